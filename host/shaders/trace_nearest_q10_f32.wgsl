struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_26>,
}

struct type_42 {
    member: array<array<type_25, 8>>,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_29,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_42;

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
    var local_9: array<type_25, 8>;
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
    var phi_2261_: type_36;
    var phi_2262_: type_36;
    var phi_2265_: type_36;
    var phi_2266_: type_36;
    var phi_2267_: bool;
    var phi_2271_: type_36;
    var phi_2280_: type_25;
    var phi_2292_: type_4;
    var phi_2295_: type_25;
    var phi_2293_: type_4;
    var phi_2318_: type_4;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2372_: type_25;
    var phi_2296_: type_25;
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
    var phi_3744_: type_25;
    var phi_4641_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_4.member));
            let _e100 = arrayLength((&global_2.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e135 = global_1.member[0u];
            let _e136 = bitcast<i32>(_e135);
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e154 = (_e96.x + (_e96.y * 2097152u));
            let _e155 = (_e154 < arrayLength((&global_5.member)));
            if _e155 {
                let _e156 = (_e154 < arrayLength((&global_6.member)));
                if _e156 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e164 = global_5.member[_e154].member_2[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e154].member_2[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e154].member_2[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e154].member[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_5.member[_e154].member[1u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e199 = global_5.member[_e154].member[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e203 = select(_e173, _e166, (_e173 < _e166));
                    let _e205 = select(_e180, _e203, (_e180 < _e203));
                    let _e207 = select(_e187, _e205, (_e187 < _e205));
                    let _e209 = select(_e194, _e207, (_e194 < _e207));
                    let _e211 = select(_e201, _e209, (_e201 < _e209));
                    let _e215 = global_5.member[_e154].member_1;
                    let _e216 = bitcast<u32>(_e215);
                    let _e217 = (_e216 & 2147483647u);
                    let _e224 = global_5.member[_e154].member_3;
                    let _e225 = bitcast<u32>(_e224);
                    let _e226 = (_e225 & 2147483647u);
                    let _e230 = (((select(_e217, _e211, (_e217 < _e211)) < 2139095040u) && (_e226 <= 2139095040u)) && (_e205 > 0u));
                    if _e230 {
                        let _e233 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                        if (_e233 >= 8388608u) {
                            phi_508_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_508_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_508_;
                        phi_509_ = _e247;
                    } else {
                        phi_509_ = 0i;
                    }
                    let _e249 = phi_509_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_519_ = true;
                    } else {
                        phi_519_ = (_e173 == _e205);
                    }
                    let _e253 = phi_519_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_529_ = _e255;
                        phi_530_ = _e255;
                        phi_532_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_529_ = u32();
                        phi_530_ = 0u;
                        phi_532_ = true;
                    }
                    let _e259 = phi_529_;
                    let _e261 = phi_530_;
                    let _e263 = phi_532_;
                    if _e263 {
                        phi_537_ = (_e261 + 1u);
                    } else {
                        phi_537_ = 0u;
                    }
                    let _e267 = phi_537_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_550_ = -126i;
                    } else {
                        phi_550_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_550_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_570_ = -126i;
                    } else {
                        phi_570_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_570_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_5.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_588_ = _e306[0];
                    } else {
                        phi_588_ = _e306[1];
                    }
                    let _e311 = phi_588_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_594_ = _e306[2];
                    } else {
                        phi_594_ = _e311;
                    }
                    let _e315 = phi_594_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e279) * select(0.00000011920929f, 1f, _e318)) * _e285);
                    let _e333 = global_5.member[_e154].member_2;
                    if _e307 {
                        phi_634_ = _e333[0];
                    } else {
                        phi_634_ = _e333[1];
                    }
                    let _e337 = phi_634_;
                    if _e312 {
                        phi_640_ = _e333[2];
                    } else {
                        phi_640_ = _e337;
                    }
                    let _e340 = phi_640_;
                    let _e341 = bitcast<u32>(_e340);
                    let _e343 = ((_e341 & 2139095040u) != 0u);
                    let _e357 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e340, _e343) * _e296) * select(0.00000011920929f, 1f, _e343)) * _e302);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e364 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e365 = (_e364 * 0.00000011920929f);
                    let _e368 = select(select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f)), 0f, _e361);
                    let _e369 = select(0f, _e357, _e361);
                    let _e370 = (_e332 + _e368);
                    let _e371 = (_e332 - _e368);
                    let _e373 = select(38685626000000000000000000f, (1f / _e357), _e361);
                    let _e374 = (_e267 == 0u);
                    if _e374 {
                        phi_713_ = _e306[0];
                    } else {
                        phi_713_ = _e306[1];
                    }
                    let _e378 = phi_713_;
                    let _e379 = (_e267 == 2u);
                    if _e379 {
                        phi_719_ = _e306[2];
                    } else {
                        phi_719_ = _e378;
                    }
                    let _e382 = phi_719_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e279) * select(0.00000011920929f, 1f, _e385)) * _e285);
                    if _e374 {
                        phi_759_ = _e333[0];
                    } else {
                        phi_759_ = _e333[1];
                    }
                    let _e403 = phi_759_;
                    if _e379 {
                        phi_765_ = _e333[2];
                    } else {
                        phi_765_ = _e403;
                    }
                    let _e406 = phi_765_;
                    let _e407 = bitcast<u32>(_e406);
                    let _e409 = ((_e407 & 2139095040u) != 0u);
                    let _e423 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e407 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e407 & 2147483648u))), _e406, _e409) * _e296) * select(0.00000011920929f, 1f, _e409)) * _e302);
                    let _e427 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e430 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                    let _e431 = (_e430 * 0.00000011920929f);
                    let _e434 = select(select(0.00000000000011368684f, _e431, (_e431 > 0.00000000000011368684f)), 0f, _e427);
                    let _e435 = select(0f, _e423, _e427);
                    let _e436 = (_e399 + _e434);
                    let _e437 = (_e399 - _e434);
                    let _e439 = select(38685626000000000000000000f, (1f / _e423), _e427);
                    let _e440 = (_e269 == 0u);
                    if _e440 {
                        phi_838_ = _e306[0];
                    } else {
                        phi_838_ = _e306[1];
                    }
                    let _e444 = phi_838_;
                    let _e445 = (_e269 == 2u);
                    if _e445 {
                        phi_844_ = _e306[2];
                    } else {
                        phi_844_ = _e444;
                    }
                    let _e448 = phi_844_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e279) * select(0.00000011920929f, 1f, _e451)) * _e285);
                    if _e440 {
                        phi_884_ = _e333[0];
                    } else {
                        phi_884_ = _e333[1];
                    }
                    let _e469 = phi_884_;
                    if _e445 {
                        phi_890_ = _e333[2];
                    } else {
                        phi_890_ = _e469;
                    }
                    let _e472 = phi_890_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e296) * select(0.00000011920929f, 1f, _e475)) * _e302);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e496 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e497 = (_e496 * 0.00000011920929f);
                    let _e500 = select(select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f)), 0f, _e493);
                    let _e501 = select(0f, _e489, _e493);
                    let _e502 = (_e465 + _e500);
                    let _e503 = (_e465 - _e500);
                    let _e505 = select(38685626000000000000000000f, (1f / _e489), _e493);
                    let _e507 = select(_e430, _e364, (_e364 > _e430));
                    let _e510 = (_e136 + _e249);
                    if (_e230 && (select(_e496, _e507, (_e507 > _e496)) <= 1099511600000f)) {
                        let _e520 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e523 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e527 = (_e520 == 0u);
                        let _e530 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e520)), 32u, _e527)) - 8i);
                        if (_e523 == 255i) {
                            phi_1009_ = 255i;
                        } else {
                            phi_1009_ = (((_e523 + select(0i, 1i, (_e523 == 0i))) - _e530) + _e510);
                        }
                        let _e538 = phi_1009_;
                        let _e548 = (_e538 <= 0i);
                        if _e548 {
                            phi_1032_ = u32();
                        } else {
                            if _e527 {
                                phi_1031_ = u32();
                            } else {
                                phi_1031_ = select(((bitcast<u32>(_e538) << bitcast<u32>(23i)) | ((_e520 << bitcast<u32>(((_e530 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e538 >= 255i));
                            }
                            let _e552 = phi_1031_;
                            phi_1032_ = _e552;
                        }
                        let _e554 = phi_1032_;
                        let _e566 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e569 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                        let _e573 = (_e566 == 0u);
                        let _e576 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e566)), 32u, _e573)) - 8i);
                        if (_e569 == 255i) {
                            phi_1069_ = 255i;
                        } else {
                            phi_1069_ = (((_e569 + select(0i, 1i, (_e569 == 0i))) - _e576) + _e510);
                        }
                        let _e584 = phi_1069_;
                        let _e594 = (_e584 <= 0i);
                        if _e594 {
                            phi_1092_ = u32();
                        } else {
                            if _e573 {
                                phi_1091_ = u32();
                            } else {
                                phi_1091_ = select(((bitcast<u32>(_e584) << bitcast<u32>(23i)) | ((_e566 << bitcast<u32>(((_e576 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e584 >= 255i));
                            }
                            let _e598 = phi_1091_;
                            phi_1092_ = _e598;
                        }
                        let _e600 = phi_1092_;
                        phi_1100_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e600, 0u, select(_e573, true, _e594))));
                        phi_1101_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e554, 0u, select(_e527, true, _e548))));
                    } else {
                        phi_1100_ = 0f;
                        phi_1101_ = 1f;
                    }
                    let _e606 = phi_1100_;
                    let _e608 = phi_1101_;
                    local_9 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e613 = (_e268 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_1[_e613];
                    let _e619 = (_e267 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    let _e625 = (_e269 % 3u);
                    let _e626 = (_e625 < 3u);
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e628 = local_1[_e625];
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e613];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e619];
                    if _e626 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e625];
                    phi_4318_ = false;
                    phi_4245_ = _e606;
                    phi_1250_ = (_e608 <= _e606);
                    phi_1253_ = type_53(type_29(vec4<f32>((f32(_e616) * _e148), (f32(_e622) * _e148), (f32(_e628) * _e148), 0f), vec4<f32>((f32(_e633) * _e148), (f32(_e637) * _e148), (f32(_e641) * _e148), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_1255_ = 0u;
                    phi_1257_ = ((3u * _e98) + 1u);
                    loop {
                        let _e649 = phi_4318_;
                        let _e651 = phi_4245_;
                        let _e653 = phi_1250_;
                        let _e655 = phi_1253_;
                        let _e657 = phi_1255_;
                        let _e659 = phi_1257_;
                        if _e653 {
                            phi_1268_ = true;
                        } else {
                            phi_1268_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1268_;
                        if _e662 {
                            let _e663 = (_e659 > 0u);
                            if _e663 {
                                if _e653 {
                                    phi_1355_ = _e653;
                                    phi_1356_ = _e655;
                                    phi_1357_ = _e657;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4548_ = true;
                                        break;
                                    }
                                    let _e686 = local_10[_e665];
                                    phi_1355_ = (_e686 <= _e651);
                                    phi_1356_ = type_53(type_29(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                    phi_1357_ = _e664;
                                }
                                let _e689 = phi_1355_;
                                let _e691 = phi_1356_;
                                let _e693 = phi_1357_;
                                if _e689 {
                                    if ((_e691.member_1 & 2147483648u) != 0u) {
                                        phi_4315_ = _e649;
                                        phi_4304_ = _e651;
                                        phi_1375_ = type_4(0u, ((_e691.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1141 = phi_4315_;
                                            let _e1143 = phi_4304_;
                                            let _e1145 = phi_1375_;
                                            if (_e1145.member < _e1145.member_1) {
                                                phi_1376_ = type_4((_e1145.member + 1u), _e1145.member_1);
                                                phi_1399_ = type_4(1u, _e1145.member);
                                            } else {
                                                phi_1376_ = _e1145;
                                                phi_1399_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1158 = phi_1376_;
                                            let _e1160 = phi_1399_;
                                            let _e1164 = (bitcast<i32>(_e1160.member) != 0i);
                                            if _e1164 {
                                                let _e1165 = ((_e691.member_1 & 268435455u) + _e1160.member_1);
                                                let _e1166 = (_e1165 < _e100);
                                                if _e1166 {
                                                    if _e1166 {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1170 = global_2.member[_e1165].member_1;
                                                    phi_1420_ = _e1170;
                                                } else {
                                                    phi_1420_ = 4294967295u;
                                                }
                                                let _e1172 = phi_1420_;
                                                if (_e1165 >= _e100) {
                                                    phi_1512_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1166 {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    if (_e613 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1179 = global_2.member[_e1165].member[_e613];
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1185 = global_2.member[_e1165].member[_e619];
                                                    if (_e625 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1191 = global_2.member[_e1165].member[_e625];
                                                    let _e1193 = (3u + _e613);
                                                    if (_e1193 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1199 = global_2.member[_e1165].member[_e1193];
                                                    let _e1200 = (3u + _e619);
                                                    if (_e1200 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1206 = global_2.member[_e1165].member[_e1200];
                                                    let _e1207 = (3u + _e625);
                                                    if (_e1207 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1213 = global_2.member[_e1165].member[_e1207];
                                                    let _e1215 = (6u + _e613);
                                                    if (_e1215 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1221 = global_2.member[_e1165].member[_e1215];
                                                    let _e1222 = (6u + _e619);
                                                    if (_e1222 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1228 = global_2.member[_e1165].member[_e1222];
                                                    let _e1229 = (6u + _e625);
                                                    if (_e1229 < 9u) {
                                                    } else {
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = true;
                                                        break;
                                                    }
                                                    let _e1235 = global_2.member[_e1165].member[_e1229];
                                                    phi_1512_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1179, _e1185, _e1191), array<f32, 3>(_e1199, _e1206, _e1213), array<f32, 3>(_e1221, _e1228, _e1235));
                                                }
                                                let _e1239 = phi_1512_;
                                                let _e1254 = (_e1239[0][2] - _e465);
                                                let _e1257 = (((_e1239[0][0] - _e332) * _e501) - (_e1254 * _e369));
                                                let _e1260 = (((_e1239[0][1] - _e399) * _e501) - (_e1254 * _e435));
                                                let _e1263 = (_e1239[1][2] - _e465);
                                                let _e1266 = (((_e1239[1][0] - _e332) * _e501) - (_e1263 * _e369));
                                                let _e1269 = (((_e1239[1][1] - _e399) * _e501) - (_e1263 * _e435));
                                                let _e1272 = (_e1239[2][2] - _e465);
                                                let _e1275 = (((_e1239[2][0] - _e332) * _e501) - (_e1272 * _e369));
                                                let _e1278 = (((_e1239[2][1] - _e399) * _e501) - (_e1272 * _e435));
                                                let _e1279 = (_e1275 * _e1269);
                                                let _e1280 = (_e1278 * _e1266);
                                                let _e1281 = (_e1257 * _e1278);
                                                let _e1282 = (_e1260 * _e1275);
                                                let _e1283 = (_e1266 * _e1260);
                                                let _e1284 = (_e1269 * _e1257);
                                                let _e1289 = (((_e1279 >= _e1280) && (_e1281 >= _e1282)) && (_e1283 >= _e1284));
                                                let _e1295 = (_e1289 || (((_e1279 <= _e1280) && (_e1281 <= _e1282)) && (_e1283 <= _e1284)));
                                                if _e1295 {
                                                    let _e1297 = select(-1f, 1f, _e1289);
                                                    let _e1299 = ((_e1279 - _e1280) * _e1297);
                                                    let _e1301 = select(0f, _e1299, (_e1299 > 0f));
                                                    let _e1303 = ((_e1281 - _e1282) * _e1297);
                                                    let _e1305 = select(0f, _e1303, (_e1303 > 0f));
                                                    let _e1307 = ((_e1283 - _e1284) * _e1297);
                                                    let _e1309 = select(0f, _e1307, (_e1307 > 0f));
                                                    let _e1311 = ((_e1301 + _e1305) + _e1309);
                                                    let _e1313 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] < _e1239[1][0]));
                                                    let _e1317 = select(_e1239[1][0], _e1239[0][0], (_e1239[0][0] > _e1239[1][0]));
                                                    let _e1321 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] < _e1239[1][1]));
                                                    let _e1325 = select(_e1239[1][1], _e1239[0][1], (_e1239[0][1] > _e1239[1][1]));
                                                    let _e1329 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] < _e1239[1][2]));
                                                    let _e1333 = select(_e1239[1][2], _e1239[0][2], (_e1239[0][2] > _e1239[1][2]));
                                                    let _e1338 = ((select(_e1239[2][0], _e1313, (_e1313 < _e1239[2][0])) - _e370) * _e373);
                                                    let _e1339 = ((select(_e1239[2][0], _e1317, (_e1317 > _e1239[2][0])) - _e371) * _e373);
                                                    let _e1342 = ((select(_e1239[2][1], _e1321, (_e1321 < _e1239[2][1])) - _e436) * _e439);
                                                    let _e1343 = ((select(_e1239[2][1], _e1325, (_e1325 > _e1239[2][1])) - _e437) * _e439);
                                                    let _e1346 = ((select(_e1239[2][2], _e1329, (_e1329 < _e1239[2][2])) - _e502) * _e505);
                                                    let _e1347 = ((select(_e1239[2][2], _e1333, (_e1333 > _e1239[2][2])) - _e503) * _e505);
                                                    let _e1349 = select(_e1347, _e1346, (_e1346 < _e1347));
                                                    let _e1351 = select(_e1347, _e1346, (_e1346 > _e1347));
                                                    let _e1353 = select(_e1339, _e1338, (_e1338 < _e1339));
                                                    let _e1355 = select(_e1343, _e1342, (_e1342 < _e1343));
                                                    let _e1357 = select(_e1355, _e1353, (_e1353 > _e1355));
                                                    let _e1359 = select(_e1349, _e1357, (_e1357 > _e1349));
                                                    let _e1361 = select(_e1339, _e1338, (_e1338 > _e1339));
                                                    let _e1363 = select(_e1343, _e1342, (_e1342 > _e1343));
                                                    let _e1365 = select(_e1363, _e1361, (_e1361 < _e1363));
                                                    let _e1367 = select(_e1351, _e1365, (_e1365 < _e1351));
                                                    let _e1368 = -(_e1349);
                                                    let _e1374 = select(_e608, _e1359, (_e1359 > _e608));
                                                    let _e1378 = select(_e1266, _e1257, (_e1257 < _e1266));
                                                    let _e1383 = select(_e1266, _e1257, (_e1257 > _e1266));
                                                    let _e1390 = select(_e1269, _e1260, (_e1260 < _e1269));
                                                    let _e1395 = select(_e1269, _e1260, (_e1260 > _e1269));
                                                    let _e1404 = (((((_e1295 && (_e1311 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1275, _e1378, (_e1378 < _e1275)) <= 0f) && (select(_e1275, _e1383, (_e1383 > _e1275)) >= 0f))) && ((select(_e1278, _e1390, (_e1390 < _e1278)) <= 0f) && (select(_e1278, _e1395, (_e1395 > _e1278)) >= 0f))) && (_e1374 <= (_e1367 + (select(_e1368, _e1351, (_e1351 > _e1368)) * 0.0000019073523f)))) && (_e1374 <= _e1143));
                                                    if _e1404 {
                                                        let _e1409 = (_e1239[1][0] - _e1239[0][0]);
                                                        let _e1410 = (_e1239[1][1] - _e1239[0][1]);
                                                        let _e1411 = (_e1239[1][2] - _e1239[0][2]);
                                                        let _e1412 = vec3<f32>(_e1409, _e1410, _e1411);
                                                        let _e1413 = (_e1239[2][0] - _e1239[1][0]);
                                                        let _e1414 = (_e1239[2][1] - _e1239[1][1]);
                                                        let _e1415 = (_e1239[2][2] - _e1239[1][2]);
                                                        let _e1416 = vec3<f32>(_e1413, _e1414, _e1415);
                                                        let _e1417 = (_e1239[0][0] - _e1239[2][0]);
                                                        let _e1418 = (_e1239[0][1] - _e1239[2][1]);
                                                        let _e1419 = (_e1239[0][2] - _e1239[2][2]);
                                                        let _e1420 = vec3<f32>(_e1417, _e1418, _e1419);
                                                        let _e1423 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                        let _e1426 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                        let _e1428 = select(_e1426, _e1423, (_e1423 > _e1426));
                                                        let _e1431 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                        let _e1433 = select(_e1431, _e1428, (_e1428 > _e1431));
                                                        let _e1436 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                        let _e1439 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                        let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                        let _e1444 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                        let _e1446 = select(_e1444, _e1441, (_e1441 > _e1444));
                                                        let _e1449 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                        let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                        let _e1457 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                        let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                        let _e1461 = select(_e1446, _e1433, (_e1433 > _e1446));
                                                        let _e1463 = select(_e1459, _e1461, (_e1461 > _e1459));
                                                        if (_e1433 == _e1463) {
                                                            phi_2043_ = _e1269;
                                                            phi_2044_ = _e1266;
                                                            phi_2045_ = _e1260;
                                                            phi_2046_ = _e1257;
                                                            phi_2047_ = vec3<f32>(_e1239[0][0], _e1239[0][1], _e1239[0][2]);
                                                            phi_2048_ = _e1420;
                                                            phi_2049_ = _e1416;
                                                            phi_2050_ = _e1412;
                                                        } else {
                                                            let _e1465 = (_e1446 == _e1463);
                                                            let _e1470 = vec3(_e1465);
                                                            phi_2043_ = select(_e1260, _e1278, _e1465);
                                                            phi_2044_ = select(_e1257, _e1275, _e1465);
                                                            phi_2045_ = select(_e1278, _e1269, _e1465);
                                                            phi_2046_ = select(_e1275, _e1266, _e1465);
                                                            phi_2047_ = select(vec3<f32>(_e1239[2][0], _e1239[2][1], _e1239[2][2]), vec3<f32>(_e1239[1][0], _e1239[1][1], _e1239[1][2]), _e1470);
                                                            phi_2048_ = select(_e1416, _e1412, _e1470);
                                                            phi_2049_ = select(_e1412, _e1420, _e1470);
                                                            phi_2050_ = select(_e1420, _e1416, _e1470);
                                                        }
                                                        let _e1476 = phi_2043_;
                                                        let _e1478 = phi_2044_;
                                                        let _e1480 = phi_2045_;
                                                        let _e1482 = phi_2046_;
                                                        let _e1484 = phi_2047_;
                                                        let _e1486 = phi_2048_;
                                                        let _e1488 = phi_2049_;
                                                        let _e1490 = phi_2050_;
                                                        let _e1497 = ((_e1488.y * _e1486.z) - (_e1486.y * _e1488.z));
                                                        let _e1502 = ((_e1488.z * _e1486.x) - (_e1486.z * _e1488.x));
                                                        let _e1505 = ((_e1488.x * _e1486.y) - (_e1486.x * _e1488.y));
                                                        let _e1508 = ((_e1301 >= _e1305) && (_e1301 >= _e1309));
                                                        let _e1509 = (_e1305 >= _e1309);
                                                        let _e1523 = (((_e1497 * (select(select(_e1239[2][0], _e1239[1][0], _e1509), _e1239[0][0], _e1508) - _e332)) + (_e1502 * (select(select(_e1239[2][1], _e1239[1][1], _e1509), _e1239[0][1], _e1508) - _e399))) + (_e1505 * (select(select(_e1239[2][2], _e1239[1][2], _e1509), _e1239[0][2], _e1508) - _e465)));
                                                        let _e1528 = (((_e1497 * _e369) + (_e1502 * _e435)) + (_e1505 * _e501));
                                                        let _e1529 = (_e1478 - _e1482);
                                                        let _e1530 = (_e1476 - _e1480);
                                                        let _e1533 = ((_e1529 * _e1529) + (_e1530 * _e1530));
                                                        let _e1540 = (-(((_e1482 * _e1529) + (_e1480 * _e1530))) / select(0.000000000000000000000000000000000000011754944f, _e1533, (_e1533 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1542 = select(1f, _e1540, (_e1540 < 1f));
                                                        let _e1544 = select(0f, _e1542, (_e1542 > 0f));
                                                        let _e1553 = ((_e1484.x + (_e1490.x * _e1544)) - _e332);
                                                        let _e1556 = ((_e1484.y + (_e1490.y * _e1544)) - _e399);
                                                        let _e1559 = ((_e1484.z + (_e1490.z * _e1544)) - _e465);
                                                        let _e1562 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                        let _e1565 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                        let _e1567 = select(_e1565, _e1562, (_e1562 > _e1565));
                                                        let _e1570 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                        let _e1572 = select(_e1570, _e1567, (_e1567 > _e1570));
                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u));
                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1502) & 2147483647u));
                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u));
                                                        let _e1605 = bitcast<f32>((bitcast<u32>(_e1488.x) & 2147483647u));
                                                        let _e1608 = bitcast<f32>((bitcast<u32>(_e1488.y) & 2147483647u));
                                                        let _e1610 = select(_e1608, _e1605, (_e1605 > _e1608));
                                                        let _e1613 = bitcast<f32>((bitcast<u32>(_e1488.z) & 2147483647u));
                                                        let _e1619 = bitcast<f32>((bitcast<u32>(_e1486.x) & 2147483647u));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1486.y) & 2147483647u));
                                                        let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                        let _e1627 = bitcast<f32>((bitcast<u32>(_e1486.z) & 2147483647u));
                                                        let _e1633 = ((bitcast<f32>((bitcast<u32>(((((_e1497 * _e1553) + (_e1502 * _e1556)) + (_e1505 * _e1559)) - _e1523)) & 2147483647u)) <= ((0.0000009536743f * select(_e1463, _e1572, (_e1572 > _e1463))) * select(_e1586, _e1583, (_e1583 > _e1586)))) && !((bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u)) <= ((0.0000038146973f * select(_e1613, _e1610, (_e1610 > _e1613))) * select(_e1627, _e1624, (_e1624 > _e1627))))));
                                                        let _e1634 = (_e1523 / _e1528);
                                                        if (_e1404 && !(_e1633)) {
                                                            let _e1637 = (_e1559 / _e501);
                                                            let _e1645 = (((_e1497 * (_e1553 - (_e369 * _e1637))) + (_e1502 * (_e1556 - (_e435 * _e1637)))) / _e1528);
                                                            phi_2241_ = select(select(_e1637, (_e1637 + _e1645), (bitcast<f32>((bitcast<u32>(_e1645) & 2147483647u)) <= _e1463)), _e1634, _e1633);
                                                        } else {
                                                            phi_2241_ = _e1634;
                                                        }
                                                        let _e1654 = phi_2241_;
                                                        let _e1656 = select(_e1367, _e1654, (_e1654 < _e1367));
                                                        let _e1658 = select(_e1359, _e1656, (_e1656 > _e1359));
                                                        let _e1659 = (1f / _e1311);
                                                        phi_2261_ = type_36(_e1658, (_e1305 * _e1659), (_e1309 * _e1659), ((_e1404 && (_e1658 >= _e608)) && (_e1658 <= _e1143)));
                                                        phi_2262_ = type_36();
                                                    } else {
                                                        phi_2261_ = type_36();
                                                        phi_2262_ = type_36(0f, 0f, 0f, _e1404);
                                                    }
                                                    let _e1668 = phi_2261_;
                                                    let _e1670 = phi_2262_;
                                                    phi_2265_ = _e1668;
                                                    phi_2266_ = _e1670;
                                                    phi_2267_ = select(true, false, _e1404);
                                                } else {
                                                    phi_2265_ = type_36();
                                                    phi_2266_ = type_36(0f, 0f, 0f, _e1295);
                                                    phi_2267_ = true;
                                                }
                                                let _e1673 = phi_2265_;
                                                let _e1675 = phi_2266_;
                                                let _e1677 = phi_2267_;
                                                if _e1677 {
                                                    phi_2271_ = _e1675;
                                                } else {
                                                    phi_2271_ = _e1673;
                                                }
                                                let _e1679 = phi_2271_;
                                                if _e1679.member_3 {
                                                    phi_2280_ = type_25(_e1679.member, _e1679.member_1, _e1679.member_2, _e1172);
                                                } else {
                                                    phi_2280_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1686 = phi_2280_;
                                                if (_e1686.member_3 != 4294967295u) {
                                                    if (_e1172 != 4294967295u) {
                                                        phi_2292_ = type_4(0u, 8u);
                                                        phi_2295_ = _e1686;
                                                        loop {
                                                            let _e1691 = phi_2292_;
                                                            let _e1693 = phi_2295_;
                                                            if (_e1691.member < _e1691.member_1) {
                                                                phi_2293_ = type_4((_e1691.member + 1u), _e1691.member_1);
                                                                phi_2318_ = type_4(1u, _e1691.member);
                                                            } else {
                                                                phi_2293_ = _e1691;
                                                                phi_2318_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1706 = phi_2293_;
                                                            let _e1708 = phi_2318_;
                                                            let _e1712 = (bitcast<i32>(_e1708.member) != 0i);
                                                            if _e1712 {
                                                                let _e1713 = (_e1708.member_1 < 8u);
                                                                if _e1713 {
                                                                } else {
                                                                    phi_4305_ = true;
                                                                    break;
                                                                }
                                                                let _e1718 = local_9[_e1708.member_1].member;
                                                                if (_e1693.member < _e1718) {
                                                                    phi_2351_ = true;
                                                                } else {
                                                                    let _e1720 = local_9[_e1708.member_1].member;
                                                                    if (_e1693.member == _e1720) {
                                                                        let _e1725 = local_9[_e1708.member_1].member_3;
                                                                        phi_2350_ = (_e1693.member_3 < _e1725);
                                                                    } else {
                                                                        phi_2350_ = false;
                                                                    }
                                                                    let _e1728 = phi_2350_;
                                                                    phi_2351_ = _e1728;
                                                                }
                                                                let _e1730 = phi_2351_;
                                                                if _e1730 {
                                                                    if _e1713 {
                                                                    } else {
                                                                        phi_4305_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1731 = local_9[_e1708.member_1];
                                                                    local_9[_e1708.member_1] = type_25(_e1693.member, _e1693.member_1, _e1693.member_2, _e1693.member_3);
                                                                    phi_2372_ = type_25(_e1731.member, _e1731.member_1, _e1731.member_2, _e1731.member_3);
                                                                } else {
                                                                    phi_2372_ = _e1693;
                                                                }
                                                                let _e1742 = phi_2372_;
                                                                phi_2296_ = _e1742;
                                                            } else {
                                                                phi_2296_ = type_25();
                                                            }
                                                            let _e1744 = phi_2296_;
                                                            continue;
                                                            continuing {
                                                                phi_2292_ = _e1706;
                                                                phi_2295_ = _e1744;
                                                                phi_4305_ = _e1141;
                                                                break if !(_e1712);
                                                            }
                                                        }
                                                        let _e1747 = phi_4305_;
                                                        phi_4463_ = _e1143;
                                                        phi_4458_ = _e1747;
                                                        if _e1747 {
                                                            break;
                                                        }
                                                        let _e1750 = local_9[7u].member_3;
                                                        if (_e1750 != 4294967295u) {
                                                            let _e1754 = local_9[7u].member;
                                                            phi_4547_ = _e1754;
                                                        } else {
                                                            phi_4547_ = _e1143;
                                                        }
                                                        let _e1756 = phi_4547_;
                                                        phi_4546_ = _e1756;
                                                        phi_4461_ = _e1747;
                                                    } else {
                                                        phi_4546_ = _e1143;
                                                        phi_4461_ = _e1141;
                                                    }
                                                    let _e1758 = phi_4546_;
                                                    let _e1760 = phi_4461_;
                                                    phi_4545_ = _e1758;
                                                    phi_4460_ = _e1760;
                                                } else {
                                                    phi_4545_ = _e1143;
                                                    phi_4460_ = _e1141;
                                                }
                                                let _e1762 = phi_4545_;
                                                let _e1764 = phi_4460_;
                                                phi_4544_ = _e1762;
                                                phi_4459_ = _e1764;
                                            } else {
                                                phi_4544_ = _e1143;
                                                phi_4459_ = _e1141;
                                            }
                                            let _e1766 = phi_4544_;
                                            let _e1768 = phi_4459_;
                                            continue;
                                            continuing {
                                                phi_4315_ = _e1768;
                                                phi_4304_ = _e1766;
                                                phi_1375_ = _e1158;
                                                phi_4463_ = _e1766;
                                                phi_4458_ = _e1768;
                                                break if !(_e1164);
                                            }
                                        }
                                        let _e1771 = phi_4463_;
                                        let _e1773 = phi_4458_;
                                        phi_4548_ = _e1773;
                                        if _e1773 {
                                            break;
                                        }
                                        phi_4662_ = _e1771;
                                        phi_4552_ = _e1773;
                                        phi_3612_ = false;
                                        phi_3613_ = _e691;
                                        phi_3614_ = select(_e693, 0u, (_e608 > _e1771));
                                    } else {
                                        if (_e691.member_1 >= _e98) {
                                            phi_3150_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e691.member_1 < _e98) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e705 = ((1u + _e268) % 4u);
                                            if (_e705 < 4u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e710 = global_4.member[_e691.member_1][_e705];
                                            let _e712 = (_e710 >> bitcast<u32>(11u));
                                            let _e714 = ((1u + _e267) % 4u);
                                            if (_e714 < 4u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e719 = global_4.member[_e691.member_1][_e714];
                                            let _e721 = (_e719 >> bitcast<u32>(11u));
                                            let _e723 = ((1u + _e269) % 4u);
                                            if (_e723 < 4u) {
                                            } else {
                                                phi_4548_ = true;
                                                break;
                                            }
                                            let _e728 = global_4.member[_e691.member_1][_e723];
                                            let _e730 = (_e728 >> bitcast<u32>(11u));
                                            let _e753 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.x - _e691.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e754 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.y - _e691.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e755 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.z - _e691.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e757 = select(_e148, _e753, (_e753 > _e148));
                                            let _e759 = select(_e148, _e754, (_e754 > _e148));
                                            let _e761 = select(_e148, _e755, (_e755 > _e148));
                                            let _e792 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e710 & 1023u))) - 8388608f) * _e757));
                                            let _e797 = (bitcast<i32>((_e710 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                            let _e801 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e759));
                                            let _e806 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                            let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e761));
                                            let _e815 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                            let _e822 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                            let _e826 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                            let _e830 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                            let _e831 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e712 & 1023u))) - 8388608f) * _e757));
                                            let _e836 = (bitcast<i32>((_e712 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e839 = bitcast<f32>((_e831 & bitcast<u32>(_e836)));
                                            let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e721 & 1023u))) - 8388608f) * _e759));
                                            let _e845 = (bitcast<i32>((_e721 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                            let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e761));
                                            let _e854 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                            let _e861 = bitcast<f32>((_e831 & bitcast<u32>(~(_e836))));
                                            let _e865 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                            let _e869 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                            let _e899 = global_4.member[_e691.member_1][0u];
                                            let _e903 = global_4.member[_e691.member_1][1u];
                                            let _e907 = global_4.member[_e691.member_1][2u];
                                            let _e911 = global_4.member[_e691.member_1][3u];
                                            let _e923 = (((_e903 >> bitcast<u32>(22i)) | ((_e907 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e911 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e924 = (_e899 & 268435455u);
                                            let _e925 = (_e923 & 268435455u);
                                            let _e928 = ((_e899 >> bitcast<u32>(28u)) & 7u);
                                            let _e936 = ((_e899 >> bitcast<u32>(31i)) | (((_e923 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e937 = (_e928 != 0u);
                                            if (_e928 == 0u) {
                                                phi_3112_ = _e924;
                                            } else {
                                                if (_e928 == 7u) {
                                                    phi_3111_ = 2147483648u;
                                                } else {
                                                    phi_3111_ = ((2147483648u | (_e928 << bitcast<u32>(28u))) | (_e925 & 268435455u));
                                                }
                                                let _e946 = phi_3111_;
                                                phi_3112_ = _e946;
                                            }
                                            let _e948 = phi_3112_;
                                            if _e937 {
                                                let _e949 = (_e928 != 7u);
                                                if _e949 {
                                                    phi_3122_ = (_e925 + _e928);
                                                } else {
                                                    phi_3122_ = u32();
                                                }
                                                let _e952 = phi_3122_;
                                                phi_3124_ = _e952;
                                                phi_3125_ = select(true, false, _e949);
                                            } else {
                                                phi_3124_ = u32();
                                                phi_3125_ = true;
                                            }
                                            let _e955 = phi_3124_;
                                            let _e957 = phi_3125_;
                                            if (_e936 == 0u) {
                                                phi_3146_ = (_e924 + select(0u, 1u, !(_e937)));
                                            } else {
                                                if (_e936 == 7u) {
                                                    phi_3145_ = 2147483648u;
                                                } else {
                                                    phi_3145_ = ((2147483648u | (_e936 << bitcast<u32>(28u))) | (select(_e955, _e925, _e957) & 268435455u));
                                                }
                                                let _e970 = phi_3145_;
                                                phi_3146_ = _e970;
                                            }
                                            let _e972 = phi_3146_;
                                            phi_3150_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e691.member.member.x + _e800), (_e691.member.member.x + _e822), (_e691.member.member_1.x - _e839), (_e691.member.member_1.x - _e861)), vec4<f32>((_e691.member.member.y + _e809), (_e691.member.member.y + _e826), (_e691.member.member_1.y - _e848), (_e691.member.member_1.y - _e865)), vec4<f32>((_e691.member.member.z + _e818), (_e691.member.member.z + _e830), (_e691.member.member_1.z - _e857), (_e691.member.member_1.z - _e869))), type_53(type_29((_e691.member.member + vec4<f32>(_e800, _e809, _e818, 0f)), (_e691.member.member_1 - vec4<f32>(_e839, _e848, _e857, 0f))), _e948), type_53(type_29((_e691.member.member + vec4<f32>(_e822, _e826, _e830, 0f)), (_e691.member.member_1 - vec4<f32>(_e861, _e865, _e869, 0f))), _e972));
                                        }
                                        let _e977 = phi_3150_;
                                        let _e988 = ((_e977.member[0].x - _e370) * _e373);
                                        let _e989 = ((_e977.member[0].y - _e370) * _e373);
                                        let _e990 = ((_e977.member[0].z - _e371) * _e373);
                                        let _e991 = ((_e977.member[0].w - _e371) * _e373);
                                        let _e1001 = ((_e977.member[1].x - _e436) * _e439);
                                        let _e1002 = ((_e977.member[1].y - _e436) * _e439);
                                        let _e1003 = ((_e977.member[1].z - _e437) * _e439);
                                        let _e1004 = ((_e977.member[1].w - _e437) * _e439);
                                        let _e1014 = ((_e977.member[2].x - _e502) * _e505);
                                        let _e1015 = ((_e977.member[2].y - _e502) * _e505);
                                        let _e1016 = ((_e977.member[2].z - _e503) * _e505);
                                        let _e1017 = ((_e977.member[2].w - _e503) * _e505);
                                        let _e1019 = select(_e1016, _e1014, (_e1014 < _e1016));
                                        let _e1021 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1023 = select(_e1016, _e1014, (_e1014 > _e1016));
                                        let _e1025 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1027 = select(_e990, _e988, (_e988 < _e990));
                                        let _e1029 = select(_e991, _e989, (_e989 < _e991));
                                        let _e1031 = select(_e1003, _e1001, (_e1001 < _e1003));
                                        let _e1033 = select(_e1004, _e1002, (_e1002 < _e1004));
                                        let _e1035 = select(_e1031, _e1027, (_e1027 > _e1031));
                                        let _e1037 = select(_e1033, _e1029, (_e1029 > _e1033));
                                        let _e1039 = select(_e1019, _e1035, (_e1035 > _e1019));
                                        let _e1041 = select(_e1021, _e1037, (_e1037 > _e1021));
                                        let _e1043 = select(_e990, _e988, (_e988 > _e990));
                                        let _e1045 = select(_e991, _e989, (_e989 > _e991));
                                        let _e1047 = select(_e1003, _e1001, (_e1001 > _e1003));
                                        let _e1049 = select(_e1004, _e1002, (_e1002 > _e1004));
                                        let _e1051 = select(_e1047, _e1043, (_e1043 < _e1047));
                                        let _e1053 = select(_e1049, _e1045, (_e1045 < _e1049));
                                        let _e1058 = -(_e1019);
                                        let _e1059 = -(_e1021);
                                        let _e1066 = (select(_e1023, _e1051, (_e1051 < _e1023)) + (select(_e1058, _e1023, (_e1023 > _e1058)) * 0.0000019073523f));
                                        let _e1067 = (select(_e1025, _e1053, (_e1053 < _e1025)) + (select(_e1059, _e1025, (_e1025 > _e1059)) * 0.0000019073523f));
                                        let _e1069 = select(_e608, _e1039, (_e1039 > _e608));
                                        let _e1071 = select(_e608, _e1041, (_e1041 > _e608));
                                        let _e1076 = (_e1069 <= select(_e651, _e1066, (_e1066 < _e651)));
                                        let _e1077 = (_e1071 <= select(_e651, _e1067, (_e1067 < _e651)));
                                        let _e1078 = (_e1069 <= _e1071);
                                        if _e1076 {
                                            if _e1077 {
                                                if _e1078 {
                                                    phi_3513_ = _e977.member_2;
                                                } else {
                                                    phi_3513_ = _e977.member_1;
                                                }
                                                let _e1082 = phi_3513_;
                                                let _e1103 = (_e693 % 128u);
                                                let _e1104 = (_e1103 < 128u);
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_8[_e1103] = _e1082.member_1;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_7[_e1103] = _e1082.member.member.x;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_6[_e1103] = _e1082.member.member.y;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_5[_e1103] = _e1082.member.member.z;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_4[_e1103] = _e1082.member.member_1.x;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_3[_e1103] = _e1082.member.member_1.y;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_2[_e1103] = _e1082.member.member_1.z;
                                                if _e1104 {
                                                } else {
                                                    phi_4548_ = true;
                                                    break;
                                                }
                                                local_10[_e1103] = select(_e1069, _e1071, _e1078);
                                                if _e1078 {
                                                    phi_3589_ = _e977.member_1;
                                                } else {
                                                    phi_3589_ = _e977.member_2;
                                                }
                                                let _e1117 = phi_3589_;
                                                phi_3590_ = _e1117;
                                                phi_3591_ = (_e693 + 1u);
                                            } else {
                                                phi_3590_ = type_53();
                                                phi_3591_ = u32();
                                            }
                                            let _e1119 = phi_3590_;
                                            let _e1121 = phi_3591_;
                                            phi_3593_ = _e1119;
                                            phi_3594_ = _e1121;
                                            phi_3595_ = select(true, false, _e1077);
                                        } else {
                                            phi_3593_ = type_53();
                                            phi_3594_ = u32();
                                            phi_3595_ = true;
                                        }
                                        let _e1124 = phi_3593_;
                                        let _e1126 = phi_3594_;
                                        let _e1128 = phi_3595_;
                                        if _e1128 {
                                            if _e1076 {
                                                phi_3604_ = _e977.member_1;
                                            } else {
                                                phi_3604_ = _e977.member_2;
                                            }
                                            let _e1132 = phi_3604_;
                                            phi_3609_ = select(_e1077, true, _e1076);
                                            phi_3610_ = _e1132;
                                        } else {
                                            phi_3609_ = _e689;
                                            phi_3610_ = _e1124;
                                        }
                                        let _e1135 = phi_3609_;
                                        let _e1137 = phi_3610_;
                                        phi_4662_ = _e651;
                                        phi_4552_ = _e649;
                                        phi_3612_ = _e1135;
                                        phi_3613_ = _e1137;
                                        phi_3614_ = select(_e1126, _e693, _e1128);
                                    }
                                    let _e1777 = phi_4662_;
                                    let _e1779 = phi_4552_;
                                    let _e1781 = phi_3612_;
                                    let _e1783 = phi_3613_;
                                    let _e1785 = phi_3614_;
                                    phi_4661_ = _e1777;
                                    phi_4551_ = _e1779;
                                    phi_3615_ = _e1781;
                                    phi_3616_ = _e1783;
                                    phi_3617_ = _e1785;
                                    phi_3618_ = (_e659 - 1u);
                                } else {
                                    phi_4661_ = _e651;
                                    phi_4551_ = _e649;
                                    phi_3615_ = _e689;
                                    phi_3616_ = _e691;
                                    phi_3617_ = _e693;
                                    phi_3618_ = _e659;
                                }
                                let _e1787 = phi_4661_;
                                let _e1789 = phi_4551_;
                                let _e1791 = phi_3615_;
                                let _e1793 = phi_3616_;
                                let _e1795 = phi_3617_;
                                let _e1797 = phi_3618_;
                                phi_4660_ = _e1787;
                                phi_4550_ = _e1789;
                                phi_3619_ = _e1791;
                                phi_3620_ = _e1793;
                                phi_3621_ = _e1795;
                                phi_3622_ = _e1797;
                            } else {
                                phi_4660_ = _e651;
                                phi_4550_ = _e649;
                                phi_3619_ = bool();
                                phi_3620_ = type_53();
                                phi_3621_ = u32();
                                phi_3622_ = u32();
                            }
                            let _e1799 = phi_4660_;
                            let _e1801 = phi_4550_;
                            let _e1803 = phi_3619_;
                            let _e1805 = phi_3620_;
                            let _e1807 = phi_3621_;
                            let _e1809 = phi_3622_;
                            phi_4659_ = _e1799;
                            phi_4549_ = _e1801;
                            phi_1251_ = _e1803;
                            phi_1254_ = _e1805;
                            phi_1256_ = _e1807;
                            phi_1258_ = _e1809;
                            phi_3623_ = _e663;
                        } else {
                            phi_4659_ = _e651;
                            phi_4549_ = _e649;
                            phi_1251_ = bool();
                            phi_1254_ = type_53();
                            phi_1256_ = u32();
                            phi_1258_ = u32();
                            phi_3623_ = false;
                        }
                        let _e1811 = phi_4659_;
                        let _e1813 = phi_4549_;
                        let _e1815 = phi_1251_;
                        let _e1817 = phi_1254_;
                        let _e1819 = phi_1256_;
                        let _e1821 = phi_1258_;
                        let _e1823 = phi_3623_;
                        continue;
                        continuing {
                            phi_4318_ = _e1813;
                            phi_4245_ = _e1811;
                            phi_1250_ = _e1815;
                            phi_1253_ = _e1817;
                            phi_1255_ = _e1819;
                            phi_1257_ = _e1821;
                            phi_4548_ = _e1813;
                            break if !(_e1823);
                        }
                    }
                    let _e1826 = phi_4548_;
                    if _e1826 {
                        break;
                    }
                    phi_3630_ = type_4(0u, 8u);
                    loop {
                        let _e1828 = phi_3630_;
                        if (_e1828.member < _e1828.member_1) {
                            phi_3631_ = type_4((_e1828.member + 1u), _e1828.member_1);
                            phi_3654_ = type_4(1u, _e1828.member);
                        } else {
                            phi_3631_ = _e1828;
                            phi_3654_ = type_4(0u, type_4().member_1);
                        }
                        let _e1841 = phi_3631_;
                        let _e1843 = phi_3654_;
                        let _e1847 = (bitcast<i32>(_e1843.member) != 0i);
                        if _e1847 {
                            let _e1848 = (_e1843.member_1 < 8u);
                            if _e1848 {
                            } else {
                                phi_4641_ = true;
                                break;
                            }
                            let _e1850 = local_9[_e1843.member_1];
                            if (_e1850.member_3 != 4294967295u) {
                                let _e1856 = -(_e510);
                                let _e1857 = bitcast<u32>(_e1850.member);
                                let _e1861 = (bitcast<i32>((_e1857 >> bitcast<u32>(23i))) & 255i);
                                let _e1862 = (_e1861 + _e1856);
                                if (_e1861 == 255i) {
                                    phi_3727_ = _e1850.member;
                                } else {
                                    if (_e1861 > 0i) {
                                        if (_e1862 > 0i) {
                                            let _e1866 = (_e1862 < 255i);
                                            if _e1866 {
                                                phi_3706_ = bitcast<f32>((_e1857 + bitcast<u32>((_e1856 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3706_ = f32();
                                            }
                                            let _e1873 = phi_3706_;
                                            phi_3708_ = _e1873;
                                            phi_3709_ = select(true, false, _e1866);
                                        } else {
                                            phi_3708_ = f32();
                                            phi_3709_ = true;
                                        }
                                        let _e1876 = phi_3708_;
                                        let _e1878 = phi_3709_;
                                        phi_3710_ = _e1876;
                                        phi_3711_ = _e1878;
                                    } else {
                                        phi_3710_ = f32();
                                        phi_3711_ = true;
                                    }
                                    let _e1880 = phi_3710_;
                                    let _e1882 = phi_3711_;
                                    if _e1882 {
                                        let _e1883 = (_e1857 & 2147483648u);
                                        let _e1890 = ((_e1857 & 8388607u) | (select(0u, 1u, ((_e1857 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1894 = (_e1890 == 0u);
                                        if _e1894 {
                                            phi_4192_ = bitcast<f32>(_e1883);
                                        } else {
                                            let _e1899 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1890)), 32u, _e1894) - 8u);
                                            let _e1902 = (_e1890 << bitcast<u32>((_e1899 & 31u)));
                                            let _e1904 = ((_e1862 + select(0i, 1i, (_e1861 == 0i))) - bitcast<i32>(_e1899));
                                            if (_e1904 >= 255i) {
                                                phi_4182_ = bitcast<f32>((_e1883 | 2139095040u));
                                                phi_4183_ = f32();
                                                phi_4184_ = true;
                                            } else {
                                                let _e1906 = (_e1904 > 0i);
                                                if _e1906 {
                                                    phi_4176_ = bitcast<f32>(((_e1883 | (bitcast<u32>(_e1904) << bitcast<u32>(23i))) | (_e1902 & 8388607u)));
                                                    phi_4177_ = f32();
                                                } else {
                                                    if (_e1904 < -24i) {
                                                        phi_4142_ = 26u;
                                                    } else {
                                                        phi_4142_ = bitcast<u32>((1i - _e1904));
                                                    }
                                                    let _e1911 = phi_4142_;
                                                    let _e1912 = (_e1911 & 31u);
                                                    let _e1914 = (_e1902 >> bitcast<u32>(_e1912));
                                                    let _e1918 = (_e1902 & ((1u << bitcast<u32>(_e1912)) - 1u));
                                                    let _e1922 = (1u << bitcast<u32>(((_e1911 - 1u) & 31u)));
                                                    if (_e1918 > _e1922) {
                                                        phi_4163_ = true;
                                                    } else {
                                                        if (_e1918 == _e1922) {
                                                            phi_4160_ = ((_e1914 & 1u) == 1u);
                                                        } else {
                                                            phi_4160_ = false;
                                                        }
                                                        let _e1928 = phi_4160_;
                                                        phi_4163_ = _e1928;
                                                    }
                                                    let _e1930 = phi_4163_;
                                                    phi_4176_ = f32();
                                                    phi_4177_ = bitcast<f32>((_e1883 | (_e1914 + select(0u, 1u, _e1930))));
                                                }
                                                let _e1943 = phi_4176_;
                                                let _e1945 = phi_4177_;
                                                phi_4182_ = _e1943;
                                                phi_4183_ = _e1945;
                                                phi_4184_ = _e1906;
                                            }
                                            let _e1949 = phi_4182_;
                                            let _e1951 = phi_4183_;
                                            let _e1953 = phi_4184_;
                                            phi_4192_ = select(_e1951, _e1949, _e1953);
                                        }
                                        let _e1957 = phi_4192_;
                                        phi_3726_ = _e1957;
                                    } else {
                                        phi_3726_ = _e1880;
                                    }
                                    let _e1959 = phi_3726_;
                                    phi_3727_ = _e1959;
                                }
                                let _e1961 = phi_3727_;
                                let _e1962 = bitcast<u32>(_e1961);
                                if ((_e1962 & 2147483647u) >= 2139095040u) {
                                    phi_3739_ = bitcast<f32>(((_e1962 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3739_ = _e1961;
                                }
                                let _e1969 = phi_3739_;
                                phi_3744_ = type_25(_e1969, _e1850.member_1, _e1850.member_2, _e1850.member_3);
                            } else {
                                phi_3744_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1972 = phi_3744_;
                            if _e1848 {
                            } else {
                                phi_4641_ = true;
                                break;
                            }
                            local_9[_e1843.member_1] = type_25(_e1972.member, _e1972.member_1, _e1972.member_2, _e1972.member_3);
                        }
                        continue;
                        continuing {
                            phi_3630_ = _e1841;
                            phi_4641_ = _e1826;
                            break if !(_e1847);
                        }
                    }
                    let _e1980 = phi_4641_;
                    if _e1980 {
                        break;
                    }
                    let _e1981 = local_9;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_6.member[_e154] = array<type_25, 8>(type_25(_e1981[0].member, _e1981[0].member_1, _e1981[0].member_2, _e1981[0].member_3), type_25(_e1981[1].member, _e1981[1].member_1, _e1981[1].member_2, _e1981[1].member_3), type_25(_e1981[2].member, _e1981[2].member_1, _e1981[2].member_2, _e1981[2].member_3), type_25(_e1981[3].member, _e1981[3].member_1, _e1981[3].member_2, _e1981[3].member_3), type_25(_e1981[4].member, _e1981[4].member_1, _e1981[4].member_2, _e1981[4].member_3), type_25(_e1981[5].member, _e1981[5].member_1, _e1981[5].member_2, _e1981[5].member_3), type_25(_e1981[6].member, _e1981[6].member_1, _e1981[6].member_2, _e1981[6].member_3), type_25(_e1981[7].member, _e1981[7].member_1, _e1981[7].member_2, _e1981[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
