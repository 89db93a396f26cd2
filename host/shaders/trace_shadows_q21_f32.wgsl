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

struct type_35 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: f32,
    member_1: bool,
}

struct type_49 {
    member: array<vec4<u32>, 2>,
}

struct type_52 {
    member: array<i32>,
}

struct type_58 {
    member: array<array<u32, 7>>,
}

struct type_63 {
    member: type_35,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_63,
    member_2: type_63,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_30;
@group(0) @binding(1) 
var<uniform> global_3: type_49;
@group(0) @binding(2) 
var<uniform> global_4: type_49;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_52;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(3) 
var<storage> global_9: type_58;
@group(0) @binding(7) 
var<storage> global_10: type_38;

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
    var phi_327_: u32;
    var phi_371_: i32;
    var phi_395_: type_41;
    var phi_545_: i32;
    var phi_546_: i32;
    var phi_556_: bool;
    var phi_566_: u32;
    var phi_567_: u32;
    var phi_569_: bool;
    var phi_574_: u32;
    var phi_606_: i32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_641_: f32;
    var phi_647_: f32;
    var phi_670_: f32;
    var phi_681_: f32;
    var phi_690_: f32;
    var phi_696_: f32;
    var phi_707_: f32;
    var phi_713_: f32;
    var phi_736_: f32;
    var phi_747_: f32;
    var phi_756_: f32;
    var phi_762_: f32;
    var phi_773_: f32;
    var phi_779_: f32;
    var phi_802_: f32;
    var phi_813_: f32;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_3913_: bool;
    var phi_1003_: type_47;
    var phi_1006_: type_63;
    var phi_1008_: u32;
    var phi_1010_: bool;
    var phi_1012_: u32;
    var phi_1023_: bool;
    var phi_1109_: type_63;
    var phi_1110_: bool;
    var phi_1111_: u32;
    var phi_3166_: u32;
    var phi_3167_: u32;
    var phi_3177_: u32;
    var phi_3179_: u32;
    var phi_3180_: bool;
    var phi_3200_: u32;
    var phi_3201_: u32;
    var phi_3205_: type_64;
    var phi_3549_: type_63;
    var phi_3626_: type_63;
    var phi_3627_: type_63;
    var phi_3628_: u32;
    var phi_3630_: type_63;
    var phi_3631_: u32;
    var phi_3632_: bool;
    var phi_3641_: type_63;
    var phi_3646_: type_63;
    var phi_3647_: bool;
    var phi_1129_: type_47;
    var phi_1132_: type_8;
    var phi_1133_: type_8;
    var phi_1155_: type_8;
    var phi_1176_: u32;
    var phi_1265_: array<array<f32, 3>, 3>;
    var phi_1382_: bool;
    var phi_1411_: bool;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1816_: vec3<f32>;
    var phi_1817_: vec3<f32>;
    var phi_1818_: vec3<f32>;
    var phi_1819_: vec3<f32>;
    var phi_1850_: bool;
    var phi_1859_: vec3<f32>;
    var phi_2026_: bool;
    var phi_2050_: f32;
    var phi_2051_: f32;
    var phi_2074_: type_26;
    var phi_2076_: type_26;
    var phi_2077_: bool;
    var phi_2081_: type_26;
    var phi_2082_: type_26;
    var phi_2083_: type_26;
    var phi_2084_: bool;
    var phi_2088_: type_26;
    var phi_2089_: bool;
    var phi_2090_: type_26;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2093_: type_26;
    var phi_2094_: bool;
    var phi_2095_: bool;
    var phi_2103_: type_26;
    var phi_2104_: bool;
    var phi_2108_: type_26;
    var phi_2131_: u32;
    var phi_2145_: i32;
    var phi_2165_: vec3<f32>;
    var phi_2166_: vec3<f32>;
    var phi_2182_: vec3<f32>;
    var phi_2183_: vec3<f32>;
    var phi_2199_: vec3<f32>;
    var phi_2200_: vec3<f32>;
    var phi_2236_: vec3<f32>;
    var phi_2418_: f32;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2442_: type_47;
    var phi_2443_: type_47;
    var phi_1130_: type_47;
    var phi_3907_: bool;
    var local_10: type_47;
    var phi_4077_: bool;
    var phi_3649_: type_47;
    var phi_3650_: type_63;
    var phi_3651_: bool;
    var phi_3652_: u32;
    var phi_4076_: bool;
    var phi_3653_: type_47;
    var phi_3654_: type_63;
    var phi_3655_: u32;
    var phi_3656_: bool;
    var phi_3657_: u32;
    var phi_4075_: bool;
    var phi_3658_: type_47;
    var phi_3659_: type_63;
    var phi_3660_: u32;
    var phi_3661_: bool;
    var phi_3662_: u32;
    var phi_4074_: bool;
    var phi_1004_: type_47;
    var phi_1007_: type_63;
    var phi_1009_: u32;
    var phi_1011_: bool;
    var phi_1013_: u32;
    var phi_3663_: bool;
    var phi_4073_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_9.member));
            let _e97 = arrayLength((&global_5.member));
            let _e109 = arrayLength((&global_8.member));
            let _e113 = global_4.member[0u][0u];
            let _e117 = global_4.member[0u][1u];
            let _e121 = global_4.member[0u][2u];
            let _e125 = global_4.member[0u][3u];
            let _e129 = global_4.member[1u][0u];
            let _e133 = global_4.member[1u][1u];
            let _e137 = global_4.member[1u][2u];
            let _e141 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e156 = (_e141 < arrayLength((&global_10.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_10.member[_e141].member_2;
                phi_327_ = _e160;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e162 = phi_327_;
            let _e165 = global_1.member[0u];
            let _e169 = global_3.member[0u][0u];
            let _e173 = global_3.member[0u][1u];
            let _e177 = global_3.member[0u][2u];
            let _e181 = global_3.member[0u][3u];
            let _e185 = global_3.member[1u][0u];
            let _e189 = global_3.member[1u][1u];
            let _e193 = global_3.member[1u][2u];
            let _e197 = global_3.member[1u][3u];
            let _e198 = bitcast<f32>(_e169);
            let _e199 = bitcast<f32>(_e173);
            let _e200 = bitcast<f32>(_e177);
            let _e202 = bitcast<f32>(_e185);
            let _e203 = array<u32, 3>(_e189, _e193, _e197);
            let _e205 = bitcast<i32>(_e165);
            if (_e205 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_371_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_395_ = type_41(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_395_ = type_41(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_395_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_2.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e240 = global_10.member[_e141].member.member_1;
                    let _e245 = global_10.member[_e141].member.member_3;
                    if (_e240 <= _e245) {
                        let _e247 = (1u < _e109);
                        if _e247 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e251 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e251 + 1u) < _e251) {
                                if _e247 {
                                } else {
                                    break;
                                }
                                let _e256 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e156 {
                        } else {
                            break;
                        }
                        let _e266 = global_10.member[_e141].member.member_2[0u];
                        let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                        let _e274 = global_10.member[_e141].member.member_2[1u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_10.member[_e141].member.member_2[2u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_10.member[_e141].member.member[0u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e298 = global_10.member[_e141].member.member[1u];
                        let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                        let _e306 = global_10.member[_e141].member.member[2u];
                        let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                        let _e310 = select(_e276, _e268, (_e276 < _e268));
                        let _e312 = select(_e284, _e310, (_e284 < _e310));
                        let _e314 = select(_e292, _e312, (_e292 < _e312));
                        let _e316 = select(_e300, _e314, (_e300 < _e314));
                        let _e318 = select(_e308, _e316, (_e308 < _e316));
                        let _e320 = (bitcast<u32>(_e240) & 2147483647u);
                        let _e329 = (((select(_e320, _e318, (_e320 < _e318)) < 2139095040u) && ((bitcast<u32>(_e245) & 2147483647u) <= 2139095040u)) && (_e312 > 0u));
                        if _e329 {
                            let _e332 = (bitcast<u32>(bitcast<f32>(_e312)) & 2147483647u);
                            if (_e332 >= 8388608u) {
                                phi_545_ = (bitcast<i32>((_e332 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_545_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e332)), 32u, (_e332 == 0u))));
                            }
                            let _e346 = phi_545_;
                            phi_546_ = _e346;
                        } else {
                            phi_546_ = 0i;
                        }
                        let _e348 = phi_546_;
                        let _e349 = (_e268 == _e312);
                        if _e349 {
                            phi_556_ = true;
                        } else {
                            phi_556_ = (_e276 == _e312);
                        }
                        let _e352 = phi_556_;
                        let _e353 = select(1u, 0u, _e349);
                        if _e352 {
                            let _e354 = (_e353 + 1u);
                            phi_566_ = _e354;
                            phi_567_ = _e354;
                            phi_569_ = select(true, false, (_e354 == 2u));
                        } else {
                            phi_566_ = u32();
                            phi_567_ = 0u;
                            phi_569_ = true;
                        }
                        let _e358 = phi_566_;
                        let _e360 = phi_567_;
                        let _e362 = phi_569_;
                        if _e362 {
                            phi_574_ = (_e360 + 1u);
                        } else {
                            phi_574_ = 0u;
                        }
                        let _e366 = phi_574_;
                        let _e367 = select(_e358, _e360, _e362);
                        let _e368 = select(_e353, select(2u, _e353, _e352), _e362);
                        let _e369 = -(_e348);
                        if (_e369 < -126i) {
                            phi_606_ = -126i;
                        } else {
                            phi_606_ = select(_e369, 127i, (_e369 > 127i));
                        }
                        let _e374 = phi_606_;
                        let _e379 = bitcast<f32>((bitcast<u32>((_e374 + 127i)) << bitcast<u32>(23i)));
                        let _e385 = bitcast<f32>((bitcast<u32>(((_e369 - _e374) + 127i)) << bitcast<u32>(23i)));
                        let _e390 = global_10.member[_e141].member.member;
                        let _e391 = (_e367 == 0u);
                        if _e391 {
                            phi_624_ = _e390[0];
                        } else {
                            phi_624_ = _e390[1];
                        }
                        let _e395 = phi_624_;
                        let _e396 = (_e367 == 2u);
                        if _e396 {
                            phi_630_ = _e390[2];
                        } else {
                            phi_630_ = _e395;
                        }
                        let _e399 = phi_630_;
                        let _e400 = global_10.member[_e141].member.member_2;
                        if _e391 {
                            phi_641_ = _e400[0];
                        } else {
                            phi_641_ = _e400[1];
                        }
                        let _e404 = phi_641_;
                        if _e396 {
                            phi_647_ = _e400[2];
                        } else {
                            phi_647_ = _e404;
                        }
                        let _e407 = phi_647_;
                        let _e409 = ((_e407 * _e379) * _e385);
                        let _e413 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e413 {
                            let _e417 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) * 0.00000011920929f);
                            phi_670_ = select(0.00000000000011368684f, _e417, (_e417 > 0.00000000000011368684f));
                        } else {
                            phi_670_ = 0f;
                        }
                        let _e421 = phi_670_;
                        let _e422 = (_e399 + _e421);
                        let _e423 = (_e399 - _e421);
                        let _e424 = select(_e409, 0f, _e413);
                        if _e413 {
                            phi_681_ = 38685626000000000000000000f;
                        } else {
                            phi_681_ = (1f / _e409);
                        }
                        let _e427 = phi_681_;
                        let _e428 = (_e366 == 0u);
                        if _e428 {
                            phi_690_ = _e390[0];
                        } else {
                            phi_690_ = _e390[1];
                        }
                        let _e432 = phi_690_;
                        let _e433 = (_e366 == 2u);
                        if _e433 {
                            phi_696_ = _e390[2];
                        } else {
                            phi_696_ = _e432;
                        }
                        let _e436 = phi_696_;
                        if _e428 {
                            phi_707_ = _e400[0];
                        } else {
                            phi_707_ = _e400[1];
                        }
                        let _e440 = phi_707_;
                        if _e433 {
                            phi_713_ = _e400[2];
                        } else {
                            phi_713_ = _e440;
                        }
                        let _e443 = phi_713_;
                        let _e445 = ((_e443 * _e379) * _e385);
                        let _e449 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e449 {
                            let _e453 = (bitcast<f32>((bitcast<u32>(_e436) & 2147483647u)) * 0.00000011920929f);
                            phi_736_ = select(0.00000000000011368684f, _e453, (_e453 > 0.00000000000011368684f));
                        } else {
                            phi_736_ = 0f;
                        }
                        let _e457 = phi_736_;
                        let _e458 = (_e436 + _e457);
                        let _e459 = (_e436 - _e457);
                        let _e460 = select(_e445, 0f, _e449);
                        if _e449 {
                            phi_747_ = 38685626000000000000000000f;
                        } else {
                            phi_747_ = (1f / _e445);
                        }
                        let _e463 = phi_747_;
                        let _e464 = (_e368 == 0u);
                        if _e464 {
                            phi_756_ = _e390[0];
                        } else {
                            phi_756_ = _e390[1];
                        }
                        let _e468 = phi_756_;
                        let _e469 = (_e368 == 2u);
                        if _e469 {
                            phi_762_ = _e390[2];
                        } else {
                            phi_762_ = _e468;
                        }
                        let _e472 = phi_762_;
                        if _e464 {
                            phi_773_ = _e400[0];
                        } else {
                            phi_773_ = _e400[1];
                        }
                        let _e476 = phi_773_;
                        if _e469 {
                            phi_779_ = _e400[2];
                        } else {
                            phi_779_ = _e476;
                        }
                        let _e479 = phi_779_;
                        let _e481 = ((_e479 * _e379) * _e385);
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e485 {
                            let _e489 = (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) * 0.00000011920929f);
                            phi_802_ = select(0.00000000000011368684f, _e489, (_e489 > 0.00000000000011368684f));
                        } else {
                            phi_802_ = 0f;
                        }
                        let _e493 = phi_802_;
                        let _e494 = (_e472 + _e493);
                        let _e495 = (_e472 - _e493);
                        let _e496 = select(_e481, 0f, _e485);
                        if _e485 {
                            phi_813_ = 38685626000000000000000000f;
                        } else {
                            phi_813_ = (1f / _e481);
                        }
                        let _e499 = phi_813_;
                        let _e502 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                        let _e505 = bitcast<f32>((bitcast<u32>(_e436) & 2147483647u));
                        let _e507 = select(_e505, _e502, (_e502 > _e505));
                        let _e510 = bitcast<f32>((bitcast<u32>(_e472) & 2147483647u));
                        if (_e329 && (select(_e510, _e507, (_e507 > _e510)) <= 1099511600000f)) {
                            let _e515 = (_e348 / 3i);
                            let _e522 = bitcast<f32>((bitcast<u32>((_e515 + 127i)) << bitcast<u32>(23i)));
                            let _e529 = bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e515)) + 127i)) << bitcast<u32>(23i)));
                            let _e530 = (((_e240 * _e522) * _e522) * _e529);
                            let _e532 = select(340282350000000000000000000000000000000f, _e530, (_e530 < 340282350000000000000000000000000000000f));
                            let _e537 = (((_e245 * _e522) * _e522) * _e529);
                            let _e539 = select(340282350000000000000000000000000000000f, _e537, (_e537 < 340282350000000000000000000000000000000f));
                            phi_913_ = select(-340282350000000000000000000000000000000f, _e539, (_e539 > -340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e532, (_e532 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_913_ = 0f;
                            phi_914_ = 1f;
                        }
                        let _e543 = phi_913_;
                        let _e545 = phi_914_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e549 = (_e367 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_1[_e549];
                        let _e555 = (_e366 % 3u);
                        let _e556 = (_e555 < 3u);
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e558 = local_1[_e555];
                        let _e561 = (_e368 % 3u);
                        let _e562 = (_e561 < 3u);
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e564 = local_1[_e561];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e569 = local[_e549];
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e555];
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e577 = local[_e561];
                        phi_3913_ = false;
                        phi_1003_ = type_47(_e543, false);
                        phi_1006_ = type_63(type_35(vec4<f32>((f32(_e552) * _e153), (f32(_e558) * _e153), (f32(_e564) * _e153), 0f), vec4<f32>((f32(_e569) * _e153), (f32(_e573) * _e153), (f32(_e577) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                        phi_1008_ = ((3u * _e95) + 1u);
                        phi_1010_ = (_e545 <= _e543);
                        phi_1012_ = 0u;
                        loop {
                            let _e587 = phi_3913_;
                            let _e589 = phi_1003_;
                            let _e591 = phi_1006_;
                            let _e593 = phi_1008_;
                            let _e595 = phi_1010_;
                            let _e597 = phi_1012_;
                            local_11 = _e589;
                            if _e595 {
                                phi_1023_ = true;
                            } else {
                                phi_1023_ = (_e597 > 0u);
                            }
                            let _e600 = phi_1023_;
                            if _e600 {
                                let _e601 = (_e593 > 0u);
                                if _e601 {
                                    if _e595 {
                                        phi_1109_ = _e591;
                                        phi_1110_ = _e595;
                                        phi_1111_ = _e597;
                                    } else {
                                        let _e602 = (_e597 - 1u);
                                        let _e603 = (_e602 % 128u);
                                        let _e604 = (_e603 < 128u);
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e606 = local_7[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e608 = local_6[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e610 = local_5[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e612 = local_4[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e614 = local_3[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e616 = local_2[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e621 = local_8[_e603];
                                        if _e604 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e624 = local_9[_e603];
                                        phi_1109_ = type_63(type_35(vec4<f32>(_e606, _e608, _e610, 0f), vec4<f32>(_e612, _e614, _e616, 0f)), _e621);
                                        phi_1110_ = (_e624 <= _e589.member);
                                        phi_1111_ = _e602;
                                    }
                                    let _e628 = phi_1109_;
                                    let _e630 = phi_1110_;
                                    let _e632 = phi_1111_;
                                    if _e630 {
                                        if ((_e628.member_1 & 2147483648u) != 0u) {
                                            phi_1129_ = _e589;
                                            phi_1132_ = type_8(0u, ((_e628.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1094 = phi_1129_;
                                                let _e1096 = phi_1132_;
                                                local_10 = _e1094;
                                                local_12 = _e1094;
                                                if (_e1096.member < _e1096.member_1) {
                                                    phi_1133_ = type_8((_e1096.member + 1u), _e1096.member_1);
                                                    phi_1155_ = type_8(1u, _e1096.member);
                                                } else {
                                                    phi_1133_ = _e1096;
                                                    phi_1155_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1109 = phi_1133_;
                                                let _e1111 = phi_1155_;
                                                let _e1115 = (bitcast<i32>(_e1111.member) != 0i);
                                                if _e1115 {
                                                    let _e1116 = ((_e628.member_1 & 268435455u) + _e1111.member_1);
                                                    let _e1117 = (_e1116 < _e97);
                                                    if _e1117 {
                                                        if _e1117 {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1121 = global_5.member[_e1116].member_1;
                                                        phi_1176_ = _e1121;
                                                    } else {
                                                        phi_1176_ = 4294967295u;
                                                    }
                                                    let _e1123 = phi_1176_;
                                                    if (_e1116 >= _e97) {
                                                        phi_1265_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1117 {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        if (_e549 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1130 = global_5.member[_e1116].member[_e549];
                                                        if (_e555 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1136 = global_5.member[_e1116].member[_e555];
                                                        if (_e561 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1142 = global_5.member[_e1116].member[_e561];
                                                        let _e1144 = (3u + _e549);
                                                        if (_e1144 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1150 = global_5.member[_e1116].member[_e1144];
                                                        let _e1151 = (3u + _e555);
                                                        if (_e1151 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1157 = global_5.member[_e1116].member[_e1151];
                                                        let _e1158 = (3u + _e561);
                                                        if (_e1158 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1164 = global_5.member[_e1116].member[_e1158];
                                                        let _e1166 = (6u + _e549);
                                                        if (_e1166 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1172 = global_5.member[_e1116].member[_e1166];
                                                        let _e1173 = (6u + _e555);
                                                        if (_e1173 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1179 = global_5.member[_e1116].member[_e1173];
                                                        let _e1180 = (6u + _e561);
                                                        if (_e1180 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1186 = global_5.member[_e1116].member[_e1180];
                                                        phi_1265_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1130, _e1136, _e1142), array<f32, 3>(_e1150, _e1157, _e1164), array<f32, 3>(_e1172, _e1179, _e1186));
                                                    }
                                                    let _e1190 = phi_1265_;
                                                    let _e1198 = (_e1190[0][2] - _e472);
                                                    let _e1201 = (((_e1190[0][0] - _e399) * _e496) - (_e1198 * _e424));
                                                    let _e1204 = (((_e1190[0][1] - _e436) * _e496) - (_e1198 * _e460));
                                                    let _e1211 = (_e1190[1][2] - _e472);
                                                    let _e1214 = (((_e1190[1][0] - _e399) * _e496) - (_e1211 * _e424));
                                                    let _e1217 = (((_e1190[1][1] - _e436) * _e496) - (_e1211 * _e460));
                                                    let _e1224 = (_e1190[2][2] - _e472);
                                                    let _e1227 = (((_e1190[2][0] - _e399) * _e496) - (_e1224 * _e424));
                                                    let _e1230 = (((_e1190[2][1] - _e436) * _e496) - (_e1224 * _e460));
                                                    let _e1231 = (_e1227 * _e1217);
                                                    let _e1232 = (_e1230 * _e1214);
                                                    let _e1233 = (_e1201 * _e1230);
                                                    let _e1234 = (_e1204 * _e1227);
                                                    let _e1235 = (_e1214 * _e1204);
                                                    let _e1236 = (_e1217 * _e1201);
                                                    let _e1241 = (((_e1231 >= _e1232) && (_e1233 >= _e1234)) && (_e1235 >= _e1236));
                                                    if (_e1241 || (((_e1231 <= _e1232) && (_e1233 <= _e1234)) && (_e1235 <= _e1236))) {
                                                        let _e1248 = select(-1f, 1f, _e1241);
                                                        let _e1250 = ((_e1231 - _e1232) * _e1248);
                                                        let _e1252 = select(0f, _e1250, (_e1250 > 0f));
                                                        let _e1254 = ((_e1233 - _e1234) * _e1248);
                                                        let _e1256 = select(0f, _e1254, (_e1254 > 0f));
                                                        let _e1258 = ((_e1235 - _e1236) * _e1248);
                                                        let _e1260 = select(0f, _e1258, (_e1258 > 0f));
                                                        let _e1262 = ((_e1252 + _e1256) + _e1260);
                                                        if (_e1262 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2093_ = type_26();
                                                            phi_2094_ = true;
                                                            phi_2095_ = false;
                                                        } else {
                                                            let _e1265 = select(_e1214, _e1201, (_e1201 < _e1214));
                                                            if (select(_e1227, _e1265, (_e1265 < _e1227)) > 0f) {
                                                                phi_1382_ = true;
                                                            } else {
                                                                let _e1270 = select(_e1214, _e1201, (_e1201 > _e1214));
                                                                phi_1382_ = (select(_e1227, _e1270, (_e1270 > _e1227)) < 0f);
                                                            }
                                                            let _e1275 = phi_1382_;
                                                            if _e1275 {
                                                                phi_2090_ = type_26();
                                                                phi_2091_ = true;
                                                                phi_2092_ = false;
                                                            } else {
                                                                let _e1277 = select(_e1217, _e1204, (_e1204 < _e1217));
                                                                if (select(_e1230, _e1277, (_e1277 < _e1230)) > 0f) {
                                                                    phi_1411_ = true;
                                                                } else {
                                                                    let _e1282 = select(_e1217, _e1204, (_e1204 > _e1217));
                                                                    phi_1411_ = (select(_e1230, _e1282, (_e1282 > _e1230)) < 0f);
                                                                }
                                                                let _e1287 = phi_1411_;
                                                                if _e1287 {
                                                                    phi_2088_ = type_26();
                                                                    phi_2089_ = false;
                                                                } else {
                                                                    let _e1289 = select(_e1190[1][0], _e1190[0][0], (_e1190[0][0] < _e1190[1][0]));
                                                                    let _e1293 = select(_e1190[1][0], _e1190[0][0], (_e1190[0][0] > _e1190[1][0]));
                                                                    let _e1297 = select(_e1190[1][1], _e1190[0][1], (_e1190[0][1] < _e1190[1][1]));
                                                                    let _e1301 = select(_e1190[1][1], _e1190[0][1], (_e1190[0][1] > _e1190[1][1]));
                                                                    let _e1305 = select(_e1190[1][2], _e1190[0][2], (_e1190[0][2] < _e1190[1][2]));
                                                                    let _e1309 = select(_e1190[1][2], _e1190[0][2], (_e1190[0][2] > _e1190[1][2]));
                                                                    let _e1314 = ((select(_e1190[2][0], _e1289, (_e1289 < _e1190[2][0])) - _e422) * _e427);
                                                                    let _e1315 = ((select(_e1190[2][0], _e1293, (_e1293 > _e1190[2][0])) - _e423) * _e427);
                                                                    let _e1318 = ((select(_e1190[2][1], _e1297, (_e1297 < _e1190[2][1])) - _e458) * _e463);
                                                                    let _e1319 = ((select(_e1190[2][1], _e1301, (_e1301 > _e1190[2][1])) - _e459) * _e463);
                                                                    let _e1322 = ((select(_e1190[2][2], _e1305, (_e1305 < _e1190[2][2])) - _e494) * _e499);
                                                                    let _e1323 = ((select(_e1190[2][2], _e1309, (_e1309 > _e1190[2][2])) - _e495) * _e499);
                                                                    let _e1325 = select(_e1323, _e1322, (_e1322 < _e1323));
                                                                    let _e1327 = select(_e1323, _e1322, (_e1322 > _e1323));
                                                                    let _e1329 = select(_e1315, _e1314, (_e1314 < _e1315));
                                                                    let _e1331 = select(_e1319, _e1318, (_e1318 < _e1319));
                                                                    let _e1333 = select(_e1331, _e1329, (_e1329 > _e1331));
                                                                    let _e1335 = select(_e1325, _e1333, (_e1333 > _e1325));
                                                                    let _e1337 = select(_e1315, _e1314, (_e1314 > _e1315));
                                                                    let _e1339 = select(_e1319, _e1318, (_e1318 > _e1319));
                                                                    let _e1341 = select(_e1339, _e1337, (_e1337 < _e1339));
                                                                    let _e1343 = select(_e1327, _e1341, (_e1341 < _e1327));
                                                                    let _e1344 = -(_e1325);
                                                                    let _e1350 = select(_e545, _e1335, (_e1335 > _e545));
                                                                    if (_e1350 > (_e1343 + (select(_e1344, _e1327, (_e1327 > _e1344)) * 0.0000019073523f))) {
                                                                        phi_2083_ = type_26();
                                                                        phi_2084_ = true;
                                                                    } else {
                                                                        let _e1352 = (_e1350 > _e1094.member);
                                                                        if _e1352 {
                                                                            phi_2082_ = type_26();
                                                                        } else {
                                                                            let _e1353 = vec3<f32>(_e1190[0][0], _e1190[0][1], _e1190[0][2]);
                                                                            let _e1354 = vec3<f32>(_e1190[1][0], _e1190[1][1], _e1190[1][2]);
                                                                            let _e1355 = vec3<f32>(_e1190[2][0], _e1190[2][1], _e1190[2][2]);
                                                                            let _e1356 = (_e1190[1][0] - _e1190[0][0]);
                                                                            let _e1357 = (_e1190[1][1] - _e1190[0][1]);
                                                                            let _e1358 = (_e1190[1][2] - _e1190[0][2]);
                                                                            let _e1359 = vec3<f32>(_e1356, _e1357, _e1358);
                                                                            let _e1360 = (_e1190[2][0] - _e1190[1][0]);
                                                                            let _e1361 = (_e1190[2][1] - _e1190[1][1]);
                                                                            let _e1362 = (_e1190[2][2] - _e1190[1][2]);
                                                                            let _e1363 = vec3<f32>(_e1360, _e1361, _e1362);
                                                                            let _e1364 = (_e1190[0][0] - _e1190[2][0]);
                                                                            let _e1365 = (_e1190[0][1] - _e1190[2][1]);
                                                                            let _e1366 = (_e1190[0][2] - _e1190[2][2]);
                                                                            let _e1367 = vec3<f32>(_e1364, _e1365, _e1366);
                                                                            let _e1370 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                            let _e1373 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                            let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                            let _e1378 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                            let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                            let _e1383 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                            let _e1386 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                            let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                                            let _e1391 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                            let _e1393 = select(_e1391, _e1388, (_e1388 > _e1391));
                                                                            let _e1396 = bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u));
                                                                            let _e1399 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                            let _e1401 = select(_e1399, _e1396, (_e1396 > _e1399));
                                                                            let _e1404 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                            let _e1406 = select(_e1404, _e1401, (_e1401 > _e1404));
                                                                            let _e1408 = select(_e1393, _e1380, (_e1380 > _e1393));
                                                                            let _e1410 = select(_e1406, _e1408, (_e1408 > _e1406));
                                                                            if (_e1380 == _e1410) {
                                                                                phi_1812_ = _e1217;
                                                                                phi_1813_ = _e1214;
                                                                                phi_1814_ = _e1204;
                                                                                phi_1815_ = _e1201;
                                                                                phi_1816_ = _e1353;
                                                                                phi_1817_ = _e1367;
                                                                                phi_1818_ = _e1363;
                                                                                phi_1819_ = _e1359;
                                                                            } else {
                                                                                let _e1412 = (_e1393 == _e1410);
                                                                                let _e1417 = vec3(_e1412);
                                                                                phi_1812_ = select(_e1204, _e1230, _e1412);
                                                                                phi_1813_ = select(_e1201, _e1227, _e1412);
                                                                                phi_1814_ = select(_e1230, _e1217, _e1412);
                                                                                phi_1815_ = select(_e1227, _e1214, _e1412);
                                                                                phi_1816_ = select(_e1355, _e1354, _e1417);
                                                                                phi_1817_ = select(_e1363, _e1359, _e1417);
                                                                                phi_1818_ = select(_e1359, _e1367, _e1417);
                                                                                phi_1819_ = select(_e1367, _e1363, _e1417);
                                                                            }
                                                                            let _e1423 = phi_1812_;
                                                                            let _e1425 = phi_1813_;
                                                                            let _e1427 = phi_1814_;
                                                                            let _e1429 = phi_1815_;
                                                                            let _e1431 = phi_1816_;
                                                                            let _e1433 = phi_1817_;
                                                                            let _e1435 = phi_1818_;
                                                                            let _e1437 = phi_1819_;
                                                                            let _e1444 = ((_e1435.y * _e1433.z) - (_e1433.y * _e1435.z));
                                                                            let _e1449 = ((_e1435.z * _e1433.x) - (_e1433.z * _e1435.x));
                                                                            let _e1452 = ((_e1435.x * _e1433.y) - (_e1433.x * _e1435.y));
                                                                            if (_e1252 >= _e1256) {
                                                                                phi_1850_ = select(true, false, (_e1252 >= _e1260));
                                                                            } else {
                                                                                phi_1850_ = true;
                                                                            }
                                                                            let _e1457 = phi_1850_;
                                                                            if _e1457 {
                                                                                phi_1859_ = select(_e1355, _e1354, vec3((_e1256 >= _e1260)));
                                                                            } else {
                                                                                phi_1859_ = _e1353;
                                                                            }
                                                                            let _e1462 = phi_1859_;
                                                                            let _e1467 = (((_e1444 * _e424) + (_e1449 * _e460)) + (_e1452 * _e496));
                                                                            let _e1478 = (((_e1444 * (_e1462.x - _e399)) + (_e1449 * (_e1462.y - _e436))) + (_e1452 * (_e1462.z - _e472)));
                                                                            let _e1480 = (_e1425 - _e1429);
                                                                            let _e1481 = (_e1423 - _e1427);
                                                                            let _e1489 = (-(((_e1429 * _e1480) + (_e1427 * _e1481))) / ((_e1480 * _e1480) + (_e1481 * _e1481)));
                                                                            let _e1491 = select(1f, _e1489, (_e1489 < 1f));
                                                                            let _e1493 = select(0f, _e1491, (_e1491 > 0f));
                                                                            let _e1506 = ((_e1431.x + (_e1437.x * _e1493)) - _e399);
                                                                            let _e1507 = ((_e1431.y + (_e1437.y * _e1493)) - _e436);
                                                                            let _e1508 = ((_e1431.z + (_e1437.z * _e1493)) - _e472);
                                                                            let _e1509 = (_e1508 / _e496);
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                            let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                                            let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                            let _e1540 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                            let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                                                            let _e1545 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1444 * _e1506) + (_e1449 * _e1507)) + (_e1452 * _e1508)) - _e1478)) & 2147483647u)) <= ((0.0000009536743f * select(_e1410, _e1531, (_e1531 > _e1410))) * select(_e1545, _e1542, (_e1542 > _e1545)))) {
                                                                                let _e1555 = bitcast<f32>((bitcast<u32>(_e1435.x) & 2147483647u));
                                                                                let _e1558 = bitcast<f32>((bitcast<u32>(_e1435.y) & 2147483647u));
                                                                                let _e1560 = select(_e1558, _e1555, (_e1555 > _e1558));
                                                                                let _e1563 = bitcast<f32>((bitcast<u32>(_e1435.z) & 2147483647u));
                                                                                let _e1569 = bitcast<f32>((bitcast<u32>(_e1433.x) & 2147483647u));
                                                                                let _e1572 = bitcast<f32>((bitcast<u32>(_e1433.y) & 2147483647u));
                                                                                let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                                                                let _e1577 = bitcast<f32>((bitcast<u32>(_e1433.z) & 2147483647u));
                                                                                phi_2026_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u)) > ((0.0000038146973f * select(_e1563, _e1560, (_e1560 > _e1563))) * select(_e1577, _e1574, (_e1574 > _e1577)))));
                                                                            } else {
                                                                                phi_2026_ = true;
                                                                            }
                                                                            let _e1584 = phi_2026_;
                                                                            if _e1584 {
                                                                                let _e1595 = ((((_e1444 * (_e1506 - (_e424 * _e1509))) + (_e1449 * (_e1507 - (_e460 * _e1509)))) + (_e1452 * (_e1508 - _e1508))) / _e1467);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u)) <= _e1410) {
                                                                                    phi_2050_ = (_e1509 + _e1595);
                                                                                } else {
                                                                                    phi_2050_ = _e1509;
                                                                                }
                                                                                let _e1602 = phi_2050_;
                                                                                phi_2051_ = _e1602;
                                                                            } else {
                                                                                phi_2051_ = (_e1478 / _e1467);
                                                                            }
                                                                            let _e1604 = phi_2051_;
                                                                            let _e1606 = select(_e1343, _e1604, (_e1604 < _e1343));
                                                                            let _e1608 = select(_e1335, _e1606, (_e1606 > _e1335));
                                                                            if (_e1608 >= _e545) {
                                                                                let _e1610 = (_e1608 <= _e1094.member);
                                                                                if _e1610 {
                                                                                    let _e1611 = (1f / _e1262);
                                                                                    phi_2074_ = type_26(_e1608, (_e1256 * _e1611), (_e1260 * _e1611), _e1123);
                                                                                } else {
                                                                                    phi_2074_ = type_26();
                                                                                }
                                                                                let _e1616 = phi_2074_;
                                                                                phi_2076_ = _e1616;
                                                                                phi_2077_ = select(true, false, _e1610);
                                                                            } else {
                                                                                phi_2076_ = type_26();
                                                                                phi_2077_ = true;
                                                                            }
                                                                            let _e1619 = phi_2076_;
                                                                            let _e1621 = phi_2077_;
                                                                            if _e1621 {
                                                                                phi_2081_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2081_ = _e1619;
                                                                            }
                                                                            let _e1623 = phi_2081_;
                                                                            phi_2082_ = _e1623;
                                                                        }
                                                                        let _e1625 = phi_2082_;
                                                                        phi_2083_ = _e1625;
                                                                        phi_2084_ = _e1352;
                                                                    }
                                                                    let _e1627 = phi_2083_;
                                                                    let _e1629 = phi_2084_;
                                                                    phi_2088_ = _e1627;
                                                                    phi_2089_ = _e1629;
                                                                }
                                                                let _e1631 = phi_2088_;
                                                                let _e1633 = phi_2089_;
                                                                phi_2090_ = _e1631;
                                                                phi_2091_ = _e1287;
                                                                phi_2092_ = _e1633;
                                                            }
                                                            let _e1635 = phi_2090_;
                                                            let _e1637 = phi_2091_;
                                                            let _e1639 = phi_2092_;
                                                            phi_2093_ = _e1635;
                                                            phi_2094_ = _e1637;
                                                            phi_2095_ = _e1639;
                                                        }
                                                        let _e1641 = phi_2093_;
                                                        let _e1643 = phi_2094_;
                                                        let _e1645 = phi_2095_;
                                                        phi_2103_ = _e1641;
                                                        phi_2104_ = select(_e1645, true, _e1643);
                                                    } else {
                                                        phi_2103_ = type_26();
                                                        phi_2104_ = true;
                                                    }
                                                    let _e1648 = phi_2103_;
                                                    let _e1650 = phi_2104_;
                                                    if _e1650 {
                                                        phi_2108_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2108_ = _e1648;
                                                    }
                                                    let _e1652 = phi_2108_;
                                                    if (_e1652.member_3 != 4294967295u) {
                                                        if (_e1123 == _e162) {
                                                            phi_2437_ = false;
                                                        } else {
                                                            let _e1656 = (_e1123 < arrayLength((&global_6.member)));
                                                            if _e1656 {
                                                                if _e1656 {
                                                                } else {
                                                                    phi_3907_ = true;
                                                                    break;
                                                                }
                                                                let _e1658 = global_6.member[_e1123];
                                                                phi_2131_ = _e1658;
                                                            } else {
                                                                phi_2131_ = 4294967295u;
                                                            }
                                                            let _e1660 = phi_2131_;
                                                            let _e1661 = (_e1660 < arrayLength((&global_7.member)));
                                                            if _e1661 {
                                                                if _e1661 {
                                                                } else {
                                                                    phi_3907_ = true;
                                                                    break;
                                                                }
                                                                let _e1663 = global_7.member[_e1660];
                                                                phi_2145_ = _e1663;
                                                            } else {
                                                                phi_2145_ = 0i;
                                                            }
                                                            let _e1665 = phi_2145_;
                                                            let _e1666 = (_e1665 == 0i);
                                                            if _e1666 {
                                                                phi_2436_ = true;
                                                            } else {
                                                                if _e391 {
                                                                    phi_2166_ = vec3<f32>(_e1190[0][0], _e1190[0][1], _e1190[0][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_2165_ = vec3<f32>(_e1190[0][2], _e1190[0][0], _e1190[0][1]);
                                                                    } else {
                                                                        phi_2165_ = vec3<f32>(_e1190[0][1], _e1190[0][2], _e1190[0][0]);
                                                                    }
                                                                    let _e1671 = phi_2165_;
                                                                    phi_2166_ = _e1671;
                                                                }
                                                                let _e1674 = phi_2166_;
                                                                if _e391 {
                                                                    phi_2183_ = vec3<f32>(_e1190[1][0], _e1190[1][1], _e1190[1][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_2182_ = vec3<f32>(_e1190[1][2], _e1190[1][0], _e1190[1][1]);
                                                                    } else {
                                                                        phi_2182_ = vec3<f32>(_e1190[1][1], _e1190[1][2], _e1190[1][0]);
                                                                    }
                                                                    let _e1679 = phi_2182_;
                                                                    phi_2183_ = _e1679;
                                                                }
                                                                let _e1682 = phi_2183_;
                                                                if _e391 {
                                                                    phi_2200_ = vec3<f32>(_e1190[2][0], _e1190[2][1], _e1190[2][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_2199_ = vec3<f32>(_e1190[2][2], _e1190[2][0], _e1190[2][1]);
                                                                    } else {
                                                                        phi_2199_ = vec3<f32>(_e1190[2][1], _e1190[2][2], _e1190[2][0]);
                                                                    }
                                                                    let _e1687 = phi_2199_;
                                                                    phi_2200_ = _e1687;
                                                                }
                                                                let _e1690 = phi_2200_;
                                                                let _e1693 = (_e1682.x - _e1674.x);
                                                                let _e1696 = (_e1682.y - _e1674.y);
                                                                let _e1699 = (_e1682.z - _e1674.z);
                                                                let _e1701 = (_e1690.x - _e1674.x);
                                                                let _e1703 = (_e1690.y - _e1674.y);
                                                                let _e1705 = (_e1690.z - _e1674.z);
                                                                if (_e234.member_1 == 1u) {
                                                                    phi_2236_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1674);
                                                                } else {
                                                                    phi_2236_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                                }
                                                                let _e1720 = phi_2236_;
                                                                let _e1726 = bitcast<f32>((bitcast<u32>((_e1693 * _e1703)) ^ _e234.member_3[0]));
                                                                let _e1730 = bitcast<f32>((bitcast<u32>((_e1696 * _e1701)) ^ _e234.member_3[0]));
                                                                let _e1734 = bitcast<f32>((bitcast<u32>((_e1696 * _e1705)) ^ _e234.member_3[0]));
                                                                let _e1738 = bitcast<f32>((bitcast<u32>((_e1699 * _e1703)) ^ _e234.member_3[0]));
                                                                let _e1742 = bitcast<f32>((bitcast<u32>((_e1699 * _e1701)) ^ _e234.member_3[0]));
                                                                let _e1746 = bitcast<f32>((bitcast<u32>((_e1693 * _e1705)) ^ _e234.member_3[0]));
                                                                let _e1747 = (_e1734 - _e1738);
                                                                let _e1748 = (_e1742 - _e1746);
                                                                let _e1749 = (_e1726 - _e1730);
                                                                let _e1773 = (bitcast<f32>((bitcast<u32>(_e1734) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u)));
                                                                let _e1780 = (bitcast<f32>((bitcast<u32>(_e1742) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1746) & 2147483647u)));
                                                                let _e1787 = (bitcast<f32>((bitcast<u32>(_e1726) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u)));
                                                                if (_e234.member_2 == 0f) {
                                                                    phi_2418_ = 0f;
                                                                } else {
                                                                    let _e1817 = bitcast<f32>((bitcast<u32>(_e1747) & 2147483647u));
                                                                    let _e1820 = bitcast<f32>((bitcast<u32>(_e1748) & 2147483647u));
                                                                    let _e1823 = bitcast<f32>((bitcast<u32>(_e1749) & 2147483647u));
                                                                    let _e1825 = select(_e1823, _e1820, (_e1820 > _e1823));
                                                                    let _e1829 = select(_e1823, _e1820, (_e1820 < _e1823));
                                                                    let _e1833 = select(_e1820, _e1817, (_e1817 < _e1820));
                                                                    let _e1835 = select(_e1820, _e1817, (_e1817 > _e1820));
                                                                    let _e1837 = select(_e1823, _e1835, (_e1835 < _e1823));
                                                                    phi_2418_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1825, _e1817, (_e1817 > _e1825)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1837, _e1833, (_e1833 > _e1837)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1829, _e1817, (_e1817 < _e1829)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1773 + _e1780) + _e1787))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                                }
                                                                let _e1864 = phi_2418_;
                                                                phi_2436_ = (_e1666 || !(((((bitcast<f32>((bitcast<u32>((_e1720.x * _e1747)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1720.y * _e1748)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1720.z * _e1749)) ^ _e234.member_3[0]))) * f32(-(_e1665))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1720.x) & 2147483647u)) * _e1773)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1720.y) & 2147483647u)) * _e1780)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1720.z) & 2147483647u)) * _e1787)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1864) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1878 = phi_2436_;
                                                            phi_2437_ = _e1878;
                                                        }
                                                        let _e1880 = phi_2437_;
                                                        if _e1880 {
                                                            phi_2442_ = type_47(_e1094.member, true);
                                                        } else {
                                                            phi_2442_ = _e1094;
                                                        }
                                                        let _e1885 = phi_2442_;
                                                        phi_2443_ = _e1885;
                                                    } else {
                                                        phi_2443_ = _e1094;
                                                    }
                                                    let _e1887 = phi_2443_;
                                                    phi_1130_ = _e1887;
                                                } else {
                                                    phi_1130_ = type_47();
                                                }
                                                let _e1889 = phi_1130_;
                                                continue;
                                                continuing {
                                                    phi_1129_ = _e1889;
                                                    phi_1132_ = _e1109;
                                                    phi_3907_ = _e587;
                                                    break if !(_e1115);
                                                }
                                            }
                                            let _e1892 = phi_3907_;
                                            phi_4073_ = _e1892;
                                            if _e1892 {
                                                break;
                                            }
                                            let _e1894 = local_10;
                                            phi_4077_ = _e1892;
                                            let _e2098 = local_12;
                                            phi_3649_ = _e2098;
                                            phi_3650_ = _e628;
                                            phi_3651_ = false;
                                            phi_3652_ = select(_e632, 0u, _e1894.member_1);
                                        } else {
                                            if (_e628.member_1 >= _e95) {
                                                phi_3205_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e628.member_1 < _e95) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e643 = (_e367 * 2u);
                                                let _e645 = ((1u + _e643) % 7u);
                                                if (_e645 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e650 = global_9.member[_e628.member_1][_e645];
                                                let _e652 = ((_e643 + 2u) % 7u);
                                                if (_e652 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e657 = global_9.member[_e628.member_1][_e652];
                                                let _e658 = (_e366 * 2u);
                                                let _e660 = ((1u + _e658) % 7u);
                                                if (_e660 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e665 = global_9.member[_e628.member_1][_e660];
                                                let _e667 = ((_e658 + 2u) % 7u);
                                                if (_e667 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e672 = global_9.member[_e628.member_1][_e667];
                                                let _e673 = (_e368 * 2u);
                                                let _e675 = ((1u + _e673) % 7u);
                                                if (_e675 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e680 = global_9.member[_e628.member_1][_e675];
                                                let _e682 = ((_e673 + 2u) % 7u);
                                                if (_e682 < 7u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e687 = global_9.member[_e628.member_1][_e682];
                                                let _e710 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.x - _e628.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e711 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.y - _e628.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e712 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.z - _e628.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e714 = select(_e153, _e710, (_e710 > _e153));
                                                let _e716 = select(_e153, _e711, (_e711 > _e153));
                                                let _e718 = select(_e153, _e712, (_e712 > _e153));
                                                let _e743 = bitcast<u32>((f32(bitcast<i32>((_e650 & 2097151u))) * _e714));
                                                let _e748 = (bitcast<i32>((_e650 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                                let _e752 = bitcast<u32>((f32(bitcast<i32>((_e665 & 2097151u))) * _e716));
                                                let _e757 = (bitcast<i32>((_e665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e760 = bitcast<f32>((_e752 & bitcast<u32>(_e757)));
                                                let _e761 = bitcast<u32>((f32(bitcast<i32>((_e680 & 2097151u))) * _e718));
                                                let _e766 = (bitcast<i32>((_e680 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e769 = bitcast<f32>((_e761 & bitcast<u32>(_e766)));
                                                let _e773 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                                let _e777 = bitcast<f32>((_e752 & bitcast<u32>(~(_e757))));
                                                let _e781 = bitcast<f32>((_e761 & bitcast<u32>(~(_e766))));
                                                let _e782 = bitcast<u32>((f32(bitcast<i32>((_e657 & 2097151u))) * _e714));
                                                let _e787 = (bitcast<i32>((_e657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                                let _e791 = bitcast<u32>((f32(bitcast<i32>((_e672 & 2097151u))) * _e716));
                                                let _e796 = (bitcast<i32>((_e672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e799 = bitcast<f32>((_e791 & bitcast<u32>(_e796)));
                                                let _e800 = bitcast<u32>((f32(bitcast<i32>((_e687 & 2097151u))) * _e718));
                                                let _e805 = (bitcast<i32>((_e687 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e808 = bitcast<f32>((_e800 & bitcast<u32>(_e805)));
                                                let _e812 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                                let _e816 = bitcast<f32>((_e791 & bitcast<u32>(~(_e796))));
                                                let _e820 = bitcast<f32>((_e800 & bitcast<u32>(~(_e805))));
                                                let _e850 = global_9.member[_e628.member_1][0u];
                                                let _e854 = global_9.member[_e628.member_1][2u];
                                                let _e858 = global_9.member[_e628.member_1][4u];
                                                let _e862 = global_9.member[_e628.member_1][6u];
                                                let _e874 = (((_e854 >> bitcast<u32>(22i)) | ((_e858 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e862 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e875 = (_e850 & 268435455u);
                                                let _e876 = (_e874 & 268435455u);
                                                let _e879 = ((_e850 >> bitcast<u32>(28u)) & 7u);
                                                let _e887 = ((_e850 >> bitcast<u32>(31i)) | (((_e874 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e888 = (_e879 != 0u);
                                                if (_e879 == 0u) {
                                                    phi_3167_ = _e875;
                                                } else {
                                                    if (_e879 == 7u) {
                                                        phi_3166_ = 2147483648u;
                                                    } else {
                                                        phi_3166_ = ((2147483648u | (_e879 << bitcast<u32>(28u))) | (_e876 & 268435455u));
                                                    }
                                                    let _e897 = phi_3166_;
                                                    phi_3167_ = _e897;
                                                }
                                                let _e899 = phi_3167_;
                                                if _e888 {
                                                    let _e900 = (_e879 != 7u);
                                                    if _e900 {
                                                        phi_3177_ = (_e876 + _e879);
                                                    } else {
                                                        phi_3177_ = u32();
                                                    }
                                                    let _e903 = phi_3177_;
                                                    phi_3179_ = _e903;
                                                    phi_3180_ = select(true, false, _e900);
                                                } else {
                                                    phi_3179_ = u32();
                                                    phi_3180_ = true;
                                                }
                                                let _e906 = phi_3179_;
                                                let _e908 = phi_3180_;
                                                if (_e887 == 0u) {
                                                    phi_3201_ = (_e875 + select(0u, 1u, !(_e888)));
                                                } else {
                                                    if (_e887 == 7u) {
                                                        phi_3200_ = 2147483648u;
                                                    } else {
                                                        phi_3200_ = ((2147483648u | (_e887 << bitcast<u32>(28u))) | (select(_e906, _e876, _e908) & 268435455u));
                                                    }
                                                    let _e921 = phi_3200_;
                                                    phi_3201_ = _e921;
                                                }
                                                let _e923 = phi_3201_;
                                                phi_3205_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e628.member.member.x + _e751), (_e628.member.member.x + _e773), (_e628.member.member_1.x - _e790), (_e628.member.member_1.x - _e812)), vec4<f32>((_e628.member.member.y + _e760), (_e628.member.member.y + _e777), (_e628.member.member_1.y - _e799), (_e628.member.member_1.y - _e816)), vec4<f32>((_e628.member.member.z + _e769), (_e628.member.member.z + _e781), (_e628.member.member_1.z - _e808), (_e628.member.member_1.z - _e820))), type_63(type_35((_e628.member.member + vec4<f32>(_e751, _e760, _e769, 0f)), (_e628.member.member_1 - vec4<f32>(_e790, _e799, _e808, 0f))), _e899), type_63(type_35((_e628.member.member + vec4<f32>(_e773, _e777, _e781, 0f)), (_e628.member.member_1 - vec4<f32>(_e812, _e816, _e820, 0f))), _e923));
                                            }
                                            let _e928 = phi_3205_;
                                            let _e940 = ((_e928.member[0].x - _e422) * _e427);
                                            let _e941 = ((_e928.member[0].y - _e422) * _e427);
                                            let _e942 = ((_e928.member[0].z - _e423) * _e427);
                                            let _e943 = ((_e928.member[0].w - _e423) * _e427);
                                            let _e953 = ((_e928.member[1].x - _e458) * _e463);
                                            let _e954 = ((_e928.member[1].y - _e458) * _e463);
                                            let _e955 = ((_e928.member[1].z - _e459) * _e463);
                                            let _e956 = ((_e928.member[1].w - _e459) * _e463);
                                            let _e966 = ((_e928.member[2].x - _e494) * _e499);
                                            let _e967 = ((_e928.member[2].y - _e494) * _e499);
                                            let _e968 = ((_e928.member[2].z - _e495) * _e499);
                                            let _e969 = ((_e928.member[2].w - _e495) * _e499);
                                            let _e971 = select(_e968, _e966, (_e966 < _e968));
                                            let _e973 = select(_e969, _e967, (_e967 < _e969));
                                            let _e975 = select(_e968, _e966, (_e966 > _e968));
                                            let _e977 = select(_e969, _e967, (_e967 > _e969));
                                            let _e979 = select(_e942, _e940, (_e940 < _e942));
                                            let _e981 = select(_e943, _e941, (_e941 < _e943));
                                            let _e983 = select(_e955, _e953, (_e953 < _e955));
                                            let _e985 = select(_e956, _e954, (_e954 < _e956));
                                            let _e987 = select(_e983, _e979, (_e979 > _e983));
                                            let _e989 = select(_e985, _e981, (_e981 > _e985));
                                            let _e991 = select(_e971, _e987, (_e987 > _e971));
                                            let _e993 = select(_e973, _e989, (_e989 > _e973));
                                            let _e995 = select(_e942, _e940, (_e940 > _e942));
                                            let _e997 = select(_e943, _e941, (_e941 > _e943));
                                            let _e999 = select(_e955, _e953, (_e953 > _e955));
                                            let _e1001 = select(_e956, _e954, (_e954 > _e956));
                                            let _e1003 = select(_e999, _e995, (_e995 < _e999));
                                            let _e1005 = select(_e1001, _e997, (_e997 < _e1001));
                                            let _e1010 = -(_e971);
                                            let _e1011 = -(_e973);
                                            let _e1018 = (select(_e975, _e1003, (_e1003 < _e975)) + (select(_e1010, _e975, (_e975 > _e1010)) * 0.0000019073523f));
                                            let _e1019 = (select(_e977, _e1005, (_e1005 < _e977)) + (select(_e1011, _e977, (_e977 > _e1011)) * 0.0000019073523f));
                                            let _e1021 = select(_e545, _e991, (_e991 > _e545));
                                            let _e1023 = select(_e545, _e993, (_e993 > _e545));
                                            let _e1028 = (_e1021 <= select(_e589.member, _e1018, (_e1018 < _e589.member)));
                                            let _e1029 = (_e1023 <= select(_e589.member, _e1019, (_e1019 < _e589.member)));
                                            let _e1030 = (_e1021 <= _e1023);
                                            if _e1028 {
                                                if _e1029 {
                                                    if _e1030 {
                                                        phi_3549_ = _e928.member_2;
                                                    } else {
                                                        phi_3549_ = _e928.member_1;
                                                    }
                                                    let _e1034 = phi_3549_;
                                                    let _e1056 = (_e632 % 128u);
                                                    let _e1057 = (_e1056 < 128u);
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1056] = _e1034.member_1;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1056] = _e1034.member.member.x;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1056] = _e1034.member.member.y;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1056] = _e1034.member.member.z;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1056] = _e1034.member.member_1.x;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1056] = _e1034.member.member_1.y;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1056] = _e1034.member.member_1.z;
                                                    if _e1057 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1056] = select(_e1023, _e1021, (_e1021 > _e1023));
                                                    if _e1030 {
                                                        phi_3626_ = _e928.member_1;
                                                    } else {
                                                        phi_3626_ = _e928.member_2;
                                                    }
                                                    let _e1070 = phi_3626_;
                                                    phi_3627_ = _e1070;
                                                    phi_3628_ = (_e632 + 1u);
                                                } else {
                                                    phi_3627_ = type_63();
                                                    phi_3628_ = u32();
                                                }
                                                let _e1072 = phi_3627_;
                                                let _e1074 = phi_3628_;
                                                phi_3630_ = _e1072;
                                                phi_3631_ = _e1074;
                                                phi_3632_ = select(true, false, _e1029);
                                            } else {
                                                phi_3630_ = type_63();
                                                phi_3631_ = u32();
                                                phi_3632_ = true;
                                            }
                                            let _e1077 = phi_3630_;
                                            let _e1079 = phi_3631_;
                                            let _e1081 = phi_3632_;
                                            if _e1081 {
                                                if _e1028 {
                                                    phi_3641_ = _e928.member_1;
                                                } else {
                                                    phi_3641_ = _e928.member_2;
                                                }
                                                let _e1085 = phi_3641_;
                                                phi_3646_ = _e1085;
                                                phi_3647_ = select(_e1029, true, _e1028);
                                            } else {
                                                phi_3646_ = _e1077;
                                                phi_3647_ = _e630;
                                            }
                                            let _e1088 = phi_3646_;
                                            let _e1090 = phi_3647_;
                                            phi_4077_ = _e587;
                                            phi_3649_ = _e589;
                                            phi_3650_ = _e1088;
                                            phi_3651_ = _e1090;
                                            phi_3652_ = select(_e1079, _e632, _e1081);
                                        }
                                        let _e1898 = phi_4077_;
                                        let _e1900 = phi_3649_;
                                        let _e1902 = phi_3650_;
                                        let _e1904 = phi_3651_;
                                        let _e1906 = phi_3652_;
                                        phi_4076_ = _e1898;
                                        phi_3653_ = _e1900;
                                        phi_3654_ = _e1902;
                                        phi_3655_ = (_e593 - 1u);
                                        phi_3656_ = _e1904;
                                        phi_3657_ = _e1906;
                                    } else {
                                        phi_4076_ = _e587;
                                        phi_3653_ = _e589;
                                        phi_3654_ = _e628;
                                        phi_3655_ = _e593;
                                        phi_3656_ = _e630;
                                        phi_3657_ = _e632;
                                    }
                                    let _e1908 = phi_4076_;
                                    let _e1910 = phi_3653_;
                                    let _e1912 = phi_3654_;
                                    let _e1914 = phi_3655_;
                                    let _e1916 = phi_3656_;
                                    let _e1918 = phi_3657_;
                                    phi_4075_ = _e1908;
                                    phi_3658_ = _e1910;
                                    phi_3659_ = _e1912;
                                    phi_3660_ = _e1914;
                                    phi_3661_ = _e1916;
                                    phi_3662_ = _e1918;
                                } else {
                                    phi_4075_ = _e587;
                                    phi_3658_ = type_47();
                                    phi_3659_ = type_63();
                                    phi_3660_ = u32();
                                    phi_3661_ = bool();
                                    phi_3662_ = u32();
                                }
                                let _e1920 = phi_4075_;
                                let _e1922 = phi_3658_;
                                let _e1924 = phi_3659_;
                                let _e1926 = phi_3660_;
                                let _e1928 = phi_3661_;
                                let _e1930 = phi_3662_;
                                phi_4074_ = _e1920;
                                phi_1004_ = _e1922;
                                phi_1007_ = _e1924;
                                phi_1009_ = _e1926;
                                phi_1011_ = _e1928;
                                phi_1013_ = _e1930;
                                phi_3663_ = _e601;
                            } else {
                                phi_4074_ = _e587;
                                phi_1004_ = type_47();
                                phi_1007_ = type_63();
                                phi_1009_ = u32();
                                phi_1011_ = bool();
                                phi_1013_ = u32();
                                phi_3663_ = false;
                            }
                            let _e1932 = phi_4074_;
                            let _e1934 = phi_1004_;
                            let _e1936 = phi_1007_;
                            let _e1938 = phi_1009_;
                            let _e1940 = phi_1011_;
                            let _e1942 = phi_1013_;
                            let _e1944 = phi_3663_;
                            continue;
                            continuing {
                                phi_3913_ = _e1932;
                                phi_1003_ = _e1934;
                                phi_1006_ = _e1936;
                                phi_1008_ = _e1938;
                                phi_1010_ = _e1940;
                                phi_1012_ = _e1942;
                                phi_4073_ = _e1932;
                                break if !(_e1944);
                            }
                        }
                        let _e1947 = phi_4073_;
                        if _e1947 {
                            break;
                        }
                        let _e1949 = local_11;
                        if _e1949.member_1 {
                        } else {
                            if _e235 {
                            } else {
                                break;
                            }
                            let _e1953 = global_2.member[_e141];
                            if _e156 {
                            } else {
                                break;
                            }
                            let _e1957 = global_10.member[_e141].member_1;
                            if _e235 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_28(_e1953.member, _e1953.member_1, _e1953.member_2, array<f32, 3>((_e1953.member_3[0] + (_e1957[0] * _e1953.member_1[0])), (_e1953.member_3[1] + (_e1957[1] * _e1953.member_1[1])), (_e1953.member_3[2] + (_e1957[2] * _e1953.member_1[2]))), _e1953.member_4);
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
fn trace_shadows_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
