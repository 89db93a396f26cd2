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
    member: array<array<u32, 2>>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
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
    member: type_28,
    member_1: f32,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_32,
    member_1: u32,
}

struct type_55 {
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
var<storage> global_4: type_41;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_403_: i32;
    var phi_404_: i32;
    var phi_414_: bool;
    var phi_424_: u32;
    var phi_425_: u32;
    var phi_427_: bool;
    var phi_432_: u32;
    var phi_445_: i32;
    var phi_465_: i32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_529_: f32;
    var phi_540_: f32;
    var phi_549_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_572_: f32;
    var phi_595_: f32;
    var phi_606_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_632_: f32;
    var phi_638_: f32;
    var phi_661_: f32;
    var phi_672_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_3594_: bool;
    var phi_863_: type_43;
    var phi_866_: type_54;
    var phi_868_: u32;
    var phi_870_: bool;
    var phi_872_: u32;
    var phi_883_: bool;
    var phi_969_: type_54;
    var phi_970_: bool;
    var phi_971_: u32;
    var phi_2602_: u32;
    var phi_2608_: u32;
    var phi_2862_: u32;
    var phi_2863_: u32;
    var phi_2873_: u32;
    var phi_2875_: u32;
    var phi_2876_: bool;
    var phi_2896_: u32;
    var phi_2897_: u32;
    var phi_2901_: type_55;
    var phi_3245_: type_54;
    var phi_3322_: type_54;
    var phi_3323_: type_54;
    var phi_3324_: u32;
    var phi_3326_: type_54;
    var phi_3327_: u32;
    var phi_3328_: bool;
    var phi_3337_: type_54;
    var phi_3342_: type_54;
    var phi_3343_: bool;
    var phi_3591_: bool;
    var phi_990_: type_43;
    var phi_993_: type_8;
    var phi_994_: type_8;
    var phi_1016_: type_8;
    var phi_1060_: u32;
    var phi_1066_: u32;
    var phi_1076_: u32;
    var phi_1092_: u32;
    var phi_1129_: u32;
    var phi_1135_: u32;
    var phi_1145_: u32;
    var phi_3576_: bool;
    var phi_1161_: type_8;
    var phi_1162_: type_8;
    var phi_1185_: type_8;
    var phi_1208_: u32;
    var phi_1223_: u32;
    var phi_1226_: type_8;
    var phi_1227_: type_8;
    var phi_1250_: type_8;
    var phi_1316_: u32;
    var phi_1296_: u32;
    var phi_1297_: u32;
    var phi_1320_: f32;
    var phi_3569_: bool;
    var phi_3648_: bool;
    var phi_3647_: bool;
    var phi_1820_: vec3<f32>;
    var phi_1821_: vec3<f32>;
    var phi_1852_: bool;
    var phi_1861_: vec3<f32>;
    var phi_1901_: type_28;
    var phi_1903_: type_28;
    var phi_1904_: bool;
    var phi_1908_: type_28;
    var phi_1909_: type_28;
    var phi_1910_: type_28;
    var phi_1911_: bool;
    var phi_1915_: type_28;
    var phi_1916_: bool;
    var phi_1920_: type_28;
    var phi_1921_: bool;
    var phi_1925_: type_28;
    var phi_1950_: bool;
    var phi_1951_: bool;
    var phi_1958_: type_43;
    var phi_1959_: type_43;
    var phi_1960_: type_43;
    var phi_3650_: bool;
    var phi_991_: type_43;
    var phi_3649_: bool;
    var phi_3712_: bool;
    var phi_3345_: type_43;
    var phi_3346_: type_54;
    var phi_3347_: bool;
    var phi_3348_: u32;
    var phi_3711_: bool;
    var phi_3349_: type_43;
    var phi_3350_: type_54;
    var phi_3351_: u32;
    var phi_3352_: bool;
    var phi_3353_: u32;
    var phi_3710_: bool;
    var phi_3354_: type_43;
    var phi_3355_: type_54;
    var phi_3356_: u32;
    var phi_3357_: bool;
    var phi_3358_: u32;
    var phi_3709_: bool;
    var phi_864_: type_43;
    var phi_867_: type_54;
    var phi_869_: u32;
    var phi_871_: bool;
    var phi_873_: u32;
    var phi_3359_: bool;
    var phi_3708_: bool;
    var local_13: type_43;
    var local_14: type_43;
    var local_15: type_43;

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
                            phi_403_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_403_;
                        phi_404_ = _e243;
                    } else {
                        phi_404_ = 0i;
                    }
                    let _e245 = phi_404_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_414_ = true;
                    } else {
                        phi_414_ = (_e169 == _e201);
                    }
                    let _e249 = phi_414_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_424_ = _e251;
                        phi_425_ = _e251;
                        phi_427_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_424_ = u32();
                        phi_425_ = 0u;
                        phi_427_ = true;
                    }
                    let _e255 = phi_424_;
                    let _e257 = phi_425_;
                    let _e259 = phi_427_;
                    if _e259 {
                        phi_432_ = (_e257 + 1u);
                    } else {
                        phi_432_ = 0u;
                    }
                    let _e263 = phi_432_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_445_ = -126i;
                    } else {
                        phi_445_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_445_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_465_ = -126i;
                    } else {
                        phi_465_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_465_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_483_ = _e302[0];
                    } else {
                        phi_483_ = _e302[1];
                    }
                    let _e307 = phi_483_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_489_ = _e302[2];
                    } else {
                        phi_489_ = _e307;
                    }
                    let _e311 = phi_489_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_500_ = _e314[0];
                    } else {
                        phi_500_ = _e314[1];
                    }
                    let _e318 = phi_500_;
                    if _e308 {
                        phi_506_ = _e314[2];
                    } else {
                        phi_506_ = _e318;
                    }
                    let _e321 = phi_506_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_529_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_529_ = 0f;
                    }
                    let _e335 = phi_529_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_540_ = 38685626000000000000000000f;
                    } else {
                        phi_540_ = (1f / _e323);
                    }
                    let _e341 = phi_540_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_549_ = _e302[0];
                    } else {
                        phi_549_ = _e302[1];
                    }
                    let _e346 = phi_549_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_555_ = _e302[2];
                    } else {
                        phi_555_ = _e346;
                    }
                    let _e350 = phi_555_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_566_ = _e314[0];
                    } else {
                        phi_566_ = _e314[1];
                    }
                    let _e356 = phi_566_;
                    if _e347 {
                        phi_572_ = _e314[2];
                    } else {
                        phi_572_ = _e356;
                    }
                    let _e359 = phi_572_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_595_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e373 = phi_595_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_606_ = 38685626000000000000000000f;
                    } else {
                        phi_606_ = (1f / _e361);
                    }
                    let _e379 = phi_606_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_615_ = _e302[0];
                    } else {
                        phi_615_ = _e302[1];
                    }
                    let _e384 = phi_615_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_621_ = _e302[2];
                    } else {
                        phi_621_ = _e384;
                    }
                    let _e388 = phi_621_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_632_ = _e314[0];
                    } else {
                        phi_632_ = _e314[1];
                    }
                    let _e394 = phi_632_;
                    if _e385 {
                        phi_638_ = _e314[2];
                    } else {
                        phi_638_ = _e394;
                    }
                    let _e397 = phi_638_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_661_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_661_ = 0f;
                    }
                    let _e411 = phi_661_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_672_ = 38685626000000000000000000f;
                    } else {
                        phi_672_ = (1f / _e399);
                    }
                    let _e417 = phi_672_;
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
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_773_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_772_ = 0f;
                        phi_773_ = 1f;
                    }
                    let _e462 = phi_772_;
                    let _e464 = phi_773_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e469 = (_e264 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e263 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    let _e481 = (_e265 % 3u);
                    let _e482 = (_e481 < 3u);
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e484 = local_1[_e481];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e489 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e493 = local[_e475];
                    if _e482 {
                    } else {
                        break;
                    }
                    let _e497 = local[_e481];
                    phi_3594_ = false;
                    phi_863_ = type_43(type_37(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e462), 0u, 0u);
                    phi_866_ = type_54(type_32(vec4<f32>((f32(_e472) * _e144), (f32(_e478) * _e144), (f32(_e484) * _e144), 0f), vec4<f32>((f32(_e489) * _e144), (f32(_e493) * _e144), (f32(_e497) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_868_ = ((3u * _e93) + 1u);
                    phi_870_ = (_e464 <= _e462);
                    phi_872_ = 0u;
                    loop {
                        let _e507 = phi_3594_;
                        let _e509 = phi_863_;
                        let _e511 = phi_866_;
                        let _e513 = phi_868_;
                        let _e515 = phi_870_;
                        let _e517 = phi_872_;
                        local_13 = _e509;
                        local_14 = _e509;
                        if _e515 {
                            phi_883_ = true;
                        } else {
                            phi_883_ = (_e517 > 0u);
                        }
                        let _e520 = phi_883_;
                        if _e520 {
                            let _e521 = (_e513 > 0u);
                            if _e521 {
                                if _e515 {
                                    phi_969_ = _e511;
                                    phi_970_ = _e515;
                                    phi_971_ = _e517;
                                } else {
                                    let _e522 = (_e517 - 1u);
                                    let _e523 = (_e522 % 128u);
                                    let _e524 = (_e523 < 128u);
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e526 = local_7[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e528 = local_6[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e530 = local_5[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e532 = local_4[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e534 = local_3[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e536 = local_2[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e541 = local_8[_e523];
                                    if _e524 {
                                    } else {
                                        phi_3708_ = true;
                                        break;
                                    }
                                    let _e544 = local_9[_e523];
                                    phi_969_ = type_54(type_32(vec4<f32>(_e526, _e528, _e530, 0f), vec4<f32>(_e532, _e534, _e536, 0f)), _e541);
                                    phi_970_ = (_e544 <= _e509.member.member_1);
                                    phi_971_ = _e522;
                                }
                                let _e549 = phi_969_;
                                let _e551 = phi_970_;
                                let _e553 = phi_971_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_3591_ = _e507;
                                        phi_990_ = _e509;
                                        phi_993_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1046 = phi_3591_;
                                            let _e1048 = phi_990_;
                                            let _e1050 = phi_993_;
                                            local_15 = _e1048;
                                            if (_e1050.member < _e1050.member_1) {
                                                phi_994_ = type_8((_e1050.member + 1u), _e1050.member_1);
                                                phi_1016_ = type_8(1u, _e1050.member);
                                            } else {
                                                phi_994_ = _e1050;
                                                phi_1016_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1063 = phi_994_;
                                            let _e1065 = phi_1016_;
                                            let _e1069 = (bitcast<i32>(_e1065.member) != 0i);
                                            if _e1069 {
                                                let _e1075 = type_43(_e1048.member, _e1048.member_1, (_e1048.member_2 + 1u));
                                                let _e1080 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1083 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1086 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1088 = select(_e1083, _e1080, (_e1080 > _e1083));
                                                let _e1090 = select(_e1086, _e1088, (_e1088 > _e1086));
                                                let _e1092 = (_e1090 < (1024f * _e144));
                                                if _e1092 {
                                                    phi_1060_ = 0u;
                                                } else {
                                                    phi_1060_ = select(2u, 1u, (_e1090 < (2097152f * _e144)));
                                                }
                                                let _e1097 = phi_1060_;
                                                switch bitcast<i32>(_e1097) {
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
                                                let _e1100 = phi_1066_;
                                                switch bitcast<i32>(_e1097) {
                                                    case 0: {
                                                        phi_1076_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1076_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1076_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1076_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1107 = phi_1076_;
                                                let _e1109 = ((_e558 + (_e1065.member_1 * ((3u * _e1100) + 1u))) + (3u * _e1107));
                                                let _e1110 = (_e1109 < _e96);
                                                if _e1110 {
                                                    if _e1110 {
                                                    } else {
                                                        phi_3649_ = true;
                                                        break;
                                                    }
                                                    let _e1112 = global_5.member[_e1109];
                                                    phi_1092_ = _e1112;
                                                } else {
                                                    phi_1092_ = 4294967295u;
                                                }
                                                let _e1114 = phi_1092_;
                                                local_10 = array<u32, 3>(_e264, _e263, _e265);
                                                if _e1092 {
                                                    phi_1129_ = 0u;
                                                } else {
                                                    phi_1129_ = select(2u, 1u, (_e1090 < (2097152f * _e144)));
                                                }
                                                let _e1120 = phi_1129_;
                                                switch bitcast<i32>(_e1120) {
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
                                                let _e1123 = phi_1135_;
                                                switch bitcast<i32>(_e1120) {
                                                    case 0: {
                                                        phi_1145_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1145_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1145_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1145_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1130 = phi_1145_;
                                                local_12 = array<f32, 4>(_e549.member.member.x, _e549.member.member.y, _e549.member.member.z, _e549.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3576_ = _e1046;
                                                phi_1161_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1144 = phi_3576_;
                                                    let _e1146 = phi_1161_;
                                                    if (_e1146.member < _e1146.member_1) {
                                                        phi_1162_ = type_8((_e1146.member + 1u), _e1146.member_1);
                                                        phi_1185_ = type_8(1u, _e1146.member);
                                                    } else {
                                                        phi_1162_ = _e1146;
                                                        phi_1185_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1159 = phi_1162_;
                                                    let _e1161 = phi_1185_;
                                                    let _e1165 = (bitcast<i32>(_e1161.member) != 0i);
                                                    if _e1165 {
                                                        let _e1167 = ((_e558 + (_e1065.member_1 * ((3u * _e1123) + 1u))) + (_e1161.member_1 * _e1130));
                                                        let _e1168 = (_e1167 < _e96);
                                                        if _e1168 {
                                                            if _e1168 {
                                                            } else {
                                                                phi_3647_ = true;
                                                                break;
                                                            }
                                                            let _e1170 = global_5.member[_e1167];
                                                            phi_1208_ = _e1170;
                                                        } else {
                                                            phi_1208_ = 0u;
                                                        }
                                                        let _e1172 = phi_1208_;
                                                        let _e1173 = (_e1167 + 1u);
                                                        let _e1174 = (_e1173 < _e96);
                                                        if _e1174 {
                                                            if _e1174 {
                                                            } else {
                                                                phi_3647_ = true;
                                                                break;
                                                            }
                                                            let _e1176 = global_5.member[_e1173];
                                                            phi_1223_ = _e1176;
                                                        } else {
                                                            phi_1223_ = 0u;
                                                        }
                                                        let _e1178 = phi_1223_;
                                                        phi_1226_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1180 = phi_1226_;
                                                            if (_e1180.member < _e1180.member_1) {
                                                                phi_1227_ = type_8((_e1180.member + 1u), _e1180.member_1);
                                                                phi_1250_ = type_8(1u, _e1180.member);
                                                            } else {
                                                                phi_1227_ = _e1180;
                                                                phi_1250_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1193 = phi_1227_;
                                                            let _e1195 = phi_1250_;
                                                            let _e1199 = (bitcast<i32>(_e1195.member) != 0i);
                                                            if _e1199 {
                                                                let _e1200 = (_e1195.member_1 < 3u);
                                                                if _e1200 {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                let _e1202 = local_10[_e1195.member_1];
                                                                if (_e1195.member_1 < 4u) {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                let _e1205 = local_12[_e1195.member_1];
                                                                switch bitcast<i32>(_e1120) {
                                                                    case 0: {
                                                                        phi_1320_ = (_e1205 + (f32(((_e1172 >> bitcast<u32>(((10u * _e1202) & 31u))) & 1023u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1202 == 0u) {
                                                                            phi_1297_ = _e1172;
                                                                        } else {
                                                                            if (_e1202 == 1u) {
                                                                                phi_1296_ = ((_e1172 >> bitcast<u32>(21i)) | (_e1178 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1296_ = (_e1178 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1226 = phi_1296_;
                                                                            phi_1297_ = _e1226;
                                                                        }
                                                                        let _e1228 = phi_1297_;
                                                                        phi_1320_ = (_e1205 + (f32((_e1228 & 2097151u)) * _e144));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1207 = (_e1167 + _e1202);
                                                                        let _e1208 = (_e1207 < _e96);
                                                                        if _e1208 {
                                                                            if _e1208 {
                                                                            } else {
                                                                                phi_3569_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1210 = global_5.member[_e1207];
                                                                            phi_1316_ = _e1210;
                                                                        } else {
                                                                            phi_1316_ = 0u;
                                                                        }
                                                                        let _e1212 = phi_1316_;
                                                                        phi_1320_ = (f32(bitcast<i32>(_e1212)) * _e144);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1320_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1242 = phi_1320_;
                                                                if (_e1161.member_1 < 3u) {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                if _e1200 {
                                                                } else {
                                                                    phi_3569_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1161.member_1][_e1195.member_1] = _e1242;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1226_ = _e1193;
                                                                phi_3569_ = _e1144;
                                                                break if !(_e1199);
                                                            }
                                                        }
                                                        let _e1248 = phi_3569_;
                                                        phi_3647_ = _e1248;
                                                        if _e1248 {
                                                            break;
                                                        }
                                                        phi_3648_ = _e1248;
                                                    } else {
                                                        phi_3648_ = _e1144;
                                                    }
                                                    let _e1250 = phi_3648_;
                                                    continue;
                                                    continuing {
                                                        phi_3576_ = _e1250;
                                                        phi_1161_ = _e1159;
                                                        phi_3647_ = _e1250;
                                                        break if !(_e1165);
                                                    }
                                                }
                                                let _e1253 = phi_3647_;
                                                phi_3649_ = _e1253;
                                                if _e1253 {
                                                    break;
                                                }
                                                let _e1254 = local_11;
                                                let _e1271 = (_e1254[0][2] - _e390);
                                                let _e1274 = (((_e1254[0][0] - _e313) * _e414) - (_e1271 * _e338));
                                                let _e1277 = (((_e1254[0][1] - _e352) * _e414) - (_e1271 * _e376));
                                                let _e1280 = (_e1254[1][2] - _e390);
                                                let _e1283 = (((_e1254[1][0] - _e313) * _e414) - (_e1280 * _e338));
                                                let _e1286 = (((_e1254[1][1] - _e352) * _e414) - (_e1280 * _e376));
                                                let _e1289 = (_e1254[2][2] - _e390);
                                                let _e1292 = (((_e1254[2][0] - _e313) * _e414) - (_e1289 * _e338));
                                                let _e1295 = (((_e1254[2][1] - _e352) * _e414) - (_e1289 * _e376));
                                                let _e1296 = (_e1292 * _e1286);
                                                let _e1297 = (_e1295 * _e1283);
                                                let _e1298 = (_e1274 * _e1295);
                                                let _e1299 = (_e1277 * _e1292);
                                                let _e1300 = (_e1283 * _e1277);
                                                let _e1301 = (_e1286 * _e1274);
                                                let _e1306 = (((_e1296 >= _e1297) && (_e1298 >= _e1299)) && (_e1300 >= _e1301));
                                                if (_e1306 || (((_e1296 <= _e1297) && (_e1298 <= _e1299)) && (_e1300 <= _e1301))) {
                                                    let _e1313 = select(-1f, 1f, _e1306);
                                                    let _e1315 = ((_e1296 - _e1297) * _e1313);
                                                    let _e1317 = select(0f, _e1315, (_e1315 > 0f));
                                                    let _e1319 = ((_e1298 - _e1299) * _e1313);
                                                    let _e1321 = select(0f, _e1319, (_e1319 > 0f));
                                                    let _e1323 = ((_e1300 - _e1301) * _e1313);
                                                    let _e1325 = select(0f, _e1323, (_e1323 > 0f));
                                                    let _e1327 = ((_e1317 + _e1321) + _e1325);
                                                    if (_e1327 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1915_ = type_28();
                                                        phi_1916_ = true;
                                                    } else {
                                                        let _e1330 = select(_e1254[1][0], _e1254[0][0], (_e1254[0][0] < _e1254[1][0]));
                                                        let _e1334 = select(_e1254[1][0], _e1254[0][0], (_e1254[0][0] > _e1254[1][0]));
                                                        let _e1338 = select(_e1254[1][1], _e1254[0][1], (_e1254[0][1] < _e1254[1][1]));
                                                        let _e1342 = select(_e1254[1][1], _e1254[0][1], (_e1254[0][1] > _e1254[1][1]));
                                                        let _e1346 = select(_e1254[1][2], _e1254[0][2], (_e1254[0][2] < _e1254[1][2]));
                                                        let _e1350 = select(_e1254[1][2], _e1254[0][2], (_e1254[0][2] > _e1254[1][2]));
                                                        let _e1355 = ((select(_e1254[2][0], _e1330, (_e1330 < _e1254[2][0])) - _e336) * _e341);
                                                        let _e1356 = ((select(_e1254[2][0], _e1334, (_e1334 > _e1254[2][0])) - _e337) * _e341);
                                                        let _e1359 = ((select(_e1254[2][1], _e1338, (_e1338 < _e1254[2][1])) - _e374) * _e379);
                                                        let _e1360 = ((select(_e1254[2][1], _e1342, (_e1342 > _e1254[2][1])) - _e375) * _e379);
                                                        let _e1363 = ((select(_e1254[2][2], _e1346, (_e1346 < _e1254[2][2])) - _e412) * _e417);
                                                        let _e1364 = ((select(_e1254[2][2], _e1350, (_e1350 > _e1254[2][2])) - _e413) * _e417);
                                                        let _e1366 = select(_e1364, _e1363, (_e1363 < _e1364));
                                                        let _e1368 = select(_e1364, _e1363, (_e1363 > _e1364));
                                                        let _e1370 = select(_e1356, _e1355, (_e1355 < _e1356));
                                                        let _e1372 = select(_e1360, _e1359, (_e1359 < _e1360));
                                                        let _e1374 = select(_e1372, _e1370, (_e1370 > _e1372));
                                                        let _e1376 = select(_e1366, _e1374, (_e1374 > _e1366));
                                                        let _e1378 = select(_e1356, _e1355, (_e1355 > _e1356));
                                                        let _e1380 = select(_e1360, _e1359, (_e1359 > _e1360));
                                                        let _e1382 = select(_e1380, _e1378, (_e1378 < _e1380));
                                                        let _e1384 = select(_e1368, _e1382, (_e1382 < _e1368));
                                                        let _e1385 = -(_e1366);
                                                        let _e1391 = select(_e464, _e1376, (_e1376 > _e464));
                                                        if (_e1391 > (_e1384 + (select(_e1385, _e1368, (_e1368 > _e1385)) * 0.0000019073523f))) {
                                                            phi_1910_ = type_28();
                                                            phi_1911_ = true;
                                                        } else {
                                                            let _e1393 = (_e1391 > _e1048.member.member_1);
                                                            if _e1393 {
                                                                phi_1909_ = type_28();
                                                            } else {
                                                                let _e1397 = (_e1254[1][0] - _e1254[0][0]);
                                                                let _e1398 = (_e1254[1][1] - _e1254[0][1]);
                                                                let _e1399 = (_e1254[1][2] - _e1254[0][2]);
                                                                let _e1400 = vec3<f32>(_e1397, _e1398, _e1399);
                                                                let _e1401 = (_e1254[2][0] - _e1254[1][0]);
                                                                let _e1402 = (_e1254[2][1] - _e1254[1][1]);
                                                                let _e1403 = (_e1254[2][2] - _e1254[1][2]);
                                                                let _e1404 = vec3<f32>(_e1401, _e1402, _e1403);
                                                                let _e1405 = (_e1254[0][0] - _e1254[2][0]);
                                                                let _e1406 = (_e1254[0][1] - _e1254[2][1]);
                                                                let _e1407 = (_e1254[0][2] - _e1254[2][2]);
                                                                let _e1408 = vec3<f32>(_e1405, _e1406, _e1407);
                                                                let _e1411 = bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u));
                                                                let _e1414 = bitcast<f32>((bitcast<u32>(_e1398) & 2147483647u));
                                                                let _e1416 = select(_e1414, _e1411, (_e1411 > _e1414));
                                                                let _e1419 = bitcast<f32>((bitcast<u32>(_e1399) & 2147483647u));
                                                                let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                                let _e1427 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                let _e1429 = select(_e1427, _e1424, (_e1424 > _e1427));
                                                                let _e1432 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                                let _e1434 = select(_e1432, _e1429, (_e1429 > _e1432));
                                                                let _e1437 = bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u));
                                                                let _e1440 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                                let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                let _e1445 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                                let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                                let _e1449 = select(_e1434, _e1421, (_e1421 > _e1434));
                                                                let _e1451 = select(_e1447, _e1449, (_e1449 > _e1447));
                                                                if (_e1421 == _e1451) {
                                                                    phi_1820_ = _e1404;
                                                                    phi_1821_ = _e1408;
                                                                } else {
                                                                    let _e1454 = vec3((_e1434 == _e1451));
                                                                    phi_1820_ = select(_e1400, _e1408, _e1454);
                                                                    phi_1821_ = select(_e1404, _e1400, _e1454);
                                                                }
                                                                let _e1458 = phi_1820_;
                                                                let _e1460 = phi_1821_;
                                                                let _e1467 = ((_e1458.y * _e1460.z) - (_e1460.y * _e1458.z));
                                                                let _e1472 = ((_e1458.z * _e1460.x) - (_e1460.z * _e1458.x));
                                                                let _e1475 = ((_e1458.x * _e1460.y) - (_e1460.x * _e1458.y));
                                                                if (_e1317 >= _e1321) {
                                                                    phi_1852_ = select(true, false, (_e1317 >= _e1325));
                                                                } else {
                                                                    phi_1852_ = true;
                                                                }
                                                                let _e1480 = phi_1852_;
                                                                if _e1480 {
                                                                    phi_1861_ = select(vec3<f32>(_e1254[2][0], _e1254[2][1], _e1254[2][2]), vec3<f32>(_e1254[1][0], _e1254[1][1], _e1254[1][2]), vec3((_e1321 >= _e1325)));
                                                                } else {
                                                                    phi_1861_ = vec3<f32>(_e1254[0][0], _e1254[0][1], _e1254[0][2]);
                                                                }
                                                                let _e1485 = phi_1861_;
                                                                let _e1502 = ((((_e1467 * (_e1485.x - _e313)) + (_e1472 * (_e1485.y - _e352))) + (_e1475 * (_e1485.z - _e390))) / (((_e1467 * _e338) + (_e1472 * _e376)) + (_e1475 * _e414)));
                                                                let _e1504 = select(_e1384, _e1502, (_e1502 < _e1384));
                                                                let _e1506 = select(_e1376, _e1504, (_e1504 > _e1376));
                                                                if (_e1506 >= _e464) {
                                                                    let _e1508 = (_e1506 <= _e1048.member.member_1);
                                                                    if _e1508 {
                                                                        let _e1509 = (1f / _e1327);
                                                                        phi_1901_ = type_28(_e1506, (_e1321 * _e1509), (_e1325 * _e1509), _e1114);
                                                                    } else {
                                                                        phi_1901_ = type_28();
                                                                    }
                                                                    let _e1514 = phi_1901_;
                                                                    phi_1903_ = _e1514;
                                                                    phi_1904_ = select(true, false, _e1508);
                                                                } else {
                                                                    phi_1903_ = type_28();
                                                                    phi_1904_ = true;
                                                                }
                                                                let _e1517 = phi_1903_;
                                                                let _e1519 = phi_1904_;
                                                                if _e1519 {
                                                                    phi_1908_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1908_ = _e1517;
                                                                }
                                                                let _e1521 = phi_1908_;
                                                                phi_1909_ = _e1521;
                                                            }
                                                            let _e1523 = phi_1909_;
                                                            phi_1910_ = _e1523;
                                                            phi_1911_ = _e1393;
                                                        }
                                                        let _e1525 = phi_1910_;
                                                        let _e1527 = phi_1911_;
                                                        phi_1915_ = _e1525;
                                                        phi_1916_ = _e1527;
                                                    }
                                                    let _e1529 = phi_1915_;
                                                    let _e1531 = phi_1916_;
                                                    phi_1920_ = _e1529;
                                                    phi_1921_ = _e1531;
                                                } else {
                                                    phi_1920_ = type_28();
                                                    phi_1921_ = true;
                                                }
                                                let _e1533 = phi_1920_;
                                                let _e1535 = phi_1921_;
                                                if _e1535 {
                                                    phi_1925_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1925_ = _e1533;
                                                }
                                                let _e1537 = phi_1925_;
                                                if (_e1537.member_3 != 4294967295u) {
                                                    if (_e1114 != 4294967295u) {
                                                        if (_e1537.member < _e1048.member.member.member) {
                                                            phi_1951_ = true;
                                                        } else {
                                                            if (_e1537.member == _e1048.member.member.member) {
                                                                phi_1950_ = (_e1537.member_3 < _e1048.member.member.member_3);
                                                            } else {
                                                                phi_1950_ = false;
                                                            }
                                                            let _e1552 = phi_1950_;
                                                            phi_1951_ = _e1552;
                                                        }
                                                        let _e1554 = phi_1951_;
                                                        if _e1554 {
                                                            phi_1958_ = type_43(type_37(_e1537, _e1537.member), _e1075.member_1, _e1075.member_2);
                                                        } else {
                                                            phi_1958_ = _e1075;
                                                        }
                                                        let _e1561 = phi_1958_;
                                                        phi_1959_ = _e1561;
                                                    } else {
                                                        phi_1959_ = _e1075;
                                                    }
                                                    let _e1563 = phi_1959_;
                                                    phi_1960_ = _e1563;
                                                } else {
                                                    phi_1960_ = _e1075;
                                                }
                                                let _e1565 = phi_1960_;
                                                phi_3650_ = _e1253;
                                                phi_991_ = _e1565;
                                            } else {
                                                phi_3650_ = _e1046;
                                                phi_991_ = type_43();
                                            }
                                            let _e1567 = phi_3650_;
                                            let _e1569 = phi_991_;
                                            continue;
                                            continuing {
                                                phi_3591_ = _e1567;
                                                phi_990_ = _e1569;
                                                phi_993_ = _e1063;
                                                phi_3649_ = _e1567;
                                                break if !(_e1069);
                                            }
                                        }
                                        let _e1572 = phi_3649_;
                                        phi_3708_ = _e1572;
                                        if _e1572 {
                                            break;
                                        }
                                        phi_3712_ = _e1572;
                                        let _e1750 = local_15;
                                        phi_3345_ = _e1750;
                                        phi_3346_ = _e549;
                                        phi_3347_ = false;
                                        phi_3348_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e93) {
                                            phi_2901_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e93) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e572 = ((1u + _e264) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e549.member_1][_e572];
                                            let _e579 = ((1u + _e263) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e584 = global_3.member[_e549.member_1][_e579];
                                            let _e586 = ((1u + _e265) % 4u);
                                            if (_e586 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e591 = global_3.member[_e549.member_1][_e586];
                                            let _e593 = ((_e264 + 1u) % 4u);
                                            if (_e593 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e598 = global_3.member[_e549.member_1][_e593];
                                            let _e600 = (_e598 >> bitcast<u32>(11u));
                                            let _e602 = ((_e263 + 1u) % 4u);
                                            if (_e602 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e607 = global_3.member[_e549.member_1][_e602];
                                            let _e609 = (_e607 >> bitcast<u32>(11u));
                                            let _e611 = ((_e265 + 1u) % 4u);
                                            if (_e611 < 4u) {
                                            } else {
                                                phi_3708_ = true;
                                                break;
                                            }
                                            let _e616 = global_3.member[_e549.member_1][_e611];
                                            let _e618 = (_e616 >> bitcast<u32>(11u));
                                            let _e641 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e642 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e643 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e645 = select(_e144, _e641, (_e641 > _e144));
                                            let _e647 = select(_e144, _e642, (_e642 > _e144));
                                            let _e649 = select(_e144, _e643, (_e643 > _e144));
                                            let _e674 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e645));
                                            let _e679 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e682 = bitcast<f32>((_e674 & bitcast<u32>(_e679)));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e647));
                                            let _e688 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e591 & 1023u))) * _e649));
                                            let _e697 = (bitcast<i32>((_e591 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e704 = bitcast<f32>((_e674 & bitcast<u32>(~(_e679))));
                                            let _e708 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e712 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e713 = bitcast<u32>((f32(bitcast<i32>((_e600 & 1023u))) * _e645));
                                            let _e718 = (bitcast<i32>((_e600 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e721 = bitcast<f32>((_e713 & bitcast<u32>(_e718)));
                                            let _e722 = bitcast<u32>((f32(bitcast<i32>((_e609 & 1023u))) * _e647));
                                            let _e727 = (bitcast<i32>((_e609 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e730 = bitcast<f32>((_e722 & bitcast<u32>(_e727)));
                                            let _e731 = bitcast<u32>((f32(bitcast<i32>((_e618 & 1023u))) * _e649));
                                            let _e736 = (bitcast<i32>((_e618 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e739 = bitcast<f32>((_e731 & bitcast<u32>(_e736)));
                                            let _e743 = bitcast<f32>((_e713 & bitcast<u32>(~(_e718))));
                                            let _e747 = bitcast<f32>((_e722 & bitcast<u32>(~(_e727))));
                                            let _e751 = bitcast<f32>((_e731 & bitcast<u32>(~(_e736))));
                                            let _e752 = (_e549.member.member.x + _e682);
                                            let _e753 = (_e549.member.member.y + _e691);
                                            let _e754 = (_e549.member.member.z + _e700);
                                            let _e757 = (_e549.member.member_1.x - _e721);
                                            let _e758 = (_e549.member.member_1.y - _e730);
                                            let _e759 = (_e549.member.member_1.z - _e739);
                                            let _e778 = (_e757 - _e752);
                                            let _e779 = (_e758 - _e753);
                                            let _e780 = (_e759 - _e754);
                                            let _e782 = select(_e779, _e778, (_e778 > _e779));
                                            let _e784 = select(_e780, _e782, (_e782 > _e780));
                                            if (_e784 < (1024f * _e144)) {
                                                phi_2602_ = 0u;
                                            } else {
                                                phi_2602_ = select(2u, 1u, (_e784 < (2097152f * _e144)));
                                            }
                                            let _e791 = phi_2602_;
                                            switch bitcast<i32>(_e791) {
                                                case 0: {
                                                    phi_2608_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2608_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2608_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2608_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e794 = phi_2608_;
                                            let _e800 = global_3.member[_e549.member_1][0u];
                                            let _e804 = global_3.member[_e549.member_1][1u];
                                            let _e808 = global_3.member[_e549.member_1][2u];
                                            let _e812 = global_3.member[_e549.member_1][3u];
                                            let _e824 = (((_e804 >> bitcast<u32>(22i)) | ((_e808 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e812 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e825 = (_e800 & 268435455u);
                                            let _e826 = (_e824 & 268435455u);
                                            let _e829 = ((_e800 >> bitcast<u32>(28u)) & 7u);
                                            let _e837 = ((_e800 >> bitcast<u32>(31i)) | (((_e824 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e838 = (_e829 != 0u);
                                            if (_e829 == 0u) {
                                                phi_2863_ = _e825;
                                            } else {
                                                if (_e829 == 7u) {
                                                    phi_2862_ = 2147483648u;
                                                } else {
                                                    phi_2862_ = ((2147483648u | (_e829 << bitcast<u32>(28u))) | (_e826 & 268435455u));
                                                }
                                                let _e847 = phi_2862_;
                                                phi_2863_ = _e847;
                                            }
                                            let _e849 = phi_2863_;
                                            if _e838 {
                                                let _e850 = (_e829 != 7u);
                                                if _e850 {
                                                    phi_2873_ = (_e826 + (_e829 * ((3u * _e794) + 1u)));
                                                } else {
                                                    phi_2873_ = u32();
                                                }
                                                let _e854 = phi_2873_;
                                                phi_2875_ = _e854;
                                                phi_2876_ = select(true, false, _e850);
                                            } else {
                                                phi_2875_ = u32();
                                                phi_2876_ = true;
                                            }
                                            let _e857 = phi_2875_;
                                            let _e859 = phi_2876_;
                                            if (_e837 == 0u) {
                                                phi_2897_ = (_e825 + select(0u, 1u, !(_e838)));
                                            } else {
                                                if (_e837 == 7u) {
                                                    phi_2896_ = 2147483648u;
                                                } else {
                                                    phi_2896_ = ((2147483648u | (_e837 << bitcast<u32>(28u))) | (select(_e857, _e826, _e859) & 268435455u));
                                                }
                                                let _e872 = phi_2896_;
                                                phi_2897_ = _e872;
                                            }
                                            let _e874 = phi_2897_;
                                            phi_2901_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e752, (_e549.member.member.x + _e704), _e757, (_e549.member.member_1.x - _e743)), vec4<f32>(_e753, (_e549.member.member.y + _e708), _e758, (_e549.member.member_1.y - _e747)), vec4<f32>(_e754, (_e549.member.member.z + _e712), _e759, (_e549.member.member_1.z - _e751))), type_54(type_32((_e549.member.member + vec4<f32>(_e682, _e691, _e700, 0f)), (_e549.member.member_1 - vec4<f32>(_e721, _e730, _e739, 0f))), _e849), type_54(type_32((_e549.member.member + vec4<f32>(_e704, _e708, _e712, 0f)), (_e549.member.member_1 - vec4<f32>(_e743, _e747, _e751, 0f))), _e874));
                                        }
                                        let _e879 = phi_2901_;
                                        let _e892 = ((_e879.member[0].x - _e336) * _e341);
                                        let _e893 = ((_e879.member[0].y - _e336) * _e341);
                                        let _e894 = ((_e879.member[0].z - _e337) * _e341);
                                        let _e895 = ((_e879.member[0].w - _e337) * _e341);
                                        let _e905 = ((_e879.member[1].x - _e374) * _e379);
                                        let _e906 = ((_e879.member[1].y - _e374) * _e379);
                                        let _e907 = ((_e879.member[1].z - _e375) * _e379);
                                        let _e908 = ((_e879.member[1].w - _e375) * _e379);
                                        let _e918 = ((_e879.member[2].x - _e412) * _e417);
                                        let _e919 = ((_e879.member[2].y - _e412) * _e417);
                                        let _e920 = ((_e879.member[2].z - _e413) * _e417);
                                        let _e921 = ((_e879.member[2].w - _e413) * _e417);
                                        let _e923 = select(_e920, _e918, (_e918 < _e920));
                                        let _e925 = select(_e921, _e919, (_e919 < _e921));
                                        let _e927 = select(_e920, _e918, (_e918 > _e920));
                                        let _e929 = select(_e921, _e919, (_e919 > _e921));
                                        let _e931 = select(_e894, _e892, (_e892 < _e894));
                                        let _e933 = select(_e895, _e893, (_e893 < _e895));
                                        let _e935 = select(_e907, _e905, (_e905 < _e907));
                                        let _e937 = select(_e908, _e906, (_e906 < _e908));
                                        let _e939 = select(_e935, _e931, (_e931 > _e935));
                                        let _e941 = select(_e937, _e933, (_e933 > _e937));
                                        let _e943 = select(_e923, _e939, (_e939 > _e923));
                                        let _e945 = select(_e925, _e941, (_e941 > _e925));
                                        let _e947 = select(_e894, _e892, (_e892 > _e894));
                                        let _e949 = select(_e895, _e893, (_e893 > _e895));
                                        let _e951 = select(_e907, _e905, (_e905 > _e907));
                                        let _e953 = select(_e908, _e906, (_e906 > _e908));
                                        let _e955 = select(_e951, _e947, (_e947 < _e951));
                                        let _e957 = select(_e953, _e949, (_e949 < _e953));
                                        let _e962 = -(_e923);
                                        let _e963 = -(_e925);
                                        let _e970 = (select(_e927, _e955, (_e955 < _e927)) + (select(_e962, _e927, (_e927 > _e962)) * 0.0000019073523f));
                                        let _e971 = (select(_e929, _e957, (_e957 < _e929)) + (select(_e963, _e929, (_e929 > _e963)) * 0.0000019073523f));
                                        let _e973 = select(_e464, _e943, (_e943 > _e464));
                                        let _e975 = select(_e464, _e945, (_e945 > _e464));
                                        let _e980 = (_e973 <= select(_e509.member.member_1, _e970, (_e970 < _e509.member.member_1)));
                                        let _e981 = (_e975 <= select(_e509.member.member_1, _e971, (_e971 < _e509.member.member_1)));
                                        let _e982 = (_e973 <= _e975);
                                        if _e980 {
                                            if _e981 {
                                                if _e982 {
                                                    phi_3245_ = _e879.member_2;
                                                } else {
                                                    phi_3245_ = _e879.member_1;
                                                }
                                                let _e986 = phi_3245_;
                                                let _e1008 = (_e553 % 128u);
                                                let _e1009 = (_e1008 < 128u);
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_8[_e1008] = _e986.member_1;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_7[_e1008] = _e986.member.member.x;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_6[_e1008] = _e986.member.member.y;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_5[_e1008] = _e986.member.member.z;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_4[_e1008] = _e986.member.member_1.x;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_3[_e1008] = _e986.member.member_1.y;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_2[_e1008] = _e986.member.member_1.z;
                                                if _e1009 {
                                                } else {
                                                    phi_3708_ = true;
                                                    break;
                                                }
                                                local_9[_e1008] = select(_e975, _e973, (_e973 > _e975));
                                                if _e982 {
                                                    phi_3322_ = _e879.member_1;
                                                } else {
                                                    phi_3322_ = _e879.member_2;
                                                }
                                                let _e1022 = phi_3322_;
                                                phi_3323_ = _e1022;
                                                phi_3324_ = (_e553 + 1u);
                                            } else {
                                                phi_3323_ = type_54();
                                                phi_3324_ = u32();
                                            }
                                            let _e1024 = phi_3323_;
                                            let _e1026 = phi_3324_;
                                            phi_3326_ = _e1024;
                                            phi_3327_ = _e1026;
                                            phi_3328_ = select(true, false, _e981);
                                        } else {
                                            phi_3326_ = type_54();
                                            phi_3327_ = u32();
                                            phi_3328_ = true;
                                        }
                                        let _e1029 = phi_3326_;
                                        let _e1031 = phi_3327_;
                                        let _e1033 = phi_3328_;
                                        if _e1033 {
                                            if _e980 {
                                                phi_3337_ = _e879.member_1;
                                            } else {
                                                phi_3337_ = _e879.member_2;
                                            }
                                            let _e1037 = phi_3337_;
                                            phi_3342_ = _e1037;
                                            phi_3343_ = select(_e981, true, _e980);
                                        } else {
                                            phi_3342_ = _e1029;
                                            phi_3343_ = _e551;
                                        }
                                        let _e1040 = phi_3342_;
                                        let _e1042 = phi_3343_;
                                        phi_3712_ = _e507;
                                        phi_3345_ = type_43(_e509.member, (_e509.member_1 + 1u), _e509.member_2);
                                        phi_3346_ = _e1040;
                                        phi_3347_ = _e1042;
                                        phi_3348_ = select(_e1031, _e553, _e1033);
                                    }
                                    let _e1574 = phi_3712_;
                                    let _e1576 = phi_3345_;
                                    let _e1578 = phi_3346_;
                                    let _e1580 = phi_3347_;
                                    let _e1582 = phi_3348_;
                                    phi_3711_ = _e1574;
                                    phi_3349_ = _e1576;
                                    phi_3350_ = _e1578;
                                    phi_3351_ = (_e513 - 1u);
                                    phi_3352_ = _e1580;
                                    phi_3353_ = _e1582;
                                } else {
                                    phi_3711_ = _e507;
                                    phi_3349_ = _e509;
                                    phi_3350_ = _e549;
                                    phi_3351_ = _e513;
                                    phi_3352_ = _e551;
                                    phi_3353_ = _e553;
                                }
                                let _e1584 = phi_3711_;
                                let _e1586 = phi_3349_;
                                let _e1588 = phi_3350_;
                                let _e1590 = phi_3351_;
                                let _e1592 = phi_3352_;
                                let _e1594 = phi_3353_;
                                phi_3710_ = _e1584;
                                phi_3354_ = _e1586;
                                phi_3355_ = _e1588;
                                phi_3356_ = _e1590;
                                phi_3357_ = _e1592;
                                phi_3358_ = _e1594;
                            } else {
                                phi_3710_ = _e507;
                                phi_3354_ = type_43();
                                phi_3355_ = type_54();
                                phi_3356_ = u32();
                                phi_3357_ = bool();
                                phi_3358_ = u32();
                            }
                            let _e1596 = phi_3710_;
                            let _e1598 = phi_3354_;
                            let _e1600 = phi_3355_;
                            let _e1602 = phi_3356_;
                            let _e1604 = phi_3357_;
                            let _e1606 = phi_3358_;
                            phi_3709_ = _e1596;
                            phi_864_ = _e1598;
                            phi_867_ = _e1600;
                            phi_869_ = _e1602;
                            phi_871_ = _e1604;
                            phi_873_ = _e1606;
                            phi_3359_ = _e521;
                        } else {
                            phi_3709_ = _e507;
                            phi_864_ = type_43();
                            phi_867_ = type_54();
                            phi_869_ = u32();
                            phi_871_ = bool();
                            phi_873_ = u32();
                            phi_3359_ = false;
                        }
                        let _e1608 = phi_3709_;
                        let _e1610 = phi_864_;
                        let _e1612 = phi_867_;
                        let _e1614 = phi_869_;
                        let _e1616 = phi_871_;
                        let _e1618 = phi_873_;
                        let _e1620 = phi_3359_;
                        continue;
                        continuing {
                            phi_3594_ = _e1608;
                            phi_863_ = _e1610;
                            phi_866_ = _e1612;
                            phi_868_ = _e1614;
                            phi_870_ = _e1616;
                            phi_872_ = _e1618;
                            phi_3708_ = _e1608;
                            break if !(_e1620);
                        }
                    }
                    let _e1623 = phi_3708_;
                    if _e1623 {
                        break;
                    }
                    let _e1625 = local_13;
                    let _e1628 = local_14;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150][0u] = _e1625.member_1;
                    global_6.member[_e150][1u] = _e1628.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
