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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_21,
    member_1: f32,
}

struct type_40 {
    member: type_36,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_23;
@group(0) @binding(0) 
var<uniform> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_28;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_49;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_51, 128>;
    var phi_391_: i32;
    var phi_392_: i32;
    var phi_402_: bool;
    var phi_412_: u32;
    var phi_413_: u32;
    var phi_415_: bool;
    var phi_420_: u32;
    var phi_453_: i32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_517_: f32;
    var phi_528_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_583_: f32;
    var phi_594_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_620_: f32;
    var phi_626_: f32;
    var phi_649_: f32;
    var phi_660_: f32;
    var phi_760_: f32;
    var phi_761_: f32;
    var phi_4392_: bool;
    var phi_1890_: type_40;
    var phi_1893_: type_51;
    var phi_1895_: u32;
    var phi_1897_: bool;
    var phi_1899_: u32;
    var phi_1910_: bool;
    var phi_1947_: type_51;
    var phi_1948_: bool;
    var phi_1949_: u32;
    var phi_3584_: u32;
    var phi_3585_: u32;
    var phi_3595_: u32;
    var phi_3597_: u32;
    var phi_3598_: bool;
    var phi_3618_: u32;
    var phi_3619_: u32;
    var phi_3623_: type_54;
    var phi_3967_: type_51;
    var phi_4000_: type_51;
    var phi_4001_: type_51;
    var phi_4002_: u32;
    var phi_4004_: type_51;
    var phi_4005_: u32;
    var phi_4006_: bool;
    var phi_4015_: type_51;
    var phi_4020_: type_51;
    var phi_4021_: bool;
    var phi_1967_: type_40;
    var phi_1970_: type_7;
    var phi_1971_: type_7;
    var phi_1993_: type_7;
    var phi_2017_: u32;
    var phi_2106_: array<array<f32, 3>, 3>;
    var phi_2577_: vec3<f32>;
    var phi_2578_: vec3<f32>;
    var phi_2609_: bool;
    var phi_2618_: vec3<f32>;
    var phi_2658_: type_21;
    var phi_2660_: type_21;
    var phi_2661_: bool;
    var phi_2665_: type_21;
    var phi_2666_: type_21;
    var phi_2667_: type_21;
    var phi_2668_: bool;
    var phi_2672_: type_21;
    var phi_2673_: bool;
    var phi_2677_: type_21;
    var phi_2678_: bool;
    var phi_2682_: type_21;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2715_: type_40;
    var phi_2716_: type_40;
    var phi_2717_: type_40;
    var phi_1968_: type_40;
    var phi_4386_: bool;
    var phi_4504_: bool;
    var phi_4023_: type_40;
    var phi_4024_: type_51;
    var phi_4025_: bool;
    var phi_4026_: u32;
    var phi_4503_: bool;
    var phi_4027_: type_40;
    var phi_4028_: type_51;
    var phi_4029_: u32;
    var phi_4030_: bool;
    var phi_4031_: u32;
    var phi_4502_: bool;
    var phi_4032_: type_40;
    var phi_4033_: type_51;
    var phi_4034_: u32;
    var phi_4035_: bool;
    var phi_4036_: u32;
    var phi_4501_: bool;
    var phi_1891_: type_40;
    var phi_1894_: type_51;
    var phi_1896_: u32;
    var phi_1898_: bool;
    var phi_1900_: u32;
    var phi_4037_: bool;
    var phi_4500_: bool;
    var local_4: type_40;
    var phi_4089_: type_21;
    var local_5: type_40;
    var local_6: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e81 = arrayLength((&global_7.member));
            let _e83 = arrayLength((&global_1.member));
            let _e91 = arrayLength((&global_6.member));
            let _e95 = global_3.member[0u][0u];
            let _e99 = global_3.member[0u][1u];
            let _e103 = global_3.member[0u][2u];
            let _e107 = global_3.member[0u][3u];
            let _e111 = global_3.member[1u][0u];
            let _e115 = global_3.member[1u][1u];
            let _e119 = global_3.member[1u][2u];
            let _e123 = (_e79.x + (_e79.y * 2097152u));
            let _e135 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e107) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e95), bitcast<i32>(_e99), bitcast<i32>(_e103));
            local = array<i32, 3>(bitcast<i32>(_e111), bitcast<i32>(_e115), bitcast<i32>(_e119));
            let _e138 = (_e123 < arrayLength((&global_4.member)));
            if _e138 {
                let _e139 = (_e123 < arrayLength((&global_2.member)));
                if _e139 {
                    let _e140 = (_e123 < arrayLength((&global_5.member)));
                    if _e140 {
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e150 = global_4.member[_e123].member.member_2[0u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_4.member[_e123].member.member_2[1u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_4.member[_e123].member.member_2[2u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_4.member[_e123].member.member[0u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_4.member[_e123].member.member[1u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e190 = global_4.member[_e123].member.member[2u];
                        let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                        let _e194 = select(_e160, _e152, (_e160 < _e152));
                        let _e196 = select(_e168, _e194, (_e168 < _e194));
                        let _e198 = select(_e176, _e196, (_e176 < _e196));
                        let _e200 = select(_e184, _e198, (_e184 < _e198));
                        let _e202 = select(_e192, _e200, (_e192 < _e200));
                        let _e207 = global_4.member[_e123].member.member_1;
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e217 = global_4.member[_e123].member.member_3;
                        let _e223 = (((select(_e209, _e202, (_e209 < _e202)) < 2139095040u) && ((bitcast<u32>(_e217) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                        if _e223 {
                            let _e226 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                            if (_e226 >= 8388608u) {
                                phi_391_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_391_;
                            phi_392_ = _e240;
                        } else {
                            phi_392_ = 0i;
                        }
                        let _e242 = phi_392_;
                        let _e243 = (_e152 == _e196);
                        if _e243 {
                            phi_402_ = true;
                        } else {
                            phi_402_ = (_e160 == _e196);
                        }
                        let _e246 = phi_402_;
                        let _e247 = select(1u, 0u, _e243);
                        if _e246 {
                            let _e248 = (_e247 + 1u);
                            phi_412_ = _e248;
                            phi_413_ = _e248;
                            phi_415_ = select(true, false, (_e248 == 2u));
                        } else {
                            phi_412_ = u32();
                            phi_413_ = 0u;
                            phi_415_ = true;
                        }
                        let _e252 = phi_412_;
                        let _e254 = phi_413_;
                        let _e256 = phi_415_;
                        if _e256 {
                            phi_420_ = (_e254 + 1u);
                        } else {
                            phi_420_ = 0u;
                        }
                        let _e260 = phi_420_;
                        let _e261 = select(_e252, _e254, _e256);
                        let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                        let _e263 = -(_e242);
                        if (_e263 < -126i) {
                            phi_453_ = -126i;
                        } else {
                            phi_453_ = select(_e263, 127i, (_e263 > 127i));
                        }
                        let _e268 = phi_453_;
                        let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                        let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                        let _e284 = global_4.member[_e123].member.member;
                        let _e285 = (_e261 == 0u);
                        if _e285 {
                            phi_471_ = _e284[0];
                        } else {
                            phi_471_ = _e284[1];
                        }
                        let _e289 = phi_471_;
                        let _e290 = (_e261 == 2u);
                        if _e290 {
                            phi_477_ = _e284[2];
                        } else {
                            phi_477_ = _e289;
                        }
                        let _e293 = phi_477_;
                        let _e294 = global_4.member[_e123].member.member_2;
                        if _e285 {
                            phi_488_ = _e294[0];
                        } else {
                            phi_488_ = _e294[1];
                        }
                        let _e298 = phi_488_;
                        if _e290 {
                            phi_494_ = _e294[2];
                        } else {
                            phi_494_ = _e298;
                        }
                        let _e301 = phi_494_;
                        let _e303 = ((_e301 * _e273) * _e279);
                        let _e307 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e307 {
                            let _e311 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) * 0.00000011920929f);
                            phi_517_ = select(0.00000000000011368684f, _e311, (_e311 > 0.00000000000011368684f));
                        } else {
                            phi_517_ = 0f;
                        }
                        let _e315 = phi_517_;
                        let _e316 = (_e293 + _e315);
                        let _e317 = (_e293 - _e315);
                        let _e318 = select(_e303, 0f, _e307);
                        if _e307 {
                            phi_528_ = 38685626000000000000000000f;
                        } else {
                            phi_528_ = (1f / _e303);
                        }
                        let _e321 = phi_528_;
                        let _e322 = (_e260 == 0u);
                        if _e322 {
                            phi_537_ = _e284[0];
                        } else {
                            phi_537_ = _e284[1];
                        }
                        let _e326 = phi_537_;
                        let _e327 = (_e260 == 2u);
                        if _e327 {
                            phi_543_ = _e284[2];
                        } else {
                            phi_543_ = _e326;
                        }
                        let _e330 = phi_543_;
                        if _e322 {
                            phi_554_ = _e294[0];
                        } else {
                            phi_554_ = _e294[1];
                        }
                        let _e334 = phi_554_;
                        if _e327 {
                            phi_560_ = _e294[2];
                        } else {
                            phi_560_ = _e334;
                        }
                        let _e337 = phi_560_;
                        let _e339 = ((_e337 * _e273) * _e279);
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e339) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e343 {
                            let _e347 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) * 0.00000011920929f);
                            phi_583_ = select(0.00000000000011368684f, _e347, (_e347 > 0.00000000000011368684f));
                        } else {
                            phi_583_ = 0f;
                        }
                        let _e351 = phi_583_;
                        let _e352 = (_e330 + _e351);
                        let _e353 = (_e330 - _e351);
                        let _e354 = select(_e339, 0f, _e343);
                        if _e343 {
                            phi_594_ = 38685626000000000000000000f;
                        } else {
                            phi_594_ = (1f / _e339);
                        }
                        let _e357 = phi_594_;
                        let _e358 = (_e262 == 0u);
                        if _e358 {
                            phi_603_ = _e284[0];
                        } else {
                            phi_603_ = _e284[1];
                        }
                        let _e362 = phi_603_;
                        let _e363 = (_e262 == 2u);
                        if _e363 {
                            phi_609_ = _e284[2];
                        } else {
                            phi_609_ = _e362;
                        }
                        let _e366 = phi_609_;
                        if _e358 {
                            phi_620_ = _e294[0];
                        } else {
                            phi_620_ = _e294[1];
                        }
                        let _e370 = phi_620_;
                        if _e363 {
                            phi_626_ = _e294[2];
                        } else {
                            phi_626_ = _e370;
                        }
                        let _e373 = phi_626_;
                        let _e375 = ((_e373 * _e273) * _e279);
                        let _e379 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e379 {
                            let _e383 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) * 0.00000011920929f);
                            phi_649_ = select(0.00000000000011368684f, _e383, (_e383 > 0.00000000000011368684f));
                        } else {
                            phi_649_ = 0f;
                        }
                        let _e387 = phi_649_;
                        let _e388 = (_e366 + _e387);
                        let _e389 = (_e366 - _e387);
                        let _e390 = select(_e375, 0f, _e379);
                        if _e379 {
                            phi_660_ = 38685626000000000000000000f;
                        } else {
                            phi_660_ = (1f / _e375);
                        }
                        let _e393 = phi_660_;
                        let _e396 = bitcast<f32>((bitcast<u32>(_e293) & 2147483647u));
                        let _e399 = bitcast<f32>((bitcast<u32>(_e330) & 2147483647u));
                        let _e401 = select(_e399, _e396, (_e396 > _e399));
                        let _e404 = bitcast<f32>((bitcast<u32>(_e366) & 2147483647u));
                        if (_e223 && (select(_e404, _e401, (_e401 > _e404)) <= 1099511600000f)) {
                            let _e409 = (_e242 / 3i);
                            let _e416 = bitcast<f32>((bitcast<u32>((_e409 + 127i)) << bitcast<u32>(23i)));
                            let _e423 = bitcast<f32>((bitcast<u32>(((_e242 - (2i * _e409)) + 127i)) << bitcast<u32>(23i)));
                            let _e424 = (((_e207 * _e416) * _e416) * _e423);
                            let _e426 = select(340282350000000000000000000000000000000f, _e424, (_e424 < 340282350000000000000000000000000000000f));
                            let _e431 = (((_e217 * _e416) * _e416) * _e423);
                            let _e433 = select(340282350000000000000000000000000000000f, _e431, (_e431 < 340282350000000000000000000000000000000f));
                            phi_760_ = select(-340282350000000000000000000000000000000f, _e433, (_e433 > -340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e426, (_e426 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_760_ = 0f;
                            phi_761_ = 1f;
                        }
                        let _e437 = phi_760_;
                        let _e439 = phi_761_;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e445 = global_4.member[_e123].member_2;
                        local_3 = array<type_51, 128>(type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e448 = (_e261 % 3u);
                        let _e449 = (_e448 < 3u);
                        if _e449 {
                        } else {
                            break;
                        }
                        let _e451 = local_1[_e448];
                        let _e454 = (_e260 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_1[_e454];
                        let _e460 = (_e262 % 3u);
                        let _e461 = (_e460 < 3u);
                        if _e461 {
                        } else {
                            break;
                        }
                        let _e463 = local_1[_e460];
                        if _e449 {
                        } else {
                            break;
                        }
                        let _e468 = local[_e448];
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e472 = local[_e454];
                        if _e461 {
                        } else {
                            break;
                        }
                        let _e476 = local[_e460];
                        phi_4392_ = false;
                        phi_1890_ = type_40(type_36(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e437), 0u, 0u);
                        phi_1893_ = type_51(type_33(vec4<f32>((f32(_e451) * _e135), (f32(_e457) * _e135), (f32(_e463) * _e135), 0f), vec4<f32>((f32(_e468) * _e135), (f32(_e472) * _e135), (f32(_e476) * _e135), 0f)), select(0u, 2147483648u, (_e81 == 0u)));
                        phi_1895_ = ((3u * _e81) + 1u);
                        phi_1897_ = (_e439 <= _e437);
                        phi_1899_ = 0u;
                        loop {
                            let _e486 = phi_4392_;
                            let _e488 = phi_1890_;
                            let _e490 = phi_1893_;
                            let _e492 = phi_1895_;
                            let _e494 = phi_1897_;
                            let _e496 = phi_1899_;
                            local_4 = _e488;
                            local_5 = _e488;
                            if _e494 {
                                phi_1910_ = true;
                            } else {
                                phi_1910_ = (_e496 > 0u);
                            }
                            let _e499 = phi_1910_;
                            if _e499 {
                                let _e500 = (_e492 > 0u);
                                if _e500 {
                                    if _e494 {
                                        phi_1947_ = _e490;
                                        phi_1948_ = _e494;
                                        phi_1949_ = _e496;
                                    } else {
                                        let _e501 = (_e496 - 1u);
                                        let _e502 = (_e501 % 128u);
                                        let _e503 = (_e502 < 128u);
                                        if _e503 {
                                        } else {
                                            phi_4500_ = true;
                                            break;
                                        }
                                        let _e505 = local_3[_e502];
                                        if _e503 {
                                        } else {
                                            phi_4500_ = true;
                                            break;
                                        }
                                        let _e513 = local_2[_e502];
                                        phi_1947_ = type_51(type_33(_e505.member.member, _e505.member.member_1), _e505.member_1);
                                        phi_1948_ = (_e513 <= _e488.member.member_1);
                                        phi_1949_ = _e501;
                                    }
                                    let _e518 = phi_1947_;
                                    let _e520 = phi_1948_;
                                    let _e522 = phi_1949_;
                                    if _e520 {
                                        if ((_e518.member_1 & 2147483648u) != 0u) {
                                            phi_1967_ = _e488;
                                            phi_1970_ = type_7(0u, ((_e518.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e975 = phi_1967_;
                                                let _e977 = phi_1970_;
                                                local_6 = _e975;
                                                if (_e977.member < _e977.member_1) {
                                                    phi_1971_ = type_7((_e977.member + 1u), _e977.member_1);
                                                    phi_1993_ = type_7(1u, _e977.member);
                                                } else {
                                                    phi_1971_ = _e977;
                                                    phi_1993_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e990 = phi_1971_;
                                                let _e992 = phi_1993_;
                                                let _e996 = (bitcast<i32>(_e992.member) != 0i);
                                                if _e996 {
                                                    let _e1002 = type_40(_e975.member, _e975.member_1, (_e975.member_2 + 1u));
                                                    let _e1003 = ((_e518.member_1 & 268435455u) + _e992.member_1);
                                                    let _e1004 = (_e1003 < _e83);
                                                    if _e1004 {
                                                        if _e1004 {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1008 = global_1.member[_e1003].member_1;
                                                        phi_2017_ = _e1008;
                                                    } else {
                                                        phi_2017_ = 4294967295u;
                                                    }
                                                    let _e1010 = phi_2017_;
                                                    if (_e1003 >= _e83) {
                                                        phi_2106_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1004 {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        if (_e448 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1017 = global_1.member[_e1003].member[_e448];
                                                        if (_e454 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1023 = global_1.member[_e1003].member[_e454];
                                                        if (_e460 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1029 = global_1.member[_e1003].member[_e460];
                                                        let _e1031 = (3u + _e448);
                                                        if (_e1031 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1037 = global_1.member[_e1003].member[_e1031];
                                                        let _e1038 = (3u + _e454);
                                                        if (_e1038 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1044 = global_1.member[_e1003].member[_e1038];
                                                        let _e1045 = (3u + _e460);
                                                        if (_e1045 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1051 = global_1.member[_e1003].member[_e1045];
                                                        let _e1053 = (6u + _e448);
                                                        if (_e1053 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1059 = global_1.member[_e1003].member[_e1053];
                                                        let _e1060 = (6u + _e454);
                                                        if (_e1060 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1066 = global_1.member[_e1003].member[_e1060];
                                                        let _e1067 = (6u + _e460);
                                                        if (_e1067 < 9u) {
                                                        } else {
                                                            phi_4386_ = true;
                                                            break;
                                                        }
                                                        let _e1073 = global_1.member[_e1003].member[_e1067];
                                                        phi_2106_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1017, _e1023, _e1029), array<f32, 3>(_e1037, _e1044, _e1051), array<f32, 3>(_e1059, _e1066, _e1073));
                                                    }
                                                    let _e1077 = phi_2106_;
                                                    let _e1086 = (_e1077[0][2] - _e366);
                                                    let _e1089 = (((_e1077[0][0] - _e293) * _e390) - (_e1086 * _e318));
                                                    let _e1092 = (((_e1077[0][1] - _e330) * _e390) - (_e1086 * _e354));
                                                    let _e1099 = (_e1077[1][2] - _e366);
                                                    let _e1102 = (((_e1077[1][0] - _e293) * _e390) - (_e1099 * _e318));
                                                    let _e1105 = (((_e1077[1][1] - _e330) * _e390) - (_e1099 * _e354));
                                                    let _e1112 = (_e1077[2][2] - _e366);
                                                    let _e1115 = (((_e1077[2][0] - _e293) * _e390) - (_e1112 * _e318));
                                                    let _e1118 = (((_e1077[2][1] - _e330) * _e390) - (_e1112 * _e354));
                                                    let _e1119 = (_e1115 * _e1105);
                                                    let _e1120 = (_e1118 * _e1102);
                                                    let _e1121 = (_e1089 * _e1118);
                                                    let _e1122 = (_e1092 * _e1115);
                                                    let _e1123 = (_e1102 * _e1092);
                                                    let _e1124 = (_e1105 * _e1089);
                                                    let _e1129 = (((_e1119 >= _e1120) && (_e1121 >= _e1122)) && (_e1123 >= _e1124));
                                                    if (_e1129 || (((_e1119 <= _e1120) && (_e1121 <= _e1122)) && (_e1123 <= _e1124))) {
                                                        let _e1136 = select(-1f, 1f, _e1129);
                                                        let _e1138 = ((_e1119 - _e1120) * _e1136);
                                                        let _e1140 = select(0f, _e1138, (_e1138 > 0f));
                                                        let _e1142 = ((_e1121 - _e1122) * _e1136);
                                                        let _e1144 = select(0f, _e1142, (_e1142 > 0f));
                                                        let _e1146 = ((_e1123 - _e1124) * _e1136);
                                                        let _e1148 = select(0f, _e1146, (_e1146 > 0f));
                                                        let _e1150 = ((_e1140 + _e1144) + _e1148);
                                                        if (_e1150 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2672_ = type_21();
                                                            phi_2673_ = true;
                                                        } else {
                                                            let _e1153 = select(_e1077[1][0], _e1077[0][0], (_e1077[0][0] < _e1077[1][0]));
                                                            let _e1157 = select(_e1077[1][0], _e1077[0][0], (_e1077[0][0] > _e1077[1][0]));
                                                            let _e1161 = select(_e1077[1][1], _e1077[0][1], (_e1077[0][1] < _e1077[1][1]));
                                                            let _e1165 = select(_e1077[1][1], _e1077[0][1], (_e1077[0][1] > _e1077[1][1]));
                                                            let _e1169 = select(_e1077[1][2], _e1077[0][2], (_e1077[0][2] < _e1077[1][2]));
                                                            let _e1173 = select(_e1077[1][2], _e1077[0][2], (_e1077[0][2] > _e1077[1][2]));
                                                            let _e1178 = ((select(_e1077[2][0], _e1153, (_e1153 < _e1077[2][0])) - _e316) * _e321);
                                                            let _e1179 = ((select(_e1077[2][0], _e1157, (_e1157 > _e1077[2][0])) - _e317) * _e321);
                                                            let _e1182 = ((select(_e1077[2][1], _e1161, (_e1161 < _e1077[2][1])) - _e352) * _e357);
                                                            let _e1183 = ((select(_e1077[2][1], _e1165, (_e1165 > _e1077[2][1])) - _e353) * _e357);
                                                            let _e1186 = ((select(_e1077[2][2], _e1169, (_e1169 < _e1077[2][2])) - _e388) * _e393);
                                                            let _e1187 = ((select(_e1077[2][2], _e1173, (_e1173 > _e1077[2][2])) - _e389) * _e393);
                                                            let _e1189 = select(_e1187, _e1186, (_e1186 < _e1187));
                                                            let _e1191 = select(_e1187, _e1186, (_e1186 > _e1187));
                                                            let _e1193 = select(_e1179, _e1178, (_e1178 < _e1179));
                                                            let _e1195 = select(_e1183, _e1182, (_e1182 < _e1183));
                                                            let _e1197 = select(_e1195, _e1193, (_e1193 > _e1195));
                                                            let _e1199 = select(_e1189, _e1197, (_e1197 > _e1189));
                                                            let _e1201 = select(_e1179, _e1178, (_e1178 > _e1179));
                                                            let _e1203 = select(_e1183, _e1182, (_e1182 > _e1183));
                                                            let _e1205 = select(_e1203, _e1201, (_e1201 < _e1203));
                                                            let _e1207 = select(_e1191, _e1205, (_e1205 < _e1191));
                                                            let _e1208 = -(_e1189);
                                                            let _e1214 = select(_e439, _e1199, (_e1199 > _e439));
                                                            if (_e1214 > (_e1207 + (select(_e1208, _e1191, (_e1191 > _e1208)) * 0.0000019073523f))) {
                                                                phi_2667_ = type_21();
                                                                phi_2668_ = true;
                                                            } else {
                                                                let _e1216 = (_e1214 > _e975.member.member_1);
                                                                if _e1216 {
                                                                    phi_2666_ = type_21();
                                                                } else {
                                                                    let _e1220 = (_e1077[1][0] - _e1077[0][0]);
                                                                    let _e1221 = (_e1077[1][1] - _e1077[0][1]);
                                                                    let _e1222 = (_e1077[1][2] - _e1077[0][2]);
                                                                    let _e1223 = vec3<f32>(_e1220, _e1221, _e1222);
                                                                    let _e1224 = (_e1077[2][0] - _e1077[1][0]);
                                                                    let _e1225 = (_e1077[2][1] - _e1077[1][1]);
                                                                    let _e1226 = (_e1077[2][2] - _e1077[1][2]);
                                                                    let _e1227 = vec3<f32>(_e1224, _e1225, _e1226);
                                                                    let _e1228 = (_e1077[0][0] - _e1077[2][0]);
                                                                    let _e1229 = (_e1077[0][1] - _e1077[2][1]);
                                                                    let _e1230 = (_e1077[0][2] - _e1077[2][2]);
                                                                    let _e1231 = vec3<f32>(_e1228, _e1229, _e1230);
                                                                    let _e1234 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                    let _e1237 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                    let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                    let _e1242 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                    let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                    let _e1247 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                    let _e1250 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                    let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                    let _e1255 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                    let _e1257 = select(_e1255, _e1252, (_e1252 > _e1255));
                                                                    let _e1260 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                    let _e1263 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                    let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                    let _e1268 = bitcast<f32>((bitcast<u32>(_e1230) & 2147483647u));
                                                                    let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                    let _e1272 = select(_e1257, _e1244, (_e1244 > _e1257));
                                                                    let _e1274 = select(_e1270, _e1272, (_e1272 > _e1270));
                                                                    if (_e1244 == _e1274) {
                                                                        phi_2577_ = _e1227;
                                                                        phi_2578_ = _e1231;
                                                                    } else {
                                                                        let _e1277 = vec3((_e1257 == _e1274));
                                                                        phi_2577_ = select(_e1223, _e1231, _e1277);
                                                                        phi_2578_ = select(_e1227, _e1223, _e1277);
                                                                    }
                                                                    let _e1281 = phi_2577_;
                                                                    let _e1283 = phi_2578_;
                                                                    let _e1290 = ((_e1281.y * _e1283.z) - (_e1283.y * _e1281.z));
                                                                    let _e1295 = ((_e1281.z * _e1283.x) - (_e1283.z * _e1281.x));
                                                                    let _e1298 = ((_e1281.x * _e1283.y) - (_e1283.x * _e1281.y));
                                                                    if (_e1140 >= _e1144) {
                                                                        phi_2609_ = select(true, false, (_e1140 >= _e1148));
                                                                    } else {
                                                                        phi_2609_ = true;
                                                                    }
                                                                    let _e1303 = phi_2609_;
                                                                    if _e1303 {
                                                                        phi_2618_ = select(vec3<f32>(_e1077[2][0], _e1077[2][1], _e1077[2][2]), vec3<f32>(_e1077[1][0], _e1077[1][1], _e1077[1][2]), vec3((_e1144 >= _e1148)));
                                                                    } else {
                                                                        phi_2618_ = vec3<f32>(_e1077[0][0], _e1077[0][1], _e1077[0][2]);
                                                                    }
                                                                    let _e1308 = phi_2618_;
                                                                    let _e1325 = ((((_e1290 * (_e1308.x - _e293)) + (_e1295 * (_e1308.y - _e330))) + (_e1298 * (_e1308.z - _e366))) / (((_e1290 * _e318) + (_e1295 * _e354)) + (_e1298 * _e390)));
                                                                    let _e1327 = select(_e1207, _e1325, (_e1325 < _e1207));
                                                                    let _e1329 = select(_e1199, _e1327, (_e1327 > _e1199));
                                                                    if (_e1329 >= _e439) {
                                                                        let _e1331 = (_e1329 <= _e975.member.member_1);
                                                                        if _e1331 {
                                                                            let _e1332 = (1f / _e1150);
                                                                            phi_2658_ = type_21(_e1329, (_e1144 * _e1332), (_e1148 * _e1332), _e1010);
                                                                        } else {
                                                                            phi_2658_ = type_21();
                                                                        }
                                                                        let _e1337 = phi_2658_;
                                                                        phi_2660_ = _e1337;
                                                                        phi_2661_ = select(true, false, _e1331);
                                                                    } else {
                                                                        phi_2660_ = type_21();
                                                                        phi_2661_ = true;
                                                                    }
                                                                    let _e1340 = phi_2660_;
                                                                    let _e1342 = phi_2661_;
                                                                    if _e1342 {
                                                                        phi_2665_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2665_ = _e1340;
                                                                    }
                                                                    let _e1344 = phi_2665_;
                                                                    phi_2666_ = _e1344;
                                                                }
                                                                let _e1346 = phi_2666_;
                                                                phi_2667_ = _e1346;
                                                                phi_2668_ = _e1216;
                                                            }
                                                            let _e1348 = phi_2667_;
                                                            let _e1350 = phi_2668_;
                                                            phi_2672_ = _e1348;
                                                            phi_2673_ = _e1350;
                                                        }
                                                        let _e1352 = phi_2672_;
                                                        let _e1354 = phi_2673_;
                                                        phi_2677_ = _e1352;
                                                        phi_2678_ = _e1354;
                                                    } else {
                                                        phi_2677_ = type_21();
                                                        phi_2678_ = true;
                                                    }
                                                    let _e1356 = phi_2677_;
                                                    let _e1358 = phi_2678_;
                                                    if _e1358 {
                                                        phi_2682_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2682_ = _e1356;
                                                    }
                                                    let _e1360 = phi_2682_;
                                                    if (_e1360.member_3 != 4294967295u) {
                                                        if (_e1010 != _e445) {
                                                            if (_e1360.member < _e975.member.member.member) {
                                                                phi_2708_ = true;
                                                            } else {
                                                                if (_e1360.member == _e975.member.member.member) {
                                                                    phi_2707_ = (_e1360.member_3 < _e975.member.member.member_3);
                                                                } else {
                                                                    phi_2707_ = false;
                                                                }
                                                                let _e1375 = phi_2707_;
                                                                phi_2708_ = _e1375;
                                                            }
                                                            let _e1377 = phi_2708_;
                                                            if _e1377 {
                                                                phi_2715_ = type_40(type_36(_e1360, _e1360.member), _e1002.member_1, _e1002.member_2);
                                                            } else {
                                                                phi_2715_ = _e1002;
                                                            }
                                                            let _e1384 = phi_2715_;
                                                            phi_2716_ = _e1384;
                                                        } else {
                                                            phi_2716_ = _e1002;
                                                        }
                                                        let _e1386 = phi_2716_;
                                                        phi_2717_ = _e1386;
                                                    } else {
                                                        phi_2717_ = _e1002;
                                                    }
                                                    let _e1388 = phi_2717_;
                                                    phi_1968_ = _e1388;
                                                } else {
                                                    phi_1968_ = type_40();
                                                }
                                                let _e1390 = phi_1968_;
                                                continue;
                                                continuing {
                                                    phi_1967_ = _e1390;
                                                    phi_1970_ = _e990;
                                                    phi_4386_ = _e486;
                                                    break if !(_e996);
                                                }
                                            }
                                            let _e1393 = phi_4386_;
                                            phi_4500_ = _e1393;
                                            if _e1393 {
                                                break;
                                            }
                                            phi_4504_ = _e1393;
                                            let _e1610 = local_6;
                                            phi_4023_ = _e1610;
                                            phi_4024_ = _e518;
                                            phi_4025_ = false;
                                            phi_4026_ = _e522;
                                        } else {
                                            if (_e518.member_1 >= _e81) {
                                                phi_3623_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e518.member_1 < _e81) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e541 = ((1u + (_e261 * 2u)) % 7u);
                                                if (_e541 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e546 = global_7.member[_e518.member_1][_e541];
                                                let _e549 = ((1u + (_e260 * 2u)) % 7u);
                                                if (_e549 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e554 = global_7.member[_e518.member_1][_e549];
                                                let _e557 = ((1u + (_e262 * 2u)) % 7u);
                                                if (_e557 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e562 = global_7.member[_e518.member_1][_e557];
                                                let _e565 = (((_e261 + 1u) * 2u) % 7u);
                                                if (_e565 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e570 = global_7.member[_e518.member_1][_e565];
                                                let _e573 = (((_e260 + 1u) * 2u) % 7u);
                                                if (_e573 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e578 = global_7.member[_e518.member_1][_e573];
                                                let _e581 = (((_e262 + 1u) * 2u) % 7u);
                                                if (_e581 < 7u) {
                                                } else {
                                                    phi_4500_ = true;
                                                    break;
                                                }
                                                let _e586 = global_7.member[_e518.member_1][_e581];
                                                let _e609 = (bitcast<f32>((bitcast<u32>((_e518.member.member_1.x - _e518.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e610 = (bitcast<f32>((bitcast<u32>((_e518.member.member_1.y - _e518.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e611 = (bitcast<f32>((bitcast<u32>((_e518.member.member_1.z - _e518.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e613 = select(_e135, _e609, (_e609 > _e135));
                                                let _e615 = select(_e135, _e610, (_e610 > _e135));
                                                let _e617 = select(_e135, _e611, (_e611 > _e135));
                                                let _e642 = bitcast<u32>((f32(bitcast<i32>((_e546 & 2097151u))) * _e613));
                                                let _e647 = (bitcast<i32>((_e546 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                                let _e651 = bitcast<u32>((f32(bitcast<i32>((_e554 & 2097151u))) * _e615));
                                                let _e656 = (bitcast<i32>((_e554 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                                let _e660 = bitcast<u32>((f32(bitcast<i32>((_e562 & 2097151u))) * _e617));
                                                let _e665 = (bitcast<i32>((_e562 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                                let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                                let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                                let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                                let _e681 = bitcast<u32>((f32(bitcast<i32>((_e570 & 2097151u))) * _e613));
                                                let _e686 = (bitcast<i32>((_e570 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                                let _e690 = bitcast<u32>((f32(bitcast<i32>((_e578 & 2097151u))) * _e615));
                                                let _e695 = (bitcast<i32>((_e578 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                                let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 2097151u))) * _e617));
                                                let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                                let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                                let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                                let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                                let _e749 = global_7.member[_e518.member_1][0u];
                                                let _e753 = global_7.member[_e518.member_1][2u];
                                                let _e757 = global_7.member[_e518.member_1][4u];
                                                let _e761 = global_7.member[_e518.member_1][6u];
                                                let _e773 = (((_e753 >> bitcast<u32>(22i)) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e761 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e774 = (_e749 & 268435455u);
                                                let _e775 = (_e773 & 268435455u);
                                                let _e778 = ((_e749 >> bitcast<u32>(28u)) & 7u);
                                                let _e786 = ((_e749 >> bitcast<u32>(31i)) | (((_e773 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e787 = (_e778 != 0u);
                                                if (_e778 == 0u) {
                                                    phi_3585_ = _e774;
                                                } else {
                                                    if (_e778 == 7u) {
                                                        phi_3584_ = 2147483648u;
                                                    } else {
                                                        phi_3584_ = ((2147483648u | (_e778 << bitcast<u32>(28u))) | (_e775 & 268435455u));
                                                    }
                                                    let _e796 = phi_3584_;
                                                    phi_3585_ = _e796;
                                                }
                                                let _e798 = phi_3585_;
                                                if _e787 {
                                                    let _e799 = (_e778 != 7u);
                                                    if _e799 {
                                                        phi_3595_ = (_e775 + _e778);
                                                    } else {
                                                        phi_3595_ = u32();
                                                    }
                                                    let _e802 = phi_3595_;
                                                    phi_3597_ = _e802;
                                                    phi_3598_ = select(true, false, _e799);
                                                } else {
                                                    phi_3597_ = u32();
                                                    phi_3598_ = true;
                                                }
                                                let _e805 = phi_3597_;
                                                let _e807 = phi_3598_;
                                                if (_e786 == 0u) {
                                                    phi_3619_ = (_e774 + select(0u, 1u, !(_e787)));
                                                } else {
                                                    if (_e786 == 7u) {
                                                        phi_3618_ = 2147483648u;
                                                    } else {
                                                        phi_3618_ = ((2147483648u | (_e786 << bitcast<u32>(28u))) | (select(_e805, _e775, _e807) & 268435455u));
                                                    }
                                                    let _e820 = phi_3618_;
                                                    phi_3619_ = _e820;
                                                }
                                                let _e822 = phi_3619_;
                                                phi_3623_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e518.member.member.x + _e650), (_e518.member.member.x + _e672), (_e518.member.member_1.x - _e689), (_e518.member.member_1.x - _e711)), vec4<f32>((_e518.member.member.y + _e659), (_e518.member.member.y + _e676), (_e518.member.member_1.y - _e698), (_e518.member.member_1.y - _e715)), vec4<f32>((_e518.member.member.z + _e668), (_e518.member.member.z + _e680), (_e518.member.member_1.z - _e707), (_e518.member.member_1.z - _e719))), type_51(type_33((_e518.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e518.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e798), type_51(type_33((_e518.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e518.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e822));
                                            }
                                            let _e827 = phi_3623_;
                                            let _e840 = ((_e827.member[0].x - _e316) * _e321);
                                            let _e841 = ((_e827.member[0].y - _e316) * _e321);
                                            let _e842 = ((_e827.member[0].z - _e317) * _e321);
                                            let _e843 = ((_e827.member[0].w - _e317) * _e321);
                                            let _e853 = ((_e827.member[1].x - _e352) * _e357);
                                            let _e854 = ((_e827.member[1].y - _e352) * _e357);
                                            let _e855 = ((_e827.member[1].z - _e353) * _e357);
                                            let _e856 = ((_e827.member[1].w - _e353) * _e357);
                                            let _e866 = ((_e827.member[2].x - _e388) * _e393);
                                            let _e867 = ((_e827.member[2].y - _e388) * _e393);
                                            let _e868 = ((_e827.member[2].z - _e389) * _e393);
                                            let _e869 = ((_e827.member[2].w - _e389) * _e393);
                                            let _e871 = select(_e868, _e866, (_e866 < _e868));
                                            let _e873 = select(_e869, _e867, (_e867 < _e869));
                                            let _e875 = select(_e868, _e866, (_e866 > _e868));
                                            let _e877 = select(_e869, _e867, (_e867 > _e869));
                                            let _e879 = select(_e842, _e840, (_e840 < _e842));
                                            let _e881 = select(_e843, _e841, (_e841 < _e843));
                                            let _e883 = select(_e855, _e853, (_e853 < _e855));
                                            let _e885 = select(_e856, _e854, (_e854 < _e856));
                                            let _e887 = select(_e883, _e879, (_e879 > _e883));
                                            let _e889 = select(_e885, _e881, (_e881 > _e885));
                                            let _e891 = select(_e871, _e887, (_e887 > _e871));
                                            let _e893 = select(_e873, _e889, (_e889 > _e873));
                                            let _e895 = select(_e842, _e840, (_e840 > _e842));
                                            let _e897 = select(_e843, _e841, (_e841 > _e843));
                                            let _e899 = select(_e855, _e853, (_e853 > _e855));
                                            let _e901 = select(_e856, _e854, (_e854 > _e856));
                                            let _e903 = select(_e899, _e895, (_e895 < _e899));
                                            let _e905 = select(_e901, _e897, (_e897 < _e901));
                                            let _e910 = -(_e871);
                                            let _e911 = -(_e873);
                                            let _e918 = (select(_e875, _e903, (_e903 < _e875)) + (select(_e910, _e875, (_e875 > _e910)) * 0.0000019073523f));
                                            let _e919 = (select(_e877, _e905, (_e905 < _e877)) + (select(_e911, _e877, (_e877 > _e911)) * 0.0000019073523f));
                                            let _e921 = select(_e439, _e891, (_e891 > _e439));
                                            let _e923 = select(_e439, _e893, (_e893 > _e439));
                                            let _e928 = (_e921 <= select(_e488.member.member_1, _e918, (_e918 < _e488.member.member_1)));
                                            let _e929 = (_e923 <= select(_e488.member.member_1, _e919, (_e919 < _e488.member.member_1)));
                                            let _e930 = (_e921 <= _e923);
                                            if _e928 {
                                                if _e929 {
                                                    if _e930 {
                                                        phi_3967_ = _e827.member_2;
                                                    } else {
                                                        phi_3967_ = _e827.member_1;
                                                    }
                                                    let _e934 = phi_3967_;
                                                    let _e935 = (_e522 % 128u);
                                                    let _e936 = (_e935 < 128u);
                                                    if _e936 {
                                                    } else {
                                                        phi_4500_ = true;
                                                        break;
                                                    }
                                                    local_3[_e935] = type_51(type_33(_e934.member.member, _e934.member.member_1), _e934.member_1);
                                                    if _e936 {
                                                    } else {
                                                        phi_4500_ = true;
                                                        break;
                                                    }
                                                    local_2[_e935] = select(_e923, _e921, (_e921 > _e923));
                                                    if _e930 {
                                                        phi_4000_ = _e827.member_1;
                                                    } else {
                                                        phi_4000_ = _e827.member_2;
                                                    }
                                                    let _e951 = phi_4000_;
                                                    phi_4001_ = _e951;
                                                    phi_4002_ = (_e522 + 1u);
                                                } else {
                                                    phi_4001_ = type_51();
                                                    phi_4002_ = u32();
                                                }
                                                let _e953 = phi_4001_;
                                                let _e955 = phi_4002_;
                                                phi_4004_ = _e953;
                                                phi_4005_ = _e955;
                                                phi_4006_ = select(true, false, _e929);
                                            } else {
                                                phi_4004_ = type_51();
                                                phi_4005_ = u32();
                                                phi_4006_ = true;
                                            }
                                            let _e958 = phi_4004_;
                                            let _e960 = phi_4005_;
                                            let _e962 = phi_4006_;
                                            if _e962 {
                                                if _e928 {
                                                    phi_4015_ = _e827.member_1;
                                                } else {
                                                    phi_4015_ = _e827.member_2;
                                                }
                                                let _e966 = phi_4015_;
                                                phi_4020_ = _e966;
                                                phi_4021_ = select(_e929, true, _e928);
                                            } else {
                                                phi_4020_ = _e958;
                                                phi_4021_ = _e520;
                                            }
                                            let _e969 = phi_4020_;
                                            let _e971 = phi_4021_;
                                            phi_4504_ = _e486;
                                            phi_4023_ = type_40(_e488.member, (_e488.member_1 + 1u), _e488.member_2);
                                            phi_4024_ = _e969;
                                            phi_4025_ = _e971;
                                            phi_4026_ = select(_e960, _e522, _e962);
                                        }
                                        let _e1395 = phi_4504_;
                                        let _e1397 = phi_4023_;
                                        let _e1399 = phi_4024_;
                                        let _e1401 = phi_4025_;
                                        let _e1403 = phi_4026_;
                                        phi_4503_ = _e1395;
                                        phi_4027_ = _e1397;
                                        phi_4028_ = _e1399;
                                        phi_4029_ = (_e492 - 1u);
                                        phi_4030_ = _e1401;
                                        phi_4031_ = _e1403;
                                    } else {
                                        phi_4503_ = _e486;
                                        phi_4027_ = _e488;
                                        phi_4028_ = _e518;
                                        phi_4029_ = _e492;
                                        phi_4030_ = _e520;
                                        phi_4031_ = _e522;
                                    }
                                    let _e1405 = phi_4503_;
                                    let _e1407 = phi_4027_;
                                    let _e1409 = phi_4028_;
                                    let _e1411 = phi_4029_;
                                    let _e1413 = phi_4030_;
                                    let _e1415 = phi_4031_;
                                    phi_4502_ = _e1405;
                                    phi_4032_ = _e1407;
                                    phi_4033_ = _e1409;
                                    phi_4034_ = _e1411;
                                    phi_4035_ = _e1413;
                                    phi_4036_ = _e1415;
                                } else {
                                    phi_4502_ = _e486;
                                    phi_4032_ = type_40();
                                    phi_4033_ = type_51();
                                    phi_4034_ = u32();
                                    phi_4035_ = bool();
                                    phi_4036_ = u32();
                                }
                                let _e1417 = phi_4502_;
                                let _e1419 = phi_4032_;
                                let _e1421 = phi_4033_;
                                let _e1423 = phi_4034_;
                                let _e1425 = phi_4035_;
                                let _e1427 = phi_4036_;
                                phi_4501_ = _e1417;
                                phi_1891_ = _e1419;
                                phi_1894_ = _e1421;
                                phi_1896_ = _e1423;
                                phi_1898_ = _e1425;
                                phi_1900_ = _e1427;
                                phi_4037_ = _e500;
                            } else {
                                phi_4501_ = _e486;
                                phi_1891_ = type_40();
                                phi_1894_ = type_51();
                                phi_1896_ = u32();
                                phi_1898_ = bool();
                                phi_1900_ = u32();
                                phi_4037_ = false;
                            }
                            let _e1429 = phi_4501_;
                            let _e1431 = phi_1891_;
                            let _e1433 = phi_1894_;
                            let _e1435 = phi_1896_;
                            let _e1437 = phi_1898_;
                            let _e1439 = phi_1900_;
                            let _e1441 = phi_4037_;
                            continue;
                            continuing {
                                phi_4392_ = _e1429;
                                phi_1890_ = _e1431;
                                phi_1893_ = _e1433;
                                phi_1895_ = _e1435;
                                phi_1897_ = _e1437;
                                phi_1899_ = _e1439;
                                phi_4500_ = _e1429;
                                break if !(_e1441);
                            }
                        }
                        let _e1444 = phi_4500_;
                        if _e1444 {
                            break;
                        }
                        let _e1446 = local_4;
                        if (_e1446.member.member.member_3 != 4294967295u) {
                            let _e1452 = (_e263 / 3i);
                            let _e1459 = bitcast<f32>((bitcast<u32>((_e1452 + 127i)) << bitcast<u32>(23i)));
                            let _e1467 = (((_e1446.member.member.member * _e1459) * _e1459) * bitcast<f32>((bitcast<u32>(((_e263 - (2i * _e1452)) + 127i)) << bitcast<u32>(23i))));
                            let _e1469 = select(340282350000000000000000000000000000000f, _e1467, (_e1467 < 340282350000000000000000000000000000000f));
                            phi_4089_ = type_21(select(-340282350000000000000000000000000000000f, _e1469, (_e1469 > -340282350000000000000000000000000000000f)), _e1446.member.member.member_1, _e1446.member.member.member_2, _e1446.member.member.member_3);
                        } else {
                            phi_4089_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1476 = phi_4089_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_2.member[_e123] = _e1476;
                        let _e1480 = local_5;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_5.member[_e123] = _e1480.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1485 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1485 > 0u) {
                            let _e1487 = (1u < _e91);
                            if _e1487 {
                                if (0u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1491 = atomicAdd((&global_6.member[0u]), _e1485);
                                if ((_e1491 + _e1485) < _e1491) {
                                    if _e1487 {
                                    } else {
                                        break;
                                    }
                                    let _e1496 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1499 = select(0u, 1u, (_e1476.member_3 != 4294967295u));
                        if (_e1499 > 0u) {
                            let _e1501 = (3u < _e91);
                            if _e1501 {
                                if (2u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1505 = atomicAdd((&global_6.member[2u]), _e1499);
                                if ((_e1505 + _e1499) < _e1505) {
                                    if _e1501 {
                                    } else {
                                        break;
                                    }
                                    let _e1510 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1480.member_1 > 0u) {
                            let _e1512 = (5u < _e91);
                            if _e1512 {
                                if (4u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1516 = atomicAdd((&global_6.member[4u]), _e1480.member_1);
                                if ((_e1516 + _e1480.member_1) < _e1516) {
                                    if _e1512 {
                                    } else {
                                        break;
                                    }
                                    let _e1521 = atomicAdd((&global_6.member[5u]), 1u);
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
