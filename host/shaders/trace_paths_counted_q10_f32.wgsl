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
    var phi_861_: type_46;
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
    var phi_987_: type_46;
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
    var phi_1932_: type_26;
    var phi_1934_: type_26;
    var phi_1935_: bool;
    var phi_1939_: type_26;
    var phi_1940_: type_26;
    var phi_1941_: type_26;
    var phi_1942_: bool;
    var phi_1946_: type_26;
    var phi_1947_: bool;
    var phi_1948_: type_26;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1951_: type_26;
    var phi_1952_: bool;
    var phi_1953_: bool;
    var phi_1961_: type_26;
    var phi_1962_: bool;
    var phi_1966_: type_26;
    var phi_1991_: bool;
    var phi_1992_: bool;
    var phi_1999_: type_46;
    var phi_2000_: type_46;
    var phi_2001_: type_46;
    var phi_988_: type_46;
    var phi_3586_: bool;
    var phi_3732_: bool;
    var phi_3209_: type_46;
    var phi_3210_: type_53;
    var phi_3211_: bool;
    var phi_3212_: u32;
    var phi_3731_: bool;
    var phi_3213_: type_46;
    var phi_3214_: type_53;
    var phi_3215_: u32;
    var phi_3216_: bool;
    var phi_3217_: u32;
    var phi_3730_: bool;
    var phi_3218_: type_46;
    var phi_3219_: type_53;
    var phi_3220_: u32;
    var phi_3221_: bool;
    var phi_3222_: u32;
    var phi_3729_: bool;
    var phi_862_: type_46;
    var phi_865_: type_53;
    var phi_867_: u32;
    var phi_869_: bool;
    var phi_871_: u32;
    var phi_3223_: bool;
    var phi_3728_: bool;
    var local_10: type_46;
    var phi_3275_: type_26;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e91 = arrayLength((&global_1.member));
            let _e99 = arrayLength((&global_7.member));
            let _e103 = global_3.member[0u][0u];
            let _e107 = global_3.member[0u][1u];
            let _e111 = global_3.member[0u][2u];
            let _e115 = global_3.member[0u][3u];
            let _e119 = global_3.member[1u][0u];
            let _e123 = global_3.member[1u][1u];
            let _e127 = global_3.member[1u][2u];
            let _e131 = (_e87.x + (_e87.y * 2097152u));
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e146 = (_e131 < arrayLength((&global_5.member)));
            if _e146 {
                let _e147 = (_e131 < arrayLength((&global_2.member)));
                if _e147 {
                    let _e148 = (_e131 < arrayLength((&global_6.member)));
                    if _e148 {
                        if _e146 {
                        } else {
                            break;
                        }
                        let _e158 = global_5.member[_e131].member.member_2[0u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_5.member[_e131].member.member_2[1u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_5.member[_e131].member.member_2[2u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_5.member[_e131].member.member[0u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e190 = global_5.member[_e131].member.member[1u];
                        let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                        let _e198 = global_5.member[_e131].member.member[2u];
                        let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                        let _e202 = select(_e168, _e160, (_e168 < _e160));
                        let _e204 = select(_e176, _e202, (_e176 < _e202));
                        let _e206 = select(_e184, _e204, (_e184 < _e204));
                        let _e208 = select(_e192, _e206, (_e192 < _e206));
                        let _e210 = select(_e200, _e208, (_e200 < _e208));
                        let _e215 = global_5.member[_e131].member.member_1;
                        let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                        let _e225 = global_5.member[_e131].member.member_3;
                        let _e231 = (((select(_e217, _e210, (_e217 < _e210)) < 2139095040u) && ((bitcast<u32>(_e225) & 2147483647u) <= 2139095040u)) && (_e204 > 0u));
                        if _e231 {
                            let _e234 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                            if (_e234 >= 8388608u) {
                                phi_394_ = (bitcast<i32>((_e234 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_394_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e234)), 32u, (_e234 == 0u))));
                            }
                            let _e248 = phi_394_;
                            phi_395_ = _e248;
                        } else {
                            phi_395_ = 0i;
                        }
                        let _e250 = phi_395_;
                        let _e251 = (_e160 == _e204);
                        if _e251 {
                            phi_405_ = true;
                        } else {
                            phi_405_ = (_e168 == _e204);
                        }
                        let _e254 = phi_405_;
                        let _e255 = select(1u, 0u, _e251);
                        if _e254 {
                            let _e256 = (_e255 + 1u);
                            phi_415_ = _e256;
                            phi_416_ = _e256;
                            phi_418_ = select(true, false, (_e256 == 2u));
                        } else {
                            phi_415_ = u32();
                            phi_416_ = 0u;
                            phi_418_ = true;
                        }
                        let _e260 = phi_415_;
                        let _e262 = phi_416_;
                        let _e264 = phi_418_;
                        if _e264 {
                            phi_423_ = (_e262 + 1u);
                        } else {
                            phi_423_ = 0u;
                        }
                        let _e268 = phi_423_;
                        let _e269 = select(_e260, _e262, _e264);
                        let _e270 = select(_e255, select(2u, _e255, _e254), _e264);
                        let _e271 = -(_e250);
                        if (_e271 < -126i) {
                            phi_455_ = -126i;
                        } else {
                            phi_455_ = select(_e271, 127i, (_e271 > 127i));
                        }
                        let _e276 = phi_455_;
                        let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                        let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                        let _e292 = global_5.member[_e131].member.member;
                        let _e293 = (_e269 == 0u);
                        if _e293 {
                            phi_473_ = _e292[0];
                        } else {
                            phi_473_ = _e292[1];
                        }
                        let _e297 = phi_473_;
                        let _e298 = (_e269 == 2u);
                        if _e298 {
                            phi_479_ = _e292[2];
                        } else {
                            phi_479_ = _e297;
                        }
                        let _e301 = phi_479_;
                        let _e302 = global_5.member[_e131].member.member_2;
                        if _e293 {
                            phi_490_ = _e302[0];
                        } else {
                            phi_490_ = _e302[1];
                        }
                        let _e306 = phi_490_;
                        if _e298 {
                            phi_496_ = _e302[2];
                        } else {
                            phi_496_ = _e306;
                        }
                        let _e309 = phi_496_;
                        let _e311 = ((_e309 * _e281) * _e287);
                        let _e315 = (bitcast<f32>((bitcast<u32>(_e311) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e315 {
                            let _e319 = (bitcast<f32>((bitcast<u32>(_e301) & 2147483647u)) * 0.00000011920929f);
                            phi_519_ = select(0.00000000000011368684f, _e319, (_e319 > 0.00000000000011368684f));
                        } else {
                            phi_519_ = 0f;
                        }
                        let _e323 = phi_519_;
                        let _e324 = (_e301 + _e323);
                        let _e325 = (_e301 - _e323);
                        let _e326 = select(_e311, 0f, _e315);
                        if _e315 {
                            phi_530_ = 38685626000000000000000000f;
                        } else {
                            phi_530_ = (1f / _e311);
                        }
                        let _e329 = phi_530_;
                        let _e330 = (_e268 == 0u);
                        if _e330 {
                            phi_539_ = _e292[0];
                        } else {
                            phi_539_ = _e292[1];
                        }
                        let _e334 = phi_539_;
                        let _e335 = (_e268 == 2u);
                        if _e335 {
                            phi_545_ = _e292[2];
                        } else {
                            phi_545_ = _e334;
                        }
                        let _e338 = phi_545_;
                        if _e330 {
                            phi_556_ = _e302[0];
                        } else {
                            phi_556_ = _e302[1];
                        }
                        let _e342 = phi_556_;
                        if _e335 {
                            phi_562_ = _e302[2];
                        } else {
                            phi_562_ = _e342;
                        }
                        let _e345 = phi_562_;
                        let _e347 = ((_e345 * _e281) * _e287);
                        let _e351 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e351 {
                            let _e355 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) * 0.00000011920929f);
                            phi_585_ = select(0.00000000000011368684f, _e355, (_e355 > 0.00000000000011368684f));
                        } else {
                            phi_585_ = 0f;
                        }
                        let _e359 = phi_585_;
                        let _e360 = (_e338 + _e359);
                        let _e361 = (_e338 - _e359);
                        let _e362 = select(_e347, 0f, _e351);
                        if _e351 {
                            phi_596_ = 38685626000000000000000000f;
                        } else {
                            phi_596_ = (1f / _e347);
                        }
                        let _e365 = phi_596_;
                        let _e366 = (_e270 == 0u);
                        if _e366 {
                            phi_605_ = _e292[0];
                        } else {
                            phi_605_ = _e292[1];
                        }
                        let _e370 = phi_605_;
                        let _e371 = (_e270 == 2u);
                        if _e371 {
                            phi_611_ = _e292[2];
                        } else {
                            phi_611_ = _e370;
                        }
                        let _e374 = phi_611_;
                        if _e366 {
                            phi_622_ = _e302[0];
                        } else {
                            phi_622_ = _e302[1];
                        }
                        let _e378 = phi_622_;
                        if _e371 {
                            phi_628_ = _e302[2];
                        } else {
                            phi_628_ = _e378;
                        }
                        let _e381 = phi_628_;
                        let _e383 = ((_e381 * _e281) * _e287);
                        let _e387 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e387 {
                            let _e391 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) * 0.00000011920929f);
                            phi_651_ = select(0.00000000000011368684f, _e391, (_e391 > 0.00000000000011368684f));
                        } else {
                            phi_651_ = 0f;
                        }
                        let _e395 = phi_651_;
                        let _e396 = (_e374 + _e395);
                        let _e397 = (_e374 - _e395);
                        let _e398 = select(_e383, 0f, _e387);
                        if _e387 {
                            phi_662_ = 38685626000000000000000000f;
                        } else {
                            phi_662_ = (1f / _e383);
                        }
                        let _e401 = phi_662_;
                        let _e404 = bitcast<f32>((bitcast<u32>(_e301) & 2147483647u));
                        let _e407 = bitcast<f32>((bitcast<u32>(_e338) & 2147483647u));
                        let _e409 = select(_e407, _e404, (_e404 > _e407));
                        let _e412 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                        if (_e231 && (select(_e412, _e409, (_e409 > _e412)) <= 1099511600000f)) {
                            let _e417 = (_e250 / 3i);
                            let _e424 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                            let _e431 = bitcast<f32>((bitcast<u32>(((_e250 - (2i * _e417)) + 127i)) << bitcast<u32>(23i)));
                            let _e432 = (((_e215 * _e424) * _e424) * _e431);
                            let _e434 = select(340282350000000000000000000000000000000f, _e432, (_e432 < 340282350000000000000000000000000000000f));
                            let _e439 = (((_e225 * _e424) * _e424) * _e431);
                            let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                            phi_762_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                            phi_763_ = select(-340282350000000000000000000000000000000f, _e434, (_e434 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_762_ = 0f;
                            phi_763_ = 1f;
                        }
                        let _e445 = phi_762_;
                        let _e447 = phi_763_;
                        if _e146 {
                        } else {
                            break;
                        }
                        let _e453 = global_5.member[_e131].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e456 = (_e269 % 3u);
                        let _e457 = (_e456 < 3u);
                        if _e457 {
                        } else {
                            break;
                        }
                        let _e459 = local_1[_e456];
                        let _e462 = (_e268 % 3u);
                        let _e463 = (_e462 < 3u);
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e465 = local_1[_e462];
                        let _e468 = (_e270 % 3u);
                        let _e469 = (_e468 < 3u);
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e471 = local_1[_e468];
                        if _e457 {
                        } else {
                            break;
                        }
                        let _e476 = local[_e456];
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e480 = local[_e462];
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e484 = local[_e468];
                        phi_3592_ = false;
                        phi_861_ = type_46(type_42(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e445), 0u, 0u);
                        phi_864_ = type_53(type_38(vec4<f32>((f32(_e459) * _e143), (f32(_e465) * _e143), (f32(_e471) * _e143), 0f), vec4<f32>((f32(_e476) * _e143), (f32(_e480) * _e143), (f32(_e484) * _e143), 0f)), select(0u, 2147483648u, (_e89 == 0u)));
                        phi_866_ = ((3u * _e89) + 1u);
                        phi_868_ = (_e447 <= _e445);
                        phi_870_ = 0u;
                        loop {
                            let _e494 = phi_3592_;
                            let _e496 = phi_861_;
                            let _e498 = phi_864_;
                            let _e500 = phi_866_;
                            let _e502 = phi_868_;
                            let _e504 = phi_870_;
                            local_10 = _e496;
                            local_11 = _e496;
                            if _e502 {
                                phi_881_ = true;
                            } else {
                                phi_881_ = (_e504 > 0u);
                            }
                            let _e507 = phi_881_;
                            if _e507 {
                                let _e508 = (_e500 > 0u);
                                if _e508 {
                                    if _e502 {
                                        phi_967_ = _e498;
                                        phi_968_ = _e502;
                                        phi_969_ = _e504;
                                    } else {
                                        let _e509 = (_e504 - 1u);
                                        let _e510 = (_e509 % 128u);
                                        let _e511 = (_e510 < 128u);
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e513 = local_7[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e515 = local_6[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e517 = local_5[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e519 = local_4[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e521 = local_3[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e523 = local_2[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e528 = local_8[_e510];
                                        if _e511 {
                                        } else {
                                            phi_3728_ = true;
                                            break;
                                        }
                                        let _e531 = local_9[_e510];
                                        phi_967_ = type_53(type_38(vec4<f32>(_e513, _e515, _e517, 0f), vec4<f32>(_e519, _e521, _e523, 0f)), _e528);
                                        phi_968_ = (_e531 <= _e496.member.member_1);
                                        phi_969_ = _e509;
                                    }
                                    let _e536 = phi_967_;
                                    let _e538 = phi_968_;
                                    let _e540 = phi_969_;
                                    if _e538 {
                                        if ((_e536.member_1 & 2147483648u) != 0u) {
                                            phi_987_ = _e496;
                                            phi_990_ = type_7(0u, ((_e536.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e991 = phi_987_;
                                                let _e993 = phi_990_;
                                                local_12 = _e991;
                                                if (_e993.member < _e993.member_1) {
                                                    phi_991_ = type_7((_e993.member + 1u), _e993.member_1);
                                                    phi_1013_ = type_7(1u, _e993.member);
                                                } else {
                                                    phi_991_ = _e993;
                                                    phi_1013_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1006 = phi_991_;
                                                let _e1008 = phi_1013_;
                                                let _e1012 = (bitcast<i32>(_e1008.member) != 0i);
                                                if _e1012 {
                                                    let _e1018 = type_46(_e991.member, _e991.member_1, (_e991.member_2 + 1u));
                                                    let _e1019 = ((_e536.member_1 & 268435455u) + _e1008.member_1);
                                                    let _e1020 = (_e1019 < _e91);
                                                    if _e1020 {
                                                        if _e1020 {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1024 = global_1.member[_e1019].member_1;
                                                        phi_1037_ = _e1024;
                                                    } else {
                                                        phi_1037_ = 4294967295u;
                                                    }
                                                    let _e1026 = phi_1037_;
                                                    if (_e1019 >= _e91) {
                                                        phi_1126_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1020 {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        if (_e456 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1033 = global_1.member[_e1019].member[_e456];
                                                        if (_e462 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1039 = global_1.member[_e1019].member[_e462];
                                                        if (_e468 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1045 = global_1.member[_e1019].member[_e468];
                                                        let _e1047 = (3u + _e456);
                                                        if (_e1047 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1053 = global_1.member[_e1019].member[_e1047];
                                                        let _e1054 = (3u + _e462);
                                                        if (_e1054 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1060 = global_1.member[_e1019].member[_e1054];
                                                        let _e1061 = (3u + _e468);
                                                        if (_e1061 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1067 = global_1.member[_e1019].member[_e1061];
                                                        let _e1069 = (6u + _e456);
                                                        if (_e1069 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1075 = global_1.member[_e1019].member[_e1069];
                                                        let _e1076 = (6u + _e462);
                                                        if (_e1076 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1082 = global_1.member[_e1019].member[_e1076];
                                                        let _e1083 = (6u + _e468);
                                                        if (_e1083 < 9u) {
                                                        } else {
                                                            phi_3586_ = true;
                                                            break;
                                                        }
                                                        let _e1089 = global_1.member[_e1019].member[_e1083];
                                                        phi_1126_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1033, _e1039, _e1045), array<f32, 3>(_e1053, _e1060, _e1067), array<f32, 3>(_e1075, _e1082, _e1089));
                                                    }
                                                    let _e1093 = phi_1126_;
                                                    let _e1102 = (_e1093[0][2] - _e374);
                                                    let _e1105 = (((_e1093[0][0] - _e301) * _e398) - (_e1102 * _e326));
                                                    let _e1108 = (((_e1093[0][1] - _e338) * _e398) - (_e1102 * _e362));
                                                    let _e1115 = (_e1093[1][2] - _e374);
                                                    let _e1118 = (((_e1093[1][0] - _e301) * _e398) - (_e1115 * _e326));
                                                    let _e1121 = (((_e1093[1][1] - _e338) * _e398) - (_e1115 * _e362));
                                                    let _e1128 = (_e1093[2][2] - _e374);
                                                    let _e1131 = (((_e1093[2][0] - _e301) * _e398) - (_e1128 * _e326));
                                                    let _e1134 = (((_e1093[2][1] - _e338) * _e398) - (_e1128 * _e362));
                                                    let _e1135 = (_e1131 * _e1121);
                                                    let _e1136 = (_e1134 * _e1118);
                                                    let _e1137 = (_e1105 * _e1134);
                                                    let _e1138 = (_e1108 * _e1131);
                                                    let _e1139 = (_e1118 * _e1108);
                                                    let _e1140 = (_e1121 * _e1105);
                                                    let _e1145 = (((_e1135 >= _e1136) && (_e1137 >= _e1138)) && (_e1139 >= _e1140));
                                                    if (_e1145 || (((_e1135 <= _e1136) && (_e1137 <= _e1138)) && (_e1139 <= _e1140))) {
                                                        let _e1152 = select(-1f, 1f, _e1145);
                                                        let _e1154 = ((_e1135 - _e1136) * _e1152);
                                                        let _e1156 = select(0f, _e1154, (_e1154 > 0f));
                                                        let _e1158 = ((_e1137 - _e1138) * _e1152);
                                                        let _e1160 = select(0f, _e1158, (_e1158 > 0f));
                                                        let _e1162 = ((_e1139 - _e1140) * _e1152);
                                                        let _e1164 = select(0f, _e1162, (_e1162 > 0f));
                                                        let _e1166 = ((_e1156 + _e1160) + _e1164);
                                                        if (_e1166 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1951_ = type_26();
                                                            phi_1952_ = true;
                                                            phi_1953_ = false;
                                                        } else {
                                                            let _e1169 = select(_e1118, _e1105, (_e1105 < _e1118));
                                                            if (select(_e1131, _e1169, (_e1169 < _e1131)) > 0f) {
                                                                phi_1243_ = true;
                                                            } else {
                                                                let _e1174 = select(_e1118, _e1105, (_e1105 > _e1118));
                                                                phi_1243_ = (select(_e1131, _e1174, (_e1174 > _e1131)) < 0f);
                                                            }
                                                            let _e1179 = phi_1243_;
                                                            if _e1179 {
                                                                phi_1948_ = type_26();
                                                                phi_1949_ = true;
                                                                phi_1950_ = false;
                                                            } else {
                                                                let _e1181 = select(_e1121, _e1108, (_e1108 < _e1121));
                                                                if (select(_e1134, _e1181, (_e1181 < _e1134)) > 0f) {
                                                                    phi_1272_ = true;
                                                                } else {
                                                                    let _e1186 = select(_e1121, _e1108, (_e1108 > _e1121));
                                                                    phi_1272_ = (select(_e1134, _e1186, (_e1186 > _e1134)) < 0f);
                                                                }
                                                                let _e1191 = phi_1272_;
                                                                if _e1191 {
                                                                    phi_1946_ = type_26();
                                                                    phi_1947_ = false;
                                                                } else {
                                                                    let _e1193 = select(_e1093[1][0], _e1093[0][0], (_e1093[0][0] < _e1093[1][0]));
                                                                    let _e1197 = select(_e1093[1][0], _e1093[0][0], (_e1093[0][0] > _e1093[1][0]));
                                                                    let _e1201 = select(_e1093[1][1], _e1093[0][1], (_e1093[0][1] < _e1093[1][1]));
                                                                    let _e1205 = select(_e1093[1][1], _e1093[0][1], (_e1093[0][1] > _e1093[1][1]));
                                                                    let _e1209 = select(_e1093[1][2], _e1093[0][2], (_e1093[0][2] < _e1093[1][2]));
                                                                    let _e1213 = select(_e1093[1][2], _e1093[0][2], (_e1093[0][2] > _e1093[1][2]));
                                                                    let _e1218 = ((select(_e1093[2][0], _e1193, (_e1193 < _e1093[2][0])) - _e324) * _e329);
                                                                    let _e1219 = ((select(_e1093[2][0], _e1197, (_e1197 > _e1093[2][0])) - _e325) * _e329);
                                                                    let _e1222 = ((select(_e1093[2][1], _e1201, (_e1201 < _e1093[2][1])) - _e360) * _e365);
                                                                    let _e1223 = ((select(_e1093[2][1], _e1205, (_e1205 > _e1093[2][1])) - _e361) * _e365);
                                                                    let _e1226 = ((select(_e1093[2][2], _e1209, (_e1209 < _e1093[2][2])) - _e396) * _e401);
                                                                    let _e1227 = ((select(_e1093[2][2], _e1213, (_e1213 > _e1093[2][2])) - _e397) * _e401);
                                                                    let _e1229 = select(_e1227, _e1226, (_e1226 < _e1227));
                                                                    let _e1231 = select(_e1227, _e1226, (_e1226 > _e1227));
                                                                    let _e1233 = select(_e1219, _e1218, (_e1218 < _e1219));
                                                                    let _e1235 = select(_e1223, _e1222, (_e1222 < _e1223));
                                                                    let _e1237 = select(_e1235, _e1233, (_e1233 > _e1235));
                                                                    let _e1239 = select(_e1229, _e1237, (_e1237 > _e1229));
                                                                    let _e1241 = select(_e1219, _e1218, (_e1218 > _e1219));
                                                                    let _e1243 = select(_e1223, _e1222, (_e1222 > _e1223));
                                                                    let _e1245 = select(_e1243, _e1241, (_e1241 < _e1243));
                                                                    let _e1247 = select(_e1231, _e1245, (_e1245 < _e1231));
                                                                    let _e1248 = -(_e1229);
                                                                    let _e1254 = select(_e447, _e1239, (_e1239 > _e447));
                                                                    if (_e1254 > (_e1247 + (select(_e1248, _e1231, (_e1231 > _e1248)) * 0.0000019073523f))) {
                                                                        phi_1941_ = type_26();
                                                                        phi_1942_ = true;
                                                                    } else {
                                                                        let _e1256 = (_e1254 > _e991.member.member_1);
                                                                        if _e1256 {
                                                                            phi_1940_ = type_26();
                                                                        } else {
                                                                            let _e1257 = vec3<f32>(_e1093[0][0], _e1093[0][1], _e1093[0][2]);
                                                                            let _e1258 = vec3<f32>(_e1093[1][0], _e1093[1][1], _e1093[1][2]);
                                                                            let _e1259 = vec3<f32>(_e1093[2][0], _e1093[2][1], _e1093[2][2]);
                                                                            let _e1260 = (_e1093[1][0] - _e1093[0][0]);
                                                                            let _e1261 = (_e1093[1][1] - _e1093[0][1]);
                                                                            let _e1262 = (_e1093[1][2] - _e1093[0][2]);
                                                                            let _e1263 = vec3<f32>(_e1260, _e1261, _e1262);
                                                                            let _e1264 = (_e1093[2][0] - _e1093[1][0]);
                                                                            let _e1265 = (_e1093[2][1] - _e1093[1][1]);
                                                                            let _e1266 = (_e1093[2][2] - _e1093[1][2]);
                                                                            let _e1267 = vec3<f32>(_e1264, _e1265, _e1266);
                                                                            let _e1268 = (_e1093[0][0] - _e1093[2][0]);
                                                                            let _e1269 = (_e1093[0][1] - _e1093[2][1]);
                                                                            let _e1270 = (_e1093[0][2] - _e1093[2][2]);
                                                                            let _e1271 = vec3<f32>(_e1268, _e1269, _e1270);
                                                                            let _e1274 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                            let _e1277 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                            let _e1279 = select(_e1277, _e1274, (_e1274 > _e1277));
                                                                            let _e1282 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                            let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                            let _e1287 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                            let _e1290 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                            let _e1292 = select(_e1290, _e1287, (_e1287 > _e1290));
                                                                            let _e1295 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                            let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                            let _e1300 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                            let _e1303 = bitcast<f32>((bitcast<u32>(_e1269) & 2147483647u));
                                                                            let _e1305 = select(_e1303, _e1300, (_e1300 > _e1303));
                                                                            let _e1308 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                            let _e1310 = select(_e1308, _e1305, (_e1305 > _e1308));
                                                                            let _e1312 = select(_e1297, _e1284, (_e1284 > _e1297));
                                                                            let _e1314 = select(_e1310, _e1312, (_e1312 > _e1310));
                                                                            if (_e1284 == _e1314) {
                                                                                phi_1673_ = _e1121;
                                                                                phi_1674_ = _e1118;
                                                                                phi_1675_ = _e1108;
                                                                                phi_1676_ = _e1105;
                                                                                phi_1677_ = _e1257;
                                                                                phi_1678_ = _e1271;
                                                                                phi_1679_ = _e1267;
                                                                                phi_1680_ = _e1263;
                                                                            } else {
                                                                                let _e1316 = (_e1297 == _e1314);
                                                                                let _e1321 = vec3(_e1316);
                                                                                phi_1673_ = select(_e1108, _e1134, _e1316);
                                                                                phi_1674_ = select(_e1105, _e1131, _e1316);
                                                                                phi_1675_ = select(_e1134, _e1121, _e1316);
                                                                                phi_1676_ = select(_e1131, _e1118, _e1316);
                                                                                phi_1677_ = select(_e1259, _e1258, _e1321);
                                                                                phi_1678_ = select(_e1267, _e1263, _e1321);
                                                                                phi_1679_ = select(_e1263, _e1271, _e1321);
                                                                                phi_1680_ = select(_e1271, _e1267, _e1321);
                                                                            }
                                                                            let _e1327 = phi_1673_;
                                                                            let _e1329 = phi_1674_;
                                                                            let _e1331 = phi_1675_;
                                                                            let _e1333 = phi_1676_;
                                                                            let _e1335 = phi_1677_;
                                                                            let _e1337 = phi_1678_;
                                                                            let _e1339 = phi_1679_;
                                                                            let _e1341 = phi_1680_;
                                                                            let _e1348 = ((_e1339.y * _e1337.z) - (_e1337.y * _e1339.z));
                                                                            let _e1353 = ((_e1339.z * _e1337.x) - (_e1337.z * _e1339.x));
                                                                            let _e1356 = ((_e1339.x * _e1337.y) - (_e1337.x * _e1339.y));
                                                                            if (_e1156 >= _e1160) {
                                                                                phi_1711_ = select(true, false, (_e1156 >= _e1164));
                                                                            } else {
                                                                                phi_1711_ = true;
                                                                            }
                                                                            let _e1361 = phi_1711_;
                                                                            if _e1361 {
                                                                                phi_1720_ = select(_e1259, _e1258, vec3((_e1160 >= _e1164)));
                                                                            } else {
                                                                                phi_1720_ = _e1257;
                                                                            }
                                                                            let _e1366 = phi_1720_;
                                                                            let _e1377 = (((_e1348 * (_e1366.x - _e301)) + (_e1353 * (_e1366.y - _e338))) + (_e1356 * (_e1366.z - _e374)));
                                                                            let _e1382 = (((_e1348 * _e326) + (_e1353 * _e362)) + (_e1356 * _e398));
                                                                            let _e1383 = (_e1329 - _e1333);
                                                                            let _e1384 = (_e1327 - _e1331);
                                                                            let _e1392 = (-(((_e1333 * _e1383) + (_e1331 * _e1384))) / ((_e1383 * _e1383) + (_e1384 * _e1384)));
                                                                            let _e1394 = select(1f, _e1392, (_e1392 < 1f));
                                                                            let _e1396 = select(0f, _e1394, (_e1394 > 0f));
                                                                            let _e1409 = ((_e1335.x + (_e1341.x * _e1396)) - _e301);
                                                                            let _e1410 = ((_e1335.y + (_e1341.y * _e1396)) - _e338);
                                                                            let _e1411 = ((_e1335.z + (_e1341.z * _e1396)) - _e374);
                                                                            let _e1412 = (_e1411 / _e398);
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                                            let _e1427 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                                            let _e1429 = select(_e1427, _e1424, (_e1424 > _e1427));
                                                                            let _e1432 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                                            let _e1434 = select(_e1432, _e1429, (_e1429 > _e1432));
                                                                            let _e1440 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                            let _e1443 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                            let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                                            let _e1448 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1348 * _e1409) + (_e1353 * _e1410)) + (_e1356 * _e1411)) - _e1377)) & 2147483647u)) <= ((0.0000009536743f * select(_e1314, _e1434, (_e1434 > _e1314))) * select(_e1448, _e1445, (_e1445 > _e1448)))) {
                                                                                let _e1458 = bitcast<f32>((bitcast<u32>(_e1339.x) & 2147483647u));
                                                                                let _e1461 = bitcast<f32>((bitcast<u32>(_e1339.y) & 2147483647u));
                                                                                let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                                let _e1466 = bitcast<f32>((bitcast<u32>(_e1339.z) & 2147483647u));
                                                                                let _e1472 = bitcast<f32>((bitcast<u32>(_e1337.x) & 2147483647u));
                                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1337.y) & 2147483647u));
                                                                                let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                                                let _e1480 = bitcast<f32>((bitcast<u32>(_e1337.z) & 2147483647u));
                                                                                let _e1484 = (bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u)) > ((0.0000038146973f * select(_e1466, _e1463, (_e1463 > _e1466))) * select(_e1480, _e1477, (_e1477 > _e1480))));
                                                                                if _e1484 {
                                                                                    phi_1885_ = (_e1377 / _e1382);
                                                                                } else {
                                                                                    phi_1885_ = f32();
                                                                                }
                                                                                let _e1487 = phi_1885_;
                                                                                phi_1887_ = _e1487;
                                                                                phi_1888_ = select(true, false, _e1484);
                                                                            } else {
                                                                                phi_1887_ = f32();
                                                                                phi_1888_ = true;
                                                                            }
                                                                            let _e1490 = phi_1887_;
                                                                            let _e1492 = phi_1888_;
                                                                            if _e1492 {
                                                                                let _e1500 = (((_e1348 * (_e1409 - (_e326 * _e1412))) + (_e1353 * (_e1410 - (_e362 * _e1412)))) / _e1382);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u)) <= _e1314) {
                                                                                    phi_1908_ = (_e1412 + _e1500);
                                                                                } else {
                                                                                    phi_1908_ = _e1412;
                                                                                }
                                                                                let _e1507 = phi_1908_;
                                                                                phi_1909_ = _e1507;
                                                                            } else {
                                                                                phi_1909_ = _e1490;
                                                                            }
                                                                            let _e1509 = phi_1909_;
                                                                            let _e1511 = select(_e1247, _e1509, (_e1509 < _e1247));
                                                                            let _e1513 = select(_e1239, _e1511, (_e1511 > _e1239));
                                                                            if (_e1513 >= _e447) {
                                                                                let _e1515 = (_e1513 <= _e991.member.member_1);
                                                                                if _e1515 {
                                                                                    let _e1516 = (1f / _e1166);
                                                                                    phi_1932_ = type_26(_e1513, (_e1160 * _e1516), (_e1164 * _e1516), _e1026);
                                                                                } else {
                                                                                    phi_1932_ = type_26();
                                                                                }
                                                                                let _e1521 = phi_1932_;
                                                                                phi_1934_ = _e1521;
                                                                                phi_1935_ = select(true, false, _e1515);
                                                                            } else {
                                                                                phi_1934_ = type_26();
                                                                                phi_1935_ = true;
                                                                            }
                                                                            let _e1524 = phi_1934_;
                                                                            let _e1526 = phi_1935_;
                                                                            if _e1526 {
                                                                                phi_1939_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1939_ = _e1524;
                                                                            }
                                                                            let _e1528 = phi_1939_;
                                                                            phi_1940_ = _e1528;
                                                                        }
                                                                        let _e1530 = phi_1940_;
                                                                        phi_1941_ = _e1530;
                                                                        phi_1942_ = _e1256;
                                                                    }
                                                                    let _e1532 = phi_1941_;
                                                                    let _e1534 = phi_1942_;
                                                                    phi_1946_ = _e1532;
                                                                    phi_1947_ = _e1534;
                                                                }
                                                                let _e1536 = phi_1946_;
                                                                let _e1538 = phi_1947_;
                                                                phi_1948_ = _e1536;
                                                                phi_1949_ = _e1191;
                                                                phi_1950_ = _e1538;
                                                            }
                                                            let _e1540 = phi_1948_;
                                                            let _e1542 = phi_1949_;
                                                            let _e1544 = phi_1950_;
                                                            phi_1951_ = _e1540;
                                                            phi_1952_ = _e1542;
                                                            phi_1953_ = _e1544;
                                                        }
                                                        let _e1546 = phi_1951_;
                                                        let _e1548 = phi_1952_;
                                                        let _e1550 = phi_1953_;
                                                        phi_1961_ = _e1546;
                                                        phi_1962_ = select(_e1550, true, _e1548);
                                                    } else {
                                                        phi_1961_ = type_26();
                                                        phi_1962_ = true;
                                                    }
                                                    let _e1553 = phi_1961_;
                                                    let _e1555 = phi_1962_;
                                                    if _e1555 {
                                                        phi_1966_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1966_ = _e1553;
                                                    }
                                                    let _e1557 = phi_1966_;
                                                    if (_e1557.member_3 != 4294967295u) {
                                                        if (_e1026 != _e453) {
                                                            if (_e1557.member < _e991.member.member.member) {
                                                                phi_1992_ = true;
                                                            } else {
                                                                if (_e1557.member == _e991.member.member.member) {
                                                                    phi_1991_ = (_e1557.member_3 < _e991.member.member.member_3);
                                                                } else {
                                                                    phi_1991_ = false;
                                                                }
                                                                let _e1572 = phi_1991_;
                                                                phi_1992_ = _e1572;
                                                            }
                                                            let _e1574 = phi_1992_;
                                                            if _e1574 {
                                                                phi_1999_ = type_46(type_42(_e1557, _e1557.member), _e1018.member_1, _e1018.member_2);
                                                            } else {
                                                                phi_1999_ = _e1018;
                                                            }
                                                            let _e1581 = phi_1999_;
                                                            phi_2000_ = _e1581;
                                                        } else {
                                                            phi_2000_ = _e1018;
                                                        }
                                                        let _e1583 = phi_2000_;
                                                        phi_2001_ = _e1583;
                                                    } else {
                                                        phi_2001_ = _e1018;
                                                    }
                                                    let _e1585 = phi_2001_;
                                                    phi_988_ = _e1585;
                                                } else {
                                                    phi_988_ = type_46();
                                                }
                                                let _e1587 = phi_988_;
                                                continue;
                                                continuing {
                                                    phi_987_ = _e1587;
                                                    phi_990_ = _e1006;
                                                    phi_3586_ = _e494;
                                                    break if !(_e1012);
                                                }
                                            }
                                            let _e1590 = phi_3586_;
                                            phi_3728_ = _e1590;
                                            if _e1590 {
                                                break;
                                            }
                                            phi_3732_ = _e1590;
                                            let _e1826 = local_12;
                                            phi_3209_ = _e1826;
                                            phi_3210_ = _e536;
                                            phi_3211_ = false;
                                            phi_3212_ = _e540;
                                        } else {
                                            if (_e536.member_1 >= _e89) {
                                                phi_2765_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e536.member_1 < _e89) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e558 = ((1u + _e269) % 4u);
                                                if (_e558 < 4u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e563 = global_4.member[_e536.member_1][_e558];
                                                let _e565 = (_e563 >> bitcast<u32>(11u));
                                                let _e567 = ((1u + _e268) % 4u);
                                                if (_e567 < 4u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e572 = global_4.member[_e536.member_1][_e567];
                                                let _e574 = (_e572 >> bitcast<u32>(11u));
                                                let _e576 = ((1u + _e270) % 4u);
                                                if (_e576 < 4u) {
                                                } else {
                                                    phi_3728_ = true;
                                                    break;
                                                }
                                                let _e581 = global_4.member[_e536.member_1][_e576];
                                                let _e583 = (_e581 >> bitcast<u32>(11u));
                                                let _e606 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.x - _e536.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e607 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.y - _e536.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e608 = (bitcast<f32>((bitcast<u32>((_e536.member.member_1.z - _e536.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e610 = select(_e143, _e606, (_e606 > _e143));
                                                let _e612 = select(_e143, _e607, (_e607 > _e143));
                                                let _e614 = select(_e143, _e608, (_e608 > _e143));
                                                let _e639 = bitcast<u32>((f32(bitcast<i32>((_e563 & 1023u))) * _e610));
                                                let _e644 = (bitcast<i32>((_e563 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e647 = bitcast<f32>((_e639 & bitcast<u32>(_e644)));
                                                let _e648 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e612));
                                                let _e653 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e656 = bitcast<f32>((_e648 & bitcast<u32>(_e653)));
                                                let _e657 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e614));
                                                let _e662 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                                let _e669 = bitcast<f32>((_e639 & bitcast<u32>(~(_e644))));
                                                let _e673 = bitcast<f32>((_e648 & bitcast<u32>(~(_e653))));
                                                let _e677 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                                let _e678 = bitcast<u32>((f32(bitcast<i32>((_e565 & 1023u))) * _e610));
                                                let _e683 = (bitcast<i32>((_e565 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e686 = bitcast<f32>((_e678 & bitcast<u32>(_e683)));
                                                let _e687 = bitcast<u32>((f32(bitcast<i32>((_e574 & 1023u))) * _e612));
                                                let _e692 = (bitcast<i32>((_e574 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e695 = bitcast<f32>((_e687 & bitcast<u32>(_e692)));
                                                let _e696 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e614));
                                                let _e701 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                                let _e708 = bitcast<f32>((_e678 & bitcast<u32>(~(_e683))));
                                                let _e712 = bitcast<f32>((_e687 & bitcast<u32>(~(_e692))));
                                                let _e716 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                                let _e746 = global_4.member[_e536.member_1][0u];
                                                let _e750 = global_4.member[_e536.member_1][1u];
                                                let _e754 = global_4.member[_e536.member_1][2u];
                                                let _e758 = global_4.member[_e536.member_1][3u];
                                                let _e770 = (((_e750 >> bitcast<u32>(22i)) | ((_e754 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e758 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e771 = (_e746 & 268435455u);
                                                let _e772 = (_e770 & 268435455u);
                                                let _e775 = ((_e746 >> bitcast<u32>(28u)) & 7u);
                                                let _e783 = ((_e746 >> bitcast<u32>(31i)) | (((_e770 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e784 = (_e775 != 0u);
                                                if (_e775 == 0u) {
                                                    phi_2727_ = _e771;
                                                } else {
                                                    if (_e775 == 7u) {
                                                        phi_2726_ = 2147483648u;
                                                    } else {
                                                        phi_2726_ = ((2147483648u | (_e775 << bitcast<u32>(28u))) | (_e772 & 268435455u));
                                                    }
                                                    let _e793 = phi_2726_;
                                                    phi_2727_ = _e793;
                                                }
                                                let _e795 = phi_2727_;
                                                if _e784 {
                                                    let _e796 = (_e775 != 7u);
                                                    if _e796 {
                                                        phi_2737_ = (_e772 + _e775);
                                                    } else {
                                                        phi_2737_ = u32();
                                                    }
                                                    let _e799 = phi_2737_;
                                                    phi_2739_ = _e799;
                                                    phi_2740_ = select(true, false, _e796);
                                                } else {
                                                    phi_2739_ = u32();
                                                    phi_2740_ = true;
                                                }
                                                let _e802 = phi_2739_;
                                                let _e804 = phi_2740_;
                                                if (_e783 == 0u) {
                                                    phi_2761_ = (_e771 + select(0u, 1u, !(_e784)));
                                                } else {
                                                    if (_e783 == 7u) {
                                                        phi_2760_ = 2147483648u;
                                                    } else {
                                                        phi_2760_ = ((2147483648u | (_e783 << bitcast<u32>(28u))) | (select(_e802, _e772, _e804) & 268435455u));
                                                    }
                                                    let _e817 = phi_2760_;
                                                    phi_2761_ = _e817;
                                                }
                                                let _e819 = phi_2761_;
                                                phi_2765_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e536.member.member.x + _e647), (_e536.member.member.x + _e669), (_e536.member.member_1.x - _e686), (_e536.member.member_1.x - _e708)), vec4<f32>((_e536.member.member.y + _e656), (_e536.member.member.y + _e673), (_e536.member.member_1.y - _e695), (_e536.member.member_1.y - _e712)), vec4<f32>((_e536.member.member.z + _e665), (_e536.member.member.z + _e677), (_e536.member.member_1.z - _e704), (_e536.member.member_1.z - _e716))), type_53(type_38((_e536.member.member + vec4<f32>(_e647, _e656, _e665, 0f)), (_e536.member.member_1 - vec4<f32>(_e686, _e695, _e704, 0f))), _e795), type_53(type_38((_e536.member.member + vec4<f32>(_e669, _e673, _e677, 0f)), (_e536.member.member_1 - vec4<f32>(_e708, _e712, _e716, 0f))), _e819));
                                            }
                                            let _e824 = phi_2765_;
                                            let _e837 = ((_e824.member[0].x - _e324) * _e329);
                                            let _e838 = ((_e824.member[0].y - _e324) * _e329);
                                            let _e839 = ((_e824.member[0].z - _e325) * _e329);
                                            let _e840 = ((_e824.member[0].w - _e325) * _e329);
                                            let _e850 = ((_e824.member[1].x - _e360) * _e365);
                                            let _e851 = ((_e824.member[1].y - _e360) * _e365);
                                            let _e852 = ((_e824.member[1].z - _e361) * _e365);
                                            let _e853 = ((_e824.member[1].w - _e361) * _e365);
                                            let _e863 = ((_e824.member[2].x - _e396) * _e401);
                                            let _e864 = ((_e824.member[2].y - _e396) * _e401);
                                            let _e865 = ((_e824.member[2].z - _e397) * _e401);
                                            let _e866 = ((_e824.member[2].w - _e397) * _e401);
                                            let _e868 = select(_e865, _e863, (_e863 < _e865));
                                            let _e870 = select(_e866, _e864, (_e864 < _e866));
                                            let _e872 = select(_e865, _e863, (_e863 > _e865));
                                            let _e874 = select(_e866, _e864, (_e864 > _e866));
                                            let _e876 = select(_e839, _e837, (_e837 < _e839));
                                            let _e878 = select(_e840, _e838, (_e838 < _e840));
                                            let _e880 = select(_e852, _e850, (_e850 < _e852));
                                            let _e882 = select(_e853, _e851, (_e851 < _e853));
                                            let _e884 = select(_e880, _e876, (_e876 > _e880));
                                            let _e886 = select(_e882, _e878, (_e878 > _e882));
                                            let _e888 = select(_e868, _e884, (_e884 > _e868));
                                            let _e890 = select(_e870, _e886, (_e886 > _e870));
                                            let _e892 = select(_e839, _e837, (_e837 > _e839));
                                            let _e894 = select(_e840, _e838, (_e838 > _e840));
                                            let _e896 = select(_e852, _e850, (_e850 > _e852));
                                            let _e898 = select(_e853, _e851, (_e851 > _e853));
                                            let _e900 = select(_e896, _e892, (_e892 < _e896));
                                            let _e902 = select(_e898, _e894, (_e894 < _e898));
                                            let _e907 = -(_e868);
                                            let _e908 = -(_e870);
                                            let _e915 = (select(_e872, _e900, (_e900 < _e872)) + (select(_e907, _e872, (_e872 > _e907)) * 0.0000019073523f));
                                            let _e916 = (select(_e874, _e902, (_e902 < _e874)) + (select(_e908, _e874, (_e874 > _e908)) * 0.0000019073523f));
                                            let _e918 = select(_e447, _e888, (_e888 > _e447));
                                            let _e920 = select(_e447, _e890, (_e890 > _e447));
                                            let _e925 = (_e918 <= select(_e496.member.member_1, _e915, (_e915 < _e496.member.member_1)));
                                            let _e926 = (_e920 <= select(_e496.member.member_1, _e916, (_e916 < _e496.member.member_1)));
                                            let _e927 = (_e918 <= _e920);
                                            if _e925 {
                                                if _e926 {
                                                    if _e927 {
                                                        phi_3109_ = _e824.member_2;
                                                    } else {
                                                        phi_3109_ = _e824.member_1;
                                                    }
                                                    let _e931 = phi_3109_;
                                                    let _e953 = (_e540 % 128u);
                                                    let _e954 = (_e953 < 128u);
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_8[_e953] = _e931.member_1;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_7[_e953] = _e931.member.member.x;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_6[_e953] = _e931.member.member.y;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_5[_e953] = _e931.member.member.z;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_4[_e953] = _e931.member.member_1.x;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_3[_e953] = _e931.member.member_1.y;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_2[_e953] = _e931.member.member_1.z;
                                                    if _e954 {
                                                    } else {
                                                        phi_3728_ = true;
                                                        break;
                                                    }
                                                    local_9[_e953] = select(_e920, _e918, (_e918 > _e920));
                                                    if _e927 {
                                                        phi_3186_ = _e824.member_1;
                                                    } else {
                                                        phi_3186_ = _e824.member_2;
                                                    }
                                                    let _e967 = phi_3186_;
                                                    phi_3187_ = _e967;
                                                    phi_3188_ = (_e540 + 1u);
                                                } else {
                                                    phi_3187_ = type_53();
                                                    phi_3188_ = u32();
                                                }
                                                let _e969 = phi_3187_;
                                                let _e971 = phi_3188_;
                                                phi_3190_ = _e969;
                                                phi_3191_ = _e971;
                                                phi_3192_ = select(true, false, _e926);
                                            } else {
                                                phi_3190_ = type_53();
                                                phi_3191_ = u32();
                                                phi_3192_ = true;
                                            }
                                            let _e974 = phi_3190_;
                                            let _e976 = phi_3191_;
                                            let _e978 = phi_3192_;
                                            if _e978 {
                                                if _e925 {
                                                    phi_3201_ = _e824.member_1;
                                                } else {
                                                    phi_3201_ = _e824.member_2;
                                                }
                                                let _e982 = phi_3201_;
                                                phi_3206_ = _e982;
                                                phi_3207_ = select(_e926, true, _e925);
                                            } else {
                                                phi_3206_ = _e974;
                                                phi_3207_ = _e538;
                                            }
                                            let _e985 = phi_3206_;
                                            let _e987 = phi_3207_;
                                            phi_3732_ = _e494;
                                            phi_3209_ = type_46(_e496.member, (_e496.member_1 + 1u), _e496.member_2);
                                            phi_3210_ = _e985;
                                            phi_3211_ = _e987;
                                            phi_3212_ = select(_e976, _e540, _e978);
                                        }
                                        let _e1592 = phi_3732_;
                                        let _e1594 = phi_3209_;
                                        let _e1596 = phi_3210_;
                                        let _e1598 = phi_3211_;
                                        let _e1600 = phi_3212_;
                                        phi_3731_ = _e1592;
                                        phi_3213_ = _e1594;
                                        phi_3214_ = _e1596;
                                        phi_3215_ = (_e500 - 1u);
                                        phi_3216_ = _e1598;
                                        phi_3217_ = _e1600;
                                    } else {
                                        phi_3731_ = _e494;
                                        phi_3213_ = _e496;
                                        phi_3214_ = _e536;
                                        phi_3215_ = _e500;
                                        phi_3216_ = _e538;
                                        phi_3217_ = _e540;
                                    }
                                    let _e1602 = phi_3731_;
                                    let _e1604 = phi_3213_;
                                    let _e1606 = phi_3214_;
                                    let _e1608 = phi_3215_;
                                    let _e1610 = phi_3216_;
                                    let _e1612 = phi_3217_;
                                    phi_3730_ = _e1602;
                                    phi_3218_ = _e1604;
                                    phi_3219_ = _e1606;
                                    phi_3220_ = _e1608;
                                    phi_3221_ = _e1610;
                                    phi_3222_ = _e1612;
                                } else {
                                    phi_3730_ = _e494;
                                    phi_3218_ = type_46();
                                    phi_3219_ = type_53();
                                    phi_3220_ = u32();
                                    phi_3221_ = bool();
                                    phi_3222_ = u32();
                                }
                                let _e1614 = phi_3730_;
                                let _e1616 = phi_3218_;
                                let _e1618 = phi_3219_;
                                let _e1620 = phi_3220_;
                                let _e1622 = phi_3221_;
                                let _e1624 = phi_3222_;
                                phi_3729_ = _e1614;
                                phi_862_ = _e1616;
                                phi_865_ = _e1618;
                                phi_867_ = _e1620;
                                phi_869_ = _e1622;
                                phi_871_ = _e1624;
                                phi_3223_ = _e508;
                            } else {
                                phi_3729_ = _e494;
                                phi_862_ = type_46();
                                phi_865_ = type_53();
                                phi_867_ = u32();
                                phi_869_ = bool();
                                phi_871_ = u32();
                                phi_3223_ = false;
                            }
                            let _e1626 = phi_3729_;
                            let _e1628 = phi_862_;
                            let _e1630 = phi_865_;
                            let _e1632 = phi_867_;
                            let _e1634 = phi_869_;
                            let _e1636 = phi_871_;
                            let _e1638 = phi_3223_;
                            continue;
                            continuing {
                                phi_3592_ = _e1626;
                                phi_861_ = _e1628;
                                phi_864_ = _e1630;
                                phi_866_ = _e1632;
                                phi_868_ = _e1634;
                                phi_870_ = _e1636;
                                phi_3728_ = _e1626;
                                break if !(_e1638);
                            }
                        }
                        let _e1641 = phi_3728_;
                        if _e1641 {
                            break;
                        }
                        let _e1643 = local_10;
                        if (_e1643.member.member.member_3 != 4294967295u) {
                            let _e1649 = (_e271 / 3i);
                            let _e1656 = bitcast<f32>((bitcast<u32>((_e1649 + 127i)) << bitcast<u32>(23i)));
                            let _e1664 = (((_e1643.member.member.member * _e1656) * _e1656) * bitcast<f32>((bitcast<u32>(((_e271 - (2i * _e1649)) + 127i)) << bitcast<u32>(23i))));
                            let _e1666 = select(340282350000000000000000000000000000000f, _e1664, (_e1664 < 340282350000000000000000000000000000000f));
                            phi_3275_ = type_26(select(-340282350000000000000000000000000000000f, _e1666, (_e1666 > -340282350000000000000000000000000000000f)), _e1643.member.member.member_1, _e1643.member.member.member_2, _e1643.member.member.member_3);
                        } else {
                            phi_3275_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1673 = phi_3275_;
                        if _e147 {
                        } else {
                            break;
                        }
                        global_2.member[_e131] = _e1673;
                        let _e1677 = local_11;
                        if _e148 {
                        } else {
                            break;
                        }
                        global_6.member[_e131] = _e1677.member_1;
                        if _e146 {
                        } else {
                            break;
                        }
                        let _e1682 = select(0u, 1u, (_e215 <= _e225));
                        if (_e1682 > 0u) {
                            let _e1684 = (1u < _e99);
                            if _e1684 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1688 = atomicAdd((&global_7.member[0u]), _e1682);
                                if ((_e1688 + _e1682) < _e1688) {
                                    if _e1684 {
                                    } else {
                                        break;
                                    }
                                    let _e1693 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1696 = select(0u, 1u, (_e1673.member_3 != 4294967295u));
                        if (_e1696 > 0u) {
                            let _e1698 = (3u < _e99);
                            if _e1698 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1702 = atomicAdd((&global_7.member[2u]), _e1696);
                                if ((_e1702 + _e1696) < _e1702) {
                                    if _e1698 {
                                    } else {
                                        break;
                                    }
                                    let _e1707 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1677.member_1 > 0u) {
                            let _e1709 = (5u < _e99);
                            if _e1709 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1713 = atomicAdd((&global_7.member[4u]), _e1677.member_1);
                                if ((_e1713 + _e1677.member_1) < _e1713) {
                                    if _e1709 {
                                    } else {
                                        break;
                                    }
                                    let _e1718 = atomicAdd((&global_7.member[5u]), 1u);
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
