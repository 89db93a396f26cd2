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

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_47 {
    member: array<type_41>,
}

struct type_54 {
    member: u32,
    member_1: type_41,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(2) 
var<storage> global_3: type_32;
@group(0) @binding(1) 
var<uniform> global_4: type_36;
@group(0) @binding(4) 
var<storage> global_5: type_47;
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
    var local_5: array<array<i32, 3>, 3>;
    var local_6: array<array<i32, 3>, 3>;
    var local_7: array<u32, 10>;
    var local_8: array<u32, 4>;
    var local_9: array<type_54, 2>;
    var local_10: type_41;
    var phi_247_: type_8;
    var phi_248_: type_8;
    var phi_271_: type_8;
    var phi_1600_: bool;
    var phi_501_: u32;
    var phi_503_: u32;
    var phi_504_: bool;
    var phi_520_: u32;
    var phi_522_: u32;
    var phi_523_: bool;
    var phi_528_: u32;
    var phi_540_: u32;
    var phi_556_: u32;
    var phi_571_: u32;
    var phi_586_: u32;
    var phi_685_: type_8;
    var phi_686_: type_8;
    var phi_709_: type_8;
    var phi_1617_: bool;
    var phi_1667_: bool;
    var phi_890_: type_8;
    var phi_891_: type_8;
    var phi_916_: type_8;
    var phi_1010_: u32;
    var phi_1016_: u32;
    var phi_1662_: bool;
    var phi_1023_: type_8;
    var phi_1024_: type_8;
    var phi_1047_: type_8;
    var phi_1660_: bool;
    var phi_1076_: type_8;
    var phi_1077_: type_8;
    var phi_1100_: type_8;
    var phi_1110_: type_8;
    var phi_1111_: type_8;
    var phi_1134_: type_8;
    var phi_1170_: i32;
    var phi_1180_: i32;
    var phi_1655_: bool;
    var phi_1672_: bool;
    var phi_1671_: bool;
    var phi_1317_: u32;
    var phi_1323_: u32;
    var phi_1326_: type_8;
    var phi_1327_: type_8;
    var phi_1350_: type_8;
    var phi_1673_: bool;
    var phi_1479_: type_8;
    var phi_1480_: type_8;
    var phi_1503_: type_8;
    var phi_1681_: bool;
    var phi_1690_: bool;
    var phi_1689_: bool;
    var phi_1688_: bool;
    var phi_1687_: bool;
    var phi_1693_: bool;
    var phi_1692_: bool;
    var phi_1691_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e59 = global;
            let _e71 = arrayLength((&global_6.member));
            let _e79 = global_4.member[0u][3u];
            let _e84 = (_e59.x + (_e59.y * 2097152u));
            let _e87 = global_1.member[0u];
            if (_e84 < _e87) {
                let _e89 = (_e84 < arrayLength((&global_3.member)));
                if _e89 {
                    let _e90 = (_e84 < arrayLength((&global_5.member)));
                    if _e90 {
                        let _e91 = (_e84 < arrayLength((&global_7.member)));
                        if _e91 {
                            if _e91 {
                            } else {
                                break;
                            }
                            if _e90 {
                            } else {
                                break;
                            }
                            local_3 = array<i32, 3>(0i, 0i, 0i);
                            local_2 = array<i32, 3>(0i, 0i, 0i);
                            local_1 = array<i32, 3>(0i, 0i, 0i);
                            local = array<i32, 3>(0i, 0i, 0i);
                            phi_247_ = type_8(0u, 3u);
                            loop {
                                let _e95 = phi_247_;
                                if (_e95.member < _e95.member_1) {
                                    phi_248_ = type_8((_e95.member + 1u), _e95.member_1);
                                    phi_271_ = type_8(1u, _e95.member);
                                } else {
                                    phi_248_ = _e95;
                                    phi_271_ = type_8(0u, type_8().member_1);
                                }
                                let _e108 = phi_248_;
                                let _e110 = phi_271_;
                                let _e114 = (bitcast<i32>(_e110.member) != 0i);
                                if _e114 {
                                    let _e116 = ((1u + _e110.member_1) % 4u);
                                    if (_e116 < 4u) {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e121 = global_7.member[_e84][_e116];
                                    let _e123 = ((_e110.member_1 + 1u) % 4u);
                                    if (_e123 < 4u) {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e128 = global_7.member[_e84][_e123];
                                    let _e129 = (_e110.member_1 < 3u);
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e133 = global_5.member[_e84].member[_e110.member_1];
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e137 = global_5.member[_e84].member_1[_e110.member_1];
                                    let _e139 = (_e128 >> bitcast<u32>(11u));
                                    let _e141 = bitcast<u32>((_e137 - _e133));
                                    let _e147 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e141)), 32u, (_e141 == 0u)));
                                    let _e152 = ((select(10u, _e147, (_e147 > 10u)) - 10u) & 31u);
                                    let _e156 = (_e133 + bitcast<i32>(((_e121 & 1023u) << bitcast<u32>(_e152))));
                                    let _e161 = (_e137 - bitcast<i32>(((_e139 & 1023u) << bitcast<u32>(_e152))));
                                    let _e165 = (((_e121 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e169 = (((_e139 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_3[_e110.member_1] = select(_e133, _e156, _e165);
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_1[_e110.member_1] = select(_e156, _e133, _e165);
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_2[_e110.member_1] = select(_e137, _e161, _e169);
                                    if _e129 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local[_e110.member_1] = select(_e161, _e137, _e169);
                                }
                                continue;
                                continuing {
                                    phi_247_ = _e108;
                                    phi_1600_ = false;
                                    break if !(_e114);
                                }
                            }
                            let _e180 = phi_1600_;
                            if _e180 {
                                break;
                            }
                            let _e181 = local;
                            let _e182 = local_1;
                            let _e183 = local_2;
                            let _e184 = local_3;
                            if _e91 {
                            } else {
                                break;
                            }
                            let _e185 = global_7.member[_e84];
                            if _e89 {
                            } else {
                                break;
                            }
                            let _e188 = global_3.member[_e84].member_1;
                            let _e191 = global_3.member[_e84].member_2;
                            let _e193 = ((_e188 & 2147483648u) != 0u);
                            if _e193 {
                                let _e197 = (((_e188 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e197 {
                                    phi_501_ = (_e188 & 268435455u);
                                } else {
                                    phi_501_ = u32();
                                }
                                let _e200 = phi_501_;
                                phi_503_ = _e200;
                                phi_504_ = select(true, false, _e197);
                            } else {
                                phi_503_ = u32();
                                phi_504_ = true;
                            }
                            let _e203 = phi_503_;
                            let _e205 = phi_504_;
                            if _e205 {
                                if ((_e191 & 2147483648u) != 0u) {
                                    let _e211 = (((_e191 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e211 {
                                        phi_520_ = (_e191 & 268435455u);
                                    } else {
                                        phi_520_ = u32();
                                    }
                                    let _e214 = phi_520_;
                                    phi_522_ = _e214;
                                    phi_523_ = select(true, false, _e211);
                                } else {
                                    phi_522_ = u32();
                                    phi_523_ = true;
                                }
                                let _e217 = phi_522_;
                                let _e219 = phi_523_;
                                phi_528_ = select(_e217, 0u, _e219);
                            } else {
                                phi_528_ = _e203;
                            }
                            let _e222 = phi_528_;
                            let _e223 = (_e222 < _e71);
                            if _e223 {
                                if _e223 {
                                } else {
                                    break;
                                }
                                let _e225 = global_6.member[_e222];
                                phi_540_ = _e225;
                            } else {
                                phi_540_ = 0u;
                            }
                            let _e227 = phi_540_;
                            if _e193 {
                                phi_556_ = select(_e191, 0u, ((_e191 & 2147483648u) != 0u));
                            } else {
                                phi_556_ = _e188;
                            }
                            let _e232 = phi_556_;
                            if _e193 {
                                let _e235 = ((_e188 >> bitcast<u32>(28u)) & 7u);
                                phi_571_ = select(_e235, 7u, (_e235 == 0u));
                            } else {
                                phi_571_ = 0u;
                            }
                            let _e239 = phi_571_;
                            if ((_e191 & 2147483648u) != 0u) {
                                let _e244 = ((_e191 >> bitcast<u32>(28u)) & 7u);
                                phi_586_ = select(_e244, 7u, (_e244 == 0u));
                            } else {
                                phi_586_ = 0u;
                            }
                            let _e248 = phi_586_;
                            local_8 = array<u32, 4>(_e185[0], _e185[1], _e185[2], _e185[3]);
                            local_8[0u] = (((_e232 & 268435455u) | (_e239 << bitcast<u32>(28u))) | (_e248 << bitcast<u32>(31i)));
                            phi_685_ = type_8(0u, 3u);
                            loop {
                                let _e269 = phi_685_;
                                if (_e269.member < _e269.member_1) {
                                    phi_686_ = type_8((_e269.member + 1u), _e269.member_1);
                                    phi_709_ = type_8(1u, _e269.member);
                                } else {
                                    phi_686_ = _e269;
                                    phi_709_ = type_8(0u, type_8().member_1);
                                }
                                let _e282 = phi_686_;
                                let _e284 = phi_709_;
                                let _e288 = (bitcast<i32>(_e284.member) != 0i);
                                if _e288 {
                                    let _e296 = ((_e284.member_1 + 1u) % 4u);
                                    if (_e296 < 4u) {
                                    } else {
                                        phi_1617_ = true;
                                        break;
                                    }
                                    let _e299 = local_8[_e296];
                                    local_8[_e296] = (_e299 | ((((_e227 & 268435455u) | ((_e248 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e284.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_685_ = _e282;
                                    phi_1617_ = _e180;
                                    break if !(_e288);
                                }
                            }
                            let _e303 = phi_1617_;
                            if _e303 {
                                break;
                            }
                            let _e304 = local_8;
                            if _e91 {
                            } else {
                                break;
                            }
                            global_7.member[_e84] = array<u32, 4>(_e304[0], _e304[1], _e304[2], _e304[3]);
                            if _e89 {
                            } else {
                                break;
                            }
                            if _e89 {
                            } else {
                                break;
                            }
                            local_9[0u] = type_54(_e188, type_41(_e184, _e183));
                            local_9[1u] = type_54(_e191, type_41(_e182, _e181));
                            phi_1667_ = _e303;
                            phi_890_ = type_8(0u, 2u);
                            loop {
                                let _e317 = phi_1667_;
                                let _e319 = phi_890_;
                                if (_e319.member < _e319.member_1) {
                                    phi_891_ = type_8((_e319.member + 1u), _e319.member_1);
                                    phi_916_ = type_8(1u, _e319.member);
                                } else {
                                    phi_891_ = _e319;
                                    phi_916_ = type_8(0u, type_8().member_1);
                                }
                                let _e332 = phi_891_;
                                let _e334 = phi_916_;
                                let _e338 = (bitcast<i32>(_e334.member) != 0i);
                                if _e338 {
                                    if (_e334.member_1 < 2u) {
                                    } else {
                                        phi_1691_ = true;
                                        break;
                                    }
                                    let _e342 = local_9[_e334.member_1].member;
                                    let _e345 = local_9[_e334.member_1].member_1;
                                    local_10 = _e345;
                                    if ((_e342 & 2147483648u) != 0u) {
                                        let _e350 = local_10.member_1[0u];
                                        let _e353 = local_10.member[0u];
                                        let _e358 = local_10.member_1[1u];
                                        let _e361 = local_10.member[1u];
                                        let _e367 = local_10.member_1[2u];
                                        let _e370 = local_10.member[2u];
                                        let _e373 = ((bitcast<u32>((_e350 - _e353)) | bitcast<u32>((_e358 - _e361))) | bitcast<u32>((_e367 - _e370)));
                                        if (_e373 < 1024u) {
                                            phi_1010_ = 0u;
                                        } else {
                                            phi_1010_ = select(2u, 1u, (_e373 < 2097152u));
                                        }
                                        let _e378 = phi_1010_;
                                        switch bitcast<i32>(_e378) {
                                            case 0: {
                                                phi_1016_ = 1u;
                                                break;
                                            }
                                            case 1: {
                                                phi_1016_ = 2u;
                                                break;
                                            }
                                            case 2: {
                                                phi_1016_ = 3u;
                                                break;
                                            }
                                            default: {
                                                phi_1016_ = u32();
                                                break;
                                            }
                                        }
                                        let _e381 = phi_1016_;
                                        phi_1662_ = _e317;
                                        phi_1023_ = type_8(0u, ((_e342 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e389 = phi_1662_;
                                            let _e391 = phi_1023_;
                                            if (_e391.member < _e391.member_1) {
                                                phi_1024_ = type_8((_e391.member + 1u), _e391.member_1);
                                                phi_1047_ = type_8(1u, _e391.member);
                                            } else {
                                                phi_1024_ = _e391;
                                                phi_1047_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e404 = phi_1024_;
                                            let _e406 = phi_1047_;
                                            let _e410 = (bitcast<i32>(_e406.member) != 0i);
                                            if _e410 {
                                                let _e412 = ((_e342 & 268435455u) + _e406.member_1);
                                                let _e413 = (_e412 < arrayLength((&global_2.member)));
                                                if _e413 {
                                                    let _e414 = (_e412 < _e71);
                                                    if _e414 {
                                                        if _e413 {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        local_5[0u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[1u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[2u] = array<i32, 3>(0i, 0i, 0i);
                                                        phi_1660_ = _e389;
                                                        phi_1076_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e419 = phi_1660_;
                                                            let _e421 = phi_1076_;
                                                            if (_e421.member < _e421.member_1) {
                                                                phi_1077_ = type_8((_e421.member + 1u), _e421.member_1);
                                                                phi_1100_ = type_8(1u, _e421.member);
                                                            } else {
                                                                phi_1077_ = _e421;
                                                                phi_1100_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e434 = phi_1077_;
                                                            let _e436 = phi_1100_;
                                                            let _e440 = (bitcast<i32>(_e436.member) != 0i);
                                                            if _e440 {
                                                                phi_1110_ = type_8(0u, 3u);
                                                                loop {
                                                                    let _e442 = phi_1110_;
                                                                    if (_e442.member < _e442.member_1) {
                                                                        phi_1111_ = type_8((_e442.member + 1u), _e442.member_1);
                                                                        phi_1134_ = type_8(1u, _e442.member);
                                                                    } else {
                                                                        phi_1111_ = _e442;
                                                                        phi_1134_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e455 = phi_1111_;
                                                                    let _e457 = phi_1134_;
                                                                    let _e461 = (bitcast<i32>(_e457.member) != 0i);
                                                                    if _e461 {
                                                                        let _e463 = ((3u * _e436.member_1) + _e457.member_1);
                                                                        if (_e463 < 9u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        let _e468 = global_2.member[_e412].member[_e463];
                                                                        let _e469 = bitcast<u32>(_e468);
                                                                        let _e472 = ((_e469 >> bitcast<u32>(23i)) & 255u);
                                                                        let _e474 = select(0u, 1u, (_e472 != 0u));
                                                                        let _e483 = (bitcast<i32>(_e79) - ((bitcast<i32>(_e472) - bitcast<i32>(_e474)) + -149i));
                                                                        let _e484 = (_e483 < 0i);
                                                                        if _e484 {
                                                                            phi_1170_ = -(_e483);
                                                                        } else {
                                                                            phi_1170_ = 0i;
                                                                        }
                                                                        let _e487 = phi_1170_;
                                                                        if _e484 {
                                                                            phi_1180_ = 0i;
                                                                        } else {
                                                                            phi_1180_ = select(_e483, 31i, (_e483 > 31i));
                                                                        }
                                                                        let _e491 = phi_1180_;
                                                                        let _e492 = (_e491 & 31i);
                                                                        let _e506 = (bitcast<i32>(_e469) >> bitcast<u32>(31i));
                                                                        if (_e436.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        if (_e457.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        local_5[_e436.member_1][_e457.member_1] = ((bitcast<i32>((((((_e469 & 8388607u) | (_e474 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e487) & 31u))) + ((1u << bitcast<u32>(_e492)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e492))) ^ _e506) - _e506);
                                                                    }
                                                                    continue;
                                                                    continuing {
                                                                        phi_1110_ = _e455;
                                                                        phi_1655_ = _e419;
                                                                        break if !(_e461);
                                                                    }
                                                                }
                                                                let _e516 = phi_1655_;
                                                                phi_1671_ = _e516;
                                                                if _e516 {
                                                                    break;
                                                                }
                                                                phi_1672_ = _e516;
                                                            } else {
                                                                phi_1672_ = _e419;
                                                            }
                                                            let _e518 = phi_1672_;
                                                            continue;
                                                            continuing {
                                                                phi_1660_ = _e518;
                                                                phi_1076_ = _e434;
                                                                phi_1671_ = _e518;
                                                                break if !(_e440);
                                                            }
                                                        }
                                                        let _e521 = phi_1671_;
                                                        phi_1687_ = _e521;
                                                        if _e521 {
                                                            break;
                                                        }
                                                        let _e522 = local_5;
                                                        local_6 = _e522;
                                                        if _e413 {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        let _e525 = global_2.member[_e412].member_1;
                                                        let _e526 = local_10.member_1[0u];
                                                        let _e527 = local_10.member[0u];
                                                        let _e530 = local_10.member_1[1u];
                                                        let _e531 = local_10.member[1u];
                                                        let _e535 = local_10.member_1[2u];
                                                        let _e536 = local_10.member[2u];
                                                        let _e539 = ((bitcast<u32>((_e526 - _e527)) | bitcast<u32>((_e530 - _e531))) | bitcast<u32>((_e535 - _e536)));
                                                        if (_e539 < 1024u) {
                                                            phi_1317_ = 0u;
                                                        } else {
                                                            phi_1317_ = select(2u, 1u, (_e539 < 2097152u));
                                                        }
                                                        let _e544 = phi_1317_;
                                                        switch bitcast<i32>(_e544) {
                                                            case 0: {
                                                                phi_1323_ = 1u;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_1323_ = 2u;
                                                                break;
                                                            }
                                                            case 2: {
                                                                phi_1323_ = 3u;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1323_ = u32();
                                                                break;
                                                            }
                                                        }
                                                        let _e547 = phi_1323_;
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1326_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e549 = phi_1326_;
                                                            if (_e549.member < _e549.member_1) {
                                                                phi_1327_ = type_8((_e549.member + 1u), _e549.member_1);
                                                                phi_1350_ = type_8(1u, _e549.member);
                                                            } else {
                                                                phi_1327_ = _e549;
                                                                phi_1350_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e562 = phi_1327_;
                                                            let _e564 = phi_1350_;
                                                            let _e568 = (bitcast<i32>(_e564.member) != 0i);
                                                            if _e568 {
                                                                if (_e564.member_1 < 3u) {
                                                                } else {
                                                                    phi_1673_ = true;
                                                                    break;
                                                                }
                                                                let _e572 = local_6[_e564.member_1][0u];
                                                                let _e575 = local_6[_e564.member_1][1u];
                                                                let _e578 = local_6[_e564.member_1][2u];
                                                                let _e579 = local_10.member[0u];
                                                                let _e581 = bitcast<u32>((_e572 - _e579));
                                                                let _e582 = local_10.member[1u];
                                                                let _e584 = bitcast<u32>((_e575 - _e582));
                                                                let _e585 = local_10.member[2u];
                                                                let _e587 = bitcast<u32>((_e578 - _e585));
                                                                let _e588 = (_e564.member_1 * _e547);
                                                                switch bitcast<i32>(_e544) {
                                                                    case 0: {
                                                                        let _e624 = (_e588 % 10u);
                                                                        if (_e624 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e624] = ((_e581 | (_e584 << bitcast<u32>(10i))) | (_e587 << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        let _e606 = (_e588 % 10u);
                                                                        if (_e606 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e606] = (_e581 | (_e584 << bitcast<u32>(21i)));
                                                                        let _e615 = ((_e588 + 1u) % 10u);
                                                                        if (_e615 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e615] = ((_e584 >> bitcast<u32>(11i)) | (_e587 << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e590 = (_e588 % 10u);
                                                                        if (_e590 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e590] = bitcast<u32>(_e572);
                                                                        let _e595 = ((_e588 + 1u) % 10u);
                                                                        if (_e595 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e595] = bitcast<u32>(_e575);
                                                                        let _e600 = ((_e588 + 2u) % 10u);
                                                                        if (_e600 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e600] = bitcast<u32>(_e578);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1326_ = _e562;
                                                                phi_1673_ = _e521;
                                                                break if !(_e568);
                                                            }
                                                        }
                                                        let _e630 = phi_1673_;
                                                        phi_1687_ = _e630;
                                                        if _e630 {
                                                            break;
                                                        }
                                                        let _e632 = ((3u * _e547) % 10u);
                                                        if (_e632 < 10u) {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        local_4[_e632] = _e525;
                                                        let _e635 = local_4;
                                                        local_7 = _e635;
                                                        phi_1479_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e637 = phi_1479_;
                                                            if (_e637.member < _e637.member_1) {
                                                                phi_1480_ = type_8((_e637.member + 1u), _e637.member_1);
                                                                phi_1503_ = type_8(1u, _e637.member);
                                                            } else {
                                                                phi_1480_ = _e637;
                                                                phi_1503_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e650 = phi_1480_;
                                                            let _e652 = phi_1503_;
                                                            let _e656 = (bitcast<i32>(_e652.member) != 0i);
                                                            if _e656 {
                                                                if _e414 {
                                                                } else {
                                                                    phi_1681_ = true;
                                                                    break;
                                                                }
                                                                let _e658 = global_6.member[_e412];
                                                                let _e659 = (_e658 + _e652.member_1);
                                                                if (_e652.member_1 < ((3u * _e381) + 1u)) {
                                                                    let _e661 = (_e659 < arrayLength((&global_8.member)));
                                                                    if _e661 {
                                                                        if (_e652.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1681_ = true;
                                                                            break;
                                                                        }
                                                                        let _e664 = local_7[_e652.member_1];
                                                                        if _e661 {
                                                                        } else {
                                                                            phi_1681_ = true;
                                                                            break;
                                                                        }
                                                                        global_8.member[_e659] = _e664;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1479_ = _e650;
                                                                phi_1681_ = _e630;
                                                                break if !(_e656);
                                                            }
                                                        }
                                                        let _e669 = phi_1681_;
                                                        phi_1687_ = _e669;
                                                        if _e669 {
                                                            break;
                                                        }
                                                        phi_1690_ = _e669;
                                                    } else {
                                                        phi_1690_ = _e389;
                                                    }
                                                    let _e671 = phi_1690_;
                                                    phi_1689_ = _e671;
                                                } else {
                                                    phi_1689_ = _e389;
                                                }
                                                let _e673 = phi_1689_;
                                                phi_1688_ = _e673;
                                            } else {
                                                phi_1688_ = _e389;
                                            }
                                            let _e675 = phi_1688_;
                                            continue;
                                            continuing {
                                                phi_1662_ = _e675;
                                                phi_1023_ = _e404;
                                                phi_1687_ = _e675;
                                                break if !(_e410);
                                            }
                                        }
                                        let _e678 = phi_1687_;
                                        phi_1691_ = _e678;
                                        if _e678 {
                                            break;
                                        }
                                        phi_1693_ = _e678;
                                    } else {
                                        phi_1693_ = _e317;
                                    }
                                    let _e680 = phi_1693_;
                                    phi_1692_ = _e680;
                                } else {
                                    phi_1692_ = _e317;
                                }
                                let _e682 = phi_1692_;
                                continue;
                                continuing {
                                    phi_1667_ = _e682;
                                    phi_890_ = _e332;
                                    phi_1691_ = _e682;
                                    break if !(_e338);
                                }
                            }
                            let _e685 = phi_1691_;
                            if _e685 {
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
