struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_34,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_61 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_24;
@group(0) @binding(0) 
var<uniform> global_2: type_44;
@group(0) @binding(1) 
var<storage> global_3: type_13;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_61;
@group(0) @binding(2) 
var<storage> global_7: type_4;

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
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_411_: i32;
    var phi_412_: i32;
    var phi_422_: bool;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_435_: bool;
    var phi_440_: u32;
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
    var phi_3767_: bool;
    var phi_879_: type_42;
    var phi_882_: type_53;
    var phi_884_: u32;
    var phi_886_: bool;
    var phi_888_: u32;
    var phi_899_: bool;
    var phi_985_: type_53;
    var phi_986_: bool;
    var phi_987_: u32;
    var phi_2618_: u32;
    var phi_2624_: u32;
    var phi_2878_: u32;
    var phi_2879_: u32;
    var phi_2889_: u32;
    var phi_2891_: u32;
    var phi_2892_: bool;
    var phi_2912_: u32;
    var phi_2913_: u32;
    var phi_2917_: type_54;
    var phi_3261_: type_53;
    var phi_3338_: type_53;
    var phi_3339_: type_53;
    var phi_3340_: u32;
    var phi_3342_: type_53;
    var phi_3343_: u32;
    var phi_3344_: bool;
    var phi_3353_: type_53;
    var phi_3358_: type_53;
    var phi_3359_: bool;
    var phi_3764_: bool;
    var phi_1006_: type_42;
    var phi_1009_: type_8;
    var phi_1010_: type_8;
    var phi_1032_: type_8;
    var phi_1076_: u32;
    var phi_1082_: u32;
    var phi_1092_: u32;
    var phi_1108_: u32;
    var phi_1145_: u32;
    var phi_1151_: u32;
    var phi_1161_: u32;
    var phi_3749_: bool;
    var phi_1177_: type_8;
    var phi_1178_: type_8;
    var phi_1201_: type_8;
    var phi_1224_: u32;
    var phi_1239_: u32;
    var phi_1242_: type_8;
    var phi_1243_: type_8;
    var phi_1266_: type_8;
    var phi_1332_: u32;
    var phi_1312_: u32;
    var phi_1313_: u32;
    var phi_1336_: f32;
    var phi_3742_: bool;
    var phi_3821_: bool;
    var phi_3820_: bool;
    var phi_1836_: vec3<f32>;
    var phi_1837_: vec3<f32>;
    var phi_1868_: bool;
    var phi_1877_: vec3<f32>;
    var phi_1917_: type_22;
    var phi_1919_: type_22;
    var phi_1920_: bool;
    var phi_1924_: type_22;
    var phi_1925_: type_22;
    var phi_1926_: type_22;
    var phi_1927_: bool;
    var phi_1931_: type_22;
    var phi_1932_: bool;
    var phi_1936_: type_22;
    var phi_1937_: bool;
    var phi_1941_: type_22;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1974_: type_42;
    var phi_1975_: type_42;
    var phi_1976_: type_42;
    var phi_3823_: bool;
    var phi_1007_: type_42;
    var phi_3822_: bool;
    var phi_3885_: bool;
    var phi_3361_: type_42;
    var phi_3362_: type_53;
    var phi_3363_: bool;
    var phi_3364_: u32;
    var phi_3884_: bool;
    var phi_3365_: type_42;
    var phi_3366_: type_53;
    var phi_3367_: u32;
    var phi_3368_: bool;
    var phi_3369_: u32;
    var phi_3883_: bool;
    var phi_3370_: type_42;
    var phi_3371_: type_53;
    var phi_3372_: u32;
    var phi_3373_: bool;
    var phi_3374_: u32;
    var phi_3882_: bool;
    var phi_880_: type_42;
    var phi_883_: type_53;
    var phi_885_: u32;
    var phi_887_: bool;
    var phi_889_: u32;
    var phi_3375_: bool;
    var phi_3881_: bool;
    var local_13: type_42;
    var phi_3427_: type_22;
    var local_14: type_42;
    var local_15: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_3.member));
            let _e98 = arrayLength((&global_7.member));
            let _e106 = arrayLength((&global_6.member));
            let _e110 = global_2.member[0u][0u];
            let _e114 = global_2.member[0u][1u];
            let _e118 = global_2.member[0u][2u];
            let _e122 = global_2.member[0u][3u];
            let _e126 = global_2.member[1u][0u];
            let _e130 = global_2.member[1u][1u];
            let _e134 = global_2.member[1u][2u];
            let _e138 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e153 = (_e138 < arrayLength((&global_4.member)));
            if _e153 {
                let _e154 = (_e138 < arrayLength((&global_1.member)));
                if _e154 {
                    let _e155 = (_e138 < arrayLength((&global_5.member)));
                    if _e155 {
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e165 = global_4.member[_e138].member.member_2[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_4.member[_e138].member.member_2[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_4.member[_e138].member.member_2[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_4.member[_e138].member.member[0u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_4.member[_e138].member.member[1u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_4.member[_e138].member.member[2u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e209 = select(_e175, _e167, (_e175 < _e167));
                        let _e211 = select(_e183, _e209, (_e183 < _e209));
                        let _e213 = select(_e191, _e211, (_e191 < _e211));
                        let _e215 = select(_e199, _e213, (_e199 < _e213));
                        let _e217 = select(_e207, _e215, (_e207 < _e215));
                        let _e222 = global_4.member[_e138].member.member_1;
                        let _e224 = (bitcast<u32>(_e222) & 2147483647u);
                        let _e232 = global_4.member[_e138].member.member_3;
                        let _e238 = (((select(_e224, _e217, (_e224 < _e217)) < 2139095040u) && ((bitcast<u32>(_e232) & 2147483647u) <= 2139095040u)) && (_e211 > 0u));
                        if _e238 {
                            let _e241 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                            if (_e241 >= 8388608u) {
                                phi_411_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_411_;
                            phi_412_ = _e255;
                        } else {
                            phi_412_ = 0i;
                        }
                        let _e257 = phi_412_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_422_ = true;
                        } else {
                            phi_422_ = (_e175 == _e211);
                        }
                        let _e261 = phi_422_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_432_ = _e263;
                            phi_433_ = _e263;
                            phi_435_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_432_ = u32();
                            phi_433_ = 0u;
                            phi_435_ = true;
                        }
                        let _e267 = phi_432_;
                        let _e269 = phi_433_;
                        let _e271 = phi_435_;
                        if _e271 {
                            phi_440_ = (_e269 + 1u);
                        } else {
                            phi_440_ = 0u;
                        }
                        let _e275 = phi_440_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_473_ = -126i;
                        } else {
                            phi_473_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_473_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_4.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_491_ = _e299[0];
                        } else {
                            phi_491_ = _e299[1];
                        }
                        let _e304 = phi_491_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_497_ = _e299[2];
                        } else {
                            phi_497_ = _e304;
                        }
                        let _e308 = phi_497_;
                        let _e309 = global_4.member[_e138].member.member_2;
                        if _e300 {
                            phi_508_ = _e309[0];
                        } else {
                            phi_508_ = _e309[1];
                        }
                        let _e313 = phi_508_;
                        if _e305 {
                            phi_514_ = _e309[2];
                        } else {
                            phi_514_ = _e313;
                        }
                        let _e316 = phi_514_;
                        let _e318 = ((_e316 * _e288) * _e294);
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e322 {
                            let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                            phi_537_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                        } else {
                            phi_537_ = 0f;
                        }
                        let _e330 = phi_537_;
                        let _e331 = (_e308 + _e330);
                        let _e332 = (_e308 - _e330);
                        let _e333 = select(_e318, 0f, _e322);
                        if _e322 {
                            phi_548_ = 38685626000000000000000000f;
                        } else {
                            phi_548_ = (1f / _e318);
                        }
                        let _e336 = phi_548_;
                        let _e337 = (_e275 == 0u);
                        if _e337 {
                            phi_557_ = _e299[0];
                        } else {
                            phi_557_ = _e299[1];
                        }
                        let _e341 = phi_557_;
                        let _e342 = (_e275 == 2u);
                        if _e342 {
                            phi_563_ = _e299[2];
                        } else {
                            phi_563_ = _e341;
                        }
                        let _e345 = phi_563_;
                        if _e337 {
                            phi_574_ = _e309[0];
                        } else {
                            phi_574_ = _e309[1];
                        }
                        let _e349 = phi_574_;
                        if _e342 {
                            phi_580_ = _e309[2];
                        } else {
                            phi_580_ = _e349;
                        }
                        let _e352 = phi_580_;
                        let _e354 = ((_e352 * _e288) * _e294);
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e358 {
                            let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                            phi_603_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                        } else {
                            phi_603_ = 0f;
                        }
                        let _e366 = phi_603_;
                        let _e367 = (_e345 + _e366);
                        let _e368 = (_e345 - _e366);
                        let _e369 = select(_e354, 0f, _e358);
                        if _e358 {
                            phi_614_ = 38685626000000000000000000f;
                        } else {
                            phi_614_ = (1f / _e354);
                        }
                        let _e372 = phi_614_;
                        let _e373 = (_e277 == 0u);
                        if _e373 {
                            phi_623_ = _e299[0];
                        } else {
                            phi_623_ = _e299[1];
                        }
                        let _e377 = phi_623_;
                        let _e378 = (_e277 == 2u);
                        if _e378 {
                            phi_629_ = _e299[2];
                        } else {
                            phi_629_ = _e377;
                        }
                        let _e381 = phi_629_;
                        if _e373 {
                            phi_640_ = _e309[0];
                        } else {
                            phi_640_ = _e309[1];
                        }
                        let _e385 = phi_640_;
                        if _e378 {
                            phi_646_ = _e309[2];
                        } else {
                            phi_646_ = _e385;
                        }
                        let _e388 = phi_646_;
                        let _e390 = ((_e388 * _e288) * _e294);
                        let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e394 {
                            let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e402 = phi_669_;
                        let _e403 = (_e381 + _e402);
                        let _e404 = (_e381 - _e402);
                        let _e405 = select(_e390, 0f, _e394);
                        if _e394 {
                            phi_680_ = 38685626000000000000000000f;
                        } else {
                            phi_680_ = (1f / _e390);
                        }
                        let _e408 = phi_680_;
                        let _e411 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                        let _e414 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                        let _e416 = select(_e414, _e411, (_e411 > _e414));
                        let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                        if (_e238 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                            let _e424 = (_e257 / 3i);
                            let _e431 = bitcast<f32>((bitcast<u32>((_e424 + 127i)) << bitcast<u32>(23i)));
                            let _e438 = bitcast<f32>((bitcast<u32>(((_e257 - (2i * _e424)) + 127i)) << bitcast<u32>(23i)));
                            let _e439 = (((_e222 * _e431) * _e431) * _e438);
                            let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                            let _e446 = (((_e232 * _e431) * _e431) * _e438);
                            let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                            phi_781_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_780_ = 0f;
                            phi_781_ = 1f;
                        }
                        let _e452 = phi_780_;
                        let _e454 = phi_781_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e460 = global_4.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e463 = (_e276 % 3u);
                        let _e464 = (_e463 < 3u);
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e466 = local_1[_e463];
                        let _e469 = (_e275 % 3u);
                        let _e470 = (_e469 < 3u);
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e472 = local_1[_e469];
                        let _e475 = (_e277 % 3u);
                        let _e476 = (_e475 < 3u);
                        if _e476 {
                        } else {
                            break;
                        }
                        let _e478 = local_1[_e475];
                        if _e464 {
                        } else {
                            break;
                        }
                        let _e483 = local[_e463];
                        if _e470 {
                        } else {
                            break;
                        }
                        let _e487 = local[_e469];
                        if _e476 {
                        } else {
                            break;
                        }
                        let _e491 = local[_e475];
                        phi_3767_ = false;
                        phi_879_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452), 0u, 0u);
                        phi_882_ = type_53(type_34(vec4<f32>((f32(_e466) * _e150), (f32(_e472) * _e150), (f32(_e478) * _e150), 0f), vec4<f32>((f32(_e483) * _e150), (f32(_e487) * _e150), (f32(_e491) * _e150), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                        phi_884_ = ((3u * _e95) + 1u);
                        phi_886_ = (_e454 <= _e452);
                        phi_888_ = 0u;
                        loop {
                            let _e501 = phi_3767_;
                            let _e503 = phi_879_;
                            let _e505 = phi_882_;
                            let _e507 = phi_884_;
                            let _e509 = phi_886_;
                            let _e511 = phi_888_;
                            local_13 = _e503;
                            local_14 = _e503;
                            if _e509 {
                                phi_899_ = true;
                            } else {
                                phi_899_ = (_e511 > 0u);
                            }
                            let _e514 = phi_899_;
                            if _e514 {
                                let _e515 = (_e507 > 0u);
                                if _e515 {
                                    if _e509 {
                                        phi_985_ = _e505;
                                        phi_986_ = _e509;
                                        phi_987_ = _e511;
                                    } else {
                                        let _e516 = (_e511 - 1u);
                                        let _e517 = (_e516 % 128u);
                                        let _e518 = (_e517 < 128u);
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e520 = local_7[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e522 = local_6[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e524 = local_5[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e526 = local_4[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e528 = local_3[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e530 = local_2[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e535 = local_8[_e517];
                                        if _e518 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e538 = local_9[_e517];
                                        phi_985_ = type_53(type_34(vec4<f32>(_e520, _e522, _e524, 0f), vec4<f32>(_e526, _e528, _e530, 0f)), _e535);
                                        phi_986_ = (_e538 <= _e503.member.member_1);
                                        phi_987_ = _e516;
                                    }
                                    let _e543 = phi_985_;
                                    let _e545 = phi_986_;
                                    let _e547 = phi_987_;
                                    if _e545 {
                                        let _e552 = (_e543.member_1 & 268435455u);
                                        if ((_e543.member_1 & 2147483648u) != 0u) {
                                            phi_3764_ = _e501;
                                            phi_1006_ = _e503;
                                            phi_1009_ = type_8(0u, ((_e543.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1040 = phi_3764_;
                                                let _e1042 = phi_1006_;
                                                let _e1044 = phi_1009_;
                                                local_15 = _e1042;
                                                if (_e1044.member < _e1044.member_1) {
                                                    phi_1010_ = type_8((_e1044.member + 1u), _e1044.member_1);
                                                    phi_1032_ = type_8(1u, _e1044.member);
                                                } else {
                                                    phi_1010_ = _e1044;
                                                    phi_1032_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1057 = phi_1010_;
                                                let _e1059 = phi_1032_;
                                                let _e1063 = (bitcast<i32>(_e1059.member) != 0i);
                                                if _e1063 {
                                                    let _e1069 = type_42(_e1042.member, _e1042.member_1, (_e1042.member_2 + 1u));
                                                    let _e1074 = (_e543.member.member_1.x - _e543.member.member.x);
                                                    let _e1077 = (_e543.member.member_1.y - _e543.member.member.y);
                                                    let _e1080 = (_e543.member.member_1.z - _e543.member.member.z);
                                                    let _e1082 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                    let _e1084 = select(_e1080, _e1082, (_e1082 > _e1080));
                                                    let _e1086 = (_e1084 < (1024f * _e150));
                                                    if _e1086 {
                                                        phi_1076_ = 0u;
                                                    } else {
                                                        phi_1076_ = select(2u, 1u, (_e1084 < (2097152f * _e150)));
                                                    }
                                                    let _e1091 = phi_1076_;
                                                    switch bitcast<i32>(_e1091) {
                                                        case 0: {
                                                            phi_1082_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1082_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1082_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1082_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1094 = phi_1082_;
                                                    switch bitcast<i32>(_e1091) {
                                                        case 0: {
                                                            phi_1092_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1092_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1092_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1092_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1101 = phi_1092_;
                                                    let _e1103 = ((_e552 + (_e1059.member_1 * ((3u * _e1094) + 1u))) + (3u * _e1101));
                                                    let _e1104 = (_e1103 < _e98);
                                                    if _e1104 {
                                                        if _e1104 {
                                                        } else {
                                                            phi_3822_ = true;
                                                            break;
                                                        }
                                                        let _e1106 = global_7.member[_e1103];
                                                        phi_1108_ = _e1106;
                                                    } else {
                                                        phi_1108_ = 4294967295u;
                                                    }
                                                    let _e1108 = phi_1108_;
                                                    local_10 = array<u32, 3>(_e276, _e275, _e277);
                                                    if _e1086 {
                                                        phi_1145_ = 0u;
                                                    } else {
                                                        phi_1145_ = select(2u, 1u, (_e1084 < (2097152f * _e150)));
                                                    }
                                                    let _e1114 = phi_1145_;
                                                    switch bitcast<i32>(_e1114) {
                                                        case 0: {
                                                            phi_1151_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1151_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1151_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1151_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1117 = phi_1151_;
                                                    switch bitcast<i32>(_e1114) {
                                                        case 0: {
                                                            phi_1161_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_1161_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_1161_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_1161_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1124 = phi_1161_;
                                                    local_12 = array<f32, 4>(_e543.member.member.x, _e543.member.member.y, _e543.member.member.z, _e543.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3749_ = _e1040;
                                                    phi_1177_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1138 = phi_3749_;
                                                        let _e1140 = phi_1177_;
                                                        if (_e1140.member < _e1140.member_1) {
                                                            phi_1178_ = type_8((_e1140.member + 1u), _e1140.member_1);
                                                            phi_1201_ = type_8(1u, _e1140.member);
                                                        } else {
                                                            phi_1178_ = _e1140;
                                                            phi_1201_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1153 = phi_1178_;
                                                        let _e1155 = phi_1201_;
                                                        let _e1159 = (bitcast<i32>(_e1155.member) != 0i);
                                                        if _e1159 {
                                                            let _e1161 = ((_e552 + (_e1059.member_1 * ((3u * _e1117) + 1u))) + (_e1155.member_1 * _e1124));
                                                            let _e1162 = (_e1161 < _e98);
                                                            if _e1162 {
                                                                if _e1162 {
                                                                } else {
                                                                    phi_3820_ = true;
                                                                    break;
                                                                }
                                                                let _e1164 = global_7.member[_e1161];
                                                                phi_1224_ = _e1164;
                                                            } else {
                                                                phi_1224_ = 0u;
                                                            }
                                                            let _e1166 = phi_1224_;
                                                            let _e1167 = (_e1161 + 1u);
                                                            let _e1168 = (_e1167 < _e98);
                                                            if _e1168 {
                                                                if _e1168 {
                                                                } else {
                                                                    phi_3820_ = true;
                                                                    break;
                                                                }
                                                                let _e1170 = global_7.member[_e1167];
                                                                phi_1239_ = _e1170;
                                                            } else {
                                                                phi_1239_ = 0u;
                                                            }
                                                            let _e1172 = phi_1239_;
                                                            phi_1242_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1174 = phi_1242_;
                                                                if (_e1174.member < _e1174.member_1) {
                                                                    phi_1243_ = type_8((_e1174.member + 1u), _e1174.member_1);
                                                                    phi_1266_ = type_8(1u, _e1174.member);
                                                                } else {
                                                                    phi_1243_ = _e1174;
                                                                    phi_1266_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1187 = phi_1243_;
                                                                let _e1189 = phi_1266_;
                                                                let _e1193 = (bitcast<i32>(_e1189.member) != 0i);
                                                                if _e1193 {
                                                                    let _e1194 = (_e1189.member_1 < 3u);
                                                                    if _e1194 {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1196 = local_10[_e1189.member_1];
                                                                    if (_e1189.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1199 = local_12[_e1189.member_1];
                                                                    switch bitcast<i32>(_e1114) {
                                                                        case 0: {
                                                                            phi_1336_ = (_e1199 + (f32(((_e1166 >> bitcast<u32>(((10u * _e1196) & 31u))) & 1023u)) * _e150));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1196 == 0u) {
                                                                                phi_1313_ = _e1166;
                                                                            } else {
                                                                                if (_e1196 == 1u) {
                                                                                    phi_1312_ = ((_e1166 >> bitcast<u32>(21i)) | (_e1172 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1312_ = (_e1172 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1220 = phi_1312_;
                                                                                phi_1313_ = _e1220;
                                                                            }
                                                                            let _e1222 = phi_1313_;
                                                                            phi_1336_ = (_e1199 + (f32((_e1222 & 2097151u)) * _e150));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1201 = (_e1161 + _e1196);
                                                                            let _e1202 = (_e1201 < _e98);
                                                                            if _e1202 {
                                                                                if _e1202 {
                                                                                } else {
                                                                                    phi_3742_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1204 = global_7.member[_e1201];
                                                                                phi_1332_ = _e1204;
                                                                            } else {
                                                                                phi_1332_ = 0u;
                                                                            }
                                                                            let _e1206 = phi_1332_;
                                                                            phi_1336_ = (f32(bitcast<i32>(_e1206)) * _e150);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1336_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1236 = phi_1336_;
                                                                    if (_e1155.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1194 {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1155.member_1][_e1189.member_1] = _e1236;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1242_ = _e1187;
                                                                    phi_3742_ = _e1138;
                                                                    break if !(_e1193);
                                                                }
                                                            }
                                                            let _e1242 = phi_3742_;
                                                            phi_3820_ = _e1242;
                                                            if _e1242 {
                                                                break;
                                                            }
                                                            phi_3821_ = _e1242;
                                                        } else {
                                                            phi_3821_ = _e1138;
                                                        }
                                                        let _e1244 = phi_3821_;
                                                        continue;
                                                        continuing {
                                                            phi_3749_ = _e1244;
                                                            phi_1177_ = _e1153;
                                                            phi_3820_ = _e1244;
                                                            break if !(_e1159);
                                                        }
                                                    }
                                                    let _e1247 = phi_3820_;
                                                    phi_3822_ = _e1247;
                                                    if _e1247 {
                                                        break;
                                                    }
                                                    let _e1248 = local_11;
                                                    let _e1265 = (_e1248[0][2] - _e381);
                                                    let _e1268 = (((_e1248[0][0] - _e308) * _e405) - (_e1265 * _e333));
                                                    let _e1271 = (((_e1248[0][1] - _e345) * _e405) - (_e1265 * _e369));
                                                    let _e1274 = (_e1248[1][2] - _e381);
                                                    let _e1277 = (((_e1248[1][0] - _e308) * _e405) - (_e1274 * _e333));
                                                    let _e1280 = (((_e1248[1][1] - _e345) * _e405) - (_e1274 * _e369));
                                                    let _e1283 = (_e1248[2][2] - _e381);
                                                    let _e1286 = (((_e1248[2][0] - _e308) * _e405) - (_e1283 * _e333));
                                                    let _e1289 = (((_e1248[2][1] - _e345) * _e405) - (_e1283 * _e369));
                                                    let _e1290 = (_e1286 * _e1280);
                                                    let _e1291 = (_e1289 * _e1277);
                                                    let _e1292 = (_e1268 * _e1289);
                                                    let _e1293 = (_e1271 * _e1286);
                                                    let _e1294 = (_e1277 * _e1271);
                                                    let _e1295 = (_e1280 * _e1268);
                                                    let _e1300 = (((_e1290 >= _e1291) && (_e1292 >= _e1293)) && (_e1294 >= _e1295));
                                                    if (_e1300 || (((_e1290 <= _e1291) && (_e1292 <= _e1293)) && (_e1294 <= _e1295))) {
                                                        let _e1307 = select(-1f, 1f, _e1300);
                                                        let _e1309 = ((_e1290 - _e1291) * _e1307);
                                                        let _e1311 = select(0f, _e1309, (_e1309 > 0f));
                                                        let _e1313 = ((_e1292 - _e1293) * _e1307);
                                                        let _e1315 = select(0f, _e1313, (_e1313 > 0f));
                                                        let _e1317 = ((_e1294 - _e1295) * _e1307);
                                                        let _e1319 = select(0f, _e1317, (_e1317 > 0f));
                                                        let _e1321 = ((_e1311 + _e1315) + _e1319);
                                                        if (_e1321 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1931_ = type_22();
                                                            phi_1932_ = true;
                                                        } else {
                                                            let _e1324 = select(_e1248[1][0], _e1248[0][0], (_e1248[0][0] < _e1248[1][0]));
                                                            let _e1328 = select(_e1248[1][0], _e1248[0][0], (_e1248[0][0] > _e1248[1][0]));
                                                            let _e1332 = select(_e1248[1][1], _e1248[0][1], (_e1248[0][1] < _e1248[1][1]));
                                                            let _e1336 = select(_e1248[1][1], _e1248[0][1], (_e1248[0][1] > _e1248[1][1]));
                                                            let _e1340 = select(_e1248[1][2], _e1248[0][2], (_e1248[0][2] < _e1248[1][2]));
                                                            let _e1344 = select(_e1248[1][2], _e1248[0][2], (_e1248[0][2] > _e1248[1][2]));
                                                            let _e1349 = ((select(_e1248[2][0], _e1324, (_e1324 < _e1248[2][0])) - _e331) * _e336);
                                                            let _e1350 = ((select(_e1248[2][0], _e1328, (_e1328 > _e1248[2][0])) - _e332) * _e336);
                                                            let _e1353 = ((select(_e1248[2][1], _e1332, (_e1332 < _e1248[2][1])) - _e367) * _e372);
                                                            let _e1354 = ((select(_e1248[2][1], _e1336, (_e1336 > _e1248[2][1])) - _e368) * _e372);
                                                            let _e1357 = ((select(_e1248[2][2], _e1340, (_e1340 < _e1248[2][2])) - _e403) * _e408);
                                                            let _e1358 = ((select(_e1248[2][2], _e1344, (_e1344 > _e1248[2][2])) - _e404) * _e408);
                                                            let _e1360 = select(_e1358, _e1357, (_e1357 < _e1358));
                                                            let _e1362 = select(_e1358, _e1357, (_e1357 > _e1358));
                                                            let _e1364 = select(_e1350, _e1349, (_e1349 < _e1350));
                                                            let _e1366 = select(_e1354, _e1353, (_e1353 < _e1354));
                                                            let _e1368 = select(_e1366, _e1364, (_e1364 > _e1366));
                                                            let _e1370 = select(_e1360, _e1368, (_e1368 > _e1360));
                                                            let _e1372 = select(_e1350, _e1349, (_e1349 > _e1350));
                                                            let _e1374 = select(_e1354, _e1353, (_e1353 > _e1354));
                                                            let _e1376 = select(_e1374, _e1372, (_e1372 < _e1374));
                                                            let _e1378 = select(_e1362, _e1376, (_e1376 < _e1362));
                                                            let _e1379 = -(_e1360);
                                                            let _e1385 = select(_e454, _e1370, (_e1370 > _e454));
                                                            if (_e1385 > (_e1378 + (select(_e1379, _e1362, (_e1362 > _e1379)) * 0.0000019073523f))) {
                                                                phi_1926_ = type_22();
                                                                phi_1927_ = true;
                                                            } else {
                                                                let _e1387 = (_e1385 > _e1042.member.member_1);
                                                                if _e1387 {
                                                                    phi_1925_ = type_22();
                                                                } else {
                                                                    let _e1391 = (_e1248[1][0] - _e1248[0][0]);
                                                                    let _e1392 = (_e1248[1][1] - _e1248[0][1]);
                                                                    let _e1393 = (_e1248[1][2] - _e1248[0][2]);
                                                                    let _e1394 = vec3<f32>(_e1391, _e1392, _e1393);
                                                                    let _e1395 = (_e1248[2][0] - _e1248[1][0]);
                                                                    let _e1396 = (_e1248[2][1] - _e1248[1][1]);
                                                                    let _e1397 = (_e1248[2][2] - _e1248[1][2]);
                                                                    let _e1398 = vec3<f32>(_e1395, _e1396, _e1397);
                                                                    let _e1399 = (_e1248[0][0] - _e1248[2][0]);
                                                                    let _e1400 = (_e1248[0][1] - _e1248[2][1]);
                                                                    let _e1401 = (_e1248[0][2] - _e1248[2][2]);
                                                                    let _e1402 = vec3<f32>(_e1399, _e1400, _e1401);
                                                                    let _e1405 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                    let _e1408 = bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u));
                                                                    let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                                    let _e1413 = bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u));
                                                                    let _e1415 = select(_e1413, _e1410, (_e1410 > _e1413));
                                                                    let _e1418 = bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u));
                                                                    let _e1421 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                                    let _e1423 = select(_e1421, _e1418, (_e1418 > _e1421));
                                                                    let _e1426 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                    let _e1428 = select(_e1426, _e1423, (_e1423 > _e1426));
                                                                    let _e1431 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                    let _e1434 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                    let _e1436 = select(_e1434, _e1431, (_e1431 > _e1434));
                                                                    let _e1439 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                    let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                                    let _e1443 = select(_e1428, _e1415, (_e1415 > _e1428));
                                                                    let _e1445 = select(_e1441, _e1443, (_e1443 > _e1441));
                                                                    if (_e1415 == _e1445) {
                                                                        phi_1836_ = _e1398;
                                                                        phi_1837_ = _e1402;
                                                                    } else {
                                                                        let _e1448 = vec3((_e1428 == _e1445));
                                                                        phi_1836_ = select(_e1394, _e1402, _e1448);
                                                                        phi_1837_ = select(_e1398, _e1394, _e1448);
                                                                    }
                                                                    let _e1452 = phi_1836_;
                                                                    let _e1454 = phi_1837_;
                                                                    let _e1461 = ((_e1452.y * _e1454.z) - (_e1454.y * _e1452.z));
                                                                    let _e1466 = ((_e1452.z * _e1454.x) - (_e1454.z * _e1452.x));
                                                                    let _e1469 = ((_e1452.x * _e1454.y) - (_e1454.x * _e1452.y));
                                                                    if (_e1311 >= _e1315) {
                                                                        phi_1868_ = select(true, false, (_e1311 >= _e1319));
                                                                    } else {
                                                                        phi_1868_ = true;
                                                                    }
                                                                    let _e1474 = phi_1868_;
                                                                    if _e1474 {
                                                                        phi_1877_ = select(vec3<f32>(_e1248[2][0], _e1248[2][1], _e1248[2][2]), vec3<f32>(_e1248[1][0], _e1248[1][1], _e1248[1][2]), vec3((_e1315 >= _e1319)));
                                                                    } else {
                                                                        phi_1877_ = vec3<f32>(_e1248[0][0], _e1248[0][1], _e1248[0][2]);
                                                                    }
                                                                    let _e1479 = phi_1877_;
                                                                    let _e1496 = ((((_e1461 * (_e1479.x - _e308)) + (_e1466 * (_e1479.y - _e345))) + (_e1469 * (_e1479.z - _e381))) / (((_e1461 * _e333) + (_e1466 * _e369)) + (_e1469 * _e405)));
                                                                    let _e1498 = select(_e1378, _e1496, (_e1496 < _e1378));
                                                                    let _e1500 = select(_e1370, _e1498, (_e1498 > _e1370));
                                                                    if (_e1500 >= _e454) {
                                                                        let _e1502 = (_e1500 <= _e1042.member.member_1);
                                                                        if _e1502 {
                                                                            let _e1503 = (1f / _e1321);
                                                                            phi_1917_ = type_22(_e1500, (_e1315 * _e1503), (_e1319 * _e1503), _e1108);
                                                                        } else {
                                                                            phi_1917_ = type_22();
                                                                        }
                                                                        let _e1508 = phi_1917_;
                                                                        phi_1919_ = _e1508;
                                                                        phi_1920_ = select(true, false, _e1502);
                                                                    } else {
                                                                        phi_1919_ = type_22();
                                                                        phi_1920_ = true;
                                                                    }
                                                                    let _e1511 = phi_1919_;
                                                                    let _e1513 = phi_1920_;
                                                                    if _e1513 {
                                                                        phi_1924_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1924_ = _e1511;
                                                                    }
                                                                    let _e1515 = phi_1924_;
                                                                    phi_1925_ = _e1515;
                                                                }
                                                                let _e1517 = phi_1925_;
                                                                phi_1926_ = _e1517;
                                                                phi_1927_ = _e1387;
                                                            }
                                                            let _e1519 = phi_1926_;
                                                            let _e1521 = phi_1927_;
                                                            phi_1931_ = _e1519;
                                                            phi_1932_ = _e1521;
                                                        }
                                                        let _e1523 = phi_1931_;
                                                        let _e1525 = phi_1932_;
                                                        phi_1936_ = _e1523;
                                                        phi_1937_ = _e1525;
                                                    } else {
                                                        phi_1936_ = type_22();
                                                        phi_1937_ = true;
                                                    }
                                                    let _e1527 = phi_1936_;
                                                    let _e1529 = phi_1937_;
                                                    if _e1529 {
                                                        phi_1941_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1941_ = _e1527;
                                                    }
                                                    let _e1531 = phi_1941_;
                                                    if (_e1531.member_3 != 4294967295u) {
                                                        if (_e1108 != _e460) {
                                                            if (_e1531.member < _e1042.member.member.member) {
                                                                phi_1967_ = true;
                                                            } else {
                                                                if (_e1531.member == _e1042.member.member.member) {
                                                                    phi_1966_ = (_e1531.member_3 < _e1042.member.member.member_3);
                                                                } else {
                                                                    phi_1966_ = false;
                                                                }
                                                                let _e1546 = phi_1966_;
                                                                phi_1967_ = _e1546;
                                                            }
                                                            let _e1548 = phi_1967_;
                                                            if _e1548 {
                                                                phi_1974_ = type_42(type_39(_e1531, _e1531.member), _e1069.member_1, _e1069.member_2);
                                                            } else {
                                                                phi_1974_ = _e1069;
                                                            }
                                                            let _e1555 = phi_1974_;
                                                            phi_1975_ = _e1555;
                                                        } else {
                                                            phi_1975_ = _e1069;
                                                        }
                                                        let _e1557 = phi_1975_;
                                                        phi_1976_ = _e1557;
                                                    } else {
                                                        phi_1976_ = _e1069;
                                                    }
                                                    let _e1559 = phi_1976_;
                                                    phi_3823_ = _e1247;
                                                    phi_1007_ = _e1559;
                                                } else {
                                                    phi_3823_ = _e1040;
                                                    phi_1007_ = type_42();
                                                }
                                                let _e1561 = phi_3823_;
                                                let _e1563 = phi_1007_;
                                                continue;
                                                continuing {
                                                    phi_3764_ = _e1561;
                                                    phi_1006_ = _e1563;
                                                    phi_1009_ = _e1057;
                                                    phi_3822_ = _e1561;
                                                    break if !(_e1063);
                                                }
                                            }
                                            let _e1566 = phi_3822_;
                                            phi_3881_ = _e1566;
                                            if _e1566 {
                                                break;
                                            }
                                            phi_3885_ = _e1566;
                                            let _e1808 = local_15;
                                            phi_3361_ = _e1808;
                                            phi_3362_ = _e543;
                                            phi_3363_ = false;
                                            phi_3364_ = _e547;
                                        } else {
                                            if (_e543.member_1 >= _e95) {
                                                phi_2917_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e543.member_1 < _e95) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e566 = ((1u + _e276) % 4u);
                                                if (_e566 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e571 = global_3.member[_e543.member_1][_e566];
                                                let _e573 = ((1u + _e275) % 4u);
                                                if (_e573 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e578 = global_3.member[_e543.member_1][_e573];
                                                let _e580 = ((1u + _e277) % 4u);
                                                if (_e580 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e585 = global_3.member[_e543.member_1][_e580];
                                                let _e587 = ((_e276 + 1u) % 4u);
                                                if (_e587 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e592 = global_3.member[_e543.member_1][_e587];
                                                let _e594 = (_e592 >> bitcast<u32>(11u));
                                                let _e596 = ((_e275 + 1u) % 4u);
                                                if (_e596 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e601 = global_3.member[_e543.member_1][_e596];
                                                let _e603 = (_e601 >> bitcast<u32>(11u));
                                                let _e605 = ((_e277 + 1u) % 4u);
                                                if (_e605 < 4u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e610 = global_3.member[_e543.member_1][_e605];
                                                let _e612 = (_e610 >> bitcast<u32>(11u));
                                                let _e635 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.x - _e543.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e636 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.y - _e543.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e637 = (bitcast<f32>((bitcast<u32>((_e543.member.member_1.z - _e543.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e639 = select(_e150, _e635, (_e635 > _e150));
                                                let _e641 = select(_e150, _e636, (_e636 > _e150));
                                                let _e643 = select(_e150, _e637, (_e637 > _e150));
                                                let _e668 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e639));
                                                let _e673 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                                let _e677 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e641));
                                                let _e682 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                                let _e686 = bitcast<u32>((f32(bitcast<i32>((_e585 & 1023u))) * _e643));
                                                let _e691 = (bitcast<i32>((_e585 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                                let _e698 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                                let _e702 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                                let _e706 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                                let _e707 = bitcast<u32>((f32(bitcast<i32>((_e594 & 1023u))) * _e639));
                                                let _e712 = (bitcast<i32>((_e594 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                                let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 1023u))) * _e641));
                                                let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                                let _e725 = bitcast<u32>((f32(bitcast<i32>((_e612 & 1023u))) * _e643));
                                                let _e730 = (bitcast<i32>((_e612 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e733 = bitcast<f32>((_e725 & bitcast<u32>(_e730)));
                                                let _e737 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                                let _e741 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                                let _e745 = bitcast<f32>((_e725 & bitcast<u32>(~(_e730))));
                                                let _e746 = (_e543.member.member.x + _e676);
                                                let _e747 = (_e543.member.member.y + _e685);
                                                let _e748 = (_e543.member.member.z + _e694);
                                                let _e751 = (_e543.member.member_1.x - _e715);
                                                let _e752 = (_e543.member.member_1.y - _e724);
                                                let _e753 = (_e543.member.member_1.z - _e733);
                                                let _e772 = (_e751 - _e746);
                                                let _e773 = (_e752 - _e747);
                                                let _e774 = (_e753 - _e748);
                                                let _e776 = select(_e773, _e772, (_e772 > _e773));
                                                let _e778 = select(_e774, _e776, (_e776 > _e774));
                                                if (_e778 < (1024f * _e150)) {
                                                    phi_2618_ = 0u;
                                                } else {
                                                    phi_2618_ = select(2u, 1u, (_e778 < (2097152f * _e150)));
                                                }
                                                let _e785 = phi_2618_;
                                                switch bitcast<i32>(_e785) {
                                                    case 0: {
                                                        phi_2624_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2624_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2624_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2624_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e788 = phi_2624_;
                                                let _e794 = global_3.member[_e543.member_1][0u];
                                                let _e798 = global_3.member[_e543.member_1][1u];
                                                let _e802 = global_3.member[_e543.member_1][2u];
                                                let _e806 = global_3.member[_e543.member_1][3u];
                                                let _e818 = (((_e798 >> bitcast<u32>(22i)) | ((_e802 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e806 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e819 = (_e794 & 268435455u);
                                                let _e820 = (_e818 & 268435455u);
                                                let _e823 = ((_e794 >> bitcast<u32>(28u)) & 7u);
                                                let _e831 = ((_e794 >> bitcast<u32>(31i)) | (((_e818 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e832 = (_e823 != 0u);
                                                if (_e823 == 0u) {
                                                    phi_2879_ = _e819;
                                                } else {
                                                    if (_e823 == 7u) {
                                                        phi_2878_ = 2147483648u;
                                                    } else {
                                                        phi_2878_ = ((2147483648u | (_e823 << bitcast<u32>(28u))) | (_e820 & 268435455u));
                                                    }
                                                    let _e841 = phi_2878_;
                                                    phi_2879_ = _e841;
                                                }
                                                let _e843 = phi_2879_;
                                                if _e832 {
                                                    let _e844 = (_e823 != 7u);
                                                    if _e844 {
                                                        phi_2889_ = (_e820 + (_e823 * ((3u * _e788) + 1u)));
                                                    } else {
                                                        phi_2889_ = u32();
                                                    }
                                                    let _e848 = phi_2889_;
                                                    phi_2891_ = _e848;
                                                    phi_2892_ = select(true, false, _e844);
                                                } else {
                                                    phi_2891_ = u32();
                                                    phi_2892_ = true;
                                                }
                                                let _e851 = phi_2891_;
                                                let _e853 = phi_2892_;
                                                if (_e831 == 0u) {
                                                    phi_2913_ = (_e819 + select(0u, 1u, !(_e832)));
                                                } else {
                                                    if (_e831 == 7u) {
                                                        phi_2912_ = 2147483648u;
                                                    } else {
                                                        phi_2912_ = ((2147483648u | (_e831 << bitcast<u32>(28u))) | (select(_e851, _e820, _e853) & 268435455u));
                                                    }
                                                    let _e866 = phi_2912_;
                                                    phi_2913_ = _e866;
                                                }
                                                let _e868 = phi_2913_;
                                                phi_2917_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e746, (_e543.member.member.x + _e698), _e751, (_e543.member.member_1.x - _e737)), vec4<f32>(_e747, (_e543.member.member.y + _e702), _e752, (_e543.member.member_1.y - _e741)), vec4<f32>(_e748, (_e543.member.member.z + _e706), _e753, (_e543.member.member_1.z - _e745))), type_53(type_34((_e543.member.member + vec4<f32>(_e676, _e685, _e694, 0f)), (_e543.member.member_1 - vec4<f32>(_e715, _e724, _e733, 0f))), _e843), type_53(type_34((_e543.member.member + vec4<f32>(_e698, _e702, _e706, 0f)), (_e543.member.member_1 - vec4<f32>(_e737, _e741, _e745, 0f))), _e868));
                                            }
                                            let _e873 = phi_2917_;
                                            let _e886 = ((_e873.member[0].x - _e331) * _e336);
                                            let _e887 = ((_e873.member[0].y - _e331) * _e336);
                                            let _e888 = ((_e873.member[0].z - _e332) * _e336);
                                            let _e889 = ((_e873.member[0].w - _e332) * _e336);
                                            let _e899 = ((_e873.member[1].x - _e367) * _e372);
                                            let _e900 = ((_e873.member[1].y - _e367) * _e372);
                                            let _e901 = ((_e873.member[1].z - _e368) * _e372);
                                            let _e902 = ((_e873.member[1].w - _e368) * _e372);
                                            let _e912 = ((_e873.member[2].x - _e403) * _e408);
                                            let _e913 = ((_e873.member[2].y - _e403) * _e408);
                                            let _e914 = ((_e873.member[2].z - _e404) * _e408);
                                            let _e915 = ((_e873.member[2].w - _e404) * _e408);
                                            let _e917 = select(_e914, _e912, (_e912 < _e914));
                                            let _e919 = select(_e915, _e913, (_e913 < _e915));
                                            let _e921 = select(_e914, _e912, (_e912 > _e914));
                                            let _e923 = select(_e915, _e913, (_e913 > _e915));
                                            let _e925 = select(_e888, _e886, (_e886 < _e888));
                                            let _e927 = select(_e889, _e887, (_e887 < _e889));
                                            let _e929 = select(_e901, _e899, (_e899 < _e901));
                                            let _e931 = select(_e902, _e900, (_e900 < _e902));
                                            let _e933 = select(_e929, _e925, (_e925 > _e929));
                                            let _e935 = select(_e931, _e927, (_e927 > _e931));
                                            let _e937 = select(_e917, _e933, (_e933 > _e917));
                                            let _e939 = select(_e919, _e935, (_e935 > _e919));
                                            let _e941 = select(_e888, _e886, (_e886 > _e888));
                                            let _e943 = select(_e889, _e887, (_e887 > _e889));
                                            let _e945 = select(_e901, _e899, (_e899 > _e901));
                                            let _e947 = select(_e902, _e900, (_e900 > _e902));
                                            let _e949 = select(_e945, _e941, (_e941 < _e945));
                                            let _e951 = select(_e947, _e943, (_e943 < _e947));
                                            let _e956 = -(_e917);
                                            let _e957 = -(_e919);
                                            let _e964 = (select(_e921, _e949, (_e949 < _e921)) + (select(_e956, _e921, (_e921 > _e956)) * 0.0000019073523f));
                                            let _e965 = (select(_e923, _e951, (_e951 < _e923)) + (select(_e957, _e923, (_e923 > _e957)) * 0.0000019073523f));
                                            let _e967 = select(_e454, _e937, (_e937 > _e454));
                                            let _e969 = select(_e454, _e939, (_e939 > _e454));
                                            let _e974 = (_e967 <= select(_e503.member.member_1, _e964, (_e964 < _e503.member.member_1)));
                                            let _e975 = (_e969 <= select(_e503.member.member_1, _e965, (_e965 < _e503.member.member_1)));
                                            let _e976 = (_e967 <= _e969);
                                            if _e974 {
                                                if _e975 {
                                                    if _e976 {
                                                        phi_3261_ = _e873.member_2;
                                                    } else {
                                                        phi_3261_ = _e873.member_1;
                                                    }
                                                    let _e980 = phi_3261_;
                                                    let _e1002 = (_e547 % 128u);
                                                    let _e1003 = (_e1002 < 128u);
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1002] = _e980.member_1;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1002] = _e980.member.member.x;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1002] = _e980.member.member.y;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1002] = _e980.member.member.z;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1002] = _e980.member.member_1.x;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1002] = _e980.member.member_1.y;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1002] = _e980.member.member_1.z;
                                                    if _e1003 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1002] = select(_e969, _e967, (_e967 > _e969));
                                                    if _e976 {
                                                        phi_3338_ = _e873.member_1;
                                                    } else {
                                                        phi_3338_ = _e873.member_2;
                                                    }
                                                    let _e1016 = phi_3338_;
                                                    phi_3339_ = _e1016;
                                                    phi_3340_ = (_e547 + 1u);
                                                } else {
                                                    phi_3339_ = type_53();
                                                    phi_3340_ = u32();
                                                }
                                                let _e1018 = phi_3339_;
                                                let _e1020 = phi_3340_;
                                                phi_3342_ = _e1018;
                                                phi_3343_ = _e1020;
                                                phi_3344_ = select(true, false, _e975);
                                            } else {
                                                phi_3342_ = type_53();
                                                phi_3343_ = u32();
                                                phi_3344_ = true;
                                            }
                                            let _e1023 = phi_3342_;
                                            let _e1025 = phi_3343_;
                                            let _e1027 = phi_3344_;
                                            if _e1027 {
                                                if _e974 {
                                                    phi_3353_ = _e873.member_1;
                                                } else {
                                                    phi_3353_ = _e873.member_2;
                                                }
                                                let _e1031 = phi_3353_;
                                                phi_3358_ = _e1031;
                                                phi_3359_ = select(_e975, true, _e974);
                                            } else {
                                                phi_3358_ = _e1023;
                                                phi_3359_ = _e545;
                                            }
                                            let _e1034 = phi_3358_;
                                            let _e1036 = phi_3359_;
                                            phi_3885_ = _e501;
                                            phi_3361_ = type_42(_e503.member, (_e503.member_1 + 1u), _e503.member_2);
                                            phi_3362_ = _e1034;
                                            phi_3363_ = _e1036;
                                            phi_3364_ = select(_e1025, _e547, _e1027);
                                        }
                                        let _e1568 = phi_3885_;
                                        let _e1570 = phi_3361_;
                                        let _e1572 = phi_3362_;
                                        let _e1574 = phi_3363_;
                                        let _e1576 = phi_3364_;
                                        phi_3884_ = _e1568;
                                        phi_3365_ = _e1570;
                                        phi_3366_ = _e1572;
                                        phi_3367_ = (_e507 - 1u);
                                        phi_3368_ = _e1574;
                                        phi_3369_ = _e1576;
                                    } else {
                                        phi_3884_ = _e501;
                                        phi_3365_ = _e503;
                                        phi_3366_ = _e543;
                                        phi_3367_ = _e507;
                                        phi_3368_ = _e545;
                                        phi_3369_ = _e547;
                                    }
                                    let _e1578 = phi_3884_;
                                    let _e1580 = phi_3365_;
                                    let _e1582 = phi_3366_;
                                    let _e1584 = phi_3367_;
                                    let _e1586 = phi_3368_;
                                    let _e1588 = phi_3369_;
                                    phi_3883_ = _e1578;
                                    phi_3370_ = _e1580;
                                    phi_3371_ = _e1582;
                                    phi_3372_ = _e1584;
                                    phi_3373_ = _e1586;
                                    phi_3374_ = _e1588;
                                } else {
                                    phi_3883_ = _e501;
                                    phi_3370_ = type_42();
                                    phi_3371_ = type_53();
                                    phi_3372_ = u32();
                                    phi_3373_ = bool();
                                    phi_3374_ = u32();
                                }
                                let _e1590 = phi_3883_;
                                let _e1592 = phi_3370_;
                                let _e1594 = phi_3371_;
                                let _e1596 = phi_3372_;
                                let _e1598 = phi_3373_;
                                let _e1600 = phi_3374_;
                                phi_3882_ = _e1590;
                                phi_880_ = _e1592;
                                phi_883_ = _e1594;
                                phi_885_ = _e1596;
                                phi_887_ = _e1598;
                                phi_889_ = _e1600;
                                phi_3375_ = _e515;
                            } else {
                                phi_3882_ = _e501;
                                phi_880_ = type_42();
                                phi_883_ = type_53();
                                phi_885_ = u32();
                                phi_887_ = bool();
                                phi_889_ = u32();
                                phi_3375_ = false;
                            }
                            let _e1602 = phi_3882_;
                            let _e1604 = phi_880_;
                            let _e1606 = phi_883_;
                            let _e1608 = phi_885_;
                            let _e1610 = phi_887_;
                            let _e1612 = phi_889_;
                            let _e1614 = phi_3375_;
                            continue;
                            continuing {
                                phi_3767_ = _e1602;
                                phi_879_ = _e1604;
                                phi_882_ = _e1606;
                                phi_884_ = _e1608;
                                phi_886_ = _e1610;
                                phi_888_ = _e1612;
                                phi_3881_ = _e1602;
                                break if !(_e1614);
                            }
                        }
                        let _e1617 = phi_3881_;
                        if _e1617 {
                            break;
                        }
                        let _e1619 = local_13;
                        if (_e1619.member.member.member_3 != 4294967295u) {
                            let _e1625 = (_e278 / 3i);
                            let _e1632 = bitcast<f32>((bitcast<u32>((_e1625 + 127i)) << bitcast<u32>(23i)));
                            let _e1640 = (((_e1619.member.member.member * _e1632) * _e1632) * bitcast<f32>((bitcast<u32>(((_e278 - (2i * _e1625)) + 127i)) << bitcast<u32>(23i))));
                            let _e1642 = select(340282350000000000000000000000000000000f, _e1640, (_e1640 < 340282350000000000000000000000000000000f));
                            phi_3427_ = type_22(select(-340282350000000000000000000000000000000f, _e1642, (_e1642 > -340282350000000000000000000000000000000f)), _e1619.member.member.member_1, _e1619.member.member.member_2, _e1619.member.member.member_3);
                        } else {
                            phi_3427_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1649 = phi_3427_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_1.member[_e138] = _e1649;
                        let _e1653 = local_14;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_5.member[_e138] = _e1653.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1658 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1658 > 0u) {
                            let _e1660 = (1u < _e106);
                            if _e1660 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1664 = atomicAdd((&global_6.member[0u]), _e1658);
                                if ((_e1664 + _e1658) < _e1664) {
                                    if _e1660 {
                                    } else {
                                        break;
                                    }
                                    let _e1669 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1672 = select(0u, 1u, (_e1649.member_3 != 4294967295u));
                        if (_e1672 > 0u) {
                            let _e1674 = (3u < _e106);
                            if _e1674 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1678 = atomicAdd((&global_6.member[2u]), _e1672);
                                if ((_e1678 + _e1672) < _e1678) {
                                    if _e1674 {
                                    } else {
                                        break;
                                    }
                                    let _e1683 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1653.member_1 > 0u) {
                            let _e1685 = (5u < _e106);
                            if _e1685 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1689 = atomicAdd((&global_6.member[4u]), _e1653.member_1);
                                if ((_e1689 + _e1653.member_1) < _e1689) {
                                    if _e1685 {
                                    } else {
                                        break;
                                    }
                                    let _e1694 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
