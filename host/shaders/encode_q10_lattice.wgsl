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
    var phi_383_: u32;
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
            let _e60 = global;
            let _e72 = arrayLength((&global_6.member));
            let _e80 = global_4.member[0u][3u];
            let _e85 = (_e60.x + (_e60.y * 2097152u));
            let _e88 = global_1.member[0u];
            if (_e85 < _e88) {
                let _e90 = (_e85 < arrayLength((&global_3.member)));
                if _e90 {
                    let _e91 = (_e85 < arrayLength((&global_5.member)));
                    if _e91 {
                        let _e92 = (_e85 < arrayLength((&global_7.member)));
                        if _e92 {
                            if _e92 {
                            } else {
                                break;
                            }
                            if _e91 {
                            } else {
                                break;
                            }
                            local_3 = array<i32, 3>(0i, 0i, 0i);
                            local_2 = array<i32, 3>(0i, 0i, 0i);
                            local_1 = array<i32, 3>(0i, 0i, 0i);
                            local = array<i32, 3>(0i, 0i, 0i);
                            phi_247_ = type_8(0u, 3u);
                            loop {
                                let _e96 = phi_247_;
                                if (_e96.member < _e96.member_1) {
                                    phi_248_ = type_8((_e96.member + 1u), _e96.member_1);
                                    phi_271_ = type_8(1u, _e96.member);
                                } else {
                                    phi_248_ = _e96;
                                    phi_271_ = type_8(0u, type_8().member_1);
                                }
                                let _e109 = phi_248_;
                                let _e111 = phi_271_;
                                let _e115 = (bitcast<i32>(_e111.member) != 0i);
                                if _e115 {
                                    let _e117 = ((1u + _e111.member_1) % 4u);
                                    if (_e117 < 4u) {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e122 = global_7.member[_e85][_e117];
                                    let _e124 = ((_e111.member_1 + 1u) % 4u);
                                    if (_e124 < 4u) {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e129 = global_7.member[_e85][_e124];
                                    let _e130 = (_e111.member_1 < 3u);
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e134 = global_5.member[_e85].member[_e111.member_1];
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    let _e138 = global_5.member[_e85].member_1[_e111.member_1];
                                    let _e140 = (_e129 >> bitcast<u32>(11u));
                                    let _e142 = bitcast<u32>((_e138 - _e134));
                                    let _e147 = select((bitcast<u32>(31i) - firstLeadingBit(_e142)), 32u, (_e142 == 0u));
                                    if ((32u - _e147) > 10u) {
                                        phi_383_ = (22u - _e147);
                                    } else {
                                        phi_383_ = 0u;
                                    }
                                    let _e152 = phi_383_;
                                    let _e154 = (_e152 & 31u);
                                    let _e158 = (_e134 + bitcast<i32>(((_e122 & 1023u) << bitcast<u32>(_e154))));
                                    let _e163 = (_e138 - bitcast<i32>(((_e140 & 1023u) << bitcast<u32>(_e154))));
                                    let _e167 = (((_e122 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e171 = (((_e140 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_3[_e111.member_1] = select(_e134, _e158, _e167);
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_1[_e111.member_1] = select(_e158, _e134, _e167);
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local_2[_e111.member_1] = select(_e138, _e163, _e171);
                                    if _e130 {
                                    } else {
                                        phi_1600_ = true;
                                        break;
                                    }
                                    local[_e111.member_1] = select(_e163, _e138, _e171);
                                }
                                continue;
                                continuing {
                                    phi_247_ = _e109;
                                    phi_1600_ = false;
                                    break if !(_e115);
                                }
                            }
                            let _e182 = phi_1600_;
                            if _e182 {
                                break;
                            }
                            let _e183 = local;
                            let _e184 = local_1;
                            let _e185 = local_2;
                            let _e186 = local_3;
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e187 = global_7.member[_e85];
                            if _e90 {
                            } else {
                                break;
                            }
                            let _e190 = global_3.member[_e85].member_1;
                            let _e193 = global_3.member[_e85].member_2;
                            let _e195 = ((_e190 & 2147483648u) != 0u);
                            if _e195 {
                                let _e199 = (((_e190 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e199 {
                                    phi_501_ = (_e190 & 268435455u);
                                } else {
                                    phi_501_ = u32();
                                }
                                let _e202 = phi_501_;
                                phi_503_ = _e202;
                                phi_504_ = select(true, false, _e199);
                            } else {
                                phi_503_ = u32();
                                phi_504_ = true;
                            }
                            let _e205 = phi_503_;
                            let _e207 = phi_504_;
                            if _e207 {
                                if ((_e193 & 2147483648u) != 0u) {
                                    let _e213 = (((_e193 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e213 {
                                        phi_520_ = (_e193 & 268435455u);
                                    } else {
                                        phi_520_ = u32();
                                    }
                                    let _e216 = phi_520_;
                                    phi_522_ = _e216;
                                    phi_523_ = select(true, false, _e213);
                                } else {
                                    phi_522_ = u32();
                                    phi_523_ = true;
                                }
                                let _e219 = phi_522_;
                                let _e221 = phi_523_;
                                phi_528_ = select(_e219, 0u, _e221);
                            } else {
                                phi_528_ = _e205;
                            }
                            let _e224 = phi_528_;
                            let _e225 = (_e224 < _e72);
                            if _e225 {
                                if _e225 {
                                } else {
                                    break;
                                }
                                let _e227 = global_6.member[_e224];
                                phi_540_ = _e227;
                            } else {
                                phi_540_ = 0u;
                            }
                            let _e229 = phi_540_;
                            if _e195 {
                                phi_556_ = select(_e193, 0u, ((_e193 & 2147483648u) != 0u));
                            } else {
                                phi_556_ = _e190;
                            }
                            let _e234 = phi_556_;
                            if _e195 {
                                let _e237 = ((_e190 >> bitcast<u32>(28u)) & 7u);
                                phi_571_ = select(_e237, 7u, (_e237 == 0u));
                            } else {
                                phi_571_ = 0u;
                            }
                            let _e241 = phi_571_;
                            if ((_e193 & 2147483648u) != 0u) {
                                let _e246 = ((_e193 >> bitcast<u32>(28u)) & 7u);
                                phi_586_ = select(_e246, 7u, (_e246 == 0u));
                            } else {
                                phi_586_ = 0u;
                            }
                            let _e250 = phi_586_;
                            local_8 = array<u32, 4>(_e187[0], _e187[1], _e187[2], _e187[3]);
                            local_8[0u] = (((_e234 & 268435455u) | (_e241 << bitcast<u32>(28u))) | (_e250 << bitcast<u32>(31i)));
                            phi_685_ = type_8(0u, 3u);
                            loop {
                                let _e271 = phi_685_;
                                if (_e271.member < _e271.member_1) {
                                    phi_686_ = type_8((_e271.member + 1u), _e271.member_1);
                                    phi_709_ = type_8(1u, _e271.member);
                                } else {
                                    phi_686_ = _e271;
                                    phi_709_ = type_8(0u, type_8().member_1);
                                }
                                let _e284 = phi_686_;
                                let _e286 = phi_709_;
                                let _e290 = (bitcast<i32>(_e286.member) != 0i);
                                if _e290 {
                                    let _e298 = ((_e286.member_1 + 1u) % 4u);
                                    if (_e298 < 4u) {
                                    } else {
                                        phi_1617_ = true;
                                        break;
                                    }
                                    let _e301 = local_8[_e298];
                                    local_8[_e298] = (_e301 | ((((_e229 & 268435455u) | ((_e250 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e286.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_685_ = _e284;
                                    phi_1617_ = _e182;
                                    break if !(_e290);
                                }
                            }
                            let _e305 = phi_1617_;
                            if _e305 {
                                break;
                            }
                            let _e306 = local_8;
                            if _e92 {
                            } else {
                                break;
                            }
                            global_7.member[_e85] = array<u32, 4>(_e306[0], _e306[1], _e306[2], _e306[3]);
                            if _e90 {
                            } else {
                                break;
                            }
                            if _e90 {
                            } else {
                                break;
                            }
                            local_9[0u] = type_54(_e190, type_41(_e186, _e185));
                            local_9[1u] = type_54(_e193, type_41(_e184, _e183));
                            phi_1667_ = _e305;
                            phi_890_ = type_8(0u, 2u);
                            loop {
                                let _e319 = phi_1667_;
                                let _e321 = phi_890_;
                                if (_e321.member < _e321.member_1) {
                                    phi_891_ = type_8((_e321.member + 1u), _e321.member_1);
                                    phi_916_ = type_8(1u, _e321.member);
                                } else {
                                    phi_891_ = _e321;
                                    phi_916_ = type_8(0u, type_8().member_1);
                                }
                                let _e334 = phi_891_;
                                let _e336 = phi_916_;
                                let _e340 = (bitcast<i32>(_e336.member) != 0i);
                                if _e340 {
                                    if (_e336.member_1 < 2u) {
                                    } else {
                                        phi_1691_ = true;
                                        break;
                                    }
                                    let _e344 = local_9[_e336.member_1].member;
                                    let _e347 = local_9[_e336.member_1].member_1;
                                    local_10 = _e347;
                                    if ((_e344 & 2147483648u) != 0u) {
                                        let _e352 = local_10.member_1[0u];
                                        let _e355 = local_10.member[0u];
                                        let _e360 = local_10.member_1[1u];
                                        let _e363 = local_10.member[1u];
                                        let _e369 = local_10.member_1[2u];
                                        let _e372 = local_10.member[2u];
                                        let _e375 = ((bitcast<u32>((_e352 - _e355)) | bitcast<u32>((_e360 - _e363))) | bitcast<u32>((_e369 - _e372)));
                                        if (_e375 < 1024u) {
                                            phi_1010_ = 0u;
                                        } else {
                                            phi_1010_ = select(2u, 1u, (_e375 < 2097152u));
                                        }
                                        let _e380 = phi_1010_;
                                        switch bitcast<i32>(_e380) {
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
                                        let _e383 = phi_1016_;
                                        phi_1662_ = _e319;
                                        phi_1023_ = type_8(0u, ((_e344 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e391 = phi_1662_;
                                            let _e393 = phi_1023_;
                                            if (_e393.member < _e393.member_1) {
                                                phi_1024_ = type_8((_e393.member + 1u), _e393.member_1);
                                                phi_1047_ = type_8(1u, _e393.member);
                                            } else {
                                                phi_1024_ = _e393;
                                                phi_1047_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e406 = phi_1024_;
                                            let _e408 = phi_1047_;
                                            let _e412 = (bitcast<i32>(_e408.member) != 0i);
                                            if _e412 {
                                                let _e414 = ((_e344 & 268435455u) + _e408.member_1);
                                                let _e415 = (_e414 < arrayLength((&global_2.member)));
                                                if _e415 {
                                                    let _e416 = (_e414 < _e72);
                                                    if _e416 {
                                                        if _e415 {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        local_5[0u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[1u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[2u] = array<i32, 3>(0i, 0i, 0i);
                                                        phi_1660_ = _e391;
                                                        phi_1076_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e421 = phi_1660_;
                                                            let _e423 = phi_1076_;
                                                            if (_e423.member < _e423.member_1) {
                                                                phi_1077_ = type_8((_e423.member + 1u), _e423.member_1);
                                                                phi_1100_ = type_8(1u, _e423.member);
                                                            } else {
                                                                phi_1077_ = _e423;
                                                                phi_1100_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e436 = phi_1077_;
                                                            let _e438 = phi_1100_;
                                                            let _e442 = (bitcast<i32>(_e438.member) != 0i);
                                                            if _e442 {
                                                                phi_1110_ = type_8(0u, 3u);
                                                                loop {
                                                                    let _e444 = phi_1110_;
                                                                    if (_e444.member < _e444.member_1) {
                                                                        phi_1111_ = type_8((_e444.member + 1u), _e444.member_1);
                                                                        phi_1134_ = type_8(1u, _e444.member);
                                                                    } else {
                                                                        phi_1111_ = _e444;
                                                                        phi_1134_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e457 = phi_1111_;
                                                                    let _e459 = phi_1134_;
                                                                    let _e463 = (bitcast<i32>(_e459.member) != 0i);
                                                                    if _e463 {
                                                                        let _e465 = ((3u * _e438.member_1) + _e459.member_1);
                                                                        if (_e465 < 9u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        let _e470 = global_2.member[_e414].member[_e465];
                                                                        let _e471 = bitcast<u32>(_e470);
                                                                        let _e474 = ((_e471 >> bitcast<u32>(23i)) & 255u);
                                                                        let _e476 = select(0u, 1u, (_e474 != 0u));
                                                                        let _e485 = (bitcast<i32>(_e80) - ((bitcast<i32>(_e474) - bitcast<i32>(_e476)) + -149i));
                                                                        let _e486 = (_e485 < 0i);
                                                                        if _e486 {
                                                                            phi_1170_ = -(_e485);
                                                                        } else {
                                                                            phi_1170_ = 0i;
                                                                        }
                                                                        let _e489 = phi_1170_;
                                                                        if _e486 {
                                                                            phi_1180_ = 0i;
                                                                        } else {
                                                                            phi_1180_ = select(_e485, 31i, (_e485 > 31i));
                                                                        }
                                                                        let _e493 = phi_1180_;
                                                                        let _e494 = (_e493 & 31i);
                                                                        let _e508 = (bitcast<i32>(_e471) >> bitcast<u32>(31i));
                                                                        if (_e438.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        if (_e459.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1655_ = true;
                                                                            break;
                                                                        }
                                                                        local_5[_e438.member_1][_e459.member_1] = ((bitcast<i32>((((((_e471 & 8388607u) | (_e476 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e489) & 31u))) + ((1u << bitcast<u32>(_e494)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e494))) ^ _e508) - _e508);
                                                                    }
                                                                    continue;
                                                                    continuing {
                                                                        phi_1110_ = _e457;
                                                                        phi_1655_ = _e421;
                                                                        break if !(_e463);
                                                                    }
                                                                }
                                                                let _e518 = phi_1655_;
                                                                phi_1671_ = _e518;
                                                                if _e518 {
                                                                    break;
                                                                }
                                                                phi_1672_ = _e518;
                                                            } else {
                                                                phi_1672_ = _e421;
                                                            }
                                                            let _e520 = phi_1672_;
                                                            continue;
                                                            continuing {
                                                                phi_1660_ = _e520;
                                                                phi_1076_ = _e436;
                                                                phi_1671_ = _e520;
                                                                break if !(_e442);
                                                            }
                                                        }
                                                        let _e523 = phi_1671_;
                                                        phi_1687_ = _e523;
                                                        if _e523 {
                                                            break;
                                                        }
                                                        let _e524 = local_5;
                                                        local_6 = _e524;
                                                        if _e415 {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        let _e527 = global_2.member[_e414].member_1;
                                                        let _e528 = local_10.member_1[0u];
                                                        let _e529 = local_10.member[0u];
                                                        let _e532 = local_10.member_1[1u];
                                                        let _e533 = local_10.member[1u];
                                                        let _e537 = local_10.member_1[2u];
                                                        let _e538 = local_10.member[2u];
                                                        let _e541 = ((bitcast<u32>((_e528 - _e529)) | bitcast<u32>((_e532 - _e533))) | bitcast<u32>((_e537 - _e538)));
                                                        if (_e541 < 1024u) {
                                                            phi_1317_ = 0u;
                                                        } else {
                                                            phi_1317_ = select(2u, 1u, (_e541 < 2097152u));
                                                        }
                                                        let _e546 = phi_1317_;
                                                        switch bitcast<i32>(_e546) {
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
                                                        let _e549 = phi_1323_;
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1326_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e551 = phi_1326_;
                                                            if (_e551.member < _e551.member_1) {
                                                                phi_1327_ = type_8((_e551.member + 1u), _e551.member_1);
                                                                phi_1350_ = type_8(1u, _e551.member);
                                                            } else {
                                                                phi_1327_ = _e551;
                                                                phi_1350_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e564 = phi_1327_;
                                                            let _e566 = phi_1350_;
                                                            let _e570 = (bitcast<i32>(_e566.member) != 0i);
                                                            if _e570 {
                                                                if (_e566.member_1 < 3u) {
                                                                } else {
                                                                    phi_1673_ = true;
                                                                    break;
                                                                }
                                                                let _e574 = local_6[_e566.member_1][0u];
                                                                let _e577 = local_6[_e566.member_1][1u];
                                                                let _e580 = local_6[_e566.member_1][2u];
                                                                let _e581 = local_10.member[0u];
                                                                let _e583 = bitcast<u32>((_e574 - _e581));
                                                                let _e584 = local_10.member[1u];
                                                                let _e586 = bitcast<u32>((_e577 - _e584));
                                                                let _e587 = local_10.member[2u];
                                                                let _e589 = bitcast<u32>((_e580 - _e587));
                                                                let _e590 = (_e566.member_1 * _e549);
                                                                switch bitcast<i32>(_e546) {
                                                                    case 0: {
                                                                        let _e626 = (_e590 % 10u);
                                                                        if (_e626 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e626] = ((_e583 | (_e586 << bitcast<u32>(10i))) | (_e589 << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        let _e608 = (_e590 % 10u);
                                                                        if (_e608 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e608] = (_e583 | (_e586 << bitcast<u32>(21i)));
                                                                        let _e617 = ((_e590 + 1u) % 10u);
                                                                        if (_e617 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e617] = ((_e586 >> bitcast<u32>(11i)) | (_e589 << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e592 = (_e590 % 10u);
                                                                        if (_e592 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e592] = bitcast<u32>(_e574);
                                                                        let _e597 = ((_e590 + 1u) % 10u);
                                                                        if (_e597 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e597] = bitcast<u32>(_e577);
                                                                        let _e602 = ((_e590 + 2u) % 10u);
                                                                        if (_e602 < 10u) {
                                                                        } else {
                                                                            phi_1673_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e602] = bitcast<u32>(_e580);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1326_ = _e564;
                                                                phi_1673_ = _e523;
                                                                break if !(_e570);
                                                            }
                                                        }
                                                        let _e632 = phi_1673_;
                                                        phi_1687_ = _e632;
                                                        if _e632 {
                                                            break;
                                                        }
                                                        let _e634 = ((3u * _e549) % 10u);
                                                        if (_e634 < 10u) {
                                                        } else {
                                                            phi_1687_ = true;
                                                            break;
                                                        }
                                                        local_4[_e634] = _e527;
                                                        let _e637 = local_4;
                                                        local_7 = _e637;
                                                        phi_1479_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e639 = phi_1479_;
                                                            if (_e639.member < _e639.member_1) {
                                                                phi_1480_ = type_8((_e639.member + 1u), _e639.member_1);
                                                                phi_1503_ = type_8(1u, _e639.member);
                                                            } else {
                                                                phi_1480_ = _e639;
                                                                phi_1503_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e652 = phi_1480_;
                                                            let _e654 = phi_1503_;
                                                            let _e658 = (bitcast<i32>(_e654.member) != 0i);
                                                            if _e658 {
                                                                if _e416 {
                                                                } else {
                                                                    phi_1681_ = true;
                                                                    break;
                                                                }
                                                                let _e660 = global_6.member[_e414];
                                                                let _e661 = (_e660 + _e654.member_1);
                                                                if (_e654.member_1 < ((3u * _e383) + 1u)) {
                                                                    let _e663 = (_e661 < arrayLength((&global_8.member)));
                                                                    if _e663 {
                                                                        if (_e654.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1681_ = true;
                                                                            break;
                                                                        }
                                                                        let _e666 = local_7[_e654.member_1];
                                                                        if _e663 {
                                                                        } else {
                                                                            phi_1681_ = true;
                                                                            break;
                                                                        }
                                                                        global_8.member[_e661] = _e666;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1479_ = _e652;
                                                                phi_1681_ = _e632;
                                                                break if !(_e658);
                                                            }
                                                        }
                                                        let _e671 = phi_1681_;
                                                        phi_1687_ = _e671;
                                                        if _e671 {
                                                            break;
                                                        }
                                                        phi_1690_ = _e671;
                                                    } else {
                                                        phi_1690_ = _e391;
                                                    }
                                                    let _e673 = phi_1690_;
                                                    phi_1689_ = _e673;
                                                } else {
                                                    phi_1689_ = _e391;
                                                }
                                                let _e675 = phi_1689_;
                                                phi_1688_ = _e675;
                                            } else {
                                                phi_1688_ = _e391;
                                            }
                                            let _e677 = phi_1688_;
                                            continue;
                                            continuing {
                                                phi_1662_ = _e677;
                                                phi_1023_ = _e406;
                                                phi_1687_ = _e677;
                                                break if !(_e412);
                                            }
                                        }
                                        let _e680 = phi_1687_;
                                        phi_1691_ = _e680;
                                        if _e680 {
                                            break;
                                        }
                                        phi_1693_ = _e680;
                                    } else {
                                        phi_1693_ = _e319;
                                    }
                                    let _e682 = phi_1693_;
                                    phi_1692_ = _e682;
                                } else {
                                    phi_1692_ = _e319;
                                }
                                let _e684 = phi_1692_;
                                continue;
                                continuing {
                                    phi_1667_ = _e684;
                                    phi_890_ = _e334;
                                    phi_1691_ = _e684;
                                    break if !(_e340);
                                }
                            }
                            let _e687 = phi_1691_;
                            if _e687 {
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
