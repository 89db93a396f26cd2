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
    var phi_394_: i32;
    var phi_395_: i32;
    var phi_405_: bool;
    var phi_415_: u32;
    var phi_416_: u32;
    var phi_418_: bool;
    var phi_423_: u32;
    var phi_455_: i32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_519_: f32;
    var phi_530_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_585_: f32;
    var phi_596_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_651_: f32;
    var phi_662_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_3592_: bool;
    var phi_861_: type_42;
    var phi_864_: type_53;
    var phi_866_: u32;
    var phi_868_: bool;
    var phi_870_: u32;
    var phi_881_: bool;
    var phi_967_: type_53;
    var phi_968_: bool;
    var phi_969_: u32;
    var phi_2726_: u32;
    var phi_2727_: u32;
    var phi_2737_: u32;
    var phi_2739_: u32;
    var phi_2740_: bool;
    var phi_2760_: u32;
    var phi_2761_: u32;
    var phi_2765_: type_54;
    var phi_3109_: type_53;
    var phi_3186_: type_53;
    var phi_3187_: type_53;
    var phi_3188_: u32;
    var phi_3190_: type_53;
    var phi_3191_: u32;
    var phi_3192_: bool;
    var phi_3201_: type_53;
    var phi_3206_: type_53;
    var phi_3207_: bool;
    var phi_987_: type_42;
    var phi_990_: type_7;
    var phi_991_: type_7;
    var phi_1013_: type_7;
    var phi_1037_: u32;
    var phi_1126_: array<array<f32, 3>, 3>;
    var phi_1243_: bool;
    var phi_1272_: bool;
    var phi_1673_: f32;
    var phi_1674_: f32;
    var phi_1675_: f32;
    var phi_1676_: f32;
    var phi_1677_: vec3<f32>;
    var phi_1678_: vec3<f32>;
    var phi_1679_: vec3<f32>;
    var phi_1680_: vec3<f32>;
    var phi_1711_: bool;
    var phi_1720_: vec3<f32>;
    var phi_1885_: f32;
    var phi_1887_: f32;
    var phi_1888_: bool;
    var phi_1908_: f32;
    var phi_1909_: f32;
    var phi_1932_: type_22;
    var phi_1934_: type_22;
    var phi_1935_: bool;
    var phi_1939_: type_22;
    var phi_1940_: type_22;
    var phi_1941_: type_22;
    var phi_1942_: bool;
    var phi_1946_: type_22;
    var phi_1947_: bool;
    var phi_1948_: type_22;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1951_: type_22;
    var phi_1952_: bool;
    var phi_1953_: bool;
    var phi_1961_: type_22;
    var phi_1962_: bool;
    var phi_1966_: type_22;
    var phi_1991_: bool;
    var phi_1992_: bool;
    var phi_1999_: type_42;
    var phi_2000_: type_42;
    var phi_2001_: type_42;
    var phi_988_: type_42;
    var phi_3586_: bool;
    var phi_3732_: bool;
    var phi_3209_: type_42;
    var phi_3210_: type_53;
    var phi_3211_: bool;
    var phi_3212_: u32;
    var phi_3731_: bool;
    var phi_3213_: type_42;
    var phi_3214_: type_53;
    var phi_3215_: u32;
    var phi_3216_: bool;
    var phi_3217_: u32;
    var phi_3730_: bool;
    var phi_3218_: type_42;
    var phi_3219_: type_53;
    var phi_3220_: u32;
    var phi_3221_: bool;
    var phi_3222_: u32;
    var phi_3729_: bool;
    var phi_862_: type_42;
    var phi_865_: type_53;
    var phi_867_: u32;
    var phi_869_: bool;
    var phi_871_: u32;
    var phi_3223_: bool;
    var phi_3728_: bool;
    var local_10: type_42;
    var phi_3275_: type_22;
    var local_11: type_42;
    var local_12: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_7.member));
            let _e89 = arrayLength((&global_1.member));
            let _e97 = arrayLength((&global_6.member));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[0u][3u];
            let _e117 = global_3.member[1u][0u];
            let _e121 = global_3.member[1u][1u];
            let _e125 = global_3.member[1u][2u];
            let _e129 = (_e85.x + (_e85.y * 2097152u));
            let _e141 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e113) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e101), bitcast<i32>(_e105), bitcast<i32>(_e109));
            local = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            let _e144 = (_e129 < arrayLength((&global_4.member)));
            if _e144 {
                let _e145 = (_e129 < arrayLength((&global_2.member)));
                if _e145 {
                    let _e146 = (_e129 < arrayLength((&global_5.member)));
                    if _e146 {
                        if _e144 {
                        } else {
                            break;
                        }
                        let _e156 = global_4.member[_e129].member.member_2[0u];
                        let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                        let _e164 = global_4.member[_e129].member.member_2[1u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e172 = global_4.member[_e129].member.member_2[2u];
                        let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                        let _e180 = global_4.member[_e129].member.member[0u];
                        let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e188 = global_4.member[_e129].member.member[1u];
                        let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                        let _e196 = global_4.member[_e129].member.member[2u];
                        let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                        let _e200 = select(_e166, _e158, (_e166 < _e158));
                        let _e202 = select(_e174, _e200, (_e174 < _e200));
                        let _e204 = select(_e182, _e202, (_e182 < _e202));
                        let _e206 = select(_e190, _e204, (_e190 < _e204));
                        let _e208 = select(_e198, _e206, (_e198 < _e206));
                        let _e213 = global_4.member[_e129].member.member_1;
                        let _e215 = (bitcast<u32>(_e213) & 2147483647u);
                        let _e223 = global_4.member[_e129].member.member_3;
                        let _e229 = (((select(_e215, _e208, (_e215 < _e208)) < 2139095040u) && ((bitcast<u32>(_e223) & 2147483647u) <= 2139095040u)) && (_e202 > 0u));
                        if _e229 {
                            let _e232 = (bitcast<u32>(bitcast<f32>(_e202)) & 2147483647u);
                            if (_e232 >= 8388608u) {
                                phi_394_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_394_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                            }
                            let _e246 = phi_394_;
                            phi_395_ = _e246;
                        } else {
                            phi_395_ = 0i;
                        }
                        let _e248 = phi_395_;
                        let _e249 = (_e158 == _e202);
                        if _e249 {
                            phi_405_ = true;
                        } else {
                            phi_405_ = (_e166 == _e202);
                        }
                        let _e252 = phi_405_;
                        let _e253 = select(1u, 0u, _e249);
                        if _e252 {
                            let _e254 = (_e253 + 1u);
                            phi_415_ = _e254;
                            phi_416_ = _e254;
                            phi_418_ = select(true, false, (_e254 == 2u));
                        } else {
                            phi_415_ = u32();
                            phi_416_ = 0u;
                            phi_418_ = true;
                        }
                        let _e258 = phi_415_;
                        let _e260 = phi_416_;
                        let _e262 = phi_418_;
                        if _e262 {
                            phi_423_ = (_e260 + 1u);
                        } else {
                            phi_423_ = 0u;
                        }
                        let _e266 = phi_423_;
                        let _e267 = select(_e258, _e260, _e262);
                        let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                        let _e269 = -(_e248);
                        if (_e269 < -126i) {
                            phi_455_ = -126i;
                        } else {
                            phi_455_ = select(_e269, 127i, (_e269 > 127i));
                        }
                        let _e274 = phi_455_;
                        let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                        let _e285 = bitcast<f32>((bitcast<u32>(((_e269 - _e274) + 127i)) << bitcast<u32>(23i)));
                        let _e290 = global_4.member[_e129].member.member;
                        let _e291 = (_e267 == 0u);
                        if _e291 {
                            phi_473_ = _e290[0];
                        } else {
                            phi_473_ = _e290[1];
                        }
                        let _e295 = phi_473_;
                        let _e296 = (_e267 == 2u);
                        if _e296 {
                            phi_479_ = _e290[2];
                        } else {
                            phi_479_ = _e295;
                        }
                        let _e299 = phi_479_;
                        let _e300 = global_4.member[_e129].member.member_2;
                        if _e291 {
                            phi_490_ = _e300[0];
                        } else {
                            phi_490_ = _e300[1];
                        }
                        let _e304 = phi_490_;
                        if _e296 {
                            phi_496_ = _e300[2];
                        } else {
                            phi_496_ = _e304;
                        }
                        let _e307 = phi_496_;
                        let _e309 = ((_e307 * _e279) * _e285);
                        let _e313 = (bitcast<f32>((bitcast<u32>(_e309) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e313 {
                            let _e317 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) * 0.00000011920929f);
                            phi_519_ = select(0.00000000000011368684f, _e317, (_e317 > 0.00000000000011368684f));
                        } else {
                            phi_519_ = 0f;
                        }
                        let _e321 = phi_519_;
                        let _e322 = (_e299 + _e321);
                        let _e323 = (_e299 - _e321);
                        let _e324 = select(_e309, 0f, _e313);
                        if _e313 {
                            phi_530_ = 38685626000000000000000000f;
                        } else {
                            phi_530_ = (1f / _e309);
                        }
                        let _e327 = phi_530_;
                        let _e328 = (_e266 == 0u);
                        if _e328 {
                            phi_539_ = _e290[0];
                        } else {
                            phi_539_ = _e290[1];
                        }
                        let _e332 = phi_539_;
                        let _e333 = (_e266 == 2u);
                        if _e333 {
                            phi_545_ = _e290[2];
                        } else {
                            phi_545_ = _e332;
                        }
                        let _e336 = phi_545_;
                        if _e328 {
                            phi_556_ = _e300[0];
                        } else {
                            phi_556_ = _e300[1];
                        }
                        let _e340 = phi_556_;
                        if _e333 {
                            phi_562_ = _e300[2];
                        } else {
                            phi_562_ = _e340;
                        }
                        let _e343 = phi_562_;
                        let _e345 = ((_e343 * _e279) * _e285);
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e349 {
                            let _e353 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) * 0.00000011920929f);
                            phi_585_ = select(0.00000000000011368684f, _e353, (_e353 > 0.00000000000011368684f));
                        } else {
                            phi_585_ = 0f;
                        }
                        let _e357 = phi_585_;
                        let _e358 = (_e336 + _e357);
                        let _e359 = (_e336 - _e357);
                        let _e360 = select(_e345, 0f, _e349);
                        if _e349 {
                            phi_596_ = 38685626000000000000000000f;
                        } else {
                            phi_596_ = (1f / _e345);
                        }
                        let _e363 = phi_596_;
                        let _e364 = (_e268 == 0u);
                        if _e364 {
                            phi_605_ = _e290[0];
                        } else {
                            phi_605_ = _e290[1];
                        }
                        let _e368 = phi_605_;
                        let _e369 = (_e268 == 2u);
                        if _e369 {
                            phi_611_ = _e290[2];
                        } else {
                            phi_611_ = _e368;
                        }
                        let _e372 = phi_611_;
                        if _e364 {
                            phi_622_ = _e300[0];
                        } else {
                            phi_622_ = _e300[1];
                        }
                        let _e376 = phi_622_;
                        if _e369 {
                            phi_628_ = _e300[2];
                        } else {
                            phi_628_ = _e376;
                        }
                        let _e379 = phi_628_;
                        let _e381 = ((_e379 * _e279) * _e285);
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e385 {
                            let _e389 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) * 0.00000011920929f);
                            phi_651_ = select(0.00000000000011368684f, _e389, (_e389 > 0.00000000000011368684f));
                        } else {
                            phi_651_ = 0f;
                        }
                        let _e393 = phi_651_;
                        let _e394 = (_e372 + _e393);
                        let _e395 = (_e372 - _e393);
                        let _e396 = select(_e381, 0f, _e385);
                        if _e385 {
                            phi_662_ = 38685626000000000000000000f;
                        } else {
                            phi_662_ = (1f / _e381);
                        }
                        let _e399 = phi_662_;
                        let _e402 = bitcast<f32>((bitcast<u32>(_e299) & 2147483647u));
                        let _e405 = bitcast<f32>((bitcast<u32>(_e336) & 2147483647u));
                        let _e407 = select(_e405, _e402, (_e402 > _e405));
                        let _e410 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
                        if (_e229 && (select(_e410, _e407, (_e407 > _e410)) <= 1099511600000f)) {
                            let _e415 = (_e248 / 3i);
                            let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                            let _e429 = bitcast<f32>((bitcast<u32>(((_e248 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                            let _e430 = (((_e213 * _e422) * _e422) * _e429);
                            let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                            let _e437 = (((_e223 * _e422) * _e422) * _e429);
                            let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                            phi_762_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                            phi_763_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_762_ = 0f;
                            phi_763_ = 1f;
                        }
                        let _e443 = phi_762_;
                        let _e445 = phi_763_;
                        if _e144 {
                        } else {
                            break;
                        }
                        let _e451 = global_4.member[_e129].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e454 = (_e267 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_1[_e454];
                        let _e460 = (_e266 % 3u);
                        let _e461 = (_e460 < 3u);
                        if _e461 {
                        } else {
                            break;
                        }
                        let _e463 = local_1[_e460];
                        let _e466 = (_e268 % 3u);
                        let _e467 = (_e466 < 3u);
                        if _e467 {
                        } else {
                            break;
                        }
                        let _e469 = local_1[_e466];
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e474 = local[_e454];
                        if _e461 {
                        } else {
                            break;
                        }
                        let _e478 = local[_e460];
                        if _e467 {
                        } else {
                            break;
                        }
                        let _e482 = local[_e466];
                        phi_3592_ = false;
                        phi_861_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e443), 0u, 0u);
                        phi_864_ = type_53(type_34(vec4<f32>((f32(_e457) * _e141), (f32(_e463) * _e141), (f32(_e469) * _e141), 0f), vec4<f32>((f32(_e474) * _e141), (f32(_e478) * _e141), (f32(_e482) * _e141), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                        phi_866_ = ((3u * _e87) + 1u);
                        phi_868_ = (_e445 <= _e443);
                        phi_870_ = 0u;
                        loop {
                            let _e492 = phi_3592_;
                            let _e494 = phi_861_;
                            let _e496 = phi_864_;
                            let _e498 = phi_866_;
                            let _e500 = phi_868_;
                            let _e502 = phi_870_;
                            local_10 = _e494;
                            local_11 = _e494;
                            if _e500 {
                                phi_881_ = true;
                            } else {
                                phi_881_ = (_e502 > 0u);
                            }
                            let _e505 = phi_881_;
                            if _e505 {
                                let _e506 = (_e498 > 0u);
                                if _e506 {
                                    if _e500 {
                                        phi_967_ = _e496;
                                        phi_968_ = _e500;
                                        phi_969_ = _e502;
                                    } else {
                                        let _e507 = (_e502 - 1u);
                                        let _e508 = (_e507 % 128u);
                                        let _e509 = (_e508 < 128u);
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e511 = local_7[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e513 = local_6[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e515 = local_5[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e517 = local_4[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e519 = local_3[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e521 = local_2[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e526 = local_8[_e508];
                                        if _e509 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e529 = local_9[_e508];
                                        phi_967_ = type_53(type_34(vec4<f32>(_e511, _e513, _e515, 0f), vec4<f32>(_e517, _e519, _e521, 0f)), _e526);
                                        phi_968_ = (_e529 <= _e494.member.member_1);
                                        phi_969_ = _e507;
                                    }
                                    let _e534 = phi_967_;
                                    let _e536 = phi_968_;
                                    let _e538 = phi_969_;
                                    if _e536 {
                                        if ((_e534.member_1 & 2147483648u) != 0u) {
                                            phi_987_ = _e494;
                                            phi_990_ = type_7(0u, ((_e534.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1007 = phi_987_;
                                                let _e1009 = phi_990_;
                                                local_12 = _e1007;
                                                if (_e1009.member < _e1009.member_1) {
                                                    phi_991_ = type_7((_e1009.member + 1u), _e1009.member_1);
                                                    phi_1013_ = type_7(1u, _e1009.member);
                                                } else {
                                                    phi_991_ = _e1009;
                                                    phi_1013_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1022 = phi_991_;
                                                let _e1024 = phi_1013_;
                                                let _e1028 = (bitcast<i32>(_e1024.member) != 0i);
                                                if _e1028 {
                                                    let _e1034 = type_42(_e1007.member, _e1007.member_1, (_e1007.member_2 + 1u));
                                                    let _e1035 = ((_e534.member_1 & 268435455u) + _e1024.member_1);
                                                    let _e1036 = (_e1035 < _e89);
                                                    if _e1036 {
                                                        if _e1036 {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1040 = global_1.member[_e1035].member_1;
                                                        phi_1037_ = _e1040;
                                                    } else {
                                                        phi_1037_ = 4294967295u;
                                                    }
                                                    let _e1042 = phi_1037_;
                                                    if (_e1035 >= _e89) {
                                                        phi_1126_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1036 {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        if (_e454 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1049 = global_1.member[_e1035].member[_e454];
                                                        if (_e460 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1055 = global_1.member[_e1035].member[_e460];
                                                        if (_e466 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1061 = global_1.member[_e1035].member[_e466];
                                                        let _e1063 = (3u + _e454);
                                                        if (_e1063 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1069 = global_1.member[_e1035].member[_e1063];
                                                        let _e1070 = (3u + _e460);
                                                        if (_e1070 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1076 = global_1.member[_e1035].member[_e1070];
                                                        let _e1077 = (3u + _e466);
                                                        if (_e1077 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1083 = global_1.member[_e1035].member[_e1077];
                                                        let _e1085 = (6u + _e454);
                                                        if (_e1085 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1091 = global_1.member[_e1035].member[_e1085];
                                                        let _e1092 = (6u + _e460);
                                                        if (_e1092 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1098 = global_1.member[_e1035].member[_e1092];
                                                        let _e1099 = (6u + _e466);
                                                        if (_e1099 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1105 = global_1.member[_e1035].member[_e1099];
                                                        phi_1126_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1049, _e1055, _e1061), array<f32, 3>(_e1069, _e1076, _e1083), array<f32, 3>(_e1091, _e1098, _e1105));
                                                    }
                                                    let _e1109 = phi_1126_;
                                                    let _e1118 = (_e1109[0][2] - _e372);
                                                    let _e1121 = (((_e1109[0][0] - _e299) * _e396) - (_e1118 * _e324));
                                                    let _e1124 = (((_e1109[0][1] - _e336) * _e396) - (_e1118 * _e360));
                                                    let _e1131 = (_e1109[1][2] - _e372);
                                                    let _e1134 = (((_e1109[1][0] - _e299) * _e396) - (_e1131 * _e324));
                                                    let _e1137 = (((_e1109[1][1] - _e336) * _e396) - (_e1131 * _e360));
                                                    let _e1144 = (_e1109[2][2] - _e372);
                                                    let _e1147 = (((_e1109[2][0] - _e299) * _e396) - (_e1144 * _e324));
                                                    let _e1150 = (((_e1109[2][1] - _e336) * _e396) - (_e1144 * _e360));
                                                    let _e1151 = (_e1147 * _e1137);
                                                    let _e1152 = (_e1150 * _e1134);
                                                    let _e1153 = (_e1121 * _e1150);
                                                    let _e1154 = (_e1124 * _e1147);
                                                    let _e1155 = (_e1134 * _e1124);
                                                    let _e1156 = (_e1137 * _e1121);
                                                    let _e1161 = (((_e1151 >= _e1152) && (_e1153 >= _e1154)) && (_e1155 >= _e1156));
                                                    if (_e1161 || (((_e1151 <= _e1152) && (_e1153 <= _e1154)) && (_e1155 <= _e1156))) {
                                                        let _e1168 = select(-1f, 1f, _e1161);
                                                        let _e1170 = ((_e1151 - _e1152) * _e1168);
                                                        let _e1172 = select(0f, _e1170, (_e1170 > 0f));
                                                        let _e1174 = ((_e1153 - _e1154) * _e1168);
                                                        let _e1176 = select(0f, _e1174, (_e1174 > 0f));
                                                        let _e1178 = ((_e1155 - _e1156) * _e1168);
                                                        let _e1180 = select(0f, _e1178, (_e1178 > 0f));
                                                        let _e1182 = ((_e1172 + _e1176) + _e1180);
                                                        if (_e1182 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1951_ = type_22();
                                                            phi_1952_ = true;
                                                            phi_1953_ = false;
                                                        } else {
                                                            let _e1185 = select(_e1134, _e1121, (_e1121 < _e1134));
                                                            if (select(_e1147, _e1185, (_e1185 < _e1147)) > 0f) {
                                                                phi_1243_ = true;
                                                            } else {
                                                                let _e1190 = select(_e1134, _e1121, (_e1121 > _e1134));
                                                                phi_1243_ = (select(_e1147, _e1190, (_e1190 > _e1147)) < 0f);
                                                            }
                                                            let _e1195 = phi_1243_;
                                                            if _e1195 {
                                                                phi_1948_ = type_22();
                                                                phi_1949_ = true;
                                                                phi_1950_ = false;
                                                            } else {
                                                                let _e1197 = select(_e1137, _e1124, (_e1124 < _e1137));
                                                                if (select(_e1150, _e1197, (_e1197 < _e1150)) > 0f) {
                                                                    phi_1272_ = true;
                                                                } else {
                                                                    let _e1202 = select(_e1137, _e1124, (_e1124 > _e1137));
                                                                    phi_1272_ = (select(_e1150, _e1202, (_e1202 > _e1150)) < 0f);
                                                                }
                                                                let _e1207 = phi_1272_;
                                                                if _e1207 {
                                                                    phi_1946_ = type_22();
                                                                    phi_1947_ = false;
                                                                } else {
                                                                    let _e1209 = select(_e1109[1][0], _e1109[0][0], (_e1109[0][0] < _e1109[1][0]));
                                                                    let _e1213 = select(_e1109[1][0], _e1109[0][0], (_e1109[0][0] > _e1109[1][0]));
                                                                    let _e1217 = select(_e1109[1][1], _e1109[0][1], (_e1109[0][1] < _e1109[1][1]));
                                                                    let _e1221 = select(_e1109[1][1], _e1109[0][1], (_e1109[0][1] > _e1109[1][1]));
                                                                    let _e1225 = select(_e1109[1][2], _e1109[0][2], (_e1109[0][2] < _e1109[1][2]));
                                                                    let _e1229 = select(_e1109[1][2], _e1109[0][2], (_e1109[0][2] > _e1109[1][2]));
                                                                    let _e1234 = ((select(_e1109[2][0], _e1209, (_e1209 < _e1109[2][0])) - _e322) * _e327);
                                                                    let _e1235 = ((select(_e1109[2][0], _e1213, (_e1213 > _e1109[2][0])) - _e323) * _e327);
                                                                    let _e1238 = ((select(_e1109[2][1], _e1217, (_e1217 < _e1109[2][1])) - _e358) * _e363);
                                                                    let _e1239 = ((select(_e1109[2][1], _e1221, (_e1221 > _e1109[2][1])) - _e359) * _e363);
                                                                    let _e1242 = ((select(_e1109[2][2], _e1225, (_e1225 < _e1109[2][2])) - _e394) * _e399);
                                                                    let _e1243 = ((select(_e1109[2][2], _e1229, (_e1229 > _e1109[2][2])) - _e395) * _e399);
                                                                    let _e1245 = select(_e1243, _e1242, (_e1242 < _e1243));
                                                                    let _e1247 = select(_e1243, _e1242, (_e1242 > _e1243));
                                                                    let _e1249 = select(_e1235, _e1234, (_e1234 < _e1235));
                                                                    let _e1251 = select(_e1239, _e1238, (_e1238 < _e1239));
                                                                    let _e1253 = select(_e1251, _e1249, (_e1249 > _e1251));
                                                                    let _e1255 = select(_e1245, _e1253, (_e1253 > _e1245));
                                                                    let _e1257 = select(_e1235, _e1234, (_e1234 > _e1235));
                                                                    let _e1259 = select(_e1239, _e1238, (_e1238 > _e1239));
                                                                    let _e1261 = select(_e1259, _e1257, (_e1257 < _e1259));
                                                                    let _e1263 = select(_e1247, _e1261, (_e1261 < _e1247));
                                                                    let _e1264 = -(_e1245);
                                                                    let _e1270 = select(_e445, _e1255, (_e1255 > _e445));
                                                                    if (_e1270 > (_e1263 + (select(_e1264, _e1247, (_e1247 > _e1264)) * 0.0000019073523f))) {
                                                                        phi_1941_ = type_22();
                                                                        phi_1942_ = true;
                                                                    } else {
                                                                        let _e1272 = (_e1270 > _e1007.member.member_1);
                                                                        if _e1272 {
                                                                            phi_1940_ = type_22();
                                                                        } else {
                                                                            let _e1273 = vec3<f32>(_e1109[0][0], _e1109[0][1], _e1109[0][2]);
                                                                            let _e1274 = vec3<f32>(_e1109[1][0], _e1109[1][1], _e1109[1][2]);
                                                                            let _e1275 = vec3<f32>(_e1109[2][0], _e1109[2][1], _e1109[2][2]);
                                                                            let _e1276 = (_e1109[1][0] - _e1109[0][0]);
                                                                            let _e1277 = (_e1109[1][1] - _e1109[0][1]);
                                                                            let _e1278 = (_e1109[1][2] - _e1109[0][2]);
                                                                            let _e1279 = vec3<f32>(_e1276, _e1277, _e1278);
                                                                            let _e1280 = (_e1109[2][0] - _e1109[1][0]);
                                                                            let _e1281 = (_e1109[2][1] - _e1109[1][1]);
                                                                            let _e1282 = (_e1109[2][2] - _e1109[1][2]);
                                                                            let _e1283 = vec3<f32>(_e1280, _e1281, _e1282);
                                                                            let _e1284 = (_e1109[0][0] - _e1109[2][0]);
                                                                            let _e1285 = (_e1109[0][1] - _e1109[2][1]);
                                                                            let _e1286 = (_e1109[0][2] - _e1109[2][2]);
                                                                            let _e1287 = vec3<f32>(_e1284, _e1285, _e1286);
                                                                            let _e1290 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                            let _e1293 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                            let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                            let _e1298 = bitcast<f32>((bitcast<u32>(_e1278) & 2147483647u));
                                                                            let _e1300 = select(_e1298, _e1295, (_e1295 > _e1298));
                                                                            let _e1303 = bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u));
                                                                            let _e1306 = bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u));
                                                                            let _e1308 = select(_e1306, _e1303, (_e1303 > _e1306));
                                                                            let _e1311 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                            let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                            let _e1316 = bitcast<f32>((bitcast<u32>(_e1284) & 2147483647u));
                                                                            let _e1319 = bitcast<f32>((bitcast<u32>(_e1285) & 2147483647u));
                                                                            let _e1321 = select(_e1319, _e1316, (_e1316 > _e1319));
                                                                            let _e1324 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                            let _e1326 = select(_e1324, _e1321, (_e1321 > _e1324));
                                                                            let _e1328 = select(_e1313, _e1300, (_e1300 > _e1313));
                                                                            let _e1330 = select(_e1326, _e1328, (_e1328 > _e1326));
                                                                            if (_e1300 == _e1330) {
                                                                                phi_1673_ = _e1137;
                                                                                phi_1674_ = _e1134;
                                                                                phi_1675_ = _e1124;
                                                                                phi_1676_ = _e1121;
                                                                                phi_1677_ = _e1273;
                                                                                phi_1678_ = _e1287;
                                                                                phi_1679_ = _e1283;
                                                                                phi_1680_ = _e1279;
                                                                            } else {
                                                                                let _e1332 = (_e1313 == _e1330);
                                                                                let _e1337 = vec3(_e1332);
                                                                                phi_1673_ = select(_e1124, _e1150, _e1332);
                                                                                phi_1674_ = select(_e1121, _e1147, _e1332);
                                                                                phi_1675_ = select(_e1150, _e1137, _e1332);
                                                                                phi_1676_ = select(_e1147, _e1134, _e1332);
                                                                                phi_1677_ = select(_e1275, _e1274, _e1337);
                                                                                phi_1678_ = select(_e1283, _e1279, _e1337);
                                                                                phi_1679_ = select(_e1279, _e1287, _e1337);
                                                                                phi_1680_ = select(_e1287, _e1283, _e1337);
                                                                            }
                                                                            let _e1343 = phi_1673_;
                                                                            let _e1345 = phi_1674_;
                                                                            let _e1347 = phi_1675_;
                                                                            let _e1349 = phi_1676_;
                                                                            let _e1351 = phi_1677_;
                                                                            let _e1353 = phi_1678_;
                                                                            let _e1355 = phi_1679_;
                                                                            let _e1357 = phi_1680_;
                                                                            let _e1364 = ((_e1355.y * _e1353.z) - (_e1353.y * _e1355.z));
                                                                            let _e1369 = ((_e1355.z * _e1353.x) - (_e1353.z * _e1355.x));
                                                                            let _e1372 = ((_e1355.x * _e1353.y) - (_e1353.x * _e1355.y));
                                                                            if (_e1172 >= _e1176) {
                                                                                phi_1711_ = select(true, false, (_e1172 >= _e1180));
                                                                            } else {
                                                                                phi_1711_ = true;
                                                                            }
                                                                            let _e1377 = phi_1711_;
                                                                            if _e1377 {
                                                                                phi_1720_ = select(_e1275, _e1274, vec3((_e1176 >= _e1180)));
                                                                            } else {
                                                                                phi_1720_ = _e1273;
                                                                            }
                                                                            let _e1382 = phi_1720_;
                                                                            let _e1393 = (((_e1364 * (_e1382.x - _e299)) + (_e1369 * (_e1382.y - _e336))) + (_e1372 * (_e1382.z - _e372)));
                                                                            let _e1398 = (((_e1364 * _e324) + (_e1369 * _e360)) + (_e1372 * _e396));
                                                                            let _e1399 = (_e1345 - _e1349);
                                                                            let _e1400 = (_e1343 - _e1347);
                                                                            let _e1408 = (-(((_e1349 * _e1399) + (_e1347 * _e1400))) / ((_e1399 * _e1399) + (_e1400 * _e1400)));
                                                                            let _e1410 = select(1f, _e1408, (_e1408 < 1f));
                                                                            let _e1412 = select(0f, _e1410, (_e1410 > 0f));
                                                                            let _e1425 = ((_e1351.x + (_e1357.x * _e1412)) - _e299);
                                                                            let _e1426 = ((_e1351.y + (_e1357.y * _e1412)) - _e336);
                                                                            let _e1427 = ((_e1351.z + (_e1357.z * _e1412)) - _e372);
                                                                            let _e1428 = (_e1427 / _e396);
                                                                            let _e1440 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                            let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                            let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                                            let _e1456 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                            let _e1459 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                            let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1364 * _e1425) + (_e1369 * _e1426)) + (_e1372 * _e1427)) - _e1393)) & 2147483647u)) <= ((0.0000009536743f * select(_e1330, _e1450, (_e1450 > _e1330))) * select(_e1464, _e1461, (_e1461 > _e1464)))) {
                                                                                let _e1474 = bitcast<f32>((bitcast<u32>(_e1355.x) & 2147483647u));
                                                                                let _e1477 = bitcast<f32>((bitcast<u32>(_e1355.y) & 2147483647u));
                                                                                let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                                let _e1482 = bitcast<f32>((bitcast<u32>(_e1355.z) & 2147483647u));
                                                                                let _e1488 = bitcast<f32>((bitcast<u32>(_e1353.x) & 2147483647u));
                                                                                let _e1491 = bitcast<f32>((bitcast<u32>(_e1353.y) & 2147483647u));
                                                                                let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                                                let _e1496 = bitcast<f32>((bitcast<u32>(_e1353.z) & 2147483647u));
                                                                                let _e1500 = (bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u)) > ((0.0000038146973f * select(_e1482, _e1479, (_e1479 > _e1482))) * select(_e1496, _e1493, (_e1493 > _e1496))));
                                                                                if _e1500 {
                                                                                    phi_1885_ = (_e1393 / _e1398);
                                                                                } else {
                                                                                    phi_1885_ = f32();
                                                                                }
                                                                                let _e1503 = phi_1885_;
                                                                                phi_1887_ = _e1503;
                                                                                phi_1888_ = select(true, false, _e1500);
                                                                            } else {
                                                                                phi_1887_ = f32();
                                                                                phi_1888_ = true;
                                                                            }
                                                                            let _e1506 = phi_1887_;
                                                                            let _e1508 = phi_1888_;
                                                                            if _e1508 {
                                                                                let _e1516 = (((_e1364 * (_e1425 - (_e324 * _e1428))) + (_e1369 * (_e1426 - (_e360 * _e1428)))) / _e1398);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u)) <= _e1330) {
                                                                                    phi_1908_ = (_e1428 + _e1516);
                                                                                } else {
                                                                                    phi_1908_ = _e1428;
                                                                                }
                                                                                let _e1523 = phi_1908_;
                                                                                phi_1909_ = _e1523;
                                                                            } else {
                                                                                phi_1909_ = _e1506;
                                                                            }
                                                                            let _e1525 = phi_1909_;
                                                                            let _e1527 = select(_e1263, _e1525, (_e1525 < _e1263));
                                                                            let _e1529 = select(_e1255, _e1527, (_e1527 > _e1255));
                                                                            if (_e1529 >= _e445) {
                                                                                let _e1531 = (_e1529 <= _e1007.member.member_1);
                                                                                if _e1531 {
                                                                                    let _e1532 = (1f / _e1182);
                                                                                    phi_1932_ = type_22(_e1529, (_e1176 * _e1532), (_e1180 * _e1532), _e1042);
                                                                                } else {
                                                                                    phi_1932_ = type_22();
                                                                                }
                                                                                let _e1537 = phi_1932_;
                                                                                phi_1934_ = _e1537;
                                                                                phi_1935_ = select(true, false, _e1531);
                                                                            } else {
                                                                                phi_1934_ = type_22();
                                                                                phi_1935_ = true;
                                                                            }
                                                                            let _e1540 = phi_1934_;
                                                                            let _e1542 = phi_1935_;
                                                                            if _e1542 {
                                                                                phi_1939_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1939_ = _e1540;
                                                                            }
                                                                            let _e1544 = phi_1939_;
                                                                            phi_1940_ = _e1544;
                                                                        }
                                                                        let _e1546 = phi_1940_;
                                                                        phi_1941_ = _e1546;
                                                                        phi_1942_ = _e1272;
                                                                    }
                                                                    let _e1548 = phi_1941_;
                                                                    let _e1550 = phi_1942_;
                                                                    phi_1946_ = _e1548;
                                                                    phi_1947_ = _e1550;
                                                                }
                                                                let _e1552 = phi_1946_;
                                                                let _e1554 = phi_1947_;
                                                                phi_1948_ = _e1552;
                                                                phi_1949_ = _e1207;
                                                                phi_1950_ = _e1554;
                                                            }
                                                            let _e1556 = phi_1948_;
                                                            let _e1558 = phi_1949_;
                                                            let _e1560 = phi_1950_;
                                                            phi_1951_ = _e1556;
                                                            phi_1952_ = _e1558;
                                                            phi_1953_ = _e1560;
                                                        }
                                                        let _e1562 = phi_1951_;
                                                        let _e1564 = phi_1952_;
                                                        let _e1566 = phi_1953_;
                                                        phi_1961_ = _e1562;
                                                        phi_1962_ = select(_e1566, true, _e1564);
                                                    } else {
                                                        phi_1961_ = type_22();
                                                        phi_1962_ = true;
                                                    }
                                                    let _e1569 = phi_1961_;
                                                    let _e1571 = phi_1962_;
                                                    if _e1571 {
                                                        phi_1966_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1966_ = _e1569;
                                                    }
                                                    let _e1573 = phi_1966_;
                                                    if (_e1573.member_3 != 4294967295u) {
                                                        if (_e1042 != _e451) {
                                                            if (_e1573.member < _e1007.member.member.member) {
                                                                phi_1992_ = true;
                                                            } else {
                                                                if (_e1573.member == _e1007.member.member.member) {
                                                                    phi_1991_ = (_e1573.member_3 < _e1007.member.member.member_3);
                                                                } else {
                                                                    phi_1991_ = false;
                                                                }
                                                                let _e1588 = phi_1991_;
                                                                phi_1992_ = _e1588;
                                                            }
                                                            let _e1590 = phi_1992_;
                                                            if _e1590 {
                                                                phi_1999_ = type_42(type_38(_e1573, _e1573.member), _e1034.member_1, _e1034.member_2);
                                                            } else {
                                                                phi_1999_ = _e1034;
                                                            }
                                                            let _e1597 = phi_1999_;
                                                            phi_2000_ = _e1597;
                                                        } else {
                                                            phi_2000_ = _e1034;
                                                        }
                                                        let _e1599 = phi_2000_;
                                                        phi_2001_ = _e1599;
                                                    } else {
                                                        phi_2001_ = _e1034;
                                                    }
                                                    let _e1601 = phi_2001_;
                                                    phi_988_ = _e1601;
                                                } else {
                                                    phi_988_ = type_42();
                                                }
                                                let _e1603 = phi_988_;
                                                continue;
                                                continuing {
                                                    phi_987_ = _e1603;
                                                    phi_990_ = _e1022;
                                                    phi_3586_ = _e492;
                                                    break if !(_e1028);
                                                }
                                            }
                                            let _e1606 = phi_3586_;
                                            phi_3728_ = _e1606;
                                            if _e1606 {
                                                break;
                                            }
                                            phi_3732_ = _e1606;
                                            let _e1842 = local_12;
                                            phi_3209_ = _e1842;
                                            phi_3210_ = _e534;
                                            phi_3211_ = false;
                                            phi_3212_ = _e538;
                                        } else {
                                            if (_e534.member_1 >= _e87) {
                                                phi_2765_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e534.member_1 < _e87) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e555 = (_e267 * 2u);
                                                let _e557 = ((1u + _e555) % 7u);
                                                if (_e557 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e562 = global_7.member[_e534.member_1][_e557];
                                                let _e564 = ((_e555 + 2u) % 7u);
                                                if (_e564 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e569 = global_7.member[_e534.member_1][_e564];
                                                let _e570 = (_e266 * 2u);
                                                let _e572 = ((1u + _e570) % 7u);
                                                if (_e572 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e577 = global_7.member[_e534.member_1][_e572];
                                                let _e579 = ((_e570 + 2u) % 7u);
                                                if (_e579 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e584 = global_7.member[_e534.member_1][_e579];
                                                let _e585 = (_e268 * 2u);
                                                let _e587 = ((1u + _e585) % 7u);
                                                if (_e587 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e592 = global_7.member[_e534.member_1][_e587];
                                                let _e594 = ((_e585 + 2u) % 7u);
                                                if (_e594 < 7u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e599 = global_7.member[_e534.member_1][_e594];
                                                let _e622 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.x - _e534.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e623 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.y - _e534.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e624 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.z - _e534.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e626 = select(_e141, _e622, (_e622 > _e141));
                                                let _e628 = select(_e141, _e623, (_e623 > _e141));
                                                let _e630 = select(_e141, _e624, (_e624 > _e141));
                                                let _e655 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e626));
                                                let _e660 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                                let _e664 = bitcast<u32>((f32(bitcast<i32>((_e577 & 2097151u))) * _e628));
                                                let _e669 = (bitcast<i32>((_e577 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                                let _e673 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e630));
                                                let _e678 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                                let _e685 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                                let _e689 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                                let _e693 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                                let _e694 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e626));
                                                let _e699 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                                let _e703 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e628));
                                                let _e708 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                                let _e712 = bitcast<u32>((f32(bitcast<i32>((_e599 & 2097151u))) * _e630));
                                                let _e717 = (bitcast<i32>((_e599 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                                let _e724 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                                let _e728 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                                let _e732 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                                let _e762 = global_7.member[_e534.member_1][0u];
                                                let _e766 = global_7.member[_e534.member_1][2u];
                                                let _e770 = global_7.member[_e534.member_1][4u];
                                                let _e774 = global_7.member[_e534.member_1][6u];
                                                let _e786 = (((_e766 >> bitcast<u32>(22i)) | ((_e770 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e774 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e787 = (_e762 & 268435455u);
                                                let _e788 = (_e786 & 268435455u);
                                                let _e791 = ((_e762 >> bitcast<u32>(28u)) & 7u);
                                                let _e799 = ((_e762 >> bitcast<u32>(31i)) | (((_e786 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e800 = (_e791 != 0u);
                                                if (_e791 == 0u) {
                                                    phi_2727_ = _e787;
                                                } else {
                                                    if (_e791 == 7u) {
                                                        phi_2726_ = 2147483648u;
                                                    } else {
                                                        phi_2726_ = ((2147483648u | (_e791 << bitcast<u32>(28u))) | (_e788 & 268435455u));
                                                    }
                                                    let _e809 = phi_2726_;
                                                    phi_2727_ = _e809;
                                                }
                                                let _e811 = phi_2727_;
                                                if _e800 {
                                                    let _e812 = (_e791 != 7u);
                                                    if _e812 {
                                                        phi_2737_ = (_e788 + _e791);
                                                    } else {
                                                        phi_2737_ = u32();
                                                    }
                                                    let _e815 = phi_2737_;
                                                    phi_2739_ = _e815;
                                                    phi_2740_ = select(true, false, _e812);
                                                } else {
                                                    phi_2739_ = u32();
                                                    phi_2740_ = true;
                                                }
                                                let _e818 = phi_2739_;
                                                let _e820 = phi_2740_;
                                                if (_e799 == 0u) {
                                                    phi_2761_ = (_e787 + select(0u, 1u, !(_e800)));
                                                } else {
                                                    if (_e799 == 7u) {
                                                        phi_2760_ = 2147483648u;
                                                    } else {
                                                        phi_2760_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (select(_e818, _e788, _e820) & 268435455u));
                                                    }
                                                    let _e833 = phi_2760_;
                                                    phi_2761_ = _e833;
                                                }
                                                let _e835 = phi_2761_;
                                                phi_2765_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e534.member.member.x + _e663), (_e534.member.member.x + _e685), (_e534.member.member_1.x - _e702), (_e534.member.member_1.x - _e724)), vec4<f32>((_e534.member.member.y + _e672), (_e534.member.member.y + _e689), (_e534.member.member_1.y - _e711), (_e534.member.member_1.y - _e728)), vec4<f32>((_e534.member.member.z + _e681), (_e534.member.member.z + _e693), (_e534.member.member_1.z - _e720), (_e534.member.member_1.z - _e732))), type_53(type_34((_e534.member.member + vec4<f32>(_e663, _e672, _e681, 0f)), (_e534.member.member_1 - vec4<f32>(_e702, _e711, _e720, 0f))), _e811), type_53(type_34((_e534.member.member + vec4<f32>(_e685, _e689, _e693, 0f)), (_e534.member.member_1 - vec4<f32>(_e724, _e728, _e732, 0f))), _e835));
                                            }
                                            let _e840 = phi_2765_;
                                            let _e853 = ((_e840.member[0].x - _e322) * _e327);
                                            let _e854 = ((_e840.member[0].y - _e322) * _e327);
                                            let _e855 = ((_e840.member[0].z - _e323) * _e327);
                                            let _e856 = ((_e840.member[0].w - _e323) * _e327);
                                            let _e866 = ((_e840.member[1].x - _e358) * _e363);
                                            let _e867 = ((_e840.member[1].y - _e358) * _e363);
                                            let _e868 = ((_e840.member[1].z - _e359) * _e363);
                                            let _e869 = ((_e840.member[1].w - _e359) * _e363);
                                            let _e879 = ((_e840.member[2].x - _e394) * _e399);
                                            let _e880 = ((_e840.member[2].y - _e394) * _e399);
                                            let _e881 = ((_e840.member[2].z - _e395) * _e399);
                                            let _e882 = ((_e840.member[2].w - _e395) * _e399);
                                            let _e884 = select(_e881, _e879, (_e879 < _e881));
                                            let _e886 = select(_e882, _e880, (_e880 < _e882));
                                            let _e888 = select(_e881, _e879, (_e879 > _e881));
                                            let _e890 = select(_e882, _e880, (_e880 > _e882));
                                            let _e892 = select(_e855, _e853, (_e853 < _e855));
                                            let _e894 = select(_e856, _e854, (_e854 < _e856));
                                            let _e896 = select(_e868, _e866, (_e866 < _e868));
                                            let _e898 = select(_e869, _e867, (_e867 < _e869));
                                            let _e900 = select(_e896, _e892, (_e892 > _e896));
                                            let _e902 = select(_e898, _e894, (_e894 > _e898));
                                            let _e904 = select(_e884, _e900, (_e900 > _e884));
                                            let _e906 = select(_e886, _e902, (_e902 > _e886));
                                            let _e908 = select(_e855, _e853, (_e853 > _e855));
                                            let _e910 = select(_e856, _e854, (_e854 > _e856));
                                            let _e912 = select(_e868, _e866, (_e866 > _e868));
                                            let _e914 = select(_e869, _e867, (_e867 > _e869));
                                            let _e916 = select(_e912, _e908, (_e908 < _e912));
                                            let _e918 = select(_e914, _e910, (_e910 < _e914));
                                            let _e923 = -(_e884);
                                            let _e924 = -(_e886);
                                            let _e931 = (select(_e888, _e916, (_e916 < _e888)) + (select(_e923, _e888, (_e888 > _e923)) * 0.0000019073523f));
                                            let _e932 = (select(_e890, _e918, (_e918 < _e890)) + (select(_e924, _e890, (_e890 > _e924)) * 0.0000019073523f));
                                            let _e934 = select(_e445, _e904, (_e904 > _e445));
                                            let _e936 = select(_e445, _e906, (_e906 > _e445));
                                            let _e941 = (_e934 <= select(_e494.member.member_1, _e931, (_e931 < _e494.member.member_1)));
                                            let _e942 = (_e936 <= select(_e494.member.member_1, _e932, (_e932 < _e494.member.member_1)));
                                            let _e943 = (_e934 <= _e936);
                                            if _e941 {
                                                if _e942 {
                                                    if _e943 {
                                                        phi_3109_ = _e840.member_2;
                                                    } else {
                                                        phi_3109_ = _e840.member_1;
                                                    }
                                                    let _e947 = phi_3109_;
                                                    let _e969 = (_e538 % 128u);
                                                    let _e970 = (_e969 < 128u);
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_8[_e969] = _e947.member_1;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_7[_e969] = _e947.member.member.x;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_6[_e969] = _e947.member.member.y;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_5[_e969] = _e947.member.member.z;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_4[_e969] = _e947.member.member_1.x;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_3[_e969] = _e947.member.member_1.y;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_2[_e969] = _e947.member.member_1.z;
                                                    if _e970 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_9[_e969] = select(_e936, _e934, (_e934 > _e936));
                                                    if _e943 {
                                                        phi_3186_ = _e840.member_1;
                                                    } else {
                                                        phi_3186_ = _e840.member_2;
                                                    }
                                                    let _e983 = phi_3186_;
                                                    phi_3187_ = _e983;
                                                    phi_3188_ = (_e538 + 1u);
                                                } else {
                                                    phi_3187_ = type_53();
                                                    phi_3188_ = u32();
                                                }
                                                let _e985 = phi_3187_;
                                                let _e987 = phi_3188_;
                                                phi_3190_ = _e985;
                                                phi_3191_ = _e987;
                                                phi_3192_ = select(true, false, _e942);
                                            } else {
                                                phi_3190_ = type_53();
                                                phi_3191_ = u32();
                                                phi_3192_ = true;
                                            }
                                            let _e990 = phi_3190_;
                                            let _e992 = phi_3191_;
                                            let _e994 = phi_3192_;
                                            if _e994 {
                                                if _e941 {
                                                    phi_3201_ = _e840.member_1;
                                                } else {
                                                    phi_3201_ = _e840.member_2;
                                                }
                                                let _e998 = phi_3201_;
                                                phi_3206_ = _e998;
                                                phi_3207_ = select(_e942, true, _e941);
                                            } else {
                                                phi_3206_ = _e990;
                                                phi_3207_ = _e536;
                                            }
                                            let _e1001 = phi_3206_;
                                            let _e1003 = phi_3207_;
                                            phi_3732_ = _e492;
                                            phi_3209_ = type_42(_e494.member, (_e494.member_1 + 1u), _e494.member_2);
                                            phi_3210_ = _e1001;
                                            phi_3211_ = _e1003;
                                            phi_3212_ = select(_e992, _e538, _e994);
                                        }
                                        let _e1608 = phi_3732_;
                                        let _e1610 = phi_3209_;
                                        let _e1612 = phi_3210_;
                                        let _e1614 = phi_3211_;
                                        let _e1616 = phi_3212_;
                                        phi_3731_ = _e1608;
                                        phi_3213_ = _e1610;
                                        phi_3214_ = _e1612;
                                        phi_3215_ = (_e498 - 1u);
                                        phi_3216_ = _e1614;
                                        phi_3217_ = _e1616;
                                    } else {
                                        phi_3731_ = _e492;
                                        phi_3213_ = _e494;
                                        phi_3214_ = _e534;
                                        phi_3215_ = _e498;
                                        phi_3216_ = _e536;
                                        phi_3217_ = _e538;
                                    }
                                    let _e1618 = phi_3731_;
                                    let _e1620 = phi_3213_;
                                    let _e1622 = phi_3214_;
                                    let _e1624 = phi_3215_;
                                    let _e1626 = phi_3216_;
                                    let _e1628 = phi_3217_;
                                    phi_3730_ = _e1618;
                                    phi_3218_ = _e1620;
                                    phi_3219_ = _e1622;
                                    phi_3220_ = _e1624;
                                    phi_3221_ = _e1626;
                                    phi_3222_ = _e1628;
                                } else {
                                    phi_3730_ = _e492;
                                    phi_3218_ = type_42();
                                    phi_3219_ = type_53();
                                    phi_3220_ = u32();
                                    phi_3221_ = bool();
                                    phi_3222_ = u32();
                                }
                                let _e1630 = phi_3730_;
                                let _e1632 = phi_3218_;
                                let _e1634 = phi_3219_;
                                let _e1636 = phi_3220_;
                                let _e1638 = phi_3221_;
                                let _e1640 = phi_3222_;
                                phi_3729_ = _e1630;
                                phi_862_ = _e1632;
                                phi_865_ = _e1634;
                                phi_867_ = _e1636;
                                phi_869_ = _e1638;
                                phi_871_ = _e1640;
                                phi_3223_ = _e506;
                            } else {
                                phi_3729_ = _e492;
                                phi_862_ = type_42();
                                phi_865_ = type_53();
                                phi_867_ = u32();
                                phi_869_ = bool();
                                phi_871_ = u32();
                                phi_3223_ = false;
                            }
                            let _e1642 = phi_3729_;
                            let _e1644 = phi_862_;
                            let _e1646 = phi_865_;
                            let _e1648 = phi_867_;
                            let _e1650 = phi_869_;
                            let _e1652 = phi_871_;
                            let _e1654 = phi_3223_;
                            continue;
                            continuing {
                                phi_3592_ = _e1642;
                                phi_861_ = _e1644;
                                phi_864_ = _e1646;
                                phi_866_ = _e1648;
                                phi_868_ = _e1650;
                                phi_870_ = _e1652;
                                phi_3728_ = _e1642;
                                break if !(_e1654);
                            }
                        }
                        let _e1657 = phi_3728_;
                        if _e1657 {
                            break;
                        }
                        let _e1659 = local_10;
                        if (_e1659.member.member.member_3 != 4294967295u) {
                            let _e1665 = (_e269 / 3i);
                            let _e1672 = bitcast<f32>((bitcast<u32>((_e1665 + 127i)) << bitcast<u32>(23i)));
                            let _e1680 = (((_e1659.member.member.member * _e1672) * _e1672) * bitcast<f32>((bitcast<u32>(((_e269 - (2i * _e1665)) + 127i)) << bitcast<u32>(23i))));
                            let _e1682 = select(340282350000000000000000000000000000000f, _e1680, (_e1680 < 340282350000000000000000000000000000000f));
                            phi_3275_ = type_22(select(-340282350000000000000000000000000000000f, _e1682, (_e1682 > -340282350000000000000000000000000000000f)), _e1659.member.member.member_1, _e1659.member.member.member_2, _e1659.member.member.member_3);
                        } else {
                            phi_3275_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1689 = phi_3275_;
                        if _e145 {
                        } else {
                            break;
                        }
                        global_2.member[_e129] = _e1689;
                        let _e1693 = local_11;
                        if _e146 {
                        } else {
                            break;
                        }
                        global_5.member[_e129] = _e1693.member_1;
                        if _e144 {
                        } else {
                            break;
                        }
                        let _e1698 = select(0u, 1u, (_e213 <= _e223));
                        if (_e1698 > 0u) {
                            let _e1700 = (1u < _e97);
                            if _e1700 {
                                if (0u < _e97) {
                                } else {
                                    break;
                                }
                                let _e1704 = atomicAdd((&global_6.member[0u]), _e1698);
                                if ((_e1704 + _e1698) < _e1704) {
                                    if _e1700 {
                                    } else {
                                        break;
                                    }
                                    let _e1709 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1712 = select(0u, 1u, (_e1689.member_3 != 4294967295u));
                        if (_e1712 > 0u) {
                            let _e1714 = (3u < _e97);
                            if _e1714 {
                                if (2u < _e97) {
                                } else {
                                    break;
                                }
                                let _e1718 = atomicAdd((&global_6.member[2u]), _e1712);
                                if ((_e1718 + _e1712) < _e1718) {
                                    if _e1714 {
                                    } else {
                                        break;
                                    }
                                    let _e1723 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1693.member_1 > 0u) {
                            let _e1725 = (5u < _e97);
                            if _e1725 {
                                if (4u < _e97) {
                                } else {
                                    break;
                                }
                                let _e1729 = atomicAdd((&global_6.member[4u]), _e1693.member_1);
                                if ((_e1729 + _e1693.member_1) < _e1729) {
                                    if _e1725 {
                                    } else {
                                        break;
                                    }
                                    let _e1734 = atomicAdd((&global_6.member[5u]), 1u);
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
