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

struct type_35 {
    member: array<type_25>,
}

struct type_39 {
    member: array<array<type_24, 8>>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_28,
    member_1: u32,
}

struct type_57 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_45;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_39;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_24, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_54, 128>;
    var local_5: array<u32, 3>;
    var local_6: array<array<f32, 3>, 3>;
    var local_7: array<f32, 4>;
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_452_: i32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_4877_: bool;
    var phi_4776_: f32;
    var phi_1953_: type_54;
    var phi_1956_: u32;
    var phi_1958_: bool;
    var phi_1960_: u32;
    var phi_1971_: bool;
    var phi_2009_: type_54;
    var phi_2010_: bool;
    var phi_2011_: u32;
    var phi_3703_: u32;
    var phi_3709_: u32;
    var phi_3963_: u32;
    var phi_3964_: u32;
    var phi_3974_: u32;
    var phi_3976_: u32;
    var phi_3977_: bool;
    var phi_3997_: u32;
    var phi_3998_: u32;
    var phi_4002_: type_57;
    var phi_4347_: type_54;
    var phi_4380_: type_54;
    var phi_4381_: type_54;
    var phi_4382_: u32;
    var phi_4384_: type_54;
    var phi_4385_: u32;
    var phi_4386_: bool;
    var phi_4395_: type_54;
    var phi_4400_: type_54;
    var phi_4401_: bool;
    var phi_4949_: f32;
    var phi_4874_: bool;
    var phi_2030_: type_8;
    var phi_2031_: type_8;
    var phi_2054_: type_8;
    var phi_2095_: u32;
    var phi_2101_: u32;
    var phi_2111_: u32;
    var phi_2127_: u32;
    var phi_2164_: u32;
    var phi_2170_: u32;
    var phi_2180_: u32;
    var phi_4859_: bool;
    var phi_2196_: type_8;
    var phi_2197_: type_8;
    var phi_2220_: type_8;
    var phi_2243_: u32;
    var phi_2258_: u32;
    var phi_2261_: type_8;
    var phi_2262_: type_8;
    var phi_2285_: type_8;
    var phi_2351_: u32;
    var phi_2331_: u32;
    var phi_2332_: u32;
    var phi_2355_: f32;
    var phi_4852_: bool;
    var phi_4931_: bool;
    var phi_4930_: bool;
    var phi_2856_: vec3<f32>;
    var phi_2857_: vec3<f32>;
    var phi_2888_: bool;
    var phi_2897_: vec3<f32>;
    var phi_2937_: type_24;
    var phi_2939_: type_24;
    var phi_2940_: bool;
    var phi_2944_: type_24;
    var phi_2945_: type_24;
    var phi_2946_: type_24;
    var phi_2947_: bool;
    var phi_2951_: type_24;
    var phi_2952_: bool;
    var phi_2956_: type_24;
    var phi_2957_: bool;
    var phi_2961_: type_24;
    var phi_2973_: type_8;
    var phi_2976_: type_24;
    var phi_2974_: type_8;
    var phi_2999_: type_8;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3053_: type_24;
    var phi_2977_: type_24;
    var phi_4961_: bool;
    var phi_5245_: f32;
    var phi_5244_: f32;
    var phi_5023_: bool;
    var phi_5243_: f32;
    var phi_5022_: bool;
    var phi_5242_: f32;
    var phi_5021_: bool;
    var phi_5182_: f32;
    var phi_5020_: bool;
    var phi_5147_: f32;
    var phi_5029_: bool;
    var phi_4403_: type_54;
    var phi_4404_: bool;
    var phi_4405_: u32;
    var phi_5146_: f32;
    var phi_5028_: bool;
    var phi_4406_: type_54;
    var phi_4407_: u32;
    var phi_4408_: bool;
    var phi_4409_: u32;
    var phi_5145_: f32;
    var phi_5027_: bool;
    var phi_4410_: type_54;
    var phi_4411_: u32;
    var phi_4412_: bool;
    var phi_4413_: u32;
    var phi_5144_: f32;
    var phi_5026_: bool;
    var phi_1954_: type_54;
    var phi_1957_: u32;
    var phi_1959_: bool;
    var phi_1961_: u32;
    var phi_4414_: bool;
    var phi_5025_: bool;
    var phi_4421_: type_8;
    var phi_4422_: type_8;
    var phi_4445_: type_8;
    var phi_4511_: type_24;
    var phi_5137_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_3.member));
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
            let _e151 = (_e150 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_4.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_4.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_4.member[_e150].member_1;
                    let _e213 = (bitcast<u32>(_e211) & 2147483647u);
                    let _e220 = global_4.member[_e150].member_3;
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && ((bitcast<u32>(_e220) & 2147483647u) <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_410_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_410_;
                        phi_411_ = _e243;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e245 = phi_411_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e169 == _e201);
                    }
                    let _e249 = phi_421_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_431_ = _e251;
                        phi_432_ = _e251;
                        phi_434_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e255 = phi_431_;
                    let _e257 = phi_432_;
                    let _e259 = phi_434_;
                    if _e259 {
                        phi_439_ = (_e257 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e263 = phi_439_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_452_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_472_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_490_ = _e302[0];
                    } else {
                        phi_490_ = _e302[1];
                    }
                    let _e307 = phi_490_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_496_ = _e302[2];
                    } else {
                        phi_496_ = _e307;
                    }
                    let _e311 = phi_496_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_507_ = _e314[0];
                    } else {
                        phi_507_ = _e314[1];
                    }
                    let _e318 = phi_507_;
                    if _e308 {
                        phi_513_ = _e314[2];
                    } else {
                        phi_513_ = _e318;
                    }
                    let _e321 = phi_513_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e335 = phi_536_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e323);
                    }
                    let _e341 = phi_547_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_556_ = _e302[0];
                    } else {
                        phi_556_ = _e302[1];
                    }
                    let _e346 = phi_556_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_562_ = _e302[2];
                    } else {
                        phi_562_ = _e346;
                    }
                    let _e350 = phi_562_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_573_ = _e314[0];
                    } else {
                        phi_573_ = _e314[1];
                    }
                    let _e356 = phi_573_;
                    if _e347 {
                        phi_579_ = _e314[2];
                    } else {
                        phi_579_ = _e356;
                    }
                    let _e359 = phi_579_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e373 = phi_602_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e361);
                    }
                    let _e379 = phi_613_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_622_ = _e302[0];
                    } else {
                        phi_622_ = _e302[1];
                    }
                    let _e384 = phi_622_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_628_ = _e302[2];
                    } else {
                        phi_628_ = _e384;
                    }
                    let _e388 = phi_628_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_639_ = _e314[0];
                    } else {
                        phi_639_ = _e314[1];
                    }
                    let _e394 = phi_639_;
                    if _e385 {
                        phi_645_ = _e314[2];
                    } else {
                        phi_645_ = _e394;
                    }
                    let _e397 = phi_645_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e411 = phi_668_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_679_ = 38685626000000000000000000f;
                    } else {
                        phi_679_ = (1f / _e399);
                    }
                    let _e417 = phi_679_;
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
                        phi_779_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_779_ = 0f;
                        phi_780_ = 1f;
                    }
                    let _e462 = phi_779_;
                    let _e464 = phi_780_;
                    local_2 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_54, 128>(type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
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
                    phi_4877_ = false;
                    phi_4776_ = _e462;
                    phi_1953_ = type_54(type_28(vec4<f32>((f32(_e470) * _e144), (f32(_e476) * _e144), (f32(_e482) * _e144), 0f), vec4<f32>((f32(_e487) * _e144), (f32(_e491) * _e144), (f32(_e495) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_1956_ = ((3u * _e93) + 1u);
                    phi_1958_ = (_e464 <= _e462);
                    phi_1960_ = 0u;
                    loop {
                        let _e505 = phi_4877_;
                        let _e507 = phi_4776_;
                        let _e509 = phi_1953_;
                        let _e511 = phi_1956_;
                        let _e513 = phi_1958_;
                        let _e515 = phi_1960_;
                        if _e513 {
                            phi_1971_ = true;
                        } else {
                            phi_1971_ = (_e515 > 0u);
                        }
                        let _e518 = phi_1971_;
                        if _e518 {
                            let _e519 = (_e511 > 0u);
                            if _e519 {
                                if _e513 {
                                    phi_2009_ = _e509;
                                    phi_2010_ = _e513;
                                    phi_2011_ = _e515;
                                } else {
                                    let _e520 = (_e515 - 1u);
                                    let _e521 = (_e520 % 128u);
                                    let _e522 = (_e521 < 128u);
                                    if _e522 {
                                    } else {
                                        phi_5025_ = true;
                                        break;
                                    }
                                    let _e524 = local_4[_e521];
                                    if _e522 {
                                    } else {
                                        phi_5025_ = true;
                                        break;
                                    }
                                    let _e532 = local_3[_e521];
                                    phi_2009_ = type_54(type_28(_e524.member.member, _e524.member.member_1), _e524.member_1);
                                    phi_2010_ = (_e532 <= _e507);
                                    phi_2011_ = _e520;
                                }
                                let _e535 = phi_2009_;
                                let _e537 = phi_2010_;
                                let _e539 = phi_2011_;
                                if _e537 {
                                    let _e544 = (_e535.member_1 & 268435455u);
                                    if ((_e535.member_1 & 2147483648u) != 0u) {
                                        phi_4949_ = _e507;
                                        phi_4874_ = _e505;
                                        phi_2030_ = type_8(0u, ((_e535.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1005 = phi_4949_;
                                            let _e1007 = phi_4874_;
                                            let _e1009 = phi_2030_;
                                            if (_e1009.member < _e1009.member_1) {
                                                phi_2031_ = type_8((_e1009.member + 1u), _e1009.member_1);
                                                phi_2054_ = type_8(1u, _e1009.member);
                                            } else {
                                                phi_2031_ = _e1009;
                                                phi_2054_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1022 = phi_2031_;
                                            let _e1024 = phi_2054_;
                                            let _e1028 = (bitcast<i32>(_e1024.member) != 0i);
                                            if _e1028 {
                                                let _e1033 = (_e535.member.member_1.x - _e535.member.member.x);
                                                let _e1036 = (_e535.member.member_1.y - _e535.member.member.y);
                                                let _e1039 = (_e535.member.member_1.z - _e535.member.member.z);
                                                let _e1041 = select(_e1036, _e1033, (_e1033 > _e1036));
                                                let _e1043 = select(_e1039, _e1041, (_e1041 > _e1039));
                                                let _e1045 = (_e1043 < (1024f * _e144));
                                                if _e1045 {
                                                    phi_2095_ = 0u;
                                                } else {
                                                    phi_2095_ = select(2u, 1u, (_e1043 < (2097152f * _e144)));
                                                }
                                                let _e1050 = phi_2095_;
                                                switch bitcast<i32>(_e1050) {
                                                    case 0: {
                                                        phi_2101_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2101_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2101_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2101_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1053 = phi_2101_;
                                                switch bitcast<i32>(_e1050) {
                                                    case 0: {
                                                        phi_2111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1060 = phi_2111_;
                                                let _e1062 = ((_e544 + (_e1024.member_1 * ((3u * _e1053) + 1u))) + (3u * _e1060));
                                                let _e1063 = (_e1062 < _e96);
                                                if _e1063 {
                                                    if _e1063 {
                                                    } else {
                                                        phi_5182_ = _e1005;
                                                        phi_5020_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_5.member[_e1062];
                                                    phi_2127_ = _e1065;
                                                } else {
                                                    phi_2127_ = 4294967295u;
                                                }
                                                let _e1067 = phi_2127_;
                                                local_5 = array<u32, 3>(_e264, _e263, _e265);
                                                if _e1045 {
                                                    phi_2164_ = 0u;
                                                } else {
                                                    phi_2164_ = select(2u, 1u, (_e1043 < (2097152f * _e144)));
                                                }
                                                let _e1073 = phi_2164_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_2170_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2170_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2170_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2170_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1076 = phi_2170_;
                                                switch bitcast<i32>(_e1073) {
                                                    case 0: {
                                                        phi_2180_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2180_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2180_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2180_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1083 = phi_2180_;
                                                local_7 = array<f32, 4>(_e535.member.member.x, _e535.member.member.y, _e535.member.member.z, _e535.member.member.w);
                                                local_6[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4859_ = _e1007;
                                                phi_2196_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1097 = phi_4859_;
                                                    let _e1099 = phi_2196_;
                                                    if (_e1099.member < _e1099.member_1) {
                                                        phi_2197_ = type_8((_e1099.member + 1u), _e1099.member_1);
                                                        phi_2220_ = type_8(1u, _e1099.member);
                                                    } else {
                                                        phi_2197_ = _e1099;
                                                        phi_2220_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1112 = phi_2197_;
                                                    let _e1114 = phi_2220_;
                                                    let _e1118 = (bitcast<i32>(_e1114.member) != 0i);
                                                    if _e1118 {
                                                        let _e1120 = ((_e544 + (_e1024.member_1 * ((3u * _e1076) + 1u))) + (_e1114.member_1 * _e1083));
                                                        let _e1121 = (_e1120 < _e96);
                                                        if _e1121 {
                                                            if _e1121 {
                                                            } else {
                                                                phi_4930_ = true;
                                                                break;
                                                            }
                                                            let _e1123 = global_5.member[_e1120];
                                                            phi_2243_ = _e1123;
                                                        } else {
                                                            phi_2243_ = 0u;
                                                        }
                                                        let _e1125 = phi_2243_;
                                                        let _e1126 = (_e1120 + 1u);
                                                        let _e1127 = (_e1126 < _e96);
                                                        if _e1127 {
                                                            if _e1127 {
                                                            } else {
                                                                phi_4930_ = true;
                                                                break;
                                                            }
                                                            let _e1129 = global_5.member[_e1126];
                                                            phi_2258_ = _e1129;
                                                        } else {
                                                            phi_2258_ = 0u;
                                                        }
                                                        let _e1131 = phi_2258_;
                                                        phi_2261_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1133 = phi_2261_;
                                                            if (_e1133.member < _e1133.member_1) {
                                                                phi_2262_ = type_8((_e1133.member + 1u), _e1133.member_1);
                                                                phi_2285_ = type_8(1u, _e1133.member);
                                                            } else {
                                                                phi_2262_ = _e1133;
                                                                phi_2285_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1146 = phi_2262_;
                                                            let _e1148 = phi_2285_;
                                                            let _e1152 = (bitcast<i32>(_e1148.member) != 0i);
                                                            if _e1152 {
                                                                let _e1153 = (_e1148.member_1 < 3u);
                                                                if _e1153 {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                let _e1155 = local_5[_e1148.member_1];
                                                                if (_e1148.member_1 < 4u) {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                let _e1158 = local_7[_e1148.member_1];
                                                                switch bitcast<i32>(_e1073) {
                                                                    case 0: {
                                                                        phi_2355_ = (_e1158 + (f32(((_e1125 >> bitcast<u32>(((10u * _e1155) & 31u))) & 1023u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1155 == 0u) {
                                                                            phi_2332_ = _e1125;
                                                                        } else {
                                                                            if (_e1155 == 1u) {
                                                                                phi_2331_ = ((_e1125 >> bitcast<u32>(21i)) | (_e1131 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2331_ = (_e1131 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1179 = phi_2331_;
                                                                            phi_2332_ = _e1179;
                                                                        }
                                                                        let _e1181 = phi_2332_;
                                                                        phi_2355_ = (_e1158 + (f32((_e1181 & 2097151u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1160 = (_e1120 + _e1155);
                                                                        let _e1161 = (_e1160 < _e96);
                                                                        if _e1161 {
                                                                            if _e1161 {
                                                                            } else {
                                                                                phi_4852_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1163 = global_5.member[_e1160];
                                                                            phi_2351_ = _e1163;
                                                                        } else {
                                                                            phi_2351_ = 0u;
                                                                        }
                                                                        let _e1165 = phi_2351_;
                                                                        phi_2355_ = (f32(bitcast<i32>(_e1165)) * _e144);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2355_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1195 = phi_2355_;
                                                                if (_e1114.member_1 < 3u) {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                if _e1153 {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                local_6[_e1114.member_1][_e1148.member_1] = _e1195;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2261_ = _e1146;
                                                                phi_4852_ = _e1097;
                                                                break if !(_e1152);
                                                            }
                                                        }
                                                        let _e1201 = phi_4852_;
                                                        phi_4930_ = _e1201;
                                                        if _e1201 {
                                                            break;
                                                        }
                                                        phi_4931_ = _e1201;
                                                    } else {
                                                        phi_4931_ = _e1097;
                                                    }
                                                    let _e1203 = phi_4931_;
                                                    continue;
                                                    continuing {
                                                        phi_4859_ = _e1203;
                                                        phi_2196_ = _e1112;
                                                        phi_4930_ = _e1203;
                                                        break if !(_e1118);
                                                    }
                                                }
                                                let _e1206 = phi_4930_;
                                                phi_5182_ = _e1005;
                                                phi_5020_ = _e1206;
                                                if _e1206 {
                                                    break;
                                                }
                                                let _e1207 = local_6;
                                                let _e1222 = (_e1207[0][2] - _e390);
                                                let _e1225 = (((_e1207[0][0] - _e313) * _e414) - (_e1222 * _e338));
                                                let _e1228 = (((_e1207[0][1] - _e352) * _e414) - (_e1222 * _e376));
                                                let _e1231 = (_e1207[1][2] - _e390);
                                                let _e1234 = (((_e1207[1][0] - _e313) * _e414) - (_e1231 * _e338));
                                                let _e1237 = (((_e1207[1][1] - _e352) * _e414) - (_e1231 * _e376));
                                                let _e1240 = (_e1207[2][2] - _e390);
                                                let _e1243 = (((_e1207[2][0] - _e313) * _e414) - (_e1240 * _e338));
                                                let _e1246 = (((_e1207[2][1] - _e352) * _e414) - (_e1240 * _e376));
                                                let _e1247 = (_e1243 * _e1237);
                                                let _e1248 = (_e1246 * _e1234);
                                                let _e1249 = (_e1225 * _e1246);
                                                let _e1250 = (_e1228 * _e1243);
                                                let _e1251 = (_e1234 * _e1228);
                                                let _e1252 = (_e1237 * _e1225);
                                                let _e1257 = (((_e1247 >= _e1248) && (_e1249 >= _e1250)) && (_e1251 >= _e1252));
                                                if (_e1257 || (((_e1247 <= _e1248) && (_e1249 <= _e1250)) && (_e1251 <= _e1252))) {
                                                    let _e1264 = select(-1f, 1f, _e1257);
                                                    let _e1266 = ((_e1247 - _e1248) * _e1264);
                                                    let _e1268 = select(0f, _e1266, (_e1266 > 0f));
                                                    let _e1270 = ((_e1249 - _e1250) * _e1264);
                                                    let _e1272 = select(0f, _e1270, (_e1270 > 0f));
                                                    let _e1274 = ((_e1251 - _e1252) * _e1264);
                                                    let _e1276 = select(0f, _e1274, (_e1274 > 0f));
                                                    let _e1278 = ((_e1268 + _e1272) + _e1276);
                                                    if (_e1278 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2951_ = type_24();
                                                        phi_2952_ = true;
                                                    } else {
                                                        let _e1281 = select(_e1207[1][0], _e1207[0][0], (_e1207[0][0] < _e1207[1][0]));
                                                        let _e1285 = select(_e1207[1][0], _e1207[0][0], (_e1207[0][0] > _e1207[1][0]));
                                                        let _e1289 = select(_e1207[1][1], _e1207[0][1], (_e1207[0][1] < _e1207[1][1]));
                                                        let _e1293 = select(_e1207[1][1], _e1207[0][1], (_e1207[0][1] > _e1207[1][1]));
                                                        let _e1297 = select(_e1207[1][2], _e1207[0][2], (_e1207[0][2] < _e1207[1][2]));
                                                        let _e1301 = select(_e1207[1][2], _e1207[0][2], (_e1207[0][2] > _e1207[1][2]));
                                                        let _e1306 = ((select(_e1207[2][0], _e1281, (_e1281 < _e1207[2][0])) - _e336) * _e341);
                                                        let _e1307 = ((select(_e1207[2][0], _e1285, (_e1285 > _e1207[2][0])) - _e337) * _e341);
                                                        let _e1310 = ((select(_e1207[2][1], _e1289, (_e1289 < _e1207[2][1])) - _e374) * _e379);
                                                        let _e1311 = ((select(_e1207[2][1], _e1293, (_e1293 > _e1207[2][1])) - _e375) * _e379);
                                                        let _e1314 = ((select(_e1207[2][2], _e1297, (_e1297 < _e1207[2][2])) - _e412) * _e417);
                                                        let _e1315 = ((select(_e1207[2][2], _e1301, (_e1301 > _e1207[2][2])) - _e413) * _e417);
                                                        let _e1317 = select(_e1315, _e1314, (_e1314 < _e1315));
                                                        let _e1319 = select(_e1315, _e1314, (_e1314 > _e1315));
                                                        let _e1321 = select(_e1307, _e1306, (_e1306 < _e1307));
                                                        let _e1323 = select(_e1311, _e1310, (_e1310 < _e1311));
                                                        let _e1325 = select(_e1323, _e1321, (_e1321 > _e1323));
                                                        let _e1327 = select(_e1317, _e1325, (_e1325 > _e1317));
                                                        let _e1329 = select(_e1307, _e1306, (_e1306 > _e1307));
                                                        let _e1331 = select(_e1311, _e1310, (_e1310 > _e1311));
                                                        let _e1333 = select(_e1331, _e1329, (_e1329 < _e1331));
                                                        let _e1335 = select(_e1319, _e1333, (_e1333 < _e1319));
                                                        let _e1336 = -(_e1317);
                                                        let _e1342 = select(_e464, _e1327, (_e1327 > _e464));
                                                        if (_e1342 > (_e1335 + (select(_e1336, _e1319, (_e1319 > _e1336)) * 0.0000019073523f))) {
                                                            phi_2946_ = type_24();
                                                            phi_2947_ = true;
                                                        } else {
                                                            let _e1344 = (_e1342 > _e1005);
                                                            if _e1344 {
                                                                phi_2945_ = type_24();
                                                            } else {
                                                                let _e1348 = (_e1207[1][0] - _e1207[0][0]);
                                                                let _e1349 = (_e1207[1][1] - _e1207[0][1]);
                                                                let _e1350 = (_e1207[1][2] - _e1207[0][2]);
                                                                let _e1351 = vec3<f32>(_e1348, _e1349, _e1350);
                                                                let _e1352 = (_e1207[2][0] - _e1207[1][0]);
                                                                let _e1353 = (_e1207[2][1] - _e1207[1][1]);
                                                                let _e1354 = (_e1207[2][2] - _e1207[1][2]);
                                                                let _e1355 = vec3<f32>(_e1352, _e1353, _e1354);
                                                                let _e1356 = (_e1207[0][0] - _e1207[2][0]);
                                                                let _e1357 = (_e1207[0][1] - _e1207[2][1]);
                                                                let _e1358 = (_e1207[0][2] - _e1207[2][2]);
                                                                let _e1359 = vec3<f32>(_e1356, _e1357, _e1358);
                                                                let _e1362 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1365 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                let _e1370 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                let _e1375 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                let _e1378 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                let _e1383 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                let _e1388 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1391 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                let _e1396 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                let _e1398 = select(_e1396, _e1393, (_e1393 > _e1396));
                                                                let _e1400 = select(_e1385, _e1372, (_e1372 > _e1385));
                                                                let _e1402 = select(_e1398, _e1400, (_e1400 > _e1398));
                                                                if (_e1372 == _e1402) {
                                                                    phi_2856_ = _e1355;
                                                                    phi_2857_ = _e1359;
                                                                } else {
                                                                    let _e1405 = vec3((_e1385 == _e1402));
                                                                    phi_2856_ = select(_e1351, _e1359, _e1405);
                                                                    phi_2857_ = select(_e1355, _e1351, _e1405);
                                                                }
                                                                let _e1409 = phi_2856_;
                                                                let _e1411 = phi_2857_;
                                                                let _e1418 = ((_e1409.y * _e1411.z) - (_e1411.y * _e1409.z));
                                                                let _e1423 = ((_e1409.z * _e1411.x) - (_e1411.z * _e1409.x));
                                                                let _e1426 = ((_e1409.x * _e1411.y) - (_e1411.x * _e1409.y));
                                                                if (_e1268 >= _e1272) {
                                                                    phi_2888_ = select(true, false, (_e1268 >= _e1276));
                                                                } else {
                                                                    phi_2888_ = true;
                                                                }
                                                                let _e1431 = phi_2888_;
                                                                if _e1431 {
                                                                    phi_2897_ = select(vec3<f32>(_e1207[2][0], _e1207[2][1], _e1207[2][2]), vec3<f32>(_e1207[1][0], _e1207[1][1], _e1207[1][2]), vec3((_e1272 >= _e1276)));
                                                                } else {
                                                                    phi_2897_ = vec3<f32>(_e1207[0][0], _e1207[0][1], _e1207[0][2]);
                                                                }
                                                                let _e1436 = phi_2897_;
                                                                let _e1453 = ((((_e1418 * (_e1436.x - _e313)) + (_e1423 * (_e1436.y - _e352))) + (_e1426 * (_e1436.z - _e390))) / (((_e1418 * _e338) + (_e1423 * _e376)) + (_e1426 * _e414)));
                                                                let _e1455 = select(_e1335, _e1453, (_e1453 < _e1335));
                                                                let _e1457 = select(_e1327, _e1455, (_e1455 > _e1327));
                                                                if (_e1457 >= _e464) {
                                                                    let _e1459 = (_e1457 <= _e1005);
                                                                    if _e1459 {
                                                                        let _e1460 = (1f / _e1278);
                                                                        phi_2937_ = type_24(_e1457, (_e1272 * _e1460), (_e1276 * _e1460), _e1067);
                                                                    } else {
                                                                        phi_2937_ = type_24();
                                                                    }
                                                                    let _e1465 = phi_2937_;
                                                                    phi_2939_ = _e1465;
                                                                    phi_2940_ = select(true, false, _e1459);
                                                                } else {
                                                                    phi_2939_ = type_24();
                                                                    phi_2940_ = true;
                                                                }
                                                                let _e1468 = phi_2939_;
                                                                let _e1470 = phi_2940_;
                                                                if _e1470 {
                                                                    phi_2944_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2944_ = _e1468;
                                                                }
                                                                let _e1472 = phi_2944_;
                                                                phi_2945_ = _e1472;
                                                            }
                                                            let _e1474 = phi_2945_;
                                                            phi_2946_ = _e1474;
                                                            phi_2947_ = _e1344;
                                                        }
                                                        let _e1476 = phi_2946_;
                                                        let _e1478 = phi_2947_;
                                                        phi_2951_ = _e1476;
                                                        phi_2952_ = _e1478;
                                                    }
                                                    let _e1480 = phi_2951_;
                                                    let _e1482 = phi_2952_;
                                                    phi_2956_ = _e1480;
                                                    phi_2957_ = _e1482;
                                                } else {
                                                    phi_2956_ = type_24();
                                                    phi_2957_ = true;
                                                }
                                                let _e1484 = phi_2956_;
                                                let _e1486 = phi_2957_;
                                                if _e1486 {
                                                    phi_2961_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2961_ = _e1484;
                                                }
                                                let _e1488 = phi_2961_;
                                                if (_e1488.member_3 != 4294967295u) {
                                                    if (_e1067 != 4294967295u) {
                                                        phi_2973_ = type_8(0u, 8u);
                                                        phi_2976_ = _e1488;
                                                        loop {
                                                            let _e1493 = phi_2973_;
                                                            let _e1495 = phi_2976_;
                                                            if (_e1493.member < _e1493.member_1) {
                                                                phi_2974_ = type_8((_e1493.member + 1u), _e1493.member_1);
                                                                phi_2999_ = type_8(1u, _e1493.member);
                                                            } else {
                                                                phi_2974_ = _e1493;
                                                                phi_2999_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1508 = phi_2974_;
                                                            let _e1510 = phi_2999_;
                                                            let _e1514 = (bitcast<i32>(_e1510.member) != 0i);
                                                            if _e1514 {
                                                                let _e1515 = (_e1510.member_1 < 8u);
                                                                if _e1515 {
                                                                } else {
                                                                    phi_4961_ = true;
                                                                    break;
                                                                }
                                                                let _e1520 = local_2[_e1510.member_1].member;
                                                                if (_e1495.member < _e1520) {
                                                                    phi_3032_ = true;
                                                                } else {
                                                                    let _e1522 = local_2[_e1510.member_1].member;
                                                                    if (_e1495.member == _e1522) {
                                                                        let _e1527 = local_2[_e1510.member_1].member_3;
                                                                        phi_3031_ = (_e1495.member_3 < _e1527);
                                                                    } else {
                                                                        phi_3031_ = false;
                                                                    }
                                                                    let _e1530 = phi_3031_;
                                                                    phi_3032_ = _e1530;
                                                                }
                                                                let _e1532 = phi_3032_;
                                                                if _e1532 {
                                                                    if _e1515 {
                                                                    } else {
                                                                        phi_4961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1533 = local_2[_e1510.member_1];
                                                                    local_2[_e1510.member_1] = type_24(_e1495.member, _e1495.member_1, _e1495.member_2, _e1495.member_3);
                                                                    phi_3053_ = type_24(_e1533.member, _e1533.member_1, _e1533.member_2, _e1533.member_3);
                                                                } else {
                                                                    phi_3053_ = _e1495;
                                                                }
                                                                let _e1544 = phi_3053_;
                                                                phi_2977_ = _e1544;
                                                            } else {
                                                                phi_2977_ = type_24();
                                                            }
                                                            let _e1546 = phi_2977_;
                                                            continue;
                                                            continuing {
                                                                phi_2973_ = _e1508;
                                                                phi_2976_ = _e1546;
                                                                phi_4961_ = _e1206;
                                                                break if !(_e1514);
                                                            }
                                                        }
                                                        let _e1549 = phi_4961_;
                                                        phi_5182_ = _e1005;
                                                        phi_5020_ = _e1549;
                                                        if _e1549 {
                                                            break;
                                                        }
                                                        let _e1552 = local_2[7u].member_3;
                                                        if (_e1552 != 4294967295u) {
                                                            let _e1556 = local_2[7u].member;
                                                            phi_5245_ = _e1556;
                                                        } else {
                                                            phi_5245_ = _e1005;
                                                        }
                                                        let _e1558 = phi_5245_;
                                                        phi_5244_ = _e1558;
                                                        phi_5023_ = _e1549;
                                                    } else {
                                                        phi_5244_ = _e1005;
                                                        phi_5023_ = _e1206;
                                                    }
                                                    let _e1560 = phi_5244_;
                                                    let _e1562 = phi_5023_;
                                                    phi_5243_ = _e1560;
                                                    phi_5022_ = _e1562;
                                                } else {
                                                    phi_5243_ = _e1005;
                                                    phi_5022_ = _e1206;
                                                }
                                                let _e1564 = phi_5243_;
                                                let _e1566 = phi_5022_;
                                                phi_5242_ = _e1564;
                                                phi_5021_ = _e1566;
                                            } else {
                                                phi_5242_ = _e1005;
                                                phi_5021_ = _e1007;
                                            }
                                            let _e1568 = phi_5242_;
                                            let _e1570 = phi_5021_;
                                            continue;
                                            continuing {
                                                phi_4949_ = _e1568;
                                                phi_4874_ = _e1570;
                                                phi_2030_ = _e1022;
                                                phi_5182_ = _e1568;
                                                phi_5020_ = _e1570;
                                                break if !(_e1028);
                                            }
                                        }
                                        let _e1573 = phi_5182_;
                                        let _e1575 = phi_5020_;
                                        phi_5025_ = _e1575;
                                        if _e1575 {
                                            break;
                                        }
                                        phi_5147_ = _e1573;
                                        phi_5029_ = _e1575;
                                        phi_4403_ = _e535;
                                        phi_4404_ = false;
                                        phi_4405_ = _e539;
                                    } else {
                                        if (_e535.member_1 >= _e93) {
                                            phi_4002_ = type_57(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e535.member_1 < _e93) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e552 = ((1u + _e264) % 4u);
                                            if (_e552 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e557 = global_3.member[_e535.member_1][_e552];
                                            let _e559 = ((1u + _e263) % 4u);
                                            if (_e559 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e564 = global_3.member[_e535.member_1][_e559];
                                            let _e566 = ((1u + _e265) % 4u);
                                            if (_e566 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e571 = global_3.member[_e535.member_1][_e566];
                                            let _e573 = ((_e264 + 1u) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e578 = global_3.member[_e535.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e582 = ((_e263 + 1u) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e587 = global_3.member[_e535.member_1][_e582];
                                            let _e589 = (_e587 >> bitcast<u32>(11u));
                                            let _e591 = ((_e265 + 1u) % 4u);
                                            if (_e591 < 4u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e596 = global_3.member[_e535.member_1][_e591];
                                            let _e598 = (_e596 >> bitcast<u32>(11u));
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.x - _e535.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.y - _e535.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e535.member.member_1.z - _e535.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e625 = select(_e144, _e621, (_e621 > _e144));
                                            let _e627 = select(_e144, _e622, (_e622 > _e144));
                                            let _e629 = select(_e144, _e623, (_e623 > _e144));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e557 & 1023u))) * _e625));
                                            let _e659 = (bitcast<i32>((_e557 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e564 & 1023u))) * _e627));
                                            let _e668 = (bitcast<i32>((_e564 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e672 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e629));
                                            let _e677 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e680 = bitcast<f32>((_e672 & bitcast<u32>(_e677)));
                                            let _e684 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e688 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e692 = bitcast<f32>((_e672 & bitcast<u32>(~(_e677))));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e625));
                                            let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e627));
                                            let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e711 = bitcast<u32>((f32(bitcast<i32>((_e598 & 1023u))) * _e629));
                                            let _e716 = (bitcast<i32>((_e598 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e719 = bitcast<f32>((_e711 & bitcast<u32>(_e716)));
                                            let _e723 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e727 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e731 = bitcast<f32>((_e711 & bitcast<u32>(~(_e716))));
                                            let _e732 = (_e535.member.member.x + _e662);
                                            let _e733 = (_e535.member.member.y + _e671);
                                            let _e734 = (_e535.member.member.z + _e680);
                                            let _e737 = (_e535.member.member_1.x - _e701);
                                            let _e738 = (_e535.member.member_1.y - _e710);
                                            let _e739 = (_e535.member.member_1.z - _e719);
                                            let _e758 = (_e737 - _e732);
                                            let _e759 = (_e738 - _e733);
                                            let _e760 = (_e739 - _e734);
                                            let _e762 = select(_e759, _e758, (_e758 > _e759));
                                            let _e764 = select(_e760, _e762, (_e762 > _e760));
                                            if (_e764 < (1024f * _e144)) {
                                                phi_3703_ = 0u;
                                            } else {
                                                phi_3703_ = select(2u, 1u, (_e764 < (2097152f * _e144)));
                                            }
                                            let _e771 = phi_3703_;
                                            switch bitcast<i32>(_e771) {
                                                case 0: {
                                                    phi_3709_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3709_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3709_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3709_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e774 = phi_3709_;
                                            let _e780 = global_3.member[_e535.member_1][0u];
                                            let _e784 = global_3.member[_e535.member_1][1u];
                                            let _e788 = global_3.member[_e535.member_1][2u];
                                            let _e792 = global_3.member[_e535.member_1][3u];
                                            let _e804 = (((_e784 >> bitcast<u32>(22i)) | ((_e788 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e792 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e805 = (_e780 & 268435455u);
                                            let _e806 = (_e804 & 268435455u);
                                            let _e809 = ((_e780 >> bitcast<u32>(28u)) & 7u);
                                            let _e817 = ((_e780 >> bitcast<u32>(31i)) | (((_e804 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e818 = (_e809 != 0u);
                                            if (_e809 == 0u) {
                                                phi_3964_ = _e805;
                                            } else {
                                                if (_e809 == 7u) {
                                                    phi_3963_ = 2147483648u;
                                                } else {
                                                    phi_3963_ = ((2147483648u | (_e809 << bitcast<u32>(28u))) | (_e806 & 268435455u));
                                                }
                                                let _e827 = phi_3963_;
                                                phi_3964_ = _e827;
                                            }
                                            let _e829 = phi_3964_;
                                            if _e818 {
                                                let _e830 = (_e809 != 7u);
                                                if _e830 {
                                                    phi_3974_ = (_e806 + (_e809 * ((3u * _e774) + 1u)));
                                                } else {
                                                    phi_3974_ = u32();
                                                }
                                                let _e834 = phi_3974_;
                                                phi_3976_ = _e834;
                                                phi_3977_ = select(true, false, _e830);
                                            } else {
                                                phi_3976_ = u32();
                                                phi_3977_ = true;
                                            }
                                            let _e837 = phi_3976_;
                                            let _e839 = phi_3977_;
                                            if (_e817 == 0u) {
                                                phi_3998_ = (_e805 + select(0u, 1u, !(_e818)));
                                            } else {
                                                if (_e817 == 7u) {
                                                    phi_3997_ = 2147483648u;
                                                } else {
                                                    phi_3997_ = ((2147483648u | (_e817 << bitcast<u32>(28u))) | (select(_e837, _e806, _e839) & 268435455u));
                                                }
                                                let _e852 = phi_3997_;
                                                phi_3998_ = _e852;
                                            }
                                            let _e854 = phi_3998_;
                                            phi_4002_ = type_57(array<vec4<f32>, 3>(vec4<f32>(_e732, (_e535.member.member.x + _e684), _e737, (_e535.member.member_1.x - _e723)), vec4<f32>(_e733, (_e535.member.member.y + _e688), _e738, (_e535.member.member_1.y - _e727)), vec4<f32>(_e734, (_e535.member.member.z + _e692), _e739, (_e535.member.member_1.z - _e731))), type_54(type_28((_e535.member.member + vec4<f32>(_e662, _e671, _e680, 0f)), (_e535.member.member_1 - vec4<f32>(_e701, _e710, _e719, 0f))), _e829), type_54(type_28((_e535.member.member + vec4<f32>(_e684, _e688, _e692, 0f)), (_e535.member.member_1 - vec4<f32>(_e723, _e727, _e731, 0f))), _e854));
                                        }
                                        let _e859 = phi_4002_;
                                        let _e870 = ((_e859.member[0].x - _e336) * _e341);
                                        let _e871 = ((_e859.member[0].y - _e336) * _e341);
                                        let _e872 = ((_e859.member[0].z - _e337) * _e341);
                                        let _e873 = ((_e859.member[0].w - _e337) * _e341);
                                        let _e883 = ((_e859.member[1].x - _e374) * _e379);
                                        let _e884 = ((_e859.member[1].y - _e374) * _e379);
                                        let _e885 = ((_e859.member[1].z - _e375) * _e379);
                                        let _e886 = ((_e859.member[1].w - _e375) * _e379);
                                        let _e896 = ((_e859.member[2].x - _e412) * _e417);
                                        let _e897 = ((_e859.member[2].y - _e412) * _e417);
                                        let _e898 = ((_e859.member[2].z - _e413) * _e417);
                                        let _e899 = ((_e859.member[2].w - _e413) * _e417);
                                        let _e901 = select(_e898, _e896, (_e896 < _e898));
                                        let _e903 = select(_e899, _e897, (_e897 < _e899));
                                        let _e905 = select(_e898, _e896, (_e896 > _e898));
                                        let _e907 = select(_e899, _e897, (_e897 > _e899));
                                        let _e909 = select(_e872, _e870, (_e870 < _e872));
                                        let _e911 = select(_e873, _e871, (_e871 < _e873));
                                        let _e913 = select(_e885, _e883, (_e883 < _e885));
                                        let _e915 = select(_e886, _e884, (_e884 < _e886));
                                        let _e917 = select(_e913, _e909, (_e909 > _e913));
                                        let _e919 = select(_e915, _e911, (_e911 > _e915));
                                        let _e921 = select(_e901, _e917, (_e917 > _e901));
                                        let _e923 = select(_e903, _e919, (_e919 > _e903));
                                        let _e925 = select(_e872, _e870, (_e870 > _e872));
                                        let _e927 = select(_e873, _e871, (_e871 > _e873));
                                        let _e929 = select(_e885, _e883, (_e883 > _e885));
                                        let _e931 = select(_e886, _e884, (_e884 > _e886));
                                        let _e933 = select(_e929, _e925, (_e925 < _e929));
                                        let _e935 = select(_e931, _e927, (_e927 < _e931));
                                        let _e940 = -(_e901);
                                        let _e941 = -(_e903);
                                        let _e948 = (select(_e905, _e933, (_e933 < _e905)) + (select(_e940, _e905, (_e905 > _e940)) * 0.0000019073523f));
                                        let _e949 = (select(_e907, _e935, (_e935 < _e907)) + (select(_e941, _e907, (_e907 > _e941)) * 0.0000019073523f));
                                        let _e951 = select(_e464, _e921, (_e921 > _e464));
                                        let _e953 = select(_e464, _e923, (_e923 > _e464));
                                        let _e958 = (_e951 <= select(_e507, _e948, (_e948 < _e507)));
                                        let _e959 = (_e953 <= select(_e507, _e949, (_e949 < _e507)));
                                        let _e960 = (_e951 <= _e953);
                                        if _e958 {
                                            if _e959 {
                                                if _e960 {
                                                    phi_4347_ = _e859.member_2;
                                                } else {
                                                    phi_4347_ = _e859.member_1;
                                                }
                                                let _e964 = phi_4347_;
                                                let _e965 = (_e539 % 128u);
                                                let _e966 = (_e965 < 128u);
                                                if _e966 {
                                                } else {
                                                    phi_5025_ = true;
                                                    break;
                                                }
                                                local_4[_e965] = type_54(type_28(_e964.member.member, _e964.member.member_1), _e964.member_1);
                                                if _e966 {
                                                } else {
                                                    phi_5025_ = true;
                                                    break;
                                                }
                                                local_3[_e965] = select(_e953, _e951, (_e951 > _e953));
                                                if _e960 {
                                                    phi_4380_ = _e859.member_1;
                                                } else {
                                                    phi_4380_ = _e859.member_2;
                                                }
                                                let _e981 = phi_4380_;
                                                phi_4381_ = _e981;
                                                phi_4382_ = (_e539 + 1u);
                                            } else {
                                                phi_4381_ = type_54();
                                                phi_4382_ = u32();
                                            }
                                            let _e983 = phi_4381_;
                                            let _e985 = phi_4382_;
                                            phi_4384_ = _e983;
                                            phi_4385_ = _e985;
                                            phi_4386_ = select(true, false, _e959);
                                        } else {
                                            phi_4384_ = type_54();
                                            phi_4385_ = u32();
                                            phi_4386_ = true;
                                        }
                                        let _e988 = phi_4384_;
                                        let _e990 = phi_4385_;
                                        let _e992 = phi_4386_;
                                        if _e992 {
                                            if _e958 {
                                                phi_4395_ = _e859.member_1;
                                            } else {
                                                phi_4395_ = _e859.member_2;
                                            }
                                            let _e996 = phi_4395_;
                                            phi_4400_ = _e996;
                                            phi_4401_ = select(_e959, true, _e958);
                                        } else {
                                            phi_4400_ = _e988;
                                            phi_4401_ = _e537;
                                        }
                                        let _e999 = phi_4400_;
                                        let _e1001 = phi_4401_;
                                        phi_5147_ = _e507;
                                        phi_5029_ = _e505;
                                        phi_4403_ = _e999;
                                        phi_4404_ = _e1001;
                                        phi_4405_ = select(_e990, _e539, _e992);
                                    }
                                    let _e1577 = phi_5147_;
                                    let _e1579 = phi_5029_;
                                    let _e1581 = phi_4403_;
                                    let _e1583 = phi_4404_;
                                    let _e1585 = phi_4405_;
                                    phi_5146_ = _e1577;
                                    phi_5028_ = _e1579;
                                    phi_4406_ = _e1581;
                                    phi_4407_ = (_e511 - 1u);
                                    phi_4408_ = _e1583;
                                    phi_4409_ = _e1585;
                                } else {
                                    phi_5146_ = _e507;
                                    phi_5028_ = _e505;
                                    phi_4406_ = _e535;
                                    phi_4407_ = _e511;
                                    phi_4408_ = _e537;
                                    phi_4409_ = _e539;
                                }
                                let _e1587 = phi_5146_;
                                let _e1589 = phi_5028_;
                                let _e1591 = phi_4406_;
                                let _e1593 = phi_4407_;
                                let _e1595 = phi_4408_;
                                let _e1597 = phi_4409_;
                                phi_5145_ = _e1587;
                                phi_5027_ = _e1589;
                                phi_4410_ = _e1591;
                                phi_4411_ = _e1593;
                                phi_4412_ = _e1595;
                                phi_4413_ = _e1597;
                            } else {
                                phi_5145_ = _e507;
                                phi_5027_ = _e505;
                                phi_4410_ = type_54();
                                phi_4411_ = u32();
                                phi_4412_ = bool();
                                phi_4413_ = u32();
                            }
                            let _e1599 = phi_5145_;
                            let _e1601 = phi_5027_;
                            let _e1603 = phi_4410_;
                            let _e1605 = phi_4411_;
                            let _e1607 = phi_4412_;
                            let _e1609 = phi_4413_;
                            phi_5144_ = _e1599;
                            phi_5026_ = _e1601;
                            phi_1954_ = _e1603;
                            phi_1957_ = _e1605;
                            phi_1959_ = _e1607;
                            phi_1961_ = _e1609;
                            phi_4414_ = _e519;
                        } else {
                            phi_5144_ = _e507;
                            phi_5026_ = _e505;
                            phi_1954_ = type_54();
                            phi_1957_ = u32();
                            phi_1959_ = bool();
                            phi_1961_ = u32();
                            phi_4414_ = false;
                        }
                        let _e1611 = phi_5144_;
                        let _e1613 = phi_5026_;
                        let _e1615 = phi_1954_;
                        let _e1617 = phi_1957_;
                        let _e1619 = phi_1959_;
                        let _e1621 = phi_1961_;
                        let _e1623 = phi_4414_;
                        continue;
                        continuing {
                            phi_4877_ = _e1613;
                            phi_4776_ = _e1611;
                            phi_1953_ = _e1615;
                            phi_1956_ = _e1617;
                            phi_1958_ = _e1619;
                            phi_1960_ = _e1621;
                            phi_5025_ = _e1613;
                            break if !(_e1623);
                        }
                    }
                    let _e1626 = phi_5025_;
                    if _e1626 {
                        break;
                    }
                    phi_4421_ = type_8(0u, 8u);
                    loop {
                        let _e1628 = phi_4421_;
                        if (_e1628.member < _e1628.member_1) {
                            phi_4422_ = type_8((_e1628.member + 1u), _e1628.member_1);
                            phi_4445_ = type_8(1u, _e1628.member);
                        } else {
                            phi_4422_ = _e1628;
                            phi_4445_ = type_8(0u, type_8().member_1);
                        }
                        let _e1641 = phi_4422_;
                        let _e1643 = phi_4445_;
                        let _e1647 = (bitcast<i32>(_e1643.member) != 0i);
                        if _e1647 {
                            let _e1648 = (_e1643.member_1 < 8u);
                            if _e1648 {
                            } else {
                                phi_5137_ = true;
                                break;
                            }
                            let _e1650 = local_2[_e1643.member_1];
                            if (_e1650.member_3 != 4294967295u) {
                                let _e1656 = -(_e431);
                                let _e1657 = (_e1656 / 3i);
                                let _e1664 = bitcast<f32>((bitcast<u32>((_e1657 + 127i)) << bitcast<u32>(23i)));
                                let _e1672 = (((_e1650.member * _e1664) * _e1664) * bitcast<f32>((bitcast<u32>(((_e1656 - (2i * _e1657)) + 127i)) << bitcast<u32>(23i))));
                                let _e1674 = select(340282350000000000000000000000000000000f, _e1672, (_e1672 < 340282350000000000000000000000000000000f));
                                phi_4511_ = type_24(select(-340282350000000000000000000000000000000f, _e1674, (_e1674 > -340282350000000000000000000000000000000f)), _e1650.member_1, _e1650.member_2, _e1650.member_3);
                            } else {
                                phi_4511_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1679 = phi_4511_;
                            if _e1648 {
                            } else {
                                phi_5137_ = true;
                                break;
                            }
                            local_2[_e1643.member_1] = type_24(_e1679.member, _e1679.member_1, _e1679.member_2, _e1679.member_3);
                        }
                        continue;
                        continuing {
                            phi_4421_ = _e1641;
                            phi_5137_ = _e1626;
                            break if !(_e1647);
                        }
                    }
                    let _e1687 = phi_5137_;
                    if _e1687 {
                        break;
                    }
                    let _e1688 = local_2;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = array<type_24, 8>(type_24(_e1688[0].member, _e1688[0].member_1, _e1688[0].member_2, _e1688[0].member_3), type_24(_e1688[1].member, _e1688[1].member_1, _e1688[1].member_2, _e1688[1].member_3), type_24(_e1688[2].member, _e1688[2].member_1, _e1688[2].member_2, _e1688[2].member_3), type_24(_e1688[3].member, _e1688[3].member_1, _e1688[3].member_2, _e1688[3].member_3), type_24(_e1688[4].member, _e1688[4].member_1, _e1688[4].member_2, _e1688[4].member_3), type_24(_e1688[5].member, _e1688[5].member_1, _e1688[5].member_2, _e1688[5].member_3), type_24(_e1688[6].member, _e1688[6].member_1, _e1688[6].member_2, _e1688[6].member_3), type_24(_e1688[7].member, _e1688[7].member_1, _e1688[7].member_2, _e1688[7].member_3));
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
