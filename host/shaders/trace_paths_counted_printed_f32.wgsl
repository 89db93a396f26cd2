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
    var phi_455_: i32;
    var phi_456_: i32;
    var phi_466_: bool;
    var phi_476_: u32;
    var phi_477_: u32;
    var phi_479_: bool;
    var phi_484_: u32;
    var phi_517_: i32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_785_: f32;
    var phi_791_: f32;
    var phi_831_: f32;
    var phi_837_: f32;
    var phi_956_: i32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_1016_: i32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1047_: f32;
    var phi_1048_: f32;
    var phi_3771_: bool;
    var phi_1140_: type_42;
    var phi_1143_: u32;
    var phi_1145_: bool;
    var phi_1147_: u32;
    var phi_1149_: type_53;
    var phi_1160_: bool;
    var phi_1246_: bool;
    var phi_1247_: u32;
    var phi_1248_: type_53;
    var phi_1266_: type_42;
    var phi_1269_: type_7;
    var phi_1270_: type_7;
    var phi_1292_: type_7;
    var phi_1316_: u32;
    var phi_1408_: array<array<f32, 3>, 3>;
    var phi_3492_: bool;
    var phi_3507_: bool;
    var phi_3522_: bool;
    var phi_3537_: bool;
    var phi_3552_: bool;
    var phi_3567_: bool;
    var phi_1950_: f32;
    var phi_1951_: f32;
    var phi_1952_: f32;
    var phi_1953_: f32;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_1956_: vec3<f32>;
    var phi_1957_: vec3<f32>;
    var phi_3582_: bool;
    var phi_3597_: bool;
    var phi_3612_: bool;
    var phi_3627_: bool;
    var phi_3642_: bool;
    var phi_3657_: bool;
    var phi_2165_: f32;
    var phi_2185_: type_41;
    var phi_2186_: type_41;
    var phi_2189_: type_41;
    var phi_2190_: type_41;
    var phi_2191_: bool;
    var phi_2195_: type_41;
    var phi_2204_: type_23;
    var phi_2229_: bool;
    var phi_2230_: bool;
    var phi_2237_: type_42;
    var phi_2238_: type_42;
    var phi_2239_: type_42;
    var phi_1267_: type_42;
    var phi_3765_: bool;
    var phi_3989_: bool;
    var phi_2240_: type_42;
    var phi_2261_: type_46;
    var phi_3150_: type_53;
    var phi_3226_: type_53;
    var phi_3227_: u32;
    var phi_3228_: type_53;
    var phi_3230_: u32;
    var phi_3231_: type_53;
    var phi_3232_: bool;
    var phi_3239_: type_53;
    var phi_3244_: bool;
    var phi_3246_: type_53;
    var phi_3251_: type_42;
    var phi_3252_: bool;
    var phi_3253_: u32;
    var phi_3254_: type_53;
    var phi_3262_: type_42;
    var phi_3265_: type_53;
    var phi_3933_: bool;
    var phi_3266_: type_42;
    var phi_3267_: u32;
    var phi_3268_: bool;
    var phi_3269_: u32;
    var phi_3270_: type_53;
    var phi_3932_: bool;
    var phi_3271_: type_42;
    var phi_3272_: u32;
    var phi_3273_: bool;
    var phi_3274_: u32;
    var phi_3275_: type_53;
    var phi_3931_: bool;
    var phi_1141_: type_42;
    var phi_1144_: u32;
    var phi_1146_: bool;
    var phi_1148_: u32;
    var phi_1150_: type_53;
    var phi_3276_: bool;
    var phi_3930_: bool;
    var local_10: type_42;
    var phi_3314_: f32;
    var phi_3316_: f32;
    var phi_3317_: bool;
    var phi_3318_: f32;
    var phi_3319_: bool;
    var phi_3685_: u32;
    var phi_3703_: bool;
    var phi_3706_: bool;
    var phi_3719_: f32;
    var phi_3720_: f32;
    var phi_3725_: f32;
    var phi_3726_: f32;
    var phi_3727_: bool;
    var phi_3735_: f32;
    var phi_3334_: f32;
    var phi_3335_: f32;
    var phi_3347_: f32;
    var phi_3352_: type_23;
    var local_11: type_42;
    var local_12: type_42;

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
                                phi_455_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_455_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                            }
                            let _e241 = phi_455_;
                            phi_456_ = _e241;
                        } else {
                            phi_456_ = 0i;
                        }
                        let _e243 = phi_456_;
                        let _e244 = (_e153 == _e197);
                        if _e244 {
                            phi_466_ = true;
                        } else {
                            phi_466_ = (_e161 == _e197);
                        }
                        let _e247 = phi_466_;
                        let _e248 = select(1u, 0u, _e244);
                        if _e247 {
                            let _e249 = (_e248 + 1u);
                            phi_476_ = _e249;
                            phi_477_ = _e249;
                            phi_479_ = select(true, false, (_e249 == 2u));
                        } else {
                            phi_476_ = u32();
                            phi_477_ = 0u;
                            phi_479_ = true;
                        }
                        let _e253 = phi_476_;
                        let _e255 = phi_477_;
                        let _e257 = phi_479_;
                        if _e257 {
                            phi_484_ = (_e255 + 1u);
                        } else {
                            phi_484_ = 0u;
                        }
                        let _e261 = phi_484_;
                        let _e262 = select(_e253, _e255, _e257);
                        let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                        let _e264 = -(_e243);
                        if (_e264 < -126i) {
                            phi_517_ = -126i;
                        } else {
                            phi_517_ = select(_e264, 127i, (_e264 > 127i));
                        }
                        let _e269 = phi_517_;
                        let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                        let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                        let _e285 = global_4.member[_e132].member.member;
                        let _e286 = (_e262 == 0u);
                        if _e286 {
                            phi_535_ = _e285[0];
                        } else {
                            phi_535_ = _e285[1];
                        }
                        let _e290 = phi_535_;
                        let _e291 = (_e262 == 2u);
                        if _e291 {
                            phi_541_ = _e285[2];
                        } else {
                            phi_541_ = _e290;
                        }
                        let _e294 = phi_541_;
                        let _e295 = bitcast<u32>(_e294);
                        let _e297 = ((_e295 & 2139095040u) != 0u);
                        let _e309 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e295 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e295 & 2147483648u))), _e294, _e297) * select(0.00000011920929f, 1f, _e297));
                        let _e310 = global_4.member[_e132].member.member_2;
                        if _e286 {
                            phi_581_ = _e310[0];
                        } else {
                            phi_581_ = _e310[1];
                        }
                        let _e314 = phi_581_;
                        if _e291 {
                            phi_587_ = _e310[2];
                        } else {
                            phi_587_ = _e314;
                        }
                        let _e317 = phi_587_;
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
                            phi_660_ = _e285[0];
                        } else {
                            phi_660_ = _e285[1];
                        }
                        let _e355 = phi_660_;
                        let _e356 = (_e261 == 2u);
                        if _e356 {
                            phi_666_ = _e285[2];
                        } else {
                            phi_666_ = _e355;
                        }
                        let _e359 = phi_666_;
                        let _e360 = bitcast<u32>(_e359);
                        let _e362 = ((_e360 & 2139095040u) != 0u);
                        let _e374 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e360 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e360 & 2147483648u))), _e359, _e362) * select(0.00000011920929f, 1f, _e362));
                        if _e351 {
                            phi_706_ = _e310[0];
                        } else {
                            phi_706_ = _e310[1];
                        }
                        let _e378 = phi_706_;
                        if _e356 {
                            phi_712_ = _e310[2];
                        } else {
                            phi_712_ = _e378;
                        }
                        let _e381 = phi_712_;
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
                            phi_785_ = _e285[0];
                        } else {
                            phi_785_ = _e285[1];
                        }
                        let _e419 = phi_785_;
                        let _e420 = (_e263 == 2u);
                        if _e420 {
                            phi_791_ = _e285[2];
                        } else {
                            phi_791_ = _e419;
                        }
                        let _e423 = phi_791_;
                        let _e424 = bitcast<u32>(_e423);
                        let _e426 = ((_e424 & 2139095040u) != 0u);
                        let _e438 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e424 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e424 & 2147483648u))), _e423, _e426) * select(0.00000011920929f, 1f, _e426));
                        if _e415 {
                            phi_831_ = _e310[0];
                        } else {
                            phi_831_ = _e310[1];
                        }
                        let _e442 = phi_831_;
                        if _e420 {
                            phi_837_ = _e310[2];
                        } else {
                            phi_837_ = _e442;
                        }
                        let _e445 = phi_837_;
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
                                phi_956_ = 255i;
                            } else {
                                phi_956_ = (((_e495 + select(0i, 1i, (_e495 == 0i))) - _e502) + _e243);
                            }
                            let _e510 = phi_956_;
                            let _e520 = (_e510 <= 0i);
                            if _e520 {
                                phi_979_ = u32();
                            } else {
                                if _e499 {
                                    phi_978_ = u32();
                                } else {
                                    phi_978_ = select(((bitcast<u32>(_e510) << bitcast<u32>(23i)) | ((_e492 << bitcast<u32>(((_e502 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e510 >= 255i));
                                }
                                let _e524 = phi_978_;
                                phi_979_ = _e524;
                            }
                            let _e526 = phi_979_;
                            let _e538 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e541 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                            let _e545 = (_e538 == 0u);
                            let _e548 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e538)), 32u, _e545)) - 8i);
                            if (_e541 == 255i) {
                                phi_1016_ = 255i;
                            } else {
                                phi_1016_ = (((_e541 + select(0i, 1i, (_e541 == 0i))) - _e548) + _e243);
                            }
                            let _e556 = phi_1016_;
                            let _e566 = (_e556 <= 0i);
                            if _e566 {
                                phi_1039_ = u32();
                            } else {
                                if _e545 {
                                    phi_1038_ = u32();
                                } else {
                                    phi_1038_ = select(((bitcast<u32>(_e556) << bitcast<u32>(23i)) | ((_e538 << bitcast<u32>(((_e548 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e556 >= 255i));
                                }
                                let _e570 = phi_1038_;
                                phi_1039_ = _e570;
                            }
                            let _e572 = phi_1039_;
                            phi_1047_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e572, 0u, select(_e545, true, _e566))));
                            phi_1048_ = bitcast<f32>(((_e209 & 2147483648u) | select(_e526, 0u, select(_e499, true, _e520))));
                        } else {
                            phi_1047_ = 0f;
                            phi_1048_ = 1f;
                        }
                        let _e578 = phi_1047_;
                        let _e580 = phi_1048_;
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
                        let _e590 = (_e262 % 3u);
                        let _e591 = (_e590 < 3u);
                        if _e591 {
                        } else {
                            break;
                        }
                        let _e593 = local_9[_e590];
                        let _e594 = (_e261 % 3u);
                        let _e595 = (_e594 < 3u);
                        if _e595 {
                        } else {
                            break;
                        }
                        let _e597 = local_9[_e594];
                        let _e598 = (_e263 % 3u);
                        let _e599 = (_e598 < 3u);
                        if _e599 {
                        } else {
                            break;
                        }
                        let _e601 = local_9[_e598];
                        local_8 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
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
                        phi_3771_ = false;
                        phi_1140_ = type_42(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e578), 0u, 0u);
                        phi_1143_ = ((3u * _e90) + 1u);
                        phi_1145_ = (_e580 <= _e578);
                        phi_1147_ = 0u;
                        phi_1149_ = type_53(type_51(array<f32, 3>(_e593, _e597, _e601), array<f32, 3>(_e605, _e607, _e609)), select(0u, 2147483648u, (_e90 == 0u)));
                        loop {
                            let _e617 = phi_3771_;
                            let _e619 = phi_1140_;
                            let _e621 = phi_1143_;
                            let _e623 = phi_1145_;
                            let _e625 = phi_1147_;
                            let _e627 = phi_1149_;
                            local_10 = _e619;
                            local_11 = _e619;
                            if _e623 {
                                phi_1160_ = true;
                            } else {
                                phi_1160_ = (_e625 > 0u);
                            }
                            let _e630 = phi_1160_;
                            if _e630 {
                                let _e631 = (_e621 > 0u);
                                if _e631 {
                                    if _e623 {
                                        phi_1246_ = _e623;
                                        phi_1247_ = _e625;
                                        phi_1248_ = _e627;
                                    } else {
                                        let _e632 = (_e625 - 1u);
                                        let _e633 = (_e632 % 128u);
                                        let _e634 = (_e633 < 128u);
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e636 = local_6[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e638 = local_5[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e640 = local_4[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e642 = local_3[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e645 = local_2[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e647 = local_1[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e649 = local[_e633];
                                        if _e634 {
                                        } else {
                                            phi_3930_ = true;
                                            break;
                                        }
                                        let _e654 = local_7[_e633];
                                        phi_1246_ = (_e654 <= _e619.member.member_1);
                                        phi_1247_ = _e632;
                                        phi_1248_ = type_53(type_51(array<f32, 3>(_e638, _e640, _e642), array<f32, 3>(_e645, _e647, _e649)), _e636);
                                    }
                                    let _e659 = phi_1246_;
                                    let _e661 = phi_1247_;
                                    let _e663 = phi_1248_;
                                    if _e659 {
                                        let _e667 = ((_e663.member_1 & 2147483648u) != 0u);
                                        if _e667 {
                                            phi_1266_ = _e619;
                                            phi_1269_ = type_7(0u, ((_e663.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e674 = phi_1266_;
                                                let _e676 = phi_1269_;
                                                local_12 = _e674;
                                                if (_e676.member < _e676.member_1) {
                                                    phi_1270_ = type_7((_e676.member + 1u), _e676.member_1);
                                                    phi_1292_ = type_7(1u, _e676.member);
                                                } else {
                                                    phi_1270_ = _e676;
                                                    phi_1292_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e689 = phi_1270_;
                                                let _e691 = phi_1292_;
                                                let _e695 = (bitcast<i32>(_e691.member) != 0i);
                                                if _e695 {
                                                    let _e701 = type_42(_e674.member, _e674.member_1, (_e674.member_2 + 1u));
                                                    let _e702 = ((_e663.member_1 & 268435455u) + _e691.member_1);
                                                    let _e703 = (_e702 < _e92);
                                                    if _e703 {
                                                        if _e703 {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e707 = global_1.member[_e702].member_1;
                                                        phi_1316_ = _e707;
                                                    } else {
                                                        phi_1316_ = 4294967295u;
                                                    }
                                                    let _e709 = phi_1316_;
                                                    if (_e702 >= _e92) {
                                                        phi_1408_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e703 {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        if (_e590 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e716 = global_1.member[_e702].member[_e590];
                                                        if (_e594 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e722 = global_1.member[_e702].member[_e594];
                                                        if (_e598 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e728 = global_1.member[_e702].member[_e598];
                                                        let _e730 = (3u + _e590);
                                                        if (_e730 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e736 = global_1.member[_e702].member[_e730];
                                                        let _e737 = (3u + _e594);
                                                        if (_e737 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e743 = global_1.member[_e702].member[_e737];
                                                        let _e744 = (3u + _e598);
                                                        if (_e744 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e750 = global_1.member[_e702].member[_e744];
                                                        let _e752 = (6u + _e590);
                                                        if (_e752 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e758 = global_1.member[_e702].member[_e752];
                                                        let _e759 = (6u + _e594);
                                                        if (_e759 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_1.member[_e702].member[_e759];
                                                        let _e766 = (6u + _e598);
                                                        if (_e766 < 9u) {
                                                        } else {
                                                            phi_3765_ = true;
                                                            break;
                                                        }
                                                        let _e772 = global_1.member[_e702].member[_e766];
                                                        phi_1408_ = array<array<f32, 3>, 3>(array<f32, 3>(_e716, _e722, _e728), array<f32, 3>(_e736, _e743, _e750), array<f32, 3>(_e758, _e765, _e772));
                                                    }
                                                    let _e776 = phi_1408_;
                                                    let _e793 = (_e776[0][2] - _e438);
                                                    let _e796 = (((_e776[0][0] - _e309) * _e474) - (_e793 * _e346));
                                                    let _e799 = (((_e776[0][1] - _e374) * _e474) - (_e793 * _e410));
                                                    let _e802 = (_e776[1][2] - _e438);
                                                    let _e805 = (((_e776[1][0] - _e309) * _e474) - (_e802 * _e346));
                                                    let _e808 = (((_e776[1][1] - _e374) * _e474) - (_e802 * _e410));
                                                    let _e811 = (_e776[2][2] - _e438);
                                                    let _e814 = (((_e776[2][0] - _e309) * _e474) - (_e811 * _e346));
                                                    let _e817 = (((_e776[2][1] - _e374) * _e474) - (_e811 * _e410));
                                                    let _e818 = (_e814 * _e808);
                                                    let _e819 = (_e817 * _e805);
                                                    let _e820 = (_e796 * _e817);
                                                    let _e821 = (_e799 * _e814);
                                                    let _e822 = (_e805 * _e799);
                                                    let _e823 = (_e808 * _e796);
                                                    let _e828 = (((_e818 >= _e819) && (_e820 >= _e821)) && (_e822 >= _e823));
                                                    let _e834 = (_e828 || (((_e818 <= _e819) && (_e820 <= _e821)) && (_e822 <= _e823)));
                                                    if _e834 {
                                                        let _e836 = select(-1f, 1f, _e828);
                                                        let _e838 = ((_e818 - _e819) * _e836);
                                                        let _e840 = select(0f, _e838, (_e838 > 0f));
                                                        let _e842 = ((_e820 - _e821) * _e836);
                                                        let _e844 = select(0f, _e842, (_e842 > 0f));
                                                        let _e846 = ((_e822 - _e823) * _e836);
                                                        let _e848 = select(0f, _e846, (_e846 > 0f));
                                                        let _e850 = ((_e840 + _e844) + _e848);
                                                        let _e852 = select(_e776[1][0], _e776[0][0], (_e776[0][0] < _e776[1][0]));
                                                        let _e856 = select(_e776[1][0], _e776[0][0], (_e776[0][0] > _e776[1][0]));
                                                        let _e860 = select(_e776[1][1], _e776[0][1], (_e776[0][1] < _e776[1][1]));
                                                        let _e864 = select(_e776[1][1], _e776[0][1], (_e776[0][1] > _e776[1][1]));
                                                        let _e868 = select(_e776[1][2], _e776[0][2], (_e776[0][2] < _e776[1][2]));
                                                        let _e872 = select(_e776[1][2], _e776[0][2], (_e776[0][2] > _e776[1][2]));
                                                        let _e877 = ((select(_e776[2][0], _e852, (_e852 < _e776[2][0])) - _e347) * _e350);
                                                        let _e878 = ((select(_e776[2][0], _e856, (_e856 > _e776[2][0])) - _e348) * _e350);
                                                        let _e881 = ((select(_e776[2][1], _e860, (_e860 < _e776[2][1])) - _e411) * _e414);
                                                        let _e882 = ((select(_e776[2][1], _e864, (_e864 > _e776[2][1])) - _e412) * _e414);
                                                        let _e885 = ((select(_e776[2][2], _e868, (_e868 < _e776[2][2])) - _e475) * _e478);
                                                        let _e886 = ((select(_e776[2][2], _e872, (_e872 > _e776[2][2])) - _e476) * _e478);
                                                        let _e888 = select(_e886, _e885, (_e885 < _e886));
                                                        let _e890 = select(_e886, _e885, (_e885 > _e886));
                                                        let _e892 = select(_e878, _e877, (_e877 < _e878));
                                                        let _e894 = select(_e882, _e881, (_e881 < _e882));
                                                        let _e896 = select(_e894, _e892, (_e892 > _e894));
                                                        let _e898 = select(_e888, _e896, (_e896 > _e888));
                                                        let _e900 = select(_e878, _e877, (_e877 > _e878));
                                                        let _e902 = select(_e882, _e881, (_e881 > _e882));
                                                        let _e904 = select(_e902, _e900, (_e900 < _e902));
                                                        let _e906 = select(_e890, _e904, (_e904 < _e890));
                                                        let _e907 = -(_e888);
                                                        let _e913 = select(_e580, _e898, (_e898 > _e580));
                                                        let _e917 = select(_e805, _e796, (_e796 < _e805));
                                                        let _e922 = select(_e805, _e796, (_e796 > _e805));
                                                        let _e929 = select(_e808, _e799, (_e799 < _e808));
                                                        let _e934 = select(_e808, _e799, (_e799 > _e808));
                                                        let _e943 = (((((_e834 && (_e850 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e814, _e917, (_e917 < _e814)) <= 0f) && (select(_e814, _e922, (_e922 > _e814)) >= 0f))) && ((select(_e817, _e929, (_e929 < _e817)) <= 0f) && (select(_e817, _e934, (_e934 > _e817)) >= 0f))) && (_e913 <= (_e906 + (select(_e907, _e890, (_e890 > _e907)) * 0.0000019073523f)))) && (_e913 <= _e674.member.member_1));
                                                        if _e943 {
                                                            let _e948 = (_e776[1][0] - _e776[0][0]);
                                                            let _e949 = (_e776[1][1] - _e776[0][1]);
                                                            let _e950 = (_e776[1][2] - _e776[0][2]);
                                                            let _e951 = vec3<f32>(_e948, _e949, _e950);
                                                            let _e952 = (_e776[2][0] - _e776[1][0]);
                                                            let _e953 = (_e776[2][1] - _e776[1][1]);
                                                            let _e954 = (_e776[2][2] - _e776[1][2]);
                                                            let _e955 = vec3<f32>(_e952, _e953, _e954);
                                                            let _e956 = (_e776[0][0] - _e776[2][0]);
                                                            let _e957 = (_e776[0][1] - _e776[2][1]);
                                                            let _e958 = (_e776[0][2] - _e776[2][2]);
                                                            let _e959 = vec3<f32>(_e956, _e957, _e958);
                                                            let _e960 = abs(_e948);
                                                            let _e961 = abs(_e949);
                                                            if (_e960 != _e960) {
                                                                phi_3492_ = true;
                                                            } else {
                                                                phi_3492_ = (_e961 >= _e960);
                                                            }
                                                            let _e965 = phi_3492_;
                                                            let _e966 = select(_e960, _e961, _e965);
                                                            let _e967 = abs(_e950);
                                                            if (_e966 != _e966) {
                                                                phi_3507_ = true;
                                                            } else {
                                                                phi_3507_ = (_e967 >= _e966);
                                                            }
                                                            let _e971 = phi_3507_;
                                                            let _e972 = select(_e966, _e967, _e971);
                                                            let _e973 = abs(_e952);
                                                            let _e974 = abs(_e953);
                                                            if (_e973 != _e973) {
                                                                phi_3522_ = true;
                                                            } else {
                                                                phi_3522_ = (_e974 >= _e973);
                                                            }
                                                            let _e978 = phi_3522_;
                                                            let _e979 = select(_e973, _e974, _e978);
                                                            let _e980 = abs(_e954);
                                                            if (_e979 != _e979) {
                                                                phi_3537_ = true;
                                                            } else {
                                                                phi_3537_ = (_e980 >= _e979);
                                                            }
                                                            let _e984 = phi_3537_;
                                                            let _e985 = select(_e979, _e980, _e984);
                                                            let _e986 = abs(_e956);
                                                            let _e987 = abs(_e957);
                                                            if (_e986 != _e986) {
                                                                phi_3552_ = true;
                                                            } else {
                                                                phi_3552_ = (_e987 >= _e986);
                                                            }
                                                            let _e991 = phi_3552_;
                                                            let _e992 = select(_e986, _e987, _e991);
                                                            let _e993 = abs(_e958);
                                                            if (_e992 != _e992) {
                                                                phi_3567_ = true;
                                                            } else {
                                                                phi_3567_ = (_e993 >= _e992);
                                                            }
                                                            let _e997 = phi_3567_;
                                                            let _e998 = select(_e992, _e993, _e997);
                                                            let _e1000 = select(_e985, _e972, (_e972 > _e985));
                                                            let _e1002 = select(_e998, _e1000, (_e1000 > _e998));
                                                            if (_e972 == _e1002) {
                                                                phi_1950_ = _e808;
                                                                phi_1951_ = _e805;
                                                                phi_1952_ = _e799;
                                                                phi_1953_ = _e796;
                                                                phi_1954_ = vec3<f32>(_e776[0][0], _e776[0][1], _e776[0][2]);
                                                                phi_1955_ = _e959;
                                                                phi_1956_ = _e955;
                                                                phi_1957_ = _e951;
                                                            } else {
                                                                let _e1004 = (_e985 == _e1002);
                                                                let _e1009 = vec3(_e1004);
                                                                phi_1950_ = select(_e799, _e817, _e1004);
                                                                phi_1951_ = select(_e796, _e814, _e1004);
                                                                phi_1952_ = select(_e817, _e808, _e1004);
                                                                phi_1953_ = select(_e814, _e805, _e1004);
                                                                phi_1954_ = select(vec3<f32>(_e776[2][0], _e776[2][1], _e776[2][2]), vec3<f32>(_e776[1][0], _e776[1][1], _e776[1][2]), _e1009);
                                                                phi_1955_ = select(_e955, _e951, _e1009);
                                                                phi_1956_ = select(_e951, _e959, _e1009);
                                                                phi_1957_ = select(_e959, _e955, _e1009);
                                                            }
                                                            let _e1015 = phi_1950_;
                                                            let _e1017 = phi_1951_;
                                                            let _e1019 = phi_1952_;
                                                            let _e1021 = phi_1953_;
                                                            let _e1023 = phi_1954_;
                                                            let _e1025 = phi_1955_;
                                                            let _e1027 = phi_1956_;
                                                            let _e1029 = phi_1957_;
                                                            let _e1036 = ((_e1027.y * _e1025.z) - (_e1025.y * _e1027.z));
                                                            let _e1041 = ((_e1027.z * _e1025.x) - (_e1025.z * _e1027.x));
                                                            let _e1044 = ((_e1027.x * _e1025.y) - (_e1025.x * _e1027.y));
                                                            let _e1047 = ((_e840 >= _e844) && (_e840 >= _e848));
                                                            let _e1048 = (_e844 >= _e848);
                                                            let _e1062 = (((_e1036 * (select(select(_e776[2][0], _e776[1][0], _e1048), _e776[0][0], _e1047) - _e309)) + (_e1041 * (select(select(_e776[2][1], _e776[1][1], _e1048), _e776[0][1], _e1047) - _e374))) + (_e1044 * (select(select(_e776[2][2], _e776[1][2], _e1048), _e776[0][2], _e1047) - _e438)));
                                                            let _e1067 = (((_e1036 * _e346) + (_e1041 * _e410)) + (_e1044 * _e474));
                                                            let _e1068 = (_e1017 - _e1021);
                                                            let _e1069 = (_e1015 - _e1019);
                                                            let _e1072 = ((_e1068 * _e1068) + (_e1069 * _e1069));
                                                            let _e1079 = (-(((_e1021 * _e1068) + (_e1019 * _e1069))) / select(0.000000000000000000000000000000000000011754944f, _e1072, (_e1072 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1081 = select(1f, _e1079, (_e1079 < 1f));
                                                            let _e1083 = select(0f, _e1081, (_e1081 > 0f));
                                                            let _e1092 = ((_e1023.x + (_e1029.x * _e1083)) - _e309);
                                                            let _e1095 = ((_e1023.y + (_e1029.y * _e1083)) - _e374);
                                                            let _e1098 = ((_e1023.z + (_e1029.z * _e1083)) - _e438);
                                                            let _e1101 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                            let _e1104 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                            let _e1106 = select(_e1104, _e1101, (_e1101 > _e1104));
                                                            let _e1109 = bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u));
                                                            let _e1111 = select(_e1109, _e1106, (_e1106 > _e1109));
                                                            let _e1115 = abs(_e1036);
                                                            let _e1116 = abs(_e1041);
                                                            if (_e1115 != _e1115) {
                                                                phi_3582_ = true;
                                                            } else {
                                                                phi_3582_ = (_e1116 >= _e1115);
                                                            }
                                                            let _e1120 = phi_3582_;
                                                            let _e1121 = select(_e1115, _e1116, _e1120);
                                                            let _e1122 = abs(_e1044);
                                                            if (_e1121 != _e1121) {
                                                                phi_3597_ = true;
                                                            } else {
                                                                phi_3597_ = (_e1122 >= _e1121);
                                                            }
                                                            let _e1126 = phi_3597_;
                                                            let _e1142 = abs(_e1027.x);
                                                            let _e1143 = abs(_e1027.y);
                                                            if (_e1142 != _e1142) {
                                                                phi_3612_ = true;
                                                            } else {
                                                                phi_3612_ = (_e1143 >= _e1142);
                                                            }
                                                            let _e1147 = phi_3612_;
                                                            let _e1148 = select(_e1142, _e1143, _e1147);
                                                            let _e1149 = abs(_e1027.z);
                                                            if (_e1148 != _e1148) {
                                                                phi_3627_ = true;
                                                            } else {
                                                                phi_3627_ = (_e1149 >= _e1148);
                                                            }
                                                            let _e1153 = phi_3627_;
                                                            let _e1156 = abs(_e1025.x);
                                                            let _e1157 = abs(_e1025.y);
                                                            if (_e1156 != _e1156) {
                                                                phi_3642_ = true;
                                                            } else {
                                                                phi_3642_ = (_e1157 >= _e1156);
                                                            }
                                                            let _e1161 = phi_3642_;
                                                            let _e1162 = select(_e1156, _e1157, _e1161);
                                                            let _e1163 = abs(_e1025.z);
                                                            if (_e1162 != _e1162) {
                                                                phi_3657_ = true;
                                                            } else {
                                                                phi_3657_ = (_e1163 >= _e1162);
                                                            }
                                                            let _e1167 = phi_3657_;
                                                            let _e1172 = ((bitcast<f32>((bitcast<u32>(((((_e1036 * _e1092) + (_e1041 * _e1095)) + (_e1044 * _e1098)) - _e1062)) & 2147483647u)) <= ((0.0000009536743f * select(_e1002, _e1111, (_e1111 > _e1002))) * select(_e1121, _e1122, _e1126))) && !((bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u)) <= ((0.0000038146973f * select(_e1148, _e1149, _e1153)) * select(_e1162, _e1163, _e1167)))));
                                                            let _e1173 = (_e1062 / _e1067);
                                                            if (_e943 && !(_e1172)) {
                                                                let _e1176 = (_e1098 / _e474);
                                                                let _e1184 = (((_e1036 * (_e1092 - (_e346 * _e1176))) + (_e1041 * (_e1095 - (_e410 * _e1176)))) / _e1067);
                                                                phi_2165_ = select(select(_e1176, (_e1176 + _e1184), (bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u)) <= _e1002)), _e1173, _e1172);
                                                            } else {
                                                                phi_2165_ = _e1173;
                                                            }
                                                            let _e1193 = phi_2165_;
                                                            let _e1195 = select(_e906, _e1193, (_e1193 < _e906));
                                                            let _e1197 = select(_e898, _e1195, (_e1195 > _e898));
                                                            let _e1198 = (1f / _e850);
                                                            phi_2185_ = type_41(_e1197, (_e844 * _e1198), (_e848 * _e1198), ((_e943 && (_e1197 >= _e580)) && (_e1197 <= _e674.member.member_1)));
                                                            phi_2186_ = type_41();
                                                        } else {
                                                            phi_2185_ = type_41();
                                                            phi_2186_ = type_41(0f, 0f, 0f, _e943);
                                                        }
                                                        let _e1207 = phi_2185_;
                                                        let _e1209 = phi_2186_;
                                                        phi_2189_ = _e1207;
                                                        phi_2190_ = _e1209;
                                                        phi_2191_ = select(true, false, _e943);
                                                    } else {
                                                        phi_2189_ = type_41();
                                                        phi_2190_ = type_41(0f, 0f, 0f, _e834);
                                                        phi_2191_ = true;
                                                    }
                                                    let _e1212 = phi_2189_;
                                                    let _e1214 = phi_2190_;
                                                    let _e1216 = phi_2191_;
                                                    if _e1216 {
                                                        phi_2195_ = _e1214;
                                                    } else {
                                                        phi_2195_ = _e1212;
                                                    }
                                                    let _e1218 = phi_2195_;
                                                    if _e1218.member_3 {
                                                        phi_2204_ = type_23(_e1218.member, _e1218.member_1, _e1218.member_2, _e709);
                                                    } else {
                                                        phi_2204_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1225 = phi_2204_;
                                                    if (_e1225.member_3 != 4294967295u) {
                                                        if (_e709 != _e586) {
                                                            if (_e1225.member < _e674.member.member.member) {
                                                                phi_2230_ = true;
                                                            } else {
                                                                if (_e1225.member == _e674.member.member.member) {
                                                                    phi_2229_ = (_e1225.member_3 < _e674.member.member.member_3);
                                                                } else {
                                                                    phi_2229_ = false;
                                                                }
                                                                let _e1240 = phi_2229_;
                                                                phi_2230_ = _e1240;
                                                            }
                                                            let _e1242 = phi_2230_;
                                                            if _e1242 {
                                                                phi_2237_ = type_42(type_38(_e1225, _e1225.member), _e701.member_1, _e701.member_2);
                                                            } else {
                                                                phi_2237_ = _e701;
                                                            }
                                                            let _e1249 = phi_2237_;
                                                            phi_2238_ = _e1249;
                                                        } else {
                                                            phi_2238_ = _e701;
                                                        }
                                                        let _e1251 = phi_2238_;
                                                        phi_2239_ = _e1251;
                                                    } else {
                                                        phi_2239_ = _e701;
                                                    }
                                                    let _e1253 = phi_2239_;
                                                    phi_1267_ = _e1253;
                                                } else {
                                                    phi_1267_ = type_42();
                                                }
                                                let _e1255 = phi_1267_;
                                                continue;
                                                continuing {
                                                    phi_1266_ = _e1255;
                                                    phi_1269_ = _e689;
                                                    phi_3765_ = _e617;
                                                    break if !(_e695);
                                                }
                                            }
                                            let _e1258 = phi_3765_;
                                            phi_3930_ = _e1258;
                                            if _e1258 {
                                                break;
                                            }
                                            phi_3989_ = _e1258;
                                            let _e1941 = local_12;
                                            phi_2240_ = _e1941;
                                        } else {
                                            phi_3989_ = _e617;
                                            phi_2240_ = _e619;
                                        }
                                        let _e1260 = phi_3989_;
                                        let _e1262 = phi_2240_;
                                        if _e667 {
                                            phi_3251_ = type_42();
                                            phi_3252_ = bool();
                                            phi_3253_ = u32();
                                            phi_3254_ = type_53();
                                        } else {
                                            let _e1263 = (_e663.member_1 < _e90);
                                            if _e1263 {
                                                if _e1263 {
                                                } else {
                                                    phi_3930_ = true;
                                                    break;
                                                }
                                                let _e1265 = global_7.member[_e663.member_1];
                                                phi_2261_ = _e1265;
                                            } else {
                                                phi_2261_ = type_46(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1267 = phi_2261_;
                                            let _e1282 = ((10u * _e262) & 31u);
                                            let _e1285 = ((_e1267.member[0] >> bitcast<u32>(_e1282)) & 1023u);
                                            let _e1293 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e128));
                                            let _e1298 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1285)) - 8388608f) * _e1293)) ^ _e128)));
                                            let _e1302 = select(select(_e663.member.member_1[0], _e1298, (_e1298 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1285 == 1023u));
                                            let _e1304 = ((10u * _e261) & 31u);
                                            let _e1307 = ((_e1267.member[0] >> bitcast<u32>(_e1304)) & 1023u);
                                            let _e1315 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e128));
                                            let _e1320 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1307)) - 8388608f) * _e1315)) ^ _e128)));
                                            let _e1324 = select(select(_e663.member.member_1[1], _e1320, (_e1320 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1307 == 1023u));
                                            let _e1326 = ((10u * _e263) & 31u);
                                            let _e1329 = ((_e1267.member[0] >> bitcast<u32>(_e1326)) & 1023u);
                                            let _e1337 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e128));
                                            let _e1342 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1329)) - 8388608f) * _e1337)) ^ _e128)));
                                            let _e1346 = select(select(_e663.member.member_1[2], _e1342, (_e1342 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1329 == 1023u));
                                            let _e1349 = ((_e1267.member[1] >> bitcast<u32>(_e1282)) & 1023u);
                                            let _e1357 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1349)) - 8388608f) * _e1293)) ^ _e128)));
                                            let _e1361 = select(select(_e663.member.member_1[0], _e1357, (_e1357 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1349 == 1023u));
                                            let _e1364 = ((_e1267.member[1] >> bitcast<u32>(_e1304)) & 1023u);
                                            let _e1372 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1364)) - 8388608f) * _e1315)) ^ _e128)));
                                            let _e1376 = select(select(_e663.member.member_1[1], _e1372, (_e1372 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1364 == 1023u));
                                            let _e1379 = ((_e1267.member[1] >> bitcast<u32>(_e1326)) & 1023u);
                                            let _e1387 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1379)) - 8388608f) * _e1337)) ^ _e128)));
                                            let _e1391 = select(select(_e663.member.member_1[2], _e1387, (_e1387 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1379 == 1023u));
                                            let _e1397 = ((_e1267.member_1[0] >> bitcast<u32>(_e1282)) & 1023u);
                                            let _e1405 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1397)) - 8388608f) * _e1293)) ^ _e128)));
                                            let _e1409 = select(select(_e663.member.member_1[0], _e1405, (_e1405 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1397 == 1023u));
                                            let _e1412 = ((_e1267.member_1[0] >> bitcast<u32>(_e1304)) & 1023u);
                                            let _e1420 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1412)) - 8388608f) * _e1315)) ^ _e128)));
                                            let _e1424 = select(select(_e663.member.member_1[1], _e1420, (_e1420 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1412 == 1023u));
                                            let _e1427 = ((_e1267.member_1[0] >> bitcast<u32>(_e1326)) & 1023u);
                                            let _e1435 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1427)) - 8388608f) * _e1337)) ^ _e128)));
                                            let _e1439 = select(select(_e663.member.member_1[2], _e1435, (_e1435 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1427 == 1023u));
                                            let _e1442 = ((_e1267.member_1[1] >> bitcast<u32>(_e1282)) & 1023u);
                                            let _e1450 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1442)) - 8388608f) * _e1293)) ^ _e128)));
                                            let _e1454 = select(select(_e663.member.member_1[0], _e1450, (_e1450 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1442 == 1023u));
                                            let _e1457 = ((_e1267.member_1[1] >> bitcast<u32>(_e1304)) & 1023u);
                                            let _e1465 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1457)) - 8388608f) * _e1315)) ^ _e128)));
                                            let _e1469 = select(select(_e663.member.member_1[1], _e1465, (_e1465 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1457 == 1023u));
                                            let _e1472 = ((_e1267.member_1[1] >> bitcast<u32>(_e1326)) & 1023u);
                                            let _e1480 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1472)) - 8388608f) * _e1337)) ^ _e128)));
                                            let _e1484 = select(select(_e663.member.member_1[2], _e1480, (_e1480 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1472 == 1023u));
                                            let _e1489 = type_53(type_51(array<f32, 3>(_e1302, _e1324, _e1346), array<f32, 3>(_e1361, _e1376, _e1391)), _e1267.member_2);
                                            let _e1494 = type_53(type_51(array<f32, 3>(_e1409, _e1424, _e1439), array<f32, 3>(_e1454, _e1469, _e1484)), _e1267.member_3);
                                            let _e1507 = ((_e1302 - _e347) * _e350);
                                            let _e1508 = ((_e1409 - _e347) * _e350);
                                            let _e1509 = ((_e1361 - _e348) * _e350);
                                            let _e1510 = ((_e1454 - _e348) * _e350);
                                            let _e1515 = ((_e1324 - _e411) * _e414);
                                            let _e1516 = ((_e1424 - _e411) * _e414);
                                            let _e1517 = ((_e1376 - _e412) * _e414);
                                            let _e1518 = ((_e1469 - _e412) * _e414);
                                            let _e1523 = ((_e1346 - _e475) * _e478);
                                            let _e1524 = ((_e1439 - _e475) * _e478);
                                            let _e1525 = ((_e1391 - _e476) * _e478);
                                            let _e1526 = ((_e1484 - _e476) * _e478);
                                            let _e1528 = select(_e1525, _e1523, (_e1523 < _e1525));
                                            let _e1530 = select(_e1526, _e1524, (_e1524 < _e1526));
                                            let _e1532 = select(_e1525, _e1523, (_e1523 > _e1525));
                                            let _e1534 = select(_e1526, _e1524, (_e1524 > _e1526));
                                            let _e1536 = select(_e1509, _e1507, (_e1507 < _e1509));
                                            let _e1538 = select(_e1510, _e1508, (_e1508 < _e1510));
                                            let _e1540 = select(_e1517, _e1515, (_e1515 < _e1517));
                                            let _e1542 = select(_e1518, _e1516, (_e1516 < _e1518));
                                            let _e1544 = select(_e1540, _e1536, (_e1536 > _e1540));
                                            let _e1546 = select(_e1542, _e1538, (_e1538 > _e1542));
                                            let _e1548 = select(_e1528, _e1544, (_e1544 > _e1528));
                                            let _e1550 = select(_e1530, _e1546, (_e1546 > _e1530));
                                            let _e1552 = select(_e1509, _e1507, (_e1507 > _e1509));
                                            let _e1554 = select(_e1510, _e1508, (_e1508 > _e1510));
                                            let _e1556 = select(_e1517, _e1515, (_e1515 > _e1517));
                                            let _e1558 = select(_e1518, _e1516, (_e1516 > _e1518));
                                            let _e1560 = select(_e1556, _e1552, (_e1552 < _e1556));
                                            let _e1562 = select(_e1558, _e1554, (_e1554 < _e1558));
                                            let _e1567 = -(_e1528);
                                            let _e1568 = -(_e1530);
                                            let _e1575 = (select(_e1532, _e1560, (_e1560 < _e1532)) + (select(_e1567, _e1532, (_e1532 > _e1567)) * 0.0000019073523f));
                                            let _e1576 = (select(_e1534, _e1562, (_e1562 < _e1534)) + (select(_e1568, _e1534, (_e1534 > _e1568)) * 0.0000019073523f));
                                            let _e1578 = select(_e580, _e1548, (_e1548 > _e580));
                                            let _e1580 = select(_e580, _e1550, (_e1550 > _e580));
                                            let _e1585 = (_e1578 <= select(_e1262.member.member_1, _e1575, (_e1575 < _e1262.member.member_1)));
                                            let _e1586 = (_e1580 <= select(_e1262.member.member_1, _e1576, (_e1576 < _e1262.member.member_1)));
                                            let _e1587 = (_e1578 <= _e1580);
                                            if _e1585 {
                                                if _e1586 {
                                                    if _e1587 {
                                                        phi_3150_ = _e1494;
                                                    } else {
                                                        phi_3150_ = _e1489;
                                                    }
                                                    let _e1589 = phi_3150_;
                                                    let _e1596 = (_e661 % 128u);
                                                    let _e1597 = (_e1596 < 128u);
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1596] = _e1589.member_1;
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1596] = _e1589.member.member[0];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1596] = _e1589.member.member[1];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1596] = _e1589.member.member[2];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1596] = _e1589.member.member_1[0];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1596] = _e1589.member.member_1[1];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local[_e1596] = _e1589.member.member_1[2];
                                                    if _e1597 {
                                                    } else {
                                                        phi_3930_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1596] = select(_e1578, _e1580, _e1587);
                                                    if _e1587 {
                                                        phi_3226_ = _e1489;
                                                    } else {
                                                        phi_3226_ = _e1494;
                                                    }
                                                    let _e1614 = phi_3226_;
                                                    phi_3227_ = (_e661 + 1u);
                                                    phi_3228_ = _e1614;
                                                } else {
                                                    phi_3227_ = u32();
                                                    phi_3228_ = type_53();
                                                }
                                                let _e1616 = phi_3227_;
                                                let _e1618 = phi_3228_;
                                                phi_3230_ = _e1616;
                                                phi_3231_ = _e1618;
                                                phi_3232_ = select(true, false, _e1586);
                                            } else {
                                                phi_3230_ = u32();
                                                phi_3231_ = type_53();
                                                phi_3232_ = true;
                                            }
                                            let _e1621 = phi_3230_;
                                            let _e1623 = phi_3231_;
                                            let _e1625 = phi_3232_;
                                            if _e1625 {
                                                if _e1585 {
                                                    phi_3239_ = _e1489;
                                                } else {
                                                    phi_3239_ = _e1494;
                                                }
                                                let _e1627 = phi_3239_;
                                                phi_3244_ = select(_e1586, true, _e1585);
                                                phi_3246_ = _e1627;
                                            } else {
                                                phi_3244_ = _e659;
                                                phi_3246_ = _e1623;
                                            }
                                            let _e1630 = phi_3244_;
                                            let _e1632 = phi_3246_;
                                            phi_3251_ = type_42(_e1262.member, (_e1262.member_1 + 1u), _e1262.member_2);
                                            phi_3252_ = _e1630;
                                            phi_3253_ = select(_e1621, _e661, _e1625);
                                            phi_3254_ = _e1632;
                                        }
                                        let _e1635 = phi_3251_;
                                        let _e1637 = phi_3252_;
                                        let _e1639 = phi_3253_;
                                        let _e1641 = phi_3254_;
                                        if _e667 {
                                            phi_3262_ = _e1262;
                                            phi_3265_ = _e663;
                                        } else {
                                            phi_3262_ = _e1635;
                                            phi_3265_ = _e1641;
                                        }
                                        let _e1643 = phi_3262_;
                                        let _e1645 = phi_3265_;
                                        phi_3933_ = _e1260;
                                        phi_3266_ = _e1643;
                                        phi_3267_ = (_e621 - 1u);
                                        phi_3268_ = select(_e1637, false, _e667);
                                        phi_3269_ = select(_e1639, _e661, _e667);
                                        phi_3270_ = _e1645;
                                    } else {
                                        phi_3933_ = _e617;
                                        phi_3266_ = _e619;
                                        phi_3267_ = _e621;
                                        phi_3268_ = _e659;
                                        phi_3269_ = _e661;
                                        phi_3270_ = _e663;
                                    }
                                    let _e1649 = phi_3933_;
                                    let _e1651 = phi_3266_;
                                    let _e1653 = phi_3267_;
                                    let _e1655 = phi_3268_;
                                    let _e1657 = phi_3269_;
                                    let _e1659 = phi_3270_;
                                    phi_3932_ = _e1649;
                                    phi_3271_ = _e1651;
                                    phi_3272_ = _e1653;
                                    phi_3273_ = _e1655;
                                    phi_3274_ = _e1657;
                                    phi_3275_ = _e1659;
                                } else {
                                    phi_3932_ = _e617;
                                    phi_3271_ = type_42();
                                    phi_3272_ = u32();
                                    phi_3273_ = bool();
                                    phi_3274_ = u32();
                                    phi_3275_ = type_53();
                                }
                                let _e1661 = phi_3932_;
                                let _e1663 = phi_3271_;
                                let _e1665 = phi_3272_;
                                let _e1667 = phi_3273_;
                                let _e1669 = phi_3274_;
                                let _e1671 = phi_3275_;
                                phi_3931_ = _e1661;
                                phi_1141_ = _e1663;
                                phi_1144_ = _e1665;
                                phi_1146_ = _e1667;
                                phi_1148_ = _e1669;
                                phi_1150_ = _e1671;
                                phi_3276_ = _e631;
                            } else {
                                phi_3931_ = _e617;
                                phi_1141_ = type_42();
                                phi_1144_ = u32();
                                phi_1146_ = bool();
                                phi_1148_ = u32();
                                phi_1150_ = type_53();
                                phi_3276_ = false;
                            }
                            let _e1673 = phi_3931_;
                            let _e1675 = phi_1141_;
                            let _e1677 = phi_1144_;
                            let _e1679 = phi_1146_;
                            let _e1681 = phi_1148_;
                            let _e1683 = phi_1150_;
                            let _e1685 = phi_3276_;
                            continue;
                            continuing {
                                phi_3771_ = _e1673;
                                phi_1140_ = _e1675;
                                phi_1143_ = _e1677;
                                phi_1145_ = _e1679;
                                phi_1147_ = _e1681;
                                phi_1149_ = _e1683;
                                phi_3930_ = _e1673;
                                break if !(_e1685);
                            }
                        }
                        let _e1688 = phi_3930_;
                        if _e1688 {
                            break;
                        }
                        let _e1690 = local_10;
                        if (_e1690.member.member.member_3 != 4294967295u) {
                            let _e1696 = bitcast<u32>(_e1690.member.member.member);
                            let _e1700 = (bitcast<i32>((_e1696 >> bitcast<u32>(23i))) & 255i);
                            let _e1701 = (_e1700 + _e264);
                            if (_e1700 == 255i) {
                                phi_3335_ = _e1690.member.member.member;
                            } else {
                                if (_e1700 > 0i) {
                                    if (_e1701 > 0i) {
                                        let _e1705 = (_e1701 < 255i);
                                        if _e1705 {
                                            phi_3314_ = bitcast<f32>((_e1696 + bitcast<u32>((_e264 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3314_ = f32();
                                        }
                                        let _e1712 = phi_3314_;
                                        phi_3316_ = _e1712;
                                        phi_3317_ = select(true, false, _e1705);
                                    } else {
                                        phi_3316_ = f32();
                                        phi_3317_ = true;
                                    }
                                    let _e1715 = phi_3316_;
                                    let _e1717 = phi_3317_;
                                    phi_3318_ = _e1715;
                                    phi_3319_ = _e1717;
                                } else {
                                    phi_3318_ = f32();
                                    phi_3319_ = true;
                                }
                                let _e1719 = phi_3318_;
                                let _e1721 = phi_3319_;
                                if _e1721 {
                                    let _e1722 = (_e1696 & 2147483648u);
                                    let _e1729 = ((_e1696 & 8388607u) | (select(0u, 1u, ((_e1696 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1733 = (_e1729 == 0u);
                                    if _e1733 {
                                        phi_3735_ = bitcast<f32>(_e1722);
                                    } else {
                                        let _e1738 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1729)), 32u, _e1733) - 8u);
                                        let _e1741 = (_e1729 << bitcast<u32>((_e1738 & 31u)));
                                        let _e1743 = ((_e1701 + select(0i, 1i, (_e1700 == 0i))) - bitcast<i32>(_e1738));
                                        if (_e1743 >= 255i) {
                                            phi_3725_ = bitcast<f32>((_e1722 | 2139095040u));
                                            phi_3726_ = f32();
                                            phi_3727_ = true;
                                        } else {
                                            let _e1745 = (_e1743 > 0i);
                                            if _e1745 {
                                                phi_3719_ = bitcast<f32>(((_e1722 | (bitcast<u32>(_e1743) << bitcast<u32>(23i))) | (_e1741 & 8388607u)));
                                                phi_3720_ = f32();
                                            } else {
                                                if (_e1743 < -24i) {
                                                    phi_3685_ = 26u;
                                                } else {
                                                    phi_3685_ = bitcast<u32>((1i - _e1743));
                                                }
                                                let _e1750 = phi_3685_;
                                                let _e1751 = (_e1750 & 31u);
                                                let _e1753 = (_e1741 >> bitcast<u32>(_e1751));
                                                let _e1757 = (_e1741 & ((1u << bitcast<u32>(_e1751)) - 1u));
                                                let _e1761 = (1u << bitcast<u32>(((_e1750 - 1u) & 31u)));
                                                if (_e1757 > _e1761) {
                                                    phi_3706_ = true;
                                                } else {
                                                    if (_e1757 == _e1761) {
                                                        phi_3703_ = ((_e1753 & 1u) == 1u);
                                                    } else {
                                                        phi_3703_ = false;
                                                    }
                                                    let _e1767 = phi_3703_;
                                                    phi_3706_ = _e1767;
                                                }
                                                let _e1769 = phi_3706_;
                                                phi_3719_ = f32();
                                                phi_3720_ = bitcast<f32>((_e1722 | (_e1753 + select(0u, 1u, _e1769))));
                                            }
                                            let _e1782 = phi_3719_;
                                            let _e1784 = phi_3720_;
                                            phi_3725_ = _e1782;
                                            phi_3726_ = _e1784;
                                            phi_3727_ = _e1745;
                                        }
                                        let _e1788 = phi_3725_;
                                        let _e1790 = phi_3726_;
                                        let _e1792 = phi_3727_;
                                        phi_3735_ = select(_e1790, _e1788, _e1792);
                                    }
                                    let _e1796 = phi_3735_;
                                    phi_3334_ = _e1796;
                                } else {
                                    phi_3334_ = _e1719;
                                }
                                let _e1798 = phi_3334_;
                                phi_3335_ = _e1798;
                            }
                            let _e1800 = phi_3335_;
                            let _e1801 = bitcast<u32>(_e1800);
                            if ((_e1801 & 2147483647u) >= 2139095040u) {
                                phi_3347_ = bitcast<f32>(((_e1801 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3347_ = _e1800;
                            }
                            let _e1808 = phi_3347_;
                            phi_3352_ = type_23(_e1808, _e1690.member.member.member_1, _e1690.member.member.member_2, _e1690.member.member.member_3);
                        } else {
                            phi_3352_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1813 = phi_3352_;
                        if _e140 {
                        } else {
                            break;
                        }
                        global_2.member[_e132] = _e1813;
                        let _e1817 = local_11;
                        if _e141 {
                        } else {
                            break;
                        }
                        global_5.member[_e132] = _e1817.member_1;
                        if _e139 {
                        } else {
                            break;
                        }
                        let _e1822 = select(0u, 1u, (_e208 <= _e218));
                        if (_e1822 > 0u) {
                            let _e1824 = (1u < _e100);
                            if _e1824 {
                                if (0u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1828 = atomicAdd((&global_6.member[0u]), _e1822);
                                if ((_e1828 + _e1822) < _e1828) {
                                    if _e1824 {
                                    } else {
                                        break;
                                    }
                                    let _e1833 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1836 = select(0u, 1u, (_e1813.member_3 != 4294967295u));
                        if (_e1836 > 0u) {
                            let _e1838 = (3u < _e100);
                            if _e1838 {
                                if (2u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1842 = atomicAdd((&global_6.member[2u]), _e1836);
                                if ((_e1842 + _e1836) < _e1842) {
                                    if _e1838 {
                                    } else {
                                        break;
                                    }
                                    let _e1847 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1817.member_1 > 0u) {
                            let _e1849 = (5u < _e100);
                            if _e1849 {
                                if (4u < _e100) {
                                } else {
                                    break;
                                }
                                let _e1853 = atomicAdd((&global_6.member[4u]), _e1817.member_1);
                                if ((_e1853 + _e1817.member_1) < _e1853) {
                                    if _e1849 {
                                    } else {
                                        break;
                                    }
                                    let _e1858 = atomicAdd((&global_6.member[5u]), 1u);
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
