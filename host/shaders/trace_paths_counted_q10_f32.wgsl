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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_47 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_54 {
    member: type_38,
    member_1: u32,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

struct type_60 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_20;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_28;
@group(0) @binding(0) 
var<uniform> global_3: type_49;
@group(0) @binding(1) 
var<storage> global_4: type_12;
@group(0) @binding(3) 
var<storage> global_5: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_60;

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
    var phi_505_: i32;
    var phi_506_: i32;
    var phi_516_: bool;
    var phi_526_: u32;
    var phi_527_: u32;
    var phi_529_: bool;
    var phi_534_: u32;
    var phi_567_: i32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_710_: f32;
    var phi_716_: f32;
    var phi_756_: f32;
    var phi_762_: f32;
    var phi_835_: f32;
    var phi_841_: f32;
    var phi_881_: f32;
    var phi_887_: f32;
    var phi_1006_: i32;
    var phi_1028_: u32;
    var phi_1029_: u32;
    var phi_1066_: i32;
    var phi_1088_: u32;
    var phi_1089_: u32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_4217_: bool;
    var phi_1203_: type_47;
    var phi_1206_: u32;
    var phi_1208_: bool;
    var phi_1210_: u32;
    var phi_1212_: type_54;
    var phi_1223_: bool;
    var phi_1309_: bool;
    var phi_1310_: u32;
    var phi_1311_: type_54;
    var phi_1329_: type_47;
    var phi_1332_: type_7;
    var phi_1333_: type_7;
    var phi_1355_: type_7;
    var phi_1379_: u32;
    var phi_1471_: array<array<f32, 3>, 3>;
    var phi_3778_: bool;
    var phi_3793_: bool;
    var phi_3808_: bool;
    var phi_3823_: bool;
    var phi_3838_: bool;
    var phi_3853_: bool;
    var phi_2013_: f32;
    var phi_2014_: f32;
    var phi_2015_: f32;
    var phi_2016_: f32;
    var phi_2017_: vec3<f32>;
    var phi_2018_: vec3<f32>;
    var phi_2019_: vec3<f32>;
    var phi_2020_: vec3<f32>;
    var phi_3868_: bool;
    var phi_3883_: bool;
    var phi_3898_: bool;
    var phi_3913_: bool;
    var phi_3928_: bool;
    var phi_3943_: bool;
    var phi_2228_: f32;
    var phi_2248_: type_46;
    var phi_2249_: type_46;
    var phi_2252_: type_46;
    var phi_2253_: type_46;
    var phi_2254_: bool;
    var phi_2258_: type_46;
    var phi_2267_: type_26;
    var phi_2292_: bool;
    var phi_2293_: bool;
    var phi_2300_: type_47;
    var phi_2301_: type_47;
    var phi_2302_: type_47;
    var phi_1330_: type_47;
    var phi_4211_: bool;
    var phi_4462_: bool;
    var phi_2303_: type_47;
    var phi_3030_: u32;
    var phi_3031_: u32;
    var phi_3041_: u32;
    var phi_3043_: u32;
    var phi_3044_: bool;
    var phi_3064_: u32;
    var phi_3065_: u32;
    var phi_3069_: type_55;
    var phi_3434_: type_54;
    var phi_3510_: type_54;
    var phi_3511_: u32;
    var phi_3512_: type_54;
    var phi_3514_: u32;
    var phi_3515_: type_54;
    var phi_3516_: bool;
    var phi_3525_: type_54;
    var phi_3530_: bool;
    var phi_3532_: type_54;
    var phi_3537_: type_47;
    var phi_3538_: bool;
    var phi_3539_: u32;
    var phi_3540_: type_54;
    var phi_3548_: type_47;
    var phi_3551_: type_54;
    var phi_4379_: bool;
    var phi_3552_: type_47;
    var phi_3553_: u32;
    var phi_3554_: bool;
    var phi_3555_: u32;
    var phi_3556_: type_54;
    var phi_4378_: bool;
    var phi_3557_: type_47;
    var phi_3558_: u32;
    var phi_3559_: bool;
    var phi_3560_: u32;
    var phi_3561_: type_54;
    var phi_4377_: bool;
    var phi_1204_: type_47;
    var phi_1207_: u32;
    var phi_1209_: bool;
    var phi_1211_: u32;
    var phi_1213_: type_54;
    var phi_3562_: bool;
    var phi_4376_: bool;
    var local_10: type_47;
    var phi_3600_: f32;
    var phi_3602_: f32;
    var phi_3603_: bool;
    var phi_3604_: f32;
    var phi_3605_: bool;
    var phi_4119_: u32;
    var phi_4137_: bool;
    var phi_4140_: bool;
    var phi_4153_: f32;
    var phi_4154_: f32;
    var phi_4159_: f32;
    var phi_4160_: f32;
    var phi_4161_: bool;
    var phi_4169_: f32;
    var phi_3620_: f32;
    var phi_3621_: f32;
    var phi_3633_: f32;
    var phi_3638_: type_26;
    var local_11: type_47;
    var local_12: type_47;

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
                                phi_505_ = (bitcast<i32>((_e241 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_505_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e241)), 32u, (_e241 == 0u))));
                            }
                            let _e255 = phi_505_;
                            phi_506_ = _e255;
                        } else {
                            phi_506_ = 0i;
                        }
                        let _e257 = phi_506_;
                        let _e258 = (_e167 == _e211);
                        if _e258 {
                            phi_516_ = true;
                        } else {
                            phi_516_ = (_e175 == _e211);
                        }
                        let _e261 = phi_516_;
                        let _e262 = select(1u, 0u, _e258);
                        if _e261 {
                            let _e263 = (_e262 + 1u);
                            phi_526_ = _e263;
                            phi_527_ = _e263;
                            phi_529_ = select(true, false, (_e263 == 2u));
                        } else {
                            phi_526_ = u32();
                            phi_527_ = 0u;
                            phi_529_ = true;
                        }
                        let _e267 = phi_526_;
                        let _e269 = phi_527_;
                        let _e271 = phi_529_;
                        if _e271 {
                            phi_534_ = (_e269 + 1u);
                        } else {
                            phi_534_ = 0u;
                        }
                        let _e275 = phi_534_;
                        let _e276 = select(_e267, _e269, _e271);
                        let _e277 = select(_e262, select(2u, _e262, _e261), _e271);
                        let _e278 = -(_e257);
                        if (_e278 < -126i) {
                            phi_567_ = -126i;
                        } else {
                            phi_567_ = select(_e278, 127i, (_e278 > 127i));
                        }
                        let _e283 = phi_567_;
                        let _e288 = bitcast<f32>((bitcast<u32>((_e283 + 127i)) << bitcast<u32>(23i)));
                        let _e294 = bitcast<f32>((bitcast<u32>(((_e278 - _e283) + 127i)) << bitcast<u32>(23i)));
                        let _e299 = global_5.member[_e138].member.member;
                        let _e300 = (_e276 == 0u);
                        if _e300 {
                            phi_585_ = _e299[0];
                        } else {
                            phi_585_ = _e299[1];
                        }
                        let _e304 = phi_585_;
                        let _e305 = (_e276 == 2u);
                        if _e305 {
                            phi_591_ = _e299[2];
                        } else {
                            phi_591_ = _e304;
                        }
                        let _e308 = phi_591_;
                        let _e309 = bitcast<u32>(_e308);
                        let _e311 = ((_e309 & 2139095040u) != 0u);
                        let _e323 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e309 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e309 & 2147483648u))), _e308, _e311) * select(0.00000011920929f, 1f, _e311));
                        let _e324 = global_5.member[_e138].member.member_2;
                        if _e300 {
                            phi_631_ = _e324[0];
                        } else {
                            phi_631_ = _e324[1];
                        }
                        let _e328 = phi_631_;
                        if _e305 {
                            phi_637_ = _e324[2];
                        } else {
                            phi_637_ = _e328;
                        }
                        let _e331 = phi_637_;
                        let _e332 = bitcast<u32>(_e331);
                        let _e334 = ((_e332 & 2139095040u) != 0u);
                        let _e348 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e332 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e332 & 2147483648u))), _e331, _e334) * _e288) * select(0.00000011920929f, 1f, _e334)) * _e294);
                        let _e352 = (bitcast<f32>((bitcast<u32>(_e348) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e355 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                        let _e356 = (_e355 * 0.00000011920929f);
                        let _e359 = select(select(0.00000000000011368684f, _e356, (_e356 > 0.00000000000011368684f)), 0f, _e352);
                        let _e360 = select(0f, _e348, _e352);
                        let _e361 = (_e323 + _e359);
                        let _e362 = (_e323 - _e359);
                        let _e364 = select(38685626000000000000000000f, (1f / _e348), _e352);
                        let _e365 = (_e275 == 0u);
                        if _e365 {
                            phi_710_ = _e299[0];
                        } else {
                            phi_710_ = _e299[1];
                        }
                        let _e369 = phi_710_;
                        let _e370 = (_e275 == 2u);
                        if _e370 {
                            phi_716_ = _e299[2];
                        } else {
                            phi_716_ = _e369;
                        }
                        let _e373 = phi_716_;
                        let _e374 = bitcast<u32>(_e373);
                        let _e376 = ((_e374 & 2139095040u) != 0u);
                        let _e388 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * select(0.00000011920929f, 1f, _e376));
                        if _e365 {
                            phi_756_ = _e324[0];
                        } else {
                            phi_756_ = _e324[1];
                        }
                        let _e392 = phi_756_;
                        if _e370 {
                            phi_762_ = _e324[2];
                        } else {
                            phi_762_ = _e392;
                        }
                        let _e395 = phi_762_;
                        let _e396 = bitcast<u32>(_e395);
                        let _e398 = ((_e396 & 2139095040u) != 0u);
                        let _e412 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e396 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e396 & 2147483648u))), _e395, _e398) * _e288) * select(0.00000011920929f, 1f, _e398)) * _e294);
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e419 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                        let _e420 = (_e419 * 0.00000011920929f);
                        let _e423 = select(select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f)), 0f, _e416);
                        let _e424 = select(0f, _e412, _e416);
                        let _e425 = (_e388 + _e423);
                        let _e426 = (_e388 - _e423);
                        let _e428 = select(38685626000000000000000000f, (1f / _e412), _e416);
                        let _e429 = (_e277 == 0u);
                        if _e429 {
                            phi_835_ = _e299[0];
                        } else {
                            phi_835_ = _e299[1];
                        }
                        let _e433 = phi_835_;
                        let _e434 = (_e277 == 2u);
                        if _e434 {
                            phi_841_ = _e299[2];
                        } else {
                            phi_841_ = _e433;
                        }
                        let _e437 = phi_841_;
                        let _e438 = bitcast<u32>(_e437);
                        let _e440 = ((_e438 & 2139095040u) != 0u);
                        let _e452 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e438 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e438 & 2147483648u))), _e437, _e440) * select(0.00000011920929f, 1f, _e440));
                        if _e429 {
                            phi_881_ = _e324[0];
                        } else {
                            phi_881_ = _e324[1];
                        }
                        let _e456 = phi_881_;
                        if _e434 {
                            phi_887_ = _e324[2];
                        } else {
                            phi_887_ = _e456;
                        }
                        let _e459 = phi_887_;
                        let _e460 = bitcast<u32>(_e459);
                        let _e462 = ((_e460 & 2139095040u) != 0u);
                        let _e476 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e460 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e460 & 2147483648u))), _e459, _e462) * _e288) * select(0.00000011920929f, 1f, _e462)) * _e294);
                        let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e483 = bitcast<f32>((bitcast<u32>(_e452) & 2147483647u));
                        let _e484 = (_e483 * 0.00000011920929f);
                        let _e487 = select(select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f)), 0f, _e480);
                        let _e488 = select(0f, _e476, _e480);
                        let _e489 = (_e452 + _e487);
                        let _e490 = (_e452 - _e487);
                        let _e492 = select(38685626000000000000000000f, (1f / _e476), _e480);
                        let _e494 = select(_e419, _e355, (_e355 > _e419));
                        if (_e238 && (select(_e483, _e494, (_e494 > _e483)) <= 1099511600000f)) {
                            let _e506 = ((_e224 & 8388607u) | (select(0u, 1u, ((_e224 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e509 = bitcast<i32>((_e224 >> bitcast<u32>(23i)));
                            let _e513 = (_e506 == 0u);
                            let _e516 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, _e513)) - 8i);
                            if (_e509 == 255i) {
                                phi_1006_ = 255i;
                            } else {
                                phi_1006_ = (((_e509 + select(0i, 1i, (_e509 == 0i))) - _e516) + _e257);
                            }
                            let _e524 = phi_1006_;
                            let _e534 = (_e524 <= 0i);
                            if _e534 {
                                phi_1029_ = u32();
                            } else {
                                if _e513 {
                                    phi_1028_ = u32();
                                } else {
                                    phi_1028_ = select(((bitcast<u32>(_e524) << bitcast<u32>(23i)) | ((_e506 << bitcast<u32>(((_e516 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e524 >= 255i));
                                }
                                let _e538 = phi_1028_;
                                phi_1029_ = _e538;
                            }
                            let _e540 = phi_1029_;
                            let _e552 = ((_e234 & 8388607u) | (select(0u, 1u, ((_e234 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e555 = bitcast<i32>((_e234 >> bitcast<u32>(23i)));
                            let _e559 = (_e552 == 0u);
                            let _e562 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e552)), 32u, _e559)) - 8i);
                            if (_e555 == 255i) {
                                phi_1066_ = 255i;
                            } else {
                                phi_1066_ = (((_e555 + select(0i, 1i, (_e555 == 0i))) - _e562) + _e257);
                            }
                            let _e570 = phi_1066_;
                            let _e580 = (_e570 <= 0i);
                            if _e580 {
                                phi_1089_ = u32();
                            } else {
                                if _e559 {
                                    phi_1088_ = u32();
                                } else {
                                    phi_1088_ = select(((bitcast<u32>(_e570) << bitcast<u32>(23i)) | ((_e552 << bitcast<u32>(((_e562 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e570 >= 255i));
                                }
                                let _e584 = phi_1088_;
                                phi_1089_ = _e584;
                            }
                            let _e586 = phi_1089_;
                            phi_1097_ = bitcast<f32>(((_e233 & 2147483648u) | select(_e586, 0u, select(_e559, true, _e580))));
                            phi_1098_ = bitcast<f32>(((_e223 & 2147483648u) | select(_e540, 0u, select(_e513, true, _e534))));
                        } else {
                            phi_1097_ = 0f;
                            phi_1098_ = 1f;
                        }
                        let _e592 = phi_1097_;
                        let _e594 = phi_1098_;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e600 = global_5.member[_e138].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e603 = (_e276 % 3u);
                        let _e604 = (_e603 < 3u);
                        if _e604 {
                        } else {
                            break;
                        }
                        let _e606 = local_1[_e603];
                        let _e609 = (_e275 % 3u);
                        let _e610 = (_e609 < 3u);
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e612 = local_1[_e609];
                        let _e615 = (_e277 % 3u);
                        let _e616 = (_e615 < 3u);
                        if _e616 {
                        } else {
                            break;
                        }
                        let _e618 = local_1[_e615];
                        if _e604 {
                        } else {
                            break;
                        }
                        let _e623 = local[_e603];
                        if _e610 {
                        } else {
                            break;
                        }
                        let _e627 = local[_e609];
                        if _e616 {
                        } else {
                            break;
                        }
                        let _e631 = local[_e615];
                        phi_4217_ = false;
                        phi_1203_ = type_47(type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e592), 0u, 0u);
                        phi_1206_ = ((3u * _e96) + 1u);
                        phi_1208_ = (_e594 <= _e592);
                        phi_1210_ = 0u;
                        phi_1212_ = type_54(type_38(vec4<f32>((f32(_e606) * _e150), (f32(_e612) * _e150), (f32(_e618) * _e150), 0f), vec4<f32>((f32(_e623) * _e150), (f32(_e627) * _e150), (f32(_e631) * _e150), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        loop {
                            let _e641 = phi_4217_;
                            let _e643 = phi_1203_;
                            let _e645 = phi_1206_;
                            let _e647 = phi_1208_;
                            let _e649 = phi_1210_;
                            let _e651 = phi_1212_;
                            local_10 = _e643;
                            local_11 = _e643;
                            if _e647 {
                                phi_1223_ = true;
                            } else {
                                phi_1223_ = (_e649 > 0u);
                            }
                            let _e654 = phi_1223_;
                            if _e654 {
                                let _e655 = (_e645 > 0u);
                                if _e655 {
                                    if _e647 {
                                        phi_1309_ = _e647;
                                        phi_1310_ = _e649;
                                        phi_1311_ = _e651;
                                    } else {
                                        let _e656 = (_e649 - 1u);
                                        let _e657 = (_e656 % 128u);
                                        let _e658 = (_e657 < 128u);
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e660 = local_7[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e662 = local_6[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e664 = local_5[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e666 = local_4[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e668 = local_3[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e670 = local_2[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e675 = local_8[_e657];
                                        if _e658 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e678 = local_9[_e657];
                                        phi_1309_ = (_e678 <= _e643.member.member_1);
                                        phi_1310_ = _e656;
                                        phi_1311_ = type_54(type_38(vec4<f32>(_e660, _e662, _e664, 0f), vec4<f32>(_e666, _e668, _e670, 0f)), _e675);
                                    }
                                    let _e683 = phi_1309_;
                                    let _e685 = phi_1310_;
                                    let _e687 = phi_1311_;
                                    if _e683 {
                                        let _e691 = ((_e687.member_1 & 2147483648u) != 0u);
                                        if _e691 {
                                            phi_1329_ = _e643;
                                            phi_1332_ = type_7(0u, ((_e687.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e698 = phi_1329_;
                                                let _e700 = phi_1332_;
                                                local_12 = _e698;
                                                if (_e700.member < _e700.member_1) {
                                                    phi_1333_ = type_7((_e700.member + 1u), _e700.member_1);
                                                    phi_1355_ = type_7(1u, _e700.member);
                                                } else {
                                                    phi_1333_ = _e700;
                                                    phi_1355_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e713 = phi_1333_;
                                                let _e715 = phi_1355_;
                                                let _e719 = (bitcast<i32>(_e715.member) != 0i);
                                                if _e719 {
                                                    let _e725 = type_47(_e698.member, _e698.member_1, (_e698.member_2 + 1u));
                                                    let _e726 = ((_e687.member_1 & 268435455u) + _e715.member_1);
                                                    let _e727 = (_e726 < _e98);
                                                    if _e727 {
                                                        if _e727 {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e731 = global_1.member[_e726].member_1;
                                                        phi_1379_ = _e731;
                                                    } else {
                                                        phi_1379_ = 4294967295u;
                                                    }
                                                    let _e733 = phi_1379_;
                                                    if (_e726 >= _e98) {
                                                        phi_1471_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e727 {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        if (_e603 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e740 = global_1.member[_e726].member[_e603];
                                                        if (_e609 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e746 = global_1.member[_e726].member[_e609];
                                                        if (_e615 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e752 = global_1.member[_e726].member[_e615];
                                                        let _e754 = (3u + _e603);
                                                        if (_e754 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e760 = global_1.member[_e726].member[_e754];
                                                        let _e761 = (3u + _e609);
                                                        if (_e761 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e767 = global_1.member[_e726].member[_e761];
                                                        let _e768 = (3u + _e615);
                                                        if (_e768 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e774 = global_1.member[_e726].member[_e768];
                                                        let _e776 = (6u + _e603);
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e782 = global_1.member[_e726].member[_e776];
                                                        let _e783 = (6u + _e609);
                                                        if (_e783 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e789 = global_1.member[_e726].member[_e783];
                                                        let _e790 = (6u + _e615);
                                                        if (_e790 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e796 = global_1.member[_e726].member[_e790];
                                                        phi_1471_ = array<array<f32, 3>, 3>(array<f32, 3>(_e740, _e746, _e752), array<f32, 3>(_e760, _e767, _e774), array<f32, 3>(_e782, _e789, _e796));
                                                    }
                                                    let _e800 = phi_1471_;
                                                    let _e817 = (_e800[0][2] - _e452);
                                                    let _e820 = (((_e800[0][0] - _e323) * _e488) - (_e817 * _e360));
                                                    let _e823 = (((_e800[0][1] - _e388) * _e488) - (_e817 * _e424));
                                                    let _e826 = (_e800[1][2] - _e452);
                                                    let _e829 = (((_e800[1][0] - _e323) * _e488) - (_e826 * _e360));
                                                    let _e832 = (((_e800[1][1] - _e388) * _e488) - (_e826 * _e424));
                                                    let _e835 = (_e800[2][2] - _e452);
                                                    let _e838 = (((_e800[2][0] - _e323) * _e488) - (_e835 * _e360));
                                                    let _e841 = (((_e800[2][1] - _e388) * _e488) - (_e835 * _e424));
                                                    let _e842 = (_e838 * _e832);
                                                    let _e843 = (_e841 * _e829);
                                                    let _e844 = (_e820 * _e841);
                                                    let _e845 = (_e823 * _e838);
                                                    let _e846 = (_e829 * _e823);
                                                    let _e847 = (_e832 * _e820);
                                                    let _e852 = (((_e842 >= _e843) && (_e844 >= _e845)) && (_e846 >= _e847));
                                                    let _e858 = (_e852 || (((_e842 <= _e843) && (_e844 <= _e845)) && (_e846 <= _e847)));
                                                    if _e858 {
                                                        let _e860 = select(-1f, 1f, _e852);
                                                        let _e862 = ((_e842 - _e843) * _e860);
                                                        let _e864 = select(0f, _e862, (_e862 > 0f));
                                                        let _e866 = ((_e844 - _e845) * _e860);
                                                        let _e868 = select(0f, _e866, (_e866 > 0f));
                                                        let _e870 = ((_e846 - _e847) * _e860);
                                                        let _e872 = select(0f, _e870, (_e870 > 0f));
                                                        let _e874 = ((_e864 + _e868) + _e872);
                                                        let _e876 = select(_e800[1][0], _e800[0][0], (_e800[0][0] < _e800[1][0]));
                                                        let _e880 = select(_e800[1][0], _e800[0][0], (_e800[0][0] > _e800[1][0]));
                                                        let _e884 = select(_e800[1][1], _e800[0][1], (_e800[0][1] < _e800[1][1]));
                                                        let _e888 = select(_e800[1][1], _e800[0][1], (_e800[0][1] > _e800[1][1]));
                                                        let _e892 = select(_e800[1][2], _e800[0][2], (_e800[0][2] < _e800[1][2]));
                                                        let _e896 = select(_e800[1][2], _e800[0][2], (_e800[0][2] > _e800[1][2]));
                                                        let _e901 = ((select(_e800[2][0], _e876, (_e876 < _e800[2][0])) - _e361) * _e364);
                                                        let _e902 = ((select(_e800[2][0], _e880, (_e880 > _e800[2][0])) - _e362) * _e364);
                                                        let _e905 = ((select(_e800[2][1], _e884, (_e884 < _e800[2][1])) - _e425) * _e428);
                                                        let _e906 = ((select(_e800[2][1], _e888, (_e888 > _e800[2][1])) - _e426) * _e428);
                                                        let _e909 = ((select(_e800[2][2], _e892, (_e892 < _e800[2][2])) - _e489) * _e492);
                                                        let _e910 = ((select(_e800[2][2], _e896, (_e896 > _e800[2][2])) - _e490) * _e492);
                                                        let _e912 = select(_e910, _e909, (_e909 < _e910));
                                                        let _e914 = select(_e910, _e909, (_e909 > _e910));
                                                        let _e916 = select(_e902, _e901, (_e901 < _e902));
                                                        let _e918 = select(_e906, _e905, (_e905 < _e906));
                                                        let _e920 = select(_e918, _e916, (_e916 > _e918));
                                                        let _e922 = select(_e912, _e920, (_e920 > _e912));
                                                        let _e924 = select(_e902, _e901, (_e901 > _e902));
                                                        let _e926 = select(_e906, _e905, (_e905 > _e906));
                                                        let _e928 = select(_e926, _e924, (_e924 < _e926));
                                                        let _e930 = select(_e914, _e928, (_e928 < _e914));
                                                        let _e931 = -(_e912);
                                                        let _e937 = select(_e594, _e922, (_e922 > _e594));
                                                        let _e941 = select(_e829, _e820, (_e820 < _e829));
                                                        let _e946 = select(_e829, _e820, (_e820 > _e829));
                                                        let _e953 = select(_e832, _e823, (_e823 < _e832));
                                                        let _e958 = select(_e832, _e823, (_e823 > _e832));
                                                        let _e967 = (((((_e858 && (_e874 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e838, _e941, (_e941 < _e838)) <= 0f) && (select(_e838, _e946, (_e946 > _e838)) >= 0f))) && ((select(_e841, _e953, (_e953 < _e841)) <= 0f) && (select(_e841, _e958, (_e958 > _e841)) >= 0f))) && (_e937 <= (_e930 + (select(_e931, _e914, (_e914 > _e931)) * 0.0000019073523f)))) && (_e937 <= _e698.member.member_1));
                                                        if _e967 {
                                                            let _e972 = (_e800[1][0] - _e800[0][0]);
                                                            let _e973 = (_e800[1][1] - _e800[0][1]);
                                                            let _e974 = (_e800[1][2] - _e800[0][2]);
                                                            let _e975 = vec3<f32>(_e972, _e973, _e974);
                                                            let _e976 = (_e800[2][0] - _e800[1][0]);
                                                            let _e977 = (_e800[2][1] - _e800[1][1]);
                                                            let _e978 = (_e800[2][2] - _e800[1][2]);
                                                            let _e979 = vec3<f32>(_e976, _e977, _e978);
                                                            let _e980 = (_e800[0][0] - _e800[2][0]);
                                                            let _e981 = (_e800[0][1] - _e800[2][1]);
                                                            let _e982 = (_e800[0][2] - _e800[2][2]);
                                                            let _e983 = vec3<f32>(_e980, _e981, _e982);
                                                            let _e984 = abs(_e972);
                                                            let _e985 = abs(_e973);
                                                            if (_e984 != _e984) {
                                                                phi_3778_ = true;
                                                            } else {
                                                                phi_3778_ = (_e985 >= _e984);
                                                            }
                                                            let _e989 = phi_3778_;
                                                            let _e990 = select(_e984, _e985, _e989);
                                                            let _e991 = abs(_e974);
                                                            if (_e990 != _e990) {
                                                                phi_3793_ = true;
                                                            } else {
                                                                phi_3793_ = (_e991 >= _e990);
                                                            }
                                                            let _e995 = phi_3793_;
                                                            let _e996 = select(_e990, _e991, _e995);
                                                            let _e997 = abs(_e976);
                                                            let _e998 = abs(_e977);
                                                            if (_e997 != _e997) {
                                                                phi_3808_ = true;
                                                            } else {
                                                                phi_3808_ = (_e998 >= _e997);
                                                            }
                                                            let _e1002 = phi_3808_;
                                                            let _e1003 = select(_e997, _e998, _e1002);
                                                            let _e1004 = abs(_e978);
                                                            if (_e1003 != _e1003) {
                                                                phi_3823_ = true;
                                                            } else {
                                                                phi_3823_ = (_e1004 >= _e1003);
                                                            }
                                                            let _e1008 = phi_3823_;
                                                            let _e1009 = select(_e1003, _e1004, _e1008);
                                                            let _e1010 = abs(_e980);
                                                            let _e1011 = abs(_e981);
                                                            if (_e1010 != _e1010) {
                                                                phi_3838_ = true;
                                                            } else {
                                                                phi_3838_ = (_e1011 >= _e1010);
                                                            }
                                                            let _e1015 = phi_3838_;
                                                            let _e1016 = select(_e1010, _e1011, _e1015);
                                                            let _e1017 = abs(_e982);
                                                            if (_e1016 != _e1016) {
                                                                phi_3853_ = true;
                                                            } else {
                                                                phi_3853_ = (_e1017 >= _e1016);
                                                            }
                                                            let _e1021 = phi_3853_;
                                                            let _e1022 = select(_e1016, _e1017, _e1021);
                                                            let _e1024 = select(_e1009, _e996, (_e996 > _e1009));
                                                            let _e1026 = select(_e1022, _e1024, (_e1024 > _e1022));
                                                            if (_e996 == _e1026) {
                                                                phi_2013_ = _e832;
                                                                phi_2014_ = _e829;
                                                                phi_2015_ = _e823;
                                                                phi_2016_ = _e820;
                                                                phi_2017_ = vec3<f32>(_e800[0][0], _e800[0][1], _e800[0][2]);
                                                                phi_2018_ = _e983;
                                                                phi_2019_ = _e979;
                                                                phi_2020_ = _e975;
                                                            } else {
                                                                let _e1028 = (_e1009 == _e1026);
                                                                let _e1033 = vec3(_e1028);
                                                                phi_2013_ = select(_e823, _e841, _e1028);
                                                                phi_2014_ = select(_e820, _e838, _e1028);
                                                                phi_2015_ = select(_e841, _e832, _e1028);
                                                                phi_2016_ = select(_e838, _e829, _e1028);
                                                                phi_2017_ = select(vec3<f32>(_e800[2][0], _e800[2][1], _e800[2][2]), vec3<f32>(_e800[1][0], _e800[1][1], _e800[1][2]), _e1033);
                                                                phi_2018_ = select(_e979, _e975, _e1033);
                                                                phi_2019_ = select(_e975, _e983, _e1033);
                                                                phi_2020_ = select(_e983, _e979, _e1033);
                                                            }
                                                            let _e1039 = phi_2013_;
                                                            let _e1041 = phi_2014_;
                                                            let _e1043 = phi_2015_;
                                                            let _e1045 = phi_2016_;
                                                            let _e1047 = phi_2017_;
                                                            let _e1049 = phi_2018_;
                                                            let _e1051 = phi_2019_;
                                                            let _e1053 = phi_2020_;
                                                            let _e1060 = ((_e1051.y * _e1049.z) - (_e1049.y * _e1051.z));
                                                            let _e1065 = ((_e1051.z * _e1049.x) - (_e1049.z * _e1051.x));
                                                            let _e1068 = ((_e1051.x * _e1049.y) - (_e1049.x * _e1051.y));
                                                            let _e1071 = ((_e864 >= _e868) && (_e864 >= _e872));
                                                            let _e1072 = (_e868 >= _e872);
                                                            let _e1086 = (((_e1060 * (select(select(_e800[2][0], _e800[1][0], _e1072), _e800[0][0], _e1071) - _e323)) + (_e1065 * (select(select(_e800[2][1], _e800[1][1], _e1072), _e800[0][1], _e1071) - _e388))) + (_e1068 * (select(select(_e800[2][2], _e800[1][2], _e1072), _e800[0][2], _e1071) - _e452)));
                                                            let _e1091 = (((_e1060 * _e360) + (_e1065 * _e424)) + (_e1068 * _e488));
                                                            let _e1092 = (_e1041 - _e1045);
                                                            let _e1093 = (_e1039 - _e1043);
                                                            let _e1096 = ((_e1092 * _e1092) + (_e1093 * _e1093));
                                                            let _e1103 = (-(((_e1045 * _e1092) + (_e1043 * _e1093))) / select(0.000000000000000000000000000000000000011754944f, _e1096, (_e1096 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1105 = select(1f, _e1103, (_e1103 < 1f));
                                                            let _e1107 = select(0f, _e1105, (_e1105 > 0f));
                                                            let _e1116 = ((_e1047.x + (_e1053.x * _e1107)) - _e323);
                                                            let _e1119 = ((_e1047.y + (_e1053.y * _e1107)) - _e388);
                                                            let _e1122 = ((_e1047.z + (_e1053.z * _e1107)) - _e452);
                                                            let _e1125 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                            let _e1128 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                            let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                            let _e1133 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                            let _e1135 = select(_e1133, _e1130, (_e1130 > _e1133));
                                                            let _e1139 = abs(_e1060);
                                                            let _e1140 = abs(_e1065);
                                                            if (_e1139 != _e1139) {
                                                                phi_3868_ = true;
                                                            } else {
                                                                phi_3868_ = (_e1140 >= _e1139);
                                                            }
                                                            let _e1144 = phi_3868_;
                                                            let _e1145 = select(_e1139, _e1140, _e1144);
                                                            let _e1146 = abs(_e1068);
                                                            if (_e1145 != _e1145) {
                                                                phi_3883_ = true;
                                                            } else {
                                                                phi_3883_ = (_e1146 >= _e1145);
                                                            }
                                                            let _e1150 = phi_3883_;
                                                            let _e1166 = abs(_e1051.x);
                                                            let _e1167 = abs(_e1051.y);
                                                            if (_e1166 != _e1166) {
                                                                phi_3898_ = true;
                                                            } else {
                                                                phi_3898_ = (_e1167 >= _e1166);
                                                            }
                                                            let _e1171 = phi_3898_;
                                                            let _e1172 = select(_e1166, _e1167, _e1171);
                                                            let _e1173 = abs(_e1051.z);
                                                            if (_e1172 != _e1172) {
                                                                phi_3913_ = true;
                                                            } else {
                                                                phi_3913_ = (_e1173 >= _e1172);
                                                            }
                                                            let _e1177 = phi_3913_;
                                                            let _e1180 = abs(_e1049.x);
                                                            let _e1181 = abs(_e1049.y);
                                                            if (_e1180 != _e1180) {
                                                                phi_3928_ = true;
                                                            } else {
                                                                phi_3928_ = (_e1181 >= _e1180);
                                                            }
                                                            let _e1185 = phi_3928_;
                                                            let _e1186 = select(_e1180, _e1181, _e1185);
                                                            let _e1187 = abs(_e1049.z);
                                                            if (_e1186 != _e1186) {
                                                                phi_3943_ = true;
                                                            } else {
                                                                phi_3943_ = (_e1187 >= _e1186);
                                                            }
                                                            let _e1191 = phi_3943_;
                                                            let _e1196 = ((bitcast<f32>((bitcast<u32>(((((_e1060 * _e1116) + (_e1065 * _e1119)) + (_e1068 * _e1122)) - _e1086)) & 2147483647u)) <= ((0.0000009536743f * select(_e1026, _e1135, (_e1135 > _e1026))) * select(_e1145, _e1146, _e1150))) && !((bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u)) <= ((0.0000038146973f * select(_e1172, _e1173, _e1177)) * select(_e1186, _e1187, _e1191)))));
                                                            let _e1197 = (_e1086 / _e1091);
                                                            if (_e967 && !(_e1196)) {
                                                                let _e1200 = (_e1122 / _e488);
                                                                let _e1208 = (((_e1060 * (_e1116 - (_e360 * _e1200))) + (_e1065 * (_e1119 - (_e424 * _e1200)))) / _e1091);
                                                                phi_2228_ = select(select(_e1200, (_e1200 + _e1208), (bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u)) <= _e1026)), _e1197, _e1196);
                                                            } else {
                                                                phi_2228_ = _e1197;
                                                            }
                                                            let _e1217 = phi_2228_;
                                                            let _e1219 = select(_e930, _e1217, (_e1217 < _e930));
                                                            let _e1221 = select(_e922, _e1219, (_e1219 > _e922));
                                                            let _e1222 = (1f / _e874);
                                                            phi_2248_ = type_46(_e1221, (_e868 * _e1222), (_e872 * _e1222), ((_e967 && (_e1221 >= _e594)) && (_e1221 <= _e698.member.member_1)));
                                                            phi_2249_ = type_46();
                                                        } else {
                                                            phi_2248_ = type_46();
                                                            phi_2249_ = type_46(0f, 0f, 0f, _e967);
                                                        }
                                                        let _e1231 = phi_2248_;
                                                        let _e1233 = phi_2249_;
                                                        phi_2252_ = _e1231;
                                                        phi_2253_ = _e1233;
                                                        phi_2254_ = select(true, false, _e967);
                                                    } else {
                                                        phi_2252_ = type_46();
                                                        phi_2253_ = type_46(0f, 0f, 0f, _e858);
                                                        phi_2254_ = true;
                                                    }
                                                    let _e1236 = phi_2252_;
                                                    let _e1238 = phi_2253_;
                                                    let _e1240 = phi_2254_;
                                                    if _e1240 {
                                                        phi_2258_ = _e1238;
                                                    } else {
                                                        phi_2258_ = _e1236;
                                                    }
                                                    let _e1242 = phi_2258_;
                                                    if _e1242.member_3 {
                                                        phi_2267_ = type_26(_e1242.member, _e1242.member_1, _e1242.member_2, _e733);
                                                    } else {
                                                        phi_2267_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1249 = phi_2267_;
                                                    if (_e1249.member_3 != 4294967295u) {
                                                        if (_e733 != _e600) {
                                                            if (_e1249.member < _e698.member.member.member) {
                                                                phi_2293_ = true;
                                                            } else {
                                                                if (_e1249.member == _e698.member.member.member) {
                                                                    phi_2292_ = (_e1249.member_3 < _e698.member.member.member_3);
                                                                } else {
                                                                    phi_2292_ = false;
                                                                }
                                                                let _e1264 = phi_2292_;
                                                                phi_2293_ = _e1264;
                                                            }
                                                            let _e1266 = phi_2293_;
                                                            if _e1266 {
                                                                phi_2300_ = type_47(type_43(_e1249, _e1249.member), _e725.member_1, _e725.member_2);
                                                            } else {
                                                                phi_2300_ = _e725;
                                                            }
                                                            let _e1273 = phi_2300_;
                                                            phi_2301_ = _e1273;
                                                        } else {
                                                            phi_2301_ = _e725;
                                                        }
                                                        let _e1275 = phi_2301_;
                                                        phi_2302_ = _e1275;
                                                    } else {
                                                        phi_2302_ = _e725;
                                                    }
                                                    let _e1277 = phi_2302_;
                                                    phi_1330_ = _e1277;
                                                } else {
                                                    phi_1330_ = type_47();
                                                }
                                                let _e1279 = phi_1330_;
                                                continue;
                                                continuing {
                                                    phi_1329_ = _e1279;
                                                    phi_1332_ = _e713;
                                                    phi_4211_ = _e641;
                                                    break if !(_e719);
                                                }
                                            }
                                            let _e1282 = phi_4211_;
                                            phi_4376_ = _e1282;
                                            if _e1282 {
                                                break;
                                            }
                                            phi_4462_ = _e1282;
                                            let _e2039 = local_12;
                                            phi_2303_ = _e2039;
                                        } else {
                                            phi_4462_ = _e641;
                                            phi_2303_ = _e643;
                                        }
                                        let _e1284 = phi_4462_;
                                        let _e1286 = phi_2303_;
                                        if _e691 {
                                            phi_3537_ = type_47();
                                            phi_3538_ = bool();
                                            phi_3539_ = u32();
                                            phi_3540_ = type_54();
                                        } else {
                                            if (_e687.member_1 >= _e96) {
                                                phi_3069_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e687.member_1 < _e96) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1290 = ((1u + _e276) % 4u);
                                                if (_e1290 < 4u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1295 = global_4.member[_e687.member_1][_e1290];
                                                let _e1297 = (_e1295 >> bitcast<u32>(11u));
                                                let _e1299 = ((1u + _e275) % 4u);
                                                if (_e1299 < 4u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1304 = global_4.member[_e687.member_1][_e1299];
                                                let _e1306 = (_e1304 >> bitcast<u32>(11u));
                                                let _e1308 = ((1u + _e277) % 4u);
                                                if (_e1308 < 4u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1313 = global_4.member[_e687.member_1][_e1308];
                                                let _e1315 = (_e1313 >> bitcast<u32>(11u));
                                                let _e1338 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.x - _e687.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e1339 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.y - _e687.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e1340 = (bitcast<f32>((bitcast<u32>((_e687.member.member_1.z - _e687.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e1342 = select(_e150, _e1338, (_e1338 > _e150));
                                                let _e1344 = select(_e150, _e1339, (_e1339 > _e150));
                                                let _e1346 = select(_e150, _e1340, (_e1340 > _e150));
                                                let _e1377 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1295 & 1023u))) - 8388608f) * _e1342));
                                                let _e1382 = (bitcast<i32>((_e1295 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1385 = bitcast<f32>((_e1377 & bitcast<u32>(_e1382)));
                                                let _e1386 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1304 & 1023u))) - 8388608f) * _e1344));
                                                let _e1391 = (bitcast<i32>((_e1304 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1394 = bitcast<f32>((_e1386 & bitcast<u32>(_e1391)));
                                                let _e1395 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1313 & 1023u))) - 8388608f) * _e1346));
                                                let _e1400 = (bitcast<i32>((_e1313 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1403 = bitcast<f32>((_e1395 & bitcast<u32>(_e1400)));
                                                let _e1407 = bitcast<f32>((_e1377 & bitcast<u32>(~(_e1382))));
                                                let _e1411 = bitcast<f32>((_e1386 & bitcast<u32>(~(_e1391))));
                                                let _e1415 = bitcast<f32>((_e1395 & bitcast<u32>(~(_e1400))));
                                                let _e1416 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1297 & 1023u))) - 8388608f) * _e1342));
                                                let _e1421 = (bitcast<i32>((_e1297 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1424 = bitcast<f32>((_e1416 & bitcast<u32>(_e1421)));
                                                let _e1425 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1306 & 1023u))) - 8388608f) * _e1344));
                                                let _e1430 = (bitcast<i32>((_e1306 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1433 = bitcast<f32>((_e1425 & bitcast<u32>(_e1430)));
                                                let _e1434 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1315 & 1023u))) - 8388608f) * _e1346));
                                                let _e1439 = (bitcast<i32>((_e1315 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e1442 = bitcast<f32>((_e1434 & bitcast<u32>(_e1439)));
                                                let _e1446 = bitcast<f32>((_e1416 & bitcast<u32>(~(_e1421))));
                                                let _e1450 = bitcast<f32>((_e1425 & bitcast<u32>(~(_e1430))));
                                                let _e1454 = bitcast<f32>((_e1434 & bitcast<u32>(~(_e1439))));
                                                let _e1484 = global_4.member[_e687.member_1][0u];
                                                let _e1488 = global_4.member[_e687.member_1][1u];
                                                let _e1492 = global_4.member[_e687.member_1][2u];
                                                let _e1496 = global_4.member[_e687.member_1][3u];
                                                let _e1508 = (((_e1488 >> bitcast<u32>(22i)) | ((_e1492 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1496 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1509 = (_e1484 & 268435455u);
                                                let _e1510 = (_e1508 & 268435455u);
                                                let _e1513 = ((_e1484 >> bitcast<u32>(28u)) & 7u);
                                                let _e1521 = ((_e1484 >> bitcast<u32>(31i)) | (((_e1508 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1522 = (_e1513 != 0u);
                                                if (_e1513 == 0u) {
                                                    phi_3031_ = _e1509;
                                                } else {
                                                    if (_e1513 == 7u) {
                                                        phi_3030_ = 2147483648u;
                                                    } else {
                                                        phi_3030_ = ((2147483648u | (_e1513 << bitcast<u32>(28u))) | (_e1510 & 268435455u));
                                                    }
                                                    let _e1531 = phi_3030_;
                                                    phi_3031_ = _e1531;
                                                }
                                                let _e1533 = phi_3031_;
                                                if _e1522 {
                                                    let _e1534 = (_e1513 != 7u);
                                                    if _e1534 {
                                                        phi_3041_ = (_e1510 + _e1513);
                                                    } else {
                                                        phi_3041_ = u32();
                                                    }
                                                    let _e1537 = phi_3041_;
                                                    phi_3043_ = _e1537;
                                                    phi_3044_ = select(true, false, _e1534);
                                                } else {
                                                    phi_3043_ = u32();
                                                    phi_3044_ = true;
                                                }
                                                let _e1540 = phi_3043_;
                                                let _e1542 = phi_3044_;
                                                if (_e1521 == 0u) {
                                                    phi_3065_ = (_e1509 + select(0u, 1u, !(_e1522)));
                                                } else {
                                                    if (_e1521 == 7u) {
                                                        phi_3064_ = 2147483648u;
                                                    } else {
                                                        phi_3064_ = ((2147483648u | (_e1521 << bitcast<u32>(28u))) | (select(_e1540, _e1510, _e1542) & 268435455u));
                                                    }
                                                    let _e1555 = phi_3064_;
                                                    phi_3065_ = _e1555;
                                                }
                                                let _e1557 = phi_3065_;
                                                phi_3069_ = type_55(array<vec4<f32>, 3>(vec4<f32>((_e687.member.member.x + _e1385), (_e687.member.member.x + _e1407), (_e687.member.member_1.x - _e1424), (_e687.member.member_1.x - _e1446)), vec4<f32>((_e687.member.member.y + _e1394), (_e687.member.member.y + _e1411), (_e687.member.member_1.y - _e1433), (_e687.member.member_1.y - _e1450)), vec4<f32>((_e687.member.member.z + _e1403), (_e687.member.member.z + _e1415), (_e687.member.member_1.z - _e1442), (_e687.member.member_1.z - _e1454))), type_54(type_38((_e687.member.member + vec4<f32>(_e1385, _e1394, _e1403, 0f)), (_e687.member.member_1 - vec4<f32>(_e1424, _e1433, _e1442, 0f))), _e1533), type_54(type_38((_e687.member.member + vec4<f32>(_e1407, _e1411, _e1415, 0f)), (_e687.member.member_1 - vec4<f32>(_e1446, _e1450, _e1454, 0f))), _e1557));
                                            }
                                            let _e1562 = phi_3069_;
                                            let _e1581 = ((_e1562.member[0].x - _e361) * _e364);
                                            let _e1582 = ((_e1562.member[0].y - _e361) * _e364);
                                            let _e1583 = ((_e1562.member[0].z - _e362) * _e364);
                                            let _e1584 = ((_e1562.member[0].w - _e362) * _e364);
                                            let _e1594 = ((_e1562.member[1].x - _e425) * _e428);
                                            let _e1595 = ((_e1562.member[1].y - _e425) * _e428);
                                            let _e1596 = ((_e1562.member[1].z - _e426) * _e428);
                                            let _e1597 = ((_e1562.member[1].w - _e426) * _e428);
                                            let _e1607 = ((_e1562.member[2].x - _e489) * _e492);
                                            let _e1608 = ((_e1562.member[2].y - _e489) * _e492);
                                            let _e1609 = ((_e1562.member[2].z - _e490) * _e492);
                                            let _e1610 = ((_e1562.member[2].w - _e490) * _e492);
                                            let _e1612 = select(_e1609, _e1607, (_e1607 < _e1609));
                                            let _e1614 = select(_e1610, _e1608, (_e1608 < _e1610));
                                            let _e1616 = select(_e1609, _e1607, (_e1607 > _e1609));
                                            let _e1618 = select(_e1610, _e1608, (_e1608 > _e1610));
                                            let _e1620 = select(_e1583, _e1581, (_e1581 < _e1583));
                                            let _e1622 = select(_e1584, _e1582, (_e1582 < _e1584));
                                            let _e1624 = select(_e1596, _e1594, (_e1594 < _e1596));
                                            let _e1626 = select(_e1597, _e1595, (_e1595 < _e1597));
                                            let _e1628 = select(_e1624, _e1620, (_e1620 > _e1624));
                                            let _e1630 = select(_e1626, _e1622, (_e1622 > _e1626));
                                            let _e1632 = select(_e1612, _e1628, (_e1628 > _e1612));
                                            let _e1634 = select(_e1614, _e1630, (_e1630 > _e1614));
                                            let _e1636 = select(_e1583, _e1581, (_e1581 > _e1583));
                                            let _e1638 = select(_e1584, _e1582, (_e1582 > _e1584));
                                            let _e1640 = select(_e1596, _e1594, (_e1594 > _e1596));
                                            let _e1642 = select(_e1597, _e1595, (_e1595 > _e1597));
                                            let _e1644 = select(_e1640, _e1636, (_e1636 < _e1640));
                                            let _e1646 = select(_e1642, _e1638, (_e1638 < _e1642));
                                            let _e1651 = -(_e1612);
                                            let _e1652 = -(_e1614);
                                            let _e1659 = (select(_e1616, _e1644, (_e1644 < _e1616)) + (select(_e1651, _e1616, (_e1616 > _e1651)) * 0.0000019073523f));
                                            let _e1660 = (select(_e1618, _e1646, (_e1646 < _e1618)) + (select(_e1652, _e1618, (_e1618 > _e1652)) * 0.0000019073523f));
                                            let _e1662 = select(_e594, _e1632, (_e1632 > _e594));
                                            let _e1664 = select(_e594, _e1634, (_e1634 > _e594));
                                            let _e1669 = (_e1662 <= select(_e1286.member.member_1, _e1659, (_e1659 < _e1286.member.member_1)));
                                            let _e1670 = (_e1664 <= select(_e1286.member.member_1, _e1660, (_e1660 < _e1286.member.member_1)));
                                            let _e1671 = (_e1662 <= _e1664);
                                            if _e1669 {
                                                if _e1670 {
                                                    if _e1671 {
                                                        phi_3434_ = _e1562.member_2;
                                                    } else {
                                                        phi_3434_ = _e1562.member_1;
                                                    }
                                                    let _e1675 = phi_3434_;
                                                    let _e1696 = (_e685 % 128u);
                                                    let _e1697 = (_e1696 < 128u);
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1696] = _e1675.member_1;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1696] = _e1675.member.member.x;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1696] = _e1675.member.member.y;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1696] = _e1675.member.member.z;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1696] = _e1675.member.member_1.x;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1696] = _e1675.member.member_1.y;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1696] = _e1675.member.member_1.z;
                                                    if _e1697 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1696] = select(_e1662, _e1664, _e1671);
                                                    if _e1671 {
                                                        phi_3510_ = _e1562.member_1;
                                                    } else {
                                                        phi_3510_ = _e1562.member_2;
                                                    }
                                                    let _e1710 = phi_3510_;
                                                    phi_3511_ = (_e685 + 1u);
                                                    phi_3512_ = _e1710;
                                                } else {
                                                    phi_3511_ = u32();
                                                    phi_3512_ = type_54();
                                                }
                                                let _e1712 = phi_3511_;
                                                let _e1714 = phi_3512_;
                                                phi_3514_ = _e1712;
                                                phi_3515_ = _e1714;
                                                phi_3516_ = select(true, false, _e1670);
                                            } else {
                                                phi_3514_ = u32();
                                                phi_3515_ = type_54();
                                                phi_3516_ = true;
                                            }
                                            let _e1717 = phi_3514_;
                                            let _e1719 = phi_3515_;
                                            let _e1721 = phi_3516_;
                                            if _e1721 {
                                                if _e1669 {
                                                    phi_3525_ = _e1562.member_1;
                                                } else {
                                                    phi_3525_ = _e1562.member_2;
                                                }
                                                let _e1725 = phi_3525_;
                                                phi_3530_ = select(_e1670, true, _e1669);
                                                phi_3532_ = _e1725;
                                            } else {
                                                phi_3530_ = _e683;
                                                phi_3532_ = _e1719;
                                            }
                                            let _e1728 = phi_3530_;
                                            let _e1730 = phi_3532_;
                                            phi_3537_ = type_47(_e1286.member, (_e1286.member_1 + 1u), _e1286.member_2);
                                            phi_3538_ = _e1728;
                                            phi_3539_ = select(_e1717, _e685, _e1721);
                                            phi_3540_ = _e1730;
                                        }
                                        let _e1733 = phi_3537_;
                                        let _e1735 = phi_3538_;
                                        let _e1737 = phi_3539_;
                                        let _e1739 = phi_3540_;
                                        if _e691 {
                                            phi_3548_ = _e1286;
                                            phi_3551_ = _e687;
                                        } else {
                                            phi_3548_ = _e1733;
                                            phi_3551_ = _e1739;
                                        }
                                        let _e1741 = phi_3548_;
                                        let _e1743 = phi_3551_;
                                        phi_4379_ = _e1284;
                                        phi_3552_ = _e1741;
                                        phi_3553_ = (_e645 - 1u);
                                        phi_3554_ = select(_e1735, false, _e691);
                                        phi_3555_ = select(_e1737, _e685, _e691);
                                        phi_3556_ = _e1743;
                                    } else {
                                        phi_4379_ = _e641;
                                        phi_3552_ = _e643;
                                        phi_3553_ = _e645;
                                        phi_3554_ = _e683;
                                        phi_3555_ = _e685;
                                        phi_3556_ = _e687;
                                    }
                                    let _e1747 = phi_4379_;
                                    let _e1749 = phi_3552_;
                                    let _e1751 = phi_3553_;
                                    let _e1753 = phi_3554_;
                                    let _e1755 = phi_3555_;
                                    let _e1757 = phi_3556_;
                                    phi_4378_ = _e1747;
                                    phi_3557_ = _e1749;
                                    phi_3558_ = _e1751;
                                    phi_3559_ = _e1753;
                                    phi_3560_ = _e1755;
                                    phi_3561_ = _e1757;
                                } else {
                                    phi_4378_ = _e641;
                                    phi_3557_ = type_47();
                                    phi_3558_ = u32();
                                    phi_3559_ = bool();
                                    phi_3560_ = u32();
                                    phi_3561_ = type_54();
                                }
                                let _e1759 = phi_4378_;
                                let _e1761 = phi_3557_;
                                let _e1763 = phi_3558_;
                                let _e1765 = phi_3559_;
                                let _e1767 = phi_3560_;
                                let _e1769 = phi_3561_;
                                phi_4377_ = _e1759;
                                phi_1204_ = _e1761;
                                phi_1207_ = _e1763;
                                phi_1209_ = _e1765;
                                phi_1211_ = _e1767;
                                phi_1213_ = _e1769;
                                phi_3562_ = _e655;
                            } else {
                                phi_4377_ = _e641;
                                phi_1204_ = type_47();
                                phi_1207_ = u32();
                                phi_1209_ = bool();
                                phi_1211_ = u32();
                                phi_1213_ = type_54();
                                phi_3562_ = false;
                            }
                            let _e1771 = phi_4377_;
                            let _e1773 = phi_1204_;
                            let _e1775 = phi_1207_;
                            let _e1777 = phi_1209_;
                            let _e1779 = phi_1211_;
                            let _e1781 = phi_1213_;
                            let _e1783 = phi_3562_;
                            continue;
                            continuing {
                                phi_4217_ = _e1771;
                                phi_1203_ = _e1773;
                                phi_1206_ = _e1775;
                                phi_1208_ = _e1777;
                                phi_1210_ = _e1779;
                                phi_1212_ = _e1781;
                                phi_4376_ = _e1771;
                                break if !(_e1783);
                            }
                        }
                        let _e1786 = phi_4376_;
                        if _e1786 {
                            break;
                        }
                        let _e1788 = local_10;
                        if (_e1788.member.member.member_3 != 4294967295u) {
                            let _e1794 = bitcast<u32>(_e1788.member.member.member);
                            let _e1798 = (bitcast<i32>((_e1794 >> bitcast<u32>(23i))) & 255i);
                            let _e1799 = (_e1798 + _e278);
                            if (_e1798 == 255i) {
                                phi_3621_ = _e1788.member.member.member;
                            } else {
                                if (_e1798 > 0i) {
                                    if (_e1799 > 0i) {
                                        let _e1803 = (_e1799 < 255i);
                                        if _e1803 {
                                            phi_3600_ = bitcast<f32>((_e1794 + bitcast<u32>((_e278 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3600_ = f32();
                                        }
                                        let _e1810 = phi_3600_;
                                        phi_3602_ = _e1810;
                                        phi_3603_ = select(true, false, _e1803);
                                    } else {
                                        phi_3602_ = f32();
                                        phi_3603_ = true;
                                    }
                                    let _e1813 = phi_3602_;
                                    let _e1815 = phi_3603_;
                                    phi_3604_ = _e1813;
                                    phi_3605_ = _e1815;
                                } else {
                                    phi_3604_ = f32();
                                    phi_3605_ = true;
                                }
                                let _e1817 = phi_3604_;
                                let _e1819 = phi_3605_;
                                if _e1819 {
                                    let _e1820 = (_e1794 & 2147483648u);
                                    let _e1827 = ((_e1794 & 8388607u) | (select(0u, 1u, ((_e1794 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1831 = (_e1827 == 0u);
                                    if _e1831 {
                                        phi_4169_ = bitcast<f32>(_e1820);
                                    } else {
                                        let _e1836 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1827)), 32u, _e1831) - 8u);
                                        let _e1839 = (_e1827 << bitcast<u32>((_e1836 & 31u)));
                                        let _e1841 = ((_e1799 + select(0i, 1i, (_e1798 == 0i))) - bitcast<i32>(_e1836));
                                        if (_e1841 >= 255i) {
                                            phi_4159_ = bitcast<f32>((_e1820 | 2139095040u));
                                            phi_4160_ = f32();
                                            phi_4161_ = true;
                                        } else {
                                            let _e1843 = (_e1841 > 0i);
                                            if _e1843 {
                                                phi_4153_ = bitcast<f32>(((_e1820 | (bitcast<u32>(_e1841) << bitcast<u32>(23i))) | (_e1839 & 8388607u)));
                                                phi_4154_ = f32();
                                            } else {
                                                if (_e1841 < -24i) {
                                                    phi_4119_ = 26u;
                                                } else {
                                                    phi_4119_ = bitcast<u32>((1i - _e1841));
                                                }
                                                let _e1848 = phi_4119_;
                                                let _e1849 = (_e1848 & 31u);
                                                let _e1851 = (_e1839 >> bitcast<u32>(_e1849));
                                                let _e1855 = (_e1839 & ((1u << bitcast<u32>(_e1849)) - 1u));
                                                let _e1859 = (1u << bitcast<u32>(((_e1848 - 1u) & 31u)));
                                                if (_e1855 > _e1859) {
                                                    phi_4140_ = true;
                                                } else {
                                                    if (_e1855 == _e1859) {
                                                        phi_4137_ = ((_e1851 & 1u) == 1u);
                                                    } else {
                                                        phi_4137_ = false;
                                                    }
                                                    let _e1865 = phi_4137_;
                                                    phi_4140_ = _e1865;
                                                }
                                                let _e1867 = phi_4140_;
                                                phi_4153_ = f32();
                                                phi_4154_ = bitcast<f32>((_e1820 | (_e1851 + select(0u, 1u, _e1867))));
                                            }
                                            let _e1880 = phi_4153_;
                                            let _e1882 = phi_4154_;
                                            phi_4159_ = _e1880;
                                            phi_4160_ = _e1882;
                                            phi_4161_ = _e1843;
                                        }
                                        let _e1886 = phi_4159_;
                                        let _e1888 = phi_4160_;
                                        let _e1890 = phi_4161_;
                                        phi_4169_ = select(_e1888, _e1886, _e1890);
                                    }
                                    let _e1894 = phi_4169_;
                                    phi_3620_ = _e1894;
                                } else {
                                    phi_3620_ = _e1817;
                                }
                                let _e1896 = phi_3620_;
                                phi_3621_ = _e1896;
                            }
                            let _e1898 = phi_3621_;
                            let _e1899 = bitcast<u32>(_e1898);
                            if ((_e1899 & 2147483647u) >= 2139095040u) {
                                phi_3633_ = bitcast<f32>(((_e1899 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3633_ = _e1898;
                            }
                            let _e1906 = phi_3633_;
                            phi_3638_ = type_26(_e1906, _e1788.member.member.member_1, _e1788.member.member.member_2, _e1788.member.member.member_3);
                        } else {
                            phi_3638_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1911 = phi_3638_;
                        if _e154 {
                        } else {
                            break;
                        }
                        global_2.member[_e138] = _e1911;
                        let _e1915 = local_11;
                        if _e155 {
                        } else {
                            break;
                        }
                        global_6.member[_e138] = _e1915.member_1;
                        if _e153 {
                        } else {
                            break;
                        }
                        let _e1920 = select(0u, 1u, (_e222 <= _e232));
                        if (_e1920 > 0u) {
                            let _e1922 = (1u < _e106);
                            if _e1922 {
                                if (0u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1926 = atomicAdd((&global_7.member[0u]), _e1920);
                                if ((_e1926 + _e1920) < _e1926) {
                                    if _e1922 {
                                    } else {
                                        break;
                                    }
                                    let _e1931 = atomicAdd((&global_7.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1934 = select(0u, 1u, (_e1911.member_3 != 4294967295u));
                        if (_e1934 > 0u) {
                            let _e1936 = (3u < _e106);
                            if _e1936 {
                                if (2u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1940 = atomicAdd((&global_7.member[2u]), _e1934);
                                if ((_e1940 + _e1934) < _e1940) {
                                    if _e1936 {
                                    } else {
                                        break;
                                    }
                                    let _e1945 = atomicAdd((&global_7.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1915.member_1 > 0u) {
                            let _e1947 = (5u < _e106);
                            if _e1947 {
                                if (4u < _e106) {
                                } else {
                                    break;
                                }
                                let _e1951 = atomicAdd((&global_7.member[4u]), _e1915.member_1);
                                if ((_e1951 + _e1915.member_1) < _e1951) {
                                    if _e1947 {
                                    } else {
                                        break;
                                    }
                                    let _e1956 = atomicAdd((&global_7.member[5u]), 1u);
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
