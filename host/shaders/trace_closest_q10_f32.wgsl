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
    var phi_499_: i32;
    var phi_500_: i32;
    var phi_510_: bool;
    var phi_520_: u32;
    var phi_521_: u32;
    var phi_523_: bool;
    var phi_528_: u32;
    var phi_541_: i32;
    var phi_561_: i32;
    var phi_579_: f32;
    var phi_585_: f32;
    var phi_625_: f32;
    var phi_631_: f32;
    var phi_704_: f32;
    var phi_710_: f32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_829_: f32;
    var phi_835_: f32;
    var phi_875_: f32;
    var phi_881_: f32;
    var phi_1000_: i32;
    var phi_1022_: u32;
    var phi_1023_: u32;
    var phi_1060_: i32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_4001_: bool;
    var phi_1188_: type_38;
    var phi_1191_: bool;
    var phi_1193_: type_51;
    var phi_1195_: u32;
    var phi_1197_: u32;
    var phi_1208_: bool;
    var phi_1294_: bool;
    var phi_1295_: type_51;
    var phi_1296_: u32;
    var phi_2981_: u32;
    var phi_2982_: u32;
    var phi_2992_: u32;
    var phi_2994_: u32;
    var phi_2995_: bool;
    var phi_3015_: u32;
    var phi_3016_: u32;
    var phi_3020_: type_52;
    var phi_3382_: type_51;
    var phi_3458_: type_51;
    var phi_3459_: type_51;
    var phi_3460_: u32;
    var phi_3462_: type_51;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3473_: type_51;
    var phi_3478_: bool;
    var phi_3479_: type_51;
    var phi_1314_: type_38;
    var phi_1317_: type_4;
    var phi_1318_: type_4;
    var phi_1340_: type_4;
    var phi_1361_: u32;
    var phi_1453_: array<array<f32, 3>, 3>;
    var phi_1983_: f32;
    var phi_1984_: f32;
    var phi_1985_: f32;
    var phi_1986_: f32;
    var phi_1987_: vec3<f32>;
    var phi_1988_: vec3<f32>;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2181_: f32;
    var phi_2201_: type_41;
    var phi_2202_: type_41;
    var phi_2205_: type_41;
    var phi_2206_: type_41;
    var phi_2207_: bool;
    var phi_2211_: type_41;
    var phi_2220_: type_25;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2252_: type_38;
    var phi_2253_: type_38;
    var phi_2254_: type_38;
    var phi_1315_: type_38;
    var phi_3995_: bool;
    var local_10: type_38;
    var phi_4152_: bool;
    var phi_3481_: type_38;
    var phi_3482_: bool;
    var phi_3483_: type_51;
    var phi_3484_: u32;
    var phi_4151_: bool;
    var phi_3485_: type_38;
    var phi_3486_: bool;
    var phi_3487_: type_51;
    var phi_3488_: u32;
    var phi_3489_: u32;
    var phi_4150_: bool;
    var phi_3490_: type_38;
    var phi_3491_: bool;
    var phi_3492_: type_51;
    var phi_3493_: u32;
    var phi_3494_: u32;
    var phi_4149_: bool;
    var phi_1189_: type_38;
    var phi_1192_: bool;
    var phi_1194_: type_51;
    var phi_1196_: u32;
    var phi_1198_: u32;
    var phi_3495_: bool;
    var phi_4148_: bool;
    var local_11: type_38;
    var phi_3533_: f32;
    var phi_3535_: f32;
    var phi_3536_: bool;
    var phi_3537_: f32;
    var phi_3538_: bool;
    var phi_3903_: u32;
    var phi_3921_: bool;
    var phi_3924_: bool;
    var phi_3937_: f32;
    var phi_3938_: f32;
    var phi_3943_: f32;
    var phi_3944_: f32;
    var phi_3945_: bool;
    var phi_3953_: f32;
    var phi_3553_: f32;
    var phi_3554_: f32;
    var phi_3566_: f32;
    var phi_3571_: type_25;
    var local_12: type_38;

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
                            phi_499_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_499_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_499_;
                        phi_500_ = _e243;
                    } else {
                        phi_500_ = 0i;
                    }
                    let _e245 = phi_500_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_510_ = true;
                    } else {
                        phi_510_ = (_e169 == _e201);
                    }
                    let _e249 = phi_510_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_520_ = _e251;
                        phi_521_ = _e251;
                        phi_523_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_520_ = u32();
                        phi_521_ = 0u;
                        phi_523_ = true;
                    }
                    let _e255 = phi_520_;
                    let _e257 = phi_521_;
                    let _e259 = phi_523_;
                    if _e259 {
                        phi_528_ = (_e257 + 1u);
                    } else {
                        phi_528_ = 0u;
                    }
                    let _e263 = phi_528_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_541_ = -126i;
                    } else {
                        phi_541_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_541_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_561_ = -126i;
                    } else {
                        phi_561_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_561_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_5.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_579_ = _e302[0];
                    } else {
                        phi_579_ = _e302[1];
                    }
                    let _e307 = phi_579_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_585_ = _e302[2];
                    } else {
                        phi_585_ = _e307;
                    }
                    let _e311 = phi_585_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_5.member[_e150].member_2;
                    if _e303 {
                        phi_625_ = _e329[0];
                    } else {
                        phi_625_ = _e329[1];
                    }
                    let _e333 = phi_625_;
                    if _e308 {
                        phi_631_ = _e329[2];
                    } else {
                        phi_631_ = _e333;
                    }
                    let _e336 = phi_631_;
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
                        phi_704_ = _e302[0];
                    } else {
                        phi_704_ = _e302[1];
                    }
                    let _e374 = phi_704_;
                    let _e375 = (_e263 == 2u);
                    if _e375 {
                        phi_710_ = _e302[2];
                    } else {
                        phi_710_ = _e374;
                    }
                    let _e378 = phi_710_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e395 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * _e275) * select(0.00000011920929f, 1f, _e381)) * _e281);
                    if _e370 {
                        phi_750_ = _e329[0];
                    } else {
                        phi_750_ = _e329[1];
                    }
                    let _e399 = phi_750_;
                    if _e375 {
                        phi_756_ = _e329[2];
                    } else {
                        phi_756_ = _e399;
                    }
                    let _e402 = phi_756_;
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
                        phi_829_ = _e302[0];
                    } else {
                        phi_829_ = _e302[1];
                    }
                    let _e440 = phi_829_;
                    let _e441 = (_e265 == 2u);
                    if _e441 {
                        phi_835_ = _e302[2];
                    } else {
                        phi_835_ = _e440;
                    }
                    let _e444 = phi_835_;
                    let _e445 = bitcast<u32>(_e444);
                    let _e447 = ((_e445 & 2139095040u) != 0u);
                    let _e461 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e445 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e445 & 2147483648u))), _e444, _e447) * _e275) * select(0.00000011920929f, 1f, _e447)) * _e281);
                    if _e436 {
                        phi_875_ = _e329[0];
                    } else {
                        phi_875_ = _e329[1];
                    }
                    let _e465 = phi_875_;
                    if _e441 {
                        phi_881_ = _e329[2];
                    } else {
                        phi_881_ = _e465;
                    }
                    let _e468 = phi_881_;
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
                            phi_1000_ = 255i;
                        } else {
                            phi_1000_ = (((_e519 + select(0i, 1i, (_e519 == 0i))) - _e526) + _e506);
                        }
                        let _e534 = phi_1000_;
                        let _e544 = (_e534 <= 0i);
                        if _e544 {
                            phi_1023_ = u32();
                        } else {
                            if _e523 {
                                phi_1022_ = u32();
                            } else {
                                phi_1022_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | ((_e516 << bitcast<u32>(((_e526 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e534 >= 255i));
                            }
                            let _e548 = phi_1022_;
                            phi_1023_ = _e548;
                        }
                        let _e550 = phi_1023_;
                        let _e562 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e565 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e569 = (_e562 == 0u);
                        let _e572 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e562)), 32u, _e569)) - 8i);
                        if (_e565 == 255i) {
                            phi_1060_ = 255i;
                        } else {
                            phi_1060_ = (((_e565 + select(0i, 1i, (_e565 == 0i))) - _e572) + _e506);
                        }
                        let _e580 = phi_1060_;
                        let _e590 = (_e580 <= 0i);
                        if _e590 {
                            phi_1083_ = u32();
                        } else {
                            if _e569 {
                                phi_1082_ = u32();
                            } else {
                                phi_1082_ = select(((bitcast<u32>(_e580) << bitcast<u32>(23i)) | ((_e562 << bitcast<u32>(((_e572 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e580 >= 255i));
                            }
                            let _e594 = phi_1082_;
                            phi_1083_ = _e594;
                        }
                        let _e596 = phi_1083_;
                        phi_1091_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e596, 0u, select(_e569, true, _e590))));
                        phi_1092_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e550, 0u, select(_e523, true, _e544))));
                    } else {
                        phi_1091_ = 0f;
                        phi_1092_ = 1f;
                    }
                    let _e602 = phi_1091_;
                    let _e604 = phi_1092_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e610 = (_e264 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_1[_e610];
                    let _e616 = (_e263 % 3u);
                    let _e617 = (_e616 < 3u);
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e619 = local_1[_e616];
                    let _e622 = (_e265 % 3u);
                    let _e623 = (_e622 < 3u);
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e625 = local_1[_e622];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e630 = local[_e610];
                    if _e617 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e616];
                    if _e623 {
                    } else {
                        break;
                    }
                    let _e638 = local[_e622];
                    phi_4001_ = false;
                    phi_1188_ = type_38(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e602);
                    phi_1191_ = (_e604 <= _e602);
                    phi_1193_ = type_51(type_33(vec4<f32>((f32(_e613) * _e144), (f32(_e619) * _e144), (f32(_e625) * _e144), 0f), vec4<f32>((f32(_e630) * _e144), (f32(_e634) * _e144), (f32(_e638) * _e144), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_1195_ = 0u;
                    phi_1197_ = ((3u * _e94) + 1u);
                    loop {
                        let _e646 = phi_4001_;
                        let _e648 = phi_1188_;
                        let _e650 = phi_1191_;
                        let _e652 = phi_1193_;
                        let _e654 = phi_1195_;
                        let _e656 = phi_1197_;
                        local_11 = _e648;
                        if _e650 {
                            phi_1208_ = true;
                        } else {
                            phi_1208_ = (_e654 > 0u);
                        }
                        let _e659 = phi_1208_;
                        if _e659 {
                            let _e660 = (_e656 > 0u);
                            if _e660 {
                                if _e650 {
                                    phi_1294_ = _e650;
                                    phi_1295_ = _e652;
                                    phi_1296_ = _e654;
                                } else {
                                    let _e661 = (_e654 - 1u);
                                    let _e662 = (_e661 % 128u);
                                    let _e663 = (_e662 < 128u);
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e665 = local_7[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e667 = local_6[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e669 = local_5[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e671 = local_4[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e673 = local_3[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e675 = local_2[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e680 = local_8[_e662];
                                    if _e663 {
                                    } else {
                                        phi_4148_ = true;
                                        break;
                                    }
                                    let _e683 = local_9[_e662];
                                    phi_1294_ = (_e683 <= _e648.member_1);
                                    phi_1295_ = type_51(type_33(vec4<f32>(_e665, _e667, _e669, 0f), vec4<f32>(_e671, _e673, _e675, 0f)), _e680);
                                    phi_1296_ = _e661;
                                }
                                let _e687 = phi_1294_;
                                let _e689 = phi_1295_;
                                let _e691 = phi_1296_;
                                if _e687 {
                                    if ((_e689.member_1 & 2147483648u) != 0u) {
                                        phi_1314_ = _e648;
                                        phi_1317_ = type_4(0u, ((_e689.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1140 = phi_1314_;
                                            let _e1142 = phi_1317_;
                                            local_10 = _e1140;
                                            local_12 = _e1140;
                                            if (_e1142.member < _e1142.member_1) {
                                                phi_1318_ = type_4((_e1142.member + 1u), _e1142.member_1);
                                                phi_1340_ = type_4(1u, _e1142.member);
                                            } else {
                                                phi_1318_ = _e1142;
                                                phi_1340_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1155 = phi_1318_;
                                            let _e1157 = phi_1340_;
                                            let _e1161 = (bitcast<i32>(_e1157.member) != 0i);
                                            if _e1161 {
                                                let _e1162 = ((_e689.member_1 & 268435455u) + _e1157.member_1);
                                                let _e1163 = (_e1162 < _e96);
                                                if _e1163 {
                                                    if _e1163 {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1167 = global_2.member[_e1162].member_1;
                                                    phi_1361_ = _e1167;
                                                } else {
                                                    phi_1361_ = 4294967295u;
                                                }
                                                let _e1169 = phi_1361_;
                                                if (_e1162 >= _e96) {
                                                    phi_1453_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1163 {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    if (_e610 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1176 = global_2.member[_e1162].member[_e610];
                                                    if (_e616 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1182 = global_2.member[_e1162].member[_e616];
                                                    if (_e622 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1188 = global_2.member[_e1162].member[_e622];
                                                    let _e1190 = (3u + _e610);
                                                    if (_e1190 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1196 = global_2.member[_e1162].member[_e1190];
                                                    let _e1197 = (3u + _e616);
                                                    if (_e1197 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1203 = global_2.member[_e1162].member[_e1197];
                                                    let _e1204 = (3u + _e622);
                                                    if (_e1204 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1210 = global_2.member[_e1162].member[_e1204];
                                                    let _e1212 = (6u + _e610);
                                                    if (_e1212 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1218 = global_2.member[_e1162].member[_e1212];
                                                    let _e1219 = (6u + _e616);
                                                    if (_e1219 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1225 = global_2.member[_e1162].member[_e1219];
                                                    let _e1226 = (6u + _e622);
                                                    if (_e1226 < 9u) {
                                                    } else {
                                                        phi_3995_ = true;
                                                        break;
                                                    }
                                                    let _e1232 = global_2.member[_e1162].member[_e1226];
                                                    phi_1453_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1176, _e1182, _e1188), array<f32, 3>(_e1196, _e1203, _e1210), array<f32, 3>(_e1218, _e1225, _e1232));
                                                }
                                                let _e1236 = phi_1453_;
                                                let _e1252 = (_e1236[0][2] - _e461);
                                                let _e1255 = (((_e1236[0][0] - _e328) * _e497) - (_e1252 * _e365));
                                                let _e1258 = (((_e1236[0][1] - _e395) * _e497) - (_e1252 * _e431));
                                                let _e1261 = (_e1236[1][2] - _e461);
                                                let _e1264 = (((_e1236[1][0] - _e328) * _e497) - (_e1261 * _e365));
                                                let _e1267 = (((_e1236[1][1] - _e395) * _e497) - (_e1261 * _e431));
                                                let _e1270 = (_e1236[2][2] - _e461);
                                                let _e1273 = (((_e1236[2][0] - _e328) * _e497) - (_e1270 * _e365));
                                                let _e1276 = (((_e1236[2][1] - _e395) * _e497) - (_e1270 * _e431));
                                                let _e1277 = (_e1273 * _e1267);
                                                let _e1278 = (_e1276 * _e1264);
                                                let _e1279 = (_e1255 * _e1276);
                                                let _e1280 = (_e1258 * _e1273);
                                                let _e1281 = (_e1264 * _e1258);
                                                let _e1282 = (_e1267 * _e1255);
                                                let _e1287 = (((_e1277 >= _e1278) && (_e1279 >= _e1280)) && (_e1281 >= _e1282));
                                                let _e1293 = (_e1287 || (((_e1277 <= _e1278) && (_e1279 <= _e1280)) && (_e1281 <= _e1282)));
                                                if _e1293 {
                                                    let _e1295 = select(-1f, 1f, _e1287);
                                                    let _e1297 = ((_e1277 - _e1278) * _e1295);
                                                    let _e1299 = select(0f, _e1297, (_e1297 > 0f));
                                                    let _e1301 = ((_e1279 - _e1280) * _e1295);
                                                    let _e1303 = select(0f, _e1301, (_e1301 > 0f));
                                                    let _e1305 = ((_e1281 - _e1282) * _e1295);
                                                    let _e1307 = select(0f, _e1305, (_e1305 > 0f));
                                                    let _e1309 = ((_e1299 + _e1303) + _e1307);
                                                    let _e1311 = select(_e1236[1][0], _e1236[0][0], (_e1236[0][0] < _e1236[1][0]));
                                                    let _e1315 = select(_e1236[1][0], _e1236[0][0], (_e1236[0][0] > _e1236[1][0]));
                                                    let _e1319 = select(_e1236[1][1], _e1236[0][1], (_e1236[0][1] < _e1236[1][1]));
                                                    let _e1323 = select(_e1236[1][1], _e1236[0][1], (_e1236[0][1] > _e1236[1][1]));
                                                    let _e1327 = select(_e1236[1][2], _e1236[0][2], (_e1236[0][2] < _e1236[1][2]));
                                                    let _e1331 = select(_e1236[1][2], _e1236[0][2], (_e1236[0][2] > _e1236[1][2]));
                                                    let _e1336 = ((select(_e1236[2][0], _e1311, (_e1311 < _e1236[2][0])) - _e366) * _e369);
                                                    let _e1337 = ((select(_e1236[2][0], _e1315, (_e1315 > _e1236[2][0])) - _e367) * _e369);
                                                    let _e1340 = ((select(_e1236[2][1], _e1319, (_e1319 < _e1236[2][1])) - _e432) * _e435);
                                                    let _e1341 = ((select(_e1236[2][1], _e1323, (_e1323 > _e1236[2][1])) - _e433) * _e435);
                                                    let _e1344 = ((select(_e1236[2][2], _e1327, (_e1327 < _e1236[2][2])) - _e498) * _e501);
                                                    let _e1345 = ((select(_e1236[2][2], _e1331, (_e1331 > _e1236[2][2])) - _e499) * _e501);
                                                    let _e1347 = select(_e1345, _e1344, (_e1344 < _e1345));
                                                    let _e1349 = select(_e1345, _e1344, (_e1344 > _e1345));
                                                    let _e1351 = select(_e1337, _e1336, (_e1336 < _e1337));
                                                    let _e1353 = select(_e1341, _e1340, (_e1340 < _e1341));
                                                    let _e1355 = select(_e1353, _e1351, (_e1351 > _e1353));
                                                    let _e1357 = select(_e1347, _e1355, (_e1355 > _e1347));
                                                    let _e1359 = select(_e1337, _e1336, (_e1336 > _e1337));
                                                    let _e1361 = select(_e1341, _e1340, (_e1340 > _e1341));
                                                    let _e1363 = select(_e1361, _e1359, (_e1359 < _e1361));
                                                    let _e1365 = select(_e1349, _e1363, (_e1363 < _e1349));
                                                    let _e1366 = -(_e1347);
                                                    let _e1372 = select(_e604, _e1357, (_e1357 > _e604));
                                                    let _e1376 = select(_e1264, _e1255, (_e1255 < _e1264));
                                                    let _e1381 = select(_e1264, _e1255, (_e1255 > _e1264));
                                                    let _e1388 = select(_e1267, _e1258, (_e1258 < _e1267));
                                                    let _e1393 = select(_e1267, _e1258, (_e1258 > _e1267));
                                                    let _e1402 = (((((_e1293 && (_e1309 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1273, _e1376, (_e1376 < _e1273)) <= 0f) && (select(_e1273, _e1381, (_e1381 > _e1273)) >= 0f))) && ((select(_e1276, _e1388, (_e1388 < _e1276)) <= 0f) && (select(_e1276, _e1393, (_e1393 > _e1276)) >= 0f))) && (_e1372 <= (_e1365 + (select(_e1366, _e1349, (_e1349 > _e1366)) * 0.0000019073523f)))) && (_e1372 <= _e1140.member_1));
                                                    if _e1402 {
                                                        let _e1407 = (_e1236[1][0] - _e1236[0][0]);
                                                        let _e1408 = (_e1236[1][1] - _e1236[0][1]);
                                                        let _e1409 = (_e1236[1][2] - _e1236[0][2]);
                                                        let _e1410 = vec3<f32>(_e1407, _e1408, _e1409);
                                                        let _e1411 = (_e1236[2][0] - _e1236[1][0]);
                                                        let _e1412 = (_e1236[2][1] - _e1236[1][1]);
                                                        let _e1413 = (_e1236[2][2] - _e1236[1][2]);
                                                        let _e1414 = vec3<f32>(_e1411, _e1412, _e1413);
                                                        let _e1415 = (_e1236[0][0] - _e1236[2][0]);
                                                        let _e1416 = (_e1236[0][1] - _e1236[2][1]);
                                                        let _e1417 = (_e1236[0][2] - _e1236[2][2]);
                                                        let _e1418 = vec3<f32>(_e1415, _e1416, _e1417);
                                                        let _e1421 = bitcast<f32>((bitcast<u32>(_e1407) & 2147483647u));
                                                        let _e1424 = bitcast<f32>((bitcast<u32>(_e1408) & 2147483647u));
                                                        let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                        let _e1429 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                        let _e1431 = select(_e1429, _e1426, (_e1426 > _e1429));
                                                        let _e1434 = bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u));
                                                        let _e1437 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                        let _e1439 = select(_e1437, _e1434, (_e1434 > _e1437));
                                                        let _e1442 = bitcast<f32>((bitcast<u32>(_e1413) & 2147483647u));
                                                        let _e1444 = select(_e1442, _e1439, (_e1439 > _e1442));
                                                        let _e1447 = bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u));
                                                        let _e1450 = bitcast<f32>((bitcast<u32>(_e1416) & 2147483647u));
                                                        let _e1452 = select(_e1450, _e1447, (_e1447 > _e1450));
                                                        let _e1455 = bitcast<f32>((bitcast<u32>(_e1417) & 2147483647u));
                                                        let _e1457 = select(_e1455, _e1452, (_e1452 > _e1455));
                                                        let _e1459 = select(_e1444, _e1431, (_e1431 > _e1444));
                                                        let _e1461 = select(_e1457, _e1459, (_e1459 > _e1457));
                                                        if (_e1431 == _e1461) {
                                                            phi_1983_ = _e1267;
                                                            phi_1984_ = _e1264;
                                                            phi_1985_ = _e1258;
                                                            phi_1986_ = _e1255;
                                                            phi_1987_ = vec3<f32>(_e1236[0][0], _e1236[0][1], _e1236[0][2]);
                                                            phi_1988_ = _e1418;
                                                            phi_1989_ = _e1414;
                                                            phi_1990_ = _e1410;
                                                        } else {
                                                            let _e1463 = (_e1444 == _e1461);
                                                            let _e1468 = vec3(_e1463);
                                                            phi_1983_ = select(_e1258, _e1276, _e1463);
                                                            phi_1984_ = select(_e1255, _e1273, _e1463);
                                                            phi_1985_ = select(_e1276, _e1267, _e1463);
                                                            phi_1986_ = select(_e1273, _e1264, _e1463);
                                                            phi_1987_ = select(vec3<f32>(_e1236[2][0], _e1236[2][1], _e1236[2][2]), vec3<f32>(_e1236[1][0], _e1236[1][1], _e1236[1][2]), _e1468);
                                                            phi_1988_ = select(_e1414, _e1410, _e1468);
                                                            phi_1989_ = select(_e1410, _e1418, _e1468);
                                                            phi_1990_ = select(_e1418, _e1414, _e1468);
                                                        }
                                                        let _e1474 = phi_1983_;
                                                        let _e1476 = phi_1984_;
                                                        let _e1478 = phi_1985_;
                                                        let _e1480 = phi_1986_;
                                                        let _e1482 = phi_1987_;
                                                        let _e1484 = phi_1988_;
                                                        let _e1486 = phi_1989_;
                                                        let _e1488 = phi_1990_;
                                                        let _e1495 = ((_e1486.y * _e1484.z) - (_e1484.y * _e1486.z));
                                                        let _e1500 = ((_e1486.z * _e1484.x) - (_e1484.z * _e1486.x));
                                                        let _e1503 = ((_e1486.x * _e1484.y) - (_e1484.x * _e1486.y));
                                                        let _e1506 = ((_e1299 >= _e1303) && (_e1299 >= _e1307));
                                                        let _e1507 = (_e1303 >= _e1307);
                                                        let _e1521 = (((_e1495 * (select(select(_e1236[2][0], _e1236[1][0], _e1507), _e1236[0][0], _e1506) - _e328)) + (_e1500 * (select(select(_e1236[2][1], _e1236[1][1], _e1507), _e1236[0][1], _e1506) - _e395))) + (_e1503 * (select(select(_e1236[2][2], _e1236[1][2], _e1507), _e1236[0][2], _e1506) - _e461)));
                                                        let _e1526 = (((_e1495 * _e365) + (_e1500 * _e431)) + (_e1503 * _e497));
                                                        let _e1527 = (_e1476 - _e1480);
                                                        let _e1528 = (_e1474 - _e1478);
                                                        let _e1531 = ((_e1527 * _e1527) + (_e1528 * _e1528));
                                                        let _e1538 = (-(((_e1480 * _e1527) + (_e1478 * _e1528))) / select(0.000000000000000000000000000000000000011754944f, _e1531, (_e1531 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1540 = select(1f, _e1538, (_e1538 < 1f));
                                                        let _e1542 = select(0f, _e1540, (_e1540 > 0f));
                                                        let _e1551 = ((_e1482.x + (_e1488.x * _e1542)) - _e328);
                                                        let _e1554 = ((_e1482.y + (_e1488.y * _e1542)) - _e395);
                                                        let _e1557 = ((_e1482.z + (_e1488.z * _e1542)) - _e461);
                                                        let _e1560 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                        let _e1563 = bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u));
                                                        let _e1565 = select(_e1563, _e1560, (_e1560 > _e1563));
                                                        let _e1568 = bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u));
                                                        let _e1570 = select(_e1568, _e1565, (_e1565 > _e1568));
                                                        let _e1576 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                        let _e1579 = bitcast<f32>((bitcast<u32>(_e1500) & 2147483647u));
                                                        let _e1581 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                        let _e1584 = bitcast<f32>((bitcast<u32>(_e1503) & 2147483647u));
                                                        let _e1603 = bitcast<f32>((bitcast<u32>(_e1486.x) & 2147483647u));
                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1486.y) & 2147483647u));
                                                        let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                        let _e1611 = bitcast<f32>((bitcast<u32>(_e1486.z) & 2147483647u));
                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1484.x) & 2147483647u));
                                                        let _e1620 = bitcast<f32>((bitcast<u32>(_e1484.y) & 2147483647u));
                                                        let _e1622 = select(_e1620, _e1617, (_e1617 > _e1620));
                                                        let _e1625 = bitcast<f32>((bitcast<u32>(_e1484.z) & 2147483647u));
                                                        let _e1631 = ((bitcast<f32>((bitcast<u32>(((((_e1495 * _e1551) + (_e1500 * _e1554)) + (_e1503 * _e1557)) - _e1521)) & 2147483647u)) <= ((0.0000009536743f * select(_e1461, _e1570, (_e1570 > _e1461))) * select(_e1584, _e1581, (_e1581 > _e1584)))) && !((bitcast<f32>((bitcast<u32>(_e1526) & 2147483647u)) <= ((0.0000038146973f * select(_e1611, _e1608, (_e1608 > _e1611))) * select(_e1625, _e1622, (_e1622 > _e1625))))));
                                                        let _e1632 = (_e1521 / _e1526);
                                                        if (_e1402 && !(_e1631)) {
                                                            let _e1635 = (_e1557 / _e497);
                                                            let _e1643 = (((_e1495 * (_e1551 - (_e365 * _e1635))) + (_e1500 * (_e1554 - (_e431 * _e1635)))) / _e1526);
                                                            phi_2181_ = select(select(_e1635, (_e1635 + _e1643), (bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u)) <= _e1461)), _e1632, _e1631);
                                                        } else {
                                                            phi_2181_ = _e1632;
                                                        }
                                                        let _e1652 = phi_2181_;
                                                        let _e1654 = select(_e1365, _e1652, (_e1652 < _e1365));
                                                        let _e1656 = select(_e1357, _e1654, (_e1654 > _e1357));
                                                        let _e1657 = (1f / _e1309);
                                                        phi_2201_ = type_41(_e1656, (_e1303 * _e1657), (_e1307 * _e1657), ((_e1402 && (_e1656 >= _e604)) && (_e1656 <= _e1140.member_1)));
                                                        phi_2202_ = type_41();
                                                    } else {
                                                        phi_2201_ = type_41();
                                                        phi_2202_ = type_41(0f, 0f, 0f, _e1402);
                                                    }
                                                    let _e1666 = phi_2201_;
                                                    let _e1668 = phi_2202_;
                                                    phi_2205_ = _e1666;
                                                    phi_2206_ = _e1668;
                                                    phi_2207_ = select(true, false, _e1402);
                                                } else {
                                                    phi_2205_ = type_41();
                                                    phi_2206_ = type_41(0f, 0f, 0f, _e1293);
                                                    phi_2207_ = true;
                                                }
                                                let _e1671 = phi_2205_;
                                                let _e1673 = phi_2206_;
                                                let _e1675 = phi_2207_;
                                                if _e1675 {
                                                    phi_2211_ = _e1673;
                                                } else {
                                                    phi_2211_ = _e1671;
                                                }
                                                let _e1677 = phi_2211_;
                                                if _e1677.member_3 {
                                                    phi_2220_ = type_25(_e1677.member, _e1677.member_1, _e1677.member_2, _e1169);
                                                } else {
                                                    phi_2220_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1684 = phi_2220_;
                                                if (_e1684.member_3 != 4294967295u) {
                                                    if (_e1169 != 4294967295u) {
                                                        if (_e1684.member < _e1140.member.member) {
                                                            phi_2246_ = true;
                                                        } else {
                                                            if (_e1684.member == _e1140.member.member) {
                                                                phi_2245_ = (_e1684.member_3 < _e1140.member.member_3);
                                                            } else {
                                                                phi_2245_ = false;
                                                            }
                                                            let _e1697 = phi_2245_;
                                                            phi_2246_ = _e1697;
                                                        }
                                                        let _e1699 = phi_2246_;
                                                        if _e1699 {
                                                            phi_2252_ = type_38(_e1684, _e1684.member);
                                                        } else {
                                                            phi_2252_ = _e1140;
                                                        }
                                                        let _e1702 = phi_2252_;
                                                        phi_2253_ = _e1702;
                                                    } else {
                                                        phi_2253_ = _e1140;
                                                    }
                                                    let _e1704 = phi_2253_;
                                                    phi_2254_ = _e1704;
                                                } else {
                                                    phi_2254_ = _e1140;
                                                }
                                                let _e1706 = phi_2254_;
                                                phi_1315_ = _e1706;
                                            } else {
                                                phi_1315_ = type_38();
                                            }
                                            let _e1708 = phi_1315_;
                                            continue;
                                            continuing {
                                                phi_1314_ = _e1708;
                                                phi_1317_ = _e1155;
                                                phi_3995_ = _e646;
                                                break if !(_e1161);
                                            }
                                        }
                                        let _e1711 = phi_3995_;
                                        phi_4148_ = _e1711;
                                        if _e1711 {
                                            break;
                                        }
                                        let _e1713 = local_10;
                                        phi_4152_ = _e1711;
                                        let _e1985 = local_12;
                                        phi_3481_ = _e1985;
                                        phi_3482_ = false;
                                        phi_3483_ = _e689;
                                        phi_3484_ = select(_e691, 0u, (_e604 > _e1713.member_1));
                                    } else {
                                        if (_e689.member_1 >= _e94) {
                                            phi_3020_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e689.member_1 < _e94) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e703 = ((1u + _e264) % 4u);
                                            if (_e703 < 4u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e708 = global_4.member[_e689.member_1][_e703];
                                            let _e710 = (_e708 >> bitcast<u32>(11u));
                                            let _e712 = ((1u + _e263) % 4u);
                                            if (_e712 < 4u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e717 = global_4.member[_e689.member_1][_e712];
                                            let _e719 = (_e717 >> bitcast<u32>(11u));
                                            let _e721 = ((1u + _e265) % 4u);
                                            if (_e721 < 4u) {
                                            } else {
                                                phi_4148_ = true;
                                                break;
                                            }
                                            let _e726 = global_4.member[_e689.member_1][_e721];
                                            let _e728 = (_e726 >> bitcast<u32>(11u));
                                            let _e751 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.x - _e689.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e752 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.y - _e689.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e753 = (bitcast<f32>((bitcast<u32>((_e689.member.member_1.z - _e689.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e755 = select(_e144, _e751, (_e751 > _e144));
                                            let _e757 = select(_e144, _e752, (_e752 > _e144));
                                            let _e759 = select(_e144, _e753, (_e753 > _e144));
                                            let _e790 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e708 & 1023u))) - 8388608f) * _e755));
                                            let _e795 = (bitcast<i32>((_e708 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                            let _e799 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e717 & 1023u))) - 8388608f) * _e757));
                                            let _e804 = (bitcast<i32>((_e717 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e807 = bitcast<f32>((_e799 & bitcast<u32>(_e804)));
                                            let _e808 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 1023u))) - 8388608f) * _e759));
                                            let _e813 = (bitcast<i32>((_e726 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e816 = bitcast<f32>((_e808 & bitcast<u32>(_e813)));
                                            let _e820 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                            let _e824 = bitcast<f32>((_e799 & bitcast<u32>(~(_e804))));
                                            let _e828 = bitcast<f32>((_e808 & bitcast<u32>(~(_e813))));
                                            let _e829 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e710 & 1023u))) - 8388608f) * _e755));
                                            let _e834 = (bitcast<i32>((_e710 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e837 = bitcast<f32>((_e829 & bitcast<u32>(_e834)));
                                            let _e838 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e719 & 1023u))) - 8388608f) * _e757));
                                            let _e843 = (bitcast<i32>((_e719 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e846 = bitcast<f32>((_e838 & bitcast<u32>(_e843)));
                                            let _e847 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e728 & 1023u))) - 8388608f) * _e759));
                                            let _e852 = (bitcast<i32>((_e728 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e855 = bitcast<f32>((_e847 & bitcast<u32>(_e852)));
                                            let _e859 = bitcast<f32>((_e829 & bitcast<u32>(~(_e834))));
                                            let _e863 = bitcast<f32>((_e838 & bitcast<u32>(~(_e843))));
                                            let _e867 = bitcast<f32>((_e847 & bitcast<u32>(~(_e852))));
                                            let _e897 = global_4.member[_e689.member_1][0u];
                                            let _e901 = global_4.member[_e689.member_1][1u];
                                            let _e905 = global_4.member[_e689.member_1][2u];
                                            let _e909 = global_4.member[_e689.member_1][3u];
                                            let _e921 = (((_e901 >> bitcast<u32>(22i)) | ((_e905 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e909 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e922 = (_e897 & 268435455u);
                                            let _e923 = (_e921 & 268435455u);
                                            let _e926 = ((_e897 >> bitcast<u32>(28u)) & 7u);
                                            let _e934 = ((_e897 >> bitcast<u32>(31i)) | (((_e921 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e935 = (_e926 != 0u);
                                            if (_e926 == 0u) {
                                                phi_2982_ = _e922;
                                            } else {
                                                if (_e926 == 7u) {
                                                    phi_2981_ = 2147483648u;
                                                } else {
                                                    phi_2981_ = ((2147483648u | (_e926 << bitcast<u32>(28u))) | (_e923 & 268435455u));
                                                }
                                                let _e944 = phi_2981_;
                                                phi_2982_ = _e944;
                                            }
                                            let _e946 = phi_2982_;
                                            if _e935 {
                                                let _e947 = (_e926 != 7u);
                                                if _e947 {
                                                    phi_2992_ = (_e923 + _e926);
                                                } else {
                                                    phi_2992_ = u32();
                                                }
                                                let _e950 = phi_2992_;
                                                phi_2994_ = _e950;
                                                phi_2995_ = select(true, false, _e947);
                                            } else {
                                                phi_2994_ = u32();
                                                phi_2995_ = true;
                                            }
                                            let _e953 = phi_2994_;
                                            let _e955 = phi_2995_;
                                            if (_e934 == 0u) {
                                                phi_3016_ = (_e922 + select(0u, 1u, !(_e935)));
                                            } else {
                                                if (_e934 == 7u) {
                                                    phi_3015_ = 2147483648u;
                                                } else {
                                                    phi_3015_ = ((2147483648u | (_e934 << bitcast<u32>(28u))) | (select(_e953, _e923, _e955) & 268435455u));
                                                }
                                                let _e968 = phi_3015_;
                                                phi_3016_ = _e968;
                                            }
                                            let _e970 = phi_3016_;
                                            phi_3020_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e689.member.member.x + _e798), (_e689.member.member.x + _e820), (_e689.member.member_1.x - _e837), (_e689.member.member_1.x - _e859)), vec4<f32>((_e689.member.member.y + _e807), (_e689.member.member.y + _e824), (_e689.member.member_1.y - _e846), (_e689.member.member_1.y - _e863)), vec4<f32>((_e689.member.member.z + _e816), (_e689.member.member.z + _e828), (_e689.member.member_1.z - _e855), (_e689.member.member_1.z - _e867))), type_51(type_33((_e689.member.member + vec4<f32>(_e798, _e807, _e816, 0f)), (_e689.member.member_1 - vec4<f32>(_e837, _e846, _e855, 0f))), _e946), type_51(type_33((_e689.member.member + vec4<f32>(_e820, _e824, _e828, 0f)), (_e689.member.member_1 - vec4<f32>(_e859, _e863, _e867, 0f))), _e970));
                                        }
                                        let _e975 = phi_3020_;
                                        let _e987 = ((_e975.member[0].x - _e366) * _e369);
                                        let _e988 = ((_e975.member[0].y - _e366) * _e369);
                                        let _e989 = ((_e975.member[0].z - _e367) * _e369);
                                        let _e990 = ((_e975.member[0].w - _e367) * _e369);
                                        let _e1000 = ((_e975.member[1].x - _e432) * _e435);
                                        let _e1001 = ((_e975.member[1].y - _e432) * _e435);
                                        let _e1002 = ((_e975.member[1].z - _e433) * _e435);
                                        let _e1003 = ((_e975.member[1].w - _e433) * _e435);
                                        let _e1013 = ((_e975.member[2].x - _e498) * _e501);
                                        let _e1014 = ((_e975.member[2].y - _e498) * _e501);
                                        let _e1015 = ((_e975.member[2].z - _e499) * _e501);
                                        let _e1016 = ((_e975.member[2].w - _e499) * _e501);
                                        let _e1018 = select(_e1015, _e1013, (_e1013 < _e1015));
                                        let _e1020 = select(_e1016, _e1014, (_e1014 < _e1016));
                                        let _e1022 = select(_e1015, _e1013, (_e1013 > _e1015));
                                        let _e1024 = select(_e1016, _e1014, (_e1014 > _e1016));
                                        let _e1026 = select(_e989, _e987, (_e987 < _e989));
                                        let _e1028 = select(_e990, _e988, (_e988 < _e990));
                                        let _e1030 = select(_e1002, _e1000, (_e1000 < _e1002));
                                        let _e1032 = select(_e1003, _e1001, (_e1001 < _e1003));
                                        let _e1034 = select(_e1030, _e1026, (_e1026 > _e1030));
                                        let _e1036 = select(_e1032, _e1028, (_e1028 > _e1032));
                                        let _e1038 = select(_e1018, _e1034, (_e1034 > _e1018));
                                        let _e1040 = select(_e1020, _e1036, (_e1036 > _e1020));
                                        let _e1042 = select(_e989, _e987, (_e987 > _e989));
                                        let _e1044 = select(_e990, _e988, (_e988 > _e990));
                                        let _e1046 = select(_e1002, _e1000, (_e1000 > _e1002));
                                        let _e1048 = select(_e1003, _e1001, (_e1001 > _e1003));
                                        let _e1050 = select(_e1046, _e1042, (_e1042 < _e1046));
                                        let _e1052 = select(_e1048, _e1044, (_e1044 < _e1048));
                                        let _e1057 = -(_e1018);
                                        let _e1058 = -(_e1020);
                                        let _e1065 = (select(_e1022, _e1050, (_e1050 < _e1022)) + (select(_e1057, _e1022, (_e1022 > _e1057)) * 0.0000019073523f));
                                        let _e1066 = (select(_e1024, _e1052, (_e1052 < _e1024)) + (select(_e1058, _e1024, (_e1024 > _e1058)) * 0.0000019073523f));
                                        let _e1068 = select(_e604, _e1038, (_e1038 > _e604));
                                        let _e1070 = select(_e604, _e1040, (_e1040 > _e604));
                                        let _e1075 = (_e1068 <= select(_e648.member_1, _e1065, (_e1065 < _e648.member_1)));
                                        let _e1076 = (_e1070 <= select(_e648.member_1, _e1066, (_e1066 < _e648.member_1)));
                                        let _e1077 = (_e1068 <= _e1070);
                                        if _e1075 {
                                            if _e1076 {
                                                if _e1077 {
                                                    phi_3382_ = _e975.member_2;
                                                } else {
                                                    phi_3382_ = _e975.member_1;
                                                }
                                                let _e1081 = phi_3382_;
                                                let _e1102 = (_e691 % 128u);
                                                let _e1103 = (_e1102 < 128u);
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_8[_e1102] = _e1081.member_1;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_7[_e1102] = _e1081.member.member.x;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_6[_e1102] = _e1081.member.member.y;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_5[_e1102] = _e1081.member.member.z;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_4[_e1102] = _e1081.member.member_1.x;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_3[_e1102] = _e1081.member.member_1.y;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_2[_e1102] = _e1081.member.member_1.z;
                                                if _e1103 {
                                                } else {
                                                    phi_4148_ = true;
                                                    break;
                                                }
                                                local_9[_e1102] = select(_e1068, _e1070, _e1077);
                                                if _e1077 {
                                                    phi_3458_ = _e975.member_1;
                                                } else {
                                                    phi_3458_ = _e975.member_2;
                                                }
                                                let _e1116 = phi_3458_;
                                                phi_3459_ = _e1116;
                                                phi_3460_ = (_e691 + 1u);
                                            } else {
                                                phi_3459_ = type_51();
                                                phi_3460_ = u32();
                                            }
                                            let _e1118 = phi_3459_;
                                            let _e1120 = phi_3460_;
                                            phi_3462_ = _e1118;
                                            phi_3463_ = _e1120;
                                            phi_3464_ = select(true, false, _e1076);
                                        } else {
                                            phi_3462_ = type_51();
                                            phi_3463_ = u32();
                                            phi_3464_ = true;
                                        }
                                        let _e1123 = phi_3462_;
                                        let _e1125 = phi_3463_;
                                        let _e1127 = phi_3464_;
                                        if _e1127 {
                                            if _e1075 {
                                                phi_3473_ = _e975.member_1;
                                            } else {
                                                phi_3473_ = _e975.member_2;
                                            }
                                            let _e1131 = phi_3473_;
                                            phi_3478_ = select(_e1076, true, _e1075);
                                            phi_3479_ = _e1131;
                                        } else {
                                            phi_3478_ = _e687;
                                            phi_3479_ = _e1123;
                                        }
                                        let _e1134 = phi_3478_;
                                        let _e1136 = phi_3479_;
                                        phi_4152_ = _e646;
                                        phi_3481_ = _e648;
                                        phi_3482_ = _e1134;
                                        phi_3483_ = _e1136;
                                        phi_3484_ = select(_e1125, _e691, _e1127);
                                    }
                                    let _e1718 = phi_4152_;
                                    let _e1720 = phi_3481_;
                                    let _e1722 = phi_3482_;
                                    let _e1724 = phi_3483_;
                                    let _e1726 = phi_3484_;
                                    phi_4151_ = _e1718;
                                    phi_3485_ = _e1720;
                                    phi_3486_ = _e1722;
                                    phi_3487_ = _e1724;
                                    phi_3488_ = _e1726;
                                    phi_3489_ = (_e656 - 1u);
                                } else {
                                    phi_4151_ = _e646;
                                    phi_3485_ = _e648;
                                    phi_3486_ = _e687;
                                    phi_3487_ = _e689;
                                    phi_3488_ = _e691;
                                    phi_3489_ = _e656;
                                }
                                let _e1728 = phi_4151_;
                                let _e1730 = phi_3485_;
                                let _e1732 = phi_3486_;
                                let _e1734 = phi_3487_;
                                let _e1736 = phi_3488_;
                                let _e1738 = phi_3489_;
                                phi_4150_ = _e1728;
                                phi_3490_ = _e1730;
                                phi_3491_ = _e1732;
                                phi_3492_ = _e1734;
                                phi_3493_ = _e1736;
                                phi_3494_ = _e1738;
                            } else {
                                phi_4150_ = _e646;
                                phi_3490_ = type_38();
                                phi_3491_ = bool();
                                phi_3492_ = type_51();
                                phi_3493_ = u32();
                                phi_3494_ = u32();
                            }
                            let _e1740 = phi_4150_;
                            let _e1742 = phi_3490_;
                            let _e1744 = phi_3491_;
                            let _e1746 = phi_3492_;
                            let _e1748 = phi_3493_;
                            let _e1750 = phi_3494_;
                            phi_4149_ = _e1740;
                            phi_1189_ = _e1742;
                            phi_1192_ = _e1744;
                            phi_1194_ = _e1746;
                            phi_1196_ = _e1748;
                            phi_1198_ = _e1750;
                            phi_3495_ = _e660;
                        } else {
                            phi_4149_ = _e646;
                            phi_1189_ = type_38();
                            phi_1192_ = bool();
                            phi_1194_ = type_51();
                            phi_1196_ = u32();
                            phi_1198_ = u32();
                            phi_3495_ = false;
                        }
                        let _e1752 = phi_4149_;
                        let _e1754 = phi_1189_;
                        let _e1756 = phi_1192_;
                        let _e1758 = phi_1194_;
                        let _e1760 = phi_1196_;
                        let _e1762 = phi_1198_;
                        let _e1764 = phi_3495_;
                        continue;
                        continuing {
                            phi_4001_ = _e1752;
                            phi_1188_ = _e1754;
                            phi_1191_ = _e1756;
                            phi_1193_ = _e1758;
                            phi_1195_ = _e1760;
                            phi_1197_ = _e1762;
                            phi_4148_ = _e1752;
                            break if !(_e1764);
                        }
                    }
                    let _e1767 = phi_4148_;
                    if _e1767 {
                        break;
                    }
                    let _e1769 = local_11;
                    if (_e1769.member.member_3 != 4294967295u) {
                        let _e1774 = -(_e506);
                        let _e1775 = bitcast<u32>(_e1769.member.member);
                        let _e1779 = (bitcast<i32>((_e1775 >> bitcast<u32>(23i))) & 255i);
                        let _e1780 = (_e1779 + _e1774);
                        if (_e1779 == 255i) {
                            phi_3554_ = _e1769.member.member;
                        } else {
                            if (_e1779 > 0i) {
                                if (_e1780 > 0i) {
                                    let _e1784 = (_e1780 < 255i);
                                    if _e1784 {
                                        phi_3533_ = bitcast<f32>((_e1775 + bitcast<u32>((_e1774 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3533_ = f32();
                                    }
                                    let _e1791 = phi_3533_;
                                    phi_3535_ = _e1791;
                                    phi_3536_ = select(true, false, _e1784);
                                } else {
                                    phi_3535_ = f32();
                                    phi_3536_ = true;
                                }
                                let _e1794 = phi_3535_;
                                let _e1796 = phi_3536_;
                                phi_3537_ = _e1794;
                                phi_3538_ = _e1796;
                            } else {
                                phi_3537_ = f32();
                                phi_3538_ = true;
                            }
                            let _e1798 = phi_3537_;
                            let _e1800 = phi_3538_;
                            if _e1800 {
                                let _e1801 = (_e1775 & 2147483648u);
                                let _e1808 = ((_e1775 & 8388607u) | (select(0u, 1u, ((_e1775 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1812 = (_e1808 == 0u);
                                if _e1812 {
                                    phi_3953_ = bitcast<f32>(_e1801);
                                } else {
                                    let _e1817 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1808)), 32u, _e1812) - 8u);
                                    let _e1820 = (_e1808 << bitcast<u32>((_e1817 & 31u)));
                                    let _e1822 = ((_e1780 + select(0i, 1i, (_e1779 == 0i))) - bitcast<i32>(_e1817));
                                    if (_e1822 >= 255i) {
                                        phi_3943_ = bitcast<f32>((_e1801 | 2139095040u));
                                        phi_3944_ = f32();
                                        phi_3945_ = true;
                                    } else {
                                        let _e1824 = (_e1822 > 0i);
                                        if _e1824 {
                                            phi_3937_ = bitcast<f32>(((_e1801 | (bitcast<u32>(_e1822) << bitcast<u32>(23i))) | (_e1820 & 8388607u)));
                                            phi_3938_ = f32();
                                        } else {
                                            if (_e1822 < -24i) {
                                                phi_3903_ = 26u;
                                            } else {
                                                phi_3903_ = bitcast<u32>((1i - _e1822));
                                            }
                                            let _e1829 = phi_3903_;
                                            let _e1830 = (_e1829 & 31u);
                                            let _e1832 = (_e1820 >> bitcast<u32>(_e1830));
                                            let _e1836 = (_e1820 & ((1u << bitcast<u32>(_e1830)) - 1u));
                                            let _e1840 = (1u << bitcast<u32>(((_e1829 - 1u) & 31u)));
                                            if (_e1836 > _e1840) {
                                                phi_3924_ = true;
                                            } else {
                                                if (_e1836 == _e1840) {
                                                    phi_3921_ = ((_e1832 & 1u) == 1u);
                                                } else {
                                                    phi_3921_ = false;
                                                }
                                                let _e1846 = phi_3921_;
                                                phi_3924_ = _e1846;
                                            }
                                            let _e1848 = phi_3924_;
                                            phi_3937_ = f32();
                                            phi_3938_ = bitcast<f32>((_e1801 | (_e1832 + select(0u, 1u, _e1848))));
                                        }
                                        let _e1861 = phi_3937_;
                                        let _e1863 = phi_3938_;
                                        phi_3943_ = _e1861;
                                        phi_3944_ = _e1863;
                                        phi_3945_ = _e1824;
                                    }
                                    let _e1867 = phi_3943_;
                                    let _e1869 = phi_3944_;
                                    let _e1871 = phi_3945_;
                                    phi_3953_ = select(_e1869, _e1867, _e1871);
                                }
                                let _e1875 = phi_3953_;
                                phi_3553_ = _e1875;
                            } else {
                                phi_3553_ = _e1798;
                            }
                            let _e1877 = phi_3553_;
                            phi_3554_ = _e1877;
                        }
                        let _e1879 = phi_3554_;
                        let _e1880 = bitcast<u32>(_e1879);
                        if ((_e1880 & 2147483647u) >= 2139095040u) {
                            phi_3566_ = bitcast<f32>(((_e1880 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3566_ = _e1879;
                        }
                        let _e1887 = phi_3566_;
                        phi_3571_ = type_25(_e1887, _e1769.member.member_1, _e1769.member.member_2, _e1769.member.member_3);
                    } else {
                        phi_3571_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1892 = phi_3571_;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = _e1892;
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
