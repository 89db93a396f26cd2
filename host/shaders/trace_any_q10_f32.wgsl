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
    var phi_393_: i32;
    var phi_394_: i32;
    var phi_404_: bool;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_417_: bool;
    var phi_422_: u32;
    var phi_435_: i32;
    var phi_455_: i32;
    var phi_473_: f32;
    var phi_479_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_644_: f32;
    var phi_650_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_769_: f32;
    var phi_775_: f32;
    var phi_894_: i32;
    var phi_916_: u32;
    var phi_917_: u32;
    var phi_954_: i32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_3824_: bool;
    var phi_1082_: type_43;
    var phi_1085_: u32;
    var phi_1087_: bool;
    var phi_1089_: u32;
    var phi_1091_: type_50;
    var phi_1102_: bool;
    var phi_1188_: bool;
    var phi_1189_: u32;
    var phi_1190_: type_50;
    var phi_1208_: type_43;
    var phi_1211_: type_7;
    var phi_1212_: type_7;
    var phi_1234_: type_7;
    var phi_1255_: u32;
    var phi_1347_: array<array<f32, 3>, 3>;
    var phi_3459_: bool;
    var phi_3474_: bool;
    var phi_3489_: bool;
    var phi_3504_: bool;
    var phi_3519_: bool;
    var phi_3534_: bool;
    var phi_1889_: f32;
    var phi_1890_: f32;
    var phi_1891_: f32;
    var phi_1892_: f32;
    var phi_1893_: vec3<f32>;
    var phi_1894_: vec3<f32>;
    var phi_1895_: vec3<f32>;
    var phi_1896_: vec3<f32>;
    var phi_3549_: bool;
    var phi_3564_: bool;
    var phi_3579_: bool;
    var phi_3594_: bool;
    var phi_3609_: bool;
    var phi_3624_: bool;
    var phi_2104_: f32;
    var phi_2124_: type_39;
    var phi_2125_: type_39;
    var phi_2128_: type_39;
    var phi_2129_: type_39;
    var phi_2130_: bool;
    var phi_2134_: type_39;
    var phi_2143_: type_28;
    var phi_2154_: type_43;
    var phi_2155_: type_43;
    var phi_1209_: type_43;
    var phi_3818_: bool;
    var phi_4066_: bool;
    var phi_2156_: type_43;
    var phi_2883_: u32;
    var phi_2884_: u32;
    var phi_2894_: u32;
    var phi_2896_: u32;
    var phi_2897_: bool;
    var phi_2917_: u32;
    var phi_2918_: u32;
    var phi_2922_: type_51;
    var phi_3284_: type_50;
    var phi_3360_: type_50;
    var phi_3361_: u32;
    var phi_3362_: type_50;
    var phi_3364_: u32;
    var phi_3365_: type_50;
    var phi_3366_: bool;
    var phi_3375_: type_50;
    var phi_3380_: bool;
    var phi_3382_: type_50;
    var phi_3386_: bool;
    var phi_3387_: u32;
    var phi_3388_: type_50;
    var phi_3398_: u32;
    var phi_3399_: type_50;
    var phi_3983_: bool;
    var phi_3400_: type_43;
    var phi_3401_: u32;
    var phi_3402_: bool;
    var phi_3403_: u32;
    var phi_3404_: type_50;
    var phi_3982_: bool;
    var phi_3405_: type_43;
    var phi_3406_: u32;
    var phi_3407_: bool;
    var phi_3408_: u32;
    var phi_3409_: type_50;
    var phi_3981_: bool;
    var phi_1083_: type_43;
    var phi_1086_: u32;
    var phi_1088_: bool;
    var phi_1090_: u32;
    var phi_1092_: type_50;
    var phi_3410_: bool;
    var phi_3980_: bool;
    var local_10: type_43;
    var local_11: type_43;

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
                            phi_393_ = (bitcast<i32>((_e226 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_393_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e226)), 32u, (_e226 == 0u))));
                        }
                        let _e240 = phi_393_;
                        phi_394_ = _e240;
                    } else {
                        phi_394_ = 0i;
                    }
                    let _e242 = phi_394_;
                    let _e243 = (_e159 == _e198);
                    if _e243 {
                        phi_404_ = true;
                    } else {
                        phi_404_ = (_e166 == _e198);
                    }
                    let _e246 = phi_404_;
                    let _e247 = select(1u, 0u, _e243);
                    if _e246 {
                        let _e248 = (_e247 + 1u);
                        phi_414_ = _e248;
                        phi_415_ = _e248;
                        phi_417_ = select(true, false, (_e248 == 2u));
                    } else {
                        phi_414_ = u32();
                        phi_415_ = 0u;
                        phi_417_ = true;
                    }
                    let _e252 = phi_414_;
                    let _e254 = phi_415_;
                    let _e256 = phi_417_;
                    if _e256 {
                        phi_422_ = (_e254 + 1u);
                    } else {
                        phi_422_ = 0u;
                    }
                    let _e260 = phi_422_;
                    let _e261 = select(_e252, _e254, _e256);
                    let _e262 = select(_e247, select(2u, _e247, _e246), _e256);
                    if (_e129 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e267 = phi_435_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e129 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e279 = -(_e242);
                    if (_e279 < -126i) {
                        phi_455_ = -126i;
                    } else {
                        phi_455_ = select(_e279, 127i, (_e279 > 127i));
                    }
                    let _e284 = phi_455_;
                    let _e289 = bitcast<f32>((bitcast<u32>((_e284 + 127i)) << bitcast<u32>(23i)));
                    let _e295 = bitcast<f32>((bitcast<u32>(((_e279 - _e284) + 127i)) << bitcast<u32>(23i)));
                    let _e299 = global_5.member[_e147].member;
                    let _e300 = (_e261 == 0u);
                    if _e300 {
                        phi_473_ = _e299[0];
                    } else {
                        phi_473_ = _e299[1];
                    }
                    let _e304 = phi_473_;
                    let _e305 = (_e261 == 2u);
                    if _e305 {
                        phi_479_ = _e299[2];
                    } else {
                        phi_479_ = _e304;
                    }
                    let _e308 = phi_479_;
                    let _e309 = bitcast<u32>(_e308);
                    let _e311 = ((_e309 & 2139095040u) != 0u);
                    let _e325 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * _e272) * select(0.00000011920929f, 1f, _e311)) * _e278);
                    let _e326 = global_5.member[_e147].member_2;
                    if _e300 {
                        phi_519_ = _e326[0];
                    } else {
                        phi_519_ = _e326[1];
                    }
                    let _e330 = phi_519_;
                    if _e305 {
                        phi_525_ = _e326[2];
                    } else {
                        phi_525_ = _e330;
                    }
                    let _e333 = phi_525_;
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
                        phi_598_ = _e299[0];
                    } else {
                        phi_598_ = _e299[1];
                    }
                    let _e371 = phi_598_;
                    let _e372 = (_e260 == 2u);
                    if _e372 {
                        phi_604_ = _e299[2];
                    } else {
                        phi_604_ = _e371;
                    }
                    let _e375 = phi_604_;
                    let _e376 = bitcast<u32>(_e375);
                    let _e378 = ((_e376 & 2139095040u) != 0u);
                    let _e392 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * _e272) * select(0.00000011920929f, 1f, _e378)) * _e278);
                    if _e367 {
                        phi_644_ = _e326[0];
                    } else {
                        phi_644_ = _e326[1];
                    }
                    let _e396 = phi_644_;
                    if _e372 {
                        phi_650_ = _e326[2];
                    } else {
                        phi_650_ = _e396;
                    }
                    let _e399 = phi_650_;
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
                        phi_723_ = _e299[0];
                    } else {
                        phi_723_ = _e299[1];
                    }
                    let _e437 = phi_723_;
                    let _e438 = (_e262 == 2u);
                    if _e438 {
                        phi_729_ = _e299[2];
                    } else {
                        phi_729_ = _e437;
                    }
                    let _e441 = phi_729_;
                    let _e442 = bitcast<u32>(_e441);
                    let _e444 = ((_e442 & 2139095040u) != 0u);
                    let _e458 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e442 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e442 & 2147483648u))), _e441, _e444) * _e272) * select(0.00000011920929f, 1f, _e444)) * _e278);
                    if _e433 {
                        phi_769_ = _e326[0];
                    } else {
                        phi_769_ = _e326[1];
                    }
                    let _e462 = phi_769_;
                    if _e438 {
                        phi_775_ = _e326[2];
                    } else {
                        phi_775_ = _e462;
                    }
                    let _e465 = phi_775_;
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
                            phi_894_ = 255i;
                        } else {
                            phi_894_ = (((_e516 + select(0i, 1i, (_e516 == 0i))) - _e523) + _e503);
                        }
                        let _e531 = phi_894_;
                        let _e541 = (_e531 <= 0i);
                        if _e541 {
                            phi_917_ = u32();
                        } else {
                            if _e520 {
                                phi_916_ = u32();
                            } else {
                                phi_916_ = select(((bitcast<u32>(_e531) << bitcast<u32>(23i)) | ((_e513 << bitcast<u32>(((_e523 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e531 >= 255i));
                            }
                            let _e545 = phi_916_;
                            phi_917_ = _e545;
                        }
                        let _e547 = phi_917_;
                        let _e559 = ((_e219 & 8388607u) | (select(0u, 1u, ((_e219 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e562 = bitcast<i32>((_e219 >> bitcast<u32>(23i)));
                        let _e566 = (_e559 == 0u);
                        let _e569 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e559)), 32u, _e566)) - 8i);
                        if (_e562 == 255i) {
                            phi_954_ = 255i;
                        } else {
                            phi_954_ = (((_e562 + select(0i, 1i, (_e562 == 0i))) - _e569) + _e503);
                        }
                        let _e577 = phi_954_;
                        let _e587 = (_e577 <= 0i);
                        if _e587 {
                            phi_977_ = u32();
                        } else {
                            if _e566 {
                                phi_976_ = u32();
                            } else {
                                phi_976_ = select(((bitcast<u32>(_e577) << bitcast<u32>(23i)) | ((_e559 << bitcast<u32>(((_e569 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e577 >= 255i));
                            }
                            let _e591 = phi_976_;
                            phi_977_ = _e591;
                        }
                        let _e593 = phi_977_;
                        phi_985_ = bitcast<f32>(((_e218 & 2147483648u) | select(_e593, 0u, select(_e566, true, _e587))));
                        phi_986_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e547, 0u, select(_e520, true, _e541))));
                    } else {
                        phi_985_ = 0f;
                        phi_986_ = 1f;
                    }
                    let _e599 = phi_985_;
                    let _e601 = phi_986_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e605 = (_e261 % 3u);
                    let _e606 = (_e605 < 3u);
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e608 = local_1[_e605];
                    let _e611 = (_e260 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e262 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    if _e606 {
                    } else {
                        break;
                    }
                    let _e625 = local[_e605];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e629 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e617];
                    phi_3824_ = false;
                    phi_1082_ = type_43(_e599, false);
                    phi_1085_ = ((3u * _e91) + 1u);
                    phi_1087_ = (_e601 <= _e599);
                    phi_1089_ = 0u;
                    phi_1091_ = type_50(type_32(vec4<f32>((f32(_e608) * _e141), (f32(_e614) * _e141), (f32(_e620) * _e141), 0f), vec4<f32>((f32(_e625) * _e141), (f32(_e629) * _e141), (f32(_e633) * _e141), 0f)), select(0u, 2147483648u, (_e91 == 0u)));
                    loop {
                        let _e643 = phi_3824_;
                        let _e645 = phi_1082_;
                        let _e647 = phi_1085_;
                        let _e649 = phi_1087_;
                        let _e651 = phi_1089_;
                        let _e653 = phi_1091_;
                        local_10 = _e645;
                        if _e649 {
                            phi_1102_ = true;
                        } else {
                            phi_1102_ = (_e651 > 0u);
                        }
                        let _e656 = phi_1102_;
                        if _e656 {
                            let _e657 = (_e647 > 0u);
                            if _e657 {
                                if _e649 {
                                    phi_1188_ = _e649;
                                    phi_1189_ = _e651;
                                    phi_1190_ = _e653;
                                } else {
                                    let _e658 = (_e651 - 1u);
                                    let _e659 = (_e658 % 128u);
                                    let _e660 = (_e659 < 128u);
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e662 = local_7[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e664 = local_6[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e666 = local_5[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e668 = local_4[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e670 = local_3[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e672 = local_2[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e677 = local_8[_e659];
                                    if _e660 {
                                    } else {
                                        phi_3980_ = true;
                                        break;
                                    }
                                    let _e680 = local_9[_e659];
                                    phi_1188_ = (_e680 <= _e645.member);
                                    phi_1189_ = _e658;
                                    phi_1190_ = type_50(type_32(vec4<f32>(_e662, _e664, _e666, 0f), vec4<f32>(_e668, _e670, _e672, 0f)), _e677);
                                }
                                let _e684 = phi_1188_;
                                let _e686 = phi_1189_;
                                let _e688 = phi_1190_;
                                if _e684 {
                                    let _e692 = ((_e688.member_1 & 2147483648u) != 0u);
                                    if _e692 {
                                        phi_1208_ = _e645;
                                        phi_1211_ = type_7(0u, ((_e688.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e699 = phi_1208_;
                                            let _e701 = phi_1211_;
                                            local_11 = _e699;
                                            if (_e701.member < _e701.member_1) {
                                                phi_1212_ = type_7((_e701.member + 1u), _e701.member_1);
                                                phi_1234_ = type_7(1u, _e701.member);
                                            } else {
                                                phi_1212_ = _e701;
                                                phi_1234_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e714 = phi_1212_;
                                            let _e716 = phi_1234_;
                                            let _e720 = (bitcast<i32>(_e716.member) != 0i);
                                            if _e720 {
                                                let _e721 = ((_e688.member_1 & 268435455u) + _e716.member_1);
                                                let _e722 = (_e721 < _e93);
                                                if _e722 {
                                                    if _e722 {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e726 = global_2.member[_e721].member_1;
                                                    phi_1255_ = _e726;
                                                } else {
                                                    phi_1255_ = 4294967295u;
                                                }
                                                let _e728 = phi_1255_;
                                                if (_e721 >= _e93) {
                                                    phi_1347_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e722 {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    if (_e605 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e735 = global_2.member[_e721].member[_e605];
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e741 = global_2.member[_e721].member[_e611];
                                                    if (_e617 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e747 = global_2.member[_e721].member[_e617];
                                                    let _e749 = (3u + _e605);
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e755 = global_2.member[_e721].member[_e749];
                                                    let _e756 = (3u + _e611);
                                                    if (_e756 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_2.member[_e721].member[_e756];
                                                    let _e763 = (3u + _e617);
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e721].member[_e763];
                                                    let _e771 = (6u + _e605);
                                                    if (_e771 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e777 = global_2.member[_e721].member[_e771];
                                                    let _e778 = (6u + _e611);
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_2.member[_e721].member[_e778];
                                                    let _e785 = (6u + _e617);
                                                    if (_e785 < 9u) {
                                                    } else {
                                                        phi_3818_ = true;
                                                        break;
                                                    }
                                                    let _e791 = global_2.member[_e721].member[_e785];
                                                    phi_1347_ = array<array<f32, 3>, 3>(array<f32, 3>(_e735, _e741, _e747), array<f32, 3>(_e755, _e762, _e769), array<f32, 3>(_e777, _e784, _e791));
                                                }
                                                let _e795 = phi_1347_;
                                                let _e811 = (_e795[0][2] - _e458);
                                                let _e814 = (((_e795[0][0] - _e325) * _e494) - (_e811 * _e362));
                                                let _e817 = (((_e795[0][1] - _e392) * _e494) - (_e811 * _e428));
                                                let _e820 = (_e795[1][2] - _e458);
                                                let _e823 = (((_e795[1][0] - _e325) * _e494) - (_e820 * _e362));
                                                let _e826 = (((_e795[1][1] - _e392) * _e494) - (_e820 * _e428));
                                                let _e829 = (_e795[2][2] - _e458);
                                                let _e832 = (((_e795[2][0] - _e325) * _e494) - (_e829 * _e362));
                                                let _e835 = (((_e795[2][1] - _e392) * _e494) - (_e829 * _e428));
                                                let _e836 = (_e832 * _e826);
                                                let _e837 = (_e835 * _e823);
                                                let _e838 = (_e814 * _e835);
                                                let _e839 = (_e817 * _e832);
                                                let _e840 = (_e823 * _e817);
                                                let _e841 = (_e826 * _e814);
                                                let _e846 = (((_e836 >= _e837) && (_e838 >= _e839)) && (_e840 >= _e841));
                                                let _e852 = (_e846 || (((_e836 <= _e837) && (_e838 <= _e839)) && (_e840 <= _e841)));
                                                if _e852 {
                                                    let _e854 = select(-1f, 1f, _e846);
                                                    let _e856 = ((_e836 - _e837) * _e854);
                                                    let _e858 = select(0f, _e856, (_e856 > 0f));
                                                    let _e860 = ((_e838 - _e839) * _e854);
                                                    let _e862 = select(0f, _e860, (_e860 > 0f));
                                                    let _e864 = ((_e840 - _e841) * _e854);
                                                    let _e866 = select(0f, _e864, (_e864 > 0f));
                                                    let _e868 = ((_e858 + _e862) + _e866);
                                                    let _e870 = select(_e795[1][0], _e795[0][0], (_e795[0][0] < _e795[1][0]));
                                                    let _e874 = select(_e795[1][0], _e795[0][0], (_e795[0][0] > _e795[1][0]));
                                                    let _e878 = select(_e795[1][1], _e795[0][1], (_e795[0][1] < _e795[1][1]));
                                                    let _e882 = select(_e795[1][1], _e795[0][1], (_e795[0][1] > _e795[1][1]));
                                                    let _e886 = select(_e795[1][2], _e795[0][2], (_e795[0][2] < _e795[1][2]));
                                                    let _e890 = select(_e795[1][2], _e795[0][2], (_e795[0][2] > _e795[1][2]));
                                                    let _e895 = ((select(_e795[2][0], _e870, (_e870 < _e795[2][0])) - _e363) * _e366);
                                                    let _e896 = ((select(_e795[2][0], _e874, (_e874 > _e795[2][0])) - _e364) * _e366);
                                                    let _e899 = ((select(_e795[2][1], _e878, (_e878 < _e795[2][1])) - _e429) * _e432);
                                                    let _e900 = ((select(_e795[2][1], _e882, (_e882 > _e795[2][1])) - _e430) * _e432);
                                                    let _e903 = ((select(_e795[2][2], _e886, (_e886 < _e795[2][2])) - _e495) * _e498);
                                                    let _e904 = ((select(_e795[2][2], _e890, (_e890 > _e795[2][2])) - _e496) * _e498);
                                                    let _e906 = select(_e904, _e903, (_e903 < _e904));
                                                    let _e908 = select(_e904, _e903, (_e903 > _e904));
                                                    let _e910 = select(_e896, _e895, (_e895 < _e896));
                                                    let _e912 = select(_e900, _e899, (_e899 < _e900));
                                                    let _e914 = select(_e912, _e910, (_e910 > _e912));
                                                    let _e916 = select(_e906, _e914, (_e914 > _e906));
                                                    let _e918 = select(_e896, _e895, (_e895 > _e896));
                                                    let _e920 = select(_e900, _e899, (_e899 > _e900));
                                                    let _e922 = select(_e920, _e918, (_e918 < _e920));
                                                    let _e924 = select(_e908, _e922, (_e922 < _e908));
                                                    let _e925 = -(_e906);
                                                    let _e931 = select(_e601, _e916, (_e916 > _e601));
                                                    let _e935 = select(_e823, _e814, (_e814 < _e823));
                                                    let _e940 = select(_e823, _e814, (_e814 > _e823));
                                                    let _e947 = select(_e826, _e817, (_e817 < _e826));
                                                    let _e952 = select(_e826, _e817, (_e817 > _e826));
                                                    let _e961 = (((((_e852 && (_e868 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e832, _e935, (_e935 < _e832)) <= 0f) && (select(_e832, _e940, (_e940 > _e832)) >= 0f))) && ((select(_e835, _e947, (_e947 < _e835)) <= 0f) && (select(_e835, _e952, (_e952 > _e835)) >= 0f))) && (_e931 <= (_e924 + (select(_e925, _e908, (_e908 > _e925)) * 0.0000019073523f)))) && (_e931 <= _e699.member));
                                                    if _e961 {
                                                        let _e966 = (_e795[1][0] - _e795[0][0]);
                                                        let _e967 = (_e795[1][1] - _e795[0][1]);
                                                        let _e968 = (_e795[1][2] - _e795[0][2]);
                                                        let _e969 = vec3<f32>(_e966, _e967, _e968);
                                                        let _e970 = (_e795[2][0] - _e795[1][0]);
                                                        let _e971 = (_e795[2][1] - _e795[1][1]);
                                                        let _e972 = (_e795[2][2] - _e795[1][2]);
                                                        let _e973 = vec3<f32>(_e970, _e971, _e972);
                                                        let _e974 = (_e795[0][0] - _e795[2][0]);
                                                        let _e975 = (_e795[0][1] - _e795[2][1]);
                                                        let _e976 = (_e795[0][2] - _e795[2][2]);
                                                        let _e977 = vec3<f32>(_e974, _e975, _e976);
                                                        let _e978 = abs(_e966);
                                                        let _e979 = abs(_e967);
                                                        if (_e978 != _e978) {
                                                            phi_3459_ = true;
                                                        } else {
                                                            phi_3459_ = (_e979 >= _e978);
                                                        }
                                                        let _e983 = phi_3459_;
                                                        let _e984 = select(_e978, _e979, _e983);
                                                        let _e985 = abs(_e968);
                                                        if (_e984 != _e984) {
                                                            phi_3474_ = true;
                                                        } else {
                                                            phi_3474_ = (_e985 >= _e984);
                                                        }
                                                        let _e989 = phi_3474_;
                                                        let _e990 = select(_e984, _e985, _e989);
                                                        let _e991 = abs(_e970);
                                                        let _e992 = abs(_e971);
                                                        if (_e991 != _e991) {
                                                            phi_3489_ = true;
                                                        } else {
                                                            phi_3489_ = (_e992 >= _e991);
                                                        }
                                                        let _e996 = phi_3489_;
                                                        let _e997 = select(_e991, _e992, _e996);
                                                        let _e998 = abs(_e972);
                                                        if (_e997 != _e997) {
                                                            phi_3504_ = true;
                                                        } else {
                                                            phi_3504_ = (_e998 >= _e997);
                                                        }
                                                        let _e1002 = phi_3504_;
                                                        let _e1003 = select(_e997, _e998, _e1002);
                                                        let _e1004 = abs(_e974);
                                                        let _e1005 = abs(_e975);
                                                        if (_e1004 != _e1004) {
                                                            phi_3519_ = true;
                                                        } else {
                                                            phi_3519_ = (_e1005 >= _e1004);
                                                        }
                                                        let _e1009 = phi_3519_;
                                                        let _e1010 = select(_e1004, _e1005, _e1009);
                                                        let _e1011 = abs(_e976);
                                                        if (_e1010 != _e1010) {
                                                            phi_3534_ = true;
                                                        } else {
                                                            phi_3534_ = (_e1011 >= _e1010);
                                                        }
                                                        let _e1015 = phi_3534_;
                                                        let _e1016 = select(_e1010, _e1011, _e1015);
                                                        let _e1018 = select(_e1003, _e990, (_e990 > _e1003));
                                                        let _e1020 = select(_e1016, _e1018, (_e1018 > _e1016));
                                                        if (_e990 == _e1020) {
                                                            phi_1889_ = _e826;
                                                            phi_1890_ = _e823;
                                                            phi_1891_ = _e817;
                                                            phi_1892_ = _e814;
                                                            phi_1893_ = vec3<f32>(_e795[0][0], _e795[0][1], _e795[0][2]);
                                                            phi_1894_ = _e977;
                                                            phi_1895_ = _e973;
                                                            phi_1896_ = _e969;
                                                        } else {
                                                            let _e1022 = (_e1003 == _e1020);
                                                            let _e1027 = vec3(_e1022);
                                                            phi_1889_ = select(_e817, _e835, _e1022);
                                                            phi_1890_ = select(_e814, _e832, _e1022);
                                                            phi_1891_ = select(_e835, _e826, _e1022);
                                                            phi_1892_ = select(_e832, _e823, _e1022);
                                                            phi_1893_ = select(vec3<f32>(_e795[2][0], _e795[2][1], _e795[2][2]), vec3<f32>(_e795[1][0], _e795[1][1], _e795[1][2]), _e1027);
                                                            phi_1894_ = select(_e973, _e969, _e1027);
                                                            phi_1895_ = select(_e969, _e977, _e1027);
                                                            phi_1896_ = select(_e977, _e973, _e1027);
                                                        }
                                                        let _e1033 = phi_1889_;
                                                        let _e1035 = phi_1890_;
                                                        let _e1037 = phi_1891_;
                                                        let _e1039 = phi_1892_;
                                                        let _e1041 = phi_1893_;
                                                        let _e1043 = phi_1894_;
                                                        let _e1045 = phi_1895_;
                                                        let _e1047 = phi_1896_;
                                                        let _e1054 = ((_e1045.y * _e1043.z) - (_e1043.y * _e1045.z));
                                                        let _e1059 = ((_e1045.z * _e1043.x) - (_e1043.z * _e1045.x));
                                                        let _e1062 = ((_e1045.x * _e1043.y) - (_e1043.x * _e1045.y));
                                                        let _e1065 = ((_e858 >= _e862) && (_e858 >= _e866));
                                                        let _e1066 = (_e862 >= _e866);
                                                        let _e1080 = (((_e1054 * (select(select(_e795[2][0], _e795[1][0], _e1066), _e795[0][0], _e1065) - _e325)) + (_e1059 * (select(select(_e795[2][1], _e795[1][1], _e1066), _e795[0][1], _e1065) - _e392))) + (_e1062 * (select(select(_e795[2][2], _e795[1][2], _e1066), _e795[0][2], _e1065) - _e458)));
                                                        let _e1085 = (((_e1054 * _e362) + (_e1059 * _e428)) + (_e1062 * _e494));
                                                        let _e1086 = (_e1035 - _e1039);
                                                        let _e1087 = (_e1033 - _e1037);
                                                        let _e1090 = ((_e1086 * _e1086) + (_e1087 * _e1087));
                                                        let _e1097 = (-(((_e1039 * _e1086) + (_e1037 * _e1087))) / select(0.000000000000000000000000000000000000011754944f, _e1090, (_e1090 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1099 = select(1f, _e1097, (_e1097 < 1f));
                                                        let _e1101 = select(0f, _e1099, (_e1099 > 0f));
                                                        let _e1110 = ((_e1041.x + (_e1047.x * _e1101)) - _e325);
                                                        let _e1113 = ((_e1041.y + (_e1047.y * _e1101)) - _e392);
                                                        let _e1116 = ((_e1041.z + (_e1047.z * _e1101)) - _e458);
                                                        let _e1119 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                        let _e1122 = bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u));
                                                        let _e1124 = select(_e1122, _e1119, (_e1119 > _e1122));
                                                        let _e1127 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                        let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                                                        let _e1133 = abs(_e1054);
                                                        let _e1134 = abs(_e1059);
                                                        if (_e1133 != _e1133) {
                                                            phi_3549_ = true;
                                                        } else {
                                                            phi_3549_ = (_e1134 >= _e1133);
                                                        }
                                                        let _e1138 = phi_3549_;
                                                        let _e1139 = select(_e1133, _e1134, _e1138);
                                                        let _e1140 = abs(_e1062);
                                                        if (_e1139 != _e1139) {
                                                            phi_3564_ = true;
                                                        } else {
                                                            phi_3564_ = (_e1140 >= _e1139);
                                                        }
                                                        let _e1144 = phi_3564_;
                                                        let _e1160 = abs(_e1045.x);
                                                        let _e1161 = abs(_e1045.y);
                                                        if (_e1160 != _e1160) {
                                                            phi_3579_ = true;
                                                        } else {
                                                            phi_3579_ = (_e1161 >= _e1160);
                                                        }
                                                        let _e1165 = phi_3579_;
                                                        let _e1166 = select(_e1160, _e1161, _e1165);
                                                        let _e1167 = abs(_e1045.z);
                                                        if (_e1166 != _e1166) {
                                                            phi_3594_ = true;
                                                        } else {
                                                            phi_3594_ = (_e1167 >= _e1166);
                                                        }
                                                        let _e1171 = phi_3594_;
                                                        let _e1174 = abs(_e1043.x);
                                                        let _e1175 = abs(_e1043.y);
                                                        if (_e1174 != _e1174) {
                                                            phi_3609_ = true;
                                                        } else {
                                                            phi_3609_ = (_e1175 >= _e1174);
                                                        }
                                                        let _e1179 = phi_3609_;
                                                        let _e1180 = select(_e1174, _e1175, _e1179);
                                                        let _e1181 = abs(_e1043.z);
                                                        if (_e1180 != _e1180) {
                                                            phi_3624_ = true;
                                                        } else {
                                                            phi_3624_ = (_e1181 >= _e1180);
                                                        }
                                                        let _e1185 = phi_3624_;
                                                        let _e1190 = ((bitcast<f32>((bitcast<u32>(((((_e1054 * _e1110) + (_e1059 * _e1113)) + (_e1062 * _e1116)) - _e1080)) & 2147483647u)) <= ((0.0000009536743f * select(_e1020, _e1129, (_e1129 > _e1020))) * select(_e1139, _e1140, _e1144))) && !((bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u)) <= ((0.0000038146973f * select(_e1166, _e1167, _e1171)) * select(_e1180, _e1181, _e1185)))));
                                                        let _e1191 = (_e1080 / _e1085);
                                                        if (_e961 && !(_e1190)) {
                                                            let _e1194 = (_e1116 / _e494);
                                                            let _e1202 = (((_e1054 * (_e1110 - (_e362 * _e1194))) + (_e1059 * (_e1113 - (_e428 * _e1194)))) / _e1085);
                                                            phi_2104_ = select(select(_e1194, (_e1194 + _e1202), (bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u)) <= _e1020)), _e1191, _e1190);
                                                        } else {
                                                            phi_2104_ = _e1191;
                                                        }
                                                        let _e1211 = phi_2104_;
                                                        let _e1213 = select(_e924, _e1211, (_e1211 < _e924));
                                                        let _e1215 = select(_e916, _e1213, (_e1213 > _e916));
                                                        let _e1216 = (1f / _e868);
                                                        phi_2124_ = type_39(_e1215, (_e862 * _e1216), (_e866 * _e1216), ((_e961 && (_e1215 >= _e601)) && (_e1215 <= _e699.member)));
                                                        phi_2125_ = type_39();
                                                    } else {
                                                        phi_2124_ = type_39();
                                                        phi_2125_ = type_39(0f, 0f, 0f, _e961);
                                                    }
                                                    let _e1225 = phi_2124_;
                                                    let _e1227 = phi_2125_;
                                                    phi_2128_ = _e1225;
                                                    phi_2129_ = _e1227;
                                                    phi_2130_ = select(true, false, _e961);
                                                } else {
                                                    phi_2128_ = type_39();
                                                    phi_2129_ = type_39(0f, 0f, 0f, _e852);
                                                    phi_2130_ = true;
                                                }
                                                let _e1230 = phi_2128_;
                                                let _e1232 = phi_2129_;
                                                let _e1234 = phi_2130_;
                                                if _e1234 {
                                                    phi_2134_ = _e1232;
                                                } else {
                                                    phi_2134_ = _e1230;
                                                }
                                                let _e1236 = phi_2134_;
                                                if _e1236.member_3 {
                                                    phi_2143_ = type_28(_e1236.member, _e1236.member_1, _e1236.member_2, _e728);
                                                } else {
                                                    phi_2143_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1243 = phi_2143_;
                                                if (_e1243.member_3 != 4294967295u) {
                                                    if (_e728 != 4294967295u) {
                                                        phi_2154_ = type_43(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2154_ = _e699;
                                                    }
                                                    let _e1248 = phi_2154_;
                                                    phi_2155_ = _e1248;
                                                } else {
                                                    phi_2155_ = _e699;
                                                }
                                                let _e1250 = phi_2155_;
                                                phi_1209_ = _e1250;
                                            } else {
                                                phi_1209_ = type_43();
                                            }
                                            let _e1252 = phi_1209_;
                                            continue;
                                            continuing {
                                                phi_1208_ = _e1252;
                                                phi_1211_ = _e714;
                                                phi_3818_ = _e643;
                                                break if !(_e720);
                                            }
                                        }
                                        let _e1255 = phi_3818_;
                                        phi_3980_ = _e1255;
                                        if _e1255 {
                                            break;
                                        }
                                        phi_4066_ = _e1255;
                                        let _e1838 = local_11;
                                        phi_2156_ = _e1838;
                                    } else {
                                        phi_4066_ = _e643;
                                        phi_2156_ = _e645;
                                    }
                                    let _e1257 = phi_4066_;
                                    let _e1259 = phi_2156_;
                                    if _e692 {
                                        phi_3386_ = bool();
                                        phi_3387_ = u32();
                                        phi_3388_ = type_50();
                                    } else {
                                        if (_e688.member_1 >= _e91) {
                                            phi_2922_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_32(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e688.member_1 < _e91) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1263 = ((1u + _e261) % 4u);
                                            if (_e1263 < 4u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1268 = global_4.member[_e688.member_1][_e1263];
                                            let _e1270 = (_e1268 >> bitcast<u32>(11u));
                                            let _e1272 = ((1u + _e260) % 4u);
                                            if (_e1272 < 4u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1277 = global_4.member[_e688.member_1][_e1272];
                                            let _e1279 = (_e1277 >> bitcast<u32>(11u));
                                            let _e1281 = ((1u + _e262) % 4u);
                                            if (_e1281 < 4u) {
                                            } else {
                                                phi_3980_ = true;
                                                break;
                                            }
                                            let _e1286 = global_4.member[_e688.member_1][_e1281];
                                            let _e1288 = (_e1286 >> bitcast<u32>(11u));
                                            let _e1311 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.x - _e688.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1312 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.y - _e688.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1313 = (bitcast<f32>((bitcast<u32>((_e688.member.member_1.z - _e688.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1315 = select(_e141, _e1311, (_e1311 > _e141));
                                            let _e1317 = select(_e141, _e1312, (_e1312 > _e141));
                                            let _e1319 = select(_e141, _e1313, (_e1313 > _e141));
                                            let _e1350 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1268 & 1023u))) - 8388608f) * _e1315));
                                            let _e1355 = (bitcast<i32>((_e1268 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1358 = bitcast<f32>((_e1350 & bitcast<u32>(_e1355)));
                                            let _e1359 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1277 & 1023u))) - 8388608f) * _e1317));
                                            let _e1364 = (bitcast<i32>((_e1277 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1367 = bitcast<f32>((_e1359 & bitcast<u32>(_e1364)));
                                            let _e1368 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1286 & 1023u))) - 8388608f) * _e1319));
                                            let _e1373 = (bitcast<i32>((_e1286 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1376 = bitcast<f32>((_e1368 & bitcast<u32>(_e1373)));
                                            let _e1380 = bitcast<f32>((_e1350 & bitcast<u32>(~(_e1355))));
                                            let _e1384 = bitcast<f32>((_e1359 & bitcast<u32>(~(_e1364))));
                                            let _e1388 = bitcast<f32>((_e1368 & bitcast<u32>(~(_e1373))));
                                            let _e1389 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1270 & 1023u))) - 8388608f) * _e1315));
                                            let _e1394 = (bitcast<i32>((_e1270 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1397 = bitcast<f32>((_e1389 & bitcast<u32>(_e1394)));
                                            let _e1398 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1279 & 1023u))) - 8388608f) * _e1317));
                                            let _e1403 = (bitcast<i32>((_e1279 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1406 = bitcast<f32>((_e1398 & bitcast<u32>(_e1403)));
                                            let _e1407 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1288 & 1023u))) - 8388608f) * _e1319));
                                            let _e1412 = (bitcast<i32>((_e1288 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1415 = bitcast<f32>((_e1407 & bitcast<u32>(_e1412)));
                                            let _e1419 = bitcast<f32>((_e1389 & bitcast<u32>(~(_e1394))));
                                            let _e1423 = bitcast<f32>((_e1398 & bitcast<u32>(~(_e1403))));
                                            let _e1427 = bitcast<f32>((_e1407 & bitcast<u32>(~(_e1412))));
                                            let _e1457 = global_4.member[_e688.member_1][0u];
                                            let _e1461 = global_4.member[_e688.member_1][1u];
                                            let _e1465 = global_4.member[_e688.member_1][2u];
                                            let _e1469 = global_4.member[_e688.member_1][3u];
                                            let _e1481 = (((_e1461 >> bitcast<u32>(22i)) | ((_e1465 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1469 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1482 = (_e1457 & 268435455u);
                                            let _e1483 = (_e1481 & 268435455u);
                                            let _e1486 = ((_e1457 >> bitcast<u32>(28u)) & 7u);
                                            let _e1494 = ((_e1457 >> bitcast<u32>(31i)) | (((_e1481 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1495 = (_e1486 != 0u);
                                            if (_e1486 == 0u) {
                                                phi_2884_ = _e1482;
                                            } else {
                                                if (_e1486 == 7u) {
                                                    phi_2883_ = 2147483648u;
                                                } else {
                                                    phi_2883_ = ((2147483648u | (_e1486 << bitcast<u32>(28u))) | (_e1483 & 268435455u));
                                                }
                                                let _e1504 = phi_2883_;
                                                phi_2884_ = _e1504;
                                            }
                                            let _e1506 = phi_2884_;
                                            if _e1495 {
                                                let _e1507 = (_e1486 != 7u);
                                                if _e1507 {
                                                    phi_2894_ = (_e1483 + _e1486);
                                                } else {
                                                    phi_2894_ = u32();
                                                }
                                                let _e1510 = phi_2894_;
                                                phi_2896_ = _e1510;
                                                phi_2897_ = select(true, false, _e1507);
                                            } else {
                                                phi_2896_ = u32();
                                                phi_2897_ = true;
                                            }
                                            let _e1513 = phi_2896_;
                                            let _e1515 = phi_2897_;
                                            if (_e1494 == 0u) {
                                                phi_2918_ = (_e1482 + select(0u, 1u, !(_e1495)));
                                            } else {
                                                if (_e1494 == 7u) {
                                                    phi_2917_ = 2147483648u;
                                                } else {
                                                    phi_2917_ = ((2147483648u | (_e1494 << bitcast<u32>(28u))) | (select(_e1513, _e1483, _e1515) & 268435455u));
                                                }
                                                let _e1528 = phi_2917_;
                                                phi_2918_ = _e1528;
                                            }
                                            let _e1530 = phi_2918_;
                                            phi_2922_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e688.member.member.x + _e1358), (_e688.member.member.x + _e1380), (_e688.member.member_1.x - _e1397), (_e688.member.member_1.x - _e1419)), vec4<f32>((_e688.member.member.y + _e1367), (_e688.member.member.y + _e1384), (_e688.member.member_1.y - _e1406), (_e688.member.member_1.y - _e1423)), vec4<f32>((_e688.member.member.z + _e1376), (_e688.member.member.z + _e1388), (_e688.member.member_1.z - _e1415), (_e688.member.member_1.z - _e1427))), type_50(type_32((_e688.member.member + vec4<f32>(_e1358, _e1367, _e1376, 0f)), (_e688.member.member_1 - vec4<f32>(_e1397, _e1406, _e1415, 0f))), _e1506), type_50(type_32((_e688.member.member + vec4<f32>(_e1380, _e1384, _e1388, 0f)), (_e688.member.member_1 - vec4<f32>(_e1419, _e1423, _e1427, 0f))), _e1530));
                                        }
                                        let _e1535 = phi_2922_;
                                        let _e1547 = ((_e1535.member[0].x - _e363) * _e366);
                                        let _e1548 = ((_e1535.member[0].y - _e363) * _e366);
                                        let _e1549 = ((_e1535.member[0].z - _e364) * _e366);
                                        let _e1550 = ((_e1535.member[0].w - _e364) * _e366);
                                        let _e1560 = ((_e1535.member[1].x - _e429) * _e432);
                                        let _e1561 = ((_e1535.member[1].y - _e429) * _e432);
                                        let _e1562 = ((_e1535.member[1].z - _e430) * _e432);
                                        let _e1563 = ((_e1535.member[1].w - _e430) * _e432);
                                        let _e1573 = ((_e1535.member[2].x - _e495) * _e498);
                                        let _e1574 = ((_e1535.member[2].y - _e495) * _e498);
                                        let _e1575 = ((_e1535.member[2].z - _e496) * _e498);
                                        let _e1576 = ((_e1535.member[2].w - _e496) * _e498);
                                        let _e1578 = select(_e1575, _e1573, (_e1573 < _e1575));
                                        let _e1580 = select(_e1576, _e1574, (_e1574 < _e1576));
                                        let _e1582 = select(_e1575, _e1573, (_e1573 > _e1575));
                                        let _e1584 = select(_e1576, _e1574, (_e1574 > _e1576));
                                        let _e1586 = select(_e1549, _e1547, (_e1547 < _e1549));
                                        let _e1588 = select(_e1550, _e1548, (_e1548 < _e1550));
                                        let _e1590 = select(_e1562, _e1560, (_e1560 < _e1562));
                                        let _e1592 = select(_e1563, _e1561, (_e1561 < _e1563));
                                        let _e1594 = select(_e1590, _e1586, (_e1586 > _e1590));
                                        let _e1596 = select(_e1592, _e1588, (_e1588 > _e1592));
                                        let _e1598 = select(_e1578, _e1594, (_e1594 > _e1578));
                                        let _e1600 = select(_e1580, _e1596, (_e1596 > _e1580));
                                        let _e1602 = select(_e1549, _e1547, (_e1547 > _e1549));
                                        let _e1604 = select(_e1550, _e1548, (_e1548 > _e1550));
                                        let _e1606 = select(_e1562, _e1560, (_e1560 > _e1562));
                                        let _e1608 = select(_e1563, _e1561, (_e1561 > _e1563));
                                        let _e1610 = select(_e1606, _e1602, (_e1602 < _e1606));
                                        let _e1612 = select(_e1608, _e1604, (_e1604 < _e1608));
                                        let _e1617 = -(_e1578);
                                        let _e1618 = -(_e1580);
                                        let _e1625 = (select(_e1582, _e1610, (_e1610 < _e1582)) + (select(_e1617, _e1582, (_e1582 > _e1617)) * 0.0000019073523f));
                                        let _e1626 = (select(_e1584, _e1612, (_e1612 < _e1584)) + (select(_e1618, _e1584, (_e1584 > _e1618)) * 0.0000019073523f));
                                        let _e1628 = select(_e601, _e1598, (_e1598 > _e601));
                                        let _e1630 = select(_e601, _e1600, (_e1600 > _e601));
                                        let _e1635 = (_e1628 <= select(_e1259.member, _e1625, (_e1625 < _e1259.member)));
                                        let _e1636 = (_e1630 <= select(_e1259.member, _e1626, (_e1626 < _e1259.member)));
                                        let _e1637 = (_e1628 <= _e1630);
                                        if _e1635 {
                                            if _e1636 {
                                                if _e1637 {
                                                    phi_3284_ = _e1535.member_2;
                                                } else {
                                                    phi_3284_ = _e1535.member_1;
                                                }
                                                let _e1641 = phi_3284_;
                                                let _e1662 = (_e686 % 128u);
                                                let _e1663 = (_e1662 < 128u);
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_8[_e1662] = _e1641.member_1;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_7[_e1662] = _e1641.member.member.x;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_6[_e1662] = _e1641.member.member.y;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_5[_e1662] = _e1641.member.member.z;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_4[_e1662] = _e1641.member.member_1.x;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_3[_e1662] = _e1641.member.member_1.y;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_2[_e1662] = _e1641.member.member_1.z;
                                                if _e1663 {
                                                } else {
                                                    phi_3980_ = true;
                                                    break;
                                                }
                                                local_9[_e1662] = select(_e1628, _e1630, _e1637);
                                                if _e1637 {
                                                    phi_3360_ = _e1535.member_1;
                                                } else {
                                                    phi_3360_ = _e1535.member_2;
                                                }
                                                let _e1676 = phi_3360_;
                                                phi_3361_ = (_e686 + 1u);
                                                phi_3362_ = _e1676;
                                            } else {
                                                phi_3361_ = u32();
                                                phi_3362_ = type_50();
                                            }
                                            let _e1678 = phi_3361_;
                                            let _e1680 = phi_3362_;
                                            phi_3364_ = _e1678;
                                            phi_3365_ = _e1680;
                                            phi_3366_ = select(true, false, _e1636);
                                        } else {
                                            phi_3364_ = u32();
                                            phi_3365_ = type_50();
                                            phi_3366_ = true;
                                        }
                                        let _e1683 = phi_3364_;
                                        let _e1685 = phi_3365_;
                                        let _e1687 = phi_3366_;
                                        if _e1687 {
                                            if _e1635 {
                                                phi_3375_ = _e1535.member_1;
                                            } else {
                                                phi_3375_ = _e1535.member_2;
                                            }
                                            let _e1691 = phi_3375_;
                                            phi_3380_ = select(_e1636, true, _e1635);
                                            phi_3382_ = _e1691;
                                        } else {
                                            phi_3380_ = _e684;
                                            phi_3382_ = _e1685;
                                        }
                                        let _e1694 = phi_3380_;
                                        let _e1696 = phi_3382_;
                                        phi_3386_ = _e1694;
                                        phi_3387_ = select(_e1683, _e686, _e1687);
                                        phi_3388_ = _e1696;
                                    }
                                    let _e1699 = phi_3386_;
                                    let _e1701 = phi_3387_;
                                    let _e1703 = phi_3388_;
                                    if _e692 {
                                        phi_3398_ = select(_e686, 0u, _e1259.member_1);
                                        phi_3399_ = _e688;
                                    } else {
                                        phi_3398_ = _e1701;
                                        phi_3399_ = _e1703;
                                    }
                                    let _e1707 = phi_3398_;
                                    let _e1709 = phi_3399_;
                                    phi_3983_ = _e1257;
                                    phi_3400_ = _e1259;
                                    phi_3401_ = (_e647 - 1u);
                                    phi_3402_ = select(_e1699, false, _e692);
                                    phi_3403_ = _e1707;
                                    phi_3404_ = _e1709;
                                } else {
                                    phi_3983_ = _e643;
                                    phi_3400_ = _e645;
                                    phi_3401_ = _e647;
                                    phi_3402_ = _e684;
                                    phi_3403_ = _e686;
                                    phi_3404_ = _e688;
                                }
                                let _e1712 = phi_3983_;
                                let _e1714 = phi_3400_;
                                let _e1716 = phi_3401_;
                                let _e1718 = phi_3402_;
                                let _e1720 = phi_3403_;
                                let _e1722 = phi_3404_;
                                phi_3982_ = _e1712;
                                phi_3405_ = _e1714;
                                phi_3406_ = _e1716;
                                phi_3407_ = _e1718;
                                phi_3408_ = _e1720;
                                phi_3409_ = _e1722;
                            } else {
                                phi_3982_ = _e643;
                                phi_3405_ = type_43();
                                phi_3406_ = u32();
                                phi_3407_ = bool();
                                phi_3408_ = u32();
                                phi_3409_ = type_50();
                            }
                            let _e1724 = phi_3982_;
                            let _e1726 = phi_3405_;
                            let _e1728 = phi_3406_;
                            let _e1730 = phi_3407_;
                            let _e1732 = phi_3408_;
                            let _e1734 = phi_3409_;
                            phi_3981_ = _e1724;
                            phi_1083_ = _e1726;
                            phi_1086_ = _e1728;
                            phi_1088_ = _e1730;
                            phi_1090_ = _e1732;
                            phi_1092_ = _e1734;
                            phi_3410_ = _e657;
                        } else {
                            phi_3981_ = _e643;
                            phi_1083_ = type_43();
                            phi_1086_ = u32();
                            phi_1088_ = bool();
                            phi_1090_ = u32();
                            phi_1092_ = type_50();
                            phi_3410_ = false;
                        }
                        let _e1736 = phi_3981_;
                        let _e1738 = phi_1083_;
                        let _e1740 = phi_1086_;
                        let _e1742 = phi_1088_;
                        let _e1744 = phi_1090_;
                        let _e1746 = phi_1092_;
                        let _e1748 = phi_3410_;
                        continue;
                        continuing {
                            phi_3824_ = _e1736;
                            phi_1082_ = _e1738;
                            phi_1085_ = _e1740;
                            phi_1087_ = _e1742;
                            phi_1089_ = _e1744;
                            phi_1091_ = _e1746;
                            phi_3980_ = _e1736;
                            break if !(_e1748);
                        }
                    }
                    let _e1751 = phi_3980_;
                    if _e1751 {
                        break;
                    }
                    let _e1753 = local_10;
                    if _e149 {
                    } else {
                        break;
                    }
                    global_6.member[_e147] = select(0u, 1u, _e1753.member_1);
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
