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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_43 {
    member: type_26,
    member_1: f32,
}

struct type_46 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_53 {
    member: type_38,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_53,
    member_2: type_53,
}

struct type_59 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_48;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_59;

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
    var phi_485_: i32;
    var phi_486_: i32;
    var phi_496_: bool;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_509_: bool;
    var phi_514_: u32;
    var phi_547_: i32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_669_: f32;
    var phi_681_: f32;
    var phi_690_: f32;
    var phi_696_: f32;
    var phi_736_: f32;
    var phi_742_: f32;
    var phi_794_: f32;
    var phi_806_: f32;
    var phi_815_: f32;
    var phi_821_: f32;
    var phi_861_: f32;
    var phi_867_: f32;
    var phi_919_: f32;
    var phi_931_: f32;
    var phi_986_: i32;
    var phi_1008_: u32;
    var phi_1009_: u32;
    var phi_1046_: i32;
    var phi_1068_: u32;
    var phi_1069_: u32;
    var phi_1077_: f32;
    var phi_1078_: f32;
    var phi_4114_: bool;
    var phi_1183_: type_46;
    var phi_1186_: bool;
    var phi_1188_: u32;
    var phi_1190_: u32;
    var phi_1192_: type_53;
    var phi_1203_: bool;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: type_53;
    var phi_3117_: u32;
    var phi_3118_: u32;
    var phi_3128_: u32;
    var phi_3130_: u32;
    var phi_3131_: bool;
    var phi_3151_: u32;
    var phi_3152_: u32;
    var phi_3156_: type_54;
    var phi_3521_: type_53;
    var phi_3598_: type_53;
    var phi_3599_: u32;
    var phi_3600_: type_53;
    var phi_3602_: u32;
    var phi_3603_: type_53;
    var phi_3604_: bool;
    var phi_3613_: type_53;
    var phi_3618_: bool;
    var phi_3620_: type_53;
    var phi_1309_: type_46;
    var phi_1312_: type_7;
    var phi_1313_: type_7;
    var phi_1335_: type_7;
    var phi_1359_: u32;
    var phi_1451_: array<array<f32, 3>, 3>;
    var phi_1603_: bool;
    var phi_1632_: bool;
    var phi_2051_: f32;
    var phi_2052_: f32;
    var phi_2053_: f32;
    var phi_2054_: f32;
    var phi_2055_: vec3<f32>;
    var phi_2056_: vec3<f32>;
    var phi_2057_: vec3<f32>;
    var phi_2058_: vec3<f32>;
    var phi_2095_: bool;
    var phi_2104_: vec3<f32>;
    var phi_2269_: f32;
    var phi_2271_: f32;
    var phi_2272_: bool;
    var phi_2292_: f32;
    var phi_2293_: f32;
    var phi_2316_: type_26;
    var phi_2318_: type_26;
    var phi_2319_: bool;
    var phi_2323_: type_26;
    var phi_2324_: type_26;
    var phi_2325_: type_26;
    var phi_2326_: bool;
    var phi_2330_: type_26;
    var phi_2331_: bool;
    var phi_2332_: type_26;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2335_: type_26;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var phi_2345_: type_26;
    var phi_2346_: bool;
    var phi_2350_: type_26;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2383_: type_46;
    var phi_2384_: type_46;
    var phi_2385_: type_46;
    var phi_1310_: type_46;
    var phi_4108_: bool;
    var phi_4272_: bool;
    var phi_3625_: type_46;
    var phi_3626_: bool;
    var phi_3627_: u32;
    var phi_3628_: type_53;
    var phi_4271_: bool;
    var phi_3629_: type_46;
    var phi_3630_: bool;
    var phi_3631_: u32;
    var phi_3632_: u32;
    var phi_3633_: type_53;
    var phi_4270_: bool;
    var phi_3634_: type_46;
    var phi_3635_: bool;
    var phi_3636_: u32;
    var phi_3637_: u32;
    var phi_3638_: type_53;
    var phi_4269_: bool;
    var phi_1184_: type_46;
    var phi_1187_: bool;
    var phi_1189_: u32;
    var phi_1191_: u32;
    var phi_1193_: type_53;
    var phi_3639_: bool;
    var phi_4268_: bool;
    var local_10: type_46;
    var phi_3677_: f32;
    var phi_3679_: f32;
    var phi_3680_: bool;
    var phi_3681_: f32;
    var phi_3682_: bool;
    var phi_4016_: u32;
    var phi_4034_: bool;
    var phi_4037_: bool;
    var phi_4050_: f32;
    var phi_4051_: f32;
    var phi_4056_: f32;
    var phi_4057_: f32;
    var phi_4058_: bool;
    var phi_4066_: f32;
    var phi_3697_: f32;
    var phi_3698_: f32;
    var phi_3710_: f32;
    var phi_3715_: type_26;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e98 = arrayLength((&global_1.member));
            let _e106 = arrayLength((&global_7.member));
            let _e110 = global_3.member[0u][0u];
            let _e114 = global_3.member[0u][1u];
            let _e118 = global_3.member[0u][2u];
            let _e122 = global_3.member[0u][3u];
            let _e126 = global_3.member[1u][0u];
            let _e130 = global_3.member[1u][1u];
            let _e134 = global_3.member[1u][2u];
            let _e138 = (_e94.x + (_e94.y * 2097152u));
            let _e150 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e122) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            local = array<i32, 3>(bitcast<i32>(_e126), bitcast<i32>(_e130), bitcast<i32>(_e134));
            let _e153 = (_e138 < arrayLength((&global_5.member)));
            if _e153 {
                let _e154 = (_e138 < arrayLength((&global_2.member)));
                if _e154 {
                    let _e155 = (_e138 < arrayLength((&global_6.member)));
                    if _e155 {
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e165 = global_5.member[_e138].member.member_2[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_5.member[_e138].member.member_2[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_5.member[_e138].member.member_2[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e189 = global_5.member[_e138].member.member[0u];
                        let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                        let _e197 = global_5.member[_e138].member.member[1u];
                        let _e199 = (bitcast<u32>(_e197) & 2147483647u);
                        let _e205 = global_5.member[_e138].member.member[2u];
                        let _e207 = (bitcast<u32>(_e205) & 2147483647u);
                        let _e209 = select(_e175, _e167, (_e175 < _e167));
                        let _e211 = select(_e183, _e209, (_e183 < _e209));
                        let _e213 = select(_e191, _e211, (_e191 < _e211));
                        let _e215 = select(_e199, _e213, (_e199 < _e213));
                        let _e217 = select(_e207, _e215, (_e207 < _e215));
                        let _e222 = global_5.member[_e138].member.member_1;
                        let _e223 = bitcast<u32>(_e222);
                        let _e224 = (_e223 & 2147483647u);
                        let _e232 = global_5.member[_e138].member.member_3;
                        let _e233 = bitcast<u32>(_e232);
                        let _e234 = (_e233 & 2147483647u);
                        let _e238 = (((select(_e224, _e217, (_e224 < _e217)) < 2139095040u) && (_e234 <= 2139095040u)) && (_e211 > 0u));
                        if _e238 {
                            let _e241 = (bitcast<u32>(bitcast<f32>(_e211)) & 2147483647u);
                            if (_e241 >= 8388608u) {
                                phi_485_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_485_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_485_;
                            phi_486_ = _e255;
                        } else {
                            phi_486_ = 0i;
                        }
                        let _e257 = phi_486_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_496_ = true;
                        } else {
                            phi_496_ = (_e175 == _e211);
                        }
                        let _e261 = phi_496_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_506_ = _e263;
                            phi_507_ = _e263;
                            phi_509_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_506_ = u32();
                            phi_507_ = 0u;
                            phi_509_ = true;
                        }
                        let _e267 = phi_506_;
                        let _e269 = phi_507_;
                        let _e271 = phi_509_;
                        if _e271 {
                            phi_514_ = (_e269 + 1u);
                        } else {
                            phi_514_ = 0u;
                        }
                        let _e275 = phi_514_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_547_ = -126i;
                        } else {
                            phi_547_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_547_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_5.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_565_ = _e299[0];
                        } else {
                            phi_565_ = _e299[1];
                        }
                        let _e304 = phi_565_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_571_ = _e299[2];
                        } else {
                            phi_571_ = _e304;
                        }
                        let _e308 = phi_571_;
                        let _e309 = bitcast<u32>(_e308);
                        let _e311 = ((_e309 & 2139095040u) != 0u);
                        let _e323 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * select(0.00000011920929f, 1f, _e311));
                        let _e324 = global_5.member[_e138].member.member_2;
                        if _e300 {
                            phi_611_ = _e324[0];
                        } else {
                            phi_611_ = _e324[1];
                        }
                        let _e328 = phi_611_;
                        if _e305 {
                            phi_617_ = _e324[2];
                        } else {
                            phi_617_ = _e328;
                        }
                        let _e331 = phi_617_;
                        let _e332 = bitcast<u32>(_e331);
                        let _e334 = ((_e332 & 2139095040u) != 0u);
                        let _e348 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e331, _e334) * _e288) * select(0.00000011920929f, 1f, _e334)) * _e294);
                        let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e352 {
                            let _e356 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e360 = phi_669_;
                        let _e361 = (_e323 + _e360);
                        let _e362 = (_e323 - _e360);
                        let _e363 = select(_e348, 0f, _e352);
                        if _e352 {
                            phi_681_ = 38685626000000000000000000f;
                        } else {
                            phi_681_ = (1f / _e348);
                        }
                        let _e366 = phi_681_;
                        let _e367 = (_e275 == 0u);
                        if _e367 {
                            phi_690_ = _e299[0];
                        } else {
                            phi_690_ = _e299[1];
                        }
                        let _e371 = phi_690_;
                        let _e372 = (_e275 == 2u);
                        if _e372 {
                            phi_696_ = _e299[2];
                        } else {
                            phi_696_ = _e371;
                        }
                        let _e375 = phi_696_;
                        let _e376 = bitcast<u32>(_e375);
                        let _e378 = ((_e376 & 2139095040u) != 0u);
                        let _e390 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e376 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e376 & 2147483648u))), _e375, _e378) * select(0.00000011920929f, 1f, _e378));
                        if _e367 {
                            phi_736_ = _e324[0];
                        } else {
                            phi_736_ = _e324[1];
                        }
                        let _e394 = phi_736_;
                        if _e372 {
                            phi_742_ = _e324[2];
                        } else {
                            phi_742_ = _e394;
                        }
                        let _e397 = phi_742_;
                        let _e398 = bitcast<u32>(_e397);
                        let _e400 = ((_e398 & 2139095040u) != 0u);
                        let _e414 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * _e288) * select(0.00000011920929f, 1f, _e400)) * _e294);
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e414) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e418 {
                            let _e422 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                            phi_794_ = select(0.00000000000011368684f, _e422, (_e422 > 0.00000000000011368684f));
                        } else {
                            phi_794_ = 0f;
                        }
                        let _e426 = phi_794_;
                        let _e427 = (_e390 + _e426);
                        let _e428 = (_e390 - _e426);
                        let _e429 = select(_e414, 0f, _e418);
                        if _e418 {
                            phi_806_ = 38685626000000000000000000f;
                        } else {
                            phi_806_ = (1f / _e414);
                        }
                        let _e432 = phi_806_;
                        let _e433 = (_e277 == 0u);
                        if _e433 {
                            phi_815_ = _e299[0];
                        } else {
                            phi_815_ = _e299[1];
                        }
                        let _e437 = phi_815_;
                        let _e438 = (_e277 == 2u);
                        if _e438 {
                            phi_821_ = _e299[2];
                        } else {
                            phi_821_ = _e437;
                        }
                        let _e441 = phi_821_;
                        let _e442 = bitcast<u32>(_e441);
                        let _e444 = ((_e442 & 2139095040u) != 0u);
                        let _e456 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e442 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e442 & 2147483648u))), _e441, _e444) * select(0.00000011920929f, 1f, _e444));
                        if _e433 {
                            phi_861_ = _e324[0];
                        } else {
                            phi_861_ = _e324[1];
                        }
                        let _e460 = phi_861_;
                        if _e438 {
                            phi_867_ = _e324[2];
                        } else {
                            phi_867_ = _e460;
                        }
                        let _e463 = phi_867_;
                        let _e464 = bitcast<u32>(_e463);
                        let _e466 = ((_e464 & 2139095040u) != 0u);
                        let _e480 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * _e288) * select(0.00000011920929f, 1f, _e466)) * _e294);
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e484 {
                            let _e488 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                            phi_919_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                        } else {
                            phi_919_ = 0f;
                        }
                        let _e492 = phi_919_;
                        let _e493 = (_e456 + _e492);
                        let _e494 = (_e456 - _e492);
                        let _e495 = select(_e480, 0f, _e484);
                        if _e484 {
                            phi_931_ = 38685626000000000000000000f;
                        } else {
                            phi_931_ = (1f / _e480);
                        }
                        let _e498 = phi_931_;
                        let _e501 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                        let _e504 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                        let _e506 = select(_e504, _e501, (_e501 > _e504));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                        if (_e238 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                            let _e521 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e524 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                            let _e528 = (_e521 == 0u);
                            let _e531 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e521)), 32u, _e528)) - 8i);
                            if (_e524 == 255i) {
                                phi_986_ = 255i;
                            } else {
                                phi_986_ = (((_e524 + select(0i, 1i, (_e524 == 0i))) - _e531) + _e257);
                            }
                            let _e539 = phi_986_;
                            let _e549 = (_e539 <= 0i);
                            if _e549 {
                                phi_1009_ = u32();
                            } else {
                                if _e528 {
                                    phi_1008_ = u32();
                                } else {
                                    phi_1008_ = select(((bitcast<u32>(_e539) << bitcast<u32>(23i)) | ((_e521 << bitcast<u32>(((_e531 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e539 >= 255i));
                                }
                                let _e553 = phi_1008_;
                                phi_1009_ = _e553;
                            }
                            let _e555 = phi_1009_;
                            let _e567 = ((_e234 & 8388607u) | (select(0u, 1u, ((_e234 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e570 = bitcast<i32>((_e234 >> bitcast<u32>(23i)));
                            let _e574 = (_e567 == 0u);
                            let _e577 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e567)), 32u, _e574)) - 8i);
                            if (_e570 == 255i) {
                                phi_1046_ = 255i;
                            } else {
                                phi_1046_ = (((_e570 + select(0i, 1i, (_e570 == 0i))) - _e577) + _e257);
                            }
                            let _e585 = phi_1046_;
                            let _e595 = (_e585 <= 0i);
                            if _e595 {
                                phi_1069_ = u32();
                            } else {
                                if _e574 {
                                    phi_1068_ = u32();
                                } else {
                                    phi_1068_ = select(((bitcast<u32>(_e585) << bitcast<u32>(23i)) | ((_e567 << bitcast<u32>(((_e577 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e585 >= 255i));
                                }
                                let _e599 = phi_1068_;
                                phi_1069_ = _e599;
                            }
                            let _e601 = phi_1069_;
                            phi_1077_ = bitcast<f32>(((_e233 & 2147483648u) | select(_e601, 0u, select(_e574, true, _e595))));
                            phi_1078_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e555, 0u, select(_e528, true, _e549))));
                        } else {
                            phi_1077_ = 0f;
                            phi_1078_ = 1f;
                        }
                        let _e607 = phi_1077_;
                        let _e609 = phi_1078_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e615 = global_5.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e618 = (_e276 % 3u);
                        let _e619 = (_e618 < 3u);
                        if _e619 {
                        } else {
                            break;
                        }
                        let _e621 = local_1[_e618];
                        let _e624 = (_e275 % 3u);
                        let _e625 = (_e624 < 3u);
                        if _e625 {
                        } else {
                            break;
                        }
                        let _e627 = local_1[_e624];
                        let _e630 = (_e277 % 3u);
                        let _e631 = (_e630 < 3u);
                        if _e631 {
                        } else {
                            break;
                        }
                        let _e633 = local_1[_e630];
                        if _e619 {
                        } else {
                            break;
                        }
                        let _e638 = local[_e618];
                        if _e625 {
                        } else {
                            break;
                        }
                        let _e642 = local[_e624];
                        if _e631 {
                        } else {
                            break;
                        }
                        let _e646 = local[_e630];
                        phi_4114_ = false;
                        phi_1183_ = type_46(type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e607), 0u, 0u);
                        phi_1186_ = (_e609 <= _e607);
                        phi_1188_ = ((3u * _e96) + 1u);
                        phi_1190_ = 0u;
                        phi_1192_ = type_53(type_38(vec4<f32>((f32(_e621) * _e150), (f32(_e627) * _e150), (f32(_e633) * _e150), 0f), vec4<f32>((f32(_e638) * _e150), (f32(_e642) * _e150), (f32(_e646) * _e150), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        loop {
                            let _e656 = phi_4114_;
                            let _e658 = phi_1183_;
                            let _e660 = phi_1186_;
                            let _e662 = phi_1188_;
                            let _e664 = phi_1190_;
                            let _e666 = phi_1192_;
                            local_10 = _e658;
                            local_11 = _e658;
                            if _e660 {
                                phi_1203_ = true;
                            } else {
                                phi_1203_ = (_e664 > 0u);
                            }
                            let _e669 = phi_1203_;
                            if _e669 {
                                let _e670 = (_e662 > 0u);
                                if _e670 {
                                    if _e660 {
                                        phi_1289_ = _e660;
                                        phi_1290_ = _e664;
                                        phi_1291_ = _e666;
                                    } else {
                                        let _e671 = (_e664 - 1u);
                                        let _e672 = (_e671 % 128u);
                                        let _e673 = (_e672 < 128u);
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e675 = local_7[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e677 = local_6[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e679 = local_5[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e681 = local_4[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e683 = local_3[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e685 = local_2[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e690 = local_8[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e693 = local_9[_e672];
                                        phi_1289_ = (_e693 <= _e658.member.member_1);
                                        phi_1290_ = _e671;
                                        phi_1291_ = type_53(type_38(vec4<f32>(_e675, _e677, _e679, 0f), vec4<f32>(_e681, _e683, _e685, 0f)), _e690);
                                    }
                                    let _e698 = phi_1289_;
                                    let _e700 = phi_1290_;
                                    let _e702 = phi_1291_;
                                    if _e698 {
                                        if ((_e702.member_1 & 2147483648u) != 0u) {
                                            phi_1309_ = _e658;
                                            phi_1312_ = type_7(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1159 = phi_1309_;
                                                let _e1161 = phi_1312_;
                                                local_12 = _e1159;
                                                if (_e1161.member < _e1161.member_1) {
                                                    phi_1313_ = type_7((_e1161.member + 1u), _e1161.member_1);
                                                    phi_1335_ = type_7(1u, _e1161.member);
                                                } else {
                                                    phi_1313_ = _e1161;
                                                    phi_1335_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1174 = phi_1313_;
                                                let _e1176 = phi_1335_;
                                                let _e1180 = (bitcast<i32>(_e1176.member) != 0i);
                                                if _e1180 {
                                                    let _e1186 = type_46(_e1159.member, _e1159.member_1, (_e1159.member_2 + 1u));
                                                    let _e1187 = ((_e702.member_1 & 268435455u) + _e1176.member_1);
                                                    let _e1188 = (_e1187 < _e98);
                                                    if _e1188 {
                                                        if _e1188 {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1192 = global_1.member[_e1187].member_1;
                                                        phi_1359_ = _e1192;
                                                    } else {
                                                        phi_1359_ = 4294967295u;
                                                    }
                                                    let _e1194 = phi_1359_;
                                                    if (_e1187 >= _e98) {
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1188 {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        if (_e618 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1201 = global_1.member[_e1187].member[_e618];
                                                        if (_e624 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1207 = global_1.member[_e1187].member[_e624];
                                                        if (_e630 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1213 = global_1.member[_e1187].member[_e630];
                                                        let _e1215 = (3u + _e618);
                                                        if (_e1215 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1221 = global_1.member[_e1187].member[_e1215];
                                                        let _e1222 = (3u + _e624);
                                                        if (_e1222 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1228 = global_1.member[_e1187].member[_e1222];
                                                        let _e1229 = (3u + _e630);
                                                        if (_e1229 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1235 = global_1.member[_e1187].member[_e1229];
                                                        let _e1237 = (6u + _e618);
                                                        if (_e1237 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1243 = global_1.member[_e1187].member[_e1237];
                                                        let _e1244 = (6u + _e624);
                                                        if (_e1244 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1250 = global_1.member[_e1187].member[_e1244];
                                                        let _e1251 = (6u + _e630);
                                                        if (_e1251 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1257 = global_1.member[_e1187].member[_e1251];
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1201, _e1207, _e1213), array<f32, 3>(_e1221, _e1228, _e1235), array<f32, 3>(_e1243, _e1250, _e1257));
                                                    }
                                                    let _e1261 = phi_1451_;
                                                    let _e1270 = (_e1261[0][2] - _e456);
                                                    let _e1273 = (((_e1261[0][0] - _e323) * _e495) - (_e1270 * _e363));
                                                    let _e1276 = (((_e1261[0][1] - _e390) * _e495) - (_e1270 * _e429));
                                                    let _e1283 = (_e1261[1][2] - _e456);
                                                    let _e1286 = (((_e1261[1][0] - _e323) * _e495) - (_e1283 * _e363));
                                                    let _e1289 = (((_e1261[1][1] - _e390) * _e495) - (_e1283 * _e429));
                                                    let _e1296 = (_e1261[2][2] - _e456);
                                                    let _e1299 = (((_e1261[2][0] - _e323) * _e495) - (_e1296 * _e363));
                                                    let _e1302 = (((_e1261[2][1] - _e390) * _e495) - (_e1296 * _e429));
                                                    let _e1303 = (_e1299 * _e1289);
                                                    let _e1304 = (_e1302 * _e1286);
                                                    let _e1305 = (_e1273 * _e1302);
                                                    let _e1306 = (_e1276 * _e1299);
                                                    let _e1307 = (_e1286 * _e1276);
                                                    let _e1308 = (_e1289 * _e1273);
                                                    let _e1313 = (((_e1303 >= _e1304) && (_e1305 >= _e1306)) && (_e1307 >= _e1308));
                                                    if (_e1313 || (((_e1303 <= _e1304) && (_e1305 <= _e1306)) && (_e1307 <= _e1308))) {
                                                        let _e1320 = select(-1f, 1f, _e1313);
                                                        let _e1322 = ((_e1303 - _e1304) * _e1320);
                                                        let _e1324 = select(0f, _e1322, (_e1322 > 0f));
                                                        let _e1326 = ((_e1305 - _e1306) * _e1320);
                                                        let _e1328 = select(0f, _e1326, (_e1326 > 0f));
                                                        let _e1330 = ((_e1307 - _e1308) * _e1320);
                                                        let _e1332 = select(0f, _e1330, (_e1330 > 0f));
                                                        let _e1334 = ((_e1324 + _e1328) + _e1332);
                                                        if (_e1334 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2335_ = type_26();
                                                            phi_2336_ = true;
                                                            phi_2337_ = false;
                                                        } else {
                                                            let _e1337 = select(_e1286, _e1273, (_e1273 < _e1286));
                                                            if (select(_e1299, _e1337, (_e1337 < _e1299)) > 0f) {
                                                                phi_1603_ = true;
                                                            } else {
                                                                let _e1342 = select(_e1286, _e1273, (_e1273 > _e1286));
                                                                phi_1603_ = (select(_e1299, _e1342, (_e1342 > _e1299)) < 0f);
                                                            }
                                                            let _e1347 = phi_1603_;
                                                            if _e1347 {
                                                                phi_2332_ = type_26();
                                                                phi_2333_ = true;
                                                                phi_2334_ = false;
                                                            } else {
                                                                let _e1349 = select(_e1289, _e1276, (_e1276 < _e1289));
                                                                if (select(_e1302, _e1349, (_e1349 < _e1302)) > 0f) {
                                                                    phi_1632_ = true;
                                                                } else {
                                                                    let _e1354 = select(_e1289, _e1276, (_e1276 > _e1289));
                                                                    phi_1632_ = (select(_e1302, _e1354, (_e1354 > _e1302)) < 0f);
                                                                }
                                                                let _e1359 = phi_1632_;
                                                                if _e1359 {
                                                                    phi_2330_ = type_26();
                                                                    phi_2331_ = false;
                                                                } else {
                                                                    let _e1361 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] < _e1261[1][0]));
                                                                    let _e1365 = select(_e1261[1][0], _e1261[0][0], (_e1261[0][0] > _e1261[1][0]));
                                                                    let _e1369 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] < _e1261[1][1]));
                                                                    let _e1373 = select(_e1261[1][1], _e1261[0][1], (_e1261[0][1] > _e1261[1][1]));
                                                                    let _e1377 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] < _e1261[1][2]));
                                                                    let _e1381 = select(_e1261[1][2], _e1261[0][2], (_e1261[0][2] > _e1261[1][2]));
                                                                    let _e1386 = ((select(_e1261[2][0], _e1361, (_e1361 < _e1261[2][0])) - _e361) * _e366);
                                                                    let _e1387 = ((select(_e1261[2][0], _e1365, (_e1365 > _e1261[2][0])) - _e362) * _e366);
                                                                    let _e1390 = ((select(_e1261[2][1], _e1369, (_e1369 < _e1261[2][1])) - _e427) * _e432);
                                                                    let _e1391 = ((select(_e1261[2][1], _e1373, (_e1373 > _e1261[2][1])) - _e428) * _e432);
                                                                    let _e1394 = ((select(_e1261[2][2], _e1377, (_e1377 < _e1261[2][2])) - _e493) * _e498);
                                                                    let _e1395 = ((select(_e1261[2][2], _e1381, (_e1381 > _e1261[2][2])) - _e494) * _e498);
                                                                    let _e1397 = select(_e1395, _e1394, (_e1394 < _e1395));
                                                                    let _e1399 = select(_e1395, _e1394, (_e1394 > _e1395));
                                                                    let _e1401 = select(_e1387, _e1386, (_e1386 < _e1387));
                                                                    let _e1403 = select(_e1391, _e1390, (_e1390 < _e1391));
                                                                    let _e1405 = select(_e1403, _e1401, (_e1401 > _e1403));
                                                                    let _e1407 = select(_e1397, _e1405, (_e1405 > _e1397));
                                                                    let _e1409 = select(_e1387, _e1386, (_e1386 > _e1387));
                                                                    let _e1411 = select(_e1391, _e1390, (_e1390 > _e1391));
                                                                    let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
                                                                    let _e1415 = select(_e1399, _e1413, (_e1413 < _e1399));
                                                                    let _e1416 = -(_e1397);
                                                                    let _e1422 = select(_e609, _e1407, (_e1407 > _e609));
                                                                    if (_e1422 > (_e1415 + (select(_e1416, _e1399, (_e1399 > _e1416)) * 0.0000019073523f))) {
                                                                        phi_2325_ = type_26();
                                                                        phi_2326_ = true;
                                                                    } else {
                                                                        let _e1424 = (_e1422 > _e1159.member.member_1);
                                                                        if _e1424 {
                                                                            phi_2324_ = type_26();
                                                                        } else {
                                                                            let _e1425 = vec3<f32>(_e1261[0][0], _e1261[0][1], _e1261[0][2]);
                                                                            let _e1426 = vec3<f32>(_e1261[1][0], _e1261[1][1], _e1261[1][2]);
                                                                            let _e1427 = vec3<f32>(_e1261[2][0], _e1261[2][1], _e1261[2][2]);
                                                                            let _e1428 = (_e1261[1][0] - _e1261[0][0]);
                                                                            let _e1429 = (_e1261[1][1] - _e1261[0][1]);
                                                                            let _e1430 = (_e1261[1][2] - _e1261[0][2]);
                                                                            let _e1431 = vec3<f32>(_e1428, _e1429, _e1430);
                                                                            let _e1432 = (_e1261[2][0] - _e1261[1][0]);
                                                                            let _e1433 = (_e1261[2][1] - _e1261[1][1]);
                                                                            let _e1434 = (_e1261[2][2] - _e1261[1][2]);
                                                                            let _e1435 = vec3<f32>(_e1432, _e1433, _e1434);
                                                                            let _e1436 = (_e1261[0][0] - _e1261[2][0]);
                                                                            let _e1437 = (_e1261[0][1] - _e1261[2][1]);
                                                                            let _e1438 = (_e1261[0][2] - _e1261[2][2]);
                                                                            let _e1439 = vec3<f32>(_e1436, _e1437, _e1438);
                                                                            let _e1442 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                            let _e1445 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                            let _e1447 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                                            let _e1450 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                            let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                                            let _e1455 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                            let _e1460 = select(_e1458, _e1455, (_e1455 > _e1458));
                                                                            let _e1463 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                            let _e1465 = select(_e1463, _e1460, (_e1460 > _e1463));
                                                                            let _e1468 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                            let _e1471 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                            let _e1473 = select(_e1471, _e1468, (_e1468 > _e1471));
                                                                            let _e1476 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                            let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                                            let _e1480 = select(_e1465, _e1452, (_e1452 > _e1465));
                                                                            let _e1482 = select(_e1478, _e1480, (_e1480 > _e1478));
                                                                            if (_e1452 == _e1482) {
                                                                                phi_2051_ = _e1289;
                                                                                phi_2052_ = _e1286;
                                                                                phi_2053_ = _e1276;
                                                                                phi_2054_ = _e1273;
                                                                                phi_2055_ = _e1425;
                                                                                phi_2056_ = _e1439;
                                                                                phi_2057_ = _e1435;
                                                                                phi_2058_ = _e1431;
                                                                            } else {
                                                                                let _e1484 = (_e1465 == _e1482);
                                                                                let _e1489 = vec3(_e1484);
                                                                                phi_2051_ = select(_e1276, _e1302, _e1484);
                                                                                phi_2052_ = select(_e1273, _e1299, _e1484);
                                                                                phi_2053_ = select(_e1302, _e1289, _e1484);
                                                                                phi_2054_ = select(_e1299, _e1286, _e1484);
                                                                                phi_2055_ = select(_e1427, _e1426, _e1489);
                                                                                phi_2056_ = select(_e1435, _e1431, _e1489);
                                                                                phi_2057_ = select(_e1431, _e1439, _e1489);
                                                                                phi_2058_ = select(_e1439, _e1435, _e1489);
                                                                            }
                                                                            let _e1495 = phi_2051_;
                                                                            let _e1497 = phi_2052_;
                                                                            let _e1499 = phi_2053_;
                                                                            let _e1501 = phi_2054_;
                                                                            let _e1503 = phi_2055_;
                                                                            let _e1505 = phi_2056_;
                                                                            let _e1507 = phi_2057_;
                                                                            let _e1509 = phi_2058_;
                                                                            let _e1516 = ((_e1507.y * _e1505.z) - (_e1505.y * _e1507.z));
                                                                            let _e1521 = ((_e1507.z * _e1505.x) - (_e1505.z * _e1507.x));
                                                                            let _e1524 = ((_e1507.x * _e1505.y) - (_e1505.x * _e1507.y));
                                                                            if (_e1324 >= _e1328) {
                                                                                phi_2095_ = select(true, false, (_e1324 >= _e1332));
                                                                            } else {
                                                                                phi_2095_ = true;
                                                                            }
                                                                            let _e1529 = phi_2095_;
                                                                            if _e1529 {
                                                                                phi_2104_ = select(_e1427, _e1426, vec3((_e1328 >= _e1332)));
                                                                            } else {
                                                                                phi_2104_ = _e1425;
                                                                            }
                                                                            let _e1534 = phi_2104_;
                                                                            let _e1545 = (((_e1516 * (_e1534.x - _e323)) + (_e1521 * (_e1534.y - _e390))) + (_e1524 * (_e1534.z - _e456)));
                                                                            let _e1550 = (((_e1516 * _e363) + (_e1521 * _e429)) + (_e1524 * _e495));
                                                                            let _e1551 = (_e1497 - _e1501);
                                                                            let _e1552 = (_e1495 - _e1499);
                                                                            let _e1560 = (-(((_e1501 * _e1551) + (_e1499 * _e1552))) / ((_e1551 * _e1551) + (_e1552 * _e1552)));
                                                                            let _e1562 = select(1f, _e1560, (_e1560 < 1f));
                                                                            let _e1564 = select(0f, _e1562, (_e1562 > 0f));
                                                                            let _e1577 = ((_e1503.x + (_e1509.x * _e1564)) - _e323);
                                                                            let _e1578 = ((_e1503.y + (_e1509.y * _e1564)) - _e390);
                                                                            let _e1579 = ((_e1503.z + (_e1509.z * _e1564)) - _e456);
                                                                            let _e1580 = (_e1579 / _e495);
                                                                            let _e1592 = bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u));
                                                                            let _e1595 = bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u));
                                                                            let _e1597 = select(_e1595, _e1592, (_e1592 > _e1595));
                                                                            let _e1600 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                                            let _e1602 = select(_e1600, _e1597, (_e1597 > _e1600));
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1516) & 2147483647u));
                                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1521) & 2147483647u));
                                                                            let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1524) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1516 * _e1577) + (_e1521 * _e1578)) + (_e1524 * _e1579)) - _e1545)) & 2147483647u)) <= ((0.0000009536743f * select(_e1482, _e1602, (_e1602 > _e1482))) * select(_e1616, _e1613, (_e1613 > _e1616)))) {
                                                                                let _e1626 = bitcast<f32>((bitcast<u32>(_e1507.x) & 2147483647u));
                                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1507.y) & 2147483647u));
                                                                                let _e1631 = select(_e1629, _e1626, (_e1626 > _e1629));
                                                                                let _e1634 = bitcast<f32>((bitcast<u32>(_e1507.z) & 2147483647u));
                                                                                let _e1640 = bitcast<f32>((bitcast<u32>(_e1505.x) & 2147483647u));
                                                                                let _e1643 = bitcast<f32>((bitcast<u32>(_e1505.y) & 2147483647u));
                                                                                let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                                let _e1648 = bitcast<f32>((bitcast<u32>(_e1505.z) & 2147483647u));
                                                                                let _e1652 = (bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)) > ((0.0000038146973f * select(_e1634, _e1631, (_e1631 > _e1634))) * select(_e1648, _e1645, (_e1645 > _e1648))));
                                                                                if _e1652 {
                                                                                    phi_2269_ = (_e1545 / _e1550);
                                                                                } else {
                                                                                    phi_2269_ = f32();
                                                                                }
                                                                                let _e1655 = phi_2269_;
                                                                                phi_2271_ = _e1655;
                                                                                phi_2272_ = select(true, false, _e1652);
                                                                            } else {
                                                                                phi_2271_ = f32();
                                                                                phi_2272_ = true;
                                                                            }
                                                                            let _e1658 = phi_2271_;
                                                                            let _e1660 = phi_2272_;
                                                                            if _e1660 {
                                                                                let _e1668 = (((_e1516 * (_e1577 - (_e363 * _e1580))) + (_e1521 * (_e1578 - (_e429 * _e1580)))) / _e1550);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1668) & 2147483647u)) <= _e1482) {
                                                                                    phi_2292_ = (_e1580 + _e1668);
                                                                                } else {
                                                                                    phi_2292_ = _e1580;
                                                                                }
                                                                                let _e1675 = phi_2292_;
                                                                                phi_2293_ = _e1675;
                                                                            } else {
                                                                                phi_2293_ = _e1658;
                                                                            }
                                                                            let _e1677 = phi_2293_;
                                                                            let _e1679 = select(_e1415, _e1677, (_e1677 < _e1415));
                                                                            let _e1681 = select(_e1407, _e1679, (_e1679 > _e1407));
                                                                            if (_e1681 >= _e609) {
                                                                                let _e1683 = (_e1681 <= _e1159.member.member_1);
                                                                                if _e1683 {
                                                                                    let _e1684 = (1f / _e1334);
                                                                                    phi_2316_ = type_26(_e1681, (_e1328 * _e1684), (_e1332 * _e1684), _e1194);
                                                                                } else {
                                                                                    phi_2316_ = type_26();
                                                                                }
                                                                                let _e1689 = phi_2316_;
                                                                                phi_2318_ = _e1689;
                                                                                phi_2319_ = select(true, false, _e1683);
                                                                            } else {
                                                                                phi_2318_ = type_26();
                                                                                phi_2319_ = true;
                                                                            }
                                                                            let _e1692 = phi_2318_;
                                                                            let _e1694 = phi_2319_;
                                                                            if _e1694 {
                                                                                phi_2323_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2323_ = _e1692;
                                                                            }
                                                                            let _e1696 = phi_2323_;
                                                                            phi_2324_ = _e1696;
                                                                        }
                                                                        let _e1698 = phi_2324_;
                                                                        phi_2325_ = _e1698;
                                                                        phi_2326_ = _e1424;
                                                                    }
                                                                    let _e1700 = phi_2325_;
                                                                    let _e1702 = phi_2326_;
                                                                    phi_2330_ = _e1700;
                                                                    phi_2331_ = _e1702;
                                                                }
                                                                let _e1704 = phi_2330_;
                                                                let _e1706 = phi_2331_;
                                                                phi_2332_ = _e1704;
                                                                phi_2333_ = _e1359;
                                                                phi_2334_ = _e1706;
                                                            }
                                                            let _e1708 = phi_2332_;
                                                            let _e1710 = phi_2333_;
                                                            let _e1712 = phi_2334_;
                                                            phi_2335_ = _e1708;
                                                            phi_2336_ = _e1710;
                                                            phi_2337_ = _e1712;
                                                        }
                                                        let _e1714 = phi_2335_;
                                                        let _e1716 = phi_2336_;
                                                        let _e1718 = phi_2337_;
                                                        phi_2345_ = _e1714;
                                                        phi_2346_ = select(_e1718, true, _e1716);
                                                    } else {
                                                        phi_2345_ = type_26();
                                                        phi_2346_ = true;
                                                    }
                                                    let _e1721 = phi_2345_;
                                                    let _e1723 = phi_2346_;
                                                    if _e1723 {
                                                        phi_2350_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2350_ = _e1721;
                                                    }
                                                    let _e1725 = phi_2350_;
                                                    if (_e1725.member_3 != 4294967295u) {
                                                        if (_e1194 != _e615) {
                                                            if (_e1725.member < _e1159.member.member.member) {
                                                                phi_2376_ = true;
                                                            } else {
                                                                if (_e1725.member == _e1159.member.member.member) {
                                                                    phi_2375_ = (_e1725.member_3 < _e1159.member.member.member_3);
                                                                } else {
                                                                    phi_2375_ = false;
                                                                }
                                                                let _e1740 = phi_2375_;
                                                                phi_2376_ = _e1740;
                                                            }
                                                            let _e1742 = phi_2376_;
                                                            if _e1742 {
                                                                phi_2383_ = type_46(type_43(_e1725, _e1725.member), _e1186.member_1, _e1186.member_2);
                                                            } else {
                                                                phi_2383_ = _e1186;
                                                            }
                                                            let _e1749 = phi_2383_;
                                                            phi_2384_ = _e1749;
                                                        } else {
                                                            phi_2384_ = _e1186;
                                                        }
                                                        let _e1751 = phi_2384_;
                                                        phi_2385_ = _e1751;
                                                    } else {
                                                        phi_2385_ = _e1186;
                                                    }
                                                    let _e1753 = phi_2385_;
                                                    phi_1310_ = _e1753;
                                                } else {
                                                    phi_1310_ = type_46();
                                                }
                                                let _e1755 = phi_1310_;
                                                continue;
                                                continuing {
                                                    phi_1309_ = _e1755;
                                                    phi_1312_ = _e1174;
                                                    phi_4108_ = _e656;
                                                    break if !(_e1180);
                                                }
                                            }
                                            let _e1758 = phi_4108_;
                                            phi_4268_ = _e1758;
                                            if _e1758 {
                                                break;
                                            }
                                            phi_4272_ = _e1758;
                                            let _e2093 = local_12;
                                            phi_3625_ = _e2093;
                                            phi_3626_ = false;
                                            phi_3627_ = _e700;
                                            phi_3628_ = _e702;
                                        } else {
                                            if (_e702.member_1 >= _e96) {
                                                phi_3156_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e702.member_1 < _e96) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e714 = ((1u + _e276) % 4u);
                                                if (_e714 < 4u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e719 = global_4.member[_e702.member_1][_e714];
                                                let _e721 = (_e719 >> bitcast<u32>(11u));
                                                let _e723 = ((1u + _e275) % 4u);
                                                if (_e723 < 4u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e728 = global_4.member[_e702.member_1][_e723];
                                                let _e730 = (_e728 >> bitcast<u32>(11u));
                                                let _e732 = ((1u + _e277) % 4u);
                                                if (_e732 < 4u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e737 = global_4.member[_e702.member_1][_e732];
                                                let _e739 = (_e737 >> bitcast<u32>(11u));
                                                let _e762 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e763 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e764 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e766 = select(_e150, _e762, (_e762 > _e150));
                                                let _e768 = select(_e150, _e763, (_e763 > _e150));
                                                let _e770 = select(_e150, _e764, (_e764 > _e150));
                                                let _e801 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e766));
                                                let _e806 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                                let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e768));
                                                let _e815 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                                let _e819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 1023u))) - 8388608f) * _e770));
                                                let _e824 = (bitcast<i32>((_e737 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e827 = bitcast<f32>((_e819 & bitcast<u32>(_e824)));
                                                let _e831 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                                let _e835 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                                let _e839 = bitcast<f32>((_e819 & bitcast<u32>(~(_e824))));
                                                let _e840 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e721 & 1023u))) - 8388608f) * _e766));
                                                let _e845 = (bitcast<i32>((_e721 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e848 = bitcast<f32>((_e840 & bitcast<u32>(_e845)));
                                                let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e730 & 1023u))) - 8388608f) * _e768));
                                                let _e854 = (bitcast<i32>((_e730 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                                let _e858 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e739 & 1023u))) - 8388608f) * _e770));
                                                let _e863 = (bitcast<i32>((_e739 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e866 = bitcast<f32>((_e858 & bitcast<u32>(_e863)));
                                                let _e870 = bitcast<f32>((_e840 & bitcast<u32>(~(_e845))));
                                                let _e874 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                                let _e878 = bitcast<f32>((_e858 & bitcast<u32>(~(_e863))));
                                                let _e908 = global_4.member[_e702.member_1][0u];
                                                let _e912 = global_4.member[_e702.member_1][1u];
                                                let _e916 = global_4.member[_e702.member_1][2u];
                                                let _e920 = global_4.member[_e702.member_1][3u];
                                                let _e932 = (((_e912 >> bitcast<u32>(22i)) | ((_e916 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e920 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e933 = (_e908 & 268435455u);
                                                let _e934 = (_e932 & 268435455u);
                                                let _e937 = ((_e908 >> bitcast<u32>(28u)) & 7u);
                                                let _e945 = ((_e908 >> bitcast<u32>(31i)) | (((_e932 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e946 = (_e937 != 0u);
                                                if (_e937 == 0u) {
                                                    phi_3118_ = _e933;
                                                } else {
                                                    if (_e937 == 7u) {
                                                        phi_3117_ = 2147483648u;
                                                    } else {
                                                        phi_3117_ = ((2147483648u | (_e937 << bitcast<u32>(28u))) | (_e934 & 268435455u));
                                                    }
                                                    let _e955 = phi_3117_;
                                                    phi_3118_ = _e955;
                                                }
                                                let _e957 = phi_3118_;
                                                if _e946 {
                                                    let _e958 = (_e937 != 7u);
                                                    if _e958 {
                                                        phi_3128_ = (_e934 + _e937);
                                                    } else {
                                                        phi_3128_ = u32();
                                                    }
                                                    let _e961 = phi_3128_;
                                                    phi_3130_ = _e961;
                                                    phi_3131_ = select(true, false, _e958);
                                                } else {
                                                    phi_3130_ = u32();
                                                    phi_3131_ = true;
                                                }
                                                let _e964 = phi_3130_;
                                                let _e966 = phi_3131_;
                                                if (_e945 == 0u) {
                                                    phi_3152_ = (_e933 + select(0u, 1u, !(_e946)));
                                                } else {
                                                    if (_e945 == 7u) {
                                                        phi_3151_ = 2147483648u;
                                                    } else {
                                                        phi_3151_ = ((2147483648u | (_e945 << bitcast<u32>(28u))) | (select(_e964, _e934, _e966) & 268435455u));
                                                    }
                                                    let _e979 = phi_3151_;
                                                    phi_3152_ = _e979;
                                                }
                                                let _e981 = phi_3152_;
                                                phi_3156_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e809), (_e702.member.member.x + _e831), (_e702.member.member_1.x - _e848), (_e702.member.member_1.x - _e870)), vec4<f32>((_e702.member.member.y + _e818), (_e702.member.member.y + _e835), (_e702.member.member_1.y - _e857), (_e702.member.member_1.y - _e874)), vec4<f32>((_e702.member.member.z + _e827), (_e702.member.member.z + _e839), (_e702.member.member_1.z - _e866), (_e702.member.member_1.z - _e878))), type_53(type_38((_e702.member.member + vec4<f32>(_e809, _e818, _e827, 0f)), (_e702.member.member_1 - vec4<f32>(_e848, _e857, _e866, 0f))), _e957), type_53(type_38((_e702.member.member + vec4<f32>(_e831, _e835, _e839, 0f)), (_e702.member.member_1 - vec4<f32>(_e870, _e874, _e878, 0f))), _e981));
                                            }
                                            let _e986 = phi_3156_;
                                            let _e1005 = ((_e986.member[0].x - _e361) * _e366);
                                            let _e1006 = ((_e986.member[0].y - _e361) * _e366);
                                            let _e1007 = ((_e986.member[0].z - _e362) * _e366);
                                            let _e1008 = ((_e986.member[0].w - _e362) * _e366);
                                            let _e1018 = ((_e986.member[1].x - _e427) * _e432);
                                            let _e1019 = ((_e986.member[1].y - _e427) * _e432);
                                            let _e1020 = ((_e986.member[1].z - _e428) * _e432);
                                            let _e1021 = ((_e986.member[1].w - _e428) * _e432);
                                            let _e1031 = ((_e986.member[2].x - _e493) * _e498);
                                            let _e1032 = ((_e986.member[2].y - _e493) * _e498);
                                            let _e1033 = ((_e986.member[2].z - _e494) * _e498);
                                            let _e1034 = ((_e986.member[2].w - _e494) * _e498);
                                            let _e1036 = select(_e1033, _e1031, (_e1031 < _e1033));
                                            let _e1038 = select(_e1034, _e1032, (_e1032 < _e1034));
                                            let _e1040 = select(_e1033, _e1031, (_e1031 > _e1033));
                                            let _e1042 = select(_e1034, _e1032, (_e1032 > _e1034));
                                            let _e1044 = select(_e1007, _e1005, (_e1005 < _e1007));
                                            let _e1046 = select(_e1008, _e1006, (_e1006 < _e1008));
                                            let _e1048 = select(_e1020, _e1018, (_e1018 < _e1020));
                                            let _e1050 = select(_e1021, _e1019, (_e1019 < _e1021));
                                            let _e1052 = select(_e1048, _e1044, (_e1044 > _e1048));
                                            let _e1054 = select(_e1050, _e1046, (_e1046 > _e1050));
                                            let _e1056 = select(_e1036, _e1052, (_e1052 > _e1036));
                                            let _e1058 = select(_e1038, _e1054, (_e1054 > _e1038));
                                            let _e1060 = select(_e1007, _e1005, (_e1005 > _e1007));
                                            let _e1062 = select(_e1008, _e1006, (_e1006 > _e1008));
                                            let _e1064 = select(_e1020, _e1018, (_e1018 > _e1020));
                                            let _e1066 = select(_e1021, _e1019, (_e1019 > _e1021));
                                            let _e1068 = select(_e1064, _e1060, (_e1060 < _e1064));
                                            let _e1070 = select(_e1066, _e1062, (_e1062 < _e1066));
                                            let _e1075 = -(_e1036);
                                            let _e1076 = -(_e1038);
                                            let _e1083 = (select(_e1040, _e1068, (_e1068 < _e1040)) + (select(_e1075, _e1040, (_e1040 > _e1075)) * 0.0000019073523f));
                                            let _e1084 = (select(_e1042, _e1070, (_e1070 < _e1042)) + (select(_e1076, _e1042, (_e1042 > _e1076)) * 0.0000019073523f));
                                            let _e1086 = select(_e609, _e1056, (_e1056 > _e609));
                                            let _e1088 = select(_e609, _e1058, (_e1058 > _e609));
                                            let _e1093 = (_e1086 <= select(_e658.member.member_1, _e1083, (_e1083 < _e658.member.member_1)));
                                            let _e1094 = (_e1088 <= select(_e658.member.member_1, _e1084, (_e1084 < _e658.member.member_1)));
                                            let _e1095 = (_e1086 <= _e1088);
                                            if _e1093 {
                                                if _e1094 {
                                                    if _e1095 {
                                                        phi_3521_ = _e986.member_2;
                                                    } else {
                                                        phi_3521_ = _e986.member_1;
                                                    }
                                                    let _e1099 = phi_3521_;
                                                    let _e1121 = (_e700 % 128u);
                                                    let _e1122 = (_e1121 < 128u);
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1121] = _e1099.member_1;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1121] = _e1099.member.member.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1121] = _e1099.member.member.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1121] = _e1099.member.member.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1121] = _e1099.member.member_1.x;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1121] = _e1099.member.member_1.y;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1121] = _e1099.member.member_1.z;
                                                    if _e1122 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1121] = select(_e1088, _e1086, !(_e1095));
                                                    if _e1095 {
                                                        phi_3598_ = _e986.member_1;
                                                    } else {
                                                        phi_3598_ = _e986.member_2;
                                                    }
                                                    let _e1135 = phi_3598_;
                                                    phi_3599_ = (_e700 + 1u);
                                                    phi_3600_ = _e1135;
                                                } else {
                                                    phi_3599_ = u32();
                                                    phi_3600_ = type_53();
                                                }
                                                let _e1137 = phi_3599_;
                                                let _e1139 = phi_3600_;
                                                phi_3602_ = _e1137;
                                                phi_3603_ = _e1139;
                                                phi_3604_ = select(true, false, _e1094);
                                            } else {
                                                phi_3602_ = u32();
                                                phi_3603_ = type_53();
                                                phi_3604_ = true;
                                            }
                                            let _e1142 = phi_3602_;
                                            let _e1144 = phi_3603_;
                                            let _e1146 = phi_3604_;
                                            if _e1146 {
                                                if _e1093 {
                                                    phi_3613_ = _e986.member_1;
                                                } else {
                                                    phi_3613_ = _e986.member_2;
                                                }
                                                let _e1150 = phi_3613_;
                                                phi_3618_ = select(_e1094, true, _e1093);
                                                phi_3620_ = _e1150;
                                            } else {
                                                phi_3618_ = _e698;
                                                phi_3620_ = _e1144;
                                            }
                                            let _e1153 = phi_3618_;
                                            let _e1155 = phi_3620_;
                                            phi_4272_ = _e656;
                                            phi_3625_ = type_46(_e658.member, (_e658.member_1 + 1u), _e658.member_2);
                                            phi_3626_ = _e1153;
                                            phi_3627_ = select(_e1142, _e700, _e1146);
                                            phi_3628_ = _e1155;
                                        }
                                        let _e1760 = phi_4272_;
                                        let _e1762 = phi_3625_;
                                        let _e1764 = phi_3626_;
                                        let _e1766 = phi_3627_;
                                        let _e1768 = phi_3628_;
                                        phi_4271_ = _e1760;
                                        phi_3629_ = _e1762;
                                        phi_3630_ = _e1764;
                                        phi_3631_ = (_e662 - 1u);
                                        phi_3632_ = _e1766;
                                        phi_3633_ = _e1768;
                                    } else {
                                        phi_4271_ = _e656;
                                        phi_3629_ = _e658;
                                        phi_3630_ = _e698;
                                        phi_3631_ = _e662;
                                        phi_3632_ = _e700;
                                        phi_3633_ = _e702;
                                    }
                                    let _e1770 = phi_4271_;
                                    let _e1772 = phi_3629_;
                                    let _e1774 = phi_3630_;
                                    let _e1776 = phi_3631_;
                                    let _e1778 = phi_3632_;
                                    let _e1780 = phi_3633_;
                                    phi_4270_ = _e1770;
                                    phi_3634_ = _e1772;
                                    phi_3635_ = _e1774;
                                    phi_3636_ = _e1776;
                                    phi_3637_ = _e1778;
                                    phi_3638_ = _e1780;
                                } else {
                                    phi_4270_ = _e656;
                                    phi_3634_ = type_46();
                                    phi_3635_ = bool();
                                    phi_3636_ = u32();
                                    phi_3637_ = u32();
                                    phi_3638_ = type_53();
                                }
                                let _e1782 = phi_4270_;
                                let _e1784 = phi_3634_;
                                let _e1786 = phi_3635_;
                                let _e1788 = phi_3636_;
                                let _e1790 = phi_3637_;
                                let _e1792 = phi_3638_;
                                phi_4269_ = _e1782;
                                phi_1184_ = _e1784;
                                phi_1187_ = _e1786;
                                phi_1189_ = _e1788;
                                phi_1191_ = _e1790;
                                phi_1193_ = _e1792;
                                phi_3639_ = _e670;
                            } else {
                                phi_4269_ = _e656;
                                phi_1184_ = type_46();
                                phi_1187_ = bool();
                                phi_1189_ = u32();
                                phi_1191_ = u32();
                                phi_1193_ = type_53();
                                phi_3639_ = false;
                            }
                            let _e1794 = phi_4269_;
                            let _e1796 = phi_1184_;
                            let _e1798 = phi_1187_;
                            let _e1800 = phi_1189_;
                            let _e1802 = phi_1191_;
                            let _e1804 = phi_1193_;
                            let _e1806 = phi_3639_;
                            continue;
                            continuing {
                                phi_4114_ = _e1794;
                                phi_1183_ = _e1796;
                                phi_1186_ = _e1798;
                                phi_1188_ = _e1800;
                                phi_1190_ = _e1802;
                                phi_1192_ = _e1804;
                                phi_4268_ = _e1794;
                                break if !(_e1806);
                            }
                        }
                        let _e1809 = phi_4268_;
                        if _e1809 {
                            break;
                        }
                        let _e1811 = local_10;
                        if (_e1811.member.member.member_3 != 4294967295u) {
                            let _e1817 = bitcast<u32>(_e1811.member.member.member);
                            let _e1821 = (bitcast<i32>((_e1817 >> bitcast<u32>(23i))) & 255i);
                            let _e1822 = (_e1821 + _e278);
                            if (_e1821 == 255i) {
                                phi_3698_ = _e1811.member.member.member;
                            } else {
                                if (_e1821 > 0i) {
                                    if (_e1822 > 0i) {
                                        let _e1826 = (_e1822 < 255i);
                                        if _e1826 {
                                            phi_3677_ = bitcast<f32>((_e1817 + bitcast<u32>((_e278 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3677_ = f32();
                                        }
                                        let _e1833 = phi_3677_;
                                        phi_3679_ = _e1833;
                                        phi_3680_ = select(true, false, _e1826);
                                    } else {
                                        phi_3679_ = f32();
                                        phi_3680_ = true;
                                    }
                                    let _e1836 = phi_3679_;
                                    let _e1838 = phi_3680_;
                                    phi_3681_ = _e1836;
                                    phi_3682_ = _e1838;
                                } else {
                                    phi_3681_ = f32();
                                    phi_3682_ = true;
                                }
                                let _e1840 = phi_3681_;
                                let _e1842 = phi_3682_;
                                if _e1842 {
                                    let _e1843 = (_e1817 & 2147483648u);
                                    let _e1850 = ((_e1817 & 8388607u) | (select(0u, 1u, ((_e1817 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1854 = (_e1850 == 0u);
                                    if _e1854 {
                                        phi_4066_ = bitcast<f32>(_e1843);
                                    } else {
                                        let _e1859 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1850)), 32u, _e1854) - 8u);
                                        let _e1862 = (_e1850 << bitcast<u32>((_e1859 & 31u)));
                                        let _e1864 = ((_e1822 + select(0i, 1i, (_e1821 == 0i))) - bitcast<i32>(_e1859));
                                        if (_e1864 >= 255i) {
                                            phi_4056_ = bitcast<f32>((_e1843 | 2139095040u));
                                            phi_4057_ = f32();
                                            phi_4058_ = true;
                                        } else {
                                            let _e1866 = (_e1864 > 0i);
                                            if _e1866 {
                                                phi_4050_ = bitcast<f32>(((_e1843 | (bitcast<u32>(_e1864) << bitcast<u32>(23i))) | (_e1862 & 8388607u)));
                                                phi_4051_ = f32();
                                            } else {
                                                if (_e1864 < -24i) {
                                                    phi_4016_ = 26u;
                                                } else {
                                                    phi_4016_ = bitcast<u32>((1i - _e1864));
                                                }
                                                let _e1871 = phi_4016_;
                                                let _e1872 = (_e1871 & 31u);
                                                let _e1874 = (_e1862 >> bitcast<u32>(_e1872));
                                                let _e1878 = (_e1862 & ((1u << bitcast<u32>(_e1872)) - 1u));
                                                let _e1882 = (1u << bitcast<u32>(((_e1871 - 1u) & 31u)));
                                                if (_e1878 > _e1882) {
                                                    phi_4037_ = true;
                                                } else {
                                                    if (_e1878 == _e1882) {
                                                        phi_4034_ = ((_e1874 & 1u) == 1u);
                                                    } else {
                                                        phi_4034_ = false;
                                                    }
                                                    let _e1888 = phi_4034_;
                                                    phi_4037_ = _e1888;
                                                }
                                                let _e1890 = phi_4037_;
                                                phi_4050_ = f32();
                                                phi_4051_ = bitcast<f32>((_e1843 | (_e1874 + select(0u, 1u, _e1890))));
                                            }
                                            let _e1903 = phi_4050_;
                                            let _e1905 = phi_4051_;
                                            phi_4056_ = _e1903;
                                            phi_4057_ = _e1905;
                                            phi_4058_ = _e1866;
                                        }
                                        let _e1909 = phi_4056_;
                                        let _e1911 = phi_4057_;
                                        let _e1913 = phi_4058_;
                                        phi_4066_ = select(_e1911, _e1909, _e1913);
                                    }
                                    let _e1917 = phi_4066_;
                                    phi_3697_ = _e1917;
                                } else {
                                    phi_3697_ = _e1840;
                                }
                                let _e1919 = phi_3697_;
                                phi_3698_ = _e1919;
                            }
                            let _e1921 = phi_3698_;
                            let _e1922 = bitcast<u32>(_e1921);
                            if ((_e1922 & 2147483647u) >= 2139095040u) {
                                phi_3710_ = bitcast<f32>(((_e1922 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3710_ = _e1921;
                            }
                            let _e1929 = phi_3710_;
                            phi_3715_ = type_26(_e1929, _e1811.member.member.member_1, _e1811.member.member.member_2, _e1811.member.member.member_3);
                        } else {
                            phi_3715_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1934 = phi_3715_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_2.member[_e138] = _e1934;
                        let _e1938 = local_11;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_6.member[_e138] = _e1938.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1943 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1943 > 0u) {
                            let _e1945 = (1u < _e106);
                            if _e1945 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1949 = atomicAdd((&global_7.member[0u]), _e1943);
                                if ((_e1949 + _e1943) < _e1949) {
                                    if _e1945 {
                                    } else {
                                        break;
                                    }
                                    let _e1954 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1957 = select(0u, 1u, (_e1934.member_3 != 4294967295u));
                        if (_e1957 > 0u) {
                            let _e1959 = (3u < _e106);
                            if _e1959 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1963 = atomicAdd((&global_7.member[2u]), _e1957);
                                if ((_e1963 + _e1957) < _e1963) {
                                    if _e1959 {
                                    } else {
                                        break;
                                    }
                                    let _e1968 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1938.member_1 > 0u) {
                            let _e1970 = (5u < _e106);
                            if _e1970 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1974 = atomicAdd((&global_7.member[4u]), _e1938.member_1);
                                if ((_e1974 + _e1938.member_1) < _e1974) {
                                    if _e1970 {
                                    } else {
                                        break;
                                    }
                                    let _e1979 = atomicAdd((&global_7.member[5u]), 1u);
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
fn trace_paths_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
