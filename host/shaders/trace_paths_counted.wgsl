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

struct type_42 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_48 {
    member: type_42,
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
    var phi_368_: i32;
    var phi_369_: i32;
    var phi_379_: bool;
    var phi_389_: u32;
    var phi_390_: u32;
    var phi_392_: bool;
    var phi_397_: u32;
    var phi_429_: i32;
    var phi_447_: f32;
    var phi_453_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_571_: f32;
    var phi_577_: f32;
    var phi_617_: f32;
    var phi_623_: f32;
    var phi_675_: f32;
    var phi_686_: f32;
    var phi_695_: f32;
    var phi_701_: f32;
    var phi_741_: f32;
    var phi_747_: f32;
    var phi_799_: f32;
    var phi_810_: f32;
    var phi_865_: i32;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_925_: i32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_2822_: bool;
    var phi_977_: type_48;
    var phi_980_: u32;
    var phi_982_: u32;
    var phi_984_: bool;
    var phi_986_: u32;
    var phi_997_: bool;
    var phi_1029_: u32;
    var phi_1030_: bool;
    var phi_1031_: u32;
    var phi_2123_: type_47;
    var phi_2467_: u32;
    var phi_2495_: u32;
    var phi_2496_: u32;
    var phi_2497_: u32;
    var phi_2499_: u32;
    var phi_2500_: u32;
    var phi_2501_: bool;
    var phi_2510_: u32;
    var phi_2515_: u32;
    var phi_2516_: bool;
    var phi_1046_: type_48;
    var phi_1049_: type_7;
    var phi_1050_: type_7;
    var phi_1072_: type_7;
    var phi_1096_: u32;
    var phi_1185_: array<array<f32, 3>, 3>;
    var phi_1302_: bool;
    var phi_1331_: bool;
    var phi_1732_: f32;
    var phi_1733_: f32;
    var phi_1734_: f32;
    var phi_1735_: f32;
    var phi_1736_: vec3<f32>;
    var phi_1737_: vec3<f32>;
    var phi_1738_: vec3<f32>;
    var phi_1739_: vec3<f32>;
    var phi_1770_: bool;
    var phi_1779_: vec3<f32>;
    var phi_1944_: f32;
    var phi_1946_: f32;
    var phi_1947_: bool;
    var phi_1967_: f32;
    var phi_1968_: f32;
    var phi_1991_: type_22;
    var phi_1993_: type_22;
    var phi_1994_: bool;
    var phi_1998_: type_22;
    var phi_1999_: type_22;
    var phi_2000_: type_22;
    var phi_2001_: bool;
    var phi_2005_: type_22;
    var phi_2006_: bool;
    var phi_2007_: type_22;
    var phi_2008_: bool;
    var phi_2009_: bool;
    var phi_2010_: type_22;
    var phi_2011_: bool;
    var phi_2012_: bool;
    var phi_2020_: type_22;
    var phi_2021_: bool;
    var phi_2025_: type_22;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2058_: type_48;
    var phi_2059_: type_48;
    var phi_2060_: type_48;
    var phi_1047_: type_48;
    var phi_2816_: bool;
    var phi_2980_: bool;
    var phi_2518_: type_48;
    var phi_2519_: u32;
    var phi_2520_: bool;
    var phi_2521_: u32;
    var phi_2979_: bool;
    var phi_2522_: type_48;
    var phi_2523_: u32;
    var phi_2524_: u32;
    var phi_2525_: bool;
    var phi_2526_: u32;
    var phi_2978_: bool;
    var phi_2527_: type_48;
    var phi_2528_: u32;
    var phi_2529_: u32;
    var phi_2530_: bool;
    var phi_2531_: u32;
    var phi_2977_: bool;
    var phi_978_: type_48;
    var phi_981_: u32;
    var phi_983_: u32;
    var phi_985_: bool;
    var phi_987_: u32;
    var phi_2532_: bool;
    var phi_2976_: bool;
    var local_2: type_48;
    var phi_2570_: f32;
    var phi_2572_: f32;
    var phi_2573_: bool;
    var phi_2574_: f32;
    var phi_2575_: bool;
    var phi_2761_: u32;
    var phi_2779_: bool;
    var phi_2782_: bool;
    var phi_2795_: f32;
    var phi_2796_: f32;
    var phi_2801_: f32;
    var phi_2802_: f32;
    var phi_2803_: bool;
    var phi_2811_: f32;
    var phi_2590_: f32;
    var phi_2591_: f32;
    var phi_2603_: f32;
    var phi_2608_: type_22;
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
                                phi_368_ = (bitcast<i32>((_e180 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_368_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e180)), 32u, (_e180 == 0u))));
                            }
                            let _e194 = phi_368_;
                            phi_369_ = _e194;
                        } else {
                            phi_369_ = 0i;
                        }
                        let _e196 = phi_369_;
                        let _e197 = (_e106 == _e150);
                        if _e197 {
                            phi_379_ = true;
                        } else {
                            phi_379_ = (_e114 == _e150);
                        }
                        let _e200 = phi_379_;
                        let _e201 = select(1u, 0u, _e197);
                        if _e200 {
                            let _e202 = (_e201 + 1u);
                            phi_389_ = _e202;
                            phi_390_ = _e202;
                            phi_392_ = select(true, false, (_e202 == 2u));
                        } else {
                            phi_389_ = u32();
                            phi_390_ = 0u;
                            phi_392_ = true;
                        }
                        let _e206 = phi_389_;
                        let _e208 = phi_390_;
                        let _e210 = phi_392_;
                        if _e210 {
                            phi_397_ = (_e208 + 1u);
                        } else {
                            phi_397_ = 0u;
                        }
                        let _e214 = phi_397_;
                        let _e215 = select(_e206, _e208, _e210);
                        let _e216 = select(_e201, select(2u, _e201, _e200), _e210);
                        let _e217 = -(_e196);
                        if (_e217 < -126i) {
                            phi_429_ = -126i;
                        } else {
                            phi_429_ = select(_e217, 127i, (_e217 > 127i));
                        }
                        let _e222 = phi_429_;
                        let _e227 = bitcast<f32>((bitcast<u32>((_e222 + 127i)) << bitcast<u32>(23i)));
                        let _e233 = bitcast<f32>((bitcast<u32>(((_e217 - _e222) + 127i)) << bitcast<u32>(23i)));
                        let _e238 = global_3.member[_e91].member.member;
                        let _e239 = (_e215 == 0u);
                        if _e239 {
                            phi_447_ = _e238[0];
                        } else {
                            phi_447_ = _e238[1];
                        }
                        let _e243 = phi_447_;
                        let _e244 = (_e215 == 2u);
                        if _e244 {
                            phi_453_ = _e238[2];
                        } else {
                            phi_453_ = _e243;
                        }
                        let _e247 = phi_453_;
                        let _e248 = bitcast<u32>(_e247);
                        let _e250 = ((_e248 & 2139095040u) != 0u);
                        let _e262 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e247, _e250) * select(0.00000011920929f, 1f, _e250));
                        let _e263 = global_3.member[_e91].member.member_2;
                        if _e239 {
                            phi_493_ = _e263[0];
                        } else {
                            phi_493_ = _e263[1];
                        }
                        let _e267 = phi_493_;
                        if _e244 {
                            phi_499_ = _e263[2];
                        } else {
                            phi_499_ = _e267;
                        }
                        let _e270 = phi_499_;
                        let _e271 = bitcast<u32>(_e270);
                        let _e273 = ((_e271 & 2139095040u) != 0u);
                        let _e287 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e271 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e271 & 2147483648u))), _e270, _e273) * _e227) * select(0.00000011920929f, 1f, _e273)) * _e233);
                        let _e291 = (bitcast<f32>((bitcast<u32>(_e287) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e291 {
                            let _e295 = (bitcast<f32>((bitcast<u32>(_e262) & 2147483647u)) * 0.00000011920929f);
                            phi_551_ = select(0.00000000000011368684f, _e295, (_e295 > 0.00000000000011368684f));
                        } else {
                            phi_551_ = 0f;
                        }
                        let _e299 = phi_551_;
                        let _e300 = (_e262 + _e299);
                        let _e301 = (_e262 - _e299);
                        let _e302 = select(_e287, 0f, _e291);
                        if _e291 {
                            phi_562_ = 38685626000000000000000000f;
                        } else {
                            phi_562_ = (1f / _e287);
                        }
                        let _e305 = phi_562_;
                        let _e306 = (_e214 == 0u);
                        if _e306 {
                            phi_571_ = _e238[0];
                        } else {
                            phi_571_ = _e238[1];
                        }
                        let _e310 = phi_571_;
                        let _e311 = (_e214 == 2u);
                        if _e311 {
                            phi_577_ = _e238[2];
                        } else {
                            phi_577_ = _e310;
                        }
                        let _e314 = phi_577_;
                        let _e315 = bitcast<u32>(_e314);
                        let _e317 = ((_e315 & 2139095040u) != 0u);
                        let _e329 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * select(0.00000011920929f, 1f, _e317));
                        if _e306 {
                            phi_617_ = _e263[0];
                        } else {
                            phi_617_ = _e263[1];
                        }
                        let _e333 = phi_617_;
                        if _e311 {
                            phi_623_ = _e263[2];
                        } else {
                            phi_623_ = _e333;
                        }
                        let _e336 = phi_623_;
                        let _e337 = bitcast<u32>(_e336);
                        let _e339 = ((_e337 & 2139095040u) != 0u);
                        let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e227) * select(0.00000011920929f, 1f, _e339)) * _e233);
                        let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e357 {
                            let _e361 = (bitcast<f32>((bitcast<u32>(_e329) & 2147483647u)) * 0.00000011920929f);
                            phi_675_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                        } else {
                            phi_675_ = 0f;
                        }
                        let _e365 = phi_675_;
                        let _e366 = (_e329 + _e365);
                        let _e367 = (_e329 - _e365);
                        let _e368 = select(_e353, 0f, _e357);
                        if _e357 {
                            phi_686_ = 38685626000000000000000000f;
                        } else {
                            phi_686_ = (1f / _e353);
                        }
                        let _e371 = phi_686_;
                        let _e372 = (_e216 == 0u);
                        if _e372 {
                            phi_695_ = _e238[0];
                        } else {
                            phi_695_ = _e238[1];
                        }
                        let _e376 = phi_695_;
                        let _e377 = (_e216 == 2u);
                        if _e377 {
                            phi_701_ = _e238[2];
                        } else {
                            phi_701_ = _e376;
                        }
                        let _e380 = phi_701_;
                        let _e381 = bitcast<u32>(_e380);
                        let _e383 = ((_e381 & 2139095040u) != 0u);
                        let _e395 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * select(0.00000011920929f, 1f, _e383));
                        if _e372 {
                            phi_741_ = _e263[0];
                        } else {
                            phi_741_ = _e263[1];
                        }
                        let _e399 = phi_741_;
                        if _e377 {
                            phi_747_ = _e263[2];
                        } else {
                            phi_747_ = _e399;
                        }
                        let _e402 = phi_747_;
                        let _e403 = bitcast<u32>(_e402);
                        let _e405 = ((_e403 & 2139095040u) != 0u);
                        let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e227) * select(0.00000011920929f, 1f, _e405)) * _e233);
                        let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e423 {
                            let _e427 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                            phi_799_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                        } else {
                            phi_799_ = 0f;
                        }
                        let _e431 = phi_799_;
                        let _e432 = (_e395 + _e431);
                        let _e433 = (_e395 - _e431);
                        let _e434 = select(_e419, 0f, _e423);
                        if _e423 {
                            phi_810_ = 38685626000000000000000000f;
                        } else {
                            phi_810_ = (1f / _e419);
                        }
                        let _e437 = phi_810_;
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
                                phi_865_ = 255i;
                            } else {
                                phi_865_ = (((_e463 + select(0i, 1i, (_e463 == 0i))) - _e470) + _e196);
                            }
                            let _e478 = phi_865_;
                            let _e488 = (_e478 <= 0i);
                            if _e488 {
                                phi_888_ = u32();
                            } else {
                                if _e467 {
                                    phi_887_ = u32();
                                } else {
                                    phi_887_ = select(((bitcast<u32>(_e478) << bitcast<u32>(23i)) | ((_e460 << bitcast<u32>(((_e470 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e478 >= 255i));
                                }
                                let _e492 = phi_887_;
                                phi_888_ = _e492;
                            }
                            let _e494 = phi_888_;
                            let _e506 = ((_e173 & 8388607u) | (select(0u, 1u, ((_e173 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e509 = bitcast<i32>((_e173 >> bitcast<u32>(23i)));
                            let _e513 = (_e506 == 0u);
                            let _e516 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e506)), 32u, _e513)) - 8i);
                            if (_e509 == 255i) {
                                phi_925_ = 255i;
                            } else {
                                phi_925_ = (((_e509 + select(0i, 1i, (_e509 == 0i))) - _e516) + _e196);
                            }
                            let _e524 = phi_925_;
                            let _e534 = (_e524 <= 0i);
                            if _e534 {
                                phi_948_ = u32();
                            } else {
                                if _e513 {
                                    phi_947_ = u32();
                                } else {
                                    phi_947_ = select(((bitcast<u32>(_e524) << bitcast<u32>(23i)) | ((_e506 << bitcast<u32>(((_e516 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e524 >= 255i));
                                }
                                let _e538 = phi_947_;
                                phi_948_ = _e538;
                            }
                            let _e540 = phi_948_;
                            phi_956_ = bitcast<f32>(((_e172 & 2147483648u) | select(_e540, 0u, select(_e513, true, _e534))));
                            phi_957_ = bitcast<f32>(((_e162 & 2147483648u) | select(_e494, 0u, select(_e467, true, _e488))));
                        } else {
                            phi_956_ = 0f;
                            phi_957_ = 1f;
                        }
                        let _e546 = phi_956_;
                        let _e548 = phi_957_;
                        if _e92 {
                        } else {
                            break;
                        }
                        let _e554 = global_3.member[_e91].member_2;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_2822_ = false;
                        phi_977_ = type_48(type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e546), 0u, 0u);
                        phi_980_ = select(0u, 2147483648u, (_e77 == 0u));
                        phi_982_ = ((3u * _e77) + 1u);
                        phi_984_ = (_e548 <= _e546);
                        phi_986_ = 0u;
                        loop {
                            let _e561 = phi_2822_;
                            let _e563 = phi_977_;
                            let _e565 = phi_980_;
                            let _e567 = phi_982_;
                            let _e569 = phi_984_;
                            let _e571 = phi_986_;
                            local_2 = _e563;
                            local_3 = _e563;
                            if _e569 {
                                phi_997_ = true;
                            } else {
                                phi_997_ = (_e571 > 0u);
                            }
                            let _e574 = phi_997_;
                            if _e574 {
                                let _e575 = (_e567 > 0u);
                                if _e575 {
                                    if _e569 {
                                        phi_1029_ = _e565;
                                        phi_1030_ = _e569;
                                        phi_1031_ = _e571;
                                    } else {
                                        let _e576 = (_e571 - 1u);
                                        let _e577 = (_e576 % 128u);
                                        let _e578 = (_e577 < 128u);
                                        if _e578 {
                                        } else {
                                            phi_2976_ = true;
                                            break;
                                        }
                                        let _e580 = local_1[_e577];
                                        if _e578 {
                                        } else {
                                            phi_2976_ = true;
                                            break;
                                        }
                                        let _e582 = local[_e577];
                                        phi_1029_ = _e580;
                                        phi_1030_ = (_e582 <= _e563.member.member_1);
                                        phi_1031_ = _e576;
                                    }
                                    let _e587 = phi_1029_;
                                    let _e589 = phi_1030_;
                                    let _e591 = phi_1031_;
                                    if _e589 {
                                        if ((_e587 & 2147483648u) != 0u) {
                                            phi_1046_ = _e563;
                                            phi_1049_ = type_7(0u, ((_e587 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e796 = phi_1046_;
                                                let _e798 = phi_1049_;
                                                local_4 = _e796;
                                                if (_e798.member < _e798.member_1) {
                                                    phi_1050_ = type_7((_e798.member + 1u), _e798.member_1);
                                                    phi_1072_ = type_7(1u, _e798.member);
                                                } else {
                                                    phi_1050_ = _e798;
                                                    phi_1072_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e811 = phi_1050_;
                                                let _e813 = phi_1072_;
                                                let _e817 = (bitcast<i32>(_e813.member) != 0i);
                                                if _e817 {
                                                    let _e823 = type_48(_e796.member, _e796.member_1, (_e796.member_2 + 1u));
                                                    let _e824 = ((_e587 & 268435455u) + _e813.member_1);
                                                    let _e825 = (_e824 < _e79);
                                                    if _e825 {
                                                        if _e825 {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e829 = global_1.member[_e824].member_1;
                                                        phi_1096_ = _e829;
                                                    } else {
                                                        phi_1096_ = 4294967295u;
                                                    }
                                                    let _e831 = phi_1096_;
                                                    if (_e824 >= _e79) {
                                                        phi_1185_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e825 {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e833 = (_e215 % 3u);
                                                        let _e834 = (_e214 % 3u);
                                                        let _e835 = (_e216 % 3u);
                                                        if (_e833 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e841 = global_1.member[_e824].member[_e833];
                                                        if (_e834 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e847 = global_1.member[_e824].member[_e834];
                                                        if (_e835 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e853 = global_1.member[_e824].member[_e835];
                                                        let _e855 = (3u + _e833);
                                                        if (_e855 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e861 = global_1.member[_e824].member[_e855];
                                                        let _e862 = (3u + _e834);
                                                        if (_e862 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e868 = global_1.member[_e824].member[_e862];
                                                        let _e869 = (3u + _e835);
                                                        if (_e869 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e875 = global_1.member[_e824].member[_e869];
                                                        let _e877 = (6u + _e833);
                                                        if (_e877 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e883 = global_1.member[_e824].member[_e877];
                                                        let _e884 = (6u + _e834);
                                                        if (_e884 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e890 = global_1.member[_e824].member[_e884];
                                                        let _e891 = (6u + _e835);
                                                        if (_e891 < 9u) {
                                                        } else {
                                                            phi_2816_ = true;
                                                            break;
                                                        }
                                                        let _e897 = global_1.member[_e824].member[_e891];
                                                        phi_1185_ = array<array<f32, 3>, 3>(array<f32, 3>(_e841, _e847, _e853), array<f32, 3>(_e861, _e868, _e875), array<f32, 3>(_e883, _e890, _e897));
                                                    }
                                                    let _e901 = phi_1185_;
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
                                                            phi_2010_ = type_22();
                                                            phi_2011_ = true;
                                                            phi_2012_ = false;
                                                        } else {
                                                            let _e977 = select(_e926, _e913, (_e913 < _e926));
                                                            if (select(_e939, _e977, (_e977 < _e939)) > 0f) {
                                                                phi_1302_ = true;
                                                            } else {
                                                                let _e982 = select(_e926, _e913, (_e913 > _e926));
                                                                phi_1302_ = (select(_e939, _e982, (_e982 > _e939)) < 0f);
                                                            }
                                                            let _e987 = phi_1302_;
                                                            if _e987 {
                                                                phi_2007_ = type_22();
                                                                phi_2008_ = true;
                                                                phi_2009_ = false;
                                                            } else {
                                                                let _e989 = select(_e929, _e916, (_e916 < _e929));
                                                                if (select(_e942, _e989, (_e989 < _e942)) > 0f) {
                                                                    phi_1331_ = true;
                                                                } else {
                                                                    let _e994 = select(_e929, _e916, (_e916 > _e929));
                                                                    phi_1331_ = (select(_e942, _e994, (_e994 > _e942)) < 0f);
                                                                }
                                                                let _e999 = phi_1331_;
                                                                if _e999 {
                                                                    phi_2005_ = type_22();
                                                                    phi_2006_ = false;
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
                                                                        phi_2000_ = type_22();
                                                                        phi_2001_ = true;
                                                                    } else {
                                                                        let _e1064 = (_e1062 > _e796.member.member_1);
                                                                        if _e1064 {
                                                                            phi_1999_ = type_22();
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
                                                                                phi_1732_ = _e929;
                                                                                phi_1733_ = _e926;
                                                                                phi_1734_ = _e916;
                                                                                phi_1735_ = _e913;
                                                                                phi_1736_ = _e1065;
                                                                                phi_1737_ = _e1079;
                                                                                phi_1738_ = _e1075;
                                                                                phi_1739_ = _e1071;
                                                                            } else {
                                                                                let _e1124 = (_e1105 == _e1122);
                                                                                let _e1129 = vec3(_e1124);
                                                                                phi_1732_ = select(_e916, _e942, _e1124);
                                                                                phi_1733_ = select(_e913, _e939, _e1124);
                                                                                phi_1734_ = select(_e942, _e929, _e1124);
                                                                                phi_1735_ = select(_e939, _e926, _e1124);
                                                                                phi_1736_ = select(_e1067, _e1066, _e1129);
                                                                                phi_1737_ = select(_e1075, _e1071, _e1129);
                                                                                phi_1738_ = select(_e1071, _e1079, _e1129);
                                                                                phi_1739_ = select(_e1079, _e1075, _e1129);
                                                                            }
                                                                            let _e1135 = phi_1732_;
                                                                            let _e1137 = phi_1733_;
                                                                            let _e1139 = phi_1734_;
                                                                            let _e1141 = phi_1735_;
                                                                            let _e1143 = phi_1736_;
                                                                            let _e1145 = phi_1737_;
                                                                            let _e1147 = phi_1738_;
                                                                            let _e1149 = phi_1739_;
                                                                            let _e1156 = ((_e1147.y * _e1145.z) - (_e1145.y * _e1147.z));
                                                                            let _e1161 = ((_e1147.z * _e1145.x) - (_e1145.z * _e1147.x));
                                                                            let _e1164 = ((_e1147.x * _e1145.y) - (_e1145.x * _e1147.y));
                                                                            if (_e964 >= _e968) {
                                                                                phi_1770_ = select(true, false, (_e964 >= _e972));
                                                                            } else {
                                                                                phi_1770_ = true;
                                                                            }
                                                                            let _e1169 = phi_1770_;
                                                                            if _e1169 {
                                                                                phi_1779_ = select(_e1067, _e1066, vec3((_e968 >= _e972)));
                                                                            } else {
                                                                                phi_1779_ = _e1065;
                                                                            }
                                                                            let _e1174 = phi_1779_;
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
                                                                                    phi_1944_ = (_e1185 / _e1190);
                                                                                } else {
                                                                                    phi_1944_ = f32();
                                                                                }
                                                                                let _e1295 = phi_1944_;
                                                                                phi_1946_ = _e1295;
                                                                                phi_1947_ = select(true, false, _e1292);
                                                                            } else {
                                                                                phi_1946_ = f32();
                                                                                phi_1947_ = true;
                                                                            }
                                                                            let _e1298 = phi_1946_;
                                                                            let _e1300 = phi_1947_;
                                                                            if _e1300 {
                                                                                let _e1308 = (((_e1156 * (_e1217 - (_e302 * _e1220))) + (_e1161 * (_e1218 - (_e368 * _e1220)))) / _e1190);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u)) <= _e1122) {
                                                                                    phi_1967_ = (_e1220 + _e1308);
                                                                                } else {
                                                                                    phi_1967_ = _e1220;
                                                                                }
                                                                                let _e1315 = phi_1967_;
                                                                                phi_1968_ = _e1315;
                                                                            } else {
                                                                                phi_1968_ = _e1298;
                                                                            }
                                                                            let _e1317 = phi_1968_;
                                                                            let _e1319 = select(_e1055, _e1317, (_e1317 < _e1055));
                                                                            let _e1321 = select(_e1047, _e1319, (_e1319 > _e1047));
                                                                            if (_e1321 >= _e548) {
                                                                                let _e1323 = (_e1321 <= _e796.member.member_1);
                                                                                if _e1323 {
                                                                                    let _e1324 = (1f / _e974);
                                                                                    phi_1991_ = type_22(_e1321, (_e968 * _e1324), (_e972 * _e1324), _e831);
                                                                                } else {
                                                                                    phi_1991_ = type_22();
                                                                                }
                                                                                let _e1329 = phi_1991_;
                                                                                phi_1993_ = _e1329;
                                                                                phi_1994_ = select(true, false, _e1323);
                                                                            } else {
                                                                                phi_1993_ = type_22();
                                                                                phi_1994_ = true;
                                                                            }
                                                                            let _e1332 = phi_1993_;
                                                                            let _e1334 = phi_1994_;
                                                                            if _e1334 {
                                                                                phi_1998_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1998_ = _e1332;
                                                                            }
                                                                            let _e1336 = phi_1998_;
                                                                            phi_1999_ = _e1336;
                                                                        }
                                                                        let _e1338 = phi_1999_;
                                                                        phi_2000_ = _e1338;
                                                                        phi_2001_ = _e1064;
                                                                    }
                                                                    let _e1340 = phi_2000_;
                                                                    let _e1342 = phi_2001_;
                                                                    phi_2005_ = _e1340;
                                                                    phi_2006_ = _e1342;
                                                                }
                                                                let _e1344 = phi_2005_;
                                                                let _e1346 = phi_2006_;
                                                                phi_2007_ = _e1344;
                                                                phi_2008_ = _e999;
                                                                phi_2009_ = _e1346;
                                                            }
                                                            let _e1348 = phi_2007_;
                                                            let _e1350 = phi_2008_;
                                                            let _e1352 = phi_2009_;
                                                            phi_2010_ = _e1348;
                                                            phi_2011_ = _e1350;
                                                            phi_2012_ = _e1352;
                                                        }
                                                        let _e1354 = phi_2010_;
                                                        let _e1356 = phi_2011_;
                                                        let _e1358 = phi_2012_;
                                                        phi_2020_ = _e1354;
                                                        phi_2021_ = select(_e1358, true, _e1356);
                                                    } else {
                                                        phi_2020_ = type_22();
                                                        phi_2021_ = true;
                                                    }
                                                    let _e1361 = phi_2020_;
                                                    let _e1363 = phi_2021_;
                                                    if _e1363 {
                                                        phi_2025_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2025_ = _e1361;
                                                    }
                                                    let _e1365 = phi_2025_;
                                                    if (_e1365.member_3 != 4294967295u) {
                                                        if (_e831 != _e554) {
                                                            if (_e1365.member < _e796.member.member.member) {
                                                                phi_2051_ = true;
                                                            } else {
                                                                if (_e1365.member == _e796.member.member.member) {
                                                                    phi_2050_ = (_e1365.member_3 < _e796.member.member.member_3);
                                                                } else {
                                                                    phi_2050_ = false;
                                                                }
                                                                let _e1380 = phi_2050_;
                                                                phi_2051_ = _e1380;
                                                            }
                                                            let _e1382 = phi_2051_;
                                                            if _e1382 {
                                                                phi_2058_ = type_48(type_42(_e1365, _e1365.member), _e823.member_1, _e823.member_2);
                                                            } else {
                                                                phi_2058_ = _e823;
                                                            }
                                                            let _e1389 = phi_2058_;
                                                            phi_2059_ = _e1389;
                                                        } else {
                                                            phi_2059_ = _e823;
                                                        }
                                                        let _e1391 = phi_2059_;
                                                        phi_2060_ = _e1391;
                                                    } else {
                                                        phi_2060_ = _e823;
                                                    }
                                                    let _e1393 = phi_2060_;
                                                    phi_1047_ = _e1393;
                                                } else {
                                                    phi_1047_ = type_48();
                                                }
                                                let _e1395 = phi_1047_;
                                                continue;
                                                continuing {
                                                    phi_1046_ = _e1395;
                                                    phi_1049_ = _e811;
                                                    phi_2816_ = _e561;
                                                    break if !(_e817);
                                                }
                                            }
                                            let _e1398 = phi_2816_;
                                            phi_2976_ = _e1398;
                                            if _e1398 {
                                                break;
                                            }
                                            phi_2980_ = _e1398;
                                            let _e1726 = local_4;
                                            phi_2518_ = _e1726;
                                            phi_2519_ = _e587;
                                            phi_2520_ = false;
                                            phi_2521_ = _e591;
                                        } else {
                                            if (_e587 >= _e77) {
                                                phi_2123_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e587 < _e77) {
                                                } else {
                                                    phi_2976_ = true;
                                                    break;
                                                }
                                                let _e607 = (_e215 % 3u);
                                                if (_e607 < 3u) {
                                                } else {
                                                    phi_2976_ = true;
                                                    break;
                                                }
                                                let _e613 = global_2.member[_e587].member[_e607];
                                                let _e619 = (_e214 % 3u);
                                                if (_e619 < 3u) {
                                                } else {
                                                    phi_2976_ = true;
                                                    break;
                                                }
                                                let _e625 = global_2.member[_e587].member[_e619];
                                                let _e631 = (_e216 % 3u);
                                                if (_e631 < 3u) {
                                                } else {
                                                    phi_2976_ = true;
                                                    break;
                                                }
                                                let _e637 = global_2.member[_e587].member[_e631];
                                                let _e647 = global_2.member[_e587].member_1;
                                                let _e651 = global_2.member[_e587].member_2;
                                                phi_2123_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e613[0], _e613[1], _e613[2], _e613[3]), vec4<f32>(_e625[0], _e625[1], _e625[2], _e625[3]), vec4<f32>(_e637[0], _e637[1], _e637[2], _e637[3])), _e647, _e651);
                                            }
                                            let _e654 = phi_2123_;
                                            let _e667 = ((_e654.member[0].x - _e300) * _e305);
                                            let _e668 = ((_e654.member[0].y - _e300) * _e305);
                                            let _e669 = ((_e654.member[0].z - _e301) * _e305);
                                            let _e670 = ((_e654.member[0].w - _e301) * _e305);
                                            let _e680 = ((_e654.member[1].x - _e366) * _e371);
                                            let _e681 = ((_e654.member[1].y - _e366) * _e371);
                                            let _e682 = ((_e654.member[1].z - _e367) * _e371);
                                            let _e683 = ((_e654.member[1].w - _e367) * _e371);
                                            let _e693 = ((_e654.member[2].x - _e432) * _e437);
                                            let _e694 = ((_e654.member[2].y - _e432) * _e437);
                                            let _e695 = ((_e654.member[2].z - _e433) * _e437);
                                            let _e696 = ((_e654.member[2].w - _e433) * _e437);
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
                                                        phi_2467_ = _e654.member_2;
                                                    } else {
                                                        phi_2467_ = _e654.member_1;
                                                    }
                                                    let _e761 = phi_2467_;
                                                    let _e764 = (_e591 % 128u);
                                                    let _e765 = (_e764 < 128u);
                                                    if _e765 {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    local_1[_e764] = _e761;
                                                    if _e765 {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    local[_e764] = select(_e750, _e748, (_e748 > _e750));
                                                    if _e757 {
                                                        phi_2495_ = _e654.member_1;
                                                    } else {
                                                        phi_2495_ = _e654.member_2;
                                                    }
                                                    let _e772 = phi_2495_;
                                                    phi_2496_ = _e772;
                                                    phi_2497_ = (_e591 + 1u);
                                                } else {
                                                    phi_2496_ = u32();
                                                    phi_2497_ = u32();
                                                }
                                                let _e774 = phi_2496_;
                                                let _e776 = phi_2497_;
                                                phi_2499_ = _e774;
                                                phi_2500_ = _e776;
                                                phi_2501_ = select(true, false, _e756);
                                            } else {
                                                phi_2499_ = u32();
                                                phi_2500_ = u32();
                                                phi_2501_ = true;
                                            }
                                            let _e779 = phi_2499_;
                                            let _e781 = phi_2500_;
                                            let _e783 = phi_2501_;
                                            if _e783 {
                                                if _e755 {
                                                    phi_2510_ = _e654.member_1;
                                                } else {
                                                    phi_2510_ = _e654.member_2;
                                                }
                                                let _e787 = phi_2510_;
                                                phi_2515_ = _e787;
                                                phi_2516_ = select(_e756, true, _e755);
                                            } else {
                                                phi_2515_ = _e779;
                                                phi_2516_ = _e589;
                                            }
                                            let _e790 = phi_2515_;
                                            let _e792 = phi_2516_;
                                            phi_2980_ = _e561;
                                            phi_2518_ = type_48(_e563.member, (_e563.member_1 + 1u), _e563.member_2);
                                            phi_2519_ = _e790;
                                            phi_2520_ = _e792;
                                            phi_2521_ = select(_e781, _e591, _e783);
                                        }
                                        let _e1400 = phi_2980_;
                                        let _e1402 = phi_2518_;
                                        let _e1404 = phi_2519_;
                                        let _e1406 = phi_2520_;
                                        let _e1408 = phi_2521_;
                                        phi_2979_ = _e1400;
                                        phi_2522_ = _e1402;
                                        phi_2523_ = _e1404;
                                        phi_2524_ = (_e567 - 1u);
                                        phi_2525_ = _e1406;
                                        phi_2526_ = _e1408;
                                    } else {
                                        phi_2979_ = _e561;
                                        phi_2522_ = _e563;
                                        phi_2523_ = _e587;
                                        phi_2524_ = _e567;
                                        phi_2525_ = _e589;
                                        phi_2526_ = _e591;
                                    }
                                    let _e1410 = phi_2979_;
                                    let _e1412 = phi_2522_;
                                    let _e1414 = phi_2523_;
                                    let _e1416 = phi_2524_;
                                    let _e1418 = phi_2525_;
                                    let _e1420 = phi_2526_;
                                    phi_2978_ = _e1410;
                                    phi_2527_ = _e1412;
                                    phi_2528_ = _e1414;
                                    phi_2529_ = _e1416;
                                    phi_2530_ = _e1418;
                                    phi_2531_ = _e1420;
                                } else {
                                    phi_2978_ = _e561;
                                    phi_2527_ = type_48();
                                    phi_2528_ = u32();
                                    phi_2529_ = u32();
                                    phi_2530_ = bool();
                                    phi_2531_ = u32();
                                }
                                let _e1422 = phi_2978_;
                                let _e1424 = phi_2527_;
                                let _e1426 = phi_2528_;
                                let _e1428 = phi_2529_;
                                let _e1430 = phi_2530_;
                                let _e1432 = phi_2531_;
                                phi_2977_ = _e1422;
                                phi_978_ = _e1424;
                                phi_981_ = _e1426;
                                phi_983_ = _e1428;
                                phi_985_ = _e1430;
                                phi_987_ = _e1432;
                                phi_2532_ = _e575;
                            } else {
                                phi_2977_ = _e561;
                                phi_978_ = type_48();
                                phi_981_ = u32();
                                phi_983_ = u32();
                                phi_985_ = bool();
                                phi_987_ = u32();
                                phi_2532_ = false;
                            }
                            let _e1434 = phi_2977_;
                            let _e1436 = phi_978_;
                            let _e1438 = phi_981_;
                            let _e1440 = phi_983_;
                            let _e1442 = phi_985_;
                            let _e1444 = phi_987_;
                            let _e1446 = phi_2532_;
                            continue;
                            continuing {
                                phi_2822_ = _e1434;
                                phi_977_ = _e1436;
                                phi_980_ = _e1438;
                                phi_982_ = _e1440;
                                phi_984_ = _e1442;
                                phi_986_ = _e1444;
                                phi_2976_ = _e1434;
                                break if !(_e1446);
                            }
                        }
                        let _e1449 = phi_2976_;
                        if _e1449 {
                            break;
                        }
                        let _e1451 = local_2;
                        if (_e1451.member.member.member_3 != 4294967295u) {
                            let _e1457 = bitcast<u32>(_e1451.member.member.member);
                            let _e1461 = (bitcast<i32>((_e1457 >> bitcast<u32>(23i))) & 255i);
                            let _e1462 = (_e1461 + _e217);
                            if (_e1461 == 255i) {
                                phi_2591_ = _e1451.member.member.member;
                            } else {
                                if (_e1461 > 0i) {
                                    if (_e1462 > 0i) {
                                        let _e1466 = (_e1462 < 255i);
                                        if _e1466 {
                                            phi_2570_ = bitcast<f32>((_e1457 + bitcast<u32>((_e217 << bitcast<u32>(23i)))));
                                        } else {
                                            phi_2570_ = f32();
                                        }
                                        let _e1473 = phi_2570_;
                                        phi_2572_ = _e1473;
                                        phi_2573_ = select(true, false, _e1466);
                                    } else {
                                        phi_2572_ = f32();
                                        phi_2573_ = true;
                                    }
                                    let _e1476 = phi_2572_;
                                    let _e1478 = phi_2573_;
                                    phi_2574_ = _e1476;
                                    phi_2575_ = _e1478;
                                } else {
                                    phi_2574_ = f32();
                                    phi_2575_ = true;
                                }
                                let _e1480 = phi_2574_;
                                let _e1482 = phi_2575_;
                                if _e1482 {
                                    let _e1483 = (_e1457 & 2147483648u);
                                    let _e1490 = ((_e1457 & 8388607u) | (select(0u, 1u, ((_e1457 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                    let _e1494 = (_e1490 == 0u);
                                    if _e1494 {
                                        phi_2811_ = bitcast<f32>(_e1483);
                                    } else {
                                        let _e1499 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1490)), 32u, _e1494) - 8u);
                                        let _e1502 = (_e1490 << bitcast<u32>((_e1499 & 31u)));
                                        let _e1504 = ((_e1462 + select(0i, 1i, (_e1461 == 0i))) - bitcast<i32>(_e1499));
                                        if (_e1504 >= 255i) {
                                            phi_2801_ = bitcast<f32>((_e1483 | 2139095040u));
                                            phi_2802_ = f32();
                                            phi_2803_ = true;
                                        } else {
                                            let _e1506 = (_e1504 > 0i);
                                            if _e1506 {
                                                phi_2795_ = bitcast<f32>(((_e1483 | (bitcast<u32>(_e1504) << bitcast<u32>(23i))) | (_e1502 & 8388607u)));
                                                phi_2796_ = f32();
                                            } else {
                                                if (_e1504 < -24i) {
                                                    phi_2761_ = 26u;
                                                } else {
                                                    phi_2761_ = bitcast<u32>((1i - _e1504));
                                                }
                                                let _e1511 = phi_2761_;
                                                let _e1512 = (_e1511 & 31u);
                                                let _e1514 = (_e1502 >> bitcast<u32>(_e1512));
                                                let _e1518 = (_e1502 & ((1u << bitcast<u32>(_e1512)) - 1u));
                                                let _e1522 = (1u << bitcast<u32>(((_e1511 - 1u) & 31u)));
                                                if (_e1518 > _e1522) {
                                                    phi_2782_ = true;
                                                } else {
                                                    if (_e1518 == _e1522) {
                                                        phi_2779_ = ((_e1514 & 1u) == 1u);
                                                    } else {
                                                        phi_2779_ = false;
                                                    }
                                                    let _e1528 = phi_2779_;
                                                    phi_2782_ = _e1528;
                                                }
                                                let _e1530 = phi_2782_;
                                                phi_2795_ = f32();
                                                phi_2796_ = bitcast<f32>((_e1483 | (_e1514 + select(0u, 1u, _e1530))));
                                            }
                                            let _e1543 = phi_2795_;
                                            let _e1545 = phi_2796_;
                                            phi_2801_ = _e1543;
                                            phi_2802_ = _e1545;
                                            phi_2803_ = _e1506;
                                        }
                                        let _e1549 = phi_2801_;
                                        let _e1551 = phi_2802_;
                                        let _e1553 = phi_2803_;
                                        phi_2811_ = select(_e1551, _e1549, _e1553);
                                    }
                                    let _e1557 = phi_2811_;
                                    phi_2590_ = _e1557;
                                } else {
                                    phi_2590_ = _e1480;
                                }
                                let _e1559 = phi_2590_;
                                phi_2591_ = _e1559;
                            }
                            let _e1561 = phi_2591_;
                            let _e1562 = bitcast<u32>(_e1561);
                            if ((_e1562 & 2147483647u) >= 2139095040u) {
                                phi_2603_ = bitcast<f32>(((_e1562 & 2147483648u) | 2139095039u));
                            } else {
                                phi_2603_ = _e1561;
                            }
                            let _e1569 = phi_2603_;
                            phi_2608_ = type_22(_e1569, _e1451.member.member.member_1, _e1451.member.member.member_2, _e1451.member.member.member_3);
                        } else {
                            phi_2608_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1574 = phi_2608_;
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
