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

struct type_32 {
    member: type_22,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_50 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_43;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_50, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_374_: i32;
    var phi_394_: i32;
    var phi_412_: f32;
    var phi_418_: f32;
    var phi_429_: f32;
    var phi_435_: f32;
    var phi_458_: f32;
    var phi_469_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_495_: f32;
    var phi_501_: f32;
    var phi_524_: f32;
    var phi_535_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_590_: f32;
    var phi_601_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_4640_: bool;
    var phi_2830_: type_32;
    var phi_2833_: type_50;
    var phi_2835_: u32;
    var phi_2837_: bool;
    var phi_2839_: u32;
    var phi_2850_: bool;
    var phi_2895_: type_50;
    var phi_2896_: bool;
    var phi_2897_: u32;
    var phi_3695_: type_41;
    var phi_3704_: type_4;
    var phi_3705_: type_4;
    var phi_3728_: type_4;
    var phi_4633_: bool;
    var phi_3858_: type_4;
    var phi_3859_: type_4;
    var phi_3882_: type_4;
    var phi_4693_: bool;
    var phi_4445_: type_50;
    var phi_4484_: type_50;
    var phi_4485_: type_50;
    var phi_4486_: u32;
    var phi_4488_: type_50;
    var phi_4489_: u32;
    var phi_4490_: bool;
    var phi_4497_: type_50;
    var phi_4502_: type_50;
    var phi_4503_: bool;
    var phi_2915_: type_32;
    var phi_2918_: type_4;
    var phi_2919_: type_4;
    var phi_2941_: type_4;
    var phi_2962_: u32;
    var phi_3051_: array<array<f32, 3>, 3>;
    var phi_3522_: vec3<f32>;
    var phi_3523_: vec3<f32>;
    var phi_3554_: bool;
    var phi_3563_: vec3<f32>;
    var phi_3603_: type_22;
    var phi_3605_: type_22;
    var phi_3606_: bool;
    var phi_3610_: type_22;
    var phi_3611_: type_22;
    var phi_3612_: type_22;
    var phi_3613_: bool;
    var phi_3617_: type_22;
    var phi_3618_: bool;
    var phi_3622_: type_22;
    var phi_3623_: bool;
    var phi_3627_: type_22;
    var phi_3652_: bool;
    var phi_3653_: bool;
    var phi_3659_: type_32;
    var phi_3660_: type_32;
    var phi_3661_: type_32;
    var phi_2916_: type_32;
    var phi_4701_: bool;
    var phi_4768_: bool;
    var phi_4505_: type_32;
    var phi_4506_: type_50;
    var phi_4507_: bool;
    var phi_4508_: u32;
    var phi_4767_: bool;
    var phi_4509_: type_32;
    var phi_4510_: type_50;
    var phi_4511_: u32;
    var phi_4512_: bool;
    var phi_4513_: u32;
    var phi_4766_: bool;
    var phi_4514_: type_32;
    var phi_4515_: type_50;
    var phi_4516_: u32;
    var phi_4517_: bool;
    var phi_4518_: u32;
    var phi_4765_: bool;
    var phi_2831_: type_32;
    var phi_2834_: type_50;
    var phi_2836_: u32;
    var phi_2838_: bool;
    var phi_2840_: u32;
    var phi_4519_: bool;
    var phi_4764_: bool;
    var local_12: type_32;
    var phi_4571_: type_22;
    var local_13: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e117 = global_3.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e80.x + (_e80.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_4.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_6.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_4.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_4.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_4.member[_e131].member_1;
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e201 = global_4.member[_e131].member_3;
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && ((bitcast<u32>(_e201) & 2147483647u) <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_332_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_332_;
                        phi_333_ = _e224;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e226 = phi_333_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e150 == _e182);
                    }
                    let _e230 = phi_343_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_353_ = _e232;
                        phi_354_ = _e232;
                        phi_356_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e236 = phi_353_;
                    let _e238 = phi_354_;
                    let _e240 = phi_356_;
                    if _e240 {
                        phi_361_ = (_e238 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e244 = phi_361_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_374_ = -126i;
                    } else {
                        phi_374_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_374_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_394_ = -126i;
                    } else {
                        phi_394_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_394_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_4.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_412_ = _e283[0];
                    } else {
                        phi_412_ = _e283[1];
                    }
                    let _e288 = phi_412_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_418_ = _e283[2];
                    } else {
                        phi_418_ = _e288;
                    }
                    let _e292 = phi_418_;
                    let _e294 = ((_e292 * _e256) * _e262);
                    let _e295 = global_4.member[_e131].member_2;
                    if _e284 {
                        phi_429_ = _e295[0];
                    } else {
                        phi_429_ = _e295[1];
                    }
                    let _e299 = phi_429_;
                    if _e289 {
                        phi_435_ = _e295[2];
                    } else {
                        phi_435_ = _e299;
                    }
                    let _e302 = phi_435_;
                    let _e304 = ((_e302 * _e273) * _e279);
                    let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e308 {
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                        phi_458_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                    } else {
                        phi_458_ = 0f;
                    }
                    let _e316 = phi_458_;
                    let _e317 = (_e294 + _e316);
                    let _e318 = (_e294 - _e316);
                    let _e319 = select(_e304, 0f, _e308);
                    if _e308 {
                        phi_469_ = 38685626000000000000000000f;
                    } else {
                        phi_469_ = (1f / _e304);
                    }
                    let _e322 = phi_469_;
                    let _e323 = (_e244 == 0u);
                    if _e323 {
                        phi_478_ = _e283[0];
                    } else {
                        phi_478_ = _e283[1];
                    }
                    let _e327 = phi_478_;
                    let _e328 = (_e244 == 2u);
                    if _e328 {
                        phi_484_ = _e283[2];
                    } else {
                        phi_484_ = _e327;
                    }
                    let _e331 = phi_484_;
                    let _e333 = ((_e331 * _e256) * _e262);
                    if _e323 {
                        phi_495_ = _e295[0];
                    } else {
                        phi_495_ = _e295[1];
                    }
                    let _e337 = phi_495_;
                    if _e328 {
                        phi_501_ = _e295[2];
                    } else {
                        phi_501_ = _e337;
                    }
                    let _e340 = phi_501_;
                    let _e342 = ((_e340 * _e273) * _e279);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e346 {
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) * 0.00000011920929f);
                        phi_524_ = select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f));
                    } else {
                        phi_524_ = 0f;
                    }
                    let _e354 = phi_524_;
                    let _e355 = (_e333 + _e354);
                    let _e356 = (_e333 - _e354);
                    let _e357 = select(_e342, 0f, _e346);
                    if _e346 {
                        phi_535_ = 38685626000000000000000000f;
                    } else {
                        phi_535_ = (1f / _e342);
                    }
                    let _e360 = phi_535_;
                    let _e361 = (_e246 == 0u);
                    if _e361 {
                        phi_544_ = _e283[0];
                    } else {
                        phi_544_ = _e283[1];
                    }
                    let _e365 = phi_544_;
                    let _e366 = (_e246 == 2u);
                    if _e366 {
                        phi_550_ = _e283[2];
                    } else {
                        phi_550_ = _e365;
                    }
                    let _e369 = phi_550_;
                    let _e371 = ((_e369 * _e256) * _e262);
                    if _e361 {
                        phi_561_ = _e295[0];
                    } else {
                        phi_561_ = _e295[1];
                    }
                    let _e375 = phi_561_;
                    if _e366 {
                        phi_567_ = _e295[2];
                    } else {
                        phi_567_ = _e375;
                    }
                    let _e378 = phi_567_;
                    let _e380 = ((_e378 * _e273) * _e279);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                        phi_590_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_590_ = 0f;
                    }
                    let _e392 = phi_590_;
                    let _e393 = (_e371 + _e392);
                    let _e394 = (_e371 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_601_ = 38685626000000000000000000f;
                    } else {
                        phi_601_ = (1f / _e380);
                    }
                    let _e398 = phi_601_;
                    let _e401 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e333) & 2147483647u));
                    let _e406 = select(_e404, _e401, (_e401 > _e404));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                    let _e412 = (_e121 + _e226);
                    if (_e207 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                        let _e415 = (_e412 / 3i);
                        let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                        let _e429 = bitcast<f32>((bitcast<u32>(((_e412 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                        let _e430 = (((_e192 * _e422) * _e422) * _e429);
                        let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                        let _e437 = (((_e201 * _e422) * _e422) * _e429);
                        let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                        phi_701_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        phi_702_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_701_ = 0f;
                        phi_702_ = 1f;
                    }
                    let _e443 = phi_701_;
                    let _e445 = phi_702_;
                    local_3 = array<type_50, 128>(type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e450 = (_e245 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_11[_e450];
                    let _e454 = (_e244 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_11[_e454];
                    let _e458 = (_e246 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_11[_e458];
                    local_10 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e465 = local_10[_e450];
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e467 = local_10[_e454];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e469 = local_10[_e458];
                    phi_4640_ = false;
                    phi_2830_ = type_32(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e443);
                    phi_2833_ = type_50(type_47(array<f32, 3>(_e453, _e457, _e461), array<f32, 3>(_e465, _e467, _e469)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_2835_ = ((3u * _e83) + 1u);
                    phi_2837_ = (_e445 <= _e443);
                    phi_2839_ = 0u;
                    loop {
                        let _e477 = phi_4640_;
                        let _e479 = phi_2830_;
                        let _e481 = phi_2833_;
                        let _e483 = phi_2835_;
                        let _e485 = phi_2837_;
                        let _e487 = phi_2839_;
                        local_12 = _e479;
                        if _e485 {
                            phi_2850_ = true;
                        } else {
                            phi_2850_ = (_e487 > 0u);
                        }
                        let _e490 = phi_2850_;
                        if _e490 {
                            let _e491 = (_e483 > 0u);
                            if _e491 {
                                if _e485 {
                                    phi_2895_ = _e481;
                                    phi_2896_ = _e485;
                                    phi_2897_ = _e487;
                                } else {
                                    let _e492 = (_e487 - 1u);
                                    let _e493 = (_e492 % 128u);
                                    let _e494 = (_e493 < 128u);
                                    if _e494 {
                                    } else {
                                        phi_4764_ = true;
                                        break;
                                    }
                                    let _e496 = local_3[_e493];
                                    if _e494 {
                                    } else {
                                        phi_4764_ = true;
                                        break;
                                    }
                                    let _e512 = local_2[_e493];
                                    phi_2895_ = type_50(type_47(array<f32, 3>(_e496.member.member[0], _e496.member.member[1], _e496.member.member[2]), array<f32, 3>(_e496.member.member_1[0], _e496.member.member_1[1], _e496.member.member_1[2])), _e496.member_1);
                                    phi_2896_ = (_e512 <= _e479.member_1);
                                    phi_2897_ = _e492;
                                }
                                let _e516 = phi_2895_;
                                let _e518 = phi_2896_;
                                let _e520 = phi_2897_;
                                if _e518 {
                                    if ((_e516.member_1 & 2147483648u) != 0u) {
                                        phi_2915_ = _e479;
                                        phi_2918_ = type_4(0u, ((_e516.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e842 = phi_2915_;
                                            let _e844 = phi_2918_;
                                            local_13 = _e842;
                                            if (_e844.member < _e844.member_1) {
                                                phi_2919_ = type_4((_e844.member + 1u), _e844.member_1);
                                                phi_2941_ = type_4(1u, _e844.member);
                                            } else {
                                                phi_2919_ = _e844;
                                                phi_2941_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e857 = phi_2919_;
                                            let _e859 = phi_2941_;
                                            let _e863 = (bitcast<i32>(_e859.member) != 0i);
                                            if _e863 {
                                                let _e864 = ((_e516.member_1 & 268435455u) + _e859.member_1);
                                                let _e865 = (_e864 < _e85);
                                                if _e865 {
                                                    if _e865 {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e869 = global_2.member[_e864].member_1;
                                                    phi_2962_ = _e869;
                                                } else {
                                                    phi_2962_ = 4294967295u;
                                                }
                                                let _e871 = phi_2962_;
                                                if (_e864 >= _e85) {
                                                    phi_3051_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e865 {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    if (_e450 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e878 = global_2.member[_e864].member[_e450];
                                                    if (_e454 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_2.member[_e864].member[_e454];
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_2.member[_e864].member[_e458];
                                                    let _e892 = (3u + _e450);
                                                    if (_e892 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_2.member[_e864].member[_e892];
                                                    let _e899 = (3u + _e454);
                                                    if (_e899 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e905 = global_2.member[_e864].member[_e899];
                                                    let _e906 = (3u + _e458);
                                                    if (_e906 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e912 = global_2.member[_e864].member[_e906];
                                                    let _e914 = (6u + _e450);
                                                    if (_e914 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e920 = global_2.member[_e864].member[_e914];
                                                    let _e921 = (6u + _e454);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_2.member[_e864].member[_e921];
                                                    let _e928 = (6u + _e458);
                                                    if (_e928 < 9u) {
                                                    } else {
                                                        phi_4701_ = true;
                                                        break;
                                                    }
                                                    let _e934 = global_2.member[_e864].member[_e928];
                                                    phi_3051_ = array<array<f32, 3>, 3>(array<f32, 3>(_e878, _e884, _e890), array<f32, 3>(_e898, _e905, _e912), array<f32, 3>(_e920, _e927, _e934));
                                                }
                                                let _e938 = phi_3051_;
                                                let _e946 = (_e938[0][2] - _e371);
                                                let _e949 = (((_e938[0][0] - _e294) * _e395) - (_e946 * _e319));
                                                let _e952 = (((_e938[0][1] - _e333) * _e395) - (_e946 * _e357));
                                                let _e959 = (_e938[1][2] - _e371);
                                                let _e962 = (((_e938[1][0] - _e294) * _e395) - (_e959 * _e319));
                                                let _e965 = (((_e938[1][1] - _e333) * _e395) - (_e959 * _e357));
                                                let _e972 = (_e938[2][2] - _e371);
                                                let _e975 = (((_e938[2][0] - _e294) * _e395) - (_e972 * _e319));
                                                let _e978 = (((_e938[2][1] - _e333) * _e395) - (_e972 * _e357));
                                                let _e979 = (_e975 * _e965);
                                                let _e980 = (_e978 * _e962);
                                                let _e981 = (_e949 * _e978);
                                                let _e982 = (_e952 * _e975);
                                                let _e983 = (_e962 * _e952);
                                                let _e984 = (_e965 * _e949);
                                                let _e989 = (((_e979 >= _e980) && (_e981 >= _e982)) && (_e983 >= _e984));
                                                if (_e989 || (((_e979 <= _e980) && (_e981 <= _e982)) && (_e983 <= _e984))) {
                                                    let _e996 = select(-1f, 1f, _e989);
                                                    let _e998 = ((_e979 - _e980) * _e996);
                                                    let _e1000 = select(0f, _e998, (_e998 > 0f));
                                                    let _e1002 = ((_e981 - _e982) * _e996);
                                                    let _e1004 = select(0f, _e1002, (_e1002 > 0f));
                                                    let _e1006 = ((_e983 - _e984) * _e996);
                                                    let _e1008 = select(0f, _e1006, (_e1006 > 0f));
                                                    let _e1010 = ((_e1000 + _e1004) + _e1008);
                                                    if (_e1010 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3617_ = type_22();
                                                        phi_3618_ = true;
                                                    } else {
                                                        let _e1013 = select(_e938[1][0], _e938[0][0], (_e938[0][0] < _e938[1][0]));
                                                        let _e1017 = select(_e938[1][0], _e938[0][0], (_e938[0][0] > _e938[1][0]));
                                                        let _e1021 = select(_e938[1][1], _e938[0][1], (_e938[0][1] < _e938[1][1]));
                                                        let _e1025 = select(_e938[1][1], _e938[0][1], (_e938[0][1] > _e938[1][1]));
                                                        let _e1029 = select(_e938[1][2], _e938[0][2], (_e938[0][2] < _e938[1][2]));
                                                        let _e1033 = select(_e938[1][2], _e938[0][2], (_e938[0][2] > _e938[1][2]));
                                                        let _e1038 = ((select(_e938[2][0], _e1013, (_e1013 < _e938[2][0])) - _e317) * _e322);
                                                        let _e1039 = ((select(_e938[2][0], _e1017, (_e1017 > _e938[2][0])) - _e318) * _e322);
                                                        let _e1042 = ((select(_e938[2][1], _e1021, (_e1021 < _e938[2][1])) - _e355) * _e360);
                                                        let _e1043 = ((select(_e938[2][1], _e1025, (_e1025 > _e938[2][1])) - _e356) * _e360);
                                                        let _e1046 = ((select(_e938[2][2], _e1029, (_e1029 < _e938[2][2])) - _e393) * _e398);
                                                        let _e1047 = ((select(_e938[2][2], _e1033, (_e1033 > _e938[2][2])) - _e394) * _e398);
                                                        let _e1049 = select(_e1047, _e1046, (_e1046 < _e1047));
                                                        let _e1051 = select(_e1047, _e1046, (_e1046 > _e1047));
                                                        let _e1053 = select(_e1039, _e1038, (_e1038 < _e1039));
                                                        let _e1055 = select(_e1043, _e1042, (_e1042 < _e1043));
                                                        let _e1057 = select(_e1055, _e1053, (_e1053 > _e1055));
                                                        let _e1059 = select(_e1049, _e1057, (_e1057 > _e1049));
                                                        let _e1061 = select(_e1039, _e1038, (_e1038 > _e1039));
                                                        let _e1063 = select(_e1043, _e1042, (_e1042 > _e1043));
                                                        let _e1065 = select(_e1063, _e1061, (_e1061 < _e1063));
                                                        let _e1067 = select(_e1051, _e1065, (_e1065 < _e1051));
                                                        let _e1068 = -(_e1049);
                                                        let _e1074 = select(_e445, _e1059, (_e1059 > _e445));
                                                        if (_e1074 > (_e1067 + (select(_e1068, _e1051, (_e1051 > _e1068)) * 0.0000019073523f))) {
                                                            phi_3612_ = type_22();
                                                            phi_3613_ = true;
                                                        } else {
                                                            let _e1076 = (_e1074 > _e842.member_1);
                                                            if _e1076 {
                                                                phi_3611_ = type_22();
                                                            } else {
                                                                let _e1080 = (_e938[1][0] - _e938[0][0]);
                                                                let _e1081 = (_e938[1][1] - _e938[0][1]);
                                                                let _e1082 = (_e938[1][2] - _e938[0][2]);
                                                                let _e1083 = vec3<f32>(_e1080, _e1081, _e1082);
                                                                let _e1084 = (_e938[2][0] - _e938[1][0]);
                                                                let _e1085 = (_e938[2][1] - _e938[1][1]);
                                                                let _e1086 = (_e938[2][2] - _e938[1][2]);
                                                                let _e1087 = vec3<f32>(_e1084, _e1085, _e1086);
                                                                let _e1088 = (_e938[0][0] - _e938[2][0]);
                                                                let _e1089 = (_e938[0][1] - _e938[2][1]);
                                                                let _e1090 = (_e938[0][2] - _e938[2][2]);
                                                                let _e1091 = vec3<f32>(_e1088, _e1089, _e1090);
                                                                let _e1094 = bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u));
                                                                let _e1097 = bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u));
                                                                let _e1099 = select(_e1097, _e1094, (_e1094 > _e1097));
                                                                let _e1102 = bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u));
                                                                let _e1104 = select(_e1102, _e1099, (_e1099 > _e1102));
                                                                let _e1107 = bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u));
                                                                let _e1110 = bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u));
                                                                let _e1112 = select(_e1110, _e1107, (_e1107 > _e1110));
                                                                let _e1115 = bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u));
                                                                let _e1117 = select(_e1115, _e1112, (_e1112 > _e1115));
                                                                let _e1120 = bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u));
                                                                let _e1123 = bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u));
                                                                let _e1125 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                                let _e1128 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
                                                                let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                                let _e1132 = select(_e1117, _e1104, (_e1104 > _e1117));
                                                                let _e1134 = select(_e1130, _e1132, (_e1132 > _e1130));
                                                                if (_e1104 == _e1134) {
                                                                    phi_3522_ = _e1087;
                                                                    phi_3523_ = _e1091;
                                                                } else {
                                                                    let _e1137 = vec3((_e1117 == _e1134));
                                                                    phi_3522_ = select(_e1083, _e1091, _e1137);
                                                                    phi_3523_ = select(_e1087, _e1083, _e1137);
                                                                }
                                                                let _e1141 = phi_3522_;
                                                                let _e1143 = phi_3523_;
                                                                let _e1150 = ((_e1141.y * _e1143.z) - (_e1143.y * _e1141.z));
                                                                let _e1155 = ((_e1141.z * _e1143.x) - (_e1143.z * _e1141.x));
                                                                let _e1158 = ((_e1141.x * _e1143.y) - (_e1143.x * _e1141.y));
                                                                if (_e1000 >= _e1004) {
                                                                    phi_3554_ = select(true, false, (_e1000 >= _e1008));
                                                                } else {
                                                                    phi_3554_ = true;
                                                                }
                                                                let _e1163 = phi_3554_;
                                                                if _e1163 {
                                                                    phi_3563_ = select(vec3<f32>(_e938[2][0], _e938[2][1], _e938[2][2]), vec3<f32>(_e938[1][0], _e938[1][1], _e938[1][2]), vec3((_e1004 >= _e1008)));
                                                                } else {
                                                                    phi_3563_ = vec3<f32>(_e938[0][0], _e938[0][1], _e938[0][2]);
                                                                }
                                                                let _e1168 = phi_3563_;
                                                                let _e1185 = ((((_e1150 * (_e1168.x - _e294)) + (_e1155 * (_e1168.y - _e333))) + (_e1158 * (_e1168.z - _e371))) / (((_e1150 * _e319) + (_e1155 * _e357)) + (_e1158 * _e395)));
                                                                let _e1187 = select(_e1067, _e1185, (_e1185 < _e1067));
                                                                let _e1189 = select(_e1059, _e1187, (_e1187 > _e1059));
                                                                if (_e1189 >= _e445) {
                                                                    let _e1191 = (_e1189 <= _e842.member_1);
                                                                    if _e1191 {
                                                                        let _e1192 = (1f / _e1010);
                                                                        phi_3603_ = type_22(_e1189, (_e1004 * _e1192), (_e1008 * _e1192), _e871);
                                                                    } else {
                                                                        phi_3603_ = type_22();
                                                                    }
                                                                    let _e1197 = phi_3603_;
                                                                    phi_3605_ = _e1197;
                                                                    phi_3606_ = select(true, false, _e1191);
                                                                } else {
                                                                    phi_3605_ = type_22();
                                                                    phi_3606_ = true;
                                                                }
                                                                let _e1200 = phi_3605_;
                                                                let _e1202 = phi_3606_;
                                                                if _e1202 {
                                                                    phi_3610_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3610_ = _e1200;
                                                                }
                                                                let _e1204 = phi_3610_;
                                                                phi_3611_ = _e1204;
                                                            }
                                                            let _e1206 = phi_3611_;
                                                            phi_3612_ = _e1206;
                                                            phi_3613_ = _e1076;
                                                        }
                                                        let _e1208 = phi_3612_;
                                                        let _e1210 = phi_3613_;
                                                        phi_3617_ = _e1208;
                                                        phi_3618_ = _e1210;
                                                    }
                                                    let _e1212 = phi_3617_;
                                                    let _e1214 = phi_3618_;
                                                    phi_3622_ = _e1212;
                                                    phi_3623_ = _e1214;
                                                } else {
                                                    phi_3622_ = type_22();
                                                    phi_3623_ = true;
                                                }
                                                let _e1216 = phi_3622_;
                                                let _e1218 = phi_3623_;
                                                if _e1218 {
                                                    phi_3627_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3627_ = _e1216;
                                                }
                                                let _e1220 = phi_3627_;
                                                if (_e1220.member_3 != 4294967295u) {
                                                    if (_e871 != 4294967295u) {
                                                        if (_e1220.member < _e842.member.member) {
                                                            phi_3653_ = true;
                                                        } else {
                                                            if (_e1220.member == _e842.member.member) {
                                                                phi_3652_ = (_e1220.member_3 < _e842.member.member_3);
                                                            } else {
                                                                phi_3652_ = false;
                                                            }
                                                            let _e1233 = phi_3652_;
                                                            phi_3653_ = _e1233;
                                                        }
                                                        let _e1235 = phi_3653_;
                                                        if _e1235 {
                                                            phi_3659_ = type_32(_e1220, _e1220.member);
                                                        } else {
                                                            phi_3659_ = _e842;
                                                        }
                                                        let _e1238 = phi_3659_;
                                                        phi_3660_ = _e1238;
                                                    } else {
                                                        phi_3660_ = _e842;
                                                    }
                                                    let _e1240 = phi_3660_;
                                                    phi_3661_ = _e1240;
                                                } else {
                                                    phi_3661_ = _e842;
                                                }
                                                let _e1242 = phi_3661_;
                                                phi_2916_ = _e1242;
                                            } else {
                                                phi_2916_ = type_32();
                                            }
                                            let _e1244 = phi_2916_;
                                            continue;
                                            continuing {
                                                phi_2915_ = _e1244;
                                                phi_2918_ = _e857;
                                                phi_4701_ = _e477;
                                                break if !(_e863);
                                            }
                                        }
                                        let _e1247 = phi_4701_;
                                        phi_4764_ = _e1247;
                                        if _e1247 {
                                            break;
                                        }
                                        phi_4768_ = _e1247;
                                        let _e1423 = local_13;
                                        phi_4505_ = _e1423;
                                        phi_4506_ = _e516;
                                        phi_4507_ = false;
                                        phi_4508_ = _e520;
                                    } else {
                                        local_1 = array<f32, 3>(_e516.member.member[0], _e516.member.member[1], _e516.member.member[2]);
                                        local = array<f32, 3>(_e516.member.member_1[0], _e516.member.member_1[1], _e516.member.member_1[2]);
                                        let _e540 = (_e516.member_1 < _e83);
                                        if _e540 {
                                            if _e540 {
                                            } else {
                                                phi_4764_ = true;
                                                break;
                                            }
                                            let _e542 = global_5.member[_e516.member_1];
                                            phi_3695_ = _e542;
                                        } else {
                                            phi_3695_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e544 = phi_3695_;
                                        let _e546 = array<u32, 3>(_e245, _e244, _e246);
                                        local_9 = _e546;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3704_ = type_4(0u, 3u);
                                        loop {
                                            let _e548 = phi_3704_;
                                            if (_e548.member < _e548.member_1) {
                                                phi_3705_ = type_4((_e548.member + 1u), _e548.member_1);
                                                phi_3728_ = type_4(1u, _e548.member);
                                            } else {
                                                phi_3705_ = _e548;
                                                phi_3728_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e561 = phi_3705_;
                                            let _e563 = phi_3728_;
                                            let _e567 = (bitcast<i32>(_e563.member) != 0i);
                                            if _e567 {
                                                let _e568 = (_e563.member_1 < 3u);
                                                if _e568 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                let _e570 = local_9[_e563.member_1];
                                                if _e568 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                let _e572 = local_1[_e563.member_1];
                                                if _e568 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                let _e574 = local[_e563.member_1];
                                                let _e577 = ((10u * _e570) & 31u);
                                                let _e580 = ((_e544.member[0] >> bitcast<u32>(_e577)) & 1023u);
                                                let _e585 = bitcast<f32>((bitcast<u32>(((_e574 - _e572) * 0.0009775171f)) ^ _e117));
                                                let _e591 = (_e572 + bitcast<f32>((bitcast<u32>((f32(_e580) * _e585)) ^ _e117)));
                                                if _e568 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_5[_e563.member_1] = select(select(_e574, _e591, (_e591 < _e574)), _e574, (_e580 == 1023u));
                                                let _e600 = ((_e544.member[1] >> bitcast<u32>(_e577)) & 1023u);
                                                let _e606 = (_e572 + bitcast<f32>((bitcast<u32>((f32(_e600) * _e585)) ^ _e117)));
                                                if _e568 {
                                                } else {
                                                    phi_4633_ = true;
                                                    break;
                                                }
                                                local_4[_e563.member_1] = select(select(_e574, _e606, (_e606 < _e574)), _e574, (_e600 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3704_ = _e561;
                                                phi_4633_ = _e477;
                                                break if !(_e567);
                                            }
                                        }
                                        let _e614 = phi_4633_;
                                        phi_4764_ = _e614;
                                        if _e614 {
                                            break;
                                        }
                                        let _e615 = local_4;
                                        let _e616 = local_5;
                                        local_8 = _e546;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3858_ = type_4(0u, 3u);
                                        loop {
                                            let _e625 = phi_3858_;
                                            if (_e625.member < _e625.member_1) {
                                                phi_3859_ = type_4((_e625.member + 1u), _e625.member_1);
                                                phi_3882_ = type_4(1u, _e625.member);
                                            } else {
                                                phi_3859_ = _e625;
                                                phi_3882_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e638 = phi_3859_;
                                            let _e640 = phi_3882_;
                                            let _e644 = (bitcast<i32>(_e640.member) != 0i);
                                            if _e644 {
                                                let _e645 = (_e640.member_1 < 3u);
                                                if _e645 {
                                                } else {
                                                    phi_4693_ = true;
                                                    break;
                                                }
                                                let _e647 = local_8[_e640.member_1];
                                                if _e645 {
                                                } else {
                                                    phi_4693_ = true;
                                                    break;
                                                }
                                                let _e649 = local_1[_e640.member_1];
                                                if _e645 {
                                                } else {
                                                    phi_4693_ = true;
                                                    break;
                                                }
                                                let _e651 = local[_e640.member_1];
                                                let _e654 = ((10u * _e647) & 31u);
                                                let _e657 = ((_e544.member_1[0] >> bitcast<u32>(_e654)) & 1023u);
                                                let _e662 = bitcast<f32>((bitcast<u32>(((_e651 - _e649) * 0.0009775171f)) ^ _e117));
                                                let _e668 = (_e649 + bitcast<f32>((bitcast<u32>((f32(_e657) * _e662)) ^ _e117)));
                                                if _e645 {
                                                } else {
                                                    phi_4693_ = true;
                                                    break;
                                                }
                                                local_7[_e640.member_1] = select(select(_e651, _e668, (_e668 < _e651)), _e651, (_e657 == 1023u));
                                                let _e677 = ((_e544.member_1[1] >> bitcast<u32>(_e654)) & 1023u);
                                                let _e683 = (_e649 + bitcast<f32>((bitcast<u32>((f32(_e677) * _e662)) ^ _e117)));
                                                if _e645 {
                                                } else {
                                                    phi_4693_ = true;
                                                    break;
                                                }
                                                local_6[_e640.member_1] = select(select(_e651, _e683, (_e683 < _e651)), _e651, (_e677 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3858_ = _e638;
                                                phi_4693_ = _e614;
                                                break if !(_e644);
                                            }
                                        }
                                        let _e691 = phi_4693_;
                                        phi_4764_ = _e691;
                                        if _e691 {
                                            break;
                                        }
                                        let _e692 = local_6;
                                        let _e693 = local_7;
                                        let _e704 = type_50(type_47(array<f32, 3>(_e616[0], _e616[1], _e616[2]), array<f32, 3>(_e615[0], _e615[1], _e615[2])), _e544.member_2);
                                        let _e709 = type_50(type_47(array<f32, 3>(_e693[0], _e693[1], _e693[2]), array<f32, 3>(_e692[0], _e692[1], _e692[2])), _e544.member_3);
                                        let _e715 = ((_e616[0] - _e317) * _e322);
                                        let _e716 = ((_e693[0] - _e317) * _e322);
                                        let _e717 = ((_e615[0] - _e318) * _e322);
                                        let _e718 = ((_e692[0] - _e318) * _e322);
                                        let _e723 = ((_e616[1] - _e355) * _e360);
                                        let _e724 = ((_e693[1] - _e355) * _e360);
                                        let _e725 = ((_e615[1] - _e356) * _e360);
                                        let _e726 = ((_e692[1] - _e356) * _e360);
                                        let _e731 = ((_e616[2] - _e393) * _e398);
                                        let _e732 = ((_e693[2] - _e393) * _e398);
                                        let _e733 = ((_e615[2] - _e394) * _e398);
                                        let _e734 = ((_e692[2] - _e394) * _e398);
                                        let _e736 = select(_e733, _e731, (_e731 < _e733));
                                        let _e738 = select(_e734, _e732, (_e732 < _e734));
                                        let _e740 = select(_e733, _e731, (_e731 > _e733));
                                        let _e742 = select(_e734, _e732, (_e732 > _e734));
                                        let _e744 = select(_e717, _e715, (_e715 < _e717));
                                        let _e746 = select(_e718, _e716, (_e716 < _e718));
                                        let _e748 = select(_e725, _e723, (_e723 < _e725));
                                        let _e750 = select(_e726, _e724, (_e724 < _e726));
                                        let _e752 = select(_e748, _e744, (_e744 > _e748));
                                        let _e754 = select(_e750, _e746, (_e746 > _e750));
                                        let _e756 = select(_e736, _e752, (_e752 > _e736));
                                        let _e758 = select(_e738, _e754, (_e754 > _e738));
                                        let _e760 = select(_e717, _e715, (_e715 > _e717));
                                        let _e762 = select(_e718, _e716, (_e716 > _e718));
                                        let _e764 = select(_e725, _e723, (_e723 > _e725));
                                        let _e766 = select(_e726, _e724, (_e724 > _e726));
                                        let _e768 = select(_e764, _e760, (_e760 < _e764));
                                        let _e770 = select(_e766, _e762, (_e762 < _e766));
                                        let _e775 = -(_e736);
                                        let _e776 = -(_e738);
                                        let _e783 = (select(_e740, _e768, (_e768 < _e740)) + (select(_e775, _e740, (_e740 > _e775)) * 0.0000019073523f));
                                        let _e784 = (select(_e742, _e770, (_e770 < _e742)) + (select(_e776, _e742, (_e742 > _e776)) * 0.0000019073523f));
                                        let _e786 = select(_e445, _e756, (_e756 > _e445));
                                        let _e788 = select(_e445, _e758, (_e758 > _e445));
                                        let _e793 = (_e786 <= select(_e479.member_1, _e783, (_e783 < _e479.member_1)));
                                        let _e794 = (_e788 <= select(_e479.member_1, _e784, (_e784 < _e479.member_1)));
                                        let _e795 = (_e786 <= _e788);
                                        if _e793 {
                                            if _e794 {
                                                if _e795 {
                                                    phi_4445_ = _e709;
                                                } else {
                                                    phi_4445_ = _e704;
                                                }
                                                let _e797 = phi_4445_;
                                                let _e798 = (_e520 % 128u);
                                                let _e799 = (_e798 < 128u);
                                                if _e799 {
                                                } else {
                                                    phi_4764_ = true;
                                                    break;
                                                }
                                                local_3[_e798] = type_50(type_47(array<f32, 3>(_e797.member.member[0], _e797.member.member[1], _e797.member.member[2]), array<f32, 3>(_e797.member.member_1[0], _e797.member.member_1[1], _e797.member.member_1[2])), _e797.member_1);
                                                if _e799 {
                                                } else {
                                                    phi_4764_ = true;
                                                    break;
                                                }
                                                local_2[_e798] = select(_e788, _e786, (_e786 > _e788));
                                                if _e795 {
                                                    phi_4484_ = _e704;
                                                } else {
                                                    phi_4484_ = _e709;
                                                }
                                                let _e820 = phi_4484_;
                                                phi_4485_ = _e820;
                                                phi_4486_ = (_e520 + 1u);
                                            } else {
                                                phi_4485_ = type_50();
                                                phi_4486_ = u32();
                                            }
                                            let _e822 = phi_4485_;
                                            let _e824 = phi_4486_;
                                            phi_4488_ = _e822;
                                            phi_4489_ = _e824;
                                            phi_4490_ = select(true, false, _e794);
                                        } else {
                                            phi_4488_ = type_50();
                                            phi_4489_ = u32();
                                            phi_4490_ = true;
                                        }
                                        let _e827 = phi_4488_;
                                        let _e829 = phi_4489_;
                                        let _e831 = phi_4490_;
                                        if _e831 {
                                            if _e793 {
                                                phi_4497_ = _e704;
                                            } else {
                                                phi_4497_ = _e709;
                                            }
                                            let _e833 = phi_4497_;
                                            phi_4502_ = _e833;
                                            phi_4503_ = select(_e794, true, _e793);
                                        } else {
                                            phi_4502_ = _e827;
                                            phi_4503_ = _e518;
                                        }
                                        let _e836 = phi_4502_;
                                        let _e838 = phi_4503_;
                                        phi_4768_ = _e691;
                                        phi_4505_ = _e479;
                                        phi_4506_ = _e836;
                                        phi_4507_ = _e838;
                                        phi_4508_ = select(_e829, _e520, _e831);
                                    }
                                    let _e1249 = phi_4768_;
                                    let _e1251 = phi_4505_;
                                    let _e1253 = phi_4506_;
                                    let _e1255 = phi_4507_;
                                    let _e1257 = phi_4508_;
                                    phi_4767_ = _e1249;
                                    phi_4509_ = _e1251;
                                    phi_4510_ = _e1253;
                                    phi_4511_ = (_e483 - 1u);
                                    phi_4512_ = _e1255;
                                    phi_4513_ = _e1257;
                                } else {
                                    phi_4767_ = _e477;
                                    phi_4509_ = _e479;
                                    phi_4510_ = _e516;
                                    phi_4511_ = _e483;
                                    phi_4512_ = _e518;
                                    phi_4513_ = _e520;
                                }
                                let _e1259 = phi_4767_;
                                let _e1261 = phi_4509_;
                                let _e1263 = phi_4510_;
                                let _e1265 = phi_4511_;
                                let _e1267 = phi_4512_;
                                let _e1269 = phi_4513_;
                                phi_4766_ = _e1259;
                                phi_4514_ = _e1261;
                                phi_4515_ = _e1263;
                                phi_4516_ = _e1265;
                                phi_4517_ = _e1267;
                                phi_4518_ = _e1269;
                            } else {
                                phi_4766_ = _e477;
                                phi_4514_ = type_32();
                                phi_4515_ = type_50();
                                phi_4516_ = u32();
                                phi_4517_ = bool();
                                phi_4518_ = u32();
                            }
                            let _e1271 = phi_4766_;
                            let _e1273 = phi_4514_;
                            let _e1275 = phi_4515_;
                            let _e1277 = phi_4516_;
                            let _e1279 = phi_4517_;
                            let _e1281 = phi_4518_;
                            phi_4765_ = _e1271;
                            phi_2831_ = _e1273;
                            phi_2834_ = _e1275;
                            phi_2836_ = _e1277;
                            phi_2838_ = _e1279;
                            phi_2840_ = _e1281;
                            phi_4519_ = _e491;
                        } else {
                            phi_4765_ = _e477;
                            phi_2831_ = type_32();
                            phi_2834_ = type_50();
                            phi_2836_ = u32();
                            phi_2838_ = bool();
                            phi_2840_ = u32();
                            phi_4519_ = false;
                        }
                        let _e1283 = phi_4765_;
                        let _e1285 = phi_2831_;
                        let _e1287 = phi_2834_;
                        let _e1289 = phi_2836_;
                        let _e1291 = phi_2838_;
                        let _e1293 = phi_2840_;
                        let _e1295 = phi_4519_;
                        continue;
                        continuing {
                            phi_4640_ = _e1283;
                            phi_2830_ = _e1285;
                            phi_2833_ = _e1287;
                            phi_2835_ = _e1289;
                            phi_2837_ = _e1291;
                            phi_2839_ = _e1293;
                            phi_4764_ = _e1283;
                            break if !(_e1295);
                        }
                    }
                    let _e1298 = phi_4764_;
                    if _e1298 {
                        break;
                    }
                    let _e1300 = local_12;
                    if (_e1300.member.member_3 != 4294967295u) {
                        let _e1305 = -(_e412);
                        let _e1306 = (_e1305 / 3i);
                        let _e1313 = bitcast<f32>((bitcast<u32>((_e1306 + 127i)) << bitcast<u32>(23i)));
                        let _e1321 = (((_e1300.member.member * _e1313) * _e1313) * bitcast<f32>((bitcast<u32>(((_e1305 - (2i * _e1306)) + 127i)) << bitcast<u32>(23i))));
                        let _e1323 = select(340282350000000000000000000000000000000f, _e1321, (_e1321 < 340282350000000000000000000000000000000f));
                        phi_4571_ = type_22(select(-340282350000000000000000000000000000000f, _e1323, (_e1323 > -340282350000000000000000000000000000000f)), _e1300.member.member_1, _e1300.member.member_2, _e1300.member.member_3);
                    } else {
                        phi_4571_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1330 = phi_4571_;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_6.member[_e131] = _e1330;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
