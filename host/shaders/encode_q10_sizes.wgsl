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

struct type_25 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_30 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_31 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_44 {
    member: array<type_38>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_16;
@group(0) @binding(2) 
var<uniform> global_3: type_16;
@group(0) @binding(3) 
var<storage> global_4: type_27;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_13;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_44;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_33;

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
    var local_16: array<i32, 3>;
    var local_17: array<i32, 3>;
    var local_18: array<i32, 3>;
    var local_19: array<i32, 3>;
    var local_20: array<u32, 4>;
    var local_21: array<u32, 4>;
    var phi_182_: i32;
    var phi_228_: type_25;
    var phi_246_: type_30;
    var phi_264_: type_30;
    var phi_330_: i32;
    var phi_340_: i32;
    var phi_387_: i32;
    var phi_397_: i32;
    var phi_444_: i32;
    var phi_454_: i32;
    var phi_503_: i32;
    var phi_513_: i32;
    var phi_562_: i32;
    var phi_572_: i32;
    var phi_621_: i32;
    var phi_631_: i32;
    var phi_3745_: bool;
    var phi_675_: type_8;
    var phi_678_: u32;
    var phi_676_: type_8;
    var phi_701_: type_8;
    var phi_723_: type_25;
    var phi_731_: bool;
    var phi_749_: type_30;
    var phi_767_: type_30;
    var phi_794_: i32;
    var phi_804_: i32;
    var phi_851_: i32;
    var phi_861_: i32;
    var phi_908_: i32;
    var phi_918_: i32;
    var phi_967_: i32;
    var phi_977_: i32;
    var phi_1026_: i32;
    var phi_1036_: i32;
    var phi_1085_: i32;
    var phi_1095_: i32;
    var phi_1162_: i32;
    var phi_1172_: i32;
    var phi_1219_: i32;
    var phi_1229_: i32;
    var phi_1276_: i32;
    var phi_1286_: i32;
    var phi_1335_: i32;
    var phi_1345_: i32;
    var phi_1394_: i32;
    var phi_1404_: i32;
    var phi_1453_: i32;
    var phi_1463_: i32;
    var phi_1507_: type_8;
    var phi_1508_: type_8;
    var phi_1531_: type_8;
    var phi_3700_: bool;
    var phi_1705_: type_8;
    var phi_1706_: type_8;
    var phi_1729_: type_8;
    var phi_3785_: bool;
    var phi_1934_: type_38;
    var phi_3804_: bool;
    var phi_1952_: u32;
    var phi_3803_: bool;
    var phi_679_: u32;
    var phi_1954_: bool;
    var phi_3802_: bool;
    var phi_2005_: type_30;
    var phi_2027_: type_30;
    var phi_2054_: i32;
    var phi_2064_: i32;
    var phi_2111_: i32;
    var phi_2121_: i32;
    var phi_2168_: i32;
    var phi_2178_: i32;
    var phi_2227_: i32;
    var phi_2237_: i32;
    var phi_2286_: i32;
    var phi_2296_: i32;
    var phi_2345_: i32;
    var phi_2355_: i32;
    var phi_2422_: i32;
    var phi_2432_: i32;
    var phi_2479_: i32;
    var phi_2489_: i32;
    var phi_2536_: i32;
    var phi_2546_: i32;
    var phi_2595_: i32;
    var phi_2605_: i32;
    var phi_2654_: i32;
    var phi_2664_: i32;
    var phi_2713_: i32;
    var phi_2723_: i32;
    var phi_2767_: type_8;
    var phi_2768_: type_8;
    var phi_2791_: type_8;
    var phi_3807_: bool;
    var phi_2965_: type_8;
    var phi_2966_: type_8;
    var phi_2989_: type_8;
    var phi_3859_: bool;
    var phi_3335_: u32;
    var phi_3341_: u32;
    var phi_3348_: type_8;
    var phi_3349_: type_8;
    var phi_3372_: type_8;
    var phi_3876_: bool;
    var phi_3891_: bool;
    var phi_3468_: u32;
    var phi_3474_: u32;
    var phi_3481_: type_8;
    var phi_3482_: type_8;
    var phi_3505_: type_8;
    var phi_3884_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_4.member));
            let _e82 = arrayLength((&global_7.member));
            let _e85 = arrayLength((&global_8.member));
            let _e88 = global_3.member[0u];
            let _e92 = global_2.member[0u];
            let _e94 = (bitcast<i32>(_e88) + bitcast<i32>(_e92));
            if (_e94 < -126i) {
                phi_182_ = -126i;
            } else {
                phi_182_ = select(_e94, 127i, (_e94 > 127i));
            }
            let _e99 = phi_182_;
            let _e103 = (_e72.x + (_e72.y * 2097152u));
            let _e106 = global_1.member[0u];
            if (_e103 < _e106) {
                let _e108 = (_e103 < _e74);
                if _e108 {
                    let _e109 = (_e103 < arrayLength((&global_5.member)));
                    if _e109 {
                        let _e110 = (_e103 < arrayLength((&global_6.member)));
                        if _e110 {
                            let _e111 = (0u < _e74);
                            if _e111 {
                                if _e111 {
                                } else {
                                    break;
                                }
                                let _e114 = global_4.member[0u];
                                phi_228_ = _e114;
                            } else {
                                phi_228_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e116 = phi_228_;
                            if (_e116.member_1 == 2147483648u) {
                                phi_246_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_246_ = type_30(vec3<f32>(_e116.member[0][0], _e116.member[1][0], _e116.member[2][0]), vec3<f32>(_e116.member[0][2], _e116.member[1][2], _e116.member[2][2]));
                            }
                            let _e135 = phi_246_;
                            if (_e116.member_2 == 2147483648u) {
                                phi_264_ = _e135;
                            } else {
                                phi_264_ = type_30(vec3<f32>(_e116.member[0][1], _e116.member[1][1], _e116.member[2][1]), vec3<f32>(_e116.member[0][3], _e116.member[1][3], _e116.member[2][3]));
                            }
                            let _e154 = phi_264_;
                            let _e183 = bitcast<u32>(select(_e154.member.x, _e135.member.x, (_e135.member.x < _e154.member.x)));
                            let _e186 = ((_e183 >> bitcast<u32>(23i)) & 255u);
                            let _e188 = select(0u, 1u, (_e186 != 0u));
                            let _e192 = ((_e183 & 8388607u) | (_e188 << bitcast<u32>(23i)));
                            let _e197 = (_e99 - ((bitcast<i32>(_e186) - bitcast<i32>(_e188)) + -149i));
                            let _e198 = (_e197 < 0i);
                            if _e198 {
                                phi_330_ = -(_e197);
                            } else {
                                phi_330_ = 0i;
                            }
                            let _e201 = phi_330_;
                            if _e198 {
                                phi_340_ = 0i;
                            } else {
                                phi_340_ = select(_e197, 31i, (_e197 > 31i));
                            }
                            let _e205 = phi_340_;
                            let _e210 = (_e205 & 31i);
                            let _e220 = (bitcast<i32>(_e183) >> bitcast<u32>(31i));
                            let _e228 = bitcast<u32>(select(_e154.member.y, _e135.member.y, (_e135.member.y < _e154.member.y)));
                            let _e231 = ((_e228 >> bitcast<u32>(23i)) & 255u);
                            let _e233 = select(0u, 1u, (_e231 != 0u));
                            let _e237 = ((_e228 & 8388607u) | (_e233 << bitcast<u32>(23i)));
                            let _e242 = (_e99 - ((bitcast<i32>(_e231) - bitcast<i32>(_e233)) + -149i));
                            let _e243 = (_e242 < 0i);
                            if _e243 {
                                phi_387_ = -(_e242);
                            } else {
                                phi_387_ = 0i;
                            }
                            let _e246 = phi_387_;
                            if _e243 {
                                phi_397_ = 0i;
                            } else {
                                phi_397_ = select(_e242, 31i, (_e242 > 31i));
                            }
                            let _e250 = phi_397_;
                            let _e255 = (_e250 & 31i);
                            let _e265 = (bitcast<i32>(_e228) >> bitcast<u32>(31i));
                            let _e273 = bitcast<u32>(select(_e154.member.z, _e135.member.z, (_e135.member.z < _e154.member.z)));
                            let _e276 = ((_e273 >> bitcast<u32>(23i)) & 255u);
                            let _e278 = select(0u, 1u, (_e276 != 0u));
                            let _e282 = ((_e273 & 8388607u) | (_e278 << bitcast<u32>(23i)));
                            let _e287 = (_e99 - ((bitcast<i32>(_e276) - bitcast<i32>(_e278)) + -149i));
                            let _e288 = (_e287 < 0i);
                            if _e288 {
                                phi_444_ = -(_e287);
                            } else {
                                phi_444_ = 0i;
                            }
                            let _e291 = phi_444_;
                            if _e288 {
                                phi_454_ = 0i;
                            } else {
                                phi_454_ = select(_e287, 31i, (_e287 > 31i));
                            }
                            let _e295 = phi_454_;
                            let _e300 = (_e295 & 31i);
                            let _e310 = (bitcast<i32>(_e273) >> bitcast<u32>(31i));
                            let _e319 = bitcast<u32>(-(select(_e154.member_1.x, _e135.member_1.x, (_e135.member_1.x > _e154.member_1.x))));
                            let _e322 = ((_e319 >> bitcast<u32>(23i)) & 255u);
                            let _e324 = select(0u, 1u, (_e322 != 0u));
                            let _e328 = ((_e319 & 8388607u) | (_e324 << bitcast<u32>(23i)));
                            let _e333 = (_e99 - ((bitcast<i32>(_e322) - bitcast<i32>(_e324)) + -149i));
                            let _e334 = (_e333 < 0i);
                            if _e334 {
                                phi_503_ = -(_e333);
                            } else {
                                phi_503_ = 0i;
                            }
                            let _e337 = phi_503_;
                            if _e334 {
                                phi_513_ = 0i;
                            } else {
                                phi_513_ = select(_e333, 31i, (_e333 > 31i));
                            }
                            let _e341 = phi_513_;
                            let _e346 = (_e341 & 31i);
                            let _e356 = (bitcast<i32>(_e319) >> bitcast<u32>(31i));
                            let _e366 = bitcast<u32>(-(select(_e154.member_1.y, _e135.member_1.y, (_e135.member_1.y > _e154.member_1.y))));
                            let _e369 = ((_e366 >> bitcast<u32>(23i)) & 255u);
                            let _e371 = select(0u, 1u, (_e369 != 0u));
                            let _e375 = ((_e366 & 8388607u) | (_e371 << bitcast<u32>(23i)));
                            let _e380 = (_e99 - ((bitcast<i32>(_e369) - bitcast<i32>(_e371)) + -149i));
                            let _e381 = (_e380 < 0i);
                            if _e381 {
                                phi_562_ = -(_e380);
                            } else {
                                phi_562_ = 0i;
                            }
                            let _e384 = phi_562_;
                            if _e381 {
                                phi_572_ = 0i;
                            } else {
                                phi_572_ = select(_e380, 31i, (_e380 > 31i));
                            }
                            let _e388 = phi_572_;
                            let _e393 = (_e388 & 31i);
                            let _e403 = (bitcast<i32>(_e366) >> bitcast<u32>(31i));
                            let _e413 = bitcast<u32>(-(select(_e154.member_1.z, _e135.member_1.z, (_e135.member_1.z > _e154.member_1.z))));
                            let _e416 = ((_e413 >> bitcast<u32>(23i)) & 255u);
                            let _e418 = select(0u, 1u, (_e416 != 0u));
                            let _e422 = ((_e413 & 8388607u) | (_e418 << bitcast<u32>(23i)));
                            let _e427 = (_e99 - ((bitcast<i32>(_e416) - bitcast<i32>(_e418)) + -149i));
                            let _e428 = (_e427 < 0i);
                            if _e428 {
                                phi_621_ = -(_e427);
                            } else {
                                phi_621_ = 0i;
                            }
                            let _e431 = phi_621_;
                            if _e428 {
                                phi_631_ = 0i;
                            } else {
                                phi_631_ = select(_e427, 31i, (_e427 > 31i));
                            }
                            let _e435 = phi_631_;
                            let _e440 = (_e435 & 31i);
                            let _e450 = (bitcast<i32>(_e413) >> bitcast<u32>(31i));
                            local_11 = array<i32, 3>((((bitcast<i32>(((_e192 << bitcast<u32>((bitcast<u32>(_e201) & 31u))) >> bitcast<u32>(_e210))) + select(0i, 1i, (((_e192 & ((1u << bitcast<u32>(_e210)) - 1u)) != 0u) && (_e220 != 0i)))) ^ _e220) - _e220), (((bitcast<i32>(((_e237 << bitcast<u32>((bitcast<u32>(_e246) & 31u))) >> bitcast<u32>(_e255))) + select(0i, 1i, (((_e237 & ((1u << bitcast<u32>(_e255)) - 1u)) != 0u) && (_e265 != 0i)))) ^ _e265) - _e265), (((bitcast<i32>(((_e282 << bitcast<u32>((bitcast<u32>(_e291) & 31u))) >> bitcast<u32>(_e300))) + select(0i, 1i, (((_e282 & ((1u << bitcast<u32>(_e300)) - 1u)) != 0u) && (_e310 != 0i)))) ^ _e310) - _e310));
                            local_10 = array<i32, 3>(-((((bitcast<i32>(((_e328 << bitcast<u32>((bitcast<u32>(_e337) & 31u))) >> bitcast<u32>(_e346))) + select(0i, 1i, (((_e328 & ((1u << bitcast<u32>(_e346)) - 1u)) != 0u) && (_e356 != 0i)))) ^ _e356) - _e356)), -((((bitcast<i32>(((_e375 << bitcast<u32>((bitcast<u32>(_e384) & 31u))) >> bitcast<u32>(_e393))) + select(0i, 1i, (((_e375 & ((1u << bitcast<u32>(_e393)) - 1u)) != 0u) && (_e403 != 0i)))) ^ _e403) - _e403)), -((((bitcast<i32>(((_e422 << bitcast<u32>((bitcast<u32>(_e431) & 31u))) >> bitcast<u32>(_e440))) + select(0i, 1i, (((_e422 & ((1u << bitcast<u32>(_e440)) - 1u)) != 0u) && (_e450 != 0i)))) ^ _e450) - _e450)));
                            phi_3745_ = false;
                            phi_675_ = type_8(0u, 128u);
                            phi_678_ = 0u;
                            loop {
                                let _e462 = phi_3745_;
                                let _e464 = phi_675_;
                                let _e466 = phi_678_;
                                if (_e464.member < _e464.member_1) {
                                    phi_676_ = type_8((_e464.member + 1u), _e464.member_1);
                                    phi_701_ = type_8(1u, _e464.member);
                                } else {
                                    phi_676_ = _e464;
                                    phi_701_ = type_8(0u, type_8().member_1);
                                }
                                let _e479 = phi_676_;
                                let _e481 = phi_701_;
                                if (bitcast<i32>(_e481.member) != 0i) {
                                    let _e485 = (_e466 == _e103);
                                    if _e485 {
                                        phi_3804_ = _e462;
                                        phi_1952_ = u32();
                                    } else {
                                        let _e486 = (_e466 < _e74);
                                        if _e486 {
                                            if _e486 {
                                            } else {
                                                phi_3802_ = true;
                                                break;
                                            }
                                            let _e489 = global_4.member[_e466];
                                            phi_723_ = _e489;
                                        } else {
                                            phi_723_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e491 = phi_723_;
                                        if ((_e491.member_1 & 2147483648u) != 0u) {
                                            phi_731_ = false;
                                        } else {
                                            phi_731_ = (_e103 <= _e491.member_1);
                                        }
                                        let _e497 = phi_731_;
                                        if (_e491.member_1 == 2147483648u) {
                                            phi_749_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_749_ = type_30(vec3<f32>(_e491.member[0][0], _e491.member[1][0], _e491.member[2][0]), vec3<f32>(_e491.member[0][2], _e491.member[1][2], _e491.member[2][2]));
                                        }
                                        let _e515 = phi_749_;
                                        if (_e491.member_2 == 2147483648u) {
                                            phi_767_ = _e515;
                                        } else {
                                            phi_767_ = type_30(vec3<f32>(_e491.member[0][1], _e491.member[1][1], _e491.member[2][1]), vec3<f32>(_e491.member[0][3], _e491.member[1][3], _e491.member[2][3]));
                                        }
                                        let _e534 = phi_767_;
                                        let _e547 = bitcast<u32>(_e515.member.x);
                                        let _e550 = ((_e547 >> bitcast<u32>(23i)) & 255u);
                                        let _e552 = select(0u, 1u, (_e550 != 0u));
                                        let _e556 = ((_e547 & 8388607u) | (_e552 << bitcast<u32>(23i)));
                                        let _e561 = (_e99 - ((bitcast<i32>(_e550) - bitcast<i32>(_e552)) + -149i));
                                        let _e562 = (_e561 < 0i);
                                        if _e562 {
                                            phi_794_ = -(_e561);
                                        } else {
                                            phi_794_ = 0i;
                                        }
                                        let _e565 = phi_794_;
                                        if _e562 {
                                            phi_804_ = 0i;
                                        } else {
                                            phi_804_ = select(_e561, 31i, (_e561 > 31i));
                                        }
                                        let _e569 = phi_804_;
                                        let _e574 = (_e569 & 31i);
                                        let _e584 = (bitcast<i32>(_e547) >> bitcast<u32>(31i));
                                        let _e592 = bitcast<u32>(_e515.member.y);
                                        let _e595 = ((_e592 >> bitcast<u32>(23i)) & 255u);
                                        let _e597 = select(0u, 1u, (_e595 != 0u));
                                        let _e601 = ((_e592 & 8388607u) | (_e597 << bitcast<u32>(23i)));
                                        let _e606 = (_e99 - ((bitcast<i32>(_e595) - bitcast<i32>(_e597)) + -149i));
                                        let _e607 = (_e606 < 0i);
                                        if _e607 {
                                            phi_851_ = -(_e606);
                                        } else {
                                            phi_851_ = 0i;
                                        }
                                        let _e610 = phi_851_;
                                        if _e607 {
                                            phi_861_ = 0i;
                                        } else {
                                            phi_861_ = select(_e606, 31i, (_e606 > 31i));
                                        }
                                        let _e614 = phi_861_;
                                        let _e619 = (_e614 & 31i);
                                        let _e629 = (bitcast<i32>(_e592) >> bitcast<u32>(31i));
                                        let _e637 = bitcast<u32>(_e515.member.z);
                                        let _e640 = ((_e637 >> bitcast<u32>(23i)) & 255u);
                                        let _e642 = select(0u, 1u, (_e640 != 0u));
                                        let _e646 = ((_e637 & 8388607u) | (_e642 << bitcast<u32>(23i)));
                                        let _e651 = (_e99 - ((bitcast<i32>(_e640) - bitcast<i32>(_e642)) + -149i));
                                        let _e652 = (_e651 < 0i);
                                        if _e652 {
                                            phi_908_ = -(_e651);
                                        } else {
                                            phi_908_ = 0i;
                                        }
                                        let _e655 = phi_908_;
                                        if _e652 {
                                            phi_918_ = 0i;
                                        } else {
                                            phi_918_ = select(_e651, 31i, (_e651 > 31i));
                                        }
                                        let _e659 = phi_918_;
                                        let _e664 = (_e659 & 31i);
                                        let _e674 = (bitcast<i32>(_e637) >> bitcast<u32>(31i));
                                        let _e683 = bitcast<u32>(-(_e515.member_1.x));
                                        let _e686 = ((_e683 >> bitcast<u32>(23i)) & 255u);
                                        let _e688 = select(0u, 1u, (_e686 != 0u));
                                        let _e692 = ((_e683 & 8388607u) | (_e688 << bitcast<u32>(23i)));
                                        let _e697 = (_e99 - ((bitcast<i32>(_e686) - bitcast<i32>(_e688)) + -149i));
                                        let _e698 = (_e697 < 0i);
                                        if _e698 {
                                            phi_967_ = -(_e697);
                                        } else {
                                            phi_967_ = 0i;
                                        }
                                        let _e701 = phi_967_;
                                        if _e698 {
                                            phi_977_ = 0i;
                                        } else {
                                            phi_977_ = select(_e697, 31i, (_e697 > 31i));
                                        }
                                        let _e705 = phi_977_;
                                        let _e710 = (_e705 & 31i);
                                        let _e720 = (bitcast<i32>(_e683) >> bitcast<u32>(31i));
                                        let _e730 = bitcast<u32>(-(_e515.member_1.y));
                                        let _e733 = ((_e730 >> bitcast<u32>(23i)) & 255u);
                                        let _e735 = select(0u, 1u, (_e733 != 0u));
                                        let _e739 = ((_e730 & 8388607u) | (_e735 << bitcast<u32>(23i)));
                                        let _e744 = (_e99 - ((bitcast<i32>(_e733) - bitcast<i32>(_e735)) + -149i));
                                        let _e745 = (_e744 < 0i);
                                        if _e745 {
                                            phi_1026_ = -(_e744);
                                        } else {
                                            phi_1026_ = 0i;
                                        }
                                        let _e748 = phi_1026_;
                                        if _e745 {
                                            phi_1036_ = 0i;
                                        } else {
                                            phi_1036_ = select(_e744, 31i, (_e744 > 31i));
                                        }
                                        let _e752 = phi_1036_;
                                        let _e757 = (_e752 & 31i);
                                        let _e767 = (bitcast<i32>(_e730) >> bitcast<u32>(31i));
                                        let _e777 = bitcast<u32>(-(_e515.member_1.z));
                                        let _e780 = ((_e777 >> bitcast<u32>(23i)) & 255u);
                                        let _e782 = select(0u, 1u, (_e780 != 0u));
                                        let _e786 = ((_e777 & 8388607u) | (_e782 << bitcast<u32>(23i)));
                                        let _e791 = (_e99 - ((bitcast<i32>(_e780) - bitcast<i32>(_e782)) + -149i));
                                        let _e792 = (_e791 < 0i);
                                        if _e792 {
                                            phi_1085_ = -(_e791);
                                        } else {
                                            phi_1085_ = 0i;
                                        }
                                        let _e795 = phi_1085_;
                                        if _e792 {
                                            phi_1095_ = 0i;
                                        } else {
                                            phi_1095_ = select(_e791, 31i, (_e791 > 31i));
                                        }
                                        let _e799 = phi_1095_;
                                        let _e804 = (_e799 & 31i);
                                        let _e814 = (bitcast<i32>(_e777) >> bitcast<u32>(31i));
                                        local_15 = array<i32, 3>((((bitcast<i32>(((_e556 << bitcast<u32>((bitcast<u32>(_e565) & 31u))) >> bitcast<u32>(_e574))) + select(0i, 1i, (((_e556 & ((1u << bitcast<u32>(_e574)) - 1u)) != 0u) && (_e584 != 0i)))) ^ _e584) - _e584), (((bitcast<i32>(((_e601 << bitcast<u32>((bitcast<u32>(_e610) & 31u))) >> bitcast<u32>(_e619))) + select(0i, 1i, (((_e601 & ((1u << bitcast<u32>(_e619)) - 1u)) != 0u) && (_e629 != 0i)))) ^ _e629) - _e629), (((bitcast<i32>(((_e646 << bitcast<u32>((bitcast<u32>(_e655) & 31u))) >> bitcast<u32>(_e664))) + select(0i, 1i, (((_e646 & ((1u << bitcast<u32>(_e664)) - 1u)) != 0u) && (_e674 != 0i)))) ^ _e674) - _e674));
                                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e692 << bitcast<u32>((bitcast<u32>(_e701) & 31u))) >> bitcast<u32>(_e710))) + select(0i, 1i, (((_e692 & ((1u << bitcast<u32>(_e710)) - 1u)) != 0u) && (_e720 != 0i)))) ^ _e720) - _e720)), -((((bitcast<i32>(((_e739 << bitcast<u32>((bitcast<u32>(_e748) & 31u))) >> bitcast<u32>(_e757))) + select(0i, 1i, (((_e739 & ((1u << bitcast<u32>(_e757)) - 1u)) != 0u) && (_e767 != 0i)))) ^ _e767) - _e767)), -((((bitcast<i32>(((_e786 << bitcast<u32>((bitcast<u32>(_e795) & 31u))) >> bitcast<u32>(_e804))) + select(0i, 1i, (((_e786 & ((1u << bitcast<u32>(_e804)) - 1u)) != 0u) && (_e814 != 0i)))) ^ _e814) - _e814)));
                                        let _e837 = bitcast<u32>(_e534.member.x);
                                        let _e840 = ((_e837 >> bitcast<u32>(23i)) & 255u);
                                        let _e842 = select(0u, 1u, (_e840 != 0u));
                                        let _e846 = ((_e837 & 8388607u) | (_e842 << bitcast<u32>(23i)));
                                        let _e851 = (_e99 - ((bitcast<i32>(_e840) - bitcast<i32>(_e842)) + -149i));
                                        let _e852 = (_e851 < 0i);
                                        if _e852 {
                                            phi_1162_ = -(_e851);
                                        } else {
                                            phi_1162_ = 0i;
                                        }
                                        let _e855 = phi_1162_;
                                        if _e852 {
                                            phi_1172_ = 0i;
                                        } else {
                                            phi_1172_ = select(_e851, 31i, (_e851 > 31i));
                                        }
                                        let _e859 = phi_1172_;
                                        let _e864 = (_e859 & 31i);
                                        let _e874 = (bitcast<i32>(_e837) >> bitcast<u32>(31i));
                                        let _e882 = bitcast<u32>(_e534.member.y);
                                        let _e885 = ((_e882 >> bitcast<u32>(23i)) & 255u);
                                        let _e887 = select(0u, 1u, (_e885 != 0u));
                                        let _e891 = ((_e882 & 8388607u) | (_e887 << bitcast<u32>(23i)));
                                        let _e896 = (_e99 - ((bitcast<i32>(_e885) - bitcast<i32>(_e887)) + -149i));
                                        let _e897 = (_e896 < 0i);
                                        if _e897 {
                                            phi_1219_ = -(_e896);
                                        } else {
                                            phi_1219_ = 0i;
                                        }
                                        let _e900 = phi_1219_;
                                        if _e897 {
                                            phi_1229_ = 0i;
                                        } else {
                                            phi_1229_ = select(_e896, 31i, (_e896 > 31i));
                                        }
                                        let _e904 = phi_1229_;
                                        let _e909 = (_e904 & 31i);
                                        let _e919 = (bitcast<i32>(_e882) >> bitcast<u32>(31i));
                                        let _e927 = bitcast<u32>(_e534.member.z);
                                        let _e930 = ((_e927 >> bitcast<u32>(23i)) & 255u);
                                        let _e932 = select(0u, 1u, (_e930 != 0u));
                                        let _e936 = ((_e927 & 8388607u) | (_e932 << bitcast<u32>(23i)));
                                        let _e941 = (_e99 - ((bitcast<i32>(_e930) - bitcast<i32>(_e932)) + -149i));
                                        let _e942 = (_e941 < 0i);
                                        if _e942 {
                                            phi_1276_ = -(_e941);
                                        } else {
                                            phi_1276_ = 0i;
                                        }
                                        let _e945 = phi_1276_;
                                        if _e942 {
                                            phi_1286_ = 0i;
                                        } else {
                                            phi_1286_ = select(_e941, 31i, (_e941 > 31i));
                                        }
                                        let _e949 = phi_1286_;
                                        let _e954 = (_e949 & 31i);
                                        let _e964 = (bitcast<i32>(_e927) >> bitcast<u32>(31i));
                                        let _e973 = bitcast<u32>(-(_e534.member_1.x));
                                        let _e976 = ((_e973 >> bitcast<u32>(23i)) & 255u);
                                        let _e978 = select(0u, 1u, (_e976 != 0u));
                                        let _e982 = ((_e973 & 8388607u) | (_e978 << bitcast<u32>(23i)));
                                        let _e987 = (_e99 - ((bitcast<i32>(_e976) - bitcast<i32>(_e978)) + -149i));
                                        let _e988 = (_e987 < 0i);
                                        if _e988 {
                                            phi_1335_ = -(_e987);
                                        } else {
                                            phi_1335_ = 0i;
                                        }
                                        let _e991 = phi_1335_;
                                        if _e988 {
                                            phi_1345_ = 0i;
                                        } else {
                                            phi_1345_ = select(_e987, 31i, (_e987 > 31i));
                                        }
                                        let _e995 = phi_1345_;
                                        let _e1000 = (_e995 & 31i);
                                        let _e1010 = (bitcast<i32>(_e973) >> bitcast<u32>(31i));
                                        let _e1020 = bitcast<u32>(-(_e534.member_1.y));
                                        let _e1023 = ((_e1020 >> bitcast<u32>(23i)) & 255u);
                                        let _e1025 = select(0u, 1u, (_e1023 != 0u));
                                        let _e1029 = ((_e1020 & 8388607u) | (_e1025 << bitcast<u32>(23i)));
                                        let _e1034 = (_e99 - ((bitcast<i32>(_e1023) - bitcast<i32>(_e1025)) + -149i));
                                        let _e1035 = (_e1034 < 0i);
                                        if _e1035 {
                                            phi_1394_ = -(_e1034);
                                        } else {
                                            phi_1394_ = 0i;
                                        }
                                        let _e1038 = phi_1394_;
                                        if _e1035 {
                                            phi_1404_ = 0i;
                                        } else {
                                            phi_1404_ = select(_e1034, 31i, (_e1034 > 31i));
                                        }
                                        let _e1042 = phi_1404_;
                                        let _e1047 = (_e1042 & 31i);
                                        let _e1057 = (bitcast<i32>(_e1020) >> bitcast<u32>(31i));
                                        let _e1067 = bitcast<u32>(-(_e534.member_1.z));
                                        let _e1070 = ((_e1067 >> bitcast<u32>(23i)) & 255u);
                                        let _e1072 = select(0u, 1u, (_e1070 != 0u));
                                        let _e1076 = ((_e1067 & 8388607u) | (_e1072 << bitcast<u32>(23i)));
                                        let _e1081 = (_e99 - ((bitcast<i32>(_e1070) - bitcast<i32>(_e1072)) + -149i));
                                        let _e1082 = (_e1081 < 0i);
                                        if _e1082 {
                                            phi_1453_ = -(_e1081);
                                        } else {
                                            phi_1453_ = 0i;
                                        }
                                        let _e1085 = phi_1453_;
                                        if _e1082 {
                                            phi_1463_ = 0i;
                                        } else {
                                            phi_1463_ = select(_e1081, 31i, (_e1081 > 31i));
                                        }
                                        let _e1089 = phi_1463_;
                                        let _e1094 = (_e1089 & 31i);
                                        let _e1104 = (bitcast<i32>(_e1067) >> bitcast<u32>(31i));
                                        local_13 = array<i32, 3>((((bitcast<i32>(((_e846 << bitcast<u32>((bitcast<u32>(_e855) & 31u))) >> bitcast<u32>(_e864))) + select(0i, 1i, (((_e846 & ((1u << bitcast<u32>(_e864)) - 1u)) != 0u) && (_e874 != 0i)))) ^ _e874) - _e874), (((bitcast<i32>(((_e891 << bitcast<u32>((bitcast<u32>(_e900) & 31u))) >> bitcast<u32>(_e909))) + select(0i, 1i, (((_e891 & ((1u << bitcast<u32>(_e909)) - 1u)) != 0u) && (_e919 != 0i)))) ^ _e919) - _e919), (((bitcast<i32>(((_e936 << bitcast<u32>((bitcast<u32>(_e945) & 31u))) >> bitcast<u32>(_e954))) + select(0i, 1i, (((_e936 & ((1u << bitcast<u32>(_e954)) - 1u)) != 0u) && (_e964 != 0i)))) ^ _e964) - _e964));
                                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e982 << bitcast<u32>((bitcast<u32>(_e991) & 31u))) >> bitcast<u32>(_e1000))) + select(0i, 1i, (((_e982 & ((1u << bitcast<u32>(_e1000)) - 1u)) != 0u) && (_e1010 != 0i)))) ^ _e1010) - _e1010)), -((((bitcast<i32>(((_e1029 << bitcast<u32>((bitcast<u32>(_e1038) & 31u))) >> bitcast<u32>(_e1047))) + select(0i, 1i, (((_e1029 & ((1u << bitcast<u32>(_e1047)) - 1u)) != 0u) && (_e1057 != 0i)))) ^ _e1057) - _e1057)), -((((bitcast<i32>(((_e1076 << bitcast<u32>((bitcast<u32>(_e1085) & 31u))) >> bitcast<u32>(_e1094))) + select(0i, 1i, (((_e1076 & ((1u << bitcast<u32>(_e1094)) - 1u)) != 0u) && (_e1104 != 0i)))) ^ _e1104) - _e1104)));
                                        local_21 = array<u32, 4>(0u, 0u, 0u, 0u);
                                        phi_1507_ = type_8(0u, 3u);
                                        loop {
                                            let _e1116 = phi_1507_;
                                            if (_e1116.member < _e1116.member_1) {
                                                phi_1508_ = type_8((_e1116.member + 1u), _e1116.member_1);
                                                phi_1531_ = type_8(1u, _e1116.member);
                                            } else {
                                                phi_1508_ = _e1116;
                                                phi_1531_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1129 = phi_1508_;
                                            let _e1131 = phi_1531_;
                                            let _e1135 = (bitcast<i32>(_e1131.member) != 0i);
                                            if _e1135 {
                                                let _e1136 = (_e1131.member_1 < 3u);
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1138 = local_11[_e1131.member_1];
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1140 = local_10[_e1131.member_1];
                                                let _e1142 = bitcast<u32>((_e1140 - _e1138));
                                                let _e1148 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1142)), 32u, (_e1142 == 0u)));
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1153 = local_15[_e1131.member_1];
                                                let _e1154 = (_e1153 - _e1138);
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1156 = local_13[_e1131.member_1];
                                                let _e1157 = (_e1156 - _e1138);
                                                let _e1158 = (_e1154 > _e1157);
                                                let _e1161 = ((select(10u, _e1148, (_e1148 > 10u)) - 10u) & 31u);
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1170 = local_14[_e1131.member_1];
                                                let _e1171 = (_e1140 - _e1170);
                                                if _e1136 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1173 = local_12[_e1131.member_1];
                                                let _e1174 = (_e1140 - _e1173);
                                                let _e1175 = (_e1171 > _e1174);
                                                let _e1188 = ((1u + _e1131.member_1) % 4u);
                                                if (_e1188 < 4u) {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                local_21[_e1188] = ((((bitcast<u32>(select(_e1157, _e1154, _e1158)) >> bitcast<u32>(_e1161)) & 1023u) | (select(0u, 1u, _e1158) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1174, _e1171, _e1175)) >> bitcast<u32>(_e1161)) & 1023u) | (select(0u, 1u, _e1175) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_1507_ = _e1129;
                                                phi_3700_ = _e462;
                                                break if !(_e1135);
                                            }
                                        }
                                        let _e1194 = phi_3700_;
                                        phi_3802_ = _e1194;
                                        if _e1194 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1705_ = type_8(0u, 3u);
                                        loop {
                                            let _e1196 = phi_1705_;
                                            if (_e1196.member < _e1196.member_1) {
                                                phi_1706_ = type_8((_e1196.member + 1u), _e1196.member_1);
                                                phi_1729_ = type_8(1u, _e1196.member);
                                            } else {
                                                phi_1706_ = _e1196;
                                                phi_1729_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1209 = phi_1706_;
                                            let _e1211 = phi_1729_;
                                            let _e1215 = (bitcast<i32>(_e1211.member) != 0i);
                                            if _e1215 {
                                                let _e1217 = ((1u + _e1211.member_1) % 4u);
                                                if (_e1217 < 4u) {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1220 = local_21[_e1217];
                                                let _e1222 = ((_e1211.member_1 + 1u) % 4u);
                                                if (_e1222 < 4u) {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1225 = local_21[_e1222];
                                                let _e1226 = (_e1211.member_1 < 3u);
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1228 = local_11[_e1211.member_1];
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1230 = local_10[_e1211.member_1];
                                                let _e1232 = (_e1225 >> bitcast<u32>(11u));
                                                let _e1234 = bitcast<u32>((_e1230 - _e1228));
                                                let _e1240 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1234)), 32u, (_e1234 == 0u)));
                                                let _e1245 = ((select(10u, _e1240, (_e1240 > 10u)) - 10u) & 31u);
                                                let _e1249 = (_e1228 + bitcast<i32>(((_e1220 & 1023u) << bitcast<u32>(_e1245))));
                                                let _e1254 = (_e1230 - bitcast<i32>(((_e1232 & 1023u) << bitcast<u32>(_e1245))));
                                                let _e1258 = (((_e1220 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                let _e1262 = (((_e1232 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_3[_e1211.member_1] = select(_e1228, _e1249, _e1258);
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_1[_e1211.member_1] = select(_e1249, _e1228, _e1258);
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_2[_e1211.member_1] = select(_e1230, _e1254, _e1262);
                                                if _e1226 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local[_e1211.member_1] = select(_e1254, _e1230, _e1262);
                                            }
                                            continue;
                                            continuing {
                                                phi_1705_ = _e1209;
                                                phi_3785_ = _e1194;
                                                break if !(_e1215);
                                            }
                                        }
                                        let _e1273 = phi_3785_;
                                        phi_3802_ = _e1273;
                                        if _e1273 {
                                            break;
                                        }
                                        let _e1274 = local;
                                        let _e1275 = local_1;
                                        let _e1276 = local_2;
                                        let _e1277 = local_3;
                                        if _e497 {
                                            phi_1934_ = type_38(array<i32, 3>(_e1277[0], _e1277[1], _e1277[2]), array<i32, 3>(_e1276[0], _e1276[1], _e1276[2]));
                                        } else {
                                            phi_1934_ = type_38(array<i32, 3>(_e1275[0], _e1275[1], _e1275[2]), array<i32, 3>(_e1274[0], _e1274[1], _e1274[2]));
                                        }
                                        let _e1297 = phi_1934_;
                                        local_11 = array<i32, 3>(_e1297.member[0], _e1297.member[1], _e1297.member[2]);
                                        local_10 = array<i32, 3>(_e1297.member_1[0], _e1297.member_1[1], _e1297.member_1[2]);
                                        phi_3804_ = _e1273;
                                        phi_1952_ = select(_e491.member_2, _e491.member_1, _e497);
                                    }
                                    let _e1310 = phi_3804_;
                                    let _e1312 = phi_1952_;
                                    phi_3803_ = _e1310;
                                    phi_679_ = _e1312;
                                    phi_1954_ = select(true, false, _e485);
                                } else {
                                    phi_3803_ = _e462;
                                    phi_679_ = u32();
                                    phi_1954_ = false;
                                }
                                let _e1315 = phi_3803_;
                                let _e1317 = phi_679_;
                                let _e1319 = phi_1954_;
                                continue;
                                continuing {
                                    phi_3745_ = _e1315;
                                    phi_675_ = _e479;
                                    phi_678_ = _e1317;
                                    phi_3802_ = _e1315;
                                    break if !(_e1319);
                                }
                            }
                            let _e1322 = phi_3802_;
                            if _e1322 {
                                break;
                            }
                            let _e1323 = local_10;
                            let _e1324 = local_11;
                            local_9 = _e1324;
                            local_8 = _e1323;
                            if _e108 {
                            } else {
                                break;
                            }
                            let _e1328 = global_4.member[_e103].member_1;
                            if (_e1328 == 2147483648u) {
                                phi_2005_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e1334 = global_4.member[_e103].member[0u];
                                let _e1339 = global_4.member[_e103].member[1u];
                                let _e1344 = global_4.member[_e103].member[2u];
                                phi_2005_ = type_30(vec3<f32>(_e1334[0], _e1339[0], _e1344[0]), vec3<f32>(_e1334[2], _e1339[2], _e1344[2]));
                            }
                            let _e1355 = phi_2005_;
                            let _e1359 = global_4.member[_e103].member_2;
                            if (_e1359 == 2147483648u) {
                                phi_2027_ = _e1355;
                            } else {
                                let _e1365 = global_4.member[_e103].member[0u];
                                let _e1370 = global_4.member[_e103].member[1u];
                                let _e1375 = global_4.member[_e103].member[2u];
                                phi_2027_ = type_30(vec3<f32>(_e1365[1], _e1370[1], _e1375[1]), vec3<f32>(_e1365[3], _e1370[3], _e1375[3]));
                            }
                            let _e1386 = phi_2027_;
                            let _e1399 = bitcast<u32>(_e1355.member.x);
                            let _e1402 = ((_e1399 >> bitcast<u32>(23i)) & 255u);
                            let _e1404 = select(0u, 1u, (_e1402 != 0u));
                            let _e1408 = ((_e1399 & 8388607u) | (_e1404 << bitcast<u32>(23i)));
                            let _e1413 = (_e99 - ((bitcast<i32>(_e1402) - bitcast<i32>(_e1404)) + -149i));
                            let _e1414 = (_e1413 < 0i);
                            if _e1414 {
                                phi_2054_ = -(_e1413);
                            } else {
                                phi_2054_ = 0i;
                            }
                            let _e1417 = phi_2054_;
                            if _e1414 {
                                phi_2064_ = 0i;
                            } else {
                                phi_2064_ = select(_e1413, 31i, (_e1413 > 31i));
                            }
                            let _e1421 = phi_2064_;
                            let _e1426 = (_e1421 & 31i);
                            let _e1436 = (bitcast<i32>(_e1399) >> bitcast<u32>(31i));
                            let _e1444 = bitcast<u32>(_e1355.member.y);
                            let _e1447 = ((_e1444 >> bitcast<u32>(23i)) & 255u);
                            let _e1449 = select(0u, 1u, (_e1447 != 0u));
                            let _e1453 = ((_e1444 & 8388607u) | (_e1449 << bitcast<u32>(23i)));
                            let _e1458 = (_e99 - ((bitcast<i32>(_e1447) - bitcast<i32>(_e1449)) + -149i));
                            let _e1459 = (_e1458 < 0i);
                            if _e1459 {
                                phi_2111_ = -(_e1458);
                            } else {
                                phi_2111_ = 0i;
                            }
                            let _e1462 = phi_2111_;
                            if _e1459 {
                                phi_2121_ = 0i;
                            } else {
                                phi_2121_ = select(_e1458, 31i, (_e1458 > 31i));
                            }
                            let _e1466 = phi_2121_;
                            let _e1471 = (_e1466 & 31i);
                            let _e1481 = (bitcast<i32>(_e1444) >> bitcast<u32>(31i));
                            let _e1489 = bitcast<u32>(_e1355.member.z);
                            let _e1492 = ((_e1489 >> bitcast<u32>(23i)) & 255u);
                            let _e1494 = select(0u, 1u, (_e1492 != 0u));
                            let _e1498 = ((_e1489 & 8388607u) | (_e1494 << bitcast<u32>(23i)));
                            let _e1503 = (_e99 - ((bitcast<i32>(_e1492) - bitcast<i32>(_e1494)) + -149i));
                            let _e1504 = (_e1503 < 0i);
                            if _e1504 {
                                phi_2168_ = -(_e1503);
                            } else {
                                phi_2168_ = 0i;
                            }
                            let _e1507 = phi_2168_;
                            if _e1504 {
                                phi_2178_ = 0i;
                            } else {
                                phi_2178_ = select(_e1503, 31i, (_e1503 > 31i));
                            }
                            let _e1511 = phi_2178_;
                            let _e1516 = (_e1511 & 31i);
                            let _e1526 = (bitcast<i32>(_e1489) >> bitcast<u32>(31i));
                            let _e1535 = bitcast<u32>(-(_e1355.member_1.x));
                            let _e1538 = ((_e1535 >> bitcast<u32>(23i)) & 255u);
                            let _e1540 = select(0u, 1u, (_e1538 != 0u));
                            let _e1544 = ((_e1535 & 8388607u) | (_e1540 << bitcast<u32>(23i)));
                            let _e1549 = (_e99 - ((bitcast<i32>(_e1538) - bitcast<i32>(_e1540)) + -149i));
                            let _e1550 = (_e1549 < 0i);
                            if _e1550 {
                                phi_2227_ = -(_e1549);
                            } else {
                                phi_2227_ = 0i;
                            }
                            let _e1553 = phi_2227_;
                            if _e1550 {
                                phi_2237_ = 0i;
                            } else {
                                phi_2237_ = select(_e1549, 31i, (_e1549 > 31i));
                            }
                            let _e1557 = phi_2237_;
                            let _e1562 = (_e1557 & 31i);
                            let _e1572 = (bitcast<i32>(_e1535) >> bitcast<u32>(31i));
                            let _e1582 = bitcast<u32>(-(_e1355.member_1.y));
                            let _e1585 = ((_e1582 >> bitcast<u32>(23i)) & 255u);
                            let _e1587 = select(0u, 1u, (_e1585 != 0u));
                            let _e1591 = ((_e1582 & 8388607u) | (_e1587 << bitcast<u32>(23i)));
                            let _e1596 = (_e99 - ((bitcast<i32>(_e1585) - bitcast<i32>(_e1587)) + -149i));
                            let _e1597 = (_e1596 < 0i);
                            if _e1597 {
                                phi_2286_ = -(_e1596);
                            } else {
                                phi_2286_ = 0i;
                            }
                            let _e1600 = phi_2286_;
                            if _e1597 {
                                phi_2296_ = 0i;
                            } else {
                                phi_2296_ = select(_e1596, 31i, (_e1596 > 31i));
                            }
                            let _e1604 = phi_2296_;
                            let _e1609 = (_e1604 & 31i);
                            let _e1619 = (bitcast<i32>(_e1582) >> bitcast<u32>(31i));
                            let _e1629 = bitcast<u32>(-(_e1355.member_1.z));
                            let _e1632 = ((_e1629 >> bitcast<u32>(23i)) & 255u);
                            let _e1634 = select(0u, 1u, (_e1632 != 0u));
                            let _e1638 = ((_e1629 & 8388607u) | (_e1634 << bitcast<u32>(23i)));
                            let _e1643 = (_e99 - ((bitcast<i32>(_e1632) - bitcast<i32>(_e1634)) + -149i));
                            let _e1644 = (_e1643 < 0i);
                            if _e1644 {
                                phi_2345_ = -(_e1643);
                            } else {
                                phi_2345_ = 0i;
                            }
                            let _e1647 = phi_2345_;
                            if _e1644 {
                                phi_2355_ = 0i;
                            } else {
                                phi_2355_ = select(_e1643, 31i, (_e1643 > 31i));
                            }
                            let _e1651 = phi_2355_;
                            let _e1656 = (_e1651 & 31i);
                            let _e1666 = (bitcast<i32>(_e1629) >> bitcast<u32>(31i));
                            local_19 = array<i32, 3>((((bitcast<i32>(((_e1408 << bitcast<u32>((bitcast<u32>(_e1417) & 31u))) >> bitcast<u32>(_e1426))) + select(0i, 1i, (((_e1408 & ((1u << bitcast<u32>(_e1426)) - 1u)) != 0u) && (_e1436 != 0i)))) ^ _e1436) - _e1436), (((bitcast<i32>(((_e1453 << bitcast<u32>((bitcast<u32>(_e1462) & 31u))) >> bitcast<u32>(_e1471))) + select(0i, 1i, (((_e1453 & ((1u << bitcast<u32>(_e1471)) - 1u)) != 0u) && (_e1481 != 0i)))) ^ _e1481) - _e1481), (((bitcast<i32>(((_e1498 << bitcast<u32>((bitcast<u32>(_e1507) & 31u))) >> bitcast<u32>(_e1516))) + select(0i, 1i, (((_e1498 & ((1u << bitcast<u32>(_e1516)) - 1u)) != 0u) && (_e1526 != 0i)))) ^ _e1526) - _e1526));
                            local_18 = array<i32, 3>(-((((bitcast<i32>(((_e1544 << bitcast<u32>((bitcast<u32>(_e1553) & 31u))) >> bitcast<u32>(_e1562))) + select(0i, 1i, (((_e1544 & ((1u << bitcast<u32>(_e1562)) - 1u)) != 0u) && (_e1572 != 0i)))) ^ _e1572) - _e1572)), -((((bitcast<i32>(((_e1591 << bitcast<u32>((bitcast<u32>(_e1600) & 31u))) >> bitcast<u32>(_e1609))) + select(0i, 1i, (((_e1591 & ((1u << bitcast<u32>(_e1609)) - 1u)) != 0u) && (_e1619 != 0i)))) ^ _e1619) - _e1619)), -((((bitcast<i32>(((_e1638 << bitcast<u32>((bitcast<u32>(_e1647) & 31u))) >> bitcast<u32>(_e1656))) + select(0i, 1i, (((_e1638 & ((1u << bitcast<u32>(_e1656)) - 1u)) != 0u) && (_e1666 != 0i)))) ^ _e1666) - _e1666)));
                            let _e1689 = bitcast<u32>(_e1386.member.x);
                            let _e1692 = ((_e1689 >> bitcast<u32>(23i)) & 255u);
                            let _e1694 = select(0u, 1u, (_e1692 != 0u));
                            let _e1698 = ((_e1689 & 8388607u) | (_e1694 << bitcast<u32>(23i)));
                            let _e1703 = (_e99 - ((bitcast<i32>(_e1692) - bitcast<i32>(_e1694)) + -149i));
                            let _e1704 = (_e1703 < 0i);
                            if _e1704 {
                                phi_2422_ = -(_e1703);
                            } else {
                                phi_2422_ = 0i;
                            }
                            let _e1707 = phi_2422_;
                            if _e1704 {
                                phi_2432_ = 0i;
                            } else {
                                phi_2432_ = select(_e1703, 31i, (_e1703 > 31i));
                            }
                            let _e1711 = phi_2432_;
                            let _e1716 = (_e1711 & 31i);
                            let _e1726 = (bitcast<i32>(_e1689) >> bitcast<u32>(31i));
                            let _e1734 = bitcast<u32>(_e1386.member.y);
                            let _e1737 = ((_e1734 >> bitcast<u32>(23i)) & 255u);
                            let _e1739 = select(0u, 1u, (_e1737 != 0u));
                            let _e1743 = ((_e1734 & 8388607u) | (_e1739 << bitcast<u32>(23i)));
                            let _e1748 = (_e99 - ((bitcast<i32>(_e1737) - bitcast<i32>(_e1739)) + -149i));
                            let _e1749 = (_e1748 < 0i);
                            if _e1749 {
                                phi_2479_ = -(_e1748);
                            } else {
                                phi_2479_ = 0i;
                            }
                            let _e1752 = phi_2479_;
                            if _e1749 {
                                phi_2489_ = 0i;
                            } else {
                                phi_2489_ = select(_e1748, 31i, (_e1748 > 31i));
                            }
                            let _e1756 = phi_2489_;
                            let _e1761 = (_e1756 & 31i);
                            let _e1771 = (bitcast<i32>(_e1734) >> bitcast<u32>(31i));
                            let _e1779 = bitcast<u32>(_e1386.member.z);
                            let _e1782 = ((_e1779 >> bitcast<u32>(23i)) & 255u);
                            let _e1784 = select(0u, 1u, (_e1782 != 0u));
                            let _e1788 = ((_e1779 & 8388607u) | (_e1784 << bitcast<u32>(23i)));
                            let _e1793 = (_e99 - ((bitcast<i32>(_e1782) - bitcast<i32>(_e1784)) + -149i));
                            let _e1794 = (_e1793 < 0i);
                            if _e1794 {
                                phi_2536_ = -(_e1793);
                            } else {
                                phi_2536_ = 0i;
                            }
                            let _e1797 = phi_2536_;
                            if _e1794 {
                                phi_2546_ = 0i;
                            } else {
                                phi_2546_ = select(_e1793, 31i, (_e1793 > 31i));
                            }
                            let _e1801 = phi_2546_;
                            let _e1806 = (_e1801 & 31i);
                            let _e1816 = (bitcast<i32>(_e1779) >> bitcast<u32>(31i));
                            let _e1825 = bitcast<u32>(-(_e1386.member_1.x));
                            let _e1828 = ((_e1825 >> bitcast<u32>(23i)) & 255u);
                            let _e1830 = select(0u, 1u, (_e1828 != 0u));
                            let _e1834 = ((_e1825 & 8388607u) | (_e1830 << bitcast<u32>(23i)));
                            let _e1839 = (_e99 - ((bitcast<i32>(_e1828) - bitcast<i32>(_e1830)) + -149i));
                            let _e1840 = (_e1839 < 0i);
                            if _e1840 {
                                phi_2595_ = -(_e1839);
                            } else {
                                phi_2595_ = 0i;
                            }
                            let _e1843 = phi_2595_;
                            if _e1840 {
                                phi_2605_ = 0i;
                            } else {
                                phi_2605_ = select(_e1839, 31i, (_e1839 > 31i));
                            }
                            let _e1847 = phi_2605_;
                            let _e1852 = (_e1847 & 31i);
                            let _e1862 = (bitcast<i32>(_e1825) >> bitcast<u32>(31i));
                            let _e1872 = bitcast<u32>(-(_e1386.member_1.y));
                            let _e1875 = ((_e1872 >> bitcast<u32>(23i)) & 255u);
                            let _e1877 = select(0u, 1u, (_e1875 != 0u));
                            let _e1881 = ((_e1872 & 8388607u) | (_e1877 << bitcast<u32>(23i)));
                            let _e1886 = (_e99 - ((bitcast<i32>(_e1875) - bitcast<i32>(_e1877)) + -149i));
                            let _e1887 = (_e1886 < 0i);
                            if _e1887 {
                                phi_2654_ = -(_e1886);
                            } else {
                                phi_2654_ = 0i;
                            }
                            let _e1890 = phi_2654_;
                            if _e1887 {
                                phi_2664_ = 0i;
                            } else {
                                phi_2664_ = select(_e1886, 31i, (_e1886 > 31i));
                            }
                            let _e1894 = phi_2664_;
                            let _e1899 = (_e1894 & 31i);
                            let _e1909 = (bitcast<i32>(_e1872) >> bitcast<u32>(31i));
                            let _e1919 = bitcast<u32>(-(_e1386.member_1.z));
                            let _e1922 = ((_e1919 >> bitcast<u32>(23i)) & 255u);
                            let _e1924 = select(0u, 1u, (_e1922 != 0u));
                            let _e1928 = ((_e1919 & 8388607u) | (_e1924 << bitcast<u32>(23i)));
                            let _e1933 = (_e99 - ((bitcast<i32>(_e1922) - bitcast<i32>(_e1924)) + -149i));
                            let _e1934 = (_e1933 < 0i);
                            if _e1934 {
                                phi_2713_ = -(_e1933);
                            } else {
                                phi_2713_ = 0i;
                            }
                            let _e1937 = phi_2713_;
                            if _e1934 {
                                phi_2723_ = 0i;
                            } else {
                                phi_2723_ = select(_e1933, 31i, (_e1933 > 31i));
                            }
                            let _e1941 = phi_2723_;
                            let _e1946 = (_e1941 & 31i);
                            let _e1956 = (bitcast<i32>(_e1919) >> bitcast<u32>(31i));
                            local_17 = array<i32, 3>((((bitcast<i32>(((_e1698 << bitcast<u32>((bitcast<u32>(_e1707) & 31u))) >> bitcast<u32>(_e1716))) + select(0i, 1i, (((_e1698 & ((1u << bitcast<u32>(_e1716)) - 1u)) != 0u) && (_e1726 != 0i)))) ^ _e1726) - _e1726), (((bitcast<i32>(((_e1743 << bitcast<u32>((bitcast<u32>(_e1752) & 31u))) >> bitcast<u32>(_e1761))) + select(0i, 1i, (((_e1743 & ((1u << bitcast<u32>(_e1761)) - 1u)) != 0u) && (_e1771 != 0i)))) ^ _e1771) - _e1771), (((bitcast<i32>(((_e1788 << bitcast<u32>((bitcast<u32>(_e1797) & 31u))) >> bitcast<u32>(_e1806))) + select(0i, 1i, (((_e1788 & ((1u << bitcast<u32>(_e1806)) - 1u)) != 0u) && (_e1816 != 0i)))) ^ _e1816) - _e1816));
                            local_16 = array<i32, 3>(-((((bitcast<i32>(((_e1834 << bitcast<u32>((bitcast<u32>(_e1843) & 31u))) >> bitcast<u32>(_e1852))) + select(0i, 1i, (((_e1834 & ((1u << bitcast<u32>(_e1852)) - 1u)) != 0u) && (_e1862 != 0i)))) ^ _e1862) - _e1862)), -((((bitcast<i32>(((_e1881 << bitcast<u32>((bitcast<u32>(_e1890) & 31u))) >> bitcast<u32>(_e1899))) + select(0i, 1i, (((_e1881 & ((1u << bitcast<u32>(_e1899)) - 1u)) != 0u) && (_e1909 != 0i)))) ^ _e1909) - _e1909)), -((((bitcast<i32>(((_e1928 << bitcast<u32>((bitcast<u32>(_e1937) & 31u))) >> bitcast<u32>(_e1946))) + select(0i, 1i, (((_e1928 & ((1u << bitcast<u32>(_e1946)) - 1u)) != 0u) && (_e1956 != 0i)))) ^ _e1956) - _e1956)));
                            local_20 = array<u32, 4>(0u, 0u, 0u, 0u);
                            phi_2767_ = type_8(0u, 3u);
                            loop {
                                let _e1968 = phi_2767_;
                                if (_e1968.member < _e1968.member_1) {
                                    phi_2768_ = type_8((_e1968.member + 1u), _e1968.member_1);
                                    phi_2791_ = type_8(1u, _e1968.member);
                                } else {
                                    phi_2768_ = _e1968;
                                    phi_2791_ = type_8(0u, type_8().member_1);
                                }
                                let _e1981 = phi_2768_;
                                let _e1983 = phi_2791_;
                                let _e1987 = (bitcast<i32>(_e1983.member) != 0i);
                                if _e1987 {
                                    let _e1988 = (_e1983.member_1 < 3u);
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e1990 = local_9[_e1983.member_1];
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e1992 = local_8[_e1983.member_1];
                                    let _e1994 = bitcast<u32>((_e1992 - _e1990));
                                    let _e2000 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1994)), 32u, (_e1994 == 0u)));
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2005 = local_19[_e1983.member_1];
                                    let _e2006 = (_e2005 - _e1990);
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2008 = local_17[_e1983.member_1];
                                    let _e2009 = (_e2008 - _e1990);
                                    let _e2010 = (_e2006 > _e2009);
                                    let _e2013 = ((select(10u, _e2000, (_e2000 > 10u)) - 10u) & 31u);
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2022 = local_18[_e1983.member_1];
                                    let _e2023 = (_e1992 - _e2022);
                                    if _e1988 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2025 = local_16[_e1983.member_1];
                                    let _e2026 = (_e1992 - _e2025);
                                    let _e2027 = (_e2023 > _e2026);
                                    let _e2040 = ((1u + _e1983.member_1) % 4u);
                                    if (_e2040 < 4u) {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    local_20[_e2040] = ((((bitcast<u32>(select(_e2009, _e2006, _e2010)) >> bitcast<u32>(_e2013)) & 1023u) | (select(0u, 1u, _e2010) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e2026, _e2023, _e2027)) >> bitcast<u32>(_e2013)) & 1023u) | (select(0u, 1u, _e2027) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                }
                                continue;
                                continuing {
                                    phi_2767_ = _e1981;
                                    phi_3807_ = _e1322;
                                    break if !(_e1987);
                                }
                            }
                            let _e2046 = phi_3807_;
                            if _e2046 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_2965_ = type_8(0u, 3u);
                            loop {
                                let _e2048 = phi_2965_;
                                if (_e2048.member < _e2048.member_1) {
                                    phi_2966_ = type_8((_e2048.member + 1u), _e2048.member_1);
                                    phi_2989_ = type_8(1u, _e2048.member);
                                } else {
                                    phi_2966_ = _e2048;
                                    phi_2989_ = type_8(0u, type_8().member_1);
                                }
                                let _e2061 = phi_2966_;
                                let _e2063 = phi_2989_;
                                let _e2067 = (bitcast<i32>(_e2063.member) != 0i);
                                if _e2067 {
                                    let _e2069 = ((1u + _e2063.member_1) % 4u);
                                    if (_e2069 < 4u) {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2072 = local_20[_e2069];
                                    let _e2074 = ((_e2063.member_1 + 1u) % 4u);
                                    if (_e2074 < 4u) {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2077 = local_20[_e2074];
                                    let _e2078 = (_e2063.member_1 < 3u);
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2080 = local_9[_e2063.member_1];
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2082 = local_8[_e2063.member_1];
                                    let _e2084 = (_e2077 >> bitcast<u32>(11u));
                                    let _e2086 = bitcast<u32>((_e2082 - _e2080));
                                    let _e2092 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e2086)), 32u, (_e2086 == 0u)));
                                    let _e2097 = ((select(10u, _e2092, (_e2092 > 10u)) - 10u) & 31u);
                                    let _e2101 = (_e2080 + bitcast<i32>(((_e2072 & 1023u) << bitcast<u32>(_e2097))));
                                    let _e2106 = (_e2082 - bitcast<i32>(((_e2084 & 1023u) << bitcast<u32>(_e2097))));
                                    let _e2110 = (((_e2072 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e2114 = (((_e2084 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_7[_e2063.member_1] = select(_e2080, _e2101, _e2110);
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_5[_e2063.member_1] = select(_e2101, _e2080, _e2110);
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_6[_e2063.member_1] = select(_e2082, _e2106, _e2114);
                                    if _e2078 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_4[_e2063.member_1] = select(_e2106, _e2082, _e2114);
                                }
                                continue;
                                continuing {
                                    phi_2965_ = _e2061;
                                    phi_3859_ = _e2046;
                                    break if !(_e2067);
                                }
                            }
                            let _e2125 = phi_3859_;
                            if _e2125 {
                                break;
                            }
                            let _e2126 = local_4;
                            let _e2127 = local_5;
                            let _e2128 = local_6;
                            let _e2129 = local_7;
                            let _e2130 = local_20;
                            if _e109 {
                            } else {
                                break;
                            }
                            global_5.member[_e103] = array<u32, 4>(_e2130[0], _e2130[1], _e2130[2], _e2130[3]);
                            if _e110 {
                            } else {
                                break;
                            }
                            global_6.member[_e103] = type_38(array<i32, 3>(_e1324[0], _e1324[1], _e1324[2]), array<i32, 3>(_e1323[0], _e1323[1], _e1323[2]));
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e1328 & 2147483648u) != 0u) {
                                let _e2169 = ((bitcast<u32>((_e2128[0] - _e2129[0])) | bitcast<u32>((_e2128[1] - _e2129[1]))) | bitcast<u32>((_e2128[2] - _e2129[2])));
                                if (_e2169 < 1024u) {
                                    phi_3335_ = 0u;
                                } else {
                                    phi_3335_ = select(2u, 1u, (_e2169 < 2097152u));
                                }
                                let _e2174 = phi_3335_;
                                switch bitcast<i32>(_e2174) {
                                    case 0: {
                                        phi_3341_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_3341_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_3341_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_3341_ = u32();
                                        break;
                                    }
                                }
                                let _e2177 = phi_3341_;
                                phi_3348_ = type_8(0u, ((_e1328 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2185 = phi_3348_;
                                    if (_e2185.member < _e2185.member_1) {
                                        phi_3349_ = type_8((_e2185.member + 1u), _e2185.member_1);
                                        phi_3372_ = type_8(1u, _e2185.member);
                                    } else {
                                        phi_3349_ = _e2185;
                                        phi_3372_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2198 = phi_3349_;
                                    let _e2200 = phi_3372_;
                                    let _e2204 = (bitcast<i32>(_e2200.member) != 0i);
                                    if _e2204 {
                                        let _e2206 = ((_e1328 & 268435455u) + _e2200.member_1);
                                        let _e2207 = (_e2206 < _e82);
                                        if _e2207 {
                                            if _e2207 {
                                            } else {
                                                phi_3876_ = true;
                                                break;
                                            }
                                            global_7.member[_e2206] = ((3u * _e2177) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3348_ = _e2198;
                                        phi_3876_ = _e2125;
                                        break if !(_e2204);
                                    }
                                }
                                let _e2211 = phi_3876_;
                                if _e2211 {
                                    break;
                                }
                                phi_3891_ = _e2211;
                            } else {
                                phi_3891_ = _e2125;
                            }
                            let _e2213 = phi_3891_;
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e1359 & 2147483648u) != 0u) {
                                let _e2223 = ((bitcast<u32>((_e2126[0] - _e2127[0])) | bitcast<u32>((_e2126[1] - _e2127[1]))) | bitcast<u32>((_e2126[2] - _e2127[2])));
                                if (_e2223 < 1024u) {
                                    phi_3468_ = 0u;
                                } else {
                                    phi_3468_ = select(2u, 1u, (_e2223 < 2097152u));
                                }
                                let _e2228 = phi_3468_;
                                switch bitcast<i32>(_e2228) {
                                    case 0: {
                                        phi_3474_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_3474_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_3474_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_3474_ = u32();
                                        break;
                                    }
                                }
                                let _e2231 = phi_3474_;
                                phi_3481_ = type_8(0u, ((_e1359 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2239 = phi_3481_;
                                    if (_e2239.member < _e2239.member_1) {
                                        phi_3482_ = type_8((_e2239.member + 1u), _e2239.member_1);
                                        phi_3505_ = type_8(1u, _e2239.member);
                                    } else {
                                        phi_3482_ = _e2239;
                                        phi_3505_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2252 = phi_3482_;
                                    let _e2254 = phi_3505_;
                                    let _e2258 = (bitcast<i32>(_e2254.member) != 0i);
                                    if _e2258 {
                                        let _e2260 = ((_e1359 & 268435455u) + _e2254.member_1);
                                        let _e2261 = (_e2260 < _e82);
                                        if _e2261 {
                                            if _e2261 {
                                            } else {
                                                phi_3884_ = true;
                                                break;
                                            }
                                            global_7.member[_e2260] = ((3u * _e2231) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3481_ = _e2252;
                                        phi_3884_ = _e2213;
                                        break if !(_e2258);
                                    }
                                }
                                let _e2265 = phi_3884_;
                                if _e2265 {
                                    break;
                                }
                            }
                            if (_e103 == 0u) {
                                if (_e85 == 0u) {
                                } else {
                                    if (0u < _e85) {
                                    } else {
                                        break;
                                    }
                                    global_8.member[0u] = type_31(array<u32, 4>(bitcast<u32>(_e1324[0]), bitcast<u32>(_e1324[1]), bitcast<u32>(_e1324[2]), bitcast<u32>(_e99)), array<u32, 4>(bitcast<u32>(_e1323[0]), bitcast<u32>(_e1323[1]), bitcast<u32>(_e1323[2]), 0u));
                                }
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
fn encode_q10_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
