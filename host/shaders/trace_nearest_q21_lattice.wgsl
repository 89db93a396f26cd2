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

struct type_46 {
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
var<storage> global_4: type_46;
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
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_3796_: bool;
    var phi_3710_: f32;
    var phi_922_: type_55;
    var phi_925_: u32;
    var phi_927_: bool;
    var phi_929_: u32;
    var phi_940_: bool;
    var phi_1027_: type_55;
    var phi_1028_: bool;
    var phi_1029_: u32;
    var phi_2579_: u32;
    var phi_2585_: u32;
    var phi_2839_: u32;
    var phi_2840_: u32;
    var phi_2850_: u32;
    var phi_2852_: u32;
    var phi_2853_: bool;
    var phi_2873_: u32;
    var phi_2874_: u32;
    var phi_2878_: type_56;
    var phi_3223_: type_55;
    var phi_3300_: type_55;
    var phi_3301_: type_55;
    var phi_3302_: u32;
    var phi_3304_: type_55;
    var phi_3305_: u32;
    var phi_3306_: bool;
    var phi_3315_: type_55;
    var phi_3320_: type_55;
    var phi_3321_: bool;
    var phi_3868_: f32;
    var phi_3793_: bool;
    var phi_1048_: type_8;
    var phi_1049_: type_8;
    var phi_1072_: type_8;
    var phi_1113_: u32;
    var phi_1119_: u32;
    var phi_1129_: u32;
    var phi_1145_: u32;
    var phi_1182_: u32;
    var phi_1188_: u32;
    var phi_1198_: u32;
    var phi_3778_: bool;
    var phi_1214_: type_8;
    var phi_1215_: type_8;
    var phi_1238_: type_8;
    var phi_1261_: u32;
    var phi_1276_: u32;
    var phi_1279_: type_8;
    var phi_1280_: type_8;
    var phi_1303_: type_8;
    var phi_1369_: u32;
    var phi_1349_: u32;
    var phi_1350_: u32;
    var phi_1373_: f32;
    var phi_3771_: bool;
    var phi_3850_: bool;
    var phi_3849_: bool;
    var phi_1874_: vec3<f32>;
    var phi_1875_: vec3<f32>;
    var phi_1906_: bool;
    var phi_1915_: vec3<f32>;
    var phi_1955_: type_20;
    var phi_1957_: type_20;
    var phi_1958_: bool;
    var phi_1962_: type_20;
    var phi_1963_: type_20;
    var phi_1964_: type_20;
    var phi_1965_: bool;
    var phi_1969_: type_20;
    var phi_1970_: bool;
    var phi_1974_: type_20;
    var phi_1975_: bool;
    var phi_1979_: type_20;
    var phi_1991_: type_8;
    var phi_1994_: type_20;
    var phi_1992_: type_8;
    var phi_2017_: type_8;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2071_: type_20;
    var phi_1995_: type_20;
    var phi_3880_: bool;
    var phi_4149_: f32;
    var phi_4148_: f32;
    var phi_3942_: bool;
    var phi_4147_: f32;
    var phi_3941_: bool;
    var phi_4146_: f32;
    var phi_3940_: bool;
    var phi_4086_: f32;
    var phi_3939_: bool;
    var phi_4051_: f32;
    var phi_3948_: bool;
    var phi_3323_: type_55;
    var phi_3324_: bool;
    var phi_3325_: u32;
    var phi_4050_: f32;
    var phi_3947_: bool;
    var phi_3326_: type_55;
    var phi_3327_: u32;
    var phi_3328_: bool;
    var phi_3329_: u32;
    var phi_4049_: f32;
    var phi_3946_: bool;
    var phi_3330_: type_55;
    var phi_3331_: u32;
    var phi_3332_: bool;
    var phi_3333_: u32;
    var phi_4048_: f32;
    var phi_3945_: bool;
    var phi_923_: type_55;
    var phi_926_: u32;
    var phi_928_: bool;
    var phi_930_: u32;
    var phi_3334_: bool;
    var phi_3944_: bool;
    var phi_3341_: type_8;
    var phi_3342_: type_8;
    var phi_3365_: type_8;
    var phi_3431_: type_20;
    var phi_4041_: bool;

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
                            phi_410_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_410_;
                        phi_411_ = _e246;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e248 = phi_411_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e172 == _e204);
                    }
                    let _e252 = phi_421_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_431_ = _e254;
                        phi_432_ = _e254;
                        phi_434_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e258 = phi_431_;
                    let _e260 = phi_432_;
                    let _e262 = phi_434_;
                    if _e262 {
                        phi_439_ = (_e260 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e266 = phi_439_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_452_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_472_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_490_ = _e305[0];
                    } else {
                        phi_490_ = _e305[1];
                    }
                    let _e310 = phi_490_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_496_ = _e305[2];
                    } else {
                        phi_496_ = _e310;
                    }
                    let _e314 = phi_496_;
                    let _e316 = ((_e314 * _e278) * _e284);
                    let _e317 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_507_ = _e317[0];
                    } else {
                        phi_507_ = _e317[1];
                    }
                    let _e321 = phi_507_;
                    if _e311 {
                        phi_513_ = _e317[2];
                    } else {
                        phi_513_ = _e321;
                    }
                    let _e324 = phi_513_;
                    let _e326 = ((_e324 * _e295) * _e301);
                    let _e330 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e330 {
                        let _e334 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e334, (_e334 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e338 = phi_536_;
                    let _e339 = (_e316 + _e338);
                    let _e340 = (_e316 - _e338);
                    let _e341 = select(_e326, 0f, _e330);
                    if _e330 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e326);
                    }
                    let _e344 = phi_547_;
                    let _e345 = (_e266 == 0u);
                    if _e345 {
                        phi_556_ = _e305[0];
                    } else {
                        phi_556_ = _e305[1];
                    }
                    let _e349 = phi_556_;
                    let _e350 = (_e266 == 2u);
                    if _e350 {
                        phi_562_ = _e305[2];
                    } else {
                        phi_562_ = _e349;
                    }
                    let _e353 = phi_562_;
                    let _e355 = ((_e353 * _e278) * _e284);
                    if _e345 {
                        phi_573_ = _e317[0];
                    } else {
                        phi_573_ = _e317[1];
                    }
                    let _e359 = phi_573_;
                    if _e350 {
                        phi_579_ = _e317[2];
                    } else {
                        phi_579_ = _e359;
                    }
                    let _e362 = phi_579_;
                    let _e364 = ((_e362 * _e295) * _e301);
                    let _e368 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e368 {
                        let _e372 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e372, (_e372 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e376 = phi_602_;
                    let _e377 = (_e355 + _e376);
                    let _e378 = (_e355 - _e376);
                    let _e379 = select(_e364, 0f, _e368);
                    if _e368 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e364);
                    }
                    let _e382 = phi_613_;
                    let _e383 = (_e268 == 0u);
                    if _e383 {
                        phi_622_ = _e305[0];
                    } else {
                        phi_622_ = _e305[1];
                    }
                    let _e387 = phi_622_;
                    let _e388 = (_e268 == 2u);
                    if _e388 {
                        phi_628_ = _e305[2];
                    } else {
                        phi_628_ = _e387;
                    }
                    let _e391 = phi_628_;
                    let _e393 = ((_e391 * _e278) * _e284);
                    if _e383 {
                        phi_639_ = _e317[0];
                    } else {
                        phi_639_ = _e317[1];
                    }
                    let _e397 = phi_639_;
                    if _e388 {
                        phi_645_ = _e317[2];
                    } else {
                        phi_645_ = _e397;
                    }
                    let _e400 = phi_645_;
                    let _e402 = ((_e400 * _e295) * _e301);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e414 = phi_668_;
                    let _e415 = (_e393 + _e414);
                    let _e416 = (_e393 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_679_ = 38685626000000000000000000f;
                    } else {
                        phi_679_ = (1f / _e402);
                    }
                    let _e420 = phi_679_;
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
                        phi_779_ = select(-340282350000000000000000000000000000000f, _e461, (_e461 > -340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_779_ = 0f;
                        phi_780_ = 1f;
                    }
                    let _e465 = phi_779_;
                    let _e467 = phi_780_;
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
                    phi_3796_ = false;
                    phi_3710_ = _e465;
                    phi_922_ = type_55(type_24(vec4<f32>((f32(_e473) * _e147), (f32(_e479) * _e147), (f32(_e485) * _e147), 0f), vec4<f32>((f32(_e490) * _e147), (f32(_e494) * _e147), (f32(_e498) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_925_ = ((3u * _e96) + 1u);
                    phi_927_ = (_e467 <= _e465);
                    phi_929_ = 0u;
                    loop {
                        let _e508 = phi_3796_;
                        let _e510 = phi_3710_;
                        let _e512 = phi_922_;
                        let _e514 = phi_925_;
                        let _e516 = phi_927_;
                        let _e518 = phi_929_;
                        if _e516 {
                            phi_940_ = true;
                        } else {
                            phi_940_ = (_e518 > 0u);
                        }
                        let _e521 = phi_940_;
                        if _e521 {
                            let _e522 = (_e514 > 0u);
                            if _e522 {
                                if _e516 {
                                    phi_1027_ = _e512;
                                    phi_1028_ = _e516;
                                    phi_1029_ = _e518;
                                } else {
                                    let _e523 = (_e518 - 1u);
                                    let _e524 = (_e523 % 128u);
                                    let _e525 = (_e524 < 128u);
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e527 = local_7[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e529 = local_6[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e531 = local_5[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e533 = local_4[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e535 = local_3[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e537 = local_2[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e542 = local_8[_e524];
                                    if _e525 {
                                    } else {
                                        phi_3944_ = true;
                                        break;
                                    }
                                    let _e545 = local_10[_e524];
                                    phi_1027_ = type_55(type_24(vec4<f32>(_e527, _e529, _e531, 0f), vec4<f32>(_e533, _e535, _e537, 0f)), _e542);
                                    phi_1028_ = (_e545 <= _e510);
                                    phi_1029_ = _e523;
                                }
                                let _e548 = phi_1027_;
                                let _e550 = phi_1028_;
                                let _e552 = phi_1029_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_3868_ = _e510;
                                        phi_3793_ = _e508;
                                        phi_1048_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1034 = phi_3868_;
                                            let _e1036 = phi_3793_;
                                            let _e1038 = phi_1048_;
                                            if (_e1038.member < _e1038.member_1) {
                                                phi_1049_ = type_8((_e1038.member + 1u), _e1038.member_1);
                                                phi_1072_ = type_8(1u, _e1038.member);
                                            } else {
                                                phi_1049_ = _e1038;
                                                phi_1072_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1051 = phi_1049_;
                                            let _e1053 = phi_1072_;
                                            let _e1057 = (bitcast<i32>(_e1053.member) != 0i);
                                            if _e1057 {
                                                let _e1062 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1065 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1068 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1070 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                let _e1072 = select(_e1068, _e1070, (_e1070 > _e1068));
                                                let _e1074 = (_e1072 < (1024f * _e147));
                                                if _e1074 {
                                                    phi_1113_ = 0u;
                                                } else {
                                                    phi_1113_ = select(2u, 1u, (_e1072 < (2097152f * _e147)));
                                                }
                                                let _e1079 = phi_1113_;
                                                switch bitcast<i32>(_e1079) {
                                                    case 0: {
                                                        phi_1119_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1119_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1119_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1119_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1082 = phi_1119_;
                                                switch bitcast<i32>(_e1079) {
                                                    case 0: {
                                                        phi_1129_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1129_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1129_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1129_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1089 = phi_1129_;
                                                let _e1091 = ((_e557 + (_e1053.member_1 * ((3u * _e1082) + 1u))) + (3u * _e1089));
                                                let _e1092 = (_e1091 < _e99);
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_4086_ = _e1034;
                                                        phi_3939_ = true;
                                                        break;
                                                    }
                                                    let _e1094 = global_5.member[_e1091];
                                                    phi_1145_ = _e1094;
                                                } else {
                                                    phi_1145_ = 4294967295u;
                                                }
                                                let _e1096 = phi_1145_;
                                                local_11 = array<u32, 3>(_e267, _e266, _e268);
                                                if _e1074 {
                                                    phi_1182_ = 0u;
                                                } else {
                                                    phi_1182_ = select(2u, 1u, (_e1072 < (2097152f * _e147)));
                                                }
                                                let _e1102 = phi_1182_;
                                                switch bitcast<i32>(_e1102) {
                                                    case 0: {
                                                        phi_1188_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1188_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1188_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1188_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1105 = phi_1188_;
                                                switch bitcast<i32>(_e1102) {
                                                    case 0: {
                                                        phi_1198_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1198_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1198_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1198_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1112 = phi_1198_;
                                                local_13 = array<f32, 4>(_e548.member.member.x, _e548.member.member.y, _e548.member.member.z, _e548.member.member.w);
                                                local_12[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_12[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3778_ = _e1036;
                                                phi_1214_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1126 = phi_3778_;
                                                    let _e1128 = phi_1214_;
                                                    if (_e1128.member < _e1128.member_1) {
                                                        phi_1215_ = type_8((_e1128.member + 1u), _e1128.member_1);
                                                        phi_1238_ = type_8(1u, _e1128.member);
                                                    } else {
                                                        phi_1215_ = _e1128;
                                                        phi_1238_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1141 = phi_1215_;
                                                    let _e1143 = phi_1238_;
                                                    let _e1147 = (bitcast<i32>(_e1143.member) != 0i);
                                                    if _e1147 {
                                                        let _e1149 = ((_e557 + (_e1053.member_1 * ((3u * _e1105) + 1u))) + (_e1143.member_1 * _e1112));
                                                        let _e1150 = (_e1149 < _e99);
                                                        if _e1150 {
                                                            if _e1150 {
                                                            } else {
                                                                phi_3849_ = true;
                                                                break;
                                                            }
                                                            let _e1152 = global_5.member[_e1149];
                                                            phi_1261_ = _e1152;
                                                        } else {
                                                            phi_1261_ = 0u;
                                                        }
                                                        let _e1154 = phi_1261_;
                                                        let _e1155 = (_e1149 + 1u);
                                                        let _e1156 = (_e1155 < _e99);
                                                        if _e1156 {
                                                            if _e1156 {
                                                            } else {
                                                                phi_3849_ = true;
                                                                break;
                                                            }
                                                            let _e1158 = global_5.member[_e1155];
                                                            phi_1276_ = _e1158;
                                                        } else {
                                                            phi_1276_ = 0u;
                                                        }
                                                        let _e1160 = phi_1276_;
                                                        phi_1279_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1162 = phi_1279_;
                                                            if (_e1162.member < _e1162.member_1) {
                                                                phi_1280_ = type_8((_e1162.member + 1u), _e1162.member_1);
                                                                phi_1303_ = type_8(1u, _e1162.member);
                                                            } else {
                                                                phi_1280_ = _e1162;
                                                                phi_1303_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1175 = phi_1280_;
                                                            let _e1177 = phi_1303_;
                                                            let _e1181 = (bitcast<i32>(_e1177.member) != 0i);
                                                            if _e1181 {
                                                                let _e1182 = (_e1177.member_1 < 3u);
                                                                if _e1182 {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                let _e1184 = local_11[_e1177.member_1];
                                                                if (_e1177.member_1 < 4u) {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                let _e1187 = local_13[_e1177.member_1];
                                                                switch bitcast<i32>(_e1102) {
                                                                    case 0: {
                                                                        phi_1373_ = (_e1187 + (f32(((_e1154 >> bitcast<u32>(((10u * _e1184) & 31u))) & 1023u)) * _e147));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1184 == 0u) {
                                                                            phi_1350_ = _e1154;
                                                                        } else {
                                                                            if (_e1184 == 1u) {
                                                                                phi_1349_ = ((_e1154 >> bitcast<u32>(21i)) | (_e1160 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1349_ = (_e1160 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1208 = phi_1349_;
                                                                            phi_1350_ = _e1208;
                                                                        }
                                                                        let _e1210 = phi_1350_;
                                                                        phi_1373_ = (_e1187 + (f32((_e1210 & 2097151u)) * _e147));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1189 = (_e1149 + _e1184);
                                                                        let _e1190 = (_e1189 < _e99);
                                                                        if _e1190 {
                                                                            if _e1190 {
                                                                            } else {
                                                                                phi_3771_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1192 = global_5.member[_e1189];
                                                                            phi_1369_ = _e1192;
                                                                        } else {
                                                                            phi_1369_ = 0u;
                                                                        }
                                                                        let _e1194 = phi_1369_;
                                                                        phi_1373_ = (f32(bitcast<i32>(_e1194)) * _e147);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1373_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1224 = phi_1373_;
                                                                if (_e1143.member_1 < 3u) {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                if _e1182 {
                                                                } else {
                                                                    phi_3771_ = true;
                                                                    break;
                                                                }
                                                                local_12[_e1143.member_1][_e1177.member_1] = _e1224;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1279_ = _e1175;
                                                                phi_3771_ = _e1126;
                                                                break if !(_e1181);
                                                            }
                                                        }
                                                        let _e1230 = phi_3771_;
                                                        phi_3849_ = _e1230;
                                                        if _e1230 {
                                                            break;
                                                        }
                                                        phi_3850_ = _e1230;
                                                    } else {
                                                        phi_3850_ = _e1126;
                                                    }
                                                    let _e1232 = phi_3850_;
                                                    continue;
                                                    continuing {
                                                        phi_3778_ = _e1232;
                                                        phi_1214_ = _e1141;
                                                        phi_3849_ = _e1232;
                                                        break if !(_e1147);
                                                    }
                                                }
                                                let _e1235 = phi_3849_;
                                                phi_4086_ = _e1034;
                                                phi_3939_ = _e1235;
                                                if _e1235 {
                                                    break;
                                                }
                                                let _e1236 = local_12;
                                                let _e1251 = (_e1236[0][2] - _e393);
                                                let _e1254 = (((_e1236[0][0] - _e316) * _e417) - (_e1251 * _e341));
                                                let _e1257 = (((_e1236[0][1] - _e355) * _e417) - (_e1251 * _e379));
                                                let _e1260 = (_e1236[1][2] - _e393);
                                                let _e1263 = (((_e1236[1][0] - _e316) * _e417) - (_e1260 * _e341));
                                                let _e1266 = (((_e1236[1][1] - _e355) * _e417) - (_e1260 * _e379));
                                                let _e1269 = (_e1236[2][2] - _e393);
                                                let _e1272 = (((_e1236[2][0] - _e316) * _e417) - (_e1269 * _e341));
                                                let _e1275 = (((_e1236[2][1] - _e355) * _e417) - (_e1269 * _e379));
                                                let _e1276 = (_e1272 * _e1266);
                                                let _e1277 = (_e1275 * _e1263);
                                                let _e1278 = (_e1254 * _e1275);
                                                let _e1279 = (_e1257 * _e1272);
                                                let _e1280 = (_e1263 * _e1257);
                                                let _e1281 = (_e1266 * _e1254);
                                                let _e1286 = (((_e1276 >= _e1277) && (_e1278 >= _e1279)) && (_e1280 >= _e1281));
                                                if (_e1286 || (((_e1276 <= _e1277) && (_e1278 <= _e1279)) && (_e1280 <= _e1281))) {
                                                    let _e1293 = select(-1f, 1f, _e1286);
                                                    let _e1295 = ((_e1276 - _e1277) * _e1293);
                                                    let _e1297 = select(0f, _e1295, (_e1295 > 0f));
                                                    let _e1299 = ((_e1278 - _e1279) * _e1293);
                                                    let _e1301 = select(0f, _e1299, (_e1299 > 0f));
                                                    let _e1303 = ((_e1280 - _e1281) * _e1293);
                                                    let _e1305 = select(0f, _e1303, (_e1303 > 0f));
                                                    let _e1307 = ((_e1297 + _e1301) + _e1305);
                                                    if (_e1307 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1969_ = type_20();
                                                        phi_1970_ = true;
                                                    } else {
                                                        let _e1310 = select(_e1236[1][0], _e1236[0][0], (_e1236[0][0] < _e1236[1][0]));
                                                        let _e1314 = select(_e1236[1][0], _e1236[0][0], (_e1236[0][0] > _e1236[1][0]));
                                                        let _e1318 = select(_e1236[1][1], _e1236[0][1], (_e1236[0][1] < _e1236[1][1]));
                                                        let _e1322 = select(_e1236[1][1], _e1236[0][1], (_e1236[0][1] > _e1236[1][1]));
                                                        let _e1326 = select(_e1236[1][2], _e1236[0][2], (_e1236[0][2] < _e1236[1][2]));
                                                        let _e1330 = select(_e1236[1][2], _e1236[0][2], (_e1236[0][2] > _e1236[1][2]));
                                                        let _e1335 = ((select(_e1236[2][0], _e1310, (_e1310 < _e1236[2][0])) - _e339) * _e344);
                                                        let _e1336 = ((select(_e1236[2][0], _e1314, (_e1314 > _e1236[2][0])) - _e340) * _e344);
                                                        let _e1339 = ((select(_e1236[2][1], _e1318, (_e1318 < _e1236[2][1])) - _e377) * _e382);
                                                        let _e1340 = ((select(_e1236[2][1], _e1322, (_e1322 > _e1236[2][1])) - _e378) * _e382);
                                                        let _e1343 = ((select(_e1236[2][2], _e1326, (_e1326 < _e1236[2][2])) - _e415) * _e420);
                                                        let _e1344 = ((select(_e1236[2][2], _e1330, (_e1330 > _e1236[2][2])) - _e416) * _e420);
                                                        let _e1346 = select(_e1344, _e1343, (_e1343 < _e1344));
                                                        let _e1348 = select(_e1344, _e1343, (_e1343 > _e1344));
                                                        let _e1350 = select(_e1336, _e1335, (_e1335 < _e1336));
                                                        let _e1352 = select(_e1340, _e1339, (_e1339 < _e1340));
                                                        let _e1354 = select(_e1352, _e1350, (_e1350 > _e1352));
                                                        let _e1356 = select(_e1346, _e1354, (_e1354 > _e1346));
                                                        let _e1358 = select(_e1336, _e1335, (_e1335 > _e1336));
                                                        let _e1360 = select(_e1340, _e1339, (_e1339 > _e1340));
                                                        let _e1362 = select(_e1360, _e1358, (_e1358 < _e1360));
                                                        let _e1364 = select(_e1348, _e1362, (_e1362 < _e1348));
                                                        let _e1365 = -(_e1346);
                                                        let _e1371 = select(_e467, _e1356, (_e1356 > _e467));
                                                        if (_e1371 > (_e1364 + (select(_e1365, _e1348, (_e1348 > _e1365)) * 0.0000019073523f))) {
                                                            phi_1964_ = type_20();
                                                            phi_1965_ = true;
                                                        } else {
                                                            let _e1373 = (_e1371 > _e1034);
                                                            if _e1373 {
                                                                phi_1963_ = type_20();
                                                            } else {
                                                                let _e1377 = (_e1236[1][0] - _e1236[0][0]);
                                                                let _e1378 = (_e1236[1][1] - _e1236[0][1]);
                                                                let _e1379 = (_e1236[1][2] - _e1236[0][2]);
                                                                let _e1380 = vec3<f32>(_e1377, _e1378, _e1379);
                                                                let _e1381 = (_e1236[2][0] - _e1236[1][0]);
                                                                let _e1382 = (_e1236[2][1] - _e1236[1][1]);
                                                                let _e1383 = (_e1236[2][2] - _e1236[1][2]);
                                                                let _e1384 = vec3<f32>(_e1381, _e1382, _e1383);
                                                                let _e1385 = (_e1236[0][0] - _e1236[2][0]);
                                                                let _e1386 = (_e1236[0][1] - _e1236[2][1]);
                                                                let _e1387 = (_e1236[0][2] - _e1236[2][2]);
                                                                let _e1388 = vec3<f32>(_e1385, _e1386, _e1387);
                                                                let _e1391 = bitcast<f32>((bitcast<u32>(_e1377) & 2147483647u));
                                                                let _e1394 = bitcast<f32>((bitcast<u32>(_e1378) & 2147483647u));
                                                                let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                                                let _e1399 = bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u));
                                                                let _e1401 = select(_e1399, _e1396, (_e1396 > _e1399));
                                                                let _e1404 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1407 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                let _e1412 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
                                                                let _e1414 = select(_e1412, _e1409, (_e1409 > _e1412));
                                                                let _e1417 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1420 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1422 = select(_e1420, _e1417, (_e1417 > _e1420));
                                                                let _e1425 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                let _e1429 = select(_e1414, _e1401, (_e1401 > _e1414));
                                                                let _e1431 = select(_e1427, _e1429, (_e1429 > _e1427));
                                                                if (_e1401 == _e1431) {
                                                                    phi_1874_ = _e1384;
                                                                    phi_1875_ = _e1388;
                                                                } else {
                                                                    let _e1434 = vec3((_e1414 == _e1431));
                                                                    phi_1874_ = select(_e1380, _e1388, _e1434);
                                                                    phi_1875_ = select(_e1384, _e1380, _e1434);
                                                                }
                                                                let _e1438 = phi_1874_;
                                                                let _e1440 = phi_1875_;
                                                                let _e1447 = ((_e1438.y * _e1440.z) - (_e1440.y * _e1438.z));
                                                                let _e1452 = ((_e1438.z * _e1440.x) - (_e1440.z * _e1438.x));
                                                                let _e1455 = ((_e1438.x * _e1440.y) - (_e1440.x * _e1438.y));
                                                                if (_e1297 >= _e1301) {
                                                                    phi_1906_ = select(true, false, (_e1297 >= _e1305));
                                                                } else {
                                                                    phi_1906_ = true;
                                                                }
                                                                let _e1460 = phi_1906_;
                                                                if _e1460 {
                                                                    phi_1915_ = select(vec3<f32>(_e1236[2][0], _e1236[2][1], _e1236[2][2]), vec3<f32>(_e1236[1][0], _e1236[1][1], _e1236[1][2]), vec3((_e1301 >= _e1305)));
                                                                } else {
                                                                    phi_1915_ = vec3<f32>(_e1236[0][0], _e1236[0][1], _e1236[0][2]);
                                                                }
                                                                let _e1465 = phi_1915_;
                                                                let _e1482 = ((((_e1447 * (_e1465.x - _e316)) + (_e1452 * (_e1465.y - _e355))) + (_e1455 * (_e1465.z - _e393))) / (((_e1447 * _e341) + (_e1452 * _e379)) + (_e1455 * _e417)));
                                                                let _e1484 = select(_e1364, _e1482, (_e1482 < _e1364));
                                                                let _e1486 = select(_e1356, _e1484, (_e1484 > _e1356));
                                                                if (_e1486 >= _e467) {
                                                                    let _e1488 = (_e1486 <= _e1034);
                                                                    if _e1488 {
                                                                        let _e1489 = (1f / _e1307);
                                                                        phi_1955_ = type_20(_e1486, (_e1301 * _e1489), (_e1305 * _e1489), _e1096);
                                                                    } else {
                                                                        phi_1955_ = type_20();
                                                                    }
                                                                    let _e1494 = phi_1955_;
                                                                    phi_1957_ = _e1494;
                                                                    phi_1958_ = select(true, false, _e1488);
                                                                } else {
                                                                    phi_1957_ = type_20();
                                                                    phi_1958_ = true;
                                                                }
                                                                let _e1497 = phi_1957_;
                                                                let _e1499 = phi_1958_;
                                                                if _e1499 {
                                                                    phi_1962_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1962_ = _e1497;
                                                                }
                                                                let _e1501 = phi_1962_;
                                                                phi_1963_ = _e1501;
                                                            }
                                                            let _e1503 = phi_1963_;
                                                            phi_1964_ = _e1503;
                                                            phi_1965_ = _e1373;
                                                        }
                                                        let _e1505 = phi_1964_;
                                                        let _e1507 = phi_1965_;
                                                        phi_1969_ = _e1505;
                                                        phi_1970_ = _e1507;
                                                    }
                                                    let _e1509 = phi_1969_;
                                                    let _e1511 = phi_1970_;
                                                    phi_1974_ = _e1509;
                                                    phi_1975_ = _e1511;
                                                } else {
                                                    phi_1974_ = type_20();
                                                    phi_1975_ = true;
                                                }
                                                let _e1513 = phi_1974_;
                                                let _e1515 = phi_1975_;
                                                if _e1515 {
                                                    phi_1979_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1979_ = _e1513;
                                                }
                                                let _e1517 = phi_1979_;
                                                if (_e1517.member_3 != 4294967295u) {
                                                    if (_e1096 != 4294967295u) {
                                                        phi_1991_ = type_8(0u, 8u);
                                                        phi_1994_ = _e1517;
                                                        loop {
                                                            let _e1522 = phi_1991_;
                                                            let _e1524 = phi_1994_;
                                                            if (_e1522.member < _e1522.member_1) {
                                                                phi_1992_ = type_8((_e1522.member + 1u), _e1522.member_1);
                                                                phi_2017_ = type_8(1u, _e1522.member);
                                                            } else {
                                                                phi_1992_ = _e1522;
                                                                phi_2017_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1537 = phi_1992_;
                                                            let _e1539 = phi_2017_;
                                                            let _e1543 = (bitcast<i32>(_e1539.member) != 0i);
                                                            if _e1543 {
                                                                let _e1544 = (_e1539.member_1 < 8u);
                                                                if _e1544 {
                                                                } else {
                                                                    phi_3880_ = true;
                                                                    break;
                                                                }
                                                                let _e1549 = local_9[_e1539.member_1].member;
                                                                if (_e1524.member < _e1549) {
                                                                    phi_2050_ = true;
                                                                } else {
                                                                    let _e1551 = local_9[_e1539.member_1].member;
                                                                    if (_e1524.member == _e1551) {
                                                                        let _e1556 = local_9[_e1539.member_1].member_3;
                                                                        phi_2049_ = (_e1524.member_3 < _e1556);
                                                                    } else {
                                                                        phi_2049_ = false;
                                                                    }
                                                                    let _e1559 = phi_2049_;
                                                                    phi_2050_ = _e1559;
                                                                }
                                                                let _e1561 = phi_2050_;
                                                                if _e1561 {
                                                                    if _e1544 {
                                                                    } else {
                                                                        phi_3880_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1562 = local_9[_e1539.member_1];
                                                                    local_9[_e1539.member_1] = type_20(_e1524.member, _e1524.member_1, _e1524.member_2, _e1524.member_3);
                                                                    phi_2071_ = type_20(_e1562.member, _e1562.member_1, _e1562.member_2, _e1562.member_3);
                                                                } else {
                                                                    phi_2071_ = _e1524;
                                                                }
                                                                let _e1573 = phi_2071_;
                                                                phi_1995_ = _e1573;
                                                            } else {
                                                                phi_1995_ = type_20();
                                                            }
                                                            let _e1575 = phi_1995_;
                                                            continue;
                                                            continuing {
                                                                phi_1991_ = _e1537;
                                                                phi_1994_ = _e1575;
                                                                phi_3880_ = _e1235;
                                                                break if !(_e1543);
                                                            }
                                                        }
                                                        let _e1578 = phi_3880_;
                                                        phi_4086_ = _e1034;
                                                        phi_3939_ = _e1578;
                                                        if _e1578 {
                                                            break;
                                                        }
                                                        let _e1581 = local_9[7u].member_3;
                                                        if (_e1581 != 4294967295u) {
                                                            let _e1585 = local_9[7u].member;
                                                            phi_4149_ = _e1585;
                                                        } else {
                                                            phi_4149_ = _e1034;
                                                        }
                                                        let _e1587 = phi_4149_;
                                                        phi_4148_ = _e1587;
                                                        phi_3942_ = _e1578;
                                                    } else {
                                                        phi_4148_ = _e1034;
                                                        phi_3942_ = _e1235;
                                                    }
                                                    let _e1589 = phi_4148_;
                                                    let _e1591 = phi_3942_;
                                                    phi_4147_ = _e1589;
                                                    phi_3941_ = _e1591;
                                                } else {
                                                    phi_4147_ = _e1034;
                                                    phi_3941_ = _e1235;
                                                }
                                                let _e1593 = phi_4147_;
                                                let _e1595 = phi_3941_;
                                                phi_4146_ = _e1593;
                                                phi_3940_ = _e1595;
                                            } else {
                                                phi_4146_ = _e1034;
                                                phi_3940_ = _e1036;
                                            }
                                            let _e1597 = phi_4146_;
                                            let _e1599 = phi_3940_;
                                            continue;
                                            continuing {
                                                phi_3868_ = _e1597;
                                                phi_3793_ = _e1599;
                                                phi_1048_ = _e1051;
                                                phi_4086_ = _e1597;
                                                phi_3939_ = _e1599;
                                                break if !(_e1057);
                                            }
                                        }
                                        let _e1602 = phi_4086_;
                                        let _e1604 = phi_3939_;
                                        phi_3944_ = _e1604;
                                        if _e1604 {
                                            break;
                                        }
                                        phi_4051_ = _e1602;
                                        phi_3948_ = _e1604;
                                        phi_3323_ = _e548;
                                        phi_3324_ = false;
                                        phi_3325_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e96) {
                                            phi_2878_ = type_56(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_55(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_55(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e96) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e564 = (_e267 * 2u);
                                            let _e566 = ((1u + _e564) % 7u);
                                            if (_e566 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e571 = global_4.member[_e548.member_1][_e566];
                                            let _e573 = ((_e564 + 2u) % 7u);
                                            if (_e573 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e578 = global_4.member[_e548.member_1][_e573];
                                            let _e579 = (_e266 * 2u);
                                            let _e581 = ((1u + _e579) % 7u);
                                            if (_e581 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e586 = global_4.member[_e548.member_1][_e581];
                                            let _e588 = ((_e579 + 2u) % 7u);
                                            if (_e588 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e593 = global_4.member[_e548.member_1][_e588];
                                            let _e594 = (_e268 * 2u);
                                            let _e596 = ((1u + _e594) % 7u);
                                            if (_e596 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e601 = global_4.member[_e548.member_1][_e596];
                                            let _e603 = ((_e594 + 2u) % 7u);
                                            if (_e603 < 7u) {
                                            } else {
                                                phi_3944_ = true;
                                                break;
                                            }
                                            let _e608 = global_4.member[_e548.member_1][_e603];
                                            let _e631 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e632 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e633 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e635 = select(_e147, _e631, (_e631 > _e147));
                                            let _e637 = select(_e147, _e632, (_e632 > _e147));
                                            let _e639 = select(_e147, _e633, (_e633 > _e147));
                                            let _e664 = bitcast<u32>((f32(bitcast<i32>((_e571 & 2097151u))) * _e635));
                                            let _e669 = (bitcast<i32>((_e571 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e637));
                                            let _e678 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e601 & 2097151u))) * _e639));
                                            let _e687 = (bitcast<i32>((_e601 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e694 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                            let _e698 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e702 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e703 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e635));
                                            let _e708 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                            let _e712 = bitcast<u32>((f32(bitcast<i32>((_e593 & 2097151u))) * _e637));
                                            let _e717 = (bitcast<i32>((_e593 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                            let _e721 = bitcast<u32>((f32(bitcast<i32>((_e608 & 2097151u))) * _e639));
                                            let _e726 = (bitcast<i32>((_e608 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e729 = bitcast<f32>((_e721 & bitcast<u32>(_e726)));
                                            let _e733 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                            let _e737 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                            let _e741 = bitcast<f32>((_e721 & bitcast<u32>(~(_e726))));
                                            let _e742 = (_e548.member.member.x + _e672);
                                            let _e743 = (_e548.member.member.y + _e681);
                                            let _e744 = (_e548.member.member.z + _e690);
                                            let _e747 = (_e548.member.member_1.x - _e711);
                                            let _e748 = (_e548.member.member_1.y - _e720);
                                            let _e749 = (_e548.member.member_1.z - _e729);
                                            let _e768 = (_e747 - _e742);
                                            let _e769 = (_e748 - _e743);
                                            let _e770 = (_e749 - _e744);
                                            let _e772 = select(_e769, _e768, (_e768 > _e769));
                                            let _e774 = select(_e770, _e772, (_e772 > _e770));
                                            if (_e774 < (1024f * _e147)) {
                                                phi_2579_ = 0u;
                                            } else {
                                                phi_2579_ = select(2u, 1u, (_e774 < (2097152f * _e147)));
                                            }
                                            let _e781 = phi_2579_;
                                            switch bitcast<i32>(_e781) {
                                                case 0: {
                                                    phi_2585_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2585_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2585_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2585_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e784 = phi_2585_;
                                            let _e790 = global_4.member[_e548.member_1][0u];
                                            let _e794 = global_4.member[_e548.member_1][2u];
                                            let _e798 = global_4.member[_e548.member_1][4u];
                                            let _e802 = global_4.member[_e548.member_1][6u];
                                            let _e814 = (((_e794 >> bitcast<u32>(22i)) | ((_e798 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e802 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e815 = (_e790 & 268435455u);
                                            let _e816 = (_e814 & 268435455u);
                                            let _e819 = ((_e790 >> bitcast<u32>(28u)) & 7u);
                                            let _e827 = ((_e790 >> bitcast<u32>(31i)) | (((_e814 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e828 = (_e819 != 0u);
                                            if (_e819 == 0u) {
                                                phi_2840_ = _e815;
                                            } else {
                                                if (_e819 == 7u) {
                                                    phi_2839_ = 2147483648u;
                                                } else {
                                                    phi_2839_ = ((2147483648u | (_e819 << bitcast<u32>(28u))) | (_e816 & 268435455u));
                                                }
                                                let _e837 = phi_2839_;
                                                phi_2840_ = _e837;
                                            }
                                            let _e839 = phi_2840_;
                                            if _e828 {
                                                let _e840 = (_e819 != 7u);
                                                if _e840 {
                                                    phi_2850_ = (_e816 + (_e819 * ((3u * _e784) + 1u)));
                                                } else {
                                                    phi_2850_ = u32();
                                                }
                                                let _e844 = phi_2850_;
                                                phi_2852_ = _e844;
                                                phi_2853_ = select(true, false, _e840);
                                            } else {
                                                phi_2852_ = u32();
                                                phi_2853_ = true;
                                            }
                                            let _e847 = phi_2852_;
                                            let _e849 = phi_2853_;
                                            if (_e827 == 0u) {
                                                phi_2874_ = (_e815 + select(0u, 1u, !(_e828)));
                                            } else {
                                                if (_e827 == 7u) {
                                                    phi_2873_ = 2147483648u;
                                                } else {
                                                    phi_2873_ = ((2147483648u | (_e827 << bitcast<u32>(28u))) | (select(_e847, _e816, _e849) & 268435455u));
                                                }
                                                let _e862 = phi_2873_;
                                                phi_2874_ = _e862;
                                            }
                                            let _e864 = phi_2874_;
                                            phi_2878_ = type_56(array<vec4<f32>, 3>(vec4<f32>(_e742, (_e548.member.member.x + _e694), _e747, (_e548.member.member_1.x - _e733)), vec4<f32>(_e743, (_e548.member.member.y + _e698), _e748, (_e548.member.member_1.y - _e737)), vec4<f32>(_e744, (_e548.member.member.z + _e702), _e749, (_e548.member.member_1.z - _e741))), type_55(type_24((_e548.member.member + vec4<f32>(_e672, _e681, _e690, 0f)), (_e548.member.member_1 - vec4<f32>(_e711, _e720, _e729, 0f))), _e839), type_55(type_24((_e548.member.member + vec4<f32>(_e694, _e698, _e702, 0f)), (_e548.member.member_1 - vec4<f32>(_e733, _e737, _e741, 0f))), _e864));
                                        }
                                        let _e869 = phi_2878_;
                                        let _e880 = ((_e869.member[0].x - _e339) * _e344);
                                        let _e881 = ((_e869.member[0].y - _e339) * _e344);
                                        let _e882 = ((_e869.member[0].z - _e340) * _e344);
                                        let _e883 = ((_e869.member[0].w - _e340) * _e344);
                                        let _e893 = ((_e869.member[1].x - _e377) * _e382);
                                        let _e894 = ((_e869.member[1].y - _e377) * _e382);
                                        let _e895 = ((_e869.member[1].z - _e378) * _e382);
                                        let _e896 = ((_e869.member[1].w - _e378) * _e382);
                                        let _e906 = ((_e869.member[2].x - _e415) * _e420);
                                        let _e907 = ((_e869.member[2].y - _e415) * _e420);
                                        let _e908 = ((_e869.member[2].z - _e416) * _e420);
                                        let _e909 = ((_e869.member[2].w - _e416) * _e420);
                                        let _e911 = select(_e908, _e906, (_e906 < _e908));
                                        let _e913 = select(_e909, _e907, (_e907 < _e909));
                                        let _e915 = select(_e908, _e906, (_e906 > _e908));
                                        let _e917 = select(_e909, _e907, (_e907 > _e909));
                                        let _e919 = select(_e882, _e880, (_e880 < _e882));
                                        let _e921 = select(_e883, _e881, (_e881 < _e883));
                                        let _e923 = select(_e895, _e893, (_e893 < _e895));
                                        let _e925 = select(_e896, _e894, (_e894 < _e896));
                                        let _e927 = select(_e923, _e919, (_e919 > _e923));
                                        let _e929 = select(_e925, _e921, (_e921 > _e925));
                                        let _e931 = select(_e911, _e927, (_e927 > _e911));
                                        let _e933 = select(_e913, _e929, (_e929 > _e913));
                                        let _e935 = select(_e882, _e880, (_e880 > _e882));
                                        let _e937 = select(_e883, _e881, (_e881 > _e883));
                                        let _e939 = select(_e895, _e893, (_e893 > _e895));
                                        let _e941 = select(_e896, _e894, (_e894 > _e896));
                                        let _e943 = select(_e939, _e935, (_e935 < _e939));
                                        let _e945 = select(_e941, _e937, (_e937 < _e941));
                                        let _e950 = -(_e911);
                                        let _e951 = -(_e913);
                                        let _e958 = (select(_e915, _e943, (_e943 < _e915)) + (select(_e950, _e915, (_e915 > _e950)) * 0.0000019073523f));
                                        let _e959 = (select(_e917, _e945, (_e945 < _e917)) + (select(_e951, _e917, (_e917 > _e951)) * 0.0000019073523f));
                                        let _e961 = select(_e467, _e931, (_e931 > _e467));
                                        let _e963 = select(_e467, _e933, (_e933 > _e467));
                                        let _e968 = (_e961 <= select(_e510, _e958, (_e958 < _e510)));
                                        let _e969 = (_e963 <= select(_e510, _e959, (_e959 < _e510)));
                                        let _e970 = (_e961 <= _e963);
                                        if _e968 {
                                            if _e969 {
                                                if _e970 {
                                                    phi_3223_ = _e869.member_2;
                                                } else {
                                                    phi_3223_ = _e869.member_1;
                                                }
                                                let _e974 = phi_3223_;
                                                let _e996 = (_e552 % 128u);
                                                let _e997 = (_e996 < 128u);
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_8[_e996] = _e974.member_1;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_7[_e996] = _e974.member.member.x;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_6[_e996] = _e974.member.member.y;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_5[_e996] = _e974.member.member.z;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_4[_e996] = _e974.member.member_1.x;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_3[_e996] = _e974.member.member_1.y;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_2[_e996] = _e974.member.member_1.z;
                                                if _e997 {
                                                } else {
                                                    phi_3944_ = true;
                                                    break;
                                                }
                                                local_10[_e996] = select(_e963, _e961, (_e961 > _e963));
                                                if _e970 {
                                                    phi_3300_ = _e869.member_1;
                                                } else {
                                                    phi_3300_ = _e869.member_2;
                                                }
                                                let _e1010 = phi_3300_;
                                                phi_3301_ = _e1010;
                                                phi_3302_ = (_e552 + 1u);
                                            } else {
                                                phi_3301_ = type_55();
                                                phi_3302_ = u32();
                                            }
                                            let _e1012 = phi_3301_;
                                            let _e1014 = phi_3302_;
                                            phi_3304_ = _e1012;
                                            phi_3305_ = _e1014;
                                            phi_3306_ = select(true, false, _e969);
                                        } else {
                                            phi_3304_ = type_55();
                                            phi_3305_ = u32();
                                            phi_3306_ = true;
                                        }
                                        let _e1017 = phi_3304_;
                                        let _e1019 = phi_3305_;
                                        let _e1021 = phi_3306_;
                                        if _e1021 {
                                            if _e968 {
                                                phi_3315_ = _e869.member_1;
                                            } else {
                                                phi_3315_ = _e869.member_2;
                                            }
                                            let _e1025 = phi_3315_;
                                            phi_3320_ = _e1025;
                                            phi_3321_ = select(_e969, true, _e968);
                                        } else {
                                            phi_3320_ = _e1017;
                                            phi_3321_ = _e550;
                                        }
                                        let _e1028 = phi_3320_;
                                        let _e1030 = phi_3321_;
                                        phi_4051_ = _e510;
                                        phi_3948_ = _e508;
                                        phi_3323_ = _e1028;
                                        phi_3324_ = _e1030;
                                        phi_3325_ = select(_e1019, _e552, _e1021);
                                    }
                                    let _e1606 = phi_4051_;
                                    let _e1608 = phi_3948_;
                                    let _e1610 = phi_3323_;
                                    let _e1612 = phi_3324_;
                                    let _e1614 = phi_3325_;
                                    phi_4050_ = _e1606;
                                    phi_3947_ = _e1608;
                                    phi_3326_ = _e1610;
                                    phi_3327_ = (_e514 - 1u);
                                    phi_3328_ = _e1612;
                                    phi_3329_ = _e1614;
                                } else {
                                    phi_4050_ = _e510;
                                    phi_3947_ = _e508;
                                    phi_3326_ = _e548;
                                    phi_3327_ = _e514;
                                    phi_3328_ = _e550;
                                    phi_3329_ = _e552;
                                }
                                let _e1616 = phi_4050_;
                                let _e1618 = phi_3947_;
                                let _e1620 = phi_3326_;
                                let _e1622 = phi_3327_;
                                let _e1624 = phi_3328_;
                                let _e1626 = phi_3329_;
                                phi_4049_ = _e1616;
                                phi_3946_ = _e1618;
                                phi_3330_ = _e1620;
                                phi_3331_ = _e1622;
                                phi_3332_ = _e1624;
                                phi_3333_ = _e1626;
                            } else {
                                phi_4049_ = _e510;
                                phi_3946_ = _e508;
                                phi_3330_ = type_55();
                                phi_3331_ = u32();
                                phi_3332_ = bool();
                                phi_3333_ = u32();
                            }
                            let _e1628 = phi_4049_;
                            let _e1630 = phi_3946_;
                            let _e1632 = phi_3330_;
                            let _e1634 = phi_3331_;
                            let _e1636 = phi_3332_;
                            let _e1638 = phi_3333_;
                            phi_4048_ = _e1628;
                            phi_3945_ = _e1630;
                            phi_923_ = _e1632;
                            phi_926_ = _e1634;
                            phi_928_ = _e1636;
                            phi_930_ = _e1638;
                            phi_3334_ = _e522;
                        } else {
                            phi_4048_ = _e510;
                            phi_3945_ = _e508;
                            phi_923_ = type_55();
                            phi_926_ = u32();
                            phi_928_ = bool();
                            phi_930_ = u32();
                            phi_3334_ = false;
                        }
                        let _e1640 = phi_4048_;
                        let _e1642 = phi_3945_;
                        let _e1644 = phi_923_;
                        let _e1646 = phi_926_;
                        let _e1648 = phi_928_;
                        let _e1650 = phi_930_;
                        let _e1652 = phi_3334_;
                        continue;
                        continuing {
                            phi_3796_ = _e1642;
                            phi_3710_ = _e1640;
                            phi_922_ = _e1644;
                            phi_925_ = _e1646;
                            phi_927_ = _e1648;
                            phi_929_ = _e1650;
                            phi_3944_ = _e1642;
                            break if !(_e1652);
                        }
                    }
                    let _e1655 = phi_3944_;
                    if _e1655 {
                        break;
                    }
                    phi_3341_ = type_8(0u, 8u);
                    loop {
                        let _e1657 = phi_3341_;
                        if (_e1657.member < _e1657.member_1) {
                            phi_3342_ = type_8((_e1657.member + 1u), _e1657.member_1);
                            phi_3365_ = type_8(1u, _e1657.member);
                        } else {
                            phi_3342_ = _e1657;
                            phi_3365_ = type_8(0u, type_8().member_1);
                        }
                        let _e1670 = phi_3342_;
                        let _e1672 = phi_3365_;
                        let _e1676 = (bitcast<i32>(_e1672.member) != 0i);
                        if _e1676 {
                            let _e1677 = (_e1672.member_1 < 8u);
                            if _e1677 {
                            } else {
                                phi_4041_ = true;
                                break;
                            }
                            let _e1679 = local_9[_e1672.member_1];
                            if (_e1679.member_3 != 4294967295u) {
                                let _e1685 = -(_e434);
                                let _e1686 = (_e1685 / 3i);
                                let _e1693 = bitcast<f32>((bitcast<u32>((_e1686 + 127i)) << bitcast<u32>(23i)));
                                let _e1701 = (((_e1679.member * _e1693) * _e1693) * bitcast<f32>((bitcast<u32>(((_e1685 - (2i * _e1686)) + 127i)) << bitcast<u32>(23i))));
                                let _e1703 = select(340282350000000000000000000000000000000f, _e1701, (_e1701 < 340282350000000000000000000000000000000f));
                                phi_3431_ = type_20(select(-340282350000000000000000000000000000000f, _e1703, (_e1703 > -340282350000000000000000000000000000000f)), _e1679.member_1, _e1679.member_2, _e1679.member_3);
                            } else {
                                phi_3431_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1708 = phi_3431_;
                            if _e1677 {
                            } else {
                                phi_4041_ = true;
                                break;
                            }
                            local_9[_e1672.member_1] = type_20(_e1708.member, _e1708.member_1, _e1708.member_2, _e1708.member_3);
                        }
                        continue;
                        continuing {
                            phi_3341_ = _e1670;
                            phi_4041_ = _e1655;
                            break if !(_e1676);
                        }
                    }
                    let _e1716 = phi_4041_;
                    if _e1716 {
                        break;
                    }
                    let _e1717 = local_9;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = array<type_20, 8>(type_20(_e1717[0].member, _e1717[0].member_1, _e1717[0].member_2, _e1717[0].member_3), type_20(_e1717[1].member, _e1717[1].member_1, _e1717[1].member_2, _e1717[1].member_3), type_20(_e1717[2].member, _e1717[2].member_1, _e1717[2].member_2, _e1717[2].member_3), type_20(_e1717[3].member, _e1717[3].member_1, _e1717[3].member_2, _e1717[3].member_3), type_20(_e1717[4].member, _e1717[4].member_1, _e1717[4].member_2, _e1717[4].member_3), type_20(_e1717[5].member, _e1717[5].member_1, _e1717[5].member_2, _e1717[5].member_3), type_20(_e1717[6].member, _e1717[6].member_1, _e1717[6].member_2, _e1717[6].member_3), type_20(_e1717[7].member, _e1717[7].member_1, _e1717[7].member_2, _e1717[7].member_3));
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
