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
    var phi_3604_: bool;
    var phi_1648_: type_4;
    var phi_1649_: type_4;
    var phi_1672_: type_4;
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
            let _e64 = global;
            let _e66 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_3.member));
            let _e74 = (_e64.x + (_e64.y * 2097152u));
            let _e77 = global_1.member[0u];
            if (_e74 < _e77) {
                let _e79 = (_e74 < _e66);
                if _e79 {
                    let _e80 = (_e74 < arrayLength((&global_4.member)));
                    if _e80 {
                        let _e81 = (0u < _e66);
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e84 = global_2.member[0u];
                            phi_171_ = _e84;
                        } else {
                            phi_171_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e86 = phi_171_;
                        if (_e86.member_1 == 2147483648u) {
                            phi_189_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_189_ = type_23(vec3<f32>(_e86.member[0][0], _e86.member[1][0], _e86.member[2][0]), vec3<f32>(_e86.member[0][2], _e86.member[1][2], _e86.member[2][2]));
                        }
                        let _e105 = phi_189_;
                        if (_e86.member_2 == 2147483648u) {
                            phi_207_ = _e105;
                        } else {
                            phi_207_ = type_23(vec3<f32>(_e86.member[0][1], _e86.member[1][1], _e86.member[2][1]), vec3<f32>(_e86.member[0][3], _e86.member[1][3], _e86.member[2][3]));
                        }
                        let _e124 = phi_207_;
                        let _e153 = bitcast<u32>(select(_e124.member.x, _e105.member.x, (_e105.member.x < _e124.member.x)));
                        let _e156 = ((_e153 >> bitcast<u32>(23i)) & 255u);
                        let _e158 = select(0u, 1u, (_e156 != 0u));
                        let _e162 = ((_e153 & 8388607u) | (_e158 << bitcast<u32>(23i)));
                        let _e165 = (bitcast<i32>(_e156) - bitcast<i32>(_e158));
                        let _e166 = (125i - _e165);
                        let _e167 = (_e166 < 0i);
                        if _e167 {
                            phi_273_ = (_e165 - 125i);
                        } else {
                            phi_273_ = 0i;
                        }
                        let _e170 = phi_273_;
                        if _e167 {
                            phi_283_ = 0i;
                        } else {
                            phi_283_ = select(_e166, 31i, (_e166 > 31i));
                        }
                        let _e174 = phi_283_;
                        let _e179 = (_e174 & 31i);
                        let _e189 = (bitcast<i32>(_e153) >> bitcast<u32>(31i));
                        let _e197 = bitcast<u32>(select(_e124.member.y, _e105.member.y, (_e105.member.y < _e124.member.y)));
                        let _e200 = ((_e197 >> bitcast<u32>(23i)) & 255u);
                        let _e202 = select(0u, 1u, (_e200 != 0u));
                        let _e206 = ((_e197 & 8388607u) | (_e202 << bitcast<u32>(23i)));
                        let _e209 = (bitcast<i32>(_e200) - bitcast<i32>(_e202));
                        let _e210 = (125i - _e209);
                        let _e211 = (_e210 < 0i);
                        if _e211 {
                            phi_330_ = (_e209 - 125i);
                        } else {
                            phi_330_ = 0i;
                        }
                        let _e214 = phi_330_;
                        if _e211 {
                            phi_340_ = 0i;
                        } else {
                            phi_340_ = select(_e210, 31i, (_e210 > 31i));
                        }
                        let _e218 = phi_340_;
                        let _e223 = (_e218 & 31i);
                        let _e233 = (bitcast<i32>(_e197) >> bitcast<u32>(31i));
                        let _e241 = bitcast<u32>(select(_e124.member.z, _e105.member.z, (_e105.member.z < _e124.member.z)));
                        let _e244 = ((_e241 >> bitcast<u32>(23i)) & 255u);
                        let _e246 = select(0u, 1u, (_e244 != 0u));
                        let _e250 = ((_e241 & 8388607u) | (_e246 << bitcast<u32>(23i)));
                        let _e253 = (bitcast<i32>(_e244) - bitcast<i32>(_e246));
                        let _e254 = (125i - _e253);
                        let _e255 = (_e254 < 0i);
                        if _e255 {
                            phi_387_ = (_e253 - 125i);
                        } else {
                            phi_387_ = 0i;
                        }
                        let _e258 = phi_387_;
                        if _e255 {
                            phi_397_ = 0i;
                        } else {
                            phi_397_ = select(_e254, 31i, (_e254 > 31i));
                        }
                        let _e262 = phi_397_;
                        let _e267 = (_e262 & 31i);
                        let _e277 = (bitcast<i32>(_e241) >> bitcast<u32>(31i));
                        let _e286 = bitcast<u32>(-(select(_e124.member_1.x, _e105.member_1.x, (_e105.member_1.x > _e124.member_1.x))));
                        let _e289 = ((_e286 >> bitcast<u32>(23i)) & 255u);
                        let _e291 = select(0u, 1u, (_e289 != 0u));
                        let _e295 = ((_e286 & 8388607u) | (_e291 << bitcast<u32>(23i)));
                        let _e298 = (bitcast<i32>(_e289) - bitcast<i32>(_e291));
                        let _e299 = (125i - _e298);
                        let _e300 = (_e299 < 0i);
                        if _e300 {
                            phi_446_ = (_e298 - 125i);
                        } else {
                            phi_446_ = 0i;
                        }
                        let _e303 = phi_446_;
                        if _e300 {
                            phi_456_ = 0i;
                        } else {
                            phi_456_ = select(_e299, 31i, (_e299 > 31i));
                        }
                        let _e307 = phi_456_;
                        let _e312 = (_e307 & 31i);
                        let _e322 = (bitcast<i32>(_e286) >> bitcast<u32>(31i));
                        let _e332 = bitcast<u32>(-(select(_e124.member_1.y, _e105.member_1.y, (_e105.member_1.y > _e124.member_1.y))));
                        let _e335 = ((_e332 >> bitcast<u32>(23i)) & 255u);
                        let _e337 = select(0u, 1u, (_e335 != 0u));
                        let _e341 = ((_e332 & 8388607u) | (_e337 << bitcast<u32>(23i)));
                        let _e344 = (bitcast<i32>(_e335) - bitcast<i32>(_e337));
                        let _e345 = (125i - _e344);
                        let _e346 = (_e345 < 0i);
                        if _e346 {
                            phi_505_ = (_e344 - 125i);
                        } else {
                            phi_505_ = 0i;
                        }
                        let _e349 = phi_505_;
                        if _e346 {
                            phi_515_ = 0i;
                        } else {
                            phi_515_ = select(_e345, 31i, (_e345 > 31i));
                        }
                        let _e353 = phi_515_;
                        let _e358 = (_e353 & 31i);
                        let _e368 = (bitcast<i32>(_e332) >> bitcast<u32>(31i));
                        let _e378 = bitcast<u32>(-(select(_e124.member_1.z, _e105.member_1.z, (_e105.member_1.z > _e124.member_1.z))));
                        let _e381 = ((_e378 >> bitcast<u32>(23i)) & 255u);
                        let _e383 = select(0u, 1u, (_e381 != 0u));
                        let _e387 = ((_e378 & 8388607u) | (_e383 << bitcast<u32>(23i)));
                        let _e390 = (bitcast<i32>(_e381) - bitcast<i32>(_e383));
                        let _e391 = (125i - _e390);
                        let _e392 = (_e391 < 0i);
                        if _e392 {
                            phi_564_ = (_e390 - 125i);
                        } else {
                            phi_564_ = 0i;
                        }
                        let _e395 = phi_564_;
                        if _e392 {
                            phi_574_ = 0i;
                        } else {
                            phi_574_ = select(_e391, 31i, (_e391 > 31i));
                        }
                        let _e399 = phi_574_;
                        let _e404 = (_e399 & 31i);
                        let _e414 = (bitcast<i32>(_e378) >> bitcast<u32>(31i));
                        local_7 = array<i32, 3>((((bitcast<i32>(((_e162 << bitcast<u32>((bitcast<u32>(_e170) & 31u))) >> bitcast<u32>(_e179))) + select(0i, 1i, (((_e162 & ((1u << bitcast<u32>(_e179)) - 1u)) != 0u) && (_e189 != 0i)))) ^ _e189) - _e189), (((bitcast<i32>(((_e206 << bitcast<u32>((bitcast<u32>(_e214) & 31u))) >> bitcast<u32>(_e223))) + select(0i, 1i, (((_e206 & ((1u << bitcast<u32>(_e223)) - 1u)) != 0u) && (_e233 != 0i)))) ^ _e233) - _e233), (((bitcast<i32>(((_e250 << bitcast<u32>((bitcast<u32>(_e258) & 31u))) >> bitcast<u32>(_e267))) + select(0i, 1i, (((_e250 & ((1u << bitcast<u32>(_e267)) - 1u)) != 0u) && (_e277 != 0i)))) ^ _e277) - _e277));
                        local_6 = array<i32, 3>(-((((bitcast<i32>(((_e295 << bitcast<u32>((bitcast<u32>(_e303) & 31u))) >> bitcast<u32>(_e312))) + select(0i, 1i, (((_e295 & ((1u << bitcast<u32>(_e312)) - 1u)) != 0u) && (_e322 != 0i)))) ^ _e322) - _e322)), -((((bitcast<i32>(((_e341 << bitcast<u32>((bitcast<u32>(_e349) & 31u))) >> bitcast<u32>(_e358))) + select(0i, 1i, (((_e341 & ((1u << bitcast<u32>(_e358)) - 1u)) != 0u) && (_e368 != 0i)))) ^ _e368) - _e368)), -((((bitcast<i32>(((_e387 << bitcast<u32>((bitcast<u32>(_e395) & 31u))) >> bitcast<u32>(_e404))) + select(0i, 1i, (((_e387 & ((1u << bitcast<u32>(_e404)) - 1u)) != 0u) && (_e414 != 0i)))) ^ _e414) - _e414)));
                        phi_3649_ = false;
                        phi_618_ = type_4(0u, 128u);
                        phi_621_ = 0u;
                        loop {
                            let _e426 = phi_3649_;
                            let _e428 = phi_618_;
                            let _e430 = phi_621_;
                            if (_e428.member < _e428.member_1) {
                                phi_619_ = type_4((_e428.member + 1u), _e428.member_1);
                                phi_644_ = type_4(1u, _e428.member);
                            } else {
                                phi_619_ = _e428;
                                phi_644_ = type_4(0u, type_4().member_1);
                            }
                            let _e443 = phi_619_;
                            let _e445 = phi_644_;
                            if (bitcast<i32>(_e445.member) != 0i) {
                                let _e449 = (_e430 == _e74);
                                if _e449 {
                                    phi_3706_ = _e426;
                                    phi_1895_ = u32();
                                } else {
                                    let _e450 = (_e430 < _e66);
                                    if _e450 {
                                        if _e450 {
                                        } else {
                                            phi_3704_ = true;
                                            break;
                                        }
                                        let _e453 = global_2.member[_e430];
                                        phi_666_ = _e453;
                                    } else {
                                        phi_666_ = type_18(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e455 = phi_666_;
                                    if ((_e455.member_1 & 2147483648u) != 0u) {
                                        phi_674_ = false;
                                    } else {
                                        phi_674_ = (_e74 <= _e455.member_1);
                                    }
                                    let _e461 = phi_674_;
                                    if (_e455.member_1 == 2147483648u) {
                                        phi_692_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_692_ = type_23(vec3<f32>(_e455.member[0][0], _e455.member[1][0], _e455.member[2][0]), vec3<f32>(_e455.member[0][2], _e455.member[1][2], _e455.member[2][2]));
                                    }
                                    let _e479 = phi_692_;
                                    if (_e455.member_2 == 2147483648u) {
                                        phi_710_ = _e479;
                                    } else {
                                        phi_710_ = type_23(vec3<f32>(_e455.member[0][1], _e455.member[1][1], _e455.member[2][1]), vec3<f32>(_e455.member[0][3], _e455.member[1][3], _e455.member[2][3]));
                                    }
                                    let _e498 = phi_710_;
                                    let _e511 = bitcast<u32>(_e479.member.x);
                                    let _e514 = ((_e511 >> bitcast<u32>(23i)) & 255u);
                                    let _e516 = select(0u, 1u, (_e514 != 0u));
                                    let _e520 = ((_e511 & 8388607u) | (_e516 << bitcast<u32>(23i)));
                                    let _e523 = (bitcast<i32>(_e514) - bitcast<i32>(_e516));
                                    let _e524 = (125i - _e523);
                                    let _e525 = (_e524 < 0i);
                                    if _e525 {
                                        phi_737_ = (_e523 - 125i);
                                    } else {
                                        phi_737_ = 0i;
                                    }
                                    let _e528 = phi_737_;
                                    if _e525 {
                                        phi_747_ = 0i;
                                    } else {
                                        phi_747_ = select(_e524, 31i, (_e524 > 31i));
                                    }
                                    let _e532 = phi_747_;
                                    let _e537 = (_e532 & 31i);
                                    let _e547 = (bitcast<i32>(_e511) >> bitcast<u32>(31i));
                                    let _e555 = bitcast<u32>(_e479.member.y);
                                    let _e558 = ((_e555 >> bitcast<u32>(23i)) & 255u);
                                    let _e560 = select(0u, 1u, (_e558 != 0u));
                                    let _e564 = ((_e555 & 8388607u) | (_e560 << bitcast<u32>(23i)));
                                    let _e567 = (bitcast<i32>(_e558) - bitcast<i32>(_e560));
                                    let _e568 = (125i - _e567);
                                    let _e569 = (_e568 < 0i);
                                    if _e569 {
                                        phi_794_ = (_e567 - 125i);
                                    } else {
                                        phi_794_ = 0i;
                                    }
                                    let _e572 = phi_794_;
                                    if _e569 {
                                        phi_804_ = 0i;
                                    } else {
                                        phi_804_ = select(_e568, 31i, (_e568 > 31i));
                                    }
                                    let _e576 = phi_804_;
                                    let _e581 = (_e576 & 31i);
                                    let _e591 = (bitcast<i32>(_e555) >> bitcast<u32>(31i));
                                    let _e599 = bitcast<u32>(_e479.member.z);
                                    let _e602 = ((_e599 >> bitcast<u32>(23i)) & 255u);
                                    let _e604 = select(0u, 1u, (_e602 != 0u));
                                    let _e608 = ((_e599 & 8388607u) | (_e604 << bitcast<u32>(23i)));
                                    let _e611 = (bitcast<i32>(_e602) - bitcast<i32>(_e604));
                                    let _e612 = (125i - _e611);
                                    let _e613 = (_e612 < 0i);
                                    if _e613 {
                                        phi_851_ = (_e611 - 125i);
                                    } else {
                                        phi_851_ = 0i;
                                    }
                                    let _e616 = phi_851_;
                                    if _e613 {
                                        phi_861_ = 0i;
                                    } else {
                                        phi_861_ = select(_e612, 31i, (_e612 > 31i));
                                    }
                                    let _e620 = phi_861_;
                                    let _e625 = (_e620 & 31i);
                                    let _e635 = (bitcast<i32>(_e599) >> bitcast<u32>(31i));
                                    let _e644 = bitcast<u32>(-(_e479.member_1.x));
                                    let _e647 = ((_e644 >> bitcast<u32>(23i)) & 255u);
                                    let _e649 = select(0u, 1u, (_e647 != 0u));
                                    let _e653 = ((_e644 & 8388607u) | (_e649 << bitcast<u32>(23i)));
                                    let _e656 = (bitcast<i32>(_e647) - bitcast<i32>(_e649));
                                    let _e657 = (125i - _e656);
                                    let _e658 = (_e657 < 0i);
                                    if _e658 {
                                        phi_910_ = (_e656 - 125i);
                                    } else {
                                        phi_910_ = 0i;
                                    }
                                    let _e661 = phi_910_;
                                    if _e658 {
                                        phi_920_ = 0i;
                                    } else {
                                        phi_920_ = select(_e657, 31i, (_e657 > 31i));
                                    }
                                    let _e665 = phi_920_;
                                    let _e670 = (_e665 & 31i);
                                    let _e680 = (bitcast<i32>(_e644) >> bitcast<u32>(31i));
                                    let _e690 = bitcast<u32>(-(_e479.member_1.y));
                                    let _e693 = ((_e690 >> bitcast<u32>(23i)) & 255u);
                                    let _e695 = select(0u, 1u, (_e693 != 0u));
                                    let _e699 = ((_e690 & 8388607u) | (_e695 << bitcast<u32>(23i)));
                                    let _e702 = (bitcast<i32>(_e693) - bitcast<i32>(_e695));
                                    let _e703 = (125i - _e702);
                                    let _e704 = (_e703 < 0i);
                                    if _e704 {
                                        phi_969_ = (_e702 - 125i);
                                    } else {
                                        phi_969_ = 0i;
                                    }
                                    let _e707 = phi_969_;
                                    if _e704 {
                                        phi_979_ = 0i;
                                    } else {
                                        phi_979_ = select(_e703, 31i, (_e703 > 31i));
                                    }
                                    let _e711 = phi_979_;
                                    let _e716 = (_e711 & 31i);
                                    let _e726 = (bitcast<i32>(_e690) >> bitcast<u32>(31i));
                                    let _e736 = bitcast<u32>(-(_e479.member_1.z));
                                    let _e739 = ((_e736 >> bitcast<u32>(23i)) & 255u);
                                    let _e741 = select(0u, 1u, (_e739 != 0u));
                                    let _e745 = ((_e736 & 8388607u) | (_e741 << bitcast<u32>(23i)));
                                    let _e748 = (bitcast<i32>(_e739) - bitcast<i32>(_e741));
                                    let _e749 = (125i - _e748);
                                    let _e750 = (_e749 < 0i);
                                    if _e750 {
                                        phi_1028_ = (_e748 - 125i);
                                    } else {
                                        phi_1028_ = 0i;
                                    }
                                    let _e753 = phi_1028_;
                                    if _e750 {
                                        phi_1038_ = 0i;
                                    } else {
                                        phi_1038_ = select(_e749, 31i, (_e749 > 31i));
                                    }
                                    let _e757 = phi_1038_;
                                    let _e762 = (_e757 & 31i);
                                    let _e772 = (bitcast<i32>(_e736) >> bitcast<u32>(31i));
                                    local_11 = array<i32, 3>((((bitcast<i32>(((_e520 << bitcast<u32>((bitcast<u32>(_e528) & 31u))) >> bitcast<u32>(_e537))) + select(0i, 1i, (((_e520 & ((1u << bitcast<u32>(_e537)) - 1u)) != 0u) && (_e547 != 0i)))) ^ _e547) - _e547), (((bitcast<i32>(((_e564 << bitcast<u32>((bitcast<u32>(_e572) & 31u))) >> bitcast<u32>(_e581))) + select(0i, 1i, (((_e564 & ((1u << bitcast<u32>(_e581)) - 1u)) != 0u) && (_e591 != 0i)))) ^ _e591) - _e591), (((bitcast<i32>(((_e608 << bitcast<u32>((bitcast<u32>(_e616) & 31u))) >> bitcast<u32>(_e625))) + select(0i, 1i, (((_e608 & ((1u << bitcast<u32>(_e625)) - 1u)) != 0u) && (_e635 != 0i)))) ^ _e635) - _e635));
                                    local_10 = array<i32, 3>(-((((bitcast<i32>(((_e653 << bitcast<u32>((bitcast<u32>(_e661) & 31u))) >> bitcast<u32>(_e670))) + select(0i, 1i, (((_e653 & ((1u << bitcast<u32>(_e670)) - 1u)) != 0u) && (_e680 != 0i)))) ^ _e680) - _e680)), -((((bitcast<i32>(((_e699 << bitcast<u32>((bitcast<u32>(_e707) & 31u))) >> bitcast<u32>(_e716))) + select(0i, 1i, (((_e699 & ((1u << bitcast<u32>(_e716)) - 1u)) != 0u) && (_e726 != 0i)))) ^ _e726) - _e726)), -((((bitcast<i32>(((_e745 << bitcast<u32>((bitcast<u32>(_e753) & 31u))) >> bitcast<u32>(_e762))) + select(0i, 1i, (((_e745 & ((1u << bitcast<u32>(_e762)) - 1u)) != 0u) && (_e772 != 0i)))) ^ _e772) - _e772)));
                                    let _e795 = bitcast<u32>(_e498.member.x);
                                    let _e798 = ((_e795 >> bitcast<u32>(23i)) & 255u);
                                    let _e800 = select(0u, 1u, (_e798 != 0u));
                                    let _e804 = ((_e795 & 8388607u) | (_e800 << bitcast<u32>(23i)));
                                    let _e807 = (bitcast<i32>(_e798) - bitcast<i32>(_e800));
                                    let _e808 = (125i - _e807);
                                    let _e809 = (_e808 < 0i);
                                    if _e809 {
                                        phi_1105_ = (_e807 - 125i);
                                    } else {
                                        phi_1105_ = 0i;
                                    }
                                    let _e812 = phi_1105_;
                                    if _e809 {
                                        phi_1115_ = 0i;
                                    } else {
                                        phi_1115_ = select(_e808, 31i, (_e808 > 31i));
                                    }
                                    let _e816 = phi_1115_;
                                    let _e821 = (_e816 & 31i);
                                    let _e831 = (bitcast<i32>(_e795) >> bitcast<u32>(31i));
                                    let _e839 = bitcast<u32>(_e498.member.y);
                                    let _e842 = ((_e839 >> bitcast<u32>(23i)) & 255u);
                                    let _e844 = select(0u, 1u, (_e842 != 0u));
                                    let _e848 = ((_e839 & 8388607u) | (_e844 << bitcast<u32>(23i)));
                                    let _e851 = (bitcast<i32>(_e842) - bitcast<i32>(_e844));
                                    let _e852 = (125i - _e851);
                                    let _e853 = (_e852 < 0i);
                                    if _e853 {
                                        phi_1162_ = (_e851 - 125i);
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
                                    let _e875 = (bitcast<i32>(_e839) >> bitcast<u32>(31i));
                                    let _e883 = bitcast<u32>(_e498.member.z);
                                    let _e886 = ((_e883 >> bitcast<u32>(23i)) & 255u);
                                    let _e888 = select(0u, 1u, (_e886 != 0u));
                                    let _e892 = ((_e883 & 8388607u) | (_e888 << bitcast<u32>(23i)));
                                    let _e895 = (bitcast<i32>(_e886) - bitcast<i32>(_e888));
                                    let _e896 = (125i - _e895);
                                    let _e897 = (_e896 < 0i);
                                    if _e897 {
                                        phi_1219_ = (_e895 - 125i);
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
                                    let _e919 = (bitcast<i32>(_e883) >> bitcast<u32>(31i));
                                    let _e928 = bitcast<u32>(-(_e498.member_1.x));
                                    let _e931 = ((_e928 >> bitcast<u32>(23i)) & 255u);
                                    let _e933 = select(0u, 1u, (_e931 != 0u));
                                    let _e937 = ((_e928 & 8388607u) | (_e933 << bitcast<u32>(23i)));
                                    let _e940 = (bitcast<i32>(_e931) - bitcast<i32>(_e933));
                                    let _e941 = (125i - _e940);
                                    let _e942 = (_e941 < 0i);
                                    if _e942 {
                                        phi_1278_ = (_e940 - 125i);
                                    } else {
                                        phi_1278_ = 0i;
                                    }
                                    let _e945 = phi_1278_;
                                    if _e942 {
                                        phi_1288_ = 0i;
                                    } else {
                                        phi_1288_ = select(_e941, 31i, (_e941 > 31i));
                                    }
                                    let _e949 = phi_1288_;
                                    let _e954 = (_e949 & 31i);
                                    let _e964 = (bitcast<i32>(_e928) >> bitcast<u32>(31i));
                                    let _e974 = bitcast<u32>(-(_e498.member_1.y));
                                    let _e977 = ((_e974 >> bitcast<u32>(23i)) & 255u);
                                    let _e979 = select(0u, 1u, (_e977 != 0u));
                                    let _e983 = ((_e974 & 8388607u) | (_e979 << bitcast<u32>(23i)));
                                    let _e986 = (bitcast<i32>(_e977) - bitcast<i32>(_e979));
                                    let _e987 = (125i - _e986);
                                    let _e988 = (_e987 < 0i);
                                    if _e988 {
                                        phi_1337_ = (_e986 - 125i);
                                    } else {
                                        phi_1337_ = 0i;
                                    }
                                    let _e991 = phi_1337_;
                                    if _e988 {
                                        phi_1347_ = 0i;
                                    } else {
                                        phi_1347_ = select(_e987, 31i, (_e987 > 31i));
                                    }
                                    let _e995 = phi_1347_;
                                    let _e1000 = (_e995 & 31i);
                                    let _e1010 = (bitcast<i32>(_e974) >> bitcast<u32>(31i));
                                    let _e1020 = bitcast<u32>(-(_e498.member_1.z));
                                    let _e1023 = ((_e1020 >> bitcast<u32>(23i)) & 255u);
                                    let _e1025 = select(0u, 1u, (_e1023 != 0u));
                                    let _e1029 = ((_e1020 & 8388607u) | (_e1025 << bitcast<u32>(23i)));
                                    let _e1032 = (bitcast<i32>(_e1023) - bitcast<i32>(_e1025));
                                    let _e1033 = (125i - _e1032);
                                    let _e1034 = (_e1033 < 0i);
                                    if _e1034 {
                                        phi_1396_ = (_e1032 - 125i);
                                    } else {
                                        phi_1396_ = 0i;
                                    }
                                    let _e1037 = phi_1396_;
                                    if _e1034 {
                                        phi_1406_ = 0i;
                                    } else {
                                        phi_1406_ = select(_e1033, 31i, (_e1033 > 31i));
                                    }
                                    let _e1041 = phi_1406_;
                                    let _e1046 = (_e1041 & 31i);
                                    let _e1056 = (bitcast<i32>(_e1020) >> bitcast<u32>(31i));
                                    local_9 = array<i32, 3>((((bitcast<i32>(((_e804 << bitcast<u32>((bitcast<u32>(_e812) & 31u))) >> bitcast<u32>(_e821))) + select(0i, 1i, (((_e804 & ((1u << bitcast<u32>(_e821)) - 1u)) != 0u) && (_e831 != 0i)))) ^ _e831) - _e831), (((bitcast<i32>(((_e848 << bitcast<u32>((bitcast<u32>(_e856) & 31u))) >> bitcast<u32>(_e865))) + select(0i, 1i, (((_e848 & ((1u << bitcast<u32>(_e865)) - 1u)) != 0u) && (_e875 != 0i)))) ^ _e875) - _e875), (((bitcast<i32>(((_e892 << bitcast<u32>((bitcast<u32>(_e900) & 31u))) >> bitcast<u32>(_e909))) + select(0i, 1i, (((_e892 & ((1u << bitcast<u32>(_e909)) - 1u)) != 0u) && (_e919 != 0i)))) ^ _e919) - _e919));
                                    local_8 = array<i32, 3>(-((((bitcast<i32>(((_e937 << bitcast<u32>((bitcast<u32>(_e945) & 31u))) >> bitcast<u32>(_e954))) + select(0i, 1i, (((_e937 & ((1u << bitcast<u32>(_e954)) - 1u)) != 0u) && (_e964 != 0i)))) ^ _e964) - _e964)), -((((bitcast<i32>(((_e983 << bitcast<u32>((bitcast<u32>(_e991) & 31u))) >> bitcast<u32>(_e1000))) + select(0i, 1i, (((_e983 & ((1u << bitcast<u32>(_e1000)) - 1u)) != 0u) && (_e1010 != 0i)))) ^ _e1010) - _e1010)), -((((bitcast<i32>(((_e1029 << bitcast<u32>((bitcast<u32>(_e1037) & 31u))) >> bitcast<u32>(_e1046))) + select(0i, 1i, (((_e1029 & ((1u << bitcast<u32>(_e1046)) - 1u)) != 0u) && (_e1056 != 0i)))) ^ _e1056) - _e1056)));
                                    local_18 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                    phi_1450_ = type_4(0u, 3u);
                                    loop {
                                        let _e1068 = phi_1450_;
                                        if (_e1068.member < _e1068.member_1) {
                                            phi_1451_ = type_4((_e1068.member + 1u), _e1068.member_1);
                                            phi_1474_ = type_4(1u, _e1068.member);
                                        } else {
                                            phi_1451_ = _e1068;
                                            phi_1474_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1081 = phi_1451_;
                                        let _e1083 = phi_1474_;
                                        let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                        if _e1087 {
                                            let _e1088 = (_e1083.member_1 < 3u);
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1090 = local_7[_e1083.member_1];
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1092 = local_6[_e1083.member_1];
                                            let _e1094 = bitcast<u32>((_e1092 - _e1090));
                                            let _e1100 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1094)), 32u, (_e1094 == 0u)));
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1105 = local_11[_e1083.member_1];
                                            let _e1106 = (_e1105 - _e1090);
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1108 = local_9[_e1083.member_1];
                                            let _e1109 = (_e1108 - _e1090);
                                            let _e1110 = (_e1106 > _e1109);
                                            let _e1113 = ((select(21u, _e1100, (_e1100 > 21u)) - 21u) & 31u);
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1122 = local_10[_e1083.member_1];
                                            let _e1123 = (_e1092 - _e1122);
                                            if _e1088 {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            let _e1125 = local_8[_e1083.member_1];
                                            let _e1126 = (_e1092 - _e1125);
                                            let _e1127 = (_e1123 > _e1126);
                                            let _e1137 = (_e1083.member_1 * 2u);
                                            let _e1139 = ((1u + _e1137) % 7u);
                                            if (_e1139 < 7u) {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            local_18[_e1139] = (((bitcast<u32>(select(_e1109, _e1106, _e1110)) >> bitcast<u32>(_e1113)) & 2097151u) | (select(0u, 1u, _e1110) << bitcast<u32>(21u)));
                                            let _e1143 = ((_e1137 + 2u) % 7u);
                                            if (_e1143 < 7u) {
                                            } else {
                                                phi_3604_ = true;
                                                break;
                                            }
                                            local_18[_e1143] = (((bitcast<u32>(select(_e1126, _e1123, _e1127)) >> bitcast<u32>(_e1113)) & 2097151u) | (select(0u, 1u, _e1127) << bitcast<u32>(21u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_1450_ = _e1081;
                                            phi_3604_ = _e426;
                                            break if !(_e1087);
                                        }
                                    }
                                    let _e1148 = phi_3604_;
                                    phi_3704_ = _e1148;
                                    if _e1148 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_1648_ = type_4(0u, 3u);
                                    loop {
                                        let _e1150 = phi_1648_;
                                        if (_e1150.member < _e1150.member_1) {
                                            phi_1649_ = type_4((_e1150.member + 1u), _e1150.member_1);
                                            phi_1672_ = type_4(1u, _e1150.member);
                                        } else {
                                            phi_1649_ = _e1150;
                                            phi_1672_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1163 = phi_1649_;
                                        let _e1165 = phi_1672_;
                                        let _e1169 = (bitcast<i32>(_e1165.member) != 0i);
                                        if _e1169 {
                                            let _e1170 = (_e1165.member_1 * 2u);
                                            let _e1172 = ((1u + _e1170) % 7u);
                                            if (_e1172 < 7u) {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1175 = local_18[_e1172];
                                            let _e1177 = ((_e1170 + 2u) % 7u);
                                            if (_e1177 < 7u) {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1180 = local_18[_e1177];
                                            let _e1181 = (_e1165.member_1 < 3u);
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1183 = local_7[_e1165.member_1];
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            let _e1185 = local_6[_e1165.member_1];
                                            let _e1187 = bitcast<u32>((_e1185 - _e1183));
                                            let _e1193 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1187)), 32u, (_e1187 == 0u)));
                                            let _e1198 = ((select(21u, _e1193, (_e1193 > 21u)) - 21u) & 31u);
                                            let _e1202 = (_e1183 + bitcast<i32>(((_e1175 & 2097151u) << bitcast<u32>(_e1198))));
                                            let _e1207 = (_e1185 - bitcast<i32>(((_e1180 & 2097151u) << bitcast<u32>(_e1198))));
                                            let _e1211 = (((_e1175 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            let _e1215 = (((_e1180 >> bitcast<u32>(21u)) & 1u) == 1u);
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_3[_e1165.member_1] = select(_e1183, _e1202, _e1211);
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_1[_e1165.member_1] = select(_e1202, _e1183, _e1211);
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local_2[_e1165.member_1] = select(_e1185, _e1207, _e1215);
                                            if _e1181 {
                                            } else {
                                                phi_3687_ = true;
                                                break;
                                            }
                                            local[_e1165.member_1] = select(_e1207, _e1185, _e1215);
                                        }
                                        continue;
                                        continuing {
                                            phi_1648_ = _e1163;
                                            phi_3687_ = _e1148;
                                            break if !(_e1169);
                                        }
                                    }
                                    let _e1226 = phi_3687_;
                                    phi_3704_ = _e1226;
                                    if _e1226 {
                                        break;
                                    }
                                    let _e1227 = local;
                                    let _e1228 = local_1;
                                    let _e1229 = local_2;
                                    let _e1230 = local_3;
                                    if _e461 {
                                        phi_1877_ = type_29(array<i32, 3>(_e1230[0], _e1230[1], _e1230[2]), array<i32, 3>(_e1229[0], _e1229[1], _e1229[2]));
                                    } else {
                                        phi_1877_ = type_29(array<i32, 3>(_e1228[0], _e1228[1], _e1228[2]), array<i32, 3>(_e1227[0], _e1227[1], _e1227[2]));
                                    }
                                    let _e1250 = phi_1877_;
                                    local_7 = array<i32, 3>(_e1250.member[0], _e1250.member[1], _e1250.member[2]);
                                    local_6 = array<i32, 3>(_e1250.member_1[0], _e1250.member_1[1], _e1250.member_1[2]);
                                    phi_3706_ = _e1226;
                                    phi_1895_ = select(_e455.member_2, _e455.member_1, _e461);
                                }
                                let _e1263 = phi_3706_;
                                let _e1265 = phi_1895_;
                                phi_3705_ = _e1263;
                                phi_622_ = _e1265;
                                phi_1897_ = select(true, false, _e449);
                            } else {
                                phi_3705_ = _e426;
                                phi_622_ = u32();
                                phi_1897_ = false;
                            }
                            let _e1268 = phi_3705_;
                            let _e1270 = phi_622_;
                            let _e1272 = phi_1897_;
                            continue;
                            continuing {
                                phi_3649_ = _e1268;
                                phi_618_ = _e443;
                                phi_621_ = _e1270;
                                phi_3704_ = _e1268;
                                break if !(_e1272);
                            }
                        }
                        let _e1275 = phi_3704_;
                        if _e1275 {
                            break;
                        }
                        let _e1276 = local_6;
                        let _e1277 = local_7;
                        local_5 = _e1277;
                        local_4 = _e1276;
                        if _e79 {
                        } else {
                            break;
                        }
                        let _e1281 = global_2.member[_e74].member_1;
                        if (_e1281 == 2147483648u) {
                            phi_1948_ = type_23(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1287 = global_2.member[_e74].member[0u];
                            let _e1292 = global_2.member[_e74].member[1u];
                            let _e1297 = global_2.member[_e74].member[2u];
                            phi_1948_ = type_23(vec3<f32>(_e1287[0], _e1292[0], _e1297[0]), vec3<f32>(_e1287[2], _e1292[2], _e1297[2]));
                        }
                        let _e1308 = phi_1948_;
                        let _e1312 = global_2.member[_e74].member_2;
                        if (_e1312 == 2147483648u) {
                            phi_1970_ = _e1308;
                        } else {
                            let _e1318 = global_2.member[_e74].member[0u];
                            let _e1323 = global_2.member[_e74].member[1u];
                            let _e1328 = global_2.member[_e74].member[2u];
                            phi_1970_ = type_23(vec3<f32>(_e1318[1], _e1323[1], _e1328[1]), vec3<f32>(_e1318[3], _e1323[3], _e1328[3]));
                        }
                        let _e1339 = phi_1970_;
                        let _e1352 = bitcast<u32>(_e1308.member.x);
                        let _e1355 = ((_e1352 >> bitcast<u32>(23i)) & 255u);
                        let _e1357 = select(0u, 1u, (_e1355 != 0u));
                        let _e1361 = ((_e1352 & 8388607u) | (_e1357 << bitcast<u32>(23i)));
                        let _e1364 = (bitcast<i32>(_e1355) - bitcast<i32>(_e1357));
                        let _e1365 = (125i - _e1364);
                        let _e1366 = (_e1365 < 0i);
                        if _e1366 {
                            phi_1997_ = (_e1364 - 125i);
                        } else {
                            phi_1997_ = 0i;
                        }
                        let _e1369 = phi_1997_;
                        if _e1366 {
                            phi_2007_ = 0i;
                        } else {
                            phi_2007_ = select(_e1365, 31i, (_e1365 > 31i));
                        }
                        let _e1373 = phi_2007_;
                        let _e1378 = (_e1373 & 31i);
                        let _e1388 = (bitcast<i32>(_e1352) >> bitcast<u32>(31i));
                        let _e1396 = bitcast<u32>(_e1308.member.y);
                        let _e1399 = ((_e1396 >> bitcast<u32>(23i)) & 255u);
                        let _e1401 = select(0u, 1u, (_e1399 != 0u));
                        let _e1405 = ((_e1396 & 8388607u) | (_e1401 << bitcast<u32>(23i)));
                        let _e1408 = (bitcast<i32>(_e1399) - bitcast<i32>(_e1401));
                        let _e1409 = (125i - _e1408);
                        let _e1410 = (_e1409 < 0i);
                        if _e1410 {
                            phi_2054_ = (_e1408 - 125i);
                        } else {
                            phi_2054_ = 0i;
                        }
                        let _e1413 = phi_2054_;
                        if _e1410 {
                            phi_2064_ = 0i;
                        } else {
                            phi_2064_ = select(_e1409, 31i, (_e1409 > 31i));
                        }
                        let _e1417 = phi_2064_;
                        let _e1422 = (_e1417 & 31i);
                        let _e1432 = (bitcast<i32>(_e1396) >> bitcast<u32>(31i));
                        let _e1440 = bitcast<u32>(_e1308.member.z);
                        let _e1443 = ((_e1440 >> bitcast<u32>(23i)) & 255u);
                        let _e1445 = select(0u, 1u, (_e1443 != 0u));
                        let _e1449 = ((_e1440 & 8388607u) | (_e1445 << bitcast<u32>(23i)));
                        let _e1452 = (bitcast<i32>(_e1443) - bitcast<i32>(_e1445));
                        let _e1453 = (125i - _e1452);
                        let _e1454 = (_e1453 < 0i);
                        if _e1454 {
                            phi_2111_ = (_e1452 - 125i);
                        } else {
                            phi_2111_ = 0i;
                        }
                        let _e1457 = phi_2111_;
                        if _e1454 {
                            phi_2121_ = 0i;
                        } else {
                            phi_2121_ = select(_e1453, 31i, (_e1453 > 31i));
                        }
                        let _e1461 = phi_2121_;
                        let _e1466 = (_e1461 & 31i);
                        let _e1476 = (bitcast<i32>(_e1440) >> bitcast<u32>(31i));
                        let _e1485 = bitcast<u32>(-(_e1308.member_1.x));
                        let _e1488 = ((_e1485 >> bitcast<u32>(23i)) & 255u);
                        let _e1490 = select(0u, 1u, (_e1488 != 0u));
                        let _e1494 = ((_e1485 & 8388607u) | (_e1490 << bitcast<u32>(23i)));
                        let _e1497 = (bitcast<i32>(_e1488) - bitcast<i32>(_e1490));
                        let _e1498 = (125i - _e1497);
                        let _e1499 = (_e1498 < 0i);
                        if _e1499 {
                            phi_2170_ = (_e1497 - 125i);
                        } else {
                            phi_2170_ = 0i;
                        }
                        let _e1502 = phi_2170_;
                        if _e1499 {
                            phi_2180_ = 0i;
                        } else {
                            phi_2180_ = select(_e1498, 31i, (_e1498 > 31i));
                        }
                        let _e1506 = phi_2180_;
                        let _e1511 = (_e1506 & 31i);
                        let _e1521 = (bitcast<i32>(_e1485) >> bitcast<u32>(31i));
                        let _e1531 = bitcast<u32>(-(_e1308.member_1.y));
                        let _e1534 = ((_e1531 >> bitcast<u32>(23i)) & 255u);
                        let _e1536 = select(0u, 1u, (_e1534 != 0u));
                        let _e1540 = ((_e1531 & 8388607u) | (_e1536 << bitcast<u32>(23i)));
                        let _e1543 = (bitcast<i32>(_e1534) - bitcast<i32>(_e1536));
                        let _e1544 = (125i - _e1543);
                        let _e1545 = (_e1544 < 0i);
                        if _e1545 {
                            phi_2229_ = (_e1543 - 125i);
                        } else {
                            phi_2229_ = 0i;
                        }
                        let _e1548 = phi_2229_;
                        if _e1545 {
                            phi_2239_ = 0i;
                        } else {
                            phi_2239_ = select(_e1544, 31i, (_e1544 > 31i));
                        }
                        let _e1552 = phi_2239_;
                        let _e1557 = (_e1552 & 31i);
                        let _e1567 = (bitcast<i32>(_e1531) >> bitcast<u32>(31i));
                        let _e1577 = bitcast<u32>(-(_e1308.member_1.z));
                        let _e1580 = ((_e1577 >> bitcast<u32>(23i)) & 255u);
                        let _e1582 = select(0u, 1u, (_e1580 != 0u));
                        let _e1586 = ((_e1577 & 8388607u) | (_e1582 << bitcast<u32>(23i)));
                        let _e1589 = (bitcast<i32>(_e1580) - bitcast<i32>(_e1582));
                        let _e1590 = (125i - _e1589);
                        let _e1591 = (_e1590 < 0i);
                        if _e1591 {
                            phi_2288_ = (_e1589 - 125i);
                        } else {
                            phi_2288_ = 0i;
                        }
                        let _e1594 = phi_2288_;
                        if _e1591 {
                            phi_2298_ = 0i;
                        } else {
                            phi_2298_ = select(_e1590, 31i, (_e1590 > 31i));
                        }
                        let _e1598 = phi_2298_;
                        let _e1603 = (_e1598 & 31i);
                        let _e1613 = (bitcast<i32>(_e1577) >> bitcast<u32>(31i));
                        local_15 = array<i32, 3>((((bitcast<i32>(((_e1361 << bitcast<u32>((bitcast<u32>(_e1369) & 31u))) >> bitcast<u32>(_e1378))) + select(0i, 1i, (((_e1361 & ((1u << bitcast<u32>(_e1378)) - 1u)) != 0u) && (_e1388 != 0i)))) ^ _e1388) - _e1388), (((bitcast<i32>(((_e1405 << bitcast<u32>((bitcast<u32>(_e1413) & 31u))) >> bitcast<u32>(_e1422))) + select(0i, 1i, (((_e1405 & ((1u << bitcast<u32>(_e1422)) - 1u)) != 0u) && (_e1432 != 0i)))) ^ _e1432) - _e1432), (((bitcast<i32>(((_e1449 << bitcast<u32>((bitcast<u32>(_e1457) & 31u))) >> bitcast<u32>(_e1466))) + select(0i, 1i, (((_e1449 & ((1u << bitcast<u32>(_e1466)) - 1u)) != 0u) && (_e1476 != 0i)))) ^ _e1476) - _e1476));
                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e1494 << bitcast<u32>((bitcast<u32>(_e1502) & 31u))) >> bitcast<u32>(_e1511))) + select(0i, 1i, (((_e1494 & ((1u << bitcast<u32>(_e1511)) - 1u)) != 0u) && (_e1521 != 0i)))) ^ _e1521) - _e1521)), -((((bitcast<i32>(((_e1540 << bitcast<u32>((bitcast<u32>(_e1548) & 31u))) >> bitcast<u32>(_e1557))) + select(0i, 1i, (((_e1540 & ((1u << bitcast<u32>(_e1557)) - 1u)) != 0u) && (_e1567 != 0i)))) ^ _e1567) - _e1567)), -((((bitcast<i32>(((_e1586 << bitcast<u32>((bitcast<u32>(_e1594) & 31u))) >> bitcast<u32>(_e1603))) + select(0i, 1i, (((_e1586 & ((1u << bitcast<u32>(_e1603)) - 1u)) != 0u) && (_e1613 != 0i)))) ^ _e1613) - _e1613)));
                        let _e1636 = bitcast<u32>(_e1339.member.x);
                        let _e1639 = ((_e1636 >> bitcast<u32>(23i)) & 255u);
                        let _e1641 = select(0u, 1u, (_e1639 != 0u));
                        let _e1645 = ((_e1636 & 8388607u) | (_e1641 << bitcast<u32>(23i)));
                        let _e1648 = (bitcast<i32>(_e1639) - bitcast<i32>(_e1641));
                        let _e1649 = (125i - _e1648);
                        let _e1650 = (_e1649 < 0i);
                        if _e1650 {
                            phi_2365_ = (_e1648 - 125i);
                        } else {
                            phi_2365_ = 0i;
                        }
                        let _e1653 = phi_2365_;
                        if _e1650 {
                            phi_2375_ = 0i;
                        } else {
                            phi_2375_ = select(_e1649, 31i, (_e1649 > 31i));
                        }
                        let _e1657 = phi_2375_;
                        let _e1662 = (_e1657 & 31i);
                        let _e1672 = (bitcast<i32>(_e1636) >> bitcast<u32>(31i));
                        let _e1680 = bitcast<u32>(_e1339.member.y);
                        let _e1683 = ((_e1680 >> bitcast<u32>(23i)) & 255u);
                        let _e1685 = select(0u, 1u, (_e1683 != 0u));
                        let _e1689 = ((_e1680 & 8388607u) | (_e1685 << bitcast<u32>(23i)));
                        let _e1692 = (bitcast<i32>(_e1683) - bitcast<i32>(_e1685));
                        let _e1693 = (125i - _e1692);
                        let _e1694 = (_e1693 < 0i);
                        if _e1694 {
                            phi_2422_ = (_e1692 - 125i);
                        } else {
                            phi_2422_ = 0i;
                        }
                        let _e1697 = phi_2422_;
                        if _e1694 {
                            phi_2432_ = 0i;
                        } else {
                            phi_2432_ = select(_e1693, 31i, (_e1693 > 31i));
                        }
                        let _e1701 = phi_2432_;
                        let _e1706 = (_e1701 & 31i);
                        let _e1716 = (bitcast<i32>(_e1680) >> bitcast<u32>(31i));
                        let _e1724 = bitcast<u32>(_e1339.member.z);
                        let _e1727 = ((_e1724 >> bitcast<u32>(23i)) & 255u);
                        let _e1729 = select(0u, 1u, (_e1727 != 0u));
                        let _e1733 = ((_e1724 & 8388607u) | (_e1729 << bitcast<u32>(23i)));
                        let _e1736 = (bitcast<i32>(_e1727) - bitcast<i32>(_e1729));
                        let _e1737 = (125i - _e1736);
                        let _e1738 = (_e1737 < 0i);
                        if _e1738 {
                            phi_2479_ = (_e1736 - 125i);
                        } else {
                            phi_2479_ = 0i;
                        }
                        let _e1741 = phi_2479_;
                        if _e1738 {
                            phi_2489_ = 0i;
                        } else {
                            phi_2489_ = select(_e1737, 31i, (_e1737 > 31i));
                        }
                        let _e1745 = phi_2489_;
                        let _e1750 = (_e1745 & 31i);
                        let _e1760 = (bitcast<i32>(_e1724) >> bitcast<u32>(31i));
                        let _e1769 = bitcast<u32>(-(_e1339.member_1.x));
                        let _e1772 = ((_e1769 >> bitcast<u32>(23i)) & 255u);
                        let _e1774 = select(0u, 1u, (_e1772 != 0u));
                        let _e1778 = ((_e1769 & 8388607u) | (_e1774 << bitcast<u32>(23i)));
                        let _e1781 = (bitcast<i32>(_e1772) - bitcast<i32>(_e1774));
                        let _e1782 = (125i - _e1781);
                        let _e1783 = (_e1782 < 0i);
                        if _e1783 {
                            phi_2538_ = (_e1781 - 125i);
                        } else {
                            phi_2538_ = 0i;
                        }
                        let _e1786 = phi_2538_;
                        if _e1783 {
                            phi_2548_ = 0i;
                        } else {
                            phi_2548_ = select(_e1782, 31i, (_e1782 > 31i));
                        }
                        let _e1790 = phi_2548_;
                        let _e1795 = (_e1790 & 31i);
                        let _e1805 = (bitcast<i32>(_e1769) >> bitcast<u32>(31i));
                        let _e1815 = bitcast<u32>(-(_e1339.member_1.y));
                        let _e1818 = ((_e1815 >> bitcast<u32>(23i)) & 255u);
                        let _e1820 = select(0u, 1u, (_e1818 != 0u));
                        let _e1824 = ((_e1815 & 8388607u) | (_e1820 << bitcast<u32>(23i)));
                        let _e1827 = (bitcast<i32>(_e1818) - bitcast<i32>(_e1820));
                        let _e1828 = (125i - _e1827);
                        let _e1829 = (_e1828 < 0i);
                        if _e1829 {
                            phi_2597_ = (_e1827 - 125i);
                        } else {
                            phi_2597_ = 0i;
                        }
                        let _e1832 = phi_2597_;
                        if _e1829 {
                            phi_2607_ = 0i;
                        } else {
                            phi_2607_ = select(_e1828, 31i, (_e1828 > 31i));
                        }
                        let _e1836 = phi_2607_;
                        let _e1841 = (_e1836 & 31i);
                        let _e1851 = (bitcast<i32>(_e1815) >> bitcast<u32>(31i));
                        let _e1861 = bitcast<u32>(-(_e1339.member_1.z));
                        let _e1864 = ((_e1861 >> bitcast<u32>(23i)) & 255u);
                        let _e1866 = select(0u, 1u, (_e1864 != 0u));
                        let _e1870 = ((_e1861 & 8388607u) | (_e1866 << bitcast<u32>(23i)));
                        let _e1873 = (bitcast<i32>(_e1864) - bitcast<i32>(_e1866));
                        let _e1874 = (125i - _e1873);
                        let _e1875 = (_e1874 < 0i);
                        if _e1875 {
                            phi_2656_ = (_e1873 - 125i);
                        } else {
                            phi_2656_ = 0i;
                        }
                        let _e1878 = phi_2656_;
                        if _e1875 {
                            phi_2666_ = 0i;
                        } else {
                            phi_2666_ = select(_e1874, 31i, (_e1874 > 31i));
                        }
                        let _e1882 = phi_2666_;
                        let _e1887 = (_e1882 & 31i);
                        let _e1897 = (bitcast<i32>(_e1861) >> bitcast<u32>(31i));
                        local_13 = array<i32, 3>((((bitcast<i32>(((_e1645 << bitcast<u32>((bitcast<u32>(_e1653) & 31u))) >> bitcast<u32>(_e1662))) + select(0i, 1i, (((_e1645 & ((1u << bitcast<u32>(_e1662)) - 1u)) != 0u) && (_e1672 != 0i)))) ^ _e1672) - _e1672), (((bitcast<i32>(((_e1689 << bitcast<u32>((bitcast<u32>(_e1697) & 31u))) >> bitcast<u32>(_e1706))) + select(0i, 1i, (((_e1689 & ((1u << bitcast<u32>(_e1706)) - 1u)) != 0u) && (_e1716 != 0i)))) ^ _e1716) - _e1716), (((bitcast<i32>(((_e1733 << bitcast<u32>((bitcast<u32>(_e1741) & 31u))) >> bitcast<u32>(_e1750))) + select(0i, 1i, (((_e1733 & ((1u << bitcast<u32>(_e1750)) - 1u)) != 0u) && (_e1760 != 0i)))) ^ _e1760) - _e1760));
                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e1778 << bitcast<u32>((bitcast<u32>(_e1786) & 31u))) >> bitcast<u32>(_e1795))) + select(0i, 1i, (((_e1778 & ((1u << bitcast<u32>(_e1795)) - 1u)) != 0u) && (_e1805 != 0i)))) ^ _e1805) - _e1805)), -((((bitcast<i32>(((_e1824 << bitcast<u32>((bitcast<u32>(_e1832) & 31u))) >> bitcast<u32>(_e1841))) + select(0i, 1i, (((_e1824 & ((1u << bitcast<u32>(_e1841)) - 1u)) != 0u) && (_e1851 != 0i)))) ^ _e1851) - _e1851)), -((((bitcast<i32>(((_e1870 << bitcast<u32>((bitcast<u32>(_e1878) & 31u))) >> bitcast<u32>(_e1887))) + select(0i, 1i, (((_e1870 & ((1u << bitcast<u32>(_e1887)) - 1u)) != 0u) && (_e1897 != 0i)))) ^ _e1897) - _e1897)));
                        local_17 = array<u32, 7>(0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_2710_ = type_4(0u, 3u);
                        loop {
                            let _e1909 = phi_2710_;
                            if (_e1909.member < _e1909.member_1) {
                                phi_2711_ = type_4((_e1909.member + 1u), _e1909.member_1);
                                phi_2734_ = type_4(1u, _e1909.member);
                            } else {
                                phi_2711_ = _e1909;
                                phi_2734_ = type_4(0u, type_4().member_1);
                            }
                            let _e1922 = phi_2711_;
                            let _e1924 = phi_2734_;
                            let _e1928 = (bitcast<i32>(_e1924.member) != 0i);
                            if _e1928 {
                                let _e1929 = (_e1924.member_1 < 3u);
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1931 = local_5[_e1924.member_1];
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1933 = local_4[_e1924.member_1];
                                let _e1935 = bitcast<u32>((_e1933 - _e1931));
                                let _e1941 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1935)), 32u, (_e1935 == 0u)));
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1946 = local_15[_e1924.member_1];
                                let _e1947 = (_e1946 - _e1931);
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1949 = local_13[_e1924.member_1];
                                let _e1950 = (_e1949 - _e1931);
                                let _e1951 = (_e1947 > _e1950);
                                let _e1954 = ((select(21u, _e1941, (_e1941 > 21u)) - 21u) & 31u);
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1963 = local_14[_e1924.member_1];
                                let _e1964 = (_e1933 - _e1963);
                                if _e1929 {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                let _e1966 = local_12[_e1924.member_1];
                                let _e1967 = (_e1933 - _e1966);
                                let _e1968 = (_e1964 > _e1967);
                                let _e1978 = (_e1924.member_1 * 2u);
                                let _e1980 = ((1u + _e1978) % 7u);
                                if (_e1980 < 7u) {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                local_17[_e1980] = (((bitcast<u32>(select(_e1950, _e1947, _e1951)) >> bitcast<u32>(_e1954)) & 2097151u) | (select(0u, 1u, _e1951) << bitcast<u32>(21u)));
                                let _e1984 = ((_e1978 + 2u) % 7u);
                                if (_e1984 < 7u) {
                                } else {
                                    phi_3709_ = true;
                                    break;
                                }
                                local_17[_e1984] = (((bitcast<u32>(select(_e1967, _e1964, _e1968)) >> bitcast<u32>(_e1954)) & 2097151u) | (select(0u, 1u, _e1968) << bitcast<u32>(21u)));
                            }
                            continue;
                            continuing {
                                phi_2710_ = _e1922;
                                phi_3709_ = _e1275;
                                break if !(_e1928);
                            }
                        }
                        let _e1989 = phi_3709_;
                        if _e1989 {
                            break;
                        }
                        phi_2908_ = type_4(0u, 3u);
                        loop {
                            let _e1991 = phi_2908_;
                            if (_e1991.member < _e1991.member_1) {
                                phi_2909_ = type_4((_e1991.member + 1u), _e1991.member_1);
                                phi_2932_ = type_4(1u, _e1991.member);
                            } else {
                                phi_2909_ = _e1991;
                                phi_2932_ = type_4(0u, type_4().member_1);
                            }
                            let _e2004 = phi_2909_;
                            let _e2006 = phi_2932_;
                            let _e2010 = (bitcast<i32>(_e2006.member) != 0i);
                            if _e2010 {
                                let _e2011 = (_e2006.member_1 * 2u);
                                if (((1u + _e2011) % 7u) < 7u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if (((_e2011 + 2u) % 7u) < 7u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                let _e2018 = (_e2006.member_1 < 3u);
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2908_ = _e2004;
                                phi_3761_ = _e1989;
                                break if !(_e2010);
                            }
                        }
                        let _e2021 = phi_3761_;
                        if _e2021 {
                            break;
                        }
                        let _e2022 = local_17;
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e79 {
                        } else {
                            break;
                        }
                        let _e2024 = ((_e1281 & 2147483648u) != 0u);
                        if _e2024 {
                            let _e2028 = (((_e1281 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e2028 {
                                phi_3143_ = (_e1281 & 268435455u);
                            } else {
                                phi_3143_ = u32();
                            }
                            let _e2031 = phi_3143_;
                            phi_3145_ = _e2031;
                            phi_3146_ = select(true, false, _e2028);
                        } else {
                            phi_3145_ = u32();
                            phi_3146_ = true;
                        }
                        let _e2034 = phi_3145_;
                        let _e2036 = phi_3146_;
                        if _e2036 {
                            if ((_e1312 & 2147483648u) != 0u) {
                                let _e2042 = (((_e1312 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e2042 {
                                    phi_3162_ = (_e1312 & 268435455u);
                                } else {
                                    phi_3162_ = u32();
                                }
                                let _e2045 = phi_3162_;
                                phi_3164_ = _e2045;
                                phi_3165_ = select(true, false, _e2042);
                            } else {
                                phi_3164_ = u32();
                                phi_3165_ = true;
                            }
                            let _e2048 = phi_3164_;
                            let _e2050 = phi_3165_;
                            phi_3170_ = select(_e2048, 0u, _e2050);
                        } else {
                            phi_3170_ = _e2034;
                        }
                        let _e2053 = phi_3170_;
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e2024 {
                            phi_3198_ = select(_e1312, 0u, ((_e1312 & 2147483648u) != 0u));
                        } else {
                            phi_3198_ = _e1281;
                        }
                        let _e2058 = phi_3198_;
                        if _e2024 {
                            let _e2061 = ((_e1281 >> bitcast<u32>(28u)) & 7u);
                            phi_3213_ = select(_e2061, 7u, (_e2061 == 0u));
                        } else {
                            phi_3213_ = 0u;
                        }
                        let _e2065 = phi_3213_;
                        if ((_e1312 & 2147483648u) != 0u) {
                            let _e2070 = ((_e1312 >> bitcast<u32>(28u)) & 7u);
                            phi_3228_ = select(_e2070, 7u, (_e2070 == 0u));
                        } else {
                            phi_3228_ = 0u;
                        }
                        let _e2074 = phi_3228_;
                        local_16 = _e2022;
                        local_16[0u] = (((_e2058 & 268435455u) | (_e2065 << bitcast<u32>(28u))) | (_e2074 << bitcast<u32>(31i)));
                        phi_3330_ = type_4(0u, 3u);
                        loop {
                            let _e2090 = phi_3330_;
                            if (_e2090.member < _e2090.member_1) {
                                phi_3331_ = type_4((_e2090.member + 1u), _e2090.member_1);
                                phi_3354_ = type_4(1u, _e2090.member);
                            } else {
                                phi_3331_ = _e2090;
                                phi_3354_ = type_4(0u, type_4().member_1);
                            }
                            let _e2103 = phi_3331_;
                            let _e2105 = phi_3354_;
                            let _e2109 = (bitcast<i32>(_e2105.member) != 0i);
                            if _e2109 {
                                let _e2118 = (((_e2105.member_1 + 1u) * 2u) % 7u);
                                if (_e2118 < 7u) {
                                } else {
                                    phi_3771_ = true;
                                    break;
                                }
                                let _e2121 = local_16[_e2118];
                                local_16[_e2118] = (_e2121 | ((((_e2053 & 268435455u) | ((_e2074 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e2105.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_3330_ = _e2103;
                                phi_3771_ = _e2021;
                                break if !(_e2109);
                            }
                        }
                        let _e2125 = phi_3771_;
                        if _e2125 {
                            break;
                        }
                        let _e2126 = local_16;
                        if _e80 {
                        } else {
                            break;
                        }
                        global_4.member[_e74] = array<u32, 7>(_e2126[0], _e2126[1], _e2126[2], _e2126[3], _e2126[4], _e2126[5], _e2126[6]);
                        if (_e74 == 0u) {
                            if (_e70 == 0u) {
                            } else {
                                if (0u < _e70) {
                                } else {
                                    break;
                                }
                                global_3.member[0u] = type_24(array<u32, 4>(bitcast<u32>(_e1277[0]), bitcast<u32>(_e1277[1]), bitcast<u32>(_e1277[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e1276[0]), bitcast<u32>(_e1276[1]), bitcast<u32>(_e1276[2]), 0u));
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
