struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: bool,
}

struct type_53 {
    member: array<vec4<u32>, 2>,
}

struct type_56 {
    member: array<i32>,
}

struct type_63 {
    member: type_39,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_53;
@group(0) @binding(2) 
var<uniform> global_4: type_53;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_56;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_42;

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
    var phi_395_: type_45;
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
    var phi_1003_: type_51;
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
    var phi_1129_: type_51;
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
    var phi_2074_: type_30;
    var phi_2076_: type_30;
    var phi_2077_: bool;
    var phi_2081_: type_30;
    var phi_2082_: type_30;
    var phi_2083_: type_30;
    var phi_2084_: bool;
    var phi_2088_: type_30;
    var phi_2089_: bool;
    var phi_2090_: type_30;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2093_: type_30;
    var phi_2094_: bool;
    var phi_2095_: bool;
    var phi_2103_: type_30;
    var phi_2104_: bool;
    var phi_2108_: type_30;
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
    var phi_2442_: type_51;
    var phi_2443_: type_51;
    var phi_1130_: type_51;
    var phi_3907_: bool;
    var local_10: type_51;
    var phi_4077_: bool;
    var phi_3649_: type_51;
    var phi_3650_: type_63;
    var phi_3651_: bool;
    var phi_3652_: u32;
    var phi_4076_: bool;
    var phi_3653_: type_51;
    var phi_3654_: type_63;
    var phi_3655_: u32;
    var phi_3656_: bool;
    var phi_3657_: u32;
    var phi_4075_: bool;
    var phi_3658_: type_51;
    var phi_3659_: type_63;
    var phi_3660_: u32;
    var phi_3661_: bool;
    var phi_3662_: u32;
    var phi_4074_: bool;
    var phi_1004_: type_51;
    var phi_1007_: type_63;
    var phi_1009_: u32;
    var phi_1011_: bool;
    var phi_1013_: u32;
    var phi_3663_: bool;
    var phi_4073_: bool;
    var local_11: type_51;
    var local_12: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_5.member));
            let _e99 = arrayLength((&global_6.member));
            let _e111 = arrayLength((&global_9.member));
            let _e115 = global_4.member[0u][0u];
            let _e119 = global_4.member[0u][1u];
            let _e123 = global_4.member[0u][2u];
            let _e127 = global_4.member[0u][3u];
            let _e131 = global_4.member[1u][0u];
            let _e135 = global_4.member[1u][1u];
            let _e139 = global_4.member[1u][2u];
            let _e143 = (_e95.x + (_e95.y * 2097152u));
            let _e155 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e127) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            local = array<i32, 3>(bitcast<i32>(_e131), bitcast<i32>(_e135), bitcast<i32>(_e139));
            let _e158 = (_e143 < arrayLength((&global_10.member)));
            if _e158 {
                if _e158 {
                } else {
                    break;
                }
                let _e162 = global_10.member[_e143].member_2;
                phi_327_ = _e162;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e164 = phi_327_;
            let _e167 = global_1.member[0u];
            let _e171 = global_3.member[0u][0u];
            let _e175 = global_3.member[0u][1u];
            let _e179 = global_3.member[0u][2u];
            let _e183 = global_3.member[0u][3u];
            let _e187 = global_3.member[1u][0u];
            let _e191 = global_3.member[1u][1u];
            let _e195 = global_3.member[1u][2u];
            let _e199 = global_3.member[1u][3u];
            let _e200 = bitcast<f32>(_e171);
            let _e201 = bitcast<f32>(_e175);
            let _e202 = bitcast<f32>(_e179);
            let _e204 = bitcast<f32>(_e187);
            let _e205 = array<u32, 3>(_e191, _e195, _e199);
            let _e207 = bitcast<i32>(_e167);
            if (_e207 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e207, 127i, (_e207 > 127i));
            }
            let _e212 = phi_371_;
            let _e217 = bitcast<f32>((bitcast<u32>((_e212 + 127i)) << bitcast<u32>(23i)));
            let _e223 = bitcast<f32>((bitcast<u32>(((_e207 - _e212) + 127i)) << bitcast<u32>(23i)));
            if (_e183 == 0u) {
                phi_395_ = type_45(array<f32, 3>(_e200, _e201, _e202), _e183, _e204, _e205);
            } else {
                phi_395_ = type_45(array<f32, 3>(((_e200 * _e217) * _e223), ((_e201 * _e217) * _e223), ((_e202 * _e217) * _e223)), _e183, ((_e204 * _e217) * _e223), _e205);
            }
            let _e236 = phi_395_;
            if _e158 {
                let _e237 = (_e143 < arrayLength((&global_2.member)));
                if _e237 {
                    if _e158 {
                    } else {
                        break;
                    }
                    let _e242 = global_10.member[_e143].member.member_1;
                    let _e247 = global_10.member[_e143].member.member_3;
                    if (_e242 <= _e247) {
                        let _e249 = (1u < _e111);
                        if _e249 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e253 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e253 + 1u) < _e253) {
                                if _e249 {
                                } else {
                                    break;
                                }
                                let _e258 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e158 {
                        } else {
                            break;
                        }
                        let _e268 = global_10.member[_e143].member.member_2[0u];
                        let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                        let _e276 = global_10.member[_e143].member.member_2[1u];
                        let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                        let _e284 = global_10.member[_e143].member.member_2[2u];
                        let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                        let _e292 = global_10.member[_e143].member.member[0u];
                        let _e294 = (bitcast<u32>(_e292) & 2147483647u);
                        let _e300 = global_10.member[_e143].member.member[1u];
                        let _e302 = (bitcast<u32>(_e300) & 2147483647u);
                        let _e308 = global_10.member[_e143].member.member[2u];
                        let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                        let _e312 = select(_e278, _e270, (_e278 < _e270));
                        let _e314 = select(_e286, _e312, (_e286 < _e312));
                        let _e316 = select(_e294, _e314, (_e294 < _e314));
                        let _e318 = select(_e302, _e316, (_e302 < _e316));
                        let _e320 = select(_e310, _e318, (_e310 < _e318));
                        let _e322 = (bitcast<u32>(_e242) & 2147483647u);
                        let _e331 = (((select(_e322, _e320, (_e322 < _e320)) < 2139095040u) && ((bitcast<u32>(_e247) & 2147483647u) <= 2139095040u)) && (_e314 > 0u));
                        if _e331 {
                            let _e334 = (bitcast<u32>(bitcast<f32>(_e314)) & 2147483647u);
                            if (_e334 >= 8388608u) {
                                phi_545_ = (bitcast<i32>((_e334 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_545_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e334)), 32u, (_e334 == 0u))));
                            }
                            let _e348 = phi_545_;
                            phi_546_ = _e348;
                        } else {
                            phi_546_ = 0i;
                        }
                        let _e350 = phi_546_;
                        let _e351 = (_e270 == _e314);
                        if _e351 {
                            phi_556_ = true;
                        } else {
                            phi_556_ = (_e278 == _e314);
                        }
                        let _e354 = phi_556_;
                        let _e355 = select(1u, 0u, _e351);
                        if _e354 {
                            let _e356 = (_e355 + 1u);
                            phi_566_ = _e356;
                            phi_567_ = _e356;
                            phi_569_ = select(true, false, (_e356 == 2u));
                        } else {
                            phi_566_ = u32();
                            phi_567_ = 0u;
                            phi_569_ = true;
                        }
                        let _e360 = phi_566_;
                        let _e362 = phi_567_;
                        let _e364 = phi_569_;
                        if _e364 {
                            phi_574_ = (_e362 + 1u);
                        } else {
                            phi_574_ = 0u;
                        }
                        let _e368 = phi_574_;
                        let _e369 = select(_e360, _e362, _e364);
                        let _e370 = select(_e355, select(2u, _e355, _e354), _e364);
                        let _e371 = -(_e350);
                        if (_e371 < -126i) {
                            phi_606_ = -126i;
                        } else {
                            phi_606_ = select(_e371, 127i, (_e371 > 127i));
                        }
                        let _e376 = phi_606_;
                        let _e381 = bitcast<f32>((bitcast<u32>((_e376 + 127i)) << bitcast<u32>(23i)));
                        let _e387 = bitcast<f32>((bitcast<u32>(((_e371 - _e376) + 127i)) << bitcast<u32>(23i)));
                        let _e392 = global_10.member[_e143].member.member;
                        let _e393 = (_e369 == 0u);
                        if _e393 {
                            phi_624_ = _e392[0];
                        } else {
                            phi_624_ = _e392[1];
                        }
                        let _e397 = phi_624_;
                        let _e398 = (_e369 == 2u);
                        if _e398 {
                            phi_630_ = _e392[2];
                        } else {
                            phi_630_ = _e397;
                        }
                        let _e401 = phi_630_;
                        let _e402 = global_10.member[_e143].member.member_2;
                        if _e393 {
                            phi_641_ = _e402[0];
                        } else {
                            phi_641_ = _e402[1];
                        }
                        let _e406 = phi_641_;
                        if _e398 {
                            phi_647_ = _e402[2];
                        } else {
                            phi_647_ = _e406;
                        }
                        let _e409 = phi_647_;
                        let _e411 = ((_e409 * _e381) * _e387);
                        let _e415 = (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e415 {
                            let _e419 = (bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)) * 0.00000011920929f);
                            phi_670_ = select(0.00000000000011368684f, _e419, (_e419 > 0.00000000000011368684f));
                        } else {
                            phi_670_ = 0f;
                        }
                        let _e423 = phi_670_;
                        let _e424 = (_e401 + _e423);
                        let _e425 = (_e401 - _e423);
                        let _e426 = select(_e411, 0f, _e415);
                        if _e415 {
                            phi_681_ = 38685626000000000000000000f;
                        } else {
                            phi_681_ = (1f / _e411);
                        }
                        let _e429 = phi_681_;
                        let _e430 = (_e368 == 0u);
                        if _e430 {
                            phi_690_ = _e392[0];
                        } else {
                            phi_690_ = _e392[1];
                        }
                        let _e434 = phi_690_;
                        let _e435 = (_e368 == 2u);
                        if _e435 {
                            phi_696_ = _e392[2];
                        } else {
                            phi_696_ = _e434;
                        }
                        let _e438 = phi_696_;
                        if _e430 {
                            phi_707_ = _e402[0];
                        } else {
                            phi_707_ = _e402[1];
                        }
                        let _e442 = phi_707_;
                        if _e435 {
                            phi_713_ = _e402[2];
                        } else {
                            phi_713_ = _e442;
                        }
                        let _e445 = phi_713_;
                        let _e447 = ((_e445 * _e381) * _e387);
                        let _e451 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e451 {
                            let _e455 = (bitcast<f32>((bitcast<u32>(_e438) & 2147483647u)) * 0.00000011920929f);
                            phi_736_ = select(0.00000000000011368684f, _e455, (_e455 > 0.00000000000011368684f));
                        } else {
                            phi_736_ = 0f;
                        }
                        let _e459 = phi_736_;
                        let _e460 = (_e438 + _e459);
                        let _e461 = (_e438 - _e459);
                        let _e462 = select(_e447, 0f, _e451);
                        if _e451 {
                            phi_747_ = 38685626000000000000000000f;
                        } else {
                            phi_747_ = (1f / _e447);
                        }
                        let _e465 = phi_747_;
                        let _e466 = (_e370 == 0u);
                        if _e466 {
                            phi_756_ = _e392[0];
                        } else {
                            phi_756_ = _e392[1];
                        }
                        let _e470 = phi_756_;
                        let _e471 = (_e370 == 2u);
                        if _e471 {
                            phi_762_ = _e392[2];
                        } else {
                            phi_762_ = _e470;
                        }
                        let _e474 = phi_762_;
                        if _e466 {
                            phi_773_ = _e402[0];
                        } else {
                            phi_773_ = _e402[1];
                        }
                        let _e478 = phi_773_;
                        if _e471 {
                            phi_779_ = _e402[2];
                        } else {
                            phi_779_ = _e478;
                        }
                        let _e481 = phi_779_;
                        let _e483 = ((_e481 * _e381) * _e387);
                        let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e487 {
                            let _e491 = (bitcast<f32>((bitcast<u32>(_e474) & 2147483647u)) * 0.00000011920929f);
                            phi_802_ = select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f));
                        } else {
                            phi_802_ = 0f;
                        }
                        let _e495 = phi_802_;
                        let _e496 = (_e474 + _e495);
                        let _e497 = (_e474 - _e495);
                        let _e498 = select(_e483, 0f, _e487);
                        if _e487 {
                            phi_813_ = 38685626000000000000000000f;
                        } else {
                            phi_813_ = (1f / _e483);
                        }
                        let _e501 = phi_813_;
                        let _e504 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                        let _e507 = bitcast<f32>((bitcast<u32>(_e438) & 2147483647u));
                        let _e509 = select(_e507, _e504, (_e504 > _e507));
                        let _e512 = bitcast<f32>((bitcast<u32>(_e474) & 2147483647u));
                        if (_e331 && (select(_e512, _e509, (_e509 > _e512)) <= 1099511600000f)) {
                            let _e517 = (_e350 / 3i);
                            let _e524 = bitcast<f32>((bitcast<u32>((_e517 + 127i)) << bitcast<u32>(23i)));
                            let _e531 = bitcast<f32>((bitcast<u32>(((_e350 - (2i * _e517)) + 127i)) << bitcast<u32>(23i)));
                            let _e532 = (((_e242 * _e524) * _e524) * _e531);
                            let _e534 = select(340282350000000000000000000000000000000f, _e532, (_e532 < 340282350000000000000000000000000000000f));
                            let _e539 = (((_e247 * _e524) * _e524) * _e531);
                            let _e541 = select(340282350000000000000000000000000000000f, _e539, (_e539 < 340282350000000000000000000000000000000f));
                            phi_913_ = select(-340282350000000000000000000000000000000f, _e541, (_e541 > -340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_913_ = 0f;
                            phi_914_ = 1f;
                        }
                        let _e545 = phi_913_;
                        let _e547 = phi_914_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e551 = (_e369 % 3u);
                        let _e552 = (_e551 < 3u);
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e554 = local_1[_e551];
                        let _e557 = (_e368 % 3u);
                        let _e558 = (_e557 < 3u);
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e560 = local_1[_e557];
                        let _e563 = (_e370 % 3u);
                        let _e564 = (_e563 < 3u);
                        if _e564 {
                        } else {
                            break;
                        }
                        let _e566 = local_1[_e563];
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e571 = local[_e551];
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e575 = local[_e557];
                        if _e564 {
                        } else {
                            break;
                        }
                        let _e579 = local[_e563];
                        phi_3913_ = false;
                        phi_1003_ = type_51(_e545, false);
                        phi_1006_ = type_63(type_39(vec4<f32>((f32(_e554) * _e155), (f32(_e560) * _e155), (f32(_e566) * _e155), 0f), vec4<f32>((f32(_e571) * _e155), (f32(_e575) * _e155), (f32(_e579) * _e155), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                        phi_1008_ = ((3u * _e97) + 1u);
                        phi_1010_ = (_e547 <= _e545);
                        phi_1012_ = 0u;
                        loop {
                            let _e589 = phi_3913_;
                            let _e591 = phi_1003_;
                            let _e593 = phi_1006_;
                            let _e595 = phi_1008_;
                            let _e597 = phi_1010_;
                            let _e599 = phi_1012_;
                            local_11 = _e591;
                            if _e597 {
                                phi_1023_ = true;
                            } else {
                                phi_1023_ = (_e599 > 0u);
                            }
                            let _e602 = phi_1023_;
                            if _e602 {
                                let _e603 = (_e595 > 0u);
                                if _e603 {
                                    if _e597 {
                                        phi_1109_ = _e593;
                                        phi_1110_ = _e597;
                                        phi_1111_ = _e599;
                                    } else {
                                        let _e604 = (_e599 - 1u);
                                        let _e605 = (_e604 % 128u);
                                        let _e606 = (_e605 < 128u);
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e608 = local_7[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e610 = local_6[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e612 = local_5[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e614 = local_4[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e616 = local_3[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e618 = local_2[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e623 = local_8[_e605];
                                        if _e606 {
                                        } else {
                                            phi_4073_ = true;
                                            break;
                                        }
                                        let _e626 = local_9[_e605];
                                        phi_1109_ = type_63(type_39(vec4<f32>(_e608, _e610, _e612, 0f), vec4<f32>(_e614, _e616, _e618, 0f)), _e623);
                                        phi_1110_ = (_e626 <= _e591.member);
                                        phi_1111_ = _e604;
                                    }
                                    let _e630 = phi_1109_;
                                    let _e632 = phi_1110_;
                                    let _e634 = phi_1111_;
                                    if _e632 {
                                        if ((_e630.member_1 & 2147483648u) != 0u) {
                                            phi_1129_ = _e591;
                                            phi_1132_ = type_8(0u, ((_e630.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1078 = phi_1129_;
                                                let _e1080 = phi_1132_;
                                                local_10 = _e1078;
                                                local_12 = _e1078;
                                                if (_e1080.member < _e1080.member_1) {
                                                    phi_1133_ = type_8((_e1080.member + 1u), _e1080.member_1);
                                                    phi_1155_ = type_8(1u, _e1080.member);
                                                } else {
                                                    phi_1133_ = _e1080;
                                                    phi_1155_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1093 = phi_1133_;
                                                let _e1095 = phi_1155_;
                                                let _e1099 = (bitcast<i32>(_e1095.member) != 0i);
                                                if _e1099 {
                                                    let _e1100 = ((_e630.member_1 & 268435455u) + _e1095.member_1);
                                                    let _e1101 = (_e1100 < _e99);
                                                    if _e1101 {
                                                        if _e1101 {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1105 = global_6.member[_e1100].member_1;
                                                        phi_1176_ = _e1105;
                                                    } else {
                                                        phi_1176_ = 4294967295u;
                                                    }
                                                    let _e1107 = phi_1176_;
                                                    if (_e1100 >= _e99) {
                                                        phi_1265_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1101 {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        if (_e551 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1114 = global_6.member[_e1100].member[_e551];
                                                        if (_e557 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1120 = global_6.member[_e1100].member[_e557];
                                                        if (_e563 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1126 = global_6.member[_e1100].member[_e563];
                                                        let _e1128 = (3u + _e551);
                                                        if (_e1128 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1134 = global_6.member[_e1100].member[_e1128];
                                                        let _e1135 = (3u + _e557);
                                                        if (_e1135 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1141 = global_6.member[_e1100].member[_e1135];
                                                        let _e1142 = (3u + _e563);
                                                        if (_e1142 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1148 = global_6.member[_e1100].member[_e1142];
                                                        let _e1150 = (6u + _e551);
                                                        if (_e1150 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1156 = global_6.member[_e1100].member[_e1150];
                                                        let _e1157 = (6u + _e557);
                                                        if (_e1157 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1163 = global_6.member[_e1100].member[_e1157];
                                                        let _e1164 = (6u + _e563);
                                                        if (_e1164 < 9u) {
                                                        } else {
                                                            phi_3907_ = true;
                                                            break;
                                                        }
                                                        let _e1170 = global_6.member[_e1100].member[_e1164];
                                                        phi_1265_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1114, _e1120, _e1126), array<f32, 3>(_e1134, _e1141, _e1148), array<f32, 3>(_e1156, _e1163, _e1170));
                                                    }
                                                    let _e1174 = phi_1265_;
                                                    let _e1182 = (_e1174[0][2] - _e474);
                                                    let _e1185 = (((_e1174[0][0] - _e401) * _e498) - (_e1182 * _e426));
                                                    let _e1188 = (((_e1174[0][1] - _e438) * _e498) - (_e1182 * _e462));
                                                    let _e1195 = (_e1174[1][2] - _e474);
                                                    let _e1198 = (((_e1174[1][0] - _e401) * _e498) - (_e1195 * _e426));
                                                    let _e1201 = (((_e1174[1][1] - _e438) * _e498) - (_e1195 * _e462));
                                                    let _e1208 = (_e1174[2][2] - _e474);
                                                    let _e1211 = (((_e1174[2][0] - _e401) * _e498) - (_e1208 * _e426));
                                                    let _e1214 = (((_e1174[2][1] - _e438) * _e498) - (_e1208 * _e462));
                                                    let _e1215 = (_e1211 * _e1201);
                                                    let _e1216 = (_e1214 * _e1198);
                                                    let _e1217 = (_e1185 * _e1214);
                                                    let _e1218 = (_e1188 * _e1211);
                                                    let _e1219 = (_e1198 * _e1188);
                                                    let _e1220 = (_e1201 * _e1185);
                                                    let _e1225 = (((_e1215 >= _e1216) && (_e1217 >= _e1218)) && (_e1219 >= _e1220));
                                                    if (_e1225 || (((_e1215 <= _e1216) && (_e1217 <= _e1218)) && (_e1219 <= _e1220))) {
                                                        let _e1232 = select(-1f, 1f, _e1225);
                                                        let _e1234 = ((_e1215 - _e1216) * _e1232);
                                                        let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                                        let _e1238 = ((_e1217 - _e1218) * _e1232);
                                                        let _e1240 = select(0f, _e1238, (_e1238 > 0f));
                                                        let _e1242 = ((_e1219 - _e1220) * _e1232);
                                                        let _e1244 = select(0f, _e1242, (_e1242 > 0f));
                                                        let _e1246 = ((_e1236 + _e1240) + _e1244);
                                                        if (_e1246 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2093_ = type_30();
                                                            phi_2094_ = true;
                                                            phi_2095_ = false;
                                                        } else {
                                                            let _e1249 = select(_e1198, _e1185, (_e1185 < _e1198));
                                                            if (select(_e1211, _e1249, (_e1249 < _e1211)) > 0f) {
                                                                phi_1382_ = true;
                                                            } else {
                                                                let _e1254 = select(_e1198, _e1185, (_e1185 > _e1198));
                                                                phi_1382_ = (select(_e1211, _e1254, (_e1254 > _e1211)) < 0f);
                                                            }
                                                            let _e1259 = phi_1382_;
                                                            if _e1259 {
                                                                phi_2090_ = type_30();
                                                                phi_2091_ = true;
                                                                phi_2092_ = false;
                                                            } else {
                                                                let _e1261 = select(_e1201, _e1188, (_e1188 < _e1201));
                                                                if (select(_e1214, _e1261, (_e1261 < _e1214)) > 0f) {
                                                                    phi_1411_ = true;
                                                                } else {
                                                                    let _e1266 = select(_e1201, _e1188, (_e1188 > _e1201));
                                                                    phi_1411_ = (select(_e1214, _e1266, (_e1266 > _e1214)) < 0f);
                                                                }
                                                                let _e1271 = phi_1411_;
                                                                if _e1271 {
                                                                    phi_2088_ = type_30();
                                                                    phi_2089_ = false;
                                                                } else {
                                                                    let _e1273 = select(_e1174[1][0], _e1174[0][0], (_e1174[0][0] < _e1174[1][0]));
                                                                    let _e1277 = select(_e1174[1][0], _e1174[0][0], (_e1174[0][0] > _e1174[1][0]));
                                                                    let _e1281 = select(_e1174[1][1], _e1174[0][1], (_e1174[0][1] < _e1174[1][1]));
                                                                    let _e1285 = select(_e1174[1][1], _e1174[0][1], (_e1174[0][1] > _e1174[1][1]));
                                                                    let _e1289 = select(_e1174[1][2], _e1174[0][2], (_e1174[0][2] < _e1174[1][2]));
                                                                    let _e1293 = select(_e1174[1][2], _e1174[0][2], (_e1174[0][2] > _e1174[1][2]));
                                                                    let _e1298 = ((select(_e1174[2][0], _e1273, (_e1273 < _e1174[2][0])) - _e424) * _e429);
                                                                    let _e1299 = ((select(_e1174[2][0], _e1277, (_e1277 > _e1174[2][0])) - _e425) * _e429);
                                                                    let _e1302 = ((select(_e1174[2][1], _e1281, (_e1281 < _e1174[2][1])) - _e460) * _e465);
                                                                    let _e1303 = ((select(_e1174[2][1], _e1285, (_e1285 > _e1174[2][1])) - _e461) * _e465);
                                                                    let _e1306 = ((select(_e1174[2][2], _e1289, (_e1289 < _e1174[2][2])) - _e496) * _e501);
                                                                    let _e1307 = ((select(_e1174[2][2], _e1293, (_e1293 > _e1174[2][2])) - _e497) * _e501);
                                                                    let _e1309 = select(_e1307, _e1306, (_e1306 < _e1307));
                                                                    let _e1311 = select(_e1307, _e1306, (_e1306 > _e1307));
                                                                    let _e1313 = select(_e1299, _e1298, (_e1298 < _e1299));
                                                                    let _e1315 = select(_e1303, _e1302, (_e1302 < _e1303));
                                                                    let _e1317 = select(_e1315, _e1313, (_e1313 > _e1315));
                                                                    let _e1319 = select(_e1309, _e1317, (_e1317 > _e1309));
                                                                    let _e1321 = select(_e1299, _e1298, (_e1298 > _e1299));
                                                                    let _e1323 = select(_e1303, _e1302, (_e1302 > _e1303));
                                                                    let _e1325 = select(_e1323, _e1321, (_e1321 < _e1323));
                                                                    let _e1327 = select(_e1311, _e1325, (_e1325 < _e1311));
                                                                    let _e1328 = -(_e1309);
                                                                    let _e1334 = select(_e547, _e1319, (_e1319 > _e547));
                                                                    if (_e1334 > (_e1327 + (select(_e1328, _e1311, (_e1311 > _e1328)) * 0.0000019073523f))) {
                                                                        phi_2083_ = type_30();
                                                                        phi_2084_ = true;
                                                                    } else {
                                                                        let _e1336 = (_e1334 > _e1078.member);
                                                                        if _e1336 {
                                                                            phi_2082_ = type_30();
                                                                        } else {
                                                                            let _e1337 = vec3<f32>(_e1174[0][0], _e1174[0][1], _e1174[0][2]);
                                                                            let _e1338 = vec3<f32>(_e1174[1][0], _e1174[1][1], _e1174[1][2]);
                                                                            let _e1339 = vec3<f32>(_e1174[2][0], _e1174[2][1], _e1174[2][2]);
                                                                            let _e1340 = (_e1174[1][0] - _e1174[0][0]);
                                                                            let _e1341 = (_e1174[1][1] - _e1174[0][1]);
                                                                            let _e1342 = (_e1174[1][2] - _e1174[0][2]);
                                                                            let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                                            let _e1344 = (_e1174[2][0] - _e1174[1][0]);
                                                                            let _e1345 = (_e1174[2][1] - _e1174[1][1]);
                                                                            let _e1346 = (_e1174[2][2] - _e1174[1][2]);
                                                                            let _e1347 = vec3<f32>(_e1344, _e1345, _e1346);
                                                                            let _e1348 = (_e1174[0][0] - _e1174[2][0]);
                                                                            let _e1349 = (_e1174[0][1] - _e1174[2][1]);
                                                                            let _e1350 = (_e1174[0][2] - _e1174[2][2]);
                                                                            let _e1351 = vec3<f32>(_e1348, _e1349, _e1350);
                                                                            let _e1354 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                            let _e1357 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                            let _e1359 = select(_e1357, _e1354, (_e1354 > _e1357));
                                                                            let _e1362 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                            let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                            let _e1367 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                            let _e1370 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                            let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                            let _e1375 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                            let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                            let _e1380 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                            let _e1383 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                            let _e1385 = select(_e1383, _e1380, (_e1380 > _e1383));
                                                                            let _e1388 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                            let _e1390 = select(_e1388, _e1385, (_e1385 > _e1388));
                                                                            let _e1392 = select(_e1377, _e1364, (_e1364 > _e1377));
                                                                            let _e1394 = select(_e1390, _e1392, (_e1392 > _e1390));
                                                                            if (_e1364 == _e1394) {
                                                                                phi_1812_ = _e1201;
                                                                                phi_1813_ = _e1198;
                                                                                phi_1814_ = _e1188;
                                                                                phi_1815_ = _e1185;
                                                                                phi_1816_ = _e1337;
                                                                                phi_1817_ = _e1351;
                                                                                phi_1818_ = _e1347;
                                                                                phi_1819_ = _e1343;
                                                                            } else {
                                                                                let _e1396 = (_e1377 == _e1394);
                                                                                let _e1401 = vec3(_e1396);
                                                                                phi_1812_ = select(_e1188, _e1214, _e1396);
                                                                                phi_1813_ = select(_e1185, _e1211, _e1396);
                                                                                phi_1814_ = select(_e1214, _e1201, _e1396);
                                                                                phi_1815_ = select(_e1211, _e1198, _e1396);
                                                                                phi_1816_ = select(_e1339, _e1338, _e1401);
                                                                                phi_1817_ = select(_e1347, _e1343, _e1401);
                                                                                phi_1818_ = select(_e1343, _e1351, _e1401);
                                                                                phi_1819_ = select(_e1351, _e1347, _e1401);
                                                                            }
                                                                            let _e1407 = phi_1812_;
                                                                            let _e1409 = phi_1813_;
                                                                            let _e1411 = phi_1814_;
                                                                            let _e1413 = phi_1815_;
                                                                            let _e1415 = phi_1816_;
                                                                            let _e1417 = phi_1817_;
                                                                            let _e1419 = phi_1818_;
                                                                            let _e1421 = phi_1819_;
                                                                            let _e1428 = ((_e1419.y * _e1417.z) - (_e1417.y * _e1419.z));
                                                                            let _e1433 = ((_e1419.z * _e1417.x) - (_e1417.z * _e1419.x));
                                                                            let _e1436 = ((_e1419.x * _e1417.y) - (_e1417.x * _e1419.y));
                                                                            if (_e1236 >= _e1240) {
                                                                                phi_1850_ = select(true, false, (_e1236 >= _e1244));
                                                                            } else {
                                                                                phi_1850_ = true;
                                                                            }
                                                                            let _e1441 = phi_1850_;
                                                                            if _e1441 {
                                                                                phi_1859_ = select(_e1339, _e1338, vec3((_e1240 >= _e1244)));
                                                                            } else {
                                                                                phi_1859_ = _e1337;
                                                                            }
                                                                            let _e1446 = phi_1859_;
                                                                            let _e1451 = (((_e1428 * _e426) + (_e1433 * _e462)) + (_e1436 * _e498));
                                                                            let _e1462 = (((_e1428 * (_e1446.x - _e401)) + (_e1433 * (_e1446.y - _e438))) + (_e1436 * (_e1446.z - _e474)));
                                                                            let _e1464 = (_e1409 - _e1413);
                                                                            let _e1465 = (_e1407 - _e1411);
                                                                            let _e1473 = (-(((_e1413 * _e1464) + (_e1411 * _e1465))) / ((_e1464 * _e1464) + (_e1465 * _e1465)));
                                                                            let _e1475 = select(1f, _e1473, (_e1473 < 1f));
                                                                            let _e1477 = select(0f, _e1475, (_e1475 > 0f));
                                                                            let _e1490 = ((_e1415.x + (_e1421.x * _e1477)) - _e401);
                                                                            let _e1491 = ((_e1415.y + (_e1421.y * _e1477)) - _e438);
                                                                            let _e1492 = ((_e1415.z + (_e1421.z * _e1477)) - _e474);
                                                                            let _e1493 = (_e1492 / _e498);
                                                                            let _e1505 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                            let _e1508 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                                            let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                            let _e1513 = bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u));
                                                                            let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                            let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1428 * _e1490) + (_e1433 * _e1491)) + (_e1436 * _e1492)) - _e1462)) & 2147483647u)) <= ((0.0000009536743f * select(_e1394, _e1515, (_e1515 > _e1394))) * select(_e1529, _e1526, (_e1526 > _e1529)))) {
                                                                                let _e1539 = bitcast<f32>((bitcast<u32>(_e1419.x) & 2147483647u));
                                                                                let _e1542 = bitcast<f32>((bitcast<u32>(_e1419.y) & 2147483647u));
                                                                                let _e1544 = select(_e1542, _e1539, (_e1539 > _e1542));
                                                                                let _e1547 = bitcast<f32>((bitcast<u32>(_e1419.z) & 2147483647u));
                                                                                let _e1553 = bitcast<f32>((bitcast<u32>(_e1417.x) & 2147483647u));
                                                                                let _e1556 = bitcast<f32>((bitcast<u32>(_e1417.y) & 2147483647u));
                                                                                let _e1558 = select(_e1556, _e1553, (_e1553 > _e1556));
                                                                                let _e1561 = bitcast<f32>((bitcast<u32>(_e1417.z) & 2147483647u));
                                                                                phi_2026_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u)) > ((0.0000038146973f * select(_e1547, _e1544, (_e1544 > _e1547))) * select(_e1561, _e1558, (_e1558 > _e1561)))));
                                                                            } else {
                                                                                phi_2026_ = true;
                                                                            }
                                                                            let _e1568 = phi_2026_;
                                                                            if _e1568 {
                                                                                let _e1579 = ((((_e1428 * (_e1490 - (_e426 * _e1493))) + (_e1433 * (_e1491 - (_e462 * _e1493)))) + (_e1436 * (_e1492 - _e1492))) / _e1451);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u)) <= _e1394) {
                                                                                    phi_2050_ = (_e1493 + _e1579);
                                                                                } else {
                                                                                    phi_2050_ = _e1493;
                                                                                }
                                                                                let _e1586 = phi_2050_;
                                                                                phi_2051_ = _e1586;
                                                                            } else {
                                                                                phi_2051_ = (_e1462 / _e1451);
                                                                            }
                                                                            let _e1588 = phi_2051_;
                                                                            let _e1590 = select(_e1327, _e1588, (_e1588 < _e1327));
                                                                            let _e1592 = select(_e1319, _e1590, (_e1590 > _e1319));
                                                                            if (_e1592 >= _e547) {
                                                                                let _e1594 = (_e1592 <= _e1078.member);
                                                                                if _e1594 {
                                                                                    let _e1595 = (1f / _e1246);
                                                                                    phi_2074_ = type_30(_e1592, (_e1240 * _e1595), (_e1244 * _e1595), _e1107);
                                                                                } else {
                                                                                    phi_2074_ = type_30();
                                                                                }
                                                                                let _e1600 = phi_2074_;
                                                                                phi_2076_ = _e1600;
                                                                                phi_2077_ = select(true, false, _e1594);
                                                                            } else {
                                                                                phi_2076_ = type_30();
                                                                                phi_2077_ = true;
                                                                            }
                                                                            let _e1603 = phi_2076_;
                                                                            let _e1605 = phi_2077_;
                                                                            if _e1605 {
                                                                                phi_2081_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2081_ = _e1603;
                                                                            }
                                                                            let _e1607 = phi_2081_;
                                                                            phi_2082_ = _e1607;
                                                                        }
                                                                        let _e1609 = phi_2082_;
                                                                        phi_2083_ = _e1609;
                                                                        phi_2084_ = _e1336;
                                                                    }
                                                                    let _e1611 = phi_2083_;
                                                                    let _e1613 = phi_2084_;
                                                                    phi_2088_ = _e1611;
                                                                    phi_2089_ = _e1613;
                                                                }
                                                                let _e1615 = phi_2088_;
                                                                let _e1617 = phi_2089_;
                                                                phi_2090_ = _e1615;
                                                                phi_2091_ = _e1271;
                                                                phi_2092_ = _e1617;
                                                            }
                                                            let _e1619 = phi_2090_;
                                                            let _e1621 = phi_2091_;
                                                            let _e1623 = phi_2092_;
                                                            phi_2093_ = _e1619;
                                                            phi_2094_ = _e1621;
                                                            phi_2095_ = _e1623;
                                                        }
                                                        let _e1625 = phi_2093_;
                                                        let _e1627 = phi_2094_;
                                                        let _e1629 = phi_2095_;
                                                        phi_2103_ = _e1625;
                                                        phi_2104_ = select(_e1629, true, _e1627);
                                                    } else {
                                                        phi_2103_ = type_30();
                                                        phi_2104_ = true;
                                                    }
                                                    let _e1632 = phi_2103_;
                                                    let _e1634 = phi_2104_;
                                                    if _e1634 {
                                                        phi_2108_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2108_ = _e1632;
                                                    }
                                                    let _e1636 = phi_2108_;
                                                    if (_e1636.member_3 != 4294967295u) {
                                                        if (_e1107 == _e164) {
                                                            phi_2437_ = false;
                                                        } else {
                                                            let _e1640 = (_e1107 < arrayLength((&global_7.member)));
                                                            if _e1640 {
                                                                if _e1640 {
                                                                } else {
                                                                    phi_3907_ = true;
                                                                    break;
                                                                }
                                                                let _e1642 = global_7.member[_e1107];
                                                                phi_2131_ = _e1642;
                                                            } else {
                                                                phi_2131_ = 4294967295u;
                                                            }
                                                            let _e1644 = phi_2131_;
                                                            let _e1645 = (_e1644 < arrayLength((&global_8.member)));
                                                            if _e1645 {
                                                                if _e1645 {
                                                                } else {
                                                                    phi_3907_ = true;
                                                                    break;
                                                                }
                                                                let _e1647 = global_8.member[_e1644];
                                                                phi_2145_ = _e1647;
                                                            } else {
                                                                phi_2145_ = 0i;
                                                            }
                                                            let _e1649 = phi_2145_;
                                                            let _e1650 = (_e1649 == 0i);
                                                            if _e1650 {
                                                                phi_2436_ = true;
                                                            } else {
                                                                if _e393 {
                                                                    phi_2166_ = vec3<f32>(_e1174[0][0], _e1174[0][1], _e1174[0][2]);
                                                                } else {
                                                                    if (_e369 == 1u) {
                                                                        phi_2165_ = vec3<f32>(_e1174[0][2], _e1174[0][0], _e1174[0][1]);
                                                                    } else {
                                                                        phi_2165_ = vec3<f32>(_e1174[0][1], _e1174[0][2], _e1174[0][0]);
                                                                    }
                                                                    let _e1655 = phi_2165_;
                                                                    phi_2166_ = _e1655;
                                                                }
                                                                let _e1658 = phi_2166_;
                                                                if _e393 {
                                                                    phi_2183_ = vec3<f32>(_e1174[1][0], _e1174[1][1], _e1174[1][2]);
                                                                } else {
                                                                    if (_e369 == 1u) {
                                                                        phi_2182_ = vec3<f32>(_e1174[1][2], _e1174[1][0], _e1174[1][1]);
                                                                    } else {
                                                                        phi_2182_ = vec3<f32>(_e1174[1][1], _e1174[1][2], _e1174[1][0]);
                                                                    }
                                                                    let _e1663 = phi_2182_;
                                                                    phi_2183_ = _e1663;
                                                                }
                                                                let _e1666 = phi_2183_;
                                                                if _e393 {
                                                                    phi_2200_ = vec3<f32>(_e1174[2][0], _e1174[2][1], _e1174[2][2]);
                                                                } else {
                                                                    if (_e369 == 1u) {
                                                                        phi_2199_ = vec3<f32>(_e1174[2][2], _e1174[2][0], _e1174[2][1]);
                                                                    } else {
                                                                        phi_2199_ = vec3<f32>(_e1174[2][1], _e1174[2][2], _e1174[2][0]);
                                                                    }
                                                                    let _e1671 = phi_2199_;
                                                                    phi_2200_ = _e1671;
                                                                }
                                                                let _e1674 = phi_2200_;
                                                                let _e1677 = (_e1666.x - _e1658.x);
                                                                let _e1680 = (_e1666.y - _e1658.y);
                                                                let _e1683 = (_e1666.z - _e1658.z);
                                                                let _e1685 = (_e1674.x - _e1658.x);
                                                                let _e1687 = (_e1674.y - _e1658.y);
                                                                let _e1689 = (_e1674.z - _e1658.z);
                                                                if (_e236.member_1 == 1u) {
                                                                    phi_2236_ = (vec3<f32>(_e236.member[0], _e236.member[1], _e236.member[2]) - _e1658);
                                                                } else {
                                                                    phi_2236_ = vec3<f32>(_e236.member[0], _e236.member[1], _e236.member[2]);
                                                                }
                                                                let _e1704 = phi_2236_;
                                                                let _e1710 = bitcast<f32>((bitcast<u32>((_e1677 * _e1687)) ^ _e236.member_3[0]));
                                                                let _e1714 = bitcast<f32>((bitcast<u32>((_e1680 * _e1685)) ^ _e236.member_3[0]));
                                                                let _e1718 = bitcast<f32>((bitcast<u32>((_e1680 * _e1689)) ^ _e236.member_3[0]));
                                                                let _e1722 = bitcast<f32>((bitcast<u32>((_e1683 * _e1687)) ^ _e236.member_3[0]));
                                                                let _e1726 = bitcast<f32>((bitcast<u32>((_e1683 * _e1685)) ^ _e236.member_3[0]));
                                                                let _e1730 = bitcast<f32>((bitcast<u32>((_e1677 * _e1689)) ^ _e236.member_3[0]));
                                                                let _e1731 = (_e1718 - _e1722);
                                                                let _e1732 = (_e1726 - _e1730);
                                                                let _e1733 = (_e1710 - _e1714);
                                                                let _e1757 = (bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u)));
                                                                let _e1764 = (bitcast<f32>((bitcast<u32>(_e1726) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1730) & 2147483647u)));
                                                                let _e1771 = (bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u)));
                                                                if (_e236.member_2 == 0f) {
                                                                    phi_2418_ = 0f;
                                                                } else {
                                                                    let _e1801 = bitcast<f32>((bitcast<u32>(_e1731) & 2147483647u));
                                                                    let _e1804 = bitcast<f32>((bitcast<u32>(_e1732) & 2147483647u));
                                                                    let _e1807 = bitcast<f32>((bitcast<u32>(_e1733) & 2147483647u));
                                                                    let _e1809 = select(_e1807, _e1804, (_e1804 > _e1807));
                                                                    let _e1813 = select(_e1807, _e1804, (_e1804 < _e1807));
                                                                    let _e1817 = select(_e1804, _e1801, (_e1801 < _e1804));
                                                                    let _e1819 = select(_e1804, _e1801, (_e1801 > _e1804));
                                                                    let _e1821 = select(_e1807, _e1819, (_e1819 < _e1807));
                                                                    phi_2418_ = bitcast<f32>((bitcast<u32>((_e236.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1809, _e1801, (_e1801 > _e1809)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1821, _e1817, (_e1817 > _e1821)))) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1813, _e1801, (_e1801 < _e1813)))) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1757 + _e1764) + _e1771))) ^ _e236.member_3[0]))) * 1.0000005f)) ^ _e236.member_3[0])))) ^ _e236.member_3[0]));
                                                                }
                                                                let _e1848 = phi_2418_;
                                                                phi_2436_ = (_e1650 || !(((((bitcast<f32>((bitcast<u32>((_e1704.x * _e1731)) ^ _e236.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1704.y * _e1732)) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1704.z * _e1733)) ^ _e236.member_3[0]))) * f32(-(_e1649))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1704.x) & 2147483647u)) * _e1757)) ^ _e236.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1704.y) & 2147483647u)) * _e1764)) ^ _e236.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1704.z) & 2147483647u)) * _e1771)) ^ _e236.member_3[0]))))) ^ _e236.member_3[0])) + _e1848) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1862 = phi_2436_;
                                                            phi_2437_ = _e1862;
                                                        }
                                                        let _e1864 = phi_2437_;
                                                        if _e1864 {
                                                            phi_2442_ = type_51(_e1078.member, true);
                                                        } else {
                                                            phi_2442_ = _e1078;
                                                        }
                                                        let _e1869 = phi_2442_;
                                                        phi_2443_ = _e1869;
                                                    } else {
                                                        phi_2443_ = _e1078;
                                                    }
                                                    let _e1871 = phi_2443_;
                                                    phi_1130_ = _e1871;
                                                } else {
                                                    phi_1130_ = type_51();
                                                }
                                                let _e1873 = phi_1130_;
                                                continue;
                                                continuing {
                                                    phi_1129_ = _e1873;
                                                    phi_1132_ = _e1093;
                                                    phi_3907_ = _e589;
                                                    break if !(_e1099);
                                                }
                                            }
                                            let _e1876 = phi_3907_;
                                            phi_4073_ = _e1876;
                                            if _e1876 {
                                                break;
                                            }
                                            let _e1878 = local_10;
                                            phi_4077_ = _e1876;
                                            let _e2082 = local_12;
                                            phi_3649_ = _e2082;
                                            phi_3650_ = _e630;
                                            phi_3651_ = false;
                                            phi_3652_ = select(_e634, 0u, _e1878.member_1);
                                        } else {
                                            if (_e630.member_1 >= _e97) {
                                                phi_3205_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e630.member_1 < _e97) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e646 = ((1u + _e369) % 4u);
                                                if (_e646 < 4u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e651 = global_5.member[_e630.member_1][_e646];
                                                let _e653 = (_e651 >> bitcast<u32>(11u));
                                                let _e655 = ((1u + _e368) % 4u);
                                                if (_e655 < 4u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e660 = global_5.member[_e630.member_1][_e655];
                                                let _e662 = (_e660 >> bitcast<u32>(11u));
                                                let _e664 = ((1u + _e370) % 4u);
                                                if (_e664 < 4u) {
                                                } else {
                                                    phi_4073_ = true;
                                                    break;
                                                }
                                                let _e669 = global_5.member[_e630.member_1][_e664];
                                                let _e671 = (_e669 >> bitcast<u32>(11u));
                                                let _e694 = (bitcast<f32>((bitcast<u32>((_e630.member.member_1.x - _e630.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e695 = (bitcast<f32>((bitcast<u32>((_e630.member.member_1.y - _e630.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e696 = (bitcast<f32>((bitcast<u32>((_e630.member.member_1.z - _e630.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e698 = select(_e155, _e694, (_e694 > _e155));
                                                let _e700 = select(_e155, _e695, (_e695 > _e155));
                                                let _e702 = select(_e155, _e696, (_e696 > _e155));
                                                let _e727 = bitcast<u32>((f32(bitcast<i32>((_e651 & 1023u))) * _e698));
                                                let _e732 = (bitcast<i32>((_e651 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e735 = bitcast<f32>((_e727 & bitcast<u32>(_e732)));
                                                let _e736 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e700));
                                                let _e741 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e744 = bitcast<f32>((_e736 & bitcast<u32>(_e741)));
                                                let _e745 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e702));
                                                let _e750 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e753 = bitcast<f32>((_e745 & bitcast<u32>(_e750)));
                                                let _e757 = bitcast<f32>((_e727 & bitcast<u32>(~(_e732))));
                                                let _e761 = bitcast<f32>((_e736 & bitcast<u32>(~(_e741))));
                                                let _e765 = bitcast<f32>((_e745 & bitcast<u32>(~(_e750))));
                                                let _e766 = bitcast<u32>((f32(bitcast<i32>((_e653 & 1023u))) * _e698));
                                                let _e771 = (bitcast<i32>((_e653 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e774 = bitcast<f32>((_e766 & bitcast<u32>(_e771)));
                                                let _e775 = bitcast<u32>((f32(bitcast<i32>((_e662 & 1023u))) * _e700));
                                                let _e780 = (bitcast<i32>((_e662 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e783 = bitcast<f32>((_e775 & bitcast<u32>(_e780)));
                                                let _e784 = bitcast<u32>((f32(bitcast<i32>((_e671 & 1023u))) * _e702));
                                                let _e789 = (bitcast<i32>((_e671 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e792 = bitcast<f32>((_e784 & bitcast<u32>(_e789)));
                                                let _e796 = bitcast<f32>((_e766 & bitcast<u32>(~(_e771))));
                                                let _e800 = bitcast<f32>((_e775 & bitcast<u32>(~(_e780))));
                                                let _e804 = bitcast<f32>((_e784 & bitcast<u32>(~(_e789))));
                                                let _e834 = global_5.member[_e630.member_1][0u];
                                                let _e838 = global_5.member[_e630.member_1][1u];
                                                let _e842 = global_5.member[_e630.member_1][2u];
                                                let _e846 = global_5.member[_e630.member_1][3u];
                                                let _e858 = (((_e838 >> bitcast<u32>(22i)) | ((_e842 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e846 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e859 = (_e834 & 268435455u);
                                                let _e860 = (_e858 & 268435455u);
                                                let _e863 = ((_e834 >> bitcast<u32>(28u)) & 7u);
                                                let _e871 = ((_e834 >> bitcast<u32>(31i)) | (((_e858 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e872 = (_e863 != 0u);
                                                if (_e863 == 0u) {
                                                    phi_3167_ = _e859;
                                                } else {
                                                    if (_e863 == 7u) {
                                                        phi_3166_ = 2147483648u;
                                                    } else {
                                                        phi_3166_ = ((2147483648u | (_e863 << bitcast<u32>(28u))) | (_e860 & 268435455u));
                                                    }
                                                    let _e881 = phi_3166_;
                                                    phi_3167_ = _e881;
                                                }
                                                let _e883 = phi_3167_;
                                                if _e872 {
                                                    let _e884 = (_e863 != 7u);
                                                    if _e884 {
                                                        phi_3177_ = (_e860 + _e863);
                                                    } else {
                                                        phi_3177_ = u32();
                                                    }
                                                    let _e887 = phi_3177_;
                                                    phi_3179_ = _e887;
                                                    phi_3180_ = select(true, false, _e884);
                                                } else {
                                                    phi_3179_ = u32();
                                                    phi_3180_ = true;
                                                }
                                                let _e890 = phi_3179_;
                                                let _e892 = phi_3180_;
                                                if (_e871 == 0u) {
                                                    phi_3201_ = (_e859 + select(0u, 1u, !(_e872)));
                                                } else {
                                                    if (_e871 == 7u) {
                                                        phi_3200_ = 2147483648u;
                                                    } else {
                                                        phi_3200_ = ((2147483648u | (_e871 << bitcast<u32>(28u))) | (select(_e890, _e860, _e892) & 268435455u));
                                                    }
                                                    let _e905 = phi_3200_;
                                                    phi_3201_ = _e905;
                                                }
                                                let _e907 = phi_3201_;
                                                phi_3205_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e630.member.member.x + _e735), (_e630.member.member.x + _e757), (_e630.member.member_1.x - _e774), (_e630.member.member_1.x - _e796)), vec4<f32>((_e630.member.member.y + _e744), (_e630.member.member.y + _e761), (_e630.member.member_1.y - _e783), (_e630.member.member_1.y - _e800)), vec4<f32>((_e630.member.member.z + _e753), (_e630.member.member.z + _e765), (_e630.member.member_1.z - _e792), (_e630.member.member_1.z - _e804))), type_63(type_39((_e630.member.member + vec4<f32>(_e735, _e744, _e753, 0f)), (_e630.member.member_1 - vec4<f32>(_e774, _e783, _e792, 0f))), _e883), type_63(type_39((_e630.member.member + vec4<f32>(_e757, _e761, _e765, 0f)), (_e630.member.member_1 - vec4<f32>(_e796, _e800, _e804, 0f))), _e907));
                                            }
                                            let _e912 = phi_3205_;
                                            let _e924 = ((_e912.member[0].x - _e424) * _e429);
                                            let _e925 = ((_e912.member[0].y - _e424) * _e429);
                                            let _e926 = ((_e912.member[0].z - _e425) * _e429);
                                            let _e927 = ((_e912.member[0].w - _e425) * _e429);
                                            let _e937 = ((_e912.member[1].x - _e460) * _e465);
                                            let _e938 = ((_e912.member[1].y - _e460) * _e465);
                                            let _e939 = ((_e912.member[1].z - _e461) * _e465);
                                            let _e940 = ((_e912.member[1].w - _e461) * _e465);
                                            let _e950 = ((_e912.member[2].x - _e496) * _e501);
                                            let _e951 = ((_e912.member[2].y - _e496) * _e501);
                                            let _e952 = ((_e912.member[2].z - _e497) * _e501);
                                            let _e953 = ((_e912.member[2].w - _e497) * _e501);
                                            let _e955 = select(_e952, _e950, (_e950 < _e952));
                                            let _e957 = select(_e953, _e951, (_e951 < _e953));
                                            let _e959 = select(_e952, _e950, (_e950 > _e952));
                                            let _e961 = select(_e953, _e951, (_e951 > _e953));
                                            let _e963 = select(_e926, _e924, (_e924 < _e926));
                                            let _e965 = select(_e927, _e925, (_e925 < _e927));
                                            let _e967 = select(_e939, _e937, (_e937 < _e939));
                                            let _e969 = select(_e940, _e938, (_e938 < _e940));
                                            let _e971 = select(_e967, _e963, (_e963 > _e967));
                                            let _e973 = select(_e969, _e965, (_e965 > _e969));
                                            let _e975 = select(_e955, _e971, (_e971 > _e955));
                                            let _e977 = select(_e957, _e973, (_e973 > _e957));
                                            let _e979 = select(_e926, _e924, (_e924 > _e926));
                                            let _e981 = select(_e927, _e925, (_e925 > _e927));
                                            let _e983 = select(_e939, _e937, (_e937 > _e939));
                                            let _e985 = select(_e940, _e938, (_e938 > _e940));
                                            let _e987 = select(_e983, _e979, (_e979 < _e983));
                                            let _e989 = select(_e985, _e981, (_e981 < _e985));
                                            let _e994 = -(_e955);
                                            let _e995 = -(_e957);
                                            let _e1002 = (select(_e959, _e987, (_e987 < _e959)) + (select(_e994, _e959, (_e959 > _e994)) * 0.0000019073523f));
                                            let _e1003 = (select(_e961, _e989, (_e989 < _e961)) + (select(_e995, _e961, (_e961 > _e995)) * 0.0000019073523f));
                                            let _e1005 = select(_e547, _e975, (_e975 > _e547));
                                            let _e1007 = select(_e547, _e977, (_e977 > _e547));
                                            let _e1012 = (_e1005 <= select(_e591.member, _e1002, (_e1002 < _e591.member)));
                                            let _e1013 = (_e1007 <= select(_e591.member, _e1003, (_e1003 < _e591.member)));
                                            let _e1014 = (_e1005 <= _e1007);
                                            if _e1012 {
                                                if _e1013 {
                                                    if _e1014 {
                                                        phi_3549_ = _e912.member_2;
                                                    } else {
                                                        phi_3549_ = _e912.member_1;
                                                    }
                                                    let _e1018 = phi_3549_;
                                                    let _e1040 = (_e634 % 128u);
                                                    let _e1041 = (_e1040 < 128u);
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1040] = _e1018.member_1;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1040] = _e1018.member.member.x;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1040] = _e1018.member.member.y;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1040] = _e1018.member.member.z;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1040] = _e1018.member.member_1.x;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1040] = _e1018.member.member_1.y;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1040] = _e1018.member.member_1.z;
                                                    if _e1041 {
                                                    } else {
                                                        phi_4073_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1040] = select(_e1007, _e1005, (_e1005 > _e1007));
                                                    if _e1014 {
                                                        phi_3626_ = _e912.member_1;
                                                    } else {
                                                        phi_3626_ = _e912.member_2;
                                                    }
                                                    let _e1054 = phi_3626_;
                                                    phi_3627_ = _e1054;
                                                    phi_3628_ = (_e634 + 1u);
                                                } else {
                                                    phi_3627_ = type_63();
                                                    phi_3628_ = u32();
                                                }
                                                let _e1056 = phi_3627_;
                                                let _e1058 = phi_3628_;
                                                phi_3630_ = _e1056;
                                                phi_3631_ = _e1058;
                                                phi_3632_ = select(true, false, _e1013);
                                            } else {
                                                phi_3630_ = type_63();
                                                phi_3631_ = u32();
                                                phi_3632_ = true;
                                            }
                                            let _e1061 = phi_3630_;
                                            let _e1063 = phi_3631_;
                                            let _e1065 = phi_3632_;
                                            if _e1065 {
                                                if _e1012 {
                                                    phi_3641_ = _e912.member_1;
                                                } else {
                                                    phi_3641_ = _e912.member_2;
                                                }
                                                let _e1069 = phi_3641_;
                                                phi_3646_ = _e1069;
                                                phi_3647_ = select(_e1013, true, _e1012);
                                            } else {
                                                phi_3646_ = _e1061;
                                                phi_3647_ = _e632;
                                            }
                                            let _e1072 = phi_3646_;
                                            let _e1074 = phi_3647_;
                                            phi_4077_ = _e589;
                                            phi_3649_ = _e591;
                                            phi_3650_ = _e1072;
                                            phi_3651_ = _e1074;
                                            phi_3652_ = select(_e1063, _e634, _e1065);
                                        }
                                        let _e1882 = phi_4077_;
                                        let _e1884 = phi_3649_;
                                        let _e1886 = phi_3650_;
                                        let _e1888 = phi_3651_;
                                        let _e1890 = phi_3652_;
                                        phi_4076_ = _e1882;
                                        phi_3653_ = _e1884;
                                        phi_3654_ = _e1886;
                                        phi_3655_ = (_e595 - 1u);
                                        phi_3656_ = _e1888;
                                        phi_3657_ = _e1890;
                                    } else {
                                        phi_4076_ = _e589;
                                        phi_3653_ = _e591;
                                        phi_3654_ = _e630;
                                        phi_3655_ = _e595;
                                        phi_3656_ = _e632;
                                        phi_3657_ = _e634;
                                    }
                                    let _e1892 = phi_4076_;
                                    let _e1894 = phi_3653_;
                                    let _e1896 = phi_3654_;
                                    let _e1898 = phi_3655_;
                                    let _e1900 = phi_3656_;
                                    let _e1902 = phi_3657_;
                                    phi_4075_ = _e1892;
                                    phi_3658_ = _e1894;
                                    phi_3659_ = _e1896;
                                    phi_3660_ = _e1898;
                                    phi_3661_ = _e1900;
                                    phi_3662_ = _e1902;
                                } else {
                                    phi_4075_ = _e589;
                                    phi_3658_ = type_51();
                                    phi_3659_ = type_63();
                                    phi_3660_ = u32();
                                    phi_3661_ = bool();
                                    phi_3662_ = u32();
                                }
                                let _e1904 = phi_4075_;
                                let _e1906 = phi_3658_;
                                let _e1908 = phi_3659_;
                                let _e1910 = phi_3660_;
                                let _e1912 = phi_3661_;
                                let _e1914 = phi_3662_;
                                phi_4074_ = _e1904;
                                phi_1004_ = _e1906;
                                phi_1007_ = _e1908;
                                phi_1009_ = _e1910;
                                phi_1011_ = _e1912;
                                phi_1013_ = _e1914;
                                phi_3663_ = _e603;
                            } else {
                                phi_4074_ = _e589;
                                phi_1004_ = type_51();
                                phi_1007_ = type_63();
                                phi_1009_ = u32();
                                phi_1011_ = bool();
                                phi_1013_ = u32();
                                phi_3663_ = false;
                            }
                            let _e1916 = phi_4074_;
                            let _e1918 = phi_1004_;
                            let _e1920 = phi_1007_;
                            let _e1922 = phi_1009_;
                            let _e1924 = phi_1011_;
                            let _e1926 = phi_1013_;
                            let _e1928 = phi_3663_;
                            continue;
                            continuing {
                                phi_3913_ = _e1916;
                                phi_1003_ = _e1918;
                                phi_1006_ = _e1920;
                                phi_1008_ = _e1922;
                                phi_1010_ = _e1924;
                                phi_1012_ = _e1926;
                                phi_4073_ = _e1916;
                                break if !(_e1928);
                            }
                        }
                        let _e1931 = phi_4073_;
                        if _e1931 {
                            break;
                        }
                        let _e1933 = local_11;
                        if _e1933.member_1 {
                        } else {
                            if _e237 {
                            } else {
                                break;
                            }
                            let _e1937 = global_2.member[_e143];
                            if _e158 {
                            } else {
                                break;
                            }
                            let _e1941 = global_10.member[_e143].member_1;
                            if _e237 {
                            } else {
                                break;
                            }
                            global_2.member[_e143] = type_32(_e1937.member, _e1937.member_1, _e1937.member_2, array<f32, 3>((_e1937.member_3[0] + (_e1941[0] * _e1937.member_1[0])), (_e1937.member_3[1] + (_e1941[1] * _e1937.member_1[1])), (_e1937.member_3[2] + (_e1941[2] * _e1937.member_1[2]))), _e1937.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
