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
    var phi_3719_: bool;
    var phi_1101_: type_29;
    var phi_1104_: bool;
    var phi_1106_: u32;
    var phi_1108_: u32;
    var phi_1110_: type_50;
    var phi_1121_: bool;
    var phi_1207_: bool;
    var phi_1208_: u32;
    var phi_1209_: type_50;
    var phi_2516_: type_37;
    var phi_3402_: type_50;
    var phi_3479_: type_50;
    var phi_3480_: u32;
    var phi_3481_: type_50;
    var phi_3483_: u32;
    var phi_3484_: type_50;
    var phi_3485_: bool;
    var phi_3492_: type_50;
    var phi_3497_: bool;
    var phi_3499_: type_50;
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
    var phi_3713_: bool;
    var phi_3895_: bool;
    var phi_3503_: type_29;
    var phi_3504_: bool;
    var phi_3505_: u32;
    var phi_3506_: type_50;
    var phi_3894_: bool;
    var phi_3507_: type_29;
    var phi_3508_: bool;
    var phi_3509_: u32;
    var phi_3510_: u32;
    var phi_3511_: type_50;
    var phi_3893_: bool;
    var phi_3512_: type_29;
    var phi_3513_: bool;
    var phi_3514_: u32;
    var phi_3515_: u32;
    var phi_3516_: type_50;
    var phi_3892_: bool;
    var phi_1102_: type_29;
    var phi_1105_: bool;
    var phi_1107_: u32;
    var phi_1109_: u32;
    var phi_1111_: type_50;
    var phi_3517_: bool;
    var phi_3891_: bool;
    var local_10: type_29;
    var phi_3555_: f32;
    var phi_3557_: f32;
    var phi_3558_: bool;
    var phi_3559_: f32;
    var phi_3560_: bool;
    var phi_3633_: u32;
    var phi_3651_: bool;
    var phi_3654_: bool;
    var phi_3667_: f32;
    var phi_3668_: f32;
    var phi_3673_: f32;
    var phi_3674_: f32;
    var phi_3675_: bool;
    var phi_3683_: f32;
    var phi_3575_: f32;
    var phi_3576_: f32;
    var phi_3588_: f32;
    var phi_3593_: type_18;
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
                    phi_3719_ = false;
                    phi_1101_ = type_29(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e601);
                    phi_1104_ = (_e603 <= _e601);
                    phi_1106_ = ((3u * _e85) + 1u);
                    phi_1108_ = 0u;
                    phi_1110_ = type_50(type_42(array<f32, 3>(_e611, _e615, _e619), array<f32, 3>(_e623, _e625, _e627)), select(0u, 2147483648u, (_e85 == 0u)));
                    loop {
                        let _e635 = phi_3719_;
                        let _e637 = phi_1101_;
                        let _e639 = phi_1104_;
                        let _e641 = phi_1106_;
                        let _e643 = phi_1108_;
                        let _e645 = phi_1110_;
                        local_10 = _e637;
                        if _e639 {
                            phi_1121_ = true;
                        } else {
                            phi_1121_ = (_e643 > 0u);
                        }
                        let _e648 = phi_1121_;
                        if _e648 {
                            let _e649 = (_e641 > 0u);
                            if _e649 {
                                if _e639 {
                                    phi_1207_ = _e639;
                                    phi_1208_ = _e643;
                                    phi_1209_ = _e645;
                                } else {
                                    let _e650 = (_e643 - 1u);
                                    let _e651 = (_e650 % 128u);
                                    let _e652 = (_e651 < 128u);
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e654 = local_6[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e656 = local_5[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e658 = local_4[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e660 = local_3[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e663 = local_2[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e665 = local_1[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e667 = local[_e651];
                                    if _e652 {
                                    } else {
                                        phi_3891_ = true;
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
                                    if ((_e680.member_1 & 2147483648u) != 0u) {
                                        phi_1228_ = _e637;
                                        phi_1231_ = type_4(0u, ((_e680.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1057 = phi_1228_;
                                            let _e1059 = phi_1231_;
                                            local_11 = _e1057;
                                            if (_e1059.member < _e1059.member_1) {
                                                phi_1232_ = type_4((_e1059.member + 1u), _e1059.member_1);
                                                phi_1254_ = type_4(1u, _e1059.member);
                                            } else {
                                                phi_1232_ = _e1059;
                                                phi_1254_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1072 = phi_1232_;
                                            let _e1074 = phi_1254_;
                                            let _e1078 = (bitcast<i32>(_e1074.member) != 0i);
                                            if _e1078 {
                                                let _e1079 = ((_e680.member_1 & 268435455u) + _e1074.member_1);
                                                let _e1080 = (_e1079 < arrayLength((&global_6.member)));
                                                if _e1080 {
                                                    if _e1080 {
                                                    } else {
                                                        phi_3713_ = true;
                                                        break;
                                                    }
                                                    let _e1083 = global_6.member[_e1079].member_1;
                                                    phi_1279_ = _e1083;
                                                } else {
                                                    phi_1279_ = 4294967295u;
                                                }
                                                let _e1085 = phi_1279_;
                                                if _e1080 {
                                                    if _e1080 {
                                                    } else {
                                                        phi_3713_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_6.member[_e1079];
                                                    phi_1295_ = _e1087;
                                                } else {
                                                    phi_1295_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1089 = phi_1295_;
                                                let _e1101 = ((10u * _e248) & 31u);
                                                let _e1104 = ((_e1089.member[0] >> bitcast<u32>(_e1101)) & 1023u);
                                                let _e1112 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e120));
                                                let _e1117 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1104)) - 8388608f) * _e1112)) ^ _e120)));
                                                let _e1121 = select(select(_e680.member.member_1[0], _e1117, (_e1117 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1104 == 1023u));
                                                let _e1123 = ((10u * _e247) & 31u);
                                                let _e1126 = ((_e1089.member[0] >> bitcast<u32>(_e1123)) & 1023u);
                                                let _e1134 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e120));
                                                let _e1139 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1126)) - 8388608f) * _e1134)) ^ _e120)));
                                                let _e1143 = select(select(_e680.member.member_1[1], _e1139, (_e1139 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1126 == 1023u));
                                                let _e1145 = ((10u * _e249) & 31u);
                                                let _e1148 = ((_e1089.member[0] >> bitcast<u32>(_e1145)) & 1023u);
                                                let _e1156 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e120));
                                                let _e1161 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1148)) - 8388608f) * _e1156)) ^ _e120)));
                                                let _e1165 = select(select(_e680.member.member_1[2], _e1161, (_e1161 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1148 == 1023u));
                                                let _e1169 = ((_e1089.member[1] >> bitcast<u32>(_e1101)) & 1023u);
                                                let _e1177 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1169)) - 8388608f) * _e1112)) ^ _e120)));
                                                let _e1181 = select(select(_e680.member.member_1[0], _e1177, (_e1177 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1169 == 1023u));
                                                let _e1184 = ((_e1089.member[1] >> bitcast<u32>(_e1123)) & 1023u);
                                                let _e1192 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1184)) - 8388608f) * _e1134)) ^ _e120)));
                                                let _e1196 = select(select(_e680.member.member_1[1], _e1192, (_e1192 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1184 == 1023u));
                                                let _e1199 = ((_e1089.member[1] >> bitcast<u32>(_e1145)) & 1023u);
                                                let _e1207 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1199)) - 8388608f) * _e1156)) ^ _e120)));
                                                let _e1211 = select(select(_e680.member.member_1[2], _e1207, (_e1207 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1199 == 1023u));
                                                let _e1215 = ((_e1089.member[2] >> bitcast<u32>(_e1101)) & 1023u);
                                                let _e1223 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1215)) - 8388608f) * _e1112)) ^ _e120)));
                                                let _e1227 = select(select(_e680.member.member_1[0], _e1223, (_e1223 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1215 == 1023u));
                                                let _e1230 = ((_e1089.member[2] >> bitcast<u32>(_e1123)) & 1023u);
                                                let _e1238 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1230)) - 8388608f) * _e1134)) ^ _e120)));
                                                let _e1242 = select(select(_e680.member.member_1[1], _e1238, (_e1238 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1230 == 1023u));
                                                let _e1245 = ((_e1089.member[2] >> bitcast<u32>(_e1145)) & 1023u);
                                                let _e1253 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1245)) - 8388608f) * _e1156)) ^ _e120)));
                                                let _e1257 = select(select(_e680.member.member_1[2], _e1253, (_e1253 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1245 == 1023u));
                                                let _e1261 = (_e1165 - _e449);
                                                let _e1264 = (((_e1121 - _e312) * _e488) - (_e1261 * _e352));
                                                let _e1267 = (((_e1143 - _e381) * _e488) - (_e1261 * _e420));
                                                let _e1270 = (_e1211 - _e449);
                                                let _e1273 = (((_e1181 - _e312) * _e488) - (_e1270 * _e352));
                                                let _e1276 = (((_e1196 - _e381) * _e488) - (_e1270 * _e420));
                                                let _e1279 = (_e1257 - _e449);
                                                let _e1282 = (((_e1227 - _e312) * _e488) - (_e1279 * _e352));
                                                let _e1285 = (((_e1242 - _e381) * _e488) - (_e1279 * _e420));
                                                let _e1286 = (_e1282 * _e1276);
                                                let _e1287 = (_e1285 * _e1273);
                                                let _e1288 = (_e1264 * _e1285);
                                                let _e1289 = (_e1267 * _e1282);
                                                let _e1290 = (_e1273 * _e1267);
                                                let _e1291 = (_e1276 * _e1264);
                                                let _e1296 = (((_e1286 >= _e1287) && (_e1288 >= _e1289)) && (_e1290 >= _e1291));
                                                if (_e1296 || (((_e1286 <= _e1287) && (_e1288 <= _e1289)) && (_e1290 <= _e1291))) {
                                                    let _e1303 = select(-1f, 1f, _e1296);
                                                    let _e1305 = ((_e1286 - _e1287) * _e1303);
                                                    let _e1307 = select(0f, _e1305, (_e1305 > 0f));
                                                    let _e1309 = ((_e1288 - _e1289) * _e1303);
                                                    let _e1311 = select(0f, _e1309, (_e1309 > 0f));
                                                    let _e1313 = ((_e1290 - _e1291) * _e1303);
                                                    let _e1315 = select(0f, _e1313, (_e1313 > 0f));
                                                    let _e1317 = ((_e1307 + _e1311) + _e1315);
                                                    if (_e1317 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2441_ = type_18();
                                                        phi_2442_ = true;
                                                        phi_2443_ = false;
                                                    } else {
                                                        let _e1320 = select(_e1273, _e1264, (_e1264 < _e1273));
                                                        if (select(_e1282, _e1320, (_e1320 < _e1282)) > 0f) {
                                                            phi_1733_ = true;
                                                        } else {
                                                            let _e1325 = select(_e1273, _e1264, (_e1264 > _e1273));
                                                            phi_1733_ = (select(_e1282, _e1325, (_e1325 > _e1282)) < 0f);
                                                        }
                                                        let _e1330 = phi_1733_;
                                                        if _e1330 {
                                                            phi_2438_ = type_18();
                                                            phi_2439_ = true;
                                                            phi_2440_ = false;
                                                        } else {
                                                            let _e1332 = select(_e1276, _e1267, (_e1267 < _e1276));
                                                            if (select(_e1285, _e1332, (_e1332 < _e1285)) > 0f) {
                                                                phi_1762_ = true;
                                                            } else {
                                                                let _e1337 = select(_e1276, _e1267, (_e1267 > _e1276));
                                                                phi_1762_ = (select(_e1285, _e1337, (_e1337 > _e1285)) < 0f);
                                                            }
                                                            let _e1342 = phi_1762_;
                                                            if _e1342 {
                                                                phi_2436_ = type_18();
                                                                phi_2437_ = false;
                                                            } else {
                                                                let _e1344 = select(_e1181, _e1121, (_e1121 < _e1181));
                                                                let _e1348 = select(_e1181, _e1121, (_e1121 > _e1181));
                                                                let _e1352 = select(_e1196, _e1143, (_e1143 < _e1196));
                                                                let _e1356 = select(_e1196, _e1143, (_e1143 > _e1196));
                                                                let _e1360 = select(_e1211, _e1165, (_e1165 < _e1211));
                                                                let _e1364 = select(_e1211, _e1165, (_e1165 > _e1211));
                                                                let _e1369 = ((select(_e1227, _e1344, (_e1344 < _e1227)) - _e350) * _e355);
                                                                let _e1370 = ((select(_e1227, _e1348, (_e1348 > _e1227)) - _e351) * _e355);
                                                                let _e1373 = ((select(_e1242, _e1352, (_e1352 < _e1242)) - _e418) * _e423);
                                                                let _e1374 = ((select(_e1242, _e1356, (_e1356 > _e1242)) - _e419) * _e423);
                                                                let _e1377 = ((select(_e1257, _e1360, (_e1360 < _e1257)) - _e486) * _e491);
                                                                let _e1378 = ((select(_e1257, _e1364, (_e1364 > _e1257)) - _e487) * _e491);
                                                                let _e1380 = select(_e1378, _e1377, (_e1377 < _e1378));
                                                                let _e1382 = select(_e1378, _e1377, (_e1377 > _e1378));
                                                                let _e1384 = select(_e1370, _e1369, (_e1369 < _e1370));
                                                                let _e1386 = select(_e1374, _e1373, (_e1373 < _e1374));
                                                                let _e1388 = select(_e1386, _e1384, (_e1384 > _e1386));
                                                                let _e1390 = select(_e1380, _e1388, (_e1388 > _e1380));
                                                                let _e1392 = select(_e1370, _e1369, (_e1369 > _e1370));
                                                                let _e1394 = select(_e1374, _e1373, (_e1373 > _e1374));
                                                                let _e1396 = select(_e1394, _e1392, (_e1392 < _e1394));
                                                                let _e1398 = select(_e1382, _e1396, (_e1396 < _e1382));
                                                                let _e1399 = -(_e1380);
                                                                let _e1405 = select(_e603, _e1390, (_e1390 > _e603));
                                                                if (_e1405 > (_e1398 + (select(_e1399, _e1382, (_e1382 > _e1399)) * 0.0000019073523f))) {
                                                                    phi_2431_ = type_18();
                                                                    phi_2432_ = true;
                                                                } else {
                                                                    let _e1407 = (_e1405 > _e1057.member_1);
                                                                    if _e1407 {
                                                                        phi_2430_ = type_18();
                                                                    } else {
                                                                        let _e1408 = vec3<f32>(_e1121, _e1143, _e1165);
                                                                        let _e1409 = vec3<f32>(_e1181, _e1196, _e1211);
                                                                        let _e1410 = vec3<f32>(_e1227, _e1242, _e1257);
                                                                        let _e1411 = (_e1181 - _e1121);
                                                                        let _e1412 = (_e1196 - _e1143);
                                                                        let _e1413 = (_e1211 - _e1165);
                                                                        let _e1414 = vec3<f32>(_e1411, _e1412, _e1413);
                                                                        let _e1415 = (_e1227 - _e1181);
                                                                        let _e1416 = (_e1242 - _e1196);
                                                                        let _e1417 = (_e1257 - _e1211);
                                                                        let _e1418 = vec3<f32>(_e1415, _e1416, _e1417);
                                                                        let _e1419 = (_e1121 - _e1227);
                                                                        let _e1420 = (_e1143 - _e1242);
                                                                        let _e1421 = (_e1165 - _e1257);
                                                                        let _e1422 = vec3<f32>(_e1419, _e1420, _e1421);
                                                                        let _e1425 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                                        let _e1428 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                                        let _e1430 = select(_e1428, _e1425, (_e1425 > _e1428));
                                                                        let _e1433 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                                        let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                        let _e1438 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                                        let _e1441 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                                        let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                        let _e1446 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                                        let _e1448 = select(_e1446, _e1443, (_e1443 > _e1446));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1454 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1456 = select(_e1454, _e1451, (_e1451 > _e1454));
                                                                        let _e1459 = bitcast<f32>((bitcast<u32>(_e1421) & 2147483647u));
                                                                        let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                        let _e1463 = select(_e1448, _e1435, (_e1435 > _e1448));
                                                                        let _e1465 = select(_e1461, _e1463, (_e1463 > _e1461));
                                                                        if (_e1435 == _e1465) {
                                                                            phi_2157_ = _e1276;
                                                                            phi_2158_ = _e1273;
                                                                            phi_2159_ = _e1267;
                                                                            phi_2160_ = _e1264;
                                                                            phi_2161_ = _e1408;
                                                                            phi_2162_ = _e1422;
                                                                            phi_2163_ = _e1418;
                                                                            phi_2164_ = _e1414;
                                                                        } else {
                                                                            let _e1467 = (_e1448 == _e1465);
                                                                            let _e1472 = vec3(_e1467);
                                                                            phi_2157_ = select(_e1267, _e1285, _e1467);
                                                                            phi_2158_ = select(_e1264, _e1282, _e1467);
                                                                            phi_2159_ = select(_e1285, _e1276, _e1467);
                                                                            phi_2160_ = select(_e1282, _e1273, _e1467);
                                                                            phi_2161_ = select(_e1410, _e1409, _e1472);
                                                                            phi_2162_ = select(_e1418, _e1414, _e1472);
                                                                            phi_2163_ = select(_e1414, _e1422, _e1472);
                                                                            phi_2164_ = select(_e1422, _e1418, _e1472);
                                                                        }
                                                                        let _e1478 = phi_2157_;
                                                                        let _e1480 = phi_2158_;
                                                                        let _e1482 = phi_2159_;
                                                                        let _e1484 = phi_2160_;
                                                                        let _e1486 = phi_2161_;
                                                                        let _e1488 = phi_2162_;
                                                                        let _e1490 = phi_2163_;
                                                                        let _e1492 = phi_2164_;
                                                                        let _e1499 = ((_e1490.y * _e1488.z) - (_e1488.y * _e1490.z));
                                                                        let _e1504 = ((_e1490.z * _e1488.x) - (_e1488.z * _e1490.x));
                                                                        let _e1507 = ((_e1490.x * _e1488.y) - (_e1488.x * _e1490.y));
                                                                        if (_e1307 >= _e1311) {
                                                                            phi_2201_ = select(true, false, (_e1307 >= _e1315));
                                                                        } else {
                                                                            phi_2201_ = true;
                                                                        }
                                                                        let _e1512 = phi_2201_;
                                                                        if _e1512 {
                                                                            phi_2210_ = select(_e1410, _e1409, vec3((_e1311 >= _e1315)));
                                                                        } else {
                                                                            phi_2210_ = _e1408;
                                                                        }
                                                                        let _e1517 = phi_2210_;
                                                                        let _e1528 = (((_e1499 * (_e1517.x - _e312)) + (_e1504 * (_e1517.y - _e381))) + (_e1507 * (_e1517.z - _e449)));
                                                                        let _e1533 = (((_e1499 * _e352) + (_e1504 * _e420)) + (_e1507 * _e488));
                                                                        let _e1534 = (_e1480 - _e1484);
                                                                        let _e1535 = (_e1478 - _e1482);
                                                                        let _e1543 = (-(((_e1484 * _e1534) + (_e1482 * _e1535))) / ((_e1534 * _e1534) + (_e1535 * _e1535)));
                                                                        let _e1545 = select(1f, _e1543, (_e1543 < 1f));
                                                                        let _e1547 = select(0f, _e1545, (_e1545 > 0f));
                                                                        let _e1560 = ((_e1486.x + (_e1492.x * _e1547)) - _e312);
                                                                        let _e1561 = ((_e1486.y + (_e1492.y * _e1547)) - _e381);
                                                                        let _e1562 = ((_e1486.z + (_e1492.z * _e1547)) - _e449);
                                                                        let _e1563 = (_e1562 / _e488);
                                                                        let _e1575 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                        let _e1578 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                        let _e1580 = select(_e1578, _e1575, (_e1575 > _e1578));
                                                                        let _e1583 = bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u));
                                                                        let _e1585 = select(_e1583, _e1580, (_e1580 > _e1583));
                                                                        let _e1591 = bitcast<f32>((bitcast<u32>(_e1499) & 2147483647u));
                                                                        let _e1594 = bitcast<f32>((bitcast<u32>(_e1504) & 2147483647u));
                                                                        let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1499 * _e1560) + (_e1504 * _e1561)) + (_e1507 * _e1562)) - _e1528)) & 2147483647u)) <= ((0.0000009536743f * select(_e1465, _e1585, (_e1585 > _e1465))) * select(_e1599, _e1596, (_e1596 > _e1599)))) {
                                                                            let _e1609 = bitcast<f32>((bitcast<u32>(_e1490.x) & 2147483647u));
                                                                            let _e1612 = bitcast<f32>((bitcast<u32>(_e1490.y) & 2147483647u));
                                                                            let _e1614 = select(_e1612, _e1609, (_e1609 > _e1612));
                                                                            let _e1617 = bitcast<f32>((bitcast<u32>(_e1490.z) & 2147483647u));
                                                                            let _e1623 = bitcast<f32>((bitcast<u32>(_e1488.x) & 2147483647u));
                                                                            let _e1626 = bitcast<f32>((bitcast<u32>(_e1488.y) & 2147483647u));
                                                                            let _e1628 = select(_e1626, _e1623, (_e1623 > _e1626));
                                                                            let _e1631 = bitcast<f32>((bitcast<u32>(_e1488.z) & 2147483647u));
                                                                            let _e1635 = (bitcast<f32>((bitcast<u32>(_e1533) & 2147483647u)) > ((0.0000038146973f * select(_e1617, _e1614, (_e1614 > _e1617))) * select(_e1631, _e1628, (_e1628 > _e1631))));
                                                                            if _e1635 {
                                                                                phi_2375_ = (_e1528 / _e1533);
                                                                            } else {
                                                                                phi_2375_ = f32();
                                                                            }
                                                                            let _e1638 = phi_2375_;
                                                                            phi_2377_ = _e1638;
                                                                            phi_2378_ = select(true, false, _e1635);
                                                                        } else {
                                                                            phi_2377_ = f32();
                                                                            phi_2378_ = true;
                                                                        }
                                                                        let _e1641 = phi_2377_;
                                                                        let _e1643 = phi_2378_;
                                                                        if _e1643 {
                                                                            let _e1651 = (((_e1499 * (_e1560 - (_e352 * _e1563))) + (_e1504 * (_e1561 - (_e420 * _e1563)))) / _e1533);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u)) <= _e1465) {
                                                                                phi_2398_ = (_e1563 + _e1651);
                                                                            } else {
                                                                                phi_2398_ = _e1563;
                                                                            }
                                                                            let _e1658 = phi_2398_;
                                                                            phi_2399_ = _e1658;
                                                                        } else {
                                                                            phi_2399_ = _e1641;
                                                                        }
                                                                        let _e1660 = phi_2399_;
                                                                        let _e1662 = select(_e1398, _e1660, (_e1660 < _e1398));
                                                                        let _e1664 = select(_e1390, _e1662, (_e1662 > _e1390));
                                                                        if (_e1664 >= _e603) {
                                                                            let _e1666 = (_e1664 <= _e1057.member_1);
                                                                            if _e1666 {
                                                                                let _e1667 = (1f / _e1317);
                                                                                phi_2422_ = type_18(_e1664, (_e1311 * _e1667), (_e1315 * _e1667), _e1085);
                                                                            } else {
                                                                                phi_2422_ = type_18();
                                                                            }
                                                                            let _e1672 = phi_2422_;
                                                                            phi_2424_ = _e1672;
                                                                            phi_2425_ = select(true, false, _e1666);
                                                                        } else {
                                                                            phi_2424_ = type_18();
                                                                            phi_2425_ = true;
                                                                        }
                                                                        let _e1675 = phi_2424_;
                                                                        let _e1677 = phi_2425_;
                                                                        if _e1677 {
                                                                            phi_2429_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2429_ = _e1675;
                                                                        }
                                                                        let _e1679 = phi_2429_;
                                                                        phi_2430_ = _e1679;
                                                                    }
                                                                    let _e1681 = phi_2430_;
                                                                    phi_2431_ = _e1681;
                                                                    phi_2432_ = _e1407;
                                                                }
                                                                let _e1683 = phi_2431_;
                                                                let _e1685 = phi_2432_;
                                                                phi_2436_ = _e1683;
                                                                phi_2437_ = _e1685;
                                                            }
                                                            let _e1687 = phi_2436_;
                                                            let _e1689 = phi_2437_;
                                                            phi_2438_ = _e1687;
                                                            phi_2439_ = _e1342;
                                                            phi_2440_ = _e1689;
                                                        }
                                                        let _e1691 = phi_2438_;
                                                        let _e1693 = phi_2439_;
                                                        let _e1695 = phi_2440_;
                                                        phi_2441_ = _e1691;
                                                        phi_2442_ = _e1693;
                                                        phi_2443_ = _e1695;
                                                    }
                                                    let _e1697 = phi_2441_;
                                                    let _e1699 = phi_2442_;
                                                    let _e1701 = phi_2443_;
                                                    phi_2451_ = _e1697;
                                                    phi_2452_ = select(_e1701, true, _e1699);
                                                } else {
                                                    phi_2451_ = type_18();
                                                    phi_2452_ = true;
                                                }
                                                let _e1704 = phi_2451_;
                                                let _e1706 = phi_2452_;
                                                if _e1706 {
                                                    phi_2456_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2456_ = _e1704;
                                                }
                                                let _e1708 = phi_2456_;
                                                if (_e1708.member_3 != 4294967295u) {
                                                    if (_e1085 != 4294967295u) {
                                                        if (_e1708.member < _e1057.member.member) {
                                                            phi_2482_ = true;
                                                        } else {
                                                            if (_e1708.member == _e1057.member.member) {
                                                                phi_2481_ = (_e1708.member_3 < _e1057.member.member_3);
                                                            } else {
                                                                phi_2481_ = false;
                                                            }
                                                            let _e1721 = phi_2481_;
                                                            phi_2482_ = _e1721;
                                                        }
                                                        let _e1723 = phi_2482_;
                                                        if _e1723 {
                                                            phi_2488_ = type_29(_e1708, _e1708.member);
                                                        } else {
                                                            phi_2488_ = _e1057;
                                                        }
                                                        let _e1726 = phi_2488_;
                                                        phi_2489_ = _e1726;
                                                    } else {
                                                        phi_2489_ = _e1057;
                                                    }
                                                    let _e1728 = phi_2489_;
                                                    phi_2490_ = _e1728;
                                                } else {
                                                    phi_2490_ = _e1057;
                                                }
                                                let _e1730 = phi_2490_;
                                                phi_1229_ = _e1730;
                                            } else {
                                                phi_1229_ = type_29();
                                            }
                                            let _e1732 = phi_1229_;
                                            continue;
                                            continuing {
                                                phi_1228_ = _e1732;
                                                phi_1231_ = _e1072;
                                                phi_3713_ = _e635;
                                                break if !(_e1078);
                                            }
                                        }
                                        let _e1735 = phi_3713_;
                                        phi_3891_ = _e1735;
                                        if _e1735 {
                                            break;
                                        }
                                        phi_3895_ = _e1735;
                                        let _e2021 = local_11;
                                        phi_3503_ = _e2021;
                                        phi_3504_ = false;
                                        phi_3505_ = _e678;
                                        phi_3506_ = _e680;
                                    } else {
                                        let _e690 = (_e680.member_1 < _e85);
                                        if _e690 {
                                            if _e690 {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e692 = global_4.member[_e680.member_1];
                                            phi_2516_ = _e692;
                                        } else {
                                            phi_2516_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e694 = phi_2516_;
                                        let _e709 = ((10u * _e248) & 31u);
                                        let _e712 = ((_e694.member[0] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e720 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e120));
                                        let _e725 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e712)) - 8388608f) * _e720)) ^ _e120)));
                                        let _e729 = select(select(_e680.member.member_1[0], _e725, (_e725 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e712 == 1023u));
                                        let _e731 = ((10u * _e247) & 31u);
                                        let _e734 = ((_e694.member[0] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e742 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e120));
                                        let _e747 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e734)) - 8388608f) * _e742)) ^ _e120)));
                                        let _e751 = select(select(_e680.member.member_1[1], _e747, (_e747 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e734 == 1023u));
                                        let _e753 = ((10u * _e249) & 31u);
                                        let _e756 = ((_e694.member[0] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e764 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e120));
                                        let _e769 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e756)) - 8388608f) * _e764)) ^ _e120)));
                                        let _e773 = select(select(_e680.member.member_1[2], _e769, (_e769 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e756 == 1023u));
                                        let _e776 = ((_e694.member[1] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e784 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e776)) - 8388608f) * _e720)) ^ _e120)));
                                        let _e788 = select(select(_e680.member.member_1[0], _e784, (_e784 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e776 == 1023u));
                                        let _e791 = ((_e694.member[1] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e799 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e791)) - 8388608f) * _e742)) ^ _e120)));
                                        let _e803 = select(select(_e680.member.member_1[1], _e799, (_e799 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e791 == 1023u));
                                        let _e806 = ((_e694.member[1] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e814 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e806)) - 8388608f) * _e764)) ^ _e120)));
                                        let _e818 = select(select(_e680.member.member_1[2], _e814, (_e814 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e806 == 1023u));
                                        let _e824 = ((_e694.member_1[0] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e832 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e824)) - 8388608f) * _e720)) ^ _e120)));
                                        let _e836 = select(select(_e680.member.member_1[0], _e832, (_e832 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e824 == 1023u));
                                        let _e839 = ((_e694.member_1[0] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e847 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e742)) ^ _e120)));
                                        let _e851 = select(select(_e680.member.member_1[1], _e847, (_e847 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e839 == 1023u));
                                        let _e854 = ((_e694.member_1[0] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e862 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e764)) ^ _e120)));
                                        let _e866 = select(select(_e680.member.member_1[2], _e862, (_e862 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e854 == 1023u));
                                        let _e869 = ((_e694.member_1[1] >> bitcast<u32>(_e709)) & 1023u);
                                        let _e877 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e720)) ^ _e120)));
                                        let _e881 = select(select(_e680.member.member_1[0], _e877, (_e877 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e869 == 1023u));
                                        let _e884 = ((_e694.member_1[1] >> bitcast<u32>(_e731)) & 1023u);
                                        let _e892 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e884)) - 8388608f) * _e742)) ^ _e120)));
                                        let _e896 = select(select(_e680.member.member_1[1], _e892, (_e892 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e884 == 1023u));
                                        let _e899 = ((_e694.member_1[1] >> bitcast<u32>(_e753)) & 1023u);
                                        let _e907 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e899)) - 8388608f) * _e764)) ^ _e120)));
                                        let _e911 = select(select(_e680.member.member_1[2], _e907, (_e907 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e899 == 1023u));
                                        let _e916 = type_50(type_42(array<f32, 3>(_e729, _e751, _e773), array<f32, 3>(_e788, _e803, _e818)), _e694.member_2);
                                        let _e921 = type_50(type_42(array<f32, 3>(_e836, _e851, _e866), array<f32, 3>(_e881, _e896, _e911)), _e694.member_3);
                                        let _e927 = ((_e729 - _e350) * _e355);
                                        let _e928 = ((_e836 - _e350) * _e355);
                                        let _e929 = ((_e788 - _e351) * _e355);
                                        let _e930 = ((_e881 - _e351) * _e355);
                                        let _e935 = ((_e751 - _e418) * _e423);
                                        let _e936 = ((_e851 - _e418) * _e423);
                                        let _e937 = ((_e803 - _e419) * _e423);
                                        let _e938 = ((_e896 - _e419) * _e423);
                                        let _e943 = ((_e773 - _e486) * _e491);
                                        let _e944 = ((_e866 - _e486) * _e491);
                                        let _e945 = ((_e818 - _e487) * _e491);
                                        let _e946 = ((_e911 - _e487) * _e491);
                                        let _e948 = select(_e945, _e943, (_e943 < _e945));
                                        let _e950 = select(_e946, _e944, (_e944 < _e946));
                                        let _e952 = select(_e945, _e943, (_e943 > _e945));
                                        let _e954 = select(_e946, _e944, (_e944 > _e946));
                                        let _e956 = select(_e929, _e927, (_e927 < _e929));
                                        let _e958 = select(_e930, _e928, (_e928 < _e930));
                                        let _e960 = select(_e937, _e935, (_e935 < _e937));
                                        let _e962 = select(_e938, _e936, (_e936 < _e938));
                                        let _e964 = select(_e960, _e956, (_e956 > _e960));
                                        let _e966 = select(_e962, _e958, (_e958 > _e962));
                                        let _e968 = select(_e948, _e964, (_e964 > _e948));
                                        let _e970 = select(_e950, _e966, (_e966 > _e950));
                                        let _e972 = select(_e929, _e927, (_e927 > _e929));
                                        let _e974 = select(_e930, _e928, (_e928 > _e930));
                                        let _e976 = select(_e937, _e935, (_e935 > _e937));
                                        let _e978 = select(_e938, _e936, (_e936 > _e938));
                                        let _e980 = select(_e976, _e972, (_e972 < _e976));
                                        let _e982 = select(_e978, _e974, (_e974 < _e978));
                                        let _e987 = -(_e948);
                                        let _e988 = -(_e950);
                                        let _e995 = (select(_e952, _e980, (_e980 < _e952)) + (select(_e987, _e952, (_e952 > _e987)) * 0.0000019073523f));
                                        let _e996 = (select(_e954, _e982, (_e982 < _e954)) + (select(_e988, _e954, (_e954 > _e988)) * 0.0000019073523f));
                                        let _e998 = select(_e603, _e968, (_e968 > _e603));
                                        let _e1000 = select(_e603, _e970, (_e970 > _e603));
                                        let _e1005 = (_e998 <= select(_e637.member_1, _e995, (_e995 < _e637.member_1)));
                                        let _e1006 = (_e1000 <= select(_e637.member_1, _e996, (_e996 < _e637.member_1)));
                                        let _e1007 = (_e998 <= _e1000);
                                        if _e1005 {
                                            if _e1006 {
                                                if _e1007 {
                                                    phi_3402_ = _e921;
                                                } else {
                                                    phi_3402_ = _e916;
                                                }
                                                let _e1009 = phi_3402_;
                                                let _e1017 = (_e678 % 128u);
                                                let _e1018 = (_e1017 < 128u);
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_6[_e1017] = _e1009.member_1;
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_5[_e1017] = _e1009.member.member[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_4[_e1017] = _e1009.member.member[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_3[_e1017] = _e1009.member.member[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_2[_e1017] = _e1009.member.member_1[0];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_1[_e1017] = _e1009.member.member_1[1];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local[_e1017] = _e1009.member.member_1[2];
                                                if _e1018 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_7[_e1017] = select(_e1000, _e998, !(_e1007));
                                                if _e1007 {
                                                    phi_3479_ = _e916;
                                                } else {
                                                    phi_3479_ = _e921;
                                                }
                                                let _e1035 = phi_3479_;
                                                phi_3480_ = (_e678 + 1u);
                                                phi_3481_ = _e1035;
                                            } else {
                                                phi_3480_ = u32();
                                                phi_3481_ = type_50();
                                            }
                                            let _e1037 = phi_3480_;
                                            let _e1039 = phi_3481_;
                                            phi_3483_ = _e1037;
                                            phi_3484_ = _e1039;
                                            phi_3485_ = select(true, false, _e1006);
                                        } else {
                                            phi_3483_ = u32();
                                            phi_3484_ = type_50();
                                            phi_3485_ = true;
                                        }
                                        let _e1042 = phi_3483_;
                                        let _e1044 = phi_3484_;
                                        let _e1046 = phi_3485_;
                                        if _e1046 {
                                            if _e1005 {
                                                phi_3492_ = _e916;
                                            } else {
                                                phi_3492_ = _e921;
                                            }
                                            let _e1048 = phi_3492_;
                                            phi_3497_ = select(_e1006, true, _e1005);
                                            phi_3499_ = _e1048;
                                        } else {
                                            phi_3497_ = _e676;
                                            phi_3499_ = _e1044;
                                        }
                                        let _e1051 = phi_3497_;
                                        let _e1053 = phi_3499_;
                                        phi_3895_ = _e635;
                                        phi_3503_ = _e637;
                                        phi_3504_ = _e1051;
                                        phi_3505_ = select(_e1042, _e678, _e1046);
                                        phi_3506_ = _e1053;
                                    }
                                    let _e1737 = phi_3895_;
                                    let _e1739 = phi_3503_;
                                    let _e1741 = phi_3504_;
                                    let _e1743 = phi_3505_;
                                    let _e1745 = phi_3506_;
                                    phi_3894_ = _e1737;
                                    phi_3507_ = _e1739;
                                    phi_3508_ = _e1741;
                                    phi_3509_ = (_e641 - 1u);
                                    phi_3510_ = _e1743;
                                    phi_3511_ = _e1745;
                                } else {
                                    phi_3894_ = _e635;
                                    phi_3507_ = _e637;
                                    phi_3508_ = _e676;
                                    phi_3509_ = _e641;
                                    phi_3510_ = _e678;
                                    phi_3511_ = _e680;
                                }
                                let _e1747 = phi_3894_;
                                let _e1749 = phi_3507_;
                                let _e1751 = phi_3508_;
                                let _e1753 = phi_3509_;
                                let _e1755 = phi_3510_;
                                let _e1757 = phi_3511_;
                                phi_3893_ = _e1747;
                                phi_3512_ = _e1749;
                                phi_3513_ = _e1751;
                                phi_3514_ = _e1753;
                                phi_3515_ = _e1755;
                                phi_3516_ = _e1757;
                            } else {
                                phi_3893_ = _e635;
                                phi_3512_ = type_29();
                                phi_3513_ = bool();
                                phi_3514_ = u32();
                                phi_3515_ = u32();
                                phi_3516_ = type_50();
                            }
                            let _e1759 = phi_3893_;
                            let _e1761 = phi_3512_;
                            let _e1763 = phi_3513_;
                            let _e1765 = phi_3514_;
                            let _e1767 = phi_3515_;
                            let _e1769 = phi_3516_;
                            phi_3892_ = _e1759;
                            phi_1102_ = _e1761;
                            phi_1105_ = _e1763;
                            phi_1107_ = _e1765;
                            phi_1109_ = _e1767;
                            phi_1111_ = _e1769;
                            phi_3517_ = _e649;
                        } else {
                            phi_3892_ = _e635;
                            phi_1102_ = type_29();
                            phi_1105_ = bool();
                            phi_1107_ = u32();
                            phi_1109_ = u32();
                            phi_1111_ = type_50();
                            phi_3517_ = false;
                        }
                        let _e1771 = phi_3892_;
                        let _e1773 = phi_1102_;
                        let _e1775 = phi_1105_;
                        let _e1777 = phi_1107_;
                        let _e1779 = phi_1109_;
                        let _e1781 = phi_1111_;
                        let _e1783 = phi_3517_;
                        continue;
                        continuing {
                            phi_3719_ = _e1771;
                            phi_1101_ = _e1773;
                            phi_1104_ = _e1775;
                            phi_1106_ = _e1777;
                            phi_1108_ = _e1779;
                            phi_1110_ = _e1781;
                            phi_3891_ = _e1771;
                            break if !(_e1783);
                        }
                    }
                    let _e1786 = phi_3891_;
                    if _e1786 {
                        break;
                    }
                    let _e1788 = local_10;
                    if (_e1788.member.member_3 != 4294967295u) {
                        let _e1793 = -(_e505);
                        let _e1794 = bitcast<u32>(_e1788.member.member);
                        let _e1798 = (bitcast<i32>((_e1794 >> bitcast<u32>(23i))) & 255i);
                        let _e1799 = (_e1798 + _e1793);
                        if (_e1798 == 255i) {
                            phi_3576_ = _e1788.member.member;
                        } else {
                            if (_e1798 > 0i) {
                                if (_e1799 > 0i) {
                                    let _e1803 = (_e1799 < 255i);
                                    if _e1803 {
                                        phi_3555_ = bitcast<f32>((_e1794 + bitcast<u32>((_e1793 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3555_ = f32();
                                    }
                                    let _e1810 = phi_3555_;
                                    phi_3557_ = _e1810;
                                    phi_3558_ = select(true, false, _e1803);
                                } else {
                                    phi_3557_ = f32();
                                    phi_3558_ = true;
                                }
                                let _e1813 = phi_3557_;
                                let _e1815 = phi_3558_;
                                phi_3559_ = _e1813;
                                phi_3560_ = _e1815;
                            } else {
                                phi_3559_ = f32();
                                phi_3560_ = true;
                            }
                            let _e1817 = phi_3559_;
                            let _e1819 = phi_3560_;
                            if _e1819 {
                                let _e1820 = (_e1794 & 2147483648u);
                                let _e1827 = ((_e1794 & 8388607u) | (select(0u, 1u, ((_e1794 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1831 = (_e1827 == 0u);
                                if _e1831 {
                                    phi_3683_ = bitcast<f32>(_e1820);
                                } else {
                                    let _e1836 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1827)), 32u, _e1831) - 8u);
                                    let _e1839 = (_e1827 << bitcast<u32>((_e1836 & 31u)));
                                    let _e1841 = ((_e1799 + select(0i, 1i, (_e1798 == 0i))) - bitcast<i32>(_e1836));
                                    if (_e1841 >= 255i) {
                                        phi_3673_ = bitcast<f32>((_e1820 | 2139095040u));
                                        phi_3674_ = f32();
                                        phi_3675_ = true;
                                    } else {
                                        let _e1843 = (_e1841 > 0i);
                                        if _e1843 {
                                            phi_3667_ = bitcast<f32>(((_e1820 | (bitcast<u32>(_e1841) << bitcast<u32>(23i))) | (_e1839 & 8388607u)));
                                            phi_3668_ = f32();
                                        } else {
                                            if (_e1841 < -24i) {
                                                phi_3633_ = 26u;
                                            } else {
                                                phi_3633_ = bitcast<u32>((1i - _e1841));
                                            }
                                            let _e1848 = phi_3633_;
                                            let _e1849 = (_e1848 & 31u);
                                            let _e1851 = (_e1839 >> bitcast<u32>(_e1849));
                                            let _e1855 = (_e1839 & ((1u << bitcast<u32>(_e1849)) - 1u));
                                            let _e1859 = (1u << bitcast<u32>(((_e1848 - 1u) & 31u)));
                                            if (_e1855 > _e1859) {
                                                phi_3654_ = true;
                                            } else {
                                                if (_e1855 == _e1859) {
                                                    phi_3651_ = ((_e1851 & 1u) == 1u);
                                                } else {
                                                    phi_3651_ = false;
                                                }
                                                let _e1865 = phi_3651_;
                                                phi_3654_ = _e1865;
                                            }
                                            let _e1867 = phi_3654_;
                                            phi_3667_ = f32();
                                            phi_3668_ = bitcast<f32>((_e1820 | (_e1851 + select(0u, 1u, _e1867))));
                                        }
                                        let _e1880 = phi_3667_;
                                        let _e1882 = phi_3668_;
                                        phi_3673_ = _e1880;
                                        phi_3674_ = _e1882;
                                        phi_3675_ = _e1843;
                                    }
                                    let _e1886 = phi_3673_;
                                    let _e1888 = phi_3674_;
                                    let _e1890 = phi_3675_;
                                    phi_3683_ = select(_e1888, _e1886, _e1890);
                                }
                                let _e1894 = phi_3683_;
                                phi_3575_ = _e1894;
                            } else {
                                phi_3575_ = _e1817;
                            }
                            let _e1896 = phi_3575_;
                            phi_3576_ = _e1896;
                        }
                        let _e1898 = phi_3576_;
                        let _e1899 = bitcast<u32>(_e1898);
                        if ((_e1899 & 2147483647u) >= 2139095040u) {
                            phi_3588_ = bitcast<f32>(((_e1899 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3588_ = _e1898;
                        }
                        let _e1906 = phi_3588_;
                        phi_3593_ = type_18(_e1906, _e1788.member.member_1, _e1788.member.member_2, _e1788.member.member_3);
                    } else {
                        phi_3593_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1911 = phi_3593_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134] = _e1911;
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
