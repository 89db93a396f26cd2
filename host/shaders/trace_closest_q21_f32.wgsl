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
    var phi_492_: i32;
    var phi_493_: i32;
    var phi_503_: bool;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_516_: bool;
    var phi_521_: u32;
    var phi_534_: i32;
    var phi_554_: i32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_868_: f32;
    var phi_874_: f32;
    var phi_993_: i32;
    var phi_1015_: u32;
    var phi_1016_: u32;
    var phi_1053_: i32;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_4072_: bool;
    var phi_1181_: type_34;
    var phi_1184_: u32;
    var phi_1186_: bool;
    var phi_1188_: u32;
    var phi_1190_: type_51;
    var phi_1201_: bool;
    var phi_1287_: bool;
    var phi_1288_: u32;
    var phi_1289_: type_51;
    var phi_1307_: type_34;
    var phi_1310_: type_4;
    var phi_1311_: type_4;
    var phi_1333_: type_4;
    var phi_1354_: u32;
    var phi_1446_: array<array<f32, 3>, 3>;
    var phi_3633_: bool;
    var phi_3648_: bool;
    var phi_3663_: bool;
    var phi_3678_: bool;
    var phi_3693_: bool;
    var phi_3708_: bool;
    var phi_1988_: f32;
    var phi_1989_: f32;
    var phi_1990_: f32;
    var phi_1991_: f32;
    var phi_1992_: vec3<f32>;
    var phi_1993_: vec3<f32>;
    var phi_1994_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_3723_: bool;
    var phi_3738_: bool;
    var phi_3753_: bool;
    var phi_3768_: bool;
    var phi_3783_: bool;
    var phi_3798_: bool;
    var phi_2203_: f32;
    var phi_2223_: type_37;
    var phi_2224_: type_37;
    var phi_2227_: type_37;
    var phi_2228_: type_37;
    var phi_2229_: bool;
    var phi_2233_: type_37;
    var phi_2242_: type_21;
    var phi_2267_: bool;
    var phi_2268_: bool;
    var phi_2274_: type_34;
    var phi_2275_: type_34;
    var phi_2276_: type_34;
    var phi_1308_: type_34;
    var phi_4066_: bool;
    var phi_4317_: bool;
    var phi_2277_: type_34;
    var phi_3004_: u32;
    var phi_3005_: u32;
    var phi_3015_: u32;
    var phi_3017_: u32;
    var phi_3018_: bool;
    var phi_3038_: u32;
    var phi_3039_: u32;
    var phi_3043_: type_52;
    var phi_3405_: type_51;
    var phi_3481_: type_51;
    var phi_3482_: u32;
    var phi_3483_: type_51;
    var phi_3485_: u32;
    var phi_3486_: type_51;
    var phi_3487_: bool;
    var phi_3496_: type_51;
    var phi_3501_: bool;
    var phi_3503_: type_51;
    var phi_3507_: bool;
    var phi_3508_: u32;
    var phi_3509_: type_51;
    var phi_3519_: type_51;
    var phi_4234_: bool;
    var phi_3520_: type_34;
    var phi_3521_: u32;
    var phi_3522_: bool;
    var phi_3523_: u32;
    var phi_3524_: type_51;
    var phi_4233_: bool;
    var phi_3525_: type_34;
    var phi_3526_: u32;
    var phi_3527_: bool;
    var phi_3528_: u32;
    var phi_3529_: type_51;
    var phi_4232_: bool;
    var phi_1182_: type_34;
    var phi_1185_: u32;
    var phi_1187_: bool;
    var phi_1189_: u32;
    var phi_1191_: type_51;
    var phi_3530_: bool;
    var phi_4231_: bool;
    var local_10: type_34;
    var phi_3568_: f32;
    var phi_3570_: f32;
    var phi_3571_: bool;
    var phi_3572_: f32;
    var phi_3573_: bool;
    var phi_3974_: u32;
    var phi_3992_: bool;
    var phi_3995_: bool;
    var phi_4008_: f32;
    var phi_4009_: f32;
    var phi_4014_: f32;
    var phi_4015_: f32;
    var phi_4016_: bool;
    var phi_4024_: f32;
    var phi_3588_: f32;
    var phi_3589_: f32;
    var phi_3601_: f32;
    var phi_3606_: type_21;
    var local_11: type_34;

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
                            phi_492_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_492_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                        }
                        let _e241 = phi_492_;
                        phi_493_ = _e241;
                    } else {
                        phi_493_ = 0i;
                    }
                    let _e243 = phi_493_;
                    let _e244 = (_e160 == _e199);
                    if _e244 {
                        phi_503_ = true;
                    } else {
                        phi_503_ = (_e167 == _e199);
                    }
                    let _e247 = phi_503_;
                    let _e248 = select(1u, 0u, _e244);
                    if _e247 {
                        let _e249 = (_e248 + 1u);
                        phi_513_ = _e249;
                        phi_514_ = _e249;
                        phi_516_ = select(true, false, (_e249 == 2u));
                    } else {
                        phi_513_ = u32();
                        phi_514_ = 0u;
                        phi_516_ = true;
                    }
                    let _e253 = phi_513_;
                    let _e255 = phi_514_;
                    let _e257 = phi_516_;
                    if _e257 {
                        phi_521_ = (_e255 + 1u);
                    } else {
                        phi_521_ = 0u;
                    }
                    let _e261 = phi_521_;
                    let _e262 = select(_e253, _e255, _e257);
                    let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                    if (_e130 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e130, 127i, (_e130 > 127i));
                    }
                    let _e268 = phi_534_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e130 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = -(_e243);
                    if (_e280 < -126i) {
                        phi_554_ = -126i;
                    } else {
                        phi_554_ = select(_e280, 127i, (_e280 > 127i));
                    }
                    let _e285 = phi_554_;
                    let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                    let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                    let _e300 = global_4.member[_e148].member;
                    let _e301 = (_e262 == 0u);
                    if _e301 {
                        phi_572_ = _e300[0];
                    } else {
                        phi_572_ = _e300[1];
                    }
                    let _e305 = phi_572_;
                    let _e306 = (_e262 == 2u);
                    if _e306 {
                        phi_578_ = _e300[2];
                    } else {
                        phi_578_ = _e305;
                    }
                    let _e309 = phi_578_;
                    let _e310 = bitcast<u32>(_e309);
                    let _e312 = ((_e310 & 2139095040u) != 0u);
                    let _e326 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e310 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e310 & 2147483648u))), _e309, _e312) * _e273) * select(0.00000011920929f, 1f, _e312)) * _e279);
                    let _e327 = global_4.member[_e148].member_2;
                    if _e301 {
                        phi_618_ = _e327[0];
                    } else {
                        phi_618_ = _e327[1];
                    }
                    let _e331 = phi_618_;
                    if _e306 {
                        phi_624_ = _e327[2];
                    } else {
                        phi_624_ = _e331;
                    }
                    let _e334 = phi_624_;
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
                        phi_697_ = _e300[0];
                    } else {
                        phi_697_ = _e300[1];
                    }
                    let _e372 = phi_697_;
                    let _e373 = (_e261 == 2u);
                    if _e373 {
                        phi_703_ = _e300[2];
                    } else {
                        phi_703_ = _e372;
                    }
                    let _e376 = phi_703_;
                    let _e377 = bitcast<u32>(_e376);
                    let _e379 = ((_e377 & 2139095040u) != 0u);
                    let _e393 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * _e273) * select(0.00000011920929f, 1f, _e379)) * _e279);
                    if _e368 {
                        phi_743_ = _e327[0];
                    } else {
                        phi_743_ = _e327[1];
                    }
                    let _e397 = phi_743_;
                    if _e373 {
                        phi_749_ = _e327[2];
                    } else {
                        phi_749_ = _e397;
                    }
                    let _e400 = phi_749_;
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
                        phi_822_ = _e300[0];
                    } else {
                        phi_822_ = _e300[1];
                    }
                    let _e438 = phi_822_;
                    let _e439 = (_e263 == 2u);
                    if _e439 {
                        phi_828_ = _e300[2];
                    } else {
                        phi_828_ = _e438;
                    }
                    let _e442 = phi_828_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e459 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * _e273) * select(0.00000011920929f, 1f, _e445)) * _e279);
                    if _e434 {
                        phi_868_ = _e327[0];
                    } else {
                        phi_868_ = _e327[1];
                    }
                    let _e463 = phi_868_;
                    if _e439 {
                        phi_874_ = _e327[2];
                    } else {
                        phi_874_ = _e463;
                    }
                    let _e466 = phi_874_;
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
                            phi_993_ = 255i;
                        } else {
                            phi_993_ = (((_e517 + select(0i, 1i, (_e517 == 0i))) - _e524) + _e504);
                        }
                        let _e532 = phi_993_;
                        let _e542 = (_e532 <= 0i);
                        if _e542 {
                            phi_1016_ = u32();
                        } else {
                            if _e521 {
                                phi_1015_ = u32();
                            } else {
                                phi_1015_ = select(((bitcast<u32>(_e532) << bitcast<u32>(23i)) | ((_e514 << bitcast<u32>(((_e524 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e532 >= 255i));
                            }
                            let _e546 = phi_1015_;
                            phi_1016_ = _e546;
                        }
                        let _e548 = phi_1016_;
                        let _e560 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e563 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                        let _e567 = (_e560 == 0u);
                        let _e570 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e560)), 32u, _e567)) - 8i);
                        if (_e563 == 255i) {
                            phi_1053_ = 255i;
                        } else {
                            phi_1053_ = (((_e563 + select(0i, 1i, (_e563 == 0i))) - _e570) + _e504);
                        }
                        let _e578 = phi_1053_;
                        let _e588 = (_e578 <= 0i);
                        if _e588 {
                            phi_1076_ = u32();
                        } else {
                            if _e567 {
                                phi_1075_ = u32();
                            } else {
                                phi_1075_ = select(((bitcast<u32>(_e578) << bitcast<u32>(23i)) | ((_e560 << bitcast<u32>(((_e570 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e578 >= 255i));
                            }
                            let _e592 = phi_1075_;
                            phi_1076_ = _e592;
                        }
                        let _e594 = phi_1076_;
                        phi_1084_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e594, 0u, select(_e567, true, _e588))));
                        phi_1085_ = bitcast<f32>(((_e210 & 2147483648u) | select(_e548, 0u, select(_e521, true, _e542))));
                    } else {
                        phi_1084_ = 0f;
                        phi_1085_ = 1f;
                    }
                    let _e600 = phi_1084_;
                    let _e602 = phi_1085_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e606 = (_e262 % 3u);
                    let _e607 = (_e606 < 3u);
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e609 = local_1[_e606];
                    let _e612 = (_e261 % 3u);
                    let _e613 = (_e612 < 3u);
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e615 = local_1[_e612];
                    let _e618 = (_e263 % 3u);
                    let _e619 = (_e618 < 3u);
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e621 = local_1[_e618];
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e626 = local[_e606];
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e630 = local[_e612];
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e618];
                    phi_4072_ = false;
                    phi_1181_ = type_34(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e600);
                    phi_1184_ = ((3u * _e92) + 1u);
                    phi_1186_ = (_e602 <= _e600);
                    phi_1188_ = 0u;
                    phi_1190_ = type_51(type_29(vec4<f32>((f32(_e609) * _e142), (f32(_e615) * _e142), (f32(_e621) * _e142), 0f), vec4<f32>((f32(_e626) * _e142), (f32(_e630) * _e142), (f32(_e634) * _e142), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    loop {
                        let _e644 = phi_4072_;
                        let _e646 = phi_1181_;
                        let _e648 = phi_1184_;
                        let _e650 = phi_1186_;
                        let _e652 = phi_1188_;
                        let _e654 = phi_1190_;
                        local_10 = _e646;
                        if _e650 {
                            phi_1201_ = true;
                        } else {
                            phi_1201_ = (_e652 > 0u);
                        }
                        let _e657 = phi_1201_;
                        if _e657 {
                            let _e658 = (_e648 > 0u);
                            if _e658 {
                                if _e650 {
                                    phi_1287_ = _e650;
                                    phi_1288_ = _e652;
                                    phi_1289_ = _e654;
                                } else {
                                    let _e659 = (_e652 - 1u);
                                    let _e660 = (_e659 % 128u);
                                    let _e661 = (_e660 < 128u);
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e663 = local_7[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e665 = local_6[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e667 = local_5[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e669 = local_4[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e671 = local_3[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e673 = local_2[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e678 = local_8[_e660];
                                    if _e661 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e681 = local_9[_e660];
                                    phi_1287_ = (_e681 <= _e646.member_1);
                                    phi_1288_ = _e659;
                                    phi_1289_ = type_51(type_29(vec4<f32>(_e663, _e665, _e667, 0f), vec4<f32>(_e669, _e671, _e673, 0f)), _e678);
                                }
                                let _e685 = phi_1287_;
                                let _e687 = phi_1288_;
                                let _e689 = phi_1289_;
                                if _e685 {
                                    let _e693 = ((_e689.member_1 & 2147483648u) != 0u);
                                    if _e693 {
                                        phi_1307_ = _e646;
                                        phi_1310_ = type_4(0u, ((_e689.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e700 = phi_1307_;
                                            let _e702 = phi_1310_;
                                            local_11 = _e700;
                                            if (_e702.member < _e702.member_1) {
                                                phi_1311_ = type_4((_e702.member + 1u), _e702.member_1);
                                                phi_1333_ = type_4(1u, _e702.member);
                                            } else {
                                                phi_1311_ = _e702;
                                                phi_1333_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e715 = phi_1311_;
                                            let _e717 = phi_1333_;
                                            let _e721 = (bitcast<i32>(_e717.member) != 0i);
                                            if _e721 {
                                                let _e722 = ((_e689.member_1 & 268435455u) + _e717.member_1);
                                                let _e723 = (_e722 < _e94);
                                                if _e723 {
                                                    if _e723 {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e727 = global_2.member[_e722].member_1;
                                                    phi_1354_ = _e727;
                                                } else {
                                                    phi_1354_ = 4294967295u;
                                                }
                                                let _e729 = phi_1354_;
                                                if (_e722 >= _e94) {
                                                    phi_1446_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e723 {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    if (_e606 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e736 = global_2.member[_e722].member[_e606];
                                                    if (_e612 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e742 = global_2.member[_e722].member[_e612];
                                                    if (_e618 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_2.member[_e722].member[_e618];
                                                    let _e750 = (3u + _e606);
                                                    if (_e750 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e756 = global_2.member[_e722].member[_e750];
                                                    let _e757 = (3u + _e612);
                                                    if (_e757 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e763 = global_2.member[_e722].member[_e757];
                                                    let _e764 = (3u + _e618);
                                                    if (_e764 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e770 = global_2.member[_e722].member[_e764];
                                                    let _e772 = (6u + _e606);
                                                    if (_e772 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e778 = global_2.member[_e722].member[_e772];
                                                    let _e779 = (6u + _e612);
                                                    if (_e779 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e785 = global_2.member[_e722].member[_e779];
                                                    let _e786 = (6u + _e618);
                                                    if (_e786 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e792 = global_2.member[_e722].member[_e786];
                                                    phi_1446_ = array<array<f32, 3>, 3>(array<f32, 3>(_e736, _e742, _e748), array<f32, 3>(_e756, _e763, _e770), array<f32, 3>(_e778, _e785, _e792));
                                                }
                                                let _e796 = phi_1446_;
                                                let _e812 = (_e796[0][2] - _e459);
                                                let _e815 = (((_e796[0][0] - _e326) * _e495) - (_e812 * _e363));
                                                let _e818 = (((_e796[0][1] - _e393) * _e495) - (_e812 * _e429));
                                                let _e821 = (_e796[1][2] - _e459);
                                                let _e824 = (((_e796[1][0] - _e326) * _e495) - (_e821 * _e363));
                                                let _e827 = (((_e796[1][1] - _e393) * _e495) - (_e821 * _e429));
                                                let _e830 = (_e796[2][2] - _e459);
                                                let _e833 = (((_e796[2][0] - _e326) * _e495) - (_e830 * _e363));
                                                let _e836 = (((_e796[2][1] - _e393) * _e495) - (_e830 * _e429));
                                                let _e837 = (_e833 * _e827);
                                                let _e838 = (_e836 * _e824);
                                                let _e839 = (_e815 * _e836);
                                                let _e840 = (_e818 * _e833);
                                                let _e841 = (_e824 * _e818);
                                                let _e842 = (_e827 * _e815);
                                                let _e847 = (((_e837 >= _e838) && (_e839 >= _e840)) && (_e841 >= _e842));
                                                let _e853 = (_e847 || (((_e837 <= _e838) && (_e839 <= _e840)) && (_e841 <= _e842)));
                                                if _e853 {
                                                    let _e855 = select(-1f, 1f, _e847);
                                                    let _e857 = ((_e837 - _e838) * _e855);
                                                    let _e859 = select(0f, _e857, (_e857 > 0f));
                                                    let _e861 = ((_e839 - _e840) * _e855);
                                                    let _e863 = select(0f, _e861, (_e861 > 0f));
                                                    let _e865 = ((_e841 - _e842) * _e855);
                                                    let _e867 = select(0f, _e865, (_e865 > 0f));
                                                    let _e869 = ((_e859 + _e863) + _e867);
                                                    let _e871 = select(_e796[1][0], _e796[0][0], (_e796[0][0] < _e796[1][0]));
                                                    let _e875 = select(_e796[1][0], _e796[0][0], (_e796[0][0] > _e796[1][0]));
                                                    let _e879 = select(_e796[1][1], _e796[0][1], (_e796[0][1] < _e796[1][1]));
                                                    let _e883 = select(_e796[1][1], _e796[0][1], (_e796[0][1] > _e796[1][1]));
                                                    let _e887 = select(_e796[1][2], _e796[0][2], (_e796[0][2] < _e796[1][2]));
                                                    let _e891 = select(_e796[1][2], _e796[0][2], (_e796[0][2] > _e796[1][2]));
                                                    let _e896 = ((select(_e796[2][0], _e871, (_e871 < _e796[2][0])) - _e364) * _e367);
                                                    let _e897 = ((select(_e796[2][0], _e875, (_e875 > _e796[2][0])) - _e365) * _e367);
                                                    let _e900 = ((select(_e796[2][1], _e879, (_e879 < _e796[2][1])) - _e430) * _e433);
                                                    let _e901 = ((select(_e796[2][1], _e883, (_e883 > _e796[2][1])) - _e431) * _e433);
                                                    let _e904 = ((select(_e796[2][2], _e887, (_e887 < _e796[2][2])) - _e496) * _e499);
                                                    let _e905 = ((select(_e796[2][2], _e891, (_e891 > _e796[2][2])) - _e497) * _e499);
                                                    let _e907 = select(_e905, _e904, (_e904 < _e905));
                                                    let _e909 = select(_e905, _e904, (_e904 > _e905));
                                                    let _e911 = select(_e897, _e896, (_e896 < _e897));
                                                    let _e913 = select(_e901, _e900, (_e900 < _e901));
                                                    let _e915 = select(_e913, _e911, (_e911 > _e913));
                                                    let _e917 = select(_e907, _e915, (_e915 > _e907));
                                                    let _e919 = select(_e897, _e896, (_e896 > _e897));
                                                    let _e921 = select(_e901, _e900, (_e900 > _e901));
                                                    let _e923 = select(_e921, _e919, (_e919 < _e921));
                                                    let _e925 = select(_e909, _e923, (_e923 < _e909));
                                                    let _e926 = -(_e907);
                                                    let _e932 = select(_e602, _e917, (_e917 > _e602));
                                                    let _e936 = select(_e824, _e815, (_e815 < _e824));
                                                    let _e941 = select(_e824, _e815, (_e815 > _e824));
                                                    let _e948 = select(_e827, _e818, (_e818 < _e827));
                                                    let _e953 = select(_e827, _e818, (_e818 > _e827));
                                                    let _e962 = (((((_e853 && (_e869 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e833, _e936, (_e936 < _e833)) <= 0f) && (select(_e833, _e941, (_e941 > _e833)) >= 0f))) && ((select(_e836, _e948, (_e948 < _e836)) <= 0f) && (select(_e836, _e953, (_e953 > _e836)) >= 0f))) && (_e932 <= (_e925 + (select(_e926, _e909, (_e909 > _e926)) * 0.0000019073523f)))) && (_e932 <= _e700.member_1));
                                                    if _e962 {
                                                        let _e967 = (_e796[1][0] - _e796[0][0]);
                                                        let _e968 = (_e796[1][1] - _e796[0][1]);
                                                        let _e969 = (_e796[1][2] - _e796[0][2]);
                                                        let _e970 = vec3<f32>(_e967, _e968, _e969);
                                                        let _e971 = (_e796[2][0] - _e796[1][0]);
                                                        let _e972 = (_e796[2][1] - _e796[1][1]);
                                                        let _e973 = (_e796[2][2] - _e796[1][2]);
                                                        let _e974 = vec3<f32>(_e971, _e972, _e973);
                                                        let _e975 = (_e796[0][0] - _e796[2][0]);
                                                        let _e976 = (_e796[0][1] - _e796[2][1]);
                                                        let _e977 = (_e796[0][2] - _e796[2][2]);
                                                        let _e978 = vec3<f32>(_e975, _e976, _e977);
                                                        let _e979 = abs(_e967);
                                                        let _e980 = abs(_e968);
                                                        if (_e979 != _e979) {
                                                            phi_3633_ = true;
                                                        } else {
                                                            phi_3633_ = (_e980 >= _e979);
                                                        }
                                                        let _e984 = phi_3633_;
                                                        let _e985 = select(_e979, _e980, _e984);
                                                        let _e986 = abs(_e969);
                                                        if (_e985 != _e985) {
                                                            phi_3648_ = true;
                                                        } else {
                                                            phi_3648_ = (_e986 >= _e985);
                                                        }
                                                        let _e990 = phi_3648_;
                                                        let _e991 = select(_e985, _e986, _e990);
                                                        let _e992 = abs(_e971);
                                                        let _e993 = abs(_e972);
                                                        if (_e992 != _e992) {
                                                            phi_3663_ = true;
                                                        } else {
                                                            phi_3663_ = (_e993 >= _e992);
                                                        }
                                                        let _e997 = phi_3663_;
                                                        let _e998 = select(_e992, _e993, _e997);
                                                        let _e999 = abs(_e973);
                                                        if (_e998 != _e998) {
                                                            phi_3678_ = true;
                                                        } else {
                                                            phi_3678_ = (_e999 >= _e998);
                                                        }
                                                        let _e1003 = phi_3678_;
                                                        let _e1004 = select(_e998, _e999, _e1003);
                                                        let _e1005 = abs(_e975);
                                                        let _e1006 = abs(_e976);
                                                        if (_e1005 != _e1005) {
                                                            phi_3693_ = true;
                                                        } else {
                                                            phi_3693_ = (_e1006 >= _e1005);
                                                        }
                                                        let _e1010 = phi_3693_;
                                                        let _e1011 = select(_e1005, _e1006, _e1010);
                                                        let _e1012 = abs(_e977);
                                                        if (_e1011 != _e1011) {
                                                            phi_3708_ = true;
                                                        } else {
                                                            phi_3708_ = (_e1012 >= _e1011);
                                                        }
                                                        let _e1016 = phi_3708_;
                                                        let _e1017 = select(_e1011, _e1012, _e1016);
                                                        let _e1019 = select(_e1004, _e991, (_e991 > _e1004));
                                                        let _e1021 = select(_e1017, _e1019, (_e1019 > _e1017));
                                                        if (_e991 == _e1021) {
                                                            phi_1988_ = _e827;
                                                            phi_1989_ = _e824;
                                                            phi_1990_ = _e818;
                                                            phi_1991_ = _e815;
                                                            phi_1992_ = vec3<f32>(_e796[0][0], _e796[0][1], _e796[0][2]);
                                                            phi_1993_ = _e978;
                                                            phi_1994_ = _e974;
                                                            phi_1995_ = _e970;
                                                        } else {
                                                            let _e1023 = (_e1004 == _e1021);
                                                            let _e1028 = vec3(_e1023);
                                                            phi_1988_ = select(_e818, _e836, _e1023);
                                                            phi_1989_ = select(_e815, _e833, _e1023);
                                                            phi_1990_ = select(_e836, _e827, _e1023);
                                                            phi_1991_ = select(_e833, _e824, _e1023);
                                                            phi_1992_ = select(vec3<f32>(_e796[2][0], _e796[2][1], _e796[2][2]), vec3<f32>(_e796[1][0], _e796[1][1], _e796[1][2]), _e1028);
                                                            phi_1993_ = select(_e974, _e970, _e1028);
                                                            phi_1994_ = select(_e970, _e978, _e1028);
                                                            phi_1995_ = select(_e978, _e974, _e1028);
                                                        }
                                                        let _e1034 = phi_1988_;
                                                        let _e1036 = phi_1989_;
                                                        let _e1038 = phi_1990_;
                                                        let _e1040 = phi_1991_;
                                                        let _e1042 = phi_1992_;
                                                        let _e1044 = phi_1993_;
                                                        let _e1046 = phi_1994_;
                                                        let _e1048 = phi_1995_;
                                                        let _e1055 = ((_e1046.y * _e1044.z) - (_e1044.y * _e1046.z));
                                                        let _e1060 = ((_e1046.z * _e1044.x) - (_e1044.z * _e1046.x));
                                                        let _e1063 = ((_e1046.x * _e1044.y) - (_e1044.x * _e1046.y));
                                                        let _e1066 = ((_e859 >= _e863) && (_e859 >= _e867));
                                                        let _e1067 = (_e863 >= _e867);
                                                        let _e1081 = (((_e1055 * (select(select(_e796[2][0], _e796[1][0], _e1067), _e796[0][0], _e1066) - _e326)) + (_e1060 * (select(select(_e796[2][1], _e796[1][1], _e1067), _e796[0][1], _e1066) - _e393))) + (_e1063 * (select(select(_e796[2][2], _e796[1][2], _e1067), _e796[0][2], _e1066) - _e459)));
                                                        let _e1086 = (((_e1055 * _e363) + (_e1060 * _e429)) + (_e1063 * _e495));
                                                        let _e1087 = (_e1036 - _e1040);
                                                        let _e1088 = (_e1034 - _e1038);
                                                        let _e1091 = ((_e1087 * _e1087) + (_e1088 * _e1088));
                                                        let _e1098 = (-(((_e1040 * _e1087) + (_e1038 * _e1088))) / select(0.000000000000000000000000000000000000011754944f, _e1091, (_e1091 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1100 = select(1f, _e1098, (_e1098 < 1f));
                                                        let _e1102 = select(0f, _e1100, (_e1100 > 0f));
                                                        let _e1111 = ((_e1042.x + (_e1048.x * _e1102)) - _e326);
                                                        let _e1114 = ((_e1042.y + (_e1048.y * _e1102)) - _e393);
                                                        let _e1117 = ((_e1042.z + (_e1048.z * _e1102)) - _e459);
                                                        let _e1120 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                        let _e1123 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                        let _e1125 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                        let _e1128 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                        let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                        let _e1134 = abs(_e1055);
                                                        let _e1135 = abs(_e1060);
                                                        if (_e1134 != _e1134) {
                                                            phi_3723_ = true;
                                                        } else {
                                                            phi_3723_ = (_e1135 >= _e1134);
                                                        }
                                                        let _e1139 = phi_3723_;
                                                        let _e1140 = select(_e1134, _e1135, _e1139);
                                                        let _e1141 = abs(_e1063);
                                                        if (_e1140 != _e1140) {
                                                            phi_3738_ = true;
                                                        } else {
                                                            phi_3738_ = (_e1141 >= _e1140);
                                                        }
                                                        let _e1145 = phi_3738_;
                                                        let _e1161 = abs(_e1046.x);
                                                        let _e1162 = abs(_e1046.y);
                                                        if (_e1161 != _e1161) {
                                                            phi_3753_ = true;
                                                        } else {
                                                            phi_3753_ = (_e1162 >= _e1161);
                                                        }
                                                        let _e1166 = phi_3753_;
                                                        let _e1167 = select(_e1161, _e1162, _e1166);
                                                        let _e1168 = abs(_e1046.z);
                                                        if (_e1167 != _e1167) {
                                                            phi_3768_ = true;
                                                        } else {
                                                            phi_3768_ = (_e1168 >= _e1167);
                                                        }
                                                        let _e1172 = phi_3768_;
                                                        let _e1175 = abs(_e1044.x);
                                                        let _e1176 = abs(_e1044.y);
                                                        if (_e1175 != _e1175) {
                                                            phi_3783_ = true;
                                                        } else {
                                                            phi_3783_ = (_e1176 >= _e1175);
                                                        }
                                                        let _e1180 = phi_3783_;
                                                        let _e1181 = select(_e1175, _e1176, _e1180);
                                                        let _e1182 = abs(_e1044.z);
                                                        if (_e1181 != _e1181) {
                                                            phi_3798_ = true;
                                                        } else {
                                                            phi_3798_ = (_e1182 >= _e1181);
                                                        }
                                                        let _e1186 = phi_3798_;
                                                        let _e1191 = ((bitcast<f32>((bitcast<u32>(((((_e1055 * _e1111) + (_e1060 * _e1114)) + (_e1063 * _e1117)) - _e1081)) & 2147483647u)) <= ((0.0000009536743f * select(_e1021, _e1130, (_e1130 > _e1021))) * select(_e1140, _e1141, _e1145))) && !((bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u)) <= ((0.0000038146973f * select(_e1167, _e1168, _e1172)) * select(_e1181, _e1182, _e1186)))));
                                                        let _e1192 = (_e1081 / _e1086);
                                                        if (_e962 && !(_e1191)) {
                                                            let _e1195 = (_e1117 / _e495);
                                                            let _e1203 = (((_e1055 * (_e1111 - (_e363 * _e1195))) + (_e1060 * (_e1114 - (_e429 * _e1195)))) / _e1086);
                                                            phi_2203_ = select(select(_e1195, (_e1195 + _e1203), (bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u)) <= _e1021)), _e1192, _e1191);
                                                        } else {
                                                            phi_2203_ = _e1192;
                                                        }
                                                        let _e1212 = phi_2203_;
                                                        let _e1214 = select(_e925, _e1212, (_e1212 < _e925));
                                                        let _e1216 = select(_e917, _e1214, (_e1214 > _e917));
                                                        let _e1217 = (1f / _e869);
                                                        phi_2223_ = type_37(_e1216, (_e863 * _e1217), (_e867 * _e1217), ((_e962 && (_e1216 >= _e602)) && (_e1216 <= _e700.member_1)));
                                                        phi_2224_ = type_37();
                                                    } else {
                                                        phi_2223_ = type_37();
                                                        phi_2224_ = type_37(0f, 0f, 0f, _e962);
                                                    }
                                                    let _e1226 = phi_2223_;
                                                    let _e1228 = phi_2224_;
                                                    phi_2227_ = _e1226;
                                                    phi_2228_ = _e1228;
                                                    phi_2229_ = select(true, false, _e962);
                                                } else {
                                                    phi_2227_ = type_37();
                                                    phi_2228_ = type_37(0f, 0f, 0f, _e853);
                                                    phi_2229_ = true;
                                                }
                                                let _e1231 = phi_2227_;
                                                let _e1233 = phi_2228_;
                                                let _e1235 = phi_2229_;
                                                if _e1235 {
                                                    phi_2233_ = _e1233;
                                                } else {
                                                    phi_2233_ = _e1231;
                                                }
                                                let _e1237 = phi_2233_;
                                                if _e1237.member_3 {
                                                    phi_2242_ = type_21(_e1237.member, _e1237.member_1, _e1237.member_2, _e729);
                                                } else {
                                                    phi_2242_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1244 = phi_2242_;
                                                if (_e1244.member_3 != 4294967295u) {
                                                    if (_e729 != 4294967295u) {
                                                        if (_e1244.member < _e700.member.member) {
                                                            phi_2268_ = true;
                                                        } else {
                                                            if (_e1244.member == _e700.member.member) {
                                                                phi_2267_ = (_e1244.member_3 < _e700.member.member_3);
                                                            } else {
                                                                phi_2267_ = false;
                                                            }
                                                            let _e1257 = phi_2267_;
                                                            phi_2268_ = _e1257;
                                                        }
                                                        let _e1259 = phi_2268_;
                                                        if _e1259 {
                                                            phi_2274_ = type_34(_e1244, _e1244.member);
                                                        } else {
                                                            phi_2274_ = _e700;
                                                        }
                                                        let _e1262 = phi_2274_;
                                                        phi_2275_ = _e1262;
                                                    } else {
                                                        phi_2275_ = _e700;
                                                    }
                                                    let _e1264 = phi_2275_;
                                                    phi_2276_ = _e1264;
                                                } else {
                                                    phi_2276_ = _e700;
                                                }
                                                let _e1266 = phi_2276_;
                                                phi_1308_ = _e1266;
                                            } else {
                                                phi_1308_ = type_34();
                                            }
                                            let _e1268 = phi_1308_;
                                            continue;
                                            continuing {
                                                phi_1307_ = _e1268;
                                                phi_1310_ = _e715;
                                                phi_4066_ = _e644;
                                                break if !(_e721);
                                            }
                                        }
                                        let _e1271 = phi_4066_;
                                        phi_4231_ = _e1271;
                                        if _e1271 {
                                            break;
                                        }
                                        phi_4317_ = _e1271;
                                        let _e1993 = local_11;
                                        phi_2277_ = _e1993;
                                    } else {
                                        phi_4317_ = _e644;
                                        phi_2277_ = _e646;
                                    }
                                    let _e1273 = phi_4317_;
                                    let _e1275 = phi_2277_;
                                    if _e693 {
                                        phi_3507_ = bool();
                                        phi_3508_ = u32();
                                        phi_3509_ = type_51();
                                    } else {
                                        if (_e689.member_1 >= _e92) {
                                            phi_3043_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e689.member_1 < _e92) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1278 = (_e262 * 2u);
                                            let _e1280 = ((1u + _e1278) % 7u);
                                            if (_e1280 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1285 = global_5.member[_e689.member_1][_e1280];
                                            let _e1287 = ((_e1278 + 2u) % 7u);
                                            if (_e1287 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1292 = global_5.member[_e689.member_1][_e1287];
                                            let _e1293 = (_e261 * 2u);
                                            let _e1295 = ((1u + _e1293) % 7u);
                                            if (_e1295 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1300 = global_5.member[_e689.member_1][_e1295];
                                            let _e1302 = ((_e1293 + 2u) % 7u);
                                            if (_e1302 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1307 = global_5.member[_e689.member_1][_e1302];
                                            let _e1308 = (_e263 * 2u);
                                            let _e1310 = ((1u + _e1308) % 7u);
                                            if (_e1310 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1315 = global_5.member[_e689.member_1][_e1310];
                                            let _e1317 = ((_e1308 + 2u) % 7u);
                                            if (_e1317 < 7u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1322 = global_5.member[_e689.member_1][_e1317];
                                            let _e1345 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.x - _e689.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1346 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.y - _e689.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1347 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.z - _e689.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1349 = select(_e142, _e1345, (_e1345 > _e142));
                                            let _e1351 = select(_e142, _e1346, (_e1346 > _e142));
                                            let _e1353 = select(_e142, _e1347, (_e1347 > _e142));
                                            let _e1384 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1285 & 2097151u))) - 8388608f) * _e1349));
                                            let _e1389 = (bitcast<i32>((_e1285 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1392 = bitcast<f32>((_e1384 & bitcast<u32>(_e1389)));
                                            let _e1393 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1300 & 2097151u))) - 8388608f) * _e1351));
                                            let _e1398 = (bitcast<i32>((_e1300 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1401 = bitcast<f32>((_e1393 & bitcast<u32>(_e1398)));
                                            let _e1402 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1315 & 2097151u))) - 8388608f) * _e1353));
                                            let _e1407 = (bitcast<i32>((_e1315 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1410 = bitcast<f32>((_e1402 & bitcast<u32>(_e1407)));
                                            let _e1414 = bitcast<f32>((_e1384 & bitcast<u32>(~(_e1389))));
                                            let _e1418 = bitcast<f32>((_e1393 & bitcast<u32>(~(_e1398))));
                                            let _e1422 = bitcast<f32>((_e1402 & bitcast<u32>(~(_e1407))));
                                            let _e1423 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1292 & 2097151u))) - 8388608f) * _e1349));
                                            let _e1428 = (bitcast<i32>((_e1292 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1431 = bitcast<f32>((_e1423 & bitcast<u32>(_e1428)));
                                            let _e1432 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1307 & 2097151u))) - 8388608f) * _e1351));
                                            let _e1437 = (bitcast<i32>((_e1307 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1440 = bitcast<f32>((_e1432 & bitcast<u32>(_e1437)));
                                            let _e1441 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1322 & 2097151u))) - 8388608f) * _e1353));
                                            let _e1446 = (bitcast<i32>((_e1322 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1449 = bitcast<f32>((_e1441 & bitcast<u32>(_e1446)));
                                            let _e1453 = bitcast<f32>((_e1423 & bitcast<u32>(~(_e1428))));
                                            let _e1457 = bitcast<f32>((_e1432 & bitcast<u32>(~(_e1437))));
                                            let _e1461 = bitcast<f32>((_e1441 & bitcast<u32>(~(_e1446))));
                                            let _e1491 = global_5.member[_e689.member_1][0u];
                                            let _e1495 = global_5.member[_e689.member_1][2u];
                                            let _e1499 = global_5.member[_e689.member_1][4u];
                                            let _e1503 = global_5.member[_e689.member_1][6u];
                                            let _e1515 = (((_e1495 >> bitcast<u32>(22i)) | ((_e1499 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1503 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1516 = (_e1491 & 268435455u);
                                            let _e1517 = (_e1515 & 268435455u);
                                            let _e1520 = ((_e1491 >> bitcast<u32>(28u)) & 7u);
                                            let _e1528 = ((_e1491 >> bitcast<u32>(31i)) | (((_e1515 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1529 = (_e1520 != 0u);
                                            if (_e1520 == 0u) {
                                                phi_3005_ = _e1516;
                                            } else {
                                                if (_e1520 == 7u) {
                                                    phi_3004_ = 2147483648u;
                                                } else {
                                                    phi_3004_ = ((2147483648u | (_e1520 << bitcast<u32>(28u))) | (_e1517 & 268435455u));
                                                }
                                                let _e1538 = phi_3004_;
                                                phi_3005_ = _e1538;
                                            }
                                            let _e1540 = phi_3005_;
                                            if _e1529 {
                                                let _e1541 = (_e1520 != 7u);
                                                if _e1541 {
                                                    phi_3015_ = (_e1517 + _e1520);
                                                } else {
                                                    phi_3015_ = u32();
                                                }
                                                let _e1544 = phi_3015_;
                                                phi_3017_ = _e1544;
                                                phi_3018_ = select(true, false, _e1541);
                                            } else {
                                                phi_3017_ = u32();
                                                phi_3018_ = true;
                                            }
                                            let _e1547 = phi_3017_;
                                            let _e1549 = phi_3018_;
                                            if (_e1528 == 0u) {
                                                phi_3039_ = (_e1516 + select(0u, 1u, !(_e1529)));
                                            } else {
                                                if (_e1528 == 7u) {
                                                    phi_3038_ = 2147483648u;
                                                } else {
                                                    phi_3038_ = ((2147483648u | (_e1528 << bitcast<u32>(28u))) | (select(_e1547, _e1517, _e1549) & 268435455u));
                                                }
                                                let _e1562 = phi_3038_;
                                                phi_3039_ = _e1562;
                                            }
                                            let _e1564 = phi_3039_;
                                            phi_3043_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e689.member.member.x + _e1392), (_e689.member.member.x + _e1414), (_e689.member.member_1.x - _e1431), (_e689.member.member_1.x - _e1453)), vec4<f32>((_e689.member.member.y + _e1401), (_e689.member.member.y + _e1418), (_e689.member.member_1.y - _e1440), (_e689.member.member_1.y - _e1457)), vec4<f32>((_e689.member.member.z + _e1410), (_e689.member.member.z + _e1422), (_e689.member.member_1.z - _e1449), (_e689.member.member_1.z - _e1461))), type_51(type_29((_e689.member.member + vec4<f32>(_e1392, _e1401, _e1410, 0f)), (_e689.member.member_1 - vec4<f32>(_e1431, _e1440, _e1449, 0f))), _e1540), type_51(type_29((_e689.member.member + vec4<f32>(_e1414, _e1418, _e1422, 0f)), (_e689.member.member_1 - vec4<f32>(_e1453, _e1457, _e1461, 0f))), _e1564));
                                        }
                                        let _e1569 = phi_3043_;
                                        let _e1581 = ((_e1569.member[0].x - _e364) * _e367);
                                        let _e1582 = ((_e1569.member[0].y - _e364) * _e367);
                                        let _e1583 = ((_e1569.member[0].z - _e365) * _e367);
                                        let _e1584 = ((_e1569.member[0].w - _e365) * _e367);
                                        let _e1594 = ((_e1569.member[1].x - _e430) * _e433);
                                        let _e1595 = ((_e1569.member[1].y - _e430) * _e433);
                                        let _e1596 = ((_e1569.member[1].z - _e431) * _e433);
                                        let _e1597 = ((_e1569.member[1].w - _e431) * _e433);
                                        let _e1607 = ((_e1569.member[2].x - _e496) * _e499);
                                        let _e1608 = ((_e1569.member[2].y - _e496) * _e499);
                                        let _e1609 = ((_e1569.member[2].z - _e497) * _e499);
                                        let _e1610 = ((_e1569.member[2].w - _e497) * _e499);
                                        let _e1612 = select(_e1609, _e1607, (_e1607 < _e1609));
                                        let _e1614 = select(_e1610, _e1608, (_e1608 < _e1610));
                                        let _e1616 = select(_e1609, _e1607, (_e1607 > _e1609));
                                        let _e1618 = select(_e1610, _e1608, (_e1608 > _e1610));
                                        let _e1620 = select(_e1583, _e1581, (_e1581 < _e1583));
                                        let _e1622 = select(_e1584, _e1582, (_e1582 < _e1584));
                                        let _e1624 = select(_e1596, _e1594, (_e1594 < _e1596));
                                        let _e1626 = select(_e1597, _e1595, (_e1595 < _e1597));
                                        let _e1628 = select(_e1624, _e1620, (_e1620 > _e1624));
                                        let _e1630 = select(_e1626, _e1622, (_e1622 > _e1626));
                                        let _e1632 = select(_e1612, _e1628, (_e1628 > _e1612));
                                        let _e1634 = select(_e1614, _e1630, (_e1630 > _e1614));
                                        let _e1636 = select(_e1583, _e1581, (_e1581 > _e1583));
                                        let _e1638 = select(_e1584, _e1582, (_e1582 > _e1584));
                                        let _e1640 = select(_e1596, _e1594, (_e1594 > _e1596));
                                        let _e1642 = select(_e1597, _e1595, (_e1595 > _e1597));
                                        let _e1644 = select(_e1640, _e1636, (_e1636 < _e1640));
                                        let _e1646 = select(_e1642, _e1638, (_e1638 < _e1642));
                                        let _e1651 = -(_e1612);
                                        let _e1652 = -(_e1614);
                                        let _e1659 = (select(_e1616, _e1644, (_e1644 < _e1616)) + (select(_e1651, _e1616, (_e1616 > _e1651)) * 0.0000019073523f));
                                        let _e1660 = (select(_e1618, _e1646, (_e1646 < _e1618)) + (select(_e1652, _e1618, (_e1618 > _e1652)) * 0.0000019073523f));
                                        let _e1662 = select(_e602, _e1632, (_e1632 > _e602));
                                        let _e1664 = select(_e602, _e1634, (_e1634 > _e602));
                                        let _e1669 = (_e1662 <= select(_e1275.member_1, _e1659, (_e1659 < _e1275.member_1)));
                                        let _e1670 = (_e1664 <= select(_e1275.member_1, _e1660, (_e1660 < _e1275.member_1)));
                                        let _e1671 = (_e1662 <= _e1664);
                                        if _e1669 {
                                            if _e1670 {
                                                if _e1671 {
                                                    phi_3405_ = _e1569.member_2;
                                                } else {
                                                    phi_3405_ = _e1569.member_1;
                                                }
                                                let _e1675 = phi_3405_;
                                                let _e1696 = (_e687 % 128u);
                                                let _e1697 = (_e1696 < 128u);
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_8[_e1696] = _e1675.member_1;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_7[_e1696] = _e1675.member.member.x;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_6[_e1696] = _e1675.member.member.y;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_5[_e1696] = _e1675.member.member.z;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_4[_e1696] = _e1675.member.member_1.x;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_3[_e1696] = _e1675.member.member_1.y;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_2[_e1696] = _e1675.member.member_1.z;
                                                if _e1697 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_9[_e1696] = select(_e1662, _e1664, _e1671);
                                                if _e1671 {
                                                    phi_3481_ = _e1569.member_1;
                                                } else {
                                                    phi_3481_ = _e1569.member_2;
                                                }
                                                let _e1710 = phi_3481_;
                                                phi_3482_ = (_e687 + 1u);
                                                phi_3483_ = _e1710;
                                            } else {
                                                phi_3482_ = u32();
                                                phi_3483_ = type_51();
                                            }
                                            let _e1712 = phi_3482_;
                                            let _e1714 = phi_3483_;
                                            phi_3485_ = _e1712;
                                            phi_3486_ = _e1714;
                                            phi_3487_ = select(true, false, _e1670);
                                        } else {
                                            phi_3485_ = u32();
                                            phi_3486_ = type_51();
                                            phi_3487_ = true;
                                        }
                                        let _e1717 = phi_3485_;
                                        let _e1719 = phi_3486_;
                                        let _e1721 = phi_3487_;
                                        if _e1721 {
                                            if _e1669 {
                                                phi_3496_ = _e1569.member_1;
                                            } else {
                                                phi_3496_ = _e1569.member_2;
                                            }
                                            let _e1725 = phi_3496_;
                                            phi_3501_ = select(_e1670, true, _e1669);
                                            phi_3503_ = _e1725;
                                        } else {
                                            phi_3501_ = _e685;
                                            phi_3503_ = _e1719;
                                        }
                                        let _e1728 = phi_3501_;
                                        let _e1730 = phi_3503_;
                                        phi_3507_ = _e1728;
                                        phi_3508_ = select(_e1717, _e687, _e1721);
                                        phi_3509_ = _e1730;
                                    }
                                    let _e1733 = phi_3507_;
                                    let _e1735 = phi_3508_;
                                    let _e1737 = phi_3509_;
                                    if _e693 {
                                        phi_3519_ = _e689;
                                    } else {
                                        phi_3519_ = _e1737;
                                    }
                                    let _e1739 = phi_3519_;
                                    phi_4234_ = _e1273;
                                    phi_3520_ = _e1275;
                                    phi_3521_ = (_e648 - 1u);
                                    phi_3522_ = select(_e1733, false, _e693);
                                    phi_3523_ = select(_e1735, _e687, _e693);
                                    phi_3524_ = _e1739;
                                } else {
                                    phi_4234_ = _e644;
                                    phi_3520_ = _e646;
                                    phi_3521_ = _e648;
                                    phi_3522_ = _e685;
                                    phi_3523_ = _e687;
                                    phi_3524_ = _e689;
                                }
                                let _e1743 = phi_4234_;
                                let _e1745 = phi_3520_;
                                let _e1747 = phi_3521_;
                                let _e1749 = phi_3522_;
                                let _e1751 = phi_3523_;
                                let _e1753 = phi_3524_;
                                phi_4233_ = _e1743;
                                phi_3525_ = _e1745;
                                phi_3526_ = _e1747;
                                phi_3527_ = _e1749;
                                phi_3528_ = _e1751;
                                phi_3529_ = _e1753;
                            } else {
                                phi_4233_ = _e644;
                                phi_3525_ = type_34();
                                phi_3526_ = u32();
                                phi_3527_ = bool();
                                phi_3528_ = u32();
                                phi_3529_ = type_51();
                            }
                            let _e1755 = phi_4233_;
                            let _e1757 = phi_3525_;
                            let _e1759 = phi_3526_;
                            let _e1761 = phi_3527_;
                            let _e1763 = phi_3528_;
                            let _e1765 = phi_3529_;
                            phi_4232_ = _e1755;
                            phi_1182_ = _e1757;
                            phi_1185_ = _e1759;
                            phi_1187_ = _e1761;
                            phi_1189_ = _e1763;
                            phi_1191_ = _e1765;
                            phi_3530_ = _e658;
                        } else {
                            phi_4232_ = _e644;
                            phi_1182_ = type_34();
                            phi_1185_ = u32();
                            phi_1187_ = bool();
                            phi_1189_ = u32();
                            phi_1191_ = type_51();
                            phi_3530_ = false;
                        }
                        let _e1767 = phi_4232_;
                        let _e1769 = phi_1182_;
                        let _e1771 = phi_1185_;
                        let _e1773 = phi_1187_;
                        let _e1775 = phi_1189_;
                        let _e1777 = phi_1191_;
                        let _e1779 = phi_3530_;
                        continue;
                        continuing {
                            phi_4072_ = _e1767;
                            phi_1181_ = _e1769;
                            phi_1184_ = _e1771;
                            phi_1186_ = _e1773;
                            phi_1188_ = _e1775;
                            phi_1190_ = _e1777;
                            phi_4231_ = _e1767;
                            break if !(_e1779);
                        }
                    }
                    let _e1782 = phi_4231_;
                    if _e1782 {
                        break;
                    }
                    let _e1784 = local_10;
                    if (_e1784.member.member_3 != 4294967295u) {
                        let _e1789 = -(_e504);
                        let _e1790 = bitcast<u32>(_e1784.member.member);
                        let _e1794 = (bitcast<i32>((_e1790 >> bitcast<u32>(23i))) & 255i);
                        let _e1795 = (_e1794 + _e1789);
                        if (_e1794 == 255i) {
                            phi_3589_ = _e1784.member.member;
                        } else {
                            if (_e1794 > 0i) {
                                if (_e1795 > 0i) {
                                    let _e1799 = (_e1795 < 255i);
                                    if _e1799 {
                                        phi_3568_ = bitcast<f32>((_e1790 + bitcast<u32>((_e1789 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3568_ = f32();
                                    }
                                    let _e1806 = phi_3568_;
                                    phi_3570_ = _e1806;
                                    phi_3571_ = select(true, false, _e1799);
                                } else {
                                    phi_3570_ = f32();
                                    phi_3571_ = true;
                                }
                                let _e1809 = phi_3570_;
                                let _e1811 = phi_3571_;
                                phi_3572_ = _e1809;
                                phi_3573_ = _e1811;
                            } else {
                                phi_3572_ = f32();
                                phi_3573_ = true;
                            }
                            let _e1813 = phi_3572_;
                            let _e1815 = phi_3573_;
                            if _e1815 {
                                let _e1816 = (_e1790 & 2147483648u);
                                let _e1823 = ((_e1790 & 8388607u) | (select(0u, 1u, ((_e1790 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1827 = (_e1823 == 0u);
                                if _e1827 {
                                    phi_4024_ = bitcast<f32>(_e1816);
                                } else {
                                    let _e1832 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1823)), 32u, _e1827) - 8u);
                                    let _e1835 = (_e1823 << bitcast<u32>((_e1832 & 31u)));
                                    let _e1837 = ((_e1795 + select(0i, 1i, (_e1794 == 0i))) - bitcast<i32>(_e1832));
                                    if (_e1837 >= 255i) {
                                        phi_4014_ = bitcast<f32>((_e1816 | 2139095040u));
                                        phi_4015_ = f32();
                                        phi_4016_ = true;
                                    } else {
                                        let _e1839 = (_e1837 > 0i);
                                        if _e1839 {
                                            phi_4008_ = bitcast<f32>(((_e1816 | (bitcast<u32>(_e1837) << bitcast<u32>(23i))) | (_e1835 & 8388607u)));
                                            phi_4009_ = f32();
                                        } else {
                                            if (_e1837 < -24i) {
                                                phi_3974_ = 26u;
                                            } else {
                                                phi_3974_ = bitcast<u32>((1i - _e1837));
                                            }
                                            let _e1844 = phi_3974_;
                                            let _e1845 = (_e1844 & 31u);
                                            let _e1847 = (_e1835 >> bitcast<u32>(_e1845));
                                            let _e1851 = (_e1835 & ((1u << bitcast<u32>(_e1845)) - 1u));
                                            let _e1855 = (1u << bitcast<u32>(((_e1844 - 1u) & 31u)));
                                            if (_e1851 > _e1855) {
                                                phi_3995_ = true;
                                            } else {
                                                if (_e1851 == _e1855) {
                                                    phi_3992_ = ((_e1847 & 1u) == 1u);
                                                } else {
                                                    phi_3992_ = false;
                                                }
                                                let _e1861 = phi_3992_;
                                                phi_3995_ = _e1861;
                                            }
                                            let _e1863 = phi_3995_;
                                            phi_4008_ = f32();
                                            phi_4009_ = bitcast<f32>((_e1816 | (_e1847 + select(0u, 1u, _e1863))));
                                        }
                                        let _e1876 = phi_4008_;
                                        let _e1878 = phi_4009_;
                                        phi_4014_ = _e1876;
                                        phi_4015_ = _e1878;
                                        phi_4016_ = _e1839;
                                    }
                                    let _e1882 = phi_4014_;
                                    let _e1884 = phi_4015_;
                                    let _e1886 = phi_4016_;
                                    phi_4024_ = select(_e1884, _e1882, _e1886);
                                }
                                let _e1890 = phi_4024_;
                                phi_3588_ = _e1890;
                            } else {
                                phi_3588_ = _e1813;
                            }
                            let _e1892 = phi_3588_;
                            phi_3589_ = _e1892;
                        }
                        let _e1894 = phi_3589_;
                        let _e1895 = bitcast<u32>(_e1894);
                        if ((_e1895 & 2147483647u) >= 2139095040u) {
                            phi_3601_ = bitcast<f32>(((_e1895 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3601_ = _e1894;
                        }
                        let _e1902 = phi_3601_;
                        phi_3606_ = type_21(_e1902, _e1784.member.member_1, _e1784.member.member_2, _e1784.member.member_3);
                    } else {
                        phi_3606_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1907 = phi_3606_;
                    if _e150 {
                    } else {
                        break;
                    }
                    global_6.member[_e148] = _e1907;
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
