struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_42 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_51 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_53 {
    member: type_51,
    member_1: u32,
}

struct type_58 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_44;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_58;
@group(0) @binding(1) 
var<storage> global_7: type_48;

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
    var phi_462_: i32;
    var phi_463_: i32;
    var phi_473_: bool;
    var phi_483_: u32;
    var phi_484_: u32;
    var phi_486_: bool;
    var phi_491_: u32;
    var phi_524_: i32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_588_: f32;
    var phi_594_: f32;
    var phi_667_: f32;
    var phi_673_: f32;
    var phi_713_: f32;
    var phi_719_: f32;
    var phi_792_: f32;
    var phi_798_: f32;
    var phi_838_: f32;
    var phi_844_: f32;
    var phi_963_: i32;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_1023_: i32;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1054_: f32;
    var phi_1055_: f32;
    var phi_3697_: bool;
    var phi_1147_: type_42;
    var phi_1150_: bool;
    var phi_1152_: type_53;
    var phi_1154_: u32;
    var phi_1156_: u32;
    var phi_1167_: bool;
    var phi_1253_: bool;
    var phi_1254_: type_53;
    var phi_1255_: u32;
    var phi_2238_: type_46;
    var phi_3127_: type_53;
    var phi_3203_: type_53;
    var phi_3204_: type_53;
    var phi_3205_: u32;
    var phi_3207_: type_53;
    var phi_3208_: u32;
    var phi_3209_: bool;
    var phi_3216_: type_53;
    var phi_3221_: bool;
    var phi_3222_: type_53;
    var phi_1273_: type_42;
    var phi_1276_: type_7;
    var phi_1277_: type_7;
    var phi_1299_: type_7;
    var phi_1323_: u32;
    var phi_1415_: array<array<f32, 3>, 3>;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1947_: f32;
    var phi_1948_: f32;
    var phi_1949_: vec3<f32>;
    var phi_1950_: vec3<f32>;
    var phi_1951_: vec3<f32>;
    var phi_1952_: vec3<f32>;
    var phi_2143_: f32;
    var phi_2163_: type_41;
    var phi_2164_: type_41;
    var phi_2167_: type_41;
    var phi_2168_: type_41;
    var phi_2169_: bool;
    var phi_2173_: type_41;
    var phi_2182_: type_23;
    var phi_2207_: bool;
    var phi_2208_: bool;
    var phi_2215_: type_42;
    var phi_2216_: type_42;
    var phi_2217_: type_42;
    var phi_1274_: type_42;
    var phi_3691_: bool;
    var local_10: type_42;
    var phi_3848_: bool;
    var phi_3224_: type_42;
    var phi_3225_: bool;
    var phi_3226_: type_53;
    var phi_3227_: u32;
    var phi_3847_: bool;
    var phi_3228_: type_42;
    var phi_3229_: bool;
    var phi_3230_: type_53;
    var phi_3231_: u32;
    var phi_3232_: u32;
    var phi_3846_: bool;
    var phi_3233_: type_42;
    var phi_3234_: bool;
    var phi_3235_: type_53;
    var phi_3236_: u32;
    var phi_3237_: u32;
    var phi_3845_: bool;
    var phi_1148_: type_42;
    var phi_1151_: bool;
    var phi_1153_: type_53;
    var phi_1155_: u32;
    var phi_1157_: u32;
    var phi_3238_: bool;
    var phi_3844_: bool;
    var local_11: type_42;
    var phi_3276_: f32;
    var phi_3278_: f32;
    var phi_3279_: bool;
    var phi_3280_: f32;
    var phi_3281_: bool;
    var phi_3611_: u32;
    var phi_3629_: bool;
    var phi_3632_: bool;
    var phi_3645_: f32;
    var phi_3646_: f32;
    var phi_3651_: f32;
    var phi_3652_: f32;
    var phi_3653_: bool;
    var phi_3661_: f32;
    var phi_3296_: f32;
    var phi_3297_: f32;
    var phi_3309_: f32;
    var phi_3314_: type_23;
    var local_12: type_42;
    var local_13: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_7.member));
            let _e92 = arrayLength((&global_1.member));
            let _e100 = arrayLength((&global_6.member));
            let _e104 = global_3.member[0u][0u];
            let _e108 = global_3.member[0u][1u];
            let _e112 = global_3.member[0u][2u];
            let _e116 = global_3.member[1u][0u];
            let _e120 = global_3.member[1u][1u];
            let _e124 = global_3.member[1u][2u];
            let _e128 = global_3.member[1u][3u];
            let _e132 = (_e87.x + (_e87.y * 2097152u));
            let _e139 = (_e132 < arrayLength((&global_4.member)));
            if _e139 {
                let _e140 = (_e132 < arrayLength((&global_2.member)));
                if _e140 {
                    let _e141 = (_e132 < arrayLength((&global_5.member)));
                    if _e141 {
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e151 = global_4.member[_e132].member.member_2[0u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_4.member[_e132].member.member_2[1u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_4.member[_e132].member.member_2[2u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_4.member[_e132].member.member[0u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_4.member[_e132].member.member[1u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e191 = global_4.member[_e132].member.member[2u];
                        let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                        let _e195 = select(_e161, _e153, (_e161 < _e153));
                        let _e197 = select(_e169, _e195, (_e169 < _e195));
                        let _e199 = select(_e177, _e197, (_e177 < _e197));
                        let _e201 = select(_e185, _e199, (_e185 < _e199));
                        let _e203 = select(_e193, _e201, (_e193 < _e201));
                        let _e208 = global_4.member[_e132].member.member_1;
                        let _e209 = bitcast<u32>(_e208);
                        let _e210 = (_e209 & 2147483647u);
                        let _e218 = global_4.member[_e132].member.member_3;
                        let _e219 = bitcast<u32>(_e218);
                        let _e220 = (_e219 & 2147483647u);
                        let _e224 = (((select(_e210, _e203, (_e210 < _e203)) < 2139095040u) && (_e220 <= 2139095040u)) && (_e197 > 0u));
                        if _e224 {
                            let _e227 = (bitcast<u32>(bitcast<f32>(_e197)) & 2147483647u);
                            if (_e227 >= 8388608u) {
                                phi_462_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_462_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_462_;
                            phi_463_ = _e241;
                        } else {
                            phi_463_ = 0i;
                        }
                        let _e243 = phi_463_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_473_ = true;
                        } else {
                            phi_473_ = (_e161 == _e197);
                        }
                        let _e247 = phi_473_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_483_ = _e249;
                            phi_484_ = _e249;
                            phi_486_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_483_ = u32();
                            phi_484_ = 0u;
                            phi_486_ = true;
                        }
                        let _e253 = phi_483_;
                        let _e255 = phi_484_;
                        let _e257 = phi_486_;
                        if _e257 {
                            phi_491_ = (_e255 + 1u);
                        } else {
                            phi_491_ = 0u;
                        }
                        let _e261 = phi_491_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_524_ = -126i;
                        } else {
                            phi_524_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_524_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_4.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_542_ = _e285[0];
                        } else {
                            phi_542_ = _e285[1];
                        }
                        let _e290 = phi_542_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_548_ = _e285[2];
                        } else {
                            phi_548_ = _e290;
                        }
                        let _e294 = phi_548_;
                        let _e295 = bitcast<u32>(_e294);
                        let _e297 = ((_e295 & 2139095040u) != 0u);
                        let _e309 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * select(0.00000011920929f, 1f, _e297));
                        let _e310 = global_4.member[_e132].member.member_2;
                        if _e286 {
                            phi_588_ = _e310[0];
                        } else {
                            phi_588_ = _e310[1];
                        }
                        let _e314 = phi_588_;
                        if _e291 {
                            phi_594_ = _e310[2];
                        } else {
                            phi_594_ = _e314;
                        }
                        let _e317 = phi_594_;
                        let _e318 = bitcast<u32>(_e317);
                        let _e320 = ((_e318 & 2139095040u) != 0u);
                        let _e334 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e318 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e318 & 2147483648u))), _e317, _e320) * _e274) * select(0.00000011920929f, 1f, _e320)) * _e280);
                        let _e338 = (bitcast<f32>((bitcast<u32>(_e334) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e341 = bitcast<f32>((bitcast<u32>(_e309) & 2147483647u));
                        let _e342 = (_e341 * 0.00000011920929f);
                        let _e345 = select(select(0.00000000000011368684f, _e342, (_e342 > 0.00000000000011368684f)), 0f, _e338);
                        let _e346 = select(0f, _e334, _e338);
                        let _e347 = (_e309 + _e345);
                        let _e348 = (_e309 - _e345);
                        let _e350 = select(38685626000000000000000000f, (1f / _e334), _e338);
                        let _e351 = (_e261 == 0u);
                        if _e351 {
                            phi_667_ = _e285[0];
                        } else {
                            phi_667_ = _e285[1];
                        }
                        let _e355 = phi_667_;
                        let _e356 = (_e261 == 2u);
                        if _e356 {
                            phi_673_ = _e285[2];
                        } else {
                            phi_673_ = _e355;
                        }
                        let _e359 = phi_673_;
                        let _e360 = bitcast<u32>(_e359);
                        let _e362 = ((_e360 & 2139095040u) != 0u);
                        let _e374 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e360 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e360 & 2147483648u))), _e359, _e362) * select(0.00000011920929f, 1f, _e362));
                        if _e351 {
                            phi_713_ = _e310[0];
                        } else {
                            phi_713_ = _e310[1];
                        }
                        let _e378 = phi_713_;
                        if _e356 {
                            phi_719_ = _e310[2];
                        } else {
                            phi_719_ = _e378;
                        }
                        let _e381 = phi_719_;
                        let _e382 = bitcast<u32>(_e381);
                        let _e384 = ((_e382 & 2139095040u) != 0u);
                        let _e398 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e382 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e382 & 2147483648u))), _e381, _e384) * _e274) * select(0.00000011920929f, 1f, _e384)) * _e280);
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e405 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                        let _e406 = (_e405 * 0.00000011920929f);
                        let _e409 = select(select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f)), 0f, _e402);
                        let _e410 = select(0f, _e398, _e402);
                        let _e411 = (_e374 + _e409);
                        let _e412 = (_e374 - _e409);
                        let _e414 = select(38685626000000000000000000f, (1f / _e398), _e402);
                        let _e415 = (_e263 == 0u);
                        if _e415 {
                            phi_792_ = _e285[0];
                        } else {
                            phi_792_ = _e285[1];
                        }
                        let _e419 = phi_792_;
                        let _e420 = (_e263 == 2u);
                        if _e420 {
                            phi_798_ = _e285[2];
                        } else {
                            phi_798_ = _e419;
                        }
                        let _e423 = phi_798_;
                        let _e424 = bitcast<u32>(_e423);
                        let _e426 = ((_e424 & 2139095040u) != 0u);
                        let _e438 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e424 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e424 & 2147483648u))), _e423, _e426) * select(0.00000011920929f, 1f, _e426));
                        if _e415 {
                            phi_838_ = _e310[0];
                        } else {
                            phi_838_ = _e310[1];
                        }
                        let _e442 = phi_838_;
                        if _e420 {
                            phi_844_ = _e310[2];
                        } else {
                            phi_844_ = _e442;
                        }
                        let _e445 = phi_844_;
                        let _e446 = bitcast<u32>(_e445);
                        let _e448 = ((_e446 & 2139095040u) != 0u);
                        let _e462 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e446 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e446 & 2147483648u))), _e445, _e448) * _e274) * select(0.00000011920929f, 1f, _e448)) * _e280);
                        let _e466 = (bitcast<f32>((bitcast<u32>(_e462) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e469 = bitcast<f32>((bitcast<u32>(_e438) & 2147483647u));
                        let _e470 = (_e469 * 0.00000011920929f);
                        let _e473 = select(select(0.00000000000011368684f, _e470, (_e470 > 0.00000000000011368684f)), 0f, _e466);
                        let _e474 = select(0f, _e462, _e466);
                        let _e475 = (_e438 + _e473);
                        let _e476 = (_e438 - _e473);
                        let _e478 = select(38685626000000000000000000f, (1f / _e462), _e466);
                        let _e480 = select(_e405, _e341, (_e341 > _e405));
                        if (_e224 && (select(_e469, _e480, (_e480 > _e469)) <= 1099511600000f)) {
                            let _e492 = ((_e210 & 8388607u) | (select(0u, 1u, ((_e210 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e495 = bitcast<i32>((_e210 >> bitcast<u32>(23i)));
                            let _e499 = (_e492 == 0u);
                            let _e502 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e492)), 32u, _e499)) - 8i);
                            if (_e495 == 255i) {
                                phi_963_ = 255i;
                            } else {
                                phi_963_ = (((_e495 + select(0i, 1i, (_e495 == 0i))) - _e502) + _e243);
                            }
                            let _e510 = phi_963_;
                            let _e520 = (_e510 <= 0i);
                            if _e520 {
                                phi_986_ = u32();
                            } else {
                                if _e499 {
                                    phi_985_ = u32();
                                } else {
                                    phi_985_ = select(((bitcast<u32>(_e510) << bitcast<u32>(23i)) | ((_e492 << bitcast<u32>(((_e502 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e510 >= 255i));
                                }
                                let _e524 = phi_985_;
                                phi_986_ = _e524;
                            }
                            let _e526 = phi_986_;
                            let _e538 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e541 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                            let _e545 = (_e538 == 0u);
                            let _e548 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e538)), 32u, _e545)) - 8i);
                            if (_e541 == 255i) {
                                phi_1023_ = 255i;
                            } else {
                                phi_1023_ = (((_e541 + select(0i, 1i, (_e541 == 0i))) - _e548) + _e243);
                            }
                            let _e556 = phi_1023_;
                            let _e566 = (_e556 <= 0i);
                            if _e566 {
                                phi_1046_ = u32();
                            } else {
                                if _e545 {
                                    phi_1045_ = u32();
                                } else {
                                    phi_1045_ = select(((bitcast<u32>(_e556) << bitcast<u32>(23i)) | ((_e538 << bitcast<u32>(((_e548 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e556 >= 255i));
                                }
                                let _e570 = phi_1045_;
                                phi_1046_ = _e570;
                            }
                            let _e572 = phi_1046_;
                            phi_1054_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e572, 0u, select(_e545, true, _e566))));
                            phi_1055_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e526, 0u, select(_e499, true, _e520))));
                        } else {
                            phi_1054_ = 0f;
                            phi_1055_ = 1f;
                        }
                        let _e578 = phi_1054_;
                        let _e580 = phi_1055_;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e586 = global_4.member[_e132].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                        let _e592 = (_e262 % 3u);
                        let _e593 = (_e592 < 3u);
                        if _e593 {
                        } else {
                            break;
                        }
                        let _e595 = local_9[_e592];
                        let _e596 = (_e261 % 3u);
                        let _e597 = (_e596 < 3u);
                        if _e597 {
                        } else {
                            break;
                        }
                        let _e599 = local_9[_e596];
                        let _e600 = (_e263 % 3u);
                        let _e601 = (_e600 < 3u);
                        if _e601 {
                        } else {
                            break;
                        }
                        let _e603 = local_9[_e600];
                        local_8 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                        if _e593 {
                        } else {
                            break;
                        }
                        let _e607 = local_8[_e592];
                        if _e597 {
                        } else {
                            break;
                        }
                        let _e609 = local_8[_e596];
                        if _e601 {
                        } else {
                            break;
                        }
                        let _e611 = local_8[_e600];
                        phi_3697_ = false;
                        phi_1147_ = type_42(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e578), 0u, 0u);
                        phi_1150_ = (_e580 <= _e578);
                        phi_1152_ = type_53(type_51(array<f32, 3>(_e595, _e599, _e603), array<f32, 3>(_e607, _e609, _e611)), select(0u, 2147483648u, (_e90 == 0u)));
                        phi_1154_ = 0u;
                        phi_1156_ = ((3u * _e90) + 1u);
                        loop {
                            let _e617 = phi_3697_;
                            let _e619 = phi_1147_;
                            let _e621 = phi_1150_;
                            let _e623 = phi_1152_;
                            let _e625 = phi_1154_;
                            let _e627 = phi_1156_;
                            local_11 = _e619;
                            local_12 = _e619;
                            if _e621 {
                                phi_1167_ = true;
                            } else {
                                phi_1167_ = (_e625 > 0u);
                            }
                            let _e630 = phi_1167_;
                            if _e630 {
                                let _e631 = (_e627 > 0u);
                                if _e631 {
                                    if _e621 {
                                        phi_1253_ = _e621;
                                        phi_1254_ = _e623;
                                        phi_1255_ = _e625;
                                    } else {
                                        let _e632 = (_e625 - 1u);
                                        let _e633 = (_e632 % 128u);
                                        let _e634 = (_e633 < 128u);
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e636 = local_6[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e638 = local_5[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e640 = local_4[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e642 = local_3[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e645 = local_2[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e647 = local_1[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e649 = local[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3844_ = true;
                                            break;
                                        }
                                        let _e654 = local_7[_e633];
                                        phi_1253_ = (_e654 <= _e619.member.member_1);
                                        phi_1254_ = type_53(type_51(array<f32, 3>(_e638, _e640, _e642), array<f32, 3>(_e645, _e647, _e649)), _e636);
                                        phi_1255_ = _e632;
                                    }
                                    let _e659 = phi_1253_;
                                    let _e661 = phi_1254_;
                                    let _e663 = phi_1255_;
                                    if _e659 {
                                        if ((_e661.member_1 & 2147483648u) != 0u) {
                                            phi_1273_ = _e619;
                                            phi_1276_ = type_7(0u, ((_e661.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1045 = phi_1273_;
                                                let _e1047 = phi_1276_;
                                                local_10 = _e1045;
                                                local_13 = _e1045;
                                                if (_e1047.member < _e1047.member_1) {
                                                    phi_1277_ = type_7((_e1047.member + 1u), _e1047.member_1);
                                                    phi_1299_ = type_7(1u, _e1047.member);
                                                } else {
                                                    phi_1277_ = _e1047;
                                                    phi_1299_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1060 = phi_1277_;
                                                let _e1062 = phi_1299_;
                                                let _e1066 = (bitcast<i32>(_e1062.member) != 0i);
                                                if _e1066 {
                                                    let _e1072 = type_42(_e1045.member, _e1045.member_1, (_e1045.member_2 + 1u));
                                                    let _e1073 = ((_e661.member_1 & 268435455u) + _e1062.member_1);
                                                    let _e1074 = (_e1073 < _e92);
                                                    if _e1074 {
                                                        if _e1074 {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1078 = global_1.member[_e1073].member_1;
                                                        phi_1323_ = _e1078;
                                                    } else {
                                                        phi_1323_ = 4294967295u;
                                                    }
                                                    let _e1080 = phi_1323_;
                                                    if (_e1073 >= _e92) {
                                                        phi_1415_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1074 {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        if (_e592 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1087 = global_1.member[_e1073].member[_e592];
                                                        if (_e596 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1093 = global_1.member[_e1073].member[_e596];
                                                        if (_e600 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1099 = global_1.member[_e1073].member[_e600];
                                                        let _e1101 = (3u + _e592);
                                                        if (_e1101 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1107 = global_1.member[_e1073].member[_e1101];
                                                        let _e1108 = (3u + _e596);
                                                        if (_e1108 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1114 = global_1.member[_e1073].member[_e1108];
                                                        let _e1115 = (3u + _e600);
                                                        if (_e1115 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1121 = global_1.member[_e1073].member[_e1115];
                                                        let _e1123 = (6u + _e592);
                                                        if (_e1123 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1129 = global_1.member[_e1073].member[_e1123];
                                                        let _e1130 = (6u + _e596);
                                                        if (_e1130 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1136 = global_1.member[_e1073].member[_e1130];
                                                        let _e1137 = (6u + _e600);
                                                        if (_e1137 < 9u) {
                                                        } else {
                                                            phi_3691_ = true;
                                                            break;
                                                        }
                                                        let _e1143 = global_1.member[_e1073].member[_e1137];
                                                        phi_1415_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1087, _e1093, _e1099), array<f32, 3>(_e1107, _e1114, _e1121), array<f32, 3>(_e1129, _e1136, _e1143));
                                                    }
                                                    let _e1147 = phi_1415_;
                                                    let _e1164 = (_e1147[0][2] - _e438);
                                                    let _e1167 = (((_e1147[0][0] - _e309) * _e474) - (_e1164 * _e346));
                                                    let _e1170 = (((_e1147[0][1] - _e374) * _e474) - (_e1164 * _e410));
                                                    let _e1173 = (_e1147[1][2] - _e438);
                                                    let _e1176 = (((_e1147[1][0] - _e309) * _e474) - (_e1173 * _e346));
                                                    let _e1179 = (((_e1147[1][1] - _e374) * _e474) - (_e1173 * _e410));
                                                    let _e1182 = (_e1147[2][2] - _e438);
                                                    let _e1185 = (((_e1147[2][0] - _e309) * _e474) - (_e1182 * _e346));
                                                    let _e1188 = (((_e1147[2][1] - _e374) * _e474) - (_e1182 * _e410));
                                                    let _e1189 = (_e1185 * _e1179);
                                                    let _e1190 = (_e1188 * _e1176);
                                                    let _e1191 = (_e1167 * _e1188);
                                                    let _e1192 = (_e1170 * _e1185);
                                                    let _e1193 = (_e1176 * _e1170);
                                                    let _e1194 = (_e1179 * _e1167);
                                                    let _e1199 = (((_e1189 >= _e1190) && (_e1191 >= _e1192)) && (_e1193 >= _e1194));
                                                    let _e1205 = (_e1199 || (((_e1189 <= _e1190) && (_e1191 <= _e1192)) && (_e1193 <= _e1194)));
                                                    if _e1205 {
                                                        let _e1207 = select(-1f, 1f, _e1199);
                                                        let _e1209 = ((_e1189 - _e1190) * _e1207);
                                                        let _e1211 = select(0f, _e1209, (_e1209 > 0f));
                                                        let _e1213 = ((_e1191 - _e1192) * _e1207);
                                                        let _e1215 = select(0f, _e1213, (_e1213 > 0f));
                                                        let _e1217 = ((_e1193 - _e1194) * _e1207);
                                                        let _e1219 = select(0f, _e1217, (_e1217 > 0f));
                                                        let _e1221 = ((_e1211 + _e1215) + _e1219);
                                                        let _e1223 = select(_e1147[1][0], _e1147[0][0], (_e1147[0][0] < _e1147[1][0]));
                                                        let _e1227 = select(_e1147[1][0], _e1147[0][0], (_e1147[0][0] > _e1147[1][0]));
                                                        let _e1231 = select(_e1147[1][1], _e1147[0][1], (_e1147[0][1] < _e1147[1][1]));
                                                        let _e1235 = select(_e1147[1][1], _e1147[0][1], (_e1147[0][1] > _e1147[1][1]));
                                                        let _e1239 = select(_e1147[1][2], _e1147[0][2], (_e1147[0][2] < _e1147[1][2]));
                                                        let _e1243 = select(_e1147[1][2], _e1147[0][2], (_e1147[0][2] > _e1147[1][2]));
                                                        let _e1248 = ((select(_e1147[2][0], _e1223, (_e1223 < _e1147[2][0])) - _e347) * _e350);
                                                        let _e1249 = ((select(_e1147[2][0], _e1227, (_e1227 > _e1147[2][0])) - _e348) * _e350);
                                                        let _e1252 = ((select(_e1147[2][1], _e1231, (_e1231 < _e1147[2][1])) - _e411) * _e414);
                                                        let _e1253 = ((select(_e1147[2][1], _e1235, (_e1235 > _e1147[2][1])) - _e412) * _e414);
                                                        let _e1256 = ((select(_e1147[2][2], _e1239, (_e1239 < _e1147[2][2])) - _e475) * _e478);
                                                        let _e1257 = ((select(_e1147[2][2], _e1243, (_e1243 > _e1147[2][2])) - _e476) * _e478);
                                                        let _e1259 = select(_e1257, _e1256, (_e1256 < _e1257));
                                                        let _e1261 = select(_e1257, _e1256, (_e1256 > _e1257));
                                                        let _e1263 = select(_e1249, _e1248, (_e1248 < _e1249));
                                                        let _e1265 = select(_e1253, _e1252, (_e1252 < _e1253));
                                                        let _e1267 = select(_e1265, _e1263, (_e1263 > _e1265));
                                                        let _e1269 = select(_e1259, _e1267, (_e1267 > _e1259));
                                                        let _e1271 = select(_e1249, _e1248, (_e1248 > _e1249));
                                                        let _e1273 = select(_e1253, _e1252, (_e1252 > _e1253));
                                                        let _e1275 = select(_e1273, _e1271, (_e1271 < _e1273));
                                                        let _e1277 = select(_e1261, _e1275, (_e1275 < _e1261));
                                                        let _e1278 = -(_e1259);
                                                        let _e1284 = select(_e580, _e1269, (_e1269 > _e580));
                                                        let _e1288 = select(_e1176, _e1167, (_e1167 < _e1176));
                                                        let _e1293 = select(_e1176, _e1167, (_e1167 > _e1176));
                                                        let _e1300 = select(_e1179, _e1170, (_e1170 < _e1179));
                                                        let _e1305 = select(_e1179, _e1170, (_e1170 > _e1179));
                                                        let _e1314 = (((((_e1205 && (_e1221 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1185, _e1288, (_e1288 < _e1185)) <= 0f) && (select(_e1185, _e1293, (_e1293 > _e1185)) >= 0f))) && ((select(_e1188, _e1300, (_e1300 < _e1188)) <= 0f) && (select(_e1188, _e1305, (_e1305 > _e1188)) >= 0f))) && (_e1284 <= (_e1277 + (select(_e1278, _e1261, (_e1261 > _e1278)) * 0.0000019073523f)))) && (_e1284 <= _e1045.member.member_1));
                                                        if _e1314 {
                                                            let _e1319 = (_e1147[1][0] - _e1147[0][0]);
                                                            let _e1320 = (_e1147[1][1] - _e1147[0][1]);
                                                            let _e1321 = (_e1147[1][2] - _e1147[0][2]);
                                                            let _e1322 = vec3<f32>(_e1319, _e1320, _e1321);
                                                            let _e1323 = (_e1147[2][0] - _e1147[1][0]);
                                                            let _e1324 = (_e1147[2][1] - _e1147[1][1]);
                                                            let _e1325 = (_e1147[2][2] - _e1147[1][2]);
                                                            let _e1326 = vec3<f32>(_e1323, _e1324, _e1325);
                                                            let _e1327 = (_e1147[0][0] - _e1147[2][0]);
                                                            let _e1328 = (_e1147[0][1] - _e1147[2][1]);
                                                            let _e1329 = (_e1147[0][2] - _e1147[2][2]);
                                                            let _e1330 = vec3<f32>(_e1327, _e1328, _e1329);
                                                            let _e1333 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                            let _e1336 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                            let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                            let _e1341 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                            let _e1343 = select(_e1341, _e1338, (_e1338 > _e1341));
                                                            let _e1346 = bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u));
                                                            let _e1349 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                            let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                            let _e1354 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                            let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                            let _e1359 = bitcast<f32>((bitcast<u32>(_e1327) & 2147483647u));
                                                            let _e1362 = bitcast<f32>((bitcast<u32>(_e1328) & 2147483647u));
                                                            let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                            let _e1367 = bitcast<f32>((bitcast<u32>(_e1329) & 2147483647u));
                                                            let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                            let _e1371 = select(_e1356, _e1343, (_e1343 > _e1356));
                                                            let _e1373 = select(_e1369, _e1371, (_e1371 > _e1369));
                                                            if (_e1343 == _e1373) {
                                                                phi_1945_ = _e1179;
                                                                phi_1946_ = _e1176;
                                                                phi_1947_ = _e1170;
                                                                phi_1948_ = _e1167;
                                                                phi_1949_ = vec3<f32>(_e1147[0][0], _e1147[0][1], _e1147[0][2]);
                                                                phi_1950_ = _e1330;
                                                                phi_1951_ = _e1326;
                                                                phi_1952_ = _e1322;
                                                            } else {
                                                                let _e1375 = (_e1356 == _e1373);
                                                                let _e1380 = vec3(_e1375);
                                                                phi_1945_ = select(_e1170, _e1188, _e1375);
                                                                phi_1946_ = select(_e1167, _e1185, _e1375);
                                                                phi_1947_ = select(_e1188, _e1179, _e1375);
                                                                phi_1948_ = select(_e1185, _e1176, _e1375);
                                                                phi_1949_ = select(vec3<f32>(_e1147[2][0], _e1147[2][1], _e1147[2][2]), vec3<f32>(_e1147[1][0], _e1147[1][1], _e1147[1][2]), _e1380);
                                                                phi_1950_ = select(_e1326, _e1322, _e1380);
                                                                phi_1951_ = select(_e1322, _e1330, _e1380);
                                                                phi_1952_ = select(_e1330, _e1326, _e1380);
                                                            }
                                                            let _e1386 = phi_1945_;
                                                            let _e1388 = phi_1946_;
                                                            let _e1390 = phi_1947_;
                                                            let _e1392 = phi_1948_;
                                                            let _e1394 = phi_1949_;
                                                            let _e1396 = phi_1950_;
                                                            let _e1398 = phi_1951_;
                                                            let _e1400 = phi_1952_;
                                                            let _e1407 = ((_e1398.y * _e1396.z) - (_e1396.y * _e1398.z));
                                                            let _e1412 = ((_e1398.z * _e1396.x) - (_e1396.z * _e1398.x));
                                                            let _e1415 = ((_e1398.x * _e1396.y) - (_e1396.x * _e1398.y));
                                                            let _e1418 = ((_e1211 >= _e1215) && (_e1211 >= _e1219));
                                                            let _e1419 = (_e1215 >= _e1219);
                                                            let _e1433 = (((_e1407 * (select(select(_e1147[2][0], _e1147[1][0], _e1419), _e1147[0][0], _e1418) - _e309)) + (_e1412 * (select(select(_e1147[2][1], _e1147[1][1], _e1419), _e1147[0][1], _e1418) - _e374))) + (_e1415 * (select(select(_e1147[2][2], _e1147[1][2], _e1419), _e1147[0][2], _e1418) - _e438)));
                                                            let _e1438 = (((_e1407 * _e346) + (_e1412 * _e410)) + (_e1415 * _e474));
                                                            let _e1439 = (_e1388 - _e1392);
                                                            let _e1440 = (_e1386 - _e1390);
                                                            let _e1443 = ((_e1439 * _e1439) + (_e1440 * _e1440));
                                                            let _e1450 = (-(((_e1392 * _e1439) + (_e1390 * _e1440))) / select(0.000000000000000000000000000000000000011754944f, _e1443, (_e1443 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1452 = select(1f, _e1450, (_e1450 < 1f));
                                                            let _e1454 = select(0f, _e1452, (_e1452 > 0f));
                                                            let _e1463 = ((_e1394.x + (_e1400.x * _e1454)) - _e309);
                                                            let _e1466 = ((_e1394.y + (_e1400.y * _e1454)) - _e374);
                                                            let _e1469 = ((_e1394.z + (_e1400.z * _e1454)) - _e438);
                                                            let _e1472 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                            let _e1475 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                            let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                            let _e1480 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                            let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                                                            let _e1488 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                            let _e1491 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                            let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                            let _e1496 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                            let _e1515 = bitcast<f32>((bitcast<u32>(_e1398.x) & 2147483647u));
                                                            let _e1518 = bitcast<f32>((bitcast<u32>(_e1398.y) & 2147483647u));
                                                            let _e1520 = select(_e1518, _e1515, (_e1515 > _e1518));
                                                            let _e1523 = bitcast<f32>((bitcast<u32>(_e1398.z) & 2147483647u));
                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1396.x) & 2147483647u));
                                                            let _e1532 = bitcast<f32>((bitcast<u32>(_e1396.y) & 2147483647u));
                                                            let _e1534 = select(_e1532, _e1529, (_e1529 > _e1532));
                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1396.z) & 2147483647u));
                                                            let _e1543 = ((bitcast<f32>((bitcast<u32>(((((_e1407 * _e1463) + (_e1412 * _e1466)) + (_e1415 * _e1469)) - _e1433)) & 2147483647u)) <= ((0.0000009536743f * select(_e1373, _e1482, (_e1482 > _e1373))) * select(_e1496, _e1493, (_e1493 > _e1496)))) && !((bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u)) <= ((0.0000038146973f * select(_e1523, _e1520, (_e1520 > _e1523))) * select(_e1537, _e1534, (_e1534 > _e1537))))));
                                                            let _e1544 = (_e1433 / _e1438);
                                                            if (_e1314 && !(_e1543)) {
                                                                let _e1547 = (_e1469 / _e474);
                                                                let _e1555 = (((_e1407 * (_e1463 - (_e346 * _e1547))) + (_e1412 * (_e1466 - (_e410 * _e1547)))) / _e1438);
                                                                phi_2143_ = select(select(_e1547, (_e1547 + _e1555), (bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u)) <= _e1373)), _e1544, _e1543);
                                                            } else {
                                                                phi_2143_ = _e1544;
                                                            }
                                                            let _e1564 = phi_2143_;
                                                            let _e1566 = select(_e1277, _e1564, (_e1564 < _e1277));
                                                            let _e1568 = select(_e1269, _e1566, (_e1566 > _e1269));
                                                            let _e1569 = (1f / _e1221);
                                                            phi_2163_ = type_41(_e1568, (_e1215 * _e1569), (_e1219 * _e1569), ((_e1314 && (_e1568 >= _e580)) && (_e1568 <= _e1045.member.member_1)));
                                                            phi_2164_ = type_41();
                                                        } else {
                                                            phi_2163_ = type_41();
                                                            phi_2164_ = type_41(0f, 0f, 0f, _e1314);
                                                        }
                                                        let _e1578 = phi_2163_;
                                                        let _e1580 = phi_2164_;
                                                        phi_2167_ = _e1578;
                                                        phi_2168_ = _e1580;
                                                        phi_2169_ = select(true, false, _e1314);
                                                    } else {
                                                        phi_2167_ = type_41();
                                                        phi_2168_ = type_41(0f, 0f, 0f, _e1205);
                                                        phi_2169_ = true;
                                                    }
                                                    let _e1583 = phi_2167_;
                                                    let _e1585 = phi_2168_;
                                                    let _e1587 = phi_2169_;
                                                    if _e1587 {
                                                        phi_2173_ = _e1585;
                                                    } else {
                                                        phi_2173_ = _e1583;
                                                    }
                                                    let _e1589 = phi_2173_;
                                                    if _e1589.member_3 {
                                                        phi_2182_ = type_23(_e1589.member, _e1589.member_1, _e1589.member_2, _e1080);
                                                    } else {
                                                        phi_2182_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1596 = phi_2182_;
                                                    if (_e1596.member_3 != 4294967295u) {
                                                        if (_e1080 != _e586) {
                                                            if (_e1596.member < _e1045.member.member.member) {
                                                                phi_2208_ = true;
                                                            } else {
                                                                if (_e1596.member == _e1045.member.member.member) {
                                                                    phi_2207_ = (_e1596.member_3 < _e1045.member.member.member_3);
                                                                } else {
                                                                    phi_2207_ = false;
                                                                }
                                                                let _e1611 = phi_2207_;
                                                                phi_2208_ = _e1611;
                                                            }
                                                            let _e1613 = phi_2208_;
                                                            if _e1613 {
                                                                phi_2215_ = type_42(type_38(_e1596, _e1596.member), _e1072.member_1, _e1072.member_2);
                                                            } else {
                                                                phi_2215_ = _e1072;
                                                            }
                                                            let _e1620 = phi_2215_;
                                                            phi_2216_ = _e1620;
                                                        } else {
                                                            phi_2216_ = _e1072;
                                                        }
                                                        let _e1622 = phi_2216_;
                                                        phi_2217_ = _e1622;
                                                    } else {
                                                        phi_2217_ = _e1072;
                                                    }
                                                    let _e1624 = phi_2217_;
                                                    phi_1274_ = _e1624;
                                                } else {
                                                    phi_1274_ = type_42();
                                                }
                                                let _e1626 = phi_1274_;
                                                continue;
                                                continuing {
                                                    phi_1273_ = _e1626;
                                                    phi_1276_ = _e1060;
                                                    phi_3691_ = _e617;
                                                    break if !(_e1066);
                                                }
                                            }
                                            let _e1629 = phi_3691_;
                                            phi_3844_ = _e1629;
                                            if _e1629 {
                                                break;
                                            }
                                            let _e1631 = local_10;
                                            phi_3848_ = _e1629;
                                            let _e1939 = local_13;
                                            phi_3224_ = _e1939;
                                            phi_3225_ = false;
                                            phi_3226_ = _e661;
                                            phi_3227_ = select(_e663, 0u, (_e580 > _e1631.member.member_1));
                                        } else {
                                            let _e672 = (_e661.member_1 < _e90);
                                            if _e672 {
                                                if _e672 {
                                                } else {
                                                    phi_3844_ = true;
                                                    break;
                                                }
                                                let _e674 = global_7.member[_e661.member_1];
                                                phi_2238_ = _e674;
                                            } else {
                                                phi_2238_ = type_46(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e676 = phi_2238_;
                                            let _e691 = ((10u * _e262) & 31u);
                                            let _e694 = ((_e676.member[0] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e702 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[0] - _e661.member.member[0]) * 0.0009775171f)) ^ _e128));
                                            let _e707 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e694)) - 8388608f) * _e702)) ^ _e128)));
                                            let _e711 = select(select(_e661.member.member_1[0], _e707, (_e707 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e694 == 1023u));
                                            let _e713 = ((10u * _e261) & 31u);
                                            let _e716 = ((_e676.member[0] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e724 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[1] - _e661.member.member[1]) * 0.0009775171f)) ^ _e128));
                                            let _e729 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e716)) - 8388608f) * _e724)) ^ _e128)));
                                            let _e733 = select(select(_e661.member.member_1[1], _e729, (_e729 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e716 == 1023u));
                                            let _e735 = ((10u * _e263) & 31u);
                                            let _e738 = ((_e676.member[0] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e746 = bitcast<f32>((bitcast<u32>(((_e661.member.member_1[2] - _e661.member.member[2]) * 0.0009775171f)) ^ _e128));
                                            let _e751 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e738)) - 8388608f) * _e746)) ^ _e128)));
                                            let _e755 = select(select(_e661.member.member_1[2], _e751, (_e751 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e738 == 1023u));
                                            let _e758 = ((_e676.member[1] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e766 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e758)) - 8388608f) * _e702)) ^ _e128)));
                                            let _e770 = select(select(_e661.member.member_1[0], _e766, (_e766 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e758 == 1023u));
                                            let _e773 = ((_e676.member[1] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e781 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e724)) ^ _e128)));
                                            let _e785 = select(select(_e661.member.member_1[1], _e781, (_e781 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e773 == 1023u));
                                            let _e788 = ((_e676.member[1] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e796 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e746)) ^ _e128)));
                                            let _e800 = select(select(_e661.member.member_1[2], _e796, (_e796 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e788 == 1023u));
                                            let _e806 = ((_e676.member_1[0] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e814 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e806)) - 8388608f) * _e702)) ^ _e128)));
                                            let _e818 = select(select(_e661.member.member_1[0], _e814, (_e814 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e806 == 1023u));
                                            let _e821 = ((_e676.member_1[0] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e829 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e724)) ^ _e128)));
                                            let _e833 = select(select(_e661.member.member_1[1], _e829, (_e829 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e821 == 1023u));
                                            let _e836 = ((_e676.member_1[0] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e844 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e746)) ^ _e128)));
                                            let _e848 = select(select(_e661.member.member_1[2], _e844, (_e844 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e836 == 1023u));
                                            let _e851 = ((_e676.member_1[1] >> bitcast<u32>(_e691)) & 1023u);
                                            let _e859 = (_e661.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e702)) ^ _e128)));
                                            let _e863 = select(select(_e661.member.member_1[0], _e859, (_e859 < _e661.member.member_1[0])), _e661.member.member_1[0], (_e851 == 1023u));
                                            let _e866 = ((_e676.member_1[1] >> bitcast<u32>(_e713)) & 1023u);
                                            let _e874 = (_e661.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e724)) ^ _e128)));
                                            let _e878 = select(select(_e661.member.member_1[1], _e874, (_e874 < _e661.member.member_1[1])), _e661.member.member_1[1], (_e866 == 1023u));
                                            let _e881 = ((_e676.member_1[1] >> bitcast<u32>(_e735)) & 1023u);
                                            let _e889 = (_e661.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e746)) ^ _e128)));
                                            let _e893 = select(select(_e661.member.member_1[2], _e889, (_e889 < _e661.member.member_1[2])), _e661.member.member_1[2], (_e881 == 1023u));
                                            let _e898 = type_53(type_51(array<f32, 3>(_e711, _e733, _e755), array<f32, 3>(_e770, _e785, _e800)), _e676.member_2);
                                            let _e903 = type_53(type_51(array<f32, 3>(_e818, _e833, _e848), array<f32, 3>(_e863, _e878, _e893)), _e676.member_3);
                                            let _e916 = ((_e711 - _e347) * _e350);
                                            let _e917 = ((_e818 - _e347) * _e350);
                                            let _e918 = ((_e770 - _e348) * _e350);
                                            let _e919 = ((_e863 - _e348) * _e350);
                                            let _e924 = ((_e733 - _e411) * _e414);
                                            let _e925 = ((_e833 - _e411) * _e414);
                                            let _e926 = ((_e785 - _e412) * _e414);
                                            let _e927 = ((_e878 - _e412) * _e414);
                                            let _e932 = ((_e755 - _e475) * _e478);
                                            let _e933 = ((_e848 - _e475) * _e478);
                                            let _e934 = ((_e800 - _e476) * _e478);
                                            let _e935 = ((_e893 - _e476) * _e478);
                                            let _e937 = select(_e934, _e932, (_e932 < _e934));
                                            let _e939 = select(_e935, _e933, (_e933 < _e935));
                                            let _e941 = select(_e934, _e932, (_e932 > _e934));
                                            let _e943 = select(_e935, _e933, (_e933 > _e935));
                                            let _e945 = select(_e918, _e916, (_e916 < _e918));
                                            let _e947 = select(_e919, _e917, (_e917 < _e919));
                                            let _e949 = select(_e926, _e924, (_e924 < _e926));
                                            let _e951 = select(_e927, _e925, (_e925 < _e927));
                                            let _e953 = select(_e949, _e945, (_e945 > _e949));
                                            let _e955 = select(_e951, _e947, (_e947 > _e951));
                                            let _e957 = select(_e937, _e953, (_e953 > _e937));
                                            let _e959 = select(_e939, _e955, (_e955 > _e939));
                                            let _e961 = select(_e918, _e916, (_e916 > _e918));
                                            let _e963 = select(_e919, _e917, (_e917 > _e919));
                                            let _e965 = select(_e926, _e924, (_e924 > _e926));
                                            let _e967 = select(_e927, _e925, (_e925 > _e927));
                                            let _e969 = select(_e965, _e961, (_e961 < _e965));
                                            let _e971 = select(_e967, _e963, (_e963 < _e967));
                                            let _e976 = -(_e937);
                                            let _e977 = -(_e939);
                                            let _e984 = (select(_e941, _e969, (_e969 < _e941)) + (select(_e976, _e941, (_e941 > _e976)) * 0.0000019073523f));
                                            let _e985 = (select(_e943, _e971, (_e971 < _e943)) + (select(_e977, _e943, (_e943 > _e977)) * 0.0000019073523f));
                                            let _e987 = select(_e580, _e957, (_e957 > _e580));
                                            let _e989 = select(_e580, _e959, (_e959 > _e580));
                                            let _e994 = (_e987 <= select(_e619.member.member_1, _e984, (_e984 < _e619.member.member_1)));
                                            let _e995 = (_e989 <= select(_e619.member.member_1, _e985, (_e985 < _e619.member.member_1)));
                                            let _e996 = (_e987 <= _e989);
                                            if _e994 {
                                                if _e995 {
                                                    if _e996 {
                                                        phi_3127_ = _e903;
                                                    } else {
                                                        phi_3127_ = _e898;
                                                    }
                                                    let _e998 = phi_3127_;
                                                    let _e1005 = (_e663 % 128u);
                                                    let _e1006 = (_e1005 < 128u);
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1005] = _e998.member_1;
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1005] = _e998.member.member[0];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1005] = _e998.member.member[1];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1005] = _e998.member.member[2];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1005] = _e998.member.member_1[0];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1005] = _e998.member.member_1[1];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local[_e1005] = _e998.member.member_1[2];
                                                    if _e1006 {
                                                    } else {
                                                        phi_3844_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1005] = select(_e987, _e989, _e996);
                                                    if _e996 {
                                                        phi_3203_ = _e898;
                                                    } else {
                                                        phi_3203_ = _e903;
                                                    }
                                                    let _e1023 = phi_3203_;
                                                    phi_3204_ = _e1023;
                                                    phi_3205_ = (_e663 + 1u);
                                                } else {
                                                    phi_3204_ = type_53();
                                                    phi_3205_ = u32();
                                                }
                                                let _e1025 = phi_3204_;
                                                let _e1027 = phi_3205_;
                                                phi_3207_ = _e1025;
                                                phi_3208_ = _e1027;
                                                phi_3209_ = select(true, false, _e995);
                                            } else {
                                                phi_3207_ = type_53();
                                                phi_3208_ = u32();
                                                phi_3209_ = true;
                                            }
                                            let _e1030 = phi_3207_;
                                            let _e1032 = phi_3208_;
                                            let _e1034 = phi_3209_;
                                            if _e1034 {
                                                if _e994 {
                                                    phi_3216_ = _e898;
                                                } else {
                                                    phi_3216_ = _e903;
                                                }
                                                let _e1036 = phi_3216_;
                                                phi_3221_ = select(_e995, true, _e994);
                                                phi_3222_ = _e1036;
                                            } else {
                                                phi_3221_ = _e659;
                                                phi_3222_ = _e1030;
                                            }
                                            let _e1039 = phi_3221_;
                                            let _e1041 = phi_3222_;
                                            phi_3848_ = _e617;
                                            phi_3224_ = type_42(_e619.member, (_e619.member_1 + 1u), _e619.member_2);
                                            phi_3225_ = _e1039;
                                            phi_3226_ = _e1041;
                                            phi_3227_ = select(_e1032, _e663, _e1034);
                                        }
                                        let _e1637 = phi_3848_;
                                        let _e1639 = phi_3224_;
                                        let _e1641 = phi_3225_;
                                        let _e1643 = phi_3226_;
                                        let _e1645 = phi_3227_;
                                        phi_3847_ = _e1637;
                                        phi_3228_ = _e1639;
                                        phi_3229_ = _e1641;
                                        phi_3230_ = _e1643;
                                        phi_3231_ = _e1645;
                                        phi_3232_ = (_e627 - 1u);
                                    } else {
                                        phi_3847_ = _e617;
                                        phi_3228_ = _e619;
                                        phi_3229_ = _e659;
                                        phi_3230_ = _e661;
                                        phi_3231_ = _e663;
                                        phi_3232_ = _e627;
                                    }
                                    let _e1647 = phi_3847_;
                                    let _e1649 = phi_3228_;
                                    let _e1651 = phi_3229_;
                                    let _e1653 = phi_3230_;
                                    let _e1655 = phi_3231_;
                                    let _e1657 = phi_3232_;
                                    phi_3846_ = _e1647;
                                    phi_3233_ = _e1649;
                                    phi_3234_ = _e1651;
                                    phi_3235_ = _e1653;
                                    phi_3236_ = _e1655;
                                    phi_3237_ = _e1657;
                                } else {
                                    phi_3846_ = _e617;
                                    phi_3233_ = type_42();
                                    phi_3234_ = bool();
                                    phi_3235_ = type_53();
                                    phi_3236_ = u32();
                                    phi_3237_ = u32();
                                }
                                let _e1659 = phi_3846_;
                                let _e1661 = phi_3233_;
                                let _e1663 = phi_3234_;
                                let _e1665 = phi_3235_;
                                let _e1667 = phi_3236_;
                                let _e1669 = phi_3237_;
                                phi_3845_ = _e1659;
                                phi_1148_ = _e1661;
                                phi_1151_ = _e1663;
                                phi_1153_ = _e1665;
                                phi_1155_ = _e1667;
                                phi_1157_ = _e1669;
                                phi_3238_ = _e631;
                            } else {
                                phi_3845_ = _e617;
                                phi_1148_ = type_42();
                                phi_1151_ = bool();
                                phi_1153_ = type_53();
                                phi_1155_ = u32();
                                phi_1157_ = u32();
                                phi_3238_ = false;
                            }
                            let _e1671 = phi_3845_;
                            let _e1673 = phi_1148_;
                            let _e1675 = phi_1151_;
                            let _e1677 = phi_1153_;
                            let _e1679 = phi_1155_;
                            let _e1681 = phi_1157_;
                            let _e1683 = phi_3238_;
                            continue;
                            continuing {
                                phi_3697_ = _e1671;
                                phi_1147_ = _e1673;
                                phi_1150_ = _e1675;
                                phi_1152_ = _e1677;
                                phi_1154_ = _e1679;
                                phi_1156_ = _e1681;
                                phi_3844_ = _e1671;
                                break if !(_e1683);
                            }
                        }
                        let _e1686 = phi_3844_;
                        if _e1686 {
                            break;
                        }
                        let _e1688 = local_11;
                        if (_e1688.member.member.member_3 != 4294967295u) {
                            let _e1694 = bitcast<u32>(_e1688.member.member.member);
                            let _e1698 = (bitcast<i32>((_e1694 >> bitcast<u32>(23i))) & 255i);
                            let _e1699 = (_e1698 + _e264);
                            if (_e1698 == 255i) {
                                phi_3297_ = _e1688.member.member.member;
                            } else {
                                if (_e1698 > 0i) {
                                    if (_e1699 > 0i) {
                                        let _e1703 = (_e1699 < 255i);
                                        if _e1703 {
                                            phi_3276_ = bitcast<f32>((_e1694 + bitcast<u32>((_e264 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3276_ = f32();
                                        }
                                        let _e1710 = phi_3276_;
                                        phi_3278_ = _e1710;
                                        phi_3279_ = select(true, false, _e1703);
                                    } else {
                                        phi_3278_ = f32();
                                        phi_3279_ = true;
                                    }
                                    let _e1713 = phi_3278_;
                                    let _e1715 = phi_3279_;
                                    phi_3280_ = _e1713;
                                    phi_3281_ = _e1715;
                                } else {
                                    phi_3280_ = f32();
                                    phi_3281_ = true;
                                }
                                let _e1717 = phi_3280_;
                                let _e1719 = phi_3281_;
                                if _e1719 {
                                    let _e1720 = (_e1694 & 2147483648u);
                                    let _e1727 = ((_e1694 & 8388607u) | (select(0u, 1u, ((_e1694 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1731 = (_e1727 == 0u);
                                    if _e1731 {
                                        phi_3661_ = bitcast<f32>(_e1720);
                                    } else {
                                        let _e1736 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1727)), 32u, _e1731) - 8u);
                                        let _e1739 = (_e1727 << bitcast<u32>((_e1736 & 31u)));
                                        let _e1741 = ((_e1699 + select(0i, 1i, (_e1698 == 0i))) - bitcast<i32>(_e1736));
                                        if (_e1741 >= 255i) {
                                            phi_3651_ = bitcast<f32>((_e1720 | 2139095040u));
                                            phi_3652_ = f32();
                                            phi_3653_ = true;
                                        } else {
                                            let _e1743 = (_e1741 > 0i);
                                            if _e1743 {
                                                phi_3645_ = bitcast<f32>(((_e1720 | (bitcast<u32>(_e1741) << bitcast<u32>(23i))) | (_e1739 & 8388607u)));
                                                phi_3646_ = f32();
                                            } else {
                                                if (_e1741 < -24i) {
                                                    phi_3611_ = 26u;
                                                } else {
                                                    phi_3611_ = bitcast<u32>((1i - _e1741));
                                                }
                                                let _e1748 = phi_3611_;
                                                let _e1749 = (_e1748 & 31u);
                                                let _e1751 = (_e1739 >> bitcast<u32>(_e1749));
                                                let _e1755 = (_e1739 & ((1u << bitcast<u32>(_e1749)) - 1u));
                                                let _e1759 = (1u << bitcast<u32>(((_e1748 - 1u) & 31u)));
                                                if (_e1755 > _e1759) {
                                                    phi_3632_ = true;
                                                } else {
                                                    if (_e1755 == _e1759) {
                                                        phi_3629_ = ((_e1751 & 1u) == 1u);
                                                    } else {
                                                        phi_3629_ = false;
                                                    }
                                                    let _e1765 = phi_3629_;
                                                    phi_3632_ = _e1765;
                                                }
                                                let _e1767 = phi_3632_;
                                                phi_3645_ = f32();
                                                phi_3646_ = bitcast<f32>((_e1720 | (_e1751 + select(0u, 1u, _e1767))));
                                            }
                                            let _e1780 = phi_3645_;
                                            let _e1782 = phi_3646_;
                                            phi_3651_ = _e1780;
                                            phi_3652_ = _e1782;
                                            phi_3653_ = _e1743;
                                        }
                                        let _e1786 = phi_3651_;
                                        let _e1788 = phi_3652_;
                                        let _e1790 = phi_3653_;
                                        phi_3661_ = select(_e1788, _e1786, _e1790);
                                    }
                                    let _e1794 = phi_3661_;
                                    phi_3296_ = _e1794;
                                } else {
                                    phi_3296_ = _e1717;
                                }
                                let _e1796 = phi_3296_;
                                phi_3297_ = _e1796;
                            }
                            let _e1798 = phi_3297_;
                            let _e1799 = bitcast<u32>(_e1798);
                            if ((_e1799 & 2147483647u) >= 2139095040u) {
                                phi_3309_ = bitcast<f32>(((_e1799 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3309_ = _e1798;
                            }
                            let _e1806 = phi_3309_;
                            phi_3314_ = type_23(_e1806, _e1688.member.member.member_1, _e1688.member.member.member_2, _e1688.member.member.member_3);
                        } else {
                            phi_3314_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1811 = phi_3314_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e132] = _e1811;
                        let _e1815 = local_12;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_5.member[_e132] = _e1815.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1820 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1820 > 0u) {
                            let _e1822 = (1u < _e100);
                            if _e1822 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1826 = atomicAdd((&global_6.member[0u]), _e1820);
                                if ((_e1826 + _e1820) < _e1826) {
                                    if _e1822 {
                                    } else {
                                        break;
                                    }
                                    let _e1831 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1834 = select(0u, 1u, (_e1811.member_3 != 4294967295u));
                        if (_e1834 > 0u) {
                            let _e1836 = (3u < _e100);
                            if _e1836 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1840 = atomicAdd((&global_6.member[2u]), _e1834);
                                if ((_e1840 + _e1834) < _e1840) {
                                    if _e1836 {
                                    } else {
                                        break;
                                    }
                                    let _e1845 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1815.member_1 > 0u) {
                            let _e1847 = (5u < _e100);
                            if _e1847 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1851 = atomicAdd((&global_6.member[4u]), _e1815.member_1);
                                if ((_e1851 + _e1815.member_1) < _e1851) {
                                    if _e1847 {
                                    } else {
                                        break;
                                    }
                                    let _e1856 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
