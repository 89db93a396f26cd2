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
    var phi_1566_: u32;
    var phi_3700_: bool;
    var phi_1705_: type_8;
    var phi_1706_: type_8;
    var phi_1729_: type_8;
    var phi_1841_: u32;
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
    var phi_2826_: u32;
    var phi_3807_: bool;
    var phi_2965_: type_8;
    var phi_2966_: type_8;
    var phi_2989_: type_8;
    var phi_3101_: u32;
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
            let _e73 = global;
            let _e75 = arrayLength((&global_4.member));
            let _e83 = arrayLength((&global_7.member));
            let _e86 = arrayLength((&global_8.member));
            let _e89 = global_3.member[0u];
            let _e93 = global_2.member[0u];
            let _e95 = (bitcast<i32>(_e89) + bitcast<i32>(_e93));
            if (_e95 < -126i) {
                phi_182_ = -126i;
            } else {
                phi_182_ = select(_e95, 127i, (_e95 > 127i));
            }
            let _e100 = phi_182_;
            let _e104 = (_e73.x + (_e73.y * 2097152u));
            let _e107 = global_1.member[0u];
            if (_e104 < _e107) {
                let _e109 = (_e104 < _e75);
                if _e109 {
                    let _e110 = (_e104 < arrayLength((&global_5.member)));
                    if _e110 {
                        let _e111 = (_e104 < arrayLength((&global_6.member)));
                        if _e111 {
                            let _e112 = (0u < _e75);
                            if _e112 {
                                if _e112 {
                                } else {
                                    break;
                                }
                                let _e115 = global_4.member[0u];
                                phi_228_ = _e115;
                            } else {
                                phi_228_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                            }
                            let _e117 = phi_228_;
                            if (_e117.member_1 == 2147483648u) {
                                phi_246_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                phi_246_ = type_30(vec3<f32>(_e117.member[0][0], _e117.member[1][0], _e117.member[2][0]), vec3<f32>(_e117.member[0][2], _e117.member[1][2], _e117.member[2][2]));
                            }
                            let _e136 = phi_246_;
                            if (_e117.member_2 == 2147483648u) {
                                phi_264_ = _e136;
                            } else {
                                phi_264_ = type_30(vec3<f32>(_e117.member[0][1], _e117.member[1][1], _e117.member[2][1]), vec3<f32>(_e117.member[0][3], _e117.member[1][3], _e117.member[2][3]));
                            }
                            let _e155 = phi_264_;
                            let _e184 = bitcast<u32>(select(_e155.member.x, _e136.member.x, (_e136.member.x < _e155.member.x)));
                            let _e187 = ((_e184 >> bitcast<u32>(23i)) & 255u);
                            let _e189 = select(0u, 1u, (_e187 != 0u));
                            let _e193 = ((_e184 & 8388607u) | (_e189 << bitcast<u32>(23i)));
                            let _e198 = (_e100 - ((bitcast<i32>(_e187) - bitcast<i32>(_e189)) + -149i));
                            let _e199 = (_e198 < 0i);
                            if _e199 {
                                phi_330_ = -(_e198);
                            } else {
                                phi_330_ = 0i;
                            }
                            let _e202 = phi_330_;
                            if _e199 {
                                phi_340_ = 0i;
                            } else {
                                phi_340_ = select(_e198, 31i, (_e198 > 31i));
                            }
                            let _e206 = phi_340_;
                            let _e211 = (_e206 & 31i);
                            let _e221 = (bitcast<i32>(_e184) >> bitcast<u32>(31i));
                            let _e229 = bitcast<u32>(select(_e155.member.y, _e136.member.y, (_e136.member.y < _e155.member.y)));
                            let _e232 = ((_e229 >> bitcast<u32>(23i)) & 255u);
                            let _e234 = select(0u, 1u, (_e232 != 0u));
                            let _e238 = ((_e229 & 8388607u) | (_e234 << bitcast<u32>(23i)));
                            let _e243 = (_e100 - ((bitcast<i32>(_e232) - bitcast<i32>(_e234)) + -149i));
                            let _e244 = (_e243 < 0i);
                            if _e244 {
                                phi_387_ = -(_e243);
                            } else {
                                phi_387_ = 0i;
                            }
                            let _e247 = phi_387_;
                            if _e244 {
                                phi_397_ = 0i;
                            } else {
                                phi_397_ = select(_e243, 31i, (_e243 > 31i));
                            }
                            let _e251 = phi_397_;
                            let _e256 = (_e251 & 31i);
                            let _e266 = (bitcast<i32>(_e229) >> bitcast<u32>(31i));
                            let _e274 = bitcast<u32>(select(_e155.member.z, _e136.member.z, (_e136.member.z < _e155.member.z)));
                            let _e277 = ((_e274 >> bitcast<u32>(23i)) & 255u);
                            let _e279 = select(0u, 1u, (_e277 != 0u));
                            let _e283 = ((_e274 & 8388607u) | (_e279 << bitcast<u32>(23i)));
                            let _e288 = (_e100 - ((bitcast<i32>(_e277) - bitcast<i32>(_e279)) + -149i));
                            let _e289 = (_e288 < 0i);
                            if _e289 {
                                phi_444_ = -(_e288);
                            } else {
                                phi_444_ = 0i;
                            }
                            let _e292 = phi_444_;
                            if _e289 {
                                phi_454_ = 0i;
                            } else {
                                phi_454_ = select(_e288, 31i, (_e288 > 31i));
                            }
                            let _e296 = phi_454_;
                            let _e301 = (_e296 & 31i);
                            let _e311 = (bitcast<i32>(_e274) >> bitcast<u32>(31i));
                            let _e320 = bitcast<u32>(-(select(_e155.member_1.x, _e136.member_1.x, (_e136.member_1.x > _e155.member_1.x))));
                            let _e323 = ((_e320 >> bitcast<u32>(23i)) & 255u);
                            let _e325 = select(0u, 1u, (_e323 != 0u));
                            let _e329 = ((_e320 & 8388607u) | (_e325 << bitcast<u32>(23i)));
                            let _e334 = (_e100 - ((bitcast<i32>(_e323) - bitcast<i32>(_e325)) + -149i));
                            let _e335 = (_e334 < 0i);
                            if _e335 {
                                phi_503_ = -(_e334);
                            } else {
                                phi_503_ = 0i;
                            }
                            let _e338 = phi_503_;
                            if _e335 {
                                phi_513_ = 0i;
                            } else {
                                phi_513_ = select(_e334, 31i, (_e334 > 31i));
                            }
                            let _e342 = phi_513_;
                            let _e347 = (_e342 & 31i);
                            let _e357 = (bitcast<i32>(_e320) >> bitcast<u32>(31i));
                            let _e367 = bitcast<u32>(-(select(_e155.member_1.y, _e136.member_1.y, (_e136.member_1.y > _e155.member_1.y))));
                            let _e370 = ((_e367 >> bitcast<u32>(23i)) & 255u);
                            let _e372 = select(0u, 1u, (_e370 != 0u));
                            let _e376 = ((_e367 & 8388607u) | (_e372 << bitcast<u32>(23i)));
                            let _e381 = (_e100 - ((bitcast<i32>(_e370) - bitcast<i32>(_e372)) + -149i));
                            let _e382 = (_e381 < 0i);
                            if _e382 {
                                phi_562_ = -(_e381);
                            } else {
                                phi_562_ = 0i;
                            }
                            let _e385 = phi_562_;
                            if _e382 {
                                phi_572_ = 0i;
                            } else {
                                phi_572_ = select(_e381, 31i, (_e381 > 31i));
                            }
                            let _e389 = phi_572_;
                            let _e394 = (_e389 & 31i);
                            let _e404 = (bitcast<i32>(_e367) >> bitcast<u32>(31i));
                            let _e414 = bitcast<u32>(-(select(_e155.member_1.z, _e136.member_1.z, (_e136.member_1.z > _e155.member_1.z))));
                            let _e417 = ((_e414 >> bitcast<u32>(23i)) & 255u);
                            let _e419 = select(0u, 1u, (_e417 != 0u));
                            let _e423 = ((_e414 & 8388607u) | (_e419 << bitcast<u32>(23i)));
                            let _e428 = (_e100 - ((bitcast<i32>(_e417) - bitcast<i32>(_e419)) + -149i));
                            let _e429 = (_e428 < 0i);
                            if _e429 {
                                phi_621_ = -(_e428);
                            } else {
                                phi_621_ = 0i;
                            }
                            let _e432 = phi_621_;
                            if _e429 {
                                phi_631_ = 0i;
                            } else {
                                phi_631_ = select(_e428, 31i, (_e428 > 31i));
                            }
                            let _e436 = phi_631_;
                            let _e441 = (_e436 & 31i);
                            let _e451 = (bitcast<i32>(_e414) >> bitcast<u32>(31i));
                            local_11 = array<i32, 3>((((bitcast<i32>(((_e193 << bitcast<u32>((bitcast<u32>(_e202) & 31u))) >> bitcast<u32>(_e211))) + select(0i, 1i, (((_e193 & ((1u << bitcast<u32>(_e211)) - 1u)) != 0u) && (_e221 != 0i)))) ^ _e221) - _e221), (((bitcast<i32>(((_e238 << bitcast<u32>((bitcast<u32>(_e247) & 31u))) >> bitcast<u32>(_e256))) + select(0i, 1i, (((_e238 & ((1u << bitcast<u32>(_e256)) - 1u)) != 0u) && (_e266 != 0i)))) ^ _e266) - _e266), (((bitcast<i32>(((_e283 << bitcast<u32>((bitcast<u32>(_e292) & 31u))) >> bitcast<u32>(_e301))) + select(0i, 1i, (((_e283 & ((1u << bitcast<u32>(_e301)) - 1u)) != 0u) && (_e311 != 0i)))) ^ _e311) - _e311));
                            local_10 = array<i32, 3>(-((((bitcast<i32>(((_e329 << bitcast<u32>((bitcast<u32>(_e338) & 31u))) >> bitcast<u32>(_e347))) + select(0i, 1i, (((_e329 & ((1u << bitcast<u32>(_e347)) - 1u)) != 0u) && (_e357 != 0i)))) ^ _e357) - _e357)), -((((bitcast<i32>(((_e376 << bitcast<u32>((bitcast<u32>(_e385) & 31u))) >> bitcast<u32>(_e394))) + select(0i, 1i, (((_e376 & ((1u << bitcast<u32>(_e394)) - 1u)) != 0u) && (_e404 != 0i)))) ^ _e404) - _e404)), -((((bitcast<i32>(((_e423 << bitcast<u32>((bitcast<u32>(_e432) & 31u))) >> bitcast<u32>(_e441))) + select(0i, 1i, (((_e423 & ((1u << bitcast<u32>(_e441)) - 1u)) != 0u) && (_e451 != 0i)))) ^ _e451) - _e451)));
                            phi_3745_ = false;
                            phi_675_ = type_8(0u, 128u);
                            phi_678_ = 0u;
                            loop {
                                let _e463 = phi_3745_;
                                let _e465 = phi_675_;
                                let _e467 = phi_678_;
                                if (_e465.member < _e465.member_1) {
                                    phi_676_ = type_8((_e465.member + 1u), _e465.member_1);
                                    phi_701_ = type_8(1u, _e465.member);
                                } else {
                                    phi_676_ = _e465;
                                    phi_701_ = type_8(0u, type_8().member_1);
                                }
                                let _e480 = phi_676_;
                                let _e482 = phi_701_;
                                if (bitcast<i32>(_e482.member) != 0i) {
                                    let _e486 = (_e467 == _e104);
                                    if _e486 {
                                        phi_3804_ = _e463;
                                        phi_1952_ = u32();
                                    } else {
                                        let _e487 = (_e467 < _e75);
                                        if _e487 {
                                            if _e487 {
                                            } else {
                                                phi_3802_ = true;
                                                break;
                                            }
                                            let _e490 = global_4.member[_e467];
                                            phi_723_ = _e490;
                                        } else {
                                            phi_723_ = type_25(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                        }
                                        let _e492 = phi_723_;
                                        if ((_e492.member_1 & 2147483648u) != 0u) {
                                            phi_731_ = false;
                                        } else {
                                            phi_731_ = (_e104 <= _e492.member_1);
                                        }
                                        let _e498 = phi_731_;
                                        if (_e492.member_1 == 2147483648u) {
                                            phi_749_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                        } else {
                                            phi_749_ = type_30(vec3<f32>(_e492.member[0][0], _e492.member[1][0], _e492.member[2][0]), vec3<f32>(_e492.member[0][2], _e492.member[1][2], _e492.member[2][2]));
                                        }
                                        let _e516 = phi_749_;
                                        if (_e492.member_2 == 2147483648u) {
                                            phi_767_ = _e516;
                                        } else {
                                            phi_767_ = type_30(vec3<f32>(_e492.member[0][1], _e492.member[1][1], _e492.member[2][1]), vec3<f32>(_e492.member[0][3], _e492.member[1][3], _e492.member[2][3]));
                                        }
                                        let _e535 = phi_767_;
                                        let _e548 = bitcast<u32>(_e516.member.x);
                                        let _e551 = ((_e548 >> bitcast<u32>(23i)) & 255u);
                                        let _e553 = select(0u, 1u, (_e551 != 0u));
                                        let _e557 = ((_e548 & 8388607u) | (_e553 << bitcast<u32>(23i)));
                                        let _e562 = (_e100 - ((bitcast<i32>(_e551) - bitcast<i32>(_e553)) + -149i));
                                        let _e563 = (_e562 < 0i);
                                        if _e563 {
                                            phi_794_ = -(_e562);
                                        } else {
                                            phi_794_ = 0i;
                                        }
                                        let _e566 = phi_794_;
                                        if _e563 {
                                            phi_804_ = 0i;
                                        } else {
                                            phi_804_ = select(_e562, 31i, (_e562 > 31i));
                                        }
                                        let _e570 = phi_804_;
                                        let _e575 = (_e570 & 31i);
                                        let _e585 = (bitcast<i32>(_e548) >> bitcast<u32>(31i));
                                        let _e593 = bitcast<u32>(_e516.member.y);
                                        let _e596 = ((_e593 >> bitcast<u32>(23i)) & 255u);
                                        let _e598 = select(0u, 1u, (_e596 != 0u));
                                        let _e602 = ((_e593 & 8388607u) | (_e598 << bitcast<u32>(23i)));
                                        let _e607 = (_e100 - ((bitcast<i32>(_e596) - bitcast<i32>(_e598)) + -149i));
                                        let _e608 = (_e607 < 0i);
                                        if _e608 {
                                            phi_851_ = -(_e607);
                                        } else {
                                            phi_851_ = 0i;
                                        }
                                        let _e611 = phi_851_;
                                        if _e608 {
                                            phi_861_ = 0i;
                                        } else {
                                            phi_861_ = select(_e607, 31i, (_e607 > 31i));
                                        }
                                        let _e615 = phi_861_;
                                        let _e620 = (_e615 & 31i);
                                        let _e630 = (bitcast<i32>(_e593) >> bitcast<u32>(31i));
                                        let _e638 = bitcast<u32>(_e516.member.z);
                                        let _e641 = ((_e638 >> bitcast<u32>(23i)) & 255u);
                                        let _e643 = select(0u, 1u, (_e641 != 0u));
                                        let _e647 = ((_e638 & 8388607u) | (_e643 << bitcast<u32>(23i)));
                                        let _e652 = (_e100 - ((bitcast<i32>(_e641) - bitcast<i32>(_e643)) + -149i));
                                        let _e653 = (_e652 < 0i);
                                        if _e653 {
                                            phi_908_ = -(_e652);
                                        } else {
                                            phi_908_ = 0i;
                                        }
                                        let _e656 = phi_908_;
                                        if _e653 {
                                            phi_918_ = 0i;
                                        } else {
                                            phi_918_ = select(_e652, 31i, (_e652 > 31i));
                                        }
                                        let _e660 = phi_918_;
                                        let _e665 = (_e660 & 31i);
                                        let _e675 = (bitcast<i32>(_e638) >> bitcast<u32>(31i));
                                        let _e684 = bitcast<u32>(-(_e516.member_1.x));
                                        let _e687 = ((_e684 >> bitcast<u32>(23i)) & 255u);
                                        let _e689 = select(0u, 1u, (_e687 != 0u));
                                        let _e693 = ((_e684 & 8388607u) | (_e689 << bitcast<u32>(23i)));
                                        let _e698 = (_e100 - ((bitcast<i32>(_e687) - bitcast<i32>(_e689)) + -149i));
                                        let _e699 = (_e698 < 0i);
                                        if _e699 {
                                            phi_967_ = -(_e698);
                                        } else {
                                            phi_967_ = 0i;
                                        }
                                        let _e702 = phi_967_;
                                        if _e699 {
                                            phi_977_ = 0i;
                                        } else {
                                            phi_977_ = select(_e698, 31i, (_e698 > 31i));
                                        }
                                        let _e706 = phi_977_;
                                        let _e711 = (_e706 & 31i);
                                        let _e721 = (bitcast<i32>(_e684) >> bitcast<u32>(31i));
                                        let _e731 = bitcast<u32>(-(_e516.member_1.y));
                                        let _e734 = ((_e731 >> bitcast<u32>(23i)) & 255u);
                                        let _e736 = select(0u, 1u, (_e734 != 0u));
                                        let _e740 = ((_e731 & 8388607u) | (_e736 << bitcast<u32>(23i)));
                                        let _e745 = (_e100 - ((bitcast<i32>(_e734) - bitcast<i32>(_e736)) + -149i));
                                        let _e746 = (_e745 < 0i);
                                        if _e746 {
                                            phi_1026_ = -(_e745);
                                        } else {
                                            phi_1026_ = 0i;
                                        }
                                        let _e749 = phi_1026_;
                                        if _e746 {
                                            phi_1036_ = 0i;
                                        } else {
                                            phi_1036_ = select(_e745, 31i, (_e745 > 31i));
                                        }
                                        let _e753 = phi_1036_;
                                        let _e758 = (_e753 & 31i);
                                        let _e768 = (bitcast<i32>(_e731) >> bitcast<u32>(31i));
                                        let _e778 = bitcast<u32>(-(_e516.member_1.z));
                                        let _e781 = ((_e778 >> bitcast<u32>(23i)) & 255u);
                                        let _e783 = select(0u, 1u, (_e781 != 0u));
                                        let _e787 = ((_e778 & 8388607u) | (_e783 << bitcast<u32>(23i)));
                                        let _e792 = (_e100 - ((bitcast<i32>(_e781) - bitcast<i32>(_e783)) + -149i));
                                        let _e793 = (_e792 < 0i);
                                        if _e793 {
                                            phi_1085_ = -(_e792);
                                        } else {
                                            phi_1085_ = 0i;
                                        }
                                        let _e796 = phi_1085_;
                                        if _e793 {
                                            phi_1095_ = 0i;
                                        } else {
                                            phi_1095_ = select(_e792, 31i, (_e792 > 31i));
                                        }
                                        let _e800 = phi_1095_;
                                        let _e805 = (_e800 & 31i);
                                        let _e815 = (bitcast<i32>(_e778) >> bitcast<u32>(31i));
                                        local_15 = array<i32, 3>((((bitcast<i32>(((_e557 << bitcast<u32>((bitcast<u32>(_e566) & 31u))) >> bitcast<u32>(_e575))) + select(0i, 1i, (((_e557 & ((1u << bitcast<u32>(_e575)) - 1u)) != 0u) && (_e585 != 0i)))) ^ _e585) - _e585), (((bitcast<i32>(((_e602 << bitcast<u32>((bitcast<u32>(_e611) & 31u))) >> bitcast<u32>(_e620))) + select(0i, 1i, (((_e602 & ((1u << bitcast<u32>(_e620)) - 1u)) != 0u) && (_e630 != 0i)))) ^ _e630) - _e630), (((bitcast<i32>(((_e647 << bitcast<u32>((bitcast<u32>(_e656) & 31u))) >> bitcast<u32>(_e665))) + select(0i, 1i, (((_e647 & ((1u << bitcast<u32>(_e665)) - 1u)) != 0u) && (_e675 != 0i)))) ^ _e675) - _e675));
                                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e693 << bitcast<u32>((bitcast<u32>(_e702) & 31u))) >> bitcast<u32>(_e711))) + select(0i, 1i, (((_e693 & ((1u << bitcast<u32>(_e711)) - 1u)) != 0u) && (_e721 != 0i)))) ^ _e721) - _e721)), -((((bitcast<i32>(((_e740 << bitcast<u32>((bitcast<u32>(_e749) & 31u))) >> bitcast<u32>(_e758))) + select(0i, 1i, (((_e740 & ((1u << bitcast<u32>(_e758)) - 1u)) != 0u) && (_e768 != 0i)))) ^ _e768) - _e768)), -((((bitcast<i32>(((_e787 << bitcast<u32>((bitcast<u32>(_e796) & 31u))) >> bitcast<u32>(_e805))) + select(0i, 1i, (((_e787 & ((1u << bitcast<u32>(_e805)) - 1u)) != 0u) && (_e815 != 0i)))) ^ _e815) - _e815)));
                                        let _e838 = bitcast<u32>(_e535.member.x);
                                        let _e841 = ((_e838 >> bitcast<u32>(23i)) & 255u);
                                        let _e843 = select(0u, 1u, (_e841 != 0u));
                                        let _e847 = ((_e838 & 8388607u) | (_e843 << bitcast<u32>(23i)));
                                        let _e852 = (_e100 - ((bitcast<i32>(_e841) - bitcast<i32>(_e843)) + -149i));
                                        let _e853 = (_e852 < 0i);
                                        if _e853 {
                                            phi_1162_ = -(_e852);
                                        } else {
                                            phi_1162_ = 0i;
                                        }
                                        let _e856 = phi_1162_;
                                        if _e853 {
                                            phi_1172_ = 0i;
                                        } else {
                                            phi_1172_ = select(_e852, 31i, (_e852 > 31i));
                                        }
                                        let _e860 = phi_1172_;
                                        let _e865 = (_e860 & 31i);
                                        let _e875 = (bitcast<i32>(_e838) >> bitcast<u32>(31i));
                                        let _e883 = bitcast<u32>(_e535.member.y);
                                        let _e886 = ((_e883 >> bitcast<u32>(23i)) & 255u);
                                        let _e888 = select(0u, 1u, (_e886 != 0u));
                                        let _e892 = ((_e883 & 8388607u) | (_e888 << bitcast<u32>(23i)));
                                        let _e897 = (_e100 - ((bitcast<i32>(_e886) - bitcast<i32>(_e888)) + -149i));
                                        let _e898 = (_e897 < 0i);
                                        if _e898 {
                                            phi_1219_ = -(_e897);
                                        } else {
                                            phi_1219_ = 0i;
                                        }
                                        let _e901 = phi_1219_;
                                        if _e898 {
                                            phi_1229_ = 0i;
                                        } else {
                                            phi_1229_ = select(_e897, 31i, (_e897 > 31i));
                                        }
                                        let _e905 = phi_1229_;
                                        let _e910 = (_e905 & 31i);
                                        let _e920 = (bitcast<i32>(_e883) >> bitcast<u32>(31i));
                                        let _e928 = bitcast<u32>(_e535.member.z);
                                        let _e931 = ((_e928 >> bitcast<u32>(23i)) & 255u);
                                        let _e933 = select(0u, 1u, (_e931 != 0u));
                                        let _e937 = ((_e928 & 8388607u) | (_e933 << bitcast<u32>(23i)));
                                        let _e942 = (_e100 - ((bitcast<i32>(_e931) - bitcast<i32>(_e933)) + -149i));
                                        let _e943 = (_e942 < 0i);
                                        if _e943 {
                                            phi_1276_ = -(_e942);
                                        } else {
                                            phi_1276_ = 0i;
                                        }
                                        let _e946 = phi_1276_;
                                        if _e943 {
                                            phi_1286_ = 0i;
                                        } else {
                                            phi_1286_ = select(_e942, 31i, (_e942 > 31i));
                                        }
                                        let _e950 = phi_1286_;
                                        let _e955 = (_e950 & 31i);
                                        let _e965 = (bitcast<i32>(_e928) >> bitcast<u32>(31i));
                                        let _e974 = bitcast<u32>(-(_e535.member_1.x));
                                        let _e977 = ((_e974 >> bitcast<u32>(23i)) & 255u);
                                        let _e979 = select(0u, 1u, (_e977 != 0u));
                                        let _e983 = ((_e974 & 8388607u) | (_e979 << bitcast<u32>(23i)));
                                        let _e988 = (_e100 - ((bitcast<i32>(_e977) - bitcast<i32>(_e979)) + -149i));
                                        let _e989 = (_e988 < 0i);
                                        if _e989 {
                                            phi_1335_ = -(_e988);
                                        } else {
                                            phi_1335_ = 0i;
                                        }
                                        let _e992 = phi_1335_;
                                        if _e989 {
                                            phi_1345_ = 0i;
                                        } else {
                                            phi_1345_ = select(_e988, 31i, (_e988 > 31i));
                                        }
                                        let _e996 = phi_1345_;
                                        let _e1001 = (_e996 & 31i);
                                        let _e1011 = (bitcast<i32>(_e974) >> bitcast<u32>(31i));
                                        let _e1021 = bitcast<u32>(-(_e535.member_1.y));
                                        let _e1024 = ((_e1021 >> bitcast<u32>(23i)) & 255u);
                                        let _e1026 = select(0u, 1u, (_e1024 != 0u));
                                        let _e1030 = ((_e1021 & 8388607u) | (_e1026 << bitcast<u32>(23i)));
                                        let _e1035 = (_e100 - ((bitcast<i32>(_e1024) - bitcast<i32>(_e1026)) + -149i));
                                        let _e1036 = (_e1035 < 0i);
                                        if _e1036 {
                                            phi_1394_ = -(_e1035);
                                        } else {
                                            phi_1394_ = 0i;
                                        }
                                        let _e1039 = phi_1394_;
                                        if _e1036 {
                                            phi_1404_ = 0i;
                                        } else {
                                            phi_1404_ = select(_e1035, 31i, (_e1035 > 31i));
                                        }
                                        let _e1043 = phi_1404_;
                                        let _e1048 = (_e1043 & 31i);
                                        let _e1058 = (bitcast<i32>(_e1021) >> bitcast<u32>(31i));
                                        let _e1068 = bitcast<u32>(-(_e535.member_1.z));
                                        let _e1071 = ((_e1068 >> bitcast<u32>(23i)) & 255u);
                                        let _e1073 = select(0u, 1u, (_e1071 != 0u));
                                        let _e1077 = ((_e1068 & 8388607u) | (_e1073 << bitcast<u32>(23i)));
                                        let _e1082 = (_e100 - ((bitcast<i32>(_e1071) - bitcast<i32>(_e1073)) + -149i));
                                        let _e1083 = (_e1082 < 0i);
                                        if _e1083 {
                                            phi_1453_ = -(_e1082);
                                        } else {
                                            phi_1453_ = 0i;
                                        }
                                        let _e1086 = phi_1453_;
                                        if _e1083 {
                                            phi_1463_ = 0i;
                                        } else {
                                            phi_1463_ = select(_e1082, 31i, (_e1082 > 31i));
                                        }
                                        let _e1090 = phi_1463_;
                                        let _e1095 = (_e1090 & 31i);
                                        let _e1105 = (bitcast<i32>(_e1068) >> bitcast<u32>(31i));
                                        local_13 = array<i32, 3>((((bitcast<i32>(((_e847 << bitcast<u32>((bitcast<u32>(_e856) & 31u))) >> bitcast<u32>(_e865))) + select(0i, 1i, (((_e847 & ((1u << bitcast<u32>(_e865)) - 1u)) != 0u) && (_e875 != 0i)))) ^ _e875) - _e875), (((bitcast<i32>(((_e892 << bitcast<u32>((bitcast<u32>(_e901) & 31u))) >> bitcast<u32>(_e910))) + select(0i, 1i, (((_e892 & ((1u << bitcast<u32>(_e910)) - 1u)) != 0u) && (_e920 != 0i)))) ^ _e920) - _e920), (((bitcast<i32>(((_e937 << bitcast<u32>((bitcast<u32>(_e946) & 31u))) >> bitcast<u32>(_e955))) + select(0i, 1i, (((_e937 & ((1u << bitcast<u32>(_e955)) - 1u)) != 0u) && (_e965 != 0i)))) ^ _e965) - _e965));
                                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e983 << bitcast<u32>((bitcast<u32>(_e992) & 31u))) >> bitcast<u32>(_e1001))) + select(0i, 1i, (((_e983 & ((1u << bitcast<u32>(_e1001)) - 1u)) != 0u) && (_e1011 != 0i)))) ^ _e1011) - _e1011)), -((((bitcast<i32>(((_e1030 << bitcast<u32>((bitcast<u32>(_e1039) & 31u))) >> bitcast<u32>(_e1048))) + select(0i, 1i, (((_e1030 & ((1u << bitcast<u32>(_e1048)) - 1u)) != 0u) && (_e1058 != 0i)))) ^ _e1058) - _e1058)), -((((bitcast<i32>(((_e1077 << bitcast<u32>((bitcast<u32>(_e1086) & 31u))) >> bitcast<u32>(_e1095))) + select(0i, 1i, (((_e1077 & ((1u << bitcast<u32>(_e1095)) - 1u)) != 0u) && (_e1105 != 0i)))) ^ _e1105) - _e1105)));
                                        local_21 = array<u32, 4>(0u, 0u, 0u, 0u);
                                        phi_1507_ = type_8(0u, 3u);
                                        loop {
                                            let _e1117 = phi_1507_;
                                            if (_e1117.member < _e1117.member_1) {
                                                phi_1508_ = type_8((_e1117.member + 1u), _e1117.member_1);
                                                phi_1531_ = type_8(1u, _e1117.member);
                                            } else {
                                                phi_1508_ = _e1117;
                                                phi_1531_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1130 = phi_1508_;
                                            let _e1132 = phi_1531_;
                                            let _e1136 = (bitcast<i32>(_e1132.member) != 0i);
                                            if _e1136 {
                                                let _e1137 = (_e1132.member_1 < 3u);
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1139 = local_11[_e1132.member_1];
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1141 = local_10[_e1132.member_1];
                                                let _e1143 = bitcast<u32>((_e1141 - _e1139));
                                                let _e1148 = select((bitcast<u32>(31i) - firstLeadingBit(_e1143)), 32u, (_e1143 == 0u));
                                                if ((32u - _e1148) > 10u) {
                                                    phi_1566_ = (22u - _e1148);
                                                } else {
                                                    phi_1566_ = 0u;
                                                }
                                                let _e1153 = phi_1566_;
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1155 = local_15[_e1132.member_1];
                                                let _e1156 = (_e1155 - _e1139);
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1158 = local_13[_e1132.member_1];
                                                let _e1159 = (_e1158 - _e1139);
                                                let _e1160 = (_e1156 > _e1159);
                                                let _e1163 = (_e1153 & 31u);
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1172 = local_14[_e1132.member_1];
                                                let _e1173 = (_e1141 - _e1172);
                                                if _e1137 {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                let _e1175 = local_12[_e1132.member_1];
                                                let _e1176 = (_e1141 - _e1175);
                                                let _e1177 = (_e1173 > _e1176);
                                                let _e1190 = ((1u + _e1132.member_1) % 4u);
                                                if (_e1190 < 4u) {
                                                } else {
                                                    phi_3700_ = true;
                                                    break;
                                                }
                                                local_21[_e1190] = ((((bitcast<u32>(select(_e1159, _e1156, _e1160)) >> bitcast<u32>(_e1163)) & 1023u) | (select(0u, 1u, _e1160) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1176, _e1173, _e1177)) >> bitcast<u32>(_e1163)) & 1023u) | (select(0u, 1u, _e1177) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                            }
                                            continue;
                                            continuing {
                                                phi_1507_ = _e1130;
                                                phi_3700_ = _e463;
                                                break if !(_e1136);
                                            }
                                        }
                                        let _e1196 = phi_3700_;
                                        phi_3802_ = _e1196;
                                        if _e1196 {
                                            break;
                                        }
                                        local_3 = array<i32, 3>(0i, 0i, 0i);
                                        local_2 = array<i32, 3>(0i, 0i, 0i);
                                        local_1 = array<i32, 3>(0i, 0i, 0i);
                                        local = array<i32, 3>(0i, 0i, 0i);
                                        phi_1705_ = type_8(0u, 3u);
                                        loop {
                                            let _e1198 = phi_1705_;
                                            if (_e1198.member < _e1198.member_1) {
                                                phi_1706_ = type_8((_e1198.member + 1u), _e1198.member_1);
                                                phi_1729_ = type_8(1u, _e1198.member);
                                            } else {
                                                phi_1706_ = _e1198;
                                                phi_1729_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1211 = phi_1706_;
                                            let _e1213 = phi_1729_;
                                            let _e1217 = (bitcast<i32>(_e1213.member) != 0i);
                                            if _e1217 {
                                                let _e1219 = ((1u + _e1213.member_1) % 4u);
                                                if (_e1219 < 4u) {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1222 = local_21[_e1219];
                                                let _e1224 = ((_e1213.member_1 + 1u) % 4u);
                                                if (_e1224 < 4u) {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1227 = local_21[_e1224];
                                                let _e1228 = (_e1213.member_1 < 3u);
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1230 = local_11[_e1213.member_1];
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                let _e1232 = local_10[_e1213.member_1];
                                                let _e1234 = (_e1227 >> bitcast<u32>(11u));
                                                let _e1236 = bitcast<u32>((_e1232 - _e1230));
                                                let _e1241 = select((bitcast<u32>(31i) - firstLeadingBit(_e1236)), 32u, (_e1236 == 0u));
                                                if ((32u - _e1241) > 10u) {
                                                    phi_1841_ = (22u - _e1241);
                                                } else {
                                                    phi_1841_ = 0u;
                                                }
                                                let _e1246 = phi_1841_;
                                                let _e1248 = (_e1246 & 31u);
                                                let _e1252 = (_e1230 + bitcast<i32>(((_e1222 & 1023u) << bitcast<u32>(_e1248))));
                                                let _e1257 = (_e1232 - bitcast<i32>(((_e1234 & 1023u) << bitcast<u32>(_e1248))));
                                                let _e1261 = (((_e1222 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                let _e1265 = (((_e1234 >> bitcast<u32>(10u)) & 1u) == 1u);
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_3[_e1213.member_1] = select(_e1230, _e1252, _e1261);
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_1[_e1213.member_1] = select(_e1252, _e1230, _e1261);
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local_2[_e1213.member_1] = select(_e1232, _e1257, _e1265);
                                                if _e1228 {
                                                } else {
                                                    phi_3785_ = true;
                                                    break;
                                                }
                                                local[_e1213.member_1] = select(_e1257, _e1232, _e1265);
                                            }
                                            continue;
                                            continuing {
                                                phi_1705_ = _e1211;
                                                phi_3785_ = _e1196;
                                                break if !(_e1217);
                                            }
                                        }
                                        let _e1276 = phi_3785_;
                                        phi_3802_ = _e1276;
                                        if _e1276 {
                                            break;
                                        }
                                        let _e1277 = local;
                                        let _e1278 = local_1;
                                        let _e1279 = local_2;
                                        let _e1280 = local_3;
                                        if _e498 {
                                            phi_1934_ = type_38(array<i32, 3>(_e1280[0], _e1280[1], _e1280[2]), array<i32, 3>(_e1279[0], _e1279[1], _e1279[2]));
                                        } else {
                                            phi_1934_ = type_38(array<i32, 3>(_e1278[0], _e1278[1], _e1278[2]), array<i32, 3>(_e1277[0], _e1277[1], _e1277[2]));
                                        }
                                        let _e1300 = phi_1934_;
                                        local_11 = array<i32, 3>(_e1300.member[0], _e1300.member[1], _e1300.member[2]);
                                        local_10 = array<i32, 3>(_e1300.member_1[0], _e1300.member_1[1], _e1300.member_1[2]);
                                        phi_3804_ = _e1276;
                                        phi_1952_ = select(_e492.member_2, _e492.member_1, _e498);
                                    }
                                    let _e1313 = phi_3804_;
                                    let _e1315 = phi_1952_;
                                    phi_3803_ = _e1313;
                                    phi_679_ = _e1315;
                                    phi_1954_ = select(true, false, _e486);
                                } else {
                                    phi_3803_ = _e463;
                                    phi_679_ = u32();
                                    phi_1954_ = false;
                                }
                                let _e1318 = phi_3803_;
                                let _e1320 = phi_679_;
                                let _e1322 = phi_1954_;
                                continue;
                                continuing {
                                    phi_3745_ = _e1318;
                                    phi_675_ = _e480;
                                    phi_678_ = _e1320;
                                    phi_3802_ = _e1318;
                                    break if !(_e1322);
                                }
                            }
                            let _e1325 = phi_3802_;
                            if _e1325 {
                                break;
                            }
                            let _e1326 = local_10;
                            let _e1327 = local_11;
                            local_9 = _e1327;
                            local_8 = _e1326;
                            if _e109 {
                            } else {
                                break;
                            }
                            let _e1331 = global_4.member[_e104].member_1;
                            if (_e1331 == 2147483648u) {
                                phi_2005_ = type_30(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                            } else {
                                let _e1337 = global_4.member[_e104].member[0u];
                                let _e1342 = global_4.member[_e104].member[1u];
                                let _e1347 = global_4.member[_e104].member[2u];
                                phi_2005_ = type_30(vec3<f32>(_e1337[0], _e1342[0], _e1347[0]), vec3<f32>(_e1337[2], _e1342[2], _e1347[2]));
                            }
                            let _e1358 = phi_2005_;
                            let _e1362 = global_4.member[_e104].member_2;
                            if (_e1362 == 2147483648u) {
                                phi_2027_ = _e1358;
                            } else {
                                let _e1368 = global_4.member[_e104].member[0u];
                                let _e1373 = global_4.member[_e104].member[1u];
                                let _e1378 = global_4.member[_e104].member[2u];
                                phi_2027_ = type_30(vec3<f32>(_e1368[1], _e1373[1], _e1378[1]), vec3<f32>(_e1368[3], _e1373[3], _e1378[3]));
                            }
                            let _e1389 = phi_2027_;
                            let _e1402 = bitcast<u32>(_e1358.member.x);
                            let _e1405 = ((_e1402 >> bitcast<u32>(23i)) & 255u);
                            let _e1407 = select(0u, 1u, (_e1405 != 0u));
                            let _e1411 = ((_e1402 & 8388607u) | (_e1407 << bitcast<u32>(23i)));
                            let _e1416 = (_e100 - ((bitcast<i32>(_e1405) - bitcast<i32>(_e1407)) + -149i));
                            let _e1417 = (_e1416 < 0i);
                            if _e1417 {
                                phi_2054_ = -(_e1416);
                            } else {
                                phi_2054_ = 0i;
                            }
                            let _e1420 = phi_2054_;
                            if _e1417 {
                                phi_2064_ = 0i;
                            } else {
                                phi_2064_ = select(_e1416, 31i, (_e1416 > 31i));
                            }
                            let _e1424 = phi_2064_;
                            let _e1429 = (_e1424 & 31i);
                            let _e1439 = (bitcast<i32>(_e1402) >> bitcast<u32>(31i));
                            let _e1447 = bitcast<u32>(_e1358.member.y);
                            let _e1450 = ((_e1447 >> bitcast<u32>(23i)) & 255u);
                            let _e1452 = select(0u, 1u, (_e1450 != 0u));
                            let _e1456 = ((_e1447 & 8388607u) | (_e1452 << bitcast<u32>(23i)));
                            let _e1461 = (_e100 - ((bitcast<i32>(_e1450) - bitcast<i32>(_e1452)) + -149i));
                            let _e1462 = (_e1461 < 0i);
                            if _e1462 {
                                phi_2111_ = -(_e1461);
                            } else {
                                phi_2111_ = 0i;
                            }
                            let _e1465 = phi_2111_;
                            if _e1462 {
                                phi_2121_ = 0i;
                            } else {
                                phi_2121_ = select(_e1461, 31i, (_e1461 > 31i));
                            }
                            let _e1469 = phi_2121_;
                            let _e1474 = (_e1469 & 31i);
                            let _e1484 = (bitcast<i32>(_e1447) >> bitcast<u32>(31i));
                            let _e1492 = bitcast<u32>(_e1358.member.z);
                            let _e1495 = ((_e1492 >> bitcast<u32>(23i)) & 255u);
                            let _e1497 = select(0u, 1u, (_e1495 != 0u));
                            let _e1501 = ((_e1492 & 8388607u) | (_e1497 << bitcast<u32>(23i)));
                            let _e1506 = (_e100 - ((bitcast<i32>(_e1495) - bitcast<i32>(_e1497)) + -149i));
                            let _e1507 = (_e1506 < 0i);
                            if _e1507 {
                                phi_2168_ = -(_e1506);
                            } else {
                                phi_2168_ = 0i;
                            }
                            let _e1510 = phi_2168_;
                            if _e1507 {
                                phi_2178_ = 0i;
                            } else {
                                phi_2178_ = select(_e1506, 31i, (_e1506 > 31i));
                            }
                            let _e1514 = phi_2178_;
                            let _e1519 = (_e1514 & 31i);
                            let _e1529 = (bitcast<i32>(_e1492) >> bitcast<u32>(31i));
                            let _e1538 = bitcast<u32>(-(_e1358.member_1.x));
                            let _e1541 = ((_e1538 >> bitcast<u32>(23i)) & 255u);
                            let _e1543 = select(0u, 1u, (_e1541 != 0u));
                            let _e1547 = ((_e1538 & 8388607u) | (_e1543 << bitcast<u32>(23i)));
                            let _e1552 = (_e100 - ((bitcast<i32>(_e1541) - bitcast<i32>(_e1543)) + -149i));
                            let _e1553 = (_e1552 < 0i);
                            if _e1553 {
                                phi_2227_ = -(_e1552);
                            } else {
                                phi_2227_ = 0i;
                            }
                            let _e1556 = phi_2227_;
                            if _e1553 {
                                phi_2237_ = 0i;
                            } else {
                                phi_2237_ = select(_e1552, 31i, (_e1552 > 31i));
                            }
                            let _e1560 = phi_2237_;
                            let _e1565 = (_e1560 & 31i);
                            let _e1575 = (bitcast<i32>(_e1538) >> bitcast<u32>(31i));
                            let _e1585 = bitcast<u32>(-(_e1358.member_1.y));
                            let _e1588 = ((_e1585 >> bitcast<u32>(23i)) & 255u);
                            let _e1590 = select(0u, 1u, (_e1588 != 0u));
                            let _e1594 = ((_e1585 & 8388607u) | (_e1590 << bitcast<u32>(23i)));
                            let _e1599 = (_e100 - ((bitcast<i32>(_e1588) - bitcast<i32>(_e1590)) + -149i));
                            let _e1600 = (_e1599 < 0i);
                            if _e1600 {
                                phi_2286_ = -(_e1599);
                            } else {
                                phi_2286_ = 0i;
                            }
                            let _e1603 = phi_2286_;
                            if _e1600 {
                                phi_2296_ = 0i;
                            } else {
                                phi_2296_ = select(_e1599, 31i, (_e1599 > 31i));
                            }
                            let _e1607 = phi_2296_;
                            let _e1612 = (_e1607 & 31i);
                            let _e1622 = (bitcast<i32>(_e1585) >> bitcast<u32>(31i));
                            let _e1632 = bitcast<u32>(-(_e1358.member_1.z));
                            let _e1635 = ((_e1632 >> bitcast<u32>(23i)) & 255u);
                            let _e1637 = select(0u, 1u, (_e1635 != 0u));
                            let _e1641 = ((_e1632 & 8388607u) | (_e1637 << bitcast<u32>(23i)));
                            let _e1646 = (_e100 - ((bitcast<i32>(_e1635) - bitcast<i32>(_e1637)) + -149i));
                            let _e1647 = (_e1646 < 0i);
                            if _e1647 {
                                phi_2345_ = -(_e1646);
                            } else {
                                phi_2345_ = 0i;
                            }
                            let _e1650 = phi_2345_;
                            if _e1647 {
                                phi_2355_ = 0i;
                            } else {
                                phi_2355_ = select(_e1646, 31i, (_e1646 > 31i));
                            }
                            let _e1654 = phi_2355_;
                            let _e1659 = (_e1654 & 31i);
                            let _e1669 = (bitcast<i32>(_e1632) >> bitcast<u32>(31i));
                            local_19 = array<i32, 3>((((bitcast<i32>(((_e1411 << bitcast<u32>((bitcast<u32>(_e1420) & 31u))) >> bitcast<u32>(_e1429))) + select(0i, 1i, (((_e1411 & ((1u << bitcast<u32>(_e1429)) - 1u)) != 0u) && (_e1439 != 0i)))) ^ _e1439) - _e1439), (((bitcast<i32>(((_e1456 << bitcast<u32>((bitcast<u32>(_e1465) & 31u))) >> bitcast<u32>(_e1474))) + select(0i, 1i, (((_e1456 & ((1u << bitcast<u32>(_e1474)) - 1u)) != 0u) && (_e1484 != 0i)))) ^ _e1484) - _e1484), (((bitcast<i32>(((_e1501 << bitcast<u32>((bitcast<u32>(_e1510) & 31u))) >> bitcast<u32>(_e1519))) + select(0i, 1i, (((_e1501 & ((1u << bitcast<u32>(_e1519)) - 1u)) != 0u) && (_e1529 != 0i)))) ^ _e1529) - _e1529));
                            local_18 = array<i32, 3>(-((((bitcast<i32>(((_e1547 << bitcast<u32>((bitcast<u32>(_e1556) & 31u))) >> bitcast<u32>(_e1565))) + select(0i, 1i, (((_e1547 & ((1u << bitcast<u32>(_e1565)) - 1u)) != 0u) && (_e1575 != 0i)))) ^ _e1575) - _e1575)), -((((bitcast<i32>(((_e1594 << bitcast<u32>((bitcast<u32>(_e1603) & 31u))) >> bitcast<u32>(_e1612))) + select(0i, 1i, (((_e1594 & ((1u << bitcast<u32>(_e1612)) - 1u)) != 0u) && (_e1622 != 0i)))) ^ _e1622) - _e1622)), -((((bitcast<i32>(((_e1641 << bitcast<u32>((bitcast<u32>(_e1650) & 31u))) >> bitcast<u32>(_e1659))) + select(0i, 1i, (((_e1641 & ((1u << bitcast<u32>(_e1659)) - 1u)) != 0u) && (_e1669 != 0i)))) ^ _e1669) - _e1669)));
                            let _e1692 = bitcast<u32>(_e1389.member.x);
                            let _e1695 = ((_e1692 >> bitcast<u32>(23i)) & 255u);
                            let _e1697 = select(0u, 1u, (_e1695 != 0u));
                            let _e1701 = ((_e1692 & 8388607u) | (_e1697 << bitcast<u32>(23i)));
                            let _e1706 = (_e100 - ((bitcast<i32>(_e1695) - bitcast<i32>(_e1697)) + -149i));
                            let _e1707 = (_e1706 < 0i);
                            if _e1707 {
                                phi_2422_ = -(_e1706);
                            } else {
                                phi_2422_ = 0i;
                            }
                            let _e1710 = phi_2422_;
                            if _e1707 {
                                phi_2432_ = 0i;
                            } else {
                                phi_2432_ = select(_e1706, 31i, (_e1706 > 31i));
                            }
                            let _e1714 = phi_2432_;
                            let _e1719 = (_e1714 & 31i);
                            let _e1729 = (bitcast<i32>(_e1692) >> bitcast<u32>(31i));
                            let _e1737 = bitcast<u32>(_e1389.member.y);
                            let _e1740 = ((_e1737 >> bitcast<u32>(23i)) & 255u);
                            let _e1742 = select(0u, 1u, (_e1740 != 0u));
                            let _e1746 = ((_e1737 & 8388607u) | (_e1742 << bitcast<u32>(23i)));
                            let _e1751 = (_e100 - ((bitcast<i32>(_e1740) - bitcast<i32>(_e1742)) + -149i));
                            let _e1752 = (_e1751 < 0i);
                            if _e1752 {
                                phi_2479_ = -(_e1751);
                            } else {
                                phi_2479_ = 0i;
                            }
                            let _e1755 = phi_2479_;
                            if _e1752 {
                                phi_2489_ = 0i;
                            } else {
                                phi_2489_ = select(_e1751, 31i, (_e1751 > 31i));
                            }
                            let _e1759 = phi_2489_;
                            let _e1764 = (_e1759 & 31i);
                            let _e1774 = (bitcast<i32>(_e1737) >> bitcast<u32>(31i));
                            let _e1782 = bitcast<u32>(_e1389.member.z);
                            let _e1785 = ((_e1782 >> bitcast<u32>(23i)) & 255u);
                            let _e1787 = select(0u, 1u, (_e1785 != 0u));
                            let _e1791 = ((_e1782 & 8388607u) | (_e1787 << bitcast<u32>(23i)));
                            let _e1796 = (_e100 - ((bitcast<i32>(_e1785) - bitcast<i32>(_e1787)) + -149i));
                            let _e1797 = (_e1796 < 0i);
                            if _e1797 {
                                phi_2536_ = -(_e1796);
                            } else {
                                phi_2536_ = 0i;
                            }
                            let _e1800 = phi_2536_;
                            if _e1797 {
                                phi_2546_ = 0i;
                            } else {
                                phi_2546_ = select(_e1796, 31i, (_e1796 > 31i));
                            }
                            let _e1804 = phi_2546_;
                            let _e1809 = (_e1804 & 31i);
                            let _e1819 = (bitcast<i32>(_e1782) >> bitcast<u32>(31i));
                            let _e1828 = bitcast<u32>(-(_e1389.member_1.x));
                            let _e1831 = ((_e1828 >> bitcast<u32>(23i)) & 255u);
                            let _e1833 = select(0u, 1u, (_e1831 != 0u));
                            let _e1837 = ((_e1828 & 8388607u) | (_e1833 << bitcast<u32>(23i)));
                            let _e1842 = (_e100 - ((bitcast<i32>(_e1831) - bitcast<i32>(_e1833)) + -149i));
                            let _e1843 = (_e1842 < 0i);
                            if _e1843 {
                                phi_2595_ = -(_e1842);
                            } else {
                                phi_2595_ = 0i;
                            }
                            let _e1846 = phi_2595_;
                            if _e1843 {
                                phi_2605_ = 0i;
                            } else {
                                phi_2605_ = select(_e1842, 31i, (_e1842 > 31i));
                            }
                            let _e1850 = phi_2605_;
                            let _e1855 = (_e1850 & 31i);
                            let _e1865 = (bitcast<i32>(_e1828) >> bitcast<u32>(31i));
                            let _e1875 = bitcast<u32>(-(_e1389.member_1.y));
                            let _e1878 = ((_e1875 >> bitcast<u32>(23i)) & 255u);
                            let _e1880 = select(0u, 1u, (_e1878 != 0u));
                            let _e1884 = ((_e1875 & 8388607u) | (_e1880 << bitcast<u32>(23i)));
                            let _e1889 = (_e100 - ((bitcast<i32>(_e1878) - bitcast<i32>(_e1880)) + -149i));
                            let _e1890 = (_e1889 < 0i);
                            if _e1890 {
                                phi_2654_ = -(_e1889);
                            } else {
                                phi_2654_ = 0i;
                            }
                            let _e1893 = phi_2654_;
                            if _e1890 {
                                phi_2664_ = 0i;
                            } else {
                                phi_2664_ = select(_e1889, 31i, (_e1889 > 31i));
                            }
                            let _e1897 = phi_2664_;
                            let _e1902 = (_e1897 & 31i);
                            let _e1912 = (bitcast<i32>(_e1875) >> bitcast<u32>(31i));
                            let _e1922 = bitcast<u32>(-(_e1389.member_1.z));
                            let _e1925 = ((_e1922 >> bitcast<u32>(23i)) & 255u);
                            let _e1927 = select(0u, 1u, (_e1925 != 0u));
                            let _e1931 = ((_e1922 & 8388607u) | (_e1927 << bitcast<u32>(23i)));
                            let _e1936 = (_e100 - ((bitcast<i32>(_e1925) - bitcast<i32>(_e1927)) + -149i));
                            let _e1937 = (_e1936 < 0i);
                            if _e1937 {
                                phi_2713_ = -(_e1936);
                            } else {
                                phi_2713_ = 0i;
                            }
                            let _e1940 = phi_2713_;
                            if _e1937 {
                                phi_2723_ = 0i;
                            } else {
                                phi_2723_ = select(_e1936, 31i, (_e1936 > 31i));
                            }
                            let _e1944 = phi_2723_;
                            let _e1949 = (_e1944 & 31i);
                            let _e1959 = (bitcast<i32>(_e1922) >> bitcast<u32>(31i));
                            local_17 = array<i32, 3>((((bitcast<i32>(((_e1701 << bitcast<u32>((bitcast<u32>(_e1710) & 31u))) >> bitcast<u32>(_e1719))) + select(0i, 1i, (((_e1701 & ((1u << bitcast<u32>(_e1719)) - 1u)) != 0u) && (_e1729 != 0i)))) ^ _e1729) - _e1729), (((bitcast<i32>(((_e1746 << bitcast<u32>((bitcast<u32>(_e1755) & 31u))) >> bitcast<u32>(_e1764))) + select(0i, 1i, (((_e1746 & ((1u << bitcast<u32>(_e1764)) - 1u)) != 0u) && (_e1774 != 0i)))) ^ _e1774) - _e1774), (((bitcast<i32>(((_e1791 << bitcast<u32>((bitcast<u32>(_e1800) & 31u))) >> bitcast<u32>(_e1809))) + select(0i, 1i, (((_e1791 & ((1u << bitcast<u32>(_e1809)) - 1u)) != 0u) && (_e1819 != 0i)))) ^ _e1819) - _e1819));
                            local_16 = array<i32, 3>(-((((bitcast<i32>(((_e1837 << bitcast<u32>((bitcast<u32>(_e1846) & 31u))) >> bitcast<u32>(_e1855))) + select(0i, 1i, (((_e1837 & ((1u << bitcast<u32>(_e1855)) - 1u)) != 0u) && (_e1865 != 0i)))) ^ _e1865) - _e1865)), -((((bitcast<i32>(((_e1884 << bitcast<u32>((bitcast<u32>(_e1893) & 31u))) >> bitcast<u32>(_e1902))) + select(0i, 1i, (((_e1884 & ((1u << bitcast<u32>(_e1902)) - 1u)) != 0u) && (_e1912 != 0i)))) ^ _e1912) - _e1912)), -((((bitcast<i32>(((_e1931 << bitcast<u32>((bitcast<u32>(_e1940) & 31u))) >> bitcast<u32>(_e1949))) + select(0i, 1i, (((_e1931 & ((1u << bitcast<u32>(_e1949)) - 1u)) != 0u) && (_e1959 != 0i)))) ^ _e1959) - _e1959)));
                            local_20 = array<u32, 4>(0u, 0u, 0u, 0u);
                            phi_2767_ = type_8(0u, 3u);
                            loop {
                                let _e1971 = phi_2767_;
                                if (_e1971.member < _e1971.member_1) {
                                    phi_2768_ = type_8((_e1971.member + 1u), _e1971.member_1);
                                    phi_2791_ = type_8(1u, _e1971.member);
                                } else {
                                    phi_2768_ = _e1971;
                                    phi_2791_ = type_8(0u, type_8().member_1);
                                }
                                let _e1984 = phi_2768_;
                                let _e1986 = phi_2791_;
                                let _e1990 = (bitcast<i32>(_e1986.member) != 0i);
                                if _e1990 {
                                    let _e1991 = (_e1986.member_1 < 3u);
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e1993 = local_9[_e1986.member_1];
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e1995 = local_8[_e1986.member_1];
                                    let _e1997 = bitcast<u32>((_e1995 - _e1993));
                                    let _e2002 = select((bitcast<u32>(31i) - firstLeadingBit(_e1997)), 32u, (_e1997 == 0u));
                                    if ((32u - _e2002) > 10u) {
                                        phi_2826_ = (22u - _e2002);
                                    } else {
                                        phi_2826_ = 0u;
                                    }
                                    let _e2007 = phi_2826_;
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2009 = local_19[_e1986.member_1];
                                    let _e2010 = (_e2009 - _e1993);
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2012 = local_17[_e1986.member_1];
                                    let _e2013 = (_e2012 - _e1993);
                                    let _e2014 = (_e2010 > _e2013);
                                    let _e2017 = (_e2007 & 31u);
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2026 = local_18[_e1986.member_1];
                                    let _e2027 = (_e1995 - _e2026);
                                    if _e1991 {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    let _e2029 = local_16[_e1986.member_1];
                                    let _e2030 = (_e1995 - _e2029);
                                    let _e2031 = (_e2027 > _e2030);
                                    let _e2044 = ((1u + _e1986.member_1) % 4u);
                                    if (_e2044 < 4u) {
                                    } else {
                                        phi_3807_ = true;
                                        break;
                                    }
                                    local_20[_e2044] = ((((bitcast<u32>(select(_e2013, _e2010, _e2014)) >> bitcast<u32>(_e2017)) & 1023u) | (select(0u, 1u, _e2014) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e2030, _e2027, _e2031)) >> bitcast<u32>(_e2017)) & 1023u) | (select(0u, 1u, _e2031) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                }
                                continue;
                                continuing {
                                    phi_2767_ = _e1984;
                                    phi_3807_ = _e1325;
                                    break if !(_e1990);
                                }
                            }
                            let _e2050 = phi_3807_;
                            if _e2050 {
                                break;
                            }
                            local_7 = array<i32, 3>(0i, 0i, 0i);
                            local_6 = array<i32, 3>(0i, 0i, 0i);
                            local_5 = array<i32, 3>(0i, 0i, 0i);
                            local_4 = array<i32, 3>(0i, 0i, 0i);
                            phi_2965_ = type_8(0u, 3u);
                            loop {
                                let _e2052 = phi_2965_;
                                if (_e2052.member < _e2052.member_1) {
                                    phi_2966_ = type_8((_e2052.member + 1u), _e2052.member_1);
                                    phi_2989_ = type_8(1u, _e2052.member);
                                } else {
                                    phi_2966_ = _e2052;
                                    phi_2989_ = type_8(0u, type_8().member_1);
                                }
                                let _e2065 = phi_2966_;
                                let _e2067 = phi_2989_;
                                let _e2071 = (bitcast<i32>(_e2067.member) != 0i);
                                if _e2071 {
                                    let _e2073 = ((1u + _e2067.member_1) % 4u);
                                    if (_e2073 < 4u) {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2076 = local_20[_e2073];
                                    let _e2078 = ((_e2067.member_1 + 1u) % 4u);
                                    if (_e2078 < 4u) {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2081 = local_20[_e2078];
                                    let _e2082 = (_e2067.member_1 < 3u);
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2084 = local_9[_e2067.member_1];
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    let _e2086 = local_8[_e2067.member_1];
                                    let _e2088 = (_e2081 >> bitcast<u32>(11u));
                                    let _e2090 = bitcast<u32>((_e2086 - _e2084));
                                    let _e2095 = select((bitcast<u32>(31i) - firstLeadingBit(_e2090)), 32u, (_e2090 == 0u));
                                    if ((32u - _e2095) > 10u) {
                                        phi_3101_ = (22u - _e2095);
                                    } else {
                                        phi_3101_ = 0u;
                                    }
                                    let _e2100 = phi_3101_;
                                    let _e2102 = (_e2100 & 31u);
                                    let _e2106 = (_e2084 + bitcast<i32>(((_e2076 & 1023u) << bitcast<u32>(_e2102))));
                                    let _e2111 = (_e2086 - bitcast<i32>(((_e2088 & 1023u) << bitcast<u32>(_e2102))));
                                    let _e2115 = (((_e2076 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    let _e2119 = (((_e2088 >> bitcast<u32>(10u)) & 1u) == 1u);
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_7[_e2067.member_1] = select(_e2084, _e2106, _e2115);
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_5[_e2067.member_1] = select(_e2106, _e2084, _e2115);
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_6[_e2067.member_1] = select(_e2086, _e2111, _e2119);
                                    if _e2082 {
                                    } else {
                                        phi_3859_ = true;
                                        break;
                                    }
                                    local_4[_e2067.member_1] = select(_e2111, _e2086, _e2119);
                                }
                                continue;
                                continuing {
                                    phi_2965_ = _e2065;
                                    phi_3859_ = _e2050;
                                    break if !(_e2071);
                                }
                            }
                            let _e2130 = phi_3859_;
                            if _e2130 {
                                break;
                            }
                            let _e2131 = local_4;
                            let _e2132 = local_5;
                            let _e2133 = local_6;
                            let _e2134 = local_7;
                            let _e2135 = local_20;
                            if _e110 {
                            } else {
                                break;
                            }
                            global_5.member[_e104] = array<u32, 4>(_e2135[0], _e2135[1], _e2135[2], _e2135[3]);
                            if _e111 {
                            } else {
                                break;
                            }
                            global_6.member[_e104] = type_38(array<i32, 3>(_e1327[0], _e1327[1], _e1327[2]), array<i32, 3>(_e1326[0], _e1326[1], _e1326[2]));
                            if _e109 {
                            } else {
                                break;
                            }
                            if ((_e1331 & 2147483648u) != 0u) {
                                let _e2174 = ((bitcast<u32>((_e2133[0] - _e2134[0])) | bitcast<u32>((_e2133[1] - _e2134[1]))) | bitcast<u32>((_e2133[2] - _e2134[2])));
                                if (_e2174 < 1024u) {
                                    phi_3335_ = 0u;
                                } else {
                                    phi_3335_ = select(2u, 1u, (_e2174 < 2097152u));
                                }
                                let _e2179 = phi_3335_;
                                switch bitcast<i32>(_e2179) {
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
                                let _e2182 = phi_3341_;
                                phi_3348_ = type_8(0u, ((_e1331 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2190 = phi_3348_;
                                    if (_e2190.member < _e2190.member_1) {
                                        phi_3349_ = type_8((_e2190.member + 1u), _e2190.member_1);
                                        phi_3372_ = type_8(1u, _e2190.member);
                                    } else {
                                        phi_3349_ = _e2190;
                                        phi_3372_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2203 = phi_3349_;
                                    let _e2205 = phi_3372_;
                                    let _e2209 = (bitcast<i32>(_e2205.member) != 0i);
                                    if _e2209 {
                                        let _e2211 = ((_e1331 & 268435455u) + _e2205.member_1);
                                        let _e2212 = (_e2211 < _e83);
                                        if _e2212 {
                                            if _e2212 {
                                            } else {
                                                phi_3876_ = true;
                                                break;
                                            }
                                            global_7.member[_e2211] = ((3u * _e2182) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3348_ = _e2203;
                                        phi_3876_ = _e2130;
                                        break if !(_e2209);
                                    }
                                }
                                let _e2216 = phi_3876_;
                                if _e2216 {
                                    break;
                                }
                                phi_3891_ = _e2216;
                            } else {
                                phi_3891_ = _e2130;
                            }
                            let _e2218 = phi_3891_;
                            if _e109 {
                            } else {
                                break;
                            }
                            if ((_e1362 & 2147483648u) != 0u) {
                                let _e2228 = ((bitcast<u32>((_e2131[0] - _e2132[0])) | bitcast<u32>((_e2131[1] - _e2132[1]))) | bitcast<u32>((_e2131[2] - _e2132[2])));
                                if (_e2228 < 1024u) {
                                    phi_3468_ = 0u;
                                } else {
                                    phi_3468_ = select(2u, 1u, (_e2228 < 2097152u));
                                }
                                let _e2233 = phi_3468_;
                                switch bitcast<i32>(_e2233) {
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
                                let _e2236 = phi_3474_;
                                phi_3481_ = type_8(0u, ((_e1362 >> bitcast<u32>(28u)) & 7u));
                                loop {
                                    let _e2244 = phi_3481_;
                                    if (_e2244.member < _e2244.member_1) {
                                        phi_3482_ = type_8((_e2244.member + 1u), _e2244.member_1);
                                        phi_3505_ = type_8(1u, _e2244.member);
                                    } else {
                                        phi_3482_ = _e2244;
                                        phi_3505_ = type_8(0u, type_8().member_1);
                                    }
                                    let _e2257 = phi_3482_;
                                    let _e2259 = phi_3505_;
                                    let _e2263 = (bitcast<i32>(_e2259.member) != 0i);
                                    if _e2263 {
                                        let _e2265 = ((_e1362 & 268435455u) + _e2259.member_1);
                                        let _e2266 = (_e2265 < _e83);
                                        if _e2266 {
                                            if _e2266 {
                                            } else {
                                                phi_3884_ = true;
                                                break;
                                            }
                                            global_7.member[_e2265] = ((3u * _e2236) + 1u);
                                        }
                                    }
                                    continue;
                                    continuing {
                                        phi_3481_ = _e2257;
                                        phi_3884_ = _e2218;
                                        break if !(_e2263);
                                    }
                                }
                                let _e2270 = phi_3884_;
                                if _e2270 {
                                    break;
                                }
                            }
                            if (_e104 == 0u) {
                                if (_e86 == 0u) {
                                } else {
                                    if (0u < _e86) {
                                    } else {
                                        break;
                                    }
                                    global_8.member[0u] = type_31(array<u32, 4>(bitcast<u32>(_e1327[0]), bitcast<u32>(_e1327[1]), bitcast<u32>(_e1327[2]), bitcast<u32>(_e100)), array<u32, 4>(bitcast<u32>(_e1326[0]), bitcast<u32>(_e1326[1]), bitcast<u32>(_e1326[2]), 0u));
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
