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
    var phi_501_: i32;
    var phi_502_: i32;
    var phi_512_: bool;
    var phi_522_: u32;
    var phi_523_: u32;
    var phi_525_: bool;
    var phi_530_: u32;
    var phi_543_: i32;
    var phi_563_: i32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_627_: f32;
    var phi_633_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_752_: f32;
    var phi_758_: f32;
    var phi_831_: f32;
    var phi_837_: f32;
    var phi_877_: f32;
    var phi_883_: f32;
    var phi_1002_: i32;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1062_: i32;
    var phi_1084_: u32;
    var phi_1085_: u32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_4335_: bool;
    var phi_4315_: f32;
    var phi_1243_: u32;
    var phi_1246_: bool;
    var phi_1248_: u32;
    var phi_1250_: type_53;
    var phi_1261_: bool;
    var phi_1348_: bool;
    var phi_1349_: u32;
    var phi_1350_: type_53;
    var phi_4332_: bool;
    var phi_4320_: f32;
    var phi_1368_: type_4;
    var phi_1369_: type_4;
    var phi_1392_: type_4;
    var phi_1413_: u32;
    var phi_1505_: array<array<f32, 3>, 3>;
    var phi_3871_: bool;
    var phi_3886_: bool;
    var phi_3901_: bool;
    var phi_3916_: bool;
    var phi_3931_: bool;
    var phi_3946_: bool;
    var phi_2048_: f32;
    var phi_2049_: f32;
    var phi_2050_: f32;
    var phi_2051_: f32;
    var phi_2052_: vec3<f32>;
    var phi_2053_: vec3<f32>;
    var phi_2054_: vec3<f32>;
    var phi_2055_: vec3<f32>;
    var phi_3961_: bool;
    var phi_3976_: bool;
    var phi_3991_: bool;
    var phi_4006_: bool;
    var phi_4021_: bool;
    var phi_4036_: bool;
    var phi_2263_: f32;
    var phi_2283_: type_32;
    var phi_2284_: type_32;
    var phi_2287_: type_32;
    var phi_2288_: type_32;
    var phi_2289_: bool;
    var phi_2293_: type_32;
    var phi_2302_: type_21;
    var phi_2314_: type_4;
    var phi_2317_: type_21;
    var phi_2315_: type_4;
    var phi_2340_: type_4;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2394_: type_21;
    var phi_2318_: type_21;
    var phi_4322_: bool;
    var phi_4641_: f32;
    var phi_4640_: f32;
    var phi_4490_: bool;
    var phi_4639_: f32;
    var phi_4489_: bool;
    var phi_4638_: f32;
    var phi_4488_: bool;
    var phi_4545_: f32;
    var phi_4487_: bool;
    var phi_4729_: bool;
    var phi_4544_: f32;
    var phi_3132_: u32;
    var phi_3133_: u32;
    var phi_3143_: u32;
    var phi_3145_: u32;
    var phi_3146_: bool;
    var phi_3166_: u32;
    var phi_3167_: u32;
    var phi_3171_: type_54;
    var phi_3534_: type_53;
    var phi_3610_: type_53;
    var phi_3611_: u32;
    var phi_3612_: type_53;
    var phi_3614_: u32;
    var phi_3615_: type_53;
    var phi_3616_: bool;
    var phi_3625_: type_53;
    var phi_3630_: bool;
    var phi_3632_: type_53;
    var phi_3636_: bool;
    var phi_3637_: u32;
    var phi_3638_: type_53;
    var phi_3648_: type_53;
    var phi_4757_: f32;
    var phi_4646_: bool;
    var phi_3649_: u32;
    var phi_3650_: bool;
    var phi_3651_: u32;
    var phi_3652_: type_53;
    var phi_4756_: f32;
    var phi_4645_: bool;
    var phi_3653_: u32;
    var phi_3654_: bool;
    var phi_3655_: u32;
    var phi_3656_: type_53;
    var phi_4755_: f32;
    var phi_4644_: bool;
    var phi_1244_: u32;
    var phi_1247_: bool;
    var phi_1249_: u32;
    var phi_1251_: type_53;
    var phi_3657_: bool;
    var phi_4643_: bool;
    var phi_3664_: type_4;
    var phi_3665_: type_4;
    var phi_3688_: type_4;
    var phi_3740_: f32;
    var phi_3742_: f32;
    var phi_3743_: bool;
    var phi_3744_: f32;
    var phi_3745_: bool;
    var phi_4212_: u32;
    var phi_4230_: bool;
    var phi_4233_: bool;
    var phi_4246_: f32;
    var phi_4247_: f32;
    var phi_4252_: f32;
    var phi_4253_: f32;
    var phi_4254_: bool;
    var phi_4262_: f32;
    var phi_3760_: f32;
    var phi_3761_: f32;
    var phi_3773_: f32;
    var phi_3778_: type_21;
    var phi_4737_: bool;

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
                            phi_501_ = (bitcast<i32>((_e231 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e231)), 32u, (_e231 == 0u))));
                        }
                        let _e245 = phi_501_;
                        phi_502_ = _e245;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e247 = phi_502_;
                    let _e248 = (_e164 == _e203);
                    if _e248 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e171 == _e203);
                    }
                    let _e251 = phi_512_;
                    let _e252 = select(1u, 0u, _e248);
                    if _e251 {
                        let _e253 = (_e252 + 1u);
                        phi_522_ = _e253;
                        phi_523_ = _e253;
                        phi_525_ = select(true, false, (_e253 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e257 = phi_522_;
                    let _e259 = phi_523_;
                    let _e261 = phi_525_;
                    if _e261 {
                        phi_530_ = (_e259 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e265 = phi_530_;
                    let _e266 = select(_e257, _e259, _e261);
                    let _e267 = select(_e252, select(2u, _e252, _e251), _e261);
                    if (_e134 < -126i) {
                        phi_543_ = -126i;
                    } else {
                        phi_543_ = select(_e134, 127i, (_e134 > 127i));
                    }
                    let _e272 = phi_543_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e134 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = -(_e247);
                    if (_e284 < -126i) {
                        phi_563_ = -126i;
                    } else {
                        phi_563_ = select(_e284, 127i, (_e284 > 127i));
                    }
                    let _e289 = phi_563_;
                    let _e294 = bitcast<f32>((bitcast<u32>((_e289 + 127i)) << bitcast<u32>(23i)));
                    let _e300 = bitcast<f32>((bitcast<u32>(((_e284 - _e289) + 127i)) << bitcast<u32>(23i)));
                    let _e304 = global_4.member[_e152].member;
                    let _e305 = (_e266 == 0u);
                    if _e305 {
                        phi_581_ = _e304[0];
                    } else {
                        phi_581_ = _e304[1];
                    }
                    let _e309 = phi_581_;
                    let _e310 = (_e266 == 2u);
                    if _e310 {
                        phi_587_ = _e304[2];
                    } else {
                        phi_587_ = _e309;
                    }
                    let _e313 = phi_587_;
                    let _e314 = bitcast<u32>(_e313);
                    let _e316 = ((_e314 & 2139095040u) != 0u);
                    let _e330 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e314 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e314 & 2147483648u))), _e313, _e316) * _e277) * select(0.00000011920929f, 1f, _e316)) * _e283);
                    let _e331 = global_4.member[_e152].member_2;
                    if _e305 {
                        phi_627_ = _e331[0];
                    } else {
                        phi_627_ = _e331[1];
                    }
                    let _e335 = phi_627_;
                    if _e310 {
                        phi_633_ = _e331[2];
                    } else {
                        phi_633_ = _e335;
                    }
                    let _e338 = phi_633_;
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
                        phi_706_ = _e304[0];
                    } else {
                        phi_706_ = _e304[1];
                    }
                    let _e376 = phi_706_;
                    let _e377 = (_e265 == 2u);
                    if _e377 {
                        phi_712_ = _e304[2];
                    } else {
                        phi_712_ = _e376;
                    }
                    let _e380 = phi_712_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e277) * select(0.00000011920929f, 1f, _e383)) * _e283);
                    if _e372 {
                        phi_752_ = _e331[0];
                    } else {
                        phi_752_ = _e331[1];
                    }
                    let _e401 = phi_752_;
                    if _e377 {
                        phi_758_ = _e331[2];
                    } else {
                        phi_758_ = _e401;
                    }
                    let _e404 = phi_758_;
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
                        phi_831_ = _e304[0];
                    } else {
                        phi_831_ = _e304[1];
                    }
                    let _e442 = phi_831_;
                    let _e443 = (_e267 == 2u);
                    if _e443 {
                        phi_837_ = _e304[2];
                    } else {
                        phi_837_ = _e442;
                    }
                    let _e446 = phi_837_;
                    let _e447 = bitcast<u32>(_e446);
                    let _e449 = ((_e447 & 2139095040u) != 0u);
                    let _e463 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * _e277) * select(0.00000011920929f, 1f, _e449)) * _e283);
                    if _e438 {
                        phi_877_ = _e331[0];
                    } else {
                        phi_877_ = _e331[1];
                    }
                    let _e467 = phi_877_;
                    if _e443 {
                        phi_883_ = _e331[2];
                    } else {
                        phi_883_ = _e467;
                    }
                    let _e470 = phi_883_;
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
                            phi_1002_ = 255i;
                        } else {
                            phi_1002_ = (((_e521 + select(0i, 1i, (_e521 == 0i))) - _e528) + _e508);
                        }
                        let _e536 = phi_1002_;
                        let _e546 = (_e536 <= 0i);
                        if _e546 {
                            phi_1025_ = u32();
                        } else {
                            if _e525 {
                                phi_1024_ = u32();
                            } else {
                                phi_1024_ = select(((bitcast<u32>(_e536) << bitcast<u32>(23i)) | ((_e518 << bitcast<u32>(((_e528 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e536 >= 255i));
                            }
                            let _e550 = phi_1024_;
                            phi_1025_ = _e550;
                        }
                        let _e552 = phi_1025_;
                        let _e564 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e567 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                        let _e571 = (_e564 == 0u);
                        let _e574 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e564)), 32u, _e571)) - 8i);
                        if (_e567 == 255i) {
                            phi_1062_ = 255i;
                        } else {
                            phi_1062_ = (((_e567 + select(0i, 1i, (_e567 == 0i))) - _e574) + _e508);
                        }
                        let _e582 = phi_1062_;
                        let _e592 = (_e582 <= 0i);
                        if _e592 {
                            phi_1085_ = u32();
                        } else {
                            if _e571 {
                                phi_1084_ = u32();
                            } else {
                                phi_1084_ = select(((bitcast<u32>(_e582) << bitcast<u32>(23i)) | ((_e564 << bitcast<u32>(((_e574 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e582 >= 255i));
                            }
                            let _e596 = phi_1084_;
                            phi_1085_ = _e596;
                        }
                        let _e598 = phi_1085_;
                        phi_1093_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e598, 0u, select(_e571, true, _e592))));
                        phi_1094_ = bitcast<f32>(((_e214 & 2147483648u) | select(_e552, 0u, select(_e525, true, _e546))));
                    } else {
                        phi_1093_ = 0f;
                        phi_1094_ = 1f;
                    }
                    let _e604 = phi_1093_;
                    let _e606 = phi_1094_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e609 = (_e266 % 3u);
                    let _e610 = (_e609 < 3u);
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e612 = local_1[_e609];
                    let _e615 = (_e265 % 3u);
                    let _e616 = (_e615 < 3u);
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e618 = local_1[_e615];
                    let _e621 = (_e267 % 3u);
                    let _e622 = (_e621 < 3u);
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e624 = local_1[_e621];
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e629 = local[_e609];
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e615];
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e621];
                    phi_4335_ = false;
                    phi_4315_ = _e604;
                    phi_1243_ = ((3u * _e96) + 1u);
                    phi_1246_ = (_e606 <= _e604);
                    phi_1248_ = 0u;
                    phi_1250_ = type_53(type_25(vec4<f32>((f32(_e612) * _e146), (f32(_e618) * _e146), (f32(_e624) * _e146), 0f), vec4<f32>((f32(_e629) * _e146), (f32(_e633) * _e146), (f32(_e637) * _e146), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e647 = phi_4335_;
                        let _e649 = phi_4315_;
                        let _e651 = phi_1243_;
                        let _e653 = phi_1246_;
                        let _e655 = phi_1248_;
                        let _e657 = phi_1250_;
                        if _e653 {
                            phi_1261_ = true;
                        } else {
                            phi_1261_ = (_e655 > 0u);
                        }
                        let _e660 = phi_1261_;
                        if _e660 {
                            let _e661 = (_e651 > 0u);
                            if _e661 {
                                if _e653 {
                                    phi_1348_ = _e653;
                                    phi_1349_ = _e655;
                                    phi_1350_ = _e657;
                                } else {
                                    let _e662 = (_e655 - 1u);
                                    let _e663 = (_e662 % 128u);
                                    let _e664 = (_e663 < 128u);
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e666 = local_7[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e668 = local_6[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e670 = local_5[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e672 = local_4[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e674 = local_3[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e676 = local_2[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e681 = local_8[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4643_ = true;
                                        break;
                                    }
                                    let _e684 = local_10[_e663];
                                    phi_1348_ = (_e684 <= _e649);
                                    phi_1349_ = _e662;
                                    phi_1350_ = type_53(type_25(vec4<f32>(_e666, _e668, _e670, 0f), vec4<f32>(_e672, _e674, _e676, 0f)), _e681);
                                }
                                let _e687 = phi_1348_;
                                let _e689 = phi_1349_;
                                let _e691 = phi_1350_;
                                if _e687 {
                                    let _e695 = ((_e691.member_1 & 2147483648u) != 0u);
                                    if _e695 {
                                        phi_4332_ = _e647;
                                        phi_4320_ = _e649;
                                        phi_1368_ = type_4(0u, ((_e691.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e702 = phi_4332_;
                                            let _e704 = phi_4320_;
                                            let _e706 = phi_1368_;
                                            if (_e706.member < _e706.member_1) {
                                                phi_1369_ = type_4((_e706.member + 1u), _e706.member_1);
                                                phi_1392_ = type_4(1u, _e706.member);
                                            } else {
                                                phi_1369_ = _e706;
                                                phi_1392_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e719 = phi_1369_;
                                            let _e721 = phi_1392_;
                                            let _e725 = (bitcast<i32>(_e721.member) != 0i);
                                            if _e725 {
                                                let _e726 = ((_e691.member_1 & 268435455u) + _e721.member_1);
                                                let _e727 = (_e726 < _e98);
                                                if _e727 {
                                                    if _e727 {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e731 = global_2.member[_e726].member_1;
                                                    phi_1413_ = _e731;
                                                } else {
                                                    phi_1413_ = 4294967295u;
                                                }
                                                let _e733 = phi_1413_;
                                                if (_e726 >= _e98) {
                                                    phi_1505_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e727 {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    if (_e609 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e740 = global_2.member[_e726].member[_e609];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e746 = global_2.member[_e726].member[_e615];
                                                    if (_e621 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e752 = global_2.member[_e726].member[_e621];
                                                    let _e754 = (3u + _e609);
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e726].member[_e754];
                                                    let _e761 = (3u + _e615);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e726].member[_e761];
                                                    let _e768 = (3u + _e621);
                                                    if (_e768 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e774 = global_2.member[_e726].member[_e768];
                                                    let _e776 = (6u + _e609);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_2.member[_e726].member[_e776];
                                                    let _e783 = (6u + _e615);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e726].member[_e783];
                                                    let _e790 = (6u + _e621);
                                                    if (_e790 < 9u) {
                                                    } else {
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_2.member[_e726].member[_e790];
                                                    phi_1505_ = array<array<f32, 3>, 3>(array<f32, 3>(_e740, _e746, _e752), array<f32, 3>(_e760, _e767, _e774), array<f32, 3>(_e782, _e789, _e796));
                                                }
                                                let _e800 = phi_1505_;
                                                let _e815 = (_e800[0][2] - _e463);
                                                let _e818 = (((_e800[0][0] - _e330) * _e499) - (_e815 * _e367));
                                                let _e821 = (((_e800[0][1] - _e397) * _e499) - (_e815 * _e433));
                                                let _e824 = (_e800[1][2] - _e463);
                                                let _e827 = (((_e800[1][0] - _e330) * _e499) - (_e824 * _e367));
                                                let _e830 = (((_e800[1][1] - _e397) * _e499) - (_e824 * _e433));
                                                let _e833 = (_e800[2][2] - _e463);
                                                let _e836 = (((_e800[2][0] - _e330) * _e499) - (_e833 * _e367));
                                                let _e839 = (((_e800[2][1] - _e397) * _e499) - (_e833 * _e433));
                                                let _e840 = (_e836 * _e830);
                                                let _e841 = (_e839 * _e827);
                                                let _e842 = (_e818 * _e839);
                                                let _e843 = (_e821 * _e836);
                                                let _e844 = (_e827 * _e821);
                                                let _e845 = (_e830 * _e818);
                                                let _e850 = (((_e840 >= _e841) && (_e842 >= _e843)) && (_e844 >= _e845));
                                                let _e856 = (_e850 || (((_e840 <= _e841) && (_e842 <= _e843)) && (_e844 <= _e845)));
                                                if _e856 {
                                                    let _e858 = select(-1f, 1f, _e850);
                                                    let _e860 = ((_e840 - _e841) * _e858);
                                                    let _e862 = select(0f, _e860, (_e860 > 0f));
                                                    let _e864 = ((_e842 - _e843) * _e858);
                                                    let _e866 = select(0f, _e864, (_e864 > 0f));
                                                    let _e868 = ((_e844 - _e845) * _e858);
                                                    let _e870 = select(0f, _e868, (_e868 > 0f));
                                                    let _e872 = ((_e862 + _e866) + _e870);
                                                    let _e874 = select(_e800[1][0], _e800[0][0], (_e800[0][0] < _e800[1][0]));
                                                    let _e878 = select(_e800[1][0], _e800[0][0], (_e800[0][0] > _e800[1][0]));
                                                    let _e882 = select(_e800[1][1], _e800[0][1], (_e800[0][1] < _e800[1][1]));
                                                    let _e886 = select(_e800[1][1], _e800[0][1], (_e800[0][1] > _e800[1][1]));
                                                    let _e890 = select(_e800[1][2], _e800[0][2], (_e800[0][2] < _e800[1][2]));
                                                    let _e894 = select(_e800[1][2], _e800[0][2], (_e800[0][2] > _e800[1][2]));
                                                    let _e899 = ((select(_e800[2][0], _e874, (_e874 < _e800[2][0])) - _e368) * _e371);
                                                    let _e900 = ((select(_e800[2][0], _e878, (_e878 > _e800[2][0])) - _e369) * _e371);
                                                    let _e903 = ((select(_e800[2][1], _e882, (_e882 < _e800[2][1])) - _e434) * _e437);
                                                    let _e904 = ((select(_e800[2][1], _e886, (_e886 > _e800[2][1])) - _e435) * _e437);
                                                    let _e907 = ((select(_e800[2][2], _e890, (_e890 < _e800[2][2])) - _e500) * _e503);
                                                    let _e908 = ((select(_e800[2][2], _e894, (_e894 > _e800[2][2])) - _e501) * _e503);
                                                    let _e910 = select(_e908, _e907, (_e907 < _e908));
                                                    let _e912 = select(_e908, _e907, (_e907 > _e908));
                                                    let _e914 = select(_e900, _e899, (_e899 < _e900));
                                                    let _e916 = select(_e904, _e903, (_e903 < _e904));
                                                    let _e918 = select(_e916, _e914, (_e914 > _e916));
                                                    let _e920 = select(_e910, _e918, (_e918 > _e910));
                                                    let _e922 = select(_e900, _e899, (_e899 > _e900));
                                                    let _e924 = select(_e904, _e903, (_e903 > _e904));
                                                    let _e926 = select(_e924, _e922, (_e922 < _e924));
                                                    let _e928 = select(_e912, _e926, (_e926 < _e912));
                                                    let _e929 = -(_e910);
                                                    let _e935 = select(_e606, _e920, (_e920 > _e606));
                                                    let _e939 = select(_e827, _e818, (_e818 < _e827));
                                                    let _e944 = select(_e827, _e818, (_e818 > _e827));
                                                    let _e951 = select(_e830, _e821, (_e821 < _e830));
                                                    let _e956 = select(_e830, _e821, (_e821 > _e830));
                                                    let _e965 = (((((_e856 && (_e872 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e836, _e939, (_e939 < _e836)) <= 0f) && (select(_e836, _e944, (_e944 > _e836)) >= 0f))) && ((select(_e839, _e951, (_e951 < _e839)) <= 0f) && (select(_e839, _e956, (_e956 > _e839)) >= 0f))) && (_e935 <= (_e928 + (select(_e929, _e912, (_e912 > _e929)) * 0.0000019073523f)))) && (_e935 <= _e704));
                                                    if _e965 {
                                                        let _e970 = (_e800[1][0] - _e800[0][0]);
                                                        let _e971 = (_e800[1][1] - _e800[0][1]);
                                                        let _e972 = (_e800[1][2] - _e800[0][2]);
                                                        let _e973 = vec3<f32>(_e970, _e971, _e972);
                                                        let _e974 = (_e800[2][0] - _e800[1][0]);
                                                        let _e975 = (_e800[2][1] - _e800[1][1]);
                                                        let _e976 = (_e800[2][2] - _e800[1][2]);
                                                        let _e977 = vec3<f32>(_e974, _e975, _e976);
                                                        let _e978 = (_e800[0][0] - _e800[2][0]);
                                                        let _e979 = (_e800[0][1] - _e800[2][1]);
                                                        let _e980 = (_e800[0][2] - _e800[2][2]);
                                                        let _e981 = vec3<f32>(_e978, _e979, _e980);
                                                        let _e982 = abs(_e970);
                                                        let _e983 = abs(_e971);
                                                        if (_e982 != _e982) {
                                                            phi_3871_ = true;
                                                        } else {
                                                            phi_3871_ = (_e983 >= _e982);
                                                        }
                                                        let _e987 = phi_3871_;
                                                        let _e988 = select(_e982, _e983, _e987);
                                                        let _e989 = abs(_e972);
                                                        if (_e988 != _e988) {
                                                            phi_3886_ = true;
                                                        } else {
                                                            phi_3886_ = (_e989 >= _e988);
                                                        }
                                                        let _e993 = phi_3886_;
                                                        let _e994 = select(_e988, _e989, _e993);
                                                        let _e995 = abs(_e974);
                                                        let _e996 = abs(_e975);
                                                        if (_e995 != _e995) {
                                                            phi_3901_ = true;
                                                        } else {
                                                            phi_3901_ = (_e996 >= _e995);
                                                        }
                                                        let _e1000 = phi_3901_;
                                                        let _e1001 = select(_e995, _e996, _e1000);
                                                        let _e1002 = abs(_e976);
                                                        if (_e1001 != _e1001) {
                                                            phi_3916_ = true;
                                                        } else {
                                                            phi_3916_ = (_e1002 >= _e1001);
                                                        }
                                                        let _e1006 = phi_3916_;
                                                        let _e1007 = select(_e1001, _e1002, _e1006);
                                                        let _e1008 = abs(_e978);
                                                        let _e1009 = abs(_e979);
                                                        if (_e1008 != _e1008) {
                                                            phi_3931_ = true;
                                                        } else {
                                                            phi_3931_ = (_e1009 >= _e1008);
                                                        }
                                                        let _e1013 = phi_3931_;
                                                        let _e1014 = select(_e1008, _e1009, _e1013);
                                                        let _e1015 = abs(_e980);
                                                        if (_e1014 != _e1014) {
                                                            phi_3946_ = true;
                                                        } else {
                                                            phi_3946_ = (_e1015 >= _e1014);
                                                        }
                                                        let _e1019 = phi_3946_;
                                                        let _e1020 = select(_e1014, _e1015, _e1019);
                                                        let _e1022 = select(_e1007, _e994, (_e994 > _e1007));
                                                        let _e1024 = select(_e1020, _e1022, (_e1022 > _e1020));
                                                        if (_e994 == _e1024) {
                                                            phi_2048_ = _e830;
                                                            phi_2049_ = _e827;
                                                            phi_2050_ = _e821;
                                                            phi_2051_ = _e818;
                                                            phi_2052_ = vec3<f32>(_e800[0][0], _e800[0][1], _e800[0][2]);
                                                            phi_2053_ = _e981;
                                                            phi_2054_ = _e977;
                                                            phi_2055_ = _e973;
                                                        } else {
                                                            let _e1026 = (_e1007 == _e1024);
                                                            let _e1031 = vec3(_e1026);
                                                            phi_2048_ = select(_e821, _e839, _e1026);
                                                            phi_2049_ = select(_e818, _e836, _e1026);
                                                            phi_2050_ = select(_e839, _e830, _e1026);
                                                            phi_2051_ = select(_e836, _e827, _e1026);
                                                            phi_2052_ = select(vec3<f32>(_e800[2][0], _e800[2][1], _e800[2][2]), vec3<f32>(_e800[1][0], _e800[1][1], _e800[1][2]), _e1031);
                                                            phi_2053_ = select(_e977, _e973, _e1031);
                                                            phi_2054_ = select(_e973, _e981, _e1031);
                                                            phi_2055_ = select(_e981, _e977, _e1031);
                                                        }
                                                        let _e1037 = phi_2048_;
                                                        let _e1039 = phi_2049_;
                                                        let _e1041 = phi_2050_;
                                                        let _e1043 = phi_2051_;
                                                        let _e1045 = phi_2052_;
                                                        let _e1047 = phi_2053_;
                                                        let _e1049 = phi_2054_;
                                                        let _e1051 = phi_2055_;
                                                        let _e1058 = ((_e1049.y * _e1047.z) - (_e1047.y * _e1049.z));
                                                        let _e1063 = ((_e1049.z * _e1047.x) - (_e1047.z * _e1049.x));
                                                        let _e1066 = ((_e1049.x * _e1047.y) - (_e1047.x * _e1049.y));
                                                        let _e1069 = ((_e862 >= _e866) && (_e862 >= _e870));
                                                        let _e1070 = (_e866 >= _e870);
                                                        let _e1084 = (((_e1058 * (select(select(_e800[2][0], _e800[1][0], _e1070), _e800[0][0], _e1069) - _e330)) + (_e1063 * (select(select(_e800[2][1], _e800[1][1], _e1070), _e800[0][1], _e1069) - _e397))) + (_e1066 * (select(select(_e800[2][2], _e800[1][2], _e1070), _e800[0][2], _e1069) - _e463)));
                                                        let _e1089 = (((_e1058 * _e367) + (_e1063 * _e433)) + (_e1066 * _e499));
                                                        let _e1090 = (_e1039 - _e1043);
                                                        let _e1091 = (_e1037 - _e1041);
                                                        let _e1094 = ((_e1090 * _e1090) + (_e1091 * _e1091));
                                                        let _e1101 = (-(((_e1043 * _e1090) + (_e1041 * _e1091))) / select(0.000000000000000000000000000000000000011754944f, _e1094, (_e1094 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1103 = select(1f, _e1101, (_e1101 < 1f));
                                                        let _e1105 = select(0f, _e1103, (_e1103 > 0f));
                                                        let _e1114 = ((_e1045.x + (_e1051.x * _e1105)) - _e330);
                                                        let _e1117 = ((_e1045.y + (_e1051.y * _e1105)) - _e397);
                                                        let _e1120 = ((_e1045.z + (_e1051.z * _e1105)) - _e463);
                                                        let _e1123 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                        let _e1126 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                        let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                        let _e1131 = bitcast<f32>((bitcast<u32>(_e1120) & 2147483647u));
                                                        let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                                                        let _e1137 = abs(_e1058);
                                                        let _e1138 = abs(_e1063);
                                                        if (_e1137 != _e1137) {
                                                            phi_3961_ = true;
                                                        } else {
                                                            phi_3961_ = (_e1138 >= _e1137);
                                                        }
                                                        let _e1142 = phi_3961_;
                                                        let _e1143 = select(_e1137, _e1138, _e1142);
                                                        let _e1144 = abs(_e1066);
                                                        if (_e1143 != _e1143) {
                                                            phi_3976_ = true;
                                                        } else {
                                                            phi_3976_ = (_e1144 >= _e1143);
                                                        }
                                                        let _e1148 = phi_3976_;
                                                        let _e1164 = abs(_e1049.x);
                                                        let _e1165 = abs(_e1049.y);
                                                        if (_e1164 != _e1164) {
                                                            phi_3991_ = true;
                                                        } else {
                                                            phi_3991_ = (_e1165 >= _e1164);
                                                        }
                                                        let _e1169 = phi_3991_;
                                                        let _e1170 = select(_e1164, _e1165, _e1169);
                                                        let _e1171 = abs(_e1049.z);
                                                        if (_e1170 != _e1170) {
                                                            phi_4006_ = true;
                                                        } else {
                                                            phi_4006_ = (_e1171 >= _e1170);
                                                        }
                                                        let _e1175 = phi_4006_;
                                                        let _e1178 = abs(_e1047.x);
                                                        let _e1179 = abs(_e1047.y);
                                                        if (_e1178 != _e1178) {
                                                            phi_4021_ = true;
                                                        } else {
                                                            phi_4021_ = (_e1179 >= _e1178);
                                                        }
                                                        let _e1183 = phi_4021_;
                                                        let _e1184 = select(_e1178, _e1179, _e1183);
                                                        let _e1185 = abs(_e1047.z);
                                                        if (_e1184 != _e1184) {
                                                            phi_4036_ = true;
                                                        } else {
                                                            phi_4036_ = (_e1185 >= _e1184);
                                                        }
                                                        let _e1189 = phi_4036_;
                                                        let _e1194 = ((bitcast<f32>((bitcast<u32>(((((_e1058 * _e1114) + (_e1063 * _e1117)) + (_e1066 * _e1120)) - _e1084)) & 2147483647u)) <= ((0.0000009536743f * select(_e1024, _e1133, (_e1133 > _e1024))) * select(_e1143, _e1144, _e1148))) && !((bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)) <= ((0.0000038146973f * select(_e1170, _e1171, _e1175)) * select(_e1184, _e1185, _e1189)))));
                                                        let _e1195 = (_e1084 / _e1089);
                                                        if (_e965 && !(_e1194)) {
                                                            let _e1198 = (_e1120 / _e499);
                                                            let _e1206 = (((_e1058 * (_e1114 - (_e367 * _e1198))) + (_e1063 * (_e1117 - (_e433 * _e1198)))) / _e1089);
                                                            phi_2263_ = select(select(_e1198, (_e1198 + _e1206), (bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u)) <= _e1024)), _e1195, _e1194);
                                                        } else {
                                                            phi_2263_ = _e1195;
                                                        }
                                                        let _e1215 = phi_2263_;
                                                        let _e1217 = select(_e928, _e1215, (_e1215 < _e928));
                                                        let _e1219 = select(_e920, _e1217, (_e1217 > _e920));
                                                        let _e1220 = (1f / _e872);
                                                        phi_2283_ = type_32(_e1219, (_e866 * _e1220), (_e870 * _e1220), ((_e965 && (_e1219 >= _e606)) && (_e1219 <= _e704)));
                                                        phi_2284_ = type_32();
                                                    } else {
                                                        phi_2283_ = type_32();
                                                        phi_2284_ = type_32(0f, 0f, 0f, _e965);
                                                    }
                                                    let _e1229 = phi_2283_;
                                                    let _e1231 = phi_2284_;
                                                    phi_2287_ = _e1229;
                                                    phi_2288_ = _e1231;
                                                    phi_2289_ = select(true, false, _e965);
                                                } else {
                                                    phi_2287_ = type_32();
                                                    phi_2288_ = type_32(0f, 0f, 0f, _e856);
                                                    phi_2289_ = true;
                                                }
                                                let _e1234 = phi_2287_;
                                                let _e1236 = phi_2288_;
                                                let _e1238 = phi_2289_;
                                                if _e1238 {
                                                    phi_2293_ = _e1236;
                                                } else {
                                                    phi_2293_ = _e1234;
                                                }
                                                let _e1240 = phi_2293_;
                                                if _e1240.member_3 {
                                                    phi_2302_ = type_21(_e1240.member, _e1240.member_1, _e1240.member_2, _e733);
                                                } else {
                                                    phi_2302_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1247 = phi_2302_;
                                                if (_e1247.member_3 != 4294967295u) {
                                                    if (_e733 != 4294967295u) {
                                                        phi_2314_ = type_4(0u, 8u);
                                                        phi_2317_ = _e1247;
                                                        loop {
                                                            let _e1252 = phi_2314_;
                                                            let _e1254 = phi_2317_;
                                                            if (_e1252.member < _e1252.member_1) {
                                                                phi_2315_ = type_4((_e1252.member + 1u), _e1252.member_1);
                                                                phi_2340_ = type_4(1u, _e1252.member);
                                                            } else {
                                                                phi_2315_ = _e1252;
                                                                phi_2340_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1267 = phi_2315_;
                                                            let _e1269 = phi_2340_;
                                                            let _e1273 = (bitcast<i32>(_e1269.member) != 0i);
                                                            if _e1273 {
                                                                let _e1274 = (_e1269.member_1 < 8u);
                                                                if _e1274 {
                                                                } else {
                                                                    phi_4322_ = true;
                                                                    break;
                                                                }
                                                                let _e1279 = local_9[_e1269.member_1].member;
                                                                if (_e1254.member < _e1279) {
                                                                    phi_2373_ = true;
                                                                } else {
                                                                    let _e1281 = local_9[_e1269.member_1].member;
                                                                    if (_e1254.member == _e1281) {
                                                                        let _e1286 = local_9[_e1269.member_1].member_3;
                                                                        phi_2372_ = (_e1254.member_3 < _e1286);
                                                                    } else {
                                                                        phi_2372_ = false;
                                                                    }
                                                                    let _e1289 = phi_2372_;
                                                                    phi_2373_ = _e1289;
                                                                }
                                                                let _e1291 = phi_2373_;
                                                                if _e1291 {
                                                                    if _e1274 {
                                                                    } else {
                                                                        phi_4322_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1292 = local_9[_e1269.member_1];
                                                                    local_9[_e1269.member_1] = type_21(_e1254.member, _e1254.member_1, _e1254.member_2, _e1254.member_3);
                                                                    phi_2394_ = type_21(_e1292.member, _e1292.member_1, _e1292.member_2, _e1292.member_3);
                                                                } else {
                                                                    phi_2394_ = _e1254;
                                                                }
                                                                let _e1303 = phi_2394_;
                                                                phi_2318_ = _e1303;
                                                            } else {
                                                                phi_2318_ = type_21();
                                                            }
                                                            let _e1305 = phi_2318_;
                                                            continue;
                                                            continuing {
                                                                phi_2314_ = _e1267;
                                                                phi_2317_ = _e1305;
                                                                phi_4322_ = _e702;
                                                                break if !(_e1273);
                                                            }
                                                        }
                                                        let _e1308 = phi_4322_;
                                                        phi_4545_ = _e704;
                                                        phi_4487_ = _e1308;
                                                        if _e1308 {
                                                            break;
                                                        }
                                                        let _e1311 = local_9[7u].member_3;
                                                        if (_e1311 != 4294967295u) {
                                                            let _e1315 = local_9[7u].member;
                                                            phi_4641_ = _e1315;
                                                        } else {
                                                            phi_4641_ = _e704;
                                                        }
                                                        let _e1317 = phi_4641_;
                                                        phi_4640_ = _e1317;
                                                        phi_4490_ = _e1308;
                                                    } else {
                                                        phi_4640_ = _e704;
                                                        phi_4490_ = _e702;
                                                    }
                                                    let _e1319 = phi_4640_;
                                                    let _e1321 = phi_4490_;
                                                    phi_4639_ = _e1319;
                                                    phi_4489_ = _e1321;
                                                } else {
                                                    phi_4639_ = _e704;
                                                    phi_4489_ = _e702;
                                                }
                                                let _e1323 = phi_4639_;
                                                let _e1325 = phi_4489_;
                                                phi_4638_ = _e1323;
                                                phi_4488_ = _e1325;
                                            } else {
                                                phi_4638_ = _e704;
                                                phi_4488_ = _e702;
                                            }
                                            let _e1327 = phi_4638_;
                                            let _e1329 = phi_4488_;
                                            continue;
                                            continuing {
                                                phi_4332_ = _e1329;
                                                phi_4320_ = _e1327;
                                                phi_1368_ = _e719;
                                                phi_4545_ = _e1327;
                                                phi_4487_ = _e1329;
                                                break if !(_e725);
                                            }
                                        }
                                        let _e1332 = phi_4545_;
                                        let _e1334 = phi_4487_;
                                        phi_4643_ = _e1334;
                                        if _e1334 {
                                            break;
                                        }
                                        phi_4729_ = _e1334;
                                        phi_4544_ = _e1332;
                                    } else {
                                        phi_4729_ = _e647;
                                        phi_4544_ = _e649;
                                    }
                                    let _e1336 = phi_4729_;
                                    let _e1338 = phi_4544_;
                                    if _e695 {
                                        phi_3636_ = bool();
                                        phi_3637_ = u32();
                                        phi_3638_ = type_53();
                                    } else {
                                        if (_e691.member_1 >= _e96) {
                                            phi_3171_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e691.member_1 < _e96) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1341 = (_e266 * 2u);
                                            let _e1343 = ((1u + _e1341) % 7u);
                                            if (_e1343 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1348 = global_5.member[_e691.member_1][_e1343];
                                            let _e1350 = ((_e1341 + 2u) % 7u);
                                            if (_e1350 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1355 = global_5.member[_e691.member_1][_e1350];
                                            let _e1356 = (_e265 * 2u);
                                            let _e1358 = ((1u + _e1356) % 7u);
                                            if (_e1358 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1363 = global_5.member[_e691.member_1][_e1358];
                                            let _e1365 = ((_e1356 + 2u) % 7u);
                                            if (_e1365 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1370 = global_5.member[_e691.member_1][_e1365];
                                            let _e1371 = (_e267 * 2u);
                                            let _e1373 = ((1u + _e1371) % 7u);
                                            if (_e1373 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1378 = global_5.member[_e691.member_1][_e1373];
                                            let _e1380 = ((_e1371 + 2u) % 7u);
                                            if (_e1380 < 7u) {
                                            } else {
                                                phi_4643_ = true;
                                                break;
                                            }
                                            let _e1385 = global_5.member[_e691.member_1][_e1380];
                                            let _e1408 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.x - _e691.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1409 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.y - _e691.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1410 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.z - _e691.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1412 = select(_e146, _e1408, (_e1408 > _e146));
                                            let _e1414 = select(_e146, _e1409, (_e1409 > _e146));
                                            let _e1416 = select(_e146, _e1410, (_e1410 > _e146));
                                            let _e1447 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1348 & 2097151u))) - 8388608f) * _e1412));
                                            let _e1452 = (bitcast<i32>((_e1348 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1455 = bitcast<f32>((_e1447 & bitcast<u32>(_e1452)));
                                            let _e1456 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1363 & 2097151u))) - 8388608f) * _e1414));
                                            let _e1461 = (bitcast<i32>((_e1363 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1464 = bitcast<f32>((_e1456 & bitcast<u32>(_e1461)));
                                            let _e1465 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1378 & 2097151u))) - 8388608f) * _e1416));
                                            let _e1470 = (bitcast<i32>((_e1378 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1473 = bitcast<f32>((_e1465 & bitcast<u32>(_e1470)));
                                            let _e1477 = bitcast<f32>((_e1447 & bitcast<u32>(~(_e1452))));
                                            let _e1481 = bitcast<f32>((_e1456 & bitcast<u32>(~(_e1461))));
                                            let _e1485 = bitcast<f32>((_e1465 & bitcast<u32>(~(_e1470))));
                                            let _e1486 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1355 & 2097151u))) - 8388608f) * _e1412));
                                            let _e1491 = (bitcast<i32>((_e1355 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1494 = bitcast<f32>((_e1486 & bitcast<u32>(_e1491)));
                                            let _e1495 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1370 & 2097151u))) - 8388608f) * _e1414));
                                            let _e1500 = (bitcast<i32>((_e1370 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1503 = bitcast<f32>((_e1495 & bitcast<u32>(_e1500)));
                                            let _e1504 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1385 & 2097151u))) - 8388608f) * _e1416));
                                            let _e1509 = (bitcast<i32>((_e1385 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1512 = bitcast<f32>((_e1504 & bitcast<u32>(_e1509)));
                                            let _e1516 = bitcast<f32>((_e1486 & bitcast<u32>(~(_e1491))));
                                            let _e1520 = bitcast<f32>((_e1495 & bitcast<u32>(~(_e1500))));
                                            let _e1524 = bitcast<f32>((_e1504 & bitcast<u32>(~(_e1509))));
                                            let _e1554 = global_5.member[_e691.member_1][0u];
                                            let _e1558 = global_5.member[_e691.member_1][2u];
                                            let _e1562 = global_5.member[_e691.member_1][4u];
                                            let _e1566 = global_5.member[_e691.member_1][6u];
                                            let _e1578 = (((_e1558 >> bitcast<u32>(22i)) | ((_e1562 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1566 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1579 = (_e1554 & 268435455u);
                                            let _e1580 = (_e1578 & 268435455u);
                                            let _e1583 = ((_e1554 >> bitcast<u32>(28u)) & 7u);
                                            let _e1591 = ((_e1554 >> bitcast<u32>(31i)) | (((_e1578 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1592 = (_e1583 != 0u);
                                            if (_e1583 == 0u) {
                                                phi_3133_ = _e1579;
                                            } else {
                                                if (_e1583 == 7u) {
                                                    phi_3132_ = 2147483648u;
                                                } else {
                                                    phi_3132_ = ((2147483648u | (_e1583 << bitcast<u32>(28u))) | (_e1580 & 268435455u));
                                                }
                                                let _e1601 = phi_3132_;
                                                phi_3133_ = _e1601;
                                            }
                                            let _e1603 = phi_3133_;
                                            if _e1592 {
                                                let _e1604 = (_e1583 != 7u);
                                                if _e1604 {
                                                    phi_3143_ = (_e1580 + _e1583);
                                                } else {
                                                    phi_3143_ = u32();
                                                }
                                                let _e1607 = phi_3143_;
                                                phi_3145_ = _e1607;
                                                phi_3146_ = select(true, false, _e1604);
                                            } else {
                                                phi_3145_ = u32();
                                                phi_3146_ = true;
                                            }
                                            let _e1610 = phi_3145_;
                                            let _e1612 = phi_3146_;
                                            if (_e1591 == 0u) {
                                                phi_3167_ = (_e1579 + select(0u, 1u, !(_e1592)));
                                            } else {
                                                if (_e1591 == 7u) {
                                                    phi_3166_ = 2147483648u;
                                                } else {
                                                    phi_3166_ = ((2147483648u | (_e1591 << bitcast<u32>(28u))) | (select(_e1610, _e1580, _e1612) & 268435455u));
                                                }
                                                let _e1625 = phi_3166_;
                                                phi_3167_ = _e1625;
                                            }
                                            let _e1627 = phi_3167_;
                                            phi_3171_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e691.member.member.x + _e1455), (_e691.member.member.x + _e1477), (_e691.member.member_1.x - _e1494), (_e691.member.member_1.x - _e1516)), vec4<f32>((_e691.member.member.y + _e1464), (_e691.member.member.y + _e1481), (_e691.member.member_1.y - _e1503), (_e691.member.member_1.y - _e1520)), vec4<f32>((_e691.member.member.z + _e1473), (_e691.member.member.z + _e1485), (_e691.member.member_1.z - _e1512), (_e691.member.member_1.z - _e1524))), type_53(type_25((_e691.member.member + vec4<f32>(_e1455, _e1464, _e1473, 0f)), (_e691.member.member_1 - vec4<f32>(_e1494, _e1503, _e1512, 0f))), _e1603), type_53(type_25((_e691.member.member + vec4<f32>(_e1477, _e1481, _e1485, 0f)), (_e691.member.member_1 - vec4<f32>(_e1516, _e1520, _e1524, 0f))), _e1627));
                                        }
                                        let _e1632 = phi_3171_;
                                        let _e1643 = ((_e1632.member[0].x - _e368) * _e371);
                                        let _e1644 = ((_e1632.member[0].y - _e368) * _e371);
                                        let _e1645 = ((_e1632.member[0].z - _e369) * _e371);
                                        let _e1646 = ((_e1632.member[0].w - _e369) * _e371);
                                        let _e1656 = ((_e1632.member[1].x - _e434) * _e437);
                                        let _e1657 = ((_e1632.member[1].y - _e434) * _e437);
                                        let _e1658 = ((_e1632.member[1].z - _e435) * _e437);
                                        let _e1659 = ((_e1632.member[1].w - _e435) * _e437);
                                        let _e1669 = ((_e1632.member[2].x - _e500) * _e503);
                                        let _e1670 = ((_e1632.member[2].y - _e500) * _e503);
                                        let _e1671 = ((_e1632.member[2].z - _e501) * _e503);
                                        let _e1672 = ((_e1632.member[2].w - _e501) * _e503);
                                        let _e1674 = select(_e1671, _e1669, (_e1669 < _e1671));
                                        let _e1676 = select(_e1672, _e1670, (_e1670 < _e1672));
                                        let _e1678 = select(_e1671, _e1669, (_e1669 > _e1671));
                                        let _e1680 = select(_e1672, _e1670, (_e1670 > _e1672));
                                        let _e1682 = select(_e1645, _e1643, (_e1643 < _e1645));
                                        let _e1684 = select(_e1646, _e1644, (_e1644 < _e1646));
                                        let _e1686 = select(_e1658, _e1656, (_e1656 < _e1658));
                                        let _e1688 = select(_e1659, _e1657, (_e1657 < _e1659));
                                        let _e1690 = select(_e1686, _e1682, (_e1682 > _e1686));
                                        let _e1692 = select(_e1688, _e1684, (_e1684 > _e1688));
                                        let _e1694 = select(_e1674, _e1690, (_e1690 > _e1674));
                                        let _e1696 = select(_e1676, _e1692, (_e1692 > _e1676));
                                        let _e1698 = select(_e1645, _e1643, (_e1643 > _e1645));
                                        let _e1700 = select(_e1646, _e1644, (_e1644 > _e1646));
                                        let _e1702 = select(_e1658, _e1656, (_e1656 > _e1658));
                                        let _e1704 = select(_e1659, _e1657, (_e1657 > _e1659));
                                        let _e1706 = select(_e1702, _e1698, (_e1698 < _e1702));
                                        let _e1708 = select(_e1704, _e1700, (_e1700 < _e1704));
                                        let _e1713 = -(_e1674);
                                        let _e1714 = -(_e1676);
                                        let _e1721 = (select(_e1678, _e1706, (_e1706 < _e1678)) + (select(_e1713, _e1678, (_e1678 > _e1713)) * 0.0000019073523f));
                                        let _e1722 = (select(_e1680, _e1708, (_e1708 < _e1680)) + (select(_e1714, _e1680, (_e1680 > _e1714)) * 0.0000019073523f));
                                        let _e1724 = select(_e606, _e1694, (_e1694 > _e606));
                                        let _e1726 = select(_e606, _e1696, (_e1696 > _e606));
                                        let _e1731 = (_e1724 <= select(_e1338, _e1721, (_e1721 < _e1338)));
                                        let _e1732 = (_e1726 <= select(_e1338, _e1722, (_e1722 < _e1338)));
                                        let _e1733 = (_e1724 <= _e1726);
                                        if _e1731 {
                                            if _e1732 {
                                                if _e1733 {
                                                    phi_3534_ = _e1632.member_2;
                                                } else {
                                                    phi_3534_ = _e1632.member_1;
                                                }
                                                let _e1737 = phi_3534_;
                                                let _e1758 = (_e689 % 128u);
                                                let _e1759 = (_e1758 < 128u);
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_8[_e1758] = _e1737.member_1;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_7[_e1758] = _e1737.member.member.x;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_6[_e1758] = _e1737.member.member.y;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_5[_e1758] = _e1737.member.member.z;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_4[_e1758] = _e1737.member.member_1.x;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_3[_e1758] = _e1737.member.member_1.y;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_2[_e1758] = _e1737.member.member_1.z;
                                                if _e1759 {
                                                } else {
                                                    phi_4643_ = true;
                                                    break;
                                                }
                                                local_10[_e1758] = select(_e1724, _e1726, _e1733);
                                                if _e1733 {
                                                    phi_3610_ = _e1632.member_1;
                                                } else {
                                                    phi_3610_ = _e1632.member_2;
                                                }
                                                let _e1772 = phi_3610_;
                                                phi_3611_ = (_e689 + 1u);
                                                phi_3612_ = _e1772;
                                            } else {
                                                phi_3611_ = u32();
                                                phi_3612_ = type_53();
                                            }
                                            let _e1774 = phi_3611_;
                                            let _e1776 = phi_3612_;
                                            phi_3614_ = _e1774;
                                            phi_3615_ = _e1776;
                                            phi_3616_ = select(true, false, _e1732);
                                        } else {
                                            phi_3614_ = u32();
                                            phi_3615_ = type_53();
                                            phi_3616_ = true;
                                        }
                                        let _e1779 = phi_3614_;
                                        let _e1781 = phi_3615_;
                                        let _e1783 = phi_3616_;
                                        if _e1783 {
                                            if _e1731 {
                                                phi_3625_ = _e1632.member_1;
                                            } else {
                                                phi_3625_ = _e1632.member_2;
                                            }
                                            let _e1787 = phi_3625_;
                                            phi_3630_ = select(_e1732, true, _e1731);
                                            phi_3632_ = _e1787;
                                        } else {
                                            phi_3630_ = _e687;
                                            phi_3632_ = _e1781;
                                        }
                                        let _e1790 = phi_3630_;
                                        let _e1792 = phi_3632_;
                                        phi_3636_ = _e1790;
                                        phi_3637_ = select(_e1779, _e689, _e1783);
                                        phi_3638_ = _e1792;
                                    }
                                    let _e1795 = phi_3636_;
                                    let _e1797 = phi_3637_;
                                    let _e1799 = phi_3638_;
                                    if _e695 {
                                        phi_3648_ = _e691;
                                    } else {
                                        phi_3648_ = _e1799;
                                    }
                                    let _e1801 = phi_3648_;
                                    phi_4757_ = _e1338;
                                    phi_4646_ = _e1336;
                                    phi_3649_ = (_e651 - 1u);
                                    phi_3650_ = select(_e1795, false, _e695);
                                    phi_3651_ = select(_e1797, _e689, _e695);
                                    phi_3652_ = _e1801;
                                } else {
                                    phi_4757_ = _e649;
                                    phi_4646_ = _e647;
                                    phi_3649_ = _e651;
                                    phi_3650_ = _e687;
                                    phi_3651_ = _e689;
                                    phi_3652_ = _e691;
                                }
                                let _e1805 = phi_4757_;
                                let _e1807 = phi_4646_;
                                let _e1809 = phi_3649_;
                                let _e1811 = phi_3650_;
                                let _e1813 = phi_3651_;
                                let _e1815 = phi_3652_;
                                phi_4756_ = _e1805;
                                phi_4645_ = _e1807;
                                phi_3653_ = _e1809;
                                phi_3654_ = _e1811;
                                phi_3655_ = _e1813;
                                phi_3656_ = _e1815;
                            } else {
                                phi_4756_ = _e649;
                                phi_4645_ = _e647;
                                phi_3653_ = u32();
                                phi_3654_ = bool();
                                phi_3655_ = u32();
                                phi_3656_ = type_53();
                            }
                            let _e1817 = phi_4756_;
                            let _e1819 = phi_4645_;
                            let _e1821 = phi_3653_;
                            let _e1823 = phi_3654_;
                            let _e1825 = phi_3655_;
                            let _e1827 = phi_3656_;
                            phi_4755_ = _e1817;
                            phi_4644_ = _e1819;
                            phi_1244_ = _e1821;
                            phi_1247_ = _e1823;
                            phi_1249_ = _e1825;
                            phi_1251_ = _e1827;
                            phi_3657_ = _e661;
                        } else {
                            phi_4755_ = _e649;
                            phi_4644_ = _e647;
                            phi_1244_ = u32();
                            phi_1247_ = bool();
                            phi_1249_ = u32();
                            phi_1251_ = type_53();
                            phi_3657_ = false;
                        }
                        let _e1829 = phi_4755_;
                        let _e1831 = phi_4644_;
                        let _e1833 = phi_1244_;
                        let _e1835 = phi_1247_;
                        let _e1837 = phi_1249_;
                        let _e1839 = phi_1251_;
                        let _e1841 = phi_3657_;
                        continue;
                        continuing {
                            phi_4335_ = _e1831;
                            phi_4315_ = _e1829;
                            phi_1243_ = _e1833;
                            phi_1246_ = _e1835;
                            phi_1248_ = _e1837;
                            phi_1250_ = _e1839;
                            phi_4643_ = _e1831;
                            break if !(_e1841);
                        }
                    }
                    let _e1844 = phi_4643_;
                    if _e1844 {
                        break;
                    }
                    phi_3664_ = type_4(0u, 8u);
                    loop {
                        let _e1846 = phi_3664_;
                        if (_e1846.member < _e1846.member_1) {
                            phi_3665_ = type_4((_e1846.member + 1u), _e1846.member_1);
                            phi_3688_ = type_4(1u, _e1846.member);
                        } else {
                            phi_3665_ = _e1846;
                            phi_3688_ = type_4(0u, type_4().member_1);
                        }
                        let _e1859 = phi_3665_;
                        let _e1861 = phi_3688_;
                        let _e1865 = (bitcast<i32>(_e1861.member) != 0i);
                        if _e1865 {
                            let _e1866 = (_e1861.member_1 < 8u);
                            if _e1866 {
                            } else {
                                phi_4737_ = true;
                                break;
                            }
                            let _e1868 = local_9[_e1861.member_1];
                            if (_e1868.member_3 != 4294967295u) {
                                let _e1874 = -(_e508);
                                let _e1875 = bitcast<u32>(_e1868.member);
                                let _e1879 = (bitcast<i32>((_e1875 >> bitcast<u32>(23i))) & 255i);
                                let _e1880 = (_e1879 + _e1874);
                                if (_e1879 == 255i) {
                                    phi_3761_ = _e1868.member;
                                } else {
                                    if (_e1879 > 0i) {
                                        if (_e1880 > 0i) {
                                            let _e1884 = (_e1880 < 255i);
                                            if _e1884 {
                                                phi_3740_ = bitcast<f32>((_e1875 + bitcast<u32>((_e1874 << bitcast<u32>(23i)))));
                                            } else {
                                                phi_3740_ = f32();
                                            }
                                            let _e1891 = phi_3740_;
                                            phi_3742_ = _e1891;
                                            phi_3743_ = select(true, false, _e1884);
                                        } else {
                                            phi_3742_ = f32();
                                            phi_3743_ = true;
                                        }
                                        let _e1894 = phi_3742_;
                                        let _e1896 = phi_3743_;
                                        phi_3744_ = _e1894;
                                        phi_3745_ = _e1896;
                                    } else {
                                        phi_3744_ = f32();
                                        phi_3745_ = true;
                                    }
                                    let _e1898 = phi_3744_;
                                    let _e1900 = phi_3745_;
                                    if _e1900 {
                                        let _e1901 = (_e1875 & 2147483648u);
                                        let _e1908 = ((_e1875 & 8388607u) | (select(0u, 1u, ((_e1875 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                        let _e1912 = (_e1908 == 0u);
                                        if _e1912 {
                                            phi_4262_ = bitcast<f32>(_e1901);
                                        } else {
                                            let _e1917 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1908)), 32u, _e1912) - 8u);
                                            let _e1920 = (_e1908 << bitcast<u32>((_e1917 & 31u)));
                                            let _e1922 = ((_e1880 + select(0i, 1i, (_e1879 == 0i))) - bitcast<i32>(_e1917));
                                            if (_e1922 >= 255i) {
                                                phi_4252_ = bitcast<f32>((_e1901 | 2139095040u));
                                                phi_4253_ = f32();
                                                phi_4254_ = true;
                                            } else {
                                                let _e1924 = (_e1922 > 0i);
                                                if _e1924 {
                                                    phi_4246_ = bitcast<f32>(((_e1901 | (bitcast<u32>(_e1922) << bitcast<u32>(23i))) | (_e1920 & 8388607u)));
                                                    phi_4247_ = f32();
                                                } else {
                                                    if (_e1922 < -24i) {
                                                        phi_4212_ = 26u;
                                                    } else {
                                                        phi_4212_ = bitcast<u32>((1i - _e1922));
                                                    }
                                                    let _e1929 = phi_4212_;
                                                    let _e1930 = (_e1929 & 31u);
                                                    let _e1932 = (_e1920 >> bitcast<u32>(_e1930));
                                                    let _e1936 = (_e1920 & ((1u << bitcast<u32>(_e1930)) - 1u));
                                                    let _e1940 = (1u << bitcast<u32>(((_e1929 - 1u) & 31u)));
                                                    if (_e1936 > _e1940) {
                                                        phi_4233_ = true;
                                                    } else {
                                                        if (_e1936 == _e1940) {
                                                            phi_4230_ = ((_e1932 & 1u) == 1u);
                                                        } else {
                                                            phi_4230_ = false;
                                                        }
                                                        let _e1946 = phi_4230_;
                                                        phi_4233_ = _e1946;
                                                    }
                                                    let _e1948 = phi_4233_;
                                                    phi_4246_ = f32();
                                                    phi_4247_ = bitcast<f32>((_e1901 | (_e1932 + select(0u, 1u, _e1948))));
                                                }
                                                let _e1961 = phi_4246_;
                                                let _e1963 = phi_4247_;
                                                phi_4252_ = _e1961;
                                                phi_4253_ = _e1963;
                                                phi_4254_ = _e1924;
                                            }
                                            let _e1967 = phi_4252_;
                                            let _e1969 = phi_4253_;
                                            let _e1971 = phi_4254_;
                                            phi_4262_ = select(_e1969, _e1967, _e1971);
                                        }
                                        let _e1975 = phi_4262_;
                                        phi_3760_ = _e1975;
                                    } else {
                                        phi_3760_ = _e1898;
                                    }
                                    let _e1977 = phi_3760_;
                                    phi_3761_ = _e1977;
                                }
                                let _e1979 = phi_3761_;
                                let _e1980 = bitcast<u32>(_e1979);
                                if ((_e1980 & 2147483647u) >= 2139095040u) {
                                    phi_3773_ = bitcast<f32>(((_e1980 & 2147483648u) | 2139095039u));
                                } else {
                                    phi_3773_ = _e1979;
                                }
                                let _e1987 = phi_3773_;
                                phi_3778_ = type_21(_e1987, _e1868.member_1, _e1868.member_2, _e1868.member_3);
                            } else {
                                phi_3778_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1990 = phi_3778_;
                            if _e1866 {
                            } else {
                                phi_4737_ = true;
                                break;
                            }
                            local_9[_e1861.member_1] = type_21(_e1990.member, _e1990.member_1, _e1990.member_2, _e1990.member_3);
                        }
                        continue;
                        continuing {
                            phi_3664_ = _e1859;
                            phi_4737_ = _e1844;
                            break if !(_e1865);
                        }
                    }
                    let _e1998 = phi_4737_;
                    if _e1998 {
                        break;
                    }
                    let _e1999 = local_9;
                    if _e154 {
                    } else {
                        break;
                    }
                    global_6.member[_e152] = array<type_21, 8>(type_21(_e1999[0].member, _e1999[0].member_1, _e1999[0].member_2, _e1999[0].member_3), type_21(_e1999[1].member, _e1999[1].member_1, _e1999[1].member_2, _e1999[1].member_3), type_21(_e1999[2].member, _e1999[2].member_1, _e1999[2].member_2, _e1999[2].member_3), type_21(_e1999[3].member, _e1999[3].member_1, _e1999[3].member_2, _e1999[3].member_3), type_21(_e1999[4].member, _e1999[4].member_1, _e1999[4].member_2, _e1999[4].member_3), type_21(_e1999[5].member, _e1999[5].member_1, _e1999[5].member_2, _e1999[5].member_3), type_21(_e1999[6].member, _e1999[6].member_1, _e1999[6].member_2, _e1999[6].member_3), type_21(_e1999[7].member, _e1999[7].member_1, _e1999[7].member_2, _e1999[7].member_3));
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
