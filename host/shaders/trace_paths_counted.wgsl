struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
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
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_43 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_49 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

struct type_53 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_53;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_402_: i32;
    var phi_403_: i32;
    var phi_413_: bool;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_426_: bool;
    var phi_431_: u32;
    var phi_464_: i32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_528_: f32;
    var phi_534_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_732_: f32;
    var phi_738_: f32;
    var phi_778_: f32;
    var phi_784_: f32;
    var phi_903_: i32;
    var phi_925_: u32;
    var phi_926_: u32;
    var phi_963_: i32;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_994_: f32;
    var phi_995_: f32;
    var phi_2960_: bool;
    var phi_1019_: type_49;
    var phi_1022_: bool;
    var phi_1024_: u32;
    var phi_1026_: u32;
    var phi_1028_: u32;
    var phi_1039_: bool;
    var phi_1071_: bool;
    var phi_1072_: u32;
    var phi_1073_: u32;
    var phi_2097_: type_48;
    var phi_2462_: u32;
    var phi_2489_: u32;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2493_: u32;
    var phi_2494_: u32;
    var phi_2495_: bool;
    var phi_2504_: u32;
    var phi_2509_: bool;
    var phi_2510_: u32;
    var phi_1088_: type_49;
    var phi_1091_: type_7;
    var phi_1092_: type_7;
    var phi_1114_: type_7;
    var phi_1138_: u32;
    var phi_1230_: array<array<f32, 3>, 3>;
    var phi_1760_: f32;
    var phi_1761_: f32;
    var phi_1762_: f32;
    var phi_1763_: f32;
    var phi_1764_: vec3<f32>;
    var phi_1765_: vec3<f32>;
    var phi_1766_: vec3<f32>;
    var phi_1767_: vec3<f32>;
    var phi_1958_: f32;
    var phi_1978_: type_47;
    var phi_1979_: type_47;
    var phi_1982_: type_47;
    var phi_1983_: type_47;
    var phi_1984_: bool;
    var phi_1988_: type_47;
    var phi_1997_: type_22;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2030_: type_49;
    var phi_2031_: type_49;
    var phi_2032_: type_49;
    var phi_1089_: type_49;
    var phi_2954_: bool;
    var local_2: type_49;
    var phi_3111_: bool;
    var phi_2512_: type_49;
    var phi_2513_: bool;
    var phi_2514_: u32;
    var phi_2515_: u32;
    var phi_3110_: bool;
    var phi_2516_: type_49;
    var phi_2517_: bool;
    var phi_2518_: u32;
    var phi_2519_: u32;
    var phi_2520_: u32;
    var phi_3109_: bool;
    var phi_2521_: type_49;
    var phi_2522_: bool;
    var phi_2523_: u32;
    var phi_2524_: u32;
    var phi_2525_: u32;
    var phi_3108_: bool;
    var phi_1020_: type_49;
    var phi_1023_: bool;
    var phi_1025_: u32;
    var phi_1027_: u32;
    var phi_1029_: u32;
    var phi_2526_: bool;
    var phi_3107_: bool;
    var local_3: type_49;
    var phi_2564_: f32;
    var phi_2566_: f32;
    var phi_2567_: bool;
    var phi_2568_: f32;
    var phi_2569_: bool;
    var phi_2899_: u32;
    var phi_2917_: bool;
    var phi_2920_: bool;
    var phi_2933_: f32;
    var phi_2934_: f32;
    var phi_2939_: f32;
    var phi_2940_: f32;
    var phi_2941_: bool;
    var phi_2949_: f32;
    var phi_2584_: f32;
    var phi_2585_: f32;
    var phi_2597_: f32;
    var phi_2602_: type_22;
    var local_4: type_49;
    var local_5: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e77 = arrayLength((&global_2.member));
            let _e79 = arrayLength((&global_1.member));
            let _e87 = arrayLength((&global_6.member));
            let _e91 = (_e75.x + (_e75.y * 2097152u));
            let _e92 = (_e91 < arrayLength((&global_3.member)));
            if _e92 {
                let _e93 = (_e91 < arrayLength((&global_4.member)));
                if _e93 {
                    let _e94 = (_e91 < arrayLength((&global_5.member)));
                    if _e94 {
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e104 = global_3.member[_e91].member.member_2[0u];
                        let _e106 = (bitcast<u32>(_e104) & 2147483647u);
                        let _e112 = global_3.member[_e91].member.member_2[1u];
                        let _e114 = (bitcast<u32>(_e112) & 2147483647u);
                        let _e120 = global_3.member[_e91].member.member_2[2u];
                        let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                        let _e128 = global_3.member[_e91].member.member[0u];
                        let _e130 = (bitcast<u32>(_e128) & 2147483647u);
                        let _e136 = global_3.member[_e91].member.member[1u];
                        let _e138 = (bitcast<u32>(_e136) & 2147483647u);
                        let _e144 = global_3.member[_e91].member.member[2u];
                        let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                        let _e148 = select(_e114, _e106, (_e114 < _e106));
                        let _e150 = select(_e122, _e148, (_e122 < _e148));
                        let _e152 = select(_e130, _e150, (_e130 < _e150));
                        let _e154 = select(_e138, _e152, (_e138 < _e152));
                        let _e156 = select(_e146, _e154, (_e146 < _e154));
                        let _e161 = global_3.member[_e91].member.member_1;
                        let _e162 = bitcast<u32>(_e161);
                        let _e163 = (_e162 & 2147483647u);
                        let _e171 = global_3.member[_e91].member.member_3;
                        let _e172 = bitcast<u32>(_e171);
                        let _e173 = (_e172 & 2147483647u);
                        let _e177 = (((select(_e163, _e156, (_e163 < _e156)) < 2139095040u) && (_e173 <= 2139095040u)) && (_e150 > 0u));
                        if _e177 {
                            let _e180 = (bitcast<u32>(bitcast<f32>(_e150)) & 2147483647u);
                            if (_e180 >= 8388608u) {
                                phi_402_ = (bitcast<i32>((_e180 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_402_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                            }
                            let _e194 = phi_402_;
                            phi_403_ = _e194;
                        } else {
                            phi_403_ = 0i;
                        }
                        let _e196 = phi_403_;
                        let _e197 = (_e106 == _e150);
                        if _e197 {
                            phi_413_ = true;
                        } else {
                            phi_413_ = (_e114 == _e150);
                        }
                        let _e200 = phi_413_;
                        let _e201 = select(1u, 0u, _e197);
                        if _e200 {
                            let _e202 = (_e201 + 1u);
                            phi_423_ = _e202;
                            phi_424_ = _e202;
                            phi_426_ = select(true, false, (_e202 == 2u));
                        } else {
                            phi_423_ = u32();
                            phi_424_ = 0u;
                            phi_426_ = true;
                        }
                        let _e206 = phi_423_;
                        let _e208 = phi_424_;
                        let _e210 = phi_426_;
                        if _e210 {
                            phi_431_ = (_e208 + 1u);
                        } else {
                            phi_431_ = 0u;
                        }
                        let _e214 = phi_431_;
                        let _e215 = select(_e206, _e208, _e210);
                        let _e216 = select(_e201, select(2u, _e201, _e200), _e210);
                        let _e217 = -(_e196);
                        if (_e217 < -126i) {
                            phi_464_ = -126i;
                        } else {
                            phi_464_ = select(_e217, 127i, (_e217 > 127i));
                        }
                        let _e222 = phi_464_;
                        let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                        let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                        let _e238 = global_3.member[_e91].member.member;
                        let _e239 = (_e215 == 0u);
                        if _e239 {
                            phi_482_ = _e238[0];
                        } else {
                            phi_482_ = _e238[1];
                        }
                        let _e243 = phi_482_;
                        let _e244 = (_e215 == 2u);
                        if _e244 {
                            phi_488_ = _e238[2];
                        } else {
                            phi_488_ = _e243;
                        }
                        let _e247 = phi_488_;
                        let _e248 = bitcast<u32>(_e247);
                        let _e250 = ((_e248 & 2139095040u) != 0u);
                        let _e262 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * select(0.00000011920929f, 1f, _e250));
                        let _e263 = global_3.member[_e91].member.member_2;
                        if _e239 {
                            phi_528_ = _e263[0];
                        } else {
                            phi_528_ = _e263[1];
                        }
                        let _e267 = phi_528_;
                        if _e244 {
                            phi_534_ = _e263[2];
                        } else {
                            phi_534_ = _e267;
                        }
                        let _e270 = phi_534_;
                        let _e271 = bitcast<u32>(_e270);
                        let _e273 = ((_e271 & 2139095040u) != 0u);
                        let _e287 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e271 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e271 & 2147483648u))), _e270, _e273) * _e227) * select(0.00000011920929f, 1f, _e273)) * _e233);
                        let _e291 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e294 = bitcast<f32>((bitcast<u32>(_e262) & 2147483647u));
                        let _e295 = (_e294 * 0.00000011920929f);
                        let _e298 = select(select(0.00000000000011368684f, _e295, (_e295 > 0.00000000000011368684f)), 0f, _e291);
                        let _e299 = select(0f, _e287, _e291);
                        let _e300 = (_e262 + _e298);
                        let _e301 = (_e262 - _e298);
                        let _e303 = select(38685626000000000000000000f, (1f / _e287), _e291);
                        let _e304 = (_e214 == 0u);
                        if _e304 {
                            phi_607_ = _e238[0];
                        } else {
                            phi_607_ = _e238[1];
                        }
                        let _e308 = phi_607_;
                        let _e309 = (_e214 == 2u);
                        if _e309 {
                            phi_613_ = _e238[2];
                        } else {
                            phi_613_ = _e308;
                        }
                        let _e312 = phi_613_;
                        let _e313 = bitcast<u32>(_e312);
                        let _e315 = ((_e313 & 2139095040u) != 0u);
                        let _e327 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * select(0.00000011920929f, 1f, _e315));
                        if _e304 {
                            phi_653_ = _e263[0];
                        } else {
                            phi_653_ = _e263[1];
                        }
                        let _e331 = phi_653_;
                        if _e309 {
                            phi_659_ = _e263[2];
                        } else {
                            phi_659_ = _e331;
                        }
                        let _e334 = phi_659_;
                        let _e335 = bitcast<u32>(_e334);
                        let _e337 = ((_e335 & 2139095040u) != 0u);
                        let _e351 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e334, _e337) * _e227) * select(0.00000011920929f, 1f, _e337)) * _e233);
                        let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e358 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                        let _e359 = (_e358 * 0.00000011920929f);
                        let _e362 = select(select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f)), 0f, _e355);
                        let _e363 = select(0f, _e351, _e355);
                        let _e364 = (_e327 + _e362);
                        let _e365 = (_e327 - _e362);
                        let _e367 = select(38685626000000000000000000f, (1f / _e351), _e355);
                        let _e368 = (_e216 == 0u);
                        if _e368 {
                            phi_732_ = _e238[0];
                        } else {
                            phi_732_ = _e238[1];
                        }
                        let _e372 = phi_732_;
                        let _e373 = (_e216 == 2u);
                        if _e373 {
                            phi_738_ = _e238[2];
                        } else {
                            phi_738_ = _e372;
                        }
                        let _e376 = phi_738_;
                        let _e377 = bitcast<u32>(_e376);
                        let _e379 = ((_e377 & 2139095040u) != 0u);
                        let _e391 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * select(0.00000011920929f, 1f, _e379));
                        if _e368 {
                            phi_778_ = _e263[0];
                        } else {
                            phi_778_ = _e263[1];
                        }
                        let _e395 = phi_778_;
                        if _e373 {
                            phi_784_ = _e263[2];
                        } else {
                            phi_784_ = _e395;
                        }
                        let _e398 = phi_784_;
                        let _e399 = bitcast<u32>(_e398);
                        let _e401 = ((_e399 & 2139095040u) != 0u);
                        let _e415 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e399 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e399 & 2147483648u))), _e398, _e401) * _e227) * select(0.00000011920929f, 1f, _e401)) * _e233);
                        let _e419 = (bitcast<f32>((bitcast<u32>(_e415) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e422 = bitcast<f32>((bitcast<u32>(_e391) & 2147483647u));
                        let _e423 = (_e422 * 0.00000011920929f);
                        let _e426 = select(select(0.00000000000011368684f, _e423, (_e423 > 0.00000000000011368684f)), 0f, _e419);
                        let _e427 = select(0f, _e415, _e419);
                        let _e428 = (_e391 + _e426);
                        let _e429 = (_e391 - _e426);
                        let _e431 = select(38685626000000000000000000f, (1f / _e415), _e419);
                        let _e433 = select(_e358, _e294, (_e294 > _e358));
                        if (_e177 && (select(_e422, _e433, (_e433 > _e422)) <= 1099511600000f)) {
                            let _e445 = ((_e163 & 8388607u) | (select(0u, 1u, ((_e163 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e448 = bitcast<i32>((_e163 >> bitcast<u32>(23i)));
                            let _e452 = (_e445 == 0u);
                            let _e455 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e445)), 32u, _e452)) - 8i);
                            if (_e448 == 255i) {
                                phi_903_ = 255i;
                            } else {
                                phi_903_ = (((_e448 + select(0i, 1i, (_e448 == 0i))) - _e455) + _e196);
                            }
                            let _e463 = phi_903_;
                            let _e473 = (_e463 <= 0i);
                            if _e473 {
                                phi_926_ = u32();
                            } else {
                                if _e452 {
                                    phi_925_ = u32();
                                } else {
                                    phi_925_ = select(((bitcast<u32>(_e463) << bitcast<u32>(23i)) | ((_e445 << bitcast<u32>(((_e455 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e463 >= 255i));
                                }
                                let _e477 = phi_925_;
                                phi_926_ = _e477;
                            }
                            let _e479 = phi_926_;
                            let _e491 = ((_e173 & 8388607u) | (select(0u, 1u, ((_e173 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e494 = bitcast<i32>((_e173 >> bitcast<u32>(23i)));
                            let _e498 = (_e491 == 0u);
                            let _e501 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e491)), 32u, _e498)) - 8i);
                            if (_e494 == 255i) {
                                phi_963_ = 255i;
                            } else {
                                phi_963_ = (((_e494 + select(0i, 1i, (_e494 == 0i))) - _e501) + _e196);
                            }
                            let _e509 = phi_963_;
                            let _e519 = (_e509 <= 0i);
                            if _e519 {
                                phi_986_ = u32();
                            } else {
                                if _e498 {
                                    phi_985_ = u32();
                                } else {
                                    phi_985_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | ((_e491 << bitcast<u32>(((_e501 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e509 >= 255i));
                                }
                                let _e523 = phi_985_;
                                phi_986_ = _e523;
                            }
                            let _e525 = phi_986_;
                            phi_994_ = bitcast<f32>(((_e172 & 2147483648u) | select(_e525, 0u, select(_e498, true, _e519))));
                            phi_995_ = bitcast<f32>(((_e162 & 2147483648u) | select(_e479, 0u, select(_e452, true, _e473))));
                        } else {
                            phi_994_ = 0f;
                            phi_995_ = 1f;
                        }
                        let _e531 = phi_994_;
                        let _e533 = phi_995_;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e539 = global_3.member[_e91].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2960_ = false;
                        phi_1019_ = type_49(type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e531), 0u, 0u);
                        phi_1022_ = (_e533 <= _e531);
                        phi_1024_ = select(0u, 2147483648u, (_e77 == 0u));
                        phi_1026_ = 0u;
                        phi_1028_ = ((3u * _e77) + 1u);
                        loop {
                            let _e546 = phi_2960_;
                            let _e548 = phi_1019_;
                            let _e550 = phi_1022_;
                            let _e552 = phi_1024_;
                            let _e554 = phi_1026_;
                            let _e556 = phi_1028_;
                            local_3 = _e548;
                            local_4 = _e548;
                            if _e550 {
                                phi_1039_ = true;
                            } else {
                                phi_1039_ = (_e554 > 0u);
                            }
                            let _e559 = phi_1039_;
                            if _e559 {
                                let _e560 = (_e556 > 0u);
                                if _e560 {
                                    if _e550 {
                                        phi_1071_ = _e550;
                                        phi_1072_ = _e552;
                                        phi_1073_ = _e554;
                                    } else {
                                        let _e561 = (_e554 - 1u);
                                        let _e562 = (_e561 % 128u);
                                        let _e563 = (_e562 < 128u);
                                        if _e563 {
                                        } else {
                                            phi_3107_ = true;
                                            break;
                                        }
                                        let _e565 = local_1[_e562];
                                        if _e563 {
                                        } else {
                                            phi_3107_ = true;
                                            break;
                                        }
                                        let _e567 = local[_e562];
                                        phi_1071_ = (_e567 <= _e548.member.member_1);
                                        phi_1072_ = _e565;
                                        phi_1073_ = _e561;
                                    }
                                    let _e572 = phi_1071_;
                                    let _e574 = phi_1072_;
                                    let _e576 = phi_1073_;
                                    if _e572 {
                                        if ((_e574 & 2147483648u) != 0u) {
                                            phi_1088_ = _e548;
                                            phi_1091_ = type_7(0u, ((_e574 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e780 = phi_1088_;
                                                let _e782 = phi_1091_;
                                                local_2 = _e780;
                                                local_5 = _e780;
                                                if (_e782.member < _e782.member_1) {
                                                    phi_1092_ = type_7((_e782.member + 1u), _e782.member_1);
                                                    phi_1114_ = type_7(1u, _e782.member);
                                                } else {
                                                    phi_1092_ = _e782;
                                                    phi_1114_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e795 = phi_1092_;
                                                let _e797 = phi_1114_;
                                                let _e801 = (bitcast<i32>(_e797.member) != 0i);
                                                if _e801 {
                                                    let _e807 = type_49(_e780.member, _e780.member_1, (_e780.member_2 + 1u));
                                                    let _e808 = ((_e574 & 268435455u) + _e797.member_1);
                                                    let _e809 = (_e808 < _e79);
                                                    if _e809 {
                                                        if _e809 {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e813 = global_1.member[_e808].member_1;
                                                        phi_1138_ = _e813;
                                                    } else {
                                                        phi_1138_ = 4294967295u;
                                                    }
                                                    let _e815 = phi_1138_;
                                                    if (_e808 >= _e79) {
                                                        phi_1230_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e809 {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e817 = (_e215 % 3u);
                                                        let _e818 = (_e214 % 3u);
                                                        let _e819 = (_e216 % 3u);
                                                        if (_e817 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e825 = global_1.member[_e808].member[_e817];
                                                        if (_e818 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e831 = global_1.member[_e808].member[_e818];
                                                        if (_e819 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e837 = global_1.member[_e808].member[_e819];
                                                        let _e839 = (3u + _e817);
                                                        if (_e839 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e845 = global_1.member[_e808].member[_e839];
                                                        let _e846 = (3u + _e818);
                                                        if (_e846 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e852 = global_1.member[_e808].member[_e846];
                                                        let _e853 = (3u + _e819);
                                                        if (_e853 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e859 = global_1.member[_e808].member[_e853];
                                                        let _e861 = (6u + _e817);
                                                        if (_e861 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e867 = global_1.member[_e808].member[_e861];
                                                        let _e868 = (6u + _e818);
                                                        if (_e868 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e874 = global_1.member[_e808].member[_e868];
                                                        let _e875 = (6u + _e819);
                                                        if (_e875 < 9u) {
                                                        } else {
                                                            phi_2954_ = true;
                                                            break;
                                                        }
                                                        let _e881 = global_1.member[_e808].member[_e875];
                                                        phi_1230_ = array<array<f32, 3>, 3>(array<f32, 3>(_e825, _e831, _e837), array<f32, 3>(_e845, _e852, _e859), array<f32, 3>(_e867, _e874, _e881));
                                                    }
                                                    let _e885 = phi_1230_;
                                                    let _e902 = (_e885[0][2] - _e391);
                                                    let _e905 = (((_e885[0][0] - _e262) * _e427) - (_e902 * _e299));
                                                    let _e908 = (((_e885[0][1] - _e327) * _e427) - (_e902 * _e363));
                                                    let _e911 = (_e885[1][2] - _e391);
                                                    let _e914 = (((_e885[1][0] - _e262) * _e427) - (_e911 * _e299));
                                                    let _e917 = (((_e885[1][1] - _e327) * _e427) - (_e911 * _e363));
                                                    let _e920 = (_e885[2][2] - _e391);
                                                    let _e923 = (((_e885[2][0] - _e262) * _e427) - (_e920 * _e299));
                                                    let _e926 = (((_e885[2][1] - _e327) * _e427) - (_e920 * _e363));
                                                    let _e927 = (_e923 * _e917);
                                                    let _e928 = (_e926 * _e914);
                                                    let _e929 = (_e905 * _e926);
                                                    let _e930 = (_e908 * _e923);
                                                    let _e931 = (_e914 * _e908);
                                                    let _e932 = (_e917 * _e905);
                                                    let _e937 = (((_e927 >= _e928) && (_e929 >= _e930)) && (_e931 >= _e932));
                                                    let _e943 = (_e937 || (((_e927 <= _e928) && (_e929 <= _e930)) && (_e931 <= _e932)));
                                                    if _e943 {
                                                        let _e945 = select(-1f, 1f, _e937);
                                                        let _e947 = ((_e927 - _e928) * _e945);
                                                        let _e949 = select(0f, _e947, (_e947 > 0f));
                                                        let _e951 = ((_e929 - _e930) * _e945);
                                                        let _e953 = select(0f, _e951, (_e951 > 0f));
                                                        let _e955 = ((_e931 - _e932) * _e945);
                                                        let _e957 = select(0f, _e955, (_e955 > 0f));
                                                        let _e959 = ((_e949 + _e953) + _e957);
                                                        let _e961 = select(_e885[1][0], _e885[0][0], (_e885[0][0] < _e885[1][0]));
                                                        let _e965 = select(_e885[1][0], _e885[0][0], (_e885[0][0] > _e885[1][0]));
                                                        let _e969 = select(_e885[1][1], _e885[0][1], (_e885[0][1] < _e885[1][1]));
                                                        let _e973 = select(_e885[1][1], _e885[0][1], (_e885[0][1] > _e885[1][1]));
                                                        let _e977 = select(_e885[1][2], _e885[0][2], (_e885[0][2] < _e885[1][2]));
                                                        let _e981 = select(_e885[1][2], _e885[0][2], (_e885[0][2] > _e885[1][2]));
                                                        let _e986 = ((select(_e885[2][0], _e961, (_e961 < _e885[2][0])) - _e300) * _e303);
                                                        let _e987 = ((select(_e885[2][0], _e965, (_e965 > _e885[2][0])) - _e301) * _e303);
                                                        let _e990 = ((select(_e885[2][1], _e969, (_e969 < _e885[2][1])) - _e364) * _e367);
                                                        let _e991 = ((select(_e885[2][1], _e973, (_e973 > _e885[2][1])) - _e365) * _e367);
                                                        let _e994 = ((select(_e885[2][2], _e977, (_e977 < _e885[2][2])) - _e428) * _e431);
                                                        let _e995 = ((select(_e885[2][2], _e981, (_e981 > _e885[2][2])) - _e429) * _e431);
                                                        let _e997 = select(_e995, _e994, (_e994 < _e995));
                                                        let _e999 = select(_e995, _e994, (_e994 > _e995));
                                                        let _e1001 = select(_e987, _e986, (_e986 < _e987));
                                                        let _e1003 = select(_e991, _e990, (_e990 < _e991));
                                                        let _e1005 = select(_e1003, _e1001, (_e1001 > _e1003));
                                                        let _e1007 = select(_e997, _e1005, (_e1005 > _e997));
                                                        let _e1009 = select(_e987, _e986, (_e986 > _e987));
                                                        let _e1011 = select(_e991, _e990, (_e990 > _e991));
                                                        let _e1013 = select(_e1011, _e1009, (_e1009 < _e1011));
                                                        let _e1015 = select(_e999, _e1013, (_e1013 < _e999));
                                                        let _e1016 = -(_e997);
                                                        let _e1022 = select(_e533, _e1007, (_e1007 > _e533));
                                                        let _e1026 = select(_e914, _e905, (_e905 < _e914));
                                                        let _e1031 = select(_e914, _e905, (_e905 > _e914));
                                                        let _e1038 = select(_e917, _e908, (_e908 < _e917));
                                                        let _e1043 = select(_e917, _e908, (_e908 > _e917));
                                                        let _e1052 = (((((_e943 && (_e959 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e923, _e1026, (_e1026 < _e923)) <= 0f) && (select(_e923, _e1031, (_e1031 > _e923)) >= 0f))) && ((select(_e926, _e1038, (_e1038 < _e926)) <= 0f) && (select(_e926, _e1043, (_e1043 > _e926)) >= 0f))) && (_e1022 <= (_e1015 + (select(_e1016, _e999, (_e999 > _e1016)) * 0.0000019073523f)))) && (_e1022 <= _e780.member.member_1));
                                                        if _e1052 {
                                                            let _e1057 = (_e885[1][0] - _e885[0][0]);
                                                            let _e1058 = (_e885[1][1] - _e885[0][1]);
                                                            let _e1059 = (_e885[1][2] - _e885[0][2]);
                                                            let _e1060 = vec3<f32>(_e1057, _e1058, _e1059);
                                                            let _e1061 = (_e885[2][0] - _e885[1][0]);
                                                            let _e1062 = (_e885[2][1] - _e885[1][1]);
                                                            let _e1063 = (_e885[2][2] - _e885[1][2]);
                                                            let _e1064 = vec3<f32>(_e1061, _e1062, _e1063);
                                                            let _e1065 = (_e885[0][0] - _e885[2][0]);
                                                            let _e1066 = (_e885[0][1] - _e885[2][1]);
                                                            let _e1067 = (_e885[0][2] - _e885[2][2]);
                                                            let _e1068 = vec3<f32>(_e1065, _e1066, _e1067);
                                                            let _e1071 = bitcast<f32>((bitcast<u32>(_e1057) & 2147483647u));
                                                            let _e1074 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                            let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                            let _e1079 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                            let _e1081 = select(_e1079, _e1076, (_e1076 > _e1079));
                                                            let _e1084 = bitcast<f32>((bitcast<u32>(_e1061) & 2147483647u));
                                                            let _e1087 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                            let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                            let _e1092 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                            let _e1094 = select(_e1092, _e1089, (_e1089 > _e1092));
                                                            let _e1097 = bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u));
                                                            let _e1100 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                                            let _e1102 = select(_e1100, _e1097, (_e1097 > _e1100));
                                                            let _e1105 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                            let _e1107 = select(_e1105, _e1102, (_e1102 > _e1105));
                                                            let _e1109 = select(_e1094, _e1081, (_e1081 > _e1094));
                                                            let _e1111 = select(_e1107, _e1109, (_e1109 > _e1107));
                                                            if (_e1081 == _e1111) {
                                                                phi_1760_ = _e917;
                                                                phi_1761_ = _e914;
                                                                phi_1762_ = _e908;
                                                                phi_1763_ = _e905;
                                                                phi_1764_ = vec3<f32>(_e885[0][0], _e885[0][1], _e885[0][2]);
                                                                phi_1765_ = _e1068;
                                                                phi_1766_ = _e1064;
                                                                phi_1767_ = _e1060;
                                                            } else {
                                                                let _e1113 = (_e1094 == _e1111);
                                                                let _e1118 = vec3(_e1113);
                                                                phi_1760_ = select(_e908, _e926, _e1113);
                                                                phi_1761_ = select(_e905, _e923, _e1113);
                                                                phi_1762_ = select(_e926, _e917, _e1113);
                                                                phi_1763_ = select(_e923, _e914, _e1113);
                                                                phi_1764_ = select(vec3<f32>(_e885[2][0], _e885[2][1], _e885[2][2]), vec3<f32>(_e885[1][0], _e885[1][1], _e885[1][2]), _e1118);
                                                                phi_1765_ = select(_e1064, _e1060, _e1118);
                                                                phi_1766_ = select(_e1060, _e1068, _e1118);
                                                                phi_1767_ = select(_e1068, _e1064, _e1118);
                                                            }
                                                            let _e1124 = phi_1760_;
                                                            let _e1126 = phi_1761_;
                                                            let _e1128 = phi_1762_;
                                                            let _e1130 = phi_1763_;
                                                            let _e1132 = phi_1764_;
                                                            let _e1134 = phi_1765_;
                                                            let _e1136 = phi_1766_;
                                                            let _e1138 = phi_1767_;
                                                            let _e1145 = ((_e1136.y * _e1134.z) - (_e1134.y * _e1136.z));
                                                            let _e1150 = ((_e1136.z * _e1134.x) - (_e1134.z * _e1136.x));
                                                            let _e1153 = ((_e1136.x * _e1134.y) - (_e1134.x * _e1136.y));
                                                            let _e1156 = ((_e949 >= _e953) && (_e949 >= _e957));
                                                            let _e1157 = (_e953 >= _e957);
                                                            let _e1171 = (((_e1145 * (select(select(_e885[2][0], _e885[1][0], _e1157), _e885[0][0], _e1156) - _e262)) + (_e1150 * (select(select(_e885[2][1], _e885[1][1], _e1157), _e885[0][1], _e1156) - _e327))) + (_e1153 * (select(select(_e885[2][2], _e885[1][2], _e1157), _e885[0][2], _e1156) - _e391)));
                                                            let _e1176 = (((_e1145 * _e299) + (_e1150 * _e363)) + (_e1153 * _e427));
                                                            let _e1177 = (_e1126 - _e1130);
                                                            let _e1178 = (_e1124 - _e1128);
                                                            let _e1181 = ((_e1177 * _e1177) + (_e1178 * _e1178));
                                                            let _e1188 = (-(((_e1130 * _e1177) + (_e1128 * _e1178))) / select(0.000000000000000000000000000000000000011754944f, _e1181, (_e1181 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1190 = select(1f, _e1188, (_e1188 < 1f));
                                                            let _e1192 = select(0f, _e1190, (_e1190 > 0f));
                                                            let _e1201 = ((_e1132.x + (_e1138.x * _e1192)) - _e262);
                                                            let _e1204 = ((_e1132.y + (_e1138.y * _e1192)) - _e327);
                                                            let _e1207 = ((_e1132.z + (_e1138.z * _e1192)) - _e391);
                                                            let _e1210 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                            let _e1213 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                            let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                                                            let _e1218 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                            let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                                            let _e1226 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                            let _e1229 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                            let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                            let _e1234 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                            let _e1253 = bitcast<f32>((bitcast<u32>(_e1136.x) & 2147483647u));
                                                            let _e1256 = bitcast<f32>((bitcast<u32>(_e1136.y) & 2147483647u));
                                                            let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                            let _e1261 = bitcast<f32>((bitcast<u32>(_e1136.z) & 2147483647u));
                                                            let _e1267 = bitcast<f32>((bitcast<u32>(_e1134.x) & 2147483647u));
                                                            let _e1270 = bitcast<f32>((bitcast<u32>(_e1134.y) & 2147483647u));
                                                            let _e1272 = select(_e1270, _e1267, (_e1267 > _e1270));
                                                            let _e1275 = bitcast<f32>((bitcast<u32>(_e1134.z) & 2147483647u));
                                                            let _e1281 = ((bitcast<f32>((bitcast<u32>(((((_e1145 * _e1201) + (_e1150 * _e1204)) + (_e1153 * _e1207)) - _e1171)) & 2147483647u)) <= ((0.0000009536743f * select(_e1111, _e1220, (_e1220 > _e1111))) * select(_e1234, _e1231, (_e1231 > _e1234)))) && !((bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u)) <= ((0.0000038146973f * select(_e1261, _e1258, (_e1258 > _e1261))) * select(_e1275, _e1272, (_e1272 > _e1275))))));
                                                            let _e1282 = (_e1171 / _e1176);
                                                            if (_e1052 && !(_e1281)) {
                                                                let _e1285 = (_e1207 / _e427);
                                                                let _e1293 = (((_e1145 * (_e1201 - (_e299 * _e1285))) + (_e1150 * (_e1204 - (_e363 * _e1285)))) / _e1176);
                                                                phi_1958_ = select(select(_e1285, (_e1285 + _e1293), (bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u)) <= _e1111)), _e1282, _e1281);
                                                            } else {
                                                                phi_1958_ = _e1282;
                                                            }
                                                            let _e1302 = phi_1958_;
                                                            let _e1304 = select(_e1015, _e1302, (_e1302 < _e1015));
                                                            let _e1306 = select(_e1007, _e1304, (_e1304 > _e1007));
                                                            let _e1307 = (1f / _e959);
                                                            phi_1978_ = type_47(_e1306, (_e953 * _e1307), (_e957 * _e1307), ((_e1052 && (_e1306 >= _e533)) && (_e1306 <= _e780.member.member_1)));
                                                            phi_1979_ = type_47();
                                                        } else {
                                                            phi_1978_ = type_47();
                                                            phi_1979_ = type_47(0f, 0f, 0f, _e1052);
                                                        }
                                                        let _e1316 = phi_1978_;
                                                        let _e1318 = phi_1979_;
                                                        phi_1982_ = _e1316;
                                                        phi_1983_ = _e1318;
                                                        phi_1984_ = select(true, false, _e1052);
                                                    } else {
                                                        phi_1982_ = type_47();
                                                        phi_1983_ = type_47(0f, 0f, 0f, _e943);
                                                        phi_1984_ = true;
                                                    }
                                                    let _e1321 = phi_1982_;
                                                    let _e1323 = phi_1983_;
                                                    let _e1325 = phi_1984_;
                                                    if _e1325 {
                                                        phi_1988_ = _e1323;
                                                    } else {
                                                        phi_1988_ = _e1321;
                                                    }
                                                    let _e1327 = phi_1988_;
                                                    if _e1327.member_3 {
                                                        phi_1997_ = type_22(_e1327.member, _e1327.member_1, _e1327.member_2, _e815);
                                                    } else {
                                                        phi_1997_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1334 = phi_1997_;
                                                    if (_e1334.member_3 != 4294967295u) {
                                                        if (_e815 != _e539) {
                                                            if (_e1334.member < _e780.member.member.member) {
                                                                phi_2023_ = true;
                                                            } else {
                                                                if (_e1334.member == _e780.member.member.member) {
                                                                    phi_2022_ = (_e1334.member_3 < _e780.member.member.member_3);
                                                                } else {
                                                                    phi_2022_ = false;
                                                                }
                                                                let _e1349 = phi_2022_;
                                                                phi_2023_ = _e1349;
                                                            }
                                                            let _e1351 = phi_2023_;
                                                            if _e1351 {
                                                                phi_2030_ = type_49(type_43(_e1334, _e1334.member), _e807.member_1, _e807.member_2);
                                                            } else {
                                                                phi_2030_ = _e807;
                                                            }
                                                            let _e1358 = phi_2030_;
                                                            phi_2031_ = _e1358;
                                                        } else {
                                                            phi_2031_ = _e807;
                                                        }
                                                        let _e1360 = phi_2031_;
                                                        phi_2032_ = _e1360;
                                                    } else {
                                                        phi_2032_ = _e807;
                                                    }
                                                    let _e1362 = phi_2032_;
                                                    phi_1089_ = _e1362;
                                                } else {
                                                    phi_1089_ = type_49();
                                                }
                                                let _e1364 = phi_1089_;
                                                continue;
                                                continuing {
                                                    phi_1088_ = _e1364;
                                                    phi_1091_ = _e795;
                                                    phi_2954_ = _e546;
                                                    break if !(_e801);
                                                }
                                            }
                                            let _e1367 = phi_2954_;
                                            phi_3107_ = _e1367;
                                            if _e1367 {
                                                break;
                                            }
                                            let _e1369 = local_2;
                                            phi_3111_ = _e1367;
                                            let _e1677 = local_5;
                                            phi_2512_ = _e1677;
                                            phi_2513_ = false;
                                            phi_2514_ = _e574;
                                            phi_2515_ = select(_e576, 0u, (_e533 > _e1369.member.member_1));
                                        } else {
                                            if (_e574 >= _e77) {
                                                phi_2097_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e574 < _e77) {
                                                } else {
                                                    phi_3107_ = true;
                                                    break;
                                                }
                                                let _e586 = (_e215 % 3u);
                                                if (_e586 < 3u) {
                                                } else {
                                                    phi_3107_ = true;
                                                    break;
                                                }
                                                let _e592 = global_2.member[_e574].member[_e586];
                                                let _e598 = (_e214 % 3u);
                                                if (_e598 < 3u) {
                                                } else {
                                                    phi_3107_ = true;
                                                    break;
                                                }
                                                let _e604 = global_2.member[_e574].member[_e598];
                                                let _e610 = (_e216 % 3u);
                                                if (_e610 < 3u) {
                                                } else {
                                                    phi_3107_ = true;
                                                    break;
                                                }
                                                let _e616 = global_2.member[_e574].member[_e610];
                                                let _e626 = global_2.member[_e574].member_1;
                                                let _e630 = global_2.member[_e574].member_2;
                                                phi_2097_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e592[0], _e592[1], _e592[2], _e592[3]), vec4<f32>(_e604[0], _e604[1], _e604[2], _e604[3]), vec4<f32>(_e616[0], _e616[1], _e616[2], _e616[3])), _e626, _e630);
                                            }
                                            let _e633 = phi_2097_;
                                            let _e652 = ((_e633.member[0].x - _e300) * _e303);
                                            let _e653 = ((_e633.member[0].y - _e300) * _e303);
                                            let _e654 = ((_e633.member[0].z - _e301) * _e303);
                                            let _e655 = ((_e633.member[0].w - _e301) * _e303);
                                            let _e665 = ((_e633.member[1].x - _e364) * _e367);
                                            let _e666 = ((_e633.member[1].y - _e364) * _e367);
                                            let _e667 = ((_e633.member[1].z - _e365) * _e367);
                                            let _e668 = ((_e633.member[1].w - _e365) * _e367);
                                            let _e678 = ((_e633.member[2].x - _e428) * _e431);
                                            let _e679 = ((_e633.member[2].y - _e428) * _e431);
                                            let _e680 = ((_e633.member[2].z - _e429) * _e431);
                                            let _e681 = ((_e633.member[2].w - _e429) * _e431);
                                            let _e683 = select(_e680, _e678, (_e678 < _e680));
                                            let _e685 = select(_e681, _e679, (_e679 < _e681));
                                            let _e687 = select(_e680, _e678, (_e678 > _e680));
                                            let _e689 = select(_e681, _e679, (_e679 > _e681));
                                            let _e691 = select(_e654, _e652, (_e652 < _e654));
                                            let _e693 = select(_e655, _e653, (_e653 < _e655));
                                            let _e695 = select(_e667, _e665, (_e665 < _e667));
                                            let _e697 = select(_e668, _e666, (_e666 < _e668));
                                            let _e699 = select(_e695, _e691, (_e691 > _e695));
                                            let _e701 = select(_e697, _e693, (_e693 > _e697));
                                            let _e703 = select(_e683, _e699, (_e699 > _e683));
                                            let _e705 = select(_e685, _e701, (_e701 > _e685));
                                            let _e707 = select(_e654, _e652, (_e652 > _e654));
                                            let _e709 = select(_e655, _e653, (_e653 > _e655));
                                            let _e711 = select(_e667, _e665, (_e665 > _e667));
                                            let _e713 = select(_e668, _e666, (_e666 > _e668));
                                            let _e715 = select(_e711, _e707, (_e707 < _e711));
                                            let _e717 = select(_e713, _e709, (_e709 < _e713));
                                            let _e722 = -(_e683);
                                            let _e723 = -(_e685);
                                            let _e730 = (select(_e687, _e715, (_e715 < _e687)) + (select(_e722, _e687, (_e687 > _e722)) * 0.0000019073523f));
                                            let _e731 = (select(_e689, _e717, (_e717 < _e689)) + (select(_e723, _e689, (_e689 > _e723)) * 0.0000019073523f));
                                            let _e733 = select(_e533, _e703, (_e703 > _e533));
                                            let _e735 = select(_e533, _e705, (_e705 > _e533));
                                            let _e740 = (_e733 <= select(_e548.member.member_1, _e730, (_e730 < _e548.member.member_1)));
                                            let _e741 = (_e735 <= select(_e548.member.member_1, _e731, (_e731 < _e548.member.member_1)));
                                            let _e742 = (_e733 <= _e735);
                                            if _e740 {
                                                if _e741 {
                                                    if _e742 {
                                                        phi_2462_ = _e633.member_2;
                                                    } else {
                                                        phi_2462_ = _e633.member_1;
                                                    }
                                                    let _e746 = phi_2462_;
                                                    let _e748 = (_e576 % 128u);
                                                    let _e749 = (_e748 < 128u);
                                                    if _e749 {
                                                    } else {
                                                        phi_3107_ = true;
                                                        break;
                                                    }
                                                    local_1[_e748] = _e746;
                                                    if _e749 {
                                                    } else {
                                                        phi_3107_ = true;
                                                        break;
                                                    }
                                                    local[_e748] = select(_e733, _e735, _e742);
                                                    if _e742 {
                                                        phi_2489_ = _e633.member_1;
                                                    } else {
                                                        phi_2489_ = _e633.member_2;
                                                    }
                                                    let _e756 = phi_2489_;
                                                    phi_2490_ = _e756;
                                                    phi_2491_ = (_e576 + 1u);
                                                } else {
                                                    phi_2490_ = u32();
                                                    phi_2491_ = u32();
                                                }
                                                let _e758 = phi_2490_;
                                                let _e760 = phi_2491_;
                                                phi_2493_ = _e758;
                                                phi_2494_ = _e760;
                                                phi_2495_ = select(true, false, _e741);
                                            } else {
                                                phi_2493_ = u32();
                                                phi_2494_ = u32();
                                                phi_2495_ = true;
                                            }
                                            let _e763 = phi_2493_;
                                            let _e765 = phi_2494_;
                                            let _e767 = phi_2495_;
                                            if _e767 {
                                                if _e740 {
                                                    phi_2504_ = _e633.member_1;
                                                } else {
                                                    phi_2504_ = _e633.member_2;
                                                }
                                                let _e771 = phi_2504_;
                                                phi_2509_ = select(_e741, true, _e740);
                                                phi_2510_ = _e771;
                                            } else {
                                                phi_2509_ = _e572;
                                                phi_2510_ = _e763;
                                            }
                                            let _e774 = phi_2509_;
                                            let _e776 = phi_2510_;
                                            phi_3111_ = _e546;
                                            phi_2512_ = type_49(_e548.member, (_e548.member_1 + 1u), _e548.member_2);
                                            phi_2513_ = _e774;
                                            phi_2514_ = _e776;
                                            phi_2515_ = select(_e765, _e576, _e767);
                                        }
                                        let _e1375 = phi_3111_;
                                        let _e1377 = phi_2512_;
                                        let _e1379 = phi_2513_;
                                        let _e1381 = phi_2514_;
                                        let _e1383 = phi_2515_;
                                        phi_3110_ = _e1375;
                                        phi_2516_ = _e1377;
                                        phi_2517_ = _e1379;
                                        phi_2518_ = _e1381;
                                        phi_2519_ = _e1383;
                                        phi_2520_ = (_e556 - 1u);
                                    } else {
                                        phi_3110_ = _e546;
                                        phi_2516_ = _e548;
                                        phi_2517_ = _e572;
                                        phi_2518_ = _e574;
                                        phi_2519_ = _e576;
                                        phi_2520_ = _e556;
                                    }
                                    let _e1385 = phi_3110_;
                                    let _e1387 = phi_2516_;
                                    let _e1389 = phi_2517_;
                                    let _e1391 = phi_2518_;
                                    let _e1393 = phi_2519_;
                                    let _e1395 = phi_2520_;
                                    phi_3109_ = _e1385;
                                    phi_2521_ = _e1387;
                                    phi_2522_ = _e1389;
                                    phi_2523_ = _e1391;
                                    phi_2524_ = _e1393;
                                    phi_2525_ = _e1395;
                                } else {
                                    phi_3109_ = _e546;
                                    phi_2521_ = type_49();
                                    phi_2522_ = bool();
                                    phi_2523_ = u32();
                                    phi_2524_ = u32();
                                    phi_2525_ = u32();
                                }
                                let _e1397 = phi_3109_;
                                let _e1399 = phi_2521_;
                                let _e1401 = phi_2522_;
                                let _e1403 = phi_2523_;
                                let _e1405 = phi_2524_;
                                let _e1407 = phi_2525_;
                                phi_3108_ = _e1397;
                                phi_1020_ = _e1399;
                                phi_1023_ = _e1401;
                                phi_1025_ = _e1403;
                                phi_1027_ = _e1405;
                                phi_1029_ = _e1407;
                                phi_2526_ = _e560;
                            } else {
                                phi_3108_ = _e546;
                                phi_1020_ = type_49();
                                phi_1023_ = bool();
                                phi_1025_ = u32();
                                phi_1027_ = u32();
                                phi_1029_ = u32();
                                phi_2526_ = false;
                            }
                            let _e1409 = phi_3108_;
                            let _e1411 = phi_1020_;
                            let _e1413 = phi_1023_;
                            let _e1415 = phi_1025_;
                            let _e1417 = phi_1027_;
                            let _e1419 = phi_1029_;
                            let _e1421 = phi_2526_;
                            continue;
                            continuing {
                                phi_2960_ = _e1409;
                                phi_1019_ = _e1411;
                                phi_1022_ = _e1413;
                                phi_1024_ = _e1415;
                                phi_1026_ = _e1417;
                                phi_1028_ = _e1419;
                                phi_3107_ = _e1409;
                                break if !(_e1421);
                            }
                        }
                        let _e1424 = phi_3107_;
                        if _e1424 {
                            break;
                        }
                        let _e1426 = local_3;
                        if (_e1426.member.member.member_3 != 4294967295u) {
                            let _e1432 = bitcast<u32>(_e1426.member.member.member);
                            let _e1436 = (bitcast<i32>((_e1432 >> bitcast<u32>(23i))) & 255i);
                            let _e1437 = (_e1436 + _e217);
                            if (_e1436 == 255i) {
                                phi_2585_ = _e1426.member.member.member;
                            } else {
                                if (_e1436 > 0i) {
                                    if (_e1437 > 0i) {
                                        let _e1441 = (_e1437 < 255i);
                                        if _e1441 {
                                            phi_2564_ = bitcast<f32>((_e1432 + bitcast<u32>((_e217 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_2564_ = f32();
                                        }
                                        let _e1448 = phi_2564_;
                                        phi_2566_ = _e1448;
                                        phi_2567_ = select(true, false, _e1441);
                                    } else {
                                        phi_2566_ = f32();
                                        phi_2567_ = true;
                                    }
                                    let _e1451 = phi_2566_;
                                    let _e1453 = phi_2567_;
                                    phi_2568_ = _e1451;
                                    phi_2569_ = _e1453;
                                } else {
                                    phi_2568_ = f32();
                                    phi_2569_ = true;
                                }
                                let _e1455 = phi_2568_;
                                let _e1457 = phi_2569_;
                                if _e1457 {
                                    let _e1458 = (_e1432 & 2147483648u);
                                    let _e1465 = ((_e1432 & 8388607u) | (select(0u, 1u, ((_e1432 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1469 = (_e1465 == 0u);
                                    if _e1469 {
                                        phi_2949_ = bitcast<f32>(_e1458);
                                    } else {
                                        let _e1474 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1465)), 32u, _e1469) - 8u);
                                        let _e1477 = (_e1465 << bitcast<u32>((_e1474 & 31u)));
                                        let _e1479 = ((_e1437 + select(0i, 1i, (_e1436 == 0i))) - bitcast<i32>(_e1474));
                                        if (_e1479 >= 255i) {
                                            phi_2939_ = bitcast<f32>((_e1458 | 2139095040u));
                                            phi_2940_ = f32();
                                            phi_2941_ = true;
                                        } else {
                                            let _e1481 = (_e1479 > 0i);
                                            if _e1481 {
                                                phi_2933_ = bitcast<f32>(((_e1458 | (bitcast<u32>(_e1479) << bitcast<u32>(23i))) | (_e1477 & 8388607u)));
                                                phi_2934_ = f32();
                                            } else {
                                                if (_e1479 < -24i) {
                                                    phi_2899_ = 26u;
                                                } else {
                                                    phi_2899_ = bitcast<u32>((1i - _e1479));
                                                }
                                                let _e1486 = phi_2899_;
                                                let _e1487 = (_e1486 & 31u);
                                                let _e1489 = (_e1477 >> bitcast<u32>(_e1487));
                                                let _e1493 = (_e1477 & ((1u << bitcast<u32>(_e1487)) - 1u));
                                                let _e1497 = (1u << bitcast<u32>(((_e1486 - 1u) & 31u)));
                                                if (_e1493 > _e1497) {
                                                    phi_2920_ = true;
                                                } else {
                                                    if (_e1493 == _e1497) {
                                                        phi_2917_ = ((_e1489 & 1u) == 1u);
                                                    } else {
                                                        phi_2917_ = false;
                                                    }
                                                    let _e1503 = phi_2917_;
                                                    phi_2920_ = _e1503;
                                                }
                                                let _e1505 = phi_2920_;
                                                phi_2933_ = f32();
                                                phi_2934_ = bitcast<f32>((_e1458 | (_e1489 + select(0u, 1u, _e1505))));
                                            }
                                            let _e1518 = phi_2933_;
                                            let _e1520 = phi_2934_;
                                            phi_2939_ = _e1518;
                                            phi_2940_ = _e1520;
                                            phi_2941_ = _e1481;
                                        }
                                        let _e1524 = phi_2939_;
                                        let _e1526 = phi_2940_;
                                        let _e1528 = phi_2941_;
                                        phi_2949_ = select(_e1526, _e1524, _e1528);
                                    }
                                    let _e1532 = phi_2949_;
                                    phi_2584_ = _e1532;
                                } else {
                                    phi_2584_ = _e1455;
                                }
                                let _e1534 = phi_2584_;
                                phi_2585_ = _e1534;
                            }
                            let _e1536 = phi_2585_;
                            let _e1537 = bitcast<u32>(_e1536);
                            if ((_e1537 & 2147483647u) >= 2139095040u) {
                                phi_2597_ = bitcast<f32>(((_e1537 & 2147483648u) | 2139095039u));
                            } else {
                                phi_2597_ = _e1536;
                            }
                            let _e1544 = phi_2597_;
                            phi_2602_ = type_22(_e1544, _e1426.member.member.member_1, _e1426.member.member.member_2, _e1426.member.member.member_3);
                        } else {
                            phi_2602_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1549 = phi_2602_;
                        if _e93 {
                        } else {
                            break;
                        }
                        global_4.member[_e91] = _e1549;
                        let _e1553 = local_4;
                        if _e94 {
                        } else {
                            break;
                        }
                        global_5.member[_e91] = _e1553.member_1;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e1558 = select(0u, 1u, (_e161 <= _e171));
                        if (_e1558 > 0u) {
                            let _e1560 = (1u < _e87);
                            if _e1560 {
                                if (0u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1564 = atomicAdd((&global_6.member[0u]), _e1558);
                                if ((_e1564 + _e1558) < _e1564) {
                                    if _e1560 {
                                    } else {
                                        break;
                                    }
                                    let _e1569 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1572 = select(0u, 1u, (_e1549.member_3 != 4294967295u));
                        if (_e1572 > 0u) {
                            let _e1574 = (3u < _e87);
                            if _e1574 {
                                if (2u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1578 = atomicAdd((&global_6.member[2u]), _e1572);
                                if ((_e1578 + _e1572) < _e1578) {
                                    if _e1574 {
                                    } else {
                                        break;
                                    }
                                    let _e1583 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1553.member_1 > 0u) {
                            let _e1585 = (5u < _e87);
                            if _e1585 {
                                if (4u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1589 = atomicAdd((&global_6.member[4u]), _e1553.member_1);
                                if ((_e1589 + _e1553.member_1) < _e1589) {
                                    if _e1585 {
                                    } else {
                                        break;
                                    }
                                    let _e1594 = atomicAdd((&global_6.member[5u]), 1u);
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
fn trace_paths_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
