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
    var phi_360_: i32;
    var phi_361_: i32;
    var phi_371_: bool;
    var phi_381_: u32;
    var phi_382_: u32;
    var phi_384_: bool;
    var phi_389_: u32;
    var phi_402_: i32;
    var phi_422_: i32;
    var phi_440_: f32;
    var phi_446_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_690_: f32;
    var phi_696_: f32;
    var phi_736_: f32;
    var phi_742_: f32;
    var phi_861_: i32;
    var phi_883_: u32;
    var phi_884_: u32;
    var phi_921_: i32;
    var phi_943_: u32;
    var phi_944_: u32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_3379_: bool;
    var phi_1036_: type_38;
    var phi_1039_: u32;
    var phi_1041_: bool;
    var phi_1043_: u32;
    var phi_1045_: type_49;
    var phi_1056_: bool;
    var phi_1142_: bool;
    var phi_1143_: u32;
    var phi_1144_: type_49;
    var phi_1162_: type_38;
    var phi_1165_: type_7;
    var phi_1166_: type_7;
    var phi_1188_: type_7;
    var phi_1209_: u32;
    var phi_1301_: array<array<f32, 3>, 3>;
    var phi_3174_: bool;
    var phi_3189_: bool;
    var phi_3204_: bool;
    var phi_3219_: bool;
    var phi_3234_: bool;
    var phi_3249_: bool;
    var phi_1843_: f32;
    var phi_1844_: f32;
    var phi_1845_: f32;
    var phi_1846_: f32;
    var phi_1847_: vec3<f32>;
    var phi_1848_: vec3<f32>;
    var phi_1849_: vec3<f32>;
    var phi_1850_: vec3<f32>;
    var phi_3264_: bool;
    var phi_3279_: bool;
    var phi_3294_: bool;
    var phi_3309_: bool;
    var phi_3324_: bool;
    var phi_3339_: bool;
    var phi_2058_: f32;
    var phi_2078_: type_34;
    var phi_2079_: type_34;
    var phi_2082_: type_34;
    var phi_2083_: type_34;
    var phi_2084_: bool;
    var phi_2088_: type_34;
    var phi_2097_: type_25;
    var phi_2108_: type_38;
    var phi_2109_: type_38;
    var phi_1163_: type_38;
    var phi_3373_: bool;
    var phi_3594_: bool;
    var phi_2110_: type_38;
    var phi_2131_: type_42;
    var phi_3017_: type_49;
    var phi_3093_: type_49;
    var phi_3094_: u32;
    var phi_3095_: type_49;
    var phi_3097_: u32;
    var phi_3098_: type_49;
    var phi_3099_: bool;
    var phi_3106_: type_49;
    var phi_3111_: bool;
    var phi_3113_: type_49;
    var phi_3117_: bool;
    var phi_3118_: u32;
    var phi_3119_: type_49;
    var phi_3129_: u32;
    var phi_3130_: type_49;
    var phi_3538_: bool;
    var phi_3131_: type_38;
    var phi_3132_: u32;
    var phi_3133_: bool;
    var phi_3134_: u32;
    var phi_3135_: type_49;
    var phi_3537_: bool;
    var phi_3136_: type_38;
    var phi_3137_: u32;
    var phi_3138_: bool;
    var phi_3139_: u32;
    var phi_3140_: type_49;
    var phi_3536_: bool;
    var phi_1037_: type_38;
    var phi_1040_: u32;
    var phi_1042_: bool;
    var phi_1044_: u32;
    var phi_1046_: type_49;
    var phi_3141_: bool;
    var phi_3535_: bool;
    var local_10: type_38;
    var local_11: type_38;

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
                            phi_360_ = (bitcast<i32>((_e212 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_360_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e212)), 32u, (_e212 == 0u))));
                        }
                        let _e226 = phi_360_;
                        phi_361_ = _e226;
                    } else {
                        phi_361_ = 0i;
                    }
                    let _e228 = phi_361_;
                    let _e229 = (_e145 == _e184);
                    if _e229 {
                        phi_371_ = true;
                    } else {
                        phi_371_ = (_e152 == _e184);
                    }
                    let _e232 = phi_371_;
                    let _e233 = select(1u, 0u, _e229);
                    if _e232 {
                        let _e234 = (_e233 + 1u);
                        phi_381_ = _e234;
                        phi_382_ = _e234;
                        phi_384_ = select(true, false, (_e234 == 2u));
                    } else {
                        phi_381_ = u32();
                        phi_382_ = 0u;
                        phi_384_ = true;
                    }
                    let _e238 = phi_381_;
                    let _e240 = phi_382_;
                    let _e242 = phi_384_;
                    if _e242 {
                        phi_389_ = (_e240 + 1u);
                    } else {
                        phi_389_ = 0u;
                    }
                    let _e246 = phi_389_;
                    let _e247 = select(_e238, _e240, _e242);
                    let _e248 = select(_e233, select(2u, _e233, _e232), _e242);
                    if (_e123 < -126i) {
                        phi_402_ = -126i;
                    } else {
                        phi_402_ = select(_e123, 127i, (_e123 > 127i));
                    }
                    let _e253 = phi_402_;
                    let _e258 = bitcast<f32>((bitcast<u32>((_e253 + 127i)) << bitcast<u32>(23i)));
                    let _e264 = bitcast<f32>((bitcast<u32>(((_e123 - _e253) + 127i)) << bitcast<u32>(23i)));
                    let _e265 = -(_e228);
                    if (_e265 < -126i) {
                        phi_422_ = -126i;
                    } else {
                        phi_422_ = select(_e265, 127i, (_e265 > 127i));
                    }
                    let _e270 = phi_422_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e265 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = global_4.member[_e133].member;
                    let _e286 = (_e247 == 0u);
                    if _e286 {
                        phi_440_ = _e285[0];
                    } else {
                        phi_440_ = _e285[1];
                    }
                    let _e290 = phi_440_;
                    let _e291 = (_e247 == 2u);
                    if _e291 {
                        phi_446_ = _e285[2];
                    } else {
                        phi_446_ = _e290;
                    }
                    let _e294 = phi_446_;
                    let _e295 = bitcast<u32>(_e294);
                    let _e297 = ((_e295 & 2139095040u) != 0u);
                    let _e311 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * _e258) * select(0.00000011920929f, 1f, _e297)) * _e264);
                    let _e312 = global_4.member[_e133].member_2;
                    if _e286 {
                        phi_486_ = _e312[0];
                    } else {
                        phi_486_ = _e312[1];
                    }
                    let _e316 = phi_486_;
                    if _e291 {
                        phi_492_ = _e312[2];
                    } else {
                        phi_492_ = _e316;
                    }
                    let _e319 = phi_492_;
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
                        phi_565_ = _e285[0];
                    } else {
                        phi_565_ = _e285[1];
                    }
                    let _e357 = phi_565_;
                    let _e358 = (_e246 == 2u);
                    if _e358 {
                        phi_571_ = _e285[2];
                    } else {
                        phi_571_ = _e357;
                    }
                    let _e361 = phi_571_;
                    let _e362 = bitcast<u32>(_e361);
                    let _e364 = ((_e362 & 2139095040u) != 0u);
                    let _e378 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e362 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e362 & 2147483648u))), _e361, _e364) * _e258) * select(0.00000011920929f, 1f, _e364)) * _e264);
                    if _e353 {
                        phi_611_ = _e312[0];
                    } else {
                        phi_611_ = _e312[1];
                    }
                    let _e382 = phi_611_;
                    if _e358 {
                        phi_617_ = _e312[2];
                    } else {
                        phi_617_ = _e382;
                    }
                    let _e385 = phi_617_;
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
                        phi_690_ = _e285[0];
                    } else {
                        phi_690_ = _e285[1];
                    }
                    let _e423 = phi_690_;
                    let _e424 = (_e248 == 2u);
                    if _e424 {
                        phi_696_ = _e285[2];
                    } else {
                        phi_696_ = _e423;
                    }
                    let _e427 = phi_696_;
                    let _e428 = bitcast<u32>(_e427);
                    let _e430 = ((_e428 & 2139095040u) != 0u);
                    let _e444 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e428 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e428 & 2147483648u))), _e427, _e430) * _e258) * select(0.00000011920929f, 1f, _e430)) * _e264);
                    if _e419 {
                        phi_736_ = _e312[0];
                    } else {
                        phi_736_ = _e312[1];
                    }
                    let _e448 = phi_736_;
                    if _e424 {
                        phi_742_ = _e312[2];
                    } else {
                        phi_742_ = _e448;
                    }
                    let _e451 = phi_742_;
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
                            phi_861_ = 255i;
                        } else {
                            phi_861_ = (((_e502 + select(0i, 1i, (_e502 == 0i))) - _e509) + _e489);
                        }
                        let _e517 = phi_861_;
                        let _e527 = (_e517 <= 0i);
                        if _e527 {
                            phi_884_ = u32();
                        } else {
                            if _e506 {
                                phi_883_ = u32();
                            } else {
                                phi_883_ = select(((bitcast<u32>(_e517) << bitcast<u32>(23i)) | ((_e499 << bitcast<u32>(((_e509 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e517 >= 255i));
                            }
                            let _e531 = phi_883_;
                            phi_884_ = _e531;
                        }
                        let _e533 = phi_884_;
                        let _e545 = ((_e205 & 8388607u) | (select(0u, 1u, ((_e205 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e548 = bitcast<i32>((_e205 >> bitcast<u32>(23i)));
                        let _e552 = (_e545 == 0u);
                        let _e555 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e545)), 32u, _e552)) - 8i);
                        if (_e548 == 255i) {
                            phi_921_ = 255i;
                        } else {
                            phi_921_ = (((_e548 + select(0i, 1i, (_e548 == 0i))) - _e555) + _e489);
                        }
                        let _e563 = phi_921_;
                        let _e573 = (_e563 <= 0i);
                        if _e573 {
                            phi_944_ = u32();
                        } else {
                            if _e552 {
                                phi_943_ = u32();
                            } else {
                                phi_943_ = select(((bitcast<u32>(_e563) << bitcast<u32>(23i)) | ((_e545 << bitcast<u32>(((_e555 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e563 >= 255i));
                            }
                            let _e577 = phi_943_;
                            phi_944_ = _e577;
                        }
                        let _e579 = phi_944_;
                        phi_952_ = bitcast<f32>(((_e204 & 2147483648u) | select(_e579, 0u, select(_e552, true, _e573))));
                        phi_953_ = bitcast<f32>(((_e195 & 2147483648u) | select(_e533, 0u, select(_e506, true, _e527))));
                    } else {
                        phi_952_ = 0f;
                        phi_953_ = 1f;
                    }
                    let _e585 = phi_952_;
                    let _e587 = phi_953_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e95), bitcast<f32>(_e99), bitcast<f32>(_e103));
                    let _e592 = (_e247 % 3u);
                    let _e593 = (_e592 < 3u);
                    if _e593 {
                    } else {
                        break;
                    }
                    let _e595 = local_9[_e592];
                    let _e596 = (_e246 % 3u);
                    let _e597 = (_e596 < 3u);
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e599 = local_9[_e596];
                    let _e600 = (_e248 % 3u);
                    let _e601 = (_e600 < 3u);
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e603 = local_9[_e600];
                    local_8 = array<f32, 3>(bitcast<f32>(_e107), bitcast<f32>(_e111), bitcast<f32>(_e115));
                    if _e593 {
                    } else {
                        break;
                    }
                    let _e607 = local_8[_e592];
                    if _e597 {
                    } else {
                        break;
                    }
                    let _e609 = local_8[_e596];
                    if _e601 {
                    } else {
                        break;
                    }
                    let _e611 = local_8[_e600];
                    phi_3379_ = false;
                    phi_1036_ = type_38(_e585, false);
                    phi_1039_ = ((3u * _e85) + 1u);
                    phi_1041_ = (_e587 <= _e585);
                    phi_1043_ = 0u;
                    phi_1045_ = type_49(type_47(array<f32, 3>(_e595, _e599, _e603), array<f32, 3>(_e607, _e609, _e611)), select(0u, 2147483648u, (_e85 == 0u)));
                    loop {
                        let _e619 = phi_3379_;
                        let _e621 = phi_1036_;
                        let _e623 = phi_1039_;
                        let _e625 = phi_1041_;
                        let _e627 = phi_1043_;
                        let _e629 = phi_1045_;
                        local_10 = _e621;
                        if _e625 {
                            phi_1056_ = true;
                        } else {
                            phi_1056_ = (_e627 > 0u);
                        }
                        let _e632 = phi_1056_;
                        if _e632 {
                            let _e633 = (_e623 > 0u);
                            if _e633 {
                                if _e625 {
                                    phi_1142_ = _e625;
                                    phi_1143_ = _e627;
                                    phi_1144_ = _e629;
                                } else {
                                    let _e634 = (_e627 - 1u);
                                    let _e635 = (_e634 % 128u);
                                    let _e636 = (_e635 < 128u);
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e638 = local_6[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e640 = local_5[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e642 = local_4[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e644 = local_3[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e647 = local_2[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e649 = local_1[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e651 = local[_e635];
                                    if _e636 {
                                    } else {
                                        phi_3535_ = true;
                                        break;
                                    }
                                    let _e656 = local_7[_e635];
                                    phi_1142_ = (_e656 <= _e621.member);
                                    phi_1143_ = _e634;
                                    phi_1144_ = type_49(type_47(array<f32, 3>(_e640, _e642, _e644), array<f32, 3>(_e647, _e649, _e651)), _e638);
                                }
                                let _e660 = phi_1142_;
                                let _e662 = phi_1143_;
                                let _e664 = phi_1144_;
                                if _e660 {
                                    let _e668 = ((_e664.member_1 & 2147483648u) != 0u);
                                    if _e668 {
                                        phi_1162_ = _e621;
                                        phi_1165_ = type_7(0u, ((_e664.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e675 = phi_1162_;
                                            let _e677 = phi_1165_;
                                            local_11 = _e675;
                                            if (_e677.member < _e677.member_1) {
                                                phi_1166_ = type_7((_e677.member + 1u), _e677.member_1);
                                                phi_1188_ = type_7(1u, _e677.member);
                                            } else {
                                                phi_1166_ = _e677;
                                                phi_1188_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e690 = phi_1166_;
                                            let _e692 = phi_1188_;
                                            let _e696 = (bitcast<i32>(_e692.member) != 0i);
                                            if _e696 {
                                                let _e697 = ((_e664.member_1 & 268435455u) + _e692.member_1);
                                                let _e698 = (_e697 < _e87);
                                                if _e698 {
                                                    if _e698 {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e702 = global_2.member[_e697].member_1;
                                                    phi_1209_ = _e702;
                                                } else {
                                                    phi_1209_ = 4294967295u;
                                                }
                                                let _e704 = phi_1209_;
                                                if (_e697 >= _e87) {
                                                    phi_1301_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e698 {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    if (_e592 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_2.member[_e697].member[_e592];
                                                    if (_e596 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_2.member[_e697].member[_e596];
                                                    if (_e600 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_2.member[_e697].member[_e600];
                                                    let _e725 = (3u + _e592);
                                                    if (_e725 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e731 = global_2.member[_e697].member[_e725];
                                                    let _e732 = (3u + _e596);
                                                    if (_e732 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e738 = global_2.member[_e697].member[_e732];
                                                    let _e739 = (3u + _e600);
                                                    if (_e739 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e697].member[_e739];
                                                    let _e747 = (6u + _e592);
                                                    if (_e747 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e697].member[_e747];
                                                    let _e754 = (6u + _e596);
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e697].member[_e754];
                                                    let _e761 = (6u + _e600);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3373_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e697].member[_e761];
                                                    phi_1301_ = array<array<f32, 3>, 3>(array<f32, 3>(_e711, _e717, _e723), array<f32, 3>(_e731, _e738, _e745), array<f32, 3>(_e753, _e760, _e767));
                                                }
                                                let _e771 = phi_1301_;
                                                let _e787 = (_e771[0][2] - _e444);
                                                let _e790 = (((_e771[0][0] - _e311) * _e480) - (_e787 * _e348));
                                                let _e793 = (((_e771[0][1] - _e378) * _e480) - (_e787 * _e414));
                                                let _e796 = (_e771[1][2] - _e444);
                                                let _e799 = (((_e771[1][0] - _e311) * _e480) - (_e796 * _e348));
                                                let _e802 = (((_e771[1][1] - _e378) * _e480) - (_e796 * _e414));
                                                let _e805 = (_e771[2][2] - _e444);
                                                let _e808 = (((_e771[2][0] - _e311) * _e480) - (_e805 * _e348));
                                                let _e811 = (((_e771[2][1] - _e378) * _e480) - (_e805 * _e414));
                                                let _e812 = (_e808 * _e802);
                                                let _e813 = (_e811 * _e799);
                                                let _e814 = (_e790 * _e811);
                                                let _e815 = (_e793 * _e808);
                                                let _e816 = (_e799 * _e793);
                                                let _e817 = (_e802 * _e790);
                                                let _e822 = (((_e812 >= _e813) && (_e814 >= _e815)) && (_e816 >= _e817));
                                                let _e828 = (_e822 || (((_e812 <= _e813) && (_e814 <= _e815)) && (_e816 <= _e817)));
                                                if _e828 {
                                                    let _e830 = select(-1f, 1f, _e822);
                                                    let _e832 = ((_e812 - _e813) * _e830);
                                                    let _e834 = select(0f, _e832, (_e832 > 0f));
                                                    let _e836 = ((_e814 - _e815) * _e830);
                                                    let _e838 = select(0f, _e836, (_e836 > 0f));
                                                    let _e840 = ((_e816 - _e817) * _e830);
                                                    let _e842 = select(0f, _e840, (_e840 > 0f));
                                                    let _e844 = ((_e834 + _e838) + _e842);
                                                    let _e846 = select(_e771[1][0], _e771[0][0], (_e771[0][0] < _e771[1][0]));
                                                    let _e850 = select(_e771[1][0], _e771[0][0], (_e771[0][0] > _e771[1][0]));
                                                    let _e854 = select(_e771[1][1], _e771[0][1], (_e771[0][1] < _e771[1][1]));
                                                    let _e858 = select(_e771[1][1], _e771[0][1], (_e771[0][1] > _e771[1][1]));
                                                    let _e862 = select(_e771[1][2], _e771[0][2], (_e771[0][2] < _e771[1][2]));
                                                    let _e866 = select(_e771[1][2], _e771[0][2], (_e771[0][2] > _e771[1][2]));
                                                    let _e871 = ((select(_e771[2][0], _e846, (_e846 < _e771[2][0])) - _e349) * _e352);
                                                    let _e872 = ((select(_e771[2][0], _e850, (_e850 > _e771[2][0])) - _e350) * _e352);
                                                    let _e875 = ((select(_e771[2][1], _e854, (_e854 < _e771[2][1])) - _e415) * _e418);
                                                    let _e876 = ((select(_e771[2][1], _e858, (_e858 > _e771[2][1])) - _e416) * _e418);
                                                    let _e879 = ((select(_e771[2][2], _e862, (_e862 < _e771[2][2])) - _e481) * _e484);
                                                    let _e880 = ((select(_e771[2][2], _e866, (_e866 > _e771[2][2])) - _e482) * _e484);
                                                    let _e882 = select(_e880, _e879, (_e879 < _e880));
                                                    let _e884 = select(_e880, _e879, (_e879 > _e880));
                                                    let _e886 = select(_e872, _e871, (_e871 < _e872));
                                                    let _e888 = select(_e876, _e875, (_e875 < _e876));
                                                    let _e890 = select(_e888, _e886, (_e886 > _e888));
                                                    let _e892 = select(_e882, _e890, (_e890 > _e882));
                                                    let _e894 = select(_e872, _e871, (_e871 > _e872));
                                                    let _e896 = select(_e876, _e875, (_e875 > _e876));
                                                    let _e898 = select(_e896, _e894, (_e894 < _e896));
                                                    let _e900 = select(_e884, _e898, (_e898 < _e884));
                                                    let _e901 = -(_e882);
                                                    let _e907 = select(_e587, _e892, (_e892 > _e587));
                                                    let _e911 = select(_e799, _e790, (_e790 < _e799));
                                                    let _e916 = select(_e799, _e790, (_e790 > _e799));
                                                    let _e923 = select(_e802, _e793, (_e793 < _e802));
                                                    let _e928 = select(_e802, _e793, (_e793 > _e802));
                                                    let _e937 = (((((_e828 && (_e844 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e808, _e911, (_e911 < _e808)) <= 0f) && (select(_e808, _e916, (_e916 > _e808)) >= 0f))) && ((select(_e811, _e923, (_e923 < _e811)) <= 0f) && (select(_e811, _e928, (_e928 > _e811)) >= 0f))) && (_e907 <= (_e900 + (select(_e901, _e884, (_e884 > _e901)) * 0.0000019073523f)))) && (_e907 <= _e675.member));
                                                    if _e937 {
                                                        let _e942 = (_e771[1][0] - _e771[0][0]);
                                                        let _e943 = (_e771[1][1] - _e771[0][1]);
                                                        let _e944 = (_e771[1][2] - _e771[0][2]);
                                                        let _e945 = vec3<f32>(_e942, _e943, _e944);
                                                        let _e946 = (_e771[2][0] - _e771[1][0]);
                                                        let _e947 = (_e771[2][1] - _e771[1][1]);
                                                        let _e948 = (_e771[2][2] - _e771[1][2]);
                                                        let _e949 = vec3<f32>(_e946, _e947, _e948);
                                                        let _e950 = (_e771[0][0] - _e771[2][0]);
                                                        let _e951 = (_e771[0][1] - _e771[2][1]);
                                                        let _e952 = (_e771[0][2] - _e771[2][2]);
                                                        let _e953 = vec3<f32>(_e950, _e951, _e952);
                                                        let _e954 = abs(_e942);
                                                        let _e955 = abs(_e943);
                                                        if (_e954 != _e954) {
                                                            phi_3174_ = true;
                                                        } else {
                                                            phi_3174_ = (_e955 >= _e954);
                                                        }
                                                        let _e959 = phi_3174_;
                                                        let _e960 = select(_e954, _e955, _e959);
                                                        let _e961 = abs(_e944);
                                                        if (_e960 != _e960) {
                                                            phi_3189_ = true;
                                                        } else {
                                                            phi_3189_ = (_e961 >= _e960);
                                                        }
                                                        let _e965 = phi_3189_;
                                                        let _e966 = select(_e960, _e961, _e965);
                                                        let _e967 = abs(_e946);
                                                        let _e968 = abs(_e947);
                                                        if (_e967 != _e967) {
                                                            phi_3204_ = true;
                                                        } else {
                                                            phi_3204_ = (_e968 >= _e967);
                                                        }
                                                        let _e972 = phi_3204_;
                                                        let _e973 = select(_e967, _e968, _e972);
                                                        let _e974 = abs(_e948);
                                                        if (_e973 != _e973) {
                                                            phi_3219_ = true;
                                                        } else {
                                                            phi_3219_ = (_e974 >= _e973);
                                                        }
                                                        let _e978 = phi_3219_;
                                                        let _e979 = select(_e973, _e974, _e978);
                                                        let _e980 = abs(_e950);
                                                        let _e981 = abs(_e951);
                                                        if (_e980 != _e980) {
                                                            phi_3234_ = true;
                                                        } else {
                                                            phi_3234_ = (_e981 >= _e980);
                                                        }
                                                        let _e985 = phi_3234_;
                                                        let _e986 = select(_e980, _e981, _e985);
                                                        let _e987 = abs(_e952);
                                                        if (_e986 != _e986) {
                                                            phi_3249_ = true;
                                                        } else {
                                                            phi_3249_ = (_e987 >= _e986);
                                                        }
                                                        let _e991 = phi_3249_;
                                                        let _e992 = select(_e986, _e987, _e991);
                                                        let _e994 = select(_e979, _e966, (_e966 > _e979));
                                                        let _e996 = select(_e992, _e994, (_e994 > _e992));
                                                        if (_e966 == _e996) {
                                                            phi_1843_ = _e802;
                                                            phi_1844_ = _e799;
                                                            phi_1845_ = _e793;
                                                            phi_1846_ = _e790;
                                                            phi_1847_ = vec3<f32>(_e771[0][0], _e771[0][1], _e771[0][2]);
                                                            phi_1848_ = _e953;
                                                            phi_1849_ = _e949;
                                                            phi_1850_ = _e945;
                                                        } else {
                                                            let _e998 = (_e979 == _e996);
                                                            let _e1003 = vec3(_e998);
                                                            phi_1843_ = select(_e793, _e811, _e998);
                                                            phi_1844_ = select(_e790, _e808, _e998);
                                                            phi_1845_ = select(_e811, _e802, _e998);
                                                            phi_1846_ = select(_e808, _e799, _e998);
                                                            phi_1847_ = select(vec3<f32>(_e771[2][0], _e771[2][1], _e771[2][2]), vec3<f32>(_e771[1][0], _e771[1][1], _e771[1][2]), _e1003);
                                                            phi_1848_ = select(_e949, _e945, _e1003);
                                                            phi_1849_ = select(_e945, _e953, _e1003);
                                                            phi_1850_ = select(_e953, _e949, _e1003);
                                                        }
                                                        let _e1009 = phi_1843_;
                                                        let _e1011 = phi_1844_;
                                                        let _e1013 = phi_1845_;
                                                        let _e1015 = phi_1846_;
                                                        let _e1017 = phi_1847_;
                                                        let _e1019 = phi_1848_;
                                                        let _e1021 = phi_1849_;
                                                        let _e1023 = phi_1850_;
                                                        let _e1030 = ((_e1021.y * _e1019.z) - (_e1019.y * _e1021.z));
                                                        let _e1035 = ((_e1021.z * _e1019.x) - (_e1019.z * _e1021.x));
                                                        let _e1038 = ((_e1021.x * _e1019.y) - (_e1019.x * _e1021.y));
                                                        let _e1041 = ((_e834 >= _e838) && (_e834 >= _e842));
                                                        let _e1042 = (_e838 >= _e842);
                                                        let _e1056 = (((_e1030 * (select(select(_e771[2][0], _e771[1][0], _e1042), _e771[0][0], _e1041) - _e311)) + (_e1035 * (select(select(_e771[2][1], _e771[1][1], _e1042), _e771[0][1], _e1041) - _e378))) + (_e1038 * (select(select(_e771[2][2], _e771[1][2], _e1042), _e771[0][2], _e1041) - _e444)));
                                                        let _e1061 = (((_e1030 * _e348) + (_e1035 * _e414)) + (_e1038 * _e480));
                                                        let _e1062 = (_e1011 - _e1015);
                                                        let _e1063 = (_e1009 - _e1013);
                                                        let _e1066 = ((_e1062 * _e1062) + (_e1063 * _e1063));
                                                        let _e1073 = (-(((_e1015 * _e1062) + (_e1013 * _e1063))) / select(0.000000000000000000000000000000000000011754944f, _e1066, (_e1066 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1075 = select(1f, _e1073, (_e1073 < 1f));
                                                        let _e1077 = select(0f, _e1075, (_e1075 > 0f));
                                                        let _e1086 = ((_e1017.x + (_e1023.x * _e1077)) - _e311);
                                                        let _e1089 = ((_e1017.y + (_e1023.y * _e1077)) - _e378);
                                                        let _e1092 = ((_e1017.z + (_e1023.z * _e1077)) - _e444);
                                                        let _e1095 = bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u));
                                                        let _e1098 = bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u));
                                                        let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                        let _e1103 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                        let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                                                        let _e1109 = abs(_e1030);
                                                        let _e1110 = abs(_e1035);
                                                        if (_e1109 != _e1109) {
                                                            phi_3264_ = true;
                                                        } else {
                                                            phi_3264_ = (_e1110 >= _e1109);
                                                        }
                                                        let _e1114 = phi_3264_;
                                                        let _e1115 = select(_e1109, _e1110, _e1114);
                                                        let _e1116 = abs(_e1038);
                                                        if (_e1115 != _e1115) {
                                                            phi_3279_ = true;
                                                        } else {
                                                            phi_3279_ = (_e1116 >= _e1115);
                                                        }
                                                        let _e1120 = phi_3279_;
                                                        let _e1136 = abs(_e1021.x);
                                                        let _e1137 = abs(_e1021.y);
                                                        if (_e1136 != _e1136) {
                                                            phi_3294_ = true;
                                                        } else {
                                                            phi_3294_ = (_e1137 >= _e1136);
                                                        }
                                                        let _e1141 = phi_3294_;
                                                        let _e1142 = select(_e1136, _e1137, _e1141);
                                                        let _e1143 = abs(_e1021.z);
                                                        if (_e1142 != _e1142) {
                                                            phi_3309_ = true;
                                                        } else {
                                                            phi_3309_ = (_e1143 >= _e1142);
                                                        }
                                                        let _e1147 = phi_3309_;
                                                        let _e1150 = abs(_e1019.x);
                                                        let _e1151 = abs(_e1019.y);
                                                        if (_e1150 != _e1150) {
                                                            phi_3324_ = true;
                                                        } else {
                                                            phi_3324_ = (_e1151 >= _e1150);
                                                        }
                                                        let _e1155 = phi_3324_;
                                                        let _e1156 = select(_e1150, _e1151, _e1155);
                                                        let _e1157 = abs(_e1019.z);
                                                        if (_e1156 != _e1156) {
                                                            phi_3339_ = true;
                                                        } else {
                                                            phi_3339_ = (_e1157 >= _e1156);
                                                        }
                                                        let _e1161 = phi_3339_;
                                                        let _e1166 = ((bitcast<f32>((bitcast<u32>(((((_e1030 * _e1086) + (_e1035 * _e1089)) + (_e1038 * _e1092)) - _e1056)) & 2147483647u)) <= ((0.0000009536743f * select(_e996, _e1105, (_e1105 > _e996))) * select(_e1115, _e1116, _e1120))) && !((bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u)) <= ((0.0000038146973f * select(_e1142, _e1143, _e1147)) * select(_e1156, _e1157, _e1161)))));
                                                        let _e1167 = (_e1056 / _e1061);
                                                        if (_e937 && !(_e1166)) {
                                                            let _e1170 = (_e1092 / _e480);
                                                            let _e1178 = (((_e1030 * (_e1086 - (_e348 * _e1170))) + (_e1035 * (_e1089 - (_e414 * _e1170)))) / _e1061);
                                                            phi_2058_ = select(select(_e1170, (_e1170 + _e1178), (bitcast<f32>((bitcast<u32>(_e1178) & 2147483647u)) <= _e996)), _e1167, _e1166);
                                                        } else {
                                                            phi_2058_ = _e1167;
                                                        }
                                                        let _e1187 = phi_2058_;
                                                        let _e1189 = select(_e900, _e1187, (_e1187 < _e900));
                                                        let _e1191 = select(_e892, _e1189, (_e1189 > _e892));
                                                        let _e1192 = (1f / _e844);
                                                        phi_2078_ = type_34(_e1191, (_e838 * _e1192), (_e842 * _e1192), ((_e937 && (_e1191 >= _e587)) && (_e1191 <= _e675.member)));
                                                        phi_2079_ = type_34();
                                                    } else {
                                                        phi_2078_ = type_34();
                                                        phi_2079_ = type_34(0f, 0f, 0f, _e937);
                                                    }
                                                    let _e1201 = phi_2078_;
                                                    let _e1203 = phi_2079_;
                                                    phi_2082_ = _e1201;
                                                    phi_2083_ = _e1203;
                                                    phi_2084_ = select(true, false, _e937);
                                                } else {
                                                    phi_2082_ = type_34();
                                                    phi_2083_ = type_34(0f, 0f, 0f, _e828);
                                                    phi_2084_ = true;
                                                }
                                                let _e1206 = phi_2082_;
                                                let _e1208 = phi_2083_;
                                                let _e1210 = phi_2084_;
                                                if _e1210 {
                                                    phi_2088_ = _e1208;
                                                } else {
                                                    phi_2088_ = _e1206;
                                                }
                                                let _e1212 = phi_2088_;
                                                if _e1212.member_3 {
                                                    phi_2097_ = type_25(_e1212.member, _e1212.member_1, _e1212.member_2, _e704);
                                                } else {
                                                    phi_2097_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1219 = phi_2097_;
                                                if (_e1219.member_3 != 4294967295u) {
                                                    if (_e704 != 4294967295u) {
                                                        phi_2108_ = type_38(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2108_ = _e675;
                                                    }
                                                    let _e1224 = phi_2108_;
                                                    phi_2109_ = _e1224;
                                                } else {
                                                    phi_2109_ = _e675;
                                                }
                                                let _e1226 = phi_2109_;
                                                phi_1163_ = _e1226;
                                            } else {
                                                phi_1163_ = type_38();
                                            }
                                            let _e1228 = phi_1163_;
                                            continue;
                                            continuing {
                                                phi_1162_ = _e1228;
                                                phi_1165_ = _e690;
                                                phi_3373_ = _e619;
                                                break if !(_e696);
                                            }
                                        }
                                        let _e1231 = phi_3373_;
                                        phi_3535_ = _e1231;
                                        if _e1231 {
                                            break;
                                        }
                                        phi_3594_ = _e1231;
                                        let _e1740 = local_11;
                                        phi_2110_ = _e1740;
                                    } else {
                                        phi_3594_ = _e619;
                                        phi_2110_ = _e621;
                                    }
                                    let _e1233 = phi_3594_;
                                    let _e1235 = phi_2110_;
                                    if _e668 {
                                        phi_3117_ = bool();
                                        phi_3118_ = u32();
                                        phi_3119_ = type_49();
                                    } else {
                                        let _e1236 = (_e664.member_1 < _e85);
                                        if _e1236 {
                                            if _e1236 {
                                            } else {
                                                phi_3535_ = true;
                                                break;
                                            }
                                            let _e1238 = global_6.member[_e664.member_1];
                                            phi_2131_ = _e1238;
                                        } else {
                                            phi_2131_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1240 = phi_2131_;
                                        let _e1255 = ((10u * _e247) & 31u);
                                        let _e1258 = ((_e1240.member[0] >> bitcast<u32>(_e1255)) & 1023u);
                                        let _e1266 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[0] - _e664.member.member[0]) * 0.0009775171f)) ^ _e119));
                                        let _e1271 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1258)) - 8388608f) * _e1266)) ^ _e119)));
                                        let _e1275 = select(select(_e664.member.member_1[0], _e1271, (_e1271 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1258 == 1023u));
                                        let _e1277 = ((10u * _e246) & 31u);
                                        let _e1280 = ((_e1240.member[0] >> bitcast<u32>(_e1277)) & 1023u);
                                        let _e1288 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[1] - _e664.member.member[1]) * 0.0009775171f)) ^ _e119));
                                        let _e1293 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1280)) - 8388608f) * _e1288)) ^ _e119)));
                                        let _e1297 = select(select(_e664.member.member_1[1], _e1293, (_e1293 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1280 == 1023u));
                                        let _e1299 = ((10u * _e248) & 31u);
                                        let _e1302 = ((_e1240.member[0] >> bitcast<u32>(_e1299)) & 1023u);
                                        let _e1310 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[2] - _e664.member.member[2]) * 0.0009775171f)) ^ _e119));
                                        let _e1315 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1302)) - 8388608f) * _e1310)) ^ _e119)));
                                        let _e1319 = select(select(_e664.member.member_1[2], _e1315, (_e1315 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1302 == 1023u));
                                        let _e1322 = ((_e1240.member[1] >> bitcast<u32>(_e1255)) & 1023u);
                                        let _e1330 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1322)) - 8388608f) * _e1266)) ^ _e119)));
                                        let _e1334 = select(select(_e664.member.member_1[0], _e1330, (_e1330 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1322 == 1023u));
                                        let _e1337 = ((_e1240.member[1] >> bitcast<u32>(_e1277)) & 1023u);
                                        let _e1345 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1337)) - 8388608f) * _e1288)) ^ _e119)));
                                        let _e1349 = select(select(_e664.member.member_1[1], _e1345, (_e1345 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1337 == 1023u));
                                        let _e1352 = ((_e1240.member[1] >> bitcast<u32>(_e1299)) & 1023u);
                                        let _e1360 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1352)) - 8388608f) * _e1310)) ^ _e119)));
                                        let _e1364 = select(select(_e664.member.member_1[2], _e1360, (_e1360 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1352 == 1023u));
                                        let _e1370 = ((_e1240.member_1[0] >> bitcast<u32>(_e1255)) & 1023u);
                                        let _e1378 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1370)) - 8388608f) * _e1266)) ^ _e119)));
                                        let _e1382 = select(select(_e664.member.member_1[0], _e1378, (_e1378 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1370 == 1023u));
                                        let _e1385 = ((_e1240.member_1[0] >> bitcast<u32>(_e1277)) & 1023u);
                                        let _e1393 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1385)) - 8388608f) * _e1288)) ^ _e119)));
                                        let _e1397 = select(select(_e664.member.member_1[1], _e1393, (_e1393 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1385 == 1023u));
                                        let _e1400 = ((_e1240.member_1[0] >> bitcast<u32>(_e1299)) & 1023u);
                                        let _e1408 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1400)) - 8388608f) * _e1310)) ^ _e119)));
                                        let _e1412 = select(select(_e664.member.member_1[2], _e1408, (_e1408 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1400 == 1023u));
                                        let _e1415 = ((_e1240.member_1[1] >> bitcast<u32>(_e1255)) & 1023u);
                                        let _e1423 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1415)) - 8388608f) * _e1266)) ^ _e119)));
                                        let _e1427 = select(select(_e664.member.member_1[0], _e1423, (_e1423 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1415 == 1023u));
                                        let _e1430 = ((_e1240.member_1[1] >> bitcast<u32>(_e1277)) & 1023u);
                                        let _e1438 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1430)) - 8388608f) * _e1288)) ^ _e119)));
                                        let _e1442 = select(select(_e664.member.member_1[1], _e1438, (_e1438 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1430 == 1023u));
                                        let _e1445 = ((_e1240.member_1[1] >> bitcast<u32>(_e1299)) & 1023u);
                                        let _e1453 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1445)) - 8388608f) * _e1310)) ^ _e119)));
                                        let _e1457 = select(select(_e664.member.member_1[2], _e1453, (_e1453 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1445 == 1023u));
                                        let _e1462 = type_49(type_47(array<f32, 3>(_e1275, _e1297, _e1319), array<f32, 3>(_e1334, _e1349, _e1364)), _e1240.member_2);
                                        let _e1467 = type_49(type_47(array<f32, 3>(_e1382, _e1397, _e1412), array<f32, 3>(_e1427, _e1442, _e1457)), _e1240.member_3);
                                        let _e1473 = ((_e1275 - _e349) * _e352);
                                        let _e1474 = ((_e1382 - _e349) * _e352);
                                        let _e1475 = ((_e1334 - _e350) * _e352);
                                        let _e1476 = ((_e1427 - _e350) * _e352);
                                        let _e1481 = ((_e1297 - _e415) * _e418);
                                        let _e1482 = ((_e1397 - _e415) * _e418);
                                        let _e1483 = ((_e1349 - _e416) * _e418);
                                        let _e1484 = ((_e1442 - _e416) * _e418);
                                        let _e1489 = ((_e1319 - _e481) * _e484);
                                        let _e1490 = ((_e1412 - _e481) * _e484);
                                        let _e1491 = ((_e1364 - _e482) * _e484);
                                        let _e1492 = ((_e1457 - _e482) * _e484);
                                        let _e1494 = select(_e1491, _e1489, (_e1489 < _e1491));
                                        let _e1496 = select(_e1492, _e1490, (_e1490 < _e1492));
                                        let _e1498 = select(_e1491, _e1489, (_e1489 > _e1491));
                                        let _e1500 = select(_e1492, _e1490, (_e1490 > _e1492));
                                        let _e1502 = select(_e1475, _e1473, (_e1473 < _e1475));
                                        let _e1504 = select(_e1476, _e1474, (_e1474 < _e1476));
                                        let _e1506 = select(_e1483, _e1481, (_e1481 < _e1483));
                                        let _e1508 = select(_e1484, _e1482, (_e1482 < _e1484));
                                        let _e1510 = select(_e1506, _e1502, (_e1502 > _e1506));
                                        let _e1512 = select(_e1508, _e1504, (_e1504 > _e1508));
                                        let _e1514 = select(_e1494, _e1510, (_e1510 > _e1494));
                                        let _e1516 = select(_e1496, _e1512, (_e1512 > _e1496));
                                        let _e1518 = select(_e1475, _e1473, (_e1473 > _e1475));
                                        let _e1520 = select(_e1476, _e1474, (_e1474 > _e1476));
                                        let _e1522 = select(_e1483, _e1481, (_e1481 > _e1483));
                                        let _e1524 = select(_e1484, _e1482, (_e1482 > _e1484));
                                        let _e1526 = select(_e1522, _e1518, (_e1518 < _e1522));
                                        let _e1528 = select(_e1524, _e1520, (_e1520 < _e1524));
                                        let _e1533 = -(_e1494);
                                        let _e1534 = -(_e1496);
                                        let _e1541 = (select(_e1498, _e1526, (_e1526 < _e1498)) + (select(_e1533, _e1498, (_e1498 > _e1533)) * 0.0000019073523f));
                                        let _e1542 = (select(_e1500, _e1528, (_e1528 < _e1500)) + (select(_e1534, _e1500, (_e1500 > _e1534)) * 0.0000019073523f));
                                        let _e1544 = select(_e587, _e1514, (_e1514 > _e587));
                                        let _e1546 = select(_e587, _e1516, (_e1516 > _e587));
                                        let _e1551 = (_e1544 <= select(_e1235.member, _e1541, (_e1541 < _e1235.member)));
                                        let _e1552 = (_e1546 <= select(_e1235.member, _e1542, (_e1542 < _e1235.member)));
                                        let _e1553 = (_e1544 <= _e1546);
                                        if _e1551 {
                                            if _e1552 {
                                                if _e1553 {
                                                    phi_3017_ = _e1467;
                                                } else {
                                                    phi_3017_ = _e1462;
                                                }
                                                let _e1555 = phi_3017_;
                                                let _e1562 = (_e662 % 128u);
                                                let _e1563 = (_e1562 < 128u);
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_6[_e1562] = _e1555.member_1;
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_5[_e1562] = _e1555.member.member[0];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_4[_e1562] = _e1555.member.member[1];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_3[_e1562] = _e1555.member.member[2];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_2[_e1562] = _e1555.member.member_1[0];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_1[_e1562] = _e1555.member.member_1[1];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local[_e1562] = _e1555.member.member_1[2];
                                                if _e1563 {
                                                } else {
                                                    phi_3535_ = true;
                                                    break;
                                                }
                                                local_7[_e1562] = select(_e1544, _e1546, _e1553);
                                                if _e1553 {
                                                    phi_3093_ = _e1462;
                                                } else {
                                                    phi_3093_ = _e1467;
                                                }
                                                let _e1580 = phi_3093_;
                                                phi_3094_ = (_e662 + 1u);
                                                phi_3095_ = _e1580;
                                            } else {
                                                phi_3094_ = u32();
                                                phi_3095_ = type_49();
                                            }
                                            let _e1582 = phi_3094_;
                                            let _e1584 = phi_3095_;
                                            phi_3097_ = _e1582;
                                            phi_3098_ = _e1584;
                                            phi_3099_ = select(true, false, _e1552);
                                        } else {
                                            phi_3097_ = u32();
                                            phi_3098_ = type_49();
                                            phi_3099_ = true;
                                        }
                                        let _e1587 = phi_3097_;
                                        let _e1589 = phi_3098_;
                                        let _e1591 = phi_3099_;
                                        if _e1591 {
                                            if _e1551 {
                                                phi_3106_ = _e1462;
                                            } else {
                                                phi_3106_ = _e1467;
                                            }
                                            let _e1593 = phi_3106_;
                                            phi_3111_ = select(_e1552, true, _e1551);
                                            phi_3113_ = _e1593;
                                        } else {
                                            phi_3111_ = _e660;
                                            phi_3113_ = _e1589;
                                        }
                                        let _e1596 = phi_3111_;
                                        let _e1598 = phi_3113_;
                                        phi_3117_ = _e1596;
                                        phi_3118_ = select(_e1587, _e662, _e1591);
                                        phi_3119_ = _e1598;
                                    }
                                    let _e1601 = phi_3117_;
                                    let _e1603 = phi_3118_;
                                    let _e1605 = phi_3119_;
                                    if _e668 {
                                        phi_3129_ = select(_e662, 0u, _e1235.member_1);
                                        phi_3130_ = _e664;
                                    } else {
                                        phi_3129_ = _e1603;
                                        phi_3130_ = _e1605;
                                    }
                                    let _e1609 = phi_3129_;
                                    let _e1611 = phi_3130_;
                                    phi_3538_ = _e1233;
                                    phi_3131_ = _e1235;
                                    phi_3132_ = (_e623 - 1u);
                                    phi_3133_ = select(_e1601, false, _e668);
                                    phi_3134_ = _e1609;
                                    phi_3135_ = _e1611;
                                } else {
                                    phi_3538_ = _e619;
                                    phi_3131_ = _e621;
                                    phi_3132_ = _e623;
                                    phi_3133_ = _e660;
                                    phi_3134_ = _e662;
                                    phi_3135_ = _e664;
                                }
                                let _e1614 = phi_3538_;
                                let _e1616 = phi_3131_;
                                let _e1618 = phi_3132_;
                                let _e1620 = phi_3133_;
                                let _e1622 = phi_3134_;
                                let _e1624 = phi_3135_;
                                phi_3537_ = _e1614;
                                phi_3136_ = _e1616;
                                phi_3137_ = _e1618;
                                phi_3138_ = _e1620;
                                phi_3139_ = _e1622;
                                phi_3140_ = _e1624;
                            } else {
                                phi_3537_ = _e619;
                                phi_3136_ = type_38();
                                phi_3137_ = u32();
                                phi_3138_ = bool();
                                phi_3139_ = u32();
                                phi_3140_ = type_49();
                            }
                            let _e1626 = phi_3537_;
                            let _e1628 = phi_3136_;
                            let _e1630 = phi_3137_;
                            let _e1632 = phi_3138_;
                            let _e1634 = phi_3139_;
                            let _e1636 = phi_3140_;
                            phi_3536_ = _e1626;
                            phi_1037_ = _e1628;
                            phi_1040_ = _e1630;
                            phi_1042_ = _e1632;
                            phi_1044_ = _e1634;
                            phi_1046_ = _e1636;
                            phi_3141_ = _e633;
                        } else {
                            phi_3536_ = _e619;
                            phi_1037_ = type_38();
                            phi_1040_ = u32();
                            phi_1042_ = bool();
                            phi_1044_ = u32();
                            phi_1046_ = type_49();
                            phi_3141_ = false;
                        }
                        let _e1638 = phi_3536_;
                        let _e1640 = phi_1037_;
                        let _e1642 = phi_1040_;
                        let _e1644 = phi_1042_;
                        let _e1646 = phi_1044_;
                        let _e1648 = phi_1046_;
                        let _e1650 = phi_3141_;
                        continue;
                        continuing {
                            phi_3379_ = _e1638;
                            phi_1036_ = _e1640;
                            phi_1039_ = _e1642;
                            phi_1041_ = _e1644;
                            phi_1043_ = _e1646;
                            phi_1045_ = _e1648;
                            phi_3535_ = _e1638;
                            break if !(_e1650);
                        }
                    }
                    let _e1653 = phi_3535_;
                    if _e1653 {
                        break;
                    }
                    let _e1655 = local_10;
                    if _e135 {
                    } else {
                        break;
                    }
                    global_5.member[_e133] = select(0u, 1u, _e1655.member_1);
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
