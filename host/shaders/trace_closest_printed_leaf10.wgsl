struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: type_18,
    member_1: f32,
}

struct type_32 {
    member: array<type_22>,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_20;
@group(0) @binding(3) 
var<storage> global_6: type_46;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_425_: i32;
    var phi_426_: i32;
    var phi_436_: bool;
    var phi_446_: u32;
    var phi_447_: u32;
    var phi_449_: bool;
    var phi_454_: u32;
    var phi_467_: i32;
    var phi_487_: i32;
    var phi_505_: f32;
    var phi_511_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_609_: f32;
    var phi_621_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_676_: f32;
    var phi_682_: f32;
    var phi_734_: f32;
    var phi_746_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_801_: f32;
    var phi_807_: f32;
    var phi_859_: f32;
    var phi_871_: f32;
    var phi_926_: i32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_986_: i32;
    var phi_1008_: u32;
    var phi_1009_: u32;
    var phi_1017_: f32;
    var phi_1018_: f32;
    var phi_3723_: bool;
    var phi_1101_: type_29;
    var phi_1104_: u32;
    var phi_1106_: bool;
    var phi_1108_: u32;
    var phi_1110_: type_50;
    var phi_1121_: bool;
    var phi_1207_: bool;
    var phi_1208_: u32;
    var phi_1209_: type_50;
    var phi_1228_: type_29;
    var phi_1231_: type_4;
    var phi_1232_: type_4;
    var phi_1254_: type_4;
    var phi_1279_: u32;
    var phi_1295_: type_44;
    var phi_1733_: bool;
    var phi_1762_: bool;
    var phi_2157_: f32;
    var phi_2158_: f32;
    var phi_2159_: f32;
    var phi_2160_: f32;
    var phi_2161_: vec3<f32>;
    var phi_2162_: vec3<f32>;
    var phi_2163_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2201_: bool;
    var phi_2210_: vec3<f32>;
    var phi_2375_: f32;
    var phi_2377_: f32;
    var phi_2378_: bool;
    var phi_2398_: f32;
    var phi_2399_: f32;
    var phi_2422_: type_18;
    var phi_2424_: type_18;
    var phi_2425_: bool;
    var phi_2429_: type_18;
    var phi_2430_: type_18;
    var phi_2431_: type_18;
    var phi_2432_: bool;
    var phi_2436_: type_18;
    var phi_2437_: bool;
    var phi_2438_: type_18;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: type_18;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_2451_: type_18;
    var phi_2452_: bool;
    var phi_2456_: type_18;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2488_: type_29;
    var phi_2489_: type_29;
    var phi_2490_: type_29;
    var phi_1229_: type_29;
    var phi_3717_: bool;
    var phi_3954_: bool;
    var phi_2491_: type_29;
    var phi_2512_: type_37;
    var phi_3398_: type_50;
    var phi_3474_: type_50;
    var phi_3475_: u32;
    var phi_3476_: type_50;
    var phi_3478_: u32;
    var phi_3479_: type_50;
    var phi_3480_: bool;
    var phi_3487_: type_50;
    var phi_3492_: bool;
    var phi_3494_: type_50;
    var phi_3498_: bool;
    var phi_3499_: u32;
    var phi_3500_: type_50;
    var phi_3510_: type_50;
    var phi_3898_: bool;
    var phi_3511_: type_29;
    var phi_3512_: u32;
    var phi_3513_: bool;
    var phi_3514_: u32;
    var phi_3515_: type_50;
    var phi_3897_: bool;
    var phi_3516_: type_29;
    var phi_3517_: u32;
    var phi_3518_: bool;
    var phi_3519_: u32;
    var phi_3520_: type_50;
    var phi_3896_: bool;
    var phi_1102_: type_29;
    var phi_1105_: u32;
    var phi_1107_: bool;
    var phi_1109_: u32;
    var phi_1111_: type_50;
    var phi_3521_: bool;
    var phi_3895_: bool;
    var local_10: type_29;
    var phi_3559_: f32;
    var phi_3561_: f32;
    var phi_3562_: bool;
    var phi_3563_: f32;
    var phi_3564_: bool;
    var phi_3637_: u32;
    var phi_3655_: bool;
    var phi_3658_: bool;
    var phi_3671_: f32;
    var phi_3672_: f32;
    var phi_3677_: f32;
    var phi_3678_: f32;
    var phi_3679_: bool;
    var phi_3687_: f32;
    var phi_3579_: f32;
    var phi_3580_: f32;
    var phi_3592_: f32;
    var phi_3597_: type_18;
    var local_11: type_29;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e85 = arrayLength((&global_4.member));
            let _e96 = global_2.member[0u][0u];
            let _e100 = global_2.member[0u][1u];
            let _e104 = global_2.member[0u][2u];
            let _e108 = global_2.member[1u][0u];
            let _e112 = global_2.member[1u][1u];
            let _e116 = global_2.member[1u][2u];
            let _e120 = global_2.member[1u][3u];
            let _e123 = global_1.member[0u];
            let _e124 = bitcast<i32>(_e123);
            let _e134 = (_e82.x + (_e82.y * 2097152u));
            let _e135 = (_e134 < arrayLength((&global_3.member)));
            if _e135 {
                let _e136 = (_e134 < arrayLength((&global_5.member)));
                if _e136 {
                    if _e135 {
                    } else {
                        break;
                    }
                    let _e144 = global_3.member[_e134].member_2[0u];
                    let _e146 = (bitcast<u32>(_e144) & 2147483647u);
                    let _e151 = global_3.member[_e134].member_2[1u];
                    let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                    let _e158 = global_3.member[_e134].member_2[2u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_3.member[_e134].member[0u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_3.member[_e134].member[1u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_3.member[_e134].member[2u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e183 = select(_e153, _e146, (_e153 < _e146));
                    let _e185 = select(_e160, _e183, (_e160 < _e183));
                    let _e187 = select(_e167, _e185, (_e167 < _e185));
                    let _e189 = select(_e174, _e187, (_e174 < _e187));
                    let _e191 = select(_e181, _e189, (_e181 < _e189));
                    let _e195 = global_3.member[_e134].member_1;
                    let _e196 = bitcast<u32>(_e195);
                    let _e197 = (_e196 & 2147483647u);
                    let _e204 = global_3.member[_e134].member_3;
                    let _e205 = bitcast<u32>(_e204);
                    let _e206 = (_e205 & 2147483647u);
                    let _e210 = (((select(_e197, _e191, (_e197 < _e191)) < 2139095040u) && (_e206 <= 2139095040u)) && (_e185 > 0u));
                    if _e210 {
                        let _e213 = (bitcast<u32>(bitcast<f32>(_e185)) & 2147483647u);
                        if (_e213 >= 8388608u) {
                            phi_425_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_425_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_425_;
                        phi_426_ = _e227;
                    } else {
                        phi_426_ = 0i;
                    }
                    let _e229 = phi_426_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_436_ = true;
                    } else {
                        phi_436_ = (_e153 == _e185);
                    }
                    let _e233 = phi_436_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_446_ = _e235;
                        phi_447_ = _e235;
                        phi_449_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_446_ = u32();
                        phi_447_ = 0u;
                        phi_449_ = true;
                    }
                    let _e239 = phi_446_;
                    let _e241 = phi_447_;
                    let _e243 = phi_449_;
                    if _e243 {
                        phi_454_ = (_e241 + 1u);
                    } else {
                        phi_454_ = 0u;
                    }
                    let _e247 = phi_454_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    if (_e124 < -126i) {
                        phi_467_ = -126i;
                    } else {
                        phi_467_ = select(_e124, 127i, (_e124 > 127i));
                    }
                    let _e254 = phi_467_;
                    let _e259 = bitcast<f32>((bitcast<u32>((_e254 + 127i)) << bitcast<u32>(23i)));
                    let _e265 = bitcast<f32>((bitcast<u32>(((_e124 - _e254) + 127i)) << bitcast<u32>(23i)));
                    let _e266 = -(_e229);
                    if (_e266 < -126i) {
                        phi_487_ = -126i;
                    } else {
                        phi_487_ = select(_e266, 127i, (_e266 > 127i));
                    }
                    let _e271 = phi_487_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e266 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = global_3.member[_e134].member;
                    let _e287 = (_e248 == 0u);
                    if _e287 {
                        phi_505_ = _e286[0];
                    } else {
                        phi_505_ = _e286[1];
                    }
                    let _e291 = phi_505_;
                    let _e292 = (_e248 == 2u);
                    if _e292 {
                        phi_511_ = _e286[2];
                    } else {
                        phi_511_ = _e291;
                    }
                    let _e295 = phi_511_;
                    let _e296 = bitcast<u32>(_e295);
                    let _e298 = ((_e296 & 2139095040u) != 0u);
                    let _e312 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e296 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e296 & 2147483648u))), _e295, _e298) * _e259) * select(0.00000011920929f, 1f, _e298)) * _e265);
                    let _e313 = global_3.member[_e134].member_2;
                    if _e287 {
                        phi_551_ = _e313[0];
                    } else {
                        phi_551_ = _e313[1];
                    }
                    let _e317 = phi_551_;
                    if _e292 {
                        phi_557_ = _e313[2];
                    } else {
                        phi_557_ = _e317;
                    }
                    let _e320 = phi_557_;
                    let _e321 = bitcast<u32>(_e320);
                    let _e323 = ((_e321 & 2139095040u) != 0u);
                    let _e337 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e320, _e323) * _e276) * select(0.00000011920929f, 1f, _e323)) * _e282);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e341 {
                        let _e345 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_609_ = select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f));
                    } else {
                        phi_609_ = 0f;
                    }
                    let _e349 = phi_609_;
                    let _e350 = (_e312 + _e349);
                    let _e351 = (_e312 - _e349);
                    let _e352 = select(_e337, 0f, _e341);
                    if _e341 {
                        phi_621_ = 38685626000000000000000000f;
                    } else {
                        phi_621_ = (1f / _e337);
                    }
                    let _e355 = phi_621_;
                    let _e356 = (_e247 == 0u);
                    if _e356 {
                        phi_630_ = _e286[0];
                    } else {
                        phi_630_ = _e286[1];
                    }
                    let _e360 = phi_630_;
                    let _e361 = (_e247 == 2u);
                    if _e361 {
                        phi_636_ = _e286[2];
                    } else {
                        phi_636_ = _e360;
                    }
                    let _e364 = phi_636_;
                    let _e365 = bitcast<u32>(_e364);
                    let _e367 = ((_e365 & 2139095040u) != 0u);
                    let _e381 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e365 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e365 & 2147483648u))), _e364, _e367) * _e259) * select(0.00000011920929f, 1f, _e367)) * _e265);
                    if _e356 {
                        phi_676_ = _e313[0];
                    } else {
                        phi_676_ = _e313[1];
                    }
                    let _e385 = phi_676_;
                    if _e361 {
                        phi_682_ = _e313[2];
                    } else {
                        phi_682_ = _e385;
                    }
                    let _e388 = phi_682_;
                    let _e389 = bitcast<u32>(_e388);
                    let _e391 = ((_e389 & 2139095040u) != 0u);
                    let _e405 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e389 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e389 & 2147483648u))), _e388, _e391) * _e276) * select(0.00000011920929f, 1f, _e391)) * _e282);
                    let _e409 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e409 {
                        let _e413 = (bitcast<f32>((bitcast<u32>(_e381) & 2147483647u)) * 0.00000011920929f);
                        phi_734_ = select(0.00000000000011368684f, _e413, (_e413 > 0.00000000000011368684f));
                    } else {
                        phi_734_ = 0f;
                    }
                    let _e417 = phi_734_;
                    let _e418 = (_e381 + _e417);
                    let _e419 = (_e381 - _e417);
                    let _e420 = select(_e405, 0f, _e409);
                    if _e409 {
                        phi_746_ = 38685626000000000000000000f;
                    } else {
                        phi_746_ = (1f / _e405);
                    }
                    let _e423 = phi_746_;
                    let _e424 = (_e249 == 0u);
                    if _e424 {
                        phi_755_ = _e286[0];
                    } else {
                        phi_755_ = _e286[1];
                    }
                    let _e428 = phi_755_;
                    let _e429 = (_e249 == 2u);
                    if _e429 {
                        phi_761_ = _e286[2];
                    } else {
                        phi_761_ = _e428;
                    }
                    let _e432 = phi_761_;
                    let _e433 = bitcast<u32>(_e432);
                    let _e435 = ((_e433 & 2139095040u) != 0u);
                    let _e449 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e433 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e433 & 2147483648u))), _e432, _e435) * _e259) * select(0.00000011920929f, 1f, _e435)) * _e265);
                    if _e424 {
                        phi_801_ = _e313[0];
                    } else {
                        phi_801_ = _e313[1];
                    }
                    let _e453 = phi_801_;
                    if _e429 {
                        phi_807_ = _e313[2];
                    } else {
                        phi_807_ = _e453;
                    }
                    let _e456 = phi_807_;
                    let _e457 = bitcast<u32>(_e456);
                    let _e459 = ((_e457 & 2139095040u) != 0u);
                    let _e473 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e457 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e457 & 2147483648u))), _e456, _e459) * _e276) * select(0.00000011920929f, 1f, _e459)) * _e282);
                    let _e477 = (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e477 {
                        let _e481 = (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) * 0.00000011920929f);
                        phi_859_ = select(0.00000000000011368684f, _e481, (_e481 > 0.00000000000011368684f));
                    } else {
                        phi_859_ = 0f;
                    }
                    let _e485 = phi_859_;
                    let _e486 = (_e449 + _e485);
                    let _e487 = (_e449 - _e485);
                    let _e488 = select(_e473, 0f, _e477);
                    if _e477 {
                        phi_871_ = 38685626000000000000000000f;
                    } else {
                        phi_871_ = (1f / _e473);
                    }
                    let _e491 = phi_871_;
                    let _e494 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e497 = bitcast<f32>((bitcast<u32>(_e381) & 2147483647u));
                    let _e499 = select(_e497, _e494, (_e494 > _e497));
                    let _e502 = bitcast<f32>((bitcast<u32>(_e449) & 2147483647u));
                    let _e505 = (_e124 + _e229);
                    if (_e210 && (select(_e502, _e499, (_e499 > _e502)) <= 1099511600000f)) {
                        let _e515 = ((_e197 & 8388607u) | (select(0u, 1u, ((_e197 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e518 = bitcast<i32>((_e197 >> bitcast<u32>(23i)));
                        let _e522 = (_e515 == 0u);
                        let _e525 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, _e522)) - 8i);
                        if (_e518 == 255i) {
                            phi_926_ = 255i;
                        } else {
                            phi_926_ = (((_e518 + select(0i, 1i, (_e518 == 0i))) - _e525) + _e505);
                        }
                        let _e533 = phi_926_;
                        let _e543 = (_e533 <= 0i);
                        if _e543 {
                            phi_949_ = u32();
                        } else {
                            if _e522 {
                                phi_948_ = u32();
                            } else {
                                phi_948_ = select(((bitcast<u32>(_e533) << bitcast<u32>(23i)) | ((_e515 << bitcast<u32>(((_e525 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e533 >= 255i));
                            }
                            let _e547 = phi_948_;
                            phi_949_ = _e547;
                        }
                        let _e549 = phi_949_;
                        let _e561 = ((_e206 & 8388607u) | (select(0u, 1u, ((_e206 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e564 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
                        let _e568 = (_e561 == 0u);
                        let _e571 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e561)), 32u, _e568)) - 8i);
                        if (_e564 == 255i) {
                            phi_986_ = 255i;
                        } else {
                            phi_986_ = (((_e564 + select(0i, 1i, (_e564 == 0i))) - _e571) + _e505);
                        }
                        let _e579 = phi_986_;
                        let _e589 = (_e579 <= 0i);
                        if _e589 {
                            phi_1009_ = u32();
                        } else {
                            if _e568 {
                                phi_1008_ = u32();
                            } else {
                                phi_1008_ = select(((bitcast<u32>(_e579) << bitcast<u32>(23i)) | ((_e561 << bitcast<u32>(((_e571 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e579 >= 255i));
                            }
                            let _e593 = phi_1008_;
                            phi_1009_ = _e593;
                        }
                        let _e595 = phi_1009_;
                        phi_1017_ = bitcast<f32>(((_e205 & 2147483648u) | select(_e595, 0u, select(_e568, true, _e589))));
                        phi_1018_ = bitcast<f32>(((_e196 & 2147483648u) | select(_e549, 0u, select(_e522, true, _e543))));
                    } else {
                        phi_1017_ = 0f;
                        phi_1018_ = 1f;
                    }
                    let _e601 = phi_1017_;
                    let _e603 = phi_1018_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e608 = (_e248 % 3u);
                    let _e609 = (_e608 < 3u);
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e611 = local_9[_e608];
                    let _e612 = (_e247 % 3u);
                    let _e613 = (_e612 < 3u);
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e615 = local_9[_e612];
                    let _e616 = (_e249 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_9[_e616];
                    local_8 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e623 = local_8[_e608];
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e625 = local_8[_e612];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e627 = local_8[_e616];
                    phi_3723_ = false;
                    phi_1101_ = type_29(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e601);
                    phi_1104_ = ((3u * _e85) + 1u);
                    phi_1106_ = (_e603 <= _e601);
                    phi_1108_ = 0u;
                    phi_1110_ = type_50(type_42(array<f32, 3>(_e611, _e615, _e619), array<f32, 3>(_e623, _e625, _e627)), select(0u, 2147483648u, (_e85 == 0u)));
                    loop {
                        let _e635 = phi_3723_;
                        let _e637 = phi_1101_;
                        let _e639 = phi_1104_;
                        let _e641 = phi_1106_;
                        let _e643 = phi_1108_;
                        let _e645 = phi_1110_;
                        local_10 = _e637;
                        if _e641 {
                            phi_1121_ = true;
                        } else {
                            phi_1121_ = (_e643 > 0u);
                        }
                        let _e648 = phi_1121_;
                        if _e648 {
                            let _e649 = (_e639 > 0u);
                            if _e649 {
                                if _e641 {
                                    phi_1207_ = _e641;
                                    phi_1208_ = _e643;
                                    phi_1209_ = _e645;
                                } else {
                                    let _e650 = (_e643 - 1u);
                                    let _e651 = (_e650 % 128u);
                                    let _e652 = (_e651 < 128u);
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e654 = local_6[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e656 = local_5[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e658 = local_4[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e660 = local_3[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e663 = local_2[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e665 = local_1[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e667 = local[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3895_ = true;
                                        break;
                                    }
                                    let _e672 = local_7[_e651];
                                    phi_1207_ = (_e672 <= _e637.member_1);
                                    phi_1208_ = _e650;
                                    phi_1209_ = type_50(type_42(array<f32, 3>(_e656, _e658, _e660), array<f32, 3>(_e663, _e665, _e667)), _e654);
                                }
                                let _e676 = phi_1207_;
                                let _e678 = phi_1208_;
                                let _e680 = phi_1209_;
                                if _e676 {
                                    let _e684 = ((_e680.member_1 & 2147483648u) != 0u);
                                    if _e684 {
                                        phi_1228_ = _e637;
                                        phi_1231_ = type_4(0u, ((_e680.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e692 = phi_1228_;
                                            let _e694 = phi_1231_;
                                            local_11 = _e692;
                                            if (_e694.member < _e694.member_1) {
                                                phi_1232_ = type_4((_e694.member + 1u), _e694.member_1);
                                                phi_1254_ = type_4(1u, _e694.member);
                                            } else {
                                                phi_1232_ = _e694;
                                                phi_1254_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e707 = phi_1232_;
                                            let _e709 = phi_1254_;
                                            let _e713 = (bitcast<i32>(_e709.member) != 0i);
                                            if _e713 {
                                                let _e714 = ((_e680.member_1 & 268435455u) + _e709.member_1);
                                                let _e715 = (_e714 < arrayLength((&global_6.member)));
                                                if _e715 {
                                                    if _e715 {
                                                    } else {
                                                        phi_3717_ = true;
                                                        break;
                                                    }
                                                    let _e718 = global_6.member[_e714].member_1;
                                                    phi_1279_ = _e718;
                                                } else {
                                                    phi_1279_ = 4294967295u;
                                                }
                                                let _e720 = phi_1279_;
                                                if _e715 {
                                                    if _e715 {
                                                    } else {
                                                        phi_3717_ = true;
                                                        break;
                                                    }
                                                    let _e722 = global_6.member[_e714];
                                                    phi_1295_ = _e722;
                                                } else {
                                                    phi_1295_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e724 = phi_1295_;
                                                let _e736 = ((10u * _e248) & 31u);
                                                let _e739 = ((_e724.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                                let _e747 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e120));
                                                let _e752 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e120)));
                                                let _e756 = select(select(_e680.member.member_1[0], _e752, (_e752 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e739 == 1023u));
                                                let _e758 = ((10u * _e247) & 31u);
                                                let _e761 = ((_e724.member[0] >> bitcast<u32>(_e758)) & 1023u);
                                                let _e769 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e120));
                                                let _e774 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e761)) - 8388608f) * _e769)) ^ _e120)));
                                                let _e778 = select(select(_e680.member.member_1[1], _e774, (_e774 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e761 == 1023u));
                                                let _e780 = ((10u * _e249) & 31u);
                                                let _e783 = ((_e724.member[0] >> bitcast<u32>(_e780)) & 1023u);
                                                let _e791 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e120));
                                                let _e796 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e783)) - 8388608f) * _e791)) ^ _e120)));
                                                let _e800 = select(select(_e680.member.member_1[2], _e796, (_e796 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e783 == 1023u));
                                                let _e804 = ((_e724.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                                let _e812 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e804)) - 8388608f) * _e747)) ^ _e120)));
                                                let _e816 = select(select(_e680.member.member_1[0], _e812, (_e812 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e804 == 1023u));
                                                let _e819 = ((_e724.member[1] >> bitcast<u32>(_e758)) & 1023u);
                                                let _e827 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e819)) - 8388608f) * _e769)) ^ _e120)));
                                                let _e831 = select(select(_e680.member.member_1[1], _e827, (_e827 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e819 == 1023u));
                                                let _e834 = ((_e724.member[1] >> bitcast<u32>(_e780)) & 1023u);
                                                let _e842 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e834)) - 8388608f) * _e791)) ^ _e120)));
                                                let _e846 = select(select(_e680.member.member_1[2], _e842, (_e842 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e834 == 1023u));
                                                let _e850 = ((_e724.member[2] >> bitcast<u32>(_e736)) & 1023u);
                                                let _e858 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e850)) - 8388608f) * _e747)) ^ _e120)));
                                                let _e862 = select(select(_e680.member.member_1[0], _e858, (_e858 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e850 == 1023u));
                                                let _e865 = ((_e724.member[2] >> bitcast<u32>(_e758)) & 1023u);
                                                let _e873 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e865)) - 8388608f) * _e769)) ^ _e120)));
                                                let _e877 = select(select(_e680.member.member_1[1], _e873, (_e873 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e865 == 1023u));
                                                let _e880 = ((_e724.member[2] >> bitcast<u32>(_e780)) & 1023u);
                                                let _e888 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e880)) - 8388608f) * _e791)) ^ _e120)));
                                                let _e892 = select(select(_e680.member.member_1[2], _e888, (_e888 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e880 == 1023u));
                                                let _e896 = (_e800 - _e449);
                                                let _e899 = (((_e756 - _e312) * _e488) - (_e896 * _e352));
                                                let _e902 = (((_e778 - _e381) * _e488) - (_e896 * _e420));
                                                let _e905 = (_e846 - _e449);
                                                let _e908 = (((_e816 - _e312) * _e488) - (_e905 * _e352));
                                                let _e911 = (((_e831 - _e381) * _e488) - (_e905 * _e420));
                                                let _e914 = (_e892 - _e449);
                                                let _e917 = (((_e862 - _e312) * _e488) - (_e914 * _e352));
                                                let _e920 = (((_e877 - _e381) * _e488) - (_e914 * _e420));
                                                let _e921 = (_e917 * _e911);
                                                let _e922 = (_e920 * _e908);
                                                let _e923 = (_e899 * _e920);
                                                let _e924 = (_e902 * _e917);
                                                let _e925 = (_e908 * _e902);
                                                let _e926 = (_e911 * _e899);
                                                let _e931 = (((_e921 >= _e922) && (_e923 >= _e924)) && (_e925 >= _e926));
                                                if (_e931 || (((_e921 <= _e922) && (_e923 <= _e924)) && (_e925 <= _e926))) {
                                                    let _e938 = select(-1f, 1f, _e931);
                                                    let _e940 = ((_e921 - _e922) * _e938);
                                                    let _e942 = select(0f, _e940, (_e940 > 0f));
                                                    let _e944 = ((_e923 - _e924) * _e938);
                                                    let _e946 = select(0f, _e944, (_e944 > 0f));
                                                    let _e948 = ((_e925 - _e926) * _e938);
                                                    let _e950 = select(0f, _e948, (_e948 > 0f));
                                                    let _e952 = ((_e942 + _e946) + _e950);
                                                    if (_e952 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2441_ = type_18();
                                                        phi_2442_ = true;
                                                        phi_2443_ = false;
                                                    } else {
                                                        let _e955 = select(_e908, _e899, (_e899 < _e908));
                                                        if (select(_e917, _e955, (_e955 < _e917)) > 0f) {
                                                            phi_1733_ = true;
                                                        } else {
                                                            let _e960 = select(_e908, _e899, (_e899 > _e908));
                                                            phi_1733_ = (select(_e917, _e960, (_e960 > _e917)) < 0f);
                                                        }
                                                        let _e965 = phi_1733_;
                                                        if _e965 {
                                                            phi_2438_ = type_18();
                                                            phi_2439_ = true;
                                                            phi_2440_ = false;
                                                        } else {
                                                            let _e967 = select(_e911, _e902, (_e902 < _e911));
                                                            if (select(_e920, _e967, (_e967 < _e920)) > 0f) {
                                                                phi_1762_ = true;
                                                            } else {
                                                                let _e972 = select(_e911, _e902, (_e902 > _e911));
                                                                phi_1762_ = (select(_e920, _e972, (_e972 > _e920)) < 0f);
                                                            }
                                                            let _e977 = phi_1762_;
                                                            if _e977 {
                                                                phi_2436_ = type_18();
                                                                phi_2437_ = false;
                                                            } else {
                                                                let _e979 = select(_e816, _e756, (_e756 < _e816));
                                                                let _e983 = select(_e816, _e756, (_e756 > _e816));
                                                                let _e987 = select(_e831, _e778, (_e778 < _e831));
                                                                let _e991 = select(_e831, _e778, (_e778 > _e831));
                                                                let _e995 = select(_e846, _e800, (_e800 < _e846));
                                                                let _e999 = select(_e846, _e800, (_e800 > _e846));
                                                                let _e1004 = ((select(_e862, _e979, (_e979 < _e862)) - _e350) * _e355);
                                                                let _e1005 = ((select(_e862, _e983, (_e983 > _e862)) - _e351) * _e355);
                                                                let _e1008 = ((select(_e877, _e987, (_e987 < _e877)) - _e418) * _e423);
                                                                let _e1009 = ((select(_e877, _e991, (_e991 > _e877)) - _e419) * _e423);
                                                                let _e1012 = ((select(_e892, _e995, (_e995 < _e892)) - _e486) * _e491);
                                                                let _e1013 = ((select(_e892, _e999, (_e999 > _e892)) - _e487) * _e491);
                                                                let _e1015 = select(_e1013, _e1012, (_e1012 < _e1013));
                                                                let _e1017 = select(_e1013, _e1012, (_e1012 > _e1013));
                                                                let _e1019 = select(_e1005, _e1004, (_e1004 < _e1005));
                                                                let _e1021 = select(_e1009, _e1008, (_e1008 < _e1009));
                                                                let _e1023 = select(_e1021, _e1019, (_e1019 > _e1021));
                                                                let _e1025 = select(_e1015, _e1023, (_e1023 > _e1015));
                                                                let _e1027 = select(_e1005, _e1004, (_e1004 > _e1005));
                                                                let _e1029 = select(_e1009, _e1008, (_e1008 > _e1009));
                                                                let _e1031 = select(_e1029, _e1027, (_e1027 < _e1029));
                                                                let _e1033 = select(_e1017, _e1031, (_e1031 < _e1017));
                                                                let _e1034 = -(_e1015);
                                                                let _e1040 = select(_e603, _e1025, (_e1025 > _e603));
                                                                if (_e1040 > (_e1033 + (select(_e1034, _e1017, (_e1017 > _e1034)) * 0.0000019073523f))) {
                                                                    phi_2431_ = type_18();
                                                                    phi_2432_ = true;
                                                                } else {
                                                                    let _e1042 = (_e1040 > _e692.member_1);
                                                                    if _e1042 {
                                                                        phi_2430_ = type_18();
                                                                    } else {
                                                                        let _e1043 = vec3<f32>(_e756, _e778, _e800);
                                                                        let _e1044 = vec3<f32>(_e816, _e831, _e846);
                                                                        let _e1045 = vec3<f32>(_e862, _e877, _e892);
                                                                        let _e1046 = (_e816 - _e756);
                                                                        let _e1047 = (_e831 - _e778);
                                                                        let _e1048 = (_e846 - _e800);
                                                                        let _e1049 = vec3<f32>(_e1046, _e1047, _e1048);
                                                                        let _e1050 = (_e862 - _e816);
                                                                        let _e1051 = (_e877 - _e831);
                                                                        let _e1052 = (_e892 - _e846);
                                                                        let _e1053 = vec3<f32>(_e1050, _e1051, _e1052);
                                                                        let _e1054 = (_e756 - _e862);
                                                                        let _e1055 = (_e778 - _e877);
                                                                        let _e1056 = (_e800 - _e892);
                                                                        let _e1057 = vec3<f32>(_e1054, _e1055, _e1056);
                                                                        let _e1060 = bitcast<f32>((bitcast<u32>(_e1046) & 2147483647u));
                                                                        let _e1063 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        let _e1065 = select(_e1063, _e1060, (_e1060 > _e1063));
                                                                        let _e1068 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1070 = select(_e1068, _e1065, (_e1065 > _e1068));
                                                                        let _e1073 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                        let _e1076 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                        let _e1078 = select(_e1076, _e1073, (_e1073 > _e1076));
                                                                        let _e1081 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1083 = select(_e1081, _e1078, (_e1078 > _e1081));
                                                                        let _e1086 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1089 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                        let _e1091 = select(_e1089, _e1086, (_e1086 > _e1089));
                                                                        let _e1094 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1096 = select(_e1094, _e1091, (_e1091 > _e1094));
                                                                        let _e1098 = select(_e1083, _e1070, (_e1070 > _e1083));
                                                                        let _e1100 = select(_e1096, _e1098, (_e1098 > _e1096));
                                                                        if (_e1070 == _e1100) {
                                                                            phi_2157_ = _e911;
                                                                            phi_2158_ = _e908;
                                                                            phi_2159_ = _e902;
                                                                            phi_2160_ = _e899;
                                                                            phi_2161_ = _e1043;
                                                                            phi_2162_ = _e1057;
                                                                            phi_2163_ = _e1053;
                                                                            phi_2164_ = _e1049;
                                                                        } else {
                                                                            let _e1102 = (_e1083 == _e1100);
                                                                            let _e1107 = vec3(_e1102);
                                                                            phi_2157_ = select(_e902, _e920, _e1102);
                                                                            phi_2158_ = select(_e899, _e917, _e1102);
                                                                            phi_2159_ = select(_e920, _e911, _e1102);
                                                                            phi_2160_ = select(_e917, _e908, _e1102);
                                                                            phi_2161_ = select(_e1045, _e1044, _e1107);
                                                                            phi_2162_ = select(_e1053, _e1049, _e1107);
                                                                            phi_2163_ = select(_e1049, _e1057, _e1107);
                                                                            phi_2164_ = select(_e1057, _e1053, _e1107);
                                                                        }
                                                                        let _e1113 = phi_2157_;
                                                                        let _e1115 = phi_2158_;
                                                                        let _e1117 = phi_2159_;
                                                                        let _e1119 = phi_2160_;
                                                                        let _e1121 = phi_2161_;
                                                                        let _e1123 = phi_2162_;
                                                                        let _e1125 = phi_2163_;
                                                                        let _e1127 = phi_2164_;
                                                                        let _e1134 = ((_e1125.y * _e1123.z) - (_e1123.y * _e1125.z));
                                                                        let _e1139 = ((_e1125.z * _e1123.x) - (_e1123.z * _e1125.x));
                                                                        let _e1142 = ((_e1125.x * _e1123.y) - (_e1123.x * _e1125.y));
                                                                        if (_e942 >= _e946) {
                                                                            phi_2201_ = select(true, false, (_e942 >= _e950));
                                                                        } else {
                                                                            phi_2201_ = true;
                                                                        }
                                                                        let _e1147 = phi_2201_;
                                                                        if _e1147 {
                                                                            phi_2210_ = select(_e1045, _e1044, vec3((_e946 >= _e950)));
                                                                        } else {
                                                                            phi_2210_ = _e1043;
                                                                        }
                                                                        let _e1152 = phi_2210_;
                                                                        let _e1163 = (((_e1134 * (_e1152.x - _e312)) + (_e1139 * (_e1152.y - _e381))) + (_e1142 * (_e1152.z - _e449)));
                                                                        let _e1168 = (((_e1134 * _e352) + (_e1139 * _e420)) + (_e1142 * _e488));
                                                                        let _e1169 = (_e1115 - _e1119);
                                                                        let _e1170 = (_e1113 - _e1117);
                                                                        let _e1178 = (-(((_e1119 * _e1169) + (_e1117 * _e1170))) / ((_e1169 * _e1169) + (_e1170 * _e1170)));
                                                                        let _e1180 = select(1f, _e1178, (_e1178 < 1f));
                                                                        let _e1182 = select(0f, _e1180, (_e1180 > 0f));
                                                                        let _e1195 = ((_e1121.x + (_e1127.x * _e1182)) - _e312);
                                                                        let _e1196 = ((_e1121.y + (_e1127.y * _e1182)) - _e381);
                                                                        let _e1197 = ((_e1121.z + (_e1127.z * _e1182)) - _e449);
                                                                        let _e1198 = (_e1197 / _e488);
                                                                        let _e1210 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                        let _e1213 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                        let _e1215 = select(_e1213, _e1210, (_e1210 > _e1213));
                                                                        let _e1218 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                        let _e1220 = select(_e1218, _e1215, (_e1215 > _e1218));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                        let _e1229 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                        let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1134 * _e1195) + (_e1139 * _e1196)) + (_e1142 * _e1197)) - _e1163)) & 2147483647u)) <= ((0.0000009536743f * select(_e1100, _e1220, (_e1220 > _e1100))) * select(_e1234, _e1231, (_e1231 > _e1234)))) {
                                                                            let _e1244 = bitcast<f32>((bitcast<u32>(_e1125.x) & 2147483647u));
                                                                            let _e1247 = bitcast<f32>((bitcast<u32>(_e1125.y) & 2147483647u));
                                                                            let _e1249 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                            let _e1252 = bitcast<f32>((bitcast<u32>(_e1125.z) & 2147483647u));
                                                                            let _e1258 = bitcast<f32>((bitcast<u32>(_e1123.x) & 2147483647u));
                                                                            let _e1261 = bitcast<f32>((bitcast<u32>(_e1123.y) & 2147483647u));
                                                                            let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                            let _e1266 = bitcast<f32>((bitcast<u32>(_e1123.z) & 2147483647u));
                                                                            let _e1270 = (bitcast<f32>((bitcast<u32>(_e1168) & 2147483647u)) > ((0.0000038146973f * select(_e1252, _e1249, (_e1249 > _e1252))) * select(_e1266, _e1263, (_e1263 > _e1266))));
                                                                            if _e1270 {
                                                                                phi_2375_ = (_e1163 / _e1168);
                                                                            } else {
                                                                                phi_2375_ = f32();
                                                                            }
                                                                            let _e1273 = phi_2375_;
                                                                            phi_2377_ = _e1273;
                                                                            phi_2378_ = select(true, false, _e1270);
                                                                        } else {
                                                                            phi_2377_ = f32();
                                                                            phi_2378_ = true;
                                                                        }
                                                                        let _e1276 = phi_2377_;
                                                                        let _e1278 = phi_2378_;
                                                                        if _e1278 {
                                                                            let _e1286 = (((_e1134 * (_e1195 - (_e352 * _e1198))) + (_e1139 * (_e1196 - (_e420 * _e1198)))) / _e1168);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u)) <= _e1100) {
                                                                                phi_2398_ = (_e1198 + _e1286);
                                                                            } else {
                                                                                phi_2398_ = _e1198;
                                                                            }
                                                                            let _e1293 = phi_2398_;
                                                                            phi_2399_ = _e1293;
                                                                        } else {
                                                                            phi_2399_ = _e1276;
                                                                        }
                                                                        let _e1295 = phi_2399_;
                                                                        let _e1297 = select(_e1033, _e1295, (_e1295 < _e1033));
                                                                        let _e1299 = select(_e1025, _e1297, (_e1297 > _e1025));
                                                                        if (_e1299 >= _e603) {
                                                                            let _e1301 = (_e1299 <= _e692.member_1);
                                                                            if _e1301 {
                                                                                let _e1302 = (1f / _e952);
                                                                                phi_2422_ = type_18(_e1299, (_e946 * _e1302), (_e950 * _e1302), _e720);
                                                                            } else {
                                                                                phi_2422_ = type_18();
                                                                            }
                                                                            let _e1307 = phi_2422_;
                                                                            phi_2424_ = _e1307;
                                                                            phi_2425_ = select(true, false, _e1301);
                                                                        } else {
                                                                            phi_2424_ = type_18();
                                                                            phi_2425_ = true;
                                                                        }
                                                                        let _e1310 = phi_2424_;
                                                                        let _e1312 = phi_2425_;
                                                                        if _e1312 {
                                                                            phi_2429_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2429_ = _e1310;
                                                                        }
                                                                        let _e1314 = phi_2429_;
                                                                        phi_2430_ = _e1314;
                                                                    }
                                                                    let _e1316 = phi_2430_;
                                                                    phi_2431_ = _e1316;
                                                                    phi_2432_ = _e1042;
                                                                }
                                                                let _e1318 = phi_2431_;
                                                                let _e1320 = phi_2432_;
                                                                phi_2436_ = _e1318;
                                                                phi_2437_ = _e1320;
                                                            }
                                                            let _e1322 = phi_2436_;
                                                            let _e1324 = phi_2437_;
                                                            phi_2438_ = _e1322;
                                                            phi_2439_ = _e977;
                                                            phi_2440_ = _e1324;
                                                        }
                                                        let _e1326 = phi_2438_;
                                                        let _e1328 = phi_2439_;
                                                        let _e1330 = phi_2440_;
                                                        phi_2441_ = _e1326;
                                                        phi_2442_ = _e1328;
                                                        phi_2443_ = _e1330;
                                                    }
                                                    let _e1332 = phi_2441_;
                                                    let _e1334 = phi_2442_;
                                                    let _e1336 = phi_2443_;
                                                    phi_2451_ = _e1332;
                                                    phi_2452_ = select(_e1336, true, _e1334);
                                                } else {
                                                    phi_2451_ = type_18();
                                                    phi_2452_ = true;
                                                }
                                                let _e1339 = phi_2451_;
                                                let _e1341 = phi_2452_;
                                                if _e1341 {
                                                    phi_2456_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2456_ = _e1339;
                                                }
                                                let _e1343 = phi_2456_;
                                                if (_e1343.member_3 != 4294967295u) {
                                                    if (_e720 != 4294967295u) {
                                                        if (_e1343.member < _e692.member.member) {
                                                            phi_2482_ = true;
                                                        } else {
                                                            if (_e1343.member == _e692.member.member) {
                                                                phi_2481_ = (_e1343.member_3 < _e692.member.member_3);
                                                            } else {
                                                                phi_2481_ = false;
                                                            }
                                                            let _e1356 = phi_2481_;
                                                            phi_2482_ = _e1356;
                                                        }
                                                        let _e1358 = phi_2482_;
                                                        if _e1358 {
                                                            phi_2488_ = type_29(_e1343, _e1343.member);
                                                        } else {
                                                            phi_2488_ = _e692;
                                                        }
                                                        let _e1361 = phi_2488_;
                                                        phi_2489_ = _e1361;
                                                    } else {
                                                        phi_2489_ = _e692;
                                                    }
                                                    let _e1363 = phi_2489_;
                                                    phi_2490_ = _e1363;
                                                } else {
                                                    phi_2490_ = _e692;
                                                }
                                                let _e1365 = phi_2490_;
                                                phi_1229_ = _e1365;
                                            } else {
                                                phi_1229_ = type_29();
                                            }
                                            let _e1367 = phi_1229_;
                                            continue;
                                            continuing {
                                                phi_1228_ = _e1367;
                                                phi_1231_ = _e707;
                                                phi_3717_ = _e635;
                                                break if !(_e713);
                                            }
                                        }
                                        let _e1370 = phi_3717_;
                                        phi_3895_ = _e1370;
                                        if _e1370 {
                                            break;
                                        }
                                        phi_3954_ = _e1370;
                                        let _e2013 = local_11;
                                        phi_2491_ = _e2013;
                                    } else {
                                        phi_3954_ = _e635;
                                        phi_2491_ = _e637;
                                    }
                                    let _e1372 = phi_3954_;
                                    let _e1374 = phi_2491_;
                                    if _e684 {
                                        phi_3498_ = bool();
                                        phi_3499_ = u32();
                                        phi_3500_ = type_50();
                                    } else {
                                        let _e1375 = (_e680.member_1 < _e85);
                                        if _e1375 {
                                            if _e1375 {
                                            } else {
                                                phi_3895_ = true;
                                                break;
                                            }
                                            let _e1377 = global_4.member[_e680.member_1];
                                            phi_2512_ = _e1377;
                                        } else {
                                            phi_2512_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1379 = phi_2512_;
                                        let _e1394 = ((10u * _e248) & 31u);
                                        let _e1397 = ((_e1379.member[0] >> bitcast<u32>(_e1394)) & 1023u);
                                        let _e1405 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e120));
                                        let _e1410 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1397)) - 8388608f) * _e1405)) ^ _e120)));
                                        let _e1414 = select(select(_e680.member.member_1[0], _e1410, (_e1410 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1397 == 1023u));
                                        let _e1416 = ((10u * _e247) & 31u);
                                        let _e1419 = ((_e1379.member[0] >> bitcast<u32>(_e1416)) & 1023u);
                                        let _e1427 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e120));
                                        let _e1432 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1419)) - 8388608f) * _e1427)) ^ _e120)));
                                        let _e1436 = select(select(_e680.member.member_1[1], _e1432, (_e1432 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1419 == 1023u));
                                        let _e1438 = ((10u * _e249) & 31u);
                                        let _e1441 = ((_e1379.member[0] >> bitcast<u32>(_e1438)) & 1023u);
                                        let _e1449 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e120));
                                        let _e1454 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1441)) - 8388608f) * _e1449)) ^ _e120)));
                                        let _e1458 = select(select(_e680.member.member_1[2], _e1454, (_e1454 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1441 == 1023u));
                                        let _e1461 = ((_e1379.member[1] >> bitcast<u32>(_e1394)) & 1023u);
                                        let _e1469 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1461)) - 8388608f) * _e1405)) ^ _e120)));
                                        let _e1473 = select(select(_e680.member.member_1[0], _e1469, (_e1469 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1461 == 1023u));
                                        let _e1476 = ((_e1379.member[1] >> bitcast<u32>(_e1416)) & 1023u);
                                        let _e1484 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1476)) - 8388608f) * _e1427)) ^ _e120)));
                                        let _e1488 = select(select(_e680.member.member_1[1], _e1484, (_e1484 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1476 == 1023u));
                                        let _e1491 = ((_e1379.member[1] >> bitcast<u32>(_e1438)) & 1023u);
                                        let _e1499 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1491)) - 8388608f) * _e1449)) ^ _e120)));
                                        let _e1503 = select(select(_e680.member.member_1[2], _e1499, (_e1499 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1491 == 1023u));
                                        let _e1509 = ((_e1379.member_1[0] >> bitcast<u32>(_e1394)) & 1023u);
                                        let _e1517 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1509)) - 8388608f) * _e1405)) ^ _e120)));
                                        let _e1521 = select(select(_e680.member.member_1[0], _e1517, (_e1517 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1509 == 1023u));
                                        let _e1524 = ((_e1379.member_1[0] >> bitcast<u32>(_e1416)) & 1023u);
                                        let _e1532 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1524)) - 8388608f) * _e1427)) ^ _e120)));
                                        let _e1536 = select(select(_e680.member.member_1[1], _e1532, (_e1532 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1524 == 1023u));
                                        let _e1539 = ((_e1379.member_1[0] >> bitcast<u32>(_e1438)) & 1023u);
                                        let _e1547 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1539)) - 8388608f) * _e1449)) ^ _e120)));
                                        let _e1551 = select(select(_e680.member.member_1[2], _e1547, (_e1547 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1539 == 1023u));
                                        let _e1554 = ((_e1379.member_1[1] >> bitcast<u32>(_e1394)) & 1023u);
                                        let _e1562 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1554)) - 8388608f) * _e1405)) ^ _e120)));
                                        let _e1566 = select(select(_e680.member.member_1[0], _e1562, (_e1562 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1554 == 1023u));
                                        let _e1569 = ((_e1379.member_1[1] >> bitcast<u32>(_e1416)) & 1023u);
                                        let _e1577 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1569)) - 8388608f) * _e1427)) ^ _e120)));
                                        let _e1581 = select(select(_e680.member.member_1[1], _e1577, (_e1577 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1569 == 1023u));
                                        let _e1584 = ((_e1379.member_1[1] >> bitcast<u32>(_e1438)) & 1023u);
                                        let _e1592 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1584)) - 8388608f) * _e1449)) ^ _e120)));
                                        let _e1596 = select(select(_e680.member.member_1[2], _e1592, (_e1592 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1584 == 1023u));
                                        let _e1601 = type_50(type_42(array<f32, 3>(_e1414, _e1436, _e1458), array<f32, 3>(_e1473, _e1488, _e1503)), _e1379.member_2);
                                        let _e1606 = type_50(type_42(array<f32, 3>(_e1521, _e1536, _e1551), array<f32, 3>(_e1566, _e1581, _e1596)), _e1379.member_3);
                                        let _e1612 = ((_e1414 - _e350) * _e355);
                                        let _e1613 = ((_e1521 - _e350) * _e355);
                                        let _e1614 = ((_e1473 - _e351) * _e355);
                                        let _e1615 = ((_e1566 - _e351) * _e355);
                                        let _e1620 = ((_e1436 - _e418) * _e423);
                                        let _e1621 = ((_e1536 - _e418) * _e423);
                                        let _e1622 = ((_e1488 - _e419) * _e423);
                                        let _e1623 = ((_e1581 - _e419) * _e423);
                                        let _e1628 = ((_e1458 - _e486) * _e491);
                                        let _e1629 = ((_e1551 - _e486) * _e491);
                                        let _e1630 = ((_e1503 - _e487) * _e491);
                                        let _e1631 = ((_e1596 - _e487) * _e491);
                                        let _e1633 = select(_e1630, _e1628, (_e1628 < _e1630));
                                        let _e1635 = select(_e1631, _e1629, (_e1629 < _e1631));
                                        let _e1637 = select(_e1630, _e1628, (_e1628 > _e1630));
                                        let _e1639 = select(_e1631, _e1629, (_e1629 > _e1631));
                                        let _e1641 = select(_e1614, _e1612, (_e1612 < _e1614));
                                        let _e1643 = select(_e1615, _e1613, (_e1613 < _e1615));
                                        let _e1645 = select(_e1622, _e1620, (_e1620 < _e1622));
                                        let _e1647 = select(_e1623, _e1621, (_e1621 < _e1623));
                                        let _e1649 = select(_e1645, _e1641, (_e1641 > _e1645));
                                        let _e1651 = select(_e1647, _e1643, (_e1643 > _e1647));
                                        let _e1653 = select(_e1633, _e1649, (_e1649 > _e1633));
                                        let _e1655 = select(_e1635, _e1651, (_e1651 > _e1635));
                                        let _e1657 = select(_e1614, _e1612, (_e1612 > _e1614));
                                        let _e1659 = select(_e1615, _e1613, (_e1613 > _e1615));
                                        let _e1661 = select(_e1622, _e1620, (_e1620 > _e1622));
                                        let _e1663 = select(_e1623, _e1621, (_e1621 > _e1623));
                                        let _e1665 = select(_e1661, _e1657, (_e1657 < _e1661));
                                        let _e1667 = select(_e1663, _e1659, (_e1659 < _e1663));
                                        let _e1672 = -(_e1633);
                                        let _e1673 = -(_e1635);
                                        let _e1680 = (select(_e1637, _e1665, (_e1665 < _e1637)) + (select(_e1672, _e1637, (_e1637 > _e1672)) * 0.0000019073523f));
                                        let _e1681 = (select(_e1639, _e1667, (_e1667 < _e1639)) + (select(_e1673, _e1639, (_e1639 > _e1673)) * 0.0000019073523f));
                                        let _e1683 = select(_e603, _e1653, (_e1653 > _e603));
                                        let _e1685 = select(_e603, _e1655, (_e1655 > _e603));
                                        let _e1690 = (_e1683 <= select(_e1374.member_1, _e1680, (_e1680 < _e1374.member_1)));
                                        let _e1691 = (_e1685 <= select(_e1374.member_1, _e1681, (_e1681 < _e1374.member_1)));
                                        let _e1692 = (_e1683 <= _e1685);
                                        if _e1690 {
                                            if _e1691 {
                                                if _e1692 {
                                                    phi_3398_ = _e1606;
                                                } else {
                                                    phi_3398_ = _e1601;
                                                }
                                                let _e1694 = phi_3398_;
                                                let _e1701 = (_e678 % 128u);
                                                let _e1702 = (_e1701 < 128u);
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_6[_e1701] = _e1694.member_1;
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_5[_e1701] = _e1694.member.member[0];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_4[_e1701] = _e1694.member.member[1];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_3[_e1701] = _e1694.member.member[2];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_2[_e1701] = _e1694.member.member_1[0];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_1[_e1701] = _e1694.member.member_1[1];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local[_e1701] = _e1694.member.member_1[2];
                                                if _e1702 {
                                                } else {
                                                    phi_3895_ = true;
                                                    break;
                                                }
                                                local_7[_e1701] = select(_e1683, _e1685, _e1692);
                                                if _e1692 {
                                                    phi_3474_ = _e1601;
                                                } else {
                                                    phi_3474_ = _e1606;
                                                }
                                                let _e1719 = phi_3474_;
                                                phi_3475_ = (_e678 + 1u);
                                                phi_3476_ = _e1719;
                                            } else {
                                                phi_3475_ = u32();
                                                phi_3476_ = type_50();
                                            }
                                            let _e1721 = phi_3475_;
                                            let _e1723 = phi_3476_;
                                            phi_3478_ = _e1721;
                                            phi_3479_ = _e1723;
                                            phi_3480_ = select(true, false, _e1691);
                                        } else {
                                            phi_3478_ = u32();
                                            phi_3479_ = type_50();
                                            phi_3480_ = true;
                                        }
                                        let _e1726 = phi_3478_;
                                        let _e1728 = phi_3479_;
                                        let _e1730 = phi_3480_;
                                        if _e1730 {
                                            if _e1690 {
                                                phi_3487_ = _e1601;
                                            } else {
                                                phi_3487_ = _e1606;
                                            }
                                            let _e1732 = phi_3487_;
                                            phi_3492_ = select(_e1691, true, _e1690);
                                            phi_3494_ = _e1732;
                                        } else {
                                            phi_3492_ = _e676;
                                            phi_3494_ = _e1728;
                                        }
                                        let _e1735 = phi_3492_;
                                        let _e1737 = phi_3494_;
                                        phi_3498_ = _e1735;
                                        phi_3499_ = select(_e1726, _e678, _e1730);
                                        phi_3500_ = _e1737;
                                    }
                                    let _e1740 = phi_3498_;
                                    let _e1742 = phi_3499_;
                                    let _e1744 = phi_3500_;
                                    if _e684 {
                                        phi_3510_ = _e680;
                                    } else {
                                        phi_3510_ = _e1744;
                                    }
                                    let _e1746 = phi_3510_;
                                    phi_3898_ = _e1372;
                                    phi_3511_ = _e1374;
                                    phi_3512_ = (_e639 - 1u);
                                    phi_3513_ = select(_e1740, false, _e684);
                                    phi_3514_ = select(_e1742, _e678, _e684);
                                    phi_3515_ = _e1746;
                                } else {
                                    phi_3898_ = _e635;
                                    phi_3511_ = _e637;
                                    phi_3512_ = _e639;
                                    phi_3513_ = _e676;
                                    phi_3514_ = _e678;
                                    phi_3515_ = _e680;
                                }
                                let _e1750 = phi_3898_;
                                let _e1752 = phi_3511_;
                                let _e1754 = phi_3512_;
                                let _e1756 = phi_3513_;
                                let _e1758 = phi_3514_;
                                let _e1760 = phi_3515_;
                                phi_3897_ = _e1750;
                                phi_3516_ = _e1752;
                                phi_3517_ = _e1754;
                                phi_3518_ = _e1756;
                                phi_3519_ = _e1758;
                                phi_3520_ = _e1760;
                            } else {
                                phi_3897_ = _e635;
                                phi_3516_ = type_29();
                                phi_3517_ = u32();
                                phi_3518_ = bool();
                                phi_3519_ = u32();
                                phi_3520_ = type_50();
                            }
                            let _e1762 = phi_3897_;
                            let _e1764 = phi_3516_;
                            let _e1766 = phi_3517_;
                            let _e1768 = phi_3518_;
                            let _e1770 = phi_3519_;
                            let _e1772 = phi_3520_;
                            phi_3896_ = _e1762;
                            phi_1102_ = _e1764;
                            phi_1105_ = _e1766;
                            phi_1107_ = _e1768;
                            phi_1109_ = _e1770;
                            phi_1111_ = _e1772;
                            phi_3521_ = _e649;
                        } else {
                            phi_3896_ = _e635;
                            phi_1102_ = type_29();
                            phi_1105_ = u32();
                            phi_1107_ = bool();
                            phi_1109_ = u32();
                            phi_1111_ = type_50();
                            phi_3521_ = false;
                        }
                        let _e1774 = phi_3896_;
                        let _e1776 = phi_1102_;
                        let _e1778 = phi_1105_;
                        let _e1780 = phi_1107_;
                        let _e1782 = phi_1109_;
                        let _e1784 = phi_1111_;
                        let _e1786 = phi_3521_;
                        continue;
                        continuing {
                            phi_3723_ = _e1774;
                            phi_1101_ = _e1776;
                            phi_1104_ = _e1778;
                            phi_1106_ = _e1780;
                            phi_1108_ = _e1782;
                            phi_1110_ = _e1784;
                            phi_3895_ = _e1774;
                            break if !(_e1786);
                        }
                    }
                    let _e1789 = phi_3895_;
                    if _e1789 {
                        break;
                    }
                    let _e1791 = local_10;
                    if (_e1791.member.member_3 != 4294967295u) {
                        let _e1796 = -(_e505);
                        let _e1797 = bitcast<u32>(_e1791.member.member);
                        let _e1801 = (bitcast<i32>((_e1797 >> bitcast<u32>(23i))) & 255i);
                        let _e1802 = (_e1801 + _e1796);
                        if (_e1801 == 255i) {
                            phi_3580_ = _e1791.member.member;
                        } else {
                            if (_e1801 > 0i) {
                                if (_e1802 > 0i) {
                                    let _e1806 = (_e1802 < 255i);
                                    if _e1806 {
                                        phi_3559_ = bitcast<f32>((_e1797 + bitcast<u32>((_e1796 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3559_ = f32();
                                    }
                                    let _e1813 = phi_3559_;
                                    phi_3561_ = _e1813;
                                    phi_3562_ = select(true, false, _e1806);
                                } else {
                                    phi_3561_ = f32();
                                    phi_3562_ = true;
                                }
                                let _e1816 = phi_3561_;
                                let _e1818 = phi_3562_;
                                phi_3563_ = _e1816;
                                phi_3564_ = _e1818;
                            } else {
                                phi_3563_ = f32();
                                phi_3564_ = true;
                            }
                            let _e1820 = phi_3563_;
                            let _e1822 = phi_3564_;
                            if _e1822 {
                                let _e1823 = (_e1797 & 2147483648u);
                                let _e1830 = ((_e1797 & 8388607u) | (select(0u, 1u, ((_e1797 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1834 = (_e1830 == 0u);
                                if _e1834 {
                                    phi_3687_ = bitcast<f32>(_e1823);
                                } else {
                                    let _e1839 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1830)), 32u, _e1834) - 8u);
                                    let _e1842 = (_e1830 << bitcast<u32>((_e1839 & 31u)));
                                    let _e1844 = ((_e1802 + select(0i, 1i, (_e1801 == 0i))) - bitcast<i32>(_e1839));
                                    if (_e1844 >= 255i) {
                                        phi_3677_ = bitcast<f32>((_e1823 | 2139095040u));
                                        phi_3678_ = f32();
                                        phi_3679_ = true;
                                    } else {
                                        let _e1846 = (_e1844 > 0i);
                                        if _e1846 {
                                            phi_3671_ = bitcast<f32>(((_e1823 | (bitcast<u32>(_e1844) << bitcast<u32>(23i))) | (_e1842 & 8388607u)));
                                            phi_3672_ = f32();
                                        } else {
                                            if (_e1844 < -24i) {
                                                phi_3637_ = 26u;
                                            } else {
                                                phi_3637_ = bitcast<u32>((1i - _e1844));
                                            }
                                            let _e1851 = phi_3637_;
                                            let _e1852 = (_e1851 & 31u);
                                            let _e1854 = (_e1842 >> bitcast<u32>(_e1852));
                                            let _e1858 = (_e1842 & ((1u << bitcast<u32>(_e1852)) - 1u));
                                            let _e1862 = (1u << bitcast<u32>(((_e1851 - 1u) & 31u)));
                                            if (_e1858 > _e1862) {
                                                phi_3658_ = true;
                                            } else {
                                                if (_e1858 == _e1862) {
                                                    phi_3655_ = ((_e1854 & 1u) == 1u);
                                                } else {
                                                    phi_3655_ = false;
                                                }
                                                let _e1868 = phi_3655_;
                                                phi_3658_ = _e1868;
                                            }
                                            let _e1870 = phi_3658_;
                                            phi_3671_ = f32();
                                            phi_3672_ = bitcast<f32>((_e1823 | (_e1854 + select(0u, 1u, _e1870))));
                                        }
                                        let _e1883 = phi_3671_;
                                        let _e1885 = phi_3672_;
                                        phi_3677_ = _e1883;
                                        phi_3678_ = _e1885;
                                        phi_3679_ = _e1846;
                                    }
                                    let _e1889 = phi_3677_;
                                    let _e1891 = phi_3678_;
                                    let _e1893 = phi_3679_;
                                    phi_3687_ = select(_e1891, _e1889, _e1893);
                                }
                                let _e1897 = phi_3687_;
                                phi_3579_ = _e1897;
                            } else {
                                phi_3579_ = _e1820;
                            }
                            let _e1899 = phi_3579_;
                            phi_3580_ = _e1899;
                        }
                        let _e1901 = phi_3580_;
                        let _e1902 = bitcast<u32>(_e1901);
                        if ((_e1902 & 2147483647u) >= 2139095040u) {
                            phi_3592_ = bitcast<f32>(((_e1902 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3592_ = _e1901;
                        }
                        let _e1909 = phi_3592_;
                        phi_3597_ = type_18(_e1909, _e1791.member.member_1, _e1791.member.member_2, _e1791.member.member_3);
                    } else {
                        phi_3597_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1914 = phi_3597_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134] = _e1914;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
