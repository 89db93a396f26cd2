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
    var phi_3055_: bool;
    var phi_3036_: f32;
    var phi_1033_: u32;
    var phi_1036_: bool;
    var phi_1038_: u32;
    var phi_1040_: u32;
    var phi_1051_: bool;
    var phi_1084_: bool;
    var phi_1085_: u32;
    var phi_1086_: u32;
    var phi_3052_: bool;
    var phi_3041_: f32;
    var phi_1101_: type_4;
    var phi_1102_: type_4;
    var phi_1125_: type_4;
    var phi_1146_: u32;
    var phi_1238_: array<array<f32, 3>, 3>;
    var phi_1391_: bool;
    var phi_1420_: bool;
    var phi_1839_: f32;
    var phi_1840_: f32;
    var phi_1841_: f32;
    var phi_1842_: f32;
    var phi_1843_: vec3<f32>;
    var phi_1844_: vec3<f32>;
    var phi_1845_: vec3<f32>;
    var phi_1846_: vec3<f32>;
    var phi_1883_: bool;
    var phi_1892_: vec3<f32>;
    var phi_2057_: f32;
    var phi_2059_: f32;
    var phi_2060_: bool;
    var phi_2080_: f32;
    var phi_2081_: f32;
    var phi_2104_: type_23;
    var phi_2106_: type_23;
    var phi_2107_: bool;
    var phi_2111_: type_23;
    var phi_2112_: type_23;
    var phi_2113_: type_23;
    var phi_2114_: bool;
    var phi_2118_: type_23;
    var phi_2119_: bool;
    var phi_2120_: type_23;
    var phi_2121_: bool;
    var phi_2122_: bool;
    var phi_2123_: type_23;
    var phi_2124_: bool;
    var phi_2125_: bool;
    var phi_2133_: type_23;
    var phi_2134_: bool;
    var phi_2138_: type_23;
    var phi_2150_: type_4;
    var phi_2153_: type_23;
    var phi_2151_: type_4;
    var phi_2176_: type_4;
    var phi_2208_: bool;
    var phi_2209_: bool;
    var phi_2230_: type_23;
    var phi_2154_: type_23;
    var phi_3043_: bool;
    var phi_3301_: f32;
    var phi_3300_: f32;
    var phi_3206_: bool;
    var phi_3299_: f32;
    var phi_3205_: bool;
    var phi_3298_: f32;
    var phi_3204_: bool;
    var phi_3210_: f32;
    var phi_3203_: bool;
    var phi_3337_: bool;
    var phi_3209_: f32;
    var phi_2306_: type_39;
    var phi_2669_: u32;
    var phi_2696_: u32;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_2700_: u32;
    var phi_2701_: u32;
    var phi_2702_: bool;
    var phi_2711_: u32;
    var phi_2716_: bool;
    var phi_2718_: u32;
    var phi_2722_: bool;
    var phi_2723_: u32;
    var phi_2724_: u32;
    var phi_3364_: f32;
    var phi_3305_: bool;
    var phi_2735_: u32;
    var phi_2736_: bool;
    var phi_2737_: u32;
    var phi_2738_: u32;
    var phi_3363_: f32;
    var phi_3304_: bool;
    var phi_2739_: u32;
    var phi_2740_: bool;
    var phi_2741_: u32;
    var phi_2742_: u32;
    var phi_3362_: f32;
    var phi_3303_: bool;
    var phi_1034_: u32;
    var phi_1037_: bool;
    var phi_1039_: u32;
    var phi_1041_: u32;
    var phi_2743_: bool;
    var phi_3302_: bool;
    var phi_2750_: type_4;
    var phi_2751_: type_4;
    var phi_2774_: type_4;
    var phi_2826_: f32;
    var phi_2828_: f32;
    var phi_2829_: bool;
    var phi_2830_: f32;
    var phi_2831_: bool;
    var phi_2970_: u32;
    var phi_2988_: bool;
    var phi_2991_: bool;
    var phi_3004_: f32;
    var phi_3005_: f32;
    var phi_3010_: f32;
    var phi_3011_: f32;
    var phi_3012_: bool;
    var phi_3020_: f32;
    var phi_2846_: f32;
    var phi_2847_: f32;
    var phi_2859_: f32;
    var phi_2864_: type_23;
    var phi_3344_: bool;

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
                    phi_3055_ = false;
                    phi_3036_ = _e559;
                    phi_1033_ = ((3u * _e78) + 1u);
                    phi_1036_ = (_e561 <= _e559);
                    phi_1038_ = 0u;
                    phi_1040_ = select(0u, 2147483648u, (_e78 == 0u));
                    loop {
                        let _e568 = phi_3055_;
                        let _e570 = phi_3036_;
                        let _e572 = phi_1033_;
                        let _e574 = phi_1036_;
                        let _e576 = phi_1038_;
                        let _e578 = phi_1040_;
                        if _e574 {
                            phi_1051_ = true;
                        } else {
                            phi_1051_ = (_e576 > 0u);
                        }
                        let _e581 = phi_1051_;
                        if _e581 {
                            let _e582 = (_e572 > 0u);
                            if _e582 {
                                if _e574 {
                                    phi_1084_ = _e574;
                                    phi_1085_ = _e576;
                                    phi_1086_ = _e578;
                                } else {
                                    let _e583 = (_e576 - 1u);
                                    let _e584 = (_e583 % 128u);
                                    let _e585 = (_e584 < 128u);
                                    if _e585 {
                                    } else {
                                        phi_3302_ = true;
                                        break;
                                    }
                                    let _e587 = local_2[_e584];
                                    if _e585 {
                                    } else {
                                        phi_3302_ = true;
                                        break;
                                    }
                                    let _e589 = local_1[_e584];
                                    phi_1084_ = (_e589 <= _e570);
                                    phi_1085_ = _e583;
                                    phi_1086_ = _e587;
                                }
                                let _e592 = phi_1084_;
                                let _e594 = phi_1085_;
                                let _e596 = phi_1086_;
                                if _e592 {
                                    let _e599 = ((_e596 & 2147483648u) != 0u);
                                    if _e599 {
                                        phi_3052_ = _e568;
                                        phi_3041_ = _e570;
                                        phi_1101_ = type_4(0u, ((_e596 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e606 = phi_3052_;
                                            let _e608 = phi_3041_;
                                            let _e610 = phi_1101_;
                                            if (_e610.member < _e610.member_1) {
                                                phi_1102_ = type_4((_e610.member + 1u), _e610.member_1);
                                                phi_1125_ = type_4(1u, _e610.member);
                                            } else {
                                                phi_1102_ = _e610;
                                                phi_1125_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e623 = phi_1102_;
                                            let _e625 = phi_1125_;
                                            let _e629 = (bitcast<i32>(_e625.member) != 0i);
                                            if _e629 {
                                                let _e630 = ((_e596 & 268435455u) + _e625.member_1);
                                                let _e631 = (_e630 < _e80);
                                                if _e631 {
                                                    if _e631 {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e635 = global_3.member[_e630].member_1;
                                                    phi_1146_ = _e635;
                                                } else {
                                                    phi_1146_ = 4294967295u;
                                                }
                                                let _e637 = phi_1146_;
                                                if (_e630 >= _e80) {
                                                    phi_1238_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e631 {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e639 = (_e206 % 3u);
                                                    let _e640 = (_e205 % 3u);
                                                    let _e641 = (_e207 % 3u);
                                                    if (_e639 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e647 = global_3.member[_e630].member[_e639];
                                                    if (_e640 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e653 = global_3.member[_e630].member[_e640];
                                                    if (_e641 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e659 = global_3.member[_e630].member[_e641];
                                                    let _e661 = (3u + _e639);
                                                    if (_e661 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e667 = global_3.member[_e630].member[_e661];
                                                    let _e668 = (3u + _e640);
                                                    if (_e668 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e674 = global_3.member[_e630].member[_e668];
                                                    let _e675 = (3u + _e641);
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_3.member[_e630].member[_e675];
                                                    let _e683 = (6u + _e639);
                                                    if (_e683 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e689 = global_3.member[_e630].member[_e683];
                                                    let _e690 = (6u + _e640);
                                                    if (_e690 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e696 = global_3.member[_e630].member[_e690];
                                                    let _e697 = (6u + _e641);
                                                    if (_e697 < 9u) {
                                                    } else {
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_3.member[_e630].member[_e697];
                                                    phi_1238_ = array<array<f32, 3>, 3>(array<f32, 3>(_e647, _e653, _e659), array<f32, 3>(_e667, _e674, _e681), array<f32, 3>(_e689, _e696, _e703));
                                                }
                                                let _e707 = phi_1238_;
                                                let _e714 = (_e707[0][2] - _e407);
                                                let _e717 = (((_e707[0][0] - _e270) * _e446) - (_e714 * _e310));
                                                let _e720 = (((_e707[0][1] - _e339) * _e446) - (_e714 * _e378));
                                                let _e727 = (_e707[1][2] - _e407);
                                                let _e730 = (((_e707[1][0] - _e270) * _e446) - (_e727 * _e310));
                                                let _e733 = (((_e707[1][1] - _e339) * _e446) - (_e727 * _e378));
                                                let _e740 = (_e707[2][2] - _e407);
                                                let _e743 = (((_e707[2][0] - _e270) * _e446) - (_e740 * _e310));
                                                let _e746 = (((_e707[2][1] - _e339) * _e446) - (_e740 * _e378));
                                                let _e747 = (_e743 * _e733);
                                                let _e748 = (_e746 * _e730);
                                                let _e749 = (_e717 * _e746);
                                                let _e750 = (_e720 * _e743);
                                                let _e751 = (_e730 * _e720);
                                                let _e752 = (_e733 * _e717);
                                                let _e757 = (((_e747 >= _e748) && (_e749 >= _e750)) && (_e751 >= _e752));
                                                if (_e757 || (((_e747 <= _e748) && (_e749 <= _e750)) && (_e751 <= _e752))) {
                                                    let _e764 = select(-1f, 1f, _e757);
                                                    let _e766 = ((_e747 - _e748) * _e764);
                                                    let _e768 = select(0f, _e766, (_e766 > 0f));
                                                    let _e770 = ((_e749 - _e750) * _e764);
                                                    let _e772 = select(0f, _e770, (_e770 > 0f));
                                                    let _e774 = ((_e751 - _e752) * _e764);
                                                    let _e776 = select(0f, _e774, (_e774 > 0f));
                                                    let _e778 = ((_e768 + _e772) + _e776);
                                                    if (_e778 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2123_ = type_23();
                                                        phi_2124_ = true;
                                                        phi_2125_ = false;
                                                    } else {
                                                        let _e781 = select(_e730, _e717, (_e717 < _e730));
                                                        if (select(_e743, _e781, (_e781 < _e743)) > 0f) {
                                                            phi_1391_ = true;
                                                        } else {
                                                            let _e786 = select(_e730, _e717, (_e717 > _e730));
                                                            phi_1391_ = (select(_e743, _e786, (_e786 > _e743)) < 0f);
                                                        }
                                                        let _e791 = phi_1391_;
                                                        if _e791 {
                                                            phi_2120_ = type_23();
                                                            phi_2121_ = true;
                                                            phi_2122_ = false;
                                                        } else {
                                                            let _e793 = select(_e733, _e720, (_e720 < _e733));
                                                            if (select(_e746, _e793, (_e793 < _e746)) > 0f) {
                                                                phi_1420_ = true;
                                                            } else {
                                                                let _e798 = select(_e733, _e720, (_e720 > _e733));
                                                                phi_1420_ = (select(_e746, _e798, (_e798 > _e746)) < 0f);
                                                            }
                                                            let _e803 = phi_1420_;
                                                            if _e803 {
                                                                phi_2118_ = type_23();
                                                                phi_2119_ = false;
                                                            } else {
                                                                let _e805 = select(_e707[1][0], _e707[0][0], (_e707[0][0] < _e707[1][0]));
                                                                let _e809 = select(_e707[1][0], _e707[0][0], (_e707[0][0] > _e707[1][0]));
                                                                let _e813 = select(_e707[1][1], _e707[0][1], (_e707[0][1] < _e707[1][1]));
                                                                let _e817 = select(_e707[1][1], _e707[0][1], (_e707[0][1] > _e707[1][1]));
                                                                let _e821 = select(_e707[1][2], _e707[0][2], (_e707[0][2] < _e707[1][2]));
                                                                let _e825 = select(_e707[1][2], _e707[0][2], (_e707[0][2] > _e707[1][2]));
                                                                let _e830 = ((select(_e707[2][0], _e805, (_e805 < _e707[2][0])) - _e308) * _e313);
                                                                let _e831 = ((select(_e707[2][0], _e809, (_e809 > _e707[2][0])) - _e309) * _e313);
                                                                let _e834 = ((select(_e707[2][1], _e813, (_e813 < _e707[2][1])) - _e376) * _e381);
                                                                let _e835 = ((select(_e707[2][1], _e817, (_e817 > _e707[2][1])) - _e377) * _e381);
                                                                let _e838 = ((select(_e707[2][2], _e821, (_e821 < _e707[2][2])) - _e444) * _e449);
                                                                let _e839 = ((select(_e707[2][2], _e825, (_e825 > _e707[2][2])) - _e445) * _e449);
                                                                let _e841 = select(_e839, _e838, (_e838 < _e839));
                                                                let _e843 = select(_e839, _e838, (_e838 > _e839));
                                                                let _e845 = select(_e831, _e830, (_e830 < _e831));
                                                                let _e847 = select(_e835, _e834, (_e834 < _e835));
                                                                let _e849 = select(_e847, _e845, (_e845 > _e847));
                                                                let _e851 = select(_e841, _e849, (_e849 > _e841));
                                                                let _e853 = select(_e831, _e830, (_e830 > _e831));
                                                                let _e855 = select(_e835, _e834, (_e834 > _e835));
                                                                let _e857 = select(_e855, _e853, (_e853 < _e855));
                                                                let _e859 = select(_e843, _e857, (_e857 < _e843));
                                                                let _e860 = -(_e841);
                                                                let _e866 = select(_e561, _e851, (_e851 > _e561));
                                                                if (_e866 > (_e859 + (select(_e860, _e843, (_e843 > _e860)) * 0.0000019073523f))) {
                                                                    phi_2113_ = type_23();
                                                                    phi_2114_ = true;
                                                                } else {
                                                                    let _e868 = (_e866 > _e608);
                                                                    if _e868 {
                                                                        phi_2112_ = type_23();
                                                                    } else {
                                                                        let _e869 = vec3<f32>(_e707[0][0], _e707[0][1], _e707[0][2]);
                                                                        let _e870 = vec3<f32>(_e707[1][0], _e707[1][1], _e707[1][2]);
                                                                        let _e871 = vec3<f32>(_e707[2][0], _e707[2][1], _e707[2][2]);
                                                                        let _e872 = (_e707[1][0] - _e707[0][0]);
                                                                        let _e873 = (_e707[1][1] - _e707[0][1]);
                                                                        let _e874 = (_e707[1][2] - _e707[0][2]);
                                                                        let _e875 = vec3<f32>(_e872, _e873, _e874);
                                                                        let _e876 = (_e707[2][0] - _e707[1][0]);
                                                                        let _e877 = (_e707[2][1] - _e707[1][1]);
                                                                        let _e878 = (_e707[2][2] - _e707[1][2]);
                                                                        let _e879 = vec3<f32>(_e876, _e877, _e878);
                                                                        let _e880 = (_e707[0][0] - _e707[2][0]);
                                                                        let _e881 = (_e707[0][1] - _e707[2][1]);
                                                                        let _e882 = (_e707[0][2] - _e707[2][2]);
                                                                        let _e883 = vec3<f32>(_e880, _e881, _e882);
                                                                        let _e886 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                        let _e889 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                        let _e891 = select(_e889, _e886, (_e886 > _e889));
                                                                        let _e894 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                        let _e896 = select(_e894, _e891, (_e891 > _e894));
                                                                        let _e899 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                        let _e902 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                        let _e904 = select(_e902, _e899, (_e899 > _e902));
                                                                        let _e907 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                        let _e909 = select(_e907, _e904, (_e904 > _e907));
                                                                        let _e912 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                        let _e915 = bitcast<f32>((bitcast<u32>(_e881) & 2147483647u));
                                                                        let _e917 = select(_e915, _e912, (_e912 > _e915));
                                                                        let _e920 = bitcast<f32>((bitcast<u32>(_e882) & 2147483647u));
                                                                        let _e922 = select(_e920, _e917, (_e917 > _e920));
                                                                        let _e924 = select(_e909, _e896, (_e896 > _e909));
                                                                        let _e926 = select(_e922, _e924, (_e924 > _e922));
                                                                        if (_e896 == _e926) {
                                                                            phi_1839_ = _e733;
                                                                            phi_1840_ = _e730;
                                                                            phi_1841_ = _e720;
                                                                            phi_1842_ = _e717;
                                                                            phi_1843_ = _e869;
                                                                            phi_1844_ = _e883;
                                                                            phi_1845_ = _e879;
                                                                            phi_1846_ = _e875;
                                                                        } else {
                                                                            let _e928 = (_e909 == _e926);
                                                                            let _e933 = vec3(_e928);
                                                                            phi_1839_ = select(_e720, _e746, _e928);
                                                                            phi_1840_ = select(_e717, _e743, _e928);
                                                                            phi_1841_ = select(_e746, _e733, _e928);
                                                                            phi_1842_ = select(_e743, _e730, _e928);
                                                                            phi_1843_ = select(_e871, _e870, _e933);
                                                                            phi_1844_ = select(_e879, _e875, _e933);
                                                                            phi_1845_ = select(_e875, _e883, _e933);
                                                                            phi_1846_ = select(_e883, _e879, _e933);
                                                                        }
                                                                        let _e939 = phi_1839_;
                                                                        let _e941 = phi_1840_;
                                                                        let _e943 = phi_1841_;
                                                                        let _e945 = phi_1842_;
                                                                        let _e947 = phi_1843_;
                                                                        let _e949 = phi_1844_;
                                                                        let _e951 = phi_1845_;
                                                                        let _e953 = phi_1846_;
                                                                        let _e960 = ((_e951.y * _e949.z) - (_e949.y * _e951.z));
                                                                        let _e965 = ((_e951.z * _e949.x) - (_e949.z * _e951.x));
                                                                        let _e968 = ((_e951.x * _e949.y) - (_e949.x * _e951.y));
                                                                        if (_e768 >= _e772) {
                                                                            phi_1883_ = select(true, false, (_e768 >= _e776));
                                                                        } else {
                                                                            phi_1883_ = true;
                                                                        }
                                                                        let _e973 = phi_1883_;
                                                                        if _e973 {
                                                                            phi_1892_ = select(_e871, _e870, vec3((_e772 >= _e776)));
                                                                        } else {
                                                                            phi_1892_ = _e869;
                                                                        }
                                                                        let _e978 = phi_1892_;
                                                                        let _e989 = (((_e960 * (_e978.x - _e270)) + (_e965 * (_e978.y - _e339))) + (_e968 * (_e978.z - _e407)));
                                                                        let _e994 = (((_e960 * _e310) + (_e965 * _e378)) + (_e968 * _e446));
                                                                        let _e995 = (_e941 - _e945);
                                                                        let _e996 = (_e939 - _e943);
                                                                        let _e1004 = (-(((_e945 * _e995) + (_e943 * _e996))) / ((_e995 * _e995) + (_e996 * _e996)));
                                                                        let _e1006 = select(1f, _e1004, (_e1004 < 1f));
                                                                        let _e1008 = select(0f, _e1006, (_e1006 > 0f));
                                                                        let _e1021 = ((_e947.x + (_e953.x * _e1008)) - _e270);
                                                                        let _e1022 = ((_e947.y + (_e953.y * _e1008)) - _e339);
                                                                        let _e1023 = ((_e947.z + (_e953.z * _e1008)) - _e407);
                                                                        let _e1024 = (_e1023 / _e446);
                                                                        let _e1036 = bitcast<f32>((bitcast<u32>(_e1021) & 2147483647u));
                                                                        let _e1039 = bitcast<f32>((bitcast<u32>(_e1022) & 2147483647u));
                                                                        let _e1041 = select(_e1039, _e1036, (_e1036 > _e1039));
                                                                        let _e1044 = bitcast<f32>((bitcast<u32>(_e1023) & 2147483647u));
                                                                        let _e1046 = select(_e1044, _e1041, (_e1041 > _e1044));
                                                                        let _e1052 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                        let _e1055 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                        let _e1057 = select(_e1055, _e1052, (_e1052 > _e1055));
                                                                        let _e1060 = bitcast<f32>((bitcast<u32>(_e968) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e960 * _e1021) + (_e965 * _e1022)) + (_e968 * _e1023)) - _e989)) & 2147483647u)) <= ((0.0000009536743f * select(_e926, _e1046, (_e1046 > _e926))) * select(_e1060, _e1057, (_e1057 > _e1060)))) {
                                                                            let _e1070 = bitcast<f32>((bitcast<u32>(_e951.x) & 2147483647u));
                                                                            let _e1073 = bitcast<f32>((bitcast<u32>(_e951.y) & 2147483647u));
                                                                            let _e1075 = select(_e1073, _e1070, (_e1070 > _e1073));
                                                                            let _e1078 = bitcast<f32>((bitcast<u32>(_e951.z) & 2147483647u));
                                                                            let _e1084 = bitcast<f32>((bitcast<u32>(_e949.x) & 2147483647u));
                                                                            let _e1087 = bitcast<f32>((bitcast<u32>(_e949.y) & 2147483647u));
                                                                            let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                                            let _e1092 = bitcast<f32>((bitcast<u32>(_e949.z) & 2147483647u));
                                                                            let _e1096 = (bitcast<f32>((bitcast<u32>(_e994) & 2147483647u)) > ((0.0000038146973f * select(_e1078, _e1075, (_e1075 > _e1078))) * select(_e1092, _e1089, (_e1089 > _e1092))));
                                                                            if _e1096 {
                                                                                phi_2057_ = (_e989 / _e994);
                                                                            } else {
                                                                                phi_2057_ = f32();
                                                                            }
                                                                            let _e1099 = phi_2057_;
                                                                            phi_2059_ = _e1099;
                                                                            phi_2060_ = select(true, false, _e1096);
                                                                        } else {
                                                                            phi_2059_ = f32();
                                                                            phi_2060_ = true;
                                                                        }
                                                                        let _e1102 = phi_2059_;
                                                                        let _e1104 = phi_2060_;
                                                                        if _e1104 {
                                                                            let _e1112 = (((_e960 * (_e1021 - (_e310 * _e1024))) + (_e965 * (_e1022 - (_e378 * _e1024)))) / _e994);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u)) <= _e926) {
                                                                                phi_2080_ = (_e1024 + _e1112);
                                                                            } else {
                                                                                phi_2080_ = _e1024;
                                                                            }
                                                                            let _e1119 = phi_2080_;
                                                                            phi_2081_ = _e1119;
                                                                        } else {
                                                                            phi_2081_ = _e1102;
                                                                        }
                                                                        let _e1121 = phi_2081_;
                                                                        let _e1123 = select(_e859, _e1121, (_e1121 < _e859));
                                                                        let _e1125 = select(_e851, _e1123, (_e1123 > _e851));
                                                                        if (_e1125 >= _e561) {
                                                                            let _e1127 = (_e1125 <= _e608);
                                                                            if _e1127 {
                                                                                let _e1128 = (1f / _e778);
                                                                                phi_2104_ = type_23(_e1125, (_e772 * _e1128), (_e776 * _e1128), _e637);
                                                                            } else {
                                                                                phi_2104_ = type_23();
                                                                            }
                                                                            let _e1133 = phi_2104_;
                                                                            phi_2106_ = _e1133;
                                                                            phi_2107_ = select(true, false, _e1127);
                                                                        } else {
                                                                            phi_2106_ = type_23();
                                                                            phi_2107_ = true;
                                                                        }
                                                                        let _e1136 = phi_2106_;
                                                                        let _e1138 = phi_2107_;
                                                                        if _e1138 {
                                                                            phi_2111_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2111_ = _e1136;
                                                                        }
                                                                        let _e1140 = phi_2111_;
                                                                        phi_2112_ = _e1140;
                                                                    }
                                                                    let _e1142 = phi_2112_;
                                                                    phi_2113_ = _e1142;
                                                                    phi_2114_ = _e868;
                                                                }
                                                                let _e1144 = phi_2113_;
                                                                let _e1146 = phi_2114_;
                                                                phi_2118_ = _e1144;
                                                                phi_2119_ = _e1146;
                                                            }
                                                            let _e1148 = phi_2118_;
                                                            let _e1150 = phi_2119_;
                                                            phi_2120_ = _e1148;
                                                            phi_2121_ = _e803;
                                                            phi_2122_ = _e1150;
                                                        }
                                                        let _e1152 = phi_2120_;
                                                        let _e1154 = phi_2121_;
                                                        let _e1156 = phi_2122_;
                                                        phi_2123_ = _e1152;
                                                        phi_2124_ = _e1154;
                                                        phi_2125_ = _e1156;
                                                    }
                                                    let _e1158 = phi_2123_;
                                                    let _e1160 = phi_2124_;
                                                    let _e1162 = phi_2125_;
                                                    phi_2133_ = _e1158;
                                                    phi_2134_ = select(_e1162, true, _e1160);
                                                } else {
                                                    phi_2133_ = type_23();
                                                    phi_2134_ = true;
                                                }
                                                let _e1165 = phi_2133_;
                                                let _e1167 = phi_2134_;
                                                if _e1167 {
                                                    phi_2138_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2138_ = _e1165;
                                                }
                                                let _e1169 = phi_2138_;
                                                if (_e1169.member_3 != 4294967295u) {
                                                    if (_e637 != 4294967295u) {
                                                        phi_2150_ = type_4(0u, 8u);
                                                        phi_2153_ = _e1169;
                                                        loop {
                                                            let _e1174 = phi_2150_;
                                                            let _e1176 = phi_2153_;
                                                            if (_e1174.member < _e1174.member_1) {
                                                                phi_2151_ = type_4((_e1174.member + 1u), _e1174.member_1);
                                                                phi_2176_ = type_4(1u, _e1174.member);
                                                            } else {
                                                                phi_2151_ = _e1174;
                                                                phi_2176_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1189 = phi_2151_;
                                                            let _e1191 = phi_2176_;
                                                            let _e1195 = (bitcast<i32>(_e1191.member) != 0i);
                                                            if _e1195 {
                                                                let _e1196 = (_e1191.member_1 < 8u);
                                                                if _e1196 {
                                                                } else {
                                                                    phi_3043_ = true;
                                                                    break;
                                                                }
                                                                let _e1201 = local[_e1191.member_1].member;
                                                                if (_e1176.member < _e1201) {
                                                                    phi_2209_ = true;
                                                                } else {
                                                                    let _e1203 = local[_e1191.member_1].member;
                                                                    if (_e1176.member == _e1203) {
                                                                        let _e1208 = local[_e1191.member_1].member_3;
                                                                        phi_2208_ = (_e1176.member_3 < _e1208);
                                                                    } else {
                                                                        phi_2208_ = false;
                                                                    }
                                                                    let _e1211 = phi_2208_;
                                                                    phi_2209_ = _e1211;
                                                                }
                                                                let _e1213 = phi_2209_;
                                                                if _e1213 {
                                                                    if _e1196 {
                                                                    } else {
                                                                        phi_3043_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1214 = local[_e1191.member_1];
                                                                    local[_e1191.member_1] = type_23(_e1176.member, _e1176.member_1, _e1176.member_2, _e1176.member_3);
                                                                    phi_2230_ = type_23(_e1214.member, _e1214.member_1, _e1214.member_2, _e1214.member_3);
                                                                } else {
                                                                    phi_2230_ = _e1176;
                                                                }
                                                                let _e1225 = phi_2230_;
                                                                phi_2154_ = _e1225;
                                                            } else {
                                                                phi_2154_ = type_23();
                                                            }
                                                            let _e1227 = phi_2154_;
                                                            continue;
                                                            continuing {
                                                                phi_2150_ = _e1189;
                                                                phi_2153_ = _e1227;
                                                                phi_3043_ = _e606;
                                                                break if !(_e1195);
                                                            }
                                                        }
                                                        let _e1230 = phi_3043_;
                                                        phi_3210_ = _e608;
                                                        phi_3203_ = _e1230;
                                                        if _e1230 {
                                                            break;
                                                        }
                                                        let _e1233 = local[7u].member_3;
                                                        if (_e1233 != 4294967295u) {
                                                            let _e1237 = local[7u].member;
                                                            phi_3301_ = _e1237;
                                                        } else {
                                                            phi_3301_ = _e608;
                                                        }
                                                        let _e1239 = phi_3301_;
                                                        phi_3300_ = _e1239;
                                                        phi_3206_ = _e1230;
                                                    } else {
                                                        phi_3300_ = _e608;
                                                        phi_3206_ = _e606;
                                                    }
                                                    let _e1241 = phi_3300_;
                                                    let _e1243 = phi_3206_;
                                                    phi_3299_ = _e1241;
                                                    phi_3205_ = _e1243;
                                                } else {
                                                    phi_3299_ = _e608;
                                                    phi_3205_ = _e606;
                                                }
                                                let _e1245 = phi_3299_;
                                                let _e1247 = phi_3205_;
                                                phi_3298_ = _e1245;
                                                phi_3204_ = _e1247;
                                            } else {
                                                phi_3298_ = _e608;
                                                phi_3204_ = _e606;
                                            }
                                            let _e1249 = phi_3298_;
                                            let _e1251 = phi_3204_;
                                            continue;
                                            continuing {
                                                phi_3052_ = _e1251;
                                                phi_3041_ = _e1249;
                                                phi_1101_ = _e623;
                                                phi_3210_ = _e1249;
                                                phi_3203_ = _e1251;
                                                break if !(_e629);
                                            }
                                        }
                                        let _e1254 = phi_3210_;
                                        let _e1256 = phi_3203_;
                                        phi_3302_ = _e1256;
                                        if _e1256 {
                                            break;
                                        }
                                        phi_3337_ = _e1256;
                                        phi_3209_ = _e1254;
                                    } else {
                                        phi_3337_ = _e568;
                                        phi_3209_ = _e570;
                                    }
                                    let _e1258 = phi_3337_;
                                    let _e1260 = phi_3209_;
                                    if _e599 {
                                        phi_2722_ = bool();
                                        phi_2723_ = u32();
                                        phi_2724_ = u32();
                                    } else {
                                        if (_e596 >= _e78) {
                                            phi_2306_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e596 < _e78) {
                                            } else {
                                                phi_3302_ = true;
                                                break;
                                            }
                                            let _e1263 = (_e206 % 3u);
                                            if (_e1263 < 3u) {
                                            } else {
                                                phi_3302_ = true;
                                                break;
                                            }
                                            let _e1269 = global_2.member[_e596].member[_e1263];
                                            let _e1275 = (_e205 % 3u);
                                            if (_e1275 < 3u) {
                                            } else {
                                                phi_3302_ = true;
                                                break;
                                            }
                                            let _e1281 = global_2.member[_e596].member[_e1275];
                                            let _e1287 = (_e207 % 3u);
                                            if (_e1287 < 3u) {
                                            } else {
                                                phi_3302_ = true;
                                                break;
                                            }
                                            let _e1293 = global_2.member[_e596].member[_e1287];
                                            let _e1303 = global_2.member[_e596].member_1;
                                            let _e1307 = global_2.member[_e596].member_2;
                                            phi_2306_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e1269[0], _e1269[1], _e1269[2], _e1269[3]), vec4<f32>(_e1281[0], _e1281[1], _e1281[2], _e1281[3]), vec4<f32>(_e1293[0], _e1293[1], _e1293[2], _e1293[3])), _e1303, _e1307);
                                        }
                                        let _e1310 = phi_2306_;
                                        let _e1321 = ((_e1310.member[0].x - _e308) * _e313);
                                        let _e1322 = ((_e1310.member[0].y - _e308) * _e313);
                                        let _e1323 = ((_e1310.member[0].z - _e309) * _e313);
                                        let _e1324 = ((_e1310.member[0].w - _e309) * _e313);
                                        let _e1334 = ((_e1310.member[1].x - _e376) * _e381);
                                        let _e1335 = ((_e1310.member[1].y - _e376) * _e381);
                                        let _e1336 = ((_e1310.member[1].z - _e377) * _e381);
                                        let _e1337 = ((_e1310.member[1].w - _e377) * _e381);
                                        let _e1347 = ((_e1310.member[2].x - _e444) * _e449);
                                        let _e1348 = ((_e1310.member[2].y - _e444) * _e449);
                                        let _e1349 = ((_e1310.member[2].z - _e445) * _e449);
                                        let _e1350 = ((_e1310.member[2].w - _e445) * _e449);
                                        let _e1352 = select(_e1349, _e1347, (_e1347 < _e1349));
                                        let _e1354 = select(_e1350, _e1348, (_e1348 < _e1350));
                                        let _e1356 = select(_e1349, _e1347, (_e1347 > _e1349));
                                        let _e1358 = select(_e1350, _e1348, (_e1348 > _e1350));
                                        let _e1360 = select(_e1323, _e1321, (_e1321 < _e1323));
                                        let _e1362 = select(_e1324, _e1322, (_e1322 < _e1324));
                                        let _e1364 = select(_e1336, _e1334, (_e1334 < _e1336));
                                        let _e1366 = select(_e1337, _e1335, (_e1335 < _e1337));
                                        let _e1368 = select(_e1364, _e1360, (_e1360 > _e1364));
                                        let _e1370 = select(_e1366, _e1362, (_e1362 > _e1366));
                                        let _e1372 = select(_e1352, _e1368, (_e1368 > _e1352));
                                        let _e1374 = select(_e1354, _e1370, (_e1370 > _e1354));
                                        let _e1376 = select(_e1323, _e1321, (_e1321 > _e1323));
                                        let _e1378 = select(_e1324, _e1322, (_e1322 > _e1324));
                                        let _e1380 = select(_e1336, _e1334, (_e1334 > _e1336));
                                        let _e1382 = select(_e1337, _e1335, (_e1335 > _e1337));
                                        let _e1384 = select(_e1380, _e1376, (_e1376 < _e1380));
                                        let _e1386 = select(_e1382, _e1378, (_e1378 < _e1382));
                                        let _e1391 = -(_e1352);
                                        let _e1392 = -(_e1354);
                                        let _e1399 = (select(_e1356, _e1384, (_e1384 < _e1356)) + (select(_e1391, _e1356, (_e1356 > _e1391)) * 0.0000019073523f));
                                        let _e1400 = (select(_e1358, _e1386, (_e1386 < _e1358)) + (select(_e1392, _e1358, (_e1358 > _e1392)) * 0.0000019073523f));
                                        let _e1402 = select(_e561, _e1372, (_e1372 > _e561));
                                        let _e1404 = select(_e561, _e1374, (_e1374 > _e561));
                                        let _e1409 = (_e1402 <= select(_e1260, _e1399, (_e1399 < _e1260)));
                                        let _e1410 = (_e1404 <= select(_e1260, _e1400, (_e1400 < _e1260)));
                                        let _e1411 = (_e1402 <= _e1404);
                                        if _e1409 {
                                            if _e1410 {
                                                if _e1411 {
                                                    phi_2669_ = _e1310.member_2;
                                                } else {
                                                    phi_2669_ = _e1310.member_1;
                                                }
                                                let _e1415 = phi_2669_;
                                                let _e1417 = (_e594 % 128u);
                                                let _e1418 = (_e1417 < 128u);
                                                if _e1418 {
                                                } else {
                                                    phi_3302_ = true;
                                                    break;
                                                }
                                                local_2[_e1417] = _e1415;
                                                if _e1418 {
                                                } else {
                                                    phi_3302_ = true;
                                                    break;
                                                }
                                                local_1[_e1417] = select(_e1402, _e1404, _e1411);
                                                if _e1411 {
                                                    phi_2696_ = _e1310.member_1;
                                                } else {
                                                    phi_2696_ = _e1310.member_2;
                                                }
                                                let _e1425 = phi_2696_;
                                                phi_2697_ = (_e594 + 1u);
                                                phi_2698_ = _e1425;
                                            } else {
                                                phi_2697_ = u32();
                                                phi_2698_ = u32();
                                            }
                                            let _e1427 = phi_2697_;
                                            let _e1429 = phi_2698_;
                                            phi_2700_ = _e1427;
                                            phi_2701_ = _e1429;
                                            phi_2702_ = select(true, false, _e1410);
                                        } else {
                                            phi_2700_ = u32();
                                            phi_2701_ = u32();
                                            phi_2702_ = true;
                                        }
                                        let _e1432 = phi_2700_;
                                        let _e1434 = phi_2701_;
                                        let _e1436 = phi_2702_;
                                        if _e1436 {
                                            if _e1409 {
                                                phi_2711_ = _e1310.member_1;
                                            } else {
                                                phi_2711_ = _e1310.member_2;
                                            }
                                            let _e1440 = phi_2711_;
                                            phi_2716_ = select(_e1410, true, _e1409);
                                            phi_2718_ = _e1440;
                                        } else {
                                            phi_2716_ = _e592;
                                            phi_2718_ = _e1434;
                                        }
                                        let _e1443 = phi_2716_;
                                        let _e1445 = phi_2718_;
                                        phi_2722_ = _e1443;
                                        phi_2723_ = select(_e1432, _e594, _e1436);
                                        phi_2724_ = _e1445;
                                    }
                                    let _e1448 = phi_2722_;
                                    let _e1450 = phi_2723_;
                                    let _e1452 = phi_2724_;
                                    phi_3364_ = _e1260;
                                    phi_3305_ = _e1258;
                                    phi_2735_ = (_e572 - 1u);
                                    phi_2736_ = select(_e1448, false, _e599);
                                    phi_2737_ = select(_e1450, _e594, _e599);
                                    phi_2738_ = select(_e1452, _e596, _e599);
                                } else {
                                    phi_3364_ = _e570;
                                    phi_3305_ = _e568;
                                    phi_2735_ = _e572;
                                    phi_2736_ = _e592;
                                    phi_2737_ = _e594;
                                    phi_2738_ = _e596;
                                }
                                let _e1457 = phi_3364_;
                                let _e1459 = phi_3305_;
                                let _e1461 = phi_2735_;
                                let _e1463 = phi_2736_;
                                let _e1465 = phi_2737_;
                                let _e1467 = phi_2738_;
                                phi_3363_ = _e1457;
                                phi_3304_ = _e1459;
                                phi_2739_ = _e1461;
                                phi_2740_ = _e1463;
                                phi_2741_ = _e1465;
                                phi_2742_ = _e1467;
                            } else {
                                phi_3363_ = _e570;
                                phi_3304_ = _e568;
                                phi_2739_ = u32();
                                phi_2740_ = bool();
                                phi_2741_ = u32();
                                phi_2742_ = u32();
                            }
                            let _e1469 = phi_3363_;
                            let _e1471 = phi_3304_;
                            let _e1473 = phi_2739_;
                            let _e1475 = phi_2740_;
                            let _e1477 = phi_2741_;
                            let _e1479 = phi_2742_;
                            phi_3362_ = _e1469;
                            phi_3303_ = _e1471;
                            phi_1034_ = _e1473;
                            phi_1037_ = _e1475;
                            phi_1039_ = _e1477;
                            phi_1041_ = _e1479;
                            phi_2743_ = _e582;
                        } else {
                            phi_3362_ = _e570;
                            phi_3303_ = _e568;
                            phi_1034_ = u32();
                            phi_1037_ = bool();
                            phi_1039_ = u32();
                            phi_1041_ = u32();
                            phi_2743_ = false;
                        }
                        let _e1481 = phi_3362_;
                        let _e1483 = phi_3303_;
                        let _e1485 = phi_1034_;
                        let _e1487 = phi_1037_;
                        let _e1489 = phi_1039_;
                        let _e1491 = phi_1041_;
                        let _e1493 = phi_2743_;
                        continue;
                        continuing {
                            phi_3055_ = _e1483;
                            phi_3036_ = _e1481;
                            phi_1033_ = _e1485;
                            phi_1036_ = _e1487;
                            phi_1038_ = _e1489;
                            phi_1040_ = _e1491;
                            phi_3302_ = _e1483;
                            break if !(_e1493);
                        }
                    }
                    let _e1496 = phi_3302_;
                    if _e1496 {
                        break;
                    }
                    phi_2750_ = type_4(0u, 8u);
                    loop {
                        let _e1498 = phi_2750_;
                        if (_e1498.member < _e1498.member_1) {
                            phi_2751_ = type_4((_e1498.member + 1u), _e1498.member_1);
                            phi_2774_ = type_4(1u, _e1498.member);
                        } else {
                            phi_2751_ = _e1498;
                            phi_2774_ = type_4(0u, type_4().member_1);
                        }
                        let _e1511 = phi_2751_;
                        let _e1513 = phi_2774_;
                        let _e1517 = (bitcast<i32>(_e1513.member) != 0i);
                        if _e1517 {
                            let _e1518 = (_e1513.member_1 < 8u);
                            if _e1518 {
                            } else {
                                phi_3344_ = true;
                                break;
                            }
                            let _e1520 = local[_e1513.member_1];
                            if (_e1520.member_3 != 4294967295u) {
                                let _e1526 = -(_e463);
                                let _e1527 = bitcast<u32>(_e1520.member);
                                let _e1531 = (bitcast<i32>((_e1527 >> bitcast<u32>(23i))) & 255i);
                                let _e1532 = (_e1531 + _e1526);
                                if (_e1531 == 255i) {
                                    phi_2847_ = _e1520.member;
                                } else {
                                    if (_e1531 > 0i) {
                                        if (_e1532 > 0i) {
                                            let _e1536 = (_e1532 < 255i);
                                            if _e1536 {
                                                phi_2826_ = bitcast<f32>((_e1527 + bitcast<u32>((_e1526 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_2826_ = f32();
                                            }
                                            let _e1543 = phi_2826_;
                                            phi_2828_ = _e1543;
                                            phi_2829_ = select(true, false, _e1536);
                                        } else {
                                            phi_2828_ = f32();
                                            phi_2829_ = true;
                                        }
                                        let _e1546 = phi_2828_;
                                        let _e1548 = phi_2829_;
                                        phi_2830_ = _e1546;
                                        phi_2831_ = _e1548;
                                    } else {
                                        phi_2830_ = f32();
                                        phi_2831_ = true;
                                    }
                                    let _e1550 = phi_2830_;
                                    let _e1552 = phi_2831_;
                                    if _e1552 {
                                        let _e1553 = (_e1527 & 2147483648u);
                                        let _e1560 = ((_e1527 & 8388607u) | (select(0u, 1u, ((_e1527 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1564 = (_e1560 == 0u);
                                        if _e1564 {
                                            phi_3020_ = bitcast<f32>(_e1553);
                                        } else {
                                            let _e1569 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1560)), 32u, _e1564) - 8u);
                                            let _e1572 = (_e1560 << bitcast<u32>((_e1569 & 31u)));
                                            let _e1574 = ((_e1532 + select(0i, 1i, (_e1531 == 0i))) - bitcast<i32>(_e1569));
                                            if (_e1574 >= 255i) {
                                                phi_3010_ = bitcast<f32>((_e1553 | 2139095040u));
                                                phi_3011_ = f32();
                                                phi_3012_ = true;
                                            } else {
                                                let _e1576 = (_e1574 > 0i);
                                                if _e1576 {
                                                    phi_3004_ = bitcast<f32>(((_e1553 | (bitcast<u32>(_e1574) << bitcast<u32>(23i))) | (_e1572 & 8388607u)));
                                                    phi_3005_ = f32();
                                                } else {
                                                    if (_e1574 < -24i) {
                                                        phi_2970_ = 26u;
                                                    } else {
                                                        phi_2970_ = bitcast<u32>((1i - _e1574));
                                                    }
                                                    let _e1581 = phi_2970_;
                                                    let _e1582 = (_e1581 & 31u);
                                                    let _e1584 = (_e1572 >> bitcast<u32>(_e1582));
                                                    let _e1588 = (_e1572 & ((1u << bitcast<u32>(_e1582)) - 1u));
                                                    let _e1592 = (1u << bitcast<u32>(((_e1581 - 1u) & 31u)));
                                                    if (_e1588 > _e1592) {
                                                        phi_2991_ = true;
                                                    } else {
                                                        if (_e1588 == _e1592) {
                                                            phi_2988_ = ((_e1584 & 1u) == 1u);
                                                        } else {
                                                            phi_2988_ = false;
                                                        }
                                                        let _e1598 = phi_2988_;
                                                        phi_2991_ = _e1598;
                                                    }
                                                    let _e1600 = phi_2991_;
                                                    phi_3004_ = f32();
                                                    phi_3005_ = bitcast<f32>((_e1553 | (_e1584 + select(0u, 1u, _e1600))));
                                                }
                                                let _e1613 = phi_3004_;
                                                let _e1615 = phi_3005_;
                                                phi_3010_ = _e1613;
                                                phi_3011_ = _e1615;
                                                phi_3012_ = _e1576;
                                            }
                                            let _e1619 = phi_3010_;
                                            let _e1621 = phi_3011_;
                                            let _e1623 = phi_3012_;
                                            phi_3020_ = select(_e1621, _e1619, _e1623);
                                        }
                                        let _e1627 = phi_3020_;
                                        phi_2846_ = _e1627;
                                    } else {
                                        phi_2846_ = _e1550;
                                    }
                                    let _e1629 = phi_2846_;
                                    phi_2847_ = _e1629;
                                }
                                let _e1631 = phi_2847_;
                                let _e1632 = bitcast<u32>(_e1631);
                                if ((_e1632 & 2147483647u) >= 2139095040u) {
                                    phi_2859_ = bitcast<f32>(((_e1632 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_2859_ = _e1631;
                                }
                                let _e1639 = phi_2859_;
                                phi_2864_ = type_23(_e1639, _e1520.member_1, _e1520.member_2, _e1520.member_3);
                            } else {
                                phi_2864_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1642 = phi_2864_;
                            if _e1518 {
                            } else {
                                phi_3344_ = true;
                                break;
                            }
                            local[_e1513.member_1] = type_23(_e1642.member, _e1642.member_1, _e1642.member_2, _e1642.member_3);
                        }
                        continue;
                        continuing {
                            phi_2750_ = _e1511;
                            phi_3344_ = _e1496;
                            break if !(_e1517);
                        }
                    }
                    let _e1650 = phi_3344_;
                    if _e1650 {
                        break;
                    }
                    let _e1651 = local;
                    if _e94 {
                    } else {
                        break;
                    }
                    global_5.member[_e88] = array<type_23, 8>(type_23(_e1651[0].member, _e1651[0].member_1, _e1651[0].member_2, _e1651[0].member_3), type_23(_e1651[1].member, _e1651[1].member_1, _e1651[1].member_2, _e1651[1].member_3), type_23(_e1651[2].member, _e1651[2].member_1, _e1651[2].member_2, _e1651[2].member_3), type_23(_e1651[3].member, _e1651[3].member_1, _e1651[3].member_2, _e1651[3].member_3), type_23(_e1651[4].member, _e1651[4].member_1, _e1651[4].member_2, _e1651[4].member_3), type_23(_e1651[5].member, _e1651[5].member_1, _e1651[5].member_2, _e1651[5].member_3), type_23(_e1651[6].member, _e1651[6].member_1, _e1651[6].member_2, _e1651[6].member_3), type_23(_e1651[7].member, _e1651[7].member_1, _e1651[7].member_2, _e1651[7].member_3));
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
