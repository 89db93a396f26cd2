struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
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

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_32 {
    member: array<type_22>,
}

struct type_34 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_38 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_40 {
    member: array<type_38>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_45 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_51 {
    member: type_43,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_47;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_364_: i32;
    var phi_365_: i32;
    var phi_375_: bool;
    var phi_385_: u32;
    var phi_386_: u32;
    var phi_388_: bool;
    var phi_393_: u32;
    var phi_406_: i32;
    var phi_426_: i32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_569_: f32;
    var phi_575_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_694_: f32;
    var phi_700_: f32;
    var phi_740_: f32;
    var phi_746_: f32;
    var phi_865_: i32;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_925_: i32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_3611_: bool;
    var phi_1041_: type_34;
    var phi_1044_: u32;
    var phi_1046_: bool;
    var phi_1048_: u32;
    var phi_1050_: type_51;
    var phi_1061_: bool;
    var phi_1147_: bool;
    var phi_1148_: u32;
    var phi_1149_: type_51;
    var phi_1168_: type_34;
    var phi_1171_: type_4;
    var phi_1172_: type_4;
    var phi_1194_: type_4;
    var phi_1222_: u32;
    var phi_1238_: type_45;
    var phi_3406_: bool;
    var phi_3421_: bool;
    var phi_3436_: bool;
    var phi_3451_: bool;
    var phi_3466_: bool;
    var phi_3481_: bool;
    var phi_2045_: f32;
    var phi_2046_: f32;
    var phi_2047_: f32;
    var phi_2048_: f32;
    var phi_2049_: vec3<f32>;
    var phi_2050_: vec3<f32>;
    var phi_2051_: vec3<f32>;
    var phi_2052_: vec3<f32>;
    var phi_3496_: bool;
    var phi_3511_: bool;
    var phi_3526_: bool;
    var phi_3541_: bool;
    var phi_3556_: bool;
    var phi_3571_: bool;
    var phi_2260_: f32;
    var phi_2280_: type_30;
    var phi_2281_: type_30;
    var phi_2284_: type_30;
    var phi_2285_: type_30;
    var phi_2286_: bool;
    var phi_2290_: type_30;
    var phi_2299_: type_21;
    var phi_2324_: bool;
    var phi_2325_: bool;
    var phi_2332_: type_34;
    var phi_2333_: type_34;
    var phi_2334_: type_34;
    var phi_1169_: type_34;
    var phi_3605_: bool;
    var phi_3847_: bool;
    var phi_2335_: type_34;
    var phi_2356_: type_38;
    var phi_3245_: type_51;
    var phi_3321_: type_51;
    var phi_3322_: u32;
    var phi_3323_: type_51;
    var phi_3325_: u32;
    var phi_3326_: type_51;
    var phi_3327_: bool;
    var phi_3334_: type_51;
    var phi_3339_: bool;
    var phi_3341_: type_51;
    var phi_3346_: type_34;
    var phi_3347_: bool;
    var phi_3348_: u32;
    var phi_3349_: type_51;
    var phi_3357_: type_34;
    var phi_3360_: type_51;
    var phi_3791_: bool;
    var phi_3361_: type_34;
    var phi_3362_: u32;
    var phi_3363_: bool;
    var phi_3364_: u32;
    var phi_3365_: type_51;
    var phi_3790_: bool;
    var phi_3366_: type_34;
    var phi_3367_: u32;
    var phi_3368_: bool;
    var phi_3369_: u32;
    var phi_3370_: type_51;
    var phi_3789_: bool;
    var phi_1042_: type_34;
    var phi_1045_: u32;
    var phi_1047_: bool;
    var phi_1049_: u32;
    var phi_1051_: type_51;
    var phi_3371_: bool;
    var phi_3788_: bool;
    var local_10: type_34;
    var local_11: type_34;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e81 = arrayLength((&global_4.member));
            let _e92 = global_2.member[0u][0u];
            let _e96 = global_2.member[0u][1u];
            let _e100 = global_2.member[0u][2u];
            let _e104 = global_2.member[1u][0u];
            let _e108 = global_2.member[1u][1u];
            let _e112 = global_2.member[1u][2u];
            let _e116 = global_2.member[1u][3u];
            let _e119 = global_1.member[0u];
            let _e120 = bitcast<i32>(_e119);
            let _e130 = (_e78.x + (_e78.y * 2097152u));
            let _e131 = (_e130 < arrayLength((&global_3.member)));
            if _e131 {
                let _e132 = (_e130 < arrayLength((&global_5.member)));
                if _e132 {
                    if _e131 {
                    } else {
                        break;
                    }
                    let _e140 = global_3.member[_e130].member_2[0u];
                    let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                    let _e147 = global_3.member[_e130].member_2[1u];
                    let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                    let _e154 = global_3.member[_e130].member_2[2u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e130].member[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e130].member[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e130].member[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e179 = select(_e149, _e142, (_e149 < _e142));
                    let _e181 = select(_e156, _e179, (_e156 < _e179));
                    let _e183 = select(_e163, _e181, (_e163 < _e181));
                    let _e185 = select(_e170, _e183, (_e170 < _e183));
                    let _e187 = select(_e177, _e185, (_e177 < _e185));
                    let _e191 = global_3.member[_e130].member_1;
                    let _e192 = bitcast<u32>(_e191);
                    let _e193 = (_e192 & 2147483647u);
                    let _e200 = global_3.member[_e130].member_3;
                    let _e201 = bitcast<u32>(_e200);
                    let _e202 = (_e201 & 2147483647u);
                    let _e206 = (((select(_e193, _e187, (_e193 < _e187)) < 2139095040u) && (_e202 <= 2139095040u)) && (_e181 > 0u));
                    if _e206 {
                        let _e209 = (bitcast<u32>(bitcast<f32>(_e181)) & 2147483647u);
                        if (_e209 >= 8388608u) {
                            phi_364_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_364_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_364_;
                        phi_365_ = _e223;
                    } else {
                        phi_365_ = 0i;
                    }
                    let _e225 = phi_365_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_375_ = true;
                    } else {
                        phi_375_ = (_e149 == _e181);
                    }
                    let _e229 = phi_375_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_385_ = _e231;
                        phi_386_ = _e231;
                        phi_388_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_385_ = u32();
                        phi_386_ = 0u;
                        phi_388_ = true;
                    }
                    let _e235 = phi_385_;
                    let _e237 = phi_386_;
                    let _e239 = phi_388_;
                    if _e239 {
                        phi_393_ = (_e237 + 1u);
                    } else {
                        phi_393_ = 0u;
                    }
                    let _e243 = phi_393_;
                    let _e244 = select(_e235, _e237, _e239);
                    let _e245 = select(_e230, select(2u, _e230, _e229), _e239);
                    if (_e120 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e250 = phi_406_;
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e120 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e225);
                    if (_e262 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e262, 127i, (_e262 > 127i));
                    }
                    let _e267 = phi_426_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e262 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = global_3.member[_e130].member;
                    let _e283 = (_e244 == 0u);
                    if _e283 {
                        phi_444_ = _e282[0];
                    } else {
                        phi_444_ = _e282[1];
                    }
                    let _e287 = phi_444_;
                    let _e288 = (_e244 == 2u);
                    if _e288 {
                        phi_450_ = _e282[2];
                    } else {
                        phi_450_ = _e287;
                    }
                    let _e291 = phi_450_;
                    let _e292 = bitcast<u32>(_e291);
                    let _e294 = ((_e292 & 2139095040u) != 0u);
                    let _e308 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e292 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e292 & 2147483648u))), _e291, _e294) * _e255) * select(0.00000011920929f, 1f, _e294)) * _e261);
                    let _e309 = global_3.member[_e130].member_2;
                    if _e283 {
                        phi_490_ = _e309[0];
                    } else {
                        phi_490_ = _e309[1];
                    }
                    let _e313 = phi_490_;
                    if _e288 {
                        phi_496_ = _e309[2];
                    } else {
                        phi_496_ = _e313;
                    }
                    let _e316 = phi_496_;
                    let _e317 = bitcast<u32>(_e316);
                    let _e319 = ((_e317 & 2139095040u) != 0u);
                    let _e333 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * _e272) * select(0.00000011920929f, 1f, _e319)) * _e278);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e340 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e341 = (_e340 * 0.00000011920929f);
                    let _e344 = select(select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f)), 0f, _e337);
                    let _e345 = select(0f, _e333, _e337);
                    let _e346 = (_e308 + _e344);
                    let _e347 = (_e308 - _e344);
                    let _e349 = select(38685626000000000000000000f, (1f / _e333), _e337);
                    let _e350 = (_e243 == 0u);
                    if _e350 {
                        phi_569_ = _e282[0];
                    } else {
                        phi_569_ = _e282[1];
                    }
                    let _e354 = phi_569_;
                    let _e355 = (_e243 == 2u);
                    if _e355 {
                        phi_575_ = _e282[2];
                    } else {
                        phi_575_ = _e354;
                    }
                    let _e358 = phi_575_;
                    let _e359 = bitcast<u32>(_e358);
                    let _e361 = ((_e359 & 2139095040u) != 0u);
                    let _e375 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e359 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e359 & 2147483648u))), _e358, _e361) * _e255) * select(0.00000011920929f, 1f, _e361)) * _e261);
                    if _e350 {
                        phi_615_ = _e309[0];
                    } else {
                        phi_615_ = _e309[1];
                    }
                    let _e379 = phi_615_;
                    if _e355 {
                        phi_621_ = _e309[2];
                    } else {
                        phi_621_ = _e379;
                    }
                    let _e382 = phi_621_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e272) * select(0.00000011920929f, 1f, _e385)) * _e278);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e406 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e407 = (_e406 * 0.00000011920929f);
                    let _e410 = select(select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f)), 0f, _e403);
                    let _e411 = select(0f, _e399, _e403);
                    let _e412 = (_e375 + _e410);
                    let _e413 = (_e375 - _e410);
                    let _e415 = select(38685626000000000000000000f, (1f / _e399), _e403);
                    let _e416 = (_e245 == 0u);
                    if _e416 {
                        phi_694_ = _e282[0];
                    } else {
                        phi_694_ = _e282[1];
                    }
                    let _e420 = phi_694_;
                    let _e421 = (_e245 == 2u);
                    if _e421 {
                        phi_700_ = _e282[2];
                    } else {
                        phi_700_ = _e420;
                    }
                    let _e424 = phi_700_;
                    let _e425 = bitcast<u32>(_e424);
                    let _e427 = ((_e425 & 2139095040u) != 0u);
                    let _e441 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e425 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e425 & 2147483648u))), _e424, _e427) * _e255) * select(0.00000011920929f, 1f, _e427)) * _e261);
                    if _e416 {
                        phi_740_ = _e309[0];
                    } else {
                        phi_740_ = _e309[1];
                    }
                    let _e445 = phi_740_;
                    if _e421 {
                        phi_746_ = _e309[2];
                    } else {
                        phi_746_ = _e445;
                    }
                    let _e448 = phi_746_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e272) * select(0.00000011920929f, 1f, _e451)) * _e278);
                    let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e472 = bitcast<f32>((bitcast<u32>(_e441) & 2147483647u));
                    let _e473 = (_e472 * 0.00000011920929f);
                    let _e476 = select(select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f)), 0f, _e469);
                    let _e477 = select(0f, _e465, _e469);
                    let _e478 = (_e441 + _e476);
                    let _e479 = (_e441 - _e476);
                    let _e481 = select(38685626000000000000000000f, (1f / _e465), _e469);
                    let _e483 = select(_e406, _e340, (_e340 > _e406));
                    let _e486 = (_e120 + _e225);
                    if (_e206 && (select(_e472, _e483, (_e483 > _e472)) <= 1099511600000f)) {
                        let _e496 = ((_e193 & 8388607u) | (select(0u, 1u, ((_e193 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e499 = bitcast<i32>((_e193 >> bitcast<u32>(23i)));
                        let _e503 = (_e496 == 0u);
                        let _e506 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e496)), 32u, _e503)) - 8i);
                        if (_e499 == 255i) {
                            phi_865_ = 255i;
                        } else {
                            phi_865_ = (((_e499 + select(0i, 1i, (_e499 == 0i))) - _e506) + _e486);
                        }
                        let _e514 = phi_865_;
                        let _e524 = (_e514 <= 0i);
                        if _e524 {
                            phi_888_ = u32();
                        } else {
                            if _e503 {
                                phi_887_ = u32();
                            } else {
                                phi_887_ = select(((bitcast<u32>(_e514) << bitcast<u32>(23i)) | ((_e496 << bitcast<u32>(((_e506 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e514 >= 255i));
                            }
                            let _e528 = phi_887_;
                            phi_888_ = _e528;
                        }
                        let _e530 = phi_888_;
                        let _e542 = ((_e202 & 8388607u) | (select(0u, 1u, ((_e202 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e545 = bitcast<i32>((_e202 >> bitcast<u32>(23i)));
                        let _e549 = (_e542 == 0u);
                        let _e552 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e542)), 32u, _e549)) - 8i);
                        if (_e545 == 255i) {
                            phi_925_ = 255i;
                        } else {
                            phi_925_ = (((_e545 + select(0i, 1i, (_e545 == 0i))) - _e552) + _e486);
                        }
                        let _e560 = phi_925_;
                        let _e570 = (_e560 <= 0i);
                        if _e570 {
                            phi_948_ = u32();
                        } else {
                            if _e549 {
                                phi_947_ = u32();
                            } else {
                                phi_947_ = select(((bitcast<u32>(_e560) << bitcast<u32>(23i)) | ((_e542 << bitcast<u32>(((_e552 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e560 >= 255i));
                            }
                            let _e574 = phi_947_;
                            phi_948_ = _e574;
                        }
                        let _e576 = phi_948_;
                        phi_956_ = bitcast<f32>(((_e201 & 2147483648u) | select(_e576, 0u, select(_e549, true, _e570))));
                        phi_957_ = bitcast<f32>(((_e192 & 2147483648u) | select(_e530, 0u, select(_e503, true, _e524))));
                    } else {
                        phi_956_ = 0f;
                        phi_957_ = 1f;
                    }
                    let _e582 = phi_956_;
                    let _e584 = phi_957_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e92), bitcast<f32>(_e96), bitcast<f32>(_e100));
                    let _e590 = (_e244 % 3u);
                    let _e591 = (_e590 < 3u);
                    if _e591 {
                    } else {
                        break;
                    }
                    let _e593 = local_9[_e590];
                    let _e594 = (_e243 % 3u);
                    let _e595 = (_e594 < 3u);
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e597 = local_9[_e594];
                    let _e598 = (_e245 % 3u);
                    let _e599 = (_e598 < 3u);
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e601 = local_9[_e598];
                    local_8 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                    if _e591 {
                    } else {
                        break;
                    }
                    let _e605 = local_8[_e590];
                    if _e595 {
                    } else {
                        break;
                    }
                    let _e607 = local_8[_e594];
                    if _e599 {
                    } else {
                        break;
                    }
                    let _e609 = local_8[_e598];
                    phi_3611_ = false;
                    phi_1041_ = type_34(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e582), 0u, 0u);
                    phi_1044_ = ((3u * _e81) + 1u);
                    phi_1046_ = (_e584 <= _e582);
                    phi_1048_ = 0u;
                    phi_1050_ = type_51(type_43(array<f32, 3>(_e593, _e597, _e601), array<f32, 3>(_e605, _e607, _e609)), select(0u, 2147483648u, (_e81 == 0u)));
                    loop {
                        let _e617 = phi_3611_;
                        let _e619 = phi_1041_;
                        let _e621 = phi_1044_;
                        let _e623 = phi_1046_;
                        let _e625 = phi_1048_;
                        let _e627 = phi_1050_;
                        local_10 = _e619;
                        local_11 = _e619;
                        if _e623 {
                            phi_1061_ = true;
                        } else {
                            phi_1061_ = (_e625 > 0u);
                        }
                        let _e630 = phi_1061_;
                        if _e630 {
                            let _e631 = (_e621 > 0u);
                            if _e631 {
                                if _e623 {
                                    phi_1147_ = _e623;
                                    phi_1148_ = _e625;
                                    phi_1149_ = _e627;
                                } else {
                                    let _e632 = (_e625 - 1u);
                                    let _e633 = (_e632 % 128u);
                                    let _e634 = (_e633 < 128u);
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e636 = local_6[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e638 = local_5[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e640 = local_4[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e642 = local_3[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e645 = local_2[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e647 = local_1[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e649 = local[_e633];
                                    if _e634 {
                                    } else {
                                        phi_3788_ = true;
                                        break;
                                    }
                                    let _e654 = local_7[_e633];
                                    phi_1147_ = (_e654 <= _e619.member.member_1);
                                    phi_1148_ = _e632;
                                    phi_1149_ = type_51(type_43(array<f32, 3>(_e638, _e640, _e642), array<f32, 3>(_e645, _e647, _e649)), _e636);
                                }
                                let _e659 = phi_1147_;
                                let _e661 = phi_1148_;
                                let _e663 = phi_1149_;
                                if _e659 {
                                    let _e667 = ((_e663.member_1 & 2147483648u) != 0u);
                                    if _e667 {
                                        phi_1168_ = _e619;
                                        phi_1171_ = type_4(0u, ((_e663.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e675 = phi_1168_;
                                            let _e677 = phi_1171_;
                                            local_12 = _e675;
                                            if (_e677.member < _e677.member_1) {
                                                phi_1172_ = type_4((_e677.member + 1u), _e677.member_1);
                                                phi_1194_ = type_4(1u, _e677.member);
                                            } else {
                                                phi_1172_ = _e677;
                                                phi_1194_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e690 = phi_1172_;
                                            let _e692 = phi_1194_;
                                            let _e696 = (bitcast<i32>(_e692.member) != 0i);
                                            if _e696 {
                                                let _e702 = type_34(_e675.member, _e675.member_1, (_e675.member_2 + 1u));
                                                let _e703 = ((_e663.member_1 & 268435455u) + _e692.member_1);
                                                let _e704 = (_e703 < arrayLength((&global_6.member)));
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_3605_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_6.member[_e703].member_1;
                                                    phi_1222_ = _e707;
                                                } else {
                                                    phi_1222_ = 4294967295u;
                                                }
                                                let _e709 = phi_1222_;
                                                if _e704 {
                                                    if _e704 {
                                                    } else {
                                                        phi_3605_ = true;
                                                        break;
                                                    }
                                                    let _e711 = global_6.member[_e703];
                                                    phi_1238_ = _e711;
                                                } else {
                                                    phi_1238_ = type_45(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e713 = phi_1238_;
                                                let _e725 = ((10u * _e244) & 31u);
                                                let _e728 = ((_e713.member[0] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e736 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e116));
                                                let _e741 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e728)) - 8388608f) * _e736)) ^ _e116)));
                                                let _e745 = select(select(_e663.member.member_1[0], _e741, (_e741 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e728 == 1023u));
                                                let _e747 = ((10u * _e243) & 31u);
                                                let _e750 = ((_e713.member[0] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e758 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e116));
                                                let _e763 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e750)) - 8388608f) * _e758)) ^ _e116)));
                                                let _e767 = select(select(_e663.member.member_1[1], _e763, (_e763 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e750 == 1023u));
                                                let _e769 = ((10u * _e245) & 31u);
                                                let _e772 = ((_e713.member[0] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e780 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e116));
                                                let _e785 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e772)) - 8388608f) * _e780)) ^ _e116)));
                                                let _e789 = select(select(_e663.member.member_1[2], _e785, (_e785 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e772 == 1023u));
                                                let _e793 = ((_e713.member[1] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e801 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e793)) - 8388608f) * _e736)) ^ _e116)));
                                                let _e805 = select(select(_e663.member.member_1[0], _e801, (_e801 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e793 == 1023u));
                                                let _e808 = ((_e713.member[1] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e816 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e808)) - 8388608f) * _e758)) ^ _e116)));
                                                let _e820 = select(select(_e663.member.member_1[1], _e816, (_e816 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e808 == 1023u));
                                                let _e823 = ((_e713.member[1] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e831 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e823)) - 8388608f) * _e780)) ^ _e116)));
                                                let _e835 = select(select(_e663.member.member_1[2], _e831, (_e831 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e823 == 1023u));
                                                let _e839 = ((_e713.member[2] >> bitcast<u32>(_e725)) & 1023u);
                                                let _e847 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e736)) ^ _e116)));
                                                let _e851 = select(select(_e663.member.member_1[0], _e847, (_e847 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e839 == 1023u));
                                                let _e854 = ((_e713.member[2] >> bitcast<u32>(_e747)) & 1023u);
                                                let _e862 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e758)) ^ _e116)));
                                                let _e866 = select(select(_e663.member.member_1[1], _e862, (_e862 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e854 == 1023u));
                                                let _e869 = ((_e713.member[2] >> bitcast<u32>(_e769)) & 1023u);
                                                let _e877 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e780)) ^ _e116)));
                                                let _e881 = select(select(_e663.member.member_1[2], _e877, (_e877 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e869 == 1023u));
                                                let _e886 = (_e789 - _e441);
                                                let _e889 = (((_e745 - _e308) * _e477) - (_e886 * _e345));
                                                let _e892 = (((_e767 - _e375) * _e477) - (_e886 * _e411));
                                                let _e895 = (_e835 - _e441);
                                                let _e898 = (((_e805 - _e308) * _e477) - (_e895 * _e345));
                                                let _e901 = (((_e820 - _e375) * _e477) - (_e895 * _e411));
                                                let _e904 = (_e881 - _e441);
                                                let _e907 = (((_e851 - _e308) * _e477) - (_e904 * _e345));
                                                let _e910 = (((_e866 - _e375) * _e477) - (_e904 * _e411));
                                                let _e911 = (_e907 * _e901);
                                                let _e912 = (_e910 * _e898);
                                                let _e913 = (_e889 * _e910);
                                                let _e914 = (_e892 * _e907);
                                                let _e915 = (_e898 * _e892);
                                                let _e916 = (_e901 * _e889);
                                                let _e921 = (((_e911 >= _e912) && (_e913 >= _e914)) && (_e915 >= _e916));
                                                let _e927 = (_e921 || (((_e911 <= _e912) && (_e913 <= _e914)) && (_e915 <= _e916)));
                                                if _e927 {
                                                    let _e929 = select(-1f, 1f, _e921);
                                                    let _e931 = ((_e911 - _e912) * _e929);
                                                    let _e933 = select(0f, _e931, (_e931 > 0f));
                                                    let _e935 = ((_e913 - _e914) * _e929);
                                                    let _e937 = select(0f, _e935, (_e935 > 0f));
                                                    let _e939 = ((_e915 - _e916) * _e929);
                                                    let _e941 = select(0f, _e939, (_e939 > 0f));
                                                    let _e943 = ((_e933 + _e937) + _e941);
                                                    let _e945 = select(_e805, _e745, (_e745 < _e805));
                                                    let _e949 = select(_e805, _e745, (_e745 > _e805));
                                                    let _e953 = select(_e820, _e767, (_e767 < _e820));
                                                    let _e957 = select(_e820, _e767, (_e767 > _e820));
                                                    let _e961 = select(_e835, _e789, (_e789 < _e835));
                                                    let _e965 = select(_e835, _e789, (_e789 > _e835));
                                                    let _e970 = ((select(_e851, _e945, (_e945 < _e851)) - _e346) * _e349);
                                                    let _e971 = ((select(_e851, _e949, (_e949 > _e851)) - _e347) * _e349);
                                                    let _e974 = ((select(_e866, _e953, (_e953 < _e866)) - _e412) * _e415);
                                                    let _e975 = ((select(_e866, _e957, (_e957 > _e866)) - _e413) * _e415);
                                                    let _e978 = ((select(_e881, _e961, (_e961 < _e881)) - _e478) * _e481);
                                                    let _e979 = ((select(_e881, _e965, (_e965 > _e881)) - _e479) * _e481);
                                                    let _e981 = select(_e979, _e978, (_e978 < _e979));
                                                    let _e983 = select(_e979, _e978, (_e978 > _e979));
                                                    let _e985 = select(_e971, _e970, (_e970 < _e971));
                                                    let _e987 = select(_e975, _e974, (_e974 < _e975));
                                                    let _e989 = select(_e987, _e985, (_e985 > _e987));
                                                    let _e991 = select(_e981, _e989, (_e989 > _e981));
                                                    let _e993 = select(_e971, _e970, (_e970 > _e971));
                                                    let _e995 = select(_e975, _e974, (_e974 > _e975));
                                                    let _e997 = select(_e995, _e993, (_e993 < _e995));
                                                    let _e999 = select(_e983, _e997, (_e997 < _e983));
                                                    let _e1000 = -(_e981);
                                                    let _e1006 = select(_e584, _e991, (_e991 > _e584));
                                                    let _e1010 = select(_e898, _e889, (_e889 < _e898));
                                                    let _e1015 = select(_e898, _e889, (_e889 > _e898));
                                                    let _e1022 = select(_e901, _e892, (_e892 < _e901));
                                                    let _e1027 = select(_e901, _e892, (_e892 > _e901));
                                                    let _e1036 = (((((_e927 && (_e943 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e907, _e1010, (_e1010 < _e907)) <= 0f) && (select(_e907, _e1015, (_e1015 > _e907)) >= 0f))) && ((select(_e910, _e1022, (_e1022 < _e910)) <= 0f) && (select(_e910, _e1027, (_e1027 > _e910)) >= 0f))) && (_e1006 <= (_e999 + (select(_e1000, _e983, (_e983 > _e1000)) * 0.0000019073523f)))) && (_e1006 <= _e675.member.member_1));
                                                    if _e1036 {
                                                        let _e1041 = (_e805 - _e745);
                                                        let _e1042 = (_e820 - _e767);
                                                        let _e1043 = (_e835 - _e789);
                                                        let _e1044 = vec3<f32>(_e1041, _e1042, _e1043);
                                                        let _e1045 = (_e851 - _e805);
                                                        let _e1046 = (_e866 - _e820);
                                                        let _e1047 = (_e881 - _e835);
                                                        let _e1048 = vec3<f32>(_e1045, _e1046, _e1047);
                                                        let _e1049 = (_e745 - _e851);
                                                        let _e1050 = (_e767 - _e866);
                                                        let _e1051 = (_e789 - _e881);
                                                        let _e1052 = vec3<f32>(_e1049, _e1050, _e1051);
                                                        let _e1053 = abs(_e1041);
                                                        let _e1054 = abs(_e1042);
                                                        if (_e1053 != _e1053) {
                                                            phi_3406_ = true;
                                                        } else {
                                                            phi_3406_ = (_e1054 >= _e1053);
                                                        }
                                                        let _e1058 = phi_3406_;
                                                        let _e1059 = select(_e1053, _e1054, _e1058);
                                                        let _e1060 = abs(_e1043);
                                                        if (_e1059 != _e1059) {
                                                            phi_3421_ = true;
                                                        } else {
                                                            phi_3421_ = (_e1060 >= _e1059);
                                                        }
                                                        let _e1064 = phi_3421_;
                                                        let _e1065 = select(_e1059, _e1060, _e1064);
                                                        let _e1066 = abs(_e1045);
                                                        let _e1067 = abs(_e1046);
                                                        if (_e1066 != _e1066) {
                                                            phi_3436_ = true;
                                                        } else {
                                                            phi_3436_ = (_e1067 >= _e1066);
                                                        }
                                                        let _e1071 = phi_3436_;
                                                        let _e1072 = select(_e1066, _e1067, _e1071);
                                                        let _e1073 = abs(_e1047);
                                                        if (_e1072 != _e1072) {
                                                            phi_3451_ = true;
                                                        } else {
                                                            phi_3451_ = (_e1073 >= _e1072);
                                                        }
                                                        let _e1077 = phi_3451_;
                                                        let _e1078 = select(_e1072, _e1073, _e1077);
                                                        let _e1079 = abs(_e1049);
                                                        let _e1080 = abs(_e1050);
                                                        if (_e1079 != _e1079) {
                                                            phi_3466_ = true;
                                                        } else {
                                                            phi_3466_ = (_e1080 >= _e1079);
                                                        }
                                                        let _e1084 = phi_3466_;
                                                        let _e1085 = select(_e1079, _e1080, _e1084);
                                                        let _e1086 = abs(_e1051);
                                                        if (_e1085 != _e1085) {
                                                            phi_3481_ = true;
                                                        } else {
                                                            phi_3481_ = (_e1086 >= _e1085);
                                                        }
                                                        let _e1090 = phi_3481_;
                                                        let _e1091 = select(_e1085, _e1086, _e1090);
                                                        let _e1093 = select(_e1078, _e1065, (_e1065 > _e1078));
                                                        let _e1095 = select(_e1091, _e1093, (_e1093 > _e1091));
                                                        if (_e1065 == _e1095) {
                                                            phi_2045_ = _e901;
                                                            phi_2046_ = _e898;
                                                            phi_2047_ = _e892;
                                                            phi_2048_ = _e889;
                                                            phi_2049_ = vec3<f32>(_e745, _e767, _e789);
                                                            phi_2050_ = _e1052;
                                                            phi_2051_ = _e1048;
                                                            phi_2052_ = _e1044;
                                                        } else {
                                                            let _e1097 = (_e1078 == _e1095);
                                                            let _e1102 = vec3(_e1097);
                                                            phi_2045_ = select(_e892, _e910, _e1097);
                                                            phi_2046_ = select(_e889, _e907, _e1097);
                                                            phi_2047_ = select(_e910, _e901, _e1097);
                                                            phi_2048_ = select(_e907, _e898, _e1097);
                                                            phi_2049_ = select(vec3<f32>(_e851, _e866, _e881), vec3<f32>(_e805, _e820, _e835), _e1102);
                                                            phi_2050_ = select(_e1048, _e1044, _e1102);
                                                            phi_2051_ = select(_e1044, _e1052, _e1102);
                                                            phi_2052_ = select(_e1052, _e1048, _e1102);
                                                        }
                                                        let _e1108 = phi_2045_;
                                                        let _e1110 = phi_2046_;
                                                        let _e1112 = phi_2047_;
                                                        let _e1114 = phi_2048_;
                                                        let _e1116 = phi_2049_;
                                                        let _e1118 = phi_2050_;
                                                        let _e1120 = phi_2051_;
                                                        let _e1122 = phi_2052_;
                                                        let _e1129 = ((_e1120.y * _e1118.z) - (_e1118.y * _e1120.z));
                                                        let _e1134 = ((_e1120.z * _e1118.x) - (_e1118.z * _e1120.x));
                                                        let _e1137 = ((_e1120.x * _e1118.y) - (_e1118.x * _e1120.y));
                                                        let _e1140 = ((_e933 >= _e937) && (_e933 >= _e941));
                                                        let _e1141 = (_e937 >= _e941);
                                                        let _e1155 = (((_e1129 * (select(select(_e851, _e805, _e1141), _e745, _e1140) - _e308)) + (_e1134 * (select(select(_e866, _e820, _e1141), _e767, _e1140) - _e375))) + (_e1137 * (select(select(_e881, _e835, _e1141), _e789, _e1140) - _e441)));
                                                        let _e1160 = (((_e1129 * _e345) + (_e1134 * _e411)) + (_e1137 * _e477));
                                                        let _e1161 = (_e1110 - _e1114);
                                                        let _e1162 = (_e1108 - _e1112);
                                                        let _e1165 = ((_e1161 * _e1161) + (_e1162 * _e1162));
                                                        let _e1172 = (-(((_e1114 * _e1161) + (_e1112 * _e1162))) / select(0.000000000000000000000000000000000000011754944f, _e1165, (_e1165 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1174 = select(1f, _e1172, (_e1172 < 1f));
                                                        let _e1176 = select(0f, _e1174, (_e1174 > 0f));
                                                        let _e1185 = ((_e1116.x + (_e1122.x * _e1176)) - _e308);
                                                        let _e1188 = ((_e1116.y + (_e1122.y * _e1176)) - _e375);
                                                        let _e1191 = ((_e1116.z + (_e1122.z * _e1176)) - _e441);
                                                        let _e1194 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                        let _e1197 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                        let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                        let _e1202 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                        let _e1204 = select(_e1202, _e1199, (_e1199 > _e1202));
                                                        let _e1208 = abs(_e1129);
                                                        let _e1209 = abs(_e1134);
                                                        if (_e1208 != _e1208) {
                                                            phi_3496_ = true;
                                                        } else {
                                                            phi_3496_ = (_e1209 >= _e1208);
                                                        }
                                                        let _e1213 = phi_3496_;
                                                        let _e1214 = select(_e1208, _e1209, _e1213);
                                                        let _e1215 = abs(_e1137);
                                                        if (_e1214 != _e1214) {
                                                            phi_3511_ = true;
                                                        } else {
                                                            phi_3511_ = (_e1215 >= _e1214);
                                                        }
                                                        let _e1219 = phi_3511_;
                                                        let _e1235 = abs(_e1120.x);
                                                        let _e1236 = abs(_e1120.y);
                                                        if (_e1235 != _e1235) {
                                                            phi_3526_ = true;
                                                        } else {
                                                            phi_3526_ = (_e1236 >= _e1235);
                                                        }
                                                        let _e1240 = phi_3526_;
                                                        let _e1241 = select(_e1235, _e1236, _e1240);
                                                        let _e1242 = abs(_e1120.z);
                                                        if (_e1241 != _e1241) {
                                                            phi_3541_ = true;
                                                        } else {
                                                            phi_3541_ = (_e1242 >= _e1241);
                                                        }
                                                        let _e1246 = phi_3541_;
                                                        let _e1249 = abs(_e1118.x);
                                                        let _e1250 = abs(_e1118.y);
                                                        if (_e1249 != _e1249) {
                                                            phi_3556_ = true;
                                                        } else {
                                                            phi_3556_ = (_e1250 >= _e1249);
                                                        }
                                                        let _e1254 = phi_3556_;
                                                        let _e1255 = select(_e1249, _e1250, _e1254);
                                                        let _e1256 = abs(_e1118.z);
                                                        if (_e1255 != _e1255) {
                                                            phi_3571_ = true;
                                                        } else {
                                                            phi_3571_ = (_e1256 >= _e1255);
                                                        }
                                                        let _e1260 = phi_3571_;
                                                        let _e1265 = ((bitcast<f32>((bitcast<u32>(((((_e1129 * _e1185) + (_e1134 * _e1188)) + (_e1137 * _e1191)) - _e1155)) & 2147483647u)) <= ((0.0000009536743f * select(_e1095, _e1204, (_e1204 > _e1095))) * select(_e1214, _e1215, _e1219))) && !((bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u)) <= ((0.0000038146973f * select(_e1241, _e1242, _e1246)) * select(_e1255, _e1256, _e1260)))));
                                                        let _e1266 = (_e1155 / _e1160);
                                                        if (_e1036 && !(_e1265)) {
                                                            let _e1269 = (_e1191 / _e477);
                                                            let _e1277 = (((_e1129 * (_e1185 - (_e345 * _e1269))) + (_e1134 * (_e1188 - (_e411 * _e1269)))) / _e1160);
                                                            phi_2260_ = select(select(_e1269, (_e1269 + _e1277), (bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u)) <= _e1095)), _e1266, _e1265);
                                                        } else {
                                                            phi_2260_ = _e1266;
                                                        }
                                                        let _e1286 = phi_2260_;
                                                        let _e1288 = select(_e999, _e1286, (_e1286 < _e999));
                                                        let _e1290 = select(_e991, _e1288, (_e1288 > _e991));
                                                        let _e1291 = (1f / _e943);
                                                        phi_2280_ = type_30(_e1290, (_e937 * _e1291), (_e941 * _e1291), ((_e1036 && (_e1290 >= _e584)) && (_e1290 <= _e675.member.member_1)));
                                                        phi_2281_ = type_30();
                                                    } else {
                                                        phi_2280_ = type_30();
                                                        phi_2281_ = type_30(0f, 0f, 0f, _e1036);
                                                    }
                                                    let _e1300 = phi_2280_;
                                                    let _e1302 = phi_2281_;
                                                    phi_2284_ = _e1300;
                                                    phi_2285_ = _e1302;
                                                    phi_2286_ = select(true, false, _e1036);
                                                } else {
                                                    phi_2284_ = type_30();
                                                    phi_2285_ = type_30(0f, 0f, 0f, _e927);
                                                    phi_2286_ = true;
                                                }
                                                let _e1305 = phi_2284_;
                                                let _e1307 = phi_2285_;
                                                let _e1309 = phi_2286_;
                                                if _e1309 {
                                                    phi_2290_ = _e1307;
                                                } else {
                                                    phi_2290_ = _e1305;
                                                }
                                                let _e1311 = phi_2290_;
                                                if _e1311.member_3 {
                                                    phi_2299_ = type_21(_e1311.member, _e1311.member_1, _e1311.member_2, _e709);
                                                } else {
                                                    phi_2299_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1318 = phi_2299_;
                                                if (_e1318.member_3 != 4294967295u) {
                                                    if (_e709 != 4294967295u) {
                                                        if (_e1318.member < _e675.member.member.member) {
                                                            phi_2325_ = true;
                                                        } else {
                                                            if (_e1318.member == _e675.member.member.member) {
                                                                phi_2324_ = (_e1318.member_3 < _e675.member.member.member_3);
                                                            } else {
                                                                phi_2324_ = false;
                                                            }
                                                            let _e1333 = phi_2324_;
                                                            phi_2325_ = _e1333;
                                                        }
                                                        let _e1335 = phi_2325_;
                                                        if _e1335 {
                                                            phi_2332_ = type_34(type_28(_e1318, _e1318.member), _e702.member_1, _e702.member_2);
                                                        } else {
                                                            phi_2332_ = _e702;
                                                        }
                                                        let _e1342 = phi_2332_;
                                                        phi_2333_ = _e1342;
                                                    } else {
                                                        phi_2333_ = _e702;
                                                    }
                                                    let _e1344 = phi_2333_;
                                                    phi_2334_ = _e1344;
                                                } else {
                                                    phi_2334_ = _e702;
                                                }
                                                let _e1346 = phi_2334_;
                                                phi_1169_ = _e1346;
                                            } else {
                                                phi_1169_ = type_34();
                                            }
                                            let _e1348 = phi_1169_;
                                            continue;
                                            continuing {
                                                phi_1168_ = _e1348;
                                                phi_1171_ = _e690;
                                                phi_3605_ = _e617;
                                                break if !(_e696);
                                            }
                                        }
                                        let _e1351 = phi_3605_;
                                        phi_3788_ = _e1351;
                                        if _e1351 {
                                            break;
                                        }
                                        phi_3847_ = _e1351;
                                        let _e1877 = local_12;
                                        phi_2335_ = _e1877;
                                    } else {
                                        phi_3847_ = _e617;
                                        phi_2335_ = _e619;
                                    }
                                    let _e1353 = phi_3847_;
                                    let _e1355 = phi_2335_;
                                    if _e667 {
                                        phi_3346_ = type_34();
                                        phi_3347_ = bool();
                                        phi_3348_ = u32();
                                        phi_3349_ = type_51();
                                    } else {
                                        let _e1356 = (_e663.member_1 < _e81);
                                        if _e1356 {
                                            if _e1356 {
                                            } else {
                                                phi_3788_ = true;
                                                break;
                                            }
                                            let _e1358 = global_4.member[_e663.member_1];
                                            phi_2356_ = _e1358;
                                        } else {
                                            phi_2356_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1360 = phi_2356_;
                                        let _e1375 = ((10u * _e244) & 31u);
                                        let _e1378 = ((_e1360.member[0] >> bitcast<u32>(_e1375)) & 1023u);
                                        let _e1386 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e116));
                                        let _e1391 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1378)) - 8388608f) * _e1386)) ^ _e116)));
                                        let _e1395 = select(select(_e663.member.member_1[0], _e1391, (_e1391 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1378 == 1023u));
                                        let _e1397 = ((10u * _e243) & 31u);
                                        let _e1400 = ((_e1360.member[0] >> bitcast<u32>(_e1397)) & 1023u);
                                        let _e1408 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e116));
                                        let _e1413 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1400)) - 8388608f) * _e1408)) ^ _e116)));
                                        let _e1417 = select(select(_e663.member.member_1[1], _e1413, (_e1413 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1400 == 1023u));
                                        let _e1419 = ((10u * _e245) & 31u);
                                        let _e1422 = ((_e1360.member[0] >> bitcast<u32>(_e1419)) & 1023u);
                                        let _e1430 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e116));
                                        let _e1435 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1422)) - 8388608f) * _e1430)) ^ _e116)));
                                        let _e1439 = select(select(_e663.member.member_1[2], _e1435, (_e1435 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1422 == 1023u));
                                        let _e1442 = ((_e1360.member[1] >> bitcast<u32>(_e1375)) & 1023u);
                                        let _e1450 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1442)) - 8388608f) * _e1386)) ^ _e116)));
                                        let _e1454 = select(select(_e663.member.member_1[0], _e1450, (_e1450 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1442 == 1023u));
                                        let _e1457 = ((_e1360.member[1] >> bitcast<u32>(_e1397)) & 1023u);
                                        let _e1465 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1457)) - 8388608f) * _e1408)) ^ _e116)));
                                        let _e1469 = select(select(_e663.member.member_1[1], _e1465, (_e1465 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1457 == 1023u));
                                        let _e1472 = ((_e1360.member[1] >> bitcast<u32>(_e1419)) & 1023u);
                                        let _e1480 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1472)) - 8388608f) * _e1430)) ^ _e116)));
                                        let _e1484 = select(select(_e663.member.member_1[2], _e1480, (_e1480 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1472 == 1023u));
                                        let _e1490 = ((_e1360.member_1[0] >> bitcast<u32>(_e1375)) & 1023u);
                                        let _e1498 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1490)) - 8388608f) * _e1386)) ^ _e116)));
                                        let _e1502 = select(select(_e663.member.member_1[0], _e1498, (_e1498 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1490 == 1023u));
                                        let _e1505 = ((_e1360.member_1[0] >> bitcast<u32>(_e1397)) & 1023u);
                                        let _e1513 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1505)) - 8388608f) * _e1408)) ^ _e116)));
                                        let _e1517 = select(select(_e663.member.member_1[1], _e1513, (_e1513 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1505 == 1023u));
                                        let _e1520 = ((_e1360.member_1[0] >> bitcast<u32>(_e1419)) & 1023u);
                                        let _e1528 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1520)) - 8388608f) * _e1430)) ^ _e116)));
                                        let _e1532 = select(select(_e663.member.member_1[2], _e1528, (_e1528 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1520 == 1023u));
                                        let _e1535 = ((_e1360.member_1[1] >> bitcast<u32>(_e1375)) & 1023u);
                                        let _e1543 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1535)) - 8388608f) * _e1386)) ^ _e116)));
                                        let _e1547 = select(select(_e663.member.member_1[0], _e1543, (_e1543 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1535 == 1023u));
                                        let _e1550 = ((_e1360.member_1[1] >> bitcast<u32>(_e1397)) & 1023u);
                                        let _e1558 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1550)) - 8388608f) * _e1408)) ^ _e116)));
                                        let _e1562 = select(select(_e663.member.member_1[1], _e1558, (_e1558 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1550 == 1023u));
                                        let _e1565 = ((_e1360.member_1[1] >> bitcast<u32>(_e1419)) & 1023u);
                                        let _e1573 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1565)) - 8388608f) * _e1430)) ^ _e116)));
                                        let _e1577 = select(select(_e663.member.member_1[2], _e1573, (_e1573 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1565 == 1023u));
                                        let _e1582 = type_51(type_43(array<f32, 3>(_e1395, _e1417, _e1439), array<f32, 3>(_e1454, _e1469, _e1484)), _e1360.member_2);
                                        let _e1587 = type_51(type_43(array<f32, 3>(_e1502, _e1517, _e1532), array<f32, 3>(_e1547, _e1562, _e1577)), _e1360.member_3);
                                        let _e1600 = ((_e1395 - _e346) * _e349);
                                        let _e1601 = ((_e1502 - _e346) * _e349);
                                        let _e1602 = ((_e1454 - _e347) * _e349);
                                        let _e1603 = ((_e1547 - _e347) * _e349);
                                        let _e1608 = ((_e1417 - _e412) * _e415);
                                        let _e1609 = ((_e1517 - _e412) * _e415);
                                        let _e1610 = ((_e1469 - _e413) * _e415);
                                        let _e1611 = ((_e1562 - _e413) * _e415);
                                        let _e1616 = ((_e1439 - _e478) * _e481);
                                        let _e1617 = ((_e1532 - _e478) * _e481);
                                        let _e1618 = ((_e1484 - _e479) * _e481);
                                        let _e1619 = ((_e1577 - _e479) * _e481);
                                        let _e1621 = select(_e1618, _e1616, (_e1616 < _e1618));
                                        let _e1623 = select(_e1619, _e1617, (_e1617 < _e1619));
                                        let _e1625 = select(_e1618, _e1616, (_e1616 > _e1618));
                                        let _e1627 = select(_e1619, _e1617, (_e1617 > _e1619));
                                        let _e1629 = select(_e1602, _e1600, (_e1600 < _e1602));
                                        let _e1631 = select(_e1603, _e1601, (_e1601 < _e1603));
                                        let _e1633 = select(_e1610, _e1608, (_e1608 < _e1610));
                                        let _e1635 = select(_e1611, _e1609, (_e1609 < _e1611));
                                        let _e1637 = select(_e1633, _e1629, (_e1629 > _e1633));
                                        let _e1639 = select(_e1635, _e1631, (_e1631 > _e1635));
                                        let _e1641 = select(_e1621, _e1637, (_e1637 > _e1621));
                                        let _e1643 = select(_e1623, _e1639, (_e1639 > _e1623));
                                        let _e1645 = select(_e1602, _e1600, (_e1600 > _e1602));
                                        let _e1647 = select(_e1603, _e1601, (_e1601 > _e1603));
                                        let _e1649 = select(_e1610, _e1608, (_e1608 > _e1610));
                                        let _e1651 = select(_e1611, _e1609, (_e1609 > _e1611));
                                        let _e1653 = select(_e1649, _e1645, (_e1645 < _e1649));
                                        let _e1655 = select(_e1651, _e1647, (_e1647 < _e1651));
                                        let _e1660 = -(_e1621);
                                        let _e1661 = -(_e1623);
                                        let _e1668 = (select(_e1625, _e1653, (_e1653 < _e1625)) + (select(_e1660, _e1625, (_e1625 > _e1660)) * 0.0000019073523f));
                                        let _e1669 = (select(_e1627, _e1655, (_e1655 < _e1627)) + (select(_e1661, _e1627, (_e1627 > _e1661)) * 0.0000019073523f));
                                        let _e1671 = select(_e584, _e1641, (_e1641 > _e584));
                                        let _e1673 = select(_e584, _e1643, (_e1643 > _e584));
                                        let _e1678 = (_e1671 <= select(_e1355.member.member_1, _e1668, (_e1668 < _e1355.member.member_1)));
                                        let _e1679 = (_e1673 <= select(_e1355.member.member_1, _e1669, (_e1669 < _e1355.member.member_1)));
                                        let _e1680 = (_e1671 <= _e1673);
                                        if _e1678 {
                                            if _e1679 {
                                                if _e1680 {
                                                    phi_3245_ = _e1587;
                                                } else {
                                                    phi_3245_ = _e1582;
                                                }
                                                let _e1682 = phi_3245_;
                                                let _e1689 = (_e661 % 128u);
                                                let _e1690 = (_e1689 < 128u);
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_6[_e1689] = _e1682.member_1;
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_5[_e1689] = _e1682.member.member[0];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_4[_e1689] = _e1682.member.member[1];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_3[_e1689] = _e1682.member.member[2];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_2[_e1689] = _e1682.member.member_1[0];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_1[_e1689] = _e1682.member.member_1[1];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local[_e1689] = _e1682.member.member_1[2];
                                                if _e1690 {
                                                } else {
                                                    phi_3788_ = true;
                                                    break;
                                                }
                                                local_7[_e1689] = select(_e1671, _e1673, _e1680);
                                                if _e1680 {
                                                    phi_3321_ = _e1582;
                                                } else {
                                                    phi_3321_ = _e1587;
                                                }
                                                let _e1707 = phi_3321_;
                                                phi_3322_ = (_e661 + 1u);
                                                phi_3323_ = _e1707;
                                            } else {
                                                phi_3322_ = u32();
                                                phi_3323_ = type_51();
                                            }
                                            let _e1709 = phi_3322_;
                                            let _e1711 = phi_3323_;
                                            phi_3325_ = _e1709;
                                            phi_3326_ = _e1711;
                                            phi_3327_ = select(true, false, _e1679);
                                        } else {
                                            phi_3325_ = u32();
                                            phi_3326_ = type_51();
                                            phi_3327_ = true;
                                        }
                                        let _e1714 = phi_3325_;
                                        let _e1716 = phi_3326_;
                                        let _e1718 = phi_3327_;
                                        if _e1718 {
                                            if _e1678 {
                                                phi_3334_ = _e1582;
                                            } else {
                                                phi_3334_ = _e1587;
                                            }
                                            let _e1720 = phi_3334_;
                                            phi_3339_ = select(_e1679, true, _e1678);
                                            phi_3341_ = _e1720;
                                        } else {
                                            phi_3339_ = _e659;
                                            phi_3341_ = _e1716;
                                        }
                                        let _e1723 = phi_3339_;
                                        let _e1725 = phi_3341_;
                                        phi_3346_ = type_34(_e1355.member, (_e1355.member_1 + 1u), _e1355.member_2);
                                        phi_3347_ = _e1723;
                                        phi_3348_ = select(_e1714, _e661, _e1718);
                                        phi_3349_ = _e1725;
                                    }
                                    let _e1728 = phi_3346_;
                                    let _e1730 = phi_3347_;
                                    let _e1732 = phi_3348_;
                                    let _e1734 = phi_3349_;
                                    if _e667 {
                                        phi_3357_ = _e1355;
                                        phi_3360_ = _e663;
                                    } else {
                                        phi_3357_ = _e1728;
                                        phi_3360_ = _e1734;
                                    }
                                    let _e1736 = phi_3357_;
                                    let _e1738 = phi_3360_;
                                    phi_3791_ = _e1353;
                                    phi_3361_ = _e1736;
                                    phi_3362_ = (_e621 - 1u);
                                    phi_3363_ = select(_e1730, false, _e667);
                                    phi_3364_ = select(_e1732, _e661, _e667);
                                    phi_3365_ = _e1738;
                                } else {
                                    phi_3791_ = _e617;
                                    phi_3361_ = _e619;
                                    phi_3362_ = _e621;
                                    phi_3363_ = _e659;
                                    phi_3364_ = _e661;
                                    phi_3365_ = _e663;
                                }
                                let _e1742 = phi_3791_;
                                let _e1744 = phi_3361_;
                                let _e1746 = phi_3362_;
                                let _e1748 = phi_3363_;
                                let _e1750 = phi_3364_;
                                let _e1752 = phi_3365_;
                                phi_3790_ = _e1742;
                                phi_3366_ = _e1744;
                                phi_3367_ = _e1746;
                                phi_3368_ = _e1748;
                                phi_3369_ = _e1750;
                                phi_3370_ = _e1752;
                            } else {
                                phi_3790_ = _e617;
                                phi_3366_ = type_34();
                                phi_3367_ = u32();
                                phi_3368_ = bool();
                                phi_3369_ = u32();
                                phi_3370_ = type_51();
                            }
                            let _e1754 = phi_3790_;
                            let _e1756 = phi_3366_;
                            let _e1758 = phi_3367_;
                            let _e1760 = phi_3368_;
                            let _e1762 = phi_3369_;
                            let _e1764 = phi_3370_;
                            phi_3789_ = _e1754;
                            phi_1042_ = _e1756;
                            phi_1045_ = _e1758;
                            phi_1047_ = _e1760;
                            phi_1049_ = _e1762;
                            phi_1051_ = _e1764;
                            phi_3371_ = _e631;
                        } else {
                            phi_3789_ = _e617;
                            phi_1042_ = type_34();
                            phi_1045_ = u32();
                            phi_1047_ = bool();
                            phi_1049_ = u32();
                            phi_1051_ = type_51();
                            phi_3371_ = false;
                        }
                        let _e1766 = phi_3789_;
                        let _e1768 = phi_1042_;
                        let _e1770 = phi_1045_;
                        let _e1772 = phi_1047_;
                        let _e1774 = phi_1049_;
                        let _e1776 = phi_1051_;
                        let _e1778 = phi_3371_;
                        continue;
                        continuing {
                            phi_3611_ = _e1766;
                            phi_1041_ = _e1768;
                            phi_1044_ = _e1770;
                            phi_1046_ = _e1772;
                            phi_1048_ = _e1774;
                            phi_1050_ = _e1776;
                            phi_3788_ = _e1766;
                            break if !(_e1778);
                        }
                    }
                    let _e1781 = phi_3788_;
                    if _e1781 {
                        break;
                    }
                    let _e1783 = local_10;
                    let _e1786 = local_11;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_5.member[_e130][0u] = _e1783.member_1;
                    global_5.member[_e130][1u] = _e1786.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
