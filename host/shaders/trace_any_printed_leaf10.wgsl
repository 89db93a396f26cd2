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
    var phi_363_: i32;
    var phi_364_: i32;
    var phi_374_: bool;
    var phi_384_: u32;
    var phi_385_: u32;
    var phi_387_: bool;
    var phi_392_: u32;
    var phi_405_: i32;
    var phi_425_: i32;
    var phi_443_: f32;
    var phi_449_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_693_: f32;
    var phi_699_: f32;
    var phi_739_: f32;
    var phi_745_: f32;
    var phi_864_: i32;
    var phi_886_: u32;
    var phi_887_: u32;
    var phi_924_: i32;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_3576_: bool;
    var phi_1039_: type_33;
    var phi_1042_: u32;
    var phi_1044_: bool;
    var phi_1046_: u32;
    var phi_1048_: type_50;
    var phi_1059_: bool;
    var phi_1145_: bool;
    var phi_1146_: u32;
    var phi_1147_: type_50;
    var phi_1166_: type_33;
    var phi_1169_: type_7;
    var phi_1170_: type_7;
    var phi_1192_: type_7;
    var phi_1217_: u32;
    var phi_1233_: type_44;
    var phi_3371_: bool;
    var phi_3386_: bool;
    var phi_3401_: bool;
    var phi_3416_: bool;
    var phi_3431_: bool;
    var phi_3446_: bool;
    var phi_2040_: f32;
    var phi_2041_: f32;
    var phi_2042_: f32;
    var phi_2043_: f32;
    var phi_2044_: vec3<f32>;
    var phi_2045_: vec3<f32>;
    var phi_2046_: vec3<f32>;
    var phi_2047_: vec3<f32>;
    var phi_3461_: bool;
    var phi_3476_: bool;
    var phi_3491_: bool;
    var phi_3506_: bool;
    var phi_3521_: bool;
    var phi_3536_: bool;
    var phi_2255_: f32;
    var phi_2275_: type_29;
    var phi_2276_: type_29;
    var phi_2279_: type_29;
    var phi_2280_: type_29;
    var phi_2281_: bool;
    var phi_2285_: type_29;
    var phi_2294_: type_21;
    var phi_2305_: type_33;
    var phi_2306_: type_33;
    var phi_1167_: type_33;
    var phi_3570_: bool;
    var phi_3809_: bool;
    var phi_2307_: type_33;
    var phi_2328_: type_37;
    var phi_3214_: type_50;
    var phi_3290_: type_50;
    var phi_3291_: u32;
    var phi_3292_: type_50;
    var phi_3294_: u32;
    var phi_3295_: type_50;
    var phi_3296_: bool;
    var phi_3303_: type_50;
    var phi_3308_: bool;
    var phi_3310_: type_50;
    var phi_3314_: bool;
    var phi_3315_: u32;
    var phi_3316_: type_50;
    var phi_3326_: u32;
    var phi_3327_: type_50;
    var phi_3753_: bool;
    var phi_3328_: type_33;
    var phi_3329_: u32;
    var phi_3330_: bool;
    var phi_3331_: u32;
    var phi_3332_: type_50;
    var phi_3752_: bool;
    var phi_3333_: type_33;
    var phi_3334_: u32;
    var phi_3335_: bool;
    var phi_3336_: u32;
    var phi_3337_: type_50;
    var phi_3751_: bool;
    var phi_1040_: type_33;
    var phi_1043_: u32;
    var phi_1045_: bool;
    var phi_1047_: u32;
    var phi_1049_: type_50;
    var phi_3338_: bool;
    var phi_3750_: bool;
    var local_10: type_33;
    var local_11: type_33;

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
                            phi_363_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_363_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_363_;
                        phi_364_ = _e225;
                    } else {
                        phi_364_ = 0i;
                    }
                    let _e227 = phi_364_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_374_ = true;
                    } else {
                        phi_374_ = (_e151 == _e183);
                    }
                    let _e231 = phi_374_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_384_ = _e233;
                        phi_385_ = _e233;
                        phi_387_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_384_ = u32();
                        phi_385_ = 0u;
                        phi_387_ = true;
                    }
                    let _e237 = phi_384_;
                    let _e239 = phi_385_;
                    let _e241 = phi_387_;
                    if _e241 {
                        phi_392_ = (_e239 + 1u);
                    } else {
                        phi_392_ = 0u;
                    }
                    let _e245 = phi_392_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_405_ = -126i;
                    } else {
                        phi_405_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_405_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_425_ = -126i;
                    } else {
                        phi_425_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_425_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_3.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_443_ = _e284[0];
                    } else {
                        phi_443_ = _e284[1];
                    }
                    let _e289 = phi_443_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_449_ = _e284[2];
                    } else {
                        phi_449_ = _e289;
                    }
                    let _e293 = phi_449_;
                    let _e294 = bitcast<u32>(_e293);
                    let _e296 = ((_e294 & 2139095040u) != 0u);
                    let _e310 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * _e257) * select(0.00000011920929f, 1f, _e296)) * _e263);
                    let _e311 = global_3.member[_e132].member_2;
                    if _e285 {
                        phi_489_ = _e311[0];
                    } else {
                        phi_489_ = _e311[1];
                    }
                    let _e315 = phi_489_;
                    if _e290 {
                        phi_495_ = _e311[2];
                    } else {
                        phi_495_ = _e315;
                    }
                    let _e318 = phi_495_;
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
                        phi_568_ = _e284[0];
                    } else {
                        phi_568_ = _e284[1];
                    }
                    let _e356 = phi_568_;
                    let _e357 = (_e245 == 2u);
                    if _e357 {
                        phi_574_ = _e284[2];
                    } else {
                        phi_574_ = _e356;
                    }
                    let _e360 = phi_574_;
                    let _e361 = bitcast<u32>(_e360);
                    let _e363 = ((_e361 & 2139095040u) != 0u);
                    let _e377 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e361 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e361 & 2147483648u))), _e360, _e363) * _e257) * select(0.00000011920929f, 1f, _e363)) * _e263);
                    if _e352 {
                        phi_614_ = _e311[0];
                    } else {
                        phi_614_ = _e311[1];
                    }
                    let _e381 = phi_614_;
                    if _e357 {
                        phi_620_ = _e311[2];
                    } else {
                        phi_620_ = _e381;
                    }
                    let _e384 = phi_620_;
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
                        phi_693_ = _e284[0];
                    } else {
                        phi_693_ = _e284[1];
                    }
                    let _e422 = phi_693_;
                    let _e423 = (_e247 == 2u);
                    if _e423 {
                        phi_699_ = _e284[2];
                    } else {
                        phi_699_ = _e422;
                    }
                    let _e426 = phi_699_;
                    let _e427 = bitcast<u32>(_e426);
                    let _e429 = ((_e427 & 2139095040u) != 0u);
                    let _e443 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e427 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e427 & 2147483648u))), _e426, _e429) * _e257) * select(0.00000011920929f, 1f, _e429)) * _e263);
                    if _e418 {
                        phi_739_ = _e311[0];
                    } else {
                        phi_739_ = _e311[1];
                    }
                    let _e447 = phi_739_;
                    if _e423 {
                        phi_745_ = _e311[2];
                    } else {
                        phi_745_ = _e447;
                    }
                    let _e450 = phi_745_;
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
                            phi_864_ = 255i;
                        } else {
                            phi_864_ = (((_e501 + select(0i, 1i, (_e501 == 0i))) - _e508) + _e488);
                        }
                        let _e516 = phi_864_;
                        let _e526 = (_e516 <= 0i);
                        if _e526 {
                            phi_887_ = u32();
                        } else {
                            if _e505 {
                                phi_886_ = u32();
                            } else {
                                phi_886_ = select(((bitcast<u32>(_e516) << bitcast<u32>(23i)) | ((_e498 << bitcast<u32>(((_e508 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e516 >= 255i));
                            }
                            let _e530 = phi_886_;
                            phi_887_ = _e530;
                        }
                        let _e532 = phi_887_;
                        let _e544 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e547 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
                        let _e551 = (_e544 == 0u);
                        let _e554 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e544)), 32u, _e551)) - 8i);
                        if (_e547 == 255i) {
                            phi_924_ = 255i;
                        } else {
                            phi_924_ = (((_e547 + select(0i, 1i, (_e547 == 0i))) - _e554) + _e488);
                        }
                        let _e562 = phi_924_;
                        let _e572 = (_e562 <= 0i);
                        if _e572 {
                            phi_947_ = u32();
                        } else {
                            if _e551 {
                                phi_946_ = u32();
                            } else {
                                phi_946_ = select(((bitcast<u32>(_e562) << bitcast<u32>(23i)) | ((_e544 << bitcast<u32>(((_e554 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e562 >= 255i));
                            }
                            let _e576 = phi_946_;
                            phi_947_ = _e576;
                        }
                        let _e578 = phi_947_;
                        phi_955_ = bitcast<f32>(((_e203 & 2147483648u) | select(_e578, 0u, select(_e551, true, _e572))));
                        phi_956_ = bitcast<f32>(((_e194 & 2147483648u) | select(_e532, 0u, select(_e505, true, _e526))));
                    } else {
                        phi_955_ = 0f;
                        phi_956_ = 1f;
                    }
                    let _e584 = phi_955_;
                    let _e586 = phi_956_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                    let _e591 = (_e246 % 3u);
                    let _e592 = (_e591 < 3u);
                    if _e592 {
                    } else {
                        break;
                    }
                    let _e594 = local_9[_e591];
                    let _e595 = (_e245 % 3u);
                    let _e596 = (_e595 < 3u);
                    if _e596 {
                    } else {
                        break;
                    }
                    let _e598 = local_9[_e595];
                    let _e599 = (_e247 % 3u);
                    let _e600 = (_e599 < 3u);
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e602 = local_9[_e599];
                    local_8 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    if _e592 {
                    } else {
                        break;
                    }
                    let _e606 = local_8[_e591];
                    if _e596 {
                    } else {
                        break;
                    }
                    let _e608 = local_8[_e595];
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e610 = local_8[_e599];
                    phi_3576_ = false;
                    phi_1039_ = type_33(_e584, false);
                    phi_1042_ = ((3u * _e83) + 1u);
                    phi_1044_ = (_e586 <= _e584);
                    phi_1046_ = 0u;
                    phi_1048_ = type_50(type_42(array<f32, 3>(_e594, _e598, _e602), array<f32, 3>(_e606, _e608, _e610)), select(0u, 2147483648u, (_e83 == 0u)));
                    loop {
                        let _e618 = phi_3576_;
                        let _e620 = phi_1039_;
                        let _e622 = phi_1042_;
                        let _e624 = phi_1044_;
                        let _e626 = phi_1046_;
                        let _e628 = phi_1048_;
                        local_10 = _e620;
                        if _e624 {
                            phi_1059_ = true;
                        } else {
                            phi_1059_ = (_e626 > 0u);
                        }
                        let _e631 = phi_1059_;
                        if _e631 {
                            let _e632 = (_e622 > 0u);
                            if _e632 {
                                if _e624 {
                                    phi_1145_ = _e624;
                                    phi_1146_ = _e626;
                                    phi_1147_ = _e628;
                                } else {
                                    let _e633 = (_e626 - 1u);
                                    let _e634 = (_e633 % 128u);
                                    let _e635 = (_e634 < 128u);
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e637 = local_6[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e639 = local_5[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e641 = local_4[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e643 = local_3[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e646 = local_2[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e648 = local_1[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e650 = local[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3750_ = true;
                                        break;
                                    }
                                    let _e655 = local_7[_e634];
                                    phi_1145_ = (_e655 <= _e620.member);
                                    phi_1146_ = _e633;
                                    phi_1147_ = type_50(type_42(array<f32, 3>(_e639, _e641, _e643), array<f32, 3>(_e646, _e648, _e650)), _e637);
                                }
                                let _e659 = phi_1145_;
                                let _e661 = phi_1146_;
                                let _e663 = phi_1147_;
                                if _e659 {
                                    let _e667 = ((_e663.member_1 & 2147483648u) != 0u);
                                    if _e667 {
                                        phi_1166_ = _e620;
                                        phi_1169_ = type_7(0u, ((_e663.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e675 = phi_1166_;
                                            let _e677 = phi_1169_;
                                            local_11 = _e675;
                                            if (_e677.member < _e677.member_1) {
                                                phi_1170_ = type_7((_e677.member + 1u), _e677.member_1);
                                                phi_1192_ = type_7(1u, _e677.member);
                                            } else {
                                                phi_1170_ = _e677;
                                                phi_1192_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e690 = phi_1170_;
                                            let _e692 = phi_1192_;
                                            let _e696 = (bitcast<i32>(_e692.member) != 0i);
                                            if _e696 {
                                                let _e697 = ((_e663.member_1 & 268435455u) + _e692.member_1);
                                                let _e698 = (_e697 < arrayLength((&global_6.member)));
                                                if _e698 {
                                                    if _e698 {
                                                    } else {
                                                        phi_3570_ = true;
                                                        break;
                                                    }
                                                    let _e701 = global_6.member[_e697].member_1;
                                                    phi_1217_ = _e701;
                                                } else {
                                                    phi_1217_ = 4294967295u;
                                                }
                                                let _e703 = phi_1217_;
                                                if _e698 {
                                                    if _e698 {
                                                    } else {
                                                        phi_3570_ = true;
                                                        break;
                                                    }
                                                    let _e705 = global_6.member[_e697];
                                                    phi_1233_ = _e705;
                                                } else {
                                                    phi_1233_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e707 = phi_1233_;
                                                let _e719 = ((10u * _e246) & 31u);
                                                let _e722 = ((_e707.member[0] >> bitcast<u32>(_e719)) & 1023u);
                                                let _e730 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e118));
                                                let _e735 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e722)) - 8388608f) * _e730)) ^ _e118)));
                                                let _e739 = select(select(_e663.member.member_1[0], _e735, (_e735 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e722 == 1023u));
                                                let _e741 = ((10u * _e245) & 31u);
                                                let _e744 = ((_e707.member[0] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e752 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e118));
                                                let _e757 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e744)) - 8388608f) * _e752)) ^ _e118)));
                                                let _e761 = select(select(_e663.member.member_1[1], _e757, (_e757 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e744 == 1023u));
                                                let _e763 = ((10u * _e247) & 31u);
                                                let _e766 = ((_e707.member[0] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e774 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e118));
                                                let _e779 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e766)) - 8388608f) * _e774)) ^ _e118)));
                                                let _e783 = select(select(_e663.member.member_1[2], _e779, (_e779 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e766 == 1023u));
                                                let _e787 = ((_e707.member[1] >> bitcast<u32>(_e719)) & 1023u);
                                                let _e795 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e787)) - 8388608f) * _e730)) ^ _e118)));
                                                let _e799 = select(select(_e663.member.member_1[0], _e795, (_e795 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e787 == 1023u));
                                                let _e802 = ((_e707.member[1] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e810 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e802)) - 8388608f) * _e752)) ^ _e118)));
                                                let _e814 = select(select(_e663.member.member_1[1], _e810, (_e810 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e802 == 1023u));
                                                let _e817 = ((_e707.member[1] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e825 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e817)) - 8388608f) * _e774)) ^ _e118)));
                                                let _e829 = select(select(_e663.member.member_1[2], _e825, (_e825 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e817 == 1023u));
                                                let _e833 = ((_e707.member[2] >> bitcast<u32>(_e719)) & 1023u);
                                                let _e841 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e833)) - 8388608f) * _e730)) ^ _e118)));
                                                let _e845 = select(select(_e663.member.member_1[0], _e841, (_e841 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e833 == 1023u));
                                                let _e848 = ((_e707.member[2] >> bitcast<u32>(_e741)) & 1023u);
                                                let _e856 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e848)) - 8388608f) * _e752)) ^ _e118)));
                                                let _e860 = select(select(_e663.member.member_1[1], _e856, (_e856 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e848 == 1023u));
                                                let _e863 = ((_e707.member[2] >> bitcast<u32>(_e763)) & 1023u);
                                                let _e871 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e863)) - 8388608f) * _e774)) ^ _e118)));
                                                let _e875 = select(select(_e663.member.member_1[2], _e871, (_e871 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e863 == 1023u));
                                                let _e879 = (_e783 - _e443);
                                                let _e882 = (((_e739 - _e310) * _e479) - (_e879 * _e347));
                                                let _e885 = (((_e761 - _e377) * _e479) - (_e879 * _e413));
                                                let _e888 = (_e829 - _e443);
                                                let _e891 = (((_e799 - _e310) * _e479) - (_e888 * _e347));
                                                let _e894 = (((_e814 - _e377) * _e479) - (_e888 * _e413));
                                                let _e897 = (_e875 - _e443);
                                                let _e900 = (((_e845 - _e310) * _e479) - (_e897 * _e347));
                                                let _e903 = (((_e860 - _e377) * _e479) - (_e897 * _e413));
                                                let _e904 = (_e900 * _e894);
                                                let _e905 = (_e903 * _e891);
                                                let _e906 = (_e882 * _e903);
                                                let _e907 = (_e885 * _e900);
                                                let _e908 = (_e891 * _e885);
                                                let _e909 = (_e894 * _e882);
                                                let _e914 = (((_e904 >= _e905) && (_e906 >= _e907)) && (_e908 >= _e909));
                                                let _e920 = (_e914 || (((_e904 <= _e905) && (_e906 <= _e907)) && (_e908 <= _e909)));
                                                if _e920 {
                                                    let _e922 = select(-1f, 1f, _e914);
                                                    let _e924 = ((_e904 - _e905) * _e922);
                                                    let _e926 = select(0f, _e924, (_e924 > 0f));
                                                    let _e928 = ((_e906 - _e907) * _e922);
                                                    let _e930 = select(0f, _e928, (_e928 > 0f));
                                                    let _e932 = ((_e908 - _e909) * _e922);
                                                    let _e934 = select(0f, _e932, (_e932 > 0f));
                                                    let _e936 = ((_e926 + _e930) + _e934);
                                                    let _e938 = select(_e799, _e739, (_e739 < _e799));
                                                    let _e942 = select(_e799, _e739, (_e739 > _e799));
                                                    let _e946 = select(_e814, _e761, (_e761 < _e814));
                                                    let _e950 = select(_e814, _e761, (_e761 > _e814));
                                                    let _e954 = select(_e829, _e783, (_e783 < _e829));
                                                    let _e958 = select(_e829, _e783, (_e783 > _e829));
                                                    let _e963 = ((select(_e845, _e938, (_e938 < _e845)) - _e348) * _e351);
                                                    let _e964 = ((select(_e845, _e942, (_e942 > _e845)) - _e349) * _e351);
                                                    let _e967 = ((select(_e860, _e946, (_e946 < _e860)) - _e414) * _e417);
                                                    let _e968 = ((select(_e860, _e950, (_e950 > _e860)) - _e415) * _e417);
                                                    let _e971 = ((select(_e875, _e954, (_e954 < _e875)) - _e480) * _e483);
                                                    let _e972 = ((select(_e875, _e958, (_e958 > _e875)) - _e481) * _e483);
                                                    let _e974 = select(_e972, _e971, (_e971 < _e972));
                                                    let _e976 = select(_e972, _e971, (_e971 > _e972));
                                                    let _e978 = select(_e964, _e963, (_e963 < _e964));
                                                    let _e980 = select(_e968, _e967, (_e967 < _e968));
                                                    let _e982 = select(_e980, _e978, (_e978 > _e980));
                                                    let _e984 = select(_e974, _e982, (_e982 > _e974));
                                                    let _e986 = select(_e964, _e963, (_e963 > _e964));
                                                    let _e988 = select(_e968, _e967, (_e967 > _e968));
                                                    let _e990 = select(_e988, _e986, (_e986 < _e988));
                                                    let _e992 = select(_e976, _e990, (_e990 < _e976));
                                                    let _e993 = -(_e974);
                                                    let _e999 = select(_e586, _e984, (_e984 > _e586));
                                                    let _e1003 = select(_e891, _e882, (_e882 < _e891));
                                                    let _e1008 = select(_e891, _e882, (_e882 > _e891));
                                                    let _e1015 = select(_e894, _e885, (_e885 < _e894));
                                                    let _e1020 = select(_e894, _e885, (_e885 > _e894));
                                                    let _e1029 = (((((_e920 && (_e936 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e900, _e1003, (_e1003 < _e900)) <= 0f) && (select(_e900, _e1008, (_e1008 > _e900)) >= 0f))) && ((select(_e903, _e1015, (_e1015 < _e903)) <= 0f) && (select(_e903, _e1020, (_e1020 > _e903)) >= 0f))) && (_e999 <= (_e992 + (select(_e993, _e976, (_e976 > _e993)) * 0.0000019073523f)))) && (_e999 <= _e675.member));
                                                    if _e1029 {
                                                        let _e1034 = (_e799 - _e739);
                                                        let _e1035 = (_e814 - _e761);
                                                        let _e1036 = (_e829 - _e783);
                                                        let _e1037 = vec3<f32>(_e1034, _e1035, _e1036);
                                                        let _e1038 = (_e845 - _e799);
                                                        let _e1039 = (_e860 - _e814);
                                                        let _e1040 = (_e875 - _e829);
                                                        let _e1041 = vec3<f32>(_e1038, _e1039, _e1040);
                                                        let _e1042 = (_e739 - _e845);
                                                        let _e1043 = (_e761 - _e860);
                                                        let _e1044 = (_e783 - _e875);
                                                        let _e1045 = vec3<f32>(_e1042, _e1043, _e1044);
                                                        let _e1046 = abs(_e1034);
                                                        let _e1047 = abs(_e1035);
                                                        if (_e1046 != _e1046) {
                                                            phi_3371_ = true;
                                                        } else {
                                                            phi_3371_ = (_e1047 >= _e1046);
                                                        }
                                                        let _e1051 = phi_3371_;
                                                        let _e1052 = select(_e1046, _e1047, _e1051);
                                                        let _e1053 = abs(_e1036);
                                                        if (_e1052 != _e1052) {
                                                            phi_3386_ = true;
                                                        } else {
                                                            phi_3386_ = (_e1053 >= _e1052);
                                                        }
                                                        let _e1057 = phi_3386_;
                                                        let _e1058 = select(_e1052, _e1053, _e1057);
                                                        let _e1059 = abs(_e1038);
                                                        let _e1060 = abs(_e1039);
                                                        if (_e1059 != _e1059) {
                                                            phi_3401_ = true;
                                                        } else {
                                                            phi_3401_ = (_e1060 >= _e1059);
                                                        }
                                                        let _e1064 = phi_3401_;
                                                        let _e1065 = select(_e1059, _e1060, _e1064);
                                                        let _e1066 = abs(_e1040);
                                                        if (_e1065 != _e1065) {
                                                            phi_3416_ = true;
                                                        } else {
                                                            phi_3416_ = (_e1066 >= _e1065);
                                                        }
                                                        let _e1070 = phi_3416_;
                                                        let _e1071 = select(_e1065, _e1066, _e1070);
                                                        let _e1072 = abs(_e1042);
                                                        let _e1073 = abs(_e1043);
                                                        if (_e1072 != _e1072) {
                                                            phi_3431_ = true;
                                                        } else {
                                                            phi_3431_ = (_e1073 >= _e1072);
                                                        }
                                                        let _e1077 = phi_3431_;
                                                        let _e1078 = select(_e1072, _e1073, _e1077);
                                                        let _e1079 = abs(_e1044);
                                                        if (_e1078 != _e1078) {
                                                            phi_3446_ = true;
                                                        } else {
                                                            phi_3446_ = (_e1079 >= _e1078);
                                                        }
                                                        let _e1083 = phi_3446_;
                                                        let _e1084 = select(_e1078, _e1079, _e1083);
                                                        let _e1086 = select(_e1071, _e1058, (_e1058 > _e1071));
                                                        let _e1088 = select(_e1084, _e1086, (_e1086 > _e1084));
                                                        if (_e1058 == _e1088) {
                                                            phi_2040_ = _e894;
                                                            phi_2041_ = _e891;
                                                            phi_2042_ = _e885;
                                                            phi_2043_ = _e882;
                                                            phi_2044_ = vec3<f32>(_e739, _e761, _e783);
                                                            phi_2045_ = _e1045;
                                                            phi_2046_ = _e1041;
                                                            phi_2047_ = _e1037;
                                                        } else {
                                                            let _e1090 = (_e1071 == _e1088);
                                                            let _e1095 = vec3(_e1090);
                                                            phi_2040_ = select(_e885, _e903, _e1090);
                                                            phi_2041_ = select(_e882, _e900, _e1090);
                                                            phi_2042_ = select(_e903, _e894, _e1090);
                                                            phi_2043_ = select(_e900, _e891, _e1090);
                                                            phi_2044_ = select(vec3<f32>(_e845, _e860, _e875), vec3<f32>(_e799, _e814, _e829), _e1095);
                                                            phi_2045_ = select(_e1041, _e1037, _e1095);
                                                            phi_2046_ = select(_e1037, _e1045, _e1095);
                                                            phi_2047_ = select(_e1045, _e1041, _e1095);
                                                        }
                                                        let _e1101 = phi_2040_;
                                                        let _e1103 = phi_2041_;
                                                        let _e1105 = phi_2042_;
                                                        let _e1107 = phi_2043_;
                                                        let _e1109 = phi_2044_;
                                                        let _e1111 = phi_2045_;
                                                        let _e1113 = phi_2046_;
                                                        let _e1115 = phi_2047_;
                                                        let _e1122 = ((_e1113.y * _e1111.z) - (_e1111.y * _e1113.z));
                                                        let _e1127 = ((_e1113.z * _e1111.x) - (_e1111.z * _e1113.x));
                                                        let _e1130 = ((_e1113.x * _e1111.y) - (_e1111.x * _e1113.y));
                                                        let _e1133 = ((_e926 >= _e930) && (_e926 >= _e934));
                                                        let _e1134 = (_e930 >= _e934);
                                                        let _e1148 = (((_e1122 * (select(select(_e845, _e799, _e1134), _e739, _e1133) - _e310)) + (_e1127 * (select(select(_e860, _e814, _e1134), _e761, _e1133) - _e377))) + (_e1130 * (select(select(_e875, _e829, _e1134), _e783, _e1133) - _e443)));
                                                        let _e1153 = (((_e1122 * _e347) + (_e1127 * _e413)) + (_e1130 * _e479));
                                                        let _e1154 = (_e1103 - _e1107);
                                                        let _e1155 = (_e1101 - _e1105);
                                                        let _e1158 = ((_e1154 * _e1154) + (_e1155 * _e1155));
                                                        let _e1165 = (-(((_e1107 * _e1154) + (_e1105 * _e1155))) / select(0.000000000000000000000000000000000000011754944f, _e1158, (_e1158 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1167 = select(1f, _e1165, (_e1165 < 1f));
                                                        let _e1169 = select(0f, _e1167, (_e1167 > 0f));
                                                        let _e1178 = ((_e1109.x + (_e1115.x * _e1169)) - _e310);
                                                        let _e1181 = ((_e1109.y + (_e1115.y * _e1169)) - _e377);
                                                        let _e1184 = ((_e1109.z + (_e1115.z * _e1169)) - _e443);
                                                        let _e1187 = bitcast<f32>((bitcast<u32>(_e1178) & 2147483647u));
                                                        let _e1190 = bitcast<f32>((bitcast<u32>(_e1181) & 2147483647u));
                                                        let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                        let _e1195 = bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u));
                                                        let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                                                        let _e1201 = abs(_e1122);
                                                        let _e1202 = abs(_e1127);
                                                        if (_e1201 != _e1201) {
                                                            phi_3461_ = true;
                                                        } else {
                                                            phi_3461_ = (_e1202 >= _e1201);
                                                        }
                                                        let _e1206 = phi_3461_;
                                                        let _e1207 = select(_e1201, _e1202, _e1206);
                                                        let _e1208 = abs(_e1130);
                                                        if (_e1207 != _e1207) {
                                                            phi_3476_ = true;
                                                        } else {
                                                            phi_3476_ = (_e1208 >= _e1207);
                                                        }
                                                        let _e1212 = phi_3476_;
                                                        let _e1228 = abs(_e1113.x);
                                                        let _e1229 = abs(_e1113.y);
                                                        if (_e1228 != _e1228) {
                                                            phi_3491_ = true;
                                                        } else {
                                                            phi_3491_ = (_e1229 >= _e1228);
                                                        }
                                                        let _e1233 = phi_3491_;
                                                        let _e1234 = select(_e1228, _e1229, _e1233);
                                                        let _e1235 = abs(_e1113.z);
                                                        if (_e1234 != _e1234) {
                                                            phi_3506_ = true;
                                                        } else {
                                                            phi_3506_ = (_e1235 >= _e1234);
                                                        }
                                                        let _e1239 = phi_3506_;
                                                        let _e1242 = abs(_e1111.x);
                                                        let _e1243 = abs(_e1111.y);
                                                        if (_e1242 != _e1242) {
                                                            phi_3521_ = true;
                                                        } else {
                                                            phi_3521_ = (_e1243 >= _e1242);
                                                        }
                                                        let _e1247 = phi_3521_;
                                                        let _e1248 = select(_e1242, _e1243, _e1247);
                                                        let _e1249 = abs(_e1111.z);
                                                        if (_e1248 != _e1248) {
                                                            phi_3536_ = true;
                                                        } else {
                                                            phi_3536_ = (_e1249 >= _e1248);
                                                        }
                                                        let _e1253 = phi_3536_;
                                                        let _e1258 = ((bitcast<f32>((bitcast<u32>(((((_e1122 * _e1178) + (_e1127 * _e1181)) + (_e1130 * _e1184)) - _e1148)) & 2147483647u)) <= ((0.0000009536743f * select(_e1088, _e1197, (_e1197 > _e1088))) * select(_e1207, _e1208, _e1212))) && !((bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u)) <= ((0.0000038146973f * select(_e1234, _e1235, _e1239)) * select(_e1248, _e1249, _e1253)))));
                                                        let _e1259 = (_e1148 / _e1153);
                                                        if (_e1029 && !(_e1258)) {
                                                            let _e1262 = (_e1184 / _e479);
                                                            let _e1270 = (((_e1122 * (_e1178 - (_e347 * _e1262))) + (_e1127 * (_e1181 - (_e413 * _e1262)))) / _e1153);
                                                            phi_2255_ = select(select(_e1262, (_e1262 + _e1270), (bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u)) <= _e1088)), _e1259, _e1258);
                                                        } else {
                                                            phi_2255_ = _e1259;
                                                        }
                                                        let _e1279 = phi_2255_;
                                                        let _e1281 = select(_e992, _e1279, (_e1279 < _e992));
                                                        let _e1283 = select(_e984, _e1281, (_e1281 > _e984));
                                                        let _e1284 = (1f / _e936);
                                                        phi_2275_ = type_29(_e1283, (_e930 * _e1284), (_e934 * _e1284), ((_e1029 && (_e1283 >= _e586)) && (_e1283 <= _e675.member)));
                                                        phi_2276_ = type_29();
                                                    } else {
                                                        phi_2275_ = type_29();
                                                        phi_2276_ = type_29(0f, 0f, 0f, _e1029);
                                                    }
                                                    let _e1293 = phi_2275_;
                                                    let _e1295 = phi_2276_;
                                                    phi_2279_ = _e1293;
                                                    phi_2280_ = _e1295;
                                                    phi_2281_ = select(true, false, _e1029);
                                                } else {
                                                    phi_2279_ = type_29();
                                                    phi_2280_ = type_29(0f, 0f, 0f, _e920);
                                                    phi_2281_ = true;
                                                }
                                                let _e1298 = phi_2279_;
                                                let _e1300 = phi_2280_;
                                                let _e1302 = phi_2281_;
                                                if _e1302 {
                                                    phi_2285_ = _e1300;
                                                } else {
                                                    phi_2285_ = _e1298;
                                                }
                                                let _e1304 = phi_2285_;
                                                if _e1304.member_3 {
                                                    phi_2294_ = type_21(_e1304.member, _e1304.member_1, _e1304.member_2, _e703);
                                                } else {
                                                    phi_2294_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1311 = phi_2294_;
                                                if (_e1311.member_3 != 4294967295u) {
                                                    if (_e703 != 4294967295u) {
                                                        phi_2305_ = type_33(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2305_ = _e675;
                                                    }
                                                    let _e1316 = phi_2305_;
                                                    phi_2306_ = _e1316;
                                                } else {
                                                    phi_2306_ = _e675;
                                                }
                                                let _e1318 = phi_2306_;
                                                phi_1167_ = _e1318;
                                            } else {
                                                phi_1167_ = type_33();
                                            }
                                            let _e1320 = phi_1167_;
                                            continue;
                                            continuing {
                                                phi_1166_ = _e1320;
                                                phi_1169_ = _e690;
                                                phi_3570_ = _e618;
                                                break if !(_e696);
                                            }
                                        }
                                        let _e1323 = phi_3570_;
                                        phi_3750_ = _e1323;
                                        if _e1323 {
                                            break;
                                        }
                                        phi_3809_ = _e1323;
                                        let _e1832 = local_11;
                                        phi_2307_ = _e1832;
                                    } else {
                                        phi_3809_ = _e618;
                                        phi_2307_ = _e620;
                                    }
                                    let _e1325 = phi_3809_;
                                    let _e1327 = phi_2307_;
                                    if _e667 {
                                        phi_3314_ = bool();
                                        phi_3315_ = u32();
                                        phi_3316_ = type_50();
                                    } else {
                                        let _e1328 = (_e663.member_1 < _e83);
                                        if _e1328 {
                                            if _e1328 {
                                            } else {
                                                phi_3750_ = true;
                                                break;
                                            }
                                            let _e1330 = global_5.member[_e663.member_1];
                                            phi_2328_ = _e1330;
                                        } else {
                                            phi_2328_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1332 = phi_2328_;
                                        let _e1347 = ((10u * _e246) & 31u);
                                        let _e1350 = ((_e1332.member[0] >> bitcast<u32>(_e1347)) & 1023u);
                                        let _e1358 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e1363 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1350)) - 8388608f) * _e1358)) ^ _e118)));
                                        let _e1367 = select(select(_e663.member.member_1[0], _e1363, (_e1363 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1350 == 1023u));
                                        let _e1369 = ((10u * _e245) & 31u);
                                        let _e1372 = ((_e1332.member[0] >> bitcast<u32>(_e1369)) & 1023u);
                                        let _e1380 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e1385 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1372)) - 8388608f) * _e1380)) ^ _e118)));
                                        let _e1389 = select(select(_e663.member.member_1[1], _e1385, (_e1385 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1372 == 1023u));
                                        let _e1391 = ((10u * _e247) & 31u);
                                        let _e1394 = ((_e1332.member[0] >> bitcast<u32>(_e1391)) & 1023u);
                                        let _e1402 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e1407 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1394)) - 8388608f) * _e1402)) ^ _e118)));
                                        let _e1411 = select(select(_e663.member.member_1[2], _e1407, (_e1407 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1394 == 1023u));
                                        let _e1414 = ((_e1332.member[1] >> bitcast<u32>(_e1347)) & 1023u);
                                        let _e1422 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1414)) - 8388608f) * _e1358)) ^ _e118)));
                                        let _e1426 = select(select(_e663.member.member_1[0], _e1422, (_e1422 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1414 == 1023u));
                                        let _e1429 = ((_e1332.member[1] >> bitcast<u32>(_e1369)) & 1023u);
                                        let _e1437 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1429)) - 8388608f) * _e1380)) ^ _e118)));
                                        let _e1441 = select(select(_e663.member.member_1[1], _e1437, (_e1437 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1429 == 1023u));
                                        let _e1444 = ((_e1332.member[1] >> bitcast<u32>(_e1391)) & 1023u);
                                        let _e1452 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1444)) - 8388608f) * _e1402)) ^ _e118)));
                                        let _e1456 = select(select(_e663.member.member_1[2], _e1452, (_e1452 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1444 == 1023u));
                                        let _e1462 = ((_e1332.member_1[0] >> bitcast<u32>(_e1347)) & 1023u);
                                        let _e1470 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1462)) - 8388608f) * _e1358)) ^ _e118)));
                                        let _e1474 = select(select(_e663.member.member_1[0], _e1470, (_e1470 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1462 == 1023u));
                                        let _e1477 = ((_e1332.member_1[0] >> bitcast<u32>(_e1369)) & 1023u);
                                        let _e1485 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1477)) - 8388608f) * _e1380)) ^ _e118)));
                                        let _e1489 = select(select(_e663.member.member_1[1], _e1485, (_e1485 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1477 == 1023u));
                                        let _e1492 = ((_e1332.member_1[0] >> bitcast<u32>(_e1391)) & 1023u);
                                        let _e1500 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1492)) - 8388608f) * _e1402)) ^ _e118)));
                                        let _e1504 = select(select(_e663.member.member_1[2], _e1500, (_e1500 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1492 == 1023u));
                                        let _e1507 = ((_e1332.member_1[1] >> bitcast<u32>(_e1347)) & 1023u);
                                        let _e1515 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1507)) - 8388608f) * _e1358)) ^ _e118)));
                                        let _e1519 = select(select(_e663.member.member_1[0], _e1515, (_e1515 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1507 == 1023u));
                                        let _e1522 = ((_e1332.member_1[1] >> bitcast<u32>(_e1369)) & 1023u);
                                        let _e1530 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1522)) - 8388608f) * _e1380)) ^ _e118)));
                                        let _e1534 = select(select(_e663.member.member_1[1], _e1530, (_e1530 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1522 == 1023u));
                                        let _e1537 = ((_e1332.member_1[1] >> bitcast<u32>(_e1391)) & 1023u);
                                        let _e1545 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1537)) - 8388608f) * _e1402)) ^ _e118)));
                                        let _e1549 = select(select(_e663.member.member_1[2], _e1545, (_e1545 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1537 == 1023u));
                                        let _e1554 = type_50(type_42(array<f32, 3>(_e1367, _e1389, _e1411), array<f32, 3>(_e1426, _e1441, _e1456)), _e1332.member_2);
                                        let _e1559 = type_50(type_42(array<f32, 3>(_e1474, _e1489, _e1504), array<f32, 3>(_e1519, _e1534, _e1549)), _e1332.member_3);
                                        let _e1565 = ((_e1367 - _e348) * _e351);
                                        let _e1566 = ((_e1474 - _e348) * _e351);
                                        let _e1567 = ((_e1426 - _e349) * _e351);
                                        let _e1568 = ((_e1519 - _e349) * _e351);
                                        let _e1573 = ((_e1389 - _e414) * _e417);
                                        let _e1574 = ((_e1489 - _e414) * _e417);
                                        let _e1575 = ((_e1441 - _e415) * _e417);
                                        let _e1576 = ((_e1534 - _e415) * _e417);
                                        let _e1581 = ((_e1411 - _e480) * _e483);
                                        let _e1582 = ((_e1504 - _e480) * _e483);
                                        let _e1583 = ((_e1456 - _e481) * _e483);
                                        let _e1584 = ((_e1549 - _e481) * _e483);
                                        let _e1586 = select(_e1583, _e1581, (_e1581 < _e1583));
                                        let _e1588 = select(_e1584, _e1582, (_e1582 < _e1584));
                                        let _e1590 = select(_e1583, _e1581, (_e1581 > _e1583));
                                        let _e1592 = select(_e1584, _e1582, (_e1582 > _e1584));
                                        let _e1594 = select(_e1567, _e1565, (_e1565 < _e1567));
                                        let _e1596 = select(_e1568, _e1566, (_e1566 < _e1568));
                                        let _e1598 = select(_e1575, _e1573, (_e1573 < _e1575));
                                        let _e1600 = select(_e1576, _e1574, (_e1574 < _e1576));
                                        let _e1602 = select(_e1598, _e1594, (_e1594 > _e1598));
                                        let _e1604 = select(_e1600, _e1596, (_e1596 > _e1600));
                                        let _e1606 = select(_e1586, _e1602, (_e1602 > _e1586));
                                        let _e1608 = select(_e1588, _e1604, (_e1604 > _e1588));
                                        let _e1610 = select(_e1567, _e1565, (_e1565 > _e1567));
                                        let _e1612 = select(_e1568, _e1566, (_e1566 > _e1568));
                                        let _e1614 = select(_e1575, _e1573, (_e1573 > _e1575));
                                        let _e1616 = select(_e1576, _e1574, (_e1574 > _e1576));
                                        let _e1618 = select(_e1614, _e1610, (_e1610 < _e1614));
                                        let _e1620 = select(_e1616, _e1612, (_e1612 < _e1616));
                                        let _e1625 = -(_e1586);
                                        let _e1626 = -(_e1588);
                                        let _e1633 = (select(_e1590, _e1618, (_e1618 < _e1590)) + (select(_e1625, _e1590, (_e1590 > _e1625)) * 0.0000019073523f));
                                        let _e1634 = (select(_e1592, _e1620, (_e1620 < _e1592)) + (select(_e1626, _e1592, (_e1592 > _e1626)) * 0.0000019073523f));
                                        let _e1636 = select(_e586, _e1606, (_e1606 > _e586));
                                        let _e1638 = select(_e586, _e1608, (_e1608 > _e586));
                                        let _e1643 = (_e1636 <= select(_e1327.member, _e1633, (_e1633 < _e1327.member)));
                                        let _e1644 = (_e1638 <= select(_e1327.member, _e1634, (_e1634 < _e1327.member)));
                                        let _e1645 = (_e1636 <= _e1638);
                                        if _e1643 {
                                            if _e1644 {
                                                if _e1645 {
                                                    phi_3214_ = _e1559;
                                                } else {
                                                    phi_3214_ = _e1554;
                                                }
                                                let _e1647 = phi_3214_;
                                                let _e1654 = (_e661 % 128u);
                                                let _e1655 = (_e1654 < 128u);
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_6[_e1654] = _e1647.member_1;
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_5[_e1654] = _e1647.member.member[0];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_4[_e1654] = _e1647.member.member[1];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_3[_e1654] = _e1647.member.member[2];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_2[_e1654] = _e1647.member.member_1[0];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_1[_e1654] = _e1647.member.member_1[1];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local[_e1654] = _e1647.member.member_1[2];
                                                if _e1655 {
                                                } else {
                                                    phi_3750_ = true;
                                                    break;
                                                }
                                                local_7[_e1654] = select(_e1636, _e1638, _e1645);
                                                if _e1645 {
                                                    phi_3290_ = _e1554;
                                                } else {
                                                    phi_3290_ = _e1559;
                                                }
                                                let _e1672 = phi_3290_;
                                                phi_3291_ = (_e661 + 1u);
                                                phi_3292_ = _e1672;
                                            } else {
                                                phi_3291_ = u32();
                                                phi_3292_ = type_50();
                                            }
                                            let _e1674 = phi_3291_;
                                            let _e1676 = phi_3292_;
                                            phi_3294_ = _e1674;
                                            phi_3295_ = _e1676;
                                            phi_3296_ = select(true, false, _e1644);
                                        } else {
                                            phi_3294_ = u32();
                                            phi_3295_ = type_50();
                                            phi_3296_ = true;
                                        }
                                        let _e1679 = phi_3294_;
                                        let _e1681 = phi_3295_;
                                        let _e1683 = phi_3296_;
                                        if _e1683 {
                                            if _e1643 {
                                                phi_3303_ = _e1554;
                                            } else {
                                                phi_3303_ = _e1559;
                                            }
                                            let _e1685 = phi_3303_;
                                            phi_3308_ = select(_e1644, true, _e1643);
                                            phi_3310_ = _e1685;
                                        } else {
                                            phi_3308_ = _e659;
                                            phi_3310_ = _e1681;
                                        }
                                        let _e1688 = phi_3308_;
                                        let _e1690 = phi_3310_;
                                        phi_3314_ = _e1688;
                                        phi_3315_ = select(_e1679, _e661, _e1683);
                                        phi_3316_ = _e1690;
                                    }
                                    let _e1693 = phi_3314_;
                                    let _e1695 = phi_3315_;
                                    let _e1697 = phi_3316_;
                                    if _e667 {
                                        phi_3326_ = select(_e661, 0u, _e1327.member_1);
                                        phi_3327_ = _e663;
                                    } else {
                                        phi_3326_ = _e1695;
                                        phi_3327_ = _e1697;
                                    }
                                    let _e1701 = phi_3326_;
                                    let _e1703 = phi_3327_;
                                    phi_3753_ = _e1325;
                                    phi_3328_ = _e1327;
                                    phi_3329_ = (_e622 - 1u);
                                    phi_3330_ = select(_e1693, false, _e667);
                                    phi_3331_ = _e1701;
                                    phi_3332_ = _e1703;
                                } else {
                                    phi_3753_ = _e618;
                                    phi_3328_ = _e620;
                                    phi_3329_ = _e622;
                                    phi_3330_ = _e659;
                                    phi_3331_ = _e661;
                                    phi_3332_ = _e663;
                                }
                                let _e1706 = phi_3753_;
                                let _e1708 = phi_3328_;
                                let _e1710 = phi_3329_;
                                let _e1712 = phi_3330_;
                                let _e1714 = phi_3331_;
                                let _e1716 = phi_3332_;
                                phi_3752_ = _e1706;
                                phi_3333_ = _e1708;
                                phi_3334_ = _e1710;
                                phi_3335_ = _e1712;
                                phi_3336_ = _e1714;
                                phi_3337_ = _e1716;
                            } else {
                                phi_3752_ = _e618;
                                phi_3333_ = type_33();
                                phi_3334_ = u32();
                                phi_3335_ = bool();
                                phi_3336_ = u32();
                                phi_3337_ = type_50();
                            }
                            let _e1718 = phi_3752_;
                            let _e1720 = phi_3333_;
                            let _e1722 = phi_3334_;
                            let _e1724 = phi_3335_;
                            let _e1726 = phi_3336_;
                            let _e1728 = phi_3337_;
                            phi_3751_ = _e1718;
                            phi_1040_ = _e1720;
                            phi_1043_ = _e1722;
                            phi_1045_ = _e1724;
                            phi_1047_ = _e1726;
                            phi_1049_ = _e1728;
                            phi_3338_ = _e632;
                        } else {
                            phi_3751_ = _e618;
                            phi_1040_ = type_33();
                            phi_1043_ = u32();
                            phi_1045_ = bool();
                            phi_1047_ = u32();
                            phi_1049_ = type_50();
                            phi_3338_ = false;
                        }
                        let _e1730 = phi_3751_;
                        let _e1732 = phi_1040_;
                        let _e1734 = phi_1043_;
                        let _e1736 = phi_1045_;
                        let _e1738 = phi_1047_;
                        let _e1740 = phi_1049_;
                        let _e1742 = phi_3338_;
                        continue;
                        continuing {
                            phi_3576_ = _e1730;
                            phi_1039_ = _e1732;
                            phi_1042_ = _e1734;
                            phi_1044_ = _e1736;
                            phi_1046_ = _e1738;
                            phi_1048_ = _e1740;
                            phi_3750_ = _e1730;
                            break if !(_e1742);
                        }
                    }
                    let _e1745 = phi_3750_;
                    if _e1745 {
                        break;
                    }
                    let _e1747 = local_10;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_4.member[_e132] = select(0u, 1u, _e1747.member_1);
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
