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
    var phi_417_: i32;
    var phi_418_: i32;
    var phi_428_: bool;
    var phi_438_: u32;
    var phi_439_: u32;
    var phi_441_: bool;
    var phi_446_: u32;
    var phi_459_: i32;
    var phi_479_: i32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_668_: f32;
    var phi_674_: f32;
    var phi_747_: f32;
    var phi_753_: f32;
    var phi_793_: f32;
    var phi_799_: f32;
    var phi_918_: i32;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_978_: i32;
    var phi_1000_: u32;
    var phi_1001_: u32;
    var phi_1009_: f32;
    var phi_1010_: f32;
    var phi_3785_: bool;
    var phi_1107_: type_41;
    var phi_1110_: bool;
    var phi_1112_: type_52;
    var phi_1114_: u32;
    var phi_1116_: u32;
    var phi_1127_: bool;
    var phi_1213_: bool;
    var phi_1214_: type_52;
    var phi_1215_: u32;
    var phi_2904_: u32;
    var phi_2905_: u32;
    var phi_2915_: u32;
    var phi_2917_: u32;
    var phi_2918_: bool;
    var phi_2938_: u32;
    var phi_2939_: u32;
    var phi_2943_: type_53;
    var phi_3308_: type_52;
    var phi_3384_: type_52;
    var phi_3385_: type_52;
    var phi_3386_: u32;
    var phi_3388_: type_52;
    var phi_3389_: u32;
    var phi_3390_: bool;
    var phi_3399_: type_52;
    var phi_3404_: bool;
    var phi_3405_: type_52;
    var phi_1233_: type_41;
    var phi_1236_: type_4;
    var phi_1237_: type_4;
    var phi_1259_: type_4;
    var phi_1283_: u32;
    var phi_1375_: array<array<f32, 3>, 3>;
    var phi_1905_: f32;
    var phi_1906_: f32;
    var phi_1907_: f32;
    var phi_1908_: f32;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1911_: vec3<f32>;
    var phi_1912_: vec3<f32>;
    var phi_2103_: f32;
    var phi_2123_: type_37;
    var phi_2124_: type_37;
    var phi_2127_: type_37;
    var phi_2128_: type_37;
    var phi_2129_: bool;
    var phi_2133_: type_37;
    var phi_2142_: type_25;
    var phi_2167_: bool;
    var phi_2168_: bool;
    var phi_2175_: type_41;
    var phi_2176_: type_41;
    var phi_2177_: type_41;
    var phi_1234_: type_41;
    var phi_3779_: bool;
    var local_10: type_41;
    var phi_3936_: bool;
    var phi_3407_: type_41;
    var phi_3408_: bool;
    var phi_3409_: type_52;
    var phi_3410_: u32;
    var phi_3935_: bool;
    var phi_3411_: type_41;
    var phi_3412_: bool;
    var phi_3413_: type_52;
    var phi_3414_: u32;
    var phi_3415_: u32;
    var phi_3934_: bool;
    var phi_3416_: type_41;
    var phi_3417_: bool;
    var phi_3418_: type_52;
    var phi_3419_: u32;
    var phi_3420_: u32;
    var phi_3933_: bool;
    var phi_1108_: type_41;
    var phi_1111_: bool;
    var phi_1113_: type_52;
    var phi_1115_: u32;
    var phi_1117_: u32;
    var phi_3421_: bool;
    var phi_3932_: bool;
    var local_11: type_41;
    var local_12: type_41;
    var local_13: type_41;

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
                            phi_417_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_417_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_417_;
                        phi_418_ = _e236;
                    } else {
                        phi_418_ = 0i;
                    }
                    let _e238 = phi_418_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_428_ = true;
                    } else {
                        phi_428_ = (_e162 == _e194);
                    }
                    let _e242 = phi_428_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_438_ = _e244;
                        phi_439_ = _e244;
                        phi_441_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_438_ = u32();
                        phi_439_ = 0u;
                        phi_441_ = true;
                    }
                    let _e248 = phi_438_;
                    let _e250 = phi_439_;
                    let _e252 = phi_441_;
                    if _e252 {
                        phi_446_ = (_e250 + 1u);
                    } else {
                        phi_446_ = 0u;
                    }
                    let _e256 = phi_446_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_459_ = -126i;
                    } else {
                        phi_459_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_459_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_479_ = -126i;
                    } else {
                        phi_479_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_479_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_4.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_497_ = _e295[0];
                    } else {
                        phi_497_ = _e295[1];
                    }
                    let _e300 = phi_497_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_503_ = _e295[2];
                    } else {
                        phi_503_ = _e300;
                    }
                    let _e304 = phi_503_;
                    let _e305 = bitcast<u32>(_e304);
                    let _e307 = ((_e305 & 2139095040u) != 0u);
                    let _e321 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e305 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e305 & 2147483648u))), _e304, _e307) * _e268) * select(0.00000011920929f, 1f, _e307)) * _e274);
                    let _e322 = global_4.member[_e143].member_2;
                    if _e296 {
                        phi_543_ = _e322[0];
                    } else {
                        phi_543_ = _e322[1];
                    }
                    let _e326 = phi_543_;
                    if _e301 {
                        phi_549_ = _e322[2];
                    } else {
                        phi_549_ = _e326;
                    }
                    let _e329 = phi_549_;
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
                        phi_622_ = _e295[0];
                    } else {
                        phi_622_ = _e295[1];
                    }
                    let _e367 = phi_622_;
                    let _e368 = (_e256 == 2u);
                    if _e368 {
                        phi_628_ = _e295[2];
                    } else {
                        phi_628_ = _e367;
                    }
                    let _e371 = phi_628_;
                    let _e372 = bitcast<u32>(_e371);
                    let _e374 = ((_e372 & 2139095040u) != 0u);
                    let _e388 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e371, _e374) * _e268) * select(0.00000011920929f, 1f, _e374)) * _e274);
                    if _e363 {
                        phi_668_ = _e322[0];
                    } else {
                        phi_668_ = _e322[1];
                    }
                    let _e392 = phi_668_;
                    if _e368 {
                        phi_674_ = _e322[2];
                    } else {
                        phi_674_ = _e392;
                    }
                    let _e395 = phi_674_;
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
                        phi_747_ = _e295[0];
                    } else {
                        phi_747_ = _e295[1];
                    }
                    let _e433 = phi_747_;
                    let _e434 = (_e258 == 2u);
                    if _e434 {
                        phi_753_ = _e295[2];
                    } else {
                        phi_753_ = _e433;
                    }
                    let _e437 = phi_753_;
                    let _e438 = bitcast<u32>(_e437);
                    let _e440 = ((_e438 & 2139095040u) != 0u);
                    let _e454 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e438 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e438 & 2147483648u))), _e437, _e440) * _e268) * select(0.00000011920929f, 1f, _e440)) * _e274);
                    if _e429 {
                        phi_793_ = _e322[0];
                    } else {
                        phi_793_ = _e322[1];
                    }
                    let _e458 = phi_793_;
                    if _e434 {
                        phi_799_ = _e322[2];
                    } else {
                        phi_799_ = _e458;
                    }
                    let _e461 = phi_799_;
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
                            phi_918_ = 255i;
                        } else {
                            phi_918_ = (((_e512 + select(0i, 1i, (_e512 == 0i))) - _e519) + _e499);
                        }
                        let _e527 = phi_918_;
                        let _e537 = (_e527 <= 0i);
                        if _e537 {
                            phi_941_ = u32();
                        } else {
                            if _e516 {
                                phi_940_ = u32();
                            } else {
                                phi_940_ = select(((bitcast<u32>(_e527) << bitcast<u32>(23i)) | ((_e509 << bitcast<u32>(((_e519 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e527 >= 255i));
                            }
                            let _e541 = phi_940_;
                            phi_941_ = _e541;
                        }
                        let _e543 = phi_941_;
                        let _e555 = ((_e215 & 8388607u) | (select(0u, 1u, ((_e215 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e558 = bitcast<i32>((_e215 >> bitcast<u32>(23i)));
                        let _e562 = (_e555 == 0u);
                        let _e565 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e555)), 32u, _e562)) - 8i);
                        if (_e558 == 255i) {
                            phi_978_ = 255i;
                        } else {
                            phi_978_ = (((_e558 + select(0i, 1i, (_e558 == 0i))) - _e565) + _e499);
                        }
                        let _e573 = phi_978_;
                        let _e583 = (_e573 <= 0i);
                        if _e583 {
                            phi_1001_ = u32();
                        } else {
                            if _e562 {
                                phi_1000_ = u32();
                            } else {
                                phi_1000_ = select(((bitcast<u32>(_e573) << bitcast<u32>(23i)) | ((_e555 << bitcast<u32>(((_e565 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e573 >= 255i));
                            }
                            let _e587 = phi_1000_;
                            phi_1001_ = _e587;
                        }
                        let _e589 = phi_1001_;
                        phi_1009_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e589, 0u, select(_e562, true, _e583))));
                        phi_1010_ = bitcast<f32>(((_e205 & 2147483648u) | select(_e543, 0u, select(_e516, true, _e537))));
                    } else {
                        phi_1009_ = 0f;
                        phi_1010_ = 1f;
                    }
                    let _e595 = phi_1009_;
                    let _e597 = phi_1010_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e604 = (_e257 % 3u);
                    let _e605 = (_e604 < 3u);
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e607 = local_1[_e604];
                    let _e610 = (_e256 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_1[_e610];
                    let _e616 = (_e258 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    if _e605 {
                    } else {
                        break;
                    }
                    let _e624 = local[_e604];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e628 = local[_e610];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e616];
                    phi_3785_ = false;
                    phi_1107_ = type_41(type_34(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e595), 0u, 0u);
                    phi_1110_ = (_e597 <= _e595);
                    phi_1112_ = type_52(type_29(vec4<f32>((f32(_e607) * _e137), (f32(_e613) * _e137), (f32(_e619) * _e137), 0f), vec4<f32>((f32(_e624) * _e137), (f32(_e628) * _e137), (f32(_e632) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_1114_ = 0u;
                    phi_1116_ = ((3u * _e87) + 1u);
                    loop {
                        let _e640 = phi_3785_;
                        let _e642 = phi_1107_;
                        let _e644 = phi_1110_;
                        let _e646 = phi_1112_;
                        let _e648 = phi_1114_;
                        let _e650 = phi_1116_;
                        local_11 = _e642;
                        local_12 = _e642;
                        if _e644 {
                            phi_1127_ = true;
                        } else {
                            phi_1127_ = (_e648 > 0u);
                        }
                        let _e653 = phi_1127_;
                        if _e653 {
                            let _e654 = (_e650 > 0u);
                            if _e654 {
                                if _e644 {
                                    phi_1213_ = _e644;
                                    phi_1214_ = _e646;
                                    phi_1215_ = _e648;
                                } else {
                                    let _e655 = (_e648 - 1u);
                                    let _e656 = (_e655 % 128u);
                                    let _e657 = (_e656 < 128u);
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e659 = local_7[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e661 = local_6[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e663 = local_5[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e665 = local_4[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e667 = local_3[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e669 = local_2[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e674 = local_8[_e656];
                                    if _e657 {
                                    } else {
                                        phi_3932_ = true;
                                        break;
                                    }
                                    let _e677 = local_9[_e656];
                                    phi_1213_ = (_e677 <= _e642.member.member_1);
                                    phi_1214_ = type_52(type_29(vec4<f32>(_e659, _e661, _e663, 0f), vec4<f32>(_e665, _e667, _e669, 0f)), _e674);
                                    phi_1215_ = _e655;
                                }
                                let _e682 = phi_1213_;
                                let _e684 = phi_1214_;
                                let _e686 = phi_1215_;
                                if _e682 {
                                    if ((_e684.member_1 & 2147483648u) != 0u) {
                                        phi_1233_ = _e642;
                                        phi_1236_ = type_4(0u, ((_e684.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1160 = phi_1233_;
                                            let _e1162 = phi_1236_;
                                            local_10 = _e1160;
                                            local_13 = _e1160;
                                            if (_e1162.member < _e1162.member_1) {
                                                phi_1237_ = type_4((_e1162.member + 1u), _e1162.member_1);
                                                phi_1259_ = type_4(1u, _e1162.member);
                                            } else {
                                                phi_1237_ = _e1162;
                                                phi_1259_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1175 = phi_1237_;
                                            let _e1177 = phi_1259_;
                                            let _e1181 = (bitcast<i32>(_e1177.member) != 0i);
                                            if _e1181 {
                                                let _e1187 = type_41(_e1160.member, _e1160.member_1, (_e1160.member_2 + 1u));
                                                let _e1188 = ((_e684.member_1 & 268435455u) + _e1177.member_1);
                                                let _e1189 = (_e1188 < _e89);
                                                if _e1189 {
                                                    if _e1189 {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1193 = global_2.member[_e1188].member_1;
                                                    phi_1283_ = _e1193;
                                                } else {
                                                    phi_1283_ = 4294967295u;
                                                }
                                                let _e1195 = phi_1283_;
                                                if (_e1188 >= _e89) {
                                                    phi_1375_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1189 {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    if (_e604 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1202 = global_2.member[_e1188].member[_e604];
                                                    if (_e610 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1208 = global_2.member[_e1188].member[_e610];
                                                    if (_e616 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1214 = global_2.member[_e1188].member[_e616];
                                                    let _e1216 = (3u + _e604);
                                                    if (_e1216 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1222 = global_2.member[_e1188].member[_e1216];
                                                    let _e1223 = (3u + _e610);
                                                    if (_e1223 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1229 = global_2.member[_e1188].member[_e1223];
                                                    let _e1230 = (3u + _e616);
                                                    if (_e1230 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1236 = global_2.member[_e1188].member[_e1230];
                                                    let _e1238 = (6u + _e604);
                                                    if (_e1238 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1244 = global_2.member[_e1188].member[_e1238];
                                                    let _e1245 = (6u + _e610);
                                                    if (_e1245 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1251 = global_2.member[_e1188].member[_e1245];
                                                    let _e1252 = (6u + _e616);
                                                    if (_e1252 < 9u) {
                                                    } else {
                                                        phi_3779_ = true;
                                                        break;
                                                    }
                                                    let _e1258 = global_2.member[_e1188].member[_e1252];
                                                    phi_1375_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1202, _e1208, _e1214), array<f32, 3>(_e1222, _e1229, _e1236), array<f32, 3>(_e1244, _e1251, _e1258));
                                                }
                                                let _e1262 = phi_1375_;
                                                let _e1279 = (_e1262[0][2] - _e454);
                                                let _e1282 = (((_e1262[0][0] - _e321) * _e490) - (_e1279 * _e358));
                                                let _e1285 = (((_e1262[0][1] - _e388) * _e490) - (_e1279 * _e424));
                                                let _e1288 = (_e1262[1][2] - _e454);
                                                let _e1291 = (((_e1262[1][0] - _e321) * _e490) - (_e1288 * _e358));
                                                let _e1294 = (((_e1262[1][1] - _e388) * _e490) - (_e1288 * _e424));
                                                let _e1297 = (_e1262[2][2] - _e454);
                                                let _e1300 = (((_e1262[2][0] - _e321) * _e490) - (_e1297 * _e358));
                                                let _e1303 = (((_e1262[2][1] - _e388) * _e490) - (_e1297 * _e424));
                                                let _e1304 = (_e1300 * _e1294);
                                                let _e1305 = (_e1303 * _e1291);
                                                let _e1306 = (_e1282 * _e1303);
                                                let _e1307 = (_e1285 * _e1300);
                                                let _e1308 = (_e1291 * _e1285);
                                                let _e1309 = (_e1294 * _e1282);
                                                let _e1314 = (((_e1304 >= _e1305) && (_e1306 >= _e1307)) && (_e1308 >= _e1309));
                                                let _e1320 = (_e1314 || (((_e1304 <= _e1305) && (_e1306 <= _e1307)) && (_e1308 <= _e1309)));
                                                if _e1320 {
                                                    let _e1322 = select(-1f, 1f, _e1314);
                                                    let _e1324 = ((_e1304 - _e1305) * _e1322);
                                                    let _e1326 = select(0f, _e1324, (_e1324 > 0f));
                                                    let _e1328 = ((_e1306 - _e1307) * _e1322);
                                                    let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                    let _e1332 = ((_e1308 - _e1309) * _e1322);
                                                    let _e1334 = select(0f, _e1332, (_e1332 > 0f));
                                                    let _e1336 = ((_e1326 + _e1330) + _e1334);
                                                    let _e1338 = select(_e1262[1][0], _e1262[0][0], (_e1262[0][0] < _e1262[1][0]));
                                                    let _e1342 = select(_e1262[1][0], _e1262[0][0], (_e1262[0][0] > _e1262[1][0]));
                                                    let _e1346 = select(_e1262[1][1], _e1262[0][1], (_e1262[0][1] < _e1262[1][1]));
                                                    let _e1350 = select(_e1262[1][1], _e1262[0][1], (_e1262[0][1] > _e1262[1][1]));
                                                    let _e1354 = select(_e1262[1][2], _e1262[0][2], (_e1262[0][2] < _e1262[1][2]));
                                                    let _e1358 = select(_e1262[1][2], _e1262[0][2], (_e1262[0][2] > _e1262[1][2]));
                                                    let _e1363 = ((select(_e1262[2][0], _e1338, (_e1338 < _e1262[2][0])) - _e359) * _e362);
                                                    let _e1364 = ((select(_e1262[2][0], _e1342, (_e1342 > _e1262[2][0])) - _e360) * _e362);
                                                    let _e1367 = ((select(_e1262[2][1], _e1346, (_e1346 < _e1262[2][1])) - _e425) * _e428);
                                                    let _e1368 = ((select(_e1262[2][1], _e1350, (_e1350 > _e1262[2][1])) - _e426) * _e428);
                                                    let _e1371 = ((select(_e1262[2][2], _e1354, (_e1354 < _e1262[2][2])) - _e491) * _e494);
                                                    let _e1372 = ((select(_e1262[2][2], _e1358, (_e1358 > _e1262[2][2])) - _e492) * _e494);
                                                    let _e1374 = select(_e1372, _e1371, (_e1371 < _e1372));
                                                    let _e1376 = select(_e1372, _e1371, (_e1371 > _e1372));
                                                    let _e1378 = select(_e1364, _e1363, (_e1363 < _e1364));
                                                    let _e1380 = select(_e1368, _e1367, (_e1367 < _e1368));
                                                    let _e1382 = select(_e1380, _e1378, (_e1378 > _e1380));
                                                    let _e1384 = select(_e1374, _e1382, (_e1382 > _e1374));
                                                    let _e1386 = select(_e1364, _e1363, (_e1363 > _e1364));
                                                    let _e1388 = select(_e1368, _e1367, (_e1367 > _e1368));
                                                    let _e1390 = select(_e1388, _e1386, (_e1386 < _e1388));
                                                    let _e1392 = select(_e1376, _e1390, (_e1390 < _e1376));
                                                    let _e1393 = -(_e1374);
                                                    let _e1399 = select(_e597, _e1384, (_e1384 > _e597));
                                                    let _e1403 = select(_e1291, _e1282, (_e1282 < _e1291));
                                                    let _e1408 = select(_e1291, _e1282, (_e1282 > _e1291));
                                                    let _e1415 = select(_e1294, _e1285, (_e1285 < _e1294));
                                                    let _e1420 = select(_e1294, _e1285, (_e1285 > _e1294));
                                                    let _e1429 = (((((_e1320 && (_e1336 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1300, _e1403, (_e1403 < _e1300)) <= 0f) && (select(_e1300, _e1408, (_e1408 > _e1300)) >= 0f))) && ((select(_e1303, _e1415, (_e1415 < _e1303)) <= 0f) && (select(_e1303, _e1420, (_e1420 > _e1303)) >= 0f))) && (_e1399 <= (_e1392 + (select(_e1393, _e1376, (_e1376 > _e1393)) * 0.0000019073523f)))) && (_e1399 <= _e1160.member.member_1));
                                                    if _e1429 {
                                                        let _e1434 = (_e1262[1][0] - _e1262[0][0]);
                                                        let _e1435 = (_e1262[1][1] - _e1262[0][1]);
                                                        let _e1436 = (_e1262[1][2] - _e1262[0][2]);
                                                        let _e1437 = vec3<f32>(_e1434, _e1435, _e1436);
                                                        let _e1438 = (_e1262[2][0] - _e1262[1][0]);
                                                        let _e1439 = (_e1262[2][1] - _e1262[1][1]);
                                                        let _e1440 = (_e1262[2][2] - _e1262[1][2]);
                                                        let _e1441 = vec3<f32>(_e1438, _e1439, _e1440);
                                                        let _e1442 = (_e1262[0][0] - _e1262[2][0]);
                                                        let _e1443 = (_e1262[0][1] - _e1262[2][1]);
                                                        let _e1444 = (_e1262[0][2] - _e1262[2][2]);
                                                        let _e1445 = vec3<f32>(_e1442, _e1443, _e1444);
                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                        let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                        let _e1456 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                        let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                                                        let _e1461 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                        let _e1464 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                        let _e1466 = select(_e1464, _e1461, (_e1461 > _e1464));
                                                        let _e1469 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                        let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                        let _e1474 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                        let _e1477 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                        let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                        let _e1482 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                        let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                        let _e1486 = select(_e1471, _e1458, (_e1458 > _e1471));
                                                        let _e1488 = select(_e1484, _e1486, (_e1486 > _e1484));
                                                        if (_e1458 == _e1488) {
                                                            phi_1905_ = _e1294;
                                                            phi_1906_ = _e1291;
                                                            phi_1907_ = _e1285;
                                                            phi_1908_ = _e1282;
                                                            phi_1909_ = vec3<f32>(_e1262[0][0], _e1262[0][1], _e1262[0][2]);
                                                            phi_1910_ = _e1445;
                                                            phi_1911_ = _e1441;
                                                            phi_1912_ = _e1437;
                                                        } else {
                                                            let _e1490 = (_e1471 == _e1488);
                                                            let _e1495 = vec3(_e1490);
                                                            phi_1905_ = select(_e1285, _e1303, _e1490);
                                                            phi_1906_ = select(_e1282, _e1300, _e1490);
                                                            phi_1907_ = select(_e1303, _e1294, _e1490);
                                                            phi_1908_ = select(_e1300, _e1291, _e1490);
                                                            phi_1909_ = select(vec3<f32>(_e1262[2][0], _e1262[2][1], _e1262[2][2]), vec3<f32>(_e1262[1][0], _e1262[1][1], _e1262[1][2]), _e1495);
                                                            phi_1910_ = select(_e1441, _e1437, _e1495);
                                                            phi_1911_ = select(_e1437, _e1445, _e1495);
                                                            phi_1912_ = select(_e1445, _e1441, _e1495);
                                                        }
                                                        let _e1501 = phi_1905_;
                                                        let _e1503 = phi_1906_;
                                                        let _e1505 = phi_1907_;
                                                        let _e1507 = phi_1908_;
                                                        let _e1509 = phi_1909_;
                                                        let _e1511 = phi_1910_;
                                                        let _e1513 = phi_1911_;
                                                        let _e1515 = phi_1912_;
                                                        let _e1522 = ((_e1513.y * _e1511.z) - (_e1511.y * _e1513.z));
                                                        let _e1527 = ((_e1513.z * _e1511.x) - (_e1511.z * _e1513.x));
                                                        let _e1530 = ((_e1513.x * _e1511.y) - (_e1511.x * _e1513.y));
                                                        let _e1533 = ((_e1326 >= _e1330) && (_e1326 >= _e1334));
                                                        let _e1534 = (_e1330 >= _e1334);
                                                        let _e1548 = (((_e1522 * (select(select(_e1262[2][0], _e1262[1][0], _e1534), _e1262[0][0], _e1533) - _e321)) + (_e1527 * (select(select(_e1262[2][1], _e1262[1][1], _e1534), _e1262[0][1], _e1533) - _e388))) + (_e1530 * (select(select(_e1262[2][2], _e1262[1][2], _e1534), _e1262[0][2], _e1533) - _e454)));
                                                        let _e1553 = (((_e1522 * _e358) + (_e1527 * _e424)) + (_e1530 * _e490));
                                                        let _e1554 = (_e1503 - _e1507);
                                                        let _e1555 = (_e1501 - _e1505);
                                                        let _e1558 = ((_e1554 * _e1554) + (_e1555 * _e1555));
                                                        let _e1565 = (-(((_e1507 * _e1554) + (_e1505 * _e1555))) / select(0.000000000000000000000000000000000000011754944f, _e1558, (_e1558 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1567 = select(1f, _e1565, (_e1565 < 1f));
                                                        let _e1569 = select(0f, _e1567, (_e1567 > 0f));
                                                        let _e1578 = ((_e1509.x + (_e1515.x * _e1569)) - _e321);
                                                        let _e1581 = ((_e1509.y + (_e1515.y * _e1569)) - _e388);
                                                        let _e1584 = ((_e1509.z + (_e1515.z * _e1569)) - _e454);
                                                        let _e1587 = bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u));
                                                        let _e1590 = bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u));
                                                        let _e1592 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                        let _e1595 = bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u));
                                                        let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                        let _e1603 = bitcast<f32>((bitcast<u32>(_e1522) & 2147483647u));
                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u));
                                                        let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                        let _e1611 = bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u));
                                                        let _e1630 = bitcast<f32>((bitcast<u32>(_e1513.x) & 2147483647u));
                                                        let _e1633 = bitcast<f32>((bitcast<u32>(_e1513.y) & 2147483647u));
                                                        let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                        let _e1638 = bitcast<f32>((bitcast<u32>(_e1513.z) & 2147483647u));
                                                        let _e1644 = bitcast<f32>((bitcast<u32>(_e1511.x) & 2147483647u));
                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1511.y) & 2147483647u));
                                                        let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                        let _e1652 = bitcast<f32>((bitcast<u32>(_e1511.z) & 2147483647u));
                                                        let _e1658 = ((bitcast<f32>((bitcast<u32>(((((_e1522 * _e1578) + (_e1527 * _e1581)) + (_e1530 * _e1584)) - _e1548)) & 2147483647u)) <= ((0.0000009536743f * select(_e1488, _e1597, (_e1597 > _e1488))) * select(_e1611, _e1608, (_e1608 > _e1611)))) && !((bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u)) <= ((0.0000038146973f * select(_e1638, _e1635, (_e1635 > _e1638))) * select(_e1652, _e1649, (_e1649 > _e1652))))));
                                                        let _e1659 = (_e1548 / _e1553);
                                                        if (_e1429 && !(_e1658)) {
                                                            let _e1662 = (_e1584 / _e490);
                                                            let _e1670 = (((_e1522 * (_e1578 - (_e358 * _e1662))) + (_e1527 * (_e1581 - (_e424 * _e1662)))) / _e1553);
                                                            phi_2103_ = select(select(_e1662, (_e1662 + _e1670), (bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u)) <= _e1488)), _e1659, _e1658);
                                                        } else {
                                                            phi_2103_ = _e1659;
                                                        }
                                                        let _e1679 = phi_2103_;
                                                        let _e1681 = select(_e1392, _e1679, (_e1679 < _e1392));
                                                        let _e1683 = select(_e1384, _e1681, (_e1681 > _e1384));
                                                        let _e1684 = (1f / _e1336);
                                                        phi_2123_ = type_37(_e1683, (_e1330 * _e1684), (_e1334 * _e1684), ((_e1429 && (_e1683 >= _e597)) && (_e1683 <= _e1160.member.member_1)));
                                                        phi_2124_ = type_37();
                                                    } else {
                                                        phi_2123_ = type_37();
                                                        phi_2124_ = type_37(0f, 0f, 0f, _e1429);
                                                    }
                                                    let _e1693 = phi_2123_;
                                                    let _e1695 = phi_2124_;
                                                    phi_2127_ = _e1693;
                                                    phi_2128_ = _e1695;
                                                    phi_2129_ = select(true, false, _e1429);
                                                } else {
                                                    phi_2127_ = type_37();
                                                    phi_2128_ = type_37(0f, 0f, 0f, _e1320);
                                                    phi_2129_ = true;
                                                }
                                                let _e1698 = phi_2127_;
                                                let _e1700 = phi_2128_;
                                                let _e1702 = phi_2129_;
                                                if _e1702 {
                                                    phi_2133_ = _e1700;
                                                } else {
                                                    phi_2133_ = _e1698;
                                                }
                                                let _e1704 = phi_2133_;
                                                if _e1704.member_3 {
                                                    phi_2142_ = type_25(_e1704.member, _e1704.member_1, _e1704.member_2, _e1195);
                                                } else {
                                                    phi_2142_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1711 = phi_2142_;
                                                if (_e1711.member_3 != 4294967295u) {
                                                    if (_e1195 != 4294967295u) {
                                                        if (_e1711.member < _e1160.member.member.member) {
                                                            phi_2168_ = true;
                                                        } else {
                                                            if (_e1711.member == _e1160.member.member.member) {
                                                                phi_2167_ = (_e1711.member_3 < _e1160.member.member.member_3);
                                                            } else {
                                                                phi_2167_ = false;
                                                            }
                                                            let _e1726 = phi_2167_;
                                                            phi_2168_ = _e1726;
                                                        }
                                                        let _e1728 = phi_2168_;
                                                        if _e1728 {
                                                            phi_2175_ = type_41(type_34(_e1711, _e1711.member), _e1187.member_1, _e1187.member_2);
                                                        } else {
                                                            phi_2175_ = _e1187;
                                                        }
                                                        let _e1735 = phi_2175_;
                                                        phi_2176_ = _e1735;
                                                    } else {
                                                        phi_2176_ = _e1187;
                                                    }
                                                    let _e1737 = phi_2176_;
                                                    phi_2177_ = _e1737;
                                                } else {
                                                    phi_2177_ = _e1187;
                                                }
                                                let _e1739 = phi_2177_;
                                                phi_1234_ = _e1739;
                                            } else {
                                                phi_1234_ = type_41();
                                            }
                                            let _e1741 = phi_1234_;
                                            continue;
                                            continuing {
                                                phi_1233_ = _e1741;
                                                phi_1236_ = _e1175;
                                                phi_3779_ = _e640;
                                                break if !(_e1181);
                                            }
                                        }
                                        let _e1744 = phi_3779_;
                                        phi_3932_ = _e1744;
                                        if _e1744 {
                                            break;
                                        }
                                        let _e1746 = local_10;
                                        phi_3936_ = _e1744;
                                        let _e1904 = local_13;
                                        phi_3407_ = _e1904;
                                        phi_3408_ = false;
                                        phi_3409_ = _e684;
                                        phi_3410_ = select(_e686, 0u, (_e597 > _e1746.member.member_1));
                                    } else {
                                        if (_e684.member_1 >= _e87) {
                                            phi_2943_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e684.member_1 < _e87) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e697 = (_e257 * 2u);
                                            let _e699 = ((1u + _e697) % 7u);
                                            if (_e699 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e704 = global_5.member[_e684.member_1][_e699];
                                            let _e706 = ((_e697 + 2u) % 7u);
                                            if (_e706 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e711 = global_5.member[_e684.member_1][_e706];
                                            let _e712 = (_e256 * 2u);
                                            let _e714 = ((1u + _e712) % 7u);
                                            if (_e714 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e719 = global_5.member[_e684.member_1][_e714];
                                            let _e721 = ((_e712 + 2u) % 7u);
                                            if (_e721 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e726 = global_5.member[_e684.member_1][_e721];
                                            let _e727 = (_e258 * 2u);
                                            let _e729 = ((1u + _e727) % 7u);
                                            if (_e729 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e734 = global_5.member[_e684.member_1][_e729];
                                            let _e736 = ((_e727 + 2u) % 7u);
                                            if (_e736 < 7u) {
                                            } else {
                                                phi_3932_ = true;
                                                break;
                                            }
                                            let _e741 = global_5.member[_e684.member_1][_e736];
                                            let _e764 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.x - _e684.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e765 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.y - _e684.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e766 = (bitcast<f32>((bitcast<u32>((_e684.member.member_1.z - _e684.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e768 = select(_e137, _e764, (_e764 > _e137));
                                            let _e770 = select(_e137, _e765, (_e765 > _e137));
                                            let _e772 = select(_e137, _e766, (_e766 > _e137));
                                            let _e803 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e704 & 2097151u))) - 8388608f) * _e768));
                                            let _e808 = (bitcast<i32>((_e704 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e811 = bitcast<f32>((_e803 & bitcast<u32>(_e808)));
                                            let _e812 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 2097151u))) - 8388608f) * _e770));
                                            let _e817 = (bitcast<i32>((_e719 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e820 = bitcast<f32>((_e812 & bitcast<u32>(_e817)));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 2097151u))) - 8388608f) * _e772));
                                            let _e826 = (bitcast<i32>((_e734 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e833 = bitcast<f32>((_e803 & bitcast<u32>(~(_e808))));
                                            let _e837 = bitcast<f32>((_e812 & bitcast<u32>(~(_e817))));
                                            let _e841 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e842 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e711 & 2097151u))) - 8388608f) * _e768));
                                            let _e847 = (bitcast<i32>((_e711 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e850 = bitcast<f32>((_e842 & bitcast<u32>(_e847)));
                                            let _e851 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 2097151u))) - 8388608f) * _e770));
                                            let _e856 = (bitcast<i32>((_e726 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e859 = bitcast<f32>((_e851 & bitcast<u32>(_e856)));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 2097151u))) - 8388608f) * _e772));
                                            let _e865 = (bitcast<i32>((_e741 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e872 = bitcast<f32>((_e842 & bitcast<u32>(~(_e847))));
                                            let _e876 = bitcast<f32>((_e851 & bitcast<u32>(~(_e856))));
                                            let _e880 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e910 = global_5.member[_e684.member_1][0u];
                                            let _e914 = global_5.member[_e684.member_1][2u];
                                            let _e918 = global_5.member[_e684.member_1][4u];
                                            let _e922 = global_5.member[_e684.member_1][6u];
                                            let _e934 = (((_e914 >> bitcast<u32>(22i)) | ((_e918 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e922 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e935 = (_e910 & 268435455u);
                                            let _e936 = (_e934 & 268435455u);
                                            let _e939 = ((_e910 >> bitcast<u32>(28u)) & 7u);
                                            let _e947 = ((_e910 >> bitcast<u32>(31i)) | (((_e934 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e948 = (_e939 != 0u);
                                            if (_e939 == 0u) {
                                                phi_2905_ = _e935;
                                            } else {
                                                if (_e939 == 7u) {
                                                    phi_2904_ = 2147483648u;
                                                } else {
                                                    phi_2904_ = ((2147483648u | (_e939 << bitcast<u32>(28u))) | (_e936 & 268435455u));
                                                }
                                                let _e957 = phi_2904_;
                                                phi_2905_ = _e957;
                                            }
                                            let _e959 = phi_2905_;
                                            if _e948 {
                                                let _e960 = (_e939 != 7u);
                                                if _e960 {
                                                    phi_2915_ = (_e936 + _e939);
                                                } else {
                                                    phi_2915_ = u32();
                                                }
                                                let _e963 = phi_2915_;
                                                phi_2917_ = _e963;
                                                phi_2918_ = select(true, false, _e960);
                                            } else {
                                                phi_2917_ = u32();
                                                phi_2918_ = true;
                                            }
                                            let _e966 = phi_2917_;
                                            let _e968 = phi_2918_;
                                            if (_e947 == 0u) {
                                                phi_2939_ = (_e935 + select(0u, 1u, !(_e948)));
                                            } else {
                                                if (_e947 == 7u) {
                                                    phi_2938_ = 2147483648u;
                                                } else {
                                                    phi_2938_ = ((2147483648u | (_e947 << bitcast<u32>(28u))) | (select(_e966, _e936, _e968) & 268435455u));
                                                }
                                                let _e981 = phi_2938_;
                                                phi_2939_ = _e981;
                                            }
                                            let _e983 = phi_2939_;
                                            phi_2943_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e684.member.member.x + _e811), (_e684.member.member.x + _e833), (_e684.member.member_1.x - _e850), (_e684.member.member_1.x - _e872)), vec4<f32>((_e684.member.member.y + _e820), (_e684.member.member.y + _e837), (_e684.member.member_1.y - _e859), (_e684.member.member_1.y - _e876)), vec4<f32>((_e684.member.member.z + _e829), (_e684.member.member.z + _e841), (_e684.member.member_1.z - _e868), (_e684.member.member_1.z - _e880))), type_52(type_29((_e684.member.member + vec4<f32>(_e811, _e820, _e829, 0f)), (_e684.member.member_1 - vec4<f32>(_e850, _e859, _e868, 0f))), _e959), type_52(type_29((_e684.member.member + vec4<f32>(_e833, _e837, _e841, 0f)), (_e684.member.member_1 - vec4<f32>(_e872, _e876, _e880, 0f))), _e983));
                                        }
                                        let _e988 = phi_2943_;
                                        let _e1007 = ((_e988.member[0].x - _e359) * _e362);
                                        let _e1008 = ((_e988.member[0].y - _e359) * _e362);
                                        let _e1009 = ((_e988.member[0].z - _e360) * _e362);
                                        let _e1010 = ((_e988.member[0].w - _e360) * _e362);
                                        let _e1020 = ((_e988.member[1].x - _e425) * _e428);
                                        let _e1021 = ((_e988.member[1].y - _e425) * _e428);
                                        let _e1022 = ((_e988.member[1].z - _e426) * _e428);
                                        let _e1023 = ((_e988.member[1].w - _e426) * _e428);
                                        let _e1033 = ((_e988.member[2].x - _e491) * _e494);
                                        let _e1034 = ((_e988.member[2].y - _e491) * _e494);
                                        let _e1035 = ((_e988.member[2].z - _e492) * _e494);
                                        let _e1036 = ((_e988.member[2].w - _e492) * _e494);
                                        let _e1038 = select(_e1035, _e1033, (_e1033 < _e1035));
                                        let _e1040 = select(_e1036, _e1034, (_e1034 < _e1036));
                                        let _e1042 = select(_e1035, _e1033, (_e1033 > _e1035));
                                        let _e1044 = select(_e1036, _e1034, (_e1034 > _e1036));
                                        let _e1046 = select(_e1009, _e1007, (_e1007 < _e1009));
                                        let _e1048 = select(_e1010, _e1008, (_e1008 < _e1010));
                                        let _e1050 = select(_e1022, _e1020, (_e1020 < _e1022));
                                        let _e1052 = select(_e1023, _e1021, (_e1021 < _e1023));
                                        let _e1054 = select(_e1050, _e1046, (_e1046 > _e1050));
                                        let _e1056 = select(_e1052, _e1048, (_e1048 > _e1052));
                                        let _e1058 = select(_e1038, _e1054, (_e1054 > _e1038));
                                        let _e1060 = select(_e1040, _e1056, (_e1056 > _e1040));
                                        let _e1062 = select(_e1009, _e1007, (_e1007 > _e1009));
                                        let _e1064 = select(_e1010, _e1008, (_e1008 > _e1010));
                                        let _e1066 = select(_e1022, _e1020, (_e1020 > _e1022));
                                        let _e1068 = select(_e1023, _e1021, (_e1021 > _e1023));
                                        let _e1070 = select(_e1066, _e1062, (_e1062 < _e1066));
                                        let _e1072 = select(_e1068, _e1064, (_e1064 < _e1068));
                                        let _e1077 = -(_e1038);
                                        let _e1078 = -(_e1040);
                                        let _e1085 = (select(_e1042, _e1070, (_e1070 < _e1042)) + (select(_e1077, _e1042, (_e1042 > _e1077)) * 0.0000019073523f));
                                        let _e1086 = (select(_e1044, _e1072, (_e1072 < _e1044)) + (select(_e1078, _e1044, (_e1044 > _e1078)) * 0.0000019073523f));
                                        let _e1088 = select(_e597, _e1058, (_e1058 > _e597));
                                        let _e1090 = select(_e597, _e1060, (_e1060 > _e597));
                                        let _e1095 = (_e1088 <= select(_e642.member.member_1, _e1085, (_e1085 < _e642.member.member_1)));
                                        let _e1096 = (_e1090 <= select(_e642.member.member_1, _e1086, (_e1086 < _e642.member.member_1)));
                                        let _e1097 = (_e1088 <= _e1090);
                                        if _e1095 {
                                            if _e1096 {
                                                if _e1097 {
                                                    phi_3308_ = _e988.member_2;
                                                } else {
                                                    phi_3308_ = _e988.member_1;
                                                }
                                                let _e1101 = phi_3308_;
                                                let _e1122 = (_e686 % 128u);
                                                let _e1123 = (_e1122 < 128u);
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_8[_e1122] = _e1101.member_1;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_7[_e1122] = _e1101.member.member.x;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_6[_e1122] = _e1101.member.member.y;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_5[_e1122] = _e1101.member.member.z;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_4[_e1122] = _e1101.member.member_1.x;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_3[_e1122] = _e1101.member.member_1.y;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_2[_e1122] = _e1101.member.member_1.z;
                                                if _e1123 {
                                                } else {
                                                    phi_3932_ = true;
                                                    break;
                                                }
                                                local_9[_e1122] = select(_e1088, _e1090, _e1097);
                                                if _e1097 {
                                                    phi_3384_ = _e988.member_1;
                                                } else {
                                                    phi_3384_ = _e988.member_2;
                                                }
                                                let _e1136 = phi_3384_;
                                                phi_3385_ = _e1136;
                                                phi_3386_ = (_e686 + 1u);
                                            } else {
                                                phi_3385_ = type_52();
                                                phi_3386_ = u32();
                                            }
                                            let _e1138 = phi_3385_;
                                            let _e1140 = phi_3386_;
                                            phi_3388_ = _e1138;
                                            phi_3389_ = _e1140;
                                            phi_3390_ = select(true, false, _e1096);
                                        } else {
                                            phi_3388_ = type_52();
                                            phi_3389_ = u32();
                                            phi_3390_ = true;
                                        }
                                        let _e1143 = phi_3388_;
                                        let _e1145 = phi_3389_;
                                        let _e1147 = phi_3390_;
                                        if _e1147 {
                                            if _e1095 {
                                                phi_3399_ = _e988.member_1;
                                            } else {
                                                phi_3399_ = _e988.member_2;
                                            }
                                            let _e1151 = phi_3399_;
                                            phi_3404_ = select(_e1096, true, _e1095);
                                            phi_3405_ = _e1151;
                                        } else {
                                            phi_3404_ = _e682;
                                            phi_3405_ = _e1143;
                                        }
                                        let _e1154 = phi_3404_;
                                        let _e1156 = phi_3405_;
                                        phi_3936_ = _e640;
                                        phi_3407_ = type_41(_e642.member, (_e642.member_1 + 1u), _e642.member_2);
                                        phi_3408_ = _e1154;
                                        phi_3409_ = _e1156;
                                        phi_3410_ = select(_e1145, _e686, _e1147);
                                    }
                                    let _e1752 = phi_3936_;
                                    let _e1754 = phi_3407_;
                                    let _e1756 = phi_3408_;
                                    let _e1758 = phi_3409_;
                                    let _e1760 = phi_3410_;
                                    phi_3935_ = _e1752;
                                    phi_3411_ = _e1754;
                                    phi_3412_ = _e1756;
                                    phi_3413_ = _e1758;
                                    phi_3414_ = _e1760;
                                    phi_3415_ = (_e650 - 1u);
                                } else {
                                    phi_3935_ = _e640;
                                    phi_3411_ = _e642;
                                    phi_3412_ = _e682;
                                    phi_3413_ = _e684;
                                    phi_3414_ = _e686;
                                    phi_3415_ = _e650;
                                }
                                let _e1762 = phi_3935_;
                                let _e1764 = phi_3411_;
                                let _e1766 = phi_3412_;
                                let _e1768 = phi_3413_;
                                let _e1770 = phi_3414_;
                                let _e1772 = phi_3415_;
                                phi_3934_ = _e1762;
                                phi_3416_ = _e1764;
                                phi_3417_ = _e1766;
                                phi_3418_ = _e1768;
                                phi_3419_ = _e1770;
                                phi_3420_ = _e1772;
                            } else {
                                phi_3934_ = _e640;
                                phi_3416_ = type_41();
                                phi_3417_ = bool();
                                phi_3418_ = type_52();
                                phi_3419_ = u32();
                                phi_3420_ = u32();
                            }
                            let _e1774 = phi_3934_;
                            let _e1776 = phi_3416_;
                            let _e1778 = phi_3417_;
                            let _e1780 = phi_3418_;
                            let _e1782 = phi_3419_;
                            let _e1784 = phi_3420_;
                            phi_3933_ = _e1774;
                            phi_1108_ = _e1776;
                            phi_1111_ = _e1778;
                            phi_1113_ = _e1780;
                            phi_1115_ = _e1782;
                            phi_1117_ = _e1784;
                            phi_3421_ = _e654;
                        } else {
                            phi_3933_ = _e640;
                            phi_1108_ = type_41();
                            phi_1111_ = bool();
                            phi_1113_ = type_52();
                            phi_1115_ = u32();
                            phi_1117_ = u32();
                            phi_3421_ = false;
                        }
                        let _e1786 = phi_3933_;
                        let _e1788 = phi_1108_;
                        let _e1790 = phi_1111_;
                        let _e1792 = phi_1113_;
                        let _e1794 = phi_1115_;
                        let _e1796 = phi_1117_;
                        let _e1798 = phi_3421_;
                        continue;
                        continuing {
                            phi_3785_ = _e1786;
                            phi_1107_ = _e1788;
                            phi_1110_ = _e1790;
                            phi_1112_ = _e1792;
                            phi_1114_ = _e1794;
                            phi_1116_ = _e1796;
                            phi_3932_ = _e1786;
                            break if !(_e1798);
                        }
                    }
                    let _e1801 = phi_3932_;
                    if _e1801 {
                        break;
                    }
                    let _e1803 = local_11;
                    let _e1806 = local_12;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143][0u] = _e1803.member_1;
                    global_6.member[_e143][1u] = _e1806.member_2;
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
