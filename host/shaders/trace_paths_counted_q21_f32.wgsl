struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
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

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
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

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_44;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_48;

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
    var phi_854_: type_42;
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
    var phi_980_: type_42;
    var phi_983_: type_7;
    var phi_984_: type_7;
    var phi_1006_: type_7;
    var phi_1030_: u32;
    var phi_1119_: array<array<f32, 3>, 3>;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1622_: bool;
    var phi_1631_: vec3<f32>;
    var phi_1671_: type_22;
    var phi_1673_: type_22;
    var phi_1674_: bool;
    var phi_1678_: type_22;
    var phi_1679_: type_22;
    var phi_1680_: type_22;
    var phi_1681_: bool;
    var phi_1685_: type_22;
    var phi_1686_: bool;
    var phi_1690_: type_22;
    var phi_1691_: bool;
    var phi_1695_: type_22;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1728_: type_42;
    var phi_1729_: type_42;
    var phi_1730_: type_42;
    var phi_981_: type_42;
    var phi_3315_: bool;
    var phi_3433_: bool;
    var phi_2938_: type_42;
    var phi_2939_: type_53;
    var phi_2940_: bool;
    var phi_2941_: u32;
    var phi_3432_: bool;
    var phi_2942_: type_42;
    var phi_2943_: type_53;
    var phi_2944_: u32;
    var phi_2945_: bool;
    var phi_2946_: u32;
    var phi_3431_: bool;
    var phi_2947_: type_42;
    var phi_2948_: type_53;
    var phi_2949_: u32;
    var phi_2950_: bool;
    var phi_2951_: u32;
    var phi_3430_: bool;
    var phi_855_: type_42;
    var phi_858_: type_53;
    var phi_860_: u32;
    var phi_862_: bool;
    var phi_864_: u32;
    var phi_2952_: bool;
    var phi_3429_: bool;
    var local_10: type_42;
    var phi_3004_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e85 = arrayLength((&global_7.member));
            let _e87 = arrayLength((&global_1.member));
            let _e95 = arrayLength((&global_6.member));
            let _e99 = global_3.member[0u][0u];
            let _e103 = global_3.member[0u][1u];
            let _e107 = global_3.member[0u][2u];
            let _e111 = global_3.member[0u][3u];
            let _e115 = global_3.member[1u][0u];
            let _e119 = global_3.member[1u][1u];
            let _e123 = global_3.member[1u][2u];
            let _e127 = (_e83.x + (_e83.y * 2097152u));
            let _e139 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e111) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e99), bitcast<i32>(_e103), bitcast<i32>(_e107));
            local = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            let _e142 = (_e127 < arrayLength((&global_4.member)));
            if _e142 {
                let _e143 = (_e127 < arrayLength((&global_2.member)));
                if _e143 {
                    let _e144 = (_e127 < arrayLength((&global_5.member)));
                    if _e144 {
                        if _e142 {
                        } else {
                            break;
                        }
                        let _e154 = global_4.member[_e127].member.member_2[0u];
                        let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                        let _e162 = global_4.member[_e127].member.member_2[1u];
                        let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                        let _e170 = global_4.member[_e127].member.member_2[2u];
                        let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                        let _e178 = global_4.member[_e127].member.member[0u];
                        let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                        let _e186 = global_4.member[_e127].member.member[1u];
                        let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                        let _e194 = global_4.member[_e127].member.member[2u];
                        let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                        let _e198 = select(_e164, _e156, (_e164 < _e156));
                        let _e200 = select(_e172, _e198, (_e172 < _e198));
                        let _e202 = select(_e180, _e200, (_e180 < _e200));
                        let _e204 = select(_e188, _e202, (_e188 < _e202));
                        let _e206 = select(_e196, _e204, (_e196 < _e204));
                        let _e211 = global_4.member[_e127].member.member_1;
                        let _e213 = (bitcast<u32>(_e211) & 2147483647u);
                        let _e221 = global_4.member[_e127].member.member_3;
                        let _e227 = (((select(_e213, _e206, (_e213 < _e206)) < 2139095040u) && ((bitcast<u32>(_e221) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                        if _e227 {
                            let _e230 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                            if (_e230 >= 8388608u) {
                                phi_387_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                            }
                            let _e244 = phi_387_;
                            phi_388_ = _e244;
                        } else {
                            phi_388_ = 0i;
                        }
                        let _e246 = phi_388_;
                        let _e247 = (_e156 == _e200);
                        if _e247 {
                            phi_398_ = true;
                        } else {
                            phi_398_ = (_e164 == _e200);
                        }
                        let _e250 = phi_398_;
                        let _e251 = select(1u, 0u, _e247);
                        if _e250 {
                            let _e252 = (_e251 + 1u);
                            phi_408_ = _e252;
                            phi_409_ = _e252;
                            phi_411_ = select(true, false, (_e252 == 2u));
                        } else {
                            phi_408_ = u32();
                            phi_409_ = 0u;
                            phi_411_ = true;
                        }
                        let _e256 = phi_408_;
                        let _e258 = phi_409_;
                        let _e260 = phi_411_;
                        if _e260 {
                            phi_416_ = (_e258 + 1u);
                        } else {
                            phi_416_ = 0u;
                        }
                        let _e264 = phi_416_;
                        let _e265 = select(_e256, _e258, _e260);
                        let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                        let _e267 = -(_e246);
                        if (_e267 < -126i) {
                            phi_448_ = -126i;
                        } else {
                            phi_448_ = select(_e267, 127i, (_e267 > 127i));
                        }
                        let _e272 = phi_448_;
                        let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                        let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                        let _e288 = global_4.member[_e127].member.member;
                        let _e289 = (_e265 == 0u);
                        if _e289 {
                            phi_466_ = _e288[0];
                        } else {
                            phi_466_ = _e288[1];
                        }
                        let _e293 = phi_466_;
                        let _e294 = (_e265 == 2u);
                        if _e294 {
                            phi_472_ = _e288[2];
                        } else {
                            phi_472_ = _e293;
                        }
                        let _e297 = phi_472_;
                        let _e298 = global_4.member[_e127].member.member_2;
                        if _e289 {
                            phi_483_ = _e298[0];
                        } else {
                            phi_483_ = _e298[1];
                        }
                        let _e302 = phi_483_;
                        if _e294 {
                            phi_489_ = _e298[2];
                        } else {
                            phi_489_ = _e302;
                        }
                        let _e305 = phi_489_;
                        let _e307 = ((_e305 * _e277) * _e283);
                        let _e311 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e311 {
                            let _e315 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) * 0.00000011920929f);
                            phi_512_ = select(0.00000000000011368684f, _e315, (_e315 > 0.00000000000011368684f));
                        } else {
                            phi_512_ = 0f;
                        }
                        let _e319 = phi_512_;
                        let _e320 = (_e297 + _e319);
                        let _e321 = (_e297 - _e319);
                        let _e322 = select(_e307, 0f, _e311);
                        if _e311 {
                            phi_523_ = 38685626000000000000000000f;
                        } else {
                            phi_523_ = (1f / _e307);
                        }
                        let _e325 = phi_523_;
                        let _e326 = (_e264 == 0u);
                        if _e326 {
                            phi_532_ = _e288[0];
                        } else {
                            phi_532_ = _e288[1];
                        }
                        let _e330 = phi_532_;
                        let _e331 = (_e264 == 2u);
                        if _e331 {
                            phi_538_ = _e288[2];
                        } else {
                            phi_538_ = _e330;
                        }
                        let _e334 = phi_538_;
                        if _e326 {
                            phi_549_ = _e298[0];
                        } else {
                            phi_549_ = _e298[1];
                        }
                        let _e338 = phi_549_;
                        if _e331 {
                            phi_555_ = _e298[2];
                        } else {
                            phi_555_ = _e338;
                        }
                        let _e341 = phi_555_;
                        let _e343 = ((_e341 * _e277) * _e283);
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e347 {
                            let _e351 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) * 0.00000011920929f);
                            phi_578_ = select(0.00000000000011368684f, _e351, (_e351 > 0.00000000000011368684f));
                        } else {
                            phi_578_ = 0f;
                        }
                        let _e355 = phi_578_;
                        let _e356 = (_e334 + _e355);
                        let _e357 = (_e334 - _e355);
                        let _e358 = select(_e343, 0f, _e347);
                        if _e347 {
                            phi_589_ = 38685626000000000000000000f;
                        } else {
                            phi_589_ = (1f / _e343);
                        }
                        let _e361 = phi_589_;
                        let _e362 = (_e266 == 0u);
                        if _e362 {
                            phi_598_ = _e288[0];
                        } else {
                            phi_598_ = _e288[1];
                        }
                        let _e366 = phi_598_;
                        let _e367 = (_e266 == 2u);
                        if _e367 {
                            phi_604_ = _e288[2];
                        } else {
                            phi_604_ = _e366;
                        }
                        let _e370 = phi_604_;
                        if _e362 {
                            phi_615_ = _e298[0];
                        } else {
                            phi_615_ = _e298[1];
                        }
                        let _e374 = phi_615_;
                        if _e367 {
                            phi_621_ = _e298[2];
                        } else {
                            phi_621_ = _e374;
                        }
                        let _e377 = phi_621_;
                        let _e379 = ((_e377 * _e277) * _e283);
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e383 {
                            let _e387 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                            phi_644_ = select(0.00000000000011368684f, _e387, (_e387 > 0.00000000000011368684f));
                        } else {
                            phi_644_ = 0f;
                        }
                        let _e391 = phi_644_;
                        let _e392 = (_e370 + _e391);
                        let _e393 = (_e370 - _e391);
                        let _e394 = select(_e379, 0f, _e383);
                        if _e383 {
                            phi_655_ = 38685626000000000000000000f;
                        } else {
                            phi_655_ = (1f / _e379);
                        }
                        let _e397 = phi_655_;
                        let _e400 = bitcast<f32>((bitcast<u32>(_e297) & 2147483647u));
                        let _e403 = bitcast<f32>((bitcast<u32>(_e334) & 2147483647u));
                        let _e405 = select(_e403, _e400, (_e400 > _e403));
                        let _e408 = bitcast<f32>((bitcast<u32>(_e370) & 2147483647u));
                        if (_e227 && (select(_e408, _e405, (_e405 > _e408)) <= 1099511600000f)) {
                            let _e413 = (_e246 / 3i);
                            let _e420 = bitcast<f32>((bitcast<u32>((_e413 + 127i)) << bitcast<u32>(23i)));
                            let _e427 = bitcast<f32>((bitcast<u32>(((_e246 - (2i * _e413)) + 127i)) << bitcast<u32>(23i)));
                            let _e428 = (((_e211 * _e420) * _e420) * _e427);
                            let _e430 = select(340282350000000000000000000000000000000f, _e428, (_e428 < 340282350000000000000000000000000000000f));
                            let _e435 = (((_e221 * _e420) * _e420) * _e427);
                            let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                            phi_755_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                            phi_756_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_755_ = 0f;
                            phi_756_ = 1f;
                        }
                        let _e441 = phi_755_;
                        let _e443 = phi_756_;
                        if _e142 {
                        } else {
                            break;
                        }
                        let _e449 = global_4.member[_e127].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e452 = (_e265 % 3u);
                        let _e453 = (_e452 < 3u);
                        if _e453 {
                        } else {
                            break;
                        }
                        let _e455 = local_1[_e452];
                        let _e458 = (_e264 % 3u);
                        let _e459 = (_e458 < 3u);
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e461 = local_1[_e458];
                        let _e464 = (_e266 % 3u);
                        let _e465 = (_e464 < 3u);
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e467 = local_1[_e464];
                        if _e453 {
                        } else {
                            break;
                        }
                        let _e472 = local[_e452];
                        if _e459 {
                        } else {
                            break;
                        }
                        let _e476 = local[_e458];
                        if _e465 {
                        } else {
                            break;
                        }
                        let _e480 = local[_e464];
                        phi_3321_ = false;
                        phi_854_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e441), 0u, 0u);
                        phi_857_ = type_53(type_34(vec4<f32>((f32(_e455) * _e139), (f32(_e461) * _e139), (f32(_e467) * _e139), 0f), vec4<f32>((f32(_e472) * _e139), (f32(_e476) * _e139), (f32(_e480) * _e139), 0f)), select(0u, 2147483648u, (_e85 == 0u)));
                        phi_859_ = ((3u * _e85) + 1u);
                        phi_861_ = (_e443 <= _e441);
                        phi_863_ = 0u;
                        loop {
                            let _e490 = phi_3321_;
                            let _e492 = phi_854_;
                            let _e494 = phi_857_;
                            let _e496 = phi_859_;
                            let _e498 = phi_861_;
                            let _e500 = phi_863_;
                            local_10 = _e492;
                            local_11 = _e492;
                            if _e498 {
                                phi_874_ = true;
                            } else {
                                phi_874_ = (_e500 > 0u);
                            }
                            let _e503 = phi_874_;
                            if _e503 {
                                let _e504 = (_e496 > 0u);
                                if _e504 {
                                    if _e498 {
                                        phi_960_ = _e494;
                                        phi_961_ = _e498;
                                        phi_962_ = _e500;
                                    } else {
                                        let _e505 = (_e500 - 1u);
                                        let _e506 = (_e505 % 128u);
                                        let _e507 = (_e506 < 128u);
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e509 = local_7[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e511 = local_6[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e513 = local_5[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e515 = local_4[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e517 = local_3[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e519 = local_2[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e524 = local_8[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3429_ = true;
                                            break;
                                        }
                                        let _e527 = local_9[_e506];
                                        phi_960_ = type_53(type_34(vec4<f32>(_e509, _e511, _e513, 0f), vec4<f32>(_e515, _e517, _e519, 0f)), _e524);
                                        phi_961_ = (_e527 <= _e492.member.member_1);
                                        phi_962_ = _e505;
                                    }
                                    let _e532 = phi_960_;
                                    let _e534 = phi_961_;
                                    let _e536 = phi_962_;
                                    if _e534 {
                                        if ((_e532.member_1 & 2147483648u) != 0u) {
                                            phi_980_ = _e492;
                                            phi_983_ = type_7(0u, ((_e532.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1005 = phi_980_;
                                                let _e1007 = phi_983_;
                                                local_12 = _e1005;
                                                if (_e1007.member < _e1007.member_1) {
                                                    phi_984_ = type_7((_e1007.member + 1u), _e1007.member_1);
                                                    phi_1006_ = type_7(1u, _e1007.member);
                                                } else {
                                                    phi_984_ = _e1007;
                                                    phi_1006_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1020 = phi_984_;
                                                let _e1022 = phi_1006_;
                                                let _e1026 = (bitcast<i32>(_e1022.member) != 0i);
                                                if _e1026 {
                                                    let _e1032 = type_42(_e1005.member, _e1005.member_1, (_e1005.member_2 + 1u));
                                                    let _e1033 = ((_e532.member_1 & 268435455u) + _e1022.member_1);
                                                    let _e1034 = (_e1033 < _e87);
                                                    if _e1034 {
                                                        if _e1034 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1038 = global_1.member[_e1033].member_1;
                                                        phi_1030_ = _e1038;
                                                    } else {
                                                        phi_1030_ = 4294967295u;
                                                    }
                                                    let _e1040 = phi_1030_;
                                                    if (_e1033 >= _e87) {
                                                        phi_1119_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1034 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        if (_e452 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1047 = global_1.member[_e1033].member[_e452];
                                                        if (_e458 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1053 = global_1.member[_e1033].member[_e458];
                                                        if (_e464 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1059 = global_1.member[_e1033].member[_e464];
                                                        let _e1061 = (3u + _e452);
                                                        if (_e1061 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1067 = global_1.member[_e1033].member[_e1061];
                                                        let _e1068 = (3u + _e458);
                                                        if (_e1068 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1074 = global_1.member[_e1033].member[_e1068];
                                                        let _e1075 = (3u + _e464);
                                                        if (_e1075 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1081 = global_1.member[_e1033].member[_e1075];
                                                        let _e1083 = (6u + _e452);
                                                        if (_e1083 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1089 = global_1.member[_e1033].member[_e1083];
                                                        let _e1090 = (6u + _e458);
                                                        if (_e1090 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1096 = global_1.member[_e1033].member[_e1090];
                                                        let _e1097 = (6u + _e464);
                                                        if (_e1097 < 9u) {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e1103 = global_1.member[_e1033].member[_e1097];
                                                        phi_1119_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1047, _e1053, _e1059), array<f32, 3>(_e1067, _e1074, _e1081), array<f32, 3>(_e1089, _e1096, _e1103));
                                                    }
                                                    let _e1107 = phi_1119_;
                                                    let _e1116 = (_e1107[0][2] - _e370);
                                                    let _e1119 = (((_e1107[0][0] - _e297) * _e394) - (_e1116 * _e322));
                                                    let _e1122 = (((_e1107[0][1] - _e334) * _e394) - (_e1116 * _e358));
                                                    let _e1129 = (_e1107[1][2] - _e370);
                                                    let _e1132 = (((_e1107[1][0] - _e297) * _e394) - (_e1129 * _e322));
                                                    let _e1135 = (((_e1107[1][1] - _e334) * _e394) - (_e1129 * _e358));
                                                    let _e1142 = (_e1107[2][2] - _e370);
                                                    let _e1145 = (((_e1107[2][0] - _e297) * _e394) - (_e1142 * _e322));
                                                    let _e1148 = (((_e1107[2][1] - _e334) * _e394) - (_e1142 * _e358));
                                                    let _e1149 = (_e1145 * _e1135);
                                                    let _e1150 = (_e1148 * _e1132);
                                                    let _e1151 = (_e1119 * _e1148);
                                                    let _e1152 = (_e1122 * _e1145);
                                                    let _e1153 = (_e1132 * _e1122);
                                                    let _e1154 = (_e1135 * _e1119);
                                                    let _e1159 = (((_e1149 >= _e1150) && (_e1151 >= _e1152)) && (_e1153 >= _e1154));
                                                    if (_e1159 || (((_e1149 <= _e1150) && (_e1151 <= _e1152)) && (_e1153 <= _e1154))) {
                                                        let _e1166 = select(-1f, 1f, _e1159);
                                                        let _e1168 = ((_e1149 - _e1150) * _e1166);
                                                        let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                        let _e1172 = ((_e1151 - _e1152) * _e1166);
                                                        let _e1174 = select(0f, _e1172, (_e1172 > 0f));
                                                        let _e1176 = ((_e1153 - _e1154) * _e1166);
                                                        let _e1178 = select(0f, _e1176, (_e1176 > 0f));
                                                        let _e1180 = ((_e1170 + _e1174) + _e1178);
                                                        if (_e1180 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1685_ = type_22();
                                                            phi_1686_ = true;
                                                        } else {
                                                            let _e1183 = select(_e1107[1][0], _e1107[0][0], (_e1107[0][0] < _e1107[1][0]));
                                                            let _e1187 = select(_e1107[1][0], _e1107[0][0], (_e1107[0][0] > _e1107[1][0]));
                                                            let _e1191 = select(_e1107[1][1], _e1107[0][1], (_e1107[0][1] < _e1107[1][1]));
                                                            let _e1195 = select(_e1107[1][1], _e1107[0][1], (_e1107[0][1] > _e1107[1][1]));
                                                            let _e1199 = select(_e1107[1][2], _e1107[0][2], (_e1107[0][2] < _e1107[1][2]));
                                                            let _e1203 = select(_e1107[1][2], _e1107[0][2], (_e1107[0][2] > _e1107[1][2]));
                                                            let _e1208 = ((select(_e1107[2][0], _e1183, (_e1183 < _e1107[2][0])) - _e320) * _e325);
                                                            let _e1209 = ((select(_e1107[2][0], _e1187, (_e1187 > _e1107[2][0])) - _e321) * _e325);
                                                            let _e1212 = ((select(_e1107[2][1], _e1191, (_e1191 < _e1107[2][1])) - _e356) * _e361);
                                                            let _e1213 = ((select(_e1107[2][1], _e1195, (_e1195 > _e1107[2][1])) - _e357) * _e361);
                                                            let _e1216 = ((select(_e1107[2][2], _e1199, (_e1199 < _e1107[2][2])) - _e392) * _e397);
                                                            let _e1217 = ((select(_e1107[2][2], _e1203, (_e1203 > _e1107[2][2])) - _e393) * _e397);
                                                            let _e1219 = select(_e1217, _e1216, (_e1216 < _e1217));
                                                            let _e1221 = select(_e1217, _e1216, (_e1216 > _e1217));
                                                            let _e1223 = select(_e1209, _e1208, (_e1208 < _e1209));
                                                            let _e1225 = select(_e1213, _e1212, (_e1212 < _e1213));
                                                            let _e1227 = select(_e1225, _e1223, (_e1223 > _e1225));
                                                            let _e1229 = select(_e1219, _e1227, (_e1227 > _e1219));
                                                            let _e1231 = select(_e1209, _e1208, (_e1208 > _e1209));
                                                            let _e1233 = select(_e1213, _e1212, (_e1212 > _e1213));
                                                            let _e1235 = select(_e1233, _e1231, (_e1231 < _e1233));
                                                            let _e1237 = select(_e1221, _e1235, (_e1235 < _e1221));
                                                            let _e1238 = -(_e1219);
                                                            let _e1244 = select(_e443, _e1229, (_e1229 > _e443));
                                                            if (_e1244 > (_e1237 + (select(_e1238, _e1221, (_e1221 > _e1238)) * 0.0000019073523f))) {
                                                                phi_1680_ = type_22();
                                                                phi_1681_ = true;
                                                            } else {
                                                                let _e1246 = (_e1244 > _e1005.member.member_1);
                                                                if _e1246 {
                                                                    phi_1679_ = type_22();
                                                                } else {
                                                                    let _e1250 = (_e1107[1][0] - _e1107[0][0]);
                                                                    let _e1251 = (_e1107[1][1] - _e1107[0][1]);
                                                                    let _e1252 = (_e1107[1][2] - _e1107[0][2]);
                                                                    let _e1253 = vec3<f32>(_e1250, _e1251, _e1252);
                                                                    let _e1254 = (_e1107[2][0] - _e1107[1][0]);
                                                                    let _e1255 = (_e1107[2][1] - _e1107[1][1]);
                                                                    let _e1256 = (_e1107[2][2] - _e1107[1][2]);
                                                                    let _e1257 = vec3<f32>(_e1254, _e1255, _e1256);
                                                                    let _e1258 = (_e1107[0][0] - _e1107[2][0]);
                                                                    let _e1259 = (_e1107[0][1] - _e1107[2][1]);
                                                                    let _e1260 = (_e1107[0][2] - _e1107[2][2]);
                                                                    let _e1261 = vec3<f32>(_e1258, _e1259, _e1260);
                                                                    let _e1264 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                    let _e1267 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                    let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                    let _e1272 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                    let _e1274 = select(_e1272, _e1269, (_e1269 > _e1272));
                                                                    let _e1277 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                    let _e1280 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                    let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                                                                    let _e1285 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                    let _e1287 = select(_e1285, _e1282, (_e1282 > _e1285));
                                                                    let _e1290 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                    let _e1293 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                    let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                    let _e1298 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                    let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                    let _e1302 = select(_e1287, _e1274, (_e1274 > _e1287));
                                                                    let _e1304 = select(_e1300, _e1302, (_e1302 > _e1300));
                                                                    if (_e1274 == _e1304) {
                                                                        phi_1590_ = _e1257;
                                                                        phi_1591_ = _e1261;
                                                                    } else {
                                                                        let _e1307 = vec3((_e1287 == _e1304));
                                                                        phi_1590_ = select(_e1253, _e1261, _e1307);
                                                                        phi_1591_ = select(_e1257, _e1253, _e1307);
                                                                    }
                                                                    let _e1311 = phi_1590_;
                                                                    let _e1313 = phi_1591_;
                                                                    let _e1320 = ((_e1311.y * _e1313.z) - (_e1313.y * _e1311.z));
                                                                    let _e1325 = ((_e1311.z * _e1313.x) - (_e1313.z * _e1311.x));
                                                                    let _e1328 = ((_e1311.x * _e1313.y) - (_e1313.x * _e1311.y));
                                                                    if (_e1170 >= _e1174) {
                                                                        phi_1622_ = select(true, false, (_e1170 >= _e1178));
                                                                    } else {
                                                                        phi_1622_ = true;
                                                                    }
                                                                    let _e1333 = phi_1622_;
                                                                    if _e1333 {
                                                                        phi_1631_ = select(vec3<f32>(_e1107[2][0], _e1107[2][1], _e1107[2][2]), vec3<f32>(_e1107[1][0], _e1107[1][1], _e1107[1][2]), vec3((_e1174 >= _e1178)));
                                                                    } else {
                                                                        phi_1631_ = vec3<f32>(_e1107[0][0], _e1107[0][1], _e1107[0][2]);
                                                                    }
                                                                    let _e1338 = phi_1631_;
                                                                    let _e1355 = ((((_e1320 * (_e1338.x - _e297)) + (_e1325 * (_e1338.y - _e334))) + (_e1328 * (_e1338.z - _e370))) / (((_e1320 * _e322) + (_e1325 * _e358)) + (_e1328 * _e394)));
                                                                    let _e1357 = select(_e1237, _e1355, (_e1355 < _e1237));
                                                                    let _e1359 = select(_e1229, _e1357, (_e1357 > _e1229));
                                                                    if (_e1359 >= _e443) {
                                                                        let _e1361 = (_e1359 <= _e1005.member.member_1);
                                                                        if _e1361 {
                                                                            let _e1362 = (1f / _e1180);
                                                                            phi_1671_ = type_22(_e1359, (_e1174 * _e1362), (_e1178 * _e1362), _e1040);
                                                                        } else {
                                                                            phi_1671_ = type_22();
                                                                        }
                                                                        let _e1367 = phi_1671_;
                                                                        phi_1673_ = _e1367;
                                                                        phi_1674_ = select(true, false, _e1361);
                                                                    } else {
                                                                        phi_1673_ = type_22();
                                                                        phi_1674_ = true;
                                                                    }
                                                                    let _e1370 = phi_1673_;
                                                                    let _e1372 = phi_1674_;
                                                                    if _e1372 {
                                                                        phi_1678_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1678_ = _e1370;
                                                                    }
                                                                    let _e1374 = phi_1678_;
                                                                    phi_1679_ = _e1374;
                                                                }
                                                                let _e1376 = phi_1679_;
                                                                phi_1680_ = _e1376;
                                                                phi_1681_ = _e1246;
                                                            }
                                                            let _e1378 = phi_1680_;
                                                            let _e1380 = phi_1681_;
                                                            phi_1685_ = _e1378;
                                                            phi_1686_ = _e1380;
                                                        }
                                                        let _e1382 = phi_1685_;
                                                        let _e1384 = phi_1686_;
                                                        phi_1690_ = _e1382;
                                                        phi_1691_ = _e1384;
                                                    } else {
                                                        phi_1690_ = type_22();
                                                        phi_1691_ = true;
                                                    }
                                                    let _e1386 = phi_1690_;
                                                    let _e1388 = phi_1691_;
                                                    if _e1388 {
                                                        phi_1695_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1695_ = _e1386;
                                                    }
                                                    let _e1390 = phi_1695_;
                                                    if (_e1390.member_3 != 4294967295u) {
                                                        if (_e1040 != _e449) {
                                                            if (_e1390.member < _e1005.member.member.member) {
                                                                phi_1721_ = true;
                                                            } else {
                                                                if (_e1390.member == _e1005.member.member.member) {
                                                                    phi_1720_ = (_e1390.member_3 < _e1005.member.member.member_3);
                                                                } else {
                                                                    phi_1720_ = false;
                                                                }
                                                                let _e1405 = phi_1720_;
                                                                phi_1721_ = _e1405;
                                                            }
                                                            let _e1407 = phi_1721_;
                                                            if _e1407 {
                                                                phi_1728_ = type_42(type_38(_e1390, _e1390.member), _e1032.member_1, _e1032.member_2);
                                                            } else {
                                                                phi_1728_ = _e1032;
                                                            }
                                                            let _e1414 = phi_1728_;
                                                            phi_1729_ = _e1414;
                                                        } else {
                                                            phi_1729_ = _e1032;
                                                        }
                                                        let _e1416 = phi_1729_;
                                                        phi_1730_ = _e1416;
                                                    } else {
                                                        phi_1730_ = _e1032;
                                                    }
                                                    let _e1418 = phi_1730_;
                                                    phi_981_ = _e1418;
                                                } else {
                                                    phi_981_ = type_42();
                                                }
                                                let _e1420 = phi_981_;
                                                continue;
                                                continuing {
                                                    phi_980_ = _e1420;
                                                    phi_983_ = _e1020;
                                                    phi_3315_ = _e490;
                                                    break if !(_e1026);
                                                }
                                            }
                                            let _e1423 = phi_3315_;
                                            phi_3429_ = _e1423;
                                            if _e1423 {
                                                break;
                                            }
                                            phi_3433_ = _e1423;
                                            let _e1640 = local_12;
                                            phi_2938_ = _e1640;
                                            phi_2939_ = _e532;
                                            phi_2940_ = false;
                                            phi_2941_ = _e536;
                                        } else {
                                            if (_e532.member_1 >= _e85) {
                                                phi_2494_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e532.member_1 < _e85) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e553 = (_e265 * 2u);
                                                let _e555 = ((1u + _e553) % 7u);
                                                if (_e555 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e560 = global_7.member[_e532.member_1][_e555];
                                                let _e562 = ((_e553 + 2u) % 7u);
                                                if (_e562 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e567 = global_7.member[_e532.member_1][_e562];
                                                let _e568 = (_e264 * 2u);
                                                let _e570 = ((1u + _e568) % 7u);
                                                if (_e570 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e575 = global_7.member[_e532.member_1][_e570];
                                                let _e577 = ((_e568 + 2u) % 7u);
                                                if (_e577 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e582 = global_7.member[_e532.member_1][_e577];
                                                let _e583 = (_e266 * 2u);
                                                let _e585 = ((1u + _e583) % 7u);
                                                if (_e585 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e590 = global_7.member[_e532.member_1][_e585];
                                                let _e592 = ((_e583 + 2u) % 7u);
                                                if (_e592 < 7u) {
                                                } else {
                                                    phi_3429_ = true;
                                                    break;
                                                }
                                                let _e597 = global_7.member[_e532.member_1][_e592];
                                                let _e620 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.x - _e532.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e621 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.y - _e532.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e622 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.z - _e532.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e624 = select(_e139, _e620, (_e620 > _e139));
                                                let _e626 = select(_e139, _e621, (_e621 > _e139));
                                                let _e628 = select(_e139, _e622, (_e622 > _e139));
                                                let _e653 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e624));
                                                let _e658 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                                let _e662 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e626));
                                                let _e667 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                                let _e671 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e628));
                                                let _e676 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                                let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                                let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                                let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                                let _e692 = bitcast<u32>((f32(bitcast<i32>((_e567 & 2097151u))) * _e624));
                                                let _e697 = (bitcast<i32>((_e567 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                                let _e701 = bitcast<u32>((f32(bitcast<i32>((_e582 & 2097151u))) * _e626));
                                                let _e706 = (bitcast<i32>((_e582 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                                let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e628));
                                                let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                                let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                                let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                                let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                                let _e760 = global_7.member[_e532.member_1][0u];
                                                let _e764 = global_7.member[_e532.member_1][2u];
                                                let _e768 = global_7.member[_e532.member_1][4u];
                                                let _e772 = global_7.member[_e532.member_1][6u];
                                                let _e784 = (((_e764 >> bitcast<u32>(22i)) | ((_e768 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e785 = (_e760 & 268435455u);
                                                let _e786 = (_e784 & 268435455u);
                                                let _e789 = ((_e760 >> bitcast<u32>(28u)) & 7u);
                                                let _e797 = ((_e760 >> bitcast<u32>(31i)) | (((_e784 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e798 = (_e789 != 0u);
                                                if (_e789 == 0u) {
                                                    phi_2456_ = _e785;
                                                } else {
                                                    if (_e789 == 7u) {
                                                        phi_2455_ = 2147483648u;
                                                    } else {
                                                        phi_2455_ = ((2147483648u | (_e789 << bitcast<u32>(28u))) | (_e786 & 268435455u));
                                                    }
                                                    let _e807 = phi_2455_;
                                                    phi_2456_ = _e807;
                                                }
                                                let _e809 = phi_2456_;
                                                if _e798 {
                                                    let _e810 = (_e789 != 7u);
                                                    if _e810 {
                                                        phi_2466_ = (_e786 + _e789);
                                                    } else {
                                                        phi_2466_ = u32();
                                                    }
                                                    let _e813 = phi_2466_;
                                                    phi_2468_ = _e813;
                                                    phi_2469_ = select(true, false, _e810);
                                                } else {
                                                    phi_2468_ = u32();
                                                    phi_2469_ = true;
                                                }
                                                let _e816 = phi_2468_;
                                                let _e818 = phi_2469_;
                                                if (_e797 == 0u) {
                                                    phi_2490_ = (_e785 + select(0u, 1u, !(_e798)));
                                                } else {
                                                    if (_e797 == 7u) {
                                                        phi_2489_ = 2147483648u;
                                                    } else {
                                                        phi_2489_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (select(_e816, _e786, _e818) & 268435455u));
                                                    }
                                                    let _e831 = phi_2489_;
                                                    phi_2490_ = _e831;
                                                }
                                                let _e833 = phi_2490_;
                                                phi_2494_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e532.member.member.x + _e661), (_e532.member.member.x + _e683), (_e532.member.member_1.x - _e700), (_e532.member.member_1.x - _e722)), vec4<f32>((_e532.member.member.y + _e670), (_e532.member.member.y + _e687), (_e532.member.member_1.y - _e709), (_e532.member.member_1.y - _e726)), vec4<f32>((_e532.member.member.z + _e679), (_e532.member.member.z + _e691), (_e532.member.member_1.z - _e718), (_e532.member.member_1.z - _e730))), type_53(type_34((_e532.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e532.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e809), type_53(type_34((_e532.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e532.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e833));
                                            }
                                            let _e838 = phi_2494_;
                                            let _e851 = ((_e838.member[0].x - _e320) * _e325);
                                            let _e852 = ((_e838.member[0].y - _e320) * _e325);
                                            let _e853 = ((_e838.member[0].z - _e321) * _e325);
                                            let _e854 = ((_e838.member[0].w - _e321) * _e325);
                                            let _e864 = ((_e838.member[1].x - _e356) * _e361);
                                            let _e865 = ((_e838.member[1].y - _e356) * _e361);
                                            let _e866 = ((_e838.member[1].z - _e357) * _e361);
                                            let _e867 = ((_e838.member[1].w - _e357) * _e361);
                                            let _e877 = ((_e838.member[2].x - _e392) * _e397);
                                            let _e878 = ((_e838.member[2].y - _e392) * _e397);
                                            let _e879 = ((_e838.member[2].z - _e393) * _e397);
                                            let _e880 = ((_e838.member[2].w - _e393) * _e397);
                                            let _e882 = select(_e879, _e877, (_e877 < _e879));
                                            let _e884 = select(_e880, _e878, (_e878 < _e880));
                                            let _e886 = select(_e879, _e877, (_e877 > _e879));
                                            let _e888 = select(_e880, _e878, (_e878 > _e880));
                                            let _e890 = select(_e853, _e851, (_e851 < _e853));
                                            let _e892 = select(_e854, _e852, (_e852 < _e854));
                                            let _e894 = select(_e866, _e864, (_e864 < _e866));
                                            let _e896 = select(_e867, _e865, (_e865 < _e867));
                                            let _e898 = select(_e894, _e890, (_e890 > _e894));
                                            let _e900 = select(_e896, _e892, (_e892 > _e896));
                                            let _e902 = select(_e882, _e898, (_e898 > _e882));
                                            let _e904 = select(_e884, _e900, (_e900 > _e884));
                                            let _e906 = select(_e853, _e851, (_e851 > _e853));
                                            let _e908 = select(_e854, _e852, (_e852 > _e854));
                                            let _e910 = select(_e866, _e864, (_e864 > _e866));
                                            let _e912 = select(_e867, _e865, (_e865 > _e867));
                                            let _e914 = select(_e910, _e906, (_e906 < _e910));
                                            let _e916 = select(_e912, _e908, (_e908 < _e912));
                                            let _e921 = -(_e882);
                                            let _e922 = -(_e884);
                                            let _e929 = (select(_e886, _e914, (_e914 < _e886)) + (select(_e921, _e886, (_e886 > _e921)) * 0.0000019073523f));
                                            let _e930 = (select(_e888, _e916, (_e916 < _e888)) + (select(_e922, _e888, (_e888 > _e922)) * 0.0000019073523f));
                                            let _e932 = select(_e443, _e902, (_e902 > _e443));
                                            let _e934 = select(_e443, _e904, (_e904 > _e443));
                                            let _e939 = (_e932 <= select(_e492.member.member_1, _e929, (_e929 < _e492.member.member_1)));
                                            let _e940 = (_e934 <= select(_e492.member.member_1, _e930, (_e930 < _e492.member.member_1)));
                                            let _e941 = (_e932 <= _e934);
                                            if _e939 {
                                                if _e940 {
                                                    if _e941 {
                                                        phi_2838_ = _e838.member_2;
                                                    } else {
                                                        phi_2838_ = _e838.member_1;
                                                    }
                                                    let _e945 = phi_2838_;
                                                    let _e967 = (_e536 % 128u);
                                                    let _e968 = (_e967 < 128u);
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_8[_e967] = _e945.member_1;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_7[_e967] = _e945.member.member.x;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_6[_e967] = _e945.member.member.y;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_5[_e967] = _e945.member.member.z;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_4[_e967] = _e945.member.member_1.x;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_3[_e967] = _e945.member.member_1.y;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_2[_e967] = _e945.member.member_1.z;
                                                    if _e968 {
                                                    } else {
                                                        phi_3429_ = true;
                                                        break;
                                                    }
                                                    local_9[_e967] = select(_e934, _e932, (_e932 > _e934));
                                                    if _e941 {
                                                        phi_2915_ = _e838.member_1;
                                                    } else {
                                                        phi_2915_ = _e838.member_2;
                                                    }
                                                    let _e981 = phi_2915_;
                                                    phi_2916_ = _e981;
                                                    phi_2917_ = (_e536 + 1u);
                                                } else {
                                                    phi_2916_ = type_53();
                                                    phi_2917_ = u32();
                                                }
                                                let _e983 = phi_2916_;
                                                let _e985 = phi_2917_;
                                                phi_2919_ = _e983;
                                                phi_2920_ = _e985;
                                                phi_2921_ = select(true, false, _e940);
                                            } else {
                                                phi_2919_ = type_53();
                                                phi_2920_ = u32();
                                                phi_2921_ = true;
                                            }
                                            let _e988 = phi_2919_;
                                            let _e990 = phi_2920_;
                                            let _e992 = phi_2921_;
                                            if _e992 {
                                                if _e939 {
                                                    phi_2930_ = _e838.member_1;
                                                } else {
                                                    phi_2930_ = _e838.member_2;
                                                }
                                                let _e996 = phi_2930_;
                                                phi_2935_ = _e996;
                                                phi_2936_ = select(_e940, true, _e939);
                                            } else {
                                                phi_2935_ = _e988;
                                                phi_2936_ = _e534;
                                            }
                                            let _e999 = phi_2935_;
                                            let _e1001 = phi_2936_;
                                            phi_3433_ = _e490;
                                            phi_2938_ = type_42(_e492.member, (_e492.member_1 + 1u), _e492.member_2);
                                            phi_2939_ = _e999;
                                            phi_2940_ = _e1001;
                                            phi_2941_ = select(_e990, _e536, _e992);
                                        }
                                        let _e1425 = phi_3433_;
                                        let _e1427 = phi_2938_;
                                        let _e1429 = phi_2939_;
                                        let _e1431 = phi_2940_;
                                        let _e1433 = phi_2941_;
                                        phi_3432_ = _e1425;
                                        phi_2942_ = _e1427;
                                        phi_2943_ = _e1429;
                                        phi_2944_ = (_e496 - 1u);
                                        phi_2945_ = _e1431;
                                        phi_2946_ = _e1433;
                                    } else {
                                        phi_3432_ = _e490;
                                        phi_2942_ = _e492;
                                        phi_2943_ = _e532;
                                        phi_2944_ = _e496;
                                        phi_2945_ = _e534;
                                        phi_2946_ = _e536;
                                    }
                                    let _e1435 = phi_3432_;
                                    let _e1437 = phi_2942_;
                                    let _e1439 = phi_2943_;
                                    let _e1441 = phi_2944_;
                                    let _e1443 = phi_2945_;
                                    let _e1445 = phi_2946_;
                                    phi_3431_ = _e1435;
                                    phi_2947_ = _e1437;
                                    phi_2948_ = _e1439;
                                    phi_2949_ = _e1441;
                                    phi_2950_ = _e1443;
                                    phi_2951_ = _e1445;
                                } else {
                                    phi_3431_ = _e490;
                                    phi_2947_ = type_42();
                                    phi_2948_ = type_53();
                                    phi_2949_ = u32();
                                    phi_2950_ = bool();
                                    phi_2951_ = u32();
                                }
                                let _e1447 = phi_3431_;
                                let _e1449 = phi_2947_;
                                let _e1451 = phi_2948_;
                                let _e1453 = phi_2949_;
                                let _e1455 = phi_2950_;
                                let _e1457 = phi_2951_;
                                phi_3430_ = _e1447;
                                phi_855_ = _e1449;
                                phi_858_ = _e1451;
                                phi_860_ = _e1453;
                                phi_862_ = _e1455;
                                phi_864_ = _e1457;
                                phi_2952_ = _e504;
                            } else {
                                phi_3430_ = _e490;
                                phi_855_ = type_42();
                                phi_858_ = type_53();
                                phi_860_ = u32();
                                phi_862_ = bool();
                                phi_864_ = u32();
                                phi_2952_ = false;
                            }
                            let _e1459 = phi_3430_;
                            let _e1461 = phi_855_;
                            let _e1463 = phi_858_;
                            let _e1465 = phi_860_;
                            let _e1467 = phi_862_;
                            let _e1469 = phi_864_;
                            let _e1471 = phi_2952_;
                            continue;
                            continuing {
                                phi_3321_ = _e1459;
                                phi_854_ = _e1461;
                                phi_857_ = _e1463;
                                phi_859_ = _e1465;
                                phi_861_ = _e1467;
                                phi_863_ = _e1469;
                                phi_3429_ = _e1459;
                                break if !(_e1471);
                            }
                        }
                        let _e1474 = phi_3429_;
                        if _e1474 {
                            break;
                        }
                        let _e1476 = local_10;
                        if (_e1476.member.member.member_3 != 4294967295u) {
                            let _e1482 = (_e267 / 3i);
                            let _e1489 = bitcast<f32>((bitcast<u32>((_e1482 + 127i)) << bitcast<u32>(23i)));
                            let _e1497 = (((_e1476.member.member.member * _e1489) * _e1489) * bitcast<f32>((bitcast<u32>(((_e267 - (2i * _e1482)) + 127i)) << bitcast<u32>(23i))));
                            let _e1499 = select(340282350000000000000000000000000000000f, _e1497, (_e1497 < 340282350000000000000000000000000000000f));
                            phi_3004_ = type_22(select(-340282350000000000000000000000000000000f, _e1499, (_e1499 > -340282350000000000000000000000000000000f)), _e1476.member.member.member_1, _e1476.member.member.member_2, _e1476.member.member.member_3);
                        } else {
                            phi_3004_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1506 = phi_3004_;
                        if _e143 {
                        } else {
                            break;
                        }
                        global_2.member[_e127] = _e1506;
                        let _e1510 = local_11;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_5.member[_e127] = _e1510.member_1;
                        if _e142 {
                        } else {
                            break;
                        }
                        let _e1515 = select(0u, 1u, (_e211 <= _e221));
                        if (_e1515 > 0u) {
                            let _e1517 = (1u < _e95);
                            if _e1517 {
                                if (0u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1521 = atomicAdd((&global_6.member[0u]), _e1515);
                                if ((_e1521 + _e1515) < _e1521) {
                                    if _e1517 {
                                    } else {
                                        break;
                                    }
                                    let _e1526 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1529 = select(0u, 1u, (_e1506.member_3 != 4294967295u));
                        if (_e1529 > 0u) {
                            let _e1531 = (3u < _e95);
                            if _e1531 {
                                if (2u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1535 = atomicAdd((&global_6.member[2u]), _e1529);
                                if ((_e1535 + _e1529) < _e1535) {
                                    if _e1531 {
                                    } else {
                                        break;
                                    }
                                    let _e1540 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1510.member_1 > 0u) {
                            let _e1542 = (5u < _e95);
                            if _e1542 {
                                if (4u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1546 = atomicAdd((&global_6.member[4u]), _e1510.member_1);
                                if ((_e1546 + _e1510.member_1) < _e1546) {
                                    if _e1542 {
                                    } else {
                                        break;
                                    }
                                    let _e1551 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
