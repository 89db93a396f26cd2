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
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_43,
    member_1: u32,
    member_2: u32,
}

struct type_52 {
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
var<storage, read_write> global_6: type_52;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_375_: i32;
    var phi_376_: i32;
    var phi_386_: bool;
    var phi_396_: u32;
    var phi_397_: u32;
    var phi_399_: bool;
    var phi_404_: u32;
    var phi_437_: i32;
    var phi_455_: f32;
    var phi_461_: f32;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_559_: f32;
    var phi_571_: f32;
    var phi_580_: f32;
    var phi_586_: f32;
    var phi_626_: f32;
    var phi_632_: f32;
    var phi_684_: f32;
    var phi_696_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_751_: f32;
    var phi_757_: f32;
    var phi_809_: f32;
    var phi_821_: f32;
    var phi_876_: i32;
    var phi_898_: u32;
    var phi_899_: u32;
    var phi_936_: i32;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_2931_: bool;
    var phi_992_: type_48;
    var phi_995_: bool;
    var phi_997_: u32;
    var phi_999_: u32;
    var phi_1001_: u32;
    var phi_1012_: bool;
    var phi_1044_: bool;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_2207_: type_47;
    var phi_2572_: u32;
    var phi_2600_: u32;
    var phi_2601_: u32;
    var phi_2602_: u32;
    var phi_2604_: u32;
    var phi_2605_: u32;
    var phi_2606_: bool;
    var phi_2615_: u32;
    var phi_2620_: bool;
    var phi_2622_: u32;
    var phi_1061_: type_48;
    var phi_1064_: type_7;
    var phi_1065_: type_7;
    var phi_1087_: type_7;
    var phi_1111_: u32;
    var phi_1203_: array<array<f32, 3>, 3>;
    var phi_1355_: bool;
    var phi_1384_: bool;
    var phi_1803_: f32;
    var phi_1804_: f32;
    var phi_1805_: f32;
    var phi_1806_: f32;
    var phi_1807_: vec3<f32>;
    var phi_1808_: vec3<f32>;
    var phi_1809_: vec3<f32>;
    var phi_1810_: vec3<f32>;
    var phi_1847_: bool;
    var phi_1856_: vec3<f32>;
    var phi_2021_: f32;
    var phi_2023_: f32;
    var phi_2024_: bool;
    var phi_2044_: f32;
    var phi_2045_: f32;
    var phi_2068_: type_22;
    var phi_2070_: type_22;
    var phi_2071_: bool;
    var phi_2075_: type_22;
    var phi_2076_: type_22;
    var phi_2077_: type_22;
    var phi_2078_: bool;
    var phi_2082_: type_22;
    var phi_2083_: bool;
    var phi_2084_: type_22;
    var phi_2085_: bool;
    var phi_2086_: bool;
    var phi_2087_: type_22;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2097_: type_22;
    var phi_2098_: bool;
    var phi_2102_: type_22;
    var phi_2127_: bool;
    var phi_2128_: bool;
    var phi_2135_: type_48;
    var phi_2136_: type_48;
    var phi_2137_: type_48;
    var phi_1062_: type_48;
    var phi_2925_: bool;
    var phi_3089_: bool;
    var phi_2627_: type_48;
    var phi_2628_: bool;
    var phi_2629_: u32;
    var phi_2630_: u32;
    var phi_3088_: bool;
    var phi_2631_: type_48;
    var phi_2632_: bool;
    var phi_2633_: u32;
    var phi_2634_: u32;
    var phi_2635_: u32;
    var phi_3087_: bool;
    var phi_2636_: type_48;
    var phi_2637_: bool;
    var phi_2638_: u32;
    var phi_2639_: u32;
    var phi_2640_: u32;
    var phi_3086_: bool;
    var phi_993_: type_48;
    var phi_996_: bool;
    var phi_998_: u32;
    var phi_1000_: u32;
    var phi_1002_: u32;
    var phi_2641_: bool;
    var phi_3085_: bool;
    var local_2: type_48;
    var phi_2679_: f32;
    var phi_2681_: f32;
    var phi_2682_: bool;
    var phi_2683_: f32;
    var phi_2684_: bool;
    var phi_2870_: u32;
    var phi_2888_: bool;
    var phi_2891_: bool;
    var phi_2904_: f32;
    var phi_2905_: f32;
    var phi_2910_: f32;
    var phi_2911_: f32;
    var phi_2912_: bool;
    var phi_2920_: f32;
    var phi_2699_: f32;
    var phi_2700_: f32;
    var phi_2712_: f32;
    var phi_2717_: type_22;
    var local_3: type_48;
    var local_4: type_48;

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
                                phi_375_ = (bitcast<i32>((_e180 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_375_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                            }
                            let _e194 = phi_375_;
                            phi_376_ = _e194;
                        } else {
                            phi_376_ = 0i;
                        }
                        let _e196 = phi_376_;
                        let _e197 = (_e106 == _e150);
                        if _e197 {
                            phi_386_ = true;
                        } else {
                            phi_386_ = (_e114 == _e150);
                        }
                        let _e200 = phi_386_;
                        let _e201 = select(1u, 0u, _e197);
                        if _e200 {
                            let _e202 = (_e201 + 1u);
                            phi_396_ = _e202;
                            phi_397_ = _e202;
                            phi_399_ = select(true, false, (_e202 == 2u));
                        } else {
                            phi_396_ = u32();
                            phi_397_ = 0u;
                            phi_399_ = true;
                        }
                        let _e206 = phi_396_;
                        let _e208 = phi_397_;
                        let _e210 = phi_399_;
                        if _e210 {
                            phi_404_ = (_e208 + 1u);
                        } else {
                            phi_404_ = 0u;
                        }
                        let _e214 = phi_404_;
                        let _e215 = select(_e206, _e208, _e210);
                        let _e216 = select(_e201, select(2u, _e201, _e200), _e210);
                        let _e217 = -(_e196);
                        if (_e217 < -126i) {
                            phi_437_ = -126i;
                        } else {
                            phi_437_ = select(_e217, 127i, (_e217 > 127i));
                        }
                        let _e222 = phi_437_;
                        let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                        let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                        let _e238 = global_3.member[_e91].member.member;
                        let _e239 = (_e215 == 0u);
                        if _e239 {
                            phi_455_ = _e238[0];
                        } else {
                            phi_455_ = _e238[1];
                        }
                        let _e243 = phi_455_;
                        let _e244 = (_e215 == 2u);
                        if _e244 {
                            phi_461_ = _e238[2];
                        } else {
                            phi_461_ = _e243;
                        }
                        let _e247 = phi_461_;
                        let _e248 = bitcast<u32>(_e247);
                        let _e250 = ((_e248 & 2139095040u) != 0u);
                        let _e262 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * select(0.00000011920929f, 1f, _e250));
                        let _e263 = global_3.member[_e91].member.member_2;
                        if _e239 {
                            phi_501_ = _e263[0];
                        } else {
                            phi_501_ = _e263[1];
                        }
                        let _e267 = phi_501_;
                        if _e244 {
                            phi_507_ = _e263[2];
                        } else {
                            phi_507_ = _e267;
                        }
                        let _e270 = phi_507_;
                        let _e271 = bitcast<u32>(_e270);
                        let _e273 = ((_e271 & 2139095040u) != 0u);
                        let _e287 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e271 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e271 & 2147483648u))), _e270, _e273) * _e227) * select(0.00000011920929f, 1f, _e273)) * _e233);
                        let _e291 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e291 {
                            let _e295 = (bitcast<f32>((bitcast<u32>(_e262) & 2147483647u)) * 0.00000011920929f);
                            phi_559_ = select(0.00000000000011368684f, _e295, (_e295 > 0.00000000000011368684f));
                        } else {
                            phi_559_ = 0f;
                        }
                        let _e299 = phi_559_;
                        let _e300 = (_e262 + _e299);
                        let _e301 = (_e262 - _e299);
                        let _e302 = select(_e287, 0f, _e291);
                        if _e291 {
                            phi_571_ = 38685626000000000000000000f;
                        } else {
                            phi_571_ = (1f / _e287);
                        }
                        let _e305 = phi_571_;
                        let _e306 = (_e214 == 0u);
                        if _e306 {
                            phi_580_ = _e238[0];
                        } else {
                            phi_580_ = _e238[1];
                        }
                        let _e310 = phi_580_;
                        let _e311 = (_e214 == 2u);
                        if _e311 {
                            phi_586_ = _e238[2];
                        } else {
                            phi_586_ = _e310;
                        }
                        let _e314 = phi_586_;
                        let _e315 = bitcast<u32>(_e314);
                        let _e317 = ((_e315 & 2139095040u) != 0u);
                        let _e329 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * select(0.00000011920929f, 1f, _e317));
                        if _e306 {
                            phi_626_ = _e263[0];
                        } else {
                            phi_626_ = _e263[1];
                        }
                        let _e333 = phi_626_;
                        if _e311 {
                            phi_632_ = _e263[2];
                        } else {
                            phi_632_ = _e333;
                        }
                        let _e336 = phi_632_;
                        let _e337 = bitcast<u32>(_e336);
                        let _e339 = ((_e337 & 2139095040u) != 0u);
                        let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e227) * select(0.00000011920929f, 1f, _e339)) * _e233);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                            phi_684_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_684_ = 0f;
                        }
                        let _e365 = phi_684_;
                        let _e366 = (_e329 + _e365);
                        let _e367 = (_e329 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_696_ = 38685626000000000000000000f;
                        } else {
                            phi_696_ = (1f / _e353);
                        }
                        let _e371 = phi_696_;
                        let _e372 = (_e216 == 0u);
                        if _e372 {
                            phi_705_ = _e238[0];
                        } else {
                            phi_705_ = _e238[1];
                        }
                        let _e376 = phi_705_;
                        let _e377 = (_e216 == 2u);
                        if _e377 {
                            phi_711_ = _e238[2];
                        } else {
                            phi_711_ = _e376;
                        }
                        let _e380 = phi_711_;
                        let _e381 = bitcast<u32>(_e380);
                        let _e383 = ((_e381 & 2139095040u) != 0u);
                        let _e395 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * select(0.00000011920929f, 1f, _e383));
                        if _e372 {
                            phi_751_ = _e263[0];
                        } else {
                            phi_751_ = _e263[1];
                        }
                        let _e399 = phi_751_;
                        if _e377 {
                            phi_757_ = _e263[2];
                        } else {
                            phi_757_ = _e399;
                        }
                        let _e402 = phi_757_;
                        let _e403 = bitcast<u32>(_e402);
                        let _e405 = ((_e403 & 2139095040u) != 0u);
                        let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e227) * select(0.00000011920929f, 1f, _e405)) * _e233);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                            phi_809_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_809_ = 0f;
                        }
                        let _e431 = phi_809_;
                        let _e432 = (_e395 + _e431);
                        let _e433 = (_e395 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_821_ = 38685626000000000000000000f;
                        } else {
                            phi_821_ = (1f / _e419);
                        }
                        let _e437 = phi_821_;
                        let _e440 = bitcast<f32>((bitcast<u32>(_e262) & 2147483647u));
                        let _e443 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                        let _e445 = select(_e443, _e440, (_e440 > _e443));
                        let _e448 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                        if (_e177 && (select(_e448, _e445, (_e445 > _e448)) <= 1099511600000f)) {
                            let _e460 = ((_e163 & 8388607u) | (select(0u, 1u, ((_e163 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e463 = bitcast<i32>((_e163 >> bitcast<u32>(23i)));
                            let _e467 = (_e460 == 0u);
                            let _e470 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, _e467)) - 8i);
                            if (_e463 == 255i) {
                                phi_876_ = 255i;
                            } else {
                                phi_876_ = (((_e463 + select(0i, 1i, (_e463 == 0i))) - _e470) + _e196);
                            }
                            let _e478 = phi_876_;
                            let _e488 = (_e478 <= 0i);
                            if _e488 {
                                phi_899_ = u32();
                            } else {
                                if _e467 {
                                    phi_898_ = u32();
                                } else {
                                    phi_898_ = select(((bitcast<u32>(_e478) << bitcast<u32>(23i)) | ((_e460 << bitcast<u32>(((_e470 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e478 >= 255i));
                                }
                                let _e492 = phi_898_;
                                phi_899_ = _e492;
                            }
                            let _e494 = phi_899_;
                            let _e506 = ((_e173 & 8388607u) | (select(0u, 1u, ((_e173 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e509 = bitcast<i32>((_e173 >> bitcast<u32>(23i)));
                            let _e513 = (_e506 == 0u);
                            let _e516 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, _e513)) - 8i);
                            if (_e509 == 255i) {
                                phi_936_ = 255i;
                            } else {
                                phi_936_ = (((_e509 + select(0i, 1i, (_e509 == 0i))) - _e516) + _e196);
                            }
                            let _e524 = phi_936_;
                            let _e534 = (_e524 <= 0i);
                            if _e534 {
                                phi_959_ = u32();
                            } else {
                                if _e513 {
                                    phi_958_ = u32();
                                } else {
                                    phi_958_ = select(((bitcast<u32>(_e524) << bitcast<u32>(23i)) | ((_e506 << bitcast<u32>(((_e516 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e524 >= 255i));
                                }
                                let _e538 = phi_958_;
                                phi_959_ = _e538;
                            }
                            let _e540 = phi_959_;
                            phi_967_ = bitcast<f32>(((_e172 & 2147483648u) | select(_e540, 0u, select(_e513, true, _e534))));
                            phi_968_ = bitcast<f32>(((_e162 & 2147483648u) | select(_e494, 0u, select(_e467, true, _e488))));
                        } else {
                            phi_967_ = 0f;
                            phi_968_ = 1f;
                        }
                        let _e546 = phi_967_;
                        let _e548 = phi_968_;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e554 = global_3.member[_e91].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2931_ = false;
                        phi_992_ = type_48(type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e546), 0u, 0u);
                        phi_995_ = (_e548 <= _e546);
                        phi_997_ = ((3u * _e77) + 1u);
                        phi_999_ = 0u;
                        phi_1001_ = select(0u, 2147483648u, (_e77 == 0u));
                        loop {
                            let _e561 = phi_2931_;
                            let _e563 = phi_992_;
                            let _e565 = phi_995_;
                            let _e567 = phi_997_;
                            let _e569 = phi_999_;
                            let _e571 = phi_1001_;
                            local_2 = _e563;
                            local_3 = _e563;
                            if _e565 {
                                phi_1012_ = true;
                            } else {
                                phi_1012_ = (_e569 > 0u);
                            }
                            let _e574 = phi_1012_;
                            if _e574 {
                                let _e575 = (_e567 > 0u);
                                if _e575 {
                                    if _e565 {
                                        phi_1044_ = _e565;
                                        phi_1045_ = _e569;
                                        phi_1046_ = _e571;
                                    } else {
                                        let _e576 = (_e569 - 1u);
                                        let _e577 = (_e576 % 128u);
                                        let _e578 = (_e577 < 128u);
                                        if _e578 {
                                        } else {
                                            phi_3085_ = true;
                                            break;
                                        }
                                        let _e580 = local_1[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3085_ = true;
                                            break;
                                        }
                                        let _e582 = local[_e577];
                                        phi_1044_ = (_e582 <= _e563.member.member_1);
                                        phi_1045_ = _e576;
                                        phi_1046_ = _e580;
                                    }
                                    let _e587 = phi_1044_;
                                    let _e589 = phi_1045_;
                                    let _e591 = phi_1046_;
                                    if _e587 {
                                        if ((_e591 & 2147483648u) != 0u) {
                                            phi_1061_ = _e563;
                                            phi_1064_ = type_7(0u, ((_e591 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e796 = phi_1061_;
                                                let _e798 = phi_1064_;
                                                local_4 = _e796;
                                                if (_e798.member < _e798.member_1) {
                                                    phi_1065_ = type_7((_e798.member + 1u), _e798.member_1);
                                                    phi_1087_ = type_7(1u, _e798.member);
                                                } else {
                                                    phi_1065_ = _e798;
                                                    phi_1087_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e811 = phi_1065_;
                                                let _e813 = phi_1087_;
                                                let _e817 = (bitcast<i32>(_e813.member) != 0i);
                                                if _e817 {
                                                    let _e823 = type_48(_e796.member, _e796.member_1, (_e796.member_2 + 1u));
                                                    let _e824 = ((_e591 & 268435455u) + _e813.member_1);
                                                    let _e825 = (_e824 < _e79);
                                                    if _e825 {
                                                        if _e825 {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e829 = global_1.member[_e824].member_1;
                                                        phi_1111_ = _e829;
                                                    } else {
                                                        phi_1111_ = 4294967295u;
                                                    }
                                                    let _e831 = phi_1111_;
                                                    if (_e824 >= _e79) {
                                                        phi_1203_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e825 {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e833 = (_e215 % 3u);
                                                        let _e834 = (_e214 % 3u);
                                                        let _e835 = (_e216 % 3u);
                                                        if (_e833 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e841 = global_1.member[_e824].member[_e833];
                                                        if (_e834 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e847 = global_1.member[_e824].member[_e834];
                                                        if (_e835 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e853 = global_1.member[_e824].member[_e835];
                                                        let _e855 = (3u + _e833);
                                                        if (_e855 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e861 = global_1.member[_e824].member[_e855];
                                                        let _e862 = (3u + _e834);
                                                        if (_e862 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e868 = global_1.member[_e824].member[_e862];
                                                        let _e869 = (3u + _e835);
                                                        if (_e869 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e875 = global_1.member[_e824].member[_e869];
                                                        let _e877 = (6u + _e833);
                                                        if (_e877 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e883 = global_1.member[_e824].member[_e877];
                                                        let _e884 = (6u + _e834);
                                                        if (_e884 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e890 = global_1.member[_e824].member[_e884];
                                                        let _e891 = (6u + _e835);
                                                        if (_e891 < 9u) {
                                                        } else {
                                                            phi_2925_ = true;
                                                            break;
                                                        }
                                                        let _e897 = global_1.member[_e824].member[_e891];
                                                        phi_1203_ = array<array<f32, 3>, 3>(array<f32, 3>(_e841, _e847, _e853), array<f32, 3>(_e861, _e868, _e875), array<f32, 3>(_e883, _e890, _e897));
                                                    }
                                                    let _e901 = phi_1203_;
                                                    let _e910 = (_e901[0][2] - _e395);
                                                    let _e913 = (((_e901[0][0] - _e262) * _e434) - (_e910 * _e302));
                                                    let _e916 = (((_e901[0][1] - _e329) * _e434) - (_e910 * _e368));
                                                    let _e923 = (_e901[1][2] - _e395);
                                                    let _e926 = (((_e901[1][0] - _e262) * _e434) - (_e923 * _e302));
                                                    let _e929 = (((_e901[1][1] - _e329) * _e434) - (_e923 * _e368));
                                                    let _e936 = (_e901[2][2] - _e395);
                                                    let _e939 = (((_e901[2][0] - _e262) * _e434) - (_e936 * _e302));
                                                    let _e942 = (((_e901[2][1] - _e329) * _e434) - (_e936 * _e368));
                                                    let _e943 = (_e939 * _e929);
                                                    let _e944 = (_e942 * _e926);
                                                    let _e945 = (_e913 * _e942);
                                                    let _e946 = (_e916 * _e939);
                                                    let _e947 = (_e926 * _e916);
                                                    let _e948 = (_e929 * _e913);
                                                    let _e953 = (((_e943 >= _e944) && (_e945 >= _e946)) && (_e947 >= _e948));
                                                    if (_e953 || (((_e943 <= _e944) && (_e945 <= _e946)) && (_e947 <= _e948))) {
                                                        let _e960 = select(-1f, 1f, _e953);
                                                        let _e962 = ((_e943 - _e944) * _e960);
                                                        let _e964 = select(0f, _e962, (_e962 > 0f));
                                                        let _e966 = ((_e945 - _e946) * _e960);
                                                        let _e968 = select(0f, _e966, (_e966 > 0f));
                                                        let _e970 = ((_e947 - _e948) * _e960);
                                                        let _e972 = select(0f, _e970, (_e970 > 0f));
                                                        let _e974 = ((_e964 + _e968) + _e972);
                                                        if (_e974 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2087_ = type_22();
                                                            phi_2088_ = true;
                                                            phi_2089_ = false;
                                                        } else {
                                                            let _e977 = select(_e926, _e913, (_e913 < _e926));
                                                            if (select(_e939, _e977, (_e977 < _e939)) > 0f) {
                                                                phi_1355_ = true;
                                                            } else {
                                                                let _e982 = select(_e926, _e913, (_e913 > _e926));
                                                                phi_1355_ = (select(_e939, _e982, (_e982 > _e939)) < 0f);
                                                            }
                                                            let _e987 = phi_1355_;
                                                            if _e987 {
                                                                phi_2084_ = type_22();
                                                                phi_2085_ = true;
                                                                phi_2086_ = false;
                                                            } else {
                                                                let _e989 = select(_e929, _e916, (_e916 < _e929));
                                                                if (select(_e942, _e989, (_e989 < _e942)) > 0f) {
                                                                    phi_1384_ = true;
                                                                } else {
                                                                    let _e994 = select(_e929, _e916, (_e916 > _e929));
                                                                    phi_1384_ = (select(_e942, _e994, (_e994 > _e942)) < 0f);
                                                                }
                                                                let _e999 = phi_1384_;
                                                                if _e999 {
                                                                    phi_2082_ = type_22();
                                                                    phi_2083_ = false;
                                                                } else {
                                                                    let _e1001 = select(_e901[1][0], _e901[0][0], (_e901[0][0] < _e901[1][0]));
                                                                    let _e1005 = select(_e901[1][0], _e901[0][0], (_e901[0][0] > _e901[1][0]));
                                                                    let _e1009 = select(_e901[1][1], _e901[0][1], (_e901[0][1] < _e901[1][1]));
                                                                    let _e1013 = select(_e901[1][1], _e901[0][1], (_e901[0][1] > _e901[1][1]));
                                                                    let _e1017 = select(_e901[1][2], _e901[0][2], (_e901[0][2] < _e901[1][2]));
                                                                    let _e1021 = select(_e901[1][2], _e901[0][2], (_e901[0][2] > _e901[1][2]));
                                                                    let _e1026 = ((select(_e901[2][0], _e1001, (_e1001 < _e901[2][0])) - _e300) * _e305);
                                                                    let _e1027 = ((select(_e901[2][0], _e1005, (_e1005 > _e901[2][0])) - _e301) * _e305);
                                                                    let _e1030 = ((select(_e901[2][1], _e1009, (_e1009 < _e901[2][1])) - _e366) * _e371);
                                                                    let _e1031 = ((select(_e901[2][1], _e1013, (_e1013 > _e901[2][1])) - _e367) * _e371);
                                                                    let _e1034 = ((select(_e901[2][2], _e1017, (_e1017 < _e901[2][2])) - _e432) * _e437);
                                                                    let _e1035 = ((select(_e901[2][2], _e1021, (_e1021 > _e901[2][2])) - _e433) * _e437);
                                                                    let _e1037 = select(_e1035, _e1034, (_e1034 < _e1035));
                                                                    let _e1039 = select(_e1035, _e1034, (_e1034 > _e1035));
                                                                    let _e1041 = select(_e1027, _e1026, (_e1026 < _e1027));
                                                                    let _e1043 = select(_e1031, _e1030, (_e1030 < _e1031));
                                                                    let _e1045 = select(_e1043, _e1041, (_e1041 > _e1043));
                                                                    let _e1047 = select(_e1037, _e1045, (_e1045 > _e1037));
                                                                    let _e1049 = select(_e1027, _e1026, (_e1026 > _e1027));
                                                                    let _e1051 = select(_e1031, _e1030, (_e1030 > _e1031));
                                                                    let _e1053 = select(_e1051, _e1049, (_e1049 < _e1051));
                                                                    let _e1055 = select(_e1039, _e1053, (_e1053 < _e1039));
                                                                    let _e1056 = -(_e1037);
                                                                    let _e1062 = select(_e548, _e1047, (_e1047 > _e548));
                                                                    if (_e1062 > (_e1055 + (select(_e1056, _e1039, (_e1039 > _e1056)) * 0.0000019073523f))) {
                                                                        phi_2077_ = type_22();
                                                                        phi_2078_ = true;
                                                                    } else {
                                                                        let _e1064 = (_e1062 > _e796.member.member_1);
                                                                        if _e1064 {
                                                                            phi_2076_ = type_22();
                                                                        } else {
                                                                            let _e1065 = vec3<f32>(_e901[0][0], _e901[0][1], _e901[0][2]);
                                                                            let _e1066 = vec3<f32>(_e901[1][0], _e901[1][1], _e901[1][2]);
                                                                            let _e1067 = vec3<f32>(_e901[2][0], _e901[2][1], _e901[2][2]);
                                                                            let _e1068 = (_e901[1][0] - _e901[0][0]);
                                                                            let _e1069 = (_e901[1][1] - _e901[0][1]);
                                                                            let _e1070 = (_e901[1][2] - _e901[0][2]);
                                                                            let _e1071 = vec3<f32>(_e1068, _e1069, _e1070);
                                                                            let _e1072 = (_e901[2][0] - _e901[1][0]);
                                                                            let _e1073 = (_e901[2][1] - _e901[1][1]);
                                                                            let _e1074 = (_e901[2][2] - _e901[1][2]);
                                                                            let _e1075 = vec3<f32>(_e1072, _e1073, _e1074);
                                                                            let _e1076 = (_e901[0][0] - _e901[2][0]);
                                                                            let _e1077 = (_e901[0][1] - _e901[2][1]);
                                                                            let _e1078 = (_e901[0][2] - _e901[2][2]);
                                                                            let _e1079 = vec3<f32>(_e1076, _e1077, _e1078);
                                                                            let _e1082 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e1069) & 2147483647u));
                                                                            let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                                                                            let _e1090 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                            let _e1092 = select(_e1090, _e1087, (_e1087 > _e1090));
                                                                            let _e1095 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                            let _e1098 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                            let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                            let _e1103 = bitcast<f32>((bitcast<u32>(_e1074) & 2147483647u));
                                                                            let _e1105 = select(_e1103, _e1100, (_e1100 > _e1103));
                                                                            let _e1108 = bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u));
                                                                            let _e1111 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                                            let _e1113 = select(_e1111, _e1108, (_e1108 > _e1111));
                                                                            let _e1116 = bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u));
                                                                            let _e1118 = select(_e1116, _e1113, (_e1113 > _e1116));
                                                                            let _e1120 = select(_e1105, _e1092, (_e1092 > _e1105));
                                                                            let _e1122 = select(_e1118, _e1120, (_e1120 > _e1118));
                                                                            if (_e1092 == _e1122) {
                                                                                phi_1803_ = _e929;
                                                                                phi_1804_ = _e926;
                                                                                phi_1805_ = _e916;
                                                                                phi_1806_ = _e913;
                                                                                phi_1807_ = _e1065;
                                                                                phi_1808_ = _e1079;
                                                                                phi_1809_ = _e1075;
                                                                                phi_1810_ = _e1071;
                                                                            } else {
                                                                                let _e1124 = (_e1105 == _e1122);
                                                                                let _e1129 = vec3(_e1124);
                                                                                phi_1803_ = select(_e916, _e942, _e1124);
                                                                                phi_1804_ = select(_e913, _e939, _e1124);
                                                                                phi_1805_ = select(_e942, _e929, _e1124);
                                                                                phi_1806_ = select(_e939, _e926, _e1124);
                                                                                phi_1807_ = select(_e1067, _e1066, _e1129);
                                                                                phi_1808_ = select(_e1075, _e1071, _e1129);
                                                                                phi_1809_ = select(_e1071, _e1079, _e1129);
                                                                                phi_1810_ = select(_e1079, _e1075, _e1129);
                                                                            }
                                                                            let _e1135 = phi_1803_;
                                                                            let _e1137 = phi_1804_;
                                                                            let _e1139 = phi_1805_;
                                                                            let _e1141 = phi_1806_;
                                                                            let _e1143 = phi_1807_;
                                                                            let _e1145 = phi_1808_;
                                                                            let _e1147 = phi_1809_;
                                                                            let _e1149 = phi_1810_;
                                                                            let _e1156 = ((_e1147.y * _e1145.z) - (_e1145.y * _e1147.z));
                                                                            let _e1161 = ((_e1147.z * _e1145.x) - (_e1145.z * _e1147.x));
                                                                            let _e1164 = ((_e1147.x * _e1145.y) - (_e1145.x * _e1147.y));
                                                                            if (_e964 >= _e968) {
                                                                                phi_1847_ = select(true, false, (_e964 >= _e972));
                                                                            } else {
                                                                                phi_1847_ = true;
                                                                            }
                                                                            let _e1169 = phi_1847_;
                                                                            if _e1169 {
                                                                                phi_1856_ = select(_e1067, _e1066, vec3((_e968 >= _e972)));
                                                                            } else {
                                                                                phi_1856_ = _e1065;
                                                                            }
                                                                            let _e1174 = phi_1856_;
                                                                            let _e1185 = (((_e1156 * (_e1174.x - _e262)) + (_e1161 * (_e1174.y - _e329))) + (_e1164 * (_e1174.z - _e395)));
                                                                            let _e1190 = (((_e1156 * _e302) + (_e1161 * _e368)) + (_e1164 * _e434));
                                                                            let _e1191 = (_e1137 - _e1141);
                                                                            let _e1192 = (_e1135 - _e1139);
                                                                            let _e1200 = (-(((_e1141 * _e1191) + (_e1139 * _e1192))) / ((_e1191 * _e1191) + (_e1192 * _e1192)));
                                                                            let _e1202 = select(1f, _e1200, (_e1200 < 1f));
                                                                            let _e1204 = select(0f, _e1202, (_e1202 > 0f));
                                                                            let _e1217 = ((_e1143.x + (_e1149.x * _e1204)) - _e262);
                                                                            let _e1218 = ((_e1143.y + (_e1149.y * _e1204)) - _e329);
                                                                            let _e1219 = ((_e1143.z + (_e1149.z * _e1204)) - _e395);
                                                                            let _e1220 = (_e1219 / _e434);
                                                                            let _e1232 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                            let _e1235 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                            let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                            let _e1240 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                            let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                            let _e1248 = bitcast<f32>((bitcast<u32>(_e1156) & 2147483647u));
                                                                            let _e1251 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
                                                                            let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                            let _e1256 = bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1156 * _e1217) + (_e1161 * _e1218)) + (_e1164 * _e1219)) - _e1185)) & 2147483647u)) <= ((0.0000009536743f * select(_e1122, _e1242, (_e1242 > _e1122))) * select(_e1256, _e1253, (_e1253 > _e1256)))) {
                                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1147.x) & 2147483647u));
                                                                                let _e1269 = bitcast<f32>((bitcast<u32>(_e1147.y) & 2147483647u));
                                                                                let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1147.z) & 2147483647u));
                                                                                let _e1280 = bitcast<f32>((bitcast<u32>(_e1145.x) & 2147483647u));
                                                                                let _e1283 = bitcast<f32>((bitcast<u32>(_e1145.y) & 2147483647u));
                                                                                let _e1285 = select(_e1283, _e1280, (_e1280 > _e1283));
                                                                                let _e1288 = bitcast<f32>((bitcast<u32>(_e1145.z) & 2147483647u));
                                                                                let _e1292 = (bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u)) > ((0.0000038146973f * select(_e1274, _e1271, (_e1271 > _e1274))) * select(_e1288, _e1285, (_e1285 > _e1288))));
                                                                                if _e1292 {
                                                                                    phi_2021_ = (_e1185 / _e1190);
                                                                                } else {
                                                                                    phi_2021_ = f32();
                                                                                }
                                                                                let _e1295 = phi_2021_;
                                                                                phi_2023_ = _e1295;
                                                                                phi_2024_ = select(true, false, _e1292);
                                                                            } else {
                                                                                phi_2023_ = f32();
                                                                                phi_2024_ = true;
                                                                            }
                                                                            let _e1298 = phi_2023_;
                                                                            let _e1300 = phi_2024_;
                                                                            if _e1300 {
                                                                                let _e1308 = (((_e1156 * (_e1217 - (_e302 * _e1220))) + (_e1161 * (_e1218 - (_e368 * _e1220)))) / _e1190);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u)) <= _e1122) {
                                                                                    phi_2044_ = (_e1220 + _e1308);
                                                                                } else {
                                                                                    phi_2044_ = _e1220;
                                                                                }
                                                                                let _e1315 = phi_2044_;
                                                                                phi_2045_ = _e1315;
                                                                            } else {
                                                                                phi_2045_ = _e1298;
                                                                            }
                                                                            let _e1317 = phi_2045_;
                                                                            let _e1319 = select(_e1055, _e1317, (_e1317 < _e1055));
                                                                            let _e1321 = select(_e1047, _e1319, (_e1319 > _e1047));
                                                                            if (_e1321 >= _e548) {
                                                                                let _e1323 = (_e1321 <= _e796.member.member_1);
                                                                                if _e1323 {
                                                                                    let _e1324 = (1f / _e974);
                                                                                    phi_2068_ = type_22(_e1321, (_e968 * _e1324), (_e972 * _e1324), _e831);
                                                                                } else {
                                                                                    phi_2068_ = type_22();
                                                                                }
                                                                                let _e1329 = phi_2068_;
                                                                                phi_2070_ = _e1329;
                                                                                phi_2071_ = select(true, false, _e1323);
                                                                            } else {
                                                                                phi_2070_ = type_22();
                                                                                phi_2071_ = true;
                                                                            }
                                                                            let _e1332 = phi_2070_;
                                                                            let _e1334 = phi_2071_;
                                                                            if _e1334 {
                                                                                phi_2075_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2075_ = _e1332;
                                                                            }
                                                                            let _e1336 = phi_2075_;
                                                                            phi_2076_ = _e1336;
                                                                        }
                                                                        let _e1338 = phi_2076_;
                                                                        phi_2077_ = _e1338;
                                                                        phi_2078_ = _e1064;
                                                                    }
                                                                    let _e1340 = phi_2077_;
                                                                    let _e1342 = phi_2078_;
                                                                    phi_2082_ = _e1340;
                                                                    phi_2083_ = _e1342;
                                                                }
                                                                let _e1344 = phi_2082_;
                                                                let _e1346 = phi_2083_;
                                                                phi_2084_ = _e1344;
                                                                phi_2085_ = _e999;
                                                                phi_2086_ = _e1346;
                                                            }
                                                            let _e1348 = phi_2084_;
                                                            let _e1350 = phi_2085_;
                                                            let _e1352 = phi_2086_;
                                                            phi_2087_ = _e1348;
                                                            phi_2088_ = _e1350;
                                                            phi_2089_ = _e1352;
                                                        }
                                                        let _e1354 = phi_2087_;
                                                        let _e1356 = phi_2088_;
                                                        let _e1358 = phi_2089_;
                                                        phi_2097_ = _e1354;
                                                        phi_2098_ = select(_e1358, true, _e1356);
                                                    } else {
                                                        phi_2097_ = type_22();
                                                        phi_2098_ = true;
                                                    }
                                                    let _e1361 = phi_2097_;
                                                    let _e1363 = phi_2098_;
                                                    if _e1363 {
                                                        phi_2102_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2102_ = _e1361;
                                                    }
                                                    let _e1365 = phi_2102_;
                                                    if (_e1365.member_3 != 4294967295u) {
                                                        if (_e831 != _e554) {
                                                            if (_e1365.member < _e796.member.member.member) {
                                                                phi_2128_ = true;
                                                            } else {
                                                                if (_e1365.member == _e796.member.member.member) {
                                                                    phi_2127_ = (_e1365.member_3 < _e796.member.member.member_3);
                                                                } else {
                                                                    phi_2127_ = false;
                                                                }
                                                                let _e1380 = phi_2127_;
                                                                phi_2128_ = _e1380;
                                                            }
                                                            let _e1382 = phi_2128_;
                                                            if _e1382 {
                                                                phi_2135_ = type_48(type_43(_e1365, _e1365.member), _e823.member_1, _e823.member_2);
                                                            } else {
                                                                phi_2135_ = _e823;
                                                            }
                                                            let _e1389 = phi_2135_;
                                                            phi_2136_ = _e1389;
                                                        } else {
                                                            phi_2136_ = _e823;
                                                        }
                                                        let _e1391 = phi_2136_;
                                                        phi_2137_ = _e1391;
                                                    } else {
                                                        phi_2137_ = _e823;
                                                    }
                                                    let _e1393 = phi_2137_;
                                                    phi_1062_ = _e1393;
                                                } else {
                                                    phi_1062_ = type_48();
                                                }
                                                let _e1395 = phi_1062_;
                                                continue;
                                                continuing {
                                                    phi_1061_ = _e1395;
                                                    phi_1064_ = _e811;
                                                    phi_2925_ = _e561;
                                                    break if !(_e817);
                                                }
                                            }
                                            let _e1398 = phi_2925_;
                                            phi_3085_ = _e1398;
                                            if _e1398 {
                                                break;
                                            }
                                            phi_3089_ = _e1398;
                                            let _e1726 = local_4;
                                            phi_2627_ = _e1726;
                                            phi_2628_ = false;
                                            phi_2629_ = _e589;
                                            phi_2630_ = _e591;
                                        } else {
                                            if (_e591 >= _e77) {
                                                phi_2207_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e591 < _e77) {
                                                } else {
                                                    phi_3085_ = true;
                                                    break;
                                                }
                                                let _e601 = (_e215 % 3u);
                                                if (_e601 < 3u) {
                                                } else {
                                                    phi_3085_ = true;
                                                    break;
                                                }
                                                let _e607 = global_2.member[_e591].member[_e601];
                                                let _e613 = (_e214 % 3u);
                                                if (_e613 < 3u) {
                                                } else {
                                                    phi_3085_ = true;
                                                    break;
                                                }
                                                let _e619 = global_2.member[_e591].member[_e613];
                                                let _e625 = (_e216 % 3u);
                                                if (_e625 < 3u) {
                                                } else {
                                                    phi_3085_ = true;
                                                    break;
                                                }
                                                let _e631 = global_2.member[_e591].member[_e625];
                                                let _e641 = global_2.member[_e591].member_1;
                                                let _e645 = global_2.member[_e591].member_2;
                                                phi_2207_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e607[0], _e607[1], _e607[2], _e607[3]), vec4<f32>(_e619[0], _e619[1], _e619[2], _e619[3]), vec4<f32>(_e631[0], _e631[1], _e631[2], _e631[3])), _e641, _e645);
                                            }
                                            let _e648 = phi_2207_;
                                            let _e667 = ((_e648.member[0].x - _e300) * _e305);
                                            let _e668 = ((_e648.member[0].y - _e300) * _e305);
                                            let _e669 = ((_e648.member[0].z - _e301) * _e305);
                                            let _e670 = ((_e648.member[0].w - _e301) * _e305);
                                            let _e680 = ((_e648.member[1].x - _e366) * _e371);
                                            let _e681 = ((_e648.member[1].y - _e366) * _e371);
                                            let _e682 = ((_e648.member[1].z - _e367) * _e371);
                                            let _e683 = ((_e648.member[1].w - _e367) * _e371);
                                            let _e693 = ((_e648.member[2].x - _e432) * _e437);
                                            let _e694 = ((_e648.member[2].y - _e432) * _e437);
                                            let _e695 = ((_e648.member[2].z - _e433) * _e437);
                                            let _e696 = ((_e648.member[2].w - _e433) * _e437);
                                            let _e698 = select(_e695, _e693, (_e693 < _e695));
                                            let _e700 = select(_e696, _e694, (_e694 < _e696));
                                            let _e702 = select(_e695, _e693, (_e693 > _e695));
                                            let _e704 = select(_e696, _e694, (_e694 > _e696));
                                            let _e706 = select(_e669, _e667, (_e667 < _e669));
                                            let _e708 = select(_e670, _e668, (_e668 < _e670));
                                            let _e710 = select(_e682, _e680, (_e680 < _e682));
                                            let _e712 = select(_e683, _e681, (_e681 < _e683));
                                            let _e714 = select(_e710, _e706, (_e706 > _e710));
                                            let _e716 = select(_e712, _e708, (_e708 > _e712));
                                            let _e718 = select(_e698, _e714, (_e714 > _e698));
                                            let _e720 = select(_e700, _e716, (_e716 > _e700));
                                            let _e722 = select(_e669, _e667, (_e667 > _e669));
                                            let _e724 = select(_e670, _e668, (_e668 > _e670));
                                            let _e726 = select(_e682, _e680, (_e680 > _e682));
                                            let _e728 = select(_e683, _e681, (_e681 > _e683));
                                            let _e730 = select(_e726, _e722, (_e722 < _e726));
                                            let _e732 = select(_e728, _e724, (_e724 < _e728));
                                            let _e737 = -(_e698);
                                            let _e738 = -(_e700);
                                            let _e745 = (select(_e702, _e730, (_e730 < _e702)) + (select(_e737, _e702, (_e702 > _e737)) * 0.0000019073523f));
                                            let _e746 = (select(_e704, _e732, (_e732 < _e704)) + (select(_e738, _e704, (_e704 > _e738)) * 0.0000019073523f));
                                            let _e748 = select(_e548, _e718, (_e718 > _e548));
                                            let _e750 = select(_e548, _e720, (_e720 > _e548));
                                            let _e755 = (_e748 <= select(_e563.member.member_1, _e745, (_e745 < _e563.member.member_1)));
                                            let _e756 = (_e750 <= select(_e563.member.member_1, _e746, (_e746 < _e563.member.member_1)));
                                            let _e757 = (_e748 <= _e750);
                                            if _e755 {
                                                if _e756 {
                                                    if _e757 {
                                                        phi_2572_ = _e648.member_2;
                                                    } else {
                                                        phi_2572_ = _e648.member_1;
                                                    }
                                                    let _e761 = phi_2572_;
                                                    let _e764 = (_e589 % 128u);
                                                    let _e765 = (_e764 < 128u);
                                                    if _e765 {
                                                    } else {
                                                        phi_3085_ = true;
                                                        break;
                                                    }
                                                    local_1[_e764] = _e761;
                                                    if _e765 {
                                                    } else {
                                                        phi_3085_ = true;
                                                        break;
                                                    }
                                                    local[_e764] = select(_e750, _e748, !(_e757));
                                                    if _e757 {
                                                        phi_2600_ = _e648.member_1;
                                                    } else {
                                                        phi_2600_ = _e648.member_2;
                                                    }
                                                    let _e772 = phi_2600_;
                                                    phi_2601_ = (_e589 + 1u);
                                                    phi_2602_ = _e772;
                                                } else {
                                                    phi_2601_ = u32();
                                                    phi_2602_ = u32();
                                                }
                                                let _e774 = phi_2601_;
                                                let _e776 = phi_2602_;
                                                phi_2604_ = _e774;
                                                phi_2605_ = _e776;
                                                phi_2606_ = select(true, false, _e756);
                                            } else {
                                                phi_2604_ = u32();
                                                phi_2605_ = u32();
                                                phi_2606_ = true;
                                            }
                                            let _e779 = phi_2604_;
                                            let _e781 = phi_2605_;
                                            let _e783 = phi_2606_;
                                            if _e783 {
                                                if _e755 {
                                                    phi_2615_ = _e648.member_1;
                                                } else {
                                                    phi_2615_ = _e648.member_2;
                                                }
                                                let _e787 = phi_2615_;
                                                phi_2620_ = select(_e756, true, _e755);
                                                phi_2622_ = _e787;
                                            } else {
                                                phi_2620_ = _e587;
                                                phi_2622_ = _e781;
                                            }
                                            let _e790 = phi_2620_;
                                            let _e792 = phi_2622_;
                                            phi_3089_ = _e561;
                                            phi_2627_ = type_48(_e563.member, (_e563.member_1 + 1u), _e563.member_2);
                                            phi_2628_ = _e790;
                                            phi_2629_ = select(_e779, _e589, _e783);
                                            phi_2630_ = _e792;
                                        }
                                        let _e1400 = phi_3089_;
                                        let _e1402 = phi_2627_;
                                        let _e1404 = phi_2628_;
                                        let _e1406 = phi_2629_;
                                        let _e1408 = phi_2630_;
                                        phi_3088_ = _e1400;
                                        phi_2631_ = _e1402;
                                        phi_2632_ = _e1404;
                                        phi_2633_ = (_e567 - 1u);
                                        phi_2634_ = _e1406;
                                        phi_2635_ = _e1408;
                                    } else {
                                        phi_3088_ = _e561;
                                        phi_2631_ = _e563;
                                        phi_2632_ = _e587;
                                        phi_2633_ = _e567;
                                        phi_2634_ = _e589;
                                        phi_2635_ = _e591;
                                    }
                                    let _e1410 = phi_3088_;
                                    let _e1412 = phi_2631_;
                                    let _e1414 = phi_2632_;
                                    let _e1416 = phi_2633_;
                                    let _e1418 = phi_2634_;
                                    let _e1420 = phi_2635_;
                                    phi_3087_ = _e1410;
                                    phi_2636_ = _e1412;
                                    phi_2637_ = _e1414;
                                    phi_2638_ = _e1416;
                                    phi_2639_ = _e1418;
                                    phi_2640_ = _e1420;
                                } else {
                                    phi_3087_ = _e561;
                                    phi_2636_ = type_48();
                                    phi_2637_ = bool();
                                    phi_2638_ = u32();
                                    phi_2639_ = u32();
                                    phi_2640_ = u32();
                                }
                                let _e1422 = phi_3087_;
                                let _e1424 = phi_2636_;
                                let _e1426 = phi_2637_;
                                let _e1428 = phi_2638_;
                                let _e1430 = phi_2639_;
                                let _e1432 = phi_2640_;
                                phi_3086_ = _e1422;
                                phi_993_ = _e1424;
                                phi_996_ = _e1426;
                                phi_998_ = _e1428;
                                phi_1000_ = _e1430;
                                phi_1002_ = _e1432;
                                phi_2641_ = _e575;
                            } else {
                                phi_3086_ = _e561;
                                phi_993_ = type_48();
                                phi_996_ = bool();
                                phi_998_ = u32();
                                phi_1000_ = u32();
                                phi_1002_ = u32();
                                phi_2641_ = false;
                            }
                            let _e1434 = phi_3086_;
                            let _e1436 = phi_993_;
                            let _e1438 = phi_996_;
                            let _e1440 = phi_998_;
                            let _e1442 = phi_1000_;
                            let _e1444 = phi_1002_;
                            let _e1446 = phi_2641_;
                            continue;
                            continuing {
                                phi_2931_ = _e1434;
                                phi_992_ = _e1436;
                                phi_995_ = _e1438;
                                phi_997_ = _e1440;
                                phi_999_ = _e1442;
                                phi_1001_ = _e1444;
                                phi_3085_ = _e1434;
                                break if !(_e1446);
                            }
                        }
                        let _e1449 = phi_3085_;
                        if _e1449 {
                            break;
                        }
                        let _e1451 = local_2;
                        if (_e1451.member.member.member_3 != 4294967295u) {
                            let _e1457 = bitcast<u32>(_e1451.member.member.member);
                            let _e1461 = (bitcast<i32>((_e1457 >> bitcast<u32>(23i))) & 255i);
                            let _e1462 = (_e1461 + _e217);
                            if (_e1461 == 255i) {
                                phi_2700_ = _e1451.member.member.member;
                            } else {
                                if (_e1461 > 0i) {
                                    if (_e1462 > 0i) {
                                        let _e1466 = (_e1462 < 255i);
                                        if _e1466 {
                                            phi_2679_ = bitcast<f32>((_e1457 + bitcast<u32>((_e217 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_2679_ = f32();
                                        }
                                        let _e1473 = phi_2679_;
                                        phi_2681_ = _e1473;
                                        phi_2682_ = select(true, false, _e1466);
                                    } else {
                                        phi_2681_ = f32();
                                        phi_2682_ = true;
                                    }
                                    let _e1476 = phi_2681_;
                                    let _e1478 = phi_2682_;
                                    phi_2683_ = _e1476;
                                    phi_2684_ = _e1478;
                                } else {
                                    phi_2683_ = f32();
                                    phi_2684_ = true;
                                }
                                let _e1480 = phi_2683_;
                                let _e1482 = phi_2684_;
                                if _e1482 {
                                    let _e1483 = (_e1457 & 2147483648u);
                                    let _e1490 = ((_e1457 & 8388607u) | (select(0u, 1u, ((_e1457 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1494 = (_e1490 == 0u);
                                    if _e1494 {
                                        phi_2920_ = bitcast<f32>(_e1483);
                                    } else {
                                        let _e1499 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1490)), 32u, _e1494) - 8u);
                                        let _e1502 = (_e1490 << bitcast<u32>((_e1499 & 31u)));
                                        let _e1504 = ((_e1462 + select(0i, 1i, (_e1461 == 0i))) - bitcast<i32>(_e1499));
                                        if (_e1504 >= 255i) {
                                            phi_2910_ = bitcast<f32>((_e1483 | 2139095040u));
                                            phi_2911_ = f32();
                                            phi_2912_ = true;
                                        } else {
                                            let _e1506 = (_e1504 > 0i);
                                            if _e1506 {
                                                phi_2904_ = bitcast<f32>(((_e1483 | (bitcast<u32>(_e1504) << bitcast<u32>(23i))) | (_e1502 & 8388607u)));
                                                phi_2905_ = f32();
                                            } else {
                                                if (_e1504 < -24i) {
                                                    phi_2870_ = 26u;
                                                } else {
                                                    phi_2870_ = bitcast<u32>((1i - _e1504));
                                                }
                                                let _e1511 = phi_2870_;
                                                let _e1512 = (_e1511 & 31u);
                                                let _e1514 = (_e1502 >> bitcast<u32>(_e1512));
                                                let _e1518 = (_e1502 & ((1u << bitcast<u32>(_e1512)) - 1u));
                                                let _e1522 = (1u << bitcast<u32>(((_e1511 - 1u) & 31u)));
                                                if (_e1518 > _e1522) {
                                                    phi_2891_ = true;
                                                } else {
                                                    if (_e1518 == _e1522) {
                                                        phi_2888_ = ((_e1514 & 1u) == 1u);
                                                    } else {
                                                        phi_2888_ = false;
                                                    }
                                                    let _e1528 = phi_2888_;
                                                    phi_2891_ = _e1528;
                                                }
                                                let _e1530 = phi_2891_;
                                                phi_2904_ = f32();
                                                phi_2905_ = bitcast<f32>((_e1483 | (_e1514 + select(0u, 1u, _e1530))));
                                            }
                                            let _e1543 = phi_2904_;
                                            let _e1545 = phi_2905_;
                                            phi_2910_ = _e1543;
                                            phi_2911_ = _e1545;
                                            phi_2912_ = _e1506;
                                        }
                                        let _e1549 = phi_2910_;
                                        let _e1551 = phi_2911_;
                                        let _e1553 = phi_2912_;
                                        phi_2920_ = select(_e1551, _e1549, _e1553);
                                    }
                                    let _e1557 = phi_2920_;
                                    phi_2699_ = _e1557;
                                } else {
                                    phi_2699_ = _e1480;
                                }
                                let _e1559 = phi_2699_;
                                phi_2700_ = _e1559;
                            }
                            let _e1561 = phi_2700_;
                            let _e1562 = bitcast<u32>(_e1561);
                            if ((_e1562 & 2147483647u) >= 2139095040u) {
                                phi_2712_ = bitcast<f32>(((_e1562 & 2147483648u) | 2139095039u));
                            } else {
                                phi_2712_ = _e1561;
                            }
                            let _e1569 = phi_2712_;
                            phi_2717_ = type_22(_e1569, _e1451.member.member.member_1, _e1451.member.member.member_2, _e1451.member.member.member_3);
                        } else {
                            phi_2717_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1574 = phi_2717_;
                        if _e93 {
                        } else {
                            break;
                        }
                        global_4.member[_e91] = _e1574;
                        let _e1578 = local_3;
                        if _e94 {
                        } else {
                            break;
                        }
                        global_5.member[_e91] = _e1578.member_1;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e1583 = select(0u, 1u, (_e161 <= _e171));
                        if (_e1583 > 0u) {
                            let _e1585 = (1u < _e87);
                            if _e1585 {
                                if (0u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1589 = atomicAdd((&global_6.member[0u]), _e1583);
                                if ((_e1589 + _e1583) < _e1589) {
                                    if _e1585 {
                                    } else {
                                        break;
                                    }
                                    let _e1594 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1597 = select(0u, 1u, (_e1574.member_3 != 4294967295u));
                        if (_e1597 > 0u) {
                            let _e1599 = (3u < _e87);
                            if _e1599 {
                                if (2u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1603 = atomicAdd((&global_6.member[2u]), _e1597);
                                if ((_e1603 + _e1597) < _e1603) {
                                    if _e1599 {
                                    } else {
                                        break;
                                    }
                                    let _e1608 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1578.member_1 > 0u) {
                            let _e1610 = (5u < _e87);
                            if _e1610 {
                                if (4u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1614 = atomicAdd((&global_6.member[4u]), _e1578.member_1);
                                if ((_e1614 + _e1578.member_1) < _e1614) {
                                    if _e1610 {
                                    } else {
                                        break;
                                    }
                                    let _e1619 = atomicAdd((&global_6.member[5u]), 1u);
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
