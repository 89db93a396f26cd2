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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_34 {
    member: type_21,
    member_1: f32,
}

struct type_37 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_39 {
    member: array<type_25>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_39;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_23;

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
    var phi_499_: i32;
    var phi_500_: i32;
    var phi_510_: bool;
    var phi_520_: u32;
    var phi_521_: u32;
    var phi_523_: bool;
    var phi_528_: u32;
    var phi_541_: i32;
    var phi_561_: i32;
    var phi_579_: f32;
    var phi_585_: f32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_704_: f32;
    var phi_710_: f32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_829_: f32;
    var phi_835_: f32;
    var phi_875_: f32;
    var phi_881_: f32;
    var phi_1000_: i32;
    var phi_1022_: u32;
    var phi_1023_: u32;
    var phi_1060_: i32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_4001_: bool;
    var phi_1188_: type_34;
    var phi_1191_: bool;
    var phi_1193_: type_51;
    var phi_1195_: u32;
    var phi_1197_: u32;
    var phi_1208_: bool;
    var phi_1294_: bool;
    var phi_1295_: type_51;
    var phi_1296_: u32;
    var phi_2981_: u32;
    var phi_2982_: u32;
    var phi_2992_: u32;
    var phi_2994_: u32;
    var phi_2995_: bool;
    var phi_3015_: u32;
    var phi_3016_: u32;
    var phi_3020_: type_52;
    var phi_3382_: type_51;
    var phi_3458_: type_51;
    var phi_3459_: type_51;
    var phi_3460_: u32;
    var phi_3462_: type_51;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3473_: type_51;
    var phi_3478_: bool;
    var phi_3479_: type_51;
    var phi_1314_: type_34;
    var phi_1317_: type_4;
    var phi_1318_: type_4;
    var phi_1340_: type_4;
    var phi_1361_: u32;
    var phi_1453_: array<array<f32, 3>, 3>;
    var phi_1983_: f32;
    var phi_1984_: f32;
    var phi_1985_: f32;
    var phi_1986_: f32;
    var phi_1987_: vec3<f32>;
    var phi_1988_: vec3<f32>;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2181_: f32;
    var phi_2201_: type_37;
    var phi_2202_: type_37;
    var phi_2205_: type_37;
    var phi_2206_: type_37;
    var phi_2207_: bool;
    var phi_2211_: type_37;
    var phi_2220_: type_21;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2252_: type_34;
    var phi_2253_: type_34;
    var phi_2254_: type_34;
    var phi_1315_: type_34;
    var phi_3995_: bool;
    var local_10: type_34;
    var phi_4152_: bool;
    var phi_3481_: type_34;
    var phi_3482_: bool;
    var phi_3483_: type_51;
    var phi_3484_: u32;
    var phi_4151_: bool;
    var phi_3485_: type_34;
    var phi_3486_: bool;
    var phi_3487_: type_51;
    var phi_3488_: u32;
    var phi_3489_: u32;
    var phi_4150_: bool;
    var phi_3490_: type_34;
    var phi_3491_: bool;
    var phi_3492_: type_51;
    var phi_3493_: u32;
    var phi_3494_: u32;
    var phi_4149_: bool;
    var phi_1189_: type_34;
    var phi_1192_: bool;
    var phi_1194_: type_51;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_3495_: bool;
    var phi_4148_: bool;
    var local_11: type_34;
    var phi_3533_: f32;
    var phi_3535_: f32;
    var phi_3536_: bool;
    var phi_3537_: f32;
    var phi_3538_: bool;
    var phi_3903_: u32;
    var phi_3921_: bool;
    var phi_3924_: bool;
    var phi_3937_: f32;
    var phi_3938_: f32;
    var phi_3943_: f32;
    var phi_3944_: f32;
    var phi_3945_: bool;
    var phi_3953_: f32;
    var phi_3553_: f32;
    var phi_3554_: f32;
    var phi_3566_: f32;
    var phi_3571_: type_21;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_5.member));
            let _e94 = arrayLength((&global_2.member));
            let _e102 = global_3.member[0u][0u];
            let _e106 = global_3.member[0u][1u];
            let _e110 = global_3.member[0u][2u];
            let _e114 = global_3.member[0u][3u];
            let _e118 = global_3.member[1u][0u];
            let _e122 = global_3.member[1u][1u];
            let _e126 = global_3.member[1u][2u];
            let _e129 = global_1.member[0u];
            let _e130 = bitcast<i32>(_e129);
            let _e142 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e114) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e102), bitcast<i32>(_e106), bitcast<i32>(_e110));
            local = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            let _e148 = (_e90.x + (_e90.y * 2097152u));
            let _e149 = (_e148 < arrayLength((&global_4.member)));
            if _e149 {
                let _e150 = (_e148 < arrayLength((&global_6.member)));
                if _e150 {
                    if _e149 {
                    } else {
                        break;
                    }
                    let _e158 = global_4.member[_e148].member_2[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e148].member_2[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e148].member_2[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e148].member[0u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_4.member[_e148].member[1u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e193 = global_4.member[_e148].member[2u];
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e197 = select(_e167, _e160, (_e167 < _e160));
                    let _e199 = select(_e174, _e197, (_e174 < _e197));
                    let _e201 = select(_e181, _e199, (_e181 < _e199));
                    let _e203 = select(_e188, _e201, (_e188 < _e201));
                    let _e205 = select(_e195, _e203, (_e195 < _e203));
                    let _e209 = global_4.member[_e148].member_1;
                    let _e210 = bitcast<u32>(_e209);
                    let _e211 = (_e210 & 2147483647u);
                    let _e218 = global_4.member[_e148].member_3;
                    let _e219 = bitcast<u32>(_e218);
                    let _e220 = (_e219 & 2147483647u);
                    let _e224 = (((select(_e211, _e205, (_e211 < _e205)) < 2139095040u) && (_e220 <= 2139095040u)) && (_e199 > 0u));
                    if _e224 {
                        let _e227 = (bitcast<u32>(bitcast<f32>(_e199)) & 2147483647u);
                        if (_e227 >= 8388608u) {
                            phi_499_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_499_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                        }
                        let _e241 = phi_499_;
                        phi_500_ = _e241;
                    } else {
                        phi_500_ = 0i;
                    }
                    let _e243 = phi_500_;
                    let _e244 = (_e160 == _e199);
                    if _e244 {
                        phi_510_ = true;
                    } else {
                        phi_510_ = (_e167 == _e199);
                    }
                    let _e247 = phi_510_;
                    let _e248 = select(1u, 0u, _e244);
                    if _e247 {
                        let _e249 = (_e248 + 1u);
                        phi_520_ = _e249;
                        phi_521_ = _e249;
                        phi_523_ = select(true, false, (_e249 == 2u));
                    } else {
                        phi_520_ = u32();
                        phi_521_ = 0u;
                        phi_523_ = true;
                    }
                    let _e253 = phi_520_;
                    let _e255 = phi_521_;
                    let _e257 = phi_523_;
                    if _e257 {
                        phi_528_ = (_e255 + 1u);
                    } else {
                        phi_528_ = 0u;
                    }
                    let _e261 = phi_528_;
                    let _e262 = select(_e253, _e255, _e257);
                    let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                    if (_e130 < -126i) {
                        phi_541_ = -126i;
                    } else {
                        phi_541_ = select(_e130, 127i, (_e130 > 127i));
                    }
                    let _e268 = phi_541_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e130 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = -(_e243);
                    if (_e280 < -126i) {
                        phi_561_ = -126i;
                    } else {
                        phi_561_ = select(_e280, 127i, (_e280 > 127i));
                    }
                    let _e285 = phi_561_;
                    let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                    let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                    let _e300 = global_4.member[_e148].member;
                    let _e301 = (_e262 == 0u);
                    if _e301 {
                        phi_579_ = _e300[0];
                    } else {
                        phi_579_ = _e300[1];
                    }
                    let _e305 = phi_579_;
                    let _e306 = (_e262 == 2u);
                    if _e306 {
                        phi_585_ = _e300[2];
                    } else {
                        phi_585_ = _e305;
                    }
                    let _e309 = phi_585_;
                    let _e310 = bitcast<u32>(_e309);
                    let _e312 = ((_e310 & 2139095040u) != 0u);
                    let _e326 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e310 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e310 & 2147483648u))), _e309, _e312) * _e273) * select(0.00000011920929f, 1f, _e312)) * _e279);
                    let _e327 = global_4.member[_e148].member_2;
                    if _e301 {
                        phi_625_ = _e327[0];
                    } else {
                        phi_625_ = _e327[1];
                    }
                    let _e331 = phi_625_;
                    if _e306 {
                        phi_631_ = _e327[2];
                    } else {
                        phi_631_ = _e331;
                    }
                    let _e334 = phi_631_;
                    let _e335 = bitcast<u32>(_e334);
                    let _e337 = ((_e335 & 2139095040u) != 0u);
                    let _e351 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e334, _e337) * _e290) * select(0.00000011920929f, 1f, _e337)) * _e296);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e358 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                    let _e359 = (_e358 * 0.00000011920929f);
                    let _e362 = select(select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f)), 0f, _e355);
                    let _e363 = select(0f, _e351, _e355);
                    let _e364 = (_e326 + _e362);
                    let _e365 = (_e326 - _e362);
                    let _e367 = select(38685626000000000000000000f, (1f / _e351), _e355);
                    let _e368 = (_e261 == 0u);
                    if _e368 {
                        phi_704_ = _e300[0];
                    } else {
                        phi_704_ = _e300[1];
                    }
                    let _e372 = phi_704_;
                    let _e373 = (_e261 == 2u);
                    if _e373 {
                        phi_710_ = _e300[2];
                    } else {
                        phi_710_ = _e372;
                    }
                    let _e376 = phi_710_;
                    let _e377 = bitcast<u32>(_e376);
                    let _e379 = ((_e377 & 2139095040u) != 0u);
                    let _e393 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * _e273) * select(0.00000011920929f, 1f, _e379)) * _e279);
                    if _e368 {
                        phi_750_ = _e327[0];
                    } else {
                        phi_750_ = _e327[1];
                    }
                    let _e397 = phi_750_;
                    if _e373 {
                        phi_756_ = _e327[2];
                    } else {
                        phi_756_ = _e397;
                    }
                    let _e400 = phi_756_;
                    let _e401 = bitcast<u32>(_e400);
                    let _e403 = ((_e401 & 2139095040u) != 0u);
                    let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e290) * select(0.00000011920929f, 1f, _e403)) * _e296);
                    let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e424 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e425 = (_e424 * 0.00000011920929f);
                    let _e428 = select(select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f)), 0f, _e421);
                    let _e429 = select(0f, _e417, _e421);
                    let _e430 = (_e393 + _e428);
                    let _e431 = (_e393 - _e428);
                    let _e433 = select(38685626000000000000000000f, (1f / _e417), _e421);
                    let _e434 = (_e263 == 0u);
                    if _e434 {
                        phi_829_ = _e300[0];
                    } else {
                        phi_829_ = _e300[1];
                    }
                    let _e438 = phi_829_;
                    let _e439 = (_e263 == 2u);
                    if _e439 {
                        phi_835_ = _e300[2];
                    } else {
                        phi_835_ = _e438;
                    }
                    let _e442 = phi_835_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e459 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * _e273) * select(0.00000011920929f, 1f, _e445)) * _e279);
                    if _e434 {
                        phi_875_ = _e327[0];
                    } else {
                        phi_875_ = _e327[1];
                    }
                    let _e463 = phi_875_;
                    if _e439 {
                        phi_881_ = _e327[2];
                    } else {
                        phi_881_ = _e463;
                    }
                    let _e466 = phi_881_;
                    let _e467 = bitcast<u32>(_e466);
                    let _e469 = ((_e467 & 2139095040u) != 0u);
                    let _e483 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * _e290) * select(0.00000011920929f, 1f, _e469)) * _e296);
                    let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e490 = bitcast<f32>((bitcast<u32>(_e459) & 2147483647u));
                    let _e491 = (_e490 * 0.00000011920929f);
                    let _e494 = select(select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f)), 0f, _e487);
                    let _e495 = select(0f, _e483, _e487);
                    let _e496 = (_e459 + _e494);
                    let _e497 = (_e459 - _e494);
                    let _e499 = select(38685626000000000000000000f, (1f / _e483), _e487);
                    let _e501 = select(_e424, _e358, (_e358 > _e424));
                    let _e504 = (_e130 + _e243);
                    if (_e224 && (select(_e490, _e501, (_e501 > _e490)) <= 1099511600000f)) {
                        let _e514 = ((_e211 & 8388607u) | (select(0u, 1u, ((_e211 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e517 = bitcast<i32>((_e211 >> bitcast<u32>(23i)));
                        let _e521 = (_e514 == 0u);
                        let _e524 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e514)), 32u, _e521)) - 8i);
                        if (_e517 == 255i) {
                            phi_1000_ = 255i;
                        } else {
                            phi_1000_ = (((_e517 + select(0i, 1i, (_e517 == 0i))) - _e524) + _e504);
                        }
                        let _e532 = phi_1000_;
                        let _e542 = (_e532 <= 0i);
                        if _e542 {
                            phi_1023_ = u32();
                        } else {
                            if _e521 {
                                phi_1022_ = u32();
                            } else {
                                phi_1022_ = select(((bitcast<u32>(_e532) << bitcast<u32>(23i)) | ((_e514 << bitcast<u32>(((_e524 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e532 >= 255i));
                            }
                            let _e546 = phi_1022_;
                            phi_1023_ = _e546;
                        }
                        let _e548 = phi_1023_;
                        let _e560 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e563 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                        let _e567 = (_e560 == 0u);
                        let _e570 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e560)), 32u, _e567)) - 8i);
                        if (_e563 == 255i) {
                            phi_1060_ = 255i;
                        } else {
                            phi_1060_ = (((_e563 + select(0i, 1i, (_e563 == 0i))) - _e570) + _e504);
                        }
                        let _e578 = phi_1060_;
                        let _e588 = (_e578 <= 0i);
                        if _e588 {
                            phi_1083_ = u32();
                        } else {
                            if _e567 {
                                phi_1082_ = u32();
                            } else {
                                phi_1082_ = select(((bitcast<u32>(_e578) << bitcast<u32>(23i)) | ((_e560 << bitcast<u32>(((_e570 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e578 >= 255i));
                            }
                            let _e592 = phi_1082_;
                            phi_1083_ = _e592;
                        }
                        let _e594 = phi_1083_;
                        phi_1091_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e594, 0u, select(_e567, true, _e588))));
                        phi_1092_ = bitcast<f32>(((_e210 & 2147483648u) | select(_e548, 0u, select(_e521, true, _e542))));
                    } else {
                        phi_1091_ = 0f;
                        phi_1092_ = 1f;
                    }
                    let _e600 = phi_1091_;
                    let _e602 = phi_1092_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e608 = (_e262 % 3u);
                    let _e609 = (_e608 < 3u);
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e611 = local_1[_e608];
                    let _e614 = (_e261 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e263 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e628 = local[_e608];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e614];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e620];
                    phi_4001_ = false;
                    phi_1188_ = type_34(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e600);
                    phi_1191_ = (_e602 <= _e600);
                    phi_1193_ = type_51(type_29(vec4<f32>((f32(_e611) * _e142), (f32(_e617) * _e142), (f32(_e623) * _e142), 0f), vec4<f32>((f32(_e628) * _e142), (f32(_e632) * _e142), (f32(_e636) * _e142), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_1195_ = 0u;
                    phi_1197_ = ((3u * _e92) + 1u);
                    loop {
                        let _e644 = phi_4001_;
                        let _e646 = phi_1188_;
                        let _e648 = phi_1191_;
                        let _e650 = phi_1193_;
                        let _e652 = phi_1195_;
                        let _e654 = phi_1197_;
                        local_11 = _e646;
                        if _e648 {
                            phi_1208_ = true;
                        } else {
                            phi_1208_ = (_e652 > 0u);
                        }
                        let _e657 = phi_1208_;
                        if _e657 {
                            let _e658 = (_e654 > 0u);
                            if _e658 {
                                if _e648 {
                                    phi_1294_ = _e648;
                                    phi_1295_ = _e650;
                                    phi_1296_ = _e652;
                                } else {
                                    let _e659 = (_e652 - 1u);
                                    let _e660 = (_e659 % 128u);
                                    let _e661 = (_e660 < 128u);
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e663 = local_7[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e665 = local_6[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e667 = local_5[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e669 = local_4[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e671 = local_3[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e673 = local_2[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e678 = local_8[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e681 = local_9[_e660];
                                    phi_1294_ = (_e681 <= _e646.member_1);
                                    phi_1295_ = type_51(type_29(vec4<f32>(_e663, _e665, _e667, 0f), vec4<f32>(_e669, _e671, _e673, 0f)), _e678);
                                    phi_1296_ = _e659;
                                }
                                let _e685 = phi_1294_;
                                let _e687 = phi_1295_;
                                let _e689 = phi_1296_;
                                if _e685 {
                                    if ((_e687.member_1 & 2147483648u) != 0u) {
                                        phi_1314_ = _e646;
                                        phi_1317_ = type_4(0u, ((_e687.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1156 = phi_1314_;
                                            let _e1158 = phi_1317_;
                                            local_10 = _e1156;
                                            local_12 = _e1156;
                                            if (_e1158.member < _e1158.member_1) {
                                                phi_1318_ = type_4((_e1158.member + 1u), _e1158.member_1);
                                                phi_1340_ = type_4(1u, _e1158.member);
                                            } else {
                                                phi_1318_ = _e1158;
                                                phi_1340_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1171 = phi_1318_;
                                            let _e1173 = phi_1340_;
                                            let _e1177 = (bitcast<i32>(_e1173.member) != 0i);
                                            if _e1177 {
                                                let _e1178 = ((_e687.member_1 & 268435455u) + _e1173.member_1);
                                                let _e1179 = (_e1178 < _e94);
                                                if _e1179 {
                                                    if _e1179 {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1183 = global_2.member[_e1178].member_1;
                                                    phi_1361_ = _e1183;
                                                } else {
                                                    phi_1361_ = 4294967295u;
                                                }
                                                let _e1185 = phi_1361_;
                                                if (_e1178 >= _e94) {
                                                    phi_1453_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1179 {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    if (_e608 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1192 = global_2.member[_e1178].member[_e608];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1198 = global_2.member[_e1178].member[_e614];
                                                    if (_e620 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1204 = global_2.member[_e1178].member[_e620];
                                                    let _e1206 = (3u + _e608);
                                                    if (_e1206 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1212 = global_2.member[_e1178].member[_e1206];
                                                    let _e1213 = (3u + _e614);
                                                    if (_e1213 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1219 = global_2.member[_e1178].member[_e1213];
                                                    let _e1220 = (3u + _e620);
                                                    if (_e1220 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1226 = global_2.member[_e1178].member[_e1220];
                                                    let _e1228 = (6u + _e608);
                                                    if (_e1228 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1234 = global_2.member[_e1178].member[_e1228];
                                                    let _e1235 = (6u + _e614);
                                                    if (_e1235 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1241 = global_2.member[_e1178].member[_e1235];
                                                    let _e1242 = (6u + _e620);
                                                    if (_e1242 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1248 = global_2.member[_e1178].member[_e1242];
                                                    phi_1453_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1192, _e1198, _e1204), array<f32, 3>(_e1212, _e1219, _e1226), array<f32, 3>(_e1234, _e1241, _e1248));
                                                }
                                                let _e1252 = phi_1453_;
                                                let _e1268 = (_e1252[0][2] - _e459);
                                                let _e1271 = (((_e1252[0][0] - _e326) * _e495) - (_e1268 * _e363));
                                                let _e1274 = (((_e1252[0][1] - _e393) * _e495) - (_e1268 * _e429));
                                                let _e1277 = (_e1252[1][2] - _e459);
                                                let _e1280 = (((_e1252[1][0] - _e326) * _e495) - (_e1277 * _e363));
                                                let _e1283 = (((_e1252[1][1] - _e393) * _e495) - (_e1277 * _e429));
                                                let _e1286 = (_e1252[2][2] - _e459);
                                                let _e1289 = (((_e1252[2][0] - _e326) * _e495) - (_e1286 * _e363));
                                                let _e1292 = (((_e1252[2][1] - _e393) * _e495) - (_e1286 * _e429));
                                                let _e1293 = (_e1289 * _e1283);
                                                let _e1294 = (_e1292 * _e1280);
                                                let _e1295 = (_e1271 * _e1292);
                                                let _e1296 = (_e1274 * _e1289);
                                                let _e1297 = (_e1280 * _e1274);
                                                let _e1298 = (_e1283 * _e1271);
                                                let _e1303 = (((_e1293 >= _e1294) && (_e1295 >= _e1296)) && (_e1297 >= _e1298));
                                                let _e1309 = (_e1303 || (((_e1293 <= _e1294) && (_e1295 <= _e1296)) && (_e1297 <= _e1298)));
                                                if _e1309 {
                                                    let _e1311 = select(-1f, 1f, _e1303);
                                                    let _e1313 = ((_e1293 - _e1294) * _e1311);
                                                    let _e1315 = select(0f, _e1313, (_e1313 > 0f));
                                                    let _e1317 = ((_e1295 - _e1296) * _e1311);
                                                    let _e1319 = select(0f, _e1317, (_e1317 > 0f));
                                                    let _e1321 = ((_e1297 - _e1298) * _e1311);
                                                    let _e1323 = select(0f, _e1321, (_e1321 > 0f));
                                                    let _e1325 = ((_e1315 + _e1319) + _e1323);
                                                    let _e1327 = select(_e1252[1][0], _e1252[0][0], (_e1252[0][0] < _e1252[1][0]));
                                                    let _e1331 = select(_e1252[1][0], _e1252[0][0], (_e1252[0][0] > _e1252[1][0]));
                                                    let _e1335 = select(_e1252[1][1], _e1252[0][1], (_e1252[0][1] < _e1252[1][1]));
                                                    let _e1339 = select(_e1252[1][1], _e1252[0][1], (_e1252[0][1] > _e1252[1][1]));
                                                    let _e1343 = select(_e1252[1][2], _e1252[0][2], (_e1252[0][2] < _e1252[1][2]));
                                                    let _e1347 = select(_e1252[1][2], _e1252[0][2], (_e1252[0][2] > _e1252[1][2]));
                                                    let _e1352 = ((select(_e1252[2][0], _e1327, (_e1327 < _e1252[2][0])) - _e364) * _e367);
                                                    let _e1353 = ((select(_e1252[2][0], _e1331, (_e1331 > _e1252[2][0])) - _e365) * _e367);
                                                    let _e1356 = ((select(_e1252[2][1], _e1335, (_e1335 < _e1252[2][1])) - _e430) * _e433);
                                                    let _e1357 = ((select(_e1252[2][1], _e1339, (_e1339 > _e1252[2][1])) - _e431) * _e433);
                                                    let _e1360 = ((select(_e1252[2][2], _e1343, (_e1343 < _e1252[2][2])) - _e496) * _e499);
                                                    let _e1361 = ((select(_e1252[2][2], _e1347, (_e1347 > _e1252[2][2])) - _e497) * _e499);
                                                    let _e1363 = select(_e1361, _e1360, (_e1360 < _e1361));
                                                    let _e1365 = select(_e1361, _e1360, (_e1360 > _e1361));
                                                    let _e1367 = select(_e1353, _e1352, (_e1352 < _e1353));
                                                    let _e1369 = select(_e1357, _e1356, (_e1356 < _e1357));
                                                    let _e1371 = select(_e1369, _e1367, (_e1367 > _e1369));
                                                    let _e1373 = select(_e1363, _e1371, (_e1371 > _e1363));
                                                    let _e1375 = select(_e1353, _e1352, (_e1352 > _e1353));
                                                    let _e1377 = select(_e1357, _e1356, (_e1356 > _e1357));
                                                    let _e1379 = select(_e1377, _e1375, (_e1375 < _e1377));
                                                    let _e1381 = select(_e1365, _e1379, (_e1379 < _e1365));
                                                    let _e1382 = -(_e1363);
                                                    let _e1388 = select(_e602, _e1373, (_e1373 > _e602));
                                                    let _e1392 = select(_e1280, _e1271, (_e1271 < _e1280));
                                                    let _e1397 = select(_e1280, _e1271, (_e1271 > _e1280));
                                                    let _e1404 = select(_e1283, _e1274, (_e1274 < _e1283));
                                                    let _e1409 = select(_e1283, _e1274, (_e1274 > _e1283));
                                                    let _e1418 = (((((_e1309 && (_e1325 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1289, _e1392, (_e1392 < _e1289)) <= 0f) && (select(_e1289, _e1397, (_e1397 > _e1289)) >= 0f))) && ((select(_e1292, _e1404, (_e1404 < _e1292)) <= 0f) && (select(_e1292, _e1409, (_e1409 > _e1292)) >= 0f))) && (_e1388 <= (_e1381 + (select(_e1382, _e1365, (_e1365 > _e1382)) * 0.0000019073523f)))) && (_e1388 <= _e1156.member_1));
                                                    if _e1418 {
                                                        let _e1423 = (_e1252[1][0] - _e1252[0][0]);
                                                        let _e1424 = (_e1252[1][1] - _e1252[0][1]);
                                                        let _e1425 = (_e1252[1][2] - _e1252[0][2]);
                                                        let _e1426 = vec3<f32>(_e1423, _e1424, _e1425);
                                                        let _e1427 = (_e1252[2][0] - _e1252[1][0]);
                                                        let _e1428 = (_e1252[2][1] - _e1252[1][1]);
                                                        let _e1429 = (_e1252[2][2] - _e1252[1][2]);
                                                        let _e1430 = vec3<f32>(_e1427, _e1428, _e1429);
                                                        let _e1431 = (_e1252[0][0] - _e1252[2][0]);
                                                        let _e1432 = (_e1252[0][1] - _e1252[2][1]);
                                                        let _e1433 = (_e1252[0][2] - _e1252[2][2]);
                                                        let _e1434 = vec3<f32>(_e1431, _e1432, _e1433);
                                                        let _e1437 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                        let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                        let _e1445 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                        let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                        let _e1450 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                        let _e1453 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                        let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                        let _e1458 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                        let _e1460 = select(_e1458, _e1455, (_e1455 > _e1458));
                                                        let _e1463 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                        let _e1466 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                        let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                        let _e1471 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                        let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                        let _e1475 = select(_e1460, _e1447, (_e1447 > _e1460));
                                                        let _e1477 = select(_e1473, _e1475, (_e1475 > _e1473));
                                                        if (_e1447 == _e1477) {
                                                            phi_1983_ = _e1283;
                                                            phi_1984_ = _e1280;
                                                            phi_1985_ = _e1274;
                                                            phi_1986_ = _e1271;
                                                            phi_1987_ = vec3<f32>(_e1252[0][0], _e1252[0][1], _e1252[0][2]);
                                                            phi_1988_ = _e1434;
                                                            phi_1989_ = _e1430;
                                                            phi_1990_ = _e1426;
                                                        } else {
                                                            let _e1479 = (_e1460 == _e1477);
                                                            let _e1484 = vec3(_e1479);
                                                            phi_1983_ = select(_e1274, _e1292, _e1479);
                                                            phi_1984_ = select(_e1271, _e1289, _e1479);
                                                            phi_1985_ = select(_e1292, _e1283, _e1479);
                                                            phi_1986_ = select(_e1289, _e1280, _e1479);
                                                            phi_1987_ = select(vec3<f32>(_e1252[2][0], _e1252[2][1], _e1252[2][2]), vec3<f32>(_e1252[1][0], _e1252[1][1], _e1252[1][2]), _e1484);
                                                            phi_1988_ = select(_e1430, _e1426, _e1484);
                                                            phi_1989_ = select(_e1426, _e1434, _e1484);
                                                            phi_1990_ = select(_e1434, _e1430, _e1484);
                                                        }
                                                        let _e1490 = phi_1983_;
                                                        let _e1492 = phi_1984_;
                                                        let _e1494 = phi_1985_;
                                                        let _e1496 = phi_1986_;
                                                        let _e1498 = phi_1987_;
                                                        let _e1500 = phi_1988_;
                                                        let _e1502 = phi_1989_;
                                                        let _e1504 = phi_1990_;
                                                        let _e1511 = ((_e1502.y * _e1500.z) - (_e1500.y * _e1502.z));
                                                        let _e1516 = ((_e1502.z * _e1500.x) - (_e1500.z * _e1502.x));
                                                        let _e1519 = ((_e1502.x * _e1500.y) - (_e1500.x * _e1502.y));
                                                        let _e1522 = ((_e1315 >= _e1319) && (_e1315 >= _e1323));
                                                        let _e1523 = (_e1319 >= _e1323);
                                                        let _e1537 = (((_e1511 * (select(select(_e1252[2][0], _e1252[1][0], _e1523), _e1252[0][0], _e1522) - _e326)) + (_e1516 * (select(select(_e1252[2][1], _e1252[1][1], _e1523), _e1252[0][1], _e1522) - _e393))) + (_e1519 * (select(select(_e1252[2][2], _e1252[1][2], _e1523), _e1252[0][2], _e1522) - _e459)));
                                                        let _e1542 = (((_e1511 * _e363) + (_e1516 * _e429)) + (_e1519 * _e495));
                                                        let _e1543 = (_e1492 - _e1496);
                                                        let _e1544 = (_e1490 - _e1494);
                                                        let _e1547 = ((_e1543 * _e1543) + (_e1544 * _e1544));
                                                        let _e1554 = (-(((_e1496 * _e1543) + (_e1494 * _e1544))) / select(0.000000000000000000000000000000000000011754944f, _e1547, (_e1547 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1556 = select(1f, _e1554, (_e1554 < 1f));
                                                        let _e1558 = select(0f, _e1556, (_e1556 > 0f));
                                                        let _e1567 = ((_e1498.x + (_e1504.x * _e1558)) - _e326);
                                                        let _e1570 = ((_e1498.y + (_e1504.y * _e1558)) - _e393);
                                                        let _e1573 = ((_e1498.z + (_e1504.z * _e1558)) - _e459);
                                                        let _e1576 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                        let _e1579 = bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u));
                                                        let _e1581 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                        let _e1584 = bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u));
                                                        let _e1586 = select(_e1584, _e1581, (_e1581 > _e1584));
                                                        let _e1592 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
                                                        let _e1595 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                        let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                        let _e1600 = bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u));
                                                        let _e1619 = bitcast<f32>((bitcast<u32>(_e1502.x) & 2147483647u));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1502.y) & 2147483647u));
                                                        let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                        let _e1627 = bitcast<f32>((bitcast<u32>(_e1502.z) & 2147483647u));
                                                        let _e1633 = bitcast<f32>((bitcast<u32>(_e1500.x) & 2147483647u));
                                                        let _e1636 = bitcast<f32>((bitcast<u32>(_e1500.y) & 2147483647u));
                                                        let _e1638 = select(_e1636, _e1633, (_e1633 > _e1636));
                                                        let _e1641 = bitcast<f32>((bitcast<u32>(_e1500.z) & 2147483647u));
                                                        let _e1647 = ((bitcast<f32>((bitcast<u32>(((((_e1511 * _e1567) + (_e1516 * _e1570)) + (_e1519 * _e1573)) - _e1537)) & 2147483647u)) <= ((0.0000009536743f * select(_e1477, _e1586, (_e1586 > _e1477))) * select(_e1600, _e1597, (_e1597 > _e1600)))) && !((bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u)) <= ((0.0000038146973f * select(_e1627, _e1624, (_e1624 > _e1627))) * select(_e1641, _e1638, (_e1638 > _e1641))))));
                                                        let _e1648 = (_e1537 / _e1542);
                                                        if (_e1418 && !(_e1647)) {
                                                            let _e1651 = (_e1573 / _e495);
                                                            let _e1659 = (((_e1511 * (_e1567 - (_e363 * _e1651))) + (_e1516 * (_e1570 - (_e429 * _e1651)))) / _e1542);
                                                            phi_2181_ = select(select(_e1651, (_e1651 + _e1659), (bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u)) <= _e1477)), _e1648, _e1647);
                                                        } else {
                                                            phi_2181_ = _e1648;
                                                        }
                                                        let _e1668 = phi_2181_;
                                                        let _e1670 = select(_e1381, _e1668, (_e1668 < _e1381));
                                                        let _e1672 = select(_e1373, _e1670, (_e1670 > _e1373));
                                                        let _e1673 = (1f / _e1325);
                                                        phi_2201_ = type_37(_e1672, (_e1319 * _e1673), (_e1323 * _e1673), ((_e1418 && (_e1672 >= _e602)) && (_e1672 <= _e1156.member_1)));
                                                        phi_2202_ = type_37();
                                                    } else {
                                                        phi_2201_ = type_37();
                                                        phi_2202_ = type_37(0f, 0f, 0f, _e1418);
                                                    }
                                                    let _e1682 = phi_2201_;
                                                    let _e1684 = phi_2202_;
                                                    phi_2205_ = _e1682;
                                                    phi_2206_ = _e1684;
                                                    phi_2207_ = select(true, false, _e1418);
                                                } else {
                                                    phi_2205_ = type_37();
                                                    phi_2206_ = type_37(0f, 0f, 0f, _e1309);
                                                    phi_2207_ = true;
                                                }
                                                let _e1687 = phi_2205_;
                                                let _e1689 = phi_2206_;
                                                let _e1691 = phi_2207_;
                                                if _e1691 {
                                                    phi_2211_ = _e1689;
                                                } else {
                                                    phi_2211_ = _e1687;
                                                }
                                                let _e1693 = phi_2211_;
                                                if _e1693.member_3 {
                                                    phi_2220_ = type_21(_e1693.member, _e1693.member_1, _e1693.member_2, _e1185);
                                                } else {
                                                    phi_2220_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1700 = phi_2220_;
                                                if (_e1700.member_3 != 4294967295u) {
                                                    if (_e1185 != 4294967295u) {
                                                        if (_e1700.member < _e1156.member.member) {
                                                            phi_2246_ = true;
                                                        } else {
                                                            if (_e1700.member == _e1156.member.member) {
                                                                phi_2245_ = (_e1700.member_3 < _e1156.member.member_3);
                                                            } else {
                                                                phi_2245_ = false;
                                                            }
                                                            let _e1713 = phi_2245_;
                                                            phi_2246_ = _e1713;
                                                        }
                                                        let _e1715 = phi_2246_;
                                                        if _e1715 {
                                                            phi_2252_ = type_34(_e1700, _e1700.member);
                                                        } else {
                                                            phi_2252_ = _e1156;
                                                        }
                                                        let _e1718 = phi_2252_;
                                                        phi_2253_ = _e1718;
                                                    } else {
                                                        phi_2253_ = _e1156;
                                                    }
                                                    let _e1720 = phi_2253_;
                                                    phi_2254_ = _e1720;
                                                } else {
                                                    phi_2254_ = _e1156;
                                                }
                                                let _e1722 = phi_2254_;
                                                phi_1315_ = _e1722;
                                            } else {
                                                phi_1315_ = type_34();
                                            }
                                            let _e1724 = phi_1315_;
                                            continue;
                                            continuing {
                                                phi_1314_ = _e1724;
                                                phi_1317_ = _e1171;
                                                phi_3995_ = _e644;
                                                break if !(_e1177);
                                            }
                                        }
                                        let _e1727 = phi_3995_;
                                        phi_4148_ = _e1727;
                                        if _e1727 {
                                            break;
                                        }
                                        let _e1729 = local_10;
                                        phi_4152_ = _e1727;
                                        let _e2001 = local_12;
                                        phi_3481_ = _e2001;
                                        phi_3482_ = false;
                                        phi_3483_ = _e687;
                                        phi_3484_ = select(_e689, 0u, (_e602 > _e1729.member_1));
                                    } else {
                                        if (_e687.member_1 >= _e92) {
                                            phi_3020_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e687.member_1 < _e92) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e700 = (_e262 * 2u);
                                            let _e702 = ((1u + _e700) % 7u);
                                            if (_e702 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e707 = global_5.member[_e687.member_1][_e702];
                                            let _e709 = ((_e700 + 2u) % 7u);
                                            if (_e709 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e714 = global_5.member[_e687.member_1][_e709];
                                            let _e715 = (_e261 * 2u);
                                            let _e717 = ((1u + _e715) % 7u);
                                            if (_e717 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e722 = global_5.member[_e687.member_1][_e717];
                                            let _e724 = ((_e715 + 2u) % 7u);
                                            if (_e724 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e729 = global_5.member[_e687.member_1][_e724];
                                            let _e730 = (_e263 * 2u);
                                            let _e732 = ((1u + _e730) % 7u);
                                            if (_e732 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e737 = global_5.member[_e687.member_1][_e732];
                                            let _e739 = ((_e730 + 2u) % 7u);
                                            if (_e739 < 7u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e744 = global_5.member[_e687.member_1][_e739];
                                            let _e767 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.x - _e687.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e768 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.y - _e687.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e769 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.z - _e687.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e771 = select(_e142, _e767, (_e767 > _e142));
                                            let _e773 = select(_e142, _e768, (_e768 > _e142));
                                            let _e775 = select(_e142, _e769, (_e769 > _e142));
                                            let _e806 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e707 & 2097151u))) - 8388608f) * _e771));
                                            let _e811 = (bitcast<i32>((_e707 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e814 = bitcast<f32>((_e806 & bitcast<u32>(_e811)));
                                            let _e815 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 2097151u))) - 8388608f) * _e773));
                                            let _e820 = (bitcast<i32>((_e722 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e823 = bitcast<f32>((_e815 & bitcast<u32>(_e820)));
                                            let _e824 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 2097151u))) - 8388608f) * _e775));
                                            let _e829 = (bitcast<i32>((_e737 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e832 = bitcast<f32>((_e824 & bitcast<u32>(_e829)));
                                            let _e836 = bitcast<f32>((_e806 & bitcast<u32>(~(_e811))));
                                            let _e840 = bitcast<f32>((_e815 & bitcast<u32>(~(_e820))));
                                            let _e844 = bitcast<f32>((_e824 & bitcast<u32>(~(_e829))));
                                            let _e845 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e714 & 2097151u))) - 8388608f) * _e771));
                                            let _e850 = (bitcast<i32>((_e714 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e853 = bitcast<f32>((_e845 & bitcast<u32>(_e850)));
                                            let _e854 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e729 & 2097151u))) - 8388608f) * _e773));
                                            let _e859 = (bitcast<i32>((_e729 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e862 = bitcast<f32>((_e854 & bitcast<u32>(_e859)));
                                            let _e863 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e744 & 2097151u))) - 8388608f) * _e775));
                                            let _e868 = (bitcast<i32>((_e744 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e871 = bitcast<f32>((_e863 & bitcast<u32>(_e868)));
                                            let _e875 = bitcast<f32>((_e845 & bitcast<u32>(~(_e850))));
                                            let _e879 = bitcast<f32>((_e854 & bitcast<u32>(~(_e859))));
                                            let _e883 = bitcast<f32>((_e863 & bitcast<u32>(~(_e868))));
                                            let _e913 = global_5.member[_e687.member_1][0u];
                                            let _e917 = global_5.member[_e687.member_1][2u];
                                            let _e921 = global_5.member[_e687.member_1][4u];
                                            let _e925 = global_5.member[_e687.member_1][6u];
                                            let _e937 = (((_e917 >> bitcast<u32>(22i)) | ((_e921 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e925 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e938 = (_e913 & 268435455u);
                                            let _e939 = (_e937 & 268435455u);
                                            let _e942 = ((_e913 >> bitcast<u32>(28u)) & 7u);
                                            let _e950 = ((_e913 >> bitcast<u32>(31i)) | (((_e937 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e951 = (_e942 != 0u);
                                            if (_e942 == 0u) {
                                                phi_2982_ = _e938;
                                            } else {
                                                if (_e942 == 7u) {
                                                    phi_2981_ = 2147483648u;
                                                } else {
                                                    phi_2981_ = ((2147483648u | (_e942 << bitcast<u32>(28u))) | (_e939 & 268435455u));
                                                }
                                                let _e960 = phi_2981_;
                                                phi_2982_ = _e960;
                                            }
                                            let _e962 = phi_2982_;
                                            if _e951 {
                                                let _e963 = (_e942 != 7u);
                                                if _e963 {
                                                    phi_2992_ = (_e939 + _e942);
                                                } else {
                                                    phi_2992_ = u32();
                                                }
                                                let _e966 = phi_2992_;
                                                phi_2994_ = _e966;
                                                phi_2995_ = select(true, false, _e963);
                                            } else {
                                                phi_2994_ = u32();
                                                phi_2995_ = true;
                                            }
                                            let _e969 = phi_2994_;
                                            let _e971 = phi_2995_;
                                            if (_e950 == 0u) {
                                                phi_3016_ = (_e938 + select(0u, 1u, !(_e951)));
                                            } else {
                                                if (_e950 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e950 << bitcast<u32>(28u))) | (select(_e969, _e939, _e971) & 268435455u));
                                                }
                                                let _e984 = phi_3015_;
                                                phi_3016_ = _e984;
                                            }
                                            let _e986 = phi_3016_;
                                            phi_3020_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e687.member.member.x + _e814), (_e687.member.member.x + _e836), (_e687.member.member_1.x - _e853), (_e687.member.member_1.x - _e875)), vec4<f32>((_e687.member.member.y + _e823), (_e687.member.member.y + _e840), (_e687.member.member_1.y - _e862), (_e687.member.member_1.y - _e879)), vec4<f32>((_e687.member.member.z + _e832), (_e687.member.member.z + _e844), (_e687.member.member_1.z - _e871), (_e687.member.member_1.z - _e883))), type_51(type_29((_e687.member.member + vec4<f32>(_e814, _e823, _e832, 0f)), (_e687.member.member_1 - vec4<f32>(_e853, _e862, _e871, 0f))), _e962), type_51(type_29((_e687.member.member + vec4<f32>(_e836, _e840, _e844, 0f)), (_e687.member.member_1 - vec4<f32>(_e875, _e879, _e883, 0f))), _e986));
                                        }
                                        let _e991 = phi_3020_;
                                        let _e1003 = ((_e991.member[0].x - _e364) * _e367);
                                        let _e1004 = ((_e991.member[0].y - _e364) * _e367);
                                        let _e1005 = ((_e991.member[0].z - _e365) * _e367);
                                        let _e1006 = ((_e991.member[0].w - _e365) * _e367);
                                        let _e1016 = ((_e991.member[1].x - _e430) * _e433);
                                        let _e1017 = ((_e991.member[1].y - _e430) * _e433);
                                        let _e1018 = ((_e991.member[1].z - _e431) * _e433);
                                        let _e1019 = ((_e991.member[1].w - _e431) * _e433);
                                        let _e1029 = ((_e991.member[2].x - _e496) * _e499);
                                        let _e1030 = ((_e991.member[2].y - _e496) * _e499);
                                        let _e1031 = ((_e991.member[2].z - _e497) * _e499);
                                        let _e1032 = ((_e991.member[2].w - _e497) * _e499);
                                        let _e1034 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1036 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1038 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1040 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1042 = select(_e1005, _e1003, (_e1003 < _e1005));
                                        let _e1044 = select(_e1006, _e1004, (_e1004 < _e1006));
                                        let _e1046 = select(_e1018, _e1016, (_e1016 < _e1018));
                                        let _e1048 = select(_e1019, _e1017, (_e1017 < _e1019));
                                        let _e1050 = select(_e1046, _e1042, (_e1042 > _e1046));
                                        let _e1052 = select(_e1048, _e1044, (_e1044 > _e1048));
                                        let _e1054 = select(_e1034, _e1050, (_e1050 > _e1034));
                                        let _e1056 = select(_e1036, _e1052, (_e1052 > _e1036));
                                        let _e1058 = select(_e1005, _e1003, (_e1003 > _e1005));
                                        let _e1060 = select(_e1006, _e1004, (_e1004 > _e1006));
                                        let _e1062 = select(_e1018, _e1016, (_e1016 > _e1018));
                                        let _e1064 = select(_e1019, _e1017, (_e1017 > _e1019));
                                        let _e1066 = select(_e1062, _e1058, (_e1058 < _e1062));
                                        let _e1068 = select(_e1064, _e1060, (_e1060 < _e1064));
                                        let _e1073 = -(_e1034);
                                        let _e1074 = -(_e1036);
                                        let _e1081 = (select(_e1038, _e1066, (_e1066 < _e1038)) + (select(_e1073, _e1038, (_e1038 > _e1073)) * 0.0000019073523f));
                                        let _e1082 = (select(_e1040, _e1068, (_e1068 < _e1040)) + (select(_e1074, _e1040, (_e1040 > _e1074)) * 0.0000019073523f));
                                        let _e1084 = select(_e602, _e1054, (_e1054 > _e602));
                                        let _e1086 = select(_e602, _e1056, (_e1056 > _e602));
                                        let _e1091 = (_e1084 <= select(_e646.member_1, _e1081, (_e1081 < _e646.member_1)));
                                        let _e1092 = (_e1086 <= select(_e646.member_1, _e1082, (_e1082 < _e646.member_1)));
                                        let _e1093 = (_e1084 <= _e1086);
                                        if _e1091 {
                                            if _e1092 {
                                                if _e1093 {
                                                    phi_3382_ = _e991.member_2;
                                                } else {
                                                    phi_3382_ = _e991.member_1;
                                                }
                                                let _e1097 = phi_3382_;
                                                let _e1118 = (_e689 % 128u);
                                                let _e1119 = (_e1118 < 128u);
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_8[_e1118] = _e1097.member_1;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_7[_e1118] = _e1097.member.member.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_6[_e1118] = _e1097.member.member.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_5[_e1118] = _e1097.member.member.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_4[_e1118] = _e1097.member.member_1.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_3[_e1118] = _e1097.member.member_1.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_2[_e1118] = _e1097.member.member_1.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_9[_e1118] = select(_e1084, _e1086, _e1093);
                                                if _e1093 {
                                                    phi_3458_ = _e991.member_1;
                                                } else {
                                                    phi_3458_ = _e991.member_2;
                                                }
                                                let _e1132 = phi_3458_;
                                                phi_3459_ = _e1132;
                                                phi_3460_ = (_e689 + 1u);
                                            } else {
                                                phi_3459_ = type_51();
                                                phi_3460_ = u32();
                                            }
                                            let _e1134 = phi_3459_;
                                            let _e1136 = phi_3460_;
                                            phi_3462_ = _e1134;
                                            phi_3463_ = _e1136;
                                            phi_3464_ = select(true, false, _e1092);
                                        } else {
                                            phi_3462_ = type_51();
                                            phi_3463_ = u32();
                                            phi_3464_ = true;
                                        }
                                        let _e1139 = phi_3462_;
                                        let _e1141 = phi_3463_;
                                        let _e1143 = phi_3464_;
                                        if _e1143 {
                                            if _e1091 {
                                                phi_3473_ = _e991.member_1;
                                            } else {
                                                phi_3473_ = _e991.member_2;
                                            }
                                            let _e1147 = phi_3473_;
                                            phi_3478_ = select(_e1092, true, _e1091);
                                            phi_3479_ = _e1147;
                                        } else {
                                            phi_3478_ = _e685;
                                            phi_3479_ = _e1139;
                                        }
                                        let _e1150 = phi_3478_;
                                        let _e1152 = phi_3479_;
                                        phi_4152_ = _e644;
                                        phi_3481_ = _e646;
                                        phi_3482_ = _e1150;
                                        phi_3483_ = _e1152;
                                        phi_3484_ = select(_e1141, _e689, _e1143);
                                    }
                                    let _e1734 = phi_4152_;
                                    let _e1736 = phi_3481_;
                                    let _e1738 = phi_3482_;
                                    let _e1740 = phi_3483_;
                                    let _e1742 = phi_3484_;
                                    phi_4151_ = _e1734;
                                    phi_3485_ = _e1736;
                                    phi_3486_ = _e1738;
                                    phi_3487_ = _e1740;
                                    phi_3488_ = _e1742;
                                    phi_3489_ = (_e654 - 1u);
                                } else {
                                    phi_4151_ = _e644;
                                    phi_3485_ = _e646;
                                    phi_3486_ = _e685;
                                    phi_3487_ = _e687;
                                    phi_3488_ = _e689;
                                    phi_3489_ = _e654;
                                }
                                let _e1744 = phi_4151_;
                                let _e1746 = phi_3485_;
                                let _e1748 = phi_3486_;
                                let _e1750 = phi_3487_;
                                let _e1752 = phi_3488_;
                                let _e1754 = phi_3489_;
                                phi_4150_ = _e1744;
                                phi_3490_ = _e1746;
                                phi_3491_ = _e1748;
                                phi_3492_ = _e1750;
                                phi_3493_ = _e1752;
                                phi_3494_ = _e1754;
                            } else {
                                phi_4150_ = _e644;
                                phi_3490_ = type_34();
                                phi_3491_ = bool();
                                phi_3492_ = type_51();
                                phi_3493_ = u32();
                                phi_3494_ = u32();
                            }
                            let _e1756 = phi_4150_;
                            let _e1758 = phi_3490_;
                            let _e1760 = phi_3491_;
                            let _e1762 = phi_3492_;
                            let _e1764 = phi_3493_;
                            let _e1766 = phi_3494_;
                            phi_4149_ = _e1756;
                            phi_1189_ = _e1758;
                            phi_1192_ = _e1760;
                            phi_1194_ = _e1762;
                            phi_1196_ = _e1764;
                            phi_1198_ = _e1766;
                            phi_3495_ = _e658;
                        } else {
                            phi_4149_ = _e644;
                            phi_1189_ = type_34();
                            phi_1192_ = bool();
                            phi_1194_ = type_51();
                            phi_1196_ = u32();
                            phi_1198_ = u32();
                            phi_3495_ = false;
                        }
                        let _e1768 = phi_4149_;
                        let _e1770 = phi_1189_;
                        let _e1772 = phi_1192_;
                        let _e1774 = phi_1194_;
                        let _e1776 = phi_1196_;
                        let _e1778 = phi_1198_;
                        let _e1780 = phi_3495_;
                        continue;
                        continuing {
                            phi_4001_ = _e1768;
                            phi_1188_ = _e1770;
                            phi_1191_ = _e1772;
                            phi_1193_ = _e1774;
                            phi_1195_ = _e1776;
                            phi_1197_ = _e1778;
                            phi_4148_ = _e1768;
                            break if !(_e1780);
                        }
                    }
                    let _e1783 = phi_4148_;
                    if _e1783 {
                        break;
                    }
                    let _e1785 = local_11;
                    if (_e1785.member.member_3 != 4294967295u) {
                        let _e1790 = -(_e504);
                        let _e1791 = bitcast<u32>(_e1785.member.member);
                        let _e1795 = (bitcast<i32>((_e1791 >> bitcast<u32>(23i))) & 255i);
                        let _e1796 = (_e1795 + _e1790);
                        if (_e1795 == 255i) {
                            phi_3554_ = _e1785.member.member;
                        } else {
                            if (_e1795 > 0i) {
                                if (_e1796 > 0i) {
                                    let _e1800 = (_e1796 < 255i);
                                    if _e1800 {
                                        phi_3533_ = bitcast<f32>((_e1791 + bitcast<u32>((_e1790 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3533_ = f32();
                                    }
                                    let _e1807 = phi_3533_;
                                    phi_3535_ = _e1807;
                                    phi_3536_ = select(true, false, _e1800);
                                } else {
                                    phi_3535_ = f32();
                                    phi_3536_ = true;
                                }
                                let _e1810 = phi_3535_;
                                let _e1812 = phi_3536_;
                                phi_3537_ = _e1810;
                                phi_3538_ = _e1812;
                            } else {
                                phi_3537_ = f32();
                                phi_3538_ = true;
                            }
                            let _e1814 = phi_3537_;
                            let _e1816 = phi_3538_;
                            if _e1816 {
                                let _e1817 = (_e1791 & 2147483648u);
                                let _e1824 = ((_e1791 & 8388607u) | (select(0u, 1u, ((_e1791 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1828 = (_e1824 == 0u);
                                if _e1828 {
                                    phi_3953_ = bitcast<f32>(_e1817);
                                } else {
                                    let _e1833 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1824)), 32u, _e1828) - 8u);
                                    let _e1836 = (_e1824 << bitcast<u32>((_e1833 & 31u)));
                                    let _e1838 = ((_e1796 + select(0i, 1i, (_e1795 == 0i))) - bitcast<i32>(_e1833));
                                    if (_e1838 >= 255i) {
                                        phi_3943_ = bitcast<f32>((_e1817 | 2139095040u));
                                        phi_3944_ = f32();
                                        phi_3945_ = true;
                                    } else {
                                        let _e1840 = (_e1838 > 0i);
                                        if _e1840 {
                                            phi_3937_ = bitcast<f32>(((_e1817 | (bitcast<u32>(_e1838) << bitcast<u32>(23i))) | (_e1836 & 8388607u)));
                                            phi_3938_ = f32();
                                        } else {
                                            if (_e1838 < -24i) {
                                                phi_3903_ = 26u;
                                            } else {
                                                phi_3903_ = bitcast<u32>((1i - _e1838));
                                            }
                                            let _e1845 = phi_3903_;
                                            let _e1846 = (_e1845 & 31u);
                                            let _e1848 = (_e1836 >> bitcast<u32>(_e1846));
                                            let _e1852 = (_e1836 & ((1u << bitcast<u32>(_e1846)) - 1u));
                                            let _e1856 = (1u << bitcast<u32>(((_e1845 - 1u) & 31u)));
                                            if (_e1852 > _e1856) {
                                                phi_3924_ = true;
                                            } else {
                                                if (_e1852 == _e1856) {
                                                    phi_3921_ = ((_e1848 & 1u) == 1u);
                                                } else {
                                                    phi_3921_ = false;
                                                }
                                                let _e1862 = phi_3921_;
                                                phi_3924_ = _e1862;
                                            }
                                            let _e1864 = phi_3924_;
                                            phi_3937_ = f32();
                                            phi_3938_ = bitcast<f32>((_e1817 | (_e1848 + select(0u, 1u, _e1864))));
                                        }
                                        let _e1877 = phi_3937_;
                                        let _e1879 = phi_3938_;
                                        phi_3943_ = _e1877;
                                        phi_3944_ = _e1879;
                                        phi_3945_ = _e1840;
                                    }
                                    let _e1883 = phi_3943_;
                                    let _e1885 = phi_3944_;
                                    let _e1887 = phi_3945_;
                                    phi_3953_ = select(_e1885, _e1883, _e1887);
                                }
                                let _e1891 = phi_3953_;
                                phi_3553_ = _e1891;
                            } else {
                                phi_3553_ = _e1814;
                            }
                            let _e1893 = phi_3553_;
                            phi_3554_ = _e1893;
                        }
                        let _e1895 = phi_3554_;
                        let _e1896 = bitcast<u32>(_e1895);
                        if ((_e1896 & 2147483647u) >= 2139095040u) {
                            phi_3566_ = bitcast<f32>(((_e1896 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3566_ = _e1895;
                        }
                        let _e1903 = phi_3566_;
                        phi_3571_ = type_21(_e1903, _e1785.member.member_1, _e1785.member.member_2, _e1785.member.member_3);
                    } else {
                        phi_3571_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1908 = phi_3571_;
                    if _e150 {
                    } else {
                        break;
                    }
                    global_6.member[_e148] = _e1908;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
