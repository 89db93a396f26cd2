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
    var phi_4161_: bool;
    var phi_1330_: type_43;
    var phi_1333_: bool;
    var phi_1335_: u32;
    var phi_1337_: u32;
    var phi_1339_: type_61;
    var phi_1350_: bool;
    var phi_1436_: bool;
    var phi_1437_: u32;
    var phi_1438_: type_61;
    var phi_2883_: type_54;
    var phi_3769_: type_61;
    var phi_3846_: type_61;
    var phi_3847_: u32;
    var phi_3848_: type_61;
    var phi_3850_: u32;
    var phi_3851_: type_61;
    var phi_3852_: bool;
    var phi_3859_: type_61;
    var phi_3864_: bool;
    var phi_3866_: type_61;
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
    var phi_4155_: bool;
    var phi_4351_: bool;
    var phi_3870_: type_43;
    var phi_3871_: bool;
    var phi_3872_: u32;
    var phi_3873_: type_61;
    var phi_4350_: bool;
    var phi_3874_: type_43;
    var phi_3875_: bool;
    var phi_3876_: u32;
    var phi_3877_: u32;
    var phi_3878_: type_61;
    var phi_4349_: bool;
    var phi_3879_: type_43;
    var phi_3880_: bool;
    var phi_3881_: u32;
    var phi_3882_: u32;
    var phi_3883_: type_61;
    var phi_4348_: bool;
    var phi_1331_: type_43;
    var phi_1334_: bool;
    var phi_1336_: u32;
    var phi_1338_: u32;
    var phi_1340_: type_61;
    var phi_3884_: bool;
    var phi_4347_: bool;
    var local_10: type_43;
    var phi_3922_: f32;
    var phi_3924_: f32;
    var phi_3925_: bool;
    var phi_3926_: f32;
    var phi_3927_: bool;
    var phi_4075_: u32;
    var phi_4093_: bool;
    var phi_4096_: bool;
    var phi_4109_: f32;
    var phi_4110_: f32;
    var phi_4115_: f32;
    var phi_4116_: f32;
    var phi_4117_: bool;
    var phi_4125_: f32;
    var phi_3942_: f32;
    var phi_3943_: f32;
    var phi_3955_: f32;
    var phi_3960_: type_27;
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
                    phi_4161_ = false;
                    phi_1330_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e742);
                    phi_1333_ = (_e744 <= _e742);
                    phi_1335_ = ((3u * _e98) + 1u);
                    phi_1337_ = 0u;
                    phi_1339_ = type_61(type_59(array<f32, 3>(_e752, _e756, _e760), array<f32, 3>(_e764, _e766, _e768)), select(0u, 2147483648u, (_e98 == 0u)));
                    loop {
                        let _e776 = phi_4161_;
                        let _e778 = phi_1330_;
                        let _e780 = phi_1333_;
                        let _e782 = phi_1335_;
                        let _e784 = phi_1337_;
                        let _e786 = phi_1339_;
                        local_10 = _e778;
                        if _e780 {
                            phi_1350_ = true;
                        } else {
                            phi_1350_ = (_e784 > 0u);
                        }
                        let _e789 = phi_1350_;
                        if _e789 {
                            let _e790 = (_e782 > 0u);
                            if _e790 {
                                if _e780 {
                                    phi_1436_ = _e780;
                                    phi_1437_ = _e784;
                                    phi_1438_ = _e786;
                                } else {
                                    let _e791 = (_e784 - 1u);
                                    let _e792 = (_e791 % 128u);
                                    let _e793 = (_e792 < 128u);
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e795 = local_6[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e797 = local_5[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e799 = local_4[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e801 = local_3[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e804 = local_2[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e806 = local_1[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
                                        break;
                                    }
                                    let _e808 = local[_e792];
                                    if _e793 {
                                    } else {
                                        phi_4347_ = true;
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
                                    if ((_e821.member_1 & 2147483648u) != 0u) {
                                        phi_1456_ = _e778;
                                        phi_1459_ = type_8(0u, ((_e821.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1197 = phi_1456_;
                                            let _e1199 = phi_1459_;
                                            local_11 = _e1197;
                                            if (_e1199.member < _e1199.member_1) {
                                                phi_1460_ = type_8((_e1199.member + 1u), _e1199.member_1);
                                                phi_1482_ = type_8(1u, _e1199.member);
                                            } else {
                                                phi_1460_ = _e1199;
                                                phi_1482_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1212 = phi_1460_;
                                            let _e1214 = phi_1482_;
                                            let _e1218 = (bitcast<i32>(_e1214.member) != 0i);
                                            if _e1218 {
                                                let _e1219 = ((_e821.member_1 & 268435455u) + _e1214.member_1);
                                                let _e1220 = (_e1219 < _e100);
                                                if _e1220 {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1224 = global_4.member[_e1219].member_1;
                                                    phi_1503_ = _e1224;
                                                } else {
                                                    phi_1503_ = 4294967295u;
                                                }
                                                let _e1226 = phi_1503_;
                                                if (_e1219 >= _e100) {
                                                    phi_1595_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1220 {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    if (_e749 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1233 = global_4.member[_e1219].member[_e749];
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1239 = global_4.member[_e1219].member[_e753];
                                                    if (_e757 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1245 = global_4.member[_e1219].member[_e757];
                                                    let _e1247 = (3u + _e749);
                                                    if (_e1247 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1253 = global_4.member[_e1219].member[_e1247];
                                                    let _e1254 = (3u + _e753);
                                                    if (_e1254 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1260 = global_4.member[_e1219].member[_e1254];
                                                    let _e1261 = (3u + _e757);
                                                    if (_e1261 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1267 = global_4.member[_e1219].member[_e1261];
                                                    let _e1269 = (6u + _e749);
                                                    if (_e1269 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1275 = global_4.member[_e1219].member[_e1269];
                                                    let _e1276 = (6u + _e753);
                                                    if (_e1276 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1282 = global_4.member[_e1219].member[_e1276];
                                                    let _e1283 = (6u + _e757);
                                                    if (_e1283 < 9u) {
                                                    } else {
                                                        phi_4155_ = true;
                                                        break;
                                                    }
                                                    let _e1289 = global_4.member[_e1219].member[_e1283];
                                                    phi_1595_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1233, _e1239, _e1245), array<f32, 3>(_e1253, _e1260, _e1267), array<f32, 3>(_e1275, _e1282, _e1289));
                                                }
                                                let _e1293 = phi_1595_;
                                                let _e1301 = (_e1293[0][2] - _e591);
                                                let _e1304 = (((_e1293[0][0] - _e458) * _e630) - (_e1301 * _e498));
                                                let _e1307 = (((_e1293[0][1] - _e525) * _e630) - (_e1301 * _e564));
                                                let _e1314 = (_e1293[1][2] - _e591);
                                                let _e1317 = (((_e1293[1][0] - _e458) * _e630) - (_e1314 * _e498));
                                                let _e1320 = (((_e1293[1][1] - _e525) * _e630) - (_e1314 * _e564));
                                                let _e1327 = (_e1293[2][2] - _e591);
                                                let _e1330 = (((_e1293[2][0] - _e458) * _e630) - (_e1327 * _e498));
                                                let _e1333 = (((_e1293[2][1] - _e525) * _e630) - (_e1327 * _e564));
                                                let _e1334 = (_e1330 * _e1320);
                                                let _e1335 = (_e1333 * _e1317);
                                                let _e1336 = (_e1304 * _e1333);
                                                let _e1337 = (_e1307 * _e1330);
                                                let _e1338 = (_e1317 * _e1307);
                                                let _e1339 = (_e1320 * _e1304);
                                                let _e1344 = (((_e1334 >= _e1335) && (_e1336 >= _e1337)) && (_e1338 >= _e1339));
                                                if (_e1344 || (((_e1334 <= _e1335) && (_e1336 <= _e1337)) && (_e1338 <= _e1339))) {
                                                    let _e1351 = select(-1f, 1f, _e1344);
                                                    let _e1353 = ((_e1334 - _e1335) * _e1351);
                                                    let _e1355 = select(0f, _e1353, (_e1353 > 0f));
                                                    let _e1357 = ((_e1336 - _e1337) * _e1351);
                                                    let _e1359 = select(0f, _e1357, (_e1357 > 0f));
                                                    let _e1361 = ((_e1338 - _e1339) * _e1351);
                                                    let _e1363 = select(0f, _e1361, (_e1361 > 0f));
                                                    let _e1365 = ((_e1355 + _e1359) + _e1363);
                                                    if (_e1365 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2479_ = type_27();
                                                        phi_2480_ = true;
                                                        phi_2481_ = false;
                                                    } else {
                                                        let _e1368 = select(_e1317, _e1304, (_e1304 < _e1317));
                                                        if (select(_e1330, _e1368, (_e1368 < _e1330)) > 0f) {
                                                            phi_1747_ = true;
                                                        } else {
                                                            let _e1373 = select(_e1317, _e1304, (_e1304 > _e1317));
                                                            phi_1747_ = (select(_e1330, _e1373, (_e1373 > _e1330)) < 0f);
                                                        }
                                                        let _e1378 = phi_1747_;
                                                        if _e1378 {
                                                            phi_2476_ = type_27();
                                                            phi_2477_ = true;
                                                            phi_2478_ = false;
                                                        } else {
                                                            let _e1380 = select(_e1320, _e1307, (_e1307 < _e1320));
                                                            if (select(_e1333, _e1380, (_e1380 < _e1333)) > 0f) {
                                                                phi_1776_ = true;
                                                            } else {
                                                                let _e1385 = select(_e1320, _e1307, (_e1307 > _e1320));
                                                                phi_1776_ = (select(_e1333, _e1385, (_e1385 > _e1333)) < 0f);
                                                            }
                                                            let _e1390 = phi_1776_;
                                                            if _e1390 {
                                                                phi_2474_ = type_27();
                                                                phi_2475_ = false;
                                                            } else {
                                                                let _e1392 = select(_e1293[1][0], _e1293[0][0], (_e1293[0][0] < _e1293[1][0]));
                                                                let _e1396 = select(_e1293[1][0], _e1293[0][0], (_e1293[0][0] > _e1293[1][0]));
                                                                let _e1400 = select(_e1293[1][1], _e1293[0][1], (_e1293[0][1] < _e1293[1][1]));
                                                                let _e1404 = select(_e1293[1][1], _e1293[0][1], (_e1293[0][1] > _e1293[1][1]));
                                                                let _e1408 = select(_e1293[1][2], _e1293[0][2], (_e1293[0][2] < _e1293[1][2]));
                                                                let _e1412 = select(_e1293[1][2], _e1293[0][2], (_e1293[0][2] > _e1293[1][2]));
                                                                let _e1417 = ((select(_e1293[2][0], _e1392, (_e1392 < _e1293[2][0])) - _e496) * _e501);
                                                                let _e1418 = ((select(_e1293[2][0], _e1396, (_e1396 > _e1293[2][0])) - _e497) * _e501);
                                                                let _e1421 = ((select(_e1293[2][1], _e1400, (_e1400 < _e1293[2][1])) - _e562) * _e567);
                                                                let _e1422 = ((select(_e1293[2][1], _e1404, (_e1404 > _e1293[2][1])) - _e563) * _e567);
                                                                let _e1425 = ((select(_e1293[2][2], _e1408, (_e1408 < _e1293[2][2])) - _e628) * _e633);
                                                                let _e1426 = ((select(_e1293[2][2], _e1412, (_e1412 > _e1293[2][2])) - _e629) * _e633);
                                                                let _e1428 = select(_e1426, _e1425, (_e1425 < _e1426));
                                                                let _e1430 = select(_e1426, _e1425, (_e1425 > _e1426));
                                                                let _e1432 = select(_e1418, _e1417, (_e1417 < _e1418));
                                                                let _e1434 = select(_e1422, _e1421, (_e1421 < _e1422));
                                                                let _e1436 = select(_e1434, _e1432, (_e1432 > _e1434));
                                                                let _e1438 = select(_e1428, _e1436, (_e1436 > _e1428));
                                                                let _e1440 = select(_e1418, _e1417, (_e1417 > _e1418));
                                                                let _e1442 = select(_e1422, _e1421, (_e1421 > _e1422));
                                                                let _e1444 = select(_e1442, _e1440, (_e1440 < _e1442));
                                                                let _e1446 = select(_e1430, _e1444, (_e1444 < _e1430));
                                                                let _e1447 = -(_e1428);
                                                                let _e1453 = select(_e744, _e1438, (_e1438 > _e744));
                                                                if (_e1453 > (_e1446 + (select(_e1447, _e1430, (_e1430 > _e1447)) * 0.0000019073523f))) {
                                                                    phi_2469_ = type_27();
                                                                    phi_2470_ = true;
                                                                } else {
                                                                    let _e1455 = (_e1453 > _e1197.member_1);
                                                                    if _e1455 {
                                                                        phi_2468_ = type_27();
                                                                    } else {
                                                                        let _e1456 = vec3<f32>(_e1293[0][0], _e1293[0][1], _e1293[0][2]);
                                                                        let _e1457 = vec3<f32>(_e1293[1][0], _e1293[1][1], _e1293[1][2]);
                                                                        let _e1458 = vec3<f32>(_e1293[2][0], _e1293[2][1], _e1293[2][2]);
                                                                        let _e1459 = (_e1293[1][0] - _e1293[0][0]);
                                                                        let _e1460 = (_e1293[1][1] - _e1293[0][1]);
                                                                        let _e1461 = (_e1293[1][2] - _e1293[0][2]);
                                                                        let _e1462 = vec3<f32>(_e1459, _e1460, _e1461);
                                                                        let _e1463 = (_e1293[2][0] - _e1293[1][0]);
                                                                        let _e1464 = (_e1293[2][1] - _e1293[1][1]);
                                                                        let _e1465 = (_e1293[2][2] - _e1293[1][2]);
                                                                        let _e1466 = vec3<f32>(_e1463, _e1464, _e1465);
                                                                        let _e1467 = (_e1293[0][0] - _e1293[2][0]);
                                                                        let _e1468 = (_e1293[0][1] - _e1293[2][1]);
                                                                        let _e1469 = (_e1293[0][2] - _e1293[2][2]);
                                                                        let _e1470 = vec3<f32>(_e1467, _e1468, _e1469);
                                                                        let _e1473 = bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u));
                                                                        let _e1476 = bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u));
                                                                        let _e1478 = select(_e1476, _e1473, (_e1473 > _e1476));
                                                                        let _e1481 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                        let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                                        let _e1486 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                                        let _e1489 = bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u));
                                                                        let _e1491 = select(_e1489, _e1486, (_e1486 > _e1489));
                                                                        let _e1494 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                        let _e1496 = select(_e1494, _e1491, (_e1491 > _e1494));
                                                                        let _e1499 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                        let _e1502 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                                        let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                        let _e1507 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                        let _e1509 = select(_e1507, _e1504, (_e1504 > _e1507));
                                                                        let _e1511 = select(_e1496, _e1483, (_e1483 > _e1496));
                                                                        let _e1513 = select(_e1509, _e1511, (_e1511 > _e1509));
                                                                        if (_e1483 == _e1513) {
                                                                            phi_2195_ = _e1320;
                                                                            phi_2196_ = _e1317;
                                                                            phi_2197_ = _e1307;
                                                                            phi_2198_ = _e1304;
                                                                            phi_2199_ = _e1456;
                                                                            phi_2200_ = _e1470;
                                                                            phi_2201_ = _e1466;
                                                                            phi_2202_ = _e1462;
                                                                        } else {
                                                                            let _e1515 = (_e1496 == _e1513);
                                                                            let _e1520 = vec3(_e1515);
                                                                            phi_2195_ = select(_e1307, _e1333, _e1515);
                                                                            phi_2196_ = select(_e1304, _e1330, _e1515);
                                                                            phi_2197_ = select(_e1333, _e1320, _e1515);
                                                                            phi_2198_ = select(_e1330, _e1317, _e1515);
                                                                            phi_2199_ = select(_e1458, _e1457, _e1520);
                                                                            phi_2200_ = select(_e1466, _e1462, _e1520);
                                                                            phi_2201_ = select(_e1462, _e1470, _e1520);
                                                                            phi_2202_ = select(_e1470, _e1466, _e1520);
                                                                        }
                                                                        let _e1526 = phi_2195_;
                                                                        let _e1528 = phi_2196_;
                                                                        let _e1530 = phi_2197_;
                                                                        let _e1532 = phi_2198_;
                                                                        let _e1534 = phi_2199_;
                                                                        let _e1536 = phi_2200_;
                                                                        let _e1538 = phi_2201_;
                                                                        let _e1540 = phi_2202_;
                                                                        let _e1547 = ((_e1538.y * _e1536.z) - (_e1536.y * _e1538.z));
                                                                        let _e1552 = ((_e1538.z * _e1536.x) - (_e1536.z * _e1538.x));
                                                                        let _e1555 = ((_e1538.x * _e1536.y) - (_e1536.x * _e1538.y));
                                                                        if (_e1355 >= _e1359) {
                                                                            phi_2239_ = select(true, false, (_e1355 >= _e1363));
                                                                        } else {
                                                                            phi_2239_ = true;
                                                                        }
                                                                        let _e1560 = phi_2239_;
                                                                        if _e1560 {
                                                                            phi_2248_ = select(_e1458, _e1457, vec3((_e1359 >= _e1363)));
                                                                        } else {
                                                                            phi_2248_ = _e1456;
                                                                        }
                                                                        let _e1565 = phi_2248_;
                                                                        let _e1576 = (((_e1547 * (_e1565.x - _e458)) + (_e1552 * (_e1565.y - _e525))) + (_e1555 * (_e1565.z - _e591)));
                                                                        let _e1581 = (((_e1547 * _e498) + (_e1552 * _e564)) + (_e1555 * _e630));
                                                                        let _e1582 = (_e1528 - _e1532);
                                                                        let _e1583 = (_e1526 - _e1530);
                                                                        let _e1591 = (-(((_e1532 * _e1582) + (_e1530 * _e1583))) / ((_e1582 * _e1582) + (_e1583 * _e1583)));
                                                                        let _e1593 = select(1f, _e1591, (_e1591 < 1f));
                                                                        let _e1595 = select(0f, _e1593, (_e1593 > 0f));
                                                                        let _e1608 = ((_e1534.x + (_e1540.x * _e1595)) - _e458);
                                                                        let _e1609 = ((_e1534.y + (_e1540.y * _e1595)) - _e525);
                                                                        let _e1610 = ((_e1534.z + (_e1540.z * _e1595)) - _e591);
                                                                        let _e1611 = (_e1610 / _e630);
                                                                        let _e1623 = bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u));
                                                                        let _e1626 = bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u));
                                                                        let _e1628 = select(_e1626, _e1623, (_e1623 > _e1626));
                                                                        let _e1631 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                        let _e1633 = select(_e1631, _e1628, (_e1628 > _e1631));
                                                                        let _e1639 = bitcast<f32>((bitcast<u32>(_e1547) & 2147483647u));
                                                                        let _e1642 = bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u));
                                                                        let _e1644 = select(_e1642, _e1639, (_e1639 > _e1642));
                                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1555) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1547 * _e1608) + (_e1552 * _e1609)) + (_e1555 * _e1610)) - _e1576)) & 2147483647u)) <= ((0.0000009536743f * select(_e1513, _e1633, (_e1633 > _e1513))) * select(_e1647, _e1644, (_e1644 > _e1647)))) {
                                                                            let _e1657 = bitcast<f32>((bitcast<u32>(_e1538.x) & 2147483647u));
                                                                            let _e1660 = bitcast<f32>((bitcast<u32>(_e1538.y) & 2147483647u));
                                                                            let _e1662 = select(_e1660, _e1657, (_e1657 > _e1660));
                                                                            let _e1665 = bitcast<f32>((bitcast<u32>(_e1538.z) & 2147483647u));
                                                                            let _e1671 = bitcast<f32>((bitcast<u32>(_e1536.x) & 2147483647u));
                                                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1536.y) & 2147483647u));
                                                                            let _e1676 = select(_e1674, _e1671, (_e1671 > _e1674));
                                                                            let _e1679 = bitcast<f32>((bitcast<u32>(_e1536.z) & 2147483647u));
                                                                            let _e1683 = (bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)) > ((0.0000038146973f * select(_e1665, _e1662, (_e1662 > _e1665))) * select(_e1679, _e1676, (_e1676 > _e1679))));
                                                                            if _e1683 {
                                                                                phi_2413_ = (_e1576 / _e1581);
                                                                            } else {
                                                                                phi_2413_ = f32();
                                                                            }
                                                                            let _e1686 = phi_2413_;
                                                                            phi_2415_ = _e1686;
                                                                            phi_2416_ = select(true, false, _e1683);
                                                                        } else {
                                                                            phi_2415_ = f32();
                                                                            phi_2416_ = true;
                                                                        }
                                                                        let _e1689 = phi_2415_;
                                                                        let _e1691 = phi_2416_;
                                                                        if _e1691 {
                                                                            let _e1699 = (((_e1547 * (_e1608 - (_e498 * _e1611))) + (_e1552 * (_e1609 - (_e564 * _e1611)))) / _e1581);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u)) <= _e1513) {
                                                                                phi_2436_ = (_e1611 + _e1699);
                                                                            } else {
                                                                                phi_2436_ = _e1611;
                                                                            }
                                                                            let _e1706 = phi_2436_;
                                                                            phi_2437_ = _e1706;
                                                                        } else {
                                                                            phi_2437_ = _e1689;
                                                                        }
                                                                        let _e1708 = phi_2437_;
                                                                        let _e1710 = select(_e1446, _e1708, (_e1708 < _e1446));
                                                                        let _e1712 = select(_e1438, _e1710, (_e1710 > _e1438));
                                                                        if (_e1712 >= _e744) {
                                                                            let _e1714 = (_e1712 <= _e1197.member_1);
                                                                            if _e1714 {
                                                                                let _e1715 = (1f / _e1365);
                                                                                phi_2460_ = type_27(_e1712, (_e1359 * _e1715), (_e1363 * _e1715), _e1226);
                                                                            } else {
                                                                                phi_2460_ = type_27();
                                                                            }
                                                                            let _e1720 = phi_2460_;
                                                                            phi_2462_ = _e1720;
                                                                            phi_2463_ = select(true, false, _e1714);
                                                                        } else {
                                                                            phi_2462_ = type_27();
                                                                            phi_2463_ = true;
                                                                        }
                                                                        let _e1723 = phi_2462_;
                                                                        let _e1725 = phi_2463_;
                                                                        if _e1725 {
                                                                            phi_2467_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2467_ = _e1723;
                                                                        }
                                                                        let _e1727 = phi_2467_;
                                                                        phi_2468_ = _e1727;
                                                                    }
                                                                    let _e1729 = phi_2468_;
                                                                    phi_2469_ = _e1729;
                                                                    phi_2470_ = _e1455;
                                                                }
                                                                let _e1731 = phi_2469_;
                                                                let _e1733 = phi_2470_;
                                                                phi_2474_ = _e1731;
                                                                phi_2475_ = _e1733;
                                                            }
                                                            let _e1735 = phi_2474_;
                                                            let _e1737 = phi_2475_;
                                                            phi_2476_ = _e1735;
                                                            phi_2477_ = _e1390;
                                                            phi_2478_ = _e1737;
                                                        }
                                                        let _e1739 = phi_2476_;
                                                        let _e1741 = phi_2477_;
                                                        let _e1743 = phi_2478_;
                                                        phi_2479_ = _e1739;
                                                        phi_2480_ = _e1741;
                                                        phi_2481_ = _e1743;
                                                    }
                                                    let _e1745 = phi_2479_;
                                                    let _e1747 = phi_2480_;
                                                    let _e1749 = phi_2481_;
                                                    phi_2489_ = _e1745;
                                                    phi_2490_ = select(_e1749, true, _e1747);
                                                } else {
                                                    phi_2489_ = type_27();
                                                    phi_2490_ = true;
                                                }
                                                let _e1752 = phi_2489_;
                                                let _e1754 = phi_2490_;
                                                if _e1754 {
                                                    phi_2494_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2494_ = _e1752;
                                                }
                                                let _e1756 = phi_2494_;
                                                if (_e1756.member_3 != 4294967295u) {
                                                    if (_e1226 == _e157) {
                                                        phi_2829_ = false;
                                                    } else {
                                                        let _e1760 = (_e1226 < arrayLength((&global_5.member)));
                                                        if _e1760 {
                                                            if _e1760 {
                                                            } else {
                                                                phi_4155_ = true;
                                                                break;
                                                            }
                                                            let _e1762 = global_5.member[_e1226];
                                                            phi_2517_ = _e1762;
                                                        } else {
                                                            phi_2517_ = 4294967295u;
                                                        }
                                                        let _e1764 = phi_2517_;
                                                        let _e1765 = (_e1764 < arrayLength((&global_6.member)));
                                                        if _e1765 {
                                                            if _e1765 {
                                                            } else {
                                                                phi_4155_ = true;
                                                                break;
                                                            }
                                                            let _e1767 = global_6.member[_e1764];
                                                            phi_2531_ = _e1767;
                                                        } else {
                                                            phi_2531_ = 0i;
                                                        }
                                                        let _e1769 = phi_2531_;
                                                        let _e1770 = (_e1769 == 0i);
                                                        if _e1770 {
                                                            phi_2828_ = true;
                                                        } else {
                                                            if _e435 {
                                                                phi_2554_ = vec3<f32>(_e1293[0][0], _e1293[0][1], _e1293[0][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2553_ = vec3<f32>(_e1293[0][2], _e1293[0][0], _e1293[0][1]);
                                                                } else {
                                                                    phi_2553_ = vec3<f32>(_e1293[0][1], _e1293[0][2], _e1293[0][0]);
                                                                }
                                                                let _e1775 = phi_2553_;
                                                                phi_2554_ = _e1775;
                                                            }
                                                            let _e1778 = phi_2554_;
                                                            if _e435 {
                                                                phi_2573_ = vec3<f32>(_e1293[1][0], _e1293[1][1], _e1293[1][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2572_ = vec3<f32>(_e1293[1][2], _e1293[1][0], _e1293[1][1]);
                                                                } else {
                                                                    phi_2572_ = vec3<f32>(_e1293[1][1], _e1293[1][2], _e1293[1][0]);
                                                                }
                                                                let _e1783 = phi_2572_;
                                                                phi_2573_ = _e1783;
                                                            }
                                                            let _e1786 = phi_2573_;
                                                            if _e435 {
                                                                phi_2592_ = vec3<f32>(_e1293[2][0], _e1293[2][1], _e1293[2][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2591_ = vec3<f32>(_e1293[2][2], _e1293[2][0], _e1293[2][1]);
                                                                } else {
                                                                    phi_2591_ = vec3<f32>(_e1293[2][1], _e1293[2][2], _e1293[2][0]);
                                                                }
                                                                let _e1791 = phi_2591_;
                                                                phi_2592_ = _e1791;
                                                            }
                                                            let _e1794 = phi_2592_;
                                                            let _e1797 = (_e1786.x - _e1778.x);
                                                            let _e1800 = (_e1786.y - _e1778.y);
                                                            let _e1803 = (_e1786.z - _e1778.z);
                                                            let _e1805 = (_e1794.x - _e1778.x);
                                                            let _e1807 = (_e1794.y - _e1778.y);
                                                            let _e1809 = (_e1794.z - _e1778.z);
                                                            if (_e289.member_1 == 1u) {
                                                                phi_2628_ = (vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]) - _e1778);
                                                            } else {
                                                                phi_2628_ = vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]);
                                                            }
                                                            let _e1824 = phi_2628_;
                                                            let _e1830 = bitcast<f32>((bitcast<u32>((_e1797 * _e1807)) ^ _e289.member_3[0]));
                                                            let _e1834 = bitcast<f32>((bitcast<u32>((_e1800 * _e1805)) ^ _e289.member_3[0]));
                                                            let _e1838 = bitcast<f32>((bitcast<u32>((_e1800 * _e1809)) ^ _e289.member_3[0]));
                                                            let _e1842 = bitcast<f32>((bitcast<u32>((_e1803 * _e1807)) ^ _e289.member_3[0]));
                                                            let _e1846 = bitcast<f32>((bitcast<u32>((_e1803 * _e1805)) ^ _e289.member_3[0]));
                                                            let _e1850 = bitcast<f32>((bitcast<u32>((_e1797 * _e1809)) ^ _e289.member_3[0]));
                                                            let _e1851 = (_e1838 - _e1842);
                                                            let _e1852 = (_e1846 - _e1850);
                                                            let _e1853 = (_e1830 - _e1834);
                                                            let _e1877 = (bitcast<f32>((bitcast<u32>(_e1838) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1842) & 2147483647u)));
                                                            let _e1884 = (bitcast<f32>((bitcast<u32>(_e1846) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u)));
                                                            let _e1891 = (bitcast<f32>((bitcast<u32>(_e1830) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u)));
                                                            if (_e289.member_2 == 0f) {
                                                                phi_2810_ = 0f;
                                                            } else {
                                                                let _e1921 = bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u));
                                                                let _e1924 = bitcast<f32>((bitcast<u32>(_e1852) & 2147483647u));
                                                                let _e1927 = bitcast<f32>((bitcast<u32>(_e1853) & 2147483647u));
                                                                let _e1929 = select(_e1927, _e1924, (_e1924 > _e1927));
                                                                let _e1933 = select(_e1927, _e1924, (_e1924 < _e1927));
                                                                let _e1937 = select(_e1924, _e1921, (_e1921 < _e1924));
                                                                let _e1939 = select(_e1924, _e1921, (_e1921 > _e1924));
                                                                let _e1941 = select(_e1927, _e1939, (_e1939 < _e1927));
                                                                phi_2810_ = bitcast<f32>((bitcast<u32>((_e289.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1929, _e1921, (_e1921 > _e1929)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1941, _e1937, (_e1937 > _e1941)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1933, _e1921, (_e1921 < _e1933)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1877 + _e1884) + _e1891))) ^ _e289.member_3[0]))) * 1.0000005f)) ^ _e289.member_3[0])))) ^ _e289.member_3[0]));
                                                            }
                                                            let _e1968 = phi_2810_;
                                                            phi_2828_ = (_e1770 || !(((((bitcast<f32>((bitcast<u32>((_e1824.x * _e1851)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1824.y * _e1852)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1824.z * _e1853)) ^ _e289.member_3[0]))) * f32(-(_e1769))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1824.x) & 2147483647u)) * _e1877)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1824.y) & 2147483647u)) * _e1884)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1824.z) & 2147483647u)) * _e1891)) ^ _e289.member_3[0]))))) ^ _e289.member_3[0])) + _e1968) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1982 = phi_2828_;
                                                        phi_2829_ = _e1982;
                                                    }
                                                    let _e1984 = phi_2829_;
                                                    if _e1984 {
                                                        if (_e1756.member < _e1197.member.member) {
                                                            phi_2849_ = true;
                                                        } else {
                                                            if (_e1756.member == _e1197.member.member) {
                                                                phi_2848_ = (_e1756.member_3 < _e1197.member.member_3);
                                                            } else {
                                                                phi_2848_ = false;
                                                            }
                                                            let _e1994 = phi_2848_;
                                                            phi_2849_ = _e1994;
                                                        }
                                                        let _e1996 = phi_2849_;
                                                        if _e1996 {
                                                            phi_2855_ = type_43(_e1756, _e1756.member);
                                                        } else {
                                                            phi_2855_ = _e1197;
                                                        }
                                                        let _e1999 = phi_2855_;
                                                        phi_2856_ = _e1999;
                                                    } else {
                                                        phi_2856_ = _e1197;
                                                    }
                                                    let _e2001 = phi_2856_;
                                                    phi_2857_ = _e2001;
                                                } else {
                                                    phi_2857_ = _e1197;
                                                }
                                                let _e2003 = phi_2857_;
                                                phi_1457_ = _e2003;
                                            } else {
                                                phi_1457_ = type_43();
                                            }
                                            let _e2005 = phi_1457_;
                                            continue;
                                            continuing {
                                                phi_1456_ = _e2005;
                                                phi_1459_ = _e1212;
                                                phi_4155_ = _e776;
                                                break if !(_e1218);
                                            }
                                        }
                                        let _e2008 = phi_4155_;
                                        phi_4347_ = _e2008;
                                        if _e2008 {
                                            break;
                                        }
                                        phi_4351_ = _e2008;
                                        let _e2334 = local_11;
                                        phi_3870_ = _e2334;
                                        phi_3871_ = false;
                                        phi_3872_ = _e819;
                                        phi_3873_ = _e821;
                                    } else {
                                        let _e830 = (_e821.member_1 < _e98);
                                        if _e830 {
                                            if _e830 {
                                            } else {
                                                phi_4347_ = true;
                                                break;
                                            }
                                            let _e832 = global_10.member[_e821.member_1];
                                            phi_2883_ = _e832;
                                        } else {
                                            phi_2883_ = type_54(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e834 = phi_2883_;
                                        let _e849 = ((10u * _e411) & 31u);
                                        let _e852 = ((_e834.member[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e860 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[0] - _e821.member.member[0]) * 0.0009775171f)) ^ _e140));
                                        let _e865 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e852)) - 8388608f) * _e860)) ^ _e140)));
                                        let _e869 = select(select(_e821.member.member_1[0], _e865, (_e865 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e852 == 1023u));
                                        let _e871 = ((10u * _e410) & 31u);
                                        let _e874 = ((_e834.member[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e882 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[1] - _e821.member.member[1]) * 0.0009775171f)) ^ _e140));
                                        let _e887 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e874)) - 8388608f) * _e882)) ^ _e140)));
                                        let _e891 = select(select(_e821.member.member_1[1], _e887, (_e887 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e874 == 1023u));
                                        let _e893 = ((10u * _e412) & 31u);
                                        let _e896 = ((_e834.member[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e904 = bitcast<f32>((bitcast<u32>(((_e821.member.member_1[2] - _e821.member.member[2]) * 0.0009775171f)) ^ _e140));
                                        let _e909 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e904)) ^ _e140)));
                                        let _e913 = select(select(_e821.member.member_1[2], _e909, (_e909 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e896 == 1023u));
                                        let _e916 = ((_e834.member[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e924 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e916)) - 8388608f) * _e860)) ^ _e140)));
                                        let _e928 = select(select(_e821.member.member_1[0], _e924, (_e924 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e916 == 1023u));
                                        let _e931 = ((_e834.member[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e939 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e882)) ^ _e140)));
                                        let _e943 = select(select(_e821.member.member_1[1], _e939, (_e939 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e931 == 1023u));
                                        let _e946 = ((_e834.member[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e954 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e946)) - 8388608f) * _e904)) ^ _e140)));
                                        let _e958 = select(select(_e821.member.member_1[2], _e954, (_e954 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e946 == 1023u));
                                        let _e964 = ((_e834.member_1[0] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e972 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e964)) - 8388608f) * _e860)) ^ _e140)));
                                        let _e976 = select(select(_e821.member.member_1[0], _e972, (_e972 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e964 == 1023u));
                                        let _e979 = ((_e834.member_1[0] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e987 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e979)) - 8388608f) * _e882)) ^ _e140)));
                                        let _e991 = select(select(_e821.member.member_1[1], _e987, (_e987 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e979 == 1023u));
                                        let _e994 = ((_e834.member_1[0] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1002 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e994)) - 8388608f) * _e904)) ^ _e140)));
                                        let _e1006 = select(select(_e821.member.member_1[2], _e1002, (_e1002 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e994 == 1023u));
                                        let _e1009 = ((_e834.member_1[1] >> bitcast<u32>(_e849)) & 1023u);
                                        let _e1017 = (_e821.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1009)) - 8388608f) * _e860)) ^ _e140)));
                                        let _e1021 = select(select(_e821.member.member_1[0], _e1017, (_e1017 < _e821.member.member_1[0])), _e821.member.member_1[0], (_e1009 == 1023u));
                                        let _e1024 = ((_e834.member_1[1] >> bitcast<u32>(_e871)) & 1023u);
                                        let _e1032 = (_e821.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1024)) - 8388608f) * _e882)) ^ _e140)));
                                        let _e1036 = select(select(_e821.member.member_1[1], _e1032, (_e1032 < _e821.member.member_1[1])), _e821.member.member_1[1], (_e1024 == 1023u));
                                        let _e1039 = ((_e834.member_1[1] >> bitcast<u32>(_e893)) & 1023u);
                                        let _e1047 = (_e821.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1039)) - 8388608f) * _e904)) ^ _e140)));
                                        let _e1051 = select(select(_e821.member.member_1[2], _e1047, (_e1047 < _e821.member.member_1[2])), _e821.member.member_1[2], (_e1039 == 1023u));
                                        let _e1056 = type_61(type_59(array<f32, 3>(_e869, _e891, _e913), array<f32, 3>(_e928, _e943, _e958)), _e834.member_2);
                                        let _e1061 = type_61(type_59(array<f32, 3>(_e976, _e991, _e1006), array<f32, 3>(_e1021, _e1036, _e1051)), _e834.member_3);
                                        let _e1067 = ((_e869 - _e496) * _e501);
                                        let _e1068 = ((_e976 - _e496) * _e501);
                                        let _e1069 = ((_e928 - _e497) * _e501);
                                        let _e1070 = ((_e1021 - _e497) * _e501);
                                        let _e1075 = ((_e891 - _e562) * _e567);
                                        let _e1076 = ((_e991 - _e562) * _e567);
                                        let _e1077 = ((_e943 - _e563) * _e567);
                                        let _e1078 = ((_e1036 - _e563) * _e567);
                                        let _e1083 = ((_e913 - _e628) * _e633);
                                        let _e1084 = ((_e1006 - _e628) * _e633);
                                        let _e1085 = ((_e958 - _e629) * _e633);
                                        let _e1086 = ((_e1051 - _e629) * _e633);
                                        let _e1088 = select(_e1085, _e1083, (_e1083 < _e1085));
                                        let _e1090 = select(_e1086, _e1084, (_e1084 < _e1086));
                                        let _e1092 = select(_e1085, _e1083, (_e1083 > _e1085));
                                        let _e1094 = select(_e1086, _e1084, (_e1084 > _e1086));
                                        let _e1096 = select(_e1069, _e1067, (_e1067 < _e1069));
                                        let _e1098 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1100 = select(_e1077, _e1075, (_e1075 < _e1077));
                                        let _e1102 = select(_e1078, _e1076, (_e1076 < _e1078));
                                        let _e1104 = select(_e1100, _e1096, (_e1096 > _e1100));
                                        let _e1106 = select(_e1102, _e1098, (_e1098 > _e1102));
                                        let _e1108 = select(_e1088, _e1104, (_e1104 > _e1088));
                                        let _e1110 = select(_e1090, _e1106, (_e1106 > _e1090));
                                        let _e1112 = select(_e1069, _e1067, (_e1067 > _e1069));
                                        let _e1114 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1116 = select(_e1077, _e1075, (_e1075 > _e1077));
                                        let _e1118 = select(_e1078, _e1076, (_e1076 > _e1078));
                                        let _e1120 = select(_e1116, _e1112, (_e1112 < _e1116));
                                        let _e1122 = select(_e1118, _e1114, (_e1114 < _e1118));
                                        let _e1127 = -(_e1088);
                                        let _e1128 = -(_e1090);
                                        let _e1135 = (select(_e1092, _e1120, (_e1120 < _e1092)) + (select(_e1127, _e1092, (_e1092 > _e1127)) * 0.0000019073523f));
                                        let _e1136 = (select(_e1094, _e1122, (_e1122 < _e1094)) + (select(_e1128, _e1094, (_e1094 > _e1128)) * 0.0000019073523f));
                                        let _e1138 = select(_e744, _e1108, (_e1108 > _e744));
                                        let _e1140 = select(_e744, _e1110, (_e1110 > _e744));
                                        let _e1145 = (_e1138 <= select(_e778.member_1, _e1135, (_e1135 < _e778.member_1)));
                                        let _e1146 = (_e1140 <= select(_e778.member_1, _e1136, (_e1136 < _e778.member_1)));
                                        let _e1147 = (_e1138 <= _e1140);
                                        if _e1145 {
                                            if _e1146 {
                                                if _e1147 {
                                                    phi_3769_ = _e1061;
                                                } else {
                                                    phi_3769_ = _e1056;
                                                }
                                                let _e1149 = phi_3769_;
                                                let _e1157 = (_e819 % 128u);
                                                let _e1158 = (_e1157 < 128u);
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_6[_e1157] = _e1149.member_1;
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_5[_e1157] = _e1149.member.member[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_4[_e1157] = _e1149.member.member[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_3[_e1157] = _e1149.member.member[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_2[_e1157] = _e1149.member.member_1[0];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_1[_e1157] = _e1149.member.member_1[1];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local[_e1157] = _e1149.member.member_1[2];
                                                if _e1158 {
                                                } else {
                                                    phi_4347_ = true;
                                                    break;
                                                }
                                                local_7[_e1157] = select(_e1140, _e1138, !(_e1147));
                                                if _e1147 {
                                                    phi_3846_ = _e1056;
                                                } else {
                                                    phi_3846_ = _e1061;
                                                }
                                                let _e1175 = phi_3846_;
                                                phi_3847_ = (_e819 + 1u);
                                                phi_3848_ = _e1175;
                                            } else {
                                                phi_3847_ = u32();
                                                phi_3848_ = type_61();
                                            }
                                            let _e1177 = phi_3847_;
                                            let _e1179 = phi_3848_;
                                            phi_3850_ = _e1177;
                                            phi_3851_ = _e1179;
                                            phi_3852_ = select(true, false, _e1146);
                                        } else {
                                            phi_3850_ = u32();
                                            phi_3851_ = type_61();
                                            phi_3852_ = true;
                                        }
                                        let _e1182 = phi_3850_;
                                        let _e1184 = phi_3851_;
                                        let _e1186 = phi_3852_;
                                        if _e1186 {
                                            if _e1145 {
                                                phi_3859_ = _e1056;
                                            } else {
                                                phi_3859_ = _e1061;
                                            }
                                            let _e1188 = phi_3859_;
                                            phi_3864_ = select(_e1146, true, _e1145);
                                            phi_3866_ = _e1188;
                                        } else {
                                            phi_3864_ = _e817;
                                            phi_3866_ = _e1184;
                                        }
                                        let _e1191 = phi_3864_;
                                        let _e1193 = phi_3866_;
                                        phi_4351_ = _e776;
                                        phi_3870_ = _e778;
                                        phi_3871_ = _e1191;
                                        phi_3872_ = select(_e1182, _e819, _e1186);
                                        phi_3873_ = _e1193;
                                    }
                                    let _e2010 = phi_4351_;
                                    let _e2012 = phi_3870_;
                                    let _e2014 = phi_3871_;
                                    let _e2016 = phi_3872_;
                                    let _e2018 = phi_3873_;
                                    phi_4350_ = _e2010;
                                    phi_3874_ = _e2012;
                                    phi_3875_ = _e2014;
                                    phi_3876_ = (_e782 - 1u);
                                    phi_3877_ = _e2016;
                                    phi_3878_ = _e2018;
                                } else {
                                    phi_4350_ = _e776;
                                    phi_3874_ = _e778;
                                    phi_3875_ = _e817;
                                    phi_3876_ = _e782;
                                    phi_3877_ = _e819;
                                    phi_3878_ = _e821;
                                }
                                let _e2020 = phi_4350_;
                                let _e2022 = phi_3874_;
                                let _e2024 = phi_3875_;
                                let _e2026 = phi_3876_;
                                let _e2028 = phi_3877_;
                                let _e2030 = phi_3878_;
                                phi_4349_ = _e2020;
                                phi_3879_ = _e2022;
                                phi_3880_ = _e2024;
                                phi_3881_ = _e2026;
                                phi_3882_ = _e2028;
                                phi_3883_ = _e2030;
                            } else {
                                phi_4349_ = _e776;
                                phi_3879_ = type_43();
                                phi_3880_ = bool();
                                phi_3881_ = u32();
                                phi_3882_ = u32();
                                phi_3883_ = type_61();
                            }
                            let _e2032 = phi_4349_;
                            let _e2034 = phi_3879_;
                            let _e2036 = phi_3880_;
                            let _e2038 = phi_3881_;
                            let _e2040 = phi_3882_;
                            let _e2042 = phi_3883_;
                            phi_4348_ = _e2032;
                            phi_1331_ = _e2034;
                            phi_1334_ = _e2036;
                            phi_1336_ = _e2038;
                            phi_1338_ = _e2040;
                            phi_1340_ = _e2042;
                            phi_3884_ = _e790;
                        } else {
                            phi_4348_ = _e776;
                            phi_1331_ = type_43();
                            phi_1334_ = bool();
                            phi_1336_ = u32();
                            phi_1338_ = u32();
                            phi_1340_ = type_61();
                            phi_3884_ = false;
                        }
                        let _e2044 = phi_4348_;
                        let _e2046 = phi_1331_;
                        let _e2048 = phi_1334_;
                        let _e2050 = phi_1336_;
                        let _e2052 = phi_1338_;
                        let _e2054 = phi_1340_;
                        let _e2056 = phi_3884_;
                        continue;
                        continuing {
                            phi_4161_ = _e2044;
                            phi_1330_ = _e2046;
                            phi_1333_ = _e2048;
                            phi_1335_ = _e2050;
                            phi_1337_ = _e2052;
                            phi_1339_ = _e2054;
                            phi_4347_ = _e2044;
                            break if !(_e2056);
                        }
                    }
                    let _e2059 = phi_4347_;
                    if _e2059 {
                        break;
                    }
                    let _e2061 = local_10;
                    if (_e2061.member.member_3 != 4294967295u) {
                        let _e2066 = bitcast<u32>(_e2061.member.member);
                        let _e2070 = (bitcast<i32>((_e2066 >> bitcast<u32>(23i))) & 255i);
                        let _e2071 = (_e2070 + _e413);
                        if (_e2070 == 255i) {
                            phi_3943_ = _e2061.member.member;
                        } else {
                            if (_e2070 > 0i) {
                                if (_e2071 > 0i) {
                                    let _e2075 = (_e2071 < 255i);
                                    if _e2075 {
                                        phi_3922_ = bitcast<f32>((_e2066 + bitcast<u32>((_e413 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3922_ = f32();
                                    }
                                    let _e2082 = phi_3922_;
                                    phi_3924_ = _e2082;
                                    phi_3925_ = select(true, false, _e2075);
                                } else {
                                    phi_3924_ = f32();
                                    phi_3925_ = true;
                                }
                                let _e2085 = phi_3924_;
                                let _e2087 = phi_3925_;
                                phi_3926_ = _e2085;
                                phi_3927_ = _e2087;
                            } else {
                                phi_3926_ = f32();
                                phi_3927_ = true;
                            }
                            let _e2089 = phi_3926_;
                            let _e2091 = phi_3927_;
                            if _e2091 {
                                let _e2092 = (_e2066 & 2147483648u);
                                let _e2099 = ((_e2066 & 8388607u) | (select(0u, 1u, ((_e2066 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2103 = (_e2099 == 0u);
                                if _e2103 {
                                    phi_4125_ = bitcast<f32>(_e2092);
                                } else {
                                    let _e2108 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2099)), 32u, _e2103) - 8u);
                                    let _e2111 = (_e2099 << bitcast<u32>((_e2108 & 31u)));
                                    let _e2113 = ((_e2071 + select(0i, 1i, (_e2070 == 0i))) - bitcast<i32>(_e2108));
                                    if (_e2113 >= 255i) {
                                        phi_4115_ = bitcast<f32>((_e2092 | 2139095040u));
                                        phi_4116_ = f32();
                                        phi_4117_ = true;
                                    } else {
                                        let _e2115 = (_e2113 > 0i);
                                        if _e2115 {
                                            phi_4109_ = bitcast<f32>(((_e2092 | (bitcast<u32>(_e2113) << bitcast<u32>(23i))) | (_e2111 & 8388607u)));
                                            phi_4110_ = f32();
                                        } else {
                                            if (_e2113 < -24i) {
                                                phi_4075_ = 26u;
                                            } else {
                                                phi_4075_ = bitcast<u32>((1i - _e2113));
                                            }
                                            let _e2120 = phi_4075_;
                                            let _e2121 = (_e2120 & 31u);
                                            let _e2123 = (_e2111 >> bitcast<u32>(_e2121));
                                            let _e2127 = (_e2111 & ((1u << bitcast<u32>(_e2121)) - 1u));
                                            let _e2131 = (1u << bitcast<u32>(((_e2120 - 1u) & 31u)));
                                            if (_e2127 > _e2131) {
                                                phi_4096_ = true;
                                            } else {
                                                if (_e2127 == _e2131) {
                                                    phi_4093_ = ((_e2123 & 1u) == 1u);
                                                } else {
                                                    phi_4093_ = false;
                                                }
                                                let _e2137 = phi_4093_;
                                                phi_4096_ = _e2137;
                                            }
                                            let _e2139 = phi_4096_;
                                            phi_4109_ = f32();
                                            phi_4110_ = bitcast<f32>((_e2092 | (_e2123 + select(0u, 1u, _e2139))));
                                        }
                                        let _e2152 = phi_4109_;
                                        let _e2154 = phi_4110_;
                                        phi_4115_ = _e2152;
                                        phi_4116_ = _e2154;
                                        phi_4117_ = _e2115;
                                    }
                                    let _e2158 = phi_4115_;
                                    let _e2160 = phi_4116_;
                                    let _e2162 = phi_4117_;
                                    phi_4125_ = select(_e2160, _e2158, _e2162);
                                }
                                let _e2166 = phi_4125_;
                                phi_3942_ = _e2166;
                            } else {
                                phi_3942_ = _e2089;
                            }
                            let _e2168 = phi_3942_;
                            phi_3943_ = _e2168;
                        }
                        let _e2170 = phi_3943_;
                        let _e2171 = bitcast<u32>(_e2170);
                        if ((_e2171 & 2147483647u) >= 2139095040u) {
                            phi_3955_ = bitcast<f32>(((_e2171 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3955_ = _e2170;
                        }
                        let _e2178 = phi_3955_;
                        phi_3960_ = type_27(_e2178, _e2061.member.member_1, _e2061.member.member_2, _e2061.member.member_3);
                    } else {
                        phi_3960_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2183 = phi_3960_;
                    if _e290 {
                    } else {
                        break;
                    }
                    global_8.member[_e144] = _e2183;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e2187 = select(0u, 1u, (_e357 <= _e367));
                    if (_e2187 > 0u) {
                        let _e2189 = (1u < _e112);
                        if _e2189 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e2193 = atomicAdd((&global_9.member[0u]), _e2187);
                            if ((_e2193 + _e2187) < _e2193) {
                                if _e2189 {
                                } else {
                                    break;
                                }
                                let _e2198 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2201 = select(0u, 1u, (_e2183.member_3 != 4294967295u));
                    if (_e2201 > 0u) {
                        let _e2203 = (3u < _e112);
                        if _e2203 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e2207 = atomicAdd((&global_9.member[2u]), _e2201);
                            if ((_e2207 + _e2201) < _e2207) {
                                if _e2203 {
                                } else {
                                    break;
                                }
                                let _e2212 = atomicAdd((&global_9.member[3u]), 1u);
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
