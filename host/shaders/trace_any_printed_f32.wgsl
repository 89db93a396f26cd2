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

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
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

struct type_34 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_44;

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
    var phi_367_: i32;
    var phi_368_: i32;
    var phi_378_: bool;
    var phi_388_: u32;
    var phi_389_: u32;
    var phi_391_: bool;
    var phi_396_: u32;
    var phi_409_: i32;
    var phi_429_: i32;
    var phi_447_: f32;
    var phi_453_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_868_: i32;
    var phi_890_: u32;
    var phi_891_: u32;
    var phi_928_: i32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_3307_: bool;
    var phi_1043_: type_38;
    var phi_1046_: bool;
    var phi_1048_: type_49;
    var phi_1050_: u32;
    var phi_1052_: u32;
    var phi_1063_: bool;
    var phi_1149_: bool;
    var phi_1150_: type_49;
    var phi_1151_: u32;
    var phi_2108_: type_42;
    var phi_2994_: type_49;
    var phi_3070_: type_49;
    var phi_3071_: type_49;
    var phi_3072_: u32;
    var phi_3074_: type_49;
    var phi_3075_: u32;
    var phi_3076_: bool;
    var phi_3083_: type_49;
    var phi_3088_: bool;
    var phi_3089_: type_49;
    var phi_1169_: type_38;
    var phi_1172_: type_7;
    var phi_1173_: type_7;
    var phi_1195_: type_7;
    var phi_1216_: u32;
    var phi_1308_: array<array<f32, 3>, 3>;
    var phi_1838_: f32;
    var phi_1839_: f32;
    var phi_1840_: f32;
    var phi_1841_: f32;
    var phi_1842_: vec3<f32>;
    var phi_1843_: vec3<f32>;
    var phi_1844_: vec3<f32>;
    var phi_1845_: vec3<f32>;
    var phi_2036_: f32;
    var phi_2056_: type_34;
    var phi_2057_: type_34;
    var phi_2060_: type_34;
    var phi_2061_: type_34;
    var phi_2062_: bool;
    var phi_2066_: type_34;
    var phi_2075_: type_25;
    var phi_2086_: type_38;
    var phi_2087_: type_38;
    var phi_1170_: type_38;
    var phi_3301_: bool;
    var local_10: type_38;
    var phi_3455_: bool;
    var phi_3091_: type_38;
    var phi_3092_: bool;
    var phi_3093_: type_49;
    var phi_3094_: u32;
    var phi_3454_: bool;
    var phi_3095_: type_38;
    var phi_3096_: bool;
    var phi_3097_: type_49;
    var phi_3098_: u32;
    var phi_3099_: u32;
    var phi_3453_: bool;
    var phi_3100_: type_38;
    var phi_3101_: bool;
    var phi_3102_: type_49;
    var phi_3103_: u32;
    var phi_3104_: u32;
    var phi_3452_: bool;
    var phi_1044_: type_38;
    var phi_1047_: bool;
    var phi_1049_: type_49;
    var phi_1051_: u32;
    var phi_1053_: u32;
    var phi_3105_: bool;
    var phi_3451_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e85 = arrayLength((&global_6.member));
            let _e87 = arrayLength((&global_2.member));
            let _e95 = global_3.member[0u][0u];
            let _e99 = global_3.member[0u][1u];
            let _e103 = global_3.member[0u][2u];
            let _e107 = global_3.member[1u][0u];
            let _e111 = global_3.member[1u][1u];
            let _e115 = global_3.member[1u][2u];
            let _e119 = global_3.member[1u][3u];
            let _e122 = global_1.member[0u];
            let _e123 = bitcast<i32>(_e122);
            let _e133 = (_e82.x + (_e82.y * 2097152u));
            let _e134 = (_e133 < arrayLength((&global_4.member)));
            if _e134 {
                let _e135 = (_e133 < arrayLength((&global_5.member)));
                if _e135 {
                    if _e134 {
                    } else {
                        break;
                    }
                    let _e143 = global_4.member[_e133].member_2[0u];
                    let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                    let _e150 = global_4.member[_e133].member_2[1u];
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e157 = global_4.member[_e133].member_2[2u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_4.member[_e133].member[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e133].member[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e133].member[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e182 = select(_e152, _e145, (_e152 < _e145));
                    let _e184 = select(_e159, _e182, (_e159 < _e182));
                    let _e186 = select(_e166, _e184, (_e166 < _e184));
                    let _e188 = select(_e173, _e186, (_e173 < _e186));
                    let _e190 = select(_e180, _e188, (_e180 < _e188));
                    let _e194 = global_4.member[_e133].member_1;
                    let _e195 = bitcast<u32>(_e194);
                    let _e196 = (_e195 & 2147483647u);
                    let _e203 = global_4.member[_e133].member_3;
                    let _e204 = bitcast<u32>(_e203);
                    let _e205 = (_e204 & 2147483647u);
                    let _e209 = (((select(_e196, _e190, (_e196 < _e190)) < 2139095040u) && (_e205 <= 2139095040u)) && (_e184 > 0u));
                    if _e209 {
                        let _e212 = (bitcast<u32>(bitcast<f32>(_e184)) & 2147483647u);
                        if (_e212 >= 8388608u) {
                            phi_367_ = (bitcast<i32>((_e212 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_367_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e212)), 32u, (_e212 == 0u))));
                        }
                        let _e226 = phi_367_;
                        phi_368_ = _e226;
                    } else {
                        phi_368_ = 0i;
                    }
                    let _e228 = phi_368_;
                    let _e229 = (_e145 == _e184);
                    if _e229 {
                        phi_378_ = true;
                    } else {
                        phi_378_ = (_e152 == _e184);
                    }
                    let _e232 = phi_378_;
                    let _e233 = select(1u, 0u, _e229);
                    if _e232 {
                        let _e234 = (_e233 + 1u);
                        phi_388_ = _e234;
                        phi_389_ = _e234;
                        phi_391_ = select(true, false, (_e234 == 2u));
                    } else {
                        phi_388_ = u32();
                        phi_389_ = 0u;
                        phi_391_ = true;
                    }
                    let _e238 = phi_388_;
                    let _e240 = phi_389_;
                    let _e242 = phi_391_;
                    if _e242 {
                        phi_396_ = (_e240 + 1u);
                    } else {
                        phi_396_ = 0u;
                    }
                    let _e246 = phi_396_;
                    let _e247 = select(_e238, _e240, _e242);
                    let _e248 = select(_e233, select(2u, _e233, _e232), _e242);
                    if (_e123 < -126i) {
                        phi_409_ = -126i;
                    } else {
                        phi_409_ = select(_e123, 127i, (_e123 > 127i));
                    }
                    let _e253 = phi_409_;
                    let _e258 = bitcast<f32>((bitcast<u32>((_e253 + 127i)) << bitcast<u32>(23i)));
                    let _e264 = bitcast<f32>((bitcast<u32>(((_e123 - _e253) + 127i)) << bitcast<u32>(23i)));
                    let _e265 = -(_e228);
                    if (_e265 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e265, 127i, (_e265 > 127i));
                    }
                    let _e270 = phi_429_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e265 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = global_4.member[_e133].member;
                    let _e286 = (_e247 == 0u);
                    if _e286 {
                        phi_447_ = _e285[0];
                    } else {
                        phi_447_ = _e285[1];
                    }
                    let _e290 = phi_447_;
                    let _e291 = (_e247 == 2u);
                    if _e291 {
                        phi_453_ = _e285[2];
                    } else {
                        phi_453_ = _e290;
                    }
                    let _e294 = phi_453_;
                    let _e295 = bitcast<u32>(_e294);
                    let _e297 = ((_e295 & 2139095040u) != 0u);
                    let _e311 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * _e258) * select(0.00000011920929f, 1f, _e297)) * _e264);
                    let _e312 = global_4.member[_e133].member_2;
                    if _e286 {
                        phi_493_ = _e312[0];
                    } else {
                        phi_493_ = _e312[1];
                    }
                    let _e316 = phi_493_;
                    if _e291 {
                        phi_499_ = _e312[2];
                    } else {
                        phi_499_ = _e316;
                    }
                    let _e319 = phi_499_;
                    let _e320 = bitcast<u32>(_e319);
                    let _e322 = ((_e320 & 2139095040u) != 0u);
                    let _e336 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e319, _e322) * _e275) * select(0.00000011920929f, 1f, _e322)) * _e281);
                    let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e343 = bitcast<f32>((bitcast<u32>(_e311) & 2147483647u));
                    let _e344 = (_e343 * 0.00000011920929f);
                    let _e347 = select(select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f)), 0f, _e340);
                    let _e348 = select(0f, _e336, _e340);
                    let _e349 = (_e311 + _e347);
                    let _e350 = (_e311 - _e347);
                    let _e352 = select(38685626000000000000000000f, (1f / _e336), _e340);
                    let _e353 = (_e246 == 0u);
                    if _e353 {
                        phi_572_ = _e285[0];
                    } else {
                        phi_572_ = _e285[1];
                    }
                    let _e357 = phi_572_;
                    let _e358 = (_e246 == 2u);
                    if _e358 {
                        phi_578_ = _e285[2];
                    } else {
                        phi_578_ = _e357;
                    }
                    let _e361 = phi_578_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e258) * select(0.00000011920929f, 1f, _e364)) * _e264);
                    if _e353 {
                        phi_618_ = _e312[0];
                    } else {
                        phi_618_ = _e312[1];
                    }
                    let _e382 = phi_618_;
                    if _e358 {
                        phi_624_ = _e312[2];
                    } else {
                        phi_624_ = _e382;
                    }
                    let _e385 = phi_624_;
                    let _e386 = bitcast<u32>(_e385);
                    let _e388 = ((_e386 & 2139095040u) != 0u);
                    let _e402 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e386 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e386 & 2147483648u))), _e385, _e388) * _e275) * select(0.00000011920929f, 1f, _e388)) * _e281);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e409 = bitcast<f32>((bitcast<u32>(_e378) & 2147483647u));
                    let _e410 = (_e409 * 0.00000011920929f);
                    let _e413 = select(select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f)), 0f, _e406);
                    let _e414 = select(0f, _e402, _e406);
                    let _e415 = (_e378 + _e413);
                    let _e416 = (_e378 - _e413);
                    let _e418 = select(38685626000000000000000000f, (1f / _e402), _e406);
                    let _e419 = (_e248 == 0u);
                    if _e419 {
                        phi_697_ = _e285[0];
                    } else {
                        phi_697_ = _e285[1];
                    }
                    let _e423 = phi_697_;
                    let _e424 = (_e248 == 2u);
                    if _e424 {
                        phi_703_ = _e285[2];
                    } else {
                        phi_703_ = _e423;
                    }
                    let _e427 = phi_703_;
                    let _e428 = bitcast<u32>(_e427);
                    let _e430 = ((_e428 & 2139095040u) != 0u);
                    let _e444 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e428 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e428 & 2147483648u))), _e427, _e430) * _e258) * select(0.00000011920929f, 1f, _e430)) * _e264);
                    if _e419 {
                        phi_743_ = _e312[0];
                    } else {
                        phi_743_ = _e312[1];
                    }
                    let _e448 = phi_743_;
                    if _e424 {
                        phi_749_ = _e312[2];
                    } else {
                        phi_749_ = _e448;
                    }
                    let _e451 = phi_749_;
                    let _e452 = bitcast<u32>(_e451);
                    let _e454 = ((_e452 & 2139095040u) != 0u);
                    let _e468 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e452 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e452 & 2147483648u))), _e451, _e454) * _e275) * select(0.00000011920929f, 1f, _e454)) * _e281);
                    let _e472 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e475 = bitcast<f32>((bitcast<u32>(_e444) & 2147483647u));
                    let _e476 = (_e475 * 0.00000011920929f);
                    let _e479 = select(select(0.00000000000011368684f, _e476, (_e476 > 0.00000000000011368684f)), 0f, _e472);
                    let _e480 = select(0f, _e468, _e472);
                    let _e481 = (_e444 + _e479);
                    let _e482 = (_e444 - _e479);
                    let _e484 = select(38685626000000000000000000f, (1f / _e468), _e472);
                    let _e486 = select(_e409, _e343, (_e343 > _e409));
                    let _e489 = (_e123 + _e228);
                    if (_e209 && (select(_e475, _e486, (_e486 > _e475)) <= 1099511600000f)) {
                        let _e499 = ((_e196 & 8388607u) | (select(0u, 1u, ((_e196 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e502 = bitcast<i32>((_e196 >> bitcast<u32>(23i)));
                        let _e506 = (_e499 == 0u);
                        let _e509 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e499)), 32u, _e506)) - 8i);
                        if (_e502 == 255i) {
                            phi_868_ = 255i;
                        } else {
                            phi_868_ = (((_e502 + select(0i, 1i, (_e502 == 0i))) - _e509) + _e489);
                        }
                        let _e517 = phi_868_;
                        let _e527 = (_e517 <= 0i);
                        if _e527 {
                            phi_891_ = u32();
                        } else {
                            if _e506 {
                                phi_890_ = u32();
                            } else {
                                phi_890_ = select(((bitcast<u32>(_e517) << bitcast<u32>(23i)) | ((_e499 << bitcast<u32>(((_e509 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e517 >= 255i));
                            }
                            let _e531 = phi_890_;
                            phi_891_ = _e531;
                        }
                        let _e533 = phi_891_;
                        let _e545 = ((_e205 & 8388607u) | (select(0u, 1u, ((_e205 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e548 = bitcast<i32>((_e205 >> bitcast<u32>(23i)));
                        let _e552 = (_e545 == 0u);
                        let _e555 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e545)), 32u, _e552)) - 8i);
                        if (_e548 == 255i) {
                            phi_928_ = 255i;
                        } else {
                            phi_928_ = (((_e548 + select(0i, 1i, (_e548 == 0i))) - _e555) + _e489);
                        }
                        let _e563 = phi_928_;
                        let _e573 = (_e563 <= 0i);
                        if _e573 {
                            phi_951_ = u32();
                        } else {
                            if _e552 {
                                phi_950_ = u32();
                            } else {
                                phi_950_ = select(((bitcast<u32>(_e563) << bitcast<u32>(23i)) | ((_e545 << bitcast<u32>(((_e555 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e563 >= 255i));
                            }
                            let _e577 = phi_950_;
                            phi_951_ = _e577;
                        }
                        let _e579 = phi_951_;
                        phi_959_ = bitcast<f32>(((_e204 & 2147483648u) | select(_e579, 0u, select(_e552, true, _e573))));
                        phi_960_ = bitcast<f32>(((_e195 & 2147483648u) | select(_e533, 0u, select(_e506, true, _e527))));
                    } else {
                        phi_959_ = 0f;
                        phi_960_ = 1f;
                    }
                    let _e585 = phi_959_;
                    let _e587 = phi_960_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e95), bitcast<f32>(_e99), bitcast<f32>(_e103));
                    let _e594 = (_e247 % 3u);
                    let _e595 = (_e594 < 3u);
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e597 = local_9[_e594];
                    let _e598 = (_e246 % 3u);
                    let _e599 = (_e598 < 3u);
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e601 = local_9[_e598];
                    let _e602 = (_e248 % 3u);
                    let _e603 = (_e602 < 3u);
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e605 = local_9[_e602];
                    local_8 = array<f32, 3>(bitcast<f32>(_e107), bitcast<f32>(_e111), bitcast<f32>(_e115));
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e609 = local_8[_e594];
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e611 = local_8[_e598];
                    if _e603 {
                    } else {
                        break;
                    }
                    let _e613 = local_8[_e602];
                    phi_3307_ = false;
                    phi_1043_ = type_38(_e585, false);
                    phi_1046_ = (_e587 <= _e585);
                    phi_1048_ = type_49(type_47(array<f32, 3>(_e597, _e601, _e605), array<f32, 3>(_e609, _e611, _e613)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_1050_ = 0u;
                    phi_1052_ = ((3u * _e85) + 1u);
                    loop {
                        let _e619 = phi_3307_;
                        let _e621 = phi_1043_;
                        let _e623 = phi_1046_;
                        let _e625 = phi_1048_;
                        let _e627 = phi_1050_;
                        let _e629 = phi_1052_;
                        local_11 = _e621;
                        if _e623 {
                            phi_1063_ = true;
                        } else {
                            phi_1063_ = (_e627 > 0u);
                        }
                        let _e632 = phi_1063_;
                        if _e632 {
                            let _e633 = (_e629 > 0u);
                            if _e633 {
                                if _e623 {
                                    phi_1149_ = _e623;
                                    phi_1150_ = _e625;
                                    phi_1151_ = _e627;
                                } else {
                                    let _e634 = (_e627 - 1u);
                                    let _e635 = (_e634 % 128u);
                                    let _e636 = (_e635 < 128u);
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e638 = local_6[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e640 = local_5[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e642 = local_4[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e644 = local_3[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e647 = local_2[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e649 = local_1[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e651 = local[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3451_ = true;
                                        break;
                                    }
                                    let _e656 = local_7[_e635];
                                    phi_1149_ = (_e656 <= _e621.member);
                                    phi_1150_ = type_49(type_47(array<f32, 3>(_e640, _e642, _e644), array<f32, 3>(_e647, _e649, _e651)), _e638);
                                    phi_1151_ = _e634;
                                }
                                let _e660 = phi_1149_;
                                let _e662 = phi_1150_;
                                let _e664 = phi_1151_;
                                if _e660 {
                                    if ((_e662.member_1 & 2147483648u) != 0u) {
                                        phi_1169_ = _e621;
                                        phi_1172_ = type_7(0u, ((_e662.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1039 = phi_1169_;
                                            let _e1041 = phi_1172_;
                                            local_10 = _e1039;
                                            local_12 = _e1039;
                                            if (_e1041.member < _e1041.member_1) {
                                                phi_1173_ = type_7((_e1041.member + 1u), _e1041.member_1);
                                                phi_1195_ = type_7(1u, _e1041.member);
                                            } else {
                                                phi_1173_ = _e1041;
                                                phi_1195_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1054 = phi_1173_;
                                            let _e1056 = phi_1195_;
                                            let _e1060 = (bitcast<i32>(_e1056.member) != 0i);
                                            if _e1060 {
                                                let _e1061 = ((_e662.member_1 & 268435455u) + _e1056.member_1);
                                                let _e1062 = (_e1061 < _e87);
                                                if _e1062 {
                                                    if _e1062 {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1066 = global_2.member[_e1061].member_1;
                                                    phi_1216_ = _e1066;
                                                } else {
                                                    phi_1216_ = 4294967295u;
                                                }
                                                let _e1068 = phi_1216_;
                                                if (_e1061 >= _e87) {
                                                    phi_1308_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1062 {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    if (_e594 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1075 = global_2.member[_e1061].member[_e594];
                                                    if (_e598 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1081 = global_2.member[_e1061].member[_e598];
                                                    if (_e602 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_2.member[_e1061].member[_e602];
                                                    let _e1089 = (3u + _e594);
                                                    if (_e1089 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_2.member[_e1061].member[_e1089];
                                                    let _e1096 = (3u + _e598);
                                                    if (_e1096 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1102 = global_2.member[_e1061].member[_e1096];
                                                    let _e1103 = (3u + _e602);
                                                    if (_e1103 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1109 = global_2.member[_e1061].member[_e1103];
                                                    let _e1111 = (6u + _e594);
                                                    if (_e1111 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1117 = global_2.member[_e1061].member[_e1111];
                                                    let _e1118 = (6u + _e598);
                                                    if (_e1118 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1124 = global_2.member[_e1061].member[_e1118];
                                                    let _e1125 = (6u + _e602);
                                                    if (_e1125 < 9u) {
                                                    } else {
                                                        phi_3301_ = true;
                                                        break;
                                                    }
                                                    let _e1131 = global_2.member[_e1061].member[_e1125];
                                                    phi_1308_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1075, _e1081, _e1087), array<f32, 3>(_e1095, _e1102, _e1109), array<f32, 3>(_e1117, _e1124, _e1131));
                                                }
                                                let _e1135 = phi_1308_;
                                                let _e1151 = (_e1135[0][2] - _e444);
                                                let _e1154 = (((_e1135[0][0] - _e311) * _e480) - (_e1151 * _e348));
                                                let _e1157 = (((_e1135[0][1] - _e378) * _e480) - (_e1151 * _e414));
                                                let _e1160 = (_e1135[1][2] - _e444);
                                                let _e1163 = (((_e1135[1][0] - _e311) * _e480) - (_e1160 * _e348));
                                                let _e1166 = (((_e1135[1][1] - _e378) * _e480) - (_e1160 * _e414));
                                                let _e1169 = (_e1135[2][2] - _e444);
                                                let _e1172 = (((_e1135[2][0] - _e311) * _e480) - (_e1169 * _e348));
                                                let _e1175 = (((_e1135[2][1] - _e378) * _e480) - (_e1169 * _e414));
                                                let _e1176 = (_e1172 * _e1166);
                                                let _e1177 = (_e1175 * _e1163);
                                                let _e1178 = (_e1154 * _e1175);
                                                let _e1179 = (_e1157 * _e1172);
                                                let _e1180 = (_e1163 * _e1157);
                                                let _e1181 = (_e1166 * _e1154);
                                                let _e1186 = (((_e1176 >= _e1177) && (_e1178 >= _e1179)) && (_e1180 >= _e1181));
                                                let _e1192 = (_e1186 || (((_e1176 <= _e1177) && (_e1178 <= _e1179)) && (_e1180 <= _e1181)));
                                                if _e1192 {
                                                    let _e1194 = select(-1f, 1f, _e1186);
                                                    let _e1196 = ((_e1176 - _e1177) * _e1194);
                                                    let _e1198 = select(0f, _e1196, (_e1196 > 0f));
                                                    let _e1200 = ((_e1178 - _e1179) * _e1194);
                                                    let _e1202 = select(0f, _e1200, (_e1200 > 0f));
                                                    let _e1204 = ((_e1180 - _e1181) * _e1194);
                                                    let _e1206 = select(0f, _e1204, (_e1204 > 0f));
                                                    let _e1208 = ((_e1198 + _e1202) + _e1206);
                                                    let _e1210 = select(_e1135[1][0], _e1135[0][0], (_e1135[0][0] < _e1135[1][0]));
                                                    let _e1214 = select(_e1135[1][0], _e1135[0][0], (_e1135[0][0] > _e1135[1][0]));
                                                    let _e1218 = select(_e1135[1][1], _e1135[0][1], (_e1135[0][1] < _e1135[1][1]));
                                                    let _e1222 = select(_e1135[1][1], _e1135[0][1], (_e1135[0][1] > _e1135[1][1]));
                                                    let _e1226 = select(_e1135[1][2], _e1135[0][2], (_e1135[0][2] < _e1135[1][2]));
                                                    let _e1230 = select(_e1135[1][2], _e1135[0][2], (_e1135[0][2] > _e1135[1][2]));
                                                    let _e1235 = ((select(_e1135[2][0], _e1210, (_e1210 < _e1135[2][0])) - _e349) * _e352);
                                                    let _e1236 = ((select(_e1135[2][0], _e1214, (_e1214 > _e1135[2][0])) - _e350) * _e352);
                                                    let _e1239 = ((select(_e1135[2][1], _e1218, (_e1218 < _e1135[2][1])) - _e415) * _e418);
                                                    let _e1240 = ((select(_e1135[2][1], _e1222, (_e1222 > _e1135[2][1])) - _e416) * _e418);
                                                    let _e1243 = ((select(_e1135[2][2], _e1226, (_e1226 < _e1135[2][2])) - _e481) * _e484);
                                                    let _e1244 = ((select(_e1135[2][2], _e1230, (_e1230 > _e1135[2][2])) - _e482) * _e484);
                                                    let _e1246 = select(_e1244, _e1243, (_e1243 < _e1244));
                                                    let _e1248 = select(_e1244, _e1243, (_e1243 > _e1244));
                                                    let _e1250 = select(_e1236, _e1235, (_e1235 < _e1236));
                                                    let _e1252 = select(_e1240, _e1239, (_e1239 < _e1240));
                                                    let _e1254 = select(_e1252, _e1250, (_e1250 > _e1252));
                                                    let _e1256 = select(_e1246, _e1254, (_e1254 > _e1246));
                                                    let _e1258 = select(_e1236, _e1235, (_e1235 > _e1236));
                                                    let _e1260 = select(_e1240, _e1239, (_e1239 > _e1240));
                                                    let _e1262 = select(_e1260, _e1258, (_e1258 < _e1260));
                                                    let _e1264 = select(_e1248, _e1262, (_e1262 < _e1248));
                                                    let _e1265 = -(_e1246);
                                                    let _e1271 = select(_e587, _e1256, (_e1256 > _e587));
                                                    let _e1275 = select(_e1163, _e1154, (_e1154 < _e1163));
                                                    let _e1280 = select(_e1163, _e1154, (_e1154 > _e1163));
                                                    let _e1287 = select(_e1166, _e1157, (_e1157 < _e1166));
                                                    let _e1292 = select(_e1166, _e1157, (_e1157 > _e1166));
                                                    let _e1301 = (((((_e1192 && (_e1208 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1172, _e1275, (_e1275 < _e1172)) <= 0f) && (select(_e1172, _e1280, (_e1280 > _e1172)) >= 0f))) && ((select(_e1175, _e1287, (_e1287 < _e1175)) <= 0f) && (select(_e1175, _e1292, (_e1292 > _e1175)) >= 0f))) && (_e1271 <= (_e1264 + (select(_e1265, _e1248, (_e1248 > _e1265)) * 0.0000019073523f)))) && (_e1271 <= _e1039.member));
                                                    if _e1301 {
                                                        let _e1306 = (_e1135[1][0] - _e1135[0][0]);
                                                        let _e1307 = (_e1135[1][1] - _e1135[0][1]);
                                                        let _e1308 = (_e1135[1][2] - _e1135[0][2]);
                                                        let _e1309 = vec3<f32>(_e1306, _e1307, _e1308);
                                                        let _e1310 = (_e1135[2][0] - _e1135[1][0]);
                                                        let _e1311 = (_e1135[2][1] - _e1135[1][1]);
                                                        let _e1312 = (_e1135[2][2] - _e1135[1][2]);
                                                        let _e1313 = vec3<f32>(_e1310, _e1311, _e1312);
                                                        let _e1314 = (_e1135[0][0] - _e1135[2][0]);
                                                        let _e1315 = (_e1135[0][1] - _e1135[2][1]);
                                                        let _e1316 = (_e1135[0][2] - _e1135[2][2]);
                                                        let _e1317 = vec3<f32>(_e1314, _e1315, _e1316);
                                                        let _e1320 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                        let _e1323 = bitcast<f32>((bitcast<u32>(_e1307) & 2147483647u));
                                                        let _e1325 = select(_e1323, _e1320, (_e1320 > _e1323));
                                                        let _e1328 = bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u));
                                                        let _e1330 = select(_e1328, _e1325, (_e1325 > _e1328));
                                                        let _e1333 = bitcast<f32>((bitcast<u32>(_e1310) & 2147483647u));
                                                        let _e1336 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                        let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                        let _e1341 = bitcast<f32>((bitcast<u32>(_e1312) & 2147483647u));
                                                        let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                        let _e1346 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
                                                        let _e1349 = bitcast<f32>((bitcast<u32>(_e1315) & 2147483647u));
                                                        let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                        let _e1354 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                        let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                        let _e1358 = select(_e1343, _e1330, (_e1330 > _e1343));
                                                        let _e1360 = select(_e1356, _e1358, (_e1358 > _e1356));
                                                        if (_e1330 == _e1360) {
                                                            phi_1838_ = _e1166;
                                                            phi_1839_ = _e1163;
                                                            phi_1840_ = _e1157;
                                                            phi_1841_ = _e1154;
                                                            phi_1842_ = vec3<f32>(_e1135[0][0], _e1135[0][1], _e1135[0][2]);
                                                            phi_1843_ = _e1317;
                                                            phi_1844_ = _e1313;
                                                            phi_1845_ = _e1309;
                                                        } else {
                                                            let _e1362 = (_e1343 == _e1360);
                                                            let _e1367 = vec3(_e1362);
                                                            phi_1838_ = select(_e1157, _e1175, _e1362);
                                                            phi_1839_ = select(_e1154, _e1172, _e1362);
                                                            phi_1840_ = select(_e1175, _e1166, _e1362);
                                                            phi_1841_ = select(_e1172, _e1163, _e1362);
                                                            phi_1842_ = select(vec3<f32>(_e1135[2][0], _e1135[2][1], _e1135[2][2]), vec3<f32>(_e1135[1][0], _e1135[1][1], _e1135[1][2]), _e1367);
                                                            phi_1843_ = select(_e1313, _e1309, _e1367);
                                                            phi_1844_ = select(_e1309, _e1317, _e1367);
                                                            phi_1845_ = select(_e1317, _e1313, _e1367);
                                                        }
                                                        let _e1373 = phi_1838_;
                                                        let _e1375 = phi_1839_;
                                                        let _e1377 = phi_1840_;
                                                        let _e1379 = phi_1841_;
                                                        let _e1381 = phi_1842_;
                                                        let _e1383 = phi_1843_;
                                                        let _e1385 = phi_1844_;
                                                        let _e1387 = phi_1845_;
                                                        let _e1394 = ((_e1385.y * _e1383.z) - (_e1383.y * _e1385.z));
                                                        let _e1399 = ((_e1385.z * _e1383.x) - (_e1383.z * _e1385.x));
                                                        let _e1402 = ((_e1385.x * _e1383.y) - (_e1383.x * _e1385.y));
                                                        let _e1405 = ((_e1198 >= _e1202) && (_e1198 >= _e1206));
                                                        let _e1406 = (_e1202 >= _e1206);
                                                        let _e1420 = (((_e1394 * (select(select(_e1135[2][0], _e1135[1][0], _e1406), _e1135[0][0], _e1405) - _e311)) + (_e1399 * (select(select(_e1135[2][1], _e1135[1][1], _e1406), _e1135[0][1], _e1405) - _e378))) + (_e1402 * (select(select(_e1135[2][2], _e1135[1][2], _e1406), _e1135[0][2], _e1405) - _e444)));
                                                        let _e1425 = (((_e1394 * _e348) + (_e1399 * _e414)) + (_e1402 * _e480));
                                                        let _e1426 = (_e1375 - _e1379);
                                                        let _e1427 = (_e1373 - _e1377);
                                                        let _e1430 = ((_e1426 * _e1426) + (_e1427 * _e1427));
                                                        let _e1437 = (-(((_e1379 * _e1426) + (_e1377 * _e1427))) / select(0.000000000000000000000000000000000000011754944f, _e1430, (_e1430 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1439 = select(1f, _e1437, (_e1437 < 1f));
                                                        let _e1441 = select(0f, _e1439, (_e1439 > 0f));
                                                        let _e1450 = ((_e1381.x + (_e1387.x * _e1441)) - _e311);
                                                        let _e1453 = ((_e1381.y + (_e1387.y * _e1441)) - _e378);
                                                        let _e1456 = ((_e1381.z + (_e1387.z * _e1441)) - _e444);
                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                        let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                        let _e1467 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
                                                        let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u));
                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                        let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                        let _e1502 = bitcast<f32>((bitcast<u32>(_e1385.x) & 2147483647u));
                                                        let _e1505 = bitcast<f32>((bitcast<u32>(_e1385.y) & 2147483647u));
                                                        let _e1507 = select(_e1505, _e1502, (_e1502 > _e1505));
                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1385.z) & 2147483647u));
                                                        let _e1516 = bitcast<f32>((bitcast<u32>(_e1383.x) & 2147483647u));
                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1383.y) & 2147483647u));
                                                        let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                        let _e1524 = bitcast<f32>((bitcast<u32>(_e1383.z) & 2147483647u));
                                                        let _e1530 = ((bitcast<f32>((bitcast<u32>(((((_e1394 * _e1450) + (_e1399 * _e1453)) + (_e1402 * _e1456)) - _e1420)) & 2147483647u)) <= ((0.0000009536743f * select(_e1360, _e1469, (_e1469 > _e1360))) * select(_e1483, _e1480, (_e1480 > _e1483)))) && !((bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u)) <= ((0.0000038146973f * select(_e1510, _e1507, (_e1507 > _e1510))) * select(_e1524, _e1521, (_e1521 > _e1524))))));
                                                        let _e1531 = (_e1420 / _e1425);
                                                        if (_e1301 && !(_e1530)) {
                                                            let _e1534 = (_e1456 / _e480);
                                                            let _e1542 = (((_e1394 * (_e1450 - (_e348 * _e1534))) + (_e1399 * (_e1453 - (_e414 * _e1534)))) / _e1425);
                                                            phi_2036_ = select(select(_e1534, (_e1534 + _e1542), (bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u)) <= _e1360)), _e1531, _e1530);
                                                        } else {
                                                            phi_2036_ = _e1531;
                                                        }
                                                        let _e1551 = phi_2036_;
                                                        let _e1553 = select(_e1264, _e1551, (_e1551 < _e1264));
                                                        let _e1555 = select(_e1256, _e1553, (_e1553 > _e1256));
                                                        let _e1556 = (1f / _e1208);
                                                        phi_2056_ = type_34(_e1555, (_e1202 * _e1556), (_e1206 * _e1556), ((_e1301 && (_e1555 >= _e587)) && (_e1555 <= _e1039.member)));
                                                        phi_2057_ = type_34();
                                                    } else {
                                                        phi_2056_ = type_34();
                                                        phi_2057_ = type_34(0f, 0f, 0f, _e1301);
                                                    }
                                                    let _e1565 = phi_2056_;
                                                    let _e1567 = phi_2057_;
                                                    phi_2060_ = _e1565;
                                                    phi_2061_ = _e1567;
                                                    phi_2062_ = select(true, false, _e1301);
                                                } else {
                                                    phi_2060_ = type_34();
                                                    phi_2061_ = type_34(0f, 0f, 0f, _e1192);
                                                    phi_2062_ = true;
                                                }
                                                let _e1570 = phi_2060_;
                                                let _e1572 = phi_2061_;
                                                let _e1574 = phi_2062_;
                                                if _e1574 {
                                                    phi_2066_ = _e1572;
                                                } else {
                                                    phi_2066_ = _e1570;
                                                }
                                                let _e1576 = phi_2066_;
                                                if _e1576.member_3 {
                                                    phi_2075_ = type_25(_e1576.member, _e1576.member_1, _e1576.member_2, _e1068);
                                                } else {
                                                    phi_2075_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1583 = phi_2075_;
                                                if (_e1583.member_3 != 4294967295u) {
                                                    if (_e1068 != 4294967295u) {
                                                        phi_2086_ = type_38(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2086_ = _e1039;
                                                    }
                                                    let _e1588 = phi_2086_;
                                                    phi_2087_ = _e1588;
                                                } else {
                                                    phi_2087_ = _e1039;
                                                }
                                                let _e1590 = phi_2087_;
                                                phi_1170_ = _e1590;
                                            } else {
                                                phi_1170_ = type_38();
                                            }
                                            let _e1592 = phi_1170_;
                                            continue;
                                            continuing {
                                                phi_1169_ = _e1592;
                                                phi_1172_ = _e1054;
                                                phi_3301_ = _e619;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1595 = phi_3301_;
                                        phi_3451_ = _e1595;
                                        if _e1595 {
                                            break;
                                        }
                                        let _e1597 = local_10;
                                        phi_3455_ = _e1595;
                                        let _e1738 = local_12;
                                        phi_3091_ = _e1738;
                                        phi_3092_ = false;
                                        phi_3093_ = _e662;
                                        phi_3094_ = select(_e664, 0u, (_e587 > _e1597.member));
                                    } else {
                                        let _e673 = (_e662.member_1 < _e85);
                                        if _e673 {
                                            if _e673 {
                                            } else {
                                                phi_3451_ = true;
                                                break;
                                            }
                                            let _e675 = global_6.member[_e662.member_1];
                                            phi_2108_ = _e675;
                                        } else {
                                            phi_2108_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e677 = phi_2108_;
                                        let _e692 = ((10u * _e247) & 31u);
                                        let _e695 = ((_e677.member[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e703 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[0] - _e662.member.member[0]) * 0.0009775171f)) ^ _e119));
                                        let _e708 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e695)) - 8388608f) * _e703)) ^ _e119)));
                                        let _e712 = select(select(_e662.member.member_1[0], _e708, (_e708 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e695 == 1023u));
                                        let _e714 = ((10u * _e246) & 31u);
                                        let _e717 = ((_e677.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[1] - _e662.member.member[1]) * 0.0009775171f)) ^ _e119));
                                        let _e730 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e119)));
                                        let _e734 = select(select(_e662.member.member_1[1], _e730, (_e730 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e717 == 1023u));
                                        let _e736 = ((10u * _e248) & 31u);
                                        let _e739 = ((_e677.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[2] - _e662.member.member[2]) * 0.0009775171f)) ^ _e119));
                                        let _e752 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e119)));
                                        let _e756 = select(select(_e662.member.member_1[2], _e752, (_e752 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e739 == 1023u));
                                        let _e759 = ((_e677.member[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e767 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e759)) - 8388608f) * _e703)) ^ _e119)));
                                        let _e771 = select(select(_e662.member.member_1[0], _e767, (_e767 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e759 == 1023u));
                                        let _e774 = ((_e677.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e782 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e774)) - 8388608f) * _e725)) ^ _e119)));
                                        let _e786 = select(select(_e662.member.member_1[1], _e782, (_e782 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e774 == 1023u));
                                        let _e789 = ((_e677.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e797 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e789)) - 8388608f) * _e747)) ^ _e119)));
                                        let _e801 = select(select(_e662.member.member_1[2], _e797, (_e797 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e789 == 1023u));
                                        let _e807 = ((_e677.member_1[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e815 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e703)) ^ _e119)));
                                        let _e819 = select(select(_e662.member.member_1[0], _e815, (_e815 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e807 == 1023u));
                                        let _e822 = ((_e677.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e830 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e725)) ^ _e119)));
                                        let _e834 = select(select(_e662.member.member_1[1], _e830, (_e830 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e822 == 1023u));
                                        let _e837 = ((_e677.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e845 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e747)) ^ _e119)));
                                        let _e849 = select(select(_e662.member.member_1[2], _e845, (_e845 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e837 == 1023u));
                                        let _e852 = ((_e677.member_1[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e860 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e703)) ^ _e119)));
                                        let _e864 = select(select(_e662.member.member_1[0], _e860, (_e860 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e852 == 1023u));
                                        let _e867 = ((_e677.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e875 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e867)) - 8388608f) * _e725)) ^ _e119)));
                                        let _e879 = select(select(_e662.member.member_1[1], _e875, (_e875 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e867 == 1023u));
                                        let _e882 = ((_e677.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e890 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e747)) ^ _e119)));
                                        let _e894 = select(select(_e662.member.member_1[2], _e890, (_e890 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e882 == 1023u));
                                        let _e899 = type_49(type_47(array<f32, 3>(_e712, _e734, _e756), array<f32, 3>(_e771, _e786, _e801)), _e677.member_2);
                                        let _e904 = type_49(type_47(array<f32, 3>(_e819, _e834, _e849), array<f32, 3>(_e864, _e879, _e894)), _e677.member_3);
                                        let _e910 = ((_e712 - _e349) * _e352);
                                        let _e911 = ((_e819 - _e349) * _e352);
                                        let _e912 = ((_e771 - _e350) * _e352);
                                        let _e913 = ((_e864 - _e350) * _e352);
                                        let _e918 = ((_e734 - _e415) * _e418);
                                        let _e919 = ((_e834 - _e415) * _e418);
                                        let _e920 = ((_e786 - _e416) * _e418);
                                        let _e921 = ((_e879 - _e416) * _e418);
                                        let _e926 = ((_e756 - _e481) * _e484);
                                        let _e927 = ((_e849 - _e481) * _e484);
                                        let _e928 = ((_e801 - _e482) * _e484);
                                        let _e929 = ((_e894 - _e482) * _e484);
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
                                        let _e981 = select(_e587, _e951, (_e951 > _e587));
                                        let _e983 = select(_e587, _e953, (_e953 > _e587));
                                        let _e988 = (_e981 <= select(_e621.member, _e978, (_e978 < _e621.member)));
                                        let _e989 = (_e983 <= select(_e621.member, _e979, (_e979 < _e621.member)));
                                        let _e990 = (_e981 <= _e983);
                                        if _e988 {
                                            if _e989 {
                                                if _e990 {
                                                    phi_2994_ = _e904;
                                                } else {
                                                    phi_2994_ = _e899;
                                                }
                                                let _e992 = phi_2994_;
                                                let _e999 = (_e664 % 128u);
                                                let _e1000 = (_e999 < 128u);
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_6[_e999] = _e992.member_1;
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_5[_e999] = _e992.member.member[0];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_4[_e999] = _e992.member.member[1];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_3[_e999] = _e992.member.member[2];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_2[_e999] = _e992.member.member_1[0];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_1[_e999] = _e992.member.member_1[1];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local[_e999] = _e992.member.member_1[2];
                                                if _e1000 {
                                                } else {
                                                    phi_3451_ = true;
                                                    break;
                                                }
                                                local_7[_e999] = select(_e981, _e983, _e990);
                                                if _e990 {
                                                    phi_3070_ = _e899;
                                                } else {
                                                    phi_3070_ = _e904;
                                                }
                                                let _e1017 = phi_3070_;
                                                phi_3071_ = _e1017;
                                                phi_3072_ = (_e664 + 1u);
                                            } else {
                                                phi_3071_ = type_49();
                                                phi_3072_ = u32();
                                            }
                                            let _e1019 = phi_3071_;
                                            let _e1021 = phi_3072_;
                                            phi_3074_ = _e1019;
                                            phi_3075_ = _e1021;
                                            phi_3076_ = select(true, false, _e989);
                                        } else {
                                            phi_3074_ = type_49();
                                            phi_3075_ = u32();
                                            phi_3076_ = true;
                                        }
                                        let _e1024 = phi_3074_;
                                        let _e1026 = phi_3075_;
                                        let _e1028 = phi_3076_;
                                        if _e1028 {
                                            if _e988 {
                                                phi_3083_ = _e899;
                                            } else {
                                                phi_3083_ = _e904;
                                            }
                                            let _e1030 = phi_3083_;
                                            phi_3088_ = select(_e989, true, _e988);
                                            phi_3089_ = _e1030;
                                        } else {
                                            phi_3088_ = _e660;
                                            phi_3089_ = _e1024;
                                        }
                                        let _e1033 = phi_3088_;
                                        let _e1035 = phi_3089_;
                                        phi_3455_ = _e619;
                                        phi_3091_ = _e621;
                                        phi_3092_ = _e1033;
                                        phi_3093_ = _e1035;
                                        phi_3094_ = select(_e1026, _e664, _e1028);
                                    }
                                    let _e1602 = phi_3455_;
                                    let _e1604 = phi_3091_;
                                    let _e1606 = phi_3092_;
                                    let _e1608 = phi_3093_;
                                    let _e1610 = phi_3094_;
                                    phi_3454_ = _e1602;
                                    phi_3095_ = _e1604;
                                    phi_3096_ = _e1606;
                                    phi_3097_ = _e1608;
                                    phi_3098_ = _e1610;
                                    phi_3099_ = (_e629 - 1u);
                                } else {
                                    phi_3454_ = _e619;
                                    phi_3095_ = _e621;
                                    phi_3096_ = _e660;
                                    phi_3097_ = _e662;
                                    phi_3098_ = _e664;
                                    phi_3099_ = _e629;
                                }
                                let _e1612 = phi_3454_;
                                let _e1614 = phi_3095_;
                                let _e1616 = phi_3096_;
                                let _e1618 = phi_3097_;
                                let _e1620 = phi_3098_;
                                let _e1622 = phi_3099_;
                                phi_3453_ = _e1612;
                                phi_3100_ = _e1614;
                                phi_3101_ = _e1616;
                                phi_3102_ = _e1618;
                                phi_3103_ = _e1620;
                                phi_3104_ = _e1622;
                            } else {
                                phi_3453_ = _e619;
                                phi_3100_ = type_38();
                                phi_3101_ = bool();
                                phi_3102_ = type_49();
                                phi_3103_ = u32();
                                phi_3104_ = u32();
                            }
                            let _e1624 = phi_3453_;
                            let _e1626 = phi_3100_;
                            let _e1628 = phi_3101_;
                            let _e1630 = phi_3102_;
                            let _e1632 = phi_3103_;
                            let _e1634 = phi_3104_;
                            phi_3452_ = _e1624;
                            phi_1044_ = _e1626;
                            phi_1047_ = _e1628;
                            phi_1049_ = _e1630;
                            phi_1051_ = _e1632;
                            phi_1053_ = _e1634;
                            phi_3105_ = _e633;
                        } else {
                            phi_3452_ = _e619;
                            phi_1044_ = type_38();
                            phi_1047_ = bool();
                            phi_1049_ = type_49();
                            phi_1051_ = u32();
                            phi_1053_ = u32();
                            phi_3105_ = false;
                        }
                        let _e1636 = phi_3452_;
                        let _e1638 = phi_1044_;
                        let _e1640 = phi_1047_;
                        let _e1642 = phi_1049_;
                        let _e1644 = phi_1051_;
                        let _e1646 = phi_1053_;
                        let _e1648 = phi_3105_;
                        continue;
                        continuing {
                            phi_3307_ = _e1636;
                            phi_1043_ = _e1638;
                            phi_1046_ = _e1640;
                            phi_1048_ = _e1642;
                            phi_1050_ = _e1644;
                            phi_1052_ = _e1646;
                            phi_3451_ = _e1636;
                            break if !(_e1648);
                        }
                    }
                    let _e1651 = phi_3451_;
                    if _e1651 {
                        break;
                    }
                    let _e1653 = local_11;
                    if _e135 {
                    } else {
                        break;
                    }
                    global_5.member[_e133] = select(0u, 1u, _e1653.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
