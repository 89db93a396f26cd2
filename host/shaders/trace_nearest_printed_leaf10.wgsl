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
    var phi_4043_: bool;
    var phi_3964_: f32;
    var phi_1164_: bool;
    var phi_1167_: u32;
    var phi_1169_: u32;
    var phi_1171_: type_52;
    var phi_1182_: bool;
    var phi_1269_: bool;
    var phi_1270_: u32;
    var phi_1271_: type_52;
    var phi_2646_: type_39;
    var phi_3533_: type_52;
    var phi_3610_: type_52;
    var phi_3611_: u32;
    var phi_3612_: type_52;
    var phi_3614_: u32;
    var phi_3615_: type_52;
    var phi_3616_: bool;
    var phi_3623_: type_52;
    var phi_3628_: bool;
    var phi_3630_: type_52;
    var phi_4040_: bool;
    var phi_4012_: f32;
    var phi_1290_: type_4;
    var phi_1291_: type_4;
    var phi_1314_: type_4;
    var phi_1339_: u32;
    var phi_1355_: type_46;
    var phi_1794_: bool;
    var phi_1823_: bool;
    var phi_2218_: f32;
    var phi_2219_: f32;
    var phi_2220_: f32;
    var phi_2221_: f32;
    var phi_2222_: vec3<f32>;
    var phi_2223_: vec3<f32>;
    var phi_2224_: vec3<f32>;
    var phi_2225_: vec3<f32>;
    var phi_2262_: bool;
    var phi_2271_: vec3<f32>;
    var phi_2436_: f32;
    var phi_2438_: f32;
    var phi_2439_: bool;
    var phi_2459_: f32;
    var phi_2460_: f32;
    var phi_2483_: type_18;
    var phi_2485_: type_18;
    var phi_2486_: bool;
    var phi_2490_: type_18;
    var phi_2491_: type_18;
    var phi_2492_: type_18;
    var phi_2493_: bool;
    var phi_2497_: type_18;
    var phi_2498_: bool;
    var phi_2499_: type_18;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var phi_2502_: type_18;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2512_: type_18;
    var phi_2513_: bool;
    var phi_2517_: type_18;
    var phi_2529_: type_4;
    var phi_2532_: type_18;
    var phi_2530_: type_4;
    var phi_2555_: type_4;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2609_: type_18;
    var phi_2533_: type_18;
    var phi_4013_: bool;
    var phi_4407_: f32;
    var phi_4406_: f32;
    var phi_4194_: bool;
    var phi_4405_: f32;
    var phi_4193_: bool;
    var phi_4404_: f32;
    var phi_4192_: bool;
    var phi_4316_: f32;
    var phi_4191_: bool;
    var phi_4281_: f32;
    var phi_4200_: bool;
    var phi_3634_: bool;
    var phi_3635_: u32;
    var phi_3636_: type_52;
    var phi_4280_: f32;
    var phi_4199_: bool;
    var phi_3637_: bool;
    var phi_3638_: u32;
    var phi_3639_: u32;
    var phi_3640_: type_52;
    var phi_4279_: f32;
    var phi_4198_: bool;
    var phi_3641_: bool;
    var phi_3642_: u32;
    var phi_3643_: u32;
    var phi_3644_: type_52;
    var phi_4278_: f32;
    var phi_4197_: bool;
    var phi_1165_: bool;
    var phi_1168_: u32;
    var phi_1170_: u32;
    var phi_1172_: type_52;
    var phi_3645_: bool;
    var phi_4196_: bool;
    var phi_3652_: type_4;
    var phi_3653_: type_4;
    var phi_3676_: type_4;
    var phi_3728_: f32;
    var phi_3730_: f32;
    var phi_3731_: bool;
    var phi_3732_: f32;
    var phi_3733_: bool;
    var phi_3872_: u32;
    var phi_3890_: bool;
    var phi_3893_: bool;
    var phi_3906_: f32;
    var phi_3907_: f32;
    var phi_3912_: f32;
    var phi_3913_: f32;
    var phi_3914_: bool;
    var phi_3922_: f32;
    var phi_3748_: f32;
    var phi_3749_: f32;
    var phi_3761_: f32;
    var phi_3766_: type_18;
    var phi_4260_: bool;

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
                    phi_4043_ = false;
                    phi_3964_ = _e604;
                    phi_1164_ = (_e606 <= _e604);
                    phi_1167_ = ((3u * _e88) + 1u);
                    phi_1169_ = 0u;
                    phi_1171_ = type_52(type_44(array<f32, 3>(_e613, _e617, _e621), array<f32, 3>(_e625, _e627, _e629)), select(0u, 2147483648u, (_e88 == 0u)));
                    loop {
                        let _e637 = phi_4043_;
                        let _e639 = phi_3964_;
                        let _e641 = phi_1164_;
                        let _e643 = phi_1167_;
                        let _e645 = phi_1169_;
                        let _e647 = phi_1171_;
                        if _e641 {
                            phi_1182_ = true;
                        } else {
                            phi_1182_ = (_e645 > 0u);
                        }
                        let _e650 = phi_1182_;
                        if _e650 {
                            let _e651 = (_e643 > 0u);
                            if _e651 {
                                if _e641 {
                                    phi_1269_ = _e641;
                                    phi_1270_ = _e645;
                                    phi_1271_ = _e647;
                                } else {
                                    let _e652 = (_e645 - 1u);
                                    let _e653 = (_e652 % 128u);
                                    let _e654 = (_e653 < 128u);
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e656 = local_6[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e658 = local_5[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e660 = local_4[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e662 = local_3[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e665 = local_2[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e667 = local_1[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e669 = local[_e653];
                                    if _e654 {
                                    } else {
                                        phi_4196_ = true;
                                        break;
                                    }
                                    let _e674 = local_8[_e653];
                                    phi_1269_ = (_e674 <= _e639);
                                    phi_1270_ = _e652;
                                    phi_1271_ = type_52(type_44(array<f32, 3>(_e658, _e660, _e662), array<f32, 3>(_e665, _e667, _e669)), _e656);
                                }
                                let _e677 = phi_1269_;
                                let _e679 = phi_1270_;
                                let _e681 = phi_1271_;
                                if _e677 {
                                    if ((_e681.member_1 & 2147483648u) != 0u) {
                                        phi_4040_ = _e637;
                                        phi_4012_ = _e639;
                                        phi_1290_ = type_4(0u, ((_e681.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1057 = phi_4040_;
                                            let _e1059 = phi_4012_;
                                            let _e1061 = phi_1290_;
                                            if (_e1061.member < _e1061.member_1) {
                                                phi_1291_ = type_4((_e1061.member + 1u), _e1061.member_1);
                                                phi_1314_ = type_4(1u, _e1061.member);
                                            } else {
                                                phi_1291_ = _e1061;
                                                phi_1314_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1074 = phi_1291_;
                                            let _e1076 = phi_1314_;
                                            let _e1080 = (bitcast<i32>(_e1076.member) != 0i);
                                            if _e1080 {
                                                let _e1081 = ((_e681.member_1 & 268435455u) + _e1076.member_1);
                                                let _e1082 = (_e1081 < arrayLength((&global_6.member)));
                                                if _e1082 {
                                                    if _e1082 {
                                                    } else {
                                                        phi_4316_ = _e1059;
                                                        phi_4191_ = true;
                                                        break;
                                                    }
                                                    let _e1085 = global_6.member[_e1081].member_1;
                                                    phi_1339_ = _e1085;
                                                } else {
                                                    phi_1339_ = 4294967295u;
                                                }
                                                let _e1087 = phi_1339_;
                                                if _e1082 {
                                                    if _e1082 {
                                                    } else {
                                                        phi_4316_ = _e1059;
                                                        phi_4191_ = true;
                                                        break;
                                                    }
                                                    let _e1089 = global_6.member[_e1081];
                                                    phi_1355_ = _e1089;
                                                } else {
                                                    phi_1355_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1091 = phi_1355_;
                                                let _e1103 = ((10u * _e251) & 31u);
                                                let _e1106 = ((_e1091.member[0] >> bitcast<u32>(_e1103)) & 1023u);
                                                let _e1114 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e123));
                                                let _e1119 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1106)) - 8388608f) * _e1114)) ^ _e123)));
                                                let _e1123 = select(select(_e681.member.member_1[0], _e1119, (_e1119 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1106 == 1023u));
                                                let _e1125 = ((10u * _e250) & 31u);
                                                let _e1128 = ((_e1091.member[0] >> bitcast<u32>(_e1125)) & 1023u);
                                                let _e1136 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e123));
                                                let _e1141 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1128)) - 8388608f) * _e1136)) ^ _e123)));
                                                let _e1145 = select(select(_e681.member.member_1[1], _e1141, (_e1141 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1128 == 1023u));
                                                let _e1147 = ((10u * _e252) & 31u);
                                                let _e1150 = ((_e1091.member[0] >> bitcast<u32>(_e1147)) & 1023u);
                                                let _e1158 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e123));
                                                let _e1163 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1150)) - 8388608f) * _e1158)) ^ _e123)));
                                                let _e1167 = select(select(_e681.member.member_1[2], _e1163, (_e1163 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1150 == 1023u));
                                                let _e1171 = ((_e1091.member[1] >> bitcast<u32>(_e1103)) & 1023u);
                                                let _e1179 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1171)) - 8388608f) * _e1114)) ^ _e123)));
                                                let _e1183 = select(select(_e681.member.member_1[0], _e1179, (_e1179 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1171 == 1023u));
                                                let _e1186 = ((_e1091.member[1] >> bitcast<u32>(_e1125)) & 1023u);
                                                let _e1194 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1186)) - 8388608f) * _e1136)) ^ _e123)));
                                                let _e1198 = select(select(_e681.member.member_1[1], _e1194, (_e1194 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1186 == 1023u));
                                                let _e1201 = ((_e1091.member[1] >> bitcast<u32>(_e1147)) & 1023u);
                                                let _e1209 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1201)) - 8388608f) * _e1158)) ^ _e123)));
                                                let _e1213 = select(select(_e681.member.member_1[2], _e1209, (_e1209 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1201 == 1023u));
                                                let _e1217 = ((_e1091.member[2] >> bitcast<u32>(_e1103)) & 1023u);
                                                let _e1225 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1217)) - 8388608f) * _e1114)) ^ _e123)));
                                                let _e1229 = select(select(_e681.member.member_1[0], _e1225, (_e1225 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e1217 == 1023u));
                                                let _e1232 = ((_e1091.member[2] >> bitcast<u32>(_e1125)) & 1023u);
                                                let _e1240 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1232)) - 8388608f) * _e1136)) ^ _e123)));
                                                let _e1244 = select(select(_e681.member.member_1[1], _e1240, (_e1240 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e1232 == 1023u));
                                                let _e1247 = ((_e1091.member[2] >> bitcast<u32>(_e1147)) & 1023u);
                                                let _e1255 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1247)) - 8388608f) * _e1158)) ^ _e123)));
                                                let _e1259 = select(select(_e681.member.member_1[2], _e1255, (_e1255 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e1247 == 1023u));
                                                let _e1262 = (_e1167 - _e452);
                                                let _e1265 = (((_e1123 - _e315) * _e491) - (_e1262 * _e355));
                                                let _e1268 = (((_e1145 - _e384) * _e491) - (_e1262 * _e423));
                                                let _e1271 = (_e1213 - _e452);
                                                let _e1274 = (((_e1183 - _e315) * _e491) - (_e1271 * _e355));
                                                let _e1277 = (((_e1198 - _e384) * _e491) - (_e1271 * _e423));
                                                let _e1280 = (_e1259 - _e452);
                                                let _e1283 = (((_e1229 - _e315) * _e491) - (_e1280 * _e355));
                                                let _e1286 = (((_e1244 - _e384) * _e491) - (_e1280 * _e423));
                                                let _e1287 = (_e1283 * _e1277);
                                                let _e1288 = (_e1286 * _e1274);
                                                let _e1289 = (_e1265 * _e1286);
                                                let _e1290 = (_e1268 * _e1283);
                                                let _e1291 = (_e1274 * _e1268);
                                                let _e1292 = (_e1277 * _e1265);
                                                let _e1297 = (((_e1287 >= _e1288) && (_e1289 >= _e1290)) && (_e1291 >= _e1292));
                                                if (_e1297 || (((_e1287 <= _e1288) && (_e1289 <= _e1290)) && (_e1291 <= _e1292))) {
                                                    let _e1304 = select(-1f, 1f, _e1297);
                                                    let _e1306 = ((_e1287 - _e1288) * _e1304);
                                                    let _e1308 = select(0f, _e1306, (_e1306 > 0f));
                                                    let _e1310 = ((_e1289 - _e1290) * _e1304);
                                                    let _e1312 = select(0f, _e1310, (_e1310 > 0f));
                                                    let _e1314 = ((_e1291 - _e1292) * _e1304);
                                                    let _e1316 = select(0f, _e1314, (_e1314 > 0f));
                                                    let _e1318 = ((_e1308 + _e1312) + _e1316);
                                                    if (_e1318 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2502_ = type_18();
                                                        phi_2503_ = true;
                                                        phi_2504_ = false;
                                                    } else {
                                                        let _e1321 = select(_e1274, _e1265, (_e1265 < _e1274));
                                                        if (select(_e1283, _e1321, (_e1321 < _e1283)) > 0f) {
                                                            phi_1794_ = true;
                                                        } else {
                                                            let _e1326 = select(_e1274, _e1265, (_e1265 > _e1274));
                                                            phi_1794_ = (select(_e1283, _e1326, (_e1326 > _e1283)) < 0f);
                                                        }
                                                        let _e1331 = phi_1794_;
                                                        if _e1331 {
                                                            phi_2499_ = type_18();
                                                            phi_2500_ = true;
                                                            phi_2501_ = false;
                                                        } else {
                                                            let _e1333 = select(_e1277, _e1268, (_e1268 < _e1277));
                                                            if (select(_e1286, _e1333, (_e1333 < _e1286)) > 0f) {
                                                                phi_1823_ = true;
                                                            } else {
                                                                let _e1338 = select(_e1277, _e1268, (_e1268 > _e1277));
                                                                phi_1823_ = (select(_e1286, _e1338, (_e1338 > _e1286)) < 0f);
                                                            }
                                                            let _e1343 = phi_1823_;
                                                            if _e1343 {
                                                                phi_2497_ = type_18();
                                                                phi_2498_ = false;
                                                            } else {
                                                                let _e1345 = select(_e1183, _e1123, (_e1123 < _e1183));
                                                                let _e1349 = select(_e1183, _e1123, (_e1123 > _e1183));
                                                                let _e1353 = select(_e1198, _e1145, (_e1145 < _e1198));
                                                                let _e1357 = select(_e1198, _e1145, (_e1145 > _e1198));
                                                                let _e1361 = select(_e1213, _e1167, (_e1167 < _e1213));
                                                                let _e1365 = select(_e1213, _e1167, (_e1167 > _e1213));
                                                                let _e1370 = ((select(_e1229, _e1345, (_e1345 < _e1229)) - _e353) * _e358);
                                                                let _e1371 = ((select(_e1229, _e1349, (_e1349 > _e1229)) - _e354) * _e358);
                                                                let _e1374 = ((select(_e1244, _e1353, (_e1353 < _e1244)) - _e421) * _e426);
                                                                let _e1375 = ((select(_e1244, _e1357, (_e1357 > _e1244)) - _e422) * _e426);
                                                                let _e1378 = ((select(_e1259, _e1361, (_e1361 < _e1259)) - _e489) * _e494);
                                                                let _e1379 = ((select(_e1259, _e1365, (_e1365 > _e1259)) - _e490) * _e494);
                                                                let _e1381 = select(_e1379, _e1378, (_e1378 < _e1379));
                                                                let _e1383 = select(_e1379, _e1378, (_e1378 > _e1379));
                                                                let _e1385 = select(_e1371, _e1370, (_e1370 < _e1371));
                                                                let _e1387 = select(_e1375, _e1374, (_e1374 < _e1375));
                                                                let _e1389 = select(_e1387, _e1385, (_e1385 > _e1387));
                                                                let _e1391 = select(_e1381, _e1389, (_e1389 > _e1381));
                                                                let _e1393 = select(_e1371, _e1370, (_e1370 > _e1371));
                                                                let _e1395 = select(_e1375, _e1374, (_e1374 > _e1375));
                                                                let _e1397 = select(_e1395, _e1393, (_e1393 < _e1395));
                                                                let _e1399 = select(_e1383, _e1397, (_e1397 < _e1383));
                                                                let _e1400 = -(_e1381);
                                                                let _e1406 = select(_e606, _e1391, (_e1391 > _e606));
                                                                if (_e1406 > (_e1399 + (select(_e1400, _e1383, (_e1383 > _e1400)) * 0.0000019073523f))) {
                                                                    phi_2492_ = type_18();
                                                                    phi_2493_ = true;
                                                                } else {
                                                                    let _e1408 = (_e1406 > _e1059);
                                                                    if _e1408 {
                                                                        phi_2491_ = type_18();
                                                                    } else {
                                                                        let _e1409 = vec3<f32>(_e1123, _e1145, _e1167);
                                                                        let _e1410 = vec3<f32>(_e1183, _e1198, _e1213);
                                                                        let _e1411 = vec3<f32>(_e1229, _e1244, _e1259);
                                                                        let _e1412 = (_e1183 - _e1123);
                                                                        let _e1413 = (_e1198 - _e1145);
                                                                        let _e1414 = (_e1213 - _e1167);
                                                                        let _e1415 = vec3<f32>(_e1412, _e1413, _e1414);
                                                                        let _e1416 = (_e1229 - _e1183);
                                                                        let _e1417 = (_e1244 - _e1198);
                                                                        let _e1418 = (_e1259 - _e1213);
                                                                        let _e1419 = vec3<f32>(_e1416, _e1417, _e1418);
                                                                        let _e1420 = (_e1123 - _e1229);
                                                                        let _e1421 = (_e1145 - _e1244);
                                                                        let _e1422 = (_e1167 - _e1259);
                                                                        let _e1423 = vec3<f32>(_e1420, _e1421, _e1422);
                                                                        let _e1426 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                                        let _e1429 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                                        let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                                                        let _e1434 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                                        let _e1436 = select(_e1434, _e1431, (_e1431 > _e1434));
                                                                        let _e1439 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1455 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                                        let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                        let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                                        let _e1464 = select(_e1449, _e1436, (_e1436 > _e1449));
                                                                        let _e1466 = select(_e1462, _e1464, (_e1464 > _e1462));
                                                                        if (_e1436 == _e1466) {
                                                                            phi_2218_ = _e1277;
                                                                            phi_2219_ = _e1274;
                                                                            phi_2220_ = _e1268;
                                                                            phi_2221_ = _e1265;
                                                                            phi_2222_ = _e1409;
                                                                            phi_2223_ = _e1423;
                                                                            phi_2224_ = _e1419;
                                                                            phi_2225_ = _e1415;
                                                                        } else {
                                                                            let _e1468 = (_e1449 == _e1466);
                                                                            let _e1473 = vec3(_e1468);
                                                                            phi_2218_ = select(_e1268, _e1286, _e1468);
                                                                            phi_2219_ = select(_e1265, _e1283, _e1468);
                                                                            phi_2220_ = select(_e1286, _e1277, _e1468);
                                                                            phi_2221_ = select(_e1283, _e1274, _e1468);
                                                                            phi_2222_ = select(_e1411, _e1410, _e1473);
                                                                            phi_2223_ = select(_e1419, _e1415, _e1473);
                                                                            phi_2224_ = select(_e1415, _e1423, _e1473);
                                                                            phi_2225_ = select(_e1423, _e1419, _e1473);
                                                                        }
                                                                        let _e1479 = phi_2218_;
                                                                        let _e1481 = phi_2219_;
                                                                        let _e1483 = phi_2220_;
                                                                        let _e1485 = phi_2221_;
                                                                        let _e1487 = phi_2222_;
                                                                        let _e1489 = phi_2223_;
                                                                        let _e1491 = phi_2224_;
                                                                        let _e1493 = phi_2225_;
                                                                        let _e1500 = ((_e1491.y * _e1489.z) - (_e1489.y * _e1491.z));
                                                                        let _e1505 = ((_e1491.z * _e1489.x) - (_e1489.z * _e1491.x));
                                                                        let _e1508 = ((_e1491.x * _e1489.y) - (_e1489.x * _e1491.y));
                                                                        if (_e1308 >= _e1312) {
                                                                            phi_2262_ = select(true, false, (_e1308 >= _e1316));
                                                                        } else {
                                                                            phi_2262_ = true;
                                                                        }
                                                                        let _e1513 = phi_2262_;
                                                                        if _e1513 {
                                                                            phi_2271_ = select(_e1411, _e1410, vec3((_e1312 >= _e1316)));
                                                                        } else {
                                                                            phi_2271_ = _e1409;
                                                                        }
                                                                        let _e1518 = phi_2271_;
                                                                        let _e1529 = (((_e1500 * (_e1518.x - _e315)) + (_e1505 * (_e1518.y - _e384))) + (_e1508 * (_e1518.z - _e452)));
                                                                        let _e1534 = (((_e1500 * _e355) + (_e1505 * _e423)) + (_e1508 * _e491));
                                                                        let _e1535 = (_e1481 - _e1485);
                                                                        let _e1536 = (_e1479 - _e1483);
                                                                        let _e1544 = (-(((_e1485 * _e1535) + (_e1483 * _e1536))) / ((_e1535 * _e1535) + (_e1536 * _e1536)));
                                                                        let _e1546 = select(1f, _e1544, (_e1544 < 1f));
                                                                        let _e1548 = select(0f, _e1546, (_e1546 > 0f));
                                                                        let _e1561 = ((_e1487.x + (_e1493.x * _e1548)) - _e315);
                                                                        let _e1562 = ((_e1487.y + (_e1493.y * _e1548)) - _e384);
                                                                        let _e1563 = ((_e1487.z + (_e1493.z * _e1548)) - _e452);
                                                                        let _e1564 = (_e1563 / _e491);
                                                                        let _e1576 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                        let _e1579 = bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u));
                                                                        let _e1581 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                                        let _e1584 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                        let _e1586 = select(_e1584, _e1581, (_e1581 > _e1584));
                                                                        let _e1592 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
                                                                        let _e1595 = bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u));
                                                                        let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                                        let _e1600 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1500 * _e1561) + (_e1505 * _e1562)) + (_e1508 * _e1563)) - _e1529)) & 2147483647u)) <= ((0.0000009536743f * select(_e1466, _e1586, (_e1586 > _e1466))) * select(_e1600, _e1597, (_e1597 > _e1600)))) {
                                                                            let _e1610 = bitcast<f32>((bitcast<u32>(_e1491.x) & 2147483647u));
                                                                            let _e1613 = bitcast<f32>((bitcast<u32>(_e1491.y) & 2147483647u));
                                                                            let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                                            let _e1618 = bitcast<f32>((bitcast<u32>(_e1491.z) & 2147483647u));
                                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1489.x) & 2147483647u));
                                                                            let _e1627 = bitcast<f32>((bitcast<u32>(_e1489.y) & 2147483647u));
                                                                            let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                                            let _e1632 = bitcast<f32>((bitcast<u32>(_e1489.z) & 2147483647u));
                                                                            let _e1636 = (bitcast<f32>((bitcast<u32>(_e1534) & 2147483647u)) > ((0.0000038146973f * select(_e1618, _e1615, (_e1615 > _e1618))) * select(_e1632, _e1629, (_e1629 > _e1632))));
                                                                            if _e1636 {
                                                                                phi_2436_ = (_e1529 / _e1534);
                                                                            } else {
                                                                                phi_2436_ = f32();
                                                                            }
                                                                            let _e1639 = phi_2436_;
                                                                            phi_2438_ = _e1639;
                                                                            phi_2439_ = select(true, false, _e1636);
                                                                        } else {
                                                                            phi_2438_ = f32();
                                                                            phi_2439_ = true;
                                                                        }
                                                                        let _e1642 = phi_2438_;
                                                                        let _e1644 = phi_2439_;
                                                                        if _e1644 {
                                                                            let _e1652 = (((_e1500 * (_e1561 - (_e355 * _e1564))) + (_e1505 * (_e1562 - (_e423 * _e1564)))) / _e1534);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u)) <= _e1466) {
                                                                                phi_2459_ = (_e1564 + _e1652);
                                                                            } else {
                                                                                phi_2459_ = _e1564;
                                                                            }
                                                                            let _e1659 = phi_2459_;
                                                                            phi_2460_ = _e1659;
                                                                        } else {
                                                                            phi_2460_ = _e1642;
                                                                        }
                                                                        let _e1661 = phi_2460_;
                                                                        let _e1663 = select(_e1399, _e1661, (_e1661 < _e1399));
                                                                        let _e1665 = select(_e1391, _e1663, (_e1663 > _e1391));
                                                                        if (_e1665 >= _e606) {
                                                                            let _e1667 = (_e1665 <= _e1059);
                                                                            if _e1667 {
                                                                                let _e1668 = (1f / _e1318);
                                                                                phi_2483_ = type_18(_e1665, (_e1312 * _e1668), (_e1316 * _e1668), _e1087);
                                                                            } else {
                                                                                phi_2483_ = type_18();
                                                                            }
                                                                            let _e1673 = phi_2483_;
                                                                            phi_2485_ = _e1673;
                                                                            phi_2486_ = select(true, false, _e1667);
                                                                        } else {
                                                                            phi_2485_ = type_18();
                                                                            phi_2486_ = true;
                                                                        }
                                                                        let _e1676 = phi_2485_;
                                                                        let _e1678 = phi_2486_;
                                                                        if _e1678 {
                                                                            phi_2490_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2490_ = _e1676;
                                                                        }
                                                                        let _e1680 = phi_2490_;
                                                                        phi_2491_ = _e1680;
                                                                    }
                                                                    let _e1682 = phi_2491_;
                                                                    phi_2492_ = _e1682;
                                                                    phi_2493_ = _e1408;
                                                                }
                                                                let _e1684 = phi_2492_;
                                                                let _e1686 = phi_2493_;
                                                                phi_2497_ = _e1684;
                                                                phi_2498_ = _e1686;
                                                            }
                                                            let _e1688 = phi_2497_;
                                                            let _e1690 = phi_2498_;
                                                            phi_2499_ = _e1688;
                                                            phi_2500_ = _e1343;
                                                            phi_2501_ = _e1690;
                                                        }
                                                        let _e1692 = phi_2499_;
                                                        let _e1694 = phi_2500_;
                                                        let _e1696 = phi_2501_;
                                                        phi_2502_ = _e1692;
                                                        phi_2503_ = _e1694;
                                                        phi_2504_ = _e1696;
                                                    }
                                                    let _e1698 = phi_2502_;
                                                    let _e1700 = phi_2503_;
                                                    let _e1702 = phi_2504_;
                                                    phi_2512_ = _e1698;
                                                    phi_2513_ = select(_e1702, true, _e1700);
                                                } else {
                                                    phi_2512_ = type_18();
                                                    phi_2513_ = true;
                                                }
                                                let _e1705 = phi_2512_;
                                                let _e1707 = phi_2513_;
                                                if _e1707 {
                                                    phi_2517_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2517_ = _e1705;
                                                }
                                                let _e1709 = phi_2517_;
                                                if (_e1709.member_3 != 4294967295u) {
                                                    if (_e1087 != 4294967295u) {
                                                        phi_2529_ = type_4(0u, 8u);
                                                        phi_2532_ = _e1709;
                                                        loop {
                                                            let _e1714 = phi_2529_;
                                                            let _e1716 = phi_2532_;
                                                            if (_e1714.member < _e1714.member_1) {
                                                                phi_2530_ = type_4((_e1714.member + 1u), _e1714.member_1);
                                                                phi_2555_ = type_4(1u, _e1714.member);
                                                            } else {
                                                                phi_2530_ = _e1714;
                                                                phi_2555_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1729 = phi_2530_;
                                                            let _e1731 = phi_2555_;
                                                            let _e1735 = (bitcast<i32>(_e1731.member) != 0i);
                                                            if _e1735 {
                                                                let _e1736 = (_e1731.member_1 < 8u);
                                                                if _e1736 {
                                                                } else {
                                                                    phi_4013_ = true;
                                                                    break;
                                                                }
                                                                let _e1741 = local_7[_e1731.member_1].member;
                                                                if (_e1716.member < _e1741) {
                                                                    phi_2588_ = true;
                                                                } else {
                                                                    let _e1743 = local_7[_e1731.member_1].member;
                                                                    if (_e1716.member == _e1743) {
                                                                        let _e1748 = local_7[_e1731.member_1].member_3;
                                                                        phi_2587_ = (_e1716.member_3 < _e1748);
                                                                    } else {
                                                                        phi_2587_ = false;
                                                                    }
                                                                    let _e1751 = phi_2587_;
                                                                    phi_2588_ = _e1751;
                                                                }
                                                                let _e1753 = phi_2588_;
                                                                if _e1753 {
                                                                    if _e1736 {
                                                                    } else {
                                                                        phi_4013_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1754 = local_7[_e1731.member_1];
                                                                    local_7[_e1731.member_1] = type_18(_e1716.member, _e1716.member_1, _e1716.member_2, _e1716.member_3);
                                                                    phi_2609_ = type_18(_e1754.member, _e1754.member_1, _e1754.member_2, _e1754.member_3);
                                                                } else {
                                                                    phi_2609_ = _e1716;
                                                                }
                                                                let _e1765 = phi_2609_;
                                                                phi_2533_ = _e1765;
                                                            } else {
                                                                phi_2533_ = type_18();
                                                            }
                                                            let _e1767 = phi_2533_;
                                                            continue;
                                                            continuing {
                                                                phi_2529_ = _e1729;
                                                                phi_2532_ = _e1767;
                                                                phi_4013_ = _e1057;
                                                                break if !(_e1735);
                                                            }
                                                        }
                                                        let _e1770 = phi_4013_;
                                                        phi_4316_ = _e1059;
                                                        phi_4191_ = _e1770;
                                                        if _e1770 {
                                                            break;
                                                        }
                                                        let _e1773 = local_7[7u].member_3;
                                                        if (_e1773 != 4294967295u) {
                                                            let _e1777 = local_7[7u].member;
                                                            phi_4407_ = _e1777;
                                                        } else {
                                                            phi_4407_ = _e1059;
                                                        }
                                                        let _e1779 = phi_4407_;
                                                        phi_4406_ = _e1779;
                                                        phi_4194_ = _e1770;
                                                    } else {
                                                        phi_4406_ = _e1059;
                                                        phi_4194_ = _e1057;
                                                    }
                                                    let _e1781 = phi_4406_;
                                                    let _e1783 = phi_4194_;
                                                    phi_4405_ = _e1781;
                                                    phi_4193_ = _e1783;
                                                } else {
                                                    phi_4405_ = _e1059;
                                                    phi_4193_ = _e1057;
                                                }
                                                let _e1785 = phi_4405_;
                                                let _e1787 = phi_4193_;
                                                phi_4404_ = _e1785;
                                                phi_4192_ = _e1787;
                                            } else {
                                                phi_4404_ = _e1059;
                                                phi_4192_ = _e1057;
                                            }
                                            let _e1789 = phi_4404_;
                                            let _e1791 = phi_4192_;
                                            continue;
                                            continuing {
                                                phi_4040_ = _e1791;
                                                phi_4012_ = _e1789;
                                                phi_1290_ = _e1074;
                                                phi_4316_ = _e1789;
                                                phi_4191_ = _e1791;
                                                break if !(_e1080);
                                            }
                                        }
                                        let _e1794 = phi_4316_;
                                        let _e1796 = phi_4191_;
                                        phi_4196_ = _e1796;
                                        if _e1796 {
                                            break;
                                        }
                                        phi_4281_ = _e1794;
                                        phi_4200_ = _e1796;
                                        phi_3634_ = false;
                                        phi_3635_ = _e679;
                                        phi_3636_ = _e681;
                                    } else {
                                        let _e691 = (_e681.member_1 < _e88);
                                        if _e691 {
                                            if _e691 {
                                            } else {
                                                phi_4196_ = true;
                                                break;
                                            }
                                            let _e693 = global_4.member[_e681.member_1];
                                            phi_2646_ = _e693;
                                        } else {
                                            phi_2646_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e695 = phi_2646_;
                                        let _e710 = ((10u * _e251) & 31u);
                                        let _e713 = ((_e695.member[0] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e721 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[0] - _e681.member.member[0]) * 0.0009775171f)) ^ _e123));
                                        let _e726 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e713)) - 8388608f) * _e721)) ^ _e123)));
                                        let _e730 = select(select(_e681.member.member_1[0], _e726, (_e726 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e713 == 1023u));
                                        let _e732 = ((10u * _e250) & 31u);
                                        let _e735 = ((_e695.member[0] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e743 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[1] - _e681.member.member[1]) * 0.0009775171f)) ^ _e123));
                                        let _e748 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e735)) - 8388608f) * _e743)) ^ _e123)));
                                        let _e752 = select(select(_e681.member.member_1[1], _e748, (_e748 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e735 == 1023u));
                                        let _e754 = ((10u * _e252) & 31u);
                                        let _e757 = ((_e695.member[0] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e765 = bitcast<f32>((bitcast<u32>(((_e681.member.member_1[2] - _e681.member.member[2]) * 0.0009775171f)) ^ _e123));
                                        let _e770 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e757)) - 8388608f) * _e765)) ^ _e123)));
                                        let _e774 = select(select(_e681.member.member_1[2], _e770, (_e770 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e757 == 1023u));
                                        let _e777 = ((_e695.member[1] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e785 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e777)) - 8388608f) * _e721)) ^ _e123)));
                                        let _e789 = select(select(_e681.member.member_1[0], _e785, (_e785 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e777 == 1023u));
                                        let _e792 = ((_e695.member[1] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e800 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e792)) - 8388608f) * _e743)) ^ _e123)));
                                        let _e804 = select(select(_e681.member.member_1[1], _e800, (_e800 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e792 == 1023u));
                                        let _e807 = ((_e695.member[1] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e815 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e807)) - 8388608f) * _e765)) ^ _e123)));
                                        let _e819 = select(select(_e681.member.member_1[2], _e815, (_e815 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e807 == 1023u));
                                        let _e825 = ((_e695.member_1[0] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e833 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e825)) - 8388608f) * _e721)) ^ _e123)));
                                        let _e837 = select(select(_e681.member.member_1[0], _e833, (_e833 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e825 == 1023u));
                                        let _e840 = ((_e695.member_1[0] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e848 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e840)) - 8388608f) * _e743)) ^ _e123)));
                                        let _e852 = select(select(_e681.member.member_1[1], _e848, (_e848 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e840 == 1023u));
                                        let _e855 = ((_e695.member_1[0] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e863 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e855)) - 8388608f) * _e765)) ^ _e123)));
                                        let _e867 = select(select(_e681.member.member_1[2], _e863, (_e863 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e855 == 1023u));
                                        let _e870 = ((_e695.member_1[1] >> bitcast<u32>(_e710)) & 1023u);
                                        let _e878 = (_e681.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e870)) - 8388608f) * _e721)) ^ _e123)));
                                        let _e882 = select(select(_e681.member.member_1[0], _e878, (_e878 < _e681.member.member_1[0])), _e681.member.member_1[0], (_e870 == 1023u));
                                        let _e885 = ((_e695.member_1[1] >> bitcast<u32>(_e732)) & 1023u);
                                        let _e893 = (_e681.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e885)) - 8388608f) * _e743)) ^ _e123)));
                                        let _e897 = select(select(_e681.member.member_1[1], _e893, (_e893 < _e681.member.member_1[1])), _e681.member.member_1[1], (_e885 == 1023u));
                                        let _e900 = ((_e695.member_1[1] >> bitcast<u32>(_e754)) & 1023u);
                                        let _e908 = (_e681.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e900)) - 8388608f) * _e765)) ^ _e123)));
                                        let _e912 = select(select(_e681.member.member_1[2], _e908, (_e908 < _e681.member.member_1[2])), _e681.member.member_1[2], (_e900 == 1023u));
                                        let _e917 = type_52(type_44(array<f32, 3>(_e730, _e752, _e774), array<f32, 3>(_e789, _e804, _e819)), _e695.member_2);
                                        let _e922 = type_52(type_44(array<f32, 3>(_e837, _e852, _e867), array<f32, 3>(_e882, _e897, _e912)), _e695.member_3);
                                        let _e927 = ((_e730 - _e353) * _e358);
                                        let _e928 = ((_e837 - _e353) * _e358);
                                        let _e929 = ((_e789 - _e354) * _e358);
                                        let _e930 = ((_e882 - _e354) * _e358);
                                        let _e935 = ((_e752 - _e421) * _e426);
                                        let _e936 = ((_e852 - _e421) * _e426);
                                        let _e937 = ((_e804 - _e422) * _e426);
                                        let _e938 = ((_e897 - _e422) * _e426);
                                        let _e943 = ((_e774 - _e489) * _e494);
                                        let _e944 = ((_e867 - _e489) * _e494);
                                        let _e945 = ((_e819 - _e490) * _e494);
                                        let _e946 = ((_e912 - _e490) * _e494);
                                        let _e948 = select(_e945, _e943, (_e943 < _e945));
                                        let _e950 = select(_e946, _e944, (_e944 < _e946));
                                        let _e952 = select(_e945, _e943, (_e943 > _e945));
                                        let _e954 = select(_e946, _e944, (_e944 > _e946));
                                        let _e956 = select(_e929, _e927, (_e927 < _e929));
                                        let _e958 = select(_e930, _e928, (_e928 < _e930));
                                        let _e960 = select(_e937, _e935, (_e935 < _e937));
                                        let _e962 = select(_e938, _e936, (_e936 < _e938));
                                        let _e964 = select(_e960, _e956, (_e956 > _e960));
                                        let _e966 = select(_e962, _e958, (_e958 > _e962));
                                        let _e968 = select(_e948, _e964, (_e964 > _e948));
                                        let _e970 = select(_e950, _e966, (_e966 > _e950));
                                        let _e972 = select(_e929, _e927, (_e927 > _e929));
                                        let _e974 = select(_e930, _e928, (_e928 > _e930));
                                        let _e976 = select(_e937, _e935, (_e935 > _e937));
                                        let _e978 = select(_e938, _e936, (_e936 > _e938));
                                        let _e980 = select(_e976, _e972, (_e972 < _e976));
                                        let _e982 = select(_e978, _e974, (_e974 < _e978));
                                        let _e987 = -(_e948);
                                        let _e988 = -(_e950);
                                        let _e995 = (select(_e952, _e980, (_e980 < _e952)) + (select(_e987, _e952, (_e952 > _e987)) * 0.0000019073523f));
                                        let _e996 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e988, _e954, (_e954 > _e988)) * 0.0000019073523f));
                                        let _e998 = select(_e606, _e968, (_e968 > _e606));
                                        let _e1000 = select(_e606, _e970, (_e970 > _e606));
                                        let _e1005 = (_e998 <= select(_e639, _e995, (_e995 < _e639)));
                                        let _e1006 = (_e1000 <= select(_e639, _e996, (_e996 < _e639)));
                                        let _e1007 = (_e998 <= _e1000);
                                        if _e1005 {
                                            if _e1006 {
                                                if _e1007 {
                                                    phi_3533_ = _e922;
                                                } else {
                                                    phi_3533_ = _e917;
                                                }
                                                let _e1009 = phi_3533_;
                                                let _e1017 = (_e679 % 128u);
                                                let _e1018 = (_e1017 < 128u);
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_6[_e1017] = _e1009.member_1;
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_5[_e1017] = _e1009.member.member[0];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_4[_e1017] = _e1009.member.member[1];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_3[_e1017] = _e1009.member.member[2];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_2[_e1017] = _e1009.member.member_1[0];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_1[_e1017] = _e1009.member.member_1[1];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local[_e1017] = _e1009.member.member_1[2];
                                                if _e1018 {
                                                } else {
                                                    phi_4196_ = true;
                                                    break;
                                                }
                                                local_8[_e1017] = select(_e1000, _e998, !(_e1007));
                                                if _e1007 {
                                                    phi_3610_ = _e917;
                                                } else {
                                                    phi_3610_ = _e922;
                                                }
                                                let _e1035 = phi_3610_;
                                                phi_3611_ = (_e679 + 1u);
                                                phi_3612_ = _e1035;
                                            } else {
                                                phi_3611_ = u32();
                                                phi_3612_ = type_52();
                                            }
                                            let _e1037 = phi_3611_;
                                            let _e1039 = phi_3612_;
                                            phi_3614_ = _e1037;
                                            phi_3615_ = _e1039;
                                            phi_3616_ = select(true, false, _e1006);
                                        } else {
                                            phi_3614_ = u32();
                                            phi_3615_ = type_52();
                                            phi_3616_ = true;
                                        }
                                        let _e1042 = phi_3614_;
                                        let _e1044 = phi_3615_;
                                        let _e1046 = phi_3616_;
                                        if _e1046 {
                                            if _e1005 {
                                                phi_3623_ = _e917;
                                            } else {
                                                phi_3623_ = _e922;
                                            }
                                            let _e1048 = phi_3623_;
                                            phi_3628_ = select(_e1006, true, _e1005);
                                            phi_3630_ = _e1048;
                                        } else {
                                            phi_3628_ = _e677;
                                            phi_3630_ = _e1044;
                                        }
                                        let _e1051 = phi_3628_;
                                        let _e1053 = phi_3630_;
                                        phi_4281_ = _e639;
                                        phi_4200_ = _e637;
                                        phi_3634_ = _e1051;
                                        phi_3635_ = select(_e1042, _e679, _e1046);
                                        phi_3636_ = _e1053;
                                    }
                                    let _e1798 = phi_4281_;
                                    let _e1800 = phi_4200_;
                                    let _e1802 = phi_3634_;
                                    let _e1804 = phi_3635_;
                                    let _e1806 = phi_3636_;
                                    phi_4280_ = _e1798;
                                    phi_4199_ = _e1800;
                                    phi_3637_ = _e1802;
                                    phi_3638_ = (_e643 - 1u);
                                    phi_3639_ = _e1804;
                                    phi_3640_ = _e1806;
                                } else {
                                    phi_4280_ = _e639;
                                    phi_4199_ = _e637;
                                    phi_3637_ = _e677;
                                    phi_3638_ = _e643;
                                    phi_3639_ = _e679;
                                    phi_3640_ = _e681;
                                }
                                let _e1808 = phi_4280_;
                                let _e1810 = phi_4199_;
                                let _e1812 = phi_3637_;
                                let _e1814 = phi_3638_;
                                let _e1816 = phi_3639_;
                                let _e1818 = phi_3640_;
                                phi_4279_ = _e1808;
                                phi_4198_ = _e1810;
                                phi_3641_ = _e1812;
                                phi_3642_ = _e1814;
                                phi_3643_ = _e1816;
                                phi_3644_ = _e1818;
                            } else {
                                phi_4279_ = _e639;
                                phi_4198_ = _e637;
                                phi_3641_ = bool();
                                phi_3642_ = u32();
                                phi_3643_ = u32();
                                phi_3644_ = type_52();
                            }
                            let _e1820 = phi_4279_;
                            let _e1822 = phi_4198_;
                            let _e1824 = phi_3641_;
                            let _e1826 = phi_3642_;
                            let _e1828 = phi_3643_;
                            let _e1830 = phi_3644_;
                            phi_4278_ = _e1820;
                            phi_4197_ = _e1822;
                            phi_1165_ = _e1824;
                            phi_1168_ = _e1826;
                            phi_1170_ = _e1828;
                            phi_1172_ = _e1830;
                            phi_3645_ = _e651;
                        } else {
                            phi_4278_ = _e639;
                            phi_4197_ = _e637;
                            phi_1165_ = bool();
                            phi_1168_ = u32();
                            phi_1170_ = u32();
                            phi_1172_ = type_52();
                            phi_3645_ = false;
                        }
                        let _e1832 = phi_4278_;
                        let _e1834 = phi_4197_;
                        let _e1836 = phi_1165_;
                        let _e1838 = phi_1168_;
                        let _e1840 = phi_1170_;
                        let _e1842 = phi_1172_;
                        let _e1844 = phi_3645_;
                        continue;
                        continuing {
                            phi_4043_ = _e1834;
                            phi_3964_ = _e1832;
                            phi_1164_ = _e1836;
                            phi_1167_ = _e1838;
                            phi_1169_ = _e1840;
                            phi_1171_ = _e1842;
                            phi_4196_ = _e1834;
                            break if !(_e1844);
                        }
                    }
                    let _e1847 = phi_4196_;
                    if _e1847 {
                        break;
                    }
                    phi_3652_ = type_4(0u, 8u);
                    loop {
                        let _e1849 = phi_3652_;
                        if (_e1849.member < _e1849.member_1) {
                            phi_3653_ = type_4((_e1849.member + 1u), _e1849.member_1);
                            phi_3676_ = type_4(1u, _e1849.member);
                        } else {
                            phi_3653_ = _e1849;
                            phi_3676_ = type_4(0u, type_4().member_1);
                        }
                        let _e1862 = phi_3653_;
                        let _e1864 = phi_3676_;
                        let _e1868 = (bitcast<i32>(_e1864.member) != 0i);
                        if _e1868 {
                            let _e1869 = (_e1864.member_1 < 8u);
                            if _e1869 {
                            } else {
                                phi_4260_ = true;
                                break;
                            }
                            let _e1871 = local_7[_e1864.member_1];
                            if (_e1871.member_3 != 4294967295u) {
                                let _e1877 = -(_e508);
                                let _e1878 = bitcast<u32>(_e1871.member);
                                let _e1882 = (bitcast<i32>((_e1878 >> bitcast<u32>(23i))) & 255i);
                                let _e1883 = (_e1882 + _e1877);
                                if (_e1882 == 255i) {
                                    phi_3749_ = _e1871.member;
                                } else {
                                    if (_e1882 > 0i) {
                                        if (_e1883 > 0i) {
                                            let _e1887 = (_e1883 < 255i);
                                            if _e1887 {
                                                phi_3728_ = bitcast<f32>((_e1878 + bitcast<u32>((_e1877 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3728_ = f32();
                                            }
                                            let _e1894 = phi_3728_;
                                            phi_3730_ = _e1894;
                                            phi_3731_ = select(true, false, _e1887);
                                        } else {
                                            phi_3730_ = f32();
                                            phi_3731_ = true;
                                        }
                                        let _e1897 = phi_3730_;
                                        let _e1899 = phi_3731_;
                                        phi_3732_ = _e1897;
                                        phi_3733_ = _e1899;
                                    } else {
                                        phi_3732_ = f32();
                                        phi_3733_ = true;
                                    }
                                    let _e1901 = phi_3732_;
                                    let _e1903 = phi_3733_;
                                    if _e1903 {
                                        let _e1904 = (_e1878 & 2147483648u);
                                        let _e1911 = ((_e1878 & 8388607u) | (select(0u, 1u, ((_e1878 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1915 = (_e1911 == 0u);
                                        if _e1915 {
                                            phi_3922_ = bitcast<f32>(_e1904);
                                        } else {
                                            let _e1920 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1911)), 32u, _e1915) - 8u);
                                            let _e1923 = (_e1911 << bitcast<u32>((_e1920 & 31u)));
                                            let _e1925 = ((_e1883 + select(0i, 1i, (_e1882 == 0i))) - bitcast<i32>(_e1920));
                                            if (_e1925 >= 255i) {
                                                phi_3912_ = bitcast<f32>((_e1904 | 2139095040u));
                                                phi_3913_ = f32();
                                                phi_3914_ = true;
                                            } else {
                                                let _e1927 = (_e1925 > 0i);
                                                if _e1927 {
                                                    phi_3906_ = bitcast<f32>(((_e1904 | (bitcast<u32>(_e1925) << bitcast<u32>(23i))) | (_e1923 & 8388607u)));
                                                    phi_3907_ = f32();
                                                } else {
                                                    if (_e1925 < -24i) {
                                                        phi_3872_ = 26u;
                                                    } else {
                                                        phi_3872_ = bitcast<u32>((1i - _e1925));
                                                    }
                                                    let _e1932 = phi_3872_;
                                                    let _e1933 = (_e1932 & 31u);
                                                    let _e1935 = (_e1923 >> bitcast<u32>(_e1933));
                                                    let _e1939 = (_e1923 & ((1u << bitcast<u32>(_e1933)) - 1u));
                                                    let _e1943 = (1u << bitcast<u32>(((_e1932 - 1u) & 31u)));
                                                    if (_e1939 > _e1943) {
                                                        phi_3893_ = true;
                                                    } else {
                                                        if (_e1939 == _e1943) {
                                                            phi_3890_ = ((_e1935 & 1u) == 1u);
                                                        } else {
                                                            phi_3890_ = false;
                                                        }
                                                        let _e1949 = phi_3890_;
                                                        phi_3893_ = _e1949;
                                                    }
                                                    let _e1951 = phi_3893_;
                                                    phi_3906_ = f32();
                                                    phi_3907_ = bitcast<f32>((_e1904 | (_e1935 + select(0u, 1u, _e1951))));
                                                }
                                                let _e1964 = phi_3906_;
                                                let _e1966 = phi_3907_;
                                                phi_3912_ = _e1964;
                                                phi_3913_ = _e1966;
                                                phi_3914_ = _e1927;
                                            }
                                            let _e1970 = phi_3912_;
                                            let _e1972 = phi_3913_;
                                            let _e1974 = phi_3914_;
                                            phi_3922_ = select(_e1972, _e1970, _e1974);
                                        }
                                        let _e1978 = phi_3922_;
                                        phi_3748_ = _e1978;
                                    } else {
                                        phi_3748_ = _e1901;
                                    }
                                    let _e1980 = phi_3748_;
                                    phi_3749_ = _e1980;
                                }
                                let _e1982 = phi_3749_;
                                let _e1983 = bitcast<u32>(_e1982);
                                if ((_e1983 & 2147483647u) >= 2139095040u) {
                                    phi_3761_ = bitcast<f32>(((_e1983 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3761_ = _e1982;
                                }
                                let _e1990 = phi_3761_;
                                phi_3766_ = type_18(_e1990, _e1871.member_1, _e1871.member_2, _e1871.member_3);
                            } else {
                                phi_3766_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1993 = phi_3766_;
                            if _e1869 {
                            } else {
                                phi_4260_ = true;
                                break;
                            }
                            local_7[_e1864.member_1] = type_18(_e1993.member, _e1993.member_1, _e1993.member_2, _e1993.member_3);
                        }
                        continue;
                        continuing {
                            phi_3652_ = _e1862;
                            phi_4260_ = _e1847;
                            break if !(_e1868);
                        }
                    }
                    let _e2001 = phi_4260_;
                    if _e2001 {
                        break;
                    }
                    let _e2002 = local_7;
                    if _e139 {
                    } else {
                        break;
                    }
                    global_5.member[_e137] = array<type_18, 8>(type_18(_e2002[0].member, _e2002[0].member_1, _e2002[0].member_2, _e2002[0].member_3), type_18(_e2002[1].member, _e2002[1].member_1, _e2002[1].member_2, _e2002[1].member_3), type_18(_e2002[2].member, _e2002[2].member_1, _e2002[2].member_2, _e2002[2].member_3), type_18(_e2002[3].member, _e2002[3].member_1, _e2002[3].member_2, _e2002[3].member_3), type_18(_e2002[4].member, _e2002[4].member_1, _e2002[4].member_2, _e2002[4].member_3), type_18(_e2002[5].member, _e2002[5].member_1, _e2002[5].member_2, _e2002[5].member_3), type_18(_e2002[6].member, _e2002[6].member_1, _e2002[6].member_2, _e2002[6].member_3), type_18(_e2002[7].member, _e2002[7].member_1, _e2002[7].member_2, _e2002[7].member_3));
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
