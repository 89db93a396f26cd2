struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_28 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_34 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_45 {
    member: array<type_34>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_13;
@group(0) @binding(1) 
var<uniform> global_2: type_13;
@group(0) @binding(2) 
var<uniform> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_24;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_45;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(7) 
var<storage, read_write> global_7: type_30;
@group(0) @binding(4) 
var<storage, read_write> global_8: type_40;

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
    var local_20: array<u32, 7>;
    var local_21: array<u32, 7>;
    var phi_183_: i32;
    var phi_229_: type_22;
    var phi_247_: type_27;
    var phi_265_: type_27;
    var phi_331_: i32;
    var phi_341_: i32;
    var phi_388_: i32;
    var phi_398_: i32;
    var phi_445_: i32;
    var phi_455_: i32;
    var phi_504_: i32;
    var phi_514_: i32;
    var phi_563_: i32;
    var phi_573_: i32;
    var phi_622_: i32;
    var phi_632_: i32;
    var phi_3764_: bool;
    var phi_676_: type_8;
    var phi_679_: u32;
    var phi_677_: type_8;
    var phi_702_: type_8;
    var phi_724_: type_22;
    var phi_732_: bool;
    var phi_750_: type_27;
    var phi_768_: type_27;
    var phi_795_: i32;
    var phi_805_: i32;
    var phi_852_: i32;
    var phi_862_: i32;
    var phi_909_: i32;
    var phi_919_: i32;
    var phi_968_: i32;
    var phi_978_: i32;
    var phi_1027_: i32;
    var phi_1037_: i32;
    var phi_1086_: i32;
    var phi_1096_: i32;
    var phi_1163_: i32;
    var phi_1173_: i32;
    var phi_1220_: i32;
    var phi_1230_: i32;
    var phi_1277_: i32;
    var phi_1287_: i32;
    var phi_1336_: i32;
    var phi_1346_: i32;
    var phi_1395_: i32;
    var phi_1405_: i32;
    var phi_1454_: i32;
    var phi_1464_: i32;
    var phi_1508_: type_8;
    var phi_1509_: type_8;
    var phi_1532_: type_8;
    var phi_1567_: u32;
    var phi_3719_: bool;
    var phi_1706_: type_8;
    var phi_1707_: type_8;
    var phi_1730_: type_8;
    var phi_1842_: u32;
    var phi_3804_: bool;
    var phi_1935_: type_34;
    var phi_3823_: bool;
    var phi_1953_: u32;
    var phi_3822_: bool;
    var phi_680_: u32;
    var phi_1955_: bool;
    var phi_3821_: bool;
    var phi_2006_: type_27;
    var phi_2028_: type_27;
    var phi_2055_: i32;
    var phi_2065_: i32;
    var phi_2112_: i32;
    var phi_2122_: i32;
    var phi_2169_: i32;
    var phi_2179_: i32;
    var phi_2228_: i32;
    var phi_2238_: i32;
    var phi_2287_: i32;
    var phi_2297_: i32;
    var phi_2346_: i32;
    var phi_2356_: i32;
    var phi_2423_: i32;
    var phi_2433_: i32;
    var phi_2480_: i32;
    var phi_2490_: i32;
    var phi_2537_: i32;
    var phi_2547_: i32;
    var phi_2596_: i32;
    var phi_2606_: i32;
    var phi_2655_: i32;
    var phi_2665_: i32;
    var phi_2714_: i32;
    var phi_2724_: i32;
    var phi_2768_: type_8;
    var phi_2769_: type_8;
    var phi_2792_: type_8;
    var phi_2827_: u32;
    var phi_3826_: bool;
    var phi_2966_: type_8;
    var phi_2967_: type_8;
    var phi_2990_: type_8;
    var phi_3102_: u32;
    var phi_3878_: bool;
    var phi_3345_: u32;
    var phi_3351_: u32;
    var phi_3358_: type_8;
    var phi_3359_: type_8;
    var phi_3382_: type_8;
    var phi_3895_: bool;
    var phi_3910_: bool;
    var phi_3478_: u32;
    var phi_3484_: u32;
    var phi_3491_: type_8;
    var phi_3492_: type_8;
    var phi_3515_: type_8;
    var phi_3903_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_4.member));
            let _e82 = arrayLength((&global_6.member));
            let _e85 = arrayLength((&global_7.member));
            let _e88 = global_3.member[0u];
            let _e92 = global_2.member[0u];
            let _e94 = (bitcast<i32>(_e88) + bitcast<i32>(_e92));
            if (_e94 < -126i) {
                phi_183_ = -126i;
            } else {
                phi_183_ = select(_e94, 127i, (_e94 > 127i));
            }
            let _e99 = phi_183_;
            let _e103 = (_e72.x + (_e72.y * 2097152u));
            let _e106 = global_1.member[0u];
            if (_e103 < _e106) {
                let _e108 = (_e103 < _e74);
                if _e108 {
                    let _e109 = (_e103 < arrayLength((&global_8.member)));
                    if _e109 {
                        let _e110 = (_e103 < arrayLength((&global_5.member)));
                        if _e110 {
                            let _e111 = (0u < _e74);
                            if _e111 {
                                if _e111 {
                                } else {
                                    break;
                                }
                                let _e114 = global_4.member[0u];
                                phi_229_ = _e114;
                            } else {
                                phi_229_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e116 = phi_229_;
                            if (_e116.member_1 == 2147483648u) {
                                phi_247_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_247_ = type_27(vec3<f32>(_e116.member[0][0], _e116.member[1][0], _e116.member[2][0]), vec3<f32>(_e116.member[0][2], _e116.member[1][2], _e116.member[2][2]));
                            }
                            let _e135 = phi_247_;
                            if (_e116.member_2 == 2147483648u) {
                                phi_265_ = _e135;
                            } else {
                                phi_265_ = type_27(vec3<f32>(_e116.member[0][1], _e116.member[1][1], _e116.member[2][1]), vec3<f32>(_e116.member[0][3], _e116.member[1][3], _e116.member[2][3]));
                            }
                            let _e154 = phi_265_;
                            let _e183 = bitcast<u32>(select(_e154.member.x, _e135.member.x, (_e135.member.x < _e154.member.x)));
                            let _e186 = ((_e183 >> bitcast<u32>(23i)) & 255u);
                            let _e188 = select(0u, 1u, (_e186 != 0u));
                            let _e192 = ((_e183 & 8388607u) | (_e188 << bitcast<u32>(23i)));
                            let _e197 = (_e99 - ((bitcast<i32>(_e186) - bitcast<i32>(_e188)) + -149i));
                            let _e198 = (_e197 < 0i);
                            if _e198 {
                                phi_331_ = -(_e197);
                            } else {
                                phi_331_ = 0i;
                            }
                            let _e201 = phi_331_;
                            if _e198 {
                                phi_341_ = 0i;
                            } else {
                                phi_341_ = select(_e197, 31i, (_e197 > 31i));
                            }
                            let _e205 = phi_341_;
                            let _e210 = (_e205 & 31i);
                            let _e220 = (bitcast<i32>(_e183) >> bitcast<u32>(31i));
                            let _e228 = bitcast<u32>(select(_e154.member.y, _e135.member.y, (_e135.member.y < _e154.member.y)));
                            let _e231 = ((_e228 >> bitcast<u32>(23i)) & 255u);
                            let _e233 = select(0u, 1u, (_e231 != 0u));
                            let _e237 = ((_e228 & 8388607u) | (_e233 << bitcast<u32>(23i)));
                            let _e242 = (_e99 - ((bitcast<i32>(_e231) - bitcast<i32>(_e233)) + -149i));
                            let _e243 = (_e242 < 0i);
                            if _e243 {
                                phi_388_ = -(_e242);
                            } else {
                                phi_388_ = 0i;
                            }
                            let _e246 = phi_388_;
                            if _e243 {
                                phi_398_ = 0i;
                            } else {
                                phi_398_ = select(_e242, 31i, (_e242 > 31i));
                            }
                            let _e250 = phi_398_;
                            let _e255 = (_e250 & 31i);
                            let _e265 = (bitcast<i32>(_e228) >> bitcast<u32>(31i));
                            let _e273 = bitcast<u32>(select(_e154.member.z, _e135.member.z, (_e135.member.z < _e154.member.z)));
                            let _e276 = ((_e273 >> bitcast<u32>(23i)) & 255u);
                            let _e278 = select(0u, 1u, (_e276 != 0u));
                            let _e282 = ((_e273 & 8388607u) | (_e278 << bitcast<u32>(23i)));
                            let _e287 = (_e99 - ((bitcast<i32>(_e276) - bitcast<i32>(_e278)) + -149i));
                            let _e288 = (_e287 < 0i);
                            if _e288 {
                                phi_445_ = -(_e287);
                            } else {
                                phi_445_ = 0i;
                            }
                            let _e291 = phi_445_;
                            if _e288 {
                                phi_455_ = 0i;
                            } else {
                                phi_455_ = select(_e287, 31i, (_e287 > 31i));
                            }
                            let _e295 = phi_455_;
                            let _e300 = (_e295 & 31i);
                            let _e310 = (bitcast<i32>(_e273) >> bitcast<u32>(31i));
                            let _e319 = bitcast<u32>(-(select(_e154.member_1.x, _e135.member_1.x, (_e135.member_1.x > _e154.member_1.x))));
                            let _e322 = ((_e319 >> bitcast<u32>(23i)) & 255u);
                            let _e324 = select(0u, 1u, (_e322 != 0u));
                            let _e328 = ((_e319 & 8388607u) | (_e324 << bitcast<u32>(23i)));
                            let _e333 = (_e99 - ((bitcast<i32>(_e322) - bitcast<i32>(_e324)) + -149i));
                            let _e334 = (_e333 < 0i);
                            if _e334 {
                                phi_504_ = -(_e333);
                            } else {
                                phi_504_ = 0i;
                            }
                            let _e337 = phi_504_;
                            if _e334 {
                                phi_514_ = 0i;
                            } else {
                                phi_514_ = select(_e333, 31i, (_e333 > 31i));
                            }
                            let _e341 = phi_514_;
                            let _e346 = (_e341 & 31i);
                            let _e356 = (bitcast<i32>(_e319) >> bitcast<u32>(31i));
                            let _e366 = bitcast<u32>(-(select(_e154.member_1.y, _e135.member_1.y, (_e135.member_1.y > _e154.member_1.y))));
                            let _e369 = ((_e366 >> bitcast<u32>(23i)) & 255u);
                            let _e371 = select(0u, 1u, (_e369 != 0u));
                            let _e375 = ((_e366 & 8388607u) | (_e371 << bitcast<u32>(23i)));
                            let _e380 = (_e99 - ((bitcast<i32>(_e369) - bitcast<i32>(_e371)) + -149i));
                            let _e381 = (_e380 < 0i);
                            if _e381 {
                                phi_563_ = -(_e380);
                            } else {
                                phi_563_ = 0i;
                            }
                            let _e384 = phi_563_;
                            if _e381 {
                                phi_573_ = 0i;
                            } else {
                                phi_573_ = select(_e380, 31i, (_e380 > 31i));
                            }
                            let _e388 = phi_573_;
                            let _e393 = (_e388 & 31i);
                            let _e403 = (bitcast<i32>(_e366) >> bitcast<u32>(31i));
                            let _e413 = bitcast<u32>(-(select(_e154.member_1.z, _e135.member_1.z, (_e135.member_1.z > _e154.member_1.z))));
                            let _e416 = ((_e413 >> bitcast<u32>(23i)) & 255u);
                            let _e418 = select(0u, 1u, (_e416 != 0u));
                            let _e422 = ((_e413 & 8388607u) | (_e418 << bitcast<u32>(23i)));
                            let _e427 = (_e99 - ((bitcast<i32>(_e416) - bitcast<i32>(_e418)) + -149i));
                            let _e428 = (_e427 < 0i);
                            if _e428 {
                                phi_622_ = -(_e427);
                            } else {
                                phi_622_ = 0i;
                            }
                            let _e431 = phi_622_;
                            if _e428 {
                                phi_632_ = 0i;
                            } else {
                                phi_632_ = select(_e427, 31i, (_e427 > 31i));
                            }
                            let _e435 = phi_632_;
                            let _e440 = (_e435 & 31i);
                            let _e450 = (bitcast<i32>(_e413) >> bitcast<u32>(31i));
                            local_11 = array<i32, 3>((((bitcast<i32>(((_e192 << bitcast<u32>((bitcast<u32>(_e201) & 31u))) >> bitcast<u32>(_e210))) + select(0i, 1i, (((_e192 & ((1u << bitcast<u32>(_e210)) - 1u)) != 0u) && (_e220 != 0i)))) ^ _e220) - _e220), (((bitcast<i32>(((_e237 << bitcast<u32>((bitcast<u32>(_e246) & 31u))) >> bitcast<u32>(_e255))) + select(0i, 1i, (((_e237 & ((1u << bitcast<u32>(_e255)) - 1u)) != 0u) && (_e265 != 0i)))) ^ _e265) - _e265), (((bitcast<i32>(((_e282 << bitcast<u32>((bitcast<u32>(_e291) & 31u))) >> bitcast<u32>(_e300))) + select(0i, 1i, (((_e282 & ((1u << bitcast<u32>(_e300)) - 1u)) != 0u) && (_e310 != 0i)))) ^ _e310) - _e310));
                            local_10 = array<i32, 3>(-((((bitcast<i32>(((_e328 << bitcast<u32>((bitcast<u32>(_e337) & 31u))) >> bitcast<u32>(_e346))) + select(0i, 1i, (((_e328 & ((1u << bitcast<u32>(_e346)) - 1u)) != 0u) && (_e356 != 0i)))) ^ _e356) - _e356)), -((((bitcast<i32>(((_e375 << bitcast<u32>((bitcast<u32>(_e384) & 31u))) >> bitcast<u32>(_e393))) + select(0i, 1i, (((_e375 & ((1u << bitcast<u32>(_e393)) - 1u)) != 0u) && (_e403 != 0i)))) ^ _e403) - _e403)), -((((bitcast<i32>(((_e422 << bitcast<u32>((bitcast<u32>(_e431) & 31u))) >> bitcast<u32>(_e440))) + select(0i, 1i, (((_e422 & ((1u << bitcast<u32>(_e440)) - 1u)) != 0u) && (_e450 != 0i)))) ^ _e450) - _e450)));
                            phi_3764_ = false;
                            phi_676_ = type_8(0u, 128u);
                            phi_679_ = 0u;
                            loop {
                                let _e462 = phi_3764_;
                                let _e464 = phi_676_;
                                let _e466 = phi_679_;
                                if (_e464.member < _e464.member_1) {
                                    phi_677_ = type_8((_e464.member + 1u), _e464.member_1);
                                    phi_702_ = type_8(1u, _e464.member);
                                } else {
                                    phi_677_ = _e464;
                                    phi_702_ = type_8(0u, type_8().member_1);
                                }
                                let _e479 = phi_677_;
                                let _e481 = phi_702_;
                                if (bitcast<i32>(_e481.member) != 0i) {
                                    let _e485 = (_e466 == _e103);
                                    if _e485 {
                                        phi_3823_ = _e462;
                                        phi_1953_ = u32();
                                    } else {
                                        let _e486 = (_e466 < _e74);
                                        if _e486 {
                                            if _e486 {
                                            } else {
                                                phi_3821_ = true;
                                                break;
                                            }
                                            let _e489 = global_4.member[_e466];
                                            phi_724_ = _e489;
                                        } else {
                                            phi_724_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e491 = phi_724_;
                                        if ((_e491.member_1 & 2147483648u) != 0u) {
                                            phi_732_ = false;
                                        } else {
                                            phi_732_ = (_e103 <= _e491.member_1);
                                        }
                                        let _e497 = phi_732_;
                                        if (_e491.member_1 == 2147483648u) {
                                            phi_750_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_750_ = type_27(vec3<f32>(_e491.member[0][0], _e491.member[1][0], _e491.member[2][0]), vec3<f32>(_e491.member[0][2], _e491.member[1][2], _e491.member[2][2]));
                                        }
                                        let _e515 = phi_750_;
                                        if (_e491.member_2 == 2147483648u) {
                                            phi_768_ = _e515;
                                        } else {
                                            phi_768_ = type_27(vec3<f32>(_e491.member[0][1], _e491.member[1][1], _e491.member[2][1]), vec3<f32>(_e491.member[0][3], _e491.member[1][3], _e491.member[2][3]));
                                        }
                                        let _e534 = phi_768_;
                                        let _e547 = bitcast<u32>(_e515.member.x);
                                        let _e550 = ((_e547 >> bitcast<u32>(23i)) & 255u);
                                        let _e552 = select(0u, 1u, (_e550 != 0u));
                                        let _e556 = ((_e547 & 8388607u) | (_e552 << bitcast<u32>(23i)));
                                        let _e561 = (_e99 - ((bitcast<i32>(_e550) - bitcast<i32>(_e552)) + -149i));
                                        let _e562 = (_e561 < 0i);
                                        if _e562 {
                                            phi_795_ = -(_e561);
                                        } else {
                                            phi_795_ = 0i;
                                        }
                                        let _e565 = phi_795_;
                                        if _e562 {
                                            phi_805_ = 0i;
                                        } else {
                                            phi_805_ = select(_e561, 31i, (_e561 > 31i));
                                        }
                                        let _e569 = phi_805_;
                                        let _e574 = (_e569 & 31i);
                                        let _e584 = (bitcast<i32>(_e547) >> bitcast<u32>(31i));
                                        let _e592 = bitcast<u32>(_e515.member.y);
                                        let _e595 = ((_e592 >> bitcast<u32>(23i)) & 255u);
                                        let _e597 = select(0u, 1u, (_e595 != 0u));
                                        let _e601 = ((_e592 & 8388607u) | (_e597 << bitcast<u32>(23i)));
                                        let _e606 = (_e99 - ((bitcast<i32>(_e595) - bitcast<i32>(_e597)) + -149i));
                                        let _e607 = (_e606 < 0i);
                                        if _e607 {
                                            phi_852_ = -(_e606);
                                        } else {
                                            phi_852_ = 0i;
                                        }
                                        let _e610 = phi_852_;
                                        if _e607 {
                                            phi_862_ = 0i;
                                        } else {
                                            phi_862_ = select(_e606, 31i, (_e606 > 31i));
                                        }
                                        let _e614 = phi_862_;
                                        let _e619 = (_e614 & 31i);
                                        let _e629 = (bitcast<i32>(_e592) >> bitcast<u32>(31i));
                                        let _e637 = bitcast<u32>(_e515.member.z);
                                        let _e640 = ((_e637 >> bitcast<u32>(23i)) & 255u);
                                        let _e642 = select(0u, 1u, (_e640 != 0u));
                                        let _e646 = ((_e637 & 8388607u) | (_e642 << bitcast<u32>(23i)));
                                        let _e651 = (_e99 - ((bitcast<i32>(_e640) - bitcast<i32>(_e642)) + -149i));
                                        let _e652 = (_e651 < 0i);
                                        if _e652 {
                                            phi_909_ = -(_e651);
                                        } else {
                                            phi_909_ = 0i;
                                        }
                                        let _e655 = phi_909_;
                                        if _e652 {
                                            phi_919_ = 0i;
                                        } else {
                                            phi_919_ = select(_e651, 31i, (_e651 > 31i));
                                        }
                                        let _e659 = phi_919_;
                                        let _e664 = (_e659 & 31i);
                                        let _e674 = (bitcast<i32>(_e637) >> bitcast<u32>(31i));
                                        let _e683 = bitcast<u32>(-(_e515.member_1.x));
                                        let _e686 = ((_e683 >> bitcast<u32>(23i)) & 255u);
                                        let _e688 = select(0u, 1u, (_e686 != 0u));
                                        let _e692 = ((_e683 & 8388607u) | (_e688 << bitcast<u32>(23i)));
                                        let _e697 = (_e99 - ((bitcast<i32>(_e686) - bitcast<i32>(_e688)) + -149i));
                                        let _e698 = (_e697 < 0i);
                                        if _e698 {
                                            phi_968_ = -(_e697);
                                        } else {
                                            phi_968_ = 0i;
                                        }
                                        let _e701 = phi_968_;
                                        if _e698 {
                                            phi_978_ = 0i;
                                        } else {
                                            phi_978_ = select(_e697, 31i, (_e697 > 31i));
                                        }
                                        let _e705 = phi_978_;
                                        let _e710 = (_e705 & 31i);
                                        let _e720 = (bitcast<i32>(_e683) >> bitcast<u32>(31i));
                                        let _e730 = bitcast<u32>(-(_e515.member_1.y));
                                        let _e733 = ((_e730 >> bitcast<u32>(23i)) & 255u);
                                        let _e735 = select(0u, 1u, (_e733 != 0u));
                                        let _e739 = ((_e730 & 8388607u) | (_e735 << bitcast<u32>(23i)));
                                        let _e744 = (_e99 - ((bitcast<i32>(_e733) - bitcast<i32>(_e735)) + -149i));
                                        let _e745 = (_e744 < 0i);
                                        if _e745 {
                                            phi_1027_ = -(_e744);
                                        } else {
                                            phi_1027_ = 0i;
                                        }
                                        let _e748 = phi_1027_;
                                        if _e745 {
                                            phi_1037_ = 0i;
                                        } else {
                                            phi_1037_ = select(_e744, 31i, (_e744 > 31i));
                                        }
                                        let _e752 = phi_1037_;
                                        let _e757 = (_e752 & 31i);
                                        let _e767 = (bitcast<i32>(_e730) >> bitcast<u32>(31i));
                                        let _e777 = bitcast<u32>(-(_e515.member_1.z));
                                        let _e780 = ((_e777 >> bitcast<u32>(23i)) & 255u);
                                        let _e782 = select(0u, 1u, (_e780 != 0u));
                                        let _e786 = ((_e777 & 8388607u) | (_e782 << bitcast<u32>(23i)));
                                        let _e791 = (_e99 - ((bitcast<i32>(_e780) - bitcast<i32>(_e782)) + -149i));
                                        let _e792 = (_e791 < 0i);
                                        if _e792 {
                                            phi_1086_ = -(_e791);
                                        } else {
                                            phi_1086_ = 0i;
                                        }
                                        let _e795 = phi_1086_;
                                        if _e792 {
                                            phi_1096_ = 0i;
                                        } else {
                                            phi_1096_ = select(_e791, 31i, (_e791 > 31i));
                                        }
                                        let _e799 = phi_1096_;
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
                                            phi_1163_ = -(_e851);
                                        } else {
                                            phi_1163_ = 0i;
                                        }
                                        let _e855 = phi_1163_;
                                        if _e852 {
                                            phi_1173_ = 0i;
                                        } else {
                                            phi_1173_ = select(_e851, 31i, (_e851 > 31i));
                                        }
                                        let _e859 = phi_1173_;
                                        let _e864 = (_e859 & 31i);
                                        let _e874 = (bitcast<i32>(_e837) >> bitcast<u32>(31i));
                                        let _e882 = bitcast<u32>(_e534.member.y);
                                        let _e885 = ((_e882 >> bitcast<u32>(23i)) & 255u);
                                        let _e887 = select(0u, 1u, (_e885 != 0u));
                                        let _e891 = ((_e882 & 8388607u) | (_e887 << bitcast<u32>(23i)));
                                        let _e896 = (_e99 - ((bitcast<i32>(_e885) - bitcast<i32>(_e887)) + -149i));
                                        let _e897 = (_e896 < 0i);
                                        if _e897 {
                                            phi_1220_ = -(_e896);
                                        } else {
                                            phi_1220_ = 0i;
                                        }
                                        let _e900 = phi_1220_;
                                        if _e897 {
                                            phi_1230_ = 0i;
                                        } else {
                                            phi_1230_ = select(_e896, 31i, (_e896 > 31i));
                                        }
                                        let _e904 = phi_1230_;
                                        let _e909 = (_e904 & 31i);
                                        let _e919 = (bitcast<i32>(_e882) >> bitcast<u32>(31i));
                                        let _e927 = bitcast<u32>(_e534.member.z);
                                        let _e930 = ((_e927 >> bitcast<u32>(23i)) & 255u);
                                        let _e932 = select(0u, 1u, (_e930 != 0u));
                                        let _e936 = ((_e927 & 8388607u) | (_e932 << bitcast<u32>(23i)));
                                        let _e941 = (_e99 - ((bitcast<i32>(_e930) - bitcast<i32>(_e932)) + -149i));
                                        let _e942 = (_e941 < 0i);
                                        if _e942 {
                                            phi_1277_ = -(_e941);
                                        } else {
                                            phi_1277_ = 0i;
                                        }
                                        let _e945 = phi_1277_;
                                        if _e942 {
                                            phi_1287_ = 0i;
                                        } else {
                                            phi_1287_ = select(_e941, 31i, (_e941 > 31i));
                                        }
                                        let _e949 = phi_1287_;
                                        let _e954 = (_e949 & 31i);
                                        let _e964 = (bitcast<i32>(_e927) >> bitcast<u32>(31i));
                                        let _e973 = bitcast<u32>(-(_e534.member_1.x));
                                        let _e976 = ((_e973 >> bitcast<u32>(23i)) & 255u);
                                        let _e978 = select(0u, 1u, (_e976 != 0u));
                                        let _e982 = ((_e973 & 8388607u) | (_e978 << bitcast<u32>(23i)));
                                        let _e987 = (_e99 - ((bitcast<i32>(_e976) - bitcast<i32>(_e978)) + -149i));
                                        let _e988 = (_e987 < 0i);
                                        if _e988 {
                                            phi_1336_ = -(_e987);
                                        } else {
                                            phi_1336_ = 0i;
                                        }
                                        let _e991 = phi_1336_;
                                        if _e988 {
                                            phi_1346_ = 0i;
                                        } else {
                                            phi_1346_ = select(_e987, 31i, (_e987 > 31i));
                                        }
                                        let _e995 = phi_1346_;
                                        let _e1000 = (_e995 & 31i);
                                        let _e1010 = (bitcast<i32>(_e973) >> bitcast<u32>(31i));
                                        let _e1020 = bitcast<u32>(-(_e534.member_1.y));
                                        let _e1023 = ((_e1020 >> bitcast<u32>(23i)) & 255u);
                                        let _e1025 = select(0u, 1u, (_e1023 != 0u));
                                        let _e1029 = ((_e1020 & 8388607u) | (_e1025 << bitcast<u32>(23i)));
                                        let _e1034 = (_e99 - ((bitcast<i32>(_e1023) - bitcast<i32>(_e1025)) + -149i));
                                        let _e1035 = (_e1034 < 0i);
                                        if _e1035 {
                                            phi_1395_ = -(_e1034);
                                        } else {
                                            phi_1395_ = 0i;
                                        }
                                        let _e1038 = phi_1395_;
                                        if _e1035 {
                                            phi_1405_ = 0i;
                                        } else {
                                            phi_1405_ = select(_e1034, 31i, (_e1034 > 31i));
                                        }
                                        let _e1042 = phi_1405_;
                                        let _e1047 = (_e1042 & 31i);
                                        let _e1057 = (bitcast<i32>(_e1020) >> bitcast<u32>(31i));
                                        let _e1067 = bitcast<u32>(-(_e534.member_1.z));
                                        let _e1070 = ((_e1067 >> bitcast<u32>(23i)) & 255u);
                                        let _e1072 = select(0u, 1u, (_e1070 != 0u));
                                        let _e1076 = ((_e1067 & 8388607u) | (_e1072 << bitcast<u32>(23i)));
                                        let _e1081 = (_e99 - ((bitcast<i32>(_e1070) - bitcast<i32>(_e1072)) + -149i));
                                        let _e1082 = (_e1081 < 0i);
                                        if _e1082 {
                                            phi_1454_ = -(_e1081);
                                        } else {
                                            phi_1454_ = 0i;
                                        }
                                        let _e1085 = phi_1454_;
                                        if _e1082 {
                                            phi_1464_ = 0i;
                                        } else {
                                            phi_1464_ = select(_e1081, 31i, (_e1081 > 31i));
                                        }
                                        let _e1089 = phi_1464_;
                                        let _e1094 = (_e1089 & 31i);
                                        let _e1104 = (bitcast<i32>(_e1067) >> bitcast<u32>(31i));
                                        local_13 = array<i32, 3>((((bitcast<i32>(((_e846 << bitcast<u32>((bitcast<u32>(_e855) & 31u))) >> bitcast<u32>(_e864))) + select(0i, 1i, (((_e846 & ((1u << bitcast<u32>(_e864)) - 1u)) != 0u) && (_e874 != 0i)))) ^ _e874) - _e874), (((bitcast<i32>(((_e891 << bitcast<u32>((bitcast<u32>(_e900) & 31u))) >> bitcast<u32>(_e909))) + select(0i, 1i, (((_e891 & ((1u << bitcast<u32>(_e909)) - 1u)) != 0u) && (_e919 != 0i)))) ^ _e919) - _e919), (((bitcast<i32>(((_e936 << bitcast<u32>((bitcast<u32>(_e945) & 31u))) >> bitcast<u32>(_e954))) + select(0i, 1i, (((_e936 & ((1u << bitcast<u32>(_e954)) - 1u)) != 0u) && (_e964 != 0i)))) ^ _e964) - _e964));
                                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e982 << bitcast<u32>((bitcast<u32>(_e991) & 31u))) >> bitcast<u32>(_e1000))) + select(0i, 1i, (((_e982 & ((1u << bitcast<u32>(_e1000)) - 1u)) != 0u) && (_e1010 != 0i)))) ^ _e1010) - _e1010)), -((((bitcast<i32>(((_e1029 << bitcast<u32>((bitcast<u32>(_e1038) & 31u))) >> bitcast<u32>(_e1047))) + select(0i, 1i, (((_e1029 & ((1u << bitcast<u32>(_e1047)) - 1u)) != 0u) && (_e1057 != 0i)))) ^ _e1057) - _e1057)), -((((bitcast<i32>(((_e1076 << bitcast<u32>((bitcast<u32>(_e1085) & 31u))) >> bitcast<u32>(_e1094))) + select(0i, 1i, (((_e1076 & ((1u << bitcast<u32>(_e1094)) - 1u)) != 0u) && (_e1104 != 0i)))) ^ _e1104) - _e1104)));
                                        local_21 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_1508_ = type_8(0u, 3u);
                                        loop {
                                            let _e1116 = phi_1508_;
                                            if (_e1116.member < _e1116.member_1) {
                                                phi_1509_ = type_8((_e1116.member + 1u), _e1116.member_1);
                                                phi_1532_ = type_8(1u, _e1116.member);
                                            } else {
                                                phi_1509_ = _e1116;
                                                phi_1532_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1129 = phi_1509_;
                                            let _e1131 = phi_1532_;
                                            let _e1135 = (bitcast<i32>(_e1131.member) != 0i);
                                            if _e1135 {
                                                let _e1136 = (_e1131.member_1 < 3u);
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1138 = local_11[_e1131.member_1];
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1140 = local_10[_e1131.member_1];
                                                let _e1142 = bitcast<u32>((_e1140 - _e1138));
                                                let _e1147 = select((bitcast<u32>(31i) - firstLeadingBit(_e1142)), 32u, (_e1142 == 0u));
                                                if ((32u - _e1147) > 21u) {
                                                    phi_1567_ = (11u - _e1147);
                                                } else {
                                                    phi_1567_ = 0u;
                                                }
                                                let _e1152 = phi_1567_;
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1154 = local_15[_e1131.member_1];
                                                let _e1155 = (_e1154 - _e1138);
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1157 = local_13[_e1131.member_1];
                                                let _e1158 = (_e1157 - _e1138);
                                                let _e1159 = (_e1155 > _e1158);
                                                let _e1162 = (_e1152 & 31u);
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1171 = local_14[_e1131.member_1];
                                                let _e1172 = (_e1140 - _e1171);
                                                if _e1136 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1174 = local_12[_e1131.member_1];
                                                let _e1175 = (_e1140 - _e1174);
                                                let _e1176 = (_e1172 > _e1175);
                                                let _e1186 = (_e1131.member_1 * 2u);
                                                let _e1188 = ((1u + _e1186) % 7u);
                                                if (_e1188 < 7u) {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                local_21[_e1188] = (((bitcast<u32>(select(_e1158, _e1155, _e1159)) >> bitcast<u32>(_e1162)) & 2097151u) | (select(0u, 1u, _e1159) << bitcast<u32>(21u)));
                                                let _e1192 = ((_e1186 + 2u) % 7u);
                                                if (_e1192 < 7u) {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                local_21[_e1192] = (((bitcast<u32>(select(_e1175, _e1172, _e1176)) >> bitcast<u32>(_e1162)) & 2097151u) | (select(0u, 1u, _e1176) << bitcast<u32>(21u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_1508_ = _e1129;
                                                phi_3719_ = _e462;
                                                break if !(_e1135);
                                            }
                                        }
                                        let _e1197 = phi_3719_;
                                        phi_3821_ = _e1197;
                                        if _e1197 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1706_ = type_8(0u, 3u);
                                        loop {
                                            let _e1199 = phi_1706_;
                                            if (_e1199.member < _e1199.member_1) {
                                                phi_1707_ = type_8((_e1199.member + 1u), _e1199.member_1);
                                                phi_1730_ = type_8(1u, _e1199.member);
                                            } else {
                                                phi_1707_ = _e1199;
                                                phi_1730_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1212 = phi_1707_;
                                            let _e1214 = phi_1730_;
                                            let _e1218 = (bitcast<i32>(_e1214.member) != 0i);
                                            if _e1218 {
                                                let _e1219 = (_e1214.member_1 * 2u);
                                                let _e1221 = ((1u + _e1219) % 7u);
                                                if (_e1221 < 7u) {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1224 = local_21[_e1221];
                                                let _e1226 = ((_e1219 + 2u) % 7u);
                                                if (_e1226 < 7u) {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1229 = local_21[_e1226];
                                                let _e1230 = (_e1214.member_1 < 3u);
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1232 = local_11[_e1214.member_1];
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1234 = local_10[_e1214.member_1];
                                                let _e1236 = bitcast<u32>((_e1234 - _e1232));
                                                let _e1241 = select((bitcast<u32>(31i) - firstLeadingBit(_e1236)), 32u, (_e1236 == 0u));
                                                if ((32u - _e1241) > 21u) {
                                                    phi_1842_ = (11u - _e1241);
                                                } else {
                                                    phi_1842_ = 0u;
                                                }
                                                let _e1246 = phi_1842_;
                                                let _e1248 = (_e1246 & 31u);
                                                let _e1252 = (_e1232 + bitcast<i32>(((_e1224 & 2097151u) << bitcast<u32>(_e1248))));
                                                let _e1257 = (_e1234 - bitcast<i32>(((_e1229 & 2097151u) << bitcast<u32>(_e1248))));
                                                let _e1261 = (((_e1224 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                let _e1265 = (((_e1229 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_3[_e1214.member_1] = select(_e1232, _e1252, _e1261);
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_1[_e1214.member_1] = select(_e1252, _e1232, _e1261);
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_2[_e1214.member_1] = select(_e1234, _e1257, _e1265);
                                                if _e1230 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local[_e1214.member_1] = select(_e1257, _e1234, _e1265);
                                            }
                                            continue;
                                            continuing {
                                                phi_1706_ = _e1212;
                                                phi_3804_ = _e1197;
                                                break if !(_e1218);
                                            }
                                        }
                                        let _e1276 = phi_3804_;
                                        phi_3821_ = _e1276;
                                        if _e1276 {
                                            break;
                                        }
                                        let _e1277 = local;
                                        let _e1278 = local_1;
                                        let _e1279 = local_2;
                                        let _e1280 = local_3;
                                        if _e497 {
                                            phi_1935_ = type_34(array<i32, 3>(_e1280[0], _e1280[1], _e1280[2]), array<i32, 3>(_e1279[0], _e1279[1], _e1279[2]));
                                        } else {
                                            phi_1935_ = type_34(array<i32, 3>(_e1278[0], _e1278[1], _e1278[2]), array<i32, 3>(_e1277[0], _e1277[1], _e1277[2]));
                                        }
                                        let _e1300 = phi_1935_;
                                        local_11 = array<i32, 3>(_e1300.member[0], _e1300.member[1], _e1300.member[2]);
                                        local_10 = array<i32, 3>(_e1300.member_1[0], _e1300.member_1[1], _e1300.member_1[2]);
                                        phi_3823_ = _e1276;
                                        phi_1953_ = select(_e491.member_2, _e491.member_1, _e497);
                                    }
                                    let _e1313 = phi_3823_;
                                    let _e1315 = phi_1953_;
                                    phi_3822_ = _e1313;
                                    phi_680_ = _e1315;
                                    phi_1955_ = select(true, false, _e485);
                                } else {
                                    phi_3822_ = _e462;
                                    phi_680_ = u32();
                                    phi_1955_ = false;
                                }
                                let _e1318 = phi_3822_;
                                let _e1320 = phi_680_;
                                let _e1322 = phi_1955_;
                                continue;
                                continuing {
                                    phi_3764_ = _e1318;
                                    phi_676_ = _e479;
                                    phi_679_ = _e1320;
                                    phi_3821_ = _e1318;
                                    break if !(_e1322);
                                }
                            }
                            let _e1325 = phi_3821_;
                            if _e1325 {
                                break;
                            }
                            let _e1326 = local_10;
                            let _e1327 = local_11;
                            local_9 = _e1327;
                            local_8 = _e1326;
                            if _e108 {
                            } else {
                                break;
                            }
                            let _e1331 = global_4.member[_e103].member_1;
                            if (_e1331 == 2147483648u) {
                                phi_2006_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e1337 = global_4.member[_e103].member[0u];
                                let _e1342 = global_4.member[_e103].member[1u];
                                let _e1347 = global_4.member[_e103].member[2u];
                                phi_2006_ = type_27(vec3<f32>(_e1337[0], _e1342[0], _e1347[0]), vec3<f32>(_e1337[2], _e1342[2], _e1347[2]));
                            }
                            let _e1358 = phi_2006_;
                            let _e1362 = global_4.member[_e103].member_2;
                            if (_e1362 == 2147483648u) {
                                phi_2028_ = _e1358;
                            } else {
                                let _e1368 = global_4.member[_e103].member[0u];
                                let _e1373 = global_4.member[_e103].member[1u];
                                let _e1378 = global_4.member[_e103].member[2u];
                                phi_2028_ = type_27(vec3<f32>(_e1368[1], _e1373[1], _e1378[1]), vec3<f32>(_e1368[3], _e1373[3], _e1378[3]));
                            }
                            let _e1389 = phi_2028_;
                            let _e1402 = bitcast<u32>(_e1358.member.x);
                            let _e1405 = ((_e1402 >> bitcast<u32>(23i)) & 255u);
                            let _e1407 = select(0u, 1u, (_e1405 != 0u));
                            let _e1411 = ((_e1402 & 8388607u) | (_e1407 << bitcast<u32>(23i)));
                            let _e1416 = (_e99 - ((bitcast<i32>(_e1405) - bitcast<i32>(_e1407)) + -149i));
                            let _e1417 = (_e1416 < 0i);
                            if _e1417 {
                                phi_2055_ = -(_e1416);
                            } else {
                                phi_2055_ = 0i;
                            }
                            let _e1420 = phi_2055_;
                            if _e1417 {
                                phi_2065_ = 0i;
                            } else {
                                phi_2065_ = select(_e1416, 31i, (_e1416 > 31i));
                            }
                            let _e1424 = phi_2065_;
                            let _e1429 = (_e1424 & 31i);
                            let _e1439 = (bitcast<i32>(_e1402) >> bitcast<u32>(31i));
                            let _e1447 = bitcast<u32>(_e1358.member.y);
                            let _e1450 = ((_e1447 >> bitcast<u32>(23i)) & 255u);
                            let _e1452 = select(0u, 1u, (_e1450 != 0u));
                            let _e1456 = ((_e1447 & 8388607u) | (_e1452 << bitcast<u32>(23i)));
                            let _e1461 = (_e99 - ((bitcast<i32>(_e1450) - bitcast<i32>(_e1452)) + -149i));
                            let _e1462 = (_e1461 < 0i);
                            if _e1462 {
                                phi_2112_ = -(_e1461);
                            } else {
                                phi_2112_ = 0i;
                            }
                            let _e1465 = phi_2112_;
                            if _e1462 {
                                phi_2122_ = 0i;
                            } else {
                                phi_2122_ = select(_e1461, 31i, (_e1461 > 31i));
                            }
                            let _e1469 = phi_2122_;
                            let _e1474 = (_e1469 & 31i);
                            let _e1484 = (bitcast<i32>(_e1447) >> bitcast<u32>(31i));
                            let _e1492 = bitcast<u32>(_e1358.member.z);
                            let _e1495 = ((_e1492 >> bitcast<u32>(23i)) & 255u);
                            let _e1497 = select(0u, 1u, (_e1495 != 0u));
                            let _e1501 = ((_e1492 & 8388607u) | (_e1497 << bitcast<u32>(23i)));
                            let _e1506 = (_e99 - ((bitcast<i32>(_e1495) - bitcast<i32>(_e1497)) + -149i));
                            let _e1507 = (_e1506 < 0i);
                            if _e1507 {
                                phi_2169_ = -(_e1506);
                            } else {
                                phi_2169_ = 0i;
                            }
                            let _e1510 = phi_2169_;
                            if _e1507 {
                                phi_2179_ = 0i;
                            } else {
                                phi_2179_ = select(_e1506, 31i, (_e1506 > 31i));
                            }
                            let _e1514 = phi_2179_;
                            let _e1519 = (_e1514 & 31i);
                            let _e1529 = (bitcast<i32>(_e1492) >> bitcast<u32>(31i));
                            let _e1538 = bitcast<u32>(-(_e1358.member_1.x));
                            let _e1541 = ((_e1538 >> bitcast<u32>(23i)) & 255u);
                            let _e1543 = select(0u, 1u, (_e1541 != 0u));
                            let _e1547 = ((_e1538 & 8388607u) | (_e1543 << bitcast<u32>(23i)));
                            let _e1552 = (_e99 - ((bitcast<i32>(_e1541) - bitcast<i32>(_e1543)) + -149i));
                            let _e1553 = (_e1552 < 0i);
                            if _e1553 {
                                phi_2228_ = -(_e1552);
                            } else {
                                phi_2228_ = 0i;
                            }
                            let _e1556 = phi_2228_;
                            if _e1553 {
                                phi_2238_ = 0i;
                            } else {
                                phi_2238_ = select(_e1552, 31i, (_e1552 > 31i));
                            }
                            let _e1560 = phi_2238_;
                            let _e1565 = (_e1560 & 31i);
                            let _e1575 = (bitcast<i32>(_e1538) >> bitcast<u32>(31i));
                            let _e1585 = bitcast<u32>(-(_e1358.member_1.y));
                            let _e1588 = ((_e1585 >> bitcast<u32>(23i)) & 255u);
                            let _e1590 = select(0u, 1u, (_e1588 != 0u));
                            let _e1594 = ((_e1585 & 8388607u) | (_e1590 << bitcast<u32>(23i)));
                            let _e1599 = (_e99 - ((bitcast<i32>(_e1588) - bitcast<i32>(_e1590)) + -149i));
                            let _e1600 = (_e1599 < 0i);
                            if _e1600 {
                                phi_2287_ = -(_e1599);
                            } else {
                                phi_2287_ = 0i;
                            }
                            let _e1603 = phi_2287_;
                            if _e1600 {
                                phi_2297_ = 0i;
                            } else {
                                phi_2297_ = select(_e1599, 31i, (_e1599 > 31i));
                            }
                            let _e1607 = phi_2297_;
                            let _e1612 = (_e1607 & 31i);
                            let _e1622 = (bitcast<i32>(_e1585) >> bitcast<u32>(31i));
                            let _e1632 = bitcast<u32>(-(_e1358.member_1.z));
                            let _e1635 = ((_e1632 >> bitcast<u32>(23i)) & 255u);
                            let _e1637 = select(0u, 1u, (_e1635 != 0u));
                            let _e1641 = ((_e1632 & 8388607u) | (_e1637 << bitcast<u32>(23i)));
                            let _e1646 = (_e99 - ((bitcast<i32>(_e1635) - bitcast<i32>(_e1637)) + -149i));
                            let _e1647 = (_e1646 < 0i);
                            if _e1647 {
                                phi_2346_ = -(_e1646);
                            } else {
                                phi_2346_ = 0i;
                            }
                            let _e1650 = phi_2346_;
                            if _e1647 {
                                phi_2356_ = 0i;
                            } else {
                                phi_2356_ = select(_e1646, 31i, (_e1646 > 31i));
                            }
                            let _e1654 = phi_2356_;
                            let _e1659 = (_e1654 & 31i);
                            let _e1669 = (bitcast<i32>(_e1632) >> bitcast<u32>(31i));
                            local_19 = array<i32, 3>((((bitcast<i32>(((_e1411 << bitcast<u32>((bitcast<u32>(_e1420) & 31u))) >> bitcast<u32>(_e1429))) + select(0i, 1i, (((_e1411 & ((1u << bitcast<u32>(_e1429)) - 1u)) != 0u) && (_e1439 != 0i)))) ^ _e1439) - _e1439), (((bitcast<i32>(((_e1456 << bitcast<u32>((bitcast<u32>(_e1465) & 31u))) >> bitcast<u32>(_e1474))) + select(0i, 1i, (((_e1456 & ((1u << bitcast<u32>(_e1474)) - 1u)) != 0u) && (_e1484 != 0i)))) ^ _e1484) - _e1484), (((bitcast<i32>(((_e1501 << bitcast<u32>((bitcast<u32>(_e1510) & 31u))) >> bitcast<u32>(_e1519))) + select(0i, 1i, (((_e1501 & ((1u << bitcast<u32>(_e1519)) - 1u)) != 0u) && (_e1529 != 0i)))) ^ _e1529) - _e1529));
                            local_18 = array<i32, 3>(-((((bitcast<i32>(((_e1547 << bitcast<u32>((bitcast<u32>(_e1556) & 31u))) >> bitcast<u32>(_e1565))) + select(0i, 1i, (((_e1547 & ((1u << bitcast<u32>(_e1565)) - 1u)) != 0u) && (_e1575 != 0i)))) ^ _e1575) - _e1575)), -((((bitcast<i32>(((_e1594 << bitcast<u32>((bitcast<u32>(_e1603) & 31u))) >> bitcast<u32>(_e1612))) + select(0i, 1i, (((_e1594 & ((1u << bitcast<u32>(_e1612)) - 1u)) != 0u) && (_e1622 != 0i)))) ^ _e1622) - _e1622)), -((((bitcast<i32>(((_e1641 << bitcast<u32>((bitcast<u32>(_e1650) & 31u))) >> bitcast<u32>(_e1659))) + select(0i, 1i, (((_e1641 & ((1u << bitcast<u32>(_e1659)) - 1u)) != 0u) && (_e1669 != 0i)))) ^ _e1669) - _e1669)));
                            let _e1692 = bitcast<u32>(_e1389.member.x);
                            let _e1695 = ((_e1692 >> bitcast<u32>(23i)) & 255u);
                            let _e1697 = select(0u, 1u, (_e1695 != 0u));
                            let _e1701 = ((_e1692 & 8388607u) | (_e1697 << bitcast<u32>(23i)));
                            let _e1706 = (_e99 - ((bitcast<i32>(_e1695) - bitcast<i32>(_e1697)) + -149i));
                            let _e1707 = (_e1706 < 0i);
                            if _e1707 {
                                phi_2423_ = -(_e1706);
                            } else {
                                phi_2423_ = 0i;
                            }
                            let _e1710 = phi_2423_;
                            if _e1707 {
                                phi_2433_ = 0i;
                            } else {
                                phi_2433_ = select(_e1706, 31i, (_e1706 > 31i));
                            }
                            let _e1714 = phi_2433_;
                            let _e1719 = (_e1714 & 31i);
                            let _e1729 = (bitcast<i32>(_e1692) >> bitcast<u32>(31i));
                            let _e1737 = bitcast<u32>(_e1389.member.y);
                            let _e1740 = ((_e1737 >> bitcast<u32>(23i)) & 255u);
                            let _e1742 = select(0u, 1u, (_e1740 != 0u));
                            let _e1746 = ((_e1737 & 8388607u) | (_e1742 << bitcast<u32>(23i)));
                            let _e1751 = (_e99 - ((bitcast<i32>(_e1740) - bitcast<i32>(_e1742)) + -149i));
                            let _e1752 = (_e1751 < 0i);
                            if _e1752 {
                                phi_2480_ = -(_e1751);
                            } else {
                                phi_2480_ = 0i;
                            }
                            let _e1755 = phi_2480_;
                            if _e1752 {
                                phi_2490_ = 0i;
                            } else {
                                phi_2490_ = select(_e1751, 31i, (_e1751 > 31i));
                            }
                            let _e1759 = phi_2490_;
                            let _e1764 = (_e1759 & 31i);
                            let _e1774 = (bitcast<i32>(_e1737) >> bitcast<u32>(31i));
                            let _e1782 = bitcast<u32>(_e1389.member.z);
                            let _e1785 = ((_e1782 >> bitcast<u32>(23i)) & 255u);
                            let _e1787 = select(0u, 1u, (_e1785 != 0u));
                            let _e1791 = ((_e1782 & 8388607u) | (_e1787 << bitcast<u32>(23i)));
                            let _e1796 = (_e99 - ((bitcast<i32>(_e1785) - bitcast<i32>(_e1787)) + -149i));
                            let _e1797 = (_e1796 < 0i);
                            if _e1797 {
                                phi_2537_ = -(_e1796);
                            } else {
                                phi_2537_ = 0i;
                            }
                            let _e1800 = phi_2537_;
                            if _e1797 {
                                phi_2547_ = 0i;
                            } else {
                                phi_2547_ = select(_e1796, 31i, (_e1796 > 31i));
                            }
                            let _e1804 = phi_2547_;
                            let _e1809 = (_e1804 & 31i);
                            let _e1819 = (bitcast<i32>(_e1782) >> bitcast<u32>(31i));
                            let _e1828 = bitcast<u32>(-(_e1389.member_1.x));
                            let _e1831 = ((_e1828 >> bitcast<u32>(23i)) & 255u);
                            let _e1833 = select(0u, 1u, (_e1831 != 0u));
                            let _e1837 = ((_e1828 & 8388607u) | (_e1833 << bitcast<u32>(23i)));
                            let _e1842 = (_e99 - ((bitcast<i32>(_e1831) - bitcast<i32>(_e1833)) + -149i));
                            let _e1843 = (_e1842 < 0i);
                            if _e1843 {
                                phi_2596_ = -(_e1842);
                            } else {
                                phi_2596_ = 0i;
                            }
                            let _e1846 = phi_2596_;
                            if _e1843 {
                                phi_2606_ = 0i;
                            } else {
                                phi_2606_ = select(_e1842, 31i, (_e1842 > 31i));
                            }
                            let _e1850 = phi_2606_;
                            let _e1855 = (_e1850 & 31i);
                            let _e1865 = (bitcast<i32>(_e1828) >> bitcast<u32>(31i));
                            let _e1875 = bitcast<u32>(-(_e1389.member_1.y));
                            let _e1878 = ((_e1875 >> bitcast<u32>(23i)) & 255u);
                            let _e1880 = select(0u, 1u, (_e1878 != 0u));
                            let _e1884 = ((_e1875 & 8388607u) | (_e1880 << bitcast<u32>(23i)));
                            let _e1889 = (_e99 - ((bitcast<i32>(_e1878) - bitcast<i32>(_e1880)) + -149i));
                            let _e1890 = (_e1889 < 0i);
                            if _e1890 {
                                phi_2655_ = -(_e1889);
                            } else {
                                phi_2655_ = 0i;
                            }
                            let _e1893 = phi_2655_;
                            if _e1890 {
                                phi_2665_ = 0i;
                            } else {
                                phi_2665_ = select(_e1889, 31i, (_e1889 > 31i));
                            }
                            let _e1897 = phi_2665_;
                            let _e1902 = (_e1897 & 31i);
                            let _e1912 = (bitcast<i32>(_e1875) >> bitcast<u32>(31i));
                            let _e1922 = bitcast<u32>(-(_e1389.member_1.z));
                            let _e1925 = ((_e1922 >> bitcast<u32>(23i)) & 255u);
                            let _e1927 = select(0u, 1u, (_e1925 != 0u));
                            let _e1931 = ((_e1922 & 8388607u) | (_e1927 << bitcast<u32>(23i)));
                            let _e1936 = (_e99 - ((bitcast<i32>(_e1925) - bitcast<i32>(_e1927)) + -149i));
                            let _e1937 = (_e1936 < 0i);
                            if _e1937 {
                                phi_2714_ = -(_e1936);
                            } else {
                                phi_2714_ = 0i;
                            }
                            let _e1940 = phi_2714_;
                            if _e1937 {
                                phi_2724_ = 0i;
                            } else {
                                phi_2724_ = select(_e1936, 31i, (_e1936 > 31i));
                            }
                            let _e1944 = phi_2724_;
                            let _e1949 = (_e1944 & 31i);
                            let _e1959 = (bitcast<i32>(_e1922) >> bitcast<u32>(31i));
                            local_17 = array<i32, 3>((((bitcast<i32>(((_e1701 << bitcast<u32>((bitcast<u32>(_e1710) & 31u))) >> bitcast<u32>(_e1719))) + select(0i, 1i, (((_e1701 & ((1u << bitcast<u32>(_e1719)) - 1u)) != 0u) && (_e1729 != 0i)))) ^ _e1729) - _e1729), (((bitcast<i32>(((_e1746 << bitcast<u32>((bitcast<u32>(_e1755) & 31u))) >> bitcast<u32>(_e1764))) + select(0i, 1i, (((_e1746 & ((1u << bitcast<u32>(_e1764)) - 1u)) != 0u) && (_e1774 != 0i)))) ^ _e1774) - _e1774), (((bitcast<i32>(((_e1791 << bitcast<u32>((bitcast<u32>(_e1800) & 31u))) >> bitcast<u32>(_e1809))) + select(0i, 1i, (((_e1791 & ((1u << bitcast<u32>(_e1809)) - 1u)) != 0u) && (_e1819 != 0i)))) ^ _e1819) - _e1819));
                            local_16 = array<i32, 3>(-((((bitcast<i32>(((_e1837 << bitcast<u32>((bitcast<u32>(_e1846) & 31u))) >> bitcast<u32>(_e1855))) + select(0i, 1i, (((_e1837 & ((1u << bitcast<u32>(_e1855)) - 1u)) != 0u) && (_e1865 != 0i)))) ^ _e1865) - _e1865)), -((((bitcast<i32>(((_e1884 << bitcast<u32>((bitcast<u32>(_e1893) & 31u))) >> bitcast<u32>(_e1902))) + select(0i, 1i, (((_e1884 & ((1u << bitcast<u32>(_e1902)) - 1u)) != 0u) && (_e1912 != 0i)))) ^ _e1912) - _e1912)), -((((bitcast<i32>(((_e1931 << bitcast<u32>((bitcast<u32>(_e1940) & 31u))) >> bitcast<u32>(_e1949))) + select(0i, 1i, (((_e1931 & ((1u << bitcast<u32>(_e1949)) - 1u)) != 0u) && (_e1959 != 0i)))) ^ _e1959) - _e1959)));
                            local_20 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                            phi_2768_ = type_8(0u, 3u);
                            loop {
                                let _e1971 = phi_2768_;
                                if (_e1971.member < _e1971.member_1) {
                                    phi_2769_ = type_8((_e1971.member + 1u), _e1971.member_1);
                                    phi_2792_ = type_8(1u, _e1971.member);
                                } else {
                                    phi_2769_ = _e1971;
                                    phi_2792_ = type_8(0u, type_8().member_1);
                                }
                                let _e1984 = phi_2769_;
                                let _e1986 = phi_2792_;
                                let _e1990 = (bitcast<i32>(_e1986.member) != 0i);
                                if _e1990 {
                                    let _e1991 = (_e1986.member_1 < 3u);
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e1993 = local_9[_e1986.member_1];
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e1995 = local_8[_e1986.member_1];
                                    let _e1997 = bitcast<u32>((_e1995 - _e1993));
                                    let _e2002 = select((bitcast<u32>(31i) - firstLeadingBit(_e1997)), 32u, (_e1997 == 0u));
                                    if ((32u - _e2002) > 21u) {
                                        phi_2827_ = (11u - _e2002);
                                    } else {
                                        phi_2827_ = 0u;
                                    }
                                    let _e2007 = phi_2827_;
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2009 = local_19[_e1986.member_1];
                                    let _e2010 = (_e2009 - _e1993);
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2012 = local_17[_e1986.member_1];
                                    let _e2013 = (_e2012 - _e1993);
                                    let _e2014 = (_e2010 > _e2013);
                                    let _e2017 = (_e2007 & 31u);
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2026 = local_18[_e1986.member_1];
                                    let _e2027 = (_e1995 - _e2026);
                                    if _e1991 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2029 = local_16[_e1986.member_1];
                                    let _e2030 = (_e1995 - _e2029);
                                    let _e2031 = (_e2027 > _e2030);
                                    let _e2041 = (_e1986.member_1 * 2u);
                                    let _e2043 = ((1u + _e2041) % 7u);
                                    if (_e2043 < 7u) {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    local_20[_e2043] = (((bitcast<u32>(select(_e2013, _e2010, _e2014)) >> bitcast<u32>(_e2017)) & 2097151u) | (select(0u, 1u, _e2014) << bitcast<u32>(21u)));
                                    let _e2047 = ((_e2041 + 2u) % 7u);
                                    if (_e2047 < 7u) {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    local_20[_e2047] = (((bitcast<u32>(select(_e2030, _e2027, _e2031)) >> bitcast<u32>(_e2017)) & 2097151u) | (select(0u, 1u, _e2031) << bitcast<u32>(21u)));
                                }
                                continue;
                                continuing {
                                    phi_2768_ = _e1984;
                                    phi_3826_ = _e1325;
                                    break if !(_e1990);
                                }
                            }
                            let _e2052 = phi_3826_;
                            if _e2052 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_2966_ = type_8(0u, 3u);
                            loop {
                                let _e2054 = phi_2966_;
                                if (_e2054.member < _e2054.member_1) {
                                    phi_2967_ = type_8((_e2054.member + 1u), _e2054.member_1);
                                    phi_2990_ = type_8(1u, _e2054.member);
                                } else {
                                    phi_2967_ = _e2054;
                                    phi_2990_ = type_8(0u, type_8().member_1);
                                }
                                let _e2067 = phi_2967_;
                                let _e2069 = phi_2990_;
                                let _e2073 = (bitcast<i32>(_e2069.member) != 0i);
                                if _e2073 {
                                    let _e2074 = (_e2069.member_1 * 2u);
                                    let _e2076 = ((1u + _e2074) % 7u);
                                    if (_e2076 < 7u) {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2079 = local_20[_e2076];
                                    let _e2081 = ((_e2074 + 2u) % 7u);
                                    if (_e2081 < 7u) {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2084 = local_20[_e2081];
                                    let _e2085 = (_e2069.member_1 < 3u);
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2087 = local_9[_e2069.member_1];
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2089 = local_8[_e2069.member_1];
                                    let _e2091 = bitcast<u32>((_e2089 - _e2087));
                                    let _e2096 = select((bitcast<u32>(31i) - firstLeadingBit(_e2091)), 32u, (_e2091 == 0u));
                                    if ((32u - _e2096) > 21u) {
                                        phi_3102_ = (11u - _e2096);
                                    } else {
                                        phi_3102_ = 0u;
                                    }
                                    let _e2101 = phi_3102_;
                                    let _e2103 = (_e2101 & 31u);
                                    let _e2107 = (_e2087 + bitcast<i32>(((_e2079 & 2097151u) << bitcast<u32>(_e2103))));
                                    let _e2112 = (_e2089 - bitcast<i32>(((_e2084 & 2097151u) << bitcast<u32>(_e2103))));
                                    let _e2116 = (((_e2079 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e2120 = (((_e2084 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_7[_e2069.member_1] = select(_e2087, _e2107, _e2116);
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_5[_e2069.member_1] = select(_e2107, _e2087, _e2116);
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_6[_e2069.member_1] = select(_e2089, _e2112, _e2120);
                                    if _e2085 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_4[_e2069.member_1] = select(_e2112, _e2089, _e2120);
                                }
                                continue;
                                continuing {
                                    phi_2966_ = _e2067;
                                    phi_3878_ = _e2052;
                                    break if !(_e2073);
                                }
                            }
                            let _e2131 = phi_3878_;
                            if _e2131 {
                                break;
                            }
                            let _e2132 = local_4;
                            let _e2133 = local_5;
                            let _e2134 = local_6;
                            let _e2135 = local_7;
                            let _e2136 = local_20;
                            if _e109 {
                            } else {
                                break;
                            }
                            global_8.member[_e103] = array<u32, 7>(_e2136[0], _e2136[1], _e2136[2], _e2136[3], _e2136[4], _e2136[5], _e2136[6]);
                            if _e110 {
                            } else {
                                break;
                            }
                            global_5.member[_e103] = type_34(array<i32, 3>(_e1327[0], _e1327[1], _e1327[2]), array<i32, 3>(_e1326[0], _e1326[1], _e1326[2]));
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e1331 & 2147483648u) != 0u) {
                                let _e2178 = ((bitcast<u32>((_e2134[0] - _e2135[0])) | bitcast<u32>((_e2134[1] - _e2135[1]))) | bitcast<u32>((_e2134[2] - _e2135[2])));
                                if (_e2178 < 1024u) {
                                    phi_3345_ = 0u;
                                } else {
                                    phi_3345_ = select(2u, 1u, (_e2178 < 2097152u));
                                }
                                let _e2183 = phi_3345_;
                                switch bitcast<i32>(_e2183) {
                                    case 0: {
                                        phi_3351_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_3351_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_3351_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_3351_ = u32();
                                        break;
                                    }
                                }
                                let _e2186 = phi_3351_;
                                phi_3358_ = type_8(0u, ((_e1331 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2194 = phi_3358_;
                                    if (_e2194.member < _e2194.member_1) {
                                        phi_3359_ = type_8((_e2194.member + 1u), _e2194.member_1);
                                        phi_3382_ = type_8(1u, _e2194.member);
                                    } else {
                                        phi_3359_ = _e2194;
                                        phi_3382_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2207 = phi_3359_;
                                    let _e2209 = phi_3382_;
                                    let _e2213 = (bitcast<i32>(_e2209.member) != 0i);
                                    if _e2213 {
                                        let _e2215 = ((_e1331 & 268435455u) + _e2209.member_1);
                                        let _e2216 = (_e2215 < _e82);
                                        if _e2216 {
                                            if _e2216 {
                                            } else {
                                                phi_3895_ = true;
                                                break;
                                            }
                                            global_6.member[_e2215] = ((3u * _e2186) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3358_ = _e2207;
                                        phi_3895_ = _e2131;
                                        break if !(_e2213);
                                    }
                                }
                                let _e2220 = phi_3895_;
                                if _e2220 {
                                    break;
                                }
                                phi_3910_ = _e2220;
                            } else {
                                phi_3910_ = _e2131;
                            }
                            let _e2222 = phi_3910_;
                            if _e108 {
                            } else {
                                break;
                            }
                            if ((_e1362 & 2147483648u) != 0u) {
                                let _e2232 = ((bitcast<u32>((_e2132[0] - _e2133[0])) | bitcast<u32>((_e2132[1] - _e2133[1]))) | bitcast<u32>((_e2132[2] - _e2133[2])));
                                if (_e2232 < 1024u) {
                                    phi_3478_ = 0u;
                                } else {
                                    phi_3478_ = select(2u, 1u, (_e2232 < 2097152u));
                                }
                                let _e2237 = phi_3478_;
                                switch bitcast<i32>(_e2237) {
                                    case 0: {
                                        phi_3484_ = 1u;
                                        break;
                                    }
                                    case 1: {
                                        phi_3484_ = 2u;
                                        break;
                                    }
                                    case 2: {
                                        phi_3484_ = 3u;
                                        break;
                                    }
                                    default: {
                                        phi_3484_ = u32();
                                        break;
                                    }
                                }
                                let _e2240 = phi_3484_;
                                phi_3491_ = type_8(0u, ((_e1362 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2248 = phi_3491_;
                                    if (_e2248.member < _e2248.member_1) {
                                        phi_3492_ = type_8((_e2248.member + 1u), _e2248.member_1);
                                        phi_3515_ = type_8(1u, _e2248.member);
                                    } else {
                                        phi_3492_ = _e2248;
                                        phi_3515_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2261 = phi_3492_;
                                    let _e2263 = phi_3515_;
                                    let _e2267 = (bitcast<i32>(_e2263.member) != 0i);
                                    if _e2267 {
                                        let _e2269 = ((_e1362 & 268435455u) + _e2263.member_1);
                                        let _e2270 = (_e2269 < _e82);
                                        if _e2270 {
                                            if _e2270 {
                                            } else {
                                                phi_3903_ = true;
                                                break;
                                            }
                                            global_6.member[_e2269] = ((3u * _e2240) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3491_ = _e2261;
                                        phi_3903_ = _e2222;
                                        break if !(_e2267);
                                    }
                                }
                                let _e2274 = phi_3903_;
                                if _e2274 {
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
                                    global_7.member[0u] = type_28(array<u32, 4>(bitcast<u32>(_e1327[0]), bitcast<u32>(_e1327[1]), bitcast<u32>(_e1327[2]), bitcast<u32>(_e99)), array<u32, 4>(bitcast<u32>(_e1326[0]), bitcast<u32>(_e1326[1]), bitcast<u32>(_e1326[2]), 0u));
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
fn encode_q21_sizes(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
