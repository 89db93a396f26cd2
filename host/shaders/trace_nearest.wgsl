struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_39 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<type_24>,
}

struct type_45 {
    member: array<array<type_23, 8>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_29;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_41;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_45;

fn function_() {
    var local: array<type_23, 8>;
    var local_1: array<f32, 128>;
    var local_2: array<u32, 128>;
    var phi_372_: i32;
    var phi_373_: i32;
    var phi_383_: bool;
    var phi_393_: u32;
    var phi_394_: u32;
    var phi_396_: bool;
    var phi_401_: u32;
    var phi_414_: i32;
    var phi_434_: i32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_556_: f32;
    var phi_568_: f32;
    var phi_577_: f32;
    var phi_583_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_681_: f32;
    var phi_693_: f32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_748_: f32;
    var phi_754_: f32;
    var phi_806_: f32;
    var phi_818_: f32;
    var phi_873_: i32;
    var phi_895_: u32;
    var phi_896_: u32;
    var phi_933_: i32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_964_: f32;
    var phi_965_: f32;
    var phi_3054_: bool;
    var phi_3035_: f32;
    var phi_1035_: bool;
    var phi_1038_: u32;
    var phi_1040_: u32;
    var phi_1042_: u32;
    var phi_1053_: bool;
    var phi_1086_: bool;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_2313_: type_39;
    var phi_2676_: u32;
    var phi_2704_: u32;
    var phi_2705_: u32;
    var phi_2706_: u32;
    var phi_2708_: u32;
    var phi_2709_: u32;
    var phi_2710_: bool;
    var phi_2719_: u32;
    var phi_2724_: bool;
    var phi_2726_: u32;
    var phi_3051_: bool;
    var phi_3041_: f32;
    var phi_1103_: type_4;
    var phi_1104_: type_4;
    var phi_1127_: type_4;
    var phi_1148_: u32;
    var phi_1240_: array<array<f32, 3>, 3>;
    var phi_1393_: bool;
    var phi_1422_: bool;
    var phi_1841_: f32;
    var phi_1842_: f32;
    var phi_1843_: f32;
    var phi_1844_: f32;
    var phi_1845_: vec3<f32>;
    var phi_1846_: vec3<f32>;
    var phi_1847_: vec3<f32>;
    var phi_1848_: vec3<f32>;
    var phi_1885_: bool;
    var phi_1894_: vec3<f32>;
    var phi_2059_: f32;
    var phi_2061_: f32;
    var phi_2062_: bool;
    var phi_2082_: f32;
    var phi_2083_: f32;
    var phi_2106_: type_23;
    var phi_2108_: type_23;
    var phi_2109_: bool;
    var phi_2113_: type_23;
    var phi_2114_: type_23;
    var phi_2115_: type_23;
    var phi_2116_: bool;
    var phi_2120_: type_23;
    var phi_2121_: bool;
    var phi_2122_: type_23;
    var phi_2123_: bool;
    var phi_2124_: bool;
    var phi_2125_: type_23;
    var phi_2126_: bool;
    var phi_2127_: bool;
    var phi_2135_: type_23;
    var phi_2136_: bool;
    var phi_2140_: type_23;
    var phi_2152_: type_4;
    var phi_2155_: type_23;
    var phi_2153_: type_4;
    var phi_2178_: type_4;
    var phi_2210_: bool;
    var phi_2211_: bool;
    var phi_2232_: type_23;
    var phi_2156_: type_23;
    var phi_3042_: bool;
    var phi_3394_: f32;
    var phi_3393_: f32;
    var phi_3205_: bool;
    var phi_3392_: f32;
    var phi_3204_: bool;
    var phi_3391_: f32;
    var phi_3203_: bool;
    var phi_3303_: f32;
    var phi_3202_: bool;
    var phi_3268_: f32;
    var phi_3211_: bool;
    var phi_2730_: bool;
    var phi_2731_: u32;
    var phi_2732_: u32;
    var phi_3267_: f32;
    var phi_3210_: bool;
    var phi_2733_: bool;
    var phi_2734_: u32;
    var phi_2735_: u32;
    var phi_2736_: u32;
    var phi_3266_: f32;
    var phi_3209_: bool;
    var phi_2737_: bool;
    var phi_2738_: u32;
    var phi_2739_: u32;
    var phi_2740_: u32;
    var phi_3265_: f32;
    var phi_3208_: bool;
    var phi_1036_: bool;
    var phi_1039_: u32;
    var phi_1041_: u32;
    var phi_1043_: u32;
    var phi_2741_: bool;
    var phi_3207_: bool;
    var phi_2748_: type_4;
    var phi_2749_: type_4;
    var phi_2772_: type_4;
    var phi_2824_: f32;
    var phi_2826_: f32;
    var phi_2827_: bool;
    var phi_2828_: f32;
    var phi_2829_: bool;
    var phi_2968_: u32;
    var phi_2986_: bool;
    var phi_2989_: bool;
    var phi_3002_: f32;
    var phi_3003_: f32;
    var phi_3008_: f32;
    var phi_3009_: f32;
    var phi_3010_: bool;
    var phi_3018_: f32;
    var phi_2844_: f32;
    var phi_2845_: f32;
    var phi_2857_: f32;
    var phi_2862_: type_23;
    var phi_3247_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e76 = global;
            let _e78 = arrayLength((&global_2.member));
            let _e80 = arrayLength((&global_3.member));
            let _e88 = (_e76.x + (_e76.y * 2097152u));
            let _e91 = global_1.member[0u];
            let _e92 = bitcast<i32>(_e91);
            let _e93 = (_e88 < arrayLength((&global_4.member)));
            if _e93 {
                let _e94 = (_e88 < arrayLength((&global_5.member)));
                if _e94 {
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e102 = global_4.member[_e88].member_2[0u];
                    let _e104 = (bitcast<u32>(_e102) & 2147483647u);
                    let _e109 = global_4.member[_e88].member_2[1u];
                    let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                    let _e116 = global_4.member[_e88].member_2[2u];
                    let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                    let _e123 = global_4.member[_e88].member[0u];
                    let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                    let _e130 = global_4.member[_e88].member[1u];
                    let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                    let _e137 = global_4.member[_e88].member[2u];
                    let _e139 = (bitcast<u32>(_e137) & 2147483647u);
                    let _e141 = select(_e111, _e104, (_e111 < _e104));
                    let _e143 = select(_e118, _e141, (_e118 < _e141));
                    let _e145 = select(_e125, _e143, (_e125 < _e143));
                    let _e147 = select(_e132, _e145, (_e132 < _e145));
                    let _e149 = select(_e139, _e147, (_e139 < _e147));
                    let _e153 = global_4.member[_e88].member_1;
                    let _e154 = bitcast<u32>(_e153);
                    let _e155 = (_e154 & 2147483647u);
                    let _e162 = global_4.member[_e88].member_3;
                    let _e163 = bitcast<u32>(_e162);
                    let _e164 = (_e163 & 2147483647u);
                    let _e168 = (((select(_e155, _e149, (_e155 < _e149)) < 2139095040u) && (_e164 <= 2139095040u)) && (_e143 > 0u));
                    if _e168 {
                        let _e171 = (bitcast<u32>(bitcast<f32>(_e143)) & 2147483647u);
                        if (_e171 >= 8388608u) {
                            phi_372_ = (bitcast<i32>((_e171 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_372_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e171)), 32u, (_e171 == 0u))));
                        }
                        let _e185 = phi_372_;
                        phi_373_ = _e185;
                    } else {
                        phi_373_ = 0i;
                    }
                    let _e187 = phi_373_;
                    let _e188 = (_e104 == _e143);
                    if _e188 {
                        phi_383_ = true;
                    } else {
                        phi_383_ = (_e111 == _e143);
                    }
                    let _e191 = phi_383_;
                    let _e192 = select(1u, 0u, _e188);
                    if _e191 {
                        let _e193 = (_e192 + 1u);
                        phi_393_ = _e193;
                        phi_394_ = _e193;
                        phi_396_ = select(true, false, (_e193 == 2u));
                    } else {
                        phi_393_ = u32();
                        phi_394_ = 0u;
                        phi_396_ = true;
                    }
                    let _e197 = phi_393_;
                    let _e199 = phi_394_;
                    let _e201 = phi_396_;
                    if _e201 {
                        phi_401_ = (_e199 + 1u);
                    } else {
                        phi_401_ = 0u;
                    }
                    let _e205 = phi_401_;
                    let _e206 = select(_e197, _e199, _e201);
                    let _e207 = select(_e192, select(2u, _e192, _e191), _e201);
                    if (_e92 < -126i) {
                        phi_414_ = -126i;
                    } else {
                        phi_414_ = select(_e92, 127i, (_e92 > 127i));
                    }
                    let _e212 = phi_414_;
                    let _e217 = bitcast<f32>((bitcast<u32>((_e212 + 127i)) << bitcast<u32>(23i)));
                    let _e223 = bitcast<f32>((bitcast<u32>(((_e92 - _e212) + 127i)) << bitcast<u32>(23i)));
                    let _e224 = -(_e187);
                    if (_e224 < -126i) {
                        phi_434_ = -126i;
                    } else {
                        phi_434_ = select(_e224, 127i, (_e224 > 127i));
                    }
                    let _e229 = phi_434_;
                    let _e234 = bitcast<f32>((bitcast<u32>((_e229 + 127i)) << bitcast<u32>(23i)));
                    let _e240 = bitcast<f32>((bitcast<u32>(((_e224 - _e229) + 127i)) << bitcast<u32>(23i)));
                    let _e244 = global_4.member[_e88].member;
                    let _e245 = (_e206 == 0u);
                    if _e245 {
                        phi_452_ = _e244[0];
                    } else {
                        phi_452_ = _e244[1];
                    }
                    let _e249 = phi_452_;
                    let _e250 = (_e206 == 2u);
                    if _e250 {
                        phi_458_ = _e244[2];
                    } else {
                        phi_458_ = _e249;
                    }
                    let _e253 = phi_458_;
                    let _e254 = bitcast<u32>(_e253);
                    let _e256 = ((_e254 & 2139095040u) != 0u);
                    let _e270 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e254 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e254 & 2147483648u))), _e253, _e256) * _e217) * select(0.00000011920929f, 1f, _e256)) * _e223);
                    let _e271 = global_4.member[_e88].member_2;
                    if _e245 {
                        phi_498_ = _e271[0];
                    } else {
                        phi_498_ = _e271[1];
                    }
                    let _e275 = phi_498_;
                    if _e250 {
                        phi_504_ = _e271[2];
                    } else {
                        phi_504_ = _e275;
                    }
                    let _e278 = phi_504_;
                    let _e279 = bitcast<u32>(_e278);
                    let _e281 = ((_e279 & 2139095040u) != 0u);
                    let _e295 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e278, _e281) * _e234) * select(0.00000011920929f, 1f, _e281)) * _e240);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_556_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_556_ = 0f;
                    }
                    let _e307 = phi_556_;
                    let _e308 = (_e270 + _e307);
                    let _e309 = (_e270 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_568_ = 38685626000000000000000000f;
                    } else {
                        phi_568_ = (1f / _e295);
                    }
                    let _e313 = phi_568_;
                    let _e314 = (_e205 == 0u);
                    if _e314 {
                        phi_577_ = _e244[0];
                    } else {
                        phi_577_ = _e244[1];
                    }
                    let _e318 = phi_577_;
                    let _e319 = (_e205 == 2u);
                    if _e319 {
                        phi_583_ = _e244[2];
                    } else {
                        phi_583_ = _e318;
                    }
                    let _e322 = phi_583_;
                    let _e323 = bitcast<u32>(_e322);
                    let _e325 = ((_e323 & 2139095040u) != 0u);
                    let _e339 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e322, _e325) * _e217) * select(0.00000011920929f, 1f, _e325)) * _e223);
                    if _e314 {
                        phi_623_ = _e271[0];
                    } else {
                        phi_623_ = _e271[1];
                    }
                    let _e343 = phi_623_;
                    if _e319 {
                        phi_629_ = _e271[2];
                    } else {
                        phi_629_ = _e343;
                    }
                    let _e346 = phi_629_;
                    let _e347 = bitcast<u32>(_e346);
                    let _e349 = ((_e347 & 2139095040u) != 0u);
                    let _e363 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e347 & 2147483648u))), _e346, _e349) * _e234) * select(0.00000011920929f, 1f, _e349)) * _e240);
                    let _e367 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e367 {
                        let _e371 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                        phi_681_ = select(0.00000000000011368684f, _e371, (_e371 > 0.00000000000011368684f));
                    } else {
                        phi_681_ = 0f;
                    }
                    let _e375 = phi_681_;
                    let _e376 = (_e339 + _e375);
                    let _e377 = (_e339 - _e375);
                    let _e378 = select(_e363, 0f, _e367);
                    if _e367 {
                        phi_693_ = 38685626000000000000000000f;
                    } else {
                        phi_693_ = (1f / _e363);
                    }
                    let _e381 = phi_693_;
                    let _e382 = (_e207 == 0u);
                    if _e382 {
                        phi_702_ = _e244[0];
                    } else {
                        phi_702_ = _e244[1];
                    }
                    let _e386 = phi_702_;
                    let _e387 = (_e207 == 2u);
                    if _e387 {
                        phi_708_ = _e244[2];
                    } else {
                        phi_708_ = _e386;
                    }
                    let _e390 = phi_708_;
                    let _e391 = bitcast<u32>(_e390);
                    let _e393 = ((_e391 & 2139095040u) != 0u);
                    let _e407 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e391 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e391 & 2147483648u))), _e390, _e393) * _e217) * select(0.00000011920929f, 1f, _e393)) * _e223);
                    if _e382 {
                        phi_748_ = _e271[0];
                    } else {
                        phi_748_ = _e271[1];
                    }
                    let _e411 = phi_748_;
                    if _e387 {
                        phi_754_ = _e271[2];
                    } else {
                        phi_754_ = _e411;
                    }
                    let _e414 = phi_754_;
                    let _e415 = bitcast<u32>(_e414);
                    let _e417 = ((_e415 & 2139095040u) != 0u);
                    let _e431 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e415 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e415 & 2147483648u))), _e414, _e417) * _e234) * select(0.00000011920929f, 1f, _e417)) * _e240);
                    let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e435 {
                        let _e439 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) * 0.00000011920929f);
                        phi_806_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                    } else {
                        phi_806_ = 0f;
                    }
                    let _e443 = phi_806_;
                    let _e444 = (_e407 + _e443);
                    let _e445 = (_e407 - _e443);
                    let _e446 = select(_e431, 0f, _e435);
                    if _e435 {
                        phi_818_ = 38685626000000000000000000f;
                    } else {
                        phi_818_ = (1f / _e431);
                    }
                    let _e449 = phi_818_;
                    let _e452 = bitcast<f32>((bitcast<u32>(_e270) & 2147483647u));
                    let _e455 = bitcast<f32>((bitcast<u32>(_e339) & 2147483647u));
                    let _e457 = select(_e455, _e452, (_e452 > _e455));
                    let _e460 = bitcast<f32>((bitcast<u32>(_e407) & 2147483647u));
                    let _e463 = (_e92 + _e187);
                    if (_e168 && (select(_e460, _e457, (_e457 > _e460)) <= 1099511600000f)) {
                        let _e473 = ((_e155 & 8388607u) | (select(0u, 1u, ((_e155 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e476 = bitcast<i32>((_e155 >> bitcast<u32>(23i)));
                        let _e480 = (_e473 == 0u);
                        let _e483 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e473)), 32u, _e480)) - 8i);
                        if (_e476 == 255i) {
                            phi_873_ = 255i;
                        } else {
                            phi_873_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e463);
                        }
                        let _e491 = phi_873_;
                        let _e501 = (_e491 <= 0i);
                        if _e501 {
                            phi_896_ = u32();
                        } else {
                            if _e480 {
                                phi_895_ = u32();
                            } else {
                                phi_895_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | ((_e473 << bitcast<u32>(((_e483 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e491 >= 255i));
                            }
                            let _e505 = phi_895_;
                            phi_896_ = _e505;
                        }
                        let _e507 = phi_896_;
                        let _e519 = ((_e164 & 8388607u) | (select(0u, 1u, ((_e164 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<i32>((_e164 >> bitcast<u32>(23i)));
                        let _e526 = (_e519 == 0u);
                        let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                        if (_e522 == 255i) {
                            phi_933_ = 255i;
                        } else {
                            phi_933_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e463);
                        }
                        let _e537 = phi_933_;
                        let _e547 = (_e537 <= 0i);
                        if _e547 {
                            phi_956_ = u32();
                        } else {
                            if _e526 {
                                phi_955_ = u32();
                            } else {
                                phi_955_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                            }
                            let _e551 = phi_955_;
                            phi_956_ = _e551;
                        }
                        let _e553 = phi_956_;
                        phi_964_ = bitcast<f32>(((_e163 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                        phi_965_ = bitcast<f32>(((_e154 & 2147483648u) | select(_e507, 0u, select(_e480, true, _e501))));
                    } else {
                        phi_964_ = 0f;
                        phi_965_ = 1f;
                    }
                    let _e559 = phi_964_;
                    let _e561 = phi_965_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3054_ = false;
                    phi_3035_ = _e559;
                    phi_1035_ = (_e561 <= _e559);
                    phi_1038_ = ((3u * _e78) + 1u);
                    phi_1040_ = 0u;
                    phi_1042_ = select(0u, 2147483648u, (_e78 == 0u));
                    loop {
                        let _e568 = phi_3054_;
                        let _e570 = phi_3035_;
                        let _e572 = phi_1035_;
                        let _e574 = phi_1038_;
                        let _e576 = phi_1040_;
                        let _e578 = phi_1042_;
                        if _e572 {
                            phi_1053_ = true;
                        } else {
                            phi_1053_ = (_e576 > 0u);
                        }
                        let _e581 = phi_1053_;
                        if _e581 {
                            let _e582 = (_e574 > 0u);
                            if _e582 {
                                if _e572 {
                                    phi_1086_ = _e572;
                                    phi_1087_ = _e576;
                                    phi_1088_ = _e578;
                                } else {
                                    let _e583 = (_e576 - 1u);
                                    let _e584 = (_e583 % 128u);
                                    let _e585 = (_e584 < 128u);
                                    if _e585 {
                                    } else {
                                        phi_3207_ = true;
                                        break;
                                    }
                                    let _e587 = local_2[_e584];
                                    if _e585 {
                                    } else {
                                        phi_3207_ = true;
                                        break;
                                    }
                                    let _e589 = local_1[_e584];
                                    phi_1086_ = (_e589 <= _e570);
                                    phi_1087_ = _e583;
                                    phi_1088_ = _e587;
                                }
                                let _e592 = phi_1086_;
                                let _e594 = phi_1087_;
                                let _e596 = phi_1088_;
                                if _e592 {
                                    if ((_e596 & 2147483648u) != 0u) {
                                        phi_3051_ = _e568;
                                        phi_3041_ = _e570;
                                        phi_1103_ = type_4(0u, ((_e596 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e793 = phi_3051_;
                                            let _e795 = phi_3041_;
                                            let _e797 = phi_1103_;
                                            if (_e797.member < _e797.member_1) {
                                                phi_1104_ = type_4((_e797.member + 1u), _e797.member_1);
                                                phi_1127_ = type_4(1u, _e797.member);
                                            } else {
                                                phi_1104_ = _e797;
                                                phi_1127_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e810 = phi_1104_;
                                            let _e812 = phi_1127_;
                                            let _e816 = (bitcast<i32>(_e812.member) != 0i);
                                            if _e816 {
                                                let _e817 = ((_e596 & 268435455u) + _e812.member_1);
                                                let _e818 = (_e817 < _e80);
                                                if _e818 {
                                                    if _e818 {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e822 = global_3.member[_e817].member_1;
                                                    phi_1148_ = _e822;
                                                } else {
                                                    phi_1148_ = 4294967295u;
                                                }
                                                let _e824 = phi_1148_;
                                                if (_e817 >= _e80) {
                                                    phi_1240_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e818 {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e826 = (_e206 % 3u);
                                                    let _e827 = (_e205 % 3u);
                                                    let _e828 = (_e207 % 3u);
                                                    if (_e826 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e834 = global_3.member[_e817].member[_e826];
                                                    if (_e827 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e840 = global_3.member[_e817].member[_e827];
                                                    if (_e828 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e846 = global_3.member[_e817].member[_e828];
                                                    let _e848 = (3u + _e826);
                                                    if (_e848 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e854 = global_3.member[_e817].member[_e848];
                                                    let _e855 = (3u + _e827);
                                                    if (_e855 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e861 = global_3.member[_e817].member[_e855];
                                                    let _e862 = (3u + _e828);
                                                    if (_e862 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e868 = global_3.member[_e817].member[_e862];
                                                    let _e870 = (6u + _e826);
                                                    if (_e870 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e876 = global_3.member[_e817].member[_e870];
                                                    let _e877 = (6u + _e827);
                                                    if (_e877 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e883 = global_3.member[_e817].member[_e877];
                                                    let _e884 = (6u + _e828);
                                                    if (_e884 < 9u) {
                                                    } else {
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_3.member[_e817].member[_e884];
                                                    phi_1240_ = array<array<f32, 3>, 3>(array<f32, 3>(_e834, _e840, _e846), array<f32, 3>(_e854, _e861, _e868), array<f32, 3>(_e876, _e883, _e890));
                                                }
                                                let _e894 = phi_1240_;
                                                let _e901 = (_e894[0][2] - _e407);
                                                let _e904 = (((_e894[0][0] - _e270) * _e446) - (_e901 * _e310));
                                                let _e907 = (((_e894[0][1] - _e339) * _e446) - (_e901 * _e378));
                                                let _e914 = (_e894[1][2] - _e407);
                                                let _e917 = (((_e894[1][0] - _e270) * _e446) - (_e914 * _e310));
                                                let _e920 = (((_e894[1][1] - _e339) * _e446) - (_e914 * _e378));
                                                let _e927 = (_e894[2][2] - _e407);
                                                let _e930 = (((_e894[2][0] - _e270) * _e446) - (_e927 * _e310));
                                                let _e933 = (((_e894[2][1] - _e339) * _e446) - (_e927 * _e378));
                                                let _e934 = (_e930 * _e920);
                                                let _e935 = (_e933 * _e917);
                                                let _e936 = (_e904 * _e933);
                                                let _e937 = (_e907 * _e930);
                                                let _e938 = (_e917 * _e907);
                                                let _e939 = (_e920 * _e904);
                                                let _e944 = (((_e934 >= _e935) && (_e936 >= _e937)) && (_e938 >= _e939));
                                                if (_e944 || (((_e934 <= _e935) && (_e936 <= _e937)) && (_e938 <= _e939))) {
                                                    let _e951 = select(-1f, 1f, _e944);
                                                    let _e953 = ((_e934 - _e935) * _e951);
                                                    let _e955 = select(0f, _e953, (_e953 > 0f));
                                                    let _e957 = ((_e936 - _e937) * _e951);
                                                    let _e959 = select(0f, _e957, (_e957 > 0f));
                                                    let _e961 = ((_e938 - _e939) * _e951);
                                                    let _e963 = select(0f, _e961, (_e961 > 0f));
                                                    let _e965 = ((_e955 + _e959) + _e963);
                                                    if (_e965 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2125_ = type_23();
                                                        phi_2126_ = true;
                                                        phi_2127_ = false;
                                                    } else {
                                                        let _e968 = select(_e917, _e904, (_e904 < _e917));
                                                        if (select(_e930, _e968, (_e968 < _e930)) > 0f) {
                                                            phi_1393_ = true;
                                                        } else {
                                                            let _e973 = select(_e917, _e904, (_e904 > _e917));
                                                            phi_1393_ = (select(_e930, _e973, (_e973 > _e930)) < 0f);
                                                        }
                                                        let _e978 = phi_1393_;
                                                        if _e978 {
                                                            phi_2122_ = type_23();
                                                            phi_2123_ = true;
                                                            phi_2124_ = false;
                                                        } else {
                                                            let _e980 = select(_e920, _e907, (_e907 < _e920));
                                                            if (select(_e933, _e980, (_e980 < _e933)) > 0f) {
                                                                phi_1422_ = true;
                                                            } else {
                                                                let _e985 = select(_e920, _e907, (_e907 > _e920));
                                                                phi_1422_ = (select(_e933, _e985, (_e985 > _e933)) < 0f);
                                                            }
                                                            let _e990 = phi_1422_;
                                                            if _e990 {
                                                                phi_2120_ = type_23();
                                                                phi_2121_ = false;
                                                            } else {
                                                                let _e992 = select(_e894[1][0], _e894[0][0], (_e894[0][0] < _e894[1][0]));
                                                                let _e996 = select(_e894[1][0], _e894[0][0], (_e894[0][0] > _e894[1][0]));
                                                                let _e1000 = select(_e894[1][1], _e894[0][1], (_e894[0][1] < _e894[1][1]));
                                                                let _e1004 = select(_e894[1][1], _e894[0][1], (_e894[0][1] > _e894[1][1]));
                                                                let _e1008 = select(_e894[1][2], _e894[0][2], (_e894[0][2] < _e894[1][2]));
                                                                let _e1012 = select(_e894[1][2], _e894[0][2], (_e894[0][2] > _e894[1][2]));
                                                                let _e1017 = ((select(_e894[2][0], _e992, (_e992 < _e894[2][0])) - _e308) * _e313);
                                                                let _e1018 = ((select(_e894[2][0], _e996, (_e996 > _e894[2][0])) - _e309) * _e313);
                                                                let _e1021 = ((select(_e894[2][1], _e1000, (_e1000 < _e894[2][1])) - _e376) * _e381);
                                                                let _e1022 = ((select(_e894[2][1], _e1004, (_e1004 > _e894[2][1])) - _e377) * _e381);
                                                                let _e1025 = ((select(_e894[2][2], _e1008, (_e1008 < _e894[2][2])) - _e444) * _e449);
                                                                let _e1026 = ((select(_e894[2][2], _e1012, (_e1012 > _e894[2][2])) - _e445) * _e449);
                                                                let _e1028 = select(_e1026, _e1025, (_e1025 < _e1026));
                                                                let _e1030 = select(_e1026, _e1025, (_e1025 > _e1026));
                                                                let _e1032 = select(_e1018, _e1017, (_e1017 < _e1018));
                                                                let _e1034 = select(_e1022, _e1021, (_e1021 < _e1022));
                                                                let _e1036 = select(_e1034, _e1032, (_e1032 > _e1034));
                                                                let _e1038 = select(_e1028, _e1036, (_e1036 > _e1028));
                                                                let _e1040 = select(_e1018, _e1017, (_e1017 > _e1018));
                                                                let _e1042 = select(_e1022, _e1021, (_e1021 > _e1022));
                                                                let _e1044 = select(_e1042, _e1040, (_e1040 < _e1042));
                                                                let _e1046 = select(_e1030, _e1044, (_e1044 < _e1030));
                                                                let _e1047 = -(_e1028);
                                                                let _e1053 = select(_e561, _e1038, (_e1038 > _e561));
                                                                if (_e1053 > (_e1046 + (select(_e1047, _e1030, (_e1030 > _e1047)) * 0.0000019073523f))) {
                                                                    phi_2115_ = type_23();
                                                                    phi_2116_ = true;
                                                                } else {
                                                                    let _e1055 = (_e1053 > _e795);
                                                                    if _e1055 {
                                                                        phi_2114_ = type_23();
                                                                    } else {
                                                                        let _e1056 = vec3<f32>(_e894[0][0], _e894[0][1], _e894[0][2]);
                                                                        let _e1057 = vec3<f32>(_e894[1][0], _e894[1][1], _e894[1][2]);
                                                                        let _e1058 = vec3<f32>(_e894[2][0], _e894[2][1], _e894[2][2]);
                                                                        let _e1059 = (_e894[1][0] - _e894[0][0]);
                                                                        let _e1060 = (_e894[1][1] - _e894[0][1]);
                                                                        let _e1061 = (_e894[1][2] - _e894[0][2]);
                                                                        let _e1062 = vec3<f32>(_e1059, _e1060, _e1061);
                                                                        let _e1063 = (_e894[2][0] - _e894[1][0]);
                                                                        let _e1064 = (_e894[2][1] - _e894[1][1]);
                                                                        let _e1065 = (_e894[2][2] - _e894[1][2]);
                                                                        let _e1066 = vec3<f32>(_e1063, _e1064, _e1065);
                                                                        let _e1067 = (_e894[0][0] - _e894[2][0]);
                                                                        let _e1068 = (_e894[0][1] - _e894[2][1]);
                                                                        let _e1069 = (_e894[0][2] - _e894[2][2]);
                                                                        let _e1070 = vec3<f32>(_e1067, _e1068, _e1069);
                                                                        let _e1073 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                        let _e1076 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1078 = select(_e1076, _e1073, (_e1073 > _e1076));
                                                                        let _e1081 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                                        let _e1083 = select(_e1081, _e1078, (_e1078 > _e1081));
                                                                        let _e1086 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                        let _e1089 = bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u));
                                                                        let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                                                                        let _e1094 = bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u));
                                                                        let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                                                                        let _e1099 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                        let _e1102 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                        let _e1104 = select(_e1102, _e1099, (_e1099 > _e1102));
                                                                        let _e1107 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
                                                                        let _e1109 = select(_e1107, _e1104, (_e1104 > _e1107));
                                                                        let _e1111 = select(_e1096, _e1083, (_e1083 > _e1096));
                                                                        let _e1113 = select(_e1109, _e1111, (_e1111 > _e1109));
                                                                        if (_e1083 == _e1113) {
                                                                            phi_1841_ = _e920;
                                                                            phi_1842_ = _e917;
                                                                            phi_1843_ = _e907;
                                                                            phi_1844_ = _e904;
                                                                            phi_1845_ = _e1056;
                                                                            phi_1846_ = _e1070;
                                                                            phi_1847_ = _e1066;
                                                                            phi_1848_ = _e1062;
                                                                        } else {
                                                                            let _e1115 = (_e1096 == _e1113);
                                                                            let _e1120 = vec3(_e1115);
                                                                            phi_1841_ = select(_e907, _e933, _e1115);
                                                                            phi_1842_ = select(_e904, _e930, _e1115);
                                                                            phi_1843_ = select(_e933, _e920, _e1115);
                                                                            phi_1844_ = select(_e930, _e917, _e1115);
                                                                            phi_1845_ = select(_e1058, _e1057, _e1120);
                                                                            phi_1846_ = select(_e1066, _e1062, _e1120);
                                                                            phi_1847_ = select(_e1062, _e1070, _e1120);
                                                                            phi_1848_ = select(_e1070, _e1066, _e1120);
                                                                        }
                                                                        let _e1126 = phi_1841_;
                                                                        let _e1128 = phi_1842_;
                                                                        let _e1130 = phi_1843_;
                                                                        let _e1132 = phi_1844_;
                                                                        let _e1134 = phi_1845_;
                                                                        let _e1136 = phi_1846_;
                                                                        let _e1138 = phi_1847_;
                                                                        let _e1140 = phi_1848_;
                                                                        let _e1147 = ((_e1138.y * _e1136.z) - (_e1136.y * _e1138.z));
                                                                        let _e1152 = ((_e1138.z * _e1136.x) - (_e1136.z * _e1138.x));
                                                                        let _e1155 = ((_e1138.x * _e1136.y) - (_e1136.x * _e1138.y));
                                                                        if (_e955 >= _e959) {
                                                                            phi_1885_ = select(true, false, (_e955 >= _e963));
                                                                        } else {
                                                                            phi_1885_ = true;
                                                                        }
                                                                        let _e1160 = phi_1885_;
                                                                        if _e1160 {
                                                                            phi_1894_ = select(_e1058, _e1057, vec3((_e959 >= _e963)));
                                                                        } else {
                                                                            phi_1894_ = _e1056;
                                                                        }
                                                                        let _e1165 = phi_1894_;
                                                                        let _e1176 = (((_e1147 * (_e1165.x - _e270)) + (_e1152 * (_e1165.y - _e339))) + (_e1155 * (_e1165.z - _e407)));
                                                                        let _e1181 = (((_e1147 * _e310) + (_e1152 * _e378)) + (_e1155 * _e446));
                                                                        let _e1182 = (_e1128 - _e1132);
                                                                        let _e1183 = (_e1126 - _e1130);
                                                                        let _e1191 = (-(((_e1132 * _e1182) + (_e1130 * _e1183))) / ((_e1182 * _e1182) + (_e1183 * _e1183)));
                                                                        let _e1193 = select(1f, _e1191, (_e1191 < 1f));
                                                                        let _e1195 = select(0f, _e1193, (_e1193 > 0f));
                                                                        let _e1208 = ((_e1134.x + (_e1140.x * _e1195)) - _e270);
                                                                        let _e1209 = ((_e1134.y + (_e1140.y * _e1195)) - _e339);
                                                                        let _e1210 = ((_e1134.z + (_e1140.z * _e1195)) - _e407);
                                                                        let _e1211 = (_e1210 / _e446);
                                                                        let _e1223 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                        let _e1228 = select(_e1226, _e1223, (_e1223 > _e1226));
                                                                        let _e1231 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                        let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                                                                        let _e1239 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                        let _e1242 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                        let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                        let _e1247 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1147 * _e1208) + (_e1152 * _e1209)) + (_e1155 * _e1210)) - _e1176)) & 2147483647u)) <= ((0.0000009536743f * select(_e1113, _e1233, (_e1233 > _e1113))) * select(_e1247, _e1244, (_e1244 > _e1247)))) {
                                                                            let _e1257 = bitcast<f32>((bitcast<u32>(_e1138.x) & 2147483647u));
                                                                            let _e1260 = bitcast<f32>((bitcast<u32>(_e1138.y) & 2147483647u));
                                                                            let _e1262 = select(_e1260, _e1257, (_e1257 > _e1260));
                                                                            let _e1265 = bitcast<f32>((bitcast<u32>(_e1138.z) & 2147483647u));
                                                                            let _e1271 = bitcast<f32>((bitcast<u32>(_e1136.x) & 2147483647u));
                                                                            let _e1274 = bitcast<f32>((bitcast<u32>(_e1136.y) & 2147483647u));
                                                                            let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                            let _e1279 = bitcast<f32>((bitcast<u32>(_e1136.z) & 2147483647u));
                                                                            let _e1283 = (bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u)) > ((0.0000038146973f * select(_e1265, _e1262, (_e1262 > _e1265))) * select(_e1279, _e1276, (_e1276 > _e1279))));
                                                                            if _e1283 {
                                                                                phi_2059_ = (_e1176 / _e1181);
                                                                            } else {
                                                                                phi_2059_ = f32();
                                                                            }
                                                                            let _e1286 = phi_2059_;
                                                                            phi_2061_ = _e1286;
                                                                            phi_2062_ = select(true, false, _e1283);
                                                                        } else {
                                                                            phi_2061_ = f32();
                                                                            phi_2062_ = true;
                                                                        }
                                                                        let _e1289 = phi_2061_;
                                                                        let _e1291 = phi_2062_;
                                                                        if _e1291 {
                                                                            let _e1299 = (((_e1147 * (_e1208 - (_e310 * _e1211))) + (_e1152 * (_e1209 - (_e378 * _e1211)))) / _e1181);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u)) <= _e1113) {
                                                                                phi_2082_ = (_e1211 + _e1299);
                                                                            } else {
                                                                                phi_2082_ = _e1211;
                                                                            }
                                                                            let _e1306 = phi_2082_;
                                                                            phi_2083_ = _e1306;
                                                                        } else {
                                                                            phi_2083_ = _e1289;
                                                                        }
                                                                        let _e1308 = phi_2083_;
                                                                        let _e1310 = select(_e1046, _e1308, (_e1308 < _e1046));
                                                                        let _e1312 = select(_e1038, _e1310, (_e1310 > _e1038));
                                                                        if (_e1312 >= _e561) {
                                                                            let _e1314 = (_e1312 <= _e795);
                                                                            if _e1314 {
                                                                                let _e1315 = (1f / _e965);
                                                                                phi_2106_ = type_23(_e1312, (_e959 * _e1315), (_e963 * _e1315), _e824);
                                                                            } else {
                                                                                phi_2106_ = type_23();
                                                                            }
                                                                            let _e1320 = phi_2106_;
                                                                            phi_2108_ = _e1320;
                                                                            phi_2109_ = select(true, false, _e1314);
                                                                        } else {
                                                                            phi_2108_ = type_23();
                                                                            phi_2109_ = true;
                                                                        }
                                                                        let _e1323 = phi_2108_;
                                                                        let _e1325 = phi_2109_;
                                                                        if _e1325 {
                                                                            phi_2113_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2113_ = _e1323;
                                                                        }
                                                                        let _e1327 = phi_2113_;
                                                                        phi_2114_ = _e1327;
                                                                    }
                                                                    let _e1329 = phi_2114_;
                                                                    phi_2115_ = _e1329;
                                                                    phi_2116_ = _e1055;
                                                                }
                                                                let _e1331 = phi_2115_;
                                                                let _e1333 = phi_2116_;
                                                                phi_2120_ = _e1331;
                                                                phi_2121_ = _e1333;
                                                            }
                                                            let _e1335 = phi_2120_;
                                                            let _e1337 = phi_2121_;
                                                            phi_2122_ = _e1335;
                                                            phi_2123_ = _e990;
                                                            phi_2124_ = _e1337;
                                                        }
                                                        let _e1339 = phi_2122_;
                                                        let _e1341 = phi_2123_;
                                                        let _e1343 = phi_2124_;
                                                        phi_2125_ = _e1339;
                                                        phi_2126_ = _e1341;
                                                        phi_2127_ = _e1343;
                                                    }
                                                    let _e1345 = phi_2125_;
                                                    let _e1347 = phi_2126_;
                                                    let _e1349 = phi_2127_;
                                                    phi_2135_ = _e1345;
                                                    phi_2136_ = select(_e1349, true, _e1347);
                                                } else {
                                                    phi_2135_ = type_23();
                                                    phi_2136_ = true;
                                                }
                                                let _e1352 = phi_2135_;
                                                let _e1354 = phi_2136_;
                                                if _e1354 {
                                                    phi_2140_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2140_ = _e1352;
                                                }
                                                let _e1356 = phi_2140_;
                                                if (_e1356.member_3 != 4294967295u) {
                                                    if (_e824 != 4294967295u) {
                                                        phi_2152_ = type_4(0u, 8u);
                                                        phi_2155_ = _e1356;
                                                        loop {
                                                            let _e1361 = phi_2152_;
                                                            let _e1363 = phi_2155_;
                                                            if (_e1361.member < _e1361.member_1) {
                                                                phi_2153_ = type_4((_e1361.member + 1u), _e1361.member_1);
                                                                phi_2178_ = type_4(1u, _e1361.member);
                                                            } else {
                                                                phi_2153_ = _e1361;
                                                                phi_2178_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1376 = phi_2153_;
                                                            let _e1378 = phi_2178_;
                                                            let _e1382 = (bitcast<i32>(_e1378.member) != 0i);
                                                            if _e1382 {
                                                                let _e1383 = (_e1378.member_1 < 8u);
                                                                if _e1383 {
                                                                } else {
                                                                    phi_3042_ = true;
                                                                    break;
                                                                }
                                                                let _e1388 = local[_e1378.member_1].member;
                                                                if (_e1363.member < _e1388) {
                                                                    phi_2211_ = true;
                                                                } else {
                                                                    let _e1390 = local[_e1378.member_1].member;
                                                                    if (_e1363.member == _e1390) {
                                                                        let _e1395 = local[_e1378.member_1].member_3;
                                                                        phi_2210_ = (_e1363.member_3 < _e1395);
                                                                    } else {
                                                                        phi_2210_ = false;
                                                                    }
                                                                    let _e1398 = phi_2210_;
                                                                    phi_2211_ = _e1398;
                                                                }
                                                                let _e1400 = phi_2211_;
                                                                if _e1400 {
                                                                    if _e1383 {
                                                                    } else {
                                                                        phi_3042_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1401 = local[_e1378.member_1];
                                                                    local[_e1378.member_1] = type_23(_e1363.member, _e1363.member_1, _e1363.member_2, _e1363.member_3);
                                                                    phi_2232_ = type_23(_e1401.member, _e1401.member_1, _e1401.member_2, _e1401.member_3);
                                                                } else {
                                                                    phi_2232_ = _e1363;
                                                                }
                                                                let _e1412 = phi_2232_;
                                                                phi_2156_ = _e1412;
                                                            } else {
                                                                phi_2156_ = type_23();
                                                            }
                                                            let _e1414 = phi_2156_;
                                                            continue;
                                                            continuing {
                                                                phi_2152_ = _e1376;
                                                                phi_2155_ = _e1414;
                                                                phi_3042_ = _e793;
                                                                break if !(_e1382);
                                                            }
                                                        }
                                                        let _e1417 = phi_3042_;
                                                        phi_3303_ = _e795;
                                                        phi_3202_ = _e1417;
                                                        if _e1417 {
                                                            break;
                                                        }
                                                        let _e1420 = local[7u].member_3;
                                                        if (_e1420 != 4294967295u) {
                                                            let _e1424 = local[7u].member;
                                                            phi_3394_ = _e1424;
                                                        } else {
                                                            phi_3394_ = _e795;
                                                        }
                                                        let _e1426 = phi_3394_;
                                                        phi_3393_ = _e1426;
                                                        phi_3205_ = _e1417;
                                                    } else {
                                                        phi_3393_ = _e795;
                                                        phi_3205_ = _e793;
                                                    }
                                                    let _e1428 = phi_3393_;
                                                    let _e1430 = phi_3205_;
                                                    phi_3392_ = _e1428;
                                                    phi_3204_ = _e1430;
                                                } else {
                                                    phi_3392_ = _e795;
                                                    phi_3204_ = _e793;
                                                }
                                                let _e1432 = phi_3392_;
                                                let _e1434 = phi_3204_;
                                                phi_3391_ = _e1432;
                                                phi_3203_ = _e1434;
                                            } else {
                                                phi_3391_ = _e795;
                                                phi_3203_ = _e793;
                                            }
                                            let _e1436 = phi_3391_;
                                            let _e1438 = phi_3203_;
                                            continue;
                                            continuing {
                                                phi_3051_ = _e1438;
                                                phi_3041_ = _e1436;
                                                phi_1103_ = _e810;
                                                phi_3303_ = _e1436;
                                                phi_3202_ = _e1438;
                                                break if !(_e816);
                                            }
                                        }
                                        let _e1441 = phi_3303_;
                                        let _e1443 = phi_3202_;
                                        phi_3207_ = _e1443;
                                        if _e1443 {
                                            break;
                                        }
                                        phi_3268_ = _e1441;
                                        phi_3211_ = _e1443;
                                        phi_2730_ = false;
                                        phi_2731_ = _e594;
                                        phi_2732_ = _e596;
                                    } else {
                                        if (_e596 >= _e78) {
                                            phi_2313_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e596 < _e78) {
                                            } else {
                                                phi_3207_ = true;
                                                break;
                                            }
                                            let _e606 = (_e206 % 3u);
                                            if (_e606 < 3u) {
                                            } else {
                                                phi_3207_ = true;
                                                break;
                                            }
                                            let _e612 = global_2.member[_e596].member[_e606];
                                            let _e618 = (_e205 % 3u);
                                            if (_e618 < 3u) {
                                            } else {
                                                phi_3207_ = true;
                                                break;
                                            }
                                            let _e624 = global_2.member[_e596].member[_e618];
                                            let _e630 = (_e207 % 3u);
                                            if (_e630 < 3u) {
                                            } else {
                                                phi_3207_ = true;
                                                break;
                                            }
                                            let _e636 = global_2.member[_e596].member[_e630];
                                            let _e646 = global_2.member[_e596].member_1;
                                            let _e650 = global_2.member[_e596].member_2;
                                            phi_2313_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e612[0], _e612[1], _e612[2], _e612[3]), vec4<f32>(_e624[0], _e624[1], _e624[2], _e624[3]), vec4<f32>(_e636[0], _e636[1], _e636[2], _e636[3])), _e646, _e650);
                                        }
                                        let _e653 = phi_2313_;
                                        let _e664 = ((_e653.member[0].x - _e308) * _e313);
                                        let _e665 = ((_e653.member[0].y - _e308) * _e313);
                                        let _e666 = ((_e653.member[0].z - _e309) * _e313);
                                        let _e667 = ((_e653.member[0].w - _e309) * _e313);
                                        let _e677 = ((_e653.member[1].x - _e376) * _e381);
                                        let _e678 = ((_e653.member[1].y - _e376) * _e381);
                                        let _e679 = ((_e653.member[1].z - _e377) * _e381);
                                        let _e680 = ((_e653.member[1].w - _e377) * _e381);
                                        let _e690 = ((_e653.member[2].x - _e444) * _e449);
                                        let _e691 = ((_e653.member[2].y - _e444) * _e449);
                                        let _e692 = ((_e653.member[2].z - _e445) * _e449);
                                        let _e693 = ((_e653.member[2].w - _e445) * _e449);
                                        let _e695 = select(_e692, _e690, (_e690 < _e692));
                                        let _e697 = select(_e693, _e691, (_e691 < _e693));
                                        let _e699 = select(_e692, _e690, (_e690 > _e692));
                                        let _e701 = select(_e693, _e691, (_e691 > _e693));
                                        let _e703 = select(_e666, _e664, (_e664 < _e666));
                                        let _e705 = select(_e667, _e665, (_e665 < _e667));
                                        let _e707 = select(_e679, _e677, (_e677 < _e679));
                                        let _e709 = select(_e680, _e678, (_e678 < _e680));
                                        let _e711 = select(_e707, _e703, (_e703 > _e707));
                                        let _e713 = select(_e709, _e705, (_e705 > _e709));
                                        let _e715 = select(_e695, _e711, (_e711 > _e695));
                                        let _e717 = select(_e697, _e713, (_e713 > _e697));
                                        let _e719 = select(_e666, _e664, (_e664 > _e666));
                                        let _e721 = select(_e667, _e665, (_e665 > _e667));
                                        let _e723 = select(_e679, _e677, (_e677 > _e679));
                                        let _e725 = select(_e680, _e678, (_e678 > _e680));
                                        let _e727 = select(_e723, _e719, (_e719 < _e723));
                                        let _e729 = select(_e725, _e721, (_e721 < _e725));
                                        let _e734 = -(_e695);
                                        let _e735 = -(_e697);
                                        let _e742 = (select(_e699, _e727, (_e727 < _e699)) + (select(_e734, _e699, (_e699 > _e734)) * 0.0000019073523f));
                                        let _e743 = (select(_e701, _e729, (_e729 < _e701)) + (select(_e735, _e701, (_e701 > _e735)) * 0.0000019073523f));
                                        let _e745 = select(_e561, _e715, (_e715 > _e561));
                                        let _e747 = select(_e561, _e717, (_e717 > _e561));
                                        let _e752 = (_e745 <= select(_e570, _e742, (_e742 < _e570)));
                                        let _e753 = (_e747 <= select(_e570, _e743, (_e743 < _e570)));
                                        let _e754 = (_e745 <= _e747);
                                        if _e752 {
                                            if _e753 {
                                                if _e754 {
                                                    phi_2676_ = _e653.member_2;
                                                } else {
                                                    phi_2676_ = _e653.member_1;
                                                }
                                                let _e758 = phi_2676_;
                                                let _e761 = (_e594 % 128u);
                                                let _e762 = (_e761 < 128u);
                                                if _e762 {
                                                } else {
                                                    phi_3207_ = true;
                                                    break;
                                                }
                                                local_2[_e761] = _e758;
                                                if _e762 {
                                                } else {
                                                    phi_3207_ = true;
                                                    break;
                                                }
                                                local_1[_e761] = select(_e747, _e745, !(_e754));
                                                if _e754 {
                                                    phi_2704_ = _e653.member_1;
                                                } else {
                                                    phi_2704_ = _e653.member_2;
                                                }
                                                let _e769 = phi_2704_;
                                                phi_2705_ = (_e594 + 1u);
                                                phi_2706_ = _e769;
                                            } else {
                                                phi_2705_ = u32();
                                                phi_2706_ = u32();
                                            }
                                            let _e771 = phi_2705_;
                                            let _e773 = phi_2706_;
                                            phi_2708_ = _e771;
                                            phi_2709_ = _e773;
                                            phi_2710_ = select(true, false, _e753);
                                        } else {
                                            phi_2708_ = u32();
                                            phi_2709_ = u32();
                                            phi_2710_ = true;
                                        }
                                        let _e776 = phi_2708_;
                                        let _e778 = phi_2709_;
                                        let _e780 = phi_2710_;
                                        if _e780 {
                                            if _e752 {
                                                phi_2719_ = _e653.member_1;
                                            } else {
                                                phi_2719_ = _e653.member_2;
                                            }
                                            let _e784 = phi_2719_;
                                            phi_2724_ = select(_e753, true, _e752);
                                            phi_2726_ = _e784;
                                        } else {
                                            phi_2724_ = _e592;
                                            phi_2726_ = _e778;
                                        }
                                        let _e787 = phi_2724_;
                                        let _e789 = phi_2726_;
                                        phi_3268_ = _e570;
                                        phi_3211_ = _e568;
                                        phi_2730_ = _e787;
                                        phi_2731_ = select(_e776, _e594, _e780);
                                        phi_2732_ = _e789;
                                    }
                                    let _e1445 = phi_3268_;
                                    let _e1447 = phi_3211_;
                                    let _e1449 = phi_2730_;
                                    let _e1451 = phi_2731_;
                                    let _e1453 = phi_2732_;
                                    phi_3267_ = _e1445;
                                    phi_3210_ = _e1447;
                                    phi_2733_ = _e1449;
                                    phi_2734_ = (_e574 - 1u);
                                    phi_2735_ = _e1451;
                                    phi_2736_ = _e1453;
                                } else {
                                    phi_3267_ = _e570;
                                    phi_3210_ = _e568;
                                    phi_2733_ = _e592;
                                    phi_2734_ = _e574;
                                    phi_2735_ = _e594;
                                    phi_2736_ = _e596;
                                }
                                let _e1455 = phi_3267_;
                                let _e1457 = phi_3210_;
                                let _e1459 = phi_2733_;
                                let _e1461 = phi_2734_;
                                let _e1463 = phi_2735_;
                                let _e1465 = phi_2736_;
                                phi_3266_ = _e1455;
                                phi_3209_ = _e1457;
                                phi_2737_ = _e1459;
                                phi_2738_ = _e1461;
                                phi_2739_ = _e1463;
                                phi_2740_ = _e1465;
                            } else {
                                phi_3266_ = _e570;
                                phi_3209_ = _e568;
                                phi_2737_ = bool();
                                phi_2738_ = u32();
                                phi_2739_ = u32();
                                phi_2740_ = u32();
                            }
                            let _e1467 = phi_3266_;
                            let _e1469 = phi_3209_;
                            let _e1471 = phi_2737_;
                            let _e1473 = phi_2738_;
                            let _e1475 = phi_2739_;
                            let _e1477 = phi_2740_;
                            phi_3265_ = _e1467;
                            phi_3208_ = _e1469;
                            phi_1036_ = _e1471;
                            phi_1039_ = _e1473;
                            phi_1041_ = _e1475;
                            phi_1043_ = _e1477;
                            phi_2741_ = _e582;
                        } else {
                            phi_3265_ = _e570;
                            phi_3208_ = _e568;
                            phi_1036_ = bool();
                            phi_1039_ = u32();
                            phi_1041_ = u32();
                            phi_1043_ = u32();
                            phi_2741_ = false;
                        }
                        let _e1479 = phi_3265_;
                        let _e1481 = phi_3208_;
                        let _e1483 = phi_1036_;
                        let _e1485 = phi_1039_;
                        let _e1487 = phi_1041_;
                        let _e1489 = phi_1043_;
                        let _e1491 = phi_2741_;
                        continue;
                        continuing {
                            phi_3054_ = _e1481;
                            phi_3035_ = _e1479;
                            phi_1035_ = _e1483;
                            phi_1038_ = _e1485;
                            phi_1040_ = _e1487;
                            phi_1042_ = _e1489;
                            phi_3207_ = _e1481;
                            break if !(_e1491);
                        }
                    }
                    let _e1494 = phi_3207_;
                    if _e1494 {
                        break;
                    }
                    phi_2748_ = type_4(0u, 8u);
                    loop {
                        let _e1496 = phi_2748_;
                        if (_e1496.member < _e1496.member_1) {
                            phi_2749_ = type_4((_e1496.member + 1u), _e1496.member_1);
                            phi_2772_ = type_4(1u, _e1496.member);
                        } else {
                            phi_2749_ = _e1496;
                            phi_2772_ = type_4(0u, type_4().member_1);
                        }
                        let _e1509 = phi_2749_;
                        let _e1511 = phi_2772_;
                        let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                        if _e1515 {
                            let _e1516 = (_e1511.member_1 < 8u);
                            if _e1516 {
                            } else {
                                phi_3247_ = true;
                                break;
                            }
                            let _e1518 = local[_e1511.member_1];
                            if (_e1518.member_3 != 4294967295u) {
                                let _e1524 = -(_e463);
                                let _e1525 = bitcast<u32>(_e1518.member);
                                let _e1529 = (bitcast<i32>((_e1525 >> bitcast<u32>(23i))) & 255i);
                                let _e1530 = (_e1529 + _e1524);
                                if (_e1529 == 255i) {
                                    phi_2845_ = _e1518.member;
                                } else {
                                    if (_e1529 > 0i) {
                                        if (_e1530 > 0i) {
                                            let _e1534 = (_e1530 < 255i);
                                            if _e1534 {
                                                phi_2824_ = bitcast<f32>((_e1525 + bitcast<u32>((_e1524 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_2824_ = f32();
                                            }
                                            let _e1541 = phi_2824_;
                                            phi_2826_ = _e1541;
                                            phi_2827_ = select(true, false, _e1534);
                                        } else {
                                            phi_2826_ = f32();
                                            phi_2827_ = true;
                                        }
                                        let _e1544 = phi_2826_;
                                        let _e1546 = phi_2827_;
                                        phi_2828_ = _e1544;
                                        phi_2829_ = _e1546;
                                    } else {
                                        phi_2828_ = f32();
                                        phi_2829_ = true;
                                    }
                                    let _e1548 = phi_2828_;
                                    let _e1550 = phi_2829_;
                                    if _e1550 {
                                        let _e1551 = (_e1525 & 2147483648u);
                                        let _e1558 = ((_e1525 & 8388607u) | (select(0u, 1u, ((_e1525 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1562 = (_e1558 == 0u);
                                        if _e1562 {
                                            phi_3018_ = bitcast<f32>(_e1551);
                                        } else {
                                            let _e1567 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1558)), 32u, _e1562) - 8u);
                                            let _e1570 = (_e1558 << bitcast<u32>((_e1567 & 31u)));
                                            let _e1572 = ((_e1530 + select(0i, 1i, (_e1529 == 0i))) - bitcast<i32>(_e1567));
                                            if (_e1572 >= 255i) {
                                                phi_3008_ = bitcast<f32>((_e1551 | 2139095040u));
                                                phi_3009_ = f32();
                                                phi_3010_ = true;
                                            } else {
                                                let _e1574 = (_e1572 > 0i);
                                                if _e1574 {
                                                    phi_3002_ = bitcast<f32>(((_e1551 | (bitcast<u32>(_e1572) << bitcast<u32>(23i))) | (_e1570 & 8388607u)));
                                                    phi_3003_ = f32();
                                                } else {
                                                    if (_e1572 < -24i) {
                                                        phi_2968_ = 26u;
                                                    } else {
                                                        phi_2968_ = bitcast<u32>((1i - _e1572));
                                                    }
                                                    let _e1579 = phi_2968_;
                                                    let _e1580 = (_e1579 & 31u);
                                                    let _e1582 = (_e1570 >> bitcast<u32>(_e1580));
                                                    let _e1586 = (_e1570 & ((1u << bitcast<u32>(_e1580)) - 1u));
                                                    let _e1590 = (1u << bitcast<u32>(((_e1579 - 1u) & 31u)));
                                                    if (_e1586 > _e1590) {
                                                        phi_2989_ = true;
                                                    } else {
                                                        if (_e1586 == _e1590) {
                                                            phi_2986_ = ((_e1582 & 1u) == 1u);
                                                        } else {
                                                            phi_2986_ = false;
                                                        }
                                                        let _e1596 = phi_2986_;
                                                        phi_2989_ = _e1596;
                                                    }
                                                    let _e1598 = phi_2989_;
                                                    phi_3002_ = f32();
                                                    phi_3003_ = bitcast<f32>((_e1551 | (_e1582 + select(0u, 1u, _e1598))));
                                                }
                                                let _e1611 = phi_3002_;
                                                let _e1613 = phi_3003_;
                                                phi_3008_ = _e1611;
                                                phi_3009_ = _e1613;
                                                phi_3010_ = _e1574;
                                            }
                                            let _e1617 = phi_3008_;
                                            let _e1619 = phi_3009_;
                                            let _e1621 = phi_3010_;
                                            phi_3018_ = select(_e1619, _e1617, _e1621);
                                        }
                                        let _e1625 = phi_3018_;
                                        phi_2844_ = _e1625;
                                    } else {
                                        phi_2844_ = _e1548;
                                    }
                                    let _e1627 = phi_2844_;
                                    phi_2845_ = _e1627;
                                }
                                let _e1629 = phi_2845_;
                                let _e1630 = bitcast<u32>(_e1629);
                                if ((_e1630 & 2147483647u) >= 2139095040u) {
                                    phi_2857_ = bitcast<f32>(((_e1630 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_2857_ = _e1629;
                                }
                                let _e1637 = phi_2857_;
                                phi_2862_ = type_23(_e1637, _e1518.member_1, _e1518.member_2, _e1518.member_3);
                            } else {
                                phi_2862_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1640 = phi_2862_;
                            if _e1516 {
                            } else {
                                phi_3247_ = true;
                                break;
                            }
                            local[_e1511.member_1] = type_23(_e1640.member, _e1640.member_1, _e1640.member_2, _e1640.member_3);
                        }
                        continue;
                        continuing {
                            phi_2748_ = _e1509;
                            phi_3247_ = _e1494;
                            break if !(_e1515);
                        }
                    }
                    let _e1648 = phi_3247_;
                    if _e1648 {
                        break;
                    }
                    let _e1649 = local;
                    if _e94 {
                    } else {
                        break;
                    }
                    global_5.member[_e88] = array<type_23, 8>(type_23(_e1649[0].member, _e1649[0].member_1, _e1649[0].member_2, _e1649[0].member_3), type_23(_e1649[1].member, _e1649[1].member_1, _e1649[1].member_2, _e1649[1].member_3), type_23(_e1649[2].member, _e1649[2].member_1, _e1649[2].member_2, _e1649[2].member_3), type_23(_e1649[3].member, _e1649[3].member_1, _e1649[3].member_2, _e1649[3].member_3), type_23(_e1649[4].member, _e1649[4].member_1, _e1649[4].member_2, _e1649[4].member_3), type_23(_e1649[5].member, _e1649[5].member_1, _e1649[5].member_2, _e1649[5].member_3), type_23(_e1649[6].member, _e1649[6].member_1, _e1649[6].member_2, _e1649[6].member_3), type_23(_e1649[7].member, _e1649[7].member_1, _e1649[7].member_2, _e1649[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
