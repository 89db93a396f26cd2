struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_21 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

struct type_27 {
    member: array<u32, 4>,
    member_1: array<u32, 4>,
}

struct type_29 {
    member: array<type_27>,
}

struct type_33 {
    member: array<i32, 3>,
    member_1: array<i32, 3>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<storage> global_2: type_23;
@group(0) @binding(2) 
var<storage, read_write> global_3: type_9;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_29;

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
    var local_16: array<u32, 4>;
    var local_17: array<u32, 4>;
    var local_18: array<u32, 4>;
    var phi_170_: type_21;
    var phi_188_: type_26;
    var phi_206_: type_26;
    var phi_272_: i32;
    var phi_282_: i32;
    var phi_329_: i32;
    var phi_339_: i32;
    var phi_386_: i32;
    var phi_396_: i32;
    var phi_445_: i32;
    var phi_455_: i32;
    var phi_504_: i32;
    var phi_514_: i32;
    var phi_563_: i32;
    var phi_573_: i32;
    var phi_3639_: bool;
    var phi_617_: type_4;
    var phi_620_: u32;
    var phi_618_: type_4;
    var phi_643_: type_4;
    var phi_665_: type_21;
    var phi_673_: bool;
    var phi_691_: type_26;
    var phi_709_: type_26;
    var phi_736_: i32;
    var phi_746_: i32;
    var phi_793_: i32;
    var phi_803_: i32;
    var phi_850_: i32;
    var phi_860_: i32;
    var phi_909_: i32;
    var phi_919_: i32;
    var phi_968_: i32;
    var phi_978_: i32;
    var phi_1027_: i32;
    var phi_1037_: i32;
    var phi_1104_: i32;
    var phi_1114_: i32;
    var phi_1161_: i32;
    var phi_1171_: i32;
    var phi_1218_: i32;
    var phi_1228_: i32;
    var phi_1277_: i32;
    var phi_1287_: i32;
    var phi_1336_: i32;
    var phi_1346_: i32;
    var phi_1395_: i32;
    var phi_1405_: i32;
    var phi_1449_: type_4;
    var phi_1450_: type_4;
    var phi_1473_: type_4;
    var phi_1508_: u32;
    var phi_3594_: bool;
    var phi_1647_: type_4;
    var phi_1648_: type_4;
    var phi_1671_: type_4;
    var phi_1783_: u32;
    var phi_3677_: bool;
    var phi_1876_: type_33;
    var phi_3696_: bool;
    var phi_1894_: u32;
    var phi_3695_: bool;
    var phi_621_: u32;
    var phi_1896_: bool;
    var phi_3694_: bool;
    var phi_1947_: type_26;
    var phi_1969_: type_26;
    var phi_1996_: i32;
    var phi_2006_: i32;
    var phi_2053_: i32;
    var phi_2063_: i32;
    var phi_2110_: i32;
    var phi_2120_: i32;
    var phi_2169_: i32;
    var phi_2179_: i32;
    var phi_2228_: i32;
    var phi_2238_: i32;
    var phi_2287_: i32;
    var phi_2297_: i32;
    var phi_2364_: i32;
    var phi_2374_: i32;
    var phi_2421_: i32;
    var phi_2431_: i32;
    var phi_2478_: i32;
    var phi_2488_: i32;
    var phi_2537_: i32;
    var phi_2547_: i32;
    var phi_2596_: i32;
    var phi_2606_: i32;
    var phi_2655_: i32;
    var phi_2665_: i32;
    var phi_2709_: type_4;
    var phi_2710_: type_4;
    var phi_2733_: type_4;
    var phi_2768_: u32;
    var phi_3699_: bool;
    var phi_2907_: type_4;
    var phi_2908_: type_4;
    var phi_2931_: type_4;
    var phi_3751_: bool;
    var phi_3139_: u32;
    var phi_3141_: u32;
    var phi_3142_: bool;
    var phi_3158_: u32;
    var phi_3160_: u32;
    var phi_3161_: bool;
    var phi_3166_: u32;
    var phi_3194_: u32;
    var phi_3209_: u32;
    var phi_3224_: u32;
    var phi_3323_: type_4;
    var phi_3324_: type_4;
    var phi_3347_: type_4;
    var phi_3761_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = global;
            let _e67 = arrayLength((&global_2.member));
            let _e71 = arrayLength((&global_4.member));
            let _e75 = (_e65.x + (_e65.y * 2097152u));
            let _e78 = global_1.member[0u];
            if (_e75 < _e78) {
                let _e80 = (_e75 < _e67);
                if _e80 {
                    let _e81 = (_e75 < arrayLength((&global_3.member)));
                    if _e81 {
                        let _e82 = (0u < _e67);
                        if _e82 {
                            if _e82 {
                            } else {
                                break;
                            }
                            let _e85 = global_2.member[0u];
                            phi_170_ = _e85;
                        } else {
                            phi_170_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e87 = phi_170_;
                        if (_e87.member_1 == 2147483648u) {
                            phi_188_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_188_ = type_26(vec3<f32>(_e87.member[0][0], _e87.member[1][0], _e87.member[2][0]), vec3<f32>(_e87.member[0][2], _e87.member[1][2], _e87.member[2][2]));
                        }
                        let _e106 = phi_188_;
                        if (_e87.member_2 == 2147483648u) {
                            phi_206_ = _e106;
                        } else {
                            phi_206_ = type_26(vec3<f32>(_e87.member[0][1], _e87.member[1][1], _e87.member[2][1]), vec3<f32>(_e87.member[0][3], _e87.member[1][3], _e87.member[2][3]));
                        }
                        let _e125 = phi_206_;
                        let _e154 = bitcast<u32>(select(_e125.member.x, _e106.member.x, (_e106.member.x < _e125.member.x)));
                        let _e157 = ((_e154 >> bitcast<u32>(23i)) & 255u);
                        let _e159 = select(0u, 1u, (_e157 != 0u));
                        let _e163 = ((_e154 & 8388607u) | (_e159 << bitcast<u32>(23i)));
                        let _e166 = (bitcast<i32>(_e157) - bitcast<i32>(_e159));
                        let _e167 = (125i - _e166);
                        let _e168 = (_e167 < 0i);
                        if _e168 {
                            phi_272_ = (_e166 - 125i);
                        } else {
                            phi_272_ = 0i;
                        }
                        let _e171 = phi_272_;
                        if _e168 {
                            phi_282_ = 0i;
                        } else {
                            phi_282_ = select(_e167, 31i, (_e167 > 31i));
                        }
                        let _e175 = phi_282_;
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
                            phi_329_ = (_e210 - 125i);
                        } else {
                            phi_329_ = 0i;
                        }
                        let _e215 = phi_329_;
                        if _e212 {
                            phi_339_ = 0i;
                        } else {
                            phi_339_ = select(_e211, 31i, (_e211 > 31i));
                        }
                        let _e219 = phi_339_;
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
                            phi_386_ = (_e254 - 125i);
                        } else {
                            phi_386_ = 0i;
                        }
                        let _e259 = phi_386_;
                        if _e256 {
                            phi_396_ = 0i;
                        } else {
                            phi_396_ = select(_e255, 31i, (_e255 > 31i));
                        }
                        let _e263 = phi_396_;
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
                            phi_445_ = (_e299 - 125i);
                        } else {
                            phi_445_ = 0i;
                        }
                        let _e304 = phi_445_;
                        if _e301 {
                            phi_455_ = 0i;
                        } else {
                            phi_455_ = select(_e300, 31i, (_e300 > 31i));
                        }
                        let _e308 = phi_455_;
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
                            phi_504_ = (_e345 - 125i);
                        } else {
                            phi_504_ = 0i;
                        }
                        let _e350 = phi_504_;
                        if _e347 {
                            phi_514_ = 0i;
                        } else {
                            phi_514_ = select(_e346, 31i, (_e346 > 31i));
                        }
                        let _e354 = phi_514_;
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
                            phi_563_ = (_e391 - 125i);
                        } else {
                            phi_563_ = 0i;
                        }
                        let _e396 = phi_563_;
                        if _e393 {
                            phi_573_ = 0i;
                        } else {
                            phi_573_ = select(_e392, 31i, (_e392 > 31i));
                        }
                        let _e400 = phi_573_;
                        let _e405 = (_e400 & 31i);
                        let _e415 = (bitcast<i32>(_e379) >> bitcast<u32>(31i));
                        local_7 = array<i32, 3>((((bitcast<i32>(((_e163 << bitcast<u32>((bitcast<u32>(_e171) & 31u))) >> bitcast<u32>(_e180))) + select(0i, 1i, (((_e163 & ((1u << bitcast<u32>(_e180)) - 1u)) != 0u) && (_e190 != 0i)))) ^ _e190) - _e190), (((bitcast<i32>(((_e207 << bitcast<u32>((bitcast<u32>(_e215) & 31u))) >> bitcast<u32>(_e224))) + select(0i, 1i, (((_e207 & ((1u << bitcast<u32>(_e224)) - 1u)) != 0u) && (_e234 != 0i)))) ^ _e234) - _e234), (((bitcast<i32>(((_e251 << bitcast<u32>((bitcast<u32>(_e259) & 31u))) >> bitcast<u32>(_e268))) + select(0i, 1i, (((_e251 & ((1u << bitcast<u32>(_e268)) - 1u)) != 0u) && (_e278 != 0i)))) ^ _e278) - _e278));
                        local_6 = array<i32, 3>(-((((bitcast<i32>(((_e296 << bitcast<u32>((bitcast<u32>(_e304) & 31u))) >> bitcast<u32>(_e313))) + select(0i, 1i, (((_e296 & ((1u << bitcast<u32>(_e313)) - 1u)) != 0u) && (_e323 != 0i)))) ^ _e323) - _e323)), -((((bitcast<i32>(((_e342 << bitcast<u32>((bitcast<u32>(_e350) & 31u))) >> bitcast<u32>(_e359))) + select(0i, 1i, (((_e342 & ((1u << bitcast<u32>(_e359)) - 1u)) != 0u) && (_e369 != 0i)))) ^ _e369) - _e369)), -((((bitcast<i32>(((_e388 << bitcast<u32>((bitcast<u32>(_e396) & 31u))) >> bitcast<u32>(_e405))) + select(0i, 1i, (((_e388 & ((1u << bitcast<u32>(_e405)) - 1u)) != 0u) && (_e415 != 0i)))) ^ _e415) - _e415)));
                        phi_3639_ = false;
                        phi_617_ = type_4(0u, 128u);
                        phi_620_ = 0u;
                        loop {
                            let _e427 = phi_3639_;
                            let _e429 = phi_617_;
                            let _e431 = phi_620_;
                            if (_e429.member < _e429.member_1) {
                                phi_618_ = type_4((_e429.member + 1u), _e429.member_1);
                                phi_643_ = type_4(1u, _e429.member);
                            } else {
                                phi_618_ = _e429;
                                phi_643_ = type_4(0u, type_4().member_1);
                            }
                            let _e444 = phi_618_;
                            let _e446 = phi_643_;
                            if (bitcast<i32>(_e446.member) != 0i) {
                                let _e450 = (_e431 == _e75);
                                if _e450 {
                                    phi_3696_ = _e427;
                                    phi_1894_ = u32();
                                } else {
                                    let _e451 = (_e431 < _e67);
                                    if _e451 {
                                        if _e451 {
                                        } else {
                                            phi_3694_ = true;
                                            break;
                                        }
                                        let _e454 = global_2.member[_e431];
                                        phi_665_ = _e454;
                                    } else {
                                        phi_665_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e456 = phi_665_;
                                    if ((_e456.member_1 & 2147483648u) != 0u) {
                                        phi_673_ = false;
                                    } else {
                                        phi_673_ = (_e75 <= _e456.member_1);
                                    }
                                    let _e462 = phi_673_;
                                    if (_e456.member_1 == 2147483648u) {
                                        phi_691_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_691_ = type_26(vec3<f32>(_e456.member[0][0], _e456.member[1][0], _e456.member[2][0]), vec3<f32>(_e456.member[0][2], _e456.member[1][2], _e456.member[2][2]));
                                    }
                                    let _e480 = phi_691_;
                                    if (_e456.member_2 == 2147483648u) {
                                        phi_709_ = _e480;
                                    } else {
                                        phi_709_ = type_26(vec3<f32>(_e456.member[0][1], _e456.member[1][1], _e456.member[2][1]), vec3<f32>(_e456.member[0][3], _e456.member[1][3], _e456.member[2][3]));
                                    }
                                    let _e499 = phi_709_;
                                    let _e512 = bitcast<u32>(_e480.member.x);
                                    let _e515 = ((_e512 >> bitcast<u32>(23i)) & 255u);
                                    let _e517 = select(0u, 1u, (_e515 != 0u));
                                    let _e521 = ((_e512 & 8388607u) | (_e517 << bitcast<u32>(23i)));
                                    let _e524 = (bitcast<i32>(_e515) - bitcast<i32>(_e517));
                                    let _e525 = (125i - _e524);
                                    let _e526 = (_e525 < 0i);
                                    if _e526 {
                                        phi_736_ = (_e524 - 125i);
                                    } else {
                                        phi_736_ = 0i;
                                    }
                                    let _e529 = phi_736_;
                                    if _e526 {
                                        phi_746_ = 0i;
                                    } else {
                                        phi_746_ = select(_e525, 31i, (_e525 > 31i));
                                    }
                                    let _e533 = phi_746_;
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
                                        phi_793_ = (_e568 - 125i);
                                    } else {
                                        phi_793_ = 0i;
                                    }
                                    let _e573 = phi_793_;
                                    if _e570 {
                                        phi_803_ = 0i;
                                    } else {
                                        phi_803_ = select(_e569, 31i, (_e569 > 31i));
                                    }
                                    let _e577 = phi_803_;
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
                                        phi_850_ = (_e612 - 125i);
                                    } else {
                                        phi_850_ = 0i;
                                    }
                                    let _e617 = phi_850_;
                                    if _e614 {
                                        phi_860_ = 0i;
                                    } else {
                                        phi_860_ = select(_e613, 31i, (_e613 > 31i));
                                    }
                                    let _e621 = phi_860_;
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
                                        phi_909_ = (_e657 - 125i);
                                    } else {
                                        phi_909_ = 0i;
                                    }
                                    let _e662 = phi_909_;
                                    if _e659 {
                                        phi_919_ = 0i;
                                    } else {
                                        phi_919_ = select(_e658, 31i, (_e658 > 31i));
                                    }
                                    let _e666 = phi_919_;
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
                                        phi_968_ = (_e703 - 125i);
                                    } else {
                                        phi_968_ = 0i;
                                    }
                                    let _e708 = phi_968_;
                                    if _e705 {
                                        phi_978_ = 0i;
                                    } else {
                                        phi_978_ = select(_e704, 31i, (_e704 > 31i));
                                    }
                                    let _e712 = phi_978_;
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
                                        phi_1027_ = (_e749 - 125i);
                                    } else {
                                        phi_1027_ = 0i;
                                    }
                                    let _e754 = phi_1027_;
                                    if _e751 {
                                        phi_1037_ = 0i;
                                    } else {
                                        phi_1037_ = select(_e750, 31i, (_e750 > 31i));
                                    }
                                    let _e758 = phi_1037_;
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
                                        phi_1104_ = (_e808 - 125i);
                                    } else {
                                        phi_1104_ = 0i;
                                    }
                                    let _e813 = phi_1104_;
                                    if _e810 {
                                        phi_1114_ = 0i;
                                    } else {
                                        phi_1114_ = select(_e809, 31i, (_e809 > 31i));
                                    }
                                    let _e817 = phi_1114_;
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
                                        phi_1161_ = (_e852 - 125i);
                                    } else {
                                        phi_1161_ = 0i;
                                    }
                                    let _e857 = phi_1161_;
                                    if _e854 {
                                        phi_1171_ = 0i;
                                    } else {
                                        phi_1171_ = select(_e853, 31i, (_e853 > 31i));
                                    }
                                    let _e861 = phi_1171_;
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
                                        phi_1218_ = (_e896 - 125i);
                                    } else {
                                        phi_1218_ = 0i;
                                    }
                                    let _e901 = phi_1218_;
                                    if _e898 {
                                        phi_1228_ = 0i;
                                    } else {
                                        phi_1228_ = select(_e897, 31i, (_e897 > 31i));
                                    }
                                    let _e905 = phi_1228_;
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
                                        phi_1277_ = (_e941 - 125i);
                                    } else {
                                        phi_1277_ = 0i;
                                    }
                                    let _e946 = phi_1277_;
                                    if _e943 {
                                        phi_1287_ = 0i;
                                    } else {
                                        phi_1287_ = select(_e942, 31i, (_e942 > 31i));
                                    }
                                    let _e950 = phi_1287_;
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
                                        phi_1336_ = (_e987 - 125i);
                                    } else {
                                        phi_1336_ = 0i;
                                    }
                                    let _e992 = phi_1336_;
                                    if _e989 {
                                        phi_1346_ = 0i;
                                    } else {
                                        phi_1346_ = select(_e988, 31i, (_e988 > 31i));
                                    }
                                    let _e996 = phi_1346_;
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
                                        phi_1395_ = (_e1033 - 125i);
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
                                    let _e1057 = (bitcast<i32>(_e1021) >> bitcast<u32>(31i));
                                    local_9 = array<i32, 3>((((bitcast<i32>(((_e805 << bitcast<u32>((bitcast<u32>(_e813) & 31u))) >> bitcast<u32>(_e822))) + select(0i, 1i, (((_e805 & ((1u << bitcast<u32>(_e822)) - 1u)) != 0u) && (_e832 != 0i)))) ^ _e832) - _e832), (((bitcast<i32>(((_e849 << bitcast<u32>((bitcast<u32>(_e857) & 31u))) >> bitcast<u32>(_e866))) + select(0i, 1i, (((_e849 & ((1u << bitcast<u32>(_e866)) - 1u)) != 0u) && (_e876 != 0i)))) ^ _e876) - _e876), (((bitcast<i32>(((_e893 << bitcast<u32>((bitcast<u32>(_e901) & 31u))) >> bitcast<u32>(_e910))) + select(0i, 1i, (((_e893 & ((1u << bitcast<u32>(_e910)) - 1u)) != 0u) && (_e920 != 0i)))) ^ _e920) - _e920));
                                    local_8 = array<i32, 3>(-((((bitcast<i32>(((_e938 << bitcast<u32>((bitcast<u32>(_e946) & 31u))) >> bitcast<u32>(_e955))) + select(0i, 1i, (((_e938 & ((1u << bitcast<u32>(_e955)) - 1u)) != 0u) && (_e965 != 0i)))) ^ _e965) - _e965)), -((((bitcast<i32>(((_e984 << bitcast<u32>((bitcast<u32>(_e992) & 31u))) >> bitcast<u32>(_e1001))) + select(0i, 1i, (((_e984 & ((1u << bitcast<u32>(_e1001)) - 1u)) != 0u) && (_e1011 != 0i)))) ^ _e1011) - _e1011)), -((((bitcast<i32>(((_e1030 << bitcast<u32>((bitcast<u32>(_e1038) & 31u))) >> bitcast<u32>(_e1047))) + select(0i, 1i, (((_e1030 & ((1u << bitcast<u32>(_e1047)) - 1u)) != 0u) && (_e1057 != 0i)))) ^ _e1057) - _e1057)));
                                    local_18 = array<u32, 4>(0u, 0u, 0u, 0u);
                                    phi_1449_ = type_4(0u, 3u);
                                    loop {
                                        let _e1069 = phi_1449_;
                                        if (_e1069.member < _e1069.member_1) {
                                            phi_1450_ = type_4((_e1069.member + 1u), _e1069.member_1);
                                            phi_1473_ = type_4(1u, _e1069.member);
                                        } else {
                                            phi_1450_ = _e1069;
                                            phi_1473_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1082 = phi_1450_;
                                        let _e1084 = phi_1473_;
                                        let _e1088 = (bitcast<i32>(_e1084.member) != 0i);
                                        if _e1088 {
                                            let _e1089 = (_e1084.member_1 < 3u);
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1091 = local_7[_e1084.member_1];
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1093 = local_6[_e1084.member_1];
                                            let _e1095 = bitcast<u32>((_e1093 - _e1091));
                                            let _e1100 = select((bitcast<u32>(31i) - firstLeadingBit(_e1095)), 32u, (_e1095 == 0u));
                                            if ((32u - _e1100) > 10u) {
                                                phi_1508_ = (22u - _e1100);
                                            } else {
                                                phi_1508_ = 0u;
                                            }
                                            let _e1105 = phi_1508_;
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1107 = local_11[_e1084.member_1];
                                            let _e1108 = (_e1107 - _e1091);
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1110 = local_9[_e1084.member_1];
                                            let _e1111 = (_e1110 - _e1091);
                                            let _e1112 = (_e1108 > _e1111);
                                            let _e1115 = (_e1105 & 31u);
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1124 = local_10[_e1084.member_1];
                                            let _e1125 = (_e1093 - _e1124);
                                            if _e1089 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1127 = local_8[_e1084.member_1];
                                            let _e1128 = (_e1093 - _e1127);
                                            let _e1129 = (_e1125 > _e1128);
                                            let _e1142 = ((1u + _e1084.member_1) % 4u);
                                            if (_e1142 < 4u) {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            local_18[_e1142] = ((((bitcast<u32>(select(_e1111, _e1108, _e1112)) >> bitcast<u32>(_e1115)) & 1023u) | (select(0u, 1u, _e1112) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1128, _e1125, _e1129)) >> bitcast<u32>(_e1115)) & 1023u) | (select(0u, 1u, _e1129) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_1449_ = _e1082;
                                            phi_3594_ = _e427;
                                            break if !(_e1088);
                                        }
                                    }
                                    let _e1148 = phi_3594_;
                                    phi_3694_ = _e1148;
                                    if _e1148 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_1647_ = type_4(0u, 3u);
                                    loop {
                                        let _e1150 = phi_1647_;
                                        if (_e1150.member < _e1150.member_1) {
                                            phi_1648_ = type_4((_e1150.member + 1u), _e1150.member_1);
                                            phi_1671_ = type_4(1u, _e1150.member);
                                        } else {
                                            phi_1648_ = _e1150;
                                            phi_1671_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1163 = phi_1648_;
                                        let _e1165 = phi_1671_;
                                        let _e1169 = (bitcast<i32>(_e1165.member) != 0i);
                                        if _e1169 {
                                            let _e1171 = ((1u + _e1165.member_1) % 4u);
                                            if (_e1171 < 4u) {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1174 = local_18[_e1171];
                                            let _e1176 = ((_e1165.member_1 + 1u) % 4u);
                                            if (_e1176 < 4u) {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1179 = local_18[_e1176];
                                            let _e1180 = (_e1165.member_1 < 3u);
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1182 = local_7[_e1165.member_1];
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1184 = local_6[_e1165.member_1];
                                            let _e1186 = (_e1179 >> bitcast<u32>(11u));
                                            let _e1188 = bitcast<u32>((_e1184 - _e1182));
                                            let _e1193 = select((bitcast<u32>(31i) - firstLeadingBit(_e1188)), 32u, (_e1188 == 0u));
                                            if ((32u - _e1193) > 10u) {
                                                phi_1783_ = (22u - _e1193);
                                            } else {
                                                phi_1783_ = 0u;
                                            }
                                            let _e1198 = phi_1783_;
                                            let _e1200 = (_e1198 & 31u);
                                            let _e1204 = (_e1182 + bitcast<i32>(((_e1174 & 1023u) << bitcast<u32>(_e1200))));
                                            let _e1209 = (_e1184 - bitcast<i32>(((_e1186 & 1023u) << bitcast<u32>(_e1200))));
                                            let _e1213 = (((_e1174 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            let _e1217 = (((_e1186 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_3[_e1165.member_1] = select(_e1182, _e1204, _e1213);
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_1[_e1165.member_1] = select(_e1204, _e1182, _e1213);
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_2[_e1165.member_1] = select(_e1184, _e1209, _e1217);
                                            if _e1180 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local[_e1165.member_1] = select(_e1209, _e1184, _e1217);
                                        }
                                        continue;
                                        continuing {
                                            phi_1647_ = _e1163;
                                            phi_3677_ = _e1148;
                                            break if !(_e1169);
                                        }
                                    }
                                    let _e1228 = phi_3677_;
                                    phi_3694_ = _e1228;
                                    if _e1228 {
                                        break;
                                    }
                                    let _e1229 = local;
                                    let _e1230 = local_1;
                                    let _e1231 = local_2;
                                    let _e1232 = local_3;
                                    if _e462 {
                                        phi_1876_ = type_33(array<i32, 3>(_e1232[0], _e1232[1], _e1232[2]), array<i32, 3>(_e1231[0], _e1231[1], _e1231[2]));
                                    } else {
                                        phi_1876_ = type_33(array<i32, 3>(_e1230[0], _e1230[1], _e1230[2]), array<i32, 3>(_e1229[0], _e1229[1], _e1229[2]));
                                    }
                                    let _e1252 = phi_1876_;
                                    local_7 = array<i32, 3>(_e1252.member[0], _e1252.member[1], _e1252.member[2]);
                                    local_6 = array<i32, 3>(_e1252.member_1[0], _e1252.member_1[1], _e1252.member_1[2]);
                                    phi_3696_ = _e1228;
                                    phi_1894_ = select(_e456.member_2, _e456.member_1, _e462);
                                }
                                let _e1265 = phi_3696_;
                                let _e1267 = phi_1894_;
                                phi_3695_ = _e1265;
                                phi_621_ = _e1267;
                                phi_1896_ = select(true, false, _e450);
                            } else {
                                phi_3695_ = _e427;
                                phi_621_ = u32();
                                phi_1896_ = false;
                            }
                            let _e1270 = phi_3695_;
                            let _e1272 = phi_621_;
                            let _e1274 = phi_1896_;
                            continue;
                            continuing {
                                phi_3639_ = _e1270;
                                phi_617_ = _e444;
                                phi_620_ = _e1272;
                                phi_3694_ = _e1270;
                                break if !(_e1274);
                            }
                        }
                        let _e1277 = phi_3694_;
                        if _e1277 {
                            break;
                        }
                        let _e1278 = local_6;
                        let _e1279 = local_7;
                        local_5 = _e1279;
                        local_4 = _e1278;
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e1283 = global_2.member[_e75].member_1;
                        if (_e1283 == 2147483648u) {
                            phi_1947_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1289 = global_2.member[_e75].member[0u];
                            let _e1294 = global_2.member[_e75].member[1u];
                            let _e1299 = global_2.member[_e75].member[2u];
                            phi_1947_ = type_26(vec3<f32>(_e1289[0], _e1294[0], _e1299[0]), vec3<f32>(_e1289[2], _e1294[2], _e1299[2]));
                        }
                        let _e1310 = phi_1947_;
                        let _e1314 = global_2.member[_e75].member_2;
                        if (_e1314 == 2147483648u) {
                            phi_1969_ = _e1310;
                        } else {
                            let _e1320 = global_2.member[_e75].member[0u];
                            let _e1325 = global_2.member[_e75].member[1u];
                            let _e1330 = global_2.member[_e75].member[2u];
                            phi_1969_ = type_26(vec3<f32>(_e1320[1], _e1325[1], _e1330[1]), vec3<f32>(_e1320[3], _e1325[3], _e1330[3]));
                        }
                        let _e1341 = phi_1969_;
                        let _e1354 = bitcast<u32>(_e1310.member.x);
                        let _e1357 = ((_e1354 >> bitcast<u32>(23i)) & 255u);
                        let _e1359 = select(0u, 1u, (_e1357 != 0u));
                        let _e1363 = ((_e1354 & 8388607u) | (_e1359 << bitcast<u32>(23i)));
                        let _e1366 = (bitcast<i32>(_e1357) - bitcast<i32>(_e1359));
                        let _e1367 = (125i - _e1366);
                        let _e1368 = (_e1367 < 0i);
                        if _e1368 {
                            phi_1996_ = (_e1366 - 125i);
                        } else {
                            phi_1996_ = 0i;
                        }
                        let _e1371 = phi_1996_;
                        if _e1368 {
                            phi_2006_ = 0i;
                        } else {
                            phi_2006_ = select(_e1367, 31i, (_e1367 > 31i));
                        }
                        let _e1375 = phi_2006_;
                        let _e1380 = (_e1375 & 31i);
                        let _e1390 = (bitcast<i32>(_e1354) >> bitcast<u32>(31i));
                        let _e1398 = bitcast<u32>(_e1310.member.y);
                        let _e1401 = ((_e1398 >> bitcast<u32>(23i)) & 255u);
                        let _e1403 = select(0u, 1u, (_e1401 != 0u));
                        let _e1407 = ((_e1398 & 8388607u) | (_e1403 << bitcast<u32>(23i)));
                        let _e1410 = (bitcast<i32>(_e1401) - bitcast<i32>(_e1403));
                        let _e1411 = (125i - _e1410);
                        let _e1412 = (_e1411 < 0i);
                        if _e1412 {
                            phi_2053_ = (_e1410 - 125i);
                        } else {
                            phi_2053_ = 0i;
                        }
                        let _e1415 = phi_2053_;
                        if _e1412 {
                            phi_2063_ = 0i;
                        } else {
                            phi_2063_ = select(_e1411, 31i, (_e1411 > 31i));
                        }
                        let _e1419 = phi_2063_;
                        let _e1424 = (_e1419 & 31i);
                        let _e1434 = (bitcast<i32>(_e1398) >> bitcast<u32>(31i));
                        let _e1442 = bitcast<u32>(_e1310.member.z);
                        let _e1445 = ((_e1442 >> bitcast<u32>(23i)) & 255u);
                        let _e1447 = select(0u, 1u, (_e1445 != 0u));
                        let _e1451 = ((_e1442 & 8388607u) | (_e1447 << bitcast<u32>(23i)));
                        let _e1454 = (bitcast<i32>(_e1445) - bitcast<i32>(_e1447));
                        let _e1455 = (125i - _e1454);
                        let _e1456 = (_e1455 < 0i);
                        if _e1456 {
                            phi_2110_ = (_e1454 - 125i);
                        } else {
                            phi_2110_ = 0i;
                        }
                        let _e1459 = phi_2110_;
                        if _e1456 {
                            phi_2120_ = 0i;
                        } else {
                            phi_2120_ = select(_e1455, 31i, (_e1455 > 31i));
                        }
                        let _e1463 = phi_2120_;
                        let _e1468 = (_e1463 & 31i);
                        let _e1478 = (bitcast<i32>(_e1442) >> bitcast<u32>(31i));
                        let _e1487 = bitcast<u32>(-(_e1310.member_1.x));
                        let _e1490 = ((_e1487 >> bitcast<u32>(23i)) & 255u);
                        let _e1492 = select(0u, 1u, (_e1490 != 0u));
                        let _e1496 = ((_e1487 & 8388607u) | (_e1492 << bitcast<u32>(23i)));
                        let _e1499 = (bitcast<i32>(_e1490) - bitcast<i32>(_e1492));
                        let _e1500 = (125i - _e1499);
                        let _e1501 = (_e1500 < 0i);
                        if _e1501 {
                            phi_2169_ = (_e1499 - 125i);
                        } else {
                            phi_2169_ = 0i;
                        }
                        let _e1504 = phi_2169_;
                        if _e1501 {
                            phi_2179_ = 0i;
                        } else {
                            phi_2179_ = select(_e1500, 31i, (_e1500 > 31i));
                        }
                        let _e1508 = phi_2179_;
                        let _e1513 = (_e1508 & 31i);
                        let _e1523 = (bitcast<i32>(_e1487) >> bitcast<u32>(31i));
                        let _e1533 = bitcast<u32>(-(_e1310.member_1.y));
                        let _e1536 = ((_e1533 >> bitcast<u32>(23i)) & 255u);
                        let _e1538 = select(0u, 1u, (_e1536 != 0u));
                        let _e1542 = ((_e1533 & 8388607u) | (_e1538 << bitcast<u32>(23i)));
                        let _e1545 = (bitcast<i32>(_e1536) - bitcast<i32>(_e1538));
                        let _e1546 = (125i - _e1545);
                        let _e1547 = (_e1546 < 0i);
                        if _e1547 {
                            phi_2228_ = (_e1545 - 125i);
                        } else {
                            phi_2228_ = 0i;
                        }
                        let _e1550 = phi_2228_;
                        if _e1547 {
                            phi_2238_ = 0i;
                        } else {
                            phi_2238_ = select(_e1546, 31i, (_e1546 > 31i));
                        }
                        let _e1554 = phi_2238_;
                        let _e1559 = (_e1554 & 31i);
                        let _e1569 = (bitcast<i32>(_e1533) >> bitcast<u32>(31i));
                        let _e1579 = bitcast<u32>(-(_e1310.member_1.z));
                        let _e1582 = ((_e1579 >> bitcast<u32>(23i)) & 255u);
                        let _e1584 = select(0u, 1u, (_e1582 != 0u));
                        let _e1588 = ((_e1579 & 8388607u) | (_e1584 << bitcast<u32>(23i)));
                        let _e1591 = (bitcast<i32>(_e1582) - bitcast<i32>(_e1584));
                        let _e1592 = (125i - _e1591);
                        let _e1593 = (_e1592 < 0i);
                        if _e1593 {
                            phi_2287_ = (_e1591 - 125i);
                        } else {
                            phi_2287_ = 0i;
                        }
                        let _e1596 = phi_2287_;
                        if _e1593 {
                            phi_2297_ = 0i;
                        } else {
                            phi_2297_ = select(_e1592, 31i, (_e1592 > 31i));
                        }
                        let _e1600 = phi_2297_;
                        let _e1605 = (_e1600 & 31i);
                        let _e1615 = (bitcast<i32>(_e1579) >> bitcast<u32>(31i));
                        local_15 = array<i32, 3>((((bitcast<i32>(((_e1363 << bitcast<u32>((bitcast<u32>(_e1371) & 31u))) >> bitcast<u32>(_e1380))) + select(0i, 1i, (((_e1363 & ((1u << bitcast<u32>(_e1380)) - 1u)) != 0u) && (_e1390 != 0i)))) ^ _e1390) - _e1390), (((bitcast<i32>(((_e1407 << bitcast<u32>((bitcast<u32>(_e1415) & 31u))) >> bitcast<u32>(_e1424))) + select(0i, 1i, (((_e1407 & ((1u << bitcast<u32>(_e1424)) - 1u)) != 0u) && (_e1434 != 0i)))) ^ _e1434) - _e1434), (((bitcast<i32>(((_e1451 << bitcast<u32>((bitcast<u32>(_e1459) & 31u))) >> bitcast<u32>(_e1468))) + select(0i, 1i, (((_e1451 & ((1u << bitcast<u32>(_e1468)) - 1u)) != 0u) && (_e1478 != 0i)))) ^ _e1478) - _e1478));
                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e1496 << bitcast<u32>((bitcast<u32>(_e1504) & 31u))) >> bitcast<u32>(_e1513))) + select(0i, 1i, (((_e1496 & ((1u << bitcast<u32>(_e1513)) - 1u)) != 0u) && (_e1523 != 0i)))) ^ _e1523) - _e1523)), -((((bitcast<i32>(((_e1542 << bitcast<u32>((bitcast<u32>(_e1550) & 31u))) >> bitcast<u32>(_e1559))) + select(0i, 1i, (((_e1542 & ((1u << bitcast<u32>(_e1559)) - 1u)) != 0u) && (_e1569 != 0i)))) ^ _e1569) - _e1569)), -((((bitcast<i32>(((_e1588 << bitcast<u32>((bitcast<u32>(_e1596) & 31u))) >> bitcast<u32>(_e1605))) + select(0i, 1i, (((_e1588 & ((1u << bitcast<u32>(_e1605)) - 1u)) != 0u) && (_e1615 != 0i)))) ^ _e1615) - _e1615)));
                        let _e1638 = bitcast<u32>(_e1341.member.x);
                        let _e1641 = ((_e1638 >> bitcast<u32>(23i)) & 255u);
                        let _e1643 = select(0u, 1u, (_e1641 != 0u));
                        let _e1647 = ((_e1638 & 8388607u) | (_e1643 << bitcast<u32>(23i)));
                        let _e1650 = (bitcast<i32>(_e1641) - bitcast<i32>(_e1643));
                        let _e1651 = (125i - _e1650);
                        let _e1652 = (_e1651 < 0i);
                        if _e1652 {
                            phi_2364_ = (_e1650 - 125i);
                        } else {
                            phi_2364_ = 0i;
                        }
                        let _e1655 = phi_2364_;
                        if _e1652 {
                            phi_2374_ = 0i;
                        } else {
                            phi_2374_ = select(_e1651, 31i, (_e1651 > 31i));
                        }
                        let _e1659 = phi_2374_;
                        let _e1664 = (_e1659 & 31i);
                        let _e1674 = (bitcast<i32>(_e1638) >> bitcast<u32>(31i));
                        let _e1682 = bitcast<u32>(_e1341.member.y);
                        let _e1685 = ((_e1682 >> bitcast<u32>(23i)) & 255u);
                        let _e1687 = select(0u, 1u, (_e1685 != 0u));
                        let _e1691 = ((_e1682 & 8388607u) | (_e1687 << bitcast<u32>(23i)));
                        let _e1694 = (bitcast<i32>(_e1685) - bitcast<i32>(_e1687));
                        let _e1695 = (125i - _e1694);
                        let _e1696 = (_e1695 < 0i);
                        if _e1696 {
                            phi_2421_ = (_e1694 - 125i);
                        } else {
                            phi_2421_ = 0i;
                        }
                        let _e1699 = phi_2421_;
                        if _e1696 {
                            phi_2431_ = 0i;
                        } else {
                            phi_2431_ = select(_e1695, 31i, (_e1695 > 31i));
                        }
                        let _e1703 = phi_2431_;
                        let _e1708 = (_e1703 & 31i);
                        let _e1718 = (bitcast<i32>(_e1682) >> bitcast<u32>(31i));
                        let _e1726 = bitcast<u32>(_e1341.member.z);
                        let _e1729 = ((_e1726 >> bitcast<u32>(23i)) & 255u);
                        let _e1731 = select(0u, 1u, (_e1729 != 0u));
                        let _e1735 = ((_e1726 & 8388607u) | (_e1731 << bitcast<u32>(23i)));
                        let _e1738 = (bitcast<i32>(_e1729) - bitcast<i32>(_e1731));
                        let _e1739 = (125i - _e1738);
                        let _e1740 = (_e1739 < 0i);
                        if _e1740 {
                            phi_2478_ = (_e1738 - 125i);
                        } else {
                            phi_2478_ = 0i;
                        }
                        let _e1743 = phi_2478_;
                        if _e1740 {
                            phi_2488_ = 0i;
                        } else {
                            phi_2488_ = select(_e1739, 31i, (_e1739 > 31i));
                        }
                        let _e1747 = phi_2488_;
                        let _e1752 = (_e1747 & 31i);
                        let _e1762 = (bitcast<i32>(_e1726) >> bitcast<u32>(31i));
                        let _e1771 = bitcast<u32>(-(_e1341.member_1.x));
                        let _e1774 = ((_e1771 >> bitcast<u32>(23i)) & 255u);
                        let _e1776 = select(0u, 1u, (_e1774 != 0u));
                        let _e1780 = ((_e1771 & 8388607u) | (_e1776 << bitcast<u32>(23i)));
                        let _e1783 = (bitcast<i32>(_e1774) - bitcast<i32>(_e1776));
                        let _e1784 = (125i - _e1783);
                        let _e1785 = (_e1784 < 0i);
                        if _e1785 {
                            phi_2537_ = (_e1783 - 125i);
                        } else {
                            phi_2537_ = 0i;
                        }
                        let _e1788 = phi_2537_;
                        if _e1785 {
                            phi_2547_ = 0i;
                        } else {
                            phi_2547_ = select(_e1784, 31i, (_e1784 > 31i));
                        }
                        let _e1792 = phi_2547_;
                        let _e1797 = (_e1792 & 31i);
                        let _e1807 = (bitcast<i32>(_e1771) >> bitcast<u32>(31i));
                        let _e1817 = bitcast<u32>(-(_e1341.member_1.y));
                        let _e1820 = ((_e1817 >> bitcast<u32>(23i)) & 255u);
                        let _e1822 = select(0u, 1u, (_e1820 != 0u));
                        let _e1826 = ((_e1817 & 8388607u) | (_e1822 << bitcast<u32>(23i)));
                        let _e1829 = (bitcast<i32>(_e1820) - bitcast<i32>(_e1822));
                        let _e1830 = (125i - _e1829);
                        let _e1831 = (_e1830 < 0i);
                        if _e1831 {
                            phi_2596_ = (_e1829 - 125i);
                        } else {
                            phi_2596_ = 0i;
                        }
                        let _e1834 = phi_2596_;
                        if _e1831 {
                            phi_2606_ = 0i;
                        } else {
                            phi_2606_ = select(_e1830, 31i, (_e1830 > 31i));
                        }
                        let _e1838 = phi_2606_;
                        let _e1843 = (_e1838 & 31i);
                        let _e1853 = (bitcast<i32>(_e1817) >> bitcast<u32>(31i));
                        let _e1863 = bitcast<u32>(-(_e1341.member_1.z));
                        let _e1866 = ((_e1863 >> bitcast<u32>(23i)) & 255u);
                        let _e1868 = select(0u, 1u, (_e1866 != 0u));
                        let _e1872 = ((_e1863 & 8388607u) | (_e1868 << bitcast<u32>(23i)));
                        let _e1875 = (bitcast<i32>(_e1866) - bitcast<i32>(_e1868));
                        let _e1876 = (125i - _e1875);
                        let _e1877 = (_e1876 < 0i);
                        if _e1877 {
                            phi_2655_ = (_e1875 - 125i);
                        } else {
                            phi_2655_ = 0i;
                        }
                        let _e1880 = phi_2655_;
                        if _e1877 {
                            phi_2665_ = 0i;
                        } else {
                            phi_2665_ = select(_e1876, 31i, (_e1876 > 31i));
                        }
                        let _e1884 = phi_2665_;
                        let _e1889 = (_e1884 & 31i);
                        let _e1899 = (bitcast<i32>(_e1863) >> bitcast<u32>(31i));
                        local_13 = array<i32, 3>((((bitcast<i32>(((_e1647 << bitcast<u32>((bitcast<u32>(_e1655) & 31u))) >> bitcast<u32>(_e1664))) + select(0i, 1i, (((_e1647 & ((1u << bitcast<u32>(_e1664)) - 1u)) != 0u) && (_e1674 != 0i)))) ^ _e1674) - _e1674), (((bitcast<i32>(((_e1691 << bitcast<u32>((bitcast<u32>(_e1699) & 31u))) >> bitcast<u32>(_e1708))) + select(0i, 1i, (((_e1691 & ((1u << bitcast<u32>(_e1708)) - 1u)) != 0u) && (_e1718 != 0i)))) ^ _e1718) - _e1718), (((bitcast<i32>(((_e1735 << bitcast<u32>((bitcast<u32>(_e1743) & 31u))) >> bitcast<u32>(_e1752))) + select(0i, 1i, (((_e1735 & ((1u << bitcast<u32>(_e1752)) - 1u)) != 0u) && (_e1762 != 0i)))) ^ _e1762) - _e1762));
                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e1780 << bitcast<u32>((bitcast<u32>(_e1788) & 31u))) >> bitcast<u32>(_e1797))) + select(0i, 1i, (((_e1780 & ((1u << bitcast<u32>(_e1797)) - 1u)) != 0u) && (_e1807 != 0i)))) ^ _e1807) - _e1807)), -((((bitcast<i32>(((_e1826 << bitcast<u32>((bitcast<u32>(_e1834) & 31u))) >> bitcast<u32>(_e1843))) + select(0i, 1i, (((_e1826 & ((1u << bitcast<u32>(_e1843)) - 1u)) != 0u) && (_e1853 != 0i)))) ^ _e1853) - _e1853)), -((((bitcast<i32>(((_e1872 << bitcast<u32>((bitcast<u32>(_e1880) & 31u))) >> bitcast<u32>(_e1889))) + select(0i, 1i, (((_e1872 & ((1u << bitcast<u32>(_e1889)) - 1u)) != 0u) && (_e1899 != 0i)))) ^ _e1899) - _e1899)));
                        local_17 = array<u32, 4>(0u, 0u, 0u, 0u);
                        phi_2709_ = type_4(0u, 3u);
                        loop {
                            let _e1911 = phi_2709_;
                            if (_e1911.member < _e1911.member_1) {
                                phi_2710_ = type_4((_e1911.member + 1u), _e1911.member_1);
                                phi_2733_ = type_4(1u, _e1911.member);
                            } else {
                                phi_2710_ = _e1911;
                                phi_2733_ = type_4(0u, type_4().member_1);
                            }
                            let _e1924 = phi_2710_;
                            let _e1926 = phi_2733_;
                            let _e1930 = (bitcast<i32>(_e1926.member) != 0i);
                            if _e1930 {
                                let _e1931 = (_e1926.member_1 < 3u);
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1933 = local_5[_e1926.member_1];
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1935 = local_4[_e1926.member_1];
                                let _e1937 = bitcast<u32>((_e1935 - _e1933));
                                let _e1942 = select((bitcast<u32>(31i) - firstLeadingBit(_e1937)), 32u, (_e1937 == 0u));
                                if ((32u - _e1942) > 10u) {
                                    phi_2768_ = (22u - _e1942);
                                } else {
                                    phi_2768_ = 0u;
                                }
                                let _e1947 = phi_2768_;
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1949 = local_15[_e1926.member_1];
                                let _e1950 = (_e1949 - _e1933);
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1952 = local_13[_e1926.member_1];
                                let _e1953 = (_e1952 - _e1933);
                                let _e1954 = (_e1950 > _e1953);
                                let _e1957 = (_e1947 & 31u);
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1966 = local_14[_e1926.member_1];
                                let _e1967 = (_e1935 - _e1966);
                                if _e1931 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1969 = local_12[_e1926.member_1];
                                let _e1970 = (_e1935 - _e1969);
                                let _e1971 = (_e1967 > _e1970);
                                let _e1984 = ((1u + _e1926.member_1) % 4u);
                                if (_e1984 < 4u) {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                local_17[_e1984] = ((((bitcast<u32>(select(_e1953, _e1950, _e1954)) >> bitcast<u32>(_e1957)) & 1023u) | (select(0u, 1u, _e1954) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1970, _e1967, _e1971)) >> bitcast<u32>(_e1957)) & 1023u) | (select(0u, 1u, _e1971) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                            }
                            continue;
                            continuing {
                                phi_2709_ = _e1924;
                                phi_3699_ = _e1277;
                                break if !(_e1930);
                            }
                        }
                        let _e1990 = phi_3699_;
                        if _e1990 {
                            break;
                        }
                        phi_2907_ = type_4(0u, 3u);
                        loop {
                            let _e1992 = phi_2907_;
                            if (_e1992.member < _e1992.member_1) {
                                phi_2908_ = type_4((_e1992.member + 1u), _e1992.member_1);
                                phi_2931_ = type_4(1u, _e1992.member);
                            } else {
                                phi_2908_ = _e1992;
                                phi_2931_ = type_4(0u, type_4().member_1);
                            }
                            let _e2005 = phi_2908_;
                            let _e2007 = phi_2931_;
                            let _e2011 = (bitcast<i32>(_e2007.member) != 0i);
                            if _e2011 {
                                if (((1u + _e2007.member_1) % 4u) < 4u) {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if (((_e2007.member_1 + 1u) % 4u) < 4u) {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                let _e2018 = (_e2007.member_1 < 3u);
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2018 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2907_ = _e2005;
                                phi_3751_ = _e1990;
                                break if !(_e2011);
                            }
                        }
                        let _e2021 = phi_3751_;
                        if _e2021 {
                            break;
                        }
                        let _e2022 = local_17;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        let _e2024 = ((_e1283 & 2147483648u) != 0u);
                        if _e2024 {
                            let _e2028 = (((_e1283 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e2028 {
                                phi_3139_ = (_e1283 & 268435455u);
                            } else {
                                phi_3139_ = u32();
                            }
                            let _e2031 = phi_3139_;
                            phi_3141_ = _e2031;
                            phi_3142_ = select(true, false, _e2028);
                        } else {
                            phi_3141_ = u32();
                            phi_3142_ = true;
                        }
                        let _e2034 = phi_3141_;
                        let _e2036 = phi_3142_;
                        if _e2036 {
                            if ((_e1314 & 2147483648u) != 0u) {
                                let _e2042 = (((_e1314 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e2042 {
                                    phi_3158_ = (_e1314 & 268435455u);
                                } else {
                                    phi_3158_ = u32();
                                }
                                let _e2045 = phi_3158_;
                                phi_3160_ = _e2045;
                                phi_3161_ = select(true, false, _e2042);
                            } else {
                                phi_3160_ = u32();
                                phi_3161_ = true;
                            }
                            let _e2048 = phi_3160_;
                            let _e2050 = phi_3161_;
                            phi_3166_ = select(_e2048, 0u, _e2050);
                        } else {
                            phi_3166_ = _e2034;
                        }
                        let _e2053 = phi_3166_;
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e80 {
                        } else {
                            break;
                        }
                        if _e2024 {
                            phi_3194_ = select(_e1314, 0u, ((_e1314 & 2147483648u) != 0u));
                        } else {
                            phi_3194_ = _e1283;
                        }
                        let _e2058 = phi_3194_;
                        if _e2024 {
                            let _e2061 = ((_e1283 >> bitcast<u32>(28u)) & 7u);
                            phi_3209_ = select(_e2061, 7u, (_e2061 == 0u));
                        } else {
                            phi_3209_ = 0u;
                        }
                        let _e2065 = phi_3209_;
                        if ((_e1314 & 2147483648u) != 0u) {
                            let _e2070 = ((_e1314 >> bitcast<u32>(28u)) & 7u);
                            phi_3224_ = select(_e2070, 7u, (_e2070 == 0u));
                        } else {
                            phi_3224_ = 0u;
                        }
                        let _e2074 = phi_3224_;
                        local_16 = _e2022;
                        local_16[0u] = (((_e2058 & 268435455u) | (_e2065 << bitcast<u32>(28u))) | (_e2074 << bitcast<u32>(31i)));
                        phi_3323_ = type_4(0u, 3u);
                        loop {
                            let _e2090 = phi_3323_;
                            if (_e2090.member < _e2090.member_1) {
                                phi_3324_ = type_4((_e2090.member + 1u), _e2090.member_1);
                                phi_3347_ = type_4(1u, _e2090.member);
                            } else {
                                phi_3324_ = _e2090;
                                phi_3347_ = type_4(0u, type_4().member_1);
                            }
                            let _e2103 = phi_3324_;
                            let _e2105 = phi_3347_;
                            let _e2109 = (bitcast<i32>(_e2105.member) != 0i);
                            if _e2109 {
                                let _e2117 = ((_e2105.member_1 + 1u) % 4u);
                                if (_e2117 < 4u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                let _e2120 = local_16[_e2117];
                                local_16[_e2117] = (_e2120 | ((((_e2053 & 268435455u) | ((_e2074 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e2105.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_3323_ = _e2103;
                                phi_3761_ = _e2021;
                                break if !(_e2109);
                            }
                        }
                        let _e2124 = phi_3761_;
                        if _e2124 {
                            break;
                        }
                        let _e2125 = local_16;
                        if _e81 {
                        } else {
                            break;
                        }
                        global_3.member[_e75] = array<u32, 4>(_e2125[0], _e2125[1], _e2125[2], _e2125[3]);
                        if (_e75 == 0u) {
                            if (_e71 == 0u) {
                            } else {
                                if (0u < _e71) {
                                } else {
                                    break;
                                }
                                global_4.member[0u] = type_27(array<u32, 4>(bitcast<u32>(_e1279[0]), bitcast<u32>(_e1279[1]), bitcast<u32>(_e1279[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e1278[0]), bitcast<u32>(_e1278[1]), bitcast<u32>(_e1278[2]), 0u));
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
fn encode_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
