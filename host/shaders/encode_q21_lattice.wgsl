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

struct type_32 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_42 {
    member: array<array<u32, 7>>,
}

struct type_47 {
    member: array<type_36>,
}

struct type_54 {
    member: u32,
    member_1: type_36,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(2) 
var<storage> global_3: type_28;
@group(0) @binding(1) 
var<uniform> global_4: type_32;
@group(0) @binding(4) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_8: type_42;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<i32, 3>;
    var local_3: array<i32, 3>;
    var local_4: array<u32, 10>;
    var local_5: array<array<i32, 3>, 3>;
    var local_6: array<array<i32, 3>, 3>;
    var local_7: array<u32, 10>;
    var local_8: array<u32, 7>;
    var local_9: array<type_54, 2>;
    var local_10: type_36;
    var phi_252_: type_8;
    var phi_253_: type_8;
    var phi_276_: type_8;
    var phi_388_: u32;
    var phi_1606_: bool;
    var phi_506_: u32;
    var phi_508_: u32;
    var phi_509_: bool;
    var phi_525_: u32;
    var phi_527_: u32;
    var phi_528_: bool;
    var phi_533_: u32;
    var phi_545_: u32;
    var phi_561_: u32;
    var phi_576_: u32;
    var phi_591_: u32;
    var phi_693_: type_8;
    var phi_694_: type_8;
    var phi_717_: type_8;
    var phi_1623_: bool;
    var phi_1673_: bool;
    var phi_901_: type_8;
    var phi_902_: type_8;
    var phi_927_: type_8;
    var phi_1021_: u32;
    var phi_1027_: u32;
    var phi_1668_: bool;
    var phi_1034_: type_8;
    var phi_1035_: type_8;
    var phi_1058_: type_8;
    var phi_1666_: bool;
    var phi_1087_: type_8;
    var phi_1088_: type_8;
    var phi_1111_: type_8;
    var phi_1121_: type_8;
    var phi_1122_: type_8;
    var phi_1145_: type_8;
    var phi_1181_: i32;
    var phi_1191_: i32;
    var phi_1661_: bool;
    var phi_1678_: bool;
    var phi_1677_: bool;
    var phi_1328_: u32;
    var phi_1334_: u32;
    var phi_1337_: type_8;
    var phi_1338_: type_8;
    var phi_1361_: type_8;
    var phi_1679_: bool;
    var phi_1490_: type_8;
    var phi_1491_: type_8;
    var phi_1514_: type_8;
    var phi_1687_: bool;
    var phi_1696_: bool;
    var phi_1695_: bool;
    var phi_1694_: bool;
    var phi_1693_: bool;
    var phi_1699_: bool;
    var phi_1698_: bool;
    var phi_1697_: bool;

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
                        let _e92 = (_e85 < arrayLength((&global_8.member)));
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
                            phi_252_ = type_8(0u, 3u);
                            loop {
                                let _e96 = phi_252_;
                                if (_e96.member < _e96.member_1) {
                                    phi_253_ = type_8((_e96.member + 1u), _e96.member_1);
                                    phi_276_ = type_8(1u, _e96.member);
                                } else {
                                    phi_253_ = _e96;
                                    phi_276_ = type_8(0u, type_8().member_1);
                                }
                                let _e109 = phi_253_;
                                let _e111 = phi_276_;
                                let _e115 = (bitcast<i32>(_e111.member) != 0i);
                                if _e115 {
                                    let _e116 = (_e111.member_1 * 2u);
                                    let _e118 = ((1u + _e116) % 7u);
                                    if (_e118 < 7u) {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e123 = global_8.member[_e85][_e118];
                                    let _e125 = ((_e116 + 2u) % 7u);
                                    if (_e125 < 7u) {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e130 = global_8.member[_e85][_e125];
                                    let _e131 = (_e111.member_1 < 3u);
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e135 = global_5.member[_e85].member[_e111.member_1];
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e139 = global_5.member[_e85].member_1[_e111.member_1];
                                    let _e141 = bitcast<u32>((_e139 - _e135));
                                    let _e146 = select((bitcast<u32>(31i) - firstLeadingBit(_e141)), 32u, (_e141 == 0u));
                                    if ((32u - _e146) > 21u) {
                                        phi_388_ = (11u - _e146);
                                    } else {
                                        phi_388_ = 0u;
                                    }
                                    let _e151 = phi_388_;
                                    let _e153 = (_e151 & 31u);
                                    let _e157 = (_e135 + bitcast<i32>(((_e123 & 2097151u) << bitcast<u32>(_e153))));
                                    let _e162 = (_e139 - bitcast<i32>(((_e130 & 2097151u) << bitcast<u32>(_e153))));
                                    let _e166 = (((_e123 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e170 = (((_e130 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_3[_e111.member_1] = select(_e135, _e157, _e166);
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_1[_e111.member_1] = select(_e157, _e135, _e166);
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_2[_e111.member_1] = select(_e139, _e162, _e170);
                                    if _e131 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local[_e111.member_1] = select(_e162, _e139, _e170);
                                }
                                continue;
                                continuing {
                                    phi_252_ = _e109;
                                    phi_1606_ = false;
                                    break if !(_e115);
                                }
                            }
                            let _e181 = phi_1606_;
                            if _e181 {
                                break;
                            }
                            let _e182 = local;
                            let _e183 = local_1;
                            let _e184 = local_2;
                            let _e185 = local_3;
                            if _e92 {
                            } else {
                                break;
                            }
                            let _e186 = global_8.member[_e85];
                            if _e90 {
                            } else {
                                break;
                            }
                            let _e189 = global_3.member[_e85].member_1;
                            let _e192 = global_3.member[_e85].member_2;
                            let _e194 = ((_e189 & 2147483648u) != 0u);
                            if _e194 {
                                let _e198 = (((_e189 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e198 {
                                    phi_506_ = (_e189 & 268435455u);
                                } else {
                                    phi_506_ = u32();
                                }
                                let _e201 = phi_506_;
                                phi_508_ = _e201;
                                phi_509_ = select(true, false, _e198);
                            } else {
                                phi_508_ = u32();
                                phi_509_ = true;
                            }
                            let _e204 = phi_508_;
                            let _e206 = phi_509_;
                            if _e206 {
                                if ((_e192 & 2147483648u) != 0u) {
                                    let _e212 = (((_e192 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e212 {
                                        phi_525_ = (_e192 & 268435455u);
                                    } else {
                                        phi_525_ = u32();
                                    }
                                    let _e215 = phi_525_;
                                    phi_527_ = _e215;
                                    phi_528_ = select(true, false, _e212);
                                } else {
                                    phi_527_ = u32();
                                    phi_528_ = true;
                                }
                                let _e218 = phi_527_;
                                let _e220 = phi_528_;
                                phi_533_ = select(_e218, 0u, _e220);
                            } else {
                                phi_533_ = _e204;
                            }
                            let _e223 = phi_533_;
                            let _e224 = (_e223 < _e72);
                            if _e224 {
                                if _e224 {
                                } else {
                                    break;
                                }
                                let _e226 = global_6.member[_e223];
                                phi_545_ = _e226;
                            } else {
                                phi_545_ = 0u;
                            }
                            let _e228 = phi_545_;
                            if _e194 {
                                phi_561_ = select(_e192, 0u, ((_e192 & 2147483648u) != 0u));
                            } else {
                                phi_561_ = _e189;
                            }
                            let _e233 = phi_561_;
                            if _e194 {
                                let _e236 = ((_e189 >> bitcast<u32>(28u)) & 7u);
                                phi_576_ = select(_e236, 7u, (_e236 == 0u));
                            } else {
                                phi_576_ = 0u;
                            }
                            let _e240 = phi_576_;
                            if ((_e192 & 2147483648u) != 0u) {
                                let _e245 = ((_e192 >> bitcast<u32>(28u)) & 7u);
                                phi_591_ = select(_e245, 7u, (_e245 == 0u));
                            } else {
                                phi_591_ = 0u;
                            }
                            let _e249 = phi_591_;
                            local_8 = array<u32, 7>(_e186[0], _e186[1], _e186[2], _e186[3], _e186[4], _e186[5], _e186[6]);
                            local_8[0u] = (((_e233 & 268435455u) | (_e240 << bitcast<u32>(28u))) | (_e249 << bitcast<u32>(31i)));
                            phi_693_ = type_8(0u, 3u);
                            loop {
                                let _e273 = phi_693_;
                                if (_e273.member < _e273.member_1) {
                                    phi_694_ = type_8((_e273.member + 1u), _e273.member_1);
                                    phi_717_ = type_8(1u, _e273.member);
                                } else {
                                    phi_694_ = _e273;
                                    phi_717_ = type_8(0u, type_8().member_1);
                                }
                                let _e286 = phi_694_;
                                let _e288 = phi_717_;
                                let _e292 = (bitcast<i32>(_e288.member) != 0i);
                                if _e292 {
                                    let _e301 = (((_e288.member_1 + 1u) * 2u) % 7u);
                                    if (_e301 < 7u) {
                                    } else {
                                        phi_1623_ = true;
                                        break;
                                    }
                                    let _e304 = local_8[_e301];
                                    local_8[_e301] = (_e304 | ((((_e228 & 268435455u) | ((_e249 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e288.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_693_ = _e286;
                                    phi_1623_ = _e181;
                                    break if !(_e292);
                                }
                            }
                            let _e308 = phi_1623_;
                            if _e308 {
                                break;
                            }
                            let _e309 = local_8;
                            if _e92 {
                            } else {
                                break;
                            }
                            global_8.member[_e85] = array<u32, 7>(_e309[0], _e309[1], _e309[2], _e309[3], _e309[4], _e309[5], _e309[6]);
                            if _e90 {
                            } else {
                                break;
                            }
                            if _e90 {
                            } else {
                                break;
                            }
                            local_9[0u] = type_54(_e189, type_36(_e185, _e184));
                            local_9[1u] = type_54(_e192, type_36(_e183, _e182));
                            phi_1673_ = _e308;
                            phi_901_ = type_8(0u, 2u);
                            loop {
                                let _e325 = phi_1673_;
                                let _e327 = phi_901_;
                                if (_e327.member < _e327.member_1) {
                                    phi_902_ = type_8((_e327.member + 1u), _e327.member_1);
                                    phi_927_ = type_8(1u, _e327.member);
                                } else {
                                    phi_902_ = _e327;
                                    phi_927_ = type_8(0u, type_8().member_1);
                                }
                                let _e340 = phi_902_;
                                let _e342 = phi_927_;
                                let _e346 = (bitcast<i32>(_e342.member) != 0i);
                                if _e346 {
                                    if (_e342.member_1 < 2u) {
                                    } else {
                                        phi_1697_ = true;
                                        break;
                                    }
                                    let _e350 = local_9[_e342.member_1].member;
                                    let _e353 = local_9[_e342.member_1].member_1;
                                    local_10 = _e353;
                                    if ((_e350 & 2147483648u) != 0u) {
                                        let _e358 = local_10.member_1[0u];
                                        let _e361 = local_10.member[0u];
                                        let _e366 = local_10.member_1[1u];
                                        let _e369 = local_10.member[1u];
                                        let _e375 = local_10.member_1[2u];
                                        let _e378 = local_10.member[2u];
                                        let _e381 = ((bitcast<u32>((_e358 - _e361)) | bitcast<u32>((_e366 - _e369))) | bitcast<u32>((_e375 - _e378)));
                                        if (_e381 < 1024u) {
                                            phi_1021_ = 0u;
                                        } else {
                                            phi_1021_ = select(2u, 1u, (_e381 < 2097152u));
                                        }
                                        let _e386 = phi_1021_;
                                        switch bitcast<i32>(_e386) {
                                            case 0: {
                                                phi_1027_ = 1u;
                                                break;
                                            }
                                            case 1: {
                                                phi_1027_ = 2u;
                                                break;
                                            }
                                            case 2: {
                                                phi_1027_ = 3u;
                                                break;
                                            }
                                            default: {
                                                phi_1027_ = u32();
                                                break;
                                            }
                                        }
                                        let _e389 = phi_1027_;
                                        phi_1668_ = _e325;
                                        phi_1034_ = type_8(0u, ((_e350 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e397 = phi_1668_;
                                            let _e399 = phi_1034_;
                                            if (_e399.member < _e399.member_1) {
                                                phi_1035_ = type_8((_e399.member + 1u), _e399.member_1);
                                                phi_1058_ = type_8(1u, _e399.member);
                                            } else {
                                                phi_1035_ = _e399;
                                                phi_1058_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e412 = phi_1035_;
                                            let _e414 = phi_1058_;
                                            let _e418 = (bitcast<i32>(_e414.member) != 0i);
                                            if _e418 {
                                                let _e420 = ((_e350 & 268435455u) + _e414.member_1);
                                                let _e421 = (_e420 < arrayLength((&global_2.member)));
                                                if _e421 {
                                                    let _e422 = (_e420 < _e72);
                                                    if _e422 {
                                                        if _e421 {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        local_5[0u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[1u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[2u] = array<i32, 3>(0i, 0i, 0i);
                                                        phi_1666_ = _e397;
                                                        phi_1087_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e427 = phi_1666_;
                                                            let _e429 = phi_1087_;
                                                            if (_e429.member < _e429.member_1) {
                                                                phi_1088_ = type_8((_e429.member + 1u), _e429.member_1);
                                                                phi_1111_ = type_8(1u, _e429.member);
                                                            } else {
                                                                phi_1088_ = _e429;
                                                                phi_1111_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e442 = phi_1088_;
                                                            let _e444 = phi_1111_;
                                                            let _e448 = (bitcast<i32>(_e444.member) != 0i);
                                                            if _e448 {
                                                                phi_1121_ = type_8(0u, 3u);
                                                                loop {
                                                                    let _e450 = phi_1121_;
                                                                    if (_e450.member < _e450.member_1) {
                                                                        phi_1122_ = type_8((_e450.member + 1u), _e450.member_1);
                                                                        phi_1145_ = type_8(1u, _e450.member);
                                                                    } else {
                                                                        phi_1122_ = _e450;
                                                                        phi_1145_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e463 = phi_1122_;
                                                                    let _e465 = phi_1145_;
                                                                    let _e469 = (bitcast<i32>(_e465.member) != 0i);
                                                                    if _e469 {
                                                                        let _e471 = ((3u * _e444.member_1) + _e465.member_1);
                                                                        if (_e471 < 9u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        let _e476 = global_2.member[_e420].member[_e471];
                                                                        let _e477 = bitcast<u32>(_e476);
                                                                        let _e480 = ((_e477 >> bitcast<u32>(23i)) & 255u);
                                                                        let _e482 = select(0u, 1u, (_e480 != 0u));
                                                                        let _e491 = (bitcast<i32>(_e80) - ((bitcast<i32>(_e480) - bitcast<i32>(_e482)) + -149i));
                                                                        let _e492 = (_e491 < 0i);
                                                                        if _e492 {
                                                                            phi_1181_ = -(_e491);
                                                                        } else {
                                                                            phi_1181_ = 0i;
                                                                        }
                                                                        let _e495 = phi_1181_;
                                                                        if _e492 {
                                                                            phi_1191_ = 0i;
                                                                        } else {
                                                                            phi_1191_ = select(_e491, 31i, (_e491 > 31i));
                                                                        }
                                                                        let _e499 = phi_1191_;
                                                                        let _e500 = (_e499 & 31i);
                                                                        let _e514 = (bitcast<i32>(_e477) >> bitcast<u32>(31i));
                                                                        if (_e444.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        if (_e465.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        local_5[_e444.member_1][_e465.member_1] = ((bitcast<i32>((((((_e477 & 8388607u) | (_e482 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e495) & 31u))) + ((1u << bitcast<u32>(_e500)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e500))) ^ _e514) - _e514);
                                                                    }
                                                                    continue;
                                                                    continuing {
                                                                        phi_1121_ = _e463;
                                                                        phi_1661_ = _e427;
                                                                        break if !(_e469);
                                                                    }
                                                                }
                                                                let _e524 = phi_1661_;
                                                                phi_1677_ = _e524;
                                                                if _e524 {
                                                                    break;
                                                                }
                                                                phi_1678_ = _e524;
                                                            } else {
                                                                phi_1678_ = _e427;
                                                            }
                                                            let _e526 = phi_1678_;
                                                            continue;
                                                            continuing {
                                                                phi_1666_ = _e526;
                                                                phi_1087_ = _e442;
                                                                phi_1677_ = _e526;
                                                                break if !(_e448);
                                                            }
                                                        }
                                                        let _e529 = phi_1677_;
                                                        phi_1693_ = _e529;
                                                        if _e529 {
                                                            break;
                                                        }
                                                        let _e530 = local_5;
                                                        local_6 = _e530;
                                                        if _e421 {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        let _e533 = global_2.member[_e420].member_1;
                                                        let _e534 = local_10.member_1[0u];
                                                        let _e535 = local_10.member[0u];
                                                        let _e538 = local_10.member_1[1u];
                                                        let _e539 = local_10.member[1u];
                                                        let _e543 = local_10.member_1[2u];
                                                        let _e544 = local_10.member[2u];
                                                        let _e547 = ((bitcast<u32>((_e534 - _e535)) | bitcast<u32>((_e538 - _e539))) | bitcast<u32>((_e543 - _e544)));
                                                        if (_e547 < 1024u) {
                                                            phi_1328_ = 0u;
                                                        } else {
                                                            phi_1328_ = select(2u, 1u, (_e547 < 2097152u));
                                                        }
                                                        let _e552 = phi_1328_;
                                                        switch bitcast<i32>(_e552) {
                                                            case 0: {
                                                                phi_1334_ = 1u;
                                                                break;
                                                            }
                                                            case 1: {
                                                                phi_1334_ = 2u;
                                                                break;
                                                            }
                                                            case 2: {
                                                                phi_1334_ = 3u;
                                                                break;
                                                            }
                                                            default: {
                                                                phi_1334_ = u32();
                                                                break;
                                                            }
                                                        }
                                                        let _e555 = phi_1334_;
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1337_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e557 = phi_1337_;
                                                            if (_e557.member < _e557.member_1) {
                                                                phi_1338_ = type_8((_e557.member + 1u), _e557.member_1);
                                                                phi_1361_ = type_8(1u, _e557.member);
                                                            } else {
                                                                phi_1338_ = _e557;
                                                                phi_1361_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e570 = phi_1338_;
                                                            let _e572 = phi_1361_;
                                                            let _e576 = (bitcast<i32>(_e572.member) != 0i);
                                                            if _e576 {
                                                                if (_e572.member_1 < 3u) {
                                                                } else {
                                                                    phi_1679_ = true;
                                                                    break;
                                                                }
                                                                let _e580 = local_6[_e572.member_1][0u];
                                                                let _e583 = local_6[_e572.member_1][1u];
                                                                let _e586 = local_6[_e572.member_1][2u];
                                                                let _e587 = local_10.member[0u];
                                                                let _e589 = bitcast<u32>((_e580 - _e587));
                                                                let _e590 = local_10.member[1u];
                                                                let _e592 = bitcast<u32>((_e583 - _e590));
                                                                let _e593 = local_10.member[2u];
                                                                let _e595 = bitcast<u32>((_e586 - _e593));
                                                                let _e596 = (_e572.member_1 * _e555);
                                                                switch bitcast<i32>(_e552) {
                                                                    case 0: {
                                                                        let _e632 = (_e596 % 10u);
                                                                        if (_e632 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e632] = ((_e589 | (_e592 << bitcast<u32>(10i))) | (_e595 << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        let _e614 = (_e596 % 10u);
                                                                        if (_e614 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e614] = (_e589 | (_e592 << bitcast<u32>(21i)));
                                                                        let _e623 = ((_e596 + 1u) % 10u);
                                                                        if (_e623 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e623] = ((_e592 >> bitcast<u32>(11i)) | (_e595 << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e598 = (_e596 % 10u);
                                                                        if (_e598 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e598] = bitcast<u32>(_e580);
                                                                        let _e603 = ((_e596 + 1u) % 10u);
                                                                        if (_e603 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e603] = bitcast<u32>(_e583);
                                                                        let _e608 = ((_e596 + 2u) % 10u);
                                                                        if (_e608 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e608] = bitcast<u32>(_e586);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1337_ = _e570;
                                                                phi_1679_ = _e529;
                                                                break if !(_e576);
                                                            }
                                                        }
                                                        let _e638 = phi_1679_;
                                                        phi_1693_ = _e638;
                                                        if _e638 {
                                                            break;
                                                        }
                                                        let _e640 = ((3u * _e555) % 10u);
                                                        if (_e640 < 10u) {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        local_4[_e640] = _e533;
                                                        let _e643 = local_4;
                                                        local_7 = _e643;
                                                        phi_1490_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e645 = phi_1490_;
                                                            if (_e645.member < _e645.member_1) {
                                                                phi_1491_ = type_8((_e645.member + 1u), _e645.member_1);
                                                                phi_1514_ = type_8(1u, _e645.member);
                                                            } else {
                                                                phi_1491_ = _e645;
                                                                phi_1514_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e658 = phi_1491_;
                                                            let _e660 = phi_1514_;
                                                            let _e664 = (bitcast<i32>(_e660.member) != 0i);
                                                            if _e664 {
                                                                if _e422 {
                                                                } else {
                                                                    phi_1687_ = true;
                                                                    break;
                                                                }
                                                                let _e666 = global_6.member[_e420];
                                                                let _e667 = (_e666 + _e660.member_1);
                                                                if (_e660.member_1 < ((3u * _e389) + 1u)) {
                                                                    let _e669 = (_e667 < arrayLength((&global_7.member)));
                                                                    if _e669 {
                                                                        if (_e660.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1687_ = true;
                                                                            break;
                                                                        }
                                                                        let _e672 = local_7[_e660.member_1];
                                                                        if _e669 {
                                                                        } else {
                                                                            phi_1687_ = true;
                                                                            break;
                                                                        }
                                                                        global_7.member[_e667] = _e672;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1490_ = _e658;
                                                                phi_1687_ = _e638;
                                                                break if !(_e664);
                                                            }
                                                        }
                                                        let _e677 = phi_1687_;
                                                        phi_1693_ = _e677;
                                                        if _e677 {
                                                            break;
                                                        }
                                                        phi_1696_ = _e677;
                                                    } else {
                                                        phi_1696_ = _e397;
                                                    }
                                                    let _e679 = phi_1696_;
                                                    phi_1695_ = _e679;
                                                } else {
                                                    phi_1695_ = _e397;
                                                }
                                                let _e681 = phi_1695_;
                                                phi_1694_ = _e681;
                                            } else {
                                                phi_1694_ = _e397;
                                            }
                                            let _e683 = phi_1694_;
                                            continue;
                                            continuing {
                                                phi_1668_ = _e683;
                                                phi_1034_ = _e412;
                                                phi_1693_ = _e683;
                                                break if !(_e418);
                                            }
                                        }
                                        let _e686 = phi_1693_;
                                        phi_1697_ = _e686;
                                        if _e686 {
                                            break;
                                        }
                                        phi_1699_ = _e686;
                                    } else {
                                        phi_1699_ = _e325;
                                    }
                                    let _e688 = phi_1699_;
                                    phi_1698_ = _e688;
                                } else {
                                    phi_1698_ = _e325;
                                }
                                let _e690 = phi_1698_;
                                continue;
                                continuing {
                                    phi_1673_ = _e690;
                                    phi_901_ = _e340;
                                    phi_1697_ = _e690;
                                    break if !(_e346);
                                }
                            }
                            let _e693 = phi_1697_;
                            if _e693 {
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
