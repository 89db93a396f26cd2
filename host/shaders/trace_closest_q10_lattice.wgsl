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

struct type_26 {
    member: array<type_24>,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_24,
    member_1: f32,
}

struct type_41 {
    member: array<type_28>,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_32,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_44;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_26;

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
    var phi_401_: i32;
    var phi_402_: i32;
    var phi_412_: bool;
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_425_: bool;
    var phi_430_: u32;
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
    var phi_3486_: bool;
    var phi_860_: type_37;
    var phi_863_: type_53;
    var phi_865_: u32;
    var phi_867_: bool;
    var phi_869_: u32;
    var phi_880_: bool;
    var phi_966_: type_53;
    var phi_967_: bool;
    var phi_968_: u32;
    var phi_2450_: u32;
    var phi_2456_: u32;
    var phi_2710_: u32;
    var phi_2711_: u32;
    var phi_2721_: u32;
    var phi_2723_: u32;
    var phi_2724_: bool;
    var phi_2744_: u32;
    var phi_2745_: u32;
    var phi_2749_: type_54;
    var phi_3093_: type_53;
    var phi_3170_: type_53;
    var phi_3171_: type_53;
    var phi_3172_: u32;
    var phi_3174_: type_53;
    var phi_3175_: u32;
    var phi_3176_: bool;
    var phi_3185_: type_53;
    var phi_3190_: type_53;
    var phi_3191_: bool;
    var phi_3483_: bool;
    var phi_987_: type_37;
    var phi_990_: type_8;
    var phi_991_: type_8;
    var phi_1013_: type_8;
    var phi_1054_: u32;
    var phi_1060_: u32;
    var phi_1070_: u32;
    var phi_1086_: u32;
    var phi_1123_: u32;
    var phi_1129_: u32;
    var phi_1139_: u32;
    var phi_3468_: bool;
    var phi_1155_: type_8;
    var phi_1156_: type_8;
    var phi_1179_: type_8;
    var phi_1202_: u32;
    var phi_1217_: u32;
    var phi_1220_: type_8;
    var phi_1221_: type_8;
    var phi_1244_: type_8;
    var phi_1310_: u32;
    var phi_1290_: u32;
    var phi_1291_: u32;
    var phi_1314_: f32;
    var phi_3461_: bool;
    var phi_3540_: bool;
    var phi_3539_: bool;
    var phi_1814_: vec3<f32>;
    var phi_1815_: vec3<f32>;
    var phi_1846_: bool;
    var phi_1855_: vec3<f32>;
    var phi_1895_: type_24;
    var phi_1897_: type_24;
    var phi_1898_: bool;
    var phi_1902_: type_24;
    var phi_1903_: type_24;
    var phi_1904_: type_24;
    var phi_1905_: bool;
    var phi_1909_: type_24;
    var phi_1910_: bool;
    var phi_1914_: type_24;
    var phi_1915_: bool;
    var phi_1919_: type_24;
    var phi_1944_: bool;
    var phi_1945_: bool;
    var phi_1951_: type_37;
    var phi_1952_: type_37;
    var phi_1953_: type_37;
    var phi_3542_: bool;
    var phi_988_: type_37;
    var phi_3541_: bool;
    var phi_3604_: bool;
    var phi_3193_: type_37;
    var phi_3194_: type_53;
    var phi_3195_: bool;
    var phi_3196_: u32;
    var phi_3603_: bool;
    var phi_3197_: type_37;
    var phi_3198_: type_53;
    var phi_3199_: u32;
    var phi_3200_: bool;
    var phi_3201_: u32;
    var phi_3602_: bool;
    var phi_3202_: type_37;
    var phi_3203_: type_53;
    var phi_3204_: u32;
    var phi_3205_: bool;
    var phi_3206_: u32;
    var phi_3601_: bool;
    var phi_861_: type_37;
    var phi_864_: type_53;
    var phi_866_: u32;
    var phi_868_: bool;
    var phi_870_: u32;
    var phi_3207_: bool;
    var phi_3600_: bool;
    var local_13: type_37;
    var phi_3259_: type_24;
    var local_14: type_37;

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
                            phi_401_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_401_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_401_;
                        phi_402_ = _e243;
                    } else {
                        phi_402_ = 0i;
                    }
                    let _e245 = phi_402_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_412_ = true;
                    } else {
                        phi_412_ = (_e169 == _e201);
                    }
                    let _e249 = phi_412_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_422_ = _e251;
                        phi_423_ = _e251;
                        phi_425_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_422_ = u32();
                        phi_423_ = 0u;
                        phi_425_ = true;
                    }
                    let _e255 = phi_422_;
                    let _e257 = phi_423_;
                    let _e259 = phi_425_;
                    if _e259 {
                        phi_430_ = (_e257 + 1u);
                    } else {
                        phi_430_ = 0u;
                    }
                    let _e263 = phi_430_;
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
                    let _e302 = global_4.member[_e150].member;
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
                    let _e314 = global_4.member[_e150].member_2;
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
                    phi_3486_ = false;
                    phi_860_ = type_37(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e462);
                    phi_863_ = type_53(type_32(vec4<f32>((f32(_e471) * _e144), (f32(_e477) * _e144), (f32(_e483) * _e144), 0f), vec4<f32>((f32(_e488) * _e144), (f32(_e492) * _e144), (f32(_e496) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_865_ = ((3u * _e93) + 1u);
                    phi_867_ = (_e464 <= _e462);
                    phi_869_ = 0u;
                    loop {
                        let _e506 = phi_3486_;
                        let _e508 = phi_860_;
                        let _e510 = phi_863_;
                        let _e512 = phi_865_;
                        let _e514 = phi_867_;
                        let _e516 = phi_869_;
                        local_13 = _e508;
                        if _e514 {
                            phi_880_ = true;
                        } else {
                            phi_880_ = (_e516 > 0u);
                        }
                        let _e519 = phi_880_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_966_ = _e510;
                                    phi_967_ = _e514;
                                    phi_968_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_3600_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_966_ = type_53(type_32(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_967_ = (_e543 <= _e508.member_1);
                                    phi_968_ = _e521;
                                }
                                let _e547 = phi_966_;
                                let _e549 = phi_967_;
                                let _e551 = phi_968_;
                                if _e549 {
                                    let _e556 = (_e547.member_1 & 268435455u);
                                    if ((_e547.member_1 & 2147483648u) != 0u) {
                                        phi_3483_ = _e506;
                                        phi_987_ = _e508;
                                        phi_990_ = type_8(0u, ((_e547.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1016 = phi_3483_;
                                            let _e1018 = phi_987_;
                                            let _e1020 = phi_990_;
                                            local_14 = _e1018;
                                            if (_e1020.member < _e1020.member_1) {
                                                phi_991_ = type_8((_e1020.member + 1u), _e1020.member_1);
                                                phi_1013_ = type_8(1u, _e1020.member);
                                            } else {
                                                phi_991_ = _e1020;
                                                phi_1013_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1033 = phi_991_;
                                            let _e1035 = phi_1013_;
                                            let _e1039 = (bitcast<i32>(_e1035.member) != 0i);
                                            if _e1039 {
                                                let _e1044 = (_e547.member.member_1.x - _e547.member.member.x);
                                                let _e1047 = (_e547.member.member_1.y - _e547.member.member.y);
                                                let _e1050 = (_e547.member.member_1.z - _e547.member.member.z);
                                                let _e1052 = select(_e1047, _e1044, (_e1044 > _e1047));
                                                let _e1054 = select(_e1050, _e1052, (_e1052 > _e1050));
                                                let _e1056 = (_e1054 < (1024f * _e144));
                                                if _e1056 {
                                                    phi_1054_ = 0u;
                                                } else {
                                                    phi_1054_ = select(2u, 1u, (_e1054 < (2097152f * _e144)));
                                                }
                                                let _e1061 = phi_1054_;
                                                switch bitcast<i32>(_e1061) {
                                                    case 0: {
                                                        phi_1060_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1060_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1060_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1060_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1064 = phi_1060_;
                                                switch bitcast<i32>(_e1061) {
                                                    case 0: {
                                                        phi_1070_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1070_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1070_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1070_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1071 = phi_1070_;
                                                let _e1073 = ((_e556 + (_e1035.member_1 * ((3u * _e1064) + 1u))) + (3u * _e1071));
                                                let _e1074 = (_e1073 < _e96);
                                                if _e1074 {
                                                    if _e1074 {
                                                    } else {
                                                        phi_3541_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_5.member[_e1073];
                                                    phi_1086_ = _e1076;
                                                } else {
                                                    phi_1086_ = 4294967295u;
                                                }
                                                let _e1078 = phi_1086_;
                                                local_10 = array<u32, 3>(_e264, _e263, _e265);
                                                if _e1056 {
                                                    phi_1123_ = 0u;
                                                } else {
                                                    phi_1123_ = select(2u, 1u, (_e1054 < (2097152f * _e144)));
                                                }
                                                let _e1084 = phi_1123_;
                                                switch bitcast<i32>(_e1084) {
                                                    case 0: {
                                                        phi_1129_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1129_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1129_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1129_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1087 = phi_1129_;
                                                switch bitcast<i32>(_e1084) {
                                                    case 0: {
                                                        phi_1139_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1139_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1139_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1139_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1094 = phi_1139_;
                                                local_12 = array<f32, 4>(_e547.member.member.x, _e547.member.member.y, _e547.member.member.z, _e547.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3468_ = _e1016;
                                                phi_1155_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1108 = phi_3468_;
                                                    let _e1110 = phi_1155_;
                                                    if (_e1110.member < _e1110.member_1) {
                                                        phi_1156_ = type_8((_e1110.member + 1u), _e1110.member_1);
                                                        phi_1179_ = type_8(1u, _e1110.member);
                                                    } else {
                                                        phi_1156_ = _e1110;
                                                        phi_1179_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1123 = phi_1156_;
                                                    let _e1125 = phi_1179_;
                                                    let _e1129 = (bitcast<i32>(_e1125.member) != 0i);
                                                    if _e1129 {
                                                        let _e1131 = ((_e556 + (_e1035.member_1 * ((3u * _e1087) + 1u))) + (_e1125.member_1 * _e1094));
                                                        let _e1132 = (_e1131 < _e96);
                                                        if _e1132 {
                                                            if _e1132 {
                                                            } else {
                                                                phi_3539_ = true;
                                                                break;
                                                            }
                                                            let _e1134 = global_5.member[_e1131];
                                                            phi_1202_ = _e1134;
                                                        } else {
                                                            phi_1202_ = 0u;
                                                        }
                                                        let _e1136 = phi_1202_;
                                                        let _e1137 = (_e1131 + 1u);
                                                        let _e1138 = (_e1137 < _e96);
                                                        if _e1138 {
                                                            if _e1138 {
                                                            } else {
                                                                phi_3539_ = true;
                                                                break;
                                                            }
                                                            let _e1140 = global_5.member[_e1137];
                                                            phi_1217_ = _e1140;
                                                        } else {
                                                            phi_1217_ = 0u;
                                                        }
                                                        let _e1142 = phi_1217_;
                                                        phi_1220_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1144 = phi_1220_;
                                                            if (_e1144.member < _e1144.member_1) {
                                                                phi_1221_ = type_8((_e1144.member + 1u), _e1144.member_1);
                                                                phi_1244_ = type_8(1u, _e1144.member);
                                                            } else {
                                                                phi_1221_ = _e1144;
                                                                phi_1244_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1157 = phi_1221_;
                                                            let _e1159 = phi_1244_;
                                                            let _e1163 = (bitcast<i32>(_e1159.member) != 0i);
                                                            if _e1163 {
                                                                let _e1164 = (_e1159.member_1 < 3u);
                                                                if _e1164 {
                                                                } else {
                                                                    phi_3461_ = true;
                                                                    break;
                                                                }
                                                                let _e1166 = local_10[_e1159.member_1];
                                                                if (_e1159.member_1 < 4u) {
                                                                } else {
                                                                    phi_3461_ = true;
                                                                    break;
                                                                }
                                                                let _e1169 = local_12[_e1159.member_1];
                                                                switch bitcast<i32>(_e1084) {
                                                                    case 0: {
                                                                        phi_1314_ = (_e1169 + (f32(((_e1136 >> bitcast<u32>(((10u * _e1166) & 31u))) & 1023u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1166 == 0u) {
                                                                            phi_1291_ = _e1136;
                                                                        } else {
                                                                            if (_e1166 == 1u) {
                                                                                phi_1290_ = ((_e1136 >> bitcast<u32>(21i)) | (_e1142 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1290_ = (_e1142 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1190 = phi_1290_;
                                                                            phi_1291_ = _e1190;
                                                                        }
                                                                        let _e1192 = phi_1291_;
                                                                        phi_1314_ = (_e1169 + (f32((_e1192 & 2097151u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1171 = (_e1131 + _e1166);
                                                                        let _e1172 = (_e1171 < _e96);
                                                                        if _e1172 {
                                                                            if _e1172 {
                                                                            } else {
                                                                                phi_3461_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1174 = global_5.member[_e1171];
                                                                            phi_1310_ = _e1174;
                                                                        } else {
                                                                            phi_1310_ = 0u;
                                                                        }
                                                                        let _e1176 = phi_1310_;
                                                                        phi_1314_ = (f32(bitcast<i32>(_e1176)) * _e144);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1314_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1206 = phi_1314_;
                                                                if (_e1125.member_1 < 3u) {
                                                                } else {
                                                                    phi_3461_ = true;
                                                                    break;
                                                                }
                                                                if _e1164 {
                                                                } else {
                                                                    phi_3461_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1125.member_1][_e1159.member_1] = _e1206;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1220_ = _e1157;
                                                                phi_3461_ = _e1108;
                                                                break if !(_e1163);
                                                            }
                                                        }
                                                        let _e1212 = phi_3461_;
                                                        phi_3539_ = _e1212;
                                                        if _e1212 {
                                                            break;
                                                        }
                                                        phi_3540_ = _e1212;
                                                    } else {
                                                        phi_3540_ = _e1108;
                                                    }
                                                    let _e1214 = phi_3540_;
                                                    continue;
                                                    continuing {
                                                        phi_3468_ = _e1214;
                                                        phi_1155_ = _e1123;
                                                        phi_3539_ = _e1214;
                                                        break if !(_e1129);
                                                    }
                                                }
                                                let _e1217 = phi_3539_;
                                                phi_3541_ = _e1217;
                                                if _e1217 {
                                                    break;
                                                }
                                                let _e1218 = local_11;
                                                let _e1234 = (_e1218[0][2] - _e390);
                                                let _e1237 = (((_e1218[0][0] - _e313) * _e414) - (_e1234 * _e338));
                                                let _e1240 = (((_e1218[0][1] - _e352) * _e414) - (_e1234 * _e376));
                                                let _e1243 = (_e1218[1][2] - _e390);
                                                let _e1246 = (((_e1218[1][0] - _e313) * _e414) - (_e1243 * _e338));
                                                let _e1249 = (((_e1218[1][1] - _e352) * _e414) - (_e1243 * _e376));
                                                let _e1252 = (_e1218[2][2] - _e390);
                                                let _e1255 = (((_e1218[2][0] - _e313) * _e414) - (_e1252 * _e338));
                                                let _e1258 = (((_e1218[2][1] - _e352) * _e414) - (_e1252 * _e376));
                                                let _e1259 = (_e1255 * _e1249);
                                                let _e1260 = (_e1258 * _e1246);
                                                let _e1261 = (_e1237 * _e1258);
                                                let _e1262 = (_e1240 * _e1255);
                                                let _e1263 = (_e1246 * _e1240);
                                                let _e1264 = (_e1249 * _e1237);
                                                let _e1269 = (((_e1259 >= _e1260) && (_e1261 >= _e1262)) && (_e1263 >= _e1264));
                                                if (_e1269 || (((_e1259 <= _e1260) && (_e1261 <= _e1262)) && (_e1263 <= _e1264))) {
                                                    let _e1276 = select(-1f, 1f, _e1269);
                                                    let _e1278 = ((_e1259 - _e1260) * _e1276);
                                                    let _e1280 = select(0f, _e1278, (_e1278 > 0f));
                                                    let _e1282 = ((_e1261 - _e1262) * _e1276);
                                                    let _e1284 = select(0f, _e1282, (_e1282 > 0f));
                                                    let _e1286 = ((_e1263 - _e1264) * _e1276);
                                                    let _e1288 = select(0f, _e1286, (_e1286 > 0f));
                                                    let _e1290 = ((_e1280 + _e1284) + _e1288);
                                                    if (_e1290 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1909_ = type_24();
                                                        phi_1910_ = true;
                                                    } else {
                                                        let _e1293 = select(_e1218[1][0], _e1218[0][0], (_e1218[0][0] < _e1218[1][0]));
                                                        let _e1297 = select(_e1218[1][0], _e1218[0][0], (_e1218[0][0] > _e1218[1][0]));
                                                        let _e1301 = select(_e1218[1][1], _e1218[0][1], (_e1218[0][1] < _e1218[1][1]));
                                                        let _e1305 = select(_e1218[1][1], _e1218[0][1], (_e1218[0][1] > _e1218[1][1]));
                                                        let _e1309 = select(_e1218[1][2], _e1218[0][2], (_e1218[0][2] < _e1218[1][2]));
                                                        let _e1313 = select(_e1218[1][2], _e1218[0][2], (_e1218[0][2] > _e1218[1][2]));
                                                        let _e1318 = ((select(_e1218[2][0], _e1293, (_e1293 < _e1218[2][0])) - _e336) * _e341);
                                                        let _e1319 = ((select(_e1218[2][0], _e1297, (_e1297 > _e1218[2][0])) - _e337) * _e341);
                                                        let _e1322 = ((select(_e1218[2][1], _e1301, (_e1301 < _e1218[2][1])) - _e374) * _e379);
                                                        let _e1323 = ((select(_e1218[2][1], _e1305, (_e1305 > _e1218[2][1])) - _e375) * _e379);
                                                        let _e1326 = ((select(_e1218[2][2], _e1309, (_e1309 < _e1218[2][2])) - _e412) * _e417);
                                                        let _e1327 = ((select(_e1218[2][2], _e1313, (_e1313 > _e1218[2][2])) - _e413) * _e417);
                                                        let _e1329 = select(_e1327, _e1326, (_e1326 < _e1327));
                                                        let _e1331 = select(_e1327, _e1326, (_e1326 > _e1327));
                                                        let _e1333 = select(_e1319, _e1318, (_e1318 < _e1319));
                                                        let _e1335 = select(_e1323, _e1322, (_e1322 < _e1323));
                                                        let _e1337 = select(_e1335, _e1333, (_e1333 > _e1335));
                                                        let _e1339 = select(_e1329, _e1337, (_e1337 > _e1329));
                                                        let _e1341 = select(_e1319, _e1318, (_e1318 > _e1319));
                                                        let _e1343 = select(_e1323, _e1322, (_e1322 > _e1323));
                                                        let _e1345 = select(_e1343, _e1341, (_e1341 < _e1343));
                                                        let _e1347 = select(_e1331, _e1345, (_e1345 < _e1331));
                                                        let _e1348 = -(_e1329);
                                                        let _e1354 = select(_e464, _e1339, (_e1339 > _e464));
                                                        if (_e1354 > (_e1347 + (select(_e1348, _e1331, (_e1331 > _e1348)) * 0.0000019073523f))) {
                                                            phi_1904_ = type_24();
                                                            phi_1905_ = true;
                                                        } else {
                                                            let _e1356 = (_e1354 > _e1018.member_1);
                                                            if _e1356 {
                                                                phi_1903_ = type_24();
                                                            } else {
                                                                let _e1360 = (_e1218[1][0] - _e1218[0][0]);
                                                                let _e1361 = (_e1218[1][1] - _e1218[0][1]);
                                                                let _e1362 = (_e1218[1][2] - _e1218[0][2]);
                                                                let _e1363 = vec3<f32>(_e1360, _e1361, _e1362);
                                                                let _e1364 = (_e1218[2][0] - _e1218[1][0]);
                                                                let _e1365 = (_e1218[2][1] - _e1218[1][1]);
                                                                let _e1366 = (_e1218[2][2] - _e1218[1][2]);
                                                                let _e1367 = vec3<f32>(_e1364, _e1365, _e1366);
                                                                let _e1368 = (_e1218[0][0] - _e1218[2][0]);
                                                                let _e1369 = (_e1218[0][1] - _e1218[2][1]);
                                                                let _e1370 = (_e1218[0][2] - _e1218[2][2]);
                                                                let _e1371 = vec3<f32>(_e1368, _e1369, _e1370);
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                let _e1400 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                let _e1403 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                let _e1405 = select(_e1403, _e1400, (_e1400 > _e1403));
                                                                let _e1408 = bitcast<f32>((bitcast<u32>(_e1370) & 2147483647u));
                                                                let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                                let _e1412 = select(_e1397, _e1384, (_e1384 > _e1397));
                                                                let _e1414 = select(_e1410, _e1412, (_e1412 > _e1410));
                                                                if (_e1384 == _e1414) {
                                                                    phi_1814_ = _e1367;
                                                                    phi_1815_ = _e1371;
                                                                } else {
                                                                    let _e1417 = vec3((_e1397 == _e1414));
                                                                    phi_1814_ = select(_e1363, _e1371, _e1417);
                                                                    phi_1815_ = select(_e1367, _e1363, _e1417);
                                                                }
                                                                let _e1421 = phi_1814_;
                                                                let _e1423 = phi_1815_;
                                                                let _e1430 = ((_e1421.y * _e1423.z) - (_e1423.y * _e1421.z));
                                                                let _e1435 = ((_e1421.z * _e1423.x) - (_e1423.z * _e1421.x));
                                                                let _e1438 = ((_e1421.x * _e1423.y) - (_e1423.x * _e1421.y));
                                                                if (_e1280 >= _e1284) {
                                                                    phi_1846_ = select(true, false, (_e1280 >= _e1288));
                                                                } else {
                                                                    phi_1846_ = true;
                                                                }
                                                                let _e1443 = phi_1846_;
                                                                if _e1443 {
                                                                    phi_1855_ = select(vec3<f32>(_e1218[2][0], _e1218[2][1], _e1218[2][2]), vec3<f32>(_e1218[1][0], _e1218[1][1], _e1218[1][2]), vec3((_e1284 >= _e1288)));
                                                                } else {
                                                                    phi_1855_ = vec3<f32>(_e1218[0][0], _e1218[0][1], _e1218[0][2]);
                                                                }
                                                                let _e1448 = phi_1855_;
                                                                let _e1465 = ((((_e1430 * (_e1448.x - _e313)) + (_e1435 * (_e1448.y - _e352))) + (_e1438 * (_e1448.z - _e390))) / (((_e1430 * _e338) + (_e1435 * _e376)) + (_e1438 * _e414)));
                                                                let _e1467 = select(_e1347, _e1465, (_e1465 < _e1347));
                                                                let _e1469 = select(_e1339, _e1467, (_e1467 > _e1339));
                                                                if (_e1469 >= _e464) {
                                                                    let _e1471 = (_e1469 <= _e1018.member_1);
                                                                    if _e1471 {
                                                                        let _e1472 = (1f / _e1290);
                                                                        phi_1895_ = type_24(_e1469, (_e1284 * _e1472), (_e1288 * _e1472), _e1078);
                                                                    } else {
                                                                        phi_1895_ = type_24();
                                                                    }
                                                                    let _e1477 = phi_1895_;
                                                                    phi_1897_ = _e1477;
                                                                    phi_1898_ = select(true, false, _e1471);
                                                                } else {
                                                                    phi_1897_ = type_24();
                                                                    phi_1898_ = true;
                                                                }
                                                                let _e1480 = phi_1897_;
                                                                let _e1482 = phi_1898_;
                                                                if _e1482 {
                                                                    phi_1902_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1902_ = _e1480;
                                                                }
                                                                let _e1484 = phi_1902_;
                                                                phi_1903_ = _e1484;
                                                            }
                                                            let _e1486 = phi_1903_;
                                                            phi_1904_ = _e1486;
                                                            phi_1905_ = _e1356;
                                                        }
                                                        let _e1488 = phi_1904_;
                                                        let _e1490 = phi_1905_;
                                                        phi_1909_ = _e1488;
                                                        phi_1910_ = _e1490;
                                                    }
                                                    let _e1492 = phi_1909_;
                                                    let _e1494 = phi_1910_;
                                                    phi_1914_ = _e1492;
                                                    phi_1915_ = _e1494;
                                                } else {
                                                    phi_1914_ = type_24();
                                                    phi_1915_ = true;
                                                }
                                                let _e1496 = phi_1914_;
                                                let _e1498 = phi_1915_;
                                                if _e1498 {
                                                    phi_1919_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1919_ = _e1496;
                                                }
                                                let _e1500 = phi_1919_;
                                                if (_e1500.member_3 != 4294967295u) {
                                                    if (_e1078 != 4294967295u) {
                                                        if (_e1500.member < _e1018.member.member) {
                                                            phi_1945_ = true;
                                                        } else {
                                                            if (_e1500.member == _e1018.member.member) {
                                                                phi_1944_ = (_e1500.member_3 < _e1018.member.member_3);
                                                            } else {
                                                                phi_1944_ = false;
                                                            }
                                                            let _e1513 = phi_1944_;
                                                            phi_1945_ = _e1513;
                                                        }
                                                        let _e1515 = phi_1945_;
                                                        if _e1515 {
                                                            phi_1951_ = type_37(_e1500, _e1500.member);
                                                        } else {
                                                            phi_1951_ = _e1018;
                                                        }
                                                        let _e1518 = phi_1951_;
                                                        phi_1952_ = _e1518;
                                                    } else {
                                                        phi_1952_ = _e1018;
                                                    }
                                                    let _e1520 = phi_1952_;
                                                    phi_1953_ = _e1520;
                                                } else {
                                                    phi_1953_ = _e1018;
                                                }
                                                let _e1522 = phi_1953_;
                                                phi_3542_ = _e1217;
                                                phi_988_ = _e1522;
                                            } else {
                                                phi_3542_ = _e1016;
                                                phi_988_ = type_37();
                                            }
                                            let _e1524 = phi_3542_;
                                            let _e1526 = phi_988_;
                                            continue;
                                            continuing {
                                                phi_3483_ = _e1524;
                                                phi_987_ = _e1526;
                                                phi_990_ = _e1033;
                                                phi_3541_ = _e1524;
                                                break if !(_e1039);
                                            }
                                        }
                                        let _e1529 = phi_3541_;
                                        phi_3600_ = _e1529;
                                        if _e1529 {
                                            break;
                                        }
                                        phi_3604_ = _e1529;
                                        let _e1729 = local_14;
                                        phi_3193_ = _e1729;
                                        phi_3194_ = _e547;
                                        phi_3195_ = false;
                                        phi_3196_ = _e551;
                                    } else {
                                        if (_e547.member_1 >= _e93) {
                                            phi_2749_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e547.member_1 < _e93) {
                                            } else {
                                                phi_3600_ = true;
                                                break;
                                            }
                                            let _e564 = ((1u + _e264) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_3600_ = true;
                                                break;
                                            }
                                            let _e569 = global_3.member[_e547.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((1u + _e263) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_3600_ = true;
                                                break;
                                            }
                                            let _e578 = global_3.member[_e547.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e582 = ((1u + _e265) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_3600_ = true;
                                                break;
                                            }
                                            let _e587 = global_3.member[_e547.member_1][_e582];
                                            let _e589 = (_e587 >> bitcast<u32>(11u));
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.x - _e547.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.y - _e547.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e547.member.member_1.z - _e547.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e616 = select(_e144, _e612, (_e612 > _e144));
                                            let _e618 = select(_e144, _e613, (_e613 > _e144));
                                            let _e620 = select(_e144, _e614, (_e614 > _e144));
                                            let _e645 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e616));
                                            let _e650 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e653 = bitcast<f32>((_e645 & bitcast<u32>(_e650)));
                                            let _e654 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e618));
                                            let _e659 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e662 = bitcast<f32>((_e654 & bitcast<u32>(_e659)));
                                            let _e663 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e620));
                                            let _e668 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e671 = bitcast<f32>((_e663 & bitcast<u32>(_e668)));
                                            let _e675 = bitcast<f32>((_e645 & bitcast<u32>(~(_e650))));
                                            let _e679 = bitcast<f32>((_e654 & bitcast<u32>(~(_e659))));
                                            let _e683 = bitcast<f32>((_e663 & bitcast<u32>(~(_e668))));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e616));
                                            let _e689 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e693 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e618));
                                            let _e698 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e701 = bitcast<f32>((_e693 & bitcast<u32>(_e698)));
                                            let _e702 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e620));
                                            let _e707 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e710 = bitcast<f32>((_e702 & bitcast<u32>(_e707)));
                                            let _e714 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e718 = bitcast<f32>((_e693 & bitcast<u32>(~(_e698))));
                                            let _e722 = bitcast<f32>((_e702 & bitcast<u32>(~(_e707))));
                                            let _e723 = (_e547.member.member.x + _e653);
                                            let _e724 = (_e547.member.member.y + _e662);
                                            let _e725 = (_e547.member.member.z + _e671);
                                            let _e728 = (_e547.member.member_1.x - _e692);
                                            let _e729 = (_e547.member.member_1.y - _e701);
                                            let _e730 = (_e547.member.member_1.z - _e710);
                                            let _e749 = (_e728 - _e723);
                                            let _e750 = (_e729 - _e724);
                                            let _e751 = (_e730 - _e725);
                                            let _e753 = select(_e750, _e749, (_e749 > _e750));
                                            let _e755 = select(_e751, _e753, (_e753 > _e751));
                                            if (_e755 < (1024f * _e144)) {
                                                phi_2450_ = 0u;
                                            } else {
                                                phi_2450_ = select(2u, 1u, (_e755 < (2097152f * _e144)));
                                            }
                                            let _e762 = phi_2450_;
                                            switch bitcast<i32>(_e762) {
                                                case 0: {
                                                    phi_2456_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2456_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2456_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2456_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e765 = phi_2456_;
                                            let _e771 = global_3.member[_e547.member_1][0u];
                                            let _e775 = global_3.member[_e547.member_1][1u];
                                            let _e779 = global_3.member[_e547.member_1][2u];
                                            let _e783 = global_3.member[_e547.member_1][3u];
                                            let _e795 = (((_e775 >> bitcast<u32>(22i)) | ((_e779 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e783 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e796 = (_e771 & 268435455u);
                                            let _e797 = (_e795 & 268435455u);
                                            let _e800 = ((_e771 >> bitcast<u32>(28u)) & 7u);
                                            let _e808 = ((_e771 >> bitcast<u32>(31i)) | (((_e795 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e809 = (_e800 != 0u);
                                            if (_e800 == 0u) {
                                                phi_2711_ = _e796;
                                            } else {
                                                if (_e800 == 7u) {
                                                    phi_2710_ = 2147483648u;
                                                } else {
                                                    phi_2710_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (_e797 & 268435455u));
                                                }
                                                let _e818 = phi_2710_;
                                                phi_2711_ = _e818;
                                            }
                                            let _e820 = phi_2711_;
                                            if _e809 {
                                                let _e821 = (_e800 != 7u);
                                                if _e821 {
                                                    phi_2721_ = (_e797 + (_e800 * ((3u * _e765) + 1u)));
                                                } else {
                                                    phi_2721_ = u32();
                                                }
                                                let _e825 = phi_2721_;
                                                phi_2723_ = _e825;
                                                phi_2724_ = select(true, false, _e821);
                                            } else {
                                                phi_2723_ = u32();
                                                phi_2724_ = true;
                                            }
                                            let _e828 = phi_2723_;
                                            let _e830 = phi_2724_;
                                            if (_e808 == 0u) {
                                                phi_2745_ = (_e796 + select(0u, 1u, !(_e809)));
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_2744_ = 2147483648u;
                                                } else {
                                                    phi_2744_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (select(_e828, _e797, _e830) & 268435455u));
                                                }
                                                let _e843 = phi_2744_;
                                                phi_2745_ = _e843;
                                            }
                                            let _e845 = phi_2745_;
                                            phi_2749_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e723, (_e547.member.member.x + _e675), _e728, (_e547.member.member_1.x - _e714)), vec4<f32>(_e724, (_e547.member.member.y + _e679), _e729, (_e547.member.member_1.y - _e718)), vec4<f32>(_e725, (_e547.member.member.z + _e683), _e730, (_e547.member.member_1.z - _e722))), type_53(type_32((_e547.member.member + vec4<f32>(_e653, _e662, _e671, 0f)), (_e547.member.member_1 - vec4<f32>(_e692, _e701, _e710, 0f))), _e820), type_53(type_32((_e547.member.member + vec4<f32>(_e675, _e679, _e683, 0f)), (_e547.member.member_1 - vec4<f32>(_e714, _e718, _e722, 0f))), _e845));
                                        }
                                        let _e850 = phi_2749_;
                                        let _e862 = ((_e850.member[0].x - _e336) * _e341);
                                        let _e863 = ((_e850.member[0].y - _e336) * _e341);
                                        let _e864 = ((_e850.member[0].z - _e337) * _e341);
                                        let _e865 = ((_e850.member[0].w - _e337) * _e341);
                                        let _e875 = ((_e850.member[1].x - _e374) * _e379);
                                        let _e876 = ((_e850.member[1].y - _e374) * _e379);
                                        let _e877 = ((_e850.member[1].z - _e375) * _e379);
                                        let _e878 = ((_e850.member[1].w - _e375) * _e379);
                                        let _e888 = ((_e850.member[2].x - _e412) * _e417);
                                        let _e889 = ((_e850.member[2].y - _e412) * _e417);
                                        let _e890 = ((_e850.member[2].z - _e413) * _e417);
                                        let _e891 = ((_e850.member[2].w - _e413) * _e417);
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
                                        let _e943 = select(_e464, _e913, (_e913 > _e464));
                                        let _e945 = select(_e464, _e915, (_e915 > _e464));
                                        let _e950 = (_e943 <= select(_e508.member_1, _e940, (_e940 < _e508.member_1)));
                                        let _e951 = (_e945 <= select(_e508.member_1, _e941, (_e941 < _e508.member_1)));
                                        let _e952 = (_e943 <= _e945);
                                        if _e950 {
                                            if _e951 {
                                                if _e952 {
                                                    phi_3093_ = _e850.member_2;
                                                } else {
                                                    phi_3093_ = _e850.member_1;
                                                }
                                                let _e956 = phi_3093_;
                                                let _e978 = (_e551 % 128u);
                                                let _e979 = (_e978 < 128u);
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_8[_e978] = _e956.member_1;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_7[_e978] = _e956.member.member.x;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_6[_e978] = _e956.member.member.y;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_5[_e978] = _e956.member.member.z;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_4[_e978] = _e956.member.member_1.x;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_3[_e978] = _e956.member.member_1.y;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_2[_e978] = _e956.member.member_1.z;
                                                if _e979 {
                                                } else {
                                                    phi_3600_ = true;
                                                    break;
                                                }
                                                local_9[_e978] = select(_e945, _e943, (_e943 > _e945));
                                                if _e952 {
                                                    phi_3170_ = _e850.member_1;
                                                } else {
                                                    phi_3170_ = _e850.member_2;
                                                }
                                                let _e992 = phi_3170_;
                                                phi_3171_ = _e992;
                                                phi_3172_ = (_e551 + 1u);
                                            } else {
                                                phi_3171_ = type_53();
                                                phi_3172_ = u32();
                                            }
                                            let _e994 = phi_3171_;
                                            let _e996 = phi_3172_;
                                            phi_3174_ = _e994;
                                            phi_3175_ = _e996;
                                            phi_3176_ = select(true, false, _e951);
                                        } else {
                                            phi_3174_ = type_53();
                                            phi_3175_ = u32();
                                            phi_3176_ = true;
                                        }
                                        let _e999 = phi_3174_;
                                        let _e1001 = phi_3175_;
                                        let _e1003 = phi_3176_;
                                        if _e1003 {
                                            if _e950 {
                                                phi_3185_ = _e850.member_1;
                                            } else {
                                                phi_3185_ = _e850.member_2;
                                            }
                                            let _e1007 = phi_3185_;
                                            phi_3190_ = _e1007;
                                            phi_3191_ = select(_e951, true, _e950);
                                        } else {
                                            phi_3190_ = _e999;
                                            phi_3191_ = _e549;
                                        }
                                        let _e1010 = phi_3190_;
                                        let _e1012 = phi_3191_;
                                        phi_3604_ = _e506;
                                        phi_3193_ = _e508;
                                        phi_3194_ = _e1010;
                                        phi_3195_ = _e1012;
                                        phi_3196_ = select(_e1001, _e551, _e1003);
                                    }
                                    let _e1531 = phi_3604_;
                                    let _e1533 = phi_3193_;
                                    let _e1535 = phi_3194_;
                                    let _e1537 = phi_3195_;
                                    let _e1539 = phi_3196_;
                                    phi_3603_ = _e1531;
                                    phi_3197_ = _e1533;
                                    phi_3198_ = _e1535;
                                    phi_3199_ = (_e512 - 1u);
                                    phi_3200_ = _e1537;
                                    phi_3201_ = _e1539;
                                } else {
                                    phi_3603_ = _e506;
                                    phi_3197_ = _e508;
                                    phi_3198_ = _e547;
                                    phi_3199_ = _e512;
                                    phi_3200_ = _e549;
                                    phi_3201_ = _e551;
                                }
                                let _e1541 = phi_3603_;
                                let _e1543 = phi_3197_;
                                let _e1545 = phi_3198_;
                                let _e1547 = phi_3199_;
                                let _e1549 = phi_3200_;
                                let _e1551 = phi_3201_;
                                phi_3602_ = _e1541;
                                phi_3202_ = _e1543;
                                phi_3203_ = _e1545;
                                phi_3204_ = _e1547;
                                phi_3205_ = _e1549;
                                phi_3206_ = _e1551;
                            } else {
                                phi_3602_ = _e506;
                                phi_3202_ = type_37();
                                phi_3203_ = type_53();
                                phi_3204_ = u32();
                                phi_3205_ = bool();
                                phi_3206_ = u32();
                            }
                            let _e1553 = phi_3602_;
                            let _e1555 = phi_3202_;
                            let _e1557 = phi_3203_;
                            let _e1559 = phi_3204_;
                            let _e1561 = phi_3205_;
                            let _e1563 = phi_3206_;
                            phi_3601_ = _e1553;
                            phi_861_ = _e1555;
                            phi_864_ = _e1557;
                            phi_866_ = _e1559;
                            phi_868_ = _e1561;
                            phi_870_ = _e1563;
                            phi_3207_ = _e520;
                        } else {
                            phi_3601_ = _e506;
                            phi_861_ = type_37();
                            phi_864_ = type_53();
                            phi_866_ = u32();
                            phi_868_ = bool();
                            phi_870_ = u32();
                            phi_3207_ = false;
                        }
                        let _e1565 = phi_3601_;
                        let _e1567 = phi_861_;
                        let _e1569 = phi_864_;
                        let _e1571 = phi_866_;
                        let _e1573 = phi_868_;
                        let _e1575 = phi_870_;
                        let _e1577 = phi_3207_;
                        continue;
                        continuing {
                            phi_3486_ = _e1565;
                            phi_860_ = _e1567;
                            phi_863_ = _e1569;
                            phi_865_ = _e1571;
                            phi_867_ = _e1573;
                            phi_869_ = _e1575;
                            phi_3600_ = _e1565;
                            break if !(_e1577);
                        }
                    }
                    let _e1580 = phi_3600_;
                    if _e1580 {
                        break;
                    }
                    let _e1582 = local_13;
                    if (_e1582.member.member_3 != 4294967295u) {
                        let _e1587 = -(_e431);
                        let _e1588 = (_e1587 / 3i);
                        let _e1595 = bitcast<f32>((bitcast<u32>((_e1588 + 127i)) << bitcast<u32>(23i)));
                        let _e1603 = (((_e1582.member.member * _e1595) * _e1595) * bitcast<f32>((bitcast<u32>(((_e1587 - (2i * _e1588)) + 127i)) << bitcast<u32>(23i))));
                        let _e1605 = select(340282350000000000000000000000000000000f, _e1603, (_e1603 < 340282350000000000000000000000000000000f));
                        phi_3259_ = type_24(select(-340282350000000000000000000000000000000f, _e1605, (_e1605 > -340282350000000000000000000000000000000f)), _e1582.member.member_1, _e1582.member.member_2, _e1582.member.member_3);
                    } else {
                        phi_3259_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1612 = phi_3259_;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = _e1612;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
