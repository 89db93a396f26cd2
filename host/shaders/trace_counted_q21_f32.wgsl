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

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_34 {
    member: type_25,
    member_1: f32,
}

struct type_37 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_39 {
    member: array<type_26>,
}

struct type_41 {
    member: type_34,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_29,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_39;
@group(0) @binding(2) 
var<storage> global_5: type_47;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_452_: i32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_740_: f32;
    var phi_746_: f32;
    var phi_786_: f32;
    var phi_792_: f32;
    var phi_911_: i32;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_971_: i32;
    var phi_993_: u32;
    var phi_994_: u32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_3859_: bool;
    var phi_1100_: type_41;
    var phi_1103_: u32;
    var phi_1105_: bool;
    var phi_1107_: u32;
    var phi_1109_: type_52;
    var phi_1120_: bool;
    var phi_1206_: bool;
    var phi_1207_: u32;
    var phi_1208_: type_52;
    var phi_1226_: type_41;
    var phi_1229_: type_4;
    var phi_1230_: type_4;
    var phi_1252_: type_4;
    var phi_1276_: u32;
    var phi_1368_: array<array<f32, 3>, 3>;
    var phi_3494_: bool;
    var phi_3509_: bool;
    var phi_3524_: bool;
    var phi_3539_: bool;
    var phi_3554_: bool;
    var phi_3569_: bool;
    var phi_1910_: f32;
    var phi_1911_: f32;
    var phi_1912_: f32;
    var phi_1913_: f32;
    var phi_1914_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1916_: vec3<f32>;
    var phi_1917_: vec3<f32>;
    var phi_3584_: bool;
    var phi_3599_: bool;
    var phi_3614_: bool;
    var phi_3629_: bool;
    var phi_3644_: bool;
    var phi_3659_: bool;
    var phi_2125_: f32;
    var phi_2145_: type_37;
    var phi_2146_: type_37;
    var phi_2149_: type_37;
    var phi_2150_: type_37;
    var phi_2151_: bool;
    var phi_2155_: type_37;
    var phi_2164_: type_25;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2197_: type_41;
    var phi_2198_: type_41;
    var phi_2199_: type_41;
    var phi_1227_: type_41;
    var phi_3853_: bool;
    var phi_4104_: bool;
    var phi_2200_: type_41;
    var phi_2927_: u32;
    var phi_2928_: u32;
    var phi_2938_: u32;
    var phi_2940_: u32;
    var phi_2941_: bool;
    var phi_2961_: u32;
    var phi_2962_: u32;
    var phi_2966_: type_53;
    var phi_3331_: type_52;
    var phi_3407_: type_52;
    var phi_3408_: u32;
    var phi_3409_: type_52;
    var phi_3411_: u32;
    var phi_3412_: type_52;
    var phi_3413_: bool;
    var phi_3422_: type_52;
    var phi_3427_: bool;
    var phi_3429_: type_52;
    var phi_3434_: type_41;
    var phi_3435_: bool;
    var phi_3436_: u32;
    var phi_3437_: type_52;
    var phi_3445_: type_41;
    var phi_3448_: type_52;
    var phi_4021_: bool;
    var phi_3449_: type_41;
    var phi_3450_: u32;
    var phi_3451_: bool;
    var phi_3452_: u32;
    var phi_3453_: type_52;
    var phi_4020_: bool;
    var phi_3454_: type_41;
    var phi_3455_: u32;
    var phi_3456_: bool;
    var phi_3457_: u32;
    var phi_3458_: type_52;
    var phi_4019_: bool;
    var phi_1101_: type_41;
    var phi_1104_: u32;
    var phi_1106_: bool;
    var phi_1108_: u32;
    var phi_1110_: type_52;
    var phi_3459_: bool;
    var phi_4018_: bool;
    var local_10: type_41;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[0u][3u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e137 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e109) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e97), bitcast<i32>(_e101), bitcast<i32>(_e105));
            local = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            let _e143 = (_e85.x + (_e85.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_4.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_6.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_4.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_4.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_4.member[_e143].member_1;
                    let _e205 = bitcast<u32>(_e204);
                    let _e206 = (_e205 & 2147483647u);
                    let _e213 = global_4.member[_e143].member_3;
                    let _e214 = bitcast<u32>(_e213);
                    let _e215 = (_e214 & 2147483647u);
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && (_e215 <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_410_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_410_;
                        phi_411_ = _e236;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e238 = phi_411_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e162 == _e194);
                    }
                    let _e242 = phi_421_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_431_ = _e244;
                        phi_432_ = _e244;
                        phi_434_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e248 = phi_431_;
                    let _e250 = phi_432_;
                    let _e252 = phi_434_;
                    if _e252 {
                        phi_439_ = (_e250 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e256 = phi_439_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_452_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_472_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_4.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_490_ = _e295[0];
                    } else {
                        phi_490_ = _e295[1];
                    }
                    let _e300 = phi_490_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_496_ = _e295[2];
                    } else {
                        phi_496_ = _e300;
                    }
                    let _e304 = phi_496_;
                    let _e305 = bitcast<u32>(_e304);
                    let _e307 = ((_e305 & 2139095040u) != 0u);
                    let _e321 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e305 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e305 & 2147483648u))), _e304, _e307) * _e268) * select(0.00000011920929f, 1f, _e307)) * _e274);
                    let _e322 = global_4.member[_e143].member_2;
                    if _e296 {
                        phi_536_ = _e322[0];
                    } else {
                        phi_536_ = _e322[1];
                    }
                    let _e326 = phi_536_;
                    if _e301 {
                        phi_542_ = _e322[2];
                    } else {
                        phi_542_ = _e326;
                    }
                    let _e329 = phi_542_;
                    let _e330 = bitcast<u32>(_e329);
                    let _e332 = ((_e330 & 2139095040u) != 0u);
                    let _e346 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e329, _e332) * _e285) * select(0.00000011920929f, 1f, _e332)) * _e291);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e353 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                    let _e354 = (_e353 * 0.00000011920929f);
                    let _e357 = select(select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f)), 0f, _e350);
                    let _e358 = select(0f, _e346, _e350);
                    let _e359 = (_e321 + _e357);
                    let _e360 = (_e321 - _e357);
                    let _e362 = select(38685626000000000000000000f, (1f / _e346), _e350);
                    let _e363 = (_e256 == 0u);
                    if _e363 {
                        phi_615_ = _e295[0];
                    } else {
                        phi_615_ = _e295[1];
                    }
                    let _e367 = phi_615_;
                    let _e368 = (_e256 == 2u);
                    if _e368 {
                        phi_621_ = _e295[2];
                    } else {
                        phi_621_ = _e367;
                    }
                    let _e371 = phi_621_;
                    let _e372 = bitcast<u32>(_e371);
                    let _e374 = ((_e372 & 2139095040u) != 0u);
                    let _e388 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e371, _e374) * _e268) * select(0.00000011920929f, 1f, _e374)) * _e274);
                    if _e363 {
                        phi_661_ = _e322[0];
                    } else {
                        phi_661_ = _e322[1];
                    }
                    let _e392 = phi_661_;
                    if _e368 {
                        phi_667_ = _e322[2];
                    } else {
                        phi_667_ = _e392;
                    }
                    let _e395 = phi_667_;
                    let _e396 = bitcast<u32>(_e395);
                    let _e398 = ((_e396 & 2139095040u) != 0u);
                    let _e412 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e396 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e396 & 2147483648u))), _e395, _e398) * _e285) * select(0.00000011920929f, 1f, _e398)) * _e291);
                    let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e419 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                    let _e420 = (_e419 * 0.00000011920929f);
                    let _e423 = select(select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f)), 0f, _e416);
                    let _e424 = select(0f, _e412, _e416);
                    let _e425 = (_e388 + _e423);
                    let _e426 = (_e388 - _e423);
                    let _e428 = select(38685626000000000000000000f, (1f / _e412), _e416);
                    let _e429 = (_e258 == 0u);
                    if _e429 {
                        phi_740_ = _e295[0];
                    } else {
                        phi_740_ = _e295[1];
                    }
                    let _e433 = phi_740_;
                    let _e434 = (_e258 == 2u);
                    if _e434 {
                        phi_746_ = _e295[2];
                    } else {
                        phi_746_ = _e433;
                    }
                    let _e437 = phi_746_;
                    let _e438 = bitcast<u32>(_e437);
                    let _e440 = ((_e438 & 2139095040u) != 0u);
                    let _e454 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e438 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e438 & 2147483648u))), _e437, _e440) * _e268) * select(0.00000011920929f, 1f, _e440)) * _e274);
                    if _e429 {
                        phi_786_ = _e322[0];
                    } else {
                        phi_786_ = _e322[1];
                    }
                    let _e458 = phi_786_;
                    if _e434 {
                        phi_792_ = _e322[2];
                    } else {
                        phi_792_ = _e458;
                    }
                    let _e461 = phi_792_;
                    let _e462 = bitcast<u32>(_e461);
                    let _e464 = ((_e462 & 2139095040u) != 0u);
                    let _e478 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e462 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e462 & 2147483648u))), _e461, _e464) * _e285) * select(0.00000011920929f, 1f, _e464)) * _e291);
                    let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e485 = bitcast<f32>((bitcast<u32>(_e454) & 2147483647u));
                    let _e486 = (_e485 * 0.00000011920929f);
                    let _e489 = select(select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f)), 0f, _e482);
                    let _e490 = select(0f, _e478, _e482);
                    let _e491 = (_e454 + _e489);
                    let _e492 = (_e454 - _e489);
                    let _e494 = select(38685626000000000000000000f, (1f / _e478), _e482);
                    let _e496 = select(_e419, _e353, (_e353 > _e419));
                    let _e499 = (_e125 + _e238);
                    if (_e219 && (select(_e485, _e496, (_e496 > _e485)) <= 1099511600000f)) {
                        let _e509 = ((_e206 & 8388607u) | (select(0u, 1u, ((_e206 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e512 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
                        let _e516 = (_e509 == 0u);
                        let _e519 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e509)), 32u, _e516)) - 8i);
                        if (_e512 == 255i) {
                            phi_911_ = 255i;
                        } else {
                            phi_911_ = (((_e512 + select(0i, 1i, (_e512 == 0i))) - _e519) + _e499);
                        }
                        let _e527 = phi_911_;
                        let _e537 = (_e527 <= 0i);
                        if _e537 {
                            phi_934_ = u32();
                        } else {
                            if _e516 {
                                phi_933_ = u32();
                            } else {
                                phi_933_ = select(((bitcast<u32>(_e527) << bitcast<u32>(23i)) | ((_e509 << bitcast<u32>(((_e519 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e527 >= 255i));
                            }
                            let _e541 = phi_933_;
                            phi_934_ = _e541;
                        }
                        let _e543 = phi_934_;
                        let _e555 = ((_e215 & 8388607u) | (select(0u, 1u, ((_e215 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e558 = bitcast<i32>((_e215 >> bitcast<u32>(23i)));
                        let _e562 = (_e555 == 0u);
                        let _e565 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e555)), 32u, _e562)) - 8i);
                        if (_e558 == 255i) {
                            phi_971_ = 255i;
                        } else {
                            phi_971_ = (((_e558 + select(0i, 1i, (_e558 == 0i))) - _e565) + _e499);
                        }
                        let _e573 = phi_971_;
                        let _e583 = (_e573 <= 0i);
                        if _e583 {
                            phi_994_ = u32();
                        } else {
                            if _e562 {
                                phi_993_ = u32();
                            } else {
                                phi_993_ = select(((bitcast<u32>(_e573) << bitcast<u32>(23i)) | ((_e555 << bitcast<u32>(((_e565 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e573 >= 255i));
                            }
                            let _e587 = phi_993_;
                            phi_994_ = _e587;
                        }
                        let _e589 = phi_994_;
                        phi_1002_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e589, 0u, select(_e562, true, _e583))));
                        phi_1003_ = bitcast<f32>(((_e205 & 2147483648u) | select(_e543, 0u, select(_e516, true, _e537))));
                    } else {
                        phi_1002_ = 0f;
                        phi_1003_ = 1f;
                    }
                    let _e595 = phi_1002_;
                    let _e597 = phi_1003_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e602 = (_e257 % 3u);
                    let _e603 = (_e602 < 3u);
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e605 = local_1[_e602];
                    let _e608 = (_e256 % 3u);
                    let _e609 = (_e608 < 3u);
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e611 = local_1[_e608];
                    let _e614 = (_e258 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e622 = local[_e602];
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e626 = local[_e608];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e630 = local[_e614];
                    phi_3859_ = false;
                    phi_1100_ = type_41(type_34(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e595), 0u, 0u);
                    phi_1103_ = ((3u * _e87) + 1u);
                    phi_1105_ = (_e597 <= _e595);
                    phi_1107_ = 0u;
                    phi_1109_ = type_52(type_29(vec4<f32>((f32(_e605) * _e137), (f32(_e611) * _e137), (f32(_e617) * _e137), 0f), vec4<f32>((f32(_e622) * _e137), (f32(_e626) * _e137), (f32(_e630) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    loop {
                        let _e640 = phi_3859_;
                        let _e642 = phi_1100_;
                        let _e644 = phi_1103_;
                        let _e646 = phi_1105_;
                        let _e648 = phi_1107_;
                        let _e650 = phi_1109_;
                        local_10 = _e642;
                        local_11 = _e642;
                        if _e646 {
                            phi_1120_ = true;
                        } else {
                            phi_1120_ = (_e648 > 0u);
                        }
                        let _e653 = phi_1120_;
                        if _e653 {
                            let _e654 = (_e644 > 0u);
                            if _e654 {
                                if _e646 {
                                    phi_1206_ = _e646;
                                    phi_1207_ = _e648;
                                    phi_1208_ = _e650;
                                } else {
                                    let _e655 = (_e648 - 1u);
                                    let _e656 = (_e655 % 128u);
                                    let _e657 = (_e656 < 128u);
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e659 = local_7[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e661 = local_6[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e663 = local_5[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e665 = local_4[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e667 = local_3[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e669 = local_2[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e674 = local_8[_e656];
                                    if _e657 {
                                    } else {
                                        phi_4018_ = true;
                                        break;
                                    }
                                    let _e677 = local_9[_e656];
                                    phi_1206_ = (_e677 <= _e642.member.member_1);
                                    phi_1207_ = _e655;
                                    phi_1208_ = type_52(type_29(vec4<f32>(_e659, _e661, _e663, 0f), vec4<f32>(_e665, _e667, _e669, 0f)), _e674);
                                }
                                let _e682 = phi_1206_;
                                let _e684 = phi_1207_;
                                let _e686 = phi_1208_;
                                if _e682 {
                                    let _e690 = ((_e686.member_1 & 2147483648u) != 0u);
                                    if _e690 {
                                        phi_1226_ = _e642;
                                        phi_1229_ = type_4(0u, ((_e686.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e697 = phi_1226_;
                                            let _e699 = phi_1229_;
                                            local_12 = _e697;
                                            if (_e699.member < _e699.member_1) {
                                                phi_1230_ = type_4((_e699.member + 1u), _e699.member_1);
                                                phi_1252_ = type_4(1u, _e699.member);
                                            } else {
                                                phi_1230_ = _e699;
                                                phi_1252_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e712 = phi_1230_;
                                            let _e714 = phi_1252_;
                                            let _e718 = (bitcast<i32>(_e714.member) != 0i);
                                            if _e718 {
                                                let _e724 = type_41(_e697.member, _e697.member_1, (_e697.member_2 + 1u));
                                                let _e725 = ((_e686.member_1 & 268435455u) + _e714.member_1);
                                                let _e726 = (_e725 < _e89);
                                                if _e726 {
                                                    if _e726 {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e730 = global_2.member[_e725].member_1;
                                                    phi_1276_ = _e730;
                                                } else {
                                                    phi_1276_ = 4294967295u;
                                                }
                                                let _e732 = phi_1276_;
                                                if (_e725 >= _e89) {
                                                    phi_1368_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e726 {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    if (_e602 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e739 = global_2.member[_e725].member[_e602];
                                                    if (_e608 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e725].member[_e608];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e751 = global_2.member[_e725].member[_e614];
                                                    let _e753 = (3u + _e602);
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e725].member[_e753];
                                                    let _e760 = (3u + _e608);
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e766 = global_2.member[_e725].member[_e760];
                                                    let _e767 = (3u + _e614);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e725].member[_e767];
                                                    let _e775 = (6u + _e602);
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e781 = global_2.member[_e725].member[_e775];
                                                    let _e782 = (6u + _e608);
                                                    if (_e782 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e788 = global_2.member[_e725].member[_e782];
                                                    let _e789 = (6u + _e614);
                                                    if (_e789 < 9u) {
                                                    } else {
                                                        phi_3853_ = true;
                                                        break;
                                                    }
                                                    let _e795 = global_2.member[_e725].member[_e789];
                                                    phi_1368_ = array<array<f32, 3>, 3>(array<f32, 3>(_e739, _e745, _e751), array<f32, 3>(_e759, _e766, _e773), array<f32, 3>(_e781, _e788, _e795));
                                                }
                                                let _e799 = phi_1368_;
                                                let _e816 = (_e799[0][2] - _e454);
                                                let _e819 = (((_e799[0][0] - _e321) * _e490) - (_e816 * _e358));
                                                let _e822 = (((_e799[0][1] - _e388) * _e490) - (_e816 * _e424));
                                                let _e825 = (_e799[1][2] - _e454);
                                                let _e828 = (((_e799[1][0] - _e321) * _e490) - (_e825 * _e358));
                                                let _e831 = (((_e799[1][1] - _e388) * _e490) - (_e825 * _e424));
                                                let _e834 = (_e799[2][2] - _e454);
                                                let _e837 = (((_e799[2][0] - _e321) * _e490) - (_e834 * _e358));
                                                let _e840 = (((_e799[2][1] - _e388) * _e490) - (_e834 * _e424));
                                                let _e841 = (_e837 * _e831);
                                                let _e842 = (_e840 * _e828);
                                                let _e843 = (_e819 * _e840);
                                                let _e844 = (_e822 * _e837);
                                                let _e845 = (_e828 * _e822);
                                                let _e846 = (_e831 * _e819);
                                                let _e851 = (((_e841 >= _e842) && (_e843 >= _e844)) && (_e845 >= _e846));
                                                let _e857 = (_e851 || (((_e841 <= _e842) && (_e843 <= _e844)) && (_e845 <= _e846)));
                                                if _e857 {
                                                    let _e859 = select(-1f, 1f, _e851);
                                                    let _e861 = ((_e841 - _e842) * _e859);
                                                    let _e863 = select(0f, _e861, (_e861 > 0f));
                                                    let _e865 = ((_e843 - _e844) * _e859);
                                                    let _e867 = select(0f, _e865, (_e865 > 0f));
                                                    let _e869 = ((_e845 - _e846) * _e859);
                                                    let _e871 = select(0f, _e869, (_e869 > 0f));
                                                    let _e873 = ((_e863 + _e867) + _e871);
                                                    let _e875 = select(_e799[1][0], _e799[0][0], (_e799[0][0] < _e799[1][0]));
                                                    let _e879 = select(_e799[1][0], _e799[0][0], (_e799[0][0] > _e799[1][0]));
                                                    let _e883 = select(_e799[1][1], _e799[0][1], (_e799[0][1] < _e799[1][1]));
                                                    let _e887 = select(_e799[1][1], _e799[0][1], (_e799[0][1] > _e799[1][1]));
                                                    let _e891 = select(_e799[1][2], _e799[0][2], (_e799[0][2] < _e799[1][2]));
                                                    let _e895 = select(_e799[1][2], _e799[0][2], (_e799[0][2] > _e799[1][2]));
                                                    let _e900 = ((select(_e799[2][0], _e875, (_e875 < _e799[2][0])) - _e359) * _e362);
                                                    let _e901 = ((select(_e799[2][0], _e879, (_e879 > _e799[2][0])) - _e360) * _e362);
                                                    let _e904 = ((select(_e799[2][1], _e883, (_e883 < _e799[2][1])) - _e425) * _e428);
                                                    let _e905 = ((select(_e799[2][1], _e887, (_e887 > _e799[2][1])) - _e426) * _e428);
                                                    let _e908 = ((select(_e799[2][2], _e891, (_e891 < _e799[2][2])) - _e491) * _e494);
                                                    let _e909 = ((select(_e799[2][2], _e895, (_e895 > _e799[2][2])) - _e492) * _e494);
                                                    let _e911 = select(_e909, _e908, (_e908 < _e909));
                                                    let _e913 = select(_e909, _e908, (_e908 > _e909));
                                                    let _e915 = select(_e901, _e900, (_e900 < _e901));
                                                    let _e917 = select(_e905, _e904, (_e904 < _e905));
                                                    let _e919 = select(_e917, _e915, (_e915 > _e917));
                                                    let _e921 = select(_e911, _e919, (_e919 > _e911));
                                                    let _e923 = select(_e901, _e900, (_e900 > _e901));
                                                    let _e925 = select(_e905, _e904, (_e904 > _e905));
                                                    let _e927 = select(_e925, _e923, (_e923 < _e925));
                                                    let _e929 = select(_e913, _e927, (_e927 < _e913));
                                                    let _e930 = -(_e911);
                                                    let _e936 = select(_e597, _e921, (_e921 > _e597));
                                                    let _e940 = select(_e828, _e819, (_e819 < _e828));
                                                    let _e945 = select(_e828, _e819, (_e819 > _e828));
                                                    let _e952 = select(_e831, _e822, (_e822 < _e831));
                                                    let _e957 = select(_e831, _e822, (_e822 > _e831));
                                                    let _e966 = (((((_e857 && (_e873 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e837, _e940, (_e940 < _e837)) <= 0f) && (select(_e837, _e945, (_e945 > _e837)) >= 0f))) && ((select(_e840, _e952, (_e952 < _e840)) <= 0f) && (select(_e840, _e957, (_e957 > _e840)) >= 0f))) && (_e936 <= (_e929 + (select(_e930, _e913, (_e913 > _e930)) * 0.0000019073523f)))) && (_e936 <= _e697.member.member_1));
                                                    if _e966 {
                                                        let _e971 = (_e799[1][0] - _e799[0][0]);
                                                        let _e972 = (_e799[1][1] - _e799[0][1]);
                                                        let _e973 = (_e799[1][2] - _e799[0][2]);
                                                        let _e974 = vec3<f32>(_e971, _e972, _e973);
                                                        let _e975 = (_e799[2][0] - _e799[1][0]);
                                                        let _e976 = (_e799[2][1] - _e799[1][1]);
                                                        let _e977 = (_e799[2][2] - _e799[1][2]);
                                                        let _e978 = vec3<f32>(_e975, _e976, _e977);
                                                        let _e979 = (_e799[0][0] - _e799[2][0]);
                                                        let _e980 = (_e799[0][1] - _e799[2][1]);
                                                        let _e981 = (_e799[0][2] - _e799[2][2]);
                                                        let _e982 = vec3<f32>(_e979, _e980, _e981);
                                                        let _e983 = abs(_e971);
                                                        let _e984 = abs(_e972);
                                                        if (_e983 != _e983) {
                                                            phi_3494_ = true;
                                                        } else {
                                                            phi_3494_ = (_e984 >= _e983);
                                                        }
                                                        let _e988 = phi_3494_;
                                                        let _e989 = select(_e983, _e984, _e988);
                                                        let _e990 = abs(_e973);
                                                        if (_e989 != _e989) {
                                                            phi_3509_ = true;
                                                        } else {
                                                            phi_3509_ = (_e990 >= _e989);
                                                        }
                                                        let _e994 = phi_3509_;
                                                        let _e995 = select(_e989, _e990, _e994);
                                                        let _e996 = abs(_e975);
                                                        let _e997 = abs(_e976);
                                                        if (_e996 != _e996) {
                                                            phi_3524_ = true;
                                                        } else {
                                                            phi_3524_ = (_e997 >= _e996);
                                                        }
                                                        let _e1001 = phi_3524_;
                                                        let _e1002 = select(_e996, _e997, _e1001);
                                                        let _e1003 = abs(_e977);
                                                        if (_e1002 != _e1002) {
                                                            phi_3539_ = true;
                                                        } else {
                                                            phi_3539_ = (_e1003 >= _e1002);
                                                        }
                                                        let _e1007 = phi_3539_;
                                                        let _e1008 = select(_e1002, _e1003, _e1007);
                                                        let _e1009 = abs(_e979);
                                                        let _e1010 = abs(_e980);
                                                        if (_e1009 != _e1009) {
                                                            phi_3554_ = true;
                                                        } else {
                                                            phi_3554_ = (_e1010 >= _e1009);
                                                        }
                                                        let _e1014 = phi_3554_;
                                                        let _e1015 = select(_e1009, _e1010, _e1014);
                                                        let _e1016 = abs(_e981);
                                                        if (_e1015 != _e1015) {
                                                            phi_3569_ = true;
                                                        } else {
                                                            phi_3569_ = (_e1016 >= _e1015);
                                                        }
                                                        let _e1020 = phi_3569_;
                                                        let _e1021 = select(_e1015, _e1016, _e1020);
                                                        let _e1023 = select(_e1008, _e995, (_e995 > _e1008));
                                                        let _e1025 = select(_e1021, _e1023, (_e1023 > _e1021));
                                                        if (_e995 == _e1025) {
                                                            phi_1910_ = _e831;
                                                            phi_1911_ = _e828;
                                                            phi_1912_ = _e822;
                                                            phi_1913_ = _e819;
                                                            phi_1914_ = vec3<f32>(_e799[0][0], _e799[0][1], _e799[0][2]);
                                                            phi_1915_ = _e982;
                                                            phi_1916_ = _e978;
                                                            phi_1917_ = _e974;
                                                        } else {
                                                            let _e1027 = (_e1008 == _e1025);
                                                            let _e1032 = vec3(_e1027);
                                                            phi_1910_ = select(_e822, _e840, _e1027);
                                                            phi_1911_ = select(_e819, _e837, _e1027);
                                                            phi_1912_ = select(_e840, _e831, _e1027);
                                                            phi_1913_ = select(_e837, _e828, _e1027);
                                                            phi_1914_ = select(vec3<f32>(_e799[2][0], _e799[2][1], _e799[2][2]), vec3<f32>(_e799[1][0], _e799[1][1], _e799[1][2]), _e1032);
                                                            phi_1915_ = select(_e978, _e974, _e1032);
                                                            phi_1916_ = select(_e974, _e982, _e1032);
                                                            phi_1917_ = select(_e982, _e978, _e1032);
                                                        }
                                                        let _e1038 = phi_1910_;
                                                        let _e1040 = phi_1911_;
                                                        let _e1042 = phi_1912_;
                                                        let _e1044 = phi_1913_;
                                                        let _e1046 = phi_1914_;
                                                        let _e1048 = phi_1915_;
                                                        let _e1050 = phi_1916_;
                                                        let _e1052 = phi_1917_;
                                                        let _e1059 = ((_e1050.y * _e1048.z) - (_e1048.y * _e1050.z));
                                                        let _e1064 = ((_e1050.z * _e1048.x) - (_e1048.z * _e1050.x));
                                                        let _e1067 = ((_e1050.x * _e1048.y) - (_e1048.x * _e1050.y));
                                                        let _e1070 = ((_e863 >= _e867) && (_e863 >= _e871));
                                                        let _e1071 = (_e867 >= _e871);
                                                        let _e1085 = (((_e1059 * (select(select(_e799[2][0], _e799[1][0], _e1071), _e799[0][0], _e1070) - _e321)) + (_e1064 * (select(select(_e799[2][1], _e799[1][1], _e1071), _e799[0][1], _e1070) - _e388))) + (_e1067 * (select(select(_e799[2][2], _e799[1][2], _e1071), _e799[0][2], _e1070) - _e454)));
                                                        let _e1090 = (((_e1059 * _e358) + (_e1064 * _e424)) + (_e1067 * _e490));
                                                        let _e1091 = (_e1040 - _e1044);
                                                        let _e1092 = (_e1038 - _e1042);
                                                        let _e1095 = ((_e1091 * _e1091) + (_e1092 * _e1092));
                                                        let _e1102 = (-(((_e1044 * _e1091) + (_e1042 * _e1092))) / select(0.000000000000000000000000000000000000011754944f, _e1095, (_e1095 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1104 = select(1f, _e1102, (_e1102 < 1f));
                                                        let _e1106 = select(0f, _e1104, (_e1104 > 0f));
                                                        let _e1115 = ((_e1046.x + (_e1052.x * _e1106)) - _e321);
                                                        let _e1118 = ((_e1046.y + (_e1052.y * _e1106)) - _e388);
                                                        let _e1121 = ((_e1046.z + (_e1052.z * _e1106)) - _e454);
                                                        let _e1124 = bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u));
                                                        let _e1127 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                        let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                                                        let _e1132 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                        let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                                                        let _e1138 = abs(_e1059);
                                                        let _e1139 = abs(_e1064);
                                                        if (_e1138 != _e1138) {
                                                            phi_3584_ = true;
                                                        } else {
                                                            phi_3584_ = (_e1139 >= _e1138);
                                                        }
                                                        let _e1143 = phi_3584_;
                                                        let _e1144 = select(_e1138, _e1139, _e1143);
                                                        let _e1145 = abs(_e1067);
                                                        if (_e1144 != _e1144) {
                                                            phi_3599_ = true;
                                                        } else {
                                                            phi_3599_ = (_e1145 >= _e1144);
                                                        }
                                                        let _e1149 = phi_3599_;
                                                        let _e1165 = abs(_e1050.x);
                                                        let _e1166 = abs(_e1050.y);
                                                        if (_e1165 != _e1165) {
                                                            phi_3614_ = true;
                                                        } else {
                                                            phi_3614_ = (_e1166 >= _e1165);
                                                        }
                                                        let _e1170 = phi_3614_;
                                                        let _e1171 = select(_e1165, _e1166, _e1170);
                                                        let _e1172 = abs(_e1050.z);
                                                        if (_e1171 != _e1171) {
                                                            phi_3629_ = true;
                                                        } else {
                                                            phi_3629_ = (_e1172 >= _e1171);
                                                        }
                                                        let _e1176 = phi_3629_;
                                                        let _e1179 = abs(_e1048.x);
                                                        let _e1180 = abs(_e1048.y);
                                                        if (_e1179 != _e1179) {
                                                            phi_3644_ = true;
                                                        } else {
                                                            phi_3644_ = (_e1180 >= _e1179);
                                                        }
                                                        let _e1184 = phi_3644_;
                                                        let _e1185 = select(_e1179, _e1180, _e1184);
                                                        let _e1186 = abs(_e1048.z);
                                                        if (_e1185 != _e1185) {
                                                            phi_3659_ = true;
                                                        } else {
                                                            phi_3659_ = (_e1186 >= _e1185);
                                                        }
                                                        let _e1190 = phi_3659_;
                                                        let _e1195 = ((bitcast<f32>((bitcast<u32>(((((_e1059 * _e1115) + (_e1064 * _e1118)) + (_e1067 * _e1121)) - _e1085)) & 2147483647u)) <= ((0.0000009536743f * select(_e1025, _e1134, (_e1134 > _e1025))) * select(_e1144, _e1145, _e1149))) && !((bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u)) <= ((0.0000038146973f * select(_e1171, _e1172, _e1176)) * select(_e1185, _e1186, _e1190)))));
                                                        let _e1196 = (_e1085 / _e1090);
                                                        if (_e966 && !(_e1195)) {
                                                            let _e1199 = (_e1121 / _e490);
                                                            let _e1207 = (((_e1059 * (_e1115 - (_e358 * _e1199))) + (_e1064 * (_e1118 - (_e424 * _e1199)))) / _e1090);
                                                            phi_2125_ = select(select(_e1199, (_e1199 + _e1207), (bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u)) <= _e1025)), _e1196, _e1195);
                                                        } else {
                                                            phi_2125_ = _e1196;
                                                        }
                                                        let _e1216 = phi_2125_;
                                                        let _e1218 = select(_e929, _e1216, (_e1216 < _e929));
                                                        let _e1220 = select(_e921, _e1218, (_e1218 > _e921));
                                                        let _e1221 = (1f / _e873);
                                                        phi_2145_ = type_37(_e1220, (_e867 * _e1221), (_e871 * _e1221), ((_e966 && (_e1220 >= _e597)) && (_e1220 <= _e697.member.member_1)));
                                                        phi_2146_ = type_37();
                                                    } else {
                                                        phi_2145_ = type_37();
                                                        phi_2146_ = type_37(0f, 0f, 0f, _e966);
                                                    }
                                                    let _e1230 = phi_2145_;
                                                    let _e1232 = phi_2146_;
                                                    phi_2149_ = _e1230;
                                                    phi_2150_ = _e1232;
                                                    phi_2151_ = select(true, false, _e966);
                                                } else {
                                                    phi_2149_ = type_37();
                                                    phi_2150_ = type_37(0f, 0f, 0f, _e857);
                                                    phi_2151_ = true;
                                                }
                                                let _e1235 = phi_2149_;
                                                let _e1237 = phi_2150_;
                                                let _e1239 = phi_2151_;
                                                if _e1239 {
                                                    phi_2155_ = _e1237;
                                                } else {
                                                    phi_2155_ = _e1235;
                                                }
                                                let _e1241 = phi_2155_;
                                                if _e1241.member_3 {
                                                    phi_2164_ = type_25(_e1241.member, _e1241.member_1, _e1241.member_2, _e732);
                                                } else {
                                                    phi_2164_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1248 = phi_2164_;
                                                if (_e1248.member_3 != 4294967295u) {
                                                    if (_e732 != 4294967295u) {
                                                        if (_e1248.member < _e697.member.member.member) {
                                                            phi_2190_ = true;
                                                        } else {
                                                            if (_e1248.member == _e697.member.member.member) {
                                                                phi_2189_ = (_e1248.member_3 < _e697.member.member.member_3);
                                                            } else {
                                                                phi_2189_ = false;
                                                            }
                                                            let _e1263 = phi_2189_;
                                                            phi_2190_ = _e1263;
                                                        }
                                                        let _e1265 = phi_2190_;
                                                        if _e1265 {
                                                            phi_2197_ = type_41(type_34(_e1248, _e1248.member), _e724.member_1, _e724.member_2);
                                                        } else {
                                                            phi_2197_ = _e724;
                                                        }
                                                        let _e1272 = phi_2197_;
                                                        phi_2198_ = _e1272;
                                                    } else {
                                                        phi_2198_ = _e724;
                                                    }
                                                    let _e1274 = phi_2198_;
                                                    phi_2199_ = _e1274;
                                                } else {
                                                    phi_2199_ = _e724;
                                                }
                                                let _e1276 = phi_2199_;
                                                phi_1227_ = _e1276;
                                            } else {
                                                phi_1227_ = type_41();
                                            }
                                            let _e1278 = phi_1227_;
                                            continue;
                                            continuing {
                                                phi_1226_ = _e1278;
                                                phi_1229_ = _e712;
                                                phi_3853_ = _e640;
                                                break if !(_e718);
                                            }
                                        }
                                        let _e1281 = phi_3853_;
                                        phi_4018_ = _e1281;
                                        if _e1281 {
                                            break;
                                        }
                                        phi_4104_ = _e1281;
                                        let _e1899 = local_12;
                                        phi_2200_ = _e1899;
                                    } else {
                                        phi_4104_ = _e640;
                                        phi_2200_ = _e642;
                                    }
                                    let _e1283 = phi_4104_;
                                    let _e1285 = phi_2200_;
                                    if _e690 {
                                        phi_3434_ = type_41();
                                        phi_3435_ = bool();
                                        phi_3436_ = u32();
                                        phi_3437_ = type_52();
                                    } else {
                                        if (_e686.member_1 >= _e87) {
                                            phi_2966_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e686.member_1 < _e87) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1288 = (_e257 * 2u);
                                            let _e1290 = ((1u + _e1288) % 7u);
                                            if (_e1290 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1295 = global_5.member[_e686.member_1][_e1290];
                                            let _e1297 = ((_e1288 + 2u) % 7u);
                                            if (_e1297 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1302 = global_5.member[_e686.member_1][_e1297];
                                            let _e1303 = (_e256 * 2u);
                                            let _e1305 = ((1u + _e1303) % 7u);
                                            if (_e1305 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1310 = global_5.member[_e686.member_1][_e1305];
                                            let _e1312 = ((_e1303 + 2u) % 7u);
                                            if (_e1312 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1317 = global_5.member[_e686.member_1][_e1312];
                                            let _e1318 = (_e258 * 2u);
                                            let _e1320 = ((1u + _e1318) % 7u);
                                            if (_e1320 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1325 = global_5.member[_e686.member_1][_e1320];
                                            let _e1327 = ((_e1318 + 2u) % 7u);
                                            if (_e1327 < 7u) {
                                            } else {
                                                phi_4018_ = true;
                                                break;
                                            }
                                            let _e1332 = global_5.member[_e686.member_1][_e1327];
                                            let _e1355 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.x - _e686.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1356 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.y - _e686.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1357 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.z - _e686.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1359 = select(_e137, _e1355, (_e1355 > _e137));
                                            let _e1361 = select(_e137, _e1356, (_e1356 > _e137));
                                            let _e1363 = select(_e137, _e1357, (_e1357 > _e137));
                                            let _e1394 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1295 & 2097151u))) - 8388608f) * _e1359));
                                            let _e1399 = (bitcast<i32>((_e1295 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1402 = bitcast<f32>((_e1394 & bitcast<u32>(_e1399)));
                                            let _e1403 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1310 & 2097151u))) - 8388608f) * _e1361));
                                            let _e1408 = (bitcast<i32>((_e1310 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1411 = bitcast<f32>((_e1403 & bitcast<u32>(_e1408)));
                                            let _e1412 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1325 & 2097151u))) - 8388608f) * _e1363));
                                            let _e1417 = (bitcast<i32>((_e1325 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1420 = bitcast<f32>((_e1412 & bitcast<u32>(_e1417)));
                                            let _e1424 = bitcast<f32>((_e1394 & bitcast<u32>(~(_e1399))));
                                            let _e1428 = bitcast<f32>((_e1403 & bitcast<u32>(~(_e1408))));
                                            let _e1432 = bitcast<f32>((_e1412 & bitcast<u32>(~(_e1417))));
                                            let _e1433 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1302 & 2097151u))) - 8388608f) * _e1359));
                                            let _e1438 = (bitcast<i32>((_e1302 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1441 = bitcast<f32>((_e1433 & bitcast<u32>(_e1438)));
                                            let _e1442 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1317 & 2097151u))) - 8388608f) * _e1361));
                                            let _e1447 = (bitcast<i32>((_e1317 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1450 = bitcast<f32>((_e1442 & bitcast<u32>(_e1447)));
                                            let _e1451 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1332 & 2097151u))) - 8388608f) * _e1363));
                                            let _e1456 = (bitcast<i32>((_e1332 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1459 = bitcast<f32>((_e1451 & bitcast<u32>(_e1456)));
                                            let _e1463 = bitcast<f32>((_e1433 & bitcast<u32>(~(_e1438))));
                                            let _e1467 = bitcast<f32>((_e1442 & bitcast<u32>(~(_e1447))));
                                            let _e1471 = bitcast<f32>((_e1451 & bitcast<u32>(~(_e1456))));
                                            let _e1501 = global_5.member[_e686.member_1][0u];
                                            let _e1505 = global_5.member[_e686.member_1][2u];
                                            let _e1509 = global_5.member[_e686.member_1][4u];
                                            let _e1513 = global_5.member[_e686.member_1][6u];
                                            let _e1525 = (((_e1505 >> bitcast<u32>(22i)) | ((_e1509 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1513 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1526 = (_e1501 & 268435455u);
                                            let _e1527 = (_e1525 & 268435455u);
                                            let _e1530 = ((_e1501 >> bitcast<u32>(28u)) & 7u);
                                            let _e1538 = ((_e1501 >> bitcast<u32>(31i)) | (((_e1525 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1539 = (_e1530 != 0u);
                                            if (_e1530 == 0u) {
                                                phi_2928_ = _e1526;
                                            } else {
                                                if (_e1530 == 7u) {
                                                    phi_2927_ = 2147483648u;
                                                } else {
                                                    phi_2927_ = ((2147483648u | (_e1530 << bitcast<u32>(28u))) | (_e1527 & 268435455u));
                                                }
                                                let _e1548 = phi_2927_;
                                                phi_2928_ = _e1548;
                                            }
                                            let _e1550 = phi_2928_;
                                            if _e1539 {
                                                let _e1551 = (_e1530 != 7u);
                                                if _e1551 {
                                                    phi_2938_ = (_e1527 + _e1530);
                                                } else {
                                                    phi_2938_ = u32();
                                                }
                                                let _e1554 = phi_2938_;
                                                phi_2940_ = _e1554;
                                                phi_2941_ = select(true, false, _e1551);
                                            } else {
                                                phi_2940_ = u32();
                                                phi_2941_ = true;
                                            }
                                            let _e1557 = phi_2940_;
                                            let _e1559 = phi_2941_;
                                            if (_e1538 == 0u) {
                                                phi_2962_ = (_e1526 + select(0u, 1u, !(_e1539)));
                                            } else {
                                                if (_e1538 == 7u) {
                                                    phi_2961_ = 2147483648u;
                                                } else {
                                                    phi_2961_ = ((2147483648u | (_e1538 << bitcast<u32>(28u))) | (select(_e1557, _e1527, _e1559) & 268435455u));
                                                }
                                                let _e1572 = phi_2961_;
                                                phi_2962_ = _e1572;
                                            }
                                            let _e1574 = phi_2962_;
                                            phi_2966_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e686.member.member.x + _e1402), (_e686.member.member.x + _e1424), (_e686.member.member_1.x - _e1441), (_e686.member.member_1.x - _e1463)), vec4<f32>((_e686.member.member.y + _e1411), (_e686.member.member.y + _e1428), (_e686.member.member_1.y - _e1450), (_e686.member.member_1.y - _e1467)), vec4<f32>((_e686.member.member.z + _e1420), (_e686.member.member.z + _e1432), (_e686.member.member_1.z - _e1459), (_e686.member.member_1.z - _e1471))), type_52(type_29((_e686.member.member + vec4<f32>(_e1402, _e1411, _e1420, 0f)), (_e686.member.member_1 - vec4<f32>(_e1441, _e1450, _e1459, 0f))), _e1550), type_52(type_29((_e686.member.member + vec4<f32>(_e1424, _e1428, _e1432, 0f)), (_e686.member.member_1 - vec4<f32>(_e1463, _e1467, _e1471, 0f))), _e1574));
                                        }
                                        let _e1579 = phi_2966_;
                                        let _e1598 = ((_e1579.member[0].x - _e359) * _e362);
                                        let _e1599 = ((_e1579.member[0].y - _e359) * _e362);
                                        let _e1600 = ((_e1579.member[0].z - _e360) * _e362);
                                        let _e1601 = ((_e1579.member[0].w - _e360) * _e362);
                                        let _e1611 = ((_e1579.member[1].x - _e425) * _e428);
                                        let _e1612 = ((_e1579.member[1].y - _e425) * _e428);
                                        let _e1613 = ((_e1579.member[1].z - _e426) * _e428);
                                        let _e1614 = ((_e1579.member[1].w - _e426) * _e428);
                                        let _e1624 = ((_e1579.member[2].x - _e491) * _e494);
                                        let _e1625 = ((_e1579.member[2].y - _e491) * _e494);
                                        let _e1626 = ((_e1579.member[2].z - _e492) * _e494);
                                        let _e1627 = ((_e1579.member[2].w - _e492) * _e494);
                                        let _e1629 = select(_e1626, _e1624, (_e1624 < _e1626));
                                        let _e1631 = select(_e1627, _e1625, (_e1625 < _e1627));
                                        let _e1633 = select(_e1626, _e1624, (_e1624 > _e1626));
                                        let _e1635 = select(_e1627, _e1625, (_e1625 > _e1627));
                                        let _e1637 = select(_e1600, _e1598, (_e1598 < _e1600));
                                        let _e1639 = select(_e1601, _e1599, (_e1599 < _e1601));
                                        let _e1641 = select(_e1613, _e1611, (_e1611 < _e1613));
                                        let _e1643 = select(_e1614, _e1612, (_e1612 < _e1614));
                                        let _e1645 = select(_e1641, _e1637, (_e1637 > _e1641));
                                        let _e1647 = select(_e1643, _e1639, (_e1639 > _e1643));
                                        let _e1649 = select(_e1629, _e1645, (_e1645 > _e1629));
                                        let _e1651 = select(_e1631, _e1647, (_e1647 > _e1631));
                                        let _e1653 = select(_e1600, _e1598, (_e1598 > _e1600));
                                        let _e1655 = select(_e1601, _e1599, (_e1599 > _e1601));
                                        let _e1657 = select(_e1613, _e1611, (_e1611 > _e1613));
                                        let _e1659 = select(_e1614, _e1612, (_e1612 > _e1614));
                                        let _e1661 = select(_e1657, _e1653, (_e1653 < _e1657));
                                        let _e1663 = select(_e1659, _e1655, (_e1655 < _e1659));
                                        let _e1668 = -(_e1629);
                                        let _e1669 = -(_e1631);
                                        let _e1676 = (select(_e1633, _e1661, (_e1661 < _e1633)) + (select(_e1668, _e1633, (_e1633 > _e1668)) * 0.0000019073523f));
                                        let _e1677 = (select(_e1635, _e1663, (_e1663 < _e1635)) + (select(_e1669, _e1635, (_e1635 > _e1669)) * 0.0000019073523f));
                                        let _e1679 = select(_e597, _e1649, (_e1649 > _e597));
                                        let _e1681 = select(_e597, _e1651, (_e1651 > _e597));
                                        let _e1686 = (_e1679 <= select(_e1285.member.member_1, _e1676, (_e1676 < _e1285.member.member_1)));
                                        let _e1687 = (_e1681 <= select(_e1285.member.member_1, _e1677, (_e1677 < _e1285.member.member_1)));
                                        let _e1688 = (_e1679 <= _e1681);
                                        if _e1686 {
                                            if _e1687 {
                                                if _e1688 {
                                                    phi_3331_ = _e1579.member_2;
                                                } else {
                                                    phi_3331_ = _e1579.member_1;
                                                }
                                                let _e1692 = phi_3331_;
                                                let _e1713 = (_e684 % 128u);
                                                let _e1714 = (_e1713 < 128u);
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_8[_e1713] = _e1692.member_1;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_7[_e1713] = _e1692.member.member.x;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_6[_e1713] = _e1692.member.member.y;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_5[_e1713] = _e1692.member.member.z;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_4[_e1713] = _e1692.member.member_1.x;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_3[_e1713] = _e1692.member.member_1.y;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_2[_e1713] = _e1692.member.member_1.z;
                                                if _e1714 {
                                                } else {
                                                    phi_4018_ = true;
                                                    break;
                                                }
                                                local_9[_e1713] = select(_e1679, _e1681, _e1688);
                                                if _e1688 {
                                                    phi_3407_ = _e1579.member_1;
                                                } else {
                                                    phi_3407_ = _e1579.member_2;
                                                }
                                                let _e1727 = phi_3407_;
                                                phi_3408_ = (_e684 + 1u);
                                                phi_3409_ = _e1727;
                                            } else {
                                                phi_3408_ = u32();
                                                phi_3409_ = type_52();
                                            }
                                            let _e1729 = phi_3408_;
                                            let _e1731 = phi_3409_;
                                            phi_3411_ = _e1729;
                                            phi_3412_ = _e1731;
                                            phi_3413_ = select(true, false, _e1687);
                                        } else {
                                            phi_3411_ = u32();
                                            phi_3412_ = type_52();
                                            phi_3413_ = true;
                                        }
                                        let _e1734 = phi_3411_;
                                        let _e1736 = phi_3412_;
                                        let _e1738 = phi_3413_;
                                        if _e1738 {
                                            if _e1686 {
                                                phi_3422_ = _e1579.member_1;
                                            } else {
                                                phi_3422_ = _e1579.member_2;
                                            }
                                            let _e1742 = phi_3422_;
                                            phi_3427_ = select(_e1687, true, _e1686);
                                            phi_3429_ = _e1742;
                                        } else {
                                            phi_3427_ = _e682;
                                            phi_3429_ = _e1736;
                                        }
                                        let _e1745 = phi_3427_;
                                        let _e1747 = phi_3429_;
                                        phi_3434_ = type_41(_e1285.member, (_e1285.member_1 + 1u), _e1285.member_2);
                                        phi_3435_ = _e1745;
                                        phi_3436_ = select(_e1734, _e684, _e1738);
                                        phi_3437_ = _e1747;
                                    }
                                    let _e1750 = phi_3434_;
                                    let _e1752 = phi_3435_;
                                    let _e1754 = phi_3436_;
                                    let _e1756 = phi_3437_;
                                    if _e690 {
                                        phi_3445_ = _e1285;
                                        phi_3448_ = _e686;
                                    } else {
                                        phi_3445_ = _e1750;
                                        phi_3448_ = _e1756;
                                    }
                                    let _e1758 = phi_3445_;
                                    let _e1760 = phi_3448_;
                                    phi_4021_ = _e1283;
                                    phi_3449_ = _e1758;
                                    phi_3450_ = (_e644 - 1u);
                                    phi_3451_ = select(_e1752, false, _e690);
                                    phi_3452_ = select(_e1754, _e684, _e690);
                                    phi_3453_ = _e1760;
                                } else {
                                    phi_4021_ = _e640;
                                    phi_3449_ = _e642;
                                    phi_3450_ = _e644;
                                    phi_3451_ = _e682;
                                    phi_3452_ = _e684;
                                    phi_3453_ = _e686;
                                }
                                let _e1764 = phi_4021_;
                                let _e1766 = phi_3449_;
                                let _e1768 = phi_3450_;
                                let _e1770 = phi_3451_;
                                let _e1772 = phi_3452_;
                                let _e1774 = phi_3453_;
                                phi_4020_ = _e1764;
                                phi_3454_ = _e1766;
                                phi_3455_ = _e1768;
                                phi_3456_ = _e1770;
                                phi_3457_ = _e1772;
                                phi_3458_ = _e1774;
                            } else {
                                phi_4020_ = _e640;
                                phi_3454_ = type_41();
                                phi_3455_ = u32();
                                phi_3456_ = bool();
                                phi_3457_ = u32();
                                phi_3458_ = type_52();
                            }
                            let _e1776 = phi_4020_;
                            let _e1778 = phi_3454_;
                            let _e1780 = phi_3455_;
                            let _e1782 = phi_3456_;
                            let _e1784 = phi_3457_;
                            let _e1786 = phi_3458_;
                            phi_4019_ = _e1776;
                            phi_1101_ = _e1778;
                            phi_1104_ = _e1780;
                            phi_1106_ = _e1782;
                            phi_1108_ = _e1784;
                            phi_1110_ = _e1786;
                            phi_3459_ = _e654;
                        } else {
                            phi_4019_ = _e640;
                            phi_1101_ = type_41();
                            phi_1104_ = u32();
                            phi_1106_ = bool();
                            phi_1108_ = u32();
                            phi_1110_ = type_52();
                            phi_3459_ = false;
                        }
                        let _e1788 = phi_4019_;
                        let _e1790 = phi_1101_;
                        let _e1792 = phi_1104_;
                        let _e1794 = phi_1106_;
                        let _e1796 = phi_1108_;
                        let _e1798 = phi_1110_;
                        let _e1800 = phi_3459_;
                        continue;
                        continuing {
                            phi_3859_ = _e1788;
                            phi_1100_ = _e1790;
                            phi_1103_ = _e1792;
                            phi_1105_ = _e1794;
                            phi_1107_ = _e1796;
                            phi_1109_ = _e1798;
                            phi_4018_ = _e1788;
                            break if !(_e1800);
                        }
                    }
                    let _e1803 = phi_4018_;
                    if _e1803 {
                        break;
                    }
                    let _e1805 = local_10;
                    let _e1808 = local_11;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143][0u] = _e1805.member_1;
                    global_6.member[_e143][1u] = _e1808.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
