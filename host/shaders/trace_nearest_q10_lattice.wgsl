struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_40 {
    member: array<array<type_24, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var phi_402_: i32;
    var phi_403_: i32;
    var phi_413_: bool;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_426_: bool;
    var phi_431_: u32;
    var phi_443_: i32;
    var phi_463_: i32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_613_: f32;
    var phi_619_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_4471_: bool;
    var phi_4327_: f32;
    var phi_913_: type_51;
    var phi_916_: u32;
    var phi_918_: bool;
    var phi_920_: u32;
    var phi_931_: bool;
    var phi_1018_: type_51;
    var phi_1019_: bool;
    var phi_1020_: u32;
    var phi_3200_: u32;
    var phi_3206_: u32;
    var phi_3460_: u32;
    var phi_3461_: u32;
    var phi_3471_: u32;
    var phi_3473_: u32;
    var phi_3474_: bool;
    var phi_3494_: u32;
    var phi_3495_: u32;
    var phi_3499_: type_52;
    var phi_3844_: type_51;
    var phi_3921_: type_51;
    var phi_3922_: type_51;
    var phi_3923_: u32;
    var phi_3925_: type_51;
    var phi_3926_: u32;
    var phi_3927_: bool;
    var phi_3936_: type_51;
    var phi_3941_: type_51;
    var phi_3942_: bool;
    var phi_4468_: bool;
    var phi_4411_: f32;
    var phi_1039_: type_8;
    var phi_1040_: type_8;
    var phi_1063_: type_8;
    var phi_1104_: u32;
    var phi_1110_: u32;
    var phi_1120_: u32;
    var phi_1136_: u32;
    var phi_1169_: u32;
    var phi_1175_: u32;
    var phi_1602_: u32;
    var phi_1620_: u32;
    var phi_1638_: u32;
    var phi_1658_: u32;
    var phi_1676_: u32;
    var phi_1694_: u32;
    var phi_1714_: u32;
    var phi_1732_: u32;
    var phi_1750_: u32;
    var phi_1328_: u32;
    var phi_1343_: u32;
    var phi_1353_: u32;
    var phi_1373_: u32;
    var phi_1393_: u32;
    var phi_1419_: u32;
    var phi_1434_: u32;
    var phi_1444_: u32;
    var phi_1464_: u32;
    var phi_1484_: u32;
    var phi_1510_: u32;
    var phi_1525_: u32;
    var phi_1535_: u32;
    var phi_1555_: u32;
    var phi_1575_: u32;
    var phi_1199_: u32;
    var phi_1242_: u32;
    var phi_1285_: u32;
    var phi_1756_: array<array<f32, 3>, 3>;
    var phi_1874_: bool;
    var phi_1903_: bool;
    var phi_2304_: f32;
    var phi_2305_: f32;
    var phi_2306_: f32;
    var phi_2307_: f32;
    var phi_2308_: vec3<f32>;
    var phi_2309_: vec3<f32>;
    var phi_2310_: vec3<f32>;
    var phi_2311_: vec3<f32>;
    var phi_2342_: bool;
    var phi_2351_: vec3<f32>;
    var phi_2518_: bool;
    var phi_2542_: f32;
    var phi_2543_: f32;
    var phi_2566_: type_24;
    var phi_2568_: type_24;
    var phi_2569_: bool;
    var phi_2573_: type_24;
    var phi_2574_: type_24;
    var phi_2575_: type_24;
    var phi_2576_: bool;
    var phi_2580_: type_24;
    var phi_2581_: bool;
    var phi_2582_: type_24;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2585_: type_24;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2595_: type_24;
    var phi_2596_: bool;
    var phi_2600_: type_24;
    var phi_2612_: type_8;
    var phi_2615_: type_24;
    var phi_2613_: type_8;
    var phi_2638_: type_8;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2692_: type_24;
    var phi_2616_: type_24;
    var phi_4439_: bool;
    var phi_4866_: f32;
    var phi_4865_: f32;
    var phi_4631_: bool;
    var phi_4864_: f32;
    var phi_4630_: bool;
    var phi_4863_: f32;
    var phi_4629_: bool;
    var phi_4775_: f32;
    var phi_4628_: bool;
    var phi_4740_: f32;
    var phi_4637_: bool;
    var phi_3944_: type_51;
    var phi_3945_: bool;
    var phi_3946_: u32;
    var phi_4739_: f32;
    var phi_4636_: bool;
    var phi_3947_: type_51;
    var phi_3948_: u32;
    var phi_3949_: bool;
    var phi_3950_: u32;
    var phi_4738_: f32;
    var phi_4635_: bool;
    var phi_3951_: type_51;
    var phi_3952_: u32;
    var phi_3953_: bool;
    var phi_3954_: u32;
    var phi_4737_: f32;
    var phi_4634_: bool;
    var phi_914_: type_51;
    var phi_917_: u32;
    var phi_919_: bool;
    var phi_921_: u32;
    var phi_3955_: bool;
    var phi_4633_: bool;
    var phi_3962_: type_8;
    var phi_3963_: type_8;
    var phi_3986_: type_8;
    var phi_4052_: type_24;
    var phi_4730_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_3.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_4.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_4.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_4.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_4.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_4.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_4.member[_e153].member_1;
                    let _e216 = (bitcast<u32>(_e214) & 2147483647u);
                    let _e223 = global_4.member[_e153].member_3;
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && ((bitcast<u32>(_e223) & 2147483647u) <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_402_;
                        phi_403_ = _e246;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e248 = phi_403_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e172 == _e204);
                    }
                    let _e252 = phi_413_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_423_ = _e254;
                        phi_424_ = _e254;
                        phi_426_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e258 = phi_423_;
                    let _e260 = phi_424_;
                    let _e262 = phi_426_;
                    if _e262 {
                        phi_431_ = (_e260 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e266 = phi_431_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_443_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_463_ = -126i;
                    } else {
                        phi_463_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_463_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_4.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_481_ = _e305[0];
                    } else {
                        phi_481_ = _e305[1];
                    }
                    let _e310 = phi_481_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_487_ = _e305[2];
                    } else {
                        phi_487_ = _e310;
                    }
                    let _e314 = phi_487_;
                    let _e316 = ((_e314 * _e278) * _e284);
                    let _e317 = global_4.member[_e153].member_2;
                    if _e306 {
                        phi_498_ = _e317[0];
                    } else {
                        phi_498_ = _e317[1];
                    }
                    let _e321 = phi_498_;
                    if _e311 {
                        phi_504_ = _e317[2];
                    } else {
                        phi_504_ = _e321;
                    }
                    let _e324 = phi_504_;
                    let _e326 = ((_e324 * _e295) * _e301);
                    let _e330 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e330 {
                        let _e334 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e334, (_e334 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e338 = phi_527_;
                    let _e339 = (_e316 + _e338);
                    let _e340 = (_e316 - _e338);
                    let _e341 = select(_e326, 0f, _e330);
                    if _e330 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e326);
                    }
                    let _e344 = phi_538_;
                    let _e345 = (_e266 == 0u);
                    if _e345 {
                        phi_547_ = _e305[0];
                    } else {
                        phi_547_ = _e305[1];
                    }
                    let _e349 = phi_547_;
                    let _e350 = (_e266 == 2u);
                    if _e350 {
                        phi_553_ = _e305[2];
                    } else {
                        phi_553_ = _e349;
                    }
                    let _e353 = phi_553_;
                    let _e355 = ((_e353 * _e278) * _e284);
                    if _e345 {
                        phi_564_ = _e317[0];
                    } else {
                        phi_564_ = _e317[1];
                    }
                    let _e359 = phi_564_;
                    if _e350 {
                        phi_570_ = _e317[2];
                    } else {
                        phi_570_ = _e359;
                    }
                    let _e362 = phi_570_;
                    let _e364 = ((_e362 * _e295) * _e301);
                    let _e368 = (bitcast<f32>((bitcast<u32>(_e364) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e368 {
                        let _e372 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e372, (_e372 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e376 = phi_593_;
                    let _e377 = (_e355 + _e376);
                    let _e378 = (_e355 - _e376);
                    let _e379 = select(_e364, 0f, _e368);
                    if _e368 {
                        phi_604_ = 38685626000000000000000000f;
                    } else {
                        phi_604_ = (1f / _e364);
                    }
                    let _e382 = phi_604_;
                    let _e383 = (_e268 == 0u);
                    if _e383 {
                        phi_613_ = _e305[0];
                    } else {
                        phi_613_ = _e305[1];
                    }
                    let _e387 = phi_613_;
                    let _e388 = (_e268 == 2u);
                    if _e388 {
                        phi_619_ = _e305[2];
                    } else {
                        phi_619_ = _e387;
                    }
                    let _e391 = phi_619_;
                    let _e393 = ((_e391 * _e278) * _e284);
                    if _e383 {
                        phi_630_ = _e317[0];
                    } else {
                        phi_630_ = _e317[1];
                    }
                    let _e397 = phi_630_;
                    if _e388 {
                        phi_636_ = _e317[2];
                    } else {
                        phi_636_ = _e397;
                    }
                    let _e400 = phi_636_;
                    let _e402 = ((_e400 * _e295) * _e301);
                    let _e406 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e406 {
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_659_ = select(0.00000000000011368684f, _e410, (_e410 > 0.00000000000011368684f));
                    } else {
                        phi_659_ = 0f;
                    }
                    let _e414 = phi_659_;
                    let _e415 = (_e393 + _e414);
                    let _e416 = (_e393 - _e414);
                    let _e417 = select(_e402, 0f, _e406);
                    if _e406 {
                        phi_670_ = 38685626000000000000000000f;
                    } else {
                        phi_670_ = (1f / _e402);
                    }
                    let _e420 = phi_670_;
                    let _e423 = bitcast<f32>((bitcast<u32>(_e316) & 2147483647u));
                    let _e426 = bitcast<f32>((bitcast<u32>(_e355) & 2147483647u));
                    let _e428 = select(_e426, _e423, (_e423 > _e426));
                    let _e431 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e434 = (_e135 + _e248);
                    if (_e229 && (select(_e431, _e428, (_e428 > _e431)) <= 1099511600000f)) {
                        let _e437 = (_e434 / 3i);
                        let _e444 = bitcast<f32>((bitcast<u32>((_e437 + 127i)) << bitcast<u32>(23i)));
                        let _e451 = bitcast<f32>((bitcast<u32>(((_e434 - (2i * _e437)) + 127i)) << bitcast<u32>(23i)));
                        let _e452 = (((_e214 * _e444) * _e444) * _e451);
                        let _e454 = select(340282350000000000000000000000000000000f, _e452, (_e452 < 340282350000000000000000000000000000000f));
                        let _e459 = (((_e223 * _e444) * _e444) * _e451);
                        let _e461 = select(340282350000000000000000000000000000000f, _e459, (_e459 < 340282350000000000000000000000000000000f));
                        phi_770_ = select(-340282350000000000000000000000000000000f, _e461, (_e461 > -340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e454, (_e454 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_770_ = 0f;
                        phi_771_ = 1f;
                    }
                    let _e465 = phi_770_;
                    let _e467 = phi_771_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e470 = (_e267 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e266 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    let _e482 = (_e268 % 3u);
                    let _e483 = (_e482 < 3u);
                    if _e483 {
                    } else {
                        break;
                    }
                    let _e485 = local_1[_e482];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e494 = local[_e476];
                    if _e483 {
                    } else {
                        break;
                    }
                    let _e498 = local[_e482];
                    phi_4471_ = false;
                    phi_4327_ = _e465;
                    phi_913_ = type_51(type_28(vec4<f32>((f32(_e473) * _e147), (f32(_e479) * _e147), (f32(_e485) * _e147), 0f), vec4<f32>((f32(_e490) * _e147), (f32(_e494) * _e147), (f32(_e498) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_916_ = ((3u * _e96) + 1u);
                    phi_918_ = (_e467 <= _e465);
                    phi_920_ = 0u;
                    loop {
                        let _e508 = phi_4471_;
                        let _e510 = phi_4327_;
                        let _e512 = phi_913_;
                        let _e514 = phi_916_;
                        let _e516 = phi_918_;
                        let _e518 = phi_920_;
                        if _e516 {
                            phi_931_ = true;
                        } else {
                            phi_931_ = (_e518 > 0u);
                        }
                        let _e521 = phi_931_;
                        if _e521 {
                            let _e522 = (_e514 > 0u);
                            if _e522 {
                                if _e516 {
                                    phi_1018_ = _e512;
                                    phi_1019_ = _e516;
                                    phi_1020_ = _e518;
                                } else {
                                    let _e523 = (_e518 - 1u);
                                    let _e524 = (_e523 % 128u);
                                    let _e525 = (_e524 < 128u);
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e527 = local_7[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e529 = local_6[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e531 = local_5[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e533 = local_4[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e535 = local_3[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e537 = local_2[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e542 = local_8[_e524];
                                    if _e525 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e545 = local_10[_e524];
                                    phi_1018_ = type_51(type_28(vec4<f32>(_e527, _e529, _e531, 0f), vec4<f32>(_e533, _e535, _e537, 0f)), _e542);
                                    phi_1019_ = (_e545 <= _e510);
                                    phi_1020_ = _e523;
                                }
                                let _e548 = phi_1018_;
                                let _e550 = phi_1019_;
                                let _e552 = phi_1020_;
                                if _e550 {
                                    let _e557 = (_e548.member_1 & 268435455u);
                                    if ((_e548.member_1 & 2147483648u) != 0u) {
                                        phi_4468_ = _e508;
                                        phi_4411_ = _e510;
                                        phi_1039_ = type_8(0u, ((_e548.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1016 = phi_4468_;
                                            let _e1018 = phi_4411_;
                                            let _e1020 = phi_1039_;
                                            if (_e1020.member < _e1020.member_1) {
                                                phi_1040_ = type_8((_e1020.member + 1u), _e1020.member_1);
                                                phi_1063_ = type_8(1u, _e1020.member);
                                            } else {
                                                phi_1040_ = _e1020;
                                                phi_1063_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1033 = phi_1040_;
                                            let _e1035 = phi_1063_;
                                            let _e1039 = (bitcast<i32>(_e1035.member) != 0i);
                                            if _e1039 {
                                                let _e1044 = (_e548.member.member_1.x - _e548.member.member.x);
                                                let _e1047 = (_e548.member.member_1.y - _e548.member.member.y);
                                                let _e1050 = (_e548.member.member_1.z - _e548.member.member.z);
                                                let _e1052 = select(_e1047, _e1044, (_e1044 > _e1047));
                                                let _e1054 = select(_e1050, _e1052, (_e1052 > _e1050));
                                                let _e1056 = (_e1054 < (1024f * _e147));
                                                if _e1056 {
                                                    phi_1104_ = 0u;
                                                } else {
                                                    phi_1104_ = select(2u, 1u, (_e1054 < (2097152f * _e147)));
                                                }
                                                let _e1061 = phi_1104_;
                                                switch bitcast<i32>(_e1061) {
                                                    case 0: {
                                                        phi_1110_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1110_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1110_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1110_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1064 = phi_1110_;
                                                switch bitcast<i32>(_e1061) {
                                                    case 0: {
                                                        phi_1120_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1120_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1120_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1120_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1071 = phi_1120_;
                                                let _e1073 = ((_e557 + (_e1035.member_1 * ((3u * _e1064) + 1u))) + (3u * _e1071));
                                                let _e1074 = (_e1073 < _e99);
                                                if _e1074 {
                                                    if _e1074 {
                                                    } else {
                                                        phi_4775_ = _e1018;
                                                        phi_4628_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_5.member[_e1073];
                                                    phi_1136_ = _e1076;
                                                } else {
                                                    phi_1136_ = 4294967295u;
                                                }
                                                let _e1078 = phi_1136_;
                                                if _e1056 {
                                                    phi_1169_ = 0u;
                                                } else {
                                                    phi_1169_ = select(2u, 1u, (_e1054 < (2097152f * _e147)));
                                                }
                                                let _e1083 = phi_1169_;
                                                switch bitcast<i32>(_e1083) {
                                                    case 0: {
                                                        phi_1175_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1175_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1175_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1175_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1086 = phi_1175_;
                                                let _e1090 = (_e557 + (_e1035.member_1 * ((3u * _e1086) + 1u)));
                                                switch bitcast<i32>(_e1083) {
                                                    case 0: {
                                                        let _e1356 = (_e1090 < _e99);
                                                        if _e1356 {
                                                            if _e1356 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1358 = global_5.member[_e1090];
                                                            phi_1199_ = _e1358;
                                                        } else {
                                                            phi_1199_ = 0u;
                                                        }
                                                        let _e1360 = phi_1199_;
                                                        let _e1362 = ((10u * _e267) & 31u);
                                                        let _e1371 = ((10u * _e266) & 31u);
                                                        let _e1380 = ((10u * _e268) & 31u);
                                                        let _e1389 = (_e1090 + 1u);
                                                        let _e1390 = (_e1389 < _e99);
                                                        if _e1390 {
                                                            if _e1390 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1392 = global_5.member[_e1389];
                                                            phi_1242_ = _e1392;
                                                        } else {
                                                            phi_1242_ = 0u;
                                                        }
                                                        let _e1394 = phi_1242_;
                                                        let _e1417 = (_e1090 + 2u);
                                                        let _e1418 = (_e1417 < _e99);
                                                        if _e1418 {
                                                            if _e1418 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1420 = global_5.member[_e1417];
                                                            phi_1285_ = _e1420;
                                                        } else {
                                                            phi_1285_ = 0u;
                                                        }
                                                        let _e1422 = phi_1285_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1360 >> bitcast<u32>(_e1362)) & 1023u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1360 >> bitcast<u32>(_e1371)) & 1023u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1360 >> bitcast<u32>(_e1380)) & 1023u))) * _e147))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1394 >> bitcast<u32>(_e1362)) & 1023u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1394 >> bitcast<u32>(_e1371)) & 1023u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1394 >> bitcast<u32>(_e1380)) & 1023u))) * _e147))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1362)) & 1023u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1371)) & 1023u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>(((_e1422 >> bitcast<u32>(_e1380)) & 1023u))) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1179 = (_e1090 < _e99);
                                                        if _e1179 {
                                                            if _e1179 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1181 = global_5.member[_e1090];
                                                            phi_1328_ = _e1181;
                                                        } else {
                                                            phi_1328_ = 0u;
                                                        }
                                                        let _e1183 = phi_1328_;
                                                        let _e1184 = (_e1090 + 1u);
                                                        let _e1185 = (_e1184 < _e99);
                                                        if _e1185 {
                                                            if _e1185 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1187 = global_5.member[_e1184];
                                                            phi_1343_ = _e1187;
                                                        } else {
                                                            phi_1343_ = 0u;
                                                        }
                                                        let _e1189 = phi_1343_;
                                                        let _e1190 = (_e267 == 1u);
                                                        if _e1190 {
                                                            phi_1353_ = ((_e1183 >> bitcast<u32>(21i)) | (_e1189 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1353_ = (_e1189 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1199 = phi_1353_;
                                                        let _e1206 = (_e266 == 1u);
                                                        if _e1206 {
                                                            phi_1373_ = ((_e1183 >> bitcast<u32>(21i)) | (_e1189 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1373_ = (_e1189 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1215 = phi_1373_;
                                                        let _e1222 = (_e268 == 1u);
                                                        if _e1222 {
                                                            phi_1393_ = ((_e1183 >> bitcast<u32>(21i)) | (_e1189 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1393_ = (_e1189 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1231 = phi_1393_;
                                                        let _e1239 = (_e1090 + 2u);
                                                        let _e1240 = (_e1239 < _e99);
                                                        if _e1240 {
                                                            if _e1240 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1242 = global_5.member[_e1239];
                                                            phi_1419_ = _e1242;
                                                        } else {
                                                            phi_1419_ = 0u;
                                                        }
                                                        let _e1244 = phi_1419_;
                                                        let _e1245 = (_e1090 + 3u);
                                                        let _e1246 = (_e1245 < _e99);
                                                        if _e1246 {
                                                            if _e1246 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1248 = global_5.member[_e1245];
                                                            phi_1434_ = _e1248;
                                                        } else {
                                                            phi_1434_ = 0u;
                                                        }
                                                        let _e1250 = phi_1434_;
                                                        if _e1190 {
                                                            phi_1444_ = ((_e1244 >> bitcast<u32>(21i)) | (_e1250 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1444_ = (_e1250 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1259 = phi_1444_;
                                                        if _e1206 {
                                                            phi_1464_ = ((_e1244 >> bitcast<u32>(21i)) | (_e1250 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1464_ = (_e1250 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1274 = phi_1464_;
                                                        if _e1222 {
                                                            phi_1484_ = ((_e1244 >> bitcast<u32>(21i)) | (_e1250 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1484_ = (_e1250 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1289 = phi_1484_;
                                                        let _e1297 = (_e1090 + 4u);
                                                        let _e1298 = (_e1297 < _e99);
                                                        if _e1298 {
                                                            if _e1298 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1300 = global_5.member[_e1297];
                                                            phi_1510_ = _e1300;
                                                        } else {
                                                            phi_1510_ = 0u;
                                                        }
                                                        let _e1302 = phi_1510_;
                                                        let _e1303 = (_e1090 + 5u);
                                                        let _e1304 = (_e1303 < _e99);
                                                        if _e1304 {
                                                            if _e1304 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1306 = global_5.member[_e1303];
                                                            phi_1525_ = _e1306;
                                                        } else {
                                                            phi_1525_ = 0u;
                                                        }
                                                        let _e1308 = phi_1525_;
                                                        if _e1190 {
                                                            phi_1535_ = ((_e1302 >> bitcast<u32>(21i)) | (_e1308 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1535_ = (_e1308 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1317 = phi_1535_;
                                                        if _e1206 {
                                                            phi_1555_ = ((_e1302 >> bitcast<u32>(21i)) | (_e1308 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1555_ = (_e1308 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1332 = phi_1555_;
                                                        if _e1222 {
                                                            phi_1575_ = ((_e1302 >> bitcast<u32>(21i)) | (_e1308 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1575_ = (_e1308 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1347 = phi_1575_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1199, _e1183, _e306) & 2097151u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1215, _e1183, _e345) & 2097151u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1231, _e1183, _e383) & 2097151u))) * _e147))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1259, _e1244, _e306) & 2097151u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1274, _e1244, _e345) & 2097151u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1289, _e1244, _e383) & 2097151u))) * _e147))), array<f32, 3>((_e548.member.member.x + (f32(bitcast<i32>((select(_e1317, _e1302, _e306) & 2097151u))) * _e147)), (_e548.member.member.y + (f32(bitcast<i32>((select(_e1332, _e1302, _e345) & 2097151u))) * _e147)), (_e548.member.member.z + (f32(bitcast<i32>((select(_e1347, _e1302, _e383) & 2097151u))) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1092 = (_e1090 + _e267);
                                                        let _e1093 = (_e1092 < _e99);
                                                        if _e1093 {
                                                            if _e1093 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1095 = global_5.member[_e1092];
                                                            phi_1602_ = _e1095;
                                                        } else {
                                                            phi_1602_ = 0u;
                                                        }
                                                        let _e1097 = phi_1602_;
                                                        let _e1101 = (_e1090 + _e266);
                                                        let _e1102 = (_e1101 < _e99);
                                                        if _e1102 {
                                                            if _e1102 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1104 = global_5.member[_e1101];
                                                            phi_1620_ = _e1104;
                                                        } else {
                                                            phi_1620_ = 0u;
                                                        }
                                                        let _e1106 = phi_1620_;
                                                        let _e1110 = (_e1090 + _e268);
                                                        let _e1111 = (_e1110 < _e99);
                                                        if _e1111 {
                                                            if _e1111 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1113 = global_5.member[_e1110];
                                                            phi_1638_ = _e1113;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e1115 = phi_1638_;
                                                        let _e1120 = (_e1090 + 3u);
                                                        let _e1121 = (_e1120 + _e267);
                                                        let _e1122 = (_e1121 < _e99);
                                                        if _e1122 {
                                                            if _e1122 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1124 = global_5.member[_e1121];
                                                            phi_1658_ = _e1124;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e1126 = phi_1658_;
                                                        let _e1130 = (_e1120 + _e266);
                                                        let _e1131 = (_e1130 < _e99);
                                                        if _e1131 {
                                                            if _e1131 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1133 = global_5.member[_e1130];
                                                            phi_1676_ = _e1133;
                                                        } else {
                                                            phi_1676_ = 0u;
                                                        }
                                                        let _e1135 = phi_1676_;
                                                        let _e1139 = (_e1120 + _e268);
                                                        let _e1140 = (_e1139 < _e99);
                                                        if _e1140 {
                                                            if _e1140 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1142 = global_5.member[_e1139];
                                                            phi_1694_ = _e1142;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1144 = phi_1694_;
                                                        let _e1149 = (_e1090 + 6u);
                                                        let _e1150 = (_e1149 + _e267);
                                                        let _e1151 = (_e1150 < _e99);
                                                        if _e1151 {
                                                            if _e1151 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1153 = global_5.member[_e1150];
                                                            phi_1714_ = _e1153;
                                                        } else {
                                                            phi_1714_ = 0u;
                                                        }
                                                        let _e1155 = phi_1714_;
                                                        let _e1159 = (_e1149 + _e266);
                                                        let _e1160 = (_e1159 < _e99);
                                                        if _e1160 {
                                                            if _e1160 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1162 = global_5.member[_e1159];
                                                            phi_1732_ = _e1162;
                                                        } else {
                                                            phi_1732_ = 0u;
                                                        }
                                                        let _e1164 = phi_1732_;
                                                        let _e1168 = (_e1149 + _e268);
                                                        let _e1169 = (_e1168 < _e99);
                                                        if _e1169 {
                                                            if _e1169 {
                                                            } else {
                                                                phi_4775_ = _e1018;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1171 = global_5.member[_e1168];
                                                            phi_1750_ = _e1171;
                                                        } else {
                                                            phi_1750_ = 0u;
                                                        }
                                                        let _e1173 = phi_1750_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1097)) * _e147), (f32(bitcast<i32>(_e1106)) * _e147), (f32(bitcast<i32>(_e1115)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1126)) * _e147), (f32(bitcast<i32>(_e1135)) * _e147), (f32(bitcast<i32>(_e1144)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e1155)) * _e147), (f32(bitcast<i32>(_e1164)) * _e147), (f32(bitcast<i32>(_e1173)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1756_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1447 = phi_1756_;
                                                let _e1454 = (_e1447[0][2] - _e393);
                                                let _e1457 = (((_e1447[0][0] - _e316) * _e417) - (_e1454 * _e341));
                                                let _e1460 = (((_e1447[0][1] - _e355) * _e417) - (_e1454 * _e379));
                                                let _e1467 = (_e1447[1][2] - _e393);
                                                let _e1470 = (((_e1447[1][0] - _e316) * _e417) - (_e1467 * _e341));
                                                let _e1473 = (((_e1447[1][1] - _e355) * _e417) - (_e1467 * _e379));
                                                let _e1480 = (_e1447[2][2] - _e393);
                                                let _e1483 = (((_e1447[2][0] - _e316) * _e417) - (_e1480 * _e341));
                                                let _e1486 = (((_e1447[2][1] - _e355) * _e417) - (_e1480 * _e379));
                                                let _e1487 = (_e1483 * _e1473);
                                                let _e1488 = (_e1486 * _e1470);
                                                let _e1489 = (_e1457 * _e1486);
                                                let _e1490 = (_e1460 * _e1483);
                                                let _e1491 = (_e1470 * _e1460);
                                                let _e1492 = (_e1473 * _e1457);
                                                let _e1497 = (((_e1487 >= _e1488) && (_e1489 >= _e1490)) && (_e1491 >= _e1492));
                                                if (_e1497 || (((_e1487 <= _e1488) && (_e1489 <= _e1490)) && (_e1491 <= _e1492))) {
                                                    let _e1504 = select(-1f, 1f, _e1497);
                                                    let _e1506 = ((_e1487 - _e1488) * _e1504);
                                                    let _e1508 = select(0f, _e1506, (_e1506 > 0f));
                                                    let _e1510 = ((_e1489 - _e1490) * _e1504);
                                                    let _e1512 = select(0f, _e1510, (_e1510 > 0f));
                                                    let _e1514 = ((_e1491 - _e1492) * _e1504);
                                                    let _e1516 = select(0f, _e1514, (_e1514 > 0f));
                                                    let _e1518 = ((_e1508 + _e1512) + _e1516);
                                                    if (_e1518 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2585_ = type_24();
                                                        phi_2586_ = true;
                                                        phi_2587_ = false;
                                                    } else {
                                                        let _e1521 = select(_e1470, _e1457, (_e1457 < _e1470));
                                                        if (select(_e1483, _e1521, (_e1521 < _e1483)) > 0f) {
                                                            phi_1874_ = true;
                                                        } else {
                                                            let _e1526 = select(_e1470, _e1457, (_e1457 > _e1470));
                                                            phi_1874_ = (select(_e1483, _e1526, (_e1526 > _e1483)) < 0f);
                                                        }
                                                        let _e1531 = phi_1874_;
                                                        if _e1531 {
                                                            phi_2582_ = type_24();
                                                            phi_2583_ = true;
                                                            phi_2584_ = false;
                                                        } else {
                                                            let _e1533 = select(_e1473, _e1460, (_e1460 < _e1473));
                                                            if (select(_e1486, _e1533, (_e1533 < _e1486)) > 0f) {
                                                                phi_1903_ = true;
                                                            } else {
                                                                let _e1538 = select(_e1473, _e1460, (_e1460 > _e1473));
                                                                phi_1903_ = (select(_e1486, _e1538, (_e1538 > _e1486)) < 0f);
                                                            }
                                                            let _e1543 = phi_1903_;
                                                            if _e1543 {
                                                                phi_2580_ = type_24();
                                                                phi_2581_ = false;
                                                            } else {
                                                                let _e1545 = select(_e1447[1][0], _e1447[0][0], (_e1447[0][0] < _e1447[1][0]));
                                                                let _e1549 = select(_e1447[1][0], _e1447[0][0], (_e1447[0][0] > _e1447[1][0]));
                                                                let _e1553 = select(_e1447[1][1], _e1447[0][1], (_e1447[0][1] < _e1447[1][1]));
                                                                let _e1557 = select(_e1447[1][1], _e1447[0][1], (_e1447[0][1] > _e1447[1][1]));
                                                                let _e1561 = select(_e1447[1][2], _e1447[0][2], (_e1447[0][2] < _e1447[1][2]));
                                                                let _e1565 = select(_e1447[1][2], _e1447[0][2], (_e1447[0][2] > _e1447[1][2]));
                                                                let _e1570 = ((select(_e1447[2][0], _e1545, (_e1545 < _e1447[2][0])) - _e339) * _e344);
                                                                let _e1571 = ((select(_e1447[2][0], _e1549, (_e1549 > _e1447[2][0])) - _e340) * _e344);
                                                                let _e1574 = ((select(_e1447[2][1], _e1553, (_e1553 < _e1447[2][1])) - _e377) * _e382);
                                                                let _e1575 = ((select(_e1447[2][1], _e1557, (_e1557 > _e1447[2][1])) - _e378) * _e382);
                                                                let _e1578 = ((select(_e1447[2][2], _e1561, (_e1561 < _e1447[2][2])) - _e415) * _e420);
                                                                let _e1579 = ((select(_e1447[2][2], _e1565, (_e1565 > _e1447[2][2])) - _e416) * _e420);
                                                                let _e1581 = select(_e1579, _e1578, (_e1578 < _e1579));
                                                                let _e1583 = select(_e1579, _e1578, (_e1578 > _e1579));
                                                                let _e1585 = select(_e1571, _e1570, (_e1570 < _e1571));
                                                                let _e1587 = select(_e1575, _e1574, (_e1574 < _e1575));
                                                                let _e1589 = select(_e1587, _e1585, (_e1585 > _e1587));
                                                                let _e1591 = select(_e1581, _e1589, (_e1589 > _e1581));
                                                                let _e1593 = select(_e1571, _e1570, (_e1570 > _e1571));
                                                                let _e1595 = select(_e1575, _e1574, (_e1574 > _e1575));
                                                                let _e1597 = select(_e1595, _e1593, (_e1593 < _e1595));
                                                                let _e1599 = select(_e1583, _e1597, (_e1597 < _e1583));
                                                                let _e1600 = -(_e1581);
                                                                let _e1606 = select(_e467, _e1591, (_e1591 > _e467));
                                                                if (_e1606 > (_e1599 + (select(_e1600, _e1583, (_e1583 > _e1600)) * 0.0000019073523f))) {
                                                                    phi_2575_ = type_24();
                                                                    phi_2576_ = true;
                                                                } else {
                                                                    let _e1608 = (_e1606 > _e1018);
                                                                    if _e1608 {
                                                                        phi_2574_ = type_24();
                                                                    } else {
                                                                        let _e1609 = vec3<f32>(_e1447[0][0], _e1447[0][1], _e1447[0][2]);
                                                                        let _e1610 = vec3<f32>(_e1447[1][0], _e1447[1][1], _e1447[1][2]);
                                                                        let _e1611 = vec3<f32>(_e1447[2][0], _e1447[2][1], _e1447[2][2]);
                                                                        let _e1612 = (_e1447[1][0] - _e1447[0][0]);
                                                                        let _e1613 = (_e1447[1][1] - _e1447[0][1]);
                                                                        let _e1614 = (_e1447[1][2] - _e1447[0][2]);
                                                                        let _e1615 = vec3<f32>(_e1612, _e1613, _e1614);
                                                                        let _e1616 = (_e1447[2][0] - _e1447[1][0]);
                                                                        let _e1617 = (_e1447[2][1] - _e1447[1][1]);
                                                                        let _e1618 = (_e1447[2][2] - _e1447[1][2]);
                                                                        let _e1619 = vec3<f32>(_e1616, _e1617, _e1618);
                                                                        let _e1620 = (_e1447[0][0] - _e1447[2][0]);
                                                                        let _e1621 = (_e1447[0][1] - _e1447[2][1]);
                                                                        let _e1622 = (_e1447[0][2] - _e1447[2][2]);
                                                                        let _e1623 = vec3<f32>(_e1620, _e1621, _e1622);
                                                                        let _e1626 = bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u));
                                                                        let _e1629 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                                        let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                        let _e1634 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
                                                                        let _e1636 = select(_e1634, _e1631, (_e1631 > _e1634));
                                                                        let _e1639 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                        let _e1642 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                        let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                        let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                                        let _e1652 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                        let _e1655 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                        let _e1657 = select(_e1655, _e1652, (_e1652 > _e1655));
                                                                        let _e1660 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                                        let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                                        let _e1664 = select(_e1649, _e1636, (_e1636 > _e1649));
                                                                        let _e1666 = select(_e1662, _e1664, (_e1664 > _e1662));
                                                                        if (_e1636 == _e1666) {
                                                                            phi_2304_ = _e1473;
                                                                            phi_2305_ = _e1470;
                                                                            phi_2306_ = _e1460;
                                                                            phi_2307_ = _e1457;
                                                                            phi_2308_ = _e1609;
                                                                            phi_2309_ = _e1623;
                                                                            phi_2310_ = _e1619;
                                                                            phi_2311_ = _e1615;
                                                                        } else {
                                                                            let _e1668 = (_e1649 == _e1666);
                                                                            let _e1673 = vec3(_e1668);
                                                                            phi_2304_ = select(_e1460, _e1486, _e1668);
                                                                            phi_2305_ = select(_e1457, _e1483, _e1668);
                                                                            phi_2306_ = select(_e1486, _e1473, _e1668);
                                                                            phi_2307_ = select(_e1483, _e1470, _e1668);
                                                                            phi_2308_ = select(_e1611, _e1610, _e1673);
                                                                            phi_2309_ = select(_e1619, _e1615, _e1673);
                                                                            phi_2310_ = select(_e1615, _e1623, _e1673);
                                                                            phi_2311_ = select(_e1623, _e1619, _e1673);
                                                                        }
                                                                        let _e1679 = phi_2304_;
                                                                        let _e1681 = phi_2305_;
                                                                        let _e1683 = phi_2306_;
                                                                        let _e1685 = phi_2307_;
                                                                        let _e1687 = phi_2308_;
                                                                        let _e1689 = phi_2309_;
                                                                        let _e1691 = phi_2310_;
                                                                        let _e1693 = phi_2311_;
                                                                        let _e1700 = ((_e1691.y * _e1689.z) - (_e1689.y * _e1691.z));
                                                                        let _e1705 = ((_e1691.z * _e1689.x) - (_e1689.z * _e1691.x));
                                                                        let _e1708 = ((_e1691.x * _e1689.y) - (_e1689.x * _e1691.y));
                                                                        if (_e1508 >= _e1512) {
                                                                            phi_2342_ = select(true, false, (_e1508 >= _e1516));
                                                                        } else {
                                                                            phi_2342_ = true;
                                                                        }
                                                                        let _e1713 = phi_2342_;
                                                                        if _e1713 {
                                                                            phi_2351_ = select(_e1611, _e1610, vec3((_e1512 >= _e1516)));
                                                                        } else {
                                                                            phi_2351_ = _e1609;
                                                                        }
                                                                        let _e1718 = phi_2351_;
                                                                        let _e1723 = (((_e1700 * _e341) + (_e1705 * _e379)) + (_e1708 * _e417));
                                                                        let _e1734 = (((_e1700 * (_e1718.x - _e316)) + (_e1705 * (_e1718.y - _e355))) + (_e1708 * (_e1718.z - _e393)));
                                                                        let _e1736 = (_e1681 - _e1685);
                                                                        let _e1737 = (_e1679 - _e1683);
                                                                        let _e1745 = (-(((_e1685 * _e1736) + (_e1683 * _e1737))) / ((_e1736 * _e1736) + (_e1737 * _e1737)));
                                                                        let _e1747 = select(1f, _e1745, (_e1745 < 1f));
                                                                        let _e1749 = select(0f, _e1747, (_e1747 > 0f));
                                                                        let _e1762 = ((_e1687.x + (_e1693.x * _e1749)) - _e316);
                                                                        let _e1763 = ((_e1687.y + (_e1693.y * _e1749)) - _e355);
                                                                        let _e1764 = ((_e1687.z + (_e1693.z * _e1749)) - _e393);
                                                                        let _e1765 = (_e1764 / _e417);
                                                                        let _e1777 = bitcast<f32>((bitcast<u32>(_e1762) & 2147483647u));
                                                                        let _e1780 = bitcast<f32>((bitcast<u32>(_e1763) & 2147483647u));
                                                                        let _e1782 = select(_e1780, _e1777, (_e1777 > _e1780));
                                                                        let _e1785 = bitcast<f32>((bitcast<u32>(_e1764) & 2147483647u));
                                                                        let _e1787 = select(_e1785, _e1782, (_e1782 > _e1785));
                                                                        let _e1793 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                        let _e1796 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                        let _e1798 = select(_e1796, _e1793, (_e1793 > _e1796));
                                                                        let _e1801 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1700 * _e1762) + (_e1705 * _e1763)) + (_e1708 * _e1764)) - _e1734)) & 2147483647u)) <= ((0.0000009536743f * select(_e1666, _e1787, (_e1787 > _e1666))) * select(_e1801, _e1798, (_e1798 > _e1801)))) {
                                                                            let _e1811 = bitcast<f32>((bitcast<u32>(_e1691.x) & 2147483647u));
                                                                            let _e1814 = bitcast<f32>((bitcast<u32>(_e1691.y) & 2147483647u));
                                                                            let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                            let _e1819 = bitcast<f32>((bitcast<u32>(_e1691.z) & 2147483647u));
                                                                            let _e1825 = bitcast<f32>((bitcast<u32>(_e1689.x) & 2147483647u));
                                                                            let _e1828 = bitcast<f32>((bitcast<u32>(_e1689.y) & 2147483647u));
                                                                            let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                            let _e1833 = bitcast<f32>((bitcast<u32>(_e1689.z) & 2147483647u));
                                                                            phi_2518_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u)) > ((0.0000038146973f * select(_e1819, _e1816, (_e1816 > _e1819))) * select(_e1833, _e1830, (_e1830 > _e1833)))));
                                                                        } else {
                                                                            phi_2518_ = true;
                                                                        }
                                                                        let _e1840 = phi_2518_;
                                                                        if _e1840 {
                                                                            let _e1851 = ((((_e1700 * (_e1762 - (_e341 * _e1765))) + (_e1705 * (_e1763 - (_e379 * _e1765)))) + (_e1708 * (_e1764 - _e1764))) / _e1723);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u)) <= _e1666) {
                                                                                phi_2542_ = (_e1765 + _e1851);
                                                                            } else {
                                                                                phi_2542_ = _e1765;
                                                                            }
                                                                            let _e1858 = phi_2542_;
                                                                            phi_2543_ = _e1858;
                                                                        } else {
                                                                            phi_2543_ = (_e1734 / _e1723);
                                                                        }
                                                                        let _e1860 = phi_2543_;
                                                                        let _e1862 = select(_e1599, _e1860, (_e1860 < _e1599));
                                                                        let _e1864 = select(_e1591, _e1862, (_e1862 > _e1591));
                                                                        if (_e1864 >= _e467) {
                                                                            let _e1866 = (_e1864 <= _e1018);
                                                                            if _e1866 {
                                                                                let _e1867 = (1f / _e1518);
                                                                                phi_2566_ = type_24(_e1864, (_e1512 * _e1867), (_e1516 * _e1867), _e1078);
                                                                            } else {
                                                                                phi_2566_ = type_24();
                                                                            }
                                                                            let _e1872 = phi_2566_;
                                                                            phi_2568_ = _e1872;
                                                                            phi_2569_ = select(true, false, _e1866);
                                                                        } else {
                                                                            phi_2568_ = type_24();
                                                                            phi_2569_ = true;
                                                                        }
                                                                        let _e1875 = phi_2568_;
                                                                        let _e1877 = phi_2569_;
                                                                        if _e1877 {
                                                                            phi_2573_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2573_ = _e1875;
                                                                        }
                                                                        let _e1879 = phi_2573_;
                                                                        phi_2574_ = _e1879;
                                                                    }
                                                                    let _e1881 = phi_2574_;
                                                                    phi_2575_ = _e1881;
                                                                    phi_2576_ = _e1608;
                                                                }
                                                                let _e1883 = phi_2575_;
                                                                let _e1885 = phi_2576_;
                                                                phi_2580_ = _e1883;
                                                                phi_2581_ = _e1885;
                                                            }
                                                            let _e1887 = phi_2580_;
                                                            let _e1889 = phi_2581_;
                                                            phi_2582_ = _e1887;
                                                            phi_2583_ = _e1543;
                                                            phi_2584_ = _e1889;
                                                        }
                                                        let _e1891 = phi_2582_;
                                                        let _e1893 = phi_2583_;
                                                        let _e1895 = phi_2584_;
                                                        phi_2585_ = _e1891;
                                                        phi_2586_ = _e1893;
                                                        phi_2587_ = _e1895;
                                                    }
                                                    let _e1897 = phi_2585_;
                                                    let _e1899 = phi_2586_;
                                                    let _e1901 = phi_2587_;
                                                    phi_2595_ = _e1897;
                                                    phi_2596_ = select(_e1901, true, _e1899);
                                                } else {
                                                    phi_2595_ = type_24();
                                                    phi_2596_ = true;
                                                }
                                                let _e1904 = phi_2595_;
                                                let _e1906 = phi_2596_;
                                                if _e1906 {
                                                    phi_2600_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2600_ = _e1904;
                                                }
                                                let _e1908 = phi_2600_;
                                                if (_e1908.member_3 != 4294967295u) {
                                                    if (_e1078 != 4294967295u) {
                                                        phi_2612_ = type_8(0u, 8u);
                                                        phi_2615_ = _e1908;
                                                        loop {
                                                            let _e1913 = phi_2612_;
                                                            let _e1915 = phi_2615_;
                                                            if (_e1913.member < _e1913.member_1) {
                                                                phi_2613_ = type_8((_e1913.member + 1u), _e1913.member_1);
                                                                phi_2638_ = type_8(1u, _e1913.member);
                                                            } else {
                                                                phi_2613_ = _e1913;
                                                                phi_2638_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1928 = phi_2613_;
                                                            let _e1930 = phi_2638_;
                                                            let _e1934 = (bitcast<i32>(_e1930.member) != 0i);
                                                            if _e1934 {
                                                                let _e1935 = (_e1930.member_1 < 8u);
                                                                if _e1935 {
                                                                } else {
                                                                    phi_4439_ = true;
                                                                    break;
                                                                }
                                                                let _e1940 = local_9[_e1930.member_1].member;
                                                                if (_e1915.member < _e1940) {
                                                                    phi_2671_ = true;
                                                                } else {
                                                                    let _e1942 = local_9[_e1930.member_1].member;
                                                                    if (_e1915.member == _e1942) {
                                                                        let _e1947 = local_9[_e1930.member_1].member_3;
                                                                        phi_2670_ = (_e1915.member_3 < _e1947);
                                                                    } else {
                                                                        phi_2670_ = false;
                                                                    }
                                                                    let _e1950 = phi_2670_;
                                                                    phi_2671_ = _e1950;
                                                                }
                                                                let _e1952 = phi_2671_;
                                                                if _e1952 {
                                                                    if _e1935 {
                                                                    } else {
                                                                        phi_4439_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1953 = local_9[_e1930.member_1];
                                                                    local_9[_e1930.member_1] = type_24(_e1915.member, _e1915.member_1, _e1915.member_2, _e1915.member_3);
                                                                    phi_2692_ = type_24(_e1953.member, _e1953.member_1, _e1953.member_2, _e1953.member_3);
                                                                } else {
                                                                    phi_2692_ = _e1915;
                                                                }
                                                                let _e1964 = phi_2692_;
                                                                phi_2616_ = _e1964;
                                                            } else {
                                                                phi_2616_ = type_24();
                                                            }
                                                            let _e1966 = phi_2616_;
                                                            continue;
                                                            continuing {
                                                                phi_2612_ = _e1928;
                                                                phi_2615_ = _e1966;
                                                                phi_4439_ = _e1016;
                                                                break if !(_e1934);
                                                            }
                                                        }
                                                        let _e1969 = phi_4439_;
                                                        phi_4775_ = _e1018;
                                                        phi_4628_ = _e1969;
                                                        if _e1969 {
                                                            break;
                                                        }
                                                        let _e1972 = local_9[7u].member_3;
                                                        if (_e1972 != 4294967295u) {
                                                            let _e1976 = local_9[7u].member;
                                                            phi_4866_ = _e1976;
                                                        } else {
                                                            phi_4866_ = _e1018;
                                                        }
                                                        let _e1978 = phi_4866_;
                                                        phi_4865_ = _e1978;
                                                        phi_4631_ = _e1969;
                                                    } else {
                                                        phi_4865_ = _e1018;
                                                        phi_4631_ = _e1016;
                                                    }
                                                    let _e1980 = phi_4865_;
                                                    let _e1982 = phi_4631_;
                                                    phi_4864_ = _e1980;
                                                    phi_4630_ = _e1982;
                                                } else {
                                                    phi_4864_ = _e1018;
                                                    phi_4630_ = _e1016;
                                                }
                                                let _e1984 = phi_4864_;
                                                let _e1986 = phi_4630_;
                                                phi_4863_ = _e1984;
                                                phi_4629_ = _e1986;
                                            } else {
                                                phi_4863_ = _e1018;
                                                phi_4629_ = _e1016;
                                            }
                                            let _e1988 = phi_4863_;
                                            let _e1990 = phi_4629_;
                                            continue;
                                            continuing {
                                                phi_4468_ = _e1990;
                                                phi_4411_ = _e1988;
                                                phi_1039_ = _e1033;
                                                phi_4775_ = _e1988;
                                                phi_4628_ = _e1990;
                                                break if !(_e1039);
                                            }
                                        }
                                        let _e1993 = phi_4775_;
                                        let _e1995 = phi_4628_;
                                        phi_4633_ = _e1995;
                                        if _e1995 {
                                            break;
                                        }
                                        phi_4740_ = _e1993;
                                        phi_4637_ = _e1995;
                                        phi_3944_ = _e548;
                                        phi_3945_ = false;
                                        phi_3946_ = _e552;
                                    } else {
                                        if (_e548.member_1 >= _e96) {
                                            phi_3499_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e548.member_1 < _e96) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e565 = ((1u + _e267) % 4u);
                                            if (_e565 < 4u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e570 = global_3.member[_e548.member_1][_e565];
                                            let _e572 = (_e570 >> bitcast<u32>(11u));
                                            let _e574 = ((1u + _e266) % 4u);
                                            if (_e574 < 4u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e579 = global_3.member[_e548.member_1][_e574];
                                            let _e581 = (_e579 >> bitcast<u32>(11u));
                                            let _e583 = ((1u + _e268) % 4u);
                                            if (_e583 < 4u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e588 = global_3.member[_e548.member_1][_e583];
                                            let _e590 = (_e588 >> bitcast<u32>(11u));
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.x - _e548.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.y - _e548.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = (bitcast<f32>((bitcast<u32>((_e548.member.member_1.z - _e548.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e617 = select(_e147, _e613, (_e613 > _e147));
                                            let _e619 = select(_e147, _e614, (_e614 > _e147));
                                            let _e621 = select(_e147, _e615, (_e615 > _e147));
                                            let _e646 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e617));
                                            let _e651 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e654 = bitcast<f32>((_e646 & bitcast<u32>(_e651)));
                                            let _e655 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e619));
                                            let _e660 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                            let _e664 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e621));
                                            let _e669 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                            let _e676 = bitcast<f32>((_e646 & bitcast<u32>(~(_e651))));
                                            let _e680 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                            let _e684 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                            let _e685 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e617));
                                            let _e690 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e693 = bitcast<f32>((_e685 & bitcast<u32>(_e690)));
                                            let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e619));
                                            let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                            let _e703 = bitcast<u32>((f32(bitcast<i32>((_e590 & 1023u))) * _e621));
                                            let _e708 = (bitcast<i32>((_e590 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                            let _e715 = bitcast<f32>((_e685 & bitcast<u32>(~(_e690))));
                                            let _e719 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                            let _e723 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                            let _e724 = (_e548.member.member.x + _e654);
                                            let _e725 = (_e548.member.member.y + _e663);
                                            let _e726 = (_e548.member.member.z + _e672);
                                            let _e729 = (_e548.member.member_1.x - _e693);
                                            let _e730 = (_e548.member.member_1.y - _e702);
                                            let _e731 = (_e548.member.member_1.z - _e711);
                                            let _e750 = (_e729 - _e724);
                                            let _e751 = (_e730 - _e725);
                                            let _e752 = (_e731 - _e726);
                                            let _e754 = select(_e751, _e750, (_e750 > _e751));
                                            let _e756 = select(_e752, _e754, (_e754 > _e752));
                                            if (_e756 < (1024f * _e147)) {
                                                phi_3200_ = 0u;
                                            } else {
                                                phi_3200_ = select(2u, 1u, (_e756 < (2097152f * _e147)));
                                            }
                                            let _e763 = phi_3200_;
                                            switch bitcast<i32>(_e763) {
                                                case 0: {
                                                    phi_3206_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3206_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3206_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3206_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e766 = phi_3206_;
                                            let _e772 = global_3.member[_e548.member_1][0u];
                                            let _e776 = global_3.member[_e548.member_1][1u];
                                            let _e780 = global_3.member[_e548.member_1][2u];
                                            let _e784 = global_3.member[_e548.member_1][3u];
                                            let _e796 = (((_e776 >> bitcast<u32>(22i)) | ((_e780 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e784 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e797 = (_e772 & 268435455u);
                                            let _e798 = (_e796 & 268435455u);
                                            let _e801 = ((_e772 >> bitcast<u32>(28u)) & 7u);
                                            let _e809 = ((_e772 >> bitcast<u32>(31i)) | (((_e796 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e810 = (_e801 != 0u);
                                            if (_e801 == 0u) {
                                                phi_3461_ = _e797;
                                            } else {
                                                if (_e801 == 7u) {
                                                    phi_3460_ = 2147483648u;
                                                } else {
                                                    phi_3460_ = ((2147483648u | (_e801 << bitcast<u32>(28u))) | (_e798 & 268435455u));
                                                }
                                                let _e819 = phi_3460_;
                                                phi_3461_ = _e819;
                                            }
                                            let _e821 = phi_3461_;
                                            if _e810 {
                                                let _e822 = (_e801 != 7u);
                                                if _e822 {
                                                    phi_3471_ = (_e798 + (_e801 * ((3u * _e766) + 1u)));
                                                } else {
                                                    phi_3471_ = u32();
                                                }
                                                let _e826 = phi_3471_;
                                                phi_3473_ = _e826;
                                                phi_3474_ = select(true, false, _e822);
                                            } else {
                                                phi_3473_ = u32();
                                                phi_3474_ = true;
                                            }
                                            let _e829 = phi_3473_;
                                            let _e831 = phi_3474_;
                                            if (_e809 == 0u) {
                                                phi_3495_ = (_e797 + select(0u, 1u, !(_e810)));
                                            } else {
                                                if (_e809 == 7u) {
                                                    phi_3494_ = 2147483648u;
                                                } else {
                                                    phi_3494_ = ((2147483648u | (_e809 << bitcast<u32>(28u))) | (select(_e829, _e798, _e831) & 268435455u));
                                                }
                                                let _e844 = phi_3494_;
                                                phi_3495_ = _e844;
                                            }
                                            let _e846 = phi_3495_;
                                            phi_3499_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e724, (_e548.member.member.x + _e676), _e729, (_e548.member.member_1.x - _e715)), vec4<f32>(_e725, (_e548.member.member.y + _e680), _e730, (_e548.member.member_1.y - _e719)), vec4<f32>(_e726, (_e548.member.member.z + _e684), _e731, (_e548.member.member_1.z - _e723))), type_51(type_28((_e548.member.member + vec4<f32>(_e654, _e663, _e672, 0f)), (_e548.member.member_1 - vec4<f32>(_e693, _e702, _e711, 0f))), _e821), type_51(type_28((_e548.member.member + vec4<f32>(_e676, _e680, _e684, 0f)), (_e548.member.member_1 - vec4<f32>(_e715, _e719, _e723, 0f))), _e846));
                                        }
                                        let _e851 = phi_3499_;
                                        let _e862 = ((_e851.member[0].x - _e339) * _e344);
                                        let _e863 = ((_e851.member[0].y - _e339) * _e344);
                                        let _e864 = ((_e851.member[0].z - _e340) * _e344);
                                        let _e865 = ((_e851.member[0].w - _e340) * _e344);
                                        let _e875 = ((_e851.member[1].x - _e377) * _e382);
                                        let _e876 = ((_e851.member[1].y - _e377) * _e382);
                                        let _e877 = ((_e851.member[1].z - _e378) * _e382);
                                        let _e878 = ((_e851.member[1].w - _e378) * _e382);
                                        let _e888 = ((_e851.member[2].x - _e415) * _e420);
                                        let _e889 = ((_e851.member[2].y - _e415) * _e420);
                                        let _e890 = ((_e851.member[2].z - _e416) * _e420);
                                        let _e891 = ((_e851.member[2].w - _e416) * _e420);
                                        let _e893 = select(_e890, _e888, (_e888 < _e890));
                                        let _e895 = select(_e891, _e889, (_e889 < _e891));
                                        let _e897 = select(_e890, _e888, (_e888 > _e890));
                                        let _e899 = select(_e891, _e889, (_e889 > _e891));
                                        let _e901 = select(_e864, _e862, (_e862 < _e864));
                                        let _e903 = select(_e865, _e863, (_e863 < _e865));
                                        let _e905 = select(_e877, _e875, (_e875 < _e877));
                                        let _e907 = select(_e878, _e876, (_e876 < _e878));
                                        let _e909 = select(_e905, _e901, (_e901 > _e905));
                                        let _e911 = select(_e907, _e903, (_e903 > _e907));
                                        let _e913 = select(_e893, _e909, (_e909 > _e893));
                                        let _e915 = select(_e895, _e911, (_e911 > _e895));
                                        let _e917 = select(_e864, _e862, (_e862 > _e864));
                                        let _e919 = select(_e865, _e863, (_e863 > _e865));
                                        let _e921 = select(_e877, _e875, (_e875 > _e877));
                                        let _e923 = select(_e878, _e876, (_e876 > _e878));
                                        let _e925 = select(_e921, _e917, (_e917 < _e921));
                                        let _e927 = select(_e923, _e919, (_e919 < _e923));
                                        let _e932 = -(_e893);
                                        let _e933 = -(_e895);
                                        let _e940 = (select(_e897, _e925, (_e925 < _e897)) + (select(_e932, _e897, (_e897 > _e932)) * 0.0000019073523f));
                                        let _e941 = (select(_e899, _e927, (_e927 < _e899)) + (select(_e933, _e899, (_e899 > _e933)) * 0.0000019073523f));
                                        let _e943 = select(_e467, _e913, (_e913 > _e467));
                                        let _e945 = select(_e467, _e915, (_e915 > _e467));
                                        let _e950 = (_e943 <= select(_e510, _e940, (_e940 < _e510)));
                                        let _e951 = (_e945 <= select(_e510, _e941, (_e941 < _e510)));
                                        let _e952 = (_e943 <= _e945);
                                        if _e950 {
                                            if _e951 {
                                                if _e952 {
                                                    phi_3844_ = _e851.member_2;
                                                } else {
                                                    phi_3844_ = _e851.member_1;
                                                }
                                                let _e956 = phi_3844_;
                                                let _e978 = (_e552 % 128u);
                                                let _e979 = (_e978 < 128u);
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_8[_e978] = _e956.member_1;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_7[_e978] = _e956.member.member.x;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_6[_e978] = _e956.member.member.y;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_5[_e978] = _e956.member.member.z;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_4[_e978] = _e956.member.member_1.x;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_3[_e978] = _e956.member.member_1.y;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_2[_e978] = _e956.member.member_1.z;
                                                if _e979 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_10[_e978] = select(_e945, _e943, (_e943 > _e945));
                                                if _e952 {
                                                    phi_3921_ = _e851.member_1;
                                                } else {
                                                    phi_3921_ = _e851.member_2;
                                                }
                                                let _e992 = phi_3921_;
                                                phi_3922_ = _e992;
                                                phi_3923_ = (_e552 + 1u);
                                            } else {
                                                phi_3922_ = type_51();
                                                phi_3923_ = u32();
                                            }
                                            let _e994 = phi_3922_;
                                            let _e996 = phi_3923_;
                                            phi_3925_ = _e994;
                                            phi_3926_ = _e996;
                                            phi_3927_ = select(true, false, _e951);
                                        } else {
                                            phi_3925_ = type_51();
                                            phi_3926_ = u32();
                                            phi_3927_ = true;
                                        }
                                        let _e999 = phi_3925_;
                                        let _e1001 = phi_3926_;
                                        let _e1003 = phi_3927_;
                                        if _e1003 {
                                            if _e950 {
                                                phi_3936_ = _e851.member_1;
                                            } else {
                                                phi_3936_ = _e851.member_2;
                                            }
                                            let _e1007 = phi_3936_;
                                            phi_3941_ = _e1007;
                                            phi_3942_ = select(_e951, true, _e950);
                                        } else {
                                            phi_3941_ = _e999;
                                            phi_3942_ = _e550;
                                        }
                                        let _e1010 = phi_3941_;
                                        let _e1012 = phi_3942_;
                                        phi_4740_ = _e510;
                                        phi_4637_ = _e508;
                                        phi_3944_ = _e1010;
                                        phi_3945_ = _e1012;
                                        phi_3946_ = select(_e1001, _e552, _e1003);
                                    }
                                    let _e1997 = phi_4740_;
                                    let _e1999 = phi_4637_;
                                    let _e2001 = phi_3944_;
                                    let _e2003 = phi_3945_;
                                    let _e2005 = phi_3946_;
                                    phi_4739_ = _e1997;
                                    phi_4636_ = _e1999;
                                    phi_3947_ = _e2001;
                                    phi_3948_ = (_e514 - 1u);
                                    phi_3949_ = _e2003;
                                    phi_3950_ = _e2005;
                                } else {
                                    phi_4739_ = _e510;
                                    phi_4636_ = _e508;
                                    phi_3947_ = _e548;
                                    phi_3948_ = _e514;
                                    phi_3949_ = _e550;
                                    phi_3950_ = _e552;
                                }
                                let _e2007 = phi_4739_;
                                let _e2009 = phi_4636_;
                                let _e2011 = phi_3947_;
                                let _e2013 = phi_3948_;
                                let _e2015 = phi_3949_;
                                let _e2017 = phi_3950_;
                                phi_4738_ = _e2007;
                                phi_4635_ = _e2009;
                                phi_3951_ = _e2011;
                                phi_3952_ = _e2013;
                                phi_3953_ = _e2015;
                                phi_3954_ = _e2017;
                            } else {
                                phi_4738_ = _e510;
                                phi_4635_ = _e508;
                                phi_3951_ = type_51();
                                phi_3952_ = u32();
                                phi_3953_ = bool();
                                phi_3954_ = u32();
                            }
                            let _e2019 = phi_4738_;
                            let _e2021 = phi_4635_;
                            let _e2023 = phi_3951_;
                            let _e2025 = phi_3952_;
                            let _e2027 = phi_3953_;
                            let _e2029 = phi_3954_;
                            phi_4737_ = _e2019;
                            phi_4634_ = _e2021;
                            phi_914_ = _e2023;
                            phi_917_ = _e2025;
                            phi_919_ = _e2027;
                            phi_921_ = _e2029;
                            phi_3955_ = _e522;
                        } else {
                            phi_4737_ = _e510;
                            phi_4634_ = _e508;
                            phi_914_ = type_51();
                            phi_917_ = u32();
                            phi_919_ = bool();
                            phi_921_ = u32();
                            phi_3955_ = false;
                        }
                        let _e2031 = phi_4737_;
                        let _e2033 = phi_4634_;
                        let _e2035 = phi_914_;
                        let _e2037 = phi_917_;
                        let _e2039 = phi_919_;
                        let _e2041 = phi_921_;
                        let _e2043 = phi_3955_;
                        continue;
                        continuing {
                            phi_4471_ = _e2033;
                            phi_4327_ = _e2031;
                            phi_913_ = _e2035;
                            phi_916_ = _e2037;
                            phi_918_ = _e2039;
                            phi_920_ = _e2041;
                            phi_4633_ = _e2033;
                            break if !(_e2043);
                        }
                    }
                    let _e2046 = phi_4633_;
                    if _e2046 {
                        break;
                    }
                    phi_3962_ = type_8(0u, 8u);
                    loop {
                        let _e2048 = phi_3962_;
                        if (_e2048.member < _e2048.member_1) {
                            phi_3963_ = type_8((_e2048.member + 1u), _e2048.member_1);
                            phi_3986_ = type_8(1u, _e2048.member);
                        } else {
                            phi_3963_ = _e2048;
                            phi_3986_ = type_8(0u, type_8().member_1);
                        }
                        let _e2061 = phi_3963_;
                        let _e2063 = phi_3986_;
                        let _e2067 = (bitcast<i32>(_e2063.member) != 0i);
                        if _e2067 {
                            let _e2068 = (_e2063.member_1 < 8u);
                            if _e2068 {
                            } else {
                                phi_4730_ = true;
                                break;
                            }
                            let _e2070 = local_9[_e2063.member_1];
                            if (_e2070.member_3 != 4294967295u) {
                                let _e2076 = -(_e434);
                                let _e2077 = (_e2076 / 3i);
                                let _e2084 = bitcast<f32>((bitcast<u32>((_e2077 + 127i)) << bitcast<u32>(23i)));
                                let _e2092 = (((_e2070.member * _e2084) * _e2084) * bitcast<f32>((bitcast<u32>(((_e2076 - (2i * _e2077)) + 127i)) << bitcast<u32>(23i))));
                                let _e2094 = select(340282350000000000000000000000000000000f, _e2092, (_e2092 < 340282350000000000000000000000000000000f));
                                phi_4052_ = type_24(select(-340282350000000000000000000000000000000f, _e2094, (_e2094 > -340282350000000000000000000000000000000f)), _e2070.member_1, _e2070.member_2, _e2070.member_3);
                            } else {
                                phi_4052_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2099 = phi_4052_;
                            if _e2068 {
                            } else {
                                phi_4730_ = true;
                                break;
                            }
                            local_9[_e2063.member_1] = type_24(_e2099.member, _e2099.member_1, _e2099.member_2, _e2099.member_3);
                        }
                        continue;
                        continuing {
                            phi_3962_ = _e2061;
                            phi_4730_ = _e2046;
                            break if !(_e2067);
                        }
                    }
                    let _e2107 = phi_4730_;
                    if _e2107 {
                        break;
                    }
                    let _e2108 = local_9;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = array<type_24, 8>(type_24(_e2108[0].member, _e2108[0].member_1, _e2108[0].member_2, _e2108[0].member_3), type_24(_e2108[1].member, _e2108[1].member_1, _e2108[1].member_2, _e2108[1].member_3), type_24(_e2108[2].member, _e2108[2].member_1, _e2108[2].member_2, _e2108[2].member_3), type_24(_e2108[3].member, _e2108[3].member_1, _e2108[3].member_2, _e2108[3].member_3), type_24(_e2108[4].member, _e2108[4].member_1, _e2108[4].member_2, _e2108[4].member_3), type_24(_e2108[5].member, _e2108[5].member_1, _e2108[5].member_2, _e2108[5].member_3), type_24(_e2108[6].member, _e2108[6].member_1, _e2108[6].member_2, _e2108[6].member_3), type_24(_e2108[7].member, _e2108[7].member_1, _e2108[7].member_2, _e2108[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
