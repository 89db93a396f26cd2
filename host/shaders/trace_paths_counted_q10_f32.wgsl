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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_25,
    member_1: f32,
}

struct type_44 {
    member: type_40,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_37,
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
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_27;
@group(0) @binding(0) 
var<uniform> global_3: type_46;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

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
    var phi_465_: f32;
    var phi_471_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_511_: f32;
    var phi_522_: f32;
    var phi_531_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_577_: f32;
    var phi_588_: f32;
    var phi_597_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_643_: f32;
    var phi_654_: f32;
    var phi_754_: f32;
    var phi_755_: f32;
    var phi_4386_: bool;
    var phi_1884_: type_44;
    var phi_1887_: type_51;
    var phi_1889_: u32;
    var phi_1891_: bool;
    var phi_1893_: u32;
    var phi_1904_: bool;
    var phi_1941_: type_51;
    var phi_1942_: bool;
    var phi_1943_: u32;
    var phi_3578_: u32;
    var phi_3579_: u32;
    var phi_3589_: u32;
    var phi_3591_: u32;
    var phi_3592_: bool;
    var phi_3612_: u32;
    var phi_3613_: u32;
    var phi_3617_: type_54;
    var phi_3961_: type_51;
    var phi_3994_: type_51;
    var phi_3995_: type_51;
    var phi_3996_: u32;
    var phi_3998_: type_51;
    var phi_3999_: u32;
    var phi_4000_: bool;
    var phi_4009_: type_51;
    var phi_4014_: type_51;
    var phi_4015_: bool;
    var phi_1961_: type_44;
    var phi_1964_: type_7;
    var phi_1965_: type_7;
    var phi_1987_: type_7;
    var phi_2011_: u32;
    var phi_2100_: array<array<f32, 3>, 3>;
    var phi_2571_: vec3<f32>;
    var phi_2572_: vec3<f32>;
    var phi_2603_: bool;
    var phi_2612_: vec3<f32>;
    var phi_2652_: type_25;
    var phi_2654_: type_25;
    var phi_2655_: bool;
    var phi_2659_: type_25;
    var phi_2660_: type_25;
    var phi_2661_: type_25;
    var phi_2662_: bool;
    var phi_2666_: type_25;
    var phi_2667_: bool;
    var phi_2671_: type_25;
    var phi_2672_: bool;
    var phi_2676_: type_25;
    var phi_2701_: bool;
    var phi_2702_: bool;
    var phi_2709_: type_44;
    var phi_2710_: type_44;
    var phi_2711_: type_44;
    var phi_1962_: type_44;
    var phi_4380_: bool;
    var phi_4494_: bool;
    var phi_4017_: type_44;
    var phi_4018_: type_51;
    var phi_4019_: bool;
    var phi_4020_: u32;
    var phi_4493_: bool;
    var phi_4021_: type_44;
    var phi_4022_: type_51;
    var phi_4023_: u32;
    var phi_4024_: bool;
    var phi_4025_: u32;
    var phi_4492_: bool;
    var phi_4026_: type_44;
    var phi_4027_: type_51;
    var phi_4028_: u32;
    var phi_4029_: bool;
    var phi_4030_: u32;
    var phi_4491_: bool;
    var phi_1885_: type_44;
    var phi_1888_: type_51;
    var phi_1890_: u32;
    var phi_1892_: bool;
    var phi_1894_: u32;
    var phi_4031_: bool;
    var phi_4490_: bool;
    var local_4: type_44;
    var phi_4083_: type_25;
    var local_5: type_44;
    var local_6: type_44;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e81 = arrayLength((&global_4.member));
            let _e83 = arrayLength((&global_1.member));
            let _e91 = arrayLength((&global_7.member));
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
            let _e138 = (_e123 < arrayLength((&global_5.member)));
            if _e138 {
                let _e139 = (_e123 < arrayLength((&global_2.member)));
                if _e139 {
                    let _e140 = (_e123 < arrayLength((&global_6.member)));
                    if _e140 {
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e150 = global_5.member[_e123].member.member_2[0u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_5.member[_e123].member.member_2[1u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_5.member[_e123].member.member_2[2u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_5.member[_e123].member.member[0u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_5.member[_e123].member.member[1u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e190 = global_5.member[_e123].member.member[2u];
                        let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                        let _e194 = select(_e160, _e152, (_e160 < _e152));
                        let _e196 = select(_e168, _e194, (_e168 < _e194));
                        let _e198 = select(_e176, _e196, (_e176 < _e196));
                        let _e200 = select(_e184, _e198, (_e184 < _e198));
                        let _e202 = select(_e192, _e200, (_e192 < _e200));
                        let _e207 = global_5.member[_e123].member.member_1;
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e217 = global_5.member[_e123].member.member_3;
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
                        let _e264 = (_e263 / 2i);
                        let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                        let _e275 = bitcast<f32>((bitcast<u32>(((_e263 - _e264) + 127i)) << bitcast<u32>(23i)));
                        let _e280 = global_5.member[_e123].member.member;
                        let _e281 = (_e261 == 0u);
                        if _e281 {
                            phi_465_ = _e280[0];
                        } else {
                            phi_465_ = _e280[1];
                        }
                        let _e285 = phi_465_;
                        let _e286 = (_e261 == 2u);
                        if _e286 {
                            phi_471_ = _e280[2];
                        } else {
                            phi_471_ = _e285;
                        }
                        let _e289 = phi_471_;
                        let _e290 = global_5.member[_e123].member.member_2;
                        if _e281 {
                            phi_482_ = _e290[0];
                        } else {
                            phi_482_ = _e290[1];
                        }
                        let _e294 = phi_482_;
                        if _e286 {
                            phi_488_ = _e290[2];
                        } else {
                            phi_488_ = _e294;
                        }
                        let _e297 = phi_488_;
                        let _e299 = ((_e297 * _e269) * _e275);
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e303 {
                            let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                            phi_511_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                        } else {
                            phi_511_ = 0f;
                        }
                        let _e311 = phi_511_;
                        let _e312 = (_e289 + _e311);
                        let _e313 = (_e289 - _e311);
                        let _e314 = select(_e299, 0f, _e303);
                        if _e303 {
                            phi_522_ = 38685626000000000000000000f;
                        } else {
                            phi_522_ = (1f / _e299);
                        }
                        let _e317 = phi_522_;
                        let _e318 = (_e260 == 0u);
                        if _e318 {
                            phi_531_ = _e280[0];
                        } else {
                            phi_531_ = _e280[1];
                        }
                        let _e322 = phi_531_;
                        let _e323 = (_e260 == 2u);
                        if _e323 {
                            phi_537_ = _e280[2];
                        } else {
                            phi_537_ = _e322;
                        }
                        let _e326 = phi_537_;
                        if _e318 {
                            phi_548_ = _e290[0];
                        } else {
                            phi_548_ = _e290[1];
                        }
                        let _e330 = phi_548_;
                        if _e323 {
                            phi_554_ = _e290[2];
                        } else {
                            phi_554_ = _e330;
                        }
                        let _e333 = phi_554_;
                        let _e335 = ((_e333 * _e269) * _e275);
                        let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e339 {
                            let _e343 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                            phi_577_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                        } else {
                            phi_577_ = 0f;
                        }
                        let _e347 = phi_577_;
                        let _e348 = (_e326 + _e347);
                        let _e349 = (_e326 - _e347);
                        let _e350 = select(_e335, 0f, _e339);
                        if _e339 {
                            phi_588_ = 38685626000000000000000000f;
                        } else {
                            phi_588_ = (1f / _e335);
                        }
                        let _e353 = phi_588_;
                        let _e354 = (_e262 == 0u);
                        if _e354 {
                            phi_597_ = _e280[0];
                        } else {
                            phi_597_ = _e280[1];
                        }
                        let _e358 = phi_597_;
                        let _e359 = (_e262 == 2u);
                        if _e359 {
                            phi_603_ = _e280[2];
                        } else {
                            phi_603_ = _e358;
                        }
                        let _e362 = phi_603_;
                        if _e354 {
                            phi_614_ = _e290[0];
                        } else {
                            phi_614_ = _e290[1];
                        }
                        let _e366 = phi_614_;
                        if _e359 {
                            phi_620_ = _e290[2];
                        } else {
                            phi_620_ = _e366;
                        }
                        let _e369 = phi_620_;
                        let _e371 = ((_e369 * _e269) * _e275);
                        let _e375 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e375 {
                            let _e379 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) * 0.00000011920929f);
                            phi_643_ = select(0.00000000000011368684f, _e379, (_e379 > 0.00000000000011368684f));
                        } else {
                            phi_643_ = 0f;
                        }
                        let _e383 = phi_643_;
                        let _e384 = (_e362 + _e383);
                        let _e385 = (_e362 - _e383);
                        let _e386 = select(_e371, 0f, _e375);
                        if _e375 {
                            phi_654_ = 38685626000000000000000000f;
                        } else {
                            phi_654_ = (1f / _e371);
                        }
                        let _e389 = phi_654_;
                        let _e392 = bitcast<f32>((bitcast<u32>(_e289) & 2147483647u));
                        let _e395 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                        let _e397 = select(_e395, _e392, (_e392 > _e395));
                        let _e400 = bitcast<f32>((bitcast<u32>(_e362) & 2147483647u));
                        if (_e223 && (select(_e400, _e397, (_e397 > _e400)) <= 1099511600000f)) {
                            let _e405 = (_e242 / 3i);
                            let _e412 = bitcast<f32>((bitcast<u32>((_e405 + 127i)) << bitcast<u32>(23i)));
                            let _e419 = bitcast<f32>((bitcast<u32>(((_e242 - (2i * _e405)) + 127i)) << bitcast<u32>(23i)));
                            let _e420 = (((_e207 * _e412) * _e412) * _e419);
                            let _e422 = select(340282350000000000000000000000000000000f, _e420, (_e420 < 340282350000000000000000000000000000000f));
                            let _e427 = (((_e217 * _e412) * _e412) * _e419);
                            let _e429 = select(340282350000000000000000000000000000000f, _e427, (_e427 < 340282350000000000000000000000000000000f));
                            phi_754_ = select(-340282350000000000000000000000000000000f, _e429, (_e429 > -340282350000000000000000000000000000000f));
                            phi_755_ = select(-340282350000000000000000000000000000000f, _e422, (_e422 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_754_ = 0f;
                            phi_755_ = 1f;
                        }
                        let _e433 = phi_754_;
                        let _e435 = phi_755_;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e441 = global_5.member[_e123].member_2;
                        local_3 = array<type_51, 128>(type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e444 = (_e261 % 3u);
                        let _e445 = (_e444 < 3u);
                        if _e445 {
                        } else {
                            break;
                        }
                        let _e447 = local_1[_e444];
                        let _e450 = (_e260 % 3u);
                        let _e451 = (_e450 < 3u);
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = local_1[_e450];
                        let _e456 = (_e262 % 3u);
                        let _e457 = (_e456 < 3u);
                        if _e457 {
                        } else {
                            break;
                        }
                        let _e459 = local_1[_e456];
                        if _e445 {
                        } else {
                            break;
                        }
                        let _e464 = local[_e444];
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e468 = local[_e450];
                        if _e457 {
                        } else {
                            break;
                        }
                        let _e472 = local[_e456];
                        phi_4386_ = false;
                        phi_1884_ = type_44(type_40(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e433), 0u, 0u);
                        phi_1887_ = type_51(type_37(vec4<f32>((f32(_e447) * _e135), (f32(_e453) * _e135), (f32(_e459) * _e135), 0f), vec4<f32>((f32(_e464) * _e135), (f32(_e468) * _e135), (f32(_e472) * _e135), 0f)), select(0u, 2147483648u, (_e81 == 0u)));
                        phi_1889_ = ((3u * _e81) + 1u);
                        phi_1891_ = (_e435 <= _e433);
                        phi_1893_ = 0u;
                        loop {
                            let _e482 = phi_4386_;
                            let _e484 = phi_1884_;
                            let _e486 = phi_1887_;
                            let _e488 = phi_1889_;
                            let _e490 = phi_1891_;
                            let _e492 = phi_1893_;
                            local_4 = _e484;
                            local_5 = _e484;
                            if _e490 {
                                phi_1904_ = true;
                            } else {
                                phi_1904_ = (_e492 > 0u);
                            }
                            let _e495 = phi_1904_;
                            if _e495 {
                                let _e496 = (_e488 > 0u);
                                if _e496 {
                                    if _e490 {
                                        phi_1941_ = _e486;
                                        phi_1942_ = _e490;
                                        phi_1943_ = _e492;
                                    } else {
                                        let _e497 = (_e492 - 1u);
                                        let _e498 = (_e497 % 128u);
                                        let _e499 = (_e498 < 128u);
                                        if _e499 {
                                        } else {
                                            phi_4490_ = true;
                                            break;
                                        }
                                        let _e501 = local_3[_e498];
                                        if _e499 {
                                        } else {
                                            phi_4490_ = true;
                                            break;
                                        }
                                        let _e509 = local_2[_e498];
                                        phi_1941_ = type_51(type_37(_e501.member.member, _e501.member.member_1), _e501.member_1);
                                        phi_1942_ = (_e509 <= _e484.member.member_1);
                                        phi_1943_ = _e497;
                                    }
                                    let _e514 = phi_1941_;
                                    let _e516 = phi_1942_;
                                    let _e518 = phi_1943_;
                                    if _e516 {
                                        if ((_e514.member_1 & 2147483648u) != 0u) {
                                            phi_1961_ = _e484;
                                            phi_1964_ = type_7(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e971 = phi_1961_;
                                                let _e973 = phi_1964_;
                                                local_6 = _e971;
                                                if (_e973.member < _e973.member_1) {
                                                    phi_1965_ = type_7((_e973.member + 1u), _e973.member_1);
                                                    phi_1987_ = type_7(1u, _e973.member);
                                                } else {
                                                    phi_1965_ = _e973;
                                                    phi_1987_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e986 = phi_1965_;
                                                let _e988 = phi_1987_;
                                                let _e992 = (bitcast<i32>(_e988.member) != 0i);
                                                if _e992 {
                                                    let _e998 = type_44(_e971.member, _e971.member_1, (_e971.member_2 + 1u));
                                                    let _e999 = ((_e514.member_1 & 268435455u) + _e988.member_1);
                                                    let _e1000 = (_e999 < _e83);
                                                    if _e1000 {
                                                        if _e1000 {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1004 = global_1.member[_e999].member_1;
                                                        phi_2011_ = _e1004;
                                                    } else {
                                                        phi_2011_ = 4294967295u;
                                                    }
                                                    let _e1006 = phi_2011_;
                                                    if (_e999 >= _e83) {
                                                        phi_2100_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1000 {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        if (_e444 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1013 = global_1.member[_e999].member[_e444];
                                                        if (_e450 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1019 = global_1.member[_e999].member[_e450];
                                                        if (_e456 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1025 = global_1.member[_e999].member[_e456];
                                                        let _e1027 = (3u + _e444);
                                                        if (_e1027 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1033 = global_1.member[_e999].member[_e1027];
                                                        let _e1034 = (3u + _e450);
                                                        if (_e1034 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1040 = global_1.member[_e999].member[_e1034];
                                                        let _e1041 = (3u + _e456);
                                                        if (_e1041 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1047 = global_1.member[_e999].member[_e1041];
                                                        let _e1049 = (6u + _e444);
                                                        if (_e1049 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1055 = global_1.member[_e999].member[_e1049];
                                                        let _e1056 = (6u + _e450);
                                                        if (_e1056 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1062 = global_1.member[_e999].member[_e1056];
                                                        let _e1063 = (6u + _e456);
                                                        if (_e1063 < 9u) {
                                                        } else {
                                                            phi_4380_ = true;
                                                            break;
                                                        }
                                                        let _e1069 = global_1.member[_e999].member[_e1063];
                                                        phi_2100_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1013, _e1019, _e1025), array<f32, 3>(_e1033, _e1040, _e1047), array<f32, 3>(_e1055, _e1062, _e1069));
                                                    }
                                                    let _e1073 = phi_2100_;
                                                    let _e1082 = (_e1073[0][2] - _e362);
                                                    let _e1085 = (((_e1073[0][0] - _e289) * _e386) - (_e1082 * _e314));
                                                    let _e1088 = (((_e1073[0][1] - _e326) * _e386) - (_e1082 * _e350));
                                                    let _e1095 = (_e1073[1][2] - _e362);
                                                    let _e1098 = (((_e1073[1][0] - _e289) * _e386) - (_e1095 * _e314));
                                                    let _e1101 = (((_e1073[1][1] - _e326) * _e386) - (_e1095 * _e350));
                                                    let _e1108 = (_e1073[2][2] - _e362);
                                                    let _e1111 = (((_e1073[2][0] - _e289) * _e386) - (_e1108 * _e314));
                                                    let _e1114 = (((_e1073[2][1] - _e326) * _e386) - (_e1108 * _e350));
                                                    let _e1115 = (_e1111 * _e1101);
                                                    let _e1116 = (_e1114 * _e1098);
                                                    let _e1117 = (_e1085 * _e1114);
                                                    let _e1118 = (_e1088 * _e1111);
                                                    let _e1119 = (_e1098 * _e1088);
                                                    let _e1120 = (_e1101 * _e1085);
                                                    let _e1125 = (((_e1115 >= _e1116) && (_e1117 >= _e1118)) && (_e1119 >= _e1120));
                                                    if (_e1125 || (((_e1115 <= _e1116) && (_e1117 <= _e1118)) && (_e1119 <= _e1120))) {
                                                        let _e1132 = select(-1f, 1f, _e1125);
                                                        let _e1134 = ((_e1115 - _e1116) * _e1132);
                                                        let _e1136 = select(0f, _e1134, (_e1134 > 0f));
                                                        let _e1138 = ((_e1117 - _e1118) * _e1132);
                                                        let _e1140 = select(0f, _e1138, (_e1138 > 0f));
                                                        let _e1142 = ((_e1119 - _e1120) * _e1132);
                                                        let _e1144 = select(0f, _e1142, (_e1142 > 0f));
                                                        let _e1146 = ((_e1136 + _e1140) + _e1144);
                                                        if (_e1146 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2666_ = type_25();
                                                            phi_2667_ = true;
                                                        } else {
                                                            let _e1149 = select(_e1073[1][0], _e1073[0][0], (_e1073[0][0] < _e1073[1][0]));
                                                            let _e1153 = select(_e1073[1][0], _e1073[0][0], (_e1073[0][0] > _e1073[1][0]));
                                                            let _e1157 = select(_e1073[1][1], _e1073[0][1], (_e1073[0][1] < _e1073[1][1]));
                                                            let _e1161 = select(_e1073[1][1], _e1073[0][1], (_e1073[0][1] > _e1073[1][1]));
                                                            let _e1165 = select(_e1073[1][2], _e1073[0][2], (_e1073[0][2] < _e1073[1][2]));
                                                            let _e1169 = select(_e1073[1][2], _e1073[0][2], (_e1073[0][2] > _e1073[1][2]));
                                                            let _e1174 = ((select(_e1073[2][0], _e1149, (_e1149 < _e1073[2][0])) - _e312) * _e317);
                                                            let _e1175 = ((select(_e1073[2][0], _e1153, (_e1153 > _e1073[2][0])) - _e313) * _e317);
                                                            let _e1178 = ((select(_e1073[2][1], _e1157, (_e1157 < _e1073[2][1])) - _e348) * _e353);
                                                            let _e1179 = ((select(_e1073[2][1], _e1161, (_e1161 > _e1073[2][1])) - _e349) * _e353);
                                                            let _e1182 = ((select(_e1073[2][2], _e1165, (_e1165 < _e1073[2][2])) - _e384) * _e389);
                                                            let _e1183 = ((select(_e1073[2][2], _e1169, (_e1169 > _e1073[2][2])) - _e385) * _e389);
                                                            let _e1185 = select(_e1183, _e1182, (_e1182 < _e1183));
                                                            let _e1187 = select(_e1183, _e1182, (_e1182 > _e1183));
                                                            let _e1189 = select(_e1175, _e1174, (_e1174 < _e1175));
                                                            let _e1191 = select(_e1179, _e1178, (_e1178 < _e1179));
                                                            let _e1193 = select(_e1191, _e1189, (_e1189 > _e1191));
                                                            let _e1195 = select(_e1185, _e1193, (_e1193 > _e1185));
                                                            let _e1197 = select(_e1175, _e1174, (_e1174 > _e1175));
                                                            let _e1199 = select(_e1179, _e1178, (_e1178 > _e1179));
                                                            let _e1201 = select(_e1199, _e1197, (_e1197 < _e1199));
                                                            let _e1203 = select(_e1187, _e1201, (_e1201 < _e1187));
                                                            let _e1204 = -(_e1185);
                                                            let _e1210 = select(_e435, _e1195, (_e1195 > _e435));
                                                            if (_e1210 > (_e1203 + (select(_e1204, _e1187, (_e1187 > _e1204)) * 0.0000019073523f))) {
                                                                phi_2661_ = type_25();
                                                                phi_2662_ = true;
                                                            } else {
                                                                let _e1212 = (_e1210 > _e971.member.member_1);
                                                                if _e1212 {
                                                                    phi_2660_ = type_25();
                                                                } else {
                                                                    let _e1216 = (_e1073[1][0] - _e1073[0][0]);
                                                                    let _e1217 = (_e1073[1][1] - _e1073[0][1]);
                                                                    let _e1218 = (_e1073[1][2] - _e1073[0][2]);
                                                                    let _e1219 = vec3<f32>(_e1216, _e1217, _e1218);
                                                                    let _e1220 = (_e1073[2][0] - _e1073[1][0]);
                                                                    let _e1221 = (_e1073[2][1] - _e1073[1][1]);
                                                                    let _e1222 = (_e1073[2][2] - _e1073[1][2]);
                                                                    let _e1223 = vec3<f32>(_e1220, _e1221, _e1222);
                                                                    let _e1224 = (_e1073[0][0] - _e1073[2][0]);
                                                                    let _e1225 = (_e1073[0][1] - _e1073[2][1]);
                                                                    let _e1226 = (_e1073[0][2] - _e1073[2][2]);
                                                                    let _e1227 = vec3<f32>(_e1224, _e1225, _e1226);
                                                                    let _e1230 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                    let _e1233 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                    let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                    let _e1238 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                    let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                                    let _e1243 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                    let _e1246 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                    let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                                    let _e1251 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                    let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                    let _e1256 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                    let _e1259 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                    let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                    let _e1264 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                    let _e1266 = select(_e1264, _e1261, (_e1261 > _e1264));
                                                                    let _e1268 = select(_e1253, _e1240, (_e1240 > _e1253));
                                                                    let _e1270 = select(_e1266, _e1268, (_e1268 > _e1266));
                                                                    if (_e1240 == _e1270) {
                                                                        phi_2571_ = _e1223;
                                                                        phi_2572_ = _e1227;
                                                                    } else {
                                                                        let _e1273 = vec3((_e1253 == _e1270));
                                                                        phi_2571_ = select(_e1219, _e1227, _e1273);
                                                                        phi_2572_ = select(_e1223, _e1219, _e1273);
                                                                    }
                                                                    let _e1277 = phi_2571_;
                                                                    let _e1279 = phi_2572_;
                                                                    let _e1286 = ((_e1277.y * _e1279.z) - (_e1279.y * _e1277.z));
                                                                    let _e1291 = ((_e1277.z * _e1279.x) - (_e1279.z * _e1277.x));
                                                                    let _e1294 = ((_e1277.x * _e1279.y) - (_e1279.x * _e1277.y));
                                                                    if (_e1136 >= _e1140) {
                                                                        phi_2603_ = select(true, false, (_e1136 >= _e1144));
                                                                    } else {
                                                                        phi_2603_ = true;
                                                                    }
                                                                    let _e1299 = phi_2603_;
                                                                    if _e1299 {
                                                                        phi_2612_ = select(vec3<f32>(_e1073[2][0], _e1073[2][1], _e1073[2][2]), vec3<f32>(_e1073[1][0], _e1073[1][1], _e1073[1][2]), vec3((_e1140 >= _e1144)));
                                                                    } else {
                                                                        phi_2612_ = vec3<f32>(_e1073[0][0], _e1073[0][1], _e1073[0][2]);
                                                                    }
                                                                    let _e1304 = phi_2612_;
                                                                    let _e1321 = ((((_e1286 * (_e1304.x - _e289)) + (_e1291 * (_e1304.y - _e326))) + (_e1294 * (_e1304.z - _e362))) / (((_e1286 * _e314) + (_e1291 * _e350)) + (_e1294 * _e386)));
                                                                    let _e1323 = select(_e1203, _e1321, (_e1321 < _e1203));
                                                                    let _e1325 = select(_e1195, _e1323, (_e1323 > _e1195));
                                                                    if (_e1325 >= _e435) {
                                                                        let _e1327 = (_e1325 <= _e971.member.member_1);
                                                                        if _e1327 {
                                                                            let _e1328 = (1f / _e1146);
                                                                            phi_2652_ = type_25(_e1325, (_e1140 * _e1328), (_e1144 * _e1328), _e1006);
                                                                        } else {
                                                                            phi_2652_ = type_25();
                                                                        }
                                                                        let _e1333 = phi_2652_;
                                                                        phi_2654_ = _e1333;
                                                                        phi_2655_ = select(true, false, _e1327);
                                                                    } else {
                                                                        phi_2654_ = type_25();
                                                                        phi_2655_ = true;
                                                                    }
                                                                    let _e1336 = phi_2654_;
                                                                    let _e1338 = phi_2655_;
                                                                    if _e1338 {
                                                                        phi_2659_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_2659_ = _e1336;
                                                                    }
                                                                    let _e1340 = phi_2659_;
                                                                    phi_2660_ = _e1340;
                                                                }
                                                                let _e1342 = phi_2660_;
                                                                phi_2661_ = _e1342;
                                                                phi_2662_ = _e1212;
                                                            }
                                                            let _e1344 = phi_2661_;
                                                            let _e1346 = phi_2662_;
                                                            phi_2666_ = _e1344;
                                                            phi_2667_ = _e1346;
                                                        }
                                                        let _e1348 = phi_2666_;
                                                        let _e1350 = phi_2667_;
                                                        phi_2671_ = _e1348;
                                                        phi_2672_ = _e1350;
                                                    } else {
                                                        phi_2671_ = type_25();
                                                        phi_2672_ = true;
                                                    }
                                                    let _e1352 = phi_2671_;
                                                    let _e1354 = phi_2672_;
                                                    if _e1354 {
                                                        phi_2676_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2676_ = _e1352;
                                                    }
                                                    let _e1356 = phi_2676_;
                                                    if (_e1356.member_3 != 4294967295u) {
                                                        if (_e1006 != _e441) {
                                                            if (_e1356.member < _e971.member.member.member) {
                                                                phi_2702_ = true;
                                                            } else {
                                                                if (_e1356.member == _e971.member.member.member) {
                                                                    phi_2701_ = (_e1356.member_3 < _e971.member.member.member_3);
                                                                } else {
                                                                    phi_2701_ = false;
                                                                }
                                                                let _e1371 = phi_2701_;
                                                                phi_2702_ = _e1371;
                                                            }
                                                            let _e1373 = phi_2702_;
                                                            if _e1373 {
                                                                phi_2709_ = type_44(type_40(_e1356, _e1356.member), _e998.member_1, _e998.member_2);
                                                            } else {
                                                                phi_2709_ = _e998;
                                                            }
                                                            let _e1380 = phi_2709_;
                                                            phi_2710_ = _e1380;
                                                        } else {
                                                            phi_2710_ = _e998;
                                                        }
                                                        let _e1382 = phi_2710_;
                                                        phi_2711_ = _e1382;
                                                    } else {
                                                        phi_2711_ = _e998;
                                                    }
                                                    let _e1384 = phi_2711_;
                                                    phi_1962_ = _e1384;
                                                } else {
                                                    phi_1962_ = type_44();
                                                }
                                                let _e1386 = phi_1962_;
                                                continue;
                                                continuing {
                                                    phi_1961_ = _e1386;
                                                    phi_1964_ = _e986;
                                                    phi_4380_ = _e482;
                                                    break if !(_e992);
                                                }
                                            }
                                            let _e1389 = phi_4380_;
                                            phi_4490_ = _e1389;
                                            if _e1389 {
                                                break;
                                            }
                                            phi_4494_ = _e1389;
                                            let _e1605 = local_6;
                                            phi_4017_ = _e1605;
                                            phi_4018_ = _e514;
                                            phi_4019_ = false;
                                            phi_4020_ = _e518;
                                        } else {
                                            if (_e514.member_1 >= _e81) {
                                                phi_3617_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e514.member_1 < _e81) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e536 = ((1u + _e261) % 4u);
                                                if (_e536 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e541 = global_4.member[_e514.member_1][_e536];
                                                let _e543 = ((1u + _e260) % 4u);
                                                if (_e543 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e548 = global_4.member[_e514.member_1][_e543];
                                                let _e550 = ((1u + _e262) % 4u);
                                                if (_e550 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e555 = global_4.member[_e514.member_1][_e550];
                                                let _e557 = ((_e261 + 1u) % 4u);
                                                if (_e557 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e562 = global_4.member[_e514.member_1][_e557];
                                                let _e564 = (_e562 >> bitcast<u32>(11u));
                                                let _e566 = ((_e260 + 1u) % 4u);
                                                if (_e566 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e571 = global_4.member[_e514.member_1][_e566];
                                                let _e573 = (_e571 >> bitcast<u32>(11u));
                                                let _e575 = ((_e262 + 1u) % 4u);
                                                if (_e575 < 4u) {
                                                } else {
                                                    phi_4490_ = true;
                                                    break;
                                                }
                                                let _e580 = global_4.member[_e514.member_1][_e575];
                                                let _e582 = (_e580 >> bitcast<u32>(11u));
                                                let _e605 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.x - _e514.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e606 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.y - _e514.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e607 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.z - _e514.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e609 = select(_e135, _e605, (_e605 > _e135));
                                                let _e611 = select(_e135, _e606, (_e606 > _e135));
                                                let _e613 = select(_e135, _e607, (_e607 > _e135));
                                                let _e638 = bitcast<u32>((f32(bitcast<i32>((_e541 & 1023u))) * _e609));
                                                let _e643 = (bitcast<i32>((_e541 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e646 = bitcast<f32>((_e638 & bitcast<u32>(_e643)));
                                                let _e647 = bitcast<u32>((f32(bitcast<i32>((_e548 & 1023u))) * _e611));
                                                let _e652 = (bitcast<i32>((_e548 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                                let _e656 = bitcast<u32>((f32(bitcast<i32>((_e555 & 1023u))) * _e613));
                                                let _e661 = (bitcast<i32>((_e555 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                                let _e668 = bitcast<f32>((_e638 & bitcast<u32>(~(_e643))));
                                                let _e672 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                                let _e676 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                                let _e677 = bitcast<u32>((f32(bitcast<i32>((_e564 & 1023u))) * _e609));
                                                let _e682 = (bitcast<i32>((_e564 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                                let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e611));
                                                let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                                let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e613));
                                                let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                                let _e707 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                                let _e711 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                                let _e715 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                                let _e745 = global_4.member[_e514.member_1][0u];
                                                let _e749 = global_4.member[_e514.member_1][1u];
                                                let _e753 = global_4.member[_e514.member_1][2u];
                                                let _e757 = global_4.member[_e514.member_1][3u];
                                                let _e769 = (((_e749 >> bitcast<u32>(22i)) | ((_e753 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e770 = (_e745 & 268435455u);
                                                let _e771 = (_e769 & 268435455u);
                                                let _e774 = ((_e745 >> bitcast<u32>(28u)) & 7u);
                                                let _e782 = ((_e745 >> bitcast<u32>(31i)) | (((_e769 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e783 = (_e774 != 0u);
                                                if (_e774 == 0u) {
                                                    phi_3579_ = _e770;
                                                } else {
                                                    if (_e774 == 7u) {
                                                        phi_3578_ = 2147483648u;
                                                    } else {
                                                        phi_3578_ = ((2147483648u | (_e774 << bitcast<u32>(28u))) | (_e771 & 268435455u));
                                                    }
                                                    let _e792 = phi_3578_;
                                                    phi_3579_ = _e792;
                                                }
                                                let _e794 = phi_3579_;
                                                if _e783 {
                                                    let _e795 = (_e774 != 7u);
                                                    if _e795 {
                                                        phi_3589_ = (_e771 + _e774);
                                                    } else {
                                                        phi_3589_ = u32();
                                                    }
                                                    let _e798 = phi_3589_;
                                                    phi_3591_ = _e798;
                                                    phi_3592_ = select(true, false, _e795);
                                                } else {
                                                    phi_3591_ = u32();
                                                    phi_3592_ = true;
                                                }
                                                let _e801 = phi_3591_;
                                                let _e803 = phi_3592_;
                                                if (_e782 == 0u) {
                                                    phi_3613_ = (_e770 + select(0u, 1u, !(_e783)));
                                                } else {
                                                    if (_e782 == 7u) {
                                                        phi_3612_ = 2147483648u;
                                                    } else {
                                                        phi_3612_ = ((2147483648u | (_e782 << bitcast<u32>(28u))) | (select(_e801, _e771, _e803) & 268435455u));
                                                    }
                                                    let _e816 = phi_3612_;
                                                    phi_3613_ = _e816;
                                                }
                                                let _e818 = phi_3613_;
                                                phi_3617_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e514.member.member.x + _e646), (_e514.member.member.x + _e668), (_e514.member.member_1.x - _e685), (_e514.member.member_1.x - _e707)), vec4<f32>((_e514.member.member.y + _e655), (_e514.member.member.y + _e672), (_e514.member.member_1.y - _e694), (_e514.member.member_1.y - _e711)), vec4<f32>((_e514.member.member.z + _e664), (_e514.member.member.z + _e676), (_e514.member.member_1.z - _e703), (_e514.member.member_1.z - _e715))), type_51(type_37((_e514.member.member + vec4<f32>(_e646, _e655, _e664, 0f)), (_e514.member.member_1 - vec4<f32>(_e685, _e694, _e703, 0f))), _e794), type_51(type_37((_e514.member.member + vec4<f32>(_e668, _e672, _e676, 0f)), (_e514.member.member_1 - vec4<f32>(_e707, _e711, _e715, 0f))), _e818));
                                            }
                                            let _e823 = phi_3617_;
                                            let _e836 = ((_e823.member[0].x - _e312) * _e317);
                                            let _e837 = ((_e823.member[0].y - _e312) * _e317);
                                            let _e838 = ((_e823.member[0].z - _e313) * _e317);
                                            let _e839 = ((_e823.member[0].w - _e313) * _e317);
                                            let _e849 = ((_e823.member[1].x - _e348) * _e353);
                                            let _e850 = ((_e823.member[1].y - _e348) * _e353);
                                            let _e851 = ((_e823.member[1].z - _e349) * _e353);
                                            let _e852 = ((_e823.member[1].w - _e349) * _e353);
                                            let _e862 = ((_e823.member[2].x - _e384) * _e389);
                                            let _e863 = ((_e823.member[2].y - _e384) * _e389);
                                            let _e864 = ((_e823.member[2].z - _e385) * _e389);
                                            let _e865 = ((_e823.member[2].w - _e385) * _e389);
                                            let _e867 = select(_e864, _e862, (_e862 < _e864));
                                            let _e869 = select(_e865, _e863, (_e863 < _e865));
                                            let _e871 = select(_e864, _e862, (_e862 > _e864));
                                            let _e873 = select(_e865, _e863, (_e863 > _e865));
                                            let _e875 = select(_e838, _e836, (_e836 < _e838));
                                            let _e877 = select(_e839, _e837, (_e837 < _e839));
                                            let _e879 = select(_e851, _e849, (_e849 < _e851));
                                            let _e881 = select(_e852, _e850, (_e850 < _e852));
                                            let _e883 = select(_e879, _e875, (_e875 > _e879));
                                            let _e885 = select(_e881, _e877, (_e877 > _e881));
                                            let _e887 = select(_e867, _e883, (_e883 > _e867));
                                            let _e889 = select(_e869, _e885, (_e885 > _e869));
                                            let _e891 = select(_e838, _e836, (_e836 > _e838));
                                            let _e893 = select(_e839, _e837, (_e837 > _e839));
                                            let _e895 = select(_e851, _e849, (_e849 > _e851));
                                            let _e897 = select(_e852, _e850, (_e850 > _e852));
                                            let _e899 = select(_e895, _e891, (_e891 < _e895));
                                            let _e901 = select(_e897, _e893, (_e893 < _e897));
                                            let _e906 = -(_e867);
                                            let _e907 = -(_e869);
                                            let _e914 = (select(_e871, _e899, (_e899 < _e871)) + (select(_e906, _e871, (_e871 > _e906)) * 0.0000019073523f));
                                            let _e915 = (select(_e873, _e901, (_e901 < _e873)) + (select(_e907, _e873, (_e873 > _e907)) * 0.0000019073523f));
                                            let _e917 = select(_e435, _e887, (_e887 > _e435));
                                            let _e919 = select(_e435, _e889, (_e889 > _e435));
                                            let _e924 = (_e917 <= select(_e484.member.member_1, _e914, (_e914 < _e484.member.member_1)));
                                            let _e925 = (_e919 <= select(_e484.member.member_1, _e915, (_e915 < _e484.member.member_1)));
                                            let _e926 = (_e917 <= _e919);
                                            if _e924 {
                                                if _e925 {
                                                    if _e926 {
                                                        phi_3961_ = _e823.member_2;
                                                    } else {
                                                        phi_3961_ = _e823.member_1;
                                                    }
                                                    let _e930 = phi_3961_;
                                                    let _e931 = (_e518 % 128u);
                                                    let _e932 = (_e931 < 128u);
                                                    if _e932 {
                                                    } else {
                                                        phi_4490_ = true;
                                                        break;
                                                    }
                                                    local_3[_e931] = type_51(type_37(_e930.member.member, _e930.member.member_1), _e930.member_1);
                                                    if _e932 {
                                                    } else {
                                                        phi_4490_ = true;
                                                        break;
                                                    }
                                                    local_2[_e931] = select(_e919, _e917, (_e917 > _e919));
                                                    if _e926 {
                                                        phi_3994_ = _e823.member_1;
                                                    } else {
                                                        phi_3994_ = _e823.member_2;
                                                    }
                                                    let _e947 = phi_3994_;
                                                    phi_3995_ = _e947;
                                                    phi_3996_ = (_e518 + 1u);
                                                } else {
                                                    phi_3995_ = type_51();
                                                    phi_3996_ = u32();
                                                }
                                                let _e949 = phi_3995_;
                                                let _e951 = phi_3996_;
                                                phi_3998_ = _e949;
                                                phi_3999_ = _e951;
                                                phi_4000_ = select(true, false, _e925);
                                            } else {
                                                phi_3998_ = type_51();
                                                phi_3999_ = u32();
                                                phi_4000_ = true;
                                            }
                                            let _e954 = phi_3998_;
                                            let _e956 = phi_3999_;
                                            let _e958 = phi_4000_;
                                            if _e958 {
                                                if _e924 {
                                                    phi_4009_ = _e823.member_1;
                                                } else {
                                                    phi_4009_ = _e823.member_2;
                                                }
                                                let _e962 = phi_4009_;
                                                phi_4014_ = _e962;
                                                phi_4015_ = select(_e925, true, _e924);
                                            } else {
                                                phi_4014_ = _e954;
                                                phi_4015_ = _e516;
                                            }
                                            let _e965 = phi_4014_;
                                            let _e967 = phi_4015_;
                                            phi_4494_ = _e482;
                                            phi_4017_ = type_44(_e484.member, (_e484.member_1 + 1u), _e484.member_2);
                                            phi_4018_ = _e965;
                                            phi_4019_ = _e967;
                                            phi_4020_ = select(_e956, _e518, _e958);
                                        }
                                        let _e1391 = phi_4494_;
                                        let _e1393 = phi_4017_;
                                        let _e1395 = phi_4018_;
                                        let _e1397 = phi_4019_;
                                        let _e1399 = phi_4020_;
                                        phi_4493_ = _e1391;
                                        phi_4021_ = _e1393;
                                        phi_4022_ = _e1395;
                                        phi_4023_ = (_e488 - 1u);
                                        phi_4024_ = _e1397;
                                        phi_4025_ = _e1399;
                                    } else {
                                        phi_4493_ = _e482;
                                        phi_4021_ = _e484;
                                        phi_4022_ = _e514;
                                        phi_4023_ = _e488;
                                        phi_4024_ = _e516;
                                        phi_4025_ = _e518;
                                    }
                                    let _e1401 = phi_4493_;
                                    let _e1403 = phi_4021_;
                                    let _e1405 = phi_4022_;
                                    let _e1407 = phi_4023_;
                                    let _e1409 = phi_4024_;
                                    let _e1411 = phi_4025_;
                                    phi_4492_ = _e1401;
                                    phi_4026_ = _e1403;
                                    phi_4027_ = _e1405;
                                    phi_4028_ = _e1407;
                                    phi_4029_ = _e1409;
                                    phi_4030_ = _e1411;
                                } else {
                                    phi_4492_ = _e482;
                                    phi_4026_ = type_44();
                                    phi_4027_ = type_51();
                                    phi_4028_ = u32();
                                    phi_4029_ = bool();
                                    phi_4030_ = u32();
                                }
                                let _e1413 = phi_4492_;
                                let _e1415 = phi_4026_;
                                let _e1417 = phi_4027_;
                                let _e1419 = phi_4028_;
                                let _e1421 = phi_4029_;
                                let _e1423 = phi_4030_;
                                phi_4491_ = _e1413;
                                phi_1885_ = _e1415;
                                phi_1888_ = _e1417;
                                phi_1890_ = _e1419;
                                phi_1892_ = _e1421;
                                phi_1894_ = _e1423;
                                phi_4031_ = _e496;
                            } else {
                                phi_4491_ = _e482;
                                phi_1885_ = type_44();
                                phi_1888_ = type_51();
                                phi_1890_ = u32();
                                phi_1892_ = bool();
                                phi_1894_ = u32();
                                phi_4031_ = false;
                            }
                            let _e1425 = phi_4491_;
                            let _e1427 = phi_1885_;
                            let _e1429 = phi_1888_;
                            let _e1431 = phi_1890_;
                            let _e1433 = phi_1892_;
                            let _e1435 = phi_1894_;
                            let _e1437 = phi_4031_;
                            continue;
                            continuing {
                                phi_4386_ = _e1425;
                                phi_1884_ = _e1427;
                                phi_1887_ = _e1429;
                                phi_1889_ = _e1431;
                                phi_1891_ = _e1433;
                                phi_1893_ = _e1435;
                                phi_4490_ = _e1425;
                                break if !(_e1437);
                            }
                        }
                        let _e1440 = phi_4490_;
                        if _e1440 {
                            break;
                        }
                        let _e1442 = local_4;
                        if (_e1442.member.member.member_3 != 4294967295u) {
                            let _e1448 = (_e263 / 3i);
                            let _e1455 = bitcast<f32>((bitcast<u32>((_e1448 + 127i)) << bitcast<u32>(23i)));
                            let _e1463 = (((_e1442.member.member.member * _e1455) * _e1455) * bitcast<f32>((bitcast<u32>(((_e263 - (2i * _e1448)) + 127i)) << bitcast<u32>(23i))));
                            let _e1465 = select(340282350000000000000000000000000000000f, _e1463, (_e1463 < 340282350000000000000000000000000000000f));
                            phi_4083_ = type_25(select(-340282350000000000000000000000000000000f, _e1465, (_e1465 > -340282350000000000000000000000000000000f)), _e1442.member.member.member_1, _e1442.member.member.member_2, _e1442.member.member.member_3);
                        } else {
                            phi_4083_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1472 = phi_4083_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_2.member[_e123] = _e1472;
                        let _e1476 = local_5;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_6.member[_e123] = _e1476.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1481 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1481 > 0u) {
                            let _e1483 = (1u < _e91);
                            if _e1483 {
                                if (0u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1487 = atomicAdd((&global_7.member[0u]), _e1481);
                                if ((_e1487 + _e1481) < _e1487) {
                                    if _e1483 {
                                    } else {
                                        break;
                                    }
                                    let _e1492 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1495 = select(0u, 1u, (_e1472.member_3 != 4294967295u));
                        if (_e1495 > 0u) {
                            let _e1497 = (3u < _e91);
                            if _e1497 {
                                if (2u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1501 = atomicAdd((&global_7.member[2u]), _e1495);
                                if ((_e1501 + _e1495) < _e1501) {
                                    if _e1497 {
                                    } else {
                                        break;
                                    }
                                    let _e1506 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1476.member_1 > 0u) {
                            let _e1508 = (5u < _e91);
                            if _e1508 {
                                if (4u < _e91) {
                                } else {
                                    break;
                                }
                                let _e1512 = atomicAdd((&global_7.member[4u]), _e1476.member_1);
                                if ((_e1512 + _e1476.member_1) < _e1512) {
                                    if _e1508 {
                                    } else {
                                        break;
                                    }
                                    let _e1517 = atomicAdd((&global_7.member[5u]), 1u);
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
