struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_53,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_66;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
var<storage> global_10: type_57;

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
    var phi_358_: u32;
    var phi_402_: i32;
    var phi_542_: type_35;
    var phi_648_: i32;
    var phi_649_: i32;
    var phi_659_: bool;
    var phi_669_: u32;
    var phi_670_: u32;
    var phi_672_: bool;
    var phi_677_: u32;
    var phi_709_: i32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_773_: f32;
    var phi_779_: f32;
    var phi_831_: f32;
    var phi_842_: f32;
    var phi_851_: f32;
    var phi_857_: f32;
    var phi_897_: f32;
    var phi_903_: f32;
    var phi_955_: f32;
    var phi_966_: f32;
    var phi_975_: f32;
    var phi_981_: f32;
    var phi_1021_: f32;
    var phi_1027_: f32;
    var phi_1079_: f32;
    var phi_1090_: f32;
    var phi_1145_: i32;
    var phi_1167_: u32;
    var phi_1168_: u32;
    var phi_1205_: i32;
    var phi_1227_: u32;
    var phi_1228_: u32;
    var phi_1236_: f32;
    var phi_1237_: f32;
    var phi_4206_: bool;
    var phi_1310_: type_38;
    var phi_1313_: type_61;
    var phi_1315_: u32;
    var phi_1317_: bool;
    var phi_1319_: u32;
    var phi_1330_: bool;
    var phi_1416_: type_61;
    var phi_1417_: bool;
    var phi_1418_: u32;
    var phi_2961_: type_48;
    var phi_3817_: type_61;
    var phi_3894_: type_61;
    var phi_3895_: type_61;
    var phi_3896_: u32;
    var phi_3898_: type_61;
    var phi_3899_: u32;
    var phi_3900_: bool;
    var phi_3907_: type_61;
    var phi_3912_: type_61;
    var phi_3913_: bool;
    var phi_1437_: type_38;
    var phi_1440_: type_8;
    var phi_1441_: type_8;
    var phi_1463_: type_8;
    var phi_1488_: u32;
    var phi_1504_: type_55;
    var phi_1898_: bool;
    var phi_1927_: bool;
    var phi_2304_: f32;
    var phi_2305_: f32;
    var phi_2306_: f32;
    var phi_2307_: f32;
    var phi_2308_: vec3<f32>;
    var phi_2309_: vec3<f32>;
    var phi_2310_: vec3<f32>;
    var phi_2311_: vec3<f32>;
    var phi_2342_: bool;
    var phi_2351_: vec3<f32>;
    var phi_2516_: f32;
    var phi_2518_: f32;
    var phi_2519_: bool;
    var phi_2539_: f32;
    var phi_2540_: f32;
    var phi_2563_: type_22;
    var phi_2565_: type_22;
    var phi_2566_: bool;
    var phi_2570_: type_22;
    var phi_2571_: type_22;
    var phi_2572_: type_22;
    var phi_2573_: bool;
    var phi_2577_: type_22;
    var phi_2578_: bool;
    var phi_2579_: type_22;
    var phi_2580_: bool;
    var phi_2581_: bool;
    var phi_2582_: type_22;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2592_: type_22;
    var phi_2593_: bool;
    var phi_2597_: type_22;
    var phi_2620_: u32;
    var phi_2634_: i32;
    var phi_2650_: vec3<f32>;
    var phi_2651_: vec3<f32>;
    var phi_2663_: vec3<f32>;
    var phi_2664_: vec3<f32>;
    var phi_2676_: vec3<f32>;
    var phi_2677_: vec3<f32>;
    var phi_2713_: vec3<f32>;
    var phi_2895_: f32;
    var phi_2913_: bool;
    var phi_2914_: bool;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2940_: type_38;
    var phi_2941_: type_38;
    var phi_2942_: type_38;
    var phi_1438_: type_38;
    var phi_4200_: bool;
    var phi_4414_: bool;
    var phi_3915_: type_38;
    var phi_3916_: type_61;
    var phi_3917_: bool;
    var phi_3918_: u32;
    var phi_4413_: bool;
    var phi_3919_: type_38;
    var phi_3920_: type_61;
    var phi_3921_: u32;
    var phi_3922_: bool;
    var phi_3923_: u32;
    var phi_4412_: bool;
    var phi_3924_: type_38;
    var phi_3925_: type_61;
    var phi_3926_: u32;
    var phi_3927_: bool;
    var phi_3928_: u32;
    var phi_4411_: bool;
    var phi_1311_: type_38;
    var phi_1314_: type_61;
    var phi_1316_: u32;
    var phi_1318_: bool;
    var phi_1320_: u32;
    var phi_3929_: bool;
    var phi_4410_: bool;
    var local_10: type_38;
    var phi_3967_: f32;
    var phi_3969_: f32;
    var phi_3970_: bool;
    var phi_3971_: f32;
    var phi_3972_: bool;
    var phi_4120_: u32;
    var phi_4138_: bool;
    var phi_4141_: bool;
    var phi_4154_: f32;
    var phi_4155_: f32;
    var phi_4160_: f32;
    var phi_4161_: f32;
    var phi_4162_: bool;
    var phi_4170_: f32;
    var phi_3987_: f32;
    var phi_3988_: f32;
    var phi_4000_: f32;
    var phi_4005_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_8.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[1u][0u];
            let _e131 = global_3.member[1u][1u];
            let _e135 = global_3.member[1u][2u];
            let _e139 = global_3.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_6.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_6.member[_e143].member_2;
                phi_358_ = _e154;
            } else {
                phi_358_ = 4294967295u;
            }
            let _e156 = phi_358_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            if (_e199 < -126i) {
                phi_402_ = -126i;
            } else {
                phi_402_ = select(_e199, 127i, (_e199 > 127i));
            }
            let _e204 = phi_402_;
            let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
            let _e215 = bitcast<f32>((bitcast<u32>(((_e199 - _e204) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_542_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                let _e217 = bitcast<u32>(_e192);
                let _e219 = ((_e217 & 2139095040u) != 0u);
                let _e234 = bitcast<u32>(_e193);
                let _e236 = ((_e234 & 2139095040u) != 0u);
                let _e251 = bitcast<u32>(_e194);
                let _e253 = ((_e251 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e196);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                phi_542_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e217 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e217 & 2147483648u))), _e192, _e219) * _e209) * select(0.00000011920929f, 1f, _e219)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e193, _e236) * _e209) * select(0.00000011920929f, 1f, _e236)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e194, _e253) * _e209) * select(0.00000011920929f, 1f, _e253)) * _e215)), _e175, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e196, _e271) * _e209) * select(0.00000011920929f, 1f, _e271)) * _e215), _e197);
            }
            let _e288 = phi_542_;
            if _e150 {
                let _e289 = (_e143 < arrayLength((&global_7.member)));
                if _e289 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e299 = global_6.member[_e143].member.member_2[0u];
                    let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                    let _e307 = global_6.member[_e143].member.member_2[1u];
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e315 = global_6.member[_e143].member.member_2[2u];
                    let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                    let _e323 = global_6.member[_e143].member.member[0u];
                    let _e325 = (bitcast<u32>(_e323) & 2147483647u);
                    let _e331 = global_6.member[_e143].member.member[1u];
                    let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                    let _e339 = global_6.member[_e143].member.member[2u];
                    let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                    let _e343 = select(_e309, _e301, (_e309 < _e301));
                    let _e345 = select(_e317, _e343, (_e317 < _e343));
                    let _e347 = select(_e325, _e345, (_e325 < _e345));
                    let _e349 = select(_e333, _e347, (_e333 < _e347));
                    let _e351 = select(_e341, _e349, (_e341 < _e349));
                    let _e356 = global_6.member[_e143].member.member_1;
                    let _e357 = bitcast<u32>(_e356);
                    let _e358 = (_e357 & 2147483647u);
                    let _e366 = global_6.member[_e143].member.member_3;
                    let _e367 = bitcast<u32>(_e366);
                    let _e368 = (_e367 & 2147483647u);
                    let _e372 = (((select(_e358, _e351, (_e358 < _e351)) < 2139095040u) && (_e368 <= 2139095040u)) && (_e345 > 0u));
                    if _e372 {
                        let _e375 = (bitcast<u32>(bitcast<f32>(_e345)) & 2147483647u);
                        if (_e375 >= 8388608u) {
                            phi_648_ = (bitcast<i32>((_e375 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_648_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))));
                        }
                        let _e389 = phi_648_;
                        phi_649_ = _e389;
                    } else {
                        phi_649_ = 0i;
                    }
                    let _e391 = phi_649_;
                    let _e392 = (_e301 == _e345);
                    if _e392 {
                        phi_659_ = true;
                    } else {
                        phi_659_ = (_e309 == _e345);
                    }
                    let _e395 = phi_659_;
                    let _e396 = select(1u, 0u, _e392);
                    if _e395 {
                        let _e397 = (_e396 + 1u);
                        phi_669_ = _e397;
                        phi_670_ = _e397;
                        phi_672_ = select(true, false, (_e397 == 2u));
                    } else {
                        phi_669_ = u32();
                        phi_670_ = 0u;
                        phi_672_ = true;
                    }
                    let _e401 = phi_669_;
                    let _e403 = phi_670_;
                    let _e405 = phi_672_;
                    if _e405 {
                        phi_677_ = (_e403 + 1u);
                    } else {
                        phi_677_ = 0u;
                    }
                    let _e409 = phi_677_;
                    let _e410 = select(_e401, _e403, _e405);
                    let _e411 = select(_e396, select(2u, _e396, _e395), _e405);
                    let _e412 = -(_e391);
                    if (_e412 < -126i) {
                        phi_709_ = -126i;
                    } else {
                        phi_709_ = select(_e412, 127i, (_e412 > 127i));
                    }
                    let _e417 = phi_709_;
                    let _e422 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                    let _e428 = bitcast<f32>((bitcast<u32>(((_e412 - _e417) + 127i)) << bitcast<u32>(23i)));
                    let _e433 = global_6.member[_e143].member.member;
                    let _e434 = (_e410 == 0u);
                    if _e434 {
                        phi_727_ = _e433[0];
                    } else {
                        phi_727_ = _e433[1];
                    }
                    let _e438 = phi_727_;
                    let _e439 = (_e410 == 2u);
                    if _e439 {
                        phi_733_ = _e433[2];
                    } else {
                        phi_733_ = _e438;
                    }
                    let _e442 = phi_733_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                    let _e458 = global_6.member[_e143].member.member_2;
                    if _e434 {
                        phi_773_ = _e458[0];
                    } else {
                        phi_773_ = _e458[1];
                    }
                    let _e462 = phi_773_;
                    if _e439 {
                        phi_779_ = _e458[2];
                    } else {
                        phi_779_ = _e462;
                    }
                    let _e465 = phi_779_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e422) * select(0.00000011920929f, 1f, _e468)) * _e428);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e486 {
                        let _e490 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                        phi_831_ = select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f));
                    } else {
                        phi_831_ = 0f;
                    }
                    let _e494 = phi_831_;
                    let _e495 = (_e457 + _e494);
                    let _e496 = (_e457 - _e494);
                    let _e497 = select(_e482, 0f, _e486);
                    if _e486 {
                        phi_842_ = 38685626000000000000000000f;
                    } else {
                        phi_842_ = (1f / _e482);
                    }
                    let _e500 = phi_842_;
                    let _e501 = (_e409 == 0u);
                    if _e501 {
                        phi_851_ = _e433[0];
                    } else {
                        phi_851_ = _e433[1];
                    }
                    let _e505 = phi_851_;
                    let _e506 = (_e409 == 2u);
                    if _e506 {
                        phi_857_ = _e433[2];
                    } else {
                        phi_857_ = _e505;
                    }
                    let _e509 = phi_857_;
                    let _e510 = bitcast<u32>(_e509);
                    let _e512 = ((_e510 & 2139095040u) != 0u);
                    let _e524 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e510 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e510 & 2147483648u))), _e509, _e512) * select(0.00000011920929f, 1f, _e512));
                    if _e501 {
                        phi_897_ = _e458[0];
                    } else {
                        phi_897_ = _e458[1];
                    }
                    let _e528 = phi_897_;
                    if _e506 {
                        phi_903_ = _e458[2];
                    } else {
                        phi_903_ = _e528;
                    }
                    let _e531 = phi_903_;
                    let _e532 = bitcast<u32>(_e531);
                    let _e534 = ((_e532 & 2139095040u) != 0u);
                    let _e548 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e532 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e532 & 2147483648u))), _e531, _e534) * _e422) * select(0.00000011920929f, 1f, _e534)) * _e428);
                    let _e552 = (bitcast<f32>((bitcast<u32>(_e548) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e552 {
                        let _e556 = (bitcast<f32>((bitcast<u32>(_e524) & 2147483647u)) * 0.00000011920929f);
                        phi_955_ = select(0.00000000000011368684f, _e556, (_e556 > 0.00000000000011368684f));
                    } else {
                        phi_955_ = 0f;
                    }
                    let _e560 = phi_955_;
                    let _e561 = (_e524 + _e560);
                    let _e562 = (_e524 - _e560);
                    let _e563 = select(_e548, 0f, _e552);
                    if _e552 {
                        phi_966_ = 38685626000000000000000000f;
                    } else {
                        phi_966_ = (1f / _e548);
                    }
                    let _e566 = phi_966_;
                    let _e567 = (_e411 == 0u);
                    if _e567 {
                        phi_975_ = _e433[0];
                    } else {
                        phi_975_ = _e433[1];
                    }
                    let _e571 = phi_975_;
                    let _e572 = (_e411 == 2u);
                    if _e572 {
                        phi_981_ = _e433[2];
                    } else {
                        phi_981_ = _e571;
                    }
                    let _e575 = phi_981_;
                    let _e576 = bitcast<u32>(_e575);
                    let _e578 = ((_e576 & 2139095040u) != 0u);
                    let _e590 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e576 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e576 & 2147483648u))), _e575, _e578) * select(0.00000011920929f, 1f, _e578));
                    if _e567 {
                        phi_1021_ = _e458[0];
                    } else {
                        phi_1021_ = _e458[1];
                    }
                    let _e594 = phi_1021_;
                    if _e572 {
                        phi_1027_ = _e458[2];
                    } else {
                        phi_1027_ = _e594;
                    }
                    let _e597 = phi_1027_;
                    let _e598 = bitcast<u32>(_e597);
                    let _e600 = ((_e598 & 2139095040u) != 0u);
                    let _e614 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e598 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e598 & 2147483648u))), _e597, _e600) * _e422) * select(0.00000011920929f, 1f, _e600)) * _e428);
                    let _e618 = (bitcast<f32>((bitcast<u32>(_e614) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e618 {
                        let _e622 = (bitcast<f32>((bitcast<u32>(_e590) & 2147483647u)) * 0.00000011920929f);
                        phi_1079_ = select(0.00000000000011368684f, _e622, (_e622 > 0.00000000000011368684f));
                    } else {
                        phi_1079_ = 0f;
                    }
                    let _e626 = phi_1079_;
                    let _e627 = (_e590 + _e626);
                    let _e628 = (_e590 - _e626);
                    let _e629 = select(_e614, 0f, _e618);
                    if _e618 {
                        phi_1090_ = 38685626000000000000000000f;
                    } else {
                        phi_1090_ = (1f / _e614);
                    }
                    let _e632 = phi_1090_;
                    let _e635 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    let _e638 = bitcast<f32>((bitcast<u32>(_e524) & 2147483647u));
                    let _e640 = select(_e638, _e635, (_e635 > _e638));
                    let _e643 = bitcast<f32>((bitcast<u32>(_e590) & 2147483647u));
                    if (_e372 && (select(_e643, _e640, (_e640 > _e643)) <= 1099511600000f)) {
                        let _e655 = ((_e358 & 8388607u) | (select(0u, 1u, ((_e358 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e658 = bitcast<i32>((_e358 >> bitcast<u32>(23i)));
                        let _e662 = (_e655 == 0u);
                        let _e665 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e655)), 32u, _e662)) - 8i);
                        if (_e658 == 255i) {
                            phi_1145_ = 255i;
                        } else {
                            phi_1145_ = (((_e658 + select(0i, 1i, (_e658 == 0i))) - _e665) + _e391);
                        }
                        let _e673 = phi_1145_;
                        let _e683 = (_e673 <= 0i);
                        if _e683 {
                            phi_1168_ = u32();
                        } else {
                            if _e662 {
                                phi_1167_ = u32();
                            } else {
                                phi_1167_ = select(((bitcast<u32>(_e673) << bitcast<u32>(23i)) | ((_e655 << bitcast<u32>(((_e665 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e673 >= 255i));
                            }
                            let _e687 = phi_1167_;
                            phi_1168_ = _e687;
                        }
                        let _e689 = phi_1168_;
                        let _e701 = ((_e368 & 8388607u) | (select(0u, 1u, ((_e368 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e704 = bitcast<i32>((_e368 >> bitcast<u32>(23i)));
                        let _e708 = (_e701 == 0u);
                        let _e711 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e701)), 32u, _e708)) - 8i);
                        if (_e704 == 255i) {
                            phi_1205_ = 255i;
                        } else {
                            phi_1205_ = (((_e704 + select(0i, 1i, (_e704 == 0i))) - _e711) + _e391);
                        }
                        let _e719 = phi_1205_;
                        let _e729 = (_e719 <= 0i);
                        if _e729 {
                            phi_1228_ = u32();
                        } else {
                            if _e708 {
                                phi_1227_ = u32();
                            } else {
                                phi_1227_ = select(((bitcast<u32>(_e719) << bitcast<u32>(23i)) | ((_e701 << bitcast<u32>(((_e711 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e719 >= 255i));
                            }
                            let _e733 = phi_1227_;
                            phi_1228_ = _e733;
                        }
                        let _e735 = phi_1228_;
                        phi_1236_ = bitcast<f32>(((_e367 & 2147483648u) | select(_e735, 0u, select(_e708, true, _e729))));
                        phi_1237_ = bitcast<f32>(((_e357 & 2147483648u) | select(_e689, 0u, select(_e662, true, _e683))));
                    } else {
                        phi_1236_ = 0f;
                        phi_1237_ = 1f;
                    }
                    let _e741 = phi_1236_;
                    let _e743 = phi_1237_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e748 = (_e410 % 3u);
                    let _e749 = (_e748 < 3u);
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e751 = local_9[_e748];
                    let _e752 = (_e409 % 3u);
                    let _e753 = (_e752 < 3u);
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e755 = local_9[_e752];
                    let _e756 = (_e411 % 3u);
                    let _e757 = (_e756 < 3u);
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e759 = local_9[_e756];
                    local_8 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e763 = local_8[_e748];
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e765 = local_8[_e752];
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e767 = local_8[_e756];
                    phi_4206_ = false;
                    phi_1310_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e741);
                    phi_1313_ = type_61(type_53(array<f32, 3>(_e751, _e755, _e759), array<f32, 3>(_e763, _e765, _e767)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_1315_ = ((3u * _e96) + 1u);
                    phi_1317_ = (_e743 <= _e741);
                    phi_1319_ = 0u;
                    loop {
                        let _e775 = phi_4206_;
                        let _e777 = phi_1310_;
                        let _e779 = phi_1313_;
                        let _e781 = phi_1315_;
                        let _e783 = phi_1317_;
                        let _e785 = phi_1319_;
                        local_10 = _e777;
                        if _e783 {
                            phi_1330_ = true;
                        } else {
                            phi_1330_ = (_e785 > 0u);
                        }
                        let _e788 = phi_1330_;
                        if _e788 {
                            let _e789 = (_e781 > 0u);
                            if _e789 {
                                if _e783 {
                                    phi_1416_ = _e779;
                                    phi_1417_ = _e783;
                                    phi_1418_ = _e785;
                                } else {
                                    let _e790 = (_e785 - 1u);
                                    let _e791 = (_e790 % 128u);
                                    let _e792 = (_e791 < 128u);
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e794 = local_6[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e796 = local_5[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e798 = local_4[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e800 = local_3[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e803 = local_2[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e805 = local_1[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e807 = local[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4410_ = true;
                                        break;
                                    }
                                    let _e812 = local_7[_e791];
                                    phi_1416_ = type_61(type_53(array<f32, 3>(_e796, _e798, _e800), array<f32, 3>(_e803, _e805, _e807)), _e794);
                                    phi_1417_ = (_e812 <= _e777.member_1);
                                    phi_1418_ = _e790;
                                }
                                let _e816 = phi_1416_;
                                let _e818 = phi_1417_;
                                let _e820 = phi_1418_;
                                if _e818 {
                                    if ((_e816.member_1 & 2147483648u) != 0u) {
                                        phi_1437_ = _e777;
                                        phi_1440_ = type_8(0u, ((_e816.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1197 = phi_1437_;
                                            let _e1199 = phi_1440_;
                                            local_11 = _e1197;
                                            if (_e1199.member < _e1199.member_1) {
                                                phi_1441_ = type_8((_e1199.member + 1u), _e1199.member_1);
                                                phi_1463_ = type_8(1u, _e1199.member);
                                            } else {
                                                phi_1441_ = _e1199;
                                                phi_1463_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1212 = phi_1441_;
                                            let _e1214 = phi_1463_;
                                            let _e1218 = (bitcast<i32>(_e1214.member) != 0i);
                                            if _e1218 {
                                                let _e1219 = ((_e816.member_1 & 268435455u) + _e1214.member_1);
                                                let _e1220 = (_e1219 < arrayLength((&global_10.member)));
                                                if _e1220 {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4200_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_10.member[_e1219].member_1;
                                                    phi_1488_ = _e1223;
                                                } else {
                                                    phi_1488_ = 4294967295u;
                                                }
                                                let _e1225 = phi_1488_;
                                                if _e1220 {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4200_ = true;
                                                        break;
                                                    }
                                                    let _e1227 = global_10.member[_e1219];
                                                    phi_1504_ = _e1227;
                                                } else {
                                                    phi_1504_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1229 = phi_1504_;
                                                let _e1241 = ((10u * _e410) & 31u);
                                                let _e1244 = ((_e1229.member[0] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1252 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[0] - _e816.member.member[0]) * 0.0009775171f)) ^ _e139));
                                                let _e1257 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1244)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1261 = select(select(_e816.member.member_1[0], _e1257, (_e1257 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e1244 == 1023u));
                                                let _e1263 = ((10u * _e409) & 31u);
                                                let _e1266 = ((_e1229.member[0] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1274 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[1] - _e816.member.member[1]) * 0.0009775171f)) ^ _e139));
                                                let _e1279 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1266)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1283 = select(select(_e816.member.member_1[1], _e1279, (_e1279 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e1266 == 1023u));
                                                let _e1285 = ((10u * _e411) & 31u);
                                                let _e1288 = ((_e1229.member[0] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1296 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[2] - _e816.member.member[2]) * 0.0009775171f)) ^ _e139));
                                                let _e1301 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1288)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1305 = select(select(_e816.member.member_1[2], _e1301, (_e1301 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e1288 == 1023u));
                                                let _e1309 = ((_e1229.member[1] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1317 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1309)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1321 = select(select(_e816.member.member_1[0], _e1317, (_e1317 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e1309 == 1023u));
                                                let _e1324 = ((_e1229.member[1] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1332 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1324)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1336 = select(select(_e816.member.member_1[1], _e1332, (_e1332 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e1324 == 1023u));
                                                let _e1339 = ((_e1229.member[1] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1347 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1339)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1351 = select(select(_e816.member.member_1[2], _e1347, (_e1347 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e1339 == 1023u));
                                                let _e1355 = ((_e1229.member[2] >> bitcast<u32>(_e1241)) & 1023u);
                                                let _e1363 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1355)) - 8388608f) * _e1252)) ^ _e139)));
                                                let _e1367 = select(select(_e816.member.member_1[0], _e1363, (_e1363 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e1355 == 1023u));
                                                let _e1370 = ((_e1229.member[2] >> bitcast<u32>(_e1263)) & 1023u);
                                                let _e1378 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1370)) - 8388608f) * _e1274)) ^ _e139)));
                                                let _e1382 = select(select(_e816.member.member_1[1], _e1378, (_e1378 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e1370 == 1023u));
                                                let _e1385 = ((_e1229.member[2] >> bitcast<u32>(_e1285)) & 1023u);
                                                let _e1393 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1385)) - 8388608f) * _e1296)) ^ _e139)));
                                                let _e1397 = select(select(_e816.member.member_1[2], _e1393, (_e1393 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e1385 == 1023u));
                                                let _e1401 = (_e1305 - _e590);
                                                let _e1404 = (((_e1261 - _e457) * _e629) - (_e1401 * _e497));
                                                let _e1407 = (((_e1283 - _e524) * _e629) - (_e1401 * _e563));
                                                let _e1410 = (_e1351 - _e590);
                                                let _e1413 = (((_e1321 - _e457) * _e629) - (_e1410 * _e497));
                                                let _e1416 = (((_e1336 - _e524) * _e629) - (_e1410 * _e563));
                                                let _e1419 = (_e1397 - _e590);
                                                let _e1422 = (((_e1367 - _e457) * _e629) - (_e1419 * _e497));
                                                let _e1425 = (((_e1382 - _e524) * _e629) - (_e1419 * _e563));
                                                let _e1426 = (_e1422 * _e1416);
                                                let _e1427 = (_e1425 * _e1413);
                                                let _e1428 = (_e1404 * _e1425);
                                                let _e1429 = (_e1407 * _e1422);
                                                let _e1430 = (_e1413 * _e1407);
                                                let _e1431 = (_e1416 * _e1404);
                                                let _e1436 = (((_e1426 >= _e1427) && (_e1428 >= _e1429)) && (_e1430 >= _e1431));
                                                if (_e1436 || (((_e1426 <= _e1427) && (_e1428 <= _e1429)) && (_e1430 <= _e1431))) {
                                                    let _e1443 = select(-1f, 1f, _e1436);
                                                    let _e1445 = ((_e1426 - _e1427) * _e1443);
                                                    let _e1447 = select(0f, _e1445, (_e1445 > 0f));
                                                    let _e1449 = ((_e1428 - _e1429) * _e1443);
                                                    let _e1451 = select(0f, _e1449, (_e1449 > 0f));
                                                    let _e1453 = ((_e1430 - _e1431) * _e1443);
                                                    let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                    let _e1457 = ((_e1447 + _e1451) + _e1455);
                                                    if (_e1457 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2582_ = type_22();
                                                        phi_2583_ = true;
                                                        phi_2584_ = false;
                                                    } else {
                                                        let _e1460 = select(_e1413, _e1404, (_e1404 < _e1413));
                                                        if (select(_e1422, _e1460, (_e1460 < _e1422)) > 0f) {
                                                            phi_1898_ = true;
                                                        } else {
                                                            let _e1465 = select(_e1413, _e1404, (_e1404 > _e1413));
                                                            phi_1898_ = (select(_e1422, _e1465, (_e1465 > _e1422)) < 0f);
                                                        }
                                                        let _e1470 = phi_1898_;
                                                        if _e1470 {
                                                            phi_2579_ = type_22();
                                                            phi_2580_ = true;
                                                            phi_2581_ = false;
                                                        } else {
                                                            let _e1472 = select(_e1416, _e1407, (_e1407 < _e1416));
                                                            if (select(_e1425, _e1472, (_e1472 < _e1425)) > 0f) {
                                                                phi_1927_ = true;
                                                            } else {
                                                                let _e1477 = select(_e1416, _e1407, (_e1407 > _e1416));
                                                                phi_1927_ = (select(_e1425, _e1477, (_e1477 > _e1425)) < 0f);
                                                            }
                                                            let _e1482 = phi_1927_;
                                                            if _e1482 {
                                                                phi_2577_ = type_22();
                                                                phi_2578_ = false;
                                                            } else {
                                                                let _e1484 = select(_e1321, _e1261, (_e1261 < _e1321));
                                                                let _e1488 = select(_e1321, _e1261, (_e1261 > _e1321));
                                                                let _e1492 = select(_e1336, _e1283, (_e1283 < _e1336));
                                                                let _e1496 = select(_e1336, _e1283, (_e1283 > _e1336));
                                                                let _e1500 = select(_e1351, _e1305, (_e1305 < _e1351));
                                                                let _e1504 = select(_e1351, _e1305, (_e1305 > _e1351));
                                                                let _e1509 = ((select(_e1367, _e1484, (_e1484 < _e1367)) - _e495) * _e500);
                                                                let _e1510 = ((select(_e1367, _e1488, (_e1488 > _e1367)) - _e496) * _e500);
                                                                let _e1513 = ((select(_e1382, _e1492, (_e1492 < _e1382)) - _e561) * _e566);
                                                                let _e1514 = ((select(_e1382, _e1496, (_e1496 > _e1382)) - _e562) * _e566);
                                                                let _e1517 = ((select(_e1397, _e1500, (_e1500 < _e1397)) - _e627) * _e632);
                                                                let _e1518 = ((select(_e1397, _e1504, (_e1504 > _e1397)) - _e628) * _e632);
                                                                let _e1520 = select(_e1518, _e1517, (_e1517 < _e1518));
                                                                let _e1522 = select(_e1518, _e1517, (_e1517 > _e1518));
                                                                let _e1524 = select(_e1510, _e1509, (_e1509 < _e1510));
                                                                let _e1526 = select(_e1514, _e1513, (_e1513 < _e1514));
                                                                let _e1528 = select(_e1526, _e1524, (_e1524 > _e1526));
                                                                let _e1530 = select(_e1520, _e1528, (_e1528 > _e1520));
                                                                let _e1532 = select(_e1510, _e1509, (_e1509 > _e1510));
                                                                let _e1534 = select(_e1514, _e1513, (_e1513 > _e1514));
                                                                let _e1536 = select(_e1534, _e1532, (_e1532 < _e1534));
                                                                let _e1538 = select(_e1522, _e1536, (_e1536 < _e1522));
                                                                let _e1539 = -(_e1520);
                                                                let _e1545 = select(_e743, _e1530, (_e1530 > _e743));
                                                                if (_e1545 > (_e1538 + (select(_e1539, _e1522, (_e1522 > _e1539)) * 0.0000019073523f))) {
                                                                    phi_2572_ = type_22();
                                                                    phi_2573_ = true;
                                                                } else {
                                                                    let _e1547 = (_e1545 > _e1197.member_1);
                                                                    if _e1547 {
                                                                        phi_2571_ = type_22();
                                                                    } else {
                                                                        let _e1548 = vec3<f32>(_e1261, _e1283, _e1305);
                                                                        let _e1549 = vec3<f32>(_e1321, _e1336, _e1351);
                                                                        let _e1550 = vec3<f32>(_e1367, _e1382, _e1397);
                                                                        let _e1551 = (_e1321 - _e1261);
                                                                        let _e1552 = (_e1336 - _e1283);
                                                                        let _e1553 = (_e1351 - _e1305);
                                                                        let _e1554 = vec3<f32>(_e1551, _e1552, _e1553);
                                                                        let _e1555 = (_e1367 - _e1321);
                                                                        let _e1556 = (_e1382 - _e1336);
                                                                        let _e1557 = (_e1397 - _e1351);
                                                                        let _e1558 = vec3<f32>(_e1555, _e1556, _e1557);
                                                                        let _e1559 = (_e1261 - _e1367);
                                                                        let _e1560 = (_e1283 - _e1382);
                                                                        let _e1561 = (_e1305 - _e1397);
                                                                        let _e1562 = vec3<f32>(_e1559, _e1560, _e1561);
                                                                        let _e1565 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                                        let _e1568 = bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u));
                                                                        let _e1570 = select(_e1568, _e1565, (_e1565 > _e1568));
                                                                        let _e1573 = bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u));
                                                                        let _e1575 = select(_e1573, _e1570, (_e1570 > _e1573));
                                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                                        let _e1581 = bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u));
                                                                        let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                                        let _e1586 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                                        let _e1588 = select(_e1586, _e1583, (_e1583 > _e1586));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                        let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                        let _e1601 = select(_e1599, _e1596, (_e1596 > _e1599));
                                                                        let _e1603 = select(_e1588, _e1575, (_e1575 > _e1588));
                                                                        let _e1605 = select(_e1601, _e1603, (_e1603 > _e1601));
                                                                        if (_e1575 == _e1605) {
                                                                            phi_2304_ = _e1416;
                                                                            phi_2305_ = _e1413;
                                                                            phi_2306_ = _e1407;
                                                                            phi_2307_ = _e1404;
                                                                            phi_2308_ = _e1548;
                                                                            phi_2309_ = _e1562;
                                                                            phi_2310_ = _e1558;
                                                                            phi_2311_ = _e1554;
                                                                        } else {
                                                                            let _e1607 = (_e1588 == _e1605);
                                                                            let _e1612 = vec3(_e1607);
                                                                            phi_2304_ = select(_e1407, _e1425, _e1607);
                                                                            phi_2305_ = select(_e1404, _e1422, _e1607);
                                                                            phi_2306_ = select(_e1425, _e1416, _e1607);
                                                                            phi_2307_ = select(_e1422, _e1413, _e1607);
                                                                            phi_2308_ = select(_e1550, _e1549, _e1612);
                                                                            phi_2309_ = select(_e1558, _e1554, _e1612);
                                                                            phi_2310_ = select(_e1554, _e1562, _e1612);
                                                                            phi_2311_ = select(_e1562, _e1558, _e1612);
                                                                        }
                                                                        let _e1618 = phi_2304_;
                                                                        let _e1620 = phi_2305_;
                                                                        let _e1622 = phi_2306_;
                                                                        let _e1624 = phi_2307_;
                                                                        let _e1626 = phi_2308_;
                                                                        let _e1628 = phi_2309_;
                                                                        let _e1630 = phi_2310_;
                                                                        let _e1632 = phi_2311_;
                                                                        let _e1639 = ((_e1630.y * _e1628.z) - (_e1628.y * _e1630.z));
                                                                        let _e1644 = ((_e1630.z * _e1628.x) - (_e1628.z * _e1630.x));
                                                                        let _e1647 = ((_e1630.x * _e1628.y) - (_e1628.x * _e1630.y));
                                                                        if (_e1447 >= _e1451) {
                                                                            phi_2342_ = select(true, false, (_e1447 >= _e1455));
                                                                        } else {
                                                                            phi_2342_ = true;
                                                                        }
                                                                        let _e1652 = phi_2342_;
                                                                        if _e1652 {
                                                                            phi_2351_ = select(_e1550, _e1549, vec3((_e1451 >= _e1455)));
                                                                        } else {
                                                                            phi_2351_ = _e1548;
                                                                        }
                                                                        let _e1657 = phi_2351_;
                                                                        let _e1668 = (((_e1639 * (_e1657.x - _e457)) + (_e1644 * (_e1657.y - _e524))) + (_e1647 * (_e1657.z - _e590)));
                                                                        let _e1673 = (((_e1639 * _e497) + (_e1644 * _e563)) + (_e1647 * _e629));
                                                                        let _e1674 = (_e1620 - _e1624);
                                                                        let _e1675 = (_e1618 - _e1622);
                                                                        let _e1683 = (-(((_e1624 * _e1674) + (_e1622 * _e1675))) / ((_e1674 * _e1674) + (_e1675 * _e1675)));
                                                                        let _e1685 = select(1f, _e1683, (_e1683 < 1f));
                                                                        let _e1687 = select(0f, _e1685, (_e1685 > 0f));
                                                                        let _e1700 = ((_e1626.x + (_e1632.x * _e1687)) - _e457);
                                                                        let _e1701 = ((_e1626.y + (_e1632.y * _e1687)) - _e524);
                                                                        let _e1702 = ((_e1626.z + (_e1632.z * _e1687)) - _e590);
                                                                        let _e1703 = (_e1702 / _e629);
                                                                        let _e1715 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                        let _e1718 = bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u));
                                                                        let _e1720 = select(_e1718, _e1715, (_e1715 > _e1718));
                                                                        let _e1723 = bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u));
                                                                        let _e1725 = select(_e1723, _e1720, (_e1720 > _e1723));
                                                                        let _e1731 = bitcast<f32>((bitcast<u32>(_e1639) & 2147483647u));
                                                                        let _e1734 = bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u));
                                                                        let _e1736 = select(_e1734, _e1731, (_e1731 > _e1734));
                                                                        let _e1739 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1639 * _e1700) + (_e1644 * _e1701)) + (_e1647 * _e1702)) - _e1668)) & 2147483647u)) <= ((0.0000009536743f * select(_e1605, _e1725, (_e1725 > _e1605))) * select(_e1739, _e1736, (_e1736 > _e1739)))) {
                                                                            let _e1749 = bitcast<f32>((bitcast<u32>(_e1630.x) & 2147483647u));
                                                                            let _e1752 = bitcast<f32>((bitcast<u32>(_e1630.y) & 2147483647u));
                                                                            let _e1754 = select(_e1752, _e1749, (_e1749 > _e1752));
                                                                            let _e1757 = bitcast<f32>((bitcast<u32>(_e1630.z) & 2147483647u));
                                                                            let _e1763 = bitcast<f32>((bitcast<u32>(_e1628.x) & 2147483647u));
                                                                            let _e1766 = bitcast<f32>((bitcast<u32>(_e1628.y) & 2147483647u));
                                                                            let _e1768 = select(_e1766, _e1763, (_e1763 > _e1766));
                                                                            let _e1771 = bitcast<f32>((bitcast<u32>(_e1628.z) & 2147483647u));
                                                                            let _e1775 = (bitcast<f32>((bitcast<u32>(_e1673) & 2147483647u)) > ((0.0000038146973f * select(_e1757, _e1754, (_e1754 > _e1757))) * select(_e1771, _e1768, (_e1768 > _e1771))));
                                                                            if _e1775 {
                                                                                phi_2516_ = (_e1668 / _e1673);
                                                                            } else {
                                                                                phi_2516_ = f32();
                                                                            }
                                                                            let _e1778 = phi_2516_;
                                                                            phi_2518_ = _e1778;
                                                                            phi_2519_ = select(true, false, _e1775);
                                                                        } else {
                                                                            phi_2518_ = f32();
                                                                            phi_2519_ = true;
                                                                        }
                                                                        let _e1781 = phi_2518_;
                                                                        let _e1783 = phi_2519_;
                                                                        if _e1783 {
                                                                            let _e1791 = (((_e1639 * (_e1700 - (_e497 * _e1703))) + (_e1644 * (_e1701 - (_e563 * _e1703)))) / _e1673);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u)) <= _e1605) {
                                                                                phi_2539_ = (_e1703 + _e1791);
                                                                            } else {
                                                                                phi_2539_ = _e1703;
                                                                            }
                                                                            let _e1798 = phi_2539_;
                                                                            phi_2540_ = _e1798;
                                                                        } else {
                                                                            phi_2540_ = _e1781;
                                                                        }
                                                                        let _e1800 = phi_2540_;
                                                                        let _e1802 = select(_e1538, _e1800, (_e1800 < _e1538));
                                                                        let _e1804 = select(_e1530, _e1802, (_e1802 > _e1530));
                                                                        if (_e1804 >= _e743) {
                                                                            let _e1806 = (_e1804 <= _e1197.member_1);
                                                                            if _e1806 {
                                                                                let _e1807 = (1f / _e1457);
                                                                                phi_2563_ = type_22(_e1804, (_e1451 * _e1807), (_e1455 * _e1807), _e1225);
                                                                            } else {
                                                                                phi_2563_ = type_22();
                                                                            }
                                                                            let _e1812 = phi_2563_;
                                                                            phi_2565_ = _e1812;
                                                                            phi_2566_ = select(true, false, _e1806);
                                                                        } else {
                                                                            phi_2565_ = type_22();
                                                                            phi_2566_ = true;
                                                                        }
                                                                        let _e1815 = phi_2565_;
                                                                        let _e1817 = phi_2566_;
                                                                        if _e1817 {
                                                                            phi_2570_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2570_ = _e1815;
                                                                        }
                                                                        let _e1819 = phi_2570_;
                                                                        phi_2571_ = _e1819;
                                                                    }
                                                                    let _e1821 = phi_2571_;
                                                                    phi_2572_ = _e1821;
                                                                    phi_2573_ = _e1547;
                                                                }
                                                                let _e1823 = phi_2572_;
                                                                let _e1825 = phi_2573_;
                                                                phi_2577_ = _e1823;
                                                                phi_2578_ = _e1825;
                                                            }
                                                            let _e1827 = phi_2577_;
                                                            let _e1829 = phi_2578_;
                                                            phi_2579_ = _e1827;
                                                            phi_2580_ = _e1482;
                                                            phi_2581_ = _e1829;
                                                        }
                                                        let _e1831 = phi_2579_;
                                                        let _e1833 = phi_2580_;
                                                        let _e1835 = phi_2581_;
                                                        phi_2582_ = _e1831;
                                                        phi_2583_ = _e1833;
                                                        phi_2584_ = _e1835;
                                                    }
                                                    let _e1837 = phi_2582_;
                                                    let _e1839 = phi_2583_;
                                                    let _e1841 = phi_2584_;
                                                    phi_2592_ = _e1837;
                                                    phi_2593_ = select(_e1841, true, _e1839);
                                                } else {
                                                    phi_2592_ = type_22();
                                                    phi_2593_ = true;
                                                }
                                                let _e1844 = phi_2592_;
                                                let _e1846 = phi_2593_;
                                                if _e1846 {
                                                    phi_2597_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2597_ = _e1844;
                                                }
                                                let _e1848 = phi_2597_;
                                                if (_e1848.member_3 != 4294967295u) {
                                                    if (_e1225 == _e156) {
                                                        phi_2914_ = false;
                                                    } else {
                                                        let _e1852 = (_e1225 < arrayLength((&global_4.member)));
                                                        if _e1852 {
                                                            if _e1852 {
                                                            } else {
                                                                phi_4200_ = true;
                                                                break;
                                                            }
                                                            let _e1854 = global_4.member[_e1225];
                                                            phi_2620_ = _e1854;
                                                        } else {
                                                            phi_2620_ = 4294967295u;
                                                        }
                                                        let _e1856 = phi_2620_;
                                                        let _e1857 = (_e1856 < arrayLength((&global_5.member)));
                                                        if _e1857 {
                                                            if _e1857 {
                                                            } else {
                                                                phi_4200_ = true;
                                                                break;
                                                            }
                                                            let _e1859 = global_5.member[_e1856];
                                                            phi_2634_ = _e1859;
                                                        } else {
                                                            phi_2634_ = 0i;
                                                        }
                                                        let _e1861 = phi_2634_;
                                                        let _e1862 = (_e1861 == 0i);
                                                        if _e1862 {
                                                            phi_2913_ = true;
                                                        } else {
                                                            if _e434 {
                                                                phi_2651_ = vec3<f32>(_e1261, _e1283, _e1305);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2650_ = vec3<f32>(_e1305, _e1261, _e1283);
                                                                } else {
                                                                    phi_2650_ = vec3<f32>(_e1283, _e1305, _e1261);
                                                                }
                                                                let _e1867 = phi_2650_;
                                                                phi_2651_ = _e1867;
                                                            }
                                                            let _e1870 = phi_2651_;
                                                            if _e434 {
                                                                phi_2664_ = vec3<f32>(_e1321, _e1336, _e1351);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2663_ = vec3<f32>(_e1351, _e1321, _e1336);
                                                                } else {
                                                                    phi_2663_ = vec3<f32>(_e1336, _e1351, _e1321);
                                                                }
                                                                let _e1875 = phi_2663_;
                                                                phi_2664_ = _e1875;
                                                            }
                                                            let _e1878 = phi_2664_;
                                                            if _e434 {
                                                                phi_2677_ = vec3<f32>(_e1367, _e1382, _e1397);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2676_ = vec3<f32>(_e1397, _e1367, _e1382);
                                                                } else {
                                                                    phi_2676_ = vec3<f32>(_e1382, _e1397, _e1367);
                                                                }
                                                                let _e1883 = phi_2676_;
                                                                phi_2677_ = _e1883;
                                                            }
                                                            let _e1886 = phi_2677_;
                                                            let _e1889 = (_e1878.x - _e1870.x);
                                                            let _e1892 = (_e1878.y - _e1870.y);
                                                            let _e1895 = (_e1878.z - _e1870.z);
                                                            let _e1897 = (_e1886.x - _e1870.x);
                                                            let _e1899 = (_e1886.y - _e1870.y);
                                                            let _e1901 = (_e1886.z - _e1870.z);
                                                            if (_e288.member_1 == 1u) {
                                                                phi_2713_ = (vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]) - _e1870);
                                                            } else {
                                                                phi_2713_ = vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]);
                                                            }
                                                            let _e1916 = phi_2713_;
                                                            let _e1922 = bitcast<f32>((bitcast<u32>((_e1889 * _e1899)) ^ _e288.member_3[0]));
                                                            let _e1926 = bitcast<f32>((bitcast<u32>((_e1892 * _e1897)) ^ _e288.member_3[0]));
                                                            let _e1930 = bitcast<f32>((bitcast<u32>((_e1892 * _e1901)) ^ _e288.member_3[0]));
                                                            let _e1934 = bitcast<f32>((bitcast<u32>((_e1895 * _e1899)) ^ _e288.member_3[0]));
                                                            let _e1938 = bitcast<f32>((bitcast<u32>((_e1895 * _e1897)) ^ _e288.member_3[0]));
                                                            let _e1942 = bitcast<f32>((bitcast<u32>((_e1889 * _e1901)) ^ _e288.member_3[0]));
                                                            let _e1943 = (_e1930 - _e1934);
                                                            let _e1944 = (_e1938 - _e1942);
                                                            let _e1945 = (_e1922 - _e1926);
                                                            let _e1969 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                            let _e1976 = (bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)));
                                                            let _e1983 = (bitcast<f32>((bitcast<u32>(_e1922) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1926) & 2147483647u)));
                                                            if (_e288.member_2 == 0f) {
                                                                phi_2895_ = 0f;
                                                            } else {
                                                                let _e2013 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                let _e2016 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                let _e2019 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                let _e2021 = select(_e2019, _e2016, (_e2016 > _e2019));
                                                                let _e2025 = select(_e2019, _e2016, (_e2016 < _e2019));
                                                                let _e2029 = select(_e2016, _e2013, (_e2013 < _e2016));
                                                                let _e2031 = select(_e2016, _e2013, (_e2013 > _e2016));
                                                                let _e2033 = select(_e2019, _e2031, (_e2031 < _e2019));
                                                                phi_2895_ = bitcast<f32>((bitcast<u32>((_e288.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2021, _e2013, (_e2013 > _e2021)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2033, _e2029, (_e2029 > _e2033)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2025, _e2013, (_e2013 < _e2025)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1969 + _e1976) + _e1983))) ^ _e288.member_3[0]))) * 1.0000005f)) ^ _e288.member_3[0])))) ^ _e288.member_3[0]));
                                                            }
                                                            let _e2060 = phi_2895_;
                                                            phi_2913_ = (_e1862 || !(((((bitcast<f32>((bitcast<u32>((_e1916.x * _e1943)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1916.y * _e1944)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1916.z * _e1945)) ^ _e288.member_3[0]))) * f32(-(_e1861))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.x) & 2147483647u)) * _e1969)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.y) & 2147483647u)) * _e1976)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1916.z) & 2147483647u)) * _e1983)) ^ _e288.member_3[0]))))) ^ _e288.member_3[0])) + _e2060) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2074 = phi_2913_;
                                                        phi_2914_ = _e2074;
                                                    }
                                                    let _e2076 = phi_2914_;
                                                    if _e2076 {
                                                        if (_e1848.member < _e1197.member.member) {
                                                            phi_2934_ = true;
                                                        } else {
                                                            if (_e1848.member == _e1197.member.member) {
                                                                phi_2933_ = (_e1848.member_3 < _e1197.member.member_3);
                                                            } else {
                                                                phi_2933_ = false;
                                                            }
                                                            let _e2086 = phi_2933_;
                                                            phi_2934_ = _e2086;
                                                        }
                                                        let _e2088 = phi_2934_;
                                                        if _e2088 {
                                                            phi_2940_ = type_38(_e1848, _e1848.member);
                                                        } else {
                                                            phi_2940_ = _e1197;
                                                        }
                                                        let _e2091 = phi_2940_;
                                                        phi_2941_ = _e2091;
                                                    } else {
                                                        phi_2941_ = _e1197;
                                                    }
                                                    let _e2093 = phi_2941_;
                                                    phi_2942_ = _e2093;
                                                } else {
                                                    phi_2942_ = _e1197;
                                                }
                                                let _e2095 = phi_2942_;
                                                phi_1438_ = _e2095;
                                            } else {
                                                phi_1438_ = type_38();
                                            }
                                            let _e2097 = phi_1438_;
                                            continue;
                                            continuing {
                                                phi_1437_ = _e2097;
                                                phi_1440_ = _e1212;
                                                phi_4200_ = _e775;
                                                break if !(_e1218);
                                            }
                                        }
                                        let _e2100 = phi_4200_;
                                        phi_4410_ = _e2100;
                                        if _e2100 {
                                            break;
                                        }
                                        phi_4414_ = _e2100;
                                        let _e2426 = local_11;
                                        phi_3915_ = _e2426;
                                        phi_3916_ = _e816;
                                        phi_3917_ = false;
                                        phi_3918_ = _e820;
                                    } else {
                                        let _e830 = (_e816.member_1 < _e96);
                                        if _e830 {
                                            if _e830 {
                                            } else {
                                                phi_4410_ = true;
                                                break;
                                            }
                                            let _e832 = global_9.member[_e816.member_1];
                                            phi_2961_ = _e832;
                                        } else {
                                            phi_2961_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e834 = phi_2961_;
                                        let _e849 = ((10u * _e410) & 31u);
                                        let _e852 = ((_e834.member[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e860 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[0] - _e816.member.member[0]) * 0.0009775171f)) ^ _e139));
                                        let _e865 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e869 = select(select(_e816.member.member_1[0], _e865, (_e865 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e852 == 1023u));
                                        let _e871 = ((10u * _e409) & 31u);
                                        let _e874 = ((_e834.member[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e882 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[1] - _e816.member.member[1]) * 0.0009775171f)) ^ _e139));
                                        let _e887 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e874)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e891 = select(select(_e816.member.member_1[1], _e887, (_e887 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e874 == 1023u));
                                        let _e893 = ((10u * _e411) & 31u);
                                        let _e896 = ((_e834.member[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e904 = bitcast<f32>((bitcast<u32>(((_e816.member.member_1[2] - _e816.member.member[2]) * 0.0009775171f)) ^ _e139));
                                        let _e909 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e913 = select(select(_e816.member.member_1[2], _e909, (_e909 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e896 == 1023u));
                                        let _e916 = ((_e834.member[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e924 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e916)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e928 = select(select(_e816.member.member_1[0], _e924, (_e924 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e916 == 1023u));
                                        let _e931 = ((_e834.member[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e939 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e943 = select(select(_e816.member.member_1[1], _e939, (_e939 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e931 == 1023u));
                                        let _e946 = ((_e834.member[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e954 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e946)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e958 = select(select(_e816.member.member_1[2], _e954, (_e954 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e946 == 1023u));
                                        let _e964 = ((_e834.member_1[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e972 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e964)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e976 = select(select(_e816.member.member_1[0], _e972, (_e972 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e964 == 1023u));
                                        let _e979 = ((_e834.member_1[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e987 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e979)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e991 = select(select(_e816.member.member_1[1], _e987, (_e987 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e979 == 1023u));
                                        let _e994 = ((_e834.member_1[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1002 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e994)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e1006 = select(select(_e816.member.member_1[2], _e1002, (_e1002 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e994 == 1023u));
                                        let _e1009 = ((_e834.member_1[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e1017 = (_e816.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1009)) - 8388608f) * _e860)) ^ _e139)));
                                        let _e1021 = select(select(_e816.member.member_1[0], _e1017, (_e1017 < _e816.member.member_1[0])), _e816.member.member_1[0], (_e1009 == 1023u));
                                        let _e1024 = ((_e834.member_1[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e1032 = (_e816.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1024)) - 8388608f) * _e882)) ^ _e139)));
                                        let _e1036 = select(select(_e816.member.member_1[1], _e1032, (_e1032 < _e816.member.member_1[1])), _e816.member.member_1[1], (_e1024 == 1023u));
                                        let _e1039 = ((_e834.member_1[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1047 = (_e816.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1039)) - 8388608f) * _e904)) ^ _e139)));
                                        let _e1051 = select(select(_e816.member.member_1[2], _e1047, (_e1047 < _e816.member.member_1[2])), _e816.member.member_1[2], (_e1039 == 1023u));
                                        let _e1056 = type_61(type_53(array<f32, 3>(_e869, _e891, _e913), array<f32, 3>(_e928, _e943, _e958)), _e834.member_2);
                                        let _e1061 = type_61(type_53(array<f32, 3>(_e976, _e991, _e1006), array<f32, 3>(_e1021, _e1036, _e1051)), _e834.member_3);
                                        let _e1067 = ((_e869 - _e495) * _e500);
                                        let _e1068 = ((_e976 - _e495) * _e500);
                                        let _e1069 = ((_e928 - _e496) * _e500);
                                        let _e1070 = ((_e1021 - _e496) * _e500);
                                        let _e1075 = ((_e891 - _e561) * _e566);
                                        let _e1076 = ((_e991 - _e561) * _e566);
                                        let _e1077 = ((_e943 - _e562) * _e566);
                                        let _e1078 = ((_e1036 - _e562) * _e566);
                                        let _e1083 = ((_e913 - _e627) * _e632);
                                        let _e1084 = ((_e1006 - _e627) * _e632);
                                        let _e1085 = ((_e958 - _e628) * _e632);
                                        let _e1086 = ((_e1051 - _e628) * _e632);
                                        let _e1088 = select(_e1085, _e1083, (_e1083 < _e1085));
                                        let _e1090 = select(_e1086, _e1084, (_e1084 < _e1086));
                                        let _e1092 = select(_e1085, _e1083, (_e1083 > _e1085));
                                        let _e1094 = select(_e1086, _e1084, (_e1084 > _e1086));
                                        let _e1096 = select(_e1069, _e1067, (_e1067 < _e1069));
                                        let _e1098 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1100 = select(_e1077, _e1075, (_e1075 < _e1077));
                                        let _e1102 = select(_e1078, _e1076, (_e1076 < _e1078));
                                        let _e1104 = select(_e1100, _e1096, (_e1096 > _e1100));
                                        let _e1106 = select(_e1102, _e1098, (_e1098 > _e1102));
                                        let _e1108 = select(_e1088, _e1104, (_e1104 > _e1088));
                                        let _e1110 = select(_e1090, _e1106, (_e1106 > _e1090));
                                        let _e1112 = select(_e1069, _e1067, (_e1067 > _e1069));
                                        let _e1114 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1116 = select(_e1077, _e1075, (_e1075 > _e1077));
                                        let _e1118 = select(_e1078, _e1076, (_e1076 > _e1078));
                                        let _e1120 = select(_e1116, _e1112, (_e1112 < _e1116));
                                        let _e1122 = select(_e1118, _e1114, (_e1114 < _e1118));
                                        let _e1127 = -(_e1088);
                                        let _e1128 = -(_e1090);
                                        let _e1135 = (select(_e1092, _e1120, (_e1120 < _e1092)) + (select(_e1127, _e1092, (_e1092 > _e1127)) * 0.0000019073523f));
                                        let _e1136 = (select(_e1094, _e1122, (_e1122 < _e1094)) + (select(_e1128, _e1094, (_e1094 > _e1128)) * 0.0000019073523f));
                                        let _e1138 = select(_e743, _e1108, (_e1108 > _e743));
                                        let _e1140 = select(_e743, _e1110, (_e1110 > _e743));
                                        let _e1145 = (_e1138 <= select(_e777.member_1, _e1135, (_e1135 < _e777.member_1)));
                                        let _e1146 = (_e1140 <= select(_e777.member_1, _e1136, (_e1136 < _e777.member_1)));
                                        let _e1147 = (_e1138 <= _e1140);
                                        if _e1145 {
                                            if _e1146 {
                                                if _e1147 {
                                                    phi_3817_ = _e1061;
                                                } else {
                                                    phi_3817_ = _e1056;
                                                }
                                                let _e1149 = phi_3817_;
                                                let _e1157 = (_e820 % 128u);
                                                let _e1158 = (_e1157 < 128u);
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_6[_e1157] = _e1149.member_1;
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_5[_e1157] = _e1149.member.member[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_4[_e1157] = _e1149.member.member[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_3[_e1157] = _e1149.member.member[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_2[_e1157] = _e1149.member.member_1[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_1[_e1157] = _e1149.member.member_1[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local[_e1157] = _e1149.member.member_1[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4410_ = true;
                                                    break;
                                                }
                                                local_7[_e1157] = select(_e1140, _e1138, (_e1138 > _e1140));
                                                if _e1147 {
                                                    phi_3894_ = _e1056;
                                                } else {
                                                    phi_3894_ = _e1061;
                                                }
                                                let _e1175 = phi_3894_;
                                                phi_3895_ = _e1175;
                                                phi_3896_ = (_e820 + 1u);
                                            } else {
                                                phi_3895_ = type_61();
                                                phi_3896_ = u32();
                                            }
                                            let _e1177 = phi_3895_;
                                            let _e1179 = phi_3896_;
                                            phi_3898_ = _e1177;
                                            phi_3899_ = _e1179;
                                            phi_3900_ = select(true, false, _e1146);
                                        } else {
                                            phi_3898_ = type_61();
                                            phi_3899_ = u32();
                                            phi_3900_ = true;
                                        }
                                        let _e1182 = phi_3898_;
                                        let _e1184 = phi_3899_;
                                        let _e1186 = phi_3900_;
                                        if _e1186 {
                                            if _e1145 {
                                                phi_3907_ = _e1056;
                                            } else {
                                                phi_3907_ = _e1061;
                                            }
                                            let _e1188 = phi_3907_;
                                            phi_3912_ = _e1188;
                                            phi_3913_ = select(_e1146, true, _e1145);
                                        } else {
                                            phi_3912_ = _e1182;
                                            phi_3913_ = _e818;
                                        }
                                        let _e1191 = phi_3912_;
                                        let _e1193 = phi_3913_;
                                        phi_4414_ = _e775;
                                        phi_3915_ = _e777;
                                        phi_3916_ = _e1191;
                                        phi_3917_ = _e1193;
                                        phi_3918_ = select(_e1184, _e820, _e1186);
                                    }
                                    let _e2102 = phi_4414_;
                                    let _e2104 = phi_3915_;
                                    let _e2106 = phi_3916_;
                                    let _e2108 = phi_3917_;
                                    let _e2110 = phi_3918_;
                                    phi_4413_ = _e2102;
                                    phi_3919_ = _e2104;
                                    phi_3920_ = _e2106;
                                    phi_3921_ = (_e781 - 1u);
                                    phi_3922_ = _e2108;
                                    phi_3923_ = _e2110;
                                } else {
                                    phi_4413_ = _e775;
                                    phi_3919_ = _e777;
                                    phi_3920_ = _e816;
                                    phi_3921_ = _e781;
                                    phi_3922_ = _e818;
                                    phi_3923_ = _e820;
                                }
                                let _e2112 = phi_4413_;
                                let _e2114 = phi_3919_;
                                let _e2116 = phi_3920_;
                                let _e2118 = phi_3921_;
                                let _e2120 = phi_3922_;
                                let _e2122 = phi_3923_;
                                phi_4412_ = _e2112;
                                phi_3924_ = _e2114;
                                phi_3925_ = _e2116;
                                phi_3926_ = _e2118;
                                phi_3927_ = _e2120;
                                phi_3928_ = _e2122;
                            } else {
                                phi_4412_ = _e775;
                                phi_3924_ = type_38();
                                phi_3925_ = type_61();
                                phi_3926_ = u32();
                                phi_3927_ = bool();
                                phi_3928_ = u32();
                            }
                            let _e2124 = phi_4412_;
                            let _e2126 = phi_3924_;
                            let _e2128 = phi_3925_;
                            let _e2130 = phi_3926_;
                            let _e2132 = phi_3927_;
                            let _e2134 = phi_3928_;
                            phi_4411_ = _e2124;
                            phi_1311_ = _e2126;
                            phi_1314_ = _e2128;
                            phi_1316_ = _e2130;
                            phi_1318_ = _e2132;
                            phi_1320_ = _e2134;
                            phi_3929_ = _e789;
                        } else {
                            phi_4411_ = _e775;
                            phi_1311_ = type_38();
                            phi_1314_ = type_61();
                            phi_1316_ = u32();
                            phi_1318_ = bool();
                            phi_1320_ = u32();
                            phi_3929_ = false;
                        }
                        let _e2136 = phi_4411_;
                        let _e2138 = phi_1311_;
                        let _e2140 = phi_1314_;
                        let _e2142 = phi_1316_;
                        let _e2144 = phi_1318_;
                        let _e2146 = phi_1320_;
                        let _e2148 = phi_3929_;
                        continue;
                        continuing {
                            phi_4206_ = _e2136;
                            phi_1310_ = _e2138;
                            phi_1313_ = _e2140;
                            phi_1315_ = _e2142;
                            phi_1317_ = _e2144;
                            phi_1319_ = _e2146;
                            phi_4410_ = _e2136;
                            break if !(_e2148);
                        }
                    }
                    let _e2151 = phi_4410_;
                    if _e2151 {
                        break;
                    }
                    let _e2153 = local_10;
                    if (_e2153.member.member_3 != 4294967295u) {
                        let _e2158 = bitcast<u32>(_e2153.member.member);
                        let _e2162 = (bitcast<i32>((_e2158 >> bitcast<u32>(23i))) & 255i);
                        let _e2163 = (_e2162 + _e412);
                        if (_e2162 == 255i) {
                            phi_3988_ = _e2153.member.member;
                        } else {
                            if (_e2162 > 0i) {
                                if (_e2163 > 0i) {
                                    let _e2167 = (_e2163 < 255i);
                                    if _e2167 {
                                        phi_3967_ = bitcast<f32>((_e2158 + bitcast<u32>((_e412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3967_ = f32();
                                    }
                                    let _e2174 = phi_3967_;
                                    phi_3969_ = _e2174;
                                    phi_3970_ = select(true, false, _e2167);
                                } else {
                                    phi_3969_ = f32();
                                    phi_3970_ = true;
                                }
                                let _e2177 = phi_3969_;
                                let _e2179 = phi_3970_;
                                phi_3971_ = _e2177;
                                phi_3972_ = _e2179;
                            } else {
                                phi_3971_ = f32();
                                phi_3972_ = true;
                            }
                            let _e2181 = phi_3971_;
                            let _e2183 = phi_3972_;
                            if _e2183 {
                                let _e2184 = (_e2158 & 2147483648u);
                                let _e2191 = ((_e2158 & 8388607u) | (select(0u, 1u, ((_e2158 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2195 = (_e2191 == 0u);
                                if _e2195 {
                                    phi_4170_ = bitcast<f32>(_e2184);
                                } else {
                                    let _e2200 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2191)), 32u, _e2195) - 8u);
                                    let _e2203 = (_e2191 << bitcast<u32>((_e2200 & 31u)));
                                    let _e2205 = ((_e2163 + select(0i, 1i, (_e2162 == 0i))) - bitcast<i32>(_e2200));
                                    if (_e2205 >= 255i) {
                                        phi_4160_ = bitcast<f32>((_e2184 | 2139095040u));
                                        phi_4161_ = f32();
                                        phi_4162_ = true;
                                    } else {
                                        let _e2207 = (_e2205 > 0i);
                                        if _e2207 {
                                            phi_4154_ = bitcast<f32>(((_e2184 | (bitcast<u32>(_e2205) << bitcast<u32>(23i))) | (_e2203 & 8388607u)));
                                            phi_4155_ = f32();
                                        } else {
                                            if (_e2205 < -24i) {
                                                phi_4120_ = 26u;
                                            } else {
                                                phi_4120_ = bitcast<u32>((1i - _e2205));
                                            }
                                            let _e2212 = phi_4120_;
                                            let _e2213 = (_e2212 & 31u);
                                            let _e2215 = (_e2203 >> bitcast<u32>(_e2213));
                                            let _e2219 = (_e2203 & ((1u << bitcast<u32>(_e2213)) - 1u));
                                            let _e2223 = (1u << bitcast<u32>(((_e2212 - 1u) & 31u)));
                                            if (_e2219 > _e2223) {
                                                phi_4141_ = true;
                                            } else {
                                                if (_e2219 == _e2223) {
                                                    phi_4138_ = ((_e2215 & 1u) == 1u);
                                                } else {
                                                    phi_4138_ = false;
                                                }
                                                let _e2229 = phi_4138_;
                                                phi_4141_ = _e2229;
                                            }
                                            let _e2231 = phi_4141_;
                                            phi_4154_ = f32();
                                            phi_4155_ = bitcast<f32>((_e2184 | (_e2215 + select(0u, 1u, _e2231))));
                                        }
                                        let _e2244 = phi_4154_;
                                        let _e2246 = phi_4155_;
                                        phi_4160_ = _e2244;
                                        phi_4161_ = _e2246;
                                        phi_4162_ = _e2207;
                                    }
                                    let _e2250 = phi_4160_;
                                    let _e2252 = phi_4161_;
                                    let _e2254 = phi_4162_;
                                    phi_4170_ = select(_e2252, _e2250, _e2254);
                                }
                                let _e2258 = phi_4170_;
                                phi_3987_ = _e2258;
                            } else {
                                phi_3987_ = _e2181;
                            }
                            let _e2260 = phi_3987_;
                            phi_3988_ = _e2260;
                        }
                        let _e2262 = phi_3988_;
                        let _e2263 = bitcast<u32>(_e2262);
                        if ((_e2263 & 2147483647u) >= 2139095040u) {
                            phi_4000_ = bitcast<f32>(((_e2263 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4000_ = _e2262;
                        }
                        let _e2270 = phi_4000_;
                        phi_4005_ = type_22(_e2270, _e2153.member.member_1, _e2153.member.member_2, _e2153.member.member_3);
                    } else {
                        phi_4005_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2275 = phi_4005_;
                    if _e289 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e2275;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e2279 = select(0u, 1u, (_e356 <= _e366));
                    if (_e2279 > 0u) {
                        let _e2281 = (1u < _e111);
                        if _e2281 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e2285 = atomicAdd((&global_8.member[0u]), _e2279);
                            if ((_e2285 + _e2279) < _e2285) {
                                if _e2281 {
                                } else {
                                    break;
                                }
                                let _e2290 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2293 = select(0u, 1u, (_e2275.member_3 != 4294967295u));
                    if (_e2293 > 0u) {
                        let _e2295 = (3u < _e111);
                        if _e2295 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e2299 = atomicAdd((&global_8.member[2u]), _e2293);
                            if ((_e2299 + _e2293) < _e2299) {
                                if _e2295 {
                                } else {
                                    break;
                                }
                                let _e2304 = atomicAdd((&global_8.member[3u]), 1u);
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
