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
    var phi_3468_: bool;
    var phi_859_: type_46;
    var phi_862_: type_53;
    var phi_864_: u32;
    var phi_866_: bool;
    var phi_868_: u32;
    var phi_879_: bool;
    var phi_965_: type_53;
    var phi_966_: bool;
    var phi_967_: u32;
    var phi_2602_: u32;
    var phi_2603_: u32;
    var phi_2613_: u32;
    var phi_2615_: u32;
    var phi_2616_: bool;
    var phi_2636_: u32;
    var phi_2637_: u32;
    var phi_2641_: type_54;
    var phi_2985_: type_53;
    var phi_3062_: type_53;
    var phi_3063_: type_53;
    var phi_3064_: u32;
    var phi_3066_: type_53;
    var phi_3067_: u32;
    var phi_3068_: bool;
    var phi_3077_: type_53;
    var phi_3082_: type_53;
    var phi_3083_: bool;
    var phi_985_: type_46;
    var phi_988_: type_7;
    var phi_989_: type_7;
    var phi_1011_: type_7;
    var phi_1035_: u32;
    var phi_1124_: array<array<f32, 3>, 3>;
    var phi_1595_: vec3<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1627_: bool;
    var phi_1636_: vec3<f32>;
    var phi_1676_: type_26;
    var phi_1678_: type_26;
    var phi_1679_: bool;
    var phi_1683_: type_26;
    var phi_1684_: type_26;
    var phi_1685_: type_26;
    var phi_1686_: bool;
    var phi_1690_: type_26;
    var phi_1691_: bool;
    var phi_1695_: type_26;
    var phi_1696_: bool;
    var phi_1700_: type_26;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1733_: type_46;
    var phi_1734_: type_46;
    var phi_1735_: type_46;
    var phi_986_: type_46;
    var phi_3462_: bool;
    var phi_3580_: bool;
    var phi_3085_: type_46;
    var phi_3086_: type_53;
    var phi_3087_: bool;
    var phi_3088_: u32;
    var phi_3579_: bool;
    var phi_3089_: type_46;
    var phi_3090_: type_53;
    var phi_3091_: u32;
    var phi_3092_: bool;
    var phi_3093_: u32;
    var phi_3578_: bool;
    var phi_3094_: type_46;
    var phi_3095_: type_53;
    var phi_3096_: u32;
    var phi_3097_: bool;
    var phi_3098_: u32;
    var phi_3577_: bool;
    var phi_860_: type_46;
    var phi_863_: type_53;
    var phi_865_: u32;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_3099_: bool;
    var phi_3576_: bool;
    var local_10: type_46;
    var phi_3151_: type_26;
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
                                phi_391_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                            }
                            let _e245 = phi_391_;
                            phi_392_ = _e245;
                        } else {
                            phi_392_ = 0i;
                        }
                        let _e247 = phi_392_;
                        let _e248 = (_e157 == _e201);
                        if _e248 {
                            phi_402_ = true;
                        } else {
                            phi_402_ = (_e165 == _e201);
                        }
                        let _e251 = phi_402_;
                        let _e252 = select(1u, 0u, _e248);
                        if _e251 {
                            let _e253 = (_e252 + 1u);
                            phi_412_ = _e253;
                            phi_413_ = _e253;
                            phi_415_ = select(true, false, (_e253 == 2u));
                        } else {
                            phi_412_ = u32();
                            phi_413_ = 0u;
                            phi_415_ = true;
                        }
                        let _e257 = phi_412_;
                        let _e259 = phi_413_;
                        let _e261 = phi_415_;
                        if _e261 {
                            phi_420_ = (_e259 + 1u);
                        } else {
                            phi_420_ = 0u;
                        }
                        let _e265 = phi_420_;
                        let _e266 = select(_e257, _e259, _e261);
                        let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                        let _e268 = -(_e247);
                        if (_e268 < -126i) {
                            phi_453_ = -126i;
                        } else {
                            phi_453_ = select(_e268, 127i, (_e268 > 127i));
                        }
                        let _e273 = phi_453_;
                        let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                        let _e284 = bitcast<f32>((bitcast<u32>(((_e268 - _e273) + 127i)) << bitcast<u32>(23i)));
                        let _e289 = global_5.member[_e128].member.member;
                        let _e290 = (_e266 == 0u);
                        if _e290 {
                            phi_471_ = _e289[0];
                        } else {
                            phi_471_ = _e289[1];
                        }
                        let _e294 = phi_471_;
                        let _e295 = (_e266 == 2u);
                        if _e295 {
                            phi_477_ = _e289[2];
                        } else {
                            phi_477_ = _e294;
                        }
                        let _e298 = phi_477_;
                        let _e299 = global_5.member[_e128].member.member_2;
                        if _e290 {
                            phi_488_ = _e299[0];
                        } else {
                            phi_488_ = _e299[1];
                        }
                        let _e303 = phi_488_;
                        if _e295 {
                            phi_494_ = _e299[2];
                        } else {
                            phi_494_ = _e303;
                        }
                        let _e306 = phi_494_;
                        let _e308 = ((_e306 * _e278) * _e284);
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e312 {
                            let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                            phi_517_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                        } else {
                            phi_517_ = 0f;
                        }
                        let _e320 = phi_517_;
                        let _e321 = (_e298 + _e320);
                        let _e322 = (_e298 - _e320);
                        let _e323 = select(_e308, 0f, _e312);
                        if _e312 {
                            phi_528_ = 38685626000000000000000000f;
                        } else {
                            phi_528_ = (1f / _e308);
                        }
                        let _e326 = phi_528_;
                        let _e327 = (_e265 == 0u);
                        if _e327 {
                            phi_537_ = _e289[0];
                        } else {
                            phi_537_ = _e289[1];
                        }
                        let _e331 = phi_537_;
                        let _e332 = (_e265 == 2u);
                        if _e332 {
                            phi_543_ = _e289[2];
                        } else {
                            phi_543_ = _e331;
                        }
                        let _e335 = phi_543_;
                        if _e327 {
                            phi_554_ = _e299[0];
                        } else {
                            phi_554_ = _e299[1];
                        }
                        let _e339 = phi_554_;
                        if _e332 {
                            phi_560_ = _e299[2];
                        } else {
                            phi_560_ = _e339;
                        }
                        let _e342 = phi_560_;
                        let _e344 = ((_e342 * _e278) * _e284);
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e344) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e348 {
                            let _e352 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_583_ = select(0.00000000000011368684f, _e352, (_e352 > 0.00000000000011368684f));
                        } else {
                            phi_583_ = 0f;
                        }
                        let _e356 = phi_583_;
                        let _e357 = (_e335 + _e356);
                        let _e358 = (_e335 - _e356);
                        let _e359 = select(_e344, 0f, _e348);
                        if _e348 {
                            phi_594_ = 38685626000000000000000000f;
                        } else {
                            phi_594_ = (1f / _e344);
                        }
                        let _e362 = phi_594_;
                        let _e363 = (_e267 == 0u);
                        if _e363 {
                            phi_603_ = _e289[0];
                        } else {
                            phi_603_ = _e289[1];
                        }
                        let _e367 = phi_603_;
                        let _e368 = (_e267 == 2u);
                        if _e368 {
                            phi_609_ = _e289[2];
                        } else {
                            phi_609_ = _e367;
                        }
                        let _e371 = phi_609_;
                        if _e363 {
                            phi_620_ = _e299[0];
                        } else {
                            phi_620_ = _e299[1];
                        }
                        let _e375 = phi_620_;
                        if _e368 {
                            phi_626_ = _e299[2];
                        } else {
                            phi_626_ = _e375;
                        }
                        let _e378 = phi_626_;
                        let _e380 = ((_e378 * _e278) * _e284);
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e384 {
                            let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                            phi_649_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                        } else {
                            phi_649_ = 0f;
                        }
                        let _e392 = phi_649_;
                        let _e393 = (_e371 + _e392);
                        let _e394 = (_e371 - _e392);
                        let _e395 = select(_e380, 0f, _e384);
                        if _e384 {
                            phi_660_ = 38685626000000000000000000f;
                        } else {
                            phi_660_ = (1f / _e380);
                        }
                        let _e398 = phi_660_;
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
                            phi_760_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_760_ = 0f;
                            phi_761_ = 1f;
                        }
                        let _e442 = phi_760_;
                        let _e444 = phi_761_;
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
                        phi_3468_ = false;
                        phi_859_ = type_46(type_42(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e442), 0u, 0u);
                        phi_862_ = type_53(type_38(vec4<f32>((f32(_e456) * _e140), (f32(_e462) * _e140), (f32(_e468) * _e140), 0f), vec4<f32>((f32(_e473) * _e140), (f32(_e477) * _e140), (f32(_e481) * _e140), 0f)), select(0u, 2147483648u, (_e86 == 0u)));
                        phi_864_ = ((3u * _e86) + 1u);
                        phi_866_ = (_e444 <= _e442);
                        phi_868_ = 0u;
                        loop {
                            let _e491 = phi_3468_;
                            let _e493 = phi_859_;
                            let _e495 = phi_862_;
                            let _e497 = phi_864_;
                            let _e499 = phi_866_;
                            let _e501 = phi_868_;
                            local_10 = _e493;
                            local_11 = _e493;
                            if _e499 {
                                phi_879_ = true;
                            } else {
                                phi_879_ = (_e501 > 0u);
                            }
                            let _e504 = phi_879_;
                            if _e504 {
                                let _e505 = (_e497 > 0u);
                                if _e505 {
                                    if _e499 {
                                        phi_965_ = _e495;
                                        phi_966_ = _e499;
                                        phi_967_ = _e501;
                                    } else {
                                        let _e506 = (_e501 - 1u);
                                        let _e507 = (_e506 % 128u);
                                        let _e508 = (_e507 < 128u);
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e510 = local_7[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e512 = local_6[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e514 = local_5[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e516 = local_4[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e518 = local_3[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e520 = local_2[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e525 = local_8[_e507];
                                        if _e508 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e528 = local_9[_e507];
                                        phi_965_ = type_53(type_38(vec4<f32>(_e510, _e512, _e514, 0f), vec4<f32>(_e516, _e518, _e520, 0f)), _e525);
                                        phi_966_ = (_e528 <= _e493.member.member_1);
                                        phi_967_ = _e506;
                                    }
                                    let _e533 = phi_965_;
                                    let _e535 = phi_966_;
                                    let _e537 = phi_967_;
                                    if _e535 {
                                        if ((_e533.member_1 & 2147483648u) != 0u) {
                                            phi_985_ = _e493;
                                            phi_988_ = type_7(0u, ((_e533.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1009 = phi_985_;
                                                let _e1011 = phi_988_;
                                                local_12 = _e1009;
                                                if (_e1011.member < _e1011.member_1) {
                                                    phi_989_ = type_7((_e1011.member + 1u), _e1011.member_1);
                                                    phi_1011_ = type_7(1u, _e1011.member);
                                                } else {
                                                    phi_989_ = _e1011;
                                                    phi_1011_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1024 = phi_989_;
                                                let _e1026 = phi_1011_;
                                                let _e1030 = (bitcast<i32>(_e1026.member) != 0i);
                                                if _e1030 {
                                                    let _e1036 = type_46(_e1009.member, _e1009.member_1, (_e1009.member_2 + 1u));
                                                    let _e1037 = ((_e533.member_1 & 268435455u) + _e1026.member_1);
                                                    let _e1038 = (_e1037 < _e88);
                                                    if _e1038 {
                                                        if _e1038 {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1042 = global_1.member[_e1037].member_1;
                                                        phi_1035_ = _e1042;
                                                    } else {
                                                        phi_1035_ = 4294967295u;
                                                    }
                                                    let _e1044 = phi_1035_;
                                                    if (_e1037 >= _e88) {
                                                        phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1038 {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        if (_e453 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1051 = global_1.member[_e1037].member[_e453];
                                                        if (_e459 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1057 = global_1.member[_e1037].member[_e459];
                                                        if (_e465 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1063 = global_1.member[_e1037].member[_e465];
                                                        let _e1065 = (3u + _e453);
                                                        if (_e1065 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1071 = global_1.member[_e1037].member[_e1065];
                                                        let _e1072 = (3u + _e459);
                                                        if (_e1072 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1078 = global_1.member[_e1037].member[_e1072];
                                                        let _e1079 = (3u + _e465);
                                                        if (_e1079 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1085 = global_1.member[_e1037].member[_e1079];
                                                        let _e1087 = (6u + _e453);
                                                        if (_e1087 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1093 = global_1.member[_e1037].member[_e1087];
                                                        let _e1094 = (6u + _e459);
                                                        if (_e1094 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1100 = global_1.member[_e1037].member[_e1094];
                                                        let _e1101 = (6u + _e465);
                                                        if (_e1101 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1107 = global_1.member[_e1037].member[_e1101];
                                                        phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1051, _e1057, _e1063), array<f32, 3>(_e1071, _e1078, _e1085), array<f32, 3>(_e1093, _e1100, _e1107));
                                                    }
                                                    let _e1111 = phi_1124_;
                                                    let _e1120 = (_e1111[0][2] - _e371);
                                                    let _e1123 = (((_e1111[0][0] - _e298) * _e395) - (_e1120 * _e323));
                                                    let _e1126 = (((_e1111[0][1] - _e335) * _e395) - (_e1120 * _e359));
                                                    let _e1133 = (_e1111[1][2] - _e371);
                                                    let _e1136 = (((_e1111[1][0] - _e298) * _e395) - (_e1133 * _e323));
                                                    let _e1139 = (((_e1111[1][1] - _e335) * _e395) - (_e1133 * _e359));
                                                    let _e1146 = (_e1111[2][2] - _e371);
                                                    let _e1149 = (((_e1111[2][0] - _e298) * _e395) - (_e1146 * _e323));
                                                    let _e1152 = (((_e1111[2][1] - _e335) * _e395) - (_e1146 * _e359));
                                                    let _e1153 = (_e1149 * _e1139);
                                                    let _e1154 = (_e1152 * _e1136);
                                                    let _e1155 = (_e1123 * _e1152);
                                                    let _e1156 = (_e1126 * _e1149);
                                                    let _e1157 = (_e1136 * _e1126);
                                                    let _e1158 = (_e1139 * _e1123);
                                                    let _e1163 = (((_e1153 >= _e1154) && (_e1155 >= _e1156)) && (_e1157 >= _e1158));
                                                    if (_e1163 || (((_e1153 <= _e1154) && (_e1155 <= _e1156)) && (_e1157 <= _e1158))) {
                                                        let _e1170 = select(-1f, 1f, _e1163);
                                                        let _e1172 = ((_e1153 - _e1154) * _e1170);
                                                        let _e1174 = select(0f, _e1172, (_e1172 > 0f));
                                                        let _e1176 = ((_e1155 - _e1156) * _e1170);
                                                        let _e1178 = select(0f, _e1176, (_e1176 > 0f));
                                                        let _e1180 = ((_e1157 - _e1158) * _e1170);
                                                        let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                        let _e1184 = ((_e1174 + _e1178) + _e1182);
                                                        if (_e1184 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1690_ = type_26();
                                                            phi_1691_ = true;
                                                        } else {
                                                            let _e1187 = select(_e1111[1][0], _e1111[0][0], (_e1111[0][0] < _e1111[1][0]));
                                                            let _e1191 = select(_e1111[1][0], _e1111[0][0], (_e1111[0][0] > _e1111[1][0]));
                                                            let _e1195 = select(_e1111[1][1], _e1111[0][1], (_e1111[0][1] < _e1111[1][1]));
                                                            let _e1199 = select(_e1111[1][1], _e1111[0][1], (_e1111[0][1] > _e1111[1][1]));
                                                            let _e1203 = select(_e1111[1][2], _e1111[0][2], (_e1111[0][2] < _e1111[1][2]));
                                                            let _e1207 = select(_e1111[1][2], _e1111[0][2], (_e1111[0][2] > _e1111[1][2]));
                                                            let _e1212 = ((select(_e1111[2][0], _e1187, (_e1187 < _e1111[2][0])) - _e321) * _e326);
                                                            let _e1213 = ((select(_e1111[2][0], _e1191, (_e1191 > _e1111[2][0])) - _e322) * _e326);
                                                            let _e1216 = ((select(_e1111[2][1], _e1195, (_e1195 < _e1111[2][1])) - _e357) * _e362);
                                                            let _e1217 = ((select(_e1111[2][1], _e1199, (_e1199 > _e1111[2][1])) - _e358) * _e362);
                                                            let _e1220 = ((select(_e1111[2][2], _e1203, (_e1203 < _e1111[2][2])) - _e393) * _e398);
                                                            let _e1221 = ((select(_e1111[2][2], _e1207, (_e1207 > _e1111[2][2])) - _e394) * _e398);
                                                            let _e1223 = select(_e1221, _e1220, (_e1220 < _e1221));
                                                            let _e1225 = select(_e1221, _e1220, (_e1220 > _e1221));
                                                            let _e1227 = select(_e1213, _e1212, (_e1212 < _e1213));
                                                            let _e1229 = select(_e1217, _e1216, (_e1216 < _e1217));
                                                            let _e1231 = select(_e1229, _e1227, (_e1227 > _e1229));
                                                            let _e1233 = select(_e1223, _e1231, (_e1231 > _e1223));
                                                            let _e1235 = select(_e1213, _e1212, (_e1212 > _e1213));
                                                            let _e1237 = select(_e1217, _e1216, (_e1216 > _e1217));
                                                            let _e1239 = select(_e1237, _e1235, (_e1235 < _e1237));
                                                            let _e1241 = select(_e1225, _e1239, (_e1239 < _e1225));
                                                            let _e1242 = -(_e1223);
                                                            let _e1248 = select(_e444, _e1233, (_e1233 > _e444));
                                                            if (_e1248 > (_e1241 + (select(_e1242, _e1225, (_e1225 > _e1242)) * 0.0000019073523f))) {
                                                                phi_1685_ = type_26();
                                                                phi_1686_ = true;
                                                            } else {
                                                                let _e1250 = (_e1248 > _e1009.member.member_1);
                                                                if _e1250 {
                                                                    phi_1684_ = type_26();
                                                                } else {
                                                                    let _e1254 = (_e1111[1][0] - _e1111[0][0]);
                                                                    let _e1255 = (_e1111[1][1] - _e1111[0][1]);
                                                                    let _e1256 = (_e1111[1][2] - _e1111[0][2]);
                                                                    let _e1257 = vec3<f32>(_e1254, _e1255, _e1256);
                                                                    let _e1258 = (_e1111[2][0] - _e1111[1][0]);
                                                                    let _e1259 = (_e1111[2][1] - _e1111[1][1]);
                                                                    let _e1260 = (_e1111[2][2] - _e1111[1][2]);
                                                                    let _e1261 = vec3<f32>(_e1258, _e1259, _e1260);
                                                                    let _e1262 = (_e1111[0][0] - _e1111[2][0]);
                                                                    let _e1263 = (_e1111[0][1] - _e1111[2][1]);
                                                                    let _e1264 = (_e1111[0][2] - _e1111[2][2]);
                                                                    let _e1265 = vec3<f32>(_e1262, _e1263, _e1264);
                                                                    let _e1268 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                    let _e1271 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                    let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                    let _e1276 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                    let _e1278 = select(_e1276, _e1273, (_e1273 > _e1276));
                                                                    let _e1281 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                    let _e1284 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                    let _e1286 = select(_e1284, _e1281, (_e1281 > _e1284));
                                                                    let _e1289 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                    let _e1291 = select(_e1289, _e1286, (_e1286 > _e1289));
                                                                    let _e1294 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                    let _e1297 = bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u));
                                                                    let _e1299 = select(_e1297, _e1294, (_e1294 > _e1297));
                                                                    let _e1302 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                    let _e1304 = select(_e1302, _e1299, (_e1299 > _e1302));
                                                                    let _e1306 = select(_e1291, _e1278, (_e1278 > _e1291));
                                                                    let _e1308 = select(_e1304, _e1306, (_e1306 > _e1304));
                                                                    if (_e1278 == _e1308) {
                                                                        phi_1595_ = _e1261;
                                                                        phi_1596_ = _e1265;
                                                                    } else {
                                                                        let _e1311 = vec3((_e1291 == _e1308));
                                                                        phi_1595_ = select(_e1257, _e1265, _e1311);
                                                                        phi_1596_ = select(_e1261, _e1257, _e1311);
                                                                    }
                                                                    let _e1315 = phi_1595_;
                                                                    let _e1317 = phi_1596_;
                                                                    let _e1324 = ((_e1315.y * _e1317.z) - (_e1317.y * _e1315.z));
                                                                    let _e1329 = ((_e1315.z * _e1317.x) - (_e1317.z * _e1315.x));
                                                                    let _e1332 = ((_e1315.x * _e1317.y) - (_e1317.x * _e1315.y));
                                                                    if (_e1174 >= _e1178) {
                                                                        phi_1627_ = select(true, false, (_e1174 >= _e1182));
                                                                    } else {
                                                                        phi_1627_ = true;
                                                                    }
                                                                    let _e1337 = phi_1627_;
                                                                    if _e1337 {
                                                                        phi_1636_ = select(vec3<f32>(_e1111[2][0], _e1111[2][1], _e1111[2][2]), vec3<f32>(_e1111[1][0], _e1111[1][1], _e1111[1][2]), vec3((_e1178 >= _e1182)));
                                                                    } else {
                                                                        phi_1636_ = vec3<f32>(_e1111[0][0], _e1111[0][1], _e1111[0][2]);
                                                                    }
                                                                    let _e1342 = phi_1636_;
                                                                    let _e1359 = ((((_e1324 * (_e1342.x - _e298)) + (_e1329 * (_e1342.y - _e335))) + (_e1332 * (_e1342.z - _e371))) / (((_e1324 * _e323) + (_e1329 * _e359)) + (_e1332 * _e395)));
                                                                    let _e1361 = select(_e1241, _e1359, (_e1359 < _e1241));
                                                                    let _e1363 = select(_e1233, _e1361, (_e1361 > _e1233));
                                                                    if (_e1363 >= _e444) {
                                                                        let _e1365 = (_e1363 <= _e1009.member.member_1);
                                                                        if _e1365 {
                                                                            let _e1366 = (1f / _e1184);
                                                                            phi_1676_ = type_26(_e1363, (_e1178 * _e1366), (_e1182 * _e1366), _e1044);
                                                                        } else {
                                                                            phi_1676_ = type_26();
                                                                        }
                                                                        let _e1371 = phi_1676_;
                                                                        phi_1678_ = _e1371;
                                                                        phi_1679_ = select(true, false, _e1365);
                                                                    } else {
                                                                        phi_1678_ = type_26();
                                                                        phi_1679_ = true;
                                                                    }
                                                                    let _e1374 = phi_1678_;
                                                                    let _e1376 = phi_1679_;
                                                                    if _e1376 {
                                                                        phi_1683_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1683_ = _e1374;
                                                                    }
                                                                    let _e1378 = phi_1683_;
                                                                    phi_1684_ = _e1378;
                                                                }
                                                                let _e1380 = phi_1684_;
                                                                phi_1685_ = _e1380;
                                                                phi_1686_ = _e1250;
                                                            }
                                                            let _e1382 = phi_1685_;
                                                            let _e1384 = phi_1686_;
                                                            phi_1690_ = _e1382;
                                                            phi_1691_ = _e1384;
                                                        }
                                                        let _e1386 = phi_1690_;
                                                        let _e1388 = phi_1691_;
                                                        phi_1695_ = _e1386;
                                                        phi_1696_ = _e1388;
                                                    } else {
                                                        phi_1695_ = type_26();
                                                        phi_1696_ = true;
                                                    }
                                                    let _e1390 = phi_1695_;
                                                    let _e1392 = phi_1696_;
                                                    if _e1392 {
                                                        phi_1700_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1700_ = _e1390;
                                                    }
                                                    let _e1394 = phi_1700_;
                                                    if (_e1394.member_3 != 4294967295u) {
                                                        if (_e1044 != _e450) {
                                                            if (_e1394.member < _e1009.member.member.member) {
                                                                phi_1726_ = true;
                                                            } else {
                                                                if (_e1394.member == _e1009.member.member.member) {
                                                                    phi_1725_ = (_e1394.member_3 < _e1009.member.member.member_3);
                                                                } else {
                                                                    phi_1725_ = false;
                                                                }
                                                                let _e1409 = phi_1725_;
                                                                phi_1726_ = _e1409;
                                                            }
                                                            let _e1411 = phi_1726_;
                                                            if _e1411 {
                                                                phi_1733_ = type_46(type_42(_e1394, _e1394.member), _e1036.member_1, _e1036.member_2);
                                                            } else {
                                                                phi_1733_ = _e1036;
                                                            }
                                                            let _e1418 = phi_1733_;
                                                            phi_1734_ = _e1418;
                                                        } else {
                                                            phi_1734_ = _e1036;
                                                        }
                                                        let _e1420 = phi_1734_;
                                                        phi_1735_ = _e1420;
                                                    } else {
                                                        phi_1735_ = _e1036;
                                                    }
                                                    let _e1422 = phi_1735_;
                                                    phi_986_ = _e1422;
                                                } else {
                                                    phi_986_ = type_46();
                                                }
                                                let _e1424 = phi_986_;
                                                continue;
                                                continuing {
                                                    phi_985_ = _e1424;
                                                    phi_988_ = _e1024;
                                                    phi_3462_ = _e491;
                                                    break if !(_e1030);
                                                }
                                            }
                                            let _e1427 = phi_3462_;
                                            phi_3576_ = _e1427;
                                            if _e1427 {
                                                break;
                                            }
                                            phi_3580_ = _e1427;
                                            let _e1644 = local_12;
                                            phi_3085_ = _e1644;
                                            phi_3086_ = _e533;
                                            phi_3087_ = false;
                                            phi_3088_ = _e537;
                                        } else {
                                            if (_e533.member_1 >= _e86) {
                                                phi_2641_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e533.member_1 < _e86) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e555 = ((1u + _e266) % 4u);
                                                if (_e555 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e560 = global_4.member[_e533.member_1][_e555];
                                                let _e562 = ((1u + _e265) % 4u);
                                                if (_e562 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e567 = global_4.member[_e533.member_1][_e562];
                                                let _e569 = ((1u + _e267) % 4u);
                                                if (_e569 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e574 = global_4.member[_e533.member_1][_e569];
                                                let _e576 = ((_e266 + 1u) % 4u);
                                                if (_e576 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e581 = global_4.member[_e533.member_1][_e576];
                                                let _e583 = (_e581 >> bitcast<u32>(11u));
                                                let _e585 = ((_e265 + 1u) % 4u);
                                                if (_e585 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e590 = global_4.member[_e533.member_1][_e585];
                                                let _e592 = (_e590 >> bitcast<u32>(11u));
                                                let _e594 = ((_e267 + 1u) % 4u);
                                                if (_e594 < 4u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e599 = global_4.member[_e533.member_1][_e594];
                                                let _e601 = (_e599 >> bitcast<u32>(11u));
                                                let _e624 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.x - _e533.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e625 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.y - _e533.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e626 = (bitcast<f32>((bitcast<u32>((_e533.member.member_1.z - _e533.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e628 = select(_e140, _e624, (_e624 > _e140));
                                                let _e630 = select(_e140, _e625, (_e625 > _e140));
                                                let _e632 = select(_e140, _e626, (_e626 > _e140));
                                                let _e657 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e628));
                                                let _e662 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e665 = bitcast<f32>((_e657 & bitcast<u32>(_e662)));
                                                let _e666 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e630));
                                                let _e671 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                                let _e675 = bitcast<u32>((f32(bitcast<i32>((_e574 & 1023u))) * _e632));
                                                let _e680 = (bitcast<i32>((_e574 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                                let _e687 = bitcast<f32>((_e657 & bitcast<u32>(~(_e662))));
                                                let _e691 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                                let _e695 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                                let _e696 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e628));
                                                let _e701 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e704 = bitcast<f32>((_e696 & bitcast<u32>(_e701)));
                                                let _e705 = bitcast<u32>((f32(bitcast<i32>((_e592 & 1023u))) * _e630));
                                                let _e710 = (bitcast<i32>((_e592 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                                let _e714 = bitcast<u32>((f32(bitcast<i32>((_e601 & 1023u))) * _e632));
                                                let _e719 = (bitcast<i32>((_e601 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e722 = bitcast<f32>((_e714 & bitcast<u32>(_e719)));
                                                let _e726 = bitcast<f32>((_e696 & bitcast<u32>(~(_e701))));
                                                let _e730 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                                let _e734 = bitcast<f32>((_e714 & bitcast<u32>(~(_e719))));
                                                let _e764 = global_4.member[_e533.member_1][0u];
                                                let _e768 = global_4.member[_e533.member_1][1u];
                                                let _e772 = global_4.member[_e533.member_1][2u];
                                                let _e776 = global_4.member[_e533.member_1][3u];
                                                let _e788 = (((_e768 >> bitcast<u32>(22i)) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e776 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e789 = (_e764 & 268435455u);
                                                let _e790 = (_e788 & 268435455u);
                                                let _e793 = ((_e764 >> bitcast<u32>(28u)) & 7u);
                                                let _e801 = ((_e764 >> bitcast<u32>(31i)) | (((_e788 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e802 = (_e793 != 0u);
                                                if (_e793 == 0u) {
                                                    phi_2603_ = _e789;
                                                } else {
                                                    if (_e793 == 7u) {
                                                        phi_2602_ = 2147483648u;
                                                    } else {
                                                        phi_2602_ = ((2147483648u | (_e793 << bitcast<u32>(28u))) | (_e790 & 268435455u));
                                                    }
                                                    let _e811 = phi_2602_;
                                                    phi_2603_ = _e811;
                                                }
                                                let _e813 = phi_2603_;
                                                if _e802 {
                                                    let _e814 = (_e793 != 7u);
                                                    if _e814 {
                                                        phi_2613_ = (_e790 + _e793);
                                                    } else {
                                                        phi_2613_ = u32();
                                                    }
                                                    let _e817 = phi_2613_;
                                                    phi_2615_ = _e817;
                                                    phi_2616_ = select(true, false, _e814);
                                                } else {
                                                    phi_2615_ = u32();
                                                    phi_2616_ = true;
                                                }
                                                let _e820 = phi_2615_;
                                                let _e822 = phi_2616_;
                                                if (_e801 == 0u) {
                                                    phi_2637_ = (_e789 + select(0u, 1u, !(_e802)));
                                                } else {
                                                    if (_e801 == 7u) {
                                                        phi_2636_ = 2147483648u;
                                                    } else {
                                                        phi_2636_ = ((2147483648u | (_e801 << bitcast<u32>(28u))) | (select(_e820, _e790, _e822) & 268435455u));
                                                    }
                                                    let _e835 = phi_2636_;
                                                    phi_2637_ = _e835;
                                                }
                                                let _e837 = phi_2637_;
                                                phi_2641_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e533.member.member.x + _e665), (_e533.member.member.x + _e687), (_e533.member.member_1.x - _e704), (_e533.member.member_1.x - _e726)), vec4<f32>((_e533.member.member.y + _e674), (_e533.member.member.y + _e691), (_e533.member.member_1.y - _e713), (_e533.member.member_1.y - _e730)), vec4<f32>((_e533.member.member.z + _e683), (_e533.member.member.z + _e695), (_e533.member.member_1.z - _e722), (_e533.member.member_1.z - _e734))), type_53(type_38((_e533.member.member + vec4<f32>(_e665, _e674, _e683, 0f)), (_e533.member.member_1 - vec4<f32>(_e704, _e713, _e722, 0f))), _e813), type_53(type_38((_e533.member.member + vec4<f32>(_e687, _e691, _e695, 0f)), (_e533.member.member_1 - vec4<f32>(_e726, _e730, _e734, 0f))), _e837));
                                            }
                                            let _e842 = phi_2641_;
                                            let _e855 = ((_e842.member[0].x - _e321) * _e326);
                                            let _e856 = ((_e842.member[0].y - _e321) * _e326);
                                            let _e857 = ((_e842.member[0].z - _e322) * _e326);
                                            let _e858 = ((_e842.member[0].w - _e322) * _e326);
                                            let _e868 = ((_e842.member[1].x - _e357) * _e362);
                                            let _e869 = ((_e842.member[1].y - _e357) * _e362);
                                            let _e870 = ((_e842.member[1].z - _e358) * _e362);
                                            let _e871 = ((_e842.member[1].w - _e358) * _e362);
                                            let _e881 = ((_e842.member[2].x - _e393) * _e398);
                                            let _e882 = ((_e842.member[2].y - _e393) * _e398);
                                            let _e883 = ((_e842.member[2].z - _e394) * _e398);
                                            let _e884 = ((_e842.member[2].w - _e394) * _e398);
                                            let _e886 = select(_e883, _e881, (_e881 < _e883));
                                            let _e888 = select(_e884, _e882, (_e882 < _e884));
                                            let _e890 = select(_e883, _e881, (_e881 > _e883));
                                            let _e892 = select(_e884, _e882, (_e882 > _e884));
                                            let _e894 = select(_e857, _e855, (_e855 < _e857));
                                            let _e896 = select(_e858, _e856, (_e856 < _e858));
                                            let _e898 = select(_e870, _e868, (_e868 < _e870));
                                            let _e900 = select(_e871, _e869, (_e869 < _e871));
                                            let _e902 = select(_e898, _e894, (_e894 > _e898));
                                            let _e904 = select(_e900, _e896, (_e896 > _e900));
                                            let _e906 = select(_e886, _e902, (_e902 > _e886));
                                            let _e908 = select(_e888, _e904, (_e904 > _e888));
                                            let _e910 = select(_e857, _e855, (_e855 > _e857));
                                            let _e912 = select(_e858, _e856, (_e856 > _e858));
                                            let _e914 = select(_e870, _e868, (_e868 > _e870));
                                            let _e916 = select(_e871, _e869, (_e869 > _e871));
                                            let _e918 = select(_e914, _e910, (_e910 < _e914));
                                            let _e920 = select(_e916, _e912, (_e912 < _e916));
                                            let _e925 = -(_e886);
                                            let _e926 = -(_e888);
                                            let _e933 = (select(_e890, _e918, (_e918 < _e890)) + (select(_e925, _e890, (_e890 > _e925)) * 0.0000019073523f));
                                            let _e934 = (select(_e892, _e920, (_e920 < _e892)) + (select(_e926, _e892, (_e892 > _e926)) * 0.0000019073523f));
                                            let _e936 = select(_e444, _e906, (_e906 > _e444));
                                            let _e938 = select(_e444, _e908, (_e908 > _e444));
                                            let _e943 = (_e936 <= select(_e493.member.member_1, _e933, (_e933 < _e493.member.member_1)));
                                            let _e944 = (_e938 <= select(_e493.member.member_1, _e934, (_e934 < _e493.member.member_1)));
                                            let _e945 = (_e936 <= _e938);
                                            if _e943 {
                                                if _e944 {
                                                    if _e945 {
                                                        phi_2985_ = _e842.member_2;
                                                    } else {
                                                        phi_2985_ = _e842.member_1;
                                                    }
                                                    let _e949 = phi_2985_;
                                                    let _e971 = (_e537 % 128u);
                                                    let _e972 = (_e971 < 128u);
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_8[_e971] = _e949.member_1;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_7[_e971] = _e949.member.member.x;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_6[_e971] = _e949.member.member.y;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_5[_e971] = _e949.member.member.z;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_4[_e971] = _e949.member.member_1.x;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_3[_e971] = _e949.member.member_1.y;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_2[_e971] = _e949.member.member_1.z;
                                                    if _e972 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_9[_e971] = select(_e938, _e936, (_e936 > _e938));
                                                    if _e945 {
                                                        phi_3062_ = _e842.member_1;
                                                    } else {
                                                        phi_3062_ = _e842.member_2;
                                                    }
                                                    let _e985 = phi_3062_;
                                                    phi_3063_ = _e985;
                                                    phi_3064_ = (_e537 + 1u);
                                                } else {
                                                    phi_3063_ = type_53();
                                                    phi_3064_ = u32();
                                                }
                                                let _e987 = phi_3063_;
                                                let _e989 = phi_3064_;
                                                phi_3066_ = _e987;
                                                phi_3067_ = _e989;
                                                phi_3068_ = select(true, false, _e944);
                                            } else {
                                                phi_3066_ = type_53();
                                                phi_3067_ = u32();
                                                phi_3068_ = true;
                                            }
                                            let _e992 = phi_3066_;
                                            let _e994 = phi_3067_;
                                            let _e996 = phi_3068_;
                                            if _e996 {
                                                if _e943 {
                                                    phi_3077_ = _e842.member_1;
                                                } else {
                                                    phi_3077_ = _e842.member_2;
                                                }
                                                let _e1000 = phi_3077_;
                                                phi_3082_ = _e1000;
                                                phi_3083_ = select(_e944, true, _e943);
                                            } else {
                                                phi_3082_ = _e992;
                                                phi_3083_ = _e535;
                                            }
                                            let _e1003 = phi_3082_;
                                            let _e1005 = phi_3083_;
                                            phi_3580_ = _e491;
                                            phi_3085_ = type_46(_e493.member, (_e493.member_1 + 1u), _e493.member_2);
                                            phi_3086_ = _e1003;
                                            phi_3087_ = _e1005;
                                            phi_3088_ = select(_e994, _e537, _e996);
                                        }
                                        let _e1429 = phi_3580_;
                                        let _e1431 = phi_3085_;
                                        let _e1433 = phi_3086_;
                                        let _e1435 = phi_3087_;
                                        let _e1437 = phi_3088_;
                                        phi_3579_ = _e1429;
                                        phi_3089_ = _e1431;
                                        phi_3090_ = _e1433;
                                        phi_3091_ = (_e497 - 1u);
                                        phi_3092_ = _e1435;
                                        phi_3093_ = _e1437;
                                    } else {
                                        phi_3579_ = _e491;
                                        phi_3089_ = _e493;
                                        phi_3090_ = _e533;
                                        phi_3091_ = _e497;
                                        phi_3092_ = _e535;
                                        phi_3093_ = _e537;
                                    }
                                    let _e1439 = phi_3579_;
                                    let _e1441 = phi_3089_;
                                    let _e1443 = phi_3090_;
                                    let _e1445 = phi_3091_;
                                    let _e1447 = phi_3092_;
                                    let _e1449 = phi_3093_;
                                    phi_3578_ = _e1439;
                                    phi_3094_ = _e1441;
                                    phi_3095_ = _e1443;
                                    phi_3096_ = _e1445;
                                    phi_3097_ = _e1447;
                                    phi_3098_ = _e1449;
                                } else {
                                    phi_3578_ = _e491;
                                    phi_3094_ = type_46();
                                    phi_3095_ = type_53();
                                    phi_3096_ = u32();
                                    phi_3097_ = bool();
                                    phi_3098_ = u32();
                                }
                                let _e1451 = phi_3578_;
                                let _e1453 = phi_3094_;
                                let _e1455 = phi_3095_;
                                let _e1457 = phi_3096_;
                                let _e1459 = phi_3097_;
                                let _e1461 = phi_3098_;
                                phi_3577_ = _e1451;
                                phi_860_ = _e1453;
                                phi_863_ = _e1455;
                                phi_865_ = _e1457;
                                phi_867_ = _e1459;
                                phi_869_ = _e1461;
                                phi_3099_ = _e505;
                            } else {
                                phi_3577_ = _e491;
                                phi_860_ = type_46();
                                phi_863_ = type_53();
                                phi_865_ = u32();
                                phi_867_ = bool();
                                phi_869_ = u32();
                                phi_3099_ = false;
                            }
                            let _e1463 = phi_3577_;
                            let _e1465 = phi_860_;
                            let _e1467 = phi_863_;
                            let _e1469 = phi_865_;
                            let _e1471 = phi_867_;
                            let _e1473 = phi_869_;
                            let _e1475 = phi_3099_;
                            continue;
                            continuing {
                                phi_3468_ = _e1463;
                                phi_859_ = _e1465;
                                phi_862_ = _e1467;
                                phi_864_ = _e1469;
                                phi_866_ = _e1471;
                                phi_868_ = _e1473;
                                phi_3576_ = _e1463;
                                break if !(_e1475);
                            }
                        }
                        let _e1478 = phi_3576_;
                        if _e1478 {
                            break;
                        }
                        let _e1480 = local_10;
                        if (_e1480.member.member.member_3 != 4294967295u) {
                            let _e1486 = (_e268 / 3i);
                            let _e1493 = bitcast<f32>((bitcast<u32>((_e1486 + 127i)) << bitcast<u32>(23i)));
                            let _e1501 = (((_e1480.member.member.member * _e1493) * _e1493) * bitcast<f32>((bitcast<u32>(((_e268 - (2i * _e1486)) + 127i)) << bitcast<u32>(23i))));
                            let _e1503 = select(340282350000000000000000000000000000000f, _e1501, (_e1501 < 340282350000000000000000000000000000000f));
                            phi_3151_ = type_26(select(-340282350000000000000000000000000000000f, _e1503, (_e1503 > -340282350000000000000000000000000000000f)), _e1480.member.member.member_1, _e1480.member.member.member_2, _e1480.member.member.member_3);
                        } else {
                            phi_3151_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1510 = phi_3151_;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_2.member[_e128] = _e1510;
                        let _e1514 = local_11;
                        if _e145 {
                        } else {
                            break;
                        }
                        global_6.member[_e128] = _e1514.member_1;
                        if _e143 {
                        } else {
                            break;
                        }
                        let _e1519 = select(0u, 1u, (_e212 <= _e222));
                        if (_e1519 > 0u) {
                            let _e1521 = (1u < _e96);
                            if _e1521 {
                                if (0u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1525 = atomicAdd((&global_7.member[0u]), _e1519);
                                if ((_e1525 + _e1519) < _e1525) {
                                    if _e1521 {
                                    } else {
                                        break;
                                    }
                                    let _e1530 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1533 = select(0u, 1u, (_e1510.member_3 != 4294967295u));
                        if (_e1533 > 0u) {
                            let _e1535 = (3u < _e96);
                            if _e1535 {
                                if (2u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1539 = atomicAdd((&global_7.member[2u]), _e1533);
                                if ((_e1539 + _e1533) < _e1539) {
                                    if _e1535 {
                                    } else {
                                        break;
                                    }
                                    let _e1544 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1514.member_1 > 0u) {
                            let _e1546 = (5u < _e96);
                            if _e1546 {
                                if (4u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1550 = atomicAdd((&global_7.member[4u]), _e1514.member_1);
                                if ((_e1550 + _e1514.member_1) < _e1550) {
                                    if _e1546 {
                                    } else {
                                        break;
                                    }
                                    let _e1555 = atomicAdd((&global_7.member[5u]), 1u);
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
