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

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: type_22,
    member_1: f32,
}

struct type_42 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_49 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_34,
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
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_45;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_60;
@group(0) @binding(1) 
var<storage> global_7: type_49;

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
    var phi_1203_: type_43;
    var phi_1206_: u32;
    var phi_1208_: bool;
    var phi_1210_: u32;
    var phi_1212_: type_54;
    var phi_1223_: bool;
    var phi_1309_: bool;
    var phi_1310_: u32;
    var phi_1311_: type_54;
    var phi_1329_: type_43;
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
    var phi_2248_: type_42;
    var phi_2249_: type_42;
    var phi_2252_: type_42;
    var phi_2253_: type_42;
    var phi_2254_: bool;
    var phi_2258_: type_42;
    var phi_2267_: type_22;
    var phi_2292_: bool;
    var phi_2293_: bool;
    var phi_2300_: type_43;
    var phi_2301_: type_43;
    var phi_2302_: type_43;
    var phi_1330_: type_43;
    var phi_4211_: bool;
    var phi_4462_: bool;
    var phi_2303_: type_43;
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
    var phi_3537_: type_43;
    var phi_3538_: bool;
    var phi_3539_: u32;
    var phi_3540_: type_54;
    var phi_3548_: type_43;
    var phi_3551_: type_54;
    var phi_4379_: bool;
    var phi_3552_: type_43;
    var phi_3553_: u32;
    var phi_3554_: bool;
    var phi_3555_: u32;
    var phi_3556_: type_54;
    var phi_4378_: bool;
    var phi_3557_: type_43;
    var phi_3558_: u32;
    var phi_3559_: bool;
    var phi_3560_: u32;
    var phi_3561_: type_54;
    var phi_4377_: bool;
    var phi_1204_: type_43;
    var phi_1207_: u32;
    var phi_1209_: bool;
    var phi_1211_: u32;
    var phi_1213_: type_54;
    var phi_3562_: bool;
    var phi_4376_: bool;
    var local_10: type_43;
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
    var phi_3638_: type_22;
    var local_11: type_43;
    var local_12: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_7.member));
            let _e96 = arrayLength((&global_1.member));
            let _e104 = arrayLength((&global_6.member));
            let _e108 = global_3.member[0u][0u];
            let _e112 = global_3.member[0u][1u];
            let _e116 = global_3.member[0u][2u];
            let _e120 = global_3.member[0u][3u];
            let _e124 = global_3.member[1u][0u];
            let _e128 = global_3.member[1u][1u];
            let _e132 = global_3.member[1u][2u];
            let _e136 = (_e92.x + (_e92.y * 2097152u));
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e151 = (_e136 < arrayLength((&global_4.member)));
            if _e151 {
                let _e152 = (_e136 < arrayLength((&global_2.member)));
                if _e152 {
                    let _e153 = (_e136 < arrayLength((&global_5.member)));
                    if _e153 {
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e163 = global_4.member[_e136].member.member_2[0u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e136].member.member_2[1u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e136].member.member_2[2u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e136].member.member[0u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e195 = global_4.member[_e136].member.member[1u];
                        let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                        let _e203 = global_4.member[_e136].member.member[2u];
                        let _e205 = (bitcast<u32>(_e203) & 2147483647u);
                        let _e207 = select(_e173, _e165, (_e173 < _e165));
                        let _e209 = select(_e181, _e207, (_e181 < _e207));
                        let _e211 = select(_e189, _e209, (_e189 < _e209));
                        let _e213 = select(_e197, _e211, (_e197 < _e211));
                        let _e215 = select(_e205, _e213, (_e205 < _e213));
                        let _e220 = global_4.member[_e136].member.member_1;
                        let _e221 = bitcast<u32>(_e220);
                        let _e222 = (_e221 & 2147483647u);
                        let _e230 = global_4.member[_e136].member.member_3;
                        let _e231 = bitcast<u32>(_e230);
                        let _e232 = (_e231 & 2147483647u);
                        let _e236 = (((select(_e222, _e215, (_e222 < _e215)) < 2139095040u) && (_e232 <= 2139095040u)) && (_e209 > 0u));
                        if _e236 {
                            let _e239 = (bitcast<u32>(bitcast<f32>(_e209)) & 2147483647u);
                            if (_e239 >= 8388608u) {
                                phi_505_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_505_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                            }
                            let _e253 = phi_505_;
                            phi_506_ = _e253;
                        } else {
                            phi_506_ = 0i;
                        }
                        let _e255 = phi_506_;
                        let _e256 = (_e165 == _e209);
                        if _e256 {
                            phi_516_ = true;
                        } else {
                            phi_516_ = (_e173 == _e209);
                        }
                        let _e259 = phi_516_;
                        let _e260 = select(1u, 0u, _e256);
                        if _e259 {
                            let _e261 = (_e260 + 1u);
                            phi_526_ = _e261;
                            phi_527_ = _e261;
                            phi_529_ = select(true, false, (_e261 == 2u));
                        } else {
                            phi_526_ = u32();
                            phi_527_ = 0u;
                            phi_529_ = true;
                        }
                        let _e265 = phi_526_;
                        let _e267 = phi_527_;
                        let _e269 = phi_529_;
                        if _e269 {
                            phi_534_ = (_e267 + 1u);
                        } else {
                            phi_534_ = 0u;
                        }
                        let _e273 = phi_534_;
                        let _e274 = select(_e265, _e267, _e269);
                        let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                        let _e276 = -(_e255);
                        if (_e276 < -126i) {
                            phi_567_ = -126i;
                        } else {
                            phi_567_ = select(_e276, 127i, (_e276 > 127i));
                        }
                        let _e281 = phi_567_;
                        let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                        let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                        let _e297 = global_4.member[_e136].member.member;
                        let _e298 = (_e274 == 0u);
                        if _e298 {
                            phi_585_ = _e297[0];
                        } else {
                            phi_585_ = _e297[1];
                        }
                        let _e302 = phi_585_;
                        let _e303 = (_e274 == 2u);
                        if _e303 {
                            phi_591_ = _e297[2];
                        } else {
                            phi_591_ = _e302;
                        }
                        let _e306 = phi_591_;
                        let _e307 = bitcast<u32>(_e306);
                        let _e309 = ((_e307 & 2139095040u) != 0u);
                        let _e321 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * select(0.00000011920929f, 1f, _e309));
                        let _e322 = global_4.member[_e136].member.member_2;
                        if _e298 {
                            phi_631_ = _e322[0];
                        } else {
                            phi_631_ = _e322[1];
                        }
                        let _e326 = phi_631_;
                        if _e303 {
                            phi_637_ = _e322[2];
                        } else {
                            phi_637_ = _e326;
                        }
                        let _e329 = phi_637_;
                        let _e330 = bitcast<u32>(_e329);
                        let _e332 = ((_e330 & 2139095040u) != 0u);
                        let _e346 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e329, _e332) * _e286) * select(0.00000011920929f, 1f, _e332)) * _e292);
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e353 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e354 = (_e353 * 0.00000011920929f);
                        let _e357 = select(select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f)), 0f, _e350);
                        let _e358 = select(0f, _e346, _e350);
                        let _e359 = (_e321 + _e357);
                        let _e360 = (_e321 - _e357);
                        let _e362 = select(38685626000000000000000000f, (1f / _e346), _e350);
                        let _e363 = (_e273 == 0u);
                        if _e363 {
                            phi_710_ = _e297[0];
                        } else {
                            phi_710_ = _e297[1];
                        }
                        let _e367 = phi_710_;
                        let _e368 = (_e273 == 2u);
                        if _e368 {
                            phi_716_ = _e297[2];
                        } else {
                            phi_716_ = _e367;
                        }
                        let _e371 = phi_716_;
                        let _e372 = bitcast<u32>(_e371);
                        let _e374 = ((_e372 & 2139095040u) != 0u);
                        let _e386 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e372 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e372 & 2147483648u))), _e371, _e374) * select(0.00000011920929f, 1f, _e374));
                        if _e363 {
                            phi_756_ = _e322[0];
                        } else {
                            phi_756_ = _e322[1];
                        }
                        let _e390 = phi_756_;
                        if _e368 {
                            phi_762_ = _e322[2];
                        } else {
                            phi_762_ = _e390;
                        }
                        let _e393 = phi_762_;
                        let _e394 = bitcast<u32>(_e393);
                        let _e396 = ((_e394 & 2139095040u) != 0u);
                        let _e410 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e394 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e394 & 2147483648u))), _e393, _e396) * _e286) * select(0.00000011920929f, 1f, _e396)) * _e292);
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e417 = bitcast<f32>((bitcast<u32>(_e386) & 2147483647u));
                        let _e418 = (_e417 * 0.00000011920929f);
                        let _e421 = select(select(0.00000000000011368684f, _e418, (_e418 > 0.00000000000011368684f)), 0f, _e414);
                        let _e422 = select(0f, _e410, _e414);
                        let _e423 = (_e386 + _e421);
                        let _e424 = (_e386 - _e421);
                        let _e426 = select(38685626000000000000000000f, (1f / _e410), _e414);
                        let _e427 = (_e275 == 0u);
                        if _e427 {
                            phi_835_ = _e297[0];
                        } else {
                            phi_835_ = _e297[1];
                        }
                        let _e431 = phi_835_;
                        let _e432 = (_e275 == 2u);
                        if _e432 {
                            phi_841_ = _e297[2];
                        } else {
                            phi_841_ = _e431;
                        }
                        let _e435 = phi_841_;
                        let _e436 = bitcast<u32>(_e435);
                        let _e438 = ((_e436 & 2139095040u) != 0u);
                        let _e450 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e436 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e436 & 2147483648u))), _e435, _e438) * select(0.00000011920929f, 1f, _e438));
                        if _e427 {
                            phi_881_ = _e322[0];
                        } else {
                            phi_881_ = _e322[1];
                        }
                        let _e454 = phi_881_;
                        if _e432 {
                            phi_887_ = _e322[2];
                        } else {
                            phi_887_ = _e454;
                        }
                        let _e457 = phi_887_;
                        let _e458 = bitcast<u32>(_e457);
                        let _e460 = ((_e458 & 2139095040u) != 0u);
                        let _e474 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e458 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e458 & 2147483648u))), _e457, _e460) * _e286) * select(0.00000011920929f, 1f, _e460)) * _e292);
                        let _e478 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e481 = bitcast<f32>((bitcast<u32>(_e450) & 2147483647u));
                        let _e482 = (_e481 * 0.00000011920929f);
                        let _e485 = select(select(0.00000000000011368684f, _e482, (_e482 > 0.00000000000011368684f)), 0f, _e478);
                        let _e486 = select(0f, _e474, _e478);
                        let _e487 = (_e450 + _e485);
                        let _e488 = (_e450 - _e485);
                        let _e490 = select(38685626000000000000000000f, (1f / _e474), _e478);
                        let _e492 = select(_e417, _e353, (_e353 > _e417));
                        if (_e236 && (select(_e481, _e492, (_e492 > _e481)) <= 1099511600000f)) {
                            let _e504 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e507 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                            let _e511 = (_e504 == 0u);
                            let _e514 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e504)), 32u, _e511)) - 8i);
                            if (_e507 == 255i) {
                                phi_1006_ = 255i;
                            } else {
                                phi_1006_ = (((_e507 + select(0i, 1i, (_e507 == 0i))) - _e514) + _e255);
                            }
                            let _e522 = phi_1006_;
                            let _e532 = (_e522 <= 0i);
                            if _e532 {
                                phi_1029_ = u32();
                            } else {
                                if _e511 {
                                    phi_1028_ = u32();
                                } else {
                                    phi_1028_ = select(((bitcast<u32>(_e522) << bitcast<u32>(23i)) | ((_e504 << bitcast<u32>(((_e514 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e522 >= 255i));
                                }
                                let _e536 = phi_1028_;
                                phi_1029_ = _e536;
                            }
                            let _e538 = phi_1029_;
                            let _e550 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e553 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                            let _e557 = (_e550 == 0u);
                            let _e560 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e550)), 32u, _e557)) - 8i);
                            if (_e553 == 255i) {
                                phi_1066_ = 255i;
                            } else {
                                phi_1066_ = (((_e553 + select(0i, 1i, (_e553 == 0i))) - _e560) + _e255);
                            }
                            let _e568 = phi_1066_;
                            let _e578 = (_e568 <= 0i);
                            if _e578 {
                                phi_1089_ = u32();
                            } else {
                                if _e557 {
                                    phi_1088_ = u32();
                                } else {
                                    phi_1088_ = select(((bitcast<u32>(_e568) << bitcast<u32>(23i)) | ((_e550 << bitcast<u32>(((_e560 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e568 >= 255i));
                                }
                                let _e582 = phi_1088_;
                                phi_1089_ = _e582;
                            }
                            let _e584 = phi_1089_;
                            phi_1097_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e584, 0u, select(_e557, true, _e578))));
                            phi_1098_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e538, 0u, select(_e511, true, _e532))));
                        } else {
                            phi_1097_ = 0f;
                            phi_1098_ = 1f;
                        }
                        let _e590 = phi_1097_;
                        let _e592 = phi_1098_;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e598 = global_4.member[_e136].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e601 = (_e274 % 3u);
                        let _e602 = (_e601 < 3u);
                        if _e602 {
                        } else {
                            break;
                        }
                        let _e604 = local_1[_e601];
                        let _e607 = (_e273 % 3u);
                        let _e608 = (_e607 < 3u);
                        if _e608 {
                        } else {
                            break;
                        }
                        let _e610 = local_1[_e607];
                        let _e613 = (_e275 % 3u);
                        let _e614 = (_e613 < 3u);
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e616 = local_1[_e613];
                        if _e602 {
                        } else {
                            break;
                        }
                        let _e621 = local[_e601];
                        if _e608 {
                        } else {
                            break;
                        }
                        let _e625 = local[_e607];
                        if _e614 {
                        } else {
                            break;
                        }
                        let _e629 = local[_e613];
                        phi_4217_ = false;
                        phi_1203_ = type_43(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e590), 0u, 0u);
                        phi_1206_ = ((3u * _e94) + 1u);
                        phi_1208_ = (_e592 <= _e590);
                        phi_1210_ = 0u;
                        phi_1212_ = type_54(type_34(vec4<f32>((f32(_e604) * _e148), (f32(_e610) * _e148), (f32(_e616) * _e148), 0f), vec4<f32>((f32(_e621) * _e148), (f32(_e625) * _e148), (f32(_e629) * _e148), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        loop {
                            let _e639 = phi_4217_;
                            let _e641 = phi_1203_;
                            let _e643 = phi_1206_;
                            let _e645 = phi_1208_;
                            let _e647 = phi_1210_;
                            let _e649 = phi_1212_;
                            local_10 = _e641;
                            local_11 = _e641;
                            if _e645 {
                                phi_1223_ = true;
                            } else {
                                phi_1223_ = (_e647 > 0u);
                            }
                            let _e652 = phi_1223_;
                            if _e652 {
                                let _e653 = (_e643 > 0u);
                                if _e653 {
                                    if _e645 {
                                        phi_1309_ = _e645;
                                        phi_1310_ = _e647;
                                        phi_1311_ = _e649;
                                    } else {
                                        let _e654 = (_e647 - 1u);
                                        let _e655 = (_e654 % 128u);
                                        let _e656 = (_e655 < 128u);
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e658 = local_7[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e660 = local_6[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e662 = local_5[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e664 = local_4[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e666 = local_3[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e668 = local_2[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e673 = local_8[_e655];
                                        if _e656 {
                                        } else {
                                            phi_4376_ = true;
                                            break;
                                        }
                                        let _e676 = local_9[_e655];
                                        phi_1309_ = (_e676 <= _e641.member.member_1);
                                        phi_1310_ = _e654;
                                        phi_1311_ = type_54(type_34(vec4<f32>(_e658, _e660, _e662, 0f), vec4<f32>(_e664, _e666, _e668, 0f)), _e673);
                                    }
                                    let _e681 = phi_1309_;
                                    let _e683 = phi_1310_;
                                    let _e685 = phi_1311_;
                                    if _e681 {
                                        let _e689 = ((_e685.member_1 & 2147483648u) != 0u);
                                        if _e689 {
                                            phi_1329_ = _e641;
                                            phi_1332_ = type_7(0u, ((_e685.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e696 = phi_1329_;
                                                let _e698 = phi_1332_;
                                                local_12 = _e696;
                                                if (_e698.member < _e698.member_1) {
                                                    phi_1333_ = type_7((_e698.member + 1u), _e698.member_1);
                                                    phi_1355_ = type_7(1u, _e698.member);
                                                } else {
                                                    phi_1333_ = _e698;
                                                    phi_1355_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e711 = phi_1333_;
                                                let _e713 = phi_1355_;
                                                let _e717 = (bitcast<i32>(_e713.member) != 0i);
                                                if _e717 {
                                                    let _e723 = type_43(_e696.member, _e696.member_1, (_e696.member_2 + 1u));
                                                    let _e724 = ((_e685.member_1 & 268435455u) + _e713.member_1);
                                                    let _e725 = (_e724 < _e96);
                                                    if _e725 {
                                                        if _e725 {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e729 = global_1.member[_e724].member_1;
                                                        phi_1379_ = _e729;
                                                    } else {
                                                        phi_1379_ = 4294967295u;
                                                    }
                                                    let _e731 = phi_1379_;
                                                    if (_e724 >= _e96) {
                                                        phi_1471_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e725 {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        if (_e601 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e738 = global_1.member[_e724].member[_e601];
                                                        if (_e607 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e744 = global_1.member[_e724].member[_e607];
                                                        if (_e613 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e750 = global_1.member[_e724].member[_e613];
                                                        let _e752 = (3u + _e601);
                                                        if (_e752 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e758 = global_1.member[_e724].member[_e752];
                                                        let _e759 = (3u + _e607);
                                                        if (_e759 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_1.member[_e724].member[_e759];
                                                        let _e766 = (3u + _e613);
                                                        if (_e766 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e772 = global_1.member[_e724].member[_e766];
                                                        let _e774 = (6u + _e601);
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_1.member[_e724].member[_e774];
                                                        let _e781 = (6u + _e607);
                                                        if (_e781 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e787 = global_1.member[_e724].member[_e781];
                                                        let _e788 = (6u + _e613);
                                                        if (_e788 < 9u) {
                                                        } else {
                                                            phi_4211_ = true;
                                                            break;
                                                        }
                                                        let _e794 = global_1.member[_e724].member[_e788];
                                                        phi_1471_ = array<array<f32, 3>, 3>(array<f32, 3>(_e738, _e744, _e750), array<f32, 3>(_e758, _e765, _e772), array<f32, 3>(_e780, _e787, _e794));
                                                    }
                                                    let _e798 = phi_1471_;
                                                    let _e815 = (_e798[0][2] - _e450);
                                                    let _e818 = (((_e798[0][0] - _e321) * _e486) - (_e815 * _e358));
                                                    let _e821 = (((_e798[0][1] - _e386) * _e486) - (_e815 * _e422));
                                                    let _e824 = (_e798[1][2] - _e450);
                                                    let _e827 = (((_e798[1][0] - _e321) * _e486) - (_e824 * _e358));
                                                    let _e830 = (((_e798[1][1] - _e386) * _e486) - (_e824 * _e422));
                                                    let _e833 = (_e798[2][2] - _e450);
                                                    let _e836 = (((_e798[2][0] - _e321) * _e486) - (_e833 * _e358));
                                                    let _e839 = (((_e798[2][1] - _e386) * _e486) - (_e833 * _e422));
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
                                                        let _e874 = select(_e798[1][0], _e798[0][0], (_e798[0][0] < _e798[1][0]));
                                                        let _e878 = select(_e798[1][0], _e798[0][0], (_e798[0][0] > _e798[1][0]));
                                                        let _e882 = select(_e798[1][1], _e798[0][1], (_e798[0][1] < _e798[1][1]));
                                                        let _e886 = select(_e798[1][1], _e798[0][1], (_e798[0][1] > _e798[1][1]));
                                                        let _e890 = select(_e798[1][2], _e798[0][2], (_e798[0][2] < _e798[1][2]));
                                                        let _e894 = select(_e798[1][2], _e798[0][2], (_e798[0][2] > _e798[1][2]));
                                                        let _e899 = ((select(_e798[2][0], _e874, (_e874 < _e798[2][0])) - _e359) * _e362);
                                                        let _e900 = ((select(_e798[2][0], _e878, (_e878 > _e798[2][0])) - _e360) * _e362);
                                                        let _e903 = ((select(_e798[2][1], _e882, (_e882 < _e798[2][1])) - _e423) * _e426);
                                                        let _e904 = ((select(_e798[2][1], _e886, (_e886 > _e798[2][1])) - _e424) * _e426);
                                                        let _e907 = ((select(_e798[2][2], _e890, (_e890 < _e798[2][2])) - _e487) * _e490);
                                                        let _e908 = ((select(_e798[2][2], _e894, (_e894 > _e798[2][2])) - _e488) * _e490);
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
                                                        let _e935 = select(_e592, _e920, (_e920 > _e592));
                                                        let _e939 = select(_e827, _e818, (_e818 < _e827));
                                                        let _e944 = select(_e827, _e818, (_e818 > _e827));
                                                        let _e951 = select(_e830, _e821, (_e821 < _e830));
                                                        let _e956 = select(_e830, _e821, (_e821 > _e830));
                                                        let _e965 = (((((_e856 && (_e872 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e836, _e939, (_e939 < _e836)) <= 0f) && (select(_e836, _e944, (_e944 > _e836)) >= 0f))) && ((select(_e839, _e951, (_e951 < _e839)) <= 0f) && (select(_e839, _e956, (_e956 > _e839)) >= 0f))) && (_e935 <= (_e928 + (select(_e929, _e912, (_e912 > _e929)) * 0.0000019073523f)))) && (_e935 <= _e696.member.member_1));
                                                        if _e965 {
                                                            let _e970 = (_e798[1][0] - _e798[0][0]);
                                                            let _e971 = (_e798[1][1] - _e798[0][1]);
                                                            let _e972 = (_e798[1][2] - _e798[0][2]);
                                                            let _e973 = vec3<f32>(_e970, _e971, _e972);
                                                            let _e974 = (_e798[2][0] - _e798[1][0]);
                                                            let _e975 = (_e798[2][1] - _e798[1][1]);
                                                            let _e976 = (_e798[2][2] - _e798[1][2]);
                                                            let _e977 = vec3<f32>(_e974, _e975, _e976);
                                                            let _e978 = (_e798[0][0] - _e798[2][0]);
                                                            let _e979 = (_e798[0][1] - _e798[2][1]);
                                                            let _e980 = (_e798[0][2] - _e798[2][2]);
                                                            let _e981 = vec3<f32>(_e978, _e979, _e980);
                                                            let _e982 = abs(_e970);
                                                            let _e983 = abs(_e971);
                                                            if (_e982 != _e982) {
                                                                phi_3778_ = true;
                                                            } else {
                                                                phi_3778_ = (_e983 >= _e982);
                                                            }
                                                            let _e987 = phi_3778_;
                                                            let _e988 = select(_e982, _e983, _e987);
                                                            let _e989 = abs(_e972);
                                                            if (_e988 != _e988) {
                                                                phi_3793_ = true;
                                                            } else {
                                                                phi_3793_ = (_e989 >= _e988);
                                                            }
                                                            let _e993 = phi_3793_;
                                                            let _e994 = select(_e988, _e989, _e993);
                                                            let _e995 = abs(_e974);
                                                            let _e996 = abs(_e975);
                                                            if (_e995 != _e995) {
                                                                phi_3808_ = true;
                                                            } else {
                                                                phi_3808_ = (_e996 >= _e995);
                                                            }
                                                            let _e1000 = phi_3808_;
                                                            let _e1001 = select(_e995, _e996, _e1000);
                                                            let _e1002 = abs(_e976);
                                                            if (_e1001 != _e1001) {
                                                                phi_3823_ = true;
                                                            } else {
                                                                phi_3823_ = (_e1002 >= _e1001);
                                                            }
                                                            let _e1006 = phi_3823_;
                                                            let _e1007 = select(_e1001, _e1002, _e1006);
                                                            let _e1008 = abs(_e978);
                                                            let _e1009 = abs(_e979);
                                                            if (_e1008 != _e1008) {
                                                                phi_3838_ = true;
                                                            } else {
                                                                phi_3838_ = (_e1009 >= _e1008);
                                                            }
                                                            let _e1013 = phi_3838_;
                                                            let _e1014 = select(_e1008, _e1009, _e1013);
                                                            let _e1015 = abs(_e980);
                                                            if (_e1014 != _e1014) {
                                                                phi_3853_ = true;
                                                            } else {
                                                                phi_3853_ = (_e1015 >= _e1014);
                                                            }
                                                            let _e1019 = phi_3853_;
                                                            let _e1020 = select(_e1014, _e1015, _e1019);
                                                            let _e1022 = select(_e1007, _e994, (_e994 > _e1007));
                                                            let _e1024 = select(_e1020, _e1022, (_e1022 > _e1020));
                                                            if (_e994 == _e1024) {
                                                                phi_2013_ = _e830;
                                                                phi_2014_ = _e827;
                                                                phi_2015_ = _e821;
                                                                phi_2016_ = _e818;
                                                                phi_2017_ = vec3<f32>(_e798[0][0], _e798[0][1], _e798[0][2]);
                                                                phi_2018_ = _e981;
                                                                phi_2019_ = _e977;
                                                                phi_2020_ = _e973;
                                                            } else {
                                                                let _e1026 = (_e1007 == _e1024);
                                                                let _e1031 = vec3(_e1026);
                                                                phi_2013_ = select(_e821, _e839, _e1026);
                                                                phi_2014_ = select(_e818, _e836, _e1026);
                                                                phi_2015_ = select(_e839, _e830, _e1026);
                                                                phi_2016_ = select(_e836, _e827, _e1026);
                                                                phi_2017_ = select(vec3<f32>(_e798[2][0], _e798[2][1], _e798[2][2]), vec3<f32>(_e798[1][0], _e798[1][1], _e798[1][2]), _e1031);
                                                                phi_2018_ = select(_e977, _e973, _e1031);
                                                                phi_2019_ = select(_e973, _e981, _e1031);
                                                                phi_2020_ = select(_e981, _e977, _e1031);
                                                            }
                                                            let _e1037 = phi_2013_;
                                                            let _e1039 = phi_2014_;
                                                            let _e1041 = phi_2015_;
                                                            let _e1043 = phi_2016_;
                                                            let _e1045 = phi_2017_;
                                                            let _e1047 = phi_2018_;
                                                            let _e1049 = phi_2019_;
                                                            let _e1051 = phi_2020_;
                                                            let _e1058 = ((_e1049.y * _e1047.z) - (_e1047.y * _e1049.z));
                                                            let _e1063 = ((_e1049.z * _e1047.x) - (_e1047.z * _e1049.x));
                                                            let _e1066 = ((_e1049.x * _e1047.y) - (_e1047.x * _e1049.y));
                                                            let _e1069 = ((_e862 >= _e866) && (_e862 >= _e870));
                                                            let _e1070 = (_e866 >= _e870);
                                                            let _e1084 = (((_e1058 * (select(select(_e798[2][0], _e798[1][0], _e1070), _e798[0][0], _e1069) - _e321)) + (_e1063 * (select(select(_e798[2][1], _e798[1][1], _e1070), _e798[0][1], _e1069) - _e386))) + (_e1066 * (select(select(_e798[2][2], _e798[1][2], _e1070), _e798[0][2], _e1069) - _e450)));
                                                            let _e1089 = (((_e1058 * _e358) + (_e1063 * _e422)) + (_e1066 * _e486));
                                                            let _e1090 = (_e1039 - _e1043);
                                                            let _e1091 = (_e1037 - _e1041);
                                                            let _e1094 = ((_e1090 * _e1090) + (_e1091 * _e1091));
                                                            let _e1101 = (-(((_e1043 * _e1090) + (_e1041 * _e1091))) / select(0.000000000000000000000000000000000000011754944f, _e1094, (_e1094 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1103 = select(1f, _e1101, (_e1101 < 1f));
                                                            let _e1105 = select(0f, _e1103, (_e1103 > 0f));
                                                            let _e1114 = ((_e1045.x + (_e1051.x * _e1105)) - _e321);
                                                            let _e1117 = ((_e1045.y + (_e1051.y * _e1105)) - _e386);
                                                            let _e1120 = ((_e1045.z + (_e1051.z * _e1105)) - _e450);
                                                            let _e1123 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                            let _e1126 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                            let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                            let _e1131 = bitcast<f32>((bitcast<u32>(_e1120) & 2147483647u));
                                                            let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                                                            let _e1137 = abs(_e1058);
                                                            let _e1138 = abs(_e1063);
                                                            if (_e1137 != _e1137) {
                                                                phi_3868_ = true;
                                                            } else {
                                                                phi_3868_ = (_e1138 >= _e1137);
                                                            }
                                                            let _e1142 = phi_3868_;
                                                            let _e1143 = select(_e1137, _e1138, _e1142);
                                                            let _e1144 = abs(_e1066);
                                                            if (_e1143 != _e1143) {
                                                                phi_3883_ = true;
                                                            } else {
                                                                phi_3883_ = (_e1144 >= _e1143);
                                                            }
                                                            let _e1148 = phi_3883_;
                                                            let _e1164 = abs(_e1049.x);
                                                            let _e1165 = abs(_e1049.y);
                                                            if (_e1164 != _e1164) {
                                                                phi_3898_ = true;
                                                            } else {
                                                                phi_3898_ = (_e1165 >= _e1164);
                                                            }
                                                            let _e1169 = phi_3898_;
                                                            let _e1170 = select(_e1164, _e1165, _e1169);
                                                            let _e1171 = abs(_e1049.z);
                                                            if (_e1170 != _e1170) {
                                                                phi_3913_ = true;
                                                            } else {
                                                                phi_3913_ = (_e1171 >= _e1170);
                                                            }
                                                            let _e1175 = phi_3913_;
                                                            let _e1178 = abs(_e1047.x);
                                                            let _e1179 = abs(_e1047.y);
                                                            if (_e1178 != _e1178) {
                                                                phi_3928_ = true;
                                                            } else {
                                                                phi_3928_ = (_e1179 >= _e1178);
                                                            }
                                                            let _e1183 = phi_3928_;
                                                            let _e1184 = select(_e1178, _e1179, _e1183);
                                                            let _e1185 = abs(_e1047.z);
                                                            if (_e1184 != _e1184) {
                                                                phi_3943_ = true;
                                                            } else {
                                                                phi_3943_ = (_e1185 >= _e1184);
                                                            }
                                                            let _e1189 = phi_3943_;
                                                            let _e1194 = ((bitcast<f32>((bitcast<u32>(((((_e1058 * _e1114) + (_e1063 * _e1117)) + (_e1066 * _e1120)) - _e1084)) & 2147483647u)) <= ((0.0000009536743f * select(_e1024, _e1133, (_e1133 > _e1024))) * select(_e1143, _e1144, _e1148))) && !((bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u)) <= ((0.0000038146973f * select(_e1170, _e1171, _e1175)) * select(_e1184, _e1185, _e1189)))));
                                                            let _e1195 = (_e1084 / _e1089);
                                                            if (_e965 && !(_e1194)) {
                                                                let _e1198 = (_e1120 / _e486);
                                                                let _e1206 = (((_e1058 * (_e1114 - (_e358 * _e1198))) + (_e1063 * (_e1117 - (_e422 * _e1198)))) / _e1089);
                                                                phi_2228_ = select(select(_e1198, (_e1198 + _e1206), (bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u)) <= _e1024)), _e1195, _e1194);
                                                            } else {
                                                                phi_2228_ = _e1195;
                                                            }
                                                            let _e1215 = phi_2228_;
                                                            let _e1217 = select(_e928, _e1215, (_e1215 < _e928));
                                                            let _e1219 = select(_e920, _e1217, (_e1217 > _e920));
                                                            let _e1220 = (1f / _e872);
                                                            phi_2248_ = type_42(_e1219, (_e866 * _e1220), (_e870 * _e1220), ((_e965 && (_e1219 >= _e592)) && (_e1219 <= _e696.member.member_1)));
                                                            phi_2249_ = type_42();
                                                        } else {
                                                            phi_2248_ = type_42();
                                                            phi_2249_ = type_42(0f, 0f, 0f, _e965);
                                                        }
                                                        let _e1229 = phi_2248_;
                                                        let _e1231 = phi_2249_;
                                                        phi_2252_ = _e1229;
                                                        phi_2253_ = _e1231;
                                                        phi_2254_ = select(true, false, _e965);
                                                    } else {
                                                        phi_2252_ = type_42();
                                                        phi_2253_ = type_42(0f, 0f, 0f, _e856);
                                                        phi_2254_ = true;
                                                    }
                                                    let _e1234 = phi_2252_;
                                                    let _e1236 = phi_2253_;
                                                    let _e1238 = phi_2254_;
                                                    if _e1238 {
                                                        phi_2258_ = _e1236;
                                                    } else {
                                                        phi_2258_ = _e1234;
                                                    }
                                                    let _e1240 = phi_2258_;
                                                    if _e1240.member_3 {
                                                        phi_2267_ = type_22(_e1240.member, _e1240.member_1, _e1240.member_2, _e731);
                                                    } else {
                                                        phi_2267_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1247 = phi_2267_;
                                                    if (_e1247.member_3 != 4294967295u) {
                                                        if (_e731 != _e598) {
                                                            if (_e1247.member < _e696.member.member.member) {
                                                                phi_2293_ = true;
                                                            } else {
                                                                if (_e1247.member == _e696.member.member.member) {
                                                                    phi_2292_ = (_e1247.member_3 < _e696.member.member.member_3);
                                                                } else {
                                                                    phi_2292_ = false;
                                                                }
                                                                let _e1262 = phi_2292_;
                                                                phi_2293_ = _e1262;
                                                            }
                                                            let _e1264 = phi_2293_;
                                                            if _e1264 {
                                                                phi_2300_ = type_43(type_39(_e1247, _e1247.member), _e723.member_1, _e723.member_2);
                                                            } else {
                                                                phi_2300_ = _e723;
                                                            }
                                                            let _e1271 = phi_2300_;
                                                            phi_2301_ = _e1271;
                                                        } else {
                                                            phi_2301_ = _e723;
                                                        }
                                                        let _e1273 = phi_2301_;
                                                        phi_2302_ = _e1273;
                                                    } else {
                                                        phi_2302_ = _e723;
                                                    }
                                                    let _e1275 = phi_2302_;
                                                    phi_1330_ = _e1275;
                                                } else {
                                                    phi_1330_ = type_43();
                                                }
                                                let _e1277 = phi_1330_;
                                                continue;
                                                continuing {
                                                    phi_1329_ = _e1277;
                                                    phi_1332_ = _e711;
                                                    phi_4211_ = _e639;
                                                    break if !(_e717);
                                                }
                                            }
                                            let _e1280 = phi_4211_;
                                            phi_4376_ = _e1280;
                                            if _e1280 {
                                                break;
                                            }
                                            phi_4462_ = _e1280;
                                            let _e2055 = local_12;
                                            phi_2303_ = _e2055;
                                        } else {
                                            phi_4462_ = _e639;
                                            phi_2303_ = _e641;
                                        }
                                        let _e1282 = phi_4462_;
                                        let _e1284 = phi_2303_;
                                        if _e689 {
                                            phi_3537_ = type_43();
                                            phi_3538_ = bool();
                                            phi_3539_ = u32();
                                            phi_3540_ = type_54();
                                        } else {
                                            if (_e685.member_1 >= _e94) {
                                                phi_3069_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e685.member_1 < _e94) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1287 = (_e274 * 2u);
                                                let _e1289 = ((1u + _e1287) % 7u);
                                                if (_e1289 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1294 = global_7.member[_e685.member_1][_e1289];
                                                let _e1296 = ((_e1287 + 2u) % 7u);
                                                if (_e1296 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1301 = global_7.member[_e685.member_1][_e1296];
                                                let _e1302 = (_e273 * 2u);
                                                let _e1304 = ((1u + _e1302) % 7u);
                                                if (_e1304 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1309 = global_7.member[_e685.member_1][_e1304];
                                                let _e1311 = ((_e1302 + 2u) % 7u);
                                                if (_e1311 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1316 = global_7.member[_e685.member_1][_e1311];
                                                let _e1317 = (_e275 * 2u);
                                                let _e1319 = ((1u + _e1317) % 7u);
                                                if (_e1319 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1324 = global_7.member[_e685.member_1][_e1319];
                                                let _e1326 = ((_e1317 + 2u) % 7u);
                                                if (_e1326 < 7u) {
                                                } else {
                                                    phi_4376_ = true;
                                                    break;
                                                }
                                                let _e1331 = global_7.member[_e685.member_1][_e1326];
                                                let _e1354 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.x - _e685.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1355 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.y - _e685.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1356 = (bitcast<f32>((bitcast<u32>((_e685.member.member_1.z - _e685.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1358 = select(_e148, _e1354, (_e1354 > _e148));
                                                let _e1360 = select(_e148, _e1355, (_e1355 > _e148));
                                                let _e1362 = select(_e148, _e1356, (_e1356 > _e148));
                                                let _e1393 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1294 & 2097151u))) - 8388608f) * _e1358));
                                                let _e1398 = (bitcast<i32>((_e1294 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1401 = bitcast<f32>((_e1393 & bitcast<u32>(_e1398)));
                                                let _e1402 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1309 & 2097151u))) - 8388608f) * _e1360));
                                                let _e1407 = (bitcast<i32>((_e1309 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1410 = bitcast<f32>((_e1402 & bitcast<u32>(_e1407)));
                                                let _e1411 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1324 & 2097151u))) - 8388608f) * _e1362));
                                                let _e1416 = (bitcast<i32>((_e1324 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1419 = bitcast<f32>((_e1411 & bitcast<u32>(_e1416)));
                                                let _e1423 = bitcast<f32>((_e1393 & bitcast<u32>(~(_e1398))));
                                                let _e1427 = bitcast<f32>((_e1402 & bitcast<u32>(~(_e1407))));
                                                let _e1431 = bitcast<f32>((_e1411 & bitcast<u32>(~(_e1416))));
                                                let _e1432 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1301 & 2097151u))) - 8388608f) * _e1358));
                                                let _e1437 = (bitcast<i32>((_e1301 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1440 = bitcast<f32>((_e1432 & bitcast<u32>(_e1437)));
                                                let _e1441 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1316 & 2097151u))) - 8388608f) * _e1360));
                                                let _e1446 = (bitcast<i32>((_e1316 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1449 = bitcast<f32>((_e1441 & bitcast<u32>(_e1446)));
                                                let _e1450 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1331 & 2097151u))) - 8388608f) * _e1362));
                                                let _e1455 = (bitcast<i32>((_e1331 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1458 = bitcast<f32>((_e1450 & bitcast<u32>(_e1455)));
                                                let _e1462 = bitcast<f32>((_e1432 & bitcast<u32>(~(_e1437))));
                                                let _e1466 = bitcast<f32>((_e1441 & bitcast<u32>(~(_e1446))));
                                                let _e1470 = bitcast<f32>((_e1450 & bitcast<u32>(~(_e1455))));
                                                let _e1500 = global_7.member[_e685.member_1][0u];
                                                let _e1504 = global_7.member[_e685.member_1][2u];
                                                let _e1508 = global_7.member[_e685.member_1][4u];
                                                let _e1512 = global_7.member[_e685.member_1][6u];
                                                let _e1524 = (((_e1504 >> bitcast<u32>(22i)) | ((_e1508 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1512 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1525 = (_e1500 & 268435455u);
                                                let _e1526 = (_e1524 & 268435455u);
                                                let _e1529 = ((_e1500 >> bitcast<u32>(28u)) & 7u);
                                                let _e1537 = ((_e1500 >> bitcast<u32>(31i)) | (((_e1524 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1538 = (_e1529 != 0u);
                                                if (_e1529 == 0u) {
                                                    phi_3031_ = _e1525;
                                                } else {
                                                    if (_e1529 == 7u) {
                                                        phi_3030_ = 2147483648u;
                                                    } else {
                                                        phi_3030_ = ((2147483648u | (_e1529 << bitcast<u32>(28u))) | (_e1526 & 268435455u));
                                                    }
                                                    let _e1547 = phi_3030_;
                                                    phi_3031_ = _e1547;
                                                }
                                                let _e1549 = phi_3031_;
                                                if _e1538 {
                                                    let _e1550 = (_e1529 != 7u);
                                                    if _e1550 {
                                                        phi_3041_ = (_e1526 + _e1529);
                                                    } else {
                                                        phi_3041_ = u32();
                                                    }
                                                    let _e1553 = phi_3041_;
                                                    phi_3043_ = _e1553;
                                                    phi_3044_ = select(true, false, _e1550);
                                                } else {
                                                    phi_3043_ = u32();
                                                    phi_3044_ = true;
                                                }
                                                let _e1556 = phi_3043_;
                                                let _e1558 = phi_3044_;
                                                if (_e1537 == 0u) {
                                                    phi_3065_ = (_e1525 + select(0u, 1u, !(_e1538)));
                                                } else {
                                                    if (_e1537 == 7u) {
                                                        phi_3064_ = 2147483648u;
                                                    } else {
                                                        phi_3064_ = ((2147483648u | (_e1537 << bitcast<u32>(28u))) | (select(_e1556, _e1526, _e1558) & 268435455u));
                                                    }
                                                    let _e1571 = phi_3064_;
                                                    phi_3065_ = _e1571;
                                                }
                                                let _e1573 = phi_3065_;
                                                phi_3069_ = type_55(array<vec4<f32>, 3>(vec4<f32>((_e685.member.member.x + _e1401), (_e685.member.member.x + _e1423), (_e685.member.member_1.x - _e1440), (_e685.member.member_1.x - _e1462)), vec4<f32>((_e685.member.member.y + _e1410), (_e685.member.member.y + _e1427), (_e685.member.member_1.y - _e1449), (_e685.member.member_1.y - _e1466)), vec4<f32>((_e685.member.member.z + _e1419), (_e685.member.member.z + _e1431), (_e685.member.member_1.z - _e1458), (_e685.member.member_1.z - _e1470))), type_54(type_34((_e685.member.member + vec4<f32>(_e1401, _e1410, _e1419, 0f)), (_e685.member.member_1 - vec4<f32>(_e1440, _e1449, _e1458, 0f))), _e1549), type_54(type_34((_e685.member.member + vec4<f32>(_e1423, _e1427, _e1431, 0f)), (_e685.member.member_1 - vec4<f32>(_e1462, _e1466, _e1470, 0f))), _e1573));
                                            }
                                            let _e1578 = phi_3069_;
                                            let _e1597 = ((_e1578.member[0].x - _e359) * _e362);
                                            let _e1598 = ((_e1578.member[0].y - _e359) * _e362);
                                            let _e1599 = ((_e1578.member[0].z - _e360) * _e362);
                                            let _e1600 = ((_e1578.member[0].w - _e360) * _e362);
                                            let _e1610 = ((_e1578.member[1].x - _e423) * _e426);
                                            let _e1611 = ((_e1578.member[1].y - _e423) * _e426);
                                            let _e1612 = ((_e1578.member[1].z - _e424) * _e426);
                                            let _e1613 = ((_e1578.member[1].w - _e424) * _e426);
                                            let _e1623 = ((_e1578.member[2].x - _e487) * _e490);
                                            let _e1624 = ((_e1578.member[2].y - _e487) * _e490);
                                            let _e1625 = ((_e1578.member[2].z - _e488) * _e490);
                                            let _e1626 = ((_e1578.member[2].w - _e488) * _e490);
                                            let _e1628 = select(_e1625, _e1623, (_e1623 < _e1625));
                                            let _e1630 = select(_e1626, _e1624, (_e1624 < _e1626));
                                            let _e1632 = select(_e1625, _e1623, (_e1623 > _e1625));
                                            let _e1634 = select(_e1626, _e1624, (_e1624 > _e1626));
                                            let _e1636 = select(_e1599, _e1597, (_e1597 < _e1599));
                                            let _e1638 = select(_e1600, _e1598, (_e1598 < _e1600));
                                            let _e1640 = select(_e1612, _e1610, (_e1610 < _e1612));
                                            let _e1642 = select(_e1613, _e1611, (_e1611 < _e1613));
                                            let _e1644 = select(_e1640, _e1636, (_e1636 > _e1640));
                                            let _e1646 = select(_e1642, _e1638, (_e1638 > _e1642));
                                            let _e1648 = select(_e1628, _e1644, (_e1644 > _e1628));
                                            let _e1650 = select(_e1630, _e1646, (_e1646 > _e1630));
                                            let _e1652 = select(_e1599, _e1597, (_e1597 > _e1599));
                                            let _e1654 = select(_e1600, _e1598, (_e1598 > _e1600));
                                            let _e1656 = select(_e1612, _e1610, (_e1610 > _e1612));
                                            let _e1658 = select(_e1613, _e1611, (_e1611 > _e1613));
                                            let _e1660 = select(_e1656, _e1652, (_e1652 < _e1656));
                                            let _e1662 = select(_e1658, _e1654, (_e1654 < _e1658));
                                            let _e1667 = -(_e1628);
                                            let _e1668 = -(_e1630);
                                            let _e1675 = (select(_e1632, _e1660, (_e1660 < _e1632)) + (select(_e1667, _e1632, (_e1632 > _e1667)) * 0.0000019073523f));
                                            let _e1676 = (select(_e1634, _e1662, (_e1662 < _e1634)) + (select(_e1668, _e1634, (_e1634 > _e1668)) * 0.0000019073523f));
                                            let _e1678 = select(_e592, _e1648, (_e1648 > _e592));
                                            let _e1680 = select(_e592, _e1650, (_e1650 > _e592));
                                            let _e1685 = (_e1678 <= select(_e1284.member.member_1, _e1675, (_e1675 < _e1284.member.member_1)));
                                            let _e1686 = (_e1680 <= select(_e1284.member.member_1, _e1676, (_e1676 < _e1284.member.member_1)));
                                            let _e1687 = (_e1678 <= _e1680);
                                            if _e1685 {
                                                if _e1686 {
                                                    if _e1687 {
                                                        phi_3434_ = _e1578.member_2;
                                                    } else {
                                                        phi_3434_ = _e1578.member_1;
                                                    }
                                                    let _e1691 = phi_3434_;
                                                    let _e1712 = (_e683 % 128u);
                                                    let _e1713 = (_e1712 < 128u);
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1712] = _e1691.member_1;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1712] = _e1691.member.member.x;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1712] = _e1691.member.member.y;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1712] = _e1691.member.member.z;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1712] = _e1691.member.member_1.x;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1712] = _e1691.member.member_1.y;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1712] = _e1691.member.member_1.z;
                                                    if _e1713 {
                                                    } else {
                                                        phi_4376_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1712] = select(_e1678, _e1680, _e1687);
                                                    if _e1687 {
                                                        phi_3510_ = _e1578.member_1;
                                                    } else {
                                                        phi_3510_ = _e1578.member_2;
                                                    }
                                                    let _e1726 = phi_3510_;
                                                    phi_3511_ = (_e683 + 1u);
                                                    phi_3512_ = _e1726;
                                                } else {
                                                    phi_3511_ = u32();
                                                    phi_3512_ = type_54();
                                                }
                                                let _e1728 = phi_3511_;
                                                let _e1730 = phi_3512_;
                                                phi_3514_ = _e1728;
                                                phi_3515_ = _e1730;
                                                phi_3516_ = select(true, false, _e1686);
                                            } else {
                                                phi_3514_ = u32();
                                                phi_3515_ = type_54();
                                                phi_3516_ = true;
                                            }
                                            let _e1733 = phi_3514_;
                                            let _e1735 = phi_3515_;
                                            let _e1737 = phi_3516_;
                                            if _e1737 {
                                                if _e1685 {
                                                    phi_3525_ = _e1578.member_1;
                                                } else {
                                                    phi_3525_ = _e1578.member_2;
                                                }
                                                let _e1741 = phi_3525_;
                                                phi_3530_ = select(_e1686, true, _e1685);
                                                phi_3532_ = _e1741;
                                            } else {
                                                phi_3530_ = _e681;
                                                phi_3532_ = _e1735;
                                            }
                                            let _e1744 = phi_3530_;
                                            let _e1746 = phi_3532_;
                                            phi_3537_ = type_43(_e1284.member, (_e1284.member_1 + 1u), _e1284.member_2);
                                            phi_3538_ = _e1744;
                                            phi_3539_ = select(_e1733, _e683, _e1737);
                                            phi_3540_ = _e1746;
                                        }
                                        let _e1749 = phi_3537_;
                                        let _e1751 = phi_3538_;
                                        let _e1753 = phi_3539_;
                                        let _e1755 = phi_3540_;
                                        if _e689 {
                                            phi_3548_ = _e1284;
                                            phi_3551_ = _e685;
                                        } else {
                                            phi_3548_ = _e1749;
                                            phi_3551_ = _e1755;
                                        }
                                        let _e1757 = phi_3548_;
                                        let _e1759 = phi_3551_;
                                        phi_4379_ = _e1282;
                                        phi_3552_ = _e1757;
                                        phi_3553_ = (_e643 - 1u);
                                        phi_3554_ = select(_e1751, false, _e689);
                                        phi_3555_ = select(_e1753, _e683, _e689);
                                        phi_3556_ = _e1759;
                                    } else {
                                        phi_4379_ = _e639;
                                        phi_3552_ = _e641;
                                        phi_3553_ = _e643;
                                        phi_3554_ = _e681;
                                        phi_3555_ = _e683;
                                        phi_3556_ = _e685;
                                    }
                                    let _e1763 = phi_4379_;
                                    let _e1765 = phi_3552_;
                                    let _e1767 = phi_3553_;
                                    let _e1769 = phi_3554_;
                                    let _e1771 = phi_3555_;
                                    let _e1773 = phi_3556_;
                                    phi_4378_ = _e1763;
                                    phi_3557_ = _e1765;
                                    phi_3558_ = _e1767;
                                    phi_3559_ = _e1769;
                                    phi_3560_ = _e1771;
                                    phi_3561_ = _e1773;
                                } else {
                                    phi_4378_ = _e639;
                                    phi_3557_ = type_43();
                                    phi_3558_ = u32();
                                    phi_3559_ = bool();
                                    phi_3560_ = u32();
                                    phi_3561_ = type_54();
                                }
                                let _e1775 = phi_4378_;
                                let _e1777 = phi_3557_;
                                let _e1779 = phi_3558_;
                                let _e1781 = phi_3559_;
                                let _e1783 = phi_3560_;
                                let _e1785 = phi_3561_;
                                phi_4377_ = _e1775;
                                phi_1204_ = _e1777;
                                phi_1207_ = _e1779;
                                phi_1209_ = _e1781;
                                phi_1211_ = _e1783;
                                phi_1213_ = _e1785;
                                phi_3562_ = _e653;
                            } else {
                                phi_4377_ = _e639;
                                phi_1204_ = type_43();
                                phi_1207_ = u32();
                                phi_1209_ = bool();
                                phi_1211_ = u32();
                                phi_1213_ = type_54();
                                phi_3562_ = false;
                            }
                            let _e1787 = phi_4377_;
                            let _e1789 = phi_1204_;
                            let _e1791 = phi_1207_;
                            let _e1793 = phi_1209_;
                            let _e1795 = phi_1211_;
                            let _e1797 = phi_1213_;
                            let _e1799 = phi_3562_;
                            continue;
                            continuing {
                                phi_4217_ = _e1787;
                                phi_1203_ = _e1789;
                                phi_1206_ = _e1791;
                                phi_1208_ = _e1793;
                                phi_1210_ = _e1795;
                                phi_1212_ = _e1797;
                                phi_4376_ = _e1787;
                                break if !(_e1799);
                            }
                        }
                        let _e1802 = phi_4376_;
                        if _e1802 {
                            break;
                        }
                        let _e1804 = local_10;
                        if (_e1804.member.member.member_3 != 4294967295u) {
                            let _e1810 = bitcast<u32>(_e1804.member.member.member);
                            let _e1814 = (bitcast<i32>((_e1810 >> bitcast<u32>(23i))) & 255i);
                            let _e1815 = (_e1814 + _e276);
                            if (_e1814 == 255i) {
                                phi_3621_ = _e1804.member.member.member;
                            } else {
                                if (_e1814 > 0i) {
                                    if (_e1815 > 0i) {
                                        let _e1819 = (_e1815 < 255i);
                                        if _e1819 {
                                            phi_3600_ = bitcast<f32>((_e1810 + bitcast<u32>((_e276 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3600_ = f32();
                                        }
                                        let _e1826 = phi_3600_;
                                        phi_3602_ = _e1826;
                                        phi_3603_ = select(true, false, _e1819);
                                    } else {
                                        phi_3602_ = f32();
                                        phi_3603_ = true;
                                    }
                                    let _e1829 = phi_3602_;
                                    let _e1831 = phi_3603_;
                                    phi_3604_ = _e1829;
                                    phi_3605_ = _e1831;
                                } else {
                                    phi_3604_ = f32();
                                    phi_3605_ = true;
                                }
                                let _e1833 = phi_3604_;
                                let _e1835 = phi_3605_;
                                if _e1835 {
                                    let _e1836 = (_e1810 & 2147483648u);
                                    let _e1843 = ((_e1810 & 8388607u) | (select(0u, 1u, ((_e1810 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1847 = (_e1843 == 0u);
                                    if _e1847 {
                                        phi_4169_ = bitcast<f32>(_e1836);
                                    } else {
                                        let _e1852 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1843)), 32u, _e1847) - 8u);
                                        let _e1855 = (_e1843 << bitcast<u32>((_e1852 & 31u)));
                                        let _e1857 = ((_e1815 + select(0i, 1i, (_e1814 == 0i))) - bitcast<i32>(_e1852));
                                        if (_e1857 >= 255i) {
                                            phi_4159_ = bitcast<f32>((_e1836 | 2139095040u));
                                            phi_4160_ = f32();
                                            phi_4161_ = true;
                                        } else {
                                            let _e1859 = (_e1857 > 0i);
                                            if _e1859 {
                                                phi_4153_ = bitcast<f32>(((_e1836 | (bitcast<u32>(_e1857) << bitcast<u32>(23i))) | (_e1855 & 8388607u)));
                                                phi_4154_ = f32();
                                            } else {
                                                if (_e1857 < -24i) {
                                                    phi_4119_ = 26u;
                                                } else {
                                                    phi_4119_ = bitcast<u32>((1i - _e1857));
                                                }
                                                let _e1864 = phi_4119_;
                                                let _e1865 = (_e1864 & 31u);
                                                let _e1867 = (_e1855 >> bitcast<u32>(_e1865));
                                                let _e1871 = (_e1855 & ((1u << bitcast<u32>(_e1865)) - 1u));
                                                let _e1875 = (1u << bitcast<u32>(((_e1864 - 1u) & 31u)));
                                                if (_e1871 > _e1875) {
                                                    phi_4140_ = true;
                                                } else {
                                                    if (_e1871 == _e1875) {
                                                        phi_4137_ = ((_e1867 & 1u) == 1u);
                                                    } else {
                                                        phi_4137_ = false;
                                                    }
                                                    let _e1881 = phi_4137_;
                                                    phi_4140_ = _e1881;
                                                }
                                                let _e1883 = phi_4140_;
                                                phi_4153_ = f32();
                                                phi_4154_ = bitcast<f32>((_e1836 | (_e1867 + select(0u, 1u, _e1883))));
                                            }
                                            let _e1896 = phi_4153_;
                                            let _e1898 = phi_4154_;
                                            phi_4159_ = _e1896;
                                            phi_4160_ = _e1898;
                                            phi_4161_ = _e1859;
                                        }
                                        let _e1902 = phi_4159_;
                                        let _e1904 = phi_4160_;
                                        let _e1906 = phi_4161_;
                                        phi_4169_ = select(_e1904, _e1902, _e1906);
                                    }
                                    let _e1910 = phi_4169_;
                                    phi_3620_ = _e1910;
                                } else {
                                    phi_3620_ = _e1833;
                                }
                                let _e1912 = phi_3620_;
                                phi_3621_ = _e1912;
                            }
                            let _e1914 = phi_3621_;
                            let _e1915 = bitcast<u32>(_e1914);
                            if ((_e1915 & 2147483647u) >= 2139095040u) {
                                phi_3633_ = bitcast<f32>(((_e1915 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3633_ = _e1914;
                            }
                            let _e1922 = phi_3633_;
                            phi_3638_ = type_22(_e1922, _e1804.member.member.member_1, _e1804.member.member.member_2, _e1804.member.member.member_3);
                        } else {
                            phi_3638_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1927 = phi_3638_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_2.member[_e136] = _e1927;
                        let _e1931 = local_11;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e1931.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e1936 = select(0u, 1u, (_e220 <= _e230));
                        if (_e1936 > 0u) {
                            let _e1938 = (1u < _e104);
                            if _e1938 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1942 = atomicAdd((&global_6.member[0u]), _e1936);
                                if ((_e1942 + _e1936) < _e1942) {
                                    if _e1938 {
                                    } else {
                                        break;
                                    }
                                    let _e1947 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1950 = select(0u, 1u, (_e1927.member_3 != 4294967295u));
                        if (_e1950 > 0u) {
                            let _e1952 = (3u < _e104);
                            if _e1952 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1956 = atomicAdd((&global_6.member[2u]), _e1950);
                                if ((_e1956 + _e1950) < _e1956) {
                                    if _e1952 {
                                    } else {
                                        break;
                                    }
                                    let _e1961 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1931.member_1 > 0u) {
                            let _e1963 = (5u < _e104);
                            if _e1963 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1967 = atomicAdd((&global_6.member[4u]), _e1931.member_1);
                                if ((_e1967 + _e1931.member_1) < _e1967) {
                                    if _e1963 {
                                    } else {
                                        break;
                                    }
                                    let _e1972 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
