struct type_5 {
    member: array<u32>,
}

struct type_11 {
    member: u32,
    member_1: u32,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<f32, 3>>,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_35 {
    member: array<vec4<u32>, 5>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<array<f32, 4>, 4>,
}

var<private> global: u32;
var<private> global_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_2: type_16;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
var<workgroup> global_4: array<u32, 64>;
@group(0) @binding(2) 
var<uniform> global_5: type_35;
@group(0) @binding(3) 
var<uniform> global_6: type_16;
@group(0) @binding(4) 
var<storage> global_7: type_21;
@group(0) @binding(5) 
var<storage> global_8: type_25;
@group(0) @binding(6) 
var<storage> global_9: type_5;
@group(0) @binding(7) 
var<storage> global_10: type_44;
@group(0) @binding(8) 
var<storage, read_write> global_11: type_5;

fn function_() {
    var local: array<array<f32, 4>, 4>;
    var local_1: type_50;
    var local_2: type_50;
    var phi_234_: i32;
    var phi_374_: type_39;
    var phi_424_: type_11;
    var phi_425_: type_11;
    var phi_448_: type_11;
    var phi_1899_: bool;
    var phi_502_: i32;
    var phi_622_: type_11;
    var phi_623_: type_11;
    var phi_646_: type_11;
    var phi_1914_: bool;
    var phi_810_: i32;
    var phi_836_: u32;
    var phi_853_: i32;
    var phi_866_: bool;
    var phi_883_: array<u32, 3>;
    var phi_898_: array<f32, 3>;
    var phi_916_: array<f32, 3>;
    var phi_934_: array<f32, 3>;
    var phi_1326_: vec3<f32>;
    var phi_1512_: f32;
    var phi_1554_: type_11;
    var phi_1557_: bool;
    var phi_1555_: type_11;
    var phi_1580_: type_11;
    var phi_1735_: bool;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1558_: bool;
    var phi_1928_: bool;
    var local_3: bool;
    var phi_1989_: bool;
    var phi_1752_: bool;
    var phi_1988_: bool;
    var phi_1753_: bool;
    var phi_1987_: bool;
    var phi_1755_: u32;
    var phi_1986_: bool;
    var phi_1756_: u32;
    var phi_1776_: type_11;
    var phi_1779_: u32;
    var phi_1777_: type_11;
    var phi_1802_: type_11;
    var phi_1780_: u32;
    var phi_1982_: bool;
    var local_4: u32;

    switch bitcast<i32>(0u) {
        default: {
            let _e61 = global_1;
            let _e62 = global;
            let _e65 = arrayLength((&global_7.member));
            let _e80 = (_e61.x + (_e61.y * 2097152u));
            let _e83 = global_6.member[0u];
            if (_e83 > 0u) {
                let _e85 = (_e80 < arrayLength((&global_8.member)));
                if _e85 {
                    let _e88 = global_2.member[0u];
                    let _e92 = global_3.member[0u][0u];
                    let _e96 = global_3.member[0u][1u];
                    let _e100 = global_3.member[0u][2u];
                    let _e104 = global_3.member[0u][3u];
                    let _e108 = global_3.member[1u][0u];
                    let _e112 = global_3.member[1u][1u];
                    let _e116 = global_3.member[1u][2u];
                    let _e120 = global_3.member[1u][3u];
                    let _e121 = bitcast<f32>(_e92);
                    let _e122 = bitcast<f32>(_e96);
                    let _e123 = bitcast<f32>(_e100);
                    let _e125 = bitcast<f32>(_e108);
                    let _e126 = array<u32, 3>(_e112, _e116, _e120);
                    let _e128 = bitcast<i32>(_e88);
                    let _e129 = (_e128 < -126i);
                    if _e129 {
                        phi_234_ = -126i;
                    } else {
                        phi_234_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e133 = phi_234_;
                    let _e138 = bitcast<f32>((bitcast<u32>((_e133 + 127i)) << bitcast<u32>(23i)));
                    let _e144 = bitcast<f32>((bitcast<u32>(((_e128 - _e133) + 127i)) << bitcast<u32>(23i)));
                    if (_e104 == 0u) {
                        phi_374_ = type_39(array<f32, 3>(_e121, _e122, _e123), _e104, _e125, _e126);
                    } else {
                        let _e146 = bitcast<u32>(_e121);
                        let _e148 = ((_e146 & 2139095040u) != 0u);
                        let _e163 = bitcast<u32>(_e122);
                        let _e165 = ((_e163 & 2139095040u) != 0u);
                        let _e180 = bitcast<u32>(_e123);
                        let _e182 = ((_e180 & 2139095040u) != 0u);
                        let _e198 = bitcast<u32>(_e125);
                        let _e200 = ((_e198 & 2139095040u) != 0u);
                        phi_374_ = type_39(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e146 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e146 & 2147483648u))), _e121, _e148) * _e138) * select(0.00000011920929f, 1f, _e148)) * _e144), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e163 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e163 & 2147483648u))), _e122, _e165) * _e138) * select(0.00000011920929f, 1f, _e165)) * _e144), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e180 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e180 & 2147483648u))), _e123, _e182) * _e138) * select(0.00000011920929f, 1f, _e182)) * _e144)), _e104, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e198 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e198 & 2147483648u))), _e125, _e200) * _e138) * select(0.00000011920929f, 1f, _e200)) * _e144), _e126);
                    }
                    let _e217 = phi_374_;
                    let _e221 = global_5.member[0u][0u];
                    let _e225 = global_5.member[0u][1u];
                    let _e229 = global_5.member[0u][2u];
                    let _e233 = global_5.member[0u][3u];
                    local_2.member = array<f32, 3>(bitcast<f32>(_e221), bitcast<f32>(_e225), bitcast<f32>(_e229));
                    local_2.member_1 = _e233;
                    local_2.member_2 = array<array<f32, 4>, 4>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f));
                    phi_424_ = type_11(0u, 4u);
                    loop {
                        let _e242 = phi_424_;
                        if (_e242.member < _e242.member_1) {
                            phi_425_ = type_11((_e242.member + 1u), _e242.member_1);
                            phi_448_ = type_11(1u, _e242.member);
                        } else {
                            phi_425_ = _e242;
                            phi_448_ = type_11(0u, type_11().member_1);
                        }
                        let _e255 = phi_425_;
                        let _e257 = phi_448_;
                        let _e261 = (bitcast<i32>(_e257.member) != 0i);
                        if _e261 {
                            let _e262 = (_e257.member_1 + 1u);
                            if (_e262 < 5u) {
                            } else {
                                phi_1899_ = true;
                                break;
                            }
                            let _e267 = global_5.member[_e262][0u];
                            let _e271 = global_5.member[_e262][1u];
                            let _e275 = global_5.member[_e262][2u];
                            let _e279 = global_5.member[_e262][3u];
                            if (_e257.member_1 < 4u) {
                            } else {
                                phi_1899_ = true;
                                break;
                            }
                            local_2.member_2[_e257.member_1][0u] = bitcast<f32>(_e267);
                            local_2.member_2[_e257.member_1][1u] = bitcast<f32>(_e271);
                            local_2.member_2[_e257.member_1][2u] = bitcast<f32>(_e275);
                            local_2.member_2[_e257.member_1][3u] = bitcast<f32>(_e279);
                        }
                        continue;
                        continuing {
                            phi_424_ = _e255;
                            phi_1899_ = false;
                            break if !(_e261);
                        }
                    }
                    let _e299 = phi_1899_;
                    if _e299 {
                        break;
                    }
                    if _e129 {
                        phi_502_ = -126i;
                    } else {
                        phi_502_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e303 = phi_502_;
                    let _e308 = bitcast<f32>((bitcast<u32>((_e303 + 127i)) << bitcast<u32>(23i)));
                    let _e314 = bitcast<f32>((bitcast<u32>(((_e128 - _e303) + 127i)) << bitcast<u32>(23i)));
                    let _e315 = local_2;
                    local_1 = _e315;
                    let _e316 = local_2.member;
                    let _e320 = bitcast<u32>(_e316[0]);
                    let _e322 = ((_e320 & 2139095040u) != 0u);
                    let _e337 = bitcast<u32>(_e316[1]);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e354 = bitcast<u32>(_e316[2]);
                    let _e356 = ((_e354 & 2139095040u) != 0u);
                    local_1.member = array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e316[0], _e322) * _e308) * select(0.00000011920929f, 1f, _e322)) * _e314), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e316[1], _e339) * _e308) * select(0.00000011920929f, 1f, _e339)) * _e314), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e354 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e354 & 2147483648u))), _e316[2], _e356) * _e308) * select(0.00000011920929f, 1f, _e356)) * _e314));
                    phi_622_ = type_11(0u, 4u);
                    loop {
                        let _e374 = phi_622_;
                        if (_e374.member < _e374.member_1) {
                            phi_623_ = type_11((_e374.member + 1u), _e374.member_1);
                            phi_646_ = type_11(1u, _e374.member);
                        } else {
                            phi_623_ = _e374;
                            phi_646_ = type_11(0u, type_11().member_1);
                        }
                        let _e387 = phi_623_;
                        let _e389 = phi_646_;
                        let _e393 = (bitcast<i32>(_e389.member) != 0i);
                        if _e393 {
                            let _e394 = (_e389.member_1 < 4u);
                            if _e394 {
                            } else {
                                phi_1914_ = true;
                                break;
                            }
                            let _e398 = local_2.member_2[_e389.member_1][3u];
                            let _e399 = bitcast<u32>(_e398);
                            let _e401 = ((_e399 & 2139095040u) != 0u);
                            if _e394 {
                            } else {
                                phi_1914_ = true;
                                break;
                            }
                            local_1.member_2[_e389.member_1][3u] = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e399 & 2147483648u))), _e398, _e401) * _e308) * select(0.00000011920929f, 1f, _e401)) * _e314);
                        }
                        continue;
                        continuing {
                            phi_622_ = _e387;
                            phi_1914_ = _e299;
                            break if !(_e393);
                        }
                    }
                    let _e421 = phi_1914_;
                    if _e421 {
                        break;
                    }
                    let _e422 = local_1;
                    local = _e422.member_2;
                    if _e129 {
                        phi_810_ = -126i;
                    } else {
                        phi_810_ = select(_e128, 127i, (_e128 > 127i));
                    }
                    let _e434 = phi_810_;
                    let _e439 = bitcast<f32>((bitcast<u32>((_e434 + 127i)) << bitcast<u32>(23i)));
                    let _e445 = bitcast<f32>((bitcast<u32>(((_e128 - _e434) + 127i)) << bitcast<u32>(23i)));
                    let _e446 = (_e80 < arrayLength((&global_9.member)));
                    if _e446 {
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e448 = global_9.member[_e80];
                        phi_836_ = _e448;
                    } else {
                        phi_836_ = 4294967295u;
                    }
                    let _e450 = phi_836_;
                    let _e451 = (_e450 < arrayLength((&global_10.member)));
                    if _e451 {
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = global_10.member[_e450];
                        phi_853_ = _e453;
                    } else {
                        phi_853_ = 0i;
                    }
                    let _e455 = phi_853_;
                    let _e456 = (_e455 == 0i);
                    if _e456 {
                        phi_866_ = select(true, false, (_e422.member_1 == 0u));
                    } else {
                        phi_866_ = true;
                    }
                    let _e460 = phi_866_;
                    if _e460 {
                        if _e85 {
                            if _e85 {
                            } else {
                                break;
                            }
                            let _e462 = global_8.member[_e80];
                            phi_883_ = _e462;
                        } else {
                            phi_883_ = array<u32, 3>(0u, 0u, 0u);
                        }
                        let _e464 = phi_883_;
                        let _e466 = (_e464[0] < _e65);
                        if _e466 {
                            if _e466 {
                            } else {
                                break;
                            }
                            let _e468 = global_7.member[_e464[0]];
                            phi_898_ = _e468;
                        } else {
                            phi_898_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e470 = phi_898_;
                        let _e475 = (_e464[1] < _e65);
                        if _e475 {
                            if _e475 {
                            } else {
                                break;
                            }
                            let _e477 = global_7.member[_e464[1]];
                            phi_916_ = _e477;
                        } else {
                            phi_916_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e479 = phi_916_;
                        let _e484 = (_e464[2] < _e65);
                        if _e484 {
                            if _e484 {
                            } else {
                                break;
                            }
                            let _e486 = global_7.member[_e464[2]];
                            phi_934_ = _e486;
                        } else {
                            phi_934_ = array<f32, 3>(0f, 0f, 0f);
                        }
                        let _e488 = phi_934_;
                        let _e492 = bitcast<u32>(_e470[0]);
                        let _e494 = ((_e492 & 2139095040u) != 0u);
                        let _e508 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e492 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e492 & 2147483648u))), _e470[0], _e494) * _e439) * select(0.00000011920929f, 1f, _e494)) * _e445);
                        let _e513 = select(_e508, 0f, (bitcast<f32>((bitcast<u32>(_e508) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e514 = bitcast<u32>(_e470[1]);
                        let _e516 = ((_e514 & 2139095040u) != 0u);
                        let _e530 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e514 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e514 & 2147483648u))), _e470[1], _e516) * _e439) * select(0.00000011920929f, 1f, _e516)) * _e445);
                        let _e535 = select(_e530, 0f, (bitcast<f32>((bitcast<u32>(_e530) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e536 = bitcast<u32>(_e470[2]);
                        let _e538 = ((_e536 & 2139095040u) != 0u);
                        let _e552 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e536 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e536 & 2147483648u))), _e470[2], _e538) * _e439) * select(0.00000011920929f, 1f, _e538)) * _e445);
                        let _e557 = select(_e552, 0f, (bitcast<f32>((bitcast<u32>(_e552) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e558 = bitcast<u32>(_e479[0]);
                        let _e560 = ((_e558 & 2139095040u) != 0u);
                        let _e574 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e558 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e558 & 2147483648u))), _e479[0], _e560) * _e439) * select(0.00000011920929f, 1f, _e560)) * _e445);
                        let _e579 = select(_e574, 0f, (bitcast<f32>((bitcast<u32>(_e574) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e580 = bitcast<u32>(_e479[1]);
                        let _e582 = ((_e580 & 2139095040u) != 0u);
                        let _e596 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e580 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e580 & 2147483648u))), _e479[1], _e582) * _e439) * select(0.00000011920929f, 1f, _e582)) * _e445);
                        let _e601 = select(_e596, 0f, (bitcast<f32>((bitcast<u32>(_e596) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e602 = bitcast<u32>(_e479[2]);
                        let _e604 = ((_e602 & 2139095040u) != 0u);
                        let _e618 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e602 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e602 & 2147483648u))), _e479[2], _e604) * _e439) * select(0.00000011920929f, 1f, _e604)) * _e445);
                        let _e623 = select(_e618, 0f, (bitcast<f32>((bitcast<u32>(_e618) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e624 = bitcast<u32>(_e488[0]);
                        let _e626 = ((_e624 & 2139095040u) != 0u);
                        let _e640 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e624 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e624 & 2147483648u))), _e488[0], _e626) * _e439) * select(0.00000011920929f, 1f, _e626)) * _e445);
                        let _e645 = select(_e640, 0f, (bitcast<f32>((bitcast<u32>(_e640) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e646 = bitcast<u32>(_e488[1]);
                        let _e648 = ((_e646 & 2139095040u) != 0u);
                        let _e662 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e646 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e646 & 2147483648u))), _e488[1], _e648) * _e439) * select(0.00000011920929f, 1f, _e648)) * _e445);
                        let _e667 = select(_e662, 0f, (bitcast<f32>((bitcast<u32>(_e662) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e668 = bitcast<u32>(_e488[2]);
                        let _e670 = ((_e668 & 2139095040u) != 0u);
                        let _e684 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e668 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e668 & 2147483648u))), _e488[2], _e670) * _e439) * select(0.00000011920929f, 1f, _e670)) * _e445);
                        let _e689 = select(_e684, 0f, (bitcast<f32>((bitcast<u32>(_e684) & 2147483647u)) < 0.000000000000000000000000000000000000011754944f));
                        let _e690 = (_e579 - _e513);
                        let _e691 = (_e601 - _e535);
                        let _e692 = (_e623 - _e557);
                        let _e693 = (_e645 - _e513);
                        let _e694 = (_e667 - _e535);
                        let _e695 = (_e689 - _e557);
                        if (_e217.member_1 == 1u) {
                            phi_1326_ = vec3<f32>((_e217.member[0] - _e513), (_e217.member[1] - _e535), (_e217.member[2] - _e557));
                        } else {
                            phi_1326_ = vec3<f32>(_e217.member[0], _e217.member[1], _e217.member[2]);
                        }
                        let _e709 = phi_1326_;
                        let _e713 = bitcast<f32>((bitcast<u32>((_e690 * _e694)) ^ _e217.member_3[0]));
                        let _e717 = bitcast<f32>((bitcast<u32>((_e691 * _e693)) ^ _e217.member_3[0]));
                        let _e721 = bitcast<f32>((bitcast<u32>((_e691 * _e695)) ^ _e217.member_3[0]));
                        let _e725 = bitcast<f32>((bitcast<u32>((_e692 * _e694)) ^ _e217.member_3[0]));
                        let _e729 = bitcast<f32>((bitcast<u32>((_e692 * _e693)) ^ _e217.member_3[0]));
                        let _e733 = bitcast<f32>((bitcast<u32>((_e690 * _e695)) ^ _e217.member_3[0]));
                        let _e734 = (_e721 - _e725);
                        let _e735 = (_e729 - _e733);
                        let _e736 = (_e713 - _e717);
                        let _e760 = (bitcast<f32>((bitcast<u32>(_e721) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e725) & 2147483647u)));
                        let _e767 = (bitcast<f32>((bitcast<u32>(_e729) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e733) & 2147483647u)));
                        let _e774 = (bitcast<f32>((bitcast<u32>(_e713) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e717) & 2147483647u)));
                        if (_e217.member_2 == 0f) {
                            phi_1512_ = 0f;
                        } else {
                            let _e803 = bitcast<f32>((bitcast<u32>(_e734) & 2147483647u));
                            let _e806 = bitcast<f32>((bitcast<u32>(_e735) & 2147483647u));
                            let _e809 = bitcast<f32>((bitcast<u32>(_e736) & 2147483647u));
                            let _e811 = select(_e809, _e806, (_e806 > _e809));
                            let _e815 = select(_e809, _e806, (_e806 < _e809));
                            let _e819 = select(_e806, _e803, (_e803 < _e806));
                            let _e821 = select(_e806, _e803, (_e803 > _e806));
                            let _e823 = select(_e809, _e821, (_e821 < _e809));
                            phi_1512_ = bitcast<f32>((bitcast<u32>((_e217.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e811, _e803, (_e803 > _e811)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e823, _e819, (_e819 > _e823)))) ^ _e217.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e815, _e803, (_e803 < _e815)))) ^ _e217.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e760 + _e767) + _e774))) ^ _e217.member_3[0]))) * 1.0000005f)) ^ _e217.member_3[0])))) ^ _e217.member_3[0]));
                        }
                        let _e850 = phi_1512_;
                        if (_e456 || !(((((bitcast<f32>((bitcast<u32>((_e709.x * _e734)) ^ _e217.member_3[0])) + bitcast<f32>((bitcast<u32>((_e709.y * _e735)) ^ _e217.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e709.z * _e736)) ^ _e217.member_3[0]))) * f32(-(_e455))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e709.x) & 2147483647u)) * _e760)) ^ _e217.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e709.y) & 2147483647u)) * _e767)) ^ _e217.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e709.z) & 2147483647u)) * _e774)) ^ _e217.member_3[0]))))) ^ _e217.member_3[0])) + _e850) + 0.0000000000000000000000000000000000001880791f)))) {
                            let _e866 = (_e513 - _e422.member[0]);
                            let _e867 = (_e535 - _e422.member[1]);
                            let _e868 = (_e557 - _e422.member[2]);
                            let _e869 = (_e579 - _e422.member[0]);
                            let _e870 = (_e601 - _e422.member[1]);
                            let _e871 = (_e623 - _e422.member[2]);
                            let _e872 = (_e645 - _e422.member[0]);
                            let _e873 = (_e667 - _e422.member[1]);
                            let _e874 = (_e689 - _e422.member[2]);
                            phi_1554_ = type_11(0u, 4u);
                            phi_1557_ = false;
                            loop {
                                let _e876 = phi_1554_;
                                let _e878 = phi_1557_;
                                local_3 = _e878;
                                if (_e876.member < _e876.member_1) {
                                    phi_1555_ = type_11((_e876.member + 1u), _e876.member_1);
                                    phi_1580_ = type_11(1u, _e876.member);
                                } else {
                                    phi_1555_ = _e876;
                                    phi_1580_ = type_11(0u, type_11().member_1);
                                }
                                let _e891 = phi_1555_;
                                let _e893 = phi_1580_;
                                let _e897 = (bitcast<i32>(_e893.member) != 0i);
                                if _e897 {
                                    let _e898 = (_e893.member_1 < 4u);
                                    if _e898 {
                                    } else {
                                        phi_1928_ = true;
                                        break;
                                    }
                                    let _e900 = local[_e893.member_1];
                                    if (((((_e900[0] * _e866) + (_e900[1] * _e867)) + (_e900[2] * _e868)) + _e900[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e866) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e867) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e868) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e900[3]) & 2147483647u)))))) {
                                        if _e898 {
                                        } else {
                                            phi_1928_ = true;
                                            break;
                                        }
                                        let _e929 = local[_e893.member_1];
                                        let _e957 = (((((_e929[0] * _e869) + (_e929[1] * _e870)) + (_e929[2] * _e871)) + _e929[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e869) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e870) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e871) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e929[3]) & 2147483647u))))));
                                        if _e957 {
                                            if _e898 {
                                            } else {
                                                phi_1928_ = true;
                                                break;
                                            }
                                            let _e958 = local[_e893.member_1];
                                            phi_1735_ = (((((_e958[0] * _e872) + (_e958[1] * _e873)) + (_e958[2] * _e874)) + _e958[3]) < (-0.0000000000000000000000000000000000001880791f - (0.000003814712f * (((bitcast<f32>((bitcast<u32>(_e872) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e873) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e874) & 2147483647u))) + bitcast<f32>((bitcast<u32>(_e958[3]) & 2147483647u))))));
                                        } else {
                                            phi_1735_ = bool();
                                        }
                                        let _e988 = phi_1735_;
                                        phi_1737_ = _e988;
                                        phi_1738_ = select(true, false, _e957);
                                    } else {
                                        phi_1737_ = bool();
                                        phi_1738_ = true;
                                    }
                                    let _e991 = phi_1737_;
                                    let _e993 = phi_1738_;
                                    phi_1558_ = (_e878 || select(_e991, false, _e993));
                                } else {
                                    phi_1558_ = bool();
                                }
                                let _e997 = phi_1558_;
                                continue;
                                continuing {
                                    phi_1554_ = _e891;
                                    phi_1557_ = _e997;
                                    phi_1928_ = _e421;
                                    break if !(_e897);
                                }
                            }
                            let _e1000 = phi_1928_;
                            if _e1000 {
                                break;
                            }
                            let _e1003 = local_3;
                            phi_1989_ = _e1000;
                            phi_1752_ = !(select(false, _e1003, (_e422.member_1 == 1u)));
                        } else {
                            phi_1989_ = _e421;
                            phi_1752_ = false;
                        }
                        let _e1007 = phi_1989_;
                        let _e1009 = phi_1752_;
                        phi_1988_ = _e1007;
                        phi_1753_ = _e1009;
                    } else {
                        phi_1988_ = _e421;
                        phi_1753_ = true;
                    }
                    let _e1011 = phi_1988_;
                    let _e1013 = phi_1753_;
                    phi_1987_ = _e1011;
                    phi_1755_ = select(0u, 1u, _e1013);
                } else {
                    phi_1987_ = false;
                    phi_1755_ = 0u;
                }
                let _e1016 = phi_1987_;
                let _e1018 = phi_1755_;
                phi_1986_ = _e1016;
                phi_1756_ = _e1018;
            } else {
                phi_1986_ = false;
                phi_1756_ = 0u;
            }
            let _e1020 = phi_1986_;
            let _e1022 = phi_1756_;
            let _e1023 = (_e62 % 64u);
            if (_e1023 < 64u) {
            } else {
                break;
            }
            global_4[_e1023] = _e1022;
            workgroupBarrier();
            let _e1026 = (_e80 / 32u);
            if ((_e62 & 31u) == 0u) {
                let _e1029 = (_e1026 < arrayLength((&global_11.member)));
                if _e1029 {
                    phi_1776_ = type_11(0u, 32u);
                    phi_1779_ = 0u;
                    loop {
                        let _e1031 = phi_1776_;
                        let _e1033 = phi_1779_;
                        local_4 = _e1033;
                        if (_e1031.member < _e1031.member_1) {
                            phi_1777_ = type_11((_e1031.member + 1u), _e1031.member_1);
                            phi_1802_ = type_11(1u, _e1031.member);
                        } else {
                            phi_1777_ = _e1031;
                            phi_1802_ = type_11(0u, type_11().member_1);
                        }
                        let _e1046 = phi_1777_;
                        let _e1048 = phi_1802_;
                        let _e1052 = (bitcast<i32>(_e1048.member) != 0i);
                        if _e1052 {
                            let _e1054 = ((_e62 + _e1048.member_1) % 64u);
                            if (_e1054 < 64u) {
                            } else {
                                phi_1982_ = true;
                                break;
                            }
                            let _e1057 = global_4[_e1054];
                            phi_1780_ = (_e1033 | (_e1057 << bitcast<u32>((_e1048.member_1 & 31u))));
                        } else {
                            phi_1780_ = u32();
                        }
                        let _e1063 = phi_1780_;
                        continue;
                        continuing {
                            phi_1776_ = _e1046;
                            phi_1779_ = _e1063;
                            phi_1982_ = _e1020;
                            break if !(_e1052);
                        }
                    }
                    let _e1066 = phi_1982_;
                    if _e1066 {
                        break;
                    }
                    if _e1029 {
                    } else {
                        break;
                    }
                    let _e1070 = local_4;
                    global_11.member[_e1026] = _e1070;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn classify(@builtin(global_invocation_id) param: vec3<u32>, @builtin(local_invocation_index) param_1: u32) {
    global_1 = param;
    global = param_1;
    function_();
}
