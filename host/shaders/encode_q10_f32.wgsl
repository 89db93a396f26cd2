struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_27 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_33 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<storage> global_2: type_23;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_29;

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
    var local_16: array<u32, 4>;
    var local_17: array<u32, 4>;
    var local_18: array<u32, 4>;
    var phi_172_: type_21;
    var phi_190_: type_26;
    var phi_208_: type_26;
    var phi_2435_: bool;
    var phi_385_: type_4;
    var phi_388_: u32;
    var phi_386_: type_4;
    var phi_411_: type_4;
    var phi_433_: type_21;
    var phi_441_: bool;
    var phi_459_: type_26;
    var phi_477_: type_26;
    var phi_749_: type_4;
    var phi_750_: type_4;
    var phi_773_: type_4;
    var phi_2426_: bool;
    var phi_947_: type_4;
    var phi_948_: type_4;
    var phi_971_: type_4;
    var phi_2455_: bool;
    var phi_1176_: type_33;
    var phi_2474_: bool;
    var phi_1194_: u32;
    var phi_2473_: bool;
    var phi_389_: u32;
    var phi_1196_: bool;
    var phi_2472_: bool;
    var phi_1247_: type_26;
    var phi_1269_: type_26;
    var phi_1541_: type_4;
    var phi_1542_: type_4;
    var phi_1565_: type_4;
    var phi_2477_: bool;
    var phi_1739_: type_4;
    var phi_1740_: type_4;
    var phi_1763_: type_4;
    var phi_2493_: bool;
    var phi_1971_: u32;
    var phi_1973_: u32;
    var phi_1974_: bool;
    var phi_1990_: u32;
    var phi_1992_: u32;
    var phi_1993_: bool;
    var phi_1998_: u32;
    var phi_2026_: u32;
    var phi_2041_: u32;
    var phi_2056_: u32;
    var phi_2155_: type_4;
    var phi_2156_: type_4;
    var phi_2179_: type_4;
    var phi_2503_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e71 = arrayLength((&global_4.member));
            let _e75 = (_e65.x + (_e65.y * 2097152u));
            let _e78 = global_1.member[0u];
            if (_e75 < _e78) {
                let _e80 = (_e75 < _e67);
                if _e80 {
                    let _e81 = (_e75 < arrayLength((&global_3.member)));
                    if _e81 {
                        let _e82 = (0u < _e67);
                        if _e82 {
                            if _e82 {
                            } else {
                                break;
                            }
                            let _e85 = global_2.member[0u];
                            phi_172_ = _e85;
                        } else {
                            phi_172_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e87 = phi_172_;
                        if (_e87.member_1 == 2147483648u) {
                            phi_190_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_190_ = type_26(vec3<f32>(_e87.member[0][0], _e87.member[1][0], _e87.member[2][0]), vec3<f32>(_e87.member[0][2], _e87.member[1][2], _e87.member[2][2]));
                        }
                        let _e106 = phi_190_;
                        if (_e87.member_2 == 2147483648u) {
                            phi_208_ = _e106;
                        } else {
                            phi_208_ = type_26(vec3<f32>(_e87.member[0][1], _e87.member[1][1], _e87.member[2][1]), vec3<f32>(_e87.member[0][3], _e87.member[1][3], _e87.member[2][3]));
                        }
                        let _e125 = phi_208_;
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
                        phi_2435_ = false;
                        phi_385_ = type_4(0u, 128u);
                        phi_388_ = 0u;
                        loop {
                            let _e229 = phi_2435_;
                            let _e231 = phi_385_;
                            let _e233 = phi_388_;
                            if (_e231.member < _e231.member_1) {
                                phi_386_ = type_4((_e231.member + 1u), _e231.member_1);
                                phi_411_ = type_4(1u, _e231.member);
                            } else {
                                phi_386_ = _e231;
                                phi_411_ = type_4(0u, type_4().member_1);
                            }
                            let _e246 = phi_386_;
                            let _e248 = phi_411_;
                            if (bitcast<i32>(_e248.member) != 0i) {
                                let _e252 = (_e233 == _e75);
                                if _e252 {
                                    phi_2474_ = _e229;
                                    phi_1194_ = u32();
                                } else {
                                    let _e253 = (_e233 < _e67);
                                    if _e253 {
                                        if _e253 {
                                        } else {
                                            phi_2472_ = true;
                                            break;
                                        }
                                        let _e256 = global_2.member[_e233];
                                        phi_433_ = _e256;
                                    } else {
                                        phi_433_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e258 = phi_433_;
                                    if ((_e258.member_1 & 2147483648u) != 0u) {
                                        phi_441_ = false;
                                    } else {
                                        phi_441_ = (_e75 <= _e258.member_1);
                                    }
                                    let _e264 = phi_441_;
                                    if (_e258.member_1 == 2147483648u) {
                                        phi_459_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_459_ = type_26(vec3<f32>(_e258.member[0][0], _e258.member[1][0], _e258.member[2][0]), vec3<f32>(_e258.member[0][2], _e258.member[1][2], _e258.member[2][2]));
                                    }
                                    let _e282 = phi_459_;
                                    if (_e258.member_2 == 2147483648u) {
                                        phi_477_ = _e282;
                                    } else {
                                        phi_477_ = type_26(vec3<f32>(_e258.member[0][1], _e258.member[1][1], _e258.member[2][1]), vec3<f32>(_e258.member[0][3], _e258.member[1][3], _e258.member[2][3]));
                                    }
                                    let _e301 = phi_477_;
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
                                    local_18 = array<u32, 4>(0u, 0u, 0u, 0u);
                                    phi_749_ = type_4(0u, 3u);
                                    loop {
                                        let _e475 = phi_749_;
                                        if (_e475.member < _e475.member_1) {
                                            phi_750_ = type_4((_e475.member + 1u), _e475.member_1);
                                            phi_773_ = type_4(1u, _e475.member);
                                        } else {
                                            phi_750_ = _e475;
                                            phi_773_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e488 = phi_750_;
                                        let _e490 = phi_773_;
                                        let _e494 = (bitcast<i32>(_e490.member) != 0i);
                                        if _e494 {
                                            let _e495 = (_e490.member_1 < 3u);
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e497 = local_7[_e490.member_1];
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e499 = local_6[_e490.member_1];
                                            let _e501 = bitcast<u32>((_e499 - _e497));
                                            let _e507 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e501)), 32u, (_e501 == 0u)));
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e512 = local_11[_e490.member_1];
                                            let _e513 = (_e512 - _e497);
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e515 = local_9[_e490.member_1];
                                            let _e516 = (_e515 - _e497);
                                            let _e517 = (_e513 > _e516);
                                            let _e520 = ((select(10u, _e507, (_e507 > 10u)) - 10u) & 31u);
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e529 = local_10[_e490.member_1];
                                            let _e530 = (_e499 - _e529);
                                            if _e495 {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            let _e532 = local_8[_e490.member_1];
                                            let _e533 = (_e499 - _e532);
                                            let _e534 = (_e530 > _e533);
                                            let _e547 = ((1u + _e490.member_1) % 4u);
                                            if (_e547 < 4u) {
                                            } else {
                                                phi_2426_ = true;
                                                break;
                                            }
                                            local_18[_e547] = ((((bitcast<u32>(select(_e516, _e513, _e517)) >> bitcast<u32>(_e520)) & 1023u) | (select(0u, 1u, _e517) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e533, _e530, _e534)) >> bitcast<u32>(_e520)) & 1023u) | (select(0u, 1u, _e534) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_749_ = _e488;
                                            phi_2426_ = _e229;
                                            break if !(_e494);
                                        }
                                    }
                                    let _e553 = phi_2426_;
                                    phi_2472_ = _e553;
                                    if _e553 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_947_ = type_4(0u, 3u);
                                    loop {
                                        let _e555 = phi_947_;
                                        if (_e555.member < _e555.member_1) {
                                            phi_948_ = type_4((_e555.member + 1u), _e555.member_1);
                                            phi_971_ = type_4(1u, _e555.member);
                                        } else {
                                            phi_948_ = _e555;
                                            phi_971_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e568 = phi_948_;
                                        let _e570 = phi_971_;
                                        let _e574 = (bitcast<i32>(_e570.member) != 0i);
                                        if _e574 {
                                            let _e576 = ((1u + _e570.member_1) % 4u);
                                            if (_e576 < 4u) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e579 = local_18[_e576];
                                            let _e581 = ((_e570.member_1 + 1u) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e584 = local_18[_e581];
                                            let _e585 = (_e570.member_1 < 3u);
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e587 = local_7[_e570.member_1];
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            let _e589 = local_6[_e570.member_1];
                                            let _e591 = (_e584 >> bitcast<u32>(11u));
                                            let _e593 = bitcast<u32>((_e589 - _e587));
                                            let _e599 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e593)), 32u, (_e593 == 0u)));
                                            let _e604 = ((select(10u, _e599, (_e599 > 10u)) - 10u) & 31u);
                                            let _e608 = (_e587 + bitcast<i32>(((_e579 & 1023u) << bitcast<u32>(_e604))));
                                            let _e613 = (_e589 - bitcast<i32>(((_e591 & 1023u) << bitcast<u32>(_e604))));
                                            let _e617 = (((_e579 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            let _e621 = (((_e591 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            local_3[_e570.member_1] = select(_e587, _e608, _e617);
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            local_1[_e570.member_1] = select(_e608, _e587, _e617);
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            local_2[_e570.member_1] = select(_e589, _e613, _e621);
                                            if _e585 {
                                            } else {
                                                phi_2455_ = true;
                                                break;
                                            }
                                            local[_e570.member_1] = select(_e613, _e589, _e621);
                                        }
                                        continue;
                                        continuing {
                                            phi_947_ = _e568;
                                            phi_2455_ = _e553;
                                            break if !(_e574);
                                        }
                                    }
                                    let _e632 = phi_2455_;
                                    phi_2472_ = _e632;
                                    if _e632 {
                                        break;
                                    }
                                    let _e633 = local;
                                    let _e634 = local_1;
                                    let _e635 = local_2;
                                    let _e636 = local_3;
                                    if _e264 {
                                        phi_1176_ = type_33(array<i32, 3>(_e636[0], _e636[1], _e636[2]), array<i32, 3>(_e635[0], _e635[1], _e635[2]));
                                    } else {
                                        phi_1176_ = type_33(array<i32, 3>(_e634[0], _e634[1], _e634[2]), array<i32, 3>(_e633[0], _e633[1], _e633[2]));
                                    }
                                    let _e656 = phi_1176_;
                                    local_7 = array<i32, 3>(_e656.member[0], _e656.member[1], _e656.member[2]);
                                    local_6 = array<i32, 3>(_e656.member_1[0], _e656.member_1[1], _e656.member_1[2]);
                                    phi_2474_ = _e632;
                                    phi_1194_ = select(_e258.member_2, _e258.member_1, _e264);
                                }
                                let _e669 = phi_2474_;
                                let _e671 = phi_1194_;
                                phi_2473_ = _e669;
                                phi_389_ = _e671;
                                phi_1196_ = select(true, false, _e252);
                            } else {
                                phi_2473_ = _e229;
                                phi_389_ = u32();
                                phi_1196_ = false;
                            }
                            let _e674 = phi_2473_;
                            let _e676 = phi_389_;
                            let _e678 = phi_1196_;
                            continue;
                            continuing {
                                phi_2435_ = _e674;
                                phi_385_ = _e246;
                                phi_388_ = _e676;
                                phi_2472_ = _e674;
                                break if !(_e678);
                            }
                        }
                        let _e681 = phi_2472_;
                        if _e681 {
                            break;
                        }
                        let _e682 = local_6;
                        let _e683 = local_7;
                        local_5 = _e683;
                        local_4 = _e682;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e687 = global_2.member[_e75].member_1;
                        if (_e687 == 2147483648u) {
                            phi_1247_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e693 = global_2.member[_e75].member[0u];
                            let _e698 = global_2.member[_e75].member[1u];
                            let _e703 = global_2.member[_e75].member[2u];
                            phi_1247_ = type_26(vec3<f32>(_e693[0], _e698[0], _e703[0]), vec3<f32>(_e693[2], _e698[2], _e703[2]));
                        }
                        let _e714 = phi_1247_;
                        let _e718 = global_2.member[_e75].member_2;
                        if (_e718 == 2147483648u) {
                            phi_1269_ = _e714;
                        } else {
                            let _e724 = global_2.member[_e75].member[0u];
                            let _e729 = global_2.member[_e75].member[1u];
                            let _e734 = global_2.member[_e75].member[2u];
                            phi_1269_ = type_26(vec3<f32>(_e724[1], _e729[1], _e734[1]), vec3<f32>(_e724[3], _e729[3], _e734[3]));
                        }
                        let _e745 = phi_1269_;
                        let _e758 = (_e714.member.x * 16777216f);
                        let _e765 = select(0i, select(select(i32(_e758), i32(-2147483648), (_e758 < -2147483600f)), 2147483647i, (_e758 > 2147483500f)), (_e758 == _e758));
                        let _e770 = (_e714.member.y * 16777216f);
                        let _e777 = select(0i, select(select(i32(_e770), i32(-2147483648), (_e770 < -2147483600f)), 2147483647i, (_e770 > 2147483500f)), (_e770 == _e770));
                        let _e782 = (_e714.member.z * 16777216f);
                        let _e789 = select(0i, select(select(i32(_e782), i32(-2147483648), (_e782 < -2147483600f)), 2147483647i, (_e782 > 2147483500f)), (_e782 == _e782));
                        let _e794 = (_e714.member_1.x * 16777216f);
                        let _e801 = select(0i, select(select(i32(_e794), i32(-2147483648), (_e794 < -2147483600f)), 2147483647i, (_e794 > 2147483500f)), (_e794 == _e794));
                        let _e806 = (_e714.member_1.y * 16777216f);
                        let _e813 = select(0i, select(select(i32(_e806), i32(-2147483648), (_e806 < -2147483600f)), 2147483647i, (_e806 > 2147483500f)), (_e806 == _e806));
                        let _e818 = (_e714.member_1.z * 16777216f);
                        let _e825 = select(0i, select(select(i32(_e818), i32(-2147483648), (_e818 < -2147483600f)), 2147483647i, (_e818 > 2147483500f)), (_e818 == _e818));
                        local_15 = array<i32, 3>((_e765 - select(0i, 1i, (f32(_e765) > _e758))), (_e777 - select(0i, 1i, (f32(_e777) > _e770))), (_e789 - select(0i, 1i, (f32(_e789) > _e782))));
                        local_14 = array<i32, 3>((_e801 + select(0i, 1i, (f32(_e801) < _e794))), (_e813 + select(0i, 1i, (f32(_e813) < _e806))), (_e825 + select(0i, 1i, (f32(_e825) < _e818))));
                        let _e844 = (_e745.member.x * 16777216f);
                        let _e851 = select(0i, select(select(i32(_e844), i32(-2147483648), (_e844 < -2147483600f)), 2147483647i, (_e844 > 2147483500f)), (_e844 == _e844));
                        let _e856 = (_e745.member.y * 16777216f);
                        let _e863 = select(0i, select(select(i32(_e856), i32(-2147483648), (_e856 < -2147483600f)), 2147483647i, (_e856 > 2147483500f)), (_e856 == _e856));
                        let _e868 = (_e745.member.z * 16777216f);
                        let _e875 = select(0i, select(select(i32(_e868), i32(-2147483648), (_e868 < -2147483600f)), 2147483647i, (_e868 > 2147483500f)), (_e868 == _e868));
                        let _e880 = (_e745.member_1.x * 16777216f);
                        let _e887 = select(0i, select(select(i32(_e880), i32(-2147483648), (_e880 < -2147483600f)), 2147483647i, (_e880 > 2147483500f)), (_e880 == _e880));
                        let _e892 = (_e745.member_1.y * 16777216f);
                        let _e899 = select(0i, select(select(i32(_e892), i32(-2147483648), (_e892 < -2147483600f)), 2147483647i, (_e892 > 2147483500f)), (_e892 == _e892));
                        let _e904 = (_e745.member_1.z * 16777216f);
                        let _e911 = select(0i, select(select(i32(_e904), i32(-2147483648), (_e904 < -2147483600f)), 2147483647i, (_e904 > 2147483500f)), (_e904 == _e904));
                        local_13 = array<i32, 3>((_e851 - select(0i, 1i, (f32(_e851) > _e844))), (_e863 - select(0i, 1i, (f32(_e863) > _e856))), (_e875 - select(0i, 1i, (f32(_e875) > _e868))));
                        local_12 = array<i32, 3>((_e887 + select(0i, 1i, (f32(_e887) < _e880))), (_e899 + select(0i, 1i, (f32(_e899) < _e892))), (_e911 + select(0i, 1i, (f32(_e911) < _e904))));
                        local_17 = array<u32, 4>(0u, 0u, 0u, 0u);
                        phi_1541_ = type_4(0u, 3u);
                        loop {
                            let _e919 = phi_1541_;
                            if (_e919.member < _e919.member_1) {
                                phi_1542_ = type_4((_e919.member + 1u), _e919.member_1);
                                phi_1565_ = type_4(1u, _e919.member);
                            } else {
                                phi_1542_ = _e919;
                                phi_1565_ = type_4(0u, type_4().member_1);
                            }
                            let _e932 = phi_1542_;
                            let _e934 = phi_1565_;
                            let _e938 = (bitcast<i32>(_e934.member) != 0i);
                            if _e938 {
                                let _e939 = (_e934.member_1 < 3u);
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e941 = local_5[_e934.member_1];
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e943 = local_4[_e934.member_1];
                                let _e945 = bitcast<u32>((_e943 - _e941));
                                let _e951 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e945)), 32u, (_e945 == 0u)));
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e956 = local_15[_e934.member_1];
                                let _e957 = (_e956 - _e941);
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e959 = local_13[_e934.member_1];
                                let _e960 = (_e959 - _e941);
                                let _e961 = (_e957 > _e960);
                                let _e964 = ((select(10u, _e951, (_e951 > 10u)) - 10u) & 31u);
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e973 = local_14[_e934.member_1];
                                let _e974 = (_e943 - _e973);
                                if _e939 {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                let _e976 = local_12[_e934.member_1];
                                let _e977 = (_e943 - _e976);
                                let _e978 = (_e974 > _e977);
                                let _e991 = ((1u + _e934.member_1) % 4u);
                                if (_e991 < 4u) {
                                } else {
                                    phi_2477_ = true;
                                    break;
                                }
                                local_17[_e991] = ((((bitcast<u32>(select(_e960, _e957, _e961)) >> bitcast<u32>(_e964)) & 1023u) | (select(0u, 1u, _e961) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e977, _e974, _e978)) >> bitcast<u32>(_e964)) & 1023u) | (select(0u, 1u, _e978) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                            }
                            continue;
                            continuing {
                                phi_1541_ = _e932;
                                phi_2477_ = _e681;
                                break if !(_e938);
                            }
                        }
                        let _e997 = phi_2477_;
                        if _e997 {
                            break;
                        }
                        phi_1739_ = type_4(0u, 3u);
                        loop {
                            let _e999 = phi_1739_;
                            if (_e999.member < _e999.member_1) {
                                phi_1740_ = type_4((_e999.member + 1u), _e999.member_1);
                                phi_1763_ = type_4(1u, _e999.member);
                            } else {
                                phi_1740_ = _e999;
                                phi_1763_ = type_4(0u, type_4().member_1);
                            }
                            let _e1012 = phi_1740_;
                            let _e1014 = phi_1763_;
                            let _e1018 = (bitcast<i32>(_e1014.member) != 0i);
                            if _e1018 {
                                if (((1u + _e1014.member_1) % 4u) < 4u) {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if (((_e1014.member_1 + 1u) % 4u) < 4u) {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                let _e1025 = (_e1014.member_1 < 3u);
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                                if _e1025 {
                                } else {
                                    phi_2493_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_1739_ = _e1012;
                                phi_2493_ = _e997;
                                break if !(_e1018);
                            }
                        }
                        let _e1028 = phi_2493_;
                        if _e1028 {
                            break;
                        }
                        let _e1029 = local_17;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e1031 = ((_e687 & 2147483648u) != 0u);
                        if _e1031 {
                            let _e1035 = (((_e687 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e1035 {
                                phi_1971_ = (_e687 & 268435455u);
                            } else {
                                phi_1971_ = u32();
                            }
                            let _e1038 = phi_1971_;
                            phi_1973_ = _e1038;
                            phi_1974_ = select(true, false, _e1035);
                        } else {
                            phi_1973_ = u32();
                            phi_1974_ = true;
                        }
                        let _e1041 = phi_1973_;
                        let _e1043 = phi_1974_;
                        if _e1043 {
                            if ((_e718 & 2147483648u) != 0u) {
                                let _e1049 = (((_e718 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e1049 {
                                    phi_1990_ = (_e718 & 268435455u);
                                } else {
                                    phi_1990_ = u32();
                                }
                                let _e1052 = phi_1990_;
                                phi_1992_ = _e1052;
                                phi_1993_ = select(true, false, _e1049);
                            } else {
                                phi_1992_ = u32();
                                phi_1993_ = true;
                            }
                            let _e1055 = phi_1992_;
                            let _e1057 = phi_1993_;
                            phi_1998_ = select(_e1055, 0u, _e1057);
                        } else {
                            phi_1998_ = _e1041;
                        }
                        let _e1060 = phi_1998_;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e1031 {
                            phi_2026_ = select(_e718, 0u, ((_e718 & 2147483648u) != 0u));
                        } else {
                            phi_2026_ = _e687;
                        }
                        let _e1065 = phi_2026_;
                        if _e1031 {
                            let _e1068 = ((_e687 >> bitcast<u32>(28u)) & 7u);
                            phi_2041_ = select(_e1068, 7u, (_e1068 == 0u));
                        } else {
                            phi_2041_ = 0u;
                        }
                        let _e1072 = phi_2041_;
                        if ((_e718 & 2147483648u) != 0u) {
                            let _e1077 = ((_e718 >> bitcast<u32>(28u)) & 7u);
                            phi_2056_ = select(_e1077, 7u, (_e1077 == 0u));
                        } else {
                            phi_2056_ = 0u;
                        }
                        let _e1081 = phi_2056_;
                        local_16 = _e1029;
                        local_16[0u] = (((_e1065 & 268435455u) | (_e1072 << bitcast<u32>(28u))) | (_e1081 << bitcast<u32>(31i)));
                        phi_2155_ = type_4(0u, 3u);
                        loop {
                            let _e1097 = phi_2155_;
                            if (_e1097.member < _e1097.member_1) {
                                phi_2156_ = type_4((_e1097.member + 1u), _e1097.member_1);
                                phi_2179_ = type_4(1u, _e1097.member);
                            } else {
                                phi_2156_ = _e1097;
                                phi_2179_ = type_4(0u, type_4().member_1);
                            }
                            let _e1110 = phi_2156_;
                            let _e1112 = phi_2179_;
                            let _e1116 = (bitcast<i32>(_e1112.member) != 0i);
                            if _e1116 {
                                let _e1124 = ((_e1112.member_1 + 1u) % 4u);
                                if (_e1124 < 4u) {
                                } else {
                                    phi_2503_ = true;
                                    break;
                                }
                                let _e1127 = local_16[_e1124];
                                local_16[_e1124] = (_e1127 | ((((_e1060 & 268435455u) | ((_e1081 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e1112.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_2155_ = _e1110;
                                phi_2503_ = _e1028;
                                break if !(_e1116);
                            }
                        }
                        let _e1131 = phi_2503_;
                        if _e1131 {
                            break;
                        }
                        let _e1132 = local_16;
                        if _e81 {
                        } else {
                            break;
                        }
                        global_3.member[_e75] = array<u32, 4>(_e1132[0], _e1132[1], _e1132[2], _e1132[3]);
                        if (_e75 == 0u) {
                            if (_e71 == 0u) {
                            } else {
                                if (0u < _e71) {
                                } else {
                                    break;
                                }
                                global_4.member[0u] = type_27(array<u32, 4>(bitcast<u32>(_e683[0]), bitcast<u32>(_e683[1]), bitcast<u32>(_e683[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e682[0]), bitcast<u32>(_e682[1]), bitcast<u32>(_e682[2]), 0u));
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
fn encode_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
