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
    var phi_391_: u32;
    var phi_435_: i32;
    var phi_575_: type_40;
    var phi_681_: i32;
    var phi_682_: i32;
    var phi_692_: bool;
    var phi_702_: u32;
    var phi_703_: u32;
    var phi_705_: bool;
    var phi_710_: u32;
    var phi_743_: i32;
    var phi_761_: f32;
    var phi_767_: f32;
    var phi_807_: f32;
    var phi_813_: f32;
    var phi_886_: f32;
    var phi_892_: f32;
    var phi_932_: f32;
    var phi_938_: f32;
    var phi_1011_: f32;
    var phi_1017_: f32;
    var phi_1057_: f32;
    var phi_1063_: f32;
    var phi_1182_: i32;
    var phi_1204_: u32;
    var phi_1205_: u32;
    var phi_1242_: i32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_4191_: bool;
    var phi_1357_: type_43;
    var phi_1360_: bool;
    var phi_1362_: type_62;
    var phi_1364_: u32;
    var phi_1366_: u32;
    var phi_1377_: bool;
    var phi_1463_: bool;
    var phi_1464_: type_62;
    var phi_1465_: u32;
    var phi_2773_: type_55;
    var phi_3659_: type_62;
    var phi_3735_: type_62;
    var phi_3736_: type_62;
    var phi_3737_: u32;
    var phi_3739_: type_62;
    var phi_3740_: u32;
    var phi_3741_: bool;
    var phi_3748_: type_62;
    var phi_3753_: bool;
    var phi_3754_: type_62;
    var phi_1483_: type_43;
    var phi_1486_: type_8;
    var phi_1487_: type_8;
    var phi_1509_: type_8;
    var phi_1530_: u32;
    var phi_1622_: array<array<f32, 3>, 3>;
    var phi_2152_: f32;
    var phi_2153_: f32;
    var phi_2154_: f32;
    var phi_2155_: f32;
    var phi_2156_: vec3<f32>;
    var phi_2157_: vec3<f32>;
    var phi_2158_: vec3<f32>;
    var phi_2159_: vec3<f32>;
    var phi_2350_: f32;
    var phi_2370_: type_46;
    var phi_2371_: type_46;
    var phi_2374_: type_46;
    var phi_2375_: type_46;
    var phi_2376_: bool;
    var phi_2380_: type_46;
    var phi_2389_: type_27;
    var phi_2412_: u32;
    var phi_2426_: i32;
    var phi_2448_: vec3<f32>;
    var phi_2449_: vec3<f32>;
    var phi_2467_: vec3<f32>;
    var phi_2468_: vec3<f32>;
    var phi_2486_: vec3<f32>;
    var phi_2487_: vec3<f32>;
    var phi_2523_: vec3<f32>;
    var phi_2705_: f32;
    var phi_2723_: bool;
    var phi_2724_: bool;
    var phi_2743_: bool;
    var phi_2744_: bool;
    var phi_2750_: type_43;
    var phi_2751_: type_43;
    var phi_2752_: type_43;
    var phi_1484_: type_43;
    var phi_4185_: bool;
    var local_10: type_43;
    var phi_4374_: bool;
    var phi_3756_: type_43;
    var phi_3757_: bool;
    var phi_3758_: type_62;
    var phi_3759_: u32;
    var phi_4373_: bool;
    var phi_3760_: type_43;
    var phi_3761_: bool;
    var phi_3762_: type_62;
    var phi_3763_: u32;
    var phi_3764_: u32;
    var phi_4372_: bool;
    var phi_3765_: type_43;
    var phi_3766_: bool;
    var phi_3767_: type_62;
    var phi_3768_: u32;
    var phi_3769_: u32;
    var phi_4371_: bool;
    var phi_1358_: type_43;
    var phi_1361_: bool;
    var phi_1363_: type_62;
    var phi_1365_: u32;
    var phi_1367_: u32;
    var phi_3770_: bool;
    var phi_4370_: bool;
    var local_11: type_43;
    var phi_3808_: f32;
    var phi_3810_: f32;
    var phi_3811_: bool;
    var phi_3812_: f32;
    var phi_3813_: bool;
    var phi_4105_: u32;
    var phi_4123_: bool;
    var phi_4126_: bool;
    var phi_4139_: f32;
    var phi_4140_: f32;
    var phi_4145_: f32;
    var phi_4146_: f32;
    var phi_4147_: bool;
    var phi_4155_: f32;
    var phi_3828_: f32;
    var phi_3829_: f32;
    var phi_3841_: f32;
    var phi_3846_: type_27;
    var local_12: type_43;

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
                phi_391_ = _e155;
            } else {
                phi_391_ = 4294967295u;
            }
            let _e157 = phi_391_;
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
                phi_435_ = -126i;
            } else {
                phi_435_ = select(_e200, 127i, (_e200 > 127i));
            }
            let _e205 = phi_435_;
            let _e210 = bitcast<f32>((bitcast<u32>((_e205 + 127i)) << bitcast<u32>(23i)));
            let _e216 = bitcast<f32>((bitcast<u32>(((_e200 - _e205) + 127i)) << bitcast<u32>(23i)));
            if (_e176 == 0u) {
                phi_575_ = type_40(array<f32, 3>(_e193, _e194, _e195), _e176, _e197, _e198);
            } else {
                let _e218 = bitcast<u32>(_e193);
                let _e220 = ((_e218 & 2139095040u) != 0u);
                let _e235 = bitcast<u32>(_e194);
                let _e237 = ((_e235 & 2139095040u) != 0u);
                let _e252 = bitcast<u32>(_e195);
                let _e254 = ((_e252 & 2139095040u) != 0u);
                let _e270 = bitcast<u32>(_e197);
                let _e272 = ((_e270 & 2139095040u) != 0u);
                phi_575_ = type_40(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e218 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e218 & 2147483648u))), _e193, _e220) * _e210) * select(0.00000011920929f, 1f, _e220)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e235 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e235 & 2147483648u))), _e194, _e237) * _e210) * select(0.00000011920929f, 1f, _e237)) * _e216), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e252 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e252 & 2147483648u))), _e195, _e254) * _e210) * select(0.00000011920929f, 1f, _e254)) * _e216)), _e176, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e270 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e270 & 2147483648u))), _e197, _e272) * _e210) * select(0.00000011920929f, 1f, _e272)) * _e216), _e198);
            }
            let _e289 = phi_575_;
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
                            phi_681_ = (bitcast<i32>((_e376 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_681_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e376)), 32u, (_e376 == 0u))));
                        }
                        let _e390 = phi_681_;
                        phi_682_ = _e390;
                    } else {
                        phi_682_ = 0i;
                    }
                    let _e392 = phi_682_;
                    let _e393 = (_e302 == _e346);
                    if _e393 {
                        phi_692_ = true;
                    } else {
                        phi_692_ = (_e310 == _e346);
                    }
                    let _e396 = phi_692_;
                    let _e397 = select(1u, 0u, _e393);
                    if _e396 {
                        let _e398 = (_e397 + 1u);
                        phi_702_ = _e398;
                        phi_703_ = _e398;
                        phi_705_ = select(true, false, (_e398 == 2u));
                    } else {
                        phi_702_ = u32();
                        phi_703_ = 0u;
                        phi_705_ = true;
                    }
                    let _e402 = phi_702_;
                    let _e404 = phi_703_;
                    let _e406 = phi_705_;
                    if _e406 {
                        phi_710_ = (_e404 + 1u);
                    } else {
                        phi_710_ = 0u;
                    }
                    let _e410 = phi_710_;
                    let _e411 = select(_e402, _e404, _e406);
                    let _e412 = select(_e397, select(2u, _e397, _e396), _e406);
                    let _e413 = -(_e392);
                    if (_e413 < -126i) {
                        phi_743_ = -126i;
                    } else {
                        phi_743_ = select(_e413, 127i, (_e413 > 127i));
                    }
                    let _e418 = phi_743_;
                    let _e423 = bitcast<f32>((bitcast<u32>((_e418 + 127i)) << bitcast<u32>(23i)));
                    let _e429 = bitcast<f32>((bitcast<u32>(((_e413 - _e418) + 127i)) << bitcast<u32>(23i)));
                    let _e434 = global_7.member[_e144].member.member;
                    let _e435 = (_e411 == 0u);
                    if _e435 {
                        phi_761_ = _e434[0];
                    } else {
                        phi_761_ = _e434[1];
                    }
                    let _e439 = phi_761_;
                    let _e440 = (_e411 == 2u);
                    if _e440 {
                        phi_767_ = _e434[2];
                    } else {
                        phi_767_ = _e439;
                    }
                    let _e443 = phi_767_;
                    let _e444 = bitcast<u32>(_e443);
                    let _e446 = ((_e444 & 2139095040u) != 0u);
                    let _e458 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e444 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e444 & 2147483648u))), _e443, _e446) * select(0.00000011920929f, 1f, _e446));
                    let _e459 = global_7.member[_e144].member.member_2;
                    if _e435 {
                        phi_807_ = _e459[0];
                    } else {
                        phi_807_ = _e459[1];
                    }
                    let _e463 = phi_807_;
                    if _e440 {
                        phi_813_ = _e459[2];
                    } else {
                        phi_813_ = _e463;
                    }
                    let _e466 = phi_813_;
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
                        phi_886_ = _e434[0];
                    } else {
                        phi_886_ = _e434[1];
                    }
                    let _e504 = phi_886_;
                    let _e505 = (_e410 == 2u);
                    if _e505 {
                        phi_892_ = _e434[2];
                    } else {
                        phi_892_ = _e504;
                    }
                    let _e508 = phi_892_;
                    let _e509 = bitcast<u32>(_e508);
                    let _e511 = ((_e509 & 2139095040u) != 0u);
                    let _e523 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e509 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e509 & 2147483648u))), _e508, _e511) * select(0.00000011920929f, 1f, _e511));
                    if _e500 {
                        phi_932_ = _e459[0];
                    } else {
                        phi_932_ = _e459[1];
                    }
                    let _e527 = phi_932_;
                    if _e505 {
                        phi_938_ = _e459[2];
                    } else {
                        phi_938_ = _e527;
                    }
                    let _e530 = phi_938_;
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
                        phi_1011_ = _e434[0];
                    } else {
                        phi_1011_ = _e434[1];
                    }
                    let _e568 = phi_1011_;
                    let _e569 = (_e412 == 2u);
                    if _e569 {
                        phi_1017_ = _e434[2];
                    } else {
                        phi_1017_ = _e568;
                    }
                    let _e572 = phi_1017_;
                    let _e573 = bitcast<u32>(_e572);
                    let _e575 = ((_e573 & 2139095040u) != 0u);
                    let _e587 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e573 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e573 & 2147483648u))), _e572, _e575) * select(0.00000011920929f, 1f, _e575));
                    if _e564 {
                        phi_1057_ = _e459[0];
                    } else {
                        phi_1057_ = _e459[1];
                    }
                    let _e591 = phi_1057_;
                    if _e569 {
                        phi_1063_ = _e459[2];
                    } else {
                        phi_1063_ = _e591;
                    }
                    let _e594 = phi_1063_;
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
                            phi_1182_ = 255i;
                        } else {
                            phi_1182_ = (((_e644 + select(0i, 1i, (_e644 == 0i))) - _e651) + _e392);
                        }
                        let _e659 = phi_1182_;
                        let _e669 = (_e659 <= 0i);
                        if _e669 {
                            phi_1205_ = u32();
                        } else {
                            if _e648 {
                                phi_1204_ = u32();
                            } else {
                                phi_1204_ = select(((bitcast<u32>(_e659) << bitcast<u32>(23i)) | ((_e641 << bitcast<u32>(((_e651 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e659 >= 255i));
                            }
                            let _e673 = phi_1204_;
                            phi_1205_ = _e673;
                        }
                        let _e675 = phi_1205_;
                        let _e687 = ((_e369 & 8388607u) | (select(0u, 1u, ((_e369 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e690 = bitcast<i32>((_e369 >> bitcast<u32>(23i)));
                        let _e694 = (_e687 == 0u);
                        let _e697 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e687)), 32u, _e694)) - 8i);
                        if (_e690 == 255i) {
                            phi_1242_ = 255i;
                        } else {
                            phi_1242_ = (((_e690 + select(0i, 1i, (_e690 == 0i))) - _e697) + _e392);
                        }
                        let _e705 = phi_1242_;
                        let _e715 = (_e705 <= 0i);
                        if _e715 {
                            phi_1265_ = u32();
                        } else {
                            if _e694 {
                                phi_1264_ = u32();
                            } else {
                                phi_1264_ = select(((bitcast<u32>(_e705) << bitcast<u32>(23i)) | ((_e687 << bitcast<u32>(((_e697 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e705 >= 255i));
                            }
                            let _e719 = phi_1264_;
                            phi_1265_ = _e719;
                        }
                        let _e721 = phi_1265_;
                        phi_1273_ = bitcast<f32>(((_e368 & 2147483648u) | select(_e721, 0u, select(_e694, true, _e715))));
                        phi_1274_ = bitcast<f32>(((_e358 & 2147483648u) | select(_e675, 0u, select(_e648, true, _e669))));
                    } else {
                        phi_1273_ = 0f;
                        phi_1274_ = 1f;
                    }
                    let _e727 = phi_1273_;
                    let _e729 = phi_1274_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e116), bitcast<f32>(_e120), bitcast<f32>(_e124));
                    let _e736 = (_e411 % 3u);
                    let _e737 = (_e736 < 3u);
                    if _e737 {
                    } else {
                        break;
                    }
                    let _e739 = local_9[_e736];
                    let _e740 = (_e410 % 3u);
                    let _e741 = (_e740 < 3u);
                    if _e741 {
                    } else {
                        break;
                    }
                    let _e743 = local_9[_e740];
                    let _e744 = (_e412 % 3u);
                    let _e745 = (_e744 < 3u);
                    if _e745 {
                    } else {
                        break;
                    }
                    let _e747 = local_9[_e744];
                    local_8 = array<f32, 3>(bitcast<f32>(_e128), bitcast<f32>(_e132), bitcast<f32>(_e136));
                    if _e737 {
                    } else {
                        break;
                    }
                    let _e751 = local_8[_e736];
                    if _e741 {
                    } else {
                        break;
                    }
                    let _e753 = local_8[_e740];
                    if _e745 {
                    } else {
                        break;
                    }
                    let _e755 = local_8[_e744];
                    phi_4191_ = false;
                    phi_1357_ = type_43(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e727);
                    phi_1360_ = (_e729 <= _e727);
                    phi_1362_ = type_62(type_60(array<f32, 3>(_e739, _e743, _e747), array<f32, 3>(_e751, _e753, _e755)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_1364_ = 0u;
                    phi_1366_ = ((3u * _e98) + 1u);
                    loop {
                        let _e761 = phi_4191_;
                        let _e763 = phi_1357_;
                        let _e765 = phi_1360_;
                        let _e767 = phi_1362_;
                        let _e769 = phi_1364_;
                        let _e771 = phi_1366_;
                        local_11 = _e763;
                        if _e765 {
                            phi_1377_ = true;
                        } else {
                            phi_1377_ = (_e769 > 0u);
                        }
                        let _e774 = phi_1377_;
                        if _e774 {
                            let _e775 = (_e771 > 0u);
                            if _e775 {
                                if _e765 {
                                    phi_1463_ = _e765;
                                    phi_1464_ = _e767;
                                    phi_1465_ = _e769;
                                } else {
                                    let _e776 = (_e769 - 1u);
                                    let _e777 = (_e776 % 128u);
                                    let _e778 = (_e777 < 128u);
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e780 = local_6[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e782 = local_5[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e784 = local_4[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e786 = local_3[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e789 = local_2[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e791 = local_1[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e793 = local[_e777];
                                    if _e778 {
                                    } else {
                                        phi_4370_ = true;
                                        break;
                                    }
                                    let _e798 = local_7[_e777];
                                    phi_1463_ = (_e798 <= _e763.member_1);
                                    phi_1464_ = type_62(type_60(array<f32, 3>(_e782, _e784, _e786), array<f32, 3>(_e789, _e791, _e793)), _e780);
                                    phi_1465_ = _e776;
                                }
                                let _e802 = phi_1463_;
                                let _e804 = phi_1464_;
                                let _e806 = phi_1465_;
                                if _e802 {
                                    if ((_e804.member_1 & 2147483648u) != 0u) {
                                        phi_1483_ = _e763;
                                        phi_1486_ = type_8(0u, ((_e804.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1181 = phi_1483_;
                                            let _e1183 = phi_1486_;
                                            local_10 = _e1181;
                                            local_12 = _e1181;
                                            if (_e1183.member < _e1183.member_1) {
                                                phi_1487_ = type_8((_e1183.member + 1u), _e1183.member_1);
                                                phi_1509_ = type_8(1u, _e1183.member);
                                            } else {
                                                phi_1487_ = _e1183;
                                                phi_1509_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1196 = phi_1487_;
                                            let _e1198 = phi_1509_;
                                            let _e1202 = (bitcast<i32>(_e1198.member) != 0i);
                                            if _e1202 {
                                                let _e1203 = ((_e804.member_1 & 268435455u) + _e1198.member_1);
                                                let _e1204 = (_e1203 < _e100);
                                                if _e1204 {
                                                    if _e1204 {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1208 = global_4.member[_e1203].member_1;
                                                    phi_1530_ = _e1208;
                                                } else {
                                                    phi_1530_ = 4294967295u;
                                                }
                                                let _e1210 = phi_1530_;
                                                if (_e1203 >= _e100) {
                                                    phi_1622_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1204 {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    if (_e736 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1217 = global_4.member[_e1203].member[_e736];
                                                    if (_e740 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_4.member[_e1203].member[_e740];
                                                    if (_e744 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1229 = global_4.member[_e1203].member[_e744];
                                                    let _e1231 = (3u + _e736);
                                                    if (_e1231 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1237 = global_4.member[_e1203].member[_e1231];
                                                    let _e1238 = (3u + _e740);
                                                    if (_e1238 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1244 = global_4.member[_e1203].member[_e1238];
                                                    let _e1245 = (3u + _e744);
                                                    if (_e1245 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1251 = global_4.member[_e1203].member[_e1245];
                                                    let _e1253 = (6u + _e736);
                                                    if (_e1253 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1259 = global_4.member[_e1203].member[_e1253];
                                                    let _e1260 = (6u + _e740);
                                                    if (_e1260 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1266 = global_4.member[_e1203].member[_e1260];
                                                    let _e1267 = (6u + _e744);
                                                    if (_e1267 < 9u) {
                                                    } else {
                                                        phi_4185_ = true;
                                                        break;
                                                    }
                                                    let _e1273 = global_4.member[_e1203].member[_e1267];
                                                    phi_1622_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1217, _e1223, _e1229), array<f32, 3>(_e1237, _e1244, _e1251), array<f32, 3>(_e1259, _e1266, _e1273));
                                                }
                                                let _e1277 = phi_1622_;
                                                let _e1293 = (_e1277[0][2] - _e587);
                                                let _e1296 = (((_e1277[0][0] - _e458) * _e623) - (_e1293 * _e495));
                                                let _e1299 = (((_e1277[0][1] - _e523) * _e623) - (_e1293 * _e559));
                                                let _e1302 = (_e1277[1][2] - _e587);
                                                let _e1305 = (((_e1277[1][0] - _e458) * _e623) - (_e1302 * _e495));
                                                let _e1308 = (((_e1277[1][1] - _e523) * _e623) - (_e1302 * _e559));
                                                let _e1311 = (_e1277[2][2] - _e587);
                                                let _e1314 = (((_e1277[2][0] - _e458) * _e623) - (_e1311 * _e495));
                                                let _e1317 = (((_e1277[2][1] - _e523) * _e623) - (_e1311 * _e559));
                                                let _e1318 = (_e1314 * _e1308);
                                                let _e1319 = (_e1317 * _e1305);
                                                let _e1320 = (_e1296 * _e1317);
                                                let _e1321 = (_e1299 * _e1314);
                                                let _e1322 = (_e1305 * _e1299);
                                                let _e1323 = (_e1308 * _e1296);
                                                let _e1328 = (((_e1318 >= _e1319) && (_e1320 >= _e1321)) && (_e1322 >= _e1323));
                                                let _e1334 = (_e1328 || (((_e1318 <= _e1319) && (_e1320 <= _e1321)) && (_e1322 <= _e1323)));
                                                if _e1334 {
                                                    let _e1336 = select(-1f, 1f, _e1328);
                                                    let _e1338 = ((_e1318 - _e1319) * _e1336);
                                                    let _e1340 = select(0f, _e1338, (_e1338 > 0f));
                                                    let _e1342 = ((_e1320 - _e1321) * _e1336);
                                                    let _e1344 = select(0f, _e1342, (_e1342 > 0f));
                                                    let _e1346 = ((_e1322 - _e1323) * _e1336);
                                                    let _e1348 = select(0f, _e1346, (_e1346 > 0f));
                                                    let _e1350 = ((_e1340 + _e1344) + _e1348);
                                                    let _e1352 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] < _e1277[1][0]));
                                                    let _e1356 = select(_e1277[1][0], _e1277[0][0], (_e1277[0][0] > _e1277[1][0]));
                                                    let _e1360 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] < _e1277[1][1]));
                                                    let _e1364 = select(_e1277[1][1], _e1277[0][1], (_e1277[0][1] > _e1277[1][1]));
                                                    let _e1368 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] < _e1277[1][2]));
                                                    let _e1372 = select(_e1277[1][2], _e1277[0][2], (_e1277[0][2] > _e1277[1][2]));
                                                    let _e1377 = ((select(_e1277[2][0], _e1352, (_e1352 < _e1277[2][0])) - _e496) * _e499);
                                                    let _e1378 = ((select(_e1277[2][0], _e1356, (_e1356 > _e1277[2][0])) - _e497) * _e499);
                                                    let _e1381 = ((select(_e1277[2][1], _e1360, (_e1360 < _e1277[2][1])) - _e560) * _e563);
                                                    let _e1382 = ((select(_e1277[2][1], _e1364, (_e1364 > _e1277[2][1])) - _e561) * _e563);
                                                    let _e1385 = ((select(_e1277[2][2], _e1368, (_e1368 < _e1277[2][2])) - _e624) * _e627);
                                                    let _e1386 = ((select(_e1277[2][2], _e1372, (_e1372 > _e1277[2][2])) - _e625) * _e627);
                                                    let _e1388 = select(_e1386, _e1385, (_e1385 < _e1386));
                                                    let _e1390 = select(_e1386, _e1385, (_e1385 > _e1386));
                                                    let _e1392 = select(_e1378, _e1377, (_e1377 < _e1378));
                                                    let _e1394 = select(_e1382, _e1381, (_e1381 < _e1382));
                                                    let _e1396 = select(_e1394, _e1392, (_e1392 > _e1394));
                                                    let _e1398 = select(_e1388, _e1396, (_e1396 > _e1388));
                                                    let _e1400 = select(_e1378, _e1377, (_e1377 > _e1378));
                                                    let _e1402 = select(_e1382, _e1381, (_e1381 > _e1382));
                                                    let _e1404 = select(_e1402, _e1400, (_e1400 < _e1402));
                                                    let _e1406 = select(_e1390, _e1404, (_e1404 < _e1390));
                                                    let _e1407 = -(_e1388);
                                                    let _e1413 = select(_e729, _e1398, (_e1398 > _e729));
                                                    let _e1417 = select(_e1305, _e1296, (_e1296 < _e1305));
                                                    let _e1422 = select(_e1305, _e1296, (_e1296 > _e1305));
                                                    let _e1429 = select(_e1308, _e1299, (_e1299 < _e1308));
                                                    let _e1434 = select(_e1308, _e1299, (_e1299 > _e1308));
                                                    let _e1443 = (((((_e1334 && (_e1350 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1314, _e1417, (_e1417 < _e1314)) <= 0f) && (select(_e1314, _e1422, (_e1422 > _e1314)) >= 0f))) && ((select(_e1317, _e1429, (_e1429 < _e1317)) <= 0f) && (select(_e1317, _e1434, (_e1434 > _e1317)) >= 0f))) && (_e1413 <= (_e1406 + (select(_e1407, _e1390, (_e1390 > _e1407)) * 0.0000019073523f)))) && (_e1413 <= _e1181.member_1));
                                                    if _e1443 {
                                                        let _e1448 = (_e1277[1][0] - _e1277[0][0]);
                                                        let _e1449 = (_e1277[1][1] - _e1277[0][1]);
                                                        let _e1450 = (_e1277[1][2] - _e1277[0][2]);
                                                        let _e1451 = vec3<f32>(_e1448, _e1449, _e1450);
                                                        let _e1452 = (_e1277[2][0] - _e1277[1][0]);
                                                        let _e1453 = (_e1277[2][1] - _e1277[1][1]);
                                                        let _e1454 = (_e1277[2][2] - _e1277[1][2]);
                                                        let _e1455 = vec3<f32>(_e1452, _e1453, _e1454);
                                                        let _e1456 = (_e1277[0][0] - _e1277[2][0]);
                                                        let _e1457 = (_e1277[0][1] - _e1277[2][1]);
                                                        let _e1458 = (_e1277[0][2] - _e1277[2][2]);
                                                        let _e1459 = vec3<f32>(_e1456, _e1457, _e1458);
                                                        let _e1462 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                        let _e1465 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                        let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                        let _e1470 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                        let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1453) & 2147483647u));
                                                        let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u));
                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                        let _e1488 = bitcast<f32>((bitcast<u32>(_e1456) & 2147483647u));
                                                        let _e1491 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                        let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                        let _e1496 = bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u));
                                                        let _e1498 = select(_e1496, _e1493, (_e1493 > _e1496));
                                                        let _e1500 = select(_e1485, _e1472, (_e1472 > _e1485));
                                                        let _e1502 = select(_e1498, _e1500, (_e1500 > _e1498));
                                                        if (_e1472 == _e1502) {
                                                            phi_2152_ = _e1308;
                                                            phi_2153_ = _e1305;
                                                            phi_2154_ = _e1299;
                                                            phi_2155_ = _e1296;
                                                            phi_2156_ = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                            phi_2157_ = _e1459;
                                                            phi_2158_ = _e1455;
                                                            phi_2159_ = _e1451;
                                                        } else {
                                                            let _e1504 = (_e1485 == _e1502);
                                                            let _e1509 = vec3(_e1504);
                                                            phi_2152_ = select(_e1299, _e1317, _e1504);
                                                            phi_2153_ = select(_e1296, _e1314, _e1504);
                                                            phi_2154_ = select(_e1317, _e1308, _e1504);
                                                            phi_2155_ = select(_e1314, _e1305, _e1504);
                                                            phi_2156_ = select(vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]), vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]), _e1509);
                                                            phi_2157_ = select(_e1455, _e1451, _e1509);
                                                            phi_2158_ = select(_e1451, _e1459, _e1509);
                                                            phi_2159_ = select(_e1459, _e1455, _e1509);
                                                        }
                                                        let _e1515 = phi_2152_;
                                                        let _e1517 = phi_2153_;
                                                        let _e1519 = phi_2154_;
                                                        let _e1521 = phi_2155_;
                                                        let _e1523 = phi_2156_;
                                                        let _e1525 = phi_2157_;
                                                        let _e1527 = phi_2158_;
                                                        let _e1529 = phi_2159_;
                                                        let _e1536 = ((_e1527.y * _e1525.z) - (_e1525.y * _e1527.z));
                                                        let _e1541 = ((_e1527.z * _e1525.x) - (_e1525.z * _e1527.x));
                                                        let _e1544 = ((_e1527.x * _e1525.y) - (_e1525.x * _e1527.y));
                                                        let _e1547 = ((_e1340 >= _e1344) && (_e1340 >= _e1348));
                                                        let _e1548 = (_e1344 >= _e1348);
                                                        let _e1562 = (((_e1536 * (select(select(_e1277[2][0], _e1277[1][0], _e1548), _e1277[0][0], _e1547) - _e458)) + (_e1541 * (select(select(_e1277[2][1], _e1277[1][1], _e1548), _e1277[0][1], _e1547) - _e523))) + (_e1544 * (select(select(_e1277[2][2], _e1277[1][2], _e1548), _e1277[0][2], _e1547) - _e587)));
                                                        let _e1567 = (((_e1536 * _e495) + (_e1541 * _e559)) + (_e1544 * _e623));
                                                        let _e1568 = (_e1517 - _e1521);
                                                        let _e1569 = (_e1515 - _e1519);
                                                        let _e1572 = ((_e1568 * _e1568) + (_e1569 * _e1569));
                                                        let _e1579 = (-(((_e1521 * _e1568) + (_e1519 * _e1569))) / select(0.000000000000000000000000000000000000011754944f, _e1572, (_e1572 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1581 = select(1f, _e1579, (_e1579 < 1f));
                                                        let _e1583 = select(0f, _e1581, (_e1581 > 0f));
                                                        let _e1592 = ((_e1523.x + (_e1529.x * _e1583)) - _e458);
                                                        let _e1595 = ((_e1523.y + (_e1529.y * _e1583)) - _e523);
                                                        let _e1598 = ((_e1523.z + (_e1529.z * _e1583)) - _e587);
                                                        let _e1601 = bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u));
                                                        let _e1604 = bitcast<f32>((bitcast<u32>(_e1595) & 2147483647u));
                                                        let _e1606 = select(_e1604, _e1601, (_e1601 > _e1604));
                                                        let _e1609 = bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u));
                                                        let _e1611 = select(_e1609, _e1606, (_e1606 > _e1609));
                                                        let _e1617 = bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u));
                                                        let _e1620 = bitcast<f32>((bitcast<u32>(_e1541) & 2147483647u));
                                                        let _e1622 = select(_e1620, _e1617, (_e1617 > _e1620));
                                                        let _e1625 = bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u));
                                                        let _e1644 = bitcast<f32>((bitcast<u32>(_e1527.x) & 2147483647u));
                                                        let _e1647 = bitcast<f32>((bitcast<u32>(_e1527.y) & 2147483647u));
                                                        let _e1649 = select(_e1647, _e1644, (_e1644 > _e1647));
                                                        let _e1652 = bitcast<f32>((bitcast<u32>(_e1527.z) & 2147483647u));
                                                        let _e1658 = bitcast<f32>((bitcast<u32>(_e1525.x) & 2147483647u));
                                                        let _e1661 = bitcast<f32>((bitcast<u32>(_e1525.y) & 2147483647u));
                                                        let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                                        let _e1666 = bitcast<f32>((bitcast<u32>(_e1525.z) & 2147483647u));
                                                        let _e1672 = ((bitcast<f32>((bitcast<u32>(((((_e1536 * _e1592) + (_e1541 * _e1595)) + (_e1544 * _e1598)) - _e1562)) & 2147483647u)) <= ((0.0000009536743f * select(_e1502, _e1611, (_e1611 > _e1502))) * select(_e1625, _e1622, (_e1622 > _e1625)))) && !((bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u)) <= ((0.0000038146973f * select(_e1652, _e1649, (_e1649 > _e1652))) * select(_e1666, _e1663, (_e1663 > _e1666))))));
                                                        let _e1673 = (_e1562 / _e1567);
                                                        if (_e1443 && !(_e1672)) {
                                                            let _e1676 = (_e1598 / _e623);
                                                            let _e1684 = (((_e1536 * (_e1592 - (_e495 * _e1676))) + (_e1541 * (_e1595 - (_e559 * _e1676)))) / _e1567);
                                                            phi_2350_ = select(select(_e1676, (_e1676 + _e1684), (bitcast<f32>((bitcast<u32>(_e1684) & 2147483647u)) <= _e1502)), _e1673, _e1672);
                                                        } else {
                                                            phi_2350_ = _e1673;
                                                        }
                                                        let _e1693 = phi_2350_;
                                                        let _e1695 = select(_e1406, _e1693, (_e1693 < _e1406));
                                                        let _e1697 = select(_e1398, _e1695, (_e1695 > _e1398));
                                                        let _e1698 = (1f / _e1350);
                                                        phi_2370_ = type_46(_e1697, (_e1344 * _e1698), (_e1348 * _e1698), ((_e1443 && (_e1697 >= _e729)) && (_e1697 <= _e1181.member_1)));
                                                        phi_2371_ = type_46();
                                                    } else {
                                                        phi_2370_ = type_46();
                                                        phi_2371_ = type_46(0f, 0f, 0f, _e1443);
                                                    }
                                                    let _e1707 = phi_2370_;
                                                    let _e1709 = phi_2371_;
                                                    phi_2374_ = _e1707;
                                                    phi_2375_ = _e1709;
                                                    phi_2376_ = select(true, false, _e1443);
                                                } else {
                                                    phi_2374_ = type_46();
                                                    phi_2375_ = type_46(0f, 0f, 0f, _e1334);
                                                    phi_2376_ = true;
                                                }
                                                let _e1712 = phi_2374_;
                                                let _e1714 = phi_2375_;
                                                let _e1716 = phi_2376_;
                                                if _e1716 {
                                                    phi_2380_ = _e1714;
                                                } else {
                                                    phi_2380_ = _e1712;
                                                }
                                                let _e1718 = phi_2380_;
                                                if _e1718.member_3 {
                                                    phi_2389_ = type_27(_e1718.member, _e1718.member_1, _e1718.member_2, _e1210);
                                                } else {
                                                    phi_2389_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1725 = phi_2389_;
                                                if (_e1725.member_3 != 4294967295u) {
                                                    if (_e1210 == _e157) {
                                                        phi_2724_ = false;
                                                    } else {
                                                        let _e1729 = (_e1210 < arrayLength((&global_5.member)));
                                                        if _e1729 {
                                                            if _e1729 {
                                                            } else {
                                                                phi_4185_ = true;
                                                                break;
                                                            }
                                                            let _e1731 = global_5.member[_e1210];
                                                            phi_2412_ = _e1731;
                                                        } else {
                                                            phi_2412_ = 4294967295u;
                                                        }
                                                        let _e1733 = phi_2412_;
                                                        let _e1734 = (_e1733 < arrayLength((&global_6.member)));
                                                        if _e1734 {
                                                            if _e1734 {
                                                            } else {
                                                                phi_4185_ = true;
                                                                break;
                                                            }
                                                            let _e1736 = global_6.member[_e1733];
                                                            phi_2426_ = _e1736;
                                                        } else {
                                                            phi_2426_ = 0i;
                                                        }
                                                        let _e1738 = phi_2426_;
                                                        let _e1739 = (_e1738 == 0i);
                                                        if _e1739 {
                                                            phi_2723_ = true;
                                                        } else {
                                                            if _e435 {
                                                                phi_2449_ = vec3<f32>(_e1277[0][0], _e1277[0][1], _e1277[0][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2448_ = vec3<f32>(_e1277[0][2], _e1277[0][0], _e1277[0][1]);
                                                                } else {
                                                                    phi_2448_ = vec3<f32>(_e1277[0][1], _e1277[0][2], _e1277[0][0]);
                                                                }
                                                                let _e1744 = phi_2448_;
                                                                phi_2449_ = _e1744;
                                                            }
                                                            let _e1747 = phi_2449_;
                                                            if _e435 {
                                                                phi_2468_ = vec3<f32>(_e1277[1][0], _e1277[1][1], _e1277[1][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2467_ = vec3<f32>(_e1277[1][2], _e1277[1][0], _e1277[1][1]);
                                                                } else {
                                                                    phi_2467_ = vec3<f32>(_e1277[1][1], _e1277[1][2], _e1277[1][0]);
                                                                }
                                                                let _e1752 = phi_2467_;
                                                                phi_2468_ = _e1752;
                                                            }
                                                            let _e1755 = phi_2468_;
                                                            if _e435 {
                                                                phi_2487_ = vec3<f32>(_e1277[2][0], _e1277[2][1], _e1277[2][2]);
                                                            } else {
                                                                if (_e411 == 1u) {
                                                                    phi_2486_ = vec3<f32>(_e1277[2][2], _e1277[2][0], _e1277[2][1]);
                                                                } else {
                                                                    phi_2486_ = vec3<f32>(_e1277[2][1], _e1277[2][2], _e1277[2][0]);
                                                                }
                                                                let _e1760 = phi_2486_;
                                                                phi_2487_ = _e1760;
                                                            }
                                                            let _e1763 = phi_2487_;
                                                            let _e1766 = (_e1755.x - _e1747.x);
                                                            let _e1769 = (_e1755.y - _e1747.y);
                                                            let _e1772 = (_e1755.z - _e1747.z);
                                                            let _e1774 = (_e1763.x - _e1747.x);
                                                            let _e1776 = (_e1763.y - _e1747.y);
                                                            let _e1778 = (_e1763.z - _e1747.z);
                                                            if (_e289.member_1 == 1u) {
                                                                phi_2523_ = (vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]) - _e1747);
                                                            } else {
                                                                phi_2523_ = vec3<f32>(_e289.member[0], _e289.member[1], _e289.member[2]);
                                                            }
                                                            let _e1793 = phi_2523_;
                                                            let _e1799 = bitcast<f32>((bitcast<u32>((_e1766 * _e1776)) ^ _e289.member_3[0]));
                                                            let _e1803 = bitcast<f32>((bitcast<u32>((_e1769 * _e1774)) ^ _e289.member_3[0]));
                                                            let _e1807 = bitcast<f32>((bitcast<u32>((_e1769 * _e1778)) ^ _e289.member_3[0]));
                                                            let _e1811 = bitcast<f32>((bitcast<u32>((_e1772 * _e1776)) ^ _e289.member_3[0]));
                                                            let _e1815 = bitcast<f32>((bitcast<u32>((_e1772 * _e1774)) ^ _e289.member_3[0]));
                                                            let _e1819 = bitcast<f32>((bitcast<u32>((_e1766 * _e1778)) ^ _e289.member_3[0]));
                                                            let _e1820 = (_e1807 - _e1811);
                                                            let _e1821 = (_e1815 - _e1819);
                                                            let _e1822 = (_e1799 - _e1803);
                                                            let _e1846 = (bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1811) & 2147483647u)));
                                                            let _e1853 = (bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1819) & 2147483647u)));
                                                            let _e1860 = (bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u)));
                                                            if (_e289.member_2 == 0f) {
                                                                phi_2705_ = 0f;
                                                            } else {
                                                                let _e1890 = bitcast<f32>((bitcast<u32>(_e1820) & 2147483647u));
                                                                let _e1893 = bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u));
                                                                let _e1896 = bitcast<f32>((bitcast<u32>(_e1822) & 2147483647u));
                                                                let _e1898 = select(_e1896, _e1893, (_e1893 > _e1896));
                                                                let _e1902 = select(_e1896, _e1893, (_e1893 < _e1896));
                                                                let _e1906 = select(_e1893, _e1890, (_e1890 < _e1893));
                                                                let _e1908 = select(_e1893, _e1890, (_e1890 > _e1893));
                                                                let _e1910 = select(_e1896, _e1908, (_e1908 < _e1896));
                                                                phi_2705_ = bitcast<f32>((bitcast<u32>((_e289.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1898, _e1890, (_e1890 > _e1898)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1910, _e1906, (_e1906 > _e1910)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1902, _e1890, (_e1890 < _e1902)))) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1846 + _e1853) + _e1860))) ^ _e289.member_3[0]))) * 1.0000005f)) ^ _e289.member_3[0])))) ^ _e289.member_3[0]));
                                                            }
                                                            let _e1937 = phi_2705_;
                                                            phi_2723_ = (_e1739 || !(((((bitcast<f32>((bitcast<u32>((_e1793.x * _e1820)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1793.y * _e1821)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1793.z * _e1822)) ^ _e289.member_3[0]))) * f32(-(_e1738))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1793.x) & 2147483647u)) * _e1846)) ^ _e289.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1793.y) & 2147483647u)) * _e1853)) ^ _e289.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1793.z) & 2147483647u)) * _e1860)) ^ _e289.member_3[0]))))) ^ _e289.member_3[0])) + _e1937) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1951 = phi_2723_;
                                                        phi_2724_ = _e1951;
                                                    }
                                                    let _e1953 = phi_2724_;
                                                    if _e1953 {
                                                        if (_e1725.member < _e1181.member.member) {
                                                            phi_2744_ = true;
                                                        } else {
                                                            if (_e1725.member == _e1181.member.member) {
                                                                phi_2743_ = (_e1725.member_3 < _e1181.member.member_3);
                                                            } else {
                                                                phi_2743_ = false;
                                                            }
                                                            let _e1963 = phi_2743_;
                                                            phi_2744_ = _e1963;
                                                        }
                                                        let _e1965 = phi_2744_;
                                                        if _e1965 {
                                                            phi_2750_ = type_43(_e1725, _e1725.member);
                                                        } else {
                                                            phi_2750_ = _e1181;
                                                        }
                                                        let _e1968 = phi_2750_;
                                                        phi_2751_ = _e1968;
                                                    } else {
                                                        phi_2751_ = _e1181;
                                                    }
                                                    let _e1970 = phi_2751_;
                                                    phi_2752_ = _e1970;
                                                } else {
                                                    phi_2752_ = _e1181;
                                                }
                                                let _e1972 = phi_2752_;
                                                phi_1484_ = _e1972;
                                            } else {
                                                phi_1484_ = type_43();
                                            }
                                            let _e1974 = phi_1484_;
                                            continue;
                                            continuing {
                                                phi_1483_ = _e1974;
                                                phi_1486_ = _e1196;
                                                phi_4185_ = _e761;
                                                break if !(_e1202);
                                            }
                                        }
                                        let _e1977 = phi_4185_;
                                        phi_4370_ = _e1977;
                                        if _e1977 {
                                            break;
                                        }
                                        let _e1979 = local_10;
                                        phi_4374_ = _e1977;
                                        let _e2284 = local_12;
                                        phi_3756_ = _e2284;
                                        phi_3757_ = false;
                                        phi_3758_ = _e804;
                                        phi_3759_ = select(_e806, 0u, (_e729 > _e1979.member_1));
                                    } else {
                                        let _e815 = (_e804.member_1 < _e98);
                                        if _e815 {
                                            if _e815 {
                                            } else {
                                                phi_4370_ = true;
                                                break;
                                            }
                                            let _e817 = global_10.member[_e804.member_1];
                                            phi_2773_ = _e817;
                                        } else {
                                            phi_2773_ = type_55(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e819 = phi_2773_;
                                        let _e834 = ((10u * _e411) & 31u);
                                        let _e837 = ((_e819.member[0] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e845 = bitcast<f32>((bitcast<u32>(((_e804.member.member_1[0] - _e804.member.member[0]) * 0.0009775171f)) ^ _e140));
                                        let _e850 = (_e804.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e837)) - 8388608f) * _e845)) ^ _e140)));
                                        let _e854 = select(select(_e804.member.member_1[0], _e850, (_e850 < _e804.member.member_1[0])), _e804.member.member_1[0], (_e837 == 1023u));
                                        let _e856 = ((10u * _e410) & 31u);
                                        let _e859 = ((_e819.member[0] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e867 = bitcast<f32>((bitcast<u32>(((_e804.member.member_1[1] - _e804.member.member[1]) * 0.0009775171f)) ^ _e140));
                                        let _e872 = (_e804.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e859)) - 8388608f) * _e867)) ^ _e140)));
                                        let _e876 = select(select(_e804.member.member_1[1], _e872, (_e872 < _e804.member.member_1[1])), _e804.member.member_1[1], (_e859 == 1023u));
                                        let _e878 = ((10u * _e412) & 31u);
                                        let _e881 = ((_e819.member[0] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e889 = bitcast<f32>((bitcast<u32>(((_e804.member.member_1[2] - _e804.member.member[2]) * 0.0009775171f)) ^ _e140));
                                        let _e894 = (_e804.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e889)) ^ _e140)));
                                        let _e898 = select(select(_e804.member.member_1[2], _e894, (_e894 < _e804.member.member_1[2])), _e804.member.member_1[2], (_e881 == 1023u));
                                        let _e901 = ((_e819.member[1] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e909 = (_e804.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e901)) - 8388608f) * _e845)) ^ _e140)));
                                        let _e913 = select(select(_e804.member.member_1[0], _e909, (_e909 < _e804.member.member_1[0])), _e804.member.member_1[0], (_e901 == 1023u));
                                        let _e916 = ((_e819.member[1] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e924 = (_e804.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e916)) - 8388608f) * _e867)) ^ _e140)));
                                        let _e928 = select(select(_e804.member.member_1[1], _e924, (_e924 < _e804.member.member_1[1])), _e804.member.member_1[1], (_e916 == 1023u));
                                        let _e931 = ((_e819.member[1] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e939 = (_e804.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e889)) ^ _e140)));
                                        let _e943 = select(select(_e804.member.member_1[2], _e939, (_e939 < _e804.member.member_1[2])), _e804.member.member_1[2], (_e931 == 1023u));
                                        let _e949 = ((_e819.member_1[0] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e957 = (_e804.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e949)) - 8388608f) * _e845)) ^ _e140)));
                                        let _e961 = select(select(_e804.member.member_1[0], _e957, (_e957 < _e804.member.member_1[0])), _e804.member.member_1[0], (_e949 == 1023u));
                                        let _e964 = ((_e819.member_1[0] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e972 = (_e804.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e964)) - 8388608f) * _e867)) ^ _e140)));
                                        let _e976 = select(select(_e804.member.member_1[1], _e972, (_e972 < _e804.member.member_1[1])), _e804.member.member_1[1], (_e964 == 1023u));
                                        let _e979 = ((_e819.member_1[0] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e987 = (_e804.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e979)) - 8388608f) * _e889)) ^ _e140)));
                                        let _e991 = select(select(_e804.member.member_1[2], _e987, (_e987 < _e804.member.member_1[2])), _e804.member.member_1[2], (_e979 == 1023u));
                                        let _e994 = ((_e819.member_1[1] >> bitcast<u32>(_e834)) & 1023u);
                                        let _e1002 = (_e804.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e994)) - 8388608f) * _e845)) ^ _e140)));
                                        let _e1006 = select(select(_e804.member.member_1[0], _e1002, (_e1002 < _e804.member.member_1[0])), _e804.member.member_1[0], (_e994 == 1023u));
                                        let _e1009 = ((_e819.member_1[1] >> bitcast<u32>(_e856)) & 1023u);
                                        let _e1017 = (_e804.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1009)) - 8388608f) * _e867)) ^ _e140)));
                                        let _e1021 = select(select(_e804.member.member_1[1], _e1017, (_e1017 < _e804.member.member_1[1])), _e804.member.member_1[1], (_e1009 == 1023u));
                                        let _e1024 = ((_e819.member_1[1] >> bitcast<u32>(_e878)) & 1023u);
                                        let _e1032 = (_e804.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1024)) - 8388608f) * _e889)) ^ _e140)));
                                        let _e1036 = select(select(_e804.member.member_1[2], _e1032, (_e1032 < _e804.member.member_1[2])), _e804.member.member_1[2], (_e1024 == 1023u));
                                        let _e1041 = type_62(type_60(array<f32, 3>(_e854, _e876, _e898), array<f32, 3>(_e913, _e928, _e943)), _e819.member_2);
                                        let _e1046 = type_62(type_60(array<f32, 3>(_e961, _e976, _e991), array<f32, 3>(_e1006, _e1021, _e1036)), _e819.member_3);
                                        let _e1052 = ((_e854 - _e496) * _e499);
                                        let _e1053 = ((_e961 - _e496) * _e499);
                                        let _e1054 = ((_e913 - _e497) * _e499);
                                        let _e1055 = ((_e1006 - _e497) * _e499);
                                        let _e1060 = ((_e876 - _e560) * _e563);
                                        let _e1061 = ((_e976 - _e560) * _e563);
                                        let _e1062 = ((_e928 - _e561) * _e563);
                                        let _e1063 = ((_e1021 - _e561) * _e563);
                                        let _e1068 = ((_e898 - _e624) * _e627);
                                        let _e1069 = ((_e991 - _e624) * _e627);
                                        let _e1070 = ((_e943 - _e625) * _e627);
                                        let _e1071 = ((_e1036 - _e625) * _e627);
                                        let _e1073 = select(_e1070, _e1068, (_e1068 < _e1070));
                                        let _e1075 = select(_e1071, _e1069, (_e1069 < _e1071));
                                        let _e1077 = select(_e1070, _e1068, (_e1068 > _e1070));
                                        let _e1079 = select(_e1071, _e1069, (_e1069 > _e1071));
                                        let _e1081 = select(_e1054, _e1052, (_e1052 < _e1054));
                                        let _e1083 = select(_e1055, _e1053, (_e1053 < _e1055));
                                        let _e1085 = select(_e1062, _e1060, (_e1060 < _e1062));
                                        let _e1087 = select(_e1063, _e1061, (_e1061 < _e1063));
                                        let _e1089 = select(_e1085, _e1081, (_e1081 > _e1085));
                                        let _e1091 = select(_e1087, _e1083, (_e1083 > _e1087));
                                        let _e1093 = select(_e1073, _e1089, (_e1089 > _e1073));
                                        let _e1095 = select(_e1075, _e1091, (_e1091 > _e1075));
                                        let _e1097 = select(_e1054, _e1052, (_e1052 > _e1054));
                                        let _e1099 = select(_e1055, _e1053, (_e1053 > _e1055));
                                        let _e1101 = select(_e1062, _e1060, (_e1060 > _e1062));
                                        let _e1103 = select(_e1063, _e1061, (_e1061 > _e1063));
                                        let _e1105 = select(_e1101, _e1097, (_e1097 < _e1101));
                                        let _e1107 = select(_e1103, _e1099, (_e1099 < _e1103));
                                        let _e1112 = -(_e1073);
                                        let _e1113 = -(_e1075);
                                        let _e1120 = (select(_e1077, _e1105, (_e1105 < _e1077)) + (select(_e1112, _e1077, (_e1077 > _e1112)) * 0.0000019073523f));
                                        let _e1121 = (select(_e1079, _e1107, (_e1107 < _e1079)) + (select(_e1113, _e1079, (_e1079 > _e1113)) * 0.0000019073523f));
                                        let _e1123 = select(_e729, _e1093, (_e1093 > _e729));
                                        let _e1125 = select(_e729, _e1095, (_e1095 > _e729));
                                        let _e1130 = (_e1123 <= select(_e763.member_1, _e1120, (_e1120 < _e763.member_1)));
                                        let _e1131 = (_e1125 <= select(_e763.member_1, _e1121, (_e1121 < _e763.member_1)));
                                        let _e1132 = (_e1123 <= _e1125);
                                        if _e1130 {
                                            if _e1131 {
                                                if _e1132 {
                                                    phi_3659_ = _e1046;
                                                } else {
                                                    phi_3659_ = _e1041;
                                                }
                                                let _e1134 = phi_3659_;
                                                let _e1141 = (_e806 % 128u);
                                                let _e1142 = (_e1141 < 128u);
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_6[_e1141] = _e1134.member_1;
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_5[_e1141] = _e1134.member.member[0];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_4[_e1141] = _e1134.member.member[1];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_3[_e1141] = _e1134.member.member[2];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_2[_e1141] = _e1134.member.member_1[0];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_1[_e1141] = _e1134.member.member_1[1];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local[_e1141] = _e1134.member.member_1[2];
                                                if _e1142 {
                                                } else {
                                                    phi_4370_ = true;
                                                    break;
                                                }
                                                local_7[_e1141] = select(_e1123, _e1125, _e1132);
                                                if _e1132 {
                                                    phi_3735_ = _e1041;
                                                } else {
                                                    phi_3735_ = _e1046;
                                                }
                                                let _e1159 = phi_3735_;
                                                phi_3736_ = _e1159;
                                                phi_3737_ = (_e806 + 1u);
                                            } else {
                                                phi_3736_ = type_62();
                                                phi_3737_ = u32();
                                            }
                                            let _e1161 = phi_3736_;
                                            let _e1163 = phi_3737_;
                                            phi_3739_ = _e1161;
                                            phi_3740_ = _e1163;
                                            phi_3741_ = select(true, false, _e1131);
                                        } else {
                                            phi_3739_ = type_62();
                                            phi_3740_ = u32();
                                            phi_3741_ = true;
                                        }
                                        let _e1166 = phi_3739_;
                                        let _e1168 = phi_3740_;
                                        let _e1170 = phi_3741_;
                                        if _e1170 {
                                            if _e1130 {
                                                phi_3748_ = _e1041;
                                            } else {
                                                phi_3748_ = _e1046;
                                            }
                                            let _e1172 = phi_3748_;
                                            phi_3753_ = select(_e1131, true, _e1130);
                                            phi_3754_ = _e1172;
                                        } else {
                                            phi_3753_ = _e802;
                                            phi_3754_ = _e1166;
                                        }
                                        let _e1175 = phi_3753_;
                                        let _e1177 = phi_3754_;
                                        phi_4374_ = _e761;
                                        phi_3756_ = _e763;
                                        phi_3757_ = _e1175;
                                        phi_3758_ = _e1177;
                                        phi_3759_ = select(_e1168, _e806, _e1170);
                                    }
                                    let _e1984 = phi_4374_;
                                    let _e1986 = phi_3756_;
                                    let _e1988 = phi_3757_;
                                    let _e1990 = phi_3758_;
                                    let _e1992 = phi_3759_;
                                    phi_4373_ = _e1984;
                                    phi_3760_ = _e1986;
                                    phi_3761_ = _e1988;
                                    phi_3762_ = _e1990;
                                    phi_3763_ = _e1992;
                                    phi_3764_ = (_e771 - 1u);
                                } else {
                                    phi_4373_ = _e761;
                                    phi_3760_ = _e763;
                                    phi_3761_ = _e802;
                                    phi_3762_ = _e804;
                                    phi_3763_ = _e806;
                                    phi_3764_ = _e771;
                                }
                                let _e1994 = phi_4373_;
                                let _e1996 = phi_3760_;
                                let _e1998 = phi_3761_;
                                let _e2000 = phi_3762_;
                                let _e2002 = phi_3763_;
                                let _e2004 = phi_3764_;
                                phi_4372_ = _e1994;
                                phi_3765_ = _e1996;
                                phi_3766_ = _e1998;
                                phi_3767_ = _e2000;
                                phi_3768_ = _e2002;
                                phi_3769_ = _e2004;
                            } else {
                                phi_4372_ = _e761;
                                phi_3765_ = type_43();
                                phi_3766_ = bool();
                                phi_3767_ = type_62();
                                phi_3768_ = u32();
                                phi_3769_ = u32();
                            }
                            let _e2006 = phi_4372_;
                            let _e2008 = phi_3765_;
                            let _e2010 = phi_3766_;
                            let _e2012 = phi_3767_;
                            let _e2014 = phi_3768_;
                            let _e2016 = phi_3769_;
                            phi_4371_ = _e2006;
                            phi_1358_ = _e2008;
                            phi_1361_ = _e2010;
                            phi_1363_ = _e2012;
                            phi_1365_ = _e2014;
                            phi_1367_ = _e2016;
                            phi_3770_ = _e775;
                        } else {
                            phi_4371_ = _e761;
                            phi_1358_ = type_43();
                            phi_1361_ = bool();
                            phi_1363_ = type_62();
                            phi_1365_ = u32();
                            phi_1367_ = u32();
                            phi_3770_ = false;
                        }
                        let _e2018 = phi_4371_;
                        let _e2020 = phi_1358_;
                        let _e2022 = phi_1361_;
                        let _e2024 = phi_1363_;
                        let _e2026 = phi_1365_;
                        let _e2028 = phi_1367_;
                        let _e2030 = phi_3770_;
                        continue;
                        continuing {
                            phi_4191_ = _e2018;
                            phi_1357_ = _e2020;
                            phi_1360_ = _e2022;
                            phi_1362_ = _e2024;
                            phi_1364_ = _e2026;
                            phi_1366_ = _e2028;
                            phi_4370_ = _e2018;
                            break if !(_e2030);
                        }
                    }
                    let _e2033 = phi_4370_;
                    if _e2033 {
                        break;
                    }
                    let _e2035 = local_11;
                    if (_e2035.member.member_3 != 4294967295u) {
                        let _e2040 = bitcast<u32>(_e2035.member.member);
                        let _e2044 = (bitcast<i32>((_e2040 >> bitcast<u32>(23i))) & 255i);
                        let _e2045 = (_e2044 + _e413);
                        if (_e2044 == 255i) {
                            phi_3829_ = _e2035.member.member;
                        } else {
                            if (_e2044 > 0i) {
                                if (_e2045 > 0i) {
                                    let _e2049 = (_e2045 < 255i);
                                    if _e2049 {
                                        phi_3808_ = bitcast<f32>((_e2040 + bitcast<u32>((_e413 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3808_ = f32();
                                    }
                                    let _e2056 = phi_3808_;
                                    phi_3810_ = _e2056;
                                    phi_3811_ = select(true, false, _e2049);
                                } else {
                                    phi_3810_ = f32();
                                    phi_3811_ = true;
                                }
                                let _e2059 = phi_3810_;
                                let _e2061 = phi_3811_;
                                phi_3812_ = _e2059;
                                phi_3813_ = _e2061;
                            } else {
                                phi_3812_ = f32();
                                phi_3813_ = true;
                            }
                            let _e2063 = phi_3812_;
                            let _e2065 = phi_3813_;
                            if _e2065 {
                                let _e2066 = (_e2040 & 2147483648u);
                                let _e2073 = ((_e2040 & 8388607u) | (select(0u, 1u, ((_e2040 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2077 = (_e2073 == 0u);
                                if _e2077 {
                                    phi_4155_ = bitcast<f32>(_e2066);
                                } else {
                                    let _e2082 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2073)), 32u, _e2077) - 8u);
                                    let _e2085 = (_e2073 << bitcast<u32>((_e2082 & 31u)));
                                    let _e2087 = ((_e2045 + select(0i, 1i, (_e2044 == 0i))) - bitcast<i32>(_e2082));
                                    if (_e2087 >= 255i) {
                                        phi_4145_ = bitcast<f32>((_e2066 | 2139095040u));
                                        phi_4146_ = f32();
                                        phi_4147_ = true;
                                    } else {
                                        let _e2089 = (_e2087 > 0i);
                                        if _e2089 {
                                            phi_4139_ = bitcast<f32>(((_e2066 | (bitcast<u32>(_e2087) << bitcast<u32>(23i))) | (_e2085 & 8388607u)));
                                            phi_4140_ = f32();
                                        } else {
                                            if (_e2087 < -24i) {
                                                phi_4105_ = 26u;
                                            } else {
                                                phi_4105_ = bitcast<u32>((1i - _e2087));
                                            }
                                            let _e2094 = phi_4105_;
                                            let _e2095 = (_e2094 & 31u);
                                            let _e2097 = (_e2085 >> bitcast<u32>(_e2095));
                                            let _e2101 = (_e2085 & ((1u << bitcast<u32>(_e2095)) - 1u));
                                            let _e2105 = (1u << bitcast<u32>(((_e2094 - 1u) & 31u)));
                                            if (_e2101 > _e2105) {
                                                phi_4126_ = true;
                                            } else {
                                                if (_e2101 == _e2105) {
                                                    phi_4123_ = ((_e2097 & 1u) == 1u);
                                                } else {
                                                    phi_4123_ = false;
                                                }
                                                let _e2111 = phi_4123_;
                                                phi_4126_ = _e2111;
                                            }
                                            let _e2113 = phi_4126_;
                                            phi_4139_ = f32();
                                            phi_4140_ = bitcast<f32>((_e2066 | (_e2097 + select(0u, 1u, _e2113))));
                                        }
                                        let _e2126 = phi_4139_;
                                        let _e2128 = phi_4140_;
                                        phi_4145_ = _e2126;
                                        phi_4146_ = _e2128;
                                        phi_4147_ = _e2089;
                                    }
                                    let _e2132 = phi_4145_;
                                    let _e2134 = phi_4146_;
                                    let _e2136 = phi_4147_;
                                    phi_4155_ = select(_e2134, _e2132, _e2136);
                                }
                                let _e2140 = phi_4155_;
                                phi_3828_ = _e2140;
                            } else {
                                phi_3828_ = _e2063;
                            }
                            let _e2142 = phi_3828_;
                            phi_3829_ = _e2142;
                        }
                        let _e2144 = phi_3829_;
                        let _e2145 = bitcast<u32>(_e2144);
                        if ((_e2145 & 2147483647u) >= 2139095040u) {
                            phi_3841_ = bitcast<f32>(((_e2145 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3841_ = _e2144;
                        }
                        let _e2152 = phi_3841_;
                        phi_3846_ = type_27(_e2152, _e2035.member.member_1, _e2035.member.member_2, _e2035.member.member_3);
                    } else {
                        phi_3846_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2157 = phi_3846_;
                    if _e290 {
                    } else {
                        break;
                    }
                    global_8.member[_e144] = _e2157;
                    if _e151 {
                    } else {
                        break;
                    }
                    let _e2161 = select(0u, 1u, (_e357 <= _e367));
                    if (_e2161 > 0u) {
                        let _e2163 = (1u < _e112);
                        if _e2163 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e2167 = atomicAdd((&global_9.member[0u]), _e2161);
                            if ((_e2167 + _e2161) < _e2167) {
                                if _e2163 {
                                } else {
                                    break;
                                }
                                let _e2172 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2175 = select(0u, 1u, (_e2157.member_3 != 4294967295u));
                    if (_e2175 > 0u) {
                        let _e2177 = (3u < _e112);
                        if _e2177 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e2181 = atomicAdd((&global_9.member[2u]), _e2175);
                            if ((_e2181 + _e2175) < _e2181) {
                                if _e2177 {
                                } else {
                                    break;
                                }
                                let _e2186 = atomicAdd((&global_9.member[3u]), 1u);
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
