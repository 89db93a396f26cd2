struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_27,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_54 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_59 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_61 {
    member: type_59,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_66;
@group(0) @binding(3) 
var<storage> global_10: type_56;

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
    var phi_364_: u32;
    var phi_408_: i32;
    var phi_548_: type_40;
    var phi_654_: i32;
    var phi_655_: i32;
    var phi_665_: bool;
    var phi_675_: u32;
    var phi_676_: u32;
    var phi_678_: bool;
    var phi_683_: u32;
    var phi_716_: i32;
    var phi_734_: f32;
    var phi_740_: f32;
    var phi_780_: f32;
    var phi_786_: f32;
    var phi_838_: f32;
    var phi_850_: f32;
    var phi_859_: f32;
    var phi_865_: f32;
    var phi_905_: f32;
    var phi_911_: f32;
    var phi_963_: f32;
    var phi_975_: f32;
    var phi_984_: f32;
    var phi_990_: f32;
    var phi_1030_: f32;
    var phi_1036_: f32;
    var phi_1088_: f32;
    var phi_1100_: f32;
    var phi_1155_: i32;
    var phi_1177_: u32;
    var phi_1178_: u32;
    var phi_1215_: i32;
    var phi_1237_: u32;
    var phi_1238_: u32;
    var phi_1246_: f32;
    var phi_1247_: f32;
    var phi_4165_: bool;
    var phi_1330_: type_43;
    var phi_1333_: u32;
    var phi_1335_: bool;
    var phi_1337_: u32;
    var phi_1339_: type_61;
    var phi_1350_: bool;
    var phi_1436_: bool;
    var phi_1437_: u32;
    var phi_1438_: type_61;
    var phi_1456_: type_43;
    var phi_1459_: type_8;
    var phi_1460_: type_8;
    var phi_1482_: type_8;
    var phi_1503_: u32;
    var phi_1595_: array<array<f32, 3>, 3>;
    var phi_1747_: bool;
    var phi_1776_: bool;
    var phi_2195_: f32;
    var phi_2196_: f32;
    var phi_2197_: f32;
    var phi_2198_: f32;
    var phi_2199_: vec3<f32>;
    var phi_2200_: vec3<f32>;
    var phi_2201_: vec3<f32>;
    var phi_2202_: vec3<f32>;
    var phi_2239_: bool;
    var phi_2248_: vec3<f32>;
    var phi_2413_: f32;
    var phi_2415_: f32;
    var phi_2416_: bool;
    var phi_2436_: f32;
    var phi_2437_: f32;
    var phi_2460_: type_27;
    var phi_2462_: type_27;
    var phi_2463_: bool;
    var phi_2467_: type_27;
    var phi_2468_: type_27;
    var phi_2469_: type_27;
    var phi_2470_: bool;
    var phi_2474_: type_27;
    var phi_2475_: bool;
    var phi_2476_: type_27;
    var phi_2477_: bool;
    var phi_2478_: bool;
    var phi_2479_: type_27;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2489_: type_27;
    var phi_2490_: bool;
    var phi_2494_: type_27;
    var phi_2517_: u32;
    var phi_2531_: i32;
    var phi_2553_: vec3<f32>;
    var phi_2554_: vec3<f32>;
    var phi_2572_: vec3<f32>;
    var phi_2573_: vec3<f32>;
    var phi_2591_: vec3<f32>;
    var phi_2592_: vec3<f32>;
    var phi_2628_: vec3<f32>;
    var phi_2810_: f32;
    var phi_2828_: bool;
    var phi_2829_: bool;
    var phi_2848_: bool;
    var phi_2849_: bool;
    var phi_2855_: type_43;
    var phi_2856_: type_43;
    var phi_2857_: type_43;
    var phi_1457_: type_43;
    var phi_4159_: bool;
    var phi_4410_: bool;
    var phi_2858_: type_43;
    var phi_2879_: type_54;
    var phi_3765_: type_61;
    var phi_3841_: type_61;
    var phi_3842_: u32;
    var phi_3843_: type_61;
    var phi_3845_: u32;
    var phi_3846_: type_61;
    var phi_3847_: bool;
    var phi_3854_: type_61;
    var phi_3859_: bool;
    var phi_3861_: type_61;
    var phi_3865_: bool;
    var phi_3866_: u32;
    var phi_3867_: type_61;
    var phi_3877_: type_61;
    var phi_4354_: bool;
    var phi_3878_: type_43;
    var phi_3879_: u32;
    var phi_3880_: bool;
    var phi_3881_: u32;
    var phi_3882_: type_61;
    var phi_4353_: bool;
    var phi_3883_: type_43;
    var phi_3884_: u32;
    var phi_3885_: bool;
    var phi_3886_: u32;
    var phi_3887_: type_61;
    var phi_4352_: bool;
    var phi_1331_: type_43;
    var phi_1334_: u32;
    var phi_1336_: bool;
    var phi_1338_: u32;
    var phi_1340_: type_61;
    var phi_3888_: bool;
    var phi_4351_: bool;
    var local_10: type_43;
    var phi_3926_: f32;
    var phi_3928_: f32;
    var phi_3929_: bool;
    var phi_3930_: f32;
    var phi_3931_: bool;
    var phi_4079_: u32;
    var phi_4097_: bool;
    var phi_4100_: bool;
    var phi_4113_: f32;
    var phi_4114_: f32;
    var phi_4119_: f32;
    var phi_4120_: f32;
    var phi_4121_: bool;
    var phi_4129_: f32;
    var phi_3946_: f32;
    var phi_3947_: f32;
    var phi_3959_: f32;
    var phi_3964_: type_27;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e98 = arrayLength((&global_10.member));
            let _e100 = arrayLength((&global_4.member));
            let _e112 = arrayLength((&global_9.member));
            let _e116 = global_3.member[0u][0u];
            let _e120 = global_3.member[0u][1u];
            let _e124 = global_3.member[0u][2u];
            let _e128 = global_3.member[1u][0u];
            let _e132 = global_3.member[1u][1u];
            let _e136 = global_3.member[1u][2u];
            let _e140 = global_3.member[1u][3u];
            let _e144 = (_e95.x + (_e95.y * 2097152u));
            let _e151 = (_e144 < arrayLength((&global_7.member)));
            if _e151 {
                if _e151 {
                } else {
                    break;
                }
                let _e155 = global_7.member[_e144].member_2;
                phi_364_ = _e155;
            } else {
                phi_364_ = 4294967295u;
            }
            let _e157 = phi_364_;
            let _e160 = global_1.member[0u];
            let _e164 = global_2.member[0u][0u];
            let _e168 = global_2.member[0u][1u];
            let _e172 = global_2.member[0u][2u];
            let _e176 = global_2.member[0u][3u];
            let _e180 = global_2.member[1u][0u];
            let _e184 = global_2.member[1u][1u];
            let _e188 = global_2.member[1u][2u];
            let _e192 = global_2.member[1u][3u];
            let _e193 = bitcast<f32>(_e164);
            let _e194 = bitcast<f32>(_e168);
            let _e195 = bitcast<f32>(_e172);
            let _e197 = bitcast<f32>(_e180);
            let _e198 = array<u32, 3>(_e184, _e188, _e192);
            let _e200 = bitcast<i32>(_e160);
            if (_e200 < -126i) {
                phi_408_ = -126i;
            } else {
                phi_408_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_408_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_548_ = type_40(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                let _e218 = bitcast<u32>(_e193);
                let _e220 = ((_e218 & 2139095040u) != 0u);
                let _e235 = bitcast<u32>(_e194);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e195);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e270 = bitcast<u32>(_e197);
                let _e272 = ((_e270 & 2139095040u) != 0u);
                phi_548_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e218 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e218 & 2147483648u))), _e193, _e220) * _e210) * select(0.00000011920929f, 1f, _e220)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e194, _e237) * _e210) * select(0.00000011920929f, 1f, _e237)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e195, _e254) * _e210) * select(0.00000011920929f, 1f, _e254)) * _e216)), _e176, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e197, _e272) * _e210) * select(0.00000011920929f, 1f, _e272)) * _e216), _e198);
            }
            let _e289 = phi_548_;
            if _e151 {
                let _e290 = (_e144 < arrayLength((&global_8.member)));
                if _e290 {
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e300 = global_7.member[_e144].member.member_2[0u];
                    let _e302 = (bitcast<u32>(_e300) & 2147483647u);
                    let _e308 = global_7.member[_e144].member.member_2[1u];
                    let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                    let _e316 = global_7.member[_e144].member.member_2[2u];
                    let _e318 = (bitcast<u32>(_e316) & 2147483647u);
                    let _e324 = global_7.member[_e144].member.member[0u];
                    let _e326 = (bitcast<u32>(_e324) & 2147483647u);
                    let _e332 = global_7.member[_e144].member.member[1u];
                    let _e334 = (bitcast<u32>(_e332) & 2147483647u);
                    let _e340 = global_7.member[_e144].member.member[2u];
                    let _e342 = (bitcast<u32>(_e340) & 2147483647u);
                    let _e344 = select(_e310, _e302, (_e310 < _e302));
                    let _e346 = select(_e318, _e344, (_e318 < _e344));
                    let _e348 = select(_e326, _e346, (_e326 < _e346));
                    let _e350 = select(_e334, _e348, (_e334 < _e348));
                    let _e352 = select(_e342, _e350, (_e342 < _e350));
                    let _e357 = global_7.member[_e144].member.member_1;
                    let _e358 = bitcast<u32>(_e357);
                    let _e359 = (_e358 & 2147483647u);
                    let _e367 = global_7.member[_e144].member.member_3;
                    let _e368 = bitcast<u32>(_e367);
                    let _e369 = (_e368 & 2147483647u);
                    let _e373 = (((select(_e359, _e352, (_e359 < _e352)) < 2139095040u) && (_e369 <= 2139095040u)) && (_e346 > 0u));
                    if _e373 {
                        let _e376 = (bitcast<u32>(bitcast<f32>(_e346)) & 2147483647u);
                        if (_e376 >= 8388608u) {
                            phi_654_ = (bitcast<i32>((_e376 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_654_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e376)), 32u, (_e376 == 0u))));
                        }
                        let _e390 = phi_654_;
                        phi_655_ = _e390;
                    } else {
                        phi_655_ = 0i;
                    }
                    let _e392 = phi_655_;
                    let _e393 = (_e302 == _e346);
                    if _e393 {
                        phi_665_ = true;
                    } else {
                        phi_665_ = (_e310 == _e346);
                    }
                    let _e396 = phi_665_;
                    let _e397 = select(1u, 0u, _e393);
                    if _e396 {
                        let _e398 = (_e397 + 1u);
                        phi_675_ = _e398;
                        phi_676_ = _e398;
                        phi_678_ = select(true, false, (_e398 == 2u));
                    } else {
                        phi_675_ = u32();
                        phi_676_ = 0u;
                        phi_678_ = true;
                    }
                    let _e402 = phi_675_;
                    let _e404 = phi_676_;
                    let _e406 = phi_678_;
                    if _e406 {
                        phi_683_ = (_e404 + 1u);
                    } else {
                        phi_683_ = 0u;
                    }
                    let _e410 = phi_683_;
                    let _e411 = select(_e402, _e404, _e406);
                    let _e412 = select(_e397, select(2u, _e397, _e396), _e406);
                    let _e413 = -(_e392);
                    if (_e413 < -126i) {
                        phi_716_ = -126i;
                    } else {
                        phi_716_ = select(_e413, 127i, (_e413 > 127i));
                    }
                    let _e418 = phi_716_;
                    let _e423 = bitcast<f32>((bitcast<u32>((_e418 + 127i)) << bitcast<u32>(23i)));
                    let _e429 = bitcast<f32>((bitcast<u32>(((_e413 - _e418) + 127i)) << bitcast<u32>(23i)));
                    let _e434 = global_7.member[_e144].member.member;
                    let _e435 = (_e411 == 0u);
                    if _e435 {
                        phi_734_ = _e434[0];
                    } else {
                        phi_734_ = _e434[1];
                    }
                    let _e439 = phi_734_;
                    let _e440 = (_e411 == 2u);
                    if _e440 {
                        phi_740_ = _e434[2];
                    } else {
                        phi_740_ = _e439;
                    }
                    let _e443 = phi_740_;
                    let _e444 = bitcast<u32>(_e443);
                    let _e446 = ((_e444 & 2139095040u) != 0u);
                    let _e458 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * select(0.00000011920929f, 1f, _e446));
                    let _e459 = global_7.member[_e144].member.member_2;
                    if _e435 {
                        phi_780_ = _e459[0];
                    } else {
                        phi_780_ = _e459[1];
                    }
                    let _e463 = phi_780_;
                    if _e440 {
                        phi_786_ = _e459[2];
                    } else {
                        phi_786_ = _e463;
                    }
                    let _e466 = phi_786_;
                    let _e467 = bitcast<u32>(_e466);
                    let _e469 = ((_e467 & 2139095040u) != 0u);
                    let _e483 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * _e423) * select(0.00000011920929f, 1f, _e469)) * _e429);
                    let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e487 {
                        let _e491 = (bitcast<f32>((bitcast<u32>(_e458) & 2147483647u)) * 0.00000011920929f);
                        phi_838_ = select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f));
                    } else {
                        phi_838_ = 0f;
                    }
                    let _e495 = phi_838_;
                    let _e496 = (_e458 + _e495);
                    let _e497 = (_e458 - _e495);
                    let _e498 = select(_e483, 0f, _e487);
                    if _e487 {
                        phi_850_ = 38685626000000000000000000f;
                    } else {
                        phi_850_ = (1f / _e483);
                    }
                    let _e501 = phi_850_;
                    let _e502 = (_e410 == 0u);
                    if _e502 {
                        phi_859_ = _e434[0];
                    } else {
                        phi_859_ = _e434[1];
                    }
                    let _e506 = phi_859_;
                    let _e507 = (_e410 == 2u);
                    if _e507 {
                        phi_865_ = _e434[2];
                    } else {
                        phi_865_ = _e506;
                    }
                    let _e510 = phi_865_;
                    let _e511 = bitcast<u32>(_e510);
                    let _e513 = ((_e511 & 2139095040u) != 0u);
                    let _e525 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e511 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e511 & 2147483648u))), _e510, _e513) * select(0.00000011920929f, 1f, _e513));
                    if _e502 {
                        phi_905_ = _e459[0];
                    } else {
                        phi_905_ = _e459[1];
                    }
                    let _e529 = phi_905_;
                    if _e507 {
                        phi_911_ = _e459[2];
                    } else {
                        phi_911_ = _e529;
                    }
                    let _e532 = phi_911_;
                    let _e533 = bitcast<u32>(_e532);
                    let _e535 = ((_e533 & 2139095040u) != 0u);
                    let _e549 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e533 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e533 & 2147483648u))), _e532, _e535) * _e423) * select(0.00000011920929f, 1f, _e535)) * _e429);
                    let _e553 = (bitcast<f32>((bitcast<u32>(_e549) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e553 {
                        let _e557 = (bitcast<f32>((bitcast<u32>(_e525) & 2147483647u)) * 0.00000011920929f);
                        phi_963_ = select(0.00000000000011368684f, _e557, (_e557 > 0.00000000000011368684f));
                    } else {
                        phi_963_ = 0f;
                    }
                    let _e561 = phi_963_;
                    let _e562 = (_e525 + _e561);
                    let _e563 = (_e525 - _e561);
                    let _e564 = select(_e549, 0f, _e553);
                    if _e553 {
                        phi_975_ = 38685626000000000000000000f;
                    } else {
                        phi_975_ = (1f / _e549);
                    }
                    let _e567 = phi_975_;
                    let _e568 = (_e412 == 0u);
                    if _e568 {
                        phi_984_ = _e434[0];
                    } else {
                        phi_984_ = _e434[1];
                    }
                    let _e572 = phi_984_;
                    let _e573 = (_e412 == 2u);
                    if _e573 {
                        phi_990_ = _e434[2];
                    } else {
                        phi_990_ = _e572;
                    }
                    let _e576 = phi_990_;
                    let _e577 = bitcast<u32>(_e576);
                    let _e579 = ((_e577 & 2139095040u) != 0u);
                    let _e591 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e577 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e577 & 2147483648u))), _e576, _e579) * select(0.00000011920929f, 1f, _e579));
                    if _e568 {
                        phi_1030_ = _e459[0];
                    } else {
                        phi_1030_ = _e459[1];
                    }
                    let _e595 = phi_1030_;
                    if _e573 {
                        phi_1036_ = _e459[2];
                    } else {
                        phi_1036_ = _e595;
                    }
                    let _e598 = phi_1036_;
                    let _e599 = bitcast<u32>(_e598);
                    let _e601 = ((_e599 & 2139095040u) != 0u);
                    let _e615 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e599 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e599 & 2147483648u))), _e598, _e601) * _e423) * select(0.00000011920929f, 1f, _e601)) * _e429);
                    let _e619 = (bitcast<f32>((bitcast<u32>(_e615) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e619 {
                        let _e623 = (bitcast<f32>((bitcast<u32>(_e591) & 2147483647u)) * 0.00000011920929f);
                        phi_1088_ = select(0.00000000000011368684f, _e623, (_e623 > 0.00000000000011368684f));
                    } else {
                        phi_1088_ = 0f;
                    }
                    let _e627 = phi_1088_;
                    let _e628 = (_e591 + _e627);
                    let _e629 = (_e591 - _e627);
                    let _e630 = select(_e615, 0f, _e619);
                    if _e619 {
                        phi_1100_ = 38685626000000000000000000f;
                    } else {
                        phi_1100_ = (1f / _e615);
                    }
                    let _e633 = phi_1100_;
                    let _e636 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                    let _e639 = bitcast<f32>((bitcast<u32>(_e525) & 2147483647u));
                    let _e641 = select(_e639, _e636, (_e636 > _e639));
                    let _e644 = bitcast<f32>((bitcast<u32>(_e591) & 2147483647u));
                    if (_e373 && (select(_e644, _e641, (_e641 > _e644)) <= 1099511600000f)) {
                        let _e656 = ((_e359 & 8388607u) | (select(0u, 1u, ((_e359 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e659 = bitcast<i32>((_e359 >> bitcast<u32>(23i)));
                        let _e663 = (_e656 == 0u);
                        let _e666 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e656)), 32u, _e663)) - 8i);
                        if (_e659 == 255i) {
                            phi_1155_ = 255i;
                        } else {
                            phi_1155_ = (((_e659 + select(0i, 1i, (_e659 == 0i))) - _e666) + _e392);
                        }
                        let _e674 = phi_1155_;
                        let _e684 = (_e674 <= 0i);
                        if _e684 {
                            phi_1178_ = u32();
                        } else {
                            if _e663 {
                                phi_1177_ = u32();
                            } else {
                                phi_1177_ = select(((bitcast<u32>(_e674) << bitcast<u32>(23i)) | ((_e656 << bitcast<u32>(((_e666 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e674 >= 255i));
                            }
                            let _e688 = phi_1177_;
                            phi_1178_ = _e688;
                        }
                        let _e690 = phi_1178_;
                        let _e702 = ((_e369 & 8388607u) | (select(0u, 1u, ((_e369 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e705 = bitcast<i32>((_e369 >> bitcast<u32>(23i)));
                        let _e709 = (_e702 == 0u);
                        let _e712 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e702)), 32u, _e709)) - 8i);
                        if (_e705 == 255i) {
                            phi_1215_ = 255i;
                        } else {
                            phi_1215_ = (((_e705 + select(0i, 1i, (_e705 == 0i))) - _e712) + _e392);
                        }
                        let _e720 = phi_1215_;
                        let _e730 = (_e720 <= 0i);
                        if _e730 {
                            phi_1238_ = u32();
                        } else {
                            if _e709 {
                                phi_1237_ = u32();
                            } else {
                                phi_1237_ = select(((bitcast<u32>(_e720) << bitcast<u32>(23i)) | ((_e702 << bitcast<u32>(((_e712 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e720 >= 255i));
                            }
                            let _e734 = phi_1237_;
                            phi_1238_ = _e734;
                        }
                        let _e736 = phi_1238_;
                        phi_1246_ = bitcast<f32>(((_e368 & 2147483648u) | select(_e736, 0u, select(_e709, true, _e730))));
                        phi_1247_ = bitcast<f32>(((_e358 & 2147483648u) | select(_e690, 0u, select(_e663, true, _e684))));
                    } else {
                        phi_1246_ = 0f;
                        phi_1247_ = 1f;
                    }
                    let _e742 = phi_1246_;
                    let _e744 = phi_1247_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                    let _e749 = (_e411 % 3u);
                    let _e750 = (_e749 < 3u);
                    if _e750 {
                    } else {
                        break;
                    }
                    let _e752 = local_9[_e749];
                    let _e753 = (_e410 % 3u);
                    let _e754 = (_e753 < 3u);
                    if _e754 {
                    } else {
                        break;
                    }
                    let _e756 = local_9[_e753];
                    let _e757 = (_e412 % 3u);
                    let _e758 = (_e757 < 3u);
                    if _e758 {
                    } else {
                        break;
                    }
                    let _e760 = local_9[_e757];
                    local_8 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                    if _e750 {
                    } else {
                        break;
                    }
                    let _e764 = local_8[_e749];
                    if _e754 {
                    } else {
                        break;
                    }
                    let _e766 = local_8[_e753];
                    if _e758 {
                    } else {
                        break;
                    }
                    let _e768 = local_8[_e757];
                    phi_4165_ = false;
                    phi_1330_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e742);
                    phi_1333_ = ((3u * _e98) + 1u);
                    phi_1335_ = (_e744 <= _e742);
                    phi_1337_ = 0u;
                    phi_1339_ = type_61(type_59(array<f32, 3>(_e752, _e756, _e760), array<f32, 3>(_e764, _e766, _e768)), select(0u, 2147483648u, (_e98 == 0u)));
                    loop {
                        let _e776 = phi_4165_;
                        let _e778 = phi_1330_;
                        let _e780 = phi_1333_;
                        let _e782 = phi_1335_;
                        let _e784 = phi_1337_;
                        let _e786 = phi_1339_;
                        local_10 = _e778;
                        if _e782 {
                            phi_1350_ = true;
                        } else {
                            phi_1350_ = (_e784 > 0u);
                        }
                        let _e789 = phi_1350_;
                        if _e789 {
                            let _e790 = (_e780 > 0u);
                            if _e790 {
                                if _e782 {
                                    phi_1436_ = _e782;
                                    phi_1437_ = _e784;
                                    phi_1438_ = _e786;
                                } else {
                                    let _e791 = (_e784 - 1u);
                                    let _e792 = (_e791 % 128u);
                                    let _e793 = (_e792 < 128u);
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e795 = local_6[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e797 = local_5[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e799 = local_4[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e801 = local_3[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e804 = local_2[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e806 = local_1[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e808 = local[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4351_ = true;
                                        break;
                                    }
                                    let _e813 = local_7[_e792];
                                    phi_1436_ = (_e813 <= _e778.member_1);
                                    phi_1437_ = _e791;
                                    phi_1438_ = type_61(type_59(array<f32, 3>(_e797, _e799, _e801), array<f32, 3>(_e804, _e806, _e808)), _e795);
                                }
                                let _e817 = phi_1436_;
                                let _e819 = phi_1437_;
                                let _e821 = phi_1438_;
                                if _e817 {
                                    let _e825 = ((_e821.member_1 & 2147483648u) != 0u);
                                    if _e825 {
                                        phi_1456_ = _e778;
                                        phi_1459_ = type_8(0u, ((_e821.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e832 = phi_1456_;
                                            let _e834 = phi_1459_;
                                            local_11 = _e832;
                                            if (_e834.member < _e834.member_1) {
                                                phi_1460_ = type_8((_e834.member + 1u), _e834.member_1);
                                                phi_1482_ = type_8(1u, _e834.member);
                                            } else {
                                                phi_1460_ = _e834;
                                                phi_1482_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e847 = phi_1460_;
                                            let _e849 = phi_1482_;
                                            let _e853 = (bitcast<i32>(_e849.member) != 0i);
                                            if _e853 {
                                                let _e854 = ((_e821.member_1 & 268435455u) + _e849.member_1);
                                                let _e855 = (_e854 < _e100);
                                                if _e855 {
                                                    if _e855 {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e859 = global_4.member[_e854].member_1;
                                                    phi_1503_ = _e859;
                                                } else {
                                                    phi_1503_ = 4294967295u;
                                                }
                                                let _e861 = phi_1503_;
                                                if (_e854 >= _e100) {
                                                    phi_1595_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e855 {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e868 = global_4.member[_e854].member[_e749];
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e874 = global_4.member[_e854].member[_e753];
                                                    if (_e757 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e880 = global_4.member[_e854].member[_e757];
                                                    let _e882 = (3u + _e749);
                                                    if (_e882 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e888 = global_4.member[_e854].member[_e882];
                                                    let _e889 = (3u + _e753);
                                                    if (_e889 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e895 = global_4.member[_e854].member[_e889];
                                                    let _e896 = (3u + _e757);
                                                    if (_e896 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e902 = global_4.member[_e854].member[_e896];
                                                    let _e904 = (6u + _e749);
                                                    if (_e904 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_4.member[_e854].member[_e904];
                                                    let _e911 = (6u + _e753);
                                                    if (_e911 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e917 = global_4.member[_e854].member[_e911];
                                                    let _e918 = (6u + _e757);
                                                    if (_e918 < 9u) {
                                                    } else {
                                                        phi_4159_ = true;
                                                        break;
                                                    }
                                                    let _e924 = global_4.member[_e854].member[_e918];
                                                    phi_1595_ = array<array<f32, 3>, 3>(array<f32, 3>(_e868, _e874, _e880), array<f32, 3>(_e888, _e895, _e902), array<f32, 3>(_e910, _e917, _e924));
                                                }
                                                let _e928 = phi_1595_;
                                                let _e936 = (_e928[0][2] - _e591);
                                                let _e939 = (((_e928[0][0] - _e458) * _e630) - (_e936 * _e498));
                                                let _e942 = (((_e928[0][1] - _e525) * _e630) - (_e936 * _e564));
                                                let _e949 = (_e928[1][2] - _e591);
                                                let _e952 = (((_e928[1][0] - _e458) * _e630) - (_e949 * _e498));
                                                let _e955 = (((_e928[1][1] - _e525) * _e630) - (_e949 * _e564));
                                                let _e962 = (_e928[2][2] - _e591);
                                                let _e965 = (((_e928[2][0] - _e458) * _e630) - (_e962 * _e498));
                                                let _e968 = (((_e928[2][1] - _e525) * _e630) - (_e962 * _e564));
                                                let _e969 = (_e965 * _e955);
                                                let _e970 = (_e968 * _e952);
                                                let _e971 = (_e939 * _e968);
                                                let _e972 = (_e942 * _e965);
                                                let _e973 = (_e952 * _e942);
                                                let _e974 = (_e955 * _e939);
                                                let _e979 = (((_e969 >= _e970) && (_e971 >= _e972)) && (_e973 >= _e974));
                                                if (_e979 || (((_e969 <= _e970) && (_e971 <= _e972)) && (_e973 <= _e974))) {
                                                    let _e986 = select(-1f, 1f, _e979);
                                                    let _e988 = ((_e969 - _e970) * _e986);
                                                    let _e990 = select(0f, _e988, (_e988 > 0f));
                                                    let _e992 = ((_e971 - _e972) * _e986);
                                                    let _e994 = select(0f, _e992, (_e992 > 0f));
                                                    let _e996 = ((_e973 - _e974) * _e986);
                                                    let _e998 = select(0f, _e996, (_e996 > 0f));
                                                    let _e1000 = ((_e990 + _e994) + _e998);
                                                    if (_e1000 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2479_ = type_27();
                                                        phi_2480_ = true;
                                                        phi_2481_ = false;
                                                    } else {
                                                        let _e1003 = select(_e952, _e939, (_e939 < _e952));
                                                        if (select(_e965, _e1003, (_e1003 < _e965)) > 0f) {
                                                            phi_1747_ = true;
                                                        } else {
                                                            let _e1008 = select(_e952, _e939, (_e939 > _e952));
                                                            phi_1747_ = (select(_e965, _e1008, (_e1008 > _e965)) < 0f);
                                                        }
                                                        let _e1013 = phi_1747_;
                                                        if _e1013 {
                                                            phi_2476_ = type_27();
                                                            phi_2477_ = true;
                                                            phi_2478_ = false;
                                                        } else {
                                                            let _e1015 = select(_e955, _e942, (_e942 < _e955));
                                                            if (select(_e968, _e1015, (_e1015 < _e968)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1020 = select(_e955, _e942, (_e942 > _e955));
                                                                phi_1776_ = (select(_e968, _e1020, (_e1020 > _e968)) < 0f);
                                                            }
                                                            let _e1025 = phi_1776_;
                                                            if _e1025 {
                                                                phi_2474_ = type_27();
                                                                phi_2475_ = false;
                                                            } else {
                                                                let _e1027 = select(_e928[1][0], _e928[0][0], (_e928[0][0] < _e928[1][0]));
                                                                let _e1031 = select(_e928[1][0], _e928[0][0], (_e928[0][0] > _e928[1][0]));
                                                                let _e1035 = select(_e928[1][1], _e928[0][1], (_e928[0][1] < _e928[1][1]));
                                                                let _e1039 = select(_e928[1][1], _e928[0][1], (_e928[0][1] > _e928[1][1]));
                                                                let _e1043 = select(_e928[1][2], _e928[0][2], (_e928[0][2] < _e928[1][2]));
                                                                let _e1047 = select(_e928[1][2], _e928[0][2], (_e928[0][2] > _e928[1][2]));
                                                                let _e1052 = ((select(_e928[2][0], _e1027, (_e1027 < _e928[2][0])) - _e496) * _e501);
                                                                let _e1053 = ((select(_e928[2][0], _e1031, (_e1031 > _e928[2][0])) - _e497) * _e501);
                                                                let _e1056 = ((select(_e928[2][1], _e1035, (_e1035 < _e928[2][1])) - _e562) * _e567);
                                                                let _e1057 = ((select(_e928[2][1], _e1039, (_e1039 > _e928[2][1])) - _e563) * _e567);
                                                                let _e1060 = ((select(_e928[2][2], _e1043, (_e1043 < _e928[2][2])) - _e628) * _e633);
                                                                let _e1061 = ((select(_e928[2][2], _e1047, (_e1047 > _e928[2][2])) - _e629) * _e633);
                                                                let _e1063 = select(_e1061, _e1060, (_e1060 < _e1061));
                                                                let _e1065 = select(_e1061, _e1060, (_e1060 > _e1061));
                                                                let _e1067 = select(_e1053, _e1052, (_e1052 < _e1053));
                                                                let _e1069 = select(_e1057, _e1056, (_e1056 < _e1057));
                                                                let _e1071 = select(_e1069, _e1067, (_e1067 > _e1069));
                                                                let _e1073 = select(_e1063, _e1071, (_e1071 > _e1063));
                                                                let _e1075 = select(_e1053, _e1052, (_e1052 > _e1053));
                                                                let _e1077 = select(_e1057, _e1056, (_e1056 > _e1057));
                                                                let _e1079 = select(_e1077, _e1075, (_e1075 < _e1077));
                                                                let _e1081 = select(_e1065, _e1079, (_e1079 < _e1065));
                                                                let _e1082 = -(_e1063);
                                                                let _e1088 = select(_e744, _e1073, (_e1073 > _e744));
                                                                if (_e1088 > (_e1081 + (select(_e1082, _e1065, (_e1065 > _e1082)) * 0.0000019073523f))) {
                                                                    phi_2469_ = type_27();
                                                                    phi_2470_ = true;
                                                                } else {
                                                                    let _e1090 = (_e1088 > _e832.member_1);
                                                                    if _e1090 {
                                                                        phi_2468_ = type_27();
                                                                    } else {
                                                                        let _e1091 = vec3<f32>(_e928[0][0], _e928[0][1], _e928[0][2]);
                                                                        let _e1092 = vec3<f32>(_e928[1][0], _e928[1][1], _e928[1][2]);
                                                                        let _e1093 = vec3<f32>(_e928[2][0], _e928[2][1], _e928[2][2]);
                                                                        let _e1094 = (_e928[1][0] - _e928[0][0]);
                                                                        let _e1095 = (_e928[1][1] - _e928[0][1]);
                                                                        let _e1096 = (_e928[1][2] - _e928[0][2]);
                                                                        let _e1097 = vec3<f32>(_e1094, _e1095, _e1096);
                                                                        let _e1098 = (_e928[2][0] - _e928[1][0]);
                                                                        let _e1099 = (_e928[2][1] - _e928[1][1]);
                                                                        let _e1100 = (_e928[2][2] - _e928[1][2]);
                                                                        let _e1101 = vec3<f32>(_e1098, _e1099, _e1100);
                                                                        let _e1102 = (_e928[0][0] - _e928[2][0]);
                                                                        let _e1103 = (_e928[0][1] - _e928[2][1]);
                                                                        let _e1104 = (_e928[0][2] - _e928[2][2]);
                                                                        let _e1105 = vec3<f32>(_e1102, _e1103, _e1104);
                                                                        let _e1108 = bitcast<f32>((bitcast<u32>(_e1094) & 2147483647u));
                                                                        let _e1111 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                        let _e1113 = select(_e1111, _e1108, (_e1108 > _e1111));
                                                                        let _e1116 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                        let _e1118 = select(_e1116, _e1113, (_e1113 > _e1116));
                                                                        let _e1121 = bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u));
                                                                        let _e1124 = bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u));
                                                                        let _e1126 = select(_e1124, _e1121, (_e1121 > _e1124));
                                                                        let _e1129 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                        let _e1131 = select(_e1129, _e1126, (_e1126 > _e1129));
                                                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u));
                                                                        let _e1137 = bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u));
                                                                        let _e1139 = select(_e1137, _e1134, (_e1134 > _e1137));
                                                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u));
                                                                        let _e1144 = select(_e1142, _e1139, (_e1139 > _e1142));
                                                                        let _e1146 = select(_e1131, _e1118, (_e1118 > _e1131));
                                                                        let _e1148 = select(_e1144, _e1146, (_e1146 > _e1144));
                                                                        if (_e1118 == _e1148) {
                                                                            phi_2195_ = _e955;
                                                                            phi_2196_ = _e952;
                                                                            phi_2197_ = _e942;
                                                                            phi_2198_ = _e939;
                                                                            phi_2199_ = _e1091;
                                                                            phi_2200_ = _e1105;
                                                                            phi_2201_ = _e1101;
                                                                            phi_2202_ = _e1097;
                                                                        } else {
                                                                            let _e1150 = (_e1131 == _e1148);
                                                                            let _e1155 = vec3(_e1150);
                                                                            phi_2195_ = select(_e942, _e968, _e1150);
                                                                            phi_2196_ = select(_e939, _e965, _e1150);
                                                                            phi_2197_ = select(_e968, _e955, _e1150);
                                                                            phi_2198_ = select(_e965, _e952, _e1150);
                                                                            phi_2199_ = select(_e1093, _e1092, _e1155);
                                                                            phi_2200_ = select(_e1101, _e1097, _e1155);
                                                                            phi_2201_ = select(_e1097, _e1105, _e1155);
                                                                            phi_2202_ = select(_e1105, _e1101, _e1155);
                                                                        }
                                                                        let _e1161 = phi_2195_;
                                                                        let _e1163 = phi_2196_;
                                                                        let _e1165 = phi_2197_;
                                                                        let _e1167 = phi_2198_;
                                                                        let _e1169 = phi_2199_;
                                                                        let _e1171 = phi_2200_;
                                                                        let _e1173 = phi_2201_;
                                                                        let _e1175 = phi_2202_;
                                                                        let _e1182 = ((_e1173.y * _e1171.z) - (_e1171.y * _e1173.z));
                                                                        let _e1187 = ((_e1173.z * _e1171.x) - (_e1171.z * _e1173.x));
                                                                        let _e1190 = ((_e1173.x * _e1171.y) - (_e1171.x * _e1173.y));
                                                                        if (_e990 >= _e994) {
                                                                            phi_2239_ = select(true, false, (_e990 >= _e998));
                                                                        } else {
                                                                            phi_2239_ = true;
                                                                        }
                                                                        let _e1195 = phi_2239_;
                                                                        if _e1195 {
                                                                            phi_2248_ = select(_e1093, _e1092, vec3((_e994 >= _e998)));
                                                                        } else {
                                                                            phi_2248_ = _e1091;
                                                                        }
                                                                        let _e1200 = phi_2248_;
                                                                        let _e1211 = (((_e1182 * (_e1200.x - _e458)) + (_e1187 * (_e1200.y - _e525))) + (_e1190 * (_e1200.z - _e591)));
                                                                        let _e1216 = (((_e1182 * _e498) + (_e1187 * _e564)) + (_e1190 * _e630));
                                                                        let _e1217 = (_e1163 - _e1167);
                                                                        let _e1218 = (_e1161 - _e1165);
                                                                        let _e1226 = (-(((_e1167 * _e1217) + (_e1165 * _e1218))) / ((_e1217 * _e1217) + (_e1218 * _e1218)));
                                                                        let _e1228 = select(1f, _e1226, (_e1226 < 1f));
                                                                        let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                                        let _e1243 = ((_e1169.x + (_e1175.x * _e1230)) - _e458);
                                                                        let _e1244 = ((_e1169.y + (_e1175.y * _e1230)) - _e525);
                                                                        let _e1245 = ((_e1169.z + (_e1175.z * _e1230)) - _e591);
                                                                        let _e1246 = (_e1245 / _e630);
                                                                        let _e1258 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                                        let _e1261 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                        let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                        let _e1266 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                        let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                        let _e1274 = bitcast<f32>((bitcast<u32>(_e1182) & 2147483647u));
                                                                        let _e1277 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                                        let _e1279 = select(_e1277, _e1274, (_e1274 > _e1277));
                                                                        let _e1282 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1182 * _e1243) + (_e1187 * _e1244)) + (_e1190 * _e1245)) - _e1211)) & 2147483647u)) <= ((0.0000009536743f * select(_e1148, _e1268, (_e1268 > _e1148))) * select(_e1282, _e1279, (_e1279 > _e1282)))) {
                                                                            let _e1292 = bitcast<f32>((bitcast<u32>(_e1173.x) & 2147483647u));
                                                                            let _e1295 = bitcast<f32>((bitcast<u32>(_e1173.y) & 2147483647u));
                                                                            let _e1297 = select(_e1295, _e1292, (_e1292 > _e1295));
                                                                            let _e1300 = bitcast<f32>((bitcast<u32>(_e1173.z) & 2147483647u));
                                                                            let _e1306 = bitcast<f32>((bitcast<u32>(_e1171.x) & 2147483647u));
                                                                            let _e1309 = bitcast<f32>((bitcast<u32>(_e1171.y) & 2147483647u));
                                                                            let _e1311 = select(_e1309, _e1306, (_e1306 > _e1309));
                                                                            let _e1314 = bitcast<f32>((bitcast<u32>(_e1171.z) & 2147483647u));
                                                                            let _e1318 = (bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u)) > ((0.0000038146973f * select(_e1300, _e1297, (_e1297 > _e1300))) * select(_e1314, _e1311, (_e1311 > _e1314))));
                                                                            if _e1318 {
                                                                                phi_2413_ = (_e1211 / _e1216);
                                                                            } else {
                                                                                phi_2413_ = f32();
                                                                            }
                                                                            let _e1321 = phi_2413_;
                                                                            phi_2415_ = _e1321;
                                                                            phi_2416_ = select(true, false, _e1318);
                                                                        } else {
                                                                            phi_2415_ = f32();
                                                                            phi_2416_ = true;
                                                                        }
                                                                        let _e1324 = phi_2415_;
                                                                        let _e1326 = phi_2416_;
                                                                        if _e1326 {
                                                                            let _e1334 = (((_e1182 * (_e1243 - (_e498 * _e1246))) + (_e1187 * (_e1244 - (_e564 * _e1246)))) / _e1216);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u)) <= _e1148) {
                                                                                phi_2436_ = (_e1246 + _e1334);
                                                                            } else {
                                                                                phi_2436_ = _e1246;
                                                                            }
                                                                            let _e1341 = phi_2436_;
                                                                            phi_2437_ = _e1341;
                                                                        } else {
                                                                            phi_2437_ = _e1324;
                                                                        }
                                                                        let _e1343 = phi_2437_;
                                                                        let _e1345 = select(_e1081, _e1343, (_e1343 < _e1081));
                                                                        let _e1347 = select(_e1073, _e1345, (_e1345 > _e1073));
                                                                        if (_e1347 >= _e744) {
                                                                            let _e1349 = (_e1347 <= _e832.member_1);
                                                                            if _e1349 {
                                                                                let _e1350 = (1f / _e1000);
                                                                                phi_2460_ = type_27(_e1347, (_e994 * _e1350), (_e998 * _e1350), _e861);
                                                                            } else {
                                                                                phi_2460_ = type_27();
                                                                            }
                                                                            let _e1355 = phi_2460_;
                                                                            phi_2462_ = _e1355;
                                                                            phi_2463_ = select(true, false, _e1349);
                                                                        } else {
                                                                            phi_2462_ = type_27();
                                                                            phi_2463_ = true;
                                                                        }
                                                                        let _e1358 = phi_2462_;
                                                                        let _e1360 = phi_2463_;
                                                                        if _e1360 {
                                                                            phi_2467_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2467_ = _e1358;
                                                                        }
                                                                        let _e1362 = phi_2467_;
                                                                        phi_2468_ = _e1362;
                                                                    }
                                                                    let _e1364 = phi_2468_;
                                                                    phi_2469_ = _e1364;
                                                                    phi_2470_ = _e1090;
                                                                }
                                                                let _e1366 = phi_2469_;
                                                                let _e1368 = phi_2470_;
                                                                phi_2474_ = _e1366;
                                                                phi_2475_ = _e1368;
                                                            }
                                                            let _e1370 = phi_2474_;
                                                            let _e1372 = phi_2475_;
                                                            phi_2476_ = _e1370;
                                                            phi_2477_ = _e1025;
                                                            phi_2478_ = _e1372;
                                                        }
                                                        let _e1374 = phi_2476_;
                                                        let _e1376 = phi_2477_;
                                                        let _e1378 = phi_2478_;
                                                        phi_2479_ = _e1374;
                                                        phi_2480_ = _e1376;
                                                        phi_2481_ = _e1378;
                                                    }
                                                    let _e1380 = phi_2479_;
                                                    let _e1382 = phi_2480_;
                                                    let _e1384 = phi_2481_;
                                                    phi_2489_ = _e1380;
                                                    phi_2490_ = select(_e1384, true, _e1382);
                                                } else {
                                                    phi_2489_ = type_27();
                                                    phi_2490_ = true;
                                                }
                                                let _e1387 = phi_2489_;
                                                let _e1389 = phi_2490_;
                                                if _e1389 {
                                                    phi_2494_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2494_ = _e1387;
                                                }
                                                let _e1391 = phi_2494_;
                                                if (_e1391.member_3 != 4294967295u) {
                                                    if (_e861 == _e157) {
                                                        phi_2829_ = false;
                                                    } else {
                                                        let _e1395 = (_e861 < arrayLength((&global_5.member)));
                                                        if _e1395 {
                                                            if _e1395 {
                                                            } else {
                                                                phi_4159_ = true;
                                                                break;
                                                            }
                                                            let _e1397 = global_5.member[_e861];
                                                            phi_2517_ = _e1397;
                                                        } else {
                                                            phi_2517_ = 4294967295u;
                                                        }
                                                        let _e1399 = phi_2517_;
                                                        let _e1400 = (_e1399 < arrayLength((&global_6.member)));
                                                        if _e1400 {
                                                            if _e1400 {
                                                            } else {
                                                                phi_4159_ = true;
                                                                break;
                                                            }
                                                            let _e1402 = global_6.member[_e1399];
                                                            phi_2531_ = _e1402;
                                                        } else {
                                                            phi_2531_ = 0i;
                                                        }
                                                        let _e1404 = phi_2531_;
                                                        let _e1405 = (_e1404 == 0i);
                                                        if _e1405 {
                                                            phi_2828_ = true;
                                                        } else {
                                                            if _e435 {
                                                                phi_2554_ = vec3<f32>(_e928[0][0], _e928[0][1], _e928[0][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2553_ = vec3<f32>(_e928[0][2], _e928[0][0], _e928[0][1]);
                                                                } else {
                                                                    phi_2553_ = vec3<f32>(_e928[0][1], _e928[0][2], _e928[0][0]);
                                                                }
                                                                let _e1410 = phi_2553_;
                                                                phi_2554_ = _e1410;
                                                            }
                                                            let _e1413 = phi_2554_;
                                                            if _e435 {
                                                                phi_2573_ = vec3<f32>(_e928[1][0], _e928[1][1], _e928[1][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2572_ = vec3<f32>(_e928[1][2], _e928[1][0], _e928[1][1]);
                                                                } else {
                                                                    phi_2572_ = vec3<f32>(_e928[1][1], _e928[1][2], _e928[1][0]);
                                                                }
                                                                let _e1418 = phi_2572_;
                                                                phi_2573_ = _e1418;
                                                            }
                                                            let _e1421 = phi_2573_;
                                                            if _e435 {
                                                                phi_2592_ = vec3<f32>(_e928[2][0], _e928[2][1], _e928[2][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2591_ = vec3<f32>(_e928[2][2], _e928[2][0], _e928[2][1]);
                                                                } else {
                                                                    phi_2591_ = vec3<f32>(_e928[2][1], _e928[2][2], _e928[2][0]);
                                                                }
                                                                let _e1426 = phi_2591_;
                                                                phi_2592_ = _e1426;
                                                            }
                                                            let _e1429 = phi_2592_;
                                                            let _e1432 = (_e1421.x - _e1413.x);
                                                            let _e1435 = (_e1421.y - _e1413.y);
                                                            let _e1438 = (_e1421.z - _e1413.z);
                                                            let _e1440 = (_e1429.x - _e1413.x);
                                                            let _e1442 = (_e1429.y - _e1413.y);
                                                            let _e1444 = (_e1429.z - _e1413.z);
                                                            if (_e289.member_1 == 1u) {
                                                                phi_2628_ = (vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]) - _e1413);
                                                            } else {
                                                                phi_2628_ = vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]);
                                                            }
                                                            let _e1459 = phi_2628_;
                                                            let _e1465 = bitcast<f32>((bitcast<u32>((_e1432 * _e1442)) ^ _e289.member_3[0]));
                                                            let _e1469 = bitcast<f32>((bitcast<u32>((_e1435 * _e1440)) ^ _e289.member_3[0]));
                                                            let _e1473 = bitcast<f32>((bitcast<u32>((_e1435 * _e1444)) ^ _e289.member_3[0]));
                                                            let _e1477 = bitcast<f32>((bitcast<u32>((_e1438 * _e1442)) ^ _e289.member_3[0]));
                                                            let _e1481 = bitcast<f32>((bitcast<u32>((_e1438 * _e1440)) ^ _e289.member_3[0]));
                                                            let _e1485 = bitcast<f32>((bitcast<u32>((_e1432 * _e1444)) ^ _e289.member_3[0]));
                                                            let _e1486 = (_e1473 - _e1477);
                                                            let _e1487 = (_e1481 - _e1485);
                                                            let _e1488 = (_e1465 - _e1469);
                                                            let _e1512 = (bitcast<f32>((bitcast<u32>(_e1473) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u)));
                                                            let _e1519 = (bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u)));
                                                            let _e1526 = (bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u)));
                                                            if (_e289.member_2 == 0f) {
                                                                phi_2810_ = 0f;
                                                            } else {
                                                                let _e1556 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                let _e1559 = bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u));
                                                                let _e1562 = bitcast<f32>((bitcast<u32>(_e1488) & 2147483647u));
                                                                let _e1564 = select(_e1562, _e1559, (_e1559 > _e1562));
                                                                let _e1568 = select(_e1562, _e1559, (_e1559 < _e1562));
                                                                let _e1572 = select(_e1559, _e1556, (_e1556 < _e1559));
                                                                let _e1574 = select(_e1559, _e1556, (_e1556 > _e1559));
                                                                let _e1576 = select(_e1562, _e1574, (_e1574 < _e1562));
                                                                phi_2810_ = bitcast<f32>((bitcast<u32>((_e289.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1564, _e1556, (_e1556 > _e1564)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1576, _e1572, (_e1572 > _e1576)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1568, _e1556, (_e1556 < _e1568)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1512 + _e1519) + _e1526))) ^ _e289.member_3[0]))) * 1.0000005f)) ^ _e289.member_3[0])))) ^ _e289.member_3[0]));
                                                            }
                                                            let _e1603 = phi_2810_;
                                                            phi_2828_ = (_e1405 || !(((((bitcast<f32>((bitcast<u32>((_e1459.x * _e1486)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1459.y * _e1487)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1459.z * _e1488)) ^ _e289.member_3[0]))) * f32(-(_e1404))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1459.x) & 2147483647u)) * _e1512)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1459.y) & 2147483647u)) * _e1519)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1459.z) & 2147483647u)) * _e1526)) ^ _e289.member_3[0]))))) ^ _e289.member_3[0])) + _e1603) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1617 = phi_2828_;
                                                        phi_2829_ = _e1617;
                                                    }
                                                    let _e1619 = phi_2829_;
                                                    if _e1619 {
                                                        if (_e1391.member < _e832.member.member) {
                                                            phi_2849_ = true;
                                                        } else {
                                                            if (_e1391.member == _e832.member.member) {
                                                                phi_2848_ = (_e1391.member_3 < _e832.member.member_3);
                                                            } else {
                                                                phi_2848_ = false;
                                                            }
                                                            let _e1629 = phi_2848_;
                                                            phi_2849_ = _e1629;
                                                        }
                                                        let _e1631 = phi_2849_;
                                                        if _e1631 {
                                                            phi_2855_ = type_43(_e1391, _e1391.member);
                                                        } else {
                                                            phi_2855_ = _e832;
                                                        }
                                                        let _e1634 = phi_2855_;
                                                        phi_2856_ = _e1634;
                                                    } else {
                                                        phi_2856_ = _e832;
                                                    }
                                                    let _e1636 = phi_2856_;
                                                    phi_2857_ = _e1636;
                                                } else {
                                                    phi_2857_ = _e832;
                                                }
                                                let _e1638 = phi_2857_;
                                                phi_1457_ = _e1638;
                                            } else {
                                                phi_1457_ = type_43();
                                            }
                                            let _e1640 = phi_1457_;
                                            continue;
                                            continuing {
                                                phi_1456_ = _e1640;
                                                phi_1459_ = _e847;
                                                phi_4159_ = _e776;
                                                break if !(_e853);
                                            }
                                        }
                                        let _e1643 = phi_4159_;
                                        phi_4351_ = _e1643;
                                        if _e1643 {
                                            break;
                                        }
                                        phi_4410_ = _e1643;
                                        let _e2326 = local_11;
                                        phi_2858_ = _e2326;
                                    } else {
                                        phi_4410_ = _e776;
                                        phi_2858_ = _e778;
                                    }
                                    let _e1645 = phi_4410_;
                                    let _e1647 = phi_2858_;
                                    if _e825 {
                                        phi_3865_ = bool();
                                        phi_3866_ = u32();
                                        phi_3867_ = type_61();
                                    } else {
                                        let _e1648 = (_e821.member_1 < _e98);
                                        if _e1648 {
                                            if _e1648 {
                                            } else {
                                                phi_4351_ = true;
                                                break;
                                            }
                                            let _e1650 = global_10.member[_e821.member_1];
                                            phi_2879_ = _e1650;
                                        } else {
                                            phi_2879_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1652 = phi_2879_;
                                        let _e1667 = ((10u * _e411) & 31u);
                                        let _e1670 = ((_e1652.member[0] >> bitcast<u32>(_e1667)) & 1023u);
                                        let _e1678 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[0] - _e821.member.member[0]) * 0.0009775171f)) ^ _e140));
                                        let _e1683 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1670)) - 8388608f) * _e1678)) ^ _e140)));
                                        let _e1687 = select(select(_e821.member.member_1[0], _e1683, (_e1683 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e1670 == 1023u));
                                        let _e1689 = ((10u * _e410) & 31u);
                                        let _e1692 = ((_e1652.member[0] >> bitcast<u32>(_e1689)) & 1023u);
                                        let _e1700 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[1] - _e821.member.member[1]) * 0.0009775171f)) ^ _e140));
                                        let _e1705 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1692)) - 8388608f) * _e1700)) ^ _e140)));
                                        let _e1709 = select(select(_e821.member.member_1[1], _e1705, (_e1705 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e1692 == 1023u));
                                        let _e1711 = ((10u * _e412) & 31u);
                                        let _e1714 = ((_e1652.member[0] >> bitcast<u32>(_e1711)) & 1023u);
                                        let _e1722 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[2] - _e821.member.member[2]) * 0.0009775171f)) ^ _e140));
                                        let _e1727 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1714)) - 8388608f) * _e1722)) ^ _e140)));
                                        let _e1731 = select(select(_e821.member.member_1[2], _e1727, (_e1727 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e1714 == 1023u));
                                        let _e1734 = ((_e1652.member[1] >> bitcast<u32>(_e1667)) & 1023u);
                                        let _e1742 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1734)) - 8388608f) * _e1678)) ^ _e140)));
                                        let _e1746 = select(select(_e821.member.member_1[0], _e1742, (_e1742 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e1734 == 1023u));
                                        let _e1749 = ((_e1652.member[1] >> bitcast<u32>(_e1689)) & 1023u);
                                        let _e1757 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1749)) - 8388608f) * _e1700)) ^ _e140)));
                                        let _e1761 = select(select(_e821.member.member_1[1], _e1757, (_e1757 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e1749 == 1023u));
                                        let _e1764 = ((_e1652.member[1] >> bitcast<u32>(_e1711)) & 1023u);
                                        let _e1772 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1764)) - 8388608f) * _e1722)) ^ _e140)));
                                        let _e1776 = select(select(_e821.member.member_1[2], _e1772, (_e1772 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e1764 == 1023u));
                                        let _e1782 = ((_e1652.member_1[0] >> bitcast<u32>(_e1667)) & 1023u);
                                        let _e1790 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1782)) - 8388608f) * _e1678)) ^ _e140)));
                                        let _e1794 = select(select(_e821.member.member_1[0], _e1790, (_e1790 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e1782 == 1023u));
                                        let _e1797 = ((_e1652.member_1[0] >> bitcast<u32>(_e1689)) & 1023u);
                                        let _e1805 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1797)) - 8388608f) * _e1700)) ^ _e140)));
                                        let _e1809 = select(select(_e821.member.member_1[1], _e1805, (_e1805 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e1797 == 1023u));
                                        let _e1812 = ((_e1652.member_1[0] >> bitcast<u32>(_e1711)) & 1023u);
                                        let _e1820 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1812)) - 8388608f) * _e1722)) ^ _e140)));
                                        let _e1824 = select(select(_e821.member.member_1[2], _e1820, (_e1820 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e1812 == 1023u));
                                        let _e1827 = ((_e1652.member_1[1] >> bitcast<u32>(_e1667)) & 1023u);
                                        let _e1835 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1827)) - 8388608f) * _e1678)) ^ _e140)));
                                        let _e1839 = select(select(_e821.member.member_1[0], _e1835, (_e1835 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e1827 == 1023u));
                                        let _e1842 = ((_e1652.member_1[1] >> bitcast<u32>(_e1689)) & 1023u);
                                        let _e1850 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1842)) - 8388608f) * _e1700)) ^ _e140)));
                                        let _e1854 = select(select(_e821.member.member_1[1], _e1850, (_e1850 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e1842 == 1023u));
                                        let _e1857 = ((_e1652.member_1[1] >> bitcast<u32>(_e1711)) & 1023u);
                                        let _e1865 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1857)) - 8388608f) * _e1722)) ^ _e140)));
                                        let _e1869 = select(select(_e821.member.member_1[2], _e1865, (_e1865 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e1857 == 1023u));
                                        let _e1874 = type_61(type_59(array<f32, 3>(_e1687, _e1709, _e1731), array<f32, 3>(_e1746, _e1761, _e1776)), _e1652.member_2);
                                        let _e1879 = type_61(type_59(array<f32, 3>(_e1794, _e1809, _e1824), array<f32, 3>(_e1839, _e1854, _e1869)), _e1652.member_3);
                                        let _e1885 = ((_e1687 - _e496) * _e501);
                                        let _e1886 = ((_e1794 - _e496) * _e501);
                                        let _e1887 = ((_e1746 - _e497) * _e501);
                                        let _e1888 = ((_e1839 - _e497) * _e501);
                                        let _e1893 = ((_e1709 - _e562) * _e567);
                                        let _e1894 = ((_e1809 - _e562) * _e567);
                                        let _e1895 = ((_e1761 - _e563) * _e567);
                                        let _e1896 = ((_e1854 - _e563) * _e567);
                                        let _e1901 = ((_e1731 - _e628) * _e633);
                                        let _e1902 = ((_e1824 - _e628) * _e633);
                                        let _e1903 = ((_e1776 - _e629) * _e633);
                                        let _e1904 = ((_e1869 - _e629) * _e633);
                                        let _e1906 = select(_e1903, _e1901, (_e1901 < _e1903));
                                        let _e1908 = select(_e1904, _e1902, (_e1902 < _e1904));
                                        let _e1910 = select(_e1903, _e1901, (_e1901 > _e1903));
                                        let _e1912 = select(_e1904, _e1902, (_e1902 > _e1904));
                                        let _e1914 = select(_e1887, _e1885, (_e1885 < _e1887));
                                        let _e1916 = select(_e1888, _e1886, (_e1886 < _e1888));
                                        let _e1918 = select(_e1895, _e1893, (_e1893 < _e1895));
                                        let _e1920 = select(_e1896, _e1894, (_e1894 < _e1896));
                                        let _e1922 = select(_e1918, _e1914, (_e1914 > _e1918));
                                        let _e1924 = select(_e1920, _e1916, (_e1916 > _e1920));
                                        let _e1926 = select(_e1906, _e1922, (_e1922 > _e1906));
                                        let _e1928 = select(_e1908, _e1924, (_e1924 > _e1908));
                                        let _e1930 = select(_e1887, _e1885, (_e1885 > _e1887));
                                        let _e1932 = select(_e1888, _e1886, (_e1886 > _e1888));
                                        let _e1934 = select(_e1895, _e1893, (_e1893 > _e1895));
                                        let _e1936 = select(_e1896, _e1894, (_e1894 > _e1896));
                                        let _e1938 = select(_e1934, _e1930, (_e1930 < _e1934));
                                        let _e1940 = select(_e1936, _e1932, (_e1932 < _e1936));
                                        let _e1945 = -(_e1906);
                                        let _e1946 = -(_e1908);
                                        let _e1953 = (select(_e1910, _e1938, (_e1938 < _e1910)) + (select(_e1945, _e1910, (_e1910 > _e1945)) * 0.0000019073523f));
                                        let _e1954 = (select(_e1912, _e1940, (_e1940 < _e1912)) + (select(_e1946, _e1912, (_e1912 > _e1946)) * 0.0000019073523f));
                                        let _e1956 = select(_e744, _e1926, (_e1926 > _e744));
                                        let _e1958 = select(_e744, _e1928, (_e1928 > _e744));
                                        let _e1963 = (_e1956 <= select(_e1647.member_1, _e1953, (_e1953 < _e1647.member_1)));
                                        let _e1964 = (_e1958 <= select(_e1647.member_1, _e1954, (_e1954 < _e1647.member_1)));
                                        let _e1965 = (_e1956 <= _e1958);
                                        if _e1963 {
                                            if _e1964 {
                                                if _e1965 {
                                                    phi_3765_ = _e1879;
                                                } else {
                                                    phi_3765_ = _e1874;
                                                }
                                                let _e1967 = phi_3765_;
                                                let _e1974 = (_e819 % 128u);
                                                let _e1975 = (_e1974 < 128u);
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_6[_e1974] = _e1967.member_1;
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_5[_e1974] = _e1967.member.member[0];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_4[_e1974] = _e1967.member.member[1];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_3[_e1974] = _e1967.member.member[2];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_2[_e1974] = _e1967.member.member_1[0];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_1[_e1974] = _e1967.member.member_1[1];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local[_e1974] = _e1967.member.member_1[2];
                                                if _e1975 {
                                                } else {
                                                    phi_4351_ = true;
                                                    break;
                                                }
                                                local_7[_e1974] = select(_e1956, _e1958, _e1965);
                                                if _e1965 {
                                                    phi_3841_ = _e1874;
                                                } else {
                                                    phi_3841_ = _e1879;
                                                }
                                                let _e1992 = phi_3841_;
                                                phi_3842_ = (_e819 + 1u);
                                                phi_3843_ = _e1992;
                                            } else {
                                                phi_3842_ = u32();
                                                phi_3843_ = type_61();
                                            }
                                            let _e1994 = phi_3842_;
                                            let _e1996 = phi_3843_;
                                            phi_3845_ = _e1994;
                                            phi_3846_ = _e1996;
                                            phi_3847_ = select(true, false, _e1964);
                                        } else {
                                            phi_3845_ = u32();
                                            phi_3846_ = type_61();
                                            phi_3847_ = true;
                                        }
                                        let _e1999 = phi_3845_;
                                        let _e2001 = phi_3846_;
                                        let _e2003 = phi_3847_;
                                        if _e2003 {
                                            if _e1963 {
                                                phi_3854_ = _e1874;
                                            } else {
                                                phi_3854_ = _e1879;
                                            }
                                            let _e2005 = phi_3854_;
                                            phi_3859_ = select(_e1964, true, _e1963);
                                            phi_3861_ = _e2005;
                                        } else {
                                            phi_3859_ = _e817;
                                            phi_3861_ = _e2001;
                                        }
                                        let _e2008 = phi_3859_;
                                        let _e2010 = phi_3861_;
                                        phi_3865_ = _e2008;
                                        phi_3866_ = select(_e1999, _e819, _e2003);
                                        phi_3867_ = _e2010;
                                    }
                                    let _e2013 = phi_3865_;
                                    let _e2015 = phi_3866_;
                                    let _e2017 = phi_3867_;
                                    if _e825 {
                                        phi_3877_ = _e821;
                                    } else {
                                        phi_3877_ = _e2017;
                                    }
                                    let _e2019 = phi_3877_;
                                    phi_4354_ = _e1645;
                                    phi_3878_ = _e1647;
                                    phi_3879_ = (_e780 - 1u);
                                    phi_3880_ = select(_e2013, false, _e825);
                                    phi_3881_ = select(_e2015, _e819, _e825);
                                    phi_3882_ = _e2019;
                                } else {
                                    phi_4354_ = _e776;
                                    phi_3878_ = _e778;
                                    phi_3879_ = _e780;
                                    phi_3880_ = _e817;
                                    phi_3881_ = _e819;
                                    phi_3882_ = _e821;
                                }
                                let _e2023 = phi_4354_;
                                let _e2025 = phi_3878_;
                                let _e2027 = phi_3879_;
                                let _e2029 = phi_3880_;
                                let _e2031 = phi_3881_;
                                let _e2033 = phi_3882_;
                                phi_4353_ = _e2023;
                                phi_3883_ = _e2025;
                                phi_3884_ = _e2027;
                                phi_3885_ = _e2029;
                                phi_3886_ = _e2031;
                                phi_3887_ = _e2033;
                            } else {
                                phi_4353_ = _e776;
                                phi_3883_ = type_43();
                                phi_3884_ = u32();
                                phi_3885_ = bool();
                                phi_3886_ = u32();
                                phi_3887_ = type_61();
                            }
                            let _e2035 = phi_4353_;
                            let _e2037 = phi_3883_;
                            let _e2039 = phi_3884_;
                            let _e2041 = phi_3885_;
                            let _e2043 = phi_3886_;
                            let _e2045 = phi_3887_;
                            phi_4352_ = _e2035;
                            phi_1331_ = _e2037;
                            phi_1334_ = _e2039;
                            phi_1336_ = _e2041;
                            phi_1338_ = _e2043;
                            phi_1340_ = _e2045;
                            phi_3888_ = _e790;
                        } else {
                            phi_4352_ = _e776;
                            phi_1331_ = type_43();
                            phi_1334_ = u32();
                            phi_1336_ = bool();
                            phi_1338_ = u32();
                            phi_1340_ = type_61();
                            phi_3888_ = false;
                        }
                        let _e2047 = phi_4352_;
                        let _e2049 = phi_1331_;
                        let _e2051 = phi_1334_;
                        let _e2053 = phi_1336_;
                        let _e2055 = phi_1338_;
                        let _e2057 = phi_1340_;
                        let _e2059 = phi_3888_;
                        continue;
                        continuing {
                            phi_4165_ = _e2047;
                            phi_1330_ = _e2049;
                            phi_1333_ = _e2051;
                            phi_1335_ = _e2053;
                            phi_1337_ = _e2055;
                            phi_1339_ = _e2057;
                            phi_4351_ = _e2047;
                            break if !(_e2059);
                        }
                    }
                    let _e2062 = phi_4351_;
                    if _e2062 {
                        break;
                    }
                    let _e2064 = local_10;
                    if (_e2064.member.member_3 != 4294967295u) {
                        let _e2069 = bitcast<u32>(_e2064.member.member);
                        let _e2073 = (bitcast<i32>((_e2069 >> bitcast<u32>(23i))) & 255i);
                        let _e2074 = (_e2073 + _e413);
                        if (_e2073 == 255i) {
                            phi_3947_ = _e2064.member.member;
                        } else {
                            if (_e2073 > 0i) {
                                if (_e2074 > 0i) {
                                    let _e2078 = (_e2074 < 255i);
                                    if _e2078 {
                                        phi_3926_ = bitcast<f32>((_e2069 + bitcast<u32>((_e413 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3926_ = f32();
                                    }
                                    let _e2085 = phi_3926_;
                                    phi_3928_ = _e2085;
                                    phi_3929_ = select(true, false, _e2078);
                                } else {
                                    phi_3928_ = f32();
                                    phi_3929_ = true;
                                }
                                let _e2088 = phi_3928_;
                                let _e2090 = phi_3929_;
                                phi_3930_ = _e2088;
                                phi_3931_ = _e2090;
                            } else {
                                phi_3930_ = f32();
                                phi_3931_ = true;
                            }
                            let _e2092 = phi_3930_;
                            let _e2094 = phi_3931_;
                            if _e2094 {
                                let _e2095 = (_e2069 & 2147483648u);
                                let _e2102 = ((_e2069 & 8388607u) | (select(0u, 1u, ((_e2069 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2106 = (_e2102 == 0u);
                                if _e2106 {
                                    phi_4129_ = bitcast<f32>(_e2095);
                                } else {
                                    let _e2111 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2102)), 32u, _e2106) - 8u);
                                    let _e2114 = (_e2102 << bitcast<u32>((_e2111 & 31u)));
                                    let _e2116 = ((_e2074 + select(0i, 1i, (_e2073 == 0i))) - bitcast<i32>(_e2111));
                                    if (_e2116 >= 255i) {
                                        phi_4119_ = bitcast<f32>((_e2095 | 2139095040u));
                                        phi_4120_ = f32();
                                        phi_4121_ = true;
                                    } else {
                                        let _e2118 = (_e2116 > 0i);
                                        if _e2118 {
                                            phi_4113_ = bitcast<f32>(((_e2095 | (bitcast<u32>(_e2116) << bitcast<u32>(23i))) | (_e2114 & 8388607u)));
                                            phi_4114_ = f32();
                                        } else {
                                            if (_e2116 < -24i) {
                                                phi_4079_ = 26u;
                                            } else {
                                                phi_4079_ = bitcast<u32>((1i - _e2116));
                                            }
                                            let _e2123 = phi_4079_;
                                            let _e2124 = (_e2123 & 31u);
                                            let _e2126 = (_e2114 >> bitcast<u32>(_e2124));
                                            let _e2130 = (_e2114 & ((1u << bitcast<u32>(_e2124)) - 1u));
                                            let _e2134 = (1u << bitcast<u32>(((_e2123 - 1u) & 31u)));
                                            if (_e2130 > _e2134) {
                                                phi_4100_ = true;
                                            } else {
                                                if (_e2130 == _e2134) {
                                                    phi_4097_ = ((_e2126 & 1u) == 1u);
                                                } else {
                                                    phi_4097_ = false;
                                                }
                                                let _e2140 = phi_4097_;
                                                phi_4100_ = _e2140;
                                            }
                                            let _e2142 = phi_4100_;
                                            phi_4113_ = f32();
                                            phi_4114_ = bitcast<f32>((_e2095 | (_e2126 + select(0u, 1u, _e2142))));
                                        }
                                        let _e2155 = phi_4113_;
                                        let _e2157 = phi_4114_;
                                        phi_4119_ = _e2155;
                                        phi_4120_ = _e2157;
                                        phi_4121_ = _e2118;
                                    }
                                    let _e2161 = phi_4119_;
                                    let _e2163 = phi_4120_;
                                    let _e2165 = phi_4121_;
                                    phi_4129_ = select(_e2163, _e2161, _e2165);
                                }
                                let _e2169 = phi_4129_;
                                phi_3946_ = _e2169;
                            } else {
                                phi_3946_ = _e2092;
                            }
                            let _e2171 = phi_3946_;
                            phi_3947_ = _e2171;
                        }
                        let _e2173 = phi_3947_;
                        let _e2174 = bitcast<u32>(_e2173);
                        if ((_e2174 & 2147483647u) >= 2139095040u) {
                            phi_3959_ = bitcast<f32>(((_e2174 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3959_ = _e2173;
                        }
                        let _e2181 = phi_3959_;
                        phi_3964_ = type_27(_e2181, _e2064.member.member_1, _e2064.member.member_2, _e2064.member.member_3);
                    } else {
                        phi_3964_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2186 = phi_3964_;
                    if _e290 {
                    } else {
                        break;
                    }
                    global_8.member[_e144] = _e2186;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e2190 = select(0u, 1u, (_e357 <= _e367));
                    if (_e2190 > 0u) {
                        let _e2192 = (1u < _e112);
                        if _e2192 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e2196 = atomicAdd((&global_9.member[0u]), _e2190);
                            if ((_e2196 + _e2190) < _e2196) {
                                if _e2192 {
                                } else {
                                    break;
                                }
                                let _e2201 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2204 = select(0u, 1u, (_e2186.member_3 != 4294967295u));
                    if (_e2204 > 0u) {
                        let _e2206 = (3u < _e112);
                        if _e2206 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e2210 = atomicAdd((&global_9.member[2u]), _e2204);
                            if ((_e2210 + _e2204) < _e2210) {
                                if _e2206 {
                                } else {
                                    break;
                                }
                                let _e2215 = atomicAdd((&global_9.member[3u]), 1u);
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
