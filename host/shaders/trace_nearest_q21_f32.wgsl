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

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_34 {
    member: array<type_22>,
}

struct type_38 {
    member: array<array<type_21, 8>>,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_25,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_44;
@group(0) @binding(4) 
var<storage> global_4: type_34;
@group(0) @binding(2) 
var<storage> global_5: type_48;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_38;

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
    var local_9: array<type_21, 8>;
    var local_10: array<f32, 128>;
    var phi_508_: i32;
    var phi_509_: i32;
    var phi_519_: bool;
    var phi_529_: u32;
    var phi_530_: u32;
    var phi_532_: bool;
    var phi_537_: u32;
    var phi_550_: i32;
    var phi_570_: i32;
    var phi_588_: f32;
    var phi_594_: f32;
    var phi_634_: f32;
    var phi_640_: f32;
    var phi_713_: f32;
    var phi_719_: f32;
    var phi_759_: f32;
    var phi_765_: f32;
    var phi_838_: f32;
    var phi_844_: f32;
    var phi_884_: f32;
    var phi_890_: f32;
    var phi_1009_: i32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1069_: i32;
    var phi_1091_: u32;
    var phi_1092_: u32;
    var phi_1100_: f32;
    var phi_1101_: f32;
    var phi_4318_: bool;
    var phi_4245_: f32;
    var phi_1250_: bool;
    var phi_1253_: type_53;
    var phi_1255_: u32;
    var phi_1257_: u32;
    var phi_1268_: bool;
    var phi_1355_: bool;
    var phi_1356_: type_53;
    var phi_1357_: u32;
    var phi_3111_: u32;
    var phi_3112_: u32;
    var phi_3122_: u32;
    var phi_3124_: u32;
    var phi_3125_: bool;
    var phi_3145_: u32;
    var phi_3146_: u32;
    var phi_3150_: type_54;
    var phi_3513_: type_53;
    var phi_3589_: type_53;
    var phi_3590_: type_53;
    var phi_3591_: u32;
    var phi_3593_: type_53;
    var phi_3594_: u32;
    var phi_3595_: bool;
    var phi_3604_: type_53;
    var phi_3609_: bool;
    var phi_3610_: type_53;
    var phi_4315_: bool;
    var phi_4304_: f32;
    var phi_1375_: type_4;
    var phi_1376_: type_4;
    var phi_1399_: type_4;
    var phi_1420_: u32;
    var phi_1512_: array<array<f32, 3>, 3>;
    var phi_2043_: f32;
    var phi_2044_: f32;
    var phi_2045_: f32;
    var phi_2046_: f32;
    var phi_2047_: vec3<f32>;
    var phi_2048_: vec3<f32>;
    var phi_2049_: vec3<f32>;
    var phi_2050_: vec3<f32>;
    var phi_2241_: f32;
    var phi_2261_: type_32;
    var phi_2262_: type_32;
    var phi_2265_: type_32;
    var phi_2266_: type_32;
    var phi_2267_: bool;
    var phi_2271_: type_32;
    var phi_2280_: type_21;
    var phi_2292_: type_4;
    var phi_2295_: type_21;
    var phi_2293_: type_4;
    var phi_2318_: type_4;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2372_: type_21;
    var phi_2296_: type_21;
    var phi_4305_: bool;
    var phi_4547_: f32;
    var phi_4546_: f32;
    var phi_4461_: bool;
    var phi_4545_: f32;
    var phi_4460_: bool;
    var phi_4544_: f32;
    var phi_4459_: bool;
    var phi_4463_: f32;
    var phi_4458_: bool;
    var phi_4662_: f32;
    var phi_4552_: bool;
    var phi_3612_: bool;
    var phi_3613_: type_53;
    var phi_3614_: u32;
    var phi_4661_: f32;
    var phi_4551_: bool;
    var phi_3615_: bool;
    var phi_3616_: type_53;
    var phi_3617_: u32;
    var phi_3618_: u32;
    var phi_4660_: f32;
    var phi_4550_: bool;
    var phi_3619_: bool;
    var phi_3620_: type_53;
    var phi_3621_: u32;
    var phi_3622_: u32;
    var phi_4659_: f32;
    var phi_4549_: bool;
    var phi_1251_: bool;
    var phi_1254_: type_53;
    var phi_1256_: u32;
    var phi_1258_: u32;
    var phi_3623_: bool;
    var phi_4548_: bool;
    var phi_3630_: type_4;
    var phi_3631_: type_4;
    var phi_3654_: type_4;
    var phi_3706_: f32;
    var phi_3708_: f32;
    var phi_3709_: bool;
    var phi_3710_: f32;
    var phi_3711_: bool;
    var phi_4142_: u32;
    var phi_4160_: bool;
    var phi_4163_: bool;
    var phi_4176_: f32;
    var phi_4177_: f32;
    var phi_4182_: f32;
    var phi_4183_: f32;
    var phi_4184_: bool;
    var phi_4192_: f32;
    var phi_3726_: f32;
    var phi_3727_: f32;
    var phi_3739_: f32;
    var phi_3744_: type_21;
    var phi_4641_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_5.member));
            let _e98 = arrayLength((&global_2.member));
            let _e106 = global_3.member[0u][0u];
            let _e110 = global_3.member[0u][1u];
            let _e114 = global_3.member[0u][2u];
            let _e118 = global_3.member[0u][3u];
            let _e122 = global_3.member[1u][0u];
            let _e126 = global_3.member[1u][1u];
            let _e130 = global_3.member[1u][2u];
            let _e133 = global_1.member[0u];
            let _e134 = bitcast<i32>(_e133);
            let _e146 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e118) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e106), bitcast<i32>(_e110), bitcast<i32>(_e114));
            local = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            let _e152 = (_e94.x + (_e94.y * 2097152u));
            let _e153 = (_e152 < arrayLength((&global_4.member)));
            if _e153 {
                let _e154 = (_e152 < arrayLength((&global_6.member)));
                if _e154 {
                    if _e153 {
                    } else {
                        break;
                    }
                    let _e162 = global_4.member[_e152].member_2[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e152].member_2[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e152].member_2[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_4.member[_e152].member[0u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_4.member[_e152].member[1u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e197 = global_4.member[_e152].member[2u];
                    let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                    let _e201 = select(_e171, _e164, (_e171 < _e164));
                    let _e203 = select(_e178, _e201, (_e178 < _e201));
                    let _e205 = select(_e185, _e203, (_e185 < _e203));
                    let _e207 = select(_e192, _e205, (_e192 < _e205));
                    let _e209 = select(_e199, _e207, (_e199 < _e207));
                    let _e213 = global_4.member[_e152].member_1;
                    let _e214 = bitcast<u32>(_e213);
                    let _e215 = (_e214 & 2147483647u);
                    let _e222 = global_4.member[_e152].member_3;
                    let _e223 = bitcast<u32>(_e222);
                    let _e224 = (_e223 & 2147483647u);
                    let _e228 = (((select(_e215, _e209, (_e215 < _e209)) < 2139095040u) && (_e224 <= 2139095040u)) && (_e203 > 0u));
                    if _e228 {
                        let _e231 = (bitcast<u32>(bitcast<f32>(_e203)) & 2147483647u);
                        if (_e231 >= 8388608u) {
                            phi_508_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_508_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                        }
                        let _e245 = phi_508_;
                        phi_509_ = _e245;
                    } else {
                        phi_509_ = 0i;
                    }
                    let _e247 = phi_509_;
                    let _e248 = (_e164 == _e203);
                    if _e248 {
                        phi_519_ = true;
                    } else {
                        phi_519_ = (_e171 == _e203);
                    }
                    let _e251 = phi_519_;
                    let _e252 = select(1u, 0u, _e248);
                    if _e251 {
                        let _e253 = (_e252 + 1u);
                        phi_529_ = _e253;
                        phi_530_ = _e253;
                        phi_532_ = select(true, false, (_e253 == 2u));
                    } else {
                        phi_529_ = u32();
                        phi_530_ = 0u;
                        phi_532_ = true;
                    }
                    let _e257 = phi_529_;
                    let _e259 = phi_530_;
                    let _e261 = phi_532_;
                    if _e261 {
                        phi_537_ = (_e259 + 1u);
                    } else {
                        phi_537_ = 0u;
                    }
                    let _e265 = phi_537_;
                    let _e266 = select(_e257, _e259, _e261);
                    let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                    if (_e134 < -126i) {
                        phi_550_ = -126i;
                    } else {
                        phi_550_ = select(_e134, 127i, (_e134 > 127i));
                    }
                    let _e272 = phi_550_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e134 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = -(_e247);
                    if (_e284 < -126i) {
                        phi_570_ = -126i;
                    } else {
                        phi_570_ = select(_e284, 127i, (_e284 > 127i));
                    }
                    let _e289 = phi_570_;
                    let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
                    let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
                    let _e304 = global_4.member[_e152].member;
                    let _e305 = (_e266 == 0u);
                    if _e305 {
                        phi_588_ = _e304[0];
                    } else {
                        phi_588_ = _e304[1];
                    }
                    let _e309 = phi_588_;
                    let _e310 = (_e266 == 2u);
                    if _e310 {
                        phi_594_ = _e304[2];
                    } else {
                        phi_594_ = _e309;
                    }
                    let _e313 = phi_594_;
                    let _e314 = bitcast<u32>(_e313);
                    let _e316 = ((_e314 & 2139095040u) != 0u);
                    let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * _e277) * select(0.00000011920929f, 1f, _e316)) * _e283);
                    let _e331 = global_4.member[_e152].member_2;
                    if _e305 {
                        phi_634_ = _e331[0];
                    } else {
                        phi_634_ = _e331[1];
                    }
                    let _e335 = phi_634_;
                    if _e310 {
                        phi_640_ = _e331[2];
                    } else {
                        phi_640_ = _e335;
                    }
                    let _e338 = phi_640_;
                    let _e339 = bitcast<u32>(_e338);
                    let _e341 = ((_e339 & 2139095040u) != 0u);
                    let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e338, _e341) * _e294) * select(0.00000011920929f, 1f, _e341)) * _e300);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e362 = bitcast<f32>((bitcast<u32>(_e330) & 2147483647u));
                    let _e363 = (_e362 * 0.00000011920929f);
                    let _e366 = select(select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f)), 0f, _e359);
                    let _e367 = select(0f, _e355, _e359);
                    let _e368 = (_e330 + _e366);
                    let _e369 = (_e330 - _e366);
                    let _e371 = select(38685626000000000000000000f, (1f / _e355), _e359);
                    let _e372 = (_e265 == 0u);
                    if _e372 {
                        phi_713_ = _e304[0];
                    } else {
                        phi_713_ = _e304[1];
                    }
                    let _e376 = phi_713_;
                    let _e377 = (_e265 == 2u);
                    if _e377 {
                        phi_719_ = _e304[2];
                    } else {
                        phi_719_ = _e376;
                    }
                    let _e380 = phi_719_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e277) * select(0.00000011920929f, 1f, _e383)) * _e283);
                    if _e372 {
                        phi_759_ = _e331[0];
                    } else {
                        phi_759_ = _e331[1];
                    }
                    let _e401 = phi_759_;
                    if _e377 {
                        phi_765_ = _e331[2];
                    } else {
                        phi_765_ = _e401;
                    }
                    let _e404 = phi_765_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e294) * select(0.00000011920929f, 1f, _e407)) * _e300);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e428 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e429 = (_e428 * 0.00000011920929f);
                    let _e432 = select(select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f)), 0f, _e425);
                    let _e433 = select(0f, _e421, _e425);
                    let _e434 = (_e397 + _e432);
                    let _e435 = (_e397 - _e432);
                    let _e437 = select(38685626000000000000000000f, (1f / _e421), _e425);
                    let _e438 = (_e267 == 0u);
                    if _e438 {
                        phi_838_ = _e304[0];
                    } else {
                        phi_838_ = _e304[1];
                    }
                    let _e442 = phi_838_;
                    let _e443 = (_e267 == 2u);
                    if _e443 {
                        phi_844_ = _e304[2];
                    } else {
                        phi_844_ = _e442;
                    }
                    let _e446 = phi_844_;
                    let _e447 = bitcast<u32>(_e446);
                    let _e449 = ((_e447 & 2139095040u) != 0u);
                    let _e463 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * _e277) * select(0.00000011920929f, 1f, _e449)) * _e283);
                    if _e438 {
                        phi_884_ = _e331[0];
                    } else {
                        phi_884_ = _e331[1];
                    }
                    let _e467 = phi_884_;
                    if _e443 {
                        phi_890_ = _e331[2];
                    } else {
                        phi_890_ = _e467;
                    }
                    let _e470 = phi_890_;
                    let _e471 = bitcast<u32>(_e470);
                    let _e473 = ((_e471 & 2139095040u) != 0u);
                    let _e487 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e470, _e473) * _e294) * select(0.00000011920929f, 1f, _e473)) * _e300);
                    let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e494 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
                    let _e495 = (_e494 * 0.00000011920929f);
                    let _e498 = select(select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f)), 0f, _e491);
                    let _e499 = select(0f, _e487, _e491);
                    let _e500 = (_e463 + _e498);
                    let _e501 = (_e463 - _e498);
                    let _e503 = select(38685626000000000000000000f, (1f / _e487), _e491);
                    let _e505 = select(_e428, _e362, (_e362 > _e428));
                    let _e508 = (_e134 + _e247);
                    if (_e228 && (select(_e494, _e505, (_e505 > _e494)) <= 1099511600000f)) {
                        let _e518 = ((_e215 & 8388607u) | (select(0u, 1u, ((_e215 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e521 = bitcast<i32>((_e215 >> bitcast<u32>(23i)));
                        let _e525 = (_e518 == 0u);
                        let _e528 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e518)), 32u, _e525)) - 8i);
                        if (_e521 == 255i) {
                            phi_1009_ = 255i;
                        } else {
                            phi_1009_ = (((_e521 + select(0i, 1i, (_e521 == 0i))) - _e528) + _e508);
                        }
                        let _e536 = phi_1009_;
                        let _e546 = (_e536 <= 0i);
                        if _e546 {
                            phi_1032_ = u32();
                        } else {
                            if _e525 {
                                phi_1031_ = u32();
                            } else {
                                phi_1031_ = select(((bitcast<u32>(_e536) << bitcast<u32>(23i)) | ((_e518 << bitcast<u32>(((_e528 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e536 >= 255i));
                            }
                            let _e550 = phi_1031_;
                            phi_1032_ = _e550;
                        }
                        let _e552 = phi_1032_;
                        let _e564 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e567 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                        let _e571 = (_e564 == 0u);
                        let _e574 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e564)), 32u, _e571)) - 8i);
                        if (_e567 == 255i) {
                            phi_1069_ = 255i;
                        } else {
                            phi_1069_ = (((_e567 + select(0i, 1i, (_e567 == 0i))) - _e574) + _e508);
                        }
                        let _e582 = phi_1069_;
                        let _e592 = (_e582 <= 0i);
                        if _e592 {
                            phi_1092_ = u32();
                        } else {
                            if _e571 {
                                phi_1091_ = u32();
                            } else {
                                phi_1091_ = select(((bitcast<u32>(_e582) << bitcast<u32>(23i)) | ((_e564 << bitcast<u32>(((_e574 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e582 >= 255i));
                            }
                            let _e596 = phi_1091_;
                            phi_1092_ = _e596;
                        }
                        let _e598 = phi_1092_;
                        phi_1100_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e598, 0u, select(_e571, true, _e592))));
                        phi_1101_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e552, 0u, select(_e525, true, _e546))));
                    } else {
                        phi_1100_ = 0f;
                        phi_1101_ = 1f;
                    }
                    let _e604 = phi_1100_;
                    let _e606 = phi_1101_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e611 = (_e266 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e265 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e267 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e623];
                    phi_4318_ = false;
                    phi_4245_ = _e604;
                    phi_1250_ = (_e606 <= _e604);
                    phi_1253_ = type_53(type_25(vec4<f32>((f32(_e614) * _e146), (f32(_e620) * _e146), (f32(_e626) * _e146), 0f), vec4<f32>((f32(_e631) * _e146), (f32(_e635) * _e146), (f32(_e639) * _e146), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1255_ = 0u;
                    phi_1257_ = ((3u * _e96) + 1u);
                    loop {
                        let _e647 = phi_4318_;
                        let _e649 = phi_4245_;
                        let _e651 = phi_1250_;
                        let _e653 = phi_1253_;
                        let _e655 = phi_1255_;
                        let _e657 = phi_1257_;
                        if _e651 {
                            phi_1268_ = true;
                        } else {
                            phi_1268_ = (_e655 > 0u);
                        }
                        let _e660 = phi_1268_;
                        if _e660 {
                            let _e661 = (_e657 > 0u);
                            if _e661 {
                                if _e651 {
                                    phi_1355_ = _e651;
                                    phi_1356_ = _e653;
                                    phi_1357_ = _e655;
                                } else {
                                    let _e662 = (_e655 - 1u);
                                    let _e663 = (_e662 % 128u);
                                    let _e664 = (_e663 < 128u);
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e666 = local_7[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e668 = local_6[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e670 = local_5[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e672 = local_4[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e674 = local_3[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e676 = local_2[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e681 = local_8[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e684 = local_10[_e663];
                                    phi_1355_ = (_e684 <= _e649);
                                    phi_1356_ = type_53(type_25(vec4<f32>(_e666, _e668, _e670, 0f), vec4<f32>(_e672, _e674, _e676, 0f)), _e681);
                                    phi_1357_ = _e662;
                                }
                                let _e687 = phi_1355_;
                                let _e689 = phi_1356_;
                                let _e691 = phi_1357_;
                                if _e687 {
                                    if ((_e689.member_1 & 2147483648u) != 0u) {
                                        phi_4315_ = _e647;
                                        phi_4304_ = _e649;
                                        phi_1375_ = type_4(0u, ((_e689.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1157 = phi_4315_;
                                            let _e1159 = phi_4304_;
                                            let _e1161 = phi_1375_;
                                            if (_e1161.member < _e1161.member_1) {
                                                phi_1376_ = type_4((_e1161.member + 1u), _e1161.member_1);
                                                phi_1399_ = type_4(1u, _e1161.member);
                                            } else {
                                                phi_1376_ = _e1161;
                                                phi_1399_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1174 = phi_1376_;
                                            let _e1176 = phi_1399_;
                                            let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                            if _e1180 {
                                                let _e1181 = ((_e689.member_1 & 268435455u) + _e1176.member_1);
                                                let _e1182 = (_e1181 < _e98);
                                                if _e1182 {
                                                    if _e1182 {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1186 = global_2.member[_e1181].member_1;
                                                    phi_1420_ = _e1186;
                                                } else {
                                                    phi_1420_ = 4294967295u;
                                                }
                                                let _e1188 = phi_1420_;
                                                if (_e1181 >= _e98) {
                                                    phi_1512_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1182 {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1195 = global_2.member[_e1181].member[_e611];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1201 = global_2.member[_e1181].member[_e617];
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1207 = global_2.member[_e1181].member[_e623];
                                                    let _e1209 = (3u + _e611);
                                                    if (_e1209 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1215 = global_2.member[_e1181].member[_e1209];
                                                    let _e1216 = (3u + _e617);
                                                    if (_e1216 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1222 = global_2.member[_e1181].member[_e1216];
                                                    let _e1223 = (3u + _e623);
                                                    if (_e1223 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1229 = global_2.member[_e1181].member[_e1223];
                                                    let _e1231 = (6u + _e611);
                                                    if (_e1231 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1237 = global_2.member[_e1181].member[_e1231];
                                                    let _e1238 = (6u + _e617);
                                                    if (_e1238 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1244 = global_2.member[_e1181].member[_e1238];
                                                    let _e1245 = (6u + _e623);
                                                    if (_e1245 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1251 = global_2.member[_e1181].member[_e1245];
                                                    phi_1512_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1195, _e1201, _e1207), array<f32, 3>(_e1215, _e1222, _e1229), array<f32, 3>(_e1237, _e1244, _e1251));
                                                }
                                                let _e1255 = phi_1512_;
                                                let _e1270 = (_e1255[0][2] - _e463);
                                                let _e1273 = (((_e1255[0][0] - _e330) * _e499) - (_e1270 * _e367));
                                                let _e1276 = (((_e1255[0][1] - _e397) * _e499) - (_e1270 * _e433));
                                                let _e1279 = (_e1255[1][2] - _e463);
                                                let _e1282 = (((_e1255[1][0] - _e330) * _e499) - (_e1279 * _e367));
                                                let _e1285 = (((_e1255[1][1] - _e397) * _e499) - (_e1279 * _e433));
                                                let _e1288 = (_e1255[2][2] - _e463);
                                                let _e1291 = (((_e1255[2][0] - _e330) * _e499) - (_e1288 * _e367));
                                                let _e1294 = (((_e1255[2][1] - _e397) * _e499) - (_e1288 * _e433));
                                                let _e1295 = (_e1291 * _e1285);
                                                let _e1296 = (_e1294 * _e1282);
                                                let _e1297 = (_e1273 * _e1294);
                                                let _e1298 = (_e1276 * _e1291);
                                                let _e1299 = (_e1282 * _e1276);
                                                let _e1300 = (_e1285 * _e1273);
                                                let _e1305 = (((_e1295 >= _e1296) && (_e1297 >= _e1298)) && (_e1299 >= _e1300));
                                                let _e1311 = (_e1305 || (((_e1295 <= _e1296) && (_e1297 <= _e1298)) && (_e1299 <= _e1300)));
                                                if _e1311 {
                                                    let _e1313 = select(-1f, 1f, _e1305);
                                                    let _e1315 = ((_e1295 - _e1296) * _e1313);
                                                    let _e1317 = select(0f, _e1315, (_e1315 > 0f));
                                                    let _e1319 = ((_e1297 - _e1298) * _e1313);
                                                    let _e1321 = select(0f, _e1319, (_e1319 > 0f));
                                                    let _e1323 = ((_e1299 - _e1300) * _e1313);
                                                    let _e1325 = select(0f, _e1323, (_e1323 > 0f));
                                                    let _e1327 = ((_e1317 + _e1321) + _e1325);
                                                    let _e1329 = select(_e1255[1][0], _e1255[0][0], (_e1255[0][0] < _e1255[1][0]));
                                                    let _e1333 = select(_e1255[1][0], _e1255[0][0], (_e1255[0][0] > _e1255[1][0]));
                                                    let _e1337 = select(_e1255[1][1], _e1255[0][1], (_e1255[0][1] < _e1255[1][1]));
                                                    let _e1341 = select(_e1255[1][1], _e1255[0][1], (_e1255[0][1] > _e1255[1][1]));
                                                    let _e1345 = select(_e1255[1][2], _e1255[0][2], (_e1255[0][2] < _e1255[1][2]));
                                                    let _e1349 = select(_e1255[1][2], _e1255[0][2], (_e1255[0][2] > _e1255[1][2]));
                                                    let _e1354 = ((select(_e1255[2][0], _e1329, (_e1329 < _e1255[2][0])) - _e368) * _e371);
                                                    let _e1355 = ((select(_e1255[2][0], _e1333, (_e1333 > _e1255[2][0])) - _e369) * _e371);
                                                    let _e1358 = ((select(_e1255[2][1], _e1337, (_e1337 < _e1255[2][1])) - _e434) * _e437);
                                                    let _e1359 = ((select(_e1255[2][1], _e1341, (_e1341 > _e1255[2][1])) - _e435) * _e437);
                                                    let _e1362 = ((select(_e1255[2][2], _e1345, (_e1345 < _e1255[2][2])) - _e500) * _e503);
                                                    let _e1363 = ((select(_e1255[2][2], _e1349, (_e1349 > _e1255[2][2])) - _e501) * _e503);
                                                    let _e1365 = select(_e1363, _e1362, (_e1362 < _e1363));
                                                    let _e1367 = select(_e1363, _e1362, (_e1362 > _e1363));
                                                    let _e1369 = select(_e1355, _e1354, (_e1354 < _e1355));
                                                    let _e1371 = select(_e1359, _e1358, (_e1358 < _e1359));
                                                    let _e1373 = select(_e1371, _e1369, (_e1369 > _e1371));
                                                    let _e1375 = select(_e1365, _e1373, (_e1373 > _e1365));
                                                    let _e1377 = select(_e1355, _e1354, (_e1354 > _e1355));
                                                    let _e1379 = select(_e1359, _e1358, (_e1358 > _e1359));
                                                    let _e1381 = select(_e1379, _e1377, (_e1377 < _e1379));
                                                    let _e1383 = select(_e1367, _e1381, (_e1381 < _e1367));
                                                    let _e1384 = -(_e1365);
                                                    let _e1390 = select(_e606, _e1375, (_e1375 > _e606));
                                                    let _e1394 = select(_e1282, _e1273, (_e1273 < _e1282));
                                                    let _e1399 = select(_e1282, _e1273, (_e1273 > _e1282));
                                                    let _e1406 = select(_e1285, _e1276, (_e1276 < _e1285));
                                                    let _e1411 = select(_e1285, _e1276, (_e1276 > _e1285));
                                                    let _e1420 = (((((_e1311 && (_e1327 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1291, _e1394, (_e1394 < _e1291)) <= 0f) && (select(_e1291, _e1399, (_e1399 > _e1291)) >= 0f))) && ((select(_e1294, _e1406, (_e1406 < _e1294)) <= 0f) && (select(_e1294, _e1411, (_e1411 > _e1294)) >= 0f))) && (_e1390 <= (_e1383 + (select(_e1384, _e1367, (_e1367 > _e1384)) * 0.0000019073523f)))) && (_e1390 <= _e1159));
                                                    if _e1420 {
                                                        let _e1425 = (_e1255[1][0] - _e1255[0][0]);
                                                        let _e1426 = (_e1255[1][1] - _e1255[0][1]);
                                                        let _e1427 = (_e1255[1][2] - _e1255[0][2]);
                                                        let _e1428 = vec3<f32>(_e1425, _e1426, _e1427);
                                                        let _e1429 = (_e1255[2][0] - _e1255[1][0]);
                                                        let _e1430 = (_e1255[2][1] - _e1255[1][1]);
                                                        let _e1431 = (_e1255[2][2] - _e1255[1][2]);
                                                        let _e1432 = vec3<f32>(_e1429, _e1430, _e1431);
                                                        let _e1433 = (_e1255[0][0] - _e1255[2][0]);
                                                        let _e1434 = (_e1255[0][1] - _e1255[2][1]);
                                                        let _e1435 = (_e1255[0][2] - _e1255[2][2]);
                                                        let _e1436 = vec3<f32>(_e1433, _e1434, _e1435);
                                                        let _e1439 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                        let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                        let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                        let _e1455 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                        let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                        let _e1460 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                        let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                        let _e1468 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                        let _e1470 = select(_e1468, _e1465, (_e1465 > _e1468));
                                                        let _e1473 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                        let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                        let _e1477 = select(_e1462, _e1449, (_e1449 > _e1462));
                                                        let _e1479 = select(_e1475, _e1477, (_e1477 > _e1475));
                                                        if (_e1449 == _e1479) {
                                                            phi_2043_ = _e1285;
                                                            phi_2044_ = _e1282;
                                                            phi_2045_ = _e1276;
                                                            phi_2046_ = _e1273;
                                                            phi_2047_ = vec3<f32>(_e1255[0][0], _e1255[0][1], _e1255[0][2]);
                                                            phi_2048_ = _e1436;
                                                            phi_2049_ = _e1432;
                                                            phi_2050_ = _e1428;
                                                        } else {
                                                            let _e1481 = (_e1462 == _e1479);
                                                            let _e1486 = vec3(_e1481);
                                                            phi_2043_ = select(_e1276, _e1294, _e1481);
                                                            phi_2044_ = select(_e1273, _e1291, _e1481);
                                                            phi_2045_ = select(_e1294, _e1285, _e1481);
                                                            phi_2046_ = select(_e1291, _e1282, _e1481);
                                                            phi_2047_ = select(vec3<f32>(_e1255[2][0], _e1255[2][1], _e1255[2][2]), vec3<f32>(_e1255[1][0], _e1255[1][1], _e1255[1][2]), _e1486);
                                                            phi_2048_ = select(_e1432, _e1428, _e1486);
                                                            phi_2049_ = select(_e1428, _e1436, _e1486);
                                                            phi_2050_ = select(_e1436, _e1432, _e1486);
                                                        }
                                                        let _e1492 = phi_2043_;
                                                        let _e1494 = phi_2044_;
                                                        let _e1496 = phi_2045_;
                                                        let _e1498 = phi_2046_;
                                                        let _e1500 = phi_2047_;
                                                        let _e1502 = phi_2048_;
                                                        let _e1504 = phi_2049_;
                                                        let _e1506 = phi_2050_;
                                                        let _e1513 = ((_e1504.y * _e1502.z) - (_e1502.y * _e1504.z));
                                                        let _e1518 = ((_e1504.z * _e1502.x) - (_e1502.z * _e1504.x));
                                                        let _e1521 = ((_e1504.x * _e1502.y) - (_e1502.x * _e1504.y));
                                                        let _e1524 = ((_e1317 >= _e1321) && (_e1317 >= _e1325));
                                                        let _e1525 = (_e1321 >= _e1325);
                                                        let _e1539 = (((_e1513 * (select(select(_e1255[2][0], _e1255[1][0], _e1525), _e1255[0][0], _e1524) - _e330)) + (_e1518 * (select(select(_e1255[2][1], _e1255[1][1], _e1525), _e1255[0][1], _e1524) - _e397))) + (_e1521 * (select(select(_e1255[2][2], _e1255[1][2], _e1525), _e1255[0][2], _e1524) - _e463)));
                                                        let _e1544 = (((_e1513 * _e367) + (_e1518 * _e433)) + (_e1521 * _e499));
                                                        let _e1545 = (_e1494 - _e1498);
                                                        let _e1546 = (_e1492 - _e1496);
                                                        let _e1549 = ((_e1545 * _e1545) + (_e1546 * _e1546));
                                                        let _e1556 = (-(((_e1498 * _e1545) + (_e1496 * _e1546))) / select(0.000000000000000000000000000000000000011754944f, _e1549, (_e1549 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1558 = select(1f, _e1556, (_e1556 < 1f));
                                                        let _e1560 = select(0f, _e1558, (_e1558 > 0f));
                                                        let _e1569 = ((_e1500.x + (_e1506.x * _e1560)) - _e330);
                                                        let _e1572 = ((_e1500.y + (_e1506.y * _e1560)) - _e397);
                                                        let _e1575 = ((_e1500.z + (_e1506.z * _e1560)) - _e463);
                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u));
                                                        let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1513) & 2147483647u));
                                                        let _e1597 = bitcast<f32>((bitcast<u32>(_e1518) & 2147483647u));
                                                        let _e1599 = select(_e1597, _e1594, (_e1594 > _e1597));
                                                        let _e1602 = bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u));
                                                        let _e1621 = bitcast<f32>((bitcast<u32>(_e1504.x) & 2147483647u));
                                                        let _e1624 = bitcast<f32>((bitcast<u32>(_e1504.y) & 2147483647u));
                                                        let _e1626 = select(_e1624, _e1621, (_e1621 > _e1624));
                                                        let _e1629 = bitcast<f32>((bitcast<u32>(_e1504.z) & 2147483647u));
                                                        let _e1635 = bitcast<f32>((bitcast<u32>(_e1502.x) & 2147483647u));
                                                        let _e1638 = bitcast<f32>((bitcast<u32>(_e1502.y) & 2147483647u));
                                                        let _e1640 = select(_e1638, _e1635, (_e1635 > _e1638));
                                                        let _e1643 = bitcast<f32>((bitcast<u32>(_e1502.z) & 2147483647u));
                                                        let _e1649 = ((bitcast<f32>((bitcast<u32>(((((_e1513 * _e1569) + (_e1518 * _e1572)) + (_e1521 * _e1575)) - _e1539)) & 2147483647u)) <= ((0.0000009536743f * select(_e1479, _e1588, (_e1588 > _e1479))) * select(_e1602, _e1599, (_e1599 > _e1602)))) && !((bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u)) <= ((0.0000038146973f * select(_e1629, _e1626, (_e1626 > _e1629))) * select(_e1643, _e1640, (_e1640 > _e1643))))));
                                                        let _e1650 = (_e1539 / _e1544);
                                                        if (_e1420 && !(_e1649)) {
                                                            let _e1653 = (_e1575 / _e499);
                                                            let _e1661 = (((_e1513 * (_e1569 - (_e367 * _e1653))) + (_e1518 * (_e1572 - (_e433 * _e1653)))) / _e1544);
                                                            phi_2241_ = select(select(_e1653, (_e1653 + _e1661), (bitcast<f32>((bitcast<u32>(_e1661) & 2147483647u)) <= _e1479)), _e1650, _e1649);
                                                        } else {
                                                            phi_2241_ = _e1650;
                                                        }
                                                        let _e1670 = phi_2241_;
                                                        let _e1672 = select(_e1383, _e1670, (_e1670 < _e1383));
                                                        let _e1674 = select(_e1375, _e1672, (_e1672 > _e1375));
                                                        let _e1675 = (1f / _e1327);
                                                        phi_2261_ = type_32(_e1674, (_e1321 * _e1675), (_e1325 * _e1675), ((_e1420 && (_e1674 >= _e606)) && (_e1674 <= _e1159)));
                                                        phi_2262_ = type_32();
                                                    } else {
                                                        phi_2261_ = type_32();
                                                        phi_2262_ = type_32(0f, 0f, 0f, _e1420);
                                                    }
                                                    let _e1684 = phi_2261_;
                                                    let _e1686 = phi_2262_;
                                                    phi_2265_ = _e1684;
                                                    phi_2266_ = _e1686;
                                                    phi_2267_ = select(true, false, _e1420);
                                                } else {
                                                    phi_2265_ = type_32();
                                                    phi_2266_ = type_32(0f, 0f, 0f, _e1311);
                                                    phi_2267_ = true;
                                                }
                                                let _e1689 = phi_2265_;
                                                let _e1691 = phi_2266_;
                                                let _e1693 = phi_2267_;
                                                if _e1693 {
                                                    phi_2271_ = _e1691;
                                                } else {
                                                    phi_2271_ = _e1689;
                                                }
                                                let _e1695 = phi_2271_;
                                                if _e1695.member_3 {
                                                    phi_2280_ = type_21(_e1695.member, _e1695.member_1, _e1695.member_2, _e1188);
                                                } else {
                                                    phi_2280_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1702 = phi_2280_;
                                                if (_e1702.member_3 != 4294967295u) {
                                                    if (_e1188 != 4294967295u) {
                                                        phi_2292_ = type_4(0u, 8u);
                                                        phi_2295_ = _e1702;
                                                        loop {
                                                            let _e1707 = phi_2292_;
                                                            let _e1709 = phi_2295_;
                                                            if (_e1707.member < _e1707.member_1) {
                                                                phi_2293_ = type_4((_e1707.member + 1u), _e1707.member_1);
                                                                phi_2318_ = type_4(1u, _e1707.member);
                                                            } else {
                                                                phi_2293_ = _e1707;
                                                                phi_2318_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1722 = phi_2293_;
                                                            let _e1724 = phi_2318_;
                                                            let _e1728 = (bitcast<i32>(_e1724.member) != 0i);
                                                            if _e1728 {
                                                                let _e1729 = (_e1724.member_1 < 8u);
                                                                if _e1729 {
                                                                } else {
                                                                    phi_4305_ = true;
                                                                    break;
                                                                }
                                                                let _e1734 = local_9[_e1724.member_1].member;
                                                                if (_e1709.member < _e1734) {
                                                                    phi_2351_ = true;
                                                                } else {
                                                                    let _e1736 = local_9[_e1724.member_1].member;
                                                                    if (_e1709.member == _e1736) {
                                                                        let _e1741 = local_9[_e1724.member_1].member_3;
                                                                        phi_2350_ = (_e1709.member_3 < _e1741);
                                                                    } else {
                                                                        phi_2350_ = false;
                                                                    }
                                                                    let _e1744 = phi_2350_;
                                                                    phi_2351_ = _e1744;
                                                                }
                                                                let _e1746 = phi_2351_;
                                                                if _e1746 {
                                                                    if _e1729 {
                                                                    } else {
                                                                        phi_4305_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1747 = local_9[_e1724.member_1];
                                                                    local_9[_e1724.member_1] = type_21(_e1709.member, _e1709.member_1, _e1709.member_2, _e1709.member_3);
                                                                    phi_2372_ = type_21(_e1747.member, _e1747.member_1, _e1747.member_2, _e1747.member_3);
                                                                } else {
                                                                    phi_2372_ = _e1709;
                                                                }
                                                                let _e1758 = phi_2372_;
                                                                phi_2296_ = _e1758;
                                                            } else {
                                                                phi_2296_ = type_21();
                                                            }
                                                            let _e1760 = phi_2296_;
                                                            continue;
                                                            continuing {
                                                                phi_2292_ = _e1722;
                                                                phi_2295_ = _e1760;
                                                                phi_4305_ = _e1157;
                                                                break if !(_e1728);
                                                            }
                                                        }
                                                        let _e1763 = phi_4305_;
                                                        phi_4463_ = _e1159;
                                                        phi_4458_ = _e1763;
                                                        if _e1763 {
                                                            break;
                                                        }
                                                        let _e1766 = local_9[7u].member_3;
                                                        if (_e1766 != 4294967295u) {
                                                            let _e1770 = local_9[7u].member;
                                                            phi_4547_ = _e1770;
                                                        } else {
                                                            phi_4547_ = _e1159;
                                                        }
                                                        let _e1772 = phi_4547_;
                                                        phi_4546_ = _e1772;
                                                        phi_4461_ = _e1763;
                                                    } else {
                                                        phi_4546_ = _e1159;
                                                        phi_4461_ = _e1157;
                                                    }
                                                    let _e1774 = phi_4546_;
                                                    let _e1776 = phi_4461_;
                                                    phi_4545_ = _e1774;
                                                    phi_4460_ = _e1776;
                                                } else {
                                                    phi_4545_ = _e1159;
                                                    phi_4460_ = _e1157;
                                                }
                                                let _e1778 = phi_4545_;
                                                let _e1780 = phi_4460_;
                                                phi_4544_ = _e1778;
                                                phi_4459_ = _e1780;
                                            } else {
                                                phi_4544_ = _e1159;
                                                phi_4459_ = _e1157;
                                            }
                                            let _e1782 = phi_4544_;
                                            let _e1784 = phi_4459_;
                                            continue;
                                            continuing {
                                                phi_4315_ = _e1784;
                                                phi_4304_ = _e1782;
                                                phi_1375_ = _e1174;
                                                phi_4463_ = _e1782;
                                                phi_4458_ = _e1784;
                                                break if !(_e1180);
                                            }
                                        }
                                        let _e1787 = phi_4463_;
                                        let _e1789 = phi_4458_;
                                        phi_4548_ = _e1789;
                                        if _e1789 {
                                            break;
                                        }
                                        phi_4662_ = _e1787;
                                        phi_4552_ = _e1789;
                                        phi_3612_ = false;
                                        phi_3613_ = _e689;
                                        phi_3614_ = select(_e691, 0u, (_e606 > _e1787));
                                    } else {
                                        if (_e689.member_1 >= _e96) {
                                            phi_3150_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e689.member_1 < _e96) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e702 = (_e266 * 2u);
                                            let _e704 = ((1u + _e702) % 7u);
                                            if (_e704 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e709 = global_5.member[_e689.member_1][_e704];
                                            let _e711 = ((_e702 + 2u) % 7u);
                                            if (_e711 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e716 = global_5.member[_e689.member_1][_e711];
                                            let _e717 = (_e265 * 2u);
                                            let _e719 = ((1u + _e717) % 7u);
                                            if (_e719 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e724 = global_5.member[_e689.member_1][_e719];
                                            let _e726 = ((_e717 + 2u) % 7u);
                                            if (_e726 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e731 = global_5.member[_e689.member_1][_e726];
                                            let _e732 = (_e267 * 2u);
                                            let _e734 = ((1u + _e732) % 7u);
                                            if (_e734 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e739 = global_5.member[_e689.member_1][_e734];
                                            let _e741 = ((_e732 + 2u) % 7u);
                                            if (_e741 < 7u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e746 = global_5.member[_e689.member_1][_e741];
                                            let _e769 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.x - _e689.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e770 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.y - _e689.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e771 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.z - _e689.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e773 = select(_e146, _e769, (_e769 > _e146));
                                            let _e775 = select(_e146, _e770, (_e770 > _e146));
                                            let _e777 = select(_e146, _e771, (_e771 > _e146));
                                            let _e808 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e709 & 2097151u))) - 8388608f) * _e773));
                                            let _e813 = (bitcast<i32>((_e709 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e816 = bitcast<f32>((_e808 & bitcast<u32>(_e813)));
                                            let _e817 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 2097151u))) - 8388608f) * _e775));
                                            let _e822 = (bitcast<i32>((_e724 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e825 = bitcast<f32>((_e817 & bitcast<u32>(_e822)));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 2097151u))) - 8388608f) * _e777));
                                            let _e831 = (bitcast<i32>((_e739 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e838 = bitcast<f32>((_e808 & bitcast<u32>(~(_e813))));
                                            let _e842 = bitcast<f32>((_e817 & bitcast<u32>(~(_e822))));
                                            let _e846 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e847 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e716 & 2097151u))) - 8388608f) * _e773));
                                            let _e852 = (bitcast<i32>((_e716 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e855 = bitcast<f32>((_e847 & bitcast<u32>(_e852)));
                                            let _e856 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 2097151u))) - 8388608f) * _e775));
                                            let _e861 = (bitcast<i32>((_e731 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e864 = bitcast<f32>((_e856 & bitcast<u32>(_e861)));
                                            let _e865 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e746 & 2097151u))) - 8388608f) * _e777));
                                            let _e870 = (bitcast<i32>((_e746 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e873 = bitcast<f32>((_e865 & bitcast<u32>(_e870)));
                                            let _e877 = bitcast<f32>((_e847 & bitcast<u32>(~(_e852))));
                                            let _e881 = bitcast<f32>((_e856 & bitcast<u32>(~(_e861))));
                                            let _e885 = bitcast<f32>((_e865 & bitcast<u32>(~(_e870))));
                                            let _e915 = global_5.member[_e689.member_1][0u];
                                            let _e919 = global_5.member[_e689.member_1][2u];
                                            let _e923 = global_5.member[_e689.member_1][4u];
                                            let _e927 = global_5.member[_e689.member_1][6u];
                                            let _e939 = (((_e919 >> bitcast<u32>(22i)) | ((_e923 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e927 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e940 = (_e915 & 268435455u);
                                            let _e941 = (_e939 & 268435455u);
                                            let _e944 = ((_e915 >> bitcast<u32>(28u)) & 7u);
                                            let _e952 = ((_e915 >> bitcast<u32>(31i)) | (((_e939 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e953 = (_e944 != 0u);
                                            if (_e944 == 0u) {
                                                phi_3112_ = _e940;
                                            } else {
                                                if (_e944 == 7u) {
                                                    phi_3111_ = 2147483648u;
                                                } else {
                                                    phi_3111_ = ((2147483648u | (_e944 << bitcast<u32>(28u))) | (_e941 & 268435455u));
                                                }
                                                let _e962 = phi_3111_;
                                                phi_3112_ = _e962;
                                            }
                                            let _e964 = phi_3112_;
                                            if _e953 {
                                                let _e965 = (_e944 != 7u);
                                                if _e965 {
                                                    phi_3122_ = (_e941 + _e944);
                                                } else {
                                                    phi_3122_ = u32();
                                                }
                                                let _e968 = phi_3122_;
                                                phi_3124_ = _e968;
                                                phi_3125_ = select(true, false, _e965);
                                            } else {
                                                phi_3124_ = u32();
                                                phi_3125_ = true;
                                            }
                                            let _e971 = phi_3124_;
                                            let _e973 = phi_3125_;
                                            if (_e952 == 0u) {
                                                phi_3146_ = (_e940 + select(0u, 1u, !(_e953)));
                                            } else {
                                                if (_e952 == 7u) {
                                                    phi_3145_ = 2147483648u;
                                                } else {
                                                    phi_3145_ = ((2147483648u | (_e952 << bitcast<u32>(28u))) | (select(_e971, _e941, _e973) & 268435455u));
                                                }
                                                let _e986 = phi_3145_;
                                                phi_3146_ = _e986;
                                            }
                                            let _e988 = phi_3146_;
                                            phi_3150_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e689.member.member.x + _e816), (_e689.member.member.x + _e838), (_e689.member.member_1.x - _e855), (_e689.member.member_1.x - _e877)), vec4<f32>((_e689.member.member.y + _e825), (_e689.member.member.y + _e842), (_e689.member.member_1.y - _e864), (_e689.member.member_1.y - _e881)), vec4<f32>((_e689.member.member.z + _e834), (_e689.member.member.z + _e846), (_e689.member.member_1.z - _e873), (_e689.member.member_1.z - _e885))), type_53(type_25((_e689.member.member + vec4<f32>(_e816, _e825, _e834, 0f)), (_e689.member.member_1 - vec4<f32>(_e855, _e864, _e873, 0f))), _e964), type_53(type_25((_e689.member.member + vec4<f32>(_e838, _e842, _e846, 0f)), (_e689.member.member_1 - vec4<f32>(_e877, _e881, _e885, 0f))), _e988));
                                        }
                                        let _e993 = phi_3150_;
                                        let _e1004 = ((_e993.member[0].x - _e368) * _e371);
                                        let _e1005 = ((_e993.member[0].y - _e368) * _e371);
                                        let _e1006 = ((_e993.member[0].z - _e369) * _e371);
                                        let _e1007 = ((_e993.member[0].w - _e369) * _e371);
                                        let _e1017 = ((_e993.member[1].x - _e434) * _e437);
                                        let _e1018 = ((_e993.member[1].y - _e434) * _e437);
                                        let _e1019 = ((_e993.member[1].z - _e435) * _e437);
                                        let _e1020 = ((_e993.member[1].w - _e435) * _e437);
                                        let _e1030 = ((_e993.member[2].x - _e500) * _e503);
                                        let _e1031 = ((_e993.member[2].y - _e500) * _e503);
                                        let _e1032 = ((_e993.member[2].z - _e501) * _e503);
                                        let _e1033 = ((_e993.member[2].w - _e501) * _e503);
                                        let _e1035 = select(_e1032, _e1030, (_e1030 < _e1032));
                                        let _e1037 = select(_e1033, _e1031, (_e1031 < _e1033));
                                        let _e1039 = select(_e1032, _e1030, (_e1030 > _e1032));
                                        let _e1041 = select(_e1033, _e1031, (_e1031 > _e1033));
                                        let _e1043 = select(_e1006, _e1004, (_e1004 < _e1006));
                                        let _e1045 = select(_e1007, _e1005, (_e1005 < _e1007));
                                        let _e1047 = select(_e1019, _e1017, (_e1017 < _e1019));
                                        let _e1049 = select(_e1020, _e1018, (_e1018 < _e1020));
                                        let _e1051 = select(_e1047, _e1043, (_e1043 > _e1047));
                                        let _e1053 = select(_e1049, _e1045, (_e1045 > _e1049));
                                        let _e1055 = select(_e1035, _e1051, (_e1051 > _e1035));
                                        let _e1057 = select(_e1037, _e1053, (_e1053 > _e1037));
                                        let _e1059 = select(_e1006, _e1004, (_e1004 > _e1006));
                                        let _e1061 = select(_e1007, _e1005, (_e1005 > _e1007));
                                        let _e1063 = select(_e1019, _e1017, (_e1017 > _e1019));
                                        let _e1065 = select(_e1020, _e1018, (_e1018 > _e1020));
                                        let _e1067 = select(_e1063, _e1059, (_e1059 < _e1063));
                                        let _e1069 = select(_e1065, _e1061, (_e1061 < _e1065));
                                        let _e1074 = -(_e1035);
                                        let _e1075 = -(_e1037);
                                        let _e1082 = (select(_e1039, _e1067, (_e1067 < _e1039)) + (select(_e1074, _e1039, (_e1039 > _e1074)) * 0.0000019073523f));
                                        let _e1083 = (select(_e1041, _e1069, (_e1069 < _e1041)) + (select(_e1075, _e1041, (_e1041 > _e1075)) * 0.0000019073523f));
                                        let _e1085 = select(_e606, _e1055, (_e1055 > _e606));
                                        let _e1087 = select(_e606, _e1057, (_e1057 > _e606));
                                        let _e1092 = (_e1085 <= select(_e649, _e1082, (_e1082 < _e649)));
                                        let _e1093 = (_e1087 <= select(_e649, _e1083, (_e1083 < _e649)));
                                        let _e1094 = (_e1085 <= _e1087);
                                        if _e1092 {
                                            if _e1093 {
                                                if _e1094 {
                                                    phi_3513_ = _e993.member_2;
                                                } else {
                                                    phi_3513_ = _e993.member_1;
                                                }
                                                let _e1098 = phi_3513_;
                                                let _e1119 = (_e691 % 128u);
                                                let _e1120 = (_e1119 < 128u);
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_8[_e1119] = _e1098.member_1;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_7[_e1119] = _e1098.member.member.x;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_6[_e1119] = _e1098.member.member.y;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_5[_e1119] = _e1098.member.member.z;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_4[_e1119] = _e1098.member.member_1.x;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_3[_e1119] = _e1098.member.member_1.y;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_2[_e1119] = _e1098.member.member_1.z;
                                                if _e1120 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_10[_e1119] = select(_e1085, _e1087, _e1094);
                                                if _e1094 {
                                                    phi_3589_ = _e993.member_1;
                                                } else {
                                                    phi_3589_ = _e993.member_2;
                                                }
                                                let _e1133 = phi_3589_;
                                                phi_3590_ = _e1133;
                                                phi_3591_ = (_e691 + 1u);
                                            } else {
                                                phi_3590_ = type_53();
                                                phi_3591_ = u32();
                                            }
                                            let _e1135 = phi_3590_;
                                            let _e1137 = phi_3591_;
                                            phi_3593_ = _e1135;
                                            phi_3594_ = _e1137;
                                            phi_3595_ = select(true, false, _e1093);
                                        } else {
                                            phi_3593_ = type_53();
                                            phi_3594_ = u32();
                                            phi_3595_ = true;
                                        }
                                        let _e1140 = phi_3593_;
                                        let _e1142 = phi_3594_;
                                        let _e1144 = phi_3595_;
                                        if _e1144 {
                                            if _e1092 {
                                                phi_3604_ = _e993.member_1;
                                            } else {
                                                phi_3604_ = _e993.member_2;
                                            }
                                            let _e1148 = phi_3604_;
                                            phi_3609_ = select(_e1093, true, _e1092);
                                            phi_3610_ = _e1148;
                                        } else {
                                            phi_3609_ = _e687;
                                            phi_3610_ = _e1140;
                                        }
                                        let _e1151 = phi_3609_;
                                        let _e1153 = phi_3610_;
                                        phi_4662_ = _e649;
                                        phi_4552_ = _e647;
                                        phi_3612_ = _e1151;
                                        phi_3613_ = _e1153;
                                        phi_3614_ = select(_e1142, _e691, _e1144);
                                    }
                                    let _e1793 = phi_4662_;
                                    let _e1795 = phi_4552_;
                                    let _e1797 = phi_3612_;
                                    let _e1799 = phi_3613_;
                                    let _e1801 = phi_3614_;
                                    phi_4661_ = _e1793;
                                    phi_4551_ = _e1795;
                                    phi_3615_ = _e1797;
                                    phi_3616_ = _e1799;
                                    phi_3617_ = _e1801;
                                    phi_3618_ = (_e657 - 1u);
                                } else {
                                    phi_4661_ = _e649;
                                    phi_4551_ = _e647;
                                    phi_3615_ = _e687;
                                    phi_3616_ = _e689;
                                    phi_3617_ = _e691;
                                    phi_3618_ = _e657;
                                }
                                let _e1803 = phi_4661_;
                                let _e1805 = phi_4551_;
                                let _e1807 = phi_3615_;
                                let _e1809 = phi_3616_;
                                let _e1811 = phi_3617_;
                                let _e1813 = phi_3618_;
                                phi_4660_ = _e1803;
                                phi_4550_ = _e1805;
                                phi_3619_ = _e1807;
                                phi_3620_ = _e1809;
                                phi_3621_ = _e1811;
                                phi_3622_ = _e1813;
                            } else {
                                phi_4660_ = _e649;
                                phi_4550_ = _e647;
                                phi_3619_ = bool();
                                phi_3620_ = type_53();
                                phi_3621_ = u32();
                                phi_3622_ = u32();
                            }
                            let _e1815 = phi_4660_;
                            let _e1817 = phi_4550_;
                            let _e1819 = phi_3619_;
                            let _e1821 = phi_3620_;
                            let _e1823 = phi_3621_;
                            let _e1825 = phi_3622_;
                            phi_4659_ = _e1815;
                            phi_4549_ = _e1817;
                            phi_1251_ = _e1819;
                            phi_1254_ = _e1821;
                            phi_1256_ = _e1823;
                            phi_1258_ = _e1825;
                            phi_3623_ = _e661;
                        } else {
                            phi_4659_ = _e649;
                            phi_4549_ = _e647;
                            phi_1251_ = bool();
                            phi_1254_ = type_53();
                            phi_1256_ = u32();
                            phi_1258_ = u32();
                            phi_3623_ = false;
                        }
                        let _e1827 = phi_4659_;
                        let _e1829 = phi_4549_;
                        let _e1831 = phi_1251_;
                        let _e1833 = phi_1254_;
                        let _e1835 = phi_1256_;
                        let _e1837 = phi_1258_;
                        let _e1839 = phi_3623_;
                        continue;
                        continuing {
                            phi_4318_ = _e1829;
                            phi_4245_ = _e1827;
                            phi_1250_ = _e1831;
                            phi_1253_ = _e1833;
                            phi_1255_ = _e1835;
                            phi_1257_ = _e1837;
                            phi_4548_ = _e1829;
                            break if !(_e1839);
                        }
                    }
                    let _e1842 = phi_4548_;
                    if _e1842 {
                        break;
                    }
                    phi_3630_ = type_4(0u, 8u);
                    loop {
                        let _e1844 = phi_3630_;
                        if (_e1844.member < _e1844.member_1) {
                            phi_3631_ = type_4((_e1844.member + 1u), _e1844.member_1);
                            phi_3654_ = type_4(1u, _e1844.member);
                        } else {
                            phi_3631_ = _e1844;
                            phi_3654_ = type_4(0u, type_4().member_1);
                        }
                        let _e1857 = phi_3631_;
                        let _e1859 = phi_3654_;
                        let _e1863 = (bitcast<i32>(_e1859.member) != 0i);
                        if _e1863 {
                            let _e1864 = (_e1859.member_1 < 8u);
                            if _e1864 {
                            } else {
                                phi_4641_ = true;
                                break;
                            }
                            let _e1866 = local_9[_e1859.member_1];
                            if (_e1866.member_3 != 4294967295u) {
                                let _e1872 = -(_e508);
                                let _e1873 = bitcast<u32>(_e1866.member);
                                let _e1877 = (bitcast<i32>((_e1873 >> bitcast<u32>(23i))) & 255i);
                                let _e1878 = (_e1877 + _e1872);
                                if (_e1877 == 255i) {
                                    phi_3727_ = _e1866.member;
                                } else {
                                    if (_e1877 > 0i) {
                                        if (_e1878 > 0i) {
                                            let _e1882 = (_e1878 < 255i);
                                            if _e1882 {
                                                phi_3706_ = bitcast<f32>((_e1873 + bitcast<u32>((_e1872 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3706_ = f32();
                                            }
                                            let _e1889 = phi_3706_;
                                            phi_3708_ = _e1889;
                                            phi_3709_ = select(true, false, _e1882);
                                        } else {
                                            phi_3708_ = f32();
                                            phi_3709_ = true;
                                        }
                                        let _e1892 = phi_3708_;
                                        let _e1894 = phi_3709_;
                                        phi_3710_ = _e1892;
                                        phi_3711_ = _e1894;
                                    } else {
                                        phi_3710_ = f32();
                                        phi_3711_ = true;
                                    }
                                    let _e1896 = phi_3710_;
                                    let _e1898 = phi_3711_;
                                    if _e1898 {
                                        let _e1899 = (_e1873 & 2147483648u);
                                        let _e1906 = ((_e1873 & 8388607u) | (select(0u, 1u, ((_e1873 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1910 = (_e1906 == 0u);
                                        if _e1910 {
                                            phi_4192_ = bitcast<f32>(_e1899);
                                        } else {
                                            let _e1915 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1906)), 32u, _e1910) - 8u);
                                            let _e1918 = (_e1906 << bitcast<u32>((_e1915 & 31u)));
                                            let _e1920 = ((_e1878 + select(0i, 1i, (_e1877 == 0i))) - bitcast<i32>(_e1915));
                                            if (_e1920 >= 255i) {
                                                phi_4182_ = bitcast<f32>((_e1899 | 2139095040u));
                                                phi_4183_ = f32();
                                                phi_4184_ = true;
                                            } else {
                                                let _e1922 = (_e1920 > 0i);
                                                if _e1922 {
                                                    phi_4176_ = bitcast<f32>(((_e1899 | (bitcast<u32>(_e1920) << bitcast<u32>(23i))) | (_e1918 & 8388607u)));
                                                    phi_4177_ = f32();
                                                } else {
                                                    if (_e1920 < -24i) {
                                                        phi_4142_ = 26u;
                                                    } else {
                                                        phi_4142_ = bitcast<u32>((1i - _e1920));
                                                    }
                                                    let _e1927 = phi_4142_;
                                                    let _e1928 = (_e1927 & 31u);
                                                    let _e1930 = (_e1918 >> bitcast<u32>(_e1928));
                                                    let _e1934 = (_e1918 & ((1u << bitcast<u32>(_e1928)) - 1u));
                                                    let _e1938 = (1u << bitcast<u32>(((_e1927 - 1u) & 31u)));
                                                    if (_e1934 > _e1938) {
                                                        phi_4163_ = true;
                                                    } else {
                                                        if (_e1934 == _e1938) {
                                                            phi_4160_ = ((_e1930 & 1u) == 1u);
                                                        } else {
                                                            phi_4160_ = false;
                                                        }
                                                        let _e1944 = phi_4160_;
                                                        phi_4163_ = _e1944;
                                                    }
                                                    let _e1946 = phi_4163_;
                                                    phi_4176_ = f32();
                                                    phi_4177_ = bitcast<f32>((_e1899 | (_e1930 + select(0u, 1u, _e1946))));
                                                }
                                                let _e1959 = phi_4176_;
                                                let _e1961 = phi_4177_;
                                                phi_4182_ = _e1959;
                                                phi_4183_ = _e1961;
                                                phi_4184_ = _e1922;
                                            }
                                            let _e1965 = phi_4182_;
                                            let _e1967 = phi_4183_;
                                            let _e1969 = phi_4184_;
                                            phi_4192_ = select(_e1967, _e1965, _e1969);
                                        }
                                        let _e1973 = phi_4192_;
                                        phi_3726_ = _e1973;
                                    } else {
                                        phi_3726_ = _e1896;
                                    }
                                    let _e1975 = phi_3726_;
                                    phi_3727_ = _e1975;
                                }
                                let _e1977 = phi_3727_;
                                let _e1978 = bitcast<u32>(_e1977);
                                if ((_e1978 & 2147483647u) >= 2139095040u) {
                                    phi_3739_ = bitcast<f32>(((_e1978 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3739_ = _e1977;
                                }
                                let _e1985 = phi_3739_;
                                phi_3744_ = type_21(_e1985, _e1866.member_1, _e1866.member_2, _e1866.member_3);
                            } else {
                                phi_3744_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1988 = phi_3744_;
                            if _e1864 {
                            } else {
                                phi_4641_ = true;
                                break;
                            }
                            local_9[_e1859.member_1] = type_21(_e1988.member, _e1988.member_1, _e1988.member_2, _e1988.member_3);
                        }
                        continue;
                        continuing {
                            phi_3630_ = _e1857;
                            phi_4641_ = _e1842;
                            break if !(_e1863);
                        }
                    }
                    let _e1996 = phi_4641_;
                    if _e1996 {
                        break;
                    }
                    let _e1997 = local_9;
                    if _e154 {
                    } else {
                        break;
                    }
                    global_6.member[_e152] = array<type_21, 8>(type_21(_e1997[0].member, _e1997[0].member_1, _e1997[0].member_2, _e1997[0].member_3), type_21(_e1997[1].member, _e1997[1].member_1, _e1997[1].member_2, _e1997[1].member_3), type_21(_e1997[2].member, _e1997[2].member_1, _e1997[2].member_2, _e1997[2].member_3), type_21(_e1997[3].member, _e1997[3].member_1, _e1997[3].member_2, _e1997[3].member_3), type_21(_e1997[4].member, _e1997[4].member_1, _e1997[4].member_2, _e1997[4].member_3), type_21(_e1997[5].member, _e1997[5].member_1, _e1997[5].member_2, _e1997[5].member_3), type_21(_e1997[6].member, _e1997[6].member_1, _e1997[6].member_2, _e1997[6].member_3), type_21(_e1997[7].member, _e1997[7].member_1, _e1997[7].member_2, _e1997[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
