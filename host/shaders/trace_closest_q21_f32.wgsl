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
    var phi_3975_: bool;
    var phi_1161_: type_34;
    var phi_1164_: u32;
    var phi_1166_: bool;
    var phi_1168_: u32;
    var phi_1170_: type_50;
    var phi_1181_: bool;
    var phi_1267_: bool;
    var phi_1268_: u32;
    var phi_1269_: type_50;
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
    var phi_3969_: bool;
    var phi_4215_: bool;
    var phi_2360_: type_34;
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
    var phi_3603_: type_34;
    var phi_3604_: u32;
    var phi_3605_: bool;
    var phi_3606_: u32;
    var phi_3607_: type_50;
    var phi_4131_: bool;
    var phi_3608_: type_34;
    var phi_3609_: u32;
    var phi_3610_: bool;
    var phi_3611_: u32;
    var phi_3612_: type_50;
    var phi_4130_: bool;
    var phi_1162_: type_34;
    var phi_1165_: u32;
    var phi_1167_: bool;
    var phi_1169_: u32;
    var phi_1171_: type_50;
    var phi_3613_: bool;
    var phi_4129_: bool;
    var local_10: type_34;
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
    var phi_3689_: type_21;
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
                    phi_3975_ = false;
                    phi_1161_ = type_34(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e615);
                    phi_1164_ = ((3u * _e92) + 1u);
                    phi_1166_ = (_e617 <= _e615);
                    phi_1168_ = 0u;
                    phi_1170_ = type_50(type_29(vec4<f32>((f32(_e624) * _e142), (f32(_e630) * _e142), (f32(_e636) * _e142), 0f), vec4<f32>((f32(_e641) * _e142), (f32(_e645) * _e142), (f32(_e649) * _e142), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    loop {
                        let _e659 = phi_3975_;
                        let _e661 = phi_1161_;
                        let _e663 = phi_1164_;
                        let _e665 = phi_1166_;
                        let _e667 = phi_1168_;
                        let _e669 = phi_1170_;
                        local_10 = _e661;
                        if _e665 {
                            phi_1181_ = true;
                        } else {
                            phi_1181_ = (_e667 > 0u);
                        }
                        let _e672 = phi_1181_;
                        if _e672 {
                            let _e673 = (_e663 > 0u);
                            if _e673 {
                                if _e665 {
                                    phi_1267_ = _e665;
                                    phi_1268_ = _e667;
                                    phi_1269_ = _e669;
                                } else {
                                    let _e674 = (_e667 - 1u);
                                    let _e675 = (_e674 % 128u);
                                    let _e676 = (_e675 < 128u);
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e678 = local_7[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e680 = local_6[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e682 = local_5[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e684 = local_4[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e686 = local_3[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e688 = local_2[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
                                        break;
                                    }
                                    let _e693 = local_8[_e675];
                                    if _e676 {
                                    } else {
                                        phi_4129_ = true;
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
                                    let _e708 = ((_e704.member_1 & 2147483648u) != 0u);
                                    if _e708 {
                                        phi_1287_ = _e661;
                                        phi_1290_ = type_4(0u, ((_e704.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e715 = phi_1287_;
                                            let _e717 = phi_1290_;
                                            local_11 = _e715;
                                            if (_e717.member < _e717.member_1) {
                                                phi_1291_ = type_4((_e717.member + 1u), _e717.member_1);
                                                phi_1313_ = type_4(1u, _e717.member);
                                            } else {
                                                phi_1291_ = _e717;
                                                phi_1313_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e730 = phi_1291_;
                                            let _e732 = phi_1313_;
                                            let _e736 = (bitcast<i32>(_e732.member) != 0i);
                                            if _e736 {
                                                let _e737 = ((_e704.member_1 & 268435455u) + _e732.member_1);
                                                let _e738 = (_e737 < _e94);
                                                if _e738 {
                                                    if _e738 {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e742 = global_2.member[_e737].member_1;
                                                    phi_1334_ = _e742;
                                                } else {
                                                    phi_1334_ = 4294967295u;
                                                }
                                                let _e744 = phi_1334_;
                                                if (_e737 >= _e94) {
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e738 {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    if (_e621 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e751 = global_2.member[_e737].member[_e621];
                                                    if (_e627 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e757 = global_2.member[_e737].member[_e627];
                                                    if (_e633 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e763 = global_2.member[_e737].member[_e633];
                                                    let _e765 = (3u + _e621);
                                                    if (_e765 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e771 = global_2.member[_e737].member[_e765];
                                                    let _e772 = (3u + _e627);
                                                    if (_e772 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e778 = global_2.member[_e737].member[_e772];
                                                    let _e779 = (3u + _e633);
                                                    if (_e779 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e785 = global_2.member[_e737].member[_e779];
                                                    let _e787 = (6u + _e621);
                                                    if (_e787 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e793 = global_2.member[_e737].member[_e787];
                                                    let _e794 = (6u + _e627);
                                                    if (_e794 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e800 = global_2.member[_e737].member[_e794];
                                                    let _e801 = (6u + _e633);
                                                    if (_e801 < 9u) {
                                                    } else {
                                                        phi_3969_ = true;
                                                        break;
                                                    }
                                                    let _e807 = global_2.member[_e737].member[_e801];
                                                    phi_1426_ = array<array<f32, 3>, 3>(array<f32, 3>(_e751, _e757, _e763), array<f32, 3>(_e771, _e778, _e785), array<f32, 3>(_e793, _e800, _e807));
                                                }
                                                let _e811 = phi_1426_;
                                                let _e819 = (_e811[0][2] - _e463);
                                                let _e822 = (((_e811[0][0] - _e326) * _e502) - (_e819 * _e366));
                                                let _e825 = (((_e811[0][1] - _e395) * _e502) - (_e819 * _e434));
                                                let _e832 = (_e811[1][2] - _e463);
                                                let _e835 = (((_e811[1][0] - _e326) * _e502) - (_e832 * _e366));
                                                let _e838 = (((_e811[1][1] - _e395) * _e502) - (_e832 * _e434));
                                                let _e845 = (_e811[2][2] - _e463);
                                                let _e848 = (((_e811[2][0] - _e326) * _e502) - (_e845 * _e366));
                                                let _e851 = (((_e811[2][1] - _e395) * _e502) - (_e845 * _e434));
                                                let _e852 = (_e848 * _e838);
                                                let _e853 = (_e851 * _e835);
                                                let _e854 = (_e822 * _e851);
                                                let _e855 = (_e825 * _e848);
                                                let _e856 = (_e835 * _e825);
                                                let _e857 = (_e838 * _e822);
                                                let _e862 = (((_e852 >= _e853) && (_e854 >= _e855)) && (_e856 >= _e857));
                                                if (_e862 || (((_e852 <= _e853) && (_e854 <= _e855)) && (_e856 <= _e857))) {
                                                    let _e869 = select(-1f, 1f, _e862);
                                                    let _e871 = ((_e852 - _e853) * _e869);
                                                    let _e873 = select(0f, _e871, (_e871 > 0f));
                                                    let _e875 = ((_e854 - _e855) * _e869);
                                                    let _e877 = select(0f, _e875, (_e875 > 0f));
                                                    let _e879 = ((_e856 - _e857) * _e869);
                                                    let _e881 = select(0f, _e879, (_e879 > 0f));
                                                    let _e883 = ((_e873 + _e877) + _e881);
                                                    if (_e883 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2310_ = type_21();
                                                        phi_2311_ = true;
                                                        phi_2312_ = false;
                                                    } else {
                                                        let _e886 = select(_e835, _e822, (_e822 < _e835));
                                                        if (select(_e848, _e886, (_e886 < _e848)) > 0f) {
                                                            phi_1578_ = true;
                                                        } else {
                                                            let _e891 = select(_e835, _e822, (_e822 > _e835));
                                                            phi_1578_ = (select(_e848, _e891, (_e891 > _e848)) < 0f);
                                                        }
                                                        let _e896 = phi_1578_;
                                                        if _e896 {
                                                            phi_2307_ = type_21();
                                                            phi_2308_ = true;
                                                            phi_2309_ = false;
                                                        } else {
                                                            let _e898 = select(_e838, _e825, (_e825 < _e838));
                                                            if (select(_e851, _e898, (_e898 < _e851)) > 0f) {
                                                                phi_1607_ = true;
                                                            } else {
                                                                let _e903 = select(_e838, _e825, (_e825 > _e838));
                                                                phi_1607_ = (select(_e851, _e903, (_e903 > _e851)) < 0f);
                                                            }
                                                            let _e908 = phi_1607_;
                                                            if _e908 {
                                                                phi_2305_ = type_21();
                                                                phi_2306_ = false;
                                                            } else {
                                                                let _e910 = select(_e811[1][0], _e811[0][0], (_e811[0][0] < _e811[1][0]));
                                                                let _e914 = select(_e811[1][0], _e811[0][0], (_e811[0][0] > _e811[1][0]));
                                                                let _e918 = select(_e811[1][1], _e811[0][1], (_e811[0][1] < _e811[1][1]));
                                                                let _e922 = select(_e811[1][1], _e811[0][1], (_e811[0][1] > _e811[1][1]));
                                                                let _e926 = select(_e811[1][2], _e811[0][2], (_e811[0][2] < _e811[1][2]));
                                                                let _e930 = select(_e811[1][2], _e811[0][2], (_e811[0][2] > _e811[1][2]));
                                                                let _e935 = ((select(_e811[2][0], _e910, (_e910 < _e811[2][0])) - _e364) * _e369);
                                                                let _e936 = ((select(_e811[2][0], _e914, (_e914 > _e811[2][0])) - _e365) * _e369);
                                                                let _e939 = ((select(_e811[2][1], _e918, (_e918 < _e811[2][1])) - _e432) * _e437);
                                                                let _e940 = ((select(_e811[2][1], _e922, (_e922 > _e811[2][1])) - _e433) * _e437);
                                                                let _e943 = ((select(_e811[2][2], _e926, (_e926 < _e811[2][2])) - _e500) * _e505);
                                                                let _e944 = ((select(_e811[2][2], _e930, (_e930 > _e811[2][2])) - _e501) * _e505);
                                                                let _e946 = select(_e944, _e943, (_e943 < _e944));
                                                                let _e948 = select(_e944, _e943, (_e943 > _e944));
                                                                let _e950 = select(_e936, _e935, (_e935 < _e936));
                                                                let _e952 = select(_e940, _e939, (_e939 < _e940));
                                                                let _e954 = select(_e952, _e950, (_e950 > _e952));
                                                                let _e956 = select(_e946, _e954, (_e954 > _e946));
                                                                let _e958 = select(_e936, _e935, (_e935 > _e936));
                                                                let _e960 = select(_e940, _e939, (_e939 > _e940));
                                                                let _e962 = select(_e960, _e958, (_e958 < _e960));
                                                                let _e964 = select(_e948, _e962, (_e962 < _e948));
                                                                let _e965 = -(_e946);
                                                                let _e971 = select(_e617, _e956, (_e956 > _e617));
                                                                if (_e971 > (_e964 + (select(_e965, _e948, (_e948 > _e965)) * 0.0000019073523f))) {
                                                                    phi_2300_ = type_21();
                                                                    phi_2301_ = true;
                                                                } else {
                                                                    let _e973 = (_e971 > _e715.member_1);
                                                                    if _e973 {
                                                                        phi_2299_ = type_21();
                                                                    } else {
                                                                        let _e974 = vec3<f32>(_e811[0][0], _e811[0][1], _e811[0][2]);
                                                                        let _e975 = vec3<f32>(_e811[1][0], _e811[1][1], _e811[1][2]);
                                                                        let _e976 = vec3<f32>(_e811[2][0], _e811[2][1], _e811[2][2]);
                                                                        let _e977 = (_e811[1][0] - _e811[0][0]);
                                                                        let _e978 = (_e811[1][1] - _e811[0][1]);
                                                                        let _e979 = (_e811[1][2] - _e811[0][2]);
                                                                        let _e980 = vec3<f32>(_e977, _e978, _e979);
                                                                        let _e981 = (_e811[2][0] - _e811[1][0]);
                                                                        let _e982 = (_e811[2][1] - _e811[1][1]);
                                                                        let _e983 = (_e811[2][2] - _e811[1][2]);
                                                                        let _e984 = vec3<f32>(_e981, _e982, _e983);
                                                                        let _e985 = (_e811[0][0] - _e811[2][0]);
                                                                        let _e986 = (_e811[0][1] - _e811[2][1]);
                                                                        let _e987 = (_e811[0][2] - _e811[2][2]);
                                                                        let _e988 = vec3<f32>(_e985, _e986, _e987);
                                                                        let _e991 = bitcast<f32>((bitcast<u32>(_e977) & 2147483647u));
                                                                        let _e994 = bitcast<f32>((bitcast<u32>(_e978) & 2147483647u));
                                                                        let _e996 = select(_e994, _e991, (_e991 > _e994));
                                                                        let _e999 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1001 = select(_e999, _e996, (_e996 > _e999));
                                                                        let _e1004 = bitcast<f32>((bitcast<u32>(_e981) & 2147483647u));
                                                                        let _e1007 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e1009 = select(_e1007, _e1004, (_e1004 > _e1007));
                                                                        let _e1012 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1014 = select(_e1012, _e1009, (_e1009 > _e1012));
                                                                        let _e1017 = bitcast<f32>((bitcast<u32>(_e985) & 2147483647u));
                                                                        let _e1020 = bitcast<f32>((bitcast<u32>(_e986) & 2147483647u));
                                                                        let _e1022 = select(_e1020, _e1017, (_e1017 > _e1020));
                                                                        let _e1025 = bitcast<f32>((bitcast<u32>(_e987) & 2147483647u));
                                                                        let _e1027 = select(_e1025, _e1022, (_e1022 > _e1025));
                                                                        let _e1029 = select(_e1014, _e1001, (_e1001 > _e1014));
                                                                        let _e1031 = select(_e1027, _e1029, (_e1029 > _e1027));
                                                                        if (_e1001 == _e1031) {
                                                                            phi_2026_ = _e838;
                                                                            phi_2027_ = _e835;
                                                                            phi_2028_ = _e825;
                                                                            phi_2029_ = _e822;
                                                                            phi_2030_ = _e974;
                                                                            phi_2031_ = _e988;
                                                                            phi_2032_ = _e984;
                                                                            phi_2033_ = _e980;
                                                                        } else {
                                                                            let _e1033 = (_e1014 == _e1031);
                                                                            let _e1038 = vec3(_e1033);
                                                                            phi_2026_ = select(_e825, _e851, _e1033);
                                                                            phi_2027_ = select(_e822, _e848, _e1033);
                                                                            phi_2028_ = select(_e851, _e838, _e1033);
                                                                            phi_2029_ = select(_e848, _e835, _e1033);
                                                                            phi_2030_ = select(_e976, _e975, _e1038);
                                                                            phi_2031_ = select(_e984, _e980, _e1038);
                                                                            phi_2032_ = select(_e980, _e988, _e1038);
                                                                            phi_2033_ = select(_e988, _e984, _e1038);
                                                                        }
                                                                        let _e1044 = phi_2026_;
                                                                        let _e1046 = phi_2027_;
                                                                        let _e1048 = phi_2028_;
                                                                        let _e1050 = phi_2029_;
                                                                        let _e1052 = phi_2030_;
                                                                        let _e1054 = phi_2031_;
                                                                        let _e1056 = phi_2032_;
                                                                        let _e1058 = phi_2033_;
                                                                        let _e1065 = ((_e1056.y * _e1054.z) - (_e1054.y * _e1056.z));
                                                                        let _e1070 = ((_e1056.z * _e1054.x) - (_e1054.z * _e1056.x));
                                                                        let _e1073 = ((_e1056.x * _e1054.y) - (_e1054.x * _e1056.y));
                                                                        if (_e873 >= _e877) {
                                                                            phi_2070_ = select(true, false, (_e873 >= _e881));
                                                                        } else {
                                                                            phi_2070_ = true;
                                                                        }
                                                                        let _e1078 = phi_2070_;
                                                                        if _e1078 {
                                                                            phi_2079_ = select(_e976, _e975, vec3((_e877 >= _e881)));
                                                                        } else {
                                                                            phi_2079_ = _e974;
                                                                        }
                                                                        let _e1083 = phi_2079_;
                                                                        let _e1094 = (((_e1065 * (_e1083.x - _e326)) + (_e1070 * (_e1083.y - _e395))) + (_e1073 * (_e1083.z - _e463)));
                                                                        let _e1099 = (((_e1065 * _e366) + (_e1070 * _e434)) + (_e1073 * _e502));
                                                                        let _e1100 = (_e1046 - _e1050);
                                                                        let _e1101 = (_e1044 - _e1048);
                                                                        let _e1109 = (-(((_e1050 * _e1100) + (_e1048 * _e1101))) / ((_e1100 * _e1100) + (_e1101 * _e1101)));
                                                                        let _e1111 = select(1f, _e1109, (_e1109 < 1f));
                                                                        let _e1113 = select(0f, _e1111, (_e1111 > 0f));
                                                                        let _e1126 = ((_e1052.x + (_e1058.x * _e1113)) - _e326);
                                                                        let _e1127 = ((_e1052.y + (_e1058.y * _e1113)) - _e395);
                                                                        let _e1128 = ((_e1052.z + (_e1058.z * _e1113)) - _e463);
                                                                        let _e1129 = (_e1128 / _e502);
                                                                        let _e1141 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                        let _e1144 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                        let _e1146 = select(_e1144, _e1141, (_e1141 > _e1144));
                                                                        let _e1149 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                        let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                        let _e1157 = bitcast<f32>((bitcast<u32>(_e1065) & 2147483647u));
                                                                        let _e1160 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                        let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                        let _e1165 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1065 * _e1126) + (_e1070 * _e1127)) + (_e1073 * _e1128)) - _e1094)) & 2147483647u)) <= ((0.0000009536743f * select(_e1031, _e1151, (_e1151 > _e1031))) * select(_e1165, _e1162, (_e1162 > _e1165)))) {
                                                                            let _e1175 = bitcast<f32>((bitcast<u32>(_e1056.x) & 2147483647u));
                                                                            let _e1178 = bitcast<f32>((bitcast<u32>(_e1056.y) & 2147483647u));
                                                                            let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                            let _e1183 = bitcast<f32>((bitcast<u32>(_e1056.z) & 2147483647u));
                                                                            let _e1189 = bitcast<f32>((bitcast<u32>(_e1054.x) & 2147483647u));
                                                                            let _e1192 = bitcast<f32>((bitcast<u32>(_e1054.y) & 2147483647u));
                                                                            let _e1194 = select(_e1192, _e1189, (_e1189 > _e1192));
                                                                            let _e1197 = bitcast<f32>((bitcast<u32>(_e1054.z) & 2147483647u));
                                                                            let _e1201 = (bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u)) > ((0.0000038146973f * select(_e1183, _e1180, (_e1180 > _e1183))) * select(_e1197, _e1194, (_e1194 > _e1197))));
                                                                            if _e1201 {
                                                                                phi_2244_ = (_e1094 / _e1099);
                                                                            } else {
                                                                                phi_2244_ = f32();
                                                                            }
                                                                            let _e1204 = phi_2244_;
                                                                            phi_2246_ = _e1204;
                                                                            phi_2247_ = select(true, false, _e1201);
                                                                        } else {
                                                                            phi_2246_ = f32();
                                                                            phi_2247_ = true;
                                                                        }
                                                                        let _e1207 = phi_2246_;
                                                                        let _e1209 = phi_2247_;
                                                                        if _e1209 {
                                                                            let _e1217 = (((_e1065 * (_e1126 - (_e366 * _e1129))) + (_e1070 * (_e1127 - (_e434 * _e1129)))) / _e1099);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u)) <= _e1031) {
                                                                                phi_2267_ = (_e1129 + _e1217);
                                                                            } else {
                                                                                phi_2267_ = _e1129;
                                                                            }
                                                                            let _e1224 = phi_2267_;
                                                                            phi_2268_ = _e1224;
                                                                        } else {
                                                                            phi_2268_ = _e1207;
                                                                        }
                                                                        let _e1226 = phi_2268_;
                                                                        let _e1228 = select(_e964, _e1226, (_e1226 < _e964));
                                                                        let _e1230 = select(_e956, _e1228, (_e1228 > _e956));
                                                                        if (_e1230 >= _e617) {
                                                                            let _e1232 = (_e1230 <= _e715.member_1);
                                                                            if _e1232 {
                                                                                let _e1233 = (1f / _e883);
                                                                                phi_2291_ = type_21(_e1230, (_e877 * _e1233), (_e881 * _e1233), _e744);
                                                                            } else {
                                                                                phi_2291_ = type_21();
                                                                            }
                                                                            let _e1238 = phi_2291_;
                                                                            phi_2293_ = _e1238;
                                                                            phi_2294_ = select(true, false, _e1232);
                                                                        } else {
                                                                            phi_2293_ = type_21();
                                                                            phi_2294_ = true;
                                                                        }
                                                                        let _e1241 = phi_2293_;
                                                                        let _e1243 = phi_2294_;
                                                                        if _e1243 {
                                                                            phi_2298_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2298_ = _e1241;
                                                                        }
                                                                        let _e1245 = phi_2298_;
                                                                        phi_2299_ = _e1245;
                                                                    }
                                                                    let _e1247 = phi_2299_;
                                                                    phi_2300_ = _e1247;
                                                                    phi_2301_ = _e973;
                                                                }
                                                                let _e1249 = phi_2300_;
                                                                let _e1251 = phi_2301_;
                                                                phi_2305_ = _e1249;
                                                                phi_2306_ = _e1251;
                                                            }
                                                            let _e1253 = phi_2305_;
                                                            let _e1255 = phi_2306_;
                                                            phi_2307_ = _e1253;
                                                            phi_2308_ = _e908;
                                                            phi_2309_ = _e1255;
                                                        }
                                                        let _e1257 = phi_2307_;
                                                        let _e1259 = phi_2308_;
                                                        let _e1261 = phi_2309_;
                                                        phi_2310_ = _e1257;
                                                        phi_2311_ = _e1259;
                                                        phi_2312_ = _e1261;
                                                    }
                                                    let _e1263 = phi_2310_;
                                                    let _e1265 = phi_2311_;
                                                    let _e1267 = phi_2312_;
                                                    phi_2320_ = _e1263;
                                                    phi_2321_ = select(_e1267, true, _e1265);
                                                } else {
                                                    phi_2320_ = type_21();
                                                    phi_2321_ = true;
                                                }
                                                let _e1270 = phi_2320_;
                                                let _e1272 = phi_2321_;
                                                if _e1272 {
                                                    phi_2325_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2325_ = _e1270;
                                                }
                                                let _e1274 = phi_2325_;
                                                if (_e1274.member_3 != 4294967295u) {
                                                    if (_e744 != 4294967295u) {
                                                        if (_e1274.member < _e715.member.member) {
                                                            phi_2351_ = true;
                                                        } else {
                                                            if (_e1274.member == _e715.member.member) {
                                                                phi_2350_ = (_e1274.member_3 < _e715.member.member_3);
                                                            } else {
                                                                phi_2350_ = false;
                                                            }
                                                            let _e1287 = phi_2350_;
                                                            phi_2351_ = _e1287;
                                                        }
                                                        let _e1289 = phi_2351_;
                                                        if _e1289 {
                                                            phi_2357_ = type_34(_e1274, _e1274.member);
                                                        } else {
                                                            phi_2357_ = _e715;
                                                        }
                                                        let _e1292 = phi_2357_;
                                                        phi_2358_ = _e1292;
                                                    } else {
                                                        phi_2358_ = _e715;
                                                    }
                                                    let _e1294 = phi_2358_;
                                                    phi_2359_ = _e1294;
                                                } else {
                                                    phi_2359_ = _e715;
                                                }
                                                let _e1296 = phi_2359_;
                                                phi_1288_ = _e1296;
                                            } else {
                                                phi_1288_ = type_34();
                                            }
                                            let _e1298 = phi_1288_;
                                            continue;
                                            continuing {
                                                phi_1287_ = _e1298;
                                                phi_1290_ = _e730;
                                                phi_3969_ = _e659;
                                                break if !(_e736);
                                            }
                                        }
                                        let _e1301 = phi_3969_;
                                        phi_4129_ = _e1301;
                                        if _e1301 {
                                            break;
                                        }
                                        phi_4215_ = _e1301;
                                        let _e2036 = local_11;
                                        phi_2360_ = _e2036;
                                    } else {
                                        phi_4215_ = _e659;
                                        phi_2360_ = _e661;
                                    }
                                    let _e1303 = phi_4215_;
                                    let _e1305 = phi_2360_;
                                    if _e708 {
                                        phi_3590_ = bool();
                                        phi_3591_ = u32();
                                        phi_3592_ = type_50();
                                    } else {
                                        if (_e704.member_1 >= _e92) {
                                            phi_3126_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e704.member_1 < _e92) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1308 = (_e262 * 2u);
                                            let _e1310 = ((1u + _e1308) % 7u);
                                            if (_e1310 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1315 = global_5.member[_e704.member_1][_e1310];
                                            let _e1317 = ((_e1308 + 2u) % 7u);
                                            if (_e1317 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1322 = global_5.member[_e704.member_1][_e1317];
                                            let _e1323 = (_e261 * 2u);
                                            let _e1325 = ((1u + _e1323) % 7u);
                                            if (_e1325 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1330 = global_5.member[_e704.member_1][_e1325];
                                            let _e1332 = ((_e1323 + 2u) % 7u);
                                            if (_e1332 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1337 = global_5.member[_e704.member_1][_e1332];
                                            let _e1338 = (_e263 * 2u);
                                            let _e1340 = ((1u + _e1338) % 7u);
                                            if (_e1340 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1345 = global_5.member[_e704.member_1][_e1340];
                                            let _e1347 = ((_e1338 + 2u) % 7u);
                                            if (_e1347 < 7u) {
                                            } else {
                                                phi_4129_ = true;
                                                break;
                                            }
                                            let _e1352 = global_5.member[_e704.member_1][_e1347];
                                            let _e1375 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.x - _e704.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1376 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.y - _e704.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1377 = (bitcast<f32>((bitcast<u32>((_e704.member.member_1.z - _e704.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1379 = select(_e142, _e1375, (_e1375 > _e142));
                                            let _e1381 = select(_e142, _e1376, (_e1376 > _e142));
                                            let _e1383 = select(_e142, _e1377, (_e1377 > _e142));
                                            let _e1414 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1315 & 2097151u))) - 8388608f) * _e1379));
                                            let _e1419 = (bitcast<i32>((_e1315 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1422 = bitcast<f32>((_e1414 & bitcast<u32>(_e1419)));
                                            let _e1423 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1330 & 2097151u))) - 8388608f) * _e1381));
                                            let _e1428 = (bitcast<i32>((_e1330 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1431 = bitcast<f32>((_e1423 & bitcast<u32>(_e1428)));
                                            let _e1432 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1345 & 2097151u))) - 8388608f) * _e1383));
                                            let _e1437 = (bitcast<i32>((_e1345 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1440 = bitcast<f32>((_e1432 & bitcast<u32>(_e1437)));
                                            let _e1444 = bitcast<f32>((_e1414 & bitcast<u32>(~(_e1419))));
                                            let _e1448 = bitcast<f32>((_e1423 & bitcast<u32>(~(_e1428))));
                                            let _e1452 = bitcast<f32>((_e1432 & bitcast<u32>(~(_e1437))));
                                            let _e1453 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1322 & 2097151u))) - 8388608f) * _e1379));
                                            let _e1458 = (bitcast<i32>((_e1322 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1461 = bitcast<f32>((_e1453 & bitcast<u32>(_e1458)));
                                            let _e1462 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1337 & 2097151u))) - 8388608f) * _e1381));
                                            let _e1467 = (bitcast<i32>((_e1337 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1470 = bitcast<f32>((_e1462 & bitcast<u32>(_e1467)));
                                            let _e1471 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1352 & 2097151u))) - 8388608f) * _e1383));
                                            let _e1476 = (bitcast<i32>((_e1352 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1479 = bitcast<f32>((_e1471 & bitcast<u32>(_e1476)));
                                            let _e1483 = bitcast<f32>((_e1453 & bitcast<u32>(~(_e1458))));
                                            let _e1487 = bitcast<f32>((_e1462 & bitcast<u32>(~(_e1467))));
                                            let _e1491 = bitcast<f32>((_e1471 & bitcast<u32>(~(_e1476))));
                                            let _e1521 = global_5.member[_e704.member_1][0u];
                                            let _e1525 = global_5.member[_e704.member_1][2u];
                                            let _e1529 = global_5.member[_e704.member_1][4u];
                                            let _e1533 = global_5.member[_e704.member_1][6u];
                                            let _e1545 = (((_e1525 >> bitcast<u32>(22i)) | ((_e1529 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1533 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1546 = (_e1521 & 268435455u);
                                            let _e1547 = (_e1545 & 268435455u);
                                            let _e1550 = ((_e1521 >> bitcast<u32>(28u)) & 7u);
                                            let _e1558 = ((_e1521 >> bitcast<u32>(31i)) | (((_e1545 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1559 = (_e1550 != 0u);
                                            if (_e1550 == 0u) {
                                                phi_3088_ = _e1546;
                                            } else {
                                                if (_e1550 == 7u) {
                                                    phi_3087_ = 2147483648u;
                                                } else {
                                                    phi_3087_ = ((2147483648u | (_e1550 << bitcast<u32>(28u))) | (_e1547 & 268435455u));
                                                }
                                                let _e1568 = phi_3087_;
                                                phi_3088_ = _e1568;
                                            }
                                            let _e1570 = phi_3088_;
                                            if _e1559 {
                                                let _e1571 = (_e1550 != 7u);
                                                if _e1571 {
                                                    phi_3098_ = (_e1547 + _e1550);
                                                } else {
                                                    phi_3098_ = u32();
                                                }
                                                let _e1574 = phi_3098_;
                                                phi_3100_ = _e1574;
                                                phi_3101_ = select(true, false, _e1571);
                                            } else {
                                                phi_3100_ = u32();
                                                phi_3101_ = true;
                                            }
                                            let _e1577 = phi_3100_;
                                            let _e1579 = phi_3101_;
                                            if (_e1558 == 0u) {
                                                phi_3122_ = (_e1546 + select(0u, 1u, !(_e1559)));
                                            } else {
                                                if (_e1558 == 7u) {
                                                    phi_3121_ = 2147483648u;
                                                } else {
                                                    phi_3121_ = ((2147483648u | (_e1558 << bitcast<u32>(28u))) | (select(_e1577, _e1547, _e1579) & 268435455u));
                                                }
                                                let _e1592 = phi_3121_;
                                                phi_3122_ = _e1592;
                                            }
                                            let _e1594 = phi_3122_;
                                            phi_3126_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e704.member.member.x + _e1422), (_e704.member.member.x + _e1444), (_e704.member.member_1.x - _e1461), (_e704.member.member_1.x - _e1483)), vec4<f32>((_e704.member.member.y + _e1431), (_e704.member.member.y + _e1448), (_e704.member.member_1.y - _e1470), (_e704.member.member_1.y - _e1487)), vec4<f32>((_e704.member.member.z + _e1440), (_e704.member.member.z + _e1452), (_e704.member.member_1.z - _e1479), (_e704.member.member_1.z - _e1491))), type_50(type_29((_e704.member.member + vec4<f32>(_e1422, _e1431, _e1440, 0f)), (_e704.member.member_1 - vec4<f32>(_e1461, _e1470, _e1479, 0f))), _e1570), type_50(type_29((_e704.member.member + vec4<f32>(_e1444, _e1448, _e1452, 0f)), (_e704.member.member_1 - vec4<f32>(_e1483, _e1487, _e1491, 0f))), _e1594));
                                        }
                                        let _e1599 = phi_3126_;
                                        let _e1611 = ((_e1599.member[0].x - _e364) * _e369);
                                        let _e1612 = ((_e1599.member[0].y - _e364) * _e369);
                                        let _e1613 = ((_e1599.member[0].z - _e365) * _e369);
                                        let _e1614 = ((_e1599.member[0].w - _e365) * _e369);
                                        let _e1624 = ((_e1599.member[1].x - _e432) * _e437);
                                        let _e1625 = ((_e1599.member[1].y - _e432) * _e437);
                                        let _e1626 = ((_e1599.member[1].z - _e433) * _e437);
                                        let _e1627 = ((_e1599.member[1].w - _e433) * _e437);
                                        let _e1637 = ((_e1599.member[2].x - _e500) * _e505);
                                        let _e1638 = ((_e1599.member[2].y - _e500) * _e505);
                                        let _e1639 = ((_e1599.member[2].z - _e501) * _e505);
                                        let _e1640 = ((_e1599.member[2].w - _e501) * _e505);
                                        let _e1642 = select(_e1639, _e1637, (_e1637 < _e1639));
                                        let _e1644 = select(_e1640, _e1638, (_e1638 < _e1640));
                                        let _e1646 = select(_e1639, _e1637, (_e1637 > _e1639));
                                        let _e1648 = select(_e1640, _e1638, (_e1638 > _e1640));
                                        let _e1650 = select(_e1613, _e1611, (_e1611 < _e1613));
                                        let _e1652 = select(_e1614, _e1612, (_e1612 < _e1614));
                                        let _e1654 = select(_e1626, _e1624, (_e1624 < _e1626));
                                        let _e1656 = select(_e1627, _e1625, (_e1625 < _e1627));
                                        let _e1658 = select(_e1654, _e1650, (_e1650 > _e1654));
                                        let _e1660 = select(_e1656, _e1652, (_e1652 > _e1656));
                                        let _e1662 = select(_e1642, _e1658, (_e1658 > _e1642));
                                        let _e1664 = select(_e1644, _e1660, (_e1660 > _e1644));
                                        let _e1666 = select(_e1613, _e1611, (_e1611 > _e1613));
                                        let _e1668 = select(_e1614, _e1612, (_e1612 > _e1614));
                                        let _e1670 = select(_e1626, _e1624, (_e1624 > _e1626));
                                        let _e1672 = select(_e1627, _e1625, (_e1625 > _e1627));
                                        let _e1674 = select(_e1670, _e1666, (_e1666 < _e1670));
                                        let _e1676 = select(_e1672, _e1668, (_e1668 < _e1672));
                                        let _e1681 = -(_e1642);
                                        let _e1682 = -(_e1644);
                                        let _e1689 = (select(_e1646, _e1674, (_e1674 < _e1646)) + (select(_e1681, _e1646, (_e1646 > _e1681)) * 0.0000019073523f));
                                        let _e1690 = (select(_e1648, _e1676, (_e1676 < _e1648)) + (select(_e1682, _e1648, (_e1648 > _e1682)) * 0.0000019073523f));
                                        let _e1692 = select(_e617, _e1662, (_e1662 > _e617));
                                        let _e1694 = select(_e617, _e1664, (_e1664 > _e617));
                                        let _e1699 = (_e1692 <= select(_e1305.member_1, _e1689, (_e1689 < _e1305.member_1)));
                                        let _e1700 = (_e1694 <= select(_e1305.member_1, _e1690, (_e1690 < _e1305.member_1)));
                                        let _e1701 = (_e1692 <= _e1694);
                                        if _e1699 {
                                            if _e1700 {
                                                if _e1701 {
                                                    phi_3488_ = _e1599.member_2;
                                                } else {
                                                    phi_3488_ = _e1599.member_1;
                                                }
                                                let _e1705 = phi_3488_;
                                                let _e1726 = (_e702 % 128u);
                                                let _e1727 = (_e1726 < 128u);
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_8[_e1726] = _e1705.member_1;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_7[_e1726] = _e1705.member.member.x;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_6[_e1726] = _e1705.member.member.y;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_5[_e1726] = _e1705.member.member.z;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_4[_e1726] = _e1705.member.member_1.x;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_3[_e1726] = _e1705.member.member_1.y;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_2[_e1726] = _e1705.member.member_1.z;
                                                if _e1727 {
                                                } else {
                                                    phi_4129_ = true;
                                                    break;
                                                }
                                                local_9[_e1726] = select(_e1692, _e1694, _e1701);
                                                if _e1701 {
                                                    phi_3564_ = _e1599.member_1;
                                                } else {
                                                    phi_3564_ = _e1599.member_2;
                                                }
                                                let _e1740 = phi_3564_;
                                                phi_3565_ = (_e702 + 1u);
                                                phi_3566_ = _e1740;
                                            } else {
                                                phi_3565_ = u32();
                                                phi_3566_ = type_50();
                                            }
                                            let _e1742 = phi_3565_;
                                            let _e1744 = phi_3566_;
                                            phi_3568_ = _e1742;
                                            phi_3569_ = _e1744;
                                            phi_3570_ = select(true, false, _e1700);
                                        } else {
                                            phi_3568_ = u32();
                                            phi_3569_ = type_50();
                                            phi_3570_ = true;
                                        }
                                        let _e1747 = phi_3568_;
                                        let _e1749 = phi_3569_;
                                        let _e1751 = phi_3570_;
                                        if _e1751 {
                                            if _e1699 {
                                                phi_3579_ = _e1599.member_1;
                                            } else {
                                                phi_3579_ = _e1599.member_2;
                                            }
                                            let _e1755 = phi_3579_;
                                            phi_3584_ = select(_e1700, true, _e1699);
                                            phi_3586_ = _e1755;
                                        } else {
                                            phi_3584_ = _e700;
                                            phi_3586_ = _e1749;
                                        }
                                        let _e1758 = phi_3584_;
                                        let _e1760 = phi_3586_;
                                        phi_3590_ = _e1758;
                                        phi_3591_ = select(_e1747, _e702, _e1751);
                                        phi_3592_ = _e1760;
                                    }
                                    let _e1763 = phi_3590_;
                                    let _e1765 = phi_3591_;
                                    let _e1767 = phi_3592_;
                                    if _e708 {
                                        phi_3602_ = _e704;
                                    } else {
                                        phi_3602_ = _e1767;
                                    }
                                    let _e1769 = phi_3602_;
                                    phi_4132_ = _e1303;
                                    phi_3603_ = _e1305;
                                    phi_3604_ = (_e663 - 1u);
                                    phi_3605_ = select(_e1763, false, _e708);
                                    phi_3606_ = select(_e1765, _e702, _e708);
                                    phi_3607_ = _e1769;
                                } else {
                                    phi_4132_ = _e659;
                                    phi_3603_ = _e661;
                                    phi_3604_ = _e663;
                                    phi_3605_ = _e700;
                                    phi_3606_ = _e702;
                                    phi_3607_ = _e704;
                                }
                                let _e1773 = phi_4132_;
                                let _e1775 = phi_3603_;
                                let _e1777 = phi_3604_;
                                let _e1779 = phi_3605_;
                                let _e1781 = phi_3606_;
                                let _e1783 = phi_3607_;
                                phi_4131_ = _e1773;
                                phi_3608_ = _e1775;
                                phi_3609_ = _e1777;
                                phi_3610_ = _e1779;
                                phi_3611_ = _e1781;
                                phi_3612_ = _e1783;
                            } else {
                                phi_4131_ = _e659;
                                phi_3608_ = type_34();
                                phi_3609_ = u32();
                                phi_3610_ = bool();
                                phi_3611_ = u32();
                                phi_3612_ = type_50();
                            }
                            let _e1785 = phi_4131_;
                            let _e1787 = phi_3608_;
                            let _e1789 = phi_3609_;
                            let _e1791 = phi_3610_;
                            let _e1793 = phi_3611_;
                            let _e1795 = phi_3612_;
                            phi_4130_ = _e1785;
                            phi_1162_ = _e1787;
                            phi_1165_ = _e1789;
                            phi_1167_ = _e1791;
                            phi_1169_ = _e1793;
                            phi_1171_ = _e1795;
                            phi_3613_ = _e673;
                        } else {
                            phi_4130_ = _e659;
                            phi_1162_ = type_34();
                            phi_1165_ = u32();
                            phi_1167_ = bool();
                            phi_1169_ = u32();
                            phi_1171_ = type_50();
                            phi_3613_ = false;
                        }
                        let _e1797 = phi_4130_;
                        let _e1799 = phi_1162_;
                        let _e1801 = phi_1165_;
                        let _e1803 = phi_1167_;
                        let _e1805 = phi_1169_;
                        let _e1807 = phi_1171_;
                        let _e1809 = phi_3613_;
                        continue;
                        continuing {
                            phi_3975_ = _e1797;
                            phi_1161_ = _e1799;
                            phi_1164_ = _e1801;
                            phi_1166_ = _e1803;
                            phi_1168_ = _e1805;
                            phi_1170_ = _e1807;
                            phi_4129_ = _e1797;
                            break if !(_e1809);
                        }
                    }
                    let _e1812 = phi_4129_;
                    if _e1812 {
                        break;
                    }
                    let _e1814 = local_10;
                    if (_e1814.member.member_3 != 4294967295u) {
                        let _e1819 = -(_e519);
                        let _e1820 = bitcast<u32>(_e1814.member.member);
                        let _e1824 = (bitcast<i32>((_e1820 >> bitcast<u32>(23i))) & 255i);
                        let _e1825 = (_e1824 + _e1819);
                        if (_e1824 == 255i) {
                            phi_3672_ = _e1814.member.member;
                        } else {
                            if (_e1824 > 0i) {
                                if (_e1825 > 0i) {
                                    let _e1829 = (_e1825 < 255i);
                                    if _e1829 {
                                        phi_3651_ = bitcast<f32>((_e1820 + bitcast<u32>((_e1819 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3651_ = f32();
                                    }
                                    let _e1836 = phi_3651_;
                                    phi_3653_ = _e1836;
                                    phi_3654_ = select(true, false, _e1829);
                                } else {
                                    phi_3653_ = f32();
                                    phi_3654_ = true;
                                }
                                let _e1839 = phi_3653_;
                                let _e1841 = phi_3654_;
                                phi_3655_ = _e1839;
                                phi_3656_ = _e1841;
                            } else {
                                phi_3655_ = f32();
                                phi_3656_ = true;
                            }
                            let _e1843 = phi_3655_;
                            let _e1845 = phi_3656_;
                            if _e1845 {
                                let _e1846 = (_e1820 & 2147483648u);
                                let _e1853 = ((_e1820 & 8388607u) | (select(0u, 1u, ((_e1820 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1857 = (_e1853 == 0u);
                                if _e1857 {
                                    phi_3927_ = bitcast<f32>(_e1846);
                                } else {
                                    let _e1862 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1853)), 32u, _e1857) - 8u);
                                    let _e1865 = (_e1853 << bitcast<u32>((_e1862 & 31u)));
                                    let _e1867 = ((_e1825 + select(0i, 1i, (_e1824 == 0i))) - bitcast<i32>(_e1862));
                                    if (_e1867 >= 255i) {
                                        phi_3917_ = bitcast<f32>((_e1846 | 2139095040u));
                                        phi_3918_ = f32();
                                        phi_3919_ = true;
                                    } else {
                                        let _e1869 = (_e1867 > 0i);
                                        if _e1869 {
                                            phi_3911_ = bitcast<f32>(((_e1846 | (bitcast<u32>(_e1867) << bitcast<u32>(23i))) | (_e1865 & 8388607u)));
                                            phi_3912_ = f32();
                                        } else {
                                            if (_e1867 < -24i) {
                                                phi_3877_ = 26u;
                                            } else {
                                                phi_3877_ = bitcast<u32>((1i - _e1867));
                                            }
                                            let _e1874 = phi_3877_;
                                            let _e1875 = (_e1874 & 31u);
                                            let _e1877 = (_e1865 >> bitcast<u32>(_e1875));
                                            let _e1881 = (_e1865 & ((1u << bitcast<u32>(_e1875)) - 1u));
                                            let _e1885 = (1u << bitcast<u32>(((_e1874 - 1u) & 31u)));
                                            if (_e1881 > _e1885) {
                                                phi_3898_ = true;
                                            } else {
                                                if (_e1881 == _e1885) {
                                                    phi_3895_ = ((_e1877 & 1u) == 1u);
                                                } else {
                                                    phi_3895_ = false;
                                                }
                                                let _e1891 = phi_3895_;
                                                phi_3898_ = _e1891;
                                            }
                                            let _e1893 = phi_3898_;
                                            phi_3911_ = f32();
                                            phi_3912_ = bitcast<f32>((_e1846 | (_e1877 + select(0u, 1u, _e1893))));
                                        }
                                        let _e1906 = phi_3911_;
                                        let _e1908 = phi_3912_;
                                        phi_3917_ = _e1906;
                                        phi_3918_ = _e1908;
                                        phi_3919_ = _e1869;
                                    }
                                    let _e1912 = phi_3917_;
                                    let _e1914 = phi_3918_;
                                    let _e1916 = phi_3919_;
                                    phi_3927_ = select(_e1914, _e1912, _e1916);
                                }
                                let _e1920 = phi_3927_;
                                phi_3671_ = _e1920;
                            } else {
                                phi_3671_ = _e1843;
                            }
                            let _e1922 = phi_3671_;
                            phi_3672_ = _e1922;
                        }
                        let _e1924 = phi_3672_;
                        let _e1925 = bitcast<u32>(_e1924);
                        if ((_e1925 & 2147483647u) >= 2139095040u) {
                            phi_3684_ = bitcast<f32>(((_e1925 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3684_ = _e1924;
                        }
                        let _e1932 = phi_3684_;
                        phi_3689_ = type_21(_e1932, _e1814.member.member_1, _e1814.member.member_2, _e1814.member.member_3);
                    } else {
                        phi_3689_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1937 = phi_3689_;
                    if _e150 {
                    } else {
                        break;
                    }
                    global_6.member[_e148] = _e1937;
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
