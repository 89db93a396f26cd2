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
    var phi_171_: type_18;
    var phi_189_: type_23;
    var phi_207_: type_23;
    var phi_273_: i32;
    var phi_283_: i32;
    var phi_330_: i32;
    var phi_340_: i32;
    var phi_387_: i32;
    var phi_397_: i32;
    var phi_446_: i32;
    var phi_456_: i32;
    var phi_505_: i32;
    var phi_515_: i32;
    var phi_564_: i32;
    var phi_574_: i32;
    var phi_3649_: bool;
    var phi_618_: type_4;
    var phi_621_: u32;
    var phi_619_: type_4;
    var phi_644_: type_4;
    var phi_666_: type_18;
    var phi_674_: bool;
    var phi_692_: type_23;
    var phi_710_: type_23;
    var phi_737_: i32;
    var phi_747_: i32;
    var phi_794_: i32;
    var phi_804_: i32;
    var phi_851_: i32;
    var phi_861_: i32;
    var phi_910_: i32;
    var phi_920_: i32;
    var phi_969_: i32;
    var phi_979_: i32;
    var phi_1028_: i32;
    var phi_1038_: i32;
    var phi_1105_: i32;
    var phi_1115_: i32;
    var phi_1162_: i32;
    var phi_1172_: i32;
    var phi_1219_: i32;
    var phi_1229_: i32;
    var phi_1278_: i32;
    var phi_1288_: i32;
    var phi_1337_: i32;
    var phi_1347_: i32;
    var phi_1396_: i32;
    var phi_1406_: i32;
    var phi_1450_: type_4;
    var phi_1451_: type_4;
    var phi_1474_: type_4;
    var phi_1509_: u32;
    var phi_3604_: bool;
    var phi_1648_: type_4;
    var phi_1649_: type_4;
    var phi_1672_: type_4;
    var phi_1784_: u32;
    var phi_3687_: bool;
    var phi_1877_: type_29;
    var phi_3706_: bool;
    var phi_1895_: u32;
    var phi_3705_: bool;
    var phi_622_: u32;
    var phi_1897_: bool;
    var phi_3704_: bool;
    var phi_1948_: type_23;
    var phi_1970_: type_23;
    var phi_1997_: i32;
    var phi_2007_: i32;
    var phi_2054_: i32;
    var phi_2064_: i32;
    var phi_2111_: i32;
    var phi_2121_: i32;
    var phi_2170_: i32;
    var phi_2180_: i32;
    var phi_2229_: i32;
    var phi_2239_: i32;
    var phi_2288_: i32;
    var phi_2298_: i32;
    var phi_2365_: i32;
    var phi_2375_: i32;
    var phi_2422_: i32;
    var phi_2432_: i32;
    var phi_2479_: i32;
    var phi_2489_: i32;
    var phi_2538_: i32;
    var phi_2548_: i32;
    var phi_2597_: i32;
    var phi_2607_: i32;
    var phi_2656_: i32;
    var phi_2666_: i32;
    var phi_2710_: type_4;
    var phi_2711_: type_4;
    var phi_2734_: type_4;
    var phi_2769_: u32;
    var phi_3709_: bool;
    var phi_2908_: type_4;
    var phi_2909_: type_4;
    var phi_2932_: type_4;
    var phi_3761_: bool;
    var phi_3143_: u32;
    var phi_3145_: u32;
    var phi_3146_: bool;
    var phi_3162_: u32;
    var phi_3164_: u32;
    var phi_3165_: bool;
    var phi_3170_: u32;
    var phi_3198_: u32;
    var phi_3213_: u32;
    var phi_3228_: u32;
    var phi_3330_: type_4;
    var phi_3331_: type_4;
    var phi_3354_: type_4;
    var phi_3771_: bool;

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
                            phi_171_ = _e85;
                        } else {
                            phi_171_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e87 = phi_171_;
                        if (_e87.member_1 == 2147483648u) {
                            phi_189_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_189_ = type_23(vec3<f32>(_e87.member[0][0], _e87.member[1][0], _e87.member[2][0]), vec3<f32>(_e87.member[0][2], _e87.member[1][2], _e87.member[2][2]));
                        }
                        let _e106 = phi_189_;
                        if (_e87.member_2 == 2147483648u) {
                            phi_207_ = _e106;
                        } else {
                            phi_207_ = type_23(vec3<f32>(_e87.member[0][1], _e87.member[1][1], _e87.member[2][1]), vec3<f32>(_e87.member[0][3], _e87.member[1][3], _e87.member[2][3]));
                        }
                        let _e125 = phi_207_;
                        let _e154 = bitcast<u32>(select(_e125.member.x, _e106.member.x, (_e106.member.x < _e125.member.x)));
                        let _e157 = ((_e154 >> bitcast<u32>(23i)) & 255u);
                        let _e159 = select(0u, 1u, (_e157 != 0u));
                        let _e163 = ((_e154 & 8388607u) | (_e159 << bitcast<u32>(23i)));
                        let _e166 = (bitcast<i32>(_e157) - bitcast<i32>(_e159));
                        let _e167 = (125i - _e166);
                        let _e168 = (_e167 < 0i);
                        if _e168 {
                            phi_273_ = (_e166 - 125i);
                        } else {
                            phi_273_ = 0i;
                        }
                        let _e171 = phi_273_;
                        if _e168 {
                            phi_283_ = 0i;
                        } else {
                            phi_283_ = select(_e167, 31i, (_e167 > 31i));
                        }
                        let _e175 = phi_283_;
                        let _e180 = (_e175 & 31i);
                        let _e190 = (bitcast<i32>(_e154) >> bitcast<u32>(31i));
                        let _e198 = bitcast<u32>(select(_e125.member.y, _e106.member.y, (_e106.member.y < _e125.member.y)));
                        let _e201 = ((_e198 >> bitcast<u32>(23i)) & 255u);
                        let _e203 = select(0u, 1u, (_e201 != 0u));
                        let _e207 = ((_e198 & 8388607u) | (_e203 << bitcast<u32>(23i)));
                        let _e210 = (bitcast<i32>(_e201) - bitcast<i32>(_e203));
                        let _e211 = (125i - _e210);
                        let _e212 = (_e211 < 0i);
                        if _e212 {
                            phi_330_ = (_e210 - 125i);
                        } else {
                            phi_330_ = 0i;
                        }
                        let _e215 = phi_330_;
                        if _e212 {
                            phi_340_ = 0i;
                        } else {
                            phi_340_ = select(_e211, 31i, (_e211 > 31i));
                        }
                        let _e219 = phi_340_;
                        let _e224 = (_e219 & 31i);
                        let _e234 = (bitcast<i32>(_e198) >> bitcast<u32>(31i));
                        let _e242 = bitcast<u32>(select(_e125.member.z, _e106.member.z, (_e106.member.z < _e125.member.z)));
                        let _e245 = ((_e242 >> bitcast<u32>(23i)) & 255u);
                        let _e247 = select(0u, 1u, (_e245 != 0u));
                        let _e251 = ((_e242 & 8388607u) | (_e247 << bitcast<u32>(23i)));
                        let _e254 = (bitcast<i32>(_e245) - bitcast<i32>(_e247));
                        let _e255 = (125i - _e254);
                        let _e256 = (_e255 < 0i);
                        if _e256 {
                            phi_387_ = (_e254 - 125i);
                        } else {
                            phi_387_ = 0i;
                        }
                        let _e259 = phi_387_;
                        if _e256 {
                            phi_397_ = 0i;
                        } else {
                            phi_397_ = select(_e255, 31i, (_e255 > 31i));
                        }
                        let _e263 = phi_397_;
                        let _e268 = (_e263 & 31i);
                        let _e278 = (bitcast<i32>(_e242) >> bitcast<u32>(31i));
                        let _e287 = bitcast<u32>(-(select(_e125.member_1.x, _e106.member_1.x, (_e106.member_1.x > _e125.member_1.x))));
                        let _e290 = ((_e287 >> bitcast<u32>(23i)) & 255u);
                        let _e292 = select(0u, 1u, (_e290 != 0u));
                        let _e296 = ((_e287 & 8388607u) | (_e292 << bitcast<u32>(23i)));
                        let _e299 = (bitcast<i32>(_e290) - bitcast<i32>(_e292));
                        let _e300 = (125i - _e299);
                        let _e301 = (_e300 < 0i);
                        if _e301 {
                            phi_446_ = (_e299 - 125i);
                        } else {
                            phi_446_ = 0i;
                        }
                        let _e304 = phi_446_;
                        if _e301 {
                            phi_456_ = 0i;
                        } else {
                            phi_456_ = select(_e300, 31i, (_e300 > 31i));
                        }
                        let _e308 = phi_456_;
                        let _e313 = (_e308 & 31i);
                        let _e323 = (bitcast<i32>(_e287) >> bitcast<u32>(31i));
                        let _e333 = bitcast<u32>(-(select(_e125.member_1.y, _e106.member_1.y, (_e106.member_1.y > _e125.member_1.y))));
                        let _e336 = ((_e333 >> bitcast<u32>(23i)) & 255u);
                        let _e338 = select(0u, 1u, (_e336 != 0u));
                        let _e342 = ((_e333 & 8388607u) | (_e338 << bitcast<u32>(23i)));
                        let _e345 = (bitcast<i32>(_e336) - bitcast<i32>(_e338));
                        let _e346 = (125i - _e345);
                        let _e347 = (_e346 < 0i);
                        if _e347 {
                            phi_505_ = (_e345 - 125i);
                        } else {
                            phi_505_ = 0i;
                        }
                        let _e350 = phi_505_;
                        if _e347 {
                            phi_515_ = 0i;
                        } else {
                            phi_515_ = select(_e346, 31i, (_e346 > 31i));
                        }
                        let _e354 = phi_515_;
                        let _e359 = (_e354 & 31i);
                        let _e369 = (bitcast<i32>(_e333) >> bitcast<u32>(31i));
                        let _e379 = bitcast<u32>(-(select(_e125.member_1.z, _e106.member_1.z, (_e106.member_1.z > _e125.member_1.z))));
                        let _e382 = ((_e379 >> bitcast<u32>(23i)) & 255u);
                        let _e384 = select(0u, 1u, (_e382 != 0u));
                        let _e388 = ((_e379 & 8388607u) | (_e384 << bitcast<u32>(23i)));
                        let _e391 = (bitcast<i32>(_e382) - bitcast<i32>(_e384));
                        let _e392 = (125i - _e391);
                        let _e393 = (_e392 < 0i);
                        if _e393 {
                            phi_564_ = (_e391 - 125i);
                        } else {
                            phi_564_ = 0i;
                        }
                        let _e396 = phi_564_;
                        if _e393 {
                            phi_574_ = 0i;
                        } else {
                            phi_574_ = select(_e392, 31i, (_e392 > 31i));
                        }
                        let _e400 = phi_574_;
                        let _e405 = (_e400 & 31i);
                        let _e415 = (bitcast<i32>(_e379) >> bitcast<u32>(31i));
                        local_7 = array<i32, 3>((((bitcast<i32>(((_e163 << bitcast<u32>((bitcast<u32>(_e171) & 31u))) >> bitcast<u32>(_e180))) + select(0i, 1i, (((_e163 & ((1u << bitcast<u32>(_e180)) - 1u)) != 0u) && (_e190 != 0i)))) ^ _e190) - _e190), (((bitcast<i32>(((_e207 << bitcast<u32>((bitcast<u32>(_e215) & 31u))) >> bitcast<u32>(_e224))) + select(0i, 1i, (((_e207 & ((1u << bitcast<u32>(_e224)) - 1u)) != 0u) && (_e234 != 0i)))) ^ _e234) - _e234), (((bitcast<i32>(((_e251 << bitcast<u32>((bitcast<u32>(_e259) & 31u))) >> bitcast<u32>(_e268))) + select(0i, 1i, (((_e251 & ((1u << bitcast<u32>(_e268)) - 1u)) != 0u) && (_e278 != 0i)))) ^ _e278) - _e278));
                        local_6 = array<i32, 3>(-((((bitcast<i32>(((_e296 << bitcast<u32>((bitcast<u32>(_e304) & 31u))) >> bitcast<u32>(_e313))) + select(0i, 1i, (((_e296 & ((1u << bitcast<u32>(_e313)) - 1u)) != 0u) && (_e323 != 0i)))) ^ _e323) - _e323)), -((((bitcast<i32>(((_e342 << bitcast<u32>((bitcast<u32>(_e350) & 31u))) >> bitcast<u32>(_e359))) + select(0i, 1i, (((_e342 & ((1u << bitcast<u32>(_e359)) - 1u)) != 0u) && (_e369 != 0i)))) ^ _e369) - _e369)), -((((bitcast<i32>(((_e388 << bitcast<u32>((bitcast<u32>(_e396) & 31u))) >> bitcast<u32>(_e405))) + select(0i, 1i, (((_e388 & ((1u << bitcast<u32>(_e405)) - 1u)) != 0u) && (_e415 != 0i)))) ^ _e415) - _e415)));
                        phi_3649_ = false;
                        phi_618_ = type_4(0u, 128u);
                        phi_621_ = 0u;
                        loop {
                            let _e427 = phi_3649_;
                            let _e429 = phi_618_;
                            let _e431 = phi_621_;
                            if (_e429.member < _e429.member_1) {
                                phi_619_ = type_4((_e429.member + 1u), _e429.member_1);
                                phi_644_ = type_4(1u, _e429.member);
                            } else {
                                phi_619_ = _e429;
                                phi_644_ = type_4(0u, type_4().member_1);
                            }
                            let _e444 = phi_619_;
                            let _e446 = phi_644_;
                            if (bitcast<i32>(_e446.member) != 0i) {
                                let _e450 = (_e431 == _e75);
                                if _e450 {
                                    phi_3706_ = _e427;
                                    phi_1895_ = u32();
                                } else {
                                    let _e451 = (_e431 < _e67);
                                    if _e451 {
                                        if _e451 {
                                        } else {
                                            phi_3704_ = true;
                                            break;
                                        }
                                        let _e454 = global_2.member[_e431];
                                        phi_666_ = _e454;
                                    } else {
                                        phi_666_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e456 = phi_666_;
                                    if ((_e456.member_1 & 2147483648u) != 0u) {
                                        phi_674_ = false;
                                    } else {
                                        phi_674_ = (_e75 <= _e456.member_1);
                                    }
                                    let _e462 = phi_674_;
                                    if (_e456.member_1 == 2147483648u) {
                                        phi_692_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_692_ = type_23(vec3<f32>(_e456.member[0][0], _e456.member[1][0], _e456.member[2][0]), vec3<f32>(_e456.member[0][2], _e456.member[1][2], _e456.member[2][2]));
                                    }
                                    let _e480 = phi_692_;
                                    if (_e456.member_2 == 2147483648u) {
                                        phi_710_ = _e480;
                                    } else {
                                        phi_710_ = type_23(vec3<f32>(_e456.member[0][1], _e456.member[1][1], _e456.member[2][1]), vec3<f32>(_e456.member[0][3], _e456.member[1][3], _e456.member[2][3]));
                                    }
                                    let _e499 = phi_710_;
                                    let _e512 = bitcast<u32>(_e480.member.x);
                                    let _e515 = ((_e512 >> bitcast<u32>(23i)) & 255u);
                                    let _e517 = select(0u, 1u, (_e515 != 0u));
                                    let _e521 = ((_e512 & 8388607u) | (_e517 << bitcast<u32>(23i)));
                                    let _e524 = (bitcast<i32>(_e515) - bitcast<i32>(_e517));
                                    let _e525 = (125i - _e524);
                                    let _e526 = (_e525 < 0i);
                                    if _e526 {
                                        phi_737_ = (_e524 - 125i);
                                    } else {
                                        phi_737_ = 0i;
                                    }
                                    let _e529 = phi_737_;
                                    if _e526 {
                                        phi_747_ = 0i;
                                    } else {
                                        phi_747_ = select(_e525, 31i, (_e525 > 31i));
                                    }
                                    let _e533 = phi_747_;
                                    let _e538 = (_e533 & 31i);
                                    let _e548 = (bitcast<i32>(_e512) >> bitcast<u32>(31i));
                                    let _e556 = bitcast<u32>(_e480.member.y);
                                    let _e559 = ((_e556 >> bitcast<u32>(23i)) & 255u);
                                    let _e561 = select(0u, 1u, (_e559 != 0u));
                                    let _e565 = ((_e556 & 8388607u) | (_e561 << bitcast<u32>(23i)));
                                    let _e568 = (bitcast<i32>(_e559) - bitcast<i32>(_e561));
                                    let _e569 = (125i - _e568);
                                    let _e570 = (_e569 < 0i);
                                    if _e570 {
                                        phi_794_ = (_e568 - 125i);
                                    } else {
                                        phi_794_ = 0i;
                                    }
                                    let _e573 = phi_794_;
                                    if _e570 {
                                        phi_804_ = 0i;
                                    } else {
                                        phi_804_ = select(_e569, 31i, (_e569 > 31i));
                                    }
                                    let _e577 = phi_804_;
                                    let _e582 = (_e577 & 31i);
                                    let _e592 = (bitcast<i32>(_e556) >> bitcast<u32>(31i));
                                    let _e600 = bitcast<u32>(_e480.member.z);
                                    let _e603 = ((_e600 >> bitcast<u32>(23i)) & 255u);
                                    let _e605 = select(0u, 1u, (_e603 != 0u));
                                    let _e609 = ((_e600 & 8388607u) | (_e605 << bitcast<u32>(23i)));
                                    let _e612 = (bitcast<i32>(_e603) - bitcast<i32>(_e605));
                                    let _e613 = (125i - _e612);
                                    let _e614 = (_e613 < 0i);
                                    if _e614 {
                                        phi_851_ = (_e612 - 125i);
                                    } else {
                                        phi_851_ = 0i;
                                    }
                                    let _e617 = phi_851_;
                                    if _e614 {
                                        phi_861_ = 0i;
                                    } else {
                                        phi_861_ = select(_e613, 31i, (_e613 > 31i));
                                    }
                                    let _e621 = phi_861_;
                                    let _e626 = (_e621 & 31i);
                                    let _e636 = (bitcast<i32>(_e600) >> bitcast<u32>(31i));
                                    let _e645 = bitcast<u32>(-(_e480.member_1.x));
                                    let _e648 = ((_e645 >> bitcast<u32>(23i)) & 255u);
                                    let _e650 = select(0u, 1u, (_e648 != 0u));
                                    let _e654 = ((_e645 & 8388607u) | (_e650 << bitcast<u32>(23i)));
                                    let _e657 = (bitcast<i32>(_e648) - bitcast<i32>(_e650));
                                    let _e658 = (125i - _e657);
                                    let _e659 = (_e658 < 0i);
                                    if _e659 {
                                        phi_910_ = (_e657 - 125i);
                                    } else {
                                        phi_910_ = 0i;
                                    }
                                    let _e662 = phi_910_;
                                    if _e659 {
                                        phi_920_ = 0i;
                                    } else {
                                        phi_920_ = select(_e658, 31i, (_e658 > 31i));
                                    }
                                    let _e666 = phi_920_;
                                    let _e671 = (_e666 & 31i);
                                    let _e681 = (bitcast<i32>(_e645) >> bitcast<u32>(31i));
                                    let _e691 = bitcast<u32>(-(_e480.member_1.y));
                                    let _e694 = ((_e691 >> bitcast<u32>(23i)) & 255u);
                                    let _e696 = select(0u, 1u, (_e694 != 0u));
                                    let _e700 = ((_e691 & 8388607u) | (_e696 << bitcast<u32>(23i)));
                                    let _e703 = (bitcast<i32>(_e694) - bitcast<i32>(_e696));
                                    let _e704 = (125i - _e703);
                                    let _e705 = (_e704 < 0i);
                                    if _e705 {
                                        phi_969_ = (_e703 - 125i);
                                    } else {
                                        phi_969_ = 0i;
                                    }
                                    let _e708 = phi_969_;
                                    if _e705 {
                                        phi_979_ = 0i;
                                    } else {
                                        phi_979_ = select(_e704, 31i, (_e704 > 31i));
                                    }
                                    let _e712 = phi_979_;
                                    let _e717 = (_e712 & 31i);
                                    let _e727 = (bitcast<i32>(_e691) >> bitcast<u32>(31i));
                                    let _e737 = bitcast<u32>(-(_e480.member_1.z));
                                    let _e740 = ((_e737 >> bitcast<u32>(23i)) & 255u);
                                    let _e742 = select(0u, 1u, (_e740 != 0u));
                                    let _e746 = ((_e737 & 8388607u) | (_e742 << bitcast<u32>(23i)));
                                    let _e749 = (bitcast<i32>(_e740) - bitcast<i32>(_e742));
                                    let _e750 = (125i - _e749);
                                    let _e751 = (_e750 < 0i);
                                    if _e751 {
                                        phi_1028_ = (_e749 - 125i);
                                    } else {
                                        phi_1028_ = 0i;
                                    }
                                    let _e754 = phi_1028_;
                                    if _e751 {
                                        phi_1038_ = 0i;
                                    } else {
                                        phi_1038_ = select(_e750, 31i, (_e750 > 31i));
                                    }
                                    let _e758 = phi_1038_;
                                    let _e763 = (_e758 & 31i);
                                    let _e773 = (bitcast<i32>(_e737) >> bitcast<u32>(31i));
                                    local_11 = array<i32, 3>((((bitcast<i32>(((_e521 << bitcast<u32>((bitcast<u32>(_e529) & 31u))) >> bitcast<u32>(_e538))) + select(0i, 1i, (((_e521 & ((1u << bitcast<u32>(_e538)) - 1u)) != 0u) && (_e548 != 0i)))) ^ _e548) - _e548), (((bitcast<i32>(((_e565 << bitcast<u32>((bitcast<u32>(_e573) & 31u))) >> bitcast<u32>(_e582))) + select(0i, 1i, (((_e565 & ((1u << bitcast<u32>(_e582)) - 1u)) != 0u) && (_e592 != 0i)))) ^ _e592) - _e592), (((bitcast<i32>(((_e609 << bitcast<u32>((bitcast<u32>(_e617) & 31u))) >> bitcast<u32>(_e626))) + select(0i, 1i, (((_e609 & ((1u << bitcast<u32>(_e626)) - 1u)) != 0u) && (_e636 != 0i)))) ^ _e636) - _e636));
                                    local_10 = array<i32, 3>(-((((bitcast<i32>(((_e654 << bitcast<u32>((bitcast<u32>(_e662) & 31u))) >> bitcast<u32>(_e671))) + select(0i, 1i, (((_e654 & ((1u << bitcast<u32>(_e671)) - 1u)) != 0u) && (_e681 != 0i)))) ^ _e681) - _e681)), -((((bitcast<i32>(((_e700 << bitcast<u32>((bitcast<u32>(_e708) & 31u))) >> bitcast<u32>(_e717))) + select(0i, 1i, (((_e700 & ((1u << bitcast<u32>(_e717)) - 1u)) != 0u) && (_e727 != 0i)))) ^ _e727) - _e727)), -((((bitcast<i32>(((_e746 << bitcast<u32>((bitcast<u32>(_e754) & 31u))) >> bitcast<u32>(_e763))) + select(0i, 1i, (((_e746 & ((1u << bitcast<u32>(_e763)) - 1u)) != 0u) && (_e773 != 0i)))) ^ _e773) - _e773)));
                                    let _e796 = bitcast<u32>(_e499.member.x);
                                    let _e799 = ((_e796 >> bitcast<u32>(23i)) & 255u);
                                    let _e801 = select(0u, 1u, (_e799 != 0u));
                                    let _e805 = ((_e796 & 8388607u) | (_e801 << bitcast<u32>(23i)));
                                    let _e808 = (bitcast<i32>(_e799) - bitcast<i32>(_e801));
                                    let _e809 = (125i - _e808);
                                    let _e810 = (_e809 < 0i);
                                    if _e810 {
                                        phi_1105_ = (_e808 - 125i);
                                    } else {
                                        phi_1105_ = 0i;
                                    }
                                    let _e813 = phi_1105_;
                                    if _e810 {
                                        phi_1115_ = 0i;
                                    } else {
                                        phi_1115_ = select(_e809, 31i, (_e809 > 31i));
                                    }
                                    let _e817 = phi_1115_;
                                    let _e822 = (_e817 & 31i);
                                    let _e832 = (bitcast<i32>(_e796) >> bitcast<u32>(31i));
                                    let _e840 = bitcast<u32>(_e499.member.y);
                                    let _e843 = ((_e840 >> bitcast<u32>(23i)) & 255u);
                                    let _e845 = select(0u, 1u, (_e843 != 0u));
                                    let _e849 = ((_e840 & 8388607u) | (_e845 << bitcast<u32>(23i)));
                                    let _e852 = (bitcast<i32>(_e843) - bitcast<i32>(_e845));
                                    let _e853 = (125i - _e852);
                                    let _e854 = (_e853 < 0i);
                                    if _e854 {
                                        phi_1162_ = (_e852 - 125i);
                                    } else {
                                        phi_1162_ = 0i;
                                    }
                                    let _e857 = phi_1162_;
                                    if _e854 {
                                        phi_1172_ = 0i;
                                    } else {
                                        phi_1172_ = select(_e853, 31i, (_e853 > 31i));
                                    }
                                    let _e861 = phi_1172_;
                                    let _e866 = (_e861 & 31i);
                                    let _e876 = (bitcast<i32>(_e840) >> bitcast<u32>(31i));
                                    let _e884 = bitcast<u32>(_e499.member.z);
                                    let _e887 = ((_e884 >> bitcast<u32>(23i)) & 255u);
                                    let _e889 = select(0u, 1u, (_e887 != 0u));
                                    let _e893 = ((_e884 & 8388607u) | (_e889 << bitcast<u32>(23i)));
                                    let _e896 = (bitcast<i32>(_e887) - bitcast<i32>(_e889));
                                    let _e897 = (125i - _e896);
                                    let _e898 = (_e897 < 0i);
                                    if _e898 {
                                        phi_1219_ = (_e896 - 125i);
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
                                    let _e920 = (bitcast<i32>(_e884) >> bitcast<u32>(31i));
                                    let _e929 = bitcast<u32>(-(_e499.member_1.x));
                                    let _e932 = ((_e929 >> bitcast<u32>(23i)) & 255u);
                                    let _e934 = select(0u, 1u, (_e932 != 0u));
                                    let _e938 = ((_e929 & 8388607u) | (_e934 << bitcast<u32>(23i)));
                                    let _e941 = (bitcast<i32>(_e932) - bitcast<i32>(_e934));
                                    let _e942 = (125i - _e941);
                                    let _e943 = (_e942 < 0i);
                                    if _e943 {
                                        phi_1278_ = (_e941 - 125i);
                                    } else {
                                        phi_1278_ = 0i;
                                    }
                                    let _e946 = phi_1278_;
                                    if _e943 {
                                        phi_1288_ = 0i;
                                    } else {
                                        phi_1288_ = select(_e942, 31i, (_e942 > 31i));
                                    }
                                    let _e950 = phi_1288_;
                                    let _e955 = (_e950 & 31i);
                                    let _e965 = (bitcast<i32>(_e929) >> bitcast<u32>(31i));
                                    let _e975 = bitcast<u32>(-(_e499.member_1.y));
                                    let _e978 = ((_e975 >> bitcast<u32>(23i)) & 255u);
                                    let _e980 = select(0u, 1u, (_e978 != 0u));
                                    let _e984 = ((_e975 & 8388607u) | (_e980 << bitcast<u32>(23i)));
                                    let _e987 = (bitcast<i32>(_e978) - bitcast<i32>(_e980));
                                    let _e988 = (125i - _e987);
                                    let _e989 = (_e988 < 0i);
                                    if _e989 {
                                        phi_1337_ = (_e987 - 125i);
                                    } else {
                                        phi_1337_ = 0i;
                                    }
                                    let _e992 = phi_1337_;
                                    if _e989 {
                                        phi_1347_ = 0i;
                                    } else {
                                        phi_1347_ = select(_e988, 31i, (_e988 > 31i));
                                    }
                                    let _e996 = phi_1347_;
                                    let _e1001 = (_e996 & 31i);
                                    let _e1011 = (bitcast<i32>(_e975) >> bitcast<u32>(31i));
                                    let _e1021 = bitcast<u32>(-(_e499.member_1.z));
                                    let _e1024 = ((_e1021 >> bitcast<u32>(23i)) & 255u);
                                    let _e1026 = select(0u, 1u, (_e1024 != 0u));
                                    let _e1030 = ((_e1021 & 8388607u) | (_e1026 << bitcast<u32>(23i)));
                                    let _e1033 = (bitcast<i32>(_e1024) - bitcast<i32>(_e1026));
                                    let _e1034 = (125i - _e1033);
                                    let _e1035 = (_e1034 < 0i);
                                    if _e1035 {
                                        phi_1396_ = (_e1033 - 125i);
                                    } else {
                                        phi_1396_ = 0i;
                                    }
                                    let _e1038 = phi_1396_;
                                    if _e1035 {
                                        phi_1406_ = 0i;
                                    } else {
                                        phi_1406_ = select(_e1034, 31i, (_e1034 > 31i));
                                    }
                                    let _e1042 = phi_1406_;
                                    let _e1047 = (_e1042 & 31i);
                                    let _e1057 = (bitcast<i32>(_e1021) >> bitcast<u32>(31i));
                                    local_9 = array<i32, 3>((((bitcast<i32>(((_e805 << bitcast<u32>((bitcast<u32>(_e813) & 31u))) >> bitcast<u32>(_e822))) + select(0i, 1i, (((_e805 & ((1u << bitcast<u32>(_e822)) - 1u)) != 0u) && (_e832 != 0i)))) ^ _e832) - _e832), (((bitcast<i32>(((_e849 << bitcast<u32>((bitcast<u32>(_e857) & 31u))) >> bitcast<u32>(_e866))) + select(0i, 1i, (((_e849 & ((1u << bitcast<u32>(_e866)) - 1u)) != 0u) && (_e876 != 0i)))) ^ _e876) - _e876), (((bitcast<i32>(((_e893 << bitcast<u32>((bitcast<u32>(_e901) & 31u))) >> bitcast<u32>(_e910))) + select(0i, 1i, (((_e893 & ((1u << bitcast<u32>(_e910)) - 1u)) != 0u) && (_e920 != 0i)))) ^ _e920) - _e920));
                                    local_8 = array<i32, 3>(-((((bitcast<i32>(((_e938 << bitcast<u32>((bitcast<u32>(_e946) & 31u))) >> bitcast<u32>(_e955))) + select(0i, 1i, (((_e938 & ((1u << bitcast<u32>(_e955)) - 1u)) != 0u) && (_e965 != 0i)))) ^ _e965) - _e965)), -((((bitcast<i32>(((_e984 << bitcast<u32>((bitcast<u32>(_e992) & 31u))) >> bitcast<u32>(_e1001))) + select(0i, 1i, (((_e984 & ((1u << bitcast<u32>(_e1001)) - 1u)) != 0u) && (_e1011 != 0i)))) ^ _e1011) - _e1011)), -((((bitcast<i32>(((_e1030 << bitcast<u32>((bitcast<u32>(_e1038) & 31u))) >> bitcast<u32>(_e1047))) + select(0i, 1i, (((_e1030 & ((1u << bitcast<u32>(_e1047)) - 1u)) != 0u) && (_e1057 != 0i)))) ^ _e1057) - _e1057)));
                                    local_18 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                    phi_1450_ = type_4(0u, 3u);
                                    loop {
                                        let _e1069 = phi_1450_;
                                        if (_e1069.member < _e1069.member_1) {
                                            phi_1451_ = type_4((_e1069.member + 1u), _e1069.member_1);
                                            phi_1474_ = type_4(1u, _e1069.member);
                                        } else {
                                            phi_1451_ = _e1069;
                                            phi_1474_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1082 = phi_1451_;
                                        let _e1084 = phi_1474_;
                                        let _e1088 = (bitcast<i32>(_e1084.member) != 0i);
                                        if _e1088 {
                                            let _e1089 = (_e1084.member_1 < 3u);
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1091 = local_7[_e1084.member_1];
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1093 = local_6[_e1084.member_1];
                                            let _e1095 = bitcast<u32>((_e1093 - _e1091));
                                            let _e1100 = select((bitcast<u32>(31i) - firstLeadingBit(_e1095)), 32u, (_e1095 == 0u));
                                            if ((32u - _e1100) > 21u) {
                                                phi_1509_ = (11u - _e1100);
                                            } else {
                                                phi_1509_ = 0u;
                                            }
                                            let _e1105 = phi_1509_;
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1107 = local_11[_e1084.member_1];
                                            let _e1108 = (_e1107 - _e1091);
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1110 = local_9[_e1084.member_1];
                                            let _e1111 = (_e1110 - _e1091);
                                            let _e1112 = (_e1108 > _e1111);
                                            let _e1115 = (_e1105 & 31u);
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1124 = local_10[_e1084.member_1];
                                            let _e1125 = (_e1093 - _e1124);
                                            if _e1089 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1127 = local_8[_e1084.member_1];
                                            let _e1128 = (_e1093 - _e1127);
                                            let _e1129 = (_e1125 > _e1128);
                                            let _e1139 = (_e1084.member_1 * 2u);
                                            let _e1141 = ((1u + _e1139) % 7u);
                                            if (_e1141 < 7u) {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            local_18[_e1141] = (((bitcast<u32>(select(_e1111, _e1108, _e1112)) >> bitcast<u32>(_e1115)) & 2097151u) | (select(0u, 1u, _e1112) << bitcast<u32>(21u)));
                                            let _e1145 = ((_e1139 + 2u) % 7u);
                                            if (_e1145 < 7u) {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            local_18[_e1145] = (((bitcast<u32>(select(_e1128, _e1125, _e1129)) >> bitcast<u32>(_e1115)) & 2097151u) | (select(0u, 1u, _e1129) << bitcast<u32>(21u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_1450_ = _e1082;
                                            phi_3604_ = _e427;
                                            break if !(_e1088);
                                        }
                                    }
                                    let _e1150 = phi_3604_;
                                    phi_3704_ = _e1150;
                                    if _e1150 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_1648_ = type_4(0u, 3u);
                                    loop {
                                        let _e1152 = phi_1648_;
                                        if (_e1152.member < _e1152.member_1) {
                                            phi_1649_ = type_4((_e1152.member + 1u), _e1152.member_1);
                                            phi_1672_ = type_4(1u, _e1152.member);
                                        } else {
                                            phi_1649_ = _e1152;
                                            phi_1672_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1165 = phi_1649_;
                                        let _e1167 = phi_1672_;
                                        let _e1171 = (bitcast<i32>(_e1167.member) != 0i);
                                        if _e1171 {
                                            let _e1172 = (_e1167.member_1 * 2u);
                                            let _e1174 = ((1u + _e1172) % 7u);
                                            if (_e1174 < 7u) {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1177 = local_18[_e1174];
                                            let _e1179 = ((_e1172 + 2u) % 7u);
                                            if (_e1179 < 7u) {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1182 = local_18[_e1179];
                                            let _e1183 = (_e1167.member_1 < 3u);
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1185 = local_7[_e1167.member_1];
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1187 = local_6[_e1167.member_1];
                                            let _e1189 = bitcast<u32>((_e1187 - _e1185));
                                            let _e1194 = select((bitcast<u32>(31i) - firstLeadingBit(_e1189)), 32u, (_e1189 == 0u));
                                            if ((32u - _e1194) > 21u) {
                                                phi_1784_ = (11u - _e1194);
                                            } else {
                                                phi_1784_ = 0u;
                                            }
                                            let _e1199 = phi_1784_;
                                            let _e1201 = (_e1199 & 31u);
                                            let _e1205 = (_e1185 + bitcast<i32>(((_e1177 & 2097151u) << bitcast<u32>(_e1201))));
                                            let _e1210 = (_e1187 - bitcast<i32>(((_e1182 & 2097151u) << bitcast<u32>(_e1201))));
                                            let _e1214 = (((_e1177 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            let _e1218 = (((_e1182 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_3[_e1167.member_1] = select(_e1185, _e1205, _e1214);
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_1[_e1167.member_1] = select(_e1205, _e1185, _e1214);
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_2[_e1167.member_1] = select(_e1187, _e1210, _e1218);
                                            if _e1183 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local[_e1167.member_1] = select(_e1210, _e1187, _e1218);
                                        }
                                        continue;
                                        continuing {
                                            phi_1648_ = _e1165;
                                            phi_3687_ = _e1150;
                                            break if !(_e1171);
                                        }
                                    }
                                    let _e1229 = phi_3687_;
                                    phi_3704_ = _e1229;
                                    if _e1229 {
                                        break;
                                    }
                                    let _e1230 = local;
                                    let _e1231 = local_1;
                                    let _e1232 = local_2;
                                    let _e1233 = local_3;
                                    if _e462 {
                                        phi_1877_ = type_29(array<i32, 3>(_e1233[0], _e1233[1], _e1233[2]), array<i32, 3>(_e1232[0], _e1232[1], _e1232[2]));
                                    } else {
                                        phi_1877_ = type_29(array<i32, 3>(_e1231[0], _e1231[1], _e1231[2]), array<i32, 3>(_e1230[0], _e1230[1], _e1230[2]));
                                    }
                                    let _e1253 = phi_1877_;
                                    local_7 = array<i32, 3>(_e1253.member[0], _e1253.member[1], _e1253.member[2]);
                                    local_6 = array<i32, 3>(_e1253.member_1[0], _e1253.member_1[1], _e1253.member_1[2]);
                                    phi_3706_ = _e1229;
                                    phi_1895_ = select(_e456.member_2, _e456.member_1, _e462);
                                }
                                let _e1266 = phi_3706_;
                                let _e1268 = phi_1895_;
                                phi_3705_ = _e1266;
                                phi_622_ = _e1268;
                                phi_1897_ = select(true, false, _e450);
                            } else {
                                phi_3705_ = _e427;
                                phi_622_ = u32();
                                phi_1897_ = false;
                            }
                            let _e1271 = phi_3705_;
                            let _e1273 = phi_622_;
                            let _e1275 = phi_1897_;
                            continue;
                            continuing {
                                phi_3649_ = _e1271;
                                phi_618_ = _e444;
                                phi_621_ = _e1273;
                                phi_3704_ = _e1271;
                                break if !(_e1275);
                            }
                        }
                        let _e1278 = phi_3704_;
                        if _e1278 {
                            break;
                        }
                        let _e1279 = local_6;
                        let _e1280 = local_7;
                        local_5 = _e1280;
                        local_4 = _e1279;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e1284 = global_2.member[_e75].member_1;
                        if (_e1284 == 2147483648u) {
                            phi_1948_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1290 = global_2.member[_e75].member[0u];
                            let _e1295 = global_2.member[_e75].member[1u];
                            let _e1300 = global_2.member[_e75].member[2u];
                            phi_1948_ = type_23(vec3<f32>(_e1290[0], _e1295[0], _e1300[0]), vec3<f32>(_e1290[2], _e1295[2], _e1300[2]));
                        }
                        let _e1311 = phi_1948_;
                        let _e1315 = global_2.member[_e75].member_2;
                        if (_e1315 == 2147483648u) {
                            phi_1970_ = _e1311;
                        } else {
                            let _e1321 = global_2.member[_e75].member[0u];
                            let _e1326 = global_2.member[_e75].member[1u];
                            let _e1331 = global_2.member[_e75].member[2u];
                            phi_1970_ = type_23(vec3<f32>(_e1321[1], _e1326[1], _e1331[1]), vec3<f32>(_e1321[3], _e1326[3], _e1331[3]));
                        }
                        let _e1342 = phi_1970_;
                        let _e1355 = bitcast<u32>(_e1311.member.x);
                        let _e1358 = ((_e1355 >> bitcast<u32>(23i)) & 255u);
                        let _e1360 = select(0u, 1u, (_e1358 != 0u));
                        let _e1364 = ((_e1355 & 8388607u) | (_e1360 << bitcast<u32>(23i)));
                        let _e1367 = (bitcast<i32>(_e1358) - bitcast<i32>(_e1360));
                        let _e1368 = (125i - _e1367);
                        let _e1369 = (_e1368 < 0i);
                        if _e1369 {
                            phi_1997_ = (_e1367 - 125i);
                        } else {
                            phi_1997_ = 0i;
                        }
                        let _e1372 = phi_1997_;
                        if _e1369 {
                            phi_2007_ = 0i;
                        } else {
                            phi_2007_ = select(_e1368, 31i, (_e1368 > 31i));
                        }
                        let _e1376 = phi_2007_;
                        let _e1381 = (_e1376 & 31i);
                        let _e1391 = (bitcast<i32>(_e1355) >> bitcast<u32>(31i));
                        let _e1399 = bitcast<u32>(_e1311.member.y);
                        let _e1402 = ((_e1399 >> bitcast<u32>(23i)) & 255u);
                        let _e1404 = select(0u, 1u, (_e1402 != 0u));
                        let _e1408 = ((_e1399 & 8388607u) | (_e1404 << bitcast<u32>(23i)));
                        let _e1411 = (bitcast<i32>(_e1402) - bitcast<i32>(_e1404));
                        let _e1412 = (125i - _e1411);
                        let _e1413 = (_e1412 < 0i);
                        if _e1413 {
                            phi_2054_ = (_e1411 - 125i);
                        } else {
                            phi_2054_ = 0i;
                        }
                        let _e1416 = phi_2054_;
                        if _e1413 {
                            phi_2064_ = 0i;
                        } else {
                            phi_2064_ = select(_e1412, 31i, (_e1412 > 31i));
                        }
                        let _e1420 = phi_2064_;
                        let _e1425 = (_e1420 & 31i);
                        let _e1435 = (bitcast<i32>(_e1399) >> bitcast<u32>(31i));
                        let _e1443 = bitcast<u32>(_e1311.member.z);
                        let _e1446 = ((_e1443 >> bitcast<u32>(23i)) & 255u);
                        let _e1448 = select(0u, 1u, (_e1446 != 0u));
                        let _e1452 = ((_e1443 & 8388607u) | (_e1448 << bitcast<u32>(23i)));
                        let _e1455 = (bitcast<i32>(_e1446) - bitcast<i32>(_e1448));
                        let _e1456 = (125i - _e1455);
                        let _e1457 = (_e1456 < 0i);
                        if _e1457 {
                            phi_2111_ = (_e1455 - 125i);
                        } else {
                            phi_2111_ = 0i;
                        }
                        let _e1460 = phi_2111_;
                        if _e1457 {
                            phi_2121_ = 0i;
                        } else {
                            phi_2121_ = select(_e1456, 31i, (_e1456 > 31i));
                        }
                        let _e1464 = phi_2121_;
                        let _e1469 = (_e1464 & 31i);
                        let _e1479 = (bitcast<i32>(_e1443) >> bitcast<u32>(31i));
                        let _e1488 = bitcast<u32>(-(_e1311.member_1.x));
                        let _e1491 = ((_e1488 >> bitcast<u32>(23i)) & 255u);
                        let _e1493 = select(0u, 1u, (_e1491 != 0u));
                        let _e1497 = ((_e1488 & 8388607u) | (_e1493 << bitcast<u32>(23i)));
                        let _e1500 = (bitcast<i32>(_e1491) - bitcast<i32>(_e1493));
                        let _e1501 = (125i - _e1500);
                        let _e1502 = (_e1501 < 0i);
                        if _e1502 {
                            phi_2170_ = (_e1500 - 125i);
                        } else {
                            phi_2170_ = 0i;
                        }
                        let _e1505 = phi_2170_;
                        if _e1502 {
                            phi_2180_ = 0i;
                        } else {
                            phi_2180_ = select(_e1501, 31i, (_e1501 > 31i));
                        }
                        let _e1509 = phi_2180_;
                        let _e1514 = (_e1509 & 31i);
                        let _e1524 = (bitcast<i32>(_e1488) >> bitcast<u32>(31i));
                        let _e1534 = bitcast<u32>(-(_e1311.member_1.y));
                        let _e1537 = ((_e1534 >> bitcast<u32>(23i)) & 255u);
                        let _e1539 = select(0u, 1u, (_e1537 != 0u));
                        let _e1543 = ((_e1534 & 8388607u) | (_e1539 << bitcast<u32>(23i)));
                        let _e1546 = (bitcast<i32>(_e1537) - bitcast<i32>(_e1539));
                        let _e1547 = (125i - _e1546);
                        let _e1548 = (_e1547 < 0i);
                        if _e1548 {
                            phi_2229_ = (_e1546 - 125i);
                        } else {
                            phi_2229_ = 0i;
                        }
                        let _e1551 = phi_2229_;
                        if _e1548 {
                            phi_2239_ = 0i;
                        } else {
                            phi_2239_ = select(_e1547, 31i, (_e1547 > 31i));
                        }
                        let _e1555 = phi_2239_;
                        let _e1560 = (_e1555 & 31i);
                        let _e1570 = (bitcast<i32>(_e1534) >> bitcast<u32>(31i));
                        let _e1580 = bitcast<u32>(-(_e1311.member_1.z));
                        let _e1583 = ((_e1580 >> bitcast<u32>(23i)) & 255u);
                        let _e1585 = select(0u, 1u, (_e1583 != 0u));
                        let _e1589 = ((_e1580 & 8388607u) | (_e1585 << bitcast<u32>(23i)));
                        let _e1592 = (bitcast<i32>(_e1583) - bitcast<i32>(_e1585));
                        let _e1593 = (125i - _e1592);
                        let _e1594 = (_e1593 < 0i);
                        if _e1594 {
                            phi_2288_ = (_e1592 - 125i);
                        } else {
                            phi_2288_ = 0i;
                        }
                        let _e1597 = phi_2288_;
                        if _e1594 {
                            phi_2298_ = 0i;
                        } else {
                            phi_2298_ = select(_e1593, 31i, (_e1593 > 31i));
                        }
                        let _e1601 = phi_2298_;
                        let _e1606 = (_e1601 & 31i);
                        let _e1616 = (bitcast<i32>(_e1580) >> bitcast<u32>(31i));
                        local_15 = array<i32, 3>((((bitcast<i32>(((_e1364 << bitcast<u32>((bitcast<u32>(_e1372) & 31u))) >> bitcast<u32>(_e1381))) + select(0i, 1i, (((_e1364 & ((1u << bitcast<u32>(_e1381)) - 1u)) != 0u) && (_e1391 != 0i)))) ^ _e1391) - _e1391), (((bitcast<i32>(((_e1408 << bitcast<u32>((bitcast<u32>(_e1416) & 31u))) >> bitcast<u32>(_e1425))) + select(0i, 1i, (((_e1408 & ((1u << bitcast<u32>(_e1425)) - 1u)) != 0u) && (_e1435 != 0i)))) ^ _e1435) - _e1435), (((bitcast<i32>(((_e1452 << bitcast<u32>((bitcast<u32>(_e1460) & 31u))) >> bitcast<u32>(_e1469))) + select(0i, 1i, (((_e1452 & ((1u << bitcast<u32>(_e1469)) - 1u)) != 0u) && (_e1479 != 0i)))) ^ _e1479) - _e1479));
                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e1497 << bitcast<u32>((bitcast<u32>(_e1505) & 31u))) >> bitcast<u32>(_e1514))) + select(0i, 1i, (((_e1497 & ((1u << bitcast<u32>(_e1514)) - 1u)) != 0u) && (_e1524 != 0i)))) ^ _e1524) - _e1524)), -((((bitcast<i32>(((_e1543 << bitcast<u32>((bitcast<u32>(_e1551) & 31u))) >> bitcast<u32>(_e1560))) + select(0i, 1i, (((_e1543 & ((1u << bitcast<u32>(_e1560)) - 1u)) != 0u) && (_e1570 != 0i)))) ^ _e1570) - _e1570)), -((((bitcast<i32>(((_e1589 << bitcast<u32>((bitcast<u32>(_e1597) & 31u))) >> bitcast<u32>(_e1606))) + select(0i, 1i, (((_e1589 & ((1u << bitcast<u32>(_e1606)) - 1u)) != 0u) && (_e1616 != 0i)))) ^ _e1616) - _e1616)));
                        let _e1639 = bitcast<u32>(_e1342.member.x);
                        let _e1642 = ((_e1639 >> bitcast<u32>(23i)) & 255u);
                        let _e1644 = select(0u, 1u, (_e1642 != 0u));
                        let _e1648 = ((_e1639 & 8388607u) | (_e1644 << bitcast<u32>(23i)));
                        let _e1651 = (bitcast<i32>(_e1642) - bitcast<i32>(_e1644));
                        let _e1652 = (125i - _e1651);
                        let _e1653 = (_e1652 < 0i);
                        if _e1653 {
                            phi_2365_ = (_e1651 - 125i);
                        } else {
                            phi_2365_ = 0i;
                        }
                        let _e1656 = phi_2365_;
                        if _e1653 {
                            phi_2375_ = 0i;
                        } else {
                            phi_2375_ = select(_e1652, 31i, (_e1652 > 31i));
                        }
                        let _e1660 = phi_2375_;
                        let _e1665 = (_e1660 & 31i);
                        let _e1675 = (bitcast<i32>(_e1639) >> bitcast<u32>(31i));
                        let _e1683 = bitcast<u32>(_e1342.member.y);
                        let _e1686 = ((_e1683 >> bitcast<u32>(23i)) & 255u);
                        let _e1688 = select(0u, 1u, (_e1686 != 0u));
                        let _e1692 = ((_e1683 & 8388607u) | (_e1688 << bitcast<u32>(23i)));
                        let _e1695 = (bitcast<i32>(_e1686) - bitcast<i32>(_e1688));
                        let _e1696 = (125i - _e1695);
                        let _e1697 = (_e1696 < 0i);
                        if _e1697 {
                            phi_2422_ = (_e1695 - 125i);
                        } else {
                            phi_2422_ = 0i;
                        }
                        let _e1700 = phi_2422_;
                        if _e1697 {
                            phi_2432_ = 0i;
                        } else {
                            phi_2432_ = select(_e1696, 31i, (_e1696 > 31i));
                        }
                        let _e1704 = phi_2432_;
                        let _e1709 = (_e1704 & 31i);
                        let _e1719 = (bitcast<i32>(_e1683) >> bitcast<u32>(31i));
                        let _e1727 = bitcast<u32>(_e1342.member.z);
                        let _e1730 = ((_e1727 >> bitcast<u32>(23i)) & 255u);
                        let _e1732 = select(0u, 1u, (_e1730 != 0u));
                        let _e1736 = ((_e1727 & 8388607u) | (_e1732 << bitcast<u32>(23i)));
                        let _e1739 = (bitcast<i32>(_e1730) - bitcast<i32>(_e1732));
                        let _e1740 = (125i - _e1739);
                        let _e1741 = (_e1740 < 0i);
                        if _e1741 {
                            phi_2479_ = (_e1739 - 125i);
                        } else {
                            phi_2479_ = 0i;
                        }
                        let _e1744 = phi_2479_;
                        if _e1741 {
                            phi_2489_ = 0i;
                        } else {
                            phi_2489_ = select(_e1740, 31i, (_e1740 > 31i));
                        }
                        let _e1748 = phi_2489_;
                        let _e1753 = (_e1748 & 31i);
                        let _e1763 = (bitcast<i32>(_e1727) >> bitcast<u32>(31i));
                        let _e1772 = bitcast<u32>(-(_e1342.member_1.x));
                        let _e1775 = ((_e1772 >> bitcast<u32>(23i)) & 255u);
                        let _e1777 = select(0u, 1u, (_e1775 != 0u));
                        let _e1781 = ((_e1772 & 8388607u) | (_e1777 << bitcast<u32>(23i)));
                        let _e1784 = (bitcast<i32>(_e1775) - bitcast<i32>(_e1777));
                        let _e1785 = (125i - _e1784);
                        let _e1786 = (_e1785 < 0i);
                        if _e1786 {
                            phi_2538_ = (_e1784 - 125i);
                        } else {
                            phi_2538_ = 0i;
                        }
                        let _e1789 = phi_2538_;
                        if _e1786 {
                            phi_2548_ = 0i;
                        } else {
                            phi_2548_ = select(_e1785, 31i, (_e1785 > 31i));
                        }
                        let _e1793 = phi_2548_;
                        let _e1798 = (_e1793 & 31i);
                        let _e1808 = (bitcast<i32>(_e1772) >> bitcast<u32>(31i));
                        let _e1818 = bitcast<u32>(-(_e1342.member_1.y));
                        let _e1821 = ((_e1818 >> bitcast<u32>(23i)) & 255u);
                        let _e1823 = select(0u, 1u, (_e1821 != 0u));
                        let _e1827 = ((_e1818 & 8388607u) | (_e1823 << bitcast<u32>(23i)));
                        let _e1830 = (bitcast<i32>(_e1821) - bitcast<i32>(_e1823));
                        let _e1831 = (125i - _e1830);
                        let _e1832 = (_e1831 < 0i);
                        if _e1832 {
                            phi_2597_ = (_e1830 - 125i);
                        } else {
                            phi_2597_ = 0i;
                        }
                        let _e1835 = phi_2597_;
                        if _e1832 {
                            phi_2607_ = 0i;
                        } else {
                            phi_2607_ = select(_e1831, 31i, (_e1831 > 31i));
                        }
                        let _e1839 = phi_2607_;
                        let _e1844 = (_e1839 & 31i);
                        let _e1854 = (bitcast<i32>(_e1818) >> bitcast<u32>(31i));
                        let _e1864 = bitcast<u32>(-(_e1342.member_1.z));
                        let _e1867 = ((_e1864 >> bitcast<u32>(23i)) & 255u);
                        let _e1869 = select(0u, 1u, (_e1867 != 0u));
                        let _e1873 = ((_e1864 & 8388607u) | (_e1869 << bitcast<u32>(23i)));
                        let _e1876 = (bitcast<i32>(_e1867) - bitcast<i32>(_e1869));
                        let _e1877 = (125i - _e1876);
                        let _e1878 = (_e1877 < 0i);
                        if _e1878 {
                            phi_2656_ = (_e1876 - 125i);
                        } else {
                            phi_2656_ = 0i;
                        }
                        let _e1881 = phi_2656_;
                        if _e1878 {
                            phi_2666_ = 0i;
                        } else {
                            phi_2666_ = select(_e1877, 31i, (_e1877 > 31i));
                        }
                        let _e1885 = phi_2666_;
                        let _e1890 = (_e1885 & 31i);
                        let _e1900 = (bitcast<i32>(_e1864) >> bitcast<u32>(31i));
                        local_13 = array<i32, 3>((((bitcast<i32>(((_e1648 << bitcast<u32>((bitcast<u32>(_e1656) & 31u))) >> bitcast<u32>(_e1665))) + select(0i, 1i, (((_e1648 & ((1u << bitcast<u32>(_e1665)) - 1u)) != 0u) && (_e1675 != 0i)))) ^ _e1675) - _e1675), (((bitcast<i32>(((_e1692 << bitcast<u32>((bitcast<u32>(_e1700) & 31u))) >> bitcast<u32>(_e1709))) + select(0i, 1i, (((_e1692 & ((1u << bitcast<u32>(_e1709)) - 1u)) != 0u) && (_e1719 != 0i)))) ^ _e1719) - _e1719), (((bitcast<i32>(((_e1736 << bitcast<u32>((bitcast<u32>(_e1744) & 31u))) >> bitcast<u32>(_e1753))) + select(0i, 1i, (((_e1736 & ((1u << bitcast<u32>(_e1753)) - 1u)) != 0u) && (_e1763 != 0i)))) ^ _e1763) - _e1763));
                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e1781 << bitcast<u32>((bitcast<u32>(_e1789) & 31u))) >> bitcast<u32>(_e1798))) + select(0i, 1i, (((_e1781 & ((1u << bitcast<u32>(_e1798)) - 1u)) != 0u) && (_e1808 != 0i)))) ^ _e1808) - _e1808)), -((((bitcast<i32>(((_e1827 << bitcast<u32>((bitcast<u32>(_e1835) & 31u))) >> bitcast<u32>(_e1844))) + select(0i, 1i, (((_e1827 & ((1u << bitcast<u32>(_e1844)) - 1u)) != 0u) && (_e1854 != 0i)))) ^ _e1854) - _e1854)), -((((bitcast<i32>(((_e1873 << bitcast<u32>((bitcast<u32>(_e1881) & 31u))) >> bitcast<u32>(_e1890))) + select(0i, 1i, (((_e1873 & ((1u << bitcast<u32>(_e1890)) - 1u)) != 0u) && (_e1900 != 0i)))) ^ _e1900) - _e1900)));
                        local_17 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_2710_ = type_4(0u, 3u);
                        loop {
                            let _e1912 = phi_2710_;
                            if (_e1912.member < _e1912.member_1) {
                                phi_2711_ = type_4((_e1912.member + 1u), _e1912.member_1);
                                phi_2734_ = type_4(1u, _e1912.member);
                            } else {
                                phi_2711_ = _e1912;
                                phi_2734_ = type_4(0u, type_4().member_1);
                            }
                            let _e1925 = phi_2711_;
                            let _e1927 = phi_2734_;
                            let _e1931 = (bitcast<i32>(_e1927.member) != 0i);
                            if _e1931 {
                                let _e1932 = (_e1927.member_1 < 3u);
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1934 = local_5[_e1927.member_1];
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1936 = local_4[_e1927.member_1];
                                let _e1938 = bitcast<u32>((_e1936 - _e1934));
                                let _e1943 = select((bitcast<u32>(31i) - firstLeadingBit(_e1938)), 32u, (_e1938 == 0u));
                                if ((32u - _e1943) > 21u) {
                                    phi_2769_ = (11u - _e1943);
                                } else {
                                    phi_2769_ = 0u;
                                }
                                let _e1948 = phi_2769_;
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1950 = local_15[_e1927.member_1];
                                let _e1951 = (_e1950 - _e1934);
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1953 = local_13[_e1927.member_1];
                                let _e1954 = (_e1953 - _e1934);
                                let _e1955 = (_e1951 > _e1954);
                                let _e1958 = (_e1948 & 31u);
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1967 = local_14[_e1927.member_1];
                                let _e1968 = (_e1936 - _e1967);
                                if _e1932 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1970 = local_12[_e1927.member_1];
                                let _e1971 = (_e1936 - _e1970);
                                let _e1972 = (_e1968 > _e1971);
                                let _e1982 = (_e1927.member_1 * 2u);
                                let _e1984 = ((1u + _e1982) % 7u);
                                if (_e1984 < 7u) {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                local_17[_e1984] = (((bitcast<u32>(select(_e1954, _e1951, _e1955)) >> bitcast<u32>(_e1958)) & 2097151u) | (select(0u, 1u, _e1955) << bitcast<u32>(21u)));
                                let _e1988 = ((_e1982 + 2u) % 7u);
                                if (_e1988 < 7u) {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                local_17[_e1988] = (((bitcast<u32>(select(_e1971, _e1968, _e1972)) >> bitcast<u32>(_e1958)) & 2097151u) | (select(0u, 1u, _e1972) << bitcast<u32>(21u)));
                            }
                            continue;
                            continuing {
                                phi_2710_ = _e1925;
                                phi_3709_ = _e1278;
                                break if !(_e1931);
                            }
                        }
                        let _e1993 = phi_3709_;
                        if _e1993 {
                            break;
                        }
                        phi_2908_ = type_4(0u, 3u);
                        loop {
                            let _e1995 = phi_2908_;
                            if (_e1995.member < _e1995.member_1) {
                                phi_2909_ = type_4((_e1995.member + 1u), _e1995.member_1);
                                phi_2932_ = type_4(1u, _e1995.member);
                            } else {
                                phi_2909_ = _e1995;
                                phi_2932_ = type_4(0u, type_4().member_1);
                            }
                            let _e2008 = phi_2909_;
                            let _e2010 = phi_2932_;
                            let _e2014 = (bitcast<i32>(_e2010.member) != 0i);
                            if _e2014 {
                                let _e2015 = (_e2010.member_1 * 2u);
                                if (((1u + _e2015) % 7u) < 7u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if (((_e2015 + 2u) % 7u) < 7u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                let _e2022 = (_e2010.member_1 < 3u);
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2022 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2908_ = _e2008;
                                phi_3761_ = _e1993;
                                break if !(_e2014);
                            }
                        }
                        let _e2025 = phi_3761_;
                        if _e2025 {
                            break;
                        }
                        let _e2026 = local_17;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e2028 = ((_e1284 & 2147483648u) != 0u);
                        if _e2028 {
                            let _e2032 = (((_e1284 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e2032 {
                                phi_3143_ = (_e1284 & 268435455u);
                            } else {
                                phi_3143_ = u32();
                            }
                            let _e2035 = phi_3143_;
                            phi_3145_ = _e2035;
                            phi_3146_ = select(true, false, _e2032);
                        } else {
                            phi_3145_ = u32();
                            phi_3146_ = true;
                        }
                        let _e2038 = phi_3145_;
                        let _e2040 = phi_3146_;
                        if _e2040 {
                            if ((_e1315 & 2147483648u) != 0u) {
                                let _e2046 = (((_e1315 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e2046 {
                                    phi_3162_ = (_e1315 & 268435455u);
                                } else {
                                    phi_3162_ = u32();
                                }
                                let _e2049 = phi_3162_;
                                phi_3164_ = _e2049;
                                phi_3165_ = select(true, false, _e2046);
                            } else {
                                phi_3164_ = u32();
                                phi_3165_ = true;
                            }
                            let _e2052 = phi_3164_;
                            let _e2054 = phi_3165_;
                            phi_3170_ = select(_e2052, 0u, _e2054);
                        } else {
                            phi_3170_ = _e2038;
                        }
                        let _e2057 = phi_3170_;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e2028 {
                            phi_3198_ = select(_e1315, 0u, ((_e1315 & 2147483648u) != 0u));
                        } else {
                            phi_3198_ = _e1284;
                        }
                        let _e2062 = phi_3198_;
                        if _e2028 {
                            let _e2065 = ((_e1284 >> bitcast<u32>(28u)) & 7u);
                            phi_3213_ = select(_e2065, 7u, (_e2065 == 0u));
                        } else {
                            phi_3213_ = 0u;
                        }
                        let _e2069 = phi_3213_;
                        if ((_e1315 & 2147483648u) != 0u) {
                            let _e2074 = ((_e1315 >> bitcast<u32>(28u)) & 7u);
                            phi_3228_ = select(_e2074, 7u, (_e2074 == 0u));
                        } else {
                            phi_3228_ = 0u;
                        }
                        let _e2078 = phi_3228_;
                        local_16 = _e2026;
                        local_16[0u] = (((_e2062 & 268435455u) | (_e2069 << bitcast<u32>(28u))) | (_e2078 << bitcast<u32>(31i)));
                        phi_3330_ = type_4(0u, 3u);
                        loop {
                            let _e2094 = phi_3330_;
                            if (_e2094.member < _e2094.member_1) {
                                phi_3331_ = type_4((_e2094.member + 1u), _e2094.member_1);
                                phi_3354_ = type_4(1u, _e2094.member);
                            } else {
                                phi_3331_ = _e2094;
                                phi_3354_ = type_4(0u, type_4().member_1);
                            }
                            let _e2107 = phi_3331_;
                            let _e2109 = phi_3354_;
                            let _e2113 = (bitcast<i32>(_e2109.member) != 0i);
                            if _e2113 {
                                let _e2122 = (((_e2109.member_1 + 1u) * 2u) % 7u);
                                if (_e2122 < 7u) {
                                } else {
                                    phi_3771_ = true;
                                    break;
                                }
                                let _e2125 = local_16[_e2122];
                                local_16[_e2122] = (_e2125 | ((((_e2057 & 268435455u) | ((_e2078 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e2109.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_3330_ = _e2107;
                                phi_3771_ = _e2025;
                                break if !(_e2113);
                            }
                        }
                        let _e2129 = phi_3771_;
                        if _e2129 {
                            break;
                        }
                        let _e2130 = local_16;
                        if _e81 {
                        } else {
                            break;
                        }
                        global_4.member[_e75] = array<u32, 7>(_e2130[0], _e2130[1], _e2130[2], _e2130[3], _e2130[4], _e2130[5], _e2130[6]);
                        if (_e75 == 0u) {
                            if (_e71 == 0u) {
                            } else {
                                if (0u < _e71) {
                                } else {
                                    break;
                                }
                                global_3.member[0u] = type_24(array<u32, 4>(bitcast<u32>(_e1280[0]), bitcast<u32>(_e1280[1]), bitcast<u32>(_e1280[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e1279[0]), bitcast<u32>(_e1279[1]), bitcast<u32>(_e1279[2]), 0u));
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
