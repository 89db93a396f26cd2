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

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_55 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_60 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_62 {
    member: type_60,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_34;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_29;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_67;
@group(0) @binding(3) 
var<storage> global_10: type_57;

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
    var phi_384_: u32;
    var phi_428_: i32;
    var phi_568_: type_40;
    var phi_674_: i32;
    var phi_675_: i32;
    var phi_685_: bool;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_698_: bool;
    var phi_703_: u32;
    var phi_736_: i32;
    var phi_754_: f32;
    var phi_760_: f32;
    var phi_800_: f32;
    var phi_806_: f32;
    var phi_879_: f32;
    var phi_885_: f32;
    var phi_925_: f32;
    var phi_931_: f32;
    var phi_1004_: f32;
    var phi_1010_: f32;
    var phi_1050_: f32;
    var phi_1056_: f32;
    var phi_1175_: i32;
    var phi_1197_: u32;
    var phi_1198_: u32;
    var phi_1235_: i32;
    var phi_1257_: u32;
    var phi_1258_: u32;
    var phi_1266_: f32;
    var phi_1267_: f32;
    var phi_4262_: bool;
    var phi_1350_: type_43;
    var phi_1353_: u32;
    var phi_1355_: bool;
    var phi_1357_: u32;
    var phi_1359_: type_62;
    var phi_1370_: bool;
    var phi_1456_: bool;
    var phi_1457_: u32;
    var phi_1458_: type_62;
    var phi_1476_: type_43;
    var phi_1479_: type_8;
    var phi_1480_: type_8;
    var phi_1502_: type_8;
    var phi_1523_: u32;
    var phi_1615_: array<array<f32, 3>, 3>;
    var phi_3983_: bool;
    var phi_3998_: bool;
    var phi_4013_: bool;
    var phi_4028_: bool;
    var phi_4043_: bool;
    var phi_4058_: bool;
    var phi_2157_: f32;
    var phi_2158_: f32;
    var phi_2159_: f32;
    var phi_2160_: f32;
    var phi_2161_: vec3<f32>;
    var phi_2162_: vec3<f32>;
    var phi_2163_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_4073_: bool;
    var phi_4088_: bool;
    var phi_4103_: bool;
    var phi_4118_: bool;
    var phi_4133_: bool;
    var phi_4148_: bool;
    var phi_2372_: f32;
    var phi_2392_: type_46;
    var phi_2393_: type_46;
    var phi_2396_: type_46;
    var phi_2397_: type_46;
    var phi_2398_: bool;
    var phi_2402_: type_46;
    var phi_2411_: type_27;
    var phi_2434_: u32;
    var phi_2448_: i32;
    var phi_2470_: vec3<f32>;
    var phi_2471_: vec3<f32>;
    var phi_2489_: vec3<f32>;
    var phi_2490_: vec3<f32>;
    var phi_2508_: vec3<f32>;
    var phi_2509_: vec3<f32>;
    var phi_2545_: vec3<f32>;
    var phi_2727_: f32;
    var phi_2745_: bool;
    var phi_2746_: bool;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2772_: type_43;
    var phi_2773_: type_43;
    var phi_2774_: type_43;
    var phi_1477_: type_43;
    var phi_4256_: bool;
    var phi_4512_: bool;
    var phi_2775_: type_43;
    var phi_2796_: type_55;
    var phi_3682_: type_62;
    var phi_3758_: type_62;
    var phi_3759_: u32;
    var phi_3760_: type_62;
    var phi_3762_: u32;
    var phi_3763_: type_62;
    var phi_3764_: bool;
    var phi_3771_: type_62;
    var phi_3776_: bool;
    var phi_3778_: type_62;
    var phi_3782_: bool;
    var phi_3783_: u32;
    var phi_3784_: type_62;
    var phi_3794_: type_62;
    var phi_4456_: bool;
    var phi_3795_: type_43;
    var phi_3796_: u32;
    var phi_3797_: bool;
    var phi_3798_: u32;
    var phi_3799_: type_62;
    var phi_4455_: bool;
    var phi_3800_: type_43;
    var phi_3801_: u32;
    var phi_3802_: bool;
    var phi_3803_: u32;
    var phi_3804_: type_62;
    var phi_4454_: bool;
    var phi_1351_: type_43;
    var phi_1354_: u32;
    var phi_1356_: bool;
    var phi_1358_: u32;
    var phi_1360_: type_62;
    var phi_3805_: bool;
    var phi_4453_: bool;
    var local_10: type_43;
    var phi_3843_: f32;
    var phi_3845_: f32;
    var phi_3846_: bool;
    var phi_3847_: f32;
    var phi_3848_: bool;
    var phi_4176_: u32;
    var phi_4194_: bool;
    var phi_4197_: bool;
    var phi_4210_: f32;
    var phi_4211_: f32;
    var phi_4216_: f32;
    var phi_4217_: f32;
    var phi_4218_: bool;
    var phi_4226_: f32;
    var phi_3863_: f32;
    var phi_3864_: f32;
    var phi_3876_: f32;
    var phi_3881_: type_27;
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
                phi_384_ = _e155;
            } else {
                phi_384_ = 4294967295u;
            }
            let _e157 = phi_384_;
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
                phi_428_ = -126i;
            } else {
                phi_428_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_428_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_568_ = type_40(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                let _e218 = bitcast<u32>(_e193);
                let _e220 = ((_e218 & 2139095040u) != 0u);
                let _e235 = bitcast<u32>(_e194);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e195);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e270 = bitcast<u32>(_e197);
                let _e272 = ((_e270 & 2139095040u) != 0u);
                phi_568_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e218 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e218 & 2147483648u))), _e193, _e220) * _e210) * select(0.00000011920929f, 1f, _e220)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e194, _e237) * _e210) * select(0.00000011920929f, 1f, _e237)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e195, _e254) * _e210) * select(0.00000011920929f, 1f, _e254)) * _e216)), _e176, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e197, _e272) * _e210) * select(0.00000011920929f, 1f, _e272)) * _e216), _e198);
            }
            let _e289 = phi_568_;
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
                            phi_674_ = (bitcast<i32>((_e376 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_674_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e376)), 32u, (_e376 == 0u))));
                        }
                        let _e390 = phi_674_;
                        phi_675_ = _e390;
                    } else {
                        phi_675_ = 0i;
                    }
                    let _e392 = phi_675_;
                    let _e393 = (_e302 == _e346);
                    if _e393 {
                        phi_685_ = true;
                    } else {
                        phi_685_ = (_e310 == _e346);
                    }
                    let _e396 = phi_685_;
                    let _e397 = select(1u, 0u, _e393);
                    if _e396 {
                        let _e398 = (_e397 + 1u);
                        phi_695_ = _e398;
                        phi_696_ = _e398;
                        phi_698_ = select(true, false, (_e398 == 2u));
                    } else {
                        phi_695_ = u32();
                        phi_696_ = 0u;
                        phi_698_ = true;
                    }
                    let _e402 = phi_695_;
                    let _e404 = phi_696_;
                    let _e406 = phi_698_;
                    if _e406 {
                        phi_703_ = (_e404 + 1u);
                    } else {
                        phi_703_ = 0u;
                    }
                    let _e410 = phi_703_;
                    let _e411 = select(_e402, _e404, _e406);
                    let _e412 = select(_e397, select(2u, _e397, _e396), _e406);
                    let _e413 = -(_e392);
                    if (_e413 < -126i) {
                        phi_736_ = -126i;
                    } else {
                        phi_736_ = select(_e413, 127i, (_e413 > 127i));
                    }
                    let _e418 = phi_736_;
                    let _e423 = bitcast<f32>((bitcast<u32>((_e418 + 127i)) << bitcast<u32>(23i)));
                    let _e429 = bitcast<f32>((bitcast<u32>(((_e413 - _e418) + 127i)) << bitcast<u32>(23i)));
                    let _e434 = global_7.member[_e144].member.member;
                    let _e435 = (_e411 == 0u);
                    if _e435 {
                        phi_754_ = _e434[0];
                    } else {
                        phi_754_ = _e434[1];
                    }
                    let _e439 = phi_754_;
                    let _e440 = (_e411 == 2u);
                    if _e440 {
                        phi_760_ = _e434[2];
                    } else {
                        phi_760_ = _e439;
                    }
                    let _e443 = phi_760_;
                    let _e444 = bitcast<u32>(_e443);
                    let _e446 = ((_e444 & 2139095040u) != 0u);
                    let _e458 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * select(0.00000011920929f, 1f, _e446));
                    let _e459 = global_7.member[_e144].member.member_2;
                    if _e435 {
                        phi_800_ = _e459[0];
                    } else {
                        phi_800_ = _e459[1];
                    }
                    let _e463 = phi_800_;
                    if _e440 {
                        phi_806_ = _e459[2];
                    } else {
                        phi_806_ = _e463;
                    }
                    let _e466 = phi_806_;
                    let _e467 = bitcast<u32>(_e466);
                    let _e469 = ((_e467 & 2139095040u) != 0u);
                    let _e483 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e467 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e467 & 2147483648u))), _e466, _e469) * _e423) * select(0.00000011920929f, 1f, _e469)) * _e429);
                    let _e487 = (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e490 = bitcast<f32>((bitcast<u32>(_e458) & 2147483647u));
                    let _e491 = (_e490 * 0.00000011920929f);
                    let _e494 = select(select(0.00000000000011368684f, _e491, (_e491 > 0.00000000000011368684f)), 0f, _e487);
                    let _e495 = select(0f, _e483, _e487);
                    let _e496 = (_e458 + _e494);
                    let _e497 = (_e458 - _e494);
                    let _e499 = select(38685626000000000000000000f, (1f / _e483), _e487);
                    let _e500 = (_e410 == 0u);
                    if _e500 {
                        phi_879_ = _e434[0];
                    } else {
                        phi_879_ = _e434[1];
                    }
                    let _e504 = phi_879_;
                    let _e505 = (_e410 == 2u);
                    if _e505 {
                        phi_885_ = _e434[2];
                    } else {
                        phi_885_ = _e504;
                    }
                    let _e508 = phi_885_;
                    let _e509 = bitcast<u32>(_e508);
                    let _e511 = ((_e509 & 2139095040u) != 0u);
                    let _e523 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e509 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e509 & 2147483648u))), _e508, _e511) * select(0.00000011920929f, 1f, _e511));
                    if _e500 {
                        phi_925_ = _e459[0];
                    } else {
                        phi_925_ = _e459[1];
                    }
                    let _e527 = phi_925_;
                    if _e505 {
                        phi_931_ = _e459[2];
                    } else {
                        phi_931_ = _e527;
                    }
                    let _e530 = phi_931_;
                    let _e531 = bitcast<u32>(_e530);
                    let _e533 = ((_e531 & 2139095040u) != 0u);
                    let _e547 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e531 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e531 & 2147483648u))), _e530, _e533) * _e423) * select(0.00000011920929f, 1f, _e533)) * _e429);
                    let _e551 = (bitcast<f32>((bitcast<u32>(_e547) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e554 = bitcast<f32>((bitcast<u32>(_e523) & 2147483647u));
                    let _e555 = (_e554 * 0.00000011920929f);
                    let _e558 = select(select(0.00000000000011368684f, _e555, (_e555 > 0.00000000000011368684f)), 0f, _e551);
                    let _e559 = select(0f, _e547, _e551);
                    let _e560 = (_e523 + _e558);
                    let _e561 = (_e523 - _e558);
                    let _e563 = select(38685626000000000000000000f, (1f / _e547), _e551);
                    let _e564 = (_e412 == 0u);
                    if _e564 {
                        phi_1004_ = _e434[0];
                    } else {
                        phi_1004_ = _e434[1];
                    }
                    let _e568 = phi_1004_;
                    let _e569 = (_e412 == 2u);
                    if _e569 {
                        phi_1010_ = _e434[2];
                    } else {
                        phi_1010_ = _e568;
                    }
                    let _e572 = phi_1010_;
                    let _e573 = bitcast<u32>(_e572);
                    let _e575 = ((_e573 & 2139095040u) != 0u);
                    let _e587 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e573 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e573 & 2147483648u))), _e572, _e575) * select(0.00000011920929f, 1f, _e575));
                    if _e564 {
                        phi_1050_ = _e459[0];
                    } else {
                        phi_1050_ = _e459[1];
                    }
                    let _e591 = phi_1050_;
                    if _e569 {
                        phi_1056_ = _e459[2];
                    } else {
                        phi_1056_ = _e591;
                    }
                    let _e594 = phi_1056_;
                    let _e595 = bitcast<u32>(_e594);
                    let _e597 = ((_e595 & 2139095040u) != 0u);
                    let _e611 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e595 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e595 & 2147483648u))), _e594, _e597) * _e423) * select(0.00000011920929f, 1f, _e597)) * _e429);
                    let _e615 = (bitcast<f32>((bitcast<u32>(_e611) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e618 = bitcast<f32>((bitcast<u32>(_e587) & 2147483647u));
                    let _e619 = (_e618 * 0.00000011920929f);
                    let _e622 = select(select(0.00000000000011368684f, _e619, (_e619 > 0.00000000000011368684f)), 0f, _e615);
                    let _e623 = select(0f, _e611, _e615);
                    let _e624 = (_e587 + _e622);
                    let _e625 = (_e587 - _e622);
                    let _e627 = select(38685626000000000000000000f, (1f / _e611), _e615);
                    let _e629 = select(_e554, _e490, (_e490 > _e554));
                    if (_e373 && (select(_e618, _e629, (_e629 > _e618)) <= 1099511600000f)) {
                        let _e641 = ((_e359 & 8388607u) | (select(0u, 1u, ((_e359 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e644 = bitcast<i32>((_e359 >> bitcast<u32>(23i)));
                        let _e648 = (_e641 == 0u);
                        let _e651 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e641)), 32u, _e648)) - 8i);
                        if (_e644 == 255i) {
                            phi_1175_ = 255i;
                        } else {
                            phi_1175_ = (((_e644 + select(0i, 1i, (_e644 == 0i))) - _e651) + _e392);
                        }
                        let _e659 = phi_1175_;
                        let _e669 = (_e659 <= 0i);
                        if _e669 {
                            phi_1198_ = u32();
                        } else {
                            if _e648 {
                                phi_1197_ = u32();
                            } else {
                                phi_1197_ = select(((bitcast<u32>(_e659) << bitcast<u32>(23i)) | ((_e641 << bitcast<u32>(((_e651 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e659 >= 255i));
                            }
                            let _e673 = phi_1197_;
                            phi_1198_ = _e673;
                        }
                        let _e675 = phi_1198_;
                        let _e687 = ((_e369 & 8388607u) | (select(0u, 1u, ((_e369 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e690 = bitcast<i32>((_e369 >> bitcast<u32>(23i)));
                        let _e694 = (_e687 == 0u);
                        let _e697 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e687)), 32u, _e694)) - 8i);
                        if (_e690 == 255i) {
                            phi_1235_ = 255i;
                        } else {
                            phi_1235_ = (((_e690 + select(0i, 1i, (_e690 == 0i))) - _e697) + _e392);
                        }
                        let _e705 = phi_1235_;
                        let _e715 = (_e705 <= 0i);
                        if _e715 {
                            phi_1258_ = u32();
                        } else {
                            if _e694 {
                                phi_1257_ = u32();
                            } else {
                                phi_1257_ = select(((bitcast<u32>(_e705) << bitcast<u32>(23i)) | ((_e687 << bitcast<u32>(((_e697 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e705 >= 255i));
                            }
                            let _e719 = phi_1257_;
                            phi_1258_ = _e719;
                        }
                        let _e721 = phi_1258_;
                        phi_1266_ = bitcast<f32>(((_e368 & 2147483648u) | select(_e721, 0u, select(_e694, true, _e715))));
                        phi_1267_ = bitcast<f32>(((_e358 & 2147483648u) | select(_e675, 0u, select(_e648, true, _e669))));
                    } else {
                        phi_1266_ = 0f;
                        phi_1267_ = 1f;
                    }
                    let _e727 = phi_1266_;
                    let _e729 = phi_1267_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                    let _e734 = (_e411 % 3u);
                    let _e735 = (_e734 < 3u);
                    if _e735 {
                    } else {
                        break;
                    }
                    let _e737 = local_9[_e734];
                    let _e738 = (_e410 % 3u);
                    let _e739 = (_e738 < 3u);
                    if _e739 {
                    } else {
                        break;
                    }
                    let _e741 = local_9[_e738];
                    let _e742 = (_e412 % 3u);
                    let _e743 = (_e742 < 3u);
                    if _e743 {
                    } else {
                        break;
                    }
                    let _e745 = local_9[_e742];
                    local_8 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                    if _e735 {
                    } else {
                        break;
                    }
                    let _e749 = local_8[_e734];
                    if _e739 {
                    } else {
                        break;
                    }
                    let _e751 = local_8[_e738];
                    if _e743 {
                    } else {
                        break;
                    }
                    let _e753 = local_8[_e742];
                    phi_4262_ = false;
                    phi_1350_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e727);
                    phi_1353_ = ((3u * _e98) + 1u);
                    phi_1355_ = (_e729 <= _e727);
                    phi_1357_ = 0u;
                    phi_1359_ = type_62(type_60(array<f32, 3>(_e737, _e741, _e745), array<f32, 3>(_e749, _e751, _e753)), select(0u, 2147483648u, (_e98 == 0u)));
                    loop {
                        let _e761 = phi_4262_;
                        let _e763 = phi_1350_;
                        let _e765 = phi_1353_;
                        let _e767 = phi_1355_;
                        let _e769 = phi_1357_;
                        let _e771 = phi_1359_;
                        local_10 = _e763;
                        if _e767 {
                            phi_1370_ = true;
                        } else {
                            phi_1370_ = (_e769 > 0u);
                        }
                        let _e774 = phi_1370_;
                        if _e774 {
                            let _e775 = (_e765 > 0u);
                            if _e775 {
                                if _e767 {
                                    phi_1456_ = _e767;
                                    phi_1457_ = _e769;
                                    phi_1458_ = _e771;
                                } else {
                                    let _e776 = (_e769 - 1u);
                                    let _e777 = (_e776 % 128u);
                                    let _e778 = (_e777 < 128u);
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e780 = local_6[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e782 = local_5[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e784 = local_4[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e786 = local_3[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e789 = local_2[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e791 = local_1[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e793 = local[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4453_ = true;
                                        break;
                                    }
                                    let _e798 = local_7[_e777];
                                    phi_1456_ = (_e798 <= _e763.member_1);
                                    phi_1457_ = _e776;
                                    phi_1458_ = type_62(type_60(array<f32, 3>(_e782, _e784, _e786), array<f32, 3>(_e789, _e791, _e793)), _e780);
                                }
                                let _e802 = phi_1456_;
                                let _e804 = phi_1457_;
                                let _e806 = phi_1458_;
                                if _e802 {
                                    let _e810 = ((_e806.member_1 & 2147483648u) != 0u);
                                    if _e810 {
                                        phi_1476_ = _e763;
                                        phi_1479_ = type_8(0u, ((_e806.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e817 = phi_1476_;
                                            let _e819 = phi_1479_;
                                            local_11 = _e817;
                                            if (_e819.member < _e819.member_1) {
                                                phi_1480_ = type_8((_e819.member + 1u), _e819.member_1);
                                                phi_1502_ = type_8(1u, _e819.member);
                                            } else {
                                                phi_1480_ = _e819;
                                                phi_1502_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e832 = phi_1480_;
                                            let _e834 = phi_1502_;
                                            let _e838 = (bitcast<i32>(_e834.member) != 0i);
                                            if _e838 {
                                                let _e839 = ((_e806.member_1 & 268435455u) + _e834.member_1);
                                                let _e840 = (_e839 < _e100);
                                                if _e840 {
                                                    if _e840 {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e844 = global_4.member[_e839].member_1;
                                                    phi_1523_ = _e844;
                                                } else {
                                                    phi_1523_ = 4294967295u;
                                                }
                                                let _e846 = phi_1523_;
                                                if (_e839 >= _e100) {
                                                    phi_1615_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e840 {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    if (_e734 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e853 = global_4.member[_e839].member[_e734];
                                                    if (_e738 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e859 = global_4.member[_e839].member[_e738];
                                                    if (_e742 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e865 = global_4.member[_e839].member[_e742];
                                                    let _e867 = (3u + _e734);
                                                    if (_e867 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e873 = global_4.member[_e839].member[_e867];
                                                    let _e874 = (3u + _e738);
                                                    if (_e874 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e880 = global_4.member[_e839].member[_e874];
                                                    let _e881 = (3u + _e742);
                                                    if (_e881 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e887 = global_4.member[_e839].member[_e881];
                                                    let _e889 = (6u + _e734);
                                                    if (_e889 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e895 = global_4.member[_e839].member[_e889];
                                                    let _e896 = (6u + _e738);
                                                    if (_e896 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e902 = global_4.member[_e839].member[_e896];
                                                    let _e903 = (6u + _e742);
                                                    if (_e903 < 9u) {
                                                    } else {
                                                        phi_4256_ = true;
                                                        break;
                                                    }
                                                    let _e909 = global_4.member[_e839].member[_e903];
                                                    phi_1615_ = array<array<f32, 3>, 3>(array<f32, 3>(_e853, _e859, _e865), array<f32, 3>(_e873, _e880, _e887), array<f32, 3>(_e895, _e902, _e909));
                                                }
                                                let _e913 = phi_1615_;
                                                let _e929 = (_e913[0][2] - _e587);
                                                let _e932 = (((_e913[0][0] - _e458) * _e623) - (_e929 * _e495));
                                                let _e935 = (((_e913[0][1] - _e523) * _e623) - (_e929 * _e559));
                                                let _e938 = (_e913[1][2] - _e587);
                                                let _e941 = (((_e913[1][0] - _e458) * _e623) - (_e938 * _e495));
                                                let _e944 = (((_e913[1][1] - _e523) * _e623) - (_e938 * _e559));
                                                let _e947 = (_e913[2][2] - _e587);
                                                let _e950 = (((_e913[2][0] - _e458) * _e623) - (_e947 * _e495));
                                                let _e953 = (((_e913[2][1] - _e523) * _e623) - (_e947 * _e559));
                                                let _e954 = (_e950 * _e944);
                                                let _e955 = (_e953 * _e941);
                                                let _e956 = (_e932 * _e953);
                                                let _e957 = (_e935 * _e950);
                                                let _e958 = (_e941 * _e935);
                                                let _e959 = (_e944 * _e932);
                                                let _e964 = (((_e954 >= _e955) && (_e956 >= _e957)) && (_e958 >= _e959));
                                                let _e970 = (_e964 || (((_e954 <= _e955) && (_e956 <= _e957)) && (_e958 <= _e959)));
                                                if _e970 {
                                                    let _e972 = select(-1f, 1f, _e964);
                                                    let _e974 = ((_e954 - _e955) * _e972);
                                                    let _e976 = select(0f, _e974, (_e974 > 0f));
                                                    let _e978 = ((_e956 - _e957) * _e972);
                                                    let _e980 = select(0f, _e978, (_e978 > 0f));
                                                    let _e982 = ((_e958 - _e959) * _e972);
                                                    let _e984 = select(0f, _e982, (_e982 > 0f));
                                                    let _e986 = ((_e976 + _e980) + _e984);
                                                    let _e988 = select(_e913[1][0], _e913[0][0], (_e913[0][0] < _e913[1][0]));
                                                    let _e992 = select(_e913[1][0], _e913[0][0], (_e913[0][0] > _e913[1][0]));
                                                    let _e996 = select(_e913[1][1], _e913[0][1], (_e913[0][1] < _e913[1][1]));
                                                    let _e1000 = select(_e913[1][1], _e913[0][1], (_e913[0][1] > _e913[1][1]));
                                                    let _e1004 = select(_e913[1][2], _e913[0][2], (_e913[0][2] < _e913[1][2]));
                                                    let _e1008 = select(_e913[1][2], _e913[0][2], (_e913[0][2] > _e913[1][2]));
                                                    let _e1013 = ((select(_e913[2][0], _e988, (_e988 < _e913[2][0])) - _e496) * _e499);
                                                    let _e1014 = ((select(_e913[2][0], _e992, (_e992 > _e913[2][0])) - _e497) * _e499);
                                                    let _e1017 = ((select(_e913[2][1], _e996, (_e996 < _e913[2][1])) - _e560) * _e563);
                                                    let _e1018 = ((select(_e913[2][1], _e1000, (_e1000 > _e913[2][1])) - _e561) * _e563);
                                                    let _e1021 = ((select(_e913[2][2], _e1004, (_e1004 < _e913[2][2])) - _e624) * _e627);
                                                    let _e1022 = ((select(_e913[2][2], _e1008, (_e1008 > _e913[2][2])) - _e625) * _e627);
                                                    let _e1024 = select(_e1022, _e1021, (_e1021 < _e1022));
                                                    let _e1026 = select(_e1022, _e1021, (_e1021 > _e1022));
                                                    let _e1028 = select(_e1014, _e1013, (_e1013 < _e1014));
                                                    let _e1030 = select(_e1018, _e1017, (_e1017 < _e1018));
                                                    let _e1032 = select(_e1030, _e1028, (_e1028 > _e1030));
                                                    let _e1034 = select(_e1024, _e1032, (_e1032 > _e1024));
                                                    let _e1036 = select(_e1014, _e1013, (_e1013 > _e1014));
                                                    let _e1038 = select(_e1018, _e1017, (_e1017 > _e1018));
                                                    let _e1040 = select(_e1038, _e1036, (_e1036 < _e1038));
                                                    let _e1042 = select(_e1026, _e1040, (_e1040 < _e1026));
                                                    let _e1043 = -(_e1024);
                                                    let _e1049 = select(_e729, _e1034, (_e1034 > _e729));
                                                    let _e1053 = select(_e941, _e932, (_e932 < _e941));
                                                    let _e1058 = select(_e941, _e932, (_e932 > _e941));
                                                    let _e1065 = select(_e944, _e935, (_e935 < _e944));
                                                    let _e1070 = select(_e944, _e935, (_e935 > _e944));
                                                    let _e1079 = (((((_e970 && (_e986 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e950, _e1053, (_e1053 < _e950)) <= 0f) && (select(_e950, _e1058, (_e1058 > _e950)) >= 0f))) && ((select(_e953, _e1065, (_e1065 < _e953)) <= 0f) && (select(_e953, _e1070, (_e1070 > _e953)) >= 0f))) && (_e1049 <= (_e1042 + (select(_e1043, _e1026, (_e1026 > _e1043)) * 0.0000019073523f)))) && (_e1049 <= _e817.member_1));
                                                    if _e1079 {
                                                        let _e1084 = (_e913[1][0] - _e913[0][0]);
                                                        let _e1085 = (_e913[1][1] - _e913[0][1]);
                                                        let _e1086 = (_e913[1][2] - _e913[0][2]);
                                                        let _e1087 = vec3<f32>(_e1084, _e1085, _e1086);
                                                        let _e1088 = (_e913[2][0] - _e913[1][0]);
                                                        let _e1089 = (_e913[2][1] - _e913[1][1]);
                                                        let _e1090 = (_e913[2][2] - _e913[1][2]);
                                                        let _e1091 = vec3<f32>(_e1088, _e1089, _e1090);
                                                        let _e1092 = (_e913[0][0] - _e913[2][0]);
                                                        let _e1093 = (_e913[0][1] - _e913[2][1]);
                                                        let _e1094 = (_e913[0][2] - _e913[2][2]);
                                                        let _e1095 = vec3<f32>(_e1092, _e1093, _e1094);
                                                        let _e1096 = abs(_e1084);
                                                        let _e1097 = abs(_e1085);
                                                        if (_e1096 != _e1096) {
                                                            phi_3983_ = true;
                                                        } else {
                                                            phi_3983_ = (_e1097 >= _e1096);
                                                        }
                                                        let _e1101 = phi_3983_;
                                                        let _e1102 = select(_e1096, _e1097, _e1101);
                                                        let _e1103 = abs(_e1086);
                                                        if (_e1102 != _e1102) {
                                                            phi_3998_ = true;
                                                        } else {
                                                            phi_3998_ = (_e1103 >= _e1102);
                                                        }
                                                        let _e1107 = phi_3998_;
                                                        let _e1108 = select(_e1102, _e1103, _e1107);
                                                        let _e1109 = abs(_e1088);
                                                        let _e1110 = abs(_e1089);
                                                        if (_e1109 != _e1109) {
                                                            phi_4013_ = true;
                                                        } else {
                                                            phi_4013_ = (_e1110 >= _e1109);
                                                        }
                                                        let _e1114 = phi_4013_;
                                                        let _e1115 = select(_e1109, _e1110, _e1114);
                                                        let _e1116 = abs(_e1090);
                                                        if (_e1115 != _e1115) {
                                                            phi_4028_ = true;
                                                        } else {
                                                            phi_4028_ = (_e1116 >= _e1115);
                                                        }
                                                        let _e1120 = phi_4028_;
                                                        let _e1121 = select(_e1115, _e1116, _e1120);
                                                        let _e1122 = abs(_e1092);
                                                        let _e1123 = abs(_e1093);
                                                        if (_e1122 != _e1122) {
                                                            phi_4043_ = true;
                                                        } else {
                                                            phi_4043_ = (_e1123 >= _e1122);
                                                        }
                                                        let _e1127 = phi_4043_;
                                                        let _e1128 = select(_e1122, _e1123, _e1127);
                                                        let _e1129 = abs(_e1094);
                                                        if (_e1128 != _e1128) {
                                                            phi_4058_ = true;
                                                        } else {
                                                            phi_4058_ = (_e1129 >= _e1128);
                                                        }
                                                        let _e1133 = phi_4058_;
                                                        let _e1134 = select(_e1128, _e1129, _e1133);
                                                        let _e1136 = select(_e1121, _e1108, (_e1108 > _e1121));
                                                        let _e1138 = select(_e1134, _e1136, (_e1136 > _e1134));
                                                        if (_e1108 == _e1138) {
                                                            phi_2157_ = _e944;
                                                            phi_2158_ = _e941;
                                                            phi_2159_ = _e935;
                                                            phi_2160_ = _e932;
                                                            phi_2161_ = vec3<f32>(_e913[0][0], _e913[0][1], _e913[0][2]);
                                                            phi_2162_ = _e1095;
                                                            phi_2163_ = _e1091;
                                                            phi_2164_ = _e1087;
                                                        } else {
                                                            let _e1140 = (_e1121 == _e1138);
                                                            let _e1145 = vec3(_e1140);
                                                            phi_2157_ = select(_e935, _e953, _e1140);
                                                            phi_2158_ = select(_e932, _e950, _e1140);
                                                            phi_2159_ = select(_e953, _e944, _e1140);
                                                            phi_2160_ = select(_e950, _e941, _e1140);
                                                            phi_2161_ = select(vec3<f32>(_e913[2][0], _e913[2][1], _e913[2][2]), vec3<f32>(_e913[1][0], _e913[1][1], _e913[1][2]), _e1145);
                                                            phi_2162_ = select(_e1091, _e1087, _e1145);
                                                            phi_2163_ = select(_e1087, _e1095, _e1145);
                                                            phi_2164_ = select(_e1095, _e1091, _e1145);
                                                        }
                                                        let _e1151 = phi_2157_;
                                                        let _e1153 = phi_2158_;
                                                        let _e1155 = phi_2159_;
                                                        let _e1157 = phi_2160_;
                                                        let _e1159 = phi_2161_;
                                                        let _e1161 = phi_2162_;
                                                        let _e1163 = phi_2163_;
                                                        let _e1165 = phi_2164_;
                                                        let _e1172 = ((_e1163.y * _e1161.z) - (_e1161.y * _e1163.z));
                                                        let _e1177 = ((_e1163.z * _e1161.x) - (_e1161.z * _e1163.x));
                                                        let _e1180 = ((_e1163.x * _e1161.y) - (_e1161.x * _e1163.y));
                                                        let _e1183 = ((_e976 >= _e980) && (_e976 >= _e984));
                                                        let _e1184 = (_e980 >= _e984);
                                                        let _e1198 = (((_e1172 * (select(select(_e913[2][0], _e913[1][0], _e1184), _e913[0][0], _e1183) - _e458)) + (_e1177 * (select(select(_e913[2][1], _e913[1][1], _e1184), _e913[0][1], _e1183) - _e523))) + (_e1180 * (select(select(_e913[2][2], _e913[1][2], _e1184), _e913[0][2], _e1183) - _e587)));
                                                        let _e1203 = (((_e1172 * _e495) + (_e1177 * _e559)) + (_e1180 * _e623));
                                                        let _e1204 = (_e1153 - _e1157);
                                                        let _e1205 = (_e1151 - _e1155);
                                                        let _e1208 = ((_e1204 * _e1204) + (_e1205 * _e1205));
                                                        let _e1215 = (-(((_e1157 * _e1204) + (_e1155 * _e1205))) / select(0.000000000000000000000000000000000000011754944f, _e1208, (_e1208 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1217 = select(1f, _e1215, (_e1215 < 1f));
                                                        let _e1219 = select(0f, _e1217, (_e1217 > 0f));
                                                        let _e1228 = ((_e1159.x + (_e1165.x * _e1219)) - _e458);
                                                        let _e1231 = ((_e1159.y + (_e1165.y * _e1219)) - _e523);
                                                        let _e1234 = ((_e1159.z + (_e1165.z * _e1219)) - _e587);
                                                        let _e1237 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                        let _e1240 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                        let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                        let _e1245 = bitcast<f32>((bitcast<u32>(_e1234) & 2147483647u));
                                                        let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                        let _e1251 = abs(_e1172);
                                                        let _e1252 = abs(_e1177);
                                                        if (_e1251 != _e1251) {
                                                            phi_4073_ = true;
                                                        } else {
                                                            phi_4073_ = (_e1252 >= _e1251);
                                                        }
                                                        let _e1256 = phi_4073_;
                                                        let _e1257 = select(_e1251, _e1252, _e1256);
                                                        let _e1258 = abs(_e1180);
                                                        if (_e1257 != _e1257) {
                                                            phi_4088_ = true;
                                                        } else {
                                                            phi_4088_ = (_e1258 >= _e1257);
                                                        }
                                                        let _e1262 = phi_4088_;
                                                        let _e1278 = abs(_e1163.x);
                                                        let _e1279 = abs(_e1163.y);
                                                        if (_e1278 != _e1278) {
                                                            phi_4103_ = true;
                                                        } else {
                                                            phi_4103_ = (_e1279 >= _e1278);
                                                        }
                                                        let _e1283 = phi_4103_;
                                                        let _e1284 = select(_e1278, _e1279, _e1283);
                                                        let _e1285 = abs(_e1163.z);
                                                        if (_e1284 != _e1284) {
                                                            phi_4118_ = true;
                                                        } else {
                                                            phi_4118_ = (_e1285 >= _e1284);
                                                        }
                                                        let _e1289 = phi_4118_;
                                                        let _e1292 = abs(_e1161.x);
                                                        let _e1293 = abs(_e1161.y);
                                                        if (_e1292 != _e1292) {
                                                            phi_4133_ = true;
                                                        } else {
                                                            phi_4133_ = (_e1293 >= _e1292);
                                                        }
                                                        let _e1297 = phi_4133_;
                                                        let _e1298 = select(_e1292, _e1293, _e1297);
                                                        let _e1299 = abs(_e1161.z);
                                                        if (_e1298 != _e1298) {
                                                            phi_4148_ = true;
                                                        } else {
                                                            phi_4148_ = (_e1299 >= _e1298);
                                                        }
                                                        let _e1303 = phi_4148_;
                                                        let _e1308 = ((bitcast<f32>((bitcast<u32>(((((_e1172 * _e1228) + (_e1177 * _e1231)) + (_e1180 * _e1234)) - _e1198)) & 2147483647u)) <= ((0.0000009536743f * select(_e1138, _e1247, (_e1247 > _e1138))) * select(_e1257, _e1258, _e1262))) && !((bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u)) <= ((0.0000038146973f * select(_e1284, _e1285, _e1289)) * select(_e1298, _e1299, _e1303)))));
                                                        let _e1309 = (_e1198 / _e1203);
                                                        if (_e1079 && !(_e1308)) {
                                                            let _e1312 = (_e1234 / _e623);
                                                            let _e1320 = (((_e1172 * (_e1228 - (_e495 * _e1312))) + (_e1177 * (_e1231 - (_e559 * _e1312)))) / _e1203);
                                                            phi_2372_ = select(select(_e1312, (_e1312 + _e1320), (bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u)) <= _e1138)), _e1309, _e1308);
                                                        } else {
                                                            phi_2372_ = _e1309;
                                                        }
                                                        let _e1329 = phi_2372_;
                                                        let _e1331 = select(_e1042, _e1329, (_e1329 < _e1042));
                                                        let _e1333 = select(_e1034, _e1331, (_e1331 > _e1034));
                                                        let _e1334 = (1f / _e986);
                                                        phi_2392_ = type_46(_e1333, (_e980 * _e1334), (_e984 * _e1334), ((_e1079 && (_e1333 >= _e729)) && (_e1333 <= _e817.member_1)));
                                                        phi_2393_ = type_46();
                                                    } else {
                                                        phi_2392_ = type_46();
                                                        phi_2393_ = type_46(0f, 0f, 0f, _e1079);
                                                    }
                                                    let _e1343 = phi_2392_;
                                                    let _e1345 = phi_2393_;
                                                    phi_2396_ = _e1343;
                                                    phi_2397_ = _e1345;
                                                    phi_2398_ = select(true, false, _e1079);
                                                } else {
                                                    phi_2396_ = type_46();
                                                    phi_2397_ = type_46(0f, 0f, 0f, _e970);
                                                    phi_2398_ = true;
                                                }
                                                let _e1348 = phi_2396_;
                                                let _e1350 = phi_2397_;
                                                let _e1352 = phi_2398_;
                                                if _e1352 {
                                                    phi_2402_ = _e1350;
                                                } else {
                                                    phi_2402_ = _e1348;
                                                }
                                                let _e1354 = phi_2402_;
                                                if _e1354.member_3 {
                                                    phi_2411_ = type_27(_e1354.member, _e1354.member_1, _e1354.member_2, _e846);
                                                } else {
                                                    phi_2411_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1361 = phi_2411_;
                                                if (_e1361.member_3 != 4294967295u) {
                                                    if (_e846 == _e157) {
                                                        phi_2746_ = false;
                                                    } else {
                                                        let _e1365 = (_e846 < arrayLength((&global_5.member)));
                                                        if _e1365 {
                                                            if _e1365 {
                                                            } else {
                                                                phi_4256_ = true;
                                                                break;
                                                            }
                                                            let _e1367 = global_5.member[_e846];
                                                            phi_2434_ = _e1367;
                                                        } else {
                                                            phi_2434_ = 4294967295u;
                                                        }
                                                        let _e1369 = phi_2434_;
                                                        let _e1370 = (_e1369 < arrayLength((&global_6.member)));
                                                        if _e1370 {
                                                            if _e1370 {
                                                            } else {
                                                                phi_4256_ = true;
                                                                break;
                                                            }
                                                            let _e1372 = global_6.member[_e1369];
                                                            phi_2448_ = _e1372;
                                                        } else {
                                                            phi_2448_ = 0i;
                                                        }
                                                        let _e1374 = phi_2448_;
                                                        let _e1375 = (_e1374 == 0i);
                                                        if _e1375 {
                                                            phi_2745_ = true;
                                                        } else {
                                                            if _e435 {
                                                                phi_2471_ = vec3<f32>(_e913[0][0], _e913[0][1], _e913[0][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2470_ = vec3<f32>(_e913[0][2], _e913[0][0], _e913[0][1]);
                                                                } else {
                                                                    phi_2470_ = vec3<f32>(_e913[0][1], _e913[0][2], _e913[0][0]);
                                                                }
                                                                let _e1380 = phi_2470_;
                                                                phi_2471_ = _e1380;
                                                            }
                                                            let _e1383 = phi_2471_;
                                                            if _e435 {
                                                                phi_2490_ = vec3<f32>(_e913[1][0], _e913[1][1], _e913[1][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2489_ = vec3<f32>(_e913[1][2], _e913[1][0], _e913[1][1]);
                                                                } else {
                                                                    phi_2489_ = vec3<f32>(_e913[1][1], _e913[1][2], _e913[1][0]);
                                                                }
                                                                let _e1388 = phi_2489_;
                                                                phi_2490_ = _e1388;
                                                            }
                                                            let _e1391 = phi_2490_;
                                                            if _e435 {
                                                                phi_2509_ = vec3<f32>(_e913[2][0], _e913[2][1], _e913[2][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2508_ = vec3<f32>(_e913[2][2], _e913[2][0], _e913[2][1]);
                                                                } else {
                                                                    phi_2508_ = vec3<f32>(_e913[2][1], _e913[2][2], _e913[2][0]);
                                                                }
                                                                let _e1396 = phi_2508_;
                                                                phi_2509_ = _e1396;
                                                            }
                                                            let _e1399 = phi_2509_;
                                                            let _e1402 = (_e1391.x - _e1383.x);
                                                            let _e1405 = (_e1391.y - _e1383.y);
                                                            let _e1408 = (_e1391.z - _e1383.z);
                                                            let _e1410 = (_e1399.x - _e1383.x);
                                                            let _e1412 = (_e1399.y - _e1383.y);
                                                            let _e1414 = (_e1399.z - _e1383.z);
                                                            if (_e289.member_1 == 1u) {
                                                                phi_2545_ = (vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]) - _e1383);
                                                            } else {
                                                                phi_2545_ = vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]);
                                                            }
                                                            let _e1429 = phi_2545_;
                                                            let _e1435 = bitcast<f32>((bitcast<u32>((_e1402 * _e1412)) ^ _e289.member_3[0]));
                                                            let _e1439 = bitcast<f32>((bitcast<u32>((_e1405 * _e1410)) ^ _e289.member_3[0]));
                                                            let _e1443 = bitcast<f32>((bitcast<u32>((_e1405 * _e1414)) ^ _e289.member_3[0]));
                                                            let _e1447 = bitcast<f32>((bitcast<u32>((_e1408 * _e1412)) ^ _e289.member_3[0]));
                                                            let _e1451 = bitcast<f32>((bitcast<u32>((_e1408 * _e1410)) ^ _e289.member_3[0]));
                                                            let _e1455 = bitcast<f32>((bitcast<u32>((_e1402 * _e1414)) ^ _e289.member_3[0]));
                                                            let _e1456 = (_e1443 - _e1447);
                                                            let _e1457 = (_e1451 - _e1455);
                                                            let _e1458 = (_e1435 - _e1439);
                                                            let _e1482 = (bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u)));
                                                            let _e1489 = (bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1455) & 2147483647u)));
                                                            let _e1496 = (bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u)));
                                                            if (_e289.member_2 == 0f) {
                                                                phi_2727_ = 0f;
                                                            } else {
                                                                let _e1526 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
                                                                let _e1529 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                                let _e1532 = bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u));
                                                                let _e1534 = select(_e1532, _e1529, (_e1529 > _e1532));
                                                                let _e1538 = select(_e1532, _e1529, (_e1529 < _e1532));
                                                                let _e1542 = select(_e1529, _e1526, (_e1526 < _e1529));
                                                                let _e1544 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                let _e1546 = select(_e1532, _e1544, (_e1544 < _e1532));
                                                                phi_2727_ = bitcast<f32>((bitcast<u32>((_e289.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1534, _e1526, (_e1526 > _e1534)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1546, _e1542, (_e1542 > _e1546)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1538, _e1526, (_e1526 < _e1538)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1482 + _e1489) + _e1496))) ^ _e289.member_3[0]))) * 1.0000005f)) ^ _e289.member_3[0])))) ^ _e289.member_3[0]));
                                                            }
                                                            let _e1573 = phi_2727_;
                                                            phi_2745_ = (_e1375 || !(((((bitcast<f32>((bitcast<u32>((_e1429.x * _e1456)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1429.y * _e1457)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1429.z * _e1458)) ^ _e289.member_3[0]))) * f32(-(_e1374))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1429.x) & 2147483647u)) * _e1482)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1429.y) & 2147483647u)) * _e1489)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1429.z) & 2147483647u)) * _e1496)) ^ _e289.member_3[0]))))) ^ _e289.member_3[0])) + _e1573) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1587 = phi_2745_;
                                                        phi_2746_ = _e1587;
                                                    }
                                                    let _e1589 = phi_2746_;
                                                    if _e1589 {
                                                        if (_e1361.member < _e817.member.member) {
                                                            phi_2766_ = true;
                                                        } else {
                                                            if (_e1361.member == _e817.member.member) {
                                                                phi_2765_ = (_e1361.member_3 < _e817.member.member_3);
                                                            } else {
                                                                phi_2765_ = false;
                                                            }
                                                            let _e1599 = phi_2765_;
                                                            phi_2766_ = _e1599;
                                                        }
                                                        let _e1601 = phi_2766_;
                                                        if _e1601 {
                                                            phi_2772_ = type_43(_e1361, _e1361.member);
                                                        } else {
                                                            phi_2772_ = _e817;
                                                        }
                                                        let _e1604 = phi_2772_;
                                                        phi_2773_ = _e1604;
                                                    } else {
                                                        phi_2773_ = _e817;
                                                    }
                                                    let _e1606 = phi_2773_;
                                                    phi_2774_ = _e1606;
                                                } else {
                                                    phi_2774_ = _e817;
                                                }
                                                let _e1608 = phi_2774_;
                                                phi_1477_ = _e1608;
                                            } else {
                                                phi_1477_ = type_43();
                                            }
                                            let _e1610 = phi_1477_;
                                            continue;
                                            continuing {
                                                phi_1476_ = _e1610;
                                                phi_1479_ = _e832;
                                                phi_4256_ = _e761;
                                                break if !(_e838);
                                            }
                                        }
                                        let _e1613 = phi_4256_;
                                        phi_4453_ = _e1613;
                                        if _e1613 {
                                            break;
                                        }
                                        phi_4512_ = _e1613;
                                        let _e2283 = local_11;
                                        phi_2775_ = _e2283;
                                    } else {
                                        phi_4512_ = _e761;
                                        phi_2775_ = _e763;
                                    }
                                    let _e1615 = phi_4512_;
                                    let _e1617 = phi_2775_;
                                    if _e810 {
                                        phi_3782_ = bool();
                                        phi_3783_ = u32();
                                        phi_3784_ = type_62();
                                    } else {
                                        let _e1618 = (_e806.member_1 < _e98);
                                        if _e1618 {
                                            if _e1618 {
                                            } else {
                                                phi_4453_ = true;
                                                break;
                                            }
                                            let _e1620 = global_10.member[_e806.member_1];
                                            phi_2796_ = _e1620;
                                        } else {
                                            phi_2796_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1622 = phi_2796_;
                                        let _e1637 = ((10u * _e411) & 31u);
                                        let _e1640 = ((_e1622.member[0] >> bitcast<u32>(_e1637)) & 1023u);
                                        let _e1648 = bitcast<f32>((bitcast<u32>(((_e806.member.member_1[0] - _e806.member.member[0]) * 0.0009775171f)) ^ _e140));
                                        let _e1653 = (_e806.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1640)) - 8388608f) * _e1648)) ^ _e140)));
                                        let _e1657 = select(select(_e806.member.member_1[0], _e1653, (_e1653 < _e806.member.member_1[0])), _e806.member.member_1[0], (_e1640 == 1023u));
                                        let _e1659 = ((10u * _e410) & 31u);
                                        let _e1662 = ((_e1622.member[0] >> bitcast<u32>(_e1659)) & 1023u);
                                        let _e1670 = bitcast<f32>((bitcast<u32>(((_e806.member.member_1[1] - _e806.member.member[1]) * 0.0009775171f)) ^ _e140));
                                        let _e1675 = (_e806.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1662)) - 8388608f) * _e1670)) ^ _e140)));
                                        let _e1679 = select(select(_e806.member.member_1[1], _e1675, (_e1675 < _e806.member.member_1[1])), _e806.member.member_1[1], (_e1662 == 1023u));
                                        let _e1681 = ((10u * _e412) & 31u);
                                        let _e1684 = ((_e1622.member[0] >> bitcast<u32>(_e1681)) & 1023u);
                                        let _e1692 = bitcast<f32>((bitcast<u32>(((_e806.member.member_1[2] - _e806.member.member[2]) * 0.0009775171f)) ^ _e140));
                                        let _e1697 = (_e806.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1684)) - 8388608f) * _e1692)) ^ _e140)));
                                        let _e1701 = select(select(_e806.member.member_1[2], _e1697, (_e1697 < _e806.member.member_1[2])), _e806.member.member_1[2], (_e1684 == 1023u));
                                        let _e1704 = ((_e1622.member[1] >> bitcast<u32>(_e1637)) & 1023u);
                                        let _e1712 = (_e806.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1704)) - 8388608f) * _e1648)) ^ _e140)));
                                        let _e1716 = select(select(_e806.member.member_1[0], _e1712, (_e1712 < _e806.member.member_1[0])), _e806.member.member_1[0], (_e1704 == 1023u));
                                        let _e1719 = ((_e1622.member[1] >> bitcast<u32>(_e1659)) & 1023u);
                                        let _e1727 = (_e806.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1719)) - 8388608f) * _e1670)) ^ _e140)));
                                        let _e1731 = select(select(_e806.member.member_1[1], _e1727, (_e1727 < _e806.member.member_1[1])), _e806.member.member_1[1], (_e1719 == 1023u));
                                        let _e1734 = ((_e1622.member[1] >> bitcast<u32>(_e1681)) & 1023u);
                                        let _e1742 = (_e806.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1734)) - 8388608f) * _e1692)) ^ _e140)));
                                        let _e1746 = select(select(_e806.member.member_1[2], _e1742, (_e1742 < _e806.member.member_1[2])), _e806.member.member_1[2], (_e1734 == 1023u));
                                        let _e1752 = ((_e1622.member_1[0] >> bitcast<u32>(_e1637)) & 1023u);
                                        let _e1760 = (_e806.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1752)) - 8388608f) * _e1648)) ^ _e140)));
                                        let _e1764 = select(select(_e806.member.member_1[0], _e1760, (_e1760 < _e806.member.member_1[0])), _e806.member.member_1[0], (_e1752 == 1023u));
                                        let _e1767 = ((_e1622.member_1[0] >> bitcast<u32>(_e1659)) & 1023u);
                                        let _e1775 = (_e806.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1767)) - 8388608f) * _e1670)) ^ _e140)));
                                        let _e1779 = select(select(_e806.member.member_1[1], _e1775, (_e1775 < _e806.member.member_1[1])), _e806.member.member_1[1], (_e1767 == 1023u));
                                        let _e1782 = ((_e1622.member_1[0] >> bitcast<u32>(_e1681)) & 1023u);
                                        let _e1790 = (_e806.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1782)) - 8388608f) * _e1692)) ^ _e140)));
                                        let _e1794 = select(select(_e806.member.member_1[2], _e1790, (_e1790 < _e806.member.member_1[2])), _e806.member.member_1[2], (_e1782 == 1023u));
                                        let _e1797 = ((_e1622.member_1[1] >> bitcast<u32>(_e1637)) & 1023u);
                                        let _e1805 = (_e806.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1797)) - 8388608f) * _e1648)) ^ _e140)));
                                        let _e1809 = select(select(_e806.member.member_1[0], _e1805, (_e1805 < _e806.member.member_1[0])), _e806.member.member_1[0], (_e1797 == 1023u));
                                        let _e1812 = ((_e1622.member_1[1] >> bitcast<u32>(_e1659)) & 1023u);
                                        let _e1820 = (_e806.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1812)) - 8388608f) * _e1670)) ^ _e140)));
                                        let _e1824 = select(select(_e806.member.member_1[1], _e1820, (_e1820 < _e806.member.member_1[1])), _e806.member.member_1[1], (_e1812 == 1023u));
                                        let _e1827 = ((_e1622.member_1[1] >> bitcast<u32>(_e1681)) & 1023u);
                                        let _e1835 = (_e806.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1827)) - 8388608f) * _e1692)) ^ _e140)));
                                        let _e1839 = select(select(_e806.member.member_1[2], _e1835, (_e1835 < _e806.member.member_1[2])), _e806.member.member_1[2], (_e1827 == 1023u));
                                        let _e1844 = type_62(type_60(array<f32, 3>(_e1657, _e1679, _e1701), array<f32, 3>(_e1716, _e1731, _e1746)), _e1622.member_2);
                                        let _e1849 = type_62(type_60(array<f32, 3>(_e1764, _e1779, _e1794), array<f32, 3>(_e1809, _e1824, _e1839)), _e1622.member_3);
                                        let _e1855 = ((_e1657 - _e496) * _e499);
                                        let _e1856 = ((_e1764 - _e496) * _e499);
                                        let _e1857 = ((_e1716 - _e497) * _e499);
                                        let _e1858 = ((_e1809 - _e497) * _e499);
                                        let _e1863 = ((_e1679 - _e560) * _e563);
                                        let _e1864 = ((_e1779 - _e560) * _e563);
                                        let _e1865 = ((_e1731 - _e561) * _e563);
                                        let _e1866 = ((_e1824 - _e561) * _e563);
                                        let _e1871 = ((_e1701 - _e624) * _e627);
                                        let _e1872 = ((_e1794 - _e624) * _e627);
                                        let _e1873 = ((_e1746 - _e625) * _e627);
                                        let _e1874 = ((_e1839 - _e625) * _e627);
                                        let _e1876 = select(_e1873, _e1871, (_e1871 < _e1873));
                                        let _e1878 = select(_e1874, _e1872, (_e1872 < _e1874));
                                        let _e1880 = select(_e1873, _e1871, (_e1871 > _e1873));
                                        let _e1882 = select(_e1874, _e1872, (_e1872 > _e1874));
                                        let _e1884 = select(_e1857, _e1855, (_e1855 < _e1857));
                                        let _e1886 = select(_e1858, _e1856, (_e1856 < _e1858));
                                        let _e1888 = select(_e1865, _e1863, (_e1863 < _e1865));
                                        let _e1890 = select(_e1866, _e1864, (_e1864 < _e1866));
                                        let _e1892 = select(_e1888, _e1884, (_e1884 > _e1888));
                                        let _e1894 = select(_e1890, _e1886, (_e1886 > _e1890));
                                        let _e1896 = select(_e1876, _e1892, (_e1892 > _e1876));
                                        let _e1898 = select(_e1878, _e1894, (_e1894 > _e1878));
                                        let _e1900 = select(_e1857, _e1855, (_e1855 > _e1857));
                                        let _e1902 = select(_e1858, _e1856, (_e1856 > _e1858));
                                        let _e1904 = select(_e1865, _e1863, (_e1863 > _e1865));
                                        let _e1906 = select(_e1866, _e1864, (_e1864 > _e1866));
                                        let _e1908 = select(_e1904, _e1900, (_e1900 < _e1904));
                                        let _e1910 = select(_e1906, _e1902, (_e1902 < _e1906));
                                        let _e1915 = -(_e1876);
                                        let _e1916 = -(_e1878);
                                        let _e1923 = (select(_e1880, _e1908, (_e1908 < _e1880)) + (select(_e1915, _e1880, (_e1880 > _e1915)) * 0.0000019073523f));
                                        let _e1924 = (select(_e1882, _e1910, (_e1910 < _e1882)) + (select(_e1916, _e1882, (_e1882 > _e1916)) * 0.0000019073523f));
                                        let _e1926 = select(_e729, _e1896, (_e1896 > _e729));
                                        let _e1928 = select(_e729, _e1898, (_e1898 > _e729));
                                        let _e1933 = (_e1926 <= select(_e1617.member_1, _e1923, (_e1923 < _e1617.member_1)));
                                        let _e1934 = (_e1928 <= select(_e1617.member_1, _e1924, (_e1924 < _e1617.member_1)));
                                        let _e1935 = (_e1926 <= _e1928);
                                        if _e1933 {
                                            if _e1934 {
                                                if _e1935 {
                                                    phi_3682_ = _e1849;
                                                } else {
                                                    phi_3682_ = _e1844;
                                                }
                                                let _e1937 = phi_3682_;
                                                let _e1944 = (_e804 % 128u);
                                                let _e1945 = (_e1944 < 128u);
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_6[_e1944] = _e1937.member_1;
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_5[_e1944] = _e1937.member.member[0];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_4[_e1944] = _e1937.member.member[1];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_3[_e1944] = _e1937.member.member[2];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_2[_e1944] = _e1937.member.member_1[0];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_1[_e1944] = _e1937.member.member_1[1];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local[_e1944] = _e1937.member.member_1[2];
                                                if _e1945 {
                                                } else {
                                                    phi_4453_ = true;
                                                    break;
                                                }
                                                local_7[_e1944] = select(_e1926, _e1928, _e1935);
                                                if _e1935 {
                                                    phi_3758_ = _e1844;
                                                } else {
                                                    phi_3758_ = _e1849;
                                                }
                                                let _e1962 = phi_3758_;
                                                phi_3759_ = (_e804 + 1u);
                                                phi_3760_ = _e1962;
                                            } else {
                                                phi_3759_ = u32();
                                                phi_3760_ = type_62();
                                            }
                                            let _e1964 = phi_3759_;
                                            let _e1966 = phi_3760_;
                                            phi_3762_ = _e1964;
                                            phi_3763_ = _e1966;
                                            phi_3764_ = select(true, false, _e1934);
                                        } else {
                                            phi_3762_ = u32();
                                            phi_3763_ = type_62();
                                            phi_3764_ = true;
                                        }
                                        let _e1969 = phi_3762_;
                                        let _e1971 = phi_3763_;
                                        let _e1973 = phi_3764_;
                                        if _e1973 {
                                            if _e1933 {
                                                phi_3771_ = _e1844;
                                            } else {
                                                phi_3771_ = _e1849;
                                            }
                                            let _e1975 = phi_3771_;
                                            phi_3776_ = select(_e1934, true, _e1933);
                                            phi_3778_ = _e1975;
                                        } else {
                                            phi_3776_ = _e802;
                                            phi_3778_ = _e1971;
                                        }
                                        let _e1978 = phi_3776_;
                                        let _e1980 = phi_3778_;
                                        phi_3782_ = _e1978;
                                        phi_3783_ = select(_e1969, _e804, _e1973);
                                        phi_3784_ = _e1980;
                                    }
                                    let _e1983 = phi_3782_;
                                    let _e1985 = phi_3783_;
                                    let _e1987 = phi_3784_;
                                    if _e810 {
                                        phi_3794_ = _e806;
                                    } else {
                                        phi_3794_ = _e1987;
                                    }
                                    let _e1989 = phi_3794_;
                                    phi_4456_ = _e1615;
                                    phi_3795_ = _e1617;
                                    phi_3796_ = (_e765 - 1u);
                                    phi_3797_ = select(_e1983, false, _e810);
                                    phi_3798_ = select(_e1985, _e804, _e810);
                                    phi_3799_ = _e1989;
                                } else {
                                    phi_4456_ = _e761;
                                    phi_3795_ = _e763;
                                    phi_3796_ = _e765;
                                    phi_3797_ = _e802;
                                    phi_3798_ = _e804;
                                    phi_3799_ = _e806;
                                }
                                let _e1993 = phi_4456_;
                                let _e1995 = phi_3795_;
                                let _e1997 = phi_3796_;
                                let _e1999 = phi_3797_;
                                let _e2001 = phi_3798_;
                                let _e2003 = phi_3799_;
                                phi_4455_ = _e1993;
                                phi_3800_ = _e1995;
                                phi_3801_ = _e1997;
                                phi_3802_ = _e1999;
                                phi_3803_ = _e2001;
                                phi_3804_ = _e2003;
                            } else {
                                phi_4455_ = _e761;
                                phi_3800_ = type_43();
                                phi_3801_ = u32();
                                phi_3802_ = bool();
                                phi_3803_ = u32();
                                phi_3804_ = type_62();
                            }
                            let _e2005 = phi_4455_;
                            let _e2007 = phi_3800_;
                            let _e2009 = phi_3801_;
                            let _e2011 = phi_3802_;
                            let _e2013 = phi_3803_;
                            let _e2015 = phi_3804_;
                            phi_4454_ = _e2005;
                            phi_1351_ = _e2007;
                            phi_1354_ = _e2009;
                            phi_1356_ = _e2011;
                            phi_1358_ = _e2013;
                            phi_1360_ = _e2015;
                            phi_3805_ = _e775;
                        } else {
                            phi_4454_ = _e761;
                            phi_1351_ = type_43();
                            phi_1354_ = u32();
                            phi_1356_ = bool();
                            phi_1358_ = u32();
                            phi_1360_ = type_62();
                            phi_3805_ = false;
                        }
                        let _e2017 = phi_4454_;
                        let _e2019 = phi_1351_;
                        let _e2021 = phi_1354_;
                        let _e2023 = phi_1356_;
                        let _e2025 = phi_1358_;
                        let _e2027 = phi_1360_;
                        let _e2029 = phi_3805_;
                        continue;
                        continuing {
                            phi_4262_ = _e2017;
                            phi_1350_ = _e2019;
                            phi_1353_ = _e2021;
                            phi_1355_ = _e2023;
                            phi_1357_ = _e2025;
                            phi_1359_ = _e2027;
                            phi_4453_ = _e2017;
                            break if !(_e2029);
                        }
                    }
                    let _e2032 = phi_4453_;
                    if _e2032 {
                        break;
                    }
                    let _e2034 = local_10;
                    if (_e2034.member.member_3 != 4294967295u) {
                        let _e2039 = bitcast<u32>(_e2034.member.member);
                        let _e2043 = (bitcast<i32>((_e2039 >> bitcast<u32>(23i))) & 255i);
                        let _e2044 = (_e2043 + _e413);
                        if (_e2043 == 255i) {
                            phi_3864_ = _e2034.member.member;
                        } else {
                            if (_e2043 > 0i) {
                                if (_e2044 > 0i) {
                                    let _e2048 = (_e2044 < 255i);
                                    if _e2048 {
                                        phi_3843_ = bitcast<f32>((_e2039 + bitcast<u32>((_e413 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3843_ = f32();
                                    }
                                    let _e2055 = phi_3843_;
                                    phi_3845_ = _e2055;
                                    phi_3846_ = select(true, false, _e2048);
                                } else {
                                    phi_3845_ = f32();
                                    phi_3846_ = true;
                                }
                                let _e2058 = phi_3845_;
                                let _e2060 = phi_3846_;
                                phi_3847_ = _e2058;
                                phi_3848_ = _e2060;
                            } else {
                                phi_3847_ = f32();
                                phi_3848_ = true;
                            }
                            let _e2062 = phi_3847_;
                            let _e2064 = phi_3848_;
                            if _e2064 {
                                let _e2065 = (_e2039 & 2147483648u);
                                let _e2072 = ((_e2039 & 8388607u) | (select(0u, 1u, ((_e2039 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2076 = (_e2072 == 0u);
                                if _e2076 {
                                    phi_4226_ = bitcast<f32>(_e2065);
                                } else {
                                    let _e2081 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2072)), 32u, _e2076) - 8u);
                                    let _e2084 = (_e2072 << bitcast<u32>((_e2081 & 31u)));
                                    let _e2086 = ((_e2044 + select(0i, 1i, (_e2043 == 0i))) - bitcast<i32>(_e2081));
                                    if (_e2086 >= 255i) {
                                        phi_4216_ = bitcast<f32>((_e2065 | 2139095040u));
                                        phi_4217_ = f32();
                                        phi_4218_ = true;
                                    } else {
                                        let _e2088 = (_e2086 > 0i);
                                        if _e2088 {
                                            phi_4210_ = bitcast<f32>(((_e2065 | (bitcast<u32>(_e2086) << bitcast<u32>(23i))) | (_e2084 & 8388607u)));
                                            phi_4211_ = f32();
                                        } else {
                                            if (_e2086 < -24i) {
                                                phi_4176_ = 26u;
                                            } else {
                                                phi_4176_ = bitcast<u32>((1i - _e2086));
                                            }
                                            let _e2093 = phi_4176_;
                                            let _e2094 = (_e2093 & 31u);
                                            let _e2096 = (_e2084 >> bitcast<u32>(_e2094));
                                            let _e2100 = (_e2084 & ((1u << bitcast<u32>(_e2094)) - 1u));
                                            let _e2104 = (1u << bitcast<u32>(((_e2093 - 1u) & 31u)));
                                            if (_e2100 > _e2104) {
                                                phi_4197_ = true;
                                            } else {
                                                if (_e2100 == _e2104) {
                                                    phi_4194_ = ((_e2096 & 1u) == 1u);
                                                } else {
                                                    phi_4194_ = false;
                                                }
                                                let _e2110 = phi_4194_;
                                                phi_4197_ = _e2110;
                                            }
                                            let _e2112 = phi_4197_;
                                            phi_4210_ = f32();
                                            phi_4211_ = bitcast<f32>((_e2065 | (_e2096 + select(0u, 1u, _e2112))));
                                        }
                                        let _e2125 = phi_4210_;
                                        let _e2127 = phi_4211_;
                                        phi_4216_ = _e2125;
                                        phi_4217_ = _e2127;
                                        phi_4218_ = _e2088;
                                    }
                                    let _e2131 = phi_4216_;
                                    let _e2133 = phi_4217_;
                                    let _e2135 = phi_4218_;
                                    phi_4226_ = select(_e2133, _e2131, _e2135);
                                }
                                let _e2139 = phi_4226_;
                                phi_3863_ = _e2139;
                            } else {
                                phi_3863_ = _e2062;
                            }
                            let _e2141 = phi_3863_;
                            phi_3864_ = _e2141;
                        }
                        let _e2143 = phi_3864_;
                        let _e2144 = bitcast<u32>(_e2143);
                        if ((_e2144 & 2147483647u) >= 2139095040u) {
                            phi_3876_ = bitcast<f32>(((_e2144 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3876_ = _e2143;
                        }
                        let _e2151 = phi_3876_;
                        phi_3881_ = type_27(_e2151, _e2034.member.member_1, _e2034.member.member_2, _e2034.member.member_3);
                    } else {
                        phi_3881_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2156 = phi_3881_;
                    if _e290 {
                    } else {
                        break;
                    }
                    global_8.member[_e144] = _e2156;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e2160 = select(0u, 1u, (_e357 <= _e367));
                    if (_e2160 > 0u) {
                        let _e2162 = (1u < _e112);
                        if _e2162 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e2166 = atomicAdd((&global_9.member[0u]), _e2160);
                            if ((_e2166 + _e2160) < _e2166) {
                                if _e2162 {
                                } else {
                                    break;
                                }
                                let _e2171 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2174 = select(0u, 1u, (_e2156.member_3 != 4294967295u));
                    if (_e2174 > 0u) {
                        let _e2176 = (3u < _e112);
                        if _e2176 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e2180 = atomicAdd((&global_9.member[2u]), _e2174);
                            if ((_e2180 + _e2174) < _e2180) {
                                if _e2176 {
                                } else {
                                    break;
                                }
                                let _e2185 = atomicAdd((&global_9.member[3u]), 1u);
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
