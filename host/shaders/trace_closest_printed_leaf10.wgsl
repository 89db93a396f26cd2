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
    var phi_445_: i32;
    var phi_446_: i32;
    var phi_456_: bool;
    var phi_466_: u32;
    var phi_467_: u32;
    var phi_469_: bool;
    var phi_474_: u32;
    var phi_487_: i32;
    var phi_507_: i32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_571_: f32;
    var phi_577_: f32;
    var phi_650_: f32;
    var phi_656_: f32;
    var phi_696_: f32;
    var phi_702_: f32;
    var phi_775_: f32;
    var phi_781_: f32;
    var phi_821_: f32;
    var phi_827_: f32;
    var phi_946_: i32;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_1006_: i32;
    var phi_1028_: u32;
    var phi_1029_: u32;
    var phi_1037_: f32;
    var phi_1038_: f32;
    var phi_3823_: bool;
    var phi_1121_: type_29;
    var phi_1124_: u32;
    var phi_1126_: bool;
    var phi_1128_: u32;
    var phi_1130_: type_51;
    var phi_1141_: bool;
    var phi_1227_: bool;
    var phi_1228_: u32;
    var phi_1229_: type_51;
    var phi_1248_: type_29;
    var phi_1251_: type_4;
    var phi_1252_: type_4;
    var phi_1274_: type_4;
    var phi_1299_: u32;
    var phi_1315_: type_45;
    var phi_3544_: bool;
    var phi_3559_: bool;
    var phi_3574_: bool;
    var phi_3589_: bool;
    var phi_3604_: bool;
    var phi_3619_: bool;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2124_: f32;
    var phi_2125_: f32;
    var phi_2126_: vec3<f32>;
    var phi_2127_: vec3<f32>;
    var phi_2128_: vec3<f32>;
    var phi_2129_: vec3<f32>;
    var phi_3634_: bool;
    var phi_3649_: bool;
    var phi_3664_: bool;
    var phi_3679_: bool;
    var phi_3694_: bool;
    var phi_3709_: bool;
    var phi_2337_: f32;
    var phi_2357_: type_31;
    var phi_2358_: type_31;
    var phi_2361_: type_31;
    var phi_2362_: type_31;
    var phi_2363_: bool;
    var phi_2367_: type_31;
    var phi_2376_: type_18;
    var phi_2401_: bool;
    var phi_2402_: bool;
    var phi_2408_: type_29;
    var phi_2409_: type_29;
    var phi_2410_: type_29;
    var phi_1249_: type_29;
    var phi_3817_: bool;
    var phi_4059_: bool;
    var phi_2411_: type_29;
    var phi_2432_: type_38;
    var phi_3318_: type_51;
    var phi_3394_: type_51;
    var phi_3395_: u32;
    var phi_3396_: type_51;
    var phi_3398_: u32;
    var phi_3399_: type_51;
    var phi_3400_: bool;
    var phi_3407_: type_51;
    var phi_3412_: bool;
    var phi_3414_: type_51;
    var phi_3418_: bool;
    var phi_3419_: u32;
    var phi_3420_: type_51;
    var phi_3430_: type_51;
    var phi_4003_: bool;
    var phi_3431_: type_29;
    var phi_3432_: u32;
    var phi_3433_: bool;
    var phi_3434_: u32;
    var phi_3435_: type_51;
    var phi_4002_: bool;
    var phi_3436_: type_29;
    var phi_3437_: u32;
    var phi_3438_: bool;
    var phi_3439_: u32;
    var phi_3440_: type_51;
    var phi_4001_: bool;
    var phi_1122_: type_29;
    var phi_1125_: u32;
    var phi_1127_: bool;
    var phi_1129_: u32;
    var phi_1131_: type_51;
    var phi_3441_: bool;
    var phi_4000_: bool;
    var local_10: type_29;
    var phi_3479_: f32;
    var phi_3481_: f32;
    var phi_3482_: bool;
    var phi_3483_: f32;
    var phi_3484_: bool;
    var phi_3737_: u32;
    var phi_3755_: bool;
    var phi_3758_: bool;
    var phi_3771_: f32;
    var phi_3772_: f32;
    var phi_3777_: f32;
    var phi_3778_: f32;
    var phi_3779_: bool;
    var phi_3787_: f32;
    var phi_3499_: f32;
    var phi_3500_: f32;
    var phi_3512_: f32;
    var phi_3517_: type_18;
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
                            phi_445_ = (bitcast<i32>((_e213 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_445_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e213)), 32u, (_e213 == 0u))));
                        }
                        let _e227 = phi_445_;
                        phi_446_ = _e227;
                    } else {
                        phi_446_ = 0i;
                    }
                    let _e229 = phi_446_;
                    let _e230 = (_e146 == _e185);
                    if _e230 {
                        phi_456_ = true;
                    } else {
                        phi_456_ = (_e153 == _e185);
                    }
                    let _e233 = phi_456_;
                    let _e234 = select(1u, 0u, _e230);
                    if _e233 {
                        let _e235 = (_e234 + 1u);
                        phi_466_ = _e235;
                        phi_467_ = _e235;
                        phi_469_ = select(true, false, (_e235 == 2u));
                    } else {
                        phi_466_ = u32();
                        phi_467_ = 0u;
                        phi_469_ = true;
                    }
                    let _e239 = phi_466_;
                    let _e241 = phi_467_;
                    let _e243 = phi_469_;
                    if _e243 {
                        phi_474_ = (_e241 + 1u);
                    } else {
                        phi_474_ = 0u;
                    }
                    let _e247 = phi_474_;
                    let _e248 = select(_e239, _e241, _e243);
                    let _e249 = select(_e234, select(2u, _e234, _e233), _e243);
                    if (_e124 < -126i) {
                        phi_487_ = -126i;
                    } else {
                        phi_487_ = select(_e124, 127i, (_e124 > 127i));
                    }
                    let _e254 = phi_487_;
                    let _e259 = bitcast<f32>((bitcast<u32>((_e254 + 127i)) << bitcast<u32>(23i)));
                    let _e265 = bitcast<f32>((bitcast<u32>(((_e124 - _e254) + 127i)) << bitcast<u32>(23i)));
                    let _e266 = -(_e229);
                    if (_e266 < -126i) {
                        phi_507_ = -126i;
                    } else {
                        phi_507_ = select(_e266, 127i, (_e266 > 127i));
                    }
                    let _e271 = phi_507_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e266 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = global_3.member[_e134].member;
                    let _e287 = (_e248 == 0u);
                    if _e287 {
                        phi_525_ = _e286[0];
                    } else {
                        phi_525_ = _e286[1];
                    }
                    let _e291 = phi_525_;
                    let _e292 = (_e248 == 2u);
                    if _e292 {
                        phi_531_ = _e286[2];
                    } else {
                        phi_531_ = _e291;
                    }
                    let _e295 = phi_531_;
                    let _e296 = bitcast<u32>(_e295);
                    let _e298 = ((_e296 & 2139095040u) != 0u);
                    let _e312 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e296 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e296 & 2147483648u))), _e295, _e298) * _e259) * select(0.00000011920929f, 1f, _e298)) * _e265);
                    let _e313 = global_3.member[_e134].member_2;
                    if _e287 {
                        phi_571_ = _e313[0];
                    } else {
                        phi_571_ = _e313[1];
                    }
                    let _e317 = phi_571_;
                    if _e292 {
                        phi_577_ = _e313[2];
                    } else {
                        phi_577_ = _e317;
                    }
                    let _e320 = phi_577_;
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
                        phi_650_ = _e286[0];
                    } else {
                        phi_650_ = _e286[1];
                    }
                    let _e358 = phi_650_;
                    let _e359 = (_e247 == 2u);
                    if _e359 {
                        phi_656_ = _e286[2];
                    } else {
                        phi_656_ = _e358;
                    }
                    let _e362 = phi_656_;
                    let _e363 = bitcast<u32>(_e362);
                    let _e365 = ((_e363 & 2139095040u) != 0u);
                    let _e379 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e362, _e365) * _e259) * select(0.00000011920929f, 1f, _e365)) * _e265);
                    if _e354 {
                        phi_696_ = _e313[0];
                    } else {
                        phi_696_ = _e313[1];
                    }
                    let _e383 = phi_696_;
                    if _e359 {
                        phi_702_ = _e313[2];
                    } else {
                        phi_702_ = _e383;
                    }
                    let _e386 = phi_702_;
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
                        phi_775_ = _e286[0];
                    } else {
                        phi_775_ = _e286[1];
                    }
                    let _e424 = phi_775_;
                    let _e425 = (_e249 == 2u);
                    if _e425 {
                        phi_781_ = _e286[2];
                    } else {
                        phi_781_ = _e424;
                    }
                    let _e428 = phi_781_;
                    let _e429 = bitcast<u32>(_e428);
                    let _e431 = ((_e429 & 2139095040u) != 0u);
                    let _e445 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e429 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e429 & 2147483648u))), _e428, _e431) * _e259) * select(0.00000011920929f, 1f, _e431)) * _e265);
                    if _e420 {
                        phi_821_ = _e313[0];
                    } else {
                        phi_821_ = _e313[1];
                    }
                    let _e449 = phi_821_;
                    if _e425 {
                        phi_827_ = _e313[2];
                    } else {
                        phi_827_ = _e449;
                    }
                    let _e452 = phi_827_;
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
                            phi_946_ = 255i;
                        } else {
                            phi_946_ = (((_e503 + select(0i, 1i, (_e503 == 0i))) - _e510) + _e490);
                        }
                        let _e518 = phi_946_;
                        let _e528 = (_e518 <= 0i);
                        if _e528 {
                            phi_969_ = u32();
                        } else {
                            if _e507 {
                                phi_968_ = u32();
                            } else {
                                phi_968_ = select(((bitcast<u32>(_e518) << bitcast<u32>(23i)) | ((_e500 << bitcast<u32>(((_e510 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e518 >= 255i));
                            }
                            let _e532 = phi_968_;
                            phi_969_ = _e532;
                        }
                        let _e534 = phi_969_;
                        let _e546 = ((_e206 & 8388607u) | (select(0u, 1u, ((_e206 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e549 = bitcast<i32>((_e206 >> bitcast<u32>(23i)));
                        let _e553 = (_e546 == 0u);
                        let _e556 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e546)), 32u, _e553)) - 8i);
                        if (_e549 == 255i) {
                            phi_1006_ = 255i;
                        } else {
                            phi_1006_ = (((_e549 + select(0i, 1i, (_e549 == 0i))) - _e556) + _e490);
                        }
                        let _e564 = phi_1006_;
                        let _e574 = (_e564 <= 0i);
                        if _e574 {
                            phi_1029_ = u32();
                        } else {
                            if _e553 {
                                phi_1028_ = u32();
                            } else {
                                phi_1028_ = select(((bitcast<u32>(_e564) << bitcast<u32>(23i)) | ((_e546 << bitcast<u32>(((_e556 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e564 >= 255i));
                            }
                            let _e578 = phi_1028_;
                            phi_1029_ = _e578;
                        }
                        let _e580 = phi_1029_;
                        phi_1037_ = bitcast<f32>(((_e205 & 2147483648u) | select(_e580, 0u, select(_e553, true, _e574))));
                        phi_1038_ = bitcast<f32>(((_e196 & 2147483648u) | select(_e534, 0u, select(_e507, true, _e528))));
                    } else {
                        phi_1037_ = 0f;
                        phi_1038_ = 1f;
                    }
                    let _e586 = phi_1037_;
                    let _e588 = phi_1038_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                    let _e593 = (_e248 % 3u);
                    let _e594 = (_e593 < 3u);
                    if _e594 {
                    } else {
                        break;
                    }
                    let _e596 = local_9[_e593];
                    let _e597 = (_e247 % 3u);
                    let _e598 = (_e597 < 3u);
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e600 = local_9[_e597];
                    let _e601 = (_e249 % 3u);
                    let _e602 = (_e601 < 3u);
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e604 = local_9[_e601];
                    local_8 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                    if _e594 {
                    } else {
                        break;
                    }
                    let _e608 = local_8[_e593];
                    if _e598 {
                    } else {
                        break;
                    }
                    let _e610 = local_8[_e597];
                    if _e602 {
                    } else {
                        break;
                    }
                    let _e612 = local_8[_e601];
                    phi_3823_ = false;
                    phi_1121_ = type_29(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e586);
                    phi_1124_ = ((3u * _e85) + 1u);
                    phi_1126_ = (_e588 <= _e586);
                    phi_1128_ = 0u;
                    phi_1130_ = type_51(type_43(array<f32, 3>(_e596, _e600, _e604), array<f32, 3>(_e608, _e610, _e612)), select(0u, 2147483648u, (_e85 == 0u)));
                    loop {
                        let _e620 = phi_3823_;
                        let _e622 = phi_1121_;
                        let _e624 = phi_1124_;
                        let _e626 = phi_1126_;
                        let _e628 = phi_1128_;
                        let _e630 = phi_1130_;
                        local_10 = _e622;
                        if _e626 {
                            phi_1141_ = true;
                        } else {
                            phi_1141_ = (_e628 > 0u);
                        }
                        let _e633 = phi_1141_;
                        if _e633 {
                            let _e634 = (_e624 > 0u);
                            if _e634 {
                                if _e626 {
                                    phi_1227_ = _e626;
                                    phi_1228_ = _e628;
                                    phi_1229_ = _e630;
                                } else {
                                    let _e635 = (_e628 - 1u);
                                    let _e636 = (_e635 % 128u);
                                    let _e637 = (_e636 < 128u);
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e639 = local_6[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e641 = local_5[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e643 = local_4[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e645 = local_3[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e648 = local_2[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e650 = local_1[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e652 = local[_e636];
                                    if _e637 {
                                    } else {
                                        phi_4000_ = true;
                                        break;
                                    }
                                    let _e657 = local_7[_e636];
                                    phi_1227_ = (_e657 <= _e622.member_1);
                                    phi_1228_ = _e635;
                                    phi_1229_ = type_51(type_43(array<f32, 3>(_e641, _e643, _e645), array<f32, 3>(_e648, _e650, _e652)), _e639);
                                }
                                let _e661 = phi_1227_;
                                let _e663 = phi_1228_;
                                let _e665 = phi_1229_;
                                if _e661 {
                                    let _e669 = ((_e665.member_1 & 2147483648u) != 0u);
                                    if _e669 {
                                        phi_1248_ = _e622;
                                        phi_1251_ = type_4(0u, ((_e665.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e677 = phi_1248_;
                                            let _e679 = phi_1251_;
                                            local_11 = _e677;
                                            if (_e679.member < _e679.member_1) {
                                                phi_1252_ = type_4((_e679.member + 1u), _e679.member_1);
                                                phi_1274_ = type_4(1u, _e679.member);
                                            } else {
                                                phi_1252_ = _e679;
                                                phi_1274_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e692 = phi_1252_;
                                            let _e694 = phi_1274_;
                                            let _e698 = (bitcast<i32>(_e694.member) != 0i);
                                            if _e698 {
                                                let _e699 = ((_e665.member_1 & 268435455u) + _e694.member_1);
                                                let _e700 = (_e699 < arrayLength((&global_6.member)));
                                                if _e700 {
                                                    if _e700 {
                                                    } else {
                                                        phi_3817_ = true;
                                                        break;
                                                    }
                                                    let _e703 = global_6.member[_e699].member_1;
                                                    phi_1299_ = _e703;
                                                } else {
                                                    phi_1299_ = 4294967295u;
                                                }
                                                let _e705 = phi_1299_;
                                                if _e700 {
                                                    if _e700 {
                                                    } else {
                                                        phi_3817_ = true;
                                                        break;
                                                    }
                                                    let _e707 = global_6.member[_e699];
                                                    phi_1315_ = _e707;
                                                } else {
                                                    phi_1315_ = type_45(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e709 = phi_1315_;
                                                let _e721 = ((10u * _e248) & 31u);
                                                let _e724 = ((_e709.member[0] >> bitcast<u32>(_e721)) & 1023u);
                                                let _e732 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[0] - _e665.member.member[0]) * 0.0009775171f)) ^ _e120));
                                                let _e737 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e724)) - 8388608f) * _e732)) ^ _e120)));
                                                let _e741 = select(select(_e665.member.member_1[0], _e737, (_e737 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e724 == 1023u));
                                                let _e743 = ((10u * _e247) & 31u);
                                                let _e746 = ((_e709.member[0] >> bitcast<u32>(_e743)) & 1023u);
                                                let _e754 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[1] - _e665.member.member[1]) * 0.0009775171f)) ^ _e120));
                                                let _e759 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e746)) - 8388608f) * _e754)) ^ _e120)));
                                                let _e763 = select(select(_e665.member.member_1[1], _e759, (_e759 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e746 == 1023u));
                                                let _e765 = ((10u * _e249) & 31u);
                                                let _e768 = ((_e709.member[0] >> bitcast<u32>(_e765)) & 1023u);
                                                let _e776 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[2] - _e665.member.member[2]) * 0.0009775171f)) ^ _e120));
                                                let _e781 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e768)) - 8388608f) * _e776)) ^ _e120)));
                                                let _e785 = select(select(_e665.member.member_1[2], _e781, (_e781 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e768 == 1023u));
                                                let _e789 = ((_e709.member[1] >> bitcast<u32>(_e721)) & 1023u);
                                                let _e797 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e789)) - 8388608f) * _e732)) ^ _e120)));
                                                let _e801 = select(select(_e665.member.member_1[0], _e797, (_e797 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e789 == 1023u));
                                                let _e804 = ((_e709.member[1] >> bitcast<u32>(_e743)) & 1023u);
                                                let _e812 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e804)) - 8388608f) * _e754)) ^ _e120)));
                                                let _e816 = select(select(_e665.member.member_1[1], _e812, (_e812 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e804 == 1023u));
                                                let _e819 = ((_e709.member[1] >> bitcast<u32>(_e765)) & 1023u);
                                                let _e827 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e819)) - 8388608f) * _e776)) ^ _e120)));
                                                let _e831 = select(select(_e665.member.member_1[2], _e827, (_e827 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e819 == 1023u));
                                                let _e835 = ((_e709.member[2] >> bitcast<u32>(_e721)) & 1023u);
                                                let _e843 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e835)) - 8388608f) * _e732)) ^ _e120)));
                                                let _e847 = select(select(_e665.member.member_1[0], _e843, (_e843 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e835 == 1023u));
                                                let _e850 = ((_e709.member[2] >> bitcast<u32>(_e743)) & 1023u);
                                                let _e858 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e850)) - 8388608f) * _e754)) ^ _e120)));
                                                let _e862 = select(select(_e665.member.member_1[1], _e858, (_e858 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e850 == 1023u));
                                                let _e865 = ((_e709.member[2] >> bitcast<u32>(_e765)) & 1023u);
                                                let _e873 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e865)) - 8388608f) * _e776)) ^ _e120)));
                                                let _e877 = select(select(_e665.member.member_1[2], _e873, (_e873 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e865 == 1023u));
                                                let _e881 = (_e785 - _e445);
                                                let _e884 = (((_e741 - _e312) * _e481) - (_e881 * _e349));
                                                let _e887 = (((_e763 - _e379) * _e481) - (_e881 * _e415));
                                                let _e890 = (_e831 - _e445);
                                                let _e893 = (((_e801 - _e312) * _e481) - (_e890 * _e349));
                                                let _e896 = (((_e816 - _e379) * _e481) - (_e890 * _e415));
                                                let _e899 = (_e877 - _e445);
                                                let _e902 = (((_e847 - _e312) * _e481) - (_e899 * _e349));
                                                let _e905 = (((_e862 - _e379) * _e481) - (_e899 * _e415));
                                                let _e906 = (_e902 * _e896);
                                                let _e907 = (_e905 * _e893);
                                                let _e908 = (_e884 * _e905);
                                                let _e909 = (_e887 * _e902);
                                                let _e910 = (_e893 * _e887);
                                                let _e911 = (_e896 * _e884);
                                                let _e916 = (((_e906 >= _e907) && (_e908 >= _e909)) && (_e910 >= _e911));
                                                let _e922 = (_e916 || (((_e906 <= _e907) && (_e908 <= _e909)) && (_e910 <= _e911)));
                                                if _e922 {
                                                    let _e924 = select(-1f, 1f, _e916);
                                                    let _e926 = ((_e906 - _e907) * _e924);
                                                    let _e928 = select(0f, _e926, (_e926 > 0f));
                                                    let _e930 = ((_e908 - _e909) * _e924);
                                                    let _e932 = select(0f, _e930, (_e930 > 0f));
                                                    let _e934 = ((_e910 - _e911) * _e924);
                                                    let _e936 = select(0f, _e934, (_e934 > 0f));
                                                    let _e938 = ((_e928 + _e932) + _e936);
                                                    let _e940 = select(_e801, _e741, (_e741 < _e801));
                                                    let _e944 = select(_e801, _e741, (_e741 > _e801));
                                                    let _e948 = select(_e816, _e763, (_e763 < _e816));
                                                    let _e952 = select(_e816, _e763, (_e763 > _e816));
                                                    let _e956 = select(_e831, _e785, (_e785 < _e831));
                                                    let _e960 = select(_e831, _e785, (_e785 > _e831));
                                                    let _e965 = ((select(_e847, _e940, (_e940 < _e847)) - _e350) * _e353);
                                                    let _e966 = ((select(_e847, _e944, (_e944 > _e847)) - _e351) * _e353);
                                                    let _e969 = ((select(_e862, _e948, (_e948 < _e862)) - _e416) * _e419);
                                                    let _e970 = ((select(_e862, _e952, (_e952 > _e862)) - _e417) * _e419);
                                                    let _e973 = ((select(_e877, _e956, (_e956 < _e877)) - _e482) * _e485);
                                                    let _e974 = ((select(_e877, _e960, (_e960 > _e877)) - _e483) * _e485);
                                                    let _e976 = select(_e974, _e973, (_e973 < _e974));
                                                    let _e978 = select(_e974, _e973, (_e973 > _e974));
                                                    let _e980 = select(_e966, _e965, (_e965 < _e966));
                                                    let _e982 = select(_e970, _e969, (_e969 < _e970));
                                                    let _e984 = select(_e982, _e980, (_e980 > _e982));
                                                    let _e986 = select(_e976, _e984, (_e984 > _e976));
                                                    let _e988 = select(_e966, _e965, (_e965 > _e966));
                                                    let _e990 = select(_e970, _e969, (_e969 > _e970));
                                                    let _e992 = select(_e990, _e988, (_e988 < _e990));
                                                    let _e994 = select(_e978, _e992, (_e992 < _e978));
                                                    let _e995 = -(_e976);
                                                    let _e1001 = select(_e588, _e986, (_e986 > _e588));
                                                    let _e1005 = select(_e893, _e884, (_e884 < _e893));
                                                    let _e1010 = select(_e893, _e884, (_e884 > _e893));
                                                    let _e1017 = select(_e896, _e887, (_e887 < _e896));
                                                    let _e1022 = select(_e896, _e887, (_e887 > _e896));
                                                    let _e1031 = (((((_e922 && (_e938 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e902, _e1005, (_e1005 < _e902)) <= 0f) && (select(_e902, _e1010, (_e1010 > _e902)) >= 0f))) && ((select(_e905, _e1017, (_e1017 < _e905)) <= 0f) && (select(_e905, _e1022, (_e1022 > _e905)) >= 0f))) && (_e1001 <= (_e994 + (select(_e995, _e978, (_e978 > _e995)) * 0.0000019073523f)))) && (_e1001 <= _e677.member_1));
                                                    if _e1031 {
                                                        let _e1036 = (_e801 - _e741);
                                                        let _e1037 = (_e816 - _e763);
                                                        let _e1038 = (_e831 - _e785);
                                                        let _e1039 = vec3<f32>(_e1036, _e1037, _e1038);
                                                        let _e1040 = (_e847 - _e801);
                                                        let _e1041 = (_e862 - _e816);
                                                        let _e1042 = (_e877 - _e831);
                                                        let _e1043 = vec3<f32>(_e1040, _e1041, _e1042);
                                                        let _e1044 = (_e741 - _e847);
                                                        let _e1045 = (_e763 - _e862);
                                                        let _e1046 = (_e785 - _e877);
                                                        let _e1047 = vec3<f32>(_e1044, _e1045, _e1046);
                                                        let _e1048 = abs(_e1036);
                                                        let _e1049 = abs(_e1037);
                                                        if (_e1048 != _e1048) {
                                                            phi_3544_ = true;
                                                        } else {
                                                            phi_3544_ = (_e1049 >= _e1048);
                                                        }
                                                        let _e1053 = phi_3544_;
                                                        let _e1054 = select(_e1048, _e1049, _e1053);
                                                        let _e1055 = abs(_e1038);
                                                        if (_e1054 != _e1054) {
                                                            phi_3559_ = true;
                                                        } else {
                                                            phi_3559_ = (_e1055 >= _e1054);
                                                        }
                                                        let _e1059 = phi_3559_;
                                                        let _e1060 = select(_e1054, _e1055, _e1059);
                                                        let _e1061 = abs(_e1040);
                                                        let _e1062 = abs(_e1041);
                                                        if (_e1061 != _e1061) {
                                                            phi_3574_ = true;
                                                        } else {
                                                            phi_3574_ = (_e1062 >= _e1061);
                                                        }
                                                        let _e1066 = phi_3574_;
                                                        let _e1067 = select(_e1061, _e1062, _e1066);
                                                        let _e1068 = abs(_e1042);
                                                        if (_e1067 != _e1067) {
                                                            phi_3589_ = true;
                                                        } else {
                                                            phi_3589_ = (_e1068 >= _e1067);
                                                        }
                                                        let _e1072 = phi_3589_;
                                                        let _e1073 = select(_e1067, _e1068, _e1072);
                                                        let _e1074 = abs(_e1044);
                                                        let _e1075 = abs(_e1045);
                                                        if (_e1074 != _e1074) {
                                                            phi_3604_ = true;
                                                        } else {
                                                            phi_3604_ = (_e1075 >= _e1074);
                                                        }
                                                        let _e1079 = phi_3604_;
                                                        let _e1080 = select(_e1074, _e1075, _e1079);
                                                        let _e1081 = abs(_e1046);
                                                        if (_e1080 != _e1080) {
                                                            phi_3619_ = true;
                                                        } else {
                                                            phi_3619_ = (_e1081 >= _e1080);
                                                        }
                                                        let _e1085 = phi_3619_;
                                                        let _e1086 = select(_e1080, _e1081, _e1085);
                                                        let _e1088 = select(_e1073, _e1060, (_e1060 > _e1073));
                                                        let _e1090 = select(_e1086, _e1088, (_e1088 > _e1086));
                                                        if (_e1060 == _e1090) {
                                                            phi_2122_ = _e896;
                                                            phi_2123_ = _e893;
                                                            phi_2124_ = _e887;
                                                            phi_2125_ = _e884;
                                                            phi_2126_ = vec3<f32>(_e741, _e763, _e785);
                                                            phi_2127_ = _e1047;
                                                            phi_2128_ = _e1043;
                                                            phi_2129_ = _e1039;
                                                        } else {
                                                            let _e1092 = (_e1073 == _e1090);
                                                            let _e1097 = vec3(_e1092);
                                                            phi_2122_ = select(_e887, _e905, _e1092);
                                                            phi_2123_ = select(_e884, _e902, _e1092);
                                                            phi_2124_ = select(_e905, _e896, _e1092);
                                                            phi_2125_ = select(_e902, _e893, _e1092);
                                                            phi_2126_ = select(vec3<f32>(_e847, _e862, _e877), vec3<f32>(_e801, _e816, _e831), _e1097);
                                                            phi_2127_ = select(_e1043, _e1039, _e1097);
                                                            phi_2128_ = select(_e1039, _e1047, _e1097);
                                                            phi_2129_ = select(_e1047, _e1043, _e1097);
                                                        }
                                                        let _e1103 = phi_2122_;
                                                        let _e1105 = phi_2123_;
                                                        let _e1107 = phi_2124_;
                                                        let _e1109 = phi_2125_;
                                                        let _e1111 = phi_2126_;
                                                        let _e1113 = phi_2127_;
                                                        let _e1115 = phi_2128_;
                                                        let _e1117 = phi_2129_;
                                                        let _e1124 = ((_e1115.y * _e1113.z) - (_e1113.y * _e1115.z));
                                                        let _e1129 = ((_e1115.z * _e1113.x) - (_e1113.z * _e1115.x));
                                                        let _e1132 = ((_e1115.x * _e1113.y) - (_e1113.x * _e1115.y));
                                                        let _e1135 = ((_e928 >= _e932) && (_e928 >= _e936));
                                                        let _e1136 = (_e932 >= _e936);
                                                        let _e1150 = (((_e1124 * (select(select(_e847, _e801, _e1136), _e741, _e1135) - _e312)) + (_e1129 * (select(select(_e862, _e816, _e1136), _e763, _e1135) - _e379))) + (_e1132 * (select(select(_e877, _e831, _e1136), _e785, _e1135) - _e445)));
                                                        let _e1155 = (((_e1124 * _e349) + (_e1129 * _e415)) + (_e1132 * _e481));
                                                        let _e1156 = (_e1105 - _e1109);
                                                        let _e1157 = (_e1103 - _e1107);
                                                        let _e1160 = ((_e1156 * _e1156) + (_e1157 * _e1157));
                                                        let _e1167 = (-(((_e1109 * _e1156) + (_e1107 * _e1157))) / select(0.000000000000000000000000000000000000011754944f, _e1160, (_e1160 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1169 = select(1f, _e1167, (_e1167 < 1f));
                                                        let _e1171 = select(0f, _e1169, (_e1169 > 0f));
                                                        let _e1180 = ((_e1111.x + (_e1117.x * _e1171)) - _e312);
                                                        let _e1183 = ((_e1111.y + (_e1117.y * _e1171)) - _e379);
                                                        let _e1186 = ((_e1111.z + (_e1117.z * _e1171)) - _e445);
                                                        let _e1189 = bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u));
                                                        let _e1192 = bitcast<f32>((bitcast<u32>(_e1183) & 2147483647u));
                                                        let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                                        let _e1197 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                        let _e1199 = select(_e1197, _e1194, (_e1194 > _e1197));
                                                        let _e1203 = abs(_e1124);
                                                        let _e1204 = abs(_e1129);
                                                        if (_e1203 != _e1203) {
                                                            phi_3634_ = true;
                                                        } else {
                                                            phi_3634_ = (_e1204 >= _e1203);
                                                        }
                                                        let _e1208 = phi_3634_;
                                                        let _e1209 = select(_e1203, _e1204, _e1208);
                                                        let _e1210 = abs(_e1132);
                                                        if (_e1209 != _e1209) {
                                                            phi_3649_ = true;
                                                        } else {
                                                            phi_3649_ = (_e1210 >= _e1209);
                                                        }
                                                        let _e1214 = phi_3649_;
                                                        let _e1230 = abs(_e1115.x);
                                                        let _e1231 = abs(_e1115.y);
                                                        if (_e1230 != _e1230) {
                                                            phi_3664_ = true;
                                                        } else {
                                                            phi_3664_ = (_e1231 >= _e1230);
                                                        }
                                                        let _e1235 = phi_3664_;
                                                        let _e1236 = select(_e1230, _e1231, _e1235);
                                                        let _e1237 = abs(_e1115.z);
                                                        if (_e1236 != _e1236) {
                                                            phi_3679_ = true;
                                                        } else {
                                                            phi_3679_ = (_e1237 >= _e1236);
                                                        }
                                                        let _e1241 = phi_3679_;
                                                        let _e1244 = abs(_e1113.x);
                                                        let _e1245 = abs(_e1113.y);
                                                        if (_e1244 != _e1244) {
                                                            phi_3694_ = true;
                                                        } else {
                                                            phi_3694_ = (_e1245 >= _e1244);
                                                        }
                                                        let _e1249 = phi_3694_;
                                                        let _e1250 = select(_e1244, _e1245, _e1249);
                                                        let _e1251 = abs(_e1113.z);
                                                        if (_e1250 != _e1250) {
                                                            phi_3709_ = true;
                                                        } else {
                                                            phi_3709_ = (_e1251 >= _e1250);
                                                        }
                                                        let _e1255 = phi_3709_;
                                                        let _e1260 = ((bitcast<f32>((bitcast<u32>(((((_e1124 * _e1180) + (_e1129 * _e1183)) + (_e1132 * _e1186)) - _e1150)) & 2147483647u)) <= ((0.0000009536743f * select(_e1090, _e1199, (_e1199 > _e1090))) * select(_e1209, _e1210, _e1214))) && !((bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u)) <= ((0.0000038146973f * select(_e1236, _e1237, _e1241)) * select(_e1250, _e1251, _e1255)))));
                                                        let _e1261 = (_e1150 / _e1155);
                                                        if (_e1031 && !(_e1260)) {
                                                            let _e1264 = (_e1186 / _e481);
                                                            let _e1272 = (((_e1124 * (_e1180 - (_e349 * _e1264))) + (_e1129 * (_e1183 - (_e415 * _e1264)))) / _e1155);
                                                            phi_2337_ = select(select(_e1264, (_e1264 + _e1272), (bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u)) <= _e1090)), _e1261, _e1260);
                                                        } else {
                                                            phi_2337_ = _e1261;
                                                        }
                                                        let _e1281 = phi_2337_;
                                                        let _e1283 = select(_e994, _e1281, (_e1281 < _e994));
                                                        let _e1285 = select(_e986, _e1283, (_e1283 > _e986));
                                                        let _e1286 = (1f / _e938);
                                                        phi_2357_ = type_31(_e1285, (_e932 * _e1286), (_e936 * _e1286), ((_e1031 && (_e1285 >= _e588)) && (_e1285 <= _e677.member_1)));
                                                        phi_2358_ = type_31();
                                                    } else {
                                                        phi_2357_ = type_31();
                                                        phi_2358_ = type_31(0f, 0f, 0f, _e1031);
                                                    }
                                                    let _e1295 = phi_2357_;
                                                    let _e1297 = phi_2358_;
                                                    phi_2361_ = _e1295;
                                                    phi_2362_ = _e1297;
                                                    phi_2363_ = select(true, false, _e1031);
                                                } else {
                                                    phi_2361_ = type_31();
                                                    phi_2362_ = type_31(0f, 0f, 0f, _e922);
                                                    phi_2363_ = true;
                                                }
                                                let _e1300 = phi_2361_;
                                                let _e1302 = phi_2362_;
                                                let _e1304 = phi_2363_;
                                                if _e1304 {
                                                    phi_2367_ = _e1302;
                                                } else {
                                                    phi_2367_ = _e1300;
                                                }
                                                let _e1306 = phi_2367_;
                                                if _e1306.member_3 {
                                                    phi_2376_ = type_18(_e1306.member, _e1306.member_1, _e1306.member_2, _e705);
                                                } else {
                                                    phi_2376_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1313 = phi_2376_;
                                                if (_e1313.member_3 != 4294967295u) {
                                                    if (_e705 != 4294967295u) {
                                                        if (_e1313.member < _e677.member.member) {
                                                            phi_2402_ = true;
                                                        } else {
                                                            if (_e1313.member == _e677.member.member) {
                                                                phi_2401_ = (_e1313.member_3 < _e677.member.member_3);
                                                            } else {
                                                                phi_2401_ = false;
                                                            }
                                                            let _e1326 = phi_2401_;
                                                            phi_2402_ = _e1326;
                                                        }
                                                        let _e1328 = phi_2402_;
                                                        if _e1328 {
                                                            phi_2408_ = type_29(_e1313, _e1313.member);
                                                        } else {
                                                            phi_2408_ = _e677;
                                                        }
                                                        let _e1331 = phi_2408_;
                                                        phi_2409_ = _e1331;
                                                    } else {
                                                        phi_2409_ = _e677;
                                                    }
                                                    let _e1333 = phi_2409_;
                                                    phi_2410_ = _e1333;
                                                } else {
                                                    phi_2410_ = _e677;
                                                }
                                                let _e1335 = phi_2410_;
                                                phi_1249_ = _e1335;
                                            } else {
                                                phi_1249_ = type_29();
                                            }
                                            let _e1337 = phi_1249_;
                                            continue;
                                            continuing {
                                                phi_1248_ = _e1337;
                                                phi_1251_ = _e692;
                                                phi_3817_ = _e620;
                                                break if !(_e698);
                                            }
                                        }
                                        let _e1340 = phi_3817_;
                                        phi_4000_ = _e1340;
                                        if _e1340 {
                                            break;
                                        }
                                        phi_4059_ = _e1340;
                                        let _e1970 = local_11;
                                        phi_2411_ = _e1970;
                                    } else {
                                        phi_4059_ = _e620;
                                        phi_2411_ = _e622;
                                    }
                                    let _e1342 = phi_4059_;
                                    let _e1344 = phi_2411_;
                                    if _e669 {
                                        phi_3418_ = bool();
                                        phi_3419_ = u32();
                                        phi_3420_ = type_51();
                                    } else {
                                        let _e1345 = (_e665.member_1 < _e85);
                                        if _e1345 {
                                            if _e1345 {
                                            } else {
                                                phi_4000_ = true;
                                                break;
                                            }
                                            let _e1347 = global_4.member[_e665.member_1];
                                            phi_2432_ = _e1347;
                                        } else {
                                            phi_2432_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1349 = phi_2432_;
                                        let _e1364 = ((10u * _e248) & 31u);
                                        let _e1367 = ((_e1349.member[0] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1375 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[0] - _e665.member.member[0]) * 0.0009775171f)) ^ _e120));
                                        let _e1380 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1367)) - 8388608f) * _e1375)) ^ _e120)));
                                        let _e1384 = select(select(_e665.member.member_1[0], _e1380, (_e1380 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1367 == 1023u));
                                        let _e1386 = ((10u * _e247) & 31u);
                                        let _e1389 = ((_e1349.member[0] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1397 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[1] - _e665.member.member[1]) * 0.0009775171f)) ^ _e120));
                                        let _e1402 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1389)) - 8388608f) * _e1397)) ^ _e120)));
                                        let _e1406 = select(select(_e665.member.member_1[1], _e1402, (_e1402 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1389 == 1023u));
                                        let _e1408 = ((10u * _e249) & 31u);
                                        let _e1411 = ((_e1349.member[0] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1419 = bitcast<f32>((bitcast<u32>(((_e665.member.member_1[2] - _e665.member.member[2]) * 0.0009775171f)) ^ _e120));
                                        let _e1424 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1411)) - 8388608f) * _e1419)) ^ _e120)));
                                        let _e1428 = select(select(_e665.member.member_1[2], _e1424, (_e1424 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1411 == 1023u));
                                        let _e1431 = ((_e1349.member[1] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1439 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1431)) - 8388608f) * _e1375)) ^ _e120)));
                                        let _e1443 = select(select(_e665.member.member_1[0], _e1439, (_e1439 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1431 == 1023u));
                                        let _e1446 = ((_e1349.member[1] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1454 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1446)) - 8388608f) * _e1397)) ^ _e120)));
                                        let _e1458 = select(select(_e665.member.member_1[1], _e1454, (_e1454 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1446 == 1023u));
                                        let _e1461 = ((_e1349.member[1] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1469 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1461)) - 8388608f) * _e1419)) ^ _e120)));
                                        let _e1473 = select(select(_e665.member.member_1[2], _e1469, (_e1469 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1461 == 1023u));
                                        let _e1479 = ((_e1349.member_1[0] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1487 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1479)) - 8388608f) * _e1375)) ^ _e120)));
                                        let _e1491 = select(select(_e665.member.member_1[0], _e1487, (_e1487 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1479 == 1023u));
                                        let _e1494 = ((_e1349.member_1[0] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1502 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1494)) - 8388608f) * _e1397)) ^ _e120)));
                                        let _e1506 = select(select(_e665.member.member_1[1], _e1502, (_e1502 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1494 == 1023u));
                                        let _e1509 = ((_e1349.member_1[0] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1517 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1509)) - 8388608f) * _e1419)) ^ _e120)));
                                        let _e1521 = select(select(_e665.member.member_1[2], _e1517, (_e1517 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1509 == 1023u));
                                        let _e1524 = ((_e1349.member_1[1] >> bitcast<u32>(_e1364)) & 1023u);
                                        let _e1532 = (_e665.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1524)) - 8388608f) * _e1375)) ^ _e120)));
                                        let _e1536 = select(select(_e665.member.member_1[0], _e1532, (_e1532 < _e665.member.member_1[0])), _e665.member.member_1[0], (_e1524 == 1023u));
                                        let _e1539 = ((_e1349.member_1[1] >> bitcast<u32>(_e1386)) & 1023u);
                                        let _e1547 = (_e665.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1539)) - 8388608f) * _e1397)) ^ _e120)));
                                        let _e1551 = select(select(_e665.member.member_1[1], _e1547, (_e1547 < _e665.member.member_1[1])), _e665.member.member_1[1], (_e1539 == 1023u));
                                        let _e1554 = ((_e1349.member_1[1] >> bitcast<u32>(_e1408)) & 1023u);
                                        let _e1562 = (_e665.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1554)) - 8388608f) * _e1419)) ^ _e120)));
                                        let _e1566 = select(select(_e665.member.member_1[2], _e1562, (_e1562 < _e665.member.member_1[2])), _e665.member.member_1[2], (_e1554 == 1023u));
                                        let _e1571 = type_51(type_43(array<f32, 3>(_e1384, _e1406, _e1428), array<f32, 3>(_e1443, _e1458, _e1473)), _e1349.member_2);
                                        let _e1576 = type_51(type_43(array<f32, 3>(_e1491, _e1506, _e1521), array<f32, 3>(_e1536, _e1551, _e1566)), _e1349.member_3);
                                        let _e1582 = ((_e1384 - _e350) * _e353);
                                        let _e1583 = ((_e1491 - _e350) * _e353);
                                        let _e1584 = ((_e1443 - _e351) * _e353);
                                        let _e1585 = ((_e1536 - _e351) * _e353);
                                        let _e1590 = ((_e1406 - _e416) * _e419);
                                        let _e1591 = ((_e1506 - _e416) * _e419);
                                        let _e1592 = ((_e1458 - _e417) * _e419);
                                        let _e1593 = ((_e1551 - _e417) * _e419);
                                        let _e1598 = ((_e1428 - _e482) * _e485);
                                        let _e1599 = ((_e1521 - _e482) * _e485);
                                        let _e1600 = ((_e1473 - _e483) * _e485);
                                        let _e1601 = ((_e1566 - _e483) * _e485);
                                        let _e1603 = select(_e1600, _e1598, (_e1598 < _e1600));
                                        let _e1605 = select(_e1601, _e1599, (_e1599 < _e1601));
                                        let _e1607 = select(_e1600, _e1598, (_e1598 > _e1600));
                                        let _e1609 = select(_e1601, _e1599, (_e1599 > _e1601));
                                        let _e1611 = select(_e1584, _e1582, (_e1582 < _e1584));
                                        let _e1613 = select(_e1585, _e1583, (_e1583 < _e1585));
                                        let _e1615 = select(_e1592, _e1590, (_e1590 < _e1592));
                                        let _e1617 = select(_e1593, _e1591, (_e1591 < _e1593));
                                        let _e1619 = select(_e1615, _e1611, (_e1611 > _e1615));
                                        let _e1621 = select(_e1617, _e1613, (_e1613 > _e1617));
                                        let _e1623 = select(_e1603, _e1619, (_e1619 > _e1603));
                                        let _e1625 = select(_e1605, _e1621, (_e1621 > _e1605));
                                        let _e1627 = select(_e1584, _e1582, (_e1582 > _e1584));
                                        let _e1629 = select(_e1585, _e1583, (_e1583 > _e1585));
                                        let _e1631 = select(_e1592, _e1590, (_e1590 > _e1592));
                                        let _e1633 = select(_e1593, _e1591, (_e1591 > _e1593));
                                        let _e1635 = select(_e1631, _e1627, (_e1627 < _e1631));
                                        let _e1637 = select(_e1633, _e1629, (_e1629 < _e1633));
                                        let _e1642 = -(_e1603);
                                        let _e1643 = -(_e1605);
                                        let _e1650 = (select(_e1607, _e1635, (_e1635 < _e1607)) + (select(_e1642, _e1607, (_e1607 > _e1642)) * 0.0000019073523f));
                                        let _e1651 = (select(_e1609, _e1637, (_e1637 < _e1609)) + (select(_e1643, _e1609, (_e1609 > _e1643)) * 0.0000019073523f));
                                        let _e1653 = select(_e588, _e1623, (_e1623 > _e588));
                                        let _e1655 = select(_e588, _e1625, (_e1625 > _e588));
                                        let _e1660 = (_e1653 <= select(_e1344.member_1, _e1650, (_e1650 < _e1344.member_1)));
                                        let _e1661 = (_e1655 <= select(_e1344.member_1, _e1651, (_e1651 < _e1344.member_1)));
                                        let _e1662 = (_e1653 <= _e1655);
                                        if _e1660 {
                                            if _e1661 {
                                                if _e1662 {
                                                    phi_3318_ = _e1576;
                                                } else {
                                                    phi_3318_ = _e1571;
                                                }
                                                let _e1664 = phi_3318_;
                                                let _e1671 = (_e663 % 128u);
                                                let _e1672 = (_e1671 < 128u);
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_6[_e1671] = _e1664.member_1;
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_5[_e1671] = _e1664.member.member[0];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_4[_e1671] = _e1664.member.member[1];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_3[_e1671] = _e1664.member.member[2];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_2[_e1671] = _e1664.member.member_1[0];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_1[_e1671] = _e1664.member.member_1[1];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local[_e1671] = _e1664.member.member_1[2];
                                                if _e1672 {
                                                } else {
                                                    phi_4000_ = true;
                                                    break;
                                                }
                                                local_7[_e1671] = select(_e1653, _e1655, _e1662);
                                                if _e1662 {
                                                    phi_3394_ = _e1571;
                                                } else {
                                                    phi_3394_ = _e1576;
                                                }
                                                let _e1689 = phi_3394_;
                                                phi_3395_ = (_e663 + 1u);
                                                phi_3396_ = _e1689;
                                            } else {
                                                phi_3395_ = u32();
                                                phi_3396_ = type_51();
                                            }
                                            let _e1691 = phi_3395_;
                                            let _e1693 = phi_3396_;
                                            phi_3398_ = _e1691;
                                            phi_3399_ = _e1693;
                                            phi_3400_ = select(true, false, _e1661);
                                        } else {
                                            phi_3398_ = u32();
                                            phi_3399_ = type_51();
                                            phi_3400_ = true;
                                        }
                                        let _e1696 = phi_3398_;
                                        let _e1698 = phi_3399_;
                                        let _e1700 = phi_3400_;
                                        if _e1700 {
                                            if _e1660 {
                                                phi_3407_ = _e1571;
                                            } else {
                                                phi_3407_ = _e1576;
                                            }
                                            let _e1702 = phi_3407_;
                                            phi_3412_ = select(_e1661, true, _e1660);
                                            phi_3414_ = _e1702;
                                        } else {
                                            phi_3412_ = _e661;
                                            phi_3414_ = _e1698;
                                        }
                                        let _e1705 = phi_3412_;
                                        let _e1707 = phi_3414_;
                                        phi_3418_ = _e1705;
                                        phi_3419_ = select(_e1696, _e663, _e1700);
                                        phi_3420_ = _e1707;
                                    }
                                    let _e1710 = phi_3418_;
                                    let _e1712 = phi_3419_;
                                    let _e1714 = phi_3420_;
                                    if _e669 {
                                        phi_3430_ = _e665;
                                    } else {
                                        phi_3430_ = _e1714;
                                    }
                                    let _e1716 = phi_3430_;
                                    phi_4003_ = _e1342;
                                    phi_3431_ = _e1344;
                                    phi_3432_ = (_e624 - 1u);
                                    phi_3433_ = select(_e1710, false, _e669);
                                    phi_3434_ = select(_e1712, _e663, _e669);
                                    phi_3435_ = _e1716;
                                } else {
                                    phi_4003_ = _e620;
                                    phi_3431_ = _e622;
                                    phi_3432_ = _e624;
                                    phi_3433_ = _e661;
                                    phi_3434_ = _e663;
                                    phi_3435_ = _e665;
                                }
                                let _e1720 = phi_4003_;
                                let _e1722 = phi_3431_;
                                let _e1724 = phi_3432_;
                                let _e1726 = phi_3433_;
                                let _e1728 = phi_3434_;
                                let _e1730 = phi_3435_;
                                phi_4002_ = _e1720;
                                phi_3436_ = _e1722;
                                phi_3437_ = _e1724;
                                phi_3438_ = _e1726;
                                phi_3439_ = _e1728;
                                phi_3440_ = _e1730;
                            } else {
                                phi_4002_ = _e620;
                                phi_3436_ = type_29();
                                phi_3437_ = u32();
                                phi_3438_ = bool();
                                phi_3439_ = u32();
                                phi_3440_ = type_51();
                            }
                            let _e1732 = phi_4002_;
                            let _e1734 = phi_3436_;
                            let _e1736 = phi_3437_;
                            let _e1738 = phi_3438_;
                            let _e1740 = phi_3439_;
                            let _e1742 = phi_3440_;
                            phi_4001_ = _e1732;
                            phi_1122_ = _e1734;
                            phi_1125_ = _e1736;
                            phi_1127_ = _e1738;
                            phi_1129_ = _e1740;
                            phi_1131_ = _e1742;
                            phi_3441_ = _e634;
                        } else {
                            phi_4001_ = _e620;
                            phi_1122_ = type_29();
                            phi_1125_ = u32();
                            phi_1127_ = bool();
                            phi_1129_ = u32();
                            phi_1131_ = type_51();
                            phi_3441_ = false;
                        }
                        let _e1744 = phi_4001_;
                        let _e1746 = phi_1122_;
                        let _e1748 = phi_1125_;
                        let _e1750 = phi_1127_;
                        let _e1752 = phi_1129_;
                        let _e1754 = phi_1131_;
                        let _e1756 = phi_3441_;
                        continue;
                        continuing {
                            phi_3823_ = _e1744;
                            phi_1121_ = _e1746;
                            phi_1124_ = _e1748;
                            phi_1126_ = _e1750;
                            phi_1128_ = _e1752;
                            phi_1130_ = _e1754;
                            phi_4000_ = _e1744;
                            break if !(_e1756);
                        }
                    }
                    let _e1759 = phi_4000_;
                    if _e1759 {
                        break;
                    }
                    let _e1761 = local_10;
                    if (_e1761.member.member_3 != 4294967295u) {
                        let _e1766 = -(_e490);
                        let _e1767 = bitcast<u32>(_e1761.member.member);
                        let _e1771 = (bitcast<i32>((_e1767 >> bitcast<u32>(23i))) & 255i);
                        let _e1772 = (_e1771 + _e1766);
                        if (_e1771 == 255i) {
                            phi_3500_ = _e1761.member.member;
                        } else {
                            if (_e1771 > 0i) {
                                if (_e1772 > 0i) {
                                    let _e1776 = (_e1772 < 255i);
                                    if _e1776 {
                                        phi_3479_ = bitcast<f32>((_e1767 + bitcast<u32>((_e1766 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3479_ = f32();
                                    }
                                    let _e1783 = phi_3479_;
                                    phi_3481_ = _e1783;
                                    phi_3482_ = select(true, false, _e1776);
                                } else {
                                    phi_3481_ = f32();
                                    phi_3482_ = true;
                                }
                                let _e1786 = phi_3481_;
                                let _e1788 = phi_3482_;
                                phi_3483_ = _e1786;
                                phi_3484_ = _e1788;
                            } else {
                                phi_3483_ = f32();
                                phi_3484_ = true;
                            }
                            let _e1790 = phi_3483_;
                            let _e1792 = phi_3484_;
                            if _e1792 {
                                let _e1793 = (_e1767 & 2147483648u);
                                let _e1800 = ((_e1767 & 8388607u) | (select(0u, 1u, ((_e1767 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1804 = (_e1800 == 0u);
                                if _e1804 {
                                    phi_3787_ = bitcast<f32>(_e1793);
                                } else {
                                    let _e1809 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1800)), 32u, _e1804) - 8u);
                                    let _e1812 = (_e1800 << bitcast<u32>((_e1809 & 31u)));
                                    let _e1814 = ((_e1772 + select(0i, 1i, (_e1771 == 0i))) - bitcast<i32>(_e1809));
                                    if (_e1814 >= 255i) {
                                        phi_3777_ = bitcast<f32>((_e1793 | 2139095040u));
                                        phi_3778_ = f32();
                                        phi_3779_ = true;
                                    } else {
                                        let _e1816 = (_e1814 > 0i);
                                        if _e1816 {
                                            phi_3771_ = bitcast<f32>(((_e1793 | (bitcast<u32>(_e1814) << bitcast<u32>(23i))) | (_e1812 & 8388607u)));
                                            phi_3772_ = f32();
                                        } else {
                                            if (_e1814 < -24i) {
                                                phi_3737_ = 26u;
                                            } else {
                                                phi_3737_ = bitcast<u32>((1i - _e1814));
                                            }
                                            let _e1821 = phi_3737_;
                                            let _e1822 = (_e1821 & 31u);
                                            let _e1824 = (_e1812 >> bitcast<u32>(_e1822));
                                            let _e1828 = (_e1812 & ((1u << bitcast<u32>(_e1822)) - 1u));
                                            let _e1832 = (1u << bitcast<u32>(((_e1821 - 1u) & 31u)));
                                            if (_e1828 > _e1832) {
                                                phi_3758_ = true;
                                            } else {
                                                if (_e1828 == _e1832) {
                                                    phi_3755_ = ((_e1824 & 1u) == 1u);
                                                } else {
                                                    phi_3755_ = false;
                                                }
                                                let _e1838 = phi_3755_;
                                                phi_3758_ = _e1838;
                                            }
                                            let _e1840 = phi_3758_;
                                            phi_3771_ = f32();
                                            phi_3772_ = bitcast<f32>((_e1793 | (_e1824 + select(0u, 1u, _e1840))));
                                        }
                                        let _e1853 = phi_3771_;
                                        let _e1855 = phi_3772_;
                                        phi_3777_ = _e1853;
                                        phi_3778_ = _e1855;
                                        phi_3779_ = _e1816;
                                    }
                                    let _e1859 = phi_3777_;
                                    let _e1861 = phi_3778_;
                                    let _e1863 = phi_3779_;
                                    phi_3787_ = select(_e1861, _e1859, _e1863);
                                }
                                let _e1867 = phi_3787_;
                                phi_3499_ = _e1867;
                            } else {
                                phi_3499_ = _e1790;
                            }
                            let _e1869 = phi_3499_;
                            phi_3500_ = _e1869;
                        }
                        let _e1871 = phi_3500_;
                        let _e1872 = bitcast<u32>(_e1871);
                        if ((_e1872 & 2147483647u) >= 2139095040u) {
                            phi_3512_ = bitcast<f32>(((_e1872 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3512_ = _e1871;
                        }
                        let _e1879 = phi_3512_;
                        phi_3517_ = type_18(_e1879, _e1761.member.member_1, _e1761.member.member_2, _e1761.member.member_3);
                    } else {
                        phi_3517_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1884 = phi_3517_;
                    if _e136 {
                    } else {
                        break;
                    }
                    global_5.member[_e134] = _e1884;
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
