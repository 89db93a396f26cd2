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
    var phi_4120_: bool;
    var phi_1183_: type_46;
    var phi_1186_: u32;
    var phi_1188_: bool;
    var phi_1190_: u32;
    var phi_1192_: type_53;
    var phi_1203_: bool;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: type_53;
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
    var phi_4114_: bool;
    var phi_4360_: bool;
    var phi_2386_: type_46;
    var phi_3113_: u32;
    var phi_3114_: u32;
    var phi_3124_: u32;
    var phi_3126_: u32;
    var phi_3127_: bool;
    var phi_3147_: u32;
    var phi_3148_: u32;
    var phi_3152_: type_54;
    var phi_3517_: type_53;
    var phi_3593_: type_53;
    var phi_3594_: u32;
    var phi_3595_: type_53;
    var phi_3597_: u32;
    var phi_3598_: type_53;
    var phi_3599_: bool;
    var phi_3608_: type_53;
    var phi_3613_: bool;
    var phi_3615_: type_53;
    var phi_3620_: type_46;
    var phi_3621_: bool;
    var phi_3622_: u32;
    var phi_3623_: type_53;
    var phi_3631_: type_46;
    var phi_3634_: type_53;
    var phi_4277_: bool;
    var phi_3635_: type_46;
    var phi_3636_: u32;
    var phi_3637_: bool;
    var phi_3638_: u32;
    var phi_3639_: type_53;
    var phi_4276_: bool;
    var phi_3640_: type_46;
    var phi_3641_: u32;
    var phi_3642_: bool;
    var phi_3643_: u32;
    var phi_3644_: type_53;
    var phi_4275_: bool;
    var phi_1184_: type_46;
    var phi_1187_: u32;
    var phi_1189_: bool;
    var phi_1191_: u32;
    var phi_1193_: type_53;
    var phi_3645_: bool;
    var phi_4274_: bool;
    var local_10: type_46;
    var phi_3683_: f32;
    var phi_3685_: f32;
    var phi_3686_: bool;
    var phi_3687_: f32;
    var phi_3688_: bool;
    var phi_4022_: u32;
    var phi_4040_: bool;
    var phi_4043_: bool;
    var phi_4056_: f32;
    var phi_4057_: f32;
    var phi_4062_: f32;
    var phi_4063_: f32;
    var phi_4064_: bool;
    var phi_4072_: f32;
    var phi_3703_: f32;
    var phi_3704_: f32;
    var phi_3716_: f32;
    var phi_3721_: type_26;
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
                        phi_4120_ = false;
                        phi_1183_ = type_46(type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e607), 0u, 0u);
                        phi_1186_ = ((3u * _e96) + 1u);
                        phi_1188_ = (_e609 <= _e607);
                        phi_1190_ = 0u;
                        phi_1192_ = type_53(type_38(vec4<f32>((f32(_e621) * _e150), (f32(_e627) * _e150), (f32(_e633) * _e150), 0f), vec4<f32>((f32(_e638) * _e150), (f32(_e642) * _e150), (f32(_e646) * _e150), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        loop {
                            let _e656 = phi_4120_;
                            let _e658 = phi_1183_;
                            let _e660 = phi_1186_;
                            let _e662 = phi_1188_;
                            let _e664 = phi_1190_;
                            let _e666 = phi_1192_;
                            local_10 = _e658;
                            local_11 = _e658;
                            if _e662 {
                                phi_1203_ = true;
                            } else {
                                phi_1203_ = (_e664 > 0u);
                            }
                            let _e669 = phi_1203_;
                            if _e669 {
                                let _e670 = (_e660 > 0u);
                                if _e670 {
                                    if _e662 {
                                        phi_1289_ = _e662;
                                        phi_1290_ = _e664;
                                        phi_1291_ = _e666;
                                    } else {
                                        let _e671 = (_e664 - 1u);
                                        let _e672 = (_e671 % 128u);
                                        let _e673 = (_e672 < 128u);
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e675 = local_7[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e677 = local_6[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e679 = local_5[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e681 = local_4[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e683 = local_3[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e685 = local_2[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e690 = local_8[_e672];
                                        if _e673 {
                                        } else {
                                            phi_4274_ = true;
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
                                        let _e706 = ((_e702.member_1 & 2147483648u) != 0u);
                                        if _e706 {
                                            phi_1309_ = _e658;
                                            phi_1312_ = type_7(0u, ((_e702.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e713 = phi_1309_;
                                                let _e715 = phi_1312_;
                                                local_12 = _e713;
                                                if (_e715.member < _e715.member_1) {
                                                    phi_1313_ = type_7((_e715.member + 1u), _e715.member_1);
                                                    phi_1335_ = type_7(1u, _e715.member);
                                                } else {
                                                    phi_1313_ = _e715;
                                                    phi_1335_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e728 = phi_1313_;
                                                let _e730 = phi_1335_;
                                                let _e734 = (bitcast<i32>(_e730.member) != 0i);
                                                if _e734 {
                                                    let _e740 = type_46(_e713.member, _e713.member_1, (_e713.member_2 + 1u));
                                                    let _e741 = ((_e702.member_1 & 268435455u) + _e730.member_1);
                                                    let _e742 = (_e741 < _e98);
                                                    if _e742 {
                                                        if _e742 {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e746 = global_1.member[_e741].member_1;
                                                        phi_1359_ = _e746;
                                                    } else {
                                                        phi_1359_ = 4294967295u;
                                                    }
                                                    let _e748 = phi_1359_;
                                                    if (_e741 >= _e98) {
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e742 {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        if (_e618 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e755 = global_1.member[_e741].member[_e618];
                                                        if (_e624 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e761 = global_1.member[_e741].member[_e624];
                                                        if (_e630 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e767 = global_1.member[_e741].member[_e630];
                                                        let _e769 = (3u + _e618);
                                                        if (_e769 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e775 = global_1.member[_e741].member[_e769];
                                                        let _e776 = (3u + _e624);
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e782 = global_1.member[_e741].member[_e776];
                                                        let _e783 = (3u + _e630);
                                                        if (_e783 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e789 = global_1.member[_e741].member[_e783];
                                                        let _e791 = (6u + _e618);
                                                        if (_e791 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e797 = global_1.member[_e741].member[_e791];
                                                        let _e798 = (6u + _e624);
                                                        if (_e798 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e804 = global_1.member[_e741].member[_e798];
                                                        let _e805 = (6u + _e630);
                                                        if (_e805 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e811 = global_1.member[_e741].member[_e805];
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(_e755, _e761, _e767), array<f32, 3>(_e775, _e782, _e789), array<f32, 3>(_e797, _e804, _e811));
                                                    }
                                                    let _e815 = phi_1451_;
                                                    let _e824 = (_e815[0][2] - _e456);
                                                    let _e827 = (((_e815[0][0] - _e323) * _e495) - (_e824 * _e363));
                                                    let _e830 = (((_e815[0][1] - _e390) * _e495) - (_e824 * _e429));
                                                    let _e837 = (_e815[1][2] - _e456);
                                                    let _e840 = (((_e815[1][0] - _e323) * _e495) - (_e837 * _e363));
                                                    let _e843 = (((_e815[1][1] - _e390) * _e495) - (_e837 * _e429));
                                                    let _e850 = (_e815[2][2] - _e456);
                                                    let _e853 = (((_e815[2][0] - _e323) * _e495) - (_e850 * _e363));
                                                    let _e856 = (((_e815[2][1] - _e390) * _e495) - (_e850 * _e429));
                                                    let _e857 = (_e853 * _e843);
                                                    let _e858 = (_e856 * _e840);
                                                    let _e859 = (_e827 * _e856);
                                                    let _e860 = (_e830 * _e853);
                                                    let _e861 = (_e840 * _e830);
                                                    let _e862 = (_e843 * _e827);
                                                    let _e867 = (((_e857 >= _e858) && (_e859 >= _e860)) && (_e861 >= _e862));
                                                    if (_e867 || (((_e857 <= _e858) && (_e859 <= _e860)) && (_e861 <= _e862))) {
                                                        let _e874 = select(-1f, 1f, _e867);
                                                        let _e876 = ((_e857 - _e858) * _e874);
                                                        let _e878 = select(0f, _e876, (_e876 > 0f));
                                                        let _e880 = ((_e859 - _e860) * _e874);
                                                        let _e882 = select(0f, _e880, (_e880 > 0f));
                                                        let _e884 = ((_e861 - _e862) * _e874);
                                                        let _e886 = select(0f, _e884, (_e884 > 0f));
                                                        let _e888 = ((_e878 + _e882) + _e886);
                                                        if (_e888 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2335_ = type_26();
                                                            phi_2336_ = true;
                                                            phi_2337_ = false;
                                                        } else {
                                                            let _e891 = select(_e840, _e827, (_e827 < _e840));
                                                            if (select(_e853, _e891, (_e891 < _e853)) > 0f) {
                                                                phi_1603_ = true;
                                                            } else {
                                                                let _e896 = select(_e840, _e827, (_e827 > _e840));
                                                                phi_1603_ = (select(_e853, _e896, (_e896 > _e853)) < 0f);
                                                            }
                                                            let _e901 = phi_1603_;
                                                            if _e901 {
                                                                phi_2332_ = type_26();
                                                                phi_2333_ = true;
                                                                phi_2334_ = false;
                                                            } else {
                                                                let _e903 = select(_e843, _e830, (_e830 < _e843));
                                                                if (select(_e856, _e903, (_e903 < _e856)) > 0f) {
                                                                    phi_1632_ = true;
                                                                } else {
                                                                    let _e908 = select(_e843, _e830, (_e830 > _e843));
                                                                    phi_1632_ = (select(_e856, _e908, (_e908 > _e856)) < 0f);
                                                                }
                                                                let _e913 = phi_1632_;
                                                                if _e913 {
                                                                    phi_2330_ = type_26();
                                                                    phi_2331_ = false;
                                                                } else {
                                                                    let _e915 = select(_e815[1][0], _e815[0][0], (_e815[0][0] < _e815[1][0]));
                                                                    let _e919 = select(_e815[1][0], _e815[0][0], (_e815[0][0] > _e815[1][0]));
                                                                    let _e923 = select(_e815[1][1], _e815[0][1], (_e815[0][1] < _e815[1][1]));
                                                                    let _e927 = select(_e815[1][1], _e815[0][1], (_e815[0][1] > _e815[1][1]));
                                                                    let _e931 = select(_e815[1][2], _e815[0][2], (_e815[0][2] < _e815[1][2]));
                                                                    let _e935 = select(_e815[1][2], _e815[0][2], (_e815[0][2] > _e815[1][2]));
                                                                    let _e940 = ((select(_e815[2][0], _e915, (_e915 < _e815[2][0])) - _e361) * _e366);
                                                                    let _e941 = ((select(_e815[2][0], _e919, (_e919 > _e815[2][0])) - _e362) * _e366);
                                                                    let _e944 = ((select(_e815[2][1], _e923, (_e923 < _e815[2][1])) - _e427) * _e432);
                                                                    let _e945 = ((select(_e815[2][1], _e927, (_e927 > _e815[2][1])) - _e428) * _e432);
                                                                    let _e948 = ((select(_e815[2][2], _e931, (_e931 < _e815[2][2])) - _e493) * _e498);
                                                                    let _e949 = ((select(_e815[2][2], _e935, (_e935 > _e815[2][2])) - _e494) * _e498);
                                                                    let _e951 = select(_e949, _e948, (_e948 < _e949));
                                                                    let _e953 = select(_e949, _e948, (_e948 > _e949));
                                                                    let _e955 = select(_e941, _e940, (_e940 < _e941));
                                                                    let _e957 = select(_e945, _e944, (_e944 < _e945));
                                                                    let _e959 = select(_e957, _e955, (_e955 > _e957));
                                                                    let _e961 = select(_e951, _e959, (_e959 > _e951));
                                                                    let _e963 = select(_e941, _e940, (_e940 > _e941));
                                                                    let _e965 = select(_e945, _e944, (_e944 > _e945));
                                                                    let _e967 = select(_e965, _e963, (_e963 < _e965));
                                                                    let _e969 = select(_e953, _e967, (_e967 < _e953));
                                                                    let _e970 = -(_e951);
                                                                    let _e976 = select(_e609, _e961, (_e961 > _e609));
                                                                    if (_e976 > (_e969 + (select(_e970, _e953, (_e953 > _e970)) * 0.0000019073523f))) {
                                                                        phi_2325_ = type_26();
                                                                        phi_2326_ = true;
                                                                    } else {
                                                                        let _e978 = (_e976 > _e713.member.member_1);
                                                                        if _e978 {
                                                                            phi_2324_ = type_26();
                                                                        } else {
                                                                            let _e979 = vec3<f32>(_e815[0][0], _e815[0][1], _e815[0][2]);
                                                                            let _e980 = vec3<f32>(_e815[1][0], _e815[1][1], _e815[1][2]);
                                                                            let _e981 = vec3<f32>(_e815[2][0], _e815[2][1], _e815[2][2]);
                                                                            let _e982 = (_e815[1][0] - _e815[0][0]);
                                                                            let _e983 = (_e815[1][1] - _e815[0][1]);
                                                                            let _e984 = (_e815[1][2] - _e815[0][2]);
                                                                            let _e985 = vec3<f32>(_e982, _e983, _e984);
                                                                            let _e986 = (_e815[2][0] - _e815[1][0]);
                                                                            let _e987 = (_e815[2][1] - _e815[1][1]);
                                                                            let _e988 = (_e815[2][2] - _e815[1][2]);
                                                                            let _e989 = vec3<f32>(_e986, _e987, _e988);
                                                                            let _e990 = (_e815[0][0] - _e815[2][0]);
                                                                            let _e991 = (_e815[0][1] - _e815[2][1]);
                                                                            let _e992 = (_e815[0][2] - _e815[2][2]);
                                                                            let _e993 = vec3<f32>(_e990, _e991, _e992);
                                                                            let _e996 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                            let _e999 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                            let _e1001 = select(_e999, _e996, (_e996 > _e999));
                                                                            let _e1004 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                            let _e1006 = select(_e1004, _e1001, (_e1001 > _e1004));
                                                                            let _e1009 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                            let _e1012 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                            let _e1014 = select(_e1012, _e1009, (_e1009 > _e1012));
                                                                            let _e1017 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                            let _e1019 = select(_e1017, _e1014, (_e1014 > _e1017));
                                                                            let _e1022 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                            let _e1025 = bitcast<f32>((bitcast<u32>(_e991) & 2147483647u));
                                                                            let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                                            let _e1030 = bitcast<f32>((bitcast<u32>(_e992) & 2147483647u));
                                                                            let _e1032 = select(_e1030, _e1027, (_e1027 > _e1030));
                                                                            let _e1034 = select(_e1019, _e1006, (_e1006 > _e1019));
                                                                            let _e1036 = select(_e1032, _e1034, (_e1034 > _e1032));
                                                                            if (_e1006 == _e1036) {
                                                                                phi_2051_ = _e843;
                                                                                phi_2052_ = _e840;
                                                                                phi_2053_ = _e830;
                                                                                phi_2054_ = _e827;
                                                                                phi_2055_ = _e979;
                                                                                phi_2056_ = _e993;
                                                                                phi_2057_ = _e989;
                                                                                phi_2058_ = _e985;
                                                                            } else {
                                                                                let _e1038 = (_e1019 == _e1036);
                                                                                let _e1043 = vec3(_e1038);
                                                                                phi_2051_ = select(_e830, _e856, _e1038);
                                                                                phi_2052_ = select(_e827, _e853, _e1038);
                                                                                phi_2053_ = select(_e856, _e843, _e1038);
                                                                                phi_2054_ = select(_e853, _e840, _e1038);
                                                                                phi_2055_ = select(_e981, _e980, _e1043);
                                                                                phi_2056_ = select(_e989, _e985, _e1043);
                                                                                phi_2057_ = select(_e985, _e993, _e1043);
                                                                                phi_2058_ = select(_e993, _e989, _e1043);
                                                                            }
                                                                            let _e1049 = phi_2051_;
                                                                            let _e1051 = phi_2052_;
                                                                            let _e1053 = phi_2053_;
                                                                            let _e1055 = phi_2054_;
                                                                            let _e1057 = phi_2055_;
                                                                            let _e1059 = phi_2056_;
                                                                            let _e1061 = phi_2057_;
                                                                            let _e1063 = phi_2058_;
                                                                            let _e1070 = ((_e1061.y * _e1059.z) - (_e1059.y * _e1061.z));
                                                                            let _e1075 = ((_e1061.z * _e1059.x) - (_e1059.z * _e1061.x));
                                                                            let _e1078 = ((_e1061.x * _e1059.y) - (_e1059.x * _e1061.y));
                                                                            if (_e878 >= _e882) {
                                                                                phi_2095_ = select(true, false, (_e878 >= _e886));
                                                                            } else {
                                                                                phi_2095_ = true;
                                                                            }
                                                                            let _e1083 = phi_2095_;
                                                                            if _e1083 {
                                                                                phi_2104_ = select(_e981, _e980, vec3((_e882 >= _e886)));
                                                                            } else {
                                                                                phi_2104_ = _e979;
                                                                            }
                                                                            let _e1088 = phi_2104_;
                                                                            let _e1099 = (((_e1070 * (_e1088.x - _e323)) + (_e1075 * (_e1088.y - _e390))) + (_e1078 * (_e1088.z - _e456)));
                                                                            let _e1104 = (((_e1070 * _e363) + (_e1075 * _e429)) + (_e1078 * _e495));
                                                                            let _e1105 = (_e1051 - _e1055);
                                                                            let _e1106 = (_e1049 - _e1053);
                                                                            let _e1114 = (-(((_e1055 * _e1105) + (_e1053 * _e1106))) / ((_e1105 * _e1105) + (_e1106 * _e1106)));
                                                                            let _e1116 = select(1f, _e1114, (_e1114 < 1f));
                                                                            let _e1118 = select(0f, _e1116, (_e1116 > 0f));
                                                                            let _e1131 = ((_e1057.x + (_e1063.x * _e1118)) - _e323);
                                                                            let _e1132 = ((_e1057.y + (_e1063.y * _e1118)) - _e390);
                                                                            let _e1133 = ((_e1057.z + (_e1063.z * _e1118)) - _e456);
                                                                            let _e1134 = (_e1133 / _e495);
                                                                            let _e1146 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                            let _e1149 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                            let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                            let _e1154 = bitcast<f32>((bitcast<u32>(_e1133) & 2147483647u));
                                                                            let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                            let _e1162 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                            let _e1165 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                            let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                            let _e1170 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1070 * _e1131) + (_e1075 * _e1132)) + (_e1078 * _e1133)) - _e1099)) & 2147483647u)) <= ((0.0000009536743f * select(_e1036, _e1156, (_e1156 > _e1036))) * select(_e1170, _e1167, (_e1167 > _e1170)))) {
                                                                                let _e1180 = bitcast<f32>((bitcast<u32>(_e1061.x) & 2147483647u));
                                                                                let _e1183 = bitcast<f32>((bitcast<u32>(_e1061.y) & 2147483647u));
                                                                                let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                                let _e1188 = bitcast<f32>((bitcast<u32>(_e1061.z) & 2147483647u));
                                                                                let _e1194 = bitcast<f32>((bitcast<u32>(_e1059.x) & 2147483647u));
                                                                                let _e1197 = bitcast<f32>((bitcast<u32>(_e1059.y) & 2147483647u));
                                                                                let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                                                let _e1202 = bitcast<f32>((bitcast<u32>(_e1059.z) & 2147483647u));
                                                                                let _e1206 = (bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u)) > ((0.0000038146973f * select(_e1188, _e1185, (_e1185 > _e1188))) * select(_e1202, _e1199, (_e1199 > _e1202))));
                                                                                if _e1206 {
                                                                                    phi_2269_ = (_e1099 / _e1104);
                                                                                } else {
                                                                                    phi_2269_ = f32();
                                                                                }
                                                                                let _e1209 = phi_2269_;
                                                                                phi_2271_ = _e1209;
                                                                                phi_2272_ = select(true, false, _e1206);
                                                                            } else {
                                                                                phi_2271_ = f32();
                                                                                phi_2272_ = true;
                                                                            }
                                                                            let _e1212 = phi_2271_;
                                                                            let _e1214 = phi_2272_;
                                                                            if _e1214 {
                                                                                let _e1222 = (((_e1070 * (_e1131 - (_e363 * _e1134))) + (_e1075 * (_e1132 - (_e429 * _e1134)))) / _e1104);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u)) <= _e1036) {
                                                                                    phi_2292_ = (_e1134 + _e1222);
                                                                                } else {
                                                                                    phi_2292_ = _e1134;
                                                                                }
                                                                                let _e1229 = phi_2292_;
                                                                                phi_2293_ = _e1229;
                                                                            } else {
                                                                                phi_2293_ = _e1212;
                                                                            }
                                                                            let _e1231 = phi_2293_;
                                                                            let _e1233 = select(_e969, _e1231, (_e1231 < _e969));
                                                                            let _e1235 = select(_e961, _e1233, (_e1233 > _e961));
                                                                            if (_e1235 >= _e609) {
                                                                                let _e1237 = (_e1235 <= _e713.member.member_1);
                                                                                if _e1237 {
                                                                                    let _e1238 = (1f / _e888);
                                                                                    phi_2316_ = type_26(_e1235, (_e882 * _e1238), (_e886 * _e1238), _e748);
                                                                                } else {
                                                                                    phi_2316_ = type_26();
                                                                                }
                                                                                let _e1243 = phi_2316_;
                                                                                phi_2318_ = _e1243;
                                                                                phi_2319_ = select(true, false, _e1237);
                                                                            } else {
                                                                                phi_2318_ = type_26();
                                                                                phi_2319_ = true;
                                                                            }
                                                                            let _e1246 = phi_2318_;
                                                                            let _e1248 = phi_2319_;
                                                                            if _e1248 {
                                                                                phi_2323_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2323_ = _e1246;
                                                                            }
                                                                            let _e1250 = phi_2323_;
                                                                            phi_2324_ = _e1250;
                                                                        }
                                                                        let _e1252 = phi_2324_;
                                                                        phi_2325_ = _e1252;
                                                                        phi_2326_ = _e978;
                                                                    }
                                                                    let _e1254 = phi_2325_;
                                                                    let _e1256 = phi_2326_;
                                                                    phi_2330_ = _e1254;
                                                                    phi_2331_ = _e1256;
                                                                }
                                                                let _e1258 = phi_2330_;
                                                                let _e1260 = phi_2331_;
                                                                phi_2332_ = _e1258;
                                                                phi_2333_ = _e913;
                                                                phi_2334_ = _e1260;
                                                            }
                                                            let _e1262 = phi_2332_;
                                                            let _e1264 = phi_2333_;
                                                            let _e1266 = phi_2334_;
                                                            phi_2335_ = _e1262;
                                                            phi_2336_ = _e1264;
                                                            phi_2337_ = _e1266;
                                                        }
                                                        let _e1268 = phi_2335_;
                                                        let _e1270 = phi_2336_;
                                                        let _e1272 = phi_2337_;
                                                        phi_2345_ = _e1268;
                                                        phi_2346_ = select(_e1272, true, _e1270);
                                                    } else {
                                                        phi_2345_ = type_26();
                                                        phi_2346_ = true;
                                                    }
                                                    let _e1275 = phi_2345_;
                                                    let _e1277 = phi_2346_;
                                                    if _e1277 {
                                                        phi_2350_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2350_ = _e1275;
                                                    }
                                                    let _e1279 = phi_2350_;
                                                    if (_e1279.member_3 != 4294967295u) {
                                                        if (_e748 != _e615) {
                                                            if (_e1279.member < _e713.member.member.member) {
                                                                phi_2376_ = true;
                                                            } else {
                                                                if (_e1279.member == _e713.member.member.member) {
                                                                    phi_2375_ = (_e1279.member_3 < _e713.member.member.member_3);
                                                                } else {
                                                                    phi_2375_ = false;
                                                                }
                                                                let _e1294 = phi_2375_;
                                                                phi_2376_ = _e1294;
                                                            }
                                                            let _e1296 = phi_2376_;
                                                            if _e1296 {
                                                                phi_2383_ = type_46(type_43(_e1279, _e1279.member), _e740.member_1, _e740.member_2);
                                                            } else {
                                                                phi_2383_ = _e740;
                                                            }
                                                            let _e1303 = phi_2383_;
                                                            phi_2384_ = _e1303;
                                                        } else {
                                                            phi_2384_ = _e740;
                                                        }
                                                        let _e1305 = phi_2384_;
                                                        phi_2385_ = _e1305;
                                                    } else {
                                                        phi_2385_ = _e740;
                                                    }
                                                    let _e1307 = phi_2385_;
                                                    phi_1310_ = _e1307;
                                                } else {
                                                    phi_1310_ = type_46();
                                                }
                                                let _e1309 = phi_1310_;
                                                continue;
                                                continuing {
                                                    phi_1309_ = _e1309;
                                                    phi_1312_ = _e728;
                                                    phi_4114_ = _e656;
                                                    break if !(_e734);
                                                }
                                            }
                                            let _e1312 = phi_4114_;
                                            phi_4274_ = _e1312;
                                            if _e1312 {
                                                break;
                                            }
                                            phi_4360_ = _e1312;
                                            let _e2082 = local_12;
                                            phi_2386_ = _e2082;
                                        } else {
                                            phi_4360_ = _e656;
                                            phi_2386_ = _e658;
                                        }
                                        let _e1314 = phi_4360_;
                                        let _e1316 = phi_2386_;
                                        if _e706 {
                                            phi_3620_ = type_46();
                                            phi_3621_ = bool();
                                            phi_3622_ = u32();
                                            phi_3623_ = type_53();
                                        } else {
                                            if (_e702.member_1 >= _e96) {
                                                phi_3152_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e702.member_1 < _e96) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1320 = ((1u + _e276) % 4u);
                                                if (_e1320 < 4u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1325 = global_4.member[_e702.member_1][_e1320];
                                                let _e1327 = (_e1325 >> bitcast<u32>(11u));
                                                let _e1329 = ((1u + _e275) % 4u);
                                                if (_e1329 < 4u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1334 = global_4.member[_e702.member_1][_e1329];
                                                let _e1336 = (_e1334 >> bitcast<u32>(11u));
                                                let _e1338 = ((1u + _e277) % 4u);
                                                if (_e1338 < 4u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1343 = global_4.member[_e702.member_1][_e1338];
                                                let _e1345 = (_e1343 >> bitcast<u32>(11u));
                                                let _e1368 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.x - _e702.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1369 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.y - _e702.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1370 = (bitcast<f32>((bitcast<u32>((_e702.member.member_1.z - _e702.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1372 = select(_e150, _e1368, (_e1368 > _e150));
                                                let _e1374 = select(_e150, _e1369, (_e1369 > _e150));
                                                let _e1376 = select(_e150, _e1370, (_e1370 > _e150));
                                                let _e1407 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1325 & 1023u))) - 8388608f) * _e1372));
                                                let _e1412 = (bitcast<i32>((_e1325 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1415 = bitcast<f32>((_e1407 & bitcast<u32>(_e1412)));
                                                let _e1416 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1334 & 1023u))) - 8388608f) * _e1374));
                                                let _e1421 = (bitcast<i32>((_e1334 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1424 = bitcast<f32>((_e1416 & bitcast<u32>(_e1421)));
                                                let _e1425 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1343 & 1023u))) - 8388608f) * _e1376));
                                                let _e1430 = (bitcast<i32>((_e1343 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1433 = bitcast<f32>((_e1425 & bitcast<u32>(_e1430)));
                                                let _e1437 = bitcast<f32>((_e1407 & bitcast<u32>(~(_e1412))));
                                                let _e1441 = bitcast<f32>((_e1416 & bitcast<u32>(~(_e1421))));
                                                let _e1445 = bitcast<f32>((_e1425 & bitcast<u32>(~(_e1430))));
                                                let _e1446 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1327 & 1023u))) - 8388608f) * _e1372));
                                                let _e1451 = (bitcast<i32>((_e1327 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1454 = bitcast<f32>((_e1446 & bitcast<u32>(_e1451)));
                                                let _e1455 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1336 & 1023u))) - 8388608f) * _e1374));
                                                let _e1460 = (bitcast<i32>((_e1336 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1463 = bitcast<f32>((_e1455 & bitcast<u32>(_e1460)));
                                                let _e1464 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1345 & 1023u))) - 8388608f) * _e1376));
                                                let _e1469 = (bitcast<i32>((_e1345 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1472 = bitcast<f32>((_e1464 & bitcast<u32>(_e1469)));
                                                let _e1476 = bitcast<f32>((_e1446 & bitcast<u32>(~(_e1451))));
                                                let _e1480 = bitcast<f32>((_e1455 & bitcast<u32>(~(_e1460))));
                                                let _e1484 = bitcast<f32>((_e1464 & bitcast<u32>(~(_e1469))));
                                                let _e1514 = global_4.member[_e702.member_1][0u];
                                                let _e1518 = global_4.member[_e702.member_1][1u];
                                                let _e1522 = global_4.member[_e702.member_1][2u];
                                                let _e1526 = global_4.member[_e702.member_1][3u];
                                                let _e1538 = (((_e1518 >> bitcast<u32>(22i)) | ((_e1522 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1526 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1539 = (_e1514 & 268435455u);
                                                let _e1540 = (_e1538 & 268435455u);
                                                let _e1543 = ((_e1514 >> bitcast<u32>(28u)) & 7u);
                                                let _e1551 = ((_e1514 >> bitcast<u32>(31i)) | (((_e1538 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1552 = (_e1543 != 0u);
                                                if (_e1543 == 0u) {
                                                    phi_3114_ = _e1539;
                                                } else {
                                                    if (_e1543 == 7u) {
                                                        phi_3113_ = 2147483648u;
                                                    } else {
                                                        phi_3113_ = ((2147483648u | (_e1543 << bitcast<u32>(28u))) | (_e1540 & 268435455u));
                                                    }
                                                    let _e1561 = phi_3113_;
                                                    phi_3114_ = _e1561;
                                                }
                                                let _e1563 = phi_3114_;
                                                if _e1552 {
                                                    let _e1564 = (_e1543 != 7u);
                                                    if _e1564 {
                                                        phi_3124_ = (_e1540 + _e1543);
                                                    } else {
                                                        phi_3124_ = u32();
                                                    }
                                                    let _e1567 = phi_3124_;
                                                    phi_3126_ = _e1567;
                                                    phi_3127_ = select(true, false, _e1564);
                                                } else {
                                                    phi_3126_ = u32();
                                                    phi_3127_ = true;
                                                }
                                                let _e1570 = phi_3126_;
                                                let _e1572 = phi_3127_;
                                                if (_e1551 == 0u) {
                                                    phi_3148_ = (_e1539 + select(0u, 1u, !(_e1552)));
                                                } else {
                                                    if (_e1551 == 7u) {
                                                        phi_3147_ = 2147483648u;
                                                    } else {
                                                        phi_3147_ = ((2147483648u | (_e1551 << bitcast<u32>(28u))) | (select(_e1570, _e1540, _e1572) & 268435455u));
                                                    }
                                                    let _e1585 = phi_3147_;
                                                    phi_3148_ = _e1585;
                                                }
                                                let _e1587 = phi_3148_;
                                                phi_3152_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e702.member.member.x + _e1415), (_e702.member.member.x + _e1437), (_e702.member.member_1.x - _e1454), (_e702.member.member_1.x - _e1476)), vec4<f32>((_e702.member.member.y + _e1424), (_e702.member.member.y + _e1441), (_e702.member.member_1.y - _e1463), (_e702.member.member_1.y - _e1480)), vec4<f32>((_e702.member.member.z + _e1433), (_e702.member.member.z + _e1445), (_e702.member.member_1.z - _e1472), (_e702.member.member_1.z - _e1484))), type_53(type_38((_e702.member.member + vec4<f32>(_e1415, _e1424, _e1433, 0f)), (_e702.member.member_1 - vec4<f32>(_e1454, _e1463, _e1472, 0f))), _e1563), type_53(type_38((_e702.member.member + vec4<f32>(_e1437, _e1441, _e1445, 0f)), (_e702.member.member_1 - vec4<f32>(_e1476, _e1480, _e1484, 0f))), _e1587));
                                            }
                                            let _e1592 = phi_3152_;
                                            let _e1611 = ((_e1592.member[0].x - _e361) * _e366);
                                            let _e1612 = ((_e1592.member[0].y - _e361) * _e366);
                                            let _e1613 = ((_e1592.member[0].z - _e362) * _e366);
                                            let _e1614 = ((_e1592.member[0].w - _e362) * _e366);
                                            let _e1624 = ((_e1592.member[1].x - _e427) * _e432);
                                            let _e1625 = ((_e1592.member[1].y - _e427) * _e432);
                                            let _e1626 = ((_e1592.member[1].z - _e428) * _e432);
                                            let _e1627 = ((_e1592.member[1].w - _e428) * _e432);
                                            let _e1637 = ((_e1592.member[2].x - _e493) * _e498);
                                            let _e1638 = ((_e1592.member[2].y - _e493) * _e498);
                                            let _e1639 = ((_e1592.member[2].z - _e494) * _e498);
                                            let _e1640 = ((_e1592.member[2].w - _e494) * _e498);
                                            let _e1642 = select(_e1639, _e1637, (_e1637 < _e1639));
                                            let _e1644 = select(_e1640, _e1638, (_e1638 < _e1640));
                                            let _e1646 = select(_e1639, _e1637, (_e1637 > _e1639));
                                            let _e1648 = select(_e1640, _e1638, (_e1638 > _e1640));
                                            let _e1650 = select(_e1613, _e1611, (_e1611 < _e1613));
                                            let _e1652 = select(_e1614, _e1612, (_e1612 < _e1614));
                                            let _e1654 = select(_e1626, _e1624, (_e1624 < _e1626));
                                            let _e1656 = select(_e1627, _e1625, (_e1625 < _e1627));
                                            let _e1658 = select(_e1654, _e1650, (_e1650 > _e1654));
                                            let _e1660 = select(_e1656, _e1652, (_e1652 > _e1656));
                                            let _e1662 = select(_e1642, _e1658, (_e1658 > _e1642));
                                            let _e1664 = select(_e1644, _e1660, (_e1660 > _e1644));
                                            let _e1666 = select(_e1613, _e1611, (_e1611 > _e1613));
                                            let _e1668 = select(_e1614, _e1612, (_e1612 > _e1614));
                                            let _e1670 = select(_e1626, _e1624, (_e1624 > _e1626));
                                            let _e1672 = select(_e1627, _e1625, (_e1625 > _e1627));
                                            let _e1674 = select(_e1670, _e1666, (_e1666 < _e1670));
                                            let _e1676 = select(_e1672, _e1668, (_e1668 < _e1672));
                                            let _e1681 = -(_e1642);
                                            let _e1682 = -(_e1644);
                                            let _e1689 = (select(_e1646, _e1674, (_e1674 < _e1646)) + (select(_e1681, _e1646, (_e1646 > _e1681)) * 0.0000019073523f));
                                            let _e1690 = (select(_e1648, _e1676, (_e1676 < _e1648)) + (select(_e1682, _e1648, (_e1648 > _e1682)) * 0.0000019073523f));
                                            let _e1692 = select(_e609, _e1662, (_e1662 > _e609));
                                            let _e1694 = select(_e609, _e1664, (_e1664 > _e609));
                                            let _e1699 = (_e1692 <= select(_e1316.member.member_1, _e1689, (_e1689 < _e1316.member.member_1)));
                                            let _e1700 = (_e1694 <= select(_e1316.member.member_1, _e1690, (_e1690 < _e1316.member.member_1)));
                                            let _e1701 = (_e1692 <= _e1694);
                                            if _e1699 {
                                                if _e1700 {
                                                    if _e1701 {
                                                        phi_3517_ = _e1592.member_2;
                                                    } else {
                                                        phi_3517_ = _e1592.member_1;
                                                    }
                                                    let _e1705 = phi_3517_;
                                                    let _e1726 = (_e700 % 128u);
                                                    let _e1727 = (_e1726 < 128u);
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1726] = _e1705.member_1;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1726] = _e1705.member.member.x;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1726] = _e1705.member.member.y;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1726] = _e1705.member.member.z;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1726] = _e1705.member.member_1.x;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1726] = _e1705.member.member_1.y;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1726] = _e1705.member.member_1.z;
                                                    if _e1727 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1726] = select(_e1692, _e1694, _e1701);
                                                    if _e1701 {
                                                        phi_3593_ = _e1592.member_1;
                                                    } else {
                                                        phi_3593_ = _e1592.member_2;
                                                    }
                                                    let _e1740 = phi_3593_;
                                                    phi_3594_ = (_e700 + 1u);
                                                    phi_3595_ = _e1740;
                                                } else {
                                                    phi_3594_ = u32();
                                                    phi_3595_ = type_53();
                                                }
                                                let _e1742 = phi_3594_;
                                                let _e1744 = phi_3595_;
                                                phi_3597_ = _e1742;
                                                phi_3598_ = _e1744;
                                                phi_3599_ = select(true, false, _e1700);
                                            } else {
                                                phi_3597_ = u32();
                                                phi_3598_ = type_53();
                                                phi_3599_ = true;
                                            }
                                            let _e1747 = phi_3597_;
                                            let _e1749 = phi_3598_;
                                            let _e1751 = phi_3599_;
                                            if _e1751 {
                                                if _e1699 {
                                                    phi_3608_ = _e1592.member_1;
                                                } else {
                                                    phi_3608_ = _e1592.member_2;
                                                }
                                                let _e1755 = phi_3608_;
                                                phi_3613_ = select(_e1700, true, _e1699);
                                                phi_3615_ = _e1755;
                                            } else {
                                                phi_3613_ = _e698;
                                                phi_3615_ = _e1749;
                                            }
                                            let _e1758 = phi_3613_;
                                            let _e1760 = phi_3615_;
                                            phi_3620_ = type_46(_e1316.member, (_e1316.member_1 + 1u), _e1316.member_2);
                                            phi_3621_ = _e1758;
                                            phi_3622_ = select(_e1747, _e700, _e1751);
                                            phi_3623_ = _e1760;
                                        }
                                        let _e1763 = phi_3620_;
                                        let _e1765 = phi_3621_;
                                        let _e1767 = phi_3622_;
                                        let _e1769 = phi_3623_;
                                        if _e706 {
                                            phi_3631_ = _e1316;
                                            phi_3634_ = _e702;
                                        } else {
                                            phi_3631_ = _e1763;
                                            phi_3634_ = _e1769;
                                        }
                                        let _e1771 = phi_3631_;
                                        let _e1773 = phi_3634_;
                                        phi_4277_ = _e1314;
                                        phi_3635_ = _e1771;
                                        phi_3636_ = (_e660 - 1u);
                                        phi_3637_ = select(_e1765, false, _e706);
                                        phi_3638_ = select(_e1767, _e700, _e706);
                                        phi_3639_ = _e1773;
                                    } else {
                                        phi_4277_ = _e656;
                                        phi_3635_ = _e658;
                                        phi_3636_ = _e660;
                                        phi_3637_ = _e698;
                                        phi_3638_ = _e700;
                                        phi_3639_ = _e702;
                                    }
                                    let _e1777 = phi_4277_;
                                    let _e1779 = phi_3635_;
                                    let _e1781 = phi_3636_;
                                    let _e1783 = phi_3637_;
                                    let _e1785 = phi_3638_;
                                    let _e1787 = phi_3639_;
                                    phi_4276_ = _e1777;
                                    phi_3640_ = _e1779;
                                    phi_3641_ = _e1781;
                                    phi_3642_ = _e1783;
                                    phi_3643_ = _e1785;
                                    phi_3644_ = _e1787;
                                } else {
                                    phi_4276_ = _e656;
                                    phi_3640_ = type_46();
                                    phi_3641_ = u32();
                                    phi_3642_ = bool();
                                    phi_3643_ = u32();
                                    phi_3644_ = type_53();
                                }
                                let _e1789 = phi_4276_;
                                let _e1791 = phi_3640_;
                                let _e1793 = phi_3641_;
                                let _e1795 = phi_3642_;
                                let _e1797 = phi_3643_;
                                let _e1799 = phi_3644_;
                                phi_4275_ = _e1789;
                                phi_1184_ = _e1791;
                                phi_1187_ = _e1793;
                                phi_1189_ = _e1795;
                                phi_1191_ = _e1797;
                                phi_1193_ = _e1799;
                                phi_3645_ = _e670;
                            } else {
                                phi_4275_ = _e656;
                                phi_1184_ = type_46();
                                phi_1187_ = u32();
                                phi_1189_ = bool();
                                phi_1191_ = u32();
                                phi_1193_ = type_53();
                                phi_3645_ = false;
                            }
                            let _e1801 = phi_4275_;
                            let _e1803 = phi_1184_;
                            let _e1805 = phi_1187_;
                            let _e1807 = phi_1189_;
                            let _e1809 = phi_1191_;
                            let _e1811 = phi_1193_;
                            let _e1813 = phi_3645_;
                            continue;
                            continuing {
                                phi_4120_ = _e1801;
                                phi_1183_ = _e1803;
                                phi_1186_ = _e1805;
                                phi_1188_ = _e1807;
                                phi_1190_ = _e1809;
                                phi_1192_ = _e1811;
                                phi_4274_ = _e1801;
                                break if !(_e1813);
                            }
                        }
                        let _e1816 = phi_4274_;
                        if _e1816 {
                            break;
                        }
                        let _e1818 = local_10;
                        if (_e1818.member.member.member_3 != 4294967295u) {
                            let _e1824 = bitcast<u32>(_e1818.member.member.member);
                            let _e1828 = (bitcast<i32>((_e1824 >> bitcast<u32>(23i))) & 255i);
                            let _e1829 = (_e1828 + _e278);
                            if (_e1828 == 255i) {
                                phi_3704_ = _e1818.member.member.member;
                            } else {
                                if (_e1828 > 0i) {
                                    if (_e1829 > 0i) {
                                        let _e1833 = (_e1829 < 255i);
                                        if _e1833 {
                                            phi_3683_ = bitcast<f32>((_e1824 + bitcast<u32>((_e278 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3683_ = f32();
                                        }
                                        let _e1840 = phi_3683_;
                                        phi_3685_ = _e1840;
                                        phi_3686_ = select(true, false, _e1833);
                                    } else {
                                        phi_3685_ = f32();
                                        phi_3686_ = true;
                                    }
                                    let _e1843 = phi_3685_;
                                    let _e1845 = phi_3686_;
                                    phi_3687_ = _e1843;
                                    phi_3688_ = _e1845;
                                } else {
                                    phi_3687_ = f32();
                                    phi_3688_ = true;
                                }
                                let _e1847 = phi_3687_;
                                let _e1849 = phi_3688_;
                                if _e1849 {
                                    let _e1850 = (_e1824 & 2147483648u);
                                    let _e1857 = ((_e1824 & 8388607u) | (select(0u, 1u, ((_e1824 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1861 = (_e1857 == 0u);
                                    if _e1861 {
                                        phi_4072_ = bitcast<f32>(_e1850);
                                    } else {
                                        let _e1866 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1857)), 32u, _e1861) - 8u);
                                        let _e1869 = (_e1857 << bitcast<u32>((_e1866 & 31u)));
                                        let _e1871 = ((_e1829 + select(0i, 1i, (_e1828 == 0i))) - bitcast<i32>(_e1866));
                                        if (_e1871 >= 255i) {
                                            phi_4062_ = bitcast<f32>((_e1850 | 2139095040u));
                                            phi_4063_ = f32();
                                            phi_4064_ = true;
                                        } else {
                                            let _e1873 = (_e1871 > 0i);
                                            if _e1873 {
                                                phi_4056_ = bitcast<f32>(((_e1850 | (bitcast<u32>(_e1871) << bitcast<u32>(23i))) | (_e1869 & 8388607u)));
                                                phi_4057_ = f32();
                                            } else {
                                                if (_e1871 < -24i) {
                                                    phi_4022_ = 26u;
                                                } else {
                                                    phi_4022_ = bitcast<u32>((1i - _e1871));
                                                }
                                                let _e1878 = phi_4022_;
                                                let _e1879 = (_e1878 & 31u);
                                                let _e1881 = (_e1869 >> bitcast<u32>(_e1879));
                                                let _e1885 = (_e1869 & ((1u << bitcast<u32>(_e1879)) - 1u));
                                                let _e1889 = (1u << bitcast<u32>(((_e1878 - 1u) & 31u)));
                                                if (_e1885 > _e1889) {
                                                    phi_4043_ = true;
                                                } else {
                                                    if (_e1885 == _e1889) {
                                                        phi_4040_ = ((_e1881 & 1u) == 1u);
                                                    } else {
                                                        phi_4040_ = false;
                                                    }
                                                    let _e1895 = phi_4040_;
                                                    phi_4043_ = _e1895;
                                                }
                                                let _e1897 = phi_4043_;
                                                phi_4056_ = f32();
                                                phi_4057_ = bitcast<f32>((_e1850 | (_e1881 + select(0u, 1u, _e1897))));
                                            }
                                            let _e1910 = phi_4056_;
                                            let _e1912 = phi_4057_;
                                            phi_4062_ = _e1910;
                                            phi_4063_ = _e1912;
                                            phi_4064_ = _e1873;
                                        }
                                        let _e1916 = phi_4062_;
                                        let _e1918 = phi_4063_;
                                        let _e1920 = phi_4064_;
                                        phi_4072_ = select(_e1918, _e1916, _e1920);
                                    }
                                    let _e1924 = phi_4072_;
                                    phi_3703_ = _e1924;
                                } else {
                                    phi_3703_ = _e1847;
                                }
                                let _e1926 = phi_3703_;
                                phi_3704_ = _e1926;
                            }
                            let _e1928 = phi_3704_;
                            let _e1929 = bitcast<u32>(_e1928);
                            if ((_e1929 & 2147483647u) >= 2139095040u) {
                                phi_3716_ = bitcast<f32>(((_e1929 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3716_ = _e1928;
                            }
                            let _e1936 = phi_3716_;
                            phi_3721_ = type_26(_e1936, _e1818.member.member.member_1, _e1818.member.member.member_2, _e1818.member.member.member_3);
                        } else {
                            phi_3721_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1941 = phi_3721_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_2.member[_e138] = _e1941;
                        let _e1945 = local_11;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_6.member[_e138] = _e1945.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1950 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1950 > 0u) {
                            let _e1952 = (1u < _e106);
                            if _e1952 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1956 = atomicAdd((&global_7.member[0u]), _e1950);
                                if ((_e1956 + _e1950) < _e1956) {
                                    if _e1952 {
                                    } else {
                                        break;
                                    }
                                    let _e1961 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1964 = select(0u, 1u, (_e1941.member_3 != 4294967295u));
                        if (_e1964 > 0u) {
                            let _e1966 = (3u < _e106);
                            if _e1966 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1970 = atomicAdd((&global_7.member[2u]), _e1964);
                                if ((_e1970 + _e1964) < _e1970) {
                                    if _e1966 {
                                    } else {
                                        break;
                                    }
                                    let _e1975 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1945.member_1 > 0u) {
                            let _e1977 = (5u < _e106);
                            if _e1977 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1981 = atomicAdd((&global_7.member[4u]), _e1945.member_1);
                                if ((_e1981 + _e1945.member_1) < _e1981) {
                                    if _e1977 {
                                    } else {
                                        break;
                                    }
                                    let _e1986 = atomicAdd((&global_7.member[5u]), 1u);
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
