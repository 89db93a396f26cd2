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
    var phi_3719_: bool;
    var phi_1706_: type_8;
    var phi_1707_: type_8;
    var phi_1730_: type_8;
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
    var phi_3826_: bool;
    var phi_2966_: type_8;
    var phi_2967_: type_8;
    var phi_2990_: type_8;
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
            let _e71 = global;
            let _e73 = arrayLength((&global_4.member));
            let _e81 = arrayLength((&global_6.member));
            let _e84 = arrayLength((&global_7.member));
            let _e87 = global_3.member[0u];
            let _e91 = global_2.member[0u];
            let _e93 = (bitcast<i32>(_e87) + bitcast<i32>(_e91));
            if (_e93 < -126i) {
                phi_183_ = -126i;
            } else {
                phi_183_ = select(_e93, 127i, (_e93 > 127i));
            }
            let _e98 = phi_183_;
            let _e102 = (_e71.x + (_e71.y * 2097152u));
            let _e105 = global_1.member[0u];
            if (_e102 < _e105) {
                let _e107 = (_e102 < _e73);
                if _e107 {
                    let _e108 = (_e102 < arrayLength((&global_8.member)));
                    if _e108 {
                        let _e109 = (_e102 < arrayLength((&global_5.member)));
                        if _e109 {
                            let _e110 = (0u < _e73);
                            if _e110 {
                                if _e110 {
                                } else {
                                    break;
                                }
                                let _e113 = global_4.member[0u];
                                phi_229_ = _e113;
                            } else {
                                phi_229_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e115 = phi_229_;
                            if (_e115.member_1 == 2147483648u) {
                                phi_247_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_247_ = type_27(vec3<f32>(_e115.member[0][0], _e115.member[1][0], _e115.member[2][0]), vec3<f32>(_e115.member[0][2], _e115.member[1][2], _e115.member[2][2]));
                            }
                            let _e134 = phi_247_;
                            if (_e115.member_2 == 2147483648u) {
                                phi_265_ = _e134;
                            } else {
                                phi_265_ = type_27(vec3<f32>(_e115.member[0][1], _e115.member[1][1], _e115.member[2][1]), vec3<f32>(_e115.member[0][3], _e115.member[1][3], _e115.member[2][3]));
                            }
                            let _e153 = phi_265_;
                            let _e182 = bitcast<u32>(select(_e153.member.x, _e134.member.x, (_e134.member.x < _e153.member.x)));
                            let _e185 = ((_e182 >> bitcast<u32>(23i)) & 255u);
                            let _e187 = select(0u, 1u, (_e185 != 0u));
                            let _e191 = ((_e182 & 8388607u) | (_e187 << bitcast<u32>(23i)));
                            let _e196 = (_e98 - ((bitcast<i32>(_e185) - bitcast<i32>(_e187)) + -149i));
                            let _e197 = (_e196 < 0i);
                            if _e197 {
                                phi_331_ = -(_e196);
                            } else {
                                phi_331_ = 0i;
                            }
                            let _e200 = phi_331_;
                            if _e197 {
                                phi_341_ = 0i;
                            } else {
                                phi_341_ = select(_e196, 31i, (_e196 > 31i));
                            }
                            let _e204 = phi_341_;
                            let _e209 = (_e204 & 31i);
                            let _e219 = (bitcast<i32>(_e182) >> bitcast<u32>(31i));
                            let _e227 = bitcast<u32>(select(_e153.member.y, _e134.member.y, (_e134.member.y < _e153.member.y)));
                            let _e230 = ((_e227 >> bitcast<u32>(23i)) & 255u);
                            let _e232 = select(0u, 1u, (_e230 != 0u));
                            let _e236 = ((_e227 & 8388607u) | (_e232 << bitcast<u32>(23i)));
                            let _e241 = (_e98 - ((bitcast<i32>(_e230) - bitcast<i32>(_e232)) + -149i));
                            let _e242 = (_e241 < 0i);
                            if _e242 {
                                phi_388_ = -(_e241);
                            } else {
                                phi_388_ = 0i;
                            }
                            let _e245 = phi_388_;
                            if _e242 {
                                phi_398_ = 0i;
                            } else {
                                phi_398_ = select(_e241, 31i, (_e241 > 31i));
                            }
                            let _e249 = phi_398_;
                            let _e254 = (_e249 & 31i);
                            let _e264 = (bitcast<i32>(_e227) >> bitcast<u32>(31i));
                            let _e272 = bitcast<u32>(select(_e153.member.z, _e134.member.z, (_e134.member.z < _e153.member.z)));
                            let _e275 = ((_e272 >> bitcast<u32>(23i)) & 255u);
                            let _e277 = select(0u, 1u, (_e275 != 0u));
                            let _e281 = ((_e272 & 8388607u) | (_e277 << bitcast<u32>(23i)));
                            let _e286 = (_e98 - ((bitcast<i32>(_e275) - bitcast<i32>(_e277)) + -149i));
                            let _e287 = (_e286 < 0i);
                            if _e287 {
                                phi_445_ = -(_e286);
                            } else {
                                phi_445_ = 0i;
                            }
                            let _e290 = phi_445_;
                            if _e287 {
                                phi_455_ = 0i;
                            } else {
                                phi_455_ = select(_e286, 31i, (_e286 > 31i));
                            }
                            let _e294 = phi_455_;
                            let _e299 = (_e294 & 31i);
                            let _e309 = (bitcast<i32>(_e272) >> bitcast<u32>(31i));
                            let _e318 = bitcast<u32>(-(select(_e153.member_1.x, _e134.member_1.x, (_e134.member_1.x > _e153.member_1.x))));
                            let _e321 = ((_e318 >> bitcast<u32>(23i)) & 255u);
                            let _e323 = select(0u, 1u, (_e321 != 0u));
                            let _e327 = ((_e318 & 8388607u) | (_e323 << bitcast<u32>(23i)));
                            let _e332 = (_e98 - ((bitcast<i32>(_e321) - bitcast<i32>(_e323)) + -149i));
                            let _e333 = (_e332 < 0i);
                            if _e333 {
                                phi_504_ = -(_e332);
                            } else {
                                phi_504_ = 0i;
                            }
                            let _e336 = phi_504_;
                            if _e333 {
                                phi_514_ = 0i;
                            } else {
                                phi_514_ = select(_e332, 31i, (_e332 > 31i));
                            }
                            let _e340 = phi_514_;
                            let _e345 = (_e340 & 31i);
                            let _e355 = (bitcast<i32>(_e318) >> bitcast<u32>(31i));
                            let _e365 = bitcast<u32>(-(select(_e153.member_1.y, _e134.member_1.y, (_e134.member_1.y > _e153.member_1.y))));
                            let _e368 = ((_e365 >> bitcast<u32>(23i)) & 255u);
                            let _e370 = select(0u, 1u, (_e368 != 0u));
                            let _e374 = ((_e365 & 8388607u) | (_e370 << bitcast<u32>(23i)));
                            let _e379 = (_e98 - ((bitcast<i32>(_e368) - bitcast<i32>(_e370)) + -149i));
                            let _e380 = (_e379 < 0i);
                            if _e380 {
                                phi_563_ = -(_e379);
                            } else {
                                phi_563_ = 0i;
                            }
                            let _e383 = phi_563_;
                            if _e380 {
                                phi_573_ = 0i;
                            } else {
                                phi_573_ = select(_e379, 31i, (_e379 > 31i));
                            }
                            let _e387 = phi_573_;
                            let _e392 = (_e387 & 31i);
                            let _e402 = (bitcast<i32>(_e365) >> bitcast<u32>(31i));
                            let _e412 = bitcast<u32>(-(select(_e153.member_1.z, _e134.member_1.z, (_e134.member_1.z > _e153.member_1.z))));
                            let _e415 = ((_e412 >> bitcast<u32>(23i)) & 255u);
                            let _e417 = select(0u, 1u, (_e415 != 0u));
                            let _e421 = ((_e412 & 8388607u) | (_e417 << bitcast<u32>(23i)));
                            let _e426 = (_e98 - ((bitcast<i32>(_e415) - bitcast<i32>(_e417)) + -149i));
                            let _e427 = (_e426 < 0i);
                            if _e427 {
                                phi_622_ = -(_e426);
                            } else {
                                phi_622_ = 0i;
                            }
                            let _e430 = phi_622_;
                            if _e427 {
                                phi_632_ = 0i;
                            } else {
                                phi_632_ = select(_e426, 31i, (_e426 > 31i));
                            }
                            let _e434 = phi_632_;
                            let _e439 = (_e434 & 31i);
                            let _e449 = (bitcast<i32>(_e412) >> bitcast<u32>(31i));
                            local_11 = array<i32, 3>((((bitcast<i32>(((_e191 << bitcast<u32>((bitcast<u32>(_e200) & 31u))) >> bitcast<u32>(_e209))) + select(0i, 1i, (((_e191 & ((1u << bitcast<u32>(_e209)) - 1u)) != 0u) && (_e219 != 0i)))) ^ _e219) - _e219), (((bitcast<i32>(((_e236 << bitcast<u32>((bitcast<u32>(_e245) & 31u))) >> bitcast<u32>(_e254))) + select(0i, 1i, (((_e236 & ((1u << bitcast<u32>(_e254)) - 1u)) != 0u) && (_e264 != 0i)))) ^ _e264) - _e264), (((bitcast<i32>(((_e281 << bitcast<u32>((bitcast<u32>(_e290) & 31u))) >> bitcast<u32>(_e299))) + select(0i, 1i, (((_e281 & ((1u << bitcast<u32>(_e299)) - 1u)) != 0u) && (_e309 != 0i)))) ^ _e309) - _e309));
                            local_10 = array<i32, 3>(-((((bitcast<i32>(((_e327 << bitcast<u32>((bitcast<u32>(_e336) & 31u))) >> bitcast<u32>(_e345))) + select(0i, 1i, (((_e327 & ((1u << bitcast<u32>(_e345)) - 1u)) != 0u) && (_e355 != 0i)))) ^ _e355) - _e355)), -((((bitcast<i32>(((_e374 << bitcast<u32>((bitcast<u32>(_e383) & 31u))) >> bitcast<u32>(_e392))) + select(0i, 1i, (((_e374 & ((1u << bitcast<u32>(_e392)) - 1u)) != 0u) && (_e402 != 0i)))) ^ _e402) - _e402)), -((((bitcast<i32>(((_e421 << bitcast<u32>((bitcast<u32>(_e430) & 31u))) >> bitcast<u32>(_e439))) + select(0i, 1i, (((_e421 & ((1u << bitcast<u32>(_e439)) - 1u)) != 0u) && (_e449 != 0i)))) ^ _e449) - _e449)));
                            phi_3764_ = false;
                            phi_676_ = type_8(0u, 128u);
                            phi_679_ = 0u;
                            loop {
                                let _e461 = phi_3764_;
                                let _e463 = phi_676_;
                                let _e465 = phi_679_;
                                if (_e463.member < _e463.member_1) {
                                    phi_677_ = type_8((_e463.member + 1u), _e463.member_1);
                                    phi_702_ = type_8(1u, _e463.member);
                                } else {
                                    phi_677_ = _e463;
                                    phi_702_ = type_8(0u, type_8().member_1);
                                }
                                let _e478 = phi_677_;
                                let _e480 = phi_702_;
                                if (bitcast<i32>(_e480.member) != 0i) {
                                    let _e484 = (_e465 == _e102);
                                    if _e484 {
                                        phi_3823_ = _e461;
                                        phi_1953_ = u32();
                                    } else {
                                        let _e485 = (_e465 < _e73);
                                        if _e485 {
                                            if _e485 {
                                            } else {
                                                phi_3821_ = true;
                                                break;
                                            }
                                            let _e488 = global_4.member[_e465];
                                            phi_724_ = _e488;
                                        } else {
                                            phi_724_ = type_22(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e490 = phi_724_;
                                        if ((_e490.member_1 & 2147483648u) != 0u) {
                                            phi_732_ = false;
                                        } else {
                                            phi_732_ = (_e102 <= _e490.member_1);
                                        }
                                        let _e496 = phi_732_;
                                        if (_e490.member_1 == 2147483648u) {
                                            phi_750_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_750_ = type_27(vec3<f32>(_e490.member[0][0], _e490.member[1][0], _e490.member[2][0]), vec3<f32>(_e490.member[0][2], _e490.member[1][2], _e490.member[2][2]));
                                        }
                                        let _e514 = phi_750_;
                                        if (_e490.member_2 == 2147483648u) {
                                            phi_768_ = _e514;
                                        } else {
                                            phi_768_ = type_27(vec3<f32>(_e490.member[0][1], _e490.member[1][1], _e490.member[2][1]), vec3<f32>(_e490.member[0][3], _e490.member[1][3], _e490.member[2][3]));
                                        }
                                        let _e533 = phi_768_;
                                        let _e546 = bitcast<u32>(_e514.member.x);
                                        let _e549 = ((_e546 >> bitcast<u32>(23i)) & 255u);
                                        let _e551 = select(0u, 1u, (_e549 != 0u));
                                        let _e555 = ((_e546 & 8388607u) | (_e551 << bitcast<u32>(23i)));
                                        let _e560 = (_e98 - ((bitcast<i32>(_e549) - bitcast<i32>(_e551)) + -149i));
                                        let _e561 = (_e560 < 0i);
                                        if _e561 {
                                            phi_795_ = -(_e560);
                                        } else {
                                            phi_795_ = 0i;
                                        }
                                        let _e564 = phi_795_;
                                        if _e561 {
                                            phi_805_ = 0i;
                                        } else {
                                            phi_805_ = select(_e560, 31i, (_e560 > 31i));
                                        }
                                        let _e568 = phi_805_;
                                        let _e573 = (_e568 & 31i);
                                        let _e583 = (bitcast<i32>(_e546) >> bitcast<u32>(31i));
                                        let _e591 = bitcast<u32>(_e514.member.y);
                                        let _e594 = ((_e591 >> bitcast<u32>(23i)) & 255u);
                                        let _e596 = select(0u, 1u, (_e594 != 0u));
                                        let _e600 = ((_e591 & 8388607u) | (_e596 << bitcast<u32>(23i)));
                                        let _e605 = (_e98 - ((bitcast<i32>(_e594) - bitcast<i32>(_e596)) + -149i));
                                        let _e606 = (_e605 < 0i);
                                        if _e606 {
                                            phi_852_ = -(_e605);
                                        } else {
                                            phi_852_ = 0i;
                                        }
                                        let _e609 = phi_852_;
                                        if _e606 {
                                            phi_862_ = 0i;
                                        } else {
                                            phi_862_ = select(_e605, 31i, (_e605 > 31i));
                                        }
                                        let _e613 = phi_862_;
                                        let _e618 = (_e613 & 31i);
                                        let _e628 = (bitcast<i32>(_e591) >> bitcast<u32>(31i));
                                        let _e636 = bitcast<u32>(_e514.member.z);
                                        let _e639 = ((_e636 >> bitcast<u32>(23i)) & 255u);
                                        let _e641 = select(0u, 1u, (_e639 != 0u));
                                        let _e645 = ((_e636 & 8388607u) | (_e641 << bitcast<u32>(23i)));
                                        let _e650 = (_e98 - ((bitcast<i32>(_e639) - bitcast<i32>(_e641)) + -149i));
                                        let _e651 = (_e650 < 0i);
                                        if _e651 {
                                            phi_909_ = -(_e650);
                                        } else {
                                            phi_909_ = 0i;
                                        }
                                        let _e654 = phi_909_;
                                        if _e651 {
                                            phi_919_ = 0i;
                                        } else {
                                            phi_919_ = select(_e650, 31i, (_e650 > 31i));
                                        }
                                        let _e658 = phi_919_;
                                        let _e663 = (_e658 & 31i);
                                        let _e673 = (bitcast<i32>(_e636) >> bitcast<u32>(31i));
                                        let _e682 = bitcast<u32>(-(_e514.member_1.x));
                                        let _e685 = ((_e682 >> bitcast<u32>(23i)) & 255u);
                                        let _e687 = select(0u, 1u, (_e685 != 0u));
                                        let _e691 = ((_e682 & 8388607u) | (_e687 << bitcast<u32>(23i)));
                                        let _e696 = (_e98 - ((bitcast<i32>(_e685) - bitcast<i32>(_e687)) + -149i));
                                        let _e697 = (_e696 < 0i);
                                        if _e697 {
                                            phi_968_ = -(_e696);
                                        } else {
                                            phi_968_ = 0i;
                                        }
                                        let _e700 = phi_968_;
                                        if _e697 {
                                            phi_978_ = 0i;
                                        } else {
                                            phi_978_ = select(_e696, 31i, (_e696 > 31i));
                                        }
                                        let _e704 = phi_978_;
                                        let _e709 = (_e704 & 31i);
                                        let _e719 = (bitcast<i32>(_e682) >> bitcast<u32>(31i));
                                        let _e729 = bitcast<u32>(-(_e514.member_1.y));
                                        let _e732 = ((_e729 >> bitcast<u32>(23i)) & 255u);
                                        let _e734 = select(0u, 1u, (_e732 != 0u));
                                        let _e738 = ((_e729 & 8388607u) | (_e734 << bitcast<u32>(23i)));
                                        let _e743 = (_e98 - ((bitcast<i32>(_e732) - bitcast<i32>(_e734)) + -149i));
                                        let _e744 = (_e743 < 0i);
                                        if _e744 {
                                            phi_1027_ = -(_e743);
                                        } else {
                                            phi_1027_ = 0i;
                                        }
                                        let _e747 = phi_1027_;
                                        if _e744 {
                                            phi_1037_ = 0i;
                                        } else {
                                            phi_1037_ = select(_e743, 31i, (_e743 > 31i));
                                        }
                                        let _e751 = phi_1037_;
                                        let _e756 = (_e751 & 31i);
                                        let _e766 = (bitcast<i32>(_e729) >> bitcast<u32>(31i));
                                        let _e776 = bitcast<u32>(-(_e514.member_1.z));
                                        let _e779 = ((_e776 >> bitcast<u32>(23i)) & 255u);
                                        let _e781 = select(0u, 1u, (_e779 != 0u));
                                        let _e785 = ((_e776 & 8388607u) | (_e781 << bitcast<u32>(23i)));
                                        let _e790 = (_e98 - ((bitcast<i32>(_e779) - bitcast<i32>(_e781)) + -149i));
                                        let _e791 = (_e790 < 0i);
                                        if _e791 {
                                            phi_1086_ = -(_e790);
                                        } else {
                                            phi_1086_ = 0i;
                                        }
                                        let _e794 = phi_1086_;
                                        if _e791 {
                                            phi_1096_ = 0i;
                                        } else {
                                            phi_1096_ = select(_e790, 31i, (_e790 > 31i));
                                        }
                                        let _e798 = phi_1096_;
                                        let _e803 = (_e798 & 31i);
                                        let _e813 = (bitcast<i32>(_e776) >> bitcast<u32>(31i));
                                        local_15 = array<i32, 3>((((bitcast<i32>(((_e555 << bitcast<u32>((bitcast<u32>(_e564) & 31u))) >> bitcast<u32>(_e573))) + select(0i, 1i, (((_e555 & ((1u << bitcast<u32>(_e573)) - 1u)) != 0u) && (_e583 != 0i)))) ^ _e583) - _e583), (((bitcast<i32>(((_e600 << bitcast<u32>((bitcast<u32>(_e609) & 31u))) >> bitcast<u32>(_e618))) + select(0i, 1i, (((_e600 & ((1u << bitcast<u32>(_e618)) - 1u)) != 0u) && (_e628 != 0i)))) ^ _e628) - _e628), (((bitcast<i32>(((_e645 << bitcast<u32>((bitcast<u32>(_e654) & 31u))) >> bitcast<u32>(_e663))) + select(0i, 1i, (((_e645 & ((1u << bitcast<u32>(_e663)) - 1u)) != 0u) && (_e673 != 0i)))) ^ _e673) - _e673));
                                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e691 << bitcast<u32>((bitcast<u32>(_e700) & 31u))) >> bitcast<u32>(_e709))) + select(0i, 1i, (((_e691 & ((1u << bitcast<u32>(_e709)) - 1u)) != 0u) && (_e719 != 0i)))) ^ _e719) - _e719)), -((((bitcast<i32>(((_e738 << bitcast<u32>((bitcast<u32>(_e747) & 31u))) >> bitcast<u32>(_e756))) + select(0i, 1i, (((_e738 & ((1u << bitcast<u32>(_e756)) - 1u)) != 0u) && (_e766 != 0i)))) ^ _e766) - _e766)), -((((bitcast<i32>(((_e785 << bitcast<u32>((bitcast<u32>(_e794) & 31u))) >> bitcast<u32>(_e803))) + select(0i, 1i, (((_e785 & ((1u << bitcast<u32>(_e803)) - 1u)) != 0u) && (_e813 != 0i)))) ^ _e813) - _e813)));
                                        let _e836 = bitcast<u32>(_e533.member.x);
                                        let _e839 = ((_e836 >> bitcast<u32>(23i)) & 255u);
                                        let _e841 = select(0u, 1u, (_e839 != 0u));
                                        let _e845 = ((_e836 & 8388607u) | (_e841 << bitcast<u32>(23i)));
                                        let _e850 = (_e98 - ((bitcast<i32>(_e839) - bitcast<i32>(_e841)) + -149i));
                                        let _e851 = (_e850 < 0i);
                                        if _e851 {
                                            phi_1163_ = -(_e850);
                                        } else {
                                            phi_1163_ = 0i;
                                        }
                                        let _e854 = phi_1163_;
                                        if _e851 {
                                            phi_1173_ = 0i;
                                        } else {
                                            phi_1173_ = select(_e850, 31i, (_e850 > 31i));
                                        }
                                        let _e858 = phi_1173_;
                                        let _e863 = (_e858 & 31i);
                                        let _e873 = (bitcast<i32>(_e836) >> bitcast<u32>(31i));
                                        let _e881 = bitcast<u32>(_e533.member.y);
                                        let _e884 = ((_e881 >> bitcast<u32>(23i)) & 255u);
                                        let _e886 = select(0u, 1u, (_e884 != 0u));
                                        let _e890 = ((_e881 & 8388607u) | (_e886 << bitcast<u32>(23i)));
                                        let _e895 = (_e98 - ((bitcast<i32>(_e884) - bitcast<i32>(_e886)) + -149i));
                                        let _e896 = (_e895 < 0i);
                                        if _e896 {
                                            phi_1220_ = -(_e895);
                                        } else {
                                            phi_1220_ = 0i;
                                        }
                                        let _e899 = phi_1220_;
                                        if _e896 {
                                            phi_1230_ = 0i;
                                        } else {
                                            phi_1230_ = select(_e895, 31i, (_e895 > 31i));
                                        }
                                        let _e903 = phi_1230_;
                                        let _e908 = (_e903 & 31i);
                                        let _e918 = (bitcast<i32>(_e881) >> bitcast<u32>(31i));
                                        let _e926 = bitcast<u32>(_e533.member.z);
                                        let _e929 = ((_e926 >> bitcast<u32>(23i)) & 255u);
                                        let _e931 = select(0u, 1u, (_e929 != 0u));
                                        let _e935 = ((_e926 & 8388607u) | (_e931 << bitcast<u32>(23i)));
                                        let _e940 = (_e98 - ((bitcast<i32>(_e929) - bitcast<i32>(_e931)) + -149i));
                                        let _e941 = (_e940 < 0i);
                                        if _e941 {
                                            phi_1277_ = -(_e940);
                                        } else {
                                            phi_1277_ = 0i;
                                        }
                                        let _e944 = phi_1277_;
                                        if _e941 {
                                            phi_1287_ = 0i;
                                        } else {
                                            phi_1287_ = select(_e940, 31i, (_e940 > 31i));
                                        }
                                        let _e948 = phi_1287_;
                                        let _e953 = (_e948 & 31i);
                                        let _e963 = (bitcast<i32>(_e926) >> bitcast<u32>(31i));
                                        let _e972 = bitcast<u32>(-(_e533.member_1.x));
                                        let _e975 = ((_e972 >> bitcast<u32>(23i)) & 255u);
                                        let _e977 = select(0u, 1u, (_e975 != 0u));
                                        let _e981 = ((_e972 & 8388607u) | (_e977 << bitcast<u32>(23i)));
                                        let _e986 = (_e98 - ((bitcast<i32>(_e975) - bitcast<i32>(_e977)) + -149i));
                                        let _e987 = (_e986 < 0i);
                                        if _e987 {
                                            phi_1336_ = -(_e986);
                                        } else {
                                            phi_1336_ = 0i;
                                        }
                                        let _e990 = phi_1336_;
                                        if _e987 {
                                            phi_1346_ = 0i;
                                        } else {
                                            phi_1346_ = select(_e986, 31i, (_e986 > 31i));
                                        }
                                        let _e994 = phi_1346_;
                                        let _e999 = (_e994 & 31i);
                                        let _e1009 = (bitcast<i32>(_e972) >> bitcast<u32>(31i));
                                        let _e1019 = bitcast<u32>(-(_e533.member_1.y));
                                        let _e1022 = ((_e1019 >> bitcast<u32>(23i)) & 255u);
                                        let _e1024 = select(0u, 1u, (_e1022 != 0u));
                                        let _e1028 = ((_e1019 & 8388607u) | (_e1024 << bitcast<u32>(23i)));
                                        let _e1033 = (_e98 - ((bitcast<i32>(_e1022) - bitcast<i32>(_e1024)) + -149i));
                                        let _e1034 = (_e1033 < 0i);
                                        if _e1034 {
                                            phi_1395_ = -(_e1033);
                                        } else {
                                            phi_1395_ = 0i;
                                        }
                                        let _e1037 = phi_1395_;
                                        if _e1034 {
                                            phi_1405_ = 0i;
                                        } else {
                                            phi_1405_ = select(_e1033, 31i, (_e1033 > 31i));
                                        }
                                        let _e1041 = phi_1405_;
                                        let _e1046 = (_e1041 & 31i);
                                        let _e1056 = (bitcast<i32>(_e1019) >> bitcast<u32>(31i));
                                        let _e1066 = bitcast<u32>(-(_e533.member_1.z));
                                        let _e1069 = ((_e1066 >> bitcast<u32>(23i)) & 255u);
                                        let _e1071 = select(0u, 1u, (_e1069 != 0u));
                                        let _e1075 = ((_e1066 & 8388607u) | (_e1071 << bitcast<u32>(23i)));
                                        let _e1080 = (_e98 - ((bitcast<i32>(_e1069) - bitcast<i32>(_e1071)) + -149i));
                                        let _e1081 = (_e1080 < 0i);
                                        if _e1081 {
                                            phi_1454_ = -(_e1080);
                                        } else {
                                            phi_1454_ = 0i;
                                        }
                                        let _e1084 = phi_1454_;
                                        if _e1081 {
                                            phi_1464_ = 0i;
                                        } else {
                                            phi_1464_ = select(_e1080, 31i, (_e1080 > 31i));
                                        }
                                        let _e1088 = phi_1464_;
                                        let _e1093 = (_e1088 & 31i);
                                        let _e1103 = (bitcast<i32>(_e1066) >> bitcast<u32>(31i));
                                        local_13 = array<i32, 3>((((bitcast<i32>(((_e845 << bitcast<u32>((bitcast<u32>(_e854) & 31u))) >> bitcast<u32>(_e863))) + select(0i, 1i, (((_e845 & ((1u << bitcast<u32>(_e863)) - 1u)) != 0u) && (_e873 != 0i)))) ^ _e873) - _e873), (((bitcast<i32>(((_e890 << bitcast<u32>((bitcast<u32>(_e899) & 31u))) >> bitcast<u32>(_e908))) + select(0i, 1i, (((_e890 & ((1u << bitcast<u32>(_e908)) - 1u)) != 0u) && (_e918 != 0i)))) ^ _e918) - _e918), (((bitcast<i32>(((_e935 << bitcast<u32>((bitcast<u32>(_e944) & 31u))) >> bitcast<u32>(_e953))) + select(0i, 1i, (((_e935 & ((1u << bitcast<u32>(_e953)) - 1u)) != 0u) && (_e963 != 0i)))) ^ _e963) - _e963));
                                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e981 << bitcast<u32>((bitcast<u32>(_e990) & 31u))) >> bitcast<u32>(_e999))) + select(0i, 1i, (((_e981 & ((1u << bitcast<u32>(_e999)) - 1u)) != 0u) && (_e1009 != 0i)))) ^ _e1009) - _e1009)), -((((bitcast<i32>(((_e1028 << bitcast<u32>((bitcast<u32>(_e1037) & 31u))) >> bitcast<u32>(_e1046))) + select(0i, 1i, (((_e1028 & ((1u << bitcast<u32>(_e1046)) - 1u)) != 0u) && (_e1056 != 0i)))) ^ _e1056) - _e1056)), -((((bitcast<i32>(((_e1075 << bitcast<u32>((bitcast<u32>(_e1084) & 31u))) >> bitcast<u32>(_e1093))) + select(0i, 1i, (((_e1075 & ((1u << bitcast<u32>(_e1093)) - 1u)) != 0u) && (_e1103 != 0i)))) ^ _e1103) - _e1103)));
                                        local_21 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_1508_ = type_8(0u, 3u);
                                        loop {
                                            let _e1115 = phi_1508_;
                                            if (_e1115.member < _e1115.member_1) {
                                                phi_1509_ = type_8((_e1115.member + 1u), _e1115.member_1);
                                                phi_1532_ = type_8(1u, _e1115.member);
                                            } else {
                                                phi_1509_ = _e1115;
                                                phi_1532_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1128 = phi_1509_;
                                            let _e1130 = phi_1532_;
                                            let _e1134 = (bitcast<i32>(_e1130.member) != 0i);
                                            if _e1134 {
                                                let _e1135 = (_e1130.member_1 < 3u);
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1137 = local_11[_e1130.member_1];
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1139 = local_10[_e1130.member_1];
                                                let _e1141 = bitcast<u32>((_e1139 - _e1137));
                                                let _e1147 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1141)), 32u, (_e1141 == 0u)));
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1152 = local_15[_e1130.member_1];
                                                let _e1153 = (_e1152 - _e1137);
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1155 = local_13[_e1130.member_1];
                                                let _e1156 = (_e1155 - _e1137);
                                                let _e1157 = (_e1153 > _e1156);
                                                let _e1160 = ((select(21u, _e1147, (_e1147 > 21u)) - 21u) & 31u);
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1169 = local_14[_e1130.member_1];
                                                let _e1170 = (_e1139 - _e1169);
                                                if _e1135 {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                let _e1172 = local_12[_e1130.member_1];
                                                let _e1173 = (_e1139 - _e1172);
                                                let _e1174 = (_e1170 > _e1173);
                                                let _e1184 = (_e1130.member_1 * 2u);
                                                let _e1186 = ((1u + _e1184) % 7u);
                                                if (_e1186 < 7u) {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                local_21[_e1186] = (((bitcast<u32>(select(_e1156, _e1153, _e1157)) >> bitcast<u32>(_e1160)) & 2097151u) | (select(0u, 1u, _e1157) << bitcast<u32>(21u)));
                                                let _e1190 = ((_e1184 + 2u) % 7u);
                                                if (_e1190 < 7u) {
                                                } else {
                                                    phi_3719_ = true;
                                                    break;
                                                }
                                                local_21[_e1190] = (((bitcast<u32>(select(_e1173, _e1170, _e1174)) >> bitcast<u32>(_e1160)) & 2097151u) | (select(0u, 1u, _e1174) << bitcast<u32>(21u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_1508_ = _e1128;
                                                phi_3719_ = _e461;
                                                break if !(_e1134);
                                            }
                                        }
                                        let _e1195 = phi_3719_;
                                        phi_3821_ = _e1195;
                                        if _e1195 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1706_ = type_8(0u, 3u);
                                        loop {
                                            let _e1197 = phi_1706_;
                                            if (_e1197.member < _e1197.member_1) {
                                                phi_1707_ = type_8((_e1197.member + 1u), _e1197.member_1);
                                                phi_1730_ = type_8(1u, _e1197.member);
                                            } else {
                                                phi_1707_ = _e1197;
                                                phi_1730_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1210 = phi_1707_;
                                            let _e1212 = phi_1730_;
                                            let _e1216 = (bitcast<i32>(_e1212.member) != 0i);
                                            if _e1216 {
                                                let _e1217 = (_e1212.member_1 * 2u);
                                                let _e1219 = ((1u + _e1217) % 7u);
                                                if (_e1219 < 7u) {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1222 = local_21[_e1219];
                                                let _e1224 = ((_e1217 + 2u) % 7u);
                                                if (_e1224 < 7u) {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1227 = local_21[_e1224];
                                                let _e1228 = (_e1212.member_1 < 3u);
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1230 = local_11[_e1212.member_1];
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                let _e1232 = local_10[_e1212.member_1];
                                                let _e1234 = bitcast<u32>((_e1232 - _e1230));
                                                let _e1240 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1234)), 32u, (_e1234 == 0u)));
                                                let _e1245 = ((select(21u, _e1240, (_e1240 > 21u)) - 21u) & 31u);
                                                let _e1249 = (_e1230 + bitcast<i32>(((_e1222 & 2097151u) << bitcast<u32>(_e1245))));
                                                let _e1254 = (_e1232 - bitcast<i32>(((_e1227 & 2097151u) << bitcast<u32>(_e1245))));
                                                let _e1258 = (((_e1222 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                let _e1262 = (((_e1227 >> bitcast<u32>(21u)) & 1u) == 1u);
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_3[_e1212.member_1] = select(_e1230, _e1249, _e1258);
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_1[_e1212.member_1] = select(_e1249, _e1230, _e1258);
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local_2[_e1212.member_1] = select(_e1232, _e1254, _e1262);
                                                if _e1228 {
                                                } else {
                                                    phi_3804_ = true;
                                                    break;
                                                }
                                                local[_e1212.member_1] = select(_e1254, _e1232, _e1262);
                                            }
                                            continue;
                                            continuing {
                                                phi_1706_ = _e1210;
                                                phi_3804_ = _e1195;
                                                break if !(_e1216);
                                            }
                                        }
                                        let _e1273 = phi_3804_;
                                        phi_3821_ = _e1273;
                                        if _e1273 {
                                            break;
                                        }
                                        let _e1274 = local;
                                        let _e1275 = local_1;
                                        let _e1276 = local_2;
                                        let _e1277 = local_3;
                                        if _e496 {
                                            phi_1935_ = type_34(array<i32, 3>(_e1277[0], _e1277[1], _e1277[2]), array<i32, 3>(_e1276[0], _e1276[1], _e1276[2]));
                                        } else {
                                            phi_1935_ = type_34(array<i32, 3>(_e1275[0], _e1275[1], _e1275[2]), array<i32, 3>(_e1274[0], _e1274[1], _e1274[2]));
                                        }
                                        let _e1297 = phi_1935_;
                                        local_11 = array<i32, 3>(_e1297.member[0], _e1297.member[1], _e1297.member[2]);
                                        local_10 = array<i32, 3>(_e1297.member_1[0], _e1297.member_1[1], _e1297.member_1[2]);
                                        phi_3823_ = _e1273;
                                        phi_1953_ = select(_e490.member_2, _e490.member_1, _e496);
                                    }
                                    let _e1310 = phi_3823_;
                                    let _e1312 = phi_1953_;
                                    phi_3822_ = _e1310;
                                    phi_680_ = _e1312;
                                    phi_1955_ = select(true, false, _e484);
                                } else {
                                    phi_3822_ = _e461;
                                    phi_680_ = u32();
                                    phi_1955_ = false;
                                }
                                let _e1315 = phi_3822_;
                                let _e1317 = phi_680_;
                                let _e1319 = phi_1955_;
                                continue;
                                continuing {
                                    phi_3764_ = _e1315;
                                    phi_676_ = _e478;
                                    phi_679_ = _e1317;
                                    phi_3821_ = _e1315;
                                    break if !(_e1319);
                                }
                            }
                            let _e1322 = phi_3821_;
                            if _e1322 {
                                break;
                            }
                            let _e1323 = local_10;
                            let _e1324 = local_11;
                            local_9 = _e1324;
                            local_8 = _e1323;
                            if _e107 {
                            } else {
                                break;
                            }
                            let _e1328 = global_4.member[_e102].member_1;
                            if (_e1328 == 2147483648u) {
                                phi_2006_ = type_27(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e1334 = global_4.member[_e102].member[0u];
                                let _e1339 = global_4.member[_e102].member[1u];
                                let _e1344 = global_4.member[_e102].member[2u];
                                phi_2006_ = type_27(vec3<f32>(_e1334[0], _e1339[0], _e1344[0]), vec3<f32>(_e1334[2], _e1339[2], _e1344[2]));
                            }
                            let _e1355 = phi_2006_;
                            let _e1359 = global_4.member[_e102].member_2;
                            if (_e1359 == 2147483648u) {
                                phi_2028_ = _e1355;
                            } else {
                                let _e1365 = global_4.member[_e102].member[0u];
                                let _e1370 = global_4.member[_e102].member[1u];
                                let _e1375 = global_4.member[_e102].member[2u];
                                phi_2028_ = type_27(vec3<f32>(_e1365[1], _e1370[1], _e1375[1]), vec3<f32>(_e1365[3], _e1370[3], _e1375[3]));
                            }
                            let _e1386 = phi_2028_;
                            let _e1399 = bitcast<u32>(_e1355.member.x);
                            let _e1402 = ((_e1399 >> bitcast<u32>(23i)) & 255u);
                            let _e1404 = select(0u, 1u, (_e1402 != 0u));
                            let _e1408 = ((_e1399 & 8388607u) | (_e1404 << bitcast<u32>(23i)));
                            let _e1413 = (_e98 - ((bitcast<i32>(_e1402) - bitcast<i32>(_e1404)) + -149i));
                            let _e1414 = (_e1413 < 0i);
                            if _e1414 {
                                phi_2055_ = -(_e1413);
                            } else {
                                phi_2055_ = 0i;
                            }
                            let _e1417 = phi_2055_;
                            if _e1414 {
                                phi_2065_ = 0i;
                            } else {
                                phi_2065_ = select(_e1413, 31i, (_e1413 > 31i));
                            }
                            let _e1421 = phi_2065_;
                            let _e1426 = (_e1421 & 31i);
                            let _e1436 = (bitcast<i32>(_e1399) >> bitcast<u32>(31i));
                            let _e1444 = bitcast<u32>(_e1355.member.y);
                            let _e1447 = ((_e1444 >> bitcast<u32>(23i)) & 255u);
                            let _e1449 = select(0u, 1u, (_e1447 != 0u));
                            let _e1453 = ((_e1444 & 8388607u) | (_e1449 << bitcast<u32>(23i)));
                            let _e1458 = (_e98 - ((bitcast<i32>(_e1447) - bitcast<i32>(_e1449)) + -149i));
                            let _e1459 = (_e1458 < 0i);
                            if _e1459 {
                                phi_2112_ = -(_e1458);
                            } else {
                                phi_2112_ = 0i;
                            }
                            let _e1462 = phi_2112_;
                            if _e1459 {
                                phi_2122_ = 0i;
                            } else {
                                phi_2122_ = select(_e1458, 31i, (_e1458 > 31i));
                            }
                            let _e1466 = phi_2122_;
                            let _e1471 = (_e1466 & 31i);
                            let _e1481 = (bitcast<i32>(_e1444) >> bitcast<u32>(31i));
                            let _e1489 = bitcast<u32>(_e1355.member.z);
                            let _e1492 = ((_e1489 >> bitcast<u32>(23i)) & 255u);
                            let _e1494 = select(0u, 1u, (_e1492 != 0u));
                            let _e1498 = ((_e1489 & 8388607u) | (_e1494 << bitcast<u32>(23i)));
                            let _e1503 = (_e98 - ((bitcast<i32>(_e1492) - bitcast<i32>(_e1494)) + -149i));
                            let _e1504 = (_e1503 < 0i);
                            if _e1504 {
                                phi_2169_ = -(_e1503);
                            } else {
                                phi_2169_ = 0i;
                            }
                            let _e1507 = phi_2169_;
                            if _e1504 {
                                phi_2179_ = 0i;
                            } else {
                                phi_2179_ = select(_e1503, 31i, (_e1503 > 31i));
                            }
                            let _e1511 = phi_2179_;
                            let _e1516 = (_e1511 & 31i);
                            let _e1526 = (bitcast<i32>(_e1489) >> bitcast<u32>(31i));
                            let _e1535 = bitcast<u32>(-(_e1355.member_1.x));
                            let _e1538 = ((_e1535 >> bitcast<u32>(23i)) & 255u);
                            let _e1540 = select(0u, 1u, (_e1538 != 0u));
                            let _e1544 = ((_e1535 & 8388607u) | (_e1540 << bitcast<u32>(23i)));
                            let _e1549 = (_e98 - ((bitcast<i32>(_e1538) - bitcast<i32>(_e1540)) + -149i));
                            let _e1550 = (_e1549 < 0i);
                            if _e1550 {
                                phi_2228_ = -(_e1549);
                            } else {
                                phi_2228_ = 0i;
                            }
                            let _e1553 = phi_2228_;
                            if _e1550 {
                                phi_2238_ = 0i;
                            } else {
                                phi_2238_ = select(_e1549, 31i, (_e1549 > 31i));
                            }
                            let _e1557 = phi_2238_;
                            let _e1562 = (_e1557 & 31i);
                            let _e1572 = (bitcast<i32>(_e1535) >> bitcast<u32>(31i));
                            let _e1582 = bitcast<u32>(-(_e1355.member_1.y));
                            let _e1585 = ((_e1582 >> bitcast<u32>(23i)) & 255u);
                            let _e1587 = select(0u, 1u, (_e1585 != 0u));
                            let _e1591 = ((_e1582 & 8388607u) | (_e1587 << bitcast<u32>(23i)));
                            let _e1596 = (_e98 - ((bitcast<i32>(_e1585) - bitcast<i32>(_e1587)) + -149i));
                            let _e1597 = (_e1596 < 0i);
                            if _e1597 {
                                phi_2287_ = -(_e1596);
                            } else {
                                phi_2287_ = 0i;
                            }
                            let _e1600 = phi_2287_;
                            if _e1597 {
                                phi_2297_ = 0i;
                            } else {
                                phi_2297_ = select(_e1596, 31i, (_e1596 > 31i));
                            }
                            let _e1604 = phi_2297_;
                            let _e1609 = (_e1604 & 31i);
                            let _e1619 = (bitcast<i32>(_e1582) >> bitcast<u32>(31i));
                            let _e1629 = bitcast<u32>(-(_e1355.member_1.z));
                            let _e1632 = ((_e1629 >> bitcast<u32>(23i)) & 255u);
                            let _e1634 = select(0u, 1u, (_e1632 != 0u));
                            let _e1638 = ((_e1629 & 8388607u) | (_e1634 << bitcast<u32>(23i)));
                            let _e1643 = (_e98 - ((bitcast<i32>(_e1632) - bitcast<i32>(_e1634)) + -149i));
                            let _e1644 = (_e1643 < 0i);
                            if _e1644 {
                                phi_2346_ = -(_e1643);
                            } else {
                                phi_2346_ = 0i;
                            }
                            let _e1647 = phi_2346_;
                            if _e1644 {
                                phi_2356_ = 0i;
                            } else {
                                phi_2356_ = select(_e1643, 31i, (_e1643 > 31i));
                            }
                            let _e1651 = phi_2356_;
                            let _e1656 = (_e1651 & 31i);
                            let _e1666 = (bitcast<i32>(_e1629) >> bitcast<u32>(31i));
                            local_19 = array<i32, 3>((((bitcast<i32>(((_e1408 << bitcast<u32>((bitcast<u32>(_e1417) & 31u))) >> bitcast<u32>(_e1426))) + select(0i, 1i, (((_e1408 & ((1u << bitcast<u32>(_e1426)) - 1u)) != 0u) && (_e1436 != 0i)))) ^ _e1436) - _e1436), (((bitcast<i32>(((_e1453 << bitcast<u32>((bitcast<u32>(_e1462) & 31u))) >> bitcast<u32>(_e1471))) + select(0i, 1i, (((_e1453 & ((1u << bitcast<u32>(_e1471)) - 1u)) != 0u) && (_e1481 != 0i)))) ^ _e1481) - _e1481), (((bitcast<i32>(((_e1498 << bitcast<u32>((bitcast<u32>(_e1507) & 31u))) >> bitcast<u32>(_e1516))) + select(0i, 1i, (((_e1498 & ((1u << bitcast<u32>(_e1516)) - 1u)) != 0u) && (_e1526 != 0i)))) ^ _e1526) - _e1526));
                            local_18 = array<i32, 3>(-((((bitcast<i32>(((_e1544 << bitcast<u32>((bitcast<u32>(_e1553) & 31u))) >> bitcast<u32>(_e1562))) + select(0i, 1i, (((_e1544 & ((1u << bitcast<u32>(_e1562)) - 1u)) != 0u) && (_e1572 != 0i)))) ^ _e1572) - _e1572)), -((((bitcast<i32>(((_e1591 << bitcast<u32>((bitcast<u32>(_e1600) & 31u))) >> bitcast<u32>(_e1609))) + select(0i, 1i, (((_e1591 & ((1u << bitcast<u32>(_e1609)) - 1u)) != 0u) && (_e1619 != 0i)))) ^ _e1619) - _e1619)), -((((bitcast<i32>(((_e1638 << bitcast<u32>((bitcast<u32>(_e1647) & 31u))) >> bitcast<u32>(_e1656))) + select(0i, 1i, (((_e1638 & ((1u << bitcast<u32>(_e1656)) - 1u)) != 0u) && (_e1666 != 0i)))) ^ _e1666) - _e1666)));
                            let _e1689 = bitcast<u32>(_e1386.member.x);
                            let _e1692 = ((_e1689 >> bitcast<u32>(23i)) & 255u);
                            let _e1694 = select(0u, 1u, (_e1692 != 0u));
                            let _e1698 = ((_e1689 & 8388607u) | (_e1694 << bitcast<u32>(23i)));
                            let _e1703 = (_e98 - ((bitcast<i32>(_e1692) - bitcast<i32>(_e1694)) + -149i));
                            let _e1704 = (_e1703 < 0i);
                            if _e1704 {
                                phi_2423_ = -(_e1703);
                            } else {
                                phi_2423_ = 0i;
                            }
                            let _e1707 = phi_2423_;
                            if _e1704 {
                                phi_2433_ = 0i;
                            } else {
                                phi_2433_ = select(_e1703, 31i, (_e1703 > 31i));
                            }
                            let _e1711 = phi_2433_;
                            let _e1716 = (_e1711 & 31i);
                            let _e1726 = (bitcast<i32>(_e1689) >> bitcast<u32>(31i));
                            let _e1734 = bitcast<u32>(_e1386.member.y);
                            let _e1737 = ((_e1734 >> bitcast<u32>(23i)) & 255u);
                            let _e1739 = select(0u, 1u, (_e1737 != 0u));
                            let _e1743 = ((_e1734 & 8388607u) | (_e1739 << bitcast<u32>(23i)));
                            let _e1748 = (_e98 - ((bitcast<i32>(_e1737) - bitcast<i32>(_e1739)) + -149i));
                            let _e1749 = (_e1748 < 0i);
                            if _e1749 {
                                phi_2480_ = -(_e1748);
                            } else {
                                phi_2480_ = 0i;
                            }
                            let _e1752 = phi_2480_;
                            if _e1749 {
                                phi_2490_ = 0i;
                            } else {
                                phi_2490_ = select(_e1748, 31i, (_e1748 > 31i));
                            }
                            let _e1756 = phi_2490_;
                            let _e1761 = (_e1756 & 31i);
                            let _e1771 = (bitcast<i32>(_e1734) >> bitcast<u32>(31i));
                            let _e1779 = bitcast<u32>(_e1386.member.z);
                            let _e1782 = ((_e1779 >> bitcast<u32>(23i)) & 255u);
                            let _e1784 = select(0u, 1u, (_e1782 != 0u));
                            let _e1788 = ((_e1779 & 8388607u) | (_e1784 << bitcast<u32>(23i)));
                            let _e1793 = (_e98 - ((bitcast<i32>(_e1782) - bitcast<i32>(_e1784)) + -149i));
                            let _e1794 = (_e1793 < 0i);
                            if _e1794 {
                                phi_2537_ = -(_e1793);
                            } else {
                                phi_2537_ = 0i;
                            }
                            let _e1797 = phi_2537_;
                            if _e1794 {
                                phi_2547_ = 0i;
                            } else {
                                phi_2547_ = select(_e1793, 31i, (_e1793 > 31i));
                            }
                            let _e1801 = phi_2547_;
                            let _e1806 = (_e1801 & 31i);
                            let _e1816 = (bitcast<i32>(_e1779) >> bitcast<u32>(31i));
                            let _e1825 = bitcast<u32>(-(_e1386.member_1.x));
                            let _e1828 = ((_e1825 >> bitcast<u32>(23i)) & 255u);
                            let _e1830 = select(0u, 1u, (_e1828 != 0u));
                            let _e1834 = ((_e1825 & 8388607u) | (_e1830 << bitcast<u32>(23i)));
                            let _e1839 = (_e98 - ((bitcast<i32>(_e1828) - bitcast<i32>(_e1830)) + -149i));
                            let _e1840 = (_e1839 < 0i);
                            if _e1840 {
                                phi_2596_ = -(_e1839);
                            } else {
                                phi_2596_ = 0i;
                            }
                            let _e1843 = phi_2596_;
                            if _e1840 {
                                phi_2606_ = 0i;
                            } else {
                                phi_2606_ = select(_e1839, 31i, (_e1839 > 31i));
                            }
                            let _e1847 = phi_2606_;
                            let _e1852 = (_e1847 & 31i);
                            let _e1862 = (bitcast<i32>(_e1825) >> bitcast<u32>(31i));
                            let _e1872 = bitcast<u32>(-(_e1386.member_1.y));
                            let _e1875 = ((_e1872 >> bitcast<u32>(23i)) & 255u);
                            let _e1877 = select(0u, 1u, (_e1875 != 0u));
                            let _e1881 = ((_e1872 & 8388607u) | (_e1877 << bitcast<u32>(23i)));
                            let _e1886 = (_e98 - ((bitcast<i32>(_e1875) - bitcast<i32>(_e1877)) + -149i));
                            let _e1887 = (_e1886 < 0i);
                            if _e1887 {
                                phi_2655_ = -(_e1886);
                            } else {
                                phi_2655_ = 0i;
                            }
                            let _e1890 = phi_2655_;
                            if _e1887 {
                                phi_2665_ = 0i;
                            } else {
                                phi_2665_ = select(_e1886, 31i, (_e1886 > 31i));
                            }
                            let _e1894 = phi_2665_;
                            let _e1899 = (_e1894 & 31i);
                            let _e1909 = (bitcast<i32>(_e1872) >> bitcast<u32>(31i));
                            let _e1919 = bitcast<u32>(-(_e1386.member_1.z));
                            let _e1922 = ((_e1919 >> bitcast<u32>(23i)) & 255u);
                            let _e1924 = select(0u, 1u, (_e1922 != 0u));
                            let _e1928 = ((_e1919 & 8388607u) | (_e1924 << bitcast<u32>(23i)));
                            let _e1933 = (_e98 - ((bitcast<i32>(_e1922) - bitcast<i32>(_e1924)) + -149i));
                            let _e1934 = (_e1933 < 0i);
                            if _e1934 {
                                phi_2714_ = -(_e1933);
                            } else {
                                phi_2714_ = 0i;
                            }
                            let _e1937 = phi_2714_;
                            if _e1934 {
                                phi_2724_ = 0i;
                            } else {
                                phi_2724_ = select(_e1933, 31i, (_e1933 > 31i));
                            }
                            let _e1941 = phi_2724_;
                            let _e1946 = (_e1941 & 31i);
                            let _e1956 = (bitcast<i32>(_e1919) >> bitcast<u32>(31i));
                            local_17 = array<i32, 3>((((bitcast<i32>(((_e1698 << bitcast<u32>((bitcast<u32>(_e1707) & 31u))) >> bitcast<u32>(_e1716))) + select(0i, 1i, (((_e1698 & ((1u << bitcast<u32>(_e1716)) - 1u)) != 0u) && (_e1726 != 0i)))) ^ _e1726) - _e1726), (((bitcast<i32>(((_e1743 << bitcast<u32>((bitcast<u32>(_e1752) & 31u))) >> bitcast<u32>(_e1761))) + select(0i, 1i, (((_e1743 & ((1u << bitcast<u32>(_e1761)) - 1u)) != 0u) && (_e1771 != 0i)))) ^ _e1771) - _e1771), (((bitcast<i32>(((_e1788 << bitcast<u32>((bitcast<u32>(_e1797) & 31u))) >> bitcast<u32>(_e1806))) + select(0i, 1i, (((_e1788 & ((1u << bitcast<u32>(_e1806)) - 1u)) != 0u) && (_e1816 != 0i)))) ^ _e1816) - _e1816));
                            local_16 = array<i32, 3>(-((((bitcast<i32>(((_e1834 << bitcast<u32>((bitcast<u32>(_e1843) & 31u))) >> bitcast<u32>(_e1852))) + select(0i, 1i, (((_e1834 & ((1u << bitcast<u32>(_e1852)) - 1u)) != 0u) && (_e1862 != 0i)))) ^ _e1862) - _e1862)), -((((bitcast<i32>(((_e1881 << bitcast<u32>((bitcast<u32>(_e1890) & 31u))) >> bitcast<u32>(_e1899))) + select(0i, 1i, (((_e1881 & ((1u << bitcast<u32>(_e1899)) - 1u)) != 0u) && (_e1909 != 0i)))) ^ _e1909) - _e1909)), -((((bitcast<i32>(((_e1928 << bitcast<u32>((bitcast<u32>(_e1937) & 31u))) >> bitcast<u32>(_e1946))) + select(0i, 1i, (((_e1928 & ((1u << bitcast<u32>(_e1946)) - 1u)) != 0u) && (_e1956 != 0i)))) ^ _e1956) - _e1956)));
                            local_20 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                            phi_2768_ = type_8(0u, 3u);
                            loop {
                                let _e1968 = phi_2768_;
                                if (_e1968.member < _e1968.member_1) {
                                    phi_2769_ = type_8((_e1968.member + 1u), _e1968.member_1);
                                    phi_2792_ = type_8(1u, _e1968.member);
                                } else {
                                    phi_2769_ = _e1968;
                                    phi_2792_ = type_8(0u, type_8().member_1);
                                }
                                let _e1981 = phi_2769_;
                                let _e1983 = phi_2792_;
                                let _e1987 = (bitcast<i32>(_e1983.member) != 0i);
                                if _e1987 {
                                    let _e1988 = (_e1983.member_1 < 3u);
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e1990 = local_9[_e1983.member_1];
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e1992 = local_8[_e1983.member_1];
                                    let _e1994 = bitcast<u32>((_e1992 - _e1990));
                                    let _e2000 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1994)), 32u, (_e1994 == 0u)));
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2005 = local_19[_e1983.member_1];
                                    let _e2006 = (_e2005 - _e1990);
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2008 = local_17[_e1983.member_1];
                                    let _e2009 = (_e2008 - _e1990);
                                    let _e2010 = (_e2006 > _e2009);
                                    let _e2013 = ((select(21u, _e2000, (_e2000 > 21u)) - 21u) & 31u);
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2022 = local_18[_e1983.member_1];
                                    let _e2023 = (_e1992 - _e2022);
                                    if _e1988 {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    let _e2025 = local_16[_e1983.member_1];
                                    let _e2026 = (_e1992 - _e2025);
                                    let _e2027 = (_e2023 > _e2026);
                                    let _e2037 = (_e1983.member_1 * 2u);
                                    let _e2039 = ((1u + _e2037) % 7u);
                                    if (_e2039 < 7u) {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    local_20[_e2039] = (((bitcast<u32>(select(_e2009, _e2006, _e2010)) >> bitcast<u32>(_e2013)) & 2097151u) | (select(0u, 1u, _e2010) << bitcast<u32>(21u)));
                                    let _e2043 = ((_e2037 + 2u) % 7u);
                                    if (_e2043 < 7u) {
                                    } else {
                                        phi_3826_ = true;
                                        break;
                                    }
                                    local_20[_e2043] = (((bitcast<u32>(select(_e2026, _e2023, _e2027)) >> bitcast<u32>(_e2013)) & 2097151u) | (select(0u, 1u, _e2027) << bitcast<u32>(21u)));
                                }
                                continue;
                                continuing {
                                    phi_2768_ = _e1981;
                                    phi_3826_ = _e1322;
                                    break if !(_e1987);
                                }
                            }
                            let _e2048 = phi_3826_;
                            if _e2048 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_2966_ = type_8(0u, 3u);
                            loop {
                                let _e2050 = phi_2966_;
                                if (_e2050.member < _e2050.member_1) {
                                    phi_2967_ = type_8((_e2050.member + 1u), _e2050.member_1);
                                    phi_2990_ = type_8(1u, _e2050.member);
                                } else {
                                    phi_2967_ = _e2050;
                                    phi_2990_ = type_8(0u, type_8().member_1);
                                }
                                let _e2063 = phi_2967_;
                                let _e2065 = phi_2990_;
                                let _e2069 = (bitcast<i32>(_e2065.member) != 0i);
                                if _e2069 {
                                    let _e2070 = (_e2065.member_1 * 2u);
                                    let _e2072 = ((1u + _e2070) % 7u);
                                    if (_e2072 < 7u) {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2075 = local_20[_e2072];
                                    let _e2077 = ((_e2070 + 2u) % 7u);
                                    if (_e2077 < 7u) {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2080 = local_20[_e2077];
                                    let _e2081 = (_e2065.member_1 < 3u);
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2083 = local_9[_e2065.member_1];
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    let _e2085 = local_8[_e2065.member_1];
                                    let _e2087 = bitcast<u32>((_e2085 - _e2083));
                                    let _e2093 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e2087)), 32u, (_e2087 == 0u)));
                                    let _e2098 = ((select(21u, _e2093, (_e2093 > 21u)) - 21u) & 31u);
                                    let _e2102 = (_e2083 + bitcast<i32>(((_e2075 & 2097151u) << bitcast<u32>(_e2098))));
                                    let _e2107 = (_e2085 - bitcast<i32>(((_e2080 & 2097151u) << bitcast<u32>(_e2098))));
                                    let _e2111 = (((_e2075 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    let _e2115 = (((_e2080 >> bitcast<u32>(21u)) & 1u) == 1u);
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_7[_e2065.member_1] = select(_e2083, _e2102, _e2111);
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_5[_e2065.member_1] = select(_e2102, _e2083, _e2111);
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_6[_e2065.member_1] = select(_e2085, _e2107, _e2115);
                                    if _e2081 {
                                    } else {
                                        phi_3878_ = true;
                                        break;
                                    }
                                    local_4[_e2065.member_1] = select(_e2107, _e2085, _e2115);
                                }
                                continue;
                                continuing {
                                    phi_2966_ = _e2063;
                                    phi_3878_ = _e2048;
                                    break if !(_e2069);
                                }
                            }
                            let _e2126 = phi_3878_;
                            if _e2126 {
                                break;
                            }
                            let _e2127 = local_4;
                            let _e2128 = local_5;
                            let _e2129 = local_6;
                            let _e2130 = local_7;
                            let _e2131 = local_20;
                            if _e108 {
                            } else {
                                break;
                            }
                            global_8.member[_e102] = array<u32, 7>(_e2131[0], _e2131[1], _e2131[2], _e2131[3], _e2131[4], _e2131[5], _e2131[6]);
                            if _e109 {
                            } else {
                                break;
                            }
                            global_5.member[_e102] = type_34(array<i32, 3>(_e1324[0], _e1324[1], _e1324[2]), array<i32, 3>(_e1323[0], _e1323[1], _e1323[2]));
                            if _e107 {
                            } else {
                                break;
                            }
                            if ((_e1328 & 2147483648u) != 0u) {
                                let _e2173 = ((bitcast<u32>((_e2129[0] - _e2130[0])) | bitcast<u32>((_e2129[1] - _e2130[1]))) | bitcast<u32>((_e2129[2] - _e2130[2])));
                                if (_e2173 < 1024u) {
                                    phi_3345_ = 0u;
                                } else {
                                    phi_3345_ = select(2u, 1u, (_e2173 < 2097152u));
                                }
                                let _e2178 = phi_3345_;
                                switch bitcast<i32>(_e2178) {
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
                                let _e2181 = phi_3351_;
                                phi_3358_ = type_8(0u, ((_e1328 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2189 = phi_3358_;
                                    if (_e2189.member < _e2189.member_1) {
                                        phi_3359_ = type_8((_e2189.member + 1u), _e2189.member_1);
                                        phi_3382_ = type_8(1u, _e2189.member);
                                    } else {
                                        phi_3359_ = _e2189;
                                        phi_3382_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2202 = phi_3359_;
                                    let _e2204 = phi_3382_;
                                    let _e2208 = (bitcast<i32>(_e2204.member) != 0i);
                                    if _e2208 {
                                        let _e2210 = ((_e1328 & 268435455u) + _e2204.member_1);
                                        let _e2211 = (_e2210 < _e81);
                                        if _e2211 {
                                            if _e2211 {
                                            } else {
                                                phi_3895_ = true;
                                                break;
                                            }
                                            global_6.member[_e2210] = ((3u * _e2181) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3358_ = _e2202;
                                        phi_3895_ = _e2126;
                                        break if !(_e2208);
                                    }
                                }
                                let _e2215 = phi_3895_;
                                if _e2215 {
                                    break;
                                }
                                phi_3910_ = _e2215;
                            } else {
                                phi_3910_ = _e2126;
                            }
                            let _e2217 = phi_3910_;
                            if _e107 {
                            } else {
                                break;
                            }
                            if ((_e1359 & 2147483648u) != 0u) {
                                let _e2227 = ((bitcast<u32>((_e2127[0] - _e2128[0])) | bitcast<u32>((_e2127[1] - _e2128[1]))) | bitcast<u32>((_e2127[2] - _e2128[2])));
                                if (_e2227 < 1024u) {
                                    phi_3478_ = 0u;
                                } else {
                                    phi_3478_ = select(2u, 1u, (_e2227 < 2097152u));
                                }
                                let _e2232 = phi_3478_;
                                switch bitcast<i32>(_e2232) {
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
                                let _e2235 = phi_3484_;
                                phi_3491_ = type_8(0u, ((_e1359 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2243 = phi_3491_;
                                    if (_e2243.member < _e2243.member_1) {
                                        phi_3492_ = type_8((_e2243.member + 1u), _e2243.member_1);
                                        phi_3515_ = type_8(1u, _e2243.member);
                                    } else {
                                        phi_3492_ = _e2243;
                                        phi_3515_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2256 = phi_3492_;
                                    let _e2258 = phi_3515_;
                                    let _e2262 = (bitcast<i32>(_e2258.member) != 0i);
                                    if _e2262 {
                                        let _e2264 = ((_e1359 & 268435455u) + _e2258.member_1);
                                        let _e2265 = (_e2264 < _e81);
                                        if _e2265 {
                                            if _e2265 {
                                            } else {
                                                phi_3903_ = true;
                                                break;
                                            }
                                            global_6.member[_e2264] = ((3u * _e2235) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3491_ = _e2256;
                                        phi_3903_ = _e2217;
                                        break if !(_e2262);
                                    }
                                }
                                let _e2269 = phi_3903_;
                                if _e2269 {
                                    break;
                                }
                            }
                            if (_e102 == 0u) {
                                if (_e84 == 0u) {
                                } else {
                                    if (0u < _e84) {
                                    } else {
                                        break;
                                    }
                                    global_7.member[0u] = type_28(array<u32, 4>(bitcast<u32>(_e1324[0]), bitcast<u32>(_e1324[1]), bitcast<u32>(_e1324[2]), bitcast<u32>(_e98)), array<u32, 4>(bitcast<u32>(_e1323[0]), bitcast<u32>(_e1323[1]), bitcast<u32>(_e1323[2]), 0u));
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
