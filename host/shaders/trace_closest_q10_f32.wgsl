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

struct type_42 {
    member: array<type_29>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_33,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_42;
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
    var phi_472_: i32;
    var phi_473_: i32;
    var phi_483_: bool;
    var phi_493_: u32;
    var phi_494_: u32;
    var phi_496_: bool;
    var phi_501_: u32;
    var phi_514_: i32;
    var phi_534_: i32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_656_: f32;
    var phi_668_: f32;
    var phi_677_: f32;
    var phi_683_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_781_: f32;
    var phi_793_: f32;
    var phi_802_: f32;
    var phi_808_: f32;
    var phi_848_: f32;
    var phi_854_: f32;
    var phi_906_: f32;
    var phi_918_: f32;
    var phi_973_: i32;
    var phi_995_: u32;
    var phi_996_: u32;
    var phi_1033_: i32;
    var phi_1055_: u32;
    var phi_1056_: u32;
    var phi_1064_: f32;
    var phi_1065_: f32;
    var phi_3975_: bool;
    var phi_1161_: type_38;
    var phi_1164_: u32;
    var phi_1166_: bool;
    var phi_1168_: u32;
    var phi_1170_: type_50;
    var phi_1181_: bool;
    var phi_1267_: bool;
    var phi_1268_: u32;
    var phi_1269_: type_50;
    var phi_1287_: type_38;
    var phi_1290_: type_4;
    var phi_1291_: type_4;
    var phi_1313_: type_4;
    var phi_1334_: u32;
    var phi_1426_: array<array<f32, 3>, 3>;
    var phi_1578_: bool;
    var phi_1607_: bool;
    var phi_2026_: f32;
    var phi_2027_: f32;
    var phi_2028_: f32;
    var phi_2029_: f32;
    var phi_2030_: vec3<f32>;
    var phi_2031_: vec3<f32>;
    var phi_2032_: vec3<f32>;
    var phi_2033_: vec3<f32>;
    var phi_2070_: bool;
    var phi_2079_: vec3<f32>;
    var phi_2244_: f32;
    var phi_2246_: f32;
    var phi_2247_: bool;
    var phi_2267_: f32;
    var phi_2268_: f32;
    var phi_2291_: type_25;
    var phi_2293_: type_25;
    var phi_2294_: bool;
    var phi_2298_: type_25;
    var phi_2299_: type_25;
    var phi_2300_: type_25;
    var phi_2301_: bool;
    var phi_2305_: type_25;
    var phi_2306_: bool;
    var phi_2307_: type_25;
    var phi_2308_: bool;
    var phi_2309_: bool;
    var phi_2310_: type_25;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2320_: type_25;
    var phi_2321_: bool;
    var phi_2325_: type_25;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2357_: type_38;
    var phi_2358_: type_38;
    var phi_2359_: type_38;
    var phi_1288_: type_38;
    var phi_3969_: bool;
    var phi_4215_: bool;
    var phi_2360_: type_38;
    var phi_3087_: u32;
    var phi_3088_: u32;
    var phi_3098_: u32;
    var phi_3100_: u32;
    var phi_3101_: bool;
    var phi_3121_: u32;
    var phi_3122_: u32;
    var phi_3126_: type_51;
    var phi_3488_: type_50;
    var phi_3564_: type_50;
    var phi_3565_: u32;
    var phi_3566_: type_50;
    var phi_3568_: u32;
    var phi_3569_: type_50;
    var phi_3570_: bool;
    var phi_3579_: type_50;
    var phi_3584_: bool;
    var phi_3586_: type_50;
    var phi_3590_: bool;
    var phi_3591_: u32;
    var phi_3592_: type_50;
    var phi_3602_: type_50;
    var phi_4132_: bool;
    var phi_3603_: type_38;
    var phi_3604_: u32;
    var phi_3605_: bool;
    var phi_3606_: u32;
    var phi_3607_: type_50;
    var phi_4131_: bool;
    var phi_3608_: type_38;
    var phi_3609_: u32;
    var phi_3610_: bool;
    var phi_3611_: u32;
    var phi_3612_: type_50;
    var phi_4130_: bool;
    var phi_1162_: type_38;
    var phi_1165_: u32;
    var phi_1167_: bool;
    var phi_1169_: u32;
    var phi_1171_: type_50;
    var phi_3613_: bool;
    var phi_4129_: bool;
    var local_10: type_38;
    var phi_3651_: f32;
    var phi_3653_: f32;
    var phi_3654_: bool;
    var phi_3655_: f32;
    var phi_3656_: bool;
    var phi_3877_: u32;
    var phi_3895_: bool;
    var phi_3898_: bool;
    var phi_3911_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3918_: f32;
    var phi_3919_: bool;
    var phi_3927_: f32;
    var phi_3671_: f32;
    var phi_3672_: f32;
    var phi_3684_: f32;
    var phi_3689_: type_25;
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
                            phi_472_ = (bitcast<i32>((_e229 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_472_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e229)), 32u, (_e229 == 0u))));
                        }
                        let _e243 = phi_472_;
                        phi_473_ = _e243;
                    } else {
                        phi_473_ = 0i;
                    }
                    let _e245 = phi_473_;
                    let _e246 = (_e162 == _e201);
                    if _e246 {
                        phi_483_ = true;
                    } else {
                        phi_483_ = (_e169 == _e201);
                    }
                    let _e249 = phi_483_;
                    let _e250 = select(1u, 0u, _e246);
                    if _e249 {
                        let _e251 = (_e250 + 1u);
                        phi_493_ = _e251;
                        phi_494_ = _e251;
                        phi_496_ = select(true, false, (_e251 == 2u));
                    } else {
                        phi_493_ = u32();
                        phi_494_ = 0u;
                        phi_496_ = true;
                    }
                    let _e255 = phi_493_;
                    let _e257 = phi_494_;
                    let _e259 = phi_496_;
                    if _e259 {
                        phi_501_ = (_e257 + 1u);
                    } else {
                        phi_501_ = 0u;
                    }
                    let _e263 = phi_501_;
                    let _e264 = select(_e255, _e257, _e259);
                    let _e265 = select(_e250, select(2u, _e250, _e249), _e259);
                    if (_e132 < -126i) {
                        phi_514_ = -126i;
                    } else {
                        phi_514_ = select(_e132, 127i, (_e132 > 127i));
                    }
                    let _e270 = phi_514_;
                    let _e275 = bitcast<f32>((bitcast<u32>((_e270 + 127i)) << bitcast<u32>(23i)));
                    let _e281 = bitcast<f32>((bitcast<u32>(((_e132 - _e270) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = -(_e245);
                    if (_e282 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e282, 127i, (_e282 > 127i));
                    }
                    let _e287 = phi_534_;
                    let _e292 = bitcast<f32>((bitcast<u32>((_e287 + 127i)) << bitcast<u32>(23i)));
                    let _e298 = bitcast<f32>((bitcast<u32>(((_e282 - _e287) + 127i)) << bitcast<u32>(23i)));
                    let _e302 = global_5.member[_e150].member;
                    let _e303 = (_e264 == 0u);
                    if _e303 {
                        phi_552_ = _e302[0];
                    } else {
                        phi_552_ = _e302[1];
                    }
                    let _e307 = phi_552_;
                    let _e308 = (_e264 == 2u);
                    if _e308 {
                        phi_558_ = _e302[2];
                    } else {
                        phi_558_ = _e307;
                    }
                    let _e311 = phi_558_;
                    let _e312 = bitcast<u32>(_e311);
                    let _e314 = ((_e312 & 2139095040u) != 0u);
                    let _e328 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e312 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e312 & 2147483648u))), _e311, _e314) * _e275) * select(0.00000011920929f, 1f, _e314)) * _e281);
                    let _e329 = global_5.member[_e150].member_2;
                    if _e303 {
                        phi_598_ = _e329[0];
                    } else {
                        phi_598_ = _e329[1];
                    }
                    let _e333 = phi_598_;
                    if _e308 {
                        phi_604_ = _e329[2];
                    } else {
                        phi_604_ = _e333;
                    }
                    let _e336 = phi_604_;
                    let _e337 = bitcast<u32>(_e336);
                    let _e339 = ((_e337 & 2139095040u) != 0u);
                    let _e353 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e337 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e337 & 2147483648u))), _e336, _e339) * _e292) * select(0.00000011920929f, 1f, _e339)) * _e298);
                    let _e357 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e357 {
                        let _e361 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_656_ = select(0.00000000000011368684f, _e361, (_e361 > 0.00000000000011368684f));
                    } else {
                        phi_656_ = 0f;
                    }
                    let _e365 = phi_656_;
                    let _e366 = (_e328 + _e365);
                    let _e367 = (_e328 - _e365);
                    let _e368 = select(_e353, 0f, _e357);
                    if _e357 {
                        phi_668_ = 38685626000000000000000000f;
                    } else {
                        phi_668_ = (1f / _e353);
                    }
                    let _e371 = phi_668_;
                    let _e372 = (_e263 == 0u);
                    if _e372 {
                        phi_677_ = _e302[0];
                    } else {
                        phi_677_ = _e302[1];
                    }
                    let _e376 = phi_677_;
                    let _e377 = (_e263 == 2u);
                    if _e377 {
                        phi_683_ = _e302[2];
                    } else {
                        phi_683_ = _e376;
                    }
                    let _e380 = phi_683_;
                    let _e381 = bitcast<u32>(_e380);
                    let _e383 = ((_e381 & 2139095040u) != 0u);
                    let _e397 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e381 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e381 & 2147483648u))), _e380, _e383) * _e275) * select(0.00000011920929f, 1f, _e383)) * _e281);
                    if _e372 {
                        phi_723_ = _e329[0];
                    } else {
                        phi_723_ = _e329[1];
                    }
                    let _e401 = phi_723_;
                    if _e377 {
                        phi_729_ = _e329[2];
                    } else {
                        phi_729_ = _e401;
                    }
                    let _e404 = phi_729_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e292) * select(0.00000011920929f, 1f, _e407)) * _e298);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_781_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_781_ = 0f;
                    }
                    let _e433 = phi_781_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_793_ = 38685626000000000000000000f;
                    } else {
                        phi_793_ = (1f / _e421);
                    }
                    let _e439 = phi_793_;
                    let _e440 = (_e265 == 0u);
                    if _e440 {
                        phi_802_ = _e302[0];
                    } else {
                        phi_802_ = _e302[1];
                    }
                    let _e444 = phi_802_;
                    let _e445 = (_e265 == 2u);
                    if _e445 {
                        phi_808_ = _e302[2];
                    } else {
                        phi_808_ = _e444;
                    }
                    let _e448 = phi_808_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e275) * select(0.00000011920929f, 1f, _e451)) * _e281);
                    if _e440 {
                        phi_848_ = _e329[0];
                    } else {
                        phi_848_ = _e329[1];
                    }
                    let _e469 = phi_848_;
                    if _e445 {
                        phi_854_ = _e329[2];
                    } else {
                        phi_854_ = _e469;
                    }
                    let _e472 = phi_854_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e292) * select(0.00000011920929f, 1f, _e475)) * _e298);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e493 {
                        let _e497 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                        phi_906_ = select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f));
                    } else {
                        phi_906_ = 0f;
                    }
                    let _e501 = phi_906_;
                    let _e502 = (_e465 + _e501);
                    let _e503 = (_e465 - _e501);
                    let _e504 = select(_e489, 0f, _e493);
                    if _e493 {
                        phi_918_ = 38685626000000000000000000f;
                    } else {
                        phi_918_ = (1f / _e489);
                    }
                    let _e507 = phi_918_;
                    let _e510 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e513 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e515 = select(_e513, _e510, (_e510 > _e513));
                    let _e518 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e521 = (_e132 + _e245);
                    if (_e226 && (select(_e518, _e515, (_e515 > _e518)) <= 1099511600000f)) {
                        let _e531 = ((_e213 & 8388607u) | (select(0u, 1u, ((_e213 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e534 = bitcast<i32>((_e213 >> bitcast<u32>(23i)));
                        let _e538 = (_e531 == 0u);
                        let _e541 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e531)), 32u, _e538)) - 8i);
                        if (_e534 == 255i) {
                            phi_973_ = 255i;
                        } else {
                            phi_973_ = (((_e534 + select(0i, 1i, (_e534 == 0i))) - _e541) + _e521);
                        }
                        let _e549 = phi_973_;
                        let _e559 = (_e549 <= 0i);
                        if _e559 {
                            phi_996_ = u32();
                        } else {
                            if _e538 {
                                phi_995_ = u32();
                            } else {
                                phi_995_ = select(((bitcast<u32>(_e549) << bitcast<u32>(23i)) | ((_e531 << bitcast<u32>(((_e541 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e549 >= 255i));
                            }
                            let _e563 = phi_995_;
                            phi_996_ = _e563;
                        }
                        let _e565 = phi_996_;
                        let _e577 = ((_e222 & 8388607u) | (select(0u, 1u, ((_e222 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e580 = bitcast<i32>((_e222 >> bitcast<u32>(23i)));
                        let _e584 = (_e577 == 0u);
                        let _e587 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e577)), 32u, _e584)) - 8i);
                        if (_e580 == 255i) {
                            phi_1033_ = 255i;
                        } else {
                            phi_1033_ = (((_e580 + select(0i, 1i, (_e580 == 0i))) - _e587) + _e521);
                        }
                        let _e595 = phi_1033_;
                        let _e605 = (_e595 <= 0i);
                        if _e605 {
                            phi_1056_ = u32();
                        } else {
                            if _e584 {
                                phi_1055_ = u32();
                            } else {
                                phi_1055_ = select(((bitcast<u32>(_e595) << bitcast<u32>(23i)) | ((_e577 << bitcast<u32>(((_e587 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e595 >= 255i));
                            }
                            let _e609 = phi_1055_;
                            phi_1056_ = _e609;
                        }
                        let _e611 = phi_1056_;
                        phi_1064_ = bitcast<f32>(((_e221 & 2147483648u) | select(_e611, 0u, select(_e584, true, _e605))));
                        phi_1065_ = bitcast<f32>(((_e212 & 2147483648u) | select(_e565, 0u, select(_e538, true, _e559))));
                    } else {
                        phi_1064_ = 0f;
                        phi_1065_ = 1f;
                    }
                    let _e617 = phi_1064_;
                    let _e619 = phi_1065_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e623 = (_e264 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    let _e629 = (_e263 % 3u);
                    let _e630 = (_e629 < 3u);
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e632 = local_1[_e629];
                    let _e635 = (_e265 % 3u);
                    let _e636 = (_e635 < 3u);
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e638 = local_1[_e635];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e643 = local[_e623];
                    if _e630 {
                    } else {
                        break;
                    }
                    let _e647 = local[_e629];
                    if _e636 {
                    } else {
                        break;
                    }
                    let _e651 = local[_e635];
                    phi_3975_ = false;
                    phi_1161_ = type_38(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e617);
                    phi_1164_ = ((3u * _e94) + 1u);
                    phi_1166_ = (_e619 <= _e617);
                    phi_1168_ = 0u;
                    phi_1170_ = type_50(type_33(vec4<f32>((f32(_e626) * _e144), (f32(_e632) * _e144), (f32(_e638) * _e144), 0f), vec4<f32>((f32(_e643) * _e144), (f32(_e647) * _e144), (f32(_e651) * _e144), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    loop {
                        let _e661 = phi_3975_;
                        let _e663 = phi_1161_;
                        let _e665 = phi_1164_;
                        let _e667 = phi_1166_;
                        let _e669 = phi_1168_;
                        let _e671 = phi_1170_;
                        local_10 = _e663;
                        if _e667 {
                            phi_1181_ = true;
                        } else {
                            phi_1181_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1181_;
                        if _e674 {
                            let _e675 = (_e665 > 0u);
                            if _e675 {
                                if _e667 {
                                    phi_1267_ = _e667;
                                    phi_1268_ = _e669;
                                    phi_1269_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e698 = local_9[_e677];
                                    phi_1267_ = (_e698 <= _e663.member_1);
                                    phi_1268_ = _e676;
                                    phi_1269_ = type_50(type_33(vec4<f32>(_e680, _e682, _e684, 0f), vec4<f32>(_e686, _e688, _e690, 0f)), _e695);
                                }
                                let _e702 = phi_1267_;
                                let _e704 = phi_1268_;
                                let _e706 = phi_1269_;
                                if _e702 {
                                    let _e710 = ((_e706.member_1 & 2147483648u) != 0u);
                                    if _e710 {
                                        phi_1287_ = _e663;
                                        phi_1290_ = type_4(0u, ((_e706.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e717 = phi_1287_;
                                            let _e719 = phi_1290_;
                                            local_11 = _e717;
                                            if (_e719.member < _e719.member_1) {
                                                phi_1291_ = type_4((_e719.member + 1u), _e719.member_1);
                                                phi_1313_ = type_4(1u, _e719.member);
                                            } else {
                                                phi_1291_ = _e719;
                                                phi_1313_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e732 = phi_1291_;
                                            let _e734 = phi_1313_;
                                            let _e738 = (bitcast<i32>(_e734.member) != 0i);
                                            if _e738 {
                                                let _e739 = ((_e706.member_1 & 268435455u) + _e734.member_1);
                                                let _e740 = (_e739 < _e96);
                                                if _e740 {
                                                    if _e740 {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e744 = global_2.member[_e739].member_1;
                                                    phi_1334_ = _e744;
                                                } else {
                                                    phi_1334_ = 4294967295u;
                                                }
                                                let _e746 = phi_1334_;
                                                if (_e739 >= _e96) {
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e740 {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e739].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e739].member[_e629];
                                                    if (_e635 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e765 = global_2.member[_e739].member[_e635];
                                                    let _e767 = (3u + _e623);
                                                    if (_e767 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e773 = global_2.member[_e739].member[_e767];
                                                    let _e774 = (3u + _e629);
                                                    if (_e774 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e780 = global_2.member[_e739].member[_e774];
                                                    let _e781 = (3u + _e635);
                                                    if (_e781 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e787 = global_2.member[_e739].member[_e781];
                                                    let _e789 = (6u + _e623);
                                                    if (_e789 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e795 = global_2.member[_e739].member[_e789];
                                                    let _e796 = (6u + _e629);
                                                    if (_e796 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e802 = global_2.member[_e739].member[_e796];
                                                    let _e803 = (6u + _e635);
                                                    if (_e803 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e809 = global_2.member[_e739].member[_e803];
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(_e753, _e759, _e765), array<f32, 3>(_e773, _e780, _e787), array<f32, 3>(_e795, _e802, _e809));
                                                }
                                                let _e813 = phi_1426_;
                                                let _e821 = (_e813[0][2] - _e465);
                                                let _e824 = (((_e813[0][0] - _e328) * _e504) - (_e821 * _e368));
                                                let _e827 = (((_e813[0][1] - _e397) * _e504) - (_e821 * _e436));
                                                let _e834 = (_e813[1][2] - _e465);
                                                let _e837 = (((_e813[1][0] - _e328) * _e504) - (_e834 * _e368));
                                                let _e840 = (((_e813[1][1] - _e397) * _e504) - (_e834 * _e436));
                                                let _e847 = (_e813[2][2] - _e465);
                                                let _e850 = (((_e813[2][0] - _e328) * _e504) - (_e847 * _e368));
                                                let _e853 = (((_e813[2][1] - _e397) * _e504) - (_e847 * _e436));
                                                let _e854 = (_e850 * _e840);
                                                let _e855 = (_e853 * _e837);
                                                let _e856 = (_e824 * _e853);
                                                let _e857 = (_e827 * _e850);
                                                let _e858 = (_e837 * _e827);
                                                let _e859 = (_e840 * _e824);
                                                let _e864 = (((_e854 >= _e855) && (_e856 >= _e857)) && (_e858 >= _e859));
                                                if (_e864 || (((_e854 <= _e855) && (_e856 <= _e857)) && (_e858 <= _e859))) {
                                                    let _e871 = select(-1f, 1f, _e864);
                                                    let _e873 = ((_e854 - _e855) * _e871);
                                                    let _e875 = select(0f, _e873, (_e873 > 0f));
                                                    let _e877 = ((_e856 - _e857) * _e871);
                                                    let _e879 = select(0f, _e877, (_e877 > 0f));
                                                    let _e881 = ((_e858 - _e859) * _e871);
                                                    let _e883 = select(0f, _e881, (_e881 > 0f));
                                                    let _e885 = ((_e875 + _e879) + _e883);
                                                    if (_e885 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2310_ = type_25();
                                                        phi_2311_ = true;
                                                        phi_2312_ = false;
                                                    } else {
                                                        let _e888 = select(_e837, _e824, (_e824 < _e837));
                                                        if (select(_e850, _e888, (_e888 < _e850)) > 0f) {
                                                            phi_1578_ = true;
                                                        } else {
                                                            let _e893 = select(_e837, _e824, (_e824 > _e837));
                                                            phi_1578_ = (select(_e850, _e893, (_e893 > _e850)) < 0f);
                                                        }
                                                        let _e898 = phi_1578_;
                                                        if _e898 {
                                                            phi_2307_ = type_25();
                                                            phi_2308_ = true;
                                                            phi_2309_ = false;
                                                        } else {
                                                            let _e900 = select(_e840, _e827, (_e827 < _e840));
                                                            if (select(_e853, _e900, (_e900 < _e853)) > 0f) {
                                                                phi_1607_ = true;
                                                            } else {
                                                                let _e905 = select(_e840, _e827, (_e827 > _e840));
                                                                phi_1607_ = (select(_e853, _e905, (_e905 > _e853)) < 0f);
                                                            }
                                                            let _e910 = phi_1607_;
                                                            if _e910 {
                                                                phi_2305_ = type_25();
                                                                phi_2306_ = false;
                                                            } else {
                                                                let _e912 = select(_e813[1][0], _e813[0][0], (_e813[0][0] < _e813[1][0]));
                                                                let _e916 = select(_e813[1][0], _e813[0][0], (_e813[0][0] > _e813[1][0]));
                                                                let _e920 = select(_e813[1][1], _e813[0][1], (_e813[0][1] < _e813[1][1]));
                                                                let _e924 = select(_e813[1][1], _e813[0][1], (_e813[0][1] > _e813[1][1]));
                                                                let _e928 = select(_e813[1][2], _e813[0][2], (_e813[0][2] < _e813[1][2]));
                                                                let _e932 = select(_e813[1][2], _e813[0][2], (_e813[0][2] > _e813[1][2]));
                                                                let _e937 = ((select(_e813[2][0], _e912, (_e912 < _e813[2][0])) - _e366) * _e371);
                                                                let _e938 = ((select(_e813[2][0], _e916, (_e916 > _e813[2][0])) - _e367) * _e371);
                                                                let _e941 = ((select(_e813[2][1], _e920, (_e920 < _e813[2][1])) - _e434) * _e439);
                                                                let _e942 = ((select(_e813[2][1], _e924, (_e924 > _e813[2][1])) - _e435) * _e439);
                                                                let _e945 = ((select(_e813[2][2], _e928, (_e928 < _e813[2][2])) - _e502) * _e507);
                                                                let _e946 = ((select(_e813[2][2], _e932, (_e932 > _e813[2][2])) - _e503) * _e507);
                                                                let _e948 = select(_e946, _e945, (_e945 < _e946));
                                                                let _e950 = select(_e946, _e945, (_e945 > _e946));
                                                                let _e952 = select(_e938, _e937, (_e937 < _e938));
                                                                let _e954 = select(_e942, _e941, (_e941 < _e942));
                                                                let _e956 = select(_e954, _e952, (_e952 > _e954));
                                                                let _e958 = select(_e948, _e956, (_e956 > _e948));
                                                                let _e960 = select(_e938, _e937, (_e937 > _e938));
                                                                let _e962 = select(_e942, _e941, (_e941 > _e942));
                                                                let _e964 = select(_e962, _e960, (_e960 < _e962));
                                                                let _e966 = select(_e950, _e964, (_e964 < _e950));
                                                                let _e967 = -(_e948);
                                                                let _e973 = select(_e619, _e958, (_e958 > _e619));
                                                                if (_e973 > (_e966 + (select(_e967, _e950, (_e950 > _e967)) * 0.0000019073523f))) {
                                                                    phi_2300_ = type_25();
                                                                    phi_2301_ = true;
                                                                } else {
                                                                    let _e975 = (_e973 > _e717.member_1);
                                                                    if _e975 {
                                                                        phi_2299_ = type_25();
                                                                    } else {
                                                                        let _e976 = vec3<f32>(_e813[0][0], _e813[0][1], _e813[0][2]);
                                                                        let _e977 = vec3<f32>(_e813[1][0], _e813[1][1], _e813[1][2]);
                                                                        let _e978 = vec3<f32>(_e813[2][0], _e813[2][1], _e813[2][2]);
                                                                        let _e979 = (_e813[1][0] - _e813[0][0]);
                                                                        let _e980 = (_e813[1][1] - _e813[0][1]);
                                                                        let _e981 = (_e813[1][2] - _e813[0][2]);
                                                                        let _e982 = vec3<f32>(_e979, _e980, _e981);
                                                                        let _e983 = (_e813[2][0] - _e813[1][0]);
                                                                        let _e984 = (_e813[2][1] - _e813[1][1]);
                                                                        let _e985 = (_e813[2][2] - _e813[1][2]);
                                                                        let _e986 = vec3<f32>(_e983, _e984, _e985);
                                                                        let _e987 = (_e813[0][0] - _e813[2][0]);
                                                                        let _e988 = (_e813[0][1] - _e813[2][1]);
                                                                        let _e989 = (_e813[0][2] - _e813[2][2]);
                                                                        let _e990 = vec3<f32>(_e987, _e988, _e989);
                                                                        let _e993 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e996 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e998 = select(_e996, _e993, (_e993 > _e996));
                                                                        let _e1001 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1003 = select(_e1001, _e998, (_e998 > _e1001));
                                                                        let _e1006 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1009 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1011 = select(_e1009, _e1006, (_e1006 > _e1009));
                                                                        let _e1014 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1016 = select(_e1014, _e1011, (_e1011 > _e1014));
                                                                        let _e1019 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1022 = bitcast<f32>((bitcast<u32>(_e988) & 2147483647u));
                                                                        let _e1024 = select(_e1022, _e1019, (_e1019 > _e1022));
                                                                        let _e1027 = bitcast<f32>((bitcast<u32>(_e989) & 2147483647u));
                                                                        let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                                                                        let _e1031 = select(_e1016, _e1003, (_e1003 > _e1016));
                                                                        let _e1033 = select(_e1029, _e1031, (_e1031 > _e1029));
                                                                        if (_e1003 == _e1033) {
                                                                            phi_2026_ = _e840;
                                                                            phi_2027_ = _e837;
                                                                            phi_2028_ = _e827;
                                                                            phi_2029_ = _e824;
                                                                            phi_2030_ = _e976;
                                                                            phi_2031_ = _e990;
                                                                            phi_2032_ = _e986;
                                                                            phi_2033_ = _e982;
                                                                        } else {
                                                                            let _e1035 = (_e1016 == _e1033);
                                                                            let _e1040 = vec3(_e1035);
                                                                            phi_2026_ = select(_e827, _e853, _e1035);
                                                                            phi_2027_ = select(_e824, _e850, _e1035);
                                                                            phi_2028_ = select(_e853, _e840, _e1035);
                                                                            phi_2029_ = select(_e850, _e837, _e1035);
                                                                            phi_2030_ = select(_e978, _e977, _e1040);
                                                                            phi_2031_ = select(_e986, _e982, _e1040);
                                                                            phi_2032_ = select(_e982, _e990, _e1040);
                                                                            phi_2033_ = select(_e990, _e986, _e1040);
                                                                        }
                                                                        let _e1046 = phi_2026_;
                                                                        let _e1048 = phi_2027_;
                                                                        let _e1050 = phi_2028_;
                                                                        let _e1052 = phi_2029_;
                                                                        let _e1054 = phi_2030_;
                                                                        let _e1056 = phi_2031_;
                                                                        let _e1058 = phi_2032_;
                                                                        let _e1060 = phi_2033_;
                                                                        let _e1067 = ((_e1058.y * _e1056.z) - (_e1056.y * _e1058.z));
                                                                        let _e1072 = ((_e1058.z * _e1056.x) - (_e1056.z * _e1058.x));
                                                                        let _e1075 = ((_e1058.x * _e1056.y) - (_e1056.x * _e1058.y));
                                                                        if (_e875 >= _e879) {
                                                                            phi_2070_ = select(true, false, (_e875 >= _e883));
                                                                        } else {
                                                                            phi_2070_ = true;
                                                                        }
                                                                        let _e1080 = phi_2070_;
                                                                        if _e1080 {
                                                                            phi_2079_ = select(_e978, _e977, vec3((_e879 >= _e883)));
                                                                        } else {
                                                                            phi_2079_ = _e976;
                                                                        }
                                                                        let _e1085 = phi_2079_;
                                                                        let _e1096 = (((_e1067 * (_e1085.x - _e328)) + (_e1072 * (_e1085.y - _e397))) + (_e1075 * (_e1085.z - _e465)));
                                                                        let _e1101 = (((_e1067 * _e368) + (_e1072 * _e436)) + (_e1075 * _e504));
                                                                        let _e1102 = (_e1048 - _e1052);
                                                                        let _e1103 = (_e1046 - _e1050);
                                                                        let _e1111 = (-(((_e1052 * _e1102) + (_e1050 * _e1103))) / ((_e1102 * _e1102) + (_e1103 * _e1103)));
                                                                        let _e1113 = select(1f, _e1111, (_e1111 < 1f));
                                                                        let _e1115 = select(0f, _e1113, (_e1113 > 0f));
                                                                        let _e1128 = ((_e1054.x + (_e1060.x * _e1115)) - _e328);
                                                                        let _e1129 = ((_e1054.y + (_e1060.y * _e1115)) - _e397);
                                                                        let _e1130 = ((_e1054.z + (_e1060.z * _e1115)) - _e465);
                                                                        let _e1131 = (_e1130 / _e504);
                                                                        let _e1143 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                        let _e1146 = bitcast<f32>((bitcast<u32>(_e1129) & 2147483647u));
                                                                        let _e1148 = select(_e1146, _e1143, (_e1143 > _e1146));
                                                                        let _e1151 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                        let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                                                        let _e1159 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                        let _e1162 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                        let _e1164 = select(_e1162, _e1159, (_e1159 > _e1162));
                                                                        let _e1167 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1067 * _e1128) + (_e1072 * _e1129)) + (_e1075 * _e1130)) - _e1096)) & 2147483647u)) <= ((0.0000009536743f * select(_e1033, _e1153, (_e1153 > _e1033))) * select(_e1167, _e1164, (_e1164 > _e1167)))) {
                                                                            let _e1177 = bitcast<f32>((bitcast<u32>(_e1058.x) & 2147483647u));
                                                                            let _e1180 = bitcast<f32>((bitcast<u32>(_e1058.y) & 2147483647u));
                                                                            let _e1182 = select(_e1180, _e1177, (_e1177 > _e1180));
                                                                            let _e1185 = bitcast<f32>((bitcast<u32>(_e1058.z) & 2147483647u));
                                                                            let _e1191 = bitcast<f32>((bitcast<u32>(_e1056.x) & 2147483647u));
                                                                            let _e1194 = bitcast<f32>((bitcast<u32>(_e1056.y) & 2147483647u));
                                                                            let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                                            let _e1199 = bitcast<f32>((bitcast<u32>(_e1056.z) & 2147483647u));
                                                                            let _e1203 = (bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u)) > ((0.0000038146973f * select(_e1185, _e1182, (_e1182 > _e1185))) * select(_e1199, _e1196, (_e1196 > _e1199))));
                                                                            if _e1203 {
                                                                                phi_2244_ = (_e1096 / _e1101);
                                                                            } else {
                                                                                phi_2244_ = f32();
                                                                            }
                                                                            let _e1206 = phi_2244_;
                                                                            phi_2246_ = _e1206;
                                                                            phi_2247_ = select(true, false, _e1203);
                                                                        } else {
                                                                            phi_2246_ = f32();
                                                                            phi_2247_ = true;
                                                                        }
                                                                        let _e1209 = phi_2246_;
                                                                        let _e1211 = phi_2247_;
                                                                        if _e1211 {
                                                                            let _e1219 = (((_e1067 * (_e1128 - (_e368 * _e1131))) + (_e1072 * (_e1129 - (_e436 * _e1131)))) / _e1101);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u)) <= _e1033) {
                                                                                phi_2267_ = (_e1131 + _e1219);
                                                                            } else {
                                                                                phi_2267_ = _e1131;
                                                                            }
                                                                            let _e1226 = phi_2267_;
                                                                            phi_2268_ = _e1226;
                                                                        } else {
                                                                            phi_2268_ = _e1209;
                                                                        }
                                                                        let _e1228 = phi_2268_;
                                                                        let _e1230 = select(_e966, _e1228, (_e1228 < _e966));
                                                                        let _e1232 = select(_e958, _e1230, (_e1230 > _e958));
                                                                        if (_e1232 >= _e619) {
                                                                            let _e1234 = (_e1232 <= _e717.member_1);
                                                                            if _e1234 {
                                                                                let _e1235 = (1f / _e885);
                                                                                phi_2291_ = type_25(_e1232, (_e879 * _e1235), (_e883 * _e1235), _e746);
                                                                            } else {
                                                                                phi_2291_ = type_25();
                                                                            }
                                                                            let _e1240 = phi_2291_;
                                                                            phi_2293_ = _e1240;
                                                                            phi_2294_ = select(true, false, _e1234);
                                                                        } else {
                                                                            phi_2293_ = type_25();
                                                                            phi_2294_ = true;
                                                                        }
                                                                        let _e1243 = phi_2293_;
                                                                        let _e1245 = phi_2294_;
                                                                        if _e1245 {
                                                                            phi_2298_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2298_ = _e1243;
                                                                        }
                                                                        let _e1247 = phi_2298_;
                                                                        phi_2299_ = _e1247;
                                                                    }
                                                                    let _e1249 = phi_2299_;
                                                                    phi_2300_ = _e1249;
                                                                    phi_2301_ = _e975;
                                                                }
                                                                let _e1251 = phi_2300_;
                                                                let _e1253 = phi_2301_;
                                                                phi_2305_ = _e1251;
                                                                phi_2306_ = _e1253;
                                                            }
                                                            let _e1255 = phi_2305_;
                                                            let _e1257 = phi_2306_;
                                                            phi_2307_ = _e1255;
                                                            phi_2308_ = _e910;
                                                            phi_2309_ = _e1257;
                                                        }
                                                        let _e1259 = phi_2307_;
                                                        let _e1261 = phi_2308_;
                                                        let _e1263 = phi_2309_;
                                                        phi_2310_ = _e1259;
                                                        phi_2311_ = _e1261;
                                                        phi_2312_ = _e1263;
                                                    }
                                                    let _e1265 = phi_2310_;
                                                    let _e1267 = phi_2311_;
                                                    let _e1269 = phi_2312_;
                                                    phi_2320_ = _e1265;
                                                    phi_2321_ = select(_e1269, true, _e1267);
                                                } else {
                                                    phi_2320_ = type_25();
                                                    phi_2321_ = true;
                                                }
                                                let _e1272 = phi_2320_;
                                                let _e1274 = phi_2321_;
                                                if _e1274 {
                                                    phi_2325_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2325_ = _e1272;
                                                }
                                                let _e1276 = phi_2325_;
                                                if (_e1276.member_3 != 4294967295u) {
                                                    if (_e746 != 4294967295u) {
                                                        if (_e1276.member < _e717.member.member) {
                                                            phi_2351_ = true;
                                                        } else {
                                                            if (_e1276.member == _e717.member.member) {
                                                                phi_2350_ = (_e1276.member_3 < _e717.member.member_3);
                                                            } else {
                                                                phi_2350_ = false;
                                                            }
                                                            let _e1289 = phi_2350_;
                                                            phi_2351_ = _e1289;
                                                        }
                                                        let _e1291 = phi_2351_;
                                                        if _e1291 {
                                                            phi_2357_ = type_38(_e1276, _e1276.member);
                                                        } else {
                                                            phi_2357_ = _e717;
                                                        }
                                                        let _e1294 = phi_2357_;
                                                        phi_2358_ = _e1294;
                                                    } else {
                                                        phi_2358_ = _e717;
                                                    }
                                                    let _e1296 = phi_2358_;
                                                    phi_2359_ = _e1296;
                                                } else {
                                                    phi_2359_ = _e717;
                                                }
                                                let _e1298 = phi_2359_;
                                                phi_1288_ = _e1298;
                                            } else {
                                                phi_1288_ = type_38();
                                            }
                                            let _e1300 = phi_1288_;
                                            continue;
                                            continuing {
                                                phi_1287_ = _e1300;
                                                phi_1290_ = _e732;
                                                phi_3969_ = _e661;
                                                break if !(_e738);
                                            }
                                        }
                                        let _e1303 = phi_3969_;
                                        phi_4129_ = _e1303;
                                        if _e1303 {
                                            break;
                                        }
                                        phi_4215_ = _e1303;
                                        let _e2020 = local_11;
                                        phi_2360_ = _e2020;
                                    } else {
                                        phi_4215_ = _e661;
                                        phi_2360_ = _e663;
                                    }
                                    let _e1305 = phi_4215_;
                                    let _e1307 = phi_2360_;
                                    if _e710 {
                                        phi_3590_ = bool();
                                        phi_3591_ = u32();
                                        phi_3592_ = type_50();
                                    } else {
                                        if (_e706.member_1 >= _e94) {
                                            phi_3126_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e706.member_1 < _e94) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1311 = ((1u + _e264) % 4u);
                                            if (_e1311 < 4u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1316 = global_4.member[_e706.member_1][_e1311];
                                            let _e1318 = (_e1316 >> bitcast<u32>(11u));
                                            let _e1320 = ((1u + _e263) % 4u);
                                            if (_e1320 < 4u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1325 = global_4.member[_e706.member_1][_e1320];
                                            let _e1327 = (_e1325 >> bitcast<u32>(11u));
                                            let _e1329 = ((1u + _e265) % 4u);
                                            if (_e1329 < 4u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1334 = global_4.member[_e706.member_1][_e1329];
                                            let _e1336 = (_e1334 >> bitcast<u32>(11u));
                                            let _e1359 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.x - _e706.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1360 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.y - _e706.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1361 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.z - _e706.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1363 = select(_e144, _e1359, (_e1359 > _e144));
                                            let _e1365 = select(_e144, _e1360, (_e1360 > _e144));
                                            let _e1367 = select(_e144, _e1361, (_e1361 > _e144));
                                            let _e1398 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1316 & 1023u))) - 8388608f) * _e1363));
                                            let _e1403 = (bitcast<i32>((_e1316 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1406 = bitcast<f32>((_e1398 & bitcast<u32>(_e1403)));
                                            let _e1407 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1325 & 1023u))) - 8388608f) * _e1365));
                                            let _e1412 = (bitcast<i32>((_e1325 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1415 = bitcast<f32>((_e1407 & bitcast<u32>(_e1412)));
                                            let _e1416 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1334 & 1023u))) - 8388608f) * _e1367));
                                            let _e1421 = (bitcast<i32>((_e1334 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1424 = bitcast<f32>((_e1416 & bitcast<u32>(_e1421)));
                                            let _e1428 = bitcast<f32>((_e1398 & bitcast<u32>(~(_e1403))));
                                            let _e1432 = bitcast<f32>((_e1407 & bitcast<u32>(~(_e1412))));
                                            let _e1436 = bitcast<f32>((_e1416 & bitcast<u32>(~(_e1421))));
                                            let _e1437 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1318 & 1023u))) - 8388608f) * _e1363));
                                            let _e1442 = (bitcast<i32>((_e1318 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1445 = bitcast<f32>((_e1437 & bitcast<u32>(_e1442)));
                                            let _e1446 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1327 & 1023u))) - 8388608f) * _e1365));
                                            let _e1451 = (bitcast<i32>((_e1327 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1454 = bitcast<f32>((_e1446 & bitcast<u32>(_e1451)));
                                            let _e1455 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1336 & 1023u))) - 8388608f) * _e1367));
                                            let _e1460 = (bitcast<i32>((_e1336 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1463 = bitcast<f32>((_e1455 & bitcast<u32>(_e1460)));
                                            let _e1467 = bitcast<f32>((_e1437 & bitcast<u32>(~(_e1442))));
                                            let _e1471 = bitcast<f32>((_e1446 & bitcast<u32>(~(_e1451))));
                                            let _e1475 = bitcast<f32>((_e1455 & bitcast<u32>(~(_e1460))));
                                            let _e1505 = global_4.member[_e706.member_1][0u];
                                            let _e1509 = global_4.member[_e706.member_1][1u];
                                            let _e1513 = global_4.member[_e706.member_1][2u];
                                            let _e1517 = global_4.member[_e706.member_1][3u];
                                            let _e1529 = (((_e1509 >> bitcast<u32>(22i)) | ((_e1513 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1517 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1530 = (_e1505 & 268435455u);
                                            let _e1531 = (_e1529 & 268435455u);
                                            let _e1534 = ((_e1505 >> bitcast<u32>(28u)) & 7u);
                                            let _e1542 = ((_e1505 >> bitcast<u32>(31i)) | (((_e1529 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1543 = (_e1534 != 0u);
                                            if (_e1534 == 0u) {
                                                phi_3088_ = _e1530;
                                            } else {
                                                if (_e1534 == 7u) {
                                                    phi_3087_ = 2147483648u;
                                                } else {
                                                    phi_3087_ = ((2147483648u | (_e1534 << bitcast<u32>(28u))) | (_e1531 & 268435455u));
                                                }
                                                let _e1552 = phi_3087_;
                                                phi_3088_ = _e1552;
                                            }
                                            let _e1554 = phi_3088_;
                                            if _e1543 {
                                                let _e1555 = (_e1534 != 7u);
                                                if _e1555 {
                                                    phi_3098_ = (_e1531 + _e1534);
                                                } else {
                                                    phi_3098_ = u32();
                                                }
                                                let _e1558 = phi_3098_;
                                                phi_3100_ = _e1558;
                                                phi_3101_ = select(true, false, _e1555);
                                            } else {
                                                phi_3100_ = u32();
                                                phi_3101_ = true;
                                            }
                                            let _e1561 = phi_3100_;
                                            let _e1563 = phi_3101_;
                                            if (_e1542 == 0u) {
                                                phi_3122_ = (_e1530 + select(0u, 1u, !(_e1543)));
                                            } else {
                                                if (_e1542 == 7u) {
                                                    phi_3121_ = 2147483648u;
                                                } else {
                                                    phi_3121_ = ((2147483648u | (_e1542 << bitcast<u32>(28u))) | (select(_e1561, _e1531, _e1563) & 268435455u));
                                                }
                                                let _e1576 = phi_3121_;
                                                phi_3122_ = _e1576;
                                            }
                                            let _e1578 = phi_3122_;
                                            phi_3126_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e706.member.member.x + _e1406), (_e706.member.member.x + _e1428), (_e706.member.member_1.x - _e1445), (_e706.member.member_1.x - _e1467)), vec4<f32>((_e706.member.member.y + _e1415), (_e706.member.member.y + _e1432), (_e706.member.member_1.y - _e1454), (_e706.member.member_1.y - _e1471)), vec4<f32>((_e706.member.member.z + _e1424), (_e706.member.member.z + _e1436), (_e706.member.member_1.z - _e1463), (_e706.member.member_1.z - _e1475))), type_50(type_33((_e706.member.member + vec4<f32>(_e1406, _e1415, _e1424, 0f)), (_e706.member.member_1 - vec4<f32>(_e1445, _e1454, _e1463, 0f))), _e1554), type_50(type_33((_e706.member.member + vec4<f32>(_e1428, _e1432, _e1436, 0f)), (_e706.member.member_1 - vec4<f32>(_e1467, _e1471, _e1475, 0f))), _e1578));
                                        }
                                        let _e1583 = phi_3126_;
                                        let _e1595 = ((_e1583.member[0].x - _e366) * _e371);
                                        let _e1596 = ((_e1583.member[0].y - _e366) * _e371);
                                        let _e1597 = ((_e1583.member[0].z - _e367) * _e371);
                                        let _e1598 = ((_e1583.member[0].w - _e367) * _e371);
                                        let _e1608 = ((_e1583.member[1].x - _e434) * _e439);
                                        let _e1609 = ((_e1583.member[1].y - _e434) * _e439);
                                        let _e1610 = ((_e1583.member[1].z - _e435) * _e439);
                                        let _e1611 = ((_e1583.member[1].w - _e435) * _e439);
                                        let _e1621 = ((_e1583.member[2].x - _e502) * _e507);
                                        let _e1622 = ((_e1583.member[2].y - _e502) * _e507);
                                        let _e1623 = ((_e1583.member[2].z - _e503) * _e507);
                                        let _e1624 = ((_e1583.member[2].w - _e503) * _e507);
                                        let _e1626 = select(_e1623, _e1621, (_e1621 < _e1623));
                                        let _e1628 = select(_e1624, _e1622, (_e1622 < _e1624));
                                        let _e1630 = select(_e1623, _e1621, (_e1621 > _e1623));
                                        let _e1632 = select(_e1624, _e1622, (_e1622 > _e1624));
                                        let _e1634 = select(_e1597, _e1595, (_e1595 < _e1597));
                                        let _e1636 = select(_e1598, _e1596, (_e1596 < _e1598));
                                        let _e1638 = select(_e1610, _e1608, (_e1608 < _e1610));
                                        let _e1640 = select(_e1611, _e1609, (_e1609 < _e1611));
                                        let _e1642 = select(_e1638, _e1634, (_e1634 > _e1638));
                                        let _e1644 = select(_e1640, _e1636, (_e1636 > _e1640));
                                        let _e1646 = select(_e1626, _e1642, (_e1642 > _e1626));
                                        let _e1648 = select(_e1628, _e1644, (_e1644 > _e1628));
                                        let _e1650 = select(_e1597, _e1595, (_e1595 > _e1597));
                                        let _e1652 = select(_e1598, _e1596, (_e1596 > _e1598));
                                        let _e1654 = select(_e1610, _e1608, (_e1608 > _e1610));
                                        let _e1656 = select(_e1611, _e1609, (_e1609 > _e1611));
                                        let _e1658 = select(_e1654, _e1650, (_e1650 < _e1654));
                                        let _e1660 = select(_e1656, _e1652, (_e1652 < _e1656));
                                        let _e1665 = -(_e1626);
                                        let _e1666 = -(_e1628);
                                        let _e1673 = (select(_e1630, _e1658, (_e1658 < _e1630)) + (select(_e1665, _e1630, (_e1630 > _e1665)) * 0.0000019073523f));
                                        let _e1674 = (select(_e1632, _e1660, (_e1660 < _e1632)) + (select(_e1666, _e1632, (_e1632 > _e1666)) * 0.0000019073523f));
                                        let _e1676 = select(_e619, _e1646, (_e1646 > _e619));
                                        let _e1678 = select(_e619, _e1648, (_e1648 > _e619));
                                        let _e1683 = (_e1676 <= select(_e1307.member_1, _e1673, (_e1673 < _e1307.member_1)));
                                        let _e1684 = (_e1678 <= select(_e1307.member_1, _e1674, (_e1674 < _e1307.member_1)));
                                        let _e1685 = (_e1676 <= _e1678);
                                        if _e1683 {
                                            if _e1684 {
                                                if _e1685 {
                                                    phi_3488_ = _e1583.member_2;
                                                } else {
                                                    phi_3488_ = _e1583.member_1;
                                                }
                                                let _e1689 = phi_3488_;
                                                let _e1710 = (_e704 % 128u);
                                                let _e1711 = (_e1710 < 128u);
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_8[_e1710] = _e1689.member_1;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_7[_e1710] = _e1689.member.member.x;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_6[_e1710] = _e1689.member.member.y;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_5[_e1710] = _e1689.member.member.z;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_4[_e1710] = _e1689.member.member_1.x;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_3[_e1710] = _e1689.member.member_1.y;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_2[_e1710] = _e1689.member.member_1.z;
                                                if _e1711 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_9[_e1710] = select(_e1676, _e1678, _e1685);
                                                if _e1685 {
                                                    phi_3564_ = _e1583.member_1;
                                                } else {
                                                    phi_3564_ = _e1583.member_2;
                                                }
                                                let _e1724 = phi_3564_;
                                                phi_3565_ = (_e704 + 1u);
                                                phi_3566_ = _e1724;
                                            } else {
                                                phi_3565_ = u32();
                                                phi_3566_ = type_50();
                                            }
                                            let _e1726 = phi_3565_;
                                            let _e1728 = phi_3566_;
                                            phi_3568_ = _e1726;
                                            phi_3569_ = _e1728;
                                            phi_3570_ = select(true, false, _e1684);
                                        } else {
                                            phi_3568_ = u32();
                                            phi_3569_ = type_50();
                                            phi_3570_ = true;
                                        }
                                        let _e1731 = phi_3568_;
                                        let _e1733 = phi_3569_;
                                        let _e1735 = phi_3570_;
                                        if _e1735 {
                                            if _e1683 {
                                                phi_3579_ = _e1583.member_1;
                                            } else {
                                                phi_3579_ = _e1583.member_2;
                                            }
                                            let _e1739 = phi_3579_;
                                            phi_3584_ = select(_e1684, true, _e1683);
                                            phi_3586_ = _e1739;
                                        } else {
                                            phi_3584_ = _e702;
                                            phi_3586_ = _e1733;
                                        }
                                        let _e1742 = phi_3584_;
                                        let _e1744 = phi_3586_;
                                        phi_3590_ = _e1742;
                                        phi_3591_ = select(_e1731, _e704, _e1735);
                                        phi_3592_ = _e1744;
                                    }
                                    let _e1747 = phi_3590_;
                                    let _e1749 = phi_3591_;
                                    let _e1751 = phi_3592_;
                                    if _e710 {
                                        phi_3602_ = _e706;
                                    } else {
                                        phi_3602_ = _e1751;
                                    }
                                    let _e1753 = phi_3602_;
                                    phi_4132_ = _e1305;
                                    phi_3603_ = _e1307;
                                    phi_3604_ = (_e665 - 1u);
                                    phi_3605_ = select(_e1747, false, _e710);
                                    phi_3606_ = select(_e1749, _e704, _e710);
                                    phi_3607_ = _e1753;
                                } else {
                                    phi_4132_ = _e661;
                                    phi_3603_ = _e663;
                                    phi_3604_ = _e665;
                                    phi_3605_ = _e702;
                                    phi_3606_ = _e704;
                                    phi_3607_ = _e706;
                                }
                                let _e1757 = phi_4132_;
                                let _e1759 = phi_3603_;
                                let _e1761 = phi_3604_;
                                let _e1763 = phi_3605_;
                                let _e1765 = phi_3606_;
                                let _e1767 = phi_3607_;
                                phi_4131_ = _e1757;
                                phi_3608_ = _e1759;
                                phi_3609_ = _e1761;
                                phi_3610_ = _e1763;
                                phi_3611_ = _e1765;
                                phi_3612_ = _e1767;
                            } else {
                                phi_4131_ = _e661;
                                phi_3608_ = type_38();
                                phi_3609_ = u32();
                                phi_3610_ = bool();
                                phi_3611_ = u32();
                                phi_3612_ = type_50();
                            }
                            let _e1769 = phi_4131_;
                            let _e1771 = phi_3608_;
                            let _e1773 = phi_3609_;
                            let _e1775 = phi_3610_;
                            let _e1777 = phi_3611_;
                            let _e1779 = phi_3612_;
                            phi_4130_ = _e1769;
                            phi_1162_ = _e1771;
                            phi_1165_ = _e1773;
                            phi_1167_ = _e1775;
                            phi_1169_ = _e1777;
                            phi_1171_ = _e1779;
                            phi_3613_ = _e675;
                        } else {
                            phi_4130_ = _e661;
                            phi_1162_ = type_38();
                            phi_1165_ = u32();
                            phi_1167_ = bool();
                            phi_1169_ = u32();
                            phi_1171_ = type_50();
                            phi_3613_ = false;
                        }
                        let _e1781 = phi_4130_;
                        let _e1783 = phi_1162_;
                        let _e1785 = phi_1165_;
                        let _e1787 = phi_1167_;
                        let _e1789 = phi_1169_;
                        let _e1791 = phi_1171_;
                        let _e1793 = phi_3613_;
                        continue;
                        continuing {
                            phi_3975_ = _e1781;
                            phi_1161_ = _e1783;
                            phi_1164_ = _e1785;
                            phi_1166_ = _e1787;
                            phi_1168_ = _e1789;
                            phi_1170_ = _e1791;
                            phi_4129_ = _e1781;
                            break if !(_e1793);
                        }
                    }
                    let _e1796 = phi_4129_;
                    if _e1796 {
                        break;
                    }
                    let _e1798 = local_10;
                    if (_e1798.member.member_3 != 4294967295u) {
                        let _e1803 = -(_e521);
                        let _e1804 = bitcast<u32>(_e1798.member.member);
                        let _e1808 = (bitcast<i32>((_e1804 >> bitcast<u32>(23i))) & 255i);
                        let _e1809 = (_e1808 + _e1803);
                        if (_e1808 == 255i) {
                            phi_3672_ = _e1798.member.member;
                        } else {
                            if (_e1808 > 0i) {
                                if (_e1809 > 0i) {
                                    let _e1813 = (_e1809 < 255i);
                                    if _e1813 {
                                        phi_3651_ = bitcast<f32>((_e1804 + bitcast<u32>((_e1803 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3651_ = f32();
                                    }
                                    let _e1820 = phi_3651_;
                                    phi_3653_ = _e1820;
                                    phi_3654_ = select(true, false, _e1813);
                                } else {
                                    phi_3653_ = f32();
                                    phi_3654_ = true;
                                }
                                let _e1823 = phi_3653_;
                                let _e1825 = phi_3654_;
                                phi_3655_ = _e1823;
                                phi_3656_ = _e1825;
                            } else {
                                phi_3655_ = f32();
                                phi_3656_ = true;
                            }
                            let _e1827 = phi_3655_;
                            let _e1829 = phi_3656_;
                            if _e1829 {
                                let _e1830 = (_e1804 & 2147483648u);
                                let _e1837 = ((_e1804 & 8388607u) | (select(0u, 1u, ((_e1804 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1841 = (_e1837 == 0u);
                                if _e1841 {
                                    phi_3927_ = bitcast<f32>(_e1830);
                                } else {
                                    let _e1846 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1837)), 32u, _e1841) - 8u);
                                    let _e1849 = (_e1837 << bitcast<u32>((_e1846 & 31u)));
                                    let _e1851 = ((_e1809 + select(0i, 1i, (_e1808 == 0i))) - bitcast<i32>(_e1846));
                                    if (_e1851 >= 255i) {
                                        phi_3917_ = bitcast<f32>((_e1830 | 2139095040u));
                                        phi_3918_ = f32();
                                        phi_3919_ = true;
                                    } else {
                                        let _e1853 = (_e1851 > 0i);
                                        if _e1853 {
                                            phi_3911_ = bitcast<f32>(((_e1830 | (bitcast<u32>(_e1851) << bitcast<u32>(23i))) | (_e1849 & 8388607u)));
                                            phi_3912_ = f32();
                                        } else {
                                            if (_e1851 < -24i) {
                                                phi_3877_ = 26u;
                                            } else {
                                                phi_3877_ = bitcast<u32>((1i - _e1851));
                                            }
                                            let _e1858 = phi_3877_;
                                            let _e1859 = (_e1858 & 31u);
                                            let _e1861 = (_e1849 >> bitcast<u32>(_e1859));
                                            let _e1865 = (_e1849 & ((1u << bitcast<u32>(_e1859)) - 1u));
                                            let _e1869 = (1u << bitcast<u32>(((_e1858 - 1u) & 31u)));
                                            if (_e1865 > _e1869) {
                                                phi_3898_ = true;
                                            } else {
                                                if (_e1865 == _e1869) {
                                                    phi_3895_ = ((_e1861 & 1u) == 1u);
                                                } else {
                                                    phi_3895_ = false;
                                                }
                                                let _e1875 = phi_3895_;
                                                phi_3898_ = _e1875;
                                            }
                                            let _e1877 = phi_3898_;
                                            phi_3911_ = f32();
                                            phi_3912_ = bitcast<f32>((_e1830 | (_e1861 + select(0u, 1u, _e1877))));
                                        }
                                        let _e1890 = phi_3911_;
                                        let _e1892 = phi_3912_;
                                        phi_3917_ = _e1890;
                                        phi_3918_ = _e1892;
                                        phi_3919_ = _e1853;
                                    }
                                    let _e1896 = phi_3917_;
                                    let _e1898 = phi_3918_;
                                    let _e1900 = phi_3919_;
                                    phi_3927_ = select(_e1898, _e1896, _e1900);
                                }
                                let _e1904 = phi_3927_;
                                phi_3671_ = _e1904;
                            } else {
                                phi_3671_ = _e1827;
                            }
                            let _e1906 = phi_3671_;
                            phi_3672_ = _e1906;
                        }
                        let _e1908 = phi_3672_;
                        let _e1909 = bitcast<u32>(_e1908);
                        if ((_e1909 & 2147483647u) >= 2139095040u) {
                            phi_3684_ = bitcast<f32>(((_e1909 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3684_ = _e1908;
                        }
                        let _e1916 = phi_3684_;
                        phi_3689_ = type_25(_e1916, _e1798.member.member_1, _e1798.member.member_2, _e1798.member.member_3);
                    } else {
                        phi_3689_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1921 = phi_3689_;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = _e1921;
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
