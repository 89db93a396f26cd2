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

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_37 {
    member: array<type_26>,
}

struct type_39 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_48 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_50 {
    member: type_48,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_368_: i32;
    var phi_369_: i32;
    var phi_379_: bool;
    var phi_389_: u32;
    var phi_390_: u32;
    var phi_392_: bool;
    var phi_397_: u32;
    var phi_410_: i32;
    var phi_430_: i32;
    var phi_448_: f32;
    var phi_454_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_619_: f32;
    var phi_625_: f32;
    var phi_698_: f32;
    var phi_704_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_869_: i32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_929_: i32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_960_: f32;
    var phi_961_: f32;
    var phi_3340_: bool;
    var phi_1045_: type_39;
    var phi_1048_: bool;
    var phi_1050_: type_50;
    var phi_1052_: u32;
    var phi_1054_: u32;
    var phi_1065_: bool;
    var phi_1151_: bool;
    var phi_1152_: type_50;
    var phi_1153_: u32;
    var phi_2136_: type_43;
    var phi_3025_: type_50;
    var phi_3101_: type_50;
    var phi_3102_: type_50;
    var phi_3103_: u32;
    var phi_3105_: type_50;
    var phi_3106_: u32;
    var phi_3107_: bool;
    var phi_3114_: type_50;
    var phi_3119_: bool;
    var phi_3120_: type_50;
    var phi_1171_: type_39;
    var phi_1174_: type_4;
    var phi_1175_: type_4;
    var phi_1197_: type_4;
    var phi_1221_: u32;
    var phi_1313_: array<array<f32, 3>, 3>;
    var phi_1843_: f32;
    var phi_1844_: f32;
    var phi_1845_: f32;
    var phi_1846_: f32;
    var phi_1847_: vec3<f32>;
    var phi_1848_: vec3<f32>;
    var phi_1849_: vec3<f32>;
    var phi_1850_: vec3<f32>;
    var phi_2041_: f32;
    var phi_2061_: type_35;
    var phi_2062_: type_35;
    var phi_2065_: type_35;
    var phi_2066_: type_35;
    var phi_2067_: bool;
    var phi_2071_: type_35;
    var phi_2080_: type_25;
    var phi_2105_: bool;
    var phi_2106_: bool;
    var phi_2113_: type_39;
    var phi_2114_: type_39;
    var phi_2115_: type_39;
    var phi_1172_: type_39;
    var phi_3334_: bool;
    var local_10: type_39;
    var phi_3491_: bool;
    var phi_3122_: type_39;
    var phi_3123_: bool;
    var phi_3124_: type_50;
    var phi_3125_: u32;
    var phi_3490_: bool;
    var phi_3126_: type_39;
    var phi_3127_: bool;
    var phi_3128_: type_50;
    var phi_3129_: u32;
    var phi_3130_: u32;
    var phi_3489_: bool;
    var phi_3131_: type_39;
    var phi_3132_: bool;
    var phi_3133_: type_50;
    var phi_3134_: u32;
    var phi_3135_: u32;
    var phi_3488_: bool;
    var phi_1046_: type_39;
    var phi_1049_: bool;
    var phi_1051_: type_50;
    var phi_1053_: u32;
    var phi_1055_: u32;
    var phi_3136_: bool;
    var phi_3487_: bool;
    var local_11: type_39;
    var local_12: type_39;
    var local_13: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e117 = global_3.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e80.x + (_e80.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_4.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_6.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_4.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_4.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_4.member[_e131].member_1;
                    let _e193 = bitcast<u32>(_e192);
                    let _e194 = (_e193 & 2147483647u);
                    let _e201 = global_4.member[_e131].member_3;
                    let _e202 = bitcast<u32>(_e201);
                    let _e203 = (_e202 & 2147483647u);
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && (_e203 <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_368_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_368_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_368_;
                        phi_369_ = _e224;
                    } else {
                        phi_369_ = 0i;
                    }
                    let _e226 = phi_369_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_379_ = true;
                    } else {
                        phi_379_ = (_e150 == _e182);
                    }
                    let _e230 = phi_379_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_389_ = _e232;
                        phi_390_ = _e232;
                        phi_392_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_389_ = u32();
                        phi_390_ = 0u;
                        phi_392_ = true;
                    }
                    let _e236 = phi_389_;
                    let _e238 = phi_390_;
                    let _e240 = phi_392_;
                    if _e240 {
                        phi_397_ = (_e238 + 1u);
                    } else {
                        phi_397_ = 0u;
                    }
                    let _e244 = phi_397_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_410_ = -126i;
                    } else {
                        phi_410_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_410_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_430_ = -126i;
                    } else {
                        phi_430_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_430_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_4.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_448_ = _e283[0];
                    } else {
                        phi_448_ = _e283[1];
                    }
                    let _e288 = phi_448_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_454_ = _e283[2];
                    } else {
                        phi_454_ = _e288;
                    }
                    let _e292 = phi_454_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_4.member[_e131].member_2;
                    if _e284 {
                        phi_494_ = _e310[0];
                    } else {
                        phi_494_ = _e310[1];
                    }
                    let _e314 = phi_494_;
                    if _e289 {
                        phi_500_ = _e310[2];
                    } else {
                        phi_500_ = _e314;
                    }
                    let _e317 = phi_500_;
                    let _e318 = bitcast<u32>(_e317);
                    let _e320 = ((_e318 & 2139095040u) != 0u);
                    let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e273) * select(0.00000011920929f, 1f, _e320)) * _e279);
                    let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e341 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                    let _e342 = (_e341 * 0.00000011920929f);
                    let _e345 = select(select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f)), 0f, _e338);
                    let _e346 = select(0f, _e334, _e338);
                    let _e347 = (_e309 + _e345);
                    let _e348 = (_e309 - _e345);
                    let _e350 = select(38685626000000000000000000f, (1f / _e334), _e338);
                    let _e351 = (_e244 == 0u);
                    if _e351 {
                        phi_573_ = _e283[0];
                    } else {
                        phi_573_ = _e283[1];
                    }
                    let _e355 = phi_573_;
                    let _e356 = (_e244 == 2u);
                    if _e356 {
                        phi_579_ = _e283[2];
                    } else {
                        phi_579_ = _e355;
                    }
                    let _e359 = phi_579_;
                    let _e360 = bitcast<u32>(_e359);
                    let _e362 = ((_e360 & 2139095040u) != 0u);
                    let _e376 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e360 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e360 & 2147483648u))), _e359, _e362) * _e256) * select(0.00000011920929f, 1f, _e362)) * _e262);
                    if _e351 {
                        phi_619_ = _e310[0];
                    } else {
                        phi_619_ = _e310[1];
                    }
                    let _e380 = phi_619_;
                    if _e356 {
                        phi_625_ = _e310[2];
                    } else {
                        phi_625_ = _e380;
                    }
                    let _e383 = phi_625_;
                    let _e384 = bitcast<u32>(_e383);
                    let _e386 = ((_e384 & 2139095040u) != 0u);
                    let _e400 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e384 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e384 & 2147483648u))), _e383, _e386) * _e273) * select(0.00000011920929f, 1f, _e386)) * _e279);
                    let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e407 = bitcast<f32>((bitcast<u32>(_e376) & 2147483647u));
                    let _e408 = (_e407 * 0.00000011920929f);
                    let _e411 = select(select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f)), 0f, _e404);
                    let _e412 = select(0f, _e400, _e404);
                    let _e413 = (_e376 + _e411);
                    let _e414 = (_e376 - _e411);
                    let _e416 = select(38685626000000000000000000f, (1f / _e400), _e404);
                    let _e417 = (_e246 == 0u);
                    if _e417 {
                        phi_698_ = _e283[0];
                    } else {
                        phi_698_ = _e283[1];
                    }
                    let _e421 = phi_698_;
                    let _e422 = (_e246 == 2u);
                    if _e422 {
                        phi_704_ = _e283[2];
                    } else {
                        phi_704_ = _e421;
                    }
                    let _e425 = phi_704_;
                    let _e426 = bitcast<u32>(_e425);
                    let _e428 = ((_e426 & 2139095040u) != 0u);
                    let _e442 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e426 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e426 & 2147483648u))), _e425, _e428) * _e256) * select(0.00000011920929f, 1f, _e428)) * _e262);
                    if _e417 {
                        phi_744_ = _e310[0];
                    } else {
                        phi_744_ = _e310[1];
                    }
                    let _e446 = phi_744_;
                    if _e422 {
                        phi_750_ = _e310[2];
                    } else {
                        phi_750_ = _e446;
                    }
                    let _e449 = phi_750_;
                    let _e450 = bitcast<u32>(_e449);
                    let _e452 = ((_e450 & 2139095040u) != 0u);
                    let _e466 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e450 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e450 & 2147483648u))), _e449, _e452) * _e273) * select(0.00000011920929f, 1f, _e452)) * _e279);
                    let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e473 = bitcast<f32>((bitcast<u32>(_e442) & 2147483647u));
                    let _e474 = (_e473 * 0.00000011920929f);
                    let _e477 = select(select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f)), 0f, _e470);
                    let _e478 = select(0f, _e466, _e470);
                    let _e479 = (_e442 + _e477);
                    let _e480 = (_e442 - _e477);
                    let _e482 = select(38685626000000000000000000f, (1f / _e466), _e470);
                    let _e484 = select(_e407, _e341, (_e341 > _e407));
                    let _e487 = (_e121 + _e226);
                    if (_e207 && (select(_e473, _e484, (_e484 > _e473)) <= 1099511600000f)) {
                        let _e497 = ((_e194 & 8388607u) | (select(0u, 1u, ((_e194 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e500 = bitcast<i32>((_e194 >> bitcast<u32>(23i)));
                        let _e504 = (_e497 == 0u);
                        let _e507 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e497)), 32u, _e504)) - 8i);
                        if (_e500 == 255i) {
                            phi_869_ = 255i;
                        } else {
                            phi_869_ = (((_e500 + select(0i, 1i, (_e500 == 0i))) - _e507) + _e487);
                        }
                        let _e515 = phi_869_;
                        let _e525 = (_e515 <= 0i);
                        if _e525 {
                            phi_892_ = u32();
                        } else {
                            if _e504 {
                                phi_891_ = u32();
                            } else {
                                phi_891_ = select(((bitcast<u32>(_e515) << bitcast<u32>(23i)) | ((_e497 << bitcast<u32>(((_e507 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e515 >= 255i));
                            }
                            let _e529 = phi_891_;
                            phi_892_ = _e529;
                        }
                        let _e531 = phi_892_;
                        let _e543 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e546 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e550 = (_e543 == 0u);
                        let _e553 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e543)), 32u, _e550)) - 8i);
                        if (_e546 == 255i) {
                            phi_929_ = 255i;
                        } else {
                            phi_929_ = (((_e546 + select(0i, 1i, (_e546 == 0i))) - _e553) + _e487);
                        }
                        let _e561 = phi_929_;
                        let _e571 = (_e561 <= 0i);
                        if _e571 {
                            phi_952_ = u32();
                        } else {
                            if _e550 {
                                phi_951_ = u32();
                            } else {
                                phi_951_ = select(((bitcast<u32>(_e561) << bitcast<u32>(23i)) | ((_e543 << bitcast<u32>(((_e553 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e561 >= 255i));
                            }
                            let _e575 = phi_951_;
                            phi_952_ = _e575;
                        }
                        let _e577 = phi_952_;
                        phi_960_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e577, 0u, select(_e550, true, _e571))));
                        phi_961_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e531, 0u, select(_e504, true, _e525))));
                    } else {
                        phi_960_ = 0f;
                        phi_961_ = 1f;
                    }
                    let _e583 = phi_960_;
                    let _e585 = phi_961_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e593 = (_e245 % 3u);
                    let _e594 = (_e593 < 3u);
                    if _e594 {
                    } else {
                        break;
                    }
                    let _e596 = local_9[_e593];
                    let _e597 = (_e244 % 3u);
                    let _e598 = (_e597 < 3u);
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e600 = local_9[_e597];
                    let _e601 = (_e246 % 3u);
                    let _e602 = (_e601 < 3u);
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e604 = local_9[_e601];
                    local_8 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
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
                    phi_3340_ = false;
                    phi_1045_ = type_39(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e583), 0u, 0u);
                    phi_1048_ = (_e585 <= _e583);
                    phi_1050_ = type_50(type_48(array<f32, 3>(_e596, _e600, _e604), array<f32, 3>(_e608, _e610, _e612)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_1052_ = 0u;
                    phi_1054_ = ((3u * _e83) + 1u);
                    loop {
                        let _e618 = phi_3340_;
                        let _e620 = phi_1045_;
                        let _e622 = phi_1048_;
                        let _e624 = phi_1050_;
                        let _e626 = phi_1052_;
                        let _e628 = phi_1054_;
                        local_11 = _e620;
                        local_12 = _e620;
                        if _e622 {
                            phi_1065_ = true;
                        } else {
                            phi_1065_ = (_e626 > 0u);
                        }
                        let _e631 = phi_1065_;
                        if _e631 {
                            let _e632 = (_e628 > 0u);
                            if _e632 {
                                if _e622 {
                                    phi_1151_ = _e622;
                                    phi_1152_ = _e624;
                                    phi_1153_ = _e626;
                                } else {
                                    let _e633 = (_e626 - 1u);
                                    let _e634 = (_e633 % 128u);
                                    let _e635 = (_e634 < 128u);
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e637 = local_6[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e639 = local_5[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e641 = local_4[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e643 = local_3[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e646 = local_2[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e648 = local_1[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e650 = local[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3487_ = true;
                                        break;
                                    }
                                    let _e655 = local_7[_e634];
                                    phi_1151_ = (_e655 <= _e620.member.member_1);
                                    phi_1152_ = type_50(type_48(array<f32, 3>(_e639, _e641, _e643), array<f32, 3>(_e646, _e648, _e650)), _e637);
                                    phi_1153_ = _e633;
                                }
                                let _e660 = phi_1151_;
                                let _e662 = phi_1152_;
                                let _e664 = phi_1153_;
                                if _e660 {
                                    if ((_e662.member_1 & 2147483648u) != 0u) {
                                        phi_1171_ = _e620;
                                        phi_1174_ = type_4(0u, ((_e662.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1046 = phi_1171_;
                                            let _e1048 = phi_1174_;
                                            local_10 = _e1046;
                                            local_13 = _e1046;
                                            if (_e1048.member < _e1048.member_1) {
                                                phi_1175_ = type_4((_e1048.member + 1u), _e1048.member_1);
                                                phi_1197_ = type_4(1u, _e1048.member);
                                            } else {
                                                phi_1175_ = _e1048;
                                                phi_1197_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1061 = phi_1175_;
                                            let _e1063 = phi_1197_;
                                            let _e1067 = (bitcast<i32>(_e1063.member) != 0i);
                                            if _e1067 {
                                                let _e1073 = type_39(_e1046.member, _e1046.member_1, (_e1046.member_2 + 1u));
                                                let _e1074 = ((_e662.member_1 & 268435455u) + _e1063.member_1);
                                                let _e1075 = (_e1074 < _e85);
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1079 = global_2.member[_e1074].member_1;
                                                    phi_1221_ = _e1079;
                                                } else {
                                                    phi_1221_ = 4294967295u;
                                                }
                                                let _e1081 = phi_1221_;
                                                if (_e1074 >= _e85) {
                                                    phi_1313_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1075 {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    if (_e593 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1088 = global_2.member[_e1074].member[_e593];
                                                    if (_e597 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_2.member[_e1074].member[_e597];
                                                    if (_e601 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1100 = global_2.member[_e1074].member[_e601];
                                                    let _e1102 = (3u + _e593);
                                                    if (_e1102 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1108 = global_2.member[_e1074].member[_e1102];
                                                    let _e1109 = (3u + _e597);
                                                    if (_e1109 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1115 = global_2.member[_e1074].member[_e1109];
                                                    let _e1116 = (3u + _e601);
                                                    if (_e1116 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1122 = global_2.member[_e1074].member[_e1116];
                                                    let _e1124 = (6u + _e593);
                                                    if (_e1124 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1130 = global_2.member[_e1074].member[_e1124];
                                                    let _e1131 = (6u + _e597);
                                                    if (_e1131 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1137 = global_2.member[_e1074].member[_e1131];
                                                    let _e1138 = (6u + _e601);
                                                    if (_e1138 < 9u) {
                                                    } else {
                                                        phi_3334_ = true;
                                                        break;
                                                    }
                                                    let _e1144 = global_2.member[_e1074].member[_e1138];
                                                    phi_1313_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1088, _e1094, _e1100), array<f32, 3>(_e1108, _e1115, _e1122), array<f32, 3>(_e1130, _e1137, _e1144));
                                                }
                                                let _e1148 = phi_1313_;
                                                let _e1165 = (_e1148[0][2] - _e442);
                                                let _e1168 = (((_e1148[0][0] - _e309) * _e478) - (_e1165 * _e346));
                                                let _e1171 = (((_e1148[0][1] - _e376) * _e478) - (_e1165 * _e412));
                                                let _e1174 = (_e1148[1][2] - _e442);
                                                let _e1177 = (((_e1148[1][0] - _e309) * _e478) - (_e1174 * _e346));
                                                let _e1180 = (((_e1148[1][1] - _e376) * _e478) - (_e1174 * _e412));
                                                let _e1183 = (_e1148[2][2] - _e442);
                                                let _e1186 = (((_e1148[2][0] - _e309) * _e478) - (_e1183 * _e346));
                                                let _e1189 = (((_e1148[2][1] - _e376) * _e478) - (_e1183 * _e412));
                                                let _e1190 = (_e1186 * _e1180);
                                                let _e1191 = (_e1189 * _e1177);
                                                let _e1192 = (_e1168 * _e1189);
                                                let _e1193 = (_e1171 * _e1186);
                                                let _e1194 = (_e1177 * _e1171);
                                                let _e1195 = (_e1180 * _e1168);
                                                let _e1200 = (((_e1190 >= _e1191) && (_e1192 >= _e1193)) && (_e1194 >= _e1195));
                                                let _e1206 = (_e1200 || (((_e1190 <= _e1191) && (_e1192 <= _e1193)) && (_e1194 <= _e1195)));
                                                if _e1206 {
                                                    let _e1208 = select(-1f, 1f, _e1200);
                                                    let _e1210 = ((_e1190 - _e1191) * _e1208);
                                                    let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                                    let _e1214 = ((_e1192 - _e1193) * _e1208);
                                                    let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                                    let _e1218 = ((_e1194 - _e1195) * _e1208);
                                                    let _e1220 = select(0f, _e1218, (_e1218 > 0f));
                                                    let _e1222 = ((_e1212 + _e1216) + _e1220);
                                                    let _e1224 = select(_e1148[1][0], _e1148[0][0], (_e1148[0][0] < _e1148[1][0]));
                                                    let _e1228 = select(_e1148[1][0], _e1148[0][0], (_e1148[0][0] > _e1148[1][0]));
                                                    let _e1232 = select(_e1148[1][1], _e1148[0][1], (_e1148[0][1] < _e1148[1][1]));
                                                    let _e1236 = select(_e1148[1][1], _e1148[0][1], (_e1148[0][1] > _e1148[1][1]));
                                                    let _e1240 = select(_e1148[1][2], _e1148[0][2], (_e1148[0][2] < _e1148[1][2]));
                                                    let _e1244 = select(_e1148[1][2], _e1148[0][2], (_e1148[0][2] > _e1148[1][2]));
                                                    let _e1249 = ((select(_e1148[2][0], _e1224, (_e1224 < _e1148[2][0])) - _e347) * _e350);
                                                    let _e1250 = ((select(_e1148[2][0], _e1228, (_e1228 > _e1148[2][0])) - _e348) * _e350);
                                                    let _e1253 = ((select(_e1148[2][1], _e1232, (_e1232 < _e1148[2][1])) - _e413) * _e416);
                                                    let _e1254 = ((select(_e1148[2][1], _e1236, (_e1236 > _e1148[2][1])) - _e414) * _e416);
                                                    let _e1257 = ((select(_e1148[2][2], _e1240, (_e1240 < _e1148[2][2])) - _e479) * _e482);
                                                    let _e1258 = ((select(_e1148[2][2], _e1244, (_e1244 > _e1148[2][2])) - _e480) * _e482);
                                                    let _e1260 = select(_e1258, _e1257, (_e1257 < _e1258));
                                                    let _e1262 = select(_e1258, _e1257, (_e1257 > _e1258));
                                                    let _e1264 = select(_e1250, _e1249, (_e1249 < _e1250));
                                                    let _e1266 = select(_e1254, _e1253, (_e1253 < _e1254));
                                                    let _e1268 = select(_e1266, _e1264, (_e1264 > _e1266));
                                                    let _e1270 = select(_e1260, _e1268, (_e1268 > _e1260));
                                                    let _e1272 = select(_e1250, _e1249, (_e1249 > _e1250));
                                                    let _e1274 = select(_e1254, _e1253, (_e1253 > _e1254));
                                                    let _e1276 = select(_e1274, _e1272, (_e1272 < _e1274));
                                                    let _e1278 = select(_e1262, _e1276, (_e1276 < _e1262));
                                                    let _e1279 = -(_e1260);
                                                    let _e1285 = select(_e585, _e1270, (_e1270 > _e585));
                                                    let _e1289 = select(_e1177, _e1168, (_e1168 < _e1177));
                                                    let _e1294 = select(_e1177, _e1168, (_e1168 > _e1177));
                                                    let _e1301 = select(_e1180, _e1171, (_e1171 < _e1180));
                                                    let _e1306 = select(_e1180, _e1171, (_e1171 > _e1180));
                                                    let _e1315 = (((((_e1206 && (_e1222 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1186, _e1289, (_e1289 < _e1186)) <= 0f) && (select(_e1186, _e1294, (_e1294 > _e1186)) >= 0f))) && ((select(_e1189, _e1301, (_e1301 < _e1189)) <= 0f) && (select(_e1189, _e1306, (_e1306 > _e1189)) >= 0f))) && (_e1285 <= (_e1278 + (select(_e1279, _e1262, (_e1262 > _e1279)) * 0.0000019073523f)))) && (_e1285 <= _e1046.member.member_1));
                                                    if _e1315 {
                                                        let _e1320 = (_e1148[1][0] - _e1148[0][0]);
                                                        let _e1321 = (_e1148[1][1] - _e1148[0][1]);
                                                        let _e1322 = (_e1148[1][2] - _e1148[0][2]);
                                                        let _e1323 = vec3<f32>(_e1320, _e1321, _e1322);
                                                        let _e1324 = (_e1148[2][0] - _e1148[1][0]);
                                                        let _e1325 = (_e1148[2][1] - _e1148[1][1]);
                                                        let _e1326 = (_e1148[2][2] - _e1148[1][2]);
                                                        let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                        let _e1328 = (_e1148[0][0] - _e1148[2][0]);
                                                        let _e1329 = (_e1148[0][1] - _e1148[2][1]);
                                                        let _e1330 = (_e1148[0][2] - _e1148[2][2]);
                                                        let _e1331 = vec3<f32>(_e1328, _e1329, _e1330);
                                                        let _e1334 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                        let _e1337 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                        let _e1339 = select(_e1337, _e1334, (_e1334 > _e1337));
                                                        let _e1342 = bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u));
                                                        let _e1344 = select(_e1342, _e1339, (_e1339 > _e1342));
                                                        let _e1347 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                        let _e1350 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                        let _e1352 = select(_e1350, _e1347, (_e1347 > _e1350));
                                                        let _e1355 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                        let _e1357 = select(_e1355, _e1352, (_e1352 > _e1355));
                                                        let _e1360 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                        let _e1363 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                        let _e1365 = select(_e1363, _e1360, (_e1360 > _e1363));
                                                        let _e1368 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                        let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                        let _e1372 = select(_e1357, _e1344, (_e1344 > _e1357));
                                                        let _e1374 = select(_e1370, _e1372, (_e1372 > _e1370));
                                                        if (_e1344 == _e1374) {
                                                            phi_1843_ = _e1180;
                                                            phi_1844_ = _e1177;
                                                            phi_1845_ = _e1171;
                                                            phi_1846_ = _e1168;
                                                            phi_1847_ = vec3<f32>(_e1148[0][0], _e1148[0][1], _e1148[0][2]);
                                                            phi_1848_ = _e1331;
                                                            phi_1849_ = _e1327;
                                                            phi_1850_ = _e1323;
                                                        } else {
                                                            let _e1376 = (_e1357 == _e1374);
                                                            let _e1381 = vec3(_e1376);
                                                            phi_1843_ = select(_e1171, _e1189, _e1376);
                                                            phi_1844_ = select(_e1168, _e1186, _e1376);
                                                            phi_1845_ = select(_e1189, _e1180, _e1376);
                                                            phi_1846_ = select(_e1186, _e1177, _e1376);
                                                            phi_1847_ = select(vec3<f32>(_e1148[2][0], _e1148[2][1], _e1148[2][2]), vec3<f32>(_e1148[1][0], _e1148[1][1], _e1148[1][2]), _e1381);
                                                            phi_1848_ = select(_e1327, _e1323, _e1381);
                                                            phi_1849_ = select(_e1323, _e1331, _e1381);
                                                            phi_1850_ = select(_e1331, _e1327, _e1381);
                                                        }
                                                        let _e1387 = phi_1843_;
                                                        let _e1389 = phi_1844_;
                                                        let _e1391 = phi_1845_;
                                                        let _e1393 = phi_1846_;
                                                        let _e1395 = phi_1847_;
                                                        let _e1397 = phi_1848_;
                                                        let _e1399 = phi_1849_;
                                                        let _e1401 = phi_1850_;
                                                        let _e1408 = ((_e1399.y * _e1397.z) - (_e1397.y * _e1399.z));
                                                        let _e1413 = ((_e1399.z * _e1397.x) - (_e1397.z * _e1399.x));
                                                        let _e1416 = ((_e1399.x * _e1397.y) - (_e1397.x * _e1399.y));
                                                        let _e1419 = ((_e1212 >= _e1216) && (_e1212 >= _e1220));
                                                        let _e1420 = (_e1216 >= _e1220);
                                                        let _e1434 = (((_e1408 * (select(select(_e1148[2][0], _e1148[1][0], _e1420), _e1148[0][0], _e1419) - _e309)) + (_e1413 * (select(select(_e1148[2][1], _e1148[1][1], _e1420), _e1148[0][1], _e1419) - _e376))) + (_e1416 * (select(select(_e1148[2][2], _e1148[1][2], _e1420), _e1148[0][2], _e1419) - _e442)));
                                                        let _e1439 = (((_e1408 * _e346) + (_e1413 * _e412)) + (_e1416 * _e478));
                                                        let _e1440 = (_e1389 - _e1393);
                                                        let _e1441 = (_e1387 - _e1391);
                                                        let _e1444 = ((_e1440 * _e1440) + (_e1441 * _e1441));
                                                        let _e1451 = (-(((_e1393 * _e1440) + (_e1391 * _e1441))) / select(0.000000000000000000000000000000000000011754944f, _e1444, (_e1444 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1453 = select(1f, _e1451, (_e1451 < 1f));
                                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                        let _e1464 = ((_e1395.x + (_e1401.x * _e1455)) - _e309);
                                                        let _e1467 = ((_e1395.y + (_e1401.y * _e1455)) - _e376);
                                                        let _e1470 = ((_e1395.z + (_e1401.z * _e1455)) - _e442);
                                                        let _e1473 = bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u));
                                                        let _e1476 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                        let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                        let _e1481 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                        let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                        let _e1489 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1492 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                        let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                        let _e1497 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                        let _e1516 = bitcast<f32>((bitcast<u32>(_e1399.x) & 2147483647u));
                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1399.y) & 2147483647u));
                                                        let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                        let _e1524 = bitcast<f32>((bitcast<u32>(_e1399.z) & 2147483647u));
                                                        let _e1530 = bitcast<f32>((bitcast<u32>(_e1397.x) & 2147483647u));
                                                        let _e1533 = bitcast<f32>((bitcast<u32>(_e1397.y) & 2147483647u));
                                                        let _e1535 = select(_e1533, _e1530, (_e1530 > _e1533));
                                                        let _e1538 = bitcast<f32>((bitcast<u32>(_e1397.z) & 2147483647u));
                                                        let _e1544 = ((bitcast<f32>((bitcast<u32>(((((_e1408 * _e1464) + (_e1413 * _e1467)) + (_e1416 * _e1470)) - _e1434)) & 2147483647u)) <= ((0.0000009536743f * select(_e1374, _e1483, (_e1483 > _e1374))) * select(_e1497, _e1494, (_e1494 > _e1497)))) && !((bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u)) <= ((0.0000038146973f * select(_e1524, _e1521, (_e1521 > _e1524))) * select(_e1538, _e1535, (_e1535 > _e1538))))));
                                                        let _e1545 = (_e1434 / _e1439);
                                                        if (_e1315 && !(_e1544)) {
                                                            let _e1548 = (_e1470 / _e478);
                                                            let _e1556 = (((_e1408 * (_e1464 - (_e346 * _e1548))) + (_e1413 * (_e1467 - (_e412 * _e1548)))) / _e1439);
                                                            phi_2041_ = select(select(_e1548, (_e1548 + _e1556), (bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u)) <= _e1374)), _e1545, _e1544);
                                                        } else {
                                                            phi_2041_ = _e1545;
                                                        }
                                                        let _e1565 = phi_2041_;
                                                        let _e1567 = select(_e1278, _e1565, (_e1565 < _e1278));
                                                        let _e1569 = select(_e1270, _e1567, (_e1567 > _e1270));
                                                        let _e1570 = (1f / _e1222);
                                                        phi_2061_ = type_35(_e1569, (_e1216 * _e1570), (_e1220 * _e1570), ((_e1315 && (_e1569 >= _e585)) && (_e1569 <= _e1046.member.member_1)));
                                                        phi_2062_ = type_35();
                                                    } else {
                                                        phi_2061_ = type_35();
                                                        phi_2062_ = type_35(0f, 0f, 0f, _e1315);
                                                    }
                                                    let _e1579 = phi_2061_;
                                                    let _e1581 = phi_2062_;
                                                    phi_2065_ = _e1579;
                                                    phi_2066_ = _e1581;
                                                    phi_2067_ = select(true, false, _e1315);
                                                } else {
                                                    phi_2065_ = type_35();
                                                    phi_2066_ = type_35(0f, 0f, 0f, _e1206);
                                                    phi_2067_ = true;
                                                }
                                                let _e1584 = phi_2065_;
                                                let _e1586 = phi_2066_;
                                                let _e1588 = phi_2067_;
                                                if _e1588 {
                                                    phi_2071_ = _e1586;
                                                } else {
                                                    phi_2071_ = _e1584;
                                                }
                                                let _e1590 = phi_2071_;
                                                if _e1590.member_3 {
                                                    phi_2080_ = type_25(_e1590.member, _e1590.member_1, _e1590.member_2, _e1081);
                                                } else {
                                                    phi_2080_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1597 = phi_2080_;
                                                if (_e1597.member_3 != 4294967295u) {
                                                    if (_e1081 != 4294967295u) {
                                                        if (_e1597.member < _e1046.member.member.member) {
                                                            phi_2106_ = true;
                                                        } else {
                                                            if (_e1597.member == _e1046.member.member.member) {
                                                                phi_2105_ = (_e1597.member_3 < _e1046.member.member.member_3);
                                                            } else {
                                                                phi_2105_ = false;
                                                            }
                                                            let _e1612 = phi_2105_;
                                                            phi_2106_ = _e1612;
                                                        }
                                                        let _e1614 = phi_2106_;
                                                        if _e1614 {
                                                            phi_2113_ = type_39(type_32(_e1597, _e1597.member), _e1073.member_1, _e1073.member_2);
                                                        } else {
                                                            phi_2113_ = _e1073;
                                                        }
                                                        let _e1621 = phi_2113_;
                                                        phi_2114_ = _e1621;
                                                    } else {
                                                        phi_2114_ = _e1073;
                                                    }
                                                    let _e1623 = phi_2114_;
                                                    phi_2115_ = _e1623;
                                                } else {
                                                    phi_2115_ = _e1073;
                                                }
                                                let _e1625 = phi_2115_;
                                                phi_1172_ = _e1625;
                                            } else {
                                                phi_1172_ = type_39();
                                            }
                                            let _e1627 = phi_1172_;
                                            continue;
                                            continuing {
                                                phi_1171_ = _e1627;
                                                phi_1174_ = _e1061;
                                                phi_3334_ = _e618;
                                                break if !(_e1067);
                                            }
                                        }
                                        let _e1630 = phi_3334_;
                                        phi_3487_ = _e1630;
                                        if _e1630 {
                                            break;
                                        }
                                        let _e1632 = local_10;
                                        phi_3491_ = _e1630;
                                        let _e1783 = local_13;
                                        phi_3122_ = _e1783;
                                        phi_3123_ = false;
                                        phi_3124_ = _e662;
                                        phi_3125_ = select(_e664, 0u, (_e585 > _e1632.member.member_1));
                                    } else {
                                        let _e673 = (_e662.member_1 < _e83);
                                        if _e673 {
                                            if _e673 {
                                            } else {
                                                phi_3487_ = true;
                                                break;
                                            }
                                            let _e675 = global_5.member[_e662.member_1];
                                            phi_2136_ = _e675;
                                        } else {
                                            phi_2136_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e677 = phi_2136_;
                                        let _e692 = ((10u * _e245) & 31u);
                                        let _e695 = ((_e677.member[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e703 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[0] - _e662.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e708 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e695)) - 8388608f) * _e703)) ^ _e117)));
                                        let _e712 = select(select(_e662.member.member_1[0], _e708, (_e708 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e695 == 1023u));
                                        let _e714 = ((10u * _e244) & 31u);
                                        let _e717 = ((_e677.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[1] - _e662.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e730 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e734 = select(select(_e662.member.member_1[1], _e730, (_e730 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e717 == 1023u));
                                        let _e736 = ((10u * _e246) & 31u);
                                        let _e739 = ((_e677.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e662.member.member_1[2] - _e662.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e752 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e756 = select(select(_e662.member.member_1[2], _e752, (_e752 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e739 == 1023u));
                                        let _e759 = ((_e677.member[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e767 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e759)) - 8388608f) * _e703)) ^ _e117)));
                                        let _e771 = select(select(_e662.member.member_1[0], _e767, (_e767 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e759 == 1023u));
                                        let _e774 = ((_e677.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e782 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e774)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e786 = select(select(_e662.member.member_1[1], _e782, (_e782 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e774 == 1023u));
                                        let _e789 = ((_e677.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e797 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e789)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e801 = select(select(_e662.member.member_1[2], _e797, (_e797 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e789 == 1023u));
                                        let _e807 = ((_e677.member_1[0] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e815 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e703)) ^ _e117)));
                                        let _e819 = select(select(_e662.member.member_1[0], _e815, (_e815 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e807 == 1023u));
                                        let _e822 = ((_e677.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e830 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e834 = select(select(_e662.member.member_1[1], _e830, (_e830 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e822 == 1023u));
                                        let _e837 = ((_e677.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e845 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e849 = select(select(_e662.member.member_1[2], _e845, (_e845 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e837 == 1023u));
                                        let _e852 = ((_e677.member_1[1] >> bitcast<u32>(_e692)) & 1023u);
                                        let _e860 = (_e662.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e703)) ^ _e117)));
                                        let _e864 = select(select(_e662.member.member_1[0], _e860, (_e860 < _e662.member.member_1[0])), _e662.member.member_1[0], (_e852 == 1023u));
                                        let _e867 = ((_e677.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e875 = (_e662.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e867)) - 8388608f) * _e725)) ^ _e117)));
                                        let _e879 = select(select(_e662.member.member_1[1], _e875, (_e875 < _e662.member.member_1[1])), _e662.member.member_1[1], (_e867 == 1023u));
                                        let _e882 = ((_e677.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e890 = (_e662.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e747)) ^ _e117)));
                                        let _e894 = select(select(_e662.member.member_1[2], _e890, (_e890 < _e662.member.member_1[2])), _e662.member.member_1[2], (_e882 == 1023u));
                                        let _e899 = type_50(type_48(array<f32, 3>(_e712, _e734, _e756), array<f32, 3>(_e771, _e786, _e801)), _e677.member_2);
                                        let _e904 = type_50(type_48(array<f32, 3>(_e819, _e834, _e849), array<f32, 3>(_e864, _e879, _e894)), _e677.member_3);
                                        let _e917 = ((_e712 - _e347) * _e350);
                                        let _e918 = ((_e819 - _e347) * _e350);
                                        let _e919 = ((_e771 - _e348) * _e350);
                                        let _e920 = ((_e864 - _e348) * _e350);
                                        let _e925 = ((_e734 - _e413) * _e416);
                                        let _e926 = ((_e834 - _e413) * _e416);
                                        let _e927 = ((_e786 - _e414) * _e416);
                                        let _e928 = ((_e879 - _e414) * _e416);
                                        let _e933 = ((_e756 - _e479) * _e482);
                                        let _e934 = ((_e849 - _e479) * _e482);
                                        let _e935 = ((_e801 - _e480) * _e482);
                                        let _e936 = ((_e894 - _e480) * _e482);
                                        let _e938 = select(_e935, _e933, (_e933 < _e935));
                                        let _e940 = select(_e936, _e934, (_e934 < _e936));
                                        let _e942 = select(_e935, _e933, (_e933 > _e935));
                                        let _e944 = select(_e936, _e934, (_e934 > _e936));
                                        let _e946 = select(_e919, _e917, (_e917 < _e919));
                                        let _e948 = select(_e920, _e918, (_e918 < _e920));
                                        let _e950 = select(_e927, _e925, (_e925 < _e927));
                                        let _e952 = select(_e928, _e926, (_e926 < _e928));
                                        let _e954 = select(_e950, _e946, (_e946 > _e950));
                                        let _e956 = select(_e952, _e948, (_e948 > _e952));
                                        let _e958 = select(_e938, _e954, (_e954 > _e938));
                                        let _e960 = select(_e940, _e956, (_e956 > _e940));
                                        let _e962 = select(_e919, _e917, (_e917 > _e919));
                                        let _e964 = select(_e920, _e918, (_e918 > _e920));
                                        let _e966 = select(_e927, _e925, (_e925 > _e927));
                                        let _e968 = select(_e928, _e926, (_e926 > _e928));
                                        let _e970 = select(_e966, _e962, (_e962 < _e966));
                                        let _e972 = select(_e968, _e964, (_e964 < _e968));
                                        let _e977 = -(_e938);
                                        let _e978 = -(_e940);
                                        let _e985 = (select(_e942, _e970, (_e970 < _e942)) + (select(_e977, _e942, (_e942 > _e977)) * 0.0000019073523f));
                                        let _e986 = (select(_e944, _e972, (_e972 < _e944)) + (select(_e978, _e944, (_e944 > _e978)) * 0.0000019073523f));
                                        let _e988 = select(_e585, _e958, (_e958 > _e585));
                                        let _e990 = select(_e585, _e960, (_e960 > _e585));
                                        let _e995 = (_e988 <= select(_e620.member.member_1, _e985, (_e985 < _e620.member.member_1)));
                                        let _e996 = (_e990 <= select(_e620.member.member_1, _e986, (_e986 < _e620.member.member_1)));
                                        let _e997 = (_e988 <= _e990);
                                        if _e995 {
                                            if _e996 {
                                                if _e997 {
                                                    phi_3025_ = _e904;
                                                } else {
                                                    phi_3025_ = _e899;
                                                }
                                                let _e999 = phi_3025_;
                                                let _e1006 = (_e664 % 128u);
                                                let _e1007 = (_e1006 < 128u);
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_6[_e1006] = _e999.member_1;
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_5[_e1006] = _e999.member.member[0];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_4[_e1006] = _e999.member.member[1];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_3[_e1006] = _e999.member.member[2];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_2[_e1006] = _e999.member.member_1[0];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_1[_e1006] = _e999.member.member_1[1];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local[_e1006] = _e999.member.member_1[2];
                                                if _e1007 {
                                                } else {
                                                    phi_3487_ = true;
                                                    break;
                                                }
                                                local_7[_e1006] = select(_e988, _e990, _e997);
                                                if _e997 {
                                                    phi_3101_ = _e899;
                                                } else {
                                                    phi_3101_ = _e904;
                                                }
                                                let _e1024 = phi_3101_;
                                                phi_3102_ = _e1024;
                                                phi_3103_ = (_e664 + 1u);
                                            } else {
                                                phi_3102_ = type_50();
                                                phi_3103_ = u32();
                                            }
                                            let _e1026 = phi_3102_;
                                            let _e1028 = phi_3103_;
                                            phi_3105_ = _e1026;
                                            phi_3106_ = _e1028;
                                            phi_3107_ = select(true, false, _e996);
                                        } else {
                                            phi_3105_ = type_50();
                                            phi_3106_ = u32();
                                            phi_3107_ = true;
                                        }
                                        let _e1031 = phi_3105_;
                                        let _e1033 = phi_3106_;
                                        let _e1035 = phi_3107_;
                                        if _e1035 {
                                            if _e995 {
                                                phi_3114_ = _e899;
                                            } else {
                                                phi_3114_ = _e904;
                                            }
                                            let _e1037 = phi_3114_;
                                            phi_3119_ = select(_e996, true, _e995);
                                            phi_3120_ = _e1037;
                                        } else {
                                            phi_3119_ = _e660;
                                            phi_3120_ = _e1031;
                                        }
                                        let _e1040 = phi_3119_;
                                        let _e1042 = phi_3120_;
                                        phi_3491_ = _e618;
                                        phi_3122_ = type_39(_e620.member, (_e620.member_1 + 1u), _e620.member_2);
                                        phi_3123_ = _e1040;
                                        phi_3124_ = _e1042;
                                        phi_3125_ = select(_e1033, _e664, _e1035);
                                    }
                                    let _e1638 = phi_3491_;
                                    let _e1640 = phi_3122_;
                                    let _e1642 = phi_3123_;
                                    let _e1644 = phi_3124_;
                                    let _e1646 = phi_3125_;
                                    phi_3490_ = _e1638;
                                    phi_3126_ = _e1640;
                                    phi_3127_ = _e1642;
                                    phi_3128_ = _e1644;
                                    phi_3129_ = _e1646;
                                    phi_3130_ = (_e628 - 1u);
                                } else {
                                    phi_3490_ = _e618;
                                    phi_3126_ = _e620;
                                    phi_3127_ = _e660;
                                    phi_3128_ = _e662;
                                    phi_3129_ = _e664;
                                    phi_3130_ = _e628;
                                }
                                let _e1648 = phi_3490_;
                                let _e1650 = phi_3126_;
                                let _e1652 = phi_3127_;
                                let _e1654 = phi_3128_;
                                let _e1656 = phi_3129_;
                                let _e1658 = phi_3130_;
                                phi_3489_ = _e1648;
                                phi_3131_ = _e1650;
                                phi_3132_ = _e1652;
                                phi_3133_ = _e1654;
                                phi_3134_ = _e1656;
                                phi_3135_ = _e1658;
                            } else {
                                phi_3489_ = _e618;
                                phi_3131_ = type_39();
                                phi_3132_ = bool();
                                phi_3133_ = type_50();
                                phi_3134_ = u32();
                                phi_3135_ = u32();
                            }
                            let _e1660 = phi_3489_;
                            let _e1662 = phi_3131_;
                            let _e1664 = phi_3132_;
                            let _e1666 = phi_3133_;
                            let _e1668 = phi_3134_;
                            let _e1670 = phi_3135_;
                            phi_3488_ = _e1660;
                            phi_1046_ = _e1662;
                            phi_1049_ = _e1664;
                            phi_1051_ = _e1666;
                            phi_1053_ = _e1668;
                            phi_1055_ = _e1670;
                            phi_3136_ = _e632;
                        } else {
                            phi_3488_ = _e618;
                            phi_1046_ = type_39();
                            phi_1049_ = bool();
                            phi_1051_ = type_50();
                            phi_1053_ = u32();
                            phi_1055_ = u32();
                            phi_3136_ = false;
                        }
                        let _e1672 = phi_3488_;
                        let _e1674 = phi_1046_;
                        let _e1676 = phi_1049_;
                        let _e1678 = phi_1051_;
                        let _e1680 = phi_1053_;
                        let _e1682 = phi_1055_;
                        let _e1684 = phi_3136_;
                        continue;
                        continuing {
                            phi_3340_ = _e1672;
                            phi_1045_ = _e1674;
                            phi_1048_ = _e1676;
                            phi_1050_ = _e1678;
                            phi_1052_ = _e1680;
                            phi_1054_ = _e1682;
                            phi_3487_ = _e1672;
                            break if !(_e1684);
                        }
                    }
                    let _e1687 = phi_3487_;
                    if _e1687 {
                        break;
                    }
                    let _e1689 = local_11;
                    let _e1692 = local_12;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_6.member[_e131][0u] = _e1689.member_1;
                    global_6.member[_e131][1u] = _e1692.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
