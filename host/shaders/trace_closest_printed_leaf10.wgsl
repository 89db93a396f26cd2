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

struct type_31 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_33 {
    member: array<type_22>,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_38 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_40 {
    member: array<type_38>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_45 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_51 {
    member: type_43,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_33;
@group(0) @binding(2) 
var<storage> global_4: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_20;
@group(0) @binding(3) 
var<storage> global_6: type_47;

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
    var phi_452_: i32;
    var phi_453_: i32;
    var phi_463_: bool;
    var phi_473_: u32;
    var phi_474_: u32;
    var phi_476_: bool;
    var phi_481_: u32;
    var phi_494_: i32;
    var phi_514_: i32;
    var phi_532_: f32;
    var phi_538_: f32;
    var phi_578_: f32;
    var phi_584_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_703_: f32;
    var phi_709_: f32;
    var phi_782_: f32;
    var phi_788_: f32;
    var phi_828_: f32;
    var phi_834_: f32;
    var phi_953_: i32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_1013_: i32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1044_: f32;
    var phi_1045_: f32;
    var phi_3752_: bool;
    var phi_1128_: type_29;
    var phi_1131_: bool;
    var phi_1133_: type_51;
    var phi_1135_: u32;
    var phi_1137_: u32;
    var phi_1148_: bool;
    var phi_1234_: bool;
    var phi_1235_: type_51;
    var phi_1236_: u32;
    var phi_2409_: type_38;
    var phi_3295_: type_51;
    var phi_3371_: type_51;
    var phi_3372_: type_51;
    var phi_3373_: u32;
    var phi_3375_: type_51;
    var phi_3376_: u32;
    var phi_3377_: bool;
    var phi_3384_: type_51;
    var phi_3389_: bool;
    var phi_3390_: type_51;
    var phi_1255_: type_29;
    var phi_1258_: type_4;
    var phi_1259_: type_4;
    var phi_1281_: type_4;
    var phi_1306_: u32;
    var phi_1322_: type_45;
    var phi_2117_: f32;
    var phi_2118_: f32;
    var phi_2119_: f32;
    var phi_2120_: f32;
    var phi_2121_: vec3<f32>;
    var phi_2122_: vec3<f32>;
    var phi_2123_: vec3<f32>;
    var phi_2124_: vec3<f32>;
    var phi_2315_: f32;
    var phi_2335_: type_31;
    var phi_2336_: type_31;
    var phi_2339_: type_31;
    var phi_2340_: type_31;
    var phi_2341_: bool;
    var phi_2345_: type_31;
    var phi_2354_: type_18;
    var phi_2379_: bool;
    var phi_2380_: bool;
    var phi_2386_: type_29;
    var phi_2387_: type_29;
    var phi_2388_: type_29;
    var phi_1256_: type_29;
    var phi_3746_: bool;
    var local_10: type_29;
    var phi_3921_: bool;
    var phi_3392_: type_29;
    var phi_3393_: bool;
    var phi_3394_: type_51;
    var phi_3395_: u32;
    var phi_3920_: bool;
    var phi_3396_: type_29;
    var phi_3397_: bool;
    var phi_3398_: type_51;
    var phi_3399_: u32;
    var phi_3400_: u32;
    var phi_3919_: bool;
    var phi_3401_: type_29;
    var phi_3402_: bool;
    var phi_3403_: type_51;
    var phi_3404_: u32;
    var phi_3405_: u32;
    var phi_3918_: bool;
    var phi_1129_: type_29;
    var phi_1132_: bool;
    var phi_1134_: type_51;
    var phi_1136_: u32;
    var phi_1138_: u32;
    var phi_3406_: bool;
    var phi_3917_: bool;
    var local_11: type_29;
    var phi_3444_: f32;
    var phi_3446_: f32;
    var phi_3447_: bool;
    var phi_3448_: f32;
    var phi_3449_: bool;
    var phi_3666_: u32;
    var phi_3684_: bool;
    var phi_3687_: bool;
    var phi_3700_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3707_: f32;
    var phi_3708_: bool;
    var phi_3716_: f32;
    var phi_3464_: f32;
    var phi_3465_: f32;
    var phi_3477_: f32;
    var phi_3482_: type_18;
    var local_12: type_29;

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
                            phi_452_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_452_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_452_;
                        phi_453_ = _e227;
                    } else {
                        phi_453_ = 0i;
                    }
                    let _e229 = phi_453_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_463_ = true;
                    } else {
                        phi_463_ = (_e153 == _e185);
                    }
                    let _e233 = phi_463_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_473_ = _e235;
                        phi_474_ = _e235;
                        phi_476_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_473_ = u32();
                        phi_474_ = 0u;
                        phi_476_ = true;
                    }
                    let _e239 = phi_473_;
                    let _e241 = phi_474_;
                    let _e243 = phi_476_;
                    if _e243 {
                        phi_481_ = (_e241 + 1u);
                    } else {
                        phi_481_ = 0u;
                    }
                    let _e247 = phi_481_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    if (_e124 < -126i) {
                        phi_494_ = -126i;
                    } else {
                        phi_494_ = select(_e124, 127i, (_e124 > 127i));
                    }
                    let _e254 = phi_494_;
                    let _e259 = bitcast<f32>((bitcast<u32>((_e254 + 127i)) << bitcast<u32>(23i)));
                    let _e265 = bitcast<f32>((bitcast<u32>(((_e124 - _e254) + 127i)) << bitcast<u32>(23i)));
                    let _e266 = -(_e229);
                    if (_e266 < -126i) {
                        phi_514_ = -126i;
                    } else {
                        phi_514_ = select(_e266, 127i, (_e266 > 127i));
                    }
                    let _e271 = phi_514_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e266 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = global_3.member[_e134].member;
                    let _e287 = (_e248 == 0u);
                    if _e287 {
                        phi_532_ = _e286[0];
                    } else {
                        phi_532_ = _e286[1];
                    }
                    let _e291 = phi_532_;
                    let _e292 = (_e248 == 2u);
                    if _e292 {
                        phi_538_ = _e286[2];
                    } else {
                        phi_538_ = _e291;
                    }
                    let _e295 = phi_538_;
                    let _e296 = bitcast<u32>(_e295);
                    let _e298 = ((_e296 & 2139095040u) != 0u);
                    let _e312 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e296 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e296 & 2147483648u))), _e295, _e298) * _e259) * select(0.00000011920929f, 1f, _e298)) * _e265);
                    let _e313 = global_3.member[_e134].member_2;
                    if _e287 {
                        phi_578_ = _e313[0];
                    } else {
                        phi_578_ = _e313[1];
                    }
                    let _e317 = phi_578_;
                    if _e292 {
                        phi_584_ = _e313[2];
                    } else {
                        phi_584_ = _e317;
                    }
                    let _e320 = phi_584_;
                    let _e321 = bitcast<u32>(_e320);
                    let _e323 = ((_e321 & 2139095040u) != 0u);
                    let _e337 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e321 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e321 & 2147483648u))), _e320, _e323) * _e276) * select(0.00000011920929f, 1f, _e323)) * _e282);
                    let _e341 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e344 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e345 = (_e344 * 0.00000011920929f);
                    let _e348 = select(select(0.00000000000011368684f, _e345, (_e345 > 0.00000000000011368684f)), 0f, _e341);
                    let _e349 = select(0f, _e337, _e341);
                    let _e350 = (_e312 + _e348);
                    let _e351 = (_e312 - _e348);
                    let _e353 = select(38685626000000000000000000f, (1f / _e337), _e341);
                    let _e354 = (_e247 == 0u);
                    if _e354 {
                        phi_657_ = _e286[0];
                    } else {
                        phi_657_ = _e286[1];
                    }
                    let _e358 = phi_657_;
                    let _e359 = (_e247 == 2u);
                    if _e359 {
                        phi_663_ = _e286[2];
                    } else {
                        phi_663_ = _e358;
                    }
                    let _e362 = phi_663_;
                    let _e363 = bitcast<u32>(_e362);
                    let _e365 = ((_e363 & 2139095040u) != 0u);
                    let _e379 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e362, _e365) * _e259) * select(0.00000011920929f, 1f, _e365)) * _e265);
                    if _e354 {
                        phi_703_ = _e313[0];
                    } else {
                        phi_703_ = _e313[1];
                    }
                    let _e383 = phi_703_;
                    if _e359 {
                        phi_709_ = _e313[2];
                    } else {
                        phi_709_ = _e383;
                    }
                    let _e386 = phi_709_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e276) * select(0.00000011920929f, 1f, _e389)) * _e282);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e410 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e411 = (_e410 * 0.00000011920929f);
                    let _e414 = select(select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f)), 0f, _e407);
                    let _e415 = select(0f, _e403, _e407);
                    let _e416 = (_e379 + _e414);
                    let _e417 = (_e379 - _e414);
                    let _e419 = select(38685626000000000000000000f, (1f / _e403), _e407);
                    let _e420 = (_e249 == 0u);
                    if _e420 {
                        phi_782_ = _e286[0];
                    } else {
                        phi_782_ = _e286[1];
                    }
                    let _e424 = phi_782_;
                    let _e425 = (_e249 == 2u);
                    if _e425 {
                        phi_788_ = _e286[2];
                    } else {
                        phi_788_ = _e424;
                    }
                    let _e428 = phi_788_;
                    let _e429 = bitcast<u32>(_e428);
                    let _e431 = ((_e429 & 2139095040u) != 0u);
                    let _e445 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e429 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e429 & 2147483648u))), _e428, _e431) * _e259) * select(0.00000011920929f, 1f, _e431)) * _e265);
                    if _e420 {
                        phi_828_ = _e313[0];
                    } else {
                        phi_828_ = _e313[1];
                    }
                    let _e449 = phi_828_;
                    if _e425 {
                        phi_834_ = _e313[2];
                    } else {
                        phi_834_ = _e449;
                    }
                    let _e452 = phi_834_;
                    let _e453 = bitcast<u32>(_e452);
                    let _e455 = ((_e453 & 2139095040u) != 0u);
                    let _e469 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e453 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e453 & 2147483648u))), _e452, _e455) * _e276) * select(0.00000011920929f, 1f, _e455)) * _e282);
                    let _e473 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e476 = bitcast<f32>((bitcast<u32>(_e445) & 2147483647u));
                    let _e477 = (_e476 * 0.00000011920929f);
                    let _e480 = select(select(0.00000000000011368684f, _e477, (_e477 > 0.00000000000011368684f)), 0f, _e473);
                    let _e481 = select(0f, _e469, _e473);
                    let _e482 = (_e445 + _e480);
                    let _e483 = (_e445 - _e480);
                    let _e485 = select(38685626000000000000000000f, (1f / _e469), _e473);
                    let _e487 = select(_e410, _e344, (_e344 > _e410));
                    let _e490 = (_e124 + _e229);
                    if (_e210 && (select(_e476, _e487, (_e487 > _e476)) <= 1099511600000f)) {
                        let _e500 = ((_e197 & 8388607u) | (select(0u, 1u, ((_e197 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e503 = bitcast<i32>((_e197 >> bitcast<u32>(23i)));
                        let _e507 = (_e500 == 0u);
                        let _e510 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e500)), 32u, _e507)) - 8i);
                        if (_e503 == 255i) {
                            phi_953_ = 255i;
                        } else {
                            phi_953_ = (((_e503 + select(0i, 1i, (_e503 == 0i))) - _e510) + _e490);
                        }
                        let _e518 = phi_953_;
                        let _e528 = (_e518 <= 0i);
                        if _e528 {
                            phi_976_ = u32();
                        } else {
                            if _e507 {
                                phi_975_ = u32();
                            } else {
                                phi_975_ = select(((bitcast<u32>(_e518) << bitcast<u32>(23i)) | ((_e500 << bitcast<u32>(((_e510 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e518 >= 255i));
                            }
                            let _e532 = phi_975_;
                            phi_976_ = _e532;
                        }
                        let _e534 = phi_976_;
                        let _e546 = ((_e206 & 8388607u) | (select(0u, 1u, ((_e206 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e549 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
                        let _e553 = (_e546 == 0u);
                        let _e556 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e546)), 32u, _e553)) - 8i);
                        if (_e549 == 255i) {
                            phi_1013_ = 255i;
                        } else {
                            phi_1013_ = (((_e549 + select(0i, 1i, (_e549 == 0i))) - _e556) + _e490);
                        }
                        let _e564 = phi_1013_;
                        let _e574 = (_e564 <= 0i);
                        if _e574 {
                            phi_1036_ = u32();
                        } else {
                            if _e553 {
                                phi_1035_ = u32();
                            } else {
                                phi_1035_ = select(((bitcast<u32>(_e564) << bitcast<u32>(23i)) | ((_e546 << bitcast<u32>(((_e556 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e564 >= 255i));
                            }
                            let _e578 = phi_1035_;
                            phi_1036_ = _e578;
                        }
                        let _e580 = phi_1036_;
                        phi_1044_ = bitcast<f32>(((_e205 & 2147483648u) | select(_e580, 0u, select(_e553, true, _e574))));
                        phi_1045_ = bitcast<f32>(((_e196 & 2147483648u) | select(_e534, 0u, select(_e507, true, _e528))));
                    } else {
                        phi_1044_ = 0f;
                        phi_1045_ = 1f;
                    }
                    let _e586 = phi_1044_;
                    let _e588 = phi_1045_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e595 = (_e248 % 3u);
                    let _e596 = (_e595 < 3u);
                    if _e596 {
                    } else {
                        break;
                    }
                    let _e598 = local_9[_e595];
                    let _e599 = (_e247 % 3u);
                    let _e600 = (_e599 < 3u);
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e602 = local_9[_e599];
                    let _e603 = (_e249 % 3u);
                    let _e604 = (_e603 < 3u);
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e606 = local_9[_e603];
                    local_8 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e596 {
                    } else {
                        break;
                    }
                    let _e610 = local_8[_e595];
                    if _e600 {
                    } else {
                        break;
                    }
                    let _e612 = local_8[_e599];
                    if _e604 {
                    } else {
                        break;
                    }
                    let _e614 = local_8[_e603];
                    phi_3752_ = false;
                    phi_1128_ = type_29(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e586);
                    phi_1131_ = (_e588 <= _e586);
                    phi_1133_ = type_51(type_43(array<f32, 3>(_e598, _e602, _e606), array<f32, 3>(_e610, _e612, _e614)), select(0u, 2147483648u, (_e85 == 0u)));
                    phi_1135_ = 0u;
                    phi_1137_ = ((3u * _e85) + 1u);
                    loop {
                        let _e620 = phi_3752_;
                        let _e622 = phi_1128_;
                        let _e624 = phi_1131_;
                        let _e626 = phi_1133_;
                        let _e628 = phi_1135_;
                        let _e630 = phi_1137_;
                        local_11 = _e622;
                        if _e624 {
                            phi_1148_ = true;
                        } else {
                            phi_1148_ = (_e628 > 0u);
                        }
                        let _e633 = phi_1148_;
                        if _e633 {
                            let _e634 = (_e630 > 0u);
                            if _e634 {
                                if _e624 {
                                    phi_1234_ = _e624;
                                    phi_1235_ = _e626;
                                    phi_1236_ = _e628;
                                } else {
                                    let _e635 = (_e628 - 1u);
                                    let _e636 = (_e635 % 128u);
                                    let _e637 = (_e636 < 128u);
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e639 = local_6[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e641 = local_5[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e643 = local_4[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e645 = local_3[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e648 = local_2[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e650 = local_1[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e652 = local[_e636];
                                    if _e637 {
                                    } else {
                                        phi_3917_ = true;
                                        break;
                                    }
                                    let _e657 = local_7[_e636];
                                    phi_1234_ = (_e657 <= _e622.member_1);
                                    phi_1235_ = type_51(type_43(array<f32, 3>(_e641, _e643, _e645), array<f32, 3>(_e648, _e650, _e652)), _e639);
                                    phi_1236_ = _e635;
                                }
                                let _e661 = phi_1234_;
                                let _e663 = phi_1235_;
                                let _e665 = phi_1236_;
                                if _e661 {
                                    if ((_e663.member_1 & 2147483648u) != 0u) {
                                        phi_1255_ = _e622;
                                        phi_1258_ = type_4(0u, ((_e663.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1041 = phi_1255_;
                                            let _e1043 = phi_1258_;
                                            local_10 = _e1041;
                                            local_12 = _e1041;
                                            if (_e1043.member < _e1043.member_1) {
                                                phi_1259_ = type_4((_e1043.member + 1u), _e1043.member_1);
                                                phi_1281_ = type_4(1u, _e1043.member);
                                            } else {
                                                phi_1259_ = _e1043;
                                                phi_1281_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1056 = phi_1259_;
                                            let _e1058 = phi_1281_;
                                            let _e1062 = (bitcast<i32>(_e1058.member) != 0i);
                                            if _e1062 {
                                                let _e1063 = ((_e663.member_1 & 268435455u) + _e1058.member_1);
                                                let _e1064 = (_e1063 < arrayLength((&global_6.member)));
                                                if _e1064 {
                                                    if _e1064 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1067 = global_6.member[_e1063].member_1;
                                                    phi_1306_ = _e1067;
                                                } else {
                                                    phi_1306_ = 4294967295u;
                                                }
                                                let _e1069 = phi_1306_;
                                                if _e1064 {
                                                    if _e1064 {
                                                    } else {
                                                        phi_3746_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_6.member[_e1063];
                                                    phi_1322_ = _e1071;
                                                } else {
                                                    phi_1322_ = type_45(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e1073 = phi_1322_;
                                                let _e1085 = ((10u * _e248) & 31u);
                                                let _e1088 = ((_e1073.member[0] >> bitcast<u32>(_e1085)) & 1023u);
                                                let _e1096 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e120));
                                                let _e1101 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1088)) - 8388608f) * _e1096)) ^ _e120)));
                                                let _e1105 = select(select(_e663.member.member_1[0], _e1101, (_e1101 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1088 == 1023u));
                                                let _e1107 = ((10u * _e247) & 31u);
                                                let _e1110 = ((_e1073.member[0] >> bitcast<u32>(_e1107)) & 1023u);
                                                let _e1118 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e120));
                                                let _e1123 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1110)) - 8388608f) * _e1118)) ^ _e120)));
                                                let _e1127 = select(select(_e663.member.member_1[1], _e1123, (_e1123 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1110 == 1023u));
                                                let _e1129 = ((10u * _e249) & 31u);
                                                let _e1132 = ((_e1073.member[0] >> bitcast<u32>(_e1129)) & 1023u);
                                                let _e1140 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e120));
                                                let _e1145 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1132)) - 8388608f) * _e1140)) ^ _e120)));
                                                let _e1149 = select(select(_e663.member.member_1[2], _e1145, (_e1145 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1132 == 1023u));
                                                let _e1153 = ((_e1073.member[1] >> bitcast<u32>(_e1085)) & 1023u);
                                                let _e1161 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1153)) - 8388608f) * _e1096)) ^ _e120)));
                                                let _e1165 = select(select(_e663.member.member_1[0], _e1161, (_e1161 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1153 == 1023u));
                                                let _e1168 = ((_e1073.member[1] >> bitcast<u32>(_e1107)) & 1023u);
                                                let _e1176 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1168)) - 8388608f) * _e1118)) ^ _e120)));
                                                let _e1180 = select(select(_e663.member.member_1[1], _e1176, (_e1176 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1168 == 1023u));
                                                let _e1183 = ((_e1073.member[1] >> bitcast<u32>(_e1129)) & 1023u);
                                                let _e1191 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1183)) - 8388608f) * _e1140)) ^ _e120)));
                                                let _e1195 = select(select(_e663.member.member_1[2], _e1191, (_e1191 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1183 == 1023u));
                                                let _e1199 = ((_e1073.member[2] >> bitcast<u32>(_e1085)) & 1023u);
                                                let _e1207 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1199)) - 8388608f) * _e1096)) ^ _e120)));
                                                let _e1211 = select(select(_e663.member.member_1[0], _e1207, (_e1207 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e1199 == 1023u));
                                                let _e1214 = ((_e1073.member[2] >> bitcast<u32>(_e1107)) & 1023u);
                                                let _e1222 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1214)) - 8388608f) * _e1118)) ^ _e120)));
                                                let _e1226 = select(select(_e663.member.member_1[1], _e1222, (_e1222 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e1214 == 1023u));
                                                let _e1229 = ((_e1073.member[2] >> bitcast<u32>(_e1129)) & 1023u);
                                                let _e1237 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1229)) - 8388608f) * _e1140)) ^ _e120)));
                                                let _e1241 = select(select(_e663.member.member_1[2], _e1237, (_e1237 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e1229 == 1023u));
                                                let _e1245 = (_e1149 - _e445);
                                                let _e1248 = (((_e1105 - _e312) * _e481) - (_e1245 * _e349));
                                                let _e1251 = (((_e1127 - _e379) * _e481) - (_e1245 * _e415));
                                                let _e1254 = (_e1195 - _e445);
                                                let _e1257 = (((_e1165 - _e312) * _e481) - (_e1254 * _e349));
                                                let _e1260 = (((_e1180 - _e379) * _e481) - (_e1254 * _e415));
                                                let _e1263 = (_e1241 - _e445);
                                                let _e1266 = (((_e1211 - _e312) * _e481) - (_e1263 * _e349));
                                                let _e1269 = (((_e1226 - _e379) * _e481) - (_e1263 * _e415));
                                                let _e1270 = (_e1266 * _e1260);
                                                let _e1271 = (_e1269 * _e1257);
                                                let _e1272 = (_e1248 * _e1269);
                                                let _e1273 = (_e1251 * _e1266);
                                                let _e1274 = (_e1257 * _e1251);
                                                let _e1275 = (_e1260 * _e1248);
                                                let _e1280 = (((_e1270 >= _e1271) && (_e1272 >= _e1273)) && (_e1274 >= _e1275));
                                                let _e1286 = (_e1280 || (((_e1270 <= _e1271) && (_e1272 <= _e1273)) && (_e1274 <= _e1275)));
                                                if _e1286 {
                                                    let _e1288 = select(-1f, 1f, _e1280);
                                                    let _e1290 = ((_e1270 - _e1271) * _e1288);
                                                    let _e1292 = select(0f, _e1290, (_e1290 > 0f));
                                                    let _e1294 = ((_e1272 - _e1273) * _e1288);
                                                    let _e1296 = select(0f, _e1294, (_e1294 > 0f));
                                                    let _e1298 = ((_e1274 - _e1275) * _e1288);
                                                    let _e1300 = select(0f, _e1298, (_e1298 > 0f));
                                                    let _e1302 = ((_e1292 + _e1296) + _e1300);
                                                    let _e1304 = select(_e1165, _e1105, (_e1105 < _e1165));
                                                    let _e1308 = select(_e1165, _e1105, (_e1105 > _e1165));
                                                    let _e1312 = select(_e1180, _e1127, (_e1127 < _e1180));
                                                    let _e1316 = select(_e1180, _e1127, (_e1127 > _e1180));
                                                    let _e1320 = select(_e1195, _e1149, (_e1149 < _e1195));
                                                    let _e1324 = select(_e1195, _e1149, (_e1149 > _e1195));
                                                    let _e1329 = ((select(_e1211, _e1304, (_e1304 < _e1211)) - _e350) * _e353);
                                                    let _e1330 = ((select(_e1211, _e1308, (_e1308 > _e1211)) - _e351) * _e353);
                                                    let _e1333 = ((select(_e1226, _e1312, (_e1312 < _e1226)) - _e416) * _e419);
                                                    let _e1334 = ((select(_e1226, _e1316, (_e1316 > _e1226)) - _e417) * _e419);
                                                    let _e1337 = ((select(_e1241, _e1320, (_e1320 < _e1241)) - _e482) * _e485);
                                                    let _e1338 = ((select(_e1241, _e1324, (_e1324 > _e1241)) - _e483) * _e485);
                                                    let _e1340 = select(_e1338, _e1337, (_e1337 < _e1338));
                                                    let _e1342 = select(_e1338, _e1337, (_e1337 > _e1338));
                                                    let _e1344 = select(_e1330, _e1329, (_e1329 < _e1330));
                                                    let _e1346 = select(_e1334, _e1333, (_e1333 < _e1334));
                                                    let _e1348 = select(_e1346, _e1344, (_e1344 > _e1346));
                                                    let _e1350 = select(_e1340, _e1348, (_e1348 > _e1340));
                                                    let _e1352 = select(_e1330, _e1329, (_e1329 > _e1330));
                                                    let _e1354 = select(_e1334, _e1333, (_e1333 > _e1334));
                                                    let _e1356 = select(_e1354, _e1352, (_e1352 < _e1354));
                                                    let _e1358 = select(_e1342, _e1356, (_e1356 < _e1342));
                                                    let _e1359 = -(_e1340);
                                                    let _e1365 = select(_e588, _e1350, (_e1350 > _e588));
                                                    let _e1369 = select(_e1257, _e1248, (_e1248 < _e1257));
                                                    let _e1374 = select(_e1257, _e1248, (_e1248 > _e1257));
                                                    let _e1381 = select(_e1260, _e1251, (_e1251 < _e1260));
                                                    let _e1386 = select(_e1260, _e1251, (_e1251 > _e1260));
                                                    let _e1395 = (((((_e1286 && (_e1302 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1266, _e1369, (_e1369 < _e1266)) <= 0f) && (select(_e1266, _e1374, (_e1374 > _e1266)) >= 0f))) && ((select(_e1269, _e1381, (_e1381 < _e1269)) <= 0f) && (select(_e1269, _e1386, (_e1386 > _e1269)) >= 0f))) && (_e1365 <= (_e1358 + (select(_e1359, _e1342, (_e1342 > _e1359)) * 0.0000019073523f)))) && (_e1365 <= _e1041.member_1));
                                                    if _e1395 {
                                                        let _e1400 = (_e1165 - _e1105);
                                                        let _e1401 = (_e1180 - _e1127);
                                                        let _e1402 = (_e1195 - _e1149);
                                                        let _e1403 = vec3<f32>(_e1400, _e1401, _e1402);
                                                        let _e1404 = (_e1211 - _e1165);
                                                        let _e1405 = (_e1226 - _e1180);
                                                        let _e1406 = (_e1241 - _e1195);
                                                        let _e1407 = vec3<f32>(_e1404, _e1405, _e1406);
                                                        let _e1408 = (_e1105 - _e1211);
                                                        let _e1409 = (_e1127 - _e1226);
                                                        let _e1410 = (_e1149 - _e1241);
                                                        let _e1411 = vec3<f32>(_e1408, _e1409, _e1410);
                                                        let _e1414 = bitcast<f32>((bitcast<u32>(_e1400) & 2147483647u));
                                                        let _e1417 = bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u));
                                                        let _e1419 = select(_e1417, _e1414, (_e1414 > _e1417));
                                                        let _e1422 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                        let _e1424 = select(_e1422, _e1419, (_e1419 > _e1422));
                                                        let _e1427 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                        let _e1430 = bitcast<f32>((bitcast<u32>(_e1405) & 2147483647u));
                                                        let _e1432 = select(_e1430, _e1427, (_e1427 > _e1430));
                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1406) & 2147483647u));
                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1443 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                        let _e1445 = select(_e1443, _e1440, (_e1440 > _e1443));
                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1410) & 2147483647u));
                                                        let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                        let _e1452 = select(_e1437, _e1424, (_e1424 > _e1437));
                                                        let _e1454 = select(_e1450, _e1452, (_e1452 > _e1450));
                                                        if (_e1424 == _e1454) {
                                                            phi_2117_ = _e1260;
                                                            phi_2118_ = _e1257;
                                                            phi_2119_ = _e1251;
                                                            phi_2120_ = _e1248;
                                                            phi_2121_ = vec3<f32>(_e1105, _e1127, _e1149);
                                                            phi_2122_ = _e1411;
                                                            phi_2123_ = _e1407;
                                                            phi_2124_ = _e1403;
                                                        } else {
                                                            let _e1456 = (_e1437 == _e1454);
                                                            let _e1461 = vec3(_e1456);
                                                            phi_2117_ = select(_e1251, _e1269, _e1456);
                                                            phi_2118_ = select(_e1248, _e1266, _e1456);
                                                            phi_2119_ = select(_e1269, _e1260, _e1456);
                                                            phi_2120_ = select(_e1266, _e1257, _e1456);
                                                            phi_2121_ = select(vec3<f32>(_e1211, _e1226, _e1241), vec3<f32>(_e1165, _e1180, _e1195), _e1461);
                                                            phi_2122_ = select(_e1407, _e1403, _e1461);
                                                            phi_2123_ = select(_e1403, _e1411, _e1461);
                                                            phi_2124_ = select(_e1411, _e1407, _e1461);
                                                        }
                                                        let _e1467 = phi_2117_;
                                                        let _e1469 = phi_2118_;
                                                        let _e1471 = phi_2119_;
                                                        let _e1473 = phi_2120_;
                                                        let _e1475 = phi_2121_;
                                                        let _e1477 = phi_2122_;
                                                        let _e1479 = phi_2123_;
                                                        let _e1481 = phi_2124_;
                                                        let _e1488 = ((_e1479.y * _e1477.z) - (_e1477.y * _e1479.z));
                                                        let _e1493 = ((_e1479.z * _e1477.x) - (_e1477.z * _e1479.x));
                                                        let _e1496 = ((_e1479.x * _e1477.y) - (_e1477.x * _e1479.y));
                                                        let _e1499 = ((_e1292 >= _e1296) && (_e1292 >= _e1300));
                                                        let _e1500 = (_e1296 >= _e1300);
                                                        let _e1514 = (((_e1488 * (select(select(_e1211, _e1165, _e1500), _e1105, _e1499) - _e312)) + (_e1493 * (select(select(_e1226, _e1180, _e1500), _e1127, _e1499) - _e379))) + (_e1496 * (select(select(_e1241, _e1195, _e1500), _e1149, _e1499) - _e445)));
                                                        let _e1519 = (((_e1488 * _e349) + (_e1493 * _e415)) + (_e1496 * _e481));
                                                        let _e1520 = (_e1469 - _e1473);
                                                        let _e1521 = (_e1467 - _e1471);
                                                        let _e1524 = ((_e1520 * _e1520) + (_e1521 * _e1521));
                                                        let _e1531 = (-(((_e1473 * _e1520) + (_e1471 * _e1521))) / select(0.000000000000000000000000000000000000011754944f, _e1524, (_e1524 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1533 = select(1f, _e1531, (_e1531 < 1f));
                                                        let _e1535 = select(0f, _e1533, (_e1533 > 0f));
                                                        let _e1544 = ((_e1475.x + (_e1481.x * _e1535)) - _e312);
                                                        let _e1547 = ((_e1475.y + (_e1481.y * _e1535)) - _e379);
                                                        let _e1550 = ((_e1475.z + (_e1481.z * _e1535)) - _e445);
                                                        let _e1553 = bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u));
                                                        let _e1556 = bitcast<f32>((bitcast<u32>(_e1547) & 2147483647u));
                                                        let _e1558 = select(_e1556, _e1553, (_e1553 > _e1556));
                                                        let _e1561 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                        let _e1563 = select(_e1561, _e1558, (_e1558 > _e1561));
                                                        let _e1569 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                        let _e1572 = bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u));
                                                        let _e1574 = select(_e1572, _e1569, (_e1569 > _e1572));
                                                        let _e1577 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                        let _e1596 = bitcast<f32>((bitcast<u32>(_e1479.x) & 2147483647u));
                                                        let _e1599 = bitcast<f32>((bitcast<u32>(_e1479.y) & 2147483647u));
                                                        let _e1601 = select(_e1599, _e1596, (_e1596 > _e1599));
                                                        let _e1604 = bitcast<f32>((bitcast<u32>(_e1479.z) & 2147483647u));
                                                        let _e1610 = bitcast<f32>((bitcast<u32>(_e1477.x) & 2147483647u));
                                                        let _e1613 = bitcast<f32>((bitcast<u32>(_e1477.y) & 2147483647u));
                                                        let _e1615 = select(_e1613, _e1610, (_e1610 > _e1613));
                                                        let _e1618 = bitcast<f32>((bitcast<u32>(_e1477.z) & 2147483647u));
                                                        let _e1624 = ((bitcast<f32>((bitcast<u32>(((((_e1488 * _e1544) + (_e1493 * _e1547)) + (_e1496 * _e1550)) - _e1514)) & 2147483647u)) <= ((0.0000009536743f * select(_e1454, _e1563, (_e1563 > _e1454))) * select(_e1577, _e1574, (_e1574 > _e1577)))) && !((bitcast<f32>((bitcast<u32>(_e1519) & 2147483647u)) <= ((0.0000038146973f * select(_e1604, _e1601, (_e1601 > _e1604))) * select(_e1618, _e1615, (_e1615 > _e1618))))));
                                                        let _e1625 = (_e1514 / _e1519);
                                                        if (_e1395 && !(_e1624)) {
                                                            let _e1628 = (_e1550 / _e481);
                                                            let _e1636 = (((_e1488 * (_e1544 - (_e349 * _e1628))) + (_e1493 * (_e1547 - (_e415 * _e1628)))) / _e1519);
                                                            phi_2315_ = select(select(_e1628, (_e1628 + _e1636), (bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u)) <= _e1454)), _e1625, _e1624);
                                                        } else {
                                                            phi_2315_ = _e1625;
                                                        }
                                                        let _e1645 = phi_2315_;
                                                        let _e1647 = select(_e1358, _e1645, (_e1645 < _e1358));
                                                        let _e1649 = select(_e1350, _e1647, (_e1647 > _e1350));
                                                        let _e1650 = (1f / _e1302);
                                                        phi_2335_ = type_31(_e1649, (_e1296 * _e1650), (_e1300 * _e1650), ((_e1395 && (_e1649 >= _e588)) && (_e1649 <= _e1041.member_1)));
                                                        phi_2336_ = type_31();
                                                    } else {
                                                        phi_2335_ = type_31();
                                                        phi_2336_ = type_31(0f, 0f, 0f, _e1395);
                                                    }
                                                    let _e1659 = phi_2335_;
                                                    let _e1661 = phi_2336_;
                                                    phi_2339_ = _e1659;
                                                    phi_2340_ = _e1661;
                                                    phi_2341_ = select(true, false, _e1395);
                                                } else {
                                                    phi_2339_ = type_31();
                                                    phi_2340_ = type_31(0f, 0f, 0f, _e1286);
                                                    phi_2341_ = true;
                                                }
                                                let _e1664 = phi_2339_;
                                                let _e1666 = phi_2340_;
                                                let _e1668 = phi_2341_;
                                                if _e1668 {
                                                    phi_2345_ = _e1666;
                                                } else {
                                                    phi_2345_ = _e1664;
                                                }
                                                let _e1670 = phi_2345_;
                                                if _e1670.member_3 {
                                                    phi_2354_ = type_18(_e1670.member, _e1670.member_1, _e1670.member_2, _e1069);
                                                } else {
                                                    phi_2354_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1677 = phi_2354_;
                                                if (_e1677.member_3 != 4294967295u) {
                                                    if (_e1069 != 4294967295u) {
                                                        if (_e1677.member < _e1041.member.member) {
                                                            phi_2380_ = true;
                                                        } else {
                                                            if (_e1677.member == _e1041.member.member) {
                                                                phi_2379_ = (_e1677.member_3 < _e1041.member.member_3);
                                                            } else {
                                                                phi_2379_ = false;
                                                            }
                                                            let _e1690 = phi_2379_;
                                                            phi_2380_ = _e1690;
                                                        }
                                                        let _e1692 = phi_2380_;
                                                        if _e1692 {
                                                            phi_2386_ = type_29(_e1677, _e1677.member);
                                                        } else {
                                                            phi_2386_ = _e1041;
                                                        }
                                                        let _e1695 = phi_2386_;
                                                        phi_2387_ = _e1695;
                                                    } else {
                                                        phi_2387_ = _e1041;
                                                    }
                                                    let _e1697 = phi_2387_;
                                                    phi_2388_ = _e1697;
                                                } else {
                                                    phi_2388_ = _e1041;
                                                }
                                                let _e1699 = phi_2388_;
                                                phi_1256_ = _e1699;
                                            } else {
                                                phi_1256_ = type_29();
                                            }
                                            let _e1701 = phi_1256_;
                                            continue;
                                            continuing {
                                                phi_1255_ = _e1701;
                                                phi_1258_ = _e1056;
                                                phi_3746_ = _e620;
                                                break if !(_e1062);
                                            }
                                        }
                                        let _e1704 = phi_3746_;
                                        phi_3917_ = _e1704;
                                        if _e1704 {
                                            break;
                                        }
                                        let _e1706 = local_10;
                                        phi_3921_ = _e1704;
                                        let _e1971 = local_12;
                                        phi_3392_ = _e1971;
                                        phi_3393_ = false;
                                        phi_3394_ = _e663;
                                        phi_3395_ = select(_e665, 0u, (_e588 > _e1706.member_1));
                                    } else {
                                        let _e675 = (_e663.member_1 < _e85);
                                        if _e675 {
                                            if _e675 {
                                            } else {
                                                phi_3917_ = true;
                                                break;
                                            }
                                            let _e677 = global_4.member[_e663.member_1];
                                            phi_2409_ = _e677;
                                        } else {
                                            phi_2409_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e679 = phi_2409_;
                                        let _e694 = ((10u * _e248) & 31u);
                                        let _e697 = ((_e679.member[0] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e705 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[0] - _e663.member.member[0]) * 0.0009775171f)) ^ _e120));
                                        let _e710 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e697)) - 8388608f) * _e705)) ^ _e120)));
                                        let _e714 = select(select(_e663.member.member_1[0], _e710, (_e710 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e697 == 1023u));
                                        let _e716 = ((10u * _e247) & 31u);
                                        let _e719 = ((_e679.member[0] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e727 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[1] - _e663.member.member[1]) * 0.0009775171f)) ^ _e120));
                                        let _e732 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e719)) - 8388608f) * _e727)) ^ _e120)));
                                        let _e736 = select(select(_e663.member.member_1[1], _e732, (_e732 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e719 == 1023u));
                                        let _e738 = ((10u * _e249) & 31u);
                                        let _e741 = ((_e679.member[0] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e749 = bitcast<f32>((bitcast<u32>(((_e663.member.member_1[2] - _e663.member.member[2]) * 0.0009775171f)) ^ _e120));
                                        let _e754 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e741)) - 8388608f) * _e749)) ^ _e120)));
                                        let _e758 = select(select(_e663.member.member_1[2], _e754, (_e754 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e741 == 1023u));
                                        let _e761 = ((_e679.member[1] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e769 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e761)) - 8388608f) * _e705)) ^ _e120)));
                                        let _e773 = select(select(_e663.member.member_1[0], _e769, (_e769 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e761 == 1023u));
                                        let _e776 = ((_e679.member[1] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e784 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e776)) - 8388608f) * _e727)) ^ _e120)));
                                        let _e788 = select(select(_e663.member.member_1[1], _e784, (_e784 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e776 == 1023u));
                                        let _e791 = ((_e679.member[1] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e799 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e791)) - 8388608f) * _e749)) ^ _e120)));
                                        let _e803 = select(select(_e663.member.member_1[2], _e799, (_e799 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e791 == 1023u));
                                        let _e809 = ((_e679.member_1[0] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e817 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e809)) - 8388608f) * _e705)) ^ _e120)));
                                        let _e821 = select(select(_e663.member.member_1[0], _e817, (_e817 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e809 == 1023u));
                                        let _e824 = ((_e679.member_1[0] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e832 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e824)) - 8388608f) * _e727)) ^ _e120)));
                                        let _e836 = select(select(_e663.member.member_1[1], _e832, (_e832 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e824 == 1023u));
                                        let _e839 = ((_e679.member_1[0] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e847 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e839)) - 8388608f) * _e749)) ^ _e120)));
                                        let _e851 = select(select(_e663.member.member_1[2], _e847, (_e847 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e839 == 1023u));
                                        let _e854 = ((_e679.member_1[1] >> bitcast<u32>(_e694)) & 1023u);
                                        let _e862 = (_e663.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e854)) - 8388608f) * _e705)) ^ _e120)));
                                        let _e866 = select(select(_e663.member.member_1[0], _e862, (_e862 < _e663.member.member_1[0])), _e663.member.member_1[0], (_e854 == 1023u));
                                        let _e869 = ((_e679.member_1[1] >> bitcast<u32>(_e716)) & 1023u);
                                        let _e877 = (_e663.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e869)) - 8388608f) * _e727)) ^ _e120)));
                                        let _e881 = select(select(_e663.member.member_1[1], _e877, (_e877 < _e663.member.member_1[1])), _e663.member.member_1[1], (_e869 == 1023u));
                                        let _e884 = ((_e679.member_1[1] >> bitcast<u32>(_e738)) & 1023u);
                                        let _e892 = (_e663.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e884)) - 8388608f) * _e749)) ^ _e120)));
                                        let _e896 = select(select(_e663.member.member_1[2], _e892, (_e892 < _e663.member.member_1[2])), _e663.member.member_1[2], (_e884 == 1023u));
                                        let _e901 = type_51(type_43(array<f32, 3>(_e714, _e736, _e758), array<f32, 3>(_e773, _e788, _e803)), _e679.member_2);
                                        let _e906 = type_51(type_43(array<f32, 3>(_e821, _e836, _e851), array<f32, 3>(_e866, _e881, _e896)), _e679.member_3);
                                        let _e912 = ((_e714 - _e350) * _e353);
                                        let _e913 = ((_e821 - _e350) * _e353);
                                        let _e914 = ((_e773 - _e351) * _e353);
                                        let _e915 = ((_e866 - _e351) * _e353);
                                        let _e920 = ((_e736 - _e416) * _e419);
                                        let _e921 = ((_e836 - _e416) * _e419);
                                        let _e922 = ((_e788 - _e417) * _e419);
                                        let _e923 = ((_e881 - _e417) * _e419);
                                        let _e928 = ((_e758 - _e482) * _e485);
                                        let _e929 = ((_e851 - _e482) * _e485);
                                        let _e930 = ((_e803 - _e483) * _e485);
                                        let _e931 = ((_e896 - _e483) * _e485);
                                        let _e933 = select(_e930, _e928, (_e928 < _e930));
                                        let _e935 = select(_e931, _e929, (_e929 < _e931));
                                        let _e937 = select(_e930, _e928, (_e928 > _e930));
                                        let _e939 = select(_e931, _e929, (_e929 > _e931));
                                        let _e941 = select(_e914, _e912, (_e912 < _e914));
                                        let _e943 = select(_e915, _e913, (_e913 < _e915));
                                        let _e945 = select(_e922, _e920, (_e920 < _e922));
                                        let _e947 = select(_e923, _e921, (_e921 < _e923));
                                        let _e949 = select(_e945, _e941, (_e941 > _e945));
                                        let _e951 = select(_e947, _e943, (_e943 > _e947));
                                        let _e953 = select(_e933, _e949, (_e949 > _e933));
                                        let _e955 = select(_e935, _e951, (_e951 > _e935));
                                        let _e957 = select(_e914, _e912, (_e912 > _e914));
                                        let _e959 = select(_e915, _e913, (_e913 > _e915));
                                        let _e961 = select(_e922, _e920, (_e920 > _e922));
                                        let _e963 = select(_e923, _e921, (_e921 > _e923));
                                        let _e965 = select(_e961, _e957, (_e957 < _e961));
                                        let _e967 = select(_e963, _e959, (_e959 < _e963));
                                        let _e972 = -(_e933);
                                        let _e973 = -(_e935);
                                        let _e980 = (select(_e937, _e965, (_e965 < _e937)) + (select(_e972, _e937, (_e937 > _e972)) * 0.0000019073523f));
                                        let _e981 = (select(_e939, _e967, (_e967 < _e939)) + (select(_e973, _e939, (_e939 > _e973)) * 0.0000019073523f));
                                        let _e983 = select(_e588, _e953, (_e953 > _e588));
                                        let _e985 = select(_e588, _e955, (_e955 > _e588));
                                        let _e990 = (_e983 <= select(_e622.member_1, _e980, (_e980 < _e622.member_1)));
                                        let _e991 = (_e985 <= select(_e622.member_1, _e981, (_e981 < _e622.member_1)));
                                        let _e992 = (_e983 <= _e985);
                                        if _e990 {
                                            if _e991 {
                                                if _e992 {
                                                    phi_3295_ = _e906;
                                                } else {
                                                    phi_3295_ = _e901;
                                                }
                                                let _e994 = phi_3295_;
                                                let _e1001 = (_e665 % 128u);
                                                let _e1002 = (_e1001 < 128u);
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_6[_e1001] = _e994.member_1;
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_5[_e1001] = _e994.member.member[0];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_4[_e1001] = _e994.member.member[1];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_3[_e1001] = _e994.member.member[2];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_2[_e1001] = _e994.member.member_1[0];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_1[_e1001] = _e994.member.member_1[1];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local[_e1001] = _e994.member.member_1[2];
                                                if _e1002 {
                                                } else {
                                                    phi_3917_ = true;
                                                    break;
                                                }
                                                local_7[_e1001] = select(_e983, _e985, _e992);
                                                if _e992 {
                                                    phi_3371_ = _e901;
                                                } else {
                                                    phi_3371_ = _e906;
                                                }
                                                let _e1019 = phi_3371_;
                                                phi_3372_ = _e1019;
                                                phi_3373_ = (_e665 + 1u);
                                            } else {
                                                phi_3372_ = type_51();
                                                phi_3373_ = u32();
                                            }
                                            let _e1021 = phi_3372_;
                                            let _e1023 = phi_3373_;
                                            phi_3375_ = _e1021;
                                            phi_3376_ = _e1023;
                                            phi_3377_ = select(true, false, _e991);
                                        } else {
                                            phi_3375_ = type_51();
                                            phi_3376_ = u32();
                                            phi_3377_ = true;
                                        }
                                        let _e1026 = phi_3375_;
                                        let _e1028 = phi_3376_;
                                        let _e1030 = phi_3377_;
                                        if _e1030 {
                                            if _e990 {
                                                phi_3384_ = _e901;
                                            } else {
                                                phi_3384_ = _e906;
                                            }
                                            let _e1032 = phi_3384_;
                                            phi_3389_ = select(_e991, true, _e990);
                                            phi_3390_ = _e1032;
                                        } else {
                                            phi_3389_ = _e661;
                                            phi_3390_ = _e1026;
                                        }
                                        let _e1035 = phi_3389_;
                                        let _e1037 = phi_3390_;
                                        phi_3921_ = _e620;
                                        phi_3392_ = _e622;
                                        phi_3393_ = _e1035;
                                        phi_3394_ = _e1037;
                                        phi_3395_ = select(_e1028, _e665, _e1030);
                                    }
                                    let _e1711 = phi_3921_;
                                    let _e1713 = phi_3392_;
                                    let _e1715 = phi_3393_;
                                    let _e1717 = phi_3394_;
                                    let _e1719 = phi_3395_;
                                    phi_3920_ = _e1711;
                                    phi_3396_ = _e1713;
                                    phi_3397_ = _e1715;
                                    phi_3398_ = _e1717;
                                    phi_3399_ = _e1719;
                                    phi_3400_ = (_e630 - 1u);
                                } else {
                                    phi_3920_ = _e620;
                                    phi_3396_ = _e622;
                                    phi_3397_ = _e661;
                                    phi_3398_ = _e663;
                                    phi_3399_ = _e665;
                                    phi_3400_ = _e630;
                                }
                                let _e1721 = phi_3920_;
                                let _e1723 = phi_3396_;
                                let _e1725 = phi_3397_;
                                let _e1727 = phi_3398_;
                                let _e1729 = phi_3399_;
                                let _e1731 = phi_3400_;
                                phi_3919_ = _e1721;
                                phi_3401_ = _e1723;
                                phi_3402_ = _e1725;
                                phi_3403_ = _e1727;
                                phi_3404_ = _e1729;
                                phi_3405_ = _e1731;
                            } else {
                                phi_3919_ = _e620;
                                phi_3401_ = type_29();
                                phi_3402_ = bool();
                                phi_3403_ = type_51();
                                phi_3404_ = u32();
                                phi_3405_ = u32();
                            }
                            let _e1733 = phi_3919_;
                            let _e1735 = phi_3401_;
                            let _e1737 = phi_3402_;
                            let _e1739 = phi_3403_;
                            let _e1741 = phi_3404_;
                            let _e1743 = phi_3405_;
                            phi_3918_ = _e1733;
                            phi_1129_ = _e1735;
                            phi_1132_ = _e1737;
                            phi_1134_ = _e1739;
                            phi_1136_ = _e1741;
                            phi_1138_ = _e1743;
                            phi_3406_ = _e634;
                        } else {
                            phi_3918_ = _e620;
                            phi_1129_ = type_29();
                            phi_1132_ = bool();
                            phi_1134_ = type_51();
                            phi_1136_ = u32();
                            phi_1138_ = u32();
                            phi_3406_ = false;
                        }
                        let _e1745 = phi_3918_;
                        let _e1747 = phi_1129_;
                        let _e1749 = phi_1132_;
                        let _e1751 = phi_1134_;
                        let _e1753 = phi_1136_;
                        let _e1755 = phi_1138_;
                        let _e1757 = phi_3406_;
                        continue;
                        continuing {
                            phi_3752_ = _e1745;
                            phi_1128_ = _e1747;
                            phi_1131_ = _e1749;
                            phi_1133_ = _e1751;
                            phi_1135_ = _e1753;
                            phi_1137_ = _e1755;
                            phi_3917_ = _e1745;
                            break if !(_e1757);
                        }
                    }
                    let _e1760 = phi_3917_;
                    if _e1760 {
                        break;
                    }
                    let _e1762 = local_11;
                    if (_e1762.member.member_3 != 4294967295u) {
                        let _e1767 = -(_e490);
                        let _e1768 = bitcast<u32>(_e1762.member.member);
                        let _e1772 = (bitcast<i32>((_e1768 >> bitcast<u32>(23i))) & 255i);
                        let _e1773 = (_e1772 + _e1767);
                        if (_e1772 == 255i) {
                            phi_3465_ = _e1762.member.member;
                        } else {
                            if (_e1772 > 0i) {
                                if (_e1773 > 0i) {
                                    let _e1777 = (_e1773 < 255i);
                                    if _e1777 {
                                        phi_3444_ = bitcast<f32>((_e1768 + bitcast<u32>((_e1767 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3444_ = f32();
                                    }
                                    let _e1784 = phi_3444_;
                                    phi_3446_ = _e1784;
                                    phi_3447_ = select(true, false, _e1777);
                                } else {
                                    phi_3446_ = f32();
                                    phi_3447_ = true;
                                }
                                let _e1787 = phi_3446_;
                                let _e1789 = phi_3447_;
                                phi_3448_ = _e1787;
                                phi_3449_ = _e1789;
                            } else {
                                phi_3448_ = f32();
                                phi_3449_ = true;
                            }
                            let _e1791 = phi_3448_;
                            let _e1793 = phi_3449_;
                            if _e1793 {
                                let _e1794 = (_e1768 & 2147483648u);
                                let _e1801 = ((_e1768 & 8388607u) | (select(0u, 1u, ((_e1768 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1805 = (_e1801 == 0u);
                                if _e1805 {
                                    phi_3716_ = bitcast<f32>(_e1794);
                                } else {
                                    let _e1810 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1801)), 32u, _e1805) - 8u);
                                    let _e1813 = (_e1801 << bitcast<u32>((_e1810 & 31u)));
                                    let _e1815 = ((_e1773 + select(0i, 1i, (_e1772 == 0i))) - bitcast<i32>(_e1810));
                                    if (_e1815 >= 255i) {
                                        phi_3706_ = bitcast<f32>((_e1794 | 2139095040u));
                                        phi_3707_ = f32();
                                        phi_3708_ = true;
                                    } else {
                                        let _e1817 = (_e1815 > 0i);
                                        if _e1817 {
                                            phi_3700_ = bitcast<f32>(((_e1794 | (bitcast<u32>(_e1815) << bitcast<u32>(23i))) | (_e1813 & 8388607u)));
                                            phi_3701_ = f32();
                                        } else {
                                            if (_e1815 < -24i) {
                                                phi_3666_ = 26u;
                                            } else {
                                                phi_3666_ = bitcast<u32>((1i - _e1815));
                                            }
                                            let _e1822 = phi_3666_;
                                            let _e1823 = (_e1822 & 31u);
                                            let _e1825 = (_e1813 >> bitcast<u32>(_e1823));
                                            let _e1829 = (_e1813 & ((1u << bitcast<u32>(_e1823)) - 1u));
                                            let _e1833 = (1u << bitcast<u32>(((_e1822 - 1u) & 31u)));
                                            if (_e1829 > _e1833) {
                                                phi_3687_ = true;
                                            } else {
                                                if (_e1829 == _e1833) {
                                                    phi_3684_ = ((_e1825 & 1u) == 1u);
                                                } else {
                                                    phi_3684_ = false;
                                                }
                                                let _e1839 = phi_3684_;
                                                phi_3687_ = _e1839;
                                            }
                                            let _e1841 = phi_3687_;
                                            phi_3700_ = f32();
                                            phi_3701_ = bitcast<f32>((_e1794 | (_e1825 + select(0u, 1u, _e1841))));
                                        }
                                        let _e1854 = phi_3700_;
                                        let _e1856 = phi_3701_;
                                        phi_3706_ = _e1854;
                                        phi_3707_ = _e1856;
                                        phi_3708_ = _e1817;
                                    }
                                    let _e1860 = phi_3706_;
                                    let _e1862 = phi_3707_;
                                    let _e1864 = phi_3708_;
                                    phi_3716_ = select(_e1862, _e1860, _e1864);
                                }
                                let _e1868 = phi_3716_;
                                phi_3464_ = _e1868;
                            } else {
                                phi_3464_ = _e1791;
                            }
                            let _e1870 = phi_3464_;
                            phi_3465_ = _e1870;
                        }
                        let _e1872 = phi_3465_;
                        let _e1873 = bitcast<u32>(_e1872);
                        if ((_e1873 & 2147483647u) >= 2139095040u) {
                            phi_3477_ = bitcast<f32>(((_e1873 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3477_ = _e1872;
                        }
                        let _e1880 = phi_3477_;
                        phi_3482_ = type_18(_e1880, _e1762.member.member_1, _e1762.member.member_2, _e1762.member.member_3);
                    } else {
                        phi_3482_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1885 = phi_3482_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134] = _e1885;
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
