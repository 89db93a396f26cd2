struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_23 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_24 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_26 {
    member: array<type_24>,
}

struct type_29 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_35 {
    member: array<array<u32, 7>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_9;
@group(0) @binding(1) 
var<storage> global_2: type_20;
@group(0) @binding(3) 
var<storage, read_write> global_3: type_26;
@group(0) @binding(2) 
var<storage, read_write> global_4: type_35;

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
    var local_16: array<u32, 7>;
    var local_17: array<u32, 7>;
    var local_18: array<u32, 7>;
    var phi_173_: type_18;
    var phi_191_: type_23;
    var phi_209_: type_23;
    var phi_2445_: bool;
    var phi_386_: type_4;
    var phi_389_: u32;
    var phi_387_: type_4;
    var phi_412_: type_4;
    var phi_434_: type_18;
    var phi_442_: bool;
    var phi_460_: type_23;
    var phi_478_: type_23;
    var phi_750_: type_4;
    var phi_751_: type_4;
    var phi_774_: type_4;
    var phi_2436_: bool;
    var phi_948_: type_4;
    var phi_949_: type_4;
    var phi_972_: type_4;
    var phi_2465_: bool;
    var phi_1177_: type_29;
    var phi_2484_: bool;
    var phi_1195_: u32;
    var phi_2483_: bool;
    var phi_390_: u32;
    var phi_1197_: bool;
    var phi_2482_: bool;
    var phi_1248_: type_23;
    var phi_1270_: type_23;
    var phi_1542_: type_4;
    var phi_1543_: type_4;
    var phi_1566_: type_4;
    var phi_2487_: bool;
    var phi_1740_: type_4;
    var phi_1741_: type_4;
    var phi_1764_: type_4;
    var phi_2503_: bool;
    var phi_1975_: u32;
    var phi_1977_: u32;
    var phi_1978_: bool;
    var phi_1994_: u32;
    var phi_1996_: u32;
    var phi_1997_: bool;
    var phi_2002_: u32;
    var phi_2030_: u32;
    var phi_2045_: u32;
    var phi_2060_: u32;
    var phi_2162_: type_4;
    var phi_2163_: type_4;
    var phi_2186_: type_4;
    var phi_2513_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e71 = arrayLength((&global_3.member));
            let _e75 = (_e65.x + (_e65.y * 2097152u));
            let _e78 = global_1.member[0u];
            if (_e75 < _e78) {
                let _e80 = (_e75 < _e67);
                if _e80 {
                    let _e81 = (_e75 < arrayLength((&global_4.member)));
                    if _e81 {
                        let _e82 = (0u < _e67);
                        if _e82 {
                            if _e82 {
                            } else {
                                break;
                            }
                            let _e85 = global_2.member[0u];
                            phi_173_ = _e85;
                        } else {
                            phi_173_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e87 = phi_173_;
                        if (_e87.member_1 == 2147483648u) {
                            phi_191_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_191_ = type_23(vec3<f32>(_e87.member[0][0], _e87.member[1][0], _e87.member[2][0]), vec3<f32>(_e87.member[0][2], _e87.member[1][2], _e87.member[2][2]));
                        }
                        let _e106 = phi_191_;
                        if (_e87.member_2 == 2147483648u) {
                            phi_209_ = _e106;
                        } else {
                            phi_209_ = type_23(vec3<f32>(_e87.member[0][1], _e87.member[1][1], _e87.member[2][1]), vec3<f32>(_e87.member[0][3], _e87.member[1][3], _e87.member[2][3]));
                        }
                        let _e125 = phi_209_;
                        let _e154 = (select(_e125.member.x, _e106.member.x, (_e106.member.x < _e125.member.x)) * 16777216f);
                        let _e161 = select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < -2147483600f)), 2147483647i, (_e154 > 2147483500f)), (_e154 == _e154));
                        let _e166 = (select(_e125.member.y, _e106.member.y, (_e106.member.y < _e125.member.y)) * 16777216f);
                        let _e173 = select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < -2147483600f)), 2147483647i, (_e166 > 2147483500f)), (_e166 == _e166));
                        let _e178 = (select(_e125.member.z, _e106.member.z, (_e106.member.z < _e125.member.z)) * 16777216f);
                        let _e185 = select(0i, select(select(i32(_e178), i32(-2147483648), (_e178 < -2147483600f)), 2147483647i, (_e178 > 2147483500f)), (_e178 == _e178));
                        let _e190 = (select(_e125.member_1.x, _e106.member_1.x, (_e106.member_1.x > _e125.member_1.x)) * 16777216f);
                        let _e197 = select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < -2147483600f)), 2147483647i, (_e190 > 2147483500f)), (_e190 == _e190));
                        let _e202 = (select(_e125.member_1.y, _e106.member_1.y, (_e106.member_1.y > _e125.member_1.y)) * 16777216f);
                        let _e209 = select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < -2147483600f)), 2147483647i, (_e202 > 2147483500f)), (_e202 == _e202));
                        let _e214 = (select(_e125.member_1.z, _e106.member_1.z, (_e106.member_1.z > _e125.member_1.z)) * 16777216f);
                        let _e221 = select(0i, select(select(i32(_e214), i32(-2147483648), (_e214 < -2147483600f)), 2147483647i, (_e214 > 2147483500f)), (_e214 == _e214));
                        local_7 = array<i32, 3>((_e161 - select(0i, 1i, (f32(_e161) > _e154))), (_e173 - select(0i, 1i, (f32(_e173) > _e166))), (_e185 - select(0i, 1i, (f32(_e185) > _e178))));
                        local_6 = array<i32, 3>((_e197 + select(0i, 1i, (f32(_e197) < _e190))), (_e209 + select(0i, 1i, (f32(_e209) < _e202))), (_e221 + select(0i, 1i, (f32(_e221) < _e214))));
                        phi_2445_ = false;
                        phi_386_ = type_4(0u, 128u);
                        phi_389_ = 0u;
                        loop {
                            let _e229 = phi_2445_;
                            let _e231 = phi_386_;
                            let _e233 = phi_389_;
                            if (_e231.member < _e231.member_1) {
                                phi_387_ = type_4((_e231.member + 1u), _e231.member_1);
                                phi_412_ = type_4(1u, _e231.member);
                            } else {
                                phi_387_ = _e231;
                                phi_412_ = type_4(0u, type_4().member_1);
                            }
                            let _e246 = phi_387_;
                            let _e248 = phi_412_;
                            if (bitcast<i32>(_e248.member) != 0i) {
                                let _e252 = (_e233 == _e75);
                                if _e252 {
                                    phi_2484_ = _e229;
                                    phi_1195_ = u32();
                                } else {
                                    let _e253 = (_e233 < _e67);
                                    if _e253 {
                                        if _e253 {
                                        } else {
                                            phi_2482_ = true;
                                            break;
                                        }
                                        let _e256 = global_2.member[_e233];
                                        phi_434_ = _e256;
                                    } else {
                                        phi_434_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e258 = phi_434_;
                                    if ((_e258.member_1 & 2147483648u) != 0u) {
                                        phi_442_ = false;
                                    } else {
                                        phi_442_ = (_e75 <= _e258.member_1);
                                    }
                                    let _e264 = phi_442_;
                                    if (_e258.member_1 == 2147483648u) {
                                        phi_460_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_460_ = type_23(vec3<f32>(_e258.member[0][0], _e258.member[1][0], _e258.member[2][0]), vec3<f32>(_e258.member[0][2], _e258.member[1][2], _e258.member[2][2]));
                                    }
                                    let _e282 = phi_460_;
                                    if (_e258.member_2 == 2147483648u) {
                                        phi_478_ = _e282;
                                    } else {
                                        phi_478_ = type_23(vec3<f32>(_e258.member[0][1], _e258.member[1][1], _e258.member[2][1]), vec3<f32>(_e258.member[0][3], _e258.member[1][3], _e258.member[2][3]));
                                    }
                                    let _e301 = phi_478_;
                                    let _e314 = (_e282.member.x * 16777216f);
                                    let _e321 = select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < -2147483600f)), 2147483647i, (_e314 > 2147483500f)), (_e314 == _e314));
                                    let _e326 = (_e282.member.y * 16777216f);
                                    let _e333 = select(0i, select(select(i32(_e326), i32(-2147483648), (_e326 < -2147483600f)), 2147483647i, (_e326 > 2147483500f)), (_e326 == _e326));
                                    let _e338 = (_e282.member.z * 16777216f);
                                    let _e345 = select(0i, select(select(i32(_e338), i32(-2147483648), (_e338 < -2147483600f)), 2147483647i, (_e338 > 2147483500f)), (_e338 == _e338));
                                    let _e350 = (_e282.member_1.x * 16777216f);
                                    let _e357 = select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < -2147483600f)), 2147483647i, (_e350 > 2147483500f)), (_e350 == _e350));
                                    let _e362 = (_e282.member_1.y * 16777216f);
                                    let _e369 = select(0i, select(select(i32(_e362), i32(-2147483648), (_e362 < -2147483600f)), 2147483647i, (_e362 > 2147483500f)), (_e362 == _e362));
                                    let _e374 = (_e282.member_1.z * 16777216f);
                                    let _e381 = select(0i, select(select(i32(_e374), i32(-2147483648), (_e374 < -2147483600f)), 2147483647i, (_e374 > 2147483500f)), (_e374 == _e374));
                                    local_11 = array<i32, 3>((_e321 - select(0i, 1i, (f32(_e321) > _e314))), (_e333 - select(0i, 1i, (f32(_e333) > _e326))), (_e345 - select(0i, 1i, (f32(_e345) > _e338))));
                                    local_10 = array<i32, 3>((_e357 + select(0i, 1i, (f32(_e357) < _e350))), (_e369 + select(0i, 1i, (f32(_e369) < _e362))), (_e381 + select(0i, 1i, (f32(_e381) < _e374))));
                                    let _e400 = (_e301.member.x * 16777216f);
                                    let _e407 = select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < -2147483600f)), 2147483647i, (_e400 > 2147483500f)), (_e400 == _e400));
                                    let _e412 = (_e301.member.y * 16777216f);
                                    let _e419 = select(0i, select(select(i32(_e412), i32(-2147483648), (_e412 < -2147483600f)), 2147483647i, (_e412 > 2147483500f)), (_e412 == _e412));
                                    let _e424 = (_e301.member.z * 16777216f);
                                    let _e431 = select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < -2147483600f)), 2147483647i, (_e424 > 2147483500f)), (_e424 == _e424));
                                    let _e436 = (_e301.member_1.x * 16777216f);
                                    let _e443 = select(0i, select(select(i32(_e436), i32(-2147483648), (_e436 < -2147483600f)), 2147483647i, (_e436 > 2147483500f)), (_e436 == _e436));
                                    let _e448 = (_e301.member_1.y * 16777216f);
                                    let _e455 = select(0i, select(select(i32(_e448), i32(-2147483648), (_e448 < -2147483600f)), 2147483647i, (_e448 > 2147483500f)), (_e448 == _e448));
                                    let _e460 = (_e301.member_1.z * 16777216f);
                                    let _e467 = select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < -2147483600f)), 2147483647i, (_e460 > 2147483500f)), (_e460 == _e460));
                                    local_9 = array<i32, 3>((_e407 - select(0i, 1i, (f32(_e407) > _e400))), (_e419 - select(0i, 1i, (f32(_e419) > _e412))), (_e431 - select(0i, 1i, (f32(_e431) > _e424))));
                                    local_8 = array<i32, 3>((_e443 + select(0i, 1i, (f32(_e443) < _e436))), (_e455 + select(0i, 1i, (f32(_e455) < _e448))), (_e467 + select(0i, 1i, (f32(_e467) < _e460))));
                                    local_18 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                    phi_750_ = type_4(0u, 3u);
                                    loop {
                                        let _e475 = phi_750_;
                                        if (_e475.member < _e475.member_1) {
                                            phi_751_ = type_4((_e475.member + 1u), _e475.member_1);
                                            phi_774_ = type_4(1u, _e475.member);
                                        } else {
                                            phi_751_ = _e475;
                                            phi_774_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e488 = phi_751_;
                                        let _e490 = phi_774_;
                                        let _e494 = (bitcast<i32>(_e490.member) != 0i);
                                        if _e494 {
                                            let _e495 = (_e490.member_1 < 3u);
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e497 = local_7[_e490.member_1];
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e499 = local_6[_e490.member_1];
                                            let _e501 = bitcast<u32>((_e499 - _e497));
                                            let _e507 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, (_e501 == 0u)));
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e512 = local_11[_e490.member_1];
                                            let _e513 = (_e512 - _e497);
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e515 = local_9[_e490.member_1];
                                            let _e516 = (_e515 - _e497);
                                            let _e517 = (_e513 > _e516);
                                            let _e520 = ((select(21u, _e507, (_e507 > 21u)) - 21u) & 31u);
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e529 = local_10[_e490.member_1];
                                            let _e530 = (_e499 - _e529);
                                            if _e495 {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            let _e532 = local_8[_e490.member_1];
                                            let _e533 = (_e499 - _e532);
                                            let _e534 = (_e530 > _e533);
                                            let _e544 = (_e490.member_1 * 2u);
                                            let _e546 = ((1u + _e544) % 7u);
                                            if (_e546 < 7u) {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            local_18[_e546] = (((bitcast<u32>(select(_e516, _e513, _e517)) >> bitcast<u32>(_e520)) & 2097151u) | (select(0u, 1u, _e517) << bitcast<u32>(21u)));
                                            let _e550 = ((_e544 + 2u) % 7u);
                                            if (_e550 < 7u) {
                                            } else {
                                                phi_2436_ = true;
                                                break;
                                            }
                                            local_18[_e550] = (((bitcast<u32>(select(_e533, _e530, _e534)) >> bitcast<u32>(_e520)) & 2097151u) | (select(0u, 1u, _e534) << bitcast<u32>(21u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_750_ = _e488;
                                            phi_2436_ = _e229;
                                            break if !(_e494);
                                        }
                                    }
                                    let _e555 = phi_2436_;
                                    phi_2482_ = _e555;
                                    if _e555 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_948_ = type_4(0u, 3u);
                                    loop {
                                        let _e557 = phi_948_;
                                        if (_e557.member < _e557.member_1) {
                                            phi_949_ = type_4((_e557.member + 1u), _e557.member_1);
                                            phi_972_ = type_4(1u, _e557.member);
                                        } else {
                                            phi_949_ = _e557;
                                            phi_972_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e570 = phi_949_;
                                        let _e572 = phi_972_;
                                        let _e576 = (bitcast<i32>(_e572.member) != 0i);
                                        if _e576 {
                                            let _e577 = (_e572.member_1 * 2u);
                                            let _e579 = ((1u + _e577) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            let _e582 = local_18[_e579];
                                            let _e584 = ((_e577 + 2u) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            let _e587 = local_18[_e584];
                                            let _e588 = (_e572.member_1 < 3u);
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            let _e590 = local_7[_e572.member_1];
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            let _e592 = local_6[_e572.member_1];
                                            let _e594 = bitcast<u32>((_e592 - _e590));
                                            let _e600 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e594)), 32u, (_e594 == 0u)));
                                            let _e605 = ((select(21u, _e600, (_e600 > 21u)) - 21u) & 31u);
                                            let _e609 = (_e590 + bitcast<i32>(((_e582 & 2097151u) << bitcast<u32>(_e605))));
                                            let _e614 = (_e592 - bitcast<i32>(((_e587 & 2097151u) << bitcast<u32>(_e605))));
                                            let _e618 = (((_e582 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            let _e622 = (((_e587 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            local_3[_e572.member_1] = select(_e590, _e609, _e618);
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            local_1[_e572.member_1] = select(_e609, _e590, _e618);
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            local_2[_e572.member_1] = select(_e592, _e614, _e622);
                                            if _e588 {
                                            } else {
                                                phi_2465_ = true;
                                                break;
                                            }
                                            local[_e572.member_1] = select(_e614, _e592, _e622);
                                        }
                                        continue;
                                        continuing {
                                            phi_948_ = _e570;
                                            phi_2465_ = _e555;
                                            break if !(_e576);
                                        }
                                    }
                                    let _e633 = phi_2465_;
                                    phi_2482_ = _e633;
                                    if _e633 {
                                        break;
                                    }
                                    let _e634 = local;
                                    let _e635 = local_1;
                                    let _e636 = local_2;
                                    let _e637 = local_3;
                                    if _e264 {
                                        phi_1177_ = type_29(array<i32, 3>(_e637[0], _e637[1], _e637[2]), array<i32, 3>(_e636[0], _e636[1], _e636[2]));
                                    } else {
                                        phi_1177_ = type_29(array<i32, 3>(_e635[0], _e635[1], _e635[2]), array<i32, 3>(_e634[0], _e634[1], _e634[2]));
                                    }
                                    let _e657 = phi_1177_;
                                    local_7 = array<i32, 3>(_e657.member[0], _e657.member[1], _e657.member[2]);
                                    local_6 = array<i32, 3>(_e657.member_1[0], _e657.member_1[1], _e657.member_1[2]);
                                    phi_2484_ = _e633;
                                    phi_1195_ = select(_e258.member_2, _e258.member_1, _e264);
                                }
                                let _e670 = phi_2484_;
                                let _e672 = phi_1195_;
                                phi_2483_ = _e670;
                                phi_390_ = _e672;
                                phi_1197_ = select(true, false, _e252);
                            } else {
                                phi_2483_ = _e229;
                                phi_390_ = u32();
                                phi_1197_ = false;
                            }
                            let _e675 = phi_2483_;
                            let _e677 = phi_390_;
                            let _e679 = phi_1197_;
                            continue;
                            continuing {
                                phi_2445_ = _e675;
                                phi_386_ = _e246;
                                phi_389_ = _e677;
                                phi_2482_ = _e675;
                                break if !(_e679);
                            }
                        }
                        let _e682 = phi_2482_;
                        if _e682 {
                            break;
                        }
                        let _e683 = local_6;
                        let _e684 = local_7;
                        local_5 = _e684;
                        local_4 = _e683;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e688 = global_2.member[_e75].member_1;
                        if (_e688 == 2147483648u) {
                            phi_1248_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e694 = global_2.member[_e75].member[0u];
                            let _e699 = global_2.member[_e75].member[1u];
                            let _e704 = global_2.member[_e75].member[2u];
                            phi_1248_ = type_23(vec3<f32>(_e694[0], _e699[0], _e704[0]), vec3<f32>(_e694[2], _e699[2], _e704[2]));
                        }
                        let _e715 = phi_1248_;
                        let _e719 = global_2.member[_e75].member_2;
                        if (_e719 == 2147483648u) {
                            phi_1270_ = _e715;
                        } else {
                            let _e725 = global_2.member[_e75].member[0u];
                            let _e730 = global_2.member[_e75].member[1u];
                            let _e735 = global_2.member[_e75].member[2u];
                            phi_1270_ = type_23(vec3<f32>(_e725[1], _e730[1], _e735[1]), vec3<f32>(_e725[3], _e730[3], _e735[3]));
                        }
                        let _e746 = phi_1270_;
                        let _e759 = (_e715.member.x * 16777216f);
                        let _e766 = select(0i, select(select(i32(_e759), i32(-2147483648), (_e759 < -2147483600f)), 2147483647i, (_e759 > 2147483500f)), (_e759 == _e759));
                        let _e771 = (_e715.member.y * 16777216f);
                        let _e778 = select(0i, select(select(i32(_e771), i32(-2147483648), (_e771 < -2147483600f)), 2147483647i, (_e771 > 2147483500f)), (_e771 == _e771));
                        let _e783 = (_e715.member.z * 16777216f);
                        let _e790 = select(0i, select(select(i32(_e783), i32(-2147483648), (_e783 < -2147483600f)), 2147483647i, (_e783 > 2147483500f)), (_e783 == _e783));
                        let _e795 = (_e715.member_1.x * 16777216f);
                        let _e802 = select(0i, select(select(i32(_e795), i32(-2147483648), (_e795 < -2147483600f)), 2147483647i, (_e795 > 2147483500f)), (_e795 == _e795));
                        let _e807 = (_e715.member_1.y * 16777216f);
                        let _e814 = select(0i, select(select(i32(_e807), i32(-2147483648), (_e807 < -2147483600f)), 2147483647i, (_e807 > 2147483500f)), (_e807 == _e807));
                        let _e819 = (_e715.member_1.z * 16777216f);
                        let _e826 = select(0i, select(select(i32(_e819), i32(-2147483648), (_e819 < -2147483600f)), 2147483647i, (_e819 > 2147483500f)), (_e819 == _e819));
                        local_15 = array<i32, 3>((_e766 - select(0i, 1i, (f32(_e766) > _e759))), (_e778 - select(0i, 1i, (f32(_e778) > _e771))), (_e790 - select(0i, 1i, (f32(_e790) > _e783))));
                        local_14 = array<i32, 3>((_e802 + select(0i, 1i, (f32(_e802) < _e795))), (_e814 + select(0i, 1i, (f32(_e814) < _e807))), (_e826 + select(0i, 1i, (f32(_e826) < _e819))));
                        let _e845 = (_e746.member.x * 16777216f);
                        let _e852 = select(0i, select(select(i32(_e845), i32(-2147483648), (_e845 < -2147483600f)), 2147483647i, (_e845 > 2147483500f)), (_e845 == _e845));
                        let _e857 = (_e746.member.y * 16777216f);
                        let _e864 = select(0i, select(select(i32(_e857), i32(-2147483648), (_e857 < -2147483600f)), 2147483647i, (_e857 > 2147483500f)), (_e857 == _e857));
                        let _e869 = (_e746.member.z * 16777216f);
                        let _e876 = select(0i, select(select(i32(_e869), i32(-2147483648), (_e869 < -2147483600f)), 2147483647i, (_e869 > 2147483500f)), (_e869 == _e869));
                        let _e881 = (_e746.member_1.x * 16777216f);
                        let _e888 = select(0i, select(select(i32(_e881), i32(-2147483648), (_e881 < -2147483600f)), 2147483647i, (_e881 > 2147483500f)), (_e881 == _e881));
                        let _e893 = (_e746.member_1.y * 16777216f);
                        let _e900 = select(0i, select(select(i32(_e893), i32(-2147483648), (_e893 < -2147483600f)), 2147483647i, (_e893 > 2147483500f)), (_e893 == _e893));
                        let _e905 = (_e746.member_1.z * 16777216f);
                        let _e912 = select(0i, select(select(i32(_e905), i32(-2147483648), (_e905 < -2147483600f)), 2147483647i, (_e905 > 2147483500f)), (_e905 == _e905));
                        local_13 = array<i32, 3>((_e852 - select(0i, 1i, (f32(_e852) > _e845))), (_e864 - select(0i, 1i, (f32(_e864) > _e857))), (_e876 - select(0i, 1i, (f32(_e876) > _e869))));
                        local_12 = array<i32, 3>((_e888 + select(0i, 1i, (f32(_e888) < _e881))), (_e900 + select(0i, 1i, (f32(_e900) < _e893))), (_e912 + select(0i, 1i, (f32(_e912) < _e905))));
                        local_17 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_1542_ = type_4(0u, 3u);
                        loop {
                            let _e920 = phi_1542_;
                            if (_e920.member < _e920.member_1) {
                                phi_1543_ = type_4((_e920.member + 1u), _e920.member_1);
                                phi_1566_ = type_4(1u, _e920.member);
                            } else {
                                phi_1543_ = _e920;
                                phi_1566_ = type_4(0u, type_4().member_1);
                            }
                            let _e933 = phi_1543_;
                            let _e935 = phi_1566_;
                            let _e939 = (bitcast<i32>(_e935.member) != 0i);
                            if _e939 {
                                let _e940 = (_e935.member_1 < 3u);
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e942 = local_5[_e935.member_1];
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e944 = local_4[_e935.member_1];
                                let _e946 = bitcast<u32>((_e944 - _e942));
                                let _e952 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e946)), 32u, (_e946 == 0u)));
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e957 = local_15[_e935.member_1];
                                let _e958 = (_e957 - _e942);
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e960 = local_13[_e935.member_1];
                                let _e961 = (_e960 - _e942);
                                let _e962 = (_e958 > _e961);
                                let _e965 = ((select(21u, _e952, (_e952 > 21u)) - 21u) & 31u);
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e974 = local_14[_e935.member_1];
                                let _e975 = (_e944 - _e974);
                                if _e940 {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                let _e977 = local_12[_e935.member_1];
                                let _e978 = (_e944 - _e977);
                                let _e979 = (_e975 > _e978);
                                let _e989 = (_e935.member_1 * 2u);
                                let _e991 = ((1u + _e989) % 7u);
                                if (_e991 < 7u) {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                local_17[_e991] = (((bitcast<u32>(select(_e961, _e958, _e962)) >> bitcast<u32>(_e965)) & 2097151u) | (select(0u, 1u, _e962) << bitcast<u32>(21u)));
                                let _e995 = ((_e989 + 2u) % 7u);
                                if (_e995 < 7u) {
                                } else {
                                    phi_2487_ = true;
                                    break;
                                }
                                local_17[_e995] = (((bitcast<u32>(select(_e978, _e975, _e979)) >> bitcast<u32>(_e965)) & 2097151u) | (select(0u, 1u, _e979) << bitcast<u32>(21u)));
                            }
                            continue;
                            continuing {
                                phi_1542_ = _e933;
                                phi_2487_ = _e682;
                                break if !(_e939);
                            }
                        }
                        let _e1000 = phi_2487_;
                        if _e1000 {
                            break;
                        }
                        phi_1740_ = type_4(0u, 3u);
                        loop {
                            let _e1002 = phi_1740_;
                            if (_e1002.member < _e1002.member_1) {
                                phi_1741_ = type_4((_e1002.member + 1u), _e1002.member_1);
                                phi_1764_ = type_4(1u, _e1002.member);
                            } else {
                                phi_1741_ = _e1002;
                                phi_1764_ = type_4(0u, type_4().member_1);
                            }
                            let _e1015 = phi_1741_;
                            let _e1017 = phi_1764_;
                            let _e1021 = (bitcast<i32>(_e1017.member) != 0i);
                            if _e1021 {
                                let _e1022 = (_e1017.member_1 * 2u);
                                if (((1u + _e1022) % 7u) < 7u) {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if (((_e1022 + 2u) % 7u) < 7u) {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                let _e1029 = (_e1017.member_1 < 3u);
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                if _e1029 {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1740_ = _e1015;
                                phi_2503_ = _e1000;
                                break if !(_e1021);
                            }
                        }
                        let _e1032 = phi_2503_;
                        if _e1032 {
                            break;
                        }
                        let _e1033 = local_17;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e1035 = ((_e688 & 2147483648u) != 0u);
                        if _e1035 {
                            let _e1039 = (((_e688 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e1039 {
                                phi_1975_ = (_e688 & 268435455u);
                            } else {
                                phi_1975_ = u32();
                            }
                            let _e1042 = phi_1975_;
                            phi_1977_ = _e1042;
                            phi_1978_ = select(true, false, _e1039);
                        } else {
                            phi_1977_ = u32();
                            phi_1978_ = true;
                        }
                        let _e1045 = phi_1977_;
                        let _e1047 = phi_1978_;
                        if _e1047 {
                            if ((_e719 & 2147483648u) != 0u) {
                                let _e1053 = (((_e719 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e1053 {
                                    phi_1994_ = (_e719 & 268435455u);
                                } else {
                                    phi_1994_ = u32();
                                }
                                let _e1056 = phi_1994_;
                                phi_1996_ = _e1056;
                                phi_1997_ = select(true, false, _e1053);
                            } else {
                                phi_1996_ = u32();
                                phi_1997_ = true;
                            }
                            let _e1059 = phi_1996_;
                            let _e1061 = phi_1997_;
                            phi_2002_ = select(_e1059, 0u, _e1061);
                        } else {
                            phi_2002_ = _e1045;
                        }
                        let _e1064 = phi_2002_;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e1035 {
                            phi_2030_ = select(_e719, 0u, ((_e719 & 2147483648u) != 0u));
                        } else {
                            phi_2030_ = _e688;
                        }
                        let _e1069 = phi_2030_;
                        if _e1035 {
                            let _e1072 = ((_e688 >> bitcast<u32>(28u)) & 7u);
                            phi_2045_ = select(_e1072, 7u, (_e1072 == 0u));
                        } else {
                            phi_2045_ = 0u;
                        }
                        let _e1076 = phi_2045_;
                        if ((_e719 & 2147483648u) != 0u) {
                            let _e1081 = ((_e719 >> bitcast<u32>(28u)) & 7u);
                            phi_2060_ = select(_e1081, 7u, (_e1081 == 0u));
                        } else {
                            phi_2060_ = 0u;
                        }
                        let _e1085 = phi_2060_;
                        local_16 = _e1033;
                        local_16[0u] = (((_e1069 & 268435455u) | (_e1076 << bitcast<u32>(28u))) | (_e1085 << bitcast<u32>(31i)));
                        phi_2162_ = type_4(0u, 3u);
                        loop {
                            let _e1101 = phi_2162_;
                            if (_e1101.member < _e1101.member_1) {
                                phi_2163_ = type_4((_e1101.member + 1u), _e1101.member_1);
                                phi_2186_ = type_4(1u, _e1101.member);
                            } else {
                                phi_2163_ = _e1101;
                                phi_2186_ = type_4(0u, type_4().member_1);
                            }
                            let _e1114 = phi_2163_;
                            let _e1116 = phi_2186_;
                            let _e1120 = (bitcast<i32>(_e1116.member) != 0i);
                            if _e1120 {
                                let _e1129 = (((_e1116.member_1 + 1u) * 2u) % 7u);
                                if (_e1129 < 7u) {
                                } else {
                                    phi_2513_ = true;
                                    break;
                                }
                                let _e1132 = local_16[_e1129];
                                local_16[_e1129] = (_e1132 | ((((_e1064 & 268435455u) | ((_e1085 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e1116.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_2162_ = _e1114;
                                phi_2513_ = _e1032;
                                break if !(_e1120);
                            }
                        }
                        let _e1136 = phi_2513_;
                        if _e1136 {
                            break;
                        }
                        let _e1137 = local_16;
                        if _e81 {
                        } else {
                            break;
                        }
                        global_4.member[_e75] = array<u32, 7>(_e1137[0], _e1137[1], _e1137[2], _e1137[3], _e1137[4], _e1137[5], _e1137[6]);
                        if (_e75 == 0u) {
                            if (_e71 == 0u) {
                            } else {
                                if (0u < _e71) {
                                } else {
                                    break;
                                }
                                global_3.member[0u] = type_24(array<u32, 4>(bitcast<u32>(_e684[0]), bitcast<u32>(_e684[1]), bitcast<u32>(_e684[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e683[0]), bitcast<u32>(_e683[1]), bitcast<u32>(_e683[2]), 0u));
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
fn encode_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
