struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<array<u32, 4>>,
}

struct type_15 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_22 {
    member: array<type_20>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_41 {
    member: array<type_29>,
}

struct type_43 {
    member: f32,
    member_1: bool,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_32,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_15;
@group(0) @binding(3) 
var<storage> global_2: type_22;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<storage> global_4: type_12;
@group(0) @binding(4) 
var<storage> global_5: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;

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
    var phi_400_: i32;
    var phi_401_: i32;
    var phi_411_: bool;
    var phi_421_: u32;
    var phi_422_: u32;
    var phi_424_: bool;
    var phi_429_: u32;
    var phi_442_: i32;
    var phi_462_: i32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_730_: f32;
    var phi_736_: f32;
    var phi_776_: f32;
    var phi_782_: f32;
    var phi_901_: i32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_961_: i32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_3752_: bool;
    var phi_1089_: type_43;
    var phi_1092_: bool;
    var phi_1094_: type_50;
    var phi_1096_: u32;
    var phi_1098_: u32;
    var phi_1109_: bool;
    var phi_1195_: bool;
    var phi_1196_: type_50;
    var phi_1197_: u32;
    var phi_2860_: u32;
    var phi_2861_: u32;
    var phi_2871_: u32;
    var phi_2873_: u32;
    var phi_2874_: bool;
    var phi_2894_: u32;
    var phi_2895_: u32;
    var phi_2899_: type_51;
    var phi_3261_: type_50;
    var phi_3337_: type_50;
    var phi_3338_: type_50;
    var phi_3339_: u32;
    var phi_3341_: type_50;
    var phi_3342_: u32;
    var phi_3343_: bool;
    var phi_3352_: type_50;
    var phi_3357_: bool;
    var phi_3358_: type_50;
    var phi_1215_: type_43;
    var phi_1218_: type_7;
    var phi_1219_: type_7;
    var phi_1241_: type_7;
    var phi_1262_: u32;
    var phi_1354_: array<array<f32, 3>, 3>;
    var phi_1884_: f32;
    var phi_1885_: f32;
    var phi_1886_: f32;
    var phi_1887_: f32;
    var phi_1888_: vec3<f32>;
    var phi_1889_: vec3<f32>;
    var phi_1890_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_2082_: f32;
    var phi_2102_: type_39;
    var phi_2103_: type_39;
    var phi_2106_: type_39;
    var phi_2107_: type_39;
    var phi_2108_: bool;
    var phi_2112_: type_39;
    var phi_2121_: type_28;
    var phi_2132_: type_43;
    var phi_2133_: type_43;
    var phi_1216_: type_43;
    var phi_3746_: bool;
    var local_10: type_43;
    var phi_3900_: bool;
    var phi_3360_: type_43;
    var phi_3361_: bool;
    var phi_3362_: type_50;
    var phi_3363_: u32;
    var phi_3899_: bool;
    var phi_3364_: type_43;
    var phi_3365_: bool;
    var phi_3366_: type_50;
    var phi_3367_: u32;
    var phi_3368_: u32;
    var phi_3898_: bool;
    var phi_3369_: type_43;
    var phi_3370_: bool;
    var phi_3371_: type_50;
    var phi_3372_: u32;
    var phi_3373_: u32;
    var phi_3897_: bool;
    var phi_1090_: type_43;
    var phi_1093_: bool;
    var phi_1095_: type_50;
    var phi_1097_: u32;
    var phi_1099_: u32;
    var phi_3374_: bool;
    var phi_3896_: bool;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e89 = global;
            let _e91 = arrayLength((&global_4.member));
            let _e93 = arrayLength((&global_2.member));
            let _e101 = global_3.member[0u][0u];
            let _e105 = global_3.member[0u][1u];
            let _e109 = global_3.member[0u][2u];
            let _e113 = global_3.member[0u][3u];
            let _e117 = global_3.member[1u][0u];
            let _e121 = global_3.member[1u][1u];
            let _e125 = global_3.member[1u][2u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e141 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e113) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e101), bitcast<i32>(_e105), bitcast<i32>(_e109));
            local = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            let _e147 = (_e89.x + (_e89.y * 2097152u));
            let _e148 = (_e147 < arrayLength((&global_5.member)));
            if _e148 {
                let _e149 = (_e147 < arrayLength((&global_6.member)));
                if _e149 {
                    if _e148 {
                    } else {
                        break;
                    }
                    let _e157 = global_5.member[_e147].member_2[0u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_5.member[_e147].member_2[1u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e147].member_2[2u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e147].member[0u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e147].member[1u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_5.member[_e147].member[2u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e196 = select(_e166, _e159, (_e166 < _e159));
                    let _e198 = select(_e173, _e196, (_e173 < _e196));
                    let _e200 = select(_e180, _e198, (_e180 < _e198));
                    let _e202 = select(_e187, _e200, (_e187 < _e200));
                    let _e204 = select(_e194, _e202, (_e194 < _e202));
                    let _e208 = global_5.member[_e147].member_1;
                    let _e209 = bitcast<u32>(_e208);
                    let _e210 = (_e209 & 2147483647u);
                    let _e217 = global_5.member[_e147].member_3;
                    let _e218 = bitcast<u32>(_e217);
                    let _e219 = (_e218 & 2147483647u);
                    let _e223 = (((select(_e210, _e204, (_e210 < _e204)) < 2139095040u) && (_e219 <= 2139095040u)) && (_e198 > 0u));
                    if _e223 {
                        let _e226 = (bitcast<u32>(bitcast<f32>(_e198)) & 2147483647u);
                        if (_e226 >= 8388608u) {
                            phi_400_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_400_;
                        phi_401_ = _e240;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e242 = phi_401_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e166 == _e198);
                    }
                    let _e246 = phi_411_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_421_ = _e248;
                        phi_422_ = _e248;
                        phi_424_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e252 = phi_421_;
                    let _e254 = phi_422_;
                    let _e256 = phi_424_;
                    if _e256 {
                        phi_429_ = (_e254 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e260 = phi_429_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_442_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_462_ = -126i;
                    } else {
                        phi_462_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_462_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_5.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_480_ = _e299[0];
                    } else {
                        phi_480_ = _e299[1];
                    }
                    let _e304 = phi_480_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_486_ = _e299[2];
                    } else {
                        phi_486_ = _e304;
                    }
                    let _e308 = phi_486_;
                    let _e309 = bitcast<u32>(_e308);
                    let _e311 = ((_e309 & 2139095040u) != 0u);
                    let _e325 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * _e272) * select(0.00000011920929f, 1f, _e311)) * _e278);
                    let _e326 = global_5.member[_e147].member_2;
                    if _e300 {
                        phi_526_ = _e326[0];
                    } else {
                        phi_526_ = _e326[1];
                    }
                    let _e330 = phi_526_;
                    if _e305 {
                        phi_532_ = _e326[2];
                    } else {
                        phi_532_ = _e330;
                    }
                    let _e333 = phi_532_;
                    let _e334 = bitcast<u32>(_e333);
                    let _e336 = ((_e334 & 2139095040u) != 0u);
                    let _e350 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e334 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e334 & 2147483648u))), _e333, _e336) * _e289) * select(0.00000011920929f, 1f, _e336)) * _e295);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e357 = bitcast<f32>((bitcast<u32>(_e325) & 2147483647u));
                    let _e358 = (_e357 * 0.00000011920929f);
                    let _e361 = select(select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f)), 0f, _e354);
                    let _e362 = select(0f, _e350, _e354);
                    let _e363 = (_e325 + _e361);
                    let _e364 = (_e325 - _e361);
                    let _e366 = select(38685626000000000000000000f, (1f / _e350), _e354);
                    let _e367 = (_e260 == 0u);
                    if _e367 {
                        phi_605_ = _e299[0];
                    } else {
                        phi_605_ = _e299[1];
                    }
                    let _e371 = phi_605_;
                    let _e372 = (_e260 == 2u);
                    if _e372 {
                        phi_611_ = _e299[2];
                    } else {
                        phi_611_ = _e371;
                    }
                    let _e375 = phi_611_;
                    let _e376 = bitcast<u32>(_e375);
                    let _e378 = ((_e376 & 2139095040u) != 0u);
                    let _e392 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * _e272) * select(0.00000011920929f, 1f, _e378)) * _e278);
                    if _e367 {
                        phi_651_ = _e326[0];
                    } else {
                        phi_651_ = _e326[1];
                    }
                    let _e396 = phi_651_;
                    if _e372 {
                        phi_657_ = _e326[2];
                    } else {
                        phi_657_ = _e396;
                    }
                    let _e399 = phi_657_;
                    let _e400 = bitcast<u32>(_e399);
                    let _e402 = ((_e400 & 2139095040u) != 0u);
                    let _e416 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e400 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e400 & 2147483648u))), _e399, _e402) * _e289) * select(0.00000011920929f, 1f, _e402)) * _e295);
                    let _e420 = (bitcast<f32>((bitcast<u32>(_e416) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e423 = bitcast<f32>((bitcast<u32>(_e392) & 2147483647u));
                    let _e424 = (_e423 * 0.00000011920929f);
                    let _e427 = select(select(0.00000000000011368684f, _e424, (_e424 > 0.00000000000011368684f)), 0f, _e420);
                    let _e428 = select(0f, _e416, _e420);
                    let _e429 = (_e392 + _e427);
                    let _e430 = (_e392 - _e427);
                    let _e432 = select(38685626000000000000000000f, (1f / _e416), _e420);
                    let _e433 = (_e262 == 0u);
                    if _e433 {
                        phi_730_ = _e299[0];
                    } else {
                        phi_730_ = _e299[1];
                    }
                    let _e437 = phi_730_;
                    let _e438 = (_e262 == 2u);
                    if _e438 {
                        phi_736_ = _e299[2];
                    } else {
                        phi_736_ = _e437;
                    }
                    let _e441 = phi_736_;
                    let _e442 = bitcast<u32>(_e441);
                    let _e444 = ((_e442 & 2139095040u) != 0u);
                    let _e458 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e442 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e442 & 2147483648u))), _e441, _e444) * _e272) * select(0.00000011920929f, 1f, _e444)) * _e278);
                    if _e433 {
                        phi_776_ = _e326[0];
                    } else {
                        phi_776_ = _e326[1];
                    }
                    let _e462 = phi_776_;
                    if _e438 {
                        phi_782_ = _e326[2];
                    } else {
                        phi_782_ = _e462;
                    }
                    let _e465 = phi_782_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e289) * select(0.00000011920929f, 1f, _e468)) * _e295);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e489 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                    let _e490 = (_e489 * 0.00000011920929f);
                    let _e493 = select(select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f)), 0f, _e486);
                    let _e494 = select(0f, _e482, _e486);
                    let _e495 = (_e458 + _e493);
                    let _e496 = (_e458 - _e493);
                    let _e498 = select(38685626000000000000000000f, (1f / _e482), _e486);
                    let _e500 = select(_e423, _e357, (_e357 > _e423));
                    let _e503 = (_e129 + _e242);
                    if (_e223 && (select(_e489, _e500, (_e500 > _e489)) <= 1099511600000f)) {
                        let _e513 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e516 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                        let _e520 = (_e513 == 0u);
                        let _e523 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e513)), 32u, _e520)) - 8i);
                        if (_e516 == 255i) {
                            phi_901_ = 255i;
                        } else {
                            phi_901_ = (((_e516 + select(0i, 1i, (_e516 == 0i))) - _e523) + _e503);
                        }
                        let _e531 = phi_901_;
                        let _e541 = (_e531 <= 0i);
                        if _e541 {
                            phi_924_ = u32();
                        } else {
                            if _e520 {
                                phi_923_ = u32();
                            } else {
                                phi_923_ = select(((bitcast<u32>(_e531) << bitcast<u32>(23i)) | ((_e513 << bitcast<u32>(((_e523 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e531 >= 255i));
                            }
                            let _e545 = phi_923_;
                            phi_924_ = _e545;
                        }
                        let _e547 = phi_924_;
                        let _e559 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e562 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                        let _e566 = (_e559 == 0u);
                        let _e569 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e559)), 32u, _e566)) - 8i);
                        if (_e562 == 255i) {
                            phi_961_ = 255i;
                        } else {
                            phi_961_ = (((_e562 + select(0i, 1i, (_e562 == 0i))) - _e569) + _e503);
                        }
                        let _e577 = phi_961_;
                        let _e587 = (_e577 <= 0i);
                        if _e587 {
                            phi_984_ = u32();
                        } else {
                            if _e566 {
                                phi_983_ = u32();
                            } else {
                                phi_983_ = select(((bitcast<u32>(_e577) << bitcast<u32>(23i)) | ((_e559 << bitcast<u32>(((_e569 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e577 >= 255i));
                            }
                            let _e591 = phi_983_;
                            phi_984_ = _e591;
                        }
                        let _e593 = phi_984_;
                        phi_992_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e593, 0u, select(_e566, true, _e587))));
                        phi_993_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e547, 0u, select(_e520, true, _e541))));
                    } else {
                        phi_992_ = 0f;
                        phi_993_ = 1f;
                    }
                    let _e599 = phi_992_;
                    let _e601 = phi_993_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e607 = (_e261 % 3u);
                    let _e608 = (_e607 < 3u);
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e610 = local_1[_e607];
                    let _e613 = (_e260 % 3u);
                    let _e614 = (_e613 < 3u);
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e616 = local_1[_e613];
                    let _e619 = (_e262 % 3u);
                    let _e620 = (_e619 < 3u);
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e622 = local_1[_e619];
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e627 = local[_e607];
                    if _e614 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e613];
                    if _e620 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e619];
                    phi_3752_ = false;
                    phi_1089_ = type_43(_e599, false);
                    phi_1092_ = (_e601 <= _e599);
                    phi_1094_ = type_50(type_32(vec4<f32>((f32(_e610) * _e141), (f32(_e616) * _e141), (f32(_e622) * _e141), 0f), vec4<f32>((f32(_e627) * _e141), (f32(_e631) * _e141), (f32(_e635) * _e141), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                    phi_1096_ = 0u;
                    phi_1098_ = ((3u * _e91) + 1u);
                    loop {
                        let _e643 = phi_3752_;
                        let _e645 = phi_1089_;
                        let _e647 = phi_1092_;
                        let _e649 = phi_1094_;
                        let _e651 = phi_1096_;
                        let _e653 = phi_1098_;
                        local_11 = _e645;
                        if _e647 {
                            phi_1109_ = true;
                        } else {
                            phi_1109_ = (_e651 > 0u);
                        }
                        let _e656 = phi_1109_;
                        if _e656 {
                            let _e657 = (_e653 > 0u);
                            if _e657 {
                                if _e647 {
                                    phi_1195_ = _e647;
                                    phi_1196_ = _e649;
                                    phi_1197_ = _e651;
                                } else {
                                    let _e658 = (_e651 - 1u);
                                    let _e659 = (_e658 % 128u);
                                    let _e660 = (_e659 < 128u);
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e662 = local_7[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e664 = local_6[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e666 = local_5[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e668 = local_4[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e670 = local_3[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e672 = local_2[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e677 = local_8[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3896_ = true;
                                        break;
                                    }
                                    let _e680 = local_9[_e659];
                                    phi_1195_ = (_e680 <= _e645.member);
                                    phi_1196_ = type_50(type_32(vec4<f32>(_e662, _e664, _e666, 0f), vec4<f32>(_e668, _e670, _e672, 0f)), _e677);
                                    phi_1197_ = _e658;
                                }
                                let _e684 = phi_1195_;
                                let _e686 = phi_1196_;
                                let _e688 = phi_1197_;
                                if _e684 {
                                    if ((_e686.member_1 & 2147483648u) != 0u) {
                                        phi_1215_ = _e645;
                                        phi_1218_ = type_7(0u, ((_e686.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1137 = phi_1215_;
                                            let _e1139 = phi_1218_;
                                            local_10 = _e1137;
                                            local_12 = _e1137;
                                            if (_e1139.member < _e1139.member_1) {
                                                phi_1219_ = type_7((_e1139.member + 1u), _e1139.member_1);
                                                phi_1241_ = type_7(1u, _e1139.member);
                                            } else {
                                                phi_1219_ = _e1139;
                                                phi_1241_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1152 = phi_1219_;
                                            let _e1154 = phi_1241_;
                                            let _e1158 = (bitcast<i32>(_e1154.member) != 0i);
                                            if _e1158 {
                                                let _e1159 = ((_e686.member_1 & 268435455u) + _e1154.member_1);
                                                let _e1160 = (_e1159 < _e93);
                                                if _e1160 {
                                                    if _e1160 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1164 = global_2.member[_e1159].member_1;
                                                    phi_1262_ = _e1164;
                                                } else {
                                                    phi_1262_ = 4294967295u;
                                                }
                                                let _e1166 = phi_1262_;
                                                if (_e1159 >= _e93) {
                                                    phi_1354_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1160 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    if (_e607 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1173 = global_2.member[_e1159].member[_e607];
                                                    if (_e613 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1179 = global_2.member[_e1159].member[_e613];
                                                    if (_e619 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1185 = global_2.member[_e1159].member[_e619];
                                                    let _e1187 = (3u + _e607);
                                                    if (_e1187 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1193 = global_2.member[_e1159].member[_e1187];
                                                    let _e1194 = (3u + _e613);
                                                    if (_e1194 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1200 = global_2.member[_e1159].member[_e1194];
                                                    let _e1201 = (3u + _e619);
                                                    if (_e1201 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1207 = global_2.member[_e1159].member[_e1201];
                                                    let _e1209 = (6u + _e607);
                                                    if (_e1209 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1215 = global_2.member[_e1159].member[_e1209];
                                                    let _e1216 = (6u + _e613);
                                                    if (_e1216 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1222 = global_2.member[_e1159].member[_e1216];
                                                    let _e1223 = (6u + _e619);
                                                    if (_e1223 < 9u) {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1229 = global_2.member[_e1159].member[_e1223];
                                                    phi_1354_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1173, _e1179, _e1185), array<f32, 3>(_e1193, _e1200, _e1207), array<f32, 3>(_e1215, _e1222, _e1229));
                                                }
                                                let _e1233 = phi_1354_;
                                                let _e1249 = (_e1233[0][2] - _e458);
                                                let _e1252 = (((_e1233[0][0] - _e325) * _e494) - (_e1249 * _e362));
                                                let _e1255 = (((_e1233[0][1] - _e392) * _e494) - (_e1249 * _e428));
                                                let _e1258 = (_e1233[1][2] - _e458);
                                                let _e1261 = (((_e1233[1][0] - _e325) * _e494) - (_e1258 * _e362));
                                                let _e1264 = (((_e1233[1][1] - _e392) * _e494) - (_e1258 * _e428));
                                                let _e1267 = (_e1233[2][2] - _e458);
                                                let _e1270 = (((_e1233[2][0] - _e325) * _e494) - (_e1267 * _e362));
                                                let _e1273 = (((_e1233[2][1] - _e392) * _e494) - (_e1267 * _e428));
                                                let _e1274 = (_e1270 * _e1264);
                                                let _e1275 = (_e1273 * _e1261);
                                                let _e1276 = (_e1252 * _e1273);
                                                let _e1277 = (_e1255 * _e1270);
                                                let _e1278 = (_e1261 * _e1255);
                                                let _e1279 = (_e1264 * _e1252);
                                                let _e1284 = (((_e1274 >= _e1275) && (_e1276 >= _e1277)) && (_e1278 >= _e1279));
                                                let _e1290 = (_e1284 || (((_e1274 <= _e1275) && (_e1276 <= _e1277)) && (_e1278 <= _e1279)));
                                                if _e1290 {
                                                    let _e1292 = select(-1f, 1f, _e1284);
                                                    let _e1294 = ((_e1274 - _e1275) * _e1292);
                                                    let _e1296 = select(0f, _e1294, (_e1294 > 0f));
                                                    let _e1298 = ((_e1276 - _e1277) * _e1292);
                                                    let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                                                    let _e1302 = ((_e1278 - _e1279) * _e1292);
                                                    let _e1304 = select(0f, _e1302, (_e1302 > 0f));
                                                    let _e1306 = ((_e1296 + _e1300) + _e1304);
                                                    let _e1308 = select(_e1233[1][0], _e1233[0][0], (_e1233[0][0] < _e1233[1][0]));
                                                    let _e1312 = select(_e1233[1][0], _e1233[0][0], (_e1233[0][0] > _e1233[1][0]));
                                                    let _e1316 = select(_e1233[1][1], _e1233[0][1], (_e1233[0][1] < _e1233[1][1]));
                                                    let _e1320 = select(_e1233[1][1], _e1233[0][1], (_e1233[0][1] > _e1233[1][1]));
                                                    let _e1324 = select(_e1233[1][2], _e1233[0][2], (_e1233[0][2] < _e1233[1][2]));
                                                    let _e1328 = select(_e1233[1][2], _e1233[0][2], (_e1233[0][2] > _e1233[1][2]));
                                                    let _e1333 = ((select(_e1233[2][0], _e1308, (_e1308 < _e1233[2][0])) - _e363) * _e366);
                                                    let _e1334 = ((select(_e1233[2][0], _e1312, (_e1312 > _e1233[2][0])) - _e364) * _e366);
                                                    let _e1337 = ((select(_e1233[2][1], _e1316, (_e1316 < _e1233[2][1])) - _e429) * _e432);
                                                    let _e1338 = ((select(_e1233[2][1], _e1320, (_e1320 > _e1233[2][1])) - _e430) * _e432);
                                                    let _e1341 = ((select(_e1233[2][2], _e1324, (_e1324 < _e1233[2][2])) - _e495) * _e498);
                                                    let _e1342 = ((select(_e1233[2][2], _e1328, (_e1328 > _e1233[2][2])) - _e496) * _e498);
                                                    let _e1344 = select(_e1342, _e1341, (_e1341 < _e1342));
                                                    let _e1346 = select(_e1342, _e1341, (_e1341 > _e1342));
                                                    let _e1348 = select(_e1334, _e1333, (_e1333 < _e1334));
                                                    let _e1350 = select(_e1338, _e1337, (_e1337 < _e1338));
                                                    let _e1352 = select(_e1350, _e1348, (_e1348 > _e1350));
                                                    let _e1354 = select(_e1344, _e1352, (_e1352 > _e1344));
                                                    let _e1356 = select(_e1334, _e1333, (_e1333 > _e1334));
                                                    let _e1358 = select(_e1338, _e1337, (_e1337 > _e1338));
                                                    let _e1360 = select(_e1358, _e1356, (_e1356 < _e1358));
                                                    let _e1362 = select(_e1346, _e1360, (_e1360 < _e1346));
                                                    let _e1363 = -(_e1344);
                                                    let _e1369 = select(_e601, _e1354, (_e1354 > _e601));
                                                    let _e1373 = select(_e1261, _e1252, (_e1252 < _e1261));
                                                    let _e1378 = select(_e1261, _e1252, (_e1252 > _e1261));
                                                    let _e1385 = select(_e1264, _e1255, (_e1255 < _e1264));
                                                    let _e1390 = select(_e1264, _e1255, (_e1255 > _e1264));
                                                    let _e1399 = (((((_e1290 && (_e1306 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1270, _e1373, (_e1373 < _e1270)) <= 0f) && (select(_e1270, _e1378, (_e1378 > _e1270)) >= 0f))) && ((select(_e1273, _e1385, (_e1385 < _e1273)) <= 0f) && (select(_e1273, _e1390, (_e1390 > _e1273)) >= 0f))) && (_e1369 <= (_e1362 + (select(_e1363, _e1346, (_e1346 > _e1363)) * 0.0000019073523f)))) && (_e1369 <= _e1137.member));
                                                    if _e1399 {
                                                        let _e1404 = (_e1233[1][0] - _e1233[0][0]);
                                                        let _e1405 = (_e1233[1][1] - _e1233[0][1]);
                                                        let _e1406 = (_e1233[1][2] - _e1233[0][2]);
                                                        let _e1407 = vec3<f32>(_e1404, _e1405, _e1406);
                                                        let _e1408 = (_e1233[2][0] - _e1233[1][0]);
                                                        let _e1409 = (_e1233[2][1] - _e1233[1][1]);
                                                        let _e1410 = (_e1233[2][2] - _e1233[1][2]);
                                                        let _e1411 = vec3<f32>(_e1408, _e1409, _e1410);
                                                        let _e1412 = (_e1233[0][0] - _e1233[2][0]);
                                                        let _e1413 = (_e1233[0][1] - _e1233[2][1]);
                                                        let _e1414 = (_e1233[0][2] - _e1233[2][2]);
                                                        let _e1415 = vec3<f32>(_e1412, _e1413, _e1414);
                                                        let _e1418 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                        let _e1421 = bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u));
                                                        let _e1423 = select(_e1421, _e1418, (_e1418 > _e1421));
                                                        let _e1426 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                        let _e1428 = select(_e1426, _e1423, (_e1423 > _e1426));
                                                        let _e1431 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1434 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                        let _e1436 = select(_e1434, _e1431, (_e1431 > _e1434));
                                                        let _e1439 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                        let _e1441 = select(_e1439, _e1436, (_e1436 > _e1439));
                                                        let _e1444 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                        let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                        let _e1452 = bitcast<f32>((bitcast<u32>(_e1414) & 2147483647u));
                                                        let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                        let _e1456 = select(_e1441, _e1428, (_e1428 > _e1441));
                                                        let _e1458 = select(_e1454, _e1456, (_e1456 > _e1454));
                                                        if (_e1428 == _e1458) {
                                                            phi_1884_ = _e1264;
                                                            phi_1885_ = _e1261;
                                                            phi_1886_ = _e1255;
                                                            phi_1887_ = _e1252;
                                                            phi_1888_ = vec3<f32>(_e1233[0][0], _e1233[0][1], _e1233[0][2]);
                                                            phi_1889_ = _e1415;
                                                            phi_1890_ = _e1411;
                                                            phi_1891_ = _e1407;
                                                        } else {
                                                            let _e1460 = (_e1441 == _e1458);
                                                            let _e1465 = vec3(_e1460);
                                                            phi_1884_ = select(_e1255, _e1273, _e1460);
                                                            phi_1885_ = select(_e1252, _e1270, _e1460);
                                                            phi_1886_ = select(_e1273, _e1264, _e1460);
                                                            phi_1887_ = select(_e1270, _e1261, _e1460);
                                                            phi_1888_ = select(vec3<f32>(_e1233[2][0], _e1233[2][1], _e1233[2][2]), vec3<f32>(_e1233[1][0], _e1233[1][1], _e1233[1][2]), _e1465);
                                                            phi_1889_ = select(_e1411, _e1407, _e1465);
                                                            phi_1890_ = select(_e1407, _e1415, _e1465);
                                                            phi_1891_ = select(_e1415, _e1411, _e1465);
                                                        }
                                                        let _e1471 = phi_1884_;
                                                        let _e1473 = phi_1885_;
                                                        let _e1475 = phi_1886_;
                                                        let _e1477 = phi_1887_;
                                                        let _e1479 = phi_1888_;
                                                        let _e1481 = phi_1889_;
                                                        let _e1483 = phi_1890_;
                                                        let _e1485 = phi_1891_;
                                                        let _e1492 = ((_e1483.y * _e1481.z) - (_e1481.y * _e1483.z));
                                                        let _e1497 = ((_e1483.z * _e1481.x) - (_e1481.z * _e1483.x));
                                                        let _e1500 = ((_e1483.x * _e1481.y) - (_e1481.x * _e1483.y));
                                                        let _e1503 = ((_e1296 >= _e1300) && (_e1296 >= _e1304));
                                                        let _e1504 = (_e1300 >= _e1304);
                                                        let _e1518 = (((_e1492 * (select(select(_e1233[2][0], _e1233[1][0], _e1504), _e1233[0][0], _e1503) - _e325)) + (_e1497 * (select(select(_e1233[2][1], _e1233[1][1], _e1504), _e1233[0][1], _e1503) - _e392))) + (_e1500 * (select(select(_e1233[2][2], _e1233[1][2], _e1504), _e1233[0][2], _e1503) - _e458)));
                                                        let _e1523 = (((_e1492 * _e362) + (_e1497 * _e428)) + (_e1500 * _e494));
                                                        let _e1524 = (_e1473 - _e1477);
                                                        let _e1525 = (_e1471 - _e1475);
                                                        let _e1528 = ((_e1524 * _e1524) + (_e1525 * _e1525));
                                                        let _e1535 = (-(((_e1477 * _e1524) + (_e1475 * _e1525))) / select(0.000000000000000000000000000000000000011754944f, _e1528, (_e1528 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1537 = select(1f, _e1535, (_e1535 < 1f));
                                                        let _e1539 = select(0f, _e1537, (_e1537 > 0f));
                                                        let _e1548 = ((_e1479.x + (_e1485.x * _e1539)) - _e325);
                                                        let _e1551 = ((_e1479.y + (_e1485.y * _e1539)) - _e392);
                                                        let _e1554 = ((_e1479.z + (_e1485.z * _e1539)) - _e458);
                                                        let _e1557 = bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u));
                                                        let _e1560 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                        let _e1562 = select(_e1560, _e1557, (_e1557 > _e1560));
                                                        let _e1565 = bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u));
                                                        let _e1567 = select(_e1565, _e1562, (_e1562 > _e1565));
                                                        let _e1573 = bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u));
                                                        let _e1576 = bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u));
                                                        let _e1578 = select(_e1576, _e1573, (_e1573 > _e1576));
                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
                                                        let _e1600 = bitcast<f32>((bitcast<u32>(_e1483.x) & 2147483647u));
                                                        let _e1603 = bitcast<f32>((bitcast<u32>(_e1483.y) & 2147483647u));
                                                        let _e1605 = select(_e1603, _e1600, (_e1600 > _e1603));
                                                        let _e1608 = bitcast<f32>((bitcast<u32>(_e1483.z) & 2147483647u));
                                                        let _e1614 = bitcast<f32>((bitcast<u32>(_e1481.x) & 2147483647u));
                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1481.y) & 2147483647u));
                                                        let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1481.z) & 2147483647u));
                                                        let _e1628 = ((bitcast<f32>((bitcast<u32>(((((_e1492 * _e1548) + (_e1497 * _e1551)) + (_e1500 * _e1554)) - _e1518)) & 2147483647u)) <= ((0.0000009536743f * select(_e1458, _e1567, (_e1567 > _e1458))) * select(_e1581, _e1578, (_e1578 > _e1581)))) && !((bitcast<f32>((bitcast<u32>(_e1523) & 2147483647u)) <= ((0.0000038146973f * select(_e1608, _e1605, (_e1605 > _e1608))) * select(_e1622, _e1619, (_e1619 > _e1622))))));
                                                        let _e1629 = (_e1518 / _e1523);
                                                        if (_e1399 && !(_e1628)) {
                                                            let _e1632 = (_e1554 / _e494);
                                                            let _e1640 = (((_e1492 * (_e1548 - (_e362 * _e1632))) + (_e1497 * (_e1551 - (_e428 * _e1632)))) / _e1523);
                                                            phi_2082_ = select(select(_e1632, (_e1632 + _e1640), (bitcast<f32>((bitcast<u32>(_e1640) & 2147483647u)) <= _e1458)), _e1629, _e1628);
                                                        } else {
                                                            phi_2082_ = _e1629;
                                                        }
                                                        let _e1649 = phi_2082_;
                                                        let _e1651 = select(_e1362, _e1649, (_e1649 < _e1362));
                                                        let _e1653 = select(_e1354, _e1651, (_e1651 > _e1354));
                                                        let _e1654 = (1f / _e1306);
                                                        phi_2102_ = type_39(_e1653, (_e1300 * _e1654), (_e1304 * _e1654), ((_e1399 && (_e1653 >= _e601)) && (_e1653 <= _e1137.member)));
                                                        phi_2103_ = type_39();
                                                    } else {
                                                        phi_2102_ = type_39();
                                                        phi_2103_ = type_39(0f, 0f, 0f, _e1399);
                                                    }
                                                    let _e1663 = phi_2102_;
                                                    let _e1665 = phi_2103_;
                                                    phi_2106_ = _e1663;
                                                    phi_2107_ = _e1665;
                                                    phi_2108_ = select(true, false, _e1399);
                                                } else {
                                                    phi_2106_ = type_39();
                                                    phi_2107_ = type_39(0f, 0f, 0f, _e1290);
                                                    phi_2108_ = true;
                                                }
                                                let _e1668 = phi_2106_;
                                                let _e1670 = phi_2107_;
                                                let _e1672 = phi_2108_;
                                                if _e1672 {
                                                    phi_2112_ = _e1670;
                                                } else {
                                                    phi_2112_ = _e1668;
                                                }
                                                let _e1674 = phi_2112_;
                                                if _e1674.member_3 {
                                                    phi_2121_ = type_28(_e1674.member, _e1674.member_1, _e1674.member_2, _e1166);
                                                } else {
                                                    phi_2121_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1681 = phi_2121_;
                                                if (_e1681.member_3 != 4294967295u) {
                                                    if (_e1166 != 4294967295u) {
                                                        phi_2132_ = type_43(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2132_ = _e1137;
                                                    }
                                                    let _e1686 = phi_2132_;
                                                    phi_2133_ = _e1686;
                                                } else {
                                                    phi_2133_ = _e1137;
                                                }
                                                let _e1688 = phi_2133_;
                                                phi_1216_ = _e1688;
                                            } else {
                                                phi_1216_ = type_43();
                                            }
                                            let _e1690 = phi_1216_;
                                            continue;
                                            continuing {
                                                phi_1215_ = _e1690;
                                                phi_1218_ = _e1152;
                                                phi_3746_ = _e643;
                                                break if !(_e1158);
                                            }
                                        }
                                        let _e1693 = phi_3746_;
                                        phi_3896_ = _e1693;
                                        if _e1693 {
                                            break;
                                        }
                                        let _e1695 = local_10;
                                        phi_3900_ = _e1693;
                                        let _e1843 = local_12;
                                        phi_3360_ = _e1843;
                                        phi_3361_ = false;
                                        phi_3362_ = _e686;
                                        phi_3363_ = select(_e688, 0u, (_e601 > _e1695.member));
                                    } else {
                                        if (_e686.member_1 >= _e91) {
                                            phi_2899_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e686.member_1 < _e91) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e700 = ((1u + _e261) % 4u);
                                            if (_e700 < 4u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e705 = global_4.member[_e686.member_1][_e700];
                                            let _e707 = (_e705 >> bitcast<u32>(11u));
                                            let _e709 = ((1u + _e260) % 4u);
                                            if (_e709 < 4u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e714 = global_4.member[_e686.member_1][_e709];
                                            let _e716 = (_e714 >> bitcast<u32>(11u));
                                            let _e718 = ((1u + _e262) % 4u);
                                            if (_e718 < 4u) {
                                            } else {
                                                phi_3896_ = true;
                                                break;
                                            }
                                            let _e723 = global_4.member[_e686.member_1][_e718];
                                            let _e725 = (_e723 >> bitcast<u32>(11u));
                                            let _e748 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.x - _e686.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e749 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.y - _e686.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e750 = (bitcast<f32>((bitcast<u32>((_e686.member.member_1.z - _e686.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e752 = select(_e141, _e748, (_e748 > _e141));
                                            let _e754 = select(_e141, _e749, (_e749 > _e141));
                                            let _e756 = select(_e141, _e750, (_e750 > _e141));
                                            let _e787 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e705 & 1023u))) - 8388608f) * _e752));
                                            let _e792 = (bitcast<i32>((_e705 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e795 = bitcast<f32>((_e787 & bitcast<u32>(_e792)));
                                            let _e796 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e714 & 1023u))) - 8388608f) * _e754));
                                            let _e801 = (bitcast<i32>((_e714 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e804 = bitcast<f32>((_e796 & bitcast<u32>(_e801)));
                                            let _e805 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 1023u))) - 8388608f) * _e756));
                                            let _e810 = (bitcast<i32>((_e723 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e813 = bitcast<f32>((_e805 & bitcast<u32>(_e810)));
                                            let _e817 = bitcast<f32>((_e787 & bitcast<u32>(~(_e792))));
                                            let _e821 = bitcast<f32>((_e796 & bitcast<u32>(~(_e801))));
                                            let _e825 = bitcast<f32>((_e805 & bitcast<u32>(~(_e810))));
                                            let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e707 & 1023u))) - 8388608f) * _e752));
                                            let _e831 = (bitcast<i32>((_e707 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                            let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e716 & 1023u))) - 8388608f) * _e754));
                                            let _e840 = (bitcast<i32>((_e716 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                            let _e844 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 1023u))) - 8388608f) * _e756));
                                            let _e849 = (bitcast<i32>((_e725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e852 = bitcast<f32>((_e844 & bitcast<u32>(_e849)));
                                            let _e856 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                            let _e860 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                            let _e864 = bitcast<f32>((_e844 & bitcast<u32>(~(_e849))));
                                            let _e894 = global_4.member[_e686.member_1][0u];
                                            let _e898 = global_4.member[_e686.member_1][1u];
                                            let _e902 = global_4.member[_e686.member_1][2u];
                                            let _e906 = global_4.member[_e686.member_1][3u];
                                            let _e918 = (((_e898 >> bitcast<u32>(22i)) | ((_e902 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e906 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e919 = (_e894 & 268435455u);
                                            let _e920 = (_e918 & 268435455u);
                                            let _e923 = ((_e894 >> bitcast<u32>(28u)) & 7u);
                                            let _e931 = ((_e894 >> bitcast<u32>(31i)) | (((_e918 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e932 = (_e923 != 0u);
                                            if (_e923 == 0u) {
                                                phi_2861_ = _e919;
                                            } else {
                                                if (_e923 == 7u) {
                                                    phi_2860_ = 2147483648u;
                                                } else {
                                                    phi_2860_ = ((2147483648u | (_e923 << bitcast<u32>(28u))) | (_e920 & 268435455u));
                                                }
                                                let _e941 = phi_2860_;
                                                phi_2861_ = _e941;
                                            }
                                            let _e943 = phi_2861_;
                                            if _e932 {
                                                let _e944 = (_e923 != 7u);
                                                if _e944 {
                                                    phi_2871_ = (_e920 + _e923);
                                                } else {
                                                    phi_2871_ = u32();
                                                }
                                                let _e947 = phi_2871_;
                                                phi_2873_ = _e947;
                                                phi_2874_ = select(true, false, _e944);
                                            } else {
                                                phi_2873_ = u32();
                                                phi_2874_ = true;
                                            }
                                            let _e950 = phi_2873_;
                                            let _e952 = phi_2874_;
                                            if (_e931 == 0u) {
                                                phi_2895_ = (_e919 + select(0u, 1u, !(_e932)));
                                            } else {
                                                if (_e931 == 7u) {
                                                    phi_2894_ = 2147483648u;
                                                } else {
                                                    phi_2894_ = ((2147483648u | (_e931 << bitcast<u32>(28u))) | (select(_e950, _e920, _e952) & 268435455u));
                                                }
                                                let _e965 = phi_2894_;
                                                phi_2895_ = _e965;
                                            }
                                            let _e967 = phi_2895_;
                                            phi_2899_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e686.member.member.x + _e795), (_e686.member.member.x + _e817), (_e686.member.member_1.x - _e834), (_e686.member.member_1.x - _e856)), vec4<f32>((_e686.member.member.y + _e804), (_e686.member.member.y + _e821), (_e686.member.member_1.y - _e843), (_e686.member.member_1.y - _e860)), vec4<f32>((_e686.member.member.z + _e813), (_e686.member.member.z + _e825), (_e686.member.member_1.z - _e852), (_e686.member.member_1.z - _e864))), type_50(type_32((_e686.member.member + vec4<f32>(_e795, _e804, _e813, 0f)), (_e686.member.member_1 - vec4<f32>(_e834, _e843, _e852, 0f))), _e943), type_50(type_32((_e686.member.member + vec4<f32>(_e817, _e821, _e825, 0f)), (_e686.member.member_1 - vec4<f32>(_e856, _e860, _e864, 0f))), _e967));
                                        }
                                        let _e972 = phi_2899_;
                                        let _e984 = ((_e972.member[0].x - _e363) * _e366);
                                        let _e985 = ((_e972.member[0].y - _e363) * _e366);
                                        let _e986 = ((_e972.member[0].z - _e364) * _e366);
                                        let _e987 = ((_e972.member[0].w - _e364) * _e366);
                                        let _e997 = ((_e972.member[1].x - _e429) * _e432);
                                        let _e998 = ((_e972.member[1].y - _e429) * _e432);
                                        let _e999 = ((_e972.member[1].z - _e430) * _e432);
                                        let _e1000 = ((_e972.member[1].w - _e430) * _e432);
                                        let _e1010 = ((_e972.member[2].x - _e495) * _e498);
                                        let _e1011 = ((_e972.member[2].y - _e495) * _e498);
                                        let _e1012 = ((_e972.member[2].z - _e496) * _e498);
                                        let _e1013 = ((_e972.member[2].w - _e496) * _e498);
                                        let _e1015 = select(_e1012, _e1010, (_e1010 < _e1012));
                                        let _e1017 = select(_e1013, _e1011, (_e1011 < _e1013));
                                        let _e1019 = select(_e1012, _e1010, (_e1010 > _e1012));
                                        let _e1021 = select(_e1013, _e1011, (_e1011 > _e1013));
                                        let _e1023 = select(_e986, _e984, (_e984 < _e986));
                                        let _e1025 = select(_e987, _e985, (_e985 < _e987));
                                        let _e1027 = select(_e999, _e997, (_e997 < _e999));
                                        let _e1029 = select(_e1000, _e998, (_e998 < _e1000));
                                        let _e1031 = select(_e1027, _e1023, (_e1023 > _e1027));
                                        let _e1033 = select(_e1029, _e1025, (_e1025 > _e1029));
                                        let _e1035 = select(_e1015, _e1031, (_e1031 > _e1015));
                                        let _e1037 = select(_e1017, _e1033, (_e1033 > _e1017));
                                        let _e1039 = select(_e986, _e984, (_e984 > _e986));
                                        let _e1041 = select(_e987, _e985, (_e985 > _e987));
                                        let _e1043 = select(_e999, _e997, (_e997 > _e999));
                                        let _e1045 = select(_e1000, _e998, (_e998 > _e1000));
                                        let _e1047 = select(_e1043, _e1039, (_e1039 < _e1043));
                                        let _e1049 = select(_e1045, _e1041, (_e1041 < _e1045));
                                        let _e1054 = -(_e1015);
                                        let _e1055 = -(_e1017);
                                        let _e1062 = (select(_e1019, _e1047, (_e1047 < _e1019)) + (select(_e1054, _e1019, (_e1019 > _e1054)) * 0.0000019073523f));
                                        let _e1063 = (select(_e1021, _e1049, (_e1049 < _e1021)) + (select(_e1055, _e1021, (_e1021 > _e1055)) * 0.0000019073523f));
                                        let _e1065 = select(_e601, _e1035, (_e1035 > _e601));
                                        let _e1067 = select(_e601, _e1037, (_e1037 > _e601));
                                        let _e1072 = (_e1065 <= select(_e645.member, _e1062, (_e1062 < _e645.member)));
                                        let _e1073 = (_e1067 <= select(_e645.member, _e1063, (_e1063 < _e645.member)));
                                        let _e1074 = (_e1065 <= _e1067);
                                        if _e1072 {
                                            if _e1073 {
                                                if _e1074 {
                                                    phi_3261_ = _e972.member_2;
                                                } else {
                                                    phi_3261_ = _e972.member_1;
                                                }
                                                let _e1078 = phi_3261_;
                                                let _e1099 = (_e688 % 128u);
                                                let _e1100 = (_e1099 < 128u);
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_8[_e1099] = _e1078.member_1;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_7[_e1099] = _e1078.member.member.x;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_6[_e1099] = _e1078.member.member.y;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_5[_e1099] = _e1078.member.member.z;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_4[_e1099] = _e1078.member.member_1.x;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_3[_e1099] = _e1078.member.member_1.y;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_2[_e1099] = _e1078.member.member_1.z;
                                                if _e1100 {
                                                } else {
                                                    phi_3896_ = true;
                                                    break;
                                                }
                                                local_9[_e1099] = select(_e1065, _e1067, _e1074);
                                                if _e1074 {
                                                    phi_3337_ = _e972.member_1;
                                                } else {
                                                    phi_3337_ = _e972.member_2;
                                                }
                                                let _e1113 = phi_3337_;
                                                phi_3338_ = _e1113;
                                                phi_3339_ = (_e688 + 1u);
                                            } else {
                                                phi_3338_ = type_50();
                                                phi_3339_ = u32();
                                            }
                                            let _e1115 = phi_3338_;
                                            let _e1117 = phi_3339_;
                                            phi_3341_ = _e1115;
                                            phi_3342_ = _e1117;
                                            phi_3343_ = select(true, false, _e1073);
                                        } else {
                                            phi_3341_ = type_50();
                                            phi_3342_ = u32();
                                            phi_3343_ = true;
                                        }
                                        let _e1120 = phi_3341_;
                                        let _e1122 = phi_3342_;
                                        let _e1124 = phi_3343_;
                                        if _e1124 {
                                            if _e1072 {
                                                phi_3352_ = _e972.member_1;
                                            } else {
                                                phi_3352_ = _e972.member_2;
                                            }
                                            let _e1128 = phi_3352_;
                                            phi_3357_ = select(_e1073, true, _e1072);
                                            phi_3358_ = _e1128;
                                        } else {
                                            phi_3357_ = _e684;
                                            phi_3358_ = _e1120;
                                        }
                                        let _e1131 = phi_3357_;
                                        let _e1133 = phi_3358_;
                                        phi_3900_ = _e643;
                                        phi_3360_ = _e645;
                                        phi_3361_ = _e1131;
                                        phi_3362_ = _e1133;
                                        phi_3363_ = select(_e1122, _e688, _e1124);
                                    }
                                    let _e1700 = phi_3900_;
                                    let _e1702 = phi_3360_;
                                    let _e1704 = phi_3361_;
                                    let _e1706 = phi_3362_;
                                    let _e1708 = phi_3363_;
                                    phi_3899_ = _e1700;
                                    phi_3364_ = _e1702;
                                    phi_3365_ = _e1704;
                                    phi_3366_ = _e1706;
                                    phi_3367_ = _e1708;
                                    phi_3368_ = (_e653 - 1u);
                                } else {
                                    phi_3899_ = _e643;
                                    phi_3364_ = _e645;
                                    phi_3365_ = _e684;
                                    phi_3366_ = _e686;
                                    phi_3367_ = _e688;
                                    phi_3368_ = _e653;
                                }
                                let _e1710 = phi_3899_;
                                let _e1712 = phi_3364_;
                                let _e1714 = phi_3365_;
                                let _e1716 = phi_3366_;
                                let _e1718 = phi_3367_;
                                let _e1720 = phi_3368_;
                                phi_3898_ = _e1710;
                                phi_3369_ = _e1712;
                                phi_3370_ = _e1714;
                                phi_3371_ = _e1716;
                                phi_3372_ = _e1718;
                                phi_3373_ = _e1720;
                            } else {
                                phi_3898_ = _e643;
                                phi_3369_ = type_43();
                                phi_3370_ = bool();
                                phi_3371_ = type_50();
                                phi_3372_ = u32();
                                phi_3373_ = u32();
                            }
                            let _e1722 = phi_3898_;
                            let _e1724 = phi_3369_;
                            let _e1726 = phi_3370_;
                            let _e1728 = phi_3371_;
                            let _e1730 = phi_3372_;
                            let _e1732 = phi_3373_;
                            phi_3897_ = _e1722;
                            phi_1090_ = _e1724;
                            phi_1093_ = _e1726;
                            phi_1095_ = _e1728;
                            phi_1097_ = _e1730;
                            phi_1099_ = _e1732;
                            phi_3374_ = _e657;
                        } else {
                            phi_3897_ = _e643;
                            phi_1090_ = type_43();
                            phi_1093_ = bool();
                            phi_1095_ = type_50();
                            phi_1097_ = u32();
                            phi_1099_ = u32();
                            phi_3374_ = false;
                        }
                        let _e1734 = phi_3897_;
                        let _e1736 = phi_1090_;
                        let _e1738 = phi_1093_;
                        let _e1740 = phi_1095_;
                        let _e1742 = phi_1097_;
                        let _e1744 = phi_1099_;
                        let _e1746 = phi_3374_;
                        continue;
                        continuing {
                            phi_3752_ = _e1734;
                            phi_1089_ = _e1736;
                            phi_1092_ = _e1738;
                            phi_1094_ = _e1740;
                            phi_1096_ = _e1742;
                            phi_1098_ = _e1744;
                            phi_3896_ = _e1734;
                            break if !(_e1746);
                        }
                    }
                    let _e1749 = phi_3896_;
                    if _e1749 {
                        break;
                    }
                    let _e1751 = local_11;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147] = select(0u, 1u, _e1751.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
