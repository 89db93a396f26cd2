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
    var phi_321_: u32;
    var phi_365_: i32;
    var phi_389_: type_41;
    var phi_539_: i32;
    var phi_540_: i32;
    var phi_550_: bool;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_563_: bool;
    var phi_568_: u32;
    var phi_600_: i32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_664_: f32;
    var phi_675_: f32;
    var phi_684_: f32;
    var phi_690_: f32;
    var phi_701_: f32;
    var phi_707_: f32;
    var phi_730_: f32;
    var phi_741_: f32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_767_: f32;
    var phi_773_: f32;
    var phi_796_: f32;
    var phi_807_: f32;
    var phi_907_: f32;
    var phi_908_: f32;
    var phi_3640_: bool;
    var phi_997_: type_47;
    var phi_1000_: type_63;
    var phi_1002_: u32;
    var phi_1004_: bool;
    var phi_1006_: u32;
    var phi_1017_: bool;
    var phi_1103_: type_63;
    var phi_1104_: bool;
    var phi_1105_: u32;
    var phi_2893_: u32;
    var phi_2894_: u32;
    var phi_2904_: u32;
    var phi_2906_: u32;
    var phi_2907_: bool;
    var phi_2927_: u32;
    var phi_2928_: u32;
    var phi_2932_: type_64;
    var phi_3276_: type_63;
    var phi_3353_: type_63;
    var phi_3354_: type_63;
    var phi_3355_: u32;
    var phi_3357_: type_63;
    var phi_3358_: u32;
    var phi_3359_: bool;
    var phi_3368_: type_63;
    var phi_3373_: type_63;
    var phi_3374_: bool;
    var phi_1123_: type_47;
    var phi_1126_: type_8;
    var phi_1127_: type_8;
    var phi_1149_: type_8;
    var phi_1170_: u32;
    var phi_1259_: array<array<f32, 3>, 3>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1762_: bool;
    var phi_1771_: vec3<f32>;
    var phi_1811_: type_26;
    var phi_1813_: type_26;
    var phi_1814_: bool;
    var phi_1818_: type_26;
    var phi_1819_: type_26;
    var phi_1820_: type_26;
    var phi_1821_: bool;
    var phi_1825_: type_26;
    var phi_1826_: bool;
    var phi_1830_: type_26;
    var phi_1831_: bool;
    var phi_1835_: type_26;
    var phi_1858_: u32;
    var phi_1872_: i32;
    var phi_1892_: vec3<f32>;
    var phi_1893_: vec3<f32>;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1926_: vec3<f32>;
    var phi_1927_: vec3<f32>;
    var phi_1963_: vec3<f32>;
    var phi_2145_: f32;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2169_: type_47;
    var phi_2170_: type_47;
    var phi_1124_: type_47;
    var phi_3634_: bool;
    var local_10: type_47;
    var phi_3776_: bool;
    var phi_3376_: type_47;
    var phi_3377_: type_63;
    var phi_3378_: bool;
    var phi_3379_: u32;
    var phi_3775_: bool;
    var phi_3380_: type_47;
    var phi_3381_: type_63;
    var phi_3382_: u32;
    var phi_3383_: bool;
    var phi_3384_: u32;
    var phi_3774_: bool;
    var phi_3385_: type_47;
    var phi_3386_: type_63;
    var phi_3387_: u32;
    var phi_3388_: bool;
    var phi_3389_: u32;
    var phi_3773_: bool;
    var phi_998_: type_47;
    var phi_1001_: type_63;
    var phi_1003_: u32;
    var phi_1005_: bool;
    var phi_1007_: u32;
    var phi_3390_: bool;
    var phi_3772_: bool;
    var local_11: type_47;
    var local_12: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_9.member));
            let _e96 = arrayLength((&global_5.member));
            let _e108 = arrayLength((&global_8.member));
            let _e112 = global_4.member[0u][0u];
            let _e116 = global_4.member[0u][1u];
            let _e120 = global_4.member[0u][2u];
            let _e124 = global_4.member[0u][3u];
            let _e128 = global_4.member[1u][0u];
            let _e132 = global_4.member[1u][1u];
            let _e136 = global_4.member[1u][2u];
            let _e140 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e124) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e112), bitcast<i32>(_e116), bitcast<i32>(_e120));
            local = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            let _e155 = (_e140 < arrayLength((&global_10.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_10.member[_e140].member_2;
                phi_321_ = _e159;
            } else {
                phi_321_ = 4294967295u;
            }
            let _e161 = phi_321_;
            let _e164 = global_1.member[0u];
            let _e168 = global_3.member[0u][0u];
            let _e172 = global_3.member[0u][1u];
            let _e176 = global_3.member[0u][2u];
            let _e180 = global_3.member[0u][3u];
            let _e184 = global_3.member[1u][0u];
            let _e188 = global_3.member[1u][1u];
            let _e192 = global_3.member[1u][2u];
            let _e196 = global_3.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_365_ = -126i;
            } else {
                phi_365_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_365_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_389_ = type_41(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_389_ = type_41(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_389_;
            if _e155 {
                let _e234 = (_e140 < arrayLength((&global_2.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e239 = global_10.member[_e140].member.member_1;
                    let _e244 = global_10.member[_e140].member.member_3;
                    if (_e239 <= _e244) {
                        let _e246 = (1u < _e108);
                        if _e246 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e250 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e250 + 1u) < _e250) {
                                if _e246 {
                                } else {
                                    break;
                                }
                                let _e255 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e155 {
                        } else {
                            break;
                        }
                        let _e265 = global_10.member[_e140].member.member_2[0u];
                        let _e267 = (bitcast<u32>(_e265) & 2147483647u);
                        let _e273 = global_10.member[_e140].member.member_2[1u];
                        let _e275 = (bitcast<u32>(_e273) & 2147483647u);
                        let _e281 = global_10.member[_e140].member.member_2[2u];
                        let _e283 = (bitcast<u32>(_e281) & 2147483647u);
                        let _e289 = global_10.member[_e140].member.member[0u];
                        let _e291 = (bitcast<u32>(_e289) & 2147483647u);
                        let _e297 = global_10.member[_e140].member.member[1u];
                        let _e299 = (bitcast<u32>(_e297) & 2147483647u);
                        let _e305 = global_10.member[_e140].member.member[2u];
                        let _e307 = (bitcast<u32>(_e305) & 2147483647u);
                        let _e309 = select(_e275, _e267, (_e275 < _e267));
                        let _e311 = select(_e283, _e309, (_e283 < _e309));
                        let _e313 = select(_e291, _e311, (_e291 < _e311));
                        let _e315 = select(_e299, _e313, (_e299 < _e313));
                        let _e317 = select(_e307, _e315, (_e307 < _e315));
                        let _e319 = (bitcast<u32>(_e239) & 2147483647u);
                        let _e328 = (((select(_e319, _e317, (_e319 < _e317)) < 2139095040u) && ((bitcast<u32>(_e244) & 2147483647u) <= 2139095040u)) && (_e311 > 0u));
                        if _e328 {
                            let _e331 = (bitcast<u32>(bitcast<f32>(_e311)) & 2147483647u);
                            if (_e331 >= 8388608u) {
                                phi_539_ = (bitcast<i32>((_e331 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_539_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e331)), 32u, (_e331 == 0u))));
                            }
                            let _e345 = phi_539_;
                            phi_540_ = _e345;
                        } else {
                            phi_540_ = 0i;
                        }
                        let _e347 = phi_540_;
                        let _e348 = (_e267 == _e311);
                        if _e348 {
                            phi_550_ = true;
                        } else {
                            phi_550_ = (_e275 == _e311);
                        }
                        let _e351 = phi_550_;
                        let _e352 = select(1u, 0u, _e348);
                        if _e351 {
                            let _e353 = (_e352 + 1u);
                            phi_560_ = _e353;
                            phi_561_ = _e353;
                            phi_563_ = select(true, false, (_e353 == 2u));
                        } else {
                            phi_560_ = u32();
                            phi_561_ = 0u;
                            phi_563_ = true;
                        }
                        let _e357 = phi_560_;
                        let _e359 = phi_561_;
                        let _e361 = phi_563_;
                        if _e361 {
                            phi_568_ = (_e359 + 1u);
                        } else {
                            phi_568_ = 0u;
                        }
                        let _e365 = phi_568_;
                        let _e366 = select(_e357, _e359, _e361);
                        let _e367 = select(_e352, select(2u, _e352, _e351), _e361);
                        let _e368 = -(_e347);
                        if (_e368 < -126i) {
                            phi_600_ = -126i;
                        } else {
                            phi_600_ = select(_e368, 127i, (_e368 > 127i));
                        }
                        let _e373 = phi_600_;
                        let _e378 = bitcast<f32>((bitcast<u32>((_e373 + 127i)) << bitcast<u32>(23i)));
                        let _e384 = bitcast<f32>((bitcast<u32>(((_e368 - _e373) + 127i)) << bitcast<u32>(23i)));
                        let _e389 = global_10.member[_e140].member.member;
                        let _e390 = (_e366 == 0u);
                        if _e390 {
                            phi_618_ = _e389[0];
                        } else {
                            phi_618_ = _e389[1];
                        }
                        let _e394 = phi_618_;
                        let _e395 = (_e366 == 2u);
                        if _e395 {
                            phi_624_ = _e389[2];
                        } else {
                            phi_624_ = _e394;
                        }
                        let _e398 = phi_624_;
                        let _e399 = global_10.member[_e140].member.member_2;
                        if _e390 {
                            phi_635_ = _e399[0];
                        } else {
                            phi_635_ = _e399[1];
                        }
                        let _e403 = phi_635_;
                        if _e395 {
                            phi_641_ = _e399[2];
                        } else {
                            phi_641_ = _e403;
                        }
                        let _e406 = phi_641_;
                        let _e408 = ((_e406 * _e378) * _e384);
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e412 {
                            let _e416 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                            phi_664_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                        } else {
                            phi_664_ = 0f;
                        }
                        let _e420 = phi_664_;
                        let _e421 = (_e398 + _e420);
                        let _e422 = (_e398 - _e420);
                        let _e423 = select(_e408, 0f, _e412);
                        if _e412 {
                            phi_675_ = 38685626000000000000000000f;
                        } else {
                            phi_675_ = (1f / _e408);
                        }
                        let _e426 = phi_675_;
                        let _e427 = (_e365 == 0u);
                        if _e427 {
                            phi_684_ = _e389[0];
                        } else {
                            phi_684_ = _e389[1];
                        }
                        let _e431 = phi_684_;
                        let _e432 = (_e365 == 2u);
                        if _e432 {
                            phi_690_ = _e389[2];
                        } else {
                            phi_690_ = _e431;
                        }
                        let _e435 = phi_690_;
                        if _e427 {
                            phi_701_ = _e399[0];
                        } else {
                            phi_701_ = _e399[1];
                        }
                        let _e439 = phi_701_;
                        if _e432 {
                            phi_707_ = _e399[2];
                        } else {
                            phi_707_ = _e439;
                        }
                        let _e442 = phi_707_;
                        let _e444 = ((_e442 * _e378) * _e384);
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e448 {
                            let _e452 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) * 0.00000011920929f);
                            phi_730_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                        } else {
                            phi_730_ = 0f;
                        }
                        let _e456 = phi_730_;
                        let _e457 = (_e435 + _e456);
                        let _e458 = (_e435 - _e456);
                        let _e459 = select(_e444, 0f, _e448);
                        if _e448 {
                            phi_741_ = 38685626000000000000000000f;
                        } else {
                            phi_741_ = (1f / _e444);
                        }
                        let _e462 = phi_741_;
                        let _e463 = (_e367 == 0u);
                        if _e463 {
                            phi_750_ = _e389[0];
                        } else {
                            phi_750_ = _e389[1];
                        }
                        let _e467 = phi_750_;
                        let _e468 = (_e367 == 2u);
                        if _e468 {
                            phi_756_ = _e389[2];
                        } else {
                            phi_756_ = _e467;
                        }
                        let _e471 = phi_756_;
                        if _e463 {
                            phi_767_ = _e399[0];
                        } else {
                            phi_767_ = _e399[1];
                        }
                        let _e475 = phi_767_;
                        if _e468 {
                            phi_773_ = _e399[2];
                        } else {
                            phi_773_ = _e475;
                        }
                        let _e478 = phi_773_;
                        let _e480 = ((_e478 * _e378) * _e384);
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e484 {
                            let _e488 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                            phi_796_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                        } else {
                            phi_796_ = 0f;
                        }
                        let _e492 = phi_796_;
                        let _e493 = (_e471 + _e492);
                        let _e494 = (_e471 - _e492);
                        let _e495 = select(_e480, 0f, _e484);
                        if _e484 {
                            phi_807_ = 38685626000000000000000000f;
                        } else {
                            phi_807_ = (1f / _e480);
                        }
                        let _e498 = phi_807_;
                        let _e501 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                        let _e504 = bitcast<f32>((bitcast<u32>(_e435) & 2147483647u));
                        let _e506 = select(_e504, _e501, (_e501 > _e504));
                        let _e509 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                        if (_e328 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                            let _e514 = (_e347 / 3i);
                            let _e521 = bitcast<f32>((bitcast<u32>((_e514 + 127i)) << bitcast<u32>(23i)));
                            let _e528 = bitcast<f32>((bitcast<u32>(((_e347 - (2i * _e514)) + 127i)) << bitcast<u32>(23i)));
                            let _e529 = (((_e239 * _e521) * _e521) * _e528);
                            let _e531 = select(340282350000000000000000000000000000000f, _e529, (_e529 < 340282350000000000000000000000000000000f));
                            let _e536 = (((_e244 * _e521) * _e521) * _e528);
                            let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                            phi_907_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                            phi_908_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_907_ = 0f;
                            phi_908_ = 1f;
                        }
                        let _e542 = phi_907_;
                        let _e544 = phi_908_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e548 = (_e366 % 3u);
                        let _e549 = (_e548 < 3u);
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e551 = local_1[_e548];
                        let _e554 = (_e365 % 3u);
                        let _e555 = (_e554 < 3u);
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e557 = local_1[_e554];
                        let _e560 = (_e367 % 3u);
                        let _e561 = (_e560 < 3u);
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e563 = local_1[_e560];
                        if _e549 {
                        } else {
                            break;
                        }
                        let _e568 = local[_e548];
                        if _e555 {
                        } else {
                            break;
                        }
                        let _e572 = local[_e554];
                        if _e561 {
                        } else {
                            break;
                        }
                        let _e576 = local[_e560];
                        phi_3640_ = false;
                        phi_997_ = type_47(_e542, false);
                        phi_1000_ = type_63(type_35(vec4<f32>((f32(_e551) * _e152), (f32(_e557) * _e152), (f32(_e563) * _e152), 0f), vec4<f32>((f32(_e568) * _e152), (f32(_e572) * _e152), (f32(_e576) * _e152), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                        phi_1002_ = ((3u * _e94) + 1u);
                        phi_1004_ = (_e544 <= _e542);
                        phi_1006_ = 0u;
                        loop {
                            let _e586 = phi_3640_;
                            let _e588 = phi_997_;
                            let _e590 = phi_1000_;
                            let _e592 = phi_1002_;
                            let _e594 = phi_1004_;
                            let _e596 = phi_1006_;
                            local_11 = _e588;
                            if _e594 {
                                phi_1017_ = true;
                            } else {
                                phi_1017_ = (_e596 > 0u);
                            }
                            let _e599 = phi_1017_;
                            if _e599 {
                                let _e600 = (_e592 > 0u);
                                if _e600 {
                                    if _e594 {
                                        phi_1103_ = _e590;
                                        phi_1104_ = _e594;
                                        phi_1105_ = _e596;
                                    } else {
                                        let _e601 = (_e596 - 1u);
                                        let _e602 = (_e601 % 128u);
                                        let _e603 = (_e602 < 128u);
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e605 = local_7[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e607 = local_6[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e609 = local_5[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e611 = local_4[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e613 = local_3[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e615 = local_2[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e620 = local_8[_e602];
                                        if _e603 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e623 = local_9[_e602];
                                        phi_1103_ = type_63(type_35(vec4<f32>(_e605, _e607, _e609, 0f), vec4<f32>(_e611, _e613, _e615, 0f)), _e620);
                                        phi_1104_ = (_e623 <= _e588.member);
                                        phi_1105_ = _e601;
                                    }
                                    let _e627 = phi_1103_;
                                    let _e629 = phi_1104_;
                                    let _e631 = phi_1105_;
                                    if _e629 {
                                        if ((_e627.member_1 & 2147483648u) != 0u) {
                                            phi_1123_ = _e588;
                                            phi_1126_ = type_8(0u, ((_e627.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1093 = phi_1123_;
                                                let _e1095 = phi_1126_;
                                                local_10 = _e1093;
                                                local_12 = _e1093;
                                                if (_e1095.member < _e1095.member_1) {
                                                    phi_1127_ = type_8((_e1095.member + 1u), _e1095.member_1);
                                                    phi_1149_ = type_8(1u, _e1095.member);
                                                } else {
                                                    phi_1127_ = _e1095;
                                                    phi_1149_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1108 = phi_1127_;
                                                let _e1110 = phi_1149_;
                                                let _e1114 = (bitcast<i32>(_e1110.member) != 0i);
                                                if _e1114 {
                                                    let _e1115 = ((_e627.member_1 & 268435455u) + _e1110.member_1);
                                                    let _e1116 = (_e1115 < _e96);
                                                    if _e1116 {
                                                        if _e1116 {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1120 = global_5.member[_e1115].member_1;
                                                        phi_1170_ = _e1120;
                                                    } else {
                                                        phi_1170_ = 4294967295u;
                                                    }
                                                    let _e1122 = phi_1170_;
                                                    if (_e1115 >= _e96) {
                                                        phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1116 {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        if (_e548 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1129 = global_5.member[_e1115].member[_e548];
                                                        if (_e554 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1135 = global_5.member[_e1115].member[_e554];
                                                        if (_e560 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1141 = global_5.member[_e1115].member[_e560];
                                                        let _e1143 = (3u + _e548);
                                                        if (_e1143 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1149 = global_5.member[_e1115].member[_e1143];
                                                        let _e1150 = (3u + _e554);
                                                        if (_e1150 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1156 = global_5.member[_e1115].member[_e1150];
                                                        let _e1157 = (3u + _e560);
                                                        if (_e1157 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1163 = global_5.member[_e1115].member[_e1157];
                                                        let _e1165 = (6u + _e548);
                                                        if (_e1165 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1171 = global_5.member[_e1115].member[_e1165];
                                                        let _e1172 = (6u + _e554);
                                                        if (_e1172 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1178 = global_5.member[_e1115].member[_e1172];
                                                        let _e1179 = (6u + _e560);
                                                        if (_e1179 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1185 = global_5.member[_e1115].member[_e1179];
                                                        phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1129, _e1135, _e1141), array<f32, 3>(_e1149, _e1156, _e1163), array<f32, 3>(_e1171, _e1178, _e1185));
                                                    }
                                                    let _e1189 = phi_1259_;
                                                    let _e1197 = (_e1189[0][2] - _e471);
                                                    let _e1200 = (((_e1189[0][0] - _e398) * _e495) - (_e1197 * _e423));
                                                    let _e1203 = (((_e1189[0][1] - _e435) * _e495) - (_e1197 * _e459));
                                                    let _e1210 = (_e1189[1][2] - _e471);
                                                    let _e1213 = (((_e1189[1][0] - _e398) * _e495) - (_e1210 * _e423));
                                                    let _e1216 = (((_e1189[1][1] - _e435) * _e495) - (_e1210 * _e459));
                                                    let _e1223 = (_e1189[2][2] - _e471);
                                                    let _e1226 = (((_e1189[2][0] - _e398) * _e495) - (_e1223 * _e423));
                                                    let _e1229 = (((_e1189[2][1] - _e435) * _e495) - (_e1223 * _e459));
                                                    let _e1230 = (_e1226 * _e1216);
                                                    let _e1231 = (_e1229 * _e1213);
                                                    let _e1232 = (_e1200 * _e1229);
                                                    let _e1233 = (_e1203 * _e1226);
                                                    let _e1234 = (_e1213 * _e1203);
                                                    let _e1235 = (_e1216 * _e1200);
                                                    let _e1240 = (((_e1230 >= _e1231) && (_e1232 >= _e1233)) && (_e1234 >= _e1235));
                                                    if (_e1240 || (((_e1230 <= _e1231) && (_e1232 <= _e1233)) && (_e1234 <= _e1235))) {
                                                        let _e1247 = select(-1f, 1f, _e1240);
                                                        let _e1249 = ((_e1230 - _e1231) * _e1247);
                                                        let _e1251 = select(0f, _e1249, (_e1249 > 0f));
                                                        let _e1253 = ((_e1232 - _e1233) * _e1247);
                                                        let _e1255 = select(0f, _e1253, (_e1253 > 0f));
                                                        let _e1257 = ((_e1234 - _e1235) * _e1247);
                                                        let _e1259 = select(0f, _e1257, (_e1257 > 0f));
                                                        let _e1261 = ((_e1251 + _e1255) + _e1259);
                                                        if (_e1261 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1825_ = type_26();
                                                            phi_1826_ = true;
                                                        } else {
                                                            let _e1264 = select(_e1189[1][0], _e1189[0][0], (_e1189[0][0] < _e1189[1][0]));
                                                            let _e1268 = select(_e1189[1][0], _e1189[0][0], (_e1189[0][0] > _e1189[1][0]));
                                                            let _e1272 = select(_e1189[1][1], _e1189[0][1], (_e1189[0][1] < _e1189[1][1]));
                                                            let _e1276 = select(_e1189[1][1], _e1189[0][1], (_e1189[0][1] > _e1189[1][1]));
                                                            let _e1280 = select(_e1189[1][2], _e1189[0][2], (_e1189[0][2] < _e1189[1][2]));
                                                            let _e1284 = select(_e1189[1][2], _e1189[0][2], (_e1189[0][2] > _e1189[1][2]));
                                                            let _e1289 = ((select(_e1189[2][0], _e1264, (_e1264 < _e1189[2][0])) - _e421) * _e426);
                                                            let _e1290 = ((select(_e1189[2][0], _e1268, (_e1268 > _e1189[2][0])) - _e422) * _e426);
                                                            let _e1293 = ((select(_e1189[2][1], _e1272, (_e1272 < _e1189[2][1])) - _e457) * _e462);
                                                            let _e1294 = ((select(_e1189[2][1], _e1276, (_e1276 > _e1189[2][1])) - _e458) * _e462);
                                                            let _e1297 = ((select(_e1189[2][2], _e1280, (_e1280 < _e1189[2][2])) - _e493) * _e498);
                                                            let _e1298 = ((select(_e1189[2][2], _e1284, (_e1284 > _e1189[2][2])) - _e494) * _e498);
                                                            let _e1300 = select(_e1298, _e1297, (_e1297 < _e1298));
                                                            let _e1302 = select(_e1298, _e1297, (_e1297 > _e1298));
                                                            let _e1304 = select(_e1290, _e1289, (_e1289 < _e1290));
                                                            let _e1306 = select(_e1294, _e1293, (_e1293 < _e1294));
                                                            let _e1308 = select(_e1306, _e1304, (_e1304 > _e1306));
                                                            let _e1310 = select(_e1300, _e1308, (_e1308 > _e1300));
                                                            let _e1312 = select(_e1290, _e1289, (_e1289 > _e1290));
                                                            let _e1314 = select(_e1294, _e1293, (_e1293 > _e1294));
                                                            let _e1316 = select(_e1314, _e1312, (_e1312 < _e1314));
                                                            let _e1318 = select(_e1302, _e1316, (_e1316 < _e1302));
                                                            let _e1319 = -(_e1300);
                                                            let _e1325 = select(_e544, _e1310, (_e1310 > _e544));
                                                            if (_e1325 > (_e1318 + (select(_e1319, _e1302, (_e1302 > _e1319)) * 0.0000019073523f))) {
                                                                phi_1820_ = type_26();
                                                                phi_1821_ = true;
                                                            } else {
                                                                let _e1327 = (_e1325 > _e1093.member);
                                                                if _e1327 {
                                                                    phi_1819_ = type_26();
                                                                } else {
                                                                    let _e1331 = (_e1189[1][0] - _e1189[0][0]);
                                                                    let _e1332 = (_e1189[1][1] - _e1189[0][1]);
                                                                    let _e1333 = (_e1189[1][2] - _e1189[0][2]);
                                                                    let _e1334 = vec3<f32>(_e1331, _e1332, _e1333);
                                                                    let _e1335 = (_e1189[2][0] - _e1189[1][0]);
                                                                    let _e1336 = (_e1189[2][1] - _e1189[1][1]);
                                                                    let _e1337 = (_e1189[2][2] - _e1189[1][2]);
                                                                    let _e1338 = vec3<f32>(_e1335, _e1336, _e1337);
                                                                    let _e1339 = (_e1189[0][0] - _e1189[2][0]);
                                                                    let _e1340 = (_e1189[0][1] - _e1189[2][1]);
                                                                    let _e1341 = (_e1189[0][2] - _e1189[2][2]);
                                                                    let _e1342 = vec3<f32>(_e1339, _e1340, _e1341);
                                                                    let _e1345 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                    let _e1348 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                    let _e1350 = select(_e1348, _e1345, (_e1345 > _e1348));
                                                                    let _e1353 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                    let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                    let _e1358 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                    let _e1361 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                    let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                    let _e1366 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                    let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                    let _e1371 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                    let _e1374 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                    let _e1376 = select(_e1374, _e1371, (_e1371 > _e1374));
                                                                    let _e1379 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                    let _e1381 = select(_e1379, _e1376, (_e1376 > _e1379));
                                                                    let _e1383 = select(_e1368, _e1355, (_e1355 > _e1368));
                                                                    let _e1385 = select(_e1381, _e1383, (_e1383 > _e1381));
                                                                    if (_e1355 == _e1385) {
                                                                        phi_1730_ = _e1338;
                                                                        phi_1731_ = _e1342;
                                                                    } else {
                                                                        let _e1388 = vec3((_e1368 == _e1385));
                                                                        phi_1730_ = select(_e1334, _e1342, _e1388);
                                                                        phi_1731_ = select(_e1338, _e1334, _e1388);
                                                                    }
                                                                    let _e1392 = phi_1730_;
                                                                    let _e1394 = phi_1731_;
                                                                    let _e1401 = ((_e1392.y * _e1394.z) - (_e1394.y * _e1392.z));
                                                                    let _e1406 = ((_e1392.z * _e1394.x) - (_e1394.z * _e1392.x));
                                                                    let _e1409 = ((_e1392.x * _e1394.y) - (_e1394.x * _e1392.y));
                                                                    if (_e1251 >= _e1255) {
                                                                        phi_1762_ = select(true, false, (_e1251 >= _e1259));
                                                                    } else {
                                                                        phi_1762_ = true;
                                                                    }
                                                                    let _e1414 = phi_1762_;
                                                                    if _e1414 {
                                                                        phi_1771_ = select(vec3<f32>(_e1189[2][0], _e1189[2][1], _e1189[2][2]), vec3<f32>(_e1189[1][0], _e1189[1][1], _e1189[1][2]), vec3((_e1255 >= _e1259)));
                                                                    } else {
                                                                        phi_1771_ = vec3<f32>(_e1189[0][0], _e1189[0][1], _e1189[0][2]);
                                                                    }
                                                                    let _e1419 = phi_1771_;
                                                                    let _e1436 = ((((_e1401 * (_e1419.x - _e398)) + (_e1406 * (_e1419.y - _e435))) + (_e1409 * (_e1419.z - _e471))) / (((_e1401 * _e423) + (_e1406 * _e459)) + (_e1409 * _e495)));
                                                                    let _e1438 = select(_e1318, _e1436, (_e1436 < _e1318));
                                                                    let _e1440 = select(_e1310, _e1438, (_e1438 > _e1310));
                                                                    if (_e1440 >= _e544) {
                                                                        let _e1442 = (_e1440 <= _e1093.member);
                                                                        if _e1442 {
                                                                            let _e1443 = (1f / _e1261);
                                                                            phi_1811_ = type_26(_e1440, (_e1255 * _e1443), (_e1259 * _e1443), _e1122);
                                                                        } else {
                                                                            phi_1811_ = type_26();
                                                                        }
                                                                        let _e1448 = phi_1811_;
                                                                        phi_1813_ = _e1448;
                                                                        phi_1814_ = select(true, false, _e1442);
                                                                    } else {
                                                                        phi_1813_ = type_26();
                                                                        phi_1814_ = true;
                                                                    }
                                                                    let _e1451 = phi_1813_;
                                                                    let _e1453 = phi_1814_;
                                                                    if _e1453 {
                                                                        phi_1818_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1818_ = _e1451;
                                                                    }
                                                                    let _e1455 = phi_1818_;
                                                                    phi_1819_ = _e1455;
                                                                }
                                                                let _e1457 = phi_1819_;
                                                                phi_1820_ = _e1457;
                                                                phi_1821_ = _e1327;
                                                            }
                                                            let _e1459 = phi_1820_;
                                                            let _e1461 = phi_1821_;
                                                            phi_1825_ = _e1459;
                                                            phi_1826_ = _e1461;
                                                        }
                                                        let _e1463 = phi_1825_;
                                                        let _e1465 = phi_1826_;
                                                        phi_1830_ = _e1463;
                                                        phi_1831_ = _e1465;
                                                    } else {
                                                        phi_1830_ = type_26();
                                                        phi_1831_ = true;
                                                    }
                                                    let _e1467 = phi_1830_;
                                                    let _e1469 = phi_1831_;
                                                    if _e1469 {
                                                        phi_1835_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1835_ = _e1467;
                                                    }
                                                    let _e1471 = phi_1835_;
                                                    if (_e1471.member_3 != 4294967295u) {
                                                        if (_e1122 == _e161) {
                                                            phi_2164_ = false;
                                                        } else {
                                                            let _e1475 = (_e1122 < arrayLength((&global_6.member)));
                                                            if _e1475 {
                                                                if _e1475 {
                                                                } else {
                                                                    phi_3634_ = true;
                                                                    break;
                                                                }
                                                                let _e1477 = global_6.member[_e1122];
                                                                phi_1858_ = _e1477;
                                                            } else {
                                                                phi_1858_ = 4294967295u;
                                                            }
                                                            let _e1479 = phi_1858_;
                                                            let _e1480 = (_e1479 < arrayLength((&global_7.member)));
                                                            if _e1480 {
                                                                if _e1480 {
                                                                } else {
                                                                    phi_3634_ = true;
                                                                    break;
                                                                }
                                                                let _e1482 = global_7.member[_e1479];
                                                                phi_1872_ = _e1482;
                                                            } else {
                                                                phi_1872_ = 0i;
                                                            }
                                                            let _e1484 = phi_1872_;
                                                            let _e1485 = (_e1484 == 0i);
                                                            if _e1485 {
                                                                phi_2163_ = true;
                                                            } else {
                                                                if _e390 {
                                                                    phi_1893_ = vec3<f32>(_e1189[0][0], _e1189[0][1], _e1189[0][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1892_ = vec3<f32>(_e1189[0][2], _e1189[0][0], _e1189[0][1]);
                                                                    } else {
                                                                        phi_1892_ = vec3<f32>(_e1189[0][1], _e1189[0][2], _e1189[0][0]);
                                                                    }
                                                                    let _e1490 = phi_1892_;
                                                                    phi_1893_ = _e1490;
                                                                }
                                                                let _e1493 = phi_1893_;
                                                                if _e390 {
                                                                    phi_1910_ = vec3<f32>(_e1189[1][0], _e1189[1][1], _e1189[1][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1909_ = vec3<f32>(_e1189[1][2], _e1189[1][0], _e1189[1][1]);
                                                                    } else {
                                                                        phi_1909_ = vec3<f32>(_e1189[1][1], _e1189[1][2], _e1189[1][0]);
                                                                    }
                                                                    let _e1498 = phi_1909_;
                                                                    phi_1910_ = _e1498;
                                                                }
                                                                let _e1501 = phi_1910_;
                                                                if _e390 {
                                                                    phi_1927_ = vec3<f32>(_e1189[2][0], _e1189[2][1], _e1189[2][2]);
                                                                } else {
                                                                    if (_e366 == 1u) {
                                                                        phi_1926_ = vec3<f32>(_e1189[2][2], _e1189[2][0], _e1189[2][1]);
                                                                    } else {
                                                                        phi_1926_ = vec3<f32>(_e1189[2][1], _e1189[2][2], _e1189[2][0]);
                                                                    }
                                                                    let _e1506 = phi_1926_;
                                                                    phi_1927_ = _e1506;
                                                                }
                                                                let _e1509 = phi_1927_;
                                                                let _e1512 = (_e1501.x - _e1493.x);
                                                                let _e1515 = (_e1501.y - _e1493.y);
                                                                let _e1518 = (_e1501.z - _e1493.z);
                                                                let _e1520 = (_e1509.x - _e1493.x);
                                                                let _e1522 = (_e1509.y - _e1493.y);
                                                                let _e1524 = (_e1509.z - _e1493.z);
                                                                if (_e233.member_1 == 1u) {
                                                                    phi_1963_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1493);
                                                                } else {
                                                                    phi_1963_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                                }
                                                                let _e1539 = phi_1963_;
                                                                let _e1545 = bitcast<f32>((bitcast<u32>((_e1512 * _e1522)) ^ _e233.member_3[0]));
                                                                let _e1549 = bitcast<f32>((bitcast<u32>((_e1515 * _e1520)) ^ _e233.member_3[0]));
                                                                let _e1553 = bitcast<f32>((bitcast<u32>((_e1515 * _e1524)) ^ _e233.member_3[0]));
                                                                let _e1557 = bitcast<f32>((bitcast<u32>((_e1518 * _e1522)) ^ _e233.member_3[0]));
                                                                let _e1561 = bitcast<f32>((bitcast<u32>((_e1518 * _e1520)) ^ _e233.member_3[0]));
                                                                let _e1565 = bitcast<f32>((bitcast<u32>((_e1512 * _e1524)) ^ _e233.member_3[0]));
                                                                let _e1566 = (_e1553 - _e1557);
                                                                let _e1567 = (_e1561 - _e1565);
                                                                let _e1568 = (_e1545 - _e1549);
                                                                let _e1592 = (bitcast<f32>((bitcast<u32>(_e1553) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u)));
                                                                let _e1599 = (bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)));
                                                                let _e1606 = (bitcast<f32>((bitcast<u32>(_e1545) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u)));
                                                                if (_e233.member_2 == 0f) {
                                                                    phi_2145_ = 0f;
                                                                } else {
                                                                    let _e1636 = bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u));
                                                                    let _e1639 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                    let _e1642 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                    let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                    let _e1648 = select(_e1642, _e1639, (_e1639 < _e1642));
                                                                    let _e1652 = select(_e1639, _e1636, (_e1636 < _e1639));
                                                                    let _e1654 = select(_e1639, _e1636, (_e1636 > _e1639));
                                                                    let _e1656 = select(_e1642, _e1654, (_e1654 < _e1642));
                                                                    phi_2145_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1644, _e1636, (_e1636 > _e1644)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1656, _e1652, (_e1652 > _e1656)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1648, _e1636, (_e1636 < _e1648)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1592 + _e1599) + _e1606))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                                }
                                                                let _e1683 = phi_2145_;
                                                                phi_2163_ = (_e1485 || !(((((bitcast<f32>((bitcast<u32>((_e1539.x * _e1566)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1539.y * _e1567)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1539.z * _e1568)) ^ _e233.member_3[0]))) * f32(-(_e1484))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1539.x) & 2147483647u)) * _e1592)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1539.y) & 2147483647u)) * _e1599)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1539.z) & 2147483647u)) * _e1606)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1683) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1697 = phi_2163_;
                                                            phi_2164_ = _e1697;
                                                        }
                                                        let _e1699 = phi_2164_;
                                                        if _e1699 {
                                                            phi_2169_ = type_47(_e1093.member, true);
                                                        } else {
                                                            phi_2169_ = _e1093;
                                                        }
                                                        let _e1704 = phi_2169_;
                                                        phi_2170_ = _e1704;
                                                    } else {
                                                        phi_2170_ = _e1093;
                                                    }
                                                    let _e1706 = phi_2170_;
                                                    phi_1124_ = _e1706;
                                                } else {
                                                    phi_1124_ = type_47();
                                                }
                                                let _e1708 = phi_1124_;
                                                continue;
                                                continuing {
                                                    phi_1123_ = _e1708;
                                                    phi_1126_ = _e1108;
                                                    phi_3634_ = _e586;
                                                    break if !(_e1114);
                                                }
                                            }
                                            let _e1711 = phi_3634_;
                                            phi_3772_ = _e1711;
                                            if _e1711 {
                                                break;
                                            }
                                            let _e1713 = local_10;
                                            phi_3776_ = _e1711;
                                            let _e1900 = local_12;
                                            phi_3376_ = _e1900;
                                            phi_3377_ = _e627;
                                            phi_3378_ = false;
                                            phi_3379_ = select(_e631, 0u, _e1713.member_1);
                                        } else {
                                            if (_e627.member_1 >= _e94) {
                                                phi_2932_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_35(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e627.member_1 < _e94) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e642 = (_e366 * 2u);
                                                let _e644 = ((1u + _e642) % 7u);
                                                if (_e644 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e649 = global_9.member[_e627.member_1][_e644];
                                                let _e651 = ((_e642 + 2u) % 7u);
                                                if (_e651 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e656 = global_9.member[_e627.member_1][_e651];
                                                let _e657 = (_e365 * 2u);
                                                let _e659 = ((1u + _e657) % 7u);
                                                if (_e659 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e664 = global_9.member[_e627.member_1][_e659];
                                                let _e666 = ((_e657 + 2u) % 7u);
                                                if (_e666 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e671 = global_9.member[_e627.member_1][_e666];
                                                let _e672 = (_e367 * 2u);
                                                let _e674 = ((1u + _e672) % 7u);
                                                if (_e674 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e679 = global_9.member[_e627.member_1][_e674];
                                                let _e681 = ((_e672 + 2u) % 7u);
                                                if (_e681 < 7u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e686 = global_9.member[_e627.member_1][_e681];
                                                let _e709 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.x - _e627.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e710 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.y - _e627.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e711 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.z - _e627.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e713 = select(_e152, _e709, (_e709 > _e152));
                                                let _e715 = select(_e152, _e710, (_e710 > _e152));
                                                let _e717 = select(_e152, _e711, (_e711 > _e152));
                                                let _e742 = bitcast<u32>((f32(bitcast<i32>((_e649 & 2097151u))) * _e713));
                                                let _e747 = (bitcast<i32>((_e649 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                                let _e751 = bitcast<u32>((f32(bitcast<i32>((_e664 & 2097151u))) * _e715));
                                                let _e756 = (bitcast<i32>((_e664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                                let _e760 = bitcast<u32>((f32(bitcast<i32>((_e679 & 2097151u))) * _e717));
                                                let _e765 = (bitcast<i32>((_e679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                                let _e772 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                                let _e776 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                                let _e780 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                                let _e781 = bitcast<u32>((f32(bitcast<i32>((_e656 & 2097151u))) * _e713));
                                                let _e786 = (bitcast<i32>((_e656 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                                let _e790 = bitcast<u32>((f32(bitcast<i32>((_e671 & 2097151u))) * _e715));
                                                let _e795 = (bitcast<i32>((_e671 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                                let _e799 = bitcast<u32>((f32(bitcast<i32>((_e686 & 2097151u))) * _e717));
                                                let _e804 = (bitcast<i32>((_e686 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e807 = bitcast<f32>((_e799 & bitcast<u32>(_e804)));
                                                let _e811 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                                let _e815 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                                let _e819 = bitcast<f32>((_e799 & bitcast<u32>(~(_e804))));
                                                let _e849 = global_9.member[_e627.member_1][0u];
                                                let _e853 = global_9.member[_e627.member_1][2u];
                                                let _e857 = global_9.member[_e627.member_1][4u];
                                                let _e861 = global_9.member[_e627.member_1][6u];
                                                let _e873 = (((_e853 >> bitcast<u32>(22i)) | ((_e857 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e861 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e874 = (_e849 & 268435455u);
                                                let _e875 = (_e873 & 268435455u);
                                                let _e878 = ((_e849 >> bitcast<u32>(28u)) & 7u);
                                                let _e886 = ((_e849 >> bitcast<u32>(31i)) | (((_e873 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e887 = (_e878 != 0u);
                                                if (_e878 == 0u) {
                                                    phi_2894_ = _e874;
                                                } else {
                                                    if (_e878 == 7u) {
                                                        phi_2893_ = 2147483648u;
                                                    } else {
                                                        phi_2893_ = ((2147483648u | (_e878 << bitcast<u32>(28u))) | (_e875 & 268435455u));
                                                    }
                                                    let _e896 = phi_2893_;
                                                    phi_2894_ = _e896;
                                                }
                                                let _e898 = phi_2894_;
                                                if _e887 {
                                                    let _e899 = (_e878 != 7u);
                                                    if _e899 {
                                                        phi_2904_ = (_e875 + _e878);
                                                    } else {
                                                        phi_2904_ = u32();
                                                    }
                                                    let _e902 = phi_2904_;
                                                    phi_2906_ = _e902;
                                                    phi_2907_ = select(true, false, _e899);
                                                } else {
                                                    phi_2906_ = u32();
                                                    phi_2907_ = true;
                                                }
                                                let _e905 = phi_2906_;
                                                let _e907 = phi_2907_;
                                                if (_e886 == 0u) {
                                                    phi_2928_ = (_e874 + select(0u, 1u, !(_e887)));
                                                } else {
                                                    if (_e886 == 7u) {
                                                        phi_2927_ = 2147483648u;
                                                    } else {
                                                        phi_2927_ = ((2147483648u | (_e886 << bitcast<u32>(28u))) | (select(_e905, _e875, _e907) & 268435455u));
                                                    }
                                                    let _e920 = phi_2927_;
                                                    phi_2928_ = _e920;
                                                }
                                                let _e922 = phi_2928_;
                                                phi_2932_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e627.member.member.x + _e750), (_e627.member.member.x + _e772), (_e627.member.member_1.x - _e789), (_e627.member.member_1.x - _e811)), vec4<f32>((_e627.member.member.y + _e759), (_e627.member.member.y + _e776), (_e627.member.member_1.y - _e798), (_e627.member.member_1.y - _e815)), vec4<f32>((_e627.member.member.z + _e768), (_e627.member.member.z + _e780), (_e627.member.member_1.z - _e807), (_e627.member.member_1.z - _e819))), type_63(type_35((_e627.member.member + vec4<f32>(_e750, _e759, _e768, 0f)), (_e627.member.member_1 - vec4<f32>(_e789, _e798, _e807, 0f))), _e898), type_63(type_35((_e627.member.member + vec4<f32>(_e772, _e776, _e780, 0f)), (_e627.member.member_1 - vec4<f32>(_e811, _e815, _e819, 0f))), _e922));
                                            }
                                            let _e927 = phi_2932_;
                                            let _e939 = ((_e927.member[0].x - _e421) * _e426);
                                            let _e940 = ((_e927.member[0].y - _e421) * _e426);
                                            let _e941 = ((_e927.member[0].z - _e422) * _e426);
                                            let _e942 = ((_e927.member[0].w - _e422) * _e426);
                                            let _e952 = ((_e927.member[1].x - _e457) * _e462);
                                            let _e953 = ((_e927.member[1].y - _e457) * _e462);
                                            let _e954 = ((_e927.member[1].z - _e458) * _e462);
                                            let _e955 = ((_e927.member[1].w - _e458) * _e462);
                                            let _e965 = ((_e927.member[2].x - _e493) * _e498);
                                            let _e966 = ((_e927.member[2].y - _e493) * _e498);
                                            let _e967 = ((_e927.member[2].z - _e494) * _e498);
                                            let _e968 = ((_e927.member[2].w - _e494) * _e498);
                                            let _e970 = select(_e967, _e965, (_e965 < _e967));
                                            let _e972 = select(_e968, _e966, (_e966 < _e968));
                                            let _e974 = select(_e967, _e965, (_e965 > _e967));
                                            let _e976 = select(_e968, _e966, (_e966 > _e968));
                                            let _e978 = select(_e941, _e939, (_e939 < _e941));
                                            let _e980 = select(_e942, _e940, (_e940 < _e942));
                                            let _e982 = select(_e954, _e952, (_e952 < _e954));
                                            let _e984 = select(_e955, _e953, (_e953 < _e955));
                                            let _e986 = select(_e982, _e978, (_e978 > _e982));
                                            let _e988 = select(_e984, _e980, (_e980 > _e984));
                                            let _e990 = select(_e970, _e986, (_e986 > _e970));
                                            let _e992 = select(_e972, _e988, (_e988 > _e972));
                                            let _e994 = select(_e941, _e939, (_e939 > _e941));
                                            let _e996 = select(_e942, _e940, (_e940 > _e942));
                                            let _e998 = select(_e954, _e952, (_e952 > _e954));
                                            let _e1000 = select(_e955, _e953, (_e953 > _e955));
                                            let _e1002 = select(_e998, _e994, (_e994 < _e998));
                                            let _e1004 = select(_e1000, _e996, (_e996 < _e1000));
                                            let _e1009 = -(_e970);
                                            let _e1010 = -(_e972);
                                            let _e1017 = (select(_e974, _e1002, (_e1002 < _e974)) + (select(_e1009, _e974, (_e974 > _e1009)) * 0.0000019073523f));
                                            let _e1018 = (select(_e976, _e1004, (_e1004 < _e976)) + (select(_e1010, _e976, (_e976 > _e1010)) * 0.0000019073523f));
                                            let _e1020 = select(_e544, _e990, (_e990 > _e544));
                                            let _e1022 = select(_e544, _e992, (_e992 > _e544));
                                            let _e1027 = (_e1020 <= select(_e588.member, _e1017, (_e1017 < _e588.member)));
                                            let _e1028 = (_e1022 <= select(_e588.member, _e1018, (_e1018 < _e588.member)));
                                            let _e1029 = (_e1020 <= _e1022);
                                            if _e1027 {
                                                if _e1028 {
                                                    if _e1029 {
                                                        phi_3276_ = _e927.member_2;
                                                    } else {
                                                        phi_3276_ = _e927.member_1;
                                                    }
                                                    let _e1033 = phi_3276_;
                                                    let _e1055 = (_e631 % 128u);
                                                    let _e1056 = (_e1055 < 128u);
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1055] = _e1033.member_1;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1055] = _e1033.member.member.x;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1055] = _e1033.member.member.y;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1055] = _e1033.member.member.z;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1055] = _e1033.member.member_1.x;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1055] = _e1033.member.member_1.y;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1055] = _e1033.member.member_1.z;
                                                    if _e1056 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1055] = select(_e1022, _e1020, (_e1020 > _e1022));
                                                    if _e1029 {
                                                        phi_3353_ = _e927.member_1;
                                                    } else {
                                                        phi_3353_ = _e927.member_2;
                                                    }
                                                    let _e1069 = phi_3353_;
                                                    phi_3354_ = _e1069;
                                                    phi_3355_ = (_e631 + 1u);
                                                } else {
                                                    phi_3354_ = type_63();
                                                    phi_3355_ = u32();
                                                }
                                                let _e1071 = phi_3354_;
                                                let _e1073 = phi_3355_;
                                                phi_3357_ = _e1071;
                                                phi_3358_ = _e1073;
                                                phi_3359_ = select(true, false, _e1028);
                                            } else {
                                                phi_3357_ = type_63();
                                                phi_3358_ = u32();
                                                phi_3359_ = true;
                                            }
                                            let _e1076 = phi_3357_;
                                            let _e1078 = phi_3358_;
                                            let _e1080 = phi_3359_;
                                            if _e1080 {
                                                if _e1027 {
                                                    phi_3368_ = _e927.member_1;
                                                } else {
                                                    phi_3368_ = _e927.member_2;
                                                }
                                                let _e1084 = phi_3368_;
                                                phi_3373_ = _e1084;
                                                phi_3374_ = select(_e1028, true, _e1027);
                                            } else {
                                                phi_3373_ = _e1076;
                                                phi_3374_ = _e629;
                                            }
                                            let _e1087 = phi_3373_;
                                            let _e1089 = phi_3374_;
                                            phi_3776_ = _e586;
                                            phi_3376_ = _e588;
                                            phi_3377_ = _e1087;
                                            phi_3378_ = _e1089;
                                            phi_3379_ = select(_e1078, _e631, _e1080);
                                        }
                                        let _e1717 = phi_3776_;
                                        let _e1719 = phi_3376_;
                                        let _e1721 = phi_3377_;
                                        let _e1723 = phi_3378_;
                                        let _e1725 = phi_3379_;
                                        phi_3775_ = _e1717;
                                        phi_3380_ = _e1719;
                                        phi_3381_ = _e1721;
                                        phi_3382_ = (_e592 - 1u);
                                        phi_3383_ = _e1723;
                                        phi_3384_ = _e1725;
                                    } else {
                                        phi_3775_ = _e586;
                                        phi_3380_ = _e588;
                                        phi_3381_ = _e627;
                                        phi_3382_ = _e592;
                                        phi_3383_ = _e629;
                                        phi_3384_ = _e631;
                                    }
                                    let _e1727 = phi_3775_;
                                    let _e1729 = phi_3380_;
                                    let _e1731 = phi_3381_;
                                    let _e1733 = phi_3382_;
                                    let _e1735 = phi_3383_;
                                    let _e1737 = phi_3384_;
                                    phi_3774_ = _e1727;
                                    phi_3385_ = _e1729;
                                    phi_3386_ = _e1731;
                                    phi_3387_ = _e1733;
                                    phi_3388_ = _e1735;
                                    phi_3389_ = _e1737;
                                } else {
                                    phi_3774_ = _e586;
                                    phi_3385_ = type_47();
                                    phi_3386_ = type_63();
                                    phi_3387_ = u32();
                                    phi_3388_ = bool();
                                    phi_3389_ = u32();
                                }
                                let _e1739 = phi_3774_;
                                let _e1741 = phi_3385_;
                                let _e1743 = phi_3386_;
                                let _e1745 = phi_3387_;
                                let _e1747 = phi_3388_;
                                let _e1749 = phi_3389_;
                                phi_3773_ = _e1739;
                                phi_998_ = _e1741;
                                phi_1001_ = _e1743;
                                phi_1003_ = _e1745;
                                phi_1005_ = _e1747;
                                phi_1007_ = _e1749;
                                phi_3390_ = _e600;
                            } else {
                                phi_3773_ = _e586;
                                phi_998_ = type_47();
                                phi_1001_ = type_63();
                                phi_1003_ = u32();
                                phi_1005_ = bool();
                                phi_1007_ = u32();
                                phi_3390_ = false;
                            }
                            let _e1751 = phi_3773_;
                            let _e1753 = phi_998_;
                            let _e1755 = phi_1001_;
                            let _e1757 = phi_1003_;
                            let _e1759 = phi_1005_;
                            let _e1761 = phi_1007_;
                            let _e1763 = phi_3390_;
                            continue;
                            continuing {
                                phi_3640_ = _e1751;
                                phi_997_ = _e1753;
                                phi_1000_ = _e1755;
                                phi_1002_ = _e1757;
                                phi_1004_ = _e1759;
                                phi_1006_ = _e1761;
                                phi_3772_ = _e1751;
                                break if !(_e1763);
                            }
                        }
                        let _e1766 = phi_3772_;
                        if _e1766 {
                            break;
                        }
                        let _e1768 = local_11;
                        if _e1768.member_1 {
                        } else {
                            if _e234 {
                            } else {
                                break;
                            }
                            let _e1772 = global_2.member[_e140];
                            if _e155 {
                            } else {
                                break;
                            }
                            let _e1776 = global_10.member[_e140].member_1;
                            if _e234 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_28(_e1772.member, _e1772.member_1, _e1772.member_2, array<f32, 3>((_e1772.member_3[0] + (_e1776[0] * _e1772.member_1[0])), (_e1772.member_3[1] + (_e1776[1] * _e1772.member_1[1])), (_e1772.member_3[2] + (_e1776[2] * _e1772.member_1[2]))), _e1772.member_4);
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
