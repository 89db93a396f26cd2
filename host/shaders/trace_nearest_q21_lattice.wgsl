struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_36 {
    member: array<array<type_20, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_55 {
    member: type_24,
    member_1: u32,
}

struct type_56 {
    member: array<vec4<f32>, 3>,
    member_1: type_55,
    member_2: type_55,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_49;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var local_9: array<type_20, 8>;
    var local_10: array<f32, 128>;
    var local_11: array<u32, 3>;
    var local_12: array<array<f32, 3>, 3>;
    var local_13: array<f32, 4>;
    var phi_411_: i32;
    var phi_412_: i32;
    var phi_422_: bool;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_435_: bool;
    var phi_440_: u32;
    var phi_453_: i32;
    var phi_473_: i32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_669_: f32;
    var phi_680_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_3954_: bool;
    var phi_3853_: f32;
    var phi_923_: type_55;
    var phi_926_: u32;
    var phi_928_: bool;
    var phi_930_: u32;
    var phi_941_: bool;
    var phi_1028_: type_55;
    var phi_1029_: bool;
    var phi_1030_: u32;
    var phi_2722_: u32;
    var phi_2728_: u32;
    var phi_2982_: u32;
    var phi_2983_: u32;
    var phi_2993_: u32;
    var phi_2995_: u32;
    var phi_2996_: bool;
    var phi_3016_: u32;
    var phi_3017_: u32;
    var phi_3021_: type_56;
    var phi_3366_: type_55;
    var phi_3443_: type_55;
    var phi_3444_: type_55;
    var phi_3445_: u32;
    var phi_3447_: type_55;
    var phi_3448_: u32;
    var phi_3449_: bool;
    var phi_3458_: type_55;
    var phi_3463_: type_55;
    var phi_3464_: bool;
    var phi_4026_: f32;
    var phi_3951_: bool;
    var phi_1049_: type_8;
    var phi_1050_: type_8;
    var phi_1073_: type_8;
    var phi_1114_: u32;
    var phi_1120_: u32;
    var phi_1130_: u32;
    var phi_1146_: u32;
    var phi_1183_: u32;
    var phi_1189_: u32;
    var phi_1199_: u32;
    var phi_3936_: bool;
    var phi_1215_: type_8;
    var phi_1216_: type_8;
    var phi_1239_: type_8;
    var phi_1262_: u32;
    var phi_1277_: u32;
    var phi_1280_: type_8;
    var phi_1281_: type_8;
    var phi_1304_: type_8;
    var phi_1370_: u32;
    var phi_1350_: u32;
    var phi_1351_: u32;
    var phi_1374_: f32;
    var phi_3929_: bool;
    var phi_4008_: bool;
    var phi_4007_: bool;
    var phi_1875_: vec3<f32>;
    var phi_1876_: vec3<f32>;
    var phi_1907_: bool;
    var phi_1916_: vec3<f32>;
    var phi_1956_: type_20;
    var phi_1958_: type_20;
    var phi_1959_: bool;
    var phi_1963_: type_20;
    var phi_1964_: type_20;
    var phi_1965_: type_20;
    var phi_1966_: bool;
    var phi_1970_: type_20;
    var phi_1971_: bool;
    var phi_1975_: type_20;
    var phi_1976_: bool;
    var phi_1980_: type_20;
    var phi_1992_: type_8;
    var phi_1995_: type_20;
    var phi_1993_: type_8;
    var phi_2018_: type_8;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2072_: type_20;
    var phi_1996_: type_20;
    var phi_4038_: bool;
    var phi_4322_: f32;
    var phi_4321_: f32;
    var phi_4100_: bool;
    var phi_4320_: f32;
    var phi_4099_: bool;
    var phi_4319_: f32;
    var phi_4098_: bool;
    var phi_4259_: f32;
    var phi_4097_: bool;
    var phi_4224_: f32;
    var phi_4106_: bool;
    var phi_3466_: type_55;
    var phi_3467_: bool;
    var phi_3468_: u32;
    var phi_4223_: f32;
    var phi_4105_: bool;
    var phi_3469_: type_55;
    var phi_3470_: u32;
    var phi_3471_: bool;
    var phi_3472_: u32;
    var phi_4222_: f32;
    var phi_4104_: bool;
    var phi_3473_: type_55;
    var phi_3474_: u32;
    var phi_3475_: bool;
    var phi_3476_: u32;
    var phi_4221_: f32;
    var phi_4103_: bool;
    var phi_924_: type_55;
    var phi_927_: u32;
    var phi_929_: bool;
    var phi_931_: u32;
    var phi_3477_: bool;
    var phi_4102_: bool;
    var phi_3484_: type_8;
    var phi_3485_: type_8;
    var phi_3508_: type_8;
    var phi_3574_: type_20;
    var phi_4214_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_3.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_3.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_3.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_3.member[_e153].member_1;
                    let _e216 = (bitcast<u32>(_e214) & 2147483647u);
                    let _e223 = global_3.member[_e153].member_3;
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && ((bitcast<u32>(_e223) & 2147483647u) <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_411_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_411_;
                        phi_412_ = _e246;
                    } else {
                        phi_412_ = 0i;
                    }
                    let _e248 = phi_412_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_422_ = true;
                    } else {
                        phi_422_ = (_e172 == _e204);
                    }
                    let _e252 = phi_422_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_432_ = _e254;
                        phi_433_ = _e254;
                        phi_435_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_432_ = u32();
                        phi_433_ = 0u;
                        phi_435_ = true;
                    }
                    let _e258 = phi_432_;
                    let _e260 = phi_433_;
                    let _e262 = phi_435_;
                    if _e262 {
                        phi_440_ = (_e260 + 1u);
                    } else {
                        phi_440_ = 0u;
                    }
                    let _e266 = phi_440_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_453_ = -126i;
                    } else {
                        phi_453_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_453_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_473_ = -126i;
                    } else {
                        phi_473_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_473_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_491_ = _e305[0];
                    } else {
                        phi_491_ = _e305[1];
                    }
                    let _e310 = phi_491_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_497_ = _e305[2];
                    } else {
                        phi_497_ = _e310;
                    }
                    let _e314 = phi_497_;
                    let _e316 = ((_e314 * _e278) * _e284);
                    let _e317 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_508_ = _e317[0];
                    } else {
                        phi_508_ = _e317[1];
                    }
                    let _e321 = phi_508_;
                    if _e311 {
                        phi_514_ = _e317[2];
                    } else {
                        phi_514_ = _e321;
                    }
                    let _e324 = phi_514_;
                    let _e326 = ((_e324 * _e295) * _e301);
                    let _e330 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e330 {
                        let _e334 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) * 0.00000011920929f);
                        phi_537_ = select(0.00000000000011368684f, _e334, (_e334 > 0.00000000000011368684f));
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e338 = phi_537_;
                    let _e339 = (_e316 + _e338);
                    let _e340 = (_e316 - _e338);
                    let _e341 = select(_e326, 0f, _e330);
                    if _e330 {
                        phi_548_ = 38685626000000000000000000f;
                    } else {
                        phi_548_ = (1f / _e326);
                    }
                    let _e344 = phi_548_;
                    let _e345 = (_e266 == 0u);
                    if _e345 {
                        phi_557_ = _e305[0];
                    } else {
                        phi_557_ = _e305[1];
                    }
                    let _e349 = phi_557_;
                    let _e350 = (_e266 == 2u);
                    if _e350 {
                        phi_563_ = _e305[2];
                    } else {
                        phi_563_ = _e349;
                    }
                    let _e353 = phi_563_;
                    let _e355 = ((_e353 * _e278) * _e284);
                    if _e345 {
                        phi_574_ = _e317[0];
                    } else {
                        phi_574_ = _e317[1];
                    }
                    let _e359 = phi_574_;
                    if _e350 {
                        phi_580_ = _e317[2];
                    } else {
                        phi_580_ = _e359;
                    }
                    let _e362 = phi_580_;
                    let _e364 = ((_e362 * _e295) * _e301);
                    let _e368 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e368 {
                        let _e372 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) * 0.00000011920929f);
                        phi_603_ = select(0.00000000000011368684f, _e372, (_e372 > 0.00000000000011368684f));
                    } else {
                        phi_603_ = 0f;
                    }
                    let _e376 = phi_603_;
                    let _e377 = (_e355 + _e376);
                    let _e378 = (_e355 - _e376);
                    let _e379 = select(_e364, 0f, _e368);
                    if _e368 {
                        phi_614_ = 38685626000000000000000000f;
                    } else {
                        phi_614_ = (1f / _e364);
                    }
                    let _e382 = phi_614_;
                    let _e383 = (_e268 == 0u);
                    if _e383 {
                        phi_623_ = _e305[0];
                    } else {
                        phi_623_ = _e305[1];
                    }
                    let _e387 = phi_623_;
                    let _e388 = (_e268 == 2u);
                    if _e388 {
                        phi_629_ = _e305[2];
                    } else {
                        phi_629_ = _e387;
                    }
                    let _e391 = phi_629_;
                    let _e393 = ((_e391 * _e278) * _e284);
                    if _e383 {
                        phi_640_ = _e317[0];
                    } else {
                        phi_640_ = _e317[1];
                    }
                    let _e397 = phi_640_;
                    if _e388 {
                        phi_646_ = _e317[2];
                    } else {
                        phi_646_ = _e397;
                    }
                    let _e400 = phi_646_;
                    let _e402 = ((_e400 * _e295) * _e301);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_669_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_669_ = 0f;
                    }
                    let _e414 = phi_669_;
                    let _e415 = (_e393 + _e414);
                    let _e416 = (_e393 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_680_ = 38685626000000000000000000f;
                    } else {
                        phi_680_ = (1f / _e402);
                    }
                    let _e420 = phi_680_;
                    let _e423 = bitcast<f32>((bitcast<u32>(_e316) & 2147483647u));
                    let _e426 = bitcast<f32>((bitcast<u32>(_e355) & 2147483647u));
                    let _e428 = select(_e426, _e423, (_e423 > _e426));
                    let _e431 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e434 = (_e135 + _e248);
                    if (_e229 && (select(_e431, _e428, (_e428 > _e431)) <= 1099511600000f)) {
                        let _e437 = (_e434 / 3i);
                        let _e444 = bitcast<f32>((bitcast<u32>((_e437 + 127i)) << bitcast<u32>(23i)));
                        let _e451 = bitcast<f32>((bitcast<u32>(((_e434 - (2i * _e437)) + 127i)) << bitcast<u32>(23i)));
                        let _e452 = (((_e214 * _e444) * _e444) * _e451);
                        let _e454 = select(340282350000000000000000000000000000000f, _e452, (_e452 < 340282350000000000000000000000000000000f));
                        let _e459 = (((_e223 * _e444) * _e444) * _e451);
                        let _e461 = select(340282350000000000000000000000000000000f, _e459, (_e459 < 340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e461, (_e461 > -340282350000000000000000000000000000000f));
                        phi_781_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_780_ = 0f;
                        phi_781_ = 1f;
                    }
                    let _e465 = phi_780_;
                    let _e467 = phi_781_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e470 = (_e267 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e266 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    let _e482 = (_e268 % 3u);
                    let _e483 = (_e482 < 3u);
                    if _e483 {
                    } else {
                        break;
                    }
                    let _e485 = local_1[_e482];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e494 = local[_e476];
                    if _e483 {
                    } else {
                        break;
                    }
                    let _e498 = local[_e482];
                    phi_3954_ = false;
                    phi_3853_ = _e465;
                    phi_923_ = type_55(type_24(vec4<f32>((f32(_e473) * _e147), (f32(_e479) * _e147), (f32(_e485) * _e147), 0f), vec4<f32>((f32(_e490) * _e147), (f32(_e494) * _e147), (f32(_e498) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_926_ = ((3u * _e96) + 1u);
                    phi_928_ = (_e467 <= _e465);
                    phi_930_ = 0u;
                    loop {
                        let _e508 = phi_3954_;
                        let _e510 = phi_3853_;
                        let _e512 = phi_923_;
                        let _e514 = phi_926_;
                        let _e516 = phi_928_;
                        let _e518 = phi_930_;
                        if _e516 {
                            phi_941_ = true;
                        } else {
                            phi_941_ = (_e518 > 0u);
                        }
                        let _e521 = phi_941_;
                        if _e521 {
                            let _e522 = (_e514 > 0u);
                            if _e522 {
                                if _e516 {
                                    phi_1028_ = _e512;
                                    phi_1029_ = _e516;
                                    phi_1030_ = _e518;
                                } else {
                                    let _e523 = (_e518 - 1u);
                                    let _e524 = (_e523 % 128u);
                                    let _e525 = (_e524 < 128u);
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e527 = local_7[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e529 = local_6[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e531 = local_5[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e533 = local_4[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e535 = local_3[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e537 = local_2[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e542 = local_8[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4102_ = true;
                                        break;
                                    }
                                    let _e545 = local_10[_e524];
                                    phi_1028_ = type_55(type_24(vec4<f32>(_e527, _e529, _e531, 0f), vec4<f32>(_e533, _e535, _e537, 0f)), _e542);
                                    phi_1029_ = (_e545 <= _e510);
                                    phi_1030_ = _e523;
                                }
                                let _e548 = phi_1028_;
                                let _e550 = phi_1029_;
                                let _e552 = phi_1030_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_4026_ = _e510;
                                        phi_3951_ = _e508;
                                        phi_1049_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1037 = phi_4026_;
                                            let _e1039 = phi_3951_;
                                            let _e1041 = phi_1049_;
                                            if (_e1041.member < _e1041.member_1) {
                                                phi_1050_ = type_8((_e1041.member + 1u), _e1041.member_1);
                                                phi_1073_ = type_8(1u, _e1041.member);
                                            } else {
                                                phi_1050_ = _e1041;
                                                phi_1073_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1054 = phi_1050_;
                                            let _e1056 = phi_1073_;
                                            let _e1060 = (bitcast<i32>(_e1056.member) != 0i);
                                            if _e1060 {
                                                let _e1065 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1068 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1071 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1073 = select(_e1068, _e1065, (_e1065 > _e1068));
                                                let _e1075 = select(_e1071, _e1073, (_e1073 > _e1071));
                                                let _e1077 = (_e1075 < (1024f * _e147));
                                                if _e1077 {
                                                    phi_1114_ = 0u;
                                                } else {
                                                    phi_1114_ = select(2u, 1u, (_e1075 < (2097152f * _e147)));
                                                }
                                                let _e1082 = phi_1114_;
                                                switch bitcast<i32>(_e1082) {
                                                    case 0: {
                                                        phi_1120_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1120_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1120_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1120_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1085 = phi_1120_;
                                                switch bitcast<i32>(_e1082) {
                                                    case 0: {
                                                        phi_1130_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1130_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1130_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1130_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1092 = phi_1130_;
                                                let _e1094 = ((_e557 + (_e1056.member_1 * ((3u * _e1085) + 1u))) + (3u * _e1092));
                                                let _e1095 = (_e1094 < _e99);
                                                if _e1095 {
                                                    if _e1095 {
                                                    } else {
                                                        phi_4259_ = _e1037;
                                                        phi_4097_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_5.member[_e1094];
                                                    phi_1146_ = _e1097;
                                                } else {
                                                    phi_1146_ = 4294967295u;
                                                }
                                                let _e1099 = phi_1146_;
                                                local_11 = array<u32, 3>(_e267, _e266, _e268);
                                                if _e1077 {
                                                    phi_1183_ = 0u;
                                                } else {
                                                    phi_1183_ = select(2u, 1u, (_e1075 < (2097152f * _e147)));
                                                }
                                                let _e1105 = phi_1183_;
                                                switch bitcast<i32>(_e1105) {
                                                    case 0: {
                                                        phi_1189_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1189_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1189_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1189_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1108 = phi_1189_;
                                                switch bitcast<i32>(_e1105) {
                                                    case 0: {
                                                        phi_1199_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1199_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1199_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1199_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1115 = phi_1199_;
                                                local_13 = array<f32, 4>(_e548.member.member.x, _e548.member.member.y, _e548.member.member.z, _e548.member.member.w);
                                                local_12[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3936_ = _e1039;
                                                phi_1215_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1129 = phi_3936_;
                                                    let _e1131 = phi_1215_;
                                                    if (_e1131.member < _e1131.member_1) {
                                                        phi_1216_ = type_8((_e1131.member + 1u), _e1131.member_1);
                                                        phi_1239_ = type_8(1u, _e1131.member);
                                                    } else {
                                                        phi_1216_ = _e1131;
                                                        phi_1239_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1144 = phi_1216_;
                                                    let _e1146 = phi_1239_;
                                                    let _e1150 = (bitcast<i32>(_e1146.member) != 0i);
                                                    if _e1150 {
                                                        let _e1152 = ((_e557 + (_e1056.member_1 * ((3u * _e1108) + 1u))) + (_e1146.member_1 * _e1115));
                                                        let _e1153 = (_e1152 < _e99);
                                                        if _e1153 {
                                                            if _e1153 {
                                                            } else {
                                                                phi_4007_ = true;
                                                                break;
                                                            }
                                                            let _e1155 = global_5.member[_e1152];
                                                            phi_1262_ = _e1155;
                                                        } else {
                                                            phi_1262_ = 0u;
                                                        }
                                                        let _e1157 = phi_1262_;
                                                        let _e1158 = (_e1152 + 1u);
                                                        let _e1159 = (_e1158 < _e99);
                                                        if _e1159 {
                                                            if _e1159 {
                                                            } else {
                                                                phi_4007_ = true;
                                                                break;
                                                            }
                                                            let _e1161 = global_5.member[_e1158];
                                                            phi_1277_ = _e1161;
                                                        } else {
                                                            phi_1277_ = 0u;
                                                        }
                                                        let _e1163 = phi_1277_;
                                                        phi_1280_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1165 = phi_1280_;
                                                            if (_e1165.member < _e1165.member_1) {
                                                                phi_1281_ = type_8((_e1165.member + 1u), _e1165.member_1);
                                                                phi_1304_ = type_8(1u, _e1165.member);
                                                            } else {
                                                                phi_1281_ = _e1165;
                                                                phi_1304_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1178 = phi_1281_;
                                                            let _e1180 = phi_1304_;
                                                            let _e1184 = (bitcast<i32>(_e1180.member) != 0i);
                                                            if _e1184 {
                                                                let _e1185 = (_e1180.member_1 < 3u);
                                                                if _e1185 {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                let _e1187 = local_11[_e1180.member_1];
                                                                if (_e1180.member_1 < 4u) {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                let _e1190 = local_13[_e1180.member_1];
                                                                switch bitcast<i32>(_e1105) {
                                                                    case 0: {
                                                                        phi_1374_ = (_e1190 + (f32(((_e1157 >> bitcast<u32>(((10u * _e1187) & 31u))) & 1023u)) * _e147));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1187 == 0u) {
                                                                            phi_1351_ = _e1157;
                                                                        } else {
                                                                            if (_e1187 == 1u) {
                                                                                phi_1350_ = ((_e1157 >> bitcast<u32>(21i)) | (_e1163 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1350_ = (_e1163 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1211 = phi_1350_;
                                                                            phi_1351_ = _e1211;
                                                                        }
                                                                        let _e1213 = phi_1351_;
                                                                        phi_1374_ = (_e1190 + (f32((_e1213 & 2097151u)) * _e147));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1192 = (_e1152 + _e1187);
                                                                        let _e1193 = (_e1192 < _e99);
                                                                        if _e1193 {
                                                                            if _e1193 {
                                                                            } else {
                                                                                phi_3929_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1195 = global_5.member[_e1192];
                                                                            phi_1370_ = _e1195;
                                                                        } else {
                                                                            phi_1370_ = 0u;
                                                                        }
                                                                        let _e1197 = phi_1370_;
                                                                        phi_1374_ = (f32(bitcast<i32>(_e1197)) * _e147);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1374_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1227 = phi_1374_;
                                                                if (_e1146.member_1 < 3u) {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                if _e1185 {
                                                                } else {
                                                                    phi_3929_ = true;
                                                                    break;
                                                                }
                                                                local_12[_e1146.member_1][_e1180.member_1] = _e1227;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1280_ = _e1178;
                                                                phi_3929_ = _e1129;
                                                                break if !(_e1184);
                                                            }
                                                        }
                                                        let _e1233 = phi_3929_;
                                                        phi_4007_ = _e1233;
                                                        if _e1233 {
                                                            break;
                                                        }
                                                        phi_4008_ = _e1233;
                                                    } else {
                                                        phi_4008_ = _e1129;
                                                    }
                                                    let _e1235 = phi_4008_;
                                                    continue;
                                                    continuing {
                                                        phi_3936_ = _e1235;
                                                        phi_1215_ = _e1144;
                                                        phi_4007_ = _e1235;
                                                        break if !(_e1150);
                                                    }
                                                }
                                                let _e1238 = phi_4007_;
                                                phi_4259_ = _e1037;
                                                phi_4097_ = _e1238;
                                                if _e1238 {
                                                    break;
                                                }
                                                let _e1239 = local_12;
                                                let _e1254 = (_e1239[0][2] - _e393);
                                                let _e1257 = (((_e1239[0][0] - _e316) * _e417) - (_e1254 * _e341));
                                                let _e1260 = (((_e1239[0][1] - _e355) * _e417) - (_e1254 * _e379));
                                                let _e1263 = (_e1239[1][2] - _e393);
                                                let _e1266 = (((_e1239[1][0] - _e316) * _e417) - (_e1263 * _e341));
                                                let _e1269 = (((_e1239[1][1] - _e355) * _e417) - (_e1263 * _e379));
                                                let _e1272 = (_e1239[2][2] - _e393);
                                                let _e1275 = (((_e1239[2][0] - _e316) * _e417) - (_e1272 * _e341));
                                                let _e1278 = (((_e1239[2][1] - _e355) * _e417) - (_e1272 * _e379));
                                                let _e1279 = (_e1275 * _e1269);
                                                let _e1280 = (_e1278 * _e1266);
                                                let _e1281 = (_e1257 * _e1278);
                                                let _e1282 = (_e1260 * _e1275);
                                                let _e1283 = (_e1266 * _e1260);
                                                let _e1284 = (_e1269 * _e1257);
                                                let _e1289 = (((_e1279 >= _e1280) && (_e1281 >= _e1282)) && (_e1283 >= _e1284));
                                                if (_e1289 || (((_e1279 <= _e1280) && (_e1281 <= _e1282)) && (_e1283 <= _e1284))) {
                                                    let _e1296 = select(-1f, 1f, _e1289);
                                                    let _e1298 = ((_e1279 - _e1280) * _e1296);
                                                    let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                                                    let _e1302 = ((_e1281 - _e1282) * _e1296);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1283 - _e1284) * _e1296);
                                                    let _e1308 = select(0f, _e1306, (_e1306 > 0f));
                                                    let _e1310 = ((_e1300 + _e1304) + _e1308);
                                                    if (_e1310 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1970_ = type_20();
                                                        phi_1971_ = true;
                                                    } else {
                                                        let _e1313 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] < _e1239[1][0]));
                                                        let _e1317 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] > _e1239[1][0]));
                                                        let _e1321 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] < _e1239[1][1]));
                                                        let _e1325 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] > _e1239[1][1]));
                                                        let _e1329 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] < _e1239[1][2]));
                                                        let _e1333 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] > _e1239[1][2]));
                                                        let _e1338 = ((select(_e1239[2][0], _e1313, (_e1313 < _e1239[2][0])) - _e339) * _e344);
                                                        let _e1339 = ((select(_e1239[2][0], _e1317, (_e1317 > _e1239[2][0])) - _e340) * _e344);
                                                        let _e1342 = ((select(_e1239[2][1], _e1321, (_e1321 < _e1239[2][1])) - _e377) * _e382);
                                                        let _e1343 = ((select(_e1239[2][1], _e1325, (_e1325 > _e1239[2][1])) - _e378) * _e382);
                                                        let _e1346 = ((select(_e1239[2][2], _e1329, (_e1329 < _e1239[2][2])) - _e415) * _e420);
                                                        let _e1347 = ((select(_e1239[2][2], _e1333, (_e1333 > _e1239[2][2])) - _e416) * _e420);
                                                        let _e1349 = select(_e1347, _e1346, (_e1346 < _e1347));
                                                        let _e1351 = select(_e1347, _e1346, (_e1346 > _e1347));
                                                        let _e1353 = select(_e1339, _e1338, (_e1338 < _e1339));
                                                        let _e1355 = select(_e1343, _e1342, (_e1342 < _e1343));
                                                        let _e1357 = select(_e1355, _e1353, (_e1353 > _e1355));
                                                        let _e1359 = select(_e1349, _e1357, (_e1357 > _e1349));
                                                        let _e1361 = select(_e1339, _e1338, (_e1338 > _e1339));
                                                        let _e1363 = select(_e1343, _e1342, (_e1342 > _e1343));
                                                        let _e1365 = select(_e1363, _e1361, (_e1361 < _e1363));
                                                        let _e1367 = select(_e1351, _e1365, (_e1365 < _e1351));
                                                        let _e1368 = -(_e1349);
                                                        let _e1374 = select(_e467, _e1359, (_e1359 > _e467));
                                                        if (_e1374 > (_e1367 + (select(_e1368, _e1351, (_e1351 > _e1368)) * 0.0000019073523f))) {
                                                            phi_1965_ = type_20();
                                                            phi_1966_ = true;
                                                        } else {
                                                            let _e1376 = (_e1374 > _e1037);
                                                            if _e1376 {
                                                                phi_1964_ = type_20();
                                                            } else {
                                                                let _e1380 = (_e1239[1][0] - _e1239[0][0]);
                                                                let _e1381 = (_e1239[1][1] - _e1239[0][1]);
                                                                let _e1382 = (_e1239[1][2] - _e1239[0][2]);
                                                                let _e1383 = vec3<f32>(_e1380, _e1381, _e1382);
                                                                let _e1384 = (_e1239[2][0] - _e1239[1][0]);
                                                                let _e1385 = (_e1239[2][1] - _e1239[1][1]);
                                                                let _e1386 = (_e1239[2][2] - _e1239[1][2]);
                                                                let _e1387 = vec3<f32>(_e1384, _e1385, _e1386);
                                                                let _e1388 = (_e1239[0][0] - _e1239[2][0]);
                                                                let _e1389 = (_e1239[0][1] - _e1239[2][1]);
                                                                let _e1390 = (_e1239[0][2] - _e1239[2][2]);
                                                                let _e1391 = vec3<f32>(_e1388, _e1389, _e1390);
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                let _e1397 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1399 = select(_e1397, _e1394, (_e1394 > _e1397));
                                                                let _e1402 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1404 = select(_e1402, _e1399, (_e1399 > _e1402));
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1384) & 2147483647u));
                                                                let _e1410 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1412 = select(_e1410, _e1407, (_e1407 > _e1410));
                                                                let _e1415 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1417 = select(_e1415, _e1412, (_e1412 > _e1415));
                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u));
                                                                let _e1423 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
                                                                let _e1425 = select(_e1423, _e1420, (_e1420 > _e1423));
                                                                let _e1428 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                let _e1432 = select(_e1417, _e1404, (_e1404 > _e1417));
                                                                let _e1434 = select(_e1430, _e1432, (_e1432 > _e1430));
                                                                if (_e1404 == _e1434) {
                                                                    phi_1875_ = _e1387;
                                                                    phi_1876_ = _e1391;
                                                                } else {
                                                                    let _e1437 = vec3((_e1417 == _e1434));
                                                                    phi_1875_ = select(_e1383, _e1391, _e1437);
                                                                    phi_1876_ = select(_e1387, _e1383, _e1437);
                                                                }
                                                                let _e1441 = phi_1875_;
                                                                let _e1443 = phi_1876_;
                                                                let _e1450 = ((_e1441.y * _e1443.z) - (_e1443.y * _e1441.z));
                                                                let _e1455 = ((_e1441.z * _e1443.x) - (_e1443.z * _e1441.x));
                                                                let _e1458 = ((_e1441.x * _e1443.y) - (_e1443.x * _e1441.y));
                                                                if (_e1300 >= _e1304) {
                                                                    phi_1907_ = select(true, false, (_e1300 >= _e1308));
                                                                } else {
                                                                    phi_1907_ = true;
                                                                }
                                                                let _e1463 = phi_1907_;
                                                                if _e1463 {
                                                                    phi_1916_ = select(vec3<f32>(_e1239[2][0], _e1239[2][1], _e1239[2][2]), vec3<f32>(_e1239[1][0], _e1239[1][1], _e1239[1][2]), vec3((_e1304 >= _e1308)));
                                                                } else {
                                                                    phi_1916_ = vec3<f32>(_e1239[0][0], _e1239[0][1], _e1239[0][2]);
                                                                }
                                                                let _e1468 = phi_1916_;
                                                                let _e1485 = ((((_e1450 * (_e1468.x - _e316)) + (_e1455 * (_e1468.y - _e355))) + (_e1458 * (_e1468.z - _e393))) / (((_e1450 * _e341) + (_e1455 * _e379)) + (_e1458 * _e417)));
                                                                let _e1487 = select(_e1367, _e1485, (_e1485 < _e1367));
                                                                let _e1489 = select(_e1359, _e1487, (_e1487 > _e1359));
                                                                if (_e1489 >= _e467) {
                                                                    let _e1491 = (_e1489 <= _e1037);
                                                                    if _e1491 {
                                                                        let _e1492 = (1f / _e1310);
                                                                        phi_1956_ = type_20(_e1489, (_e1304 * _e1492), (_e1308 * _e1492), _e1099);
                                                                    } else {
                                                                        phi_1956_ = type_20();
                                                                    }
                                                                    let _e1497 = phi_1956_;
                                                                    phi_1958_ = _e1497;
                                                                    phi_1959_ = select(true, false, _e1491);
                                                                } else {
                                                                    phi_1958_ = type_20();
                                                                    phi_1959_ = true;
                                                                }
                                                                let _e1500 = phi_1958_;
                                                                let _e1502 = phi_1959_;
                                                                if _e1502 {
                                                                    phi_1963_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1963_ = _e1500;
                                                                }
                                                                let _e1504 = phi_1963_;
                                                                phi_1964_ = _e1504;
                                                            }
                                                            let _e1506 = phi_1964_;
                                                            phi_1965_ = _e1506;
                                                            phi_1966_ = _e1376;
                                                        }
                                                        let _e1508 = phi_1965_;
                                                        let _e1510 = phi_1966_;
                                                        phi_1970_ = _e1508;
                                                        phi_1971_ = _e1510;
                                                    }
                                                    let _e1512 = phi_1970_;
                                                    let _e1514 = phi_1971_;
                                                    phi_1975_ = _e1512;
                                                    phi_1976_ = _e1514;
                                                } else {
                                                    phi_1975_ = type_20();
                                                    phi_1976_ = true;
                                                }
                                                let _e1516 = phi_1975_;
                                                let _e1518 = phi_1976_;
                                                if _e1518 {
                                                    phi_1980_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1980_ = _e1516;
                                                }
                                                let _e1520 = phi_1980_;
                                                if (_e1520.member_3 != 4294967295u) {
                                                    if (_e1099 != 4294967295u) {
                                                        phi_1992_ = type_8(0u, 8u);
                                                        phi_1995_ = _e1520;
                                                        loop {
                                                            let _e1525 = phi_1992_;
                                                            let _e1527 = phi_1995_;
                                                            if (_e1525.member < _e1525.member_1) {
                                                                phi_1993_ = type_8((_e1525.member + 1u), _e1525.member_1);
                                                                phi_2018_ = type_8(1u, _e1525.member);
                                                            } else {
                                                                phi_1993_ = _e1525;
                                                                phi_2018_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1540 = phi_1993_;
                                                            let _e1542 = phi_2018_;
                                                            let _e1546 = (bitcast<i32>(_e1542.member) != 0i);
                                                            if _e1546 {
                                                                let _e1547 = (_e1542.member_1 < 8u);
                                                                if _e1547 {
                                                                } else {
                                                                    phi_4038_ = true;
                                                                    break;
                                                                }
                                                                let _e1552 = local_9[_e1542.member_1].member;
                                                                if (_e1527.member < _e1552) {
                                                                    phi_2051_ = true;
                                                                } else {
                                                                    let _e1554 = local_9[_e1542.member_1].member;
                                                                    if (_e1527.member == _e1554) {
                                                                        let _e1559 = local_9[_e1542.member_1].member_3;
                                                                        phi_2050_ = (_e1527.member_3 < _e1559);
                                                                    } else {
                                                                        phi_2050_ = false;
                                                                    }
                                                                    let _e1562 = phi_2050_;
                                                                    phi_2051_ = _e1562;
                                                                }
                                                                let _e1564 = phi_2051_;
                                                                if _e1564 {
                                                                    if _e1547 {
                                                                    } else {
                                                                        phi_4038_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1565 = local_9[_e1542.member_1];
                                                                    local_9[_e1542.member_1] = type_20(_e1527.member, _e1527.member_1, _e1527.member_2, _e1527.member_3);
                                                                    phi_2072_ = type_20(_e1565.member, _e1565.member_1, _e1565.member_2, _e1565.member_3);
                                                                } else {
                                                                    phi_2072_ = _e1527;
                                                                }
                                                                let _e1576 = phi_2072_;
                                                                phi_1996_ = _e1576;
                                                            } else {
                                                                phi_1996_ = type_20();
                                                            }
                                                            let _e1578 = phi_1996_;
                                                            continue;
                                                            continuing {
                                                                phi_1992_ = _e1540;
                                                                phi_1995_ = _e1578;
                                                                phi_4038_ = _e1238;
                                                                break if !(_e1546);
                                                            }
                                                        }
                                                        let _e1581 = phi_4038_;
                                                        phi_4259_ = _e1037;
                                                        phi_4097_ = _e1581;
                                                        if _e1581 {
                                                            break;
                                                        }
                                                        let _e1584 = local_9[7u].member_3;
                                                        if (_e1584 != 4294967295u) {
                                                            let _e1588 = local_9[7u].member;
                                                            phi_4322_ = _e1588;
                                                        } else {
                                                            phi_4322_ = _e1037;
                                                        }
                                                        let _e1590 = phi_4322_;
                                                        phi_4321_ = _e1590;
                                                        phi_4100_ = _e1581;
                                                    } else {
                                                        phi_4321_ = _e1037;
                                                        phi_4100_ = _e1238;
                                                    }
                                                    let _e1592 = phi_4321_;
                                                    let _e1594 = phi_4100_;
                                                    phi_4320_ = _e1592;
                                                    phi_4099_ = _e1594;
                                                } else {
                                                    phi_4320_ = _e1037;
                                                    phi_4099_ = _e1238;
                                                }
                                                let _e1596 = phi_4320_;
                                                let _e1598 = phi_4099_;
                                                phi_4319_ = _e1596;
                                                phi_4098_ = _e1598;
                                            } else {
                                                phi_4319_ = _e1037;
                                                phi_4098_ = _e1039;
                                            }
                                            let _e1600 = phi_4319_;
                                            let _e1602 = phi_4098_;
                                            continue;
                                            continuing {
                                                phi_4026_ = _e1600;
                                                phi_3951_ = _e1602;
                                                phi_1049_ = _e1054;
                                                phi_4259_ = _e1600;
                                                phi_4097_ = _e1602;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1605 = phi_4259_;
                                        let _e1607 = phi_4097_;
                                        phi_4102_ = _e1607;
                                        if _e1607 {
                                            break;
                                        }
                                        phi_4224_ = _e1605;
                                        phi_4106_ = _e1607;
                                        phi_3466_ = _e548;
                                        phi_3467_ = false;
                                        phi_3468_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e96) {
                                            phi_3021_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_55(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_55(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e96) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e566 = ((1u + (_e267 * 2u)) % 7u);
                                            if (_e566 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e571 = global_4.member[_e548.member_1][_e566];
                                            let _e574 = ((1u + (_e266 * 2u)) % 7u);
                                            if (_e574 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e548.member_1][_e574];
                                            let _e582 = ((1u + (_e268 * 2u)) % 7u);
                                            if (_e582 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e587 = global_4.member[_e548.member_1][_e582];
                                            let _e590 = (((_e267 + 1u) * 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e595 = global_4.member[_e548.member_1][_e590];
                                            let _e598 = (((_e266 + 1u) * 2u) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e603 = global_4.member[_e548.member_1][_e598];
                                            let _e606 = (((_e268 + 1u) * 2u) % 7u);
                                            if (_e606 < 7u) {
                                            } else {
                                                phi_4102_ = true;
                                                break;
                                            }
                                            let _e611 = global_4.member[_e548.member_1][_e606];
                                            let _e634 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e636 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e638 = select(_e147, _e634, (_e634 > _e147));
                                            let _e640 = select(_e147, _e635, (_e635 > _e147));
                                            let _e642 = select(_e147, _e636, (_e636 > _e147));
                                            let _e667 = bitcast<u32>((f32(bitcast<i32>((_e571 & 2097151u))) * _e638));
                                            let _e672 = (bitcast<i32>((_e571 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e675 = bitcast<f32>((_e667 & bitcast<u32>(_e672)));
                                            let _e676 = bitcast<u32>((f32(bitcast<i32>((_e579 & 2097151u))) * _e640));
                                            let _e681 = (bitcast<i32>((_e579 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                            let _e685 = bitcast<u32>((f32(bitcast<i32>((_e587 & 2097151u))) * _e642));
                                            let _e690 = (bitcast<i32>((_e587 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                            let _e697 = bitcast<f32>((_e667 & bitcast<u32>(~(_e672))));
                                            let _e701 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                            let _e705 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                            let _e706 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e638));
                                            let _e711 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e714 = bitcast<f32>((_e706 & bitcast<u32>(_e711)));
                                            let _e715 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e640));
                                            let _e720 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e723 = bitcast<f32>((_e715 & bitcast<u32>(_e720)));
                                            let _e724 = bitcast<u32>((f32(bitcast<i32>((_e611 & 2097151u))) * _e642));
                                            let _e729 = (bitcast<i32>((_e611 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e732 = bitcast<f32>((_e724 & bitcast<u32>(_e729)));
                                            let _e736 = bitcast<f32>((_e706 & bitcast<u32>(~(_e711))));
                                            let _e740 = bitcast<f32>((_e715 & bitcast<u32>(~(_e720))));
                                            let _e744 = bitcast<f32>((_e724 & bitcast<u32>(~(_e729))));
                                            let _e745 = (_e548.member.member.x + _e675);
                                            let _e746 = (_e548.member.member.y + _e684);
                                            let _e747 = (_e548.member.member.z + _e693);
                                            let _e750 = (_e548.member.member_1.x - _e714);
                                            let _e751 = (_e548.member.member_1.y - _e723);
                                            let _e752 = (_e548.member.member_1.z - _e732);
                                            let _e771 = (_e750 - _e745);
                                            let _e772 = (_e751 - _e746);
                                            let _e773 = (_e752 - _e747);
                                            let _e775 = select(_e772, _e771, (_e771 > _e772));
                                            let _e777 = select(_e773, _e775, (_e775 > _e773));
                                            if (_e777 < (1024f * _e147)) {
                                                phi_2722_ = 0u;
                                            } else {
                                                phi_2722_ = select(2u, 1u, (_e777 < (2097152f * _e147)));
                                            }
                                            let _e784 = phi_2722_;
                                            switch bitcast<i32>(_e784) {
                                                case 0: {
                                                    phi_2728_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2728_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2728_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2728_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e787 = phi_2728_;
                                            let _e793 = global_4.member[_e548.member_1][0u];
                                            let _e797 = global_4.member[_e548.member_1][2u];
                                            let _e801 = global_4.member[_e548.member_1][4u];
                                            let _e805 = global_4.member[_e548.member_1][6u];
                                            let _e817 = (((_e797 >> bitcast<u32>(22i)) | ((_e801 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e805 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e818 = (_e793 & 268435455u);
                                            let _e819 = (_e817 & 268435455u);
                                            let _e822 = ((_e793 >> bitcast<u32>(28u)) & 7u);
                                            let _e830 = ((_e793 >> bitcast<u32>(31i)) | (((_e817 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e831 = (_e822 != 0u);
                                            if (_e822 == 0u) {
                                                phi_2983_ = _e818;
                                            } else {
                                                if (_e822 == 7u) {
                                                    phi_2982_ = 2147483648u;
                                                } else {
                                                    phi_2982_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (_e819 & 268435455u));
                                                }
                                                let _e840 = phi_2982_;
                                                phi_2983_ = _e840;
                                            }
                                            let _e842 = phi_2983_;
                                            if _e831 {
                                                let _e843 = (_e822 != 7u);
                                                if _e843 {
                                                    phi_2993_ = (_e819 + (_e822 * ((3u * _e787) + 1u)));
                                                } else {
                                                    phi_2993_ = u32();
                                                }
                                                let _e847 = phi_2993_;
                                                phi_2995_ = _e847;
                                                phi_2996_ = select(true, false, _e843);
                                            } else {
                                                phi_2995_ = u32();
                                                phi_2996_ = true;
                                            }
                                            let _e850 = phi_2995_;
                                            let _e852 = phi_2996_;
                                            if (_e830 == 0u) {
                                                phi_3017_ = (_e818 + select(0u, 1u, !(_e831)));
                                            } else {
                                                if (_e830 == 7u) {
                                                    phi_3016_ = 2147483648u;
                                                } else {
                                                    phi_3016_ = ((2147483648u | (_e830 << bitcast<u32>(28u))) | (select(_e850, _e819, _e852) & 268435455u));
                                                }
                                                let _e865 = phi_3016_;
                                                phi_3017_ = _e865;
                                            }
                                            let _e867 = phi_3017_;
                                            phi_3021_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e745, (_e548.member.member.x + _e697), _e750, (_e548.member.member_1.x - _e736)), vec4<f32>(_e746, (_e548.member.member.y + _e701), _e751, (_e548.member.member_1.y - _e740)), vec4<f32>(_e747, (_e548.member.member.z + _e705), _e752, (_e548.member.member_1.z - _e744))), type_55(type_24((_e548.member.member + vec4<f32>(_e675, _e684, _e693, 0f)), (_e548.member.member_1 - vec4<f32>(_e714, _e723, _e732, 0f))), _e842), type_55(type_24((_e548.member.member + vec4<f32>(_e697, _e701, _e705, 0f)), (_e548.member.member_1 - vec4<f32>(_e736, _e740, _e744, 0f))), _e867));
                                        }
                                        let _e872 = phi_3021_;
                                        let _e883 = ((_e872.member[0].x - _e339) * _e344);
                                        let _e884 = ((_e872.member[0].y - _e339) * _e344);
                                        let _e885 = ((_e872.member[0].z - _e340) * _e344);
                                        let _e886 = ((_e872.member[0].w - _e340) * _e344);
                                        let _e896 = ((_e872.member[1].x - _e377) * _e382);
                                        let _e897 = ((_e872.member[1].y - _e377) * _e382);
                                        let _e898 = ((_e872.member[1].z - _e378) * _e382);
                                        let _e899 = ((_e872.member[1].w - _e378) * _e382);
                                        let _e909 = ((_e872.member[2].x - _e415) * _e420);
                                        let _e910 = ((_e872.member[2].y - _e415) * _e420);
                                        let _e911 = ((_e872.member[2].z - _e416) * _e420);
                                        let _e912 = ((_e872.member[2].w - _e416) * _e420);
                                        let _e914 = select(_e911, _e909, (_e909 < _e911));
                                        let _e916 = select(_e912, _e910, (_e910 < _e912));
                                        let _e918 = select(_e911, _e909, (_e909 > _e911));
                                        let _e920 = select(_e912, _e910, (_e910 > _e912));
                                        let _e922 = select(_e885, _e883, (_e883 < _e885));
                                        let _e924 = select(_e886, _e884, (_e884 < _e886));
                                        let _e926 = select(_e898, _e896, (_e896 < _e898));
                                        let _e928 = select(_e899, _e897, (_e897 < _e899));
                                        let _e930 = select(_e926, _e922, (_e922 > _e926));
                                        let _e932 = select(_e928, _e924, (_e924 > _e928));
                                        let _e934 = select(_e914, _e930, (_e930 > _e914));
                                        let _e936 = select(_e916, _e932, (_e932 > _e916));
                                        let _e938 = select(_e885, _e883, (_e883 > _e885));
                                        let _e940 = select(_e886, _e884, (_e884 > _e886));
                                        let _e942 = select(_e898, _e896, (_e896 > _e898));
                                        let _e944 = select(_e899, _e897, (_e897 > _e899));
                                        let _e946 = select(_e942, _e938, (_e938 < _e942));
                                        let _e948 = select(_e944, _e940, (_e940 < _e944));
                                        let _e953 = -(_e914);
                                        let _e954 = -(_e916);
                                        let _e961 = (select(_e918, _e946, (_e946 < _e918)) + (select(_e953, _e918, (_e918 > _e953)) * 0.0000019073523f));
                                        let _e962 = (select(_e920, _e948, (_e948 < _e920)) + (select(_e954, _e920, (_e920 > _e954)) * 0.0000019073523f));
                                        let _e964 = select(_e467, _e934, (_e934 > _e467));
                                        let _e966 = select(_e467, _e936, (_e936 > _e467));
                                        let _e971 = (_e964 <= select(_e510, _e961, (_e961 < _e510)));
                                        let _e972 = (_e966 <= select(_e510, _e962, (_e962 < _e510)));
                                        let _e973 = (_e964 <= _e966);
                                        if _e971 {
                                            if _e972 {
                                                if _e973 {
                                                    phi_3366_ = _e872.member_2;
                                                } else {
                                                    phi_3366_ = _e872.member_1;
                                                }
                                                let _e977 = phi_3366_;
                                                let _e999 = (_e552 % 128u);
                                                let _e1000 = (_e999 < 128u);
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_8[_e999] = _e977.member_1;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_7[_e999] = _e977.member.member.x;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_6[_e999] = _e977.member.member.y;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_5[_e999] = _e977.member.member.z;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_4[_e999] = _e977.member.member_1.x;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_3[_e999] = _e977.member.member_1.y;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_2[_e999] = _e977.member.member_1.z;
                                                if _e1000 {
                                                } else {
                                                    phi_4102_ = true;
                                                    break;
                                                }
                                                local_10[_e999] = select(_e966, _e964, (_e964 > _e966));
                                                if _e973 {
                                                    phi_3443_ = _e872.member_1;
                                                } else {
                                                    phi_3443_ = _e872.member_2;
                                                }
                                                let _e1013 = phi_3443_;
                                                phi_3444_ = _e1013;
                                                phi_3445_ = (_e552 + 1u);
                                            } else {
                                                phi_3444_ = type_55();
                                                phi_3445_ = u32();
                                            }
                                            let _e1015 = phi_3444_;
                                            let _e1017 = phi_3445_;
                                            phi_3447_ = _e1015;
                                            phi_3448_ = _e1017;
                                            phi_3449_ = select(true, false, _e972);
                                        } else {
                                            phi_3447_ = type_55();
                                            phi_3448_ = u32();
                                            phi_3449_ = true;
                                        }
                                        let _e1020 = phi_3447_;
                                        let _e1022 = phi_3448_;
                                        let _e1024 = phi_3449_;
                                        if _e1024 {
                                            if _e971 {
                                                phi_3458_ = _e872.member_1;
                                            } else {
                                                phi_3458_ = _e872.member_2;
                                            }
                                            let _e1028 = phi_3458_;
                                            phi_3463_ = _e1028;
                                            phi_3464_ = select(_e972, true, _e971);
                                        } else {
                                            phi_3463_ = _e1020;
                                            phi_3464_ = _e550;
                                        }
                                        let _e1031 = phi_3463_;
                                        let _e1033 = phi_3464_;
                                        phi_4224_ = _e510;
                                        phi_4106_ = _e508;
                                        phi_3466_ = _e1031;
                                        phi_3467_ = _e1033;
                                        phi_3468_ = select(_e1022, _e552, _e1024);
                                    }
                                    let _e1609 = phi_4224_;
                                    let _e1611 = phi_4106_;
                                    let _e1613 = phi_3466_;
                                    let _e1615 = phi_3467_;
                                    let _e1617 = phi_3468_;
                                    phi_4223_ = _e1609;
                                    phi_4105_ = _e1611;
                                    phi_3469_ = _e1613;
                                    phi_3470_ = (_e514 - 1u);
                                    phi_3471_ = _e1615;
                                    phi_3472_ = _e1617;
                                } else {
                                    phi_4223_ = _e510;
                                    phi_4105_ = _e508;
                                    phi_3469_ = _e548;
                                    phi_3470_ = _e514;
                                    phi_3471_ = _e550;
                                    phi_3472_ = _e552;
                                }
                                let _e1619 = phi_4223_;
                                let _e1621 = phi_4105_;
                                let _e1623 = phi_3469_;
                                let _e1625 = phi_3470_;
                                let _e1627 = phi_3471_;
                                let _e1629 = phi_3472_;
                                phi_4222_ = _e1619;
                                phi_4104_ = _e1621;
                                phi_3473_ = _e1623;
                                phi_3474_ = _e1625;
                                phi_3475_ = _e1627;
                                phi_3476_ = _e1629;
                            } else {
                                phi_4222_ = _e510;
                                phi_4104_ = _e508;
                                phi_3473_ = type_55();
                                phi_3474_ = u32();
                                phi_3475_ = bool();
                                phi_3476_ = u32();
                            }
                            let _e1631 = phi_4222_;
                            let _e1633 = phi_4104_;
                            let _e1635 = phi_3473_;
                            let _e1637 = phi_3474_;
                            let _e1639 = phi_3475_;
                            let _e1641 = phi_3476_;
                            phi_4221_ = _e1631;
                            phi_4103_ = _e1633;
                            phi_924_ = _e1635;
                            phi_927_ = _e1637;
                            phi_929_ = _e1639;
                            phi_931_ = _e1641;
                            phi_3477_ = _e522;
                        } else {
                            phi_4221_ = _e510;
                            phi_4103_ = _e508;
                            phi_924_ = type_55();
                            phi_927_ = u32();
                            phi_929_ = bool();
                            phi_931_ = u32();
                            phi_3477_ = false;
                        }
                        let _e1643 = phi_4221_;
                        let _e1645 = phi_4103_;
                        let _e1647 = phi_924_;
                        let _e1649 = phi_927_;
                        let _e1651 = phi_929_;
                        let _e1653 = phi_931_;
                        let _e1655 = phi_3477_;
                        continue;
                        continuing {
                            phi_3954_ = _e1645;
                            phi_3853_ = _e1643;
                            phi_923_ = _e1647;
                            phi_926_ = _e1649;
                            phi_928_ = _e1651;
                            phi_930_ = _e1653;
                            phi_4102_ = _e1645;
                            break if !(_e1655);
                        }
                    }
                    let _e1658 = phi_4102_;
                    if _e1658 {
                        break;
                    }
                    phi_3484_ = type_8(0u, 8u);
                    loop {
                        let _e1660 = phi_3484_;
                        if (_e1660.member < _e1660.member_1) {
                            phi_3485_ = type_8((_e1660.member + 1u), _e1660.member_1);
                            phi_3508_ = type_8(1u, _e1660.member);
                        } else {
                            phi_3485_ = _e1660;
                            phi_3508_ = type_8(0u, type_8().member_1);
                        }
                        let _e1673 = phi_3485_;
                        let _e1675 = phi_3508_;
                        let _e1679 = (bitcast<i32>(_e1675.member) != 0i);
                        if _e1679 {
                            let _e1680 = (_e1675.member_1 < 8u);
                            if _e1680 {
                            } else {
                                phi_4214_ = true;
                                break;
                            }
                            let _e1682 = local_9[_e1675.member_1];
                            if (_e1682.member_3 != 4294967295u) {
                                let _e1688 = -(_e434);
                                let _e1689 = (_e1688 / 3i);
                                let _e1696 = bitcast<f32>((bitcast<u32>((_e1689 + 127i)) << bitcast<u32>(23i)));
                                let _e1704 = (((_e1682.member * _e1696) * _e1696) * bitcast<f32>((bitcast<u32>(((_e1688 - (2i * _e1689)) + 127i)) << bitcast<u32>(23i))));
                                let _e1706 = select(340282350000000000000000000000000000000f, _e1704, (_e1704 < 340282350000000000000000000000000000000f));
                                phi_3574_ = type_20(select(-340282350000000000000000000000000000000f, _e1706, (_e1706 > -340282350000000000000000000000000000000f)), _e1682.member_1, _e1682.member_2, _e1682.member_3);
                            } else {
                                phi_3574_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1711 = phi_3574_;
                            if _e1680 {
                            } else {
                                phi_4214_ = true;
                                break;
                            }
                            local_9[_e1675.member_1] = type_20(_e1711.member, _e1711.member_1, _e1711.member_2, _e1711.member_3);
                        }
                        continue;
                        continuing {
                            phi_3484_ = _e1673;
                            phi_4214_ = _e1658;
                            break if !(_e1679);
                        }
                    }
                    let _e1719 = phi_4214_;
                    if _e1719 {
                        break;
                    }
                    let _e1720 = local_9;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = array<type_20, 8>(type_20(_e1720[0].member, _e1720[0].member_1, _e1720[0].member_2, _e1720[0].member_3), type_20(_e1720[1].member, _e1720[1].member_1, _e1720[1].member_2, _e1720[1].member_3), type_20(_e1720[2].member, _e1720[2].member_1, _e1720[2].member_2, _e1720[2].member_3), type_20(_e1720[3].member, _e1720[3].member_1, _e1720[3].member_2, _e1720[3].member_3), type_20(_e1720[4].member, _e1720[4].member_1, _e1720[4].member_2, _e1720[4].member_3), type_20(_e1720[5].member, _e1720[5].member_1, _e1720[5].member_2, _e1720[5].member_3), type_20(_e1720[6].member, _e1720[6].member_1, _e1720[6].member_2, _e1720[6].member_3), type_20(_e1720[7].member, _e1720[7].member_1, _e1720[7].member_2, _e1720[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
