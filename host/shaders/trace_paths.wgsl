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
    var phi_302_: u32;
    var phi_407_: i32;
    var phi_408_: i32;
    var phi_418_: bool;
    var phi_428_: u32;
    var phi_429_: u32;
    var phi_431_: bool;
    var phi_436_: u32;
    var phi_469_: i32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_658_: f32;
    var phi_664_: f32;
    var phi_737_: f32;
    var phi_743_: f32;
    var phi_783_: f32;
    var phi_789_: f32;
    var phi_908_: i32;
    var phi_930_: u32;
    var phi_931_: u32;
    var phi_968_: i32;
    var phi_990_: u32;
    var phi_991_: u32;
    var phi_999_: f32;
    var phi_1000_: f32;
    var phi_2911_: bool;
    var phi_1015_: type_43;
    var phi_1018_: bool;
    var phi_1020_: u32;
    var phi_1022_: u32;
    var phi_1024_: u32;
    var phi_1035_: bool;
    var phi_1067_: bool;
    var phi_1068_: u32;
    var phi_1069_: u32;
    var phi_2089_: type_48;
    var phi_2451_: u32;
    var phi_2478_: u32;
    var phi_2479_: u32;
    var phi_2480_: u32;
    var phi_2482_: u32;
    var phi_2483_: u32;
    var phi_2484_: bool;
    var phi_2493_: u32;
    var phi_2498_: bool;
    var phi_2499_: u32;
    var phi_1084_: type_43;
    var phi_1087_: type_7;
    var phi_1088_: type_7;
    var phi_1110_: type_7;
    var phi_1131_: u32;
    var phi_1223_: array<array<f32, 3>, 3>;
    var phi_1753_: f32;
    var phi_1754_: f32;
    var phi_1755_: f32;
    var phi_1756_: f32;
    var phi_1757_: vec3<f32>;
    var phi_1758_: vec3<f32>;
    var phi_1759_: vec3<f32>;
    var phi_1760_: vec3<f32>;
    var phi_1951_: f32;
    var phi_1971_: type_47;
    var phi_1972_: type_47;
    var phi_1975_: type_47;
    var phi_1976_: type_47;
    var phi_1977_: bool;
    var phi_1981_: type_47;
    var phi_1990_: type_22;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2022_: type_43;
    var phi_2023_: type_43;
    var phi_2024_: type_43;
    var phi_1085_: type_43;
    var phi_2905_: bool;
    var local_2: type_43;
    var phi_3063_: bool;
    var phi_2501_: type_43;
    var phi_2502_: bool;
    var phi_2503_: u32;
    var phi_2504_: u32;
    var phi_3062_: bool;
    var phi_2505_: type_43;
    var phi_2506_: bool;
    var phi_2507_: u32;
    var phi_2508_: u32;
    var phi_2509_: u32;
    var phi_3061_: bool;
    var phi_2510_: type_43;
    var phi_2511_: bool;
    var phi_2512_: u32;
    var phi_2513_: u32;
    var phi_2514_: u32;
    var phi_3060_: bool;
    var phi_1016_: type_43;
    var phi_1019_: bool;
    var phi_1021_: u32;
    var phi_1023_: u32;
    var phi_1025_: u32;
    var phi_2515_: bool;
    var phi_3059_: bool;
    var local_3: type_43;
    var phi_2553_: f32;
    var phi_2555_: f32;
    var phi_2556_: bool;
    var phi_2557_: f32;
    var phi_2558_: bool;
    var phi_2850_: u32;
    var phi_2868_: bool;
    var phi_2871_: bool;
    var phi_2884_: f32;
    var phi_2885_: f32;
    var phi_2890_: f32;
    var phi_2891_: f32;
    var phi_2892_: bool;
    var phi_2900_: f32;
    var phi_2573_: f32;
    var phi_2574_: f32;
    var phi_2586_: f32;
    var phi_2591_: type_22;
    var local_4: type_43;

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
                phi_302_ = _e93;
            } else {
                phi_302_ = 4294967295u;
            }
            let _e95 = phi_302_;
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
                            phi_407_ = (bitcast<i32>((_e182 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_407_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u))));
                        }
                        let _e196 = phi_407_;
                        phi_408_ = _e196;
                    } else {
                        phi_408_ = 0i;
                    }
                    let _e198 = phi_408_;
                    let _e199 = (_e108 == _e152);
                    if _e199 {
                        phi_418_ = true;
                    } else {
                        phi_418_ = (_e116 == _e152);
                    }
                    let _e202 = phi_418_;
                    let _e203 = select(1u, 0u, _e199);
                    if _e202 {
                        let _e204 = (_e203 + 1u);
                        phi_428_ = _e204;
                        phi_429_ = _e204;
                        phi_431_ = select(true, false, (_e204 == 2u));
                    } else {
                        phi_428_ = u32();
                        phi_429_ = 0u;
                        phi_431_ = true;
                    }
                    let _e208 = phi_428_;
                    let _e210 = phi_429_;
                    let _e212 = phi_431_;
                    if _e212 {
                        phi_436_ = (_e210 + 1u);
                    } else {
                        phi_436_ = 0u;
                    }
                    let _e216 = phi_436_;
                    let _e217 = select(_e208, _e210, _e212);
                    let _e218 = select(_e203, select(2u, _e203, _e202), _e212);
                    let _e219 = -(_e198);
                    if (_e219 < -126i) {
                        phi_469_ = -126i;
                    } else {
                        phi_469_ = select(_e219, 127i, (_e219 > 127i));
                    }
                    let _e224 = phi_469_;
                    let _e229 = bitcast<f32>((bitcast<u32>((_e224 + 127i)) << bitcast<u32>(23i)));
                    let _e235 = bitcast<f32>((bitcast<u32>(((_e219 - _e224) + 127i)) << bitcast<u32>(23i)));
                    let _e240 = global_3.member[_e88].member.member;
                    let _e241 = (_e217 == 0u);
                    if _e241 {
                        phi_487_ = _e240[0];
                    } else {
                        phi_487_ = _e240[1];
                    }
                    let _e245 = phi_487_;
                    let _e246 = (_e217 == 2u);
                    if _e246 {
                        phi_493_ = _e240[2];
                    } else {
                        phi_493_ = _e245;
                    }
                    let _e249 = phi_493_;
                    let _e250 = bitcast<u32>(_e249);
                    let _e252 = ((_e250 & 2139095040u) != 0u);
                    let _e264 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e249, _e252) * select(0.00000011920929f, 1f, _e252));
                    let _e265 = global_3.member[_e88].member.member_2;
                    if _e241 {
                        phi_533_ = _e265[0];
                    } else {
                        phi_533_ = _e265[1];
                    }
                    let _e269 = phi_533_;
                    if _e246 {
                        phi_539_ = _e265[2];
                    } else {
                        phi_539_ = _e269;
                    }
                    let _e272 = phi_539_;
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
                        phi_612_ = _e240[0];
                    } else {
                        phi_612_ = _e240[1];
                    }
                    let _e310 = phi_612_;
                    let _e311 = (_e216 == 2u);
                    if _e311 {
                        phi_618_ = _e240[2];
                    } else {
                        phi_618_ = _e310;
                    }
                    let _e314 = phi_618_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e329 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * select(0.00000011920929f, 1f, _e317));
                    if _e306 {
                        phi_658_ = _e265[0];
                    } else {
                        phi_658_ = _e265[1];
                    }
                    let _e333 = phi_658_;
                    if _e311 {
                        phi_664_ = _e265[2];
                    } else {
                        phi_664_ = _e333;
                    }
                    let _e336 = phi_664_;
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
                        phi_737_ = _e240[0];
                    } else {
                        phi_737_ = _e240[1];
                    }
                    let _e374 = phi_737_;
                    let _e375 = (_e218 == 2u);
                    if _e375 {
                        phi_743_ = _e240[2];
                    } else {
                        phi_743_ = _e374;
                    }
                    let _e378 = phi_743_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e393 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * select(0.00000011920929f, 1f, _e381));
                    if _e370 {
                        phi_783_ = _e265[0];
                    } else {
                        phi_783_ = _e265[1];
                    }
                    let _e397 = phi_783_;
                    if _e375 {
                        phi_789_ = _e265[2];
                    } else {
                        phi_789_ = _e397;
                    }
                    let _e400 = phi_789_;
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
                            phi_908_ = 255i;
                        } else {
                            phi_908_ = (((_e450 + select(0i, 1i, (_e450 == 0i))) - _e457) + _e198);
                        }
                        let _e465 = phi_908_;
                        let _e475 = (_e465 <= 0i);
                        if _e475 {
                            phi_931_ = u32();
                        } else {
                            if _e454 {
                                phi_930_ = u32();
                            } else {
                                phi_930_ = select(((bitcast<u32>(_e465) << bitcast<u32>(23i)) | ((_e447 << bitcast<u32>(((_e457 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e465 >= 255i));
                            }
                            let _e479 = phi_930_;
                            phi_931_ = _e479;
                        }
                        let _e481 = phi_931_;
                        let _e493 = ((_e175 & 8388607u) | (select(0u, 1u, ((_e175 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e496 = bitcast<i32>((_e175 >> bitcast<u32>(23i)));
                        let _e500 = (_e493 == 0u);
                        let _e503 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e493)), 32u, _e500)) - 8i);
                        if (_e496 == 255i) {
                            phi_968_ = 255i;
                        } else {
                            phi_968_ = (((_e496 + select(0i, 1i, (_e496 == 0i))) - _e503) + _e198);
                        }
                        let _e511 = phi_968_;
                        let _e521 = (_e511 <= 0i);
                        if _e521 {
                            phi_991_ = u32();
                        } else {
                            if _e500 {
                                phi_990_ = u32();
                            } else {
                                phi_990_ = select(((bitcast<u32>(_e511) << bitcast<u32>(23i)) | ((_e493 << bitcast<u32>(((_e503 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e511 >= 255i));
                            }
                            let _e525 = phi_990_;
                            phi_991_ = _e525;
                        }
                        let _e527 = phi_991_;
                        phi_999_ = bitcast<f32>(((_e174 & 2147483648u) | select(_e527, 0u, select(_e500, true, _e521))));
                        phi_1000_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e481, 0u, select(_e454, true, _e475))));
                    } else {
                        phi_999_ = 0f;
                        phi_1000_ = 1f;
                    }
                    let _e533 = phi_999_;
                    let _e535 = phi_1000_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2911_ = false;
                    phi_1015_ = type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e533);
                    phi_1018_ = (_e535 <= _e533);
                    phi_1020_ = select(0u, 2147483648u, (_e76 == 0u));
                    phi_1022_ = 0u;
                    phi_1024_ = ((3u * _e76) + 1u);
                    loop {
                        let _e543 = phi_2911_;
                        let _e545 = phi_1015_;
                        let _e547 = phi_1018_;
                        let _e549 = phi_1020_;
                        let _e551 = phi_1022_;
                        let _e553 = phi_1024_;
                        local_3 = _e545;
                        if _e547 {
                            phi_1035_ = true;
                        } else {
                            phi_1035_ = (_e551 > 0u);
                        }
                        let _e556 = phi_1035_;
                        if _e556 {
                            let _e557 = (_e553 > 0u);
                            if _e557 {
                                if _e547 {
                                    phi_1067_ = _e547;
                                    phi_1068_ = _e549;
                                    phi_1069_ = _e551;
                                } else {
                                    let _e558 = (_e551 - 1u);
                                    let _e559 = (_e558 % 128u);
                                    let _e560 = (_e559 < 128u);
                                    if _e560 {
                                    } else {
                                        phi_3059_ = true;
                                        break;
                                    }
                                    let _e562 = local_1[_e559];
                                    if _e560 {
                                    } else {
                                        phi_3059_ = true;
                                        break;
                                    }
                                    let _e564 = local[_e559];
                                    phi_1067_ = (_e564 <= _e545.member_1);
                                    phi_1068_ = _e562;
                                    phi_1069_ = _e558;
                                }
                                let _e568 = phi_1067_;
                                let _e570 = phi_1068_;
                                let _e572 = phi_1069_;
                                if _e568 {
                                    if ((_e570 & 2147483648u) != 0u) {
                                        phi_1084_ = _e545;
                                        phi_1087_ = type_7(0u, ((_e570 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e769 = phi_1084_;
                                            let _e771 = phi_1087_;
                                            local_2 = _e769;
                                            local_4 = _e769;
                                            if (_e771.member < _e771.member_1) {
                                                phi_1088_ = type_7((_e771.member + 1u), _e771.member_1);
                                                phi_1110_ = type_7(1u, _e771.member);
                                            } else {
                                                phi_1088_ = _e771;
                                                phi_1110_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e784 = phi_1088_;
                                            let _e786 = phi_1110_;
                                            let _e790 = (bitcast<i32>(_e786.member) != 0i);
                                            if _e790 {
                                                let _e791 = ((_e570 & 268435455u) + _e786.member_1);
                                                let _e792 = (_e791 < _e78);
                                                if _e792 {
                                                    if _e792 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_1.member[_e791].member_1;
                                                    phi_1131_ = _e796;
                                                } else {
                                                    phi_1131_ = 4294967295u;
                                                }
                                                let _e798 = phi_1131_;
                                                if (_e791 >= _e78) {
                                                    phi_1223_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e792 {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e800 = (_e217 % 3u);
                                                    let _e801 = (_e216 % 3u);
                                                    let _e802 = (_e218 % 3u);
                                                    if (_e800 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e808 = global_1.member[_e791].member[_e800];
                                                    if (_e801 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e814 = global_1.member[_e791].member[_e801];
                                                    if (_e802 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e820 = global_1.member[_e791].member[_e802];
                                                    let _e822 = (3u + _e800);
                                                    if (_e822 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e828 = global_1.member[_e791].member[_e822];
                                                    let _e829 = (3u + _e801);
                                                    if (_e829 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e835 = global_1.member[_e791].member[_e829];
                                                    let _e836 = (3u + _e802);
                                                    if (_e836 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e842 = global_1.member[_e791].member[_e836];
                                                    let _e844 = (6u + _e800);
                                                    if (_e844 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e850 = global_1.member[_e791].member[_e844];
                                                    let _e851 = (6u + _e801);
                                                    if (_e851 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e857 = global_1.member[_e791].member[_e851];
                                                    let _e858 = (6u + _e802);
                                                    if (_e858 < 9u) {
                                                    } else {
                                                        phi_2905_ = true;
                                                        break;
                                                    }
                                                    let _e864 = global_1.member[_e791].member[_e858];
                                                    phi_1223_ = array<array<f32, 3>, 3>(array<f32, 3>(_e808, _e814, _e820), array<f32, 3>(_e828, _e835, _e842), array<f32, 3>(_e850, _e857, _e864));
                                                }
                                                let _e868 = phi_1223_;
                                                let _e884 = (_e868[0][2] - _e393);
                                                let _e887 = (((_e868[0][0] - _e264) * _e429) - (_e884 * _e301));
                                                let _e890 = (((_e868[0][1] - _e329) * _e429) - (_e884 * _e365));
                                                let _e893 = (_e868[1][2] - _e393);
                                                let _e896 = (((_e868[1][0] - _e264) * _e429) - (_e893 * _e301));
                                                let _e899 = (((_e868[1][1] - _e329) * _e429) - (_e893 * _e365));
                                                let _e902 = (_e868[2][2] - _e393);
                                                let _e905 = (((_e868[2][0] - _e264) * _e429) - (_e902 * _e301));
                                                let _e908 = (((_e868[2][1] - _e329) * _e429) - (_e902 * _e365));
                                                let _e909 = (_e905 * _e899);
                                                let _e910 = (_e908 * _e896);
                                                let _e911 = (_e887 * _e908);
                                                let _e912 = (_e890 * _e905);
                                                let _e913 = (_e896 * _e890);
                                                let _e914 = (_e899 * _e887);
                                                let _e919 = (((_e909 >= _e910) && (_e911 >= _e912)) && (_e913 >= _e914));
                                                let _e925 = (_e919 || (((_e909 <= _e910) && (_e911 <= _e912)) && (_e913 <= _e914)));
                                                if _e925 {
                                                    let _e927 = select(-1f, 1f, _e919);
                                                    let _e929 = ((_e909 - _e910) * _e927);
                                                    let _e931 = select(0f, _e929, (_e929 > 0f));
                                                    let _e933 = ((_e911 - _e912) * _e927);
                                                    let _e935 = select(0f, _e933, (_e933 > 0f));
                                                    let _e937 = ((_e913 - _e914) * _e927);
                                                    let _e939 = select(0f, _e937, (_e937 > 0f));
                                                    let _e941 = ((_e931 + _e935) + _e939);
                                                    let _e943 = select(_e868[1][0], _e868[0][0], (_e868[0][0] < _e868[1][0]));
                                                    let _e947 = select(_e868[1][0], _e868[0][0], (_e868[0][0] > _e868[1][0]));
                                                    let _e951 = select(_e868[1][1], _e868[0][1], (_e868[0][1] < _e868[1][1]));
                                                    let _e955 = select(_e868[1][1], _e868[0][1], (_e868[0][1] > _e868[1][1]));
                                                    let _e959 = select(_e868[1][2], _e868[0][2], (_e868[0][2] < _e868[1][2]));
                                                    let _e963 = select(_e868[1][2], _e868[0][2], (_e868[0][2] > _e868[1][2]));
                                                    let _e968 = ((select(_e868[2][0], _e943, (_e943 < _e868[2][0])) - _e302) * _e305);
                                                    let _e969 = ((select(_e868[2][0], _e947, (_e947 > _e868[2][0])) - _e303) * _e305);
                                                    let _e972 = ((select(_e868[2][1], _e951, (_e951 < _e868[2][1])) - _e366) * _e369);
                                                    let _e973 = ((select(_e868[2][1], _e955, (_e955 > _e868[2][1])) - _e367) * _e369);
                                                    let _e976 = ((select(_e868[2][2], _e959, (_e959 < _e868[2][2])) - _e430) * _e433);
                                                    let _e977 = ((select(_e868[2][2], _e963, (_e963 > _e868[2][2])) - _e431) * _e433);
                                                    let _e979 = select(_e977, _e976, (_e976 < _e977));
                                                    let _e981 = select(_e977, _e976, (_e976 > _e977));
                                                    let _e983 = select(_e969, _e968, (_e968 < _e969));
                                                    let _e985 = select(_e973, _e972, (_e972 < _e973));
                                                    let _e987 = select(_e985, _e983, (_e983 > _e985));
                                                    let _e989 = select(_e979, _e987, (_e987 > _e979));
                                                    let _e991 = select(_e969, _e968, (_e968 > _e969));
                                                    let _e993 = select(_e973, _e972, (_e972 > _e973));
                                                    let _e995 = select(_e993, _e991, (_e991 < _e993));
                                                    let _e997 = select(_e981, _e995, (_e995 < _e981));
                                                    let _e998 = -(_e979);
                                                    let _e1004 = select(_e535, _e989, (_e989 > _e535));
                                                    let _e1008 = select(_e896, _e887, (_e887 < _e896));
                                                    let _e1013 = select(_e896, _e887, (_e887 > _e896));
                                                    let _e1020 = select(_e899, _e890, (_e890 < _e899));
                                                    let _e1025 = select(_e899, _e890, (_e890 > _e899));
                                                    let _e1034 = (((((_e925 && (_e941 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e905, _e1008, (_e1008 < _e905)) <= 0f) && (select(_e905, _e1013, (_e1013 > _e905)) >= 0f))) && ((select(_e908, _e1020, (_e1020 < _e908)) <= 0f) && (select(_e908, _e1025, (_e1025 > _e908)) >= 0f))) && (_e1004 <= (_e997 + (select(_e998, _e981, (_e981 > _e998)) * 0.0000019073523f)))) && (_e1004 <= _e769.member_1));
                                                    if _e1034 {
                                                        let _e1039 = (_e868[1][0] - _e868[0][0]);
                                                        let _e1040 = (_e868[1][1] - _e868[0][1]);
                                                        let _e1041 = (_e868[1][2] - _e868[0][2]);
                                                        let _e1042 = vec3<f32>(_e1039, _e1040, _e1041);
                                                        let _e1043 = (_e868[2][0] - _e868[1][0]);
                                                        let _e1044 = (_e868[2][1] - _e868[1][1]);
                                                        let _e1045 = (_e868[2][2] - _e868[1][2]);
                                                        let _e1046 = vec3<f32>(_e1043, _e1044, _e1045);
                                                        let _e1047 = (_e868[0][0] - _e868[2][0]);
                                                        let _e1048 = (_e868[0][1] - _e868[2][1]);
                                                        let _e1049 = (_e868[0][2] - _e868[2][2]);
                                                        let _e1050 = vec3<f32>(_e1047, _e1048, _e1049);
                                                        let _e1053 = bitcast<f32>((bitcast<u32>(_e1039) & 2147483647u));
                                                        let _e1056 = bitcast<f32>((bitcast<u32>(_e1040) & 2147483647u));
                                                        let _e1058 = select(_e1056, _e1053, (_e1053 > _e1056));
                                                        let _e1061 = bitcast<f32>((bitcast<u32>(_e1041) & 2147483647u));
                                                        let _e1063 = select(_e1061, _e1058, (_e1058 > _e1061));
                                                        let _e1066 = bitcast<f32>((bitcast<u32>(_e1043) & 2147483647u));
                                                        let _e1069 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                        let _e1071 = select(_e1069, _e1066, (_e1066 > _e1069));
                                                        let _e1074 = bitcast<f32>((bitcast<u32>(_e1045) & 2147483647u));
                                                        let _e1076 = select(_e1074, _e1071, (_e1071 > _e1074));
                                                        let _e1079 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                        let _e1082 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                        let _e1084 = select(_e1082, _e1079, (_e1079 > _e1082));
                                                        let _e1087 = bitcast<f32>((bitcast<u32>(_e1049) & 2147483647u));
                                                        let _e1089 = select(_e1087, _e1084, (_e1084 > _e1087));
                                                        let _e1091 = select(_e1076, _e1063, (_e1063 > _e1076));
                                                        let _e1093 = select(_e1089, _e1091, (_e1091 > _e1089));
                                                        if (_e1063 == _e1093) {
                                                            phi_1753_ = _e899;
                                                            phi_1754_ = _e896;
                                                            phi_1755_ = _e890;
                                                            phi_1756_ = _e887;
                                                            phi_1757_ = vec3<f32>(_e868[0][0], _e868[0][1], _e868[0][2]);
                                                            phi_1758_ = _e1050;
                                                            phi_1759_ = _e1046;
                                                            phi_1760_ = _e1042;
                                                        } else {
                                                            let _e1095 = (_e1076 == _e1093);
                                                            let _e1100 = vec3(_e1095);
                                                            phi_1753_ = select(_e890, _e908, _e1095);
                                                            phi_1754_ = select(_e887, _e905, _e1095);
                                                            phi_1755_ = select(_e908, _e899, _e1095);
                                                            phi_1756_ = select(_e905, _e896, _e1095);
                                                            phi_1757_ = select(vec3<f32>(_e868[2][0], _e868[2][1], _e868[2][2]), vec3<f32>(_e868[1][0], _e868[1][1], _e868[1][2]), _e1100);
                                                            phi_1758_ = select(_e1046, _e1042, _e1100);
                                                            phi_1759_ = select(_e1042, _e1050, _e1100);
                                                            phi_1760_ = select(_e1050, _e1046, _e1100);
                                                        }
                                                        let _e1106 = phi_1753_;
                                                        let _e1108 = phi_1754_;
                                                        let _e1110 = phi_1755_;
                                                        let _e1112 = phi_1756_;
                                                        let _e1114 = phi_1757_;
                                                        let _e1116 = phi_1758_;
                                                        let _e1118 = phi_1759_;
                                                        let _e1120 = phi_1760_;
                                                        let _e1127 = ((_e1118.y * _e1116.z) - (_e1116.y * _e1118.z));
                                                        let _e1132 = ((_e1118.z * _e1116.x) - (_e1116.z * _e1118.x));
                                                        let _e1135 = ((_e1118.x * _e1116.y) - (_e1116.x * _e1118.y));
                                                        let _e1138 = ((_e931 >= _e935) && (_e931 >= _e939));
                                                        let _e1139 = (_e935 >= _e939);
                                                        let _e1153 = (((_e1127 * (select(select(_e868[2][0], _e868[1][0], _e1139), _e868[0][0], _e1138) - _e264)) + (_e1132 * (select(select(_e868[2][1], _e868[1][1], _e1139), _e868[0][1], _e1138) - _e329))) + (_e1135 * (select(select(_e868[2][2], _e868[1][2], _e1139), _e868[0][2], _e1138) - _e393)));
                                                        let _e1158 = (((_e1127 * _e301) + (_e1132 * _e365)) + (_e1135 * _e429));
                                                        let _e1159 = (_e1108 - _e1112);
                                                        let _e1160 = (_e1106 - _e1110);
                                                        let _e1163 = ((_e1159 * _e1159) + (_e1160 * _e1160));
                                                        let _e1170 = (-(((_e1112 * _e1159) + (_e1110 * _e1160))) / select(0.000000000000000000000000000000000000011754944f, _e1163, (_e1163 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1172 = select(1f, _e1170, (_e1170 < 1f));
                                                        let _e1174 = select(0f, _e1172, (_e1172 > 0f));
                                                        let _e1183 = ((_e1114.x + (_e1120.x * _e1174)) - _e264);
                                                        let _e1186 = ((_e1114.y + (_e1120.y * _e1174)) - _e329);
                                                        let _e1189 = ((_e1114.z + (_e1120.z * _e1174)) - _e393);
                                                        let _e1192 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                        let _e1195 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                        let _e1197 = select(_e1195, _e1192, (_e1192 > _e1195));
                                                        let _e1200 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
                                                        let _e1202 = select(_e1200, _e1197, (_e1197 > _e1200));
                                                        let _e1208 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                        let _e1211 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                        let _e1213 = select(_e1211, _e1208, (_e1208 > _e1211));
                                                        let _e1216 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1118.x) & 2147483647u));
                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1118.y) & 2147483647u));
                                                        let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                        let _e1243 = bitcast<f32>((bitcast<u32>(_e1118.z) & 2147483647u));
                                                        let _e1249 = bitcast<f32>((bitcast<u32>(_e1116.x) & 2147483647u));
                                                        let _e1252 = bitcast<f32>((bitcast<u32>(_e1116.y) & 2147483647u));
                                                        let _e1254 = select(_e1252, _e1249, (_e1249 > _e1252));
                                                        let _e1257 = bitcast<f32>((bitcast<u32>(_e1116.z) & 2147483647u));
                                                        let _e1263 = ((bitcast<f32>((bitcast<u32>(((((_e1127 * _e1183) + (_e1132 * _e1186)) + (_e1135 * _e1189)) - _e1153)) & 2147483647u)) <= ((0.0000009536743f * select(_e1093, _e1202, (_e1202 > _e1093))) * select(_e1216, _e1213, (_e1213 > _e1216)))) && !((bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u)) <= ((0.0000038146973f * select(_e1243, _e1240, (_e1240 > _e1243))) * select(_e1257, _e1254, (_e1254 > _e1257))))));
                                                        let _e1264 = (_e1153 / _e1158);
                                                        if (_e1034 && !(_e1263)) {
                                                            let _e1267 = (_e1189 / _e429);
                                                            let _e1275 = (((_e1127 * (_e1183 - (_e301 * _e1267))) + (_e1132 * (_e1186 - (_e365 * _e1267)))) / _e1158);
                                                            phi_1951_ = select(select(_e1267, (_e1267 + _e1275), (bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u)) <= _e1093)), _e1264, _e1263);
                                                        } else {
                                                            phi_1951_ = _e1264;
                                                        }
                                                        let _e1284 = phi_1951_;
                                                        let _e1286 = select(_e997, _e1284, (_e1284 < _e997));
                                                        let _e1288 = select(_e989, _e1286, (_e1286 > _e989));
                                                        let _e1289 = (1f / _e941);
                                                        phi_1971_ = type_47(_e1288, (_e935 * _e1289), (_e939 * _e1289), ((_e1034 && (_e1288 >= _e535)) && (_e1288 <= _e769.member_1)));
                                                        phi_1972_ = type_47();
                                                    } else {
                                                        phi_1971_ = type_47();
                                                        phi_1972_ = type_47(0f, 0f, 0f, _e1034);
                                                    }
                                                    let _e1298 = phi_1971_;
                                                    let _e1300 = phi_1972_;
                                                    phi_1975_ = _e1298;
                                                    phi_1976_ = _e1300;
                                                    phi_1977_ = select(true, false, _e1034);
                                                } else {
                                                    phi_1975_ = type_47();
                                                    phi_1976_ = type_47(0f, 0f, 0f, _e925);
                                                    phi_1977_ = true;
                                                }
                                                let _e1303 = phi_1975_;
                                                let _e1305 = phi_1976_;
                                                let _e1307 = phi_1977_;
                                                if _e1307 {
                                                    phi_1981_ = _e1305;
                                                } else {
                                                    phi_1981_ = _e1303;
                                                }
                                                let _e1309 = phi_1981_;
                                                if _e1309.member_3 {
                                                    phi_1990_ = type_22(_e1309.member, _e1309.member_1, _e1309.member_2, _e798);
                                                } else {
                                                    phi_1990_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1316 = phi_1990_;
                                                if (_e1316.member_3 != 4294967295u) {
                                                    if (_e798 != _e95) {
                                                        if (_e1316.member < _e769.member.member) {
                                                            phi_2016_ = true;
                                                        } else {
                                                            if (_e1316.member == _e769.member.member) {
                                                                phi_2015_ = (_e1316.member_3 < _e769.member.member_3);
                                                            } else {
                                                                phi_2015_ = false;
                                                            }
                                                            let _e1329 = phi_2015_;
                                                            phi_2016_ = _e1329;
                                                        }
                                                        let _e1331 = phi_2016_;
                                                        if _e1331 {
                                                            phi_2022_ = type_43(_e1316, _e1316.member);
                                                        } else {
                                                            phi_2022_ = _e769;
                                                        }
                                                        let _e1334 = phi_2022_;
                                                        phi_2023_ = _e1334;
                                                    } else {
                                                        phi_2023_ = _e769;
                                                    }
                                                    let _e1336 = phi_2023_;
                                                    phi_2024_ = _e1336;
                                                } else {
                                                    phi_2024_ = _e769;
                                                }
                                                let _e1338 = phi_2024_;
                                                phi_1085_ = _e1338;
                                            } else {
                                                phi_1085_ = type_43();
                                            }
                                            let _e1340 = phi_1085_;
                                            continue;
                                            continuing {
                                                phi_1084_ = _e1340;
                                                phi_1087_ = _e784;
                                                phi_2905_ = _e543;
                                                break if !(_e790);
                                            }
                                        }
                                        let _e1343 = phi_2905_;
                                        phi_3059_ = _e1343;
                                        if _e1343 {
                                            break;
                                        }
                                        let _e1345 = local_2;
                                        phi_3063_ = _e1343;
                                        let _e1636 = local_4;
                                        phi_2501_ = _e1636;
                                        phi_2502_ = false;
                                        phi_2503_ = _e570;
                                        phi_2504_ = select(_e572, 0u, (_e535 > _e1345.member_1));
                                    } else {
                                        if (_e570 >= _e76) {
                                            phi_2089_ = type_48(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e570 < _e76) {
                                            } else {
                                                phi_3059_ = true;
                                                break;
                                            }
                                            let _e582 = (_e217 % 3u);
                                            if (_e582 < 3u) {
                                            } else {
                                                phi_3059_ = true;
                                                break;
                                            }
                                            let _e588 = global_2.member[_e570].member[_e582];
                                            let _e594 = (_e216 % 3u);
                                            if (_e594 < 3u) {
                                            } else {
                                                phi_3059_ = true;
                                                break;
                                            }
                                            let _e600 = global_2.member[_e570].member[_e594];
                                            let _e606 = (_e218 % 3u);
                                            if (_e606 < 3u) {
                                            } else {
                                                phi_3059_ = true;
                                                break;
                                            }
                                            let _e612 = global_2.member[_e570].member[_e606];
                                            let _e622 = global_2.member[_e570].member_1;
                                            let _e626 = global_2.member[_e570].member_2;
                                            phi_2089_ = type_48(array<vec4<f32>, 3>(vec4<f32>(_e588[0], _e588[1], _e588[2], _e588[3]), vec4<f32>(_e600[0], _e600[1], _e600[2], _e600[3]), vec4<f32>(_e612[0], _e612[1], _e612[2], _e612[3])), _e622, _e626);
                                        }
                                        let _e629 = phi_2089_;
                                        let _e641 = ((_e629.member[0].x - _e302) * _e305);
                                        let _e642 = ((_e629.member[0].y - _e302) * _e305);
                                        let _e643 = ((_e629.member[0].z - _e303) * _e305);
                                        let _e644 = ((_e629.member[0].w - _e303) * _e305);
                                        let _e654 = ((_e629.member[1].x - _e366) * _e369);
                                        let _e655 = ((_e629.member[1].y - _e366) * _e369);
                                        let _e656 = ((_e629.member[1].z - _e367) * _e369);
                                        let _e657 = ((_e629.member[1].w - _e367) * _e369);
                                        let _e667 = ((_e629.member[2].x - _e430) * _e433);
                                        let _e668 = ((_e629.member[2].y - _e430) * _e433);
                                        let _e669 = ((_e629.member[2].z - _e431) * _e433);
                                        let _e670 = ((_e629.member[2].w - _e431) * _e433);
                                        let _e672 = select(_e669, _e667, (_e667 < _e669));
                                        let _e674 = select(_e670, _e668, (_e668 < _e670));
                                        let _e676 = select(_e669, _e667, (_e667 > _e669));
                                        let _e678 = select(_e670, _e668, (_e668 > _e670));
                                        let _e680 = select(_e643, _e641, (_e641 < _e643));
                                        let _e682 = select(_e644, _e642, (_e642 < _e644));
                                        let _e684 = select(_e656, _e654, (_e654 < _e656));
                                        let _e686 = select(_e657, _e655, (_e655 < _e657));
                                        let _e688 = select(_e684, _e680, (_e680 > _e684));
                                        let _e690 = select(_e686, _e682, (_e682 > _e686));
                                        let _e692 = select(_e672, _e688, (_e688 > _e672));
                                        let _e694 = select(_e674, _e690, (_e690 > _e674));
                                        let _e696 = select(_e643, _e641, (_e641 > _e643));
                                        let _e698 = select(_e644, _e642, (_e642 > _e644));
                                        let _e700 = select(_e656, _e654, (_e654 > _e656));
                                        let _e702 = select(_e657, _e655, (_e655 > _e657));
                                        let _e704 = select(_e700, _e696, (_e696 < _e700));
                                        let _e706 = select(_e702, _e698, (_e698 < _e702));
                                        let _e711 = -(_e672);
                                        let _e712 = -(_e674);
                                        let _e719 = (select(_e676, _e704, (_e704 < _e676)) + (select(_e711, _e676, (_e676 > _e711)) * 0.0000019073523f));
                                        let _e720 = (select(_e678, _e706, (_e706 < _e678)) + (select(_e712, _e678, (_e678 > _e712)) * 0.0000019073523f));
                                        let _e722 = select(_e535, _e692, (_e692 > _e535));
                                        let _e724 = select(_e535, _e694, (_e694 > _e535));
                                        let _e729 = (_e722 <= select(_e545.member_1, _e719, (_e719 < _e545.member_1)));
                                        let _e730 = (_e724 <= select(_e545.member_1, _e720, (_e720 < _e545.member_1)));
                                        let _e731 = (_e722 <= _e724);
                                        if _e729 {
                                            if _e730 {
                                                if _e731 {
                                                    phi_2451_ = _e629.member_2;
                                                } else {
                                                    phi_2451_ = _e629.member_1;
                                                }
                                                let _e735 = phi_2451_;
                                                let _e737 = (_e572 % 128u);
                                                let _e738 = (_e737 < 128u);
                                                if _e738 {
                                                } else {
                                                    phi_3059_ = true;
                                                    break;
                                                }
                                                local_1[_e737] = _e735;
                                                if _e738 {
                                                } else {
                                                    phi_3059_ = true;
                                                    break;
                                                }
                                                local[_e737] = select(_e722, _e724, _e731);
                                                if _e731 {
                                                    phi_2478_ = _e629.member_1;
                                                } else {
                                                    phi_2478_ = _e629.member_2;
                                                }
                                                let _e745 = phi_2478_;
                                                phi_2479_ = _e745;
                                                phi_2480_ = (_e572 + 1u);
                                            } else {
                                                phi_2479_ = u32();
                                                phi_2480_ = u32();
                                            }
                                            let _e747 = phi_2479_;
                                            let _e749 = phi_2480_;
                                            phi_2482_ = _e747;
                                            phi_2483_ = _e749;
                                            phi_2484_ = select(true, false, _e730);
                                        } else {
                                            phi_2482_ = u32();
                                            phi_2483_ = u32();
                                            phi_2484_ = true;
                                        }
                                        let _e752 = phi_2482_;
                                        let _e754 = phi_2483_;
                                        let _e756 = phi_2484_;
                                        if _e756 {
                                            if _e729 {
                                                phi_2493_ = _e629.member_1;
                                            } else {
                                                phi_2493_ = _e629.member_2;
                                            }
                                            let _e760 = phi_2493_;
                                            phi_2498_ = select(_e730, true, _e729);
                                            phi_2499_ = _e760;
                                        } else {
                                            phi_2498_ = _e568;
                                            phi_2499_ = _e752;
                                        }
                                        let _e763 = phi_2498_;
                                        let _e765 = phi_2499_;
                                        phi_3063_ = _e543;
                                        phi_2501_ = _e545;
                                        phi_2502_ = _e763;
                                        phi_2503_ = _e765;
                                        phi_2504_ = select(_e754, _e572, _e756);
                                    }
                                    let _e1350 = phi_3063_;
                                    let _e1352 = phi_2501_;
                                    let _e1354 = phi_2502_;
                                    let _e1356 = phi_2503_;
                                    let _e1358 = phi_2504_;
                                    phi_3062_ = _e1350;
                                    phi_2505_ = _e1352;
                                    phi_2506_ = _e1354;
                                    phi_2507_ = _e1356;
                                    phi_2508_ = _e1358;
                                    phi_2509_ = (_e553 - 1u);
                                } else {
                                    phi_3062_ = _e543;
                                    phi_2505_ = _e545;
                                    phi_2506_ = _e568;
                                    phi_2507_ = _e570;
                                    phi_2508_ = _e572;
                                    phi_2509_ = _e553;
                                }
                                let _e1360 = phi_3062_;
                                let _e1362 = phi_2505_;
                                let _e1364 = phi_2506_;
                                let _e1366 = phi_2507_;
                                let _e1368 = phi_2508_;
                                let _e1370 = phi_2509_;
                                phi_3061_ = _e1360;
                                phi_2510_ = _e1362;
                                phi_2511_ = _e1364;
                                phi_2512_ = _e1366;
                                phi_2513_ = _e1368;
                                phi_2514_ = _e1370;
                            } else {
                                phi_3061_ = _e543;
                                phi_2510_ = type_43();
                                phi_2511_ = bool();
                                phi_2512_ = u32();
                                phi_2513_ = u32();
                                phi_2514_ = u32();
                            }
                            let _e1372 = phi_3061_;
                            let _e1374 = phi_2510_;
                            let _e1376 = phi_2511_;
                            let _e1378 = phi_2512_;
                            let _e1380 = phi_2513_;
                            let _e1382 = phi_2514_;
                            phi_3060_ = _e1372;
                            phi_1016_ = _e1374;
                            phi_1019_ = _e1376;
                            phi_1021_ = _e1378;
                            phi_1023_ = _e1380;
                            phi_1025_ = _e1382;
                            phi_2515_ = _e557;
                        } else {
                            phi_3060_ = _e543;
                            phi_1016_ = type_43();
                            phi_1019_ = bool();
                            phi_1021_ = u32();
                            phi_1023_ = u32();
                            phi_1025_ = u32();
                            phi_2515_ = false;
                        }
                        let _e1384 = phi_3060_;
                        let _e1386 = phi_1016_;
                        let _e1388 = phi_1019_;
                        let _e1390 = phi_1021_;
                        let _e1392 = phi_1023_;
                        let _e1394 = phi_1025_;
                        let _e1396 = phi_2515_;
                        continue;
                        continuing {
                            phi_2911_ = _e1384;
                            phi_1015_ = _e1386;
                            phi_1018_ = _e1388;
                            phi_1020_ = _e1390;
                            phi_1022_ = _e1392;
                            phi_1024_ = _e1394;
                            phi_3059_ = _e1384;
                            break if !(_e1396);
                        }
                    }
                    let _e1399 = phi_3059_;
                    if _e1399 {
                        break;
                    }
                    let _e1401 = local_3;
                    if (_e1401.member.member_3 != 4294967295u) {
                        let _e1406 = bitcast<u32>(_e1401.member.member);
                        let _e1410 = (bitcast<i32>((_e1406 >> bitcast<u32>(23i))) & 255i);
                        let _e1411 = (_e1410 + _e219);
                        if (_e1410 == 255i) {
                            phi_2574_ = _e1401.member.member;
                        } else {
                            if (_e1410 > 0i) {
                                if (_e1411 > 0i) {
                                    let _e1415 = (_e1411 < 255i);
                                    if _e1415 {
                                        phi_2553_ = bitcast<f32>((_e1406 + bitcast<u32>((_e219 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2553_ = f32();
                                    }
                                    let _e1422 = phi_2553_;
                                    phi_2555_ = _e1422;
                                    phi_2556_ = select(true, false, _e1415);
                                } else {
                                    phi_2555_ = f32();
                                    phi_2556_ = true;
                                }
                                let _e1425 = phi_2555_;
                                let _e1427 = phi_2556_;
                                phi_2557_ = _e1425;
                                phi_2558_ = _e1427;
                            } else {
                                phi_2557_ = f32();
                                phi_2558_ = true;
                            }
                            let _e1429 = phi_2557_;
                            let _e1431 = phi_2558_;
                            if _e1431 {
                                let _e1432 = (_e1406 & 2147483648u);
                                let _e1439 = ((_e1406 & 8388607u) | (select(0u, 1u, ((_e1406 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1443 = (_e1439 == 0u);
                                if _e1443 {
                                    phi_2900_ = bitcast<f32>(_e1432);
                                } else {
                                    let _e1448 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1439)), 32u, _e1443) - 8u);
                                    let _e1451 = (_e1439 << bitcast<u32>((_e1448 & 31u)));
                                    let _e1453 = ((_e1411 + select(0i, 1i, (_e1410 == 0i))) - bitcast<i32>(_e1448));
                                    if (_e1453 >= 255i) {
                                        phi_2890_ = bitcast<f32>((_e1432 | 2139095040u));
                                        phi_2891_ = f32();
                                        phi_2892_ = true;
                                    } else {
                                        let _e1455 = (_e1453 > 0i);
                                        if _e1455 {
                                            phi_2884_ = bitcast<f32>(((_e1432 | (bitcast<u32>(_e1453) << bitcast<u32>(23i))) | (_e1451 & 8388607u)));
                                            phi_2885_ = f32();
                                        } else {
                                            if (_e1453 < -24i) {
                                                phi_2850_ = 26u;
                                            } else {
                                                phi_2850_ = bitcast<u32>((1i - _e1453));
                                            }
                                            let _e1460 = phi_2850_;
                                            let _e1461 = (_e1460 & 31u);
                                            let _e1463 = (_e1451 >> bitcast<u32>(_e1461));
                                            let _e1467 = (_e1451 & ((1u << bitcast<u32>(_e1461)) - 1u));
                                            let _e1471 = (1u << bitcast<u32>(((_e1460 - 1u) & 31u)));
                                            if (_e1467 > _e1471) {
                                                phi_2871_ = true;
                                            } else {
                                                if (_e1467 == _e1471) {
                                                    phi_2868_ = ((_e1463 & 1u) == 1u);
                                                } else {
                                                    phi_2868_ = false;
                                                }
                                                let _e1477 = phi_2868_;
                                                phi_2871_ = _e1477;
                                            }
                                            let _e1479 = phi_2871_;
                                            phi_2884_ = f32();
                                            phi_2885_ = bitcast<f32>((_e1432 | (_e1463 + select(0u, 1u, _e1479))));
                                        }
                                        let _e1492 = phi_2884_;
                                        let _e1494 = phi_2885_;
                                        phi_2890_ = _e1492;
                                        phi_2891_ = _e1494;
                                        phi_2892_ = _e1455;
                                    }
                                    let _e1498 = phi_2890_;
                                    let _e1500 = phi_2891_;
                                    let _e1502 = phi_2892_;
                                    phi_2900_ = select(_e1500, _e1498, _e1502);
                                }
                                let _e1506 = phi_2900_;
                                phi_2573_ = _e1506;
                            } else {
                                phi_2573_ = _e1429;
                            }
                            let _e1508 = phi_2573_;
                            phi_2574_ = _e1508;
                        }
                        let _e1510 = phi_2574_;
                        let _e1511 = bitcast<u32>(_e1510);
                        if ((_e1511 & 2147483647u) >= 2139095040u) {
                            phi_2586_ = bitcast<f32>(((_e1511 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2586_ = _e1510;
                        }
                        let _e1518 = phi_2586_;
                        phi_2591_ = type_22(_e1518, _e1401.member.member_1, _e1401.member.member_2, _e1401.member.member_3);
                    } else {
                        phi_2591_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1523 = phi_2591_;
                    if _e96 {
                    } else {
                        break;
                    }
                    global_4.member[_e88] = _e1523;
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e1527 = select(0u, 1u, (_e163 <= _e173));
                    if (_e1527 > 0u) {
                        let _e1529 = (1u < _e84);
                        if _e1529 {
                            if (0u < _e84) {
                            } else {
                                break;
                            }
                            let _e1533 = atomicAdd((&global_5.member[0u]), _e1527);
                            if ((_e1533 + _e1527) < _e1533) {
                                if _e1529 {
                                } else {
                                    break;
                                }
                                let _e1538 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1541 = select(0u, 1u, (_e1523.member_3 != 4294967295u));
                    if (_e1541 > 0u) {
                        let _e1543 = (3u < _e84);
                        if _e1543 {
                            if (2u < _e84) {
                            } else {
                                break;
                            }
                            let _e1547 = atomicAdd((&global_5.member[2u]), _e1541);
                            if ((_e1547 + _e1541) < _e1547) {
                                if _e1543 {
                                } else {
                                    break;
                                }
                                let _e1552 = atomicAdd((&global_5.member[3u]), 1u);
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
