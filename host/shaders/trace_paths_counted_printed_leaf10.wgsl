struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_33 {
    member: type_19,
    member_1: f32,
}

struct type_35 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_44,
    member_1: u32,
}

struct type_62 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_37;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_62;
@group(0) @binding(1) 
var<storage> global_6: type_41;
@group(0) @binding(2) 
var<storage> global_7: type_49;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_53, 128>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<array<f32, 3>, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var phi_356_: i32;
    var phi_357_: i32;
    var phi_367_: bool;
    var phi_377_: u32;
    var phi_378_: u32;
    var phi_380_: bool;
    var phi_385_: u32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_447_: f32;
    var phi_453_: f32;
    var phi_476_: f32;
    var phi_487_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_542_: f32;
    var phi_553_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_579_: f32;
    var phi_585_: f32;
    var phi_608_: f32;
    var phi_619_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_4919_: bool;
    var phi_2857_: type_35;
    var phi_2860_: type_53;
    var phi_2862_: u32;
    var phi_2864_: bool;
    var phi_2866_: u32;
    var phi_2877_: bool;
    var phi_2922_: type_53;
    var phi_2923_: bool;
    var phi_2924_: u32;
    var phi_3847_: type_39;
    var phi_3856_: type_7;
    var phi_3857_: type_7;
    var phi_3880_: type_7;
    var phi_4912_: bool;
    var phi_4010_: type_7;
    var phi_4011_: type_7;
    var phi_4034_: type_7;
    var phi_4968_: bool;
    var phi_4597_: type_53;
    var phi_4636_: type_53;
    var phi_4637_: type_53;
    var phi_4638_: u32;
    var phi_4640_: type_53;
    var phi_4641_: u32;
    var phi_4642_: bool;
    var phi_4649_: type_53;
    var phi_4654_: type_53;
    var phi_4655_: bool;
    var phi_4985_: bool;
    var phi_2943_: type_35;
    var phi_2946_: type_7;
    var phi_2947_: type_7;
    var phi_2969_: type_7;
    var phi_3014_: u32;
    var phi_3038_: type_47;
    var phi_4981_: bool;
    var phi_3049_: type_7;
    var phi_3050_: type_7;
    var phi_3073_: type_7;
    var phi_3083_: type_7;
    var phi_3084_: type_7;
    var phi_3107_: type_7;
    var phi_4976_: bool;
    var phi_4989_: bool;
    var phi_4988_: bool;
    var phi_3670_: vec3<f32>;
    var phi_3671_: vec3<f32>;
    var phi_3702_: bool;
    var phi_3711_: vec3<f32>;
    var phi_3751_: type_19;
    var phi_3753_: type_19;
    var phi_3754_: bool;
    var phi_3758_: type_19;
    var phi_3759_: type_19;
    var phi_3760_: type_19;
    var phi_3761_: bool;
    var phi_3765_: type_19;
    var phi_3766_: bool;
    var phi_3770_: type_19;
    var phi_3771_: bool;
    var phi_3775_: type_19;
    var phi_3800_: bool;
    var phi_3801_: bool;
    var phi_3808_: type_35;
    var phi_3809_: type_35;
    var phi_3810_: type_35;
    var phi_4991_: bool;
    var phi_2944_: type_35;
    var phi_4990_: bool;
    var phi_5053_: bool;
    var phi_4657_: type_35;
    var phi_4658_: type_53;
    var phi_4659_: bool;
    var phi_4660_: u32;
    var phi_5052_: bool;
    var phi_4661_: type_35;
    var phi_4662_: type_53;
    var phi_4663_: u32;
    var phi_4664_: bool;
    var phi_4665_: u32;
    var phi_5051_: bool;
    var phi_4666_: type_35;
    var phi_4667_: type_53;
    var phi_4668_: u32;
    var phi_4669_: bool;
    var phi_4670_: u32;
    var phi_5050_: bool;
    var phi_2858_: type_35;
    var phi_2861_: type_53;
    var phi_2863_: u32;
    var phi_2865_: bool;
    var phi_2867_: u32;
    var phi_4671_: bool;
    var phi_5049_: bool;
    var local_17: type_35;
    var phi_4723_: type_19;
    var local_18: type_35;
    var local_19: type_35;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_6.member));
            let _e99 = arrayLength((&global_5.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[1u][0u];
            let _e119 = global_2.member[1u][1u];
            let _e123 = global_2.member[1u][2u];
            let _e127 = global_2.member[1u][3u];
            let _e131 = (_e85.x + (_e85.y * 2097152u));
            let _e138 = (_e131 < arrayLength((&global_3.member)));
            if _e138 {
                let _e139 = (_e131 < arrayLength((&global_1.member)));
                if _e139 {
                    let _e140 = (_e131 < arrayLength((&global_4.member)));
                    if _e140 {
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e150 = global_3.member[_e131].member.member_2[0u];
                        let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                        let _e158 = global_3.member[_e131].member.member_2[1u];
                        let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                        let _e166 = global_3.member[_e131].member.member_2[2u];
                        let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                        let _e174 = global_3.member[_e131].member.member[0u];
                        let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                        let _e182 = global_3.member[_e131].member.member[1u];
                        let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                        let _e190 = global_3.member[_e131].member.member[2u];
                        let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                        let _e194 = select(_e160, _e152, (_e160 < _e152));
                        let _e196 = select(_e168, _e194, (_e168 < _e194));
                        let _e198 = select(_e176, _e196, (_e176 < _e196));
                        let _e200 = select(_e184, _e198, (_e184 < _e198));
                        let _e202 = select(_e192, _e200, (_e192 < _e200));
                        let _e207 = global_3.member[_e131].member.member_1;
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e217 = global_3.member[_e131].member.member_3;
                        let _e223 = (((select(_e209, _e202, (_e209 < _e202)) < 2139095040u) && ((bitcast<u32>(_e217) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                        if _e223 {
                            let _e226 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                            if (_e226 >= 8388608u) {
                                phi_356_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_356_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                            }
                            let _e240 = phi_356_;
                            phi_357_ = _e240;
                        } else {
                            phi_357_ = 0i;
                        }
                        let _e242 = phi_357_;
                        let _e243 = (_e152 == _e196);
                        if _e243 {
                            phi_367_ = true;
                        } else {
                            phi_367_ = (_e160 == _e196);
                        }
                        let _e246 = phi_367_;
                        let _e247 = select(1u, 0u, _e243);
                        if _e246 {
                            let _e248 = (_e247 + 1u);
                            phi_377_ = _e248;
                            phi_378_ = _e248;
                            phi_380_ = select(true, false, (_e248 == 2u));
                        } else {
                            phi_377_ = u32();
                            phi_378_ = 0u;
                            phi_380_ = true;
                        }
                        let _e252 = phi_377_;
                        let _e254 = phi_378_;
                        let _e256 = phi_380_;
                        if _e256 {
                            phi_385_ = (_e254 + 1u);
                        } else {
                            phi_385_ = 0u;
                        }
                        let _e260 = phi_385_;
                        let _e261 = select(_e252, _e254, _e256);
                        let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                        let _e263 = -(_e242);
                        let _e264 = (_e263 / 2i);
                        let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                        let _e275 = bitcast<f32>((bitcast<u32>(((_e263 - _e264) + 127i)) << bitcast<u32>(23i)));
                        let _e280 = global_3.member[_e131].member.member;
                        let _e281 = (_e261 == 0u);
                        if _e281 {
                            phi_430_ = _e280[0];
                        } else {
                            phi_430_ = _e280[1];
                        }
                        let _e285 = phi_430_;
                        let _e286 = (_e261 == 2u);
                        if _e286 {
                            phi_436_ = _e280[2];
                        } else {
                            phi_436_ = _e285;
                        }
                        let _e289 = phi_436_;
                        let _e290 = global_3.member[_e131].member.member_2;
                        if _e281 {
                            phi_447_ = _e290[0];
                        } else {
                            phi_447_ = _e290[1];
                        }
                        let _e294 = phi_447_;
                        if _e286 {
                            phi_453_ = _e290[2];
                        } else {
                            phi_453_ = _e294;
                        }
                        let _e297 = phi_453_;
                        let _e299 = ((_e297 * _e269) * _e275);
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e299) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e303 {
                            let _e307 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) * 0.00000011920929f);
                            phi_476_ = select(0.00000000000011368684f, _e307, (_e307 > 0.00000000000011368684f));
                        } else {
                            phi_476_ = 0f;
                        }
                        let _e311 = phi_476_;
                        let _e312 = (_e289 + _e311);
                        let _e313 = (_e289 - _e311);
                        let _e314 = select(_e299, 0f, _e303);
                        if _e303 {
                            phi_487_ = 38685626000000000000000000f;
                        } else {
                            phi_487_ = (1f / _e299);
                        }
                        let _e317 = phi_487_;
                        let _e318 = (_e260 == 0u);
                        if _e318 {
                            phi_496_ = _e280[0];
                        } else {
                            phi_496_ = _e280[1];
                        }
                        let _e322 = phi_496_;
                        let _e323 = (_e260 == 2u);
                        if _e323 {
                            phi_502_ = _e280[2];
                        } else {
                            phi_502_ = _e322;
                        }
                        let _e326 = phi_502_;
                        if _e318 {
                            phi_513_ = _e290[0];
                        } else {
                            phi_513_ = _e290[1];
                        }
                        let _e330 = phi_513_;
                        if _e323 {
                            phi_519_ = _e290[2];
                        } else {
                            phi_519_ = _e330;
                        }
                        let _e333 = phi_519_;
                        let _e335 = ((_e333 * _e269) * _e275);
                        let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e339 {
                            let _e343 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                            phi_542_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                        } else {
                            phi_542_ = 0f;
                        }
                        let _e347 = phi_542_;
                        let _e348 = (_e326 + _e347);
                        let _e349 = (_e326 - _e347);
                        let _e350 = select(_e335, 0f, _e339);
                        if _e339 {
                            phi_553_ = 38685626000000000000000000f;
                        } else {
                            phi_553_ = (1f / _e335);
                        }
                        let _e353 = phi_553_;
                        let _e354 = (_e262 == 0u);
                        if _e354 {
                            phi_562_ = _e280[0];
                        } else {
                            phi_562_ = _e280[1];
                        }
                        let _e358 = phi_562_;
                        let _e359 = (_e262 == 2u);
                        if _e359 {
                            phi_568_ = _e280[2];
                        } else {
                            phi_568_ = _e358;
                        }
                        let _e362 = phi_568_;
                        if _e354 {
                            phi_579_ = _e290[0];
                        } else {
                            phi_579_ = _e290[1];
                        }
                        let _e366 = phi_579_;
                        if _e359 {
                            phi_585_ = _e290[2];
                        } else {
                            phi_585_ = _e366;
                        }
                        let _e369 = phi_585_;
                        let _e371 = ((_e369 * _e269) * _e275);
                        let _e375 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e375 {
                            let _e379 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) * 0.00000011920929f);
                            phi_608_ = select(0.00000000000011368684f, _e379, (_e379 > 0.00000000000011368684f));
                        } else {
                            phi_608_ = 0f;
                        }
                        let _e383 = phi_608_;
                        let _e384 = (_e362 + _e383);
                        let _e385 = (_e362 - _e383);
                        let _e386 = select(_e371, 0f, _e375);
                        if _e375 {
                            phi_619_ = 38685626000000000000000000f;
                        } else {
                            phi_619_ = (1f / _e371);
                        }
                        let _e389 = phi_619_;
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
                            phi_719_ = select(-340282350000000000000000000000000000000f, _e429, (_e429 > -340282350000000000000000000000000000000f));
                            phi_720_ = select(-340282350000000000000000000000000000000f, _e422, (_e422 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_719_ = 0f;
                            phi_720_ = 1f;
                        }
                        let _e433 = phi_719_;
                        let _e435 = phi_720_;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e441 = global_3.member[_e131].member_2;
                        local_5 = array<type_53, 128>(type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_44(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_16 = array<f32, 3>(bitcast<f32>(_e103), bitcast<f32>(_e107), bitcast<f32>(_e111));
                        let _e445 = (_e261 % 3u);
                        let _e446 = (_e445 < 3u);
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e448 = local_16[_e445];
                        let _e449 = (_e260 % 3u);
                        let _e450 = (_e449 < 3u);
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e452 = local_16[_e449];
                        let _e453 = (_e262 % 3u);
                        let _e454 = (_e453 < 3u);
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e456 = local_16[_e453];
                        local_15 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                        if _e446 {
                        } else {
                            break;
                        }
                        let _e460 = local_15[_e445];
                        if _e450 {
                        } else {
                            break;
                        }
                        let _e462 = local_15[_e449];
                        if _e454 {
                        } else {
                            break;
                        }
                        let _e464 = local_15[_e453];
                        phi_4919_ = false;
                        phi_2857_ = type_35(type_33(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e433), 0u, 0u);
                        phi_2860_ = type_53(type_44(array<f32, 3>(_e448, _e452, _e456), array<f32, 3>(_e460, _e462, _e464)), select(0u, 2147483648u, (_e88 == 0u)));
                        phi_2862_ = ((3u * _e88) + 1u);
                        phi_2864_ = (_e435 <= _e433);
                        phi_2866_ = 0u;
                        loop {
                            let _e472 = phi_4919_;
                            let _e474 = phi_2857_;
                            let _e476 = phi_2860_;
                            let _e478 = phi_2862_;
                            let _e480 = phi_2864_;
                            let _e482 = phi_2866_;
                            local_17 = _e474;
                            local_18 = _e474;
                            if _e480 {
                                phi_2877_ = true;
                            } else {
                                phi_2877_ = (_e482 > 0u);
                            }
                            let _e485 = phi_2877_;
                            if _e485 {
                                let _e486 = (_e478 > 0u);
                                if _e486 {
                                    if _e480 {
                                        phi_2922_ = _e476;
                                        phi_2923_ = _e480;
                                        phi_2924_ = _e482;
                                    } else {
                                        let _e487 = (_e482 - 1u);
                                        let _e488 = (_e487 % 128u);
                                        let _e489 = (_e488 < 128u);
                                        if _e489 {
                                        } else {
                                            phi_5049_ = true;
                                            break;
                                        }
                                        let _e491 = local_5[_e488];
                                        if _e489 {
                                        } else {
                                            phi_5049_ = true;
                                            break;
                                        }
                                        let _e507 = local_4[_e488];
                                        phi_2922_ = type_53(type_44(array<f32, 3>(_e491.member.member[0], _e491.member.member[1], _e491.member.member[2]), array<f32, 3>(_e491.member.member_1[0], _e491.member.member_1[1], _e491.member.member_1[2])), _e491.member_1);
                                        phi_2923_ = (_e507 <= _e474.member.member_1);
                                        phi_2924_ = _e487;
                                    }
                                    let _e512 = phi_2922_;
                                    let _e514 = phi_2923_;
                                    let _e516 = phi_2924_;
                                    if _e514 {
                                        if ((_e512.member_1 & 2147483648u) != 0u) {
                                            phi_4985_ = _e472;
                                            phi_2943_ = _e474;
                                            phi_2946_ = type_7(0u, ((_e512.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e845 = phi_4985_;
                                                let _e847 = phi_2943_;
                                                let _e849 = phi_2946_;
                                                local_19 = _e847;
                                                if (_e849.member < _e849.member_1) {
                                                    phi_2947_ = type_7((_e849.member + 1u), _e849.member_1);
                                                    phi_2969_ = type_7(1u, _e849.member);
                                                } else {
                                                    phi_2947_ = _e849;
                                                    phi_2969_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e862 = phi_2947_;
                                                let _e864 = phi_2969_;
                                                let _e868 = (bitcast<i32>(_e864.member) != 0i);
                                                if _e868 {
                                                    let _e874 = type_35(_e847.member, _e847.member_1, (_e847.member_2 + 1u));
                                                    local_1 = array<f32, 3>(_e512.member.member[0], _e512.member.member[1], _e512.member.member[2]);
                                                    local = array<f32, 3>(_e512.member.member_1[0], _e512.member.member_1[1], _e512.member.member_1[2]);
                                                    let _e885 = ((_e512.member_1 & 268435455u) + _e864.member_1);
                                                    let _e886 = (_e885 < arrayLength((&global_7.member)));
                                                    if _e886 {
                                                        if _e886 {
                                                        } else {
                                                            phi_4990_ = true;
                                                            break;
                                                        }
                                                        let _e889 = global_7.member[_e885].member_1;
                                                        phi_3014_ = _e889;
                                                    } else {
                                                        phi_3014_ = 4294967295u;
                                                    }
                                                    let _e891 = phi_3014_;
                                                    local_12 = array<u32, 3>(_e261, _e260, _e262);
                                                    if _e886 {
                                                        if _e886 {
                                                        } else {
                                                            phi_4990_ = true;
                                                            break;
                                                        }
                                                        let _e894 = global_7.member[_e885];
                                                        phi_3038_ = _e894;
                                                    } else {
                                                        phi_3038_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e896 = phi_3038_;
                                                    local_14 = array<u32, 3>(_e896.member[0], _e896.member[1], _e896.member[2]);
                                                    local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4981_ = _e845;
                                                    phi_3049_ = type_7(0u, 3u);
                                                    loop {
                                                        let _e906 = phi_4981_;
                                                        let _e908 = phi_3049_;
                                                        if (_e908.member < _e908.member_1) {
                                                            phi_3050_ = type_7((_e908.member + 1u), _e908.member_1);
                                                            phi_3073_ = type_7(1u, _e908.member);
                                                        } else {
                                                            phi_3050_ = _e908;
                                                            phi_3073_ = type_7(0u, type_7().member_1);
                                                        }
                                                        let _e921 = phi_3050_;
                                                        let _e923 = phi_3073_;
                                                        let _e927 = (bitcast<i32>(_e923.member) != 0i);
                                                        if _e927 {
                                                            phi_3083_ = type_7(0u, 3u);
                                                            loop {
                                                                let _e929 = phi_3083_;
                                                                if (_e929.member < _e929.member_1) {
                                                                    phi_3084_ = type_7((_e929.member + 1u), _e929.member_1);
                                                                    phi_3107_ = type_7(1u, _e929.member);
                                                                } else {
                                                                    phi_3084_ = _e929;
                                                                    phi_3107_ = type_7(0u, type_7().member_1);
                                                                }
                                                                let _e942 = phi_3084_;
                                                                let _e944 = phi_3107_;
                                                                let _e948 = (bitcast<i32>(_e944.member) != 0i);
                                                                if _e948 {
                                                                    let _e949 = (_e923.member_1 < 3u);
                                                                    if _e949 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    let _e951 = local_14[_e923.member_1];
                                                                    let _e952 = (_e944.member_1 < 3u);
                                                                    if _e952 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    let _e954 = local_12[_e944.member_1];
                                                                    let _e959 = ((_e951 >> bitcast<u32>(((10u * _e954) & 31u))) & 1023u);
                                                                    if _e952 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    let _e961 = local_1[_e944.member_1];
                                                                    if _e952 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    let _e963 = local[_e944.member_1];
                                                                    let _e974 = (_e961 + bitcast<f32>((bitcast<u32>((f32(_e959) * bitcast<f32>((bitcast<u32>(((_e963 - _e961) * 0.0009775171f)) ^ _e127)))) ^ _e127)));
                                                                    if _e949 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    if _e952 {
                                                                    } else {
                                                                        phi_4976_ = true;
                                                                        break;
                                                                    }
                                                                    local_13[_e923.member_1][_e944.member_1] = select(select(_e963, _e974, (_e974 < _e963)), _e963, (_e959 == 1023u));
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_3083_ = _e942;
                                                                    phi_4976_ = _e906;
                                                                    break if !(_e948);
                                                                }
                                                            }
                                                            let _e983 = phi_4976_;
                                                            phi_4988_ = _e983;
                                                            if _e983 {
                                                                break;
                                                            }
                                                            phi_4989_ = _e983;
                                                        } else {
                                                            phi_4989_ = _e906;
                                                        }
                                                        let _e985 = phi_4989_;
                                                        continue;
                                                        continuing {
                                                            phi_4981_ = _e985;
                                                            phi_3049_ = _e921;
                                                            phi_4988_ = _e985;
                                                            break if !(_e927);
                                                        }
                                                    }
                                                    let _e988 = phi_4988_;
                                                    phi_4990_ = _e988;
                                                    if _e988 {
                                                        break;
                                                    }
                                                    let _e989 = local_13;
                                                    let _e1006 = (_e989[0][2] - _e362);
                                                    let _e1009 = (((_e989[0][0] - _e289) * _e386) - (_e1006 * _e314));
                                                    let _e1012 = (((_e989[0][1] - _e326) * _e386) - (_e1006 * _e350));
                                                    let _e1015 = (_e989[1][2] - _e362);
                                                    let _e1018 = (((_e989[1][0] - _e289) * _e386) - (_e1015 * _e314));
                                                    let _e1021 = (((_e989[1][1] - _e326) * _e386) - (_e1015 * _e350));
                                                    let _e1024 = (_e989[2][2] - _e362);
                                                    let _e1027 = (((_e989[2][0] - _e289) * _e386) - (_e1024 * _e314));
                                                    let _e1030 = (((_e989[2][1] - _e326) * _e386) - (_e1024 * _e350));
                                                    let _e1031 = (_e1027 * _e1021);
                                                    let _e1032 = (_e1030 * _e1018);
                                                    let _e1033 = (_e1009 * _e1030);
                                                    let _e1034 = (_e1012 * _e1027);
                                                    let _e1035 = (_e1018 * _e1012);
                                                    let _e1036 = (_e1021 * _e1009);
                                                    let _e1041 = (((_e1031 >= _e1032) && (_e1033 >= _e1034)) && (_e1035 >= _e1036));
                                                    if (_e1041 || (((_e1031 <= _e1032) && (_e1033 <= _e1034)) && (_e1035 <= _e1036))) {
                                                        let _e1048 = select(-1f, 1f, _e1041);
                                                        let _e1050 = ((_e1031 - _e1032) * _e1048);
                                                        let _e1052 = select(0f, _e1050, (_e1050 > 0f));
                                                        let _e1054 = ((_e1033 - _e1034) * _e1048);
                                                        let _e1056 = select(0f, _e1054, (_e1054 > 0f));
                                                        let _e1058 = ((_e1035 - _e1036) * _e1048);
                                                        let _e1060 = select(0f, _e1058, (_e1058 > 0f));
                                                        let _e1062 = ((_e1052 + _e1056) + _e1060);
                                                        if (_e1062 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3765_ = type_19();
                                                            phi_3766_ = true;
                                                        } else {
                                                            let _e1065 = select(_e989[1][0], _e989[0][0], (_e989[0][0] < _e989[1][0]));
                                                            let _e1069 = select(_e989[1][0], _e989[0][0], (_e989[0][0] > _e989[1][0]));
                                                            let _e1073 = select(_e989[1][1], _e989[0][1], (_e989[0][1] < _e989[1][1]));
                                                            let _e1077 = select(_e989[1][1], _e989[0][1], (_e989[0][1] > _e989[1][1]));
                                                            let _e1081 = select(_e989[1][2], _e989[0][2], (_e989[0][2] < _e989[1][2]));
                                                            let _e1085 = select(_e989[1][2], _e989[0][2], (_e989[0][2] > _e989[1][2]));
                                                            let _e1090 = ((select(_e989[2][0], _e1065, (_e1065 < _e989[2][0])) - _e312) * _e317);
                                                            let _e1091 = ((select(_e989[2][0], _e1069, (_e1069 > _e989[2][0])) - _e313) * _e317);
                                                            let _e1094 = ((select(_e989[2][1], _e1073, (_e1073 < _e989[2][1])) - _e348) * _e353);
                                                            let _e1095 = ((select(_e989[2][1], _e1077, (_e1077 > _e989[2][1])) - _e349) * _e353);
                                                            let _e1098 = ((select(_e989[2][2], _e1081, (_e1081 < _e989[2][2])) - _e384) * _e389);
                                                            let _e1099 = ((select(_e989[2][2], _e1085, (_e1085 > _e989[2][2])) - _e385) * _e389);
                                                            let _e1101 = select(_e1099, _e1098, (_e1098 < _e1099));
                                                            let _e1103 = select(_e1099, _e1098, (_e1098 > _e1099));
                                                            let _e1105 = select(_e1091, _e1090, (_e1090 < _e1091));
                                                            let _e1107 = select(_e1095, _e1094, (_e1094 < _e1095));
                                                            let _e1109 = select(_e1107, _e1105, (_e1105 > _e1107));
                                                            let _e1111 = select(_e1101, _e1109, (_e1109 > _e1101));
                                                            let _e1113 = select(_e1091, _e1090, (_e1090 > _e1091));
                                                            let _e1115 = select(_e1095, _e1094, (_e1094 > _e1095));
                                                            let _e1117 = select(_e1115, _e1113, (_e1113 < _e1115));
                                                            let _e1119 = select(_e1103, _e1117, (_e1117 < _e1103));
                                                            let _e1120 = -(_e1101);
                                                            let _e1126 = select(_e435, _e1111, (_e1111 > _e435));
                                                            if (_e1126 > (_e1119 + (select(_e1120, _e1103, (_e1103 > _e1120)) * 0.0000019073523f))) {
                                                                phi_3760_ = type_19();
                                                                phi_3761_ = true;
                                                            } else {
                                                                let _e1128 = (_e1126 > _e847.member.member_1);
                                                                if _e1128 {
                                                                    phi_3759_ = type_19();
                                                                } else {
                                                                    let _e1132 = (_e989[1][0] - _e989[0][0]);
                                                                    let _e1133 = (_e989[1][1] - _e989[0][1]);
                                                                    let _e1134 = (_e989[1][2] - _e989[0][2]);
                                                                    let _e1135 = vec3<f32>(_e1132, _e1133, _e1134);
                                                                    let _e1136 = (_e989[2][0] - _e989[1][0]);
                                                                    let _e1137 = (_e989[2][1] - _e989[1][1]);
                                                                    let _e1138 = (_e989[2][2] - _e989[1][2]);
                                                                    let _e1139 = vec3<f32>(_e1136, _e1137, _e1138);
                                                                    let _e1140 = (_e989[0][0] - _e989[2][0]);
                                                                    let _e1141 = (_e989[0][1] - _e989[2][1]);
                                                                    let _e1142 = (_e989[0][2] - _e989[2][2]);
                                                                    let _e1143 = vec3<f32>(_e1140, _e1141, _e1142);
                                                                    let _e1146 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                    let _e1149 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                    let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                    let _e1154 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                    let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                    let _e1159 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                    let _e1162 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                    let _e1164 = select(_e1162, _e1159, (_e1159 > _e1162));
                                                                    let _e1167 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                    let _e1169 = select(_e1167, _e1164, (_e1164 > _e1167));
                                                                    let _e1172 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                    let _e1175 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                    let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                                                                    let _e1180 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                    let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                                                                    let _e1184 = select(_e1169, _e1156, (_e1156 > _e1169));
                                                                    let _e1186 = select(_e1182, _e1184, (_e1184 > _e1182));
                                                                    if (_e1156 == _e1186) {
                                                                        phi_3670_ = _e1139;
                                                                        phi_3671_ = _e1143;
                                                                    } else {
                                                                        let _e1189 = vec3((_e1169 == _e1186));
                                                                        phi_3670_ = select(_e1135, _e1143, _e1189);
                                                                        phi_3671_ = select(_e1139, _e1135, _e1189);
                                                                    }
                                                                    let _e1193 = phi_3670_;
                                                                    let _e1195 = phi_3671_;
                                                                    let _e1202 = ((_e1193.y * _e1195.z) - (_e1195.y * _e1193.z));
                                                                    let _e1207 = ((_e1193.z * _e1195.x) - (_e1195.z * _e1193.x));
                                                                    let _e1210 = ((_e1193.x * _e1195.y) - (_e1195.x * _e1193.y));
                                                                    if (_e1052 >= _e1056) {
                                                                        phi_3702_ = select(true, false, (_e1052 >= _e1060));
                                                                    } else {
                                                                        phi_3702_ = true;
                                                                    }
                                                                    let _e1215 = phi_3702_;
                                                                    if _e1215 {
                                                                        phi_3711_ = select(vec3<f32>(_e989[2][0], _e989[2][1], _e989[2][2]), vec3<f32>(_e989[1][0], _e989[1][1], _e989[1][2]), vec3((_e1056 >= _e1060)));
                                                                    } else {
                                                                        phi_3711_ = vec3<f32>(_e989[0][0], _e989[0][1], _e989[0][2]);
                                                                    }
                                                                    let _e1220 = phi_3711_;
                                                                    let _e1237 = ((((_e1202 * (_e1220.x - _e289)) + (_e1207 * (_e1220.y - _e326))) + (_e1210 * (_e1220.z - _e362))) / (((_e1202 * _e314) + (_e1207 * _e350)) + (_e1210 * _e386)));
                                                                    let _e1239 = select(_e1119, _e1237, (_e1237 < _e1119));
                                                                    let _e1241 = select(_e1111, _e1239, (_e1239 > _e1111));
                                                                    if (_e1241 >= _e435) {
                                                                        let _e1243 = (_e1241 <= _e847.member.member_1);
                                                                        if _e1243 {
                                                                            let _e1244 = (1f / _e1062);
                                                                            phi_3751_ = type_19(_e1241, (_e1056 * _e1244), (_e1060 * _e1244), _e891);
                                                                        } else {
                                                                            phi_3751_ = type_19();
                                                                        }
                                                                        let _e1249 = phi_3751_;
                                                                        phi_3753_ = _e1249;
                                                                        phi_3754_ = select(true, false, _e1243);
                                                                    } else {
                                                                        phi_3753_ = type_19();
                                                                        phi_3754_ = true;
                                                                    }
                                                                    let _e1252 = phi_3753_;
                                                                    let _e1254 = phi_3754_;
                                                                    if _e1254 {
                                                                        phi_3758_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3758_ = _e1252;
                                                                    }
                                                                    let _e1256 = phi_3758_;
                                                                    phi_3759_ = _e1256;
                                                                }
                                                                let _e1258 = phi_3759_;
                                                                phi_3760_ = _e1258;
                                                                phi_3761_ = _e1128;
                                                            }
                                                            let _e1260 = phi_3760_;
                                                            let _e1262 = phi_3761_;
                                                            phi_3765_ = _e1260;
                                                            phi_3766_ = _e1262;
                                                        }
                                                        let _e1264 = phi_3765_;
                                                        let _e1266 = phi_3766_;
                                                        phi_3770_ = _e1264;
                                                        phi_3771_ = _e1266;
                                                    } else {
                                                        phi_3770_ = type_19();
                                                        phi_3771_ = true;
                                                    }
                                                    let _e1268 = phi_3770_;
                                                    let _e1270 = phi_3771_;
                                                    if _e1270 {
                                                        phi_3775_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3775_ = _e1268;
                                                    }
                                                    let _e1272 = phi_3775_;
                                                    if (_e1272.member_3 != 4294967295u) {
                                                        if (_e891 != _e441) {
                                                            if (_e1272.member < _e847.member.member.member) {
                                                                phi_3801_ = true;
                                                            } else {
                                                                if (_e1272.member == _e847.member.member.member) {
                                                                    phi_3800_ = (_e1272.member_3 < _e847.member.member.member_3);
                                                                } else {
                                                                    phi_3800_ = false;
                                                                }
                                                                let _e1287 = phi_3800_;
                                                                phi_3801_ = _e1287;
                                                            }
                                                            let _e1289 = phi_3801_;
                                                            if _e1289 {
                                                                phi_3808_ = type_35(type_33(_e1272, _e1272.member), _e874.member_1, _e874.member_2);
                                                            } else {
                                                                phi_3808_ = _e874;
                                                            }
                                                            let _e1296 = phi_3808_;
                                                            phi_3809_ = _e1296;
                                                        } else {
                                                            phi_3809_ = _e874;
                                                        }
                                                        let _e1298 = phi_3809_;
                                                        phi_3810_ = _e1298;
                                                    } else {
                                                        phi_3810_ = _e874;
                                                    }
                                                    let _e1300 = phi_3810_;
                                                    phi_4991_ = _e988;
                                                    phi_2944_ = _e1300;
                                                } else {
                                                    phi_4991_ = _e845;
                                                    phi_2944_ = type_35();
                                                }
                                                let _e1302 = phi_4991_;
                                                let _e1304 = phi_2944_;
                                                continue;
                                                continuing {
                                                    phi_4985_ = _e1302;
                                                    phi_2943_ = _e1304;
                                                    phi_2946_ = _e862;
                                                    phi_4990_ = _e1302;
                                                    break if !(_e868);
                                                }
                                            }
                                            let _e1307 = phi_4990_;
                                            phi_5049_ = _e1307;
                                            if _e1307 {
                                                break;
                                            }
                                            phi_5053_ = _e1307;
                                            let _e1536 = local_19;
                                            phi_4657_ = _e1536;
                                            phi_4658_ = _e512;
                                            phi_4659_ = false;
                                            phi_4660_ = _e516;
                                        } else {
                                            local_3 = array<f32, 3>(_e512.member.member[0], _e512.member.member[1], _e512.member.member[2]);
                                            local_2 = array<f32, 3>(_e512.member.member_1[0], _e512.member.member_1[1], _e512.member.member_1[2]);
                                            let _e542 = (_e512.member_1 < _e88);
                                            if _e542 {
                                                if _e542 {
                                                } else {
                                                    phi_5049_ = true;
                                                    break;
                                                }
                                                let _e544 = global_6.member[_e512.member_1];
                                                phi_3847_ = _e544;
                                            } else {
                                                phi_3847_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e546 = phi_3847_;
                                            let _e548 = array<u32, 3>(_e261, _e260, _e262);
                                            local_11 = _e548;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3856_ = type_7(0u, 3u);
                                            loop {
                                                let _e550 = phi_3856_;
                                                if (_e550.member < _e550.member_1) {
                                                    phi_3857_ = type_7((_e550.member + 1u), _e550.member_1);
                                                    phi_3880_ = type_7(1u, _e550.member);
                                                } else {
                                                    phi_3857_ = _e550;
                                                    phi_3880_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e563 = phi_3857_;
                                                let _e565 = phi_3880_;
                                                let _e569 = (bitcast<i32>(_e565.member) != 0i);
                                                if _e569 {
                                                    let _e570 = (_e565.member_1 < 3u);
                                                    if _e570 {
                                                    } else {
                                                        phi_4912_ = true;
                                                        break;
                                                    }
                                                    let _e572 = local_11[_e565.member_1];
                                                    if _e570 {
                                                    } else {
                                                        phi_4912_ = true;
                                                        break;
                                                    }
                                                    let _e574 = local_3[_e565.member_1];
                                                    if _e570 {
                                                    } else {
                                                        phi_4912_ = true;
                                                        break;
                                                    }
                                                    let _e576 = local_2[_e565.member_1];
                                                    let _e579 = ((10u * _e572) & 31u);
                                                    let _e582 = ((_e546.member[0] >> bitcast<u32>(_e579)) & 1023u);
                                                    let _e587 = bitcast<f32>((bitcast<u32>(((_e576 - _e574) * 0.0009775171f)) ^ _e127));
                                                    let _e593 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e582) * _e587)) ^ _e127)));
                                                    if _e570 {
                                                    } else {
                                                        phi_4912_ = true;
                                                        break;
                                                    }
                                                    local_7[_e565.member_1] = select(select(_e576, _e593, (_e593 < _e576)), _e576, (_e582 == 1023u));
                                                    let _e602 = ((_e546.member[1] >> bitcast<u32>(_e579)) & 1023u);
                                                    let _e608 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e602) * _e587)) ^ _e127)));
                                                    if _e570 {
                                                    } else {
                                                        phi_4912_ = true;
                                                        break;
                                                    }
                                                    local_6[_e565.member_1] = select(select(_e576, _e608, (_e608 < _e576)), _e576, (_e602 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3856_ = _e563;
                                                    phi_4912_ = _e472;
                                                    break if !(_e569);
                                                }
                                            }
                                            let _e616 = phi_4912_;
                                            phi_5049_ = _e616;
                                            if _e616 {
                                                break;
                                            }
                                            let _e617 = local_6;
                                            let _e618 = local_7;
                                            local_10 = _e548;
                                            local_9 = array<f32, 3>(0f, 0f, 0f);
                                            local_8 = array<f32, 3>(0f, 0f, 0f);
                                            phi_4010_ = type_7(0u, 3u);
                                            loop {
                                                let _e627 = phi_4010_;
                                                if (_e627.member < _e627.member_1) {
                                                    phi_4011_ = type_7((_e627.member + 1u), _e627.member_1);
                                                    phi_4034_ = type_7(1u, _e627.member);
                                                } else {
                                                    phi_4011_ = _e627;
                                                    phi_4034_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e640 = phi_4011_;
                                                let _e642 = phi_4034_;
                                                let _e646 = (bitcast<i32>(_e642.member) != 0i);
                                                if _e646 {
                                                    let _e647 = (_e642.member_1 < 3u);
                                                    if _e647 {
                                                    } else {
                                                        phi_4968_ = true;
                                                        break;
                                                    }
                                                    let _e649 = local_10[_e642.member_1];
                                                    if _e647 {
                                                    } else {
                                                        phi_4968_ = true;
                                                        break;
                                                    }
                                                    let _e651 = local_3[_e642.member_1];
                                                    if _e647 {
                                                    } else {
                                                        phi_4968_ = true;
                                                        break;
                                                    }
                                                    let _e653 = local_2[_e642.member_1];
                                                    let _e656 = ((10u * _e649) & 31u);
                                                    let _e659 = ((_e546.member_1[0] >> bitcast<u32>(_e656)) & 1023u);
                                                    let _e664 = bitcast<f32>((bitcast<u32>(((_e653 - _e651) * 0.0009775171f)) ^ _e127));
                                                    let _e670 = (_e651 + bitcast<f32>((bitcast<u32>((f32(_e659) * _e664)) ^ _e127)));
                                                    if _e647 {
                                                    } else {
                                                        phi_4968_ = true;
                                                        break;
                                                    }
                                                    local_9[_e642.member_1] = select(select(_e653, _e670, (_e670 < _e653)), _e653, (_e659 == 1023u));
                                                    let _e679 = ((_e546.member_1[1] >> bitcast<u32>(_e656)) & 1023u);
                                                    let _e685 = (_e651 + bitcast<f32>((bitcast<u32>((f32(_e679) * _e664)) ^ _e127)));
                                                    if _e647 {
                                                    } else {
                                                        phi_4968_ = true;
                                                        break;
                                                    }
                                                    local_8[_e642.member_1] = select(select(_e653, _e685, (_e685 < _e653)), _e653, (_e679 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_4010_ = _e640;
                                                    phi_4968_ = _e616;
                                                    break if !(_e646);
                                                }
                                            }
                                            let _e693 = phi_4968_;
                                            phi_5049_ = _e693;
                                            if _e693 {
                                                break;
                                            }
                                            let _e694 = local_8;
                                            let _e695 = local_9;
                                            let _e706 = type_53(type_44(array<f32, 3>(_e618[0], _e618[1], _e618[2]), array<f32, 3>(_e617[0], _e617[1], _e617[2])), _e546.member_2);
                                            let _e711 = type_53(type_44(array<f32, 3>(_e695[0], _e695[1], _e695[2]), array<f32, 3>(_e694[0], _e694[1], _e694[2])), _e546.member_3);
                                            let _e718 = ((_e618[0] - _e312) * _e317);
                                            let _e719 = ((_e695[0] - _e312) * _e317);
                                            let _e720 = ((_e617[0] - _e313) * _e317);
                                            let _e721 = ((_e694[0] - _e313) * _e317);
                                            let _e726 = ((_e618[1] - _e348) * _e353);
                                            let _e727 = ((_e695[1] - _e348) * _e353);
                                            let _e728 = ((_e617[1] - _e349) * _e353);
                                            let _e729 = ((_e694[1] - _e349) * _e353);
                                            let _e734 = ((_e618[2] - _e384) * _e389);
                                            let _e735 = ((_e695[2] - _e384) * _e389);
                                            let _e736 = ((_e617[2] - _e385) * _e389);
                                            let _e737 = ((_e694[2] - _e385) * _e389);
                                            let _e739 = select(_e736, _e734, (_e734 < _e736));
                                            let _e741 = select(_e737, _e735, (_e735 < _e737));
                                            let _e743 = select(_e736, _e734, (_e734 > _e736));
                                            let _e745 = select(_e737, _e735, (_e735 > _e737));
                                            let _e747 = select(_e720, _e718, (_e718 < _e720));
                                            let _e749 = select(_e721, _e719, (_e719 < _e721));
                                            let _e751 = select(_e728, _e726, (_e726 < _e728));
                                            let _e753 = select(_e729, _e727, (_e727 < _e729));
                                            let _e755 = select(_e751, _e747, (_e747 > _e751));
                                            let _e757 = select(_e753, _e749, (_e749 > _e753));
                                            let _e759 = select(_e739, _e755, (_e755 > _e739));
                                            let _e761 = select(_e741, _e757, (_e757 > _e741));
                                            let _e763 = select(_e720, _e718, (_e718 > _e720));
                                            let _e765 = select(_e721, _e719, (_e719 > _e721));
                                            let _e767 = select(_e728, _e726, (_e726 > _e728));
                                            let _e769 = select(_e729, _e727, (_e727 > _e729));
                                            let _e771 = select(_e767, _e763, (_e763 < _e767));
                                            let _e773 = select(_e769, _e765, (_e765 < _e769));
                                            let _e778 = -(_e739);
                                            let _e779 = -(_e741);
                                            let _e786 = (select(_e743, _e771, (_e771 < _e743)) + (select(_e778, _e743, (_e743 > _e778)) * 0.0000019073523f));
                                            let _e787 = (select(_e745, _e773, (_e773 < _e745)) + (select(_e779, _e745, (_e745 > _e779)) * 0.0000019073523f));
                                            let _e789 = select(_e435, _e759, (_e759 > _e435));
                                            let _e791 = select(_e435, _e761, (_e761 > _e435));
                                            let _e796 = (_e789 <= select(_e474.member.member_1, _e786, (_e786 < _e474.member.member_1)));
                                            let _e797 = (_e791 <= select(_e474.member.member_1, _e787, (_e787 < _e474.member.member_1)));
                                            let _e798 = (_e789 <= _e791);
                                            if _e796 {
                                                if _e797 {
                                                    if _e798 {
                                                        phi_4597_ = _e711;
                                                    } else {
                                                        phi_4597_ = _e706;
                                                    }
                                                    let _e800 = phi_4597_;
                                                    let _e801 = (_e516 % 128u);
                                                    let _e802 = (_e801 < 128u);
                                                    if _e802 {
                                                    } else {
                                                        phi_5049_ = true;
                                                        break;
                                                    }
                                                    local_5[_e801] = type_53(type_44(array<f32, 3>(_e800.member.member[0], _e800.member.member[1], _e800.member.member[2]), array<f32, 3>(_e800.member.member_1[0], _e800.member.member_1[1], _e800.member.member_1[2])), _e800.member_1);
                                                    if _e802 {
                                                    } else {
                                                        phi_5049_ = true;
                                                        break;
                                                    }
                                                    local_4[_e801] = select(_e791, _e789, (_e789 > _e791));
                                                    if _e798 {
                                                        phi_4636_ = _e706;
                                                    } else {
                                                        phi_4636_ = _e711;
                                                    }
                                                    let _e823 = phi_4636_;
                                                    phi_4637_ = _e823;
                                                    phi_4638_ = (_e516 + 1u);
                                                } else {
                                                    phi_4637_ = type_53();
                                                    phi_4638_ = u32();
                                                }
                                                let _e825 = phi_4637_;
                                                let _e827 = phi_4638_;
                                                phi_4640_ = _e825;
                                                phi_4641_ = _e827;
                                                phi_4642_ = select(true, false, _e797);
                                            } else {
                                                phi_4640_ = type_53();
                                                phi_4641_ = u32();
                                                phi_4642_ = true;
                                            }
                                            let _e830 = phi_4640_;
                                            let _e832 = phi_4641_;
                                            let _e834 = phi_4642_;
                                            if _e834 {
                                                if _e796 {
                                                    phi_4649_ = _e706;
                                                } else {
                                                    phi_4649_ = _e711;
                                                }
                                                let _e836 = phi_4649_;
                                                phi_4654_ = _e836;
                                                phi_4655_ = select(_e797, true, _e796);
                                            } else {
                                                phi_4654_ = _e830;
                                                phi_4655_ = _e514;
                                            }
                                            let _e839 = phi_4654_;
                                            let _e841 = phi_4655_;
                                            phi_5053_ = _e693;
                                            phi_4657_ = type_35(_e474.member, (_e474.member_1 + 1u), _e474.member_2);
                                            phi_4658_ = _e839;
                                            phi_4659_ = _e841;
                                            phi_4660_ = select(_e832, _e516, _e834);
                                        }
                                        let _e1309 = phi_5053_;
                                        let _e1311 = phi_4657_;
                                        let _e1313 = phi_4658_;
                                        let _e1315 = phi_4659_;
                                        let _e1317 = phi_4660_;
                                        phi_5052_ = _e1309;
                                        phi_4661_ = _e1311;
                                        phi_4662_ = _e1313;
                                        phi_4663_ = (_e478 - 1u);
                                        phi_4664_ = _e1315;
                                        phi_4665_ = _e1317;
                                    } else {
                                        phi_5052_ = _e472;
                                        phi_4661_ = _e474;
                                        phi_4662_ = _e512;
                                        phi_4663_ = _e478;
                                        phi_4664_ = _e514;
                                        phi_4665_ = _e516;
                                    }
                                    let _e1319 = phi_5052_;
                                    let _e1321 = phi_4661_;
                                    let _e1323 = phi_4662_;
                                    let _e1325 = phi_4663_;
                                    let _e1327 = phi_4664_;
                                    let _e1329 = phi_4665_;
                                    phi_5051_ = _e1319;
                                    phi_4666_ = _e1321;
                                    phi_4667_ = _e1323;
                                    phi_4668_ = _e1325;
                                    phi_4669_ = _e1327;
                                    phi_4670_ = _e1329;
                                } else {
                                    phi_5051_ = _e472;
                                    phi_4666_ = type_35();
                                    phi_4667_ = type_53();
                                    phi_4668_ = u32();
                                    phi_4669_ = bool();
                                    phi_4670_ = u32();
                                }
                                let _e1331 = phi_5051_;
                                let _e1333 = phi_4666_;
                                let _e1335 = phi_4667_;
                                let _e1337 = phi_4668_;
                                let _e1339 = phi_4669_;
                                let _e1341 = phi_4670_;
                                phi_5050_ = _e1331;
                                phi_2858_ = _e1333;
                                phi_2861_ = _e1335;
                                phi_2863_ = _e1337;
                                phi_2865_ = _e1339;
                                phi_2867_ = _e1341;
                                phi_4671_ = _e486;
                            } else {
                                phi_5050_ = _e472;
                                phi_2858_ = type_35();
                                phi_2861_ = type_53();
                                phi_2863_ = u32();
                                phi_2865_ = bool();
                                phi_2867_ = u32();
                                phi_4671_ = false;
                            }
                            let _e1343 = phi_5050_;
                            let _e1345 = phi_2858_;
                            let _e1347 = phi_2861_;
                            let _e1349 = phi_2863_;
                            let _e1351 = phi_2865_;
                            let _e1353 = phi_2867_;
                            let _e1355 = phi_4671_;
                            continue;
                            continuing {
                                phi_4919_ = _e1343;
                                phi_2857_ = _e1345;
                                phi_2860_ = _e1347;
                                phi_2862_ = _e1349;
                                phi_2864_ = _e1351;
                                phi_2866_ = _e1353;
                                phi_5049_ = _e1343;
                                break if !(_e1355);
                            }
                        }
                        let _e1358 = phi_5049_;
                        if _e1358 {
                            break;
                        }
                        let _e1360 = local_17;
                        if (_e1360.member.member.member_3 != 4294967295u) {
                            let _e1366 = (_e263 / 3i);
                            let _e1373 = bitcast<f32>((bitcast<u32>((_e1366 + 127i)) << bitcast<u32>(23i)));
                            let _e1381 = (((_e1360.member.member.member * _e1373) * _e1373) * bitcast<f32>((bitcast<u32>(((_e263 - (2i * _e1366)) + 127i)) << bitcast<u32>(23i))));
                            let _e1383 = select(340282350000000000000000000000000000000f, _e1381, (_e1381 < 340282350000000000000000000000000000000f));
                            phi_4723_ = type_19(select(-340282350000000000000000000000000000000f, _e1383, (_e1383 > -340282350000000000000000000000000000000f)), _e1360.member.member.member_1, _e1360.member.member.member_2, _e1360.member.member.member_3);
                        } else {
                            phi_4723_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1390 = phi_4723_;
                        if _e139 {
                        } else {
                            break;
                        }
                        global_1.member[_e131] = _e1390;
                        let _e1394 = local_18;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_4.member[_e131] = _e1394.member_1;
                        if _e138 {
                        } else {
                            break;
                        }
                        let _e1399 = select(0u, 1u, (_e207 <= _e217));
                        if (_e1399 > 0u) {
                            let _e1401 = (1u < _e99);
                            if _e1401 {
                                if (0u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1405 = atomicAdd((&global_5.member[0u]), _e1399);
                                if ((_e1405 + _e1399) < _e1405) {
                                    if _e1401 {
                                    } else {
                                        break;
                                    }
                                    let _e1410 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1413 = select(0u, 1u, (_e1390.member_3 != 4294967295u));
                        if (_e1413 > 0u) {
                            let _e1415 = (3u < _e99);
                            if _e1415 {
                                if (2u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1419 = atomicAdd((&global_5.member[2u]), _e1413);
                                if ((_e1419 + _e1413) < _e1419) {
                                    if _e1415 {
                                    } else {
                                        break;
                                    }
                                    let _e1424 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1394.member_1 > 0u) {
                            let _e1426 = (5u < _e99);
                            if _e1426 {
                                if (4u < _e99) {
                                } else {
                                    break;
                                }
                                let _e1430 = atomicAdd((&global_5.member[4u]), _e1394.member_1);
                                if ((_e1430 + _e1394.member_1) < _e1430) {
                                    if _e1426 {
                                    } else {
                                        break;
                                    }
                                    let _e1435 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
