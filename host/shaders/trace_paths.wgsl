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
var<storage, read_write> global_5: type_52;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_295_: u32;
    var phi_400_: i32;
    var phi_401_: i32;
    var phi_411_: bool;
    var phi_421_: u32;
    var phi_422_: u32;
    var phi_424_: bool;
    var phi_429_: u32;
    var phi_462_: i32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_526_: f32;
    var phi_532_: f32;
    var phi_605_: f32;
    var phi_611_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_730_: f32;
    var phi_736_: f32;
    var phi_776_: f32;
    var phi_782_: f32;
    var phi_901_: i32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_961_: i32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_2982_: bool;
    var phi_1008_: type_43;
    var phi_1011_: u32;
    var phi_1013_: bool;
    var phi_1015_: u32;
    var phi_1017_: u32;
    var phi_1028_: bool;
    var phi_1060_: bool;
    var phi_1061_: u32;
    var phi_1062_: u32;
    var phi_1077_: type_43;
    var phi_1080_: type_7;
    var phi_1081_: type_7;
    var phi_1103_: type_7;
    var phi_1124_: u32;
    var phi_1216_: array<array<f32, 3>, 3>;
    var phi_2728_: bool;
    var phi_2743_: bool;
    var phi_2758_: bool;
    var phi_2773_: bool;
    var phi_2788_: bool;
    var phi_2803_: bool;
    var phi_1758_: f32;
    var phi_1759_: f32;
    var phi_1760_: f32;
    var phi_1761_: f32;
    var phi_1762_: vec3<f32>;
    var phi_1763_: vec3<f32>;
    var phi_1764_: vec3<f32>;
    var phi_1765_: vec3<f32>;
    var phi_2818_: bool;
    var phi_2833_: bool;
    var phi_2848_: bool;
    var phi_2863_: bool;
    var phi_2878_: bool;
    var phi_2893_: bool;
    var phi_1973_: f32;
    var phi_1993_: type_47;
    var phi_1994_: type_47;
    var phi_1997_: type_47;
    var phi_1998_: type_47;
    var phi_1999_: bool;
    var phi_2003_: type_47;
    var phi_2012_: type_22;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2044_: type_43;
    var phi_2045_: type_43;
    var phi_2046_: type_43;
    var phi_1078_: type_43;
    var phi_2976_: bool;
    var phi_3177_: bool;
    var phi_2047_: type_43;
    var phi_2112_: type_48;
    var phi_2474_: u32;
    var phi_2501_: u32;
    var phi_2502_: u32;
    var phi_2503_: u32;
    var phi_2505_: u32;
    var phi_2506_: u32;
    var phi_2507_: bool;
    var phi_2516_: u32;
    var phi_2521_: bool;
    var phi_2523_: u32;
    var phi_2527_: bool;
    var phi_2528_: u32;
    var phi_2529_: u32;
    var phi_3145_: bool;
    var phi_2540_: type_43;
    var phi_2541_: u32;
    var phi_2542_: bool;
    var phi_2543_: u32;
    var phi_2544_: u32;
    var phi_3144_: bool;
    var phi_2545_: type_43;
    var phi_2546_: u32;
    var phi_2547_: bool;
    var phi_2548_: u32;
    var phi_2549_: u32;
    var phi_3143_: bool;
    var phi_1009_: type_43;
    var phi_1012_: u32;
    var phi_1014_: bool;
    var phi_1016_: u32;
    var phi_1018_: u32;
    var phi_2550_: bool;
    var phi_3142_: bool;
    var local_2: type_43;
    var phi_2588_: f32;
    var phi_2590_: f32;
    var phi_2591_: bool;
    var phi_2592_: f32;
    var phi_2593_: bool;
    var phi_2921_: u32;
    var phi_2939_: bool;
    var phi_2942_: bool;
    var phi_2955_: f32;
    var phi_2956_: f32;
    var phi_2961_: f32;
    var phi_2962_: f32;
    var phi_2963_: bool;
    var phi_2971_: f32;
    var phi_2608_: f32;
    var phi_2609_: f32;
    var phi_2621_: f32;
    var phi_2626_: type_22;
    var local_3: type_43;

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
                phi_295_ = _e93;
            } else {
                phi_295_ = 4294967295u;
            }
            let _e95 = phi_295_;
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
                            phi_400_ = (bitcast<i32>((_e182 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_400_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u))));
                        }
                        let _e196 = phi_400_;
                        phi_401_ = _e196;
                    } else {
                        phi_401_ = 0i;
                    }
                    let _e198 = phi_401_;
                    let _e199 = (_e108 == _e152);
                    if _e199 {
                        phi_411_ = true;
                    } else {
                        phi_411_ = (_e116 == _e152);
                    }
                    let _e202 = phi_411_;
                    let _e203 = select(1u, 0u, _e199);
                    if _e202 {
                        let _e204 = (_e203 + 1u);
                        phi_421_ = _e204;
                        phi_422_ = _e204;
                        phi_424_ = select(true, false, (_e204 == 2u));
                    } else {
                        phi_421_ = u32();
                        phi_422_ = 0u;
                        phi_424_ = true;
                    }
                    let _e208 = phi_421_;
                    let _e210 = phi_422_;
                    let _e212 = phi_424_;
                    if _e212 {
                        phi_429_ = (_e210 + 1u);
                    } else {
                        phi_429_ = 0u;
                    }
                    let _e216 = phi_429_;
                    let _e217 = select(_e208, _e210, _e212);
                    let _e218 = select(_e203, select(2u, _e203, _e202), _e212);
                    let _e219 = -(_e198);
                    if (_e219 < -126i) {
                        phi_462_ = -126i;
                    } else {
                        phi_462_ = select(_e219, 127i, (_e219 > 127i));
                    }
                    let _e224 = phi_462_;
                    let _e229 = bitcast<f32>((bitcast<u32>((_e224 + 127i)) << bitcast<u32>(23i)));
                    let _e235 = bitcast<f32>((bitcast<u32>(((_e219 - _e224) + 127i)) << bitcast<u32>(23i)));
                    let _e240 = global_3.member[_e88].member.member;
                    let _e241 = (_e217 == 0u);
                    if _e241 {
                        phi_480_ = _e240[0];
                    } else {
                        phi_480_ = _e240[1];
                    }
                    let _e245 = phi_480_;
                    let _e246 = (_e217 == 2u);
                    if _e246 {
                        phi_486_ = _e240[2];
                    } else {
                        phi_486_ = _e245;
                    }
                    let _e249 = phi_486_;
                    let _e250 = bitcast<u32>(_e249);
                    let _e252 = ((_e250 & 2139095040u) != 0u);
                    let _e264 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e249, _e252) * select(0.00000011920929f, 1f, _e252));
                    let _e265 = global_3.member[_e88].member.member_2;
                    if _e241 {
                        phi_526_ = _e265[0];
                    } else {
                        phi_526_ = _e265[1];
                    }
                    let _e269 = phi_526_;
                    if _e246 {
                        phi_532_ = _e265[2];
                    } else {
                        phi_532_ = _e269;
                    }
                    let _e272 = phi_532_;
                    let _e273 = bitcast<u32>(_e272);
                    let _e275 = ((_e273 & 2139095040u) != 0u);
                    let _e289 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e273 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e273 & 2147483648u))), _e272, _e275) * _e229) * select(0.00000011920929f, 1f, _e275)) * _e235);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e296 = bitcast<f32>((bitcast<u32>(_e264) & 2147483647u));
                    let _e297 = (_e296 * 0.00000011920929f);
                    let _e300 = select(select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f)), 0f, _e293);
                    let _e301 = select(0f, _e289, _e293);
                    let _e302 = (_e264 + _e300);
                    let _e303 = (_e264 - _e300);
                    let _e305 = select(38685626000000000000000000f, (1f / _e289), _e293);
                    let _e306 = (_e216 == 0u);
                    if _e306 {
                        phi_605_ = _e240[0];
                    } else {
                        phi_605_ = _e240[1];
                    }
                    let _e310 = phi_605_;
                    let _e311 = (_e216 == 2u);
                    if _e311 {
                        phi_611_ = _e240[2];
                    } else {
                        phi_611_ = _e310;
                    }
                    let _e314 = phi_611_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e329 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * select(0.00000011920929f, 1f, _e317));
                    if _e306 {
                        phi_651_ = _e265[0];
                    } else {
                        phi_651_ = _e265[1];
                    }
                    let _e333 = phi_651_;
                    if _e311 {
                        phi_657_ = _e265[2];
                    } else {
                        phi_657_ = _e333;
                    }
                    let _e336 = phi_657_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e229) * select(0.00000011920929f, 1f, _e339)) * _e235);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e360 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e361 = (_e360 * 0.00000011920929f);
                    let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
                    let _e365 = select(0f, _e353, _e357);
                    let _e366 = (_e329 + _e364);
                    let _e367 = (_e329 - _e364);
                    let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
                    let _e370 = (_e218 == 0u);
                    if _e370 {
                        phi_730_ = _e240[0];
                    } else {
                        phi_730_ = _e240[1];
                    }
                    let _e374 = phi_730_;
                    let _e375 = (_e218 == 2u);
                    if _e375 {
                        phi_736_ = _e240[2];
                    } else {
                        phi_736_ = _e374;
                    }
                    let _e378 = phi_736_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e393 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * select(0.00000011920929f, 1f, _e381));
                    if _e370 {
                        phi_776_ = _e265[0];
                    } else {
                        phi_776_ = _e265[1];
                    }
                    let _e397 = phi_776_;
                    if _e375 {
                        phi_782_ = _e265[2];
                    } else {
                        phi_782_ = _e397;
                    }
                    let _e400 = phi_782_;
                    let _e401 = bitcast<u32>(_e400);
                    let _e403 = ((_e401 & 2139095040u) != 0u);
                    let _e417 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e401 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e401 & 2147483648u))), _e400, _e403) * _e229) * select(0.00000011920929f, 1f, _e403)) * _e235);
                    let _e421 = (bitcast<f32>((bitcast<u32>(_e417) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e424 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e425 = (_e424 * 0.00000011920929f);
                    let _e428 = select(select(0.00000000000011368684f, _e425, (_e425 > 0.00000000000011368684f)), 0f, _e421);
                    let _e429 = select(0f, _e417, _e421);
                    let _e430 = (_e393 + _e428);
                    let _e431 = (_e393 - _e428);
                    let _e433 = select(38685626000000000000000000f, (1f / _e417), _e421);
                    let _e435 = select(_e360, _e296, (_e296 > _e360));
                    if (_e179 && (select(_e424, _e435, (_e435 > _e424)) <= 1099511600000f)) {
                        let _e447 = ((_e165 & 8388607u) | (select(0u, 1u, ((_e165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e450 = bitcast<i32>((_e165 >> bitcast<u32>(23i)));
                        let _e454 = (_e447 == 0u);
                        let _e457 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e447)), 32u, _e454)) - 8i);
                        if (_e450 == 255i) {
                            phi_901_ = 255i;
                        } else {
                            phi_901_ = (((_e450 + select(0i, 1i, (_e450 == 0i))) - _e457) + _e198);
                        }
                        let _e465 = phi_901_;
                        let _e475 = (_e465 <= 0i);
                        if _e475 {
                            phi_924_ = u32();
                        } else {
                            if _e454 {
                                phi_923_ = u32();
                            } else {
                                phi_923_ = select(((bitcast<u32>(_e465) << bitcast<u32>(23i)) | ((_e447 << bitcast<u32>(((_e457 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e465 >= 255i));
                            }
                            let _e479 = phi_923_;
                            phi_924_ = _e479;
                        }
                        let _e481 = phi_924_;
                        let _e493 = ((_e175 & 8388607u) | (select(0u, 1u, ((_e175 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e496 = bitcast<i32>((_e175 >> bitcast<u32>(23i)));
                        let _e500 = (_e493 == 0u);
                        let _e503 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e493)), 32u, _e500)) - 8i);
                        if (_e496 == 255i) {
                            phi_961_ = 255i;
                        } else {
                            phi_961_ = (((_e496 + select(0i, 1i, (_e496 == 0i))) - _e503) + _e198);
                        }
                        let _e511 = phi_961_;
                        let _e521 = (_e511 <= 0i);
                        if _e521 {
                            phi_984_ = u32();
                        } else {
                            if _e500 {
                                phi_983_ = u32();
                            } else {
                                phi_983_ = select(((bitcast<u32>(_e511) << bitcast<u32>(23i)) | ((_e493 << bitcast<u32>(((_e503 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e511 >= 255i));
                            }
                            let _e525 = phi_983_;
                            phi_984_ = _e525;
                        }
                        let _e527 = phi_984_;
                        phi_992_ = bitcast<f32>(((_e174 & 2147483648u) | select(_e527, 0u, select(_e500, true, _e521))));
                        phi_993_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e481, 0u, select(_e454, true, _e475))));
                    } else {
                        phi_992_ = 0f;
                        phi_993_ = 1f;
                    }
                    let _e533 = phi_992_;
                    let _e535 = phi_993_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2982_ = false;
                    phi_1008_ = type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e533);
                    phi_1011_ = ((3u * _e76) + 1u);
                    phi_1013_ = (_e535 <= _e533);
                    phi_1015_ = 0u;
                    phi_1017_ = select(0u, 2147483648u, (_e76 == 0u));
                    loop {
                        let _e543 = phi_2982_;
                        let _e545 = phi_1008_;
                        let _e547 = phi_1011_;
                        let _e549 = phi_1013_;
                        let _e551 = phi_1015_;
                        let _e553 = phi_1017_;
                        local_2 = _e545;
                        if _e549 {
                            phi_1028_ = true;
                        } else {
                            phi_1028_ = (_e551 > 0u);
                        }
                        let _e556 = phi_1028_;
                        if _e556 {
                            let _e557 = (_e547 > 0u);
                            if _e557 {
                                if _e549 {
                                    phi_1060_ = _e549;
                                    phi_1061_ = _e551;
                                    phi_1062_ = _e553;
                                } else {
                                    let _e558 = (_e551 - 1u);
                                    let _e559 = (_e558 % 128u);
                                    let _e560 = (_e559 < 128u);
                                    if _e560 {
                                    } else {
                                        phi_3142_ = true;
                                        break;
                                    }
                                    let _e562 = local_1[_e559];
                                    if _e560 {
                                    } else {
                                        phi_3142_ = true;
                                        break;
                                    }
                                    let _e564 = local[_e559];
                                    phi_1060_ = (_e564 <= _e545.member_1);
                                    phi_1061_ = _e558;
                                    phi_1062_ = _e562;
                                }
                                let _e568 = phi_1060_;
                                let _e570 = phi_1061_;
                                let _e572 = phi_1062_;
                                if _e568 {
                                    let _e575 = ((_e572 & 2147483648u) != 0u);
                                    if _e575 {
                                        phi_1077_ = _e545;
                                        phi_1080_ = type_7(0u, ((_e572 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e582 = phi_1077_;
                                            let _e584 = phi_1080_;
                                            local_3 = _e582;
                                            if (_e584.member < _e584.member_1) {
                                                phi_1081_ = type_7((_e584.member + 1u), _e584.member_1);
                                                phi_1103_ = type_7(1u, _e584.member);
                                            } else {
                                                phi_1081_ = _e584;
                                                phi_1103_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e597 = phi_1081_;
                                            let _e599 = phi_1103_;
                                            let _e603 = (bitcast<i32>(_e599.member) != 0i);
                                            if _e603 {
                                                let _e604 = ((_e572 & 268435455u) + _e599.member_1);
                                                let _e605 = (_e604 < _e78);
                                                if _e605 {
                                                    if _e605 {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e609 = global_1.member[_e604].member_1;
                                                    phi_1124_ = _e609;
                                                } else {
                                                    phi_1124_ = 4294967295u;
                                                }
                                                let _e611 = phi_1124_;
                                                if (_e604 >= _e78) {
                                                    phi_1216_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e605 {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e613 = (_e217 % 3u);
                                                    let _e614 = (_e216 % 3u);
                                                    let _e615 = (_e218 % 3u);
                                                    if (_e613 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e621 = global_1.member[_e604].member[_e613];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e627 = global_1.member[_e604].member[_e614];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e633 = global_1.member[_e604].member[_e615];
                                                    let _e635 = (3u + _e613);
                                                    if (_e635 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e641 = global_1.member[_e604].member[_e635];
                                                    let _e642 = (3u + _e614);
                                                    if (_e642 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e648 = global_1.member[_e604].member[_e642];
                                                    let _e649 = (3u + _e615);
                                                    if (_e649 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e655 = global_1.member[_e604].member[_e649];
                                                    let _e657 = (6u + _e613);
                                                    if (_e657 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_1.member[_e604].member[_e657];
                                                    let _e664 = (6u + _e614);
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e670 = global_1.member[_e604].member[_e664];
                                                    let _e671 = (6u + _e615);
                                                    if (_e671 < 9u) {
                                                    } else {
                                                        phi_2976_ = true;
                                                        break;
                                                    }
                                                    let _e677 = global_1.member[_e604].member[_e671];
                                                    phi_1216_ = array<array<f32, 3>, 3>(array<f32, 3>(_e621, _e627, _e633), array<f32, 3>(_e641, _e648, _e655), array<f32, 3>(_e663, _e670, _e677));
                                                }
                                                let _e681 = phi_1216_;
                                                let _e697 = (_e681[0][2] - _e393);
                                                let _e700 = (((_e681[0][0] - _e264) * _e429) - (_e697 * _e301));
                                                let _e703 = (((_e681[0][1] - _e329) * _e429) - (_e697 * _e365));
                                                let _e706 = (_e681[1][2] - _e393);
                                                let _e709 = (((_e681[1][0] - _e264) * _e429) - (_e706 * _e301));
                                                let _e712 = (((_e681[1][1] - _e329) * _e429) - (_e706 * _e365));
                                                let _e715 = (_e681[2][2] - _e393);
                                                let _e718 = (((_e681[2][0] - _e264) * _e429) - (_e715 * _e301));
                                                let _e721 = (((_e681[2][1] - _e329) * _e429) - (_e715 * _e365));
                                                let _e722 = (_e718 * _e712);
                                                let _e723 = (_e721 * _e709);
                                                let _e724 = (_e700 * _e721);
                                                let _e725 = (_e703 * _e718);
                                                let _e726 = (_e709 * _e703);
                                                let _e727 = (_e712 * _e700);
                                                let _e732 = (((_e722 >= _e723) && (_e724 >= _e725)) && (_e726 >= _e727));
                                                let _e738 = (_e732 || (((_e722 <= _e723) && (_e724 <= _e725)) && (_e726 <= _e727)));
                                                if _e738 {
                                                    let _e740 = select(-1f, 1f, _e732);
                                                    let _e742 = ((_e722 - _e723) * _e740);
                                                    let _e744 = select(0f, _e742, (_e742 > 0f));
                                                    let _e746 = ((_e724 - _e725) * _e740);
                                                    let _e748 = select(0f, _e746, (_e746 > 0f));
                                                    let _e750 = ((_e726 - _e727) * _e740);
                                                    let _e752 = select(0f, _e750, (_e750 > 0f));
                                                    let _e754 = ((_e744 + _e748) + _e752);
                                                    let _e756 = select(_e681[1][0], _e681[0][0], (_e681[0][0] < _e681[1][0]));
                                                    let _e760 = select(_e681[1][0], _e681[0][0], (_e681[0][0] > _e681[1][0]));
                                                    let _e764 = select(_e681[1][1], _e681[0][1], (_e681[0][1] < _e681[1][1]));
                                                    let _e768 = select(_e681[1][1], _e681[0][1], (_e681[0][1] > _e681[1][1]));
                                                    let _e772 = select(_e681[1][2], _e681[0][2], (_e681[0][2] < _e681[1][2]));
                                                    let _e776 = select(_e681[1][2], _e681[0][2], (_e681[0][2] > _e681[1][2]));
                                                    let _e781 = ((select(_e681[2][0], _e756, (_e756 < _e681[2][0])) - _e302) * _e305);
                                                    let _e782 = ((select(_e681[2][0], _e760, (_e760 > _e681[2][0])) - _e303) * _e305);
                                                    let _e785 = ((select(_e681[2][1], _e764, (_e764 < _e681[2][1])) - _e366) * _e369);
                                                    let _e786 = ((select(_e681[2][1], _e768, (_e768 > _e681[2][1])) - _e367) * _e369);
                                                    let _e789 = ((select(_e681[2][2], _e772, (_e772 < _e681[2][2])) - _e430) * _e433);
                                                    let _e790 = ((select(_e681[2][2], _e776, (_e776 > _e681[2][2])) - _e431) * _e433);
                                                    let _e792 = select(_e790, _e789, (_e789 < _e790));
                                                    let _e794 = select(_e790, _e789, (_e789 > _e790));
                                                    let _e796 = select(_e782, _e781, (_e781 < _e782));
                                                    let _e798 = select(_e786, _e785, (_e785 < _e786));
                                                    let _e800 = select(_e798, _e796, (_e796 > _e798));
                                                    let _e802 = select(_e792, _e800, (_e800 > _e792));
                                                    let _e804 = select(_e782, _e781, (_e781 > _e782));
                                                    let _e806 = select(_e786, _e785, (_e785 > _e786));
                                                    let _e808 = select(_e806, _e804, (_e804 < _e806));
                                                    let _e810 = select(_e794, _e808, (_e808 < _e794));
                                                    let _e811 = -(_e792);
                                                    let _e817 = select(_e535, _e802, (_e802 > _e535));
                                                    let _e821 = select(_e709, _e700, (_e700 < _e709));
                                                    let _e826 = select(_e709, _e700, (_e700 > _e709));
                                                    let _e833 = select(_e712, _e703, (_e703 < _e712));
                                                    let _e838 = select(_e712, _e703, (_e703 > _e712));
                                                    let _e847 = (((((_e738 && (_e754 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e718, _e821, (_e821 < _e718)) <= 0f) && (select(_e718, _e826, (_e826 > _e718)) >= 0f))) && ((select(_e721, _e833, (_e833 < _e721)) <= 0f) && (select(_e721, _e838, (_e838 > _e721)) >= 0f))) && (_e817 <= (_e810 + (select(_e811, _e794, (_e794 > _e811)) * 0.0000019073523f)))) && (_e817 <= _e582.member_1));
                                                    if _e847 {
                                                        let _e852 = (_e681[1][0] - _e681[0][0]);
                                                        let _e853 = (_e681[1][1] - _e681[0][1]);
                                                        let _e854 = (_e681[1][2] - _e681[0][2]);
                                                        let _e855 = vec3<f32>(_e852, _e853, _e854);
                                                        let _e856 = (_e681[2][0] - _e681[1][0]);
                                                        let _e857 = (_e681[2][1] - _e681[1][1]);
                                                        let _e858 = (_e681[2][2] - _e681[1][2]);
                                                        let _e859 = vec3<f32>(_e856, _e857, _e858);
                                                        let _e860 = (_e681[0][0] - _e681[2][0]);
                                                        let _e861 = (_e681[0][1] - _e681[2][1]);
                                                        let _e862 = (_e681[0][2] - _e681[2][2]);
                                                        let _e863 = vec3<f32>(_e860, _e861, _e862);
                                                        let _e864 = abs(_e852);
                                                        let _e865 = abs(_e853);
                                                        if (_e864 != _e864) {
                                                            phi_2728_ = true;
                                                        } else {
                                                            phi_2728_ = (_e865 >= _e864);
                                                        }
                                                        let _e869 = phi_2728_;
                                                        let _e870 = select(_e864, _e865, _e869);
                                                        let _e871 = abs(_e854);
                                                        if (_e870 != _e870) {
                                                            phi_2743_ = true;
                                                        } else {
                                                            phi_2743_ = (_e871 >= _e870);
                                                        }
                                                        let _e875 = phi_2743_;
                                                        let _e876 = select(_e870, _e871, _e875);
                                                        let _e877 = abs(_e856);
                                                        let _e878 = abs(_e857);
                                                        if (_e877 != _e877) {
                                                            phi_2758_ = true;
                                                        } else {
                                                            phi_2758_ = (_e878 >= _e877);
                                                        }
                                                        let _e882 = phi_2758_;
                                                        let _e883 = select(_e877, _e878, _e882);
                                                        let _e884 = abs(_e858);
                                                        if (_e883 != _e883) {
                                                            phi_2773_ = true;
                                                        } else {
                                                            phi_2773_ = (_e884 >= _e883);
                                                        }
                                                        let _e888 = phi_2773_;
                                                        let _e889 = select(_e883, _e884, _e888);
                                                        let _e890 = abs(_e860);
                                                        let _e891 = abs(_e861);
                                                        if (_e890 != _e890) {
                                                            phi_2788_ = true;
                                                        } else {
                                                            phi_2788_ = (_e891 >= _e890);
                                                        }
                                                        let _e895 = phi_2788_;
                                                        let _e896 = select(_e890, _e891, _e895);
                                                        let _e897 = abs(_e862);
                                                        if (_e896 != _e896) {
                                                            phi_2803_ = true;
                                                        } else {
                                                            phi_2803_ = (_e897 >= _e896);
                                                        }
                                                        let _e901 = phi_2803_;
                                                        let _e902 = select(_e896, _e897, _e901);
                                                        let _e904 = select(_e889, _e876, (_e876 > _e889));
                                                        let _e906 = select(_e902, _e904, (_e904 > _e902));
                                                        if (_e876 == _e906) {
                                                            phi_1758_ = _e712;
                                                            phi_1759_ = _e709;
                                                            phi_1760_ = _e703;
                                                            phi_1761_ = _e700;
                                                            phi_1762_ = vec3<f32>(_e681[0][0], _e681[0][1], _e681[0][2]);
                                                            phi_1763_ = _e863;
                                                            phi_1764_ = _e859;
                                                            phi_1765_ = _e855;
                                                        } else {
                                                            let _e908 = (_e889 == _e906);
                                                            let _e913 = vec3(_e908);
                                                            phi_1758_ = select(_e703, _e721, _e908);
                                                            phi_1759_ = select(_e700, _e718, _e908);
                                                            phi_1760_ = select(_e721, _e712, _e908);
                                                            phi_1761_ = select(_e718, _e709, _e908);
                                                            phi_1762_ = select(vec3<f32>(_e681[2][0], _e681[2][1], _e681[2][2]), vec3<f32>(_e681[1][0], _e681[1][1], _e681[1][2]), _e913);
                                                            phi_1763_ = select(_e859, _e855, _e913);
                                                            phi_1764_ = select(_e855, _e863, _e913);
                                                            phi_1765_ = select(_e863, _e859, _e913);
                                                        }
                                                        let _e919 = phi_1758_;
                                                        let _e921 = phi_1759_;
                                                        let _e923 = phi_1760_;
                                                        let _e925 = phi_1761_;
                                                        let _e927 = phi_1762_;
                                                        let _e929 = phi_1763_;
                                                        let _e931 = phi_1764_;
                                                        let _e933 = phi_1765_;
                                                        let _e940 = ((_e931.y * _e929.z) - (_e929.y * _e931.z));
                                                        let _e945 = ((_e931.z * _e929.x) - (_e929.z * _e931.x));
                                                        let _e948 = ((_e931.x * _e929.y) - (_e929.x * _e931.y));
                                                        let _e951 = ((_e744 >= _e748) && (_e744 >= _e752));
                                                        let _e952 = (_e748 >= _e752);
                                                        let _e966 = (((_e940 * (select(select(_e681[2][0], _e681[1][0], _e952), _e681[0][0], _e951) - _e264)) + (_e945 * (select(select(_e681[2][1], _e681[1][1], _e952), _e681[0][1], _e951) - _e329))) + (_e948 * (select(select(_e681[2][2], _e681[1][2], _e952), _e681[0][2], _e951) - _e393)));
                                                        let _e971 = (((_e940 * _e301) + (_e945 * _e365)) + (_e948 * _e429));
                                                        let _e972 = (_e921 - _e925);
                                                        let _e973 = (_e919 - _e923);
                                                        let _e976 = ((_e972 * _e972) + (_e973 * _e973));
                                                        let _e983 = (-(((_e925 * _e972) + (_e923 * _e973))) / select(0.000000000000000000000000000000000000011754944f, _e976, (_e976 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e985 = select(1f, _e983, (_e983 < 1f));
                                                        let _e987 = select(0f, _e985, (_e985 > 0f));
                                                        let _e996 = ((_e927.x + (_e933.x * _e987)) - _e264);
                                                        let _e999 = ((_e927.y + (_e933.y * _e987)) - _e329);
                                                        let _e1002 = ((_e927.z + (_e933.z * _e987)) - _e393);
                                                        let _e1005 = bitcast<f32>((bitcast<u32>(_e996) & 2147483647u));
                                                        let _e1008 = bitcast<f32>((bitcast<u32>(_e999) & 2147483647u));
                                                        let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                        let _e1013 = bitcast<f32>((bitcast<u32>(_e1002) & 2147483647u));
                                                        let _e1015 = select(_e1013, _e1010, (_e1010 > _e1013));
                                                        let _e1019 = abs(_e940);
                                                        let _e1020 = abs(_e945);
                                                        if (_e1019 != _e1019) {
                                                            phi_2818_ = true;
                                                        } else {
                                                            phi_2818_ = (_e1020 >= _e1019);
                                                        }
                                                        let _e1024 = phi_2818_;
                                                        let _e1025 = select(_e1019, _e1020, _e1024);
                                                        let _e1026 = abs(_e948);
                                                        if (_e1025 != _e1025) {
                                                            phi_2833_ = true;
                                                        } else {
                                                            phi_2833_ = (_e1026 >= _e1025);
                                                        }
                                                        let _e1030 = phi_2833_;
                                                        let _e1046 = abs(_e931.x);
                                                        let _e1047 = abs(_e931.y);
                                                        if (_e1046 != _e1046) {
                                                            phi_2848_ = true;
                                                        } else {
                                                            phi_2848_ = (_e1047 >= _e1046);
                                                        }
                                                        let _e1051 = phi_2848_;
                                                        let _e1052 = select(_e1046, _e1047, _e1051);
                                                        let _e1053 = abs(_e931.z);
                                                        if (_e1052 != _e1052) {
                                                            phi_2863_ = true;
                                                        } else {
                                                            phi_2863_ = (_e1053 >= _e1052);
                                                        }
                                                        let _e1057 = phi_2863_;
                                                        let _e1060 = abs(_e929.x);
                                                        let _e1061 = abs(_e929.y);
                                                        if (_e1060 != _e1060) {
                                                            phi_2878_ = true;
                                                        } else {
                                                            phi_2878_ = (_e1061 >= _e1060);
                                                        }
                                                        let _e1065 = phi_2878_;
                                                        let _e1066 = select(_e1060, _e1061, _e1065);
                                                        let _e1067 = abs(_e929.z);
                                                        if (_e1066 != _e1066) {
                                                            phi_2893_ = true;
                                                        } else {
                                                            phi_2893_ = (_e1067 >= _e1066);
                                                        }
                                                        let _e1071 = phi_2893_;
                                                        let _e1076 = ((bitcast<f32>((bitcast<u32>(((((_e940 * _e996) + (_e945 * _e999)) + (_e948 * _e1002)) - _e966)) & 2147483647u)) <= ((0.0000009536743f * select(_e906, _e1015, (_e1015 > _e906))) * select(_e1025, _e1026, _e1030))) && !((bitcast<f32>((bitcast<u32>(_e971) & 2147483647u)) <= ((0.0000038146973f * select(_e1052, _e1053, _e1057)) * select(_e1066, _e1067, _e1071)))));
                                                        let _e1077 = (_e966 / _e971);
                                                        if (_e847 && !(_e1076)) {
                                                            let _e1080 = (_e1002 / _e429);
                                                            let _e1088 = (((_e940 * (_e996 - (_e301 * _e1080))) + (_e945 * (_e999 - (_e365 * _e1080)))) / _e971);
                                                            phi_1973_ = select(select(_e1080, (_e1080 + _e1088), (bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u)) <= _e906)), _e1077, _e1076);
                                                        } else {
                                                            phi_1973_ = _e1077;
                                                        }
                                                        let _e1097 = phi_1973_;
                                                        let _e1099 = select(_e810, _e1097, (_e1097 < _e810));
                                                        let _e1101 = select(_e802, _e1099, (_e1099 > _e802));
                                                        let _e1102 = (1f / _e754);
                                                        phi_1993_ = type_47(_e1101, (_e748 * _e1102), (_e752 * _e1102), ((_e847 && (_e1101 >= _e535)) && (_e1101 <= _e582.member_1)));
                                                        phi_1994_ = type_47();
                                                    } else {
                                                        phi_1993_ = type_47();
                                                        phi_1994_ = type_47(0f, 0f, 0f, _e847);
                                                    }
                                                    let _e1111 = phi_1993_;
                                                    let _e1113 = phi_1994_;
                                                    phi_1997_ = _e1111;
                                                    phi_1998_ = _e1113;
                                                    phi_1999_ = select(true, false, _e847);
                                                } else {
                                                    phi_1997_ = type_47();
                                                    phi_1998_ = type_47(0f, 0f, 0f, _e738);
                                                    phi_1999_ = true;
                                                }
                                                let _e1116 = phi_1997_;
                                                let _e1118 = phi_1998_;
                                                let _e1120 = phi_1999_;
                                                if _e1120 {
                                                    phi_2003_ = _e1118;
                                                } else {
                                                    phi_2003_ = _e1116;
                                                }
                                                let _e1122 = phi_2003_;
                                                if _e1122.member_3 {
                                                    phi_2012_ = type_22(_e1122.member, _e1122.member_1, _e1122.member_2, _e611);
                                                } else {
                                                    phi_2012_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1129 = phi_2012_;
                                                if (_e1129.member_3 != 4294967295u) {
                                                    if (_e611 != _e95) {
                                                        if (_e1129.member < _e582.member.member) {
                                                            phi_2038_ = true;
                                                        } else {
                                                            if (_e1129.member == _e582.member.member) {
                                                                phi_2037_ = (_e1129.member_3 < _e582.member.member_3);
                                                            } else {
                                                                phi_2037_ = false;
                                                            }
                                                            let _e1142 = phi_2037_;
                                                            phi_2038_ = _e1142;
                                                        }
                                                        let _e1144 = phi_2038_;
                                                        if _e1144 {
                                                            phi_2044_ = type_43(_e1129, _e1129.member);
                                                        } else {
                                                            phi_2044_ = _e582;
                                                        }
                                                        let _e1147 = phi_2044_;
                                                        phi_2045_ = _e1147;
                                                    } else {
                                                        phi_2045_ = _e582;
                                                    }
                                                    let _e1149 = phi_2045_;
                                                    phi_2046_ = _e1149;
                                                } else {
                                                    phi_2046_ = _e582;
                                                }
                                                let _e1151 = phi_2046_;
                                                phi_1078_ = _e1151;
                                            } else {
                                                phi_1078_ = type_43();
                                            }
                                            let _e1153 = phi_1078_;
                                            continue;
                                            continuing {
                                                phi_1077_ = _e1153;
                                                phi_1080_ = _e597;
                                                phi_2976_ = _e543;
                                                break if !(_e603);
                                            }
                                        }
                                        let _e1156 = phi_2976_;
                                        phi_3142_ = _e1156;
                                        if _e1156 {
                                            break;
                                        }
                                        phi_3177_ = _e1156;
                                        let _e1634 = local_3;
                                        phi_2047_ = _e1634;
                                    } else {
                                        phi_3177_ = _e543;
                                        phi_2047_ = _e545;
                                    }
                                    let _e1158 = phi_3177_;
                                    let _e1160 = phi_2047_;
                                    if _e575 {
                                        phi_2527_ = bool();
                                        phi_2528_ = u32();
                                        phi_2529_ = u32();
                                    } else {
                                        if (_e572 >= _e76) {
                                            phi_2112_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e572 < _e76) {
                                            } else {
                                                phi_3142_ = true;
                                                break;
                                            }
                                            let _e1163 = (_e217 % 3u);
                                            if (_e1163 < 3u) {
                                            } else {
                                                phi_3142_ = true;
                                                break;
                                            }
                                            let _e1169 = global_2.member[_e572].member[_e1163];
                                            let _e1175 = (_e216 % 3u);
                                            if (_e1175 < 3u) {
                                            } else {
                                                phi_3142_ = true;
                                                break;
                                            }
                                            let _e1181 = global_2.member[_e572].member[_e1175];
                                            let _e1187 = (_e218 % 3u);
                                            if (_e1187 < 3u) {
                                            } else {
                                                phi_3142_ = true;
                                                break;
                                            }
                                            let _e1193 = global_2.member[_e572].member[_e1187];
                                            let _e1203 = global_2.member[_e572].member_1;
                                            let _e1207 = global_2.member[_e572].member_2;
                                            phi_2112_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e1169[0], _e1169[1], _e1169[2], _e1169[3]), vec4<f32>(_e1181[0], _e1181[1], _e1181[2], _e1181[3]), vec4<f32>(_e1193[0], _e1193[1], _e1193[2], _e1193[3])), _e1203, _e1207);
                                        }
                                        let _e1210 = phi_2112_;
                                        let _e1222 = ((_e1210.member[0].x - _e302) * _e305);
                                        let _e1223 = ((_e1210.member[0].y - _e302) * _e305);
                                        let _e1224 = ((_e1210.member[0].z - _e303) * _e305);
                                        let _e1225 = ((_e1210.member[0].w - _e303) * _e305);
                                        let _e1235 = ((_e1210.member[1].x - _e366) * _e369);
                                        let _e1236 = ((_e1210.member[1].y - _e366) * _e369);
                                        let _e1237 = ((_e1210.member[1].z - _e367) * _e369);
                                        let _e1238 = ((_e1210.member[1].w - _e367) * _e369);
                                        let _e1248 = ((_e1210.member[2].x - _e430) * _e433);
                                        let _e1249 = ((_e1210.member[2].y - _e430) * _e433);
                                        let _e1250 = ((_e1210.member[2].z - _e431) * _e433);
                                        let _e1251 = ((_e1210.member[2].w - _e431) * _e433);
                                        let _e1253 = select(_e1250, _e1248, (_e1248 < _e1250));
                                        let _e1255 = select(_e1251, _e1249, (_e1249 < _e1251));
                                        let _e1257 = select(_e1250, _e1248, (_e1248 > _e1250));
                                        let _e1259 = select(_e1251, _e1249, (_e1249 > _e1251));
                                        let _e1261 = select(_e1224, _e1222, (_e1222 < _e1224));
                                        let _e1263 = select(_e1225, _e1223, (_e1223 < _e1225));
                                        let _e1265 = select(_e1237, _e1235, (_e1235 < _e1237));
                                        let _e1267 = select(_e1238, _e1236, (_e1236 < _e1238));
                                        let _e1269 = select(_e1265, _e1261, (_e1261 > _e1265));
                                        let _e1271 = select(_e1267, _e1263, (_e1263 > _e1267));
                                        let _e1273 = select(_e1253, _e1269, (_e1269 > _e1253));
                                        let _e1275 = select(_e1255, _e1271, (_e1271 > _e1255));
                                        let _e1277 = select(_e1224, _e1222, (_e1222 > _e1224));
                                        let _e1279 = select(_e1225, _e1223, (_e1223 > _e1225));
                                        let _e1281 = select(_e1237, _e1235, (_e1235 > _e1237));
                                        let _e1283 = select(_e1238, _e1236, (_e1236 > _e1238));
                                        let _e1285 = select(_e1281, _e1277, (_e1277 < _e1281));
                                        let _e1287 = select(_e1283, _e1279, (_e1279 < _e1283));
                                        let _e1292 = -(_e1253);
                                        let _e1293 = -(_e1255);
                                        let _e1300 = (select(_e1257, _e1285, (_e1285 < _e1257)) + (select(_e1292, _e1257, (_e1257 > _e1292)) * 0.0000019073523f));
                                        let _e1301 = (select(_e1259, _e1287, (_e1287 < _e1259)) + (select(_e1293, _e1259, (_e1259 > _e1293)) * 0.0000019073523f));
                                        let _e1303 = select(_e535, _e1273, (_e1273 > _e535));
                                        let _e1305 = select(_e535, _e1275, (_e1275 > _e535));
                                        let _e1310 = (_e1303 <= select(_e1160.member_1, _e1300, (_e1300 < _e1160.member_1)));
                                        let _e1311 = (_e1305 <= select(_e1160.member_1, _e1301, (_e1301 < _e1160.member_1)));
                                        let _e1312 = (_e1303 <= _e1305);
                                        if _e1310 {
                                            if _e1311 {
                                                if _e1312 {
                                                    phi_2474_ = _e1210.member_2;
                                                } else {
                                                    phi_2474_ = _e1210.member_1;
                                                }
                                                let _e1316 = phi_2474_;
                                                let _e1318 = (_e570 % 128u);
                                                let _e1319 = (_e1318 < 128u);
                                                if _e1319 {
                                                } else {
                                                    phi_3142_ = true;
                                                    break;
                                                }
                                                local_1[_e1318] = _e1316;
                                                if _e1319 {
                                                } else {
                                                    phi_3142_ = true;
                                                    break;
                                                }
                                                local[_e1318] = select(_e1303, _e1305, _e1312);
                                                if _e1312 {
                                                    phi_2501_ = _e1210.member_1;
                                                } else {
                                                    phi_2501_ = _e1210.member_2;
                                                }
                                                let _e1326 = phi_2501_;
                                                phi_2502_ = (_e570 + 1u);
                                                phi_2503_ = _e1326;
                                            } else {
                                                phi_2502_ = u32();
                                                phi_2503_ = u32();
                                            }
                                            let _e1328 = phi_2502_;
                                            let _e1330 = phi_2503_;
                                            phi_2505_ = _e1328;
                                            phi_2506_ = _e1330;
                                            phi_2507_ = select(true, false, _e1311);
                                        } else {
                                            phi_2505_ = u32();
                                            phi_2506_ = u32();
                                            phi_2507_ = true;
                                        }
                                        let _e1333 = phi_2505_;
                                        let _e1335 = phi_2506_;
                                        let _e1337 = phi_2507_;
                                        if _e1337 {
                                            if _e1310 {
                                                phi_2516_ = _e1210.member_1;
                                            } else {
                                                phi_2516_ = _e1210.member_2;
                                            }
                                            let _e1341 = phi_2516_;
                                            phi_2521_ = select(_e1311, true, _e1310);
                                            phi_2523_ = _e1341;
                                        } else {
                                            phi_2521_ = _e568;
                                            phi_2523_ = _e1335;
                                        }
                                        let _e1344 = phi_2521_;
                                        let _e1346 = phi_2523_;
                                        phi_2527_ = _e1344;
                                        phi_2528_ = select(_e1333, _e570, _e1337);
                                        phi_2529_ = _e1346;
                                    }
                                    let _e1349 = phi_2527_;
                                    let _e1351 = phi_2528_;
                                    let _e1353 = phi_2529_;
                                    phi_3145_ = _e1158;
                                    phi_2540_ = _e1160;
                                    phi_2541_ = (_e547 - 1u);
                                    phi_2542_ = select(_e1349, false, _e575);
                                    phi_2543_ = select(_e1351, _e570, _e575);
                                    phi_2544_ = select(_e1353, _e572, _e575);
                                } else {
                                    phi_3145_ = _e543;
                                    phi_2540_ = _e545;
                                    phi_2541_ = _e547;
                                    phi_2542_ = _e568;
                                    phi_2543_ = _e570;
                                    phi_2544_ = _e572;
                                }
                                let _e1358 = phi_3145_;
                                let _e1360 = phi_2540_;
                                let _e1362 = phi_2541_;
                                let _e1364 = phi_2542_;
                                let _e1366 = phi_2543_;
                                let _e1368 = phi_2544_;
                                phi_3144_ = _e1358;
                                phi_2545_ = _e1360;
                                phi_2546_ = _e1362;
                                phi_2547_ = _e1364;
                                phi_2548_ = _e1366;
                                phi_2549_ = _e1368;
                            } else {
                                phi_3144_ = _e543;
                                phi_2545_ = type_43();
                                phi_2546_ = u32();
                                phi_2547_ = bool();
                                phi_2548_ = u32();
                                phi_2549_ = u32();
                            }
                            let _e1370 = phi_3144_;
                            let _e1372 = phi_2545_;
                            let _e1374 = phi_2546_;
                            let _e1376 = phi_2547_;
                            let _e1378 = phi_2548_;
                            let _e1380 = phi_2549_;
                            phi_3143_ = _e1370;
                            phi_1009_ = _e1372;
                            phi_1012_ = _e1374;
                            phi_1014_ = _e1376;
                            phi_1016_ = _e1378;
                            phi_1018_ = _e1380;
                            phi_2550_ = _e557;
                        } else {
                            phi_3143_ = _e543;
                            phi_1009_ = type_43();
                            phi_1012_ = u32();
                            phi_1014_ = bool();
                            phi_1016_ = u32();
                            phi_1018_ = u32();
                            phi_2550_ = false;
                        }
                        let _e1382 = phi_3143_;
                        let _e1384 = phi_1009_;
                        let _e1386 = phi_1012_;
                        let _e1388 = phi_1014_;
                        let _e1390 = phi_1016_;
                        let _e1392 = phi_1018_;
                        let _e1394 = phi_2550_;
                        continue;
                        continuing {
                            phi_2982_ = _e1382;
                            phi_1008_ = _e1384;
                            phi_1011_ = _e1386;
                            phi_1013_ = _e1388;
                            phi_1015_ = _e1390;
                            phi_1017_ = _e1392;
                            phi_3142_ = _e1382;
                            break if !(_e1394);
                        }
                    }
                    let _e1397 = phi_3142_;
                    if _e1397 {
                        break;
                    }
                    let _e1399 = local_2;
                    if (_e1399.member.member_3 != 4294967295u) {
                        let _e1404 = bitcast<u32>(_e1399.member.member);
                        let _e1408 = (bitcast<i32>((_e1404 >> bitcast<u32>(23i))) & 255i);
                        let _e1409 = (_e1408 + _e219);
                        if (_e1408 == 255i) {
                            phi_2609_ = _e1399.member.member;
                        } else {
                            if (_e1408 > 0i) {
                                if (_e1409 > 0i) {
                                    let _e1413 = (_e1409 < 255i);
                                    if _e1413 {
                                        phi_2588_ = bitcast<f32>((_e1404 + bitcast<u32>((_e219 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2588_ = f32();
                                    }
                                    let _e1420 = phi_2588_;
                                    phi_2590_ = _e1420;
                                    phi_2591_ = select(true, false, _e1413);
                                } else {
                                    phi_2590_ = f32();
                                    phi_2591_ = true;
                                }
                                let _e1423 = phi_2590_;
                                let _e1425 = phi_2591_;
                                phi_2592_ = _e1423;
                                phi_2593_ = _e1425;
                            } else {
                                phi_2592_ = f32();
                                phi_2593_ = true;
                            }
                            let _e1427 = phi_2592_;
                            let _e1429 = phi_2593_;
                            if _e1429 {
                                let _e1430 = (_e1404 & 2147483648u);
                                let _e1437 = ((_e1404 & 8388607u) | (select(0u, 1u, ((_e1404 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1441 = (_e1437 == 0u);
                                if _e1441 {
                                    phi_2971_ = bitcast<f32>(_e1430);
                                } else {
                                    let _e1446 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1437)), 32u, _e1441) - 8u);
                                    let _e1449 = (_e1437 << bitcast<u32>((_e1446 & 31u)));
                                    let _e1451 = ((_e1409 + select(0i, 1i, (_e1408 == 0i))) - bitcast<i32>(_e1446));
                                    if (_e1451 >= 255i) {
                                        phi_2961_ = bitcast<f32>((_e1430 | 2139095040u));
                                        phi_2962_ = f32();
                                        phi_2963_ = true;
                                    } else {
                                        let _e1453 = (_e1451 > 0i);
                                        if _e1453 {
                                            phi_2955_ = bitcast<f32>(((_e1430 | (bitcast<u32>(_e1451) << bitcast<u32>(23i))) | (_e1449 & 8388607u)));
                                            phi_2956_ = f32();
                                        } else {
                                            if (_e1451 < -24i) {
                                                phi_2921_ = 26u;
                                            } else {
                                                phi_2921_ = bitcast<u32>((1i - _e1451));
                                            }
                                            let _e1458 = phi_2921_;
                                            let _e1459 = (_e1458 & 31u);
                                            let _e1461 = (_e1449 >> bitcast<u32>(_e1459));
                                            let _e1465 = (_e1449 & ((1u << bitcast<u32>(_e1459)) - 1u));
                                            let _e1469 = (1u << bitcast<u32>(((_e1458 - 1u) & 31u)));
                                            if (_e1465 > _e1469) {
                                                phi_2942_ = true;
                                            } else {
                                                if (_e1465 == _e1469) {
                                                    phi_2939_ = ((_e1461 & 1u) == 1u);
                                                } else {
                                                    phi_2939_ = false;
                                                }
                                                let _e1475 = phi_2939_;
                                                phi_2942_ = _e1475;
                                            }
                                            let _e1477 = phi_2942_;
                                            phi_2955_ = f32();
                                            phi_2956_ = bitcast<f32>((_e1430 | (_e1461 + select(0u, 1u, _e1477))));
                                        }
                                        let _e1490 = phi_2955_;
                                        let _e1492 = phi_2956_;
                                        phi_2961_ = _e1490;
                                        phi_2962_ = _e1492;
                                        phi_2963_ = _e1453;
                                    }
                                    let _e1496 = phi_2961_;
                                    let _e1498 = phi_2962_;
                                    let _e1500 = phi_2963_;
                                    phi_2971_ = select(_e1498, _e1496, _e1500);
                                }
                                let _e1504 = phi_2971_;
                                phi_2608_ = _e1504;
                            } else {
                                phi_2608_ = _e1427;
                            }
                            let _e1506 = phi_2608_;
                            phi_2609_ = _e1506;
                        }
                        let _e1508 = phi_2609_;
                        let _e1509 = bitcast<u32>(_e1508);
                        if ((_e1509 & 2147483647u) >= 2139095040u) {
                            phi_2621_ = bitcast<f32>(((_e1509 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2621_ = _e1508;
                        }
                        let _e1516 = phi_2621_;
                        phi_2626_ = type_22(_e1516, _e1399.member.member_1, _e1399.member.member_2, _e1399.member.member_3);
                    } else {
                        phi_2626_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1521 = phi_2626_;
                    if _e96 {
                    } else {
                        break;
                    }
                    global_4.member[_e88] = _e1521;
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e1525 = select(0u, 1u, (_e163 <= _e173));
                    if (_e1525 > 0u) {
                        let _e1527 = (1u < _e84);
                        if _e1527 {
                            if (0u < _e84) {
                            } else {
                                break;
                            }
                            let _e1531 = atomicAdd((&global_5.member[0u]), _e1525);
                            if ((_e1531 + _e1525) < _e1531) {
                                if _e1527 {
                                } else {
                                    break;
                                }
                                let _e1536 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1539 = select(0u, 1u, (_e1521.member_3 != 4294967295u));
                    if (_e1539 > 0u) {
                        let _e1541 = (3u < _e84);
                        if _e1541 {
                            if (2u < _e84) {
                            } else {
                                break;
                            }
                            let _e1545 = atomicAdd((&global_5.member[2u]), _e1539);
                            if ((_e1545 + _e1539) < _e1545) {
                                if _e1541 {
                                } else {
                                    break;
                                }
                                let _e1550 = atomicAdd((&global_5.member[3u]), 1u);
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
