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
    var phi_328_: u32;
    var phi_372_: i32;
    var phi_396_: type_41;
    var phi_546_: i32;
    var phi_547_: i32;
    var phi_557_: bool;
    var phi_567_: u32;
    var phi_568_: u32;
    var phi_570_: bool;
    var phi_575_: u32;
    var phi_607_: i32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_671_: f32;
    var phi_682_: f32;
    var phi_691_: f32;
    var phi_697_: f32;
    var phi_708_: f32;
    var phi_714_: f32;
    var phi_737_: f32;
    var phi_748_: f32;
    var phi_757_: f32;
    var phi_763_: f32;
    var phi_774_: f32;
    var phi_780_: f32;
    var phi_803_: f32;
    var phi_814_: f32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_3911_: bool;
    var phi_1004_: type_47;
    var phi_1007_: type_63;
    var phi_1009_: u32;
    var phi_1011_: bool;
    var phi_1013_: u32;
    var phi_1024_: bool;
    var phi_1110_: type_63;
    var phi_1111_: bool;
    var phi_1112_: u32;
    var phi_3164_: u32;
    var phi_3165_: u32;
    var phi_3175_: u32;
    var phi_3177_: u32;
    var phi_3178_: bool;
    var phi_3198_: u32;
    var phi_3199_: u32;
    var phi_3203_: type_64;
    var phi_3547_: type_63;
    var phi_3624_: type_63;
    var phi_3625_: type_63;
    var phi_3626_: u32;
    var phi_3628_: type_63;
    var phi_3629_: u32;
    var phi_3630_: bool;
    var phi_3639_: type_63;
    var phi_3644_: type_63;
    var phi_3645_: bool;
    var phi_1130_: type_47;
    var phi_1133_: type_8;
    var phi_1134_: type_8;
    var phi_1156_: type_8;
    var phi_1177_: u32;
    var phi_1266_: array<array<f32, 3>, 3>;
    var phi_1383_: bool;
    var phi_1412_: bool;
    var phi_1813_: f32;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1816_: f32;
    var phi_1817_: vec3<f32>;
    var phi_1818_: vec3<f32>;
    var phi_1819_: vec3<f32>;
    var phi_1820_: vec3<f32>;
    var phi_1851_: bool;
    var phi_1860_: vec3<f32>;
    var phi_2025_: f32;
    var phi_2027_: f32;
    var phi_2028_: bool;
    var phi_2048_: f32;
    var phi_2049_: f32;
    var phi_2072_: type_26;
    var phi_2074_: type_26;
    var phi_2075_: bool;
    var phi_2079_: type_26;
    var phi_2080_: type_26;
    var phi_2081_: type_26;
    var phi_2082_: bool;
    var phi_2086_: type_26;
    var phi_2087_: bool;
    var phi_2088_: type_26;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2091_: type_26;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2101_: type_26;
    var phi_2102_: bool;
    var phi_2106_: type_26;
    var phi_2129_: u32;
    var phi_2143_: i32;
    var phi_2163_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2180_: vec3<f32>;
    var phi_2181_: vec3<f32>;
    var phi_2197_: vec3<f32>;
    var phi_2198_: vec3<f32>;
    var phi_2234_: vec3<f32>;
    var phi_2416_: f32;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2440_: type_47;
    var phi_2441_: type_47;
    var phi_1131_: type_47;
    var phi_3905_: bool;
    var local_10: type_47;
    var phi_4075_: bool;
    var phi_3647_: type_47;
    var phi_3648_: type_63;
    var phi_3649_: bool;
    var phi_3650_: u32;
    var phi_4074_: bool;
    var phi_3651_: type_47;
    var phi_3652_: type_63;
    var phi_3653_: u32;
    var phi_3654_: bool;
    var phi_3655_: u32;
    var phi_4073_: bool;
    var phi_3656_: type_47;
    var phi_3657_: type_63;
    var phi_3658_: u32;
    var phi_3659_: bool;
    var phi_3660_: u32;
    var phi_4072_: bool;
    var phi_1005_: type_47;
    var phi_1008_: type_63;
    var phi_1010_: u32;
    var phi_1012_: bool;
    var phi_1014_: u32;
    var phi_3661_: bool;
    var phi_4071_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e98 = arrayLength((&global_5.member));
            let _e110 = arrayLength((&global_8.member));
            let _e114 = global_4.member[0u][0u];
            let _e118 = global_4.member[0u][1u];
            let _e122 = global_4.member[0u][2u];
            let _e126 = global_4.member[0u][3u];
            let _e130 = global_4.member[1u][0u];
            let _e134 = global_4.member[1u][1u];
            let _e138 = global_4.member[1u][2u];
            let _e142 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e126) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            local = array<i32, 3>(bitcast<i32>(_e130), bitcast<i32>(_e134), bitcast<i32>(_e138));
            let _e157 = (_e142 < arrayLength((&global_10.member)));
            if _e157 {
                if _e157 {
                } else {
                    break;
                }
                let _e161 = global_10.member[_e142].member_2;
                phi_328_ = _e161;
            } else {
                phi_328_ = 4294967295u;
            }
            let _e163 = phi_328_;
            let _e166 = global_1.member[0u];
            let _e170 = global_3.member[0u][0u];
            let _e174 = global_3.member[0u][1u];
            let _e178 = global_3.member[0u][2u];
            let _e182 = global_3.member[0u][3u];
            let _e186 = global_3.member[1u][0u];
            let _e190 = global_3.member[1u][1u];
            let _e194 = global_3.member[1u][2u];
            let _e198 = global_3.member[1u][3u];
            let _e199 = bitcast<f32>(_e170);
            let _e200 = bitcast<f32>(_e174);
            let _e201 = bitcast<f32>(_e178);
            let _e203 = bitcast<f32>(_e186);
            let _e204 = array<u32, 3>(_e190, _e194, _e198);
            let _e206 = bitcast<i32>(_e166);
            if (_e206 < -126i) {
                phi_372_ = -126i;
            } else {
                phi_372_ = select(_e206, 127i, (_e206 > 127i));
            }
            let _e211 = phi_372_;
            let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
            let _e222 = bitcast<f32>((bitcast<u32>(((_e206 - _e211) + 127i)) << bitcast<u32>(23i)));
            if (_e182 == 0u) {
                phi_396_ = type_41(array<f32, 3>(_e199, _e200, _e201), _e182, _e203, _e204);
            } else {
                phi_396_ = type_41(array<f32, 3>(((_e199 * _e216) * _e222), ((_e200 * _e216) * _e222), ((_e201 * _e216) * _e222)), _e182, ((_e203 * _e216) * _e222), _e204);
            }
            let _e235 = phi_396_;
            if _e157 {
                let _e236 = (_e142 < arrayLength((&global_2.member)));
                if _e236 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e241 = global_10.member[_e142].member.member_1;
                    let _e246 = global_10.member[_e142].member.member_3;
                    if (_e241 <= _e246) {
                        let _e248 = (1u < _e110);
                        if _e248 {
                            if (0u < _e110) {
                            } else {
                                break;
                            }
                            let _e252 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e252 + 1u) < _e252) {
                                if _e248 {
                                } else {
                                    break;
                                }
                                let _e257 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e157 {
                        } else {
                            break;
                        }
                        let _e267 = global_10.member[_e142].member.member_2[0u];
                        let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                        let _e275 = global_10.member[_e142].member.member_2[1u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_10.member[_e142].member.member_2[2u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_10.member[_e142].member.member[0u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e299 = global_10.member[_e142].member.member[1u];
                        let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                        let _e307 = global_10.member[_e142].member.member[2u];
                        let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                        let _e311 = select(_e277, _e269, (_e277 < _e269));
                        let _e313 = select(_e285, _e311, (_e285 < _e311));
                        let _e315 = select(_e293, _e313, (_e293 < _e313));
                        let _e317 = select(_e301, _e315, (_e301 < _e315));
                        let _e319 = select(_e309, _e317, (_e309 < _e317));
                        let _e321 = (bitcast<u32>(_e241) & 2147483647u);
                        let _e330 = (((select(_e321, _e319, (_e321 < _e319)) < 2139095040u) && ((bitcast<u32>(_e246) & 2147483647u) <= 2139095040u)) && (_e313 > 0u));
                        if _e330 {
                            let _e333 = (bitcast<u32>(bitcast<f32>(_e313)) & 2147483647u);
                            if (_e333 >= 8388608u) {
                                phi_546_ = (bitcast<i32>((_e333 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_546_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e333)), 32u, (_e333 == 0u))));
                            }
                            let _e347 = phi_546_;
                            phi_547_ = _e347;
                        } else {
                            phi_547_ = 0i;
                        }
                        let _e349 = phi_547_;
                        let _e350 = (_e269 == _e313);
                        if _e350 {
                            phi_557_ = true;
                        } else {
                            phi_557_ = (_e277 == _e313);
                        }
                        let _e353 = phi_557_;
                        let _e354 = select(1u, 0u, _e350);
                        if _e353 {
                            let _e355 = (_e354 + 1u);
                            phi_567_ = _e355;
                            phi_568_ = _e355;
                            phi_570_ = select(true, false, (_e355 == 2u));
                        } else {
                            phi_567_ = u32();
                            phi_568_ = 0u;
                            phi_570_ = true;
                        }
                        let _e359 = phi_567_;
                        let _e361 = phi_568_;
                        let _e363 = phi_570_;
                        if _e363 {
                            phi_575_ = (_e361 + 1u);
                        } else {
                            phi_575_ = 0u;
                        }
                        let _e367 = phi_575_;
                        let _e368 = select(_e359, _e361, _e363);
                        let _e369 = select(_e354, select(2u, _e354, _e353), _e363);
                        let _e370 = -(_e349);
                        if (_e370 < -126i) {
                            phi_607_ = -126i;
                        } else {
                            phi_607_ = select(_e370, 127i, (_e370 > 127i));
                        }
                        let _e375 = phi_607_;
                        let _e380 = bitcast<f32>((bitcast<u32>((_e375 + 127i)) << bitcast<u32>(23i)));
                        let _e386 = bitcast<f32>((bitcast<u32>(((_e370 - _e375) + 127i)) << bitcast<u32>(23i)));
                        let _e391 = global_10.member[_e142].member.member;
                        let _e392 = (_e368 == 0u);
                        if _e392 {
                            phi_625_ = _e391[0];
                        } else {
                            phi_625_ = _e391[1];
                        }
                        let _e396 = phi_625_;
                        let _e397 = (_e368 == 2u);
                        if _e397 {
                            phi_631_ = _e391[2];
                        } else {
                            phi_631_ = _e396;
                        }
                        let _e400 = phi_631_;
                        let _e401 = global_10.member[_e142].member.member_2;
                        if _e392 {
                            phi_642_ = _e401[0];
                        } else {
                            phi_642_ = _e401[1];
                        }
                        let _e405 = phi_642_;
                        if _e397 {
                            phi_648_ = _e401[2];
                        } else {
                            phi_648_ = _e405;
                        }
                        let _e408 = phi_648_;
                        let _e410 = ((_e408 * _e380) * _e386);
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e414 {
                            let _e418 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) * 0.00000011920929f);
                            phi_671_ = select(0.00000000000011368684f, _e418, (_e418 > 0.00000000000011368684f));
                        } else {
                            phi_671_ = 0f;
                        }
                        let _e422 = phi_671_;
                        let _e423 = (_e400 + _e422);
                        let _e424 = (_e400 - _e422);
                        let _e425 = select(_e410, 0f, _e414);
                        if _e414 {
                            phi_682_ = 38685626000000000000000000f;
                        } else {
                            phi_682_ = (1f / _e410);
                        }
                        let _e428 = phi_682_;
                        let _e429 = (_e367 == 0u);
                        if _e429 {
                            phi_691_ = _e391[0];
                        } else {
                            phi_691_ = _e391[1];
                        }
                        let _e433 = phi_691_;
                        let _e434 = (_e367 == 2u);
                        if _e434 {
                            phi_697_ = _e391[2];
                        } else {
                            phi_697_ = _e433;
                        }
                        let _e437 = phi_697_;
                        if _e429 {
                            phi_708_ = _e401[0];
                        } else {
                            phi_708_ = _e401[1];
                        }
                        let _e441 = phi_708_;
                        if _e434 {
                            phi_714_ = _e401[2];
                        } else {
                            phi_714_ = _e441;
                        }
                        let _e444 = phi_714_;
                        let _e446 = ((_e444 * _e380) * _e386);
                        let _e450 = (bitcast<f32>((bitcast<u32>(_e446) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e450 {
                            let _e454 = (bitcast<f32>((bitcast<u32>(_e437) & 2147483647u)) * 0.00000011920929f);
                            phi_737_ = select(0.00000000000011368684f, _e454, (_e454 > 0.00000000000011368684f));
                        } else {
                            phi_737_ = 0f;
                        }
                        let _e458 = phi_737_;
                        let _e459 = (_e437 + _e458);
                        let _e460 = (_e437 - _e458);
                        let _e461 = select(_e446, 0f, _e450);
                        if _e450 {
                            phi_748_ = 38685626000000000000000000f;
                        } else {
                            phi_748_ = (1f / _e446);
                        }
                        let _e464 = phi_748_;
                        let _e465 = (_e369 == 0u);
                        if _e465 {
                            phi_757_ = _e391[0];
                        } else {
                            phi_757_ = _e391[1];
                        }
                        let _e469 = phi_757_;
                        let _e470 = (_e369 == 2u);
                        if _e470 {
                            phi_763_ = _e391[2];
                        } else {
                            phi_763_ = _e469;
                        }
                        let _e473 = phi_763_;
                        if _e465 {
                            phi_774_ = _e401[0];
                        } else {
                            phi_774_ = _e401[1];
                        }
                        let _e477 = phi_774_;
                        if _e470 {
                            phi_780_ = _e401[2];
                        } else {
                            phi_780_ = _e477;
                        }
                        let _e480 = phi_780_;
                        let _e482 = ((_e480 * _e380) * _e386);
                        let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e486 {
                            let _e490 = (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) * 0.00000011920929f);
                            phi_803_ = select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f));
                        } else {
                            phi_803_ = 0f;
                        }
                        let _e494 = phi_803_;
                        let _e495 = (_e473 + _e494);
                        let _e496 = (_e473 - _e494);
                        let _e497 = select(_e482, 0f, _e486);
                        if _e486 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e482);
                        }
                        let _e500 = phi_814_;
                        let _e503 = bitcast<f32>((bitcast<u32>(_e400) & 2147483647u));
                        let _e506 = bitcast<f32>((bitcast<u32>(_e437) & 2147483647u));
                        let _e508 = select(_e506, _e503, (_e503 > _e506));
                        let _e511 = bitcast<f32>((bitcast<u32>(_e473) & 2147483647u));
                        if (_e330 && (select(_e511, _e508, (_e508 > _e511)) <= 1099511600000f)) {
                            let _e516 = (_e349 / 3i);
                            let _e523 = bitcast<f32>((bitcast<u32>((_e516 + 127i)) << bitcast<u32>(23i)));
                            let _e530 = bitcast<f32>((bitcast<u32>(((_e349 - (2i * _e516)) + 127i)) << bitcast<u32>(23i)));
                            let _e531 = (((_e241 * _e523) * _e523) * _e530);
                            let _e533 = select(340282350000000000000000000000000000000f, _e531, (_e531 < 340282350000000000000000000000000000000f));
                            let _e538 = (((_e246 * _e523) * _e523) * _e530);
                            let _e540 = select(340282350000000000000000000000000000000f, _e538, (_e538 < 340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e540, (_e540 > -340282350000000000000000000000000000000f));
                            phi_915_ = select(-340282350000000000000000000000000000000f, _e533, (_e533 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_914_ = 0f;
                            phi_915_ = 1f;
                        }
                        let _e544 = phi_914_;
                        let _e546 = phi_915_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e550 = (_e368 % 3u);
                        let _e551 = (_e550 < 3u);
                        if _e551 {
                        } else {
                            break;
                        }
                        let _e553 = local_1[_e550];
                        let _e556 = (_e367 % 3u);
                        let _e557 = (_e556 < 3u);
                        if _e557 {
                        } else {
                            break;
                        }
                        let _e559 = local_1[_e556];
                        let _e562 = (_e369 % 3u);
                        let _e563 = (_e562 < 3u);
                        if _e563 {
                        } else {
                            break;
                        }
                        let _e565 = local_1[_e562];
                        if _e551 {
                        } else {
                            break;
                        }
                        let _e570 = local[_e550];
                        if _e557 {
                        } else {
                            break;
                        }
                        let _e574 = local[_e556];
                        if _e563 {
                        } else {
                            break;
                        }
                        let _e578 = local[_e562];
                        phi_3911_ = false;
                        phi_1004_ = type_47(_e544, false);
                        phi_1007_ = type_63(type_35(vec4<f32>((f32(_e553) * _e154), (f32(_e559) * _e154), (f32(_e565) * _e154), 0f), vec4<f32>((f32(_e570) * _e154), (f32(_e574) * _e154), (f32(_e578) * _e154), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                        phi_1009_ = ((3u * _e96) + 1u);
                        phi_1011_ = (_e546 <= _e544);
                        phi_1013_ = 0u;
                        loop {
                            let _e588 = phi_3911_;
                            let _e590 = phi_1004_;
                            let _e592 = phi_1007_;
                            let _e594 = phi_1009_;
                            let _e596 = phi_1011_;
                            let _e598 = phi_1013_;
                            local_11 = _e590;
                            if _e596 {
                                phi_1024_ = true;
                            } else {
                                phi_1024_ = (_e598 > 0u);
                            }
                            let _e601 = phi_1024_;
                            if _e601 {
                                let _e602 = (_e594 > 0u);
                                if _e602 {
                                    if _e596 {
                                        phi_1110_ = _e592;
                                        phi_1111_ = _e596;
                                        phi_1112_ = _e598;
                                    } else {
                                        let _e603 = (_e598 - 1u);
                                        let _e604 = (_e603 % 128u);
                                        let _e605 = (_e604 < 128u);
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e607 = local_7[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e609 = local_6[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e611 = local_5[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e613 = local_4[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e615 = local_3[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e617 = local_2[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e622 = local_8[_e604];
                                        if _e605 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e625 = local_9[_e604];
                                        phi_1110_ = type_63(type_35(vec4<f32>(_e607, _e609, _e611, 0f), vec4<f32>(_e613, _e615, _e617, 0f)), _e622);
                                        phi_1111_ = (_e625 <= _e590.member);
                                        phi_1112_ = _e603;
                                    }
                                    let _e629 = phi_1110_;
                                    let _e631 = phi_1111_;
                                    let _e633 = phi_1112_;
                                    if _e631 {
                                        if ((_e629.member_1 & 2147483648u) != 0u) {
                                            phi_1130_ = _e590;
                                            phi_1133_ = type_8(0u, ((_e629.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1095 = phi_1130_;
                                                let _e1097 = phi_1133_;
                                                local_10 = _e1095;
                                                local_12 = _e1095;
                                                if (_e1097.member < _e1097.member_1) {
                                                    phi_1134_ = type_8((_e1097.member + 1u), _e1097.member_1);
                                                    phi_1156_ = type_8(1u, _e1097.member);
                                                } else {
                                                    phi_1134_ = _e1097;
                                                    phi_1156_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1110 = phi_1134_;
                                                let _e1112 = phi_1156_;
                                                let _e1116 = (bitcast<i32>(_e1112.member) != 0i);
                                                if _e1116 {
                                                    let _e1117 = ((_e629.member_1 & 268435455u) + _e1112.member_1);
                                                    let _e1118 = (_e1117 < _e98);
                                                    if _e1118 {
                                                        if _e1118 {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1122 = global_5.member[_e1117].member_1;
                                                        phi_1177_ = _e1122;
                                                    } else {
                                                        phi_1177_ = 4294967295u;
                                                    }
                                                    let _e1124 = phi_1177_;
                                                    if (_e1117 >= _e98) {
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1118 {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        if (_e550 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1131 = global_5.member[_e1117].member[_e550];
                                                        if (_e556 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1137 = global_5.member[_e1117].member[_e556];
                                                        if (_e562 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1143 = global_5.member[_e1117].member[_e562];
                                                        let _e1145 = (3u + _e550);
                                                        if (_e1145 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1151 = global_5.member[_e1117].member[_e1145];
                                                        let _e1152 = (3u + _e556);
                                                        if (_e1152 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1158 = global_5.member[_e1117].member[_e1152];
                                                        let _e1159 = (3u + _e562);
                                                        if (_e1159 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1165 = global_5.member[_e1117].member[_e1159];
                                                        let _e1167 = (6u + _e550);
                                                        if (_e1167 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1173 = global_5.member[_e1117].member[_e1167];
                                                        let _e1174 = (6u + _e556);
                                                        if (_e1174 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1180 = global_5.member[_e1117].member[_e1174];
                                                        let _e1181 = (6u + _e562);
                                                        if (_e1181 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1187 = global_5.member[_e1117].member[_e1181];
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1131, _e1137, _e1143), array<f32, 3>(_e1151, _e1158, _e1165), array<f32, 3>(_e1173, _e1180, _e1187));
                                                    }
                                                    let _e1191 = phi_1266_;
                                                    let _e1199 = (_e1191[0][2] - _e473);
                                                    let _e1202 = (((_e1191[0][0] - _e400) * _e497) - (_e1199 * _e425));
                                                    let _e1205 = (((_e1191[0][1] - _e437) * _e497) - (_e1199 * _e461));
                                                    let _e1212 = (_e1191[1][2] - _e473);
                                                    let _e1215 = (((_e1191[1][0] - _e400) * _e497) - (_e1212 * _e425));
                                                    let _e1218 = (((_e1191[1][1] - _e437) * _e497) - (_e1212 * _e461));
                                                    let _e1225 = (_e1191[2][2] - _e473);
                                                    let _e1228 = (((_e1191[2][0] - _e400) * _e497) - (_e1225 * _e425));
                                                    let _e1231 = (((_e1191[2][1] - _e437) * _e497) - (_e1225 * _e461));
                                                    let _e1232 = (_e1228 * _e1218);
                                                    let _e1233 = (_e1231 * _e1215);
                                                    let _e1234 = (_e1202 * _e1231);
                                                    let _e1235 = (_e1205 * _e1228);
                                                    let _e1236 = (_e1215 * _e1205);
                                                    let _e1237 = (_e1218 * _e1202);
                                                    let _e1242 = (((_e1232 >= _e1233) && (_e1234 >= _e1235)) && (_e1236 >= _e1237));
                                                    if (_e1242 || (((_e1232 <= _e1233) && (_e1234 <= _e1235)) && (_e1236 <= _e1237))) {
                                                        let _e1249 = select(-1f, 1f, _e1242);
                                                        let _e1251 = ((_e1232 - _e1233) * _e1249);
                                                        let _e1253 = select(0f, _e1251, (_e1251 > 0f));
                                                        let _e1255 = ((_e1234 - _e1235) * _e1249);
                                                        let _e1257 = select(0f, _e1255, (_e1255 > 0f));
                                                        let _e1259 = ((_e1236 - _e1237) * _e1249);
                                                        let _e1261 = select(0f, _e1259, (_e1259 > 0f));
                                                        let _e1263 = ((_e1253 + _e1257) + _e1261);
                                                        if (_e1263 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2091_ = type_26();
                                                            phi_2092_ = true;
                                                            phi_2093_ = false;
                                                        } else {
                                                            let _e1266 = select(_e1215, _e1202, (_e1202 < _e1215));
                                                            if (select(_e1228, _e1266, (_e1266 < _e1228)) > 0f) {
                                                                phi_1383_ = true;
                                                            } else {
                                                                let _e1271 = select(_e1215, _e1202, (_e1202 > _e1215));
                                                                phi_1383_ = (select(_e1228, _e1271, (_e1271 > _e1228)) < 0f);
                                                            }
                                                            let _e1276 = phi_1383_;
                                                            if _e1276 {
                                                                phi_2088_ = type_26();
                                                                phi_2089_ = true;
                                                                phi_2090_ = false;
                                                            } else {
                                                                let _e1278 = select(_e1218, _e1205, (_e1205 < _e1218));
                                                                if (select(_e1231, _e1278, (_e1278 < _e1231)) > 0f) {
                                                                    phi_1412_ = true;
                                                                } else {
                                                                    let _e1283 = select(_e1218, _e1205, (_e1205 > _e1218));
                                                                    phi_1412_ = (select(_e1231, _e1283, (_e1283 > _e1231)) < 0f);
                                                                }
                                                                let _e1288 = phi_1412_;
                                                                if _e1288 {
                                                                    phi_2086_ = type_26();
                                                                    phi_2087_ = false;
                                                                } else {
                                                                    let _e1290 = select(_e1191[1][0], _e1191[0][0], (_e1191[0][0] < _e1191[1][0]));
                                                                    let _e1294 = select(_e1191[1][0], _e1191[0][0], (_e1191[0][0] > _e1191[1][0]));
                                                                    let _e1298 = select(_e1191[1][1], _e1191[0][1], (_e1191[0][1] < _e1191[1][1]));
                                                                    let _e1302 = select(_e1191[1][1], _e1191[0][1], (_e1191[0][1] > _e1191[1][1]));
                                                                    let _e1306 = select(_e1191[1][2], _e1191[0][2], (_e1191[0][2] < _e1191[1][2]));
                                                                    let _e1310 = select(_e1191[1][2], _e1191[0][2], (_e1191[0][2] > _e1191[1][2]));
                                                                    let _e1315 = ((select(_e1191[2][0], _e1290, (_e1290 < _e1191[2][0])) - _e423) * _e428);
                                                                    let _e1316 = ((select(_e1191[2][0], _e1294, (_e1294 > _e1191[2][0])) - _e424) * _e428);
                                                                    let _e1319 = ((select(_e1191[2][1], _e1298, (_e1298 < _e1191[2][1])) - _e459) * _e464);
                                                                    let _e1320 = ((select(_e1191[2][1], _e1302, (_e1302 > _e1191[2][1])) - _e460) * _e464);
                                                                    let _e1323 = ((select(_e1191[2][2], _e1306, (_e1306 < _e1191[2][2])) - _e495) * _e500);
                                                                    let _e1324 = ((select(_e1191[2][2], _e1310, (_e1310 > _e1191[2][2])) - _e496) * _e500);
                                                                    let _e1326 = select(_e1324, _e1323, (_e1323 < _e1324));
                                                                    let _e1328 = select(_e1324, _e1323, (_e1323 > _e1324));
                                                                    let _e1330 = select(_e1316, _e1315, (_e1315 < _e1316));
                                                                    let _e1332 = select(_e1320, _e1319, (_e1319 < _e1320));
                                                                    let _e1334 = select(_e1332, _e1330, (_e1330 > _e1332));
                                                                    let _e1336 = select(_e1326, _e1334, (_e1334 > _e1326));
                                                                    let _e1338 = select(_e1316, _e1315, (_e1315 > _e1316));
                                                                    let _e1340 = select(_e1320, _e1319, (_e1319 > _e1320));
                                                                    let _e1342 = select(_e1340, _e1338, (_e1338 < _e1340));
                                                                    let _e1344 = select(_e1328, _e1342, (_e1342 < _e1328));
                                                                    let _e1345 = -(_e1326);
                                                                    let _e1351 = select(_e546, _e1336, (_e1336 > _e546));
                                                                    if (_e1351 > (_e1344 + (select(_e1345, _e1328, (_e1328 > _e1345)) * 0.0000019073523f))) {
                                                                        phi_2081_ = type_26();
                                                                        phi_2082_ = true;
                                                                    } else {
                                                                        let _e1353 = (_e1351 > _e1095.member);
                                                                        if _e1353 {
                                                                            phi_2080_ = type_26();
                                                                        } else {
                                                                            let _e1354 = vec3<f32>(_e1191[0][0], _e1191[0][1], _e1191[0][2]);
                                                                            let _e1355 = vec3<f32>(_e1191[1][0], _e1191[1][1], _e1191[1][2]);
                                                                            let _e1356 = vec3<f32>(_e1191[2][0], _e1191[2][1], _e1191[2][2]);
                                                                            let _e1357 = (_e1191[1][0] - _e1191[0][0]);
                                                                            let _e1358 = (_e1191[1][1] - _e1191[0][1]);
                                                                            let _e1359 = (_e1191[1][2] - _e1191[0][2]);
                                                                            let _e1360 = vec3<f32>(_e1357, _e1358, _e1359);
                                                                            let _e1361 = (_e1191[2][0] - _e1191[1][0]);
                                                                            let _e1362 = (_e1191[2][1] - _e1191[1][1]);
                                                                            let _e1363 = (_e1191[2][2] - _e1191[1][2]);
                                                                            let _e1364 = vec3<f32>(_e1361, _e1362, _e1363);
                                                                            let _e1365 = (_e1191[0][0] - _e1191[2][0]);
                                                                            let _e1366 = (_e1191[0][1] - _e1191[2][1]);
                                                                            let _e1367 = (_e1191[0][2] - _e1191[2][2]);
                                                                            let _e1368 = vec3<f32>(_e1365, _e1366, _e1367);
                                                                            let _e1371 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                            let _e1374 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                            let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                            let _e1379 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                            let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                            let _e1384 = bitcast<f32>((bitcast<u32>(_e1361) & 2147483647u));
                                                                            let _e1387 = bitcast<f32>((bitcast<u32>(_e1362) & 2147483647u));
                                                                            let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                            let _e1392 = bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u));
                                                                            let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                                                            let _e1397 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                            let _e1400 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                            let _e1402 = select(_e1400, _e1397, (_e1397 > _e1400));
                                                                            let _e1405 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                            let _e1407 = select(_e1405, _e1402, (_e1402 > _e1405));
                                                                            let _e1409 = select(_e1394, _e1381, (_e1381 > _e1394));
                                                                            let _e1411 = select(_e1407, _e1409, (_e1409 > _e1407));
                                                                            if (_e1381 == _e1411) {
                                                                                phi_1813_ = _e1218;
                                                                                phi_1814_ = _e1215;
                                                                                phi_1815_ = _e1205;
                                                                                phi_1816_ = _e1202;
                                                                                phi_1817_ = _e1354;
                                                                                phi_1818_ = _e1368;
                                                                                phi_1819_ = _e1364;
                                                                                phi_1820_ = _e1360;
                                                                            } else {
                                                                                let _e1413 = (_e1394 == _e1411);
                                                                                let _e1418 = vec3(_e1413);
                                                                                phi_1813_ = select(_e1205, _e1231, _e1413);
                                                                                phi_1814_ = select(_e1202, _e1228, _e1413);
                                                                                phi_1815_ = select(_e1231, _e1218, _e1413);
                                                                                phi_1816_ = select(_e1228, _e1215, _e1413);
                                                                                phi_1817_ = select(_e1356, _e1355, _e1418);
                                                                                phi_1818_ = select(_e1364, _e1360, _e1418);
                                                                                phi_1819_ = select(_e1360, _e1368, _e1418);
                                                                                phi_1820_ = select(_e1368, _e1364, _e1418);
                                                                            }
                                                                            let _e1424 = phi_1813_;
                                                                            let _e1426 = phi_1814_;
                                                                            let _e1428 = phi_1815_;
                                                                            let _e1430 = phi_1816_;
                                                                            let _e1432 = phi_1817_;
                                                                            let _e1434 = phi_1818_;
                                                                            let _e1436 = phi_1819_;
                                                                            let _e1438 = phi_1820_;
                                                                            let _e1445 = ((_e1436.y * _e1434.z) - (_e1434.y * _e1436.z));
                                                                            let _e1450 = ((_e1436.z * _e1434.x) - (_e1434.z * _e1436.x));
                                                                            let _e1453 = ((_e1436.x * _e1434.y) - (_e1434.x * _e1436.y));
                                                                            if (_e1253 >= _e1257) {
                                                                                phi_1851_ = select(true, false, (_e1253 >= _e1261));
                                                                            } else {
                                                                                phi_1851_ = true;
                                                                            }
                                                                            let _e1458 = phi_1851_;
                                                                            if _e1458 {
                                                                                phi_1860_ = select(_e1356, _e1355, vec3((_e1257 >= _e1261)));
                                                                            } else {
                                                                                phi_1860_ = _e1354;
                                                                            }
                                                                            let _e1463 = phi_1860_;
                                                                            let _e1474 = (((_e1445 * (_e1463.x - _e400)) + (_e1450 * (_e1463.y - _e437))) + (_e1453 * (_e1463.z - _e473)));
                                                                            let _e1479 = (((_e1445 * _e425) + (_e1450 * _e461)) + (_e1453 * _e497));
                                                                            let _e1480 = (_e1426 - _e1430);
                                                                            let _e1481 = (_e1424 - _e1428);
                                                                            let _e1489 = (-(((_e1430 * _e1480) + (_e1428 * _e1481))) / ((_e1480 * _e1480) + (_e1481 * _e1481)));
                                                                            let _e1491 = select(1f, _e1489, (_e1489 < 1f));
                                                                            let _e1493 = select(0f, _e1491, (_e1491 > 0f));
                                                                            let _e1506 = ((_e1432.x + (_e1438.x * _e1493)) - _e400);
                                                                            let _e1507 = ((_e1432.y + (_e1438.y * _e1493)) - _e437);
                                                                            let _e1508 = ((_e1432.z + (_e1438.z * _e1493)) - _e473);
                                                                            let _e1509 = (_e1508 / _e497);
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                            let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                                            let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                            let _e1537 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                            let _e1540 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                            let _e1542 = select(_e1540, _e1537, (_e1537 > _e1540));
                                                                            let _e1545 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1445 * _e1506) + (_e1450 * _e1507)) + (_e1453 * _e1508)) - _e1474)) & 2147483647u)) <= ((0.0000009536743f * select(_e1411, _e1531, (_e1531 > _e1411))) * select(_e1545, _e1542, (_e1542 > _e1545)))) {
                                                                                let _e1555 = bitcast<f32>((bitcast<u32>(_e1436.x) & 2147483647u));
                                                                                let _e1558 = bitcast<f32>((bitcast<u32>(_e1436.y) & 2147483647u));
                                                                                let _e1560 = select(_e1558, _e1555, (_e1555 > _e1558));
                                                                                let _e1563 = bitcast<f32>((bitcast<u32>(_e1436.z) & 2147483647u));
                                                                                let _e1569 = bitcast<f32>((bitcast<u32>(_e1434.x) & 2147483647u));
                                                                                let _e1572 = bitcast<f32>((bitcast<u32>(_e1434.y) & 2147483647u));
                                                                                let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                                                                let _e1577 = bitcast<f32>((bitcast<u32>(_e1434.z) & 2147483647u));
                                                                                let _e1581 = (bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u)) > ((0.0000038146973f * select(_e1563, _e1560, (_e1560 > _e1563))) * select(_e1577, _e1574, (_e1574 > _e1577))));
                                                                                if _e1581 {
                                                                                    phi_2025_ = (_e1474 / _e1479);
                                                                                } else {
                                                                                    phi_2025_ = f32();
                                                                                }
                                                                                let _e1584 = phi_2025_;
                                                                                phi_2027_ = _e1584;
                                                                                phi_2028_ = select(true, false, _e1581);
                                                                            } else {
                                                                                phi_2027_ = f32();
                                                                                phi_2028_ = true;
                                                                            }
                                                                            let _e1587 = phi_2027_;
                                                                            let _e1589 = phi_2028_;
                                                                            if _e1589 {
                                                                                let _e1597 = (((_e1445 * (_e1506 - (_e425 * _e1509))) + (_e1450 * (_e1507 - (_e461 * _e1509)))) / _e1479);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1597) & 2147483647u)) <= _e1411) {
                                                                                    phi_2048_ = (_e1509 + _e1597);
                                                                                } else {
                                                                                    phi_2048_ = _e1509;
                                                                                }
                                                                                let _e1604 = phi_2048_;
                                                                                phi_2049_ = _e1604;
                                                                            } else {
                                                                                phi_2049_ = _e1587;
                                                                            }
                                                                            let _e1606 = phi_2049_;
                                                                            let _e1608 = select(_e1344, _e1606, (_e1606 < _e1344));
                                                                            let _e1610 = select(_e1336, _e1608, (_e1608 > _e1336));
                                                                            if (_e1610 >= _e546) {
                                                                                let _e1612 = (_e1610 <= _e1095.member);
                                                                                if _e1612 {
                                                                                    let _e1613 = (1f / _e1263);
                                                                                    phi_2072_ = type_26(_e1610, (_e1257 * _e1613), (_e1261 * _e1613), _e1124);
                                                                                } else {
                                                                                    phi_2072_ = type_26();
                                                                                }
                                                                                let _e1618 = phi_2072_;
                                                                                phi_2074_ = _e1618;
                                                                                phi_2075_ = select(true, false, _e1612);
                                                                            } else {
                                                                                phi_2074_ = type_26();
                                                                                phi_2075_ = true;
                                                                            }
                                                                            let _e1621 = phi_2074_;
                                                                            let _e1623 = phi_2075_;
                                                                            if _e1623 {
                                                                                phi_2079_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2079_ = _e1621;
                                                                            }
                                                                            let _e1625 = phi_2079_;
                                                                            phi_2080_ = _e1625;
                                                                        }
                                                                        let _e1627 = phi_2080_;
                                                                        phi_2081_ = _e1627;
                                                                        phi_2082_ = _e1353;
                                                                    }
                                                                    let _e1629 = phi_2081_;
                                                                    let _e1631 = phi_2082_;
                                                                    phi_2086_ = _e1629;
                                                                    phi_2087_ = _e1631;
                                                                }
                                                                let _e1633 = phi_2086_;
                                                                let _e1635 = phi_2087_;
                                                                phi_2088_ = _e1633;
                                                                phi_2089_ = _e1288;
                                                                phi_2090_ = _e1635;
                                                            }
                                                            let _e1637 = phi_2088_;
                                                            let _e1639 = phi_2089_;
                                                            let _e1641 = phi_2090_;
                                                            phi_2091_ = _e1637;
                                                            phi_2092_ = _e1639;
                                                            phi_2093_ = _e1641;
                                                        }
                                                        let _e1643 = phi_2091_;
                                                        let _e1645 = phi_2092_;
                                                        let _e1647 = phi_2093_;
                                                        phi_2101_ = _e1643;
                                                        phi_2102_ = select(_e1647, true, _e1645);
                                                    } else {
                                                        phi_2101_ = type_26();
                                                        phi_2102_ = true;
                                                    }
                                                    let _e1650 = phi_2101_;
                                                    let _e1652 = phi_2102_;
                                                    if _e1652 {
                                                        phi_2106_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2106_ = _e1650;
                                                    }
                                                    let _e1654 = phi_2106_;
                                                    if (_e1654.member_3 != 4294967295u) {
                                                        if (_e1124 == _e163) {
                                                            phi_2435_ = false;
                                                        } else {
                                                            let _e1658 = (_e1124 < arrayLength((&global_6.member)));
                                                            if _e1658 {
                                                                if _e1658 {
                                                                } else {
                                                                    phi_3905_ = true;
                                                                    break;
                                                                }
                                                                let _e1660 = global_6.member[_e1124];
                                                                phi_2129_ = _e1660;
                                                            } else {
                                                                phi_2129_ = 4294967295u;
                                                            }
                                                            let _e1662 = phi_2129_;
                                                            let _e1663 = (_e1662 < arrayLength((&global_7.member)));
                                                            if _e1663 {
                                                                if _e1663 {
                                                                } else {
                                                                    phi_3905_ = true;
                                                                    break;
                                                                }
                                                                let _e1665 = global_7.member[_e1662];
                                                                phi_2143_ = _e1665;
                                                            } else {
                                                                phi_2143_ = 0i;
                                                            }
                                                            let _e1667 = phi_2143_;
                                                            let _e1668 = (_e1667 == 0i);
                                                            if _e1668 {
                                                                phi_2434_ = true;
                                                            } else {
                                                                if _e392 {
                                                                    phi_2164_ = vec3<f32>(_e1191[0][0], _e1191[0][1], _e1191[0][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_2163_ = vec3<f32>(_e1191[0][2], _e1191[0][0], _e1191[0][1]);
                                                                    } else {
                                                                        phi_2163_ = vec3<f32>(_e1191[0][1], _e1191[0][2], _e1191[0][0]);
                                                                    }
                                                                    let _e1673 = phi_2163_;
                                                                    phi_2164_ = _e1673;
                                                                }
                                                                let _e1676 = phi_2164_;
                                                                if _e392 {
                                                                    phi_2181_ = vec3<f32>(_e1191[1][0], _e1191[1][1], _e1191[1][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_2180_ = vec3<f32>(_e1191[1][2], _e1191[1][0], _e1191[1][1]);
                                                                    } else {
                                                                        phi_2180_ = vec3<f32>(_e1191[1][1], _e1191[1][2], _e1191[1][0]);
                                                                    }
                                                                    let _e1681 = phi_2180_;
                                                                    phi_2181_ = _e1681;
                                                                }
                                                                let _e1684 = phi_2181_;
                                                                if _e392 {
                                                                    phi_2198_ = vec3<f32>(_e1191[2][0], _e1191[2][1], _e1191[2][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_2197_ = vec3<f32>(_e1191[2][2], _e1191[2][0], _e1191[2][1]);
                                                                    } else {
                                                                        phi_2197_ = vec3<f32>(_e1191[2][1], _e1191[2][2], _e1191[2][0]);
                                                                    }
                                                                    let _e1689 = phi_2197_;
                                                                    phi_2198_ = _e1689;
                                                                }
                                                                let _e1692 = phi_2198_;
                                                                let _e1695 = (_e1684.x - _e1676.x);
                                                                let _e1698 = (_e1684.y - _e1676.y);
                                                                let _e1701 = (_e1684.z - _e1676.z);
                                                                let _e1703 = (_e1692.x - _e1676.x);
                                                                let _e1705 = (_e1692.y - _e1676.y);
                                                                let _e1707 = (_e1692.z - _e1676.z);
                                                                if (_e235.member_1 == 1u) {
                                                                    phi_2234_ = (vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]) - _e1676);
                                                                } else {
                                                                    phi_2234_ = vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]);
                                                                }
                                                                let _e1722 = phi_2234_;
                                                                let _e1728 = bitcast<f32>((bitcast<u32>((_e1695 * _e1705)) ^ _e235.member_3[0]));
                                                                let _e1732 = bitcast<f32>((bitcast<u32>((_e1698 * _e1703)) ^ _e235.member_3[0]));
                                                                let _e1736 = bitcast<f32>((bitcast<u32>((_e1698 * _e1707)) ^ _e235.member_3[0]));
                                                                let _e1740 = bitcast<f32>((bitcast<u32>((_e1701 * _e1705)) ^ _e235.member_3[0]));
                                                                let _e1744 = bitcast<f32>((bitcast<u32>((_e1701 * _e1703)) ^ _e235.member_3[0]));
                                                                let _e1748 = bitcast<f32>((bitcast<u32>((_e1695 * _e1707)) ^ _e235.member_3[0]));
                                                                let _e1749 = (_e1736 - _e1740);
                                                                let _e1750 = (_e1744 - _e1748);
                                                                let _e1751 = (_e1728 - _e1732);
                                                                let _e1775 = (bitcast<f32>((bitcast<u32>(_e1736) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1740) & 2147483647u)));
                                                                let _e1782 = (bitcast<f32>((bitcast<u32>(_e1744) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1748) & 2147483647u)));
                                                                let _e1789 = (bitcast<f32>((bitcast<u32>(_e1728) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1732) & 2147483647u)));
                                                                if (_e235.member_2 == 0f) {
                                                                    phi_2416_ = 0f;
                                                                } else {
                                                                    let _e1819 = bitcast<f32>((bitcast<u32>(_e1749) & 2147483647u));
                                                                    let _e1822 = bitcast<f32>((bitcast<u32>(_e1750) & 2147483647u));
                                                                    let _e1825 = bitcast<f32>((bitcast<u32>(_e1751) & 2147483647u));
                                                                    let _e1827 = select(_e1825, _e1822, (_e1822 > _e1825));
                                                                    let _e1831 = select(_e1825, _e1822, (_e1822 < _e1825));
                                                                    let _e1835 = select(_e1822, _e1819, (_e1819 < _e1822));
                                                                    let _e1837 = select(_e1822, _e1819, (_e1819 > _e1822));
                                                                    let _e1839 = select(_e1825, _e1837, (_e1837 < _e1825));
                                                                    phi_2416_ = bitcast<f32>((bitcast<u32>((_e235.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1827, _e1819, (_e1819 > _e1827)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1839, _e1835, (_e1835 > _e1839)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1831, _e1819, (_e1819 < _e1831)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1775 + _e1782) + _e1789))) ^ _e235.member_3[0]))) * 1.0000005f)) ^ _e235.member_3[0])))) ^ _e235.member_3[0]));
                                                                }
                                                                let _e1866 = phi_2416_;
                                                                phi_2434_ = (_e1668 || !(((((bitcast<f32>((bitcast<u32>((_e1722.x * _e1749)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1722.y * _e1750)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1722.z * _e1751)) ^ _e235.member_3[0]))) * f32(-(_e1667))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1722.x) & 2147483647u)) * _e1775)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1722.y) & 2147483647u)) * _e1782)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1722.z) & 2147483647u)) * _e1789)) ^ _e235.member_3[0]))))) ^ _e235.member_3[0])) + _e1866) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1880 = phi_2434_;
                                                            phi_2435_ = _e1880;
                                                        }
                                                        let _e1882 = phi_2435_;
                                                        if _e1882 {
                                                            phi_2440_ = type_47(_e1095.member, true);
                                                        } else {
                                                            phi_2440_ = _e1095;
                                                        }
                                                        let _e1887 = phi_2440_;
                                                        phi_2441_ = _e1887;
                                                    } else {
                                                        phi_2441_ = _e1095;
                                                    }
                                                    let _e1889 = phi_2441_;
                                                    phi_1131_ = _e1889;
                                                } else {
                                                    phi_1131_ = type_47();
                                                }
                                                let _e1891 = phi_1131_;
                                                continue;
                                                continuing {
                                                    phi_1130_ = _e1891;
                                                    phi_1133_ = _e1110;
                                                    phi_3905_ = _e588;
                                                    break if !(_e1116);
                                                }
                                            }
                                            let _e1894 = phi_3905_;
                                            phi_4071_ = _e1894;
                                            if _e1894 {
                                                break;
                                            }
                                            let _e1896 = local_10;
                                            phi_4075_ = _e1894;
                                            let _e2102 = local_12;
                                            phi_3647_ = _e2102;
                                            phi_3648_ = _e629;
                                            phi_3649_ = false;
                                            phi_3650_ = select(_e633, 0u, _e1896.member_1);
                                        } else {
                                            if (_e629.member_1 >= _e96) {
                                                phi_3203_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e629.member_1 < _e96) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e644 = (_e368 * 2u);
                                                let _e646 = ((1u + _e644) % 7u);
                                                if (_e646 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e651 = global_9.member[_e629.member_1][_e646];
                                                let _e653 = ((_e644 + 2u) % 7u);
                                                if (_e653 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e658 = global_9.member[_e629.member_1][_e653];
                                                let _e659 = (_e367 * 2u);
                                                let _e661 = ((1u + _e659) % 7u);
                                                if (_e661 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e666 = global_9.member[_e629.member_1][_e661];
                                                let _e668 = ((_e659 + 2u) % 7u);
                                                if (_e668 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e673 = global_9.member[_e629.member_1][_e668];
                                                let _e674 = (_e369 * 2u);
                                                let _e676 = ((1u + _e674) % 7u);
                                                if (_e676 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e681 = global_9.member[_e629.member_1][_e676];
                                                let _e683 = ((_e674 + 2u) % 7u);
                                                if (_e683 < 7u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e688 = global_9.member[_e629.member_1][_e683];
                                                let _e711 = (bitcast<f32>((bitcast<u32>((_e629.member.member_1.x - _e629.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e712 = (bitcast<f32>((bitcast<u32>((_e629.member.member_1.y - _e629.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e713 = (bitcast<f32>((bitcast<u32>((_e629.member.member_1.z - _e629.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e715 = select(_e154, _e711, (_e711 > _e154));
                                                let _e717 = select(_e154, _e712, (_e712 > _e154));
                                                let _e719 = select(_e154, _e713, (_e713 > _e154));
                                                let _e744 = bitcast<u32>((f32(bitcast<i32>((_e651 & 2097151u))) * _e715));
                                                let _e749 = (bitcast<i32>((_e651 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e752 = bitcast<f32>((_e744 & bitcast<u32>(_e749)));
                                                let _e753 = bitcast<u32>((f32(bitcast<i32>((_e666 & 2097151u))) * _e717));
                                                let _e758 = (bitcast<i32>((_e666 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e761 = bitcast<f32>((_e753 & bitcast<u32>(_e758)));
                                                let _e762 = bitcast<u32>((f32(bitcast<i32>((_e681 & 2097151u))) * _e719));
                                                let _e767 = (bitcast<i32>((_e681 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                                let _e774 = bitcast<f32>((_e744 & bitcast<u32>(~(_e749))));
                                                let _e778 = bitcast<f32>((_e753 & bitcast<u32>(~(_e758))));
                                                let _e782 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                                let _e783 = bitcast<u32>((f32(bitcast<i32>((_e658 & 2097151u))) * _e715));
                                                let _e788 = (bitcast<i32>((_e658 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e791 = bitcast<f32>((_e783 & bitcast<u32>(_e788)));
                                                let _e792 = bitcast<u32>((f32(bitcast<i32>((_e673 & 2097151u))) * _e717));
                                                let _e797 = (bitcast<i32>((_e673 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e800 = bitcast<f32>((_e792 & bitcast<u32>(_e797)));
                                                let _e801 = bitcast<u32>((f32(bitcast<i32>((_e688 & 2097151u))) * _e719));
                                                let _e806 = (bitcast<i32>((_e688 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e809 = bitcast<f32>((_e801 & bitcast<u32>(_e806)));
                                                let _e813 = bitcast<f32>((_e783 & bitcast<u32>(~(_e788))));
                                                let _e817 = bitcast<f32>((_e792 & bitcast<u32>(~(_e797))));
                                                let _e821 = bitcast<f32>((_e801 & bitcast<u32>(~(_e806))));
                                                let _e851 = global_9.member[_e629.member_1][0u];
                                                let _e855 = global_9.member[_e629.member_1][2u];
                                                let _e859 = global_9.member[_e629.member_1][4u];
                                                let _e863 = global_9.member[_e629.member_1][6u];
                                                let _e875 = (((_e855 >> bitcast<u32>(22i)) | ((_e859 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e863 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e876 = (_e851 & 268435455u);
                                                let _e877 = (_e875 & 268435455u);
                                                let _e880 = ((_e851 >> bitcast<u32>(28u)) & 7u);
                                                let _e888 = ((_e851 >> bitcast<u32>(31i)) | (((_e875 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e889 = (_e880 != 0u);
                                                if (_e880 == 0u) {
                                                    phi_3165_ = _e876;
                                                } else {
                                                    if (_e880 == 7u) {
                                                        phi_3164_ = 2147483648u;
                                                    } else {
                                                        phi_3164_ = ((2147483648u | (_e880 << bitcast<u32>(28u))) | (_e877 & 268435455u));
                                                    }
                                                    let _e898 = phi_3164_;
                                                    phi_3165_ = _e898;
                                                }
                                                let _e900 = phi_3165_;
                                                if _e889 {
                                                    let _e901 = (_e880 != 7u);
                                                    if _e901 {
                                                        phi_3175_ = (_e877 + _e880);
                                                    } else {
                                                        phi_3175_ = u32();
                                                    }
                                                    let _e904 = phi_3175_;
                                                    phi_3177_ = _e904;
                                                    phi_3178_ = select(true, false, _e901);
                                                } else {
                                                    phi_3177_ = u32();
                                                    phi_3178_ = true;
                                                }
                                                let _e907 = phi_3177_;
                                                let _e909 = phi_3178_;
                                                if (_e888 == 0u) {
                                                    phi_3199_ = (_e876 + select(0u, 1u, !(_e889)));
                                                } else {
                                                    if (_e888 == 7u) {
                                                        phi_3198_ = 2147483648u;
                                                    } else {
                                                        phi_3198_ = ((2147483648u | (_e888 << bitcast<u32>(28u))) | (select(_e907, _e877, _e909) & 268435455u));
                                                    }
                                                    let _e922 = phi_3198_;
                                                    phi_3199_ = _e922;
                                                }
                                                let _e924 = phi_3199_;
                                                phi_3203_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e629.member.member.x + _e752), (_e629.member.member.x + _e774), (_e629.member.member_1.x - _e791), (_e629.member.member_1.x - _e813)), vec4<f32>((_e629.member.member.y + _e761), (_e629.member.member.y + _e778), (_e629.member.member_1.y - _e800), (_e629.member.member_1.y - _e817)), vec4<f32>((_e629.member.member.z + _e770), (_e629.member.member.z + _e782), (_e629.member.member_1.z - _e809), (_e629.member.member_1.z - _e821))), type_63(type_35((_e629.member.member + vec4<f32>(_e752, _e761, _e770, 0f)), (_e629.member.member_1 - vec4<f32>(_e791, _e800, _e809, 0f))), _e900), type_63(type_35((_e629.member.member + vec4<f32>(_e774, _e778, _e782, 0f)), (_e629.member.member_1 - vec4<f32>(_e813, _e817, _e821, 0f))), _e924));
                                            }
                                            let _e929 = phi_3203_;
                                            let _e941 = ((_e929.member[0].x - _e423) * _e428);
                                            let _e942 = ((_e929.member[0].y - _e423) * _e428);
                                            let _e943 = ((_e929.member[0].z - _e424) * _e428);
                                            let _e944 = ((_e929.member[0].w - _e424) * _e428);
                                            let _e954 = ((_e929.member[1].x - _e459) * _e464);
                                            let _e955 = ((_e929.member[1].y - _e459) * _e464);
                                            let _e956 = ((_e929.member[1].z - _e460) * _e464);
                                            let _e957 = ((_e929.member[1].w - _e460) * _e464);
                                            let _e967 = ((_e929.member[2].x - _e495) * _e500);
                                            let _e968 = ((_e929.member[2].y - _e495) * _e500);
                                            let _e969 = ((_e929.member[2].z - _e496) * _e500);
                                            let _e970 = ((_e929.member[2].w - _e496) * _e500);
                                            let _e972 = select(_e969, _e967, (_e967 < _e969));
                                            let _e974 = select(_e970, _e968, (_e968 < _e970));
                                            let _e976 = select(_e969, _e967, (_e967 > _e969));
                                            let _e978 = select(_e970, _e968, (_e968 > _e970));
                                            let _e980 = select(_e943, _e941, (_e941 < _e943));
                                            let _e982 = select(_e944, _e942, (_e942 < _e944));
                                            let _e984 = select(_e956, _e954, (_e954 < _e956));
                                            let _e986 = select(_e957, _e955, (_e955 < _e957));
                                            let _e988 = select(_e984, _e980, (_e980 > _e984));
                                            let _e990 = select(_e986, _e982, (_e982 > _e986));
                                            let _e992 = select(_e972, _e988, (_e988 > _e972));
                                            let _e994 = select(_e974, _e990, (_e990 > _e974));
                                            let _e996 = select(_e943, _e941, (_e941 > _e943));
                                            let _e998 = select(_e944, _e942, (_e942 > _e944));
                                            let _e1000 = select(_e956, _e954, (_e954 > _e956));
                                            let _e1002 = select(_e957, _e955, (_e955 > _e957));
                                            let _e1004 = select(_e1000, _e996, (_e996 < _e1000));
                                            let _e1006 = select(_e1002, _e998, (_e998 < _e1002));
                                            let _e1011 = -(_e972);
                                            let _e1012 = -(_e974);
                                            let _e1019 = (select(_e976, _e1004, (_e1004 < _e976)) + (select(_e1011, _e976, (_e976 > _e1011)) * 0.0000019073523f));
                                            let _e1020 = (select(_e978, _e1006, (_e1006 < _e978)) + (select(_e1012, _e978, (_e978 > _e1012)) * 0.0000019073523f));
                                            let _e1022 = select(_e546, _e992, (_e992 > _e546));
                                            let _e1024 = select(_e546, _e994, (_e994 > _e546));
                                            let _e1029 = (_e1022 <= select(_e590.member, _e1019, (_e1019 < _e590.member)));
                                            let _e1030 = (_e1024 <= select(_e590.member, _e1020, (_e1020 < _e590.member)));
                                            let _e1031 = (_e1022 <= _e1024);
                                            if _e1029 {
                                                if _e1030 {
                                                    if _e1031 {
                                                        phi_3547_ = _e929.member_2;
                                                    } else {
                                                        phi_3547_ = _e929.member_1;
                                                    }
                                                    let _e1035 = phi_3547_;
                                                    let _e1057 = (_e633 % 128u);
                                                    let _e1058 = (_e1057 < 128u);
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1057] = _e1035.member_1;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1057] = _e1035.member.member.x;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1057] = _e1035.member.member.y;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1057] = _e1035.member.member.z;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1057] = _e1035.member.member_1.x;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1057] = _e1035.member.member_1.y;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1057] = _e1035.member.member_1.z;
                                                    if _e1058 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1057] = select(_e1024, _e1022, (_e1022 > _e1024));
                                                    if _e1031 {
                                                        phi_3624_ = _e929.member_1;
                                                    } else {
                                                        phi_3624_ = _e929.member_2;
                                                    }
                                                    let _e1071 = phi_3624_;
                                                    phi_3625_ = _e1071;
                                                    phi_3626_ = (_e633 + 1u);
                                                } else {
                                                    phi_3625_ = type_63();
                                                    phi_3626_ = u32();
                                                }
                                                let _e1073 = phi_3625_;
                                                let _e1075 = phi_3626_;
                                                phi_3628_ = _e1073;
                                                phi_3629_ = _e1075;
                                                phi_3630_ = select(true, false, _e1030);
                                            } else {
                                                phi_3628_ = type_63();
                                                phi_3629_ = u32();
                                                phi_3630_ = true;
                                            }
                                            let _e1078 = phi_3628_;
                                            let _e1080 = phi_3629_;
                                            let _e1082 = phi_3630_;
                                            if _e1082 {
                                                if _e1029 {
                                                    phi_3639_ = _e929.member_1;
                                                } else {
                                                    phi_3639_ = _e929.member_2;
                                                }
                                                let _e1086 = phi_3639_;
                                                phi_3644_ = _e1086;
                                                phi_3645_ = select(_e1030, true, _e1029);
                                            } else {
                                                phi_3644_ = _e1078;
                                                phi_3645_ = _e631;
                                            }
                                            let _e1089 = phi_3644_;
                                            let _e1091 = phi_3645_;
                                            phi_4075_ = _e588;
                                            phi_3647_ = _e590;
                                            phi_3648_ = _e1089;
                                            phi_3649_ = _e1091;
                                            phi_3650_ = select(_e1080, _e633, _e1082);
                                        }
                                        let _e1900 = phi_4075_;
                                        let _e1902 = phi_3647_;
                                        let _e1904 = phi_3648_;
                                        let _e1906 = phi_3649_;
                                        let _e1908 = phi_3650_;
                                        phi_4074_ = _e1900;
                                        phi_3651_ = _e1902;
                                        phi_3652_ = _e1904;
                                        phi_3653_ = (_e594 - 1u);
                                        phi_3654_ = _e1906;
                                        phi_3655_ = _e1908;
                                    } else {
                                        phi_4074_ = _e588;
                                        phi_3651_ = _e590;
                                        phi_3652_ = _e629;
                                        phi_3653_ = _e594;
                                        phi_3654_ = _e631;
                                        phi_3655_ = _e633;
                                    }
                                    let _e1910 = phi_4074_;
                                    let _e1912 = phi_3651_;
                                    let _e1914 = phi_3652_;
                                    let _e1916 = phi_3653_;
                                    let _e1918 = phi_3654_;
                                    let _e1920 = phi_3655_;
                                    phi_4073_ = _e1910;
                                    phi_3656_ = _e1912;
                                    phi_3657_ = _e1914;
                                    phi_3658_ = _e1916;
                                    phi_3659_ = _e1918;
                                    phi_3660_ = _e1920;
                                } else {
                                    phi_4073_ = _e588;
                                    phi_3656_ = type_47();
                                    phi_3657_ = type_63();
                                    phi_3658_ = u32();
                                    phi_3659_ = bool();
                                    phi_3660_ = u32();
                                }
                                let _e1922 = phi_4073_;
                                let _e1924 = phi_3656_;
                                let _e1926 = phi_3657_;
                                let _e1928 = phi_3658_;
                                let _e1930 = phi_3659_;
                                let _e1932 = phi_3660_;
                                phi_4072_ = _e1922;
                                phi_1005_ = _e1924;
                                phi_1008_ = _e1926;
                                phi_1010_ = _e1928;
                                phi_1012_ = _e1930;
                                phi_1014_ = _e1932;
                                phi_3661_ = _e602;
                            } else {
                                phi_4072_ = _e588;
                                phi_1005_ = type_47();
                                phi_1008_ = type_63();
                                phi_1010_ = u32();
                                phi_1012_ = bool();
                                phi_1014_ = u32();
                                phi_3661_ = false;
                            }
                            let _e1934 = phi_4072_;
                            let _e1936 = phi_1005_;
                            let _e1938 = phi_1008_;
                            let _e1940 = phi_1010_;
                            let _e1942 = phi_1012_;
                            let _e1944 = phi_1014_;
                            let _e1946 = phi_3661_;
                            continue;
                            continuing {
                                phi_3911_ = _e1934;
                                phi_1004_ = _e1936;
                                phi_1007_ = _e1938;
                                phi_1009_ = _e1940;
                                phi_1011_ = _e1942;
                                phi_1013_ = _e1944;
                                phi_4071_ = _e1934;
                                break if !(_e1946);
                            }
                        }
                        let _e1949 = phi_4071_;
                        if _e1949 {
                            break;
                        }
                        let _e1951 = local_11;
                        if _e1951.member_1 {
                        } else {
                            if _e236 {
                            } else {
                                break;
                            }
                            let _e1955 = global_2.member[_e142];
                            if _e157 {
                            } else {
                                break;
                            }
                            let _e1959 = global_10.member[_e142].member_1;
                            if _e236 {
                            } else {
                                break;
                            }
                            global_2.member[_e142] = type_28(_e1955.member, _e1955.member_1, _e1955.member_2, array<f32, 3>((_e1955.member_3[0] + (_e1959[0] * _e1955.member_1[0])), (_e1955.member_3[1] + (_e1959[1] * _e1955.member_1[1])), (_e1955.member_3[2] + (_e1959[2] * _e1955.member_1[2]))), _e1955.member_4);
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
