struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_34 {
    member: type_21,
    member_1: f32,
}

struct type_38 {
    member: array<type_25>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_29,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_23;

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
    var phi_1161_: type_34;
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
    var phi_1287_: type_34;
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
    var phi_2291_: type_21;
    var phi_2293_: type_21;
    var phi_2294_: bool;
    var phi_2298_: type_21;
    var phi_2299_: type_21;
    var phi_2300_: type_21;
    var phi_2301_: bool;
    var phi_2305_: type_21;
    var phi_2306_: bool;
    var phi_2307_: type_21;
    var phi_2308_: bool;
    var phi_2309_: bool;
    var phi_2310_: type_21;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2320_: type_21;
    var phi_2321_: bool;
    var phi_2325_: type_21;
    var phi_2350_: bool;
    var phi_2351_: bool;
    var phi_2357_: type_34;
    var phi_2358_: type_34;
    var phi_2359_: type_34;
    var phi_1288_: type_34;
    var phi_3965_: bool;
    var phi_4129_: bool;
    var phi_3595_: type_34;
    var phi_3596_: bool;
    var phi_3597_: u32;
    var phi_3598_: type_50;
    var phi_4128_: bool;
    var phi_3599_: type_34;
    var phi_3600_: bool;
    var phi_3601_: u32;
    var phi_3602_: u32;
    var phi_3603_: type_50;
    var phi_4127_: bool;
    var phi_3604_: type_34;
    var phi_3605_: bool;
    var phi_3606_: u32;
    var phi_3607_: u32;
    var phi_3608_: type_50;
    var phi_4126_: bool;
    var phi_1162_: type_34;
    var phi_1165_: bool;
    var phi_1167_: u32;
    var phi_1169_: u32;
    var phi_1171_: type_50;
    var phi_3609_: bool;
    var phi_4125_: bool;
    var local_10: type_34;
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
    var phi_3685_: type_21;
    var local_11: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_5.member));
            let _e94 = arrayLength((&global_2.member));
            let _e102 = global_3.member[0u][0u];
            let _e106 = global_3.member[0u][1u];
            let _e110 = global_3.member[0u][2u];
            let _e114 = global_3.member[0u][3u];
            let _e118 = global_3.member[1u][0u];
            let _e122 = global_3.member[1u][1u];
            let _e126 = global_3.member[1u][2u];
            let _e129 = global_1.member[0u];
            let _e130 = bitcast<i32>(_e129);
            let _e142 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e114) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e102), bitcast<i32>(_e106), bitcast<i32>(_e110));
            local = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            let _e148 = (_e90.x + (_e90.y * 2097152u));
            let _e149 = (_e148 < arrayLength((&global_4.member)));
            if _e149 {
                let _e150 = (_e148 < arrayLength((&global_6.member)));
                if _e150 {
                    if _e149 {
                    } else {
                        break;
                    }
                    let _e158 = global_4.member[_e148].member_2[0u];
                    let _e160 = (bitcast<u32>(_e158) & 2147483647u);
                    let _e165 = global_4.member[_e148].member_2[1u];
                    let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                    let _e172 = global_4.member[_e148].member_2[2u];
                    let _e174 = (bitcast<u32>(_e172) & 2147483647u);
                    let _e179 = global_4.member[_e148].member[0u];
                    let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                    let _e186 = global_4.member[_e148].member[1u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e193 = global_4.member[_e148].member[2u];
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e197 = select(_e167, _e160, (_e167 < _e160));
                    let _e199 = select(_e174, _e197, (_e174 < _e197));
                    let _e201 = select(_e181, _e199, (_e181 < _e199));
                    let _e203 = select(_e188, _e201, (_e188 < _e201));
                    let _e205 = select(_e195, _e203, (_e195 < _e203));
                    let _e209 = global_4.member[_e148].member_1;
                    let _e210 = bitcast<u32>(_e209);
                    let _e211 = (_e210 & 2147483647u);
                    let _e218 = global_4.member[_e148].member_3;
                    let _e219 = bitcast<u32>(_e218);
                    let _e220 = (_e219 & 2147483647u);
                    let _e224 = (((select(_e211, _e205, (_e211 < _e205)) < 2139095040u) && (_e220 <= 2139095040u)) && (_e199 > 0u));
                    if _e224 {
                        let _e227 = (bitcast<u32>(bitcast<f32>(_e199)) & 2147483647u);
                        if (_e227 >= 8388608u) {
                            phi_472_ = (bitcast<i32>((_e227 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_472_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e227)), 32u, (_e227 == 0u))));
                        }
                        let _e241 = phi_472_;
                        phi_473_ = _e241;
                    } else {
                        phi_473_ = 0i;
                    }
                    let _e243 = phi_473_;
                    let _e244 = (_e160 == _e199);
                    if _e244 {
                        phi_483_ = true;
                    } else {
                        phi_483_ = (_e167 == _e199);
                    }
                    let _e247 = phi_483_;
                    let _e248 = select(1u, 0u, _e244);
                    if _e247 {
                        let _e249 = (_e248 + 1u);
                        phi_493_ = _e249;
                        phi_494_ = _e249;
                        phi_496_ = select(true, false, (_e249 == 2u));
                    } else {
                        phi_493_ = u32();
                        phi_494_ = 0u;
                        phi_496_ = true;
                    }
                    let _e253 = phi_493_;
                    let _e255 = phi_494_;
                    let _e257 = phi_496_;
                    if _e257 {
                        phi_501_ = (_e255 + 1u);
                    } else {
                        phi_501_ = 0u;
                    }
                    let _e261 = phi_501_;
                    let _e262 = select(_e253, _e255, _e257);
                    let _e263 = select(_e248, select(2u, _e248, _e247), _e257);
                    if (_e130 < -126i) {
                        phi_514_ = -126i;
                    } else {
                        phi_514_ = select(_e130, 127i, (_e130 > 127i));
                    }
                    let _e268 = phi_514_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e130 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e280 = -(_e243);
                    if (_e280 < -126i) {
                        phi_534_ = -126i;
                    } else {
                        phi_534_ = select(_e280, 127i, (_e280 > 127i));
                    }
                    let _e285 = phi_534_;
                    let _e290 = bitcast<f32>((bitcast<u32>((_e285 + 127i)) << bitcast<u32>(23i)));
                    let _e296 = bitcast<f32>((bitcast<u32>(((_e280 - _e285) + 127i)) << bitcast<u32>(23i)));
                    let _e300 = global_4.member[_e148].member;
                    let _e301 = (_e262 == 0u);
                    if _e301 {
                        phi_552_ = _e300[0];
                    } else {
                        phi_552_ = _e300[1];
                    }
                    let _e305 = phi_552_;
                    let _e306 = (_e262 == 2u);
                    if _e306 {
                        phi_558_ = _e300[2];
                    } else {
                        phi_558_ = _e305;
                    }
                    let _e309 = phi_558_;
                    let _e310 = bitcast<u32>(_e309);
                    let _e312 = ((_e310 & 2139095040u) != 0u);
                    let _e326 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e310 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e310 & 2147483648u))), _e309, _e312) * _e273) * select(0.00000011920929f, 1f, _e312)) * _e279);
                    let _e327 = global_4.member[_e148].member_2;
                    if _e301 {
                        phi_598_ = _e327[0];
                    } else {
                        phi_598_ = _e327[1];
                    }
                    let _e331 = phi_598_;
                    if _e306 {
                        phi_604_ = _e327[2];
                    } else {
                        phi_604_ = _e331;
                    }
                    let _e334 = phi_604_;
                    let _e335 = bitcast<u32>(_e334);
                    let _e337 = ((_e335 & 2139095040u) != 0u);
                    let _e351 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e335 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e335 & 2147483648u))), _e334, _e337) * _e290) * select(0.00000011920929f, 1f, _e337)) * _e296);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e326) & 2147483647u)) * 0.00000011920929f);
                        phi_656_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_656_ = 0f;
                    }
                    let _e363 = phi_656_;
                    let _e364 = (_e326 + _e363);
                    let _e365 = (_e326 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_668_ = 38685626000000000000000000f;
                    } else {
                        phi_668_ = (1f / _e351);
                    }
                    let _e369 = phi_668_;
                    let _e370 = (_e261 == 0u);
                    if _e370 {
                        phi_677_ = _e300[0];
                    } else {
                        phi_677_ = _e300[1];
                    }
                    let _e374 = phi_677_;
                    let _e375 = (_e261 == 2u);
                    if _e375 {
                        phi_683_ = _e300[2];
                    } else {
                        phi_683_ = _e374;
                    }
                    let _e378 = phi_683_;
                    let _e379 = bitcast<u32>(_e378);
                    let _e381 = ((_e379 & 2139095040u) != 0u);
                    let _e395 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e379 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e379 & 2147483648u))), _e378, _e381) * _e273) * select(0.00000011920929f, 1f, _e381)) * _e279);
                    if _e370 {
                        phi_723_ = _e327[0];
                    } else {
                        phi_723_ = _e327[1];
                    }
                    let _e399 = phi_723_;
                    if _e375 {
                        phi_729_ = _e327[2];
                    } else {
                        phi_729_ = _e399;
                    }
                    let _e402 = phi_729_;
                    let _e403 = bitcast<u32>(_e402);
                    let _e405 = ((_e403 & 2139095040u) != 0u);
                    let _e419 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e403 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e403 & 2147483648u))), _e402, _e405) * _e290) * select(0.00000011920929f, 1f, _e405)) * _e296);
                    let _e423 = (bitcast<f32>((bitcast<u32>(_e419) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e423 {
                        let _e427 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                        phi_781_ = select(0.00000000000011368684f, _e427, (_e427 > 0.00000000000011368684f));
                    } else {
                        phi_781_ = 0f;
                    }
                    let _e431 = phi_781_;
                    let _e432 = (_e395 + _e431);
                    let _e433 = (_e395 - _e431);
                    let _e434 = select(_e419, 0f, _e423);
                    if _e423 {
                        phi_793_ = 38685626000000000000000000f;
                    } else {
                        phi_793_ = (1f / _e419);
                    }
                    let _e437 = phi_793_;
                    let _e438 = (_e263 == 0u);
                    if _e438 {
                        phi_802_ = _e300[0];
                    } else {
                        phi_802_ = _e300[1];
                    }
                    let _e442 = phi_802_;
                    let _e443 = (_e263 == 2u);
                    if _e443 {
                        phi_808_ = _e300[2];
                    } else {
                        phi_808_ = _e442;
                    }
                    let _e446 = phi_808_;
                    let _e447 = bitcast<u32>(_e446);
                    let _e449 = ((_e447 & 2139095040u) != 0u);
                    let _e463 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e447 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e447 & 2147483648u))), _e446, _e449) * _e273) * select(0.00000011920929f, 1f, _e449)) * _e279);
                    if _e438 {
                        phi_848_ = _e327[0];
                    } else {
                        phi_848_ = _e327[1];
                    }
                    let _e467 = phi_848_;
                    if _e443 {
                        phi_854_ = _e327[2];
                    } else {
                        phi_854_ = _e467;
                    }
                    let _e470 = phi_854_;
                    let _e471 = bitcast<u32>(_e470);
                    let _e473 = ((_e471 & 2139095040u) != 0u);
                    let _e487 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e470, _e473) * _e290) * select(0.00000011920929f, 1f, _e473)) * _e296);
                    let _e491 = (bitcast<f32>((bitcast<u32>(_e487) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e491 {
                        let _e495 = (bitcast<f32>((bitcast<u32>(_e463) & 2147483647u)) * 0.00000011920929f);
                        phi_906_ = select(0.00000000000011368684f, _e495, (_e495 > 0.00000000000011368684f));
                    } else {
                        phi_906_ = 0f;
                    }
                    let _e499 = phi_906_;
                    let _e500 = (_e463 + _e499);
                    let _e501 = (_e463 - _e499);
                    let _e502 = select(_e487, 0f, _e491);
                    if _e491 {
                        phi_918_ = 38685626000000000000000000f;
                    } else {
                        phi_918_ = (1f / _e487);
                    }
                    let _e505 = phi_918_;
                    let _e508 = bitcast<f32>((bitcast<u32>(_e326) & 2147483647u));
                    let _e511 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                    let _e513 = select(_e511, _e508, (_e508 > _e511));
                    let _e516 = bitcast<f32>((bitcast<u32>(_e463) & 2147483647u));
                    let _e519 = (_e130 + _e243);
                    if (_e224 && (select(_e516, _e513, (_e513 > _e516)) <= 1099511600000f)) {
                        let _e529 = ((_e211 & 8388607u) | (select(0u, 1u, ((_e211 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e532 = bitcast<i32>((_e211 >> bitcast<u32>(23i)));
                        let _e536 = (_e529 == 0u);
                        let _e539 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, _e536)) - 8i);
                        if (_e532 == 255i) {
                            phi_973_ = 255i;
                        } else {
                            phi_973_ = (((_e532 + select(0i, 1i, (_e532 == 0i))) - _e539) + _e519);
                        }
                        let _e547 = phi_973_;
                        let _e557 = (_e547 <= 0i);
                        if _e557 {
                            phi_996_ = u32();
                        } else {
                            if _e536 {
                                phi_995_ = u32();
                            } else {
                                phi_995_ = select(((bitcast<u32>(_e547) << bitcast<u32>(23i)) | ((_e529 << bitcast<u32>(((_e539 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e547 >= 255i));
                            }
                            let _e561 = phi_995_;
                            phi_996_ = _e561;
                        }
                        let _e563 = phi_996_;
                        let _e575 = ((_e220 & 8388607u) | (select(0u, 1u, ((_e220 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e578 = bitcast<i32>((_e220 >> bitcast<u32>(23i)));
                        let _e582 = (_e575 == 0u);
                        let _e585 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e575)), 32u, _e582)) - 8i);
                        if (_e578 == 255i) {
                            phi_1033_ = 255i;
                        } else {
                            phi_1033_ = (((_e578 + select(0i, 1i, (_e578 == 0i))) - _e585) + _e519);
                        }
                        let _e593 = phi_1033_;
                        let _e603 = (_e593 <= 0i);
                        if _e603 {
                            phi_1056_ = u32();
                        } else {
                            if _e582 {
                                phi_1055_ = u32();
                            } else {
                                phi_1055_ = select(((bitcast<u32>(_e593) << bitcast<u32>(23i)) | ((_e575 << bitcast<u32>(((_e585 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e593 >= 255i));
                            }
                            let _e607 = phi_1055_;
                            phi_1056_ = _e607;
                        }
                        let _e609 = phi_1056_;
                        phi_1064_ = bitcast<f32>(((_e219 & 2147483648u) | select(_e609, 0u, select(_e582, true, _e603))));
                        phi_1065_ = bitcast<f32>(((_e210 & 2147483648u) | select(_e563, 0u, select(_e536, true, _e557))));
                    } else {
                        phi_1064_ = 0f;
                        phi_1065_ = 1f;
                    }
                    let _e615 = phi_1064_;
                    let _e617 = phi_1065_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e621 = (_e262 % 3u);
                    let _e622 = (_e621 < 3u);
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e624 = local_1[_e621];
                    let _e627 = (_e261 % 3u);
                    let _e628 = (_e627 < 3u);
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e630 = local_1[_e627];
                    let _e633 = (_e263 % 3u);
                    let _e634 = (_e633 < 3u);
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e636 = local_1[_e633];
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e641 = local[_e621];
                    if _e628 {
                    } else {
                        break;
                    }
                    let _e645 = local[_e627];
                    if _e634 {
                    } else {
                        break;
                    }
                    let _e649 = local[_e633];
                    phi_3971_ = false;
                    phi_1161_ = type_34(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e615);
                    phi_1164_ = (_e617 <= _e615);
                    phi_1166_ = ((3u * _e92) + 1u);
                    phi_1168_ = 0u;
                    phi_1170_ = type_50(type_29(vec4<f32>((f32(_e624) * _e142), (f32(_e630) * _e142), (f32(_e636) * _e142), 0f), vec4<f32>((f32(_e641) * _e142), (f32(_e645) * _e142), (f32(_e649) * _e142), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    loop {
                        let _e659 = phi_3971_;
                        let _e661 = phi_1161_;
                        let _e663 = phi_1164_;
                        let _e665 = phi_1166_;
                        let _e667 = phi_1168_;
                        let _e669 = phi_1170_;
                        local_10 = _e661;
                        if _e663 {
                            phi_1181_ = true;
                        } else {
                            phi_1181_ = (_e667 > 0u);
                        }
                        let _e672 = phi_1181_;
                        if _e672 {
                            let _e673 = (_e665 > 0u);
                            if _e673 {
                                if _e663 {
                                    phi_1267_ = _e663;
                                    phi_1268_ = _e667;
                                    phi_1269_ = _e669;
                                } else {
                                    let _e674 = (_e667 - 1u);
                                    let _e675 = (_e674 % 128u);
                                    let _e676 = (_e675 < 128u);
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e678 = local_7[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e680 = local_6[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e682 = local_5[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e684 = local_4[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e686 = local_3[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e688 = local_2[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e693 = local_8[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4125_ = true;
                                        break;
                                    }
                                    let _e696 = local_9[_e675];
                                    phi_1267_ = (_e696 <= _e661.member_1);
                                    phi_1268_ = _e674;
                                    phi_1269_ = type_50(type_29(vec4<f32>(_e678, _e680, _e682, 0f), vec4<f32>(_e684, _e686, _e688, 0f)), _e693);
                                }
                                let _e700 = phi_1267_;
                                let _e702 = phi_1268_;
                                let _e704 = phi_1269_;
                                if _e700 {
                                    if ((_e704.member_1 & 2147483648u) != 0u) {
                                        phi_1287_ = _e661;
                                        phi_1290_ = type_4(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1172 = phi_1287_;
                                            let _e1174 = phi_1290_;
                                            local_11 = _e1172;
                                            if (_e1174.member < _e1174.member_1) {
                                                phi_1291_ = type_4((_e1174.member + 1u), _e1174.member_1);
                                                phi_1313_ = type_4(1u, _e1174.member);
                                            } else {
                                                phi_1291_ = _e1174;
                                                phi_1313_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1187 = phi_1291_;
                                            let _e1189 = phi_1313_;
                                            let _e1193 = (bitcast<i32>(_e1189.member) != 0i);
                                            if _e1193 {
                                                let _e1194 = ((_e704.member_1 & 268435455u) + _e1189.member_1);
                                                let _e1195 = (_e1194 < _e94);
                                                if _e1195 {
                                                    if _e1195 {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1199 = global_2.member[_e1194].member_1;
                                                    phi_1334_ = _e1199;
                                                } else {
                                                    phi_1334_ = 4294967295u;
                                                }
                                                let _e1201 = phi_1334_;
                                                if (_e1194 >= _e94) {
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1195 {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    if (_e621 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1208 = global_2.member[_e1194].member[_e621];
                                                    if (_e627 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1214 = global_2.member[_e1194].member[_e627];
                                                    if (_e633 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1220 = global_2.member[_e1194].member[_e633];
                                                    let _e1222 = (3u + _e621);
                                                    if (_e1222 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1228 = global_2.member[_e1194].member[_e1222];
                                                    let _e1229 = (3u + _e627);
                                                    if (_e1229 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1235 = global_2.member[_e1194].member[_e1229];
                                                    let _e1236 = (3u + _e633);
                                                    if (_e1236 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1242 = global_2.member[_e1194].member[_e1236];
                                                    let _e1244 = (6u + _e621);
                                                    if (_e1244 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1250 = global_2.member[_e1194].member[_e1244];
                                                    let _e1251 = (6u + _e627);
                                                    if (_e1251 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1257 = global_2.member[_e1194].member[_e1251];
                                                    let _e1258 = (6u + _e633);
                                                    if (_e1258 < 9u) {
                                                    } else {
                                                        phi_3965_ = true;
                                                        break;
                                                    }
                                                    let _e1264 = global_2.member[_e1194].member[_e1258];
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1208, _e1214, _e1220), array<f32, 3>(_e1228, _e1235, _e1242), array<f32, 3>(_e1250, _e1257, _e1264));
                                                }
                                                let _e1268 = phi_1426_;
                                                let _e1276 = (_e1268[0][2] - _e463);
                                                let _e1279 = (((_e1268[0][0] - _e326) * _e502) - (_e1276 * _e366));
                                                let _e1282 = (((_e1268[0][1] - _e395) * _e502) - (_e1276 * _e434));
                                                let _e1289 = (_e1268[1][2] - _e463);
                                                let _e1292 = (((_e1268[1][0] - _e326) * _e502) - (_e1289 * _e366));
                                                let _e1295 = (((_e1268[1][1] - _e395) * _e502) - (_e1289 * _e434));
                                                let _e1302 = (_e1268[2][2] - _e463);
                                                let _e1305 = (((_e1268[2][0] - _e326) * _e502) - (_e1302 * _e366));
                                                let _e1308 = (((_e1268[2][1] - _e395) * _e502) - (_e1302 * _e434));
                                                let _e1309 = (_e1305 * _e1295);
                                                let _e1310 = (_e1308 * _e1292);
                                                let _e1311 = (_e1279 * _e1308);
                                                let _e1312 = (_e1282 * _e1305);
                                                let _e1313 = (_e1292 * _e1282);
                                                let _e1314 = (_e1295 * _e1279);
                                                let _e1319 = (((_e1309 >= _e1310) && (_e1311 >= _e1312)) && (_e1313 >= _e1314));
                                                if (_e1319 || (((_e1309 <= _e1310) && (_e1311 <= _e1312)) && (_e1313 <= _e1314))) {
                                                    let _e1326 = select(-1f, 1f, _e1319);
                                                    let _e1328 = ((_e1309 - _e1310) * _e1326);
                                                    let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                    let _e1332 = ((_e1311 - _e1312) * _e1326);
                                                    let _e1334 = select(0f, _e1332, (_e1332 > 0f));
                                                    let _e1336 = ((_e1313 - _e1314) * _e1326);
                                                    let _e1338 = select(0f, _e1336, (_e1336 > 0f));
                                                    let _e1340 = ((_e1330 + _e1334) + _e1338);
                                                    if (_e1340 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2310_ = type_21();
                                                        phi_2311_ = true;
                                                        phi_2312_ = false;
                                                    } else {
                                                        let _e1343 = select(_e1292, _e1279, (_e1279 < _e1292));
                                                        if (select(_e1305, _e1343, (_e1343 < _e1305)) > 0f) {
                                                            phi_1578_ = true;
                                                        } else {
                                                            let _e1348 = select(_e1292, _e1279, (_e1279 > _e1292));
                                                            phi_1578_ = (select(_e1305, _e1348, (_e1348 > _e1305)) < 0f);
                                                        }
                                                        let _e1353 = phi_1578_;
                                                        if _e1353 {
                                                            phi_2307_ = type_21();
                                                            phi_2308_ = true;
                                                            phi_2309_ = false;
                                                        } else {
                                                            let _e1355 = select(_e1295, _e1282, (_e1282 < _e1295));
                                                            if (select(_e1308, _e1355, (_e1355 < _e1308)) > 0f) {
                                                                phi_1607_ = true;
                                                            } else {
                                                                let _e1360 = select(_e1295, _e1282, (_e1282 > _e1295));
                                                                phi_1607_ = (select(_e1308, _e1360, (_e1360 > _e1308)) < 0f);
                                                            }
                                                            let _e1365 = phi_1607_;
                                                            if _e1365 {
                                                                phi_2305_ = type_21();
                                                                phi_2306_ = false;
                                                            } else {
                                                                let _e1367 = select(_e1268[1][0], _e1268[0][0], (_e1268[0][0] < _e1268[1][0]));
                                                                let _e1371 = select(_e1268[1][0], _e1268[0][0], (_e1268[0][0] > _e1268[1][0]));
                                                                let _e1375 = select(_e1268[1][1], _e1268[0][1], (_e1268[0][1] < _e1268[1][1]));
                                                                let _e1379 = select(_e1268[1][1], _e1268[0][1], (_e1268[0][1] > _e1268[1][1]));
                                                                let _e1383 = select(_e1268[1][2], _e1268[0][2], (_e1268[0][2] < _e1268[1][2]));
                                                                let _e1387 = select(_e1268[1][2], _e1268[0][2], (_e1268[0][2] > _e1268[1][2]));
                                                                let _e1392 = ((select(_e1268[2][0], _e1367, (_e1367 < _e1268[2][0])) - _e364) * _e369);
                                                                let _e1393 = ((select(_e1268[2][0], _e1371, (_e1371 > _e1268[2][0])) - _e365) * _e369);
                                                                let _e1396 = ((select(_e1268[2][1], _e1375, (_e1375 < _e1268[2][1])) - _e432) * _e437);
                                                                let _e1397 = ((select(_e1268[2][1], _e1379, (_e1379 > _e1268[2][1])) - _e433) * _e437);
                                                                let _e1400 = ((select(_e1268[2][2], _e1383, (_e1383 < _e1268[2][2])) - _e500) * _e505);
                                                                let _e1401 = ((select(_e1268[2][2], _e1387, (_e1387 > _e1268[2][2])) - _e501) * _e505);
                                                                let _e1403 = select(_e1401, _e1400, (_e1400 < _e1401));
                                                                let _e1405 = select(_e1401, _e1400, (_e1400 > _e1401));
                                                                let _e1407 = select(_e1393, _e1392, (_e1392 < _e1393));
                                                                let _e1409 = select(_e1397, _e1396, (_e1396 < _e1397));
                                                                let _e1411 = select(_e1409, _e1407, (_e1407 > _e1409));
                                                                let _e1413 = select(_e1403, _e1411, (_e1411 > _e1403));
                                                                let _e1415 = select(_e1393, _e1392, (_e1392 > _e1393));
                                                                let _e1417 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                                let _e1419 = select(_e1417, _e1415, (_e1415 < _e1417));
                                                                let _e1421 = select(_e1405, _e1419, (_e1419 < _e1405));
                                                                let _e1422 = -(_e1403);
                                                                let _e1428 = select(_e617, _e1413, (_e1413 > _e617));
                                                                if (_e1428 > (_e1421 + (select(_e1422, _e1405, (_e1405 > _e1422)) * 0.0000019073523f))) {
                                                                    phi_2300_ = type_21();
                                                                    phi_2301_ = true;
                                                                } else {
                                                                    let _e1430 = (_e1428 > _e1172.member_1);
                                                                    if _e1430 {
                                                                        phi_2299_ = type_21();
                                                                    } else {
                                                                        let _e1431 = vec3<f32>(_e1268[0][0], _e1268[0][1], _e1268[0][2]);
                                                                        let _e1432 = vec3<f32>(_e1268[1][0], _e1268[1][1], _e1268[1][2]);
                                                                        let _e1433 = vec3<f32>(_e1268[2][0], _e1268[2][1], _e1268[2][2]);
                                                                        let _e1434 = (_e1268[1][0] - _e1268[0][0]);
                                                                        let _e1435 = (_e1268[1][1] - _e1268[0][1]);
                                                                        let _e1436 = (_e1268[1][2] - _e1268[0][2]);
                                                                        let _e1437 = vec3<f32>(_e1434, _e1435, _e1436);
                                                                        let _e1438 = (_e1268[2][0] - _e1268[1][0]);
                                                                        let _e1439 = (_e1268[2][1] - _e1268[1][1]);
                                                                        let _e1440 = (_e1268[2][2] - _e1268[1][2]);
                                                                        let _e1441 = vec3<f32>(_e1438, _e1439, _e1440);
                                                                        let _e1442 = (_e1268[0][0] - _e1268[2][0]);
                                                                        let _e1443 = (_e1268[0][1] - _e1268[2][1]);
                                                                        let _e1444 = (_e1268[0][2] - _e1268[2][2]);
                                                                        let _e1445 = vec3<f32>(_e1442, _e1443, _e1444);
                                                                        let _e1448 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                        let _e1451 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                        let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                        let _e1456 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                        let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                                                                        let _e1461 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                        let _e1464 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                        let _e1466 = select(_e1464, _e1461, (_e1461 > _e1464));
                                                                        let _e1469 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                        let _e1471 = select(_e1469, _e1466, (_e1466 > _e1469));
                                                                        let _e1474 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                                        let _e1477 = bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u));
                                                                        let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                        let _e1482 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                        let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                                        let _e1486 = select(_e1471, _e1458, (_e1458 > _e1471));
                                                                        let _e1488 = select(_e1484, _e1486, (_e1486 > _e1484));
                                                                        if (_e1458 == _e1488) {
                                                                            phi_2026_ = _e1295;
                                                                            phi_2027_ = _e1292;
                                                                            phi_2028_ = _e1282;
                                                                            phi_2029_ = _e1279;
                                                                            phi_2030_ = _e1431;
                                                                            phi_2031_ = _e1445;
                                                                            phi_2032_ = _e1441;
                                                                            phi_2033_ = _e1437;
                                                                        } else {
                                                                            let _e1490 = (_e1471 == _e1488);
                                                                            let _e1495 = vec3(_e1490);
                                                                            phi_2026_ = select(_e1282, _e1308, _e1490);
                                                                            phi_2027_ = select(_e1279, _e1305, _e1490);
                                                                            phi_2028_ = select(_e1308, _e1295, _e1490);
                                                                            phi_2029_ = select(_e1305, _e1292, _e1490);
                                                                            phi_2030_ = select(_e1433, _e1432, _e1495);
                                                                            phi_2031_ = select(_e1441, _e1437, _e1495);
                                                                            phi_2032_ = select(_e1437, _e1445, _e1495);
                                                                            phi_2033_ = select(_e1445, _e1441, _e1495);
                                                                        }
                                                                        let _e1501 = phi_2026_;
                                                                        let _e1503 = phi_2027_;
                                                                        let _e1505 = phi_2028_;
                                                                        let _e1507 = phi_2029_;
                                                                        let _e1509 = phi_2030_;
                                                                        let _e1511 = phi_2031_;
                                                                        let _e1513 = phi_2032_;
                                                                        let _e1515 = phi_2033_;
                                                                        let _e1522 = ((_e1513.y * _e1511.z) - (_e1511.y * _e1513.z));
                                                                        let _e1527 = ((_e1513.z * _e1511.x) - (_e1511.z * _e1513.x));
                                                                        let _e1530 = ((_e1513.x * _e1511.y) - (_e1511.x * _e1513.y));
                                                                        if (_e1330 >= _e1334) {
                                                                            phi_2070_ = select(true, false, (_e1330 >= _e1338));
                                                                        } else {
                                                                            phi_2070_ = true;
                                                                        }
                                                                        let _e1535 = phi_2070_;
                                                                        if _e1535 {
                                                                            phi_2079_ = select(_e1433, _e1432, vec3((_e1334 >= _e1338)));
                                                                        } else {
                                                                            phi_2079_ = _e1431;
                                                                        }
                                                                        let _e1540 = phi_2079_;
                                                                        let _e1551 = (((_e1522 * (_e1540.x - _e326)) + (_e1527 * (_e1540.y - _e395))) + (_e1530 * (_e1540.z - _e463)));
                                                                        let _e1556 = (((_e1522 * _e366) + (_e1527 * _e434)) + (_e1530 * _e502));
                                                                        let _e1557 = (_e1503 - _e1507);
                                                                        let _e1558 = (_e1501 - _e1505);
                                                                        let _e1566 = (-(((_e1507 * _e1557) + (_e1505 * _e1558))) / ((_e1557 * _e1557) + (_e1558 * _e1558)));
                                                                        let _e1568 = select(1f, _e1566, (_e1566 < 1f));
                                                                        let _e1570 = select(0f, _e1568, (_e1568 > 0f));
                                                                        let _e1583 = ((_e1509.x + (_e1515.x * _e1570)) - _e326);
                                                                        let _e1584 = ((_e1509.y + (_e1515.y * _e1570)) - _e395);
                                                                        let _e1585 = ((_e1509.z + (_e1515.z * _e1570)) - _e463);
                                                                        let _e1586 = (_e1585 / _e502);
                                                                        let _e1598 = bitcast<f32>((bitcast<u32>(_e1583) & 2147483647u));
                                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1584) & 2147483647u));
                                                                        let _e1603 = select(_e1601, _e1598, (_e1598 > _e1601));
                                                                        let _e1606 = bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u));
                                                                        let _e1608 = select(_e1606, _e1603, (_e1603 > _e1606));
                                                                        let _e1614 = bitcast<f32>((bitcast<u32>(_e1522) & 2147483647u));
                                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1527) & 2147483647u));
                                                                        let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1522 * _e1583) + (_e1527 * _e1584)) + (_e1530 * _e1585)) - _e1551)) & 2147483647u)) <= ((0.0000009536743f * select(_e1488, _e1608, (_e1608 > _e1488))) * select(_e1622, _e1619, (_e1619 > _e1622)))) {
                                                                            let _e1632 = bitcast<f32>((bitcast<u32>(_e1513.x) & 2147483647u));
                                                                            let _e1635 = bitcast<f32>((bitcast<u32>(_e1513.y) & 2147483647u));
                                                                            let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                            let _e1640 = bitcast<f32>((bitcast<u32>(_e1513.z) & 2147483647u));
                                                                            let _e1646 = bitcast<f32>((bitcast<u32>(_e1511.x) & 2147483647u));
                                                                            let _e1649 = bitcast<f32>((bitcast<u32>(_e1511.y) & 2147483647u));
                                                                            let _e1651 = select(_e1649, _e1646, (_e1646 > _e1649));
                                                                            let _e1654 = bitcast<f32>((bitcast<u32>(_e1511.z) & 2147483647u));
                                                                            let _e1658 = (bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u)) > ((0.0000038146973f * select(_e1640, _e1637, (_e1637 > _e1640))) * select(_e1654, _e1651, (_e1651 > _e1654))));
                                                                            if _e1658 {
                                                                                phi_2244_ = (_e1551 / _e1556);
                                                                            } else {
                                                                                phi_2244_ = f32();
                                                                            }
                                                                            let _e1661 = phi_2244_;
                                                                            phi_2246_ = _e1661;
                                                                            phi_2247_ = select(true, false, _e1658);
                                                                        } else {
                                                                            phi_2246_ = f32();
                                                                            phi_2247_ = true;
                                                                        }
                                                                        let _e1664 = phi_2246_;
                                                                        let _e1666 = phi_2247_;
                                                                        if _e1666 {
                                                                            let _e1674 = (((_e1522 * (_e1583 - (_e366 * _e1586))) + (_e1527 * (_e1584 - (_e434 * _e1586)))) / _e1556);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u)) <= _e1488) {
                                                                                phi_2267_ = (_e1586 + _e1674);
                                                                            } else {
                                                                                phi_2267_ = _e1586;
                                                                            }
                                                                            let _e1681 = phi_2267_;
                                                                            phi_2268_ = _e1681;
                                                                        } else {
                                                                            phi_2268_ = _e1664;
                                                                        }
                                                                        let _e1683 = phi_2268_;
                                                                        let _e1685 = select(_e1421, _e1683, (_e1683 < _e1421));
                                                                        let _e1687 = select(_e1413, _e1685, (_e1685 > _e1413));
                                                                        if (_e1687 >= _e617) {
                                                                            let _e1689 = (_e1687 <= _e1172.member_1);
                                                                            if _e1689 {
                                                                                let _e1690 = (1f / _e1340);
                                                                                phi_2291_ = type_21(_e1687, (_e1334 * _e1690), (_e1338 * _e1690), _e1201);
                                                                            } else {
                                                                                phi_2291_ = type_21();
                                                                            }
                                                                            let _e1695 = phi_2291_;
                                                                            phi_2293_ = _e1695;
                                                                            phi_2294_ = select(true, false, _e1689);
                                                                        } else {
                                                                            phi_2293_ = type_21();
                                                                            phi_2294_ = true;
                                                                        }
                                                                        let _e1698 = phi_2293_;
                                                                        let _e1700 = phi_2294_;
                                                                        if _e1700 {
                                                                            phi_2298_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2298_ = _e1698;
                                                                        }
                                                                        let _e1702 = phi_2298_;
                                                                        phi_2299_ = _e1702;
                                                                    }
                                                                    let _e1704 = phi_2299_;
                                                                    phi_2300_ = _e1704;
                                                                    phi_2301_ = _e1430;
                                                                }
                                                                let _e1706 = phi_2300_;
                                                                let _e1708 = phi_2301_;
                                                                phi_2305_ = _e1706;
                                                                phi_2306_ = _e1708;
                                                            }
                                                            let _e1710 = phi_2305_;
                                                            let _e1712 = phi_2306_;
                                                            phi_2307_ = _e1710;
                                                            phi_2308_ = _e1365;
                                                            phi_2309_ = _e1712;
                                                        }
                                                        let _e1714 = phi_2307_;
                                                        let _e1716 = phi_2308_;
                                                        let _e1718 = phi_2309_;
                                                        phi_2310_ = _e1714;
                                                        phi_2311_ = _e1716;
                                                        phi_2312_ = _e1718;
                                                    }
                                                    let _e1720 = phi_2310_;
                                                    let _e1722 = phi_2311_;
                                                    let _e1724 = phi_2312_;
                                                    phi_2320_ = _e1720;
                                                    phi_2321_ = select(_e1724, true, _e1722);
                                                } else {
                                                    phi_2320_ = type_21();
                                                    phi_2321_ = true;
                                                }
                                                let _e1727 = phi_2320_;
                                                let _e1729 = phi_2321_;
                                                if _e1729 {
                                                    phi_2325_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2325_ = _e1727;
                                                }
                                                let _e1731 = phi_2325_;
                                                if (_e1731.member_3 != 4294967295u) {
                                                    if (_e1201 != 4294967295u) {
                                                        if (_e1731.member < _e1172.member.member) {
                                                            phi_2351_ = true;
                                                        } else {
                                                            if (_e1731.member == _e1172.member.member) {
                                                                phi_2350_ = (_e1731.member_3 < _e1172.member.member_3);
                                                            } else {
                                                                phi_2350_ = false;
                                                            }
                                                            let _e1744 = phi_2350_;
                                                            phi_2351_ = _e1744;
                                                        }
                                                        let _e1746 = phi_2351_;
                                                        if _e1746 {
                                                            phi_2357_ = type_34(_e1731, _e1731.member);
                                                        } else {
                                                            phi_2357_ = _e1172;
                                                        }
                                                        let _e1749 = phi_2357_;
                                                        phi_2358_ = _e1749;
                                                    } else {
                                                        phi_2358_ = _e1172;
                                                    }
                                                    let _e1751 = phi_2358_;
                                                    phi_2359_ = _e1751;
                                                } else {
                                                    phi_2359_ = _e1172;
                                                }
                                                let _e1753 = phi_2359_;
                                                phi_1288_ = _e1753;
                                            } else {
                                                phi_1288_ = type_34();
                                            }
                                            let _e1755 = phi_1288_;
                                            continue;
                                            continuing {
                                                phi_1287_ = _e1755;
                                                phi_1290_ = _e1187;
                                                phi_3965_ = _e659;
                                                break if !(_e1193);
                                            }
                                        }
                                        let _e1758 = phi_3965_;
                                        phi_4125_ = _e1758;
                                        if _e1758 {
                                            break;
                                        }
                                        phi_4129_ = _e1758;
                                        let _e2051 = local_11;
                                        phi_3595_ = _e2051;
                                        phi_3596_ = false;
                                        phi_3597_ = _e702;
                                        phi_3598_ = _e704;
                                    } else {
                                        if (_e704.member_1 >= _e92) {
                                            phi_3130_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e704.member_1 < _e92) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e715 = (_e262 * 2u);
                                            let _e717 = ((1u + _e715) % 7u);
                                            if (_e717 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e722 = global_5.member[_e704.member_1][_e717];
                                            let _e724 = ((_e715 + 2u) % 7u);
                                            if (_e724 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e729 = global_5.member[_e704.member_1][_e724];
                                            let _e730 = (_e261 * 2u);
                                            let _e732 = ((1u + _e730) % 7u);
                                            if (_e732 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e737 = global_5.member[_e704.member_1][_e732];
                                            let _e739 = ((_e730 + 2u) % 7u);
                                            if (_e739 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e744 = global_5.member[_e704.member_1][_e739];
                                            let _e745 = (_e263 * 2u);
                                            let _e747 = ((1u + _e745) % 7u);
                                            if (_e747 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e752 = global_5.member[_e704.member_1][_e747];
                                            let _e754 = ((_e745 + 2u) % 7u);
                                            if (_e754 < 7u) {
                                            } else {
                                                phi_4125_ = true;
                                                break;
                                            }
                                            let _e759 = global_5.member[_e704.member_1][_e754];
                                            let _e782 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e783 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e784 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e786 = select(_e142, _e782, (_e782 > _e142));
                                            let _e788 = select(_e142, _e783, (_e783 > _e142));
                                            let _e790 = select(_e142, _e784, (_e784 > _e142));
                                            let _e821 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 2097151u))) - 8388608f) * _e786));
                                            let _e826 = (bitcast<i32>((_e722 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e829 = bitcast<f32>((_e821 & bitcast<u32>(_e826)));
                                            let _e830 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e737 & 2097151u))) - 8388608f) * _e788));
                                            let _e835 = (bitcast<i32>((_e737 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e838 = bitcast<f32>((_e830 & bitcast<u32>(_e835)));
                                            let _e839 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e752 & 2097151u))) - 8388608f) * _e790));
                                            let _e844 = (bitcast<i32>((_e752 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e847 = bitcast<f32>((_e839 & bitcast<u32>(_e844)));
                                            let _e851 = bitcast<f32>((_e821 & bitcast<u32>(~(_e826))));
                                            let _e855 = bitcast<f32>((_e830 & bitcast<u32>(~(_e835))));
                                            let _e859 = bitcast<f32>((_e839 & bitcast<u32>(~(_e844))));
                                            let _e860 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e729 & 2097151u))) - 8388608f) * _e786));
                                            let _e865 = (bitcast<i32>((_e729 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e868 = bitcast<f32>((_e860 & bitcast<u32>(_e865)));
                                            let _e869 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e744 & 2097151u))) - 8388608f) * _e788));
                                            let _e874 = (bitcast<i32>((_e744 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e877 = bitcast<f32>((_e869 & bitcast<u32>(_e874)));
                                            let _e878 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e759 & 2097151u))) - 8388608f) * _e790));
                                            let _e883 = (bitcast<i32>((_e759 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e886 = bitcast<f32>((_e878 & bitcast<u32>(_e883)));
                                            let _e890 = bitcast<f32>((_e860 & bitcast<u32>(~(_e865))));
                                            let _e894 = bitcast<f32>((_e869 & bitcast<u32>(~(_e874))));
                                            let _e898 = bitcast<f32>((_e878 & bitcast<u32>(~(_e883))));
                                            let _e928 = global_5.member[_e704.member_1][0u];
                                            let _e932 = global_5.member[_e704.member_1][2u];
                                            let _e936 = global_5.member[_e704.member_1][4u];
                                            let _e940 = global_5.member[_e704.member_1][6u];
                                            let _e952 = (((_e932 >> bitcast<u32>(22i)) | ((_e936 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e940 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e953 = (_e928 & 268435455u);
                                            let _e954 = (_e952 & 268435455u);
                                            let _e957 = ((_e928 >> bitcast<u32>(28u)) & 7u);
                                            let _e965 = ((_e928 >> bitcast<u32>(31i)) | (((_e952 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e966 = (_e957 != 0u);
                                            if (_e957 == 0u) {
                                                phi_3092_ = _e953;
                                            } else {
                                                if (_e957 == 7u) {
                                                    phi_3091_ = 2147483648u;
                                                } else {
                                                    phi_3091_ = ((2147483648u | (_e957 << bitcast<u32>(28u))) | (_e954 & 268435455u));
                                                }
                                                let _e975 = phi_3091_;
                                                phi_3092_ = _e975;
                                            }
                                            let _e977 = phi_3092_;
                                            if _e966 {
                                                let _e978 = (_e957 != 7u);
                                                if _e978 {
                                                    phi_3102_ = (_e954 + _e957);
                                                } else {
                                                    phi_3102_ = u32();
                                                }
                                                let _e981 = phi_3102_;
                                                phi_3104_ = _e981;
                                                phi_3105_ = select(true, false, _e978);
                                            } else {
                                                phi_3104_ = u32();
                                                phi_3105_ = true;
                                            }
                                            let _e984 = phi_3104_;
                                            let _e986 = phi_3105_;
                                            if (_e965 == 0u) {
                                                phi_3126_ = (_e953 + select(0u, 1u, !(_e966)));
                                            } else {
                                                if (_e965 == 7u) {
                                                    phi_3125_ = 2147483648u;
                                                } else {
                                                    phi_3125_ = ((2147483648u | (_e965 << bitcast<u32>(28u))) | (select(_e984, _e954, _e986) & 268435455u));
                                                }
                                                let _e999 = phi_3125_;
                                                phi_3126_ = _e999;
                                            }
                                            let _e1001 = phi_3126_;
                                            phi_3130_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e704.member.member.x + _e829), (_e704.member.member.x + _e851), (_e704.member.member_1.x - _e868), (_e704.member.member_1.x - _e890)), vec4<f32>((_e704.member.member.y + _e838), (_e704.member.member.y + _e855), (_e704.member.member_1.y - _e877), (_e704.member.member_1.y - _e894)), vec4<f32>((_e704.member.member.z + _e847), (_e704.member.member.z + _e859), (_e704.member.member_1.z - _e886), (_e704.member.member_1.z - _e898))), type_50(type_29((_e704.member.member + vec4<f32>(_e829, _e838, _e847, 0f)), (_e704.member.member_1 - vec4<f32>(_e868, _e877, _e886, 0f))), _e977), type_50(type_29((_e704.member.member + vec4<f32>(_e851, _e855, _e859, 0f)), (_e704.member.member_1 - vec4<f32>(_e890, _e894, _e898, 0f))), _e1001));
                                        }
                                        let _e1006 = phi_3130_;
                                        let _e1018 = ((_e1006.member[0].x - _e364) * _e369);
                                        let _e1019 = ((_e1006.member[0].y - _e364) * _e369);
                                        let _e1020 = ((_e1006.member[0].z - _e365) * _e369);
                                        let _e1021 = ((_e1006.member[0].w - _e365) * _e369);
                                        let _e1031 = ((_e1006.member[1].x - _e432) * _e437);
                                        let _e1032 = ((_e1006.member[1].y - _e432) * _e437);
                                        let _e1033 = ((_e1006.member[1].z - _e433) * _e437);
                                        let _e1034 = ((_e1006.member[1].w - _e433) * _e437);
                                        let _e1044 = ((_e1006.member[2].x - _e500) * _e505);
                                        let _e1045 = ((_e1006.member[2].y - _e500) * _e505);
                                        let _e1046 = ((_e1006.member[2].z - _e501) * _e505);
                                        let _e1047 = ((_e1006.member[2].w - _e501) * _e505);
                                        let _e1049 = select(_e1046, _e1044, (_e1044 < _e1046));
                                        let _e1051 = select(_e1047, _e1045, (_e1045 < _e1047));
                                        let _e1053 = select(_e1046, _e1044, (_e1044 > _e1046));
                                        let _e1055 = select(_e1047, _e1045, (_e1045 > _e1047));
                                        let _e1057 = select(_e1020, _e1018, (_e1018 < _e1020));
                                        let _e1059 = select(_e1021, _e1019, (_e1019 < _e1021));
                                        let _e1061 = select(_e1033, _e1031, (_e1031 < _e1033));
                                        let _e1063 = select(_e1034, _e1032, (_e1032 < _e1034));
                                        let _e1065 = select(_e1061, _e1057, (_e1057 > _e1061));
                                        let _e1067 = select(_e1063, _e1059, (_e1059 > _e1063));
                                        let _e1069 = select(_e1049, _e1065, (_e1065 > _e1049));
                                        let _e1071 = select(_e1051, _e1067, (_e1067 > _e1051));
                                        let _e1073 = select(_e1020, _e1018, (_e1018 > _e1020));
                                        let _e1075 = select(_e1021, _e1019, (_e1019 > _e1021));
                                        let _e1077 = select(_e1033, _e1031, (_e1031 > _e1033));
                                        let _e1079 = select(_e1034, _e1032, (_e1032 > _e1034));
                                        let _e1081 = select(_e1077, _e1073, (_e1073 < _e1077));
                                        let _e1083 = select(_e1079, _e1075, (_e1075 < _e1079));
                                        let _e1088 = -(_e1049);
                                        let _e1089 = -(_e1051);
                                        let _e1096 = (select(_e1053, _e1081, (_e1081 < _e1053)) + (select(_e1088, _e1053, (_e1053 > _e1088)) * 0.0000019073523f));
                                        let _e1097 = (select(_e1055, _e1083, (_e1083 < _e1055)) + (select(_e1089, _e1055, (_e1055 > _e1089)) * 0.0000019073523f));
                                        let _e1099 = select(_e617, _e1069, (_e1069 > _e617));
                                        let _e1101 = select(_e617, _e1071, (_e1071 > _e617));
                                        let _e1106 = (_e1099 <= select(_e661.member_1, _e1096, (_e1096 < _e661.member_1)));
                                        let _e1107 = (_e1101 <= select(_e661.member_1, _e1097, (_e1097 < _e661.member_1)));
                                        let _e1108 = (_e1099 <= _e1101);
                                        if _e1106 {
                                            if _e1107 {
                                                if _e1108 {
                                                    phi_3492_ = _e1006.member_2;
                                                } else {
                                                    phi_3492_ = _e1006.member_1;
                                                }
                                                let _e1112 = phi_3492_;
                                                let _e1134 = (_e702 % 128u);
                                                let _e1135 = (_e1134 < 128u);
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_8[_e1134] = _e1112.member_1;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_7[_e1134] = _e1112.member.member.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_6[_e1134] = _e1112.member.member.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_5[_e1134] = _e1112.member.member.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_4[_e1134] = _e1112.member.member_1.x;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_3[_e1134] = _e1112.member.member_1.y;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_2[_e1134] = _e1112.member.member_1.z;
                                                if _e1135 {
                                                } else {
                                                    phi_4125_ = true;
                                                    break;
                                                }
                                                local_9[_e1134] = select(_e1101, _e1099, !(_e1108));
                                                if _e1108 {
                                                    phi_3569_ = _e1006.member_1;
                                                } else {
                                                    phi_3569_ = _e1006.member_2;
                                                }
                                                let _e1148 = phi_3569_;
                                                phi_3570_ = (_e702 + 1u);
                                                phi_3571_ = _e1148;
                                            } else {
                                                phi_3570_ = u32();
                                                phi_3571_ = type_50();
                                            }
                                            let _e1150 = phi_3570_;
                                            let _e1152 = phi_3571_;
                                            phi_3573_ = _e1150;
                                            phi_3574_ = _e1152;
                                            phi_3575_ = select(true, false, _e1107);
                                        } else {
                                            phi_3573_ = u32();
                                            phi_3574_ = type_50();
                                            phi_3575_ = true;
                                        }
                                        let _e1155 = phi_3573_;
                                        let _e1157 = phi_3574_;
                                        let _e1159 = phi_3575_;
                                        if _e1159 {
                                            if _e1106 {
                                                phi_3584_ = _e1006.member_1;
                                            } else {
                                                phi_3584_ = _e1006.member_2;
                                            }
                                            let _e1163 = phi_3584_;
                                            phi_3589_ = select(_e1107, true, _e1106);
                                            phi_3591_ = _e1163;
                                        } else {
                                            phi_3589_ = _e700;
                                            phi_3591_ = _e1157;
                                        }
                                        let _e1166 = phi_3589_;
                                        let _e1168 = phi_3591_;
                                        phi_4129_ = _e659;
                                        phi_3595_ = _e661;
                                        phi_3596_ = _e1166;
                                        phi_3597_ = select(_e1155, _e702, _e1159);
                                        phi_3598_ = _e1168;
                                    }
                                    let _e1760 = phi_4129_;
                                    let _e1762 = phi_3595_;
                                    let _e1764 = phi_3596_;
                                    let _e1766 = phi_3597_;
                                    let _e1768 = phi_3598_;
                                    phi_4128_ = _e1760;
                                    phi_3599_ = _e1762;
                                    phi_3600_ = _e1764;
                                    phi_3601_ = (_e665 - 1u);
                                    phi_3602_ = _e1766;
                                    phi_3603_ = _e1768;
                                } else {
                                    phi_4128_ = _e659;
                                    phi_3599_ = _e661;
                                    phi_3600_ = _e700;
                                    phi_3601_ = _e665;
                                    phi_3602_ = _e702;
                                    phi_3603_ = _e704;
                                }
                                let _e1770 = phi_4128_;
                                let _e1772 = phi_3599_;
                                let _e1774 = phi_3600_;
                                let _e1776 = phi_3601_;
                                let _e1778 = phi_3602_;
                                let _e1780 = phi_3603_;
                                phi_4127_ = _e1770;
                                phi_3604_ = _e1772;
                                phi_3605_ = _e1774;
                                phi_3606_ = _e1776;
                                phi_3607_ = _e1778;
                                phi_3608_ = _e1780;
                            } else {
                                phi_4127_ = _e659;
                                phi_3604_ = type_34();
                                phi_3605_ = bool();
                                phi_3606_ = u32();
                                phi_3607_ = u32();
                                phi_3608_ = type_50();
                            }
                            let _e1782 = phi_4127_;
                            let _e1784 = phi_3604_;
                            let _e1786 = phi_3605_;
                            let _e1788 = phi_3606_;
                            let _e1790 = phi_3607_;
                            let _e1792 = phi_3608_;
                            phi_4126_ = _e1782;
                            phi_1162_ = _e1784;
                            phi_1165_ = _e1786;
                            phi_1167_ = _e1788;
                            phi_1169_ = _e1790;
                            phi_1171_ = _e1792;
                            phi_3609_ = _e673;
                        } else {
                            phi_4126_ = _e659;
                            phi_1162_ = type_34();
                            phi_1165_ = bool();
                            phi_1167_ = u32();
                            phi_1169_ = u32();
                            phi_1171_ = type_50();
                            phi_3609_ = false;
                        }
                        let _e1794 = phi_4126_;
                        let _e1796 = phi_1162_;
                        let _e1798 = phi_1165_;
                        let _e1800 = phi_1167_;
                        let _e1802 = phi_1169_;
                        let _e1804 = phi_1171_;
                        let _e1806 = phi_3609_;
                        continue;
                        continuing {
                            phi_3971_ = _e1794;
                            phi_1161_ = _e1796;
                            phi_1164_ = _e1798;
                            phi_1166_ = _e1800;
                            phi_1168_ = _e1802;
                            phi_1170_ = _e1804;
                            phi_4125_ = _e1794;
                            break if !(_e1806);
                        }
                    }
                    let _e1809 = phi_4125_;
                    if _e1809 {
                        break;
                    }
                    let _e1811 = local_10;
                    if (_e1811.member.member_3 != 4294967295u) {
                        let _e1816 = -(_e519);
                        let _e1817 = bitcast<u32>(_e1811.member.member);
                        let _e1821 = (bitcast<i32>((_e1817 >> bitcast<u32>(23i))) & 255i);
                        let _e1822 = (_e1821 + _e1816);
                        if (_e1821 == 255i) {
                            phi_3668_ = _e1811.member.member;
                        } else {
                            if (_e1821 > 0i) {
                                if (_e1822 > 0i) {
                                    let _e1826 = (_e1822 < 255i);
                                    if _e1826 {
                                        phi_3647_ = bitcast<f32>((_e1817 + bitcast<u32>((_e1816 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3647_ = f32();
                                    }
                                    let _e1833 = phi_3647_;
                                    phi_3649_ = _e1833;
                                    phi_3650_ = select(true, false, _e1826);
                                } else {
                                    phi_3649_ = f32();
                                    phi_3650_ = true;
                                }
                                let _e1836 = phi_3649_;
                                let _e1838 = phi_3650_;
                                phi_3651_ = _e1836;
                                phi_3652_ = _e1838;
                            } else {
                                phi_3651_ = f32();
                                phi_3652_ = true;
                            }
                            let _e1840 = phi_3651_;
                            let _e1842 = phi_3652_;
                            if _e1842 {
                                let _e1843 = (_e1817 & 2147483648u);
                                let _e1850 = ((_e1817 & 8388607u) | (select(0u, 1u, ((_e1817 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1854 = (_e1850 == 0u);
                                if _e1854 {
                                    phi_3923_ = bitcast<f32>(_e1843);
                                } else {
                                    let _e1859 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1850)), 32u, _e1854) - 8u);
                                    let _e1862 = (_e1850 << bitcast<u32>((_e1859 & 31u)));
                                    let _e1864 = ((_e1822 + select(0i, 1i, (_e1821 == 0i))) - bitcast<i32>(_e1859));
                                    if (_e1864 >= 255i) {
                                        phi_3913_ = bitcast<f32>((_e1843 | 2139095040u));
                                        phi_3914_ = f32();
                                        phi_3915_ = true;
                                    } else {
                                        let _e1866 = (_e1864 > 0i);
                                        if _e1866 {
                                            phi_3907_ = bitcast<f32>(((_e1843 | (bitcast<u32>(_e1864) << bitcast<u32>(23i))) | (_e1862 & 8388607u)));
                                            phi_3908_ = f32();
                                        } else {
                                            if (_e1864 < -24i) {
                                                phi_3873_ = 26u;
                                            } else {
                                                phi_3873_ = bitcast<u32>((1i - _e1864));
                                            }
                                            let _e1871 = phi_3873_;
                                            let _e1872 = (_e1871 & 31u);
                                            let _e1874 = (_e1862 >> bitcast<u32>(_e1872));
                                            let _e1878 = (_e1862 & ((1u << bitcast<u32>(_e1872)) - 1u));
                                            let _e1882 = (1u << bitcast<u32>(((_e1871 - 1u) & 31u)));
                                            if (_e1878 > _e1882) {
                                                phi_3894_ = true;
                                            } else {
                                                if (_e1878 == _e1882) {
                                                    phi_3891_ = ((_e1874 & 1u) == 1u);
                                                } else {
                                                    phi_3891_ = false;
                                                }
                                                let _e1888 = phi_3891_;
                                                phi_3894_ = _e1888;
                                            }
                                            let _e1890 = phi_3894_;
                                            phi_3907_ = f32();
                                            phi_3908_ = bitcast<f32>((_e1843 | (_e1874 + select(0u, 1u, _e1890))));
                                        }
                                        let _e1903 = phi_3907_;
                                        let _e1905 = phi_3908_;
                                        phi_3913_ = _e1903;
                                        phi_3914_ = _e1905;
                                        phi_3915_ = _e1866;
                                    }
                                    let _e1909 = phi_3913_;
                                    let _e1911 = phi_3914_;
                                    let _e1913 = phi_3915_;
                                    phi_3923_ = select(_e1911, _e1909, _e1913);
                                }
                                let _e1917 = phi_3923_;
                                phi_3667_ = _e1917;
                            } else {
                                phi_3667_ = _e1840;
                            }
                            let _e1919 = phi_3667_;
                            phi_3668_ = _e1919;
                        }
                        let _e1921 = phi_3668_;
                        let _e1922 = bitcast<u32>(_e1921);
                        if ((_e1922 & 2147483647u) >= 2139095040u) {
                            phi_3680_ = bitcast<f32>(((_e1922 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3680_ = _e1921;
                        }
                        let _e1929 = phi_3680_;
                        phi_3685_ = type_21(_e1929, _e1811.member.member_1, _e1811.member.member_2, _e1811.member.member_3);
                    } else {
                        phi_3685_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1934 = phi_3685_;
                    if _e150 {
                    } else {
                        break;
                    }
                    global_6.member[_e148] = _e1934;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
