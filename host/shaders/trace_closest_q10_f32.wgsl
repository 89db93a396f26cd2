struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_38 {
    member: type_25,
    member_1: f32,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_43 {
    member: array<type_29>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_46;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_43;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_27;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_492_: i32;
    var phi_493_: i32;
    var phi_503_: bool;
    var phi_513_: u32;
    var phi_514_: u32;
    var phi_516_: bool;
    var phi_521_: u32;
    var phi_534_: i32;
    var phi_554_: i32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_697_: f32;
    var phi_703_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_868_: f32;
    var phi_874_: f32;
    var phi_993_: i32;
    var phi_1015_: u32;
    var phi_1016_: u32;
    var phi_1053_: i32;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_4072_: bool;
    var phi_1181_: type_38;
    var phi_1184_: u32;
    var phi_1186_: bool;
    var phi_1188_: u32;
    var phi_1190_: type_51;
    var phi_1201_: bool;
    var phi_1287_: bool;
    var phi_1288_: u32;
    var phi_1289_: type_51;
    var phi_1307_: type_38;
    var phi_1310_: type_4;
    var phi_1311_: type_4;
    var phi_1333_: type_4;
    var phi_1354_: u32;
    var phi_1446_: array<array<f32, 3>, 3>;
    var phi_3633_: bool;
    var phi_3648_: bool;
    var phi_3663_: bool;
    var phi_3678_: bool;
    var phi_3693_: bool;
    var phi_3708_: bool;
    var phi_1988_: f32;
    var phi_1989_: f32;
    var phi_1990_: f32;
    var phi_1991_: f32;
    var phi_1992_: vec3<f32>;
    var phi_1993_: vec3<f32>;
    var phi_1994_: vec3<f32>;
    var phi_1995_: vec3<f32>;
    var phi_3723_: bool;
    var phi_3738_: bool;
    var phi_3753_: bool;
    var phi_3768_: bool;
    var phi_3783_: bool;
    var phi_3798_: bool;
    var phi_2203_: f32;
    var phi_2223_: type_41;
    var phi_2224_: type_41;
    var phi_2227_: type_41;
    var phi_2228_: type_41;
    var phi_2229_: bool;
    var phi_2233_: type_41;
    var phi_2242_: type_25;
    var phi_2267_: bool;
    var phi_2268_: bool;
    var phi_2274_: type_38;
    var phi_2275_: type_38;
    var phi_2276_: type_38;
    var phi_1308_: type_38;
    var phi_4066_: bool;
    var phi_4317_: bool;
    var phi_2277_: type_38;
    var phi_3004_: u32;
    var phi_3005_: u32;
    var phi_3015_: u32;
    var phi_3017_: u32;
    var phi_3018_: bool;
    var phi_3038_: u32;
    var phi_3039_: u32;
    var phi_3043_: type_52;
    var phi_3405_: type_51;
    var phi_3481_: type_51;
    var phi_3482_: u32;
    var phi_3483_: type_51;
    var phi_3485_: u32;
    var phi_3486_: type_51;
    var phi_3487_: bool;
    var phi_3496_: type_51;
    var phi_3501_: bool;
    var phi_3503_: type_51;
    var phi_3507_: bool;
    var phi_3508_: u32;
    var phi_3509_: type_51;
    var phi_3519_: type_51;
    var phi_4234_: bool;
    var phi_3520_: type_38;
    var phi_3521_: u32;
    var phi_3522_: bool;
    var phi_3523_: u32;
    var phi_3524_: type_51;
    var phi_4233_: bool;
    var phi_3525_: type_38;
    var phi_3526_: u32;
    var phi_3527_: bool;
    var phi_3528_: u32;
    var phi_3529_: type_51;
    var phi_4232_: bool;
    var phi_1182_: type_38;
    var phi_1185_: u32;
    var phi_1187_: bool;
    var phi_1189_: u32;
    var phi_1191_: type_51;
    var phi_3530_: bool;
    var phi_4231_: bool;
    var local_10: type_38;
    var phi_3568_: f32;
    var phi_3570_: f32;
    var phi_3571_: bool;
    var phi_3572_: f32;
    var phi_3573_: bool;
    var phi_3974_: u32;
    var phi_3992_: bool;
    var phi_3995_: bool;
    var phi_4008_: f32;
    var phi_4009_: f32;
    var phi_4014_: f32;
    var phi_4015_: f32;
    var phi_4016_: bool;
    var phi_4024_: f32;
    var phi_3588_: f32;
    var phi_3589_: f32;
    var phi_3601_: f32;
    var phi_3606_: type_25;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_4.member));
            let _e96 = arrayLength((&global_2.member));
            let _e104 = global_3.member[0u][0u];
            let _e108 = global_3.member[0u][1u];
            let _e112 = global_3.member[0u][2u];
            let _e116 = global_3.member[0u][3u];
            let _e120 = global_3.member[1u][0u];
            let _e124 = global_3.member[1u][1u];
            let _e128 = global_3.member[1u][2u];
            let _e131 = global_1.member[0u];
            let _e132 = bitcast<i32>(_e131);
            let _e144 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e116) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e104), bitcast<i32>(_e108), bitcast<i32>(_e112));
            local = array<i32, 3>(bitcast<i32>(_e120), bitcast<i32>(_e124), bitcast<i32>(_e128));
            let _e150 = (_e92.x + (_e92.y * 2097152u));
            let _e151 = (_e150 < arrayLength((&global_5.member)));
            if _e151 {
                let _e152 = (_e150 < arrayLength((&global_6.member)));
                if _e152 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e160 = global_5.member[_e150].member_2[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_5.member[_e150].member_2[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_5.member[_e150].member_2[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_5.member[_e150].member[0u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_5.member[_e150].member[1u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e195 = global_5.member[_e150].member[2u];
                    let _e197 = (bitcast<u32>(_e195) & 2147483647u);
                    let _e199 = select(_e169, _e162, (_e169 < _e162));
                    let _e201 = select(_e176, _e199, (_e176 < _e199));
                    let _e203 = select(_e183, _e201, (_e183 < _e201));
                    let _e205 = select(_e190, _e203, (_e190 < _e203));
                    let _e207 = select(_e197, _e205, (_e197 < _e205));
                    let _e211 = global_5.member[_e150].member_1;
                    let _e212 = bitcast<u32>(_e211);
                    let _e213 = (_e212 & 2147483647u);
                    let _e220 = global_5.member[_e150].member_3;
                    let _e221 = bitcast<u32>(_e220);
                    let _e222 = (_e221 & 2147483647u);
                    let _e226 = (((select(_e213, _e207, (_e213 < _e207)) < 2139095040u) && (_e222 <= 2139095040u)) && (_e201 > 0u));
                    if _e226 {
                        let _e229 = (bitcast<u32>(bitcast<f32>(_e201)) & 2147483647u);
                        if (_e229 >= 8388608u) {
                            phi_492_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_492_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_492_;
                        phi_493_ = _e243;
                    } else {
                        phi_493_ = 0i;
                    }
                    let _e245 = phi_493_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_503_ = true;
                    } else {
                        phi_503_ = (_e169 == _e201);
                    }
                    let _e249 = phi_503_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_513_ = _e251;
                        phi_514_ = _e251;
                        phi_516_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_513_ = u32();
                        phi_514_ = 0u;
                        phi_516_ = true;
                    }
                    let _e255 = phi_513_;
                    let _e257 = phi_514_;
                    let _e259 = phi_516_;
                    if _e259 {
                        phi_521_ = (_e257 + 1u);
                    } else {
                        phi_521_ = 0u;
                    }
                    let _e263 = phi_521_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_534_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_554_ = -126i;
                    } else {
                        phi_554_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_554_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_5.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_572_ = _e302[0];
                    } else {
                        phi_572_ = _e302[1];
                    }
                    let _e307 = phi_572_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_578_ = _e302[2];
                    } else {
                        phi_578_ = _e307;
                    }
                    let _e311 = phi_578_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_5.member[_e150].member_2;
                    if _e303 {
                        phi_618_ = _e329[0];
                    } else {
                        phi_618_ = _e329[1];
                    }
                    let _e333 = phi_618_;
                    if _e308 {
                        phi_624_ = _e329[2];
                    } else {
                        phi_624_ = _e333;
                    }
                    let _e336 = phi_624_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e360 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e361 = (_e360 * 0.00000011920929f);
                    let _e364 = select(select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f)), 0f, _e357);
                    let _e365 = select(0f, _e353, _e357);
                    let _e366 = (_e328 + _e364);
                    let _e367 = (_e328 - _e364);
                    let _e369 = select(38685626000000000000000000f, (1f / _e353), _e357);
                    let _e370 = (_e263 == 0u);
                    if _e370 {
                        phi_697_ = _e302[0];
                    } else {
                        phi_697_ = _e302[1];
                    }
                    let _e374 = phi_697_;
                    let _e375 = (_e263 == 2u);
                    if _e375 {
                        phi_703_ = _e302[2];
                    } else {
                        phi_703_ = _e374;
                    }
                    let _e378 = phi_703_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e395 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * _e275) * select(0.00000011920929f, 1f, _e381)) * _e281);
                    if _e370 {
                        phi_743_ = _e329[0];
                    } else {
                        phi_743_ = _e329[1];
                    }
                    let _e399 = phi_743_;
                    if _e375 {
                        phi_749_ = _e329[2];
                    } else {
                        phi_749_ = _e399;
                    }
                    let _e402 = phi_749_;
                    let _e403 = bitcast<u32>(_e402);
                    let _e405 = ((_e403 & 2139095040u) != 0u);
                    let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e292) * select(0.00000011920929f, 1f, _e405)) * _e298);
                    let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e426 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                    let _e427 = (_e426 * 0.00000011920929f);
                    let _e430 = select(select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f)), 0f, _e423);
                    let _e431 = select(0f, _e419, _e423);
                    let _e432 = (_e395 + _e430);
                    let _e433 = (_e395 - _e430);
                    let _e435 = select(38685626000000000000000000f, (1f / _e419), _e423);
                    let _e436 = (_e265 == 0u);
                    if _e436 {
                        phi_822_ = _e302[0];
                    } else {
                        phi_822_ = _e302[1];
                    }
                    let _e440 = phi_822_;
                    let _e441 = (_e265 == 2u);
                    if _e441 {
                        phi_828_ = _e302[2];
                    } else {
                        phi_828_ = _e440;
                    }
                    let _e444 = phi_828_;
                    let _e445 = bitcast<u32>(_e444);
                    let _e447 = ((_e445 & 2139095040u) != 0u);
                    let _e461 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e445 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e445 & 2147483648u))), _e444, _e447) * _e275) * select(0.00000011920929f, 1f, _e447)) * _e281);
                    if _e436 {
                        phi_868_ = _e329[0];
                    } else {
                        phi_868_ = _e329[1];
                    }
                    let _e465 = phi_868_;
                    if _e441 {
                        phi_874_ = _e329[2];
                    } else {
                        phi_874_ = _e465;
                    }
                    let _e468 = phi_874_;
                    let _e469 = bitcast<u32>(_e468);
                    let _e471 = ((_e469 & 2139095040u) != 0u);
                    let _e485 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e469 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e469 & 2147483648u))), _e468, _e471) * _e292) * select(0.00000011920929f, 1f, _e471)) * _e298);
                    let _e489 = (bitcast<f32>((bitcast<u32>(_e485) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e492 = bitcast<f32>((bitcast<u32>(_e461) & 2147483647u));
                    let _e493 = (_e492 * 0.00000011920929f);
                    let _e496 = select(select(0.00000000000011368684f, _e493, (_e493 > 0.00000000000011368684f)), 0f, _e489);
                    let _e497 = select(0f, _e485, _e489);
                    let _e498 = (_e461 + _e496);
                    let _e499 = (_e461 - _e496);
                    let _e501 = select(38685626000000000000000000f, (1f / _e485), _e489);
                    let _e503 = select(_e426, _e360, (_e360 > _e426));
                    let _e506 = (_e132 + _e245);
                    if (_e226 && (select(_e492, _e503, (_e503 > _e492)) <= 1099511600000f)) {
                        let _e516 = ((_e213 & 8388607u) | (select(0u, 1u, ((_e213 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e519 = bitcast<i32>((_e213 >> bitcast<u32>(23i)));
                        let _e523 = (_e516 == 0u);
                        let _e526 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e516)), 32u, _e523)) - 8i);
                        if (_e519 == 255i) {
                            phi_993_ = 255i;
                        } else {
                            phi_993_ = (((_e519 + select(0i, 1i, (_e519 == 0i))) - _e526) + _e506);
                        }
                        let _e534 = phi_993_;
                        let _e544 = (_e534 <= 0i);
                        if _e544 {
                            phi_1016_ = u32();
                        } else {
                            if _e523 {
                                phi_1015_ = u32();
                            } else {
                                phi_1015_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | ((_e516 << bitcast<u32>(((_e526 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e534 >= 255i));
                            }
                            let _e548 = phi_1015_;
                            phi_1016_ = _e548;
                        }
                        let _e550 = phi_1016_;
                        let _e562 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e565 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e569 = (_e562 == 0u);
                        let _e572 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e562)), 32u, _e569)) - 8i);
                        if (_e565 == 255i) {
                            phi_1053_ = 255i;
                        } else {
                            phi_1053_ = (((_e565 + select(0i, 1i, (_e565 == 0i))) - _e572) + _e506);
                        }
                        let _e580 = phi_1053_;
                        let _e590 = (_e580 <= 0i);
                        if _e590 {
                            phi_1076_ = u32();
                        } else {
                            if _e569 {
                                phi_1075_ = u32();
                            } else {
                                phi_1075_ = select(((bitcast<u32>(_e580) << bitcast<u32>(23i)) | ((_e562 << bitcast<u32>(((_e572 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e580 >= 255i));
                            }
                            let _e594 = phi_1075_;
                            phi_1076_ = _e594;
                        }
                        let _e596 = phi_1076_;
                        phi_1084_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e596, 0u, select(_e569, true, _e590))));
                        phi_1085_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e550, 0u, select(_e523, true, _e544))));
                    } else {
                        phi_1084_ = 0f;
                        phi_1085_ = 1f;
                    }
                    let _e602 = phi_1084_;
                    let _e604 = phi_1085_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e608 = (_e264 % 3u);
                    let _e609 = (_e608 < 3u);
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e611 = local_1[_e608];
                    let _e614 = (_e263 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e265 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    if _e609 {
                    } else {
                        break;
                    }
                    let _e628 = local[_e608];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e614];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e620];
                    phi_4072_ = false;
                    phi_1181_ = type_38(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e602);
                    phi_1184_ = ((3u * _e94) + 1u);
                    phi_1186_ = (_e604 <= _e602);
                    phi_1188_ = 0u;
                    phi_1190_ = type_51(type_33(vec4<f32>((f32(_e611) * _e144), (f32(_e617) * _e144), (f32(_e623) * _e144), 0f), vec4<f32>((f32(_e628) * _e144), (f32(_e632) * _e144), (f32(_e636) * _e144), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    loop {
                        let _e646 = phi_4072_;
                        let _e648 = phi_1181_;
                        let _e650 = phi_1184_;
                        let _e652 = phi_1186_;
                        let _e654 = phi_1188_;
                        let _e656 = phi_1190_;
                        local_10 = _e648;
                        if _e652 {
                            phi_1201_ = true;
                        } else {
                            phi_1201_ = (_e654 > 0u);
                        }
                        let _e659 = phi_1201_;
                        if _e659 {
                            let _e660 = (_e650 > 0u);
                            if _e660 {
                                if _e652 {
                                    phi_1287_ = _e652;
                                    phi_1288_ = _e654;
                                    phi_1289_ = _e656;
                                } else {
                                    let _e661 = (_e654 - 1u);
                                    let _e662 = (_e661 % 128u);
                                    let _e663 = (_e662 < 128u);
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e665 = local_7[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e667 = local_6[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e669 = local_5[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e671 = local_4[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e673 = local_3[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e675 = local_2[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e680 = local_8[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4231_ = true;
                                        break;
                                    }
                                    let _e683 = local_9[_e662];
                                    phi_1287_ = (_e683 <= _e648.member_1);
                                    phi_1288_ = _e661;
                                    phi_1289_ = type_51(type_33(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                }
                                let _e687 = phi_1287_;
                                let _e689 = phi_1288_;
                                let _e691 = phi_1289_;
                                if _e687 {
                                    let _e695 = ((_e691.member_1 & 2147483648u) != 0u);
                                    if _e695 {
                                        phi_1307_ = _e648;
                                        phi_1310_ = type_4(0u, ((_e691.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e702 = phi_1307_;
                                            let _e704 = phi_1310_;
                                            local_11 = _e702;
                                            if (_e704.member < _e704.member_1) {
                                                phi_1311_ = type_4((_e704.member + 1u), _e704.member_1);
                                                phi_1333_ = type_4(1u, _e704.member);
                                            } else {
                                                phi_1311_ = _e704;
                                                phi_1333_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e717 = phi_1311_;
                                            let _e719 = phi_1333_;
                                            let _e723 = (bitcast<i32>(_e719.member) != 0i);
                                            if _e723 {
                                                let _e724 = ((_e691.member_1 & 268435455u) + _e719.member_1);
                                                let _e725 = (_e724 < _e96);
                                                if _e725 {
                                                    if _e725 {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e729 = global_2.member[_e724].member_1;
                                                    phi_1354_ = _e729;
                                                } else {
                                                    phi_1354_ = 4294967295u;
                                                }
                                                let _e731 = phi_1354_;
                                                if (_e724 >= _e96) {
                                                    phi_1446_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e725 {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    if (_e608 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e738 = global_2.member[_e724].member[_e608];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e744 = global_2.member[_e724].member[_e614];
                                                    if (_e620 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e750 = global_2.member[_e724].member[_e620];
                                                    let _e752 = (3u + _e608);
                                                    if (_e752 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e758 = global_2.member[_e724].member[_e752];
                                                    let _e759 = (3u + _e614);
                                                    if (_e759 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e765 = global_2.member[_e724].member[_e759];
                                                    let _e766 = (3u + _e620);
                                                    if (_e766 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e772 = global_2.member[_e724].member[_e766];
                                                    let _e774 = (6u + _e608);
                                                    if (_e774 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e780 = global_2.member[_e724].member[_e774];
                                                    let _e781 = (6u + _e614);
                                                    if (_e781 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e787 = global_2.member[_e724].member[_e781];
                                                    let _e788 = (6u + _e620);
                                                    if (_e788 < 9u) {
                                                    } else {
                                                        phi_4066_ = true;
                                                        break;
                                                    }
                                                    let _e794 = global_2.member[_e724].member[_e788];
                                                    phi_1446_ = array<array<f32, 3>, 3>(array<f32, 3>(_e738, _e744, _e750), array<f32, 3>(_e758, _e765, _e772), array<f32, 3>(_e780, _e787, _e794));
                                                }
                                                let _e798 = phi_1446_;
                                                let _e814 = (_e798[0][2] - _e461);
                                                let _e817 = (((_e798[0][0] - _e328) * _e497) - (_e814 * _e365));
                                                let _e820 = (((_e798[0][1] - _e395) * _e497) - (_e814 * _e431));
                                                let _e823 = (_e798[1][2] - _e461);
                                                let _e826 = (((_e798[1][0] - _e328) * _e497) - (_e823 * _e365));
                                                let _e829 = (((_e798[1][1] - _e395) * _e497) - (_e823 * _e431));
                                                let _e832 = (_e798[2][2] - _e461);
                                                let _e835 = (((_e798[2][0] - _e328) * _e497) - (_e832 * _e365));
                                                let _e838 = (((_e798[2][1] - _e395) * _e497) - (_e832 * _e431));
                                                let _e839 = (_e835 * _e829);
                                                let _e840 = (_e838 * _e826);
                                                let _e841 = (_e817 * _e838);
                                                let _e842 = (_e820 * _e835);
                                                let _e843 = (_e826 * _e820);
                                                let _e844 = (_e829 * _e817);
                                                let _e849 = (((_e839 >= _e840) && (_e841 >= _e842)) && (_e843 >= _e844));
                                                let _e855 = (_e849 || (((_e839 <= _e840) && (_e841 <= _e842)) && (_e843 <= _e844)));
                                                if _e855 {
                                                    let _e857 = select(-1f, 1f, _e849);
                                                    let _e859 = ((_e839 - _e840) * _e857);
                                                    let _e861 = select(0f, _e859, (_e859 > 0f));
                                                    let _e863 = ((_e841 - _e842) * _e857);
                                                    let _e865 = select(0f, _e863, (_e863 > 0f));
                                                    let _e867 = ((_e843 - _e844) * _e857);
                                                    let _e869 = select(0f, _e867, (_e867 > 0f));
                                                    let _e871 = ((_e861 + _e865) + _e869);
                                                    let _e873 = select(_e798[1][0], _e798[0][0], (_e798[0][0] < _e798[1][0]));
                                                    let _e877 = select(_e798[1][0], _e798[0][0], (_e798[0][0] > _e798[1][0]));
                                                    let _e881 = select(_e798[1][1], _e798[0][1], (_e798[0][1] < _e798[1][1]));
                                                    let _e885 = select(_e798[1][1], _e798[0][1], (_e798[0][1] > _e798[1][1]));
                                                    let _e889 = select(_e798[1][2], _e798[0][2], (_e798[0][2] < _e798[1][2]));
                                                    let _e893 = select(_e798[1][2], _e798[0][2], (_e798[0][2] > _e798[1][2]));
                                                    let _e898 = ((select(_e798[2][0], _e873, (_e873 < _e798[2][0])) - _e366) * _e369);
                                                    let _e899 = ((select(_e798[2][0], _e877, (_e877 > _e798[2][0])) - _e367) * _e369);
                                                    let _e902 = ((select(_e798[2][1], _e881, (_e881 < _e798[2][1])) - _e432) * _e435);
                                                    let _e903 = ((select(_e798[2][1], _e885, (_e885 > _e798[2][1])) - _e433) * _e435);
                                                    let _e906 = ((select(_e798[2][2], _e889, (_e889 < _e798[2][2])) - _e498) * _e501);
                                                    let _e907 = ((select(_e798[2][2], _e893, (_e893 > _e798[2][2])) - _e499) * _e501);
                                                    let _e909 = select(_e907, _e906, (_e906 < _e907));
                                                    let _e911 = select(_e907, _e906, (_e906 > _e907));
                                                    let _e913 = select(_e899, _e898, (_e898 < _e899));
                                                    let _e915 = select(_e903, _e902, (_e902 < _e903));
                                                    let _e917 = select(_e915, _e913, (_e913 > _e915));
                                                    let _e919 = select(_e909, _e917, (_e917 > _e909));
                                                    let _e921 = select(_e899, _e898, (_e898 > _e899));
                                                    let _e923 = select(_e903, _e902, (_e902 > _e903));
                                                    let _e925 = select(_e923, _e921, (_e921 < _e923));
                                                    let _e927 = select(_e911, _e925, (_e925 < _e911));
                                                    let _e928 = -(_e909);
                                                    let _e934 = select(_e604, _e919, (_e919 > _e604));
                                                    let _e938 = select(_e826, _e817, (_e817 < _e826));
                                                    let _e943 = select(_e826, _e817, (_e817 > _e826));
                                                    let _e950 = select(_e829, _e820, (_e820 < _e829));
                                                    let _e955 = select(_e829, _e820, (_e820 > _e829));
                                                    let _e964 = (((((_e855 && (_e871 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e835, _e938, (_e938 < _e835)) <= 0f) && (select(_e835, _e943, (_e943 > _e835)) >= 0f))) && ((select(_e838, _e950, (_e950 < _e838)) <= 0f) && (select(_e838, _e955, (_e955 > _e838)) >= 0f))) && (_e934 <= (_e927 + (select(_e928, _e911, (_e911 > _e928)) * 0.0000019073523f)))) && (_e934 <= _e702.member_1));
                                                    if _e964 {
                                                        let _e969 = (_e798[1][0] - _e798[0][0]);
                                                        let _e970 = (_e798[1][1] - _e798[0][1]);
                                                        let _e971 = (_e798[1][2] - _e798[0][2]);
                                                        let _e972 = vec3<f32>(_e969, _e970, _e971);
                                                        let _e973 = (_e798[2][0] - _e798[1][0]);
                                                        let _e974 = (_e798[2][1] - _e798[1][1]);
                                                        let _e975 = (_e798[2][2] - _e798[1][2]);
                                                        let _e976 = vec3<f32>(_e973, _e974, _e975);
                                                        let _e977 = (_e798[0][0] - _e798[2][0]);
                                                        let _e978 = (_e798[0][1] - _e798[2][1]);
                                                        let _e979 = (_e798[0][2] - _e798[2][2]);
                                                        let _e980 = vec3<f32>(_e977, _e978, _e979);
                                                        let _e981 = abs(_e969);
                                                        let _e982 = abs(_e970);
                                                        if (_e981 != _e981) {
                                                            phi_3633_ = true;
                                                        } else {
                                                            phi_3633_ = (_e982 >= _e981);
                                                        }
                                                        let _e986 = phi_3633_;
                                                        let _e987 = select(_e981, _e982, _e986);
                                                        let _e988 = abs(_e971);
                                                        if (_e987 != _e987) {
                                                            phi_3648_ = true;
                                                        } else {
                                                            phi_3648_ = (_e988 >= _e987);
                                                        }
                                                        let _e992 = phi_3648_;
                                                        let _e993 = select(_e987, _e988, _e992);
                                                        let _e994 = abs(_e973);
                                                        let _e995 = abs(_e974);
                                                        if (_e994 != _e994) {
                                                            phi_3663_ = true;
                                                        } else {
                                                            phi_3663_ = (_e995 >= _e994);
                                                        }
                                                        let _e999 = phi_3663_;
                                                        let _e1000 = select(_e994, _e995, _e999);
                                                        let _e1001 = abs(_e975);
                                                        if (_e1000 != _e1000) {
                                                            phi_3678_ = true;
                                                        } else {
                                                            phi_3678_ = (_e1001 >= _e1000);
                                                        }
                                                        let _e1005 = phi_3678_;
                                                        let _e1006 = select(_e1000, _e1001, _e1005);
                                                        let _e1007 = abs(_e977);
                                                        let _e1008 = abs(_e978);
                                                        if (_e1007 != _e1007) {
                                                            phi_3693_ = true;
                                                        } else {
                                                            phi_3693_ = (_e1008 >= _e1007);
                                                        }
                                                        let _e1012 = phi_3693_;
                                                        let _e1013 = select(_e1007, _e1008, _e1012);
                                                        let _e1014 = abs(_e979);
                                                        if (_e1013 != _e1013) {
                                                            phi_3708_ = true;
                                                        } else {
                                                            phi_3708_ = (_e1014 >= _e1013);
                                                        }
                                                        let _e1018 = phi_3708_;
                                                        let _e1019 = select(_e1013, _e1014, _e1018);
                                                        let _e1021 = select(_e1006, _e993, (_e993 > _e1006));
                                                        let _e1023 = select(_e1019, _e1021, (_e1021 > _e1019));
                                                        if (_e993 == _e1023) {
                                                            phi_1988_ = _e829;
                                                            phi_1989_ = _e826;
                                                            phi_1990_ = _e820;
                                                            phi_1991_ = _e817;
                                                            phi_1992_ = vec3<f32>(_e798[0][0], _e798[0][1], _e798[0][2]);
                                                            phi_1993_ = _e980;
                                                            phi_1994_ = _e976;
                                                            phi_1995_ = _e972;
                                                        } else {
                                                            let _e1025 = (_e1006 == _e1023);
                                                            let _e1030 = vec3(_e1025);
                                                            phi_1988_ = select(_e820, _e838, _e1025);
                                                            phi_1989_ = select(_e817, _e835, _e1025);
                                                            phi_1990_ = select(_e838, _e829, _e1025);
                                                            phi_1991_ = select(_e835, _e826, _e1025);
                                                            phi_1992_ = select(vec3<f32>(_e798[2][0], _e798[2][1], _e798[2][2]), vec3<f32>(_e798[1][0], _e798[1][1], _e798[1][2]), _e1030);
                                                            phi_1993_ = select(_e976, _e972, _e1030);
                                                            phi_1994_ = select(_e972, _e980, _e1030);
                                                            phi_1995_ = select(_e980, _e976, _e1030);
                                                        }
                                                        let _e1036 = phi_1988_;
                                                        let _e1038 = phi_1989_;
                                                        let _e1040 = phi_1990_;
                                                        let _e1042 = phi_1991_;
                                                        let _e1044 = phi_1992_;
                                                        let _e1046 = phi_1993_;
                                                        let _e1048 = phi_1994_;
                                                        let _e1050 = phi_1995_;
                                                        let _e1057 = ((_e1048.y * _e1046.z) - (_e1046.y * _e1048.z));
                                                        let _e1062 = ((_e1048.z * _e1046.x) - (_e1046.z * _e1048.x));
                                                        let _e1065 = ((_e1048.x * _e1046.y) - (_e1046.x * _e1048.y));
                                                        let _e1068 = ((_e861 >= _e865) && (_e861 >= _e869));
                                                        let _e1069 = (_e865 >= _e869);
                                                        let _e1083 = (((_e1057 * (select(select(_e798[2][0], _e798[1][0], _e1069), _e798[0][0], _e1068) - _e328)) + (_e1062 * (select(select(_e798[2][1], _e798[1][1], _e1069), _e798[0][1], _e1068) - _e395))) + (_e1065 * (select(select(_e798[2][2], _e798[1][2], _e1069), _e798[0][2], _e1068) - _e461)));
                                                        let _e1088 = (((_e1057 * _e365) + (_e1062 * _e431)) + (_e1065 * _e497));
                                                        let _e1089 = (_e1038 - _e1042);
                                                        let _e1090 = (_e1036 - _e1040);
                                                        let _e1093 = ((_e1089 * _e1089) + (_e1090 * _e1090));
                                                        let _e1100 = (-(((_e1042 * _e1089) + (_e1040 * _e1090))) / select(0.000000000000000000000000000000000000011754944f, _e1093, (_e1093 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1102 = select(1f, _e1100, (_e1100 < 1f));
                                                        let _e1104 = select(0f, _e1102, (_e1102 > 0f));
                                                        let _e1113 = ((_e1044.x + (_e1050.x * _e1104)) - _e328);
                                                        let _e1116 = ((_e1044.y + (_e1050.y * _e1104)) - _e395);
                                                        let _e1119 = ((_e1044.z + (_e1050.z * _e1104)) - _e461);
                                                        let _e1122 = bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u));
                                                        let _e1125 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                        let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                        let _e1130 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                        let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                        let _e1136 = abs(_e1057);
                                                        let _e1137 = abs(_e1062);
                                                        if (_e1136 != _e1136) {
                                                            phi_3723_ = true;
                                                        } else {
                                                            phi_3723_ = (_e1137 >= _e1136);
                                                        }
                                                        let _e1141 = phi_3723_;
                                                        let _e1142 = select(_e1136, _e1137, _e1141);
                                                        let _e1143 = abs(_e1065);
                                                        if (_e1142 != _e1142) {
                                                            phi_3738_ = true;
                                                        } else {
                                                            phi_3738_ = (_e1143 >= _e1142);
                                                        }
                                                        let _e1147 = phi_3738_;
                                                        let _e1163 = abs(_e1048.x);
                                                        let _e1164 = abs(_e1048.y);
                                                        if (_e1163 != _e1163) {
                                                            phi_3753_ = true;
                                                        } else {
                                                            phi_3753_ = (_e1164 >= _e1163);
                                                        }
                                                        let _e1168 = phi_3753_;
                                                        let _e1169 = select(_e1163, _e1164, _e1168);
                                                        let _e1170 = abs(_e1048.z);
                                                        if (_e1169 != _e1169) {
                                                            phi_3768_ = true;
                                                        } else {
                                                            phi_3768_ = (_e1170 >= _e1169);
                                                        }
                                                        let _e1174 = phi_3768_;
                                                        let _e1177 = abs(_e1046.x);
                                                        let _e1178 = abs(_e1046.y);
                                                        if (_e1177 != _e1177) {
                                                            phi_3783_ = true;
                                                        } else {
                                                            phi_3783_ = (_e1178 >= _e1177);
                                                        }
                                                        let _e1182 = phi_3783_;
                                                        let _e1183 = select(_e1177, _e1178, _e1182);
                                                        let _e1184 = abs(_e1046.z);
                                                        if (_e1183 != _e1183) {
                                                            phi_3798_ = true;
                                                        } else {
                                                            phi_3798_ = (_e1184 >= _e1183);
                                                        }
                                                        let _e1188 = phi_3798_;
                                                        let _e1193 = ((bitcast<f32>((bitcast<u32>(((((_e1057 * _e1113) + (_e1062 * _e1116)) + (_e1065 * _e1119)) - _e1083)) & 2147483647u)) <= ((0.0000009536743f * select(_e1023, _e1132, (_e1132 > _e1023))) * select(_e1142, _e1143, _e1147))) && !((bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u)) <= ((0.0000038146973f * select(_e1169, _e1170, _e1174)) * select(_e1183, _e1184, _e1188)))));
                                                        let _e1194 = (_e1083 / _e1088);
                                                        if (_e964 && !(_e1193)) {
                                                            let _e1197 = (_e1119 / _e497);
                                                            let _e1205 = (((_e1057 * (_e1113 - (_e365 * _e1197))) + (_e1062 * (_e1116 - (_e431 * _e1197)))) / _e1088);
                                                            phi_2203_ = select(select(_e1197, (_e1197 + _e1205), (bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u)) <= _e1023)), _e1194, _e1193);
                                                        } else {
                                                            phi_2203_ = _e1194;
                                                        }
                                                        let _e1214 = phi_2203_;
                                                        let _e1216 = select(_e927, _e1214, (_e1214 < _e927));
                                                        let _e1218 = select(_e919, _e1216, (_e1216 > _e919));
                                                        let _e1219 = (1f / _e871);
                                                        phi_2223_ = type_41(_e1218, (_e865 * _e1219), (_e869 * _e1219), ((_e964 && (_e1218 >= _e604)) && (_e1218 <= _e702.member_1)));
                                                        phi_2224_ = type_41();
                                                    } else {
                                                        phi_2223_ = type_41();
                                                        phi_2224_ = type_41(0f, 0f, 0f, _e964);
                                                    }
                                                    let _e1228 = phi_2223_;
                                                    let _e1230 = phi_2224_;
                                                    phi_2227_ = _e1228;
                                                    phi_2228_ = _e1230;
                                                    phi_2229_ = select(true, false, _e964);
                                                } else {
                                                    phi_2227_ = type_41();
                                                    phi_2228_ = type_41(0f, 0f, 0f, _e855);
                                                    phi_2229_ = true;
                                                }
                                                let _e1233 = phi_2227_;
                                                let _e1235 = phi_2228_;
                                                let _e1237 = phi_2229_;
                                                if _e1237 {
                                                    phi_2233_ = _e1235;
                                                } else {
                                                    phi_2233_ = _e1233;
                                                }
                                                let _e1239 = phi_2233_;
                                                if _e1239.member_3 {
                                                    phi_2242_ = type_25(_e1239.member, _e1239.member_1, _e1239.member_2, _e731);
                                                } else {
                                                    phi_2242_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1246 = phi_2242_;
                                                if (_e1246.member_3 != 4294967295u) {
                                                    if (_e731 != 4294967295u) {
                                                        if (_e1246.member < _e702.member.member) {
                                                            phi_2268_ = true;
                                                        } else {
                                                            if (_e1246.member == _e702.member.member) {
                                                                phi_2267_ = (_e1246.member_3 < _e702.member.member_3);
                                                            } else {
                                                                phi_2267_ = false;
                                                            }
                                                            let _e1259 = phi_2267_;
                                                            phi_2268_ = _e1259;
                                                        }
                                                        let _e1261 = phi_2268_;
                                                        if _e1261 {
                                                            phi_2274_ = type_38(_e1246, _e1246.member);
                                                        } else {
                                                            phi_2274_ = _e702;
                                                        }
                                                        let _e1264 = phi_2274_;
                                                        phi_2275_ = _e1264;
                                                    } else {
                                                        phi_2275_ = _e702;
                                                    }
                                                    let _e1266 = phi_2275_;
                                                    phi_2276_ = _e1266;
                                                } else {
                                                    phi_2276_ = _e702;
                                                }
                                                let _e1268 = phi_2276_;
                                                phi_1308_ = _e1268;
                                            } else {
                                                phi_1308_ = type_38();
                                            }
                                            let _e1270 = phi_1308_;
                                            continue;
                                            continuing {
                                                phi_1307_ = _e1270;
                                                phi_1310_ = _e717;
                                                phi_4066_ = _e646;
                                                break if !(_e723);
                                            }
                                        }
                                        let _e1273 = phi_4066_;
                                        phi_4231_ = _e1273;
                                        if _e1273 {
                                            break;
                                        }
                                        phi_4317_ = _e1273;
                                        let _e1977 = local_11;
                                        phi_2277_ = _e1977;
                                    } else {
                                        phi_4317_ = _e646;
                                        phi_2277_ = _e648;
                                    }
                                    let _e1275 = phi_4317_;
                                    let _e1277 = phi_2277_;
                                    if _e695 {
                                        phi_3507_ = bool();
                                        phi_3508_ = u32();
                                        phi_3509_ = type_51();
                                    } else {
                                        if (_e691.member_1 >= _e94) {
                                            phi_3043_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e691.member_1 < _e94) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1281 = ((1u + _e264) % 4u);
                                            if (_e1281 < 4u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1286 = global_4.member[_e691.member_1][_e1281];
                                            let _e1288 = (_e1286 >> bitcast<u32>(11u));
                                            let _e1290 = ((1u + _e263) % 4u);
                                            if (_e1290 < 4u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1295 = global_4.member[_e691.member_1][_e1290];
                                            let _e1297 = (_e1295 >> bitcast<u32>(11u));
                                            let _e1299 = ((1u + _e265) % 4u);
                                            if (_e1299 < 4u) {
                                            } else {
                                                phi_4231_ = true;
                                                break;
                                            }
                                            let _e1304 = global_4.member[_e691.member_1][_e1299];
                                            let _e1306 = (_e1304 >> bitcast<u32>(11u));
                                            let _e1329 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.x - _e691.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1330 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.y - _e691.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1331 = (bitcast<f32>((bitcast<u32>((_e691.member.member_1.z - _e691.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1333 = select(_e144, _e1329, (_e1329 > _e144));
                                            let _e1335 = select(_e144, _e1330, (_e1330 > _e144));
                                            let _e1337 = select(_e144, _e1331, (_e1331 > _e144));
                                            let _e1368 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1286 & 1023u))) - 8388608f) * _e1333));
                                            let _e1373 = (bitcast<i32>((_e1286 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1376 = bitcast<f32>((_e1368 & bitcast<u32>(_e1373)));
                                            let _e1377 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1295 & 1023u))) - 8388608f) * _e1335));
                                            let _e1382 = (bitcast<i32>((_e1295 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1385 = bitcast<f32>((_e1377 & bitcast<u32>(_e1382)));
                                            let _e1386 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1304 & 1023u))) - 8388608f) * _e1337));
                                            let _e1391 = (bitcast<i32>((_e1304 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1394 = bitcast<f32>((_e1386 & bitcast<u32>(_e1391)));
                                            let _e1398 = bitcast<f32>((_e1368 & bitcast<u32>(~(_e1373))));
                                            let _e1402 = bitcast<f32>((_e1377 & bitcast<u32>(~(_e1382))));
                                            let _e1406 = bitcast<f32>((_e1386 & bitcast<u32>(~(_e1391))));
                                            let _e1407 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1288 & 1023u))) - 8388608f) * _e1333));
                                            let _e1412 = (bitcast<i32>((_e1288 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1415 = bitcast<f32>((_e1407 & bitcast<u32>(_e1412)));
                                            let _e1416 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1297 & 1023u))) - 8388608f) * _e1335));
                                            let _e1421 = (bitcast<i32>((_e1297 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1424 = bitcast<f32>((_e1416 & bitcast<u32>(_e1421)));
                                            let _e1425 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1306 & 1023u))) - 8388608f) * _e1337));
                                            let _e1430 = (bitcast<i32>((_e1306 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1433 = bitcast<f32>((_e1425 & bitcast<u32>(_e1430)));
                                            let _e1437 = bitcast<f32>((_e1407 & bitcast<u32>(~(_e1412))));
                                            let _e1441 = bitcast<f32>((_e1416 & bitcast<u32>(~(_e1421))));
                                            let _e1445 = bitcast<f32>((_e1425 & bitcast<u32>(~(_e1430))));
                                            let _e1475 = global_4.member[_e691.member_1][0u];
                                            let _e1479 = global_4.member[_e691.member_1][1u];
                                            let _e1483 = global_4.member[_e691.member_1][2u];
                                            let _e1487 = global_4.member[_e691.member_1][3u];
                                            let _e1499 = (((_e1479 >> bitcast<u32>(22i)) | ((_e1483 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1487 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1500 = (_e1475 & 268435455u);
                                            let _e1501 = (_e1499 & 268435455u);
                                            let _e1504 = ((_e1475 >> bitcast<u32>(28u)) & 7u);
                                            let _e1512 = ((_e1475 >> bitcast<u32>(31i)) | (((_e1499 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1513 = (_e1504 != 0u);
                                            if (_e1504 == 0u) {
                                                phi_3005_ = _e1500;
                                            } else {
                                                if (_e1504 == 7u) {
                                                    phi_3004_ = 2147483648u;
                                                } else {
                                                    phi_3004_ = ((2147483648u | (_e1504 << bitcast<u32>(28u))) | (_e1501 & 268435455u));
                                                }
                                                let _e1522 = phi_3004_;
                                                phi_3005_ = _e1522;
                                            }
                                            let _e1524 = phi_3005_;
                                            if _e1513 {
                                                let _e1525 = (_e1504 != 7u);
                                                if _e1525 {
                                                    phi_3015_ = (_e1501 + _e1504);
                                                } else {
                                                    phi_3015_ = u32();
                                                }
                                                let _e1528 = phi_3015_;
                                                phi_3017_ = _e1528;
                                                phi_3018_ = select(true, false, _e1525);
                                            } else {
                                                phi_3017_ = u32();
                                                phi_3018_ = true;
                                            }
                                            let _e1531 = phi_3017_;
                                            let _e1533 = phi_3018_;
                                            if (_e1512 == 0u) {
                                                phi_3039_ = (_e1500 + select(0u, 1u, !(_e1513)));
                                            } else {
                                                if (_e1512 == 7u) {
                                                    phi_3038_ = 2147483648u;
                                                } else {
                                                    phi_3038_ = ((2147483648u | (_e1512 << bitcast<u32>(28u))) | (select(_e1531, _e1501, _e1533) & 268435455u));
                                                }
                                                let _e1546 = phi_3038_;
                                                phi_3039_ = _e1546;
                                            }
                                            let _e1548 = phi_3039_;
                                            phi_3043_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e691.member.member.x + _e1376), (_e691.member.member.x + _e1398), (_e691.member.member_1.x - _e1415), (_e691.member.member_1.x - _e1437)), vec4<f32>((_e691.member.member.y + _e1385), (_e691.member.member.y + _e1402), (_e691.member.member_1.y - _e1424), (_e691.member.member_1.y - _e1441)), vec4<f32>((_e691.member.member.z + _e1394), (_e691.member.member.z + _e1406), (_e691.member.member_1.z - _e1433), (_e691.member.member_1.z - _e1445))), type_51(type_33((_e691.member.member + vec4<f32>(_e1376, _e1385, _e1394, 0f)), (_e691.member.member_1 - vec4<f32>(_e1415, _e1424, _e1433, 0f))), _e1524), type_51(type_33((_e691.member.member + vec4<f32>(_e1398, _e1402, _e1406, 0f)), (_e691.member.member_1 - vec4<f32>(_e1437, _e1441, _e1445, 0f))), _e1548));
                                        }
                                        let _e1553 = phi_3043_;
                                        let _e1565 = ((_e1553.member[0].x - _e366) * _e369);
                                        let _e1566 = ((_e1553.member[0].y - _e366) * _e369);
                                        let _e1567 = ((_e1553.member[0].z - _e367) * _e369);
                                        let _e1568 = ((_e1553.member[0].w - _e367) * _e369);
                                        let _e1578 = ((_e1553.member[1].x - _e432) * _e435);
                                        let _e1579 = ((_e1553.member[1].y - _e432) * _e435);
                                        let _e1580 = ((_e1553.member[1].z - _e433) * _e435);
                                        let _e1581 = ((_e1553.member[1].w - _e433) * _e435);
                                        let _e1591 = ((_e1553.member[2].x - _e498) * _e501);
                                        let _e1592 = ((_e1553.member[2].y - _e498) * _e501);
                                        let _e1593 = ((_e1553.member[2].z - _e499) * _e501);
                                        let _e1594 = ((_e1553.member[2].w - _e499) * _e501);
                                        let _e1596 = select(_e1593, _e1591, (_e1591 < _e1593));
                                        let _e1598 = select(_e1594, _e1592, (_e1592 < _e1594));
                                        let _e1600 = select(_e1593, _e1591, (_e1591 > _e1593));
                                        let _e1602 = select(_e1594, _e1592, (_e1592 > _e1594));
                                        let _e1604 = select(_e1567, _e1565, (_e1565 < _e1567));
                                        let _e1606 = select(_e1568, _e1566, (_e1566 < _e1568));
                                        let _e1608 = select(_e1580, _e1578, (_e1578 < _e1580));
                                        let _e1610 = select(_e1581, _e1579, (_e1579 < _e1581));
                                        let _e1612 = select(_e1608, _e1604, (_e1604 > _e1608));
                                        let _e1614 = select(_e1610, _e1606, (_e1606 > _e1610));
                                        let _e1616 = select(_e1596, _e1612, (_e1612 > _e1596));
                                        let _e1618 = select(_e1598, _e1614, (_e1614 > _e1598));
                                        let _e1620 = select(_e1567, _e1565, (_e1565 > _e1567));
                                        let _e1622 = select(_e1568, _e1566, (_e1566 > _e1568));
                                        let _e1624 = select(_e1580, _e1578, (_e1578 > _e1580));
                                        let _e1626 = select(_e1581, _e1579, (_e1579 > _e1581));
                                        let _e1628 = select(_e1624, _e1620, (_e1620 < _e1624));
                                        let _e1630 = select(_e1626, _e1622, (_e1622 < _e1626));
                                        let _e1635 = -(_e1596);
                                        let _e1636 = -(_e1598);
                                        let _e1643 = (select(_e1600, _e1628, (_e1628 < _e1600)) + (select(_e1635, _e1600, (_e1600 > _e1635)) * 0.0000019073523f));
                                        let _e1644 = (select(_e1602, _e1630, (_e1630 < _e1602)) + (select(_e1636, _e1602, (_e1602 > _e1636)) * 0.0000019073523f));
                                        let _e1646 = select(_e604, _e1616, (_e1616 > _e604));
                                        let _e1648 = select(_e604, _e1618, (_e1618 > _e604));
                                        let _e1653 = (_e1646 <= select(_e1277.member_1, _e1643, (_e1643 < _e1277.member_1)));
                                        let _e1654 = (_e1648 <= select(_e1277.member_1, _e1644, (_e1644 < _e1277.member_1)));
                                        let _e1655 = (_e1646 <= _e1648);
                                        if _e1653 {
                                            if _e1654 {
                                                if _e1655 {
                                                    phi_3405_ = _e1553.member_2;
                                                } else {
                                                    phi_3405_ = _e1553.member_1;
                                                }
                                                let _e1659 = phi_3405_;
                                                let _e1680 = (_e689 % 128u);
                                                let _e1681 = (_e1680 < 128u);
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_8[_e1680] = _e1659.member_1;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_7[_e1680] = _e1659.member.member.x;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_6[_e1680] = _e1659.member.member.y;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_5[_e1680] = _e1659.member.member.z;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_4[_e1680] = _e1659.member.member_1.x;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_3[_e1680] = _e1659.member.member_1.y;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_2[_e1680] = _e1659.member.member_1.z;
                                                if _e1681 {
                                                } else {
                                                    phi_4231_ = true;
                                                    break;
                                                }
                                                local_9[_e1680] = select(_e1646, _e1648, _e1655);
                                                if _e1655 {
                                                    phi_3481_ = _e1553.member_1;
                                                } else {
                                                    phi_3481_ = _e1553.member_2;
                                                }
                                                let _e1694 = phi_3481_;
                                                phi_3482_ = (_e689 + 1u);
                                                phi_3483_ = _e1694;
                                            } else {
                                                phi_3482_ = u32();
                                                phi_3483_ = type_51();
                                            }
                                            let _e1696 = phi_3482_;
                                            let _e1698 = phi_3483_;
                                            phi_3485_ = _e1696;
                                            phi_3486_ = _e1698;
                                            phi_3487_ = select(true, false, _e1654);
                                        } else {
                                            phi_3485_ = u32();
                                            phi_3486_ = type_51();
                                            phi_3487_ = true;
                                        }
                                        let _e1701 = phi_3485_;
                                        let _e1703 = phi_3486_;
                                        let _e1705 = phi_3487_;
                                        if _e1705 {
                                            if _e1653 {
                                                phi_3496_ = _e1553.member_1;
                                            } else {
                                                phi_3496_ = _e1553.member_2;
                                            }
                                            let _e1709 = phi_3496_;
                                            phi_3501_ = select(_e1654, true, _e1653);
                                            phi_3503_ = _e1709;
                                        } else {
                                            phi_3501_ = _e687;
                                            phi_3503_ = _e1703;
                                        }
                                        let _e1712 = phi_3501_;
                                        let _e1714 = phi_3503_;
                                        phi_3507_ = _e1712;
                                        phi_3508_ = select(_e1701, _e689, _e1705);
                                        phi_3509_ = _e1714;
                                    }
                                    let _e1717 = phi_3507_;
                                    let _e1719 = phi_3508_;
                                    let _e1721 = phi_3509_;
                                    if _e695 {
                                        phi_3519_ = _e691;
                                    } else {
                                        phi_3519_ = _e1721;
                                    }
                                    let _e1723 = phi_3519_;
                                    phi_4234_ = _e1275;
                                    phi_3520_ = _e1277;
                                    phi_3521_ = (_e650 - 1u);
                                    phi_3522_ = select(_e1717, false, _e695);
                                    phi_3523_ = select(_e1719, _e689, _e695);
                                    phi_3524_ = _e1723;
                                } else {
                                    phi_4234_ = _e646;
                                    phi_3520_ = _e648;
                                    phi_3521_ = _e650;
                                    phi_3522_ = _e687;
                                    phi_3523_ = _e689;
                                    phi_3524_ = _e691;
                                }
                                let _e1727 = phi_4234_;
                                let _e1729 = phi_3520_;
                                let _e1731 = phi_3521_;
                                let _e1733 = phi_3522_;
                                let _e1735 = phi_3523_;
                                let _e1737 = phi_3524_;
                                phi_4233_ = _e1727;
                                phi_3525_ = _e1729;
                                phi_3526_ = _e1731;
                                phi_3527_ = _e1733;
                                phi_3528_ = _e1735;
                                phi_3529_ = _e1737;
                            } else {
                                phi_4233_ = _e646;
                                phi_3525_ = type_38();
                                phi_3526_ = u32();
                                phi_3527_ = bool();
                                phi_3528_ = u32();
                                phi_3529_ = type_51();
                            }
                            let _e1739 = phi_4233_;
                            let _e1741 = phi_3525_;
                            let _e1743 = phi_3526_;
                            let _e1745 = phi_3527_;
                            let _e1747 = phi_3528_;
                            let _e1749 = phi_3529_;
                            phi_4232_ = _e1739;
                            phi_1182_ = _e1741;
                            phi_1185_ = _e1743;
                            phi_1187_ = _e1745;
                            phi_1189_ = _e1747;
                            phi_1191_ = _e1749;
                            phi_3530_ = _e660;
                        } else {
                            phi_4232_ = _e646;
                            phi_1182_ = type_38();
                            phi_1185_ = u32();
                            phi_1187_ = bool();
                            phi_1189_ = u32();
                            phi_1191_ = type_51();
                            phi_3530_ = false;
                        }
                        let _e1751 = phi_4232_;
                        let _e1753 = phi_1182_;
                        let _e1755 = phi_1185_;
                        let _e1757 = phi_1187_;
                        let _e1759 = phi_1189_;
                        let _e1761 = phi_1191_;
                        let _e1763 = phi_3530_;
                        continue;
                        continuing {
                            phi_4072_ = _e1751;
                            phi_1181_ = _e1753;
                            phi_1184_ = _e1755;
                            phi_1186_ = _e1757;
                            phi_1188_ = _e1759;
                            phi_1190_ = _e1761;
                            phi_4231_ = _e1751;
                            break if !(_e1763);
                        }
                    }
                    let _e1766 = phi_4231_;
                    if _e1766 {
                        break;
                    }
                    let _e1768 = local_10;
                    if (_e1768.member.member_3 != 4294967295u) {
                        let _e1773 = -(_e506);
                        let _e1774 = bitcast<u32>(_e1768.member.member);
                        let _e1778 = (bitcast<i32>((_e1774 >> bitcast<u32>(23i))) & 255i);
                        let _e1779 = (_e1778 + _e1773);
                        if (_e1778 == 255i) {
                            phi_3589_ = _e1768.member.member;
                        } else {
                            if (_e1778 > 0i) {
                                if (_e1779 > 0i) {
                                    let _e1783 = (_e1779 < 255i);
                                    if _e1783 {
                                        phi_3568_ = bitcast<f32>((_e1774 + bitcast<u32>((_e1773 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3568_ = f32();
                                    }
                                    let _e1790 = phi_3568_;
                                    phi_3570_ = _e1790;
                                    phi_3571_ = select(true, false, _e1783);
                                } else {
                                    phi_3570_ = f32();
                                    phi_3571_ = true;
                                }
                                let _e1793 = phi_3570_;
                                let _e1795 = phi_3571_;
                                phi_3572_ = _e1793;
                                phi_3573_ = _e1795;
                            } else {
                                phi_3572_ = f32();
                                phi_3573_ = true;
                            }
                            let _e1797 = phi_3572_;
                            let _e1799 = phi_3573_;
                            if _e1799 {
                                let _e1800 = (_e1774 & 2147483648u);
                                let _e1807 = ((_e1774 & 8388607u) | (select(0u, 1u, ((_e1774 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1811 = (_e1807 == 0u);
                                if _e1811 {
                                    phi_4024_ = bitcast<f32>(_e1800);
                                } else {
                                    let _e1816 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1807)), 32u, _e1811) - 8u);
                                    let _e1819 = (_e1807 << bitcast<u32>((_e1816 & 31u)));
                                    let _e1821 = ((_e1779 + select(0i, 1i, (_e1778 == 0i))) - bitcast<i32>(_e1816));
                                    if (_e1821 >= 255i) {
                                        phi_4014_ = bitcast<f32>((_e1800 | 2139095040u));
                                        phi_4015_ = f32();
                                        phi_4016_ = true;
                                    } else {
                                        let _e1823 = (_e1821 > 0i);
                                        if _e1823 {
                                            phi_4008_ = bitcast<f32>(((_e1800 | (bitcast<u32>(_e1821) << bitcast<u32>(23i))) | (_e1819 & 8388607u)));
                                            phi_4009_ = f32();
                                        } else {
                                            if (_e1821 < -24i) {
                                                phi_3974_ = 26u;
                                            } else {
                                                phi_3974_ = bitcast<u32>((1i - _e1821));
                                            }
                                            let _e1828 = phi_3974_;
                                            let _e1829 = (_e1828 & 31u);
                                            let _e1831 = (_e1819 >> bitcast<u32>(_e1829));
                                            let _e1835 = (_e1819 & ((1u << bitcast<u32>(_e1829)) - 1u));
                                            let _e1839 = (1u << bitcast<u32>(((_e1828 - 1u) & 31u)));
                                            if (_e1835 > _e1839) {
                                                phi_3995_ = true;
                                            } else {
                                                if (_e1835 == _e1839) {
                                                    phi_3992_ = ((_e1831 & 1u) == 1u);
                                                } else {
                                                    phi_3992_ = false;
                                                }
                                                let _e1845 = phi_3992_;
                                                phi_3995_ = _e1845;
                                            }
                                            let _e1847 = phi_3995_;
                                            phi_4008_ = f32();
                                            phi_4009_ = bitcast<f32>((_e1800 | (_e1831 + select(0u, 1u, _e1847))));
                                        }
                                        let _e1860 = phi_4008_;
                                        let _e1862 = phi_4009_;
                                        phi_4014_ = _e1860;
                                        phi_4015_ = _e1862;
                                        phi_4016_ = _e1823;
                                    }
                                    let _e1866 = phi_4014_;
                                    let _e1868 = phi_4015_;
                                    let _e1870 = phi_4016_;
                                    phi_4024_ = select(_e1868, _e1866, _e1870);
                                }
                                let _e1874 = phi_4024_;
                                phi_3588_ = _e1874;
                            } else {
                                phi_3588_ = _e1797;
                            }
                            let _e1876 = phi_3588_;
                            phi_3589_ = _e1876;
                        }
                        let _e1878 = phi_3589_;
                        let _e1879 = bitcast<u32>(_e1878);
                        if ((_e1879 & 2147483647u) >= 2139095040u) {
                            phi_3601_ = bitcast<f32>(((_e1879 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3601_ = _e1878;
                        }
                        let _e1886 = phi_3601_;
                        phi_3606_ = type_25(_e1886, _e1768.member.member_1, _e1768.member.member_2, _e1768.member.member_3);
                    } else {
                        phi_3606_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1891 = phi_3606_;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = _e1891;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
