struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_18,
    member_1: f32,
}

struct type_38 {
    member: type_35,
    member_1: u32,
    member_2: u32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_30,
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
var<storage, read_write> global_1: type_20;
@group(0) @binding(0) 
var<uniform> global_2: type_40;
@group(0) @binding(3) 
var<storage> global_3: type_25;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_61;
@group(0) @binding(1) 
var<storage> global_6: type_47;
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
    var phi_879_: type_38;
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
    var phi_1006_: type_38;
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
    var phi_1917_: type_18;
    var phi_1919_: type_18;
    var phi_1920_: bool;
    var phi_1924_: type_18;
    var phi_1925_: type_18;
    var phi_1926_: type_18;
    var phi_1927_: bool;
    var phi_1931_: type_18;
    var phi_1932_: bool;
    var phi_1936_: type_18;
    var phi_1937_: bool;
    var phi_1941_: type_18;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1974_: type_38;
    var phi_1975_: type_38;
    var phi_1976_: type_38;
    var phi_3823_: bool;
    var phi_1007_: type_38;
    var phi_3822_: bool;
    var phi_3885_: bool;
    var phi_3361_: type_38;
    var phi_3362_: type_53;
    var phi_3363_: bool;
    var phi_3364_: u32;
    var phi_3884_: bool;
    var phi_3365_: type_38;
    var phi_3366_: type_53;
    var phi_3367_: u32;
    var phi_3368_: bool;
    var phi_3369_: u32;
    var phi_3883_: bool;
    var phi_3370_: type_38;
    var phi_3371_: type_53;
    var phi_3372_: u32;
    var phi_3373_: bool;
    var phi_3374_: u32;
    var phi_3882_: bool;
    var phi_880_: type_38;
    var phi_883_: type_53;
    var phi_885_: u32;
    var phi_887_: bool;
    var phi_889_: u32;
    var phi_3375_: bool;
    var phi_3881_: bool;
    var local_13: type_38;
    var phi_3427_: type_18;
    var local_14: type_38;
    var local_15: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_6.member));
            let _e97 = arrayLength((&global_7.member));
            let _e105 = arrayLength((&global_5.member));
            let _e109 = global_2.member[0u][0u];
            let _e113 = global_2.member[0u][1u];
            let _e117 = global_2.member[0u][2u];
            let _e121 = global_2.member[0u][3u];
            let _e125 = global_2.member[1u][0u];
            let _e129 = global_2.member[1u][1u];
            let _e133 = global_2.member[1u][2u];
            let _e137 = (_e92.x + (_e92.y * 2097152u));
            let _e149 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e121) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            local = array<i32, 3>(bitcast<i32>(_e125), bitcast<i32>(_e129), bitcast<i32>(_e133));
            let _e152 = (_e137 < arrayLength((&global_3.member)));
            if _e152 {
                let _e153 = (_e137 < arrayLength((&global_1.member)));
                if _e153 {
                    let _e154 = (_e137 < arrayLength((&global_4.member)));
                    if _e154 {
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e164 = global_3.member[_e137].member.member_2[0u];
                        let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                        let _e172 = global_3.member[_e137].member.member_2[1u];
                        let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                        let _e180 = global_3.member[_e137].member.member_2[2u];
                        let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                        let _e188 = global_3.member[_e137].member.member[0u];
                        let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                        let _e196 = global_3.member[_e137].member.member[1u];
                        let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                        let _e204 = global_3.member[_e137].member.member[2u];
                        let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                        let _e208 = select(_e174, _e166, (_e174 < _e166));
                        let _e210 = select(_e182, _e208, (_e182 < _e208));
                        let _e212 = select(_e190, _e210, (_e190 < _e210));
                        let _e214 = select(_e198, _e212, (_e198 < _e212));
                        let _e216 = select(_e206, _e214, (_e206 < _e214));
                        let _e221 = global_3.member[_e137].member.member_1;
                        let _e223 = (bitcast<u32>(_e221) & 2147483647u);
                        let _e231 = global_3.member[_e137].member.member_3;
                        let _e237 = (((select(_e223, _e216, (_e223 < _e216)) < 2139095040u) && ((bitcast<u32>(_e231) & 2147483647u) <= 2139095040u)) && (_e210 > 0u));
                        if _e237 {
                            let _e240 = (bitcast<u32>(bitcast<f32>(_e210)) & 2147483647u);
                            if (_e240 >= 8388608u) {
                                phi_411_ = (bitcast<i32>((_e240 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_411_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e240)), 32u, (_e240 == 0u))));
                            }
                            let _e254 = phi_411_;
                            phi_412_ = _e254;
                        } else {
                            phi_412_ = 0i;
                        }
                        let _e256 = phi_412_;
                        let _e257 = (_e166 == _e210);
                        if _e257 {
                            phi_422_ = true;
                        } else {
                            phi_422_ = (_e174 == _e210);
                        }
                        let _e260 = phi_422_;
                        let _e261 = select(1u, 0u, _e257);
                        if _e260 {
                            let _e262 = (_e261 + 1u);
                            phi_432_ = _e262;
                            phi_433_ = _e262;
                            phi_435_ = select(true, false, (_e262 == 2u));
                        } else {
                            phi_432_ = u32();
                            phi_433_ = 0u;
                            phi_435_ = true;
                        }
                        let _e266 = phi_432_;
                        let _e268 = phi_433_;
                        let _e270 = phi_435_;
                        if _e270 {
                            phi_440_ = (_e268 + 1u);
                        } else {
                            phi_440_ = 0u;
                        }
                        let _e274 = phi_440_;
                        let _e275 = select(_e266, _e268, _e270);
                        let _e276 = select(_e261, select(2u, _e261, _e260), _e270);
                        let _e277 = -(_e256);
                        if (_e277 < -126i) {
                            phi_473_ = -126i;
                        } else {
                            phi_473_ = select(_e277, 127i, (_e277 > 127i));
                        }
                        let _e282 = phi_473_;
                        let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                        let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                        let _e298 = global_3.member[_e137].member.member;
                        let _e299 = (_e275 == 0u);
                        if _e299 {
                            phi_491_ = _e298[0];
                        } else {
                            phi_491_ = _e298[1];
                        }
                        let _e303 = phi_491_;
                        let _e304 = (_e275 == 2u);
                        if _e304 {
                            phi_497_ = _e298[2];
                        } else {
                            phi_497_ = _e303;
                        }
                        let _e307 = phi_497_;
                        let _e308 = global_3.member[_e137].member.member_2;
                        if _e299 {
                            phi_508_ = _e308[0];
                        } else {
                            phi_508_ = _e308[1];
                        }
                        let _e312 = phi_508_;
                        if _e304 {
                            phi_514_ = _e308[2];
                        } else {
                            phi_514_ = _e312;
                        }
                        let _e315 = phi_514_;
                        let _e317 = ((_e315 * _e287) * _e293);
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e321 {
                            let _e325 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) * 0.00000011920929f);
                            phi_537_ = select(0.00000000000011368684f, _e325, (_e325 > 0.00000000000011368684f));
                        } else {
                            phi_537_ = 0f;
                        }
                        let _e329 = phi_537_;
                        let _e330 = (_e307 + _e329);
                        let _e331 = (_e307 - _e329);
                        let _e332 = select(_e317, 0f, _e321);
                        if _e321 {
                            phi_548_ = 38685626000000000000000000f;
                        } else {
                            phi_548_ = (1f / _e317);
                        }
                        let _e335 = phi_548_;
                        let _e336 = (_e274 == 0u);
                        if _e336 {
                            phi_557_ = _e298[0];
                        } else {
                            phi_557_ = _e298[1];
                        }
                        let _e340 = phi_557_;
                        let _e341 = (_e274 == 2u);
                        if _e341 {
                            phi_563_ = _e298[2];
                        } else {
                            phi_563_ = _e340;
                        }
                        let _e344 = phi_563_;
                        if _e336 {
                            phi_574_ = _e308[0];
                        } else {
                            phi_574_ = _e308[1];
                        }
                        let _e348 = phi_574_;
                        if _e341 {
                            phi_580_ = _e308[2];
                        } else {
                            phi_580_ = _e348;
                        }
                        let _e351 = phi_580_;
                        let _e353 = ((_e351 * _e287) * _e293);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) * 0.00000011920929f);
                            phi_603_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_603_ = 0f;
                        }
                        let _e365 = phi_603_;
                        let _e366 = (_e344 + _e365);
                        let _e367 = (_e344 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_614_ = 38685626000000000000000000f;
                        } else {
                            phi_614_ = (1f / _e353);
                        }
                        let _e371 = phi_614_;
                        let _e372 = (_e276 == 0u);
                        if _e372 {
                            phi_623_ = _e298[0];
                        } else {
                            phi_623_ = _e298[1];
                        }
                        let _e376 = phi_623_;
                        let _e377 = (_e276 == 2u);
                        if _e377 {
                            phi_629_ = _e298[2];
                        } else {
                            phi_629_ = _e376;
                        }
                        let _e380 = phi_629_;
                        if _e372 {
                            phi_640_ = _e308[0];
                        } else {
                            phi_640_ = _e308[1];
                        }
                        let _e384 = phi_640_;
                        if _e377 {
                            phi_646_ = _e308[2];
                        } else {
                            phi_646_ = _e384;
                        }
                        let _e387 = phi_646_;
                        let _e389 = ((_e387 * _e287) * _e293);
                        let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e393 {
                            let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e401 = phi_669_;
                        let _e402 = (_e380 + _e401);
                        let _e403 = (_e380 - _e401);
                        let _e404 = select(_e389, 0f, _e393);
                        if _e393 {
                            phi_680_ = 38685626000000000000000000f;
                        } else {
                            phi_680_ = (1f / _e389);
                        }
                        let _e407 = phi_680_;
                        let _e410 = bitcast<f32>((bitcast<u32>(_e307) & 2147483647u));
                        let _e413 = bitcast<f32>((bitcast<u32>(_e344) & 2147483647u));
                        let _e415 = select(_e413, _e410, (_e410 > _e413));
                        let _e418 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                        if (_e237 && (select(_e418, _e415, (_e415 > _e418)) <= 1099511600000f)) {
                            let _e423 = (_e256 / 3i);
                            let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                            let _e437 = bitcast<f32>((bitcast<u32>(((_e256 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                            let _e438 = (((_e221 * _e430) * _e430) * _e437);
                            let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                            let _e445 = (((_e231 * _e430) * _e430) * _e437);
                            let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                            phi_780_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                            phi_781_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_780_ = 0f;
                            phi_781_ = 1f;
                        }
                        let _e451 = phi_780_;
                        let _e453 = phi_781_;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e459 = global_3.member[_e137].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e462 = (_e275 % 3u);
                        let _e463 = (_e462 < 3u);
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e465 = local_1[_e462];
                        let _e468 = (_e274 % 3u);
                        let _e469 = (_e468 < 3u);
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e471 = local_1[_e468];
                        let _e474 = (_e276 % 3u);
                        let _e475 = (_e474 < 3u);
                        if _e475 {
                        } else {
                            break;
                        }
                        let _e477 = local_1[_e474];
                        if _e463 {
                        } else {
                            break;
                        }
                        let _e482 = local[_e462];
                        if _e469 {
                        } else {
                            break;
                        }
                        let _e486 = local[_e468];
                        if _e475 {
                        } else {
                            break;
                        }
                        let _e490 = local[_e474];
                        phi_3767_ = false;
                        phi_879_ = type_38(type_35(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                        phi_882_ = type_53(type_30(vec4<f32>((f32(_e465) * _e149), (f32(_e471) * _e149), (f32(_e477) * _e149), 0f), vec4<f32>((f32(_e482) * _e149), (f32(_e486) * _e149), (f32(_e490) * _e149), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_884_ = ((3u * _e94) + 1u);
                        phi_886_ = (_e453 <= _e451);
                        phi_888_ = 0u;
                        loop {
                            let _e500 = phi_3767_;
                            let _e502 = phi_879_;
                            let _e504 = phi_882_;
                            let _e506 = phi_884_;
                            let _e508 = phi_886_;
                            let _e510 = phi_888_;
                            local_13 = _e502;
                            local_14 = _e502;
                            if _e508 {
                                phi_899_ = true;
                            } else {
                                phi_899_ = (_e510 > 0u);
                            }
                            let _e513 = phi_899_;
                            if _e513 {
                                let _e514 = (_e506 > 0u);
                                if _e514 {
                                    if _e508 {
                                        phi_985_ = _e504;
                                        phi_986_ = _e508;
                                        phi_987_ = _e510;
                                    } else {
                                        let _e515 = (_e510 - 1u);
                                        let _e516 = (_e515 % 128u);
                                        let _e517 = (_e516 < 128u);
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e519 = local_7[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e521 = local_6[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e523 = local_5[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e525 = local_4[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e527 = local_3[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e529 = local_2[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e534 = local_8[_e516];
                                        if _e517 {
                                        } else {
                                            phi_3881_ = true;
                                            break;
                                        }
                                        let _e537 = local_9[_e516];
                                        phi_985_ = type_53(type_30(vec4<f32>(_e519, _e521, _e523, 0f), vec4<f32>(_e525, _e527, _e529, 0f)), _e534);
                                        phi_986_ = (_e537 <= _e502.member.member_1);
                                        phi_987_ = _e515;
                                    }
                                    let _e542 = phi_985_;
                                    let _e544 = phi_986_;
                                    let _e546 = phi_987_;
                                    if _e544 {
                                        let _e551 = (_e542.member_1 & 268435455u);
                                        if ((_e542.member_1 & 2147483648u) != 0u) {
                                            phi_3764_ = _e500;
                                            phi_1006_ = _e502;
                                            phi_1009_ = type_8(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1039 = phi_3764_;
                                                let _e1041 = phi_1006_;
                                                let _e1043 = phi_1009_;
                                                local_15 = _e1041;
                                                if (_e1043.member < _e1043.member_1) {
                                                    phi_1010_ = type_8((_e1043.member + 1u), _e1043.member_1);
                                                    phi_1032_ = type_8(1u, _e1043.member);
                                                } else {
                                                    phi_1010_ = _e1043;
                                                    phi_1032_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1056 = phi_1010_;
                                                let _e1058 = phi_1032_;
                                                let _e1062 = (bitcast<i32>(_e1058.member) != 0i);
                                                if _e1062 {
                                                    let _e1068 = type_38(_e1041.member, _e1041.member_1, (_e1041.member_2 + 1u));
                                                    let _e1073 = (_e542.member.member_1.x - _e542.member.member.x);
                                                    let _e1076 = (_e542.member.member_1.y - _e542.member.member.y);
                                                    let _e1079 = (_e542.member.member_1.z - _e542.member.member.z);
                                                    let _e1081 = select(_e1076, _e1073, (_e1073 > _e1076));
                                                    let _e1083 = select(_e1079, _e1081, (_e1081 > _e1079));
                                                    let _e1085 = (_e1083 < (1024f * _e149));
                                                    if _e1085 {
                                                        phi_1076_ = 0u;
                                                    } else {
                                                        phi_1076_ = select(2u, 1u, (_e1083 < (2097152f * _e149)));
                                                    }
                                                    let _e1090 = phi_1076_;
                                                    switch bitcast<i32>(_e1090) {
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
                                                    let _e1093 = phi_1082_;
                                                    switch bitcast<i32>(_e1090) {
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
                                                    let _e1100 = phi_1092_;
                                                    let _e1102 = ((_e551 + (_e1058.member_1 * ((3u * _e1093) + 1u))) + (3u * _e1100));
                                                    let _e1103 = (_e1102 < _e97);
                                                    if _e1103 {
                                                        if _e1103 {
                                                        } else {
                                                            phi_3822_ = true;
                                                            break;
                                                        }
                                                        let _e1105 = global_7.member[_e1102];
                                                        phi_1108_ = _e1105;
                                                    } else {
                                                        phi_1108_ = 4294967295u;
                                                    }
                                                    let _e1107 = phi_1108_;
                                                    local_10 = array<u32, 3>(_e275, _e274, _e276);
                                                    if _e1085 {
                                                        phi_1145_ = 0u;
                                                    } else {
                                                        phi_1145_ = select(2u, 1u, (_e1083 < (2097152f * _e149)));
                                                    }
                                                    let _e1113 = phi_1145_;
                                                    switch bitcast<i32>(_e1113) {
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
                                                    let _e1116 = phi_1151_;
                                                    switch bitcast<i32>(_e1113) {
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
                                                    let _e1123 = phi_1161_;
                                                    local_12 = array<f32, 4>(_e542.member.member.x, _e542.member.member.y, _e542.member.member.z, _e542.member.member.w);
                                                    local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_3749_ = _e1039;
                                                    phi_1177_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1137 = phi_3749_;
                                                        let _e1139 = phi_1177_;
                                                        if (_e1139.member < _e1139.member_1) {
                                                            phi_1178_ = type_8((_e1139.member + 1u), _e1139.member_1);
                                                            phi_1201_ = type_8(1u, _e1139.member);
                                                        } else {
                                                            phi_1178_ = _e1139;
                                                            phi_1201_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1152 = phi_1178_;
                                                        let _e1154 = phi_1201_;
                                                        let _e1158 = (bitcast<i32>(_e1154.member) != 0i);
                                                        if _e1158 {
                                                            let _e1160 = ((_e551 + (_e1058.member_1 * ((3u * _e1116) + 1u))) + (_e1154.member_1 * _e1123));
                                                            let _e1161 = (_e1160 < _e97);
                                                            if _e1161 {
                                                                if _e1161 {
                                                                } else {
                                                                    phi_3820_ = true;
                                                                    break;
                                                                }
                                                                let _e1163 = global_7.member[_e1160];
                                                                phi_1224_ = _e1163;
                                                            } else {
                                                                phi_1224_ = 0u;
                                                            }
                                                            let _e1165 = phi_1224_;
                                                            let _e1166 = (_e1160 + 1u);
                                                            let _e1167 = (_e1166 < _e97);
                                                            if _e1167 {
                                                                if _e1167 {
                                                                } else {
                                                                    phi_3820_ = true;
                                                                    break;
                                                                }
                                                                let _e1169 = global_7.member[_e1166];
                                                                phi_1239_ = _e1169;
                                                            } else {
                                                                phi_1239_ = 0u;
                                                            }
                                                            let _e1171 = phi_1239_;
                                                            phi_1242_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1173 = phi_1242_;
                                                                if (_e1173.member < _e1173.member_1) {
                                                                    phi_1243_ = type_8((_e1173.member + 1u), _e1173.member_1);
                                                                    phi_1266_ = type_8(1u, _e1173.member);
                                                                } else {
                                                                    phi_1243_ = _e1173;
                                                                    phi_1266_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1186 = phi_1243_;
                                                                let _e1188 = phi_1266_;
                                                                let _e1192 = (bitcast<i32>(_e1188.member) != 0i);
                                                                if _e1192 {
                                                                    let _e1193 = (_e1188.member_1 < 3u);
                                                                    if _e1193 {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1195 = local_10[_e1188.member_1];
                                                                    if (_e1188.member_1 < 4u) {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1198 = local_12[_e1188.member_1];
                                                                    switch bitcast<i32>(_e1113) {
                                                                        case 0: {
                                                                            phi_1336_ = (_e1198 + (f32(((_e1165 >> bitcast<u32>(((10u * _e1195) & 31u))) & 1023u)) * _e149));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1195 == 0u) {
                                                                                phi_1313_ = _e1165;
                                                                            } else {
                                                                                if (_e1195 == 1u) {
                                                                                    phi_1312_ = ((_e1165 >> bitcast<u32>(21i)) | (_e1171 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_1312_ = (_e1171 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1219 = phi_1312_;
                                                                                phi_1313_ = _e1219;
                                                                            }
                                                                            let _e1221 = phi_1313_;
                                                                            phi_1336_ = (_e1198 + (f32((_e1221 & 2097151u)) * _e149));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1200 = (_e1160 + _e1195);
                                                                            let _e1201 = (_e1200 < _e97);
                                                                            if _e1201 {
                                                                                if _e1201 {
                                                                                } else {
                                                                                    phi_3742_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1203 = global_7.member[_e1200];
                                                                                phi_1332_ = _e1203;
                                                                            } else {
                                                                                phi_1332_ = 0u;
                                                                            }
                                                                            let _e1205 = phi_1332_;
                                                                            phi_1336_ = (f32(bitcast<i32>(_e1205)) * _e149);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_1336_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1235 = phi_1336_;
                                                                    if (_e1154.member_1 < 3u) {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1193 {
                                                                    } else {
                                                                        phi_3742_ = true;
                                                                        break;
                                                                    }
                                                                    local_11[_e1154.member_1][_e1188.member_1] = _e1235;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_1242_ = _e1186;
                                                                    phi_3742_ = _e1137;
                                                                    break if !(_e1192);
                                                                }
                                                            }
                                                            let _e1241 = phi_3742_;
                                                            phi_3820_ = _e1241;
                                                            if _e1241 {
                                                                break;
                                                            }
                                                            phi_3821_ = _e1241;
                                                        } else {
                                                            phi_3821_ = _e1137;
                                                        }
                                                        let _e1243 = phi_3821_;
                                                        continue;
                                                        continuing {
                                                            phi_3749_ = _e1243;
                                                            phi_1177_ = _e1152;
                                                            phi_3820_ = _e1243;
                                                            break if !(_e1158);
                                                        }
                                                    }
                                                    let _e1246 = phi_3820_;
                                                    phi_3822_ = _e1246;
                                                    if _e1246 {
                                                        break;
                                                    }
                                                    let _e1247 = local_11;
                                                    let _e1264 = (_e1247[0][2] - _e380);
                                                    let _e1267 = (((_e1247[0][0] - _e307) * _e404) - (_e1264 * _e332));
                                                    let _e1270 = (((_e1247[0][1] - _e344) * _e404) - (_e1264 * _e368));
                                                    let _e1273 = (_e1247[1][2] - _e380);
                                                    let _e1276 = (((_e1247[1][0] - _e307) * _e404) - (_e1273 * _e332));
                                                    let _e1279 = (((_e1247[1][1] - _e344) * _e404) - (_e1273 * _e368));
                                                    let _e1282 = (_e1247[2][2] - _e380);
                                                    let _e1285 = (((_e1247[2][0] - _e307) * _e404) - (_e1282 * _e332));
                                                    let _e1288 = (((_e1247[2][1] - _e344) * _e404) - (_e1282 * _e368));
                                                    let _e1289 = (_e1285 * _e1279);
                                                    let _e1290 = (_e1288 * _e1276);
                                                    let _e1291 = (_e1267 * _e1288);
                                                    let _e1292 = (_e1270 * _e1285);
                                                    let _e1293 = (_e1276 * _e1270);
                                                    let _e1294 = (_e1279 * _e1267);
                                                    let _e1299 = (((_e1289 >= _e1290) && (_e1291 >= _e1292)) && (_e1293 >= _e1294));
                                                    if (_e1299 || (((_e1289 <= _e1290) && (_e1291 <= _e1292)) && (_e1293 <= _e1294))) {
                                                        let _e1306 = select(-1f, 1f, _e1299);
                                                        let _e1308 = ((_e1289 - _e1290) * _e1306);
                                                        let _e1310 = select(0f, _e1308, (_e1308 > 0f));
                                                        let _e1312 = ((_e1291 - _e1292) * _e1306);
                                                        let _e1314 = select(0f, _e1312, (_e1312 > 0f));
                                                        let _e1316 = ((_e1293 - _e1294) * _e1306);
                                                        let _e1318 = select(0f, _e1316, (_e1316 > 0f));
                                                        let _e1320 = ((_e1310 + _e1314) + _e1318);
                                                        if (_e1320 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1931_ = type_18();
                                                            phi_1932_ = true;
                                                        } else {
                                                            let _e1323 = select(_e1247[1][0], _e1247[0][0], (_e1247[0][0] < _e1247[1][0]));
                                                            let _e1327 = select(_e1247[1][0], _e1247[0][0], (_e1247[0][0] > _e1247[1][0]));
                                                            let _e1331 = select(_e1247[1][1], _e1247[0][1], (_e1247[0][1] < _e1247[1][1]));
                                                            let _e1335 = select(_e1247[1][1], _e1247[0][1], (_e1247[0][1] > _e1247[1][1]));
                                                            let _e1339 = select(_e1247[1][2], _e1247[0][2], (_e1247[0][2] < _e1247[1][2]));
                                                            let _e1343 = select(_e1247[1][2], _e1247[0][2], (_e1247[0][2] > _e1247[1][2]));
                                                            let _e1348 = ((select(_e1247[2][0], _e1323, (_e1323 < _e1247[2][0])) - _e330) * _e335);
                                                            let _e1349 = ((select(_e1247[2][0], _e1327, (_e1327 > _e1247[2][0])) - _e331) * _e335);
                                                            let _e1352 = ((select(_e1247[2][1], _e1331, (_e1331 < _e1247[2][1])) - _e366) * _e371);
                                                            let _e1353 = ((select(_e1247[2][1], _e1335, (_e1335 > _e1247[2][1])) - _e367) * _e371);
                                                            let _e1356 = ((select(_e1247[2][2], _e1339, (_e1339 < _e1247[2][2])) - _e402) * _e407);
                                                            let _e1357 = ((select(_e1247[2][2], _e1343, (_e1343 > _e1247[2][2])) - _e403) * _e407);
                                                            let _e1359 = select(_e1357, _e1356, (_e1356 < _e1357));
                                                            let _e1361 = select(_e1357, _e1356, (_e1356 > _e1357));
                                                            let _e1363 = select(_e1349, _e1348, (_e1348 < _e1349));
                                                            let _e1365 = select(_e1353, _e1352, (_e1352 < _e1353));
                                                            let _e1367 = select(_e1365, _e1363, (_e1363 > _e1365));
                                                            let _e1369 = select(_e1359, _e1367, (_e1367 > _e1359));
                                                            let _e1371 = select(_e1349, _e1348, (_e1348 > _e1349));
                                                            let _e1373 = select(_e1353, _e1352, (_e1352 > _e1353));
                                                            let _e1375 = select(_e1373, _e1371, (_e1371 < _e1373));
                                                            let _e1377 = select(_e1361, _e1375, (_e1375 < _e1361));
                                                            let _e1378 = -(_e1359);
                                                            let _e1384 = select(_e453, _e1369, (_e1369 > _e453));
                                                            if (_e1384 > (_e1377 + (select(_e1378, _e1361, (_e1361 > _e1378)) * 0.0000019073523f))) {
                                                                phi_1926_ = type_18();
                                                                phi_1927_ = true;
                                                            } else {
                                                                let _e1386 = (_e1384 > _e1041.member.member_1);
                                                                if _e1386 {
                                                                    phi_1925_ = type_18();
                                                                } else {
                                                                    let _e1390 = (_e1247[1][0] - _e1247[0][0]);
                                                                    let _e1391 = (_e1247[1][1] - _e1247[0][1]);
                                                                    let _e1392 = (_e1247[1][2] - _e1247[0][2]);
                                                                    let _e1393 = vec3<f32>(_e1390, _e1391, _e1392);
                                                                    let _e1394 = (_e1247[2][0] - _e1247[1][0]);
                                                                    let _e1395 = (_e1247[2][1] - _e1247[1][1]);
                                                                    let _e1396 = (_e1247[2][2] - _e1247[1][2]);
                                                                    let _e1397 = vec3<f32>(_e1394, _e1395, _e1396);
                                                                    let _e1398 = (_e1247[0][0] - _e1247[2][0]);
                                                                    let _e1399 = (_e1247[0][1] - _e1247[2][1]);
                                                                    let _e1400 = (_e1247[0][2] - _e1247[2][2]);
                                                                    let _e1401 = vec3<f32>(_e1398, _e1399, _e1400);
                                                                    let _e1404 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                    let _e1407 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                    let _e1409 = select(_e1407, _e1404, (_e1404 > _e1407));
                                                                    let _e1412 = bitcast<f32>((bitcast<u32>(_e1392) & 2147483647u));
                                                                    let _e1414 = select(_e1412, _e1409, (_e1409 > _e1412));
                                                                    let _e1417 = bitcast<f32>((bitcast<u32>(_e1394) & 2147483647u));
                                                                    let _e1420 = bitcast<f32>((bitcast<u32>(_e1395) & 2147483647u));
                                                                    let _e1422 = select(_e1420, _e1417, (_e1417 > _e1420));
                                                                    let _e1425 = bitcast<f32>((bitcast<u32>(_e1396) & 2147483647u));
                                                                    let _e1427 = select(_e1425, _e1422, (_e1422 > _e1425));
                                                                    let _e1430 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                                    let _e1433 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                    let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                    let _e1438 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                                    let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                    let _e1442 = select(_e1427, _e1414, (_e1414 > _e1427));
                                                                    let _e1444 = select(_e1440, _e1442, (_e1442 > _e1440));
                                                                    if (_e1414 == _e1444) {
                                                                        phi_1836_ = _e1397;
                                                                        phi_1837_ = _e1401;
                                                                    } else {
                                                                        let _e1447 = vec3((_e1427 == _e1444));
                                                                        phi_1836_ = select(_e1393, _e1401, _e1447);
                                                                        phi_1837_ = select(_e1397, _e1393, _e1447);
                                                                    }
                                                                    let _e1451 = phi_1836_;
                                                                    let _e1453 = phi_1837_;
                                                                    let _e1460 = ((_e1451.y * _e1453.z) - (_e1453.y * _e1451.z));
                                                                    let _e1465 = ((_e1451.z * _e1453.x) - (_e1453.z * _e1451.x));
                                                                    let _e1468 = ((_e1451.x * _e1453.y) - (_e1453.x * _e1451.y));
                                                                    if (_e1310 >= _e1314) {
                                                                        phi_1868_ = select(true, false, (_e1310 >= _e1318));
                                                                    } else {
                                                                        phi_1868_ = true;
                                                                    }
                                                                    let _e1473 = phi_1868_;
                                                                    if _e1473 {
                                                                        phi_1877_ = select(vec3<f32>(_e1247[2][0], _e1247[2][1], _e1247[2][2]), vec3<f32>(_e1247[1][0], _e1247[1][1], _e1247[1][2]), vec3((_e1314 >= _e1318)));
                                                                    } else {
                                                                        phi_1877_ = vec3<f32>(_e1247[0][0], _e1247[0][1], _e1247[0][2]);
                                                                    }
                                                                    let _e1478 = phi_1877_;
                                                                    let _e1495 = ((((_e1460 * (_e1478.x - _e307)) + (_e1465 * (_e1478.y - _e344))) + (_e1468 * (_e1478.z - _e380))) / (((_e1460 * _e332) + (_e1465 * _e368)) + (_e1468 * _e404)));
                                                                    let _e1497 = select(_e1377, _e1495, (_e1495 < _e1377));
                                                                    let _e1499 = select(_e1369, _e1497, (_e1497 > _e1369));
                                                                    if (_e1499 >= _e453) {
                                                                        let _e1501 = (_e1499 <= _e1041.member.member_1);
                                                                        if _e1501 {
                                                                            let _e1502 = (1f / _e1320);
                                                                            phi_1917_ = type_18(_e1499, (_e1314 * _e1502), (_e1318 * _e1502), _e1107);
                                                                        } else {
                                                                            phi_1917_ = type_18();
                                                                        }
                                                                        let _e1507 = phi_1917_;
                                                                        phi_1919_ = _e1507;
                                                                        phi_1920_ = select(true, false, _e1501);
                                                                    } else {
                                                                        phi_1919_ = type_18();
                                                                        phi_1920_ = true;
                                                                    }
                                                                    let _e1510 = phi_1919_;
                                                                    let _e1512 = phi_1920_;
                                                                    if _e1512 {
                                                                        phi_1924_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1924_ = _e1510;
                                                                    }
                                                                    let _e1514 = phi_1924_;
                                                                    phi_1925_ = _e1514;
                                                                }
                                                                let _e1516 = phi_1925_;
                                                                phi_1926_ = _e1516;
                                                                phi_1927_ = _e1386;
                                                            }
                                                            let _e1518 = phi_1926_;
                                                            let _e1520 = phi_1927_;
                                                            phi_1931_ = _e1518;
                                                            phi_1932_ = _e1520;
                                                        }
                                                        let _e1522 = phi_1931_;
                                                        let _e1524 = phi_1932_;
                                                        phi_1936_ = _e1522;
                                                        phi_1937_ = _e1524;
                                                    } else {
                                                        phi_1936_ = type_18();
                                                        phi_1937_ = true;
                                                    }
                                                    let _e1526 = phi_1936_;
                                                    let _e1528 = phi_1937_;
                                                    if _e1528 {
                                                        phi_1941_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1941_ = _e1526;
                                                    }
                                                    let _e1530 = phi_1941_;
                                                    if (_e1530.member_3 != 4294967295u) {
                                                        if (_e1107 != _e459) {
                                                            if (_e1530.member < _e1041.member.member.member) {
                                                                phi_1967_ = true;
                                                            } else {
                                                                if (_e1530.member == _e1041.member.member.member) {
                                                                    phi_1966_ = (_e1530.member_3 < _e1041.member.member.member_3);
                                                                } else {
                                                                    phi_1966_ = false;
                                                                }
                                                                let _e1545 = phi_1966_;
                                                                phi_1967_ = _e1545;
                                                            }
                                                            let _e1547 = phi_1967_;
                                                            if _e1547 {
                                                                phi_1974_ = type_38(type_35(_e1530, _e1530.member), _e1068.member_1, _e1068.member_2);
                                                            } else {
                                                                phi_1974_ = _e1068;
                                                            }
                                                            let _e1554 = phi_1974_;
                                                            phi_1975_ = _e1554;
                                                        } else {
                                                            phi_1975_ = _e1068;
                                                        }
                                                        let _e1556 = phi_1975_;
                                                        phi_1976_ = _e1556;
                                                    } else {
                                                        phi_1976_ = _e1068;
                                                    }
                                                    let _e1558 = phi_1976_;
                                                    phi_3823_ = _e1246;
                                                    phi_1007_ = _e1558;
                                                } else {
                                                    phi_3823_ = _e1039;
                                                    phi_1007_ = type_38();
                                                }
                                                let _e1560 = phi_3823_;
                                                let _e1562 = phi_1007_;
                                                continue;
                                                continuing {
                                                    phi_3764_ = _e1560;
                                                    phi_1006_ = _e1562;
                                                    phi_1009_ = _e1056;
                                                    phi_3822_ = _e1560;
                                                    break if !(_e1062);
                                                }
                                            }
                                            let _e1565 = phi_3822_;
                                            phi_3881_ = _e1565;
                                            if _e1565 {
                                                break;
                                            }
                                            phi_3885_ = _e1565;
                                            let _e1807 = local_15;
                                            phi_3361_ = _e1807;
                                            phi_3362_ = _e542;
                                            phi_3363_ = false;
                                            phi_3364_ = _e546;
                                        } else {
                                            if (_e542.member_1 >= _e94) {
                                                phi_2917_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e542.member_1 < _e94) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e566 = ((1u + (_e275 * 2u)) % 7u);
                                                if (_e566 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e571 = global_6.member[_e542.member_1][_e566];
                                                let _e574 = ((1u + (_e274 * 2u)) % 7u);
                                                if (_e574 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e579 = global_6.member[_e542.member_1][_e574];
                                                let _e582 = ((1u + (_e276 * 2u)) % 7u);
                                                if (_e582 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e587 = global_6.member[_e542.member_1][_e582];
                                                let _e590 = (((_e275 + 1u) * 2u) % 7u);
                                                if (_e590 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e595 = global_6.member[_e542.member_1][_e590];
                                                let _e598 = (((_e274 + 1u) * 2u) % 7u);
                                                if (_e598 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e603 = global_6.member[_e542.member_1][_e598];
                                                let _e606 = (((_e276 + 1u) * 2u) % 7u);
                                                if (_e606 < 7u) {
                                                } else {
                                                    phi_3881_ = true;
                                                    break;
                                                }
                                                let _e611 = global_6.member[_e542.member_1][_e606];
                                                let _e634 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e635 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e636 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e638 = select(_e149, _e634, (_e634 > _e149));
                                                let _e640 = select(_e149, _e635, (_e635 > _e149));
                                                let _e642 = select(_e149, _e636, (_e636 > _e149));
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
                                                let _e745 = (_e542.member.member.x + _e675);
                                                let _e746 = (_e542.member.member.y + _e684);
                                                let _e747 = (_e542.member.member.z + _e693);
                                                let _e750 = (_e542.member.member_1.x - _e714);
                                                let _e751 = (_e542.member.member_1.y - _e723);
                                                let _e752 = (_e542.member.member_1.z - _e732);
                                                let _e771 = (_e750 - _e745);
                                                let _e772 = (_e751 - _e746);
                                                let _e773 = (_e752 - _e747);
                                                let _e775 = select(_e772, _e771, (_e771 > _e772));
                                                let _e777 = select(_e773, _e775, (_e775 > _e773));
                                                if (_e777 < (1024f * _e149)) {
                                                    phi_2618_ = 0u;
                                                } else {
                                                    phi_2618_ = select(2u, 1u, (_e777 < (2097152f * _e149)));
                                                }
                                                let _e784 = phi_2618_;
                                                switch bitcast<i32>(_e784) {
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
                                                let _e787 = phi_2624_;
                                                let _e793 = global_6.member[_e542.member_1][0u];
                                                let _e797 = global_6.member[_e542.member_1][2u];
                                                let _e801 = global_6.member[_e542.member_1][4u];
                                                let _e805 = global_6.member[_e542.member_1][6u];
                                                let _e817 = (((_e797 >> bitcast<u32>(22i)) | ((_e801 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e805 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e818 = (_e793 & 268435455u);
                                                let _e819 = (_e817 & 268435455u);
                                                let _e822 = ((_e793 >> bitcast<u32>(28u)) & 7u);
                                                let _e830 = ((_e793 >> bitcast<u32>(31i)) | (((_e817 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e831 = (_e822 != 0u);
                                                if (_e822 == 0u) {
                                                    phi_2879_ = _e818;
                                                } else {
                                                    if (_e822 == 7u) {
                                                        phi_2878_ = 2147483648u;
                                                    } else {
                                                        phi_2878_ = ((2147483648u | (_e822 << bitcast<u32>(28u))) | (_e819 & 268435455u));
                                                    }
                                                    let _e840 = phi_2878_;
                                                    phi_2879_ = _e840;
                                                }
                                                let _e842 = phi_2879_;
                                                if _e831 {
                                                    let _e843 = (_e822 != 7u);
                                                    if _e843 {
                                                        phi_2889_ = (_e819 + (_e822 * ((3u * _e787) + 1u)));
                                                    } else {
                                                        phi_2889_ = u32();
                                                    }
                                                    let _e847 = phi_2889_;
                                                    phi_2891_ = _e847;
                                                    phi_2892_ = select(true, false, _e843);
                                                } else {
                                                    phi_2891_ = u32();
                                                    phi_2892_ = true;
                                                }
                                                let _e850 = phi_2891_;
                                                let _e852 = phi_2892_;
                                                if (_e830 == 0u) {
                                                    phi_2913_ = (_e818 + select(0u, 1u, !(_e831)));
                                                } else {
                                                    if (_e830 == 7u) {
                                                        phi_2912_ = 2147483648u;
                                                    } else {
                                                        phi_2912_ = ((2147483648u | (_e830 << bitcast<u32>(28u))) | (select(_e850, _e819, _e852) & 268435455u));
                                                    }
                                                    let _e865 = phi_2912_;
                                                    phi_2913_ = _e865;
                                                }
                                                let _e867 = phi_2913_;
                                                phi_2917_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e745, (_e542.member.member.x + _e697), _e750, (_e542.member.member_1.x - _e736)), vec4<f32>(_e746, (_e542.member.member.y + _e701), _e751, (_e542.member.member_1.y - _e740)), vec4<f32>(_e747, (_e542.member.member.z + _e705), _e752, (_e542.member.member_1.z - _e744))), type_53(type_30((_e542.member.member + vec4<f32>(_e675, _e684, _e693, 0f)), (_e542.member.member_1 - vec4<f32>(_e714, _e723, _e732, 0f))), _e842), type_53(type_30((_e542.member.member + vec4<f32>(_e697, _e701, _e705, 0f)), (_e542.member.member_1 - vec4<f32>(_e736, _e740, _e744, 0f))), _e867));
                                            }
                                            let _e872 = phi_2917_;
                                            let _e885 = ((_e872.member[0].x - _e330) * _e335);
                                            let _e886 = ((_e872.member[0].y - _e330) * _e335);
                                            let _e887 = ((_e872.member[0].z - _e331) * _e335);
                                            let _e888 = ((_e872.member[0].w - _e331) * _e335);
                                            let _e898 = ((_e872.member[1].x - _e366) * _e371);
                                            let _e899 = ((_e872.member[1].y - _e366) * _e371);
                                            let _e900 = ((_e872.member[1].z - _e367) * _e371);
                                            let _e901 = ((_e872.member[1].w - _e367) * _e371);
                                            let _e911 = ((_e872.member[2].x - _e402) * _e407);
                                            let _e912 = ((_e872.member[2].y - _e402) * _e407);
                                            let _e913 = ((_e872.member[2].z - _e403) * _e407);
                                            let _e914 = ((_e872.member[2].w - _e403) * _e407);
                                            let _e916 = select(_e913, _e911, (_e911 < _e913));
                                            let _e918 = select(_e914, _e912, (_e912 < _e914));
                                            let _e920 = select(_e913, _e911, (_e911 > _e913));
                                            let _e922 = select(_e914, _e912, (_e912 > _e914));
                                            let _e924 = select(_e887, _e885, (_e885 < _e887));
                                            let _e926 = select(_e888, _e886, (_e886 < _e888));
                                            let _e928 = select(_e900, _e898, (_e898 < _e900));
                                            let _e930 = select(_e901, _e899, (_e899 < _e901));
                                            let _e932 = select(_e928, _e924, (_e924 > _e928));
                                            let _e934 = select(_e930, _e926, (_e926 > _e930));
                                            let _e936 = select(_e916, _e932, (_e932 > _e916));
                                            let _e938 = select(_e918, _e934, (_e934 > _e918));
                                            let _e940 = select(_e887, _e885, (_e885 > _e887));
                                            let _e942 = select(_e888, _e886, (_e886 > _e888));
                                            let _e944 = select(_e900, _e898, (_e898 > _e900));
                                            let _e946 = select(_e901, _e899, (_e899 > _e901));
                                            let _e948 = select(_e944, _e940, (_e940 < _e944));
                                            let _e950 = select(_e946, _e942, (_e942 < _e946));
                                            let _e955 = -(_e916);
                                            let _e956 = -(_e918);
                                            let _e963 = (select(_e920, _e948, (_e948 < _e920)) + (select(_e955, _e920, (_e920 > _e955)) * 0.0000019073523f));
                                            let _e964 = (select(_e922, _e950, (_e950 < _e922)) + (select(_e956, _e922, (_e922 > _e956)) * 0.0000019073523f));
                                            let _e966 = select(_e453, _e936, (_e936 > _e453));
                                            let _e968 = select(_e453, _e938, (_e938 > _e453));
                                            let _e973 = (_e966 <= select(_e502.member.member_1, _e963, (_e963 < _e502.member.member_1)));
                                            let _e974 = (_e968 <= select(_e502.member.member_1, _e964, (_e964 < _e502.member.member_1)));
                                            let _e975 = (_e966 <= _e968);
                                            if _e973 {
                                                if _e974 {
                                                    if _e975 {
                                                        phi_3261_ = _e872.member_2;
                                                    } else {
                                                        phi_3261_ = _e872.member_1;
                                                    }
                                                    let _e979 = phi_3261_;
                                                    let _e1001 = (_e546 % 128u);
                                                    let _e1002 = (_e1001 < 128u);
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1001] = _e979.member_1;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1001] = _e979.member.member.x;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1001] = _e979.member.member.y;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1001] = _e979.member.member.z;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1001] = _e979.member.member_1.x;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1001] = _e979.member.member_1.y;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1001] = _e979.member.member_1.z;
                                                    if _e1002 {
                                                    } else {
                                                        phi_3881_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1001] = select(_e968, _e966, (_e966 > _e968));
                                                    if _e975 {
                                                        phi_3338_ = _e872.member_1;
                                                    } else {
                                                        phi_3338_ = _e872.member_2;
                                                    }
                                                    let _e1015 = phi_3338_;
                                                    phi_3339_ = _e1015;
                                                    phi_3340_ = (_e546 + 1u);
                                                } else {
                                                    phi_3339_ = type_53();
                                                    phi_3340_ = u32();
                                                }
                                                let _e1017 = phi_3339_;
                                                let _e1019 = phi_3340_;
                                                phi_3342_ = _e1017;
                                                phi_3343_ = _e1019;
                                                phi_3344_ = select(true, false, _e974);
                                            } else {
                                                phi_3342_ = type_53();
                                                phi_3343_ = u32();
                                                phi_3344_ = true;
                                            }
                                            let _e1022 = phi_3342_;
                                            let _e1024 = phi_3343_;
                                            let _e1026 = phi_3344_;
                                            if _e1026 {
                                                if _e973 {
                                                    phi_3353_ = _e872.member_1;
                                                } else {
                                                    phi_3353_ = _e872.member_2;
                                                }
                                                let _e1030 = phi_3353_;
                                                phi_3358_ = _e1030;
                                                phi_3359_ = select(_e974, true, _e973);
                                            } else {
                                                phi_3358_ = _e1022;
                                                phi_3359_ = _e544;
                                            }
                                            let _e1033 = phi_3358_;
                                            let _e1035 = phi_3359_;
                                            phi_3885_ = _e500;
                                            phi_3361_ = type_38(_e502.member, (_e502.member_1 + 1u), _e502.member_2);
                                            phi_3362_ = _e1033;
                                            phi_3363_ = _e1035;
                                            phi_3364_ = select(_e1024, _e546, _e1026);
                                        }
                                        let _e1567 = phi_3885_;
                                        let _e1569 = phi_3361_;
                                        let _e1571 = phi_3362_;
                                        let _e1573 = phi_3363_;
                                        let _e1575 = phi_3364_;
                                        phi_3884_ = _e1567;
                                        phi_3365_ = _e1569;
                                        phi_3366_ = _e1571;
                                        phi_3367_ = (_e506 - 1u);
                                        phi_3368_ = _e1573;
                                        phi_3369_ = _e1575;
                                    } else {
                                        phi_3884_ = _e500;
                                        phi_3365_ = _e502;
                                        phi_3366_ = _e542;
                                        phi_3367_ = _e506;
                                        phi_3368_ = _e544;
                                        phi_3369_ = _e546;
                                    }
                                    let _e1577 = phi_3884_;
                                    let _e1579 = phi_3365_;
                                    let _e1581 = phi_3366_;
                                    let _e1583 = phi_3367_;
                                    let _e1585 = phi_3368_;
                                    let _e1587 = phi_3369_;
                                    phi_3883_ = _e1577;
                                    phi_3370_ = _e1579;
                                    phi_3371_ = _e1581;
                                    phi_3372_ = _e1583;
                                    phi_3373_ = _e1585;
                                    phi_3374_ = _e1587;
                                } else {
                                    phi_3883_ = _e500;
                                    phi_3370_ = type_38();
                                    phi_3371_ = type_53();
                                    phi_3372_ = u32();
                                    phi_3373_ = bool();
                                    phi_3374_ = u32();
                                }
                                let _e1589 = phi_3883_;
                                let _e1591 = phi_3370_;
                                let _e1593 = phi_3371_;
                                let _e1595 = phi_3372_;
                                let _e1597 = phi_3373_;
                                let _e1599 = phi_3374_;
                                phi_3882_ = _e1589;
                                phi_880_ = _e1591;
                                phi_883_ = _e1593;
                                phi_885_ = _e1595;
                                phi_887_ = _e1597;
                                phi_889_ = _e1599;
                                phi_3375_ = _e514;
                            } else {
                                phi_3882_ = _e500;
                                phi_880_ = type_38();
                                phi_883_ = type_53();
                                phi_885_ = u32();
                                phi_887_ = bool();
                                phi_889_ = u32();
                                phi_3375_ = false;
                            }
                            let _e1601 = phi_3882_;
                            let _e1603 = phi_880_;
                            let _e1605 = phi_883_;
                            let _e1607 = phi_885_;
                            let _e1609 = phi_887_;
                            let _e1611 = phi_889_;
                            let _e1613 = phi_3375_;
                            continue;
                            continuing {
                                phi_3767_ = _e1601;
                                phi_879_ = _e1603;
                                phi_882_ = _e1605;
                                phi_884_ = _e1607;
                                phi_886_ = _e1609;
                                phi_888_ = _e1611;
                                phi_3881_ = _e1601;
                                break if !(_e1613);
                            }
                        }
                        let _e1616 = phi_3881_;
                        if _e1616 {
                            break;
                        }
                        let _e1618 = local_13;
                        if (_e1618.member.member.member_3 != 4294967295u) {
                            let _e1624 = (_e277 / 3i);
                            let _e1631 = bitcast<f32>((bitcast<u32>((_e1624 + 127i)) << bitcast<u32>(23i)));
                            let _e1639 = (((_e1618.member.member.member * _e1631) * _e1631) * bitcast<f32>((bitcast<u32>(((_e277 - (2i * _e1624)) + 127i)) << bitcast<u32>(23i))));
                            let _e1641 = select(340282350000000000000000000000000000000f, _e1639, (_e1639 < 340282350000000000000000000000000000000f));
                            phi_3427_ = type_18(select(-340282350000000000000000000000000000000f, _e1641, (_e1641 > -340282350000000000000000000000000000000f)), _e1618.member.member.member_1, _e1618.member.member.member_2, _e1618.member.member.member_3);
                        } else {
                            phi_3427_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1648 = phi_3427_;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_1.member[_e137] = _e1648;
                        let _e1652 = local_14;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_4.member[_e137] = _e1652.member_1;
                        if _e152 {
                        } else {
                            break;
                        }
                        let _e1657 = select(0u, 1u, (_e221 <= _e231));
                        if (_e1657 > 0u) {
                            let _e1659 = (1u < _e105);
                            if _e1659 {
                                if (0u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1663 = atomicAdd((&global_5.member[0u]), _e1657);
                                if ((_e1663 + _e1657) < _e1663) {
                                    if _e1659 {
                                    } else {
                                        break;
                                    }
                                    let _e1668 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1671 = select(0u, 1u, (_e1648.member_3 != 4294967295u));
                        if (_e1671 > 0u) {
                            let _e1673 = (3u < _e105);
                            if _e1673 {
                                if (2u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1677 = atomicAdd((&global_5.member[2u]), _e1671);
                                if ((_e1677 + _e1671) < _e1677) {
                                    if _e1673 {
                                    } else {
                                        break;
                                    }
                                    let _e1682 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1652.member_1 > 0u) {
                            let _e1684 = (5u < _e105);
                            if _e1684 {
                                if (4u < _e105) {
                                } else {
                                    break;
                                }
                                let _e1688 = atomicAdd((&global_5.member[4u]), _e1652.member_1);
                                if ((_e1688 + _e1652.member_1) < _e1688) {
                                    if _e1684 {
                                    } else {
                                        break;
                                    }
                                    let _e1693 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
