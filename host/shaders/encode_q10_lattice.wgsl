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

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_30 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_50 {
    member: array<type_44>,
}

struct type_55 {
    member: u32,
    member_1: type_44,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(2) 
var<storage> global_3: type_32;
@group(0) @binding(1) 
var<uniform> global_4: type_39;
@group(0) @binding(4) 
var<storage> global_5: type_50;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_13;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<i32, 3>;
    var local_3: array<i32, 3>;
    var local_4: array<u32, 10>;
    var local_5: array<f32, 3>;
    var local_6: array<u32, 10>;
    var local_7: array<u32, 4>;
    var local_8: array<type_55, 2>;
    var local_9: type_44;
    var phi_253_: type_8;
    var phi_254_: type_8;
    var phi_277_: type_8;
    var phi_1657_: bool;
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
    var phi_691_: type_8;
    var phi_692_: type_8;
    var phi_715_: type_8;
    var phi_1674_: bool;
    var phi_1725_: bool;
    var phi_896_: type_8;
    var phi_897_: type_8;
    var phi_922_: type_8;
    var phi_1016_: u32;
    var phi_1022_: u32;
    var phi_1720_: bool;
    var phi_1029_: type_8;
    var phi_1030_: type_8;
    var phi_1053_: type_8;
    var phi_1143_: u32;
    var phi_1149_: u32;
    var phi_1168_: type_8;
    var phi_1169_: type_8;
    var phi_1192_: type_8;
    var phi_1404_: i32;
    var phi_1450_: i32;
    var phi_1497_: i32;
    var phi_1712_: bool;
    var phi_1557_: type_8;
    var phi_1558_: type_8;
    var phi_1581_: type_8;
    var phi_1730_: bool;
    var phi_1739_: bool;
    var phi_1738_: bool;
    var phi_1737_: bool;
    var phi_1736_: bool;
    var phi_1742_: bool;
    var phi_1741_: bool;
    var phi_1740_: bool;

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
                        let _e98 = (_e91 < arrayLength((&global_7.member)));
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
                                    let _e123 = ((1u + _e117.member_1) % 4u);
                                    if (_e123 < 4u) {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    let _e128 = global_7.member[_e91][_e123];
                                    let _e130 = ((_e117.member_1 + 1u) % 4u);
                                    if (_e130 < 4u) {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    let _e135 = global_7.member[_e91][_e130];
                                    let _e136 = (_e117.member_1 < 3u);
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    let _e140 = global_5.member[_e91].member[_e117.member_1];
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    let _e144 = global_5.member[_e91].member_1[_e117.member_1];
                                    let _e146 = (_e135 >> bitcast<u32>(11u));
                                    let _e148 = bitcast<u32>((_e144 - _e140));
                                    let _e154 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e148)), 32u, (_e148 == 0u)));
                                    let _e159 = ((select(10u, _e154, (_e154 > 10u)) - 10u) & 31u);
                                    let _e163 = (_e140 + bitcast<i32>(((_e128 & 1023u) << bitcast<u32>(_e159))));
                                    let _e168 = (_e144 - bitcast<i32>(((_e146 & 1023u) << bitcast<u32>(_e159))));
                                    let _e172 = (((_e128 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e176 = (((_e146 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    local_3[_e117.member_1] = select(_e140, _e163, _e172);
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    local_1[_e117.member_1] = select(_e163, _e140, _e172);
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    local_2[_e117.member_1] = select(_e144, _e168, _e176);
                                    if _e136 {
                                    } else {
                                        phi_1657_ = true;
                                        break;
                                    }
                                    local[_e117.member_1] = select(_e168, _e144, _e176);
                                }
                                continue;
                                continuing {
                                    phi_253_ = _e115;
                                    phi_1657_ = false;
                                    break if !(_e121);
                                }
                            }
                            let _e187 = phi_1657_;
                            if _e187 {
                                break;
                            }
                            let _e188 = local;
                            let _e189 = local_1;
                            let _e190 = local_2;
                            let _e191 = local_3;
                            if _e98 {
                            } else {
                                break;
                            }
                            let _e192 = global_7.member[_e91];
                            if _e96 {
                            } else {
                                break;
                            }
                            let _e195 = global_3.member[_e91].member_1;
                            let _e198 = global_3.member[_e91].member_2;
                            let _e200 = ((_e195 & 2147483648u) != 0u);
                            if _e200 {
                                let _e204 = (((_e195 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e204 {
                                    phi_507_ = (_e195 & 268435455u);
                                } else {
                                    phi_507_ = u32();
                                }
                                let _e207 = phi_507_;
                                phi_509_ = _e207;
                                phi_510_ = select(true, false, _e204);
                            } else {
                                phi_509_ = u32();
                                phi_510_ = true;
                            }
                            let _e210 = phi_509_;
                            let _e212 = phi_510_;
                            if _e212 {
                                if ((_e198 & 2147483648u) != 0u) {
                                    let _e218 = (((_e198 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e218 {
                                        phi_526_ = (_e198 & 268435455u);
                                    } else {
                                        phi_526_ = u32();
                                    }
                                    let _e221 = phi_526_;
                                    phi_528_ = _e221;
                                    phi_529_ = select(true, false, _e218);
                                } else {
                                    phi_528_ = u32();
                                    phi_529_ = true;
                                }
                                let _e224 = phi_528_;
                                let _e226 = phi_529_;
                                phi_534_ = select(_e224, 0u, _e226);
                            } else {
                                phi_534_ = _e210;
                            }
                            let _e229 = phi_534_;
                            let _e230 = (_e229 < _e78);
                            if _e230 {
                                if _e230 {
                                } else {
                                    break;
                                }
                                let _e232 = global_6.member[_e229];
                                phi_546_ = _e232;
                            } else {
                                phi_546_ = 0u;
                            }
                            let _e234 = phi_546_;
                            if _e200 {
                                phi_562_ = select(_e198, 0u, ((_e198 & 2147483648u) != 0u));
                            } else {
                                phi_562_ = _e195;
                            }
                            let _e239 = phi_562_;
                            if _e200 {
                                let _e242 = ((_e195 >> bitcast<u32>(28u)) & 7u);
                                phi_577_ = select(_e242, 7u, (_e242 == 0u));
                            } else {
                                phi_577_ = 0u;
                            }
                            let _e246 = phi_577_;
                            if ((_e198 & 2147483648u) != 0u) {
                                let _e251 = ((_e198 >> bitcast<u32>(28u)) & 7u);
                                phi_592_ = select(_e251, 7u, (_e251 == 0u));
                            } else {
                                phi_592_ = 0u;
                            }
                            let _e255 = phi_592_;
                            local_7 = array<u32, 4>(_e192[0], _e192[1], _e192[2], _e192[3]);
                            local_7[0u] = (((_e239 & 268435455u) | (_e246 << bitcast<u32>(28u))) | (_e255 << bitcast<u32>(31i)));
                            phi_691_ = type_8(0u, 3u);
                            loop {
                                let _e276 = phi_691_;
                                if (_e276.member < _e276.member_1) {
                                    phi_692_ = type_8((_e276.member + 1u), _e276.member_1);
                                    phi_715_ = type_8(1u, _e276.member);
                                } else {
                                    phi_692_ = _e276;
                                    phi_715_ = type_8(0u, type_8().member_1);
                                }
                                let _e289 = phi_692_;
                                let _e291 = phi_715_;
                                let _e295 = (bitcast<i32>(_e291.member) != 0i);
                                if _e295 {
                                    let _e303 = ((_e291.member_1 + 1u) % 4u);
                                    if (_e303 < 4u) {
                                    } else {
                                        phi_1674_ = true;
                                        break;
                                    }
                                    let _e306 = local_7[_e303];
                                    local_7[_e303] = (_e306 | ((((_e234 & 268435455u) | ((_e255 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e291.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_691_ = _e289;
                                    phi_1674_ = _e187;
                                    break if !(_e295);
                                }
                            }
                            let _e310 = phi_1674_;
                            if _e310 {
                                break;
                            }
                            let _e311 = local_7;
                            if _e98 {
                            } else {
                                break;
                            }
                            global_7.member[_e91] = array<u32, 4>(_e311[0], _e311[1], _e311[2], _e311[3]);
                            if _e96 {
                            } else {
                                break;
                            }
                            if _e96 {
                            } else {
                                break;
                            }
                            local_8[0u] = type_55(_e195, type_44(_e191, _e190));
                            local_8[1u] = type_55(_e198, type_44(_e189, _e188));
                            phi_1725_ = _e310;
                            phi_896_ = type_8(0u, 2u);
                            loop {
                                let _e324 = phi_1725_;
                                let _e326 = phi_896_;
                                if (_e326.member < _e326.member_1) {
                                    phi_897_ = type_8((_e326.member + 1u), _e326.member_1);
                                    phi_922_ = type_8(1u, _e326.member);
                                } else {
                                    phi_897_ = _e326;
                                    phi_922_ = type_8(0u, type_8().member_1);
                                }
                                let _e339 = phi_897_;
                                let _e341 = phi_922_;
                                let _e345 = (bitcast<i32>(_e341.member) != 0i);
                                if _e345 {
                                    if (_e341.member_1 < 2u) {
                                    } else {
                                        phi_1740_ = true;
                                        break;
                                    }
                                    let _e349 = local_8[_e341.member_1].member;
                                    let _e352 = local_8[_e341.member_1].member_1;
                                    local_9 = _e352;
                                    if ((_e349 & 2147483648u) != 0u) {
                                        let _e357 = local_9.member_1[0u];
                                        let _e360 = local_9.member[0u];
                                        let _e365 = local_9.member_1[1u];
                                        let _e368 = local_9.member[1u];
                                        let _e374 = local_9.member_1[2u];
                                        let _e377 = local_9.member[2u];
                                        let _e380 = ((bitcast<u32>((_e357 - _e360)) | bitcast<u32>((_e365 - _e368))) | bitcast<u32>((_e374 - _e377)));
                                        if (_e380 < 1024u) {
                                            phi_1016_ = 0u;
                                        } else {
                                            phi_1016_ = select(2u, 1u, (_e380 < 2097152u));
                                        }
                                        let _e385 = phi_1016_;
                                        switch bitcast<i32>(_e385) {
                                            case 0: {
                                                phi_1022_ = 1u;
                                                break;
                                            }
                                            case 1: {
                                                phi_1022_ = 2u;
                                                break;
                                            }
                                            case 2: {
                                                phi_1022_ = 3u;
                                                break;
                                            }
                                            default: {
                                                phi_1022_ = u32();
                                                break;
                                            }
                                        }
                                        let _e388 = phi_1022_;
                                        phi_1720_ = _e324;
                                        phi_1029_ = type_8(0u, ((_e349 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e396 = phi_1720_;
                                            let _e398 = phi_1029_;
                                            if (_e398.member < _e398.member_1) {
                                                phi_1030_ = type_8((_e398.member + 1u), _e398.member_1);
                                                phi_1053_ = type_8(1u, _e398.member);
                                            } else {
                                                phi_1030_ = _e398;
                                                phi_1053_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e411 = phi_1030_;
                                            let _e413 = phi_1053_;
                                            let _e417 = (bitcast<i32>(_e413.member) != 0i);
                                            if _e417 {
                                                let _e419 = ((_e349 & 268435455u) + _e413.member_1);
                                                let _e420 = (_e419 < arrayLength((&global_2.member)));
                                                if _e420 {
                                                    let _e421 = (_e419 < _e78);
                                                    if _e421 {
                                                        if _e420 {
                                                        } else {
                                                            phi_1736_ = true;
                                                            break;
                                                        }
                                                        let _e426 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e86) + 127i)) << bitcast<u32>(23i)));
                                                        let _e427 = local_9.member_1[0u];
                                                        let _e428 = local_9.member[0u];
                                                        let _e431 = local_9.member_1[1u];
                                                        let _e432 = local_9.member[1u];
                                                        let _e436 = local_9.member_1[2u];
                                                        let _e437 = local_9.member[2u];
                                                        let _e440 = ((bitcast<u32>((_e427 - _e428)) | bitcast<u32>((_e431 - _e432))) | bitcast<u32>((_e436 - _e437)));
                                                        if (_e440 < 1024u) {
                                                            phi_1143_ = 0u;
                                                        } else {
                                                            phi_1143_ = select(2u, 1u, (_e440 < 2097152u));
                                                        }
                                                        let _e445 = phi_1143_;
                                                        switch bitcast<i32>(_e445) {
                                                            case 0: {
                                                                phi_1149_ = 1u;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_1149_ = 2u;
                                                                break;
                                                            }
                                                            case 2: {
                                                                phi_1149_ = 3u;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1149_ = u32();
                                                                break;
                                                            }
                                                        }
                                                        let _e448 = phi_1149_;
                                                        let _e449 = (1f / _e426);
                                                        let _e450 = local_9.member[0u];
                                                        let _e453 = local_9.member[1u];
                                                        let _e456 = local_9.member[2u];
                                                        local_5[0u] = (f32(_e450) * _e426);
                                                        local_5[1u] = (f32(_e453) * _e426);
                                                        local_5[2u] = (f32(_e456) * _e426);
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1168_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e463 = phi_1168_;
                                                            if (_e463.member < _e463.member_1) {
                                                                phi_1169_ = type_8((_e463.member + 1u), _e463.member_1);
                                                                phi_1192_ = type_8(1u, _e463.member);
                                                            } else {
                                                                phi_1169_ = _e463;
                                                                phi_1192_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e476 = phi_1169_;
                                                            let _e478 = phi_1192_;
                                                            let _e482 = (bitcast<i32>(_e478.member) != 0i);
                                                            if _e482 {
                                                                let _e483 = (3u * _e478.member_1);
                                                                let _e484 = (_e483 + 1u);
                                                                let _e485 = (_e483 + 2u);
                                                                let _e486 = (_e478.member_1 * _e448);
                                                                switch bitcast<i32>(_e445) {
                                                                    case 0: {
                                                                        if (_e483 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e665 = global_2.member[_e419].member[_e483];
                                                                        let _e666 = (_e483 % 3u);
                                                                        if (_e666 < 3u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e669 = local_5[_e666];
                                                                        if (_e484 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e679 = global_2.member[_e419].member[_e484];
                                                                        let _e680 = (_e484 % 3u);
                                                                        if (_e680 < 3u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e683 = local_5[_e680];
                                                                        if (_e485 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e696 = global_2.member[_e419].member[_e485];
                                                                        let _e697 = (_e485 % 3u);
                                                                        if (_e697 < 3u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e700 = local_5[_e697];
                                                                        let _e708 = (_e486 % 10u);
                                                                        if (_e708 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e708] = (((bitcast<u32>((((_e665 - _e669) * _e449) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e679 - _e683) * _e449) + 8388608f)) & 4194303u) << bitcast<u32>(10i))) | ((bitcast<u32>((((_e696 - _e700) * _e449) + 8388608f)) & 4194303u) << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e483 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e602 = global_2.member[_e419].member[_e483];
                                                                        let _e603 = (_e483 % 3u);
                                                                        if (_e603 < 3u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e606 = local_5[_e603];
                                                                        let _e612 = (_e484 < 9u);
                                                                        if _e612 {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e616 = global_2.member[_e419].member[_e484];
                                                                        let _e617 = (_e484 % 3u);
                                                                        let _e618 = (_e617 < 3u);
                                                                        if _e618 {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e620 = local_5[_e617];
                                                                        let _e628 = (_e486 % 10u);
                                                                        if (_e628 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e628] = ((bitcast<u32>((((_e602 - _e606) * _e449) + 8388608f)) & 4194303u) | ((bitcast<u32>((((_e616 - _e620) * _e449) + 8388608f)) & 4194303u) << bitcast<u32>(21i)));
                                                                        if _e612 {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        if _e618 {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e632 = local_5[_e617];
                                                                        if (_e485 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e644 = global_2.member[_e419].member[_e485];
                                                                        let _e645 = (_e485 % 3u);
                                                                        if (_e645 < 3u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e648 = local_5[_e645];
                                                                        let _e657 = ((_e486 + 1u) % 10u);
                                                                        if (_e657 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e657] = (((bitcast<u32>((((_e616 - _e632) * _e449) + 8388608f)) & 4194303u) >> bitcast<u32>(11i)) | ((bitcast<u32>((((_e644 - _e648) * _e449) + 8388608f)) & 4194303u) << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        if (_e483 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e492 = global_2.member[_e419].member[_e483];
                                                                        let _e494 = (bitcast<u32>(_e426) & 2147483647u);
                                                                        let _e495 = (_e494 >= 8388608u);
                                                                        if _e495 {
                                                                            phi_1404_ = (bitcast<i32>((_e494 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1404_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u))));
                                                                        }
                                                                        let _e508 = phi_1404_;
                                                                        let _e514 = (_e492 * bitcast<f32>((bitcast<u32>((127i - _e508)) << bitcast<u32>(23i))));
                                                                        let _e523 = (_e486 % 10u);
                                                                        if (_e523 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e523] = bitcast<u32>(select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514)));
                                                                        if (_e484 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e530 = global_2.member[_e419].member[_e484];
                                                                        if _e495 {
                                                                            phi_1450_ = (bitcast<i32>((_e494 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1450_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u))));
                                                                        }
                                                                        let _e543 = phi_1450_;
                                                                        let _e549 = (_e530 * bitcast<f32>((bitcast<u32>((127i - _e543)) << bitcast<u32>(23i))));
                                                                        let _e559 = ((_e486 + 1u) % 10u);
                                                                        if (_e559 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e559] = bitcast<u32>(select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < -2147483600f)), 2147483647i, (_e549 > 2147483500f)), (_e549 == _e549)));
                                                                        if (_e485 < 9u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        let _e566 = global_2.member[_e419].member[_e485];
                                                                        if _e495 {
                                                                            phi_1497_ = (bitcast<i32>((_e494 >> bitcast<u32>(23i))) - 127i);
                                                                        } else {
                                                                            phi_1497_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u))));
                                                                        }
                                                                        let _e579 = phi_1497_;
                                                                        let _e585 = (_e566 * bitcast<f32>((bitcast<u32>((127i - _e579)) << bitcast<u32>(23i))));
                                                                        let _e595 = ((_e486 + 2u) % 10u);
                                                                        if (_e595 < 10u) {
                                                                        } else {
                                                                            phi_1712_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e595] = bitcast<u32>(select(0i, select(select(i32(_e585), i32(-2147483648), (_e585 < -2147483600f)), 2147483647i, (_e585 > 2147483500f)), (_e585 == _e585)));
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1168_ = _e476;
                                                                phi_1712_ = _e396;
                                                                break if !(_e482);
                                                            }
                                                        }
                                                        let _e714 = phi_1712_;
                                                        phi_1736_ = _e714;
                                                        if _e714 {
                                                            break;
                                                        }
                                                        let _e717 = global_2.member[_e419].member_1;
                                                        let _e719 = ((3u * _e448) % 10u);
                                                        if (_e719 < 10u) {
                                                        } else {
                                                            phi_1736_ = true;
                                                            break;
                                                        }
                                                        local_4[_e719] = _e717;
                                                        let _e722 = local_4;
                                                        local_6 = _e722;
                                                        phi_1557_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e724 = phi_1557_;
                                                            if (_e724.member < _e724.member_1) {
                                                                phi_1558_ = type_8((_e724.member + 1u), _e724.member_1);
                                                                phi_1581_ = type_8(1u, _e724.member);
                                                            } else {
                                                                phi_1558_ = _e724;
                                                                phi_1581_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e737 = phi_1558_;
                                                            let _e739 = phi_1581_;
                                                            let _e743 = (bitcast<i32>(_e739.member) != 0i);
                                                            if _e743 {
                                                                if _e421 {
                                                                } else {
                                                                    phi_1730_ = true;
                                                                    break;
                                                                }
                                                                let _e745 = global_6.member[_e419];
                                                                let _e746 = (_e745 + _e739.member_1);
                                                                if (_e739.member_1 < ((3u * _e388) + 1u)) {
                                                                    let _e748 = (_e746 < arrayLength((&global_8.member)));
                                                                    if _e748 {
                                                                        if (_e739.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1730_ = true;
                                                                            break;
                                                                        }
                                                                        let _e751 = local_6[_e739.member_1];
                                                                        if _e748 {
                                                                        } else {
                                                                            phi_1730_ = true;
                                                                            break;
                                                                        }
                                                                        global_8.member[_e746] = _e751;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1557_ = _e737;
                                                                phi_1730_ = _e714;
                                                                break if !(_e743);
                                                            }
                                                        }
                                                        let _e756 = phi_1730_;
                                                        phi_1736_ = _e756;
                                                        if _e756 {
                                                            break;
                                                        }
                                                        phi_1739_ = _e756;
                                                    } else {
                                                        phi_1739_ = _e396;
                                                    }
                                                    let _e758 = phi_1739_;
                                                    phi_1738_ = _e758;
                                                } else {
                                                    phi_1738_ = _e396;
                                                }
                                                let _e760 = phi_1738_;
                                                phi_1737_ = _e760;
                                            } else {
                                                phi_1737_ = _e396;
                                            }
                                            let _e762 = phi_1737_;
                                            continue;
                                            continuing {
                                                phi_1720_ = _e762;
                                                phi_1029_ = _e411;
                                                phi_1736_ = _e762;
                                                break if !(_e417);
                                            }
                                        }
                                        let _e765 = phi_1736_;
                                        phi_1740_ = _e765;
                                        if _e765 {
                                            break;
                                        }
                                        phi_1742_ = _e765;
                                    } else {
                                        phi_1742_ = _e324;
                                    }
                                    let _e767 = phi_1742_;
                                    phi_1741_ = _e767;
                                } else {
                                    phi_1741_ = _e324;
                                }
                                let _e769 = phi_1741_;
                                continue;
                                continuing {
                                    phi_1725_ = _e769;
                                    phi_896_ = _e339;
                                    phi_1740_ = _e769;
                                    break if !(_e345);
                                }
                            }
                            let _e772 = phi_1740_;
                            if _e772 {
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
fn encode_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
