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
    var phi_361_: i32;
    var phi_362_: i32;
    var phi_372_: bool;
    var phi_382_: u32;
    var phi_383_: u32;
    var phi_385_: bool;
    var phi_390_: u32;
    var phi_403_: i32;
    var phi_423_: i32;
    var phi_441_: f32;
    var phi_447_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_691_: f32;
    var phi_697_: f32;
    var phi_737_: f32;
    var phi_743_: f32;
    var phi_862_: i32;
    var phi_884_: u32;
    var phi_885_: u32;
    var phi_922_: i32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_3414_: bool;
    var phi_1038_: type_39;
    var phi_1041_: u32;
    var phi_1043_: bool;
    var phi_1045_: u32;
    var phi_1047_: type_50;
    var phi_1058_: bool;
    var phi_1144_: bool;
    var phi_1145_: u32;
    var phi_1146_: type_50;
    var phi_1164_: type_39;
    var phi_1167_: type_4;
    var phi_1168_: type_4;
    var phi_1190_: type_4;
    var phi_1214_: u32;
    var phi_1306_: array<array<f32, 3>, 3>;
    var phi_3209_: bool;
    var phi_3224_: bool;
    var phi_3239_: bool;
    var phi_3254_: bool;
    var phi_3269_: bool;
    var phi_3284_: bool;
    var phi_1848_: f32;
    var phi_1849_: f32;
    var phi_1850_: f32;
    var phi_1851_: f32;
    var phi_1852_: vec3<f32>;
    var phi_1853_: vec3<f32>;
    var phi_1854_: vec3<f32>;
    var phi_1855_: vec3<f32>;
    var phi_3299_: bool;
    var phi_3314_: bool;
    var phi_3329_: bool;
    var phi_3344_: bool;
    var phi_3359_: bool;
    var phi_3374_: bool;
    var phi_2063_: f32;
    var phi_2083_: type_35;
    var phi_2084_: type_35;
    var phi_2087_: type_35;
    var phi_2088_: type_35;
    var phi_2089_: bool;
    var phi_2093_: type_35;
    var phi_2102_: type_25;
    var phi_2127_: bool;
    var phi_2128_: bool;
    var phi_2135_: type_39;
    var phi_2136_: type_39;
    var phi_2137_: type_39;
    var phi_1165_: type_39;
    var phi_3408_: bool;
    var phi_3632_: bool;
    var phi_2138_: type_39;
    var phi_2159_: type_43;
    var phi_3048_: type_50;
    var phi_3124_: type_50;
    var phi_3125_: u32;
    var phi_3126_: type_50;
    var phi_3128_: u32;
    var phi_3129_: type_50;
    var phi_3130_: bool;
    var phi_3137_: type_50;
    var phi_3142_: bool;
    var phi_3144_: type_50;
    var phi_3149_: type_39;
    var phi_3150_: bool;
    var phi_3151_: u32;
    var phi_3152_: type_50;
    var phi_3160_: type_39;
    var phi_3163_: type_50;
    var phi_3576_: bool;
    var phi_3164_: type_39;
    var phi_3165_: u32;
    var phi_3166_: bool;
    var phi_3167_: u32;
    var phi_3168_: type_50;
    var phi_3575_: bool;
    var phi_3169_: type_39;
    var phi_3170_: u32;
    var phi_3171_: bool;
    var phi_3172_: u32;
    var phi_3173_: type_50;
    var phi_3574_: bool;
    var phi_1039_: type_39;
    var phi_1042_: u32;
    var phi_1044_: bool;
    var phi_1046_: u32;
    var phi_1048_: type_50;
    var phi_3174_: bool;
    var phi_3573_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

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
                            phi_361_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_361_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_361_;
                        phi_362_ = _e224;
                    } else {
                        phi_362_ = 0i;
                    }
                    let _e226 = phi_362_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_372_ = true;
                    } else {
                        phi_372_ = (_e150 == _e182);
                    }
                    let _e230 = phi_372_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_382_ = _e232;
                        phi_383_ = _e232;
                        phi_385_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_382_ = u32();
                        phi_383_ = 0u;
                        phi_385_ = true;
                    }
                    let _e236 = phi_382_;
                    let _e238 = phi_383_;
                    let _e240 = phi_385_;
                    if _e240 {
                        phi_390_ = (_e238 + 1u);
                    } else {
                        phi_390_ = 0u;
                    }
                    let _e244 = phi_390_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_403_ = -126i;
                    } else {
                        phi_403_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_403_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_423_ = -126i;
                    } else {
                        phi_423_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_423_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_4.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_441_ = _e283[0];
                    } else {
                        phi_441_ = _e283[1];
                    }
                    let _e288 = phi_441_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_447_ = _e283[2];
                    } else {
                        phi_447_ = _e288;
                    }
                    let _e292 = phi_447_;
                    let _e293 = bitcast<u32>(_e292);
                    let _e295 = ((_e293 & 2139095040u) != 0u);
                    let _e309 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e293 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e293 & 2147483648u))), _e292, _e295) * _e256) * select(0.00000011920929f, 1f, _e295)) * _e262);
                    let _e310 = global_4.member[_e131].member_2;
                    if _e284 {
                        phi_487_ = _e310[0];
                    } else {
                        phi_487_ = _e310[1];
                    }
                    let _e314 = phi_487_;
                    if _e289 {
                        phi_493_ = _e310[2];
                    } else {
                        phi_493_ = _e314;
                    }
                    let _e317 = phi_493_;
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
                        phi_566_ = _e283[0];
                    } else {
                        phi_566_ = _e283[1];
                    }
                    let _e355 = phi_566_;
                    let _e356 = (_e244 == 2u);
                    if _e356 {
                        phi_572_ = _e283[2];
                    } else {
                        phi_572_ = _e355;
                    }
                    let _e359 = phi_572_;
                    let _e360 = bitcast<u32>(_e359);
                    let _e362 = ((_e360 & 2139095040u) != 0u);
                    let _e376 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e360 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e360 & 2147483648u))), _e359, _e362) * _e256) * select(0.00000011920929f, 1f, _e362)) * _e262);
                    if _e351 {
                        phi_612_ = _e310[0];
                    } else {
                        phi_612_ = _e310[1];
                    }
                    let _e380 = phi_612_;
                    if _e356 {
                        phi_618_ = _e310[2];
                    } else {
                        phi_618_ = _e380;
                    }
                    let _e383 = phi_618_;
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
                        phi_691_ = _e283[0];
                    } else {
                        phi_691_ = _e283[1];
                    }
                    let _e421 = phi_691_;
                    let _e422 = (_e246 == 2u);
                    if _e422 {
                        phi_697_ = _e283[2];
                    } else {
                        phi_697_ = _e421;
                    }
                    let _e425 = phi_697_;
                    let _e426 = bitcast<u32>(_e425);
                    let _e428 = ((_e426 & 2139095040u) != 0u);
                    let _e442 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e426 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e426 & 2147483648u))), _e425, _e428) * _e256) * select(0.00000011920929f, 1f, _e428)) * _e262);
                    if _e417 {
                        phi_737_ = _e310[0];
                    } else {
                        phi_737_ = _e310[1];
                    }
                    let _e446 = phi_737_;
                    if _e422 {
                        phi_743_ = _e310[2];
                    } else {
                        phi_743_ = _e446;
                    }
                    let _e449 = phi_743_;
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
                            phi_862_ = 255i;
                        } else {
                            phi_862_ = (((_e500 + select(0i, 1i, (_e500 == 0i))) - _e507) + _e487);
                        }
                        let _e515 = phi_862_;
                        let _e525 = (_e515 <= 0i);
                        if _e525 {
                            phi_885_ = u32();
                        } else {
                            if _e504 {
                                phi_884_ = u32();
                            } else {
                                phi_884_ = select(((bitcast<u32>(_e515) << bitcast<u32>(23i)) | ((_e497 << bitcast<u32>(((_e507 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e515 >= 255i));
                            }
                            let _e529 = phi_884_;
                            phi_885_ = _e529;
                        }
                        let _e531 = phi_885_;
                        let _e543 = ((_e203 & 8388607u) | (select(0u, 1u, ((_e203 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e546 = bitcast<i32>((_e203 >> bitcast<u32>(23i)));
                        let _e550 = (_e543 == 0u);
                        let _e553 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e543)), 32u, _e550)) - 8i);
                        if (_e546 == 255i) {
                            phi_922_ = 255i;
                        } else {
                            phi_922_ = (((_e546 + select(0i, 1i, (_e546 == 0i))) - _e553) + _e487);
                        }
                        let _e561 = phi_922_;
                        let _e571 = (_e561 <= 0i);
                        if _e571 {
                            phi_945_ = u32();
                        } else {
                            if _e550 {
                                phi_944_ = u32();
                            } else {
                                phi_944_ = select(((bitcast<u32>(_e561) << bitcast<u32>(23i)) | ((_e543 << bitcast<u32>(((_e553 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e561 >= 255i));
                            }
                            let _e575 = phi_944_;
                            phi_945_ = _e575;
                        }
                        let _e577 = phi_945_;
                        phi_953_ = bitcast<f32>(((_e202 & 2147483648u) | select(_e577, 0u, select(_e550, true, _e571))));
                        phi_954_ = bitcast<f32>(((_e193 & 2147483648u) | select(_e531, 0u, select(_e504, true, _e525))));
                    } else {
                        phi_953_ = 0f;
                        phi_954_ = 1f;
                    }
                    let _e583 = phi_953_;
                    let _e585 = phi_954_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e591 = (_e245 % 3u);
                    let _e592 = (_e591 < 3u);
                    if _e592 {
                    } else {
                        break;
                    }
                    let _e594 = local_9[_e591];
                    let _e595 = (_e244 % 3u);
                    let _e596 = (_e595 < 3u);
                    if _e596 {
                    } else {
                        break;
                    }
                    let _e598 = local_9[_e595];
                    let _e599 = (_e246 % 3u);
                    let _e600 = (_e599 < 3u);
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e602 = local_9[_e599];
                    local_8 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
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
                    phi_3414_ = false;
                    phi_1038_ = type_39(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e583), 0u, 0u);
                    phi_1041_ = ((3u * _e83) + 1u);
                    phi_1043_ = (_e585 <= _e583);
                    phi_1045_ = 0u;
                    phi_1047_ = type_50(type_48(array<f32, 3>(_e594, _e598, _e602), array<f32, 3>(_e606, _e608, _e610)), select(0u, 2147483648u, (_e83 == 0u)));
                    loop {
                        let _e618 = phi_3414_;
                        let _e620 = phi_1038_;
                        let _e622 = phi_1041_;
                        let _e624 = phi_1043_;
                        let _e626 = phi_1045_;
                        let _e628 = phi_1047_;
                        local_10 = _e620;
                        local_11 = _e620;
                        if _e624 {
                            phi_1058_ = true;
                        } else {
                            phi_1058_ = (_e626 > 0u);
                        }
                        let _e631 = phi_1058_;
                        if _e631 {
                            let _e632 = (_e622 > 0u);
                            if _e632 {
                                if _e624 {
                                    phi_1144_ = _e624;
                                    phi_1145_ = _e626;
                                    phi_1146_ = _e628;
                                } else {
                                    let _e633 = (_e626 - 1u);
                                    let _e634 = (_e633 % 128u);
                                    let _e635 = (_e634 < 128u);
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e637 = local_6[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e639 = local_5[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e641 = local_4[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e643 = local_3[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e646 = local_2[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e648 = local_1[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e650 = local[_e634];
                                    if _e635 {
                                    } else {
                                        phi_3573_ = true;
                                        break;
                                    }
                                    let _e655 = local_7[_e634];
                                    phi_1144_ = (_e655 <= _e620.member.member_1);
                                    phi_1145_ = _e633;
                                    phi_1146_ = type_50(type_48(array<f32, 3>(_e639, _e641, _e643), array<f32, 3>(_e646, _e648, _e650)), _e637);
                                }
                                let _e660 = phi_1144_;
                                let _e662 = phi_1145_;
                                let _e664 = phi_1146_;
                                if _e660 {
                                    let _e668 = ((_e664.member_1 & 2147483648u) != 0u);
                                    if _e668 {
                                        phi_1164_ = _e620;
                                        phi_1167_ = type_4(0u, ((_e664.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e675 = phi_1164_;
                                            let _e677 = phi_1167_;
                                            local_12 = _e675;
                                            if (_e677.member < _e677.member_1) {
                                                phi_1168_ = type_4((_e677.member + 1u), _e677.member_1);
                                                phi_1190_ = type_4(1u, _e677.member);
                                            } else {
                                                phi_1168_ = _e677;
                                                phi_1190_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e690 = phi_1168_;
                                            let _e692 = phi_1190_;
                                            let _e696 = (bitcast<i32>(_e692.member) != 0i);
                                            if _e696 {
                                                let _e702 = type_39(_e675.member, _e675.member_1, (_e675.member_2 + 1u));
                                                let _e703 = ((_e664.member_1 & 268435455u) + _e692.member_1);
                                                let _e704 = (_e703 < _e85);
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e708 = global_2.member[_e703].member_1;
                                                    phi_1214_ = _e708;
                                                } else {
                                                    phi_1214_ = 4294967295u;
                                                }
                                                let _e710 = phi_1214_;
                                                if (_e703 >= _e85) {
                                                    phi_1306_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e704 {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    if (_e591 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e717 = global_2.member[_e703].member[_e591];
                                                    if (_e595 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_2.member[_e703].member[_e595];
                                                    if (_e599 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e729 = global_2.member[_e703].member[_e599];
                                                    let _e731 = (3u + _e591);
                                                    if (_e731 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_2.member[_e703].member[_e731];
                                                    let _e738 = (3u + _e595);
                                                    if (_e738 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e744 = global_2.member[_e703].member[_e738];
                                                    let _e745 = (3u + _e599);
                                                    if (_e745 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e751 = global_2.member[_e703].member[_e745];
                                                    let _e753 = (6u + _e591);
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e703].member[_e753];
                                                    let _e760 = (6u + _e595);
                                                    if (_e760 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e766 = global_2.member[_e703].member[_e760];
                                                    let _e767 = (6u + _e599);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_3408_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e703].member[_e767];
                                                    phi_1306_ = array<array<f32, 3>, 3>(array<f32, 3>(_e717, _e723, _e729), array<f32, 3>(_e737, _e744, _e751), array<f32, 3>(_e759, _e766, _e773));
                                                }
                                                let _e777 = phi_1306_;
                                                let _e794 = (_e777[0][2] - _e442);
                                                let _e797 = (((_e777[0][0] - _e309) * _e478) - (_e794 * _e346));
                                                let _e800 = (((_e777[0][1] - _e376) * _e478) - (_e794 * _e412));
                                                let _e803 = (_e777[1][2] - _e442);
                                                let _e806 = (((_e777[1][0] - _e309) * _e478) - (_e803 * _e346));
                                                let _e809 = (((_e777[1][1] - _e376) * _e478) - (_e803 * _e412));
                                                let _e812 = (_e777[2][2] - _e442);
                                                let _e815 = (((_e777[2][0] - _e309) * _e478) - (_e812 * _e346));
                                                let _e818 = (((_e777[2][1] - _e376) * _e478) - (_e812 * _e412));
                                                let _e819 = (_e815 * _e809);
                                                let _e820 = (_e818 * _e806);
                                                let _e821 = (_e797 * _e818);
                                                let _e822 = (_e800 * _e815);
                                                let _e823 = (_e806 * _e800);
                                                let _e824 = (_e809 * _e797);
                                                let _e829 = (((_e819 >= _e820) && (_e821 >= _e822)) && (_e823 >= _e824));
                                                let _e835 = (_e829 || (((_e819 <= _e820) && (_e821 <= _e822)) && (_e823 <= _e824)));
                                                if _e835 {
                                                    let _e837 = select(-1f, 1f, _e829);
                                                    let _e839 = ((_e819 - _e820) * _e837);
                                                    let _e841 = select(0f, _e839, (_e839 > 0f));
                                                    let _e843 = ((_e821 - _e822) * _e837);
                                                    let _e845 = select(0f, _e843, (_e843 > 0f));
                                                    let _e847 = ((_e823 - _e824) * _e837);
                                                    let _e849 = select(0f, _e847, (_e847 > 0f));
                                                    let _e851 = ((_e841 + _e845) + _e849);
                                                    let _e853 = select(_e777[1][0], _e777[0][0], (_e777[0][0] < _e777[1][0]));
                                                    let _e857 = select(_e777[1][0], _e777[0][0], (_e777[0][0] > _e777[1][0]));
                                                    let _e861 = select(_e777[1][1], _e777[0][1], (_e777[0][1] < _e777[1][1]));
                                                    let _e865 = select(_e777[1][1], _e777[0][1], (_e777[0][1] > _e777[1][1]));
                                                    let _e869 = select(_e777[1][2], _e777[0][2], (_e777[0][2] < _e777[1][2]));
                                                    let _e873 = select(_e777[1][2], _e777[0][2], (_e777[0][2] > _e777[1][2]));
                                                    let _e878 = ((select(_e777[2][0], _e853, (_e853 < _e777[2][0])) - _e347) * _e350);
                                                    let _e879 = ((select(_e777[2][0], _e857, (_e857 > _e777[2][0])) - _e348) * _e350);
                                                    let _e882 = ((select(_e777[2][1], _e861, (_e861 < _e777[2][1])) - _e413) * _e416);
                                                    let _e883 = ((select(_e777[2][1], _e865, (_e865 > _e777[2][1])) - _e414) * _e416);
                                                    let _e886 = ((select(_e777[2][2], _e869, (_e869 < _e777[2][2])) - _e479) * _e482);
                                                    let _e887 = ((select(_e777[2][2], _e873, (_e873 > _e777[2][2])) - _e480) * _e482);
                                                    let _e889 = select(_e887, _e886, (_e886 < _e887));
                                                    let _e891 = select(_e887, _e886, (_e886 > _e887));
                                                    let _e893 = select(_e879, _e878, (_e878 < _e879));
                                                    let _e895 = select(_e883, _e882, (_e882 < _e883));
                                                    let _e897 = select(_e895, _e893, (_e893 > _e895));
                                                    let _e899 = select(_e889, _e897, (_e897 > _e889));
                                                    let _e901 = select(_e879, _e878, (_e878 > _e879));
                                                    let _e903 = select(_e883, _e882, (_e882 > _e883));
                                                    let _e905 = select(_e903, _e901, (_e901 < _e903));
                                                    let _e907 = select(_e891, _e905, (_e905 < _e891));
                                                    let _e908 = -(_e889);
                                                    let _e914 = select(_e585, _e899, (_e899 > _e585));
                                                    let _e918 = select(_e806, _e797, (_e797 < _e806));
                                                    let _e923 = select(_e806, _e797, (_e797 > _e806));
                                                    let _e930 = select(_e809, _e800, (_e800 < _e809));
                                                    let _e935 = select(_e809, _e800, (_e800 > _e809));
                                                    let _e944 = (((((_e835 && (_e851 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e815, _e918, (_e918 < _e815)) <= 0f) && (select(_e815, _e923, (_e923 > _e815)) >= 0f))) && ((select(_e818, _e930, (_e930 < _e818)) <= 0f) && (select(_e818, _e935, (_e935 > _e818)) >= 0f))) && (_e914 <= (_e907 + (select(_e908, _e891, (_e891 > _e908)) * 0.0000019073523f)))) && (_e914 <= _e675.member.member_1));
                                                    if _e944 {
                                                        let _e949 = (_e777[1][0] - _e777[0][0]);
                                                        let _e950 = (_e777[1][1] - _e777[0][1]);
                                                        let _e951 = (_e777[1][2] - _e777[0][2]);
                                                        let _e952 = vec3<f32>(_e949, _e950, _e951);
                                                        let _e953 = (_e777[2][0] - _e777[1][0]);
                                                        let _e954 = (_e777[2][1] - _e777[1][1]);
                                                        let _e955 = (_e777[2][2] - _e777[1][2]);
                                                        let _e956 = vec3<f32>(_e953, _e954, _e955);
                                                        let _e957 = (_e777[0][0] - _e777[2][0]);
                                                        let _e958 = (_e777[0][1] - _e777[2][1]);
                                                        let _e959 = (_e777[0][2] - _e777[2][2]);
                                                        let _e960 = vec3<f32>(_e957, _e958, _e959);
                                                        let _e961 = abs(_e949);
                                                        let _e962 = abs(_e950);
                                                        if (_e961 != _e961) {
                                                            phi_3209_ = true;
                                                        } else {
                                                            phi_3209_ = (_e962 >= _e961);
                                                        }
                                                        let _e966 = phi_3209_;
                                                        let _e967 = select(_e961, _e962, _e966);
                                                        let _e968 = abs(_e951);
                                                        if (_e967 != _e967) {
                                                            phi_3224_ = true;
                                                        } else {
                                                            phi_3224_ = (_e968 >= _e967);
                                                        }
                                                        let _e972 = phi_3224_;
                                                        let _e973 = select(_e967, _e968, _e972);
                                                        let _e974 = abs(_e953);
                                                        let _e975 = abs(_e954);
                                                        if (_e974 != _e974) {
                                                            phi_3239_ = true;
                                                        } else {
                                                            phi_3239_ = (_e975 >= _e974);
                                                        }
                                                        let _e979 = phi_3239_;
                                                        let _e980 = select(_e974, _e975, _e979);
                                                        let _e981 = abs(_e955);
                                                        if (_e980 != _e980) {
                                                            phi_3254_ = true;
                                                        } else {
                                                            phi_3254_ = (_e981 >= _e980);
                                                        }
                                                        let _e985 = phi_3254_;
                                                        let _e986 = select(_e980, _e981, _e985);
                                                        let _e987 = abs(_e957);
                                                        let _e988 = abs(_e958);
                                                        if (_e987 != _e987) {
                                                            phi_3269_ = true;
                                                        } else {
                                                            phi_3269_ = (_e988 >= _e987);
                                                        }
                                                        let _e992 = phi_3269_;
                                                        let _e993 = select(_e987, _e988, _e992);
                                                        let _e994 = abs(_e959);
                                                        if (_e993 != _e993) {
                                                            phi_3284_ = true;
                                                        } else {
                                                            phi_3284_ = (_e994 >= _e993);
                                                        }
                                                        let _e998 = phi_3284_;
                                                        let _e999 = select(_e993, _e994, _e998);
                                                        let _e1001 = select(_e986, _e973, (_e973 > _e986));
                                                        let _e1003 = select(_e999, _e1001, (_e1001 > _e999));
                                                        if (_e973 == _e1003) {
                                                            phi_1848_ = _e809;
                                                            phi_1849_ = _e806;
                                                            phi_1850_ = _e800;
                                                            phi_1851_ = _e797;
                                                            phi_1852_ = vec3<f32>(_e777[0][0], _e777[0][1], _e777[0][2]);
                                                            phi_1853_ = _e960;
                                                            phi_1854_ = _e956;
                                                            phi_1855_ = _e952;
                                                        } else {
                                                            let _e1005 = (_e986 == _e1003);
                                                            let _e1010 = vec3(_e1005);
                                                            phi_1848_ = select(_e800, _e818, _e1005);
                                                            phi_1849_ = select(_e797, _e815, _e1005);
                                                            phi_1850_ = select(_e818, _e809, _e1005);
                                                            phi_1851_ = select(_e815, _e806, _e1005);
                                                            phi_1852_ = select(vec3<f32>(_e777[2][0], _e777[2][1], _e777[2][2]), vec3<f32>(_e777[1][0], _e777[1][1], _e777[1][2]), _e1010);
                                                            phi_1853_ = select(_e956, _e952, _e1010);
                                                            phi_1854_ = select(_e952, _e960, _e1010);
                                                            phi_1855_ = select(_e960, _e956, _e1010);
                                                        }
                                                        let _e1016 = phi_1848_;
                                                        let _e1018 = phi_1849_;
                                                        let _e1020 = phi_1850_;
                                                        let _e1022 = phi_1851_;
                                                        let _e1024 = phi_1852_;
                                                        let _e1026 = phi_1853_;
                                                        let _e1028 = phi_1854_;
                                                        let _e1030 = phi_1855_;
                                                        let _e1037 = ((_e1028.y * _e1026.z) - (_e1026.y * _e1028.z));
                                                        let _e1042 = ((_e1028.z * _e1026.x) - (_e1026.z * _e1028.x));
                                                        let _e1045 = ((_e1028.x * _e1026.y) - (_e1026.x * _e1028.y));
                                                        let _e1048 = ((_e841 >= _e845) && (_e841 >= _e849));
                                                        let _e1049 = (_e845 >= _e849);
                                                        let _e1063 = (((_e1037 * (select(select(_e777[2][0], _e777[1][0], _e1049), _e777[0][0], _e1048) - _e309)) + (_e1042 * (select(select(_e777[2][1], _e777[1][1], _e1049), _e777[0][1], _e1048) - _e376))) + (_e1045 * (select(select(_e777[2][2], _e777[1][2], _e1049), _e777[0][2], _e1048) - _e442)));
                                                        let _e1068 = (((_e1037 * _e346) + (_e1042 * _e412)) + (_e1045 * _e478));
                                                        let _e1069 = (_e1018 - _e1022);
                                                        let _e1070 = (_e1016 - _e1020);
                                                        let _e1073 = ((_e1069 * _e1069) + (_e1070 * _e1070));
                                                        let _e1080 = (-(((_e1022 * _e1069) + (_e1020 * _e1070))) / select(0.000000000000000000000000000000000000011754944f, _e1073, (_e1073 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1082 = select(1f, _e1080, (_e1080 < 1f));
                                                        let _e1084 = select(0f, _e1082, (_e1082 > 0f));
                                                        let _e1093 = ((_e1024.x + (_e1030.x * _e1084)) - _e309);
                                                        let _e1096 = ((_e1024.y + (_e1030.y * _e1084)) - _e376);
                                                        let _e1099 = ((_e1024.z + (_e1030.z * _e1084)) - _e442);
                                                        let _e1102 = bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u));
                                                        let _e1105 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                        let _e1107 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                        let _e1110 = bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u));
                                                        let _e1112 = select(_e1110, _e1107, (_e1107 > _e1110));
                                                        let _e1116 = abs(_e1037);
                                                        let _e1117 = abs(_e1042);
                                                        if (_e1116 != _e1116) {
                                                            phi_3299_ = true;
                                                        } else {
                                                            phi_3299_ = (_e1117 >= _e1116);
                                                        }
                                                        let _e1121 = phi_3299_;
                                                        let _e1122 = select(_e1116, _e1117, _e1121);
                                                        let _e1123 = abs(_e1045);
                                                        if (_e1122 != _e1122) {
                                                            phi_3314_ = true;
                                                        } else {
                                                            phi_3314_ = (_e1123 >= _e1122);
                                                        }
                                                        let _e1127 = phi_3314_;
                                                        let _e1143 = abs(_e1028.x);
                                                        let _e1144 = abs(_e1028.y);
                                                        if (_e1143 != _e1143) {
                                                            phi_3329_ = true;
                                                        } else {
                                                            phi_3329_ = (_e1144 >= _e1143);
                                                        }
                                                        let _e1148 = phi_3329_;
                                                        let _e1149 = select(_e1143, _e1144, _e1148);
                                                        let _e1150 = abs(_e1028.z);
                                                        if (_e1149 != _e1149) {
                                                            phi_3344_ = true;
                                                        } else {
                                                            phi_3344_ = (_e1150 >= _e1149);
                                                        }
                                                        let _e1154 = phi_3344_;
                                                        let _e1157 = abs(_e1026.x);
                                                        let _e1158 = abs(_e1026.y);
                                                        if (_e1157 != _e1157) {
                                                            phi_3359_ = true;
                                                        } else {
                                                            phi_3359_ = (_e1158 >= _e1157);
                                                        }
                                                        let _e1162 = phi_3359_;
                                                        let _e1163 = select(_e1157, _e1158, _e1162);
                                                        let _e1164 = abs(_e1026.z);
                                                        if (_e1163 != _e1163) {
                                                            phi_3374_ = true;
                                                        } else {
                                                            phi_3374_ = (_e1164 >= _e1163);
                                                        }
                                                        let _e1168 = phi_3374_;
                                                        let _e1173 = ((bitcast<f32>((bitcast<u32>(((((_e1037 * _e1093) + (_e1042 * _e1096)) + (_e1045 * _e1099)) - _e1063)) & 2147483647u)) <= ((0.0000009536743f * select(_e1003, _e1112, (_e1112 > _e1003))) * select(_e1122, _e1123, _e1127))) && !((bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u)) <= ((0.0000038146973f * select(_e1149, _e1150, _e1154)) * select(_e1163, _e1164, _e1168)))));
                                                        let _e1174 = (_e1063 / _e1068);
                                                        if (_e944 && !(_e1173)) {
                                                            let _e1177 = (_e1099 / _e478);
                                                            let _e1185 = (((_e1037 * (_e1093 - (_e346 * _e1177))) + (_e1042 * (_e1096 - (_e412 * _e1177)))) / _e1068);
                                                            phi_2063_ = select(select(_e1177, (_e1177 + _e1185), (bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u)) <= _e1003)), _e1174, _e1173);
                                                        } else {
                                                            phi_2063_ = _e1174;
                                                        }
                                                        let _e1194 = phi_2063_;
                                                        let _e1196 = select(_e907, _e1194, (_e1194 < _e907));
                                                        let _e1198 = select(_e899, _e1196, (_e1196 > _e899));
                                                        let _e1199 = (1f / _e851);
                                                        phi_2083_ = type_35(_e1198, (_e845 * _e1199), (_e849 * _e1199), ((_e944 && (_e1198 >= _e585)) && (_e1198 <= _e675.member.member_1)));
                                                        phi_2084_ = type_35();
                                                    } else {
                                                        phi_2083_ = type_35();
                                                        phi_2084_ = type_35(0f, 0f, 0f, _e944);
                                                    }
                                                    let _e1208 = phi_2083_;
                                                    let _e1210 = phi_2084_;
                                                    phi_2087_ = _e1208;
                                                    phi_2088_ = _e1210;
                                                    phi_2089_ = select(true, false, _e944);
                                                } else {
                                                    phi_2087_ = type_35();
                                                    phi_2088_ = type_35(0f, 0f, 0f, _e835);
                                                    phi_2089_ = true;
                                                }
                                                let _e1213 = phi_2087_;
                                                let _e1215 = phi_2088_;
                                                let _e1217 = phi_2089_;
                                                if _e1217 {
                                                    phi_2093_ = _e1215;
                                                } else {
                                                    phi_2093_ = _e1213;
                                                }
                                                let _e1219 = phi_2093_;
                                                if _e1219.member_3 {
                                                    phi_2102_ = type_25(_e1219.member, _e1219.member_1, _e1219.member_2, _e710);
                                                } else {
                                                    phi_2102_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1226 = phi_2102_;
                                                if (_e1226.member_3 != 4294967295u) {
                                                    if (_e710 != 4294967295u) {
                                                        if (_e1226.member < _e675.member.member.member) {
                                                            phi_2128_ = true;
                                                        } else {
                                                            if (_e1226.member == _e675.member.member.member) {
                                                                phi_2127_ = (_e1226.member_3 < _e675.member.member.member_3);
                                                            } else {
                                                                phi_2127_ = false;
                                                            }
                                                            let _e1241 = phi_2127_;
                                                            phi_2128_ = _e1241;
                                                        }
                                                        let _e1243 = phi_2128_;
                                                        if _e1243 {
                                                            phi_2135_ = type_39(type_32(_e1226, _e1226.member), _e702.member_1, _e702.member_2);
                                                        } else {
                                                            phi_2135_ = _e702;
                                                        }
                                                        let _e1250 = phi_2135_;
                                                        phi_2136_ = _e1250;
                                                    } else {
                                                        phi_2136_ = _e702;
                                                    }
                                                    let _e1252 = phi_2136_;
                                                    phi_2137_ = _e1252;
                                                } else {
                                                    phi_2137_ = _e702;
                                                }
                                                let _e1254 = phi_2137_;
                                                phi_1165_ = _e1254;
                                            } else {
                                                phi_1165_ = type_39();
                                            }
                                            let _e1256 = phi_1165_;
                                            continue;
                                            continuing {
                                                phi_1164_ = _e1256;
                                                phi_1167_ = _e690;
                                                phi_3408_ = _e618;
                                                break if !(_e696);
                                            }
                                        }
                                        let _e1259 = phi_3408_;
                                        phi_3573_ = _e1259;
                                        if _e1259 {
                                            break;
                                        }
                                        phi_3632_ = _e1259;
                                        let _e1785 = local_12;
                                        phi_2138_ = _e1785;
                                    } else {
                                        phi_3632_ = _e618;
                                        phi_2138_ = _e620;
                                    }
                                    let _e1261 = phi_3632_;
                                    let _e1263 = phi_2138_;
                                    if _e668 {
                                        phi_3149_ = type_39();
                                        phi_3150_ = bool();
                                        phi_3151_ = u32();
                                        phi_3152_ = type_50();
                                    } else {
                                        let _e1264 = (_e664.member_1 < _e83);
                                        if _e1264 {
                                            if _e1264 {
                                            } else {
                                                phi_3573_ = true;
                                                break;
                                            }
                                            let _e1266 = global_5.member[_e664.member_1];
                                            phi_2159_ = _e1266;
                                        } else {
                                            phi_2159_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1268 = phi_2159_;
                                        let _e1283 = ((10u * _e245) & 31u);
                                        let _e1286 = ((_e1268.member[0] >> bitcast<u32>(_e1283)) & 1023u);
                                        let _e1294 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[0] - _e664.member.member[0]) * 0.0009775171f)) ^ _e117));
                                        let _e1299 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1286)) - 8388608f) * _e1294)) ^ _e117)));
                                        let _e1303 = select(select(_e664.member.member_1[0], _e1299, (_e1299 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1286 == 1023u));
                                        let _e1305 = ((10u * _e244) & 31u);
                                        let _e1308 = ((_e1268.member[0] >> bitcast<u32>(_e1305)) & 1023u);
                                        let _e1316 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[1] - _e664.member.member[1]) * 0.0009775171f)) ^ _e117));
                                        let _e1321 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1308)) - 8388608f) * _e1316)) ^ _e117)));
                                        let _e1325 = select(select(_e664.member.member_1[1], _e1321, (_e1321 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1308 == 1023u));
                                        let _e1327 = ((10u * _e246) & 31u);
                                        let _e1330 = ((_e1268.member[0] >> bitcast<u32>(_e1327)) & 1023u);
                                        let _e1338 = bitcast<f32>((bitcast<u32>(((_e664.member.member_1[2] - _e664.member.member[2]) * 0.0009775171f)) ^ _e117));
                                        let _e1343 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1330)) - 8388608f) * _e1338)) ^ _e117)));
                                        let _e1347 = select(select(_e664.member.member_1[2], _e1343, (_e1343 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1330 == 1023u));
                                        let _e1350 = ((_e1268.member[1] >> bitcast<u32>(_e1283)) & 1023u);
                                        let _e1358 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1350)) - 8388608f) * _e1294)) ^ _e117)));
                                        let _e1362 = select(select(_e664.member.member_1[0], _e1358, (_e1358 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1350 == 1023u));
                                        let _e1365 = ((_e1268.member[1] >> bitcast<u32>(_e1305)) & 1023u);
                                        let _e1373 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1365)) - 8388608f) * _e1316)) ^ _e117)));
                                        let _e1377 = select(select(_e664.member.member_1[1], _e1373, (_e1373 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1365 == 1023u));
                                        let _e1380 = ((_e1268.member[1] >> bitcast<u32>(_e1327)) & 1023u);
                                        let _e1388 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1380)) - 8388608f) * _e1338)) ^ _e117)));
                                        let _e1392 = select(select(_e664.member.member_1[2], _e1388, (_e1388 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1380 == 1023u));
                                        let _e1398 = ((_e1268.member_1[0] >> bitcast<u32>(_e1283)) & 1023u);
                                        let _e1406 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1398)) - 8388608f) * _e1294)) ^ _e117)));
                                        let _e1410 = select(select(_e664.member.member_1[0], _e1406, (_e1406 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1398 == 1023u));
                                        let _e1413 = ((_e1268.member_1[0] >> bitcast<u32>(_e1305)) & 1023u);
                                        let _e1421 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1413)) - 8388608f) * _e1316)) ^ _e117)));
                                        let _e1425 = select(select(_e664.member.member_1[1], _e1421, (_e1421 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1413 == 1023u));
                                        let _e1428 = ((_e1268.member_1[0] >> bitcast<u32>(_e1327)) & 1023u);
                                        let _e1436 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1428)) - 8388608f) * _e1338)) ^ _e117)));
                                        let _e1440 = select(select(_e664.member.member_1[2], _e1436, (_e1436 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1428 == 1023u));
                                        let _e1443 = ((_e1268.member_1[1] >> bitcast<u32>(_e1283)) & 1023u);
                                        let _e1451 = (_e664.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1443)) - 8388608f) * _e1294)) ^ _e117)));
                                        let _e1455 = select(select(_e664.member.member_1[0], _e1451, (_e1451 < _e664.member.member_1[0])), _e664.member.member_1[0], (_e1443 == 1023u));
                                        let _e1458 = ((_e1268.member_1[1] >> bitcast<u32>(_e1305)) & 1023u);
                                        let _e1466 = (_e664.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1458)) - 8388608f) * _e1316)) ^ _e117)));
                                        let _e1470 = select(select(_e664.member.member_1[1], _e1466, (_e1466 < _e664.member.member_1[1])), _e664.member.member_1[1], (_e1458 == 1023u));
                                        let _e1473 = ((_e1268.member_1[1] >> bitcast<u32>(_e1327)) & 1023u);
                                        let _e1481 = (_e664.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1473)) - 8388608f) * _e1338)) ^ _e117)));
                                        let _e1485 = select(select(_e664.member.member_1[2], _e1481, (_e1481 < _e664.member.member_1[2])), _e664.member.member_1[2], (_e1473 == 1023u));
                                        let _e1490 = type_50(type_48(array<f32, 3>(_e1303, _e1325, _e1347), array<f32, 3>(_e1362, _e1377, _e1392)), _e1268.member_2);
                                        let _e1495 = type_50(type_48(array<f32, 3>(_e1410, _e1425, _e1440), array<f32, 3>(_e1455, _e1470, _e1485)), _e1268.member_3);
                                        let _e1508 = ((_e1303 - _e347) * _e350);
                                        let _e1509 = ((_e1410 - _e347) * _e350);
                                        let _e1510 = ((_e1362 - _e348) * _e350);
                                        let _e1511 = ((_e1455 - _e348) * _e350);
                                        let _e1516 = ((_e1325 - _e413) * _e416);
                                        let _e1517 = ((_e1425 - _e413) * _e416);
                                        let _e1518 = ((_e1377 - _e414) * _e416);
                                        let _e1519 = ((_e1470 - _e414) * _e416);
                                        let _e1524 = ((_e1347 - _e479) * _e482);
                                        let _e1525 = ((_e1440 - _e479) * _e482);
                                        let _e1526 = ((_e1392 - _e480) * _e482);
                                        let _e1527 = ((_e1485 - _e480) * _e482);
                                        let _e1529 = select(_e1526, _e1524, (_e1524 < _e1526));
                                        let _e1531 = select(_e1527, _e1525, (_e1525 < _e1527));
                                        let _e1533 = select(_e1526, _e1524, (_e1524 > _e1526));
                                        let _e1535 = select(_e1527, _e1525, (_e1525 > _e1527));
                                        let _e1537 = select(_e1510, _e1508, (_e1508 < _e1510));
                                        let _e1539 = select(_e1511, _e1509, (_e1509 < _e1511));
                                        let _e1541 = select(_e1518, _e1516, (_e1516 < _e1518));
                                        let _e1543 = select(_e1519, _e1517, (_e1517 < _e1519));
                                        let _e1545 = select(_e1541, _e1537, (_e1537 > _e1541));
                                        let _e1547 = select(_e1543, _e1539, (_e1539 > _e1543));
                                        let _e1549 = select(_e1529, _e1545, (_e1545 > _e1529));
                                        let _e1551 = select(_e1531, _e1547, (_e1547 > _e1531));
                                        let _e1553 = select(_e1510, _e1508, (_e1508 > _e1510));
                                        let _e1555 = select(_e1511, _e1509, (_e1509 > _e1511));
                                        let _e1557 = select(_e1518, _e1516, (_e1516 > _e1518));
                                        let _e1559 = select(_e1519, _e1517, (_e1517 > _e1519));
                                        let _e1561 = select(_e1557, _e1553, (_e1553 < _e1557));
                                        let _e1563 = select(_e1559, _e1555, (_e1555 < _e1559));
                                        let _e1568 = -(_e1529);
                                        let _e1569 = -(_e1531);
                                        let _e1576 = (select(_e1533, _e1561, (_e1561 < _e1533)) + (select(_e1568, _e1533, (_e1533 > _e1568)) * 0.0000019073523f));
                                        let _e1577 = (select(_e1535, _e1563, (_e1563 < _e1535)) + (select(_e1569, _e1535, (_e1535 > _e1569)) * 0.0000019073523f));
                                        let _e1579 = select(_e585, _e1549, (_e1549 > _e585));
                                        let _e1581 = select(_e585, _e1551, (_e1551 > _e585));
                                        let _e1586 = (_e1579 <= select(_e1263.member.member_1, _e1576, (_e1576 < _e1263.member.member_1)));
                                        let _e1587 = (_e1581 <= select(_e1263.member.member_1, _e1577, (_e1577 < _e1263.member.member_1)));
                                        let _e1588 = (_e1579 <= _e1581);
                                        if _e1586 {
                                            if _e1587 {
                                                if _e1588 {
                                                    phi_3048_ = _e1495;
                                                } else {
                                                    phi_3048_ = _e1490;
                                                }
                                                let _e1590 = phi_3048_;
                                                let _e1597 = (_e662 % 128u);
                                                let _e1598 = (_e1597 < 128u);
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_6[_e1597] = _e1590.member_1;
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_5[_e1597] = _e1590.member.member[0];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_4[_e1597] = _e1590.member.member[1];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_3[_e1597] = _e1590.member.member[2];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_2[_e1597] = _e1590.member.member_1[0];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_1[_e1597] = _e1590.member.member_1[1];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local[_e1597] = _e1590.member.member_1[2];
                                                if _e1598 {
                                                } else {
                                                    phi_3573_ = true;
                                                    break;
                                                }
                                                local_7[_e1597] = select(_e1579, _e1581, _e1588);
                                                if _e1588 {
                                                    phi_3124_ = _e1490;
                                                } else {
                                                    phi_3124_ = _e1495;
                                                }
                                                let _e1615 = phi_3124_;
                                                phi_3125_ = (_e662 + 1u);
                                                phi_3126_ = _e1615;
                                            } else {
                                                phi_3125_ = u32();
                                                phi_3126_ = type_50();
                                            }
                                            let _e1617 = phi_3125_;
                                            let _e1619 = phi_3126_;
                                            phi_3128_ = _e1617;
                                            phi_3129_ = _e1619;
                                            phi_3130_ = select(true, false, _e1587);
                                        } else {
                                            phi_3128_ = u32();
                                            phi_3129_ = type_50();
                                            phi_3130_ = true;
                                        }
                                        let _e1622 = phi_3128_;
                                        let _e1624 = phi_3129_;
                                        let _e1626 = phi_3130_;
                                        if _e1626 {
                                            if _e1586 {
                                                phi_3137_ = _e1490;
                                            } else {
                                                phi_3137_ = _e1495;
                                            }
                                            let _e1628 = phi_3137_;
                                            phi_3142_ = select(_e1587, true, _e1586);
                                            phi_3144_ = _e1628;
                                        } else {
                                            phi_3142_ = _e660;
                                            phi_3144_ = _e1624;
                                        }
                                        let _e1631 = phi_3142_;
                                        let _e1633 = phi_3144_;
                                        phi_3149_ = type_39(_e1263.member, (_e1263.member_1 + 1u), _e1263.member_2);
                                        phi_3150_ = _e1631;
                                        phi_3151_ = select(_e1622, _e662, _e1626);
                                        phi_3152_ = _e1633;
                                    }
                                    let _e1636 = phi_3149_;
                                    let _e1638 = phi_3150_;
                                    let _e1640 = phi_3151_;
                                    let _e1642 = phi_3152_;
                                    if _e668 {
                                        phi_3160_ = _e1263;
                                        phi_3163_ = _e664;
                                    } else {
                                        phi_3160_ = _e1636;
                                        phi_3163_ = _e1642;
                                    }
                                    let _e1644 = phi_3160_;
                                    let _e1646 = phi_3163_;
                                    phi_3576_ = _e1261;
                                    phi_3164_ = _e1644;
                                    phi_3165_ = (_e622 - 1u);
                                    phi_3166_ = select(_e1638, false, _e668);
                                    phi_3167_ = select(_e1640, _e662, _e668);
                                    phi_3168_ = _e1646;
                                } else {
                                    phi_3576_ = _e618;
                                    phi_3164_ = _e620;
                                    phi_3165_ = _e622;
                                    phi_3166_ = _e660;
                                    phi_3167_ = _e662;
                                    phi_3168_ = _e664;
                                }
                                let _e1650 = phi_3576_;
                                let _e1652 = phi_3164_;
                                let _e1654 = phi_3165_;
                                let _e1656 = phi_3166_;
                                let _e1658 = phi_3167_;
                                let _e1660 = phi_3168_;
                                phi_3575_ = _e1650;
                                phi_3169_ = _e1652;
                                phi_3170_ = _e1654;
                                phi_3171_ = _e1656;
                                phi_3172_ = _e1658;
                                phi_3173_ = _e1660;
                            } else {
                                phi_3575_ = _e618;
                                phi_3169_ = type_39();
                                phi_3170_ = u32();
                                phi_3171_ = bool();
                                phi_3172_ = u32();
                                phi_3173_ = type_50();
                            }
                            let _e1662 = phi_3575_;
                            let _e1664 = phi_3169_;
                            let _e1666 = phi_3170_;
                            let _e1668 = phi_3171_;
                            let _e1670 = phi_3172_;
                            let _e1672 = phi_3173_;
                            phi_3574_ = _e1662;
                            phi_1039_ = _e1664;
                            phi_1042_ = _e1666;
                            phi_1044_ = _e1668;
                            phi_1046_ = _e1670;
                            phi_1048_ = _e1672;
                            phi_3174_ = _e632;
                        } else {
                            phi_3574_ = _e618;
                            phi_1039_ = type_39();
                            phi_1042_ = u32();
                            phi_1044_ = bool();
                            phi_1046_ = u32();
                            phi_1048_ = type_50();
                            phi_3174_ = false;
                        }
                        let _e1674 = phi_3574_;
                        let _e1676 = phi_1039_;
                        let _e1678 = phi_1042_;
                        let _e1680 = phi_1044_;
                        let _e1682 = phi_1046_;
                        let _e1684 = phi_1048_;
                        let _e1686 = phi_3174_;
                        continue;
                        continuing {
                            phi_3414_ = _e1674;
                            phi_1038_ = _e1676;
                            phi_1041_ = _e1678;
                            phi_1043_ = _e1680;
                            phi_1045_ = _e1682;
                            phi_1047_ = _e1684;
                            phi_3573_ = _e1674;
                            break if !(_e1686);
                        }
                    }
                    let _e1689 = phi_3573_;
                    if _e1689 {
                        break;
                    }
                    let _e1691 = local_10;
                    let _e1694 = local_11;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_6.member[_e131][0u] = _e1691.member_1;
                    global_6.member[_e131][1u] = _e1694.member_2;
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
