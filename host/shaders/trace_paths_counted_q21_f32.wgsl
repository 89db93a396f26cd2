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
    var phi_4120_: bool;
    var phi_1183_: type_42;
    var phi_1186_: u32;
    var phi_1188_: bool;
    var phi_1190_: u32;
    var phi_1192_: type_53;
    var phi_1203_: bool;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: type_53;
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
    var phi_4114_: bool;
    var phi_4360_: bool;
    var phi_2386_: type_42;
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
    var phi_3620_: type_42;
    var phi_3621_: bool;
    var phi_3622_: u32;
    var phi_3623_: type_53;
    var phi_3631_: type_42;
    var phi_3634_: type_53;
    var phi_4277_: bool;
    var phi_3635_: type_42;
    var phi_3636_: u32;
    var phi_3637_: bool;
    var phi_3638_: u32;
    var phi_3639_: type_53;
    var phi_4276_: bool;
    var phi_3640_: type_42;
    var phi_3641_: u32;
    var phi_3642_: bool;
    var phi_3643_: u32;
    var phi_3644_: type_53;
    var phi_4275_: bool;
    var phi_1184_: type_42;
    var phi_1187_: u32;
    var phi_1189_: bool;
    var phi_1191_: u32;
    var phi_1193_: type_53;
    var phi_3645_: bool;
    var phi_4274_: bool;
    var local_10: type_42;
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
    var phi_3721_: type_22;
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
                        phi_4120_ = false;
                        phi_1183_ = type_42(type_39(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e605), 0u, 0u);
                        phi_1186_ = ((3u * _e94) + 1u);
                        phi_1188_ = (_e607 <= _e605);
                        phi_1190_ = 0u;
                        phi_1192_ = type_53(type_34(vec4<f32>((f32(_e619) * _e148), (f32(_e625) * _e148), (f32(_e631) * _e148), 0f), vec4<f32>((f32(_e636) * _e148), (f32(_e640) * _e148), (f32(_e644) * _e148), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        loop {
                            let _e654 = phi_4120_;
                            let _e656 = phi_1183_;
                            let _e658 = phi_1186_;
                            let _e660 = phi_1188_;
                            let _e662 = phi_1190_;
                            let _e664 = phi_1192_;
                            local_10 = _e656;
                            local_11 = _e656;
                            if _e660 {
                                phi_1203_ = true;
                            } else {
                                phi_1203_ = (_e662 > 0u);
                            }
                            let _e667 = phi_1203_;
                            if _e667 {
                                let _e668 = (_e658 > 0u);
                                if _e668 {
                                    if _e660 {
                                        phi_1289_ = _e660;
                                        phi_1290_ = _e662;
                                        phi_1291_ = _e664;
                                    } else {
                                        let _e669 = (_e662 - 1u);
                                        let _e670 = (_e669 % 128u);
                                        let _e671 = (_e670 < 128u);
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e673 = local_7[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e675 = local_6[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e677 = local_5[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e679 = local_4[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e681 = local_3[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e683 = local_2[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
                                            break;
                                        }
                                        let _e688 = local_8[_e670];
                                        if _e671 {
                                        } else {
                                            phi_4274_ = true;
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
                                        let _e704 = ((_e700.member_1 & 2147483648u) != 0u);
                                        if _e704 {
                                            phi_1309_ = _e656;
                                            phi_1312_ = type_7(0u, ((_e700.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e711 = phi_1309_;
                                                let _e713 = phi_1312_;
                                                local_12 = _e711;
                                                if (_e713.member < _e713.member_1) {
                                                    phi_1313_ = type_7((_e713.member + 1u), _e713.member_1);
                                                    phi_1335_ = type_7(1u, _e713.member);
                                                } else {
                                                    phi_1313_ = _e713;
                                                    phi_1335_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e726 = phi_1313_;
                                                let _e728 = phi_1335_;
                                                let _e732 = (bitcast<i32>(_e728.member) != 0i);
                                                if _e732 {
                                                    let _e738 = type_42(_e711.member, _e711.member_1, (_e711.member_2 + 1u));
                                                    let _e739 = ((_e700.member_1 & 268435455u) + _e728.member_1);
                                                    let _e740 = (_e739 < _e96);
                                                    if _e740 {
                                                        if _e740 {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e744 = global_1.member[_e739].member_1;
                                                        phi_1359_ = _e744;
                                                    } else {
                                                        phi_1359_ = 4294967295u;
                                                    }
                                                    let _e746 = phi_1359_;
                                                    if (_e739 >= _e96) {
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e740 {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        if (_e616 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e753 = global_1.member[_e739].member[_e616];
                                                        if (_e622 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e759 = global_1.member[_e739].member[_e622];
                                                        if (_e628 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_1.member[_e739].member[_e628];
                                                        let _e767 = (3u + _e616);
                                                        if (_e767 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e773 = global_1.member[_e739].member[_e767];
                                                        let _e774 = (3u + _e622);
                                                        if (_e774 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e780 = global_1.member[_e739].member[_e774];
                                                        let _e781 = (3u + _e628);
                                                        if (_e781 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e787 = global_1.member[_e739].member[_e781];
                                                        let _e789 = (6u + _e616);
                                                        if (_e789 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e795 = global_1.member[_e739].member[_e789];
                                                        let _e796 = (6u + _e622);
                                                        if (_e796 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e802 = global_1.member[_e739].member[_e796];
                                                        let _e803 = (6u + _e628);
                                                        if (_e803 < 9u) {
                                                        } else {
                                                            phi_4114_ = true;
                                                            break;
                                                        }
                                                        let _e809 = global_1.member[_e739].member[_e803];
                                                        phi_1451_ = array<array<f32, 3>, 3>(array<f32, 3>(_e753, _e759, _e765), array<f32, 3>(_e773, _e780, _e787), array<f32, 3>(_e795, _e802, _e809));
                                                    }
                                                    let _e813 = phi_1451_;
                                                    let _e822 = (_e813[0][2] - _e454);
                                                    let _e825 = (((_e813[0][0] - _e321) * _e493) - (_e822 * _e361));
                                                    let _e828 = (((_e813[0][1] - _e388) * _e493) - (_e822 * _e427));
                                                    let _e835 = (_e813[1][2] - _e454);
                                                    let _e838 = (((_e813[1][0] - _e321) * _e493) - (_e835 * _e361));
                                                    let _e841 = (((_e813[1][1] - _e388) * _e493) - (_e835 * _e427));
                                                    let _e848 = (_e813[2][2] - _e454);
                                                    let _e851 = (((_e813[2][0] - _e321) * _e493) - (_e848 * _e361));
                                                    let _e854 = (((_e813[2][1] - _e388) * _e493) - (_e848 * _e427));
                                                    let _e855 = (_e851 * _e841);
                                                    let _e856 = (_e854 * _e838);
                                                    let _e857 = (_e825 * _e854);
                                                    let _e858 = (_e828 * _e851);
                                                    let _e859 = (_e838 * _e828);
                                                    let _e860 = (_e841 * _e825);
                                                    let _e865 = (((_e855 >= _e856) && (_e857 >= _e858)) && (_e859 >= _e860));
                                                    if (_e865 || (((_e855 <= _e856) && (_e857 <= _e858)) && (_e859 <= _e860))) {
                                                        let _e872 = select(-1f, 1f, _e865);
                                                        let _e874 = ((_e855 - _e856) * _e872);
                                                        let _e876 = select(0f, _e874, (_e874 > 0f));
                                                        let _e878 = ((_e857 - _e858) * _e872);
                                                        let _e880 = select(0f, _e878, (_e878 > 0f));
                                                        let _e882 = ((_e859 - _e860) * _e872);
                                                        let _e884 = select(0f, _e882, (_e882 > 0f));
                                                        let _e886 = ((_e876 + _e880) + _e884);
                                                        if (_e886 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2335_ = type_22();
                                                            phi_2336_ = true;
                                                            phi_2337_ = false;
                                                        } else {
                                                            let _e889 = select(_e838, _e825, (_e825 < _e838));
                                                            if (select(_e851, _e889, (_e889 < _e851)) > 0f) {
                                                                phi_1603_ = true;
                                                            } else {
                                                                let _e894 = select(_e838, _e825, (_e825 > _e838));
                                                                phi_1603_ = (select(_e851, _e894, (_e894 > _e851)) < 0f);
                                                            }
                                                            let _e899 = phi_1603_;
                                                            if _e899 {
                                                                phi_2332_ = type_22();
                                                                phi_2333_ = true;
                                                                phi_2334_ = false;
                                                            } else {
                                                                let _e901 = select(_e841, _e828, (_e828 < _e841));
                                                                if (select(_e854, _e901, (_e901 < _e854)) > 0f) {
                                                                    phi_1632_ = true;
                                                                } else {
                                                                    let _e906 = select(_e841, _e828, (_e828 > _e841));
                                                                    phi_1632_ = (select(_e854, _e906, (_e906 > _e854)) < 0f);
                                                                }
                                                                let _e911 = phi_1632_;
                                                                if _e911 {
                                                                    phi_2330_ = type_22();
                                                                    phi_2331_ = false;
                                                                } else {
                                                                    let _e913 = select(_e813[1][0], _e813[0][0], (_e813[0][0] < _e813[1][0]));
                                                                    let _e917 = select(_e813[1][0], _e813[0][0], (_e813[0][0] > _e813[1][0]));
                                                                    let _e921 = select(_e813[1][1], _e813[0][1], (_e813[0][1] < _e813[1][1]));
                                                                    let _e925 = select(_e813[1][1], _e813[0][1], (_e813[0][1] > _e813[1][1]));
                                                                    let _e929 = select(_e813[1][2], _e813[0][2], (_e813[0][2] < _e813[1][2]));
                                                                    let _e933 = select(_e813[1][2], _e813[0][2], (_e813[0][2] > _e813[1][2]));
                                                                    let _e938 = ((select(_e813[2][0], _e913, (_e913 < _e813[2][0])) - _e359) * _e364);
                                                                    let _e939 = ((select(_e813[2][0], _e917, (_e917 > _e813[2][0])) - _e360) * _e364);
                                                                    let _e942 = ((select(_e813[2][1], _e921, (_e921 < _e813[2][1])) - _e425) * _e430);
                                                                    let _e943 = ((select(_e813[2][1], _e925, (_e925 > _e813[2][1])) - _e426) * _e430);
                                                                    let _e946 = ((select(_e813[2][2], _e929, (_e929 < _e813[2][2])) - _e491) * _e496);
                                                                    let _e947 = ((select(_e813[2][2], _e933, (_e933 > _e813[2][2])) - _e492) * _e496);
                                                                    let _e949 = select(_e947, _e946, (_e946 < _e947));
                                                                    let _e951 = select(_e947, _e946, (_e946 > _e947));
                                                                    let _e953 = select(_e939, _e938, (_e938 < _e939));
                                                                    let _e955 = select(_e943, _e942, (_e942 < _e943));
                                                                    let _e957 = select(_e955, _e953, (_e953 > _e955));
                                                                    let _e959 = select(_e949, _e957, (_e957 > _e949));
                                                                    let _e961 = select(_e939, _e938, (_e938 > _e939));
                                                                    let _e963 = select(_e943, _e942, (_e942 > _e943));
                                                                    let _e965 = select(_e963, _e961, (_e961 < _e963));
                                                                    let _e967 = select(_e951, _e965, (_e965 < _e951));
                                                                    let _e968 = -(_e949);
                                                                    let _e974 = select(_e607, _e959, (_e959 > _e607));
                                                                    if (_e974 > (_e967 + (select(_e968, _e951, (_e951 > _e968)) * 0.0000019073523f))) {
                                                                        phi_2325_ = type_22();
                                                                        phi_2326_ = true;
                                                                    } else {
                                                                        let _e976 = (_e974 > _e711.member.member_1);
                                                                        if _e976 {
                                                                            phi_2324_ = type_22();
                                                                        } else {
                                                                            let _e977 = vec3<f32>(_e813[0][0], _e813[0][1], _e813[0][2]);
                                                                            let _e978 = vec3<f32>(_e813[1][0], _e813[1][1], _e813[1][2]);
                                                                            let _e979 = vec3<f32>(_e813[2][0], _e813[2][1], _e813[2][2]);
                                                                            let _e980 = (_e813[1][0] - _e813[0][0]);
                                                                            let _e981 = (_e813[1][1] - _e813[0][1]);
                                                                            let _e982 = (_e813[1][2] - _e813[0][2]);
                                                                            let _e983 = vec3<f32>(_e980, _e981, _e982);
                                                                            let _e984 = (_e813[2][0] - _e813[1][0]);
                                                                            let _e985 = (_e813[2][1] - _e813[1][1]);
                                                                            let _e986 = (_e813[2][2] - _e813[1][2]);
                                                                            let _e987 = vec3<f32>(_e984, _e985, _e986);
                                                                            let _e988 = (_e813[0][0] - _e813[2][0]);
                                                                            let _e989 = (_e813[0][1] - _e813[2][1]);
                                                                            let _e990 = (_e813[0][2] - _e813[2][2]);
                                                                            let _e991 = vec3<f32>(_e988, _e989, _e990);
                                                                            let _e994 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                            let _e997 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                            let _e999 = select(_e997, _e994, (_e994 > _e997));
                                                                            let _e1002 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                            let _e1004 = select(_e1002, _e999, (_e999 > _e1002));
                                                                            let _e1007 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                            let _e1010 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                            let _e1012 = select(_e1010, _e1007, (_e1007 > _e1010));
                                                                            let _e1015 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                            let _e1017 = select(_e1015, _e1012, (_e1012 > _e1015));
                                                                            let _e1020 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                            let _e1023 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                            let _e1025 = select(_e1023, _e1020, (_e1020 > _e1023));
                                                                            let _e1028 = bitcast<f32>((bitcast<u32>(_e990) & 2147483647u));
                                                                            let _e1030 = select(_e1028, _e1025, (_e1025 > _e1028));
                                                                            let _e1032 = select(_e1017, _e1004, (_e1004 > _e1017));
                                                                            let _e1034 = select(_e1030, _e1032, (_e1032 > _e1030));
                                                                            if (_e1004 == _e1034) {
                                                                                phi_2051_ = _e841;
                                                                                phi_2052_ = _e838;
                                                                                phi_2053_ = _e828;
                                                                                phi_2054_ = _e825;
                                                                                phi_2055_ = _e977;
                                                                                phi_2056_ = _e991;
                                                                                phi_2057_ = _e987;
                                                                                phi_2058_ = _e983;
                                                                            } else {
                                                                                let _e1036 = (_e1017 == _e1034);
                                                                                let _e1041 = vec3(_e1036);
                                                                                phi_2051_ = select(_e828, _e854, _e1036);
                                                                                phi_2052_ = select(_e825, _e851, _e1036);
                                                                                phi_2053_ = select(_e854, _e841, _e1036);
                                                                                phi_2054_ = select(_e851, _e838, _e1036);
                                                                                phi_2055_ = select(_e979, _e978, _e1041);
                                                                                phi_2056_ = select(_e987, _e983, _e1041);
                                                                                phi_2057_ = select(_e983, _e991, _e1041);
                                                                                phi_2058_ = select(_e991, _e987, _e1041);
                                                                            }
                                                                            let _e1047 = phi_2051_;
                                                                            let _e1049 = phi_2052_;
                                                                            let _e1051 = phi_2053_;
                                                                            let _e1053 = phi_2054_;
                                                                            let _e1055 = phi_2055_;
                                                                            let _e1057 = phi_2056_;
                                                                            let _e1059 = phi_2057_;
                                                                            let _e1061 = phi_2058_;
                                                                            let _e1068 = ((_e1059.y * _e1057.z) - (_e1057.y * _e1059.z));
                                                                            let _e1073 = ((_e1059.z * _e1057.x) - (_e1057.z * _e1059.x));
                                                                            let _e1076 = ((_e1059.x * _e1057.y) - (_e1057.x * _e1059.y));
                                                                            if (_e876 >= _e880) {
                                                                                phi_2095_ = select(true, false, (_e876 >= _e884));
                                                                            } else {
                                                                                phi_2095_ = true;
                                                                            }
                                                                            let _e1081 = phi_2095_;
                                                                            if _e1081 {
                                                                                phi_2104_ = select(_e979, _e978, vec3((_e880 >= _e884)));
                                                                            } else {
                                                                                phi_2104_ = _e977;
                                                                            }
                                                                            let _e1086 = phi_2104_;
                                                                            let _e1097 = (((_e1068 * (_e1086.x - _e321)) + (_e1073 * (_e1086.y - _e388))) + (_e1076 * (_e1086.z - _e454)));
                                                                            let _e1102 = (((_e1068 * _e361) + (_e1073 * _e427)) + (_e1076 * _e493));
                                                                            let _e1103 = (_e1049 - _e1053);
                                                                            let _e1104 = (_e1047 - _e1051);
                                                                            let _e1112 = (-(((_e1053 * _e1103) + (_e1051 * _e1104))) / ((_e1103 * _e1103) + (_e1104 * _e1104)));
                                                                            let _e1114 = select(1f, _e1112, (_e1112 < 1f));
                                                                            let _e1116 = select(0f, _e1114, (_e1114 > 0f));
                                                                            let _e1129 = ((_e1055.x + (_e1061.x * _e1116)) - _e321);
                                                                            let _e1130 = ((_e1055.y + (_e1061.y * _e1116)) - _e388);
                                                                            let _e1131 = ((_e1055.z + (_e1061.z * _e1116)) - _e454);
                                                                            let _e1132 = (_e1131 / _e493);
                                                                            let _e1144 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                                                            let _e1147 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                            let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                            let _e1152 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                            let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                            let _e1160 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                            let _e1163 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                            let _e1165 = select(_e1163, _e1160, (_e1160 > _e1163));
                                                                            let _e1168 = bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1068 * _e1129) + (_e1073 * _e1130)) + (_e1076 * _e1131)) - _e1097)) & 2147483647u)) <= ((0.0000009536743f * select(_e1034, _e1154, (_e1154 > _e1034))) * select(_e1168, _e1165, (_e1165 > _e1168)))) {
                                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1059.x) & 2147483647u));
                                                                                let _e1181 = bitcast<f32>((bitcast<u32>(_e1059.y) & 2147483647u));
                                                                                let _e1183 = select(_e1181, _e1178, (_e1178 > _e1181));
                                                                                let _e1186 = bitcast<f32>((bitcast<u32>(_e1059.z) & 2147483647u));
                                                                                let _e1192 = bitcast<f32>((bitcast<u32>(_e1057.x) & 2147483647u));
                                                                                let _e1195 = bitcast<f32>((bitcast<u32>(_e1057.y) & 2147483647u));
                                                                                let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                                                                                let _e1200 = bitcast<f32>((bitcast<u32>(_e1057.z) & 2147483647u));
                                                                                let _e1204 = (bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u)) > ((0.0000038146973f * select(_e1186, _e1183, (_e1183 > _e1186))) * select(_e1200, _e1197, (_e1197 > _e1200))));
                                                                                if _e1204 {
                                                                                    phi_2269_ = (_e1097 / _e1102);
                                                                                } else {
                                                                                    phi_2269_ = f32();
                                                                                }
                                                                                let _e1207 = phi_2269_;
                                                                                phi_2271_ = _e1207;
                                                                                phi_2272_ = select(true, false, _e1204);
                                                                            } else {
                                                                                phi_2271_ = f32();
                                                                                phi_2272_ = true;
                                                                            }
                                                                            let _e1210 = phi_2271_;
                                                                            let _e1212 = phi_2272_;
                                                                            if _e1212 {
                                                                                let _e1220 = (((_e1068 * (_e1129 - (_e361 * _e1132))) + (_e1073 * (_e1130 - (_e427 * _e1132)))) / _e1102);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u)) <= _e1034) {
                                                                                    phi_2292_ = (_e1132 + _e1220);
                                                                                } else {
                                                                                    phi_2292_ = _e1132;
                                                                                }
                                                                                let _e1227 = phi_2292_;
                                                                                phi_2293_ = _e1227;
                                                                            } else {
                                                                                phi_2293_ = _e1210;
                                                                            }
                                                                            let _e1229 = phi_2293_;
                                                                            let _e1231 = select(_e967, _e1229, (_e1229 < _e967));
                                                                            let _e1233 = select(_e959, _e1231, (_e1231 > _e959));
                                                                            if (_e1233 >= _e607) {
                                                                                let _e1235 = (_e1233 <= _e711.member.member_1);
                                                                                if _e1235 {
                                                                                    let _e1236 = (1f / _e886);
                                                                                    phi_2316_ = type_22(_e1233, (_e880 * _e1236), (_e884 * _e1236), _e746);
                                                                                } else {
                                                                                    phi_2316_ = type_22();
                                                                                }
                                                                                let _e1241 = phi_2316_;
                                                                                phi_2318_ = _e1241;
                                                                                phi_2319_ = select(true, false, _e1235);
                                                                            } else {
                                                                                phi_2318_ = type_22();
                                                                                phi_2319_ = true;
                                                                            }
                                                                            let _e1244 = phi_2318_;
                                                                            let _e1246 = phi_2319_;
                                                                            if _e1246 {
                                                                                phi_2323_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2323_ = _e1244;
                                                                            }
                                                                            let _e1248 = phi_2323_;
                                                                            phi_2324_ = _e1248;
                                                                        }
                                                                        let _e1250 = phi_2324_;
                                                                        phi_2325_ = _e1250;
                                                                        phi_2326_ = _e976;
                                                                    }
                                                                    let _e1252 = phi_2325_;
                                                                    let _e1254 = phi_2326_;
                                                                    phi_2330_ = _e1252;
                                                                    phi_2331_ = _e1254;
                                                                }
                                                                let _e1256 = phi_2330_;
                                                                let _e1258 = phi_2331_;
                                                                phi_2332_ = _e1256;
                                                                phi_2333_ = _e911;
                                                                phi_2334_ = _e1258;
                                                            }
                                                            let _e1260 = phi_2332_;
                                                            let _e1262 = phi_2333_;
                                                            let _e1264 = phi_2334_;
                                                            phi_2335_ = _e1260;
                                                            phi_2336_ = _e1262;
                                                            phi_2337_ = _e1264;
                                                        }
                                                        let _e1266 = phi_2335_;
                                                        let _e1268 = phi_2336_;
                                                        let _e1270 = phi_2337_;
                                                        phi_2345_ = _e1266;
                                                        phi_2346_ = select(_e1270, true, _e1268);
                                                    } else {
                                                        phi_2345_ = type_22();
                                                        phi_2346_ = true;
                                                    }
                                                    let _e1273 = phi_2345_;
                                                    let _e1275 = phi_2346_;
                                                    if _e1275 {
                                                        phi_2350_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2350_ = _e1273;
                                                    }
                                                    let _e1277 = phi_2350_;
                                                    if (_e1277.member_3 != 4294967295u) {
                                                        if (_e746 != _e613) {
                                                            if (_e1277.member < _e711.member.member.member) {
                                                                phi_2376_ = true;
                                                            } else {
                                                                if (_e1277.member == _e711.member.member.member) {
                                                                    phi_2375_ = (_e1277.member_3 < _e711.member.member.member_3);
                                                                } else {
                                                                    phi_2375_ = false;
                                                                }
                                                                let _e1292 = phi_2375_;
                                                                phi_2376_ = _e1292;
                                                            }
                                                            let _e1294 = phi_2376_;
                                                            if _e1294 {
                                                                phi_2383_ = type_42(type_39(_e1277, _e1277.member), _e738.member_1, _e738.member_2);
                                                            } else {
                                                                phi_2383_ = _e738;
                                                            }
                                                            let _e1301 = phi_2383_;
                                                            phi_2384_ = _e1301;
                                                        } else {
                                                            phi_2384_ = _e738;
                                                        }
                                                        let _e1303 = phi_2384_;
                                                        phi_2385_ = _e1303;
                                                    } else {
                                                        phi_2385_ = _e738;
                                                    }
                                                    let _e1305 = phi_2385_;
                                                    phi_1310_ = _e1305;
                                                } else {
                                                    phi_1310_ = type_42();
                                                }
                                                let _e1307 = phi_1310_;
                                                continue;
                                                continuing {
                                                    phi_1309_ = _e1307;
                                                    phi_1312_ = _e726;
                                                    phi_4114_ = _e654;
                                                    break if !(_e732);
                                                }
                                            }
                                            let _e1310 = phi_4114_;
                                            phi_4274_ = _e1310;
                                            if _e1310 {
                                                break;
                                            }
                                            phi_4360_ = _e1310;
                                            let _e2098 = local_12;
                                            phi_2386_ = _e2098;
                                        } else {
                                            phi_4360_ = _e654;
                                            phi_2386_ = _e656;
                                        }
                                        let _e1312 = phi_4360_;
                                        let _e1314 = phi_2386_;
                                        if _e704 {
                                            phi_3620_ = type_42();
                                            phi_3621_ = bool();
                                            phi_3622_ = u32();
                                            phi_3623_ = type_53();
                                        } else {
                                            if (_e700.member_1 >= _e94) {
                                                phi_3152_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_53(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e700.member_1 < _e94) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1317 = (_e274 * 2u);
                                                let _e1319 = ((1u + _e1317) % 7u);
                                                if (_e1319 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1324 = global_7.member[_e700.member_1][_e1319];
                                                let _e1326 = ((_e1317 + 2u) % 7u);
                                                if (_e1326 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1331 = global_7.member[_e700.member_1][_e1326];
                                                let _e1332 = (_e273 * 2u);
                                                let _e1334 = ((1u + _e1332) % 7u);
                                                if (_e1334 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1339 = global_7.member[_e700.member_1][_e1334];
                                                let _e1341 = ((_e1332 + 2u) % 7u);
                                                if (_e1341 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1346 = global_7.member[_e700.member_1][_e1341];
                                                let _e1347 = (_e275 * 2u);
                                                let _e1349 = ((1u + _e1347) % 7u);
                                                if (_e1349 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1354 = global_7.member[_e700.member_1][_e1349];
                                                let _e1356 = ((_e1347 + 2u) % 7u);
                                                if (_e1356 < 7u) {
                                                } else {
                                                    phi_4274_ = true;
                                                    break;
                                                }
                                                let _e1361 = global_7.member[_e700.member_1][_e1356];
                                                let _e1384 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.x - _e700.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1385 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.y - _e700.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1386 = (bitcast<f32>((bitcast<u32>((_e700.member.member_1.z - _e700.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e1388 = select(_e148, _e1384, (_e1384 > _e148));
                                                let _e1390 = select(_e148, _e1385, (_e1385 > _e148));
                                                let _e1392 = select(_e148, _e1386, (_e1386 > _e148));
                                                let _e1423 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1324 & 2097151u))) - 8388608f) * _e1388));
                                                let _e1428 = (bitcast<i32>((_e1324 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1431 = bitcast<f32>((_e1423 & bitcast<u32>(_e1428)));
                                                let _e1432 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1339 & 2097151u))) - 8388608f) * _e1390));
                                                let _e1437 = (bitcast<i32>((_e1339 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1440 = bitcast<f32>((_e1432 & bitcast<u32>(_e1437)));
                                                let _e1441 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1354 & 2097151u))) - 8388608f) * _e1392));
                                                let _e1446 = (bitcast<i32>((_e1354 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1449 = bitcast<f32>((_e1441 & bitcast<u32>(_e1446)));
                                                let _e1453 = bitcast<f32>((_e1423 & bitcast<u32>(~(_e1428))));
                                                let _e1457 = bitcast<f32>((_e1432 & bitcast<u32>(~(_e1437))));
                                                let _e1461 = bitcast<f32>((_e1441 & bitcast<u32>(~(_e1446))));
                                                let _e1462 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1331 & 2097151u))) - 8388608f) * _e1388));
                                                let _e1467 = (bitcast<i32>((_e1331 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1470 = bitcast<f32>((_e1462 & bitcast<u32>(_e1467)));
                                                let _e1471 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1346 & 2097151u))) - 8388608f) * _e1390));
                                                let _e1476 = (bitcast<i32>((_e1346 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1479 = bitcast<f32>((_e1471 & bitcast<u32>(_e1476)));
                                                let _e1480 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1361 & 2097151u))) - 8388608f) * _e1392));
                                                let _e1485 = (bitcast<i32>((_e1361 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e1488 = bitcast<f32>((_e1480 & bitcast<u32>(_e1485)));
                                                let _e1492 = bitcast<f32>((_e1462 & bitcast<u32>(~(_e1467))));
                                                let _e1496 = bitcast<f32>((_e1471 & bitcast<u32>(~(_e1476))));
                                                let _e1500 = bitcast<f32>((_e1480 & bitcast<u32>(~(_e1485))));
                                                let _e1530 = global_7.member[_e700.member_1][0u];
                                                let _e1534 = global_7.member[_e700.member_1][2u];
                                                let _e1538 = global_7.member[_e700.member_1][4u];
                                                let _e1542 = global_7.member[_e700.member_1][6u];
                                                let _e1554 = (((_e1534 >> bitcast<u32>(22i)) | ((_e1538 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1542 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e1555 = (_e1530 & 268435455u);
                                                let _e1556 = (_e1554 & 268435455u);
                                                let _e1559 = ((_e1530 >> bitcast<u32>(28u)) & 7u);
                                                let _e1567 = ((_e1530 >> bitcast<u32>(31i)) | (((_e1554 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e1568 = (_e1559 != 0u);
                                                if (_e1559 == 0u) {
                                                    phi_3114_ = _e1555;
                                                } else {
                                                    if (_e1559 == 7u) {
                                                        phi_3113_ = 2147483648u;
                                                    } else {
                                                        phi_3113_ = ((2147483648u | (_e1559 << bitcast<u32>(28u))) | (_e1556 & 268435455u));
                                                    }
                                                    let _e1577 = phi_3113_;
                                                    phi_3114_ = _e1577;
                                                }
                                                let _e1579 = phi_3114_;
                                                if _e1568 {
                                                    let _e1580 = (_e1559 != 7u);
                                                    if _e1580 {
                                                        phi_3124_ = (_e1556 + _e1559);
                                                    } else {
                                                        phi_3124_ = u32();
                                                    }
                                                    let _e1583 = phi_3124_;
                                                    phi_3126_ = _e1583;
                                                    phi_3127_ = select(true, false, _e1580);
                                                } else {
                                                    phi_3126_ = u32();
                                                    phi_3127_ = true;
                                                }
                                                let _e1586 = phi_3126_;
                                                let _e1588 = phi_3127_;
                                                if (_e1567 == 0u) {
                                                    phi_3148_ = (_e1555 + select(0u, 1u, !(_e1568)));
                                                } else {
                                                    if (_e1567 == 7u) {
                                                        phi_3147_ = 2147483648u;
                                                    } else {
                                                        phi_3147_ = ((2147483648u | (_e1567 << bitcast<u32>(28u))) | (select(_e1586, _e1556, _e1588) & 268435455u));
                                                    }
                                                    let _e1601 = phi_3147_;
                                                    phi_3148_ = _e1601;
                                                }
                                                let _e1603 = phi_3148_;
                                                phi_3152_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e700.member.member.x + _e1431), (_e700.member.member.x + _e1453), (_e700.member.member_1.x - _e1470), (_e700.member.member_1.x - _e1492)), vec4<f32>((_e700.member.member.y + _e1440), (_e700.member.member.y + _e1457), (_e700.member.member_1.y - _e1479), (_e700.member.member_1.y - _e1496)), vec4<f32>((_e700.member.member.z + _e1449), (_e700.member.member.z + _e1461), (_e700.member.member_1.z - _e1488), (_e700.member.member_1.z - _e1500))), type_53(type_34((_e700.member.member + vec4<f32>(_e1431, _e1440, _e1449, 0f)), (_e700.member.member_1 - vec4<f32>(_e1470, _e1479, _e1488, 0f))), _e1579), type_53(type_34((_e700.member.member + vec4<f32>(_e1453, _e1457, _e1461, 0f)), (_e700.member.member_1 - vec4<f32>(_e1492, _e1496, _e1500, 0f))), _e1603));
                                            }
                                            let _e1608 = phi_3152_;
                                            let _e1627 = ((_e1608.member[0].x - _e359) * _e364);
                                            let _e1628 = ((_e1608.member[0].y - _e359) * _e364);
                                            let _e1629 = ((_e1608.member[0].z - _e360) * _e364);
                                            let _e1630 = ((_e1608.member[0].w - _e360) * _e364);
                                            let _e1640 = ((_e1608.member[1].x - _e425) * _e430);
                                            let _e1641 = ((_e1608.member[1].y - _e425) * _e430);
                                            let _e1642 = ((_e1608.member[1].z - _e426) * _e430);
                                            let _e1643 = ((_e1608.member[1].w - _e426) * _e430);
                                            let _e1653 = ((_e1608.member[2].x - _e491) * _e496);
                                            let _e1654 = ((_e1608.member[2].y - _e491) * _e496);
                                            let _e1655 = ((_e1608.member[2].z - _e492) * _e496);
                                            let _e1656 = ((_e1608.member[2].w - _e492) * _e496);
                                            let _e1658 = select(_e1655, _e1653, (_e1653 < _e1655));
                                            let _e1660 = select(_e1656, _e1654, (_e1654 < _e1656));
                                            let _e1662 = select(_e1655, _e1653, (_e1653 > _e1655));
                                            let _e1664 = select(_e1656, _e1654, (_e1654 > _e1656));
                                            let _e1666 = select(_e1629, _e1627, (_e1627 < _e1629));
                                            let _e1668 = select(_e1630, _e1628, (_e1628 < _e1630));
                                            let _e1670 = select(_e1642, _e1640, (_e1640 < _e1642));
                                            let _e1672 = select(_e1643, _e1641, (_e1641 < _e1643));
                                            let _e1674 = select(_e1670, _e1666, (_e1666 > _e1670));
                                            let _e1676 = select(_e1672, _e1668, (_e1668 > _e1672));
                                            let _e1678 = select(_e1658, _e1674, (_e1674 > _e1658));
                                            let _e1680 = select(_e1660, _e1676, (_e1676 > _e1660));
                                            let _e1682 = select(_e1629, _e1627, (_e1627 > _e1629));
                                            let _e1684 = select(_e1630, _e1628, (_e1628 > _e1630));
                                            let _e1686 = select(_e1642, _e1640, (_e1640 > _e1642));
                                            let _e1688 = select(_e1643, _e1641, (_e1641 > _e1643));
                                            let _e1690 = select(_e1686, _e1682, (_e1682 < _e1686));
                                            let _e1692 = select(_e1688, _e1684, (_e1684 < _e1688));
                                            let _e1697 = -(_e1658);
                                            let _e1698 = -(_e1660);
                                            let _e1705 = (select(_e1662, _e1690, (_e1690 < _e1662)) + (select(_e1697, _e1662, (_e1662 > _e1697)) * 0.0000019073523f));
                                            let _e1706 = (select(_e1664, _e1692, (_e1692 < _e1664)) + (select(_e1698, _e1664, (_e1664 > _e1698)) * 0.0000019073523f));
                                            let _e1708 = select(_e607, _e1678, (_e1678 > _e607));
                                            let _e1710 = select(_e607, _e1680, (_e1680 > _e607));
                                            let _e1715 = (_e1708 <= select(_e1314.member.member_1, _e1705, (_e1705 < _e1314.member.member_1)));
                                            let _e1716 = (_e1710 <= select(_e1314.member.member_1, _e1706, (_e1706 < _e1314.member.member_1)));
                                            let _e1717 = (_e1708 <= _e1710);
                                            if _e1715 {
                                                if _e1716 {
                                                    if _e1717 {
                                                        phi_3517_ = _e1608.member_2;
                                                    } else {
                                                        phi_3517_ = _e1608.member_1;
                                                    }
                                                    let _e1721 = phi_3517_;
                                                    let _e1742 = (_e698 % 128u);
                                                    let _e1743 = (_e1742 < 128u);
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1742] = _e1721.member_1;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1742] = _e1721.member.member.x;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1742] = _e1721.member.member.y;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1742] = _e1721.member.member.z;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1742] = _e1721.member.member_1.x;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1742] = _e1721.member.member_1.y;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1742] = _e1721.member.member_1.z;
                                                    if _e1743 {
                                                    } else {
                                                        phi_4274_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1742] = select(_e1708, _e1710, _e1717);
                                                    if _e1717 {
                                                        phi_3593_ = _e1608.member_1;
                                                    } else {
                                                        phi_3593_ = _e1608.member_2;
                                                    }
                                                    let _e1756 = phi_3593_;
                                                    phi_3594_ = (_e698 + 1u);
                                                    phi_3595_ = _e1756;
                                                } else {
                                                    phi_3594_ = u32();
                                                    phi_3595_ = type_53();
                                                }
                                                let _e1758 = phi_3594_;
                                                let _e1760 = phi_3595_;
                                                phi_3597_ = _e1758;
                                                phi_3598_ = _e1760;
                                                phi_3599_ = select(true, false, _e1716);
                                            } else {
                                                phi_3597_ = u32();
                                                phi_3598_ = type_53();
                                                phi_3599_ = true;
                                            }
                                            let _e1763 = phi_3597_;
                                            let _e1765 = phi_3598_;
                                            let _e1767 = phi_3599_;
                                            if _e1767 {
                                                if _e1715 {
                                                    phi_3608_ = _e1608.member_1;
                                                } else {
                                                    phi_3608_ = _e1608.member_2;
                                                }
                                                let _e1771 = phi_3608_;
                                                phi_3613_ = select(_e1716, true, _e1715);
                                                phi_3615_ = _e1771;
                                            } else {
                                                phi_3613_ = _e696;
                                                phi_3615_ = _e1765;
                                            }
                                            let _e1774 = phi_3613_;
                                            let _e1776 = phi_3615_;
                                            phi_3620_ = type_42(_e1314.member, (_e1314.member_1 + 1u), _e1314.member_2);
                                            phi_3621_ = _e1774;
                                            phi_3622_ = select(_e1763, _e698, _e1767);
                                            phi_3623_ = _e1776;
                                        }
                                        let _e1779 = phi_3620_;
                                        let _e1781 = phi_3621_;
                                        let _e1783 = phi_3622_;
                                        let _e1785 = phi_3623_;
                                        if _e704 {
                                            phi_3631_ = _e1314;
                                            phi_3634_ = _e700;
                                        } else {
                                            phi_3631_ = _e1779;
                                            phi_3634_ = _e1785;
                                        }
                                        let _e1787 = phi_3631_;
                                        let _e1789 = phi_3634_;
                                        phi_4277_ = _e1312;
                                        phi_3635_ = _e1787;
                                        phi_3636_ = (_e658 - 1u);
                                        phi_3637_ = select(_e1781, false, _e704);
                                        phi_3638_ = select(_e1783, _e698, _e704);
                                        phi_3639_ = _e1789;
                                    } else {
                                        phi_4277_ = _e654;
                                        phi_3635_ = _e656;
                                        phi_3636_ = _e658;
                                        phi_3637_ = _e696;
                                        phi_3638_ = _e698;
                                        phi_3639_ = _e700;
                                    }
                                    let _e1793 = phi_4277_;
                                    let _e1795 = phi_3635_;
                                    let _e1797 = phi_3636_;
                                    let _e1799 = phi_3637_;
                                    let _e1801 = phi_3638_;
                                    let _e1803 = phi_3639_;
                                    phi_4276_ = _e1793;
                                    phi_3640_ = _e1795;
                                    phi_3641_ = _e1797;
                                    phi_3642_ = _e1799;
                                    phi_3643_ = _e1801;
                                    phi_3644_ = _e1803;
                                } else {
                                    phi_4276_ = _e654;
                                    phi_3640_ = type_42();
                                    phi_3641_ = u32();
                                    phi_3642_ = bool();
                                    phi_3643_ = u32();
                                    phi_3644_ = type_53();
                                }
                                let _e1805 = phi_4276_;
                                let _e1807 = phi_3640_;
                                let _e1809 = phi_3641_;
                                let _e1811 = phi_3642_;
                                let _e1813 = phi_3643_;
                                let _e1815 = phi_3644_;
                                phi_4275_ = _e1805;
                                phi_1184_ = _e1807;
                                phi_1187_ = _e1809;
                                phi_1189_ = _e1811;
                                phi_1191_ = _e1813;
                                phi_1193_ = _e1815;
                                phi_3645_ = _e668;
                            } else {
                                phi_4275_ = _e654;
                                phi_1184_ = type_42();
                                phi_1187_ = u32();
                                phi_1189_ = bool();
                                phi_1191_ = u32();
                                phi_1193_ = type_53();
                                phi_3645_ = false;
                            }
                            let _e1817 = phi_4275_;
                            let _e1819 = phi_1184_;
                            let _e1821 = phi_1187_;
                            let _e1823 = phi_1189_;
                            let _e1825 = phi_1191_;
                            let _e1827 = phi_1193_;
                            let _e1829 = phi_3645_;
                            continue;
                            continuing {
                                phi_4120_ = _e1817;
                                phi_1183_ = _e1819;
                                phi_1186_ = _e1821;
                                phi_1188_ = _e1823;
                                phi_1190_ = _e1825;
                                phi_1192_ = _e1827;
                                phi_4274_ = _e1817;
                                break if !(_e1829);
                            }
                        }
                        let _e1832 = phi_4274_;
                        if _e1832 {
                            break;
                        }
                        let _e1834 = local_10;
                        if (_e1834.member.member.member_3 != 4294967295u) {
                            let _e1840 = bitcast<u32>(_e1834.member.member.member);
                            let _e1844 = (bitcast<i32>((_e1840 >> bitcast<u32>(23i))) & 255i);
                            let _e1845 = (_e1844 + _e276);
                            if (_e1844 == 255i) {
                                phi_3704_ = _e1834.member.member.member;
                            } else {
                                if (_e1844 > 0i) {
                                    if (_e1845 > 0i) {
                                        let _e1849 = (_e1845 < 255i);
                                        if _e1849 {
                                            phi_3683_ = bitcast<f32>((_e1840 + bitcast<u32>((_e276 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_3683_ = f32();
                                        }
                                        let _e1856 = phi_3683_;
                                        phi_3685_ = _e1856;
                                        phi_3686_ = select(true, false, _e1849);
                                    } else {
                                        phi_3685_ = f32();
                                        phi_3686_ = true;
                                    }
                                    let _e1859 = phi_3685_;
                                    let _e1861 = phi_3686_;
                                    phi_3687_ = _e1859;
                                    phi_3688_ = _e1861;
                                } else {
                                    phi_3687_ = f32();
                                    phi_3688_ = true;
                                }
                                let _e1863 = phi_3687_;
                                let _e1865 = phi_3688_;
                                if _e1865 {
                                    let _e1866 = (_e1840 & 2147483648u);
                                    let _e1873 = ((_e1840 & 8388607u) | (select(0u, 1u, ((_e1840 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1877 = (_e1873 == 0u);
                                    if _e1877 {
                                        phi_4072_ = bitcast<f32>(_e1866);
                                    } else {
                                        let _e1882 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1873)), 32u, _e1877) - 8u);
                                        let _e1885 = (_e1873 << bitcast<u32>((_e1882 & 31u)));
                                        let _e1887 = ((_e1845 + select(0i, 1i, (_e1844 == 0i))) - bitcast<i32>(_e1882));
                                        if (_e1887 >= 255i) {
                                            phi_4062_ = bitcast<f32>((_e1866 | 2139095040u));
                                            phi_4063_ = f32();
                                            phi_4064_ = true;
                                        } else {
                                            let _e1889 = (_e1887 > 0i);
                                            if _e1889 {
                                                phi_4056_ = bitcast<f32>(((_e1866 | (bitcast<u32>(_e1887) << bitcast<u32>(23i))) | (_e1885 & 8388607u)));
                                                phi_4057_ = f32();
                                            } else {
                                                if (_e1887 < -24i) {
                                                    phi_4022_ = 26u;
                                                } else {
                                                    phi_4022_ = bitcast<u32>((1i - _e1887));
                                                }
                                                let _e1894 = phi_4022_;
                                                let _e1895 = (_e1894 & 31u);
                                                let _e1897 = (_e1885 >> bitcast<u32>(_e1895));
                                                let _e1901 = (_e1885 & ((1u << bitcast<u32>(_e1895)) - 1u));
                                                let _e1905 = (1u << bitcast<u32>(((_e1894 - 1u) & 31u)));
                                                if (_e1901 > _e1905) {
                                                    phi_4043_ = true;
                                                } else {
                                                    if (_e1901 == _e1905) {
                                                        phi_4040_ = ((_e1897 & 1u) == 1u);
                                                    } else {
                                                        phi_4040_ = false;
                                                    }
                                                    let _e1911 = phi_4040_;
                                                    phi_4043_ = _e1911;
                                                }
                                                let _e1913 = phi_4043_;
                                                phi_4056_ = f32();
                                                phi_4057_ = bitcast<f32>((_e1866 | (_e1897 + select(0u, 1u, _e1913))));
                                            }
                                            let _e1926 = phi_4056_;
                                            let _e1928 = phi_4057_;
                                            phi_4062_ = _e1926;
                                            phi_4063_ = _e1928;
                                            phi_4064_ = _e1889;
                                        }
                                        let _e1932 = phi_4062_;
                                        let _e1934 = phi_4063_;
                                        let _e1936 = phi_4064_;
                                        phi_4072_ = select(_e1934, _e1932, _e1936);
                                    }
                                    let _e1940 = phi_4072_;
                                    phi_3703_ = _e1940;
                                } else {
                                    phi_3703_ = _e1863;
                                }
                                let _e1942 = phi_3703_;
                                phi_3704_ = _e1942;
                            }
                            let _e1944 = phi_3704_;
                            let _e1945 = bitcast<u32>(_e1944);
                            if ((_e1945 & 2147483647u) >= 2139095040u) {
                                phi_3716_ = bitcast<f32>(((_e1945 & 2147483648u) | 2139095039u));
                            } else {
                                phi_3716_ = _e1944;
                            }
                            let _e1952 = phi_3716_;
                            phi_3721_ = type_22(_e1952, _e1834.member.member.member_1, _e1834.member.member.member_2, _e1834.member.member.member_3);
                        } else {
                            phi_3721_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1957 = phi_3721_;
                        if _e152 {
                        } else {
                            break;
                        }
                        global_2.member[_e136] = _e1957;
                        let _e1961 = local_11;
                        if _e153 {
                        } else {
                            break;
                        }
                        global_5.member[_e136] = _e1961.member_1;
                        if _e151 {
                        } else {
                            break;
                        }
                        let _e1966 = select(0u, 1u, (_e220 <= _e230));
                        if (_e1966 > 0u) {
                            let _e1968 = (1u < _e104);
                            if _e1968 {
                                if (0u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1972 = atomicAdd((&global_6.member[0u]), _e1966);
                                if ((_e1972 + _e1966) < _e1972) {
                                    if _e1968 {
                                    } else {
                                        break;
                                    }
                                    let _e1977 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1980 = select(0u, 1u, (_e1957.member_3 != 4294967295u));
                        if (_e1980 > 0u) {
                            let _e1982 = (3u < _e104);
                            if _e1982 {
                                if (2u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1986 = atomicAdd((&global_6.member[2u]), _e1980);
                                if ((_e1986 + _e1980) < _e1986) {
                                    if _e1982 {
                                    } else {
                                        break;
                                    }
                                    let _e1991 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1961.member_1 > 0u) {
                            let _e1993 = (5u < _e104);
                            if _e1993 {
                                if (4u < _e104) {
                                } else {
                                    break;
                                }
                                let _e1997 = atomicAdd((&global_6.member[4u]), _e1961.member_1);
                                if ((_e1997 + _e1961.member_1) < _e1997) {
                                    if _e1993 {
                                    } else {
                                        break;
                                    }
                                    let _e2002 = atomicAdd((&global_6.member[5u]), 1u);
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
