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

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: array<type_28>,
}

struct type_40 {
    member: f32,
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_47 {
    member: type_31,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_47,
    member_2: type_47,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_47, 128>;
    var phi_361_: i32;
    var phi_362_: i32;
    var phi_372_: bool;
    var phi_382_: u32;
    var phi_383_: u32;
    var phi_385_: bool;
    var phi_390_: u32;
    var phi_435_: f32;
    var phi_441_: f32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_481_: f32;
    var phi_492_: f32;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_518_: f32;
    var phi_524_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_567_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_4175_: bool;
    var phi_1845_: type_40;
    var phi_1848_: type_47;
    var phi_1850_: u32;
    var phi_1852_: bool;
    var phi_1854_: u32;
    var phi_1865_: bool;
    var phi_1902_: type_47;
    var phi_1903_: bool;
    var phi_1904_: u32;
    var phi_3511_: u32;
    var phi_3512_: u32;
    var phi_3522_: u32;
    var phi_3524_: u32;
    var phi_3525_: bool;
    var phi_3545_: u32;
    var phi_3546_: u32;
    var phi_3550_: type_50;
    var phi_3894_: type_47;
    var phi_3927_: type_47;
    var phi_3928_: type_47;
    var phi_3929_: u32;
    var phi_3931_: type_47;
    var phi_3932_: u32;
    var phi_3933_: bool;
    var phi_3942_: type_47;
    var phi_3947_: type_47;
    var phi_3948_: bool;
    var phi_1922_: type_40;
    var phi_1925_: type_7;
    var phi_1926_: type_7;
    var phi_1948_: type_7;
    var phi_1969_: u32;
    var phi_2058_: array<array<f32, 3>, 3>;
    var phi_2529_: vec3<f32>;
    var phi_2530_: vec3<f32>;
    var phi_2561_: bool;
    var phi_2570_: vec3<f32>;
    var phi_2610_: type_27;
    var phi_2612_: type_27;
    var phi_2613_: bool;
    var phi_2617_: type_27;
    var phi_2618_: type_27;
    var phi_2619_: type_27;
    var phi_2620_: bool;
    var phi_2624_: type_27;
    var phi_2625_: bool;
    var phi_2629_: type_27;
    var phi_2630_: bool;
    var phi_2634_: type_27;
    var phi_2645_: type_40;
    var phi_2646_: type_40;
    var phi_1923_: type_40;
    var phi_4169_: bool;
    var local_4: type_40;
    var phi_4280_: bool;
    var phi_3950_: type_40;
    var phi_3951_: type_47;
    var phi_3952_: bool;
    var phi_3953_: u32;
    var phi_4279_: bool;
    var phi_3954_: type_40;
    var phi_3955_: type_47;
    var phi_3956_: u32;
    var phi_3957_: bool;
    var phi_3958_: u32;
    var phi_4278_: bool;
    var phi_3959_: type_40;
    var phi_3960_: type_47;
    var phi_3961_: u32;
    var phi_3962_: bool;
    var phi_3963_: u32;
    var phi_4277_: bool;
    var phi_1846_: type_40;
    var phi_1849_: type_47;
    var phi_1851_: u32;
    var phi_1853_: bool;
    var phi_1855_: u32;
    var phi_3964_: bool;
    var phi_4276_: bool;
    var local_5: type_40;
    var local_6: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e79 = arrayLength((&global_4.member));
            let _e81 = arrayLength((&global_2.member));
            let _e89 = global_3.member[0u][0u];
            let _e93 = global_3.member[0u][1u];
            let _e97 = global_3.member[0u][2u];
            let _e101 = global_3.member[0u][3u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e116 = global_1.member[0u];
            let _e117 = bitcast<i32>(_e116);
            let _e129 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e101) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e89), bitcast<i32>(_e93), bitcast<i32>(_e97));
            local = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            let _e135 = (_e77.x + (_e77.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_5.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_6.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_5.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_5.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_5.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_5.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_5.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_5.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_5.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_5.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_361_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_361_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_361_;
                        phi_362_ = _e228;
                    } else {
                        phi_362_ = 0i;
                    }
                    let _e230 = phi_362_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_372_ = true;
                    } else {
                        phi_372_ = (_e154 == _e186);
                    }
                    let _e234 = phi_372_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_382_ = _e236;
                        phi_383_ = _e236;
                        phi_385_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_382_ = u32();
                        phi_383_ = 0u;
                        phi_385_ = true;
                    }
                    let _e240 = phi_382_;
                    let _e242 = phi_383_;
                    let _e244 = phi_385_;
                    if _e244 {
                        phi_390_ = (_e242 + 1u);
                    } else {
                        phi_390_ = 0u;
                    }
                    let _e248 = phi_390_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    let _e251 = (_e117 / 2i);
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e117 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e230);
                    let _e264 = (_e263 / 2i);
                    let _e269 = bitcast<f32>((bitcast<u32>((_e264 + 127i)) << bitcast<u32>(23i)));
                    let _e275 = bitcast<f32>((bitcast<u32>(((_e263 - _e264) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = global_5.member[_e135].member;
                    let _e280 = (_e249 == 0u);
                    if _e280 {
                        phi_435_ = _e279[0];
                    } else {
                        phi_435_ = _e279[1];
                    }
                    let _e284 = phi_435_;
                    let _e285 = (_e249 == 2u);
                    if _e285 {
                        phi_441_ = _e279[2];
                    } else {
                        phi_441_ = _e284;
                    }
                    let _e288 = phi_441_;
                    let _e290 = ((_e288 * _e256) * _e262);
                    let _e291 = global_5.member[_e135].member_2;
                    if _e280 {
                        phi_452_ = _e291[0];
                    } else {
                        phi_452_ = _e291[1];
                    }
                    let _e295 = phi_452_;
                    if _e285 {
                        phi_458_ = _e291[2];
                    } else {
                        phi_458_ = _e295;
                    }
                    let _e298 = phi_458_;
                    let _e300 = ((_e298 * _e269) * _e275);
                    let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e304 {
                        let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                        phi_481_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                    } else {
                        phi_481_ = 0f;
                    }
                    let _e312 = phi_481_;
                    let _e313 = (_e290 + _e312);
                    let _e314 = (_e290 - _e312);
                    let _e315 = select(_e300, 0f, _e304);
                    if _e304 {
                        phi_492_ = 38685626000000000000000000f;
                    } else {
                        phi_492_ = (1f / _e300);
                    }
                    let _e318 = phi_492_;
                    let _e319 = (_e248 == 0u);
                    if _e319 {
                        phi_501_ = _e279[0];
                    } else {
                        phi_501_ = _e279[1];
                    }
                    let _e323 = phi_501_;
                    let _e324 = (_e248 == 2u);
                    if _e324 {
                        phi_507_ = _e279[2];
                    } else {
                        phi_507_ = _e323;
                    }
                    let _e327 = phi_507_;
                    let _e329 = ((_e327 * _e256) * _e262);
                    if _e319 {
                        phi_518_ = _e291[0];
                    } else {
                        phi_518_ = _e291[1];
                    }
                    let _e333 = phi_518_;
                    if _e324 {
                        phi_524_ = _e291[2];
                    } else {
                        phi_524_ = _e333;
                    }
                    let _e336 = phi_524_;
                    let _e338 = ((_e336 * _e269) * _e275);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                        phi_547_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_547_ = 0f;
                    }
                    let _e350 = phi_547_;
                    let _e351 = (_e329 + _e350);
                    let _e352 = (_e329 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_558_ = 38685626000000000000000000f;
                    } else {
                        phi_558_ = (1f / _e338);
                    }
                    let _e356 = phi_558_;
                    let _e357 = (_e250 == 0u);
                    if _e357 {
                        phi_567_ = _e279[0];
                    } else {
                        phi_567_ = _e279[1];
                    }
                    let _e361 = phi_567_;
                    let _e362 = (_e250 == 2u);
                    if _e362 {
                        phi_573_ = _e279[2];
                    } else {
                        phi_573_ = _e361;
                    }
                    let _e365 = phi_573_;
                    let _e367 = ((_e365 * _e256) * _e262);
                    if _e357 {
                        phi_584_ = _e291[0];
                    } else {
                        phi_584_ = _e291[1];
                    }
                    let _e371 = phi_584_;
                    if _e362 {
                        phi_590_ = _e291[2];
                    } else {
                        phi_590_ = _e371;
                    }
                    let _e374 = phi_590_;
                    let _e376 = ((_e374 * _e269) * _e275);
                    let _e380 = (bitcast<f32>((bitcast<u32>(_e376) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e380 {
                        let _e384 = (bitcast<f32>((bitcast<u32>(_e367) & 2147483647u)) * 0.00000011920929f);
                        phi_613_ = select(0.00000000000011368684f, _e384, (_e384 > 0.00000000000011368684f));
                    } else {
                        phi_613_ = 0f;
                    }
                    let _e388 = phi_613_;
                    let _e389 = (_e367 + _e388);
                    let _e390 = (_e367 - _e388);
                    let _e391 = select(_e376, 0f, _e380);
                    if _e380 {
                        phi_624_ = 38685626000000000000000000f;
                    } else {
                        phi_624_ = (1f / _e376);
                    }
                    let _e394 = phi_624_;
                    let _e397 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                    let _e400 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e402 = select(_e400, _e397, (_e397 > _e400));
                    let _e405 = bitcast<f32>((bitcast<u32>(_e367) & 2147483647u));
                    let _e408 = (_e117 + _e230);
                    if (_e211 && (select(_e405, _e402, (_e402 > _e405)) <= 1099511600000f)) {
                        let _e411 = (_e408 / 3i);
                        let _e418 = bitcast<f32>((bitcast<u32>((_e411 + 127i)) << bitcast<u32>(23i)));
                        let _e425 = bitcast<f32>((bitcast<u32>(((_e408 - (2i * _e411)) + 127i)) << bitcast<u32>(23i)));
                        let _e426 = (((_e196 * _e418) * _e418) * _e425);
                        let _e428 = select(340282350000000000000000000000000000000f, _e426, (_e426 < 340282350000000000000000000000000000000f));
                        let _e433 = (((_e205 * _e418) * _e418) * _e425);
                        let _e435 = select(340282350000000000000000000000000000000f, _e433, (_e433 < 340282350000000000000000000000000000000f));
                        phi_724_ = select(-340282350000000000000000000000000000000f, _e435, (_e435 > -340282350000000000000000000000000000000f));
                        phi_725_ = select(-340282350000000000000000000000000000000f, _e428, (_e428 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_724_ = 0f;
                        phi_725_ = 1f;
                    }
                    let _e439 = phi_724_;
                    let _e441 = phi_725_;
                    local_3 = array<type_47, 128>(type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e445 = (_e249 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_1[_e445];
                    let _e451 = (_e248 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_1[_e451];
                    let _e457 = (_e250 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_1[_e457];
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e465 = local[_e445];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e469 = local[_e451];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e473 = local[_e457];
                    phi_4175_ = false;
                    phi_1845_ = type_40(_e439, false);
                    phi_1848_ = type_47(type_31(vec4<f32>((f32(_e448) * _e129), (f32(_e454) * _e129), (f32(_e460) * _e129), 0f), vec4<f32>((f32(_e465) * _e129), (f32(_e469) * _e129), (f32(_e473) * _e129), 0f)), select(0u, 2147483648u, (_e79 == 0u)));
                    phi_1850_ = ((3u * _e79) + 1u);
                    phi_1852_ = (_e441 <= _e439);
                    phi_1854_ = 0u;
                    loop {
                        let _e483 = phi_4175_;
                        let _e485 = phi_1845_;
                        let _e487 = phi_1848_;
                        let _e489 = phi_1850_;
                        let _e491 = phi_1852_;
                        let _e493 = phi_1854_;
                        local_5 = _e485;
                        if _e491 {
                            phi_1865_ = true;
                        } else {
                            phi_1865_ = (_e493 > 0u);
                        }
                        let _e496 = phi_1865_;
                        if _e496 {
                            let _e497 = (_e489 > 0u);
                            if _e497 {
                                if _e491 {
                                    phi_1902_ = _e487;
                                    phi_1903_ = _e491;
                                    phi_1904_ = _e493;
                                } else {
                                    let _e498 = (_e493 - 1u);
                                    let _e499 = (_e498 % 128u);
                                    let _e500 = (_e499 < 128u);
                                    if _e500 {
                                    } else {
                                        phi_4276_ = true;
                                        break;
                                    }
                                    let _e502 = local_3[_e499];
                                    if _e500 {
                                    } else {
                                        phi_4276_ = true;
                                        break;
                                    }
                                    let _e510 = local_2[_e499];
                                    phi_1902_ = type_47(type_31(_e502.member.member, _e502.member.member_1), _e502.member_1);
                                    phi_1903_ = (_e510 <= _e485.member);
                                    phi_1904_ = _e498;
                                }
                                let _e514 = phi_1902_;
                                let _e516 = phi_1903_;
                                let _e518 = phi_1904_;
                                if _e516 {
                                    if ((_e514.member_1 & 2147483648u) != 0u) {
                                        phi_1922_ = _e485;
                                        phi_1925_ = type_7(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e964 = phi_1922_;
                                            let _e966 = phi_1925_;
                                            local_4 = _e964;
                                            local_6 = _e964;
                                            if (_e966.member < _e966.member_1) {
                                                phi_1926_ = type_7((_e966.member + 1u), _e966.member_1);
                                                phi_1948_ = type_7(1u, _e966.member);
                                            } else {
                                                phi_1926_ = _e966;
                                                phi_1948_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e979 = phi_1926_;
                                            let _e981 = phi_1948_;
                                            let _e985 = (bitcast<i32>(_e981.member) != 0i);
                                            if _e985 {
                                                let _e986 = ((_e514.member_1 & 268435455u) + _e981.member_1);
                                                let _e987 = (_e986 < _e81);
                                                if _e987 {
                                                    if _e987 {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e991 = global_2.member[_e986].member_1;
                                                    phi_1969_ = _e991;
                                                } else {
                                                    phi_1969_ = 4294967295u;
                                                }
                                                let _e993 = phi_1969_;
                                                if (_e986 >= _e81) {
                                                    phi_2058_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e987 {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    if (_e445 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1000 = global_2.member[_e986].member[_e445];
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1006 = global_2.member[_e986].member[_e451];
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1012 = global_2.member[_e986].member[_e457];
                                                    let _e1014 = (3u + _e445);
                                                    if (_e1014 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1020 = global_2.member[_e986].member[_e1014];
                                                    let _e1021 = (3u + _e451);
                                                    if (_e1021 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1027 = global_2.member[_e986].member[_e1021];
                                                    let _e1028 = (3u + _e457);
                                                    if (_e1028 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1034 = global_2.member[_e986].member[_e1028];
                                                    let _e1036 = (6u + _e445);
                                                    if (_e1036 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e986].member[_e1036];
                                                    let _e1043 = (6u + _e451);
                                                    if (_e1043 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1049 = global_2.member[_e986].member[_e1043];
                                                    let _e1050 = (6u + _e457);
                                                    if (_e1050 < 9u) {
                                                    } else {
                                                        phi_4169_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_2.member[_e986].member[_e1050];
                                                    phi_2058_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1000, _e1006, _e1012), array<f32, 3>(_e1020, _e1027, _e1034), array<f32, 3>(_e1042, _e1049, _e1056));
                                                }
                                                let _e1060 = phi_2058_;
                                                let _e1068 = (_e1060[0][2] - _e367);
                                                let _e1071 = (((_e1060[0][0] - _e290) * _e391) - (_e1068 * _e315));
                                                let _e1074 = (((_e1060[0][1] - _e329) * _e391) - (_e1068 * _e353));
                                                let _e1081 = (_e1060[1][2] - _e367);
                                                let _e1084 = (((_e1060[1][0] - _e290) * _e391) - (_e1081 * _e315));
                                                let _e1087 = (((_e1060[1][1] - _e329) * _e391) - (_e1081 * _e353));
                                                let _e1094 = (_e1060[2][2] - _e367);
                                                let _e1097 = (((_e1060[2][0] - _e290) * _e391) - (_e1094 * _e315));
                                                let _e1100 = (((_e1060[2][1] - _e329) * _e391) - (_e1094 * _e353));
                                                let _e1101 = (_e1097 * _e1087);
                                                let _e1102 = (_e1100 * _e1084);
                                                let _e1103 = (_e1071 * _e1100);
                                                let _e1104 = (_e1074 * _e1097);
                                                let _e1105 = (_e1084 * _e1074);
                                                let _e1106 = (_e1087 * _e1071);
                                                let _e1111 = (((_e1101 >= _e1102) && (_e1103 >= _e1104)) && (_e1105 >= _e1106));
                                                if (_e1111 || (((_e1101 <= _e1102) && (_e1103 <= _e1104)) && (_e1105 <= _e1106))) {
                                                    let _e1118 = select(-1f, 1f, _e1111);
                                                    let _e1120 = ((_e1101 - _e1102) * _e1118);
                                                    let _e1122 = select(0f, _e1120, (_e1120 > 0f));
                                                    let _e1124 = ((_e1103 - _e1104) * _e1118);
                                                    let _e1126 = select(0f, _e1124, (_e1124 > 0f));
                                                    let _e1128 = ((_e1105 - _e1106) * _e1118);
                                                    let _e1130 = select(0f, _e1128, (_e1128 > 0f));
                                                    let _e1132 = ((_e1122 + _e1126) + _e1130);
                                                    if (_e1132 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2624_ = type_27();
                                                        phi_2625_ = true;
                                                    } else {
                                                        let _e1135 = select(_e1060[1][0], _e1060[0][0], (_e1060[0][0] < _e1060[1][0]));
                                                        let _e1139 = select(_e1060[1][0], _e1060[0][0], (_e1060[0][0] > _e1060[1][0]));
                                                        let _e1143 = select(_e1060[1][1], _e1060[0][1], (_e1060[0][1] < _e1060[1][1]));
                                                        let _e1147 = select(_e1060[1][1], _e1060[0][1], (_e1060[0][1] > _e1060[1][1]));
                                                        let _e1151 = select(_e1060[1][2], _e1060[0][2], (_e1060[0][2] < _e1060[1][2]));
                                                        let _e1155 = select(_e1060[1][2], _e1060[0][2], (_e1060[0][2] > _e1060[1][2]));
                                                        let _e1160 = ((select(_e1060[2][0], _e1135, (_e1135 < _e1060[2][0])) - _e313) * _e318);
                                                        let _e1161 = ((select(_e1060[2][0], _e1139, (_e1139 > _e1060[2][0])) - _e314) * _e318);
                                                        let _e1164 = ((select(_e1060[2][1], _e1143, (_e1143 < _e1060[2][1])) - _e351) * _e356);
                                                        let _e1165 = ((select(_e1060[2][1], _e1147, (_e1147 > _e1060[2][1])) - _e352) * _e356);
                                                        let _e1168 = ((select(_e1060[2][2], _e1151, (_e1151 < _e1060[2][2])) - _e389) * _e394);
                                                        let _e1169 = ((select(_e1060[2][2], _e1155, (_e1155 > _e1060[2][2])) - _e390) * _e394);
                                                        let _e1171 = select(_e1169, _e1168, (_e1168 < _e1169));
                                                        let _e1173 = select(_e1169, _e1168, (_e1168 > _e1169));
                                                        let _e1175 = select(_e1161, _e1160, (_e1160 < _e1161));
                                                        let _e1177 = select(_e1165, _e1164, (_e1164 < _e1165));
                                                        let _e1179 = select(_e1177, _e1175, (_e1175 > _e1177));
                                                        let _e1181 = select(_e1171, _e1179, (_e1179 > _e1171));
                                                        let _e1183 = select(_e1161, _e1160, (_e1160 > _e1161));
                                                        let _e1185 = select(_e1165, _e1164, (_e1164 > _e1165));
                                                        let _e1187 = select(_e1185, _e1183, (_e1183 < _e1185));
                                                        let _e1189 = select(_e1173, _e1187, (_e1187 < _e1173));
                                                        let _e1190 = -(_e1171);
                                                        let _e1196 = select(_e441, _e1181, (_e1181 > _e441));
                                                        if (_e1196 > (_e1189 + (select(_e1190, _e1173, (_e1173 > _e1190)) * 0.0000019073523f))) {
                                                            phi_2619_ = type_27();
                                                            phi_2620_ = true;
                                                        } else {
                                                            let _e1198 = (_e1196 > _e964.member);
                                                            if _e1198 {
                                                                phi_2618_ = type_27();
                                                            } else {
                                                                let _e1202 = (_e1060[1][0] - _e1060[0][0]);
                                                                let _e1203 = (_e1060[1][1] - _e1060[0][1]);
                                                                let _e1204 = (_e1060[1][2] - _e1060[0][2]);
                                                                let _e1205 = vec3<f32>(_e1202, _e1203, _e1204);
                                                                let _e1206 = (_e1060[2][0] - _e1060[1][0]);
                                                                let _e1207 = (_e1060[2][1] - _e1060[1][1]);
                                                                let _e1208 = (_e1060[2][2] - _e1060[1][2]);
                                                                let _e1209 = vec3<f32>(_e1206, _e1207, _e1208);
                                                                let _e1210 = (_e1060[0][0] - _e1060[2][0]);
                                                                let _e1211 = (_e1060[0][1] - _e1060[2][1]);
                                                                let _e1212 = (_e1060[0][2] - _e1060[2][2]);
                                                                let _e1213 = vec3<f32>(_e1210, _e1211, _e1212);
                                                                let _e1216 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                let _e1219 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                                let _e1224 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                let _e1226 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                                let _e1229 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                let _e1242 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1211) & 2147483647u));
                                                                let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1250 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                let _e1254 = select(_e1239, _e1226, (_e1226 > _e1239));
                                                                let _e1256 = select(_e1252, _e1254, (_e1254 > _e1252));
                                                                if (_e1226 == _e1256) {
                                                                    phi_2529_ = _e1209;
                                                                    phi_2530_ = _e1213;
                                                                } else {
                                                                    let _e1259 = vec3((_e1239 == _e1256));
                                                                    phi_2529_ = select(_e1205, _e1213, _e1259);
                                                                    phi_2530_ = select(_e1209, _e1205, _e1259);
                                                                }
                                                                let _e1263 = phi_2529_;
                                                                let _e1265 = phi_2530_;
                                                                let _e1272 = ((_e1263.y * _e1265.z) - (_e1265.y * _e1263.z));
                                                                let _e1277 = ((_e1263.z * _e1265.x) - (_e1265.z * _e1263.x));
                                                                let _e1280 = ((_e1263.x * _e1265.y) - (_e1265.x * _e1263.y));
                                                                if (_e1122 >= _e1126) {
                                                                    phi_2561_ = select(true, false, (_e1122 >= _e1130));
                                                                } else {
                                                                    phi_2561_ = true;
                                                                }
                                                                let _e1285 = phi_2561_;
                                                                if _e1285 {
                                                                    phi_2570_ = select(vec3<f32>(_e1060[2][0], _e1060[2][1], _e1060[2][2]), vec3<f32>(_e1060[1][0], _e1060[1][1], _e1060[1][2]), vec3((_e1126 >= _e1130)));
                                                                } else {
                                                                    phi_2570_ = vec3<f32>(_e1060[0][0], _e1060[0][1], _e1060[0][2]);
                                                                }
                                                                let _e1290 = phi_2570_;
                                                                let _e1307 = ((((_e1272 * (_e1290.x - _e290)) + (_e1277 * (_e1290.y - _e329))) + (_e1280 * (_e1290.z - _e367))) / (((_e1272 * _e315) + (_e1277 * _e353)) + (_e1280 * _e391)));
                                                                let _e1309 = select(_e1189, _e1307, (_e1307 < _e1189));
                                                                let _e1311 = select(_e1181, _e1309, (_e1309 > _e1181));
                                                                if (_e1311 >= _e441) {
                                                                    let _e1313 = (_e1311 <= _e964.member);
                                                                    if _e1313 {
                                                                        let _e1314 = (1f / _e1132);
                                                                        phi_2610_ = type_27(_e1311, (_e1126 * _e1314), (_e1130 * _e1314), _e993);
                                                                    } else {
                                                                        phi_2610_ = type_27();
                                                                    }
                                                                    let _e1319 = phi_2610_;
                                                                    phi_2612_ = _e1319;
                                                                    phi_2613_ = select(true, false, _e1313);
                                                                } else {
                                                                    phi_2612_ = type_27();
                                                                    phi_2613_ = true;
                                                                }
                                                                let _e1322 = phi_2612_;
                                                                let _e1324 = phi_2613_;
                                                                if _e1324 {
                                                                    phi_2617_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2617_ = _e1322;
                                                                }
                                                                let _e1326 = phi_2617_;
                                                                phi_2618_ = _e1326;
                                                            }
                                                            let _e1328 = phi_2618_;
                                                            phi_2619_ = _e1328;
                                                            phi_2620_ = _e1198;
                                                        }
                                                        let _e1330 = phi_2619_;
                                                        let _e1332 = phi_2620_;
                                                        phi_2624_ = _e1330;
                                                        phi_2625_ = _e1332;
                                                    }
                                                    let _e1334 = phi_2624_;
                                                    let _e1336 = phi_2625_;
                                                    phi_2629_ = _e1334;
                                                    phi_2630_ = _e1336;
                                                } else {
                                                    phi_2629_ = type_27();
                                                    phi_2630_ = true;
                                                }
                                                let _e1338 = phi_2629_;
                                                let _e1340 = phi_2630_;
                                                if _e1340 {
                                                    phi_2634_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2634_ = _e1338;
                                                }
                                                let _e1342 = phi_2634_;
                                                if (_e1342.member_3 != 4294967295u) {
                                                    if (_e993 != 4294967295u) {
                                                        phi_2645_ = type_40(_e964.member, true);
                                                    } else {
                                                        phi_2645_ = _e964;
                                                    }
                                                    let _e1350 = phi_2645_;
                                                    phi_2646_ = _e1350;
                                                } else {
                                                    phi_2646_ = _e964;
                                                }
                                                let _e1352 = phi_2646_;
                                                phi_1923_ = _e1352;
                                            } else {
                                                phi_1923_ = type_40();
                                            }
                                            let _e1354 = phi_1923_;
                                            continue;
                                            continuing {
                                                phi_1922_ = _e1354;
                                                phi_1925_ = _e979;
                                                phi_4169_ = _e483;
                                                break if !(_e985);
                                            }
                                        }
                                        let _e1357 = phi_4169_;
                                        phi_4276_ = _e1357;
                                        if _e1357 {
                                            break;
                                        }
                                        let _e1359 = local_4;
                                        phi_4280_ = _e1357;
                                        let _e1504 = local_6;
                                        phi_3950_ = _e1504;
                                        phi_3951_ = _e514;
                                        phi_3952_ = false;
                                        phi_3953_ = select(_e518, 0u, _e1359.member_1);
                                    } else {
                                        if (_e514.member_1 >= _e79) {
                                            phi_3550_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_47(type_31(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e514.member_1 < _e79) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e530 = ((1u + _e249) % 4u);
                                            if (_e530 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e535 = global_4.member[_e514.member_1][_e530];
                                            let _e537 = ((1u + _e248) % 4u);
                                            if (_e537 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e542 = global_4.member[_e514.member_1][_e537];
                                            let _e544 = ((1u + _e250) % 4u);
                                            if (_e544 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e549 = global_4.member[_e514.member_1][_e544];
                                            let _e551 = ((_e249 + 1u) % 4u);
                                            if (_e551 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e556 = global_4.member[_e514.member_1][_e551];
                                            let _e558 = (_e556 >> bitcast<u32>(11u));
                                            let _e560 = ((_e248 + 1u) % 4u);
                                            if (_e560 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e565 = global_4.member[_e514.member_1][_e560];
                                            let _e567 = (_e565 >> bitcast<u32>(11u));
                                            let _e569 = ((_e250 + 1u) % 4u);
                                            if (_e569 < 4u) {
                                            } else {
                                                phi_4276_ = true;
                                                break;
                                            }
                                            let _e574 = global_4.member[_e514.member_1][_e569];
                                            let _e576 = (_e574 >> bitcast<u32>(11u));
                                            let _e599 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.x - _e514.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e600 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.y - _e514.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e601 = (bitcast<f32>((bitcast<u32>((_e514.member.member_1.z - _e514.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e603 = select(_e129, _e599, (_e599 > _e129));
                                            let _e605 = select(_e129, _e600, (_e600 > _e129));
                                            let _e607 = select(_e129, _e601, (_e601 > _e129));
                                            let _e632 = bitcast<u32>((f32(bitcast<i32>((_e535 & 1023u))) * _e603));
                                            let _e637 = (bitcast<i32>((_e535 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e640 = bitcast<f32>((_e632 & bitcast<u32>(_e637)));
                                            let _e641 = bitcast<u32>((f32(bitcast<i32>((_e542 & 1023u))) * _e605));
                                            let _e646 = (bitcast<i32>((_e542 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e649 = bitcast<f32>((_e641 & bitcast<u32>(_e646)));
                                            let _e650 = bitcast<u32>((f32(bitcast<i32>((_e549 & 1023u))) * _e607));
                                            let _e655 = (bitcast<i32>((_e549 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e658 = bitcast<f32>((_e650 & bitcast<u32>(_e655)));
                                            let _e662 = bitcast<f32>((_e632 & bitcast<u32>(~(_e637))));
                                            let _e666 = bitcast<f32>((_e641 & bitcast<u32>(~(_e646))));
                                            let _e670 = bitcast<f32>((_e650 & bitcast<u32>(~(_e655))));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e558 & 1023u))) * _e603));
                                            let _e676 = (bitcast<i32>((_e558 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e680 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e605));
                                            let _e685 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e688 = bitcast<f32>((_e680 & bitcast<u32>(_e685)));
                                            let _e689 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e607));
                                            let _e694 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e697 = bitcast<f32>((_e689 & bitcast<u32>(_e694)));
                                            let _e701 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e705 = bitcast<f32>((_e680 & bitcast<u32>(~(_e685))));
                                            let _e709 = bitcast<f32>((_e689 & bitcast<u32>(~(_e694))));
                                            let _e739 = global_4.member[_e514.member_1][0u];
                                            let _e743 = global_4.member[_e514.member_1][1u];
                                            let _e747 = global_4.member[_e514.member_1][2u];
                                            let _e751 = global_4.member[_e514.member_1][3u];
                                            let _e763 = (((_e743 >> bitcast<u32>(22i)) | ((_e747 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e751 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e764 = (_e739 & 268435455u);
                                            let _e765 = (_e763 & 268435455u);
                                            let _e768 = ((_e739 >> bitcast<u32>(28u)) & 7u);
                                            let _e776 = ((_e739 >> bitcast<u32>(31i)) | (((_e763 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e777 = (_e768 != 0u);
                                            if (_e768 == 0u) {
                                                phi_3512_ = _e764;
                                            } else {
                                                if (_e768 == 7u) {
                                                    phi_3511_ = 2147483648u;
                                                } else {
                                                    phi_3511_ = ((2147483648u | (_e768 << bitcast<u32>(28u))) | (_e765 & 268435455u));
                                                }
                                                let _e786 = phi_3511_;
                                                phi_3512_ = _e786;
                                            }
                                            let _e788 = phi_3512_;
                                            if _e777 {
                                                let _e789 = (_e768 != 7u);
                                                if _e789 {
                                                    phi_3522_ = (_e765 + _e768);
                                                } else {
                                                    phi_3522_ = u32();
                                                }
                                                let _e792 = phi_3522_;
                                                phi_3524_ = _e792;
                                                phi_3525_ = select(true, false, _e789);
                                            } else {
                                                phi_3524_ = u32();
                                                phi_3525_ = true;
                                            }
                                            let _e795 = phi_3524_;
                                            let _e797 = phi_3525_;
                                            if (_e776 == 0u) {
                                                phi_3546_ = (_e764 + select(0u, 1u, !(_e777)));
                                            } else {
                                                if (_e776 == 7u) {
                                                    phi_3545_ = 2147483648u;
                                                } else {
                                                    phi_3545_ = ((2147483648u | (_e776 << bitcast<u32>(28u))) | (select(_e795, _e765, _e797) & 268435455u));
                                                }
                                                let _e810 = phi_3545_;
                                                phi_3546_ = _e810;
                                            }
                                            let _e812 = phi_3546_;
                                            phi_3550_ = type_50(array<vec4<f32>, 3>(vec4<f32>((_e514.member.member.x + _e640), (_e514.member.member.x + _e662), (_e514.member.member_1.x - _e679), (_e514.member.member_1.x - _e701)), vec4<f32>((_e514.member.member.y + _e649), (_e514.member.member.y + _e666), (_e514.member.member_1.y - _e688), (_e514.member.member_1.y - _e705)), vec4<f32>((_e514.member.member.z + _e658), (_e514.member.member.z + _e670), (_e514.member.member_1.z - _e697), (_e514.member.member_1.z - _e709))), type_47(type_31((_e514.member.member + vec4<f32>(_e640, _e649, _e658, 0f)), (_e514.member.member_1 - vec4<f32>(_e679, _e688, _e697, 0f))), _e788), type_47(type_31((_e514.member.member + vec4<f32>(_e662, _e666, _e670, 0f)), (_e514.member.member_1 - vec4<f32>(_e701, _e705, _e709, 0f))), _e812));
                                        }
                                        let _e817 = phi_3550_;
                                        let _e829 = ((_e817.member[0].x - _e313) * _e318);
                                        let _e830 = ((_e817.member[0].y - _e313) * _e318);
                                        let _e831 = ((_e817.member[0].z - _e314) * _e318);
                                        let _e832 = ((_e817.member[0].w - _e314) * _e318);
                                        let _e842 = ((_e817.member[1].x - _e351) * _e356);
                                        let _e843 = ((_e817.member[1].y - _e351) * _e356);
                                        let _e844 = ((_e817.member[1].z - _e352) * _e356);
                                        let _e845 = ((_e817.member[1].w - _e352) * _e356);
                                        let _e855 = ((_e817.member[2].x - _e389) * _e394);
                                        let _e856 = ((_e817.member[2].y - _e389) * _e394);
                                        let _e857 = ((_e817.member[2].z - _e390) * _e394);
                                        let _e858 = ((_e817.member[2].w - _e390) * _e394);
                                        let _e860 = select(_e857, _e855, (_e855 < _e857));
                                        let _e862 = select(_e858, _e856, (_e856 < _e858));
                                        let _e864 = select(_e857, _e855, (_e855 > _e857));
                                        let _e866 = select(_e858, _e856, (_e856 > _e858));
                                        let _e868 = select(_e831, _e829, (_e829 < _e831));
                                        let _e870 = select(_e832, _e830, (_e830 < _e832));
                                        let _e872 = select(_e844, _e842, (_e842 < _e844));
                                        let _e874 = select(_e845, _e843, (_e843 < _e845));
                                        let _e876 = select(_e872, _e868, (_e868 > _e872));
                                        let _e878 = select(_e874, _e870, (_e870 > _e874));
                                        let _e880 = select(_e860, _e876, (_e876 > _e860));
                                        let _e882 = select(_e862, _e878, (_e878 > _e862));
                                        let _e884 = select(_e831, _e829, (_e829 > _e831));
                                        let _e886 = select(_e832, _e830, (_e830 > _e832));
                                        let _e888 = select(_e844, _e842, (_e842 > _e844));
                                        let _e890 = select(_e845, _e843, (_e843 > _e845));
                                        let _e892 = select(_e888, _e884, (_e884 < _e888));
                                        let _e894 = select(_e890, _e886, (_e886 < _e890));
                                        let _e899 = -(_e860);
                                        let _e900 = -(_e862);
                                        let _e907 = (select(_e864, _e892, (_e892 < _e864)) + (select(_e899, _e864, (_e864 > _e899)) * 0.0000019073523f));
                                        let _e908 = (select(_e866, _e894, (_e894 < _e866)) + (select(_e900, _e866, (_e866 > _e900)) * 0.0000019073523f));
                                        let _e910 = select(_e441, _e880, (_e880 > _e441));
                                        let _e912 = select(_e441, _e882, (_e882 > _e441));
                                        let _e917 = (_e910 <= select(_e485.member, _e907, (_e907 < _e485.member)));
                                        let _e918 = (_e912 <= select(_e485.member, _e908, (_e908 < _e485.member)));
                                        let _e919 = (_e910 <= _e912);
                                        if _e917 {
                                            if _e918 {
                                                if _e919 {
                                                    phi_3894_ = _e817.member_2;
                                                } else {
                                                    phi_3894_ = _e817.member_1;
                                                }
                                                let _e923 = phi_3894_;
                                                let _e924 = (_e518 % 128u);
                                                let _e925 = (_e924 < 128u);
                                                if _e925 {
                                                } else {
                                                    phi_4276_ = true;
                                                    break;
                                                }
                                                local_3[_e924] = type_47(type_31(_e923.member.member, _e923.member.member_1), _e923.member_1);
                                                if _e925 {
                                                } else {
                                                    phi_4276_ = true;
                                                    break;
                                                }
                                                local_2[_e924] = select(_e912, _e910, (_e910 > _e912));
                                                if _e919 {
                                                    phi_3927_ = _e817.member_1;
                                                } else {
                                                    phi_3927_ = _e817.member_2;
                                                }
                                                let _e940 = phi_3927_;
                                                phi_3928_ = _e940;
                                                phi_3929_ = (_e518 + 1u);
                                            } else {
                                                phi_3928_ = type_47();
                                                phi_3929_ = u32();
                                            }
                                            let _e942 = phi_3928_;
                                            let _e944 = phi_3929_;
                                            phi_3931_ = _e942;
                                            phi_3932_ = _e944;
                                            phi_3933_ = select(true, false, _e918);
                                        } else {
                                            phi_3931_ = type_47();
                                            phi_3932_ = u32();
                                            phi_3933_ = true;
                                        }
                                        let _e947 = phi_3931_;
                                        let _e949 = phi_3932_;
                                        let _e951 = phi_3933_;
                                        if _e951 {
                                            if _e917 {
                                                phi_3942_ = _e817.member_1;
                                            } else {
                                                phi_3942_ = _e817.member_2;
                                            }
                                            let _e955 = phi_3942_;
                                            phi_3947_ = _e955;
                                            phi_3948_ = select(_e918, true, _e917);
                                        } else {
                                            phi_3947_ = _e947;
                                            phi_3948_ = _e516;
                                        }
                                        let _e958 = phi_3947_;
                                        let _e960 = phi_3948_;
                                        phi_4280_ = _e483;
                                        phi_3950_ = _e485;
                                        phi_3951_ = _e958;
                                        phi_3952_ = _e960;
                                        phi_3953_ = select(_e949, _e518, _e951);
                                    }
                                    let _e1363 = phi_4280_;
                                    let _e1365 = phi_3950_;
                                    let _e1367 = phi_3951_;
                                    let _e1369 = phi_3952_;
                                    let _e1371 = phi_3953_;
                                    phi_4279_ = _e1363;
                                    phi_3954_ = _e1365;
                                    phi_3955_ = _e1367;
                                    phi_3956_ = (_e489 - 1u);
                                    phi_3957_ = _e1369;
                                    phi_3958_ = _e1371;
                                } else {
                                    phi_4279_ = _e483;
                                    phi_3954_ = _e485;
                                    phi_3955_ = _e514;
                                    phi_3956_ = _e489;
                                    phi_3957_ = _e516;
                                    phi_3958_ = _e518;
                                }
                                let _e1373 = phi_4279_;
                                let _e1375 = phi_3954_;
                                let _e1377 = phi_3955_;
                                let _e1379 = phi_3956_;
                                let _e1381 = phi_3957_;
                                let _e1383 = phi_3958_;
                                phi_4278_ = _e1373;
                                phi_3959_ = _e1375;
                                phi_3960_ = _e1377;
                                phi_3961_ = _e1379;
                                phi_3962_ = _e1381;
                                phi_3963_ = _e1383;
                            } else {
                                phi_4278_ = _e483;
                                phi_3959_ = type_40();
                                phi_3960_ = type_47();
                                phi_3961_ = u32();
                                phi_3962_ = bool();
                                phi_3963_ = u32();
                            }
                            let _e1385 = phi_4278_;
                            let _e1387 = phi_3959_;
                            let _e1389 = phi_3960_;
                            let _e1391 = phi_3961_;
                            let _e1393 = phi_3962_;
                            let _e1395 = phi_3963_;
                            phi_4277_ = _e1385;
                            phi_1846_ = _e1387;
                            phi_1849_ = _e1389;
                            phi_1851_ = _e1391;
                            phi_1853_ = _e1393;
                            phi_1855_ = _e1395;
                            phi_3964_ = _e497;
                        } else {
                            phi_4277_ = _e483;
                            phi_1846_ = type_40();
                            phi_1849_ = type_47();
                            phi_1851_ = u32();
                            phi_1853_ = bool();
                            phi_1855_ = u32();
                            phi_3964_ = false;
                        }
                        let _e1397 = phi_4277_;
                        let _e1399 = phi_1846_;
                        let _e1401 = phi_1849_;
                        let _e1403 = phi_1851_;
                        let _e1405 = phi_1853_;
                        let _e1407 = phi_1855_;
                        let _e1409 = phi_3964_;
                        continue;
                        continuing {
                            phi_4175_ = _e1397;
                            phi_1845_ = _e1399;
                            phi_1848_ = _e1401;
                            phi_1850_ = _e1403;
                            phi_1852_ = _e1405;
                            phi_1854_ = _e1407;
                            phi_4276_ = _e1397;
                            break if !(_e1409);
                        }
                    }
                    let _e1412 = phi_4276_;
                    if _e1412 {
                        break;
                    }
                    let _e1414 = local_5;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = select(0u, 1u, _e1414.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
