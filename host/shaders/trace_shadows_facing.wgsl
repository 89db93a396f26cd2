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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_54 {
    member: f32,
    member_1: bool,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_56;
@group(0) @binding(2) 
var<storage> global_3: type_39;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_216_: u32;
    var phi_281_: type_47;
    var phi_431_: i32;
    var phi_432_: i32;
    var phi_442_: bool;
    var phi_452_: u32;
    var phi_453_: u32;
    var phi_455_: bool;
    var phi_460_: u32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_521_: f32;
    var phi_527_: f32;
    var phi_550_: f32;
    var phi_561_: f32;
    var phi_570_: f32;
    var phi_576_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_616_: f32;
    var phi_627_: f32;
    var phi_636_: f32;
    var phi_642_: f32;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_682_: f32;
    var phi_693_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_2728_: bool;
    var phi_1068_: type_54;
    var phi_1071_: u32;
    var phi_1073_: u32;
    var phi_1075_: bool;
    var phi_1077_: u32;
    var phi_1088_: bool;
    var phi_1119_: u32;
    var phi_1120_: bool;
    var phi_1121_: u32;
    var phi_2244_: type_53;
    var phi_2588_: u32;
    var phi_2615_: u32;
    var phi_2616_: u32;
    var phi_2617_: u32;
    var phi_2619_: u32;
    var phi_2620_: u32;
    var phi_2621_: bool;
    var phi_2630_: u32;
    var phi_2635_: u32;
    var phi_2636_: bool;
    var phi_1136_: type_54;
    var phi_1139_: type_8;
    var phi_1140_: type_8;
    var phi_1162_: type_8;
    var phi_1183_: u32;
    var phi_1272_: array<array<f32, 3>, 3>;
    var phi_1743_: vec3<f32>;
    var phi_1744_: vec3<f32>;
    var phi_1775_: bool;
    var phi_1784_: vec3<f32>;
    var phi_1824_: type_28;
    var phi_1826_: type_28;
    var phi_1827_: bool;
    var phi_1831_: type_28;
    var phi_1832_: type_28;
    var phi_1833_: type_28;
    var phi_1834_: bool;
    var phi_1838_: type_28;
    var phi_1839_: bool;
    var phi_1843_: type_28;
    var phi_1844_: bool;
    var phi_1848_: type_28;
    var phi_1871_: u32;
    var phi_1885_: i32;
    var phi_1905_: vec3<f32>;
    var phi_1906_: vec3<f32>;
    var phi_1922_: vec3<f32>;
    var phi_1923_: vec3<f32>;
    var phi_1939_: vec3<f32>;
    var phi_1940_: vec3<f32>;
    var phi_1976_: vec3<f32>;
    var phi_2158_: f32;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2182_: type_54;
    var phi_2183_: type_54;
    var phi_1137_: type_54;
    var phi_2722_: bool;
    var local_2: type_54;
    var phi_2858_: bool;
    var phi_2638_: type_54;
    var phi_2639_: u32;
    var phi_2640_: bool;
    var phi_2641_: u32;
    var phi_2857_: bool;
    var phi_2642_: type_54;
    var phi_2643_: u32;
    var phi_2644_: u32;
    var phi_2645_: bool;
    var phi_2646_: u32;
    var phi_2856_: bool;
    var phi_2647_: type_54;
    var phi_2648_: u32;
    var phi_2649_: u32;
    var phi_2650_: bool;
    var phi_2651_: u32;
    var phi_2855_: bool;
    var phi_1069_: type_54;
    var phi_1072_: u32;
    var phi_1074_: u32;
    var phi_1076_: bool;
    var phi_1078_: u32;
    var phi_2652_: bool;
    var phi_2854_: bool;
    var local_3: type_54;
    var local_4: type_54;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_3.member));
            let _e76 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_7.member));
            let _e92 = (_e72.x + (_e72.y * 2097152u));
            let _e93 = (_e92 < arrayLength((&global_8.member)));
            if _e93 {
                if _e93 {
                } else {
                    break;
                }
                let _e97 = global_8.member[_e92].member_2;
                phi_216_ = _e97;
            } else {
                phi_216_ = 4294967295u;
            }
            let _e99 = phi_216_;
            let _e102 = global_1.member[0u];
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e134 = global_2.member[1u][3u];
            let _e135 = bitcast<f32>(_e106);
            let _e136 = bitcast<f32>(_e110);
            let _e137 = bitcast<f32>(_e114);
            let _e139 = bitcast<f32>(_e122);
            let _e140 = array<u32, 3>(_e126, _e130, _e134);
            let _e142 = bitcast<i32>(_e102);
            let _e143 = (_e142 / 2i);
            let _e148 = bitcast<f32>((bitcast<u32>((_e143 + 127i)) << bitcast<u32>(23i)));
            let _e154 = bitcast<f32>((bitcast<u32>(((_e142 - _e143) + 127i)) << bitcast<u32>(23i)));
            if (_e118 == 0u) {
                phi_281_ = type_47(array<f32, 3>(_e135, _e136, _e137), _e118, _e139, _e140);
            } else {
                phi_281_ = type_47(array<f32, 3>(((_e135 * _e148) * _e154), ((_e136 * _e148) * _e154), ((_e137 * _e148) * _e154)), _e118, ((_e139 * _e148) * _e154), _e140);
            }
            let _e167 = phi_281_;
            if _e93 {
                let _e168 = (_e92 < arrayLength((&global_9.member)));
                if _e168 {
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e173 = global_8.member[_e92].member.member_1;
                    let _e178 = global_8.member[_e92].member.member_3;
                    if (_e173 <= _e178) {
                        let _e180 = (1u < _e88);
                        if _e180 {
                            if (0u < _e88) {
                            } else {
                                break;
                            }
                            let _e184 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e184 + 1u) < _e184) {
                                if _e180 {
                                } else {
                                    break;
                                }
                                let _e189 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e93 {
                        } else {
                            break;
                        }
                        let _e199 = global_8.member[_e92].member.member_2[0u];
                        let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                        let _e207 = global_8.member[_e92].member.member_2[1u];
                        let _e209 = (bitcast<u32>(_e207) & 2147483647u);
                        let _e215 = global_8.member[_e92].member.member_2[2u];
                        let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                        let _e223 = global_8.member[_e92].member.member[0u];
                        let _e225 = (bitcast<u32>(_e223) & 2147483647u);
                        let _e231 = global_8.member[_e92].member.member[1u];
                        let _e233 = (bitcast<u32>(_e231) & 2147483647u);
                        let _e239 = global_8.member[_e92].member.member[2u];
                        let _e241 = (bitcast<u32>(_e239) & 2147483647u);
                        let _e243 = select(_e209, _e201, (_e209 < _e201));
                        let _e245 = select(_e217, _e243, (_e217 < _e243));
                        let _e247 = select(_e225, _e245, (_e225 < _e245));
                        let _e249 = select(_e233, _e247, (_e233 < _e247));
                        let _e251 = select(_e241, _e249, (_e241 < _e249));
                        let _e253 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e262 = (((select(_e253, _e251, (_e253 < _e251)) < 2139095040u) && ((bitcast<u32>(_e178) & 2147483647u) <= 2139095040u)) && (_e245 > 0u));
                        if _e262 {
                            let _e265 = (bitcast<u32>(bitcast<f32>(_e245)) & 2147483647u);
                            if (_e265 >= 8388608u) {
                                phi_431_ = (bitcast<i32>((_e265 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_431_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e265)), 32u, (_e265 == 0u))));
                            }
                            let _e279 = phi_431_;
                            phi_432_ = _e279;
                        } else {
                            phi_432_ = 0i;
                        }
                        let _e281 = phi_432_;
                        let _e282 = (_e201 == _e245);
                        if _e282 {
                            phi_442_ = true;
                        } else {
                            phi_442_ = (_e209 == _e245);
                        }
                        let _e285 = phi_442_;
                        let _e286 = select(1u, 0u, _e282);
                        if _e285 {
                            let _e287 = (_e286 + 1u);
                            phi_452_ = _e287;
                            phi_453_ = _e287;
                            phi_455_ = select(true, false, (_e287 == 2u));
                        } else {
                            phi_452_ = u32();
                            phi_453_ = 0u;
                            phi_455_ = true;
                        }
                        let _e291 = phi_452_;
                        let _e293 = phi_453_;
                        let _e295 = phi_455_;
                        if _e295 {
                            phi_460_ = (_e293 + 1u);
                        } else {
                            phi_460_ = 0u;
                        }
                        let _e299 = phi_460_;
                        let _e300 = select(_e291, _e293, _e295);
                        let _e301 = select(_e286, select(2u, _e286, _e285), _e295);
                        let _e302 = -(_e281);
                        let _e303 = (_e302 / 2i);
                        let _e308 = bitcast<f32>((bitcast<u32>((_e303 + 127i)) << bitcast<u32>(23i)));
                        let _e314 = bitcast<f32>((bitcast<u32>(((_e302 - _e303) + 127i)) << bitcast<u32>(23i)));
                        let _e319 = global_8.member[_e92].member.member;
                        let _e320 = (_e300 == 0u);
                        if _e320 {
                            phi_504_ = _e319[0];
                        } else {
                            phi_504_ = _e319[1];
                        }
                        let _e324 = phi_504_;
                        let _e325 = (_e300 == 2u);
                        if _e325 {
                            phi_510_ = _e319[2];
                        } else {
                            phi_510_ = _e324;
                        }
                        let _e328 = phi_510_;
                        let _e329 = global_8.member[_e92].member.member_2;
                        if _e320 {
                            phi_521_ = _e329[0];
                        } else {
                            phi_521_ = _e329[1];
                        }
                        let _e333 = phi_521_;
                        if _e325 {
                            phi_527_ = _e329[2];
                        } else {
                            phi_527_ = _e333;
                        }
                        let _e336 = phi_527_;
                        let _e338 = ((_e336 * _e308) * _e314);
                        let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e342 {
                            let _e346 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                            phi_550_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                        } else {
                            phi_550_ = 0f;
                        }
                        let _e350 = phi_550_;
                        let _e351 = (_e328 + _e350);
                        let _e352 = (_e328 - _e350);
                        let _e353 = select(_e338, 0f, _e342);
                        if _e342 {
                            phi_561_ = 38685626000000000000000000f;
                        } else {
                            phi_561_ = (1f / _e338);
                        }
                        let _e356 = phi_561_;
                        let _e357 = (_e299 == 0u);
                        if _e357 {
                            phi_570_ = _e319[0];
                        } else {
                            phi_570_ = _e319[1];
                        }
                        let _e361 = phi_570_;
                        let _e362 = (_e299 == 2u);
                        if _e362 {
                            phi_576_ = _e319[2];
                        } else {
                            phi_576_ = _e361;
                        }
                        let _e365 = phi_576_;
                        if _e357 {
                            phi_587_ = _e329[0];
                        } else {
                            phi_587_ = _e329[1];
                        }
                        let _e369 = phi_587_;
                        if _e362 {
                            phi_593_ = _e329[2];
                        } else {
                            phi_593_ = _e369;
                        }
                        let _e372 = phi_593_;
                        let _e374 = ((_e372 * _e308) * _e314);
                        let _e378 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e378 {
                            let _e382 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) * 0.00000011920929f);
                            phi_616_ = select(0.00000000000011368684f, _e382, (_e382 > 0.00000000000011368684f));
                        } else {
                            phi_616_ = 0f;
                        }
                        let _e386 = phi_616_;
                        let _e387 = (_e365 + _e386);
                        let _e388 = (_e365 - _e386);
                        let _e389 = select(_e374, 0f, _e378);
                        if _e378 {
                            phi_627_ = 38685626000000000000000000f;
                        } else {
                            phi_627_ = (1f / _e374);
                        }
                        let _e392 = phi_627_;
                        let _e393 = (_e301 == 0u);
                        if _e393 {
                            phi_636_ = _e319[0];
                        } else {
                            phi_636_ = _e319[1];
                        }
                        let _e397 = phi_636_;
                        let _e398 = (_e301 == 2u);
                        if _e398 {
                            phi_642_ = _e319[2];
                        } else {
                            phi_642_ = _e397;
                        }
                        let _e401 = phi_642_;
                        if _e393 {
                            phi_653_ = _e329[0];
                        } else {
                            phi_653_ = _e329[1];
                        }
                        let _e405 = phi_653_;
                        if _e398 {
                            phi_659_ = _e329[2];
                        } else {
                            phi_659_ = _e405;
                        }
                        let _e408 = phi_659_;
                        let _e410 = ((_e408 * _e308) * _e314);
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e414 {
                            let _e418 = (bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)) * 0.00000011920929f);
                            phi_682_ = select(0.00000000000011368684f, _e418, (_e418 > 0.00000000000011368684f));
                        } else {
                            phi_682_ = 0f;
                        }
                        let _e422 = phi_682_;
                        let _e423 = (_e401 + _e422);
                        let _e424 = (_e401 - _e422);
                        let _e425 = select(_e410, 0f, _e414);
                        if _e414 {
                            phi_693_ = 38685626000000000000000000f;
                        } else {
                            phi_693_ = (1f / _e410);
                        }
                        let _e428 = phi_693_;
                        let _e431 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                        let _e434 = bitcast<f32>((bitcast<u32>(_e365) & 2147483647u));
                        let _e436 = select(_e434, _e431, (_e431 > _e434));
                        let _e439 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                        if (_e262 && (select(_e439, _e436, (_e436 > _e439)) <= 1099511600000f)) {
                            let _e444 = (_e281 / 3i);
                            let _e451 = bitcast<f32>((bitcast<u32>((_e444 + 127i)) << bitcast<u32>(23i)));
                            let _e458 = bitcast<f32>((bitcast<u32>(((_e281 - (2i * _e444)) + 127i)) << bitcast<u32>(23i)));
                            let _e459 = (((_e173 * _e451) * _e451) * _e458);
                            let _e461 = select(340282350000000000000000000000000000000f, _e459, (_e459 < 340282350000000000000000000000000000000f));
                            let _e466 = (((_e178 * _e451) * _e451) * _e458);
                            let _e468 = select(340282350000000000000000000000000000000f, _e466, (_e466 < 340282350000000000000000000000000000000f));
                            phi_793_ = select(-340282350000000000000000000000000000000f, _e468, (_e468 > -340282350000000000000000000000000000000f));
                            phi_794_ = select(-340282350000000000000000000000000000000f, _e461, (_e461 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_793_ = 0f;
                            phi_794_ = 1f;
                        }
                        let _e472 = phi_793_;
                        let _e474 = phi_794_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2728_ = false;
                        phi_1068_ = type_54(_e472, false);
                        phi_1071_ = select(0u, 2147483648u, (_e74 == 0u));
                        phi_1073_ = ((3u * _e74) + 1u);
                        phi_1075_ = (_e474 <= _e472);
                        phi_1077_ = 0u;
                        loop {
                            let _e482 = phi_2728_;
                            let _e484 = phi_1068_;
                            let _e486 = phi_1071_;
                            let _e488 = phi_1073_;
                            let _e490 = phi_1075_;
                            let _e492 = phi_1077_;
                            local_3 = _e484;
                            if _e490 {
                                phi_1088_ = true;
                            } else {
                                phi_1088_ = (_e492 > 0u);
                            }
                            let _e495 = phi_1088_;
                            if _e495 {
                                let _e496 = (_e488 > 0u);
                                if _e496 {
                                    if _e490 {
                                        phi_1119_ = _e486;
                                        phi_1120_ = _e490;
                                        phi_1121_ = _e492;
                                    } else {
                                        let _e497 = (_e492 - 1u);
                                        let _e498 = (_e497 % 128u);
                                        let _e499 = (_e498 < 128u);
                                        if _e499 {
                                        } else {
                                            phi_2854_ = true;
                                            break;
                                        }
                                        let _e501 = local_1[_e498];
                                        if _e499 {
                                        } else {
                                            phi_2854_ = true;
                                            break;
                                        }
                                        let _e503 = local[_e498];
                                        phi_1119_ = _e501;
                                        phi_1120_ = (_e503 <= _e484.member);
                                        phi_1121_ = _e497;
                                    }
                                    let _e507 = phi_1119_;
                                    let _e509 = phi_1120_;
                                    let _e511 = phi_1121_;
                                    if _e509 {
                                        if ((_e507 & 2147483648u) != 0u) {
                                            phi_1136_ = _e484;
                                            phi_1139_ = type_8(0u, ((_e507 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e709 = phi_1136_;
                                                let _e711 = phi_1139_;
                                                local_2 = _e709;
                                                local_4 = _e709;
                                                if (_e711.member < _e711.member_1) {
                                                    phi_1140_ = type_8((_e711.member + 1u), _e711.member_1);
                                                    phi_1162_ = type_8(1u, _e711.member);
                                                } else {
                                                    phi_1140_ = _e711;
                                                    phi_1162_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e724 = phi_1140_;
                                                let _e726 = phi_1162_;
                                                let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                                if _e730 {
                                                    let _e731 = ((_e507 & 268435455u) + _e726.member_1);
                                                    let _e732 = (_e731 < _e76);
                                                    if _e732 {
                                                        if _e732 {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e736 = global_4.member[_e731].member_1;
                                                        phi_1183_ = _e736;
                                                    } else {
                                                        phi_1183_ = 4294967295u;
                                                    }
                                                    let _e738 = phi_1183_;
                                                    if (_e731 >= _e76) {
                                                        phi_1272_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e732 {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e740 = (_e300 % 3u);
                                                        let _e741 = (_e299 % 3u);
                                                        let _e742 = (_e301 % 3u);
                                                        if (_e740 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e748 = global_4.member[_e731].member[_e740];
                                                        if (_e741 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e754 = global_4.member[_e731].member[_e741];
                                                        if (_e742 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e760 = global_4.member[_e731].member[_e742];
                                                        let _e762 = (3u + _e740);
                                                        if (_e762 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e768 = global_4.member[_e731].member[_e762];
                                                        let _e769 = (3u + _e741);
                                                        if (_e769 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e775 = global_4.member[_e731].member[_e769];
                                                        let _e776 = (3u + _e742);
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e782 = global_4.member[_e731].member[_e776];
                                                        let _e784 = (6u + _e740);
                                                        if (_e784 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e790 = global_4.member[_e731].member[_e784];
                                                        let _e791 = (6u + _e741);
                                                        if (_e791 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e797 = global_4.member[_e731].member[_e791];
                                                        let _e798 = (6u + _e742);
                                                        if (_e798 < 9u) {
                                                        } else {
                                                            phi_2722_ = true;
                                                            break;
                                                        }
                                                        let _e804 = global_4.member[_e731].member[_e798];
                                                        phi_1272_ = array<array<f32, 3>, 3>(array<f32, 3>(_e748, _e754, _e760), array<f32, 3>(_e768, _e775, _e782), array<f32, 3>(_e790, _e797, _e804));
                                                    }
                                                    let _e808 = phi_1272_;
                                                    let _e816 = (_e808[0][2] - _e401);
                                                    let _e819 = (((_e808[0][0] - _e328) * _e425) - (_e816 * _e353));
                                                    let _e822 = (((_e808[0][1] - _e365) * _e425) - (_e816 * _e389));
                                                    let _e829 = (_e808[1][2] - _e401);
                                                    let _e832 = (((_e808[1][0] - _e328) * _e425) - (_e829 * _e353));
                                                    let _e835 = (((_e808[1][1] - _e365) * _e425) - (_e829 * _e389));
                                                    let _e842 = (_e808[2][2] - _e401);
                                                    let _e845 = (((_e808[2][0] - _e328) * _e425) - (_e842 * _e353));
                                                    let _e848 = (((_e808[2][1] - _e365) * _e425) - (_e842 * _e389));
                                                    let _e849 = (_e845 * _e835);
                                                    let _e850 = (_e848 * _e832);
                                                    let _e851 = (_e819 * _e848);
                                                    let _e852 = (_e822 * _e845);
                                                    let _e853 = (_e832 * _e822);
                                                    let _e854 = (_e835 * _e819);
                                                    let _e859 = (((_e849 >= _e850) && (_e851 >= _e852)) && (_e853 >= _e854));
                                                    if (_e859 || (((_e849 <= _e850) && (_e851 <= _e852)) && (_e853 <= _e854))) {
                                                        let _e866 = select(-1f, 1f, _e859);
                                                        let _e868 = ((_e849 - _e850) * _e866);
                                                        let _e870 = select(0f, _e868, (_e868 > 0f));
                                                        let _e872 = ((_e851 - _e852) * _e866);
                                                        let _e874 = select(0f, _e872, (_e872 > 0f));
                                                        let _e876 = ((_e853 - _e854) * _e866);
                                                        let _e878 = select(0f, _e876, (_e876 > 0f));
                                                        let _e880 = ((_e870 + _e874) + _e878);
                                                        if (_e880 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1838_ = type_28();
                                                            phi_1839_ = true;
                                                        } else {
                                                            let _e883 = select(_e808[1][0], _e808[0][0], (_e808[0][0] < _e808[1][0]));
                                                            let _e887 = select(_e808[1][0], _e808[0][0], (_e808[0][0] > _e808[1][0]));
                                                            let _e891 = select(_e808[1][1], _e808[0][1], (_e808[0][1] < _e808[1][1]));
                                                            let _e895 = select(_e808[1][1], _e808[0][1], (_e808[0][1] > _e808[1][1]));
                                                            let _e899 = select(_e808[1][2], _e808[0][2], (_e808[0][2] < _e808[1][2]));
                                                            let _e903 = select(_e808[1][2], _e808[0][2], (_e808[0][2] > _e808[1][2]));
                                                            let _e908 = ((select(_e808[2][0], _e883, (_e883 < _e808[2][0])) - _e351) * _e356);
                                                            let _e909 = ((select(_e808[2][0], _e887, (_e887 > _e808[2][0])) - _e352) * _e356);
                                                            let _e912 = ((select(_e808[2][1], _e891, (_e891 < _e808[2][1])) - _e387) * _e392);
                                                            let _e913 = ((select(_e808[2][1], _e895, (_e895 > _e808[2][1])) - _e388) * _e392);
                                                            let _e916 = ((select(_e808[2][2], _e899, (_e899 < _e808[2][2])) - _e423) * _e428);
                                                            let _e917 = ((select(_e808[2][2], _e903, (_e903 > _e808[2][2])) - _e424) * _e428);
                                                            let _e919 = select(_e917, _e916, (_e916 < _e917));
                                                            let _e921 = select(_e917, _e916, (_e916 > _e917));
                                                            let _e923 = select(_e909, _e908, (_e908 < _e909));
                                                            let _e925 = select(_e913, _e912, (_e912 < _e913));
                                                            let _e927 = select(_e925, _e923, (_e923 > _e925));
                                                            let _e929 = select(_e919, _e927, (_e927 > _e919));
                                                            let _e931 = select(_e909, _e908, (_e908 > _e909));
                                                            let _e933 = select(_e913, _e912, (_e912 > _e913));
                                                            let _e935 = select(_e933, _e931, (_e931 < _e933));
                                                            let _e937 = select(_e921, _e935, (_e935 < _e921));
                                                            let _e938 = -(_e919);
                                                            let _e944 = select(_e474, _e929, (_e929 > _e474));
                                                            if (_e944 > (_e937 + (select(_e938, _e921, (_e921 > _e938)) * 0.0000019073523f))) {
                                                                phi_1833_ = type_28();
                                                                phi_1834_ = true;
                                                            } else {
                                                                let _e946 = (_e944 > _e709.member);
                                                                if _e946 {
                                                                    phi_1832_ = type_28();
                                                                } else {
                                                                    let _e950 = (_e808[1][0] - _e808[0][0]);
                                                                    let _e951 = (_e808[1][1] - _e808[0][1]);
                                                                    let _e952 = (_e808[1][2] - _e808[0][2]);
                                                                    let _e953 = vec3<f32>(_e950, _e951, _e952);
                                                                    let _e954 = (_e808[2][0] - _e808[1][0]);
                                                                    let _e955 = (_e808[2][1] - _e808[1][1]);
                                                                    let _e956 = (_e808[2][2] - _e808[1][2]);
                                                                    let _e957 = vec3<f32>(_e954, _e955, _e956);
                                                                    let _e958 = (_e808[0][0] - _e808[2][0]);
                                                                    let _e959 = (_e808[0][1] - _e808[2][1]);
                                                                    let _e960 = (_e808[0][2] - _e808[2][2]);
                                                                    let _e961 = vec3<f32>(_e958, _e959, _e960);
                                                                    let _e964 = bitcast<f32>((bitcast<u32>(_e950) & 2147483647u));
                                                                    let _e967 = bitcast<f32>((bitcast<u32>(_e951) & 2147483647u));
                                                                    let _e969 = select(_e967, _e964, (_e964 > _e967));
                                                                    let _e972 = bitcast<f32>((bitcast<u32>(_e952) & 2147483647u));
                                                                    let _e974 = select(_e972, _e969, (_e969 > _e972));
                                                                    let _e977 = bitcast<f32>((bitcast<u32>(_e954) & 2147483647u));
                                                                    let _e980 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                    let _e982 = select(_e980, _e977, (_e977 > _e980));
                                                                    let _e985 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                    let _e987 = select(_e985, _e982, (_e982 > _e985));
                                                                    let _e990 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                    let _e993 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                    let _e995 = select(_e993, _e990, (_e990 > _e993));
                                                                    let _e998 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                    let _e1000 = select(_e998, _e995, (_e995 > _e998));
                                                                    let _e1002 = select(_e987, _e974, (_e974 > _e987));
                                                                    let _e1004 = select(_e1000, _e1002, (_e1002 > _e1000));
                                                                    if (_e974 == _e1004) {
                                                                        phi_1743_ = _e957;
                                                                        phi_1744_ = _e961;
                                                                    } else {
                                                                        let _e1007 = vec3((_e987 == _e1004));
                                                                        phi_1743_ = select(_e953, _e961, _e1007);
                                                                        phi_1744_ = select(_e957, _e953, _e1007);
                                                                    }
                                                                    let _e1011 = phi_1743_;
                                                                    let _e1013 = phi_1744_;
                                                                    let _e1020 = ((_e1011.y * _e1013.z) - (_e1013.y * _e1011.z));
                                                                    let _e1025 = ((_e1011.z * _e1013.x) - (_e1013.z * _e1011.x));
                                                                    let _e1028 = ((_e1011.x * _e1013.y) - (_e1013.x * _e1011.y));
                                                                    if (_e870 >= _e874) {
                                                                        phi_1775_ = select(true, false, (_e870 >= _e878));
                                                                    } else {
                                                                        phi_1775_ = true;
                                                                    }
                                                                    let _e1033 = phi_1775_;
                                                                    if _e1033 {
                                                                        phi_1784_ = select(vec3<f32>(_e808[2][0], _e808[2][1], _e808[2][2]), vec3<f32>(_e808[1][0], _e808[1][1], _e808[1][2]), vec3((_e874 >= _e878)));
                                                                    } else {
                                                                        phi_1784_ = vec3<f32>(_e808[0][0], _e808[0][1], _e808[0][2]);
                                                                    }
                                                                    let _e1038 = phi_1784_;
                                                                    let _e1055 = ((((_e1020 * (_e1038.x - _e328)) + (_e1025 * (_e1038.y - _e365))) + (_e1028 * (_e1038.z - _e401))) / (((_e1020 * _e353) + (_e1025 * _e389)) + (_e1028 * _e425)));
                                                                    let _e1057 = select(_e937, _e1055, (_e1055 < _e937));
                                                                    let _e1059 = select(_e929, _e1057, (_e1057 > _e929));
                                                                    if (_e1059 >= _e474) {
                                                                        let _e1061 = (_e1059 <= _e709.member);
                                                                        if _e1061 {
                                                                            let _e1062 = (1f / _e880);
                                                                            phi_1824_ = type_28(_e1059, (_e874 * _e1062), (_e878 * _e1062), _e738);
                                                                        } else {
                                                                            phi_1824_ = type_28();
                                                                        }
                                                                        let _e1067 = phi_1824_;
                                                                        phi_1826_ = _e1067;
                                                                        phi_1827_ = select(true, false, _e1061);
                                                                    } else {
                                                                        phi_1826_ = type_28();
                                                                        phi_1827_ = true;
                                                                    }
                                                                    let _e1070 = phi_1826_;
                                                                    let _e1072 = phi_1827_;
                                                                    if _e1072 {
                                                                        phi_1831_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1831_ = _e1070;
                                                                    }
                                                                    let _e1074 = phi_1831_;
                                                                    phi_1832_ = _e1074;
                                                                }
                                                                let _e1076 = phi_1832_;
                                                                phi_1833_ = _e1076;
                                                                phi_1834_ = _e946;
                                                            }
                                                            let _e1078 = phi_1833_;
                                                            let _e1080 = phi_1834_;
                                                            phi_1838_ = _e1078;
                                                            phi_1839_ = _e1080;
                                                        }
                                                        let _e1082 = phi_1838_;
                                                        let _e1084 = phi_1839_;
                                                        phi_1843_ = _e1082;
                                                        phi_1844_ = _e1084;
                                                    } else {
                                                        phi_1843_ = type_28();
                                                        phi_1844_ = true;
                                                    }
                                                    let _e1086 = phi_1843_;
                                                    let _e1088 = phi_1844_;
                                                    if _e1088 {
                                                        phi_1848_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1848_ = _e1086;
                                                    }
                                                    let _e1090 = phi_1848_;
                                                    if (_e1090.member_3 != 4294967295u) {
                                                        if (_e738 == _e99) {
                                                            phi_2177_ = false;
                                                        } else {
                                                            let _e1094 = (_e738 < arrayLength((&global_5.member)));
                                                            if _e1094 {
                                                                if _e1094 {
                                                                } else {
                                                                    phi_2722_ = true;
                                                                    break;
                                                                }
                                                                let _e1096 = global_5.member[_e738];
                                                                phi_1871_ = _e1096;
                                                            } else {
                                                                phi_1871_ = 4294967295u;
                                                            }
                                                            let _e1098 = phi_1871_;
                                                            let _e1099 = (_e1098 < arrayLength((&global_6.member)));
                                                            if _e1099 {
                                                                if _e1099 {
                                                                } else {
                                                                    phi_2722_ = true;
                                                                    break;
                                                                }
                                                                let _e1101 = global_6.member[_e1098];
                                                                phi_1885_ = _e1101;
                                                            } else {
                                                                phi_1885_ = 0i;
                                                            }
                                                            let _e1103 = phi_1885_;
                                                            let _e1104 = (_e1103 == 0i);
                                                            if _e1104 {
                                                                phi_2176_ = true;
                                                            } else {
                                                                if _e320 {
                                                                    phi_1906_ = vec3<f32>(_e808[0][0], _e808[0][1], _e808[0][2]);
                                                                } else {
                                                                    if (_e300 == 1u) {
                                                                        phi_1905_ = vec3<f32>(_e808[0][2], _e808[0][0], _e808[0][1]);
                                                                    } else {
                                                                        phi_1905_ = vec3<f32>(_e808[0][1], _e808[0][2], _e808[0][0]);
                                                                    }
                                                                    let _e1109 = phi_1905_;
                                                                    phi_1906_ = _e1109;
                                                                }
                                                                let _e1112 = phi_1906_;
                                                                if _e320 {
                                                                    phi_1923_ = vec3<f32>(_e808[1][0], _e808[1][1], _e808[1][2]);
                                                                } else {
                                                                    if (_e300 == 1u) {
                                                                        phi_1922_ = vec3<f32>(_e808[1][2], _e808[1][0], _e808[1][1]);
                                                                    } else {
                                                                        phi_1922_ = vec3<f32>(_e808[1][1], _e808[1][2], _e808[1][0]);
                                                                    }
                                                                    let _e1117 = phi_1922_;
                                                                    phi_1923_ = _e1117;
                                                                }
                                                                let _e1120 = phi_1923_;
                                                                if _e320 {
                                                                    phi_1940_ = vec3<f32>(_e808[2][0], _e808[2][1], _e808[2][2]);
                                                                } else {
                                                                    if (_e300 == 1u) {
                                                                        phi_1939_ = vec3<f32>(_e808[2][2], _e808[2][0], _e808[2][1]);
                                                                    } else {
                                                                        phi_1939_ = vec3<f32>(_e808[2][1], _e808[2][2], _e808[2][0]);
                                                                    }
                                                                    let _e1125 = phi_1939_;
                                                                    phi_1940_ = _e1125;
                                                                }
                                                                let _e1128 = phi_1940_;
                                                                let _e1131 = (_e1120.x - _e1112.x);
                                                                let _e1134 = (_e1120.y - _e1112.y);
                                                                let _e1137 = (_e1120.z - _e1112.z);
                                                                let _e1139 = (_e1128.x - _e1112.x);
                                                                let _e1141 = (_e1128.y - _e1112.y);
                                                                let _e1143 = (_e1128.z - _e1112.z);
                                                                if (_e167.member_1 == 1u) {
                                                                    phi_1976_ = (vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]) - _e1112);
                                                                } else {
                                                                    phi_1976_ = vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]);
                                                                }
                                                                let _e1158 = phi_1976_;
                                                                let _e1164 = bitcast<f32>((bitcast<u32>((_e1131 * _e1141)) ^ _e167.member_3[0]));
                                                                let _e1168 = bitcast<f32>((bitcast<u32>((_e1134 * _e1139)) ^ _e167.member_3[0]));
                                                                let _e1172 = bitcast<f32>((bitcast<u32>((_e1134 * _e1143)) ^ _e167.member_3[0]));
                                                                let _e1176 = bitcast<f32>((bitcast<u32>((_e1137 * _e1141)) ^ _e167.member_3[0]));
                                                                let _e1180 = bitcast<f32>((bitcast<u32>((_e1137 * _e1139)) ^ _e167.member_3[0]));
                                                                let _e1184 = bitcast<f32>((bitcast<u32>((_e1131 * _e1143)) ^ _e167.member_3[0]));
                                                                let _e1185 = (_e1172 - _e1176);
                                                                let _e1186 = (_e1180 - _e1184);
                                                                let _e1187 = (_e1164 - _e1168);
                                                                let _e1211 = (bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u)));
                                                                let _e1218 = (bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1184) & 2147483647u)));
                                                                let _e1225 = (bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u)));
                                                                if (_e167.member_2 == 0f) {
                                                                    phi_2158_ = 0f;
                                                                } else {
                                                                    let _e1255 = bitcast<f32>((bitcast<u32>(_e1185) & 2147483647u));
                                                                    let _e1258 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                    let _e1261 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                                    let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                    let _e1267 = select(_e1261, _e1258, (_e1258 < _e1261));
                                                                    let _e1271 = select(_e1258, _e1255, (_e1255 < _e1258));
                                                                    let _e1273 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                    let _e1275 = select(_e1261, _e1273, (_e1273 < _e1261));
                                                                    phi_2158_ = bitcast<f32>((bitcast<u32>((_e167.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1263, _e1255, (_e1255 > _e1263)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1275, _e1271, (_e1271 > _e1275)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1267, _e1255, (_e1255 < _e1267)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1211 + _e1218) + _e1225))) ^ _e167.member_3[0]))) * 1.0000005f)) ^ _e167.member_3[0])))) ^ _e167.member_3[0]));
                                                                }
                                                                let _e1302 = phi_2158_;
                                                                phi_2176_ = (_e1104 || !(((((bitcast<f32>((bitcast<u32>((_e1158.x * _e1185)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1158.y * _e1186)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1158.z * _e1187)) ^ _e167.member_3[0]))) * f32(-(_e1103))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1158.x) & 2147483647u)) * _e1211)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1158.y) & 2147483647u)) * _e1218)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1158.z) & 2147483647u)) * _e1225)) ^ _e167.member_3[0]))))) ^ _e167.member_3[0])) + _e1302) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1316 = phi_2176_;
                                                            phi_2177_ = _e1316;
                                                        }
                                                        let _e1318 = phi_2177_;
                                                        if _e1318 {
                                                            phi_2182_ = type_54(_e709.member, true);
                                                        } else {
                                                            phi_2182_ = _e709;
                                                        }
                                                        let _e1323 = phi_2182_;
                                                        phi_2183_ = _e1323;
                                                    } else {
                                                        phi_2183_ = _e709;
                                                    }
                                                    let _e1325 = phi_2183_;
                                                    phi_1137_ = _e1325;
                                                } else {
                                                    phi_1137_ = type_54();
                                                }
                                                let _e1327 = phi_1137_;
                                                continue;
                                                continuing {
                                                    phi_1136_ = _e1327;
                                                    phi_1139_ = _e724;
                                                    phi_2722_ = _e482;
                                                    break if !(_e730);
                                                }
                                            }
                                            let _e1330 = phi_2722_;
                                            phi_2854_ = _e1330;
                                            if _e1330 {
                                                break;
                                            }
                                            let _e1332 = local_2;
                                            phi_2858_ = _e1330;
                                            let _e1510 = local_4;
                                            phi_2638_ = _e1510;
                                            phi_2639_ = _e507;
                                            phi_2640_ = false;
                                            phi_2641_ = select(_e511, 0u, _e1332.member_1);
                                        } else {
                                            if (_e507 >= _e74) {
                                                phi_2244_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e507 < _e74) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                let _e521 = (_e300 % 3u);
                                                if (_e521 < 3u) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                let _e527 = global_3.member[_e507].member[_e521];
                                                let _e533 = (_e299 % 3u);
                                                if (_e533 < 3u) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                let _e539 = global_3.member[_e507].member[_e533];
                                                let _e545 = (_e301 % 3u);
                                                if (_e545 < 3u) {
                                                } else {
                                                    phi_2854_ = true;
                                                    break;
                                                }
                                                let _e551 = global_3.member[_e507].member[_e545];
                                                let _e561 = global_3.member[_e507].member_1;
                                                let _e565 = global_3.member[_e507].member_2;
                                                phi_2244_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e527[0], _e527[1], _e527[2], _e527[3]), vec4<f32>(_e539[0], _e539[1], _e539[2], _e539[3]), vec4<f32>(_e551[0], _e551[1], _e551[2], _e551[3])), _e561, _e565);
                                            }
                                            let _e568 = phi_2244_;
                                            let _e580 = ((_e568.member[0].x - _e351) * _e356);
                                            let _e581 = ((_e568.member[0].y - _e351) * _e356);
                                            let _e582 = ((_e568.member[0].z - _e352) * _e356);
                                            let _e583 = ((_e568.member[0].w - _e352) * _e356);
                                            let _e593 = ((_e568.member[1].x - _e387) * _e392);
                                            let _e594 = ((_e568.member[1].y - _e387) * _e392);
                                            let _e595 = ((_e568.member[1].z - _e388) * _e392);
                                            let _e596 = ((_e568.member[1].w - _e388) * _e392);
                                            let _e606 = ((_e568.member[2].x - _e423) * _e428);
                                            let _e607 = ((_e568.member[2].y - _e423) * _e428);
                                            let _e608 = ((_e568.member[2].z - _e424) * _e428);
                                            let _e609 = ((_e568.member[2].w - _e424) * _e428);
                                            let _e611 = select(_e608, _e606, (_e606 < _e608));
                                            let _e613 = select(_e609, _e607, (_e607 < _e609));
                                            let _e615 = select(_e608, _e606, (_e606 > _e608));
                                            let _e617 = select(_e609, _e607, (_e607 > _e609));
                                            let _e619 = select(_e582, _e580, (_e580 < _e582));
                                            let _e621 = select(_e583, _e581, (_e581 < _e583));
                                            let _e623 = select(_e595, _e593, (_e593 < _e595));
                                            let _e625 = select(_e596, _e594, (_e594 < _e596));
                                            let _e627 = select(_e623, _e619, (_e619 > _e623));
                                            let _e629 = select(_e625, _e621, (_e621 > _e625));
                                            let _e631 = select(_e611, _e627, (_e627 > _e611));
                                            let _e633 = select(_e613, _e629, (_e629 > _e613));
                                            let _e635 = select(_e582, _e580, (_e580 > _e582));
                                            let _e637 = select(_e583, _e581, (_e581 > _e583));
                                            let _e639 = select(_e595, _e593, (_e593 > _e595));
                                            let _e641 = select(_e596, _e594, (_e594 > _e596));
                                            let _e643 = select(_e639, _e635, (_e635 < _e639));
                                            let _e645 = select(_e641, _e637, (_e637 < _e641));
                                            let _e650 = -(_e611);
                                            let _e651 = -(_e613);
                                            let _e658 = (select(_e615, _e643, (_e643 < _e615)) + (select(_e650, _e615, (_e615 > _e650)) * 0.0000019073523f));
                                            let _e659 = (select(_e617, _e645, (_e645 < _e617)) + (select(_e651, _e617, (_e617 > _e651)) * 0.0000019073523f));
                                            let _e661 = select(_e474, _e631, (_e631 > _e474));
                                            let _e663 = select(_e474, _e633, (_e633 > _e474));
                                            let _e668 = (_e661 <= select(_e484.member, _e658, (_e658 < _e484.member)));
                                            let _e669 = (_e663 <= select(_e484.member, _e659, (_e659 < _e484.member)));
                                            let _e670 = (_e661 <= _e663);
                                            if _e668 {
                                                if _e669 {
                                                    if _e670 {
                                                        phi_2588_ = _e568.member_2;
                                                    } else {
                                                        phi_2588_ = _e568.member_1;
                                                    }
                                                    let _e674 = phi_2588_;
                                                    let _e675 = (_e511 % 128u);
                                                    let _e676 = (_e675 < 128u);
                                                    if _e676 {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    local_1[_e675] = _e674;
                                                    if _e676 {
                                                    } else {
                                                        phi_2854_ = true;
                                                        break;
                                                    }
                                                    local[_e675] = select(_e663, _e661, (_e661 > _e663));
                                                    if _e670 {
                                                        phi_2615_ = _e568.member_1;
                                                    } else {
                                                        phi_2615_ = _e568.member_2;
                                                    }
                                                    let _e685 = phi_2615_;
                                                    phi_2616_ = _e685;
                                                    phi_2617_ = (_e511 + 1u);
                                                } else {
                                                    phi_2616_ = u32();
                                                    phi_2617_ = u32();
                                                }
                                                let _e687 = phi_2616_;
                                                let _e689 = phi_2617_;
                                                phi_2619_ = _e687;
                                                phi_2620_ = _e689;
                                                phi_2621_ = select(true, false, _e669);
                                            } else {
                                                phi_2619_ = u32();
                                                phi_2620_ = u32();
                                                phi_2621_ = true;
                                            }
                                            let _e692 = phi_2619_;
                                            let _e694 = phi_2620_;
                                            let _e696 = phi_2621_;
                                            if _e696 {
                                                if _e668 {
                                                    phi_2630_ = _e568.member_1;
                                                } else {
                                                    phi_2630_ = _e568.member_2;
                                                }
                                                let _e700 = phi_2630_;
                                                phi_2635_ = _e700;
                                                phi_2636_ = select(_e669, true, _e668);
                                            } else {
                                                phi_2635_ = _e692;
                                                phi_2636_ = _e509;
                                            }
                                            let _e703 = phi_2635_;
                                            let _e705 = phi_2636_;
                                            phi_2858_ = _e482;
                                            phi_2638_ = _e484;
                                            phi_2639_ = _e703;
                                            phi_2640_ = _e705;
                                            phi_2641_ = select(_e694, _e511, _e696);
                                        }
                                        let _e1336 = phi_2858_;
                                        let _e1338 = phi_2638_;
                                        let _e1340 = phi_2639_;
                                        let _e1342 = phi_2640_;
                                        let _e1344 = phi_2641_;
                                        phi_2857_ = _e1336;
                                        phi_2642_ = _e1338;
                                        phi_2643_ = _e1340;
                                        phi_2644_ = (_e488 - 1u);
                                        phi_2645_ = _e1342;
                                        phi_2646_ = _e1344;
                                    } else {
                                        phi_2857_ = _e482;
                                        phi_2642_ = _e484;
                                        phi_2643_ = _e507;
                                        phi_2644_ = _e488;
                                        phi_2645_ = _e509;
                                        phi_2646_ = _e511;
                                    }
                                    let _e1346 = phi_2857_;
                                    let _e1348 = phi_2642_;
                                    let _e1350 = phi_2643_;
                                    let _e1352 = phi_2644_;
                                    let _e1354 = phi_2645_;
                                    let _e1356 = phi_2646_;
                                    phi_2856_ = _e1346;
                                    phi_2647_ = _e1348;
                                    phi_2648_ = _e1350;
                                    phi_2649_ = _e1352;
                                    phi_2650_ = _e1354;
                                    phi_2651_ = _e1356;
                                } else {
                                    phi_2856_ = _e482;
                                    phi_2647_ = type_54();
                                    phi_2648_ = u32();
                                    phi_2649_ = u32();
                                    phi_2650_ = bool();
                                    phi_2651_ = u32();
                                }
                                let _e1358 = phi_2856_;
                                let _e1360 = phi_2647_;
                                let _e1362 = phi_2648_;
                                let _e1364 = phi_2649_;
                                let _e1366 = phi_2650_;
                                let _e1368 = phi_2651_;
                                phi_2855_ = _e1358;
                                phi_1069_ = _e1360;
                                phi_1072_ = _e1362;
                                phi_1074_ = _e1364;
                                phi_1076_ = _e1366;
                                phi_1078_ = _e1368;
                                phi_2652_ = _e496;
                            } else {
                                phi_2855_ = _e482;
                                phi_1069_ = type_54();
                                phi_1072_ = u32();
                                phi_1074_ = u32();
                                phi_1076_ = bool();
                                phi_1078_ = u32();
                                phi_2652_ = false;
                            }
                            let _e1370 = phi_2855_;
                            let _e1372 = phi_1069_;
                            let _e1374 = phi_1072_;
                            let _e1376 = phi_1074_;
                            let _e1378 = phi_1076_;
                            let _e1380 = phi_1078_;
                            let _e1382 = phi_2652_;
                            continue;
                            continuing {
                                phi_2728_ = _e1370;
                                phi_1068_ = _e1372;
                                phi_1071_ = _e1374;
                                phi_1073_ = _e1376;
                                phi_1075_ = _e1378;
                                phi_1077_ = _e1380;
                                phi_2854_ = _e1370;
                                break if !(_e1382);
                            }
                        }
                        let _e1385 = phi_2854_;
                        if _e1385 {
                            break;
                        }
                        let _e1387 = local_3;
                        if _e1387.member_1 {
                        } else {
                            if _e168 {
                            } else {
                                break;
                            }
                            let _e1391 = global_9.member[_e92];
                            if _e93 {
                            } else {
                                break;
                            }
                            let _e1395 = global_8.member[_e92].member_1;
                            if _e168 {
                            } else {
                                break;
                            }
                            global_9.member[_e92] = type_30(_e1391.member, _e1391.member_1, _e1391.member_2, array<f32, 3>((_e1391.member_3[0] + (_e1395[0] * _e1391.member_1[0])), (_e1391.member_3[1] + (_e1395[1] * _e1391.member_1[1])), (_e1391.member_3[2] + (_e1395[2] * _e1391.member_1[2]))), _e1391.member_4);
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
fn trace_shadows_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
