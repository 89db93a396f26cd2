struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_31 {
    member: array<type_22>,
}

struct type_33 {
    member: f32,
    member_1: bool,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_39;
@group(0) @binding(3) 
var<storage> global_6: type_46;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_370_: i32;
    var phi_371_: i32;
    var phi_381_: bool;
    var phi_391_: u32;
    var phi_392_: u32;
    var phi_394_: bool;
    var phi_399_: u32;
    var phi_412_: i32;
    var phi_432_: i32;
    var phi_450_: f32;
    var phi_456_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_746_: f32;
    var phi_752_: f32;
    var phi_871_: i32;
    var phi_893_: u32;
    var phi_894_: u32;
    var phi_931_: i32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_3504_: bool;
    var phi_1046_: type_33;
    var phi_1049_: bool;
    var phi_1051_: type_50;
    var phi_1053_: u32;
    var phi_1055_: u32;
    var phi_1066_: bool;
    var phi_1152_: bool;
    var phi_1153_: type_50;
    var phi_1154_: u32;
    var phi_2305_: type_37;
    var phi_3191_: type_50;
    var phi_3267_: type_50;
    var phi_3268_: type_50;
    var phi_3269_: u32;
    var phi_3271_: type_50;
    var phi_3272_: u32;
    var phi_3273_: bool;
    var phi_3280_: type_50;
    var phi_3285_: bool;
    var phi_3286_: type_50;
    var phi_1173_: type_33;
    var phi_1176_: type_7;
    var phi_1177_: type_7;
    var phi_1199_: type_7;
    var phi_1224_: u32;
    var phi_1240_: type_44;
    var phi_2035_: f32;
    var phi_2036_: f32;
    var phi_2037_: f32;
    var phi_2038_: f32;
    var phi_2039_: vec3<f32>;
    var phi_2040_: vec3<f32>;
    var phi_2041_: vec3<f32>;
    var phi_2042_: vec3<f32>;
    var phi_2233_: f32;
    var phi_2253_: type_29;
    var phi_2254_: type_29;
    var phi_2257_: type_29;
    var phi_2258_: type_29;
    var phi_2259_: bool;
    var phi_2263_: type_29;
    var phi_2272_: type_21;
    var phi_2283_: type_33;
    var phi_2284_: type_33;
    var phi_1174_: type_33;
    var phi_3498_: bool;
    var local_10: type_33;
    var phi_3670_: bool;
    var phi_3288_: type_33;
    var phi_3289_: bool;
    var phi_3290_: type_50;
    var phi_3291_: u32;
    var phi_3669_: bool;
    var phi_3292_: type_33;
    var phi_3293_: bool;
    var phi_3294_: type_50;
    var phi_3295_: u32;
    var phi_3296_: u32;
    var phi_3668_: bool;
    var phi_3297_: type_33;
    var phi_3298_: bool;
    var phi_3299_: type_50;
    var phi_3300_: u32;
    var phi_3301_: u32;
    var phi_3667_: bool;
    var phi_1047_: type_33;
    var phi_1050_: bool;
    var phi_1052_: type_50;
    var phi_1054_: u32;
    var phi_1056_: u32;
    var phi_3302_: bool;
    var phi_3666_: bool;
    var local_11: type_33;
    var local_12: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e94 = global_2.member[0u][0u];
            let _e98 = global_2.member[0u][1u];
            let _e102 = global_2.member[0u][2u];
            let _e106 = global_2.member[1u][0u];
            let _e110 = global_2.member[1u][1u];
            let _e114 = global_2.member[1u][2u];
            let _e118 = global_2.member[1u][3u];
            let _e121 = global_1.member[0u];
            let _e122 = bitcast<i32>(_e121);
            let _e132 = (_e80.x + (_e80.y * 2097152u));
            let _e133 = (_e132 < arrayLength((&global_3.member)));
            if _e133 {
                let _e134 = (_e132 < arrayLength((&global_4.member)));
                if _e134 {
                    if _e133 {
                    } else {
                        break;
                    }
                    let _e142 = global_3.member[_e132].member_2[0u];
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e149 = global_3.member[_e132].member_2[1u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_3.member[_e132].member_2[2u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_3.member[_e132].member[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e132].member[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e132].member[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e181 = select(_e151, _e144, (_e151 < _e144));
                    let _e183 = select(_e158, _e181, (_e158 < _e181));
                    let _e185 = select(_e165, _e183, (_e165 < _e183));
                    let _e187 = select(_e172, _e185, (_e172 < _e185));
                    let _e189 = select(_e179, _e187, (_e179 < _e187));
                    let _e193 = global_3.member[_e132].member_1;
                    let _e194 = bitcast<u32>(_e193);
                    let _e195 = (_e194 & 2147483647u);
                    let _e202 = global_3.member[_e132].member_3;
                    let _e203 = bitcast<u32>(_e202);
                    let _e204 = (_e203 & 2147483647u);
                    let _e208 = (((select(_e195, _e189, (_e195 < _e189)) < 2139095040u) && (_e204 <= 2139095040u)) && (_e183 > 0u));
                    if _e208 {
                        let _e211 = (bitcast<u32>(bitcast<f32>(_e183)) & 2147483647u);
                        if (_e211 >= 8388608u) {
                            phi_370_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_370_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_370_;
                        phi_371_ = _e225;
                    } else {
                        phi_371_ = 0i;
                    }
                    let _e227 = phi_371_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_381_ = true;
                    } else {
                        phi_381_ = (_e151 == _e183);
                    }
                    let _e231 = phi_381_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_391_ = _e233;
                        phi_392_ = _e233;
                        phi_394_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_391_ = u32();
                        phi_392_ = 0u;
                        phi_394_ = true;
                    }
                    let _e237 = phi_391_;
                    let _e239 = phi_392_;
                    let _e241 = phi_394_;
                    if _e241 {
                        phi_399_ = (_e239 + 1u);
                    } else {
                        phi_399_ = 0u;
                    }
                    let _e245 = phi_399_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_412_ = -126i;
                    } else {
                        phi_412_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_412_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_432_ = -126i;
                    } else {
                        phi_432_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_432_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_3.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_450_ = _e284[0];
                    } else {
                        phi_450_ = _e284[1];
                    }
                    let _e289 = phi_450_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_456_ = _e284[2];
                    } else {
                        phi_456_ = _e289;
                    }
                    let _e293 = phi_456_;
                    let _e294 = bitcast<u32>(_e293);
                    let _e296 = ((_e294 & 2139095040u) != 0u);
                    let _e310 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * _e257) * select(0.00000011920929f, 1f, _e296)) * _e263);
                    let _e311 = global_3.member[_e132].member_2;
                    if _e285 {
                        phi_496_ = _e311[0];
                    } else {
                        phi_496_ = _e311[1];
                    }
                    let _e315 = phi_496_;
                    if _e290 {
                        phi_502_ = _e311[2];
                    } else {
                        phi_502_ = _e315;
                    }
                    let _e318 = phi_502_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e274) * select(0.00000011920929f, 1f, _e321)) * _e280);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e342 = bitcast<f32>((bitcast<u32>(_e310) & 2147483647u));
                    let _e343 = (_e342 * 0.00000011920929f);
                    let _e346 = select(select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f)), 0f, _e339);
                    let _e347 = select(0f, _e335, _e339);
                    let _e348 = (_e310 + _e346);
                    let _e349 = (_e310 - _e346);
                    let _e351 = select(38685626000000000000000000f, (1f / _e335), _e339);
                    let _e352 = (_e245 == 0u);
                    if _e352 {
                        phi_575_ = _e284[0];
                    } else {
                        phi_575_ = _e284[1];
                    }
                    let _e356 = phi_575_;
                    let _e357 = (_e245 == 2u);
                    if _e357 {
                        phi_581_ = _e284[2];
                    } else {
                        phi_581_ = _e356;
                    }
                    let _e360 = phi_581_;
                    let _e361 = bitcast<u32>(_e360);
                    let _e363 = ((_e361 & 2139095040u) != 0u);
                    let _e377 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e360, _e363) * _e257) * select(0.00000011920929f, 1f, _e363)) * _e263);
                    if _e352 {
                        phi_621_ = _e311[0];
                    } else {
                        phi_621_ = _e311[1];
                    }
                    let _e381 = phi_621_;
                    if _e357 {
                        phi_627_ = _e311[2];
                    } else {
                        phi_627_ = _e381;
                    }
                    let _e384 = phi_627_;
                    let _e385 = bitcast<u32>(_e384);
                    let _e387 = ((_e385 & 2139095040u) != 0u);
                    let _e401 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e385 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e385 & 2147483648u))), _e384, _e387) * _e274) * select(0.00000011920929f, 1f, _e387)) * _e280);
                    let _e405 = (bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e408 = bitcast<f32>((bitcast<u32>(_e377) & 2147483647u));
                    let _e409 = (_e408 * 0.00000011920929f);
                    let _e412 = select(select(0.00000000000011368684f, _e409, (_e409 > 0.00000000000011368684f)), 0f, _e405);
                    let _e413 = select(0f, _e401, _e405);
                    let _e414 = (_e377 + _e412);
                    let _e415 = (_e377 - _e412);
                    let _e417 = select(38685626000000000000000000f, (1f / _e401), _e405);
                    let _e418 = (_e247 == 0u);
                    if _e418 {
                        phi_700_ = _e284[0];
                    } else {
                        phi_700_ = _e284[1];
                    }
                    let _e422 = phi_700_;
                    let _e423 = (_e247 == 2u);
                    if _e423 {
                        phi_706_ = _e284[2];
                    } else {
                        phi_706_ = _e422;
                    }
                    let _e426 = phi_706_;
                    let _e427 = bitcast<u32>(_e426);
                    let _e429 = ((_e427 & 2139095040u) != 0u);
                    let _e443 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e427 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e427 & 2147483648u))), _e426, _e429) * _e257) * select(0.00000011920929f, 1f, _e429)) * _e263);
                    if _e418 {
                        phi_746_ = _e311[0];
                    } else {
                        phi_746_ = _e311[1];
                    }
                    let _e447 = phi_746_;
                    if _e423 {
                        phi_752_ = _e311[2];
                    } else {
                        phi_752_ = _e447;
                    }
                    let _e450 = phi_752_;
                    let _e451 = bitcast<u32>(_e450);
                    let _e453 = ((_e451 & 2139095040u) != 0u);
                    let _e467 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e451 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e451 & 2147483648u))), _e450, _e453) * _e274) * select(0.00000011920929f, 1f, _e453)) * _e280);
                    let _e471 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e474 = bitcast<f32>((bitcast<u32>(_e443) & 2147483647u));
                    let _e475 = (_e474 * 0.00000011920929f);
                    let _e478 = select(select(0.00000000000011368684f, _e475, (_e475 > 0.00000000000011368684f)), 0f, _e471);
                    let _e479 = select(0f, _e467, _e471);
                    let _e480 = (_e443 + _e478);
                    let _e481 = (_e443 - _e478);
                    let _e483 = select(38685626000000000000000000f, (1f / _e467), _e471);
                    let _e485 = select(_e408, _e342, (_e342 > _e408));
                    let _e488 = (_e122 + _e227);
                    if (_e208 && (select(_e474, _e485, (_e485 > _e474)) <= 1099511600000f)) {
                        let _e498 = ((_e195 & 8388607u) | (select(0u, 1u, ((_e195 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e501 = bitcast<i32>((_e195 >> bitcast<u32>(23i)));
                        let _e505 = (_e498 == 0u);
                        let _e508 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, _e505)) - 8i);
                        if (_e501 == 255i) {
                            phi_871_ = 255i;
                        } else {
                            phi_871_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e488);
                        }
                        let _e516 = phi_871_;
                        let _e526 = (_e516 <= 0i);
                        if _e526 {
                            phi_894_ = u32();
                        } else {
                            if _e505 {
                                phi_893_ = u32();
                            } else {
                                phi_893_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | ((_e498 << bitcast<u32>(((_e508 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e516 >= 255i));
                            }
                            let _e530 = phi_893_;
                            phi_894_ = _e530;
                        }
                        let _e532 = phi_894_;
                        let _e544 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e547 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
                        let _e551 = (_e544 == 0u);
                        let _e554 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e544)), 32u, _e551)) - 8i);
                        if (_e547 == 255i) {
                            phi_931_ = 255i;
                        } else {
                            phi_931_ = (((_e547 + select(0i, 1i, (_e547 == 0i))) - _e554) + _e488);
                        }
                        let _e562 = phi_931_;
                        let _e572 = (_e562 <= 0i);
                        if _e572 {
                            phi_954_ = u32();
                        } else {
                            if _e551 {
                                phi_953_ = u32();
                            } else {
                                phi_953_ = select(((bitcast<u32>(_e562) << bitcast<u32>(23i)) | ((_e544 << bitcast<u32>(((_e554 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e562 >= 255i));
                            }
                            let _e576 = phi_953_;
                            phi_954_ = _e576;
                        }
                        let _e578 = phi_954_;
                        phi_962_ = bitcast<f32>(((_e203 & 2147483648u) | select(_e578, 0u, select(_e551, true, _e572))));
                        phi_963_ = bitcast<f32>(((_e194 & 2147483648u) | select(_e532, 0u, select(_e505, true, _e526))));
                    } else {
                        phi_962_ = 0f;
                        phi_963_ = 1f;
                    }
                    let _e584 = phi_962_;
                    let _e586 = phi_963_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                    let _e593 = (_e246 % 3u);
                    let _e594 = (_e593 < 3u);
                    if _e594 {
                    } else {
                        break;
                    }
                    let _e596 = local_9[_e593];
                    let _e597 = (_e245 % 3u);
                    let _e598 = (_e597 < 3u);
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e600 = local_9[_e597];
                    let _e601 = (_e247 % 3u);
                    let _e602 = (_e601 < 3u);
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e604 = local_9[_e601];
                    local_8 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    if _e594 {
                    } else {
                        break;
                    }
                    let _e608 = local_8[_e593];
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e610 = local_8[_e597];
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e612 = local_8[_e601];
                    phi_3504_ = false;
                    phi_1046_ = type_33(_e584, false);
                    phi_1049_ = (_e586 <= _e584);
                    phi_1051_ = type_50(type_42(array<f32, 3>(_e596, _e600, _e604), array<f32, 3>(_e608, _e610, _e612)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_1053_ = 0u;
                    phi_1055_ = ((3u * _e83) + 1u);
                    loop {
                        let _e618 = phi_3504_;
                        let _e620 = phi_1046_;
                        let _e622 = phi_1049_;
                        let _e624 = phi_1051_;
                        let _e626 = phi_1053_;
                        let _e628 = phi_1055_;
                        local_11 = _e620;
                        if _e622 {
                            phi_1066_ = true;
                        } else {
                            phi_1066_ = (_e626 > 0u);
                        }
                        let _e631 = phi_1066_;
                        if _e631 {
                            let _e632 = (_e628 > 0u);
                            if _e632 {
                                if _e622 {
                                    phi_1152_ = _e622;
                                    phi_1153_ = _e624;
                                    phi_1154_ = _e626;
                                } else {
                                    let _e633 = (_e626 - 1u);
                                    let _e634 = (_e633 % 128u);
                                    let _e635 = (_e634 < 128u);
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e637 = local_6[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e639 = local_5[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e641 = local_4[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e643 = local_3[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e646 = local_2[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e648 = local_1[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e650 = local[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3666_ = true;
                                        break;
                                    }
                                    let _e655 = local_7[_e634];
                                    phi_1152_ = (_e655 <= _e620.member);
                                    phi_1153_ = type_50(type_42(array<f32, 3>(_e639, _e641, _e643), array<f32, 3>(_e646, _e648, _e650)), _e637);
                                    phi_1154_ = _e633;
                                }
                                let _e659 = phi_1152_;
                                let _e661 = phi_1153_;
                                let _e663 = phi_1154_;
                                if _e659 {
                                    if ((_e661.member_1 & 2147483648u) != 0u) {
                                        phi_1173_ = _e620;
                                        phi_1176_ = type_7(0u, ((_e661.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1039 = phi_1173_;
                                            let _e1041 = phi_1176_;
                                            local_10 = _e1039;
                                            local_12 = _e1039;
                                            if (_e1041.member < _e1041.member_1) {
                                                phi_1177_ = type_7((_e1041.member + 1u), _e1041.member_1);
                                                phi_1199_ = type_7(1u, _e1041.member);
                                            } else {
                                                phi_1177_ = _e1041;
                                                phi_1199_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1054 = phi_1177_;
                                            let _e1056 = phi_1199_;
                                            let _e1060 = (bitcast<i32>(_e1056.member) != 0i);
                                            if _e1060 {
                                                let _e1061 = ((_e661.member_1 & 268435455u) + _e1056.member_1);
                                                let _e1062 = (_e1061 < arrayLength((&global_6.member)));
                                                if _e1062 {
                                                    if _e1062 {
                                                    } else {
                                                        phi_3498_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_6.member[_e1061].member_1;
                                                    phi_1224_ = _e1065;
                                                } else {
                                                    phi_1224_ = 4294967295u;
                                                }
                                                let _e1067 = phi_1224_;
                                                if _e1062 {
                                                    if _e1062 {
                                                    } else {
                                                        phi_3498_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_6.member[_e1061];
                                                    phi_1240_ = _e1069;
                                                } else {
                                                    phi_1240_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1071 = phi_1240_;
                                                let _e1083 = ((10u * _e246) & 31u);
                                                let _e1086 = ((_e1071.member[0] >> bitcast<u32>(_e1083)) & 1023u);
                                                let _e1094 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[0] - _e661.member.member[0]) * 0.0009775171f)) ^ _e118));
                                                let _e1099 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1086)) - 8388608f) * _e1094)) ^ _e118)));
                                                let _e1103 = select(select(_e661.member.member_1[0], _e1099, (_e1099 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1086 == 1023u));
                                                let _e1105 = ((10u * _e245) & 31u);
                                                let _e1108 = ((_e1071.member[0] >> bitcast<u32>(_e1105)) & 1023u);
                                                let _e1116 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[1] - _e661.member.member[1]) * 0.0009775171f)) ^ _e118));
                                                let _e1121 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1108)) - 8388608f) * _e1116)) ^ _e118)));
                                                let _e1125 = select(select(_e661.member.member_1[1], _e1121, (_e1121 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1108 == 1023u));
                                                let _e1127 = ((10u * _e247) & 31u);
                                                let _e1130 = ((_e1071.member[0] >> bitcast<u32>(_e1127)) & 1023u);
                                                let _e1138 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[2] - _e661.member.member[2]) * 0.0009775171f)) ^ _e118));
                                                let _e1143 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1130)) - 8388608f) * _e1138)) ^ _e118)));
                                                let _e1147 = select(select(_e661.member.member_1[2], _e1143, (_e1143 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1130 == 1023u));
                                                let _e1151 = ((_e1071.member[1] >> bitcast<u32>(_e1083)) & 1023u);
                                                let _e1159 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1151)) - 8388608f) * _e1094)) ^ _e118)));
                                                let _e1163 = select(select(_e661.member.member_1[0], _e1159, (_e1159 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1151 == 1023u));
                                                let _e1166 = ((_e1071.member[1] >> bitcast<u32>(_e1105)) & 1023u);
                                                let _e1174 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1166)) - 8388608f) * _e1116)) ^ _e118)));
                                                let _e1178 = select(select(_e661.member.member_1[1], _e1174, (_e1174 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1166 == 1023u));
                                                let _e1181 = ((_e1071.member[1] >> bitcast<u32>(_e1127)) & 1023u);
                                                let _e1189 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1181)) - 8388608f) * _e1138)) ^ _e118)));
                                                let _e1193 = select(select(_e661.member.member_1[2], _e1189, (_e1189 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1181 == 1023u));
                                                let _e1197 = ((_e1071.member[2] >> bitcast<u32>(_e1083)) & 1023u);
                                                let _e1205 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1197)) - 8388608f) * _e1094)) ^ _e118)));
                                                let _e1209 = select(select(_e661.member.member_1[0], _e1205, (_e1205 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e1197 == 1023u));
                                                let _e1212 = ((_e1071.member[2] >> bitcast<u32>(_e1105)) & 1023u);
                                                let _e1220 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1212)) - 8388608f) * _e1116)) ^ _e118)));
                                                let _e1224 = select(select(_e661.member.member_1[1], _e1220, (_e1220 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e1212 == 1023u));
                                                let _e1227 = ((_e1071.member[2] >> bitcast<u32>(_e1127)) & 1023u);
                                                let _e1235 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1227)) - 8388608f) * _e1138)) ^ _e118)));
                                                let _e1239 = select(select(_e661.member.member_1[2], _e1235, (_e1235 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e1227 == 1023u));
                                                let _e1243 = (_e1147 - _e443);
                                                let _e1246 = (((_e1103 - _e310) * _e479) - (_e1243 * _e347));
                                                let _e1249 = (((_e1125 - _e377) * _e479) - (_e1243 * _e413));
                                                let _e1252 = (_e1193 - _e443);
                                                let _e1255 = (((_e1163 - _e310) * _e479) - (_e1252 * _e347));
                                                let _e1258 = (((_e1178 - _e377) * _e479) - (_e1252 * _e413));
                                                let _e1261 = (_e1239 - _e443);
                                                let _e1264 = (((_e1209 - _e310) * _e479) - (_e1261 * _e347));
                                                let _e1267 = (((_e1224 - _e377) * _e479) - (_e1261 * _e413));
                                                let _e1268 = (_e1264 * _e1258);
                                                let _e1269 = (_e1267 * _e1255);
                                                let _e1270 = (_e1246 * _e1267);
                                                let _e1271 = (_e1249 * _e1264);
                                                let _e1272 = (_e1255 * _e1249);
                                                let _e1273 = (_e1258 * _e1246);
                                                let _e1278 = (((_e1268 >= _e1269) && (_e1270 >= _e1271)) && (_e1272 >= _e1273));
                                                let _e1284 = (_e1278 || (((_e1268 <= _e1269) && (_e1270 <= _e1271)) && (_e1272 <= _e1273)));
                                                if _e1284 {
                                                    let _e1286 = select(-1f, 1f, _e1278);
                                                    let _e1288 = ((_e1268 - _e1269) * _e1286);
                                                    let _e1290 = select(0f, _e1288, (_e1288 > 0f));
                                                    let _e1292 = ((_e1270 - _e1271) * _e1286);
                                                    let _e1294 = select(0f, _e1292, (_e1292 > 0f));
                                                    let _e1296 = ((_e1272 - _e1273) * _e1286);
                                                    let _e1298 = select(0f, _e1296, (_e1296 > 0f));
                                                    let _e1300 = ((_e1290 + _e1294) + _e1298);
                                                    let _e1302 = select(_e1163, _e1103, (_e1103 < _e1163));
                                                    let _e1306 = select(_e1163, _e1103, (_e1103 > _e1163));
                                                    let _e1310 = select(_e1178, _e1125, (_e1125 < _e1178));
                                                    let _e1314 = select(_e1178, _e1125, (_e1125 > _e1178));
                                                    let _e1318 = select(_e1193, _e1147, (_e1147 < _e1193));
                                                    let _e1322 = select(_e1193, _e1147, (_e1147 > _e1193));
                                                    let _e1327 = ((select(_e1209, _e1302, (_e1302 < _e1209)) - _e348) * _e351);
                                                    let _e1328 = ((select(_e1209, _e1306, (_e1306 > _e1209)) - _e349) * _e351);
                                                    let _e1331 = ((select(_e1224, _e1310, (_e1310 < _e1224)) - _e414) * _e417);
                                                    let _e1332 = ((select(_e1224, _e1314, (_e1314 > _e1224)) - _e415) * _e417);
                                                    let _e1335 = ((select(_e1239, _e1318, (_e1318 < _e1239)) - _e480) * _e483);
                                                    let _e1336 = ((select(_e1239, _e1322, (_e1322 > _e1239)) - _e481) * _e483);
                                                    let _e1338 = select(_e1336, _e1335, (_e1335 < _e1336));
                                                    let _e1340 = select(_e1336, _e1335, (_e1335 > _e1336));
                                                    let _e1342 = select(_e1328, _e1327, (_e1327 < _e1328));
                                                    let _e1344 = select(_e1332, _e1331, (_e1331 < _e1332));
                                                    let _e1346 = select(_e1344, _e1342, (_e1342 > _e1344));
                                                    let _e1348 = select(_e1338, _e1346, (_e1346 > _e1338));
                                                    let _e1350 = select(_e1328, _e1327, (_e1327 > _e1328));
                                                    let _e1352 = select(_e1332, _e1331, (_e1331 > _e1332));
                                                    let _e1354 = select(_e1352, _e1350, (_e1350 < _e1352));
                                                    let _e1356 = select(_e1340, _e1354, (_e1354 < _e1340));
                                                    let _e1357 = -(_e1338);
                                                    let _e1363 = select(_e586, _e1348, (_e1348 > _e586));
                                                    let _e1367 = select(_e1255, _e1246, (_e1246 < _e1255));
                                                    let _e1372 = select(_e1255, _e1246, (_e1246 > _e1255));
                                                    let _e1379 = select(_e1258, _e1249, (_e1249 < _e1258));
                                                    let _e1384 = select(_e1258, _e1249, (_e1249 > _e1258));
                                                    let _e1393 = (((((_e1284 && (_e1300 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1264, _e1367, (_e1367 < _e1264)) <= 0f) && (select(_e1264, _e1372, (_e1372 > _e1264)) >= 0f))) && ((select(_e1267, _e1379, (_e1379 < _e1267)) <= 0f) && (select(_e1267, _e1384, (_e1384 > _e1267)) >= 0f))) && (_e1363 <= (_e1356 + (select(_e1357, _e1340, (_e1340 > _e1357)) * 0.0000019073523f)))) && (_e1363 <= _e1039.member));
                                                    if _e1393 {
                                                        let _e1398 = (_e1163 - _e1103);
                                                        let _e1399 = (_e1178 - _e1125);
                                                        let _e1400 = (_e1193 - _e1147);
                                                        let _e1401 = vec3<f32>(_e1398, _e1399, _e1400);
                                                        let _e1402 = (_e1209 - _e1163);
                                                        let _e1403 = (_e1224 - _e1178);
                                                        let _e1404 = (_e1239 - _e1193);
                                                        let _e1405 = vec3<f32>(_e1402, _e1403, _e1404);
                                                        let _e1406 = (_e1103 - _e1209);
                                                        let _e1407 = (_e1125 - _e1224);
                                                        let _e1408 = (_e1147 - _e1239);
                                                        let _e1409 = vec3<f32>(_e1406, _e1407, _e1408);
                                                        let _e1412 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                        let _e1415 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                        let _e1417 = select(_e1415, _e1412, (_e1412 > _e1415));
                                                        let _e1420 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                        let _e1422 = select(_e1420, _e1417, (_e1417 > _e1420));
                                                        let _e1425 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                        let _e1428 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                        let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                        let _e1441 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                        let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1448 = select(_e1446, _e1443, (_e1443 > _e1446));
                                                        let _e1450 = select(_e1435, _e1422, (_e1422 > _e1435));
                                                        let _e1452 = select(_e1448, _e1450, (_e1450 > _e1448));
                                                        if (_e1422 == _e1452) {
                                                            phi_2035_ = _e1258;
                                                            phi_2036_ = _e1255;
                                                            phi_2037_ = _e1249;
                                                            phi_2038_ = _e1246;
                                                            phi_2039_ = vec3<f32>(_e1103, _e1125, _e1147);
                                                            phi_2040_ = _e1409;
                                                            phi_2041_ = _e1405;
                                                            phi_2042_ = _e1401;
                                                        } else {
                                                            let _e1454 = (_e1435 == _e1452);
                                                            let _e1459 = vec3(_e1454);
                                                            phi_2035_ = select(_e1249, _e1267, _e1454);
                                                            phi_2036_ = select(_e1246, _e1264, _e1454);
                                                            phi_2037_ = select(_e1267, _e1258, _e1454);
                                                            phi_2038_ = select(_e1264, _e1255, _e1454);
                                                            phi_2039_ = select(vec3<f32>(_e1209, _e1224, _e1239), vec3<f32>(_e1163, _e1178, _e1193), _e1459);
                                                            phi_2040_ = select(_e1405, _e1401, _e1459);
                                                            phi_2041_ = select(_e1401, _e1409, _e1459);
                                                            phi_2042_ = select(_e1409, _e1405, _e1459);
                                                        }
                                                        let _e1465 = phi_2035_;
                                                        let _e1467 = phi_2036_;
                                                        let _e1469 = phi_2037_;
                                                        let _e1471 = phi_2038_;
                                                        let _e1473 = phi_2039_;
                                                        let _e1475 = phi_2040_;
                                                        let _e1477 = phi_2041_;
                                                        let _e1479 = phi_2042_;
                                                        let _e1486 = ((_e1477.y * _e1475.z) - (_e1475.y * _e1477.z));
                                                        let _e1491 = ((_e1477.z * _e1475.x) - (_e1475.z * _e1477.x));
                                                        let _e1494 = ((_e1477.x * _e1475.y) - (_e1475.x * _e1477.y));
                                                        let _e1497 = ((_e1290 >= _e1294) && (_e1290 >= _e1298));
                                                        let _e1498 = (_e1294 >= _e1298);
                                                        let _e1512 = (((_e1486 * (select(select(_e1209, _e1163, _e1498), _e1103, _e1497) - _e310)) + (_e1491 * (select(select(_e1224, _e1178, _e1498), _e1125, _e1497) - _e377))) + (_e1494 * (select(select(_e1239, _e1193, _e1498), _e1147, _e1497) - _e443)));
                                                        let _e1517 = (((_e1486 * _e347) + (_e1491 * _e413)) + (_e1494 * _e479));
                                                        let _e1518 = (_e1467 - _e1471);
                                                        let _e1519 = (_e1465 - _e1469);
                                                        let _e1522 = ((_e1518 * _e1518) + (_e1519 * _e1519));
                                                        let _e1529 = (-(((_e1471 * _e1518) + (_e1469 * _e1519))) / select(0.000000000000000000000000000000000000011754944f, _e1522, (_e1522 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1531 = select(1f, _e1529, (_e1529 < 1f));
                                                        let _e1533 = select(0f, _e1531, (_e1531 > 0f));
                                                        let _e1542 = ((_e1473.x + (_e1479.x * _e1533)) - _e310);
                                                        let _e1545 = ((_e1473.y + (_e1479.y * _e1533)) - _e377);
                                                        let _e1548 = ((_e1473.z + (_e1479.z * _e1533)) - _e443);
                                                        let _e1551 = bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u));
                                                        let _e1554 = bitcast<f32>((bitcast<u32>(_e1545) & 2147483647u));
                                                        let _e1556 = select(_e1554, _e1551, (_e1551 > _e1554));
                                                        let _e1559 = bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u));
                                                        let _e1561 = select(_e1559, _e1556, (_e1556 > _e1559));
                                                        let _e1567 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                        let _e1570 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                        let _e1572 = select(_e1570, _e1567, (_e1567 > _e1570));
                                                        let _e1575 = bitcast<f32>((bitcast<u32>(_e1494) & 2147483647u));
                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1477.x) & 2147483647u));
                                                        let _e1597 = bitcast<f32>((bitcast<u32>(_e1477.y) & 2147483647u));
                                                        let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1477.z) & 2147483647u));
                                                        let _e1608 = bitcast<f32>((bitcast<u32>(_e1475.x) & 2147483647u));
                                                        let _e1611 = bitcast<f32>((bitcast<u32>(_e1475.y) & 2147483647u));
                                                        let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                        let _e1616 = bitcast<f32>((bitcast<u32>(_e1475.z) & 2147483647u));
                                                        let _e1622 = ((bitcast<f32>((bitcast<u32>(((((_e1486 * _e1542) + (_e1491 * _e1545)) + (_e1494 * _e1548)) - _e1512)) & 2147483647u)) <= ((0.0000009536743f * select(_e1452, _e1561, (_e1561 > _e1452))) * select(_e1575, _e1572, (_e1572 > _e1575)))) && !((bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u)) <= ((0.0000038146973f * select(_e1602, _e1599, (_e1599 > _e1602))) * select(_e1616, _e1613, (_e1613 > _e1616))))));
                                                        let _e1623 = (_e1512 / _e1517);
                                                        if (_e1393 && !(_e1622)) {
                                                            let _e1626 = (_e1548 / _e479);
                                                            let _e1634 = (((_e1486 * (_e1542 - (_e347 * _e1626))) + (_e1491 * (_e1545 - (_e413 * _e1626)))) / _e1517);
                                                            phi_2233_ = select(select(_e1626, (_e1626 + _e1634), (bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u)) <= _e1452)), _e1623, _e1622);
                                                        } else {
                                                            phi_2233_ = _e1623;
                                                        }
                                                        let _e1643 = phi_2233_;
                                                        let _e1645 = select(_e1356, _e1643, (_e1643 < _e1356));
                                                        let _e1647 = select(_e1348, _e1645, (_e1645 > _e1348));
                                                        let _e1648 = (1f / _e1300);
                                                        phi_2253_ = type_29(_e1647, (_e1294 * _e1648), (_e1298 * _e1648), ((_e1393 && (_e1647 >= _e586)) && (_e1647 <= _e1039.member)));
                                                        phi_2254_ = type_29();
                                                    } else {
                                                        phi_2253_ = type_29();
                                                        phi_2254_ = type_29(0f, 0f, 0f, _e1393);
                                                    }
                                                    let _e1657 = phi_2253_;
                                                    let _e1659 = phi_2254_;
                                                    phi_2257_ = _e1657;
                                                    phi_2258_ = _e1659;
                                                    phi_2259_ = select(true, false, _e1393);
                                                } else {
                                                    phi_2257_ = type_29();
                                                    phi_2258_ = type_29(0f, 0f, 0f, _e1284);
                                                    phi_2259_ = true;
                                                }
                                                let _e1662 = phi_2257_;
                                                let _e1664 = phi_2258_;
                                                let _e1666 = phi_2259_;
                                                if _e1666 {
                                                    phi_2263_ = _e1664;
                                                } else {
                                                    phi_2263_ = _e1662;
                                                }
                                                let _e1668 = phi_2263_;
                                                if _e1668.member_3 {
                                                    phi_2272_ = type_21(_e1668.member, _e1668.member_1, _e1668.member_2, _e1067);
                                                } else {
                                                    phi_2272_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1675 = phi_2272_;
                                                if (_e1675.member_3 != 4294967295u) {
                                                    if (_e1067 != 4294967295u) {
                                                        phi_2283_ = type_33(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2283_ = _e1039;
                                                    }
                                                    let _e1680 = phi_2283_;
                                                    phi_2284_ = _e1680;
                                                } else {
                                                    phi_2284_ = _e1039;
                                                }
                                                let _e1682 = phi_2284_;
                                                phi_1174_ = _e1682;
                                            } else {
                                                phi_1174_ = type_33();
                                            }
                                            let _e1684 = phi_1174_;
                                            continue;
                                            continuing {
                                                phi_1173_ = _e1684;
                                                phi_1176_ = _e1054;
                                                phi_3498_ = _e618;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1687 = phi_3498_;
                                        phi_3666_ = _e1687;
                                        if _e1687 {
                                            break;
                                        }
                                        let _e1689 = local_10;
                                        phi_3670_ = _e1687;
                                        let _e1830 = local_12;
                                        phi_3288_ = _e1830;
                                        phi_3289_ = false;
                                        phi_3290_ = _e661;
                                        phi_3291_ = select(_e663, 0u, (_e586 > _e1689.member));
                                    } else {
                                        let _e673 = (_e661.member_1 < _e83);
                                        if _e673 {
                                            if _e673 {
                                            } else {
                                                phi_3666_ = true;
                                                break;
                                            }
                                            let _e675 = global_5.member[_e661.member_1];
                                            phi_2305_ = _e675;
                                        } else {
                                            phi_2305_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e677 = phi_2305_;
                                        let _e692 = ((10u * _e246) & 31u);
                                        let _e695 = ((_e677.member[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e703 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[0] - _e661.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e708 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e695)) - 8388608f) * _e703)) ^ _e118)));
                                        let _e712 = select(select(_e661.member.member_1[0], _e708, (_e708 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e695 == 1023u));
                                        let _e714 = ((10u * _e245) & 31u);
                                        let _e717 = ((_e677.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[1] - _e661.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e730 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e734 = select(select(_e661.member.member_1[1], _e730, (_e730 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e717 == 1023u));
                                        let _e736 = ((10u * _e247) & 31u);
                                        let _e739 = ((_e677.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[2] - _e661.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e752 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e756 = select(select(_e661.member.member_1[2], _e752, (_e752 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e739 == 1023u));
                                        let _e759 = ((_e677.member[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e767 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e759)) - 8388608f) * _e703)) ^ _e118)));
                                        let _e771 = select(select(_e661.member.member_1[0], _e767, (_e767 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e759 == 1023u));
                                        let _e774 = ((_e677.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e782 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e774)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e786 = select(select(_e661.member.member_1[1], _e782, (_e782 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e774 == 1023u));
                                        let _e789 = ((_e677.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e797 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e789)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e801 = select(select(_e661.member.member_1[2], _e797, (_e797 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e789 == 1023u));
                                        let _e807 = ((_e677.member_1[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e815 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e703)) ^ _e118)));
                                        let _e819 = select(select(_e661.member.member_1[0], _e815, (_e815 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e807 == 1023u));
                                        let _e822 = ((_e677.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e830 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e834 = select(select(_e661.member.member_1[1], _e830, (_e830 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e822 == 1023u));
                                        let _e837 = ((_e677.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e845 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e849 = select(select(_e661.member.member_1[2], _e845, (_e845 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e837 == 1023u));
                                        let _e852 = ((_e677.member_1[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e860 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e703)) ^ _e118)));
                                        let _e864 = select(select(_e661.member.member_1[0], _e860, (_e860 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e852 == 1023u));
                                        let _e867 = ((_e677.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e875 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e867)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e879 = select(select(_e661.member.member_1[1], _e875, (_e875 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e867 == 1023u));
                                        let _e882 = ((_e677.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e890 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e894 = select(select(_e661.member.member_1[2], _e890, (_e890 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e882 == 1023u));
                                        let _e899 = type_50(type_42(array<f32, 3>(_e712, _e734, _e756), array<f32, 3>(_e771, _e786, _e801)), _e677.member_2);
                                        let _e904 = type_50(type_42(array<f32, 3>(_e819, _e834, _e849), array<f32, 3>(_e864, _e879, _e894)), _e677.member_3);
                                        let _e910 = ((_e712 - _e348) * _e351);
                                        let _e911 = ((_e819 - _e348) * _e351);
                                        let _e912 = ((_e771 - _e349) * _e351);
                                        let _e913 = ((_e864 - _e349) * _e351);
                                        let _e918 = ((_e734 - _e414) * _e417);
                                        let _e919 = ((_e834 - _e414) * _e417);
                                        let _e920 = ((_e786 - _e415) * _e417);
                                        let _e921 = ((_e879 - _e415) * _e417);
                                        let _e926 = ((_e756 - _e480) * _e483);
                                        let _e927 = ((_e849 - _e480) * _e483);
                                        let _e928 = ((_e801 - _e481) * _e483);
                                        let _e929 = ((_e894 - _e481) * _e483);
                                        let _e931 = select(_e928, _e926, (_e926 < _e928));
                                        let _e933 = select(_e929, _e927, (_e927 < _e929));
                                        let _e935 = select(_e928, _e926, (_e926 > _e928));
                                        let _e937 = select(_e929, _e927, (_e927 > _e929));
                                        let _e939 = select(_e912, _e910, (_e910 < _e912));
                                        let _e941 = select(_e913, _e911, (_e911 < _e913));
                                        let _e943 = select(_e920, _e918, (_e918 < _e920));
                                        let _e945 = select(_e921, _e919, (_e919 < _e921));
                                        let _e947 = select(_e943, _e939, (_e939 > _e943));
                                        let _e949 = select(_e945, _e941, (_e941 > _e945));
                                        let _e951 = select(_e931, _e947, (_e947 > _e931));
                                        let _e953 = select(_e933, _e949, (_e949 > _e933));
                                        let _e955 = select(_e912, _e910, (_e910 > _e912));
                                        let _e957 = select(_e913, _e911, (_e911 > _e913));
                                        let _e959 = select(_e920, _e918, (_e918 > _e920));
                                        let _e961 = select(_e921, _e919, (_e919 > _e921));
                                        let _e963 = select(_e959, _e955, (_e955 < _e959));
                                        let _e965 = select(_e961, _e957, (_e957 < _e961));
                                        let _e970 = -(_e931);
                                        let _e971 = -(_e933);
                                        let _e978 = (select(_e935, _e963, (_e963 < _e935)) + (select(_e970, _e935, (_e935 > _e970)) * 0.0000019073523f));
                                        let _e979 = (select(_e937, _e965, (_e965 < _e937)) + (select(_e971, _e937, (_e937 > _e971)) * 0.0000019073523f));
                                        let _e981 = select(_e586, _e951, (_e951 > _e586));
                                        let _e983 = select(_e586, _e953, (_e953 > _e586));
                                        let _e988 = (_e981 <= select(_e620.member, _e978, (_e978 < _e620.member)));
                                        let _e989 = (_e983 <= select(_e620.member, _e979, (_e979 < _e620.member)));
                                        let _e990 = (_e981 <= _e983);
                                        if _e988 {
                                            if _e989 {
                                                if _e990 {
                                                    phi_3191_ = _e904;
                                                } else {
                                                    phi_3191_ = _e899;
                                                }
                                                let _e992 = phi_3191_;
                                                let _e999 = (_e663 % 128u);
                                                let _e1000 = (_e999 < 128u);
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_6[_e999] = _e992.member_1;
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_5[_e999] = _e992.member.member[0];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_4[_e999] = _e992.member.member[1];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_3[_e999] = _e992.member.member[2];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_2[_e999] = _e992.member.member_1[0];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_1[_e999] = _e992.member.member_1[1];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local[_e999] = _e992.member.member_1[2];
                                                if _e1000 {
                                                } else {
                                                    phi_3666_ = true;
                                                    break;
                                                }
                                                local_7[_e999] = select(_e981, _e983, _e990);
                                                if _e990 {
                                                    phi_3267_ = _e899;
                                                } else {
                                                    phi_3267_ = _e904;
                                                }
                                                let _e1017 = phi_3267_;
                                                phi_3268_ = _e1017;
                                                phi_3269_ = (_e663 + 1u);
                                            } else {
                                                phi_3268_ = type_50();
                                                phi_3269_ = u32();
                                            }
                                            let _e1019 = phi_3268_;
                                            let _e1021 = phi_3269_;
                                            phi_3271_ = _e1019;
                                            phi_3272_ = _e1021;
                                            phi_3273_ = select(true, false, _e989);
                                        } else {
                                            phi_3271_ = type_50();
                                            phi_3272_ = u32();
                                            phi_3273_ = true;
                                        }
                                        let _e1024 = phi_3271_;
                                        let _e1026 = phi_3272_;
                                        let _e1028 = phi_3273_;
                                        if _e1028 {
                                            if _e988 {
                                                phi_3280_ = _e899;
                                            } else {
                                                phi_3280_ = _e904;
                                            }
                                            let _e1030 = phi_3280_;
                                            phi_3285_ = select(_e989, true, _e988);
                                            phi_3286_ = _e1030;
                                        } else {
                                            phi_3285_ = _e659;
                                            phi_3286_ = _e1024;
                                        }
                                        let _e1033 = phi_3285_;
                                        let _e1035 = phi_3286_;
                                        phi_3670_ = _e618;
                                        phi_3288_ = _e620;
                                        phi_3289_ = _e1033;
                                        phi_3290_ = _e1035;
                                        phi_3291_ = select(_e1026, _e663, _e1028);
                                    }
                                    let _e1694 = phi_3670_;
                                    let _e1696 = phi_3288_;
                                    let _e1698 = phi_3289_;
                                    let _e1700 = phi_3290_;
                                    let _e1702 = phi_3291_;
                                    phi_3669_ = _e1694;
                                    phi_3292_ = _e1696;
                                    phi_3293_ = _e1698;
                                    phi_3294_ = _e1700;
                                    phi_3295_ = _e1702;
                                    phi_3296_ = (_e628 - 1u);
                                } else {
                                    phi_3669_ = _e618;
                                    phi_3292_ = _e620;
                                    phi_3293_ = _e659;
                                    phi_3294_ = _e661;
                                    phi_3295_ = _e663;
                                    phi_3296_ = _e628;
                                }
                                let _e1704 = phi_3669_;
                                let _e1706 = phi_3292_;
                                let _e1708 = phi_3293_;
                                let _e1710 = phi_3294_;
                                let _e1712 = phi_3295_;
                                let _e1714 = phi_3296_;
                                phi_3668_ = _e1704;
                                phi_3297_ = _e1706;
                                phi_3298_ = _e1708;
                                phi_3299_ = _e1710;
                                phi_3300_ = _e1712;
                                phi_3301_ = _e1714;
                            } else {
                                phi_3668_ = _e618;
                                phi_3297_ = type_33();
                                phi_3298_ = bool();
                                phi_3299_ = type_50();
                                phi_3300_ = u32();
                                phi_3301_ = u32();
                            }
                            let _e1716 = phi_3668_;
                            let _e1718 = phi_3297_;
                            let _e1720 = phi_3298_;
                            let _e1722 = phi_3299_;
                            let _e1724 = phi_3300_;
                            let _e1726 = phi_3301_;
                            phi_3667_ = _e1716;
                            phi_1047_ = _e1718;
                            phi_1050_ = _e1720;
                            phi_1052_ = _e1722;
                            phi_1054_ = _e1724;
                            phi_1056_ = _e1726;
                            phi_3302_ = _e632;
                        } else {
                            phi_3667_ = _e618;
                            phi_1047_ = type_33();
                            phi_1050_ = bool();
                            phi_1052_ = type_50();
                            phi_1054_ = u32();
                            phi_1056_ = u32();
                            phi_3302_ = false;
                        }
                        let _e1728 = phi_3667_;
                        let _e1730 = phi_1047_;
                        let _e1732 = phi_1050_;
                        let _e1734 = phi_1052_;
                        let _e1736 = phi_1054_;
                        let _e1738 = phi_1056_;
                        let _e1740 = phi_3302_;
                        continue;
                        continuing {
                            phi_3504_ = _e1728;
                            phi_1046_ = _e1730;
                            phi_1049_ = _e1732;
                            phi_1051_ = _e1734;
                            phi_1053_ = _e1736;
                            phi_1055_ = _e1738;
                            phi_3666_ = _e1728;
                            break if !(_e1740);
                        }
                    }
                    let _e1743 = phi_3666_;
                    if _e1743 {
                        break;
                    }
                    let _e1745 = local_11;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_4.member[_e132] = select(0u, 1u, _e1745.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
