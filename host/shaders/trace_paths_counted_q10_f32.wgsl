struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_42 {
    member: type_26,
    member_1: f32,
}

struct type_46 {
    member: type_42,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_38,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_48;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

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
    var phi_387_: i32;
    var phi_388_: i32;
    var phi_398_: bool;
    var phi_408_: u32;
    var phi_409_: u32;
    var phi_411_: bool;
    var phi_416_: u32;
    var phi_448_: i32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_512_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_589_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_644_: f32;
    var phi_655_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_3321_: bool;
    var phi_854_: type_46;
    var phi_857_: type_53;
    var phi_859_: u32;
    var phi_861_: bool;
    var phi_863_: u32;
    var phi_874_: bool;
    var phi_960_: type_53;
    var phi_961_: bool;
    var phi_962_: u32;
    var phi_2455_: u32;
    var phi_2456_: u32;
    var phi_2466_: u32;
    var phi_2468_: u32;
    var phi_2469_: bool;
    var phi_2489_: u32;
    var phi_2490_: u32;
    var phi_2494_: type_54;
    var phi_2838_: type_53;
    var phi_2915_: type_53;
    var phi_2916_: type_53;
    var phi_2917_: u32;
    var phi_2919_: type_53;
    var phi_2920_: u32;
    var phi_2921_: bool;
    var phi_2930_: type_53;
    var phi_2935_: type_53;
    var phi_2936_: bool;
    var phi_980_: type_46;
    var phi_983_: type_7;
    var phi_984_: type_7;
    var phi_1006_: type_7;
    var phi_1030_: u32;
    var phi_1119_: array<array<f32, 3>, 3>;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1622_: bool;
    var phi_1631_: vec3<f32>;
    var phi_1671_: type_26;
    var phi_1673_: type_26;
    var phi_1674_: bool;
    var phi_1678_: type_26;
    var phi_1679_: type_26;
    var phi_1680_: type_26;
    var phi_1681_: bool;
    var phi_1685_: type_26;
    var phi_1686_: bool;
    var phi_1690_: type_26;
    var phi_1691_: bool;
    var phi_1695_: type_26;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1728_: type_46;
    var phi_1729_: type_46;
    var phi_1730_: type_46;
    var phi_981_: type_46;
    var phi_3315_: bool;
    var phi_3433_: bool;
    var phi_2938_: type_46;
    var phi_2939_: type_53;
    var phi_2940_: bool;
    var phi_2941_: u32;
    var phi_3432_: bool;
    var phi_2942_: type_46;
    var phi_2943_: type_53;
    var phi_2944_: u32;
    var phi_2945_: bool;
    var phi_2946_: u32;
    var phi_3431_: bool;
    var phi_2947_: type_46;
    var phi_2948_: type_53;
    var phi_2949_: u32;
    var phi_2950_: bool;
    var phi_2951_: u32;
    var phi_3430_: bool;
    var phi_855_: type_46;
    var phi_858_: type_53;
    var phi_860_: u32;
    var phi_862_: bool;
    var phi_864_: u32;
    var phi_2952_: bool;
    var phi_3429_: bool;
    var local_10: type_46;
    var phi_3004_: type_26;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e86 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_1.member));
            let _e96 = arrayLength((&global_7.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[0u][3u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e128 = (_e84.x + (_e84.y * 2097152u));
            let _e140 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e112) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e100), bitcast<i32>(_e104), bitcast<i32>(_e108));
            local = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            let _e143 = (_e128 < arrayLength((&global_5.member)));
            if _e143 {
                let _e144 = (_e128 < arrayLength((&global_2.member)));
                if _e144 {
                    let _e145 = (_e128 < arrayLength((&global_6.member)));
                    if _e145 {
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e155 = global_5.member[_e128].member.member_2[0u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e163 = global_5.member[_e128].member.member_2[1u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_5.member[_e128].member.member_2[2u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_5.member[_e128].member.member[0u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_5.member[_e128].member.member[1u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_5.member[_e128].member.member[2u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e199 = select(_e165, _e157, (_e165 < _e157));
                        let _e201 = select(_e173, _e199, (_e173 < _e199));
                        let _e203 = select(_e181, _e201, (_e181 < _e201));
                        let _e205 = select(_e189, _e203, (_e189 < _e203));
                        let _e207 = select(_e197, _e205, (_e197 < _e205));
                        let _e212 = global_5.member[_e128].member.member_1;
                        let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                        let _e222 = global_5.member[_e128].member.member_3;
                        let _e228 = (((select(_e214, _e207, (_e214 < _e207)) < 2139095040u) && ((bitcast<u32>(_e222) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                        if _e228 {
                            let _e231 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                            if (_e231 >= 8388608u) {
                                phi_387_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e245 = phi_387_;
                            phi_388_ = _e245;
                        } else {
                            phi_388_ = 0i;
                        }
                        let _e247 = phi_388_;
                        let _e248 = (_e157 == _e201);
                        if _e248 {
                            phi_398_ = true;
                        } else {
                            phi_398_ = (_e165 == _e201);
                        }
                        let _e251 = phi_398_;
                        let _e252 = select(1u, 0u, _e248);
                        if _e251 {
                            let _e253 = (_e252 + 1u);
                            phi_408_ = _e253;
                            phi_409_ = _e253;
                            phi_411_ = select(true, false, (_e253 == 2u));
                        } else {
                            phi_408_ = u32();
                            phi_409_ = 0u;
                            phi_411_ = true;
                        }
                        let _e257 = phi_408_;
                        let _e259 = phi_409_;
                        let _e261 = phi_411_;
                        if _e261 {
                            phi_416_ = (_e259 + 1u);
                        } else {
                            phi_416_ = 0u;
                        }
                        let _e265 = phi_416_;
                        let _e266 = select(_e257, _e259, _e261);
                        let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                        let _e268 = -(_e247);
                        if (_e268 < -126i) {
                            phi_448_ = -126i;
                        } else {
                            phi_448_ = select(_e268, 127i, (_e268 > 127i));
                        }
                        let _e273 = phi_448_;
                        let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                        let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                        let _e289 = global_5.member[_e128].member.member;
                        let _e290 = (_e266 == 0u);
                        if _e290 {
                            phi_466_ = _e289[0];
                        } else {
                            phi_466_ = _e289[1];
                        }
                        let _e294 = phi_466_;
                        let _e295 = (_e266 == 2u);
                        if _e295 {
                            phi_472_ = _e289[2];
                        } else {
                            phi_472_ = _e294;
                        }
                        let _e298 = phi_472_;
                        let _e299 = global_5.member[_e128].member.member_2;
                        if _e290 {
                            phi_483_ = _e299[0];
                        } else {
                            phi_483_ = _e299[1];
                        }
                        let _e303 = phi_483_;
                        if _e295 {
                            phi_489_ = _e299[2];
                        } else {
                            phi_489_ = _e303;
                        }
                        let _e306 = phi_489_;
                        let _e308 = ((_e306 * _e278) * _e284);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                            phi_512_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                        } else {
                            phi_512_ = 0f;
                        }
                        let _e320 = phi_512_;
                        let _e321 = (_e298 + _e320);
                        let _e322 = (_e298 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_523_ = 38685626000000000000000000f;
                        } else {
                            phi_523_ = (1f / _e308);
                        }
                        let _e326 = phi_523_;
                        let _e327 = (_e265 == 0u);
                        if _e327 {
                            phi_532_ = _e289[0];
                        } else {
                            phi_532_ = _e289[1];
                        }
                        let _e331 = phi_532_;
                        let _e332 = (_e265 == 2u);
                        if _e332 {
                            phi_538_ = _e289[2];
                        } else {
                            phi_538_ = _e331;
                        }
                        let _e335 = phi_538_;
                        if _e327 {
                            phi_549_ = _e299[0];
                        } else {
                            phi_549_ = _e299[1];
                        }
                        let _e339 = phi_549_;
                        if _e332 {
                            phi_555_ = _e299[2];
                        } else {
                            phi_555_ = _e339;
                        }
                        let _e342 = phi_555_;
                        let _e344 = ((_e342 * _e278) * _e284);
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e348 {
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_578_ = select(0.00000000000011368684f, _e352, (_e352 > 0.00000000000011368684f));
                        } else {
                            phi_578_ = 0f;
                        }
                        let _e356 = phi_578_;
                        let _e357 = (_e335 + _e356);
                        let _e358 = (_e335 - _e356);
                        let _e359 = select(_e344, 0f, _e348);
                        if _e348 {
                            phi_589_ = 38685626000000000000000000f;
                        } else {
                            phi_589_ = (1f / _e344);
                        }
                        let _e362 = phi_589_;
                        let _e363 = (_e267 == 0u);
                        if _e363 {
                            phi_598_ = _e289[0];
                        } else {
                            phi_598_ = _e289[1];
                        }
                        let _e367 = phi_598_;
                        let _e368 = (_e267 == 2u);
                        if _e368 {
                            phi_604_ = _e289[2];
                        } else {
                            phi_604_ = _e367;
                        }
                        let _e371 = phi_604_;
                        if _e363 {
                            phi_615_ = _e299[0];
                        } else {
                            phi_615_ = _e299[1];
                        }
                        let _e375 = phi_615_;
                        if _e368 {
                            phi_621_ = _e299[2];
                        } else {
                            phi_621_ = _e375;
                        }
                        let _e378 = phi_621_;
                        let _e380 = ((_e378 * _e278) * _e284);
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e384 {
                            let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                            phi_644_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                        } else {
                            phi_644_ = 0f;
                        }
                        let _e392 = phi_644_;
                        let _e393 = (_e371 + _e392);
                        let _e394 = (_e371 - _e392);
                        let _e395 = select(_e380, 0f, _e384);
                        if _e384 {
                            phi_655_ = 38685626000000000000000000f;
                        } else {
                            phi_655_ = (1f / _e380);
                        }
                        let _e398 = phi_655_;
                        let _e401 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                        let _e404 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                        let _e406 = select(_e404, _e401, (_e401 > _e404));
                        let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                        if (_e228 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                            let _e414 = (_e247 / 3i);
                            let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                            let _e428 = bitcast<f32>((bitcast<u32>(((_e247 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                            let _e429 = (((_e212 * _e421) * _e421) * _e428);
                            let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                            let _e436 = (((_e222 * _e421) * _e421) * _e428);
                            let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                            phi_755_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                            phi_756_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_755_ = 0f;
                            phi_756_ = 1f;
                        }
                        let _e442 = phi_755_;
                        let _e444 = phi_756_;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e450 = global_5.member[_e128].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e453 = (_e266 % 3u);
                        let _e454 = (_e453 < 3u);
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e456 = local_1[_e453];
                        let _e459 = (_e265 % 3u);
                        let _e460 = (_e459 < 3u);
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e462 = local_1[_e459];
                        let _e465 = (_e267 % 3u);
                        let _e466 = (_e465 < 3u);
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e468 = local_1[_e465];
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e473 = local[_e453];
                        if _e460 {
                        } else {
                            break;
                        }
                        let _e477 = local[_e459];
                        if _e466 {
                        } else {
                            break;
                        }
                        let _e481 = local[_e465];
                        phi_3321_ = false;
                        phi_854_ = type_46(type_42(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e442), 0u, 0u);
                        phi_857_ = type_53(type_38(vec4<f32>((f32(_e456) * _e140), (f32(_e462) * _e140), (f32(_e468) * _e140), 0f), vec4<f32>((f32(_e473) * _e140), (f32(_e477) * _e140), (f32(_e481) * _e140), 0f)), select(0u, 2147483648u, (_e86 == 0u)));
                        phi_859_ = ((3u * _e86) + 1u);
                        phi_861_ = (_e444 <= _e442);
                        phi_863_ = 0u;
                        loop {
                            let _e491 = phi_3321_;
                            let _e493 = phi_854_;
                            let _e495 = phi_857_;
                            let _e497 = phi_859_;
                            let _e499 = phi_861_;
                            let _e501 = phi_863_;
                            local_10 = _e493;
                            local_11 = _e493;
                            if _e499 {
                                phi_874_ = true;
                            } else {
                                phi_874_ = (_e501 > 0u);
                            }
                            let _e504 = phi_874_;
                            if _e504 {
                                let _e505 = (_e497 > 0u);
                                if _e505 {
                                    if _e499 {
                                        phi_960_ = _e495;
                                        phi_961_ = _e499;
                                        phi_962_ = _e501;
                                    } else {
                                        let _e506 = (_e501 - 1u);
                                        let _e507 = (_e506 % 128u);
                                        let _e508 = (_e507 < 128u);
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e510 = local_7[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e512 = local_6[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e514 = local_5[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e516 = local_4[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e518 = local_3[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e520 = local_2[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e525 = local_8[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e528 = local_9[_e507];
                                        phi_960_ = type_53(type_38(vec4<f32>(_e510, _e512, _e514, 0f), vec4<f32>(_e516, _e518, _e520, 0f)), _e525);
                                        phi_961_ = (_e528 <= _e493.member.member_1);
                                        phi_962_ = _e506;
                                    }
                                    let _e533 = phi_960_;
                                    let _e535 = phi_961_;
                                    let _e537 = phi_962_;
                                    if _e535 {
                                        if ((_e533.member_1 & 2147483648u) != 0u) {
                                            phi_980_ = _e493;
                                            phi_983_ = type_7(0u, ((_e533.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e988 = phi_980_;
                                                let _e990 = phi_983_;
                                                local_12 = _e988;
                                                if (_e990.member < _e990.member_1) {
                                                    phi_984_ = type_7((_e990.member + 1u), _e990.member_1);
                                                    phi_1006_ = type_7(1u, _e990.member);
                                                } else {
                                                    phi_984_ = _e990;
                                                    phi_1006_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1003 = phi_984_;
                                                let _e1005 = phi_1006_;
                                                let _e1009 = (bitcast<i32>(_e1005.member) != 0i);
                                                if _e1009 {
                                                    let _e1015 = type_46(_e988.member, _e988.member_1, (_e988.member_2 + 1u));
                                                    let _e1016 = ((_e533.member_1 & 268435455u) + _e1005.member_1);
                                                    let _e1017 = (_e1016 < _e88);
                                                    if _e1017 {
                                                        if _e1017 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1021 = global_1.member[_e1016].member_1;
                                                        phi_1030_ = _e1021;
                                                    } else {
                                                        phi_1030_ = 4294967295u;
                                                    }
                                                    let _e1023 = phi_1030_;
                                                    if (_e1016 >= _e88) {
                                                        phi_1119_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1017 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        if (_e453 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1030 = global_1.member[_e1016].member[_e453];
                                                        if (_e459 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1036 = global_1.member[_e1016].member[_e459];
                                                        if (_e465 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1042 = global_1.member[_e1016].member[_e465];
                                                        let _e1044 = (3u + _e453);
                                                        if (_e1044 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1050 = global_1.member[_e1016].member[_e1044];
                                                        let _e1051 = (3u + _e459);
                                                        if (_e1051 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1057 = global_1.member[_e1016].member[_e1051];
                                                        let _e1058 = (3u + _e465);
                                                        if (_e1058 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1064 = global_1.member[_e1016].member[_e1058];
                                                        let _e1066 = (6u + _e453);
                                                        if (_e1066 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1072 = global_1.member[_e1016].member[_e1066];
                                                        let _e1073 = (6u + _e459);
                                                        if (_e1073 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1079 = global_1.member[_e1016].member[_e1073];
                                                        let _e1080 = (6u + _e465);
                                                        if (_e1080 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1086 = global_1.member[_e1016].member[_e1080];
                                                        phi_1119_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1030, _e1036, _e1042), array<f32, 3>(_e1050, _e1057, _e1064), array<f32, 3>(_e1072, _e1079, _e1086));
                                                    }
                                                    let _e1090 = phi_1119_;
                                                    let _e1099 = (_e1090[0][2] - _e371);
                                                    let _e1102 = (((_e1090[0][0] - _e298) * _e395) - (_e1099 * _e323));
                                                    let _e1105 = (((_e1090[0][1] - _e335) * _e395) - (_e1099 * _e359));
                                                    let _e1112 = (_e1090[1][2] - _e371);
                                                    let _e1115 = (((_e1090[1][0] - _e298) * _e395) - (_e1112 * _e323));
                                                    let _e1118 = (((_e1090[1][1] - _e335) * _e395) - (_e1112 * _e359));
                                                    let _e1125 = (_e1090[2][2] - _e371);
                                                    let _e1128 = (((_e1090[2][0] - _e298) * _e395) - (_e1125 * _e323));
                                                    let _e1131 = (((_e1090[2][1] - _e335) * _e395) - (_e1125 * _e359));
                                                    let _e1132 = (_e1128 * _e1118);
                                                    let _e1133 = (_e1131 * _e1115);
                                                    let _e1134 = (_e1102 * _e1131);
                                                    let _e1135 = (_e1105 * _e1128);
                                                    let _e1136 = (_e1115 * _e1105);
                                                    let _e1137 = (_e1118 * _e1102);
                                                    let _e1142 = (((_e1132 >= _e1133) && (_e1134 >= _e1135)) && (_e1136 >= _e1137));
                                                    if (_e1142 || (((_e1132 <= _e1133) && (_e1134 <= _e1135)) && (_e1136 <= _e1137))) {
                                                        let _e1149 = select(-1f, 1f, _e1142);
                                                        let _e1151 = ((_e1132 - _e1133) * _e1149);
                                                        let _e1153 = select(0f, _e1151, (_e1151 > 0f));
                                                        let _e1155 = ((_e1134 - _e1135) * _e1149);
                                                        let _e1157 = select(0f, _e1155, (_e1155 > 0f));
                                                        let _e1159 = ((_e1136 - _e1137) * _e1149);
                                                        let _e1161 = select(0f, _e1159, (_e1159 > 0f));
                                                        let _e1163 = ((_e1153 + _e1157) + _e1161);
                                                        if (_e1163 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1685_ = type_26();
                                                            phi_1686_ = true;
                                                        } else {
                                                            let _e1166 = select(_e1090[1][0], _e1090[0][0], (_e1090[0][0] < _e1090[1][0]));
                                                            let _e1170 = select(_e1090[1][0], _e1090[0][0], (_e1090[0][0] > _e1090[1][0]));
                                                            let _e1174 = select(_e1090[1][1], _e1090[0][1], (_e1090[0][1] < _e1090[1][1]));
                                                            let _e1178 = select(_e1090[1][1], _e1090[0][1], (_e1090[0][1] > _e1090[1][1]));
                                                            let _e1182 = select(_e1090[1][2], _e1090[0][2], (_e1090[0][2] < _e1090[1][2]));
                                                            let _e1186 = select(_e1090[1][2], _e1090[0][2], (_e1090[0][2] > _e1090[1][2]));
                                                            let _e1191 = ((select(_e1090[2][0], _e1166, (_e1166 < _e1090[2][0])) - _e321) * _e326);
                                                            let _e1192 = ((select(_e1090[2][0], _e1170, (_e1170 > _e1090[2][0])) - _e322) * _e326);
                                                            let _e1195 = ((select(_e1090[2][1], _e1174, (_e1174 < _e1090[2][1])) - _e357) * _e362);
                                                            let _e1196 = ((select(_e1090[2][1], _e1178, (_e1178 > _e1090[2][1])) - _e358) * _e362);
                                                            let _e1199 = ((select(_e1090[2][2], _e1182, (_e1182 < _e1090[2][2])) - _e393) * _e398);
                                                            let _e1200 = ((select(_e1090[2][2], _e1186, (_e1186 > _e1090[2][2])) - _e394) * _e398);
                                                            let _e1202 = select(_e1200, _e1199, (_e1199 < _e1200));
                                                            let _e1204 = select(_e1200, _e1199, (_e1199 > _e1200));
                                                            let _e1206 = select(_e1192, _e1191, (_e1191 < _e1192));
                                                            let _e1208 = select(_e1196, _e1195, (_e1195 < _e1196));
                                                            let _e1210 = select(_e1208, _e1206, (_e1206 > _e1208));
                                                            let _e1212 = select(_e1202, _e1210, (_e1210 > _e1202));
                                                            let _e1214 = select(_e1192, _e1191, (_e1191 > _e1192));
                                                            let _e1216 = select(_e1196, _e1195, (_e1195 > _e1196));
                                                            let _e1218 = select(_e1216, _e1214, (_e1214 < _e1216));
                                                            let _e1220 = select(_e1204, _e1218, (_e1218 < _e1204));
                                                            let _e1221 = -(_e1202);
                                                            let _e1227 = select(_e444, _e1212, (_e1212 > _e444));
                                                            if (_e1227 > (_e1220 + (select(_e1221, _e1204, (_e1204 > _e1221)) * 0.0000019073523f))) {
                                                                phi_1680_ = type_26();
                                                                phi_1681_ = true;
                                                            } else {
                                                                let _e1229 = (_e1227 > _e988.member.member_1);
                                                                if _e1229 {
                                                                    phi_1679_ = type_26();
                                                                } else {
                                                                    let _e1233 = (_e1090[1][0] - _e1090[0][0]);
                                                                    let _e1234 = (_e1090[1][1] - _e1090[0][1]);
                                                                    let _e1235 = (_e1090[1][2] - _e1090[0][2]);
                                                                    let _e1236 = vec3<f32>(_e1233, _e1234, _e1235);
                                                                    let _e1237 = (_e1090[2][0] - _e1090[1][0]);
                                                                    let _e1238 = (_e1090[2][1] - _e1090[1][1]);
                                                                    let _e1239 = (_e1090[2][2] - _e1090[1][2]);
                                                                    let _e1240 = vec3<f32>(_e1237, _e1238, _e1239);
                                                                    let _e1241 = (_e1090[0][0] - _e1090[2][0]);
                                                                    let _e1242 = (_e1090[0][1] - _e1090[2][1]);
                                                                    let _e1243 = (_e1090[0][2] - _e1090[2][2]);
                                                                    let _e1244 = vec3<f32>(_e1241, _e1242, _e1243);
                                                                    let _e1247 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                    let _e1250 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                                    let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                    let _e1255 = bitcast<f32>((bitcast<u32>(_e1235) & 2147483647u));
                                                                    let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                    let _e1260 = bitcast<f32>((bitcast<u32>(_e1237) & 2147483647u));
                                                                    let _e1263 = bitcast<f32>((bitcast<u32>(_e1238) & 2147483647u));
                                                                    let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                    let _e1268 = bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u));
                                                                    let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                    let _e1273 = bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u));
                                                                    let _e1276 = bitcast<f32>((bitcast<u32>(_e1242) & 2147483647u));
                                                                    let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                                    let _e1281 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                                    let _e1283 = select(_e1281, _e1278, (_e1278 > _e1281));
                                                                    let _e1285 = select(_e1270, _e1257, (_e1257 > _e1270));
                                                                    let _e1287 = select(_e1283, _e1285, (_e1285 > _e1283));
                                                                    if (_e1257 == _e1287) {
                                                                        phi_1590_ = _e1240;
                                                                        phi_1591_ = _e1244;
                                                                    } else {
                                                                        let _e1290 = vec3((_e1270 == _e1287));
                                                                        phi_1590_ = select(_e1236, _e1244, _e1290);
                                                                        phi_1591_ = select(_e1240, _e1236, _e1290);
                                                                    }
                                                                    let _e1294 = phi_1590_;
                                                                    let _e1296 = phi_1591_;
                                                                    let _e1303 = ((_e1294.y * _e1296.z) - (_e1296.y * _e1294.z));
                                                                    let _e1308 = ((_e1294.z * _e1296.x) - (_e1296.z * _e1294.x));
                                                                    let _e1311 = ((_e1294.x * _e1296.y) - (_e1296.x * _e1294.y));
                                                                    if (_e1153 >= _e1157) {
                                                                        phi_1622_ = select(true, false, (_e1153 >= _e1161));
                                                                    } else {
                                                                        phi_1622_ = true;
                                                                    }
                                                                    let _e1316 = phi_1622_;
                                                                    if _e1316 {
                                                                        phi_1631_ = select(vec3<f32>(_e1090[2][0], _e1090[2][1], _e1090[2][2]), vec3<f32>(_e1090[1][0], _e1090[1][1], _e1090[1][2]), vec3((_e1157 >= _e1161)));
                                                                    } else {
                                                                        phi_1631_ = vec3<f32>(_e1090[0][0], _e1090[0][1], _e1090[0][2]);
                                                                    }
                                                                    let _e1321 = phi_1631_;
                                                                    let _e1338 = ((((_e1303 * (_e1321.x - _e298)) + (_e1308 * (_e1321.y - _e335))) + (_e1311 * (_e1321.z - _e371))) / (((_e1303 * _e323) + (_e1308 * _e359)) + (_e1311 * _e395)));
                                                                    let _e1340 = select(_e1220, _e1338, (_e1338 < _e1220));
                                                                    let _e1342 = select(_e1212, _e1340, (_e1340 > _e1212));
                                                                    if (_e1342 >= _e444) {
                                                                        let _e1344 = (_e1342 <= _e988.member.member_1);
                                                                        if _e1344 {
                                                                            let _e1345 = (1f / _e1163);
                                                                            phi_1671_ = type_26(_e1342, (_e1157 * _e1345), (_e1161 * _e1345), _e1023);
                                                                        } else {
                                                                            phi_1671_ = type_26();
                                                                        }
                                                                        let _e1350 = phi_1671_;
                                                                        phi_1673_ = _e1350;
                                                                        phi_1674_ = select(true, false, _e1344);
                                                                    } else {
                                                                        phi_1673_ = type_26();
                                                                        phi_1674_ = true;
                                                                    }
                                                                    let _e1353 = phi_1673_;
                                                                    let _e1355 = phi_1674_;
                                                                    if _e1355 {
                                                                        phi_1678_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1678_ = _e1353;
                                                                    }
                                                                    let _e1357 = phi_1678_;
                                                                    phi_1679_ = _e1357;
                                                                }
                                                                let _e1359 = phi_1679_;
                                                                phi_1680_ = _e1359;
                                                                phi_1681_ = _e1229;
                                                            }
                                                            let _e1361 = phi_1680_;
                                                            let _e1363 = phi_1681_;
                                                            phi_1685_ = _e1361;
                                                            phi_1686_ = _e1363;
                                                        }
                                                        let _e1365 = phi_1685_;
                                                        let _e1367 = phi_1686_;
                                                        phi_1690_ = _e1365;
                                                        phi_1691_ = _e1367;
                                                    } else {
                                                        phi_1690_ = type_26();
                                                        phi_1691_ = true;
                                                    }
                                                    let _e1369 = phi_1690_;
                                                    let _e1371 = phi_1691_;
                                                    if _e1371 {
                                                        phi_1695_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1695_ = _e1369;
                                                    }
                                                    let _e1373 = phi_1695_;
                                                    if (_e1373.member_3 != 4294967295u) {
                                                        if (_e1023 != _e450) {
                                                            if (_e1373.member < _e988.member.member.member) {
                                                                phi_1721_ = true;
                                                            } else {
                                                                if (_e1373.member == _e988.member.member.member) {
                                                                    phi_1720_ = (_e1373.member_3 < _e988.member.member.member_3);
                                                                } else {
                                                                    phi_1720_ = false;
                                                                }
                                                                let _e1388 = phi_1720_;
                                                                phi_1721_ = _e1388;
                                                            }
                                                            let _e1390 = phi_1721_;
                                                            if _e1390 {
                                                                phi_1728_ = type_46(type_42(_e1373, _e1373.member), _e1015.member_1, _e1015.member_2);
                                                            } else {
                                                                phi_1728_ = _e1015;
                                                            }
                                                            let _e1397 = phi_1728_;
                                                            phi_1729_ = _e1397;
                                                        } else {
                                                            phi_1729_ = _e1015;
                                                        }
                                                        let _e1399 = phi_1729_;
                                                        phi_1730_ = _e1399;
                                                    } else {
                                                        phi_1730_ = _e1015;
                                                    }
                                                    let _e1401 = phi_1730_;
                                                    phi_981_ = _e1401;
                                                } else {
                                                    phi_981_ = type_46();
                                                }
                                                let _e1403 = phi_981_;
                                                continue;
                                                continuing {
                                                    phi_980_ = _e1403;
                                                    phi_983_ = _e1003;
                                                    phi_3315_ = _e491;
                                                    break if !(_e1009);
                                                }
                                            }
                                            let _e1406 = phi_3315_;
                                            phi_3429_ = _e1406;
                                            if _e1406 {
                                                break;
                                            }
                                            phi_3433_ = _e1406;
                                            let _e1623 = local_12;
                                            phi_2938_ = _e1623;
                                            phi_2939_ = _e533;
                                            phi_2940_ = false;
                                            phi_2941_ = _e537;
                                        } else {
                                            if (_e533.member_1 >= _e86) {
                                                phi_2494_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e533.member_1 < _e86) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e555 = ((1u + _e266) % 4u);
                                                if (_e555 < 4u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e560 = global_4.member[_e533.member_1][_e555];
                                                let _e562 = (_e560 >> bitcast<u32>(11u));
                                                let _e564 = ((1u + _e265) % 4u);
                                                if (_e564 < 4u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e569 = global_4.member[_e533.member_1][_e564];
                                                let _e571 = (_e569 >> bitcast<u32>(11u));
                                                let _e573 = ((1u + _e267) % 4u);
                                                if (_e573 < 4u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e578 = global_4.member[_e533.member_1][_e573];
                                                let _e580 = (_e578 >> bitcast<u32>(11u));
                                                let _e603 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.x - _e533.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e604 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.y - _e533.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e605 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.z - _e533.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e607 = select(_e140, _e603, (_e603 > _e140));
                                                let _e609 = select(_e140, _e604, (_e604 > _e140));
                                                let _e611 = select(_e140, _e605, (_e605 > _e140));
                                                let _e636 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e607));
                                                let _e641 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e644 = bitcast<f32>((_e636 & bitcast<u32>(_e641)));
                                                let _e645 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e609));
                                                let _e650 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                                let _e654 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e611));
                                                let _e659 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                                let _e666 = bitcast<f32>((_e636 & bitcast<u32>(~(_e641))));
                                                let _e670 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                                let _e674 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                                let _e675 = bitcast<u32>((f32(bitcast<i32>((_e562 & 1023u))) * _e607));
                                                let _e680 = (bitcast<i32>((_e562 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                                let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e609));
                                                let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                                let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e611));
                                                let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                                let _e705 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                                let _e709 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                                let _e713 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                                let _e743 = global_4.member[_e533.member_1][0u];
                                                let _e747 = global_4.member[_e533.member_1][1u];
                                                let _e751 = global_4.member[_e533.member_1][2u];
                                                let _e755 = global_4.member[_e533.member_1][3u];
                                                let _e767 = (((_e747 >> bitcast<u32>(22i)) | ((_e751 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e755 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e768 = (_e743 & 268435455u);
                                                let _e769 = (_e767 & 268435455u);
                                                let _e772 = ((_e743 >> bitcast<u32>(28u)) & 7u);
                                                let _e780 = ((_e743 >> bitcast<u32>(31i)) | (((_e767 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e781 = (_e772 != 0u);
                                                if (_e772 == 0u) {
                                                    phi_2456_ = _e768;
                                                } else {
                                                    if (_e772 == 7u) {
                                                        phi_2455_ = 2147483648u;
                                                    } else {
                                                        phi_2455_ = ((2147483648u | (_e772 << bitcast<u32>(28u))) | (_e769 & 268435455u));
                                                    }
                                                    let _e790 = phi_2455_;
                                                    phi_2456_ = _e790;
                                                }
                                                let _e792 = phi_2456_;
                                                if _e781 {
                                                    let _e793 = (_e772 != 7u);
                                                    if _e793 {
                                                        phi_2466_ = (_e769 + _e772);
                                                    } else {
                                                        phi_2466_ = u32();
                                                    }
                                                    let _e796 = phi_2466_;
                                                    phi_2468_ = _e796;
                                                    phi_2469_ = select(true, false, _e793);
                                                } else {
                                                    phi_2468_ = u32();
                                                    phi_2469_ = true;
                                                }
                                                let _e799 = phi_2468_;
                                                let _e801 = phi_2469_;
                                                if (_e780 == 0u) {
                                                    phi_2490_ = (_e768 + select(0u, 1u, !(_e781)));
                                                } else {
                                                    if (_e780 == 7u) {
                                                        phi_2489_ = 2147483648u;
                                                    } else {
                                                        phi_2489_ = ((2147483648u | (_e780 << bitcast<u32>(28u))) | (select(_e799, _e769, _e801) & 268435455u));
                                                    }
                                                    let _e814 = phi_2489_;
                                                    phi_2490_ = _e814;
                                                }
                                                let _e816 = phi_2490_;
                                                phi_2494_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e533.member.member.x + _e644), (_e533.member.member.x + _e666), (_e533.member.member_1.x - _e683), (_e533.member.member_1.x - _e705)), vec4<f32>((_e533.member.member.y + _e653), (_e533.member.member.y + _e670), (_e533.member.member_1.y - _e692), (_e533.member.member_1.y - _e709)), vec4<f32>((_e533.member.member.z + _e662), (_e533.member.member.z + _e674), (_e533.member.member_1.z - _e701), (_e533.member.member_1.z - _e713))), type_53(type_38((_e533.member.member + vec4<f32>(_e644, _e653, _e662, 0f)), (_e533.member.member_1 - vec4<f32>(_e683, _e692, _e701, 0f))), _e792), type_53(type_38((_e533.member.member + vec4<f32>(_e666, _e670, _e674, 0f)), (_e533.member.member_1 - vec4<f32>(_e705, _e709, _e713, 0f))), _e816));
                                            }
                                            let _e821 = phi_2494_;
                                            let _e834 = ((_e821.member[0].x - _e321) * _e326);
                                            let _e835 = ((_e821.member[0].y - _e321) * _e326);
                                            let _e836 = ((_e821.member[0].z - _e322) * _e326);
                                            let _e837 = ((_e821.member[0].w - _e322) * _e326);
                                            let _e847 = ((_e821.member[1].x - _e357) * _e362);
                                            let _e848 = ((_e821.member[1].y - _e357) * _e362);
                                            let _e849 = ((_e821.member[1].z - _e358) * _e362);
                                            let _e850 = ((_e821.member[1].w - _e358) * _e362);
                                            let _e860 = ((_e821.member[2].x - _e393) * _e398);
                                            let _e861 = ((_e821.member[2].y - _e393) * _e398);
                                            let _e862 = ((_e821.member[2].z - _e394) * _e398);
                                            let _e863 = ((_e821.member[2].w - _e394) * _e398);
                                            let _e865 = select(_e862, _e860, (_e860 < _e862));
                                            let _e867 = select(_e863, _e861, (_e861 < _e863));
                                            let _e869 = select(_e862, _e860, (_e860 > _e862));
                                            let _e871 = select(_e863, _e861, (_e861 > _e863));
                                            let _e873 = select(_e836, _e834, (_e834 < _e836));
                                            let _e875 = select(_e837, _e835, (_e835 < _e837));
                                            let _e877 = select(_e849, _e847, (_e847 < _e849));
                                            let _e879 = select(_e850, _e848, (_e848 < _e850));
                                            let _e881 = select(_e877, _e873, (_e873 > _e877));
                                            let _e883 = select(_e879, _e875, (_e875 > _e879));
                                            let _e885 = select(_e865, _e881, (_e881 > _e865));
                                            let _e887 = select(_e867, _e883, (_e883 > _e867));
                                            let _e889 = select(_e836, _e834, (_e834 > _e836));
                                            let _e891 = select(_e837, _e835, (_e835 > _e837));
                                            let _e893 = select(_e849, _e847, (_e847 > _e849));
                                            let _e895 = select(_e850, _e848, (_e848 > _e850));
                                            let _e897 = select(_e893, _e889, (_e889 < _e893));
                                            let _e899 = select(_e895, _e891, (_e891 < _e895));
                                            let _e904 = -(_e865);
                                            let _e905 = -(_e867);
                                            let _e912 = (select(_e869, _e897, (_e897 < _e869)) + (select(_e904, _e869, (_e869 > _e904)) * 0.0000019073523f));
                                            let _e913 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e905, _e871, (_e871 > _e905)) * 0.0000019073523f));
                                            let _e915 = select(_e444, _e885, (_e885 > _e444));
                                            let _e917 = select(_e444, _e887, (_e887 > _e444));
                                            let _e922 = (_e915 <= select(_e493.member.member_1, _e912, (_e912 < _e493.member.member_1)));
                                            let _e923 = (_e917 <= select(_e493.member.member_1, _e913, (_e913 < _e493.member.member_1)));
                                            let _e924 = (_e915 <= _e917);
                                            if _e922 {
                                                if _e923 {
                                                    if _e924 {
                                                        phi_2838_ = _e821.member_2;
                                                    } else {
                                                        phi_2838_ = _e821.member_1;
                                                    }
                                                    let _e928 = phi_2838_;
                                                    let _e950 = (_e537 % 128u);
                                                    let _e951 = (_e950 < 128u);
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_8[_e950] = _e928.member_1;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_7[_e950] = _e928.member.member.x;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_6[_e950] = _e928.member.member.y;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_5[_e950] = _e928.member.member.z;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_4[_e950] = _e928.member.member_1.x;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_3[_e950] = _e928.member.member_1.y;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_2[_e950] = _e928.member.member_1.z;
                                                    if _e951 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_9[_e950] = select(_e917, _e915, (_e915 > _e917));
                                                    if _e924 {
                                                        phi_2915_ = _e821.member_1;
                                                    } else {
                                                        phi_2915_ = _e821.member_2;
                                                    }
                                                    let _e964 = phi_2915_;
                                                    phi_2916_ = _e964;
                                                    phi_2917_ = (_e537 + 1u);
                                                } else {
                                                    phi_2916_ = type_53();
                                                    phi_2917_ = u32();
                                                }
                                                let _e966 = phi_2916_;
                                                let _e968 = phi_2917_;
                                                phi_2919_ = _e966;
                                                phi_2920_ = _e968;
                                                phi_2921_ = select(true, false, _e923);
                                            } else {
                                                phi_2919_ = type_53();
                                                phi_2920_ = u32();
                                                phi_2921_ = true;
                                            }
                                            let _e971 = phi_2919_;
                                            let _e973 = phi_2920_;
                                            let _e975 = phi_2921_;
                                            if _e975 {
                                                if _e922 {
                                                    phi_2930_ = _e821.member_1;
                                                } else {
                                                    phi_2930_ = _e821.member_2;
                                                }
                                                let _e979 = phi_2930_;
                                                phi_2935_ = _e979;
                                                phi_2936_ = select(_e923, true, _e922);
                                            } else {
                                                phi_2935_ = _e971;
                                                phi_2936_ = _e535;
                                            }
                                            let _e982 = phi_2935_;
                                            let _e984 = phi_2936_;
                                            phi_3433_ = _e491;
                                            phi_2938_ = type_46(_e493.member, (_e493.member_1 + 1u), _e493.member_2);
                                            phi_2939_ = _e982;
                                            phi_2940_ = _e984;
                                            phi_2941_ = select(_e973, _e537, _e975);
                                        }
                                        let _e1408 = phi_3433_;
                                        let _e1410 = phi_2938_;
                                        let _e1412 = phi_2939_;
                                        let _e1414 = phi_2940_;
                                        let _e1416 = phi_2941_;
                                        phi_3432_ = _e1408;
                                        phi_2942_ = _e1410;
                                        phi_2943_ = _e1412;
                                        phi_2944_ = (_e497 - 1u);
                                        phi_2945_ = _e1414;
                                        phi_2946_ = _e1416;
                                    } else {
                                        phi_3432_ = _e491;
                                        phi_2942_ = _e493;
                                        phi_2943_ = _e533;
                                        phi_2944_ = _e497;
                                        phi_2945_ = _e535;
                                        phi_2946_ = _e537;
                                    }
                                    let _e1418 = phi_3432_;
                                    let _e1420 = phi_2942_;
                                    let _e1422 = phi_2943_;
                                    let _e1424 = phi_2944_;
                                    let _e1426 = phi_2945_;
                                    let _e1428 = phi_2946_;
                                    phi_3431_ = _e1418;
                                    phi_2947_ = _e1420;
                                    phi_2948_ = _e1422;
                                    phi_2949_ = _e1424;
                                    phi_2950_ = _e1426;
                                    phi_2951_ = _e1428;
                                } else {
                                    phi_3431_ = _e491;
                                    phi_2947_ = type_46();
                                    phi_2948_ = type_53();
                                    phi_2949_ = u32();
                                    phi_2950_ = bool();
                                    phi_2951_ = u32();
                                }
                                let _e1430 = phi_3431_;
                                let _e1432 = phi_2947_;
                                let _e1434 = phi_2948_;
                                let _e1436 = phi_2949_;
                                let _e1438 = phi_2950_;
                                let _e1440 = phi_2951_;
                                phi_3430_ = _e1430;
                                phi_855_ = _e1432;
                                phi_858_ = _e1434;
                                phi_860_ = _e1436;
                                phi_862_ = _e1438;
                                phi_864_ = _e1440;
                                phi_2952_ = _e505;
                            } else {
                                phi_3430_ = _e491;
                                phi_855_ = type_46();
                                phi_858_ = type_53();
                                phi_860_ = u32();
                                phi_862_ = bool();
                                phi_864_ = u32();
                                phi_2952_ = false;
                            }
                            let _e1442 = phi_3430_;
                            let _e1444 = phi_855_;
                            let _e1446 = phi_858_;
                            let _e1448 = phi_860_;
                            let _e1450 = phi_862_;
                            let _e1452 = phi_864_;
                            let _e1454 = phi_2952_;
                            continue;
                            continuing {
                                phi_3321_ = _e1442;
                                phi_854_ = _e1444;
                                phi_857_ = _e1446;
                                phi_859_ = _e1448;
                                phi_861_ = _e1450;
                                phi_863_ = _e1452;
                                phi_3429_ = _e1442;
                                break if !(_e1454);
                            }
                        }
                        let _e1457 = phi_3429_;
                        if _e1457 {
                            break;
                        }
                        let _e1459 = local_10;
                        if (_e1459.member.member.member_3 != 4294967295u) {
                            let _e1465 = (_e268 / 3i);
                            let _e1472 = bitcast<f32>((bitcast<u32>((_e1465 + 127i)) << bitcast<u32>(23i)));
                            let _e1480 = (((_e1459.member.member.member * _e1472) * _e1472) * bitcast<f32>((bitcast<u32>(((_e268 - (2i * _e1465)) + 127i)) << bitcast<u32>(23i))));
                            let _e1482 = select(340282350000000000000000000000000000000f, _e1480, (_e1480 < 340282350000000000000000000000000000000f));
                            phi_3004_ = type_26(select(-340282350000000000000000000000000000000f, _e1482, (_e1482 > -340282350000000000000000000000000000000f)), _e1459.member.member.member_1, _e1459.member.member.member_2, _e1459.member.member.member_3);
                        } else {
                            phi_3004_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1489 = phi_3004_;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_2.member[_e128] = _e1489;
                        let _e1493 = local_11;
                        if _e145 {
                        } else {
                            break;
                        }
                        global_6.member[_e128] = _e1493.member_1;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e1498 = select(0u, 1u, (_e212 <= _e222));
                        if (_e1498 > 0u) {
                            let _e1500 = (1u < _e96);
                            if _e1500 {
                                if (0u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1504 = atomicAdd((&global_7.member[0u]), _e1498);
                                if ((_e1504 + _e1498) < _e1504) {
                                    if _e1500 {
                                    } else {
                                        break;
                                    }
                                    let _e1509 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1512 = select(0u, 1u, (_e1489.member_3 != 4294967295u));
                        if (_e1512 > 0u) {
                            let _e1514 = (3u < _e96);
                            if _e1514 {
                                if (2u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1518 = atomicAdd((&global_7.member[2u]), _e1512);
                                if ((_e1518 + _e1512) < _e1518) {
                                    if _e1514 {
                                    } else {
                                        break;
                                    }
                                    let _e1523 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1493.member_1 > 0u) {
                            let _e1525 = (5u < _e96);
                            if _e1525 {
                                if (4u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1529 = atomicAdd((&global_7.member[4u]), _e1493.member_1);
                                if ((_e1529 + _e1493.member_1) < _e1529) {
                                    if _e1525 {
                                    } else {
                                        break;
                                    }
                                    let _e1534 = atomicAdd((&global_7.member[5u]), 1u);
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
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
