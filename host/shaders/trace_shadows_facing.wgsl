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
    var phi_295_: i32;
    var phi_319_: type_47;
    var phi_429_: i32;
    var phi_430_: i32;
    var phi_440_: bool;
    var phi_450_: u32;
    var phi_451_: u32;
    var phi_453_: bool;
    var phi_458_: u32;
    var phi_490_: i32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_640_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_686_: f32;
    var phi_697_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_2732_: bool;
    var phi_1072_: type_54;
    var phi_1075_: u32;
    var phi_1077_: u32;
    var phi_1079_: bool;
    var phi_1081_: u32;
    var phi_1092_: bool;
    var phi_1123_: u32;
    var phi_1124_: bool;
    var phi_1125_: u32;
    var phi_2248_: type_53;
    var phi_2592_: u32;
    var phi_2619_: u32;
    var phi_2620_: u32;
    var phi_2621_: u32;
    var phi_2623_: u32;
    var phi_2624_: u32;
    var phi_2625_: bool;
    var phi_2634_: u32;
    var phi_2639_: u32;
    var phi_2640_: bool;
    var phi_1140_: type_54;
    var phi_1143_: type_8;
    var phi_1144_: type_8;
    var phi_1166_: type_8;
    var phi_1187_: u32;
    var phi_1276_: array<array<f32, 3>, 3>;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1779_: bool;
    var phi_1788_: vec3<f32>;
    var phi_1828_: type_28;
    var phi_1830_: type_28;
    var phi_1831_: bool;
    var phi_1835_: type_28;
    var phi_1836_: type_28;
    var phi_1837_: type_28;
    var phi_1838_: bool;
    var phi_1842_: type_28;
    var phi_1843_: bool;
    var phi_1847_: type_28;
    var phi_1848_: bool;
    var phi_1852_: type_28;
    var phi_1875_: u32;
    var phi_1889_: i32;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1926_: vec3<f32>;
    var phi_1927_: vec3<f32>;
    var phi_1943_: vec3<f32>;
    var phi_1944_: vec3<f32>;
    var phi_1980_: vec3<f32>;
    var phi_2162_: f32;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2186_: type_54;
    var phi_2187_: type_54;
    var phi_1141_: type_54;
    var phi_2726_: bool;
    var local_2: type_54;
    var phi_2867_: bool;
    var phi_2642_: type_54;
    var phi_2643_: u32;
    var phi_2644_: bool;
    var phi_2645_: u32;
    var phi_2866_: bool;
    var phi_2646_: type_54;
    var phi_2647_: u32;
    var phi_2648_: u32;
    var phi_2649_: bool;
    var phi_2650_: u32;
    var phi_2865_: bool;
    var phi_2651_: type_54;
    var phi_2652_: u32;
    var phi_2653_: u32;
    var phi_2654_: bool;
    var phi_2655_: u32;
    var phi_2864_: bool;
    var phi_1073_: type_54;
    var phi_1076_: u32;
    var phi_1078_: u32;
    var phi_1080_: bool;
    var phi_1082_: u32;
    var phi_2656_: bool;
    var phi_2863_: bool;
    var local_3: type_54;
    var local_4: type_54;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_3.member));
            let _e77 = arrayLength((&global_4.member));
            let _e89 = arrayLength((&global_7.member));
            let _e93 = (_e73.x + (_e73.y * 2097152u));
            let _e94 = (_e93 < arrayLength((&global_8.member)));
            if _e94 {
                let _e95 = (_e93 < arrayLength((&global_9.member)));
                if _e95 {
                    if _e94 {
                    } else {
                        break;
                    }
                    let _e100 = global_8.member[_e93].member.member_1;
                    let _e105 = global_8.member[_e93].member.member_3;
                    if (_e100 <= _e105) {
                        let _e107 = (1u < _e89);
                        if _e107 {
                            if (0u < _e89) {
                            } else {
                                break;
                            }
                            let _e111 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e111 + 1u) < _e111) {
                                if _e107 {
                                } else {
                                    break;
                                }
                                let _e116 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        let _e119 = global_1.member[0u];
                        let _e123 = global_2.member[0u][0u];
                        let _e127 = global_2.member[0u][1u];
                        let _e131 = global_2.member[0u][2u];
                        let _e135 = global_2.member[0u][3u];
                        let _e139 = global_2.member[1u][0u];
                        let _e143 = global_2.member[1u][1u];
                        let _e147 = global_2.member[1u][2u];
                        let _e151 = global_2.member[1u][3u];
                        let _e152 = bitcast<f32>(_e123);
                        let _e153 = bitcast<f32>(_e127);
                        let _e154 = bitcast<f32>(_e131);
                        let _e156 = bitcast<f32>(_e139);
                        let _e157 = array<u32, 3>(_e143, _e147, _e151);
                        let _e159 = bitcast<i32>(_e119);
                        if (_e159 < -126i) {
                            phi_295_ = -126i;
                        } else {
                            phi_295_ = select(_e159, 127i, (_e159 > 127i));
                        }
                        let _e164 = phi_295_;
                        let _e169 = bitcast<f32>((bitcast<u32>((_e164 + 127i)) << bitcast<u32>(23i)));
                        let _e175 = bitcast<f32>((bitcast<u32>(((_e159 - _e164) + 127i)) << bitcast<u32>(23i)));
                        if (_e135 == 0u) {
                            phi_319_ = type_47(array<f32, 3>(_e152, _e153, _e154), _e135, _e156, _e157);
                        } else {
                            phi_319_ = type_47(array<f32, 3>(((_e152 * _e169) * _e175), ((_e153 * _e169) * _e175), ((_e154 * _e169) * _e175)), _e135, ((_e156 * _e169) * _e175), _e157);
                        }
                        let _e188 = phi_319_;
                        if _e94 {
                        } else {
                            break;
                        }
                        if _e94 {
                        } else {
                            break;
                        }
                        let _e192 = global_8.member[_e93].member_2;
                        let _e202 = global_8.member[_e93].member.member_2[0u];
                        let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                        let _e210 = global_8.member[_e93].member.member_2[1u];
                        let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                        let _e218 = global_8.member[_e93].member.member_2[2u];
                        let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                        let _e226 = global_8.member[_e93].member.member[0u];
                        let _e228 = (bitcast<u32>(_e226) & 2147483647u);
                        let _e234 = global_8.member[_e93].member.member[1u];
                        let _e236 = (bitcast<u32>(_e234) & 2147483647u);
                        let _e242 = global_8.member[_e93].member.member[2u];
                        let _e244 = (bitcast<u32>(_e242) & 2147483647u);
                        let _e246 = select(_e212, _e204, (_e212 < _e204));
                        let _e248 = select(_e220, _e246, (_e220 < _e246));
                        let _e250 = select(_e228, _e248, (_e228 < _e248));
                        let _e252 = select(_e236, _e250, (_e236 < _e250));
                        let _e254 = select(_e244, _e252, (_e244 < _e252));
                        let _e256 = (bitcast<u32>(_e100) & 2147483647u);
                        let _e265 = (((select(_e256, _e254, (_e256 < _e254)) < 2139095040u) && ((bitcast<u32>(_e105) & 2147483647u) <= 2139095040u)) && (_e248 > 0u));
                        if _e265 {
                            let _e268 = (bitcast<u32>(bitcast<f32>(_e248)) & 2147483647u);
                            if (_e268 >= 8388608u) {
                                phi_429_ = (bitcast<i32>((_e268 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_429_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e268)), 32u, (_e268 == 0u))));
                            }
                            let _e282 = phi_429_;
                            phi_430_ = _e282;
                        } else {
                            phi_430_ = 0i;
                        }
                        let _e284 = phi_430_;
                        let _e285 = (_e204 == _e248);
                        if _e285 {
                            phi_440_ = true;
                        } else {
                            phi_440_ = (_e212 == _e248);
                        }
                        let _e288 = phi_440_;
                        let _e289 = select(1u, 0u, _e285);
                        if _e288 {
                            let _e290 = (_e289 + 1u);
                            phi_450_ = _e290;
                            phi_451_ = _e290;
                            phi_453_ = select(true, false, (_e290 == 2u));
                        } else {
                            phi_450_ = u32();
                            phi_451_ = 0u;
                            phi_453_ = true;
                        }
                        let _e294 = phi_450_;
                        let _e296 = phi_451_;
                        let _e298 = phi_453_;
                        if _e298 {
                            phi_458_ = (_e296 + 1u);
                        } else {
                            phi_458_ = 0u;
                        }
                        let _e302 = phi_458_;
                        let _e303 = select(_e294, _e296, _e298);
                        let _e304 = select(_e289, select(2u, _e289, _e288), _e298);
                        let _e305 = -(_e284);
                        if (_e305 < -126i) {
                            phi_490_ = -126i;
                        } else {
                            phi_490_ = select(_e305, 127i, (_e305 > 127i));
                        }
                        let _e310 = phi_490_;
                        let _e315 = bitcast<f32>((bitcast<u32>((_e310 + 127i)) << bitcast<u32>(23i)));
                        let _e321 = bitcast<f32>((bitcast<u32>(((_e305 - _e310) + 127i)) << bitcast<u32>(23i)));
                        let _e326 = global_8.member[_e93].member.member;
                        let _e327 = (_e303 == 0u);
                        if _e327 {
                            phi_508_ = _e326[0];
                        } else {
                            phi_508_ = _e326[1];
                        }
                        let _e331 = phi_508_;
                        let _e332 = (_e303 == 2u);
                        if _e332 {
                            phi_514_ = _e326[2];
                        } else {
                            phi_514_ = _e331;
                        }
                        let _e335 = phi_514_;
                        let _e336 = global_8.member[_e93].member.member_2;
                        if _e327 {
                            phi_525_ = _e336[0];
                        } else {
                            phi_525_ = _e336[1];
                        }
                        let _e340 = phi_525_;
                        if _e332 {
                            phi_531_ = _e336[2];
                        } else {
                            phi_531_ = _e340;
                        }
                        let _e343 = phi_531_;
                        let _e345 = ((_e343 * _e315) * _e321);
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e349 {
                            let _e353 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) * 0.00000011920929f);
                            phi_554_ = select(0.00000000000011368684f, _e353, (_e353 > 0.00000000000011368684f));
                        } else {
                            phi_554_ = 0f;
                        }
                        let _e357 = phi_554_;
                        let _e358 = (_e335 + _e357);
                        let _e359 = (_e335 - _e357);
                        let _e360 = select(_e345, 0f, _e349);
                        if _e349 {
                            phi_565_ = 38685626000000000000000000f;
                        } else {
                            phi_565_ = (1f / _e345);
                        }
                        let _e363 = phi_565_;
                        let _e364 = (_e302 == 0u);
                        if _e364 {
                            phi_574_ = _e326[0];
                        } else {
                            phi_574_ = _e326[1];
                        }
                        let _e368 = phi_574_;
                        let _e369 = (_e302 == 2u);
                        if _e369 {
                            phi_580_ = _e326[2];
                        } else {
                            phi_580_ = _e368;
                        }
                        let _e372 = phi_580_;
                        if _e364 {
                            phi_591_ = _e336[0];
                        } else {
                            phi_591_ = _e336[1];
                        }
                        let _e376 = phi_591_;
                        if _e369 {
                            phi_597_ = _e336[2];
                        } else {
                            phi_597_ = _e376;
                        }
                        let _e379 = phi_597_;
                        let _e381 = ((_e379 * _e315) * _e321);
                        let _e385 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e385 {
                            let _e389 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) * 0.00000011920929f);
                            phi_620_ = select(0.00000000000011368684f, _e389, (_e389 > 0.00000000000011368684f));
                        } else {
                            phi_620_ = 0f;
                        }
                        let _e393 = phi_620_;
                        let _e394 = (_e372 + _e393);
                        let _e395 = (_e372 - _e393);
                        let _e396 = select(_e381, 0f, _e385);
                        if _e385 {
                            phi_631_ = 38685626000000000000000000f;
                        } else {
                            phi_631_ = (1f / _e381);
                        }
                        let _e399 = phi_631_;
                        let _e400 = (_e304 == 0u);
                        if _e400 {
                            phi_640_ = _e326[0];
                        } else {
                            phi_640_ = _e326[1];
                        }
                        let _e404 = phi_640_;
                        let _e405 = (_e304 == 2u);
                        if _e405 {
                            phi_646_ = _e326[2];
                        } else {
                            phi_646_ = _e404;
                        }
                        let _e408 = phi_646_;
                        if _e400 {
                            phi_657_ = _e336[0];
                        } else {
                            phi_657_ = _e336[1];
                        }
                        let _e412 = phi_657_;
                        if _e405 {
                            phi_663_ = _e336[2];
                        } else {
                            phi_663_ = _e412;
                        }
                        let _e415 = phi_663_;
                        let _e417 = ((_e415 * _e315) * _e321);
                        let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e421 {
                            let _e425 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) * 0.00000011920929f);
                            phi_686_ = select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f));
                        } else {
                            phi_686_ = 0f;
                        }
                        let _e429 = phi_686_;
                        let _e430 = (_e408 + _e429);
                        let _e431 = (_e408 - _e429);
                        let _e432 = select(_e417, 0f, _e421);
                        if _e421 {
                            phi_697_ = 38685626000000000000000000f;
                        } else {
                            phi_697_ = (1f / _e417);
                        }
                        let _e435 = phi_697_;
                        let _e438 = bitcast<f32>((bitcast<u32>(_e335) & 2147483647u));
                        let _e441 = bitcast<f32>((bitcast<u32>(_e372) & 2147483647u));
                        let _e443 = select(_e441, _e438, (_e438 > _e441));
                        let _e446 = bitcast<f32>((bitcast<u32>(_e408) & 2147483647u));
                        if (_e265 && (select(_e446, _e443, (_e443 > _e446)) <= 1099511600000f)) {
                            let _e451 = (_e284 / 3i);
                            let _e458 = bitcast<f32>((bitcast<u32>((_e451 + 127i)) << bitcast<u32>(23i)));
                            let _e465 = bitcast<f32>((bitcast<u32>(((_e284 - (2i * _e451)) + 127i)) << bitcast<u32>(23i)));
                            let _e466 = (((_e100 * _e458) * _e458) * _e465);
                            let _e468 = select(340282350000000000000000000000000000000f, _e466, (_e466 < 340282350000000000000000000000000000000f));
                            let _e473 = (((_e105 * _e458) * _e458) * _e465);
                            let _e475 = select(340282350000000000000000000000000000000f, _e473, (_e473 < 340282350000000000000000000000000000000f));
                            phi_797_ = select(-340282350000000000000000000000000000000f, _e475, (_e475 > -340282350000000000000000000000000000000f));
                            phi_798_ = select(-340282350000000000000000000000000000000f, _e468, (_e468 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_797_ = 0f;
                            phi_798_ = 1f;
                        }
                        let _e479 = phi_797_;
                        let _e481 = phi_798_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2732_ = false;
                        phi_1072_ = type_54(_e479, false);
                        phi_1075_ = select(0u, 2147483648u, (_e75 == 0u));
                        phi_1077_ = ((3u * _e75) + 1u);
                        phi_1079_ = (_e481 <= _e479);
                        phi_1081_ = 0u;
                        loop {
                            let _e489 = phi_2732_;
                            let _e491 = phi_1072_;
                            let _e493 = phi_1075_;
                            let _e495 = phi_1077_;
                            let _e497 = phi_1079_;
                            let _e499 = phi_1081_;
                            local_3 = _e491;
                            if _e497 {
                                phi_1092_ = true;
                            } else {
                                phi_1092_ = (_e499 > 0u);
                            }
                            let _e502 = phi_1092_;
                            if _e502 {
                                let _e503 = (_e495 > 0u);
                                if _e503 {
                                    if _e497 {
                                        phi_1123_ = _e493;
                                        phi_1124_ = _e497;
                                        phi_1125_ = _e499;
                                    } else {
                                        let _e504 = (_e499 - 1u);
                                        let _e505 = (_e504 % 128u);
                                        let _e506 = (_e505 < 128u);
                                        if _e506 {
                                        } else {
                                            phi_2863_ = true;
                                            break;
                                        }
                                        let _e508 = local_1[_e505];
                                        if _e506 {
                                        } else {
                                            phi_2863_ = true;
                                            break;
                                        }
                                        let _e510 = local[_e505];
                                        phi_1123_ = _e508;
                                        phi_1124_ = (_e510 <= _e491.member);
                                        phi_1125_ = _e504;
                                    }
                                    let _e514 = phi_1123_;
                                    let _e516 = phi_1124_;
                                    let _e518 = phi_1125_;
                                    if _e516 {
                                        if ((_e514 & 2147483648u) != 0u) {
                                            phi_1140_ = _e491;
                                            phi_1143_ = type_8(0u, ((_e514 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e716 = phi_1140_;
                                                let _e718 = phi_1143_;
                                                local_2 = _e716;
                                                local_4 = _e716;
                                                if (_e718.member < _e718.member_1) {
                                                    phi_1144_ = type_8((_e718.member + 1u), _e718.member_1);
                                                    phi_1166_ = type_8(1u, _e718.member);
                                                } else {
                                                    phi_1144_ = _e718;
                                                    phi_1166_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e731 = phi_1144_;
                                                let _e733 = phi_1166_;
                                                let _e737 = (bitcast<i32>(_e733.member) != 0i);
                                                if _e737 {
                                                    let _e738 = ((_e514 & 268435455u) + _e733.member_1);
                                                    let _e739 = (_e738 < _e77);
                                                    if _e739 {
                                                        if _e739 {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e743 = global_4.member[_e738].member_1;
                                                        phi_1187_ = _e743;
                                                    } else {
                                                        phi_1187_ = 4294967295u;
                                                    }
                                                    let _e745 = phi_1187_;
                                                    if (_e738 >= _e77) {
                                                        phi_1276_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e739 {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e747 = (_e303 % 3u);
                                                        let _e748 = (_e302 % 3u);
                                                        let _e749 = (_e304 % 3u);
                                                        if (_e747 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e755 = global_4.member[_e738].member[_e747];
                                                        if (_e748 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e761 = global_4.member[_e738].member[_e748];
                                                        if (_e749 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e767 = global_4.member[_e738].member[_e749];
                                                        let _e769 = (3u + _e747);
                                                        if (_e769 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e775 = global_4.member[_e738].member[_e769];
                                                        let _e776 = (3u + _e748);
                                                        if (_e776 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e782 = global_4.member[_e738].member[_e776];
                                                        let _e783 = (3u + _e749);
                                                        if (_e783 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e789 = global_4.member[_e738].member[_e783];
                                                        let _e791 = (6u + _e747);
                                                        if (_e791 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e797 = global_4.member[_e738].member[_e791];
                                                        let _e798 = (6u + _e748);
                                                        if (_e798 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e804 = global_4.member[_e738].member[_e798];
                                                        let _e805 = (6u + _e749);
                                                        if (_e805 < 9u) {
                                                        } else {
                                                            phi_2726_ = true;
                                                            break;
                                                        }
                                                        let _e811 = global_4.member[_e738].member[_e805];
                                                        phi_1276_ = array<array<f32, 3>, 3>(array<f32, 3>(_e755, _e761, _e767), array<f32, 3>(_e775, _e782, _e789), array<f32, 3>(_e797, _e804, _e811));
                                                    }
                                                    let _e815 = phi_1276_;
                                                    let _e823 = (_e815[0][2] - _e408);
                                                    let _e826 = (((_e815[0][0] - _e335) * _e432) - (_e823 * _e360));
                                                    let _e829 = (((_e815[0][1] - _e372) * _e432) - (_e823 * _e396));
                                                    let _e836 = (_e815[1][2] - _e408);
                                                    let _e839 = (((_e815[1][0] - _e335) * _e432) - (_e836 * _e360));
                                                    let _e842 = (((_e815[1][1] - _e372) * _e432) - (_e836 * _e396));
                                                    let _e849 = (_e815[2][2] - _e408);
                                                    let _e852 = (((_e815[2][0] - _e335) * _e432) - (_e849 * _e360));
                                                    let _e855 = (((_e815[2][1] - _e372) * _e432) - (_e849 * _e396));
                                                    let _e856 = (_e852 * _e842);
                                                    let _e857 = (_e855 * _e839);
                                                    let _e858 = (_e826 * _e855);
                                                    let _e859 = (_e829 * _e852);
                                                    let _e860 = (_e839 * _e829);
                                                    let _e861 = (_e842 * _e826);
                                                    let _e866 = (((_e856 >= _e857) && (_e858 >= _e859)) && (_e860 >= _e861));
                                                    if (_e866 || (((_e856 <= _e857) && (_e858 <= _e859)) && (_e860 <= _e861))) {
                                                        let _e873 = select(-1f, 1f, _e866);
                                                        let _e875 = ((_e856 - _e857) * _e873);
                                                        let _e877 = select(0f, _e875, (_e875 > 0f));
                                                        let _e879 = ((_e858 - _e859) * _e873);
                                                        let _e881 = select(0f, _e879, (_e879 > 0f));
                                                        let _e883 = ((_e860 - _e861) * _e873);
                                                        let _e885 = select(0f, _e883, (_e883 > 0f));
                                                        let _e887 = ((_e877 + _e881) + _e885);
                                                        if (_e887 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1842_ = type_28();
                                                            phi_1843_ = true;
                                                        } else {
                                                            let _e890 = select(_e815[1][0], _e815[0][0], (_e815[0][0] < _e815[1][0]));
                                                            let _e894 = select(_e815[1][0], _e815[0][0], (_e815[0][0] > _e815[1][0]));
                                                            let _e898 = select(_e815[1][1], _e815[0][1], (_e815[0][1] < _e815[1][1]));
                                                            let _e902 = select(_e815[1][1], _e815[0][1], (_e815[0][1] > _e815[1][1]));
                                                            let _e906 = select(_e815[1][2], _e815[0][2], (_e815[0][2] < _e815[1][2]));
                                                            let _e910 = select(_e815[1][2], _e815[0][2], (_e815[0][2] > _e815[1][2]));
                                                            let _e915 = ((select(_e815[2][0], _e890, (_e890 < _e815[2][0])) - _e358) * _e363);
                                                            let _e916 = ((select(_e815[2][0], _e894, (_e894 > _e815[2][0])) - _e359) * _e363);
                                                            let _e919 = ((select(_e815[2][1], _e898, (_e898 < _e815[2][1])) - _e394) * _e399);
                                                            let _e920 = ((select(_e815[2][1], _e902, (_e902 > _e815[2][1])) - _e395) * _e399);
                                                            let _e923 = ((select(_e815[2][2], _e906, (_e906 < _e815[2][2])) - _e430) * _e435);
                                                            let _e924 = ((select(_e815[2][2], _e910, (_e910 > _e815[2][2])) - _e431) * _e435);
                                                            let _e926 = select(_e924, _e923, (_e923 < _e924));
                                                            let _e928 = select(_e924, _e923, (_e923 > _e924));
                                                            let _e930 = select(_e916, _e915, (_e915 < _e916));
                                                            let _e932 = select(_e920, _e919, (_e919 < _e920));
                                                            let _e934 = select(_e932, _e930, (_e930 > _e932));
                                                            let _e936 = select(_e926, _e934, (_e934 > _e926));
                                                            let _e938 = select(_e916, _e915, (_e915 > _e916));
                                                            let _e940 = select(_e920, _e919, (_e919 > _e920));
                                                            let _e942 = select(_e940, _e938, (_e938 < _e940));
                                                            let _e944 = select(_e928, _e942, (_e942 < _e928));
                                                            let _e945 = -(_e926);
                                                            let _e951 = select(_e481, _e936, (_e936 > _e481));
                                                            if (_e951 > (_e944 + (select(_e945, _e928, (_e928 > _e945)) * 0.0000019073523f))) {
                                                                phi_1837_ = type_28();
                                                                phi_1838_ = true;
                                                            } else {
                                                                let _e953 = (_e951 > _e716.member);
                                                                if _e953 {
                                                                    phi_1836_ = type_28();
                                                                } else {
                                                                    let _e957 = (_e815[1][0] - _e815[0][0]);
                                                                    let _e958 = (_e815[1][1] - _e815[0][1]);
                                                                    let _e959 = (_e815[1][2] - _e815[0][2]);
                                                                    let _e960 = vec3<f32>(_e957, _e958, _e959);
                                                                    let _e961 = (_e815[2][0] - _e815[1][0]);
                                                                    let _e962 = (_e815[2][1] - _e815[1][1]);
                                                                    let _e963 = (_e815[2][2] - _e815[1][2]);
                                                                    let _e964 = vec3<f32>(_e961, _e962, _e963);
                                                                    let _e965 = (_e815[0][0] - _e815[2][0]);
                                                                    let _e966 = (_e815[0][1] - _e815[2][1]);
                                                                    let _e967 = (_e815[0][2] - _e815[2][2]);
                                                                    let _e968 = vec3<f32>(_e965, _e966, _e967);
                                                                    let _e971 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                    let _e974 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                    let _e976 = select(_e974, _e971, (_e971 > _e974));
                                                                    let _e979 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                    let _e981 = select(_e979, _e976, (_e976 > _e979));
                                                                    let _e984 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                    let _e987 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                    let _e989 = select(_e987, _e984, (_e984 > _e987));
                                                                    let _e992 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                    let _e994 = select(_e992, _e989, (_e989 > _e992));
                                                                    let _e997 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                    let _e1000 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                    let _e1002 = select(_e1000, _e997, (_e997 > _e1000));
                                                                    let _e1005 = bitcast<f32>((bitcast<u32>(_e967) & 2147483647u));
                                                                    let _e1007 = select(_e1005, _e1002, (_e1002 > _e1005));
                                                                    let _e1009 = select(_e994, _e981, (_e981 > _e994));
                                                                    let _e1011 = select(_e1007, _e1009, (_e1009 > _e1007));
                                                                    if (_e981 == _e1011) {
                                                                        phi_1747_ = _e964;
                                                                        phi_1748_ = _e968;
                                                                    } else {
                                                                        let _e1014 = vec3((_e994 == _e1011));
                                                                        phi_1747_ = select(_e960, _e968, _e1014);
                                                                        phi_1748_ = select(_e964, _e960, _e1014);
                                                                    }
                                                                    let _e1018 = phi_1747_;
                                                                    let _e1020 = phi_1748_;
                                                                    let _e1027 = ((_e1018.y * _e1020.z) - (_e1020.y * _e1018.z));
                                                                    let _e1032 = ((_e1018.z * _e1020.x) - (_e1020.z * _e1018.x));
                                                                    let _e1035 = ((_e1018.x * _e1020.y) - (_e1020.x * _e1018.y));
                                                                    if (_e877 >= _e881) {
                                                                        phi_1779_ = select(true, false, (_e877 >= _e885));
                                                                    } else {
                                                                        phi_1779_ = true;
                                                                    }
                                                                    let _e1040 = phi_1779_;
                                                                    if _e1040 {
                                                                        phi_1788_ = select(vec3<f32>(_e815[2][0], _e815[2][1], _e815[2][2]), vec3<f32>(_e815[1][0], _e815[1][1], _e815[1][2]), vec3((_e881 >= _e885)));
                                                                    } else {
                                                                        phi_1788_ = vec3<f32>(_e815[0][0], _e815[0][1], _e815[0][2]);
                                                                    }
                                                                    let _e1045 = phi_1788_;
                                                                    let _e1062 = ((((_e1027 * (_e1045.x - _e335)) + (_e1032 * (_e1045.y - _e372))) + (_e1035 * (_e1045.z - _e408))) / (((_e1027 * _e360) + (_e1032 * _e396)) + (_e1035 * _e432)));
                                                                    let _e1064 = select(_e944, _e1062, (_e1062 < _e944));
                                                                    let _e1066 = select(_e936, _e1064, (_e1064 > _e936));
                                                                    if (_e1066 >= _e481) {
                                                                        let _e1068 = (_e1066 <= _e716.member);
                                                                        if _e1068 {
                                                                            let _e1069 = (1f / _e887);
                                                                            phi_1828_ = type_28(_e1066, (_e881 * _e1069), (_e885 * _e1069), _e745);
                                                                        } else {
                                                                            phi_1828_ = type_28();
                                                                        }
                                                                        let _e1074 = phi_1828_;
                                                                        phi_1830_ = _e1074;
                                                                        phi_1831_ = select(true, false, _e1068);
                                                                    } else {
                                                                        phi_1830_ = type_28();
                                                                        phi_1831_ = true;
                                                                    }
                                                                    let _e1077 = phi_1830_;
                                                                    let _e1079 = phi_1831_;
                                                                    if _e1079 {
                                                                        phi_1835_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1835_ = _e1077;
                                                                    }
                                                                    let _e1081 = phi_1835_;
                                                                    phi_1836_ = _e1081;
                                                                }
                                                                let _e1083 = phi_1836_;
                                                                phi_1837_ = _e1083;
                                                                phi_1838_ = _e953;
                                                            }
                                                            let _e1085 = phi_1837_;
                                                            let _e1087 = phi_1838_;
                                                            phi_1842_ = _e1085;
                                                            phi_1843_ = _e1087;
                                                        }
                                                        let _e1089 = phi_1842_;
                                                        let _e1091 = phi_1843_;
                                                        phi_1847_ = _e1089;
                                                        phi_1848_ = _e1091;
                                                    } else {
                                                        phi_1847_ = type_28();
                                                        phi_1848_ = true;
                                                    }
                                                    let _e1093 = phi_1847_;
                                                    let _e1095 = phi_1848_;
                                                    if _e1095 {
                                                        phi_1852_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1852_ = _e1093;
                                                    }
                                                    let _e1097 = phi_1852_;
                                                    if (_e1097.member_3 != 4294967295u) {
                                                        if (_e745 == _e192) {
                                                            phi_2181_ = false;
                                                        } else {
                                                            let _e1101 = (_e745 < arrayLength((&global_5.member)));
                                                            if _e1101 {
                                                                if _e1101 {
                                                                } else {
                                                                    phi_2726_ = true;
                                                                    break;
                                                                }
                                                                let _e1103 = global_5.member[_e745];
                                                                phi_1875_ = _e1103;
                                                            } else {
                                                                phi_1875_ = 4294967295u;
                                                            }
                                                            let _e1105 = phi_1875_;
                                                            let _e1106 = (_e1105 < arrayLength((&global_6.member)));
                                                            if _e1106 {
                                                                if _e1106 {
                                                                } else {
                                                                    phi_2726_ = true;
                                                                    break;
                                                                }
                                                                let _e1108 = global_6.member[_e1105];
                                                                phi_1889_ = _e1108;
                                                            } else {
                                                                phi_1889_ = 0i;
                                                            }
                                                            let _e1110 = phi_1889_;
                                                            let _e1111 = (_e1110 == 0i);
                                                            if _e1111 {
                                                                phi_2180_ = true;
                                                            } else {
                                                                if _e327 {
                                                                    phi_1910_ = vec3<f32>(_e815[0][0], _e815[0][1], _e815[0][2]);
                                                                } else {
                                                                    if (_e303 == 1u) {
                                                                        phi_1909_ = vec3<f32>(_e815[0][2], _e815[0][0], _e815[0][1]);
                                                                    } else {
                                                                        phi_1909_ = vec3<f32>(_e815[0][1], _e815[0][2], _e815[0][0]);
                                                                    }
                                                                    let _e1116 = phi_1909_;
                                                                    phi_1910_ = _e1116;
                                                                }
                                                                let _e1119 = phi_1910_;
                                                                if _e327 {
                                                                    phi_1927_ = vec3<f32>(_e815[1][0], _e815[1][1], _e815[1][2]);
                                                                } else {
                                                                    if (_e303 == 1u) {
                                                                        phi_1926_ = vec3<f32>(_e815[1][2], _e815[1][0], _e815[1][1]);
                                                                    } else {
                                                                        phi_1926_ = vec3<f32>(_e815[1][1], _e815[1][2], _e815[1][0]);
                                                                    }
                                                                    let _e1124 = phi_1926_;
                                                                    phi_1927_ = _e1124;
                                                                }
                                                                let _e1127 = phi_1927_;
                                                                if _e327 {
                                                                    phi_1944_ = vec3<f32>(_e815[2][0], _e815[2][1], _e815[2][2]);
                                                                } else {
                                                                    if (_e303 == 1u) {
                                                                        phi_1943_ = vec3<f32>(_e815[2][2], _e815[2][0], _e815[2][1]);
                                                                    } else {
                                                                        phi_1943_ = vec3<f32>(_e815[2][1], _e815[2][2], _e815[2][0]);
                                                                    }
                                                                    let _e1132 = phi_1943_;
                                                                    phi_1944_ = _e1132;
                                                                }
                                                                let _e1135 = phi_1944_;
                                                                let _e1138 = (_e1127.x - _e1119.x);
                                                                let _e1141 = (_e1127.y - _e1119.y);
                                                                let _e1144 = (_e1127.z - _e1119.z);
                                                                let _e1146 = (_e1135.x - _e1119.x);
                                                                let _e1148 = (_e1135.y - _e1119.y);
                                                                let _e1150 = (_e1135.z - _e1119.z);
                                                                if (_e188.member_1 == 1u) {
                                                                    phi_1980_ = (vec3<f32>(_e188.member[0], _e188.member[1], _e188.member[2]) - _e1119);
                                                                } else {
                                                                    phi_1980_ = vec3<f32>(_e188.member[0], _e188.member[1], _e188.member[2]);
                                                                }
                                                                let _e1165 = phi_1980_;
                                                                let _e1171 = bitcast<f32>((bitcast<u32>((_e1138 * _e1148)) ^ _e188.member_3[0]));
                                                                let _e1175 = bitcast<f32>((bitcast<u32>((_e1141 * _e1146)) ^ _e188.member_3[0]));
                                                                let _e1179 = bitcast<f32>((bitcast<u32>((_e1141 * _e1150)) ^ _e188.member_3[0]));
                                                                let _e1183 = bitcast<f32>((bitcast<u32>((_e1144 * _e1148)) ^ _e188.member_3[0]));
                                                                let _e1187 = bitcast<f32>((bitcast<u32>((_e1144 * _e1146)) ^ _e188.member_3[0]));
                                                                let _e1191 = bitcast<f32>((bitcast<u32>((_e1138 * _e1150)) ^ _e188.member_3[0]));
                                                                let _e1192 = (_e1179 - _e1183);
                                                                let _e1193 = (_e1187 - _e1191);
                                                                let _e1194 = (_e1171 - _e1175);
                                                                let _e1218 = (bitcast<f32>((bitcast<u32>(_e1179) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u)));
                                                                let _e1225 = (bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u)));
                                                                let _e1232 = (bitcast<f32>((bitcast<u32>(_e1171) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1175) & 2147483647u)));
                                                                if (_e188.member_2 == 0f) {
                                                                    phi_2162_ = 0f;
                                                                } else {
                                                                    let _e1262 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                    let _e1265 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
                                                                    let _e1268 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                    let _e1270 = select(_e1268, _e1265, (_e1265 > _e1268));
                                                                    let _e1274 = select(_e1268, _e1265, (_e1265 < _e1268));
                                                                    let _e1278 = select(_e1265, _e1262, (_e1262 < _e1265));
                                                                    let _e1280 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                    let _e1282 = select(_e1268, _e1280, (_e1280 < _e1268));
                                                                    phi_2162_ = bitcast<f32>((bitcast<u32>((_e188.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1270, _e1262, (_e1262 > _e1270)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1282, _e1278, (_e1278 > _e1282)))) ^ _e188.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1274, _e1262, (_e1262 < _e1274)))) ^ _e188.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1218 + _e1225) + _e1232))) ^ _e188.member_3[0]))) * 1.0000005f)) ^ _e188.member_3[0])))) ^ _e188.member_3[0]));
                                                                }
                                                                let _e1309 = phi_2162_;
                                                                phi_2180_ = (_e1111 || !(((((bitcast<f32>((bitcast<u32>((_e1165.x * _e1192)) ^ _e188.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1165.y * _e1193)) ^ _e188.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1165.z * _e1194)) ^ _e188.member_3[0]))) * f32(-(_e1110))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1165.x) & 2147483647u)) * _e1218)) ^ _e188.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1165.y) & 2147483647u)) * _e1225)) ^ _e188.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1165.z) & 2147483647u)) * _e1232)) ^ _e188.member_3[0]))))) ^ _e188.member_3[0])) + _e1309) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1323 = phi_2180_;
                                                            phi_2181_ = _e1323;
                                                        }
                                                        let _e1325 = phi_2181_;
                                                        if _e1325 {
                                                            phi_2186_ = type_54(_e716.member, true);
                                                        } else {
                                                            phi_2186_ = _e716;
                                                        }
                                                        let _e1330 = phi_2186_;
                                                        phi_2187_ = _e1330;
                                                    } else {
                                                        phi_2187_ = _e716;
                                                    }
                                                    let _e1332 = phi_2187_;
                                                    phi_1141_ = _e1332;
                                                } else {
                                                    phi_1141_ = type_54();
                                                }
                                                let _e1334 = phi_1141_;
                                                continue;
                                                continuing {
                                                    phi_1140_ = _e1334;
                                                    phi_1143_ = _e731;
                                                    phi_2726_ = _e489;
                                                    break if !(_e737);
                                                }
                                            }
                                            let _e1337 = phi_2726_;
                                            phi_2863_ = _e1337;
                                            if _e1337 {
                                                break;
                                            }
                                            let _e1339 = local_2;
                                            phi_2867_ = _e1337;
                                            let _e1518 = local_4;
                                            phi_2642_ = _e1518;
                                            phi_2643_ = _e514;
                                            phi_2644_ = false;
                                            phi_2645_ = select(_e518, 0u, _e1339.member_1);
                                        } else {
                                            if (_e514 >= _e75) {
                                                phi_2248_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e514 < _e75) {
                                                } else {
                                                    phi_2863_ = true;
                                                    break;
                                                }
                                                let _e528 = (_e303 % 3u);
                                                if (_e528 < 3u) {
                                                } else {
                                                    phi_2863_ = true;
                                                    break;
                                                }
                                                let _e534 = global_3.member[_e514].member[_e528];
                                                let _e540 = (_e302 % 3u);
                                                if (_e540 < 3u) {
                                                } else {
                                                    phi_2863_ = true;
                                                    break;
                                                }
                                                let _e546 = global_3.member[_e514].member[_e540];
                                                let _e552 = (_e304 % 3u);
                                                if (_e552 < 3u) {
                                                } else {
                                                    phi_2863_ = true;
                                                    break;
                                                }
                                                let _e558 = global_3.member[_e514].member[_e552];
                                                let _e568 = global_3.member[_e514].member_1;
                                                let _e572 = global_3.member[_e514].member_2;
                                                phi_2248_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e534[0], _e534[1], _e534[2], _e534[3]), vec4<f32>(_e546[0], _e546[1], _e546[2], _e546[3]), vec4<f32>(_e558[0], _e558[1], _e558[2], _e558[3])), _e568, _e572);
                                            }
                                            let _e575 = phi_2248_;
                                            let _e587 = ((_e575.member[0].x - _e358) * _e363);
                                            let _e588 = ((_e575.member[0].y - _e358) * _e363);
                                            let _e589 = ((_e575.member[0].z - _e359) * _e363);
                                            let _e590 = ((_e575.member[0].w - _e359) * _e363);
                                            let _e600 = ((_e575.member[1].x - _e394) * _e399);
                                            let _e601 = ((_e575.member[1].y - _e394) * _e399);
                                            let _e602 = ((_e575.member[1].z - _e395) * _e399);
                                            let _e603 = ((_e575.member[1].w - _e395) * _e399);
                                            let _e613 = ((_e575.member[2].x - _e430) * _e435);
                                            let _e614 = ((_e575.member[2].y - _e430) * _e435);
                                            let _e615 = ((_e575.member[2].z - _e431) * _e435);
                                            let _e616 = ((_e575.member[2].w - _e431) * _e435);
                                            let _e618 = select(_e615, _e613, (_e613 < _e615));
                                            let _e620 = select(_e616, _e614, (_e614 < _e616));
                                            let _e622 = select(_e615, _e613, (_e613 > _e615));
                                            let _e624 = select(_e616, _e614, (_e614 > _e616));
                                            let _e626 = select(_e589, _e587, (_e587 < _e589));
                                            let _e628 = select(_e590, _e588, (_e588 < _e590));
                                            let _e630 = select(_e602, _e600, (_e600 < _e602));
                                            let _e632 = select(_e603, _e601, (_e601 < _e603));
                                            let _e634 = select(_e630, _e626, (_e626 > _e630));
                                            let _e636 = select(_e632, _e628, (_e628 > _e632));
                                            let _e638 = select(_e618, _e634, (_e634 > _e618));
                                            let _e640 = select(_e620, _e636, (_e636 > _e620));
                                            let _e642 = select(_e589, _e587, (_e587 > _e589));
                                            let _e644 = select(_e590, _e588, (_e588 > _e590));
                                            let _e646 = select(_e602, _e600, (_e600 > _e602));
                                            let _e648 = select(_e603, _e601, (_e601 > _e603));
                                            let _e650 = select(_e646, _e642, (_e642 < _e646));
                                            let _e652 = select(_e648, _e644, (_e644 < _e648));
                                            let _e657 = -(_e618);
                                            let _e658 = -(_e620);
                                            let _e665 = (select(_e622, _e650, (_e650 < _e622)) + (select(_e657, _e622, (_e622 > _e657)) * 0.0000019073523f));
                                            let _e666 = (select(_e624, _e652, (_e652 < _e624)) + (select(_e658, _e624, (_e624 > _e658)) * 0.0000019073523f));
                                            let _e668 = select(_e481, _e638, (_e638 > _e481));
                                            let _e670 = select(_e481, _e640, (_e640 > _e481));
                                            let _e675 = (_e668 <= select(_e491.member, _e665, (_e665 < _e491.member)));
                                            let _e676 = (_e670 <= select(_e491.member, _e666, (_e666 < _e491.member)));
                                            let _e677 = (_e668 <= _e670);
                                            if _e675 {
                                                if _e676 {
                                                    if _e677 {
                                                        phi_2592_ = _e575.member_2;
                                                    } else {
                                                        phi_2592_ = _e575.member_1;
                                                    }
                                                    let _e681 = phi_2592_;
                                                    let _e682 = (_e518 % 128u);
                                                    let _e683 = (_e682 < 128u);
                                                    if _e683 {
                                                    } else {
                                                        phi_2863_ = true;
                                                        break;
                                                    }
                                                    local_1[_e682] = _e681;
                                                    if _e683 {
                                                    } else {
                                                        phi_2863_ = true;
                                                        break;
                                                    }
                                                    local[_e682] = select(_e670, _e668, (_e668 > _e670));
                                                    if _e677 {
                                                        phi_2619_ = _e575.member_1;
                                                    } else {
                                                        phi_2619_ = _e575.member_2;
                                                    }
                                                    let _e692 = phi_2619_;
                                                    phi_2620_ = _e692;
                                                    phi_2621_ = (_e518 + 1u);
                                                } else {
                                                    phi_2620_ = u32();
                                                    phi_2621_ = u32();
                                                }
                                                let _e694 = phi_2620_;
                                                let _e696 = phi_2621_;
                                                phi_2623_ = _e694;
                                                phi_2624_ = _e696;
                                                phi_2625_ = select(true, false, _e676);
                                            } else {
                                                phi_2623_ = u32();
                                                phi_2624_ = u32();
                                                phi_2625_ = true;
                                            }
                                            let _e699 = phi_2623_;
                                            let _e701 = phi_2624_;
                                            let _e703 = phi_2625_;
                                            if _e703 {
                                                if _e675 {
                                                    phi_2634_ = _e575.member_1;
                                                } else {
                                                    phi_2634_ = _e575.member_2;
                                                }
                                                let _e707 = phi_2634_;
                                                phi_2639_ = _e707;
                                                phi_2640_ = select(_e676, true, _e675);
                                            } else {
                                                phi_2639_ = _e699;
                                                phi_2640_ = _e516;
                                            }
                                            let _e710 = phi_2639_;
                                            let _e712 = phi_2640_;
                                            phi_2867_ = _e489;
                                            phi_2642_ = _e491;
                                            phi_2643_ = _e710;
                                            phi_2644_ = _e712;
                                            phi_2645_ = select(_e701, _e518, _e703);
                                        }
                                        let _e1343 = phi_2867_;
                                        let _e1345 = phi_2642_;
                                        let _e1347 = phi_2643_;
                                        let _e1349 = phi_2644_;
                                        let _e1351 = phi_2645_;
                                        phi_2866_ = _e1343;
                                        phi_2646_ = _e1345;
                                        phi_2647_ = _e1347;
                                        phi_2648_ = (_e495 - 1u);
                                        phi_2649_ = _e1349;
                                        phi_2650_ = _e1351;
                                    } else {
                                        phi_2866_ = _e489;
                                        phi_2646_ = _e491;
                                        phi_2647_ = _e514;
                                        phi_2648_ = _e495;
                                        phi_2649_ = _e516;
                                        phi_2650_ = _e518;
                                    }
                                    let _e1353 = phi_2866_;
                                    let _e1355 = phi_2646_;
                                    let _e1357 = phi_2647_;
                                    let _e1359 = phi_2648_;
                                    let _e1361 = phi_2649_;
                                    let _e1363 = phi_2650_;
                                    phi_2865_ = _e1353;
                                    phi_2651_ = _e1355;
                                    phi_2652_ = _e1357;
                                    phi_2653_ = _e1359;
                                    phi_2654_ = _e1361;
                                    phi_2655_ = _e1363;
                                } else {
                                    phi_2865_ = _e489;
                                    phi_2651_ = type_54();
                                    phi_2652_ = u32();
                                    phi_2653_ = u32();
                                    phi_2654_ = bool();
                                    phi_2655_ = u32();
                                }
                                let _e1365 = phi_2865_;
                                let _e1367 = phi_2651_;
                                let _e1369 = phi_2652_;
                                let _e1371 = phi_2653_;
                                let _e1373 = phi_2654_;
                                let _e1375 = phi_2655_;
                                phi_2864_ = _e1365;
                                phi_1073_ = _e1367;
                                phi_1076_ = _e1369;
                                phi_1078_ = _e1371;
                                phi_1080_ = _e1373;
                                phi_1082_ = _e1375;
                                phi_2656_ = _e503;
                            } else {
                                phi_2864_ = _e489;
                                phi_1073_ = type_54();
                                phi_1076_ = u32();
                                phi_1078_ = u32();
                                phi_1080_ = bool();
                                phi_1082_ = u32();
                                phi_2656_ = false;
                            }
                            let _e1377 = phi_2864_;
                            let _e1379 = phi_1073_;
                            let _e1381 = phi_1076_;
                            let _e1383 = phi_1078_;
                            let _e1385 = phi_1080_;
                            let _e1387 = phi_1082_;
                            let _e1389 = phi_2656_;
                            continue;
                            continuing {
                                phi_2732_ = _e1377;
                                phi_1072_ = _e1379;
                                phi_1075_ = _e1381;
                                phi_1077_ = _e1383;
                                phi_1079_ = _e1385;
                                phi_1081_ = _e1387;
                                phi_2863_ = _e1377;
                                break if !(_e1389);
                            }
                        }
                        let _e1392 = phi_2863_;
                        if _e1392 {
                            break;
                        }
                        let _e1394 = local_3;
                        if _e1394.member_1 {
                        } else {
                            if _e95 {
                            } else {
                                break;
                            }
                            let _e1398 = global_9.member[_e93];
                            if _e94 {
                            } else {
                                break;
                            }
                            let _e1402 = global_8.member[_e93].member_1;
                            if _e95 {
                            } else {
                                break;
                            }
                            global_9.member[_e93] = type_30(_e1398.member, _e1398.member_1, _e1398.member_2, array<f32, 3>((_e1398.member_3[0] + (_e1402[0] * _e1398.member_1[0])), (_e1398.member_3[1] + (_e1402[1] * _e1398.member_1[1])), (_e1398.member_3[2] + (_e1402[2] * _e1398.member_1[2]))), _e1398.member_4);
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
