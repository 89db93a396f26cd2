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
    member: type_39,
    member_1: u32,
    member_2: u32,
}

struct type_44 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_53 {
    member: type_34,
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
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_24;
@group(0) @binding(0) 
var<uniform> global_3: type_44;
@group(0) @binding(3) 
var<storage> global_4: type_29;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_59;
@group(0) @binding(1) 
var<storage> global_7: type_48;

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
    var phi_1183_: type_42;
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
    var phi_1309_: type_42;
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
    var phi_2316_: type_22;
    var phi_2318_: type_22;
    var phi_2319_: bool;
    var phi_2323_: type_22;
    var phi_2324_: type_22;
    var phi_2325_: type_22;
    var phi_2326_: bool;
    var phi_2330_: type_22;
    var phi_2331_: bool;
    var phi_2332_: type_22;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2335_: type_22;
    var phi_2336_: bool;
    var phi_2337_: bool;
    var phi_2345_: type_22;
    var phi_2346_: bool;
    var phi_2350_: type_22;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2383_: type_42;
    var phi_2384_: type_42;
    var phi_2385_: type_42;
    var phi_1310_: type_42;
    var phi_4108_: bool;
    var phi_4272_: bool;
    var phi_3625_: type_42;
    var phi_3626_: bool;
    var phi_3627_: u32;
    var phi_3628_: type_53;
    var phi_4271_: bool;
    var phi_3629_: type_42;
    var phi_3630_: bool;
    var phi_3631_: u32;
    var phi_3632_: u32;
    var phi_3633_: type_53;
    var phi_4270_: bool;
    var phi_3634_: type_42;
    var phi_3635_: bool;
    var phi_3636_: u32;
    var phi_3637_: u32;
    var phi_3638_: type_53;
    var phi_4269_: bool;
    var phi_1184_: type_42;
    var phi_1187_: bool;
    var phi_1189_: u32;
    var phi_1191_: u32;
    var phi_1193_: type_53;
    var phi_3639_: bool;
    var phi_4268_: bool;
    var local_10: type_42;
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
    var phi_3715_: type_22;
    var local_11: type_42;
    var local_12: type_42;

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
                                phi_485_ = (bitcast<i32>((_e239 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_485_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e239)), 32u, (_e239 == 0u))));
                            }
                            let _e253 = phi_485_;
                            phi_486_ = _e253;
                        } else {
                            phi_486_ = 0i;
                        }
                        let _e255 = phi_486_;
                        let _e256 = (_e165 == _e209);
                        if _e256 {
                            phi_496_ = true;
                        } else {
                            phi_496_ = (_e173 == _e209);
                        }
                        let _e259 = phi_496_;
                        let _e260 = select(1u, 0u, _e256);
                        if _e259 {
                            let _e261 = (_e260 + 1u);
                            phi_506_ = _e261;
                            phi_507_ = _e261;
                            phi_509_ = select(true, false, (_e261 == 2u));
                        } else {
                            phi_506_ = u32();
                            phi_507_ = 0u;
                            phi_509_ = true;
                        }
                        let _e265 = phi_506_;
                        let _e267 = phi_507_;
                        let _e269 = phi_509_;
                        if _e269 {
                            phi_514_ = (_e267 + 1u);
                        } else {
                            phi_514_ = 0u;
                        }
                        let _e273 = phi_514_;
                        let _e274 = select(_e265, _e267, _e269);
                        let _e275 = select(_e260, select(2u, _e260, _e259), _e269);
                        let _e276 = -(_e255);
                        if (_e276 < -126i) {
                            phi_547_ = -126i;
                        } else {
                            phi_547_ = select(_e276, 127i, (_e276 > 127i));
                        }
                        let _e281 = phi_547_;
                        let _e286 = bitcast<f32>((bitcast<u32>((_e281 + 127i)) << bitcast<u32>(23i)));
                        let _e292 = bitcast<f32>((bitcast<u32>(((_e276 - _e281) + 127i)) << bitcast<u32>(23i)));
                        let _e297 = global_4.member[_e136].member.member;
                        let _e298 = (_e274 == 0u);
                        if _e298 {
                            phi_565_ = _e297[0];
                        } else {
                            phi_565_ = _e297[1];
                        }
                        let _e302 = phi_565_;
                        let _e303 = (_e274 == 2u);
                        if _e303 {
                            phi_571_ = _e297[2];
                        } else {
                            phi_571_ = _e302;
                        }
                        let _e306 = phi_571_;
                        let _e307 = bitcast<u32>(_e306);
                        let _e309 = ((_e307 & 2139095040u) != 0u);
                        let _e321 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e307 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e307 & 2147483648u))), _e306, _e309) * select(0.00000011920929f, 1f, _e309));
                        let _e322 = global_4.member[_e136].member.member_2;
                        if _e298 {
                            phi_611_ = _e322[0];
                        } else {
                            phi_611_ = _e322[1];
                        }
                        let _e326 = phi_611_;
                        if _e303 {
                            phi_617_ = _e322[2];
                        } else {
                            phi_617_ = _e326;
                        }
                        let _e329 = phi_617_;
                        let _e330 = bitcast<u32>(_e329);
                        let _e332 = ((_e330 & 2139095040u) != 0u);
                        let _e346 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e330 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e330 & 2147483648u))), _e329, _e332) * _e286) * select(0.00000011920929f, 1f, _e332)) * _e292);
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e350 {
                            let _e354 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) * 0.00000011920929f);
                            phi_669_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                        } else {
                            phi_669_ = 0f;
                        }
                        let _e358 = phi_669_;
                        let _e359 = (_e321 + _e358);
                        let _e360 = (_e321 - _e358);
                        let _e361 = select(_e346, 0f, _e350);
                        if _e350 {
                            phi_681_ = 38685626000000000000000000f;
                        } else {
                            phi_681_ = (1f / _e346);
                        }
                        let _e364 = phi_681_;
                        let _e365 = (_e273 == 0u);
                        if _e365 {
                            phi_690_ = _e297[0];
                        } else {
                            phi_690_ = _e297[1];
                        }
                        let _e369 = phi_690_;
                        let _e370 = (_e273 == 2u);
                        if _e370 {
                            phi_696_ = _e297[2];
                        } else {
                            phi_696_ = _e369;
                        }
                        let _e373 = phi_696_;
                        let _e374 = bitcast<u32>(_e373);
                        let _e376 = ((_e374 & 2139095040u) != 0u);
                        let _e388 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e374 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e374 & 2147483648u))), _e373, _e376) * select(0.00000011920929f, 1f, _e376));
                        if _e365 {
                            phi_736_ = _e322[0];
                        } else {
                            phi_736_ = _e322[1];
                        }
                        let _e392 = phi_736_;
                        if _e370 {
                            phi_742_ = _e322[2];
                        } else {
                            phi_742_ = _e392;
                        }
                        let _e395 = phi_742_;
                        let _e396 = bitcast<u32>(_e395);
                        let _e398 = ((_e396 & 2139095040u) != 0u);
                        let _e412 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e396 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e396 & 2147483648u))), _e395, _e398) * _e286) * select(0.00000011920929f, 1f, _e398)) * _e292);
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e416 {
                            let _e420 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) * 0.00000011920929f);
                            phi_794_ = select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f));
                        } else {
                            phi_794_ = 0f;
                        }
                        let _e424 = phi_794_;
                        let _e425 = (_e388 + _e424);
                        let _e426 = (_e388 - _e424);
                        let _e427 = select(_e412, 0f, _e416);
                        if _e416 {
                            phi_806_ = 38685626000000000000000000f;
                        } else {
                            phi_806_ = (1f / _e412);
                        }
                        let _e430 = phi_806_;
                        let _e431 = (_e275 == 0u);
                        if _e431 {
                            phi_815_ = _e297[0];
                        } else {
                            phi_815_ = _e297[1];
                        }
                        let _e435 = phi_815_;
                        let _e436 = (_e275 == 2u);
                        if _e436 {
                            phi_821_ = _e297[2];
                        } else {
                            phi_821_ = _e435;
                        }
                        let _e439 = phi_821_;
                        let _e440 = bitcast<u32>(_e439);
                        let _e442 = ((_e440 & 2139095040u) != 0u);
                        let _e454 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e440 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e440 & 2147483648u))), _e439, _e442) * select(0.00000011920929f, 1f, _e442));
                        if _e431 {
                            phi_861_ = _e322[0];
                        } else {
                            phi_861_ = _e322[1];
                        }
                        let _e458 = phi_861_;
                        if _e436 {
                            phi_867_ = _e322[2];
                        } else {
                            phi_867_ = _e458;
                        }
                        let _e461 = phi_867_;
                        let _e462 = bitcast<u32>(_e461);
                        let _e464 = ((_e462 & 2139095040u) != 0u);
                        let _e478 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e462 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e462 & 2147483648u))), _e461, _e464) * _e286) * select(0.00000011920929f, 1f, _e464)) * _e292);
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e482 {
                            let _e486 = (bitcast<f32>((bitcast<u32>(_e454) & 2147483647u)) * 0.00000011920929f);
                            phi_919_ = select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f));
                        } else {
                            phi_919_ = 0f;
                        }
                        let _e490 = phi_919_;
                        let _e491 = (_e454 + _e490);
                        let _e492 = (_e454 - _e490);
                        let _e493 = select(_e478, 0f, _e482);
                        if _e482 {
                            phi_931_ = 38685626000000000000000000f;
                        } else {
                            phi_931_ = (1f / _e478);
                        }
                        let _e496 = phi_931_;
                        let _e499 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e502 = bitcast<f32>((bitcast<u32>(_e388) & 2147483647u));
                        let _e504 = select(_e502, _e499, (_e499 > _e502));
                        let _e507 = bitcast<f32>((bitcast<u32>(_e454) & 2147483647u));
                        if (_e236 && (select(_e507, _e504, (_e504 > _e507)) <= 1099511600000f)) {
                            let _e519 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e522 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                            let _e526 = (_e519 == 0u);
                            let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                            if (_e522 == 255i) {
                                phi_986_ = 255i;
                            } else {
                                phi_986_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e255);
                            }
                            let _e537 = phi_986_;
                            let _e547 = (_e537 <= 0i);
                            if _e547 {
                                phi_1009_ = u32();
                            } else {
                                if _e526 {
                                    phi_1008_ = u32();
                                } else {
                                    phi_1008_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                                }
                                let _e551 = phi_1008_;
                                phi_1009_ = _e551;
                            }
                            let _e553 = phi_1009_;
                            let _e565 = ((_e232 & 8388607u) | (select(0u, 1u, ((_e232 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e568 = bitcast<i32>((_e232 >> bitcast<u32>(23i)));
                            let _e572 = (_e565 == 0u);
                            let _e575 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e565)), 32u, _e572)) - 8i);
                            if (_e568 == 255i) {
                                phi_1046_ = 255i;
                            } else {
                                phi_1046_ = (((_e568 + select(0i, 1i, (_e568 == 0i))) - _e575) + _e255);
                            }
                            let _e583 = phi_1046_;
                            let _e593 = (_e583 <= 0i);
                            if _e593 {
                                phi_1069_ = u32();
                            } else {
                                if _e572 {
                                    phi_1068_ = u32();
                                } else {
                                    phi_1068_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | ((_e565 << bitcast<u32>(((_e575 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e583 >= 255i));
                                }
                                let _e597 = phi_1068_;
                                phi_1069_ = _e597;
                            }
                            let _e599 = phi_1069_;
                            phi_1077_ = bitcast<f32>(((_e231 & 2147483648u) | select(_e599, 0u, select(_e572, true, _e593))));
                            phi_1078_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                        } else {
                            phi_1077_ = 0f;
                            phi_1078_ = 1f;
                        }
                        let _e605 = phi_1077_;
                        let _e607 = phi_1078_;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e613 = global_4.member[_e136].member_2;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e616 = (_e274 % 3u);
                        let _e617 = (_e616 < 3u);
                        if _e617 {
                        } else {
                            break;
                        }
                        let _e619 = local_1[_e616];
                        let _e622 = (_e273 % 3u);
                        let _e623 = (_e622 < 3u);
                        if _e623 {
                        } else {
                            break;
                        }
                        let _e625 = local_1[_e622];
                        let _e628 = (_e275 % 3u);
                        let _e629 = (_e628 < 3u);
                        if _e629 {
                        } else {
                            break;
                        }
                        let _e631 = local_1[_e628];
                        if _e617 {
                        } else {
                            break;
                        }
                        let _e636 = local[_e616];
                        if _e623 {
                        } else {
                            break;
                        }
                        let _e640 = local[_e622];
                        if _e629 {
                        } else {
                            break;
                        }
                        let _e644 = local[_e628];
                        phi_4114_ = false;
                        phi_1183_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e605), 0u, 0u);
                        phi_1186_ = (_e607 <= _e605);
                        phi_1188_ = ((3u * _e94) + 1u);
                        phi_1190_ = 0u;
                        phi_1192_ = type_53(type_34(vec4<f32>((f32(_e619) * _e148), (f32(_e625) * _e148), (f32(_e631) * _e148), 0f), vec4<f32>((f32(_e636) * _e148), (f32(_e640) * _e148), (f32(_e644) * _e148), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        loop {
                            let _e654 = phi_4114_;
                            let _e656 = phi_1183_;
                            let _e658 = phi_1186_;
                            let _e660 = phi_1188_;
                            let _e662 = phi_1190_;
                            let _e664 = phi_1192_;
                            local_10 = _e656;
                            local_11 = _e656;
                            if _e658 {
                                phi_1203_ = true;
                            } else {
                                phi_1203_ = (_e662 > 0u);
                            }
                            let _e667 = phi_1203_;
                            if _e667 {
                                let _e668 = (_e660 > 0u);
                                if _e668 {
                                    if _e658 {
                                        phi_1289_ = _e658;
                                        phi_1290_ = _e662;
                                        phi_1291_ = _e664;
                                    } else {
                                        let _e669 = (_e662 - 1u);
                                        let _e670 = (_e669 % 128u);
                                        let _e671 = (_e670 < 128u);
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e673 = local_7[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e675 = local_6[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e677 = local_5[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e679 = local_4[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e681 = local_3[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e683 = local_2[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e688 = local_8[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4268_ = true;
                                            break;
                                        }
                                        let _e691 = local_9[_e670];
                                        phi_1289_ = (_e691 <= _e656.member.member_1);
                                        phi_1290_ = _e669;
                                        phi_1291_ = type_53(type_34(vec4<f32>(_e673, _e675, _e677, 0f), vec4<f32>(_e679, _e681, _e683, 0f)), _e688);
                                    }
                                    let _e696 = phi_1289_;
                                    let _e698 = phi_1290_;
                                    let _e700 = phi_1291_;
                                    if _e696 {
                                        if ((_e700.member_1 & 2147483648u) != 0u) {
                                            phi_1309_ = _e656;
                                            phi_1312_ = type_7(0u, ((_e700.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1175 = phi_1309_;
                                                let _e1177 = phi_1312_;
                                                local_12 = _e1175;
                                                if (_e1177.member < _e1177.member_1) {
                                                    phi_1313_ = type_7((_e1177.member + 1u), _e1177.member_1);
                                                    phi_1335_ = type_7(1u, _e1177.member);
                                                } else {
                                                    phi_1313_ = _e1177;
                                                    phi_1335_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e1190 = phi_1313_;
                                                let _e1192 = phi_1335_;
                                                let _e1196 = (bitcast<i32>(_e1192.member) != 0i);
                                                if _e1196 {
                                                    let _e1202 = type_42(_e1175.member, _e1175.member_1, (_e1175.member_2 + 1u));
                                                    let _e1203 = ((_e700.member_1 & 268435455u) + _e1192.member_1);
                                                    let _e1204 = (_e1203 < _e96);
                                                    if _e1204 {
                                                        if _e1204 {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1208 = global_1.member[_e1203].member_1;
                                                        phi_1359_ = _e1208;
                                                    } else {
                                                        phi_1359_ = 4294967295u;
                                                    }
                                                    let _e1210 = phi_1359_;
                                                    if (_e1203 >= _e96) {
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1204 {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        if (_e616 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1217 = global_1.member[_e1203].member[_e616];
                                                        if (_e622 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1223 = global_1.member[_e1203].member[_e622];
                                                        if (_e628 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1229 = global_1.member[_e1203].member[_e628];
                                                        let _e1231 = (3u + _e616);
                                                        if (_e1231 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1237 = global_1.member[_e1203].member[_e1231];
                                                        let _e1238 = (3u + _e622);
                                                        if (_e1238 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1244 = global_1.member[_e1203].member[_e1238];
                                                        let _e1245 = (3u + _e628);
                                                        if (_e1245 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1251 = global_1.member[_e1203].member[_e1245];
                                                        let _e1253 = (6u + _e616);
                                                        if (_e1253 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1259 = global_1.member[_e1203].member[_e1253];
                                                        let _e1260 = (6u + _e622);
                                                        if (_e1260 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1266 = global_1.member[_e1203].member[_e1260];
                                                        let _e1267 = (6u + _e628);
                                                        if (_e1267 < 9u) {
                                                        } else {
                                                            phi_4108_ = true;
                                                            break;
                                                        }
                                                        let _e1273 = global_1.member[_e1203].member[_e1267];
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1217, _e1223, _e1229), array<f32, 3>(_e1237, _e1244, _e1251), array<f32, 3>(_e1259, _e1266, _e1273));
                                                    }
                                                    let _e1277 = phi_1451_;
                                                    let _e1286 = (_e1277[0][2] - _e454);
                                                    let _e1289 = (((_e1277[0][0] - _e321) * _e493) - (_e1286 * _e361));
                                                    let _e1292 = (((_e1277[0][1] - _e388) * _e493) - (_e1286 * _e427));
                                                    let _e1299 = (_e1277[1][2] - _e454);
                                                    let _e1302 = (((_e1277[1][0] - _e321) * _e493) - (_e1299 * _e361));
                                                    let _e1305 = (((_e1277[1][1] - _e388) * _e493) - (_e1299 * _e427));
                                                    let _e1312 = (_e1277[2][2] - _e454);
                                                    let _e1315 = (((_e1277[2][0] - _e321) * _e493) - (_e1312 * _e361));
                                                    let _e1318 = (((_e1277[2][1] - _e388) * _e493) - (_e1312 * _e427));
                                                    let _e1319 = (_e1315 * _e1305);
                                                    let _e1320 = (_e1318 * _e1302);
                                                    let _e1321 = (_e1289 * _e1318);
                                                    let _e1322 = (_e1292 * _e1315);
                                                    let _e1323 = (_e1302 * _e1292);
                                                    let _e1324 = (_e1305 * _e1289);
                                                    let _e1329 = (((_e1319 >= _e1320) && (_e1321 >= _e1322)) && (_e1323 >= _e1324));
                                                    if (_e1329 || (((_e1319 <= _e1320) && (_e1321 <= _e1322)) && (_e1323 <= _e1324))) {
                                                        let _e1336 = select(-1f, 1f, _e1329);
                                                        let _e1338 = ((_e1319 - _e1320) * _e1336);
                                                        let _e1340 = select(0f, _e1338, (_e1338 > 0f));
                                                        let _e1342 = ((_e1321 - _e1322) * _e1336);
                                                        let _e1344 = select(0f, _e1342, (_e1342 > 0f));
                                                        let _e1346 = ((_e1323 - _e1324) * _e1336);
                                                        let _e1348 = select(0f, _e1346, (_e1346 > 0f));
                                                        let _e1350 = ((_e1340 + _e1344) + _e1348);
                                                        if (_e1350 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2335_ = type_22();
                                                            phi_2336_ = true;
                                                            phi_2337_ = false;
                                                        } else {
                                                            let _e1353 = select(_e1302, _e1289, (_e1289 < _e1302));
                                                            if (select(_e1315, _e1353, (_e1353 < _e1315)) > 0f) {
                                                                phi_1603_ = true;
                                                            } else {
                                                                let _e1358 = select(_e1302, _e1289, (_e1289 > _e1302));
                                                                phi_1603_ = (select(_e1315, _e1358, (_e1358 > _e1315)) < 0f);
                                                            }
                                                            let _e1363 = phi_1603_;
                                                            if _e1363 {
                                                                phi_2332_ = type_22();
                                                                phi_2333_ = true;
                                                                phi_2334_ = false;
                                                            } else {
                                                                let _e1365 = select(_e1305, _e1292, (_e1292 < _e1305));
                                                                if (select(_e1318, _e1365, (_e1365 < _e1318)) > 0f) {
                                                                    phi_1632_ = true;
                                                                } else {
                                                                    let _e1370 = select(_e1305, _e1292, (_e1292 > _e1305));
                                                                    phi_1632_ = (select(_e1318, _e1370, (_e1370 > _e1318)) < 0f);
                                                                }
                                                                let _e1375 = phi_1632_;
                                                                if _e1375 {
                                                                    phi_2330_ = type_22();
                                                                    phi_2331_ = false;
                                                                } else {
                                                                    let _e1377 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] < _e1277[1][0]));
                                                                    let _e1381 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] > _e1277[1][0]));
                                                                    let _e1385 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] < _e1277[1][1]));
                                                                    let _e1389 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] > _e1277[1][1]));
                                                                    let _e1393 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] < _e1277[1][2]));
                                                                    let _e1397 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] > _e1277[1][2]));
                                                                    let _e1402 = ((select(_e1277[2][0], _e1377, (_e1377 < _e1277[2][0])) - _e359) * _e364);
                                                                    let _e1403 = ((select(_e1277[2][0], _e1381, (_e1381 > _e1277[2][0])) - _e360) * _e364);
                                                                    let _e1406 = ((select(_e1277[2][1], _e1385, (_e1385 < _e1277[2][1])) - _e425) * _e430);
                                                                    let _e1407 = ((select(_e1277[2][1], _e1389, (_e1389 > _e1277[2][1])) - _e426) * _e430);
                                                                    let _e1410 = ((select(_e1277[2][2], _e1393, (_e1393 < _e1277[2][2])) - _e491) * _e496);
                                                                    let _e1411 = ((select(_e1277[2][2], _e1397, (_e1397 > _e1277[2][2])) - _e492) * _e496);
                                                                    let _e1413 = select(_e1411, _e1410, (_e1410 < _e1411));
                                                                    let _e1415 = select(_e1411, _e1410, (_e1410 > _e1411));
                                                                    let _e1417 = select(_e1403, _e1402, (_e1402 < _e1403));
                                                                    let _e1419 = select(_e1407, _e1406, (_e1406 < _e1407));
                                                                    let _e1421 = select(_e1419, _e1417, (_e1417 > _e1419));
                                                                    let _e1423 = select(_e1413, _e1421, (_e1421 > _e1413));
                                                                    let _e1425 = select(_e1403, _e1402, (_e1402 > _e1403));
                                                                    let _e1427 = select(_e1407, _e1406, (_e1406 > _e1407));
                                                                    let _e1429 = select(_e1427, _e1425, (_e1425 < _e1427));
                                                                    let _e1431 = select(_e1415, _e1429, (_e1429 < _e1415));
                                                                    let _e1432 = -(_e1413);
                                                                    let _e1438 = select(_e607, _e1423, (_e1423 > _e607));
                                                                    if (_e1438 > (_e1431 + (select(_e1432, _e1415, (_e1415 > _e1432)) * 0.0000019073523f))) {
                                                                        phi_2325_ = type_22();
                                                                        phi_2326_ = true;
                                                                    } else {
                                                                        let _e1440 = (_e1438 > _e1175.member.member_1);
                                                                        if _e1440 {
                                                                            phi_2324_ = type_22();
                                                                        } else {
                                                                            let _e1441 = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                                            let _e1442 = vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]);
                                                                            let _e1443 = vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]);
                                                                            let _e1444 = (_e1277[1][0] - _e1277[0][0]);
                                                                            let _e1445 = (_e1277[1][1] - _e1277[0][1]);
                                                                            let _e1446 = (_e1277[1][2] - _e1277[0][2]);
                                                                            let _e1447 = vec3<f32>(_e1444, _e1445, _e1446);
                                                                            let _e1448 = (_e1277[2][0] - _e1277[1][0]);
                                                                            let _e1449 = (_e1277[2][1] - _e1277[1][1]);
                                                                            let _e1450 = (_e1277[2][2] - _e1277[1][2]);
                                                                            let _e1451 = vec3<f32>(_e1448, _e1449, _e1450);
                                                                            let _e1452 = (_e1277[0][0] - _e1277[2][0]);
                                                                            let _e1453 = (_e1277[0][1] - _e1277[2][1]);
                                                                            let _e1454 = (_e1277[0][2] - _e1277[2][2]);
                                                                            let _e1455 = vec3<f32>(_e1452, _e1453, _e1454);
                                                                            let _e1458 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                            let _e1461 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                            let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                            let _e1466 = bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u));
                                                                            let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                                            let _e1471 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                            let _e1474 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                            let _e1476 = select(_e1474, _e1471, (_e1471 > _e1474));
                                                                            let _e1479 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                            let _e1481 = select(_e1479, _e1476, (_e1476 > _e1479));
                                                                            let _e1484 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                            let _e1487 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                                            let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                                            let _e1492 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                                            let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                                            let _e1496 = select(_e1481, _e1468, (_e1468 > _e1481));
                                                                            let _e1498 = select(_e1494, _e1496, (_e1496 > _e1494));
                                                                            if (_e1468 == _e1498) {
                                                                                phi_2051_ = _e1305;
                                                                                phi_2052_ = _e1302;
                                                                                phi_2053_ = _e1292;
                                                                                phi_2054_ = _e1289;
                                                                                phi_2055_ = _e1441;
                                                                                phi_2056_ = _e1455;
                                                                                phi_2057_ = _e1451;
                                                                                phi_2058_ = _e1447;
                                                                            } else {
                                                                                let _e1500 = (_e1481 == _e1498);
                                                                                let _e1505 = vec3(_e1500);
                                                                                phi_2051_ = select(_e1292, _e1318, _e1500);
                                                                                phi_2052_ = select(_e1289, _e1315, _e1500);
                                                                                phi_2053_ = select(_e1318, _e1305, _e1500);
                                                                                phi_2054_ = select(_e1315, _e1302, _e1500);
                                                                                phi_2055_ = select(_e1443, _e1442, _e1505);
                                                                                phi_2056_ = select(_e1451, _e1447, _e1505);
                                                                                phi_2057_ = select(_e1447, _e1455, _e1505);
                                                                                phi_2058_ = select(_e1455, _e1451, _e1505);
                                                                            }
                                                                            let _e1511 = phi_2051_;
                                                                            let _e1513 = phi_2052_;
                                                                            let _e1515 = phi_2053_;
                                                                            let _e1517 = phi_2054_;
                                                                            let _e1519 = phi_2055_;
                                                                            let _e1521 = phi_2056_;
                                                                            let _e1523 = phi_2057_;
                                                                            let _e1525 = phi_2058_;
                                                                            let _e1532 = ((_e1523.y * _e1521.z) - (_e1521.y * _e1523.z));
                                                                            let _e1537 = ((_e1523.z * _e1521.x) - (_e1521.z * _e1523.x));
                                                                            let _e1540 = ((_e1523.x * _e1521.y) - (_e1521.x * _e1523.y));
                                                                            if (_e1340 >= _e1344) {
                                                                                phi_2095_ = select(true, false, (_e1340 >= _e1348));
                                                                            } else {
                                                                                phi_2095_ = true;
                                                                            }
                                                                            let _e1545 = phi_2095_;
                                                                            if _e1545 {
                                                                                phi_2104_ = select(_e1443, _e1442, vec3((_e1344 >= _e1348)));
                                                                            } else {
                                                                                phi_2104_ = _e1441;
                                                                            }
                                                                            let _e1550 = phi_2104_;
                                                                            let _e1561 = (((_e1532 * (_e1550.x - _e321)) + (_e1537 * (_e1550.y - _e388))) + (_e1540 * (_e1550.z - _e454)));
                                                                            let _e1566 = (((_e1532 * _e361) + (_e1537 * _e427)) + (_e1540 * _e493));
                                                                            let _e1567 = (_e1513 - _e1517);
                                                                            let _e1568 = (_e1511 - _e1515);
                                                                            let _e1576 = (-(((_e1517 * _e1567) + (_e1515 * _e1568))) / ((_e1567 * _e1567) + (_e1568 * _e1568)));
                                                                            let _e1578 = select(1f, _e1576, (_e1576 < 1f));
                                                                            let _e1580 = select(0f, _e1578, (_e1578 > 0f));
                                                                            let _e1593 = ((_e1519.x + (_e1525.x * _e1580)) - _e321);
                                                                            let _e1594 = ((_e1519.y + (_e1525.y * _e1580)) - _e388);
                                                                            let _e1595 = ((_e1519.z + (_e1525.z * _e1580)) - _e454);
                                                                            let _e1596 = (_e1595 / _e493);
                                                                            let _e1608 = bitcast<f32>((bitcast<u32>(_e1593) & 2147483647u));
                                                                            let _e1611 = bitcast<f32>((bitcast<u32>(_e1594) & 2147483647u));
                                                                            let _e1613 = select(_e1611, _e1608, (_e1608 > _e1611));
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                                            let _e1618 = select(_e1616, _e1613, (_e1613 > _e1616));
                                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1532) & 2147483647u));
                                                                            let _e1627 = bitcast<f32>((bitcast<u32>(_e1537) & 2147483647u));
                                                                            let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                                            let _e1632 = bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1532 * _e1593) + (_e1537 * _e1594)) + (_e1540 * _e1595)) - _e1561)) & 2147483647u)) <= ((0.0000009536743f * select(_e1498, _e1618, (_e1618 > _e1498))) * select(_e1632, _e1629, (_e1629 > _e1632)))) {
                                                                                let _e1642 = bitcast<f32>((bitcast<u32>(_e1523.x) & 2147483647u));
                                                                                let _e1645 = bitcast<f32>((bitcast<u32>(_e1523.y) & 2147483647u));
                                                                                let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                                let _e1650 = bitcast<f32>((bitcast<u32>(_e1523.z) & 2147483647u));
                                                                                let _e1656 = bitcast<f32>((bitcast<u32>(_e1521.x) & 2147483647u));
                                                                                let _e1659 = bitcast<f32>((bitcast<u32>(_e1521.y) & 2147483647u));
                                                                                let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                                let _e1664 = bitcast<f32>((bitcast<u32>(_e1521.z) & 2147483647u));
                                                                                let _e1668 = (bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u)) > ((0.0000038146973f * select(_e1650, _e1647, (_e1647 > _e1650))) * select(_e1664, _e1661, (_e1661 > _e1664))));
                                                                                if _e1668 {
                                                                                    phi_2269_ = (_e1561 / _e1566);
                                                                                } else {
                                                                                    phi_2269_ = f32();
                                                                                }
                                                                                let _e1671 = phi_2269_;
                                                                                phi_2271_ = _e1671;
                                                                                phi_2272_ = select(true, false, _e1668);
                                                                            } else {
                                                                                phi_2271_ = f32();
                                                                                phi_2272_ = true;
                                                                            }
                                                                            let _e1674 = phi_2271_;
                                                                            let _e1676 = phi_2272_;
                                                                            if _e1676 {
                                                                                let _e1684 = (((_e1532 * (_e1593 - (_e361 * _e1596))) + (_e1537 * (_e1594 - (_e427 * _e1596)))) / _e1566);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u)) <= _e1498) {
                                                                                    phi_2292_ = (_e1596 + _e1684);
                                                                                } else {
                                                                                    phi_2292_ = _e1596;
                                                                                }
                                                                                let _e1691 = phi_2292_;
                                                                                phi_2293_ = _e1691;
                                                                            } else {
                                                                                phi_2293_ = _e1674;
                                                                            }
                                                                            let _e1693 = phi_2293_;
                                                                            let _e1695 = select(_e1431, _e1693, (_e1693 < _e1431));
                                                                            let _e1697 = select(_e1423, _e1695, (_e1695 > _e1423));
                                                                            if (_e1697 >= _e607) {
                                                                                let _e1699 = (_e1697 <= _e1175.member.member_1);
                                                                                if _e1699 {
                                                                                    let _e1700 = (1f / _e1350);
                                                                                    phi_2316_ = type_22(_e1697, (_e1344 * _e1700), (_e1348 * _e1700), _e1210);
                                                                                } else {
                                                                                    phi_2316_ = type_22();
                                                                                }
                                                                                let _e1705 = phi_2316_;
                                                                                phi_2318_ = _e1705;
                                                                                phi_2319_ = select(true, false, _e1699);
                                                                            } else {
                                                                                phi_2318_ = type_22();
                                                                                phi_2319_ = true;
                                                                            }
                                                                            let _e1708 = phi_2318_;
                                                                            let _e1710 = phi_2319_;
                                                                            if _e1710 {
                                                                                phi_2323_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2323_ = _e1708;
                                                                            }
                                                                            let _e1712 = phi_2323_;
                                                                            phi_2324_ = _e1712;
                                                                        }
                                                                        let _e1714 = phi_2324_;
                                                                        phi_2325_ = _e1714;
                                                                        phi_2326_ = _e1440;
                                                                    }
                                                                    let _e1716 = phi_2325_;
                                                                    let _e1718 = phi_2326_;
                                                                    phi_2330_ = _e1716;
                                                                    phi_2331_ = _e1718;
                                                                }
                                                                let _e1720 = phi_2330_;
                                                                let _e1722 = phi_2331_;
                                                                phi_2332_ = _e1720;
                                                                phi_2333_ = _e1375;
                                                                phi_2334_ = _e1722;
                                                            }
                                                            let _e1724 = phi_2332_;
                                                            let _e1726 = phi_2333_;
                                                            let _e1728 = phi_2334_;
                                                            phi_2335_ = _e1724;
                                                            phi_2336_ = _e1726;
                                                            phi_2337_ = _e1728;
                                                        }
                                                        let _e1730 = phi_2335_;
                                                        let _e1732 = phi_2336_;
                                                        let _e1734 = phi_2337_;
                                                        phi_2345_ = _e1730;
                                                        phi_2346_ = select(_e1734, true, _e1732);
                                                    } else {
                                                        phi_2345_ = type_22();
                                                        phi_2346_ = true;
                                                    }
                                                    let _e1737 = phi_2345_;
                                                    let _e1739 = phi_2346_;
                                                    if _e1739 {
                                                        phi_2350_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2350_ = _e1737;
                                                    }
                                                    let _e1741 = phi_2350_;
                                                    if (_e1741.member_3 != 4294967295u) {
                                                        if (_e1210 != _e613) {
                                                            if (_e1741.member < _e1175.member.member.member) {
                                                                phi_2376_ = true;
                                                            } else {
                                                                if (_e1741.member == _e1175.member.member.member) {
                                                                    phi_2375_ = (_e1741.member_3 < _e1175.member.member.member_3);
                                                                } else {
                                                                    phi_2375_ = false;
                                                                }
                                                                let _e1756 = phi_2375_;
                                                                phi_2376_ = _e1756;
                                                            }
                                                            let _e1758 = phi_2376_;
                                                            if _e1758 {
                                                                phi_2383_ = type_42(type_39(_e1741, _e1741.member), _e1202.member_1, _e1202.member_2);
                                                            } else {
                                                                phi_2383_ = _e1202;
                                                            }
                                                            let _e1765 = phi_2383_;
                                                            phi_2384_ = _e1765;
                                                        } else {
                                                            phi_2384_ = _e1202;
                                                        }
                                                        let _e1767 = phi_2384_;
                                                        phi_2385_ = _e1767;
                                                    } else {
                                                        phi_2385_ = _e1202;
                                                    }
                                                    let _e1769 = phi_2385_;
                                                    phi_1310_ = _e1769;
                                                } else {
                                                    phi_1310_ = type_42();
                                                }
                                                let _e1771 = phi_1310_;
                                                continue;
                                                continuing {
                                                    phi_1309_ = _e1771;
                                                    phi_1312_ = _e1190;
                                                    phi_4108_ = _e654;
                                                    break if !(_e1196);
                                                }
                                            }
                                            let _e1774 = phi_4108_;
                                            phi_4268_ = _e1774;
                                            if _e1774 {
                                                break;
                                            }
                                            phi_4272_ = _e1774;
                                            let _e2109 = local_12;
                                            phi_3625_ = _e2109;
                                            phi_3626_ = false;
                                            phi_3627_ = _e698;
                                            phi_3628_ = _e700;
                                        } else {
                                            if (_e700.member_1 >= _e94) {
                                                phi_3156_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e700.member_1 < _e94) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e711 = (_e274 * 2u);
                                                let _e713 = ((1u + _e711) % 7u);
                                                if (_e713 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e718 = global_7.member[_e700.member_1][_e713];
                                                let _e720 = ((_e711 + 2u) % 7u);
                                                if (_e720 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e725 = global_7.member[_e700.member_1][_e720];
                                                let _e726 = (_e273 * 2u);
                                                let _e728 = ((1u + _e726) % 7u);
                                                if (_e728 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e733 = global_7.member[_e700.member_1][_e728];
                                                let _e735 = ((_e726 + 2u) % 7u);
                                                if (_e735 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e740 = global_7.member[_e700.member_1][_e735];
                                                let _e741 = (_e275 * 2u);
                                                let _e743 = ((1u + _e741) % 7u);
                                                if (_e743 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e748 = global_7.member[_e700.member_1][_e743];
                                                let _e750 = ((_e741 + 2u) % 7u);
                                                if (_e750 < 7u) {
                                                } else {
                                                    phi_4268_ = true;
                                                    break;
                                                }
                                                let _e755 = global_7.member[_e700.member_1][_e750];
                                                let _e778 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.x - _e700.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e779 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.y - _e700.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e780 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.z - _e700.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e782 = select(_e148, _e778, (_e778 > _e148));
                                                let _e784 = select(_e148, _e779, (_e779 > _e148));
                                                let _e786 = select(_e148, _e780, (_e780 > _e148));
                                                let _e817 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e718 & 2097151u))) - 8388608f) * _e782));
                                                let _e822 = (bitcast<i32>((_e718 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e825 = bitcast<f32>((_e817 & bitcast<u32>(_e822)));
                                                let _e826 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e784));
                                                let _e831 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e834 = bitcast<f32>((_e826 & bitcast<u32>(_e831)));
                                                let _e835 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 2097151u))) - 8388608f) * _e786));
                                                let _e840 = (bitcast<i32>((_e748 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e843 = bitcast<f32>((_e835 & bitcast<u32>(_e840)));
                                                let _e847 = bitcast<f32>((_e817 & bitcast<u32>(~(_e822))));
                                                let _e851 = bitcast<f32>((_e826 & bitcast<u32>(~(_e831))));
                                                let _e855 = bitcast<f32>((_e835 & bitcast<u32>(~(_e840))));
                                                let _e856 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 2097151u))) - 8388608f) * _e782));
                                                let _e861 = (bitcast<i32>((_e725 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e864 = bitcast<f32>((_e856 & bitcast<u32>(_e861)));
                                                let _e865 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e740 & 2097151u))) - 8388608f) * _e784));
                                                let _e870 = (bitcast<i32>((_e740 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e873 = bitcast<f32>((_e865 & bitcast<u32>(_e870)));
                                                let _e874 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e755 & 2097151u))) - 8388608f) * _e786));
                                                let _e879 = (bitcast<i32>((_e755 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e882 = bitcast<f32>((_e874 & bitcast<u32>(_e879)));
                                                let _e886 = bitcast<f32>((_e856 & bitcast<u32>(~(_e861))));
                                                let _e890 = bitcast<f32>((_e865 & bitcast<u32>(~(_e870))));
                                                let _e894 = bitcast<f32>((_e874 & bitcast<u32>(~(_e879))));
                                                let _e924 = global_7.member[_e700.member_1][0u];
                                                let _e928 = global_7.member[_e700.member_1][2u];
                                                let _e932 = global_7.member[_e700.member_1][4u];
                                                let _e936 = global_7.member[_e700.member_1][6u];
                                                let _e948 = (((_e928 >> bitcast<u32>(22i)) | ((_e932 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e936 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e949 = (_e924 & 268435455u);
                                                let _e950 = (_e948 & 268435455u);
                                                let _e953 = ((_e924 >> bitcast<u32>(28u)) & 7u);
                                                let _e961 = ((_e924 >> bitcast<u32>(31i)) | (((_e948 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e962 = (_e953 != 0u);
                                                if (_e953 == 0u) {
                                                    phi_3118_ = _e949;
                                                } else {
                                                    if (_e953 == 7u) {
                                                        phi_3117_ = 2147483648u;
                                                    } else {
                                                        phi_3117_ = ((2147483648u | (_e953 << bitcast<u32>(28u))) | (_e950 & 268435455u));
                                                    }
                                                    let _e971 = phi_3117_;
                                                    phi_3118_ = _e971;
                                                }
                                                let _e973 = phi_3118_;
                                                if _e962 {
                                                    let _e974 = (_e953 != 7u);
                                                    if _e974 {
                                                        phi_3128_ = (_e950 + _e953);
                                                    } else {
                                                        phi_3128_ = u32();
                                                    }
                                                    let _e977 = phi_3128_;
                                                    phi_3130_ = _e977;
                                                    phi_3131_ = select(true, false, _e974);
                                                } else {
                                                    phi_3130_ = u32();
                                                    phi_3131_ = true;
                                                }
                                                let _e980 = phi_3130_;
                                                let _e982 = phi_3131_;
                                                if (_e961 == 0u) {
                                                    phi_3152_ = (_e949 + select(0u, 1u, !(_e962)));
                                                } else {
                                                    if (_e961 == 7u) {
                                                        phi_3151_ = 2147483648u;
                                                    } else {
                                                        phi_3151_ = ((2147483648u | (_e961 << bitcast<u32>(28u))) | (select(_e980, _e950, _e982) & 268435455u));
                                                    }
                                                    let _e995 = phi_3151_;
                                                    phi_3152_ = _e995;
                                                }
                                                let _e997 = phi_3152_;
                                                phi_3156_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e700.member.member.x + _e825), (_e700.member.member.x + _e847), (_e700.member.member_1.x - _e864), (_e700.member.member_1.x - _e886)), vec4<f32>((_e700.member.member.y + _e834), (_e700.member.member.y + _e851), (_e700.member.member_1.y - _e873), (_e700.member.member_1.y - _e890)), vec4<f32>((_e700.member.member.z + _e843), (_e700.member.member.z + _e855), (_e700.member.member_1.z - _e882), (_e700.member.member_1.z - _e894))), type_53(type_34((_e700.member.member + vec4<f32>(_e825, _e834, _e843, 0f)), (_e700.member.member_1 - vec4<f32>(_e864, _e873, _e882, 0f))), _e973), type_53(type_34((_e700.member.member + vec4<f32>(_e847, _e851, _e855, 0f)), (_e700.member.member_1 - vec4<f32>(_e886, _e890, _e894, 0f))), _e997));
                                            }
                                            let _e1002 = phi_3156_;
                                            let _e1021 = ((_e1002.member[0].x - _e359) * _e364);
                                            let _e1022 = ((_e1002.member[0].y - _e359) * _e364);
                                            let _e1023 = ((_e1002.member[0].z - _e360) * _e364);
                                            let _e1024 = ((_e1002.member[0].w - _e360) * _e364);
                                            let _e1034 = ((_e1002.member[1].x - _e425) * _e430);
                                            let _e1035 = ((_e1002.member[1].y - _e425) * _e430);
                                            let _e1036 = ((_e1002.member[1].z - _e426) * _e430);
                                            let _e1037 = ((_e1002.member[1].w - _e426) * _e430);
                                            let _e1047 = ((_e1002.member[2].x - _e491) * _e496);
                                            let _e1048 = ((_e1002.member[2].y - _e491) * _e496);
                                            let _e1049 = ((_e1002.member[2].z - _e492) * _e496);
                                            let _e1050 = ((_e1002.member[2].w - _e492) * _e496);
                                            let _e1052 = select(_e1049, _e1047, (_e1047 < _e1049));
                                            let _e1054 = select(_e1050, _e1048, (_e1048 < _e1050));
                                            let _e1056 = select(_e1049, _e1047, (_e1047 > _e1049));
                                            let _e1058 = select(_e1050, _e1048, (_e1048 > _e1050));
                                            let _e1060 = select(_e1023, _e1021, (_e1021 < _e1023));
                                            let _e1062 = select(_e1024, _e1022, (_e1022 < _e1024));
                                            let _e1064 = select(_e1036, _e1034, (_e1034 < _e1036));
                                            let _e1066 = select(_e1037, _e1035, (_e1035 < _e1037));
                                            let _e1068 = select(_e1064, _e1060, (_e1060 > _e1064));
                                            let _e1070 = select(_e1066, _e1062, (_e1062 > _e1066));
                                            let _e1072 = select(_e1052, _e1068, (_e1068 > _e1052));
                                            let _e1074 = select(_e1054, _e1070, (_e1070 > _e1054));
                                            let _e1076 = select(_e1023, _e1021, (_e1021 > _e1023));
                                            let _e1078 = select(_e1024, _e1022, (_e1022 > _e1024));
                                            let _e1080 = select(_e1036, _e1034, (_e1034 > _e1036));
                                            let _e1082 = select(_e1037, _e1035, (_e1035 > _e1037));
                                            let _e1084 = select(_e1080, _e1076, (_e1076 < _e1080));
                                            let _e1086 = select(_e1082, _e1078, (_e1078 < _e1082));
                                            let _e1091 = -(_e1052);
                                            let _e1092 = -(_e1054);
                                            let _e1099 = (select(_e1056, _e1084, (_e1084 < _e1056)) + (select(_e1091, _e1056, (_e1056 > _e1091)) * 0.0000019073523f));
                                            let _e1100 = (select(_e1058, _e1086, (_e1086 < _e1058)) + (select(_e1092, _e1058, (_e1058 > _e1092)) * 0.0000019073523f));
                                            let _e1102 = select(_e607, _e1072, (_e1072 > _e607));
                                            let _e1104 = select(_e607, _e1074, (_e1074 > _e607));
                                            let _e1109 = (_e1102 <= select(_e656.member.member_1, _e1099, (_e1099 < _e656.member.member_1)));
                                            let _e1110 = (_e1104 <= select(_e656.member.member_1, _e1100, (_e1100 < _e656.member.member_1)));
                                            let _e1111 = (_e1102 <= _e1104);
                                            if _e1109 {
                                                if _e1110 {
                                                    if _e1111 {
                                                        phi_3521_ = _e1002.member_2;
                                                    } else {
                                                        phi_3521_ = _e1002.member_1;
                                                    }
                                                    let _e1115 = phi_3521_;
                                                    let _e1137 = (_e698 % 128u);
                                                    let _e1138 = (_e1137 < 128u);
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1137] = _e1115.member_1;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1137] = _e1115.member.member.x;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1137] = _e1115.member.member.y;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1137] = _e1115.member.member.z;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1137] = _e1115.member.member_1.x;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1137] = _e1115.member.member_1.y;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1137] = _e1115.member.member_1.z;
                                                    if _e1138 {
                                                    } else {
                                                        phi_4268_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1137] = select(_e1104, _e1102, !(_e1111));
                                                    if _e1111 {
                                                        phi_3598_ = _e1002.member_1;
                                                    } else {
                                                        phi_3598_ = _e1002.member_2;
                                                    }
                                                    let _e1151 = phi_3598_;
                                                    phi_3599_ = (_e698 + 1u);
                                                    phi_3600_ = _e1151;
                                                } else {
                                                    phi_3599_ = u32();
                                                    phi_3600_ = type_53();
                                                }
                                                let _e1153 = phi_3599_;
                                                let _e1155 = phi_3600_;
                                                phi_3602_ = _e1153;
                                                phi_3603_ = _e1155;
                                                phi_3604_ = select(true, false, _e1110);
                                            } else {
                                                phi_3602_ = u32();
                                                phi_3603_ = type_53();
                                                phi_3604_ = true;
                                            }
                                            let _e1158 = phi_3602_;
                                            let _e1160 = phi_3603_;
                                            let _e1162 = phi_3604_;
                                            if _e1162 {
                                                if _e1109 {
                                                    phi_3613_ = _e1002.member_1;
                                                } else {
                                                    phi_3613_ = _e1002.member_2;
                                                }
                                                let _e1166 = phi_3613_;
                                                phi_3618_ = select(_e1110, true, _e1109);
                                                phi_3620_ = _e1166;
                                            } else {
                                                phi_3618_ = _e696;
                                                phi_3620_ = _e1160;
                                            }
                                            let _e1169 = phi_3618_;
                                            let _e1171 = phi_3620_;
                                            phi_4272_ = _e654;
                                            phi_3625_ = type_42(_e656.member, (_e656.member_1 + 1u), _e656.member_2);
                                            phi_3626_ = _e1169;
                                            phi_3627_ = select(_e1158, _e698, _e1162);
                                            phi_3628_ = _e1171;
                                        }
                                        let _e1776 = phi_4272_;
                                        let _e1778 = phi_3625_;
                                        let _e1780 = phi_3626_;
                                        let _e1782 = phi_3627_;
                                        let _e1784 = phi_3628_;
                                        phi_4271_ = _e1776;
                                        phi_3629_ = _e1778;
                                        phi_3630_ = _e1780;
                                        phi_3631_ = (_e660 - 1u);
                                        phi_3632_ = _e1782;
                                        phi_3633_ = _e1784;
                                    } else {
                                        phi_4271_ = _e654;
                                        phi_3629_ = _e656;
                                        phi_3630_ = _e696;
                                        phi_3631_ = _e660;
                                        phi_3632_ = _e698;
                                        phi_3633_ = _e700;
                                    }
                                    let _e1786 = phi_4271_;
                                    let _e1788 = phi_3629_;
                                    let _e1790 = phi_3630_;
                                    let _e1792 = phi_3631_;
                                    let _e1794 = phi_3632_;
                                    let _e1796 = phi_3633_;
                                    phi_4270_ = _e1786;
                                    phi_3634_ = _e1788;
                                    phi_3635_ = _e1790;
                                    phi_3636_ = _e1792;
                                    phi_3637_ = _e1794;
                                    phi_3638_ = _e1796;
                                } else {
                                    phi_4270_ = _e654;
                                    phi_3634_ = type_42();
                                    phi_3635_ = bool();
                                    phi_3636_ = u32();
                                    phi_3637_ = u32();
                                    phi_3638_ = type_53();
                                }
                                let _e1798 = phi_4270_;
                                let _e1800 = phi_3634_;
                                let _e1802 = phi_3635_;
                                let _e1804 = phi_3636_;
                                let _e1806 = phi_3637_;
                                let _e1808 = phi_3638_;
                                phi_4269_ = _e1798;
                                phi_1184_ = _e1800;
                                phi_1187_ = _e1802;
                                phi_1189_ = _e1804;
                                phi_1191_ = _e1806;
                                phi_1193_ = _e1808;
                                phi_3639_ = _e668;
                            } else {
                                phi_4269_ = _e654;
                                phi_1184_ = type_42();
                                phi_1187_ = bool();
                                phi_1189_ = u32();
                                phi_1191_ = u32();
                                phi_1193_ = type_53();
                                phi_3639_ = false;
                            }
                            let _e1810 = phi_4269_;
                            let _e1812 = phi_1184_;
                            let _e1814 = phi_1187_;
                            let _e1816 = phi_1189_;
                            let _e1818 = phi_1191_;
                            let _e1820 = phi_1193_;
                            let _e1822 = phi_3639_;
                            continue;
                            continuing {
                                phi_4114_ = _e1810;
                                phi_1183_ = _e1812;
                                phi_1186_ = _e1814;
                                phi_1188_ = _e1816;
                                phi_1190_ = _e1818;
                                phi_1192_ = _e1820;
                                phi_4268_ = _e1810;
                                break if !(_e1822);
                            }
                        }
                        let _e1825 = phi_4268_;
                        if _e1825 {
                            break;
                        }
                        let _e1827 = local_10;
                        if (_e1827.member.member.member_3 != 4294967295u) {
                            let _e1833 = bitcast<u32>(_e1827.member.member.member);
                            let _e1837 = (bitcast<i32>((_e1833 >> bitcast<u32>(23i))) & 255i);
                            let _e1838 = (_e1837 + _e276);
                            if (_e1837 == 255i) {
                                phi_3698_ = _e1827.member.member.member;
                            } else {
                                if (_e1837 > 0i) {
                                    if (_e1838 > 0i) {
                                        let _e1842 = (_e1838 < 255i);
                                        if _e1842 {
                                            phi_3677_ = bitcast<f32>((_e1833 + bitcast<u32>((_e276 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3677_ = f32();
                                        }
                                        let _e1849 = phi_3677_;
                                        phi_3679_ = _e1849;
                                        phi_3680_ = select(true, false, _e1842);
                                    } else {
                                        phi_3679_ = f32();
                                        phi_3680_ = true;
                                    }
                                    let _e1852 = phi_3679_;
                                    let _e1854 = phi_3680_;
                                    phi_3681_ = _e1852;
                                    phi_3682_ = _e1854;
                                } else {
                                    phi_3681_ = f32();
                                    phi_3682_ = true;
                                }
                                let _e1856 = phi_3681_;
                                let _e1858 = phi_3682_;
                                if _e1858 {
                                    let _e1859 = (_e1833 & 2147483648u);
                                    let _e1866 = ((_e1833 & 8388607u) | (select(0u, 1u, ((_e1833 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1870 = (_e1866 == 0u);
                                    if _e1870 {
                                        phi_4066_ = bitcast<f32>(_e1859);
                                    } else {
                                        let _e1875 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1866)), 32u, _e1870) - 8u);
                                        let _e1878 = (_e1866 << bitcast<u32>((_e1875 & 31u)));
                                        let _e1880 = ((_e1838 + select(0i, 1i, (_e1837 == 0i))) - bitcast<i32>(_e1875));
                                        if (_e1880 >= 255i) {
                                            phi_4056_ = bitcast<f32>((_e1859 | 2139095040u));
                                            phi_4057_ = f32();
                                            phi_4058_ = true;
                                        } else {
                                            let _e1882 = (_e1880 > 0i);
                                            if _e1882 {
                                                phi_4050_ = bitcast<f32>(((_e1859 | (bitcast<u32>(_e1880) << bitcast<u32>(23i))) | (_e1878 & 8388607u)));
                                                phi_4051_ = f32();
                                            } else {
                                                if (_e1880 < -24i) {
                                                    phi_4016_ = 26u;
                                                } else {
                                                    phi_4016_ = bitcast<u32>((1i - _e1880));
                                                }
                                                let _e1887 = phi_4016_;
                                                let _e1888 = (_e1887 & 31u);
                                                let _e1890 = (_e1878 >> bitcast<u32>(_e1888));
                                                let _e1894 = (_e1878 & ((1u << bitcast<u32>(_e1888)) - 1u));
                                                let _e1898 = (1u << bitcast<u32>(((_e1887 - 1u) & 31u)));
                                                if (_e1894 > _e1898) {
                                                    phi_4037_ = true;
                                                } else {
                                                    if (_e1894 == _e1898) {
                                                        phi_4034_ = ((_e1890 & 1u) == 1u);
                                                    } else {
                                                        phi_4034_ = false;
                                                    }
                                                    let _e1904 = phi_4034_;
                                                    phi_4037_ = _e1904;
                                                }
                                                let _e1906 = phi_4037_;
                                                phi_4050_ = f32();
                                                phi_4051_ = bitcast<f32>((_e1859 | (_e1890 + select(0u, 1u, _e1906))));
                                            }
                                            let _e1919 = phi_4050_;
                                            let _e1921 = phi_4051_;
                                            phi_4056_ = _e1919;
                                            phi_4057_ = _e1921;
                                            phi_4058_ = _e1882;
                                        }
                                        let _e1925 = phi_4056_;
                                        let _e1927 = phi_4057_;
                                        let _e1929 = phi_4058_;
                                        phi_4066_ = select(_e1927, _e1925, _e1929);
                                    }
                                    let _e1933 = phi_4066_;
                                    phi_3697_ = _e1933;
                                } else {
                                    phi_3697_ = _e1856;
                                }
                                let _e1935 = phi_3697_;
                                phi_3698_ = _e1935;
                            }
                            let _e1937 = phi_3698_;
                            let _e1938 = bitcast<u32>(_e1937);
                            if ((_e1938 & 2147483647u) >= 2139095040u) {
                                phi_3710_ = bitcast<f32>(((_e1938 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3710_ = _e1937;
                            }
                            let _e1945 = phi_3710_;
                            phi_3715_ = type_22(_e1945, _e1827.member.member.member_1, _e1827.member.member.member_2, _e1827.member.member.member_3);
                        } else {
                            phi_3715_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1950 = phi_3715_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_2.member[_e136] = _e1950;
                        let _e1954 = local_11;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e1954.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e1959 = select(0u, 1u, (_e220 <= _e230));
                        if (_e1959 > 0u) {
                            let _e1961 = (1u < _e104);
                            if _e1961 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1965 = atomicAdd((&global_6.member[0u]), _e1959);
                                if ((_e1965 + _e1959) < _e1965) {
                                    if _e1961 {
                                    } else {
                                        break;
                                    }
                                    let _e1970 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1973 = select(0u, 1u, (_e1950.member_3 != 4294967295u));
                        if (_e1973 > 0u) {
                            let _e1975 = (3u < _e104);
                            if _e1975 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1979 = atomicAdd((&global_6.member[2u]), _e1973);
                                if ((_e1979 + _e1973) < _e1979) {
                                    if _e1975 {
                                    } else {
                                        break;
                                    }
                                    let _e1984 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1954.member_1 > 0u) {
                            let _e1986 = (5u < _e104);
                            if _e1986 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1990 = atomicAdd((&global_6.member[4u]), _e1954.member_1);
                                if ((_e1990 + _e1954.member_1) < _e1990) {
                                    if _e1986 {
                                    } else {
                                        break;
                                    }
                                    let _e1995 = atomicAdd((&global_6.member[5u]), 1u);
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
