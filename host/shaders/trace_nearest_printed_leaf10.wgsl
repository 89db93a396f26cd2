struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<type_19>,
}

struct type_31 {
    member: array<array<type_18, 8>>,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_52 {
    member: type_44,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_27;
@group(0) @binding(2) 
var<storage> global_4: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(3) 
var<storage> global_6: type_48;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_18, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_433_: i32;
    var phi_434_: i32;
    var phi_444_: bool;
    var phi_454_: u32;
    var phi_455_: u32;
    var phi_457_: bool;
    var phi_462_: u32;
    var phi_475_: i32;
    var phi_495_: i32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_617_: f32;
    var phi_629_: f32;
    var phi_638_: f32;
    var phi_644_: f32;
    var phi_684_: f32;
    var phi_690_: f32;
    var phi_742_: f32;
    var phi_754_: f32;
    var phi_763_: f32;
    var phi_769_: f32;
    var phi_809_: f32;
    var phi_815_: f32;
    var phi_867_: f32;
    var phi_879_: f32;
    var phi_934_: i32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_994_: i32;
    var phi_1016_: u32;
    var phi_1017_: u32;
    var phi_1025_: f32;
    var phi_1026_: f32;
    var phi_4020_: bool;
    var phi_3965_: f32;
    var phi_1162_: u32;
    var phi_1165_: bool;
    var phi_1167_: u32;
    var phi_1169_: type_52;
    var phi_1180_: bool;
    var phi_1267_: bool;
    var phi_1268_: u32;
    var phi_1269_: type_52;
    var phi_4017_: bool;
    var phi_3988_: f32;
    var phi_1288_: type_4;
    var phi_1289_: type_4;
    var phi_1312_: type_4;
    var phi_1337_: u32;
    var phi_1353_: type_46;
    var phi_1792_: bool;
    var phi_1821_: bool;
    var phi_2216_: f32;
    var phi_2217_: f32;
    var phi_2218_: f32;
    var phi_2219_: f32;
    var phi_2220_: vec3<f32>;
    var phi_2221_: vec3<f32>;
    var phi_2222_: vec3<f32>;
    var phi_2223_: vec3<f32>;
    var phi_2260_: bool;
    var phi_2269_: vec3<f32>;
    var phi_2434_: f32;
    var phi_2436_: f32;
    var phi_2437_: bool;
    var phi_2457_: f32;
    var phi_2458_: f32;
    var phi_2481_: type_18;
    var phi_2483_: type_18;
    var phi_2484_: bool;
    var phi_2488_: type_18;
    var phi_2489_: type_18;
    var phi_2490_: type_18;
    var phi_2491_: bool;
    var phi_2495_: type_18;
    var phi_2496_: bool;
    var phi_2497_: type_18;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: type_18;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2510_: type_18;
    var phi_2511_: bool;
    var phi_2515_: type_18;
    var phi_2527_: type_4;
    var phi_2530_: type_18;
    var phi_2528_: type_4;
    var phi_2553_: type_4;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2607_: type_18;
    var phi_2531_: type_18;
    var phi_3990_: bool;
    var phi_4290_: f32;
    var phi_4289_: f32;
    var phi_4171_: bool;
    var phi_4288_: f32;
    var phi_4170_: bool;
    var phi_4287_: f32;
    var phi_4169_: bool;
    var phi_4199_: f32;
    var phi_4168_: bool;
    var phi_4350_: bool;
    var phi_4198_: f32;
    var phi_2639_: type_39;
    var phi_3526_: type_52;
    var phi_3602_: type_52;
    var phi_3603_: u32;
    var phi_3604_: type_52;
    var phi_3606_: u32;
    var phi_3607_: type_52;
    var phi_3608_: bool;
    var phi_3615_: type_52;
    var phi_3620_: bool;
    var phi_3622_: type_52;
    var phi_3626_: bool;
    var phi_3627_: u32;
    var phi_3628_: type_52;
    var phi_3638_: type_52;
    var phi_4377_: f32;
    var phi_4294_: bool;
    var phi_3639_: u32;
    var phi_3640_: bool;
    var phi_3641_: u32;
    var phi_3642_: type_52;
    var phi_4376_: f32;
    var phi_4293_: bool;
    var phi_3643_: u32;
    var phi_3644_: bool;
    var phi_3645_: u32;
    var phi_3646_: type_52;
    var phi_4375_: f32;
    var phi_4292_: bool;
    var phi_1163_: u32;
    var phi_1166_: bool;
    var phi_1168_: u32;
    var phi_1170_: type_52;
    var phi_3647_: bool;
    var phi_4291_: bool;
    var phi_3654_: type_4;
    var phi_3655_: type_4;
    var phi_3678_: type_4;
    var phi_3730_: f32;
    var phi_3732_: f32;
    var phi_3733_: bool;
    var phi_3734_: f32;
    var phi_3735_: bool;
    var phi_3874_: u32;
    var phi_3892_: bool;
    var phi_3895_: bool;
    var phi_3908_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3915_: f32;
    var phi_3916_: bool;
    var phi_3924_: f32;
    var phi_3750_: f32;
    var phi_3751_: f32;
    var phi_3763_: f32;
    var phi_3768_: type_18;
    var phi_4357_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e99 = global_2.member[0u][0u];
            let _e103 = global_2.member[0u][1u];
            let _e107 = global_2.member[0u][2u];
            let _e111 = global_2.member[1u][0u];
            let _e115 = global_2.member[1u][1u];
            let _e119 = global_2.member[1u][2u];
            let _e123 = global_2.member[1u][3u];
            let _e126 = global_1.member[0u];
            let _e127 = bitcast<i32>(_e126);
            let _e137 = (_e85.x + (_e85.y * 2097152u));
            let _e138 = (_e137 < arrayLength((&global_3.member)));
            if _e138 {
                let _e139 = (_e137 < arrayLength((&global_5.member)));
                if _e139 {
                    if _e138 {
                    } else {
                        break;
                    }
                    let _e147 = global_3.member[_e137].member_2[0u];
                    let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                    let _e154 = global_3.member[_e137].member_2[1u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e137].member_2[2u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e137].member[0u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e137].member[1u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_3.member[_e137].member[2u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e186 = select(_e156, _e149, (_e156 < _e149));
                    let _e188 = select(_e163, _e186, (_e163 < _e186));
                    let _e190 = select(_e170, _e188, (_e170 < _e188));
                    let _e192 = select(_e177, _e190, (_e177 < _e190));
                    let _e194 = select(_e184, _e192, (_e184 < _e192));
                    let _e198 = global_3.member[_e137].member_1;
                    let _e199 = bitcast<u32>(_e198);
                    let _e200 = (_e199 & 2147483647u);
                    let _e207 = global_3.member[_e137].member_3;
                    let _e208 = bitcast<u32>(_e207);
                    let _e209 = (_e208 & 2147483647u);
                    let _e213 = (((select(_e200, _e194, (_e200 < _e194)) < 2139095040u) && (_e209 <= 2139095040u)) && (_e188 > 0u));
                    if _e213 {
                        let _e216 = (bitcast<u32>(bitcast<f32>(_e188)) & 2147483647u);
                        if (_e216 >= 8388608u) {
                            phi_433_ = (bitcast<i32>((_e216 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_433_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e216)), 32u, (_e216 == 0u))));
                        }
                        let _e230 = phi_433_;
                        phi_434_ = _e230;
                    } else {
                        phi_434_ = 0i;
                    }
                    let _e232 = phi_434_;
                    let _e233 = (_e149 == _e188);
                    if _e233 {
                        phi_444_ = true;
                    } else {
                        phi_444_ = (_e156 == _e188);
                    }
                    let _e236 = phi_444_;
                    let _e237 = select(1u, 0u, _e233);
                    if _e236 {
                        let _e238 = (_e237 + 1u);
                        phi_454_ = _e238;
                        phi_455_ = _e238;
                        phi_457_ = select(true, false, (_e238 == 2u));
                    } else {
                        phi_454_ = u32();
                        phi_455_ = 0u;
                        phi_457_ = true;
                    }
                    let _e242 = phi_454_;
                    let _e244 = phi_455_;
                    let _e246 = phi_457_;
                    if _e246 {
                        phi_462_ = (_e244 + 1u);
                    } else {
                        phi_462_ = 0u;
                    }
                    let _e250 = phi_462_;
                    let _e251 = select(_e242, _e244, _e246);
                    let _e252 = select(_e237, select(2u, _e237, _e236), _e246);
                    if (_e127 < -126i) {
                        phi_475_ = -126i;
                    } else {
                        phi_475_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e257 = phi_475_;
                    let _e262 = bitcast<f32>((bitcast<u32>((_e257 + 127i)) << bitcast<u32>(23i)));
                    let _e268 = bitcast<f32>((bitcast<u32>(((_e127 - _e257) + 127i)) << bitcast<u32>(23i)));
                    let _e269 = -(_e232);
                    if (_e269 < -126i) {
                        phi_495_ = -126i;
                    } else {
                        phi_495_ = select(_e269, 127i, (_e269 > 127i));
                    }
                    let _e274 = phi_495_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e269 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e289 = global_3.member[_e137].member;
                    let _e290 = (_e251 == 0u);
                    if _e290 {
                        phi_513_ = _e289[0];
                    } else {
                        phi_513_ = _e289[1];
                    }
                    let _e294 = phi_513_;
                    let _e295 = (_e251 == 2u);
                    if _e295 {
                        phi_519_ = _e289[2];
                    } else {
                        phi_519_ = _e294;
                    }
                    let _e298 = phi_519_;
                    let _e299 = bitcast<u32>(_e298);
                    let _e301 = ((_e299 & 2139095040u) != 0u);
                    let _e315 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e299 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e299 & 2147483648u))), _e298, _e301) * _e262) * select(0.00000011920929f, 1f, _e301)) * _e268);
                    let _e316 = global_3.member[_e137].member_2;
                    if _e290 {
                        phi_559_ = _e316[0];
                    } else {
                        phi_559_ = _e316[1];
                    }
                    let _e320 = phi_559_;
                    if _e295 {
                        phi_565_ = _e316[2];
                    } else {
                        phi_565_ = _e320;
                    }
                    let _e323 = phi_565_;
                    let _e324 = bitcast<u32>(_e323);
                    let _e326 = ((_e324 & 2139095040u) != 0u);
                    let _e340 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e324 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e324 & 2147483648u))), _e323, _e326) * _e279) * select(0.00000011920929f, 1f, _e326)) * _e285);
                    let _e344 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e344 {
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e315) & 2147483647u)) * 0.00000011920929f);
                        phi_617_ = select(0.00000000000011368684f, _e348, (_e348 > 0.00000000000011368684f));
                    } else {
                        phi_617_ = 0f;
                    }
                    let _e352 = phi_617_;
                    let _e353 = (_e315 + _e352);
                    let _e354 = (_e315 - _e352);
                    let _e355 = select(_e340, 0f, _e344);
                    if _e344 {
                        phi_629_ = 38685626000000000000000000f;
                    } else {
                        phi_629_ = (1f / _e340);
                    }
                    let _e358 = phi_629_;
                    let _e359 = (_e250 == 0u);
                    if _e359 {
                        phi_638_ = _e289[0];
                    } else {
                        phi_638_ = _e289[1];
                    }
                    let _e363 = phi_638_;
                    let _e364 = (_e250 == 2u);
                    if _e364 {
                        phi_644_ = _e289[2];
                    } else {
                        phi_644_ = _e363;
                    }
                    let _e367 = phi_644_;
                    let _e368 = bitcast<u32>(_e367);
                    let _e370 = ((_e368 & 2139095040u) != 0u);
                    let _e384 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e368 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e368 & 2147483648u))), _e367, _e370) * _e262) * select(0.00000011920929f, 1f, _e370)) * _e268);
                    if _e359 {
                        phi_684_ = _e316[0];
                    } else {
                        phi_684_ = _e316[1];
                    }
                    let _e388 = phi_684_;
                    if _e364 {
                        phi_690_ = _e316[2];
                    } else {
                        phi_690_ = _e388;
                    }
                    let _e391 = phi_690_;
                    let _e392 = bitcast<u32>(_e391);
                    let _e394 = ((_e392 & 2139095040u) != 0u);
                    let _e408 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e392 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e392 & 2147483648u))), _e391, _e394) * _e279) * select(0.00000011920929f, 1f, _e394)) * _e285);
                    let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e412 {
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                        phi_742_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                    } else {
                        phi_742_ = 0f;
                    }
                    let _e420 = phi_742_;
                    let _e421 = (_e384 + _e420);
                    let _e422 = (_e384 - _e420);
                    let _e423 = select(_e408, 0f, _e412);
                    if _e412 {
                        phi_754_ = 38685626000000000000000000f;
                    } else {
                        phi_754_ = (1f / _e408);
                    }
                    let _e426 = phi_754_;
                    let _e427 = (_e252 == 0u);
                    if _e427 {
                        phi_763_ = _e289[0];
                    } else {
                        phi_763_ = _e289[1];
                    }
                    let _e431 = phi_763_;
                    let _e432 = (_e252 == 2u);
                    if _e432 {
                        phi_769_ = _e289[2];
                    } else {
                        phi_769_ = _e431;
                    }
                    let _e435 = phi_769_;
                    let _e436 = bitcast<u32>(_e435);
                    let _e438 = ((_e436 & 2139095040u) != 0u);
                    let _e452 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e436 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e436 & 2147483648u))), _e435, _e438) * _e262) * select(0.00000011920929f, 1f, _e438)) * _e268);
                    if _e427 {
                        phi_809_ = _e316[0];
                    } else {
                        phi_809_ = _e316[1];
                    }
                    let _e456 = phi_809_;
                    if _e432 {
                        phi_815_ = _e316[2];
                    } else {
                        phi_815_ = _e456;
                    }
                    let _e459 = phi_815_;
                    let _e460 = bitcast<u32>(_e459);
                    let _e462 = ((_e460 & 2139095040u) != 0u);
                    let _e476 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e460 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e460 & 2147483648u))), _e459, _e462) * _e279) * select(0.00000011920929f, 1f, _e462)) * _e285);
                    let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e480 {
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e452) & 2147483647u)) * 0.00000011920929f);
                        phi_867_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                    } else {
                        phi_867_ = 0f;
                    }
                    let _e488 = phi_867_;
                    let _e489 = (_e452 + _e488);
                    let _e490 = (_e452 - _e488);
                    let _e491 = select(_e476, 0f, _e480);
                    if _e480 {
                        phi_879_ = 38685626000000000000000000f;
                    } else {
                        phi_879_ = (1f / _e476);
                    }
                    let _e494 = phi_879_;
                    let _e497 = bitcast<f32>((bitcast<u32>(_e315) & 2147483647u));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                    let _e502 = select(_e500, _e497, (_e497 > _e500));
                    let _e505 = bitcast<f32>((bitcast<u32>(_e452) & 2147483647u));
                    let _e508 = (_e127 + _e232);
                    if (_e213 && (select(_e505, _e502, (_e502 > _e505)) <= 1099511600000f)) {
                        let _e518 = ((_e200 & 8388607u) | (select(0u, 1u, ((_e200 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e521 = bitcast<i32>((_e200 >> bitcast<u32>(23i)));
                        let _e525 = (_e518 == 0u);
                        let _e528 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e518)), 32u, _e525)) - 8i);
                        if (_e521 == 255i) {
                            phi_934_ = 255i;
                        } else {
                            phi_934_ = (((_e521 + select(0i, 1i, (_e521 == 0i))) - _e528) + _e508);
                        }
                        let _e536 = phi_934_;
                        let _e546 = (_e536 <= 0i);
                        if _e546 {
                            phi_957_ = u32();
                        } else {
                            if _e525 {
                                phi_956_ = u32();
                            } else {
                                phi_956_ = select(((bitcast<u32>(_e536) << bitcast<u32>(23i)) | ((_e518 << bitcast<u32>(((_e528 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e536 >= 255i));
                            }
                            let _e550 = phi_956_;
                            phi_957_ = _e550;
                        }
                        let _e552 = phi_957_;
                        let _e564 = ((_e209 & 8388607u) | (select(0u, 1u, ((_e209 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e567 = bitcast<i32>((_e209 >> bitcast<u32>(23i)));
                        let _e571 = (_e564 == 0u);
                        let _e574 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e564)), 32u, _e571)) - 8i);
                        if (_e567 == 255i) {
                            phi_994_ = 255i;
                        } else {
                            phi_994_ = (((_e567 + select(0i, 1i, (_e567 == 0i))) - _e574) + _e508);
                        }
                        let _e582 = phi_994_;
                        let _e592 = (_e582 <= 0i);
                        if _e592 {
                            phi_1017_ = u32();
                        } else {
                            if _e571 {
                                phi_1016_ = u32();
                            } else {
                                phi_1016_ = select(((bitcast<u32>(_e582) << bitcast<u32>(23i)) | ((_e564 << bitcast<u32>(((_e574 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e582 >= 255i));
                            }
                            let _e596 = phi_1016_;
                            phi_1017_ = _e596;
                        }
                        let _e598 = phi_1017_;
                        phi_1025_ = bitcast<f32>(((_e208 & 2147483648u) | select(_e598, 0u, select(_e571, true, _e592))));
                        phi_1026_ = bitcast<f32>(((_e199 & 2147483648u) | select(_e552, 0u, select(_e525, true, _e546))));
                    } else {
                        phi_1025_ = 0f;
                        phi_1026_ = 1f;
                    }
                    let _e604 = phi_1025_;
                    let _e606 = phi_1026_;
                    local_7 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e99), bitcast<f32>(_e103), bitcast<f32>(_e107));
                    let _e610 = (_e251 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_10[_e610];
                    let _e614 = (_e250 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_10[_e614];
                    let _e618 = (_e252 % 3u);
                    let _e619 = (_e618 < 3u);
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e621 = local_10[_e618];
                    local_9 = array<f32, 3>(bitcast<f32>(_e111), bitcast<f32>(_e115), bitcast<f32>(_e119));
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e625 = local_9[_e610];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e627 = local_9[_e614];
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e629 = local_9[_e618];
                    phi_4020_ = false;
                    phi_3965_ = _e604;
                    phi_1162_ = ((3u * _e88) + 1u);
                    phi_1165_ = (_e606 <= _e604);
                    phi_1167_ = 0u;
                    phi_1169_ = type_52(type_44(array<f32, 3>(_e613, _e617, _e621), array<f32, 3>(_e625, _e627, _e629)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e637 = phi_4020_;
                        let _e639 = phi_3965_;
                        let _e641 = phi_1162_;
                        let _e643 = phi_1165_;
                        let _e645 = phi_1167_;
                        let _e647 = phi_1169_;
                        if _e643 {
                            phi_1180_ = true;
                        } else {
                            phi_1180_ = (_e645 > 0u);
                        }
                        let _e650 = phi_1180_;
                        if _e650 {
                            let _e651 = (_e641 > 0u);
                            if _e651 {
                                if _e643 {
                                    phi_1267_ = _e643;
                                    phi_1268_ = _e645;
                                    phi_1269_ = _e647;
                                } else {
                                    let _e652 = (_e645 - 1u);
                                    let _e653 = (_e652 % 128u);
                                    let _e654 = (_e653 < 128u);
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e656 = local_6[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e658 = local_5[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e660 = local_4[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e662 = local_3[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e665 = local_2[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e667 = local_1[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e669 = local[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4291_ = true;
                                        break;
                                    }
                                    let _e674 = local_8[_e653];
                                    phi_1267_ = (_e674 <= _e639);
                                    phi_1268_ = _e652;
                                    phi_1269_ = type_52(type_44(array<f32, 3>(_e658, _e660, _e662), array<f32, 3>(_e665, _e667, _e669)), _e656);
                                }
                                let _e677 = phi_1267_;
                                let _e679 = phi_1268_;
                                let _e681 = phi_1269_;
                                if _e677 {
                                    let _e685 = ((_e681.member_1 & 2147483648u) != 0u);
                                    if _e685 {
                                        phi_4017_ = _e637;
                                        phi_3988_ = _e639;
                                        phi_1288_ = type_4(0u, ((_e681.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e693 = phi_4017_;
                                            let _e695 = phi_3988_;
                                            let _e697 = phi_1288_;
                                            if (_e697.member < _e697.member_1) {
                                                phi_1289_ = type_4((_e697.member + 1u), _e697.member_1);
                                                phi_1312_ = type_4(1u, _e697.member);
                                            } else {
                                                phi_1289_ = _e697;
                                                phi_1312_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e710 = phi_1289_;
                                            let _e712 = phi_1312_;
                                            let _e716 = (bitcast<i32>(_e712.member) != 0i);
                                            if _e716 {
                                                let _e717 = ((_e681.member_1 & 268435455u) + _e712.member_1);
                                                let _e718 = (_e717 < arrayLength((&global_6.member)));
                                                if _e718 {
                                                    if _e718 {
                                                    } else {
                                                        phi_4199_ = _e695;
                                                        phi_4168_ = true;
                                                        break;
                                                    }
                                                    let _e721 = global_6.member[_e717].member_1;
                                                    phi_1337_ = _e721;
                                                } else {
                                                    phi_1337_ = 4294967295u;
                                                }
                                                let _e723 = phi_1337_;
                                                if _e718 {
                                                    if _e718 {
                                                    } else {
                                                        phi_4199_ = _e695;
                                                        phi_4168_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_6.member[_e717];
                                                    phi_1353_ = _e725;
                                                } else {
                                                    phi_1353_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e727 = phi_1353_;
                                                let _e739 = ((10u * _e251) & 31u);
                                                let _e742 = ((_e727.member[0] >> bitcast<u32>(_e739)) & 1023u);
                                                let _e750 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e123));
                                                let _e755 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e742)) - 8388608f) * _e750)) ^ _e123)));
                                                let _e759 = select(select(_e681.member.member_1[0], _e755, (_e755 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e742 == 1023u));
                                                let _e761 = ((10u * _e250) & 31u);
                                                let _e764 = ((_e727.member[0] >> bitcast<u32>(_e761)) & 1023u);
                                                let _e772 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e123));
                                                let _e777 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e764)) - 8388608f) * _e772)) ^ _e123)));
                                                let _e781 = select(select(_e681.member.member_1[1], _e777, (_e777 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e764 == 1023u));
                                                let _e783 = ((10u * _e252) & 31u);
                                                let _e786 = ((_e727.member[0] >> bitcast<u32>(_e783)) & 1023u);
                                                let _e794 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e123));
                                                let _e799 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e786)) - 8388608f) * _e794)) ^ _e123)));
                                                let _e803 = select(select(_e681.member.member_1[2], _e799, (_e799 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e786 == 1023u));
                                                let _e807 = ((_e727.member[1] >> bitcast<u32>(_e739)) & 1023u);
                                                let _e815 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e750)) ^ _e123)));
                                                let _e819 = select(select(_e681.member.member_1[0], _e815, (_e815 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e807 == 1023u));
                                                let _e822 = ((_e727.member[1] >> bitcast<u32>(_e761)) & 1023u);
                                                let _e830 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e822)) - 8388608f) * _e772)) ^ _e123)));
                                                let _e834 = select(select(_e681.member.member_1[1], _e830, (_e830 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e822 == 1023u));
                                                let _e837 = ((_e727.member[1] >> bitcast<u32>(_e783)) & 1023u);
                                                let _e845 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e794)) ^ _e123)));
                                                let _e849 = select(select(_e681.member.member_1[2], _e845, (_e845 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e837 == 1023u));
                                                let _e853 = ((_e727.member[2] >> bitcast<u32>(_e739)) & 1023u);
                                                let _e861 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e853)) - 8388608f) * _e750)) ^ _e123)));
                                                let _e865 = select(select(_e681.member.member_1[0], _e861, (_e861 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e853 == 1023u));
                                                let _e868 = ((_e727.member[2] >> bitcast<u32>(_e761)) & 1023u);
                                                let _e876 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e772)) ^ _e123)));
                                                let _e880 = select(select(_e681.member.member_1[1], _e876, (_e876 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e868 == 1023u));
                                                let _e883 = ((_e727.member[2] >> bitcast<u32>(_e783)) & 1023u);
                                                let _e891 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e883)) - 8388608f) * _e794)) ^ _e123)));
                                                let _e895 = select(select(_e681.member.member_1[2], _e891, (_e891 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e883 == 1023u));
                                                let _e898 = (_e803 - _e452);
                                                let _e901 = (((_e759 - _e315) * _e491) - (_e898 * _e355));
                                                let _e904 = (((_e781 - _e384) * _e491) - (_e898 * _e423));
                                                let _e907 = (_e849 - _e452);
                                                let _e910 = (((_e819 - _e315) * _e491) - (_e907 * _e355));
                                                let _e913 = (((_e834 - _e384) * _e491) - (_e907 * _e423));
                                                let _e916 = (_e895 - _e452);
                                                let _e919 = (((_e865 - _e315) * _e491) - (_e916 * _e355));
                                                let _e922 = (((_e880 - _e384) * _e491) - (_e916 * _e423));
                                                let _e923 = (_e919 * _e913);
                                                let _e924 = (_e922 * _e910);
                                                let _e925 = (_e901 * _e922);
                                                let _e926 = (_e904 * _e919);
                                                let _e927 = (_e910 * _e904);
                                                let _e928 = (_e913 * _e901);
                                                let _e933 = (((_e923 >= _e924) && (_e925 >= _e926)) && (_e927 >= _e928));
                                                if (_e933 || (((_e923 <= _e924) && (_e925 <= _e926)) && (_e927 <= _e928))) {
                                                    let _e940 = select(-1f, 1f, _e933);
                                                    let _e942 = ((_e923 - _e924) * _e940);
                                                    let _e944 = select(0f, _e942, (_e942 > 0f));
                                                    let _e946 = ((_e925 - _e926) * _e940);
                                                    let _e948 = select(0f, _e946, (_e946 > 0f));
                                                    let _e950 = ((_e927 - _e928) * _e940);
                                                    let _e952 = select(0f, _e950, (_e950 > 0f));
                                                    let _e954 = ((_e944 + _e948) + _e952);
                                                    if (_e954 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2500_ = type_18();
                                                        phi_2501_ = true;
                                                        phi_2502_ = false;
                                                    } else {
                                                        let _e957 = select(_e910, _e901, (_e901 < _e910));
                                                        if (select(_e919, _e957, (_e957 < _e919)) > 0f) {
                                                            phi_1792_ = true;
                                                        } else {
                                                            let _e962 = select(_e910, _e901, (_e901 > _e910));
                                                            phi_1792_ = (select(_e919, _e962, (_e962 > _e919)) < 0f);
                                                        }
                                                        let _e967 = phi_1792_;
                                                        if _e967 {
                                                            phi_2497_ = type_18();
                                                            phi_2498_ = true;
                                                            phi_2499_ = false;
                                                        } else {
                                                            let _e969 = select(_e913, _e904, (_e904 < _e913));
                                                            if (select(_e922, _e969, (_e969 < _e922)) > 0f) {
                                                                phi_1821_ = true;
                                                            } else {
                                                                let _e974 = select(_e913, _e904, (_e904 > _e913));
                                                                phi_1821_ = (select(_e922, _e974, (_e974 > _e922)) < 0f);
                                                            }
                                                            let _e979 = phi_1821_;
                                                            if _e979 {
                                                                phi_2495_ = type_18();
                                                                phi_2496_ = false;
                                                            } else {
                                                                let _e981 = select(_e819, _e759, (_e759 < _e819));
                                                                let _e985 = select(_e819, _e759, (_e759 > _e819));
                                                                let _e989 = select(_e834, _e781, (_e781 < _e834));
                                                                let _e993 = select(_e834, _e781, (_e781 > _e834));
                                                                let _e997 = select(_e849, _e803, (_e803 < _e849));
                                                                let _e1001 = select(_e849, _e803, (_e803 > _e849));
                                                                let _e1006 = ((select(_e865, _e981, (_e981 < _e865)) - _e353) * _e358);
                                                                let _e1007 = ((select(_e865, _e985, (_e985 > _e865)) - _e354) * _e358);
                                                                let _e1010 = ((select(_e880, _e989, (_e989 < _e880)) - _e421) * _e426);
                                                                let _e1011 = ((select(_e880, _e993, (_e993 > _e880)) - _e422) * _e426);
                                                                let _e1014 = ((select(_e895, _e997, (_e997 < _e895)) - _e489) * _e494);
                                                                let _e1015 = ((select(_e895, _e1001, (_e1001 > _e895)) - _e490) * _e494);
                                                                let _e1017 = select(_e1015, _e1014, (_e1014 < _e1015));
                                                                let _e1019 = select(_e1015, _e1014, (_e1014 > _e1015));
                                                                let _e1021 = select(_e1007, _e1006, (_e1006 < _e1007));
                                                                let _e1023 = select(_e1011, _e1010, (_e1010 < _e1011));
                                                                let _e1025 = select(_e1023, _e1021, (_e1021 > _e1023));
                                                                let _e1027 = select(_e1017, _e1025, (_e1025 > _e1017));
                                                                let _e1029 = select(_e1007, _e1006, (_e1006 > _e1007));
                                                                let _e1031 = select(_e1011, _e1010, (_e1010 > _e1011));
                                                                let _e1033 = select(_e1031, _e1029, (_e1029 < _e1031));
                                                                let _e1035 = select(_e1019, _e1033, (_e1033 < _e1019));
                                                                let _e1036 = -(_e1017);
                                                                let _e1042 = select(_e606, _e1027, (_e1027 > _e606));
                                                                if (_e1042 > (_e1035 + (select(_e1036, _e1019, (_e1019 > _e1036)) * 0.0000019073523f))) {
                                                                    phi_2490_ = type_18();
                                                                    phi_2491_ = true;
                                                                } else {
                                                                    let _e1044 = (_e1042 > _e695);
                                                                    if _e1044 {
                                                                        phi_2489_ = type_18();
                                                                    } else {
                                                                        let _e1045 = vec3<f32>(_e759, _e781, _e803);
                                                                        let _e1046 = vec3<f32>(_e819, _e834, _e849);
                                                                        let _e1047 = vec3<f32>(_e865, _e880, _e895);
                                                                        let _e1048 = (_e819 - _e759);
                                                                        let _e1049 = (_e834 - _e781);
                                                                        let _e1050 = (_e849 - _e803);
                                                                        let _e1051 = vec3<f32>(_e1048, _e1049, _e1050);
                                                                        let _e1052 = (_e865 - _e819);
                                                                        let _e1053 = (_e880 - _e834);
                                                                        let _e1054 = (_e895 - _e849);
                                                                        let _e1055 = vec3<f32>(_e1052, _e1053, _e1054);
                                                                        let _e1056 = (_e759 - _e865);
                                                                        let _e1057 = (_e781 - _e880);
                                                                        let _e1058 = (_e803 - _e895);
                                                                        let _e1059 = vec3<f32>(_e1056, _e1057, _e1058);
                                                                        let _e1062 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1065 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                                        let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
                                                                        let _e1070 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                        let _e1072 = select(_e1070, _e1067, (_e1067 > _e1070));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1078 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                                        let _e1080 = select(_e1078, _e1075, (_e1075 > _e1078));
                                                                        let _e1083 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1085 = select(_e1083, _e1080, (_e1080 > _e1083));
                                                                        let _e1088 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1091 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                                        let _e1093 = select(_e1091, _e1088, (_e1088 > _e1091));
                                                                        let _e1096 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1098 = select(_e1096, _e1093, (_e1093 > _e1096));
                                                                        let _e1100 = select(_e1085, _e1072, (_e1072 > _e1085));
                                                                        let _e1102 = select(_e1098, _e1100, (_e1100 > _e1098));
                                                                        if (_e1072 == _e1102) {
                                                                            phi_2216_ = _e913;
                                                                            phi_2217_ = _e910;
                                                                            phi_2218_ = _e904;
                                                                            phi_2219_ = _e901;
                                                                            phi_2220_ = _e1045;
                                                                            phi_2221_ = _e1059;
                                                                            phi_2222_ = _e1055;
                                                                            phi_2223_ = _e1051;
                                                                        } else {
                                                                            let _e1104 = (_e1085 == _e1102);
                                                                            let _e1109 = vec3(_e1104);
                                                                            phi_2216_ = select(_e904, _e922, _e1104);
                                                                            phi_2217_ = select(_e901, _e919, _e1104);
                                                                            phi_2218_ = select(_e922, _e913, _e1104);
                                                                            phi_2219_ = select(_e919, _e910, _e1104);
                                                                            phi_2220_ = select(_e1047, _e1046, _e1109);
                                                                            phi_2221_ = select(_e1055, _e1051, _e1109);
                                                                            phi_2222_ = select(_e1051, _e1059, _e1109);
                                                                            phi_2223_ = select(_e1059, _e1055, _e1109);
                                                                        }
                                                                        let _e1115 = phi_2216_;
                                                                        let _e1117 = phi_2217_;
                                                                        let _e1119 = phi_2218_;
                                                                        let _e1121 = phi_2219_;
                                                                        let _e1123 = phi_2220_;
                                                                        let _e1125 = phi_2221_;
                                                                        let _e1127 = phi_2222_;
                                                                        let _e1129 = phi_2223_;
                                                                        let _e1136 = ((_e1127.y * _e1125.z) - (_e1125.y * _e1127.z));
                                                                        let _e1141 = ((_e1127.z * _e1125.x) - (_e1125.z * _e1127.x));
                                                                        let _e1144 = ((_e1127.x * _e1125.y) - (_e1125.x * _e1127.y));
                                                                        if (_e944 >= _e948) {
                                                                            phi_2260_ = select(true, false, (_e944 >= _e952));
                                                                        } else {
                                                                            phi_2260_ = true;
                                                                        }
                                                                        let _e1149 = phi_2260_;
                                                                        if _e1149 {
                                                                            phi_2269_ = select(_e1047, _e1046, vec3((_e948 >= _e952)));
                                                                        } else {
                                                                            phi_2269_ = _e1045;
                                                                        }
                                                                        let _e1154 = phi_2269_;
                                                                        let _e1165 = (((_e1136 * (_e1154.x - _e315)) + (_e1141 * (_e1154.y - _e384))) + (_e1144 * (_e1154.z - _e452)));
                                                                        let _e1170 = (((_e1136 * _e355) + (_e1141 * _e423)) + (_e1144 * _e491));
                                                                        let _e1171 = (_e1117 - _e1121);
                                                                        let _e1172 = (_e1115 - _e1119);
                                                                        let _e1180 = (-(((_e1121 * _e1171) + (_e1119 * _e1172))) / ((_e1171 * _e1171) + (_e1172 * _e1172)));
                                                                        let _e1182 = select(1f, _e1180, (_e1180 < 1f));
                                                                        let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                                                        let _e1197 = ((_e1123.x + (_e1129.x * _e1184)) - _e315);
                                                                        let _e1198 = ((_e1123.y + (_e1129.y * _e1184)) - _e384);
                                                                        let _e1199 = ((_e1123.z + (_e1129.z * _e1184)) - _e452);
                                                                        let _e1200 = (_e1199 / _e491);
                                                                        let _e1212 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                        let _e1215 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                        let _e1217 = select(_e1215, _e1212, (_e1212 > _e1215));
                                                                        let _e1220 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                        let _e1222 = select(_e1220, _e1217, (_e1217 > _e1220));
                                                                        let _e1228 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                        let _e1231 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                        let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
                                                                        let _e1236 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1136 * _e1197) + (_e1141 * _e1198)) + (_e1144 * _e1199)) - _e1165)) & 2147483647u)) <= ((0.0000009536743f * select(_e1102, _e1222, (_e1222 > _e1102))) * select(_e1236, _e1233, (_e1233 > _e1236)))) {
                                                                            let _e1246 = bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u));
                                                                            let _e1249 = bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u));
                                                                            let _e1251 = select(_e1249, _e1246, (_e1246 > _e1249));
                                                                            let _e1254 = bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u));
                                                                            let _e1260 = bitcast<f32>((bitcast<u32>(_e1125.x) & 2147483647u));
                                                                            let _e1263 = bitcast<f32>((bitcast<u32>(_e1125.y) & 2147483647u));
                                                                            let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                            let _e1268 = bitcast<f32>((bitcast<u32>(_e1125.z) & 2147483647u));
                                                                            let _e1272 = (bitcast<f32>((bitcast<u32>(_e1170) & 2147483647u)) > ((0.0000038146973f * select(_e1254, _e1251, (_e1251 > _e1254))) * select(_e1268, _e1265, (_e1265 > _e1268))));
                                                                            if _e1272 {
                                                                                phi_2434_ = (_e1165 / _e1170);
                                                                            } else {
                                                                                phi_2434_ = f32();
                                                                            }
                                                                            let _e1275 = phi_2434_;
                                                                            phi_2436_ = _e1275;
                                                                            phi_2437_ = select(true, false, _e1272);
                                                                        } else {
                                                                            phi_2436_ = f32();
                                                                            phi_2437_ = true;
                                                                        }
                                                                        let _e1278 = phi_2436_;
                                                                        let _e1280 = phi_2437_;
                                                                        if _e1280 {
                                                                            let _e1288 = (((_e1136 * (_e1197 - (_e355 * _e1200))) + (_e1141 * (_e1198 - (_e423 * _e1200)))) / _e1170);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u)) <= _e1102) {
                                                                                phi_2457_ = (_e1200 + _e1288);
                                                                            } else {
                                                                                phi_2457_ = _e1200;
                                                                            }
                                                                            let _e1295 = phi_2457_;
                                                                            phi_2458_ = _e1295;
                                                                        } else {
                                                                            phi_2458_ = _e1278;
                                                                        }
                                                                        let _e1297 = phi_2458_;
                                                                        let _e1299 = select(_e1035, _e1297, (_e1297 < _e1035));
                                                                        let _e1301 = select(_e1027, _e1299, (_e1299 > _e1027));
                                                                        if (_e1301 >= _e606) {
                                                                            let _e1303 = (_e1301 <= _e695);
                                                                            if _e1303 {
                                                                                let _e1304 = (1f / _e954);
                                                                                phi_2481_ = type_18(_e1301, (_e948 * _e1304), (_e952 * _e1304), _e723);
                                                                            } else {
                                                                                phi_2481_ = type_18();
                                                                            }
                                                                            let _e1309 = phi_2481_;
                                                                            phi_2483_ = _e1309;
                                                                            phi_2484_ = select(true, false, _e1303);
                                                                        } else {
                                                                            phi_2483_ = type_18();
                                                                            phi_2484_ = true;
                                                                        }
                                                                        let _e1312 = phi_2483_;
                                                                        let _e1314 = phi_2484_;
                                                                        if _e1314 {
                                                                            phi_2488_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2488_ = _e1312;
                                                                        }
                                                                        let _e1316 = phi_2488_;
                                                                        phi_2489_ = _e1316;
                                                                    }
                                                                    let _e1318 = phi_2489_;
                                                                    phi_2490_ = _e1318;
                                                                    phi_2491_ = _e1044;
                                                                }
                                                                let _e1320 = phi_2490_;
                                                                let _e1322 = phi_2491_;
                                                                phi_2495_ = _e1320;
                                                                phi_2496_ = _e1322;
                                                            }
                                                            let _e1324 = phi_2495_;
                                                            let _e1326 = phi_2496_;
                                                            phi_2497_ = _e1324;
                                                            phi_2498_ = _e979;
                                                            phi_2499_ = _e1326;
                                                        }
                                                        let _e1328 = phi_2497_;
                                                        let _e1330 = phi_2498_;
                                                        let _e1332 = phi_2499_;
                                                        phi_2500_ = _e1328;
                                                        phi_2501_ = _e1330;
                                                        phi_2502_ = _e1332;
                                                    }
                                                    let _e1334 = phi_2500_;
                                                    let _e1336 = phi_2501_;
                                                    let _e1338 = phi_2502_;
                                                    phi_2510_ = _e1334;
                                                    phi_2511_ = select(_e1338, true, _e1336);
                                                } else {
                                                    phi_2510_ = type_18();
                                                    phi_2511_ = true;
                                                }
                                                let _e1341 = phi_2510_;
                                                let _e1343 = phi_2511_;
                                                if _e1343 {
                                                    phi_2515_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2515_ = _e1341;
                                                }
                                                let _e1345 = phi_2515_;
                                                if (_e1345.member_3 != 4294967295u) {
                                                    if (_e723 != 4294967295u) {
                                                        phi_2527_ = type_4(0u, 8u);
                                                        phi_2530_ = _e1345;
                                                        loop {
                                                            let _e1350 = phi_2527_;
                                                            let _e1352 = phi_2530_;
                                                            if (_e1350.member < _e1350.member_1) {
                                                                phi_2528_ = type_4((_e1350.member + 1u), _e1350.member_1);
                                                                phi_2553_ = type_4(1u, _e1350.member);
                                                            } else {
                                                                phi_2528_ = _e1350;
                                                                phi_2553_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1365 = phi_2528_;
                                                            let _e1367 = phi_2553_;
                                                            let _e1371 = (bitcast<i32>(_e1367.member) != 0i);
                                                            if _e1371 {
                                                                let _e1372 = (_e1367.member_1 < 8u);
                                                                if _e1372 {
                                                                } else {
                                                                    phi_3990_ = true;
                                                                    break;
                                                                }
                                                                let _e1377 = local_7[_e1367.member_1].member;
                                                                if (_e1352.member < _e1377) {
                                                                    phi_2586_ = true;
                                                                } else {
                                                                    let _e1379 = local_7[_e1367.member_1].member;
                                                                    if (_e1352.member == _e1379) {
                                                                        let _e1384 = local_7[_e1367.member_1].member_3;
                                                                        phi_2585_ = (_e1352.member_3 < _e1384);
                                                                    } else {
                                                                        phi_2585_ = false;
                                                                    }
                                                                    let _e1387 = phi_2585_;
                                                                    phi_2586_ = _e1387;
                                                                }
                                                                let _e1389 = phi_2586_;
                                                                if _e1389 {
                                                                    if _e1372 {
                                                                    } else {
                                                                        phi_3990_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1390 = local_7[_e1367.member_1];
                                                                    local_7[_e1367.member_1] = type_18(_e1352.member, _e1352.member_1, _e1352.member_2, _e1352.member_3);
                                                                    phi_2607_ = type_18(_e1390.member, _e1390.member_1, _e1390.member_2, _e1390.member_3);
                                                                } else {
                                                                    phi_2607_ = _e1352;
                                                                }
                                                                let _e1401 = phi_2607_;
                                                                phi_2531_ = _e1401;
                                                            } else {
                                                                phi_2531_ = type_18();
                                                            }
                                                            let _e1403 = phi_2531_;
                                                            continue;
                                                            continuing {
                                                                phi_2527_ = _e1365;
                                                                phi_2530_ = _e1403;
                                                                phi_3990_ = _e693;
                                                                break if !(_e1371);
                                                            }
                                                        }
                                                        let _e1406 = phi_3990_;
                                                        phi_4199_ = _e695;
                                                        phi_4168_ = _e1406;
                                                        if _e1406 {
                                                            break;
                                                        }
                                                        let _e1409 = local_7[7u].member_3;
                                                        if (_e1409 != 4294967295u) {
                                                            let _e1413 = local_7[7u].member;
                                                            phi_4290_ = _e1413;
                                                        } else {
                                                            phi_4290_ = _e695;
                                                        }
                                                        let _e1415 = phi_4290_;
                                                        phi_4289_ = _e1415;
                                                        phi_4171_ = _e1406;
                                                    } else {
                                                        phi_4289_ = _e695;
                                                        phi_4171_ = _e693;
                                                    }
                                                    let _e1417 = phi_4289_;
                                                    let _e1419 = phi_4171_;
                                                    phi_4288_ = _e1417;
                                                    phi_4170_ = _e1419;
                                                } else {
                                                    phi_4288_ = _e695;
                                                    phi_4170_ = _e693;
                                                }
                                                let _e1421 = phi_4288_;
                                                let _e1423 = phi_4170_;
                                                phi_4287_ = _e1421;
                                                phi_4169_ = _e1423;
                                            } else {
                                                phi_4287_ = _e695;
                                                phi_4169_ = _e693;
                                            }
                                            let _e1425 = phi_4287_;
                                            let _e1427 = phi_4169_;
                                            continue;
                                            continuing {
                                                phi_4017_ = _e1427;
                                                phi_3988_ = _e1425;
                                                phi_1288_ = _e710;
                                                phi_4199_ = _e1425;
                                                phi_4168_ = _e1427;
                                                break if !(_e716);
                                            }
                                        }
                                        let _e1430 = phi_4199_;
                                        let _e1432 = phi_4168_;
                                        phi_4291_ = _e1432;
                                        if _e1432 {
                                            break;
                                        }
                                        phi_4350_ = _e1432;
                                        phi_4198_ = _e1430;
                                    } else {
                                        phi_4350_ = _e637;
                                        phi_4198_ = _e639;
                                    }
                                    let _e1434 = phi_4350_;
                                    let _e1436 = phi_4198_;
                                    if _e685 {
                                        phi_3626_ = bool();
                                        phi_3627_ = u32();
                                        phi_3628_ = type_52();
                                    } else {
                                        let _e1437 = (_e681.member_1 < _e88);
                                        if _e1437 {
                                            if _e1437 {
                                            } else {
                                                phi_4291_ = true;
                                                break;
                                            }
                                            let _e1439 = global_4.member[_e681.member_1];
                                            phi_2639_ = _e1439;
                                        } else {
                                            phi_2639_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1441 = phi_2639_;
                                        let _e1456 = ((10u * _e251) & 31u);
                                        let _e1459 = ((_e1441.member[0] >> bitcast<u32>(_e1456)) & 1023u);
                                        let _e1467 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e123));
                                        let _e1472 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1459)) - 8388608f) * _e1467)) ^ _e123)));
                                        let _e1476 = select(select(_e681.member.member_1[0], _e1472, (_e1472 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1459 == 1023u));
                                        let _e1478 = ((10u * _e250) & 31u);
                                        let _e1481 = ((_e1441.member[0] >> bitcast<u32>(_e1478)) & 1023u);
                                        let _e1489 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e123));
                                        let _e1494 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1481)) - 8388608f) * _e1489)) ^ _e123)));
                                        let _e1498 = select(select(_e681.member.member_1[1], _e1494, (_e1494 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1481 == 1023u));
                                        let _e1500 = ((10u * _e252) & 31u);
                                        let _e1503 = ((_e1441.member[0] >> bitcast<u32>(_e1500)) & 1023u);
                                        let _e1511 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e123));
                                        let _e1516 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1503)) - 8388608f) * _e1511)) ^ _e123)));
                                        let _e1520 = select(select(_e681.member.member_1[2], _e1516, (_e1516 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1503 == 1023u));
                                        let _e1523 = ((_e1441.member[1] >> bitcast<u32>(_e1456)) & 1023u);
                                        let _e1531 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1523)) - 8388608f) * _e1467)) ^ _e123)));
                                        let _e1535 = select(select(_e681.member.member_1[0], _e1531, (_e1531 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1523 == 1023u));
                                        let _e1538 = ((_e1441.member[1] >> bitcast<u32>(_e1478)) & 1023u);
                                        let _e1546 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1538)) - 8388608f) * _e1489)) ^ _e123)));
                                        let _e1550 = select(select(_e681.member.member_1[1], _e1546, (_e1546 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1538 == 1023u));
                                        let _e1553 = ((_e1441.member[1] >> bitcast<u32>(_e1500)) & 1023u);
                                        let _e1561 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1553)) - 8388608f) * _e1511)) ^ _e123)));
                                        let _e1565 = select(select(_e681.member.member_1[2], _e1561, (_e1561 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1553 == 1023u));
                                        let _e1571 = ((_e1441.member_1[0] >> bitcast<u32>(_e1456)) & 1023u);
                                        let _e1579 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1571)) - 8388608f) * _e1467)) ^ _e123)));
                                        let _e1583 = select(select(_e681.member.member_1[0], _e1579, (_e1579 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1571 == 1023u));
                                        let _e1586 = ((_e1441.member_1[0] >> bitcast<u32>(_e1478)) & 1023u);
                                        let _e1594 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1586)) - 8388608f) * _e1489)) ^ _e123)));
                                        let _e1598 = select(select(_e681.member.member_1[1], _e1594, (_e1594 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1586 == 1023u));
                                        let _e1601 = ((_e1441.member_1[0] >> bitcast<u32>(_e1500)) & 1023u);
                                        let _e1609 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1601)) - 8388608f) * _e1511)) ^ _e123)));
                                        let _e1613 = select(select(_e681.member.member_1[2], _e1609, (_e1609 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1601 == 1023u));
                                        let _e1616 = ((_e1441.member_1[1] >> bitcast<u32>(_e1456)) & 1023u);
                                        let _e1624 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1616)) - 8388608f) * _e1467)) ^ _e123)));
                                        let _e1628 = select(select(_e681.member.member_1[0], _e1624, (_e1624 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1616 == 1023u));
                                        let _e1631 = ((_e1441.member_1[1] >> bitcast<u32>(_e1478)) & 1023u);
                                        let _e1639 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1631)) - 8388608f) * _e1489)) ^ _e123)));
                                        let _e1643 = select(select(_e681.member.member_1[1], _e1639, (_e1639 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1631 == 1023u));
                                        let _e1646 = ((_e1441.member_1[1] >> bitcast<u32>(_e1500)) & 1023u);
                                        let _e1654 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1646)) - 8388608f) * _e1511)) ^ _e123)));
                                        let _e1658 = select(select(_e681.member.member_1[2], _e1654, (_e1654 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1646 == 1023u));
                                        let _e1663 = type_52(type_44(array<f32, 3>(_e1476, _e1498, _e1520), array<f32, 3>(_e1535, _e1550, _e1565)), _e1441.member_2);
                                        let _e1668 = type_52(type_44(array<f32, 3>(_e1583, _e1598, _e1613), array<f32, 3>(_e1628, _e1643, _e1658)), _e1441.member_3);
                                        let _e1673 = ((_e1476 - _e353) * _e358);
                                        let _e1674 = ((_e1583 - _e353) * _e358);
                                        let _e1675 = ((_e1535 - _e354) * _e358);
                                        let _e1676 = ((_e1628 - _e354) * _e358);
                                        let _e1681 = ((_e1498 - _e421) * _e426);
                                        let _e1682 = ((_e1598 - _e421) * _e426);
                                        let _e1683 = ((_e1550 - _e422) * _e426);
                                        let _e1684 = ((_e1643 - _e422) * _e426);
                                        let _e1689 = ((_e1520 - _e489) * _e494);
                                        let _e1690 = ((_e1613 - _e489) * _e494);
                                        let _e1691 = ((_e1565 - _e490) * _e494);
                                        let _e1692 = ((_e1658 - _e490) * _e494);
                                        let _e1694 = select(_e1691, _e1689, (_e1689 < _e1691));
                                        let _e1696 = select(_e1692, _e1690, (_e1690 < _e1692));
                                        let _e1698 = select(_e1691, _e1689, (_e1689 > _e1691));
                                        let _e1700 = select(_e1692, _e1690, (_e1690 > _e1692));
                                        let _e1702 = select(_e1675, _e1673, (_e1673 < _e1675));
                                        let _e1704 = select(_e1676, _e1674, (_e1674 < _e1676));
                                        let _e1706 = select(_e1683, _e1681, (_e1681 < _e1683));
                                        let _e1708 = select(_e1684, _e1682, (_e1682 < _e1684));
                                        let _e1710 = select(_e1706, _e1702, (_e1702 > _e1706));
                                        let _e1712 = select(_e1708, _e1704, (_e1704 > _e1708));
                                        let _e1714 = select(_e1694, _e1710, (_e1710 > _e1694));
                                        let _e1716 = select(_e1696, _e1712, (_e1712 > _e1696));
                                        let _e1718 = select(_e1675, _e1673, (_e1673 > _e1675));
                                        let _e1720 = select(_e1676, _e1674, (_e1674 > _e1676));
                                        let _e1722 = select(_e1683, _e1681, (_e1681 > _e1683));
                                        let _e1724 = select(_e1684, _e1682, (_e1682 > _e1684));
                                        let _e1726 = select(_e1722, _e1718, (_e1718 < _e1722));
                                        let _e1728 = select(_e1724, _e1720, (_e1720 < _e1724));
                                        let _e1733 = -(_e1694);
                                        let _e1734 = -(_e1696);
                                        let _e1741 = (select(_e1698, _e1726, (_e1726 < _e1698)) + (select(_e1733, _e1698, (_e1698 > _e1733)) * 0.0000019073523f));
                                        let _e1742 = (select(_e1700, _e1728, (_e1728 < _e1700)) + (select(_e1734, _e1700, (_e1700 > _e1734)) * 0.0000019073523f));
                                        let _e1744 = select(_e606, _e1714, (_e1714 > _e606));
                                        let _e1746 = select(_e606, _e1716, (_e1716 > _e606));
                                        let _e1751 = (_e1744 <= select(_e1436, _e1741, (_e1741 < _e1436)));
                                        let _e1752 = (_e1746 <= select(_e1436, _e1742, (_e1742 < _e1436)));
                                        let _e1753 = (_e1744 <= _e1746);
                                        if _e1751 {
                                            if _e1752 {
                                                if _e1753 {
                                                    phi_3526_ = _e1668;
                                                } else {
                                                    phi_3526_ = _e1663;
                                                }
                                                let _e1755 = phi_3526_;
                                                let _e1762 = (_e679 % 128u);
                                                let _e1763 = (_e1762 < 128u);
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_6[_e1762] = _e1755.member_1;
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_5[_e1762] = _e1755.member.member[0];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_4[_e1762] = _e1755.member.member[1];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_3[_e1762] = _e1755.member.member[2];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_2[_e1762] = _e1755.member.member_1[0];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_1[_e1762] = _e1755.member.member_1[1];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local[_e1762] = _e1755.member.member_1[2];
                                                if _e1763 {
                                                } else {
                                                    phi_4291_ = true;
                                                    break;
                                                }
                                                local_8[_e1762] = select(_e1744, _e1746, _e1753);
                                                if _e1753 {
                                                    phi_3602_ = _e1663;
                                                } else {
                                                    phi_3602_ = _e1668;
                                                }
                                                let _e1780 = phi_3602_;
                                                phi_3603_ = (_e679 + 1u);
                                                phi_3604_ = _e1780;
                                            } else {
                                                phi_3603_ = u32();
                                                phi_3604_ = type_52();
                                            }
                                            let _e1782 = phi_3603_;
                                            let _e1784 = phi_3604_;
                                            phi_3606_ = _e1782;
                                            phi_3607_ = _e1784;
                                            phi_3608_ = select(true, false, _e1752);
                                        } else {
                                            phi_3606_ = u32();
                                            phi_3607_ = type_52();
                                            phi_3608_ = true;
                                        }
                                        let _e1787 = phi_3606_;
                                        let _e1789 = phi_3607_;
                                        let _e1791 = phi_3608_;
                                        if _e1791 {
                                            if _e1751 {
                                                phi_3615_ = _e1663;
                                            } else {
                                                phi_3615_ = _e1668;
                                            }
                                            let _e1793 = phi_3615_;
                                            phi_3620_ = select(_e1752, true, _e1751);
                                            phi_3622_ = _e1793;
                                        } else {
                                            phi_3620_ = _e677;
                                            phi_3622_ = _e1789;
                                        }
                                        let _e1796 = phi_3620_;
                                        let _e1798 = phi_3622_;
                                        phi_3626_ = _e1796;
                                        phi_3627_ = select(_e1787, _e679, _e1791);
                                        phi_3628_ = _e1798;
                                    }
                                    let _e1801 = phi_3626_;
                                    let _e1803 = phi_3627_;
                                    let _e1805 = phi_3628_;
                                    if _e685 {
                                        phi_3638_ = _e681;
                                    } else {
                                        phi_3638_ = _e1805;
                                    }
                                    let _e1807 = phi_3638_;
                                    phi_4377_ = _e1436;
                                    phi_4294_ = _e1434;
                                    phi_3639_ = (_e641 - 1u);
                                    phi_3640_ = select(_e1801, false, _e685);
                                    phi_3641_ = select(_e1803, _e679, _e685);
                                    phi_3642_ = _e1807;
                                } else {
                                    phi_4377_ = _e639;
                                    phi_4294_ = _e637;
                                    phi_3639_ = _e641;
                                    phi_3640_ = _e677;
                                    phi_3641_ = _e679;
                                    phi_3642_ = _e681;
                                }
                                let _e1811 = phi_4377_;
                                let _e1813 = phi_4294_;
                                let _e1815 = phi_3639_;
                                let _e1817 = phi_3640_;
                                let _e1819 = phi_3641_;
                                let _e1821 = phi_3642_;
                                phi_4376_ = _e1811;
                                phi_4293_ = _e1813;
                                phi_3643_ = _e1815;
                                phi_3644_ = _e1817;
                                phi_3645_ = _e1819;
                                phi_3646_ = _e1821;
                            } else {
                                phi_4376_ = _e639;
                                phi_4293_ = _e637;
                                phi_3643_ = u32();
                                phi_3644_ = bool();
                                phi_3645_ = u32();
                                phi_3646_ = type_52();
                            }
                            let _e1823 = phi_4376_;
                            let _e1825 = phi_4293_;
                            let _e1827 = phi_3643_;
                            let _e1829 = phi_3644_;
                            let _e1831 = phi_3645_;
                            let _e1833 = phi_3646_;
                            phi_4375_ = _e1823;
                            phi_4292_ = _e1825;
                            phi_1163_ = _e1827;
                            phi_1166_ = _e1829;
                            phi_1168_ = _e1831;
                            phi_1170_ = _e1833;
                            phi_3647_ = _e651;
                        } else {
                            phi_4375_ = _e639;
                            phi_4292_ = _e637;
                            phi_1163_ = u32();
                            phi_1166_ = bool();
                            phi_1168_ = u32();
                            phi_1170_ = type_52();
                            phi_3647_ = false;
                        }
                        let _e1835 = phi_4375_;
                        let _e1837 = phi_4292_;
                        let _e1839 = phi_1163_;
                        let _e1841 = phi_1166_;
                        let _e1843 = phi_1168_;
                        let _e1845 = phi_1170_;
                        let _e1847 = phi_3647_;
                        continue;
                        continuing {
                            phi_4020_ = _e1837;
                            phi_3965_ = _e1835;
                            phi_1162_ = _e1839;
                            phi_1165_ = _e1841;
                            phi_1167_ = _e1843;
                            phi_1169_ = _e1845;
                            phi_4291_ = _e1837;
                            break if !(_e1847);
                        }
                    }
                    let _e1850 = phi_4291_;
                    if _e1850 {
                        break;
                    }
                    phi_3654_ = type_4(0u, 8u);
                    loop {
                        let _e1852 = phi_3654_;
                        if (_e1852.member < _e1852.member_1) {
                            phi_3655_ = type_4((_e1852.member + 1u), _e1852.member_1);
                            phi_3678_ = type_4(1u, _e1852.member);
                        } else {
                            phi_3655_ = _e1852;
                            phi_3678_ = type_4(0u, type_4().member_1);
                        }
                        let _e1865 = phi_3655_;
                        let _e1867 = phi_3678_;
                        let _e1871 = (bitcast<i32>(_e1867.member) != 0i);
                        if _e1871 {
                            let _e1872 = (_e1867.member_1 < 8u);
                            if _e1872 {
                            } else {
                                phi_4357_ = true;
                                break;
                            }
                            let _e1874 = local_7[_e1867.member_1];
                            if (_e1874.member_3 != 4294967295u) {
                                let _e1880 = -(_e508);
                                let _e1881 = bitcast<u32>(_e1874.member);
                                let _e1885 = (bitcast<i32>((_e1881 >> bitcast<u32>(23i))) & 255i);
                                let _e1886 = (_e1885 + _e1880);
                                if (_e1885 == 255i) {
                                    phi_3751_ = _e1874.member;
                                } else {
                                    if (_e1885 > 0i) {
                                        if (_e1886 > 0i) {
                                            let _e1890 = (_e1886 < 255i);
                                            if _e1890 {
                                                phi_3730_ = bitcast<f32>((_e1881 + bitcast<u32>((_e1880 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3730_ = f32();
                                            }
                                            let _e1897 = phi_3730_;
                                            phi_3732_ = _e1897;
                                            phi_3733_ = select(true, false, _e1890);
                                        } else {
                                            phi_3732_ = f32();
                                            phi_3733_ = true;
                                        }
                                        let _e1900 = phi_3732_;
                                        let _e1902 = phi_3733_;
                                        phi_3734_ = _e1900;
                                        phi_3735_ = _e1902;
                                    } else {
                                        phi_3734_ = f32();
                                        phi_3735_ = true;
                                    }
                                    let _e1904 = phi_3734_;
                                    let _e1906 = phi_3735_;
                                    if _e1906 {
                                        let _e1907 = (_e1881 & 2147483648u);
                                        let _e1914 = ((_e1881 & 8388607u) | (select(0u, 1u, ((_e1881 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1918 = (_e1914 == 0u);
                                        if _e1918 {
                                            phi_3924_ = bitcast<f32>(_e1907);
                                        } else {
                                            let _e1923 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1914)), 32u, _e1918) - 8u);
                                            let _e1926 = (_e1914 << bitcast<u32>((_e1923 & 31u)));
                                            let _e1928 = ((_e1886 + select(0i, 1i, (_e1885 == 0i))) - bitcast<i32>(_e1923));
                                            if (_e1928 >= 255i) {
                                                phi_3914_ = bitcast<f32>((_e1907 | 2139095040u));
                                                phi_3915_ = f32();
                                                phi_3916_ = true;
                                            } else {
                                                let _e1930 = (_e1928 > 0i);
                                                if _e1930 {
                                                    phi_3908_ = bitcast<f32>(((_e1907 | (bitcast<u32>(_e1928) << bitcast<u32>(23i))) | (_e1926 & 8388607u)));
                                                    phi_3909_ = f32();
                                                } else {
                                                    if (_e1928 < -24i) {
                                                        phi_3874_ = 26u;
                                                    } else {
                                                        phi_3874_ = bitcast<u32>((1i - _e1928));
                                                    }
                                                    let _e1935 = phi_3874_;
                                                    let _e1936 = (_e1935 & 31u);
                                                    let _e1938 = (_e1926 >> bitcast<u32>(_e1936));
                                                    let _e1942 = (_e1926 & ((1u << bitcast<u32>(_e1936)) - 1u));
                                                    let _e1946 = (1u << bitcast<u32>(((_e1935 - 1u) & 31u)));
                                                    if (_e1942 > _e1946) {
                                                        phi_3895_ = true;
                                                    } else {
                                                        if (_e1942 == _e1946) {
                                                            phi_3892_ = ((_e1938 & 1u) == 1u);
                                                        } else {
                                                            phi_3892_ = false;
                                                        }
                                                        let _e1952 = phi_3892_;
                                                        phi_3895_ = _e1952;
                                                    }
                                                    let _e1954 = phi_3895_;
                                                    phi_3908_ = f32();
                                                    phi_3909_ = bitcast<f32>((_e1907 | (_e1938 + select(0u, 1u, _e1954))));
                                                }
                                                let _e1967 = phi_3908_;
                                                let _e1969 = phi_3909_;
                                                phi_3914_ = _e1967;
                                                phi_3915_ = _e1969;
                                                phi_3916_ = _e1930;
                                            }
                                            let _e1973 = phi_3914_;
                                            let _e1975 = phi_3915_;
                                            let _e1977 = phi_3916_;
                                            phi_3924_ = select(_e1975, _e1973, _e1977);
                                        }
                                        let _e1981 = phi_3924_;
                                        phi_3750_ = _e1981;
                                    } else {
                                        phi_3750_ = _e1904;
                                    }
                                    let _e1983 = phi_3750_;
                                    phi_3751_ = _e1983;
                                }
                                let _e1985 = phi_3751_;
                                let _e1986 = bitcast<u32>(_e1985);
                                if ((_e1986 & 2147483647u) >= 2139095040u) {
                                    phi_3763_ = bitcast<f32>(((_e1986 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3763_ = _e1985;
                                }
                                let _e1993 = phi_3763_;
                                phi_3768_ = type_18(_e1993, _e1874.member_1, _e1874.member_2, _e1874.member_3);
                            } else {
                                phi_3768_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1996 = phi_3768_;
                            if _e1872 {
                            } else {
                                phi_4357_ = true;
                                break;
                            }
                            local_7[_e1867.member_1] = type_18(_e1996.member, _e1996.member_1, _e1996.member_2, _e1996.member_3);
                        }
                        continue;
                        continuing {
                            phi_3654_ = _e1865;
                            phi_4357_ = _e1850;
                            break if !(_e1871);
                        }
                    }
                    let _e2004 = phi_4357_;
                    if _e2004 {
                        break;
                    }
                    let _e2005 = local_7;
                    if _e139 {
                    } else {
                        break;
                    }
                    global_5.member[_e137] = array<type_18, 8>(type_18(_e2005[0].member, _e2005[0].member_1, _e2005[0].member_2, _e2005[0].member_3), type_18(_e2005[1].member, _e2005[1].member_1, _e2005[1].member_2, _e2005[1].member_3), type_18(_e2005[2].member, _e2005[2].member_1, _e2005[2].member_2, _e2005[2].member_3), type_18(_e2005[3].member, _e2005[3].member_1, _e2005[3].member_2, _e2005[3].member_3), type_18(_e2005[4].member, _e2005[4].member_1, _e2005[4].member_2, _e2005[4].member_3), type_18(_e2005[5].member, _e2005[5].member_1, _e2005[5].member_2, _e2005[5].member_3), type_18(_e2005[6].member, _e2005[6].member_1, _e2005[6].member_2, _e2005[6].member_3), type_18(_e2005[7].member, _e2005[7].member_1, _e2005[7].member_2, _e2005[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
