struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_36 {
    member: array<array<type_20, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_24,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var local_9: array<type_20, 8>;
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
    var phi_2566_: type_20;
    var phi_2568_: type_20;
    var phi_2569_: bool;
    var phi_2573_: type_20;
    var phi_2574_: type_20;
    var phi_2575_: type_20;
    var phi_2576_: bool;
    var phi_2580_: type_20;
    var phi_2581_: bool;
    var phi_2582_: type_20;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2585_: type_20;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2595_: type_20;
    var phi_2596_: bool;
    var phi_2600_: type_20;
    var phi_2612_: type_8;
    var phi_2615_: type_20;
    var phi_2613_: type_8;
    var phi_2638_: type_8;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2692_: type_20;
    var phi_2616_: type_20;
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
    var phi_4052_: type_20;
    var phi_4730_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_4.member));
            let _e96 = arrayLength((&global_5.member));
            let _e104 = global_2.member[0u][0u];
            let _e108 = global_2.member[0u][1u];
            let _e112 = global_2.member[0u][2u];
            let _e116 = global_2.member[0u][3u];
            let _e120 = global_2.member[1u][0u];
            let _e124 = global_2.member[1u][1u];
            let _e128 = global_2.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e91.x + (_e91.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_3.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_3.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_3.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_3.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_3.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_3.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_3.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_3.member[_e150].member_1;
                    let _e213 = (bitcast<u32>(_e211) & 2147483647u);
                    let _e220 = global_3.member[_e150].member_3;
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && ((bitcast<u32>(_e220) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_402_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_402_;
                        phi_403_ = _e243;
                    } else {
                        phi_403_ = 0i;
                    }
                    let _e245 = phi_403_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_413_ = true;
                    } else {
                        phi_413_ = (_e169 == _e201);
                    }
                    let _e249 = phi_413_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_423_ = _e251;
                        phi_424_ = _e251;
                        phi_426_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_423_ = u32();
                        phi_424_ = 0u;
                        phi_426_ = true;
                    }
                    let _e255 = phi_423_;
                    let _e257 = phi_424_;
                    let _e259 = phi_426_;
                    if _e259 {
                        phi_431_ = (_e257 + 1u);
                    } else {
                        phi_431_ = 0u;
                    }
                    let _e263 = phi_431_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_443_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_463_ = -126i;
                    } else {
                        phi_463_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_463_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_3.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_481_ = _e302[0];
                    } else {
                        phi_481_ = _e302[1];
                    }
                    let _e307 = phi_481_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_487_ = _e302[2];
                    } else {
                        phi_487_ = _e307;
                    }
                    let _e311 = phi_487_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_3.member[_e150].member_2;
                    if _e303 {
                        phi_498_ = _e314[0];
                    } else {
                        phi_498_ = _e314[1];
                    }
                    let _e318 = phi_498_;
                    if _e308 {
                        phi_504_ = _e314[2];
                    } else {
                        phi_504_ = _e318;
                    }
                    let _e321 = phi_504_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_527_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_527_ = 0f;
                    }
                    let _e335 = phi_527_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e323);
                    }
                    let _e341 = phi_538_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_547_ = _e302[0];
                    } else {
                        phi_547_ = _e302[1];
                    }
                    let _e346 = phi_547_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_553_ = _e302[2];
                    } else {
                        phi_553_ = _e346;
                    }
                    let _e350 = phi_553_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_564_ = _e314[0];
                    } else {
                        phi_564_ = _e314[1];
                    }
                    let _e356 = phi_564_;
                    if _e347 {
                        phi_570_ = _e314[2];
                    } else {
                        phi_570_ = _e356;
                    }
                    let _e359 = phi_570_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_593_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_593_ = 0f;
                    }
                    let _e373 = phi_593_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_604_ = 38685626000000000000000000f;
                    } else {
                        phi_604_ = (1f / _e361);
                    }
                    let _e379 = phi_604_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_613_ = _e302[0];
                    } else {
                        phi_613_ = _e302[1];
                    }
                    let _e384 = phi_613_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_619_ = _e302[2];
                    } else {
                        phi_619_ = _e384;
                    }
                    let _e388 = phi_619_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_630_ = _e314[0];
                    } else {
                        phi_630_ = _e314[1];
                    }
                    let _e394 = phi_630_;
                    if _e385 {
                        phi_636_ = _e314[2];
                    } else {
                        phi_636_ = _e394;
                    }
                    let _e397 = phi_636_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_659_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_659_ = 0f;
                    }
                    let _e411 = phi_659_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_670_ = 38685626000000000000000000f;
                    } else {
                        phi_670_ = (1f / _e399);
                    }
                    let _e417 = phi_670_;
                    let _e420 = bitcast<f32>((bitcast<u32>(_e313) & 2147483647u));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e352) & 2147483647u));
                    let _e425 = select(_e423, _e420, (_e420 > _e423));
                    let _e428 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    let _e431 = (_e132 + _e245);
                    if (_e226 && (select(_e428, _e425, (_e425 > _e428)) <= 1099511600000f)) {
                        let _e434 = (_e431 / 3i);
                        let _e441 = bitcast<f32>((bitcast<u32>((_e434 + 127i)) << bitcast<u32>(23i)));
                        let _e448 = bitcast<f32>((bitcast<u32>(((_e431 - (2i * _e434)) + 127i)) << bitcast<u32>(23i)));
                        let _e449 = (((_e211 * _e441) * _e441) * _e448);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        let _e456 = (((_e220 * _e441) * _e441) * _e448);
                        let _e458 = select(340282350000000000000000000000000000000f, _e456, (_e456 < 340282350000000000000000000000000000000f));
                        phi_770_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_770_ = 0f;
                        phi_771_ = 1f;
                    }
                    let _e462 = phi_770_;
                    let _e464 = phi_771_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e467 = (_e264 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e263 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    let _e479 = (_e265 % 3u);
                    let _e480 = (_e479 < 3u);
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e482 = local_1[_e479];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e473];
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e479];
                    phi_4471_ = false;
                    phi_4327_ = _e462;
                    phi_913_ = type_51(type_24(vec4<f32>((f32(_e470) * _e144), (f32(_e476) * _e144), (f32(_e482) * _e144), 0f), vec4<f32>((f32(_e487) * _e144), (f32(_e491) * _e144), (f32(_e495) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_916_ = ((3u * _e93) + 1u);
                    phi_918_ = (_e464 <= _e462);
                    phi_920_ = 0u;
                    loop {
                        let _e505 = phi_4471_;
                        let _e507 = phi_4327_;
                        let _e509 = phi_913_;
                        let _e511 = phi_916_;
                        let _e513 = phi_918_;
                        let _e515 = phi_920_;
                        if _e513 {
                            phi_931_ = true;
                        } else {
                            phi_931_ = (_e515 > 0u);
                        }
                        let _e518 = phi_931_;
                        if _e518 {
                            let _e519 = (_e511 > 0u);
                            if _e519 {
                                if _e513 {
                                    phi_1018_ = _e509;
                                    phi_1019_ = _e513;
                                    phi_1020_ = _e515;
                                } else {
                                    let _e520 = (_e515 - 1u);
                                    let _e521 = (_e520 % 128u);
                                    let _e522 = (_e521 < 128u);
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e524 = local_7[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e526 = local_6[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e528 = local_5[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e530 = local_4[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e532 = local_3[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e534 = local_2[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e539 = local_8[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4633_ = true;
                                        break;
                                    }
                                    let _e542 = local_10[_e521];
                                    phi_1018_ = type_51(type_24(vec4<f32>(_e524, _e526, _e528, 0f), vec4<f32>(_e530, _e532, _e534, 0f)), _e539);
                                    phi_1019_ = (_e542 <= _e507);
                                    phi_1020_ = _e520;
                                }
                                let _e545 = phi_1018_;
                                let _e547 = phi_1019_;
                                let _e549 = phi_1020_;
                                if _e547 {
                                    let _e554 = (_e545.member_1 & 268435455u);
                                    if ((_e545.member_1 & 2147483648u) != 0u) {
                                        phi_4468_ = _e505;
                                        phi_4411_ = _e507;
                                        phi_1039_ = type_8(0u, ((_e545.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1031 = phi_4468_;
                                            let _e1033 = phi_4411_;
                                            let _e1035 = phi_1039_;
                                            if (_e1035.member < _e1035.member_1) {
                                                phi_1040_ = type_8((_e1035.member + 1u), _e1035.member_1);
                                                phi_1063_ = type_8(1u, _e1035.member);
                                            } else {
                                                phi_1040_ = _e1035;
                                                phi_1063_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1048 = phi_1040_;
                                            let _e1050 = phi_1063_;
                                            let _e1054 = (bitcast<i32>(_e1050.member) != 0i);
                                            if _e1054 {
                                                let _e1059 = (_e545.member.member_1.x - _e545.member.member.x);
                                                let _e1062 = (_e545.member.member_1.y - _e545.member.member.y);
                                                let _e1065 = (_e545.member.member_1.z - _e545.member.member.z);
                                                let _e1067 = select(_e1062, _e1059, (_e1059 > _e1062));
                                                let _e1069 = select(_e1065, _e1067, (_e1067 > _e1065));
                                                let _e1071 = (_e1069 < (1024f * _e144));
                                                if _e1071 {
                                                    phi_1104_ = 0u;
                                                } else {
                                                    phi_1104_ = select(2u, 1u, (_e1069 < (2097152f * _e144)));
                                                }
                                                let _e1076 = phi_1104_;
                                                switch bitcast<i32>(_e1076) {
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
                                                let _e1079 = phi_1110_;
                                                switch bitcast<i32>(_e1076) {
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
                                                let _e1086 = phi_1120_;
                                                let _e1088 = ((_e554 + (_e1050.member_1 * ((3u * _e1079) + 1u))) + (3u * _e1086));
                                                let _e1089 = (_e1088 < _e96);
                                                if _e1089 {
                                                    if _e1089 {
                                                    } else {
                                                        phi_4775_ = _e1033;
                                                        phi_4628_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_5.member[_e1088];
                                                    phi_1136_ = _e1091;
                                                } else {
                                                    phi_1136_ = 4294967295u;
                                                }
                                                let _e1093 = phi_1136_;
                                                if _e1071 {
                                                    phi_1169_ = 0u;
                                                } else {
                                                    phi_1169_ = select(2u, 1u, (_e1069 < (2097152f * _e144)));
                                                }
                                                let _e1098 = phi_1169_;
                                                switch bitcast<i32>(_e1098) {
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
                                                let _e1101 = phi_1175_;
                                                let _e1105 = (_e554 + (_e1050.member_1 * ((3u * _e1101) + 1u)));
                                                switch bitcast<i32>(_e1098) {
                                                    case 0: {
                                                        let _e1371 = (_e1105 < _e96);
                                                        if _e1371 {
                                                            if _e1371 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1373 = global_5.member[_e1105];
                                                            phi_1199_ = _e1373;
                                                        } else {
                                                            phi_1199_ = 0u;
                                                        }
                                                        let _e1375 = phi_1199_;
                                                        let _e1377 = ((10u * _e264) & 31u);
                                                        let _e1386 = ((10u * _e263) & 31u);
                                                        let _e1395 = ((10u * _e265) & 31u);
                                                        let _e1404 = (_e1105 + 1u);
                                                        let _e1405 = (_e1404 < _e96);
                                                        if _e1405 {
                                                            if _e1405 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1407 = global_5.member[_e1404];
                                                            phi_1242_ = _e1407;
                                                        } else {
                                                            phi_1242_ = 0u;
                                                        }
                                                        let _e1409 = phi_1242_;
                                                        let _e1432 = (_e1105 + 2u);
                                                        let _e1433 = (_e1432 < _e96);
                                                        if _e1433 {
                                                            if _e1433 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1435 = global_5.member[_e1432];
                                                            phi_1285_ = _e1435;
                                                        } else {
                                                            phi_1285_ = 0u;
                                                        }
                                                        let _e1437 = phi_1285_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1375 >> bitcast<u32>(_e1377)) & 1023u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1375 >> bitcast<u32>(_e1386)) & 1023u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1375 >> bitcast<u32>(_e1395)) & 1023u))) * _e144))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1409 >> bitcast<u32>(_e1377)) & 1023u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1409 >> bitcast<u32>(_e1386)) & 1023u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1409 >> bitcast<u32>(_e1395)) & 1023u))) * _e144))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1377)) & 1023u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1386)) & 1023u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1395)) & 1023u))) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1194 = (_e1105 < _e96);
                                                        if _e1194 {
                                                            if _e1194 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1196 = global_5.member[_e1105];
                                                            phi_1328_ = _e1196;
                                                        } else {
                                                            phi_1328_ = 0u;
                                                        }
                                                        let _e1198 = phi_1328_;
                                                        let _e1199 = (_e1105 + 1u);
                                                        let _e1200 = (_e1199 < _e96);
                                                        if _e1200 {
                                                            if _e1200 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1202 = global_5.member[_e1199];
                                                            phi_1343_ = _e1202;
                                                        } else {
                                                            phi_1343_ = 0u;
                                                        }
                                                        let _e1204 = phi_1343_;
                                                        let _e1205 = (_e264 == 1u);
                                                        if _e1205 {
                                                            phi_1353_ = ((_e1198 >> bitcast<u32>(21i)) | (_e1204 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1353_ = (_e1204 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1214 = phi_1353_;
                                                        let _e1221 = (_e263 == 1u);
                                                        if _e1221 {
                                                            phi_1373_ = ((_e1198 >> bitcast<u32>(21i)) | (_e1204 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1373_ = (_e1204 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1230 = phi_1373_;
                                                        let _e1237 = (_e265 == 1u);
                                                        if _e1237 {
                                                            phi_1393_ = ((_e1198 >> bitcast<u32>(21i)) | (_e1204 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1393_ = (_e1204 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1246 = phi_1393_;
                                                        let _e1254 = (_e1105 + 2u);
                                                        let _e1255 = (_e1254 < _e96);
                                                        if _e1255 {
                                                            if _e1255 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1257 = global_5.member[_e1254];
                                                            phi_1419_ = _e1257;
                                                        } else {
                                                            phi_1419_ = 0u;
                                                        }
                                                        let _e1259 = phi_1419_;
                                                        let _e1260 = (_e1105 + 3u);
                                                        let _e1261 = (_e1260 < _e96);
                                                        if _e1261 {
                                                            if _e1261 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1263 = global_5.member[_e1260];
                                                            phi_1434_ = _e1263;
                                                        } else {
                                                            phi_1434_ = 0u;
                                                        }
                                                        let _e1265 = phi_1434_;
                                                        if _e1205 {
                                                            phi_1444_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1444_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1274 = phi_1444_;
                                                        if _e1221 {
                                                            phi_1464_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1464_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1289 = phi_1464_;
                                                        if _e1237 {
                                                            phi_1484_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1484_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1304 = phi_1484_;
                                                        let _e1312 = (_e1105 + 4u);
                                                        let _e1313 = (_e1312 < _e96);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_5.member[_e1312];
                                                            phi_1510_ = _e1315;
                                                        } else {
                                                            phi_1510_ = 0u;
                                                        }
                                                        let _e1317 = phi_1510_;
                                                        let _e1318 = (_e1105 + 5u);
                                                        let _e1319 = (_e1318 < _e96);
                                                        if _e1319 {
                                                            if _e1319 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1321 = global_5.member[_e1318];
                                                            phi_1525_ = _e1321;
                                                        } else {
                                                            phi_1525_ = 0u;
                                                        }
                                                        let _e1323 = phi_1525_;
                                                        if _e1205 {
                                                            phi_1535_ = ((_e1317 >> bitcast<u32>(21i)) | (_e1323 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1535_ = (_e1323 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1332 = phi_1535_;
                                                        if _e1221 {
                                                            phi_1555_ = ((_e1317 >> bitcast<u32>(21i)) | (_e1323 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1555_ = (_e1323 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1347 = phi_1555_;
                                                        if _e1237 {
                                                            phi_1575_ = ((_e1317 >> bitcast<u32>(21i)) | (_e1323 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1575_ = (_e1323 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1362 = phi_1575_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1214, _e1198, _e303) & 2097151u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1230, _e1198, _e342) & 2097151u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1246, _e1198, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1274, _e1259, _e303) & 2097151u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1289, _e1259, _e342) & 2097151u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1304, _e1259, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e545.member.member.x + (f32(bitcast<i32>((select(_e1332, _e1317, _e303) & 2097151u))) * _e144)), (_e545.member.member.y + (f32(bitcast<i32>((select(_e1347, _e1317, _e342) & 2097151u))) * _e144)), (_e545.member.member.z + (f32(bitcast<i32>((select(_e1362, _e1317, _e380) & 2097151u))) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1107 = (_e1105 + _e264);
                                                        let _e1108 = (_e1107 < _e96);
                                                        if _e1108 {
                                                            if _e1108 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1110 = global_5.member[_e1107];
                                                            phi_1602_ = _e1110;
                                                        } else {
                                                            phi_1602_ = 0u;
                                                        }
                                                        let _e1112 = phi_1602_;
                                                        let _e1116 = (_e1105 + _e263);
                                                        let _e1117 = (_e1116 < _e96);
                                                        if _e1117 {
                                                            if _e1117 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1119 = global_5.member[_e1116];
                                                            phi_1620_ = _e1119;
                                                        } else {
                                                            phi_1620_ = 0u;
                                                        }
                                                        let _e1121 = phi_1620_;
                                                        let _e1125 = (_e1105 + _e265);
                                                        let _e1126 = (_e1125 < _e96);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_5.member[_e1125];
                                                            phi_1638_ = _e1128;
                                                        } else {
                                                            phi_1638_ = 0u;
                                                        }
                                                        let _e1130 = phi_1638_;
                                                        let _e1135 = (_e1105 + 3u);
                                                        let _e1136 = (_e1135 + _e264);
                                                        let _e1137 = (_e1136 < _e96);
                                                        if _e1137 {
                                                            if _e1137 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1139 = global_5.member[_e1136];
                                                            phi_1658_ = _e1139;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e1141 = phi_1658_;
                                                        let _e1145 = (_e1135 + _e263);
                                                        let _e1146 = (_e1145 < _e96);
                                                        if _e1146 {
                                                            if _e1146 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1148 = global_5.member[_e1145];
                                                            phi_1676_ = _e1148;
                                                        } else {
                                                            phi_1676_ = 0u;
                                                        }
                                                        let _e1150 = phi_1676_;
                                                        let _e1154 = (_e1135 + _e265);
                                                        let _e1155 = (_e1154 < _e96);
                                                        if _e1155 {
                                                            if _e1155 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1157 = global_5.member[_e1154];
                                                            phi_1694_ = _e1157;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1159 = phi_1694_;
                                                        let _e1164 = (_e1105 + 6u);
                                                        let _e1165 = (_e1164 + _e264);
                                                        let _e1166 = (_e1165 < _e96);
                                                        if _e1166 {
                                                            if _e1166 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1168 = global_5.member[_e1165];
                                                            phi_1714_ = _e1168;
                                                        } else {
                                                            phi_1714_ = 0u;
                                                        }
                                                        let _e1170 = phi_1714_;
                                                        let _e1174 = (_e1164 + _e263);
                                                        let _e1175 = (_e1174 < _e96);
                                                        if _e1175 {
                                                            if _e1175 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1177 = global_5.member[_e1174];
                                                            phi_1732_ = _e1177;
                                                        } else {
                                                            phi_1732_ = 0u;
                                                        }
                                                        let _e1179 = phi_1732_;
                                                        let _e1183 = (_e1164 + _e265);
                                                        let _e1184 = (_e1183 < _e96);
                                                        if _e1184 {
                                                            if _e1184 {
                                                            } else {
                                                                phi_4775_ = _e1033;
                                                                phi_4628_ = true;
                                                                break;
                                                            }
                                                            let _e1186 = global_5.member[_e1183];
                                                            phi_1750_ = _e1186;
                                                        } else {
                                                            phi_1750_ = 0u;
                                                        }
                                                        let _e1188 = phi_1750_;
                                                        phi_1756_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1112)) * _e144), (f32(bitcast<i32>(_e1121)) * _e144), (f32(bitcast<i32>(_e1130)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1141)) * _e144), (f32(bitcast<i32>(_e1150)) * _e144), (f32(bitcast<i32>(_e1159)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1170)) * _e144), (f32(bitcast<i32>(_e1179)) * _e144), (f32(bitcast<i32>(_e1188)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1756_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1462 = phi_1756_;
                                                let _e1469 = (_e1462[0][2] - _e390);
                                                let _e1472 = (((_e1462[0][0] - _e313) * _e414) - (_e1469 * _e338));
                                                let _e1475 = (((_e1462[0][1] - _e352) * _e414) - (_e1469 * _e376));
                                                let _e1482 = (_e1462[1][2] - _e390);
                                                let _e1485 = (((_e1462[1][0] - _e313) * _e414) - (_e1482 * _e338));
                                                let _e1488 = (((_e1462[1][1] - _e352) * _e414) - (_e1482 * _e376));
                                                let _e1495 = (_e1462[2][2] - _e390);
                                                let _e1498 = (((_e1462[2][0] - _e313) * _e414) - (_e1495 * _e338));
                                                let _e1501 = (((_e1462[2][1] - _e352) * _e414) - (_e1495 * _e376));
                                                let _e1502 = (_e1498 * _e1488);
                                                let _e1503 = (_e1501 * _e1485);
                                                let _e1504 = (_e1472 * _e1501);
                                                let _e1505 = (_e1475 * _e1498);
                                                let _e1506 = (_e1485 * _e1475);
                                                let _e1507 = (_e1488 * _e1472);
                                                let _e1512 = (((_e1502 >= _e1503) && (_e1504 >= _e1505)) && (_e1506 >= _e1507));
                                                if (_e1512 || (((_e1502 <= _e1503) && (_e1504 <= _e1505)) && (_e1506 <= _e1507))) {
                                                    let _e1519 = select(-1f, 1f, _e1512);
                                                    let _e1521 = ((_e1502 - _e1503) * _e1519);
                                                    let _e1523 = select(0f, _e1521, (_e1521 > 0f));
                                                    let _e1525 = ((_e1504 - _e1505) * _e1519);
                                                    let _e1527 = select(0f, _e1525, (_e1525 > 0f));
                                                    let _e1529 = ((_e1506 - _e1507) * _e1519);
                                                    let _e1531 = select(0f, _e1529, (_e1529 > 0f));
                                                    let _e1533 = ((_e1523 + _e1527) + _e1531);
                                                    if (_e1533 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2585_ = type_20();
                                                        phi_2586_ = true;
                                                        phi_2587_ = false;
                                                    } else {
                                                        let _e1536 = select(_e1485, _e1472, (_e1472 < _e1485));
                                                        if (select(_e1498, _e1536, (_e1536 < _e1498)) > 0f) {
                                                            phi_1874_ = true;
                                                        } else {
                                                            let _e1541 = select(_e1485, _e1472, (_e1472 > _e1485));
                                                            phi_1874_ = (select(_e1498, _e1541, (_e1541 > _e1498)) < 0f);
                                                        }
                                                        let _e1546 = phi_1874_;
                                                        if _e1546 {
                                                            phi_2582_ = type_20();
                                                            phi_2583_ = true;
                                                            phi_2584_ = false;
                                                        } else {
                                                            let _e1548 = select(_e1488, _e1475, (_e1475 < _e1488));
                                                            if (select(_e1501, _e1548, (_e1548 < _e1501)) > 0f) {
                                                                phi_1903_ = true;
                                                            } else {
                                                                let _e1553 = select(_e1488, _e1475, (_e1475 > _e1488));
                                                                phi_1903_ = (select(_e1501, _e1553, (_e1553 > _e1501)) < 0f);
                                                            }
                                                            let _e1558 = phi_1903_;
                                                            if _e1558 {
                                                                phi_2580_ = type_20();
                                                                phi_2581_ = false;
                                                            } else {
                                                                let _e1560 = select(_e1462[1][0], _e1462[0][0], (_e1462[0][0] < _e1462[1][0]));
                                                                let _e1564 = select(_e1462[1][0], _e1462[0][0], (_e1462[0][0] > _e1462[1][0]));
                                                                let _e1568 = select(_e1462[1][1], _e1462[0][1], (_e1462[0][1] < _e1462[1][1]));
                                                                let _e1572 = select(_e1462[1][1], _e1462[0][1], (_e1462[0][1] > _e1462[1][1]));
                                                                let _e1576 = select(_e1462[1][2], _e1462[0][2], (_e1462[0][2] < _e1462[1][2]));
                                                                let _e1580 = select(_e1462[1][2], _e1462[0][2], (_e1462[0][2] > _e1462[1][2]));
                                                                let _e1585 = ((select(_e1462[2][0], _e1560, (_e1560 < _e1462[2][0])) - _e336) * _e341);
                                                                let _e1586 = ((select(_e1462[2][0], _e1564, (_e1564 > _e1462[2][0])) - _e337) * _e341);
                                                                let _e1589 = ((select(_e1462[2][1], _e1568, (_e1568 < _e1462[2][1])) - _e374) * _e379);
                                                                let _e1590 = ((select(_e1462[2][1], _e1572, (_e1572 > _e1462[2][1])) - _e375) * _e379);
                                                                let _e1593 = ((select(_e1462[2][2], _e1576, (_e1576 < _e1462[2][2])) - _e412) * _e417);
                                                                let _e1594 = ((select(_e1462[2][2], _e1580, (_e1580 > _e1462[2][2])) - _e413) * _e417);
                                                                let _e1596 = select(_e1594, _e1593, (_e1593 < _e1594));
                                                                let _e1598 = select(_e1594, _e1593, (_e1593 > _e1594));
                                                                let _e1600 = select(_e1586, _e1585, (_e1585 < _e1586));
                                                                let _e1602 = select(_e1590, _e1589, (_e1589 < _e1590));
                                                                let _e1604 = select(_e1602, _e1600, (_e1600 > _e1602));
                                                                let _e1606 = select(_e1596, _e1604, (_e1604 > _e1596));
                                                                let _e1608 = select(_e1586, _e1585, (_e1585 > _e1586));
                                                                let _e1610 = select(_e1590, _e1589, (_e1589 > _e1590));
                                                                let _e1612 = select(_e1610, _e1608, (_e1608 < _e1610));
                                                                let _e1614 = select(_e1598, _e1612, (_e1612 < _e1598));
                                                                let _e1615 = -(_e1596);
                                                                let _e1621 = select(_e464, _e1606, (_e1606 > _e464));
                                                                if (_e1621 > (_e1614 + (select(_e1615, _e1598, (_e1598 > _e1615)) * 0.0000019073523f))) {
                                                                    phi_2575_ = type_20();
                                                                    phi_2576_ = true;
                                                                } else {
                                                                    let _e1623 = (_e1621 > _e1033);
                                                                    if _e1623 {
                                                                        phi_2574_ = type_20();
                                                                    } else {
                                                                        let _e1624 = vec3<f32>(_e1462[0][0], _e1462[0][1], _e1462[0][2]);
                                                                        let _e1625 = vec3<f32>(_e1462[1][0], _e1462[1][1], _e1462[1][2]);
                                                                        let _e1626 = vec3<f32>(_e1462[2][0], _e1462[2][1], _e1462[2][2]);
                                                                        let _e1627 = (_e1462[1][0] - _e1462[0][0]);
                                                                        let _e1628 = (_e1462[1][1] - _e1462[0][1]);
                                                                        let _e1629 = (_e1462[1][2] - _e1462[0][2]);
                                                                        let _e1630 = vec3<f32>(_e1627, _e1628, _e1629);
                                                                        let _e1631 = (_e1462[2][0] - _e1462[1][0]);
                                                                        let _e1632 = (_e1462[2][1] - _e1462[1][1]);
                                                                        let _e1633 = (_e1462[2][2] - _e1462[1][2]);
                                                                        let _e1634 = vec3<f32>(_e1631, _e1632, _e1633);
                                                                        let _e1635 = (_e1462[0][0] - _e1462[2][0]);
                                                                        let _e1636 = (_e1462[0][1] - _e1462[2][1]);
                                                                        let _e1637 = (_e1462[0][2] - _e1462[2][2]);
                                                                        let _e1638 = vec3<f32>(_e1635, _e1636, _e1637);
                                                                        let _e1641 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1644 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                        let _e1646 = select(_e1644, _e1641, (_e1641 > _e1644));
                                                                        let _e1649 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                        let _e1651 = select(_e1649, _e1646, (_e1646 > _e1649));
                                                                        let _e1654 = bitcast<f32>((bitcast<u32>(_e1631) & 2147483647u));
                                                                        let _e1657 = bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u));
                                                                        let _e1659 = select(_e1657, _e1654, (_e1654 > _e1657));
                                                                        let _e1662 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                        let _e1664 = select(_e1662, _e1659, (_e1659 > _e1662));
                                                                        let _e1667 = bitcast<f32>((bitcast<u32>(_e1635) & 2147483647u));
                                                                        let _e1670 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                        let _e1672 = select(_e1670, _e1667, (_e1667 > _e1670));
                                                                        let _e1675 = bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u));
                                                                        let _e1677 = select(_e1675, _e1672, (_e1672 > _e1675));
                                                                        let _e1679 = select(_e1664, _e1651, (_e1651 > _e1664));
                                                                        let _e1681 = select(_e1677, _e1679, (_e1679 > _e1677));
                                                                        if (_e1651 == _e1681) {
                                                                            phi_2304_ = _e1488;
                                                                            phi_2305_ = _e1485;
                                                                            phi_2306_ = _e1475;
                                                                            phi_2307_ = _e1472;
                                                                            phi_2308_ = _e1624;
                                                                            phi_2309_ = _e1638;
                                                                            phi_2310_ = _e1634;
                                                                            phi_2311_ = _e1630;
                                                                        } else {
                                                                            let _e1683 = (_e1664 == _e1681);
                                                                            let _e1688 = vec3(_e1683);
                                                                            phi_2304_ = select(_e1475, _e1501, _e1683);
                                                                            phi_2305_ = select(_e1472, _e1498, _e1683);
                                                                            phi_2306_ = select(_e1501, _e1488, _e1683);
                                                                            phi_2307_ = select(_e1498, _e1485, _e1683);
                                                                            phi_2308_ = select(_e1626, _e1625, _e1688);
                                                                            phi_2309_ = select(_e1634, _e1630, _e1688);
                                                                            phi_2310_ = select(_e1630, _e1638, _e1688);
                                                                            phi_2311_ = select(_e1638, _e1634, _e1688);
                                                                        }
                                                                        let _e1694 = phi_2304_;
                                                                        let _e1696 = phi_2305_;
                                                                        let _e1698 = phi_2306_;
                                                                        let _e1700 = phi_2307_;
                                                                        let _e1702 = phi_2308_;
                                                                        let _e1704 = phi_2309_;
                                                                        let _e1706 = phi_2310_;
                                                                        let _e1708 = phi_2311_;
                                                                        let _e1715 = ((_e1706.y * _e1704.z) - (_e1704.y * _e1706.z));
                                                                        let _e1720 = ((_e1706.z * _e1704.x) - (_e1704.z * _e1706.x));
                                                                        let _e1723 = ((_e1706.x * _e1704.y) - (_e1704.x * _e1706.y));
                                                                        if (_e1523 >= _e1527) {
                                                                            phi_2342_ = select(true, false, (_e1523 >= _e1531));
                                                                        } else {
                                                                            phi_2342_ = true;
                                                                        }
                                                                        let _e1728 = phi_2342_;
                                                                        if _e1728 {
                                                                            phi_2351_ = select(_e1626, _e1625, vec3((_e1527 >= _e1531)));
                                                                        } else {
                                                                            phi_2351_ = _e1624;
                                                                        }
                                                                        let _e1733 = phi_2351_;
                                                                        let _e1738 = (((_e1715 * _e338) + (_e1720 * _e376)) + (_e1723 * _e414));
                                                                        let _e1749 = (((_e1715 * (_e1733.x - _e313)) + (_e1720 * (_e1733.y - _e352))) + (_e1723 * (_e1733.z - _e390)));
                                                                        let _e1751 = (_e1696 - _e1700);
                                                                        let _e1752 = (_e1694 - _e1698);
                                                                        let _e1760 = (-(((_e1700 * _e1751) + (_e1698 * _e1752))) / ((_e1751 * _e1751) + (_e1752 * _e1752)));
                                                                        let _e1762 = select(1f, _e1760, (_e1760 < 1f));
                                                                        let _e1764 = select(0f, _e1762, (_e1762 > 0f));
                                                                        let _e1777 = ((_e1702.x + (_e1708.x * _e1764)) - _e313);
                                                                        let _e1778 = ((_e1702.y + (_e1708.y * _e1764)) - _e352);
                                                                        let _e1779 = ((_e1702.z + (_e1708.z * _e1764)) - _e390);
                                                                        let _e1780 = (_e1779 / _e414);
                                                                        let _e1792 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1795 = bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u));
                                                                        let _e1797 = select(_e1795, _e1792, (_e1792 > _e1795));
                                                                        let _e1800 = bitcast<f32>((bitcast<u32>(_e1779) & 2147483647u));
                                                                        let _e1802 = select(_e1800, _e1797, (_e1797 > _e1800));
                                                                        let _e1808 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                        let _e1811 = bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u));
                                                                        let _e1813 = select(_e1811, _e1808, (_e1808 > _e1811));
                                                                        let _e1816 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1715 * _e1777) + (_e1720 * _e1778)) + (_e1723 * _e1779)) - _e1749)) & 2147483647u)) <= ((0.0000009536743f * select(_e1681, _e1802, (_e1802 > _e1681))) * select(_e1816, _e1813, (_e1813 > _e1816)))) {
                                                                            let _e1826 = bitcast<f32>((bitcast<u32>(_e1706.x) & 2147483647u));
                                                                            let _e1829 = bitcast<f32>((bitcast<u32>(_e1706.y) & 2147483647u));
                                                                            let _e1831 = select(_e1829, _e1826, (_e1826 > _e1829));
                                                                            let _e1834 = bitcast<f32>((bitcast<u32>(_e1706.z) & 2147483647u));
                                                                            let _e1840 = bitcast<f32>((bitcast<u32>(_e1704.x) & 2147483647u));
                                                                            let _e1843 = bitcast<f32>((bitcast<u32>(_e1704.y) & 2147483647u));
                                                                            let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                                            let _e1848 = bitcast<f32>((bitcast<u32>(_e1704.z) & 2147483647u));
                                                                            phi_2518_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u)) > ((0.0000038146973f * select(_e1834, _e1831, (_e1831 > _e1834))) * select(_e1848, _e1845, (_e1845 > _e1848)))));
                                                                        } else {
                                                                            phi_2518_ = true;
                                                                        }
                                                                        let _e1855 = phi_2518_;
                                                                        if _e1855 {
                                                                            let _e1866 = ((((_e1715 * (_e1777 - (_e338 * _e1780))) + (_e1720 * (_e1778 - (_e376 * _e1780)))) + (_e1723 * (_e1779 - _e1779))) / _e1738);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1866) & 2147483647u)) <= _e1681) {
                                                                                phi_2542_ = (_e1780 + _e1866);
                                                                            } else {
                                                                                phi_2542_ = _e1780;
                                                                            }
                                                                            let _e1873 = phi_2542_;
                                                                            phi_2543_ = _e1873;
                                                                        } else {
                                                                            phi_2543_ = (_e1749 / _e1738);
                                                                        }
                                                                        let _e1875 = phi_2543_;
                                                                        let _e1877 = select(_e1614, _e1875, (_e1875 < _e1614));
                                                                        let _e1879 = select(_e1606, _e1877, (_e1877 > _e1606));
                                                                        if (_e1879 >= _e464) {
                                                                            let _e1881 = (_e1879 <= _e1033);
                                                                            if _e1881 {
                                                                                let _e1882 = (1f / _e1533);
                                                                                phi_2566_ = type_20(_e1879, (_e1527 * _e1882), (_e1531 * _e1882), _e1093);
                                                                            } else {
                                                                                phi_2566_ = type_20();
                                                                            }
                                                                            let _e1887 = phi_2566_;
                                                                            phi_2568_ = _e1887;
                                                                            phi_2569_ = select(true, false, _e1881);
                                                                        } else {
                                                                            phi_2568_ = type_20();
                                                                            phi_2569_ = true;
                                                                        }
                                                                        let _e1890 = phi_2568_;
                                                                        let _e1892 = phi_2569_;
                                                                        if _e1892 {
                                                                            phi_2573_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2573_ = _e1890;
                                                                        }
                                                                        let _e1894 = phi_2573_;
                                                                        phi_2574_ = _e1894;
                                                                    }
                                                                    let _e1896 = phi_2574_;
                                                                    phi_2575_ = _e1896;
                                                                    phi_2576_ = _e1623;
                                                                }
                                                                let _e1898 = phi_2575_;
                                                                let _e1900 = phi_2576_;
                                                                phi_2580_ = _e1898;
                                                                phi_2581_ = _e1900;
                                                            }
                                                            let _e1902 = phi_2580_;
                                                            let _e1904 = phi_2581_;
                                                            phi_2582_ = _e1902;
                                                            phi_2583_ = _e1558;
                                                            phi_2584_ = _e1904;
                                                        }
                                                        let _e1906 = phi_2582_;
                                                        let _e1908 = phi_2583_;
                                                        let _e1910 = phi_2584_;
                                                        phi_2585_ = _e1906;
                                                        phi_2586_ = _e1908;
                                                        phi_2587_ = _e1910;
                                                    }
                                                    let _e1912 = phi_2585_;
                                                    let _e1914 = phi_2586_;
                                                    let _e1916 = phi_2587_;
                                                    phi_2595_ = _e1912;
                                                    phi_2596_ = select(_e1916, true, _e1914);
                                                } else {
                                                    phi_2595_ = type_20();
                                                    phi_2596_ = true;
                                                }
                                                let _e1919 = phi_2595_;
                                                let _e1921 = phi_2596_;
                                                if _e1921 {
                                                    phi_2600_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2600_ = _e1919;
                                                }
                                                let _e1923 = phi_2600_;
                                                if (_e1923.member_3 != 4294967295u) {
                                                    if (_e1093 != 4294967295u) {
                                                        phi_2612_ = type_8(0u, 8u);
                                                        phi_2615_ = _e1923;
                                                        loop {
                                                            let _e1928 = phi_2612_;
                                                            let _e1930 = phi_2615_;
                                                            if (_e1928.member < _e1928.member_1) {
                                                                phi_2613_ = type_8((_e1928.member + 1u), _e1928.member_1);
                                                                phi_2638_ = type_8(1u, _e1928.member);
                                                            } else {
                                                                phi_2613_ = _e1928;
                                                                phi_2638_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1943 = phi_2613_;
                                                            let _e1945 = phi_2638_;
                                                            let _e1949 = (bitcast<i32>(_e1945.member) != 0i);
                                                            if _e1949 {
                                                                let _e1950 = (_e1945.member_1 < 8u);
                                                                if _e1950 {
                                                                } else {
                                                                    phi_4439_ = true;
                                                                    break;
                                                                }
                                                                let _e1955 = local_9[_e1945.member_1].member;
                                                                if (_e1930.member < _e1955) {
                                                                    phi_2671_ = true;
                                                                } else {
                                                                    let _e1957 = local_9[_e1945.member_1].member;
                                                                    if (_e1930.member == _e1957) {
                                                                        let _e1962 = local_9[_e1945.member_1].member_3;
                                                                        phi_2670_ = (_e1930.member_3 < _e1962);
                                                                    } else {
                                                                        phi_2670_ = false;
                                                                    }
                                                                    let _e1965 = phi_2670_;
                                                                    phi_2671_ = _e1965;
                                                                }
                                                                let _e1967 = phi_2671_;
                                                                if _e1967 {
                                                                    if _e1950 {
                                                                    } else {
                                                                        phi_4439_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1968 = local_9[_e1945.member_1];
                                                                    local_9[_e1945.member_1] = type_20(_e1930.member, _e1930.member_1, _e1930.member_2, _e1930.member_3);
                                                                    phi_2692_ = type_20(_e1968.member, _e1968.member_1, _e1968.member_2, _e1968.member_3);
                                                                } else {
                                                                    phi_2692_ = _e1930;
                                                                }
                                                                let _e1979 = phi_2692_;
                                                                phi_2616_ = _e1979;
                                                            } else {
                                                                phi_2616_ = type_20();
                                                            }
                                                            let _e1981 = phi_2616_;
                                                            continue;
                                                            continuing {
                                                                phi_2612_ = _e1943;
                                                                phi_2615_ = _e1981;
                                                                phi_4439_ = _e1031;
                                                                break if !(_e1949);
                                                            }
                                                        }
                                                        let _e1984 = phi_4439_;
                                                        phi_4775_ = _e1033;
                                                        phi_4628_ = _e1984;
                                                        if _e1984 {
                                                            break;
                                                        }
                                                        let _e1987 = local_9[7u].member_3;
                                                        if (_e1987 != 4294967295u) {
                                                            let _e1991 = local_9[7u].member;
                                                            phi_4866_ = _e1991;
                                                        } else {
                                                            phi_4866_ = _e1033;
                                                        }
                                                        let _e1993 = phi_4866_;
                                                        phi_4865_ = _e1993;
                                                        phi_4631_ = _e1984;
                                                    } else {
                                                        phi_4865_ = _e1033;
                                                        phi_4631_ = _e1031;
                                                    }
                                                    let _e1995 = phi_4865_;
                                                    let _e1997 = phi_4631_;
                                                    phi_4864_ = _e1995;
                                                    phi_4630_ = _e1997;
                                                } else {
                                                    phi_4864_ = _e1033;
                                                    phi_4630_ = _e1031;
                                                }
                                                let _e1999 = phi_4864_;
                                                let _e2001 = phi_4630_;
                                                phi_4863_ = _e1999;
                                                phi_4629_ = _e2001;
                                            } else {
                                                phi_4863_ = _e1033;
                                                phi_4629_ = _e1031;
                                            }
                                            let _e2003 = phi_4863_;
                                            let _e2005 = phi_4629_;
                                            continue;
                                            continuing {
                                                phi_4468_ = _e2005;
                                                phi_4411_ = _e2003;
                                                phi_1039_ = _e1048;
                                                phi_4775_ = _e2003;
                                                phi_4628_ = _e2005;
                                                break if !(_e1054);
                                            }
                                        }
                                        let _e2008 = phi_4775_;
                                        let _e2010 = phi_4628_;
                                        phi_4633_ = _e2010;
                                        if _e2010 {
                                            break;
                                        }
                                        phi_4740_ = _e2008;
                                        phi_4637_ = _e2010;
                                        phi_3944_ = _e545;
                                        phi_3945_ = false;
                                        phi_3946_ = _e549;
                                    } else {
                                        if (_e545.member_1 >= _e93) {
                                            phi_3499_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e545.member_1 < _e93) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e561 = (_e264 * 2u);
                                            let _e563 = ((1u + _e561) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e568 = global_4.member[_e545.member_1][_e563];
                                            let _e570 = ((_e561 + 2u) % 7u);
                                            if (_e570 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e575 = global_4.member[_e545.member_1][_e570];
                                            let _e576 = (_e263 * 2u);
                                            let _e578 = ((1u + _e576) % 7u);
                                            if (_e578 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e583 = global_4.member[_e545.member_1][_e578];
                                            let _e585 = ((_e576 + 2u) % 7u);
                                            if (_e585 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e590 = global_4.member[_e545.member_1][_e585];
                                            let _e591 = (_e265 * 2u);
                                            let _e593 = ((1u + _e591) % 7u);
                                            if (_e593 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e598 = global_4.member[_e545.member_1][_e593];
                                            let _e600 = ((_e591 + 2u) % 7u);
                                            if (_e600 < 7u) {
                                            } else {
                                                phi_4633_ = true;
                                                break;
                                            }
                                            let _e605 = global_4.member[_e545.member_1][_e600];
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.x - _e545.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.y - _e545.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e545.member.member_1.z - _e545.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e632 = select(_e144, _e628, (_e628 > _e144));
                                            let _e634 = select(_e144, _e629, (_e629 > _e144));
                                            let _e636 = select(_e144, _e630, (_e630 > _e144));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e632));
                                            let _e666 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e670 = bitcast<u32>((f32(bitcast<i32>((_e583 & 2097151u))) * _e634));
                                            let _e675 = (bitcast<i32>((_e583 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e678 = bitcast<f32>((_e670 & bitcast<u32>(_e675)));
                                            let _e679 = bitcast<u32>((f32(bitcast<i32>((_e598 & 2097151u))) * _e636));
                                            let _e684 = (bitcast<i32>((_e598 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e687 = bitcast<f32>((_e679 & bitcast<u32>(_e684)));
                                            let _e691 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e695 = bitcast<f32>((_e670 & bitcast<u32>(~(_e675))));
                                            let _e699 = bitcast<f32>((_e679 & bitcast<u32>(~(_e684))));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e575 & 2097151u))) * _e632));
                                            let _e705 = (bitcast<i32>((_e575 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e709 = bitcast<u32>((f32(bitcast<i32>((_e590 & 2097151u))) * _e634));
                                            let _e714 = (bitcast<i32>((_e590 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e717 = bitcast<f32>((_e709 & bitcast<u32>(_e714)));
                                            let _e718 = bitcast<u32>((f32(bitcast<i32>((_e605 & 2097151u))) * _e636));
                                            let _e723 = (bitcast<i32>((_e605 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e726 = bitcast<f32>((_e718 & bitcast<u32>(_e723)));
                                            let _e730 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e734 = bitcast<f32>((_e709 & bitcast<u32>(~(_e714))));
                                            let _e738 = bitcast<f32>((_e718 & bitcast<u32>(~(_e723))));
                                            let _e739 = (_e545.member.member.x + _e669);
                                            let _e740 = (_e545.member.member.y + _e678);
                                            let _e741 = (_e545.member.member.z + _e687);
                                            let _e744 = (_e545.member.member_1.x - _e708);
                                            let _e745 = (_e545.member.member_1.y - _e717);
                                            let _e746 = (_e545.member.member_1.z - _e726);
                                            let _e765 = (_e744 - _e739);
                                            let _e766 = (_e745 - _e740);
                                            let _e767 = (_e746 - _e741);
                                            let _e769 = select(_e766, _e765, (_e765 > _e766));
                                            let _e771 = select(_e767, _e769, (_e769 > _e767));
                                            if (_e771 < (1024f * _e144)) {
                                                phi_3200_ = 0u;
                                            } else {
                                                phi_3200_ = select(2u, 1u, (_e771 < (2097152f * _e144)));
                                            }
                                            let _e778 = phi_3200_;
                                            switch bitcast<i32>(_e778) {
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
                                            let _e781 = phi_3206_;
                                            let _e787 = global_4.member[_e545.member_1][0u];
                                            let _e791 = global_4.member[_e545.member_1][2u];
                                            let _e795 = global_4.member[_e545.member_1][4u];
                                            let _e799 = global_4.member[_e545.member_1][6u];
                                            let _e811 = (((_e791 >> bitcast<u32>(22i)) | ((_e795 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e799 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e812 = (_e787 & 268435455u);
                                            let _e813 = (_e811 & 268435455u);
                                            let _e816 = ((_e787 >> bitcast<u32>(28u)) & 7u);
                                            let _e824 = ((_e787 >> bitcast<u32>(31i)) | (((_e811 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e825 = (_e816 != 0u);
                                            if (_e816 == 0u) {
                                                phi_3461_ = _e812;
                                            } else {
                                                if (_e816 == 7u) {
                                                    phi_3460_ = 2147483648u;
                                                } else {
                                                    phi_3460_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (_e813 & 268435455u));
                                                }
                                                let _e834 = phi_3460_;
                                                phi_3461_ = _e834;
                                            }
                                            let _e836 = phi_3461_;
                                            if _e825 {
                                                let _e837 = (_e816 != 7u);
                                                if _e837 {
                                                    phi_3471_ = (_e813 + (_e816 * ((3u * _e781) + 1u)));
                                                } else {
                                                    phi_3471_ = u32();
                                                }
                                                let _e841 = phi_3471_;
                                                phi_3473_ = _e841;
                                                phi_3474_ = select(true, false, _e837);
                                            } else {
                                                phi_3473_ = u32();
                                                phi_3474_ = true;
                                            }
                                            let _e844 = phi_3473_;
                                            let _e846 = phi_3474_;
                                            if (_e824 == 0u) {
                                                phi_3495_ = (_e812 + select(0u, 1u, !(_e825)));
                                            } else {
                                                if (_e824 == 7u) {
                                                    phi_3494_ = 2147483648u;
                                                } else {
                                                    phi_3494_ = ((2147483648u | (_e824 << bitcast<u32>(28u))) | (select(_e844, _e813, _e846) & 268435455u));
                                                }
                                                let _e859 = phi_3494_;
                                                phi_3495_ = _e859;
                                            }
                                            let _e861 = phi_3495_;
                                            phi_3499_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e739, (_e545.member.member.x + _e691), _e744, (_e545.member.member_1.x - _e730)), vec4<f32>(_e740, (_e545.member.member.y + _e695), _e745, (_e545.member.member_1.y - _e734)), vec4<f32>(_e741, (_e545.member.member.z + _e699), _e746, (_e545.member.member_1.z - _e738))), type_51(type_24((_e545.member.member + vec4<f32>(_e669, _e678, _e687, 0f)), (_e545.member.member_1 - vec4<f32>(_e708, _e717, _e726, 0f))), _e836), type_51(type_24((_e545.member.member + vec4<f32>(_e691, _e695, _e699, 0f)), (_e545.member.member_1 - vec4<f32>(_e730, _e734, _e738, 0f))), _e861));
                                        }
                                        let _e866 = phi_3499_;
                                        let _e877 = ((_e866.member[0].x - _e336) * _e341);
                                        let _e878 = ((_e866.member[0].y - _e336) * _e341);
                                        let _e879 = ((_e866.member[0].z - _e337) * _e341);
                                        let _e880 = ((_e866.member[0].w - _e337) * _e341);
                                        let _e890 = ((_e866.member[1].x - _e374) * _e379);
                                        let _e891 = ((_e866.member[1].y - _e374) * _e379);
                                        let _e892 = ((_e866.member[1].z - _e375) * _e379);
                                        let _e893 = ((_e866.member[1].w - _e375) * _e379);
                                        let _e903 = ((_e866.member[2].x - _e412) * _e417);
                                        let _e904 = ((_e866.member[2].y - _e412) * _e417);
                                        let _e905 = ((_e866.member[2].z - _e413) * _e417);
                                        let _e906 = ((_e866.member[2].w - _e413) * _e417);
                                        let _e908 = select(_e905, _e903, (_e903 < _e905));
                                        let _e910 = select(_e906, _e904, (_e904 < _e906));
                                        let _e912 = select(_e905, _e903, (_e903 > _e905));
                                        let _e914 = select(_e906, _e904, (_e904 > _e906));
                                        let _e916 = select(_e879, _e877, (_e877 < _e879));
                                        let _e918 = select(_e880, _e878, (_e878 < _e880));
                                        let _e920 = select(_e892, _e890, (_e890 < _e892));
                                        let _e922 = select(_e893, _e891, (_e891 < _e893));
                                        let _e924 = select(_e920, _e916, (_e916 > _e920));
                                        let _e926 = select(_e922, _e918, (_e918 > _e922));
                                        let _e928 = select(_e908, _e924, (_e924 > _e908));
                                        let _e930 = select(_e910, _e926, (_e926 > _e910));
                                        let _e932 = select(_e879, _e877, (_e877 > _e879));
                                        let _e934 = select(_e880, _e878, (_e878 > _e880));
                                        let _e936 = select(_e892, _e890, (_e890 > _e892));
                                        let _e938 = select(_e893, _e891, (_e891 > _e893));
                                        let _e940 = select(_e936, _e932, (_e932 < _e936));
                                        let _e942 = select(_e938, _e934, (_e934 < _e938));
                                        let _e947 = -(_e908);
                                        let _e948 = -(_e910);
                                        let _e955 = (select(_e912, _e940, (_e940 < _e912)) + (select(_e947, _e912, (_e912 > _e947)) * 0.0000019073523f));
                                        let _e956 = (select(_e914, _e942, (_e942 < _e914)) + (select(_e948, _e914, (_e914 > _e948)) * 0.0000019073523f));
                                        let _e958 = select(_e464, _e928, (_e928 > _e464));
                                        let _e960 = select(_e464, _e930, (_e930 > _e464));
                                        let _e965 = (_e958 <= select(_e507, _e955, (_e955 < _e507)));
                                        let _e966 = (_e960 <= select(_e507, _e956, (_e956 < _e507)));
                                        let _e967 = (_e958 <= _e960);
                                        if _e965 {
                                            if _e966 {
                                                if _e967 {
                                                    phi_3844_ = _e866.member_2;
                                                } else {
                                                    phi_3844_ = _e866.member_1;
                                                }
                                                let _e971 = phi_3844_;
                                                let _e993 = (_e549 % 128u);
                                                let _e994 = (_e993 < 128u);
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_8[_e993] = _e971.member_1;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_7[_e993] = _e971.member.member.x;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_6[_e993] = _e971.member.member.y;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_5[_e993] = _e971.member.member.z;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_4[_e993] = _e971.member.member_1.x;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_3[_e993] = _e971.member.member_1.y;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_2[_e993] = _e971.member.member_1.z;
                                                if _e994 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_10[_e993] = select(_e960, _e958, (_e958 > _e960));
                                                if _e967 {
                                                    phi_3921_ = _e866.member_1;
                                                } else {
                                                    phi_3921_ = _e866.member_2;
                                                }
                                                let _e1007 = phi_3921_;
                                                phi_3922_ = _e1007;
                                                phi_3923_ = (_e549 + 1u);
                                            } else {
                                                phi_3922_ = type_51();
                                                phi_3923_ = u32();
                                            }
                                            let _e1009 = phi_3922_;
                                            let _e1011 = phi_3923_;
                                            phi_3925_ = _e1009;
                                            phi_3926_ = _e1011;
                                            phi_3927_ = select(true, false, _e966);
                                        } else {
                                            phi_3925_ = type_51();
                                            phi_3926_ = u32();
                                            phi_3927_ = true;
                                        }
                                        let _e1014 = phi_3925_;
                                        let _e1016 = phi_3926_;
                                        let _e1018 = phi_3927_;
                                        if _e1018 {
                                            if _e965 {
                                                phi_3936_ = _e866.member_1;
                                            } else {
                                                phi_3936_ = _e866.member_2;
                                            }
                                            let _e1022 = phi_3936_;
                                            phi_3941_ = _e1022;
                                            phi_3942_ = select(_e966, true, _e965);
                                        } else {
                                            phi_3941_ = _e1014;
                                            phi_3942_ = _e547;
                                        }
                                        let _e1025 = phi_3941_;
                                        let _e1027 = phi_3942_;
                                        phi_4740_ = _e507;
                                        phi_4637_ = _e505;
                                        phi_3944_ = _e1025;
                                        phi_3945_ = _e1027;
                                        phi_3946_ = select(_e1016, _e549, _e1018);
                                    }
                                    let _e2012 = phi_4740_;
                                    let _e2014 = phi_4637_;
                                    let _e2016 = phi_3944_;
                                    let _e2018 = phi_3945_;
                                    let _e2020 = phi_3946_;
                                    phi_4739_ = _e2012;
                                    phi_4636_ = _e2014;
                                    phi_3947_ = _e2016;
                                    phi_3948_ = (_e511 - 1u);
                                    phi_3949_ = _e2018;
                                    phi_3950_ = _e2020;
                                } else {
                                    phi_4739_ = _e507;
                                    phi_4636_ = _e505;
                                    phi_3947_ = _e545;
                                    phi_3948_ = _e511;
                                    phi_3949_ = _e547;
                                    phi_3950_ = _e549;
                                }
                                let _e2022 = phi_4739_;
                                let _e2024 = phi_4636_;
                                let _e2026 = phi_3947_;
                                let _e2028 = phi_3948_;
                                let _e2030 = phi_3949_;
                                let _e2032 = phi_3950_;
                                phi_4738_ = _e2022;
                                phi_4635_ = _e2024;
                                phi_3951_ = _e2026;
                                phi_3952_ = _e2028;
                                phi_3953_ = _e2030;
                                phi_3954_ = _e2032;
                            } else {
                                phi_4738_ = _e507;
                                phi_4635_ = _e505;
                                phi_3951_ = type_51();
                                phi_3952_ = u32();
                                phi_3953_ = bool();
                                phi_3954_ = u32();
                            }
                            let _e2034 = phi_4738_;
                            let _e2036 = phi_4635_;
                            let _e2038 = phi_3951_;
                            let _e2040 = phi_3952_;
                            let _e2042 = phi_3953_;
                            let _e2044 = phi_3954_;
                            phi_4737_ = _e2034;
                            phi_4634_ = _e2036;
                            phi_914_ = _e2038;
                            phi_917_ = _e2040;
                            phi_919_ = _e2042;
                            phi_921_ = _e2044;
                            phi_3955_ = _e519;
                        } else {
                            phi_4737_ = _e507;
                            phi_4634_ = _e505;
                            phi_914_ = type_51();
                            phi_917_ = u32();
                            phi_919_ = bool();
                            phi_921_ = u32();
                            phi_3955_ = false;
                        }
                        let _e2046 = phi_4737_;
                        let _e2048 = phi_4634_;
                        let _e2050 = phi_914_;
                        let _e2052 = phi_917_;
                        let _e2054 = phi_919_;
                        let _e2056 = phi_921_;
                        let _e2058 = phi_3955_;
                        continue;
                        continuing {
                            phi_4471_ = _e2048;
                            phi_4327_ = _e2046;
                            phi_913_ = _e2050;
                            phi_916_ = _e2052;
                            phi_918_ = _e2054;
                            phi_920_ = _e2056;
                            phi_4633_ = _e2048;
                            break if !(_e2058);
                        }
                    }
                    let _e2061 = phi_4633_;
                    if _e2061 {
                        break;
                    }
                    phi_3962_ = type_8(0u, 8u);
                    loop {
                        let _e2063 = phi_3962_;
                        if (_e2063.member < _e2063.member_1) {
                            phi_3963_ = type_8((_e2063.member + 1u), _e2063.member_1);
                            phi_3986_ = type_8(1u, _e2063.member);
                        } else {
                            phi_3963_ = _e2063;
                            phi_3986_ = type_8(0u, type_8().member_1);
                        }
                        let _e2076 = phi_3963_;
                        let _e2078 = phi_3986_;
                        let _e2082 = (bitcast<i32>(_e2078.member) != 0i);
                        if _e2082 {
                            let _e2083 = (_e2078.member_1 < 8u);
                            if _e2083 {
                            } else {
                                phi_4730_ = true;
                                break;
                            }
                            let _e2085 = local_9[_e2078.member_1];
                            if (_e2085.member_3 != 4294967295u) {
                                let _e2091 = -(_e431);
                                let _e2092 = (_e2091 / 3i);
                                let _e2099 = bitcast<f32>((bitcast<u32>((_e2092 + 127i)) << bitcast<u32>(23i)));
                                let _e2107 = (((_e2085.member * _e2099) * _e2099) * bitcast<f32>((bitcast<u32>(((_e2091 - (2i * _e2092)) + 127i)) << bitcast<u32>(23i))));
                                let _e2109 = select(340282350000000000000000000000000000000f, _e2107, (_e2107 < 340282350000000000000000000000000000000f));
                                phi_4052_ = type_20(select(-340282350000000000000000000000000000000f, _e2109, (_e2109 > -340282350000000000000000000000000000000f)), _e2085.member_1, _e2085.member_2, _e2085.member_3);
                            } else {
                                phi_4052_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2114 = phi_4052_;
                            if _e2083 {
                            } else {
                                phi_4730_ = true;
                                break;
                            }
                            local_9[_e2078.member_1] = type_20(_e2114.member, _e2114.member_1, _e2114.member_2, _e2114.member_3);
                        }
                        continue;
                        continuing {
                            phi_3962_ = _e2076;
                            phi_4730_ = _e2061;
                            break if !(_e2082);
                        }
                    }
                    let _e2122 = phi_4730_;
                    if _e2122 {
                        break;
                    }
                    let _e2123 = local_9;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = array<type_20, 8>(type_20(_e2123[0].member, _e2123[0].member_1, _e2123[0].member_2, _e2123[0].member_3), type_20(_e2123[1].member, _e2123[1].member_1, _e2123[1].member_2, _e2123[1].member_3), type_20(_e2123[2].member, _e2123[2].member_1, _e2123[2].member_2, _e2123[2].member_3), type_20(_e2123[3].member, _e2123[3].member_1, _e2123[3].member_2, _e2123[3].member_3), type_20(_e2123[4].member, _e2123[4].member_1, _e2123[4].member_2, _e2123[4].member_3), type_20(_e2123[5].member, _e2123[5].member_1, _e2123[5].member_2, _e2123[5].member_3), type_20(_e2123[6].member, _e2123[6].member_1, _e2123[6].member_2, _e2123[6].member_3), type_20(_e2123[7].member, _e2123[7].member_1, _e2123[7].member_2, _e2123[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
