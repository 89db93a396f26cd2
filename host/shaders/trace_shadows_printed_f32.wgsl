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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_31 {
    member: array<type_29>,
}

struct type_35 {
    member: type_28,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_46 {
    member: f32,
    member_1: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_55 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_60 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_60,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_31;
@group(0) @binding(1) 
var<uniform> global_3: type_48;
@group(0) @binding(2) 
var<uniform> global_4: type_48;
@group(0) @binding(4) 
var<storage> global_5: type_20;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_51;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_67;
@group(0) @binding(7) 
var<storage> global_9: type_37;
@group(0) @binding(3) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_268_: u32;
    var phi_312_: i32;
    var phi_336_: type_41;
    var phi_486_: i32;
    var phi_487_: i32;
    var phi_497_: bool;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_510_: bool;
    var phi_515_: u32;
    var phi_547_: i32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_588_: f32;
    var phi_611_: f32;
    var phi_622_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_654_: f32;
    var phi_677_: f32;
    var phi_688_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_714_: f32;
    var phi_720_: f32;
    var phi_743_: f32;
    var phi_754_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_3163_: bool;
    var phi_928_: type_46;
    var phi_931_: type_62;
    var phi_933_: u32;
    var phi_935_: bool;
    var phi_937_: u32;
    var phi_948_: bool;
    var phi_1034_: type_62;
    var phi_1035_: bool;
    var phi_1036_: u32;
    var phi_2121_: type_55;
    var phi_2953_: type_62;
    var phi_3030_: type_62;
    var phi_3031_: type_62;
    var phi_3032_: u32;
    var phi_3034_: type_62;
    var phi_3035_: u32;
    var phi_3036_: bool;
    var phi_3043_: type_62;
    var phi_3048_: type_62;
    var phi_3049_: bool;
    var phi_1054_: type_46;
    var phi_1057_: type_8;
    var phi_1058_: type_8;
    var phi_1080_: type_8;
    var phi_1101_: u32;
    var phi_1190_: array<array<f32, 3>, 3>;
    var phi_1661_: vec3<f32>;
    var phi_1662_: vec3<f32>;
    var phi_1693_: bool;
    var phi_1702_: vec3<f32>;
    var phi_1742_: type_27;
    var phi_1744_: type_27;
    var phi_1745_: bool;
    var phi_1749_: type_27;
    var phi_1750_: type_27;
    var phi_1751_: type_27;
    var phi_1752_: bool;
    var phi_1756_: type_27;
    var phi_1757_: bool;
    var phi_1761_: type_27;
    var phi_1762_: bool;
    var phi_1766_: type_27;
    var phi_1789_: u32;
    var phi_1803_: i32;
    var phi_1823_: vec3<f32>;
    var phi_1824_: vec3<f32>;
    var phi_1840_: vec3<f32>;
    var phi_1841_: vec3<f32>;
    var phi_1857_: vec3<f32>;
    var phi_1858_: vec3<f32>;
    var phi_1894_: vec3<f32>;
    var phi_2076_: f32;
    var phi_2094_: bool;
    var phi_2095_: bool;
    var phi_2100_: type_46;
    var phi_2101_: type_46;
    var phi_1055_: type_46;
    var phi_3157_: bool;
    var local_10: type_46;
    var phi_3299_: bool;
    var phi_3051_: type_46;
    var phi_3052_: type_62;
    var phi_3053_: bool;
    var phi_3054_: u32;
    var phi_3298_: bool;
    var phi_3055_: type_46;
    var phi_3056_: type_62;
    var phi_3057_: u32;
    var phi_3058_: bool;
    var phi_3059_: u32;
    var phi_3297_: bool;
    var phi_3060_: type_46;
    var phi_3061_: type_62;
    var phi_3062_: u32;
    var phi_3063_: bool;
    var phi_3064_: u32;
    var phi_3296_: bool;
    var phi_929_: type_46;
    var phi_932_: type_62;
    var phi_934_: u32;
    var phi_936_: bool;
    var phi_938_: u32;
    var phi_3065_: bool;
    var phi_3295_: bool;
    var local_11: type_46;
    var local_12: type_46;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e88 = arrayLength((&global_10.member));
            let _e90 = arrayLength((&global_5.member));
            let _e102 = arrayLength((&global_8.member));
            let _e106 = global_4.member[0u][0u];
            let _e110 = global_4.member[0u][1u];
            let _e114 = global_4.member[0u][2u];
            let _e118 = global_4.member[1u][0u];
            let _e122 = global_4.member[1u][1u];
            let _e126 = global_4.member[1u][2u];
            let _e130 = global_4.member[1u][3u];
            let _e134 = (_e85.x + (_e85.y * 2097152u));
            let _e141 = (_e134 < arrayLength((&global_9.member)));
            if _e141 {
                if _e141 {
                } else {
                    break;
                }
                let _e145 = global_9.member[_e134].member_2;
                phi_268_ = _e145;
            } else {
                phi_268_ = 4294967295u;
            }
            let _e147 = phi_268_;
            let _e150 = global_1.member[0u];
            let _e154 = global_3.member[0u][0u];
            let _e158 = global_3.member[0u][1u];
            let _e162 = global_3.member[0u][2u];
            let _e166 = global_3.member[0u][3u];
            let _e170 = global_3.member[1u][0u];
            let _e174 = global_3.member[1u][1u];
            let _e178 = global_3.member[1u][2u];
            let _e182 = global_3.member[1u][3u];
            let _e183 = bitcast<f32>(_e154);
            let _e184 = bitcast<f32>(_e158);
            let _e185 = bitcast<f32>(_e162);
            let _e187 = bitcast<f32>(_e170);
            let _e188 = array<u32, 3>(_e174, _e178, _e182);
            let _e190 = bitcast<i32>(_e150);
            if (_e190 < -126i) {
                phi_312_ = -126i;
            } else {
                phi_312_ = select(_e190, 127i, (_e190 > 127i));
            }
            let _e195 = phi_312_;
            let _e200 = bitcast<f32>((bitcast<u32>((_e195 + 127i)) << bitcast<u32>(23i)));
            let _e206 = bitcast<f32>((bitcast<u32>(((_e190 - _e195) + 127i)) << bitcast<u32>(23i)));
            if (_e166 == 0u) {
                phi_336_ = type_41(array<f32, 3>(_e183, _e184, _e185), _e166, _e187, _e188);
            } else {
                phi_336_ = type_41(array<f32, 3>(((_e183 * _e200) * _e206), ((_e184 * _e200) * _e206), ((_e185 * _e200) * _e206)), _e166, ((_e187 * _e200) * _e206), _e188);
            }
            let _e219 = phi_336_;
            if _e141 {
                let _e220 = (_e134 < arrayLength((&global_2.member)));
                if _e220 {
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e225 = global_9.member[_e134].member.member_1;
                    let _e230 = global_9.member[_e134].member.member_3;
                    if (_e225 <= _e230) {
                        let _e232 = (1u < _e102);
                        if _e232 {
                            if (0u < _e102) {
                            } else {
                                break;
                            }
                            let _e236 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e236 + 1u) < _e236) {
                                if _e232 {
                                } else {
                                    break;
                                }
                                let _e241 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e141 {
                        } else {
                            break;
                        }
                        let _e251 = global_9.member[_e134].member.member_2[0u];
                        let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                        let _e259 = global_9.member[_e134].member.member_2[1u];
                        let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                        let _e267 = global_9.member[_e134].member.member_2[2u];
                        let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                        let _e275 = global_9.member[_e134].member.member[0u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_9.member[_e134].member.member[1u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_9.member[_e134].member.member[2u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e295 = select(_e261, _e253, (_e261 < _e253));
                        let _e297 = select(_e269, _e295, (_e269 < _e295));
                        let _e299 = select(_e277, _e297, (_e277 < _e297));
                        let _e301 = select(_e285, _e299, (_e285 < _e299));
                        let _e303 = select(_e293, _e301, (_e293 < _e301));
                        let _e305 = (bitcast<u32>(_e225) & 2147483647u);
                        let _e314 = (((select(_e305, _e303, (_e305 < _e303)) < 2139095040u) && ((bitcast<u32>(_e230) & 2147483647u) <= 2139095040u)) && (_e297 > 0u));
                        if _e314 {
                            let _e317 = (bitcast<u32>(bitcast<f32>(_e297)) & 2147483647u);
                            if (_e317 >= 8388608u) {
                                phi_486_ = (bitcast<i32>((_e317 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_486_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e317)), 32u, (_e317 == 0u))));
                            }
                            let _e331 = phi_486_;
                            phi_487_ = _e331;
                        } else {
                            phi_487_ = 0i;
                        }
                        let _e333 = phi_487_;
                        let _e334 = (_e253 == _e297);
                        if _e334 {
                            phi_497_ = true;
                        } else {
                            phi_497_ = (_e261 == _e297);
                        }
                        let _e337 = phi_497_;
                        let _e338 = select(1u, 0u, _e334);
                        if _e337 {
                            let _e339 = (_e338 + 1u);
                            phi_507_ = _e339;
                            phi_508_ = _e339;
                            phi_510_ = select(true, false, (_e339 == 2u));
                        } else {
                            phi_507_ = u32();
                            phi_508_ = 0u;
                            phi_510_ = true;
                        }
                        let _e343 = phi_507_;
                        let _e345 = phi_508_;
                        let _e347 = phi_510_;
                        if _e347 {
                            phi_515_ = (_e345 + 1u);
                        } else {
                            phi_515_ = 0u;
                        }
                        let _e351 = phi_515_;
                        let _e352 = select(_e343, _e345, _e347);
                        let _e353 = select(_e338, select(2u, _e338, _e337), _e347);
                        let _e354 = -(_e333);
                        if (_e354 < -126i) {
                            phi_547_ = -126i;
                        } else {
                            phi_547_ = select(_e354, 127i, (_e354 > 127i));
                        }
                        let _e359 = phi_547_;
                        let _e364 = bitcast<f32>((bitcast<u32>((_e359 + 127i)) << bitcast<u32>(23i)));
                        let _e370 = bitcast<f32>((bitcast<u32>(((_e354 - _e359) + 127i)) << bitcast<u32>(23i)));
                        let _e375 = global_9.member[_e134].member.member;
                        let _e376 = (_e352 == 0u);
                        if _e376 {
                            phi_565_ = _e375[0];
                        } else {
                            phi_565_ = _e375[1];
                        }
                        let _e380 = phi_565_;
                        let _e381 = (_e352 == 2u);
                        if _e381 {
                            phi_571_ = _e375[2];
                        } else {
                            phi_571_ = _e380;
                        }
                        let _e384 = phi_571_;
                        let _e385 = global_9.member[_e134].member.member_2;
                        if _e376 {
                            phi_582_ = _e385[0];
                        } else {
                            phi_582_ = _e385[1];
                        }
                        let _e389 = phi_582_;
                        if _e381 {
                            phi_588_ = _e385[2];
                        } else {
                            phi_588_ = _e389;
                        }
                        let _e392 = phi_588_;
                        let _e394 = ((_e392 * _e364) * _e370);
                        let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e398 {
                            let _e402 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) * 0.00000011920929f);
                            phi_611_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                        } else {
                            phi_611_ = 0f;
                        }
                        let _e406 = phi_611_;
                        let _e407 = (_e384 + _e406);
                        let _e408 = (_e384 - _e406);
                        let _e409 = select(_e394, 0f, _e398);
                        if _e398 {
                            phi_622_ = 38685626000000000000000000f;
                        } else {
                            phi_622_ = (1f / _e394);
                        }
                        let _e412 = phi_622_;
                        let _e413 = (_e351 == 0u);
                        if _e413 {
                            phi_631_ = _e375[0];
                        } else {
                            phi_631_ = _e375[1];
                        }
                        let _e417 = phi_631_;
                        let _e418 = (_e351 == 2u);
                        if _e418 {
                            phi_637_ = _e375[2];
                        } else {
                            phi_637_ = _e417;
                        }
                        let _e421 = phi_637_;
                        if _e413 {
                            phi_648_ = _e385[0];
                        } else {
                            phi_648_ = _e385[1];
                        }
                        let _e425 = phi_648_;
                        if _e418 {
                            phi_654_ = _e385[2];
                        } else {
                            phi_654_ = _e425;
                        }
                        let _e428 = phi_654_;
                        let _e430 = ((_e428 * _e364) * _e370);
                        let _e434 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e434 {
                            let _e438 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) * 0.00000011920929f);
                            phi_677_ = select(0.00000000000011368684f, _e438, (_e438 > 0.00000000000011368684f));
                        } else {
                            phi_677_ = 0f;
                        }
                        let _e442 = phi_677_;
                        let _e443 = (_e421 + _e442);
                        let _e444 = (_e421 - _e442);
                        let _e445 = select(_e430, 0f, _e434);
                        if _e434 {
                            phi_688_ = 38685626000000000000000000f;
                        } else {
                            phi_688_ = (1f / _e430);
                        }
                        let _e448 = phi_688_;
                        let _e449 = (_e353 == 0u);
                        if _e449 {
                            phi_697_ = _e375[0];
                        } else {
                            phi_697_ = _e375[1];
                        }
                        let _e453 = phi_697_;
                        let _e454 = (_e353 == 2u);
                        if _e454 {
                            phi_703_ = _e375[2];
                        } else {
                            phi_703_ = _e453;
                        }
                        let _e457 = phi_703_;
                        if _e449 {
                            phi_714_ = _e385[0];
                        } else {
                            phi_714_ = _e385[1];
                        }
                        let _e461 = phi_714_;
                        if _e454 {
                            phi_720_ = _e385[2];
                        } else {
                            phi_720_ = _e461;
                        }
                        let _e464 = phi_720_;
                        let _e466 = ((_e464 * _e364) * _e370);
                        let _e470 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e470 {
                            let _e474 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                            phi_743_ = select(0.00000000000011368684f, _e474, (_e474 > 0.00000000000011368684f));
                        } else {
                            phi_743_ = 0f;
                        }
                        let _e478 = phi_743_;
                        let _e479 = (_e457 + _e478);
                        let _e480 = (_e457 - _e478);
                        let _e481 = select(_e466, 0f, _e470);
                        if _e470 {
                            phi_754_ = 38685626000000000000000000f;
                        } else {
                            phi_754_ = (1f / _e466);
                        }
                        let _e484 = phi_754_;
                        let _e487 = bitcast<f32>((bitcast<u32>(_e384) & 2147483647u));
                        let _e490 = bitcast<f32>((bitcast<u32>(_e421) & 2147483647u));
                        let _e492 = select(_e490, _e487, (_e487 > _e490));
                        let _e495 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                        if (_e314 && (select(_e495, _e492, (_e492 > _e495)) <= 1099511600000f)) {
                            let _e500 = (_e333 / 3i);
                            let _e507 = bitcast<f32>((bitcast<u32>((_e500 + 127i)) << bitcast<u32>(23i)));
                            let _e514 = bitcast<f32>((bitcast<u32>(((_e333 - (2i * _e500)) + 127i)) << bitcast<u32>(23i)));
                            let _e515 = (((_e225 * _e507) * _e507) * _e514);
                            let _e517 = select(340282350000000000000000000000000000000f, _e515, (_e515 < 340282350000000000000000000000000000000f));
                            let _e522 = (((_e230 * _e507) * _e507) * _e514);
                            let _e524 = select(340282350000000000000000000000000000000f, _e522, (_e522 < 340282350000000000000000000000000000000f));
                            phi_854_ = select(-340282350000000000000000000000000000000f, _e524, (_e524 > -340282350000000000000000000000000000000f));
                            phi_855_ = select(-340282350000000000000000000000000000000f, _e517, (_e517 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_854_ = 0f;
                            phi_855_ = 1f;
                        }
                        let _e528 = phi_854_;
                        let _e530 = phi_855_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                        let _e535 = (_e352 % 3u);
                        let _e536 = (_e535 < 3u);
                        if _e536 {
                        } else {
                            break;
                        }
                        let _e538 = local_9[_e535];
                        let _e539 = (_e351 % 3u);
                        let _e540 = (_e539 < 3u);
                        if _e540 {
                        } else {
                            break;
                        }
                        let _e542 = local_9[_e539];
                        let _e543 = (_e353 % 3u);
                        let _e544 = (_e543 < 3u);
                        if _e544 {
                        } else {
                            break;
                        }
                        let _e546 = local_9[_e543];
                        local_8 = array<f32, 3>(bitcast<f32>(_e118), bitcast<f32>(_e122), bitcast<f32>(_e126));
                        if _e536 {
                        } else {
                            break;
                        }
                        let _e550 = local_8[_e535];
                        if _e540 {
                        } else {
                            break;
                        }
                        let _e552 = local_8[_e539];
                        if _e544 {
                        } else {
                            break;
                        }
                        let _e554 = local_8[_e543];
                        phi_3163_ = false;
                        phi_928_ = type_46(_e528, false);
                        phi_931_ = type_62(type_60(array<f32, 3>(_e538, _e542, _e546), array<f32, 3>(_e550, _e552, _e554)), select(0u, 2147483648u, (_e88 == 0u)));
                        phi_933_ = ((3u * _e88) + 1u);
                        phi_935_ = (_e530 <= _e528);
                        phi_937_ = 0u;
                        loop {
                            let _e562 = phi_3163_;
                            let _e564 = phi_928_;
                            let _e566 = phi_931_;
                            let _e568 = phi_933_;
                            let _e570 = phi_935_;
                            let _e572 = phi_937_;
                            local_11 = _e564;
                            if _e570 {
                                phi_948_ = true;
                            } else {
                                phi_948_ = (_e572 > 0u);
                            }
                            let _e575 = phi_948_;
                            if _e575 {
                                let _e576 = (_e568 > 0u);
                                if _e576 {
                                    if _e570 {
                                        phi_1034_ = _e566;
                                        phi_1035_ = _e570;
                                        phi_1036_ = _e572;
                                    } else {
                                        let _e577 = (_e572 - 1u);
                                        let _e578 = (_e577 % 128u);
                                        let _e579 = (_e578 < 128u);
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e581 = local_6[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e583 = local_5[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e585 = local_4[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e587 = local_3[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e590 = local_2[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e592 = local_1[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e594 = local[_e578];
                                        if _e579 {
                                        } else {
                                            phi_3295_ = true;
                                            break;
                                        }
                                        let _e599 = local_7[_e578];
                                        phi_1034_ = type_62(type_60(array<f32, 3>(_e583, _e585, _e587), array<f32, 3>(_e590, _e592, _e594)), _e581);
                                        phi_1035_ = (_e599 <= _e564.member);
                                        phi_1036_ = _e577;
                                    }
                                    let _e603 = phi_1034_;
                                    let _e605 = phi_1035_;
                                    let _e607 = phi_1036_;
                                    if _e605 {
                                        if ((_e603.member_1 & 2147483648u) != 0u) {
                                            phi_1054_ = _e564;
                                            phi_1057_ = type_8(0u, ((_e603.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e959 = phi_1054_;
                                                let _e961 = phi_1057_;
                                                local_10 = _e959;
                                                local_12 = _e959;
                                                if (_e961.member < _e961.member_1) {
                                                    phi_1058_ = type_8((_e961.member + 1u), _e961.member_1);
                                                    phi_1080_ = type_8(1u, _e961.member);
                                                } else {
                                                    phi_1058_ = _e961;
                                                    phi_1080_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e974 = phi_1058_;
                                                let _e976 = phi_1080_;
                                                let _e980 = (bitcast<i32>(_e976.member) != 0i);
                                                if _e980 {
                                                    let _e981 = ((_e603.member_1 & 268435455u) + _e976.member_1);
                                                    let _e982 = (_e981 < _e90);
                                                    if _e982 {
                                                        if _e982 {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e986 = global_5.member[_e981].member_1;
                                                        phi_1101_ = _e986;
                                                    } else {
                                                        phi_1101_ = 4294967295u;
                                                    }
                                                    let _e988 = phi_1101_;
                                                    if (_e981 >= _e90) {
                                                        phi_1190_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e982 {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        if (_e535 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e995 = global_5.member[_e981].member[_e535];
                                                        if (_e539 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1001 = global_5.member[_e981].member[_e539];
                                                        if (_e543 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1007 = global_5.member[_e981].member[_e543];
                                                        let _e1009 = (3u + _e535);
                                                        if (_e1009 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1015 = global_5.member[_e981].member[_e1009];
                                                        let _e1016 = (3u + _e539);
                                                        if (_e1016 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1022 = global_5.member[_e981].member[_e1016];
                                                        let _e1023 = (3u + _e543);
                                                        if (_e1023 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1029 = global_5.member[_e981].member[_e1023];
                                                        let _e1031 = (6u + _e535);
                                                        if (_e1031 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1037 = global_5.member[_e981].member[_e1031];
                                                        let _e1038 = (6u + _e539);
                                                        if (_e1038 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1044 = global_5.member[_e981].member[_e1038];
                                                        let _e1045 = (6u + _e543);
                                                        if (_e1045 < 9u) {
                                                        } else {
                                                            phi_3157_ = true;
                                                            break;
                                                        }
                                                        let _e1051 = global_5.member[_e981].member[_e1045];
                                                        phi_1190_ = array<array<f32, 3>, 3>(array<f32, 3>(_e995, _e1001, _e1007), array<f32, 3>(_e1015, _e1022, _e1029), array<f32, 3>(_e1037, _e1044, _e1051));
                                                    }
                                                    let _e1055 = phi_1190_;
                                                    let _e1063 = (_e1055[0][2] - _e457);
                                                    let _e1066 = (((_e1055[0][0] - _e384) * _e481) - (_e1063 * _e409));
                                                    let _e1069 = (((_e1055[0][1] - _e421) * _e481) - (_e1063 * _e445));
                                                    let _e1076 = (_e1055[1][2] - _e457);
                                                    let _e1079 = (((_e1055[1][0] - _e384) * _e481) - (_e1076 * _e409));
                                                    let _e1082 = (((_e1055[1][1] - _e421) * _e481) - (_e1076 * _e445));
                                                    let _e1089 = (_e1055[2][2] - _e457);
                                                    let _e1092 = (((_e1055[2][0] - _e384) * _e481) - (_e1089 * _e409));
                                                    let _e1095 = (((_e1055[2][1] - _e421) * _e481) - (_e1089 * _e445));
                                                    let _e1096 = (_e1092 * _e1082);
                                                    let _e1097 = (_e1095 * _e1079);
                                                    let _e1098 = (_e1066 * _e1095);
                                                    let _e1099 = (_e1069 * _e1092);
                                                    let _e1100 = (_e1079 * _e1069);
                                                    let _e1101 = (_e1082 * _e1066);
                                                    let _e1106 = (((_e1096 >= _e1097) && (_e1098 >= _e1099)) && (_e1100 >= _e1101));
                                                    if (_e1106 || (((_e1096 <= _e1097) && (_e1098 <= _e1099)) && (_e1100 <= _e1101))) {
                                                        let _e1113 = select(-1f, 1f, _e1106);
                                                        let _e1115 = ((_e1096 - _e1097) * _e1113);
                                                        let _e1117 = select(0f, _e1115, (_e1115 > 0f));
                                                        let _e1119 = ((_e1098 - _e1099) * _e1113);
                                                        let _e1121 = select(0f, _e1119, (_e1119 > 0f));
                                                        let _e1123 = ((_e1100 - _e1101) * _e1113);
                                                        let _e1125 = select(0f, _e1123, (_e1123 > 0f));
                                                        let _e1127 = ((_e1117 + _e1121) + _e1125);
                                                        if (_e1127 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1756_ = type_27();
                                                            phi_1757_ = true;
                                                        } else {
                                                            let _e1130 = select(_e1055[1][0], _e1055[0][0], (_e1055[0][0] < _e1055[1][0]));
                                                            let _e1134 = select(_e1055[1][0], _e1055[0][0], (_e1055[0][0] > _e1055[1][0]));
                                                            let _e1138 = select(_e1055[1][1], _e1055[0][1], (_e1055[0][1] < _e1055[1][1]));
                                                            let _e1142 = select(_e1055[1][1], _e1055[0][1], (_e1055[0][1] > _e1055[1][1]));
                                                            let _e1146 = select(_e1055[1][2], _e1055[0][2], (_e1055[0][2] < _e1055[1][2]));
                                                            let _e1150 = select(_e1055[1][2], _e1055[0][2], (_e1055[0][2] > _e1055[1][2]));
                                                            let _e1155 = ((select(_e1055[2][0], _e1130, (_e1130 < _e1055[2][0])) - _e407) * _e412);
                                                            let _e1156 = ((select(_e1055[2][0], _e1134, (_e1134 > _e1055[2][0])) - _e408) * _e412);
                                                            let _e1159 = ((select(_e1055[2][1], _e1138, (_e1138 < _e1055[2][1])) - _e443) * _e448);
                                                            let _e1160 = ((select(_e1055[2][1], _e1142, (_e1142 > _e1055[2][1])) - _e444) * _e448);
                                                            let _e1163 = ((select(_e1055[2][2], _e1146, (_e1146 < _e1055[2][2])) - _e479) * _e484);
                                                            let _e1164 = ((select(_e1055[2][2], _e1150, (_e1150 > _e1055[2][2])) - _e480) * _e484);
                                                            let _e1166 = select(_e1164, _e1163, (_e1163 < _e1164));
                                                            let _e1168 = select(_e1164, _e1163, (_e1163 > _e1164));
                                                            let _e1170 = select(_e1156, _e1155, (_e1155 < _e1156));
                                                            let _e1172 = select(_e1160, _e1159, (_e1159 < _e1160));
                                                            let _e1174 = select(_e1172, _e1170, (_e1170 > _e1172));
                                                            let _e1176 = select(_e1166, _e1174, (_e1174 > _e1166));
                                                            let _e1178 = select(_e1156, _e1155, (_e1155 > _e1156));
                                                            let _e1180 = select(_e1160, _e1159, (_e1159 > _e1160));
                                                            let _e1182 = select(_e1180, _e1178, (_e1178 < _e1180));
                                                            let _e1184 = select(_e1168, _e1182, (_e1182 < _e1168));
                                                            let _e1185 = -(_e1166);
                                                            let _e1191 = select(_e530, _e1176, (_e1176 > _e530));
                                                            if (_e1191 > (_e1184 + (select(_e1185, _e1168, (_e1168 > _e1185)) * 0.0000019073523f))) {
                                                                phi_1751_ = type_27();
                                                                phi_1752_ = true;
                                                            } else {
                                                                let _e1193 = (_e1191 > _e959.member);
                                                                if _e1193 {
                                                                    phi_1750_ = type_27();
                                                                } else {
                                                                    let _e1197 = (_e1055[1][0] - _e1055[0][0]);
                                                                    let _e1198 = (_e1055[1][1] - _e1055[0][1]);
                                                                    let _e1199 = (_e1055[1][2] - _e1055[0][2]);
                                                                    let _e1200 = vec3<f32>(_e1197, _e1198, _e1199);
                                                                    let _e1201 = (_e1055[2][0] - _e1055[1][0]);
                                                                    let _e1202 = (_e1055[2][1] - _e1055[1][1]);
                                                                    let _e1203 = (_e1055[2][2] - _e1055[1][2]);
                                                                    let _e1204 = vec3<f32>(_e1201, _e1202, _e1203);
                                                                    let _e1205 = (_e1055[0][0] - _e1055[2][0]);
                                                                    let _e1206 = (_e1055[0][1] - _e1055[2][1]);
                                                                    let _e1207 = (_e1055[0][2] - _e1055[2][2]);
                                                                    let _e1208 = vec3<f32>(_e1205, _e1206, _e1207);
                                                                    let _e1211 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                    let _e1214 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                    let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                                    let _e1219 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                    let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                                    let _e1224 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                    let _e1227 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                    let _e1229 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                                    let _e1232 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                    let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                    let _e1237 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                    let _e1240 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                    let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                    let _e1245 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                    let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                    let _e1249 = select(_e1234, _e1221, (_e1221 > _e1234));
                                                                    let _e1251 = select(_e1247, _e1249, (_e1249 > _e1247));
                                                                    if (_e1221 == _e1251) {
                                                                        phi_1661_ = _e1204;
                                                                        phi_1662_ = _e1208;
                                                                    } else {
                                                                        let _e1254 = vec3((_e1234 == _e1251));
                                                                        phi_1661_ = select(_e1200, _e1208, _e1254);
                                                                        phi_1662_ = select(_e1204, _e1200, _e1254);
                                                                    }
                                                                    let _e1258 = phi_1661_;
                                                                    let _e1260 = phi_1662_;
                                                                    let _e1267 = ((_e1258.y * _e1260.z) - (_e1260.y * _e1258.z));
                                                                    let _e1272 = ((_e1258.z * _e1260.x) - (_e1260.z * _e1258.x));
                                                                    let _e1275 = ((_e1258.x * _e1260.y) - (_e1260.x * _e1258.y));
                                                                    if (_e1117 >= _e1121) {
                                                                        phi_1693_ = select(true, false, (_e1117 >= _e1125));
                                                                    } else {
                                                                        phi_1693_ = true;
                                                                    }
                                                                    let _e1280 = phi_1693_;
                                                                    if _e1280 {
                                                                        phi_1702_ = select(vec3<f32>(_e1055[2][0], _e1055[2][1], _e1055[2][2]), vec3<f32>(_e1055[1][0], _e1055[1][1], _e1055[1][2]), vec3((_e1121 >= _e1125)));
                                                                    } else {
                                                                        phi_1702_ = vec3<f32>(_e1055[0][0], _e1055[0][1], _e1055[0][2]);
                                                                    }
                                                                    let _e1285 = phi_1702_;
                                                                    let _e1302 = ((((_e1267 * (_e1285.x - _e384)) + (_e1272 * (_e1285.y - _e421))) + (_e1275 * (_e1285.z - _e457))) / (((_e1267 * _e409) + (_e1272 * _e445)) + (_e1275 * _e481)));
                                                                    let _e1304 = select(_e1184, _e1302, (_e1302 < _e1184));
                                                                    let _e1306 = select(_e1176, _e1304, (_e1304 > _e1176));
                                                                    if (_e1306 >= _e530) {
                                                                        let _e1308 = (_e1306 <= _e959.member);
                                                                        if _e1308 {
                                                                            let _e1309 = (1f / _e1127);
                                                                            phi_1742_ = type_27(_e1306, (_e1121 * _e1309), (_e1125 * _e1309), _e988);
                                                                        } else {
                                                                            phi_1742_ = type_27();
                                                                        }
                                                                        let _e1314 = phi_1742_;
                                                                        phi_1744_ = _e1314;
                                                                        phi_1745_ = select(true, false, _e1308);
                                                                    } else {
                                                                        phi_1744_ = type_27();
                                                                        phi_1745_ = true;
                                                                    }
                                                                    let _e1317 = phi_1744_;
                                                                    let _e1319 = phi_1745_;
                                                                    if _e1319 {
                                                                        phi_1749_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1749_ = _e1317;
                                                                    }
                                                                    let _e1321 = phi_1749_;
                                                                    phi_1750_ = _e1321;
                                                                }
                                                                let _e1323 = phi_1750_;
                                                                phi_1751_ = _e1323;
                                                                phi_1752_ = _e1193;
                                                            }
                                                            let _e1325 = phi_1751_;
                                                            let _e1327 = phi_1752_;
                                                            phi_1756_ = _e1325;
                                                            phi_1757_ = _e1327;
                                                        }
                                                        let _e1329 = phi_1756_;
                                                        let _e1331 = phi_1757_;
                                                        phi_1761_ = _e1329;
                                                        phi_1762_ = _e1331;
                                                    } else {
                                                        phi_1761_ = type_27();
                                                        phi_1762_ = true;
                                                    }
                                                    let _e1333 = phi_1761_;
                                                    let _e1335 = phi_1762_;
                                                    if _e1335 {
                                                        phi_1766_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1766_ = _e1333;
                                                    }
                                                    let _e1337 = phi_1766_;
                                                    if (_e1337.member_3 != 4294967295u) {
                                                        if (_e988 == _e147) {
                                                            phi_2095_ = false;
                                                        } else {
                                                            let _e1341 = (_e988 < arrayLength((&global_6.member)));
                                                            if _e1341 {
                                                                if _e1341 {
                                                                } else {
                                                                    phi_3157_ = true;
                                                                    break;
                                                                }
                                                                let _e1343 = global_6.member[_e988];
                                                                phi_1789_ = _e1343;
                                                            } else {
                                                                phi_1789_ = 4294967295u;
                                                            }
                                                            let _e1345 = phi_1789_;
                                                            let _e1346 = (_e1345 < arrayLength((&global_7.member)));
                                                            if _e1346 {
                                                                if _e1346 {
                                                                } else {
                                                                    phi_3157_ = true;
                                                                    break;
                                                                }
                                                                let _e1348 = global_7.member[_e1345];
                                                                phi_1803_ = _e1348;
                                                            } else {
                                                                phi_1803_ = 0i;
                                                            }
                                                            let _e1350 = phi_1803_;
                                                            let _e1351 = (_e1350 == 0i);
                                                            if _e1351 {
                                                                phi_2094_ = true;
                                                            } else {
                                                                if _e376 {
                                                                    phi_1824_ = vec3<f32>(_e1055[0][0], _e1055[0][1], _e1055[0][2]);
                                                                } else {
                                                                    if (_e352 == 1u) {
                                                                        phi_1823_ = vec3<f32>(_e1055[0][2], _e1055[0][0], _e1055[0][1]);
                                                                    } else {
                                                                        phi_1823_ = vec3<f32>(_e1055[0][1], _e1055[0][2], _e1055[0][0]);
                                                                    }
                                                                    let _e1356 = phi_1823_;
                                                                    phi_1824_ = _e1356;
                                                                }
                                                                let _e1359 = phi_1824_;
                                                                if _e376 {
                                                                    phi_1841_ = vec3<f32>(_e1055[1][0], _e1055[1][1], _e1055[1][2]);
                                                                } else {
                                                                    if (_e352 == 1u) {
                                                                        phi_1840_ = vec3<f32>(_e1055[1][2], _e1055[1][0], _e1055[1][1]);
                                                                    } else {
                                                                        phi_1840_ = vec3<f32>(_e1055[1][1], _e1055[1][2], _e1055[1][0]);
                                                                    }
                                                                    let _e1364 = phi_1840_;
                                                                    phi_1841_ = _e1364;
                                                                }
                                                                let _e1367 = phi_1841_;
                                                                if _e376 {
                                                                    phi_1858_ = vec3<f32>(_e1055[2][0], _e1055[2][1], _e1055[2][2]);
                                                                } else {
                                                                    if (_e352 == 1u) {
                                                                        phi_1857_ = vec3<f32>(_e1055[2][2], _e1055[2][0], _e1055[2][1]);
                                                                    } else {
                                                                        phi_1857_ = vec3<f32>(_e1055[2][1], _e1055[2][2], _e1055[2][0]);
                                                                    }
                                                                    let _e1372 = phi_1857_;
                                                                    phi_1858_ = _e1372;
                                                                }
                                                                let _e1375 = phi_1858_;
                                                                let _e1378 = (_e1367.x - _e1359.x);
                                                                let _e1381 = (_e1367.y - _e1359.y);
                                                                let _e1384 = (_e1367.z - _e1359.z);
                                                                let _e1386 = (_e1375.x - _e1359.x);
                                                                let _e1388 = (_e1375.y - _e1359.y);
                                                                let _e1390 = (_e1375.z - _e1359.z);
                                                                if (_e219.member_1 == 1u) {
                                                                    phi_1894_ = (vec3<f32>(_e219.member[0], _e219.member[1], _e219.member[2]) - _e1359);
                                                                } else {
                                                                    phi_1894_ = vec3<f32>(_e219.member[0], _e219.member[1], _e219.member[2]);
                                                                }
                                                                let _e1405 = phi_1894_;
                                                                let _e1411 = bitcast<f32>((bitcast<u32>((_e1378 * _e1388)) ^ _e219.member_3[0]));
                                                                let _e1415 = bitcast<f32>((bitcast<u32>((_e1381 * _e1386)) ^ _e219.member_3[0]));
                                                                let _e1419 = bitcast<f32>((bitcast<u32>((_e1381 * _e1390)) ^ _e219.member_3[0]));
                                                                let _e1423 = bitcast<f32>((bitcast<u32>((_e1384 * _e1388)) ^ _e219.member_3[0]));
                                                                let _e1427 = bitcast<f32>((bitcast<u32>((_e1384 * _e1386)) ^ _e219.member_3[0]));
                                                                let _e1431 = bitcast<f32>((bitcast<u32>((_e1378 * _e1390)) ^ _e219.member_3[0]));
                                                                let _e1432 = (_e1419 - _e1423);
                                                                let _e1433 = (_e1427 - _e1431);
                                                                let _e1434 = (_e1411 - _e1415);
                                                                let _e1458 = (bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u)));
                                                                let _e1465 = (bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u)));
                                                                let _e1472 = (bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u)));
                                                                if (_e219.member_2 == 0f) {
                                                                    phi_2076_ = 0f;
                                                                } else {
                                                                    let _e1502 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                    let _e1505 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                    let _e1508 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                    let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                    let _e1514 = select(_e1508, _e1505, (_e1505 < _e1508));
                                                                    let _e1518 = select(_e1505, _e1502, (_e1502 < _e1505));
                                                                    let _e1520 = select(_e1505, _e1502, (_e1502 > _e1505));
                                                                    let _e1522 = select(_e1508, _e1520, (_e1520 < _e1508));
                                                                    phi_2076_ = bitcast<f32>((bitcast<u32>((_e219.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1510, _e1502, (_e1502 > _e1510)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1522, _e1518, (_e1518 > _e1522)))) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1514, _e1502, (_e1502 < _e1514)))) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1458 + _e1465) + _e1472))) ^ _e219.member_3[0]))) * 1.0000005f)) ^ _e219.member_3[0])))) ^ _e219.member_3[0]));
                                                                }
                                                                let _e1549 = phi_2076_;
                                                                phi_2094_ = (_e1351 || !(((((bitcast<f32>((bitcast<u32>((_e1405.x * _e1432)) ^ _e219.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1405.y * _e1433)) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1405.z * _e1434)) ^ _e219.member_3[0]))) * f32(-(_e1350))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.x) & 2147483647u)) * _e1458)) ^ _e219.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.y) & 2147483647u)) * _e1465)) ^ _e219.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.z) & 2147483647u)) * _e1472)) ^ _e219.member_3[0]))))) ^ _e219.member_3[0])) + _e1549) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1563 = phi_2094_;
                                                            phi_2095_ = _e1563;
                                                        }
                                                        let _e1565 = phi_2095_;
                                                        if _e1565 {
                                                            phi_2100_ = type_46(_e959.member, true);
                                                        } else {
                                                            phi_2100_ = _e959;
                                                        }
                                                        let _e1570 = phi_2100_;
                                                        phi_2101_ = _e1570;
                                                    } else {
                                                        phi_2101_ = _e959;
                                                    }
                                                    let _e1572 = phi_2101_;
                                                    phi_1055_ = _e1572;
                                                } else {
                                                    phi_1055_ = type_46();
                                                }
                                                let _e1574 = phi_1055_;
                                                continue;
                                                continuing {
                                                    phi_1054_ = _e1574;
                                                    phi_1057_ = _e974;
                                                    phi_3157_ = _e562;
                                                    break if !(_e980);
                                                }
                                            }
                                            let _e1577 = phi_3157_;
                                            phi_3295_ = _e1577;
                                            if _e1577 {
                                                break;
                                            }
                                            let _e1579 = local_10;
                                            phi_3299_ = _e1577;
                                            let _e1759 = local_12;
                                            phi_3051_ = _e1759;
                                            phi_3052_ = _e603;
                                            phi_3053_ = false;
                                            phi_3054_ = select(_e607, 0u, _e1579.member_1);
                                        } else {
                                            let _e616 = (_e603.member_1 < _e88);
                                            if _e616 {
                                                if _e616 {
                                                } else {
                                                    phi_3295_ = true;
                                                    break;
                                                }
                                                let _e618 = global_10.member[_e603.member_1];
                                                phi_2121_ = _e618;
                                            } else {
                                                phi_2121_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e620 = phi_2121_;
                                            let _e635 = ((10u * _e352) & 31u);
                                            let _e638 = ((_e620.member[0] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e643 = bitcast<f32>((bitcast<u32>(((_e603.member.member_1[0] - _e603.member.member[0]) * 0.0009775171f)) ^ _e130));
                                            let _e649 = (_e603.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e638) * _e643)) ^ _e130)));
                                            let _e653 = select(select(_e603.member.member_1[0], _e649, (_e649 < _e603.member.member_1[0])), _e603.member.member_1[0], (_e638 == 1023u));
                                            let _e655 = ((10u * _e351) & 31u);
                                            let _e658 = ((_e620.member[0] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e663 = bitcast<f32>((bitcast<u32>(((_e603.member.member_1[1] - _e603.member.member[1]) * 0.0009775171f)) ^ _e130));
                                            let _e669 = (_e603.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e658) * _e663)) ^ _e130)));
                                            let _e673 = select(select(_e603.member.member_1[1], _e669, (_e669 < _e603.member.member_1[1])), _e603.member.member_1[1], (_e658 == 1023u));
                                            let _e675 = ((10u * _e353) & 31u);
                                            let _e678 = ((_e620.member[0] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e683 = bitcast<f32>((bitcast<u32>(((_e603.member.member_1[2] - _e603.member.member[2]) * 0.0009775171f)) ^ _e130));
                                            let _e689 = (_e603.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e683)) ^ _e130)));
                                            let _e693 = select(select(_e603.member.member_1[2], _e689, (_e689 < _e603.member.member_1[2])), _e603.member.member_1[2], (_e678 == 1023u));
                                            let _e696 = ((_e620.member[1] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e702 = (_e603.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e696) * _e643)) ^ _e130)));
                                            let _e706 = select(select(_e603.member.member_1[0], _e702, (_e702 < _e603.member.member_1[0])), _e603.member.member_1[0], (_e696 == 1023u));
                                            let _e709 = ((_e620.member[1] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e715 = (_e603.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e709) * _e663)) ^ _e130)));
                                            let _e719 = select(select(_e603.member.member_1[1], _e715, (_e715 < _e603.member.member_1[1])), _e603.member.member_1[1], (_e709 == 1023u));
                                            let _e722 = ((_e620.member[1] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e728 = (_e603.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e722) * _e683)) ^ _e130)));
                                            let _e732 = select(select(_e603.member.member_1[2], _e728, (_e728 < _e603.member.member_1[2])), _e603.member.member_1[2], (_e722 == 1023u));
                                            let _e738 = ((_e620.member_1[0] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e744 = (_e603.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e738) * _e643)) ^ _e130)));
                                            let _e748 = select(select(_e603.member.member_1[0], _e744, (_e744 < _e603.member.member_1[0])), _e603.member.member_1[0], (_e738 == 1023u));
                                            let _e751 = ((_e620.member_1[0] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e757 = (_e603.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e751) * _e663)) ^ _e130)));
                                            let _e761 = select(select(_e603.member.member_1[1], _e757, (_e757 < _e603.member.member_1[1])), _e603.member.member_1[1], (_e751 == 1023u));
                                            let _e764 = ((_e620.member_1[0] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e770 = (_e603.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e764) * _e683)) ^ _e130)));
                                            let _e774 = select(select(_e603.member.member_1[2], _e770, (_e770 < _e603.member.member_1[2])), _e603.member.member_1[2], (_e764 == 1023u));
                                            let _e777 = ((_e620.member_1[1] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e783 = (_e603.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e777) * _e643)) ^ _e130)));
                                            let _e787 = select(select(_e603.member.member_1[0], _e783, (_e783 < _e603.member.member_1[0])), _e603.member.member_1[0], (_e777 == 1023u));
                                            let _e790 = ((_e620.member_1[1] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e796 = (_e603.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e790) * _e663)) ^ _e130)));
                                            let _e800 = select(select(_e603.member.member_1[1], _e796, (_e796 < _e603.member.member_1[1])), _e603.member.member_1[1], (_e790 == 1023u));
                                            let _e803 = ((_e620.member_1[1] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e809 = (_e603.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e803) * _e683)) ^ _e130)));
                                            let _e813 = select(select(_e603.member.member_1[2], _e809, (_e809 < _e603.member.member_1[2])), _e603.member.member_1[2], (_e803 == 1023u));
                                            let _e818 = type_62(type_60(array<f32, 3>(_e653, _e673, _e693), array<f32, 3>(_e706, _e719, _e732)), _e620.member_2);
                                            let _e823 = type_62(type_60(array<f32, 3>(_e748, _e761, _e774), array<f32, 3>(_e787, _e800, _e813)), _e620.member_3);
                                            let _e829 = ((_e653 - _e407) * _e412);
                                            let _e830 = ((_e748 - _e407) * _e412);
                                            let _e831 = ((_e706 - _e408) * _e412);
                                            let _e832 = ((_e787 - _e408) * _e412);
                                            let _e837 = ((_e673 - _e443) * _e448);
                                            let _e838 = ((_e761 - _e443) * _e448);
                                            let _e839 = ((_e719 - _e444) * _e448);
                                            let _e840 = ((_e800 - _e444) * _e448);
                                            let _e845 = ((_e693 - _e479) * _e484);
                                            let _e846 = ((_e774 - _e479) * _e484);
                                            let _e847 = ((_e732 - _e480) * _e484);
                                            let _e848 = ((_e813 - _e480) * _e484);
                                            let _e850 = select(_e847, _e845, (_e845 < _e847));
                                            let _e852 = select(_e848, _e846, (_e846 < _e848));
                                            let _e854 = select(_e847, _e845, (_e845 > _e847));
                                            let _e856 = select(_e848, _e846, (_e846 > _e848));
                                            let _e858 = select(_e831, _e829, (_e829 < _e831));
                                            let _e860 = select(_e832, _e830, (_e830 < _e832));
                                            let _e862 = select(_e839, _e837, (_e837 < _e839));
                                            let _e864 = select(_e840, _e838, (_e838 < _e840));
                                            let _e866 = select(_e862, _e858, (_e858 > _e862));
                                            let _e868 = select(_e864, _e860, (_e860 > _e864));
                                            let _e870 = select(_e850, _e866, (_e866 > _e850));
                                            let _e872 = select(_e852, _e868, (_e868 > _e852));
                                            let _e874 = select(_e831, _e829, (_e829 > _e831));
                                            let _e876 = select(_e832, _e830, (_e830 > _e832));
                                            let _e878 = select(_e839, _e837, (_e837 > _e839));
                                            let _e880 = select(_e840, _e838, (_e838 > _e840));
                                            let _e882 = select(_e878, _e874, (_e874 < _e878));
                                            let _e884 = select(_e880, _e876, (_e876 < _e880));
                                            let _e889 = -(_e850);
                                            let _e890 = -(_e852);
                                            let _e897 = (select(_e854, _e882, (_e882 < _e854)) + (select(_e889, _e854, (_e854 > _e889)) * 0.0000019073523f));
                                            let _e898 = (select(_e856, _e884, (_e884 < _e856)) + (select(_e890, _e856, (_e856 > _e890)) * 0.0000019073523f));
                                            let _e900 = select(_e530, _e870, (_e870 > _e530));
                                            let _e902 = select(_e530, _e872, (_e872 > _e530));
                                            let _e907 = (_e900 <= select(_e564.member, _e897, (_e897 < _e564.member)));
                                            let _e908 = (_e902 <= select(_e564.member, _e898, (_e898 < _e564.member)));
                                            let _e909 = (_e900 <= _e902);
                                            if _e907 {
                                                if _e908 {
                                                    if _e909 {
                                                        phi_2953_ = _e823;
                                                    } else {
                                                        phi_2953_ = _e818;
                                                    }
                                                    let _e911 = phi_2953_;
                                                    let _e919 = (_e607 % 128u);
                                                    let _e920 = (_e919 < 128u);
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_6[_e919] = _e911.member_1;
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_5[_e919] = _e911.member.member[0];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_4[_e919] = _e911.member.member[1];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_3[_e919] = _e911.member.member[2];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_2[_e919] = _e911.member.member_1[0];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_1[_e919] = _e911.member.member_1[1];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local[_e919] = _e911.member.member_1[2];
                                                    if _e920 {
                                                    } else {
                                                        phi_3295_ = true;
                                                        break;
                                                    }
                                                    local_7[_e919] = select(_e902, _e900, (_e900 > _e902));
                                                    if _e909 {
                                                        phi_3030_ = _e818;
                                                    } else {
                                                        phi_3030_ = _e823;
                                                    }
                                                    let _e937 = phi_3030_;
                                                    phi_3031_ = _e937;
                                                    phi_3032_ = (_e607 + 1u);
                                                } else {
                                                    phi_3031_ = type_62();
                                                    phi_3032_ = u32();
                                                }
                                                let _e939 = phi_3031_;
                                                let _e941 = phi_3032_;
                                                phi_3034_ = _e939;
                                                phi_3035_ = _e941;
                                                phi_3036_ = select(true, false, _e908);
                                            } else {
                                                phi_3034_ = type_62();
                                                phi_3035_ = u32();
                                                phi_3036_ = true;
                                            }
                                            let _e944 = phi_3034_;
                                            let _e946 = phi_3035_;
                                            let _e948 = phi_3036_;
                                            if _e948 {
                                                if _e907 {
                                                    phi_3043_ = _e818;
                                                } else {
                                                    phi_3043_ = _e823;
                                                }
                                                let _e950 = phi_3043_;
                                                phi_3048_ = _e950;
                                                phi_3049_ = select(_e908, true, _e907);
                                            } else {
                                                phi_3048_ = _e944;
                                                phi_3049_ = _e605;
                                            }
                                            let _e953 = phi_3048_;
                                            let _e955 = phi_3049_;
                                            phi_3299_ = _e562;
                                            phi_3051_ = _e564;
                                            phi_3052_ = _e953;
                                            phi_3053_ = _e955;
                                            phi_3054_ = select(_e946, _e607, _e948);
                                        }
                                        let _e1583 = phi_3299_;
                                        let _e1585 = phi_3051_;
                                        let _e1587 = phi_3052_;
                                        let _e1589 = phi_3053_;
                                        let _e1591 = phi_3054_;
                                        phi_3298_ = _e1583;
                                        phi_3055_ = _e1585;
                                        phi_3056_ = _e1587;
                                        phi_3057_ = (_e568 - 1u);
                                        phi_3058_ = _e1589;
                                        phi_3059_ = _e1591;
                                    } else {
                                        phi_3298_ = _e562;
                                        phi_3055_ = _e564;
                                        phi_3056_ = _e603;
                                        phi_3057_ = _e568;
                                        phi_3058_ = _e605;
                                        phi_3059_ = _e607;
                                    }
                                    let _e1593 = phi_3298_;
                                    let _e1595 = phi_3055_;
                                    let _e1597 = phi_3056_;
                                    let _e1599 = phi_3057_;
                                    let _e1601 = phi_3058_;
                                    let _e1603 = phi_3059_;
                                    phi_3297_ = _e1593;
                                    phi_3060_ = _e1595;
                                    phi_3061_ = _e1597;
                                    phi_3062_ = _e1599;
                                    phi_3063_ = _e1601;
                                    phi_3064_ = _e1603;
                                } else {
                                    phi_3297_ = _e562;
                                    phi_3060_ = type_46();
                                    phi_3061_ = type_62();
                                    phi_3062_ = u32();
                                    phi_3063_ = bool();
                                    phi_3064_ = u32();
                                }
                                let _e1605 = phi_3297_;
                                let _e1607 = phi_3060_;
                                let _e1609 = phi_3061_;
                                let _e1611 = phi_3062_;
                                let _e1613 = phi_3063_;
                                let _e1615 = phi_3064_;
                                phi_3296_ = _e1605;
                                phi_929_ = _e1607;
                                phi_932_ = _e1609;
                                phi_934_ = _e1611;
                                phi_936_ = _e1613;
                                phi_938_ = _e1615;
                                phi_3065_ = _e576;
                            } else {
                                phi_3296_ = _e562;
                                phi_929_ = type_46();
                                phi_932_ = type_62();
                                phi_934_ = u32();
                                phi_936_ = bool();
                                phi_938_ = u32();
                                phi_3065_ = false;
                            }
                            let _e1617 = phi_3296_;
                            let _e1619 = phi_929_;
                            let _e1621 = phi_932_;
                            let _e1623 = phi_934_;
                            let _e1625 = phi_936_;
                            let _e1627 = phi_938_;
                            let _e1629 = phi_3065_;
                            continue;
                            continuing {
                                phi_3163_ = _e1617;
                                phi_928_ = _e1619;
                                phi_931_ = _e1621;
                                phi_933_ = _e1623;
                                phi_935_ = _e1625;
                                phi_937_ = _e1627;
                                phi_3295_ = _e1617;
                                break if !(_e1629);
                            }
                        }
                        let _e1632 = phi_3295_;
                        if _e1632 {
                            break;
                        }
                        let _e1634 = local_11;
                        if _e1634.member_1 {
                        } else {
                            if _e220 {
                            } else {
                                break;
                            }
                            let _e1638 = global_2.member[_e134];
                            if _e141 {
                            } else {
                                break;
                            }
                            let _e1642 = global_9.member[_e134].member_1;
                            if _e220 {
                            } else {
                                break;
                            }
                            global_2.member[_e134] = type_29(_e1638.member, _e1638.member_1, _e1638.member_2, array<f32, 3>((_e1638.member_3[0] + (_e1642[0] * _e1638.member_1[0])), (_e1638.member_3[1] + (_e1642[1] * _e1638.member_1[1])), (_e1638.member_3[2] + (_e1642[2] * _e1638.member_1[2]))), _e1638.member_4);
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
fn trace_shadows_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
