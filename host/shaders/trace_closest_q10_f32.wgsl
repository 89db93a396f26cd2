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
    var phi_3971_: bool;
    var phi_1161_: type_38;
    var phi_1164_: bool;
    var phi_1166_: u32;
    var phi_1168_: u32;
    var phi_1170_: type_50;
    var phi_1181_: bool;
    var phi_1267_: bool;
    var phi_1268_: u32;
    var phi_1269_: type_50;
    var phi_3091_: u32;
    var phi_3092_: u32;
    var phi_3102_: u32;
    var phi_3104_: u32;
    var phi_3105_: bool;
    var phi_3125_: u32;
    var phi_3126_: u32;
    var phi_3130_: type_51;
    var phi_3492_: type_50;
    var phi_3569_: type_50;
    var phi_3570_: u32;
    var phi_3571_: type_50;
    var phi_3573_: u32;
    var phi_3574_: type_50;
    var phi_3575_: bool;
    var phi_3584_: type_50;
    var phi_3589_: bool;
    var phi_3591_: type_50;
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
    var phi_3965_: bool;
    var phi_4129_: bool;
    var phi_3595_: type_38;
    var phi_3596_: bool;
    var phi_3597_: u32;
    var phi_3598_: type_50;
    var phi_4128_: bool;
    var phi_3599_: type_38;
    var phi_3600_: bool;
    var phi_3601_: u32;
    var phi_3602_: u32;
    var phi_3603_: type_50;
    var phi_4127_: bool;
    var phi_3604_: type_38;
    var phi_3605_: bool;
    var phi_3606_: u32;
    var phi_3607_: u32;
    var phi_3608_: type_50;
    var phi_4126_: bool;
    var phi_1162_: type_38;
    var phi_1165_: bool;
    var phi_1167_: u32;
    var phi_1169_: u32;
    var phi_1171_: type_50;
    var phi_3609_: bool;
    var phi_4125_: bool;
    var local_10: type_38;
    var phi_3647_: f32;
    var phi_3649_: f32;
    var phi_3650_: bool;
    var phi_3651_: f32;
    var phi_3652_: bool;
    var phi_3873_: u32;
    var phi_3891_: bool;
    var phi_3894_: bool;
    var phi_3907_: f32;
    var phi_3908_: f32;
    var phi_3913_: f32;
    var phi_3914_: f32;
    var phi_3915_: bool;
    var phi_3923_: f32;
    var phi_3667_: f32;
    var phi_3668_: f32;
    var phi_3680_: f32;
    var phi_3685_: type_25;
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
                    phi_3971_ = false;
                    phi_1161_ = type_38(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e617);
                    phi_1164_ = (_e619 <= _e617);
                    phi_1166_ = ((3u * _e94) + 1u);
                    phi_1168_ = 0u;
                    phi_1170_ = type_50(type_33(vec4<f32>((f32(_e626) * _e144), (f32(_e632) * _e144), (f32(_e638) * _e144), 0f), vec4<f32>((f32(_e643) * _e144), (f32(_e647) * _e144), (f32(_e651) * _e144), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    loop {
                        let _e661 = phi_3971_;
                        let _e663 = phi_1161_;
                        let _e665 = phi_1164_;
                        let _e667 = phi_1166_;
                        let _e669 = phi_1168_;
                        let _e671 = phi_1170_;
                        local_10 = _e663;
                        if _e665 {
                            phi_1181_ = true;
                        } else {
                            phi_1181_ = (_e669 > 0u);
                        }
                        let _e674 = phi_1181_;
                        if _e674 {
                            let _e675 = (_e667 > 0u);
                            if _e675 {
                                if _e665 {
                                    phi_1267_ = _e665;
                                    phi_1268_ = _e669;
                                    phi_1269_ = _e671;
                                } else {
                                    let _e676 = (_e669 - 1u);
                                    let _e677 = (_e676 % 128u);
                                    let _e678 = (_e677 < 128u);
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e680 = local_7[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e682 = local_6[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e684 = local_5[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e686 = local_4[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e688 = local_3[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e690 = local_2[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e695 = local_8[_e677];
                                    if _e678 {
                                    } else {
                                        phi_4125_ = true;
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
                                    if ((_e706.member_1 & 2147483648u) != 0u) {
                                        phi_1287_ = _e663;
                                        phi_1290_ = type_4(0u, ((_e706.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1156 = phi_1287_;
                                            let _e1158 = phi_1290_;
                                            local_11 = _e1156;
                                            if (_e1158.member < _e1158.member_1) {
                                                phi_1291_ = type_4((_e1158.member + 1u), _e1158.member_1);
                                                phi_1313_ = type_4(1u, _e1158.member);
                                            } else {
                                                phi_1291_ = _e1158;
                                                phi_1313_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1171 = phi_1291_;
                                            let _e1173 = phi_1313_;
                                            let _e1177 = (bitcast<i32>(_e1173.member) != 0i);
                                            if _e1177 {
                                                let _e1178 = ((_e706.member_1 & 268435455u) + _e1173.member_1);
                                                let _e1179 = (_e1178 < _e96);
                                                if _e1179 {
                                                    if _e1179 {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1183 = global_2.member[_e1178].member_1;
                                                    phi_1334_ = _e1183;
                                                } else {
                                                    phi_1334_ = 4294967295u;
                                                }
                                                let _e1185 = phi_1334_;
                                                if (_e1178 >= _e96) {
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1179 {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    if (_e623 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1192 = global_2.member[_e1178].member[_e623];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1198 = global_2.member[_e1178].member[_e629];
                                                    if (_e635 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1204 = global_2.member[_e1178].member[_e635];
                                                    let _e1206 = (3u + _e623);
                                                    if (_e1206 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1212 = global_2.member[_e1178].member[_e1206];
                                                    let _e1213 = (3u + _e629);
                                                    if (_e1213 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1219 = global_2.member[_e1178].member[_e1213];
                                                    let _e1220 = (3u + _e635);
                                                    if (_e1220 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1226 = global_2.member[_e1178].member[_e1220];
                                                    let _e1228 = (6u + _e623);
                                                    if (_e1228 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1234 = global_2.member[_e1178].member[_e1228];
                                                    let _e1235 = (6u + _e629);
                                                    if (_e1235 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1241 = global_2.member[_e1178].member[_e1235];
                                                    let _e1242 = (6u + _e635);
                                                    if (_e1242 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1248 = global_2.member[_e1178].member[_e1242];
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1192, _e1198, _e1204), array<f32, 3>(_e1212, _e1219, _e1226), array<f32, 3>(_e1234, _e1241, _e1248));
                                                }
                                                let _e1252 = phi_1426_;
                                                let _e1260 = (_e1252[0][2] - _e465);
                                                let _e1263 = (((_e1252[0][0] - _e328) * _e504) - (_e1260 * _e368));
                                                let _e1266 = (((_e1252[0][1] - _e397) * _e504) - (_e1260 * _e436));
                                                let _e1273 = (_e1252[1][2] - _e465);
                                                let _e1276 = (((_e1252[1][0] - _e328) * _e504) - (_e1273 * _e368));
                                                let _e1279 = (((_e1252[1][1] - _e397) * _e504) - (_e1273 * _e436));
                                                let _e1286 = (_e1252[2][2] - _e465);
                                                let _e1289 = (((_e1252[2][0] - _e328) * _e504) - (_e1286 * _e368));
                                                let _e1292 = (((_e1252[2][1] - _e397) * _e504) - (_e1286 * _e436));
                                                let _e1293 = (_e1289 * _e1279);
                                                let _e1294 = (_e1292 * _e1276);
                                                let _e1295 = (_e1263 * _e1292);
                                                let _e1296 = (_e1266 * _e1289);
                                                let _e1297 = (_e1276 * _e1266);
                                                let _e1298 = (_e1279 * _e1263);
                                                let _e1303 = (((_e1293 >= _e1294) && (_e1295 >= _e1296)) && (_e1297 >= _e1298));
                                                if (_e1303 || (((_e1293 <= _e1294) && (_e1295 <= _e1296)) && (_e1297 <= _e1298))) {
                                                    let _e1310 = select(-1f, 1f, _e1303);
                                                    let _e1312 = ((_e1293 - _e1294) * _e1310);
                                                    let _e1314 = select(0f, _e1312, (_e1312 > 0f));
                                                    let _e1316 = ((_e1295 - _e1296) * _e1310);
                                                    let _e1318 = select(0f, _e1316, (_e1316 > 0f));
                                                    let _e1320 = ((_e1297 - _e1298) * _e1310);
                                                    let _e1322 = select(0f, _e1320, (_e1320 > 0f));
                                                    let _e1324 = ((_e1314 + _e1318) + _e1322);
                                                    if (_e1324 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2310_ = type_25();
                                                        phi_2311_ = true;
                                                        phi_2312_ = false;
                                                    } else {
                                                        let _e1327 = select(_e1276, _e1263, (_e1263 < _e1276));
                                                        if (select(_e1289, _e1327, (_e1327 < _e1289)) > 0f) {
                                                            phi_1578_ = true;
                                                        } else {
                                                            let _e1332 = select(_e1276, _e1263, (_e1263 > _e1276));
                                                            phi_1578_ = (select(_e1289, _e1332, (_e1332 > _e1289)) < 0f);
                                                        }
                                                        let _e1337 = phi_1578_;
                                                        if _e1337 {
                                                            phi_2307_ = type_25();
                                                            phi_2308_ = true;
                                                            phi_2309_ = false;
                                                        } else {
                                                            let _e1339 = select(_e1279, _e1266, (_e1266 < _e1279));
                                                            if (select(_e1292, _e1339, (_e1339 < _e1292)) > 0f) {
                                                                phi_1607_ = true;
                                                            } else {
                                                                let _e1344 = select(_e1279, _e1266, (_e1266 > _e1279));
                                                                phi_1607_ = (select(_e1292, _e1344, (_e1344 > _e1292)) < 0f);
                                                            }
                                                            let _e1349 = phi_1607_;
                                                            if _e1349 {
                                                                phi_2305_ = type_25();
                                                                phi_2306_ = false;
                                                            } else {
                                                                let _e1351 = select(_e1252[1][0], _e1252[0][0], (_e1252[0][0] < _e1252[1][0]));
                                                                let _e1355 = select(_e1252[1][0], _e1252[0][0], (_e1252[0][0] > _e1252[1][0]));
                                                                let _e1359 = select(_e1252[1][1], _e1252[0][1], (_e1252[0][1] < _e1252[1][1]));
                                                                let _e1363 = select(_e1252[1][1], _e1252[0][1], (_e1252[0][1] > _e1252[1][1]));
                                                                let _e1367 = select(_e1252[1][2], _e1252[0][2], (_e1252[0][2] < _e1252[1][2]));
                                                                let _e1371 = select(_e1252[1][2], _e1252[0][2], (_e1252[0][2] > _e1252[1][2]));
                                                                let _e1376 = ((select(_e1252[2][0], _e1351, (_e1351 < _e1252[2][0])) - _e366) * _e371);
                                                                let _e1377 = ((select(_e1252[2][0], _e1355, (_e1355 > _e1252[2][0])) - _e367) * _e371);
                                                                let _e1380 = ((select(_e1252[2][1], _e1359, (_e1359 < _e1252[2][1])) - _e434) * _e439);
                                                                let _e1381 = ((select(_e1252[2][1], _e1363, (_e1363 > _e1252[2][1])) - _e435) * _e439);
                                                                let _e1384 = ((select(_e1252[2][2], _e1367, (_e1367 < _e1252[2][2])) - _e502) * _e507);
                                                                let _e1385 = ((select(_e1252[2][2], _e1371, (_e1371 > _e1252[2][2])) - _e503) * _e507);
                                                                let _e1387 = select(_e1385, _e1384, (_e1384 < _e1385));
                                                                let _e1389 = select(_e1385, _e1384, (_e1384 > _e1385));
                                                                let _e1391 = select(_e1377, _e1376, (_e1376 < _e1377));
                                                                let _e1393 = select(_e1381, _e1380, (_e1380 < _e1381));
                                                                let _e1395 = select(_e1393, _e1391, (_e1391 > _e1393));
                                                                let _e1397 = select(_e1387, _e1395, (_e1395 > _e1387));
                                                                let _e1399 = select(_e1377, _e1376, (_e1376 > _e1377));
                                                                let _e1401 = select(_e1381, _e1380, (_e1380 > _e1381));
                                                                let _e1403 = select(_e1401, _e1399, (_e1399 < _e1401));
                                                                let _e1405 = select(_e1389, _e1403, (_e1403 < _e1389));
                                                                let _e1406 = -(_e1387);
                                                                let _e1412 = select(_e619, _e1397, (_e1397 > _e619));
                                                                if (_e1412 > (_e1405 + (select(_e1406, _e1389, (_e1389 > _e1406)) * 0.0000019073523f))) {
                                                                    phi_2300_ = type_25();
                                                                    phi_2301_ = true;
                                                                } else {
                                                                    let _e1414 = (_e1412 > _e1156.member_1);
                                                                    if _e1414 {
                                                                        phi_2299_ = type_25();
                                                                    } else {
                                                                        let _e1415 = vec3<f32>(_e1252[0][0], _e1252[0][1], _e1252[0][2]);
                                                                        let _e1416 = vec3<f32>(_e1252[1][0], _e1252[1][1], _e1252[1][2]);
                                                                        let _e1417 = vec3<f32>(_e1252[2][0], _e1252[2][1], _e1252[2][2]);
                                                                        let _e1418 = (_e1252[1][0] - _e1252[0][0]);
                                                                        let _e1419 = (_e1252[1][1] - _e1252[0][1]);
                                                                        let _e1420 = (_e1252[1][2] - _e1252[0][2]);
                                                                        let _e1421 = vec3<f32>(_e1418, _e1419, _e1420);
                                                                        let _e1422 = (_e1252[2][0] - _e1252[1][0]);
                                                                        let _e1423 = (_e1252[2][1] - _e1252[1][1]);
                                                                        let _e1424 = (_e1252[2][2] - _e1252[1][2]);
                                                                        let _e1425 = vec3<f32>(_e1422, _e1423, _e1424);
                                                                        let _e1426 = (_e1252[0][0] - _e1252[2][0]);
                                                                        let _e1427 = (_e1252[0][1] - _e1252[2][1]);
                                                                        let _e1428 = (_e1252[0][2] - _e1252[2][2]);
                                                                        let _e1429 = vec3<f32>(_e1426, _e1427, _e1428);
                                                                        let _e1432 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1435 = bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u));
                                                                        let _e1437 = select(_e1435, _e1432, (_e1432 > _e1435));
                                                                        let _e1440 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1442 = select(_e1440, _e1437, (_e1437 > _e1440));
                                                                        let _e1445 = bitcast<f32>((bitcast<u32>(_e1422) & 2147483647u));
                                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                        let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                                        let _e1453 = bitcast<f32>((bitcast<u32>(_e1424) & 2147483647u));
                                                                        let _e1455 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                                        let _e1458 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                        let _e1461 = bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u));
                                                                        let _e1463 = select(_e1461, _e1458, (_e1458 > _e1461));
                                                                        let _e1466 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                        let _e1468 = select(_e1466, _e1463, (_e1463 > _e1466));
                                                                        let _e1470 = select(_e1455, _e1442, (_e1442 > _e1455));
                                                                        let _e1472 = select(_e1468, _e1470, (_e1470 > _e1468));
                                                                        if (_e1442 == _e1472) {
                                                                            phi_2026_ = _e1279;
                                                                            phi_2027_ = _e1276;
                                                                            phi_2028_ = _e1266;
                                                                            phi_2029_ = _e1263;
                                                                            phi_2030_ = _e1415;
                                                                            phi_2031_ = _e1429;
                                                                            phi_2032_ = _e1425;
                                                                            phi_2033_ = _e1421;
                                                                        } else {
                                                                            let _e1474 = (_e1455 == _e1472);
                                                                            let _e1479 = vec3(_e1474);
                                                                            phi_2026_ = select(_e1266, _e1292, _e1474);
                                                                            phi_2027_ = select(_e1263, _e1289, _e1474);
                                                                            phi_2028_ = select(_e1292, _e1279, _e1474);
                                                                            phi_2029_ = select(_e1289, _e1276, _e1474);
                                                                            phi_2030_ = select(_e1417, _e1416, _e1479);
                                                                            phi_2031_ = select(_e1425, _e1421, _e1479);
                                                                            phi_2032_ = select(_e1421, _e1429, _e1479);
                                                                            phi_2033_ = select(_e1429, _e1425, _e1479);
                                                                        }
                                                                        let _e1485 = phi_2026_;
                                                                        let _e1487 = phi_2027_;
                                                                        let _e1489 = phi_2028_;
                                                                        let _e1491 = phi_2029_;
                                                                        let _e1493 = phi_2030_;
                                                                        let _e1495 = phi_2031_;
                                                                        let _e1497 = phi_2032_;
                                                                        let _e1499 = phi_2033_;
                                                                        let _e1506 = ((_e1497.y * _e1495.z) - (_e1495.y * _e1497.z));
                                                                        let _e1511 = ((_e1497.z * _e1495.x) - (_e1495.z * _e1497.x));
                                                                        let _e1514 = ((_e1497.x * _e1495.y) - (_e1495.x * _e1497.y));
                                                                        if (_e1314 >= _e1318) {
                                                                            phi_2070_ = select(true, false, (_e1314 >= _e1322));
                                                                        } else {
                                                                            phi_2070_ = true;
                                                                        }
                                                                        let _e1519 = phi_2070_;
                                                                        if _e1519 {
                                                                            phi_2079_ = select(_e1417, _e1416, vec3((_e1318 >= _e1322)));
                                                                        } else {
                                                                            phi_2079_ = _e1415;
                                                                        }
                                                                        let _e1524 = phi_2079_;
                                                                        let _e1535 = (((_e1506 * (_e1524.x - _e328)) + (_e1511 * (_e1524.y - _e397))) + (_e1514 * (_e1524.z - _e465)));
                                                                        let _e1540 = (((_e1506 * _e368) + (_e1511 * _e436)) + (_e1514 * _e504));
                                                                        let _e1541 = (_e1487 - _e1491);
                                                                        let _e1542 = (_e1485 - _e1489);
                                                                        let _e1550 = (-(((_e1491 * _e1541) + (_e1489 * _e1542))) / ((_e1541 * _e1541) + (_e1542 * _e1542)));
                                                                        let _e1552 = select(1f, _e1550, (_e1550 < 1f));
                                                                        let _e1554 = select(0f, _e1552, (_e1552 > 0f));
                                                                        let _e1567 = ((_e1493.x + (_e1499.x * _e1554)) - _e328);
                                                                        let _e1568 = ((_e1493.y + (_e1499.y * _e1554)) - _e397);
                                                                        let _e1569 = ((_e1493.z + (_e1499.z * _e1554)) - _e465);
                                                                        let _e1570 = (_e1569 / _e504);
                                                                        let _e1582 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                        let _e1585 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                        let _e1587 = select(_e1585, _e1582, (_e1582 > _e1585));
                                                                        let _e1590 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                        let _e1592 = select(_e1590, _e1587, (_e1587 > _e1590));
                                                                        let _e1598 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
                                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1511) & 2147483647u));
                                                                        let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1514) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1506 * _e1567) + (_e1511 * _e1568)) + (_e1514 * _e1569)) - _e1535)) & 2147483647u)) <= ((0.0000009536743f * select(_e1472, _e1592, (_e1592 > _e1472))) * select(_e1606, _e1603, (_e1603 > _e1606)))) {
                                                                            let _e1616 = bitcast<f32>((bitcast<u32>(_e1497.x) & 2147483647u));
                                                                            let _e1619 = bitcast<f32>((bitcast<u32>(_e1497.y) & 2147483647u));
                                                                            let _e1621 = select(_e1619, _e1616, (_e1616 > _e1619));
                                                                            let _e1624 = bitcast<f32>((bitcast<u32>(_e1497.z) & 2147483647u));
                                                                            let _e1630 = bitcast<f32>((bitcast<u32>(_e1495.x) & 2147483647u));
                                                                            let _e1633 = bitcast<f32>((bitcast<u32>(_e1495.y) & 2147483647u));
                                                                            let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                                            let _e1638 = bitcast<f32>((bitcast<u32>(_e1495.z) & 2147483647u));
                                                                            let _e1642 = (bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u)) > ((0.0000038146973f * select(_e1624, _e1621, (_e1621 > _e1624))) * select(_e1638, _e1635, (_e1635 > _e1638))));
                                                                            if _e1642 {
                                                                                phi_2244_ = (_e1535 / _e1540);
                                                                            } else {
                                                                                phi_2244_ = f32();
                                                                            }
                                                                            let _e1645 = phi_2244_;
                                                                            phi_2246_ = _e1645;
                                                                            phi_2247_ = select(true, false, _e1642);
                                                                        } else {
                                                                            phi_2246_ = f32();
                                                                            phi_2247_ = true;
                                                                        }
                                                                        let _e1648 = phi_2246_;
                                                                        let _e1650 = phi_2247_;
                                                                        if _e1650 {
                                                                            let _e1658 = (((_e1506 * (_e1567 - (_e368 * _e1570))) + (_e1511 * (_e1568 - (_e436 * _e1570)))) / _e1540);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u)) <= _e1472) {
                                                                                phi_2267_ = (_e1570 + _e1658);
                                                                            } else {
                                                                                phi_2267_ = _e1570;
                                                                            }
                                                                            let _e1665 = phi_2267_;
                                                                            phi_2268_ = _e1665;
                                                                        } else {
                                                                            phi_2268_ = _e1648;
                                                                        }
                                                                        let _e1667 = phi_2268_;
                                                                        let _e1669 = select(_e1405, _e1667, (_e1667 < _e1405));
                                                                        let _e1671 = select(_e1397, _e1669, (_e1669 > _e1397));
                                                                        if (_e1671 >= _e619) {
                                                                            let _e1673 = (_e1671 <= _e1156.member_1);
                                                                            if _e1673 {
                                                                                let _e1674 = (1f / _e1324);
                                                                                phi_2291_ = type_25(_e1671, (_e1318 * _e1674), (_e1322 * _e1674), _e1185);
                                                                            } else {
                                                                                phi_2291_ = type_25();
                                                                            }
                                                                            let _e1679 = phi_2291_;
                                                                            phi_2293_ = _e1679;
                                                                            phi_2294_ = select(true, false, _e1673);
                                                                        } else {
                                                                            phi_2293_ = type_25();
                                                                            phi_2294_ = true;
                                                                        }
                                                                        let _e1682 = phi_2293_;
                                                                        let _e1684 = phi_2294_;
                                                                        if _e1684 {
                                                                            phi_2298_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2298_ = _e1682;
                                                                        }
                                                                        let _e1686 = phi_2298_;
                                                                        phi_2299_ = _e1686;
                                                                    }
                                                                    let _e1688 = phi_2299_;
                                                                    phi_2300_ = _e1688;
                                                                    phi_2301_ = _e1414;
                                                                }
                                                                let _e1690 = phi_2300_;
                                                                let _e1692 = phi_2301_;
                                                                phi_2305_ = _e1690;
                                                                phi_2306_ = _e1692;
                                                            }
                                                            let _e1694 = phi_2305_;
                                                            let _e1696 = phi_2306_;
                                                            phi_2307_ = _e1694;
                                                            phi_2308_ = _e1349;
                                                            phi_2309_ = _e1696;
                                                        }
                                                        let _e1698 = phi_2307_;
                                                        let _e1700 = phi_2308_;
                                                        let _e1702 = phi_2309_;
                                                        phi_2310_ = _e1698;
                                                        phi_2311_ = _e1700;
                                                        phi_2312_ = _e1702;
                                                    }
                                                    let _e1704 = phi_2310_;
                                                    let _e1706 = phi_2311_;
                                                    let _e1708 = phi_2312_;
                                                    phi_2320_ = _e1704;
                                                    phi_2321_ = select(_e1708, true, _e1706);
                                                } else {
                                                    phi_2320_ = type_25();
                                                    phi_2321_ = true;
                                                }
                                                let _e1711 = phi_2320_;
                                                let _e1713 = phi_2321_;
                                                if _e1713 {
                                                    phi_2325_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2325_ = _e1711;
                                                }
                                                let _e1715 = phi_2325_;
                                                if (_e1715.member_3 != 4294967295u) {
                                                    if (_e1185 != 4294967295u) {
                                                        if (_e1715.member < _e1156.member.member) {
                                                            phi_2351_ = true;
                                                        } else {
                                                            if (_e1715.member == _e1156.member.member) {
                                                                phi_2350_ = (_e1715.member_3 < _e1156.member.member_3);
                                                            } else {
                                                                phi_2350_ = false;
                                                            }
                                                            let _e1728 = phi_2350_;
                                                            phi_2351_ = _e1728;
                                                        }
                                                        let _e1730 = phi_2351_;
                                                        if _e1730 {
                                                            phi_2357_ = type_38(_e1715, _e1715.member);
                                                        } else {
                                                            phi_2357_ = _e1156;
                                                        }
                                                        let _e1733 = phi_2357_;
                                                        phi_2358_ = _e1733;
                                                    } else {
                                                        phi_2358_ = _e1156;
                                                    }
                                                    let _e1735 = phi_2358_;
                                                    phi_2359_ = _e1735;
                                                } else {
                                                    phi_2359_ = _e1156;
                                                }
                                                let _e1737 = phi_2359_;
                                                phi_1288_ = _e1737;
                                            } else {
                                                phi_1288_ = type_38();
                                            }
                                            let _e1739 = phi_1288_;
                                            continue;
                                            continuing {
                                                phi_1287_ = _e1739;
                                                phi_1290_ = _e1171;
                                                phi_3965_ = _e661;
                                                break if !(_e1177);
                                            }
                                        }
                                        let _e1742 = phi_3965_;
                                        phi_4125_ = _e1742;
                                        if _e1742 {
                                            break;
                                        }
                                        phi_4129_ = _e1742;
                                        let _e2035 = local_11;
                                        phi_3595_ = _e2035;
                                        phi_3596_ = false;
                                        phi_3597_ = _e704;
                                        phi_3598_ = _e706;
                                    } else {
                                        if (_e706.member_1 >= _e94) {
                                            phi_3130_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e706.member_1 < _e94) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e718 = ((1u + _e264) % 4u);
                                            if (_e718 < 4u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e723 = global_4.member[_e706.member_1][_e718];
                                            let _e725 = (_e723 >> bitcast<u32>(11u));
                                            let _e727 = ((1u + _e263) % 4u);
                                            if (_e727 < 4u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e732 = global_4.member[_e706.member_1][_e727];
                                            let _e734 = (_e732 >> bitcast<u32>(11u));
                                            let _e736 = ((1u + _e265) % 4u);
                                            if (_e736 < 4u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e741 = global_4.member[_e706.member_1][_e736];
                                            let _e743 = (_e741 >> bitcast<u32>(11u));
                                            let _e766 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.x - _e706.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e767 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.y - _e706.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e768 = (bitcast<f32>((bitcast<u32>((_e706.member.member_1.z - _e706.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e770 = select(_e144, _e766, (_e766 > _e144));
                                            let _e772 = select(_e144, _e767, (_e767 > _e144));
                                            let _e774 = select(_e144, _e768, (_e768 > _e144));
                                            let _e805 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e723 & 1023u))) - 8388608f) * _e770));
                                            let _e810 = (bitcast<i32>((_e723 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e813 = bitcast<f32>((_e805 & bitcast<u32>(_e810)));
                                            let _e814 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e732 & 1023u))) - 8388608f) * _e772));
                                            let _e819 = (bitcast<i32>((_e732 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e822 = bitcast<f32>((_e814 & bitcast<u32>(_e819)));
                                            let _e823 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 1023u))) - 8388608f) * _e774));
                                            let _e828 = (bitcast<i32>((_e741 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e831 = bitcast<f32>((_e823 & bitcast<u32>(_e828)));
                                            let _e835 = bitcast<f32>((_e805 & bitcast<u32>(~(_e810))));
                                            let _e839 = bitcast<f32>((_e814 & bitcast<u32>(~(_e819))));
                                            let _e843 = bitcast<f32>((_e823 & bitcast<u32>(~(_e828))));
                                            let _e844 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e725 & 1023u))) - 8388608f) * _e770));
                                            let _e849 = (bitcast<i32>((_e725 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e852 = bitcast<f32>((_e844 & bitcast<u32>(_e849)));
                                            let _e853 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e734 & 1023u))) - 8388608f) * _e772));
                                            let _e858 = (bitcast<i32>((_e734 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e861 = bitcast<f32>((_e853 & bitcast<u32>(_e858)));
                                            let _e862 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e743 & 1023u))) - 8388608f) * _e774));
                                            let _e867 = (bitcast<i32>((_e743 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e870 = bitcast<f32>((_e862 & bitcast<u32>(_e867)));
                                            let _e874 = bitcast<f32>((_e844 & bitcast<u32>(~(_e849))));
                                            let _e878 = bitcast<f32>((_e853 & bitcast<u32>(~(_e858))));
                                            let _e882 = bitcast<f32>((_e862 & bitcast<u32>(~(_e867))));
                                            let _e912 = global_4.member[_e706.member_1][0u];
                                            let _e916 = global_4.member[_e706.member_1][1u];
                                            let _e920 = global_4.member[_e706.member_1][2u];
                                            let _e924 = global_4.member[_e706.member_1][3u];
                                            let _e936 = (((_e916 >> bitcast<u32>(22i)) | ((_e920 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e924 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e937 = (_e912 & 268435455u);
                                            let _e938 = (_e936 & 268435455u);
                                            let _e941 = ((_e912 >> bitcast<u32>(28u)) & 7u);
                                            let _e949 = ((_e912 >> bitcast<u32>(31i)) | (((_e936 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e950 = (_e941 != 0u);
                                            if (_e941 == 0u) {
                                                phi_3092_ = _e937;
                                            } else {
                                                if (_e941 == 7u) {
                                                    phi_3091_ = 2147483648u;
                                                } else {
                                                    phi_3091_ = ((2147483648u | (_e941 << bitcast<u32>(28u))) | (_e938 & 268435455u));
                                                }
                                                let _e959 = phi_3091_;
                                                phi_3092_ = _e959;
                                            }
                                            let _e961 = phi_3092_;
                                            if _e950 {
                                                let _e962 = (_e941 != 7u);
                                                if _e962 {
                                                    phi_3102_ = (_e938 + _e941);
                                                } else {
                                                    phi_3102_ = u32();
                                                }
                                                let _e965 = phi_3102_;
                                                phi_3104_ = _e965;
                                                phi_3105_ = select(true, false, _e962);
                                            } else {
                                                phi_3104_ = u32();
                                                phi_3105_ = true;
                                            }
                                            let _e968 = phi_3104_;
                                            let _e970 = phi_3105_;
                                            if (_e949 == 0u) {
                                                phi_3126_ = (_e937 + select(0u, 1u, !(_e950)));
                                            } else {
                                                if (_e949 == 7u) {
                                                    phi_3125_ = 2147483648u;
                                                } else {
                                                    phi_3125_ = ((2147483648u | (_e949 << bitcast<u32>(28u))) | (select(_e968, _e938, _e970) & 268435455u));
                                                }
                                                let _e983 = phi_3125_;
                                                phi_3126_ = _e983;
                                            }
                                            let _e985 = phi_3126_;
                                            phi_3130_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e706.member.member.x + _e813), (_e706.member.member.x + _e835), (_e706.member.member_1.x - _e852), (_e706.member.member_1.x - _e874)), vec4<f32>((_e706.member.member.y + _e822), (_e706.member.member.y + _e839), (_e706.member.member_1.y - _e861), (_e706.member.member_1.y - _e878)), vec4<f32>((_e706.member.member.z + _e831), (_e706.member.member.z + _e843), (_e706.member.member_1.z - _e870), (_e706.member.member_1.z - _e882))), type_50(type_33((_e706.member.member + vec4<f32>(_e813, _e822, _e831, 0f)), (_e706.member.member_1 - vec4<f32>(_e852, _e861, _e870, 0f))), _e961), type_50(type_33((_e706.member.member + vec4<f32>(_e835, _e839, _e843, 0f)), (_e706.member.member_1 - vec4<f32>(_e874, _e878, _e882, 0f))), _e985));
                                        }
                                        let _e990 = phi_3130_;
                                        let _e1002 = ((_e990.member[0].x - _e366) * _e371);
                                        let _e1003 = ((_e990.member[0].y - _e366) * _e371);
                                        let _e1004 = ((_e990.member[0].z - _e367) * _e371);
                                        let _e1005 = ((_e990.member[0].w - _e367) * _e371);
                                        let _e1015 = ((_e990.member[1].x - _e434) * _e439);
                                        let _e1016 = ((_e990.member[1].y - _e434) * _e439);
                                        let _e1017 = ((_e990.member[1].z - _e435) * _e439);
                                        let _e1018 = ((_e990.member[1].w - _e435) * _e439);
                                        let _e1028 = ((_e990.member[2].x - _e502) * _e507);
                                        let _e1029 = ((_e990.member[2].y - _e502) * _e507);
                                        let _e1030 = ((_e990.member[2].z - _e503) * _e507);
                                        let _e1031 = ((_e990.member[2].w - _e503) * _e507);
                                        let _e1033 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1035 = select(_e1031, _e1029, (_e1029 < _e1031));
                                        let _e1037 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1039 = select(_e1031, _e1029, (_e1029 > _e1031));
                                        let _e1041 = select(_e1004, _e1002, (_e1002 < _e1004));
                                        let _e1043 = select(_e1005, _e1003, (_e1003 < _e1005));
                                        let _e1045 = select(_e1017, _e1015, (_e1015 < _e1017));
                                        let _e1047 = select(_e1018, _e1016, (_e1016 < _e1018));
                                        let _e1049 = select(_e1045, _e1041, (_e1041 > _e1045));
                                        let _e1051 = select(_e1047, _e1043, (_e1043 > _e1047));
                                        let _e1053 = select(_e1033, _e1049, (_e1049 > _e1033));
                                        let _e1055 = select(_e1035, _e1051, (_e1051 > _e1035));
                                        let _e1057 = select(_e1004, _e1002, (_e1002 > _e1004));
                                        let _e1059 = select(_e1005, _e1003, (_e1003 > _e1005));
                                        let _e1061 = select(_e1017, _e1015, (_e1015 > _e1017));
                                        let _e1063 = select(_e1018, _e1016, (_e1016 > _e1018));
                                        let _e1065 = select(_e1061, _e1057, (_e1057 < _e1061));
                                        let _e1067 = select(_e1063, _e1059, (_e1059 < _e1063));
                                        let _e1072 = -(_e1033);
                                        let _e1073 = -(_e1035);
                                        let _e1080 = (select(_e1037, _e1065, (_e1065 < _e1037)) + (select(_e1072, _e1037, (_e1037 > _e1072)) * 0.0000019073523f));
                                        let _e1081 = (select(_e1039, _e1067, (_e1067 < _e1039)) + (select(_e1073, _e1039, (_e1039 > _e1073)) * 0.0000019073523f));
                                        let _e1083 = select(_e619, _e1053, (_e1053 > _e619));
                                        let _e1085 = select(_e619, _e1055, (_e1055 > _e619));
                                        let _e1090 = (_e1083 <= select(_e663.member_1, _e1080, (_e1080 < _e663.member_1)));
                                        let _e1091 = (_e1085 <= select(_e663.member_1, _e1081, (_e1081 < _e663.member_1)));
                                        let _e1092 = (_e1083 <= _e1085);
                                        if _e1090 {
                                            if _e1091 {
                                                if _e1092 {
                                                    phi_3492_ = _e990.member_2;
                                                } else {
                                                    phi_3492_ = _e990.member_1;
                                                }
                                                let _e1096 = phi_3492_;
                                                let _e1118 = (_e704 % 128u);
                                                let _e1119 = (_e1118 < 128u);
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_8[_e1118] = _e1096.member_1;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_7[_e1118] = _e1096.member.member.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_6[_e1118] = _e1096.member.member.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_5[_e1118] = _e1096.member.member.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_4[_e1118] = _e1096.member.member_1.x;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_3[_e1118] = _e1096.member.member_1.y;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_2[_e1118] = _e1096.member.member_1.z;
                                                if _e1119 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_9[_e1118] = select(_e1085, _e1083, !(_e1092));
                                                if _e1092 {
                                                    phi_3569_ = _e990.member_1;
                                                } else {
                                                    phi_3569_ = _e990.member_2;
                                                }
                                                let _e1132 = phi_3569_;
                                                phi_3570_ = (_e704 + 1u);
                                                phi_3571_ = _e1132;
                                            } else {
                                                phi_3570_ = u32();
                                                phi_3571_ = type_50();
                                            }
                                            let _e1134 = phi_3570_;
                                            let _e1136 = phi_3571_;
                                            phi_3573_ = _e1134;
                                            phi_3574_ = _e1136;
                                            phi_3575_ = select(true, false, _e1091);
                                        } else {
                                            phi_3573_ = u32();
                                            phi_3574_ = type_50();
                                            phi_3575_ = true;
                                        }
                                        let _e1139 = phi_3573_;
                                        let _e1141 = phi_3574_;
                                        let _e1143 = phi_3575_;
                                        if _e1143 {
                                            if _e1090 {
                                                phi_3584_ = _e990.member_1;
                                            } else {
                                                phi_3584_ = _e990.member_2;
                                            }
                                            let _e1147 = phi_3584_;
                                            phi_3589_ = select(_e1091, true, _e1090);
                                            phi_3591_ = _e1147;
                                        } else {
                                            phi_3589_ = _e702;
                                            phi_3591_ = _e1141;
                                        }
                                        let _e1150 = phi_3589_;
                                        let _e1152 = phi_3591_;
                                        phi_4129_ = _e661;
                                        phi_3595_ = _e663;
                                        phi_3596_ = _e1150;
                                        phi_3597_ = select(_e1139, _e704, _e1143);
                                        phi_3598_ = _e1152;
                                    }
                                    let _e1744 = phi_4129_;
                                    let _e1746 = phi_3595_;
                                    let _e1748 = phi_3596_;
                                    let _e1750 = phi_3597_;
                                    let _e1752 = phi_3598_;
                                    phi_4128_ = _e1744;
                                    phi_3599_ = _e1746;
                                    phi_3600_ = _e1748;
                                    phi_3601_ = (_e667 - 1u);
                                    phi_3602_ = _e1750;
                                    phi_3603_ = _e1752;
                                } else {
                                    phi_4128_ = _e661;
                                    phi_3599_ = _e663;
                                    phi_3600_ = _e702;
                                    phi_3601_ = _e667;
                                    phi_3602_ = _e704;
                                    phi_3603_ = _e706;
                                }
                                let _e1754 = phi_4128_;
                                let _e1756 = phi_3599_;
                                let _e1758 = phi_3600_;
                                let _e1760 = phi_3601_;
                                let _e1762 = phi_3602_;
                                let _e1764 = phi_3603_;
                                phi_4127_ = _e1754;
                                phi_3604_ = _e1756;
                                phi_3605_ = _e1758;
                                phi_3606_ = _e1760;
                                phi_3607_ = _e1762;
                                phi_3608_ = _e1764;
                            } else {
                                phi_4127_ = _e661;
                                phi_3604_ = type_38();
                                phi_3605_ = bool();
                                phi_3606_ = u32();
                                phi_3607_ = u32();
                                phi_3608_ = type_50();
                            }
                            let _e1766 = phi_4127_;
                            let _e1768 = phi_3604_;
                            let _e1770 = phi_3605_;
                            let _e1772 = phi_3606_;
                            let _e1774 = phi_3607_;
                            let _e1776 = phi_3608_;
                            phi_4126_ = _e1766;
                            phi_1162_ = _e1768;
                            phi_1165_ = _e1770;
                            phi_1167_ = _e1772;
                            phi_1169_ = _e1774;
                            phi_1171_ = _e1776;
                            phi_3609_ = _e675;
                        } else {
                            phi_4126_ = _e661;
                            phi_1162_ = type_38();
                            phi_1165_ = bool();
                            phi_1167_ = u32();
                            phi_1169_ = u32();
                            phi_1171_ = type_50();
                            phi_3609_ = false;
                        }
                        let _e1778 = phi_4126_;
                        let _e1780 = phi_1162_;
                        let _e1782 = phi_1165_;
                        let _e1784 = phi_1167_;
                        let _e1786 = phi_1169_;
                        let _e1788 = phi_1171_;
                        let _e1790 = phi_3609_;
                        continue;
                        continuing {
                            phi_3971_ = _e1778;
                            phi_1161_ = _e1780;
                            phi_1164_ = _e1782;
                            phi_1166_ = _e1784;
                            phi_1168_ = _e1786;
                            phi_1170_ = _e1788;
                            phi_4125_ = _e1778;
                            break if !(_e1790);
                        }
                    }
                    let _e1793 = phi_4125_;
                    if _e1793 {
                        break;
                    }
                    let _e1795 = local_10;
                    if (_e1795.member.member_3 != 4294967295u) {
                        let _e1800 = -(_e521);
                        let _e1801 = bitcast<u32>(_e1795.member.member);
                        let _e1805 = (bitcast<i32>((_e1801 >> bitcast<u32>(23i))) & 255i);
                        let _e1806 = (_e1805 + _e1800);
                        if (_e1805 == 255i) {
                            phi_3668_ = _e1795.member.member;
                        } else {
                            if (_e1805 > 0i) {
                                if (_e1806 > 0i) {
                                    let _e1810 = (_e1806 < 255i);
                                    if _e1810 {
                                        phi_3647_ = bitcast<f32>((_e1801 + bitcast<u32>((_e1800 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3647_ = f32();
                                    }
                                    let _e1817 = phi_3647_;
                                    phi_3649_ = _e1817;
                                    phi_3650_ = select(true, false, _e1810);
                                } else {
                                    phi_3649_ = f32();
                                    phi_3650_ = true;
                                }
                                let _e1820 = phi_3649_;
                                let _e1822 = phi_3650_;
                                phi_3651_ = _e1820;
                                phi_3652_ = _e1822;
                            } else {
                                phi_3651_ = f32();
                                phi_3652_ = true;
                            }
                            let _e1824 = phi_3651_;
                            let _e1826 = phi_3652_;
                            if _e1826 {
                                let _e1827 = (_e1801 & 2147483648u);
                                let _e1834 = ((_e1801 & 8388607u) | (select(0u, 1u, ((_e1801 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1838 = (_e1834 == 0u);
                                if _e1838 {
                                    phi_3923_ = bitcast<f32>(_e1827);
                                } else {
                                    let _e1843 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1834)), 32u, _e1838) - 8u);
                                    let _e1846 = (_e1834 << bitcast<u32>((_e1843 & 31u)));
                                    let _e1848 = ((_e1806 + select(0i, 1i, (_e1805 == 0i))) - bitcast<i32>(_e1843));
                                    if (_e1848 >= 255i) {
                                        phi_3913_ = bitcast<f32>((_e1827 | 2139095040u));
                                        phi_3914_ = f32();
                                        phi_3915_ = true;
                                    } else {
                                        let _e1850 = (_e1848 > 0i);
                                        if _e1850 {
                                            phi_3907_ = bitcast<f32>(((_e1827 | (bitcast<u32>(_e1848) << bitcast<u32>(23i))) | (_e1846 & 8388607u)));
                                            phi_3908_ = f32();
                                        } else {
                                            if (_e1848 < -24i) {
                                                phi_3873_ = 26u;
                                            } else {
                                                phi_3873_ = bitcast<u32>((1i - _e1848));
                                            }
                                            let _e1855 = phi_3873_;
                                            let _e1856 = (_e1855 & 31u);
                                            let _e1858 = (_e1846 >> bitcast<u32>(_e1856));
                                            let _e1862 = (_e1846 & ((1u << bitcast<u32>(_e1856)) - 1u));
                                            let _e1866 = (1u << bitcast<u32>(((_e1855 - 1u) & 31u)));
                                            if (_e1862 > _e1866) {
                                                phi_3894_ = true;
                                            } else {
                                                if (_e1862 == _e1866) {
                                                    phi_3891_ = ((_e1858 & 1u) == 1u);
                                                } else {
                                                    phi_3891_ = false;
                                                }
                                                let _e1872 = phi_3891_;
                                                phi_3894_ = _e1872;
                                            }
                                            let _e1874 = phi_3894_;
                                            phi_3907_ = f32();
                                            phi_3908_ = bitcast<f32>((_e1827 | (_e1858 + select(0u, 1u, _e1874))));
                                        }
                                        let _e1887 = phi_3907_;
                                        let _e1889 = phi_3908_;
                                        phi_3913_ = _e1887;
                                        phi_3914_ = _e1889;
                                        phi_3915_ = _e1850;
                                    }
                                    let _e1893 = phi_3913_;
                                    let _e1895 = phi_3914_;
                                    let _e1897 = phi_3915_;
                                    phi_3923_ = select(_e1895, _e1893, _e1897);
                                }
                                let _e1901 = phi_3923_;
                                phi_3667_ = _e1901;
                            } else {
                                phi_3667_ = _e1824;
                            }
                            let _e1903 = phi_3667_;
                            phi_3668_ = _e1903;
                        }
                        let _e1905 = phi_3668_;
                        let _e1906 = bitcast<u32>(_e1905);
                        if ((_e1906 & 2147483647u) >= 2139095040u) {
                            phi_3680_ = bitcast<f32>(((_e1906 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3680_ = _e1905;
                        }
                        let _e1913 = phi_3680_;
                        phi_3685_ = type_25(_e1913, _e1795.member.member_1, _e1795.member.member_2, _e1795.member.member_3);
                    } else {
                        phi_3685_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1918 = phi_3685_;
                    if _e152 {
                    } else {
                        break;
                    }
                    global_6.member[_e150] = _e1918;
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
