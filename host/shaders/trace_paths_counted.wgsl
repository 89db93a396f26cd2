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
    var phi_395_: i32;
    var phi_396_: i32;
    var phi_406_: bool;
    var phi_416_: u32;
    var phi_417_: u32;
    var phi_419_: bool;
    var phi_424_: u32;
    var phi_457_: i32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_521_: f32;
    var phi_527_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_771_: f32;
    var phi_777_: f32;
    var phi_896_: i32;
    var phi_918_: u32;
    var phi_919_: u32;
    var phi_956_: i32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_3034_: bool;
    var phi_1012_: type_49;
    var phi_1015_: u32;
    var phi_1017_: bool;
    var phi_1019_: u32;
    var phi_1021_: u32;
    var phi_1032_: bool;
    var phi_1064_: bool;
    var phi_1065_: u32;
    var phi_1066_: u32;
    var phi_1081_: type_49;
    var phi_1084_: type_7;
    var phi_1085_: type_7;
    var phi_1107_: type_7;
    var phi_1131_: u32;
    var phi_1223_: array<array<f32, 3>, 3>;
    var phi_2780_: bool;
    var phi_2795_: bool;
    var phi_2810_: bool;
    var phi_2825_: bool;
    var phi_2840_: bool;
    var phi_2855_: bool;
    var phi_1765_: f32;
    var phi_1766_: f32;
    var phi_1767_: f32;
    var phi_1768_: f32;
    var phi_1769_: vec3<f32>;
    var phi_1770_: vec3<f32>;
    var phi_1771_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_2870_: bool;
    var phi_2885_: bool;
    var phi_2900_: bool;
    var phi_2915_: bool;
    var phi_2930_: bool;
    var phi_2945_: bool;
    var phi_1980_: f32;
    var phi_2000_: type_47;
    var phi_2001_: type_47;
    var phi_2004_: type_47;
    var phi_2005_: type_47;
    var phi_2006_: bool;
    var phi_2010_: type_47;
    var phi_2019_: type_22;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2052_: type_49;
    var phi_2053_: type_49;
    var phi_2054_: type_49;
    var phi_1082_: type_49;
    var phi_3028_: bool;
    var phi_3228_: bool;
    var phi_2055_: type_49;
    var phi_2120_: type_48;
    var phi_2485_: u32;
    var phi_2512_: u32;
    var phi_2513_: u32;
    var phi_2514_: u32;
    var phi_2516_: u32;
    var phi_2517_: u32;
    var phi_2518_: bool;
    var phi_2527_: u32;
    var phi_2532_: bool;
    var phi_2534_: u32;
    var phi_2539_: type_49;
    var phi_2540_: bool;
    var phi_2541_: u32;
    var phi_2542_: u32;
    var phi_2550_: type_49;
    var phi_3196_: bool;
    var phi_2554_: type_49;
    var phi_2555_: u32;
    var phi_2556_: bool;
    var phi_2557_: u32;
    var phi_2558_: u32;
    var phi_3195_: bool;
    var phi_2559_: type_49;
    var phi_2560_: u32;
    var phi_2561_: bool;
    var phi_2562_: u32;
    var phi_2563_: u32;
    var phi_3194_: bool;
    var phi_1013_: type_49;
    var phi_1016_: u32;
    var phi_1018_: bool;
    var phi_1020_: u32;
    var phi_1022_: u32;
    var phi_2564_: bool;
    var phi_3193_: bool;
    var local_2: type_49;
    var phi_2602_: f32;
    var phi_2604_: f32;
    var phi_2605_: bool;
    var phi_2606_: f32;
    var phi_2607_: bool;
    var phi_2973_: u32;
    var phi_2991_: bool;
    var phi_2994_: bool;
    var phi_3007_: f32;
    var phi_3008_: f32;
    var phi_3013_: f32;
    var phi_3014_: f32;
    var phi_3015_: bool;
    var phi_3023_: f32;
    var phi_2622_: f32;
    var phi_2623_: f32;
    var phi_2635_: f32;
    var phi_2640_: type_22;
    var local_3: type_49;
    var local_4: type_49;

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
                                phi_395_ = (bitcast<i32>((_e180 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_395_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                            }
                            let _e194 = phi_395_;
                            phi_396_ = _e194;
                        } else {
                            phi_396_ = 0i;
                        }
                        let _e196 = phi_396_;
                        let _e197 = (_e106 == _e150);
                        if _e197 {
                            phi_406_ = true;
                        } else {
                            phi_406_ = (_e114 == _e150);
                        }
                        let _e200 = phi_406_;
                        let _e201 = select(1u, 0u, _e197);
                        if _e200 {
                            let _e202 = (_e201 + 1u);
                            phi_416_ = _e202;
                            phi_417_ = _e202;
                            phi_419_ = select(true, false, (_e202 == 2u));
                        } else {
                            phi_416_ = u32();
                            phi_417_ = 0u;
                            phi_419_ = true;
                        }
                        let _e206 = phi_416_;
                        let _e208 = phi_417_;
                        let _e210 = phi_419_;
                        if _e210 {
                            phi_424_ = (_e208 + 1u);
                        } else {
                            phi_424_ = 0u;
                        }
                        let _e214 = phi_424_;
                        let _e215 = select(_e206, _e208, _e210);
                        let _e216 = select(_e201, select(2u, _e201, _e200), _e210);
                        let _e217 = -(_e196);
                        if (_e217 < -126i) {
                            phi_457_ = -126i;
                        } else {
                            phi_457_ = select(_e217, 127i, (_e217 > 127i));
                        }
                        let _e222 = phi_457_;
                        let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                        let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                        let _e238 = global_3.member[_e91].member.member;
                        let _e239 = (_e215 == 0u);
                        if _e239 {
                            phi_475_ = _e238[0];
                        } else {
                            phi_475_ = _e238[1];
                        }
                        let _e243 = phi_475_;
                        let _e244 = (_e215 == 2u);
                        if _e244 {
                            phi_481_ = _e238[2];
                        } else {
                            phi_481_ = _e243;
                        }
                        let _e247 = phi_481_;
                        let _e248 = bitcast<u32>(_e247);
                        let _e250 = ((_e248 & 2139095040u) != 0u);
                        let _e262 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * select(0.00000011920929f, 1f, _e250));
                        let _e263 = global_3.member[_e91].member.member_2;
                        if _e239 {
                            phi_521_ = _e263[0];
                        } else {
                            phi_521_ = _e263[1];
                        }
                        let _e267 = phi_521_;
                        if _e244 {
                            phi_527_ = _e263[2];
                        } else {
                            phi_527_ = _e267;
                        }
                        let _e270 = phi_527_;
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
                            phi_600_ = _e238[0];
                        } else {
                            phi_600_ = _e238[1];
                        }
                        let _e308 = phi_600_;
                        let _e309 = (_e214 == 2u);
                        if _e309 {
                            phi_606_ = _e238[2];
                        } else {
                            phi_606_ = _e308;
                        }
                        let _e312 = phi_606_;
                        let _e313 = bitcast<u32>(_e312);
                        let _e315 = ((_e313 & 2139095040u) != 0u);
                        let _e327 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * select(0.00000011920929f, 1f, _e315));
                        if _e304 {
                            phi_646_ = _e263[0];
                        } else {
                            phi_646_ = _e263[1];
                        }
                        let _e331 = phi_646_;
                        if _e309 {
                            phi_652_ = _e263[2];
                        } else {
                            phi_652_ = _e331;
                        }
                        let _e334 = phi_652_;
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
                            phi_725_ = _e238[0];
                        } else {
                            phi_725_ = _e238[1];
                        }
                        let _e372 = phi_725_;
                        let _e373 = (_e216 == 2u);
                        if _e373 {
                            phi_731_ = _e238[2];
                        } else {
                            phi_731_ = _e372;
                        }
                        let _e376 = phi_731_;
                        let _e377 = bitcast<u32>(_e376);
                        let _e379 = ((_e377 & 2139095040u) != 0u);
                        let _e391 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e377 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e377 & 2147483648u))), _e376, _e379) * select(0.00000011920929f, 1f, _e379));
                        if _e368 {
                            phi_771_ = _e263[0];
                        } else {
                            phi_771_ = _e263[1];
                        }
                        let _e395 = phi_771_;
                        if _e373 {
                            phi_777_ = _e263[2];
                        } else {
                            phi_777_ = _e395;
                        }
                        let _e398 = phi_777_;
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
                                phi_896_ = 255i;
                            } else {
                                phi_896_ = (((_e448 + select(0i, 1i, (_e448 == 0i))) - _e455) + _e196);
                            }
                            let _e463 = phi_896_;
                            let _e473 = (_e463 <= 0i);
                            if _e473 {
                                phi_919_ = u32();
                            } else {
                                if _e452 {
                                    phi_918_ = u32();
                                } else {
                                    phi_918_ = select(((bitcast<u32>(_e463) << bitcast<u32>(23i)) | ((_e445 << bitcast<u32>(((_e455 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e463 >= 255i));
                                }
                                let _e477 = phi_918_;
                                phi_919_ = _e477;
                            }
                            let _e479 = phi_919_;
                            let _e491 = ((_e173 & 8388607u) | (select(0u, 1u, ((_e173 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e494 = bitcast<i32>((_e173 >> bitcast<u32>(23i)));
                            let _e498 = (_e491 == 0u);
                            let _e501 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e491)), 32u, _e498)) - 8i);
                            if (_e494 == 255i) {
                                phi_956_ = 255i;
                            } else {
                                phi_956_ = (((_e494 + select(0i, 1i, (_e494 == 0i))) - _e501) + _e196);
                            }
                            let _e509 = phi_956_;
                            let _e519 = (_e509 <= 0i);
                            if _e519 {
                                phi_979_ = u32();
                            } else {
                                if _e498 {
                                    phi_978_ = u32();
                                } else {
                                    phi_978_ = select(((bitcast<u32>(_e509) << bitcast<u32>(23i)) | ((_e491 << bitcast<u32>(((_e501 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e509 >= 255i));
                                }
                                let _e523 = phi_978_;
                                phi_979_ = _e523;
                            }
                            let _e525 = phi_979_;
                            phi_987_ = bitcast<f32>(((_e172 & 2147483648u) | select(_e525, 0u, select(_e498, true, _e519))));
                            phi_988_ = bitcast<f32>(((_e162 & 2147483648u) | select(_e479, 0u, select(_e452, true, _e473))));
                        } else {
                            phi_987_ = 0f;
                            phi_988_ = 1f;
                        }
                        let _e531 = phi_987_;
                        let _e533 = phi_988_;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e539 = global_3.member[_e91].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_3034_ = false;
                        phi_1012_ = type_49(type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e531), 0u, 0u);
                        phi_1015_ = ((3u * _e77) + 1u);
                        phi_1017_ = (_e533 <= _e531);
                        phi_1019_ = 0u;
                        phi_1021_ = select(0u, 2147483648u, (_e77 == 0u));
                        loop {
                            let _e546 = phi_3034_;
                            let _e548 = phi_1012_;
                            let _e550 = phi_1015_;
                            let _e552 = phi_1017_;
                            let _e554 = phi_1019_;
                            let _e556 = phi_1021_;
                            local_2 = _e548;
                            local_3 = _e548;
                            if _e552 {
                                phi_1032_ = true;
                            } else {
                                phi_1032_ = (_e554 > 0u);
                            }
                            let _e559 = phi_1032_;
                            if _e559 {
                                let _e560 = (_e550 > 0u);
                                if _e560 {
                                    if _e552 {
                                        phi_1064_ = _e552;
                                        phi_1065_ = _e554;
                                        phi_1066_ = _e556;
                                    } else {
                                        let _e561 = (_e554 - 1u);
                                        let _e562 = (_e561 % 128u);
                                        let _e563 = (_e562 < 128u);
                                        if _e563 {
                                        } else {
                                            phi_3193_ = true;
                                            break;
                                        }
                                        let _e565 = local_1[_e562];
                                        if _e563 {
                                        } else {
                                            phi_3193_ = true;
                                            break;
                                        }
                                        let _e567 = local[_e562];
                                        phi_1064_ = (_e567 <= _e548.member.member_1);
                                        phi_1065_ = _e561;
                                        phi_1066_ = _e565;
                                    }
                                    let _e572 = phi_1064_;
                                    let _e574 = phi_1065_;
                                    let _e576 = phi_1066_;
                                    if _e572 {
                                        let _e579 = ((_e576 & 2147483648u) != 0u);
                                        if _e579 {
                                            phi_1081_ = _e548;
                                            phi_1084_ = type_7(0u, ((_e576 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e586 = phi_1081_;
                                                let _e588 = phi_1084_;
                                                local_4 = _e586;
                                                if (_e588.member < _e588.member_1) {
                                                    phi_1085_ = type_7((_e588.member + 1u), _e588.member_1);
                                                    phi_1107_ = type_7(1u, _e588.member);
                                                } else {
                                                    phi_1085_ = _e588;
                                                    phi_1107_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e601 = phi_1085_;
                                                let _e603 = phi_1107_;
                                                let _e607 = (bitcast<i32>(_e603.member) != 0i);
                                                if _e607 {
                                                    let _e613 = type_49(_e586.member, _e586.member_1, (_e586.member_2 + 1u));
                                                    let _e614 = ((_e576 & 268435455u) + _e603.member_1);
                                                    let _e615 = (_e614 < _e79);
                                                    if _e615 {
                                                        if _e615 {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e619 = global_1.member[_e614].member_1;
                                                        phi_1131_ = _e619;
                                                    } else {
                                                        phi_1131_ = 4294967295u;
                                                    }
                                                    let _e621 = phi_1131_;
                                                    if (_e614 >= _e79) {
                                                        phi_1223_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e615 {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e623 = (_e215 % 3u);
                                                        let _e624 = (_e214 % 3u);
                                                        let _e625 = (_e216 % 3u);
                                                        if (_e623 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e631 = global_1.member[_e614].member[_e623];
                                                        if (_e624 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e637 = global_1.member[_e614].member[_e624];
                                                        if (_e625 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e643 = global_1.member[_e614].member[_e625];
                                                        let _e645 = (3u + _e623);
                                                        if (_e645 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e651 = global_1.member[_e614].member[_e645];
                                                        let _e652 = (3u + _e624);
                                                        if (_e652 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e658 = global_1.member[_e614].member[_e652];
                                                        let _e659 = (3u + _e625);
                                                        if (_e659 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e665 = global_1.member[_e614].member[_e659];
                                                        let _e667 = (6u + _e623);
                                                        if (_e667 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e673 = global_1.member[_e614].member[_e667];
                                                        let _e674 = (6u + _e624);
                                                        if (_e674 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e680 = global_1.member[_e614].member[_e674];
                                                        let _e681 = (6u + _e625);
                                                        if (_e681 < 9u) {
                                                        } else {
                                                            phi_3028_ = true;
                                                            break;
                                                        }
                                                        let _e687 = global_1.member[_e614].member[_e681];
                                                        phi_1223_ = array<array<f32, 3>, 3>(array<f32, 3>(_e631, _e637, _e643), array<f32, 3>(_e651, _e658, _e665), array<f32, 3>(_e673, _e680, _e687));
                                                    }
                                                    let _e691 = phi_1223_;
                                                    let _e708 = (_e691[0][2] - _e391);
                                                    let _e711 = (((_e691[0][0] - _e262) * _e427) - (_e708 * _e299));
                                                    let _e714 = (((_e691[0][1] - _e327) * _e427) - (_e708 * _e363));
                                                    let _e717 = (_e691[1][2] - _e391);
                                                    let _e720 = (((_e691[1][0] - _e262) * _e427) - (_e717 * _e299));
                                                    let _e723 = (((_e691[1][1] - _e327) * _e427) - (_e717 * _e363));
                                                    let _e726 = (_e691[2][2] - _e391);
                                                    let _e729 = (((_e691[2][0] - _e262) * _e427) - (_e726 * _e299));
                                                    let _e732 = (((_e691[2][1] - _e327) * _e427) - (_e726 * _e363));
                                                    let _e733 = (_e729 * _e723);
                                                    let _e734 = (_e732 * _e720);
                                                    let _e735 = (_e711 * _e732);
                                                    let _e736 = (_e714 * _e729);
                                                    let _e737 = (_e720 * _e714);
                                                    let _e738 = (_e723 * _e711);
                                                    let _e743 = (((_e733 >= _e734) && (_e735 >= _e736)) && (_e737 >= _e738));
                                                    let _e749 = (_e743 || (((_e733 <= _e734) && (_e735 <= _e736)) && (_e737 <= _e738)));
                                                    if _e749 {
                                                        let _e751 = select(-1f, 1f, _e743);
                                                        let _e753 = ((_e733 - _e734) * _e751);
                                                        let _e755 = select(0f, _e753, (_e753 > 0f));
                                                        let _e757 = ((_e735 - _e736) * _e751);
                                                        let _e759 = select(0f, _e757, (_e757 > 0f));
                                                        let _e761 = ((_e737 - _e738) * _e751);
                                                        let _e763 = select(0f, _e761, (_e761 > 0f));
                                                        let _e765 = ((_e755 + _e759) + _e763);
                                                        let _e767 = select(_e691[1][0], _e691[0][0], (_e691[0][0] < _e691[1][0]));
                                                        let _e771 = select(_e691[1][0], _e691[0][0], (_e691[0][0] > _e691[1][0]));
                                                        let _e775 = select(_e691[1][1], _e691[0][1], (_e691[0][1] < _e691[1][1]));
                                                        let _e779 = select(_e691[1][1], _e691[0][1], (_e691[0][1] > _e691[1][1]));
                                                        let _e783 = select(_e691[1][2], _e691[0][2], (_e691[0][2] < _e691[1][2]));
                                                        let _e787 = select(_e691[1][2], _e691[0][2], (_e691[0][2] > _e691[1][2]));
                                                        let _e792 = ((select(_e691[2][0], _e767, (_e767 < _e691[2][0])) - _e300) * _e303);
                                                        let _e793 = ((select(_e691[2][0], _e771, (_e771 > _e691[2][0])) - _e301) * _e303);
                                                        let _e796 = ((select(_e691[2][1], _e775, (_e775 < _e691[2][1])) - _e364) * _e367);
                                                        let _e797 = ((select(_e691[2][1], _e779, (_e779 > _e691[2][1])) - _e365) * _e367);
                                                        let _e800 = ((select(_e691[2][2], _e783, (_e783 < _e691[2][2])) - _e428) * _e431);
                                                        let _e801 = ((select(_e691[2][2], _e787, (_e787 > _e691[2][2])) - _e429) * _e431);
                                                        let _e803 = select(_e801, _e800, (_e800 < _e801));
                                                        let _e805 = select(_e801, _e800, (_e800 > _e801));
                                                        let _e807 = select(_e793, _e792, (_e792 < _e793));
                                                        let _e809 = select(_e797, _e796, (_e796 < _e797));
                                                        let _e811 = select(_e809, _e807, (_e807 > _e809));
                                                        let _e813 = select(_e803, _e811, (_e811 > _e803));
                                                        let _e815 = select(_e793, _e792, (_e792 > _e793));
                                                        let _e817 = select(_e797, _e796, (_e796 > _e797));
                                                        let _e819 = select(_e817, _e815, (_e815 < _e817));
                                                        let _e821 = select(_e805, _e819, (_e819 < _e805));
                                                        let _e822 = -(_e803);
                                                        let _e828 = select(_e533, _e813, (_e813 > _e533));
                                                        let _e832 = select(_e720, _e711, (_e711 < _e720));
                                                        let _e837 = select(_e720, _e711, (_e711 > _e720));
                                                        let _e844 = select(_e723, _e714, (_e714 < _e723));
                                                        let _e849 = select(_e723, _e714, (_e714 > _e723));
                                                        let _e858 = (((((_e749 && (_e765 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e729, _e832, (_e832 < _e729)) <= 0f) && (select(_e729, _e837, (_e837 > _e729)) >= 0f))) && ((select(_e732, _e844, (_e844 < _e732)) <= 0f) && (select(_e732, _e849, (_e849 > _e732)) >= 0f))) && (_e828 <= (_e821 + (select(_e822, _e805, (_e805 > _e822)) * 0.0000019073523f)))) && (_e828 <= _e586.member.member_1));
                                                        if _e858 {
                                                            let _e863 = (_e691[1][0] - _e691[0][0]);
                                                            let _e864 = (_e691[1][1] - _e691[0][1]);
                                                            let _e865 = (_e691[1][2] - _e691[0][2]);
                                                            let _e866 = vec3<f32>(_e863, _e864, _e865);
                                                            let _e867 = (_e691[2][0] - _e691[1][0]);
                                                            let _e868 = (_e691[2][1] - _e691[1][1]);
                                                            let _e869 = (_e691[2][2] - _e691[1][2]);
                                                            let _e870 = vec3<f32>(_e867, _e868, _e869);
                                                            let _e871 = (_e691[0][0] - _e691[2][0]);
                                                            let _e872 = (_e691[0][1] - _e691[2][1]);
                                                            let _e873 = (_e691[0][2] - _e691[2][2]);
                                                            let _e874 = vec3<f32>(_e871, _e872, _e873);
                                                            let _e875 = abs(_e863);
                                                            let _e876 = abs(_e864);
                                                            if (_e875 != _e875) {
                                                                phi_2780_ = true;
                                                            } else {
                                                                phi_2780_ = (_e876 >= _e875);
                                                            }
                                                            let _e880 = phi_2780_;
                                                            let _e881 = select(_e875, _e876, _e880);
                                                            let _e882 = abs(_e865);
                                                            if (_e881 != _e881) {
                                                                phi_2795_ = true;
                                                            } else {
                                                                phi_2795_ = (_e882 >= _e881);
                                                            }
                                                            let _e886 = phi_2795_;
                                                            let _e887 = select(_e881, _e882, _e886);
                                                            let _e888 = abs(_e867);
                                                            let _e889 = abs(_e868);
                                                            if (_e888 != _e888) {
                                                                phi_2810_ = true;
                                                            } else {
                                                                phi_2810_ = (_e889 >= _e888);
                                                            }
                                                            let _e893 = phi_2810_;
                                                            let _e894 = select(_e888, _e889, _e893);
                                                            let _e895 = abs(_e869);
                                                            if (_e894 != _e894) {
                                                                phi_2825_ = true;
                                                            } else {
                                                                phi_2825_ = (_e895 >= _e894);
                                                            }
                                                            let _e899 = phi_2825_;
                                                            let _e900 = select(_e894, _e895, _e899);
                                                            let _e901 = abs(_e871);
                                                            let _e902 = abs(_e872);
                                                            if (_e901 != _e901) {
                                                                phi_2840_ = true;
                                                            } else {
                                                                phi_2840_ = (_e902 >= _e901);
                                                            }
                                                            let _e906 = phi_2840_;
                                                            let _e907 = select(_e901, _e902, _e906);
                                                            let _e908 = abs(_e873);
                                                            if (_e907 != _e907) {
                                                                phi_2855_ = true;
                                                            } else {
                                                                phi_2855_ = (_e908 >= _e907);
                                                            }
                                                            let _e912 = phi_2855_;
                                                            let _e913 = select(_e907, _e908, _e912);
                                                            let _e915 = select(_e900, _e887, (_e887 > _e900));
                                                            let _e917 = select(_e913, _e915, (_e915 > _e913));
                                                            if (_e887 == _e917) {
                                                                phi_1765_ = _e723;
                                                                phi_1766_ = _e720;
                                                                phi_1767_ = _e714;
                                                                phi_1768_ = _e711;
                                                                phi_1769_ = vec3<f32>(_e691[0][0], _e691[0][1], _e691[0][2]);
                                                                phi_1770_ = _e874;
                                                                phi_1771_ = _e870;
                                                                phi_1772_ = _e866;
                                                            } else {
                                                                let _e919 = (_e900 == _e917);
                                                                let _e924 = vec3(_e919);
                                                                phi_1765_ = select(_e714, _e732, _e919);
                                                                phi_1766_ = select(_e711, _e729, _e919);
                                                                phi_1767_ = select(_e732, _e723, _e919);
                                                                phi_1768_ = select(_e729, _e720, _e919);
                                                                phi_1769_ = select(vec3<f32>(_e691[2][0], _e691[2][1], _e691[2][2]), vec3<f32>(_e691[1][0], _e691[1][1], _e691[1][2]), _e924);
                                                                phi_1770_ = select(_e870, _e866, _e924);
                                                                phi_1771_ = select(_e866, _e874, _e924);
                                                                phi_1772_ = select(_e874, _e870, _e924);
                                                            }
                                                            let _e930 = phi_1765_;
                                                            let _e932 = phi_1766_;
                                                            let _e934 = phi_1767_;
                                                            let _e936 = phi_1768_;
                                                            let _e938 = phi_1769_;
                                                            let _e940 = phi_1770_;
                                                            let _e942 = phi_1771_;
                                                            let _e944 = phi_1772_;
                                                            let _e951 = ((_e942.y * _e940.z) - (_e940.y * _e942.z));
                                                            let _e956 = ((_e942.z * _e940.x) - (_e940.z * _e942.x));
                                                            let _e959 = ((_e942.x * _e940.y) - (_e940.x * _e942.y));
                                                            let _e962 = ((_e755 >= _e759) && (_e755 >= _e763));
                                                            let _e963 = (_e759 >= _e763);
                                                            let _e977 = (((_e951 * (select(select(_e691[2][0], _e691[1][0], _e963), _e691[0][0], _e962) - _e262)) + (_e956 * (select(select(_e691[2][1], _e691[1][1], _e963), _e691[0][1], _e962) - _e327))) + (_e959 * (select(select(_e691[2][2], _e691[1][2], _e963), _e691[0][2], _e962) - _e391)));
                                                            let _e982 = (((_e951 * _e299) + (_e956 * _e363)) + (_e959 * _e427));
                                                            let _e983 = (_e932 - _e936);
                                                            let _e984 = (_e930 - _e934);
                                                            let _e987 = ((_e983 * _e983) + (_e984 * _e984));
                                                            let _e994 = (-(((_e936 * _e983) + (_e934 * _e984))) / select(0.000000000000000000000000000000000000011754944f, _e987, (_e987 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e996 = select(1f, _e994, (_e994 < 1f));
                                                            let _e998 = select(0f, _e996, (_e996 > 0f));
                                                            let _e1007 = ((_e938.x + (_e944.x * _e998)) - _e262);
                                                            let _e1010 = ((_e938.y + (_e944.y * _e998)) - _e327);
                                                            let _e1013 = ((_e938.z + (_e944.z * _e998)) - _e391);
                                                            let _e1016 = bitcast<f32>((bitcast<u32>(_e1007) & 2147483647u));
                                                            let _e1019 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                            let _e1021 = select(_e1019, _e1016, (_e1016 > _e1019));
                                                            let _e1024 = bitcast<f32>((bitcast<u32>(_e1013) & 2147483647u));
                                                            let _e1026 = select(_e1024, _e1021, (_e1021 > _e1024));
                                                            let _e1030 = abs(_e951);
                                                            let _e1031 = abs(_e956);
                                                            if (_e1030 != _e1030) {
                                                                phi_2870_ = true;
                                                            } else {
                                                                phi_2870_ = (_e1031 >= _e1030);
                                                            }
                                                            let _e1035 = phi_2870_;
                                                            let _e1036 = select(_e1030, _e1031, _e1035);
                                                            let _e1037 = abs(_e959);
                                                            if (_e1036 != _e1036) {
                                                                phi_2885_ = true;
                                                            } else {
                                                                phi_2885_ = (_e1037 >= _e1036);
                                                            }
                                                            let _e1041 = phi_2885_;
                                                            let _e1057 = abs(_e942.x);
                                                            let _e1058 = abs(_e942.y);
                                                            if (_e1057 != _e1057) {
                                                                phi_2900_ = true;
                                                            } else {
                                                                phi_2900_ = (_e1058 >= _e1057);
                                                            }
                                                            let _e1062 = phi_2900_;
                                                            let _e1063 = select(_e1057, _e1058, _e1062);
                                                            let _e1064 = abs(_e942.z);
                                                            if (_e1063 != _e1063) {
                                                                phi_2915_ = true;
                                                            } else {
                                                                phi_2915_ = (_e1064 >= _e1063);
                                                            }
                                                            let _e1068 = phi_2915_;
                                                            let _e1071 = abs(_e940.x);
                                                            let _e1072 = abs(_e940.y);
                                                            if (_e1071 != _e1071) {
                                                                phi_2930_ = true;
                                                            } else {
                                                                phi_2930_ = (_e1072 >= _e1071);
                                                            }
                                                            let _e1076 = phi_2930_;
                                                            let _e1077 = select(_e1071, _e1072, _e1076);
                                                            let _e1078 = abs(_e940.z);
                                                            if (_e1077 != _e1077) {
                                                                phi_2945_ = true;
                                                            } else {
                                                                phi_2945_ = (_e1078 >= _e1077);
                                                            }
                                                            let _e1082 = phi_2945_;
                                                            let _e1087 = ((bitcast<f32>((bitcast<u32>(((((_e951 * _e1007) + (_e956 * _e1010)) + (_e959 * _e1013)) - _e977)) & 2147483647u)) <= ((0.0000009536743f * select(_e917, _e1026, (_e1026 > _e917))) * select(_e1036, _e1037, _e1041))) && !((bitcast<f32>((bitcast<u32>(_e982) & 2147483647u)) <= ((0.0000038146973f * select(_e1063, _e1064, _e1068)) * select(_e1077, _e1078, _e1082)))));
                                                            let _e1088 = (_e977 / _e982);
                                                            if (_e858 && !(_e1087)) {
                                                                let _e1091 = (_e1013 / _e427);
                                                                let _e1099 = (((_e951 * (_e1007 - (_e299 * _e1091))) + (_e956 * (_e1010 - (_e363 * _e1091)))) / _e982);
                                                                phi_1980_ = select(select(_e1091, (_e1091 + _e1099), (bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u)) <= _e917)), _e1088, _e1087);
                                                            } else {
                                                                phi_1980_ = _e1088;
                                                            }
                                                            let _e1108 = phi_1980_;
                                                            let _e1110 = select(_e821, _e1108, (_e1108 < _e821));
                                                            let _e1112 = select(_e813, _e1110, (_e1110 > _e813));
                                                            let _e1113 = (1f / _e765);
                                                            phi_2000_ = type_47(_e1112, (_e759 * _e1113), (_e763 * _e1113), ((_e858 && (_e1112 >= _e533)) && (_e1112 <= _e586.member.member_1)));
                                                            phi_2001_ = type_47();
                                                        } else {
                                                            phi_2000_ = type_47();
                                                            phi_2001_ = type_47(0f, 0f, 0f, _e858);
                                                        }
                                                        let _e1122 = phi_2000_;
                                                        let _e1124 = phi_2001_;
                                                        phi_2004_ = _e1122;
                                                        phi_2005_ = _e1124;
                                                        phi_2006_ = select(true, false, _e858);
                                                    } else {
                                                        phi_2004_ = type_47();
                                                        phi_2005_ = type_47(0f, 0f, 0f, _e749);
                                                        phi_2006_ = true;
                                                    }
                                                    let _e1127 = phi_2004_;
                                                    let _e1129 = phi_2005_;
                                                    let _e1131 = phi_2006_;
                                                    if _e1131 {
                                                        phi_2010_ = _e1129;
                                                    } else {
                                                        phi_2010_ = _e1127;
                                                    }
                                                    let _e1133 = phi_2010_;
                                                    if _e1133.member_3 {
                                                        phi_2019_ = type_22(_e1133.member, _e1133.member_1, _e1133.member_2, _e621);
                                                    } else {
                                                        phi_2019_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1140 = phi_2019_;
                                                    if (_e1140.member_3 != 4294967295u) {
                                                        if (_e621 != _e539) {
                                                            if (_e1140.member < _e586.member.member.member) {
                                                                phi_2045_ = true;
                                                            } else {
                                                                if (_e1140.member == _e586.member.member.member) {
                                                                    phi_2044_ = (_e1140.member_3 < _e586.member.member.member_3);
                                                                } else {
                                                                    phi_2044_ = false;
                                                                }
                                                                let _e1155 = phi_2044_;
                                                                phi_2045_ = _e1155;
                                                            }
                                                            let _e1157 = phi_2045_;
                                                            if _e1157 {
                                                                phi_2052_ = type_49(type_43(_e1140, _e1140.member), _e613.member_1, _e613.member_2);
                                                            } else {
                                                                phi_2052_ = _e613;
                                                            }
                                                            let _e1164 = phi_2052_;
                                                            phi_2053_ = _e1164;
                                                        } else {
                                                            phi_2053_ = _e613;
                                                        }
                                                        let _e1166 = phi_2053_;
                                                        phi_2054_ = _e1166;
                                                    } else {
                                                        phi_2054_ = _e613;
                                                    }
                                                    let _e1168 = phi_2054_;
                                                    phi_1082_ = _e1168;
                                                } else {
                                                    phi_1082_ = type_49();
                                                }
                                                let _e1170 = phi_1082_;
                                                continue;
                                                continuing {
                                                    phi_1081_ = _e1170;
                                                    phi_1084_ = _e601;
                                                    phi_3028_ = _e546;
                                                    break if !(_e607);
                                                }
                                            }
                                            let _e1173 = phi_3028_;
                                            phi_3193_ = _e1173;
                                            if _e1173 {
                                                break;
                                            }
                                            phi_3228_ = _e1173;
                                            let _e1678 = local_4;
                                            phi_2055_ = _e1678;
                                        } else {
                                            phi_3228_ = _e546;
                                            phi_2055_ = _e548;
                                        }
                                        let _e1175 = phi_3228_;
                                        let _e1177 = phi_2055_;
                                        if _e579 {
                                            phi_2539_ = type_49();
                                            phi_2540_ = bool();
                                            phi_2541_ = u32();
                                            phi_2542_ = u32();
                                        } else {
                                            if (_e576 >= _e77) {
                                                phi_2120_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e576 < _e77) {
                                                } else {
                                                    phi_3193_ = true;
                                                    break;
                                                }
                                                let _e1180 = (_e215 % 3u);
                                                if (_e1180 < 3u) {
                                                } else {
                                                    phi_3193_ = true;
                                                    break;
                                                }
                                                let _e1186 = global_2.member[_e576].member[_e1180];
                                                let _e1192 = (_e214 % 3u);
                                                if (_e1192 < 3u) {
                                                } else {
                                                    phi_3193_ = true;
                                                    break;
                                                }
                                                let _e1198 = global_2.member[_e576].member[_e1192];
                                                let _e1204 = (_e216 % 3u);
                                                if (_e1204 < 3u) {
                                                } else {
                                                    phi_3193_ = true;
                                                    break;
                                                }
                                                let _e1210 = global_2.member[_e576].member[_e1204];
                                                let _e1220 = global_2.member[_e576].member_1;
                                                let _e1224 = global_2.member[_e576].member_2;
                                                phi_2120_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e1186[0], _e1186[1], _e1186[2], _e1186[3]), vec4<f32>(_e1198[0], _e1198[1], _e1198[2], _e1198[3]), vec4<f32>(_e1210[0], _e1210[1], _e1210[2], _e1210[3])), _e1220, _e1224);
                                            }
                                            let _e1227 = phi_2120_;
                                            let _e1246 = ((_e1227.member[0].x - _e300) * _e303);
                                            let _e1247 = ((_e1227.member[0].y - _e300) * _e303);
                                            let _e1248 = ((_e1227.member[0].z - _e301) * _e303);
                                            let _e1249 = ((_e1227.member[0].w - _e301) * _e303);
                                            let _e1259 = ((_e1227.member[1].x - _e364) * _e367);
                                            let _e1260 = ((_e1227.member[1].y - _e364) * _e367);
                                            let _e1261 = ((_e1227.member[1].z - _e365) * _e367);
                                            let _e1262 = ((_e1227.member[1].w - _e365) * _e367);
                                            let _e1272 = ((_e1227.member[2].x - _e428) * _e431);
                                            let _e1273 = ((_e1227.member[2].y - _e428) * _e431);
                                            let _e1274 = ((_e1227.member[2].z - _e429) * _e431);
                                            let _e1275 = ((_e1227.member[2].w - _e429) * _e431);
                                            let _e1277 = select(_e1274, _e1272, (_e1272 < _e1274));
                                            let _e1279 = select(_e1275, _e1273, (_e1273 < _e1275));
                                            let _e1281 = select(_e1274, _e1272, (_e1272 > _e1274));
                                            let _e1283 = select(_e1275, _e1273, (_e1273 > _e1275));
                                            let _e1285 = select(_e1248, _e1246, (_e1246 < _e1248));
                                            let _e1287 = select(_e1249, _e1247, (_e1247 < _e1249));
                                            let _e1289 = select(_e1261, _e1259, (_e1259 < _e1261));
                                            let _e1291 = select(_e1262, _e1260, (_e1260 < _e1262));
                                            let _e1293 = select(_e1289, _e1285, (_e1285 > _e1289));
                                            let _e1295 = select(_e1291, _e1287, (_e1287 > _e1291));
                                            let _e1297 = select(_e1277, _e1293, (_e1293 > _e1277));
                                            let _e1299 = select(_e1279, _e1295, (_e1295 > _e1279));
                                            let _e1301 = select(_e1248, _e1246, (_e1246 > _e1248));
                                            let _e1303 = select(_e1249, _e1247, (_e1247 > _e1249));
                                            let _e1305 = select(_e1261, _e1259, (_e1259 > _e1261));
                                            let _e1307 = select(_e1262, _e1260, (_e1260 > _e1262));
                                            let _e1309 = select(_e1305, _e1301, (_e1301 < _e1305));
                                            let _e1311 = select(_e1307, _e1303, (_e1303 < _e1307));
                                            let _e1316 = -(_e1277);
                                            let _e1317 = -(_e1279);
                                            let _e1324 = (select(_e1281, _e1309, (_e1309 < _e1281)) + (select(_e1316, _e1281, (_e1281 > _e1316)) * 0.0000019073523f));
                                            let _e1325 = (select(_e1283, _e1311, (_e1311 < _e1283)) + (select(_e1317, _e1283, (_e1283 > _e1317)) * 0.0000019073523f));
                                            let _e1327 = select(_e533, _e1297, (_e1297 > _e533));
                                            let _e1329 = select(_e533, _e1299, (_e1299 > _e533));
                                            let _e1334 = (_e1327 <= select(_e1177.member.member_1, _e1324, (_e1324 < _e1177.member.member_1)));
                                            let _e1335 = (_e1329 <= select(_e1177.member.member_1, _e1325, (_e1325 < _e1177.member.member_1)));
                                            let _e1336 = (_e1327 <= _e1329);
                                            if _e1334 {
                                                if _e1335 {
                                                    if _e1336 {
                                                        phi_2485_ = _e1227.member_2;
                                                    } else {
                                                        phi_2485_ = _e1227.member_1;
                                                    }
                                                    let _e1340 = phi_2485_;
                                                    let _e1342 = (_e574 % 128u);
                                                    let _e1343 = (_e1342 < 128u);
                                                    if _e1343 {
                                                    } else {
                                                        phi_3193_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1342] = _e1340;
                                                    if _e1343 {
                                                    } else {
                                                        phi_3193_ = true;
                                                        break;
                                                    }
                                                    local[_e1342] = select(_e1327, _e1329, _e1336);
                                                    if _e1336 {
                                                        phi_2512_ = _e1227.member_1;
                                                    } else {
                                                        phi_2512_ = _e1227.member_2;
                                                    }
                                                    let _e1350 = phi_2512_;
                                                    phi_2513_ = (_e574 + 1u);
                                                    phi_2514_ = _e1350;
                                                } else {
                                                    phi_2513_ = u32();
                                                    phi_2514_ = u32();
                                                }
                                                let _e1352 = phi_2513_;
                                                let _e1354 = phi_2514_;
                                                phi_2516_ = _e1352;
                                                phi_2517_ = _e1354;
                                                phi_2518_ = select(true, false, _e1335);
                                            } else {
                                                phi_2516_ = u32();
                                                phi_2517_ = u32();
                                                phi_2518_ = true;
                                            }
                                            let _e1357 = phi_2516_;
                                            let _e1359 = phi_2517_;
                                            let _e1361 = phi_2518_;
                                            if _e1361 {
                                                if _e1334 {
                                                    phi_2527_ = _e1227.member_1;
                                                } else {
                                                    phi_2527_ = _e1227.member_2;
                                                }
                                                let _e1365 = phi_2527_;
                                                phi_2532_ = select(_e1335, true, _e1334);
                                                phi_2534_ = _e1365;
                                            } else {
                                                phi_2532_ = _e572;
                                                phi_2534_ = _e1359;
                                            }
                                            let _e1368 = phi_2532_;
                                            let _e1370 = phi_2534_;
                                            phi_2539_ = type_49(_e1177.member, (_e1177.member_1 + 1u), _e1177.member_2);
                                            phi_2540_ = _e1368;
                                            phi_2541_ = select(_e1357, _e574, _e1361);
                                            phi_2542_ = _e1370;
                                        }
                                        let _e1373 = phi_2539_;
                                        let _e1375 = phi_2540_;
                                        let _e1377 = phi_2541_;
                                        let _e1379 = phi_2542_;
                                        if _e579 {
                                            phi_2550_ = _e1177;
                                        } else {
                                            phi_2550_ = _e1373;
                                        }
                                        let _e1381 = phi_2550_;
                                        phi_3196_ = _e1175;
                                        phi_2554_ = _e1381;
                                        phi_2555_ = (_e550 - 1u);
                                        phi_2556_ = select(_e1375, false, _e579);
                                        phi_2557_ = select(_e1377, _e574, _e579);
                                        phi_2558_ = select(_e1379, _e576, _e579);
                                    } else {
                                        phi_3196_ = _e546;
                                        phi_2554_ = _e548;
                                        phi_2555_ = _e550;
                                        phi_2556_ = _e572;
                                        phi_2557_ = _e574;
                                        phi_2558_ = _e576;
                                    }
                                    let _e1386 = phi_3196_;
                                    let _e1388 = phi_2554_;
                                    let _e1390 = phi_2555_;
                                    let _e1392 = phi_2556_;
                                    let _e1394 = phi_2557_;
                                    let _e1396 = phi_2558_;
                                    phi_3195_ = _e1386;
                                    phi_2559_ = _e1388;
                                    phi_2560_ = _e1390;
                                    phi_2561_ = _e1392;
                                    phi_2562_ = _e1394;
                                    phi_2563_ = _e1396;
                                } else {
                                    phi_3195_ = _e546;
                                    phi_2559_ = type_49();
                                    phi_2560_ = u32();
                                    phi_2561_ = bool();
                                    phi_2562_ = u32();
                                    phi_2563_ = u32();
                                }
                                let _e1398 = phi_3195_;
                                let _e1400 = phi_2559_;
                                let _e1402 = phi_2560_;
                                let _e1404 = phi_2561_;
                                let _e1406 = phi_2562_;
                                let _e1408 = phi_2563_;
                                phi_3194_ = _e1398;
                                phi_1013_ = _e1400;
                                phi_1016_ = _e1402;
                                phi_1018_ = _e1404;
                                phi_1020_ = _e1406;
                                phi_1022_ = _e1408;
                                phi_2564_ = _e560;
                            } else {
                                phi_3194_ = _e546;
                                phi_1013_ = type_49();
                                phi_1016_ = u32();
                                phi_1018_ = bool();
                                phi_1020_ = u32();
                                phi_1022_ = u32();
                                phi_2564_ = false;
                            }
                            let _e1410 = phi_3194_;
                            let _e1412 = phi_1013_;
                            let _e1414 = phi_1016_;
                            let _e1416 = phi_1018_;
                            let _e1418 = phi_1020_;
                            let _e1420 = phi_1022_;
                            let _e1422 = phi_2564_;
                            continue;
                            continuing {
                                phi_3034_ = _e1410;
                                phi_1012_ = _e1412;
                                phi_1015_ = _e1414;
                                phi_1017_ = _e1416;
                                phi_1019_ = _e1418;
                                phi_1021_ = _e1420;
                                phi_3193_ = _e1410;
                                break if !(_e1422);
                            }
                        }
                        let _e1425 = phi_3193_;
                        if _e1425 {
                            break;
                        }
                        let _e1427 = local_2;
                        if (_e1427.member.member.member_3 != 4294967295u) {
                            let _e1433 = bitcast<u32>(_e1427.member.member.member);
                            let _e1437 = (bitcast<i32>((_e1433 >> bitcast<u32>(23i))) & 255i);
                            let _e1438 = (_e1437 + _e217);
                            if (_e1437 == 255i) {
                                phi_2623_ = _e1427.member.member.member;
                            } else {
                                if (_e1437 > 0i) {
                                    if (_e1438 > 0i) {
                                        let _e1442 = (_e1438 < 255i);
                                        if _e1442 {
                                            phi_2602_ = bitcast<f32>((_e1433 + bitcast<u32>((_e217 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_2602_ = f32();
                                        }
                                        let _e1449 = phi_2602_;
                                        phi_2604_ = _e1449;
                                        phi_2605_ = select(true, false, _e1442);
                                    } else {
                                        phi_2604_ = f32();
                                        phi_2605_ = true;
                                    }
                                    let _e1452 = phi_2604_;
                                    let _e1454 = phi_2605_;
                                    phi_2606_ = _e1452;
                                    phi_2607_ = _e1454;
                                } else {
                                    phi_2606_ = f32();
                                    phi_2607_ = true;
                                }
                                let _e1456 = phi_2606_;
                                let _e1458 = phi_2607_;
                                if _e1458 {
                                    let _e1459 = (_e1433 & 2147483648u);
                                    let _e1466 = ((_e1433 & 8388607u) | (select(0u, 1u, ((_e1433 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1470 = (_e1466 == 0u);
                                    if _e1470 {
                                        phi_3023_ = bitcast<f32>(_e1459);
                                    } else {
                                        let _e1475 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1466)), 32u, _e1470) - 8u);
                                        let _e1478 = (_e1466 << bitcast<u32>((_e1475 & 31u)));
                                        let _e1480 = ((_e1438 + select(0i, 1i, (_e1437 == 0i))) - bitcast<i32>(_e1475));
                                        if (_e1480 >= 255i) {
                                            phi_3013_ = bitcast<f32>((_e1459 | 2139095040u));
                                            phi_3014_ = f32();
                                            phi_3015_ = true;
                                        } else {
                                            let _e1482 = (_e1480 > 0i);
                                            if _e1482 {
                                                phi_3007_ = bitcast<f32>(((_e1459 | (bitcast<u32>(_e1480) << bitcast<u32>(23i))) | (_e1478 & 8388607u)));
                                                phi_3008_ = f32();
                                            } else {
                                                if (_e1480 < -24i) {
                                                    phi_2973_ = 26u;
                                                } else {
                                                    phi_2973_ = bitcast<u32>((1i - _e1480));
                                                }
                                                let _e1487 = phi_2973_;
                                                let _e1488 = (_e1487 & 31u);
                                                let _e1490 = (_e1478 >> bitcast<u32>(_e1488));
                                                let _e1494 = (_e1478 & ((1u << bitcast<u32>(_e1488)) - 1u));
                                                let _e1498 = (1u << bitcast<u32>(((_e1487 - 1u) & 31u)));
                                                if (_e1494 > _e1498) {
                                                    phi_2994_ = true;
                                                } else {
                                                    if (_e1494 == _e1498) {
                                                        phi_2991_ = ((_e1490 & 1u) == 1u);
                                                    } else {
                                                        phi_2991_ = false;
                                                    }
                                                    let _e1504 = phi_2991_;
                                                    phi_2994_ = _e1504;
                                                }
                                                let _e1506 = phi_2994_;
                                                phi_3007_ = f32();
                                                phi_3008_ = bitcast<f32>((_e1459 | (_e1490 + select(0u, 1u, _e1506))));
                                            }
                                            let _e1519 = phi_3007_;
                                            let _e1521 = phi_3008_;
                                            phi_3013_ = _e1519;
                                            phi_3014_ = _e1521;
                                            phi_3015_ = _e1482;
                                        }
                                        let _e1525 = phi_3013_;
                                        let _e1527 = phi_3014_;
                                        let _e1529 = phi_3015_;
                                        phi_3023_ = select(_e1527, _e1525, _e1529);
                                    }
                                    let _e1533 = phi_3023_;
                                    phi_2622_ = _e1533;
                                } else {
                                    phi_2622_ = _e1456;
                                }
                                let _e1535 = phi_2622_;
                                phi_2623_ = _e1535;
                            }
                            let _e1537 = phi_2623_;
                            let _e1538 = bitcast<u32>(_e1537);
                            if ((_e1538 & 2147483647u) >= 2139095040u) {
                                phi_2635_ = bitcast<f32>(((_e1538 & 2147483648u) | 2139095039u));
                            } else {
                                phi_2635_ = _e1537;
                            }
                            let _e1545 = phi_2635_;
                            phi_2640_ = type_22(_e1545, _e1427.member.member.member_1, _e1427.member.member.member_2, _e1427.member.member.member_3);
                        } else {
                            phi_2640_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1550 = phi_2640_;
                        if _e93 {
                        } else {
                            break;
                        }
                        global_4.member[_e91] = _e1550;
                        let _e1554 = local_3;
                        if _e94 {
                        } else {
                            break;
                        }
                        global_5.member[_e91] = _e1554.member_1;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e1559 = select(0u, 1u, (_e161 <= _e171));
                        if (_e1559 > 0u) {
                            let _e1561 = (1u < _e87);
                            if _e1561 {
                                if (0u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1565 = atomicAdd((&global_6.member[0u]), _e1559);
                                if ((_e1565 + _e1559) < _e1565) {
                                    if _e1561 {
                                    } else {
                                        break;
                                    }
                                    let _e1570 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1573 = select(0u, 1u, (_e1550.member_3 != 4294967295u));
                        if (_e1573 > 0u) {
                            let _e1575 = (3u < _e87);
                            if _e1575 {
                                if (2u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1579 = atomicAdd((&global_6.member[2u]), _e1573);
                                if ((_e1579 + _e1573) < _e1579) {
                                    if _e1575 {
                                    } else {
                                        break;
                                    }
                                    let _e1584 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1554.member_1 > 0u) {
                            let _e1586 = (5u < _e87);
                            if _e1586 {
                                if (4u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1590 = atomicAdd((&global_6.member[4u]), _e1554.member_1);
                                if ((_e1590 + _e1554.member_1) < _e1590) {
                                    if _e1586 {
                                    } else {
                                        break;
                                    }
                                    let _e1595 = atomicAdd((&global_6.member[5u]), 1u);
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
