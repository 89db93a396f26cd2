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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_50 {
    member: type_28,
    member_1: f32,
}

struct type_54 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_57 {
    member: array<vec4<u32>, 2>,
}

struct type_60 {
    member: array<i32>,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_57;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_60;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_67;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_332_: u32;
    var phi_376_: i32;
    var phi_516_: type_46;
    var phi_622_: i32;
    var phi_623_: i32;
    var phi_633_: bool;
    var phi_643_: u32;
    var phi_644_: u32;
    var phi_646_: bool;
    var phi_651_: u32;
    var phi_684_: i32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_748_: f32;
    var phi_754_: f32;
    var phi_827_: f32;
    var phi_833_: f32;
    var phi_873_: f32;
    var phi_879_: f32;
    var phi_952_: f32;
    var phi_958_: f32;
    var phi_998_: f32;
    var phi_1004_: f32;
    var phi_1123_: i32;
    var phi_1145_: u32;
    var phi_1146_: u32;
    var phi_1183_: i32;
    var phi_1205_: u32;
    var phi_1206_: u32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_3533_: bool;
    var phi_1230_: type_50;
    var phi_1233_: u32;
    var phi_1235_: bool;
    var phi_1237_: u32;
    var phi_1239_: u32;
    var phi_1250_: bool;
    var phi_1282_: bool;
    var phi_1283_: u32;
    var phi_1284_: u32;
    var phi_1299_: type_50;
    var phi_1302_: type_8;
    var phi_1303_: type_8;
    var phi_1325_: type_8;
    var phi_1346_: u32;
    var phi_1438_: array<array<f32, 3>, 3>;
    var phi_3279_: bool;
    var phi_3294_: bool;
    var phi_3309_: bool;
    var phi_3324_: bool;
    var phi_3339_: bool;
    var phi_3354_: bool;
    var phi_1980_: f32;
    var phi_1981_: f32;
    var phi_1982_: f32;
    var phi_1983_: f32;
    var phi_1984_: vec3<f32>;
    var phi_1985_: vec3<f32>;
    var phi_1986_: vec3<f32>;
    var phi_1987_: vec3<f32>;
    var phi_3369_: bool;
    var phi_3384_: bool;
    var phi_3399_: bool;
    var phi_3414_: bool;
    var phi_3429_: bool;
    var phi_3444_: bool;
    var phi_2195_: f32;
    var phi_2215_: type_54;
    var phi_2216_: type_54;
    var phi_2219_: type_54;
    var phi_2220_: type_54;
    var phi_2221_: bool;
    var phi_2225_: type_54;
    var phi_2234_: type_28;
    var phi_2257_: u32;
    var phi_2271_: i32;
    var phi_2293_: vec3<f32>;
    var phi_2294_: vec3<f32>;
    var phi_2312_: vec3<f32>;
    var phi_2313_: vec3<f32>;
    var phi_2331_: vec3<f32>;
    var phi_2332_: vec3<f32>;
    var phi_2368_: vec3<f32>;
    var phi_2550_: f32;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2588_: bool;
    var phi_2589_: bool;
    var phi_2595_: type_50;
    var phi_2596_: type_50;
    var phi_2597_: type_50;
    var phi_1300_: type_50;
    var phi_3527_: bool;
    var phi_3759_: bool;
    var phi_2598_: type_50;
    var phi_2663_: type_55;
    var phi_3025_: u32;
    var phi_3052_: u32;
    var phi_3053_: u32;
    var phi_3054_: u32;
    var phi_3056_: u32;
    var phi_3057_: u32;
    var phi_3058_: bool;
    var phi_3067_: u32;
    var phi_3072_: bool;
    var phi_3074_: u32;
    var phi_3078_: bool;
    var phi_3079_: u32;
    var phi_3080_: u32;
    var phi_3727_: bool;
    var phi_3091_: type_50;
    var phi_3092_: u32;
    var phi_3093_: bool;
    var phi_3094_: u32;
    var phi_3095_: u32;
    var phi_3726_: bool;
    var phi_3096_: type_50;
    var phi_3097_: u32;
    var phi_3098_: bool;
    var phi_3099_: u32;
    var phi_3100_: u32;
    var phi_3725_: bool;
    var phi_1231_: type_50;
    var phi_1234_: u32;
    var phi_1236_: bool;
    var phi_1238_: u32;
    var phi_1240_: u32;
    var phi_3101_: bool;
    var phi_3724_: bool;
    var local_2: type_50;
    var phi_3139_: f32;
    var phi_3141_: f32;
    var phi_3142_: bool;
    var phi_3143_: f32;
    var phi_3144_: bool;
    var phi_3472_: u32;
    var phi_3490_: bool;
    var phi_3493_: bool;
    var phi_3506_: f32;
    var phi_3507_: f32;
    var phi_3512_: f32;
    var phi_3513_: f32;
    var phi_3514_: bool;
    var phi_3522_: f32;
    var phi_3159_: f32;
    var phi_3160_: f32;
    var phi_3172_: f32;
    var phi_3177_: type_28;
    var local_3: type_50;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e86 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_2.member));
            let _e100 = arrayLength((&global_9.member));
            let _e104 = (_e84.x + (_e84.y * 2097152u));
            let _e105 = (_e104 < arrayLength((&global_7.member)));
            if _e105 {
                if _e105 {
                } else {
                    break;
                }
                let _e109 = global_7.member[_e104].member_2;
                phi_332_ = _e109;
            } else {
                phi_332_ = 4294967295u;
            }
            let _e111 = phi_332_;
            let _e114 = global_1.member[0u];
            let _e118 = global_3.member[0u][0u];
            let _e122 = global_3.member[0u][1u];
            let _e126 = global_3.member[0u][2u];
            let _e130 = global_3.member[0u][3u];
            let _e134 = global_3.member[1u][0u];
            let _e138 = global_3.member[1u][1u];
            let _e142 = global_3.member[1u][2u];
            let _e146 = global_3.member[1u][3u];
            let _e147 = bitcast<f32>(_e118);
            let _e148 = bitcast<f32>(_e122);
            let _e149 = bitcast<f32>(_e126);
            let _e151 = bitcast<f32>(_e134);
            let _e152 = array<u32, 3>(_e138, _e142, _e146);
            let _e154 = bitcast<i32>(_e114);
            if (_e154 < -126i) {
                phi_376_ = -126i;
            } else {
                phi_376_ = select(_e154, 127i, (_e154 > 127i));
            }
            let _e159 = phi_376_;
            let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
            let _e170 = bitcast<f32>((bitcast<u32>(((_e154 - _e159) + 127i)) << bitcast<u32>(23i)));
            if (_e130 == 0u) {
                phi_516_ = type_46(array<f32, 3>(_e147, _e148, _e149), _e130, _e151, _e152);
            } else {
                let _e172 = bitcast<u32>(_e147);
                let _e174 = ((_e172 & 2139095040u) != 0u);
                let _e189 = bitcast<u32>(_e148);
                let _e191 = ((_e189 & 2139095040u) != 0u);
                let _e206 = bitcast<u32>(_e149);
                let _e208 = ((_e206 & 2139095040u) != 0u);
                let _e224 = bitcast<u32>(_e151);
                let _e226 = ((_e224 & 2139095040u) != 0u);
                phi_516_ = type_46(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e172 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e172 & 2147483648u))), _e147, _e174) * _e164) * select(0.00000011920929f, 1f, _e174)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e189 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e189 & 2147483648u))), _e148, _e191) * _e164) * select(0.00000011920929f, 1f, _e191)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e206 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e206 & 2147483648u))), _e149, _e208) * _e164) * select(0.00000011920929f, 1f, _e208)) * _e170)), _e130, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e224 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e224 & 2147483648u))), _e151, _e226) * _e164) * select(0.00000011920929f, 1f, _e226)) * _e170), _e152);
            }
            let _e243 = phi_516_;
            if _e105 {
                let _e244 = (_e104 < arrayLength((&global_8.member)));
                if _e244 {
                    if _e105 {
                    } else {
                        break;
                    }
                    let _e254 = global_7.member[_e104].member.member_2[0u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_7.member[_e104].member.member_2[1u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_7.member[_e104].member.member_2[2u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e278 = global_7.member[_e104].member.member[0u];
                    let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                    let _e286 = global_7.member[_e104].member.member[1u];
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e294 = global_7.member[_e104].member.member[2u];
                    let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                    let _e298 = select(_e264, _e256, (_e264 < _e256));
                    let _e300 = select(_e272, _e298, (_e272 < _e298));
                    let _e302 = select(_e280, _e300, (_e280 < _e300));
                    let _e304 = select(_e288, _e302, (_e288 < _e302));
                    let _e306 = select(_e296, _e304, (_e296 < _e304));
                    let _e311 = global_7.member[_e104].member.member_1;
                    let _e312 = bitcast<u32>(_e311);
                    let _e313 = (_e312 & 2147483647u);
                    let _e321 = global_7.member[_e104].member.member_3;
                    let _e322 = bitcast<u32>(_e321);
                    let _e323 = (_e322 & 2147483647u);
                    let _e327 = (((select(_e313, _e306, (_e313 < _e306)) < 2139095040u) && (_e323 <= 2139095040u)) && (_e300 > 0u));
                    if _e327 {
                        let _e330 = (bitcast<u32>(bitcast<f32>(_e300)) & 2147483647u);
                        if (_e330 >= 8388608u) {
                            phi_622_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_622_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_622_;
                        phi_623_ = _e344;
                    } else {
                        phi_623_ = 0i;
                    }
                    let _e346 = phi_623_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_633_ = true;
                    } else {
                        phi_633_ = (_e264 == _e300);
                    }
                    let _e350 = phi_633_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_643_ = _e352;
                        phi_644_ = _e352;
                        phi_646_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_643_ = u32();
                        phi_644_ = 0u;
                        phi_646_ = true;
                    }
                    let _e356 = phi_643_;
                    let _e358 = phi_644_;
                    let _e360 = phi_646_;
                    if _e360 {
                        phi_651_ = (_e358 + 1u);
                    } else {
                        phi_651_ = 0u;
                    }
                    let _e364 = phi_651_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_684_ = -126i;
                    } else {
                        phi_684_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_684_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_7.member[_e104].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_702_ = _e388[0];
                    } else {
                        phi_702_ = _e388[1];
                    }
                    let _e393 = phi_702_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_708_ = _e388[2];
                    } else {
                        phi_708_ = _e393;
                    }
                    let _e397 = phi_708_;
                    let _e398 = bitcast<u32>(_e397);
                    let _e400 = ((_e398 & 2139095040u) != 0u);
                    let _e412 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * select(0.00000011920929f, 1f, _e400));
                    let _e413 = global_7.member[_e104].member.member_2;
                    if _e389 {
                        phi_748_ = _e413[0];
                    } else {
                        phi_748_ = _e413[1];
                    }
                    let _e417 = phi_748_;
                    if _e394 {
                        phi_754_ = _e413[2];
                    } else {
                        phi_754_ = _e417;
                    }
                    let _e420 = phi_754_;
                    let _e421 = bitcast<u32>(_e420);
                    let _e423 = ((_e421 & 2139095040u) != 0u);
                    let _e437 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e421 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e421 & 2147483648u))), _e420, _e423) * _e377) * select(0.00000011920929f, 1f, _e423)) * _e383);
                    let _e441 = (bitcast<f32>((bitcast<u32>(_e437) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e444 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                    let _e445 = (_e444 * 0.00000011920929f);
                    let _e448 = select(select(0.00000000000011368684f, _e445, (_e445 > 0.00000000000011368684f)), 0f, _e441);
                    let _e449 = select(0f, _e437, _e441);
                    let _e450 = (_e412 + _e448);
                    let _e451 = (_e412 - _e448);
                    let _e453 = select(38685626000000000000000000f, (1f / _e437), _e441);
                    let _e454 = (_e364 == 0u);
                    if _e454 {
                        phi_827_ = _e388[0];
                    } else {
                        phi_827_ = _e388[1];
                    }
                    let _e458 = phi_827_;
                    let _e459 = (_e364 == 2u);
                    if _e459 {
                        phi_833_ = _e388[2];
                    } else {
                        phi_833_ = _e458;
                    }
                    let _e462 = phi_833_;
                    let _e463 = bitcast<u32>(_e462);
                    let _e465 = ((_e463 & 2139095040u) != 0u);
                    let _e477 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e463 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e463 & 2147483648u))), _e462, _e465) * select(0.00000011920929f, 1f, _e465));
                    if _e454 {
                        phi_873_ = _e413[0];
                    } else {
                        phi_873_ = _e413[1];
                    }
                    let _e481 = phi_873_;
                    if _e459 {
                        phi_879_ = _e413[2];
                    } else {
                        phi_879_ = _e481;
                    }
                    let _e484 = phi_879_;
                    let _e485 = bitcast<u32>(_e484);
                    let _e487 = ((_e485 & 2139095040u) != 0u);
                    let _e501 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e485 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e485 & 2147483648u))), _e484, _e487) * _e377) * select(0.00000011920929f, 1f, _e487)) * _e383);
                    let _e505 = (bitcast<f32>((bitcast<u32>(_e501) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e508 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
                    let _e509 = (_e508 * 0.00000011920929f);
                    let _e512 = select(select(0.00000000000011368684f, _e509, (_e509 > 0.00000000000011368684f)), 0f, _e505);
                    let _e513 = select(0f, _e501, _e505);
                    let _e514 = (_e477 + _e512);
                    let _e515 = (_e477 - _e512);
                    let _e517 = select(38685626000000000000000000f, (1f / _e501), _e505);
                    let _e518 = (_e366 == 0u);
                    if _e518 {
                        phi_952_ = _e388[0];
                    } else {
                        phi_952_ = _e388[1];
                    }
                    let _e522 = phi_952_;
                    let _e523 = (_e366 == 2u);
                    if _e523 {
                        phi_958_ = _e388[2];
                    } else {
                        phi_958_ = _e522;
                    }
                    let _e526 = phi_958_;
                    let _e527 = bitcast<u32>(_e526);
                    let _e529 = ((_e527 & 2139095040u) != 0u);
                    let _e541 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e527 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e527 & 2147483648u))), _e526, _e529) * select(0.00000011920929f, 1f, _e529));
                    if _e518 {
                        phi_998_ = _e413[0];
                    } else {
                        phi_998_ = _e413[1];
                    }
                    let _e545 = phi_998_;
                    if _e523 {
                        phi_1004_ = _e413[2];
                    } else {
                        phi_1004_ = _e545;
                    }
                    let _e548 = phi_1004_;
                    let _e549 = bitcast<u32>(_e548);
                    let _e551 = ((_e549 & 2139095040u) != 0u);
                    let _e565 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e549 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e549 & 2147483648u))), _e548, _e551) * _e377) * select(0.00000011920929f, 1f, _e551)) * _e383);
                    let _e569 = (bitcast<f32>((bitcast<u32>(_e565) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e572 = bitcast<f32>((bitcast<u32>(_e541) & 2147483647u));
                    let _e573 = (_e572 * 0.00000011920929f);
                    let _e576 = select(select(0.00000000000011368684f, _e573, (_e573 > 0.00000000000011368684f)), 0f, _e569);
                    let _e577 = select(0f, _e565, _e569);
                    let _e578 = (_e541 + _e576);
                    let _e579 = (_e541 - _e576);
                    let _e581 = select(38685626000000000000000000f, (1f / _e565), _e569);
                    let _e583 = select(_e508, _e444, (_e444 > _e508));
                    if (_e327 && (select(_e572, _e583, (_e583 > _e572)) <= 1099511600000f)) {
                        let _e595 = ((_e313 & 8388607u) | (select(0u, 1u, ((_e313 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e598 = bitcast<i32>((_e313 >> bitcast<u32>(23i)));
                        let _e602 = (_e595 == 0u);
                        let _e605 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e595)), 32u, _e602)) - 8i);
                        if (_e598 == 255i) {
                            phi_1123_ = 255i;
                        } else {
                            phi_1123_ = (((_e598 + select(0i, 1i, (_e598 == 0i))) - _e605) + _e346);
                        }
                        let _e613 = phi_1123_;
                        let _e623 = (_e613 <= 0i);
                        if _e623 {
                            phi_1146_ = u32();
                        } else {
                            if _e602 {
                                phi_1145_ = u32();
                            } else {
                                phi_1145_ = select(((bitcast<u32>(_e613) << bitcast<u32>(23i)) | ((_e595 << bitcast<u32>(((_e605 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e613 >= 255i));
                            }
                            let _e627 = phi_1145_;
                            phi_1146_ = _e627;
                        }
                        let _e629 = phi_1146_;
                        let _e641 = ((_e323 & 8388607u) | (select(0u, 1u, ((_e323 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e644 = bitcast<i32>((_e323 >> bitcast<u32>(23i)));
                        let _e648 = (_e641 == 0u);
                        let _e651 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e641)), 32u, _e648)) - 8i);
                        if (_e644 == 255i) {
                            phi_1183_ = 255i;
                        } else {
                            phi_1183_ = (((_e644 + select(0i, 1i, (_e644 == 0i))) - _e651) + _e346);
                        }
                        let _e659 = phi_1183_;
                        let _e669 = (_e659 <= 0i);
                        if _e669 {
                            phi_1206_ = u32();
                        } else {
                            if _e648 {
                                phi_1205_ = u32();
                            } else {
                                phi_1205_ = select(((bitcast<u32>(_e659) << bitcast<u32>(23i)) | ((_e641 << bitcast<u32>(((_e651 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e659 >= 255i));
                            }
                            let _e673 = phi_1205_;
                            phi_1206_ = _e673;
                        }
                        let _e675 = phi_1206_;
                        phi_1214_ = bitcast<f32>(((_e322 & 2147483648u) | select(_e675, 0u, select(_e648, true, _e669))));
                        phi_1215_ = bitcast<f32>(((_e312 & 2147483648u) | select(_e629, 0u, select(_e602, true, _e623))));
                    } else {
                        phi_1214_ = 0f;
                        phi_1215_ = 1f;
                    }
                    let _e681 = phi_1214_;
                    let _e683 = phi_1215_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3533_ = false;
                    phi_1230_ = type_50(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e681);
                    phi_1233_ = ((3u * _e86) + 1u);
                    phi_1235_ = (_e683 <= _e681);
                    phi_1237_ = 0u;
                    phi_1239_ = select(0u, 2147483648u, (_e86 == 0u));
                    loop {
                        let _e691 = phi_3533_;
                        let _e693 = phi_1230_;
                        let _e695 = phi_1233_;
                        let _e697 = phi_1235_;
                        let _e699 = phi_1237_;
                        let _e701 = phi_1239_;
                        local_2 = _e693;
                        if _e697 {
                            phi_1250_ = true;
                        } else {
                            phi_1250_ = (_e699 > 0u);
                        }
                        let _e704 = phi_1250_;
                        if _e704 {
                            let _e705 = (_e695 > 0u);
                            if _e705 {
                                if _e697 {
                                    phi_1282_ = _e697;
                                    phi_1283_ = _e699;
                                    phi_1284_ = _e701;
                                } else {
                                    let _e706 = (_e699 - 1u);
                                    let _e707 = (_e706 % 128u);
                                    let _e708 = (_e707 < 128u);
                                    if _e708 {
                                    } else {
                                        phi_3724_ = true;
                                        break;
                                    }
                                    let _e710 = local_1[_e707];
                                    if _e708 {
                                    } else {
                                        phi_3724_ = true;
                                        break;
                                    }
                                    let _e712 = local[_e707];
                                    phi_1282_ = (_e712 <= _e693.member_1);
                                    phi_1283_ = _e706;
                                    phi_1284_ = _e710;
                                }
                                let _e716 = phi_1282_;
                                let _e718 = phi_1283_;
                                let _e720 = phi_1284_;
                                if _e716 {
                                    let _e723 = ((_e720 & 2147483648u) != 0u);
                                    if _e723 {
                                        phi_1299_ = _e693;
                                        phi_1302_ = type_8(0u, ((_e720 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e730 = phi_1299_;
                                            let _e732 = phi_1302_;
                                            local_3 = _e730;
                                            if (_e732.member < _e732.member_1) {
                                                phi_1303_ = type_8((_e732.member + 1u), _e732.member_1);
                                                phi_1325_ = type_8(1u, _e732.member);
                                            } else {
                                                phi_1303_ = _e732;
                                                phi_1325_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e745 = phi_1303_;
                                            let _e747 = phi_1325_;
                                            let _e751 = (bitcast<i32>(_e747.member) != 0i);
                                            if _e751 {
                                                let _e752 = ((_e720 & 268435455u) + _e747.member_1);
                                                let _e753 = (_e752 < _e88);
                                                if _e753 {
                                                    if _e753 {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e757 = global_2.member[_e752].member_1;
                                                    phi_1346_ = _e757;
                                                } else {
                                                    phi_1346_ = 4294967295u;
                                                }
                                                let _e759 = phi_1346_;
                                                if (_e752 >= _e88) {
                                                    phi_1438_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e753 {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e761 = (_e365 % 3u);
                                                    let _e762 = (_e364 % 3u);
                                                    let _e763 = (_e366 % 3u);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e769 = global_2.member[_e752].member[_e761];
                                                    if (_e762 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e752].member[_e762];
                                                    if (_e763 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e781 = global_2.member[_e752].member[_e763];
                                                    let _e783 = (3u + _e761);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e752].member[_e783];
                                                    let _e790 = (3u + _e762);
                                                    if (_e790 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_2.member[_e752].member[_e790];
                                                    let _e797 = (3u + _e763);
                                                    if (_e797 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e803 = global_2.member[_e752].member[_e797];
                                                    let _e805 = (6u + _e761);
                                                    if (_e805 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e811 = global_2.member[_e752].member[_e805];
                                                    let _e812 = (6u + _e762);
                                                    if (_e812 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e818 = global_2.member[_e752].member[_e812];
                                                    let _e819 = (6u + _e763);
                                                    if (_e819 < 9u) {
                                                    } else {
                                                        phi_3527_ = true;
                                                        break;
                                                    }
                                                    let _e825 = global_2.member[_e752].member[_e819];
                                                    phi_1438_ = array<array<f32, 3>, 3>(array<f32, 3>(_e769, _e775, _e781), array<f32, 3>(_e789, _e796, _e803), array<f32, 3>(_e811, _e818, _e825));
                                                }
                                                let _e829 = phi_1438_;
                                                let _e845 = (_e829[0][2] - _e541);
                                                let _e848 = (((_e829[0][0] - _e412) * _e577) - (_e845 * _e449));
                                                let _e851 = (((_e829[0][1] - _e477) * _e577) - (_e845 * _e513));
                                                let _e854 = (_e829[1][2] - _e541);
                                                let _e857 = (((_e829[1][0] - _e412) * _e577) - (_e854 * _e449));
                                                let _e860 = (((_e829[1][1] - _e477) * _e577) - (_e854 * _e513));
                                                let _e863 = (_e829[2][2] - _e541);
                                                let _e866 = (((_e829[2][0] - _e412) * _e577) - (_e863 * _e449));
                                                let _e869 = (((_e829[2][1] - _e477) * _e577) - (_e863 * _e513));
                                                let _e870 = (_e866 * _e860);
                                                let _e871 = (_e869 * _e857);
                                                let _e872 = (_e848 * _e869);
                                                let _e873 = (_e851 * _e866);
                                                let _e874 = (_e857 * _e851);
                                                let _e875 = (_e860 * _e848);
                                                let _e880 = (((_e870 >= _e871) && (_e872 >= _e873)) && (_e874 >= _e875));
                                                let _e886 = (_e880 || (((_e870 <= _e871) && (_e872 <= _e873)) && (_e874 <= _e875)));
                                                if _e886 {
                                                    let _e888 = select(-1f, 1f, _e880);
                                                    let _e890 = ((_e870 - _e871) * _e888);
                                                    let _e892 = select(0f, _e890, (_e890 > 0f));
                                                    let _e894 = ((_e872 - _e873) * _e888);
                                                    let _e896 = select(0f, _e894, (_e894 > 0f));
                                                    let _e898 = ((_e874 - _e875) * _e888);
                                                    let _e900 = select(0f, _e898, (_e898 > 0f));
                                                    let _e902 = ((_e892 + _e896) + _e900);
                                                    let _e904 = select(_e829[1][0], _e829[0][0], (_e829[0][0] < _e829[1][0]));
                                                    let _e908 = select(_e829[1][0], _e829[0][0], (_e829[0][0] > _e829[1][0]));
                                                    let _e912 = select(_e829[1][1], _e829[0][1], (_e829[0][1] < _e829[1][1]));
                                                    let _e916 = select(_e829[1][1], _e829[0][1], (_e829[0][1] > _e829[1][1]));
                                                    let _e920 = select(_e829[1][2], _e829[0][2], (_e829[0][2] < _e829[1][2]));
                                                    let _e924 = select(_e829[1][2], _e829[0][2], (_e829[0][2] > _e829[1][2]));
                                                    let _e929 = ((select(_e829[2][0], _e904, (_e904 < _e829[2][0])) - _e450) * _e453);
                                                    let _e930 = ((select(_e829[2][0], _e908, (_e908 > _e829[2][0])) - _e451) * _e453);
                                                    let _e933 = ((select(_e829[2][1], _e912, (_e912 < _e829[2][1])) - _e514) * _e517);
                                                    let _e934 = ((select(_e829[2][1], _e916, (_e916 > _e829[2][1])) - _e515) * _e517);
                                                    let _e937 = ((select(_e829[2][2], _e920, (_e920 < _e829[2][2])) - _e578) * _e581);
                                                    let _e938 = ((select(_e829[2][2], _e924, (_e924 > _e829[2][2])) - _e579) * _e581);
                                                    let _e940 = select(_e938, _e937, (_e937 < _e938));
                                                    let _e942 = select(_e938, _e937, (_e937 > _e938));
                                                    let _e944 = select(_e930, _e929, (_e929 < _e930));
                                                    let _e946 = select(_e934, _e933, (_e933 < _e934));
                                                    let _e948 = select(_e946, _e944, (_e944 > _e946));
                                                    let _e950 = select(_e940, _e948, (_e948 > _e940));
                                                    let _e952 = select(_e930, _e929, (_e929 > _e930));
                                                    let _e954 = select(_e934, _e933, (_e933 > _e934));
                                                    let _e956 = select(_e954, _e952, (_e952 < _e954));
                                                    let _e958 = select(_e942, _e956, (_e956 < _e942));
                                                    let _e959 = -(_e940);
                                                    let _e965 = select(_e683, _e950, (_e950 > _e683));
                                                    let _e969 = select(_e857, _e848, (_e848 < _e857));
                                                    let _e974 = select(_e857, _e848, (_e848 > _e857));
                                                    let _e981 = select(_e860, _e851, (_e851 < _e860));
                                                    let _e986 = select(_e860, _e851, (_e851 > _e860));
                                                    let _e995 = (((((_e886 && (_e902 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e866, _e969, (_e969 < _e866)) <= 0f) && (select(_e866, _e974, (_e974 > _e866)) >= 0f))) && ((select(_e869, _e981, (_e981 < _e869)) <= 0f) && (select(_e869, _e986, (_e986 > _e869)) >= 0f))) && (_e965 <= (_e958 + (select(_e959, _e942, (_e942 > _e959)) * 0.0000019073523f)))) && (_e965 <= _e730.member_1));
                                                    if _e995 {
                                                        let _e1000 = (_e829[1][0] - _e829[0][0]);
                                                        let _e1001 = (_e829[1][1] - _e829[0][1]);
                                                        let _e1002 = (_e829[1][2] - _e829[0][2]);
                                                        let _e1003 = vec3<f32>(_e1000, _e1001, _e1002);
                                                        let _e1004 = (_e829[2][0] - _e829[1][0]);
                                                        let _e1005 = (_e829[2][1] - _e829[1][1]);
                                                        let _e1006 = (_e829[2][2] - _e829[1][2]);
                                                        let _e1007 = vec3<f32>(_e1004, _e1005, _e1006);
                                                        let _e1008 = (_e829[0][0] - _e829[2][0]);
                                                        let _e1009 = (_e829[0][1] - _e829[2][1]);
                                                        let _e1010 = (_e829[0][2] - _e829[2][2]);
                                                        let _e1011 = vec3<f32>(_e1008, _e1009, _e1010);
                                                        let _e1012 = abs(_e1000);
                                                        let _e1013 = abs(_e1001);
                                                        if (_e1012 != _e1012) {
                                                            phi_3279_ = true;
                                                        } else {
                                                            phi_3279_ = (_e1013 >= _e1012);
                                                        }
                                                        let _e1017 = phi_3279_;
                                                        let _e1018 = select(_e1012, _e1013, _e1017);
                                                        let _e1019 = abs(_e1002);
                                                        if (_e1018 != _e1018) {
                                                            phi_3294_ = true;
                                                        } else {
                                                            phi_3294_ = (_e1019 >= _e1018);
                                                        }
                                                        let _e1023 = phi_3294_;
                                                        let _e1024 = select(_e1018, _e1019, _e1023);
                                                        let _e1025 = abs(_e1004);
                                                        let _e1026 = abs(_e1005);
                                                        if (_e1025 != _e1025) {
                                                            phi_3309_ = true;
                                                        } else {
                                                            phi_3309_ = (_e1026 >= _e1025);
                                                        }
                                                        let _e1030 = phi_3309_;
                                                        let _e1031 = select(_e1025, _e1026, _e1030);
                                                        let _e1032 = abs(_e1006);
                                                        if (_e1031 != _e1031) {
                                                            phi_3324_ = true;
                                                        } else {
                                                            phi_3324_ = (_e1032 >= _e1031);
                                                        }
                                                        let _e1036 = phi_3324_;
                                                        let _e1037 = select(_e1031, _e1032, _e1036);
                                                        let _e1038 = abs(_e1008);
                                                        let _e1039 = abs(_e1009);
                                                        if (_e1038 != _e1038) {
                                                            phi_3339_ = true;
                                                        } else {
                                                            phi_3339_ = (_e1039 >= _e1038);
                                                        }
                                                        let _e1043 = phi_3339_;
                                                        let _e1044 = select(_e1038, _e1039, _e1043);
                                                        let _e1045 = abs(_e1010);
                                                        if (_e1044 != _e1044) {
                                                            phi_3354_ = true;
                                                        } else {
                                                            phi_3354_ = (_e1045 >= _e1044);
                                                        }
                                                        let _e1049 = phi_3354_;
                                                        let _e1050 = select(_e1044, _e1045, _e1049);
                                                        let _e1052 = select(_e1037, _e1024, (_e1024 > _e1037));
                                                        let _e1054 = select(_e1050, _e1052, (_e1052 > _e1050));
                                                        if (_e1024 == _e1054) {
                                                            phi_1980_ = _e860;
                                                            phi_1981_ = _e857;
                                                            phi_1982_ = _e851;
                                                            phi_1983_ = _e848;
                                                            phi_1984_ = vec3<f32>(_e829[0][0], _e829[0][1], _e829[0][2]);
                                                            phi_1985_ = _e1011;
                                                            phi_1986_ = _e1007;
                                                            phi_1987_ = _e1003;
                                                        } else {
                                                            let _e1056 = (_e1037 == _e1054);
                                                            let _e1061 = vec3(_e1056);
                                                            phi_1980_ = select(_e851, _e869, _e1056);
                                                            phi_1981_ = select(_e848, _e866, _e1056);
                                                            phi_1982_ = select(_e869, _e860, _e1056);
                                                            phi_1983_ = select(_e866, _e857, _e1056);
                                                            phi_1984_ = select(vec3<f32>(_e829[2][0], _e829[2][1], _e829[2][2]), vec3<f32>(_e829[1][0], _e829[1][1], _e829[1][2]), _e1061);
                                                            phi_1985_ = select(_e1007, _e1003, _e1061);
                                                            phi_1986_ = select(_e1003, _e1011, _e1061);
                                                            phi_1987_ = select(_e1011, _e1007, _e1061);
                                                        }
                                                        let _e1067 = phi_1980_;
                                                        let _e1069 = phi_1981_;
                                                        let _e1071 = phi_1982_;
                                                        let _e1073 = phi_1983_;
                                                        let _e1075 = phi_1984_;
                                                        let _e1077 = phi_1985_;
                                                        let _e1079 = phi_1986_;
                                                        let _e1081 = phi_1987_;
                                                        let _e1088 = ((_e1079.y * _e1077.z) - (_e1077.y * _e1079.z));
                                                        let _e1093 = ((_e1079.z * _e1077.x) - (_e1077.z * _e1079.x));
                                                        let _e1096 = ((_e1079.x * _e1077.y) - (_e1077.x * _e1079.y));
                                                        let _e1099 = ((_e892 >= _e896) && (_e892 >= _e900));
                                                        let _e1100 = (_e896 >= _e900);
                                                        let _e1114 = (((_e1088 * (select(select(_e829[2][0], _e829[1][0], _e1100), _e829[0][0], _e1099) - _e412)) + (_e1093 * (select(select(_e829[2][1], _e829[1][1], _e1100), _e829[0][1], _e1099) - _e477))) + (_e1096 * (select(select(_e829[2][2], _e829[1][2], _e1100), _e829[0][2], _e1099) - _e541)));
                                                        let _e1119 = (((_e1088 * _e449) + (_e1093 * _e513)) + (_e1096 * _e577));
                                                        let _e1120 = (_e1069 - _e1073);
                                                        let _e1121 = (_e1067 - _e1071);
                                                        let _e1124 = ((_e1120 * _e1120) + (_e1121 * _e1121));
                                                        let _e1131 = (-(((_e1073 * _e1120) + (_e1071 * _e1121))) / select(0.000000000000000000000000000000000000011754944f, _e1124, (_e1124 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1133 = select(1f, _e1131, (_e1131 < 1f));
                                                        let _e1135 = select(0f, _e1133, (_e1133 > 0f));
                                                        let _e1144 = ((_e1075.x + (_e1081.x * _e1135)) - _e412);
                                                        let _e1147 = ((_e1075.y + (_e1081.y * _e1135)) - _e477);
                                                        let _e1150 = ((_e1075.z + (_e1081.z * _e1135)) - _e541);
                                                        let _e1153 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                        let _e1156 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                        let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                        let _e1161 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                        let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                        let _e1167 = abs(_e1088);
                                                        let _e1168 = abs(_e1093);
                                                        if (_e1167 != _e1167) {
                                                            phi_3369_ = true;
                                                        } else {
                                                            phi_3369_ = (_e1168 >= _e1167);
                                                        }
                                                        let _e1172 = phi_3369_;
                                                        let _e1173 = select(_e1167, _e1168, _e1172);
                                                        let _e1174 = abs(_e1096);
                                                        if (_e1173 != _e1173) {
                                                            phi_3384_ = true;
                                                        } else {
                                                            phi_3384_ = (_e1174 >= _e1173);
                                                        }
                                                        let _e1178 = phi_3384_;
                                                        let _e1194 = abs(_e1079.x);
                                                        let _e1195 = abs(_e1079.y);
                                                        if (_e1194 != _e1194) {
                                                            phi_3399_ = true;
                                                        } else {
                                                            phi_3399_ = (_e1195 >= _e1194);
                                                        }
                                                        let _e1199 = phi_3399_;
                                                        let _e1200 = select(_e1194, _e1195, _e1199);
                                                        let _e1201 = abs(_e1079.z);
                                                        if (_e1200 != _e1200) {
                                                            phi_3414_ = true;
                                                        } else {
                                                            phi_3414_ = (_e1201 >= _e1200);
                                                        }
                                                        let _e1205 = phi_3414_;
                                                        let _e1208 = abs(_e1077.x);
                                                        let _e1209 = abs(_e1077.y);
                                                        if (_e1208 != _e1208) {
                                                            phi_3429_ = true;
                                                        } else {
                                                            phi_3429_ = (_e1209 >= _e1208);
                                                        }
                                                        let _e1213 = phi_3429_;
                                                        let _e1214 = select(_e1208, _e1209, _e1213);
                                                        let _e1215 = abs(_e1077.z);
                                                        if (_e1214 != _e1214) {
                                                            phi_3444_ = true;
                                                        } else {
                                                            phi_3444_ = (_e1215 >= _e1214);
                                                        }
                                                        let _e1219 = phi_3444_;
                                                        let _e1224 = ((bitcast<f32>((bitcast<u32>(((((_e1088 * _e1144) + (_e1093 * _e1147)) + (_e1096 * _e1150)) - _e1114)) & 2147483647u)) <= ((0.0000009536743f * select(_e1054, _e1163, (_e1163 > _e1054))) * select(_e1173, _e1174, _e1178))) && !((bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u)) <= ((0.0000038146973f * select(_e1200, _e1201, _e1205)) * select(_e1214, _e1215, _e1219)))));
                                                        let _e1225 = (_e1114 / _e1119);
                                                        if (_e995 && !(_e1224)) {
                                                            let _e1228 = (_e1150 / _e577);
                                                            let _e1236 = (((_e1088 * (_e1144 - (_e449 * _e1228))) + (_e1093 * (_e1147 - (_e513 * _e1228)))) / _e1119);
                                                            phi_2195_ = select(select(_e1228, (_e1228 + _e1236), (bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u)) <= _e1054)), _e1225, _e1224);
                                                        } else {
                                                            phi_2195_ = _e1225;
                                                        }
                                                        let _e1245 = phi_2195_;
                                                        let _e1247 = select(_e958, _e1245, (_e1245 < _e958));
                                                        let _e1249 = select(_e950, _e1247, (_e1247 > _e950));
                                                        let _e1250 = (1f / _e902);
                                                        phi_2215_ = type_54(_e1249, (_e896 * _e1250), (_e900 * _e1250), ((_e995 && (_e1249 >= _e683)) && (_e1249 <= _e730.member_1)));
                                                        phi_2216_ = type_54();
                                                    } else {
                                                        phi_2215_ = type_54();
                                                        phi_2216_ = type_54(0f, 0f, 0f, _e995);
                                                    }
                                                    let _e1259 = phi_2215_;
                                                    let _e1261 = phi_2216_;
                                                    phi_2219_ = _e1259;
                                                    phi_2220_ = _e1261;
                                                    phi_2221_ = select(true, false, _e995);
                                                } else {
                                                    phi_2219_ = type_54();
                                                    phi_2220_ = type_54(0f, 0f, 0f, _e886);
                                                    phi_2221_ = true;
                                                }
                                                let _e1264 = phi_2219_;
                                                let _e1266 = phi_2220_;
                                                let _e1268 = phi_2221_;
                                                if _e1268 {
                                                    phi_2225_ = _e1266;
                                                } else {
                                                    phi_2225_ = _e1264;
                                                }
                                                let _e1270 = phi_2225_;
                                                if _e1270.member_3 {
                                                    phi_2234_ = type_28(_e1270.member, _e1270.member_1, _e1270.member_2, _e759);
                                                } else {
                                                    phi_2234_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1277 = phi_2234_;
                                                if (_e1277.member_3 != 4294967295u) {
                                                    if (_e759 == _e111) {
                                                        phi_2569_ = false;
                                                    } else {
                                                        let _e1281 = (_e759 < arrayLength((&global_5.member)));
                                                        if _e1281 {
                                                            if _e1281 {
                                                            } else {
                                                                phi_3527_ = true;
                                                                break;
                                                            }
                                                            let _e1283 = global_5.member[_e759];
                                                            phi_2257_ = _e1283;
                                                        } else {
                                                            phi_2257_ = 4294967295u;
                                                        }
                                                        let _e1285 = phi_2257_;
                                                        let _e1286 = (_e1285 < arrayLength((&global_6.member)));
                                                        if _e1286 {
                                                            if _e1286 {
                                                            } else {
                                                                phi_3527_ = true;
                                                                break;
                                                            }
                                                            let _e1288 = global_6.member[_e1285];
                                                            phi_2271_ = _e1288;
                                                        } else {
                                                            phi_2271_ = 0i;
                                                        }
                                                        let _e1290 = phi_2271_;
                                                        let _e1291 = (_e1290 == 0i);
                                                        if _e1291 {
                                                            phi_2568_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2294_ = vec3<f32>(_e829[0][0], _e829[0][1], _e829[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2293_ = vec3<f32>(_e829[0][2], _e829[0][0], _e829[0][1]);
                                                                } else {
                                                                    phi_2293_ = vec3<f32>(_e829[0][1], _e829[0][2], _e829[0][0]);
                                                                }
                                                                let _e1296 = phi_2293_;
                                                                phi_2294_ = _e1296;
                                                            }
                                                            let _e1299 = phi_2294_;
                                                            if _e389 {
                                                                phi_2313_ = vec3<f32>(_e829[1][0], _e829[1][1], _e829[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2312_ = vec3<f32>(_e829[1][2], _e829[1][0], _e829[1][1]);
                                                                } else {
                                                                    phi_2312_ = vec3<f32>(_e829[1][1], _e829[1][2], _e829[1][0]);
                                                                }
                                                                let _e1304 = phi_2312_;
                                                                phi_2313_ = _e1304;
                                                            }
                                                            let _e1307 = phi_2313_;
                                                            if _e389 {
                                                                phi_2332_ = vec3<f32>(_e829[2][0], _e829[2][1], _e829[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2331_ = vec3<f32>(_e829[2][2], _e829[2][0], _e829[2][1]);
                                                                } else {
                                                                    phi_2331_ = vec3<f32>(_e829[2][1], _e829[2][2], _e829[2][0]);
                                                                }
                                                                let _e1312 = phi_2331_;
                                                                phi_2332_ = _e1312;
                                                            }
                                                            let _e1315 = phi_2332_;
                                                            let _e1318 = (_e1307.x - _e1299.x);
                                                            let _e1321 = (_e1307.y - _e1299.y);
                                                            let _e1324 = (_e1307.z - _e1299.z);
                                                            let _e1326 = (_e1315.x - _e1299.x);
                                                            let _e1328 = (_e1315.y - _e1299.y);
                                                            let _e1330 = (_e1315.z - _e1299.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2368_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1299);
                                                            } else {
                                                                phi_2368_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1345 = phi_2368_;
                                                            let _e1351 = bitcast<f32>((bitcast<u32>((_e1318 * _e1328)) ^ _e243.member_3[0]));
                                                            let _e1355 = bitcast<f32>((bitcast<u32>((_e1321 * _e1326)) ^ _e243.member_3[0]));
                                                            let _e1359 = bitcast<f32>((bitcast<u32>((_e1321 * _e1330)) ^ _e243.member_3[0]));
                                                            let _e1363 = bitcast<f32>((bitcast<u32>((_e1324 * _e1328)) ^ _e243.member_3[0]));
                                                            let _e1367 = bitcast<f32>((bitcast<u32>((_e1324 * _e1326)) ^ _e243.member_3[0]));
                                                            let _e1371 = bitcast<f32>((bitcast<u32>((_e1318 * _e1330)) ^ _e243.member_3[0]));
                                                            let _e1372 = (_e1359 - _e1363);
                                                            let _e1373 = (_e1367 - _e1371);
                                                            let _e1374 = (_e1351 - _e1355);
                                                            let _e1398 = (bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u)));
                                                            let _e1405 = (bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u)));
                                                            let _e1412 = (bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2550_ = 0f;
                                                            } else {
                                                                let _e1442 = bitcast<f32>((bitcast<u32>(_e1372) & 2147483647u));
                                                                let _e1445 = bitcast<f32>((bitcast<u32>(_e1373) & 2147483647u));
                                                                let _e1448 = bitcast<f32>((bitcast<u32>(_e1374) & 2147483647u));
                                                                let _e1450 = select(_e1448, _e1445, (_e1445 > _e1448));
                                                                let _e1454 = select(_e1448, _e1445, (_e1445 < _e1448));
                                                                let _e1458 = select(_e1445, _e1442, (_e1442 < _e1445));
                                                                let _e1460 = select(_e1445, _e1442, (_e1442 > _e1445));
                                                                let _e1462 = select(_e1448, _e1460, (_e1460 < _e1448));
                                                                phi_2550_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1450, _e1442, (_e1442 > _e1450)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1462, _e1458, (_e1458 > _e1462)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1454, _e1442, (_e1442 < _e1454)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1398 + _e1405) + _e1412))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1489 = phi_2550_;
                                                            phi_2568_ = (_e1291 || !(((((bitcast<f32>((bitcast<u32>((_e1345.x * _e1372)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1345.y * _e1373)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1345.z * _e1374)) ^ _e243.member_3[0]))) * f32(-(_e1290))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1345.x) & 2147483647u)) * _e1398)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1345.y) & 2147483647u)) * _e1405)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1345.z) & 2147483647u)) * _e1412)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1489) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1503 = phi_2568_;
                                                        phi_2569_ = _e1503;
                                                    }
                                                    let _e1505 = phi_2569_;
                                                    if _e1505 {
                                                        if (_e1277.member < _e730.member.member) {
                                                            phi_2589_ = true;
                                                        } else {
                                                            if (_e1277.member == _e730.member.member) {
                                                                phi_2588_ = (_e1277.member_3 < _e730.member.member_3);
                                                            } else {
                                                                phi_2588_ = false;
                                                            }
                                                            let _e1515 = phi_2588_;
                                                            phi_2589_ = _e1515;
                                                        }
                                                        let _e1517 = phi_2589_;
                                                        if _e1517 {
                                                            phi_2595_ = type_50(_e1277, _e1277.member);
                                                        } else {
                                                            phi_2595_ = _e730;
                                                        }
                                                        let _e1520 = phi_2595_;
                                                        phi_2596_ = _e1520;
                                                    } else {
                                                        phi_2596_ = _e730;
                                                    }
                                                    let _e1522 = phi_2596_;
                                                    phi_2597_ = _e1522;
                                                } else {
                                                    phi_2597_ = _e730;
                                                }
                                                let _e1524 = phi_2597_;
                                                phi_1300_ = _e1524;
                                            } else {
                                                phi_1300_ = type_50();
                                            }
                                            let _e1526 = phi_1300_;
                                            continue;
                                            continuing {
                                                phi_1299_ = _e1526;
                                                phi_1302_ = _e745;
                                                phi_3527_ = _e691;
                                                break if !(_e751);
                                            }
                                        }
                                        let _e1529 = phi_3527_;
                                        phi_3724_ = _e1529;
                                        if _e1529 {
                                            break;
                                        }
                                        phi_3759_ = _e1529;
                                        let _e2021 = local_3;
                                        phi_2598_ = _e2021;
                                    } else {
                                        phi_3759_ = _e691;
                                        phi_2598_ = _e693;
                                    }
                                    let _e1531 = phi_3759_;
                                    let _e1533 = phi_2598_;
                                    if _e723 {
                                        phi_3078_ = bool();
                                        phi_3079_ = u32();
                                        phi_3080_ = u32();
                                    } else {
                                        if (_e720 >= _e86) {
                                            phi_2663_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e720 < _e86) {
                                            } else {
                                                phi_3724_ = true;
                                                break;
                                            }
                                            let _e1536 = (_e365 % 3u);
                                            if (_e1536 < 3u) {
                                            } else {
                                                phi_3724_ = true;
                                                break;
                                            }
                                            let _e1542 = global_4.member[_e720].member[_e1536];
                                            let _e1548 = (_e364 % 3u);
                                            if (_e1548 < 3u) {
                                            } else {
                                                phi_3724_ = true;
                                                break;
                                            }
                                            let _e1554 = global_4.member[_e720].member[_e1548];
                                            let _e1560 = (_e366 % 3u);
                                            if (_e1560 < 3u) {
                                            } else {
                                                phi_3724_ = true;
                                                break;
                                            }
                                            let _e1566 = global_4.member[_e720].member[_e1560];
                                            let _e1576 = global_4.member[_e720].member_1;
                                            let _e1580 = global_4.member[_e720].member_2;
                                            phi_2663_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e1542[0], _e1542[1], _e1542[2], _e1542[3]), vec4<f32>(_e1554[0], _e1554[1], _e1554[2], _e1554[3]), vec4<f32>(_e1566[0], _e1566[1], _e1566[2], _e1566[3])), _e1576, _e1580);
                                        }
                                        let _e1583 = phi_2663_;
                                        let _e1595 = ((_e1583.member[0].x - _e450) * _e453);
                                        let _e1596 = ((_e1583.member[0].y - _e450) * _e453);
                                        let _e1597 = ((_e1583.member[0].z - _e451) * _e453);
                                        let _e1598 = ((_e1583.member[0].w - _e451) * _e453);
                                        let _e1608 = ((_e1583.member[1].x - _e514) * _e517);
                                        let _e1609 = ((_e1583.member[1].y - _e514) * _e517);
                                        let _e1610 = ((_e1583.member[1].z - _e515) * _e517);
                                        let _e1611 = ((_e1583.member[1].w - _e515) * _e517);
                                        let _e1621 = ((_e1583.member[2].x - _e578) * _e581);
                                        let _e1622 = ((_e1583.member[2].y - _e578) * _e581);
                                        let _e1623 = ((_e1583.member[2].z - _e579) * _e581);
                                        let _e1624 = ((_e1583.member[2].w - _e579) * _e581);
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
                                        let _e1676 = select(_e683, _e1646, (_e1646 > _e683));
                                        let _e1678 = select(_e683, _e1648, (_e1648 > _e683));
                                        let _e1683 = (_e1676 <= select(_e1533.member_1, _e1673, (_e1673 < _e1533.member_1)));
                                        let _e1684 = (_e1678 <= select(_e1533.member_1, _e1674, (_e1674 < _e1533.member_1)));
                                        let _e1685 = (_e1676 <= _e1678);
                                        if _e1683 {
                                            if _e1684 {
                                                if _e1685 {
                                                    phi_3025_ = _e1583.member_2;
                                                } else {
                                                    phi_3025_ = _e1583.member_1;
                                                }
                                                let _e1689 = phi_3025_;
                                                let _e1691 = (_e718 % 128u);
                                                let _e1692 = (_e1691 < 128u);
                                                if _e1692 {
                                                } else {
                                                    phi_3724_ = true;
                                                    break;
                                                }
                                                local_1[_e1691] = _e1689;
                                                if _e1692 {
                                                } else {
                                                    phi_3724_ = true;
                                                    break;
                                                }
                                                local[_e1691] = select(_e1676, _e1678, _e1685);
                                                if _e1685 {
                                                    phi_3052_ = _e1583.member_1;
                                                } else {
                                                    phi_3052_ = _e1583.member_2;
                                                }
                                                let _e1699 = phi_3052_;
                                                phi_3053_ = (_e718 + 1u);
                                                phi_3054_ = _e1699;
                                            } else {
                                                phi_3053_ = u32();
                                                phi_3054_ = u32();
                                            }
                                            let _e1701 = phi_3053_;
                                            let _e1703 = phi_3054_;
                                            phi_3056_ = _e1701;
                                            phi_3057_ = _e1703;
                                            phi_3058_ = select(true, false, _e1684);
                                        } else {
                                            phi_3056_ = u32();
                                            phi_3057_ = u32();
                                            phi_3058_ = true;
                                        }
                                        let _e1706 = phi_3056_;
                                        let _e1708 = phi_3057_;
                                        let _e1710 = phi_3058_;
                                        if _e1710 {
                                            if _e1683 {
                                                phi_3067_ = _e1583.member_1;
                                            } else {
                                                phi_3067_ = _e1583.member_2;
                                            }
                                            let _e1714 = phi_3067_;
                                            phi_3072_ = select(_e1684, true, _e1683);
                                            phi_3074_ = _e1714;
                                        } else {
                                            phi_3072_ = _e716;
                                            phi_3074_ = _e1708;
                                        }
                                        let _e1717 = phi_3072_;
                                        let _e1719 = phi_3074_;
                                        phi_3078_ = _e1717;
                                        phi_3079_ = select(_e1706, _e718, _e1710);
                                        phi_3080_ = _e1719;
                                    }
                                    let _e1722 = phi_3078_;
                                    let _e1724 = phi_3079_;
                                    let _e1726 = phi_3080_;
                                    phi_3727_ = _e1531;
                                    phi_3091_ = _e1533;
                                    phi_3092_ = (_e695 - 1u);
                                    phi_3093_ = select(_e1722, false, _e723);
                                    phi_3094_ = select(_e1724, _e718, _e723);
                                    phi_3095_ = select(_e1726, _e720, _e723);
                                } else {
                                    phi_3727_ = _e691;
                                    phi_3091_ = _e693;
                                    phi_3092_ = _e695;
                                    phi_3093_ = _e716;
                                    phi_3094_ = _e718;
                                    phi_3095_ = _e720;
                                }
                                let _e1731 = phi_3727_;
                                let _e1733 = phi_3091_;
                                let _e1735 = phi_3092_;
                                let _e1737 = phi_3093_;
                                let _e1739 = phi_3094_;
                                let _e1741 = phi_3095_;
                                phi_3726_ = _e1731;
                                phi_3096_ = _e1733;
                                phi_3097_ = _e1735;
                                phi_3098_ = _e1737;
                                phi_3099_ = _e1739;
                                phi_3100_ = _e1741;
                            } else {
                                phi_3726_ = _e691;
                                phi_3096_ = type_50();
                                phi_3097_ = u32();
                                phi_3098_ = bool();
                                phi_3099_ = u32();
                                phi_3100_ = u32();
                            }
                            let _e1743 = phi_3726_;
                            let _e1745 = phi_3096_;
                            let _e1747 = phi_3097_;
                            let _e1749 = phi_3098_;
                            let _e1751 = phi_3099_;
                            let _e1753 = phi_3100_;
                            phi_3725_ = _e1743;
                            phi_1231_ = _e1745;
                            phi_1234_ = _e1747;
                            phi_1236_ = _e1749;
                            phi_1238_ = _e1751;
                            phi_1240_ = _e1753;
                            phi_3101_ = _e705;
                        } else {
                            phi_3725_ = _e691;
                            phi_1231_ = type_50();
                            phi_1234_ = u32();
                            phi_1236_ = bool();
                            phi_1238_ = u32();
                            phi_1240_ = u32();
                            phi_3101_ = false;
                        }
                        let _e1755 = phi_3725_;
                        let _e1757 = phi_1231_;
                        let _e1759 = phi_1234_;
                        let _e1761 = phi_1236_;
                        let _e1763 = phi_1238_;
                        let _e1765 = phi_1240_;
                        let _e1767 = phi_3101_;
                        continue;
                        continuing {
                            phi_3533_ = _e1755;
                            phi_1230_ = _e1757;
                            phi_1233_ = _e1759;
                            phi_1235_ = _e1761;
                            phi_1237_ = _e1763;
                            phi_1239_ = _e1765;
                            phi_3724_ = _e1755;
                            break if !(_e1767);
                        }
                    }
                    let _e1770 = phi_3724_;
                    if _e1770 {
                        break;
                    }
                    let _e1772 = local_2;
                    if (_e1772.member.member_3 != 4294967295u) {
                        let _e1777 = bitcast<u32>(_e1772.member.member);
                        let _e1781 = (bitcast<i32>((_e1777 >> bitcast<u32>(23i))) & 255i);
                        let _e1782 = (_e1781 + _e367);
                        if (_e1781 == 255i) {
                            phi_3160_ = _e1772.member.member;
                        } else {
                            if (_e1781 > 0i) {
                                if (_e1782 > 0i) {
                                    let _e1786 = (_e1782 < 255i);
                                    if _e1786 {
                                        phi_3139_ = bitcast<f32>((_e1777 + bitcast<u32>((_e367 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3139_ = f32();
                                    }
                                    let _e1793 = phi_3139_;
                                    phi_3141_ = _e1793;
                                    phi_3142_ = select(true, false, _e1786);
                                } else {
                                    phi_3141_ = f32();
                                    phi_3142_ = true;
                                }
                                let _e1796 = phi_3141_;
                                let _e1798 = phi_3142_;
                                phi_3143_ = _e1796;
                                phi_3144_ = _e1798;
                            } else {
                                phi_3143_ = f32();
                                phi_3144_ = true;
                            }
                            let _e1800 = phi_3143_;
                            let _e1802 = phi_3144_;
                            if _e1802 {
                                let _e1803 = (_e1777 & 2147483648u);
                                let _e1810 = ((_e1777 & 8388607u) | (select(0u, 1u, ((_e1777 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1814 = (_e1810 == 0u);
                                if _e1814 {
                                    phi_3522_ = bitcast<f32>(_e1803);
                                } else {
                                    let _e1819 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1810)), 32u, _e1814) - 8u);
                                    let _e1822 = (_e1810 << bitcast<u32>((_e1819 & 31u)));
                                    let _e1824 = ((_e1782 + select(0i, 1i, (_e1781 == 0i))) - bitcast<i32>(_e1819));
                                    if (_e1824 >= 255i) {
                                        phi_3512_ = bitcast<f32>((_e1803 | 2139095040u));
                                        phi_3513_ = f32();
                                        phi_3514_ = true;
                                    } else {
                                        let _e1826 = (_e1824 > 0i);
                                        if _e1826 {
                                            phi_3506_ = bitcast<f32>(((_e1803 | (bitcast<u32>(_e1824) << bitcast<u32>(23i))) | (_e1822 & 8388607u)));
                                            phi_3507_ = f32();
                                        } else {
                                            if (_e1824 < -24i) {
                                                phi_3472_ = 26u;
                                            } else {
                                                phi_3472_ = bitcast<u32>((1i - _e1824));
                                            }
                                            let _e1831 = phi_3472_;
                                            let _e1832 = (_e1831 & 31u);
                                            let _e1834 = (_e1822 >> bitcast<u32>(_e1832));
                                            let _e1838 = (_e1822 & ((1u << bitcast<u32>(_e1832)) - 1u));
                                            let _e1842 = (1u << bitcast<u32>(((_e1831 - 1u) & 31u)));
                                            if (_e1838 > _e1842) {
                                                phi_3493_ = true;
                                            } else {
                                                if (_e1838 == _e1842) {
                                                    phi_3490_ = ((_e1834 & 1u) == 1u);
                                                } else {
                                                    phi_3490_ = false;
                                                }
                                                let _e1848 = phi_3490_;
                                                phi_3493_ = _e1848;
                                            }
                                            let _e1850 = phi_3493_;
                                            phi_3506_ = f32();
                                            phi_3507_ = bitcast<f32>((_e1803 | (_e1834 + select(0u, 1u, _e1850))));
                                        }
                                        let _e1863 = phi_3506_;
                                        let _e1865 = phi_3507_;
                                        phi_3512_ = _e1863;
                                        phi_3513_ = _e1865;
                                        phi_3514_ = _e1826;
                                    }
                                    let _e1869 = phi_3512_;
                                    let _e1871 = phi_3513_;
                                    let _e1873 = phi_3514_;
                                    phi_3522_ = select(_e1871, _e1869, _e1873);
                                }
                                let _e1877 = phi_3522_;
                                phi_3159_ = _e1877;
                            } else {
                                phi_3159_ = _e1800;
                            }
                            let _e1879 = phi_3159_;
                            phi_3160_ = _e1879;
                        }
                        let _e1881 = phi_3160_;
                        let _e1882 = bitcast<u32>(_e1881);
                        if ((_e1882 & 2147483647u) >= 2139095040u) {
                            phi_3172_ = bitcast<f32>(((_e1882 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3172_ = _e1881;
                        }
                        let _e1889 = phi_3172_;
                        phi_3177_ = type_28(_e1889, _e1772.member.member_1, _e1772.member.member_2, _e1772.member.member_3);
                    } else {
                        phi_3177_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1894 = phi_3177_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_8.member[_e104] = _e1894;
                    if _e105 {
                    } else {
                        break;
                    }
                    let _e1898 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1898 > 0u) {
                        let _e1900 = (1u < _e100);
                        if _e1900 {
                            if (0u < _e100) {
                            } else {
                                break;
                            }
                            let _e1904 = atomicAdd((&global_9.member[0u]), _e1898);
                            if ((_e1904 + _e1898) < _e1904) {
                                if _e1900 {
                                } else {
                                    break;
                                }
                                let _e1909 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1912 = select(0u, 1u, (_e1894.member_3 != 4294967295u));
                    if (_e1912 > 0u) {
                        let _e1914 = (3u < _e100);
                        if _e1914 {
                            if (2u < _e100) {
                            } else {
                                break;
                            }
                            let _e1918 = atomicAdd((&global_9.member[2u]), _e1912);
                            if ((_e1918 + _e1912) < _e1918) {
                                if _e1914 {
                                } else {
                                    break;
                                }
                                let _e1923 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
