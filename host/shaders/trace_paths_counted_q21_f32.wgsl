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

struct type_51 {
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
var<storage> global_7: type_51;

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
    var phi_859_: type_42;
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
    var phi_985_: type_42;
    var phi_988_: type_7;
    var phi_989_: type_7;
    var phi_1011_: type_7;
    var phi_1035_: u32;
    var phi_1124_: array<array<f32, 3>, 3>;
    var phi_1595_: vec3<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1627_: bool;
    var phi_1636_: vec3<f32>;
    var phi_1676_: type_22;
    var phi_1678_: type_22;
    var phi_1679_: bool;
    var phi_1683_: type_22;
    var phi_1684_: type_22;
    var phi_1685_: type_22;
    var phi_1686_: bool;
    var phi_1690_: type_22;
    var phi_1691_: bool;
    var phi_1695_: type_22;
    var phi_1696_: bool;
    var phi_1700_: type_22;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1733_: type_42;
    var phi_1734_: type_42;
    var phi_1735_: type_42;
    var phi_986_: type_42;
    var phi_3462_: bool;
    var phi_3580_: bool;
    var phi_3085_: type_42;
    var phi_3086_: type_53;
    var phi_3087_: bool;
    var phi_3088_: u32;
    var phi_3579_: bool;
    var phi_3089_: type_42;
    var phi_3090_: type_53;
    var phi_3091_: u32;
    var phi_3092_: bool;
    var phi_3093_: u32;
    var phi_3578_: bool;
    var phi_3094_: type_42;
    var phi_3095_: type_53;
    var phi_3096_: u32;
    var phi_3097_: bool;
    var phi_3098_: u32;
    var phi_3577_: bool;
    var phi_860_: type_42;
    var phi_863_: type_53;
    var phi_865_: u32;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_3099_: bool;
    var phi_3576_: bool;
    var local_10: type_42;
    var phi_3151_: type_22;
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
                                phi_391_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_391_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                            }
                            let _e244 = phi_391_;
                            phi_392_ = _e244;
                        } else {
                            phi_392_ = 0i;
                        }
                        let _e246 = phi_392_;
                        let _e247 = (_e156 == _e200);
                        if _e247 {
                            phi_402_ = true;
                        } else {
                            phi_402_ = (_e164 == _e200);
                        }
                        let _e250 = phi_402_;
                        let _e251 = select(1u, 0u, _e247);
                        if _e250 {
                            let _e252 = (_e251 + 1u);
                            phi_412_ = _e252;
                            phi_413_ = _e252;
                            phi_415_ = select(true, false, (_e252 == 2u));
                        } else {
                            phi_412_ = u32();
                            phi_413_ = 0u;
                            phi_415_ = true;
                        }
                        let _e256 = phi_412_;
                        let _e258 = phi_413_;
                        let _e260 = phi_415_;
                        if _e260 {
                            phi_420_ = (_e258 + 1u);
                        } else {
                            phi_420_ = 0u;
                        }
                        let _e264 = phi_420_;
                        let _e265 = select(_e256, _e258, _e260);
                        let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                        let _e267 = -(_e246);
                        if (_e267 < -126i) {
                            phi_453_ = -126i;
                        } else {
                            phi_453_ = select(_e267, 127i, (_e267 > 127i));
                        }
                        let _e272 = phi_453_;
                        let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                        let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                        let _e288 = global_4.member[_e127].member.member;
                        let _e289 = (_e265 == 0u);
                        if _e289 {
                            phi_471_ = _e288[0];
                        } else {
                            phi_471_ = _e288[1];
                        }
                        let _e293 = phi_471_;
                        let _e294 = (_e265 == 2u);
                        if _e294 {
                            phi_477_ = _e288[2];
                        } else {
                            phi_477_ = _e293;
                        }
                        let _e297 = phi_477_;
                        let _e298 = global_4.member[_e127].member.member_2;
                        if _e289 {
                            phi_488_ = _e298[0];
                        } else {
                            phi_488_ = _e298[1];
                        }
                        let _e302 = phi_488_;
                        if _e294 {
                            phi_494_ = _e298[2];
                        } else {
                            phi_494_ = _e302;
                        }
                        let _e305 = phi_494_;
                        let _e307 = ((_e305 * _e277) * _e283);
                        let _e311 = (bitcast<f32>((bitcast<u32>(_e307) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e311 {
                            let _e315 = (bitcast<f32>((bitcast<u32>(_e297) & 2147483647u)) * 0.00000011920929f);
                            phi_517_ = select(0.00000000000011368684f, _e315, (_e315 > 0.00000000000011368684f));
                        } else {
                            phi_517_ = 0f;
                        }
                        let _e319 = phi_517_;
                        let _e320 = (_e297 + _e319);
                        let _e321 = (_e297 - _e319);
                        let _e322 = select(_e307, 0f, _e311);
                        if _e311 {
                            phi_528_ = 38685626000000000000000000f;
                        } else {
                            phi_528_ = (1f / _e307);
                        }
                        let _e325 = phi_528_;
                        let _e326 = (_e264 == 0u);
                        if _e326 {
                            phi_537_ = _e288[0];
                        } else {
                            phi_537_ = _e288[1];
                        }
                        let _e330 = phi_537_;
                        let _e331 = (_e264 == 2u);
                        if _e331 {
                            phi_543_ = _e288[2];
                        } else {
                            phi_543_ = _e330;
                        }
                        let _e334 = phi_543_;
                        if _e326 {
                            phi_554_ = _e298[0];
                        } else {
                            phi_554_ = _e298[1];
                        }
                        let _e338 = phi_554_;
                        if _e331 {
                            phi_560_ = _e298[2];
                        } else {
                            phi_560_ = _e338;
                        }
                        let _e341 = phi_560_;
                        let _e343 = ((_e341 * _e277) * _e283);
                        let _e347 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e347 {
                            let _e351 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) * 0.00000011920929f);
                            phi_583_ = select(0.00000000000011368684f, _e351, (_e351 > 0.00000000000011368684f));
                        } else {
                            phi_583_ = 0f;
                        }
                        let _e355 = phi_583_;
                        let _e356 = (_e334 + _e355);
                        let _e357 = (_e334 - _e355);
                        let _e358 = select(_e343, 0f, _e347);
                        if _e347 {
                            phi_594_ = 38685626000000000000000000f;
                        } else {
                            phi_594_ = (1f / _e343);
                        }
                        let _e361 = phi_594_;
                        let _e362 = (_e266 == 0u);
                        if _e362 {
                            phi_603_ = _e288[0];
                        } else {
                            phi_603_ = _e288[1];
                        }
                        let _e366 = phi_603_;
                        let _e367 = (_e266 == 2u);
                        if _e367 {
                            phi_609_ = _e288[2];
                        } else {
                            phi_609_ = _e366;
                        }
                        let _e370 = phi_609_;
                        if _e362 {
                            phi_620_ = _e298[0];
                        } else {
                            phi_620_ = _e298[1];
                        }
                        let _e374 = phi_620_;
                        if _e367 {
                            phi_626_ = _e298[2];
                        } else {
                            phi_626_ = _e374;
                        }
                        let _e377 = phi_626_;
                        let _e379 = ((_e377 * _e277) * _e283);
                        let _e383 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e383 {
                            let _e387 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                            phi_649_ = select(0.00000000000011368684f, _e387, (_e387 > 0.00000000000011368684f));
                        } else {
                            phi_649_ = 0f;
                        }
                        let _e391 = phi_649_;
                        let _e392 = (_e370 + _e391);
                        let _e393 = (_e370 - _e391);
                        let _e394 = select(_e379, 0f, _e383);
                        if _e383 {
                            phi_660_ = 38685626000000000000000000f;
                        } else {
                            phi_660_ = (1f / _e379);
                        }
                        let _e397 = phi_660_;
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
                            phi_760_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                            phi_761_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_760_ = 0f;
                            phi_761_ = 1f;
                        }
                        let _e441 = phi_760_;
                        let _e443 = phi_761_;
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
                        phi_3468_ = false;
                        phi_859_ = type_42(type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e441), 0u, 0u);
                        phi_862_ = type_53(type_34(vec4<f32>((f32(_e455) * _e139), (f32(_e461) * _e139), (f32(_e467) * _e139), 0f), vec4<f32>((f32(_e472) * _e139), (f32(_e476) * _e139), (f32(_e480) * _e139), 0f)), select(0u, 2147483648u, (_e85 == 0u)));
                        phi_864_ = ((3u * _e85) + 1u);
                        phi_866_ = (_e443 <= _e441);
                        phi_868_ = 0u;
                        loop {
                            let _e490 = phi_3468_;
                            let _e492 = phi_859_;
                            let _e494 = phi_862_;
                            let _e496 = phi_864_;
                            let _e498 = phi_866_;
                            let _e500 = phi_868_;
                            local_10 = _e492;
                            local_11 = _e492;
                            if _e498 {
                                phi_879_ = true;
                            } else {
                                phi_879_ = (_e500 > 0u);
                            }
                            let _e503 = phi_879_;
                            if _e503 {
                                let _e504 = (_e496 > 0u);
                                if _e504 {
                                    if _e498 {
                                        phi_965_ = _e494;
                                        phi_966_ = _e498;
                                        phi_967_ = _e500;
                                    } else {
                                        let _e505 = (_e500 - 1u);
                                        let _e506 = (_e505 % 128u);
                                        let _e507 = (_e506 < 128u);
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e509 = local_7[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e511 = local_6[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e513 = local_5[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e515 = local_4[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e517 = local_3[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e519 = local_2[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e524 = local_8[_e506];
                                        if _e507 {
                                        } else {
                                            phi_3576_ = true;
                                            break;
                                        }
                                        let _e527 = local_9[_e506];
                                        phi_965_ = type_53(type_34(vec4<f32>(_e509, _e511, _e513, 0f), vec4<f32>(_e515, _e517, _e519, 0f)), _e524);
                                        phi_966_ = (_e527 <= _e492.member.member_1);
                                        phi_967_ = _e505;
                                    }
                                    let _e532 = phi_965_;
                                    let _e534 = phi_966_;
                                    let _e536 = phi_967_;
                                    if _e534 {
                                        if ((_e532.member_1 & 2147483648u) != 0u) {
                                            phi_985_ = _e492;
                                            phi_988_ = type_7(0u, ((_e532.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1008 = phi_985_;
                                                let _e1010 = phi_988_;
                                                local_12 = _e1008;
                                                if (_e1010.member < _e1010.member_1) {
                                                    phi_989_ = type_7((_e1010.member + 1u), _e1010.member_1);
                                                    phi_1011_ = type_7(1u, _e1010.member);
                                                } else {
                                                    phi_989_ = _e1010;
                                                    phi_1011_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1023 = phi_989_;
                                                let _e1025 = phi_1011_;
                                                let _e1029 = (bitcast<i32>(_e1025.member) != 0i);
                                                if _e1029 {
                                                    let _e1035 = type_42(_e1008.member, _e1008.member_1, (_e1008.member_2 + 1u));
                                                    let _e1036 = ((_e532.member_1 & 268435455u) + _e1025.member_1);
                                                    let _e1037 = (_e1036 < _e87);
                                                    if _e1037 {
                                                        if _e1037 {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1041 = global_1.member[_e1036].member_1;
                                                        phi_1035_ = _e1041;
                                                    } else {
                                                        phi_1035_ = 4294967295u;
                                                    }
                                                    let _e1043 = phi_1035_;
                                                    if (_e1036 >= _e87) {
                                                        phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1037 {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        if (_e452 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1050 = global_1.member[_e1036].member[_e452];
                                                        if (_e458 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1056 = global_1.member[_e1036].member[_e458];
                                                        if (_e464 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1062 = global_1.member[_e1036].member[_e464];
                                                        let _e1064 = (3u + _e452);
                                                        if (_e1064 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1070 = global_1.member[_e1036].member[_e1064];
                                                        let _e1071 = (3u + _e458);
                                                        if (_e1071 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1077 = global_1.member[_e1036].member[_e1071];
                                                        let _e1078 = (3u + _e464);
                                                        if (_e1078 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1084 = global_1.member[_e1036].member[_e1078];
                                                        let _e1086 = (6u + _e452);
                                                        if (_e1086 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1092 = global_1.member[_e1036].member[_e1086];
                                                        let _e1093 = (6u + _e458);
                                                        if (_e1093 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1099 = global_1.member[_e1036].member[_e1093];
                                                        let _e1100 = (6u + _e464);
                                                        if (_e1100 < 9u) {
                                                        } else {
                                                            phi_3462_ = true;
                                                            break;
                                                        }
                                                        let _e1106 = global_1.member[_e1036].member[_e1100];
                                                        phi_1124_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1050, _e1056, _e1062), array<f32, 3>(_e1070, _e1077, _e1084), array<f32, 3>(_e1092, _e1099, _e1106));
                                                    }
                                                    let _e1110 = phi_1124_;
                                                    let _e1119 = (_e1110[0][2] - _e370);
                                                    let _e1122 = (((_e1110[0][0] - _e297) * _e394) - (_e1119 * _e322));
                                                    let _e1125 = (((_e1110[0][1] - _e334) * _e394) - (_e1119 * _e358));
                                                    let _e1132 = (_e1110[1][2] - _e370);
                                                    let _e1135 = (((_e1110[1][0] - _e297) * _e394) - (_e1132 * _e322));
                                                    let _e1138 = (((_e1110[1][1] - _e334) * _e394) - (_e1132 * _e358));
                                                    let _e1145 = (_e1110[2][2] - _e370);
                                                    let _e1148 = (((_e1110[2][0] - _e297) * _e394) - (_e1145 * _e322));
                                                    let _e1151 = (((_e1110[2][1] - _e334) * _e394) - (_e1145 * _e358));
                                                    let _e1152 = (_e1148 * _e1138);
                                                    let _e1153 = (_e1151 * _e1135);
                                                    let _e1154 = (_e1122 * _e1151);
                                                    let _e1155 = (_e1125 * _e1148);
                                                    let _e1156 = (_e1135 * _e1125);
                                                    let _e1157 = (_e1138 * _e1122);
                                                    let _e1162 = (((_e1152 >= _e1153) && (_e1154 >= _e1155)) && (_e1156 >= _e1157));
                                                    if (_e1162 || (((_e1152 <= _e1153) && (_e1154 <= _e1155)) && (_e1156 <= _e1157))) {
                                                        let _e1169 = select(-1f, 1f, _e1162);
                                                        let _e1171 = ((_e1152 - _e1153) * _e1169);
                                                        let _e1173 = select(0f, _e1171, (_e1171 > 0f));
                                                        let _e1175 = ((_e1154 - _e1155) * _e1169);
                                                        let _e1177 = select(0f, _e1175, (_e1175 > 0f));
                                                        let _e1179 = ((_e1156 - _e1157) * _e1169);
                                                        let _e1181 = select(0f, _e1179, (_e1179 > 0f));
                                                        let _e1183 = ((_e1173 + _e1177) + _e1181);
                                                        if (_e1183 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1690_ = type_22();
                                                            phi_1691_ = true;
                                                        } else {
                                                            let _e1186 = select(_e1110[1][0], _e1110[0][0], (_e1110[0][0] < _e1110[1][0]));
                                                            let _e1190 = select(_e1110[1][0], _e1110[0][0], (_e1110[0][0] > _e1110[1][0]));
                                                            let _e1194 = select(_e1110[1][1], _e1110[0][1], (_e1110[0][1] < _e1110[1][1]));
                                                            let _e1198 = select(_e1110[1][1], _e1110[0][1], (_e1110[0][1] > _e1110[1][1]));
                                                            let _e1202 = select(_e1110[1][2], _e1110[0][2], (_e1110[0][2] < _e1110[1][2]));
                                                            let _e1206 = select(_e1110[1][2], _e1110[0][2], (_e1110[0][2] > _e1110[1][2]));
                                                            let _e1211 = ((select(_e1110[2][0], _e1186, (_e1186 < _e1110[2][0])) - _e320) * _e325);
                                                            let _e1212 = ((select(_e1110[2][0], _e1190, (_e1190 > _e1110[2][0])) - _e321) * _e325);
                                                            let _e1215 = ((select(_e1110[2][1], _e1194, (_e1194 < _e1110[2][1])) - _e356) * _e361);
                                                            let _e1216 = ((select(_e1110[2][1], _e1198, (_e1198 > _e1110[2][1])) - _e357) * _e361);
                                                            let _e1219 = ((select(_e1110[2][2], _e1202, (_e1202 < _e1110[2][2])) - _e392) * _e397);
                                                            let _e1220 = ((select(_e1110[2][2], _e1206, (_e1206 > _e1110[2][2])) - _e393) * _e397);
                                                            let _e1222 = select(_e1220, _e1219, (_e1219 < _e1220));
                                                            let _e1224 = select(_e1220, _e1219, (_e1219 > _e1220));
                                                            let _e1226 = select(_e1212, _e1211, (_e1211 < _e1212));
                                                            let _e1228 = select(_e1216, _e1215, (_e1215 < _e1216));
                                                            let _e1230 = select(_e1228, _e1226, (_e1226 > _e1228));
                                                            let _e1232 = select(_e1222, _e1230, (_e1230 > _e1222));
                                                            let _e1234 = select(_e1212, _e1211, (_e1211 > _e1212));
                                                            let _e1236 = select(_e1216, _e1215, (_e1215 > _e1216));
                                                            let _e1238 = select(_e1236, _e1234, (_e1234 < _e1236));
                                                            let _e1240 = select(_e1224, _e1238, (_e1238 < _e1224));
                                                            let _e1241 = -(_e1222);
                                                            let _e1247 = select(_e443, _e1232, (_e1232 > _e443));
                                                            if (_e1247 > (_e1240 + (select(_e1241, _e1224, (_e1224 > _e1241)) * 0.0000019073523f))) {
                                                                phi_1685_ = type_22();
                                                                phi_1686_ = true;
                                                            } else {
                                                                let _e1249 = (_e1247 > _e1008.member.member_1);
                                                                if _e1249 {
                                                                    phi_1684_ = type_22();
                                                                } else {
                                                                    let _e1253 = (_e1110[1][0] - _e1110[0][0]);
                                                                    let _e1254 = (_e1110[1][1] - _e1110[0][1]);
                                                                    let _e1255 = (_e1110[1][2] - _e1110[0][2]);
                                                                    let _e1256 = vec3<f32>(_e1253, _e1254, _e1255);
                                                                    let _e1257 = (_e1110[2][0] - _e1110[1][0]);
                                                                    let _e1258 = (_e1110[2][1] - _e1110[1][1]);
                                                                    let _e1259 = (_e1110[2][2] - _e1110[1][2]);
                                                                    let _e1260 = vec3<f32>(_e1257, _e1258, _e1259);
                                                                    let _e1261 = (_e1110[0][0] - _e1110[2][0]);
                                                                    let _e1262 = (_e1110[0][1] - _e1110[2][1]);
                                                                    let _e1263 = (_e1110[0][2] - _e1110[2][2]);
                                                                    let _e1264 = vec3<f32>(_e1261, _e1262, _e1263);
                                                                    let _e1267 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                    let _e1270 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                    let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                                    let _e1275 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                    let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                                                                    let _e1280 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                                    let _e1283 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                    let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                    let _e1288 = bitcast<f32>((bitcast<u32>(_e1259) & 2147483647u));
                                                                    let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                    let _e1293 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                    let _e1296 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                    let _e1298 = select(_e1296, _e1293, (_e1293 > _e1296));
                                                                    let _e1301 = bitcast<f32>((bitcast<u32>(_e1263) & 2147483647u));
                                                                    let _e1303 = select(_e1301, _e1298, (_e1298 > _e1301));
                                                                    let _e1305 = select(_e1290, _e1277, (_e1277 > _e1290));
                                                                    let _e1307 = select(_e1303, _e1305, (_e1305 > _e1303));
                                                                    if (_e1277 == _e1307) {
                                                                        phi_1595_ = _e1260;
                                                                        phi_1596_ = _e1264;
                                                                    } else {
                                                                        let _e1310 = vec3((_e1290 == _e1307));
                                                                        phi_1595_ = select(_e1256, _e1264, _e1310);
                                                                        phi_1596_ = select(_e1260, _e1256, _e1310);
                                                                    }
                                                                    let _e1314 = phi_1595_;
                                                                    let _e1316 = phi_1596_;
                                                                    let _e1323 = ((_e1314.y * _e1316.z) - (_e1316.y * _e1314.z));
                                                                    let _e1328 = ((_e1314.z * _e1316.x) - (_e1316.z * _e1314.x));
                                                                    let _e1331 = ((_e1314.x * _e1316.y) - (_e1316.x * _e1314.y));
                                                                    if (_e1173 >= _e1177) {
                                                                        phi_1627_ = select(true, false, (_e1173 >= _e1181));
                                                                    } else {
                                                                        phi_1627_ = true;
                                                                    }
                                                                    let _e1336 = phi_1627_;
                                                                    if _e1336 {
                                                                        phi_1636_ = select(vec3<f32>(_e1110[2][0], _e1110[2][1], _e1110[2][2]), vec3<f32>(_e1110[1][0], _e1110[1][1], _e1110[1][2]), vec3((_e1177 >= _e1181)));
                                                                    } else {
                                                                        phi_1636_ = vec3<f32>(_e1110[0][0], _e1110[0][1], _e1110[0][2]);
                                                                    }
                                                                    let _e1341 = phi_1636_;
                                                                    let _e1358 = ((((_e1323 * (_e1341.x - _e297)) + (_e1328 * (_e1341.y - _e334))) + (_e1331 * (_e1341.z - _e370))) / (((_e1323 * _e322) + (_e1328 * _e358)) + (_e1331 * _e394)));
                                                                    let _e1360 = select(_e1240, _e1358, (_e1358 < _e1240));
                                                                    let _e1362 = select(_e1232, _e1360, (_e1360 > _e1232));
                                                                    if (_e1362 >= _e443) {
                                                                        let _e1364 = (_e1362 <= _e1008.member.member_1);
                                                                        if _e1364 {
                                                                            let _e1365 = (1f / _e1183);
                                                                            phi_1676_ = type_22(_e1362, (_e1177 * _e1365), (_e1181 * _e1365), _e1043);
                                                                        } else {
                                                                            phi_1676_ = type_22();
                                                                        }
                                                                        let _e1370 = phi_1676_;
                                                                        phi_1678_ = _e1370;
                                                                        phi_1679_ = select(true, false, _e1364);
                                                                    } else {
                                                                        phi_1678_ = type_22();
                                                                        phi_1679_ = true;
                                                                    }
                                                                    let _e1373 = phi_1678_;
                                                                    let _e1375 = phi_1679_;
                                                                    if _e1375 {
                                                                        phi_1683_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1683_ = _e1373;
                                                                    }
                                                                    let _e1377 = phi_1683_;
                                                                    phi_1684_ = _e1377;
                                                                }
                                                                let _e1379 = phi_1684_;
                                                                phi_1685_ = _e1379;
                                                                phi_1686_ = _e1249;
                                                            }
                                                            let _e1381 = phi_1685_;
                                                            let _e1383 = phi_1686_;
                                                            phi_1690_ = _e1381;
                                                            phi_1691_ = _e1383;
                                                        }
                                                        let _e1385 = phi_1690_;
                                                        let _e1387 = phi_1691_;
                                                        phi_1695_ = _e1385;
                                                        phi_1696_ = _e1387;
                                                    } else {
                                                        phi_1695_ = type_22();
                                                        phi_1696_ = true;
                                                    }
                                                    let _e1389 = phi_1695_;
                                                    let _e1391 = phi_1696_;
                                                    if _e1391 {
                                                        phi_1700_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1700_ = _e1389;
                                                    }
                                                    let _e1393 = phi_1700_;
                                                    if (_e1393.member_3 != 4294967295u) {
                                                        if (_e1043 != _e449) {
                                                            if (_e1393.member < _e1008.member.member.member) {
                                                                phi_1726_ = true;
                                                            } else {
                                                                if (_e1393.member == _e1008.member.member.member) {
                                                                    phi_1725_ = (_e1393.member_3 < _e1008.member.member.member_3);
                                                                } else {
                                                                    phi_1725_ = false;
                                                                }
                                                                let _e1408 = phi_1725_;
                                                                phi_1726_ = _e1408;
                                                            }
                                                            let _e1410 = phi_1726_;
                                                            if _e1410 {
                                                                phi_1733_ = type_42(type_38(_e1393, _e1393.member), _e1035.member_1, _e1035.member_2);
                                                            } else {
                                                                phi_1733_ = _e1035;
                                                            }
                                                            let _e1417 = phi_1733_;
                                                            phi_1734_ = _e1417;
                                                        } else {
                                                            phi_1734_ = _e1035;
                                                        }
                                                        let _e1419 = phi_1734_;
                                                        phi_1735_ = _e1419;
                                                    } else {
                                                        phi_1735_ = _e1035;
                                                    }
                                                    let _e1421 = phi_1735_;
                                                    phi_986_ = _e1421;
                                                } else {
                                                    phi_986_ = type_42();
                                                }
                                                let _e1423 = phi_986_;
                                                continue;
                                                continuing {
                                                    phi_985_ = _e1423;
                                                    phi_988_ = _e1023;
                                                    phi_3462_ = _e490;
                                                    break if !(_e1029);
                                                }
                                            }
                                            let _e1426 = phi_3462_;
                                            phi_3576_ = _e1426;
                                            if _e1426 {
                                                break;
                                            }
                                            phi_3580_ = _e1426;
                                            let _e1643 = local_12;
                                            phi_3085_ = _e1643;
                                            phi_3086_ = _e532;
                                            phi_3087_ = false;
                                            phi_3088_ = _e536;
                                        } else {
                                            if (_e532.member_1 >= _e85) {
                                                phi_2641_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e532.member_1 < _e85) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e555 = ((1u + (_e265 * 2u)) % 7u);
                                                if (_e555 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e560 = global_7.member[_e532.member_1][_e555];
                                                let _e563 = ((1u + (_e264 * 2u)) % 7u);
                                                if (_e563 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e568 = global_7.member[_e532.member_1][_e563];
                                                let _e571 = ((1u + (_e266 * 2u)) % 7u);
                                                if (_e571 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e576 = global_7.member[_e532.member_1][_e571];
                                                let _e579 = (((_e265 + 1u) * 2u) % 7u);
                                                if (_e579 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e584 = global_7.member[_e532.member_1][_e579];
                                                let _e587 = (((_e264 + 1u) * 2u) % 7u);
                                                if (_e587 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e592 = global_7.member[_e532.member_1][_e587];
                                                let _e595 = (((_e266 + 1u) * 2u) % 7u);
                                                if (_e595 < 7u) {
                                                } else {
                                                    phi_3576_ = true;
                                                    break;
                                                }
                                                let _e600 = global_7.member[_e532.member_1][_e595];
                                                let _e623 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.x - _e532.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e624 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.y - _e532.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e625 = (bitcast<f32>((bitcast<u32>((_e532.member.member_1.z - _e532.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e627 = select(_e139, _e623, (_e623 > _e139));
                                                let _e629 = select(_e139, _e624, (_e624 > _e139));
                                                let _e631 = select(_e139, _e625, (_e625 > _e139));
                                                let _e656 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e627));
                                                let _e661 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                                let _e665 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e629));
                                                let _e670 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                                let _e674 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e631));
                                                let _e679 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e682 = bitcast<f32>((_e674 & bitcast<u32>(_e679)));
                                                let _e686 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                                let _e690 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                                let _e694 = bitcast<f32>((_e674 & bitcast<u32>(~(_e679))));
                                                let _e695 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e627));
                                                let _e700 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                                let _e704 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e629));
                                                let _e709 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                                let _e713 = bitcast<u32>((f32(bitcast<i32>((_e600 & 2097151u))) * _e631));
                                                let _e718 = (bitcast<i32>((_e600 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e721 = bitcast<f32>((_e713 & bitcast<u32>(_e718)));
                                                let _e725 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                                let _e729 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                                let _e733 = bitcast<f32>((_e713 & bitcast<u32>(~(_e718))));
                                                let _e763 = global_7.member[_e532.member_1][0u];
                                                let _e767 = global_7.member[_e532.member_1][2u];
                                                let _e771 = global_7.member[_e532.member_1][4u];
                                                let _e775 = global_7.member[_e532.member_1][6u];
                                                let _e787 = (((_e767 >> bitcast<u32>(22i)) | ((_e771 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e775 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e788 = (_e763 & 268435455u);
                                                let _e789 = (_e787 & 268435455u);
                                                let _e792 = ((_e763 >> bitcast<u32>(28u)) & 7u);
                                                let _e800 = ((_e763 >> bitcast<u32>(31i)) | (((_e787 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e801 = (_e792 != 0u);
                                                if (_e792 == 0u) {
                                                    phi_2603_ = _e788;
                                                } else {
                                                    if (_e792 == 7u) {
                                                        phi_2602_ = 2147483648u;
                                                    } else {
                                                        phi_2602_ = ((2147483648u | (_e792 << bitcast<u32>(28u))) | (_e789 & 268435455u));
                                                    }
                                                    let _e810 = phi_2602_;
                                                    phi_2603_ = _e810;
                                                }
                                                let _e812 = phi_2603_;
                                                if _e801 {
                                                    let _e813 = (_e792 != 7u);
                                                    if _e813 {
                                                        phi_2613_ = (_e789 + _e792);
                                                    } else {
                                                        phi_2613_ = u32();
                                                    }
                                                    let _e816 = phi_2613_;
                                                    phi_2615_ = _e816;
                                                    phi_2616_ = select(true, false, _e813);
                                                } else {
                                                    phi_2615_ = u32();
                                                    phi_2616_ = true;
                                                }
                                                let _e819 = phi_2615_;
                                                let _e821 = phi_2616_;
                                                if (_e800 == 0u) {
                                                    phi_2637_ = (_e788 + select(0u, 1u, !(_e801)));
                                                } else {
                                                    if (_e800 == 7u) {
                                                        phi_2636_ = 2147483648u;
                                                    } else {
                                                        phi_2636_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (select(_e819, _e789, _e821) & 268435455u));
                                                    }
                                                    let _e834 = phi_2636_;
                                                    phi_2637_ = _e834;
                                                }
                                                let _e836 = phi_2637_;
                                                phi_2641_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e532.member.member.x + _e664), (_e532.member.member.x + _e686), (_e532.member.member_1.x - _e703), (_e532.member.member_1.x - _e725)), vec4<f32>((_e532.member.member.y + _e673), (_e532.member.member.y + _e690), (_e532.member.member_1.y - _e712), (_e532.member.member_1.y - _e729)), vec4<f32>((_e532.member.member.z + _e682), (_e532.member.member.z + _e694), (_e532.member.member_1.z - _e721), (_e532.member.member_1.z - _e733))), type_53(type_34((_e532.member.member + vec4<f32>(_e664, _e673, _e682, 0f)), (_e532.member.member_1 - vec4<f32>(_e703, _e712, _e721, 0f))), _e812), type_53(type_34((_e532.member.member + vec4<f32>(_e686, _e690, _e694, 0f)), (_e532.member.member_1 - vec4<f32>(_e725, _e729, _e733, 0f))), _e836));
                                            }
                                            let _e841 = phi_2641_;
                                            let _e854 = ((_e841.member[0].x - _e320) * _e325);
                                            let _e855 = ((_e841.member[0].y - _e320) * _e325);
                                            let _e856 = ((_e841.member[0].z - _e321) * _e325);
                                            let _e857 = ((_e841.member[0].w - _e321) * _e325);
                                            let _e867 = ((_e841.member[1].x - _e356) * _e361);
                                            let _e868 = ((_e841.member[1].y - _e356) * _e361);
                                            let _e869 = ((_e841.member[1].z - _e357) * _e361);
                                            let _e870 = ((_e841.member[1].w - _e357) * _e361);
                                            let _e880 = ((_e841.member[2].x - _e392) * _e397);
                                            let _e881 = ((_e841.member[2].y - _e392) * _e397);
                                            let _e882 = ((_e841.member[2].z - _e393) * _e397);
                                            let _e883 = ((_e841.member[2].w - _e393) * _e397);
                                            let _e885 = select(_e882, _e880, (_e880 < _e882));
                                            let _e887 = select(_e883, _e881, (_e881 < _e883));
                                            let _e889 = select(_e882, _e880, (_e880 > _e882));
                                            let _e891 = select(_e883, _e881, (_e881 > _e883));
                                            let _e893 = select(_e856, _e854, (_e854 < _e856));
                                            let _e895 = select(_e857, _e855, (_e855 < _e857));
                                            let _e897 = select(_e869, _e867, (_e867 < _e869));
                                            let _e899 = select(_e870, _e868, (_e868 < _e870));
                                            let _e901 = select(_e897, _e893, (_e893 > _e897));
                                            let _e903 = select(_e899, _e895, (_e895 > _e899));
                                            let _e905 = select(_e885, _e901, (_e901 > _e885));
                                            let _e907 = select(_e887, _e903, (_e903 > _e887));
                                            let _e909 = select(_e856, _e854, (_e854 > _e856));
                                            let _e911 = select(_e857, _e855, (_e855 > _e857));
                                            let _e913 = select(_e869, _e867, (_e867 > _e869));
                                            let _e915 = select(_e870, _e868, (_e868 > _e870));
                                            let _e917 = select(_e913, _e909, (_e909 < _e913));
                                            let _e919 = select(_e915, _e911, (_e911 < _e915));
                                            let _e924 = -(_e885);
                                            let _e925 = -(_e887);
                                            let _e932 = (select(_e889, _e917, (_e917 < _e889)) + (select(_e924, _e889, (_e889 > _e924)) * 0.0000019073523f));
                                            let _e933 = (select(_e891, _e919, (_e919 < _e891)) + (select(_e925, _e891, (_e891 > _e925)) * 0.0000019073523f));
                                            let _e935 = select(_e443, _e905, (_e905 > _e443));
                                            let _e937 = select(_e443, _e907, (_e907 > _e443));
                                            let _e942 = (_e935 <= select(_e492.member.member_1, _e932, (_e932 < _e492.member.member_1)));
                                            let _e943 = (_e937 <= select(_e492.member.member_1, _e933, (_e933 < _e492.member.member_1)));
                                            let _e944 = (_e935 <= _e937);
                                            if _e942 {
                                                if _e943 {
                                                    if _e944 {
                                                        phi_2985_ = _e841.member_2;
                                                    } else {
                                                        phi_2985_ = _e841.member_1;
                                                    }
                                                    let _e948 = phi_2985_;
                                                    let _e970 = (_e536 % 128u);
                                                    let _e971 = (_e970 < 128u);
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_8[_e970] = _e948.member_1;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_7[_e970] = _e948.member.member.x;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_6[_e970] = _e948.member.member.y;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_5[_e970] = _e948.member.member.z;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_4[_e970] = _e948.member.member_1.x;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_3[_e970] = _e948.member.member_1.y;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_2[_e970] = _e948.member.member_1.z;
                                                    if _e971 {
                                                    } else {
                                                        phi_3576_ = true;
                                                        break;
                                                    }
                                                    local_9[_e970] = select(_e937, _e935, (_e935 > _e937));
                                                    if _e944 {
                                                        phi_3062_ = _e841.member_1;
                                                    } else {
                                                        phi_3062_ = _e841.member_2;
                                                    }
                                                    let _e984 = phi_3062_;
                                                    phi_3063_ = _e984;
                                                    phi_3064_ = (_e536 + 1u);
                                                } else {
                                                    phi_3063_ = type_53();
                                                    phi_3064_ = u32();
                                                }
                                                let _e986 = phi_3063_;
                                                let _e988 = phi_3064_;
                                                phi_3066_ = _e986;
                                                phi_3067_ = _e988;
                                                phi_3068_ = select(true, false, _e943);
                                            } else {
                                                phi_3066_ = type_53();
                                                phi_3067_ = u32();
                                                phi_3068_ = true;
                                            }
                                            let _e991 = phi_3066_;
                                            let _e993 = phi_3067_;
                                            let _e995 = phi_3068_;
                                            if _e995 {
                                                if _e942 {
                                                    phi_3077_ = _e841.member_1;
                                                } else {
                                                    phi_3077_ = _e841.member_2;
                                                }
                                                let _e999 = phi_3077_;
                                                phi_3082_ = _e999;
                                                phi_3083_ = select(_e943, true, _e942);
                                            } else {
                                                phi_3082_ = _e991;
                                                phi_3083_ = _e534;
                                            }
                                            let _e1002 = phi_3082_;
                                            let _e1004 = phi_3083_;
                                            phi_3580_ = _e490;
                                            phi_3085_ = type_42(_e492.member, (_e492.member_1 + 1u), _e492.member_2);
                                            phi_3086_ = _e1002;
                                            phi_3087_ = _e1004;
                                            phi_3088_ = select(_e993, _e536, _e995);
                                        }
                                        let _e1428 = phi_3580_;
                                        let _e1430 = phi_3085_;
                                        let _e1432 = phi_3086_;
                                        let _e1434 = phi_3087_;
                                        let _e1436 = phi_3088_;
                                        phi_3579_ = _e1428;
                                        phi_3089_ = _e1430;
                                        phi_3090_ = _e1432;
                                        phi_3091_ = (_e496 - 1u);
                                        phi_3092_ = _e1434;
                                        phi_3093_ = _e1436;
                                    } else {
                                        phi_3579_ = _e490;
                                        phi_3089_ = _e492;
                                        phi_3090_ = _e532;
                                        phi_3091_ = _e496;
                                        phi_3092_ = _e534;
                                        phi_3093_ = _e536;
                                    }
                                    let _e1438 = phi_3579_;
                                    let _e1440 = phi_3089_;
                                    let _e1442 = phi_3090_;
                                    let _e1444 = phi_3091_;
                                    let _e1446 = phi_3092_;
                                    let _e1448 = phi_3093_;
                                    phi_3578_ = _e1438;
                                    phi_3094_ = _e1440;
                                    phi_3095_ = _e1442;
                                    phi_3096_ = _e1444;
                                    phi_3097_ = _e1446;
                                    phi_3098_ = _e1448;
                                } else {
                                    phi_3578_ = _e490;
                                    phi_3094_ = type_42();
                                    phi_3095_ = type_53();
                                    phi_3096_ = u32();
                                    phi_3097_ = bool();
                                    phi_3098_ = u32();
                                }
                                let _e1450 = phi_3578_;
                                let _e1452 = phi_3094_;
                                let _e1454 = phi_3095_;
                                let _e1456 = phi_3096_;
                                let _e1458 = phi_3097_;
                                let _e1460 = phi_3098_;
                                phi_3577_ = _e1450;
                                phi_860_ = _e1452;
                                phi_863_ = _e1454;
                                phi_865_ = _e1456;
                                phi_867_ = _e1458;
                                phi_869_ = _e1460;
                                phi_3099_ = _e504;
                            } else {
                                phi_3577_ = _e490;
                                phi_860_ = type_42();
                                phi_863_ = type_53();
                                phi_865_ = u32();
                                phi_867_ = bool();
                                phi_869_ = u32();
                                phi_3099_ = false;
                            }
                            let _e1462 = phi_3577_;
                            let _e1464 = phi_860_;
                            let _e1466 = phi_863_;
                            let _e1468 = phi_865_;
                            let _e1470 = phi_867_;
                            let _e1472 = phi_869_;
                            let _e1474 = phi_3099_;
                            continue;
                            continuing {
                                phi_3468_ = _e1462;
                                phi_859_ = _e1464;
                                phi_862_ = _e1466;
                                phi_864_ = _e1468;
                                phi_866_ = _e1470;
                                phi_868_ = _e1472;
                                phi_3576_ = _e1462;
                                break if !(_e1474);
                            }
                        }
                        let _e1477 = phi_3576_;
                        if _e1477 {
                            break;
                        }
                        let _e1479 = local_10;
                        if (_e1479.member.member.member_3 != 4294967295u) {
                            let _e1485 = (_e267 / 3i);
                            let _e1492 = bitcast<f32>((bitcast<u32>((_e1485 + 127i)) << bitcast<u32>(23i)));
                            let _e1500 = (((_e1479.member.member.member * _e1492) * _e1492) * bitcast<f32>((bitcast<u32>(((_e267 - (2i * _e1485)) + 127i)) << bitcast<u32>(23i))));
                            let _e1502 = select(340282350000000000000000000000000000000f, _e1500, (_e1500 < 340282350000000000000000000000000000000f));
                            phi_3151_ = type_22(select(-340282350000000000000000000000000000000f, _e1502, (_e1502 > -340282350000000000000000000000000000000f)), _e1479.member.member.member_1, _e1479.member.member.member_2, _e1479.member.member.member_3);
                        } else {
                            phi_3151_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1509 = phi_3151_;
                        if _e143 {
                        } else {
                            break;
                        }
                        global_2.member[_e127] = _e1509;
                        let _e1513 = local_11;
                        if _e144 {
                        } else {
                            break;
                        }
                        global_5.member[_e127] = _e1513.member_1;
                        if _e142 {
                        } else {
                            break;
                        }
                        let _e1518 = select(0u, 1u, (_e211 <= _e221));
                        if (_e1518 > 0u) {
                            let _e1520 = (1u < _e95);
                            if _e1520 {
                                if (0u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1524 = atomicAdd((&global_6.member[0u]), _e1518);
                                if ((_e1524 + _e1518) < _e1524) {
                                    if _e1520 {
                                    } else {
                                        break;
                                    }
                                    let _e1529 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1532 = select(0u, 1u, (_e1509.member_3 != 4294967295u));
                        if (_e1532 > 0u) {
                            let _e1534 = (3u < _e95);
                            if _e1534 {
                                if (2u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1538 = atomicAdd((&global_6.member[2u]), _e1532);
                                if ((_e1538 + _e1532) < _e1538) {
                                    if _e1534 {
                                    } else {
                                        break;
                                    }
                                    let _e1543 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1513.member_1 > 0u) {
                            let _e1545 = (5u < _e95);
                            if _e1545 {
                                if (4u < _e95) {
                                } else {
                                    break;
                                }
                                let _e1549 = atomicAdd((&global_6.member[4u]), _e1513.member_1);
                                if ((_e1549 + _e1513.member_1) < _e1549) {
                                    if _e1545 {
                                    } else {
                                        break;
                                    }
                                    let _e1554 = atomicAdd((&global_6.member[5u]), 1u);
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
