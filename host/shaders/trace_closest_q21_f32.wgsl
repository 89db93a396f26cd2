struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
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

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_21,
    member_1: f32,
}

struct type_38 {
    member: array<type_25>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_29,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_23;

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
    var phi_381_: i32;
    var phi_382_: i32;
    var phi_392_: bool;
    var phi_402_: u32;
    var phi_403_: u32;
    var phi_405_: bool;
    var phi_410_: u32;
    var phi_422_: i32;
    var phi_442_: i32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_506_: f32;
    var phi_517_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_572_: f32;
    var phi_583_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_3450_: bool;
    var phi_839_: type_33;
    var phi_842_: type_50;
    var phi_844_: u32;
    var phi_846_: bool;
    var phi_848_: u32;
    var phi_859_: bool;
    var phi_945_: type_50;
    var phi_946_: bool;
    var phi_947_: u32;
    var phi_2697_: u32;
    var phi_2698_: u32;
    var phi_2708_: u32;
    var phi_2710_: u32;
    var phi_2711_: bool;
    var phi_2731_: u32;
    var phi_2732_: u32;
    var phi_2736_: type_51;
    var phi_3080_: type_50;
    var phi_3157_: type_50;
    var phi_3158_: type_50;
    var phi_3159_: u32;
    var phi_3161_: type_50;
    var phi_3162_: u32;
    var phi_3163_: bool;
    var phi_3172_: type_50;
    var phi_3177_: type_50;
    var phi_3178_: bool;
    var phi_965_: type_33;
    var phi_968_: type_4;
    var phi_969_: type_4;
    var phi_991_: type_4;
    var phi_1012_: u32;
    var phi_1101_: array<array<f32, 3>, 3>;
    var phi_1218_: bool;
    var phi_1247_: bool;
    var phi_1648_: f32;
    var phi_1649_: f32;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1655_: vec3<f32>;
    var phi_1686_: bool;
    var phi_1695_: vec3<f32>;
    var phi_1860_: f32;
    var phi_1862_: f32;
    var phi_1863_: bool;
    var phi_1883_: f32;
    var phi_1884_: f32;
    var phi_1907_: type_21;
    var phi_1909_: type_21;
    var phi_1910_: bool;
    var phi_1914_: type_21;
    var phi_1915_: type_21;
    var phi_1916_: type_21;
    var phi_1917_: bool;
    var phi_1921_: type_21;
    var phi_1922_: bool;
    var phi_1923_: type_21;
    var phi_1924_: bool;
    var phi_1925_: bool;
    var phi_1926_: type_21;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1936_: type_21;
    var phi_1937_: bool;
    var phi_1941_: type_21;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1973_: type_33;
    var phi_1974_: type_33;
    var phi_1975_: type_33;
    var phi_966_: type_33;
    var phi_3444_: bool;
    var phi_3590_: bool;
    var phi_3180_: type_33;
    var phi_3181_: type_50;
    var phi_3182_: bool;
    var phi_3183_: u32;
    var phi_3589_: bool;
    var phi_3184_: type_33;
    var phi_3185_: type_50;
    var phi_3186_: u32;
    var phi_3187_: bool;
    var phi_3188_: u32;
    var phi_3588_: bool;
    var phi_3189_: type_33;
    var phi_3190_: type_50;
    var phi_3191_: u32;
    var phi_3192_: bool;
    var phi_3193_: u32;
    var phi_3587_: bool;
    var phi_840_: type_33;
    var phi_843_: type_50;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_3194_: bool;
    var phi_3586_: bool;
    var local_10: type_33;
    var phi_3246_: type_21;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e85 = arrayLength((&global_5.member));
            let _e87 = arrayLength((&global_2.member));
            let _e95 = global_3.member[0u][0u];
            let _e99 = global_3.member[0u][1u];
            let _e103 = global_3.member[0u][2u];
            let _e107 = global_3.member[0u][3u];
            let _e111 = global_3.member[1u][0u];
            let _e115 = global_3.member[1u][1u];
            let _e119 = global_3.member[1u][2u];
            let _e122 = global_1.member[0u];
            let _e123 = bitcast<i32>(_e122);
            let _e135 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e107) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e95), bitcast<i32>(_e99), bitcast<i32>(_e103));
            local = array<i32, 3>(bitcast<i32>(_e111), bitcast<i32>(_e115), bitcast<i32>(_e119));
            let _e141 = (_e83.x + (_e83.y * 2097152u));
            let _e142 = (_e141 < arrayLength((&global_4.member)));
            if _e142 {
                let _e143 = (_e141 < arrayLength((&global_6.member)));
                if _e143 {
                    if _e142 {
                    } else {
                        break;
                    }
                    let _e151 = global_4.member[_e141].member_2[0u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_4.member[_e141].member_2[1u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e141].member_2[2u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e141].member[0u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e141].member[1u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_4.member[_e141].member[2u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e190 = select(_e160, _e153, (_e160 < _e153));
                    let _e192 = select(_e167, _e190, (_e167 < _e190));
                    let _e194 = select(_e174, _e192, (_e174 < _e192));
                    let _e196 = select(_e181, _e194, (_e181 < _e194));
                    let _e198 = select(_e188, _e196, (_e188 < _e196));
                    let _e202 = global_4.member[_e141].member_1;
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e211 = global_4.member[_e141].member_3;
                    let _e217 = (((select(_e204, _e198, (_e204 < _e198)) < 2139095040u) && ((bitcast<u32>(_e211) & 2147483647u) <= 2139095040u)) && (_e192 > 0u));
                    if _e217 {
                        let _e220 = (bitcast<u32>(bitcast<f32>(_e192)) & 2147483647u);
                        if (_e220 >= 8388608u) {
                            phi_381_ = (bitcast<i32>((_e220 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_381_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e220)), 32u, (_e220 == 0u))));
                        }
                        let _e234 = phi_381_;
                        phi_382_ = _e234;
                    } else {
                        phi_382_ = 0i;
                    }
                    let _e236 = phi_382_;
                    let _e237 = (_e153 == _e192);
                    if _e237 {
                        phi_392_ = true;
                    } else {
                        phi_392_ = (_e160 == _e192);
                    }
                    let _e240 = phi_392_;
                    let _e241 = select(1u, 0u, _e237);
                    if _e240 {
                        let _e242 = (_e241 + 1u);
                        phi_402_ = _e242;
                        phi_403_ = _e242;
                        phi_405_ = select(true, false, (_e242 == 2u));
                    } else {
                        phi_402_ = u32();
                        phi_403_ = 0u;
                        phi_405_ = true;
                    }
                    let _e246 = phi_402_;
                    let _e248 = phi_403_;
                    let _e250 = phi_405_;
                    if _e250 {
                        phi_410_ = (_e248 + 1u);
                    } else {
                        phi_410_ = 0u;
                    }
                    let _e254 = phi_410_;
                    let _e255 = select(_e246, _e248, _e250);
                    let _e256 = select(_e241, select(2u, _e241, _e240), _e250);
                    if (_e123 < -126i) {
                        phi_422_ = -126i;
                    } else {
                        phi_422_ = select(_e123, 127i, (_e123 > 127i));
                    }
                    let _e261 = phi_422_;
                    let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                    let _e272 = bitcast<f32>((bitcast<u32>(((_e123 - _e261) + 127i)) << bitcast<u32>(23i)));
                    let _e273 = -(_e236);
                    if (_e273 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e273, 127i, (_e273 > 127i));
                    }
                    let _e278 = phi_442_;
                    let _e283 = bitcast<f32>((bitcast<u32>((_e278 + 127i)) << bitcast<u32>(23i)));
                    let _e289 = bitcast<f32>((bitcast<u32>(((_e273 - _e278) + 127i)) << bitcast<u32>(23i)));
                    let _e293 = global_4.member[_e141].member;
                    let _e294 = (_e255 == 0u);
                    if _e294 {
                        phi_460_ = _e293[0];
                    } else {
                        phi_460_ = _e293[1];
                    }
                    let _e298 = phi_460_;
                    let _e299 = (_e255 == 2u);
                    if _e299 {
                        phi_466_ = _e293[2];
                    } else {
                        phi_466_ = _e298;
                    }
                    let _e302 = phi_466_;
                    let _e304 = ((_e302 * _e266) * _e272);
                    let _e305 = global_4.member[_e141].member_2;
                    if _e294 {
                        phi_477_ = _e305[0];
                    } else {
                        phi_477_ = _e305[1];
                    }
                    let _e309 = phi_477_;
                    if _e299 {
                        phi_483_ = _e305[2];
                    } else {
                        phi_483_ = _e309;
                    }
                    let _e312 = phi_483_;
                    let _e314 = ((_e312 * _e283) * _e289);
                    let _e318 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e318 {
                        let _e322 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) * 0.00000011920929f);
                        phi_506_ = select(0.00000000000011368684f, _e322, (_e322 > 0.00000000000011368684f));
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e326 = phi_506_;
                    let _e327 = (_e304 + _e326);
                    let _e328 = (_e304 - _e326);
                    let _e329 = select(_e314, 0f, _e318);
                    if _e318 {
                        phi_517_ = 38685626000000000000000000f;
                    } else {
                        phi_517_ = (1f / _e314);
                    }
                    let _e332 = phi_517_;
                    let _e333 = (_e254 == 0u);
                    if _e333 {
                        phi_526_ = _e293[0];
                    } else {
                        phi_526_ = _e293[1];
                    }
                    let _e337 = phi_526_;
                    let _e338 = (_e254 == 2u);
                    if _e338 {
                        phi_532_ = _e293[2];
                    } else {
                        phi_532_ = _e337;
                    }
                    let _e341 = phi_532_;
                    let _e343 = ((_e341 * _e266) * _e272);
                    if _e333 {
                        phi_543_ = _e305[0];
                    } else {
                        phi_543_ = _e305[1];
                    }
                    let _e347 = phi_543_;
                    if _e338 {
                        phi_549_ = _e305[2];
                    } else {
                        phi_549_ = _e347;
                    }
                    let _e350 = phi_549_;
                    let _e352 = ((_e350 * _e283) * _e289);
                    let _e356 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e356 {
                        let _e360 = (bitcast<f32>((bitcast<u32>(_e343) & 2147483647u)) * 0.00000011920929f);
                        phi_572_ = select(0.00000000000011368684f, _e360, (_e360 > 0.00000000000011368684f));
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e364 = phi_572_;
                    let _e365 = (_e343 + _e364);
                    let _e366 = (_e343 - _e364);
                    let _e367 = select(_e352, 0f, _e356);
                    if _e356 {
                        phi_583_ = 38685626000000000000000000f;
                    } else {
                        phi_583_ = (1f / _e352);
                    }
                    let _e370 = phi_583_;
                    let _e371 = (_e256 == 0u);
                    if _e371 {
                        phi_592_ = _e293[0];
                    } else {
                        phi_592_ = _e293[1];
                    }
                    let _e375 = phi_592_;
                    let _e376 = (_e256 == 2u);
                    if _e376 {
                        phi_598_ = _e293[2];
                    } else {
                        phi_598_ = _e375;
                    }
                    let _e379 = phi_598_;
                    let _e381 = ((_e379 * _e266) * _e272);
                    if _e371 {
                        phi_609_ = _e305[0];
                    } else {
                        phi_609_ = _e305[1];
                    }
                    let _e385 = phi_609_;
                    if _e376 {
                        phi_615_ = _e305[2];
                    } else {
                        phi_615_ = _e385;
                    }
                    let _e388 = phi_615_;
                    let _e390 = ((_e388 * _e283) * _e289);
                    let _e394 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e394 {
                        let _e398 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                        phi_638_ = select(0.00000000000011368684f, _e398, (_e398 > 0.00000000000011368684f));
                    } else {
                        phi_638_ = 0f;
                    }
                    let _e402 = phi_638_;
                    let _e403 = (_e381 + _e402);
                    let _e404 = (_e381 - _e402);
                    let _e405 = select(_e390, 0f, _e394);
                    if _e394 {
                        phi_649_ = 38685626000000000000000000f;
                    } else {
                        phi_649_ = (1f / _e390);
                    }
                    let _e408 = phi_649_;
                    let _e411 = bitcast<f32>((bitcast<u32>(_e304) & 2147483647u));
                    let _e414 = bitcast<f32>((bitcast<u32>(_e343) & 2147483647u));
                    let _e416 = select(_e414, _e411, (_e411 > _e414));
                    let _e419 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                    let _e422 = (_e123 + _e236);
                    if (_e217 && (select(_e419, _e416, (_e416 > _e419)) <= 1099511600000f)) {
                        let _e425 = (_e422 / 3i);
                        let _e432 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e439 = bitcast<f32>((bitcast<u32>(((_e422 - (2i * _e425)) + 127i)) << bitcast<u32>(23i)));
                        let _e440 = (((_e202 * _e432) * _e432) * _e439);
                        let _e442 = select(340282350000000000000000000000000000000f, _e440, (_e440 < 340282350000000000000000000000000000000f));
                        let _e447 = (((_e211 * _e432) * _e432) * _e439);
                        let _e449 = select(340282350000000000000000000000000000000f, _e447, (_e447 < 340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e449, (_e449 > -340282350000000000000000000000000000000f));
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e442, (_e442 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_749_ = 0f;
                        phi_750_ = 1f;
                    }
                    let _e453 = phi_749_;
                    let _e455 = phi_750_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e459 = (_e255 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    let _e465 = (_e254 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e256 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e479 = local[_e459];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e465];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e471];
                    phi_3450_ = false;
                    phi_839_ = type_33(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e453);
                    phi_842_ = type_50(type_29(vec4<f32>((f32(_e462) * _e135), (f32(_e468) * _e135), (f32(_e474) * _e135), 0f), vec4<f32>((f32(_e479) * _e135), (f32(_e483) * _e135), (f32(_e487) * _e135), 0f)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_844_ = ((3u * _e85) + 1u);
                    phi_846_ = (_e455 <= _e453);
                    phi_848_ = 0u;
                    loop {
                        let _e497 = phi_3450_;
                        let _e499 = phi_839_;
                        let _e501 = phi_842_;
                        let _e503 = phi_844_;
                        let _e505 = phi_846_;
                        let _e507 = phi_848_;
                        local_10 = _e499;
                        if _e505 {
                            phi_859_ = true;
                        } else {
                            phi_859_ = (_e507 > 0u);
                        }
                        let _e510 = phi_859_;
                        if _e510 {
                            let _e511 = (_e503 > 0u);
                            if _e511 {
                                if _e505 {
                                    phi_945_ = _e501;
                                    phi_946_ = _e505;
                                    phi_947_ = _e507;
                                } else {
                                    let _e512 = (_e507 - 1u);
                                    let _e513 = (_e512 % 128u);
                                    let _e514 = (_e513 < 128u);
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e516 = local_7[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e518 = local_6[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e520 = local_5[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e522 = local_4[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e524 = local_3[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e526 = local_2[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e531 = local_8[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3586_ = true;
                                        break;
                                    }
                                    let _e534 = local_9[_e513];
                                    phi_945_ = type_50(type_29(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                    phi_946_ = (_e534 <= _e499.member_1);
                                    phi_947_ = _e512;
                                }
                                let _e538 = phi_945_;
                                let _e540 = phi_946_;
                                let _e542 = phi_947_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_965_ = _e499;
                                        phi_968_ = type_4(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_965_;
                                            let _e1006 = phi_968_;
                                            local_11 = _e1004;
                                            if (_e1006.member < _e1006.member_1) {
                                                phi_969_ = type_4((_e1006.member + 1u), _e1006.member_1);
                                                phi_991_ = type_4(1u, _e1006.member);
                                            } else {
                                                phi_969_ = _e1006;
                                                phi_991_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1019 = phi_969_;
                                            let _e1021 = phi_991_;
                                            let _e1025 = (bitcast<i32>(_e1021.member) != 0i);
                                            if _e1025 {
                                                let _e1026 = ((_e538.member_1 & 268435455u) + _e1021.member_1);
                                                let _e1027 = (_e1026 < _e87);
                                                if _e1027 {
                                                    if _e1027 {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1031 = global_2.member[_e1026].member_1;
                                                    phi_1012_ = _e1031;
                                                } else {
                                                    phi_1012_ = 4294967295u;
                                                }
                                                let _e1033 = phi_1012_;
                                                if (_e1026 >= _e87) {
                                                    phi_1101_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1027 {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1040 = global_2.member[_e1026].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1046 = global_2.member[_e1026].member[_e465];
                                                    if (_e471 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1052 = global_2.member[_e1026].member[_e471];
                                                    let _e1054 = (3u + _e459);
                                                    if (_e1054 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1060 = global_2.member[_e1026].member[_e1054];
                                                    let _e1061 = (3u + _e465);
                                                    if (_e1061 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1067 = global_2.member[_e1026].member[_e1061];
                                                    let _e1068 = (3u + _e471);
                                                    if (_e1068 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_2.member[_e1026].member[_e1068];
                                                    let _e1076 = (6u + _e459);
                                                    if (_e1076 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1082 = global_2.member[_e1026].member[_e1076];
                                                    let _e1083 = (6u + _e465);
                                                    if (_e1083 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_2.member[_e1026].member[_e1083];
                                                    let _e1090 = (6u + _e471);
                                                    if (_e1090 < 9u) {
                                                    } else {
                                                        phi_3444_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1026].member[_e1090];
                                                    phi_1101_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1040, _e1046, _e1052), array<f32, 3>(_e1060, _e1067, _e1074), array<f32, 3>(_e1082, _e1089, _e1096));
                                                }
                                                let _e1100 = phi_1101_;
                                                let _e1108 = (_e1100[0][2] - _e381);
                                                let _e1111 = (((_e1100[0][0] - _e304) * _e405) - (_e1108 * _e329));
                                                let _e1114 = (((_e1100[0][1] - _e343) * _e405) - (_e1108 * _e367));
                                                let _e1121 = (_e1100[1][2] - _e381);
                                                let _e1124 = (((_e1100[1][0] - _e304) * _e405) - (_e1121 * _e329));
                                                let _e1127 = (((_e1100[1][1] - _e343) * _e405) - (_e1121 * _e367));
                                                let _e1134 = (_e1100[2][2] - _e381);
                                                let _e1137 = (((_e1100[2][0] - _e304) * _e405) - (_e1134 * _e329));
                                                let _e1140 = (((_e1100[2][1] - _e343) * _e405) - (_e1134 * _e367));
                                                let _e1141 = (_e1137 * _e1127);
                                                let _e1142 = (_e1140 * _e1124);
                                                let _e1143 = (_e1111 * _e1140);
                                                let _e1144 = (_e1114 * _e1137);
                                                let _e1145 = (_e1124 * _e1114);
                                                let _e1146 = (_e1127 * _e1111);
                                                let _e1151 = (((_e1141 >= _e1142) && (_e1143 >= _e1144)) && (_e1145 >= _e1146));
                                                if (_e1151 || (((_e1141 <= _e1142) && (_e1143 <= _e1144)) && (_e1145 <= _e1146))) {
                                                    let _e1158 = select(-1f, 1f, _e1151);
                                                    let _e1160 = ((_e1141 - _e1142) * _e1158);
                                                    let _e1162 = select(0f, _e1160, (_e1160 > 0f));
                                                    let _e1164 = ((_e1143 - _e1144) * _e1158);
                                                    let _e1166 = select(0f, _e1164, (_e1164 > 0f));
                                                    let _e1168 = ((_e1145 - _e1146) * _e1158);
                                                    let _e1170 = select(0f, _e1168, (_e1168 > 0f));
                                                    let _e1172 = ((_e1162 + _e1166) + _e1170);
                                                    if (_e1172 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1926_ = type_21();
                                                        phi_1927_ = true;
                                                        phi_1928_ = false;
                                                    } else {
                                                        let _e1175 = select(_e1124, _e1111, (_e1111 < _e1124));
                                                        if (select(_e1137, _e1175, (_e1175 < _e1137)) > 0f) {
                                                            phi_1218_ = true;
                                                        } else {
                                                            let _e1180 = select(_e1124, _e1111, (_e1111 > _e1124));
                                                            phi_1218_ = (select(_e1137, _e1180, (_e1180 > _e1137)) < 0f);
                                                        }
                                                        let _e1185 = phi_1218_;
                                                        if _e1185 {
                                                            phi_1923_ = type_21();
                                                            phi_1924_ = true;
                                                            phi_1925_ = false;
                                                        } else {
                                                            let _e1187 = select(_e1127, _e1114, (_e1114 < _e1127));
                                                            if (select(_e1140, _e1187, (_e1187 < _e1140)) > 0f) {
                                                                phi_1247_ = true;
                                                            } else {
                                                                let _e1192 = select(_e1127, _e1114, (_e1114 > _e1127));
                                                                phi_1247_ = (select(_e1140, _e1192, (_e1192 > _e1140)) < 0f);
                                                            }
                                                            let _e1197 = phi_1247_;
                                                            if _e1197 {
                                                                phi_1921_ = type_21();
                                                                phi_1922_ = false;
                                                            } else {
                                                                let _e1199 = select(_e1100[1][0], _e1100[0][0], (_e1100[0][0] < _e1100[1][0]));
                                                                let _e1203 = select(_e1100[1][0], _e1100[0][0], (_e1100[0][0] > _e1100[1][0]));
                                                                let _e1207 = select(_e1100[1][1], _e1100[0][1], (_e1100[0][1] < _e1100[1][1]));
                                                                let _e1211 = select(_e1100[1][1], _e1100[0][1], (_e1100[0][1] > _e1100[1][1]));
                                                                let _e1215 = select(_e1100[1][2], _e1100[0][2], (_e1100[0][2] < _e1100[1][2]));
                                                                let _e1219 = select(_e1100[1][2], _e1100[0][2], (_e1100[0][2] > _e1100[1][2]));
                                                                let _e1224 = ((select(_e1100[2][0], _e1199, (_e1199 < _e1100[2][0])) - _e327) * _e332);
                                                                let _e1225 = ((select(_e1100[2][0], _e1203, (_e1203 > _e1100[2][0])) - _e328) * _e332);
                                                                let _e1228 = ((select(_e1100[2][1], _e1207, (_e1207 < _e1100[2][1])) - _e365) * _e370);
                                                                let _e1229 = ((select(_e1100[2][1], _e1211, (_e1211 > _e1100[2][1])) - _e366) * _e370);
                                                                let _e1232 = ((select(_e1100[2][2], _e1215, (_e1215 < _e1100[2][2])) - _e403) * _e408);
                                                                let _e1233 = ((select(_e1100[2][2], _e1219, (_e1219 > _e1100[2][2])) - _e404) * _e408);
                                                                let _e1235 = select(_e1233, _e1232, (_e1232 < _e1233));
                                                                let _e1237 = select(_e1233, _e1232, (_e1232 > _e1233));
                                                                let _e1239 = select(_e1225, _e1224, (_e1224 < _e1225));
                                                                let _e1241 = select(_e1229, _e1228, (_e1228 < _e1229));
                                                                let _e1243 = select(_e1241, _e1239, (_e1239 > _e1241));
                                                                let _e1245 = select(_e1235, _e1243, (_e1243 > _e1235));
                                                                let _e1247 = select(_e1225, _e1224, (_e1224 > _e1225));
                                                                let _e1249 = select(_e1229, _e1228, (_e1228 > _e1229));
                                                                let _e1251 = select(_e1249, _e1247, (_e1247 < _e1249));
                                                                let _e1253 = select(_e1237, _e1251, (_e1251 < _e1237));
                                                                let _e1254 = -(_e1235);
                                                                let _e1260 = select(_e455, _e1245, (_e1245 > _e455));
                                                                if (_e1260 > (_e1253 + (select(_e1254, _e1237, (_e1237 > _e1254)) * 0.0000019073523f))) {
                                                                    phi_1916_ = type_21();
                                                                    phi_1917_ = true;
                                                                } else {
                                                                    let _e1262 = (_e1260 > _e1004.member_1);
                                                                    if _e1262 {
                                                                        phi_1915_ = type_21();
                                                                    } else {
                                                                        let _e1263 = vec3<f32>(_e1100[0][0], _e1100[0][1], _e1100[0][2]);
                                                                        let _e1264 = vec3<f32>(_e1100[1][0], _e1100[1][1], _e1100[1][2]);
                                                                        let _e1265 = vec3<f32>(_e1100[2][0], _e1100[2][1], _e1100[2][2]);
                                                                        let _e1266 = (_e1100[1][0] - _e1100[0][0]);
                                                                        let _e1267 = (_e1100[1][1] - _e1100[0][1]);
                                                                        let _e1268 = (_e1100[1][2] - _e1100[0][2]);
                                                                        let _e1269 = vec3<f32>(_e1266, _e1267, _e1268);
                                                                        let _e1270 = (_e1100[2][0] - _e1100[1][0]);
                                                                        let _e1271 = (_e1100[2][1] - _e1100[1][1]);
                                                                        let _e1272 = (_e1100[2][2] - _e1100[1][2]);
                                                                        let _e1273 = vec3<f32>(_e1270, _e1271, _e1272);
                                                                        let _e1274 = (_e1100[0][0] - _e1100[2][0]);
                                                                        let _e1275 = (_e1100[0][1] - _e1100[2][1]);
                                                                        let _e1276 = (_e1100[0][2] - _e1100[2][2]);
                                                                        let _e1277 = vec3<f32>(_e1274, _e1275, _e1276);
                                                                        let _e1280 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                        let _e1283 = bitcast<f32>((bitcast<u32>(_e1267) & 2147483647u));
                                                                        let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                        let _e1288 = bitcast<f32>((bitcast<u32>(_e1268) & 2147483647u));
                                                                        let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                        let _e1293 = bitcast<f32>((bitcast<u32>(_e1270) & 2147483647u));
                                                                        let _e1296 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                        let _e1298 = select(_e1296, _e1293, (_e1293 > _e1296));
                                                                        let _e1301 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                        let _e1303 = select(_e1301, _e1298, (_e1298 > _e1301));
                                                                        let _e1306 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1309 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                        let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                        let _e1314 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                        let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                        let _e1318 = select(_e1303, _e1290, (_e1290 > _e1303));
                                                                        let _e1320 = select(_e1316, _e1318, (_e1318 > _e1316));
                                                                        if (_e1290 == _e1320) {
                                                                            phi_1648_ = _e1127;
                                                                            phi_1649_ = _e1124;
                                                                            phi_1650_ = _e1114;
                                                                            phi_1651_ = _e1111;
                                                                            phi_1652_ = _e1263;
                                                                            phi_1653_ = _e1277;
                                                                            phi_1654_ = _e1273;
                                                                            phi_1655_ = _e1269;
                                                                        } else {
                                                                            let _e1322 = (_e1303 == _e1320);
                                                                            let _e1327 = vec3(_e1322);
                                                                            phi_1648_ = select(_e1114, _e1140, _e1322);
                                                                            phi_1649_ = select(_e1111, _e1137, _e1322);
                                                                            phi_1650_ = select(_e1140, _e1127, _e1322);
                                                                            phi_1651_ = select(_e1137, _e1124, _e1322);
                                                                            phi_1652_ = select(_e1265, _e1264, _e1327);
                                                                            phi_1653_ = select(_e1273, _e1269, _e1327);
                                                                            phi_1654_ = select(_e1269, _e1277, _e1327);
                                                                            phi_1655_ = select(_e1277, _e1273, _e1327);
                                                                        }
                                                                        let _e1333 = phi_1648_;
                                                                        let _e1335 = phi_1649_;
                                                                        let _e1337 = phi_1650_;
                                                                        let _e1339 = phi_1651_;
                                                                        let _e1341 = phi_1652_;
                                                                        let _e1343 = phi_1653_;
                                                                        let _e1345 = phi_1654_;
                                                                        let _e1347 = phi_1655_;
                                                                        let _e1354 = ((_e1345.y * _e1343.z) - (_e1343.y * _e1345.z));
                                                                        let _e1359 = ((_e1345.z * _e1343.x) - (_e1343.z * _e1345.x));
                                                                        let _e1362 = ((_e1345.x * _e1343.y) - (_e1343.x * _e1345.y));
                                                                        if (_e1162 >= _e1166) {
                                                                            phi_1686_ = select(true, false, (_e1162 >= _e1170));
                                                                        } else {
                                                                            phi_1686_ = true;
                                                                        }
                                                                        let _e1367 = phi_1686_;
                                                                        if _e1367 {
                                                                            phi_1695_ = select(_e1265, _e1264, vec3((_e1166 >= _e1170)));
                                                                        } else {
                                                                            phi_1695_ = _e1263;
                                                                        }
                                                                        let _e1372 = phi_1695_;
                                                                        let _e1383 = (((_e1354 * (_e1372.x - _e304)) + (_e1359 * (_e1372.y - _e343))) + (_e1362 * (_e1372.z - _e381)));
                                                                        let _e1388 = (((_e1354 * _e329) + (_e1359 * _e367)) + (_e1362 * _e405));
                                                                        let _e1389 = (_e1335 - _e1339);
                                                                        let _e1390 = (_e1333 - _e1337);
                                                                        let _e1398 = (-(((_e1339 * _e1389) + (_e1337 * _e1390))) / ((_e1389 * _e1389) + (_e1390 * _e1390)));
                                                                        let _e1400 = select(1f, _e1398, (_e1398 < 1f));
                                                                        let _e1402 = select(0f, _e1400, (_e1400 > 0f));
                                                                        let _e1415 = ((_e1341.x + (_e1347.x * _e1402)) - _e304);
                                                                        let _e1416 = ((_e1341.y + (_e1347.y * _e1402)) - _e343);
                                                                        let _e1417 = ((_e1341.z + (_e1347.z * _e1402)) - _e381);
                                                                        let _e1418 = (_e1417 / _e405);
                                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1440 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                        let _e1451 = select(_e1449, _e1446, (_e1446 > _e1449));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1354 * _e1415) + (_e1359 * _e1416)) + (_e1362 * _e1417)) - _e1383)) & 2147483647u)) <= ((0.0000009536743f * select(_e1320, _e1440, (_e1440 > _e1320))) * select(_e1454, _e1451, (_e1451 > _e1454)))) {
                                                                            let _e1464 = bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u));
                                                                            let _e1467 = bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u));
                                                                            let _e1469 = select(_e1467, _e1464, (_e1464 > _e1467));
                                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u));
                                                                            let _e1478 = bitcast<f32>((bitcast<u32>(_e1343.x) & 2147483647u));
                                                                            let _e1481 = bitcast<f32>((bitcast<u32>(_e1343.y) & 2147483647u));
                                                                            let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                            let _e1486 = bitcast<f32>((bitcast<u32>(_e1343.z) & 2147483647u));
                                                                            let _e1490 = (bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)) > ((0.0000038146973f * select(_e1472, _e1469, (_e1469 > _e1472))) * select(_e1486, _e1483, (_e1483 > _e1486))));
                                                                            if _e1490 {
                                                                                phi_1860_ = (_e1383 / _e1388);
                                                                            } else {
                                                                                phi_1860_ = f32();
                                                                            }
                                                                            let _e1493 = phi_1860_;
                                                                            phi_1862_ = _e1493;
                                                                            phi_1863_ = select(true, false, _e1490);
                                                                        } else {
                                                                            phi_1862_ = f32();
                                                                            phi_1863_ = true;
                                                                        }
                                                                        let _e1496 = phi_1862_;
                                                                        let _e1498 = phi_1863_;
                                                                        if _e1498 {
                                                                            let _e1506 = (((_e1354 * (_e1415 - (_e329 * _e1418))) + (_e1359 * (_e1416 - (_e367 * _e1418)))) / _e1388);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u)) <= _e1320) {
                                                                                phi_1883_ = (_e1418 + _e1506);
                                                                            } else {
                                                                                phi_1883_ = _e1418;
                                                                            }
                                                                            let _e1513 = phi_1883_;
                                                                            phi_1884_ = _e1513;
                                                                        } else {
                                                                            phi_1884_ = _e1496;
                                                                        }
                                                                        let _e1515 = phi_1884_;
                                                                        let _e1517 = select(_e1253, _e1515, (_e1515 < _e1253));
                                                                        let _e1519 = select(_e1245, _e1517, (_e1517 > _e1245));
                                                                        if (_e1519 >= _e455) {
                                                                            let _e1521 = (_e1519 <= _e1004.member_1);
                                                                            if _e1521 {
                                                                                let _e1522 = (1f / _e1172);
                                                                                phi_1907_ = type_21(_e1519, (_e1166 * _e1522), (_e1170 * _e1522), _e1033);
                                                                            } else {
                                                                                phi_1907_ = type_21();
                                                                            }
                                                                            let _e1527 = phi_1907_;
                                                                            phi_1909_ = _e1527;
                                                                            phi_1910_ = select(true, false, _e1521);
                                                                        } else {
                                                                            phi_1909_ = type_21();
                                                                            phi_1910_ = true;
                                                                        }
                                                                        let _e1530 = phi_1909_;
                                                                        let _e1532 = phi_1910_;
                                                                        if _e1532 {
                                                                            phi_1914_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1914_ = _e1530;
                                                                        }
                                                                        let _e1534 = phi_1914_;
                                                                        phi_1915_ = _e1534;
                                                                    }
                                                                    let _e1536 = phi_1915_;
                                                                    phi_1916_ = _e1536;
                                                                    phi_1917_ = _e1262;
                                                                }
                                                                let _e1538 = phi_1916_;
                                                                let _e1540 = phi_1917_;
                                                                phi_1921_ = _e1538;
                                                                phi_1922_ = _e1540;
                                                            }
                                                            let _e1542 = phi_1921_;
                                                            let _e1544 = phi_1922_;
                                                            phi_1923_ = _e1542;
                                                            phi_1924_ = _e1197;
                                                            phi_1925_ = _e1544;
                                                        }
                                                        let _e1546 = phi_1923_;
                                                        let _e1548 = phi_1924_;
                                                        let _e1550 = phi_1925_;
                                                        phi_1926_ = _e1546;
                                                        phi_1927_ = _e1548;
                                                        phi_1928_ = _e1550;
                                                    }
                                                    let _e1552 = phi_1926_;
                                                    let _e1554 = phi_1927_;
                                                    let _e1556 = phi_1928_;
                                                    phi_1936_ = _e1552;
                                                    phi_1937_ = select(_e1556, true, _e1554);
                                                } else {
                                                    phi_1936_ = type_21();
                                                    phi_1937_ = true;
                                                }
                                                let _e1559 = phi_1936_;
                                                let _e1561 = phi_1937_;
                                                if _e1561 {
                                                    phi_1941_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1941_ = _e1559;
                                                }
                                                let _e1563 = phi_1941_;
                                                if (_e1563.member_3 != 4294967295u) {
                                                    if (_e1033 != 4294967295u) {
                                                        if (_e1563.member < _e1004.member.member) {
                                                            phi_1967_ = true;
                                                        } else {
                                                            if (_e1563.member == _e1004.member.member) {
                                                                phi_1966_ = (_e1563.member_3 < _e1004.member.member_3);
                                                            } else {
                                                                phi_1966_ = false;
                                                            }
                                                            let _e1576 = phi_1966_;
                                                            phi_1967_ = _e1576;
                                                        }
                                                        let _e1578 = phi_1967_;
                                                        if _e1578 {
                                                            phi_1973_ = type_33(_e1563, _e1563.member);
                                                        } else {
                                                            phi_1973_ = _e1004;
                                                        }
                                                        let _e1581 = phi_1973_;
                                                        phi_1974_ = _e1581;
                                                    } else {
                                                        phi_1974_ = _e1004;
                                                    }
                                                    let _e1583 = phi_1974_;
                                                    phi_1975_ = _e1583;
                                                } else {
                                                    phi_1975_ = _e1004;
                                                }
                                                let _e1585 = phi_1975_;
                                                phi_966_ = _e1585;
                                            } else {
                                                phi_966_ = type_33();
                                            }
                                            let _e1587 = phi_966_;
                                            continue;
                                            continuing {
                                                phi_965_ = _e1587;
                                                phi_968_ = _e1019;
                                                phi_3444_ = _e497;
                                                break if !(_e1025);
                                            }
                                        }
                                        let _e1590 = phi_3444_;
                                        phi_3586_ = _e1590;
                                        if _e1590 {
                                            break;
                                        }
                                        phi_3590_ = _e1590;
                                        let _e1784 = local_11;
                                        phi_3180_ = _e1784;
                                        phi_3181_ = _e538;
                                        phi_3182_ = false;
                                        phi_3183_ = _e542;
                                    } else {
                                        if (_e538.member_1 >= _e85) {
                                            phi_2736_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e85) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e553 = (_e255 * 2u);
                                            let _e555 = ((1u + _e553) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e560 = global_5.member[_e538.member_1][_e555];
                                            let _e562 = ((_e553 + 2u) % 7u);
                                            if (_e562 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e567 = global_5.member[_e538.member_1][_e562];
                                            let _e568 = (_e254 * 2u);
                                            let _e570 = ((1u + _e568) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e575 = global_5.member[_e538.member_1][_e570];
                                            let _e577 = ((_e568 + 2u) % 7u);
                                            if (_e577 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e582 = global_5.member[_e538.member_1][_e577];
                                            let _e583 = (_e256 * 2u);
                                            let _e585 = ((1u + _e583) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e590 = global_5.member[_e538.member_1][_e585];
                                            let _e592 = ((_e583 + 2u) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_3586_ = true;
                                                break;
                                            }
                                            let _e597 = global_5.member[_e538.member_1][_e592];
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = select(_e135, _e620, (_e620 > _e135));
                                            let _e626 = select(_e135, _e621, (_e621 > _e135));
                                            let _e628 = select(_e135, _e622, (_e622 > _e135));
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
                                            let _e760 = global_5.member[_e538.member_1][0u];
                                            let _e764 = global_5.member[_e538.member_1][2u];
                                            let _e768 = global_5.member[_e538.member_1][4u];
                                            let _e772 = global_5.member[_e538.member_1][6u];
                                            let _e784 = (((_e764 >> bitcast<u32>(22i)) | ((_e768 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e772 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e785 = (_e760 & 268435455u);
                                            let _e786 = (_e784 & 268435455u);
                                            let _e789 = ((_e760 >> bitcast<u32>(28u)) & 7u);
                                            let _e797 = ((_e760 >> bitcast<u32>(31i)) | (((_e784 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e798 = (_e789 != 0u);
                                            if (_e789 == 0u) {
                                                phi_2698_ = _e785;
                                            } else {
                                                if (_e789 == 7u) {
                                                    phi_2697_ = 2147483648u;
                                                } else {
                                                    phi_2697_ = ((2147483648u | (_e789 << bitcast<u32>(28u))) | (_e786 & 268435455u));
                                                }
                                                let _e807 = phi_2697_;
                                                phi_2698_ = _e807;
                                            }
                                            let _e809 = phi_2698_;
                                            if _e798 {
                                                let _e810 = (_e789 != 7u);
                                                if _e810 {
                                                    phi_2708_ = (_e786 + _e789);
                                                } else {
                                                    phi_2708_ = u32();
                                                }
                                                let _e813 = phi_2708_;
                                                phi_2710_ = _e813;
                                                phi_2711_ = select(true, false, _e810);
                                            } else {
                                                phi_2710_ = u32();
                                                phi_2711_ = true;
                                            }
                                            let _e816 = phi_2710_;
                                            let _e818 = phi_2711_;
                                            if (_e797 == 0u) {
                                                phi_2732_ = (_e785 + select(0u, 1u, !(_e798)));
                                            } else {
                                                if (_e797 == 7u) {
                                                    phi_2731_ = 2147483648u;
                                                } else {
                                                    phi_2731_ = ((2147483648u | (_e797 << bitcast<u32>(28u))) | (select(_e816, _e786, _e818) & 268435455u));
                                                }
                                                let _e831 = phi_2731_;
                                                phi_2732_ = _e831;
                                            }
                                            let _e833 = phi_2732_;
                                            phi_2736_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e661), (_e538.member.member.x + _e683), (_e538.member.member_1.x - _e700), (_e538.member.member_1.x - _e722)), vec4<f32>((_e538.member.member.y + _e670), (_e538.member.member.y + _e687), (_e538.member.member_1.y - _e709), (_e538.member.member_1.y - _e726)), vec4<f32>((_e538.member.member.z + _e679), (_e538.member.member.z + _e691), (_e538.member.member_1.z - _e718), (_e538.member.member_1.z - _e730))), type_50(type_29((_e538.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e538.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e809), type_50(type_29((_e538.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e538.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e833));
                                        }
                                        let _e838 = phi_2736_;
                                        let _e850 = ((_e838.member[0].x - _e327) * _e332);
                                        let _e851 = ((_e838.member[0].y - _e327) * _e332);
                                        let _e852 = ((_e838.member[0].z - _e328) * _e332);
                                        let _e853 = ((_e838.member[0].w - _e328) * _e332);
                                        let _e863 = ((_e838.member[1].x - _e365) * _e370);
                                        let _e864 = ((_e838.member[1].y - _e365) * _e370);
                                        let _e865 = ((_e838.member[1].z - _e366) * _e370);
                                        let _e866 = ((_e838.member[1].w - _e366) * _e370);
                                        let _e876 = ((_e838.member[2].x - _e403) * _e408);
                                        let _e877 = ((_e838.member[2].y - _e403) * _e408);
                                        let _e878 = ((_e838.member[2].z - _e404) * _e408);
                                        let _e879 = ((_e838.member[2].w - _e404) * _e408);
                                        let _e881 = select(_e878, _e876, (_e876 < _e878));
                                        let _e883 = select(_e879, _e877, (_e877 < _e879));
                                        let _e885 = select(_e878, _e876, (_e876 > _e878));
                                        let _e887 = select(_e879, _e877, (_e877 > _e879));
                                        let _e889 = select(_e852, _e850, (_e850 < _e852));
                                        let _e891 = select(_e853, _e851, (_e851 < _e853));
                                        let _e893 = select(_e865, _e863, (_e863 < _e865));
                                        let _e895 = select(_e866, _e864, (_e864 < _e866));
                                        let _e897 = select(_e893, _e889, (_e889 > _e893));
                                        let _e899 = select(_e895, _e891, (_e891 > _e895));
                                        let _e901 = select(_e881, _e897, (_e897 > _e881));
                                        let _e903 = select(_e883, _e899, (_e899 > _e883));
                                        let _e905 = select(_e852, _e850, (_e850 > _e852));
                                        let _e907 = select(_e853, _e851, (_e851 > _e853));
                                        let _e909 = select(_e865, _e863, (_e863 > _e865));
                                        let _e911 = select(_e866, _e864, (_e864 > _e866));
                                        let _e913 = select(_e909, _e905, (_e905 < _e909));
                                        let _e915 = select(_e911, _e907, (_e907 < _e911));
                                        let _e920 = -(_e881);
                                        let _e921 = -(_e883);
                                        let _e928 = (select(_e885, _e913, (_e913 < _e885)) + (select(_e920, _e885, (_e885 > _e920)) * 0.0000019073523f));
                                        let _e929 = (select(_e887, _e915, (_e915 < _e887)) + (select(_e921, _e887, (_e887 > _e921)) * 0.0000019073523f));
                                        let _e931 = select(_e455, _e901, (_e901 > _e455));
                                        let _e933 = select(_e455, _e903, (_e903 > _e455));
                                        let _e938 = (_e931 <= select(_e499.member_1, _e928, (_e928 < _e499.member_1)));
                                        let _e939 = (_e933 <= select(_e499.member_1, _e929, (_e929 < _e499.member_1)));
                                        let _e940 = (_e931 <= _e933);
                                        if _e938 {
                                            if _e939 {
                                                if _e940 {
                                                    phi_3080_ = _e838.member_2;
                                                } else {
                                                    phi_3080_ = _e838.member_1;
                                                }
                                                let _e944 = phi_3080_;
                                                let _e966 = (_e542 % 128u);
                                                let _e967 = (_e966 < 128u);
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_8[_e966] = _e944.member_1;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_7[_e966] = _e944.member.member.x;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_6[_e966] = _e944.member.member.y;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_5[_e966] = _e944.member.member.z;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_4[_e966] = _e944.member.member_1.x;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_3[_e966] = _e944.member.member_1.y;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_2[_e966] = _e944.member.member_1.z;
                                                if _e967 {
                                                } else {
                                                    phi_3586_ = true;
                                                    break;
                                                }
                                                local_9[_e966] = select(_e933, _e931, (_e931 > _e933));
                                                if _e940 {
                                                    phi_3157_ = _e838.member_1;
                                                } else {
                                                    phi_3157_ = _e838.member_2;
                                                }
                                                let _e980 = phi_3157_;
                                                phi_3158_ = _e980;
                                                phi_3159_ = (_e542 + 1u);
                                            } else {
                                                phi_3158_ = type_50();
                                                phi_3159_ = u32();
                                            }
                                            let _e982 = phi_3158_;
                                            let _e984 = phi_3159_;
                                            phi_3161_ = _e982;
                                            phi_3162_ = _e984;
                                            phi_3163_ = select(true, false, _e939);
                                        } else {
                                            phi_3161_ = type_50();
                                            phi_3162_ = u32();
                                            phi_3163_ = true;
                                        }
                                        let _e987 = phi_3161_;
                                        let _e989 = phi_3162_;
                                        let _e991 = phi_3163_;
                                        if _e991 {
                                            if _e938 {
                                                phi_3172_ = _e838.member_1;
                                            } else {
                                                phi_3172_ = _e838.member_2;
                                            }
                                            let _e995 = phi_3172_;
                                            phi_3177_ = _e995;
                                            phi_3178_ = select(_e939, true, _e938);
                                        } else {
                                            phi_3177_ = _e987;
                                            phi_3178_ = _e540;
                                        }
                                        let _e998 = phi_3177_;
                                        let _e1000 = phi_3178_;
                                        phi_3590_ = _e497;
                                        phi_3180_ = _e499;
                                        phi_3181_ = _e998;
                                        phi_3182_ = _e1000;
                                        phi_3183_ = select(_e989, _e542, _e991);
                                    }
                                    let _e1592 = phi_3590_;
                                    let _e1594 = phi_3180_;
                                    let _e1596 = phi_3181_;
                                    let _e1598 = phi_3182_;
                                    let _e1600 = phi_3183_;
                                    phi_3589_ = _e1592;
                                    phi_3184_ = _e1594;
                                    phi_3185_ = _e1596;
                                    phi_3186_ = (_e503 - 1u);
                                    phi_3187_ = _e1598;
                                    phi_3188_ = _e1600;
                                } else {
                                    phi_3589_ = _e497;
                                    phi_3184_ = _e499;
                                    phi_3185_ = _e538;
                                    phi_3186_ = _e503;
                                    phi_3187_ = _e540;
                                    phi_3188_ = _e542;
                                }
                                let _e1602 = phi_3589_;
                                let _e1604 = phi_3184_;
                                let _e1606 = phi_3185_;
                                let _e1608 = phi_3186_;
                                let _e1610 = phi_3187_;
                                let _e1612 = phi_3188_;
                                phi_3588_ = _e1602;
                                phi_3189_ = _e1604;
                                phi_3190_ = _e1606;
                                phi_3191_ = _e1608;
                                phi_3192_ = _e1610;
                                phi_3193_ = _e1612;
                            } else {
                                phi_3588_ = _e497;
                                phi_3189_ = type_33();
                                phi_3190_ = type_50();
                                phi_3191_ = u32();
                                phi_3192_ = bool();
                                phi_3193_ = u32();
                            }
                            let _e1614 = phi_3588_;
                            let _e1616 = phi_3189_;
                            let _e1618 = phi_3190_;
                            let _e1620 = phi_3191_;
                            let _e1622 = phi_3192_;
                            let _e1624 = phi_3193_;
                            phi_3587_ = _e1614;
                            phi_840_ = _e1616;
                            phi_843_ = _e1618;
                            phi_845_ = _e1620;
                            phi_847_ = _e1622;
                            phi_849_ = _e1624;
                            phi_3194_ = _e511;
                        } else {
                            phi_3587_ = _e497;
                            phi_840_ = type_33();
                            phi_843_ = type_50();
                            phi_845_ = u32();
                            phi_847_ = bool();
                            phi_849_ = u32();
                            phi_3194_ = false;
                        }
                        let _e1626 = phi_3587_;
                        let _e1628 = phi_840_;
                        let _e1630 = phi_843_;
                        let _e1632 = phi_845_;
                        let _e1634 = phi_847_;
                        let _e1636 = phi_849_;
                        let _e1638 = phi_3194_;
                        continue;
                        continuing {
                            phi_3450_ = _e1626;
                            phi_839_ = _e1628;
                            phi_842_ = _e1630;
                            phi_844_ = _e1632;
                            phi_846_ = _e1634;
                            phi_848_ = _e1636;
                            phi_3586_ = _e1626;
                            break if !(_e1638);
                        }
                    }
                    let _e1641 = phi_3586_;
                    if _e1641 {
                        break;
                    }
                    let _e1643 = local_10;
                    if (_e1643.member.member_3 != 4294967295u) {
                        let _e1648 = -(_e422);
                        let _e1649 = (_e1648 / 3i);
                        let _e1656 = bitcast<f32>((bitcast<u32>((_e1649 + 127i)) << bitcast<u32>(23i)));
                        let _e1664 = (((_e1643.member.member * _e1656) * _e1656) * bitcast<f32>((bitcast<u32>(((_e1648 - (2i * _e1649)) + 127i)) << bitcast<u32>(23i))));
                        let _e1666 = select(340282350000000000000000000000000000000f, _e1664, (_e1664 < 340282350000000000000000000000000000000f));
                        phi_3246_ = type_21(select(-340282350000000000000000000000000000000f, _e1666, (_e1666 > -340282350000000000000000000000000000000f)), _e1643.member.member_1, _e1643.member.member_2, _e1643.member.member_3);
                    } else {
                        phi_3246_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1673 = phi_3246_;
                    if _e143 {
                    } else {
                        break;
                    }
                    global_6.member[_e141] = _e1673;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
