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

struct type_51 {
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
var<storage, read_write> global_5: type_51;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_268_: u32;
    var phi_373_: i32;
    var phi_374_: i32;
    var phi_384_: bool;
    var phi_394_: u32;
    var phi_395_: u32;
    var phi_397_: bool;
    var phi_402_: u32;
    var phi_434_: i32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_556_: f32;
    var phi_567_: f32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_680_: f32;
    var phi_691_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_746_: f32;
    var phi_752_: f32;
    var phi_804_: f32;
    var phi_815_: f32;
    var phi_870_: i32;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_930_: i32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_961_: f32;
    var phi_962_: f32;
    var phi_2773_: bool;
    var phi_973_: type_42;
    var phi_976_: u32;
    var phi_978_: u32;
    var phi_980_: bool;
    var phi_982_: u32;
    var phi_993_: bool;
    var phi_1025_: u32;
    var phi_1026_: bool;
    var phi_1027_: u32;
    var phi_2112_: type_47;
    var phi_2456_: u32;
    var phi_2484_: u32;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2488_: u32;
    var phi_2489_: u32;
    var phi_2490_: bool;
    var phi_2499_: u32;
    var phi_2504_: u32;
    var phi_2505_: bool;
    var phi_1042_: type_42;
    var phi_1045_: type_7;
    var phi_1046_: type_7;
    var phi_1068_: type_7;
    var phi_1089_: u32;
    var phi_1178_: array<array<f32, 3>, 3>;
    var phi_1295_: bool;
    var phi_1324_: bool;
    var phi_1725_: f32;
    var phi_1726_: f32;
    var phi_1727_: f32;
    var phi_1728_: f32;
    var phi_1729_: vec3<f32>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1732_: vec3<f32>;
    var phi_1763_: bool;
    var phi_1772_: vec3<f32>;
    var phi_1937_: f32;
    var phi_1939_: f32;
    var phi_1940_: bool;
    var phi_1960_: f32;
    var phi_1961_: f32;
    var phi_1984_: type_22;
    var phi_1986_: type_22;
    var phi_1987_: bool;
    var phi_1991_: type_22;
    var phi_1992_: type_22;
    var phi_1993_: type_22;
    var phi_1994_: bool;
    var phi_1998_: type_22;
    var phi_1999_: bool;
    var phi_2000_: type_22;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2003_: type_22;
    var phi_2004_: bool;
    var phi_2005_: bool;
    var phi_2013_: type_22;
    var phi_2014_: bool;
    var phi_2018_: type_22;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_2050_: type_42;
    var phi_2051_: type_42;
    var phi_2052_: type_42;
    var phi_1043_: type_42;
    var phi_2767_: bool;
    var phi_2932_: bool;
    var phi_2507_: type_42;
    var phi_2508_: u32;
    var phi_2509_: bool;
    var phi_2510_: u32;
    var phi_2931_: bool;
    var phi_2511_: type_42;
    var phi_2512_: u32;
    var phi_2513_: u32;
    var phi_2514_: bool;
    var phi_2515_: u32;
    var phi_2930_: bool;
    var phi_2516_: type_42;
    var phi_2517_: u32;
    var phi_2518_: u32;
    var phi_2519_: bool;
    var phi_2520_: u32;
    var phi_2929_: bool;
    var phi_974_: type_42;
    var phi_977_: u32;
    var phi_979_: u32;
    var phi_981_: bool;
    var phi_983_: u32;
    var phi_2521_: bool;
    var phi_2928_: bool;
    var local_2: type_42;
    var phi_2559_: f32;
    var phi_2561_: f32;
    var phi_2562_: bool;
    var phi_2563_: f32;
    var phi_2564_: bool;
    var phi_2712_: u32;
    var phi_2730_: bool;
    var phi_2733_: bool;
    var phi_2746_: f32;
    var phi_2747_: f32;
    var phi_2752_: f32;
    var phi_2753_: f32;
    var phi_2754_: bool;
    var phi_2762_: f32;
    var phi_2579_: f32;
    var phi_2580_: f32;
    var phi_2592_: f32;
    var phi_2597_: type_22;
    var local_3: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = global;
            let _e76 = arrayLength((&global_2.member));
            let _e78 = arrayLength((&global_1.member));
            let _e84 = arrayLength((&global_5.member));
            let _e88 = (_e74.x + (_e74.y * 2097152u));
            let _e89 = (_e88 < arrayLength((&global_3.member)));
            if _e89 {
                if _e89 {
                } else {
                    break;
                }
                let _e93 = global_3.member[_e88].member_2;
                phi_268_ = _e93;
            } else {
                phi_268_ = 4294967295u;
            }
            let _e95 = phi_268_;
            if _e89 {
                let _e96 = (_e88 < arrayLength((&global_4.member)));
                if _e96 {
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e106 = global_3.member[_e88].member.member_2[0u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e114 = global_3.member[_e88].member.member_2[1u];
                    let _e116 = (bitcast<u32>(_e114) & 2147483647u);
                    let _e122 = global_3.member[_e88].member.member_2[2u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e130 = global_3.member[_e88].member.member[0u];
                    let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                    let _e138 = global_3.member[_e88].member.member[1u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e146 = global_3.member[_e88].member.member[2u];
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e150 = select(_e116, _e108, (_e116 < _e108));
                    let _e152 = select(_e124, _e150, (_e124 < _e150));
                    let _e154 = select(_e132, _e152, (_e132 < _e152));
                    let _e156 = select(_e140, _e154, (_e140 < _e154));
                    let _e158 = select(_e148, _e156, (_e148 < _e156));
                    let _e163 = global_3.member[_e88].member.member_1;
                    let _e164 = bitcast<u32>(_e163);
                    let _e165 = (_e164 & 2147483647u);
                    let _e173 = global_3.member[_e88].member.member_3;
                    let _e174 = bitcast<u32>(_e173);
                    let _e175 = (_e174 & 2147483647u);
                    let _e179 = (((select(_e165, _e158, (_e165 < _e158)) < 2139095040u) && (_e175 <= 2139095040u)) && (_e152 > 0u));
                    if _e179 {
                        let _e182 = (bitcast<u32>(bitcast<f32>(_e152)) & 2147483647u);
                        if (_e182 >= 8388608u) {
                            phi_373_ = (bitcast<i32>((_e182 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_373_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u))));
                        }
                        let _e196 = phi_373_;
                        phi_374_ = _e196;
                    } else {
                        phi_374_ = 0i;
                    }
                    let _e198 = phi_374_;
                    let _e199 = (_e108 == _e152);
                    if _e199 {
                        phi_384_ = true;
                    } else {
                        phi_384_ = (_e116 == _e152);
                    }
                    let _e202 = phi_384_;
                    let _e203 = select(1u, 0u, _e199);
                    if _e202 {
                        let _e204 = (_e203 + 1u);
                        phi_394_ = _e204;
                        phi_395_ = _e204;
                        phi_397_ = select(true, false, (_e204 == 2u));
                    } else {
                        phi_394_ = u32();
                        phi_395_ = 0u;
                        phi_397_ = true;
                    }
                    let _e208 = phi_394_;
                    let _e210 = phi_395_;
                    let _e212 = phi_397_;
                    if _e212 {
                        phi_402_ = (_e210 + 1u);
                    } else {
                        phi_402_ = 0u;
                    }
                    let _e216 = phi_402_;
                    let _e217 = select(_e208, _e210, _e212);
                    let _e218 = select(_e203, select(2u, _e203, _e202), _e212);
                    let _e219 = -(_e198);
                    if (_e219 < -126i) {
                        phi_434_ = -126i;
                    } else {
                        phi_434_ = select(_e219, 127i, (_e219 > 127i));
                    }
                    let _e224 = phi_434_;
                    let _e229 = bitcast<f32>((bitcast<u32>((_e224 + 127i)) << bitcast<u32>(23i)));
                    let _e235 = bitcast<f32>((bitcast<u32>(((_e219 - _e224) + 127i)) << bitcast<u32>(23i)));
                    let _e240 = global_3.member[_e88].member.member;
                    let _e241 = (_e217 == 0u);
                    if _e241 {
                        phi_452_ = _e240[0];
                    } else {
                        phi_452_ = _e240[1];
                    }
                    let _e245 = phi_452_;
                    let _e246 = (_e217 == 2u);
                    if _e246 {
                        phi_458_ = _e240[2];
                    } else {
                        phi_458_ = _e245;
                    }
                    let _e249 = phi_458_;
                    let _e250 = bitcast<u32>(_e249);
                    let _e252 = ((_e250 & 2139095040u) != 0u);
                    let _e264 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e249, _e252) * select(0.00000011920929f, 1f, _e252));
                    let _e265 = global_3.member[_e88].member.member_2;
                    if _e241 {
                        phi_498_ = _e265[0];
                    } else {
                        phi_498_ = _e265[1];
                    }
                    let _e269 = phi_498_;
                    if _e246 {
                        phi_504_ = _e265[2];
                    } else {
                        phi_504_ = _e269;
                    }
                    let _e272 = phi_504_;
                    let _e273 = bitcast<u32>(_e272);
                    let _e275 = ((_e273 & 2139095040u) != 0u);
                    let _e289 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e273 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e273 & 2147483648u))), _e272, _e275) * _e229) * select(0.00000011920929f, 1f, _e275)) * _e235);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e293 {
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) * 0.00000011920929f);
                        phi_556_ = select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f));
                    } else {
                        phi_556_ = 0f;
                    }
                    let _e301 = phi_556_;
                    let _e302 = (_e264 + _e301);
                    let _e303 = (_e264 - _e301);
                    let _e304 = select(_e289, 0f, _e293);
                    if _e293 {
                        phi_567_ = 38685626000000000000000000f;
                    } else {
                        phi_567_ = (1f / _e289);
                    }
                    let _e307 = phi_567_;
                    let _e308 = (_e216 == 0u);
                    if _e308 {
                        phi_576_ = _e240[0];
                    } else {
                        phi_576_ = _e240[1];
                    }
                    let _e312 = phi_576_;
                    let _e313 = (_e216 == 2u);
                    if _e313 {
                        phi_582_ = _e240[2];
                    } else {
                        phi_582_ = _e312;
                    }
                    let _e316 = phi_582_;
                    let _e317 = bitcast<u32>(_e316);
                    let _e319 = ((_e317 & 2139095040u) != 0u);
                    let _e331 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * select(0.00000011920929f, 1f, _e319));
                    if _e308 {
                        phi_622_ = _e265[0];
                    } else {
                        phi_622_ = _e265[1];
                    }
                    let _e335 = phi_622_;
                    if _e313 {
                        phi_628_ = _e265[2];
                    } else {
                        phi_628_ = _e335;
                    }
                    let _e338 = phi_628_;
                    let _e339 = bitcast<u32>(_e338);
                    let _e341 = ((_e339 & 2139095040u) != 0u);
                    let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e338, _e341) * _e229) * select(0.00000011920929f, 1f, _e341)) * _e235);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e359 {
                        let _e363 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_680_ = select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f));
                    } else {
                        phi_680_ = 0f;
                    }
                    let _e367 = phi_680_;
                    let _e368 = (_e331 + _e367);
                    let _e369 = (_e331 - _e367);
                    let _e370 = select(_e355, 0f, _e359);
                    if _e359 {
                        phi_691_ = 38685626000000000000000000f;
                    } else {
                        phi_691_ = (1f / _e355);
                    }
                    let _e373 = phi_691_;
                    let _e374 = (_e218 == 0u);
                    if _e374 {
                        phi_700_ = _e240[0];
                    } else {
                        phi_700_ = _e240[1];
                    }
                    let _e378 = phi_700_;
                    let _e379 = (_e218 == 2u);
                    if _e379 {
                        phi_706_ = _e240[2];
                    } else {
                        phi_706_ = _e378;
                    }
                    let _e382 = phi_706_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e397 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * select(0.00000011920929f, 1f, _e385));
                    if _e374 {
                        phi_746_ = _e265[0];
                    } else {
                        phi_746_ = _e265[1];
                    }
                    let _e401 = phi_746_;
                    if _e379 {
                        phi_752_ = _e265[2];
                    } else {
                        phi_752_ = _e401;
                    }
                    let _e404 = phi_752_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e229) * select(0.00000011920929f, 1f, _e407)) * _e235);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_804_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_804_ = 0f;
                    }
                    let _e433 = phi_804_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_815_ = 38685626000000000000000000f;
                    } else {
                        phi_815_ = (1f / _e421);
                    }
                    let _e439 = phi_815_;
                    let _e442 = bitcast<f32>((bitcast<u32>(_e264) & 2147483647u));
                    let _e445 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e447 = select(_e445, _e442, (_e442 > _e445));
                    let _e450 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    if (_e179 && (select(_e450, _e447, (_e447 > _e450)) <= 1099511600000f)) {
                        let _e462 = ((_e165 & 8388607u) | (select(0u, 1u, ((_e165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e465 = bitcast<i32>((_e165 >> bitcast<u32>(23i)));
                        let _e469 = (_e462 == 0u);
                        let _e472 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, _e469)) - 8i);
                        if (_e465 == 255i) {
                            phi_870_ = 255i;
                        } else {
                            phi_870_ = (((_e465 + select(0i, 1i, (_e465 == 0i))) - _e472) + _e198);
                        }
                        let _e480 = phi_870_;
                        let _e490 = (_e480 <= 0i);
                        if _e490 {
                            phi_893_ = u32();
                        } else {
                            if _e469 {
                                phi_892_ = u32();
                            } else {
                                phi_892_ = select(((bitcast<u32>(_e480) << bitcast<u32>(23i)) | ((_e462 << bitcast<u32>(((_e472 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e480 >= 255i));
                            }
                            let _e494 = phi_892_;
                            phi_893_ = _e494;
                        }
                        let _e496 = phi_893_;
                        let _e508 = ((_e175 & 8388607u) | (select(0u, 1u, ((_e175 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e511 = bitcast<i32>((_e175 >> bitcast<u32>(23i)));
                        let _e515 = (_e508 == 0u);
                        let _e518 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e508)), 32u, _e515)) - 8i);
                        if (_e511 == 255i) {
                            phi_930_ = 255i;
                        } else {
                            phi_930_ = (((_e511 + select(0i, 1i, (_e511 == 0i))) - _e518) + _e198);
                        }
                        let _e526 = phi_930_;
                        let _e536 = (_e526 <= 0i);
                        if _e536 {
                            phi_953_ = u32();
                        } else {
                            if _e515 {
                                phi_952_ = u32();
                            } else {
                                phi_952_ = select(((bitcast<u32>(_e526) << bitcast<u32>(23i)) | ((_e508 << bitcast<u32>(((_e518 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e526 >= 255i));
                            }
                            let _e540 = phi_952_;
                            phi_953_ = _e540;
                        }
                        let _e542 = phi_953_;
                        phi_961_ = bitcast<f32>(((_e174 & 2147483648u) | select(_e542, 0u, select(_e515, true, _e536))));
                        phi_962_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e496, 0u, select(_e469, true, _e490))));
                    } else {
                        phi_961_ = 0f;
                        phi_962_ = 1f;
                    }
                    let _e548 = phi_961_;
                    let _e550 = phi_962_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2773_ = false;
                    phi_973_ = type_42(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e548);
                    phi_976_ = select(0u, 2147483648u, (_e76 == 0u));
                    phi_978_ = ((3u * _e76) + 1u);
                    phi_980_ = (_e550 <= _e548);
                    phi_982_ = 0u;
                    loop {
                        let _e558 = phi_2773_;
                        let _e560 = phi_973_;
                        let _e562 = phi_976_;
                        let _e564 = phi_978_;
                        let _e566 = phi_980_;
                        let _e568 = phi_982_;
                        local_2 = _e560;
                        if _e566 {
                            phi_993_ = true;
                        } else {
                            phi_993_ = (_e568 > 0u);
                        }
                        let _e571 = phi_993_;
                        if _e571 {
                            let _e572 = (_e564 > 0u);
                            if _e572 {
                                if _e566 {
                                    phi_1025_ = _e562;
                                    phi_1026_ = _e566;
                                    phi_1027_ = _e568;
                                } else {
                                    let _e573 = (_e568 - 1u);
                                    let _e574 = (_e573 % 128u);
                                    let _e575 = (_e574 < 128u);
                                    if _e575 {
                                    } else {
                                        phi_2928_ = true;
                                        break;
                                    }
                                    let _e577 = local_1[_e574];
                                    if _e575 {
                                    } else {
                                        phi_2928_ = true;
                                        break;
                                    }
                                    let _e579 = local[_e574];
                                    phi_1025_ = _e577;
                                    phi_1026_ = (_e579 <= _e560.member_1);
                                    phi_1027_ = _e573;
                                }
                                let _e583 = phi_1025_;
                                let _e585 = phi_1026_;
                                let _e587 = phi_1027_;
                                if _e585 {
                                    if ((_e583 & 2147483648u) != 0u) {
                                        phi_1042_ = _e560;
                                        phi_1045_ = type_7(0u, ((_e583 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e785 = phi_1042_;
                                            let _e787 = phi_1045_;
                                            local_3 = _e785;
                                            if (_e787.member < _e787.member_1) {
                                                phi_1046_ = type_7((_e787.member + 1u), _e787.member_1);
                                                phi_1068_ = type_7(1u, _e787.member);
                                            } else {
                                                phi_1046_ = _e787;
                                                phi_1068_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e800 = phi_1046_;
                                            let _e802 = phi_1068_;
                                            let _e806 = (bitcast<i32>(_e802.member) != 0i);
                                            if _e806 {
                                                let _e807 = ((_e583 & 268435455u) + _e802.member_1);
                                                let _e808 = (_e807 < _e78);
                                                if _e808 {
                                                    if _e808 {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e812 = global_1.member[_e807].member_1;
                                                    phi_1089_ = _e812;
                                                } else {
                                                    phi_1089_ = 4294967295u;
                                                }
                                                let _e814 = phi_1089_;
                                                if (_e807 >= _e78) {
                                                    phi_1178_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e808 {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e816 = (_e217 % 3u);
                                                    let _e817 = (_e216 % 3u);
                                                    let _e818 = (_e218 % 3u);
                                                    if (_e816 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e824 = global_1.member[_e807].member[_e816];
                                                    if (_e817 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e830 = global_1.member[_e807].member[_e817];
                                                    if (_e818 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e836 = global_1.member[_e807].member[_e818];
                                                    let _e838 = (3u + _e816);
                                                    if (_e838 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e844 = global_1.member[_e807].member[_e838];
                                                    let _e845 = (3u + _e817);
                                                    if (_e845 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e851 = global_1.member[_e807].member[_e845];
                                                    let _e852 = (3u + _e818);
                                                    if (_e852 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e858 = global_1.member[_e807].member[_e852];
                                                    let _e860 = (6u + _e816);
                                                    if (_e860 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e866 = global_1.member[_e807].member[_e860];
                                                    let _e867 = (6u + _e817);
                                                    if (_e867 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e873 = global_1.member[_e807].member[_e867];
                                                    let _e874 = (6u + _e818);
                                                    if (_e874 < 9u) {
                                                    } else {
                                                        phi_2767_ = true;
                                                        break;
                                                    }
                                                    let _e880 = global_1.member[_e807].member[_e874];
                                                    phi_1178_ = array<array<f32, 3>, 3>(array<f32, 3>(_e824, _e830, _e836), array<f32, 3>(_e844, _e851, _e858), array<f32, 3>(_e866, _e873, _e880));
                                                }
                                                let _e884 = phi_1178_;
                                                let _e892 = (_e884[0][2] - _e397);
                                                let _e895 = (((_e884[0][0] - _e264) * _e436) - (_e892 * _e304));
                                                let _e898 = (((_e884[0][1] - _e331) * _e436) - (_e892 * _e370));
                                                let _e905 = (_e884[1][2] - _e397);
                                                let _e908 = (((_e884[1][0] - _e264) * _e436) - (_e905 * _e304));
                                                let _e911 = (((_e884[1][1] - _e331) * _e436) - (_e905 * _e370));
                                                let _e918 = (_e884[2][2] - _e397);
                                                let _e921 = (((_e884[2][0] - _e264) * _e436) - (_e918 * _e304));
                                                let _e924 = (((_e884[2][1] - _e331) * _e436) - (_e918 * _e370));
                                                let _e925 = (_e921 * _e911);
                                                let _e926 = (_e924 * _e908);
                                                let _e927 = (_e895 * _e924);
                                                let _e928 = (_e898 * _e921);
                                                let _e929 = (_e908 * _e898);
                                                let _e930 = (_e911 * _e895);
                                                let _e935 = (((_e925 >= _e926) && (_e927 >= _e928)) && (_e929 >= _e930));
                                                if (_e935 || (((_e925 <= _e926) && (_e927 <= _e928)) && (_e929 <= _e930))) {
                                                    let _e942 = select(-1f, 1f, _e935);
                                                    let _e944 = ((_e925 - _e926) * _e942);
                                                    let _e946 = select(0f, _e944, (_e944 > 0f));
                                                    let _e948 = ((_e927 - _e928) * _e942);
                                                    let _e950 = select(0f, _e948, (_e948 > 0f));
                                                    let _e952 = ((_e929 - _e930) * _e942);
                                                    let _e954 = select(0f, _e952, (_e952 > 0f));
                                                    let _e956 = ((_e946 + _e950) + _e954);
                                                    if (_e956 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2003_ = type_22();
                                                        phi_2004_ = true;
                                                        phi_2005_ = false;
                                                    } else {
                                                        let _e959 = select(_e908, _e895, (_e895 < _e908));
                                                        if (select(_e921, _e959, (_e959 < _e921)) > 0f) {
                                                            phi_1295_ = true;
                                                        } else {
                                                            let _e964 = select(_e908, _e895, (_e895 > _e908));
                                                            phi_1295_ = (select(_e921, _e964, (_e964 > _e921)) < 0f);
                                                        }
                                                        let _e969 = phi_1295_;
                                                        if _e969 {
                                                            phi_2000_ = type_22();
                                                            phi_2001_ = true;
                                                            phi_2002_ = false;
                                                        } else {
                                                            let _e971 = select(_e911, _e898, (_e898 < _e911));
                                                            if (select(_e924, _e971, (_e971 < _e924)) > 0f) {
                                                                phi_1324_ = true;
                                                            } else {
                                                                let _e976 = select(_e911, _e898, (_e898 > _e911));
                                                                phi_1324_ = (select(_e924, _e976, (_e976 > _e924)) < 0f);
                                                            }
                                                            let _e981 = phi_1324_;
                                                            if _e981 {
                                                                phi_1998_ = type_22();
                                                                phi_1999_ = false;
                                                            } else {
                                                                let _e983 = select(_e884[1][0], _e884[0][0], (_e884[0][0] < _e884[1][0]));
                                                                let _e987 = select(_e884[1][0], _e884[0][0], (_e884[0][0] > _e884[1][0]));
                                                                let _e991 = select(_e884[1][1], _e884[0][1], (_e884[0][1] < _e884[1][1]));
                                                                let _e995 = select(_e884[1][1], _e884[0][1], (_e884[0][1] > _e884[1][1]));
                                                                let _e999 = select(_e884[1][2], _e884[0][2], (_e884[0][2] < _e884[1][2]));
                                                                let _e1003 = select(_e884[1][2], _e884[0][2], (_e884[0][2] > _e884[1][2]));
                                                                let _e1008 = ((select(_e884[2][0], _e983, (_e983 < _e884[2][0])) - _e302) * _e307);
                                                                let _e1009 = ((select(_e884[2][0], _e987, (_e987 > _e884[2][0])) - _e303) * _e307);
                                                                let _e1012 = ((select(_e884[2][1], _e991, (_e991 < _e884[2][1])) - _e368) * _e373);
                                                                let _e1013 = ((select(_e884[2][1], _e995, (_e995 > _e884[2][1])) - _e369) * _e373);
                                                                let _e1016 = ((select(_e884[2][2], _e999, (_e999 < _e884[2][2])) - _e434) * _e439);
                                                                let _e1017 = ((select(_e884[2][2], _e1003, (_e1003 > _e884[2][2])) - _e435) * _e439);
                                                                let _e1019 = select(_e1017, _e1016, (_e1016 < _e1017));
                                                                let _e1021 = select(_e1017, _e1016, (_e1016 > _e1017));
                                                                let _e1023 = select(_e1009, _e1008, (_e1008 < _e1009));
                                                                let _e1025 = select(_e1013, _e1012, (_e1012 < _e1013));
                                                                let _e1027 = select(_e1025, _e1023, (_e1023 > _e1025));
                                                                let _e1029 = select(_e1019, _e1027, (_e1027 > _e1019));
                                                                let _e1031 = select(_e1009, _e1008, (_e1008 > _e1009));
                                                                let _e1033 = select(_e1013, _e1012, (_e1012 > _e1013));
                                                                let _e1035 = select(_e1033, _e1031, (_e1031 < _e1033));
                                                                let _e1037 = select(_e1021, _e1035, (_e1035 < _e1021));
                                                                let _e1038 = -(_e1019);
                                                                let _e1044 = select(_e550, _e1029, (_e1029 > _e550));
                                                                if (_e1044 > (_e1037 + (select(_e1038, _e1021, (_e1021 > _e1038)) * 0.0000019073523f))) {
                                                                    phi_1993_ = type_22();
                                                                    phi_1994_ = true;
                                                                } else {
                                                                    let _e1046 = (_e1044 > _e785.member_1);
                                                                    if _e1046 {
                                                                        phi_1992_ = type_22();
                                                                    } else {
                                                                        let _e1047 = vec3<f32>(_e884[0][0], _e884[0][1], _e884[0][2]);
                                                                        let _e1048 = vec3<f32>(_e884[1][0], _e884[1][1], _e884[1][2]);
                                                                        let _e1049 = vec3<f32>(_e884[2][0], _e884[2][1], _e884[2][2]);
                                                                        let _e1050 = (_e884[1][0] - _e884[0][0]);
                                                                        let _e1051 = (_e884[1][1] - _e884[0][1]);
                                                                        let _e1052 = (_e884[1][2] - _e884[0][2]);
                                                                        let _e1053 = vec3<f32>(_e1050, _e1051, _e1052);
                                                                        let _e1054 = (_e884[2][0] - _e884[1][0]);
                                                                        let _e1055 = (_e884[2][1] - _e884[1][1]);
                                                                        let _e1056 = (_e884[2][2] - _e884[1][2]);
                                                                        let _e1057 = vec3<f32>(_e1054, _e1055, _e1056);
                                                                        let _e1058 = (_e884[0][0] - _e884[2][0]);
                                                                        let _e1059 = (_e884[0][1] - _e884[2][1]);
                                                                        let _e1060 = (_e884[0][2] - _e884[2][2]);
                                                                        let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                                        let _e1064 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                        let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                        let _e1072 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                                                                        let _e1077 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                                                                        let _e1090 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1093 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                        let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                                        let _e1098 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                        let _e1102 = select(_e1087, _e1074, (_e1074 > _e1087));
                                                                        let _e1104 = select(_e1100, _e1102, (_e1102 > _e1100));
                                                                        if (_e1074 == _e1104) {
                                                                            phi_1725_ = _e911;
                                                                            phi_1726_ = _e908;
                                                                            phi_1727_ = _e898;
                                                                            phi_1728_ = _e895;
                                                                            phi_1729_ = _e1047;
                                                                            phi_1730_ = _e1061;
                                                                            phi_1731_ = _e1057;
                                                                            phi_1732_ = _e1053;
                                                                        } else {
                                                                            let _e1106 = (_e1087 == _e1104);
                                                                            let _e1111 = vec3(_e1106);
                                                                            phi_1725_ = select(_e898, _e924, _e1106);
                                                                            phi_1726_ = select(_e895, _e921, _e1106);
                                                                            phi_1727_ = select(_e924, _e911, _e1106);
                                                                            phi_1728_ = select(_e921, _e908, _e1106);
                                                                            phi_1729_ = select(_e1049, _e1048, _e1111);
                                                                            phi_1730_ = select(_e1057, _e1053, _e1111);
                                                                            phi_1731_ = select(_e1053, _e1061, _e1111);
                                                                            phi_1732_ = select(_e1061, _e1057, _e1111);
                                                                        }
                                                                        let _e1117 = phi_1725_;
                                                                        let _e1119 = phi_1726_;
                                                                        let _e1121 = phi_1727_;
                                                                        let _e1123 = phi_1728_;
                                                                        let _e1125 = phi_1729_;
                                                                        let _e1127 = phi_1730_;
                                                                        let _e1129 = phi_1731_;
                                                                        let _e1131 = phi_1732_;
                                                                        let _e1138 = ((_e1129.y * _e1127.z) - (_e1127.y * _e1129.z));
                                                                        let _e1143 = ((_e1129.z * _e1127.x) - (_e1127.z * _e1129.x));
                                                                        let _e1146 = ((_e1129.x * _e1127.y) - (_e1127.x * _e1129.y));
                                                                        if (_e946 >= _e950) {
                                                                            phi_1763_ = select(true, false, (_e946 >= _e954));
                                                                        } else {
                                                                            phi_1763_ = true;
                                                                        }
                                                                        let _e1151 = phi_1763_;
                                                                        if _e1151 {
                                                                            phi_1772_ = select(_e1049, _e1048, vec3((_e950 >= _e954)));
                                                                        } else {
                                                                            phi_1772_ = _e1047;
                                                                        }
                                                                        let _e1156 = phi_1772_;
                                                                        let _e1167 = (((_e1138 * (_e1156.x - _e264)) + (_e1143 * (_e1156.y - _e331))) + (_e1146 * (_e1156.z - _e397)));
                                                                        let _e1172 = (((_e1138 * _e304) + (_e1143 * _e370)) + (_e1146 * _e436));
                                                                        let _e1173 = (_e1119 - _e1123);
                                                                        let _e1174 = (_e1117 - _e1121);
                                                                        let _e1182 = (-(((_e1123 * _e1173) + (_e1121 * _e1174))) / ((_e1173 * _e1173) + (_e1174 * _e1174)));
                                                                        let _e1184 = select(1f, _e1182, (_e1182 < 1f));
                                                                        let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                                                        let _e1199 = ((_e1125.x + (_e1131.x * _e1186)) - _e264);
                                                                        let _e1200 = ((_e1125.y + (_e1131.y * _e1186)) - _e331);
                                                                        let _e1201 = ((_e1125.z + (_e1131.z * _e1186)) - _e397);
                                                                        let _e1202 = (_e1201 / _e436);
                                                                        let _e1214 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                        let _e1217 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                        let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                                        let _e1222 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                        let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                        let _e1233 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                        let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1138 * _e1199) + (_e1143 * _e1200)) + (_e1146 * _e1201)) - _e1167)) & 2147483647u)) <= ((0.0000009536743f * select(_e1104, _e1224, (_e1224 > _e1104))) * select(_e1238, _e1235, (_e1235 > _e1238)))) {
                                                                            let _e1248 = bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u));
                                                                            let _e1251 = bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u));
                                                                            let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                            let _e1256 = bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u));
                                                                            let _e1262 = bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u));
                                                                            let _e1265 = bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u));
                                                                            let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                            let _e1270 = bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u));
                                                                            let _e1274 = (bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u)) > ((0.0000038146973f * select(_e1256, _e1253, (_e1253 > _e1256))) * select(_e1270, _e1267, (_e1267 > _e1270))));
                                                                            if _e1274 {
                                                                                phi_1937_ = (_e1167 / _e1172);
                                                                            } else {
                                                                                phi_1937_ = f32();
                                                                            }
                                                                            let _e1277 = phi_1937_;
                                                                            phi_1939_ = _e1277;
                                                                            phi_1940_ = select(true, false, _e1274);
                                                                        } else {
                                                                            phi_1939_ = f32();
                                                                            phi_1940_ = true;
                                                                        }
                                                                        let _e1280 = phi_1939_;
                                                                        let _e1282 = phi_1940_;
                                                                        if _e1282 {
                                                                            let _e1290 = (((_e1138 * (_e1199 - (_e304 * _e1202))) + (_e1143 * (_e1200 - (_e370 * _e1202)))) / _e1172);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u)) <= _e1104) {
                                                                                phi_1960_ = (_e1202 + _e1290);
                                                                            } else {
                                                                                phi_1960_ = _e1202;
                                                                            }
                                                                            let _e1297 = phi_1960_;
                                                                            phi_1961_ = _e1297;
                                                                        } else {
                                                                            phi_1961_ = _e1280;
                                                                        }
                                                                        let _e1299 = phi_1961_;
                                                                        let _e1301 = select(_e1037, _e1299, (_e1299 < _e1037));
                                                                        let _e1303 = select(_e1029, _e1301, (_e1301 > _e1029));
                                                                        if (_e1303 >= _e550) {
                                                                            let _e1305 = (_e1303 <= _e785.member_1);
                                                                            if _e1305 {
                                                                                let _e1306 = (1f / _e956);
                                                                                phi_1984_ = type_22(_e1303, (_e950 * _e1306), (_e954 * _e1306), _e814);
                                                                            } else {
                                                                                phi_1984_ = type_22();
                                                                            }
                                                                            let _e1311 = phi_1984_;
                                                                            phi_1986_ = _e1311;
                                                                            phi_1987_ = select(true, false, _e1305);
                                                                        } else {
                                                                            phi_1986_ = type_22();
                                                                            phi_1987_ = true;
                                                                        }
                                                                        let _e1314 = phi_1986_;
                                                                        let _e1316 = phi_1987_;
                                                                        if _e1316 {
                                                                            phi_1991_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1991_ = _e1314;
                                                                        }
                                                                        let _e1318 = phi_1991_;
                                                                        phi_1992_ = _e1318;
                                                                    }
                                                                    let _e1320 = phi_1992_;
                                                                    phi_1993_ = _e1320;
                                                                    phi_1994_ = _e1046;
                                                                }
                                                                let _e1322 = phi_1993_;
                                                                let _e1324 = phi_1994_;
                                                                phi_1998_ = _e1322;
                                                                phi_1999_ = _e1324;
                                                            }
                                                            let _e1326 = phi_1998_;
                                                            let _e1328 = phi_1999_;
                                                            phi_2000_ = _e1326;
                                                            phi_2001_ = _e981;
                                                            phi_2002_ = _e1328;
                                                        }
                                                        let _e1330 = phi_2000_;
                                                        let _e1332 = phi_2001_;
                                                        let _e1334 = phi_2002_;
                                                        phi_2003_ = _e1330;
                                                        phi_2004_ = _e1332;
                                                        phi_2005_ = _e1334;
                                                    }
                                                    let _e1336 = phi_2003_;
                                                    let _e1338 = phi_2004_;
                                                    let _e1340 = phi_2005_;
                                                    phi_2013_ = _e1336;
                                                    phi_2014_ = select(_e1340, true, _e1338);
                                                } else {
                                                    phi_2013_ = type_22();
                                                    phi_2014_ = true;
                                                }
                                                let _e1343 = phi_2013_;
                                                let _e1345 = phi_2014_;
                                                if _e1345 {
                                                    phi_2018_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2018_ = _e1343;
                                                }
                                                let _e1347 = phi_2018_;
                                                if (_e1347.member_3 != 4294967295u) {
                                                    if (_e814 != _e95) {
                                                        if (_e1347.member < _e785.member.member) {
                                                            phi_2044_ = true;
                                                        } else {
                                                            if (_e1347.member == _e785.member.member) {
                                                                phi_2043_ = (_e1347.member_3 < _e785.member.member_3);
                                                            } else {
                                                                phi_2043_ = false;
                                                            }
                                                            let _e1360 = phi_2043_;
                                                            phi_2044_ = _e1360;
                                                        }
                                                        let _e1362 = phi_2044_;
                                                        if _e1362 {
                                                            phi_2050_ = type_42(_e1347, _e1347.member);
                                                        } else {
                                                            phi_2050_ = _e785;
                                                        }
                                                        let _e1365 = phi_2050_;
                                                        phi_2051_ = _e1365;
                                                    } else {
                                                        phi_2051_ = _e785;
                                                    }
                                                    let _e1367 = phi_2051_;
                                                    phi_2052_ = _e1367;
                                                } else {
                                                    phi_2052_ = _e785;
                                                }
                                                let _e1369 = phi_2052_;
                                                phi_1043_ = _e1369;
                                            } else {
                                                phi_1043_ = type_42();
                                            }
                                            let _e1371 = phi_1043_;
                                            continue;
                                            continuing {
                                                phi_1042_ = _e1371;
                                                phi_1045_ = _e800;
                                                phi_2767_ = _e558;
                                                break if !(_e806);
                                            }
                                        }
                                        let _e1374 = phi_2767_;
                                        phi_2928_ = _e1374;
                                        if _e1374 {
                                            break;
                                        }
                                        phi_2932_ = _e1374;
                                        let _e1686 = local_3;
                                        phi_2507_ = _e1686;
                                        phi_2508_ = _e583;
                                        phi_2509_ = false;
                                        phi_2510_ = _e587;
                                    } else {
                                        if (_e583 >= _e76) {
                                            phi_2112_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e583 < _e76) {
                                            } else {
                                                phi_2928_ = true;
                                                break;
                                            }
                                            let _e597 = (_e217 % 3u);
                                            if (_e597 < 3u) {
                                            } else {
                                                phi_2928_ = true;
                                                break;
                                            }
                                            let _e603 = global_2.member[_e583].member[_e597];
                                            let _e609 = (_e216 % 3u);
                                            if (_e609 < 3u) {
                                            } else {
                                                phi_2928_ = true;
                                                break;
                                            }
                                            let _e615 = global_2.member[_e583].member[_e609];
                                            let _e621 = (_e218 % 3u);
                                            if (_e621 < 3u) {
                                            } else {
                                                phi_2928_ = true;
                                                break;
                                            }
                                            let _e627 = global_2.member[_e583].member[_e621];
                                            let _e637 = global_2.member[_e583].member_1;
                                            let _e641 = global_2.member[_e583].member_2;
                                            phi_2112_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e603[0], _e603[1], _e603[2], _e603[3]), vec4<f32>(_e615[0], _e615[1], _e615[2], _e615[3]), vec4<f32>(_e627[0], _e627[1], _e627[2], _e627[3])), _e637, _e641);
                                        }
                                        let _e644 = phi_2112_;
                                        let _e656 = ((_e644.member[0].x - _e302) * _e307);
                                        let _e657 = ((_e644.member[0].y - _e302) * _e307);
                                        let _e658 = ((_e644.member[0].z - _e303) * _e307);
                                        let _e659 = ((_e644.member[0].w - _e303) * _e307);
                                        let _e669 = ((_e644.member[1].x - _e368) * _e373);
                                        let _e670 = ((_e644.member[1].y - _e368) * _e373);
                                        let _e671 = ((_e644.member[1].z - _e369) * _e373);
                                        let _e672 = ((_e644.member[1].w - _e369) * _e373);
                                        let _e682 = ((_e644.member[2].x - _e434) * _e439);
                                        let _e683 = ((_e644.member[2].y - _e434) * _e439);
                                        let _e684 = ((_e644.member[2].z - _e435) * _e439);
                                        let _e685 = ((_e644.member[2].w - _e435) * _e439);
                                        let _e687 = select(_e684, _e682, (_e682 < _e684));
                                        let _e689 = select(_e685, _e683, (_e683 < _e685));
                                        let _e691 = select(_e684, _e682, (_e682 > _e684));
                                        let _e693 = select(_e685, _e683, (_e683 > _e685));
                                        let _e695 = select(_e658, _e656, (_e656 < _e658));
                                        let _e697 = select(_e659, _e657, (_e657 < _e659));
                                        let _e699 = select(_e671, _e669, (_e669 < _e671));
                                        let _e701 = select(_e672, _e670, (_e670 < _e672));
                                        let _e703 = select(_e699, _e695, (_e695 > _e699));
                                        let _e705 = select(_e701, _e697, (_e697 > _e701));
                                        let _e707 = select(_e687, _e703, (_e703 > _e687));
                                        let _e709 = select(_e689, _e705, (_e705 > _e689));
                                        let _e711 = select(_e658, _e656, (_e656 > _e658));
                                        let _e713 = select(_e659, _e657, (_e657 > _e659));
                                        let _e715 = select(_e671, _e669, (_e669 > _e671));
                                        let _e717 = select(_e672, _e670, (_e670 > _e672));
                                        let _e719 = select(_e715, _e711, (_e711 < _e715));
                                        let _e721 = select(_e717, _e713, (_e713 < _e717));
                                        let _e726 = -(_e687);
                                        let _e727 = -(_e689);
                                        let _e734 = (select(_e691, _e719, (_e719 < _e691)) + (select(_e726, _e691, (_e691 > _e726)) * 0.0000019073523f));
                                        let _e735 = (select(_e693, _e721, (_e721 < _e693)) + (select(_e727, _e693, (_e693 > _e727)) * 0.0000019073523f));
                                        let _e737 = select(_e550, _e707, (_e707 > _e550));
                                        let _e739 = select(_e550, _e709, (_e709 > _e550));
                                        let _e744 = (_e737 <= select(_e560.member_1, _e734, (_e734 < _e560.member_1)));
                                        let _e745 = (_e739 <= select(_e560.member_1, _e735, (_e735 < _e560.member_1)));
                                        let _e746 = (_e737 <= _e739);
                                        if _e744 {
                                            if _e745 {
                                                if _e746 {
                                                    phi_2456_ = _e644.member_2;
                                                } else {
                                                    phi_2456_ = _e644.member_1;
                                                }
                                                let _e750 = phi_2456_;
                                                let _e753 = (_e587 % 128u);
                                                let _e754 = (_e753 < 128u);
                                                if _e754 {
                                                } else {
                                                    phi_2928_ = true;
                                                    break;
                                                }
                                                local_1[_e753] = _e750;
                                                if _e754 {
                                                } else {
                                                    phi_2928_ = true;
                                                    break;
                                                }
                                                local[_e753] = select(_e739, _e737, (_e737 > _e739));
                                                if _e746 {
                                                    phi_2484_ = _e644.member_1;
                                                } else {
                                                    phi_2484_ = _e644.member_2;
                                                }
                                                let _e761 = phi_2484_;
                                                phi_2485_ = _e761;
                                                phi_2486_ = (_e587 + 1u);
                                            } else {
                                                phi_2485_ = u32();
                                                phi_2486_ = u32();
                                            }
                                            let _e763 = phi_2485_;
                                            let _e765 = phi_2486_;
                                            phi_2488_ = _e763;
                                            phi_2489_ = _e765;
                                            phi_2490_ = select(true, false, _e745);
                                        } else {
                                            phi_2488_ = u32();
                                            phi_2489_ = u32();
                                            phi_2490_ = true;
                                        }
                                        let _e768 = phi_2488_;
                                        let _e770 = phi_2489_;
                                        let _e772 = phi_2490_;
                                        if _e772 {
                                            if _e744 {
                                                phi_2499_ = _e644.member_1;
                                            } else {
                                                phi_2499_ = _e644.member_2;
                                            }
                                            let _e776 = phi_2499_;
                                            phi_2504_ = _e776;
                                            phi_2505_ = select(_e745, true, _e744);
                                        } else {
                                            phi_2504_ = _e768;
                                            phi_2505_ = _e585;
                                        }
                                        let _e779 = phi_2504_;
                                        let _e781 = phi_2505_;
                                        phi_2932_ = _e558;
                                        phi_2507_ = _e560;
                                        phi_2508_ = _e779;
                                        phi_2509_ = _e781;
                                        phi_2510_ = select(_e770, _e587, _e772);
                                    }
                                    let _e1376 = phi_2932_;
                                    let _e1378 = phi_2507_;
                                    let _e1380 = phi_2508_;
                                    let _e1382 = phi_2509_;
                                    let _e1384 = phi_2510_;
                                    phi_2931_ = _e1376;
                                    phi_2511_ = _e1378;
                                    phi_2512_ = _e1380;
                                    phi_2513_ = (_e564 - 1u);
                                    phi_2514_ = _e1382;
                                    phi_2515_ = _e1384;
                                } else {
                                    phi_2931_ = _e558;
                                    phi_2511_ = _e560;
                                    phi_2512_ = _e583;
                                    phi_2513_ = _e564;
                                    phi_2514_ = _e585;
                                    phi_2515_ = _e587;
                                }
                                let _e1386 = phi_2931_;
                                let _e1388 = phi_2511_;
                                let _e1390 = phi_2512_;
                                let _e1392 = phi_2513_;
                                let _e1394 = phi_2514_;
                                let _e1396 = phi_2515_;
                                phi_2930_ = _e1386;
                                phi_2516_ = _e1388;
                                phi_2517_ = _e1390;
                                phi_2518_ = _e1392;
                                phi_2519_ = _e1394;
                                phi_2520_ = _e1396;
                            } else {
                                phi_2930_ = _e558;
                                phi_2516_ = type_42();
                                phi_2517_ = u32();
                                phi_2518_ = u32();
                                phi_2519_ = bool();
                                phi_2520_ = u32();
                            }
                            let _e1398 = phi_2930_;
                            let _e1400 = phi_2516_;
                            let _e1402 = phi_2517_;
                            let _e1404 = phi_2518_;
                            let _e1406 = phi_2519_;
                            let _e1408 = phi_2520_;
                            phi_2929_ = _e1398;
                            phi_974_ = _e1400;
                            phi_977_ = _e1402;
                            phi_979_ = _e1404;
                            phi_981_ = _e1406;
                            phi_983_ = _e1408;
                            phi_2521_ = _e572;
                        } else {
                            phi_2929_ = _e558;
                            phi_974_ = type_42();
                            phi_977_ = u32();
                            phi_979_ = u32();
                            phi_981_ = bool();
                            phi_983_ = u32();
                            phi_2521_ = false;
                        }
                        let _e1410 = phi_2929_;
                        let _e1412 = phi_974_;
                        let _e1414 = phi_977_;
                        let _e1416 = phi_979_;
                        let _e1418 = phi_981_;
                        let _e1420 = phi_983_;
                        let _e1422 = phi_2521_;
                        continue;
                        continuing {
                            phi_2773_ = _e1410;
                            phi_973_ = _e1412;
                            phi_976_ = _e1414;
                            phi_978_ = _e1416;
                            phi_980_ = _e1418;
                            phi_982_ = _e1420;
                            phi_2928_ = _e1410;
                            break if !(_e1422);
                        }
                    }
                    let _e1425 = phi_2928_;
                    if _e1425 {
                        break;
                    }
                    let _e1427 = local_2;
                    if (_e1427.member.member_3 != 4294967295u) {
                        let _e1432 = bitcast<u32>(_e1427.member.member);
                        let _e1436 = (bitcast<i32>((_e1432 >> bitcast<u32>(23i))) & 255i);
                        let _e1437 = (_e1436 + _e219);
                        if (_e1436 == 255i) {
                            phi_2580_ = _e1427.member.member;
                        } else {
                            if (_e1436 > 0i) {
                                if (_e1437 > 0i) {
                                    let _e1441 = (_e1437 < 255i);
                                    if _e1441 {
                                        phi_2559_ = bitcast<f32>((_e1432 + bitcast<u32>((_e219 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2559_ = f32();
                                    }
                                    let _e1448 = phi_2559_;
                                    phi_2561_ = _e1448;
                                    phi_2562_ = select(true, false, _e1441);
                                } else {
                                    phi_2561_ = f32();
                                    phi_2562_ = true;
                                }
                                let _e1451 = phi_2561_;
                                let _e1453 = phi_2562_;
                                phi_2563_ = _e1451;
                                phi_2564_ = _e1453;
                            } else {
                                phi_2563_ = f32();
                                phi_2564_ = true;
                            }
                            let _e1455 = phi_2563_;
                            let _e1457 = phi_2564_;
                            if _e1457 {
                                let _e1458 = (_e1432 & 2147483648u);
                                let _e1465 = ((_e1432 & 8388607u) | (select(0u, 1u, ((_e1432 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1469 = (_e1465 == 0u);
                                if _e1469 {
                                    phi_2762_ = bitcast<f32>(_e1458);
                                } else {
                                    let _e1474 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1465)), 32u, _e1469) - 8u);
                                    let _e1477 = (_e1465 << bitcast<u32>((_e1474 & 31u)));
                                    let _e1479 = ((_e1437 + select(0i, 1i, (_e1436 == 0i))) - bitcast<i32>(_e1474));
                                    if (_e1479 >= 255i) {
                                        phi_2752_ = bitcast<f32>((_e1458 | 2139095040u));
                                        phi_2753_ = f32();
                                        phi_2754_ = true;
                                    } else {
                                        let _e1481 = (_e1479 > 0i);
                                        if _e1481 {
                                            phi_2746_ = bitcast<f32>(((_e1458 | (bitcast<u32>(_e1479) << bitcast<u32>(23i))) | (_e1477 & 8388607u)));
                                            phi_2747_ = f32();
                                        } else {
                                            if (_e1479 < -24i) {
                                                phi_2712_ = 26u;
                                            } else {
                                                phi_2712_ = bitcast<u32>((1i - _e1479));
                                            }
                                            let _e1486 = phi_2712_;
                                            let _e1487 = (_e1486 & 31u);
                                            let _e1489 = (_e1477 >> bitcast<u32>(_e1487));
                                            let _e1493 = (_e1477 & ((1u << bitcast<u32>(_e1487)) - 1u));
                                            let _e1497 = (1u << bitcast<u32>(((_e1486 - 1u) & 31u)));
                                            if (_e1493 > _e1497) {
                                                phi_2733_ = true;
                                            } else {
                                                if (_e1493 == _e1497) {
                                                    phi_2730_ = ((_e1489 & 1u) == 1u);
                                                } else {
                                                    phi_2730_ = false;
                                                }
                                                let _e1503 = phi_2730_;
                                                phi_2733_ = _e1503;
                                            }
                                            let _e1505 = phi_2733_;
                                            phi_2746_ = f32();
                                            phi_2747_ = bitcast<f32>((_e1458 | (_e1489 + select(0u, 1u, _e1505))));
                                        }
                                        let _e1518 = phi_2746_;
                                        let _e1520 = phi_2747_;
                                        phi_2752_ = _e1518;
                                        phi_2753_ = _e1520;
                                        phi_2754_ = _e1481;
                                    }
                                    let _e1524 = phi_2752_;
                                    let _e1526 = phi_2753_;
                                    let _e1528 = phi_2754_;
                                    phi_2762_ = select(_e1526, _e1524, _e1528);
                                }
                                let _e1532 = phi_2762_;
                                phi_2579_ = _e1532;
                            } else {
                                phi_2579_ = _e1455;
                            }
                            let _e1534 = phi_2579_;
                            phi_2580_ = _e1534;
                        }
                        let _e1536 = phi_2580_;
                        let _e1537 = bitcast<u32>(_e1536);
                        if ((_e1537 & 2147483647u) >= 2139095040u) {
                            phi_2592_ = bitcast<f32>(((_e1537 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2592_ = _e1536;
                        }
                        let _e1544 = phi_2592_;
                        phi_2597_ = type_22(_e1544, _e1427.member.member_1, _e1427.member.member_2, _e1427.member.member_3);
                    } else {
                        phi_2597_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1549 = phi_2597_;
                    if _e96 {
                    } else {
                        break;
                    }
                    global_4.member[_e88] = _e1549;
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e1553 = select(0u, 1u, (_e163 <= _e173));
                    if (_e1553 > 0u) {
                        let _e1555 = (1u < _e84);
                        if _e1555 {
                            if (0u < _e84) {
                            } else {
                                break;
                            }
                            let _e1559 = atomicAdd((&global_5.member[0u]), _e1553);
                            if ((_e1559 + _e1553) < _e1559) {
                                if _e1555 {
                                } else {
                                    break;
                                }
                                let _e1564 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1567 = select(0u, 1u, (_e1549.member_3 != 4294967295u));
                    if (_e1567 > 0u) {
                        let _e1569 = (3u < _e84);
                        if _e1569 {
                            if (2u < _e84) {
                            } else {
                                break;
                            }
                            let _e1573 = atomicAdd((&global_5.member[2u]), _e1567);
                            if ((_e1573 + _e1567) < _e1573) {
                                if _e1569 {
                                } else {
                                    break;
                                }
                                let _e1578 = atomicAdd((&global_5.member[3u]), 1u);
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
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
