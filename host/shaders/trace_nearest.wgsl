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
    var phi_365_: i32;
    var phi_366_: i32;
    var phi_376_: bool;
    var phi_386_: u32;
    var phi_387_: u32;
    var phi_389_: bool;
    var phi_394_: u32;
    var phi_406_: i32;
    var phi_426_: i32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_548_: f32;
    var phi_559_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_672_: f32;
    var phi_683_: f32;
    var phi_692_: f32;
    var phi_698_: f32;
    var phi_738_: f32;
    var phi_744_: f32;
    var phi_796_: f32;
    var phi_807_: f32;
    var phi_862_: i32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_922_: i32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_2944_: bool;
    var phi_2924_: f32;
    var phi_1018_: u32;
    var phi_1021_: u32;
    var phi_1023_: bool;
    var phi_1025_: u32;
    var phi_1036_: bool;
    var phi_1069_: u32;
    var phi_1070_: bool;
    var phi_1071_: u32;
    var phi_2224_: type_39;
    var phi_2569_: u32;
    var phi_2597_: u32;
    var phi_2598_: u32;
    var phi_2599_: u32;
    var phi_2601_: u32;
    var phi_2602_: u32;
    var phi_2603_: bool;
    var phi_2612_: u32;
    var phi_2617_: u32;
    var phi_2618_: bool;
    var phi_2941_: bool;
    var phi_2931_: f32;
    var phi_1086_: type_4;
    var phi_1087_: type_4;
    var phi_1110_: type_4;
    var phi_1131_: u32;
    var phi_1220_: array<array<f32, 3>, 3>;
    var phi_1338_: bool;
    var phi_1367_: bool;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1771_: f32;
    var phi_1772_: vec3<f32>;
    var phi_1773_: vec3<f32>;
    var phi_1774_: vec3<f32>;
    var phi_1775_: vec3<f32>;
    var phi_1806_: bool;
    var phi_1815_: vec3<f32>;
    var phi_1980_: f32;
    var phi_1982_: f32;
    var phi_1983_: bool;
    var phi_2003_: f32;
    var phi_2004_: f32;
    var phi_2027_: type_23;
    var phi_2029_: type_23;
    var phi_2030_: bool;
    var phi_2034_: type_23;
    var phi_2035_: type_23;
    var phi_2036_: type_23;
    var phi_2037_: bool;
    var phi_2041_: type_23;
    var phi_2042_: bool;
    var phi_2043_: type_23;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2046_: type_23;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2056_: type_23;
    var phi_2057_: bool;
    var phi_2061_: type_23;
    var phi_2073_: type_4;
    var phi_2076_: type_23;
    var phi_2074_: type_4;
    var phi_2099_: type_4;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2153_: type_23;
    var phi_2077_: type_23;
    var phi_2932_: bool;
    var phi_3284_: f32;
    var phi_3283_: f32;
    var phi_3095_: bool;
    var phi_3282_: f32;
    var phi_3094_: bool;
    var phi_3281_: f32;
    var phi_3093_: bool;
    var phi_3193_: f32;
    var phi_3092_: bool;
    var phi_3158_: f32;
    var phi_3101_: bool;
    var phi_2620_: u32;
    var phi_2621_: bool;
    var phi_2622_: u32;
    var phi_3157_: f32;
    var phi_3100_: bool;
    var phi_2623_: u32;
    var phi_2624_: u32;
    var phi_2625_: bool;
    var phi_2626_: u32;
    var phi_3156_: f32;
    var phi_3099_: bool;
    var phi_2627_: u32;
    var phi_2628_: u32;
    var phi_2629_: bool;
    var phi_2630_: u32;
    var phi_3155_: f32;
    var phi_3098_: bool;
    var phi_1019_: u32;
    var phi_1022_: u32;
    var phi_1024_: bool;
    var phi_1026_: u32;
    var phi_2631_: bool;
    var phi_3097_: bool;
    var phi_2638_: type_4;
    var phi_2639_: type_4;
    var phi_2662_: type_4;
    var phi_2714_: f32;
    var phi_2716_: f32;
    var phi_2717_: bool;
    var phi_2718_: f32;
    var phi_2719_: bool;
    var phi_2858_: u32;
    var phi_2876_: bool;
    var phi_2879_: bool;
    var phi_2892_: f32;
    var phi_2893_: f32;
    var phi_2898_: f32;
    var phi_2899_: f32;
    var phi_2900_: bool;
    var phi_2908_: f32;
    var phi_2734_: f32;
    var phi_2735_: f32;
    var phi_2747_: f32;
    var phi_2752_: type_23;
    var phi_3137_: bool;

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
                            phi_365_ = (bitcast<i32>((_e171 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_365_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e171)), 32u, (_e171 == 0u))));
                        }
                        let _e185 = phi_365_;
                        phi_366_ = _e185;
                    } else {
                        phi_366_ = 0i;
                    }
                    let _e187 = phi_366_;
                    let _e188 = (_e104 == _e143);
                    if _e188 {
                        phi_376_ = true;
                    } else {
                        phi_376_ = (_e111 == _e143);
                    }
                    let _e191 = phi_376_;
                    let _e192 = select(1u, 0u, _e188);
                    if _e191 {
                        let _e193 = (_e192 + 1u);
                        phi_386_ = _e193;
                        phi_387_ = _e193;
                        phi_389_ = select(true, false, (_e193 == 2u));
                    } else {
                        phi_386_ = u32();
                        phi_387_ = 0u;
                        phi_389_ = true;
                    }
                    let _e197 = phi_386_;
                    let _e199 = phi_387_;
                    let _e201 = phi_389_;
                    if _e201 {
                        phi_394_ = (_e199 + 1u);
                    } else {
                        phi_394_ = 0u;
                    }
                    let _e205 = phi_394_;
                    let _e206 = select(_e197, _e199, _e201);
                    let _e207 = select(_e192, select(2u, _e192, _e191), _e201);
                    if (_e92 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e92, 127i, (_e92 > 127i));
                    }
                    let _e212 = phi_406_;
                    let _e217 = bitcast<f32>((bitcast<u32>((_e212 + 127i)) << bitcast<u32>(23i)));
                    let _e223 = bitcast<f32>((bitcast<u32>(((_e92 - _e212) + 127i)) << bitcast<u32>(23i)));
                    let _e224 = -(_e187);
                    if (_e224 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e224, 127i, (_e224 > 127i));
                    }
                    let _e229 = phi_426_;
                    let _e234 = bitcast<f32>((bitcast<u32>((_e229 + 127i)) << bitcast<u32>(23i)));
                    let _e240 = bitcast<f32>((bitcast<u32>(((_e224 - _e229) + 127i)) << bitcast<u32>(23i)));
                    let _e244 = global_4.member[_e88].member;
                    let _e245 = (_e206 == 0u);
                    if _e245 {
                        phi_444_ = _e244[0];
                    } else {
                        phi_444_ = _e244[1];
                    }
                    let _e249 = phi_444_;
                    let _e250 = (_e206 == 2u);
                    if _e250 {
                        phi_450_ = _e244[2];
                    } else {
                        phi_450_ = _e249;
                    }
                    let _e253 = phi_450_;
                    let _e254 = bitcast<u32>(_e253);
                    let _e256 = ((_e254 & 2139095040u) != 0u);
                    let _e270 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e254 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e254 & 2147483648u))), _e253, _e256) * _e217) * select(0.00000011920929f, 1f, _e256)) * _e223);
                    let _e271 = global_4.member[_e88].member_2;
                    if _e245 {
                        phi_490_ = _e271[0];
                    } else {
                        phi_490_ = _e271[1];
                    }
                    let _e275 = phi_490_;
                    if _e250 {
                        phi_496_ = _e271[2];
                    } else {
                        phi_496_ = _e275;
                    }
                    let _e278 = phi_496_;
                    let _e279 = bitcast<u32>(_e278);
                    let _e281 = ((_e279 & 2139095040u) != 0u);
                    let _e295 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e279 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e279 & 2147483648u))), _e278, _e281) * _e234) * select(0.00000011920929f, 1f, _e281)) * _e240);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e270) & 2147483647u)) * 0.00000011920929f);
                        phi_548_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e307 = phi_548_;
                    let _e308 = (_e270 + _e307);
                    let _e309 = (_e270 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_559_ = 38685626000000000000000000f;
                    } else {
                        phi_559_ = (1f / _e295);
                    }
                    let _e313 = phi_559_;
                    let _e314 = (_e205 == 0u);
                    if _e314 {
                        phi_568_ = _e244[0];
                    } else {
                        phi_568_ = _e244[1];
                    }
                    let _e318 = phi_568_;
                    let _e319 = (_e205 == 2u);
                    if _e319 {
                        phi_574_ = _e244[2];
                    } else {
                        phi_574_ = _e318;
                    }
                    let _e322 = phi_574_;
                    let _e323 = bitcast<u32>(_e322);
                    let _e325 = ((_e323 & 2139095040u) != 0u);
                    let _e339 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e323 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e323 & 2147483648u))), _e322, _e325) * _e217) * select(0.00000011920929f, 1f, _e325)) * _e223);
                    if _e314 {
                        phi_614_ = _e271[0];
                    } else {
                        phi_614_ = _e271[1];
                    }
                    let _e343 = phi_614_;
                    if _e319 {
                        phi_620_ = _e271[2];
                    } else {
                        phi_620_ = _e343;
                    }
                    let _e346 = phi_620_;
                    let _e347 = bitcast<u32>(_e346);
                    let _e349 = ((_e347 & 2139095040u) != 0u);
                    let _e363 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e347 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e347 & 2147483648u))), _e346, _e349) * _e234) * select(0.00000011920929f, 1f, _e349)) * _e240);
                    let _e367 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e367 {
                        let _e371 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) * 0.00000011920929f);
                        phi_672_ = select(0.00000000000011368684f, _e371, (_e371 > 0.00000000000011368684f));
                    } else {
                        phi_672_ = 0f;
                    }
                    let _e375 = phi_672_;
                    let _e376 = (_e339 + _e375);
                    let _e377 = (_e339 - _e375);
                    let _e378 = select(_e363, 0f, _e367);
                    if _e367 {
                        phi_683_ = 38685626000000000000000000f;
                    } else {
                        phi_683_ = (1f / _e363);
                    }
                    let _e381 = phi_683_;
                    let _e382 = (_e207 == 0u);
                    if _e382 {
                        phi_692_ = _e244[0];
                    } else {
                        phi_692_ = _e244[1];
                    }
                    let _e386 = phi_692_;
                    let _e387 = (_e207 == 2u);
                    if _e387 {
                        phi_698_ = _e244[2];
                    } else {
                        phi_698_ = _e386;
                    }
                    let _e390 = phi_698_;
                    let _e391 = bitcast<u32>(_e390);
                    let _e393 = ((_e391 & 2139095040u) != 0u);
                    let _e407 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e391 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e391 & 2147483648u))), _e390, _e393) * _e217) * select(0.00000011920929f, 1f, _e393)) * _e223);
                    if _e382 {
                        phi_738_ = _e271[0];
                    } else {
                        phi_738_ = _e271[1];
                    }
                    let _e411 = phi_738_;
                    if _e387 {
                        phi_744_ = _e271[2];
                    } else {
                        phi_744_ = _e411;
                    }
                    let _e414 = phi_744_;
                    let _e415 = bitcast<u32>(_e414);
                    let _e417 = ((_e415 & 2139095040u) != 0u);
                    let _e431 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e415 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e415 & 2147483648u))), _e414, _e417) * _e234) * select(0.00000011920929f, 1f, _e417)) * _e240);
                    let _e435 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e435 {
                        let _e439 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) * 0.00000011920929f);
                        phi_796_ = select(0.00000000000011368684f, _e439, (_e439 > 0.00000000000011368684f));
                    } else {
                        phi_796_ = 0f;
                    }
                    let _e443 = phi_796_;
                    let _e444 = (_e407 + _e443);
                    let _e445 = (_e407 - _e443);
                    let _e446 = select(_e431, 0f, _e435);
                    if _e435 {
                        phi_807_ = 38685626000000000000000000f;
                    } else {
                        phi_807_ = (1f / _e431);
                    }
                    let _e449 = phi_807_;
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
                            phi_862_ = 255i;
                        } else {
                            phi_862_ = (((_e476 + select(0i, 1i, (_e476 == 0i))) - _e483) + _e463);
                        }
                        let _e491 = phi_862_;
                        let _e501 = (_e491 <= 0i);
                        if _e501 {
                            phi_885_ = u32();
                        } else {
                            if _e480 {
                                phi_884_ = u32();
                            } else {
                                phi_884_ = select(((bitcast<u32>(_e491) << bitcast<u32>(23i)) | ((_e473 << bitcast<u32>(((_e483 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e491 >= 255i));
                            }
                            let _e505 = phi_884_;
                            phi_885_ = _e505;
                        }
                        let _e507 = phi_885_;
                        let _e519 = ((_e164 & 8388607u) | (select(0u, 1u, ((_e164 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<i32>((_e164 >> bitcast<u32>(23i)));
                        let _e526 = (_e519 == 0u);
                        let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                        if (_e522 == 255i) {
                            phi_922_ = 255i;
                        } else {
                            phi_922_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e463);
                        }
                        let _e537 = phi_922_;
                        let _e547 = (_e537 <= 0i);
                        if _e547 {
                            phi_945_ = u32();
                        } else {
                            if _e526 {
                                phi_944_ = u32();
                            } else {
                                phi_944_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                            }
                            let _e551 = phi_944_;
                            phi_945_ = _e551;
                        }
                        let _e553 = phi_945_;
                        phi_953_ = bitcast<f32>(((_e163 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                        phi_954_ = bitcast<f32>(((_e154 & 2147483648u) | select(_e507, 0u, select(_e480, true, _e501))));
                    } else {
                        phi_953_ = 0f;
                        phi_954_ = 1f;
                    }
                    let _e559 = phi_953_;
                    let _e561 = phi_954_;
                    local = array<type_23, 8>(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_2 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2944_ = false;
                    phi_2924_ = _e559;
                    phi_1018_ = select(0u, 2147483648u, (_e78 == 0u));
                    phi_1021_ = ((3u * _e78) + 1u);
                    phi_1023_ = (_e561 <= _e559);
                    phi_1025_ = 0u;
                    loop {
                        let _e568 = phi_2944_;
                        let _e570 = phi_2924_;
                        let _e572 = phi_1018_;
                        let _e574 = phi_1021_;
                        let _e576 = phi_1023_;
                        let _e578 = phi_1025_;
                        if _e576 {
                            phi_1036_ = true;
                        } else {
                            phi_1036_ = (_e578 > 0u);
                        }
                        let _e581 = phi_1036_;
                        if _e581 {
                            let _e582 = (_e574 > 0u);
                            if _e582 {
                                if _e576 {
                                    phi_1069_ = _e572;
                                    phi_1070_ = _e576;
                                    phi_1071_ = _e578;
                                } else {
                                    let _e583 = (_e578 - 1u);
                                    let _e584 = (_e583 % 128u);
                                    let _e585 = (_e584 < 128u);
                                    if _e585 {
                                    } else {
                                        phi_3097_ = true;
                                        break;
                                    }
                                    let _e587 = local_2[_e584];
                                    if _e585 {
                                    } else {
                                        phi_3097_ = true;
                                        break;
                                    }
                                    let _e589 = local_1[_e584];
                                    phi_1069_ = _e587;
                                    phi_1070_ = (_e589 <= _e570);
                                    phi_1071_ = _e583;
                                }
                                let _e592 = phi_1069_;
                                let _e594 = phi_1070_;
                                let _e596 = phi_1071_;
                                if _e594 {
                                    if ((_e592 & 2147483648u) != 0u) {
                                        phi_2941_ = _e568;
                                        phi_2931_ = _e570;
                                        phi_1086_ = type_4(0u, ((_e592 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e793 = phi_2941_;
                                            let _e795 = phi_2931_;
                                            let _e797 = phi_1086_;
                                            if (_e797.member < _e797.member_1) {
                                                phi_1087_ = type_4((_e797.member + 1u), _e797.member_1);
                                                phi_1110_ = type_4(1u, _e797.member);
                                            } else {
                                                phi_1087_ = _e797;
                                                phi_1110_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e810 = phi_1087_;
                                            let _e812 = phi_1110_;
                                            let _e816 = (bitcast<i32>(_e812.member) != 0i);
                                            if _e816 {
                                                let _e817 = ((_e592 & 268435455u) + _e812.member_1);
                                                let _e818 = (_e817 < _e80);
                                                if _e818 {
                                                    if _e818 {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e822 = global_3.member[_e817].member_1;
                                                    phi_1131_ = _e822;
                                                } else {
                                                    phi_1131_ = 4294967295u;
                                                }
                                                let _e824 = phi_1131_;
                                                if (_e817 >= _e80) {
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e818 {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e826 = (_e206 % 3u);
                                                    let _e827 = (_e205 % 3u);
                                                    let _e828 = (_e207 % 3u);
                                                    if (_e826 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e834 = global_3.member[_e817].member[_e826];
                                                    if (_e827 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e840 = global_3.member[_e817].member[_e827];
                                                    if (_e828 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e846 = global_3.member[_e817].member[_e828];
                                                    let _e848 = (3u + _e826);
                                                    if (_e848 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e854 = global_3.member[_e817].member[_e848];
                                                    let _e855 = (3u + _e827);
                                                    if (_e855 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e861 = global_3.member[_e817].member[_e855];
                                                    let _e862 = (3u + _e828);
                                                    if (_e862 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e868 = global_3.member[_e817].member[_e862];
                                                    let _e870 = (6u + _e826);
                                                    if (_e870 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e876 = global_3.member[_e817].member[_e870];
                                                    let _e877 = (6u + _e827);
                                                    if (_e877 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e883 = global_3.member[_e817].member[_e877];
                                                    let _e884 = (6u + _e828);
                                                    if (_e884 < 9u) {
                                                    } else {
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_3.member[_e817].member[_e884];
                                                    phi_1220_ = array<array<f32, 3>, 3>(array<f32, 3>(_e834, _e840, _e846), array<f32, 3>(_e854, _e861, _e868), array<f32, 3>(_e876, _e883, _e890));
                                                }
                                                let _e894 = phi_1220_;
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
                                                        phi_2046_ = type_23();
                                                        phi_2047_ = true;
                                                        phi_2048_ = false;
                                                    } else {
                                                        let _e968 = select(_e917, _e904, (_e904 < _e917));
                                                        if (select(_e930, _e968, (_e968 < _e930)) > 0f) {
                                                            phi_1338_ = true;
                                                        } else {
                                                            let _e973 = select(_e917, _e904, (_e904 > _e917));
                                                            phi_1338_ = (select(_e930, _e973, (_e973 > _e930)) < 0f);
                                                        }
                                                        let _e978 = phi_1338_;
                                                        if _e978 {
                                                            phi_2043_ = type_23();
                                                            phi_2044_ = true;
                                                            phi_2045_ = false;
                                                        } else {
                                                            let _e980 = select(_e920, _e907, (_e907 < _e920));
                                                            if (select(_e933, _e980, (_e980 < _e933)) > 0f) {
                                                                phi_1367_ = true;
                                                            } else {
                                                                let _e985 = select(_e920, _e907, (_e907 > _e920));
                                                                phi_1367_ = (select(_e933, _e985, (_e985 > _e933)) < 0f);
                                                            }
                                                            let _e990 = phi_1367_;
                                                            if _e990 {
                                                                phi_2041_ = type_23();
                                                                phi_2042_ = false;
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
                                                                    phi_2036_ = type_23();
                                                                    phi_2037_ = true;
                                                                } else {
                                                                    let _e1055 = (_e1053 > _e795);
                                                                    if _e1055 {
                                                                        phi_2035_ = type_23();
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
                                                                            phi_1768_ = _e920;
                                                                            phi_1769_ = _e917;
                                                                            phi_1770_ = _e907;
                                                                            phi_1771_ = _e904;
                                                                            phi_1772_ = _e1056;
                                                                            phi_1773_ = _e1070;
                                                                            phi_1774_ = _e1066;
                                                                            phi_1775_ = _e1062;
                                                                        } else {
                                                                            let _e1115 = (_e1096 == _e1113);
                                                                            let _e1120 = vec3(_e1115);
                                                                            phi_1768_ = select(_e907, _e933, _e1115);
                                                                            phi_1769_ = select(_e904, _e930, _e1115);
                                                                            phi_1770_ = select(_e933, _e920, _e1115);
                                                                            phi_1771_ = select(_e930, _e917, _e1115);
                                                                            phi_1772_ = select(_e1058, _e1057, _e1120);
                                                                            phi_1773_ = select(_e1066, _e1062, _e1120);
                                                                            phi_1774_ = select(_e1062, _e1070, _e1120);
                                                                            phi_1775_ = select(_e1070, _e1066, _e1120);
                                                                        }
                                                                        let _e1126 = phi_1768_;
                                                                        let _e1128 = phi_1769_;
                                                                        let _e1130 = phi_1770_;
                                                                        let _e1132 = phi_1771_;
                                                                        let _e1134 = phi_1772_;
                                                                        let _e1136 = phi_1773_;
                                                                        let _e1138 = phi_1774_;
                                                                        let _e1140 = phi_1775_;
                                                                        let _e1147 = ((_e1138.y * _e1136.z) - (_e1136.y * _e1138.z));
                                                                        let _e1152 = ((_e1138.z * _e1136.x) - (_e1136.z * _e1138.x));
                                                                        let _e1155 = ((_e1138.x * _e1136.y) - (_e1136.x * _e1138.y));
                                                                        if (_e955 >= _e959) {
                                                                            phi_1806_ = select(true, false, (_e955 >= _e963));
                                                                        } else {
                                                                            phi_1806_ = true;
                                                                        }
                                                                        let _e1160 = phi_1806_;
                                                                        if _e1160 {
                                                                            phi_1815_ = select(_e1058, _e1057, vec3((_e959 >= _e963)));
                                                                        } else {
                                                                            phi_1815_ = _e1056;
                                                                        }
                                                                        let _e1165 = phi_1815_;
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
                                                                                phi_1980_ = (_e1176 / _e1181);
                                                                            } else {
                                                                                phi_1980_ = f32();
                                                                            }
                                                                            let _e1286 = phi_1980_;
                                                                            phi_1982_ = _e1286;
                                                                            phi_1983_ = select(true, false, _e1283);
                                                                        } else {
                                                                            phi_1982_ = f32();
                                                                            phi_1983_ = true;
                                                                        }
                                                                        let _e1289 = phi_1982_;
                                                                        let _e1291 = phi_1983_;
                                                                        if _e1291 {
                                                                            let _e1299 = (((_e1147 * (_e1208 - (_e310 * _e1211))) + (_e1152 * (_e1209 - (_e378 * _e1211)))) / _e1181);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1299) & 2147483647u)) <= _e1113) {
                                                                                phi_2003_ = (_e1211 + _e1299);
                                                                            } else {
                                                                                phi_2003_ = _e1211;
                                                                            }
                                                                            let _e1306 = phi_2003_;
                                                                            phi_2004_ = _e1306;
                                                                        } else {
                                                                            phi_2004_ = _e1289;
                                                                        }
                                                                        let _e1308 = phi_2004_;
                                                                        let _e1310 = select(_e1046, _e1308, (_e1308 < _e1046));
                                                                        let _e1312 = select(_e1038, _e1310, (_e1310 > _e1038));
                                                                        if (_e1312 >= _e561) {
                                                                            let _e1314 = (_e1312 <= _e795);
                                                                            if _e1314 {
                                                                                let _e1315 = (1f / _e965);
                                                                                phi_2027_ = type_23(_e1312, (_e959 * _e1315), (_e963 * _e1315), _e824);
                                                                            } else {
                                                                                phi_2027_ = type_23();
                                                                            }
                                                                            let _e1320 = phi_2027_;
                                                                            phi_2029_ = _e1320;
                                                                            phi_2030_ = select(true, false, _e1314);
                                                                        } else {
                                                                            phi_2029_ = type_23();
                                                                            phi_2030_ = true;
                                                                        }
                                                                        let _e1323 = phi_2029_;
                                                                        let _e1325 = phi_2030_;
                                                                        if _e1325 {
                                                                            phi_2034_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2034_ = _e1323;
                                                                        }
                                                                        let _e1327 = phi_2034_;
                                                                        phi_2035_ = _e1327;
                                                                    }
                                                                    let _e1329 = phi_2035_;
                                                                    phi_2036_ = _e1329;
                                                                    phi_2037_ = _e1055;
                                                                }
                                                                let _e1331 = phi_2036_;
                                                                let _e1333 = phi_2037_;
                                                                phi_2041_ = _e1331;
                                                                phi_2042_ = _e1333;
                                                            }
                                                            let _e1335 = phi_2041_;
                                                            let _e1337 = phi_2042_;
                                                            phi_2043_ = _e1335;
                                                            phi_2044_ = _e990;
                                                            phi_2045_ = _e1337;
                                                        }
                                                        let _e1339 = phi_2043_;
                                                        let _e1341 = phi_2044_;
                                                        let _e1343 = phi_2045_;
                                                        phi_2046_ = _e1339;
                                                        phi_2047_ = _e1341;
                                                        phi_2048_ = _e1343;
                                                    }
                                                    let _e1345 = phi_2046_;
                                                    let _e1347 = phi_2047_;
                                                    let _e1349 = phi_2048_;
                                                    phi_2056_ = _e1345;
                                                    phi_2057_ = select(_e1349, true, _e1347);
                                                } else {
                                                    phi_2056_ = type_23();
                                                    phi_2057_ = true;
                                                }
                                                let _e1352 = phi_2056_;
                                                let _e1354 = phi_2057_;
                                                if _e1354 {
                                                    phi_2061_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2061_ = _e1352;
                                                }
                                                let _e1356 = phi_2061_;
                                                if (_e1356.member_3 != 4294967295u) {
                                                    if (_e824 != 4294967295u) {
                                                        phi_2073_ = type_4(0u, 8u);
                                                        phi_2076_ = _e1356;
                                                        loop {
                                                            let _e1361 = phi_2073_;
                                                            let _e1363 = phi_2076_;
                                                            if (_e1361.member < _e1361.member_1) {
                                                                phi_2074_ = type_4((_e1361.member + 1u), _e1361.member_1);
                                                                phi_2099_ = type_4(1u, _e1361.member);
                                                            } else {
                                                                phi_2074_ = _e1361;
                                                                phi_2099_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1376 = phi_2074_;
                                                            let _e1378 = phi_2099_;
                                                            let _e1382 = (bitcast<i32>(_e1378.member) != 0i);
                                                            if _e1382 {
                                                                let _e1383 = (_e1378.member_1 < 8u);
                                                                if _e1383 {
                                                                } else {
                                                                    phi_2932_ = true;
                                                                    break;
                                                                }
                                                                let _e1388 = local[_e1378.member_1].member;
                                                                if (_e1363.member < _e1388) {
                                                                    phi_2132_ = true;
                                                                } else {
                                                                    let _e1390 = local[_e1378.member_1].member;
                                                                    if (_e1363.member == _e1390) {
                                                                        let _e1395 = local[_e1378.member_1].member_3;
                                                                        phi_2131_ = (_e1363.member_3 < _e1395);
                                                                    } else {
                                                                        phi_2131_ = false;
                                                                    }
                                                                    let _e1398 = phi_2131_;
                                                                    phi_2132_ = _e1398;
                                                                }
                                                                let _e1400 = phi_2132_;
                                                                if _e1400 {
                                                                    if _e1383 {
                                                                    } else {
                                                                        phi_2932_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1401 = local[_e1378.member_1];
                                                                    local[_e1378.member_1] = type_23(_e1363.member, _e1363.member_1, _e1363.member_2, _e1363.member_3);
                                                                    phi_2153_ = type_23(_e1401.member, _e1401.member_1, _e1401.member_2, _e1401.member_3);
                                                                } else {
                                                                    phi_2153_ = _e1363;
                                                                }
                                                                let _e1412 = phi_2153_;
                                                                phi_2077_ = _e1412;
                                                            } else {
                                                                phi_2077_ = type_23();
                                                            }
                                                            let _e1414 = phi_2077_;
                                                            continue;
                                                            continuing {
                                                                phi_2073_ = _e1376;
                                                                phi_2076_ = _e1414;
                                                                phi_2932_ = _e793;
                                                                break if !(_e1382);
                                                            }
                                                        }
                                                        let _e1417 = phi_2932_;
                                                        phi_3193_ = _e795;
                                                        phi_3092_ = _e1417;
                                                        if _e1417 {
                                                            break;
                                                        }
                                                        let _e1420 = local[7u].member_3;
                                                        if (_e1420 != 4294967295u) {
                                                            let _e1424 = local[7u].member;
                                                            phi_3284_ = _e1424;
                                                        } else {
                                                            phi_3284_ = _e795;
                                                        }
                                                        let _e1426 = phi_3284_;
                                                        phi_3283_ = _e1426;
                                                        phi_3095_ = _e1417;
                                                    } else {
                                                        phi_3283_ = _e795;
                                                        phi_3095_ = _e793;
                                                    }
                                                    let _e1428 = phi_3283_;
                                                    let _e1430 = phi_3095_;
                                                    phi_3282_ = _e1428;
                                                    phi_3094_ = _e1430;
                                                } else {
                                                    phi_3282_ = _e795;
                                                    phi_3094_ = _e793;
                                                }
                                                let _e1432 = phi_3282_;
                                                let _e1434 = phi_3094_;
                                                phi_3281_ = _e1432;
                                                phi_3093_ = _e1434;
                                            } else {
                                                phi_3281_ = _e795;
                                                phi_3093_ = _e793;
                                            }
                                            let _e1436 = phi_3281_;
                                            let _e1438 = phi_3093_;
                                            continue;
                                            continuing {
                                                phi_2941_ = _e1438;
                                                phi_2931_ = _e1436;
                                                phi_1086_ = _e810;
                                                phi_3193_ = _e1436;
                                                phi_3092_ = _e1438;
                                                break if !(_e816);
                                            }
                                        }
                                        let _e1441 = phi_3193_;
                                        let _e1443 = phi_3092_;
                                        phi_3097_ = _e1443;
                                        if _e1443 {
                                            break;
                                        }
                                        phi_3158_ = _e1441;
                                        phi_3101_ = _e1443;
                                        phi_2620_ = _e592;
                                        phi_2621_ = false;
                                        phi_2622_ = _e596;
                                    } else {
                                        if (_e592 >= _e78) {
                                            phi_2224_ = type_39(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e592 < _e78) {
                                            } else {
                                                phi_3097_ = true;
                                                break;
                                            }
                                            let _e606 = (_e206 % 3u);
                                            if (_e606 < 3u) {
                                            } else {
                                                phi_3097_ = true;
                                                break;
                                            }
                                            let _e612 = global_2.member[_e592].member[_e606];
                                            let _e618 = (_e205 % 3u);
                                            if (_e618 < 3u) {
                                            } else {
                                                phi_3097_ = true;
                                                break;
                                            }
                                            let _e624 = global_2.member[_e592].member[_e618];
                                            let _e630 = (_e207 % 3u);
                                            if (_e630 < 3u) {
                                            } else {
                                                phi_3097_ = true;
                                                break;
                                            }
                                            let _e636 = global_2.member[_e592].member[_e630];
                                            let _e646 = global_2.member[_e592].member_1;
                                            let _e650 = global_2.member[_e592].member_2;
                                            phi_2224_ = type_39(array<vec4<f32>, 3>(vec4<f32>(_e612[0], _e612[1], _e612[2], _e612[3]), vec4<f32>(_e624[0], _e624[1], _e624[2], _e624[3]), vec4<f32>(_e636[0], _e636[1], _e636[2], _e636[3])), _e646, _e650);
                                        }
                                        let _e653 = phi_2224_;
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
                                                    phi_2569_ = _e653.member_2;
                                                } else {
                                                    phi_2569_ = _e653.member_1;
                                                }
                                                let _e758 = phi_2569_;
                                                let _e761 = (_e596 % 128u);
                                                let _e762 = (_e761 < 128u);
                                                if _e762 {
                                                } else {
                                                    phi_3097_ = true;
                                                    break;
                                                }
                                                local_2[_e761] = _e758;
                                                if _e762 {
                                                } else {
                                                    phi_3097_ = true;
                                                    break;
                                                }
                                                local_1[_e761] = select(_e747, _e745, (_e745 > _e747));
                                                if _e754 {
                                                    phi_2597_ = _e653.member_1;
                                                } else {
                                                    phi_2597_ = _e653.member_2;
                                                }
                                                let _e769 = phi_2597_;
                                                phi_2598_ = _e769;
                                                phi_2599_ = (_e596 + 1u);
                                            } else {
                                                phi_2598_ = u32();
                                                phi_2599_ = u32();
                                            }
                                            let _e771 = phi_2598_;
                                            let _e773 = phi_2599_;
                                            phi_2601_ = _e771;
                                            phi_2602_ = _e773;
                                            phi_2603_ = select(true, false, _e753);
                                        } else {
                                            phi_2601_ = u32();
                                            phi_2602_ = u32();
                                            phi_2603_ = true;
                                        }
                                        let _e776 = phi_2601_;
                                        let _e778 = phi_2602_;
                                        let _e780 = phi_2603_;
                                        if _e780 {
                                            if _e752 {
                                                phi_2612_ = _e653.member_1;
                                            } else {
                                                phi_2612_ = _e653.member_2;
                                            }
                                            let _e784 = phi_2612_;
                                            phi_2617_ = _e784;
                                            phi_2618_ = select(_e753, true, _e752);
                                        } else {
                                            phi_2617_ = _e776;
                                            phi_2618_ = _e594;
                                        }
                                        let _e787 = phi_2617_;
                                        let _e789 = phi_2618_;
                                        phi_3158_ = _e570;
                                        phi_3101_ = _e568;
                                        phi_2620_ = _e787;
                                        phi_2621_ = _e789;
                                        phi_2622_ = select(_e778, _e596, _e780);
                                    }
                                    let _e1445 = phi_3158_;
                                    let _e1447 = phi_3101_;
                                    let _e1449 = phi_2620_;
                                    let _e1451 = phi_2621_;
                                    let _e1453 = phi_2622_;
                                    phi_3157_ = _e1445;
                                    phi_3100_ = _e1447;
                                    phi_2623_ = _e1449;
                                    phi_2624_ = (_e574 - 1u);
                                    phi_2625_ = _e1451;
                                    phi_2626_ = _e1453;
                                } else {
                                    phi_3157_ = _e570;
                                    phi_3100_ = _e568;
                                    phi_2623_ = _e592;
                                    phi_2624_ = _e574;
                                    phi_2625_ = _e594;
                                    phi_2626_ = _e596;
                                }
                                let _e1455 = phi_3157_;
                                let _e1457 = phi_3100_;
                                let _e1459 = phi_2623_;
                                let _e1461 = phi_2624_;
                                let _e1463 = phi_2625_;
                                let _e1465 = phi_2626_;
                                phi_3156_ = _e1455;
                                phi_3099_ = _e1457;
                                phi_2627_ = _e1459;
                                phi_2628_ = _e1461;
                                phi_2629_ = _e1463;
                                phi_2630_ = _e1465;
                            } else {
                                phi_3156_ = _e570;
                                phi_3099_ = _e568;
                                phi_2627_ = u32();
                                phi_2628_ = u32();
                                phi_2629_ = bool();
                                phi_2630_ = u32();
                            }
                            let _e1467 = phi_3156_;
                            let _e1469 = phi_3099_;
                            let _e1471 = phi_2627_;
                            let _e1473 = phi_2628_;
                            let _e1475 = phi_2629_;
                            let _e1477 = phi_2630_;
                            phi_3155_ = _e1467;
                            phi_3098_ = _e1469;
                            phi_1019_ = _e1471;
                            phi_1022_ = _e1473;
                            phi_1024_ = _e1475;
                            phi_1026_ = _e1477;
                            phi_2631_ = _e582;
                        } else {
                            phi_3155_ = _e570;
                            phi_3098_ = _e568;
                            phi_1019_ = u32();
                            phi_1022_ = u32();
                            phi_1024_ = bool();
                            phi_1026_ = u32();
                            phi_2631_ = false;
                        }
                        let _e1479 = phi_3155_;
                        let _e1481 = phi_3098_;
                        let _e1483 = phi_1019_;
                        let _e1485 = phi_1022_;
                        let _e1487 = phi_1024_;
                        let _e1489 = phi_1026_;
                        let _e1491 = phi_2631_;
                        continue;
                        continuing {
                            phi_2944_ = _e1481;
                            phi_2924_ = _e1479;
                            phi_1018_ = _e1483;
                            phi_1021_ = _e1485;
                            phi_1023_ = _e1487;
                            phi_1025_ = _e1489;
                            phi_3097_ = _e1481;
                            break if !(_e1491);
                        }
                    }
                    let _e1494 = phi_3097_;
                    if _e1494 {
                        break;
                    }
                    phi_2638_ = type_4(0u, 8u);
                    loop {
                        let _e1496 = phi_2638_;
                        if (_e1496.member < _e1496.member_1) {
                            phi_2639_ = type_4((_e1496.member + 1u), _e1496.member_1);
                            phi_2662_ = type_4(1u, _e1496.member);
                        } else {
                            phi_2639_ = _e1496;
                            phi_2662_ = type_4(0u, type_4().member_1);
                        }
                        let _e1509 = phi_2639_;
                        let _e1511 = phi_2662_;
                        let _e1515 = (bitcast<i32>(_e1511.member) != 0i);
                        if _e1515 {
                            let _e1516 = (_e1511.member_1 < 8u);
                            if _e1516 {
                            } else {
                                phi_3137_ = true;
                                break;
                            }
                            let _e1518 = local[_e1511.member_1];
                            if (_e1518.member_3 != 4294967295u) {
                                let _e1524 = -(_e463);
                                let _e1525 = bitcast<u32>(_e1518.member);
                                let _e1529 = (bitcast<i32>((_e1525 >> bitcast<u32>(23i))) & 255i);
                                let _e1530 = (_e1529 + _e1524);
                                if (_e1529 == 255i) {
                                    phi_2735_ = _e1518.member;
                                } else {
                                    if (_e1529 > 0i) {
                                        if (_e1530 > 0i) {
                                            let _e1534 = (_e1530 < 255i);
                                            if _e1534 {
                                                phi_2714_ = bitcast<f32>((_e1525 + bitcast<u32>((_e1524 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_2714_ = f32();
                                            }
                                            let _e1541 = phi_2714_;
                                            phi_2716_ = _e1541;
                                            phi_2717_ = select(true, false, _e1534);
                                        } else {
                                            phi_2716_ = f32();
                                            phi_2717_ = true;
                                        }
                                        let _e1544 = phi_2716_;
                                        let _e1546 = phi_2717_;
                                        phi_2718_ = _e1544;
                                        phi_2719_ = _e1546;
                                    } else {
                                        phi_2718_ = f32();
                                        phi_2719_ = true;
                                    }
                                    let _e1548 = phi_2718_;
                                    let _e1550 = phi_2719_;
                                    if _e1550 {
                                        let _e1551 = (_e1525 & 2147483648u);
                                        let _e1558 = ((_e1525 & 8388607u) | (select(0u, 1u, ((_e1525 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1562 = (_e1558 == 0u);
                                        if _e1562 {
                                            phi_2908_ = bitcast<f32>(_e1551);
                                        } else {
                                            let _e1567 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1558)), 32u, _e1562) - 8u);
                                            let _e1570 = (_e1558 << bitcast<u32>((_e1567 & 31u)));
                                            let _e1572 = ((_e1530 + select(0i, 1i, (_e1529 == 0i))) - bitcast<i32>(_e1567));
                                            if (_e1572 >= 255i) {
                                                phi_2898_ = bitcast<f32>((_e1551 | 2139095040u));
                                                phi_2899_ = f32();
                                                phi_2900_ = true;
                                            } else {
                                                let _e1574 = (_e1572 > 0i);
                                                if _e1574 {
                                                    phi_2892_ = bitcast<f32>(((_e1551 | (bitcast<u32>(_e1572) << bitcast<u32>(23i))) | (_e1570 & 8388607u)));
                                                    phi_2893_ = f32();
                                                } else {
                                                    if (_e1572 < -24i) {
                                                        phi_2858_ = 26u;
                                                    } else {
                                                        phi_2858_ = bitcast<u32>((1i - _e1572));
                                                    }
                                                    let _e1579 = phi_2858_;
                                                    let _e1580 = (_e1579 & 31u);
                                                    let _e1582 = (_e1570 >> bitcast<u32>(_e1580));
                                                    let _e1586 = (_e1570 & ((1u << bitcast<u32>(_e1580)) - 1u));
                                                    let _e1590 = (1u << bitcast<u32>(((_e1579 - 1u) & 31u)));
                                                    if (_e1586 > _e1590) {
                                                        phi_2879_ = true;
                                                    } else {
                                                        if (_e1586 == _e1590) {
                                                            phi_2876_ = ((_e1582 & 1u) == 1u);
                                                        } else {
                                                            phi_2876_ = false;
                                                        }
                                                        let _e1596 = phi_2876_;
                                                        phi_2879_ = _e1596;
                                                    }
                                                    let _e1598 = phi_2879_;
                                                    phi_2892_ = f32();
                                                    phi_2893_ = bitcast<f32>((_e1551 | (_e1582 + select(0u, 1u, _e1598))));
                                                }
                                                let _e1611 = phi_2892_;
                                                let _e1613 = phi_2893_;
                                                phi_2898_ = _e1611;
                                                phi_2899_ = _e1613;
                                                phi_2900_ = _e1574;
                                            }
                                            let _e1617 = phi_2898_;
                                            let _e1619 = phi_2899_;
                                            let _e1621 = phi_2900_;
                                            phi_2908_ = select(_e1619, _e1617, _e1621);
                                        }
                                        let _e1625 = phi_2908_;
                                        phi_2734_ = _e1625;
                                    } else {
                                        phi_2734_ = _e1548;
                                    }
                                    let _e1627 = phi_2734_;
                                    phi_2735_ = _e1627;
                                }
                                let _e1629 = phi_2735_;
                                let _e1630 = bitcast<u32>(_e1629);
                                if ((_e1630 & 2147483647u) >= 2139095040u) {
                                    phi_2747_ = bitcast<f32>(((_e1630 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_2747_ = _e1629;
                                }
                                let _e1637 = phi_2747_;
                                phi_2752_ = type_23(_e1637, _e1518.member_1, _e1518.member_2, _e1518.member_3);
                            } else {
                                phi_2752_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1640 = phi_2752_;
                            if _e1516 {
                            } else {
                                phi_3137_ = true;
                                break;
                            }
                            local[_e1511.member_1] = type_23(_e1640.member, _e1640.member_1, _e1640.member_2, _e1640.member_3);
                        }
                        continue;
                        continuing {
                            phi_2638_ = _e1509;
                            phi_3137_ = _e1494;
                            break if !(_e1515);
                        }
                    }
                    let _e1648 = phi_3137_;
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
