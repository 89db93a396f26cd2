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
                        let _e91 = (_e84 < arrayLength((&global_8.member)));
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
                            phi_252_ = type_8(0u, 3u);
                            loop {
                                let _e95 = phi_252_;
                                if (_e95.member < _e95.member_1) {
                                    phi_253_ = type_8((_e95.member + 1u), _e95.member_1);
                                    phi_276_ = type_8(1u, _e95.member);
                                } else {
                                    phi_253_ = _e95;
                                    phi_276_ = type_8(0u, type_8().member_1);
                                }
                                let _e108 = phi_253_;
                                let _e110 = phi_276_;
                                let _e114 = (bitcast<i32>(_e110.member) != 0i);
                                if _e114 {
                                    let _e115 = (_e110.member_1 * 2u);
                                    let _e117 = ((1u + _e115) % 7u);
                                    if (_e117 < 7u) {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e122 = global_8.member[_e84][_e117];
                                    let _e124 = ((_e115 + 2u) % 7u);
                                    if (_e124 < 7u) {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e129 = global_8.member[_e84][_e124];
                                    let _e130 = (_e110.member_1 < 3u);
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e134 = global_5.member[_e84].member[_e110.member_1];
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    let _e138 = global_5.member[_e84].member_1[_e110.member_1];
                                    let _e140 = bitcast<u32>((_e138 - _e134));
                                    let _e146 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e140)), 32u, (_e140 == 0u)));
                                    let _e151 = ((select(21u, _e146, (_e146 > 21u)) - 21u) & 31u);
                                    let _e155 = (_e134 + bitcast<i32>(((_e122 & 2097151u) << bitcast<u32>(_e151))));
                                    let _e160 = (_e138 - bitcast<i32>(((_e129 & 2097151u) << bitcast<u32>(_e151))));
                                    let _e164 = (((_e122 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e168 = (((_e129 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_3[_e110.member_1] = select(_e134, _e155, _e164);
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_1[_e110.member_1] = select(_e155, _e134, _e164);
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local_2[_e110.member_1] = select(_e138, _e160, _e168);
                                    if _e130 {
                                    } else {
                                        phi_1606_ = true;
                                        break;
                                    }
                                    local[_e110.member_1] = select(_e160, _e138, _e168);
                                }
                                continue;
                                continuing {
                                    phi_252_ = _e108;
                                    phi_1606_ = false;
                                    break if !(_e114);
                                }
                            }
                            let _e179 = phi_1606_;
                            if _e179 {
                                break;
                            }
                            let _e180 = local;
                            let _e181 = local_1;
                            let _e182 = local_2;
                            let _e183 = local_3;
                            if _e91 {
                            } else {
                                break;
                            }
                            let _e184 = global_8.member[_e84];
                            if _e89 {
                            } else {
                                break;
                            }
                            let _e187 = global_3.member[_e84].member_1;
                            let _e190 = global_3.member[_e84].member_2;
                            let _e192 = ((_e187 & 2147483648u) != 0u);
                            if _e192 {
                                let _e196 = (((_e187 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e196 {
                                    phi_506_ = (_e187 & 268435455u);
                                } else {
                                    phi_506_ = u32();
                                }
                                let _e199 = phi_506_;
                                phi_508_ = _e199;
                                phi_509_ = select(true, false, _e196);
                            } else {
                                phi_508_ = u32();
                                phi_509_ = true;
                            }
                            let _e202 = phi_508_;
                            let _e204 = phi_509_;
                            if _e204 {
                                if ((_e190 & 2147483648u) != 0u) {
                                    let _e210 = (((_e190 >> bitcast<u32>(28u)) & 7u) > 0u);
                                    if _e210 {
                                        phi_525_ = (_e190 & 268435455u);
                                    } else {
                                        phi_525_ = u32();
                                    }
                                    let _e213 = phi_525_;
                                    phi_527_ = _e213;
                                    phi_528_ = select(true, false, _e210);
                                } else {
                                    phi_527_ = u32();
                                    phi_528_ = true;
                                }
                                let _e216 = phi_527_;
                                let _e218 = phi_528_;
                                phi_533_ = select(_e216, 0u, _e218);
                            } else {
                                phi_533_ = _e202;
                            }
                            let _e221 = phi_533_;
                            let _e222 = (_e221 < _e71);
                            if _e222 {
                                if _e222 {
                                } else {
                                    break;
                                }
                                let _e224 = global_6.member[_e221];
                                phi_545_ = _e224;
                            } else {
                                phi_545_ = 0u;
                            }
                            let _e226 = phi_545_;
                            if _e192 {
                                phi_561_ = select(_e190, 0u, ((_e190 & 2147483648u) != 0u));
                            } else {
                                phi_561_ = _e187;
                            }
                            let _e231 = phi_561_;
                            if _e192 {
                                let _e234 = ((_e187 >> bitcast<u32>(28u)) & 7u);
                                phi_576_ = select(_e234, 7u, (_e234 == 0u));
                            } else {
                                phi_576_ = 0u;
                            }
                            let _e238 = phi_576_;
                            if ((_e190 & 2147483648u) != 0u) {
                                let _e243 = ((_e190 >> bitcast<u32>(28u)) & 7u);
                                phi_591_ = select(_e243, 7u, (_e243 == 0u));
                            } else {
                                phi_591_ = 0u;
                            }
                            let _e247 = phi_591_;
                            local_8 = array<u32, 7>(_e184[0], _e184[1], _e184[2], _e184[3], _e184[4], _e184[5], _e184[6]);
                            local_8[0u] = (((_e231 & 268435455u) | (_e238 << bitcast<u32>(28u))) | (_e247 << bitcast<u32>(31i)));
                            phi_693_ = type_8(0u, 3u);
                            loop {
                                let _e271 = phi_693_;
                                if (_e271.member < _e271.member_1) {
                                    phi_694_ = type_8((_e271.member + 1u), _e271.member_1);
                                    phi_717_ = type_8(1u, _e271.member);
                                } else {
                                    phi_694_ = _e271;
                                    phi_717_ = type_8(0u, type_8().member_1);
                                }
                                let _e284 = phi_694_;
                                let _e286 = phi_717_;
                                let _e290 = (bitcast<i32>(_e286.member) != 0i);
                                if _e290 {
                                    let _e299 = (((_e286.member_1 + 1u) * 2u) % 7u);
                                    if (_e299 < 7u) {
                                    } else {
                                        phi_1623_ = true;
                                        break;
                                    }
                                    let _e302 = local_8[_e299];
                                    local_8[_e299] = (_e302 | ((((_e226 & 268435455u) | ((_e247 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e286.member_1) & 31u))) << bitcast<u32>(22i)));
                                }
                                continue;
                                continuing {
                                    phi_693_ = _e284;
                                    phi_1623_ = _e179;
                                    break if !(_e290);
                                }
                            }
                            let _e306 = phi_1623_;
                            if _e306 {
                                break;
                            }
                            let _e307 = local_8;
                            if _e91 {
                            } else {
                                break;
                            }
                            global_8.member[_e84] = array<u32, 7>(_e307[0], _e307[1], _e307[2], _e307[3], _e307[4], _e307[5], _e307[6]);
                            if _e89 {
                            } else {
                                break;
                            }
                            if _e89 {
                            } else {
                                break;
                            }
                            local_9[0u] = type_54(_e187, type_36(_e183, _e182));
                            local_9[1u] = type_54(_e190, type_36(_e181, _e180));
                            phi_1673_ = _e306;
                            phi_901_ = type_8(0u, 2u);
                            loop {
                                let _e323 = phi_1673_;
                                let _e325 = phi_901_;
                                if (_e325.member < _e325.member_1) {
                                    phi_902_ = type_8((_e325.member + 1u), _e325.member_1);
                                    phi_927_ = type_8(1u, _e325.member);
                                } else {
                                    phi_902_ = _e325;
                                    phi_927_ = type_8(0u, type_8().member_1);
                                }
                                let _e338 = phi_902_;
                                let _e340 = phi_927_;
                                let _e344 = (bitcast<i32>(_e340.member) != 0i);
                                if _e344 {
                                    if (_e340.member_1 < 2u) {
                                    } else {
                                        phi_1697_ = true;
                                        break;
                                    }
                                    let _e348 = local_9[_e340.member_1].member;
                                    let _e351 = local_9[_e340.member_1].member_1;
                                    local_10 = _e351;
                                    if ((_e348 & 2147483648u) != 0u) {
                                        let _e356 = local_10.member_1[0u];
                                        let _e359 = local_10.member[0u];
                                        let _e364 = local_10.member_1[1u];
                                        let _e367 = local_10.member[1u];
                                        let _e373 = local_10.member_1[2u];
                                        let _e376 = local_10.member[2u];
                                        let _e379 = ((bitcast<u32>((_e356 - _e359)) | bitcast<u32>((_e364 - _e367))) | bitcast<u32>((_e373 - _e376)));
                                        if (_e379 < 1024u) {
                                            phi_1021_ = 0u;
                                        } else {
                                            phi_1021_ = select(2u, 1u, (_e379 < 2097152u));
                                        }
                                        let _e384 = phi_1021_;
                                        switch bitcast<i32>(_e384) {
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
                                        let _e387 = phi_1027_;
                                        phi_1668_ = _e323;
                                        phi_1034_ = type_8(0u, ((_e348 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e395 = phi_1668_;
                                            let _e397 = phi_1034_;
                                            if (_e397.member < _e397.member_1) {
                                                phi_1035_ = type_8((_e397.member + 1u), _e397.member_1);
                                                phi_1058_ = type_8(1u, _e397.member);
                                            } else {
                                                phi_1035_ = _e397;
                                                phi_1058_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e410 = phi_1035_;
                                            let _e412 = phi_1058_;
                                            let _e416 = (bitcast<i32>(_e412.member) != 0i);
                                            if _e416 {
                                                let _e418 = ((_e348 & 268435455u) + _e412.member_1);
                                                let _e419 = (_e418 < arrayLength((&global_2.member)));
                                                if _e419 {
                                                    let _e420 = (_e418 < _e71);
                                                    if _e420 {
                                                        if _e419 {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        local_5[0u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[1u] = array<i32, 3>(0i, 0i, 0i);
                                                        local_5[2u] = array<i32, 3>(0i, 0i, 0i);
                                                        phi_1666_ = _e395;
                                                        phi_1087_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e425 = phi_1666_;
                                                            let _e427 = phi_1087_;
                                                            if (_e427.member < _e427.member_1) {
                                                                phi_1088_ = type_8((_e427.member + 1u), _e427.member_1);
                                                                phi_1111_ = type_8(1u, _e427.member);
                                                            } else {
                                                                phi_1088_ = _e427;
                                                                phi_1111_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e440 = phi_1088_;
                                                            let _e442 = phi_1111_;
                                                            let _e446 = (bitcast<i32>(_e442.member) != 0i);
                                                            if _e446 {
                                                                phi_1121_ = type_8(0u, 3u);
                                                                loop {
                                                                    let _e448 = phi_1121_;
                                                                    if (_e448.member < _e448.member_1) {
                                                                        phi_1122_ = type_8((_e448.member + 1u), _e448.member_1);
                                                                        phi_1145_ = type_8(1u, _e448.member);
                                                                    } else {
                                                                        phi_1122_ = _e448;
                                                                        phi_1145_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e461 = phi_1122_;
                                                                    let _e463 = phi_1145_;
                                                                    let _e467 = (bitcast<i32>(_e463.member) != 0i);
                                                                    if _e467 {
                                                                        let _e469 = ((3u * _e442.member_1) + _e463.member_1);
                                                                        if (_e469 < 9u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        let _e474 = global_2.member[_e418].member[_e469];
                                                                        let _e475 = bitcast<u32>(_e474);
                                                                        let _e478 = ((_e475 >> bitcast<u32>(23i)) & 255u);
                                                                        let _e480 = select(0u, 1u, (_e478 != 0u));
                                                                        let _e489 = (bitcast<i32>(_e79) - ((bitcast<i32>(_e478) - bitcast<i32>(_e480)) + -149i));
                                                                        let _e490 = (_e489 < 0i);
                                                                        if _e490 {
                                                                            phi_1181_ = -(_e489);
                                                                        } else {
                                                                            phi_1181_ = 0i;
                                                                        }
                                                                        let _e493 = phi_1181_;
                                                                        if _e490 {
                                                                            phi_1191_ = 0i;
                                                                        } else {
                                                                            phi_1191_ = select(_e489, 31i, (_e489 > 31i));
                                                                        }
                                                                        let _e497 = phi_1191_;
                                                                        let _e498 = (_e497 & 31i);
                                                                        let _e512 = (bitcast<i32>(_e475) >> bitcast<u32>(31i));
                                                                        if (_e442.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        if (_e463.member_1 < 3u) {
                                                                        } else {
                                                                            phi_1661_ = true;
                                                                            break;
                                                                        }
                                                                        local_5[_e442.member_1][_e463.member_1] = ((bitcast<i32>((((((_e475 & 8388607u) | (_e480 << bitcast<u32>(23i))) << bitcast<u32>((bitcast<u32>(_e493) & 31u))) + ((1u << bitcast<u32>(_e498)) >> bitcast<u32>(1i))) >> bitcast<u32>(_e498))) ^ _e512) - _e512);
                                                                    }
                                                                    continue;
                                                                    continuing {
                                                                        phi_1121_ = _e461;
                                                                        phi_1661_ = _e425;
                                                                        break if !(_e467);
                                                                    }
                                                                }
                                                                let _e522 = phi_1661_;
                                                                phi_1677_ = _e522;
                                                                if _e522 {
                                                                    break;
                                                                }
                                                                phi_1678_ = _e522;
                                                            } else {
                                                                phi_1678_ = _e425;
                                                            }
                                                            let _e524 = phi_1678_;
                                                            continue;
                                                            continuing {
                                                                phi_1666_ = _e524;
                                                                phi_1087_ = _e440;
                                                                phi_1677_ = _e524;
                                                                break if !(_e446);
                                                            }
                                                        }
                                                        let _e527 = phi_1677_;
                                                        phi_1693_ = _e527;
                                                        if _e527 {
                                                            break;
                                                        }
                                                        let _e528 = local_5;
                                                        local_6 = _e528;
                                                        if _e419 {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        let _e531 = global_2.member[_e418].member_1;
                                                        let _e532 = local_10.member_1[0u];
                                                        let _e533 = local_10.member[0u];
                                                        let _e536 = local_10.member_1[1u];
                                                        let _e537 = local_10.member[1u];
                                                        let _e541 = local_10.member_1[2u];
                                                        let _e542 = local_10.member[2u];
                                                        let _e545 = ((bitcast<u32>((_e532 - _e533)) | bitcast<u32>((_e536 - _e537))) | bitcast<u32>((_e541 - _e542)));
                                                        if (_e545 < 1024u) {
                                                            phi_1328_ = 0u;
                                                        } else {
                                                            phi_1328_ = select(2u, 1u, (_e545 < 2097152u));
                                                        }
                                                        let _e550 = phi_1328_;
                                                        switch bitcast<i32>(_e550) {
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
                                                        let _e553 = phi_1334_;
                                                        local_4 = array<u32, 10>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_1337_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e555 = phi_1337_;
                                                            if (_e555.member < _e555.member_1) {
                                                                phi_1338_ = type_8((_e555.member + 1u), _e555.member_1);
                                                                phi_1361_ = type_8(1u, _e555.member);
                                                            } else {
                                                                phi_1338_ = _e555;
                                                                phi_1361_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e568 = phi_1338_;
                                                            let _e570 = phi_1361_;
                                                            let _e574 = (bitcast<i32>(_e570.member) != 0i);
                                                            if _e574 {
                                                                if (_e570.member_1 < 3u) {
                                                                } else {
                                                                    phi_1679_ = true;
                                                                    break;
                                                                }
                                                                let _e578 = local_6[_e570.member_1][0u];
                                                                let _e581 = local_6[_e570.member_1][1u];
                                                                let _e584 = local_6[_e570.member_1][2u];
                                                                let _e585 = local_10.member[0u];
                                                                let _e587 = bitcast<u32>((_e578 - _e585));
                                                                let _e588 = local_10.member[1u];
                                                                let _e590 = bitcast<u32>((_e581 - _e588));
                                                                let _e591 = local_10.member[2u];
                                                                let _e593 = bitcast<u32>((_e584 - _e591));
                                                                let _e594 = (_e570.member_1 * _e553);
                                                                switch bitcast<i32>(_e550) {
                                                                    case 0: {
                                                                        let _e630 = (_e594 % 10u);
                                                                        if (_e630 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e630] = ((_e587 | (_e590 << bitcast<u32>(10i))) | (_e593 << bitcast<u32>(20i)));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        let _e612 = (_e594 % 10u);
                                                                        if (_e612 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e612] = (_e587 | (_e590 << bitcast<u32>(21i)));
                                                                        let _e621 = ((_e594 + 1u) % 10u);
                                                                        if (_e621 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e621] = ((_e590 >> bitcast<u32>(11i)) | (_e593 << bitcast<u32>(10i)));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e596 = (_e594 % 10u);
                                                                        if (_e596 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e596] = bitcast<u32>(_e578);
                                                                        let _e601 = ((_e594 + 1u) % 10u);
                                                                        if (_e601 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e601] = bitcast<u32>(_e581);
                                                                        let _e606 = ((_e594 + 2u) % 10u);
                                                                        if (_e606 < 10u) {
                                                                        } else {
                                                                            phi_1679_ = true;
                                                                            break;
                                                                        }
                                                                        local_4[_e606] = bitcast<u32>(_e584);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        break;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1337_ = _e568;
                                                                phi_1679_ = _e527;
                                                                break if !(_e574);
                                                            }
                                                        }
                                                        let _e636 = phi_1679_;
                                                        phi_1693_ = _e636;
                                                        if _e636 {
                                                            break;
                                                        }
                                                        let _e638 = ((3u * _e553) % 10u);
                                                        if (_e638 < 10u) {
                                                        } else {
                                                            phi_1693_ = true;
                                                            break;
                                                        }
                                                        local_4[_e638] = _e531;
                                                        let _e641 = local_4;
                                                        local_7 = _e641;
                                                        phi_1490_ = type_8(0u, 10u);
                                                        loop {
                                                            let _e643 = phi_1490_;
                                                            if (_e643.member < _e643.member_1) {
                                                                phi_1491_ = type_8((_e643.member + 1u), _e643.member_1);
                                                                phi_1514_ = type_8(1u, _e643.member);
                                                            } else {
                                                                phi_1491_ = _e643;
                                                                phi_1514_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e656 = phi_1491_;
                                                            let _e658 = phi_1514_;
                                                            let _e662 = (bitcast<i32>(_e658.member) != 0i);
                                                            if _e662 {
                                                                if _e420 {
                                                                } else {
                                                                    phi_1687_ = true;
                                                                    break;
                                                                }
                                                                let _e664 = global_6.member[_e418];
                                                                let _e665 = (_e664 + _e658.member_1);
                                                                if (_e658.member_1 < ((3u * _e387) + 1u)) {
                                                                    let _e667 = (_e665 < arrayLength((&global_7.member)));
                                                                    if _e667 {
                                                                        if (_e658.member_1 < 10u) {
                                                                        } else {
                                                                            phi_1687_ = true;
                                                                            break;
                                                                        }
                                                                        let _e670 = local_7[_e658.member_1];
                                                                        if _e667 {
                                                                        } else {
                                                                            phi_1687_ = true;
                                                                            break;
                                                                        }
                                                                        global_7.member[_e665] = _e670;
                                                                    }
                                                                }
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1490_ = _e656;
                                                                phi_1687_ = _e636;
                                                                break if !(_e662);
                                                            }
                                                        }
                                                        let _e675 = phi_1687_;
                                                        phi_1693_ = _e675;
                                                        if _e675 {
                                                            break;
                                                        }
                                                        phi_1696_ = _e675;
                                                    } else {
                                                        phi_1696_ = _e395;
                                                    }
                                                    let _e677 = phi_1696_;
                                                    phi_1695_ = _e677;
                                                } else {
                                                    phi_1695_ = _e395;
                                                }
                                                let _e679 = phi_1695_;
                                                phi_1694_ = _e679;
                                            } else {
                                                phi_1694_ = _e395;
                                            }
                                            let _e681 = phi_1694_;
                                            continue;
                                            continuing {
                                                phi_1668_ = _e681;
                                                phi_1034_ = _e410;
                                                phi_1693_ = _e681;
                                                break if !(_e416);
                                            }
                                        }
                                        let _e684 = phi_1693_;
                                        phi_1697_ = _e684;
                                        if _e684 {
                                            break;
                                        }
                                        phi_1699_ = _e684;
                                    } else {
                                        phi_1699_ = _e323;
                                    }
                                    let _e686 = phi_1699_;
                                    phi_1698_ = _e686;
                                } else {
                                    phi_1698_ = _e323;
                                }
                                let _e688 = phi_1698_;
                                continue;
                                continuing {
                                    phi_1673_ = _e688;
                                    phi_901_ = _e338;
                                    phi_1697_ = _e688;
                                    break if !(_e344);
                                }
                            }
                            let _e691 = phi_1697_;
                            if _e691 {
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
