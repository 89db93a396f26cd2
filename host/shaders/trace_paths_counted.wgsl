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
    var phi_2937_: bool;
    var phi_992_: type_48;
    var phi_995_: u32;
    var phi_997_: bool;
    var phi_999_: u32;
    var phi_1001_: u32;
    var phi_1012_: bool;
    var phi_1044_: bool;
    var phi_1045_: u32;
    var phi_1046_: u32;
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
    var phi_2931_: bool;
    var phi_3126_: bool;
    var phi_2138_: type_48;
    var phi_2203_: type_47;
    var phi_2568_: u32;
    var phi_2595_: u32;
    var phi_2596_: u32;
    var phi_2597_: u32;
    var phi_2599_: u32;
    var phi_2600_: u32;
    var phi_2601_: bool;
    var phi_2610_: u32;
    var phi_2615_: bool;
    var phi_2617_: u32;
    var phi_2622_: type_48;
    var phi_2623_: bool;
    var phi_2624_: u32;
    var phi_2625_: u32;
    var phi_2633_: type_48;
    var phi_3094_: bool;
    var phi_2637_: type_48;
    var phi_2638_: u32;
    var phi_2639_: bool;
    var phi_2640_: u32;
    var phi_2641_: u32;
    var phi_3093_: bool;
    var phi_2642_: type_48;
    var phi_2643_: u32;
    var phi_2644_: bool;
    var phi_2645_: u32;
    var phi_2646_: u32;
    var phi_3092_: bool;
    var phi_993_: type_48;
    var phi_996_: u32;
    var phi_998_: bool;
    var phi_1000_: u32;
    var phi_1002_: u32;
    var phi_2647_: bool;
    var phi_3091_: bool;
    var local_2: type_48;
    var phi_2685_: f32;
    var phi_2687_: f32;
    var phi_2688_: bool;
    var phi_2689_: f32;
    var phi_2690_: bool;
    var phi_2876_: u32;
    var phi_2894_: bool;
    var phi_2897_: bool;
    var phi_2910_: f32;
    var phi_2911_: f32;
    var phi_2916_: f32;
    var phi_2917_: f32;
    var phi_2918_: bool;
    var phi_2926_: f32;
    var phi_2705_: f32;
    var phi_2706_: f32;
    var phi_2718_: f32;
    var phi_2723_: type_22;
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
                        phi_2937_ = false;
                        phi_992_ = type_48(type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e546), 0u, 0u);
                        phi_995_ = ((3u * _e77) + 1u);
                        phi_997_ = (_e548 <= _e546);
                        phi_999_ = 0u;
                        phi_1001_ = select(0u, 2147483648u, (_e77 == 0u));
                        loop {
                            let _e561 = phi_2937_;
                            let _e563 = phi_992_;
                            let _e565 = phi_995_;
                            let _e567 = phi_997_;
                            let _e569 = phi_999_;
                            let _e571 = phi_1001_;
                            local_2 = _e563;
                            local_3 = _e563;
                            if _e567 {
                                phi_1012_ = true;
                            } else {
                                phi_1012_ = (_e569 > 0u);
                            }
                            let _e574 = phi_1012_;
                            if _e574 {
                                let _e575 = (_e565 > 0u);
                                if _e575 {
                                    if _e567 {
                                        phi_1044_ = _e567;
                                        phi_1045_ = _e569;
                                        phi_1046_ = _e571;
                                    } else {
                                        let _e576 = (_e569 - 1u);
                                        let _e577 = (_e576 % 128u);
                                        let _e578 = (_e577 < 128u);
                                        if _e578 {
                                        } else {
                                            phi_3091_ = true;
                                            break;
                                        }
                                        let _e580 = local_1[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3091_ = true;
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
                                        let _e594 = ((_e591 & 2147483648u) != 0u);
                                        if _e594 {
                                            phi_1061_ = _e563;
                                            phi_1064_ = type_7(0u, ((_e591 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e601 = phi_1061_;
                                                let _e603 = phi_1064_;
                                                local_4 = _e601;
                                                if (_e603.member < _e603.member_1) {
                                                    phi_1065_ = type_7((_e603.member + 1u), _e603.member_1);
                                                    phi_1087_ = type_7(1u, _e603.member);
                                                } else {
                                                    phi_1065_ = _e603;
                                                    phi_1087_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e616 = phi_1065_;
                                                let _e618 = phi_1087_;
                                                let _e622 = (bitcast<i32>(_e618.member) != 0i);
                                                if _e622 {
                                                    let _e628 = type_48(_e601.member, _e601.member_1, (_e601.member_2 + 1u));
                                                    let _e629 = ((_e591 & 268435455u) + _e618.member_1);
                                                    let _e630 = (_e629 < _e79);
                                                    if _e630 {
                                                        if _e630 {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e634 = global_1.member[_e629].member_1;
                                                        phi_1111_ = _e634;
                                                    } else {
                                                        phi_1111_ = 4294967295u;
                                                    }
                                                    let _e636 = phi_1111_;
                                                    if (_e629 >= _e79) {
                                                        phi_1203_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e630 {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e638 = (_e215 % 3u);
                                                        let _e639 = (_e214 % 3u);
                                                        let _e640 = (_e216 % 3u);
                                                        if (_e638 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e646 = global_1.member[_e629].member[_e638];
                                                        if (_e639 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e652 = global_1.member[_e629].member[_e639];
                                                        if (_e640 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e658 = global_1.member[_e629].member[_e640];
                                                        let _e660 = (3u + _e638);
                                                        if (_e660 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e666 = global_1.member[_e629].member[_e660];
                                                        let _e667 = (3u + _e639);
                                                        if (_e667 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e673 = global_1.member[_e629].member[_e667];
                                                        let _e674 = (3u + _e640);
                                                        if (_e674 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e680 = global_1.member[_e629].member[_e674];
                                                        let _e682 = (6u + _e638);
                                                        if (_e682 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e688 = global_1.member[_e629].member[_e682];
                                                        let _e689 = (6u + _e639);
                                                        if (_e689 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e695 = global_1.member[_e629].member[_e689];
                                                        let _e696 = (6u + _e640);
                                                        if (_e696 < 9u) {
                                                        } else {
                                                            phi_2931_ = true;
                                                            break;
                                                        }
                                                        let _e702 = global_1.member[_e629].member[_e696];
                                                        phi_1203_ = array<array<f32, 3>, 3>(array<f32, 3>(_e646, _e652, _e658), array<f32, 3>(_e666, _e673, _e680), array<f32, 3>(_e688, _e695, _e702));
                                                    }
                                                    let _e706 = phi_1203_;
                                                    let _e715 = (_e706[0][2] - _e395);
                                                    let _e718 = (((_e706[0][0] - _e262) * _e434) - (_e715 * _e302));
                                                    let _e721 = (((_e706[0][1] - _e329) * _e434) - (_e715 * _e368));
                                                    let _e728 = (_e706[1][2] - _e395);
                                                    let _e731 = (((_e706[1][0] - _e262) * _e434) - (_e728 * _e302));
                                                    let _e734 = (((_e706[1][1] - _e329) * _e434) - (_e728 * _e368));
                                                    let _e741 = (_e706[2][2] - _e395);
                                                    let _e744 = (((_e706[2][0] - _e262) * _e434) - (_e741 * _e302));
                                                    let _e747 = (((_e706[2][1] - _e329) * _e434) - (_e741 * _e368));
                                                    let _e748 = (_e744 * _e734);
                                                    let _e749 = (_e747 * _e731);
                                                    let _e750 = (_e718 * _e747);
                                                    let _e751 = (_e721 * _e744);
                                                    let _e752 = (_e731 * _e721);
                                                    let _e753 = (_e734 * _e718);
                                                    let _e758 = (((_e748 >= _e749) && (_e750 >= _e751)) && (_e752 >= _e753));
                                                    if (_e758 || (((_e748 <= _e749) && (_e750 <= _e751)) && (_e752 <= _e753))) {
                                                        let _e765 = select(-1f, 1f, _e758);
                                                        let _e767 = ((_e748 - _e749) * _e765);
                                                        let _e769 = select(0f, _e767, (_e767 > 0f));
                                                        let _e771 = ((_e750 - _e751) * _e765);
                                                        let _e773 = select(0f, _e771, (_e771 > 0f));
                                                        let _e775 = ((_e752 - _e753) * _e765);
                                                        let _e777 = select(0f, _e775, (_e775 > 0f));
                                                        let _e779 = ((_e769 + _e773) + _e777);
                                                        if (_e779 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2087_ = type_22();
                                                            phi_2088_ = true;
                                                            phi_2089_ = false;
                                                        } else {
                                                            let _e782 = select(_e731, _e718, (_e718 < _e731));
                                                            if (select(_e744, _e782, (_e782 < _e744)) > 0f) {
                                                                phi_1355_ = true;
                                                            } else {
                                                                let _e787 = select(_e731, _e718, (_e718 > _e731));
                                                                phi_1355_ = (select(_e744, _e787, (_e787 > _e744)) < 0f);
                                                            }
                                                            let _e792 = phi_1355_;
                                                            if _e792 {
                                                                phi_2084_ = type_22();
                                                                phi_2085_ = true;
                                                                phi_2086_ = false;
                                                            } else {
                                                                let _e794 = select(_e734, _e721, (_e721 < _e734));
                                                                if (select(_e747, _e794, (_e794 < _e747)) > 0f) {
                                                                    phi_1384_ = true;
                                                                } else {
                                                                    let _e799 = select(_e734, _e721, (_e721 > _e734));
                                                                    phi_1384_ = (select(_e747, _e799, (_e799 > _e747)) < 0f);
                                                                }
                                                                let _e804 = phi_1384_;
                                                                if _e804 {
                                                                    phi_2082_ = type_22();
                                                                    phi_2083_ = false;
                                                                } else {
                                                                    let _e806 = select(_e706[1][0], _e706[0][0], (_e706[0][0] < _e706[1][0]));
                                                                    let _e810 = select(_e706[1][0], _e706[0][0], (_e706[0][0] > _e706[1][0]));
                                                                    let _e814 = select(_e706[1][1], _e706[0][1], (_e706[0][1] < _e706[1][1]));
                                                                    let _e818 = select(_e706[1][1], _e706[0][1], (_e706[0][1] > _e706[1][1]));
                                                                    let _e822 = select(_e706[1][2], _e706[0][2], (_e706[0][2] < _e706[1][2]));
                                                                    let _e826 = select(_e706[1][2], _e706[0][2], (_e706[0][2] > _e706[1][2]));
                                                                    let _e831 = ((select(_e706[2][0], _e806, (_e806 < _e706[2][0])) - _e300) * _e305);
                                                                    let _e832 = ((select(_e706[2][0], _e810, (_e810 > _e706[2][0])) - _e301) * _e305);
                                                                    let _e835 = ((select(_e706[2][1], _e814, (_e814 < _e706[2][1])) - _e366) * _e371);
                                                                    let _e836 = ((select(_e706[2][1], _e818, (_e818 > _e706[2][1])) - _e367) * _e371);
                                                                    let _e839 = ((select(_e706[2][2], _e822, (_e822 < _e706[2][2])) - _e432) * _e437);
                                                                    let _e840 = ((select(_e706[2][2], _e826, (_e826 > _e706[2][2])) - _e433) * _e437);
                                                                    let _e842 = select(_e840, _e839, (_e839 < _e840));
                                                                    let _e844 = select(_e840, _e839, (_e839 > _e840));
                                                                    let _e846 = select(_e832, _e831, (_e831 < _e832));
                                                                    let _e848 = select(_e836, _e835, (_e835 < _e836));
                                                                    let _e850 = select(_e848, _e846, (_e846 > _e848));
                                                                    let _e852 = select(_e842, _e850, (_e850 > _e842));
                                                                    let _e854 = select(_e832, _e831, (_e831 > _e832));
                                                                    let _e856 = select(_e836, _e835, (_e835 > _e836));
                                                                    let _e858 = select(_e856, _e854, (_e854 < _e856));
                                                                    let _e860 = select(_e844, _e858, (_e858 < _e844));
                                                                    let _e861 = -(_e842);
                                                                    let _e867 = select(_e548, _e852, (_e852 > _e548));
                                                                    if (_e867 > (_e860 + (select(_e861, _e844, (_e844 > _e861)) * 0.0000019073523f))) {
                                                                        phi_2077_ = type_22();
                                                                        phi_2078_ = true;
                                                                    } else {
                                                                        let _e869 = (_e867 > _e601.member.member_1);
                                                                        if _e869 {
                                                                            phi_2076_ = type_22();
                                                                        } else {
                                                                            let _e870 = vec3<f32>(_e706[0][0], _e706[0][1], _e706[0][2]);
                                                                            let _e871 = vec3<f32>(_e706[1][0], _e706[1][1], _e706[1][2]);
                                                                            let _e872 = vec3<f32>(_e706[2][0], _e706[2][1], _e706[2][2]);
                                                                            let _e873 = (_e706[1][0] - _e706[0][0]);
                                                                            let _e874 = (_e706[1][1] - _e706[0][1]);
                                                                            let _e875 = (_e706[1][2] - _e706[0][2]);
                                                                            let _e876 = vec3<f32>(_e873, _e874, _e875);
                                                                            let _e877 = (_e706[2][0] - _e706[1][0]);
                                                                            let _e878 = (_e706[2][1] - _e706[1][1]);
                                                                            let _e879 = (_e706[2][2] - _e706[1][2]);
                                                                            let _e880 = vec3<f32>(_e877, _e878, _e879);
                                                                            let _e881 = (_e706[0][0] - _e706[2][0]);
                                                                            let _e882 = (_e706[0][1] - _e706[2][1]);
                                                                            let _e883 = (_e706[0][2] - _e706[2][2]);
                                                                            let _e884 = vec3<f32>(_e881, _e882, _e883);
                                                                            let _e887 = bitcast<f32>((bitcast<u32>(_e873) & 2147483647u));
                                                                            let _e890 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                            let _e892 = select(_e890, _e887, (_e887 > _e890));
                                                                            let _e895 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                            let _e897 = select(_e895, _e892, (_e892 > _e895));
                                                                            let _e900 = bitcast<f32>((bitcast<u32>(_e877) & 2147483647u));
                                                                            let _e903 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                            let _e905 = select(_e903, _e900, (_e900 > _e903));
                                                                            let _e908 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                            let _e910 = select(_e908, _e905, (_e905 > _e908));
                                                                            let _e913 = bitcast<f32>((bitcast<u32>(_e881) & 2147483647u));
                                                                            let _e916 = bitcast<f32>((bitcast<u32>(_e882) & 2147483647u));
                                                                            let _e918 = select(_e916, _e913, (_e913 > _e916));
                                                                            let _e921 = bitcast<f32>((bitcast<u32>(_e883) & 2147483647u));
                                                                            let _e923 = select(_e921, _e918, (_e918 > _e921));
                                                                            let _e925 = select(_e910, _e897, (_e897 > _e910));
                                                                            let _e927 = select(_e923, _e925, (_e925 > _e923));
                                                                            if (_e897 == _e927) {
                                                                                phi_1803_ = _e734;
                                                                                phi_1804_ = _e731;
                                                                                phi_1805_ = _e721;
                                                                                phi_1806_ = _e718;
                                                                                phi_1807_ = _e870;
                                                                                phi_1808_ = _e884;
                                                                                phi_1809_ = _e880;
                                                                                phi_1810_ = _e876;
                                                                            } else {
                                                                                let _e929 = (_e910 == _e927);
                                                                                let _e934 = vec3(_e929);
                                                                                phi_1803_ = select(_e721, _e747, _e929);
                                                                                phi_1804_ = select(_e718, _e744, _e929);
                                                                                phi_1805_ = select(_e747, _e734, _e929);
                                                                                phi_1806_ = select(_e744, _e731, _e929);
                                                                                phi_1807_ = select(_e872, _e871, _e934);
                                                                                phi_1808_ = select(_e880, _e876, _e934);
                                                                                phi_1809_ = select(_e876, _e884, _e934);
                                                                                phi_1810_ = select(_e884, _e880, _e934);
                                                                            }
                                                                            let _e940 = phi_1803_;
                                                                            let _e942 = phi_1804_;
                                                                            let _e944 = phi_1805_;
                                                                            let _e946 = phi_1806_;
                                                                            let _e948 = phi_1807_;
                                                                            let _e950 = phi_1808_;
                                                                            let _e952 = phi_1809_;
                                                                            let _e954 = phi_1810_;
                                                                            let _e961 = ((_e952.y * _e950.z) - (_e950.y * _e952.z));
                                                                            let _e966 = ((_e952.z * _e950.x) - (_e950.z * _e952.x));
                                                                            let _e969 = ((_e952.x * _e950.y) - (_e950.x * _e952.y));
                                                                            if (_e769 >= _e773) {
                                                                                phi_1847_ = select(true, false, (_e769 >= _e777));
                                                                            } else {
                                                                                phi_1847_ = true;
                                                                            }
                                                                            let _e974 = phi_1847_;
                                                                            if _e974 {
                                                                                phi_1856_ = select(_e872, _e871, vec3((_e773 >= _e777)));
                                                                            } else {
                                                                                phi_1856_ = _e870;
                                                                            }
                                                                            let _e979 = phi_1856_;
                                                                            let _e990 = (((_e961 * (_e979.x - _e262)) + (_e966 * (_e979.y - _e329))) + (_e969 * (_e979.z - _e395)));
                                                                            let _e995 = (((_e961 * _e302) + (_e966 * _e368)) + (_e969 * _e434));
                                                                            let _e996 = (_e942 - _e946);
                                                                            let _e997 = (_e940 - _e944);
                                                                            let _e1005 = (-(((_e946 * _e996) + (_e944 * _e997))) / ((_e996 * _e996) + (_e997 * _e997)));
                                                                            let _e1007 = select(1f, _e1005, (_e1005 < 1f));
                                                                            let _e1009 = select(0f, _e1007, (_e1007 > 0f));
                                                                            let _e1022 = ((_e948.x + (_e954.x * _e1009)) - _e262);
                                                                            let _e1023 = ((_e948.y + (_e954.y * _e1009)) - _e329);
                                                                            let _e1024 = ((_e948.z + (_e954.z * _e1009)) - _e395);
                                                                            let _e1025 = (_e1024 / _e434);
                                                                            let _e1037 = bitcast<f32>((bitcast<u32>(_e1022) & 2147483647u));
                                                                            let _e1040 = bitcast<f32>((bitcast<u32>(_e1023) & 2147483647u));
                                                                            let _e1042 = select(_e1040, _e1037, (_e1037 > _e1040));
                                                                            let _e1045 = bitcast<f32>((bitcast<u32>(_e1024) & 2147483647u));
                                                                            let _e1047 = select(_e1045, _e1042, (_e1042 > _e1045));
                                                                            let _e1053 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                            let _e1056 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                            let _e1058 = select(_e1056, _e1053, (_e1053 > _e1056));
                                                                            let _e1061 = bitcast<f32>((bitcast<u32>(_e969) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e961 * _e1022) + (_e966 * _e1023)) + (_e969 * _e1024)) - _e990)) & 2147483647u)) <= ((0.0000009536743f * select(_e927, _e1047, (_e1047 > _e927))) * select(_e1061, _e1058, (_e1058 > _e1061)))) {
                                                                                let _e1071 = bitcast<f32>((bitcast<u32>(_e952.x) & 2147483647u));
                                                                                let _e1074 = bitcast<f32>((bitcast<u32>(_e952.y) & 2147483647u));
                                                                                let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                                                let _e1079 = bitcast<f32>((bitcast<u32>(_e952.z) & 2147483647u));
                                                                                let _e1085 = bitcast<f32>((bitcast<u32>(_e950.x) & 2147483647u));
                                                                                let _e1088 = bitcast<f32>((bitcast<u32>(_e950.y) & 2147483647u));
                                                                                let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                                let _e1093 = bitcast<f32>((bitcast<u32>(_e950.z) & 2147483647u));
                                                                                let _e1097 = (bitcast<f32>((bitcast<u32>(_e995) & 2147483647u)) > ((0.0000038146973f * select(_e1079, _e1076, (_e1076 > _e1079))) * select(_e1093, _e1090, (_e1090 > _e1093))));
                                                                                if _e1097 {
                                                                                    phi_2021_ = (_e990 / _e995);
                                                                                } else {
                                                                                    phi_2021_ = f32();
                                                                                }
                                                                                let _e1100 = phi_2021_;
                                                                                phi_2023_ = _e1100;
                                                                                phi_2024_ = select(true, false, _e1097);
                                                                            } else {
                                                                                phi_2023_ = f32();
                                                                                phi_2024_ = true;
                                                                            }
                                                                            let _e1103 = phi_2023_;
                                                                            let _e1105 = phi_2024_;
                                                                            if _e1105 {
                                                                                let _e1113 = (((_e961 * (_e1022 - (_e302 * _e1025))) + (_e966 * (_e1023 - (_e368 * _e1025)))) / _e995);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u)) <= _e927) {
                                                                                    phi_2044_ = (_e1025 + _e1113);
                                                                                } else {
                                                                                    phi_2044_ = _e1025;
                                                                                }
                                                                                let _e1120 = phi_2044_;
                                                                                phi_2045_ = _e1120;
                                                                            } else {
                                                                                phi_2045_ = _e1103;
                                                                            }
                                                                            let _e1122 = phi_2045_;
                                                                            let _e1124 = select(_e860, _e1122, (_e1122 < _e860));
                                                                            let _e1126 = select(_e852, _e1124, (_e1124 > _e852));
                                                                            if (_e1126 >= _e548) {
                                                                                let _e1128 = (_e1126 <= _e601.member.member_1);
                                                                                if _e1128 {
                                                                                    let _e1129 = (1f / _e779);
                                                                                    phi_2068_ = type_22(_e1126, (_e773 * _e1129), (_e777 * _e1129), _e636);
                                                                                } else {
                                                                                    phi_2068_ = type_22();
                                                                                }
                                                                                let _e1134 = phi_2068_;
                                                                                phi_2070_ = _e1134;
                                                                                phi_2071_ = select(true, false, _e1128);
                                                                            } else {
                                                                                phi_2070_ = type_22();
                                                                                phi_2071_ = true;
                                                                            }
                                                                            let _e1137 = phi_2070_;
                                                                            let _e1139 = phi_2071_;
                                                                            if _e1139 {
                                                                                phi_2075_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2075_ = _e1137;
                                                                            }
                                                                            let _e1141 = phi_2075_;
                                                                            phi_2076_ = _e1141;
                                                                        }
                                                                        let _e1143 = phi_2076_;
                                                                        phi_2077_ = _e1143;
                                                                        phi_2078_ = _e869;
                                                                    }
                                                                    let _e1145 = phi_2077_;
                                                                    let _e1147 = phi_2078_;
                                                                    phi_2082_ = _e1145;
                                                                    phi_2083_ = _e1147;
                                                                }
                                                                let _e1149 = phi_2082_;
                                                                let _e1151 = phi_2083_;
                                                                phi_2084_ = _e1149;
                                                                phi_2085_ = _e804;
                                                                phi_2086_ = _e1151;
                                                            }
                                                            let _e1153 = phi_2084_;
                                                            let _e1155 = phi_2085_;
                                                            let _e1157 = phi_2086_;
                                                            phi_2087_ = _e1153;
                                                            phi_2088_ = _e1155;
                                                            phi_2089_ = _e1157;
                                                        }
                                                        let _e1159 = phi_2087_;
                                                        let _e1161 = phi_2088_;
                                                        let _e1163 = phi_2089_;
                                                        phi_2097_ = _e1159;
                                                        phi_2098_ = select(_e1163, true, _e1161);
                                                    } else {
                                                        phi_2097_ = type_22();
                                                        phi_2098_ = true;
                                                    }
                                                    let _e1166 = phi_2097_;
                                                    let _e1168 = phi_2098_;
                                                    if _e1168 {
                                                        phi_2102_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2102_ = _e1166;
                                                    }
                                                    let _e1170 = phi_2102_;
                                                    if (_e1170.member_3 != 4294967295u) {
                                                        if (_e636 != _e554) {
                                                            if (_e1170.member < _e601.member.member.member) {
                                                                phi_2128_ = true;
                                                            } else {
                                                                if (_e1170.member == _e601.member.member.member) {
                                                                    phi_2127_ = (_e1170.member_3 < _e601.member.member.member_3);
                                                                } else {
                                                                    phi_2127_ = false;
                                                                }
                                                                let _e1185 = phi_2127_;
                                                                phi_2128_ = _e1185;
                                                            }
                                                            let _e1187 = phi_2128_;
                                                            if _e1187 {
                                                                phi_2135_ = type_48(type_43(_e1170, _e1170.member), _e628.member_1, _e628.member_2);
                                                            } else {
                                                                phi_2135_ = _e628;
                                                            }
                                                            let _e1194 = phi_2135_;
                                                            phi_2136_ = _e1194;
                                                        } else {
                                                            phi_2136_ = _e628;
                                                        }
                                                        let _e1196 = phi_2136_;
                                                        phi_2137_ = _e1196;
                                                    } else {
                                                        phi_2137_ = _e628;
                                                    }
                                                    let _e1198 = phi_2137_;
                                                    phi_1062_ = _e1198;
                                                } else {
                                                    phi_1062_ = type_48();
                                                }
                                                let _e1200 = phi_1062_;
                                                continue;
                                                continuing {
                                                    phi_1061_ = _e1200;
                                                    phi_1064_ = _e616;
                                                    phi_2931_ = _e561;
                                                    break if !(_e622);
                                                }
                                            }
                                            let _e1203 = phi_2931_;
                                            phi_3091_ = _e1203;
                                            if _e1203 {
                                                break;
                                            }
                                            phi_3126_ = _e1203;
                                            let _e1721 = local_4;
                                            phi_2138_ = _e1721;
                                        } else {
                                            phi_3126_ = _e561;
                                            phi_2138_ = _e563;
                                        }
                                        let _e1205 = phi_3126_;
                                        let _e1207 = phi_2138_;
                                        if _e594 {
                                            phi_2622_ = type_48();
                                            phi_2623_ = bool();
                                            phi_2624_ = u32();
                                            phi_2625_ = u32();
                                        } else {
                                            if (_e591 >= _e77) {
                                                phi_2203_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e591 < _e77) {
                                                } else {
                                                    phi_3091_ = true;
                                                    break;
                                                }
                                                let _e1210 = (_e215 % 3u);
                                                if (_e1210 < 3u) {
                                                } else {
                                                    phi_3091_ = true;
                                                    break;
                                                }
                                                let _e1216 = global_2.member[_e591].member[_e1210];
                                                let _e1222 = (_e214 % 3u);
                                                if (_e1222 < 3u) {
                                                } else {
                                                    phi_3091_ = true;
                                                    break;
                                                }
                                                let _e1228 = global_2.member[_e591].member[_e1222];
                                                let _e1234 = (_e216 % 3u);
                                                if (_e1234 < 3u) {
                                                } else {
                                                    phi_3091_ = true;
                                                    break;
                                                }
                                                let _e1240 = global_2.member[_e591].member[_e1234];
                                                let _e1250 = global_2.member[_e591].member_1;
                                                let _e1254 = global_2.member[_e591].member_2;
                                                phi_2203_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e1216[0], _e1216[1], _e1216[2], _e1216[3]), vec4<f32>(_e1228[0], _e1228[1], _e1228[2], _e1228[3]), vec4<f32>(_e1240[0], _e1240[1], _e1240[2], _e1240[3])), _e1250, _e1254);
                                            }
                                            let _e1257 = phi_2203_;
                                            let _e1276 = ((_e1257.member[0].x - _e300) * _e305);
                                            let _e1277 = ((_e1257.member[0].y - _e300) * _e305);
                                            let _e1278 = ((_e1257.member[0].z - _e301) * _e305);
                                            let _e1279 = ((_e1257.member[0].w - _e301) * _e305);
                                            let _e1289 = ((_e1257.member[1].x - _e366) * _e371);
                                            let _e1290 = ((_e1257.member[1].y - _e366) * _e371);
                                            let _e1291 = ((_e1257.member[1].z - _e367) * _e371);
                                            let _e1292 = ((_e1257.member[1].w - _e367) * _e371);
                                            let _e1302 = ((_e1257.member[2].x - _e432) * _e437);
                                            let _e1303 = ((_e1257.member[2].y - _e432) * _e437);
                                            let _e1304 = ((_e1257.member[2].z - _e433) * _e437);
                                            let _e1305 = ((_e1257.member[2].w - _e433) * _e437);
                                            let _e1307 = select(_e1304, _e1302, (_e1302 < _e1304));
                                            let _e1309 = select(_e1305, _e1303, (_e1303 < _e1305));
                                            let _e1311 = select(_e1304, _e1302, (_e1302 > _e1304));
                                            let _e1313 = select(_e1305, _e1303, (_e1303 > _e1305));
                                            let _e1315 = select(_e1278, _e1276, (_e1276 < _e1278));
                                            let _e1317 = select(_e1279, _e1277, (_e1277 < _e1279));
                                            let _e1319 = select(_e1291, _e1289, (_e1289 < _e1291));
                                            let _e1321 = select(_e1292, _e1290, (_e1290 < _e1292));
                                            let _e1323 = select(_e1319, _e1315, (_e1315 > _e1319));
                                            let _e1325 = select(_e1321, _e1317, (_e1317 > _e1321));
                                            let _e1327 = select(_e1307, _e1323, (_e1323 > _e1307));
                                            let _e1329 = select(_e1309, _e1325, (_e1325 > _e1309));
                                            let _e1331 = select(_e1278, _e1276, (_e1276 > _e1278));
                                            let _e1333 = select(_e1279, _e1277, (_e1277 > _e1279));
                                            let _e1335 = select(_e1291, _e1289, (_e1289 > _e1291));
                                            let _e1337 = select(_e1292, _e1290, (_e1290 > _e1292));
                                            let _e1339 = select(_e1335, _e1331, (_e1331 < _e1335));
                                            let _e1341 = select(_e1337, _e1333, (_e1333 < _e1337));
                                            let _e1346 = -(_e1307);
                                            let _e1347 = -(_e1309);
                                            let _e1354 = (select(_e1311, _e1339, (_e1339 < _e1311)) + (select(_e1346, _e1311, (_e1311 > _e1346)) * 0.0000019073523f));
                                            let _e1355 = (select(_e1313, _e1341, (_e1341 < _e1313)) + (select(_e1347, _e1313, (_e1313 > _e1347)) * 0.0000019073523f));
                                            let _e1357 = select(_e548, _e1327, (_e1327 > _e548));
                                            let _e1359 = select(_e548, _e1329, (_e1329 > _e548));
                                            let _e1364 = (_e1357 <= select(_e1207.member.member_1, _e1354, (_e1354 < _e1207.member.member_1)));
                                            let _e1365 = (_e1359 <= select(_e1207.member.member_1, _e1355, (_e1355 < _e1207.member.member_1)));
                                            let _e1366 = (_e1357 <= _e1359);
                                            if _e1364 {
                                                if _e1365 {
                                                    if _e1366 {
                                                        phi_2568_ = _e1257.member_2;
                                                    } else {
                                                        phi_2568_ = _e1257.member_1;
                                                    }
                                                    let _e1370 = phi_2568_;
                                                    let _e1372 = (_e589 % 128u);
                                                    let _e1373 = (_e1372 < 128u);
                                                    if _e1373 {
                                                    } else {
                                                        phi_3091_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1372] = _e1370;
                                                    if _e1373 {
                                                    } else {
                                                        phi_3091_ = true;
                                                        break;
                                                    }
                                                    local[_e1372] = select(_e1357, _e1359, _e1366);
                                                    if _e1366 {
                                                        phi_2595_ = _e1257.member_1;
                                                    } else {
                                                        phi_2595_ = _e1257.member_2;
                                                    }
                                                    let _e1380 = phi_2595_;
                                                    phi_2596_ = (_e589 + 1u);
                                                    phi_2597_ = _e1380;
                                                } else {
                                                    phi_2596_ = u32();
                                                    phi_2597_ = u32();
                                                }
                                                let _e1382 = phi_2596_;
                                                let _e1384 = phi_2597_;
                                                phi_2599_ = _e1382;
                                                phi_2600_ = _e1384;
                                                phi_2601_ = select(true, false, _e1365);
                                            } else {
                                                phi_2599_ = u32();
                                                phi_2600_ = u32();
                                                phi_2601_ = true;
                                            }
                                            let _e1387 = phi_2599_;
                                            let _e1389 = phi_2600_;
                                            let _e1391 = phi_2601_;
                                            if _e1391 {
                                                if _e1364 {
                                                    phi_2610_ = _e1257.member_1;
                                                } else {
                                                    phi_2610_ = _e1257.member_2;
                                                }
                                                let _e1395 = phi_2610_;
                                                phi_2615_ = select(_e1365, true, _e1364);
                                                phi_2617_ = _e1395;
                                            } else {
                                                phi_2615_ = _e587;
                                                phi_2617_ = _e1389;
                                            }
                                            let _e1398 = phi_2615_;
                                            let _e1400 = phi_2617_;
                                            phi_2622_ = type_48(_e1207.member, (_e1207.member_1 + 1u), _e1207.member_2);
                                            phi_2623_ = _e1398;
                                            phi_2624_ = select(_e1387, _e589, _e1391);
                                            phi_2625_ = _e1400;
                                        }
                                        let _e1403 = phi_2622_;
                                        let _e1405 = phi_2623_;
                                        let _e1407 = phi_2624_;
                                        let _e1409 = phi_2625_;
                                        if _e594 {
                                            phi_2633_ = _e1207;
                                        } else {
                                            phi_2633_ = _e1403;
                                        }
                                        let _e1411 = phi_2633_;
                                        phi_3094_ = _e1205;
                                        phi_2637_ = _e1411;
                                        phi_2638_ = (_e565 - 1u);
                                        phi_2639_ = select(_e1405, false, _e594);
                                        phi_2640_ = select(_e1407, _e589, _e594);
                                        phi_2641_ = select(_e1409, _e591, _e594);
                                    } else {
                                        phi_3094_ = _e561;
                                        phi_2637_ = _e563;
                                        phi_2638_ = _e565;
                                        phi_2639_ = _e587;
                                        phi_2640_ = _e589;
                                        phi_2641_ = _e591;
                                    }
                                    let _e1416 = phi_3094_;
                                    let _e1418 = phi_2637_;
                                    let _e1420 = phi_2638_;
                                    let _e1422 = phi_2639_;
                                    let _e1424 = phi_2640_;
                                    let _e1426 = phi_2641_;
                                    phi_3093_ = _e1416;
                                    phi_2642_ = _e1418;
                                    phi_2643_ = _e1420;
                                    phi_2644_ = _e1422;
                                    phi_2645_ = _e1424;
                                    phi_2646_ = _e1426;
                                } else {
                                    phi_3093_ = _e561;
                                    phi_2642_ = type_48();
                                    phi_2643_ = u32();
                                    phi_2644_ = bool();
                                    phi_2645_ = u32();
                                    phi_2646_ = u32();
                                }
                                let _e1428 = phi_3093_;
                                let _e1430 = phi_2642_;
                                let _e1432 = phi_2643_;
                                let _e1434 = phi_2644_;
                                let _e1436 = phi_2645_;
                                let _e1438 = phi_2646_;
                                phi_3092_ = _e1428;
                                phi_993_ = _e1430;
                                phi_996_ = _e1432;
                                phi_998_ = _e1434;
                                phi_1000_ = _e1436;
                                phi_1002_ = _e1438;
                                phi_2647_ = _e575;
                            } else {
                                phi_3092_ = _e561;
                                phi_993_ = type_48();
                                phi_996_ = u32();
                                phi_998_ = bool();
                                phi_1000_ = u32();
                                phi_1002_ = u32();
                                phi_2647_ = false;
                            }
                            let _e1440 = phi_3092_;
                            let _e1442 = phi_993_;
                            let _e1444 = phi_996_;
                            let _e1446 = phi_998_;
                            let _e1448 = phi_1000_;
                            let _e1450 = phi_1002_;
                            let _e1452 = phi_2647_;
                            continue;
                            continuing {
                                phi_2937_ = _e1440;
                                phi_992_ = _e1442;
                                phi_995_ = _e1444;
                                phi_997_ = _e1446;
                                phi_999_ = _e1448;
                                phi_1001_ = _e1450;
                                phi_3091_ = _e1440;
                                break if !(_e1452);
                            }
                        }
                        let _e1455 = phi_3091_;
                        if _e1455 {
                            break;
                        }
                        let _e1457 = local_2;
                        if (_e1457.member.member.member_3 != 4294967295u) {
                            let _e1463 = bitcast<u32>(_e1457.member.member.member);
                            let _e1467 = (bitcast<i32>((_e1463 >> bitcast<u32>(23i))) & 255i);
                            let _e1468 = (_e1467 + _e217);
                            if (_e1467 == 255i) {
                                phi_2706_ = _e1457.member.member.member;
                            } else {
                                if (_e1467 > 0i) {
                                    if (_e1468 > 0i) {
                                        let _e1472 = (_e1468 < 255i);
                                        if _e1472 {
                                            phi_2685_ = bitcast<f32>((_e1463 + bitcast<u32>((_e217 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_2685_ = f32();
                                        }
                                        let _e1479 = phi_2685_;
                                        phi_2687_ = _e1479;
                                        phi_2688_ = select(true, false, _e1472);
                                    } else {
                                        phi_2687_ = f32();
                                        phi_2688_ = true;
                                    }
                                    let _e1482 = phi_2687_;
                                    let _e1484 = phi_2688_;
                                    phi_2689_ = _e1482;
                                    phi_2690_ = _e1484;
                                } else {
                                    phi_2689_ = f32();
                                    phi_2690_ = true;
                                }
                                let _e1486 = phi_2689_;
                                let _e1488 = phi_2690_;
                                if _e1488 {
                                    let _e1489 = (_e1463 & 2147483648u);
                                    let _e1496 = ((_e1463 & 8388607u) | (select(0u, 1u, ((_e1463 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1500 = (_e1496 == 0u);
                                    if _e1500 {
                                        phi_2926_ = bitcast<f32>(_e1489);
                                    } else {
                                        let _e1505 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1496)), 32u, _e1500) - 8u);
                                        let _e1508 = (_e1496 << bitcast<u32>((_e1505 & 31u)));
                                        let _e1510 = ((_e1468 + select(0i, 1i, (_e1467 == 0i))) - bitcast<i32>(_e1505));
                                        if (_e1510 >= 255i) {
                                            phi_2916_ = bitcast<f32>((_e1489 | 2139095040u));
                                            phi_2917_ = f32();
                                            phi_2918_ = true;
                                        } else {
                                            let _e1512 = (_e1510 > 0i);
                                            if _e1512 {
                                                phi_2910_ = bitcast<f32>(((_e1489 | (bitcast<u32>(_e1510) << bitcast<u32>(23i))) | (_e1508 & 8388607u)));
                                                phi_2911_ = f32();
                                            } else {
                                                if (_e1510 < -24i) {
                                                    phi_2876_ = 26u;
                                                } else {
                                                    phi_2876_ = bitcast<u32>((1i - _e1510));
                                                }
                                                let _e1517 = phi_2876_;
                                                let _e1518 = (_e1517 & 31u);
                                                let _e1520 = (_e1508 >> bitcast<u32>(_e1518));
                                                let _e1524 = (_e1508 & ((1u << bitcast<u32>(_e1518)) - 1u));
                                                let _e1528 = (1u << bitcast<u32>(((_e1517 - 1u) & 31u)));
                                                if (_e1524 > _e1528) {
                                                    phi_2897_ = true;
                                                } else {
                                                    if (_e1524 == _e1528) {
                                                        phi_2894_ = ((_e1520 & 1u) == 1u);
                                                    } else {
                                                        phi_2894_ = false;
                                                    }
                                                    let _e1534 = phi_2894_;
                                                    phi_2897_ = _e1534;
                                                }
                                                let _e1536 = phi_2897_;
                                                phi_2910_ = f32();
                                                phi_2911_ = bitcast<f32>((_e1489 | (_e1520 + select(0u, 1u, _e1536))));
                                            }
                                            let _e1549 = phi_2910_;
                                            let _e1551 = phi_2911_;
                                            phi_2916_ = _e1549;
                                            phi_2917_ = _e1551;
                                            phi_2918_ = _e1512;
                                        }
                                        let _e1555 = phi_2916_;
                                        let _e1557 = phi_2917_;
                                        let _e1559 = phi_2918_;
                                        phi_2926_ = select(_e1557, _e1555, _e1559);
                                    }
                                    let _e1563 = phi_2926_;
                                    phi_2705_ = _e1563;
                                } else {
                                    phi_2705_ = _e1486;
                                }
                                let _e1565 = phi_2705_;
                                phi_2706_ = _e1565;
                            }
                            let _e1567 = phi_2706_;
                            let _e1568 = bitcast<u32>(_e1567);
                            if ((_e1568 & 2147483647u) >= 2139095040u) {
                                phi_2718_ = bitcast<f32>(((_e1568 & 2147483648u) | 2139095039u));
                            } else {
                                phi_2718_ = _e1567;
                            }
                            let _e1575 = phi_2718_;
                            phi_2723_ = type_22(_e1575, _e1457.member.member.member_1, _e1457.member.member.member_2, _e1457.member.member.member_3);
                        } else {
                            phi_2723_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1580 = phi_2723_;
                        if _e93 {
                        } else {
                            break;
                        }
                        global_4.member[_e91] = _e1580;
                        let _e1584 = local_3;
                        if _e94 {
                        } else {
                            break;
                        }
                        global_5.member[_e91] = _e1584.member_1;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e1589 = select(0u, 1u, (_e161 <= _e171));
                        if (_e1589 > 0u) {
                            let _e1591 = (1u < _e87);
                            if _e1591 {
                                if (0u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1595 = atomicAdd((&global_6.member[0u]), _e1589);
                                if ((_e1595 + _e1589) < _e1595) {
                                    if _e1591 {
                                    } else {
                                        break;
                                    }
                                    let _e1600 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1603 = select(0u, 1u, (_e1580.member_3 != 4294967295u));
                        if (_e1603 > 0u) {
                            let _e1605 = (3u < _e87);
                            if _e1605 {
                                if (2u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1609 = atomicAdd((&global_6.member[2u]), _e1603);
                                if ((_e1609 + _e1603) < _e1609) {
                                    if _e1605 {
                                    } else {
                                        break;
                                    }
                                    let _e1614 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1584.member_1 > 0u) {
                            let _e1616 = (5u < _e87);
                            if _e1616 {
                                if (4u < _e87) {
                                } else {
                                    break;
                                }
                                let _e1620 = atomicAdd((&global_6.member[4u]), _e1584.member_1);
                                if ((_e1620 + _e1584.member_1) < _e1620) {
                                    if _e1616 {
                                    } else {
                                        break;
                                    }
                                    let _e1625 = atomicAdd((&global_6.member[5u]), 1u);
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
