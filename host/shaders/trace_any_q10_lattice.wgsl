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

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: type_28,
    member_1: u32,
}

struct type_50 {
    member: array<vec4<f32>, 3>,
    member_1: type_49,
    member_2: type_49,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var phi_397_: i32;
    var phi_398_: i32;
    var phi_408_: bool;
    var phi_418_: u32;
    var phi_419_: u32;
    var phi_421_: bool;
    var phi_426_: u32;
    var phi_439_: i32;
    var phi_459_: i32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_626_: f32;
    var phi_632_: f32;
    var phi_655_: f32;
    var phi_666_: f32;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_3557_: bool;
    var phi_856_: type_38;
    var phi_859_: type_49;
    var phi_861_: u32;
    var phi_863_: bool;
    var phi_865_: u32;
    var phi_876_: bool;
    var phi_962_: type_49;
    var phi_963_: bool;
    var phi_964_: u32;
    var phi_2567_: u32;
    var phi_2573_: u32;
    var phi_2827_: u32;
    var phi_2828_: u32;
    var phi_2838_: u32;
    var phi_2840_: u32;
    var phi_2841_: bool;
    var phi_2861_: u32;
    var phi_2862_: u32;
    var phi_2866_: type_50;
    var phi_3210_: type_49;
    var phi_3287_: type_49;
    var phi_3288_: type_49;
    var phi_3289_: u32;
    var phi_3291_: type_49;
    var phi_3292_: u32;
    var phi_3293_: bool;
    var phi_3302_: type_49;
    var phi_3307_: type_49;
    var phi_3308_: bool;
    var phi_3554_: bool;
    var phi_983_: type_38;
    var phi_986_: type_8;
    var phi_987_: type_8;
    var phi_1009_: type_8;
    var phi_1050_: u32;
    var phi_1056_: u32;
    var phi_1066_: u32;
    var phi_1082_: u32;
    var phi_1119_: u32;
    var phi_1125_: u32;
    var phi_1135_: u32;
    var phi_3539_: bool;
    var phi_1151_: type_8;
    var phi_1152_: type_8;
    var phi_1175_: type_8;
    var phi_1198_: u32;
    var phi_1213_: u32;
    var phi_1216_: type_8;
    var phi_1217_: type_8;
    var phi_1240_: type_8;
    var phi_1306_: u32;
    var phi_1286_: u32;
    var phi_1287_: u32;
    var phi_1310_: f32;
    var phi_3532_: bool;
    var phi_3611_: bool;
    var phi_3610_: bool;
    var phi_1810_: vec3<f32>;
    var phi_1811_: vec3<f32>;
    var phi_1842_: bool;
    var phi_1851_: vec3<f32>;
    var phi_1891_: type_24;
    var phi_1893_: type_24;
    var phi_1894_: bool;
    var phi_1898_: type_24;
    var phi_1899_: type_24;
    var phi_1900_: type_24;
    var phi_1901_: bool;
    var phi_1905_: type_24;
    var phi_1906_: bool;
    var phi_1910_: type_24;
    var phi_1911_: bool;
    var phi_1915_: type_24;
    var phi_1926_: type_38;
    var phi_1927_: type_38;
    var phi_3613_: bool;
    var phi_984_: type_38;
    var phi_3612_: bool;
    var local_13: type_38;
    var phi_3672_: bool;
    var phi_3310_: type_38;
    var phi_3311_: type_49;
    var phi_3312_: bool;
    var phi_3313_: u32;
    var phi_3671_: bool;
    var phi_3314_: type_38;
    var phi_3315_: type_49;
    var phi_3316_: u32;
    var phi_3317_: bool;
    var phi_3318_: u32;
    var phi_3670_: bool;
    var phi_3319_: type_38;
    var phi_3320_: type_49;
    var phi_3321_: u32;
    var phi_3322_: bool;
    var phi_3323_: u32;
    var phi_3669_: bool;
    var phi_857_: type_38;
    var phi_860_: type_49;
    var phi_862_: u32;
    var phi_864_: bool;
    var phi_866_: u32;
    var phi_3324_: bool;
    var phi_3668_: bool;
    var local_14: type_38;
    var local_15: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e91 = global;
            let _e93 = arrayLength((&global_3.member));
            let _e96 = arrayLength((&global_6.member));
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
                let _e152 = (_e150 < arrayLength((&global_5.member)));
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
                            phi_397_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_397_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_397_;
                        phi_398_ = _e243;
                    } else {
                        phi_398_ = 0i;
                    }
                    let _e245 = phi_398_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_408_ = true;
                    } else {
                        phi_408_ = (_e169 == _e201);
                    }
                    let _e249 = phi_408_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_418_ = _e251;
                        phi_419_ = _e251;
                        phi_421_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_418_ = u32();
                        phi_419_ = 0u;
                        phi_421_ = true;
                    }
                    let _e255 = phi_418_;
                    let _e257 = phi_419_;
                    let _e259 = phi_421_;
                    if _e259 {
                        phi_426_ = (_e257 + 1u);
                    } else {
                        phi_426_ = 0u;
                    }
                    let _e263 = phi_426_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_439_ = -126i;
                    } else {
                        phi_439_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_439_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_459_ = -126i;
                    } else {
                        phi_459_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_459_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_477_ = _e302[0];
                    } else {
                        phi_477_ = _e302[1];
                    }
                    let _e307 = phi_477_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_483_ = _e302[2];
                    } else {
                        phi_483_ = _e307;
                    }
                    let _e311 = phi_483_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_494_ = _e314[0];
                    } else {
                        phi_494_ = _e314[1];
                    }
                    let _e318 = phi_494_;
                    if _e308 {
                        phi_500_ = _e314[2];
                    } else {
                        phi_500_ = _e318;
                    }
                    let _e321 = phi_500_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_523_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_523_ = 0f;
                    }
                    let _e335 = phi_523_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_534_ = 38685626000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e323);
                    }
                    let _e341 = phi_534_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_543_ = _e302[0];
                    } else {
                        phi_543_ = _e302[1];
                    }
                    let _e346 = phi_543_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_549_ = _e302[2];
                    } else {
                        phi_549_ = _e346;
                    }
                    let _e350 = phi_549_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_560_ = _e314[0];
                    } else {
                        phi_560_ = _e314[1];
                    }
                    let _e356 = phi_560_;
                    if _e347 {
                        phi_566_ = _e314[2];
                    } else {
                        phi_566_ = _e356;
                    }
                    let _e359 = phi_566_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_589_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_589_ = 0f;
                    }
                    let _e373 = phi_589_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e361);
                    }
                    let _e379 = phi_600_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_609_ = _e302[0];
                    } else {
                        phi_609_ = _e302[1];
                    }
                    let _e384 = phi_609_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_615_ = _e302[2];
                    } else {
                        phi_615_ = _e384;
                    }
                    let _e388 = phi_615_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_626_ = _e314[0];
                    } else {
                        phi_626_ = _e314[1];
                    }
                    let _e394 = phi_626_;
                    if _e385 {
                        phi_632_ = _e314[2];
                    } else {
                        phi_632_ = _e394;
                    }
                    let _e397 = phi_632_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_655_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_655_ = 0f;
                    }
                    let _e411 = phi_655_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_666_ = 38685626000000000000000000f;
                    } else {
                        phi_666_ = (1f / _e399);
                    }
                    let _e417 = phi_666_;
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
                        phi_766_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_767_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_766_ = 0f;
                        phi_767_ = 1f;
                    }
                    let _e462 = phi_766_;
                    let _e464 = phi_767_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e264 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e263 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e265 % 3u);
                    let _e481 = (_e480 < 3u);
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e483 = local_1[_e480];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e474];
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e496 = local[_e480];
                    phi_3557_ = false;
                    phi_856_ = type_38(_e462, false);
                    phi_859_ = type_49(type_28(vec4<f32>((f32(_e471) * _e144), (f32(_e477) * _e144), (f32(_e483) * _e144), 0f), vec4<f32>((f32(_e488) * _e144), (f32(_e492) * _e144), (f32(_e496) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_861_ = ((3u * _e93) + 1u);
                    phi_863_ = (_e464 <= _e462);
                    phi_865_ = 0u;
                    loop {
                        let _e506 = phi_3557_;
                        let _e508 = phi_856_;
                        let _e510 = phi_859_;
                        let _e512 = phi_861_;
                        let _e514 = phi_863_;
                        let _e516 = phi_865_;
                        local_14 = _e508;
                        if _e514 {
                            phi_876_ = true;
                        } else {
                            phi_876_ = (_e516 > 0u);
                        }
                        let _e519 = phi_876_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_962_ = _e510;
                                    phi_963_ = _e514;
                                    phi_964_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3668_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_962_ = type_49(type_28(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_963_ = (_e543 <= _e508.member);
                                    phi_964_ = _e521;
                                }
                                let _e547 = phi_962_;
                                let _e549 = phi_963_;
                                let _e551 = phi_964_;
                                if _e549 {
                                    let _e556 = (_e547.member_1 & 268435455u);
                                    if ((_e547.member_1 & 2147483648u) != 0u) {
                                        phi_3554_ = _e506;
                                        phi_983_ = _e508;
                                        phi_986_ = type_8(0u, ((_e547.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1037 = phi_3554_;
                                            let _e1039 = phi_983_;
                                            let _e1041 = phi_986_;
                                            local_13 = _e1039;
                                            local_15 = _e1039;
                                            if (_e1041.member < _e1041.member_1) {
                                                phi_987_ = type_8((_e1041.member + 1u), _e1041.member_1);
                                                phi_1009_ = type_8(1u, _e1041.member);
                                            } else {
                                                phi_987_ = _e1041;
                                                phi_1009_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1054 = phi_987_;
                                            let _e1056 = phi_1009_;
                                            let _e1060 = (bitcast<i32>(_e1056.member) != 0i);
                                            if _e1060 {
                                                let _e1065 = (_e547.member.member_1.x - _e547.member.member.x);
                                                let _e1068 = (_e547.member.member_1.y - _e547.member.member.y);
                                                let _e1071 = (_e547.member.member_1.z - _e547.member.member.z);
                                                let _e1073 = select(_e1068, _e1065, (_e1065 > _e1068));
                                                let _e1075 = select(_e1071, _e1073, (_e1073 > _e1071));
                                                let _e1077 = (_e1075 < (1024f * _e144));
                                                if _e1077 {
                                                    phi_1050_ = 0u;
                                                } else {
                                                    phi_1050_ = select(2u, 1u, (_e1075 < (2097152f * _e144)));
                                                }
                                                let _e1082 = phi_1050_;
                                                switch bitcast<i32>(_e1082) {
                                                    case 0: {
                                                        phi_1056_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1056_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1056_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1056_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1085 = phi_1056_;
                                                switch bitcast<i32>(_e1082) {
                                                    case 0: {
                                                        phi_1066_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1066_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1066_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1066_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1092 = phi_1066_;
                                                let _e1094 = ((_e556 + (_e1056.member_1 * ((3u * _e1085) + 1u))) + (3u * _e1092));
                                                let _e1095 = (_e1094 < _e96);
                                                if _e1095 {
                                                    if _e1095 {
                                                    } else {
                                                        phi_3612_ = true;
                                                        break;
                                                    }
                                                    let _e1097 = global_6.member[_e1094];
                                                    phi_1082_ = _e1097;
                                                } else {
                                                    phi_1082_ = 4294967295u;
                                                }
                                                let _e1099 = phi_1082_;
                                                local_10 = array<u32, 3>(_e264, _e263, _e265);
                                                if _e1077 {
                                                    phi_1119_ = 0u;
                                                } else {
                                                    phi_1119_ = select(2u, 1u, (_e1075 < (2097152f * _e144)));
                                                }
                                                let _e1105 = phi_1119_;
                                                switch bitcast<i32>(_e1105) {
                                                    case 0: {
                                                        phi_1125_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1125_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1125_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1125_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1108 = phi_1125_;
                                                switch bitcast<i32>(_e1105) {
                                                    case 0: {
                                                        phi_1135_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1135_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1135_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1135_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1115 = phi_1135_;
                                                local_12 = array<f32, 4>(_e547.member.member.x, _e547.member.member.y, _e547.member.member.z, _e547.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3539_ = _e1037;
                                                phi_1151_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1129 = phi_3539_;
                                                    let _e1131 = phi_1151_;
                                                    if (_e1131.member < _e1131.member_1) {
                                                        phi_1152_ = type_8((_e1131.member + 1u), _e1131.member_1);
                                                        phi_1175_ = type_8(1u, _e1131.member);
                                                    } else {
                                                        phi_1152_ = _e1131;
                                                        phi_1175_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1144 = phi_1152_;
                                                    let _e1146 = phi_1175_;
                                                    let _e1150 = (bitcast<i32>(_e1146.member) != 0i);
                                                    if _e1150 {
                                                        let _e1152 = ((_e556 + (_e1056.member_1 * ((3u * _e1108) + 1u))) + (_e1146.member_1 * _e1115));
                                                        let _e1153 = (_e1152 < _e96);
                                                        if _e1153 {
                                                            if _e1153 {
                                                            } else {
                                                                phi_3610_ = true;
                                                                break;
                                                            }
                                                            let _e1155 = global_6.member[_e1152];
                                                            phi_1198_ = _e1155;
                                                        } else {
                                                            phi_1198_ = 0u;
                                                        }
                                                        let _e1157 = phi_1198_;
                                                        let _e1158 = (_e1152 + 1u);
                                                        let _e1159 = (_e1158 < _e96);
                                                        if _e1159 {
                                                            if _e1159 {
                                                            } else {
                                                                phi_3610_ = true;
                                                                break;
                                                            }
                                                            let _e1161 = global_6.member[_e1158];
                                                            phi_1213_ = _e1161;
                                                        } else {
                                                            phi_1213_ = 0u;
                                                        }
                                                        let _e1163 = phi_1213_;
                                                        phi_1216_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1165 = phi_1216_;
                                                            if (_e1165.member < _e1165.member_1) {
                                                                phi_1217_ = type_8((_e1165.member + 1u), _e1165.member_1);
                                                                phi_1240_ = type_8(1u, _e1165.member);
                                                            } else {
                                                                phi_1217_ = _e1165;
                                                                phi_1240_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1178 = phi_1217_;
                                                            let _e1180 = phi_1240_;
                                                            let _e1184 = (bitcast<i32>(_e1180.member) != 0i);
                                                            if _e1184 {
                                                                let _e1185 = (_e1180.member_1 < 3u);
                                                                if _e1185 {
                                                                } else {
                                                                    phi_3532_ = true;
                                                                    break;
                                                                }
                                                                let _e1187 = local_10[_e1180.member_1];
                                                                if (_e1180.member_1 < 4u) {
                                                                } else {
                                                                    phi_3532_ = true;
                                                                    break;
                                                                }
                                                                let _e1190 = local_12[_e1180.member_1];
                                                                switch bitcast<i32>(_e1105) {
                                                                    case 0: {
                                                                        phi_1310_ = (_e1190 + (f32(((_e1157 >> bitcast<u32>(((10u * _e1187) & 31u))) & 1023u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1187 == 0u) {
                                                                            phi_1287_ = _e1157;
                                                                        } else {
                                                                            if (_e1187 == 1u) {
                                                                                phi_1286_ = ((_e1157 >> bitcast<u32>(21i)) | (_e1163 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1286_ = (_e1163 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1211 = phi_1286_;
                                                                            phi_1287_ = _e1211;
                                                                        }
                                                                        let _e1213 = phi_1287_;
                                                                        phi_1310_ = (_e1190 + (f32((_e1213 & 2097151u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1192 = (_e1152 + _e1187);
                                                                        let _e1193 = (_e1192 < _e96);
                                                                        if _e1193 {
                                                                            if _e1193 {
                                                                            } else {
                                                                                phi_3532_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1195 = global_6.member[_e1192];
                                                                            phi_1306_ = _e1195;
                                                                        } else {
                                                                            phi_1306_ = 0u;
                                                                        }
                                                                        let _e1197 = phi_1306_;
                                                                        phi_1310_ = (f32(bitcast<i32>(_e1197)) * _e144);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1310_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1227 = phi_1310_;
                                                                if (_e1146.member_1 < 3u) {
                                                                } else {
                                                                    phi_3532_ = true;
                                                                    break;
                                                                }
                                                                if _e1185 {
                                                                } else {
                                                                    phi_3532_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1146.member_1][_e1180.member_1] = _e1227;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1216_ = _e1178;
                                                                phi_3532_ = _e1129;
                                                                break if !(_e1184);
                                                            }
                                                        }
                                                        let _e1233 = phi_3532_;
                                                        phi_3610_ = _e1233;
                                                        if _e1233 {
                                                            break;
                                                        }
                                                        phi_3611_ = _e1233;
                                                    } else {
                                                        phi_3611_ = _e1129;
                                                    }
                                                    let _e1235 = phi_3611_;
                                                    continue;
                                                    continuing {
                                                        phi_3539_ = _e1235;
                                                        phi_1151_ = _e1144;
                                                        phi_3610_ = _e1235;
                                                        break if !(_e1150);
                                                    }
                                                }
                                                let _e1238 = phi_3610_;
                                                phi_3612_ = _e1238;
                                                if _e1238 {
                                                    break;
                                                }
                                                let _e1239 = local_11;
                                                let _e1255 = (_e1239[0][2] - _e390);
                                                let _e1258 = (((_e1239[0][0] - _e313) * _e414) - (_e1255 * _e338));
                                                let _e1261 = (((_e1239[0][1] - _e352) * _e414) - (_e1255 * _e376));
                                                let _e1264 = (_e1239[1][2] - _e390);
                                                let _e1267 = (((_e1239[1][0] - _e313) * _e414) - (_e1264 * _e338));
                                                let _e1270 = (((_e1239[1][1] - _e352) * _e414) - (_e1264 * _e376));
                                                let _e1273 = (_e1239[2][2] - _e390);
                                                let _e1276 = (((_e1239[2][0] - _e313) * _e414) - (_e1273 * _e338));
                                                let _e1279 = (((_e1239[2][1] - _e352) * _e414) - (_e1273 * _e376));
                                                let _e1280 = (_e1276 * _e1270);
                                                let _e1281 = (_e1279 * _e1267);
                                                let _e1282 = (_e1258 * _e1279);
                                                let _e1283 = (_e1261 * _e1276);
                                                let _e1284 = (_e1267 * _e1261);
                                                let _e1285 = (_e1270 * _e1258);
                                                let _e1290 = (((_e1280 >= _e1281) && (_e1282 >= _e1283)) && (_e1284 >= _e1285));
                                                if (_e1290 || (((_e1280 <= _e1281) && (_e1282 <= _e1283)) && (_e1284 <= _e1285))) {
                                                    let _e1297 = select(-1f, 1f, _e1290);
                                                    let _e1299 = ((_e1280 - _e1281) * _e1297);
                                                    let _e1301 = select(0f, _e1299, (_e1299 > 0f));
                                                    let _e1303 = ((_e1282 - _e1283) * _e1297);
                                                    let _e1305 = select(0f, _e1303, (_e1303 > 0f));
                                                    let _e1307 = ((_e1284 - _e1285) * _e1297);
                                                    let _e1309 = select(0f, _e1307, (_e1307 > 0f));
                                                    let _e1311 = ((_e1301 + _e1305) + _e1309);
                                                    if (_e1311 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1905_ = type_24();
                                                        phi_1906_ = true;
                                                    } else {
                                                        let _e1314 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] < _e1239[1][0]));
                                                        let _e1318 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] > _e1239[1][0]));
                                                        let _e1322 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] < _e1239[1][1]));
                                                        let _e1326 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] > _e1239[1][1]));
                                                        let _e1330 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] < _e1239[1][2]));
                                                        let _e1334 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] > _e1239[1][2]));
                                                        let _e1339 = ((select(_e1239[2][0], _e1314, (_e1314 < _e1239[2][0])) - _e336) * _e341);
                                                        let _e1340 = ((select(_e1239[2][0], _e1318, (_e1318 > _e1239[2][0])) - _e337) * _e341);
                                                        let _e1343 = ((select(_e1239[2][1], _e1322, (_e1322 < _e1239[2][1])) - _e374) * _e379);
                                                        let _e1344 = ((select(_e1239[2][1], _e1326, (_e1326 > _e1239[2][1])) - _e375) * _e379);
                                                        let _e1347 = ((select(_e1239[2][2], _e1330, (_e1330 < _e1239[2][2])) - _e412) * _e417);
                                                        let _e1348 = ((select(_e1239[2][2], _e1334, (_e1334 > _e1239[2][2])) - _e413) * _e417);
                                                        let _e1350 = select(_e1348, _e1347, (_e1347 < _e1348));
                                                        let _e1352 = select(_e1348, _e1347, (_e1347 > _e1348));
                                                        let _e1354 = select(_e1340, _e1339, (_e1339 < _e1340));
                                                        let _e1356 = select(_e1344, _e1343, (_e1343 < _e1344));
                                                        let _e1358 = select(_e1356, _e1354, (_e1354 > _e1356));
                                                        let _e1360 = select(_e1350, _e1358, (_e1358 > _e1350));
                                                        let _e1362 = select(_e1340, _e1339, (_e1339 > _e1340));
                                                        let _e1364 = select(_e1344, _e1343, (_e1343 > _e1344));
                                                        let _e1366 = select(_e1364, _e1362, (_e1362 < _e1364));
                                                        let _e1368 = select(_e1352, _e1366, (_e1366 < _e1352));
                                                        let _e1369 = -(_e1350);
                                                        let _e1375 = select(_e464, _e1360, (_e1360 > _e464));
                                                        if (_e1375 > (_e1368 + (select(_e1369, _e1352, (_e1352 > _e1369)) * 0.0000019073523f))) {
                                                            phi_1900_ = type_24();
                                                            phi_1901_ = true;
                                                        } else {
                                                            let _e1377 = (_e1375 > _e1039.member);
                                                            if _e1377 {
                                                                phi_1899_ = type_24();
                                                            } else {
                                                                let _e1381 = (_e1239[1][0] - _e1239[0][0]);
                                                                let _e1382 = (_e1239[1][1] - _e1239[0][1]);
                                                                let _e1383 = (_e1239[1][2] - _e1239[0][2]);
                                                                let _e1384 = vec3<f32>(_e1381, _e1382, _e1383);
                                                                let _e1385 = (_e1239[2][0] - _e1239[1][0]);
                                                                let _e1386 = (_e1239[2][1] - _e1239[1][1]);
                                                                let _e1387 = (_e1239[2][2] - _e1239[1][2]);
                                                                let _e1388 = vec3<f32>(_e1385, _e1386, _e1387);
                                                                let _e1389 = (_e1239[0][0] - _e1239[2][0]);
                                                                let _e1390 = (_e1239[0][1] - _e1239[2][1]);
                                                                let _e1391 = (_e1239[0][2] - _e1239[2][2]);
                                                                let _e1392 = vec3<f32>(_e1389, _e1390, _e1391);
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                let _e1398 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                let _e1400 = select(_e1398, _e1395, (_e1395 > _e1398));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1383) & 2147483647u));
                                                                let _e1405 = select(_e1403, _e1400, (_e1400 > _e1403));
                                                                let _e1408 = bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u));
                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u));
                                                                let _e1413 = select(_e1411, _e1408, (_e1408 > _e1411));
                                                                let _e1416 = bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u));
                                                                let _e1418 = select(_e1416, _e1413, (_e1413 > _e1416));
                                                                let _e1421 = bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u));
                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1390) & 2147483647u));
                                                                let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                let _e1429 = bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u));
                                                                let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                                                let _e1433 = select(_e1418, _e1405, (_e1405 > _e1418));
                                                                let _e1435 = select(_e1431, _e1433, (_e1433 > _e1431));
                                                                if (_e1405 == _e1435) {
                                                                    phi_1810_ = _e1388;
                                                                    phi_1811_ = _e1392;
                                                                } else {
                                                                    let _e1438 = vec3((_e1418 == _e1435));
                                                                    phi_1810_ = select(_e1384, _e1392, _e1438);
                                                                    phi_1811_ = select(_e1388, _e1384, _e1438);
                                                                }
                                                                let _e1442 = phi_1810_;
                                                                let _e1444 = phi_1811_;
                                                                let _e1451 = ((_e1442.y * _e1444.z) - (_e1444.y * _e1442.z));
                                                                let _e1456 = ((_e1442.z * _e1444.x) - (_e1444.z * _e1442.x));
                                                                let _e1459 = ((_e1442.x * _e1444.y) - (_e1444.x * _e1442.y));
                                                                if (_e1301 >= _e1305) {
                                                                    phi_1842_ = select(true, false, (_e1301 >= _e1309));
                                                                } else {
                                                                    phi_1842_ = true;
                                                                }
                                                                let _e1464 = phi_1842_;
                                                                if _e1464 {
                                                                    phi_1851_ = select(vec3<f32>(_e1239[2][0], _e1239[2][1], _e1239[2][2]), vec3<f32>(_e1239[1][0], _e1239[1][1], _e1239[1][2]), vec3((_e1305 >= _e1309)));
                                                                } else {
                                                                    phi_1851_ = vec3<f32>(_e1239[0][0], _e1239[0][1], _e1239[0][2]);
                                                                }
                                                                let _e1469 = phi_1851_;
                                                                let _e1486 = ((((_e1451 * (_e1469.x - _e313)) + (_e1456 * (_e1469.y - _e352))) + (_e1459 * (_e1469.z - _e390))) / (((_e1451 * _e338) + (_e1456 * _e376)) + (_e1459 * _e414)));
                                                                let _e1488 = select(_e1368, _e1486, (_e1486 < _e1368));
                                                                let _e1490 = select(_e1360, _e1488, (_e1488 > _e1360));
                                                                if (_e1490 >= _e464) {
                                                                    let _e1492 = (_e1490 <= _e1039.member);
                                                                    if _e1492 {
                                                                        let _e1493 = (1f / _e1311);
                                                                        phi_1891_ = type_24(_e1490, (_e1305 * _e1493), (_e1309 * _e1493), _e1099);
                                                                    } else {
                                                                        phi_1891_ = type_24();
                                                                    }
                                                                    let _e1498 = phi_1891_;
                                                                    phi_1893_ = _e1498;
                                                                    phi_1894_ = select(true, false, _e1492);
                                                                } else {
                                                                    phi_1893_ = type_24();
                                                                    phi_1894_ = true;
                                                                }
                                                                let _e1501 = phi_1893_;
                                                                let _e1503 = phi_1894_;
                                                                if _e1503 {
                                                                    phi_1898_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1898_ = _e1501;
                                                                }
                                                                let _e1505 = phi_1898_;
                                                                phi_1899_ = _e1505;
                                                            }
                                                            let _e1507 = phi_1899_;
                                                            phi_1900_ = _e1507;
                                                            phi_1901_ = _e1377;
                                                        }
                                                        let _e1509 = phi_1900_;
                                                        let _e1511 = phi_1901_;
                                                        phi_1905_ = _e1509;
                                                        phi_1906_ = _e1511;
                                                    }
                                                    let _e1513 = phi_1905_;
                                                    let _e1515 = phi_1906_;
                                                    phi_1910_ = _e1513;
                                                    phi_1911_ = _e1515;
                                                } else {
                                                    phi_1910_ = type_24();
                                                    phi_1911_ = true;
                                                }
                                                let _e1517 = phi_1910_;
                                                let _e1519 = phi_1911_;
                                                if _e1519 {
                                                    phi_1915_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1915_ = _e1517;
                                                }
                                                let _e1521 = phi_1915_;
                                                if (_e1521.member_3 != 4294967295u) {
                                                    if (_e1099 != 4294967295u) {
                                                        phi_1926_ = type_38(_e1039.member, true);
                                                    } else {
                                                        phi_1926_ = _e1039;
                                                    }
                                                    let _e1529 = phi_1926_;
                                                    phi_1927_ = _e1529;
                                                } else {
                                                    phi_1927_ = _e1039;
                                                }
                                                let _e1531 = phi_1927_;
                                                phi_3613_ = _e1238;
                                                phi_984_ = _e1531;
                                            } else {
                                                phi_3613_ = _e1037;
                                                phi_984_ = type_38();
                                            }
                                            let _e1533 = phi_3613_;
                                            let _e1535 = phi_984_;
                                            continue;
                                            continuing {
                                                phi_3554_ = _e1533;
                                                phi_983_ = _e1535;
                                                phi_986_ = _e1054;
                                                phi_3612_ = _e1533;
                                                break if !(_e1060);
                                            }
                                        }
                                        let _e1538 = phi_3612_;
                                        phi_3668_ = _e1538;
                                        if _e1538 {
                                            break;
                                        }
                                        let _e1540 = local_13;
                                        phi_3672_ = _e1538;
                                        let _e1712 = local_15;
                                        phi_3310_ = _e1712;
                                        phi_3311_ = _e547;
                                        phi_3312_ = false;
                                        phi_3313_ = select(_e551, 0u, _e1540.member_1);
                                    } else {
                                        if (_e547.member_1 >= _e93) {
                                            phi_2866_ = type_50(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_49(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e547.member_1 < _e93) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e564 = ((1u + _e264) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e569 = global_3.member[_e547.member_1][_e564];
                                            let _e571 = ((1u + _e263) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e576 = global_3.member[_e547.member_1][_e571];
                                            let _e578 = ((1u + _e265) % 4u);
                                            if (_e578 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e583 = global_3.member[_e547.member_1][_e578];
                                            let _e585 = ((_e264 + 1u) % 4u);
                                            if (_e585 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e590 = global_3.member[_e547.member_1][_e585];
                                            let _e592 = (_e590 >> bitcast<u32>(11u));
                                            let _e594 = ((_e263 + 1u) % 4u);
                                            if (_e594 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e599 = global_3.member[_e547.member_1][_e594];
                                            let _e601 = (_e599 >> bitcast<u32>(11u));
                                            let _e603 = ((_e265 + 1u) % 4u);
                                            if (_e603 < 4u) {
                                            } else {
                                                phi_3668_ = true;
                                                break;
                                            }
                                            let _e608 = global_3.member[_e547.member_1][_e603];
                                            let _e610 = (_e608 >> bitcast<u32>(11u));
                                            let _e633 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.x - _e547.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e634 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.y - _e547.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.z - _e547.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e637 = select(_e144, _e633, (_e633 > _e144));
                                            let _e639 = select(_e144, _e634, (_e634 > _e144));
                                            let _e641 = select(_e144, _e635, (_e635 > _e144));
                                            let _e666 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e637));
                                            let _e671 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                            let _e675 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e639));
                                            let _e680 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e583 & 1023u))) * _e641));
                                            let _e689 = (bitcast<i32>((_e583 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e696 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                            let _e700 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                            let _e704 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e705 = bitcast<u32>((f32(bitcast<i32>((_e592 & 1023u))) * _e637));
                                            let _e710 = (bitcast<i32>((_e592 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                            let _e714 = bitcast<u32>((f32(bitcast<i32>((_e601 & 1023u))) * _e639));
                                            let _e719 = (bitcast<i32>((_e601 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e722 = bitcast<f32>((_e714 & bitcast<u32>(_e719)));
                                            let _e723 = bitcast<u32>((f32(bitcast<i32>((_e610 & 1023u))) * _e641));
                                            let _e728 = (bitcast<i32>((_e610 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                            let _e735 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                            let _e739 = bitcast<f32>((_e714 & bitcast<u32>(~(_e719))));
                                            let _e743 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                            let _e744 = (_e547.member.member.x + _e674);
                                            let _e745 = (_e547.member.member.y + _e683);
                                            let _e746 = (_e547.member.member.z + _e692);
                                            let _e749 = (_e547.member.member_1.x - _e713);
                                            let _e750 = (_e547.member.member_1.y - _e722);
                                            let _e751 = (_e547.member.member_1.z - _e731);
                                            let _e770 = (_e749 - _e744);
                                            let _e771 = (_e750 - _e745);
                                            let _e772 = (_e751 - _e746);
                                            let _e774 = select(_e771, _e770, (_e770 > _e771));
                                            let _e776 = select(_e772, _e774, (_e774 > _e772));
                                            if (_e776 < (1024f * _e144)) {
                                                phi_2567_ = 0u;
                                            } else {
                                                phi_2567_ = select(2u, 1u, (_e776 < (2097152f * _e144)));
                                            }
                                            let _e783 = phi_2567_;
                                            switch bitcast<i32>(_e783) {
                                                case 0: {
                                                    phi_2573_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2573_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2573_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2573_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e786 = phi_2573_;
                                            let _e792 = global_3.member[_e547.member_1][0u];
                                            let _e796 = global_3.member[_e547.member_1][1u];
                                            let _e800 = global_3.member[_e547.member_1][2u];
                                            let _e804 = global_3.member[_e547.member_1][3u];
                                            let _e816 = (((_e796 >> bitcast<u32>(22i)) | ((_e800 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e804 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e817 = (_e792 & 268435455u);
                                            let _e818 = (_e816 & 268435455u);
                                            let _e821 = ((_e792 >> bitcast<u32>(28u)) & 7u);
                                            let _e829 = ((_e792 >> bitcast<u32>(31i)) | (((_e816 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e830 = (_e821 != 0u);
                                            if (_e821 == 0u) {
                                                phi_2828_ = _e817;
                                            } else {
                                                if (_e821 == 7u) {
                                                    phi_2827_ = 2147483648u;
                                                } else {
                                                    phi_2827_ = ((2147483648u | (_e821 << bitcast<u32>(28u))) | (_e818 & 268435455u));
                                                }
                                                let _e839 = phi_2827_;
                                                phi_2828_ = _e839;
                                            }
                                            let _e841 = phi_2828_;
                                            if _e830 {
                                                let _e842 = (_e821 != 7u);
                                                if _e842 {
                                                    phi_2838_ = (_e818 + (_e821 * ((3u * _e786) + 1u)));
                                                } else {
                                                    phi_2838_ = u32();
                                                }
                                                let _e846 = phi_2838_;
                                                phi_2840_ = _e846;
                                                phi_2841_ = select(true, false, _e842);
                                            } else {
                                                phi_2840_ = u32();
                                                phi_2841_ = true;
                                            }
                                            let _e849 = phi_2840_;
                                            let _e851 = phi_2841_;
                                            if (_e829 == 0u) {
                                                phi_2862_ = (_e817 + select(0u, 1u, !(_e830)));
                                            } else {
                                                if (_e829 == 7u) {
                                                    phi_2861_ = 2147483648u;
                                                } else {
                                                    phi_2861_ = ((2147483648u | (_e829 << bitcast<u32>(28u))) | (select(_e849, _e818, _e851) & 268435455u));
                                                }
                                                let _e864 = phi_2861_;
                                                phi_2862_ = _e864;
                                            }
                                            let _e866 = phi_2862_;
                                            phi_2866_ = type_50(array<vec4<f32>, 3>(vec4<f32>(_e744, (_e547.member.member.x + _e696), _e749, (_e547.member.member_1.x - _e735)), vec4<f32>(_e745, (_e547.member.member.y + _e700), _e750, (_e547.member.member_1.y - _e739)), vec4<f32>(_e746, (_e547.member.member.z + _e704), _e751, (_e547.member.member_1.z - _e743))), type_49(type_28((_e547.member.member + vec4<f32>(_e674, _e683, _e692, 0f)), (_e547.member.member_1 - vec4<f32>(_e713, _e722, _e731, 0f))), _e841), type_49(type_28((_e547.member.member + vec4<f32>(_e696, _e700, _e704, 0f)), (_e547.member.member_1 - vec4<f32>(_e735, _e739, _e743, 0f))), _e866));
                                        }
                                        let _e871 = phi_2866_;
                                        let _e883 = ((_e871.member[0].x - _e336) * _e341);
                                        let _e884 = ((_e871.member[0].y - _e336) * _e341);
                                        let _e885 = ((_e871.member[0].z - _e337) * _e341);
                                        let _e886 = ((_e871.member[0].w - _e337) * _e341);
                                        let _e896 = ((_e871.member[1].x - _e374) * _e379);
                                        let _e897 = ((_e871.member[1].y - _e374) * _e379);
                                        let _e898 = ((_e871.member[1].z - _e375) * _e379);
                                        let _e899 = ((_e871.member[1].w - _e375) * _e379);
                                        let _e909 = ((_e871.member[2].x - _e412) * _e417);
                                        let _e910 = ((_e871.member[2].y - _e412) * _e417);
                                        let _e911 = ((_e871.member[2].z - _e413) * _e417);
                                        let _e912 = ((_e871.member[2].w - _e413) * _e417);
                                        let _e914 = select(_e911, _e909, (_e909 < _e911));
                                        let _e916 = select(_e912, _e910, (_e910 < _e912));
                                        let _e918 = select(_e911, _e909, (_e909 > _e911));
                                        let _e920 = select(_e912, _e910, (_e910 > _e912));
                                        let _e922 = select(_e885, _e883, (_e883 < _e885));
                                        let _e924 = select(_e886, _e884, (_e884 < _e886));
                                        let _e926 = select(_e898, _e896, (_e896 < _e898));
                                        let _e928 = select(_e899, _e897, (_e897 < _e899));
                                        let _e930 = select(_e926, _e922, (_e922 > _e926));
                                        let _e932 = select(_e928, _e924, (_e924 > _e928));
                                        let _e934 = select(_e914, _e930, (_e930 > _e914));
                                        let _e936 = select(_e916, _e932, (_e932 > _e916));
                                        let _e938 = select(_e885, _e883, (_e883 > _e885));
                                        let _e940 = select(_e886, _e884, (_e884 > _e886));
                                        let _e942 = select(_e898, _e896, (_e896 > _e898));
                                        let _e944 = select(_e899, _e897, (_e897 > _e899));
                                        let _e946 = select(_e942, _e938, (_e938 < _e942));
                                        let _e948 = select(_e944, _e940, (_e940 < _e944));
                                        let _e953 = -(_e914);
                                        let _e954 = -(_e916);
                                        let _e961 = (select(_e918, _e946, (_e946 < _e918)) + (select(_e953, _e918, (_e918 > _e953)) * 0.0000019073523f));
                                        let _e962 = (select(_e920, _e948, (_e948 < _e920)) + (select(_e954, _e920, (_e920 > _e954)) * 0.0000019073523f));
                                        let _e964 = select(_e464, _e934, (_e934 > _e464));
                                        let _e966 = select(_e464, _e936, (_e936 > _e464));
                                        let _e971 = (_e964 <= select(_e508.member, _e961, (_e961 < _e508.member)));
                                        let _e972 = (_e966 <= select(_e508.member, _e962, (_e962 < _e508.member)));
                                        let _e973 = (_e964 <= _e966);
                                        if _e971 {
                                            if _e972 {
                                                if _e973 {
                                                    phi_3210_ = _e871.member_2;
                                                } else {
                                                    phi_3210_ = _e871.member_1;
                                                }
                                                let _e977 = phi_3210_;
                                                let _e999 = (_e551 % 128u);
                                                let _e1000 = (_e999 < 128u);
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_8[_e999] = _e977.member_1;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_7[_e999] = _e977.member.member.x;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_6[_e999] = _e977.member.member.y;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_5[_e999] = _e977.member.member.z;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_4[_e999] = _e977.member.member_1.x;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_3[_e999] = _e977.member.member_1.y;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_2[_e999] = _e977.member.member_1.z;
                                                if _e1000 {
                                                } else {
                                                    phi_3668_ = true;
                                                    break;
                                                }
                                                local_9[_e999] = select(_e966, _e964, (_e964 > _e966));
                                                if _e973 {
                                                    phi_3287_ = _e871.member_1;
                                                } else {
                                                    phi_3287_ = _e871.member_2;
                                                }
                                                let _e1013 = phi_3287_;
                                                phi_3288_ = _e1013;
                                                phi_3289_ = (_e551 + 1u);
                                            } else {
                                                phi_3288_ = type_49();
                                                phi_3289_ = u32();
                                            }
                                            let _e1015 = phi_3288_;
                                            let _e1017 = phi_3289_;
                                            phi_3291_ = _e1015;
                                            phi_3292_ = _e1017;
                                            phi_3293_ = select(true, false, _e972);
                                        } else {
                                            phi_3291_ = type_49();
                                            phi_3292_ = u32();
                                            phi_3293_ = true;
                                        }
                                        let _e1020 = phi_3291_;
                                        let _e1022 = phi_3292_;
                                        let _e1024 = phi_3293_;
                                        if _e1024 {
                                            if _e971 {
                                                phi_3302_ = _e871.member_1;
                                            } else {
                                                phi_3302_ = _e871.member_2;
                                            }
                                            let _e1028 = phi_3302_;
                                            phi_3307_ = _e1028;
                                            phi_3308_ = select(_e972, true, _e971);
                                        } else {
                                            phi_3307_ = _e1020;
                                            phi_3308_ = _e549;
                                        }
                                        let _e1031 = phi_3307_;
                                        let _e1033 = phi_3308_;
                                        phi_3672_ = _e506;
                                        phi_3310_ = _e508;
                                        phi_3311_ = _e1031;
                                        phi_3312_ = _e1033;
                                        phi_3313_ = select(_e1022, _e551, _e1024);
                                    }
                                    let _e1544 = phi_3672_;
                                    let _e1546 = phi_3310_;
                                    let _e1548 = phi_3311_;
                                    let _e1550 = phi_3312_;
                                    let _e1552 = phi_3313_;
                                    phi_3671_ = _e1544;
                                    phi_3314_ = _e1546;
                                    phi_3315_ = _e1548;
                                    phi_3316_ = (_e512 - 1u);
                                    phi_3317_ = _e1550;
                                    phi_3318_ = _e1552;
                                } else {
                                    phi_3671_ = _e506;
                                    phi_3314_ = _e508;
                                    phi_3315_ = _e547;
                                    phi_3316_ = _e512;
                                    phi_3317_ = _e549;
                                    phi_3318_ = _e551;
                                }
                                let _e1554 = phi_3671_;
                                let _e1556 = phi_3314_;
                                let _e1558 = phi_3315_;
                                let _e1560 = phi_3316_;
                                let _e1562 = phi_3317_;
                                let _e1564 = phi_3318_;
                                phi_3670_ = _e1554;
                                phi_3319_ = _e1556;
                                phi_3320_ = _e1558;
                                phi_3321_ = _e1560;
                                phi_3322_ = _e1562;
                                phi_3323_ = _e1564;
                            } else {
                                phi_3670_ = _e506;
                                phi_3319_ = type_38();
                                phi_3320_ = type_49();
                                phi_3321_ = u32();
                                phi_3322_ = bool();
                                phi_3323_ = u32();
                            }
                            let _e1566 = phi_3670_;
                            let _e1568 = phi_3319_;
                            let _e1570 = phi_3320_;
                            let _e1572 = phi_3321_;
                            let _e1574 = phi_3322_;
                            let _e1576 = phi_3323_;
                            phi_3669_ = _e1566;
                            phi_857_ = _e1568;
                            phi_860_ = _e1570;
                            phi_862_ = _e1572;
                            phi_864_ = _e1574;
                            phi_866_ = _e1576;
                            phi_3324_ = _e520;
                        } else {
                            phi_3669_ = _e506;
                            phi_857_ = type_38();
                            phi_860_ = type_49();
                            phi_862_ = u32();
                            phi_864_ = bool();
                            phi_866_ = u32();
                            phi_3324_ = false;
                        }
                        let _e1578 = phi_3669_;
                        let _e1580 = phi_857_;
                        let _e1582 = phi_860_;
                        let _e1584 = phi_862_;
                        let _e1586 = phi_864_;
                        let _e1588 = phi_866_;
                        let _e1590 = phi_3324_;
                        continue;
                        continuing {
                            phi_3557_ = _e1578;
                            phi_856_ = _e1580;
                            phi_859_ = _e1582;
                            phi_861_ = _e1584;
                            phi_863_ = _e1586;
                            phi_865_ = _e1588;
                            phi_3668_ = _e1578;
                            break if !(_e1590);
                        }
                    }
                    let _e1593 = phi_3668_;
                    if _e1593 {
                        break;
                    }
                    let _e1595 = local_14;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_5.member[_e150] = select(0u, 1u, _e1595.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
