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
    var phi_328_: u32;
    var phi_372_: i32;
    var phi_396_: type_45;
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
    var phi_1004_: type_51;
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
    var phi_1130_: type_51;
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
    var phi_2072_: type_30;
    var phi_2074_: type_30;
    var phi_2075_: bool;
    var phi_2079_: type_30;
    var phi_2080_: type_30;
    var phi_2081_: type_30;
    var phi_2082_: bool;
    var phi_2086_: type_30;
    var phi_2087_: bool;
    var phi_2088_: type_30;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2091_: type_30;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2101_: type_30;
    var phi_2102_: bool;
    var phi_2106_: type_30;
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
    var phi_2440_: type_51;
    var phi_2441_: type_51;
    var phi_1131_: type_51;
    var phi_3905_: bool;
    var local_10: type_51;
    var phi_4075_: bool;
    var phi_3647_: type_51;
    var phi_3648_: type_63;
    var phi_3649_: bool;
    var phi_3650_: u32;
    var phi_4074_: bool;
    var phi_3651_: type_51;
    var phi_3652_: type_63;
    var phi_3653_: u32;
    var phi_3654_: bool;
    var phi_3655_: u32;
    var phi_4073_: bool;
    var phi_3656_: type_51;
    var phi_3657_: type_63;
    var phi_3658_: u32;
    var phi_3659_: bool;
    var phi_3660_: u32;
    var phi_4072_: bool;
    var phi_1005_: type_51;
    var phi_1008_: type_63;
    var phi_1010_: u32;
    var phi_1012_: bool;
    var phi_1014_: u32;
    var phi_3661_: bool;
    var phi_4071_: bool;
    var local_11: type_51;
    var local_12: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_5.member));
            let _e100 = arrayLength((&global_6.member));
            let _e112 = arrayLength((&global_9.member));
            let _e116 = global_4.member[0u][0u];
            let _e120 = global_4.member[0u][1u];
            let _e124 = global_4.member[0u][2u];
            let _e128 = global_4.member[0u][3u];
            let _e132 = global_4.member[1u][0u];
            let _e136 = global_4.member[1u][1u];
            let _e140 = global_4.member[1u][2u];
            let _e144 = (_e96.x + (_e96.y * 2097152u));
            let _e156 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e128) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            local = array<i32, 3>(bitcast<i32>(_e132), bitcast<i32>(_e136), bitcast<i32>(_e140));
            let _e159 = (_e144 < arrayLength((&global_10.member)));
            if _e159 {
                if _e159 {
                } else {
                    break;
                }
                let _e163 = global_10.member[_e144].member_2;
                phi_328_ = _e163;
            } else {
                phi_328_ = 4294967295u;
            }
            let _e165 = phi_328_;
            let _e168 = global_1.member[0u];
            let _e172 = global_3.member[0u][0u];
            let _e176 = global_3.member[0u][1u];
            let _e180 = global_3.member[0u][2u];
            let _e184 = global_3.member[0u][3u];
            let _e188 = global_3.member[1u][0u];
            let _e192 = global_3.member[1u][1u];
            let _e196 = global_3.member[1u][2u];
            let _e200 = global_3.member[1u][3u];
            let _e201 = bitcast<f32>(_e172);
            let _e202 = bitcast<f32>(_e176);
            let _e203 = bitcast<f32>(_e180);
            let _e205 = bitcast<f32>(_e188);
            let _e206 = array<u32, 3>(_e192, _e196, _e200);
            let _e208 = bitcast<i32>(_e168);
            if (_e208 < -126i) {
                phi_372_ = -126i;
            } else {
                phi_372_ = select(_e208, 127i, (_e208 > 127i));
            }
            let _e213 = phi_372_;
            let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
            let _e224 = bitcast<f32>((bitcast<u32>(((_e208 - _e213) + 127i)) << bitcast<u32>(23i)));
            if (_e184 == 0u) {
                phi_396_ = type_45(array<f32, 3>(_e201, _e202, _e203), _e184, _e205, _e206);
            } else {
                phi_396_ = type_45(array<f32, 3>(((_e201 * _e218) * _e224), ((_e202 * _e218) * _e224), ((_e203 * _e218) * _e224)), _e184, ((_e205 * _e218) * _e224), _e206);
            }
            let _e237 = phi_396_;
            if _e159 {
                let _e238 = (_e144 < arrayLength((&global_2.member)));
                if _e238 {
                    if _e159 {
                    } else {
                        break;
                    }
                    let _e243 = global_10.member[_e144].member.member_1;
                    let _e248 = global_10.member[_e144].member.member_3;
                    if (_e243 <= _e248) {
                        let _e250 = (1u < _e112);
                        if _e250 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e254 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e254 + 1u) < _e254) {
                                if _e250 {
                                } else {
                                    break;
                                }
                                let _e259 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e159 {
                        } else {
                            break;
                        }
                        let _e269 = global_10.member[_e144].member.member_2[0u];
                        let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                        let _e277 = global_10.member[_e144].member.member_2[1u];
                        let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                        let _e285 = global_10.member[_e144].member.member_2[2u];
                        let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                        let _e293 = global_10.member[_e144].member.member[0u];
                        let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                        let _e301 = global_10.member[_e144].member.member[1u];
                        let _e303 = (bitcast<u32>(_e301) & 2147483647u);
                        let _e309 = global_10.member[_e144].member.member[2u];
                        let _e311 = (bitcast<u32>(_e309) & 2147483647u);
                        let _e313 = select(_e279, _e271, (_e279 < _e271));
                        let _e315 = select(_e287, _e313, (_e287 < _e313));
                        let _e317 = select(_e295, _e315, (_e295 < _e315));
                        let _e319 = select(_e303, _e317, (_e303 < _e317));
                        let _e321 = select(_e311, _e319, (_e311 < _e319));
                        let _e323 = (bitcast<u32>(_e243) & 2147483647u);
                        let _e332 = (((select(_e323, _e321, (_e323 < _e321)) < 2139095040u) && ((bitcast<u32>(_e248) & 2147483647u) <= 2139095040u)) && (_e315 > 0u));
                        if _e332 {
                            let _e335 = (bitcast<u32>(bitcast<f32>(_e315)) & 2147483647u);
                            if (_e335 >= 8388608u) {
                                phi_546_ = (bitcast<i32>((_e335 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_546_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e335)), 32u, (_e335 == 0u))));
                            }
                            let _e349 = phi_546_;
                            phi_547_ = _e349;
                        } else {
                            phi_547_ = 0i;
                        }
                        let _e351 = phi_547_;
                        let _e352 = (_e271 == _e315);
                        if _e352 {
                            phi_557_ = true;
                        } else {
                            phi_557_ = (_e279 == _e315);
                        }
                        let _e355 = phi_557_;
                        let _e356 = select(1u, 0u, _e352);
                        if _e355 {
                            let _e357 = (_e356 + 1u);
                            phi_567_ = _e357;
                            phi_568_ = _e357;
                            phi_570_ = select(true, false, (_e357 == 2u));
                        } else {
                            phi_567_ = u32();
                            phi_568_ = 0u;
                            phi_570_ = true;
                        }
                        let _e361 = phi_567_;
                        let _e363 = phi_568_;
                        let _e365 = phi_570_;
                        if _e365 {
                            phi_575_ = (_e363 + 1u);
                        } else {
                            phi_575_ = 0u;
                        }
                        let _e369 = phi_575_;
                        let _e370 = select(_e361, _e363, _e365);
                        let _e371 = select(_e356, select(2u, _e356, _e355), _e365);
                        let _e372 = -(_e351);
                        if (_e372 < -126i) {
                            phi_607_ = -126i;
                        } else {
                            phi_607_ = select(_e372, 127i, (_e372 > 127i));
                        }
                        let _e377 = phi_607_;
                        let _e382 = bitcast<f32>((bitcast<u32>((_e377 + 127i)) << bitcast<u32>(23i)));
                        let _e388 = bitcast<f32>((bitcast<u32>(((_e372 - _e377) + 127i)) << bitcast<u32>(23i)));
                        let _e393 = global_10.member[_e144].member.member;
                        let _e394 = (_e370 == 0u);
                        if _e394 {
                            phi_625_ = _e393[0];
                        } else {
                            phi_625_ = _e393[1];
                        }
                        let _e398 = phi_625_;
                        let _e399 = (_e370 == 2u);
                        if _e399 {
                            phi_631_ = _e393[2];
                        } else {
                            phi_631_ = _e398;
                        }
                        let _e402 = phi_631_;
                        let _e403 = global_10.member[_e144].member.member_2;
                        if _e394 {
                            phi_642_ = _e403[0];
                        } else {
                            phi_642_ = _e403[1];
                        }
                        let _e407 = phi_642_;
                        if _e399 {
                            phi_648_ = _e403[2];
                        } else {
                            phi_648_ = _e407;
                        }
                        let _e410 = phi_648_;
                        let _e412 = ((_e410 * _e382) * _e388);
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e416 {
                            let _e420 = (bitcast<f32>((bitcast<u32>(_e402) & 2147483647u)) * 0.00000011920929f);
                            phi_671_ = select(0.00000000000011368684f, _e420, (_e420 > 0.00000000000011368684f));
                        } else {
                            phi_671_ = 0f;
                        }
                        let _e424 = phi_671_;
                        let _e425 = (_e402 + _e424);
                        let _e426 = (_e402 - _e424);
                        let _e427 = select(_e412, 0f, _e416);
                        if _e416 {
                            phi_682_ = 38685626000000000000000000f;
                        } else {
                            phi_682_ = (1f / _e412);
                        }
                        let _e430 = phi_682_;
                        let _e431 = (_e369 == 0u);
                        if _e431 {
                            phi_691_ = _e393[0];
                        } else {
                            phi_691_ = _e393[1];
                        }
                        let _e435 = phi_691_;
                        let _e436 = (_e369 == 2u);
                        if _e436 {
                            phi_697_ = _e393[2];
                        } else {
                            phi_697_ = _e435;
                        }
                        let _e439 = phi_697_;
                        if _e431 {
                            phi_708_ = _e403[0];
                        } else {
                            phi_708_ = _e403[1];
                        }
                        let _e443 = phi_708_;
                        if _e436 {
                            phi_714_ = _e403[2];
                        } else {
                            phi_714_ = _e443;
                        }
                        let _e446 = phi_714_;
                        let _e448 = ((_e446 * _e382) * _e388);
                        let _e452 = (bitcast<f32>((bitcast<u32>(_e448) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e452 {
                            let _e456 = (bitcast<f32>((bitcast<u32>(_e439) & 2147483647u)) * 0.00000011920929f);
                            phi_737_ = select(0.00000000000011368684f, _e456, (_e456 > 0.00000000000011368684f));
                        } else {
                            phi_737_ = 0f;
                        }
                        let _e460 = phi_737_;
                        let _e461 = (_e439 + _e460);
                        let _e462 = (_e439 - _e460);
                        let _e463 = select(_e448, 0f, _e452);
                        if _e452 {
                            phi_748_ = 38685626000000000000000000f;
                        } else {
                            phi_748_ = (1f / _e448);
                        }
                        let _e466 = phi_748_;
                        let _e467 = (_e371 == 0u);
                        if _e467 {
                            phi_757_ = _e393[0];
                        } else {
                            phi_757_ = _e393[1];
                        }
                        let _e471 = phi_757_;
                        let _e472 = (_e371 == 2u);
                        if _e472 {
                            phi_763_ = _e393[2];
                        } else {
                            phi_763_ = _e471;
                        }
                        let _e475 = phi_763_;
                        if _e467 {
                            phi_774_ = _e403[0];
                        } else {
                            phi_774_ = _e403[1];
                        }
                        let _e479 = phi_774_;
                        if _e472 {
                            phi_780_ = _e403[2];
                        } else {
                            phi_780_ = _e479;
                        }
                        let _e482 = phi_780_;
                        let _e484 = ((_e482 * _e382) * _e388);
                        let _e488 = (bitcast<f32>((bitcast<u32>(_e484) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e488 {
                            let _e492 = (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) * 0.00000011920929f);
                            phi_803_ = select(0.00000000000011368684f, _e492, (_e492 > 0.00000000000011368684f));
                        } else {
                            phi_803_ = 0f;
                        }
                        let _e496 = phi_803_;
                        let _e497 = (_e475 + _e496);
                        let _e498 = (_e475 - _e496);
                        let _e499 = select(_e484, 0f, _e488);
                        if _e488 {
                            phi_814_ = 38685626000000000000000000f;
                        } else {
                            phi_814_ = (1f / _e484);
                        }
                        let _e502 = phi_814_;
                        let _e505 = bitcast<f32>((bitcast<u32>(_e402) & 2147483647u));
                        let _e508 = bitcast<f32>((bitcast<u32>(_e439) & 2147483647u));
                        let _e510 = select(_e508, _e505, (_e505 > _e508));
                        let _e513 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
                        if (_e332 && (select(_e513, _e510, (_e510 > _e513)) <= 1099511600000f)) {
                            let _e518 = (_e351 / 3i);
                            let _e525 = bitcast<f32>((bitcast<u32>((_e518 + 127i)) << bitcast<u32>(23i)));
                            let _e532 = bitcast<f32>((bitcast<u32>(((_e351 - (2i * _e518)) + 127i)) << bitcast<u32>(23i)));
                            let _e533 = (((_e243 * _e525) * _e525) * _e532);
                            let _e535 = select(340282350000000000000000000000000000000f, _e533, (_e533 < 340282350000000000000000000000000000000f));
                            let _e540 = (((_e248 * _e525) * _e525) * _e532);
                            let _e542 = select(340282350000000000000000000000000000000f, _e540, (_e540 < 340282350000000000000000000000000000000f));
                            phi_914_ = select(-340282350000000000000000000000000000000f, _e542, (_e542 > -340282350000000000000000000000000000000f));
                            phi_915_ = select(-340282350000000000000000000000000000000f, _e535, (_e535 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_914_ = 0f;
                            phi_915_ = 1f;
                        }
                        let _e546 = phi_914_;
                        let _e548 = phi_915_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e552 = (_e370 % 3u);
                        let _e553 = (_e552 < 3u);
                        if _e553 {
                        } else {
                            break;
                        }
                        let _e555 = local_1[_e552];
                        let _e558 = (_e369 % 3u);
                        let _e559 = (_e558 < 3u);
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e561 = local_1[_e558];
                        let _e564 = (_e371 % 3u);
                        let _e565 = (_e564 < 3u);
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e567 = local_1[_e564];
                        if _e553 {
                        } else {
                            break;
                        }
                        let _e572 = local[_e552];
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e576 = local[_e558];
                        if _e565 {
                        } else {
                            break;
                        }
                        let _e580 = local[_e564];
                        phi_3911_ = false;
                        phi_1004_ = type_51(_e546, false);
                        phi_1007_ = type_63(type_39(vec4<f32>((f32(_e555) * _e156), (f32(_e561) * _e156), (f32(_e567) * _e156), 0f), vec4<f32>((f32(_e572) * _e156), (f32(_e576) * _e156), (f32(_e580) * _e156), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                        phi_1009_ = ((3u * _e98) + 1u);
                        phi_1011_ = (_e548 <= _e546);
                        phi_1013_ = 0u;
                        loop {
                            let _e590 = phi_3911_;
                            let _e592 = phi_1004_;
                            let _e594 = phi_1007_;
                            let _e596 = phi_1009_;
                            let _e598 = phi_1011_;
                            let _e600 = phi_1013_;
                            local_11 = _e592;
                            if _e598 {
                                phi_1024_ = true;
                            } else {
                                phi_1024_ = (_e600 > 0u);
                            }
                            let _e603 = phi_1024_;
                            if _e603 {
                                let _e604 = (_e596 > 0u);
                                if _e604 {
                                    if _e598 {
                                        phi_1110_ = _e594;
                                        phi_1111_ = _e598;
                                        phi_1112_ = _e600;
                                    } else {
                                        let _e605 = (_e600 - 1u);
                                        let _e606 = (_e605 % 128u);
                                        let _e607 = (_e606 < 128u);
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e609 = local_7[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e611 = local_6[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e613 = local_5[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e615 = local_4[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e617 = local_3[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e619 = local_2[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e624 = local_8[_e606];
                                        if _e607 {
                                        } else {
                                            phi_4071_ = true;
                                            break;
                                        }
                                        let _e627 = local_9[_e606];
                                        phi_1110_ = type_63(type_39(vec4<f32>(_e609, _e611, _e613, 0f), vec4<f32>(_e615, _e617, _e619, 0f)), _e624);
                                        phi_1111_ = (_e627 <= _e592.member);
                                        phi_1112_ = _e605;
                                    }
                                    let _e631 = phi_1110_;
                                    let _e633 = phi_1111_;
                                    let _e635 = phi_1112_;
                                    if _e633 {
                                        if ((_e631.member_1 & 2147483648u) != 0u) {
                                            phi_1130_ = _e592;
                                            phi_1133_ = type_8(0u, ((_e631.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1079 = phi_1130_;
                                                let _e1081 = phi_1133_;
                                                local_10 = _e1079;
                                                local_12 = _e1079;
                                                if (_e1081.member < _e1081.member_1) {
                                                    phi_1134_ = type_8((_e1081.member + 1u), _e1081.member_1);
                                                    phi_1156_ = type_8(1u, _e1081.member);
                                                } else {
                                                    phi_1134_ = _e1081;
                                                    phi_1156_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1094 = phi_1134_;
                                                let _e1096 = phi_1156_;
                                                let _e1100 = (bitcast<i32>(_e1096.member) != 0i);
                                                if _e1100 {
                                                    let _e1101 = ((_e631.member_1 & 268435455u) + _e1096.member_1);
                                                    let _e1102 = (_e1101 < _e100);
                                                    if _e1102 {
                                                        if _e1102 {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1106 = global_6.member[_e1101].member_1;
                                                        phi_1177_ = _e1106;
                                                    } else {
                                                        phi_1177_ = 4294967295u;
                                                    }
                                                    let _e1108 = phi_1177_;
                                                    if (_e1101 >= _e100) {
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1102 {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        if (_e552 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1115 = global_6.member[_e1101].member[_e552];
                                                        if (_e558 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1121 = global_6.member[_e1101].member[_e558];
                                                        if (_e564 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1127 = global_6.member[_e1101].member[_e564];
                                                        let _e1129 = (3u + _e552);
                                                        if (_e1129 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1135 = global_6.member[_e1101].member[_e1129];
                                                        let _e1136 = (3u + _e558);
                                                        if (_e1136 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1142 = global_6.member[_e1101].member[_e1136];
                                                        let _e1143 = (3u + _e564);
                                                        if (_e1143 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1149 = global_6.member[_e1101].member[_e1143];
                                                        let _e1151 = (6u + _e552);
                                                        if (_e1151 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1157 = global_6.member[_e1101].member[_e1151];
                                                        let _e1158 = (6u + _e558);
                                                        if (_e1158 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1164 = global_6.member[_e1101].member[_e1158];
                                                        let _e1165 = (6u + _e564);
                                                        if (_e1165 < 9u) {
                                                        } else {
                                                            phi_3905_ = true;
                                                            break;
                                                        }
                                                        let _e1171 = global_6.member[_e1101].member[_e1165];
                                                        phi_1266_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1115, _e1121, _e1127), array<f32, 3>(_e1135, _e1142, _e1149), array<f32, 3>(_e1157, _e1164, _e1171));
                                                    }
                                                    let _e1175 = phi_1266_;
                                                    let _e1183 = (_e1175[0][2] - _e475);
                                                    let _e1186 = (((_e1175[0][0] - _e402) * _e499) - (_e1183 * _e427));
                                                    let _e1189 = (((_e1175[0][1] - _e439) * _e499) - (_e1183 * _e463));
                                                    let _e1196 = (_e1175[1][2] - _e475);
                                                    let _e1199 = (((_e1175[1][0] - _e402) * _e499) - (_e1196 * _e427));
                                                    let _e1202 = (((_e1175[1][1] - _e439) * _e499) - (_e1196 * _e463));
                                                    let _e1209 = (_e1175[2][2] - _e475);
                                                    let _e1212 = (((_e1175[2][0] - _e402) * _e499) - (_e1209 * _e427));
                                                    let _e1215 = (((_e1175[2][1] - _e439) * _e499) - (_e1209 * _e463));
                                                    let _e1216 = (_e1212 * _e1202);
                                                    let _e1217 = (_e1215 * _e1199);
                                                    let _e1218 = (_e1186 * _e1215);
                                                    let _e1219 = (_e1189 * _e1212);
                                                    let _e1220 = (_e1199 * _e1189);
                                                    let _e1221 = (_e1202 * _e1186);
                                                    let _e1226 = (((_e1216 >= _e1217) && (_e1218 >= _e1219)) && (_e1220 >= _e1221));
                                                    if (_e1226 || (((_e1216 <= _e1217) && (_e1218 <= _e1219)) && (_e1220 <= _e1221))) {
                                                        let _e1233 = select(-1f, 1f, _e1226);
                                                        let _e1235 = ((_e1216 - _e1217) * _e1233);
                                                        let _e1237 = select(0f, _e1235, (_e1235 > 0f));
                                                        let _e1239 = ((_e1218 - _e1219) * _e1233);
                                                        let _e1241 = select(0f, _e1239, (_e1239 > 0f));
                                                        let _e1243 = ((_e1220 - _e1221) * _e1233);
                                                        let _e1245 = select(0f, _e1243, (_e1243 > 0f));
                                                        let _e1247 = ((_e1237 + _e1241) + _e1245);
                                                        if (_e1247 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2091_ = type_30();
                                                            phi_2092_ = true;
                                                            phi_2093_ = false;
                                                        } else {
                                                            let _e1250 = select(_e1199, _e1186, (_e1186 < _e1199));
                                                            if (select(_e1212, _e1250, (_e1250 < _e1212)) > 0f) {
                                                                phi_1383_ = true;
                                                            } else {
                                                                let _e1255 = select(_e1199, _e1186, (_e1186 > _e1199));
                                                                phi_1383_ = (select(_e1212, _e1255, (_e1255 > _e1212)) < 0f);
                                                            }
                                                            let _e1260 = phi_1383_;
                                                            if _e1260 {
                                                                phi_2088_ = type_30();
                                                                phi_2089_ = true;
                                                                phi_2090_ = false;
                                                            } else {
                                                                let _e1262 = select(_e1202, _e1189, (_e1189 < _e1202));
                                                                if (select(_e1215, _e1262, (_e1262 < _e1215)) > 0f) {
                                                                    phi_1412_ = true;
                                                                } else {
                                                                    let _e1267 = select(_e1202, _e1189, (_e1189 > _e1202));
                                                                    phi_1412_ = (select(_e1215, _e1267, (_e1267 > _e1215)) < 0f);
                                                                }
                                                                let _e1272 = phi_1412_;
                                                                if _e1272 {
                                                                    phi_2086_ = type_30();
                                                                    phi_2087_ = false;
                                                                } else {
                                                                    let _e1274 = select(_e1175[1][0], _e1175[0][0], (_e1175[0][0] < _e1175[1][0]));
                                                                    let _e1278 = select(_e1175[1][0], _e1175[0][0], (_e1175[0][0] > _e1175[1][0]));
                                                                    let _e1282 = select(_e1175[1][1], _e1175[0][1], (_e1175[0][1] < _e1175[1][1]));
                                                                    let _e1286 = select(_e1175[1][1], _e1175[0][1], (_e1175[0][1] > _e1175[1][1]));
                                                                    let _e1290 = select(_e1175[1][2], _e1175[0][2], (_e1175[0][2] < _e1175[1][2]));
                                                                    let _e1294 = select(_e1175[1][2], _e1175[0][2], (_e1175[0][2] > _e1175[1][2]));
                                                                    let _e1299 = ((select(_e1175[2][0], _e1274, (_e1274 < _e1175[2][0])) - _e425) * _e430);
                                                                    let _e1300 = ((select(_e1175[2][0], _e1278, (_e1278 > _e1175[2][0])) - _e426) * _e430);
                                                                    let _e1303 = ((select(_e1175[2][1], _e1282, (_e1282 < _e1175[2][1])) - _e461) * _e466);
                                                                    let _e1304 = ((select(_e1175[2][1], _e1286, (_e1286 > _e1175[2][1])) - _e462) * _e466);
                                                                    let _e1307 = ((select(_e1175[2][2], _e1290, (_e1290 < _e1175[2][2])) - _e497) * _e502);
                                                                    let _e1308 = ((select(_e1175[2][2], _e1294, (_e1294 > _e1175[2][2])) - _e498) * _e502);
                                                                    let _e1310 = select(_e1308, _e1307, (_e1307 < _e1308));
                                                                    let _e1312 = select(_e1308, _e1307, (_e1307 > _e1308));
                                                                    let _e1314 = select(_e1300, _e1299, (_e1299 < _e1300));
                                                                    let _e1316 = select(_e1304, _e1303, (_e1303 < _e1304));
                                                                    let _e1318 = select(_e1316, _e1314, (_e1314 > _e1316));
                                                                    let _e1320 = select(_e1310, _e1318, (_e1318 > _e1310));
                                                                    let _e1322 = select(_e1300, _e1299, (_e1299 > _e1300));
                                                                    let _e1324 = select(_e1304, _e1303, (_e1303 > _e1304));
                                                                    let _e1326 = select(_e1324, _e1322, (_e1322 < _e1324));
                                                                    let _e1328 = select(_e1312, _e1326, (_e1326 < _e1312));
                                                                    let _e1329 = -(_e1310);
                                                                    let _e1335 = select(_e548, _e1320, (_e1320 > _e548));
                                                                    if (_e1335 > (_e1328 + (select(_e1329, _e1312, (_e1312 > _e1329)) * 0.0000019073523f))) {
                                                                        phi_2081_ = type_30();
                                                                        phi_2082_ = true;
                                                                    } else {
                                                                        let _e1337 = (_e1335 > _e1079.member);
                                                                        if _e1337 {
                                                                            phi_2080_ = type_30();
                                                                        } else {
                                                                            let _e1338 = vec3<f32>(_e1175[0][0], _e1175[0][1], _e1175[0][2]);
                                                                            let _e1339 = vec3<f32>(_e1175[1][0], _e1175[1][1], _e1175[1][2]);
                                                                            let _e1340 = vec3<f32>(_e1175[2][0], _e1175[2][1], _e1175[2][2]);
                                                                            let _e1341 = (_e1175[1][0] - _e1175[0][0]);
                                                                            let _e1342 = (_e1175[1][1] - _e1175[0][1]);
                                                                            let _e1343 = (_e1175[1][2] - _e1175[0][2]);
                                                                            let _e1344 = vec3<f32>(_e1341, _e1342, _e1343);
                                                                            let _e1345 = (_e1175[2][0] - _e1175[1][0]);
                                                                            let _e1346 = (_e1175[2][1] - _e1175[1][1]);
                                                                            let _e1347 = (_e1175[2][2] - _e1175[1][2]);
                                                                            let _e1348 = vec3<f32>(_e1345, _e1346, _e1347);
                                                                            let _e1349 = (_e1175[0][0] - _e1175[2][0]);
                                                                            let _e1350 = (_e1175[0][1] - _e1175[2][1]);
                                                                            let _e1351 = (_e1175[0][2] - _e1175[2][2]);
                                                                            let _e1352 = vec3<f32>(_e1349, _e1350, _e1351);
                                                                            let _e1355 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                            let _e1358 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                            let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                                            let _e1363 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                            let _e1365 = select(_e1363, _e1360, (_e1360 > _e1363));
                                                                            let _e1368 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                            let _e1371 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                            let _e1373 = select(_e1371, _e1368, (_e1368 > _e1371));
                                                                            let _e1376 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                            let _e1378 = select(_e1376, _e1373, (_e1373 > _e1376));
                                                                            let _e1381 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                            let _e1384 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                            let _e1386 = select(_e1384, _e1381, (_e1381 > _e1384));
                                                                            let _e1389 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                            let _e1391 = select(_e1389, _e1386, (_e1386 > _e1389));
                                                                            let _e1393 = select(_e1378, _e1365, (_e1365 > _e1378));
                                                                            let _e1395 = select(_e1391, _e1393, (_e1393 > _e1391));
                                                                            if (_e1365 == _e1395) {
                                                                                phi_1813_ = _e1202;
                                                                                phi_1814_ = _e1199;
                                                                                phi_1815_ = _e1189;
                                                                                phi_1816_ = _e1186;
                                                                                phi_1817_ = _e1338;
                                                                                phi_1818_ = _e1352;
                                                                                phi_1819_ = _e1348;
                                                                                phi_1820_ = _e1344;
                                                                            } else {
                                                                                let _e1397 = (_e1378 == _e1395);
                                                                                let _e1402 = vec3(_e1397);
                                                                                phi_1813_ = select(_e1189, _e1215, _e1397);
                                                                                phi_1814_ = select(_e1186, _e1212, _e1397);
                                                                                phi_1815_ = select(_e1215, _e1202, _e1397);
                                                                                phi_1816_ = select(_e1212, _e1199, _e1397);
                                                                                phi_1817_ = select(_e1340, _e1339, _e1402);
                                                                                phi_1818_ = select(_e1348, _e1344, _e1402);
                                                                                phi_1819_ = select(_e1344, _e1352, _e1402);
                                                                                phi_1820_ = select(_e1352, _e1348, _e1402);
                                                                            }
                                                                            let _e1408 = phi_1813_;
                                                                            let _e1410 = phi_1814_;
                                                                            let _e1412 = phi_1815_;
                                                                            let _e1414 = phi_1816_;
                                                                            let _e1416 = phi_1817_;
                                                                            let _e1418 = phi_1818_;
                                                                            let _e1420 = phi_1819_;
                                                                            let _e1422 = phi_1820_;
                                                                            let _e1429 = ((_e1420.y * _e1418.z) - (_e1418.y * _e1420.z));
                                                                            let _e1434 = ((_e1420.z * _e1418.x) - (_e1418.z * _e1420.x));
                                                                            let _e1437 = ((_e1420.x * _e1418.y) - (_e1418.x * _e1420.y));
                                                                            if (_e1237 >= _e1241) {
                                                                                phi_1851_ = select(true, false, (_e1237 >= _e1245));
                                                                            } else {
                                                                                phi_1851_ = true;
                                                                            }
                                                                            let _e1442 = phi_1851_;
                                                                            if _e1442 {
                                                                                phi_1860_ = select(_e1340, _e1339, vec3((_e1241 >= _e1245)));
                                                                            } else {
                                                                                phi_1860_ = _e1338;
                                                                            }
                                                                            let _e1447 = phi_1860_;
                                                                            let _e1458 = (((_e1429 * (_e1447.x - _e402)) + (_e1434 * (_e1447.y - _e439))) + (_e1437 * (_e1447.z - _e475)));
                                                                            let _e1463 = (((_e1429 * _e427) + (_e1434 * _e463)) + (_e1437 * _e499));
                                                                            let _e1464 = (_e1410 - _e1414);
                                                                            let _e1465 = (_e1408 - _e1412);
                                                                            let _e1473 = (-(((_e1414 * _e1464) + (_e1412 * _e1465))) / ((_e1464 * _e1464) + (_e1465 * _e1465)));
                                                                            let _e1475 = select(1f, _e1473, (_e1473 < 1f));
                                                                            let _e1477 = select(0f, _e1475, (_e1475 > 0f));
                                                                            let _e1490 = ((_e1416.x + (_e1422.x * _e1477)) - _e402);
                                                                            let _e1491 = ((_e1416.y + (_e1422.y * _e1477)) - _e439);
                                                                            let _e1492 = ((_e1416.z + (_e1422.z * _e1477)) - _e475);
                                                                            let _e1493 = (_e1492 / _e499);
                                                                            let _e1505 = bitcast<f32>((bitcast<u32>(_e1490) & 2147483647u));
                                                                            let _e1508 = bitcast<f32>((bitcast<u32>(_e1491) & 2147483647u));
                                                                            let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                            let _e1513 = bitcast<f32>((bitcast<u32>(_e1492) & 2147483647u));
                                                                            let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                            let _e1521 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                            let _e1524 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                            let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                            let _e1529 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1429 * _e1490) + (_e1434 * _e1491)) + (_e1437 * _e1492)) - _e1458)) & 2147483647u)) <= ((0.0000009536743f * select(_e1395, _e1515, (_e1515 > _e1395))) * select(_e1529, _e1526, (_e1526 > _e1529)))) {
                                                                                let _e1539 = bitcast<f32>((bitcast<u32>(_e1420.x) & 2147483647u));
                                                                                let _e1542 = bitcast<f32>((bitcast<u32>(_e1420.y) & 2147483647u));
                                                                                let _e1544 = select(_e1542, _e1539, (_e1539 > _e1542));
                                                                                let _e1547 = bitcast<f32>((bitcast<u32>(_e1420.z) & 2147483647u));
                                                                                let _e1553 = bitcast<f32>((bitcast<u32>(_e1418.x) & 2147483647u));
                                                                                let _e1556 = bitcast<f32>((bitcast<u32>(_e1418.y) & 2147483647u));
                                                                                let _e1558 = select(_e1556, _e1553, (_e1553 > _e1556));
                                                                                let _e1561 = bitcast<f32>((bitcast<u32>(_e1418.z) & 2147483647u));
                                                                                let _e1565 = (bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u)) > ((0.0000038146973f * select(_e1547, _e1544, (_e1544 > _e1547))) * select(_e1561, _e1558, (_e1558 > _e1561))));
                                                                                if _e1565 {
                                                                                    phi_2025_ = (_e1458 / _e1463);
                                                                                } else {
                                                                                    phi_2025_ = f32();
                                                                                }
                                                                                let _e1568 = phi_2025_;
                                                                                phi_2027_ = _e1568;
                                                                                phi_2028_ = select(true, false, _e1565);
                                                                            } else {
                                                                                phi_2027_ = f32();
                                                                                phi_2028_ = true;
                                                                            }
                                                                            let _e1571 = phi_2027_;
                                                                            let _e1573 = phi_2028_;
                                                                            if _e1573 {
                                                                                let _e1581 = (((_e1429 * (_e1490 - (_e427 * _e1493))) + (_e1434 * (_e1491 - (_e463 * _e1493)))) / _e1463);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)) <= _e1395) {
                                                                                    phi_2048_ = (_e1493 + _e1581);
                                                                                } else {
                                                                                    phi_2048_ = _e1493;
                                                                                }
                                                                                let _e1588 = phi_2048_;
                                                                                phi_2049_ = _e1588;
                                                                            } else {
                                                                                phi_2049_ = _e1571;
                                                                            }
                                                                            let _e1590 = phi_2049_;
                                                                            let _e1592 = select(_e1328, _e1590, (_e1590 < _e1328));
                                                                            let _e1594 = select(_e1320, _e1592, (_e1592 > _e1320));
                                                                            if (_e1594 >= _e548) {
                                                                                let _e1596 = (_e1594 <= _e1079.member);
                                                                                if _e1596 {
                                                                                    let _e1597 = (1f / _e1247);
                                                                                    phi_2072_ = type_30(_e1594, (_e1241 * _e1597), (_e1245 * _e1597), _e1108);
                                                                                } else {
                                                                                    phi_2072_ = type_30();
                                                                                }
                                                                                let _e1602 = phi_2072_;
                                                                                phi_2074_ = _e1602;
                                                                                phi_2075_ = select(true, false, _e1596);
                                                                            } else {
                                                                                phi_2074_ = type_30();
                                                                                phi_2075_ = true;
                                                                            }
                                                                            let _e1605 = phi_2074_;
                                                                            let _e1607 = phi_2075_;
                                                                            if _e1607 {
                                                                                phi_2079_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2079_ = _e1605;
                                                                            }
                                                                            let _e1609 = phi_2079_;
                                                                            phi_2080_ = _e1609;
                                                                        }
                                                                        let _e1611 = phi_2080_;
                                                                        phi_2081_ = _e1611;
                                                                        phi_2082_ = _e1337;
                                                                    }
                                                                    let _e1613 = phi_2081_;
                                                                    let _e1615 = phi_2082_;
                                                                    phi_2086_ = _e1613;
                                                                    phi_2087_ = _e1615;
                                                                }
                                                                let _e1617 = phi_2086_;
                                                                let _e1619 = phi_2087_;
                                                                phi_2088_ = _e1617;
                                                                phi_2089_ = _e1272;
                                                                phi_2090_ = _e1619;
                                                            }
                                                            let _e1621 = phi_2088_;
                                                            let _e1623 = phi_2089_;
                                                            let _e1625 = phi_2090_;
                                                            phi_2091_ = _e1621;
                                                            phi_2092_ = _e1623;
                                                            phi_2093_ = _e1625;
                                                        }
                                                        let _e1627 = phi_2091_;
                                                        let _e1629 = phi_2092_;
                                                        let _e1631 = phi_2093_;
                                                        phi_2101_ = _e1627;
                                                        phi_2102_ = select(_e1631, true, _e1629);
                                                    } else {
                                                        phi_2101_ = type_30();
                                                        phi_2102_ = true;
                                                    }
                                                    let _e1634 = phi_2101_;
                                                    let _e1636 = phi_2102_;
                                                    if _e1636 {
                                                        phi_2106_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2106_ = _e1634;
                                                    }
                                                    let _e1638 = phi_2106_;
                                                    if (_e1638.member_3 != 4294967295u) {
                                                        if (_e1108 == _e165) {
                                                            phi_2435_ = false;
                                                        } else {
                                                            let _e1642 = (_e1108 < arrayLength((&global_7.member)));
                                                            if _e1642 {
                                                                if _e1642 {
                                                                } else {
                                                                    phi_3905_ = true;
                                                                    break;
                                                                }
                                                                let _e1644 = global_7.member[_e1108];
                                                                phi_2129_ = _e1644;
                                                            } else {
                                                                phi_2129_ = 4294967295u;
                                                            }
                                                            let _e1646 = phi_2129_;
                                                            let _e1647 = (_e1646 < arrayLength((&global_8.member)));
                                                            if _e1647 {
                                                                if _e1647 {
                                                                } else {
                                                                    phi_3905_ = true;
                                                                    break;
                                                                }
                                                                let _e1649 = global_8.member[_e1646];
                                                                phi_2143_ = _e1649;
                                                            } else {
                                                                phi_2143_ = 0i;
                                                            }
                                                            let _e1651 = phi_2143_;
                                                            let _e1652 = (_e1651 == 0i);
                                                            if _e1652 {
                                                                phi_2434_ = true;
                                                            } else {
                                                                if _e394 {
                                                                    phi_2164_ = vec3<f32>(_e1175[0][0], _e1175[0][1], _e1175[0][2]);
                                                                } else {
                                                                    if (_e370 == 1u) {
                                                                        phi_2163_ = vec3<f32>(_e1175[0][2], _e1175[0][0], _e1175[0][1]);
                                                                    } else {
                                                                        phi_2163_ = vec3<f32>(_e1175[0][1], _e1175[0][2], _e1175[0][0]);
                                                                    }
                                                                    let _e1657 = phi_2163_;
                                                                    phi_2164_ = _e1657;
                                                                }
                                                                let _e1660 = phi_2164_;
                                                                if _e394 {
                                                                    phi_2181_ = vec3<f32>(_e1175[1][0], _e1175[1][1], _e1175[1][2]);
                                                                } else {
                                                                    if (_e370 == 1u) {
                                                                        phi_2180_ = vec3<f32>(_e1175[1][2], _e1175[1][0], _e1175[1][1]);
                                                                    } else {
                                                                        phi_2180_ = vec3<f32>(_e1175[1][1], _e1175[1][2], _e1175[1][0]);
                                                                    }
                                                                    let _e1665 = phi_2180_;
                                                                    phi_2181_ = _e1665;
                                                                }
                                                                let _e1668 = phi_2181_;
                                                                if _e394 {
                                                                    phi_2198_ = vec3<f32>(_e1175[2][0], _e1175[2][1], _e1175[2][2]);
                                                                } else {
                                                                    if (_e370 == 1u) {
                                                                        phi_2197_ = vec3<f32>(_e1175[2][2], _e1175[2][0], _e1175[2][1]);
                                                                    } else {
                                                                        phi_2197_ = vec3<f32>(_e1175[2][1], _e1175[2][2], _e1175[2][0]);
                                                                    }
                                                                    let _e1673 = phi_2197_;
                                                                    phi_2198_ = _e1673;
                                                                }
                                                                let _e1676 = phi_2198_;
                                                                let _e1679 = (_e1668.x - _e1660.x);
                                                                let _e1682 = (_e1668.y - _e1660.y);
                                                                let _e1685 = (_e1668.z - _e1660.z);
                                                                let _e1687 = (_e1676.x - _e1660.x);
                                                                let _e1689 = (_e1676.y - _e1660.y);
                                                                let _e1691 = (_e1676.z - _e1660.z);
                                                                if (_e237.member_1 == 1u) {
                                                                    phi_2234_ = (vec3<f32>(_e237.member[0], _e237.member[1], _e237.member[2]) - _e1660);
                                                                } else {
                                                                    phi_2234_ = vec3<f32>(_e237.member[0], _e237.member[1], _e237.member[2]);
                                                                }
                                                                let _e1706 = phi_2234_;
                                                                let _e1712 = bitcast<f32>((bitcast<u32>((_e1679 * _e1689)) ^ _e237.member_3[0]));
                                                                let _e1716 = bitcast<f32>((bitcast<u32>((_e1682 * _e1687)) ^ _e237.member_3[0]));
                                                                let _e1720 = bitcast<f32>((bitcast<u32>((_e1682 * _e1691)) ^ _e237.member_3[0]));
                                                                let _e1724 = bitcast<f32>((bitcast<u32>((_e1685 * _e1689)) ^ _e237.member_3[0]));
                                                                let _e1728 = bitcast<f32>((bitcast<u32>((_e1685 * _e1687)) ^ _e237.member_3[0]));
                                                                let _e1732 = bitcast<f32>((bitcast<u32>((_e1679 * _e1691)) ^ _e237.member_3[0]));
                                                                let _e1733 = (_e1720 - _e1724);
                                                                let _e1734 = (_e1728 - _e1732);
                                                                let _e1735 = (_e1712 - _e1716);
                                                                let _e1759 = (bitcast<f32>((bitcast<u32>(_e1720) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u)));
                                                                let _e1766 = (bitcast<f32>((bitcast<u32>(_e1728) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1732) & 2147483647u)));
                                                                let _e1773 = (bitcast<f32>((bitcast<u32>(_e1712) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u)));
                                                                if (_e237.member_2 == 0f) {
                                                                    phi_2416_ = 0f;
                                                                } else {
                                                                    let _e1803 = bitcast<f32>((bitcast<u32>(_e1733) & 2147483647u));
                                                                    let _e1806 = bitcast<f32>((bitcast<u32>(_e1734) & 2147483647u));
                                                                    let _e1809 = bitcast<f32>((bitcast<u32>(_e1735) & 2147483647u));
                                                                    let _e1811 = select(_e1809, _e1806, (_e1806 > _e1809));
                                                                    let _e1815 = select(_e1809, _e1806, (_e1806 < _e1809));
                                                                    let _e1819 = select(_e1806, _e1803, (_e1803 < _e1806));
                                                                    let _e1821 = select(_e1806, _e1803, (_e1803 > _e1806));
                                                                    let _e1823 = select(_e1809, _e1821, (_e1821 < _e1809));
                                                                    phi_2416_ = bitcast<f32>((bitcast<u32>((_e237.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1811, _e1803, (_e1803 > _e1811)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1823, _e1819, (_e1819 > _e1823)))) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1815, _e1803, (_e1803 < _e1815)))) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1759 + _e1766) + _e1773))) ^ _e237.member_3[0]))) * 1.0000005f)) ^ _e237.member_3[0])))) ^ _e237.member_3[0]));
                                                                }
                                                                let _e1850 = phi_2416_;
                                                                phi_2434_ = (_e1652 || !(((((bitcast<f32>((bitcast<u32>((_e1706.x * _e1733)) ^ _e237.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1706.y * _e1734)) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1706.z * _e1735)) ^ _e237.member_3[0]))) * f32(-(_e1651))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1706.x) & 2147483647u)) * _e1759)) ^ _e237.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1706.y) & 2147483647u)) * _e1766)) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1706.z) & 2147483647u)) * _e1773)) ^ _e237.member_3[0]))))) ^ _e237.member_3[0])) + _e1850) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1864 = phi_2434_;
                                                            phi_2435_ = _e1864;
                                                        }
                                                        let _e1866 = phi_2435_;
                                                        if _e1866 {
                                                            phi_2440_ = type_51(_e1079.member, true);
                                                        } else {
                                                            phi_2440_ = _e1079;
                                                        }
                                                        let _e1871 = phi_2440_;
                                                        phi_2441_ = _e1871;
                                                    } else {
                                                        phi_2441_ = _e1079;
                                                    }
                                                    let _e1873 = phi_2441_;
                                                    phi_1131_ = _e1873;
                                                } else {
                                                    phi_1131_ = type_51();
                                                }
                                                let _e1875 = phi_1131_;
                                                continue;
                                                continuing {
                                                    phi_1130_ = _e1875;
                                                    phi_1133_ = _e1094;
                                                    phi_3905_ = _e590;
                                                    break if !(_e1100);
                                                }
                                            }
                                            let _e1878 = phi_3905_;
                                            phi_4071_ = _e1878;
                                            if _e1878 {
                                                break;
                                            }
                                            let _e1880 = local_10;
                                            phi_4075_ = _e1878;
                                            let _e2086 = local_12;
                                            phi_3647_ = _e2086;
                                            phi_3648_ = _e631;
                                            phi_3649_ = false;
                                            phi_3650_ = select(_e635, 0u, _e1880.member_1);
                                        } else {
                                            if (_e631.member_1 >= _e98) {
                                                phi_3203_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e631.member_1 < _e98) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e647 = ((1u + _e370) % 4u);
                                                if (_e647 < 4u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e652 = global_5.member[_e631.member_1][_e647];
                                                let _e654 = (_e652 >> bitcast<u32>(11u));
                                                let _e656 = ((1u + _e369) % 4u);
                                                if (_e656 < 4u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e661 = global_5.member[_e631.member_1][_e656];
                                                let _e663 = (_e661 >> bitcast<u32>(11u));
                                                let _e665 = ((1u + _e371) % 4u);
                                                if (_e665 < 4u) {
                                                } else {
                                                    phi_4071_ = true;
                                                    break;
                                                }
                                                let _e670 = global_5.member[_e631.member_1][_e665];
                                                let _e672 = (_e670 >> bitcast<u32>(11u));
                                                let _e695 = (bitcast<f32>((bitcast<u32>((_e631.member.member_1.x - _e631.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e696 = (bitcast<f32>((bitcast<u32>((_e631.member.member_1.y - _e631.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e697 = (bitcast<f32>((bitcast<u32>((_e631.member.member_1.z - _e631.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e699 = select(_e156, _e695, (_e695 > _e156));
                                                let _e701 = select(_e156, _e696, (_e696 > _e156));
                                                let _e703 = select(_e156, _e697, (_e697 > _e156));
                                                let _e728 = bitcast<u32>((f32(bitcast<i32>((_e652 & 1023u))) * _e699));
                                                let _e733 = (bitcast<i32>((_e652 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e736 = bitcast<f32>((_e728 & bitcast<u32>(_e733)));
                                                let _e737 = bitcast<u32>((f32(bitcast<i32>((_e661 & 1023u))) * _e701));
                                                let _e742 = (bitcast<i32>((_e661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e745 = bitcast<f32>((_e737 & bitcast<u32>(_e742)));
                                                let _e746 = bitcast<u32>((f32(bitcast<i32>((_e670 & 1023u))) * _e703));
                                                let _e751 = (bitcast<i32>((_e670 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e754 = bitcast<f32>((_e746 & bitcast<u32>(_e751)));
                                                let _e758 = bitcast<f32>((_e728 & bitcast<u32>(~(_e733))));
                                                let _e762 = bitcast<f32>((_e737 & bitcast<u32>(~(_e742))));
                                                let _e766 = bitcast<f32>((_e746 & bitcast<u32>(~(_e751))));
                                                let _e767 = bitcast<u32>((f32(bitcast<i32>((_e654 & 1023u))) * _e699));
                                                let _e772 = (bitcast<i32>((_e654 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e775 = bitcast<f32>((_e767 & bitcast<u32>(_e772)));
                                                let _e776 = bitcast<u32>((f32(bitcast<i32>((_e663 & 1023u))) * _e701));
                                                let _e781 = (bitcast<i32>((_e663 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e784 = bitcast<f32>((_e776 & bitcast<u32>(_e781)));
                                                let _e785 = bitcast<u32>((f32(bitcast<i32>((_e672 & 1023u))) * _e703));
                                                let _e790 = (bitcast<i32>((_e672 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e793 = bitcast<f32>((_e785 & bitcast<u32>(_e790)));
                                                let _e797 = bitcast<f32>((_e767 & bitcast<u32>(~(_e772))));
                                                let _e801 = bitcast<f32>((_e776 & bitcast<u32>(~(_e781))));
                                                let _e805 = bitcast<f32>((_e785 & bitcast<u32>(~(_e790))));
                                                let _e835 = global_5.member[_e631.member_1][0u];
                                                let _e839 = global_5.member[_e631.member_1][1u];
                                                let _e843 = global_5.member[_e631.member_1][2u];
                                                let _e847 = global_5.member[_e631.member_1][3u];
                                                let _e859 = (((_e839 >> bitcast<u32>(22i)) | ((_e843 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e847 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e860 = (_e835 & 268435455u);
                                                let _e861 = (_e859 & 268435455u);
                                                let _e864 = ((_e835 >> bitcast<u32>(28u)) & 7u);
                                                let _e872 = ((_e835 >> bitcast<u32>(31i)) | (((_e859 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e873 = (_e864 != 0u);
                                                if (_e864 == 0u) {
                                                    phi_3165_ = _e860;
                                                } else {
                                                    if (_e864 == 7u) {
                                                        phi_3164_ = 2147483648u;
                                                    } else {
                                                        phi_3164_ = ((2147483648u | (_e864 << bitcast<u32>(28u))) | (_e861 & 268435455u));
                                                    }
                                                    let _e882 = phi_3164_;
                                                    phi_3165_ = _e882;
                                                }
                                                let _e884 = phi_3165_;
                                                if _e873 {
                                                    let _e885 = (_e864 != 7u);
                                                    if _e885 {
                                                        phi_3175_ = (_e861 + _e864);
                                                    } else {
                                                        phi_3175_ = u32();
                                                    }
                                                    let _e888 = phi_3175_;
                                                    phi_3177_ = _e888;
                                                    phi_3178_ = select(true, false, _e885);
                                                } else {
                                                    phi_3177_ = u32();
                                                    phi_3178_ = true;
                                                }
                                                let _e891 = phi_3177_;
                                                let _e893 = phi_3178_;
                                                if (_e872 == 0u) {
                                                    phi_3199_ = (_e860 + select(0u, 1u, !(_e873)));
                                                } else {
                                                    if (_e872 == 7u) {
                                                        phi_3198_ = 2147483648u;
                                                    } else {
                                                        phi_3198_ = ((2147483648u | (_e872 << bitcast<u32>(28u))) | (select(_e891, _e861, _e893) & 268435455u));
                                                    }
                                                    let _e906 = phi_3198_;
                                                    phi_3199_ = _e906;
                                                }
                                                let _e908 = phi_3199_;
                                                phi_3203_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e631.member.member.x + _e736), (_e631.member.member.x + _e758), (_e631.member.member_1.x - _e775), (_e631.member.member_1.x - _e797)), vec4<f32>((_e631.member.member.y + _e745), (_e631.member.member.y + _e762), (_e631.member.member_1.y - _e784), (_e631.member.member_1.y - _e801)), vec4<f32>((_e631.member.member.z + _e754), (_e631.member.member.z + _e766), (_e631.member.member_1.z - _e793), (_e631.member.member_1.z - _e805))), type_63(type_39((_e631.member.member + vec4<f32>(_e736, _e745, _e754, 0f)), (_e631.member.member_1 - vec4<f32>(_e775, _e784, _e793, 0f))), _e884), type_63(type_39((_e631.member.member + vec4<f32>(_e758, _e762, _e766, 0f)), (_e631.member.member_1 - vec4<f32>(_e797, _e801, _e805, 0f))), _e908));
                                            }
                                            let _e913 = phi_3203_;
                                            let _e925 = ((_e913.member[0].x - _e425) * _e430);
                                            let _e926 = ((_e913.member[0].y - _e425) * _e430);
                                            let _e927 = ((_e913.member[0].z - _e426) * _e430);
                                            let _e928 = ((_e913.member[0].w - _e426) * _e430);
                                            let _e938 = ((_e913.member[1].x - _e461) * _e466);
                                            let _e939 = ((_e913.member[1].y - _e461) * _e466);
                                            let _e940 = ((_e913.member[1].z - _e462) * _e466);
                                            let _e941 = ((_e913.member[1].w - _e462) * _e466);
                                            let _e951 = ((_e913.member[2].x - _e497) * _e502);
                                            let _e952 = ((_e913.member[2].y - _e497) * _e502);
                                            let _e953 = ((_e913.member[2].z - _e498) * _e502);
                                            let _e954 = ((_e913.member[2].w - _e498) * _e502);
                                            let _e956 = select(_e953, _e951, (_e951 < _e953));
                                            let _e958 = select(_e954, _e952, (_e952 < _e954));
                                            let _e960 = select(_e953, _e951, (_e951 > _e953));
                                            let _e962 = select(_e954, _e952, (_e952 > _e954));
                                            let _e964 = select(_e927, _e925, (_e925 < _e927));
                                            let _e966 = select(_e928, _e926, (_e926 < _e928));
                                            let _e968 = select(_e940, _e938, (_e938 < _e940));
                                            let _e970 = select(_e941, _e939, (_e939 < _e941));
                                            let _e972 = select(_e968, _e964, (_e964 > _e968));
                                            let _e974 = select(_e970, _e966, (_e966 > _e970));
                                            let _e976 = select(_e956, _e972, (_e972 > _e956));
                                            let _e978 = select(_e958, _e974, (_e974 > _e958));
                                            let _e980 = select(_e927, _e925, (_e925 > _e927));
                                            let _e982 = select(_e928, _e926, (_e926 > _e928));
                                            let _e984 = select(_e940, _e938, (_e938 > _e940));
                                            let _e986 = select(_e941, _e939, (_e939 > _e941));
                                            let _e988 = select(_e984, _e980, (_e980 < _e984));
                                            let _e990 = select(_e986, _e982, (_e982 < _e986));
                                            let _e995 = -(_e956);
                                            let _e996 = -(_e958);
                                            let _e1003 = (select(_e960, _e988, (_e988 < _e960)) + (select(_e995, _e960, (_e960 > _e995)) * 0.0000019073523f));
                                            let _e1004 = (select(_e962, _e990, (_e990 < _e962)) + (select(_e996, _e962, (_e962 > _e996)) * 0.0000019073523f));
                                            let _e1006 = select(_e548, _e976, (_e976 > _e548));
                                            let _e1008 = select(_e548, _e978, (_e978 > _e548));
                                            let _e1013 = (_e1006 <= select(_e592.member, _e1003, (_e1003 < _e592.member)));
                                            let _e1014 = (_e1008 <= select(_e592.member, _e1004, (_e1004 < _e592.member)));
                                            let _e1015 = (_e1006 <= _e1008);
                                            if _e1013 {
                                                if _e1014 {
                                                    if _e1015 {
                                                        phi_3547_ = _e913.member_2;
                                                    } else {
                                                        phi_3547_ = _e913.member_1;
                                                    }
                                                    let _e1019 = phi_3547_;
                                                    let _e1041 = (_e635 % 128u);
                                                    let _e1042 = (_e1041 < 128u);
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1041] = _e1019.member_1;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1041] = _e1019.member.member.x;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1041] = _e1019.member.member.y;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1041] = _e1019.member.member.z;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1041] = _e1019.member.member_1.x;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1041] = _e1019.member.member_1.y;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1041] = _e1019.member.member_1.z;
                                                    if _e1042 {
                                                    } else {
                                                        phi_4071_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1041] = select(_e1008, _e1006, (_e1006 > _e1008));
                                                    if _e1015 {
                                                        phi_3624_ = _e913.member_1;
                                                    } else {
                                                        phi_3624_ = _e913.member_2;
                                                    }
                                                    let _e1055 = phi_3624_;
                                                    phi_3625_ = _e1055;
                                                    phi_3626_ = (_e635 + 1u);
                                                } else {
                                                    phi_3625_ = type_63();
                                                    phi_3626_ = u32();
                                                }
                                                let _e1057 = phi_3625_;
                                                let _e1059 = phi_3626_;
                                                phi_3628_ = _e1057;
                                                phi_3629_ = _e1059;
                                                phi_3630_ = select(true, false, _e1014);
                                            } else {
                                                phi_3628_ = type_63();
                                                phi_3629_ = u32();
                                                phi_3630_ = true;
                                            }
                                            let _e1062 = phi_3628_;
                                            let _e1064 = phi_3629_;
                                            let _e1066 = phi_3630_;
                                            if _e1066 {
                                                if _e1013 {
                                                    phi_3639_ = _e913.member_1;
                                                } else {
                                                    phi_3639_ = _e913.member_2;
                                                }
                                                let _e1070 = phi_3639_;
                                                phi_3644_ = _e1070;
                                                phi_3645_ = select(_e1014, true, _e1013);
                                            } else {
                                                phi_3644_ = _e1062;
                                                phi_3645_ = _e633;
                                            }
                                            let _e1073 = phi_3644_;
                                            let _e1075 = phi_3645_;
                                            phi_4075_ = _e590;
                                            phi_3647_ = _e592;
                                            phi_3648_ = _e1073;
                                            phi_3649_ = _e1075;
                                            phi_3650_ = select(_e1064, _e635, _e1066);
                                        }
                                        let _e1884 = phi_4075_;
                                        let _e1886 = phi_3647_;
                                        let _e1888 = phi_3648_;
                                        let _e1890 = phi_3649_;
                                        let _e1892 = phi_3650_;
                                        phi_4074_ = _e1884;
                                        phi_3651_ = _e1886;
                                        phi_3652_ = _e1888;
                                        phi_3653_ = (_e596 - 1u);
                                        phi_3654_ = _e1890;
                                        phi_3655_ = _e1892;
                                    } else {
                                        phi_4074_ = _e590;
                                        phi_3651_ = _e592;
                                        phi_3652_ = _e631;
                                        phi_3653_ = _e596;
                                        phi_3654_ = _e633;
                                        phi_3655_ = _e635;
                                    }
                                    let _e1894 = phi_4074_;
                                    let _e1896 = phi_3651_;
                                    let _e1898 = phi_3652_;
                                    let _e1900 = phi_3653_;
                                    let _e1902 = phi_3654_;
                                    let _e1904 = phi_3655_;
                                    phi_4073_ = _e1894;
                                    phi_3656_ = _e1896;
                                    phi_3657_ = _e1898;
                                    phi_3658_ = _e1900;
                                    phi_3659_ = _e1902;
                                    phi_3660_ = _e1904;
                                } else {
                                    phi_4073_ = _e590;
                                    phi_3656_ = type_51();
                                    phi_3657_ = type_63();
                                    phi_3658_ = u32();
                                    phi_3659_ = bool();
                                    phi_3660_ = u32();
                                }
                                let _e1906 = phi_4073_;
                                let _e1908 = phi_3656_;
                                let _e1910 = phi_3657_;
                                let _e1912 = phi_3658_;
                                let _e1914 = phi_3659_;
                                let _e1916 = phi_3660_;
                                phi_4072_ = _e1906;
                                phi_1005_ = _e1908;
                                phi_1008_ = _e1910;
                                phi_1010_ = _e1912;
                                phi_1012_ = _e1914;
                                phi_1014_ = _e1916;
                                phi_3661_ = _e604;
                            } else {
                                phi_4072_ = _e590;
                                phi_1005_ = type_51();
                                phi_1008_ = type_63();
                                phi_1010_ = u32();
                                phi_1012_ = bool();
                                phi_1014_ = u32();
                                phi_3661_ = false;
                            }
                            let _e1918 = phi_4072_;
                            let _e1920 = phi_1005_;
                            let _e1922 = phi_1008_;
                            let _e1924 = phi_1010_;
                            let _e1926 = phi_1012_;
                            let _e1928 = phi_1014_;
                            let _e1930 = phi_3661_;
                            continue;
                            continuing {
                                phi_3911_ = _e1918;
                                phi_1004_ = _e1920;
                                phi_1007_ = _e1922;
                                phi_1009_ = _e1924;
                                phi_1011_ = _e1926;
                                phi_1013_ = _e1928;
                                phi_4071_ = _e1918;
                                break if !(_e1930);
                            }
                        }
                        let _e1933 = phi_4071_;
                        if _e1933 {
                            break;
                        }
                        let _e1935 = local_11;
                        if _e1935.member_1 {
                        } else {
                            if _e238 {
                            } else {
                                break;
                            }
                            let _e1939 = global_2.member[_e144];
                            if _e159 {
                            } else {
                                break;
                            }
                            let _e1943 = global_10.member[_e144].member_1;
                            if _e238 {
                            } else {
                                break;
                            }
                            global_2.member[_e144] = type_32(_e1939.member, _e1939.member_1, _e1939.member_2, array<f32, 3>((_e1939.member_3[0] + (_e1943[0] * _e1939.member_1[0])), (_e1939.member_3[1] + (_e1943[1] * _e1939.member_1[1])), (_e1939.member_3[2] + (_e1943[2] * _e1939.member_1[2]))), _e1939.member_4);
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
