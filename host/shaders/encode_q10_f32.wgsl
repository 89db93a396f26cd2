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
    var phi_3594_: bool;
    var phi_1647_: type_4;
    var phi_1648_: type_4;
    var phi_1671_: type_4;
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
            let _e64 = global;
            let _e66 = arrayLength((&global_2.member));
            let _e70 = arrayLength((&global_4.member));
            let _e74 = (_e64.x + (_e64.y * 2097152u));
            let _e77 = global_1.member[0u];
            if (_e74 < _e77) {
                let _e79 = (_e74 < _e66);
                if _e79 {
                    let _e80 = (_e74 < arrayLength((&global_3.member)));
                    if _e80 {
                        let _e81 = (0u < _e66);
                        if _e81 {
                            if _e81 {
                            } else {
                                break;
                            }
                            let _e84 = global_2.member[0u];
                            phi_170_ = _e84;
                        } else {
                            phi_170_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                        }
                        let _e86 = phi_170_;
                        if (_e86.member_1 == 2147483648u) {
                            phi_188_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_188_ = type_26(vec3<f32>(_e86.member[0][0], _e86.member[1][0], _e86.member[2][0]), vec3<f32>(_e86.member[0][2], _e86.member[1][2], _e86.member[2][2]));
                        }
                        let _e105 = phi_188_;
                        if (_e86.member_2 == 2147483648u) {
                            phi_206_ = _e105;
                        } else {
                            phi_206_ = type_26(vec3<f32>(_e86.member[0][1], _e86.member[1][1], _e86.member[2][1]), vec3<f32>(_e86.member[0][3], _e86.member[1][3], _e86.member[2][3]));
                        }
                        let _e124 = phi_206_;
                        let _e153 = bitcast<u32>(select(_e124.member.x, _e105.member.x, (_e105.member.x < _e124.member.x)));
                        let _e156 = ((_e153 >> bitcast<u32>(23i)) & 255u);
                        let _e158 = select(0u, 1u, (_e156 != 0u));
                        let _e162 = ((_e153 & 8388607u) | (_e158 << bitcast<u32>(23i)));
                        let _e165 = (bitcast<i32>(_e156) - bitcast<i32>(_e158));
                        let _e166 = (125i - _e165);
                        let _e167 = (_e166 < 0i);
                        if _e167 {
                            phi_272_ = (_e165 - 125i);
                        } else {
                            phi_272_ = 0i;
                        }
                        let _e170 = phi_272_;
                        if _e167 {
                            phi_282_ = 0i;
                        } else {
                            phi_282_ = select(_e166, 31i, (_e166 > 31i));
                        }
                        let _e174 = phi_282_;
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
                            phi_329_ = (_e209 - 125i);
                        } else {
                            phi_329_ = 0i;
                        }
                        let _e214 = phi_329_;
                        if _e211 {
                            phi_339_ = 0i;
                        } else {
                            phi_339_ = select(_e210, 31i, (_e210 > 31i));
                        }
                        let _e218 = phi_339_;
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
                            phi_386_ = (_e253 - 125i);
                        } else {
                            phi_386_ = 0i;
                        }
                        let _e258 = phi_386_;
                        if _e255 {
                            phi_396_ = 0i;
                        } else {
                            phi_396_ = select(_e254, 31i, (_e254 > 31i));
                        }
                        let _e262 = phi_396_;
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
                            phi_445_ = (_e298 - 125i);
                        } else {
                            phi_445_ = 0i;
                        }
                        let _e303 = phi_445_;
                        if _e300 {
                            phi_455_ = 0i;
                        } else {
                            phi_455_ = select(_e299, 31i, (_e299 > 31i));
                        }
                        let _e307 = phi_455_;
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
                            phi_504_ = (_e344 - 125i);
                        } else {
                            phi_504_ = 0i;
                        }
                        let _e349 = phi_504_;
                        if _e346 {
                            phi_514_ = 0i;
                        } else {
                            phi_514_ = select(_e345, 31i, (_e345 > 31i));
                        }
                        let _e353 = phi_514_;
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
                            phi_563_ = (_e390 - 125i);
                        } else {
                            phi_563_ = 0i;
                        }
                        let _e395 = phi_563_;
                        if _e392 {
                            phi_573_ = 0i;
                        } else {
                            phi_573_ = select(_e391, 31i, (_e391 > 31i));
                        }
                        let _e399 = phi_573_;
                        let _e404 = (_e399 & 31i);
                        let _e414 = (bitcast<i32>(_e378) >> bitcast<u32>(31i));
                        local_7 = array<i32, 3>((((bitcast<i32>(((_e162 << bitcast<u32>((bitcast<u32>(_e170) & 31u))) >> bitcast<u32>(_e179))) + select(0i, 1i, (((_e162 & ((1u << bitcast<u32>(_e179)) - 1u)) != 0u) && (_e189 != 0i)))) ^ _e189) - _e189), (((bitcast<i32>(((_e206 << bitcast<u32>((bitcast<u32>(_e214) & 31u))) >> bitcast<u32>(_e223))) + select(0i, 1i, (((_e206 & ((1u << bitcast<u32>(_e223)) - 1u)) != 0u) && (_e233 != 0i)))) ^ _e233) - _e233), (((bitcast<i32>(((_e250 << bitcast<u32>((bitcast<u32>(_e258) & 31u))) >> bitcast<u32>(_e267))) + select(0i, 1i, (((_e250 & ((1u << bitcast<u32>(_e267)) - 1u)) != 0u) && (_e277 != 0i)))) ^ _e277) - _e277));
                        local_6 = array<i32, 3>(-((((bitcast<i32>(((_e295 << bitcast<u32>((bitcast<u32>(_e303) & 31u))) >> bitcast<u32>(_e312))) + select(0i, 1i, (((_e295 & ((1u << bitcast<u32>(_e312)) - 1u)) != 0u) && (_e322 != 0i)))) ^ _e322) - _e322)), -((((bitcast<i32>(((_e341 << bitcast<u32>((bitcast<u32>(_e349) & 31u))) >> bitcast<u32>(_e358))) + select(0i, 1i, (((_e341 & ((1u << bitcast<u32>(_e358)) - 1u)) != 0u) && (_e368 != 0i)))) ^ _e368) - _e368)), -((((bitcast<i32>(((_e387 << bitcast<u32>((bitcast<u32>(_e395) & 31u))) >> bitcast<u32>(_e404))) + select(0i, 1i, (((_e387 & ((1u << bitcast<u32>(_e404)) - 1u)) != 0u) && (_e414 != 0i)))) ^ _e414) - _e414)));
                        phi_3639_ = false;
                        phi_617_ = type_4(0u, 128u);
                        phi_620_ = 0u;
                        loop {
                            let _e426 = phi_3639_;
                            let _e428 = phi_617_;
                            let _e430 = phi_620_;
                            if (_e428.member < _e428.member_1) {
                                phi_618_ = type_4((_e428.member + 1u), _e428.member_1);
                                phi_643_ = type_4(1u, _e428.member);
                            } else {
                                phi_618_ = _e428;
                                phi_643_ = type_4(0u, type_4().member_1);
                            }
                            let _e443 = phi_618_;
                            let _e445 = phi_643_;
                            if (bitcast<i32>(_e445.member) != 0i) {
                                let _e449 = (_e430 == _e74);
                                if _e449 {
                                    phi_3696_ = _e426;
                                    phi_1894_ = u32();
                                } else {
                                    let _e450 = (_e430 < _e66);
                                    if _e450 {
                                        if _e450 {
                                        } else {
                                            phi_3694_ = true;
                                            break;
                                        }
                                        let _e453 = global_2.member[_e430];
                                        phi_665_ = _e453;
                                    } else {
                                        phi_665_ = type_21(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u, 0u, 0u);
                                    }
                                    let _e455 = phi_665_;
                                    if ((_e455.member_1 & 2147483648u) != 0u) {
                                        phi_673_ = false;
                                    } else {
                                        phi_673_ = (_e74 <= _e455.member_1);
                                    }
                                    let _e461 = phi_673_;
                                    if (_e455.member_1 == 2147483648u) {
                                        phi_691_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                    } else {
                                        phi_691_ = type_26(vec3<f32>(_e455.member[0][0], _e455.member[1][0], _e455.member[2][0]), vec3<f32>(_e455.member[0][2], _e455.member[1][2], _e455.member[2][2]));
                                    }
                                    let _e479 = phi_691_;
                                    if (_e455.member_2 == 2147483648u) {
                                        phi_709_ = _e479;
                                    } else {
                                        phi_709_ = type_26(vec3<f32>(_e455.member[0][1], _e455.member[1][1], _e455.member[2][1]), vec3<f32>(_e455.member[0][3], _e455.member[1][3], _e455.member[2][3]));
                                    }
                                    let _e498 = phi_709_;
                                    let _e511 = bitcast<u32>(_e479.member.x);
                                    let _e514 = ((_e511 >> bitcast<u32>(23i)) & 255u);
                                    let _e516 = select(0u, 1u, (_e514 != 0u));
                                    let _e520 = ((_e511 & 8388607u) | (_e516 << bitcast<u32>(23i)));
                                    let _e523 = (bitcast<i32>(_e514) - bitcast<i32>(_e516));
                                    let _e524 = (125i - _e523);
                                    let _e525 = (_e524 < 0i);
                                    if _e525 {
                                        phi_736_ = (_e523 - 125i);
                                    } else {
                                        phi_736_ = 0i;
                                    }
                                    let _e528 = phi_736_;
                                    if _e525 {
                                        phi_746_ = 0i;
                                    } else {
                                        phi_746_ = select(_e524, 31i, (_e524 > 31i));
                                    }
                                    let _e532 = phi_746_;
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
                                        phi_793_ = (_e567 - 125i);
                                    } else {
                                        phi_793_ = 0i;
                                    }
                                    let _e572 = phi_793_;
                                    if _e569 {
                                        phi_803_ = 0i;
                                    } else {
                                        phi_803_ = select(_e568, 31i, (_e568 > 31i));
                                    }
                                    let _e576 = phi_803_;
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
                                        phi_850_ = (_e611 - 125i);
                                    } else {
                                        phi_850_ = 0i;
                                    }
                                    let _e616 = phi_850_;
                                    if _e613 {
                                        phi_860_ = 0i;
                                    } else {
                                        phi_860_ = select(_e612, 31i, (_e612 > 31i));
                                    }
                                    let _e620 = phi_860_;
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
                                        phi_909_ = (_e656 - 125i);
                                    } else {
                                        phi_909_ = 0i;
                                    }
                                    let _e661 = phi_909_;
                                    if _e658 {
                                        phi_919_ = 0i;
                                    } else {
                                        phi_919_ = select(_e657, 31i, (_e657 > 31i));
                                    }
                                    let _e665 = phi_919_;
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
                                        phi_968_ = (_e702 - 125i);
                                    } else {
                                        phi_968_ = 0i;
                                    }
                                    let _e707 = phi_968_;
                                    if _e704 {
                                        phi_978_ = 0i;
                                    } else {
                                        phi_978_ = select(_e703, 31i, (_e703 > 31i));
                                    }
                                    let _e711 = phi_978_;
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
                                        phi_1027_ = (_e748 - 125i);
                                    } else {
                                        phi_1027_ = 0i;
                                    }
                                    let _e753 = phi_1027_;
                                    if _e750 {
                                        phi_1037_ = 0i;
                                    } else {
                                        phi_1037_ = select(_e749, 31i, (_e749 > 31i));
                                    }
                                    let _e757 = phi_1037_;
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
                                        phi_1104_ = (_e807 - 125i);
                                    } else {
                                        phi_1104_ = 0i;
                                    }
                                    let _e812 = phi_1104_;
                                    if _e809 {
                                        phi_1114_ = 0i;
                                    } else {
                                        phi_1114_ = select(_e808, 31i, (_e808 > 31i));
                                    }
                                    let _e816 = phi_1114_;
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
                                        phi_1161_ = (_e851 - 125i);
                                    } else {
                                        phi_1161_ = 0i;
                                    }
                                    let _e856 = phi_1161_;
                                    if _e853 {
                                        phi_1171_ = 0i;
                                    } else {
                                        phi_1171_ = select(_e852, 31i, (_e852 > 31i));
                                    }
                                    let _e860 = phi_1171_;
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
                                        phi_1218_ = (_e895 - 125i);
                                    } else {
                                        phi_1218_ = 0i;
                                    }
                                    let _e900 = phi_1218_;
                                    if _e897 {
                                        phi_1228_ = 0i;
                                    } else {
                                        phi_1228_ = select(_e896, 31i, (_e896 > 31i));
                                    }
                                    let _e904 = phi_1228_;
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
                                        phi_1277_ = (_e940 - 125i);
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
                                    let _e964 = (bitcast<i32>(_e928) >> bitcast<u32>(31i));
                                    let _e974 = bitcast<u32>(-(_e498.member_1.y));
                                    let _e977 = ((_e974 >> bitcast<u32>(23i)) & 255u);
                                    let _e979 = select(0u, 1u, (_e977 != 0u));
                                    let _e983 = ((_e974 & 8388607u) | (_e979 << bitcast<u32>(23i)));
                                    let _e986 = (bitcast<i32>(_e977) - bitcast<i32>(_e979));
                                    let _e987 = (125i - _e986);
                                    let _e988 = (_e987 < 0i);
                                    if _e988 {
                                        phi_1336_ = (_e986 - 125i);
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
                                    let _e1010 = (bitcast<i32>(_e974) >> bitcast<u32>(31i));
                                    let _e1020 = bitcast<u32>(-(_e498.member_1.z));
                                    let _e1023 = ((_e1020 >> bitcast<u32>(23i)) & 255u);
                                    let _e1025 = select(0u, 1u, (_e1023 != 0u));
                                    let _e1029 = ((_e1020 & 8388607u) | (_e1025 << bitcast<u32>(23i)));
                                    let _e1032 = (bitcast<i32>(_e1023) - bitcast<i32>(_e1025));
                                    let _e1033 = (125i - _e1032);
                                    let _e1034 = (_e1033 < 0i);
                                    if _e1034 {
                                        phi_1395_ = (_e1032 - 125i);
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
                                    let _e1056 = (bitcast<i32>(_e1020) >> bitcast<u32>(31i));
                                    local_9 = array<i32, 3>((((bitcast<i32>(((_e804 << bitcast<u32>((bitcast<u32>(_e812) & 31u))) >> bitcast<u32>(_e821))) + select(0i, 1i, (((_e804 & ((1u << bitcast<u32>(_e821)) - 1u)) != 0u) && (_e831 != 0i)))) ^ _e831) - _e831), (((bitcast<i32>(((_e848 << bitcast<u32>((bitcast<u32>(_e856) & 31u))) >> bitcast<u32>(_e865))) + select(0i, 1i, (((_e848 & ((1u << bitcast<u32>(_e865)) - 1u)) != 0u) && (_e875 != 0i)))) ^ _e875) - _e875), (((bitcast<i32>(((_e892 << bitcast<u32>((bitcast<u32>(_e900) & 31u))) >> bitcast<u32>(_e909))) + select(0i, 1i, (((_e892 & ((1u << bitcast<u32>(_e909)) - 1u)) != 0u) && (_e919 != 0i)))) ^ _e919) - _e919));
                                    local_8 = array<i32, 3>(-((((bitcast<i32>(((_e937 << bitcast<u32>((bitcast<u32>(_e945) & 31u))) >> bitcast<u32>(_e954))) + select(0i, 1i, (((_e937 & ((1u << bitcast<u32>(_e954)) - 1u)) != 0u) && (_e964 != 0i)))) ^ _e964) - _e964)), -((((bitcast<i32>(((_e983 << bitcast<u32>((bitcast<u32>(_e991) & 31u))) >> bitcast<u32>(_e1000))) + select(0i, 1i, (((_e983 & ((1u << bitcast<u32>(_e1000)) - 1u)) != 0u) && (_e1010 != 0i)))) ^ _e1010) - _e1010)), -((((bitcast<i32>(((_e1029 << bitcast<u32>((bitcast<u32>(_e1037) & 31u))) >> bitcast<u32>(_e1046))) + select(0i, 1i, (((_e1029 & ((1u << bitcast<u32>(_e1046)) - 1u)) != 0u) && (_e1056 != 0i)))) ^ _e1056) - _e1056)));
                                    local_18 = array<u32, 4>(0u, 0u, 0u, 0u);
                                    phi_1449_ = type_4(0u, 3u);
                                    loop {
                                        let _e1068 = phi_1449_;
                                        if (_e1068.member < _e1068.member_1) {
                                            phi_1450_ = type_4((_e1068.member + 1u), _e1068.member_1);
                                            phi_1473_ = type_4(1u, _e1068.member);
                                        } else {
                                            phi_1450_ = _e1068;
                                            phi_1473_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1081 = phi_1450_;
                                        let _e1083 = phi_1473_;
                                        let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                        if _e1087 {
                                            let _e1088 = (_e1083.member_1 < 3u);
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1090 = local_7[_e1083.member_1];
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1092 = local_6[_e1083.member_1];
                                            let _e1094 = bitcast<u32>((_e1092 - _e1090));
                                            let _e1100 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1094)), 32u, (_e1094 == 0u)));
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1105 = local_11[_e1083.member_1];
                                            let _e1106 = (_e1105 - _e1090);
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1108 = local_9[_e1083.member_1];
                                            let _e1109 = (_e1108 - _e1090);
                                            let _e1110 = (_e1106 > _e1109);
                                            let _e1113 = ((select(10u, _e1100, (_e1100 > 10u)) - 10u) & 31u);
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1122 = local_10[_e1083.member_1];
                                            let _e1123 = (_e1092 - _e1122);
                                            if _e1088 {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            let _e1125 = local_8[_e1083.member_1];
                                            let _e1126 = (_e1092 - _e1125);
                                            let _e1127 = (_e1123 > _e1126);
                                            let _e1140 = ((1u + _e1083.member_1) % 4u);
                                            if (_e1140 < 4u) {
                                            } else {
                                                phi_3594_ = true;
                                                break;
                                            }
                                            local_18[_e1140] = ((((bitcast<u32>(select(_e1109, _e1106, _e1110)) >> bitcast<u32>(_e1113)) & 1023u) | (select(0u, 1u, _e1110) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1126, _e1123, _e1127)) >> bitcast<u32>(_e1113)) & 1023u) | (select(0u, 1u, _e1127) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                                        }
                                        continue;
                                        continuing {
                                            phi_1449_ = _e1081;
                                            phi_3594_ = _e426;
                                            break if !(_e1087);
                                        }
                                    }
                                    let _e1146 = phi_3594_;
                                    phi_3694_ = _e1146;
                                    if _e1146 {
                                        break;
                                    }
                                    local_3 = array<i32, 3>(0i, 0i, 0i);
                                    local_2 = array<i32, 3>(0i, 0i, 0i);
                                    local_1 = array<i32, 3>(0i, 0i, 0i);
                                    local = array<i32, 3>(0i, 0i, 0i);
                                    phi_1647_ = type_4(0u, 3u);
                                    loop {
                                        let _e1148 = phi_1647_;
                                        if (_e1148.member < _e1148.member_1) {
                                            phi_1648_ = type_4((_e1148.member + 1u), _e1148.member_1);
                                            phi_1671_ = type_4(1u, _e1148.member);
                                        } else {
                                            phi_1648_ = _e1148;
                                            phi_1671_ = type_4(0u, type_4().member_1);
                                        }
                                        let _e1161 = phi_1648_;
                                        let _e1163 = phi_1671_;
                                        let _e1167 = (bitcast<i32>(_e1163.member) != 0i);
                                        if _e1167 {
                                            let _e1169 = ((1u + _e1163.member_1) % 4u);
                                            if (_e1169 < 4u) {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1172 = local_18[_e1169];
                                            let _e1174 = ((_e1163.member_1 + 1u) % 4u);
                                            if (_e1174 < 4u) {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1177 = local_18[_e1174];
                                            let _e1178 = (_e1163.member_1 < 3u);
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1180 = local_7[_e1163.member_1];
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            let _e1182 = local_6[_e1163.member_1];
                                            let _e1184 = (_e1177 >> bitcast<u32>(11u));
                                            let _e1186 = bitcast<u32>((_e1182 - _e1180));
                                            let _e1192 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1186)), 32u, (_e1186 == 0u)));
                                            let _e1197 = ((select(10u, _e1192, (_e1192 > 10u)) - 10u) & 31u);
                                            let _e1201 = (_e1180 + bitcast<i32>(((_e1172 & 1023u) << bitcast<u32>(_e1197))));
                                            let _e1206 = (_e1182 - bitcast<i32>(((_e1184 & 1023u) << bitcast<u32>(_e1197))));
                                            let _e1210 = (((_e1172 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            let _e1214 = (((_e1184 >> bitcast<u32>(10u)) & 1u) == 1u);
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_3[_e1163.member_1] = select(_e1180, _e1201, _e1210);
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_1[_e1163.member_1] = select(_e1201, _e1180, _e1210);
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local_2[_e1163.member_1] = select(_e1182, _e1206, _e1214);
                                            if _e1178 {
                                            } else {
                                                phi_3677_ = true;
                                                break;
                                            }
                                            local[_e1163.member_1] = select(_e1206, _e1182, _e1214);
                                        }
                                        continue;
                                        continuing {
                                            phi_1647_ = _e1161;
                                            phi_3677_ = _e1146;
                                            break if !(_e1167);
                                        }
                                    }
                                    let _e1225 = phi_3677_;
                                    phi_3694_ = _e1225;
                                    if _e1225 {
                                        break;
                                    }
                                    let _e1226 = local;
                                    let _e1227 = local_1;
                                    let _e1228 = local_2;
                                    let _e1229 = local_3;
                                    if _e461 {
                                        phi_1876_ = type_33(array<i32, 3>(_e1229[0], _e1229[1], _e1229[2]), array<i32, 3>(_e1228[0], _e1228[1], _e1228[2]));
                                    } else {
                                        phi_1876_ = type_33(array<i32, 3>(_e1227[0], _e1227[1], _e1227[2]), array<i32, 3>(_e1226[0], _e1226[1], _e1226[2]));
                                    }
                                    let _e1249 = phi_1876_;
                                    local_7 = array<i32, 3>(_e1249.member[0], _e1249.member[1], _e1249.member[2]);
                                    local_6 = array<i32, 3>(_e1249.member_1[0], _e1249.member_1[1], _e1249.member_1[2]);
                                    phi_3696_ = _e1225;
                                    phi_1894_ = select(_e455.member_2, _e455.member_1, _e461);
                                }
                                let _e1262 = phi_3696_;
                                let _e1264 = phi_1894_;
                                phi_3695_ = _e1262;
                                phi_621_ = _e1264;
                                phi_1896_ = select(true, false, _e449);
                            } else {
                                phi_3695_ = _e426;
                                phi_621_ = u32();
                                phi_1896_ = false;
                            }
                            let _e1267 = phi_3695_;
                            let _e1269 = phi_621_;
                            let _e1271 = phi_1896_;
                            continue;
                            continuing {
                                phi_3639_ = _e1267;
                                phi_617_ = _e443;
                                phi_620_ = _e1269;
                                phi_3694_ = _e1267;
                                break if !(_e1271);
                            }
                        }
                        let _e1274 = phi_3694_;
                        if _e1274 {
                            break;
                        }
                        let _e1275 = local_6;
                        let _e1276 = local_7;
                        local_5 = _e1276;
                        local_4 = _e1275;
                        if _e79 {
                        } else {
                            break;
                        }
                        let _e1280 = global_2.member[_e74].member_1;
                        if (_e1280 == 2147483648u) {
                            phi_1947_ = type_26(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            let _e1286 = global_2.member[_e74].member[0u];
                            let _e1291 = global_2.member[_e74].member[1u];
                            let _e1296 = global_2.member[_e74].member[2u];
                            phi_1947_ = type_26(vec3<f32>(_e1286[0], _e1291[0], _e1296[0]), vec3<f32>(_e1286[2], _e1291[2], _e1296[2]));
                        }
                        let _e1307 = phi_1947_;
                        let _e1311 = global_2.member[_e74].member_2;
                        if (_e1311 == 2147483648u) {
                            phi_1969_ = _e1307;
                        } else {
                            let _e1317 = global_2.member[_e74].member[0u];
                            let _e1322 = global_2.member[_e74].member[1u];
                            let _e1327 = global_2.member[_e74].member[2u];
                            phi_1969_ = type_26(vec3<f32>(_e1317[1], _e1322[1], _e1327[1]), vec3<f32>(_e1317[3], _e1322[3], _e1327[3]));
                        }
                        let _e1338 = phi_1969_;
                        let _e1351 = bitcast<u32>(_e1307.member.x);
                        let _e1354 = ((_e1351 >> bitcast<u32>(23i)) & 255u);
                        let _e1356 = select(0u, 1u, (_e1354 != 0u));
                        let _e1360 = ((_e1351 & 8388607u) | (_e1356 << bitcast<u32>(23i)));
                        let _e1363 = (bitcast<i32>(_e1354) - bitcast<i32>(_e1356));
                        let _e1364 = (125i - _e1363);
                        let _e1365 = (_e1364 < 0i);
                        if _e1365 {
                            phi_1996_ = (_e1363 - 125i);
                        } else {
                            phi_1996_ = 0i;
                        }
                        let _e1368 = phi_1996_;
                        if _e1365 {
                            phi_2006_ = 0i;
                        } else {
                            phi_2006_ = select(_e1364, 31i, (_e1364 > 31i));
                        }
                        let _e1372 = phi_2006_;
                        let _e1377 = (_e1372 & 31i);
                        let _e1387 = (bitcast<i32>(_e1351) >> bitcast<u32>(31i));
                        let _e1395 = bitcast<u32>(_e1307.member.y);
                        let _e1398 = ((_e1395 >> bitcast<u32>(23i)) & 255u);
                        let _e1400 = select(0u, 1u, (_e1398 != 0u));
                        let _e1404 = ((_e1395 & 8388607u) | (_e1400 << bitcast<u32>(23i)));
                        let _e1407 = (bitcast<i32>(_e1398) - bitcast<i32>(_e1400));
                        let _e1408 = (125i - _e1407);
                        let _e1409 = (_e1408 < 0i);
                        if _e1409 {
                            phi_2053_ = (_e1407 - 125i);
                        } else {
                            phi_2053_ = 0i;
                        }
                        let _e1412 = phi_2053_;
                        if _e1409 {
                            phi_2063_ = 0i;
                        } else {
                            phi_2063_ = select(_e1408, 31i, (_e1408 > 31i));
                        }
                        let _e1416 = phi_2063_;
                        let _e1421 = (_e1416 & 31i);
                        let _e1431 = (bitcast<i32>(_e1395) >> bitcast<u32>(31i));
                        let _e1439 = bitcast<u32>(_e1307.member.z);
                        let _e1442 = ((_e1439 >> bitcast<u32>(23i)) & 255u);
                        let _e1444 = select(0u, 1u, (_e1442 != 0u));
                        let _e1448 = ((_e1439 & 8388607u) | (_e1444 << bitcast<u32>(23i)));
                        let _e1451 = (bitcast<i32>(_e1442) - bitcast<i32>(_e1444));
                        let _e1452 = (125i - _e1451);
                        let _e1453 = (_e1452 < 0i);
                        if _e1453 {
                            phi_2110_ = (_e1451 - 125i);
                        } else {
                            phi_2110_ = 0i;
                        }
                        let _e1456 = phi_2110_;
                        if _e1453 {
                            phi_2120_ = 0i;
                        } else {
                            phi_2120_ = select(_e1452, 31i, (_e1452 > 31i));
                        }
                        let _e1460 = phi_2120_;
                        let _e1465 = (_e1460 & 31i);
                        let _e1475 = (bitcast<i32>(_e1439) >> bitcast<u32>(31i));
                        let _e1484 = bitcast<u32>(-(_e1307.member_1.x));
                        let _e1487 = ((_e1484 >> bitcast<u32>(23i)) & 255u);
                        let _e1489 = select(0u, 1u, (_e1487 != 0u));
                        let _e1493 = ((_e1484 & 8388607u) | (_e1489 << bitcast<u32>(23i)));
                        let _e1496 = (bitcast<i32>(_e1487) - bitcast<i32>(_e1489));
                        let _e1497 = (125i - _e1496);
                        let _e1498 = (_e1497 < 0i);
                        if _e1498 {
                            phi_2169_ = (_e1496 - 125i);
                        } else {
                            phi_2169_ = 0i;
                        }
                        let _e1501 = phi_2169_;
                        if _e1498 {
                            phi_2179_ = 0i;
                        } else {
                            phi_2179_ = select(_e1497, 31i, (_e1497 > 31i));
                        }
                        let _e1505 = phi_2179_;
                        let _e1510 = (_e1505 & 31i);
                        let _e1520 = (bitcast<i32>(_e1484) >> bitcast<u32>(31i));
                        let _e1530 = bitcast<u32>(-(_e1307.member_1.y));
                        let _e1533 = ((_e1530 >> bitcast<u32>(23i)) & 255u);
                        let _e1535 = select(0u, 1u, (_e1533 != 0u));
                        let _e1539 = ((_e1530 & 8388607u) | (_e1535 << bitcast<u32>(23i)));
                        let _e1542 = (bitcast<i32>(_e1533) - bitcast<i32>(_e1535));
                        let _e1543 = (125i - _e1542);
                        let _e1544 = (_e1543 < 0i);
                        if _e1544 {
                            phi_2228_ = (_e1542 - 125i);
                        } else {
                            phi_2228_ = 0i;
                        }
                        let _e1547 = phi_2228_;
                        if _e1544 {
                            phi_2238_ = 0i;
                        } else {
                            phi_2238_ = select(_e1543, 31i, (_e1543 > 31i));
                        }
                        let _e1551 = phi_2238_;
                        let _e1556 = (_e1551 & 31i);
                        let _e1566 = (bitcast<i32>(_e1530) >> bitcast<u32>(31i));
                        let _e1576 = bitcast<u32>(-(_e1307.member_1.z));
                        let _e1579 = ((_e1576 >> bitcast<u32>(23i)) & 255u);
                        let _e1581 = select(0u, 1u, (_e1579 != 0u));
                        let _e1585 = ((_e1576 & 8388607u) | (_e1581 << bitcast<u32>(23i)));
                        let _e1588 = (bitcast<i32>(_e1579) - bitcast<i32>(_e1581));
                        let _e1589 = (125i - _e1588);
                        let _e1590 = (_e1589 < 0i);
                        if _e1590 {
                            phi_2287_ = (_e1588 - 125i);
                        } else {
                            phi_2287_ = 0i;
                        }
                        let _e1593 = phi_2287_;
                        if _e1590 {
                            phi_2297_ = 0i;
                        } else {
                            phi_2297_ = select(_e1589, 31i, (_e1589 > 31i));
                        }
                        let _e1597 = phi_2297_;
                        let _e1602 = (_e1597 & 31i);
                        let _e1612 = (bitcast<i32>(_e1576) >> bitcast<u32>(31i));
                        local_15 = array<i32, 3>((((bitcast<i32>(((_e1360 << bitcast<u32>((bitcast<u32>(_e1368) & 31u))) >> bitcast<u32>(_e1377))) + select(0i, 1i, (((_e1360 & ((1u << bitcast<u32>(_e1377)) - 1u)) != 0u) && (_e1387 != 0i)))) ^ _e1387) - _e1387), (((bitcast<i32>(((_e1404 << bitcast<u32>((bitcast<u32>(_e1412) & 31u))) >> bitcast<u32>(_e1421))) + select(0i, 1i, (((_e1404 & ((1u << bitcast<u32>(_e1421)) - 1u)) != 0u) && (_e1431 != 0i)))) ^ _e1431) - _e1431), (((bitcast<i32>(((_e1448 << bitcast<u32>((bitcast<u32>(_e1456) & 31u))) >> bitcast<u32>(_e1465))) + select(0i, 1i, (((_e1448 & ((1u << bitcast<u32>(_e1465)) - 1u)) != 0u) && (_e1475 != 0i)))) ^ _e1475) - _e1475));
                        local_14 = array<i32, 3>(-((((bitcast<i32>(((_e1493 << bitcast<u32>((bitcast<u32>(_e1501) & 31u))) >> bitcast<u32>(_e1510))) + select(0i, 1i, (((_e1493 & ((1u << bitcast<u32>(_e1510)) - 1u)) != 0u) && (_e1520 != 0i)))) ^ _e1520) - _e1520)), -((((bitcast<i32>(((_e1539 << bitcast<u32>((bitcast<u32>(_e1547) & 31u))) >> bitcast<u32>(_e1556))) + select(0i, 1i, (((_e1539 & ((1u << bitcast<u32>(_e1556)) - 1u)) != 0u) && (_e1566 != 0i)))) ^ _e1566) - _e1566)), -((((bitcast<i32>(((_e1585 << bitcast<u32>((bitcast<u32>(_e1593) & 31u))) >> bitcast<u32>(_e1602))) + select(0i, 1i, (((_e1585 & ((1u << bitcast<u32>(_e1602)) - 1u)) != 0u) && (_e1612 != 0i)))) ^ _e1612) - _e1612)));
                        let _e1635 = bitcast<u32>(_e1338.member.x);
                        let _e1638 = ((_e1635 >> bitcast<u32>(23i)) & 255u);
                        let _e1640 = select(0u, 1u, (_e1638 != 0u));
                        let _e1644 = ((_e1635 & 8388607u) | (_e1640 << bitcast<u32>(23i)));
                        let _e1647 = (bitcast<i32>(_e1638) - bitcast<i32>(_e1640));
                        let _e1648 = (125i - _e1647);
                        let _e1649 = (_e1648 < 0i);
                        if _e1649 {
                            phi_2364_ = (_e1647 - 125i);
                        } else {
                            phi_2364_ = 0i;
                        }
                        let _e1652 = phi_2364_;
                        if _e1649 {
                            phi_2374_ = 0i;
                        } else {
                            phi_2374_ = select(_e1648, 31i, (_e1648 > 31i));
                        }
                        let _e1656 = phi_2374_;
                        let _e1661 = (_e1656 & 31i);
                        let _e1671 = (bitcast<i32>(_e1635) >> bitcast<u32>(31i));
                        let _e1679 = bitcast<u32>(_e1338.member.y);
                        let _e1682 = ((_e1679 >> bitcast<u32>(23i)) & 255u);
                        let _e1684 = select(0u, 1u, (_e1682 != 0u));
                        let _e1688 = ((_e1679 & 8388607u) | (_e1684 << bitcast<u32>(23i)));
                        let _e1691 = (bitcast<i32>(_e1682) - bitcast<i32>(_e1684));
                        let _e1692 = (125i - _e1691);
                        let _e1693 = (_e1692 < 0i);
                        if _e1693 {
                            phi_2421_ = (_e1691 - 125i);
                        } else {
                            phi_2421_ = 0i;
                        }
                        let _e1696 = phi_2421_;
                        if _e1693 {
                            phi_2431_ = 0i;
                        } else {
                            phi_2431_ = select(_e1692, 31i, (_e1692 > 31i));
                        }
                        let _e1700 = phi_2431_;
                        let _e1705 = (_e1700 & 31i);
                        let _e1715 = (bitcast<i32>(_e1679) >> bitcast<u32>(31i));
                        let _e1723 = bitcast<u32>(_e1338.member.z);
                        let _e1726 = ((_e1723 >> bitcast<u32>(23i)) & 255u);
                        let _e1728 = select(0u, 1u, (_e1726 != 0u));
                        let _e1732 = ((_e1723 & 8388607u) | (_e1728 << bitcast<u32>(23i)));
                        let _e1735 = (bitcast<i32>(_e1726) - bitcast<i32>(_e1728));
                        let _e1736 = (125i - _e1735);
                        let _e1737 = (_e1736 < 0i);
                        if _e1737 {
                            phi_2478_ = (_e1735 - 125i);
                        } else {
                            phi_2478_ = 0i;
                        }
                        let _e1740 = phi_2478_;
                        if _e1737 {
                            phi_2488_ = 0i;
                        } else {
                            phi_2488_ = select(_e1736, 31i, (_e1736 > 31i));
                        }
                        let _e1744 = phi_2488_;
                        let _e1749 = (_e1744 & 31i);
                        let _e1759 = (bitcast<i32>(_e1723) >> bitcast<u32>(31i));
                        let _e1768 = bitcast<u32>(-(_e1338.member_1.x));
                        let _e1771 = ((_e1768 >> bitcast<u32>(23i)) & 255u);
                        let _e1773 = select(0u, 1u, (_e1771 != 0u));
                        let _e1777 = ((_e1768 & 8388607u) | (_e1773 << bitcast<u32>(23i)));
                        let _e1780 = (bitcast<i32>(_e1771) - bitcast<i32>(_e1773));
                        let _e1781 = (125i - _e1780);
                        let _e1782 = (_e1781 < 0i);
                        if _e1782 {
                            phi_2537_ = (_e1780 - 125i);
                        } else {
                            phi_2537_ = 0i;
                        }
                        let _e1785 = phi_2537_;
                        if _e1782 {
                            phi_2547_ = 0i;
                        } else {
                            phi_2547_ = select(_e1781, 31i, (_e1781 > 31i));
                        }
                        let _e1789 = phi_2547_;
                        let _e1794 = (_e1789 & 31i);
                        let _e1804 = (bitcast<i32>(_e1768) >> bitcast<u32>(31i));
                        let _e1814 = bitcast<u32>(-(_e1338.member_1.y));
                        let _e1817 = ((_e1814 >> bitcast<u32>(23i)) & 255u);
                        let _e1819 = select(0u, 1u, (_e1817 != 0u));
                        let _e1823 = ((_e1814 & 8388607u) | (_e1819 << bitcast<u32>(23i)));
                        let _e1826 = (bitcast<i32>(_e1817) - bitcast<i32>(_e1819));
                        let _e1827 = (125i - _e1826);
                        let _e1828 = (_e1827 < 0i);
                        if _e1828 {
                            phi_2596_ = (_e1826 - 125i);
                        } else {
                            phi_2596_ = 0i;
                        }
                        let _e1831 = phi_2596_;
                        if _e1828 {
                            phi_2606_ = 0i;
                        } else {
                            phi_2606_ = select(_e1827, 31i, (_e1827 > 31i));
                        }
                        let _e1835 = phi_2606_;
                        let _e1840 = (_e1835 & 31i);
                        let _e1850 = (bitcast<i32>(_e1814) >> bitcast<u32>(31i));
                        let _e1860 = bitcast<u32>(-(_e1338.member_1.z));
                        let _e1863 = ((_e1860 >> bitcast<u32>(23i)) & 255u);
                        let _e1865 = select(0u, 1u, (_e1863 != 0u));
                        let _e1869 = ((_e1860 & 8388607u) | (_e1865 << bitcast<u32>(23i)));
                        let _e1872 = (bitcast<i32>(_e1863) - bitcast<i32>(_e1865));
                        let _e1873 = (125i - _e1872);
                        let _e1874 = (_e1873 < 0i);
                        if _e1874 {
                            phi_2655_ = (_e1872 - 125i);
                        } else {
                            phi_2655_ = 0i;
                        }
                        let _e1877 = phi_2655_;
                        if _e1874 {
                            phi_2665_ = 0i;
                        } else {
                            phi_2665_ = select(_e1873, 31i, (_e1873 > 31i));
                        }
                        let _e1881 = phi_2665_;
                        let _e1886 = (_e1881 & 31i);
                        let _e1896 = (bitcast<i32>(_e1860) >> bitcast<u32>(31i));
                        local_13 = array<i32, 3>((((bitcast<i32>(((_e1644 << bitcast<u32>((bitcast<u32>(_e1652) & 31u))) >> bitcast<u32>(_e1661))) + select(0i, 1i, (((_e1644 & ((1u << bitcast<u32>(_e1661)) - 1u)) != 0u) && (_e1671 != 0i)))) ^ _e1671) - _e1671), (((bitcast<i32>(((_e1688 << bitcast<u32>((bitcast<u32>(_e1696) & 31u))) >> bitcast<u32>(_e1705))) + select(0i, 1i, (((_e1688 & ((1u << bitcast<u32>(_e1705)) - 1u)) != 0u) && (_e1715 != 0i)))) ^ _e1715) - _e1715), (((bitcast<i32>(((_e1732 << bitcast<u32>((bitcast<u32>(_e1740) & 31u))) >> bitcast<u32>(_e1749))) + select(0i, 1i, (((_e1732 & ((1u << bitcast<u32>(_e1749)) - 1u)) != 0u) && (_e1759 != 0i)))) ^ _e1759) - _e1759));
                        local_12 = array<i32, 3>(-((((bitcast<i32>(((_e1777 << bitcast<u32>((bitcast<u32>(_e1785) & 31u))) >> bitcast<u32>(_e1794))) + select(0i, 1i, (((_e1777 & ((1u << bitcast<u32>(_e1794)) - 1u)) != 0u) && (_e1804 != 0i)))) ^ _e1804) - _e1804)), -((((bitcast<i32>(((_e1823 << bitcast<u32>((bitcast<u32>(_e1831) & 31u))) >> bitcast<u32>(_e1840))) + select(0i, 1i, (((_e1823 & ((1u << bitcast<u32>(_e1840)) - 1u)) != 0u) && (_e1850 != 0i)))) ^ _e1850) - _e1850)), -((((bitcast<i32>(((_e1869 << bitcast<u32>((bitcast<u32>(_e1877) & 31u))) >> bitcast<u32>(_e1886))) + select(0i, 1i, (((_e1869 & ((1u << bitcast<u32>(_e1886)) - 1u)) != 0u) && (_e1896 != 0i)))) ^ _e1896) - _e1896)));
                        local_17 = array<u32, 4>(0u, 0u, 0u, 0u);
                        phi_2709_ = type_4(0u, 3u);
                        loop {
                            let _e1908 = phi_2709_;
                            if (_e1908.member < _e1908.member_1) {
                                phi_2710_ = type_4((_e1908.member + 1u), _e1908.member_1);
                                phi_2733_ = type_4(1u, _e1908.member);
                            } else {
                                phi_2710_ = _e1908;
                                phi_2733_ = type_4(0u, type_4().member_1);
                            }
                            let _e1921 = phi_2710_;
                            let _e1923 = phi_2733_;
                            let _e1927 = (bitcast<i32>(_e1923.member) != 0i);
                            if _e1927 {
                                let _e1928 = (_e1923.member_1 < 3u);
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1930 = local_5[_e1923.member_1];
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1932 = local_4[_e1923.member_1];
                                let _e1934 = bitcast<u32>((_e1932 - _e1930));
                                let _e1940 = (32u - select((bitcast<u32>(31i) - firstLeadingBit(_e1934)), 32u, (_e1934 == 0u)));
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1945 = local_15[_e1923.member_1];
                                let _e1946 = (_e1945 - _e1930);
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1948 = local_13[_e1923.member_1];
                                let _e1949 = (_e1948 - _e1930);
                                let _e1950 = (_e1946 > _e1949);
                                let _e1953 = ((select(10u, _e1940, (_e1940 > 10u)) - 10u) & 31u);
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1962 = local_14[_e1923.member_1];
                                let _e1963 = (_e1932 - _e1962);
                                if _e1928 {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                let _e1965 = local_12[_e1923.member_1];
                                let _e1966 = (_e1932 - _e1965);
                                let _e1967 = (_e1963 > _e1966);
                                let _e1980 = ((1u + _e1923.member_1) % 4u);
                                if (_e1980 < 4u) {
                                } else {
                                    phi_3699_ = true;
                                    break;
                                }
                                local_17[_e1980] = ((((bitcast<u32>(select(_e1949, _e1946, _e1950)) >> bitcast<u32>(_e1953)) & 1023u) | (select(0u, 1u, _e1950) << bitcast<u32>(10u))) | ((((bitcast<u32>(select(_e1966, _e1963, _e1967)) >> bitcast<u32>(_e1953)) & 1023u) | (select(0u, 1u, _e1967) << bitcast<u32>(10u))) << bitcast<u32>(11u)));
                            }
                            continue;
                            continuing {
                                phi_2709_ = _e1921;
                                phi_3699_ = _e1274;
                                break if !(_e1927);
                            }
                        }
                        let _e1986 = phi_3699_;
                        if _e1986 {
                            break;
                        }
                        phi_2907_ = type_4(0u, 3u);
                        loop {
                            let _e1988 = phi_2907_;
                            if (_e1988.member < _e1988.member_1) {
                                phi_2908_ = type_4((_e1988.member + 1u), _e1988.member_1);
                                phi_2931_ = type_4(1u, _e1988.member);
                            } else {
                                phi_2908_ = _e1988;
                                phi_2931_ = type_4(0u, type_4().member_1);
                            }
                            let _e2001 = phi_2908_;
                            let _e2003 = phi_2931_;
                            let _e2007 = (bitcast<i32>(_e2003.member) != 0i);
                            if _e2007 {
                                if (((1u + _e2003.member_1) % 4u) < 4u) {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if (((_e2003.member_1 + 1u) % 4u) < 4u) {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                let _e2014 = (_e2003.member_1 < 3u);
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                                if _e2014 {
                                } else {
                                    phi_3751_ = true;
                                    break;
                                }
                            }
                            continue;
                            continuing {
                                phi_2907_ = _e2001;
                                phi_3751_ = _e1986;
                                break if !(_e2007);
                            }
                        }
                        let _e2017 = phi_3751_;
                        if _e2017 {
                            break;
                        }
                        let _e2018 = local_17;
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e79 {
                        } else {
                            break;
                        }
                        let _e2020 = ((_e1280 & 2147483648u) != 0u);
                        if _e2020 {
                            let _e2024 = (((_e1280 >> bitcast<u32>(28u)) & 7u) > 0u);
                            if _e2024 {
                                phi_3139_ = (_e1280 & 268435455u);
                            } else {
                                phi_3139_ = u32();
                            }
                            let _e2027 = phi_3139_;
                            phi_3141_ = _e2027;
                            phi_3142_ = select(true, false, _e2024);
                        } else {
                            phi_3141_ = u32();
                            phi_3142_ = true;
                        }
                        let _e2030 = phi_3141_;
                        let _e2032 = phi_3142_;
                        if _e2032 {
                            if ((_e1311 & 2147483648u) != 0u) {
                                let _e2038 = (((_e1311 >> bitcast<u32>(28u)) & 7u) > 0u);
                                if _e2038 {
                                    phi_3158_ = (_e1311 & 268435455u);
                                } else {
                                    phi_3158_ = u32();
                                }
                                let _e2041 = phi_3158_;
                                phi_3160_ = _e2041;
                                phi_3161_ = select(true, false, _e2038);
                            } else {
                                phi_3160_ = u32();
                                phi_3161_ = true;
                            }
                            let _e2044 = phi_3160_;
                            let _e2046 = phi_3161_;
                            phi_3166_ = select(_e2044, 0u, _e2046);
                        } else {
                            phi_3166_ = _e2030;
                        }
                        let _e2049 = phi_3166_;
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e79 {
                        } else {
                            break;
                        }
                        if _e2020 {
                            phi_3194_ = select(_e1311, 0u, ((_e1311 & 2147483648u) != 0u));
                        } else {
                            phi_3194_ = _e1280;
                        }
                        let _e2054 = phi_3194_;
                        if _e2020 {
                            let _e2057 = ((_e1280 >> bitcast<u32>(28u)) & 7u);
                            phi_3209_ = select(_e2057, 7u, (_e2057 == 0u));
                        } else {
                            phi_3209_ = 0u;
                        }
                        let _e2061 = phi_3209_;
                        if ((_e1311 & 2147483648u) != 0u) {
                            let _e2066 = ((_e1311 >> bitcast<u32>(28u)) & 7u);
                            phi_3224_ = select(_e2066, 7u, (_e2066 == 0u));
                        } else {
                            phi_3224_ = 0u;
                        }
                        let _e2070 = phi_3224_;
                        local_16 = _e2018;
                        local_16[0u] = (((_e2054 & 268435455u) | (_e2061 << bitcast<u32>(28u))) | (_e2070 << bitcast<u32>(31i)));
                        phi_3323_ = type_4(0u, 3u);
                        loop {
                            let _e2086 = phi_3323_;
                            if (_e2086.member < _e2086.member_1) {
                                phi_3324_ = type_4((_e2086.member + 1u), _e2086.member_1);
                                phi_3347_ = type_4(1u, _e2086.member);
                            } else {
                                phi_3324_ = _e2086;
                                phi_3347_ = type_4(0u, type_4().member_1);
                            }
                            let _e2099 = phi_3324_;
                            let _e2101 = phi_3347_;
                            let _e2105 = (bitcast<i32>(_e2101.member) != 0i);
                            if _e2105 {
                                let _e2113 = ((_e2101.member_1 + 1u) % 4u);
                                if (_e2113 < 4u) {
                                } else {
                                    phi_3761_ = true;
                                    break;
                                }
                                let _e2116 = local_16[_e2113];
                                local_16[_e2113] = (_e2116 | ((((_e2049 & 268435455u) | ((_e2070 >> bitcast<u32>(1i)) << bitcast<u32>(28u))) >> bitcast<u32>(((10u * _e2101.member_1) & 31u))) << bitcast<u32>(22i)));
                            }
                            continue;
                            continuing {
                                phi_3323_ = _e2099;
                                phi_3761_ = _e2017;
                                break if !(_e2105);
                            }
                        }
                        let _e2120 = phi_3761_;
                        if _e2120 {
                            break;
                        }
                        let _e2121 = local_16;
                        if _e80 {
                        } else {
                            break;
                        }
                        global_3.member[_e74] = array<u32, 4>(_e2121[0], _e2121[1], _e2121[2], _e2121[3]);
                        if (_e74 == 0u) {
                            if (_e70 == 0u) {
                            } else {
                                if (0u < _e70) {
                                } else {
                                    break;
                                }
                                global_4.member[0u] = type_27(array<u32, 4>(bitcast<u32>(_e1276[0]), bitcast<u32>(_e1276[1]), bitcast<u32>(_e1276[2]), 4294967272u), array<u32, 4>(bitcast<u32>(_e1275[0]), bitcast<u32>(_e1275[1]), bitcast<u32>(_e1275[2]), 0u));
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
