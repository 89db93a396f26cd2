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

struct type_45 {
    member: type_28,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
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
    var phi_389_: i32;
    var phi_390_: i32;
    var phi_400_: bool;
    var phi_410_: u32;
    var phi_411_: u32;
    var phi_413_: bool;
    var phi_418_: u32;
    var phi_430_: i32;
    var phi_450_: i32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_617_: f32;
    var phi_623_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_4010_: bool;
    var phi_847_: type_38;
    var phi_850_: type_45;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_867_: bool;
    var phi_953_: type_45;
    var phi_954_: bool;
    var phi_955_: u32;
    var phi_3043_: u32;
    var phi_3049_: u32;
    var phi_3303_: u32;
    var phi_3304_: u32;
    var phi_3314_: u32;
    var phi_3316_: u32;
    var phi_3317_: bool;
    var phi_3337_: u32;
    var phi_3338_: u32;
    var phi_3342_: type_46;
    var phi_3686_: type_45;
    var phi_3763_: type_45;
    var phi_3764_: type_45;
    var phi_3765_: u32;
    var phi_3767_: type_45;
    var phi_3768_: u32;
    var phi_3769_: bool;
    var phi_3778_: type_45;
    var phi_3783_: type_45;
    var phi_3784_: bool;
    var phi_974_: type_38;
    var phi_977_: type_8;
    var phi_978_: type_8;
    var phi_1000_: type_8;
    var phi_1041_: u32;
    var phi_1047_: u32;
    var phi_1057_: u32;
    var phi_1073_: u32;
    var phi_1106_: u32;
    var phi_1112_: u32;
    var phi_1539_: u32;
    var phi_1557_: u32;
    var phi_1575_: u32;
    var phi_1595_: u32;
    var phi_1613_: u32;
    var phi_1631_: u32;
    var phi_1651_: u32;
    var phi_1669_: u32;
    var phi_1687_: u32;
    var phi_1265_: u32;
    var phi_1280_: u32;
    var phi_1290_: u32;
    var phi_1310_: u32;
    var phi_1330_: u32;
    var phi_1356_: u32;
    var phi_1371_: u32;
    var phi_1381_: u32;
    var phi_1401_: u32;
    var phi_1421_: u32;
    var phi_1447_: u32;
    var phi_1462_: u32;
    var phi_1472_: u32;
    var phi_1492_: u32;
    var phi_1512_: u32;
    var phi_1136_: u32;
    var phi_1179_: u32;
    var phi_1222_: u32;
    var phi_1693_: array<array<f32, 3>, 3>;
    var phi_1810_: bool;
    var phi_1839_: bool;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2243_: f32;
    var phi_2244_: vec3<f32>;
    var phi_2245_: vec3<f32>;
    var phi_2246_: vec3<f32>;
    var phi_2247_: vec3<f32>;
    var phi_2278_: bool;
    var phi_2287_: vec3<f32>;
    var phi_2452_: f32;
    var phi_2454_: f32;
    var phi_2455_: bool;
    var phi_2475_: f32;
    var phi_2476_: f32;
    var phi_2499_: type_24;
    var phi_2501_: type_24;
    var phi_2502_: bool;
    var phi_2506_: type_24;
    var phi_2507_: type_24;
    var phi_2508_: type_24;
    var phi_2509_: bool;
    var phi_2513_: type_24;
    var phi_2514_: bool;
    var phi_2515_: type_24;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: type_24;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2528_: type_24;
    var phi_2529_: bool;
    var phi_2533_: type_24;
    var phi_2544_: type_38;
    var phi_2545_: type_38;
    var phi_975_: type_38;
    var phi_4004_: bool;
    var local_10: type_38;
    var phi_4194_: bool;
    var phi_3786_: type_38;
    var phi_3787_: type_45;
    var phi_3788_: bool;
    var phi_3789_: u32;
    var phi_4193_: bool;
    var phi_3790_: type_38;
    var phi_3791_: type_45;
    var phi_3792_: u32;
    var phi_3793_: bool;
    var phi_3794_: u32;
    var phi_4192_: bool;
    var phi_3795_: type_38;
    var phi_3796_: type_45;
    var phi_3797_: u32;
    var phi_3798_: bool;
    var phi_3799_: u32;
    var phi_4191_: bool;
    var phi_848_: type_38;
    var phi_851_: type_45;
    var phi_853_: u32;
    var phi_855_: bool;
    var phi_857_: u32;
    var phi_3800_: bool;
    var phi_4190_: bool;
    var local_11: type_38;
    var local_12: type_38;

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
                            phi_389_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_389_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_389_;
                        phi_390_ = _e243;
                    } else {
                        phi_390_ = 0i;
                    }
                    let _e245 = phi_390_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_400_ = true;
                    } else {
                        phi_400_ = (_e169 == _e201);
                    }
                    let _e249 = phi_400_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_410_ = _e251;
                        phi_411_ = _e251;
                        phi_413_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_410_ = u32();
                        phi_411_ = 0u;
                        phi_413_ = true;
                    }
                    let _e255 = phi_410_;
                    let _e257 = phi_411_;
                    let _e259 = phi_413_;
                    if _e259 {
                        phi_418_ = (_e257 + 1u);
                    } else {
                        phi_418_ = 0u;
                    }
                    let _e263 = phi_418_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_430_ = -126i;
                    } else {
                        phi_430_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_430_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_450_ = -126i;
                    } else {
                        phi_450_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_450_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_4.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_468_ = _e302[0];
                    } else {
                        phi_468_ = _e302[1];
                    }
                    let _e307 = phi_468_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_474_ = _e302[2];
                    } else {
                        phi_474_ = _e307;
                    }
                    let _e311 = phi_474_;
                    let _e313 = ((_e311 * _e275) * _e281);
                    let _e314 = global_4.member[_e150].member_2;
                    if _e303 {
                        phi_485_ = _e314[0];
                    } else {
                        phi_485_ = _e314[1];
                    }
                    let _e318 = phi_485_;
                    if _e308 {
                        phi_491_ = _e314[2];
                    } else {
                        phi_491_ = _e318;
                    }
                    let _e321 = phi_491_;
                    let _e323 = ((_e321 * _e292) * _e298);
                    let _e327 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e327 {
                        let _e331 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) * 0.00000011920929f);
                        phi_514_ = select(0.00000000000011368684f, _e331, (_e331 > 0.00000000000011368684f));
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e335 = phi_514_;
                    let _e336 = (_e313 + _e335);
                    let _e337 = (_e313 - _e335);
                    let _e338 = select(_e323, 0f, _e327);
                    if _e327 {
                        phi_525_ = 38685626000000000000000000f;
                    } else {
                        phi_525_ = (1f / _e323);
                    }
                    let _e341 = phi_525_;
                    let _e342 = (_e263 == 0u);
                    if _e342 {
                        phi_534_ = _e302[0];
                    } else {
                        phi_534_ = _e302[1];
                    }
                    let _e346 = phi_534_;
                    let _e347 = (_e263 == 2u);
                    if _e347 {
                        phi_540_ = _e302[2];
                    } else {
                        phi_540_ = _e346;
                    }
                    let _e350 = phi_540_;
                    let _e352 = ((_e350 * _e275) * _e281);
                    if _e342 {
                        phi_551_ = _e314[0];
                    } else {
                        phi_551_ = _e314[1];
                    }
                    let _e356 = phi_551_;
                    if _e347 {
                        phi_557_ = _e314[2];
                    } else {
                        phi_557_ = _e356;
                    }
                    let _e359 = phi_557_;
                    let _e361 = ((_e359 * _e292) * _e298);
                    let _e365 = (bitcast<f32>((bitcast<u32>(_e361) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e365 {
                        let _e369 = (bitcast<f32>((bitcast<u32>(_e352) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e369, (_e369 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e373 = phi_580_;
                    let _e374 = (_e352 + _e373);
                    let _e375 = (_e352 - _e373);
                    let _e376 = select(_e361, 0f, _e365);
                    if _e365 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e361);
                    }
                    let _e379 = phi_591_;
                    let _e380 = (_e265 == 0u);
                    if _e380 {
                        phi_600_ = _e302[0];
                    } else {
                        phi_600_ = _e302[1];
                    }
                    let _e384 = phi_600_;
                    let _e385 = (_e265 == 2u);
                    if _e385 {
                        phi_606_ = _e302[2];
                    } else {
                        phi_606_ = _e384;
                    }
                    let _e388 = phi_606_;
                    let _e390 = ((_e388 * _e275) * _e281);
                    if _e380 {
                        phi_617_ = _e314[0];
                    } else {
                        phi_617_ = _e314[1];
                    }
                    let _e394 = phi_617_;
                    if _e385 {
                        phi_623_ = _e314[2];
                    } else {
                        phi_623_ = _e394;
                    }
                    let _e397 = phi_623_;
                    let _e399 = ((_e397 * _e292) * _e298);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_646_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_646_ = 0f;
                    }
                    let _e411 = phi_646_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_657_ = 38685626000000000000000000f;
                    } else {
                        phi_657_ = (1f / _e399);
                    }
                    let _e417 = phi_657_;
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
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e458, (_e458 > -340282350000000000000000000000000000000f));
                        phi_758_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_757_ = 0f;
                        phi_758_ = 1f;
                    }
                    let _e462 = phi_757_;
                    let _e464 = phi_758_;
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
                    phi_4010_ = false;
                    phi_847_ = type_38(_e462, false);
                    phi_850_ = type_45(type_28(vec4<f32>((f32(_e471) * _e144), (f32(_e477) * _e144), (f32(_e483) * _e144), 0f), vec4<f32>((f32(_e488) * _e144), (f32(_e492) * _e144), (f32(_e496) * _e144), 0f)), select(0u, 2147483648u, (_e93 == 0u)));
                    phi_852_ = ((3u * _e93) + 1u);
                    phi_854_ = (_e464 <= _e462);
                    phi_856_ = 0u;
                    loop {
                        let _e506 = phi_4010_;
                        let _e508 = phi_847_;
                        let _e510 = phi_850_;
                        let _e512 = phi_852_;
                        let _e514 = phi_854_;
                        let _e516 = phi_856_;
                        local_11 = _e508;
                        if _e514 {
                            phi_867_ = true;
                        } else {
                            phi_867_ = (_e516 > 0u);
                        }
                        let _e519 = phi_867_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_953_ = _e510;
                                    phi_954_ = _e514;
                                    phi_955_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4190_ = true;
                                        break;
                                    }
                                    let _e543 = local_9[_e522];
                                    phi_953_ = type_45(type_28(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_954_ = (_e543 <= _e508.member);
                                    phi_955_ = _e521;
                                }
                                let _e547 = phi_953_;
                                let _e549 = phi_954_;
                                let _e551 = phi_955_;
                                if _e549 {
                                    let _e556 = (_e547.member_1 & 268435455u);
                                    if ((_e547.member_1 & 2147483648u) != 0u) {
                                        phi_974_ = _e508;
                                        phi_977_ = type_8(0u, ((_e547.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1016 = phi_974_;
                                            let _e1018 = phi_977_;
                                            local_10 = _e1016;
                                            local_12 = _e1016;
                                            if (_e1018.member < _e1018.member_1) {
                                                phi_978_ = type_8((_e1018.member + 1u), _e1018.member_1);
                                                phi_1000_ = type_8(1u, _e1018.member);
                                            } else {
                                                phi_978_ = _e1018;
                                                phi_1000_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1031 = phi_978_;
                                            let _e1033 = phi_1000_;
                                            let _e1037 = (bitcast<i32>(_e1033.member) != 0i);
                                            if _e1037 {
                                                let _e1042 = (_e547.member.member_1.x - _e547.member.member.x);
                                                let _e1045 = (_e547.member.member_1.y - _e547.member.member.y);
                                                let _e1048 = (_e547.member.member_1.z - _e547.member.member.z);
                                                let _e1050 = select(_e1045, _e1042, (_e1042 > _e1045));
                                                let _e1052 = select(_e1048, _e1050, (_e1050 > _e1048));
                                                let _e1054 = (_e1052 < (1024f * _e144));
                                                if _e1054 {
                                                    phi_1041_ = 0u;
                                                } else {
                                                    phi_1041_ = select(2u, 1u, (_e1052 < (2097152f * _e144)));
                                                }
                                                let _e1059 = phi_1041_;
                                                switch bitcast<i32>(_e1059) {
                                                    case 0: {
                                                        phi_1047_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1047_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1047_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1047_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1062 = phi_1047_;
                                                switch bitcast<i32>(_e1059) {
                                                    case 0: {
                                                        phi_1057_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1057_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1057_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1057_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1069 = phi_1057_;
                                                let _e1071 = ((_e556 + (_e1033.member_1 * ((3u * _e1062) + 1u))) + (3u * _e1069));
                                                let _e1072 = (_e1071 < _e96);
                                                if _e1072 {
                                                    if _e1072 {
                                                    } else {
                                                        phi_4004_ = true;
                                                        break;
                                                    }
                                                    let _e1074 = global_6.member[_e1071];
                                                    phi_1073_ = _e1074;
                                                } else {
                                                    phi_1073_ = 4294967295u;
                                                }
                                                let _e1076 = phi_1073_;
                                                if _e1054 {
                                                    phi_1106_ = 0u;
                                                } else {
                                                    phi_1106_ = select(2u, 1u, (_e1052 < (2097152f * _e144)));
                                                }
                                                let _e1081 = phi_1106_;
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        phi_1112_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1112_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1112_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1112_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1084 = phi_1112_;
                                                let _e1088 = (_e556 + (_e1033.member_1 * ((3u * _e1084) + 1u)));
                                                switch bitcast<i32>(_e1081) {
                                                    case 0: {
                                                        let _e1354 = (_e1088 < _e96);
                                                        if _e1354 {
                                                            if _e1354 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1356 = global_6.member[_e1088];
                                                            phi_1136_ = _e1356;
                                                        } else {
                                                            phi_1136_ = 0u;
                                                        }
                                                        let _e1358 = phi_1136_;
                                                        let _e1360 = ((10u * _e264) & 31u);
                                                        let _e1369 = ((10u * _e263) & 31u);
                                                        let _e1378 = ((10u * _e265) & 31u);
                                                        let _e1387 = (_e1088 + 1u);
                                                        let _e1388 = (_e1387 < _e96);
                                                        if _e1388 {
                                                            if _e1388 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1390 = global_6.member[_e1387];
                                                            phi_1179_ = _e1390;
                                                        } else {
                                                            phi_1179_ = 0u;
                                                        }
                                                        let _e1392 = phi_1179_;
                                                        let _e1415 = (_e1088 + 2u);
                                                        let _e1416 = (_e1415 < _e96);
                                                        if _e1416 {
                                                            if _e1416 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1418 = global_6.member[_e1415];
                                                            phi_1222_ = _e1418;
                                                        } else {
                                                            phi_1222_ = 0u;
                                                        }
                                                        let _e1420 = phi_1222_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1360)) & 1023u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1369)) & 1023u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>(((_e1358 >> bitcast<u32>(_e1378)) & 1023u))) * _e144))), array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1360)) & 1023u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1369)) & 1023u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>(((_e1392 >> bitcast<u32>(_e1378)) & 1023u))) * _e144))), array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1360)) & 1023u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1369)) & 1023u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1378)) & 1023u))) * _e144))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1177 = (_e1088 < _e96);
                                                        if _e1177 {
                                                            if _e1177 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1179 = global_6.member[_e1088];
                                                            phi_1265_ = _e1179;
                                                        } else {
                                                            phi_1265_ = 0u;
                                                        }
                                                        let _e1181 = phi_1265_;
                                                        let _e1182 = (_e1088 + 1u);
                                                        let _e1183 = (_e1182 < _e96);
                                                        if _e1183 {
                                                            if _e1183 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1185 = global_6.member[_e1182];
                                                            phi_1280_ = _e1185;
                                                        } else {
                                                            phi_1280_ = 0u;
                                                        }
                                                        let _e1187 = phi_1280_;
                                                        let _e1188 = (_e264 == 1u);
                                                        if _e1188 {
                                                            phi_1290_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1290_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1197 = phi_1290_;
                                                        let _e1204 = (_e263 == 1u);
                                                        if _e1204 {
                                                            phi_1310_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1310_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1213 = phi_1310_;
                                                        let _e1220 = (_e265 == 1u);
                                                        if _e1220 {
                                                            phi_1330_ = ((_e1181 >> bitcast<u32>(21i)) | (_e1187 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1330_ = (_e1187 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1229 = phi_1330_;
                                                        let _e1237 = (_e1088 + 2u);
                                                        let _e1238 = (_e1237 < _e96);
                                                        if _e1238 {
                                                            if _e1238 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1240 = global_6.member[_e1237];
                                                            phi_1356_ = _e1240;
                                                        } else {
                                                            phi_1356_ = 0u;
                                                        }
                                                        let _e1242 = phi_1356_;
                                                        let _e1243 = (_e1088 + 3u);
                                                        let _e1244 = (_e1243 < _e96);
                                                        if _e1244 {
                                                            if _e1244 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1246 = global_6.member[_e1243];
                                                            phi_1371_ = _e1246;
                                                        } else {
                                                            phi_1371_ = 0u;
                                                        }
                                                        let _e1248 = phi_1371_;
                                                        if _e1188 {
                                                            phi_1381_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1381_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1257 = phi_1381_;
                                                        if _e1204 {
                                                            phi_1401_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1401_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1272 = phi_1401_;
                                                        if _e1220 {
                                                            phi_1421_ = ((_e1242 >> bitcast<u32>(21i)) | (_e1248 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1421_ = (_e1248 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1287 = phi_1421_;
                                                        let _e1295 = (_e1088 + 4u);
                                                        let _e1296 = (_e1295 < _e96);
                                                        if _e1296 {
                                                            if _e1296 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1298 = global_6.member[_e1295];
                                                            phi_1447_ = _e1298;
                                                        } else {
                                                            phi_1447_ = 0u;
                                                        }
                                                        let _e1300 = phi_1447_;
                                                        let _e1301 = (_e1088 + 5u);
                                                        let _e1302 = (_e1301 < _e96);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_6.member[_e1301];
                                                            phi_1462_ = _e1304;
                                                        } else {
                                                            phi_1462_ = 0u;
                                                        }
                                                        let _e1306 = phi_1462_;
                                                        if _e1188 {
                                                            phi_1472_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1472_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1315 = phi_1472_;
                                                        if _e1204 {
                                                            phi_1492_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1492_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1330 = phi_1492_;
                                                        if _e1220 {
                                                            phi_1512_ = ((_e1300 >> bitcast<u32>(21i)) | (_e1306 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1512_ = (_e1306 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1345 = phi_1512_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>((select(_e1197, _e1181, _e303) & 2097151u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>((select(_e1213, _e1181, _e342) & 2097151u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>((select(_e1229, _e1181, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>((select(_e1257, _e1242, _e303) & 2097151u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>((select(_e1272, _e1242, _e342) & 2097151u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>((select(_e1287, _e1242, _e380) & 2097151u))) * _e144))), array<f32, 3>((_e547.member.member.x + (f32(bitcast<i32>((select(_e1315, _e1300, _e303) & 2097151u))) * _e144)), (_e547.member.member.y + (f32(bitcast<i32>((select(_e1330, _e1300, _e342) & 2097151u))) * _e144)), (_e547.member.member.z + (f32(bitcast<i32>((select(_e1345, _e1300, _e380) & 2097151u))) * _e144))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1090 = (_e1088 + _e264);
                                                        let _e1091 = (_e1090 < _e96);
                                                        if _e1091 {
                                                            if _e1091 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1093 = global_6.member[_e1090];
                                                            phi_1539_ = _e1093;
                                                        } else {
                                                            phi_1539_ = 0u;
                                                        }
                                                        let _e1095 = phi_1539_;
                                                        let _e1099 = (_e1088 + _e263);
                                                        let _e1100 = (_e1099 < _e96);
                                                        if _e1100 {
                                                            if _e1100 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1102 = global_6.member[_e1099];
                                                            phi_1557_ = _e1102;
                                                        } else {
                                                            phi_1557_ = 0u;
                                                        }
                                                        let _e1104 = phi_1557_;
                                                        let _e1108 = (_e1088 + _e265);
                                                        let _e1109 = (_e1108 < _e96);
                                                        if _e1109 {
                                                            if _e1109 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1111 = global_6.member[_e1108];
                                                            phi_1575_ = _e1111;
                                                        } else {
                                                            phi_1575_ = 0u;
                                                        }
                                                        let _e1113 = phi_1575_;
                                                        let _e1118 = (_e1088 + 3u);
                                                        let _e1119 = (_e1118 + _e264);
                                                        let _e1120 = (_e1119 < _e96);
                                                        if _e1120 {
                                                            if _e1120 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1122 = global_6.member[_e1119];
                                                            phi_1595_ = _e1122;
                                                        } else {
                                                            phi_1595_ = 0u;
                                                        }
                                                        let _e1124 = phi_1595_;
                                                        let _e1128 = (_e1118 + _e263);
                                                        let _e1129 = (_e1128 < _e96);
                                                        if _e1129 {
                                                            if _e1129 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1131 = global_6.member[_e1128];
                                                            phi_1613_ = _e1131;
                                                        } else {
                                                            phi_1613_ = 0u;
                                                        }
                                                        let _e1133 = phi_1613_;
                                                        let _e1137 = (_e1118 + _e265);
                                                        let _e1138 = (_e1137 < _e96);
                                                        if _e1138 {
                                                            if _e1138 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1140 = global_6.member[_e1137];
                                                            phi_1631_ = _e1140;
                                                        } else {
                                                            phi_1631_ = 0u;
                                                        }
                                                        let _e1142 = phi_1631_;
                                                        let _e1147 = (_e1088 + 6u);
                                                        let _e1148 = (_e1147 + _e264);
                                                        let _e1149 = (_e1148 < _e96);
                                                        if _e1149 {
                                                            if _e1149 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1151 = global_6.member[_e1148];
                                                            phi_1651_ = _e1151;
                                                        } else {
                                                            phi_1651_ = 0u;
                                                        }
                                                        let _e1153 = phi_1651_;
                                                        let _e1157 = (_e1147 + _e263);
                                                        let _e1158 = (_e1157 < _e96);
                                                        if _e1158 {
                                                            if _e1158 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1160 = global_6.member[_e1157];
                                                            phi_1669_ = _e1160;
                                                        } else {
                                                            phi_1669_ = 0u;
                                                        }
                                                        let _e1162 = phi_1669_;
                                                        let _e1166 = (_e1147 + _e265);
                                                        let _e1167 = (_e1166 < _e96);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_4004_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_6.member[_e1166];
                                                            phi_1687_ = _e1169;
                                                        } else {
                                                            phi_1687_ = 0u;
                                                        }
                                                        let _e1171 = phi_1687_;
                                                        phi_1693_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1095)) * _e144), (f32(bitcast<i32>(_e1104)) * _e144), (f32(bitcast<i32>(_e1113)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1124)) * _e144), (f32(bitcast<i32>(_e1133)) * _e144), (f32(bitcast<i32>(_e1142)) * _e144)), array<f32, 3>((f32(bitcast<i32>(_e1153)) * _e144), (f32(bitcast<i32>(_e1162)) * _e144), (f32(bitcast<i32>(_e1171)) * _e144)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1693_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1445 = phi_1693_;
                                                let _e1453 = (_e1445[0][2] - _e390);
                                                let _e1456 = (((_e1445[0][0] - _e313) * _e414) - (_e1453 * _e338));
                                                let _e1459 = (((_e1445[0][1] - _e352) * _e414) - (_e1453 * _e376));
                                                let _e1466 = (_e1445[1][2] - _e390);
                                                let _e1469 = (((_e1445[1][0] - _e313) * _e414) - (_e1466 * _e338));
                                                let _e1472 = (((_e1445[1][1] - _e352) * _e414) - (_e1466 * _e376));
                                                let _e1479 = (_e1445[2][2] - _e390);
                                                let _e1482 = (((_e1445[2][0] - _e313) * _e414) - (_e1479 * _e338));
                                                let _e1485 = (((_e1445[2][1] - _e352) * _e414) - (_e1479 * _e376));
                                                let _e1486 = (_e1482 * _e1472);
                                                let _e1487 = (_e1485 * _e1469);
                                                let _e1488 = (_e1456 * _e1485);
                                                let _e1489 = (_e1459 * _e1482);
                                                let _e1490 = (_e1469 * _e1459);
                                                let _e1491 = (_e1472 * _e1456);
                                                let _e1496 = (((_e1486 >= _e1487) && (_e1488 >= _e1489)) && (_e1490 >= _e1491));
                                                if (_e1496 || (((_e1486 <= _e1487) && (_e1488 <= _e1489)) && (_e1490 <= _e1491))) {
                                                    let _e1503 = select(-1f, 1f, _e1496);
                                                    let _e1505 = ((_e1486 - _e1487) * _e1503);
                                                    let _e1507 = select(0f, _e1505, (_e1505 > 0f));
                                                    let _e1509 = ((_e1488 - _e1489) * _e1503);
                                                    let _e1511 = select(0f, _e1509, (_e1509 > 0f));
                                                    let _e1513 = ((_e1490 - _e1491) * _e1503);
                                                    let _e1515 = select(0f, _e1513, (_e1513 > 0f));
                                                    let _e1517 = ((_e1507 + _e1511) + _e1515);
                                                    if (_e1517 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2518_ = type_24();
                                                        phi_2519_ = true;
                                                        phi_2520_ = false;
                                                    } else {
                                                        let _e1520 = select(_e1469, _e1456, (_e1456 < _e1469));
                                                        if (select(_e1482, _e1520, (_e1520 < _e1482)) > 0f) {
                                                            phi_1810_ = true;
                                                        } else {
                                                            let _e1525 = select(_e1469, _e1456, (_e1456 > _e1469));
                                                            phi_1810_ = (select(_e1482, _e1525, (_e1525 > _e1482)) < 0f);
                                                        }
                                                        let _e1530 = phi_1810_;
                                                        if _e1530 {
                                                            phi_2515_ = type_24();
                                                            phi_2516_ = true;
                                                            phi_2517_ = false;
                                                        } else {
                                                            let _e1532 = select(_e1472, _e1459, (_e1459 < _e1472));
                                                            if (select(_e1485, _e1532, (_e1532 < _e1485)) > 0f) {
                                                                phi_1839_ = true;
                                                            } else {
                                                                let _e1537 = select(_e1472, _e1459, (_e1459 > _e1472));
                                                                phi_1839_ = (select(_e1485, _e1537, (_e1537 > _e1485)) < 0f);
                                                            }
                                                            let _e1542 = phi_1839_;
                                                            if _e1542 {
                                                                phi_2513_ = type_24();
                                                                phi_2514_ = false;
                                                            } else {
                                                                let _e1544 = select(_e1445[1][0], _e1445[0][0], (_e1445[0][0] < _e1445[1][0]));
                                                                let _e1548 = select(_e1445[1][0], _e1445[0][0], (_e1445[0][0] > _e1445[1][0]));
                                                                let _e1552 = select(_e1445[1][1], _e1445[0][1], (_e1445[0][1] < _e1445[1][1]));
                                                                let _e1556 = select(_e1445[1][1], _e1445[0][1], (_e1445[0][1] > _e1445[1][1]));
                                                                let _e1560 = select(_e1445[1][2], _e1445[0][2], (_e1445[0][2] < _e1445[1][2]));
                                                                let _e1564 = select(_e1445[1][2], _e1445[0][2], (_e1445[0][2] > _e1445[1][2]));
                                                                let _e1569 = ((select(_e1445[2][0], _e1544, (_e1544 < _e1445[2][0])) - _e336) * _e341);
                                                                let _e1570 = ((select(_e1445[2][0], _e1548, (_e1548 > _e1445[2][0])) - _e337) * _e341);
                                                                let _e1573 = ((select(_e1445[2][1], _e1552, (_e1552 < _e1445[2][1])) - _e374) * _e379);
                                                                let _e1574 = ((select(_e1445[2][1], _e1556, (_e1556 > _e1445[2][1])) - _e375) * _e379);
                                                                let _e1577 = ((select(_e1445[2][2], _e1560, (_e1560 < _e1445[2][2])) - _e412) * _e417);
                                                                let _e1578 = ((select(_e1445[2][2], _e1564, (_e1564 > _e1445[2][2])) - _e413) * _e417);
                                                                let _e1580 = select(_e1578, _e1577, (_e1577 < _e1578));
                                                                let _e1582 = select(_e1578, _e1577, (_e1577 > _e1578));
                                                                let _e1584 = select(_e1570, _e1569, (_e1569 < _e1570));
                                                                let _e1586 = select(_e1574, _e1573, (_e1573 < _e1574));
                                                                let _e1588 = select(_e1586, _e1584, (_e1584 > _e1586));
                                                                let _e1590 = select(_e1580, _e1588, (_e1588 > _e1580));
                                                                let _e1592 = select(_e1570, _e1569, (_e1569 > _e1570));
                                                                let _e1594 = select(_e1574, _e1573, (_e1573 > _e1574));
                                                                let _e1596 = select(_e1594, _e1592, (_e1592 < _e1594));
                                                                let _e1598 = select(_e1582, _e1596, (_e1596 < _e1582));
                                                                let _e1599 = -(_e1580);
                                                                let _e1605 = select(_e464, _e1590, (_e1590 > _e464));
                                                                if (_e1605 > (_e1598 + (select(_e1599, _e1582, (_e1582 > _e1599)) * 0.0000019073523f))) {
                                                                    phi_2508_ = type_24();
                                                                    phi_2509_ = true;
                                                                } else {
                                                                    let _e1607 = (_e1605 > _e1016.member);
                                                                    if _e1607 {
                                                                        phi_2507_ = type_24();
                                                                    } else {
                                                                        let _e1608 = vec3<f32>(_e1445[0][0], _e1445[0][1], _e1445[0][2]);
                                                                        let _e1609 = vec3<f32>(_e1445[1][0], _e1445[1][1], _e1445[1][2]);
                                                                        let _e1610 = vec3<f32>(_e1445[2][0], _e1445[2][1], _e1445[2][2]);
                                                                        let _e1611 = (_e1445[1][0] - _e1445[0][0]);
                                                                        let _e1612 = (_e1445[1][1] - _e1445[0][1]);
                                                                        let _e1613 = (_e1445[1][2] - _e1445[0][2]);
                                                                        let _e1614 = vec3<f32>(_e1611, _e1612, _e1613);
                                                                        let _e1615 = (_e1445[2][0] - _e1445[1][0]);
                                                                        let _e1616 = (_e1445[2][1] - _e1445[1][1]);
                                                                        let _e1617 = (_e1445[2][2] - _e1445[1][2]);
                                                                        let _e1618 = vec3<f32>(_e1615, _e1616, _e1617);
                                                                        let _e1619 = (_e1445[0][0] - _e1445[2][0]);
                                                                        let _e1620 = (_e1445[0][1] - _e1445[2][1]);
                                                                        let _e1621 = (_e1445[0][2] - _e1445[2][2]);
                                                                        let _e1622 = vec3<f32>(_e1619, _e1620, _e1621);
                                                                        let _e1625 = bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u));
                                                                        let _e1628 = bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u));
                                                                        let _e1630 = select(_e1628, _e1625, (_e1625 > _e1628));
                                                                        let _e1633 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                                        let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                                        let _e1638 = bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u));
                                                                        let _e1641 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                        let _e1643 = select(_e1641, _e1638, (_e1638 > _e1641));
                                                                        let _e1646 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                        let _e1648 = select(_e1646, _e1643, (_e1643 > _e1646));
                                                                        let _e1651 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                                        let _e1654 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                        let _e1656 = select(_e1654, _e1651, (_e1651 > _e1654));
                                                                        let _e1659 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                        let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                        let _e1663 = select(_e1648, _e1635, (_e1635 > _e1648));
                                                                        let _e1665 = select(_e1661, _e1663, (_e1663 > _e1661));
                                                                        if (_e1635 == _e1665) {
                                                                            phi_2240_ = _e1472;
                                                                            phi_2241_ = _e1469;
                                                                            phi_2242_ = _e1459;
                                                                            phi_2243_ = _e1456;
                                                                            phi_2244_ = _e1608;
                                                                            phi_2245_ = _e1622;
                                                                            phi_2246_ = _e1618;
                                                                            phi_2247_ = _e1614;
                                                                        } else {
                                                                            let _e1667 = (_e1648 == _e1665);
                                                                            let _e1672 = vec3(_e1667);
                                                                            phi_2240_ = select(_e1459, _e1485, _e1667);
                                                                            phi_2241_ = select(_e1456, _e1482, _e1667);
                                                                            phi_2242_ = select(_e1485, _e1472, _e1667);
                                                                            phi_2243_ = select(_e1482, _e1469, _e1667);
                                                                            phi_2244_ = select(_e1610, _e1609, _e1672);
                                                                            phi_2245_ = select(_e1618, _e1614, _e1672);
                                                                            phi_2246_ = select(_e1614, _e1622, _e1672);
                                                                            phi_2247_ = select(_e1622, _e1618, _e1672);
                                                                        }
                                                                        let _e1678 = phi_2240_;
                                                                        let _e1680 = phi_2241_;
                                                                        let _e1682 = phi_2242_;
                                                                        let _e1684 = phi_2243_;
                                                                        let _e1686 = phi_2244_;
                                                                        let _e1688 = phi_2245_;
                                                                        let _e1690 = phi_2246_;
                                                                        let _e1692 = phi_2247_;
                                                                        let _e1699 = ((_e1690.y * _e1688.z) - (_e1688.y * _e1690.z));
                                                                        let _e1704 = ((_e1690.z * _e1688.x) - (_e1688.z * _e1690.x));
                                                                        let _e1707 = ((_e1690.x * _e1688.y) - (_e1688.x * _e1690.y));
                                                                        if (_e1507 >= _e1511) {
                                                                            phi_2278_ = select(true, false, (_e1507 >= _e1515));
                                                                        } else {
                                                                            phi_2278_ = true;
                                                                        }
                                                                        let _e1712 = phi_2278_;
                                                                        if _e1712 {
                                                                            phi_2287_ = select(_e1610, _e1609, vec3((_e1511 >= _e1515)));
                                                                        } else {
                                                                            phi_2287_ = _e1608;
                                                                        }
                                                                        let _e1717 = phi_2287_;
                                                                        let _e1728 = (((_e1699 * (_e1717.x - _e313)) + (_e1704 * (_e1717.y - _e352))) + (_e1707 * (_e1717.z - _e390)));
                                                                        let _e1733 = (((_e1699 * _e338) + (_e1704 * _e376)) + (_e1707 * _e414));
                                                                        let _e1734 = (_e1680 - _e1684);
                                                                        let _e1735 = (_e1678 - _e1682);
                                                                        let _e1743 = (-(((_e1684 * _e1734) + (_e1682 * _e1735))) / ((_e1734 * _e1734) + (_e1735 * _e1735)));
                                                                        let _e1745 = select(1f, _e1743, (_e1743 < 1f));
                                                                        let _e1747 = select(0f, _e1745, (_e1745 > 0f));
                                                                        let _e1760 = ((_e1686.x + (_e1692.x * _e1747)) - _e313);
                                                                        let _e1761 = ((_e1686.y + (_e1692.y * _e1747)) - _e352);
                                                                        let _e1762 = ((_e1686.z + (_e1692.z * _e1747)) - _e390);
                                                                        let _e1763 = (_e1762 / _e414);
                                                                        let _e1775 = bitcast<f32>((bitcast<u32>(_e1760) & 2147483647u));
                                                                        let _e1778 = bitcast<f32>((bitcast<u32>(_e1761) & 2147483647u));
                                                                        let _e1780 = select(_e1778, _e1775, (_e1775 > _e1778));
                                                                        let _e1783 = bitcast<f32>((bitcast<u32>(_e1762) & 2147483647u));
                                                                        let _e1785 = select(_e1783, _e1780, (_e1780 > _e1783));
                                                                        let _e1791 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                                        let _e1794 = bitcast<f32>((bitcast<u32>(_e1704) & 2147483647u));
                                                                        let _e1796 = select(_e1794, _e1791, (_e1791 > _e1794));
                                                                        let _e1799 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1699 * _e1760) + (_e1704 * _e1761)) + (_e1707 * _e1762)) - _e1728)) & 2147483647u)) <= ((0.0000009536743f * select(_e1665, _e1785, (_e1785 > _e1665))) * select(_e1799, _e1796, (_e1796 > _e1799)))) {
                                                                            let _e1809 = bitcast<f32>((bitcast<u32>(_e1690.x) & 2147483647u));
                                                                            let _e1812 = bitcast<f32>((bitcast<u32>(_e1690.y) & 2147483647u));
                                                                            let _e1814 = select(_e1812, _e1809, (_e1809 > _e1812));
                                                                            let _e1817 = bitcast<f32>((bitcast<u32>(_e1690.z) & 2147483647u));
                                                                            let _e1823 = bitcast<f32>((bitcast<u32>(_e1688.x) & 2147483647u));
                                                                            let _e1826 = bitcast<f32>((bitcast<u32>(_e1688.y) & 2147483647u));
                                                                            let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                                            let _e1831 = bitcast<f32>((bitcast<u32>(_e1688.z) & 2147483647u));
                                                                            let _e1835 = (bitcast<f32>((bitcast<u32>(_e1733) & 2147483647u)) > ((0.0000038146973f * select(_e1817, _e1814, (_e1814 > _e1817))) * select(_e1831, _e1828, (_e1828 > _e1831))));
                                                                            if _e1835 {
                                                                                phi_2452_ = (_e1728 / _e1733);
                                                                            } else {
                                                                                phi_2452_ = f32();
                                                                            }
                                                                            let _e1838 = phi_2452_;
                                                                            phi_2454_ = _e1838;
                                                                            phi_2455_ = select(true, false, _e1835);
                                                                        } else {
                                                                            phi_2454_ = f32();
                                                                            phi_2455_ = true;
                                                                        }
                                                                        let _e1841 = phi_2454_;
                                                                        let _e1843 = phi_2455_;
                                                                        if _e1843 {
                                                                            let _e1851 = (((_e1699 * (_e1760 - (_e338 * _e1763))) + (_e1704 * (_e1761 - (_e376 * _e1763)))) / _e1733);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u)) <= _e1665) {
                                                                                phi_2475_ = (_e1763 + _e1851);
                                                                            } else {
                                                                                phi_2475_ = _e1763;
                                                                            }
                                                                            let _e1858 = phi_2475_;
                                                                            phi_2476_ = _e1858;
                                                                        } else {
                                                                            phi_2476_ = _e1841;
                                                                        }
                                                                        let _e1860 = phi_2476_;
                                                                        let _e1862 = select(_e1598, _e1860, (_e1860 < _e1598));
                                                                        let _e1864 = select(_e1590, _e1862, (_e1862 > _e1590));
                                                                        if (_e1864 >= _e464) {
                                                                            let _e1866 = (_e1864 <= _e1016.member);
                                                                            if _e1866 {
                                                                                let _e1867 = (1f / _e1517);
                                                                                phi_2499_ = type_24(_e1864, (_e1511 * _e1867), (_e1515 * _e1867), _e1076);
                                                                            } else {
                                                                                phi_2499_ = type_24();
                                                                            }
                                                                            let _e1872 = phi_2499_;
                                                                            phi_2501_ = _e1872;
                                                                            phi_2502_ = select(true, false, _e1866);
                                                                        } else {
                                                                            phi_2501_ = type_24();
                                                                            phi_2502_ = true;
                                                                        }
                                                                        let _e1875 = phi_2501_;
                                                                        let _e1877 = phi_2502_;
                                                                        if _e1877 {
                                                                            phi_2506_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2506_ = _e1875;
                                                                        }
                                                                        let _e1879 = phi_2506_;
                                                                        phi_2507_ = _e1879;
                                                                    }
                                                                    let _e1881 = phi_2507_;
                                                                    phi_2508_ = _e1881;
                                                                    phi_2509_ = _e1607;
                                                                }
                                                                let _e1883 = phi_2508_;
                                                                let _e1885 = phi_2509_;
                                                                phi_2513_ = _e1883;
                                                                phi_2514_ = _e1885;
                                                            }
                                                            let _e1887 = phi_2513_;
                                                            let _e1889 = phi_2514_;
                                                            phi_2515_ = _e1887;
                                                            phi_2516_ = _e1542;
                                                            phi_2517_ = _e1889;
                                                        }
                                                        let _e1891 = phi_2515_;
                                                        let _e1893 = phi_2516_;
                                                        let _e1895 = phi_2517_;
                                                        phi_2518_ = _e1891;
                                                        phi_2519_ = _e1893;
                                                        phi_2520_ = _e1895;
                                                    }
                                                    let _e1897 = phi_2518_;
                                                    let _e1899 = phi_2519_;
                                                    let _e1901 = phi_2520_;
                                                    phi_2528_ = _e1897;
                                                    phi_2529_ = select(_e1901, true, _e1899);
                                                } else {
                                                    phi_2528_ = type_24();
                                                    phi_2529_ = true;
                                                }
                                                let _e1904 = phi_2528_;
                                                let _e1906 = phi_2529_;
                                                if _e1906 {
                                                    phi_2533_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2533_ = _e1904;
                                                }
                                                let _e1908 = phi_2533_;
                                                if (_e1908.member_3 != 4294967295u) {
                                                    if (_e1076 != 4294967295u) {
                                                        phi_2544_ = type_38(_e1016.member, true);
                                                    } else {
                                                        phi_2544_ = _e1016;
                                                    }
                                                    let _e1916 = phi_2544_;
                                                    phi_2545_ = _e1916;
                                                } else {
                                                    phi_2545_ = _e1016;
                                                }
                                                let _e1918 = phi_2545_;
                                                phi_975_ = _e1918;
                                            } else {
                                                phi_975_ = type_38();
                                            }
                                            let _e1920 = phi_975_;
                                            continue;
                                            continuing {
                                                phi_974_ = _e1920;
                                                phi_977_ = _e1031;
                                                phi_4004_ = _e506;
                                                break if !(_e1037);
                                            }
                                        }
                                        let _e1923 = phi_4004_;
                                        phi_4190_ = _e1923;
                                        if _e1923 {
                                            break;
                                        }
                                        let _e1925 = local_10;
                                        phi_4194_ = _e1923;
                                        let _e2125 = local_12;
                                        phi_3786_ = _e2125;
                                        phi_3787_ = _e547;
                                        phi_3788_ = false;
                                        phi_3789_ = select(_e551, 0u, _e1925.member_1);
                                    } else {
                                        if (_e547.member_1 >= _e93) {
                                            phi_3342_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e547.member_1 < _e93) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e564 = ((1u + _e264) % 4u);
                                            if (_e564 < 4u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e569 = global_3.member[_e547.member_1][_e564];
                                            let _e571 = (_e569 >> bitcast<u32>(11u));
                                            let _e573 = ((1u + _e263) % 4u);
                                            if (_e573 < 4u) {
                                            } else {
                                                phi_4190_ = true;
                                                break;
                                            }
                                            let _e578 = global_3.member[_e547.member_1][_e573];
                                            let _e580 = (_e578 >> bitcast<u32>(11u));
                                            let _e582 = ((1u + _e265) % 4u);
                                            if (_e582 < 4u) {
                                            } else {
                                                phi_4190_ = true;
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
                                                phi_3043_ = 0u;
                                            } else {
                                                phi_3043_ = select(2u, 1u, (_e755 < (2097152f * _e144)));
                                            }
                                            let _e762 = phi_3043_;
                                            switch bitcast<i32>(_e762) {
                                                case 0: {
                                                    phi_3049_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3049_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3049_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3049_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e765 = phi_3049_;
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
                                                phi_3304_ = _e796;
                                            } else {
                                                if (_e800 == 7u) {
                                                    phi_3303_ = 2147483648u;
                                                } else {
                                                    phi_3303_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (_e797 & 268435455u));
                                                }
                                                let _e818 = phi_3303_;
                                                phi_3304_ = _e818;
                                            }
                                            let _e820 = phi_3304_;
                                            if _e809 {
                                                let _e821 = (_e800 != 7u);
                                                if _e821 {
                                                    phi_3314_ = (_e797 + (_e800 * ((3u * _e765) + 1u)));
                                                } else {
                                                    phi_3314_ = u32();
                                                }
                                                let _e825 = phi_3314_;
                                                phi_3316_ = _e825;
                                                phi_3317_ = select(true, false, _e821);
                                            } else {
                                                phi_3316_ = u32();
                                                phi_3317_ = true;
                                            }
                                            let _e828 = phi_3316_;
                                            let _e830 = phi_3317_;
                                            if (_e808 == 0u) {
                                                phi_3338_ = (_e796 + select(0u, 1u, !(_e809)));
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_3337_ = 2147483648u;
                                                } else {
                                                    phi_3337_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (select(_e828, _e797, _e830) & 268435455u));
                                                }
                                                let _e843 = phi_3337_;
                                                phi_3338_ = _e843;
                                            }
                                            let _e845 = phi_3338_;
                                            phi_3342_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e723, (_e547.member.member.x + _e675), _e728, (_e547.member.member_1.x - _e714)), vec4<f32>(_e724, (_e547.member.member.y + _e679), _e729, (_e547.member.member_1.y - _e718)), vec4<f32>(_e725, (_e547.member.member.z + _e683), _e730, (_e547.member.member_1.z - _e722))), type_45(type_28((_e547.member.member + vec4<f32>(_e653, _e662, _e671, 0f)), (_e547.member.member_1 - vec4<f32>(_e692, _e701, _e710, 0f))), _e820), type_45(type_28((_e547.member.member + vec4<f32>(_e675, _e679, _e683, 0f)), (_e547.member.member_1 - vec4<f32>(_e714, _e718, _e722, 0f))), _e845));
                                        }
                                        let _e850 = phi_3342_;
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
                                        let _e950 = (_e943 <= select(_e508.member, _e940, (_e940 < _e508.member)));
                                        let _e951 = (_e945 <= select(_e508.member, _e941, (_e941 < _e508.member)));
                                        let _e952 = (_e943 <= _e945);
                                        if _e950 {
                                            if _e951 {
                                                if _e952 {
                                                    phi_3686_ = _e850.member_2;
                                                } else {
                                                    phi_3686_ = _e850.member_1;
                                                }
                                                let _e956 = phi_3686_;
                                                let _e978 = (_e551 % 128u);
                                                let _e979 = (_e978 < 128u);
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_8[_e978] = _e956.member_1;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_7[_e978] = _e956.member.member.x;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_6[_e978] = _e956.member.member.y;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_5[_e978] = _e956.member.member.z;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_4[_e978] = _e956.member.member_1.x;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_3[_e978] = _e956.member.member_1.y;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_2[_e978] = _e956.member.member_1.z;
                                                if _e979 {
                                                } else {
                                                    phi_4190_ = true;
                                                    break;
                                                }
                                                local_9[_e978] = select(_e945, _e943, (_e943 > _e945));
                                                if _e952 {
                                                    phi_3763_ = _e850.member_1;
                                                } else {
                                                    phi_3763_ = _e850.member_2;
                                                }
                                                let _e992 = phi_3763_;
                                                phi_3764_ = _e992;
                                                phi_3765_ = (_e551 + 1u);
                                            } else {
                                                phi_3764_ = type_45();
                                                phi_3765_ = u32();
                                            }
                                            let _e994 = phi_3764_;
                                            let _e996 = phi_3765_;
                                            phi_3767_ = _e994;
                                            phi_3768_ = _e996;
                                            phi_3769_ = select(true, false, _e951);
                                        } else {
                                            phi_3767_ = type_45();
                                            phi_3768_ = u32();
                                            phi_3769_ = true;
                                        }
                                        let _e999 = phi_3767_;
                                        let _e1001 = phi_3768_;
                                        let _e1003 = phi_3769_;
                                        if _e1003 {
                                            if _e950 {
                                                phi_3778_ = _e850.member_1;
                                            } else {
                                                phi_3778_ = _e850.member_2;
                                            }
                                            let _e1007 = phi_3778_;
                                            phi_3783_ = _e1007;
                                            phi_3784_ = select(_e951, true, _e950);
                                        } else {
                                            phi_3783_ = _e999;
                                            phi_3784_ = _e549;
                                        }
                                        let _e1010 = phi_3783_;
                                        let _e1012 = phi_3784_;
                                        phi_4194_ = _e506;
                                        phi_3786_ = _e508;
                                        phi_3787_ = _e1010;
                                        phi_3788_ = _e1012;
                                        phi_3789_ = select(_e1001, _e551, _e1003);
                                    }
                                    let _e1929 = phi_4194_;
                                    let _e1931 = phi_3786_;
                                    let _e1933 = phi_3787_;
                                    let _e1935 = phi_3788_;
                                    let _e1937 = phi_3789_;
                                    phi_4193_ = _e1929;
                                    phi_3790_ = _e1931;
                                    phi_3791_ = _e1933;
                                    phi_3792_ = (_e512 - 1u);
                                    phi_3793_ = _e1935;
                                    phi_3794_ = _e1937;
                                } else {
                                    phi_4193_ = _e506;
                                    phi_3790_ = _e508;
                                    phi_3791_ = _e547;
                                    phi_3792_ = _e512;
                                    phi_3793_ = _e549;
                                    phi_3794_ = _e551;
                                }
                                let _e1939 = phi_4193_;
                                let _e1941 = phi_3790_;
                                let _e1943 = phi_3791_;
                                let _e1945 = phi_3792_;
                                let _e1947 = phi_3793_;
                                let _e1949 = phi_3794_;
                                phi_4192_ = _e1939;
                                phi_3795_ = _e1941;
                                phi_3796_ = _e1943;
                                phi_3797_ = _e1945;
                                phi_3798_ = _e1947;
                                phi_3799_ = _e1949;
                            } else {
                                phi_4192_ = _e506;
                                phi_3795_ = type_38();
                                phi_3796_ = type_45();
                                phi_3797_ = u32();
                                phi_3798_ = bool();
                                phi_3799_ = u32();
                            }
                            let _e1951 = phi_4192_;
                            let _e1953 = phi_3795_;
                            let _e1955 = phi_3796_;
                            let _e1957 = phi_3797_;
                            let _e1959 = phi_3798_;
                            let _e1961 = phi_3799_;
                            phi_4191_ = _e1951;
                            phi_848_ = _e1953;
                            phi_851_ = _e1955;
                            phi_853_ = _e1957;
                            phi_855_ = _e1959;
                            phi_857_ = _e1961;
                            phi_3800_ = _e520;
                        } else {
                            phi_4191_ = _e506;
                            phi_848_ = type_38();
                            phi_851_ = type_45();
                            phi_853_ = u32();
                            phi_855_ = bool();
                            phi_857_ = u32();
                            phi_3800_ = false;
                        }
                        let _e1963 = phi_4191_;
                        let _e1965 = phi_848_;
                        let _e1967 = phi_851_;
                        let _e1969 = phi_853_;
                        let _e1971 = phi_855_;
                        let _e1973 = phi_857_;
                        let _e1975 = phi_3800_;
                        continue;
                        continuing {
                            phi_4010_ = _e1963;
                            phi_847_ = _e1965;
                            phi_850_ = _e1967;
                            phi_852_ = _e1969;
                            phi_854_ = _e1971;
                            phi_856_ = _e1973;
                            phi_4190_ = _e1963;
                            break if !(_e1975);
                        }
                    }
                    let _e1978 = phi_4190_;
                    if _e1978 {
                        break;
                    }
                    let _e1980 = local_11;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_5.member[_e150] = select(0u, 1u, _e1980.member_1);
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
