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
    var phi_339_: u32;
    var phi_383_: i32;
    var phi_523_: type_46;
    var phi_629_: i32;
    var phi_630_: i32;
    var phi_640_: bool;
    var phi_650_: u32;
    var phi_651_: u32;
    var phi_653_: bool;
    var phi_658_: u32;
    var phi_691_: i32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_880_: f32;
    var phi_886_: f32;
    var phi_959_: f32;
    var phi_965_: f32;
    var phi_1005_: f32;
    var phi_1011_: f32;
    var phi_1130_: i32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1190_: i32;
    var phi_1212_: u32;
    var phi_1213_: u32;
    var phi_1221_: f32;
    var phi_1222_: f32;
    var phi_3462_: bool;
    var phi_1237_: type_50;
    var phi_1240_: bool;
    var phi_1242_: u32;
    var phi_1244_: u32;
    var phi_1246_: u32;
    var phi_1257_: bool;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: u32;
    var phi_2640_: type_55;
    var phi_3002_: u32;
    var phi_3029_: u32;
    var phi_3030_: u32;
    var phi_3031_: u32;
    var phi_3033_: u32;
    var phi_3034_: u32;
    var phi_3035_: bool;
    var phi_3044_: u32;
    var phi_3049_: bool;
    var phi_3050_: u32;
    var phi_1306_: type_50;
    var phi_1309_: type_8;
    var phi_1310_: type_8;
    var phi_1332_: type_8;
    var phi_1353_: u32;
    var phi_1445_: array<array<f32, 3>, 3>;
    var phi_1975_: f32;
    var phi_1976_: f32;
    var phi_1977_: f32;
    var phi_1978_: f32;
    var phi_1979_: vec3<f32>;
    var phi_1980_: vec3<f32>;
    var phi_1981_: vec3<f32>;
    var phi_1982_: vec3<f32>;
    var phi_2173_: f32;
    var phi_2193_: type_54;
    var phi_2194_: type_54;
    var phi_2197_: type_54;
    var phi_2198_: type_54;
    var phi_2199_: bool;
    var phi_2203_: type_54;
    var phi_2212_: type_28;
    var phi_2235_: u32;
    var phi_2249_: i32;
    var phi_2271_: vec3<f32>;
    var phi_2272_: vec3<f32>;
    var phi_2290_: vec3<f32>;
    var phi_2291_: vec3<f32>;
    var phi_2309_: vec3<f32>;
    var phi_2310_: vec3<f32>;
    var phi_2346_: vec3<f32>;
    var phi_2528_: f32;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2566_: bool;
    var phi_2567_: bool;
    var phi_2573_: type_50;
    var phi_2574_: type_50;
    var phi_2575_: type_50;
    var phi_1307_: type_50;
    var phi_3456_: bool;
    var local_2: type_50;
    var phi_3645_: bool;
    var phi_3052_: type_50;
    var phi_3053_: bool;
    var phi_3054_: u32;
    var phi_3055_: u32;
    var phi_3644_: bool;
    var phi_3056_: type_50;
    var phi_3057_: bool;
    var phi_3058_: u32;
    var phi_3059_: u32;
    var phi_3060_: u32;
    var phi_3643_: bool;
    var phi_3061_: type_50;
    var phi_3062_: bool;
    var phi_3063_: u32;
    var phi_3064_: u32;
    var phi_3065_: u32;
    var phi_3642_: bool;
    var phi_1238_: type_50;
    var phi_1241_: bool;
    var phi_1243_: u32;
    var phi_1245_: u32;
    var phi_1247_: u32;
    var phi_3066_: bool;
    var phi_3641_: bool;
    var local_3: type_50;
    var phi_3104_: f32;
    var phi_3106_: f32;
    var phi_3107_: bool;
    var phi_3108_: f32;
    var phi_3109_: bool;
    var phi_3401_: u32;
    var phi_3419_: bool;
    var phi_3422_: bool;
    var phi_3435_: f32;
    var phi_3436_: f32;
    var phi_3441_: f32;
    var phi_3442_: f32;
    var phi_3443_: bool;
    var phi_3451_: f32;
    var phi_3124_: f32;
    var phi_3125_: f32;
    var phi_3137_: f32;
    var phi_3142_: type_28;
    var local_4: type_50;

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
                phi_339_ = _e109;
            } else {
                phi_339_ = 4294967295u;
            }
            let _e111 = phi_339_;
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
                phi_383_ = -126i;
            } else {
                phi_383_ = select(_e154, 127i, (_e154 > 127i));
            }
            let _e159 = phi_383_;
            let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
            let _e170 = bitcast<f32>((bitcast<u32>(((_e154 - _e159) + 127i)) << bitcast<u32>(23i)));
            if (_e130 == 0u) {
                phi_523_ = type_46(array<f32, 3>(_e147, _e148, _e149), _e130, _e151, _e152);
            } else {
                let _e172 = bitcast<u32>(_e147);
                let _e174 = ((_e172 & 2139095040u) != 0u);
                let _e189 = bitcast<u32>(_e148);
                let _e191 = ((_e189 & 2139095040u) != 0u);
                let _e206 = bitcast<u32>(_e149);
                let _e208 = ((_e206 & 2139095040u) != 0u);
                let _e224 = bitcast<u32>(_e151);
                let _e226 = ((_e224 & 2139095040u) != 0u);
                phi_523_ = type_46(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e172 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e172 & 2147483648u))), _e147, _e174) * _e164) * select(0.00000011920929f, 1f, _e174)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e189 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e189 & 2147483648u))), _e148, _e191) * _e164) * select(0.00000011920929f, 1f, _e191)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e206 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e206 & 2147483648u))), _e149, _e208) * _e164) * select(0.00000011920929f, 1f, _e208)) * _e170)), _e130, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e224 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e224 & 2147483648u))), _e151, _e226) * _e164) * select(0.00000011920929f, 1f, _e226)) * _e170), _e152);
            }
            let _e243 = phi_523_;
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
                            phi_629_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_629_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_629_;
                        phi_630_ = _e344;
                    } else {
                        phi_630_ = 0i;
                    }
                    let _e346 = phi_630_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_640_ = true;
                    } else {
                        phi_640_ = (_e264 == _e300);
                    }
                    let _e350 = phi_640_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_650_ = _e352;
                        phi_651_ = _e352;
                        phi_653_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_650_ = u32();
                        phi_651_ = 0u;
                        phi_653_ = true;
                    }
                    let _e356 = phi_650_;
                    let _e358 = phi_651_;
                    let _e360 = phi_653_;
                    if _e360 {
                        phi_658_ = (_e358 + 1u);
                    } else {
                        phi_658_ = 0u;
                    }
                    let _e364 = phi_658_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_691_ = -126i;
                    } else {
                        phi_691_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_691_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_7.member[_e104].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_709_ = _e388[0];
                    } else {
                        phi_709_ = _e388[1];
                    }
                    let _e393 = phi_709_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_715_ = _e388[2];
                    } else {
                        phi_715_ = _e393;
                    }
                    let _e397 = phi_715_;
                    let _e398 = bitcast<u32>(_e397);
                    let _e400 = ((_e398 & 2139095040u) != 0u);
                    let _e412 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * select(0.00000011920929f, 1f, _e400));
                    let _e413 = global_7.member[_e104].member.member_2;
                    if _e389 {
                        phi_755_ = _e413[0];
                    } else {
                        phi_755_ = _e413[1];
                    }
                    let _e417 = phi_755_;
                    if _e394 {
                        phi_761_ = _e413[2];
                    } else {
                        phi_761_ = _e417;
                    }
                    let _e420 = phi_761_;
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
                        phi_834_ = _e388[0];
                    } else {
                        phi_834_ = _e388[1];
                    }
                    let _e458 = phi_834_;
                    let _e459 = (_e364 == 2u);
                    if _e459 {
                        phi_840_ = _e388[2];
                    } else {
                        phi_840_ = _e458;
                    }
                    let _e462 = phi_840_;
                    let _e463 = bitcast<u32>(_e462);
                    let _e465 = ((_e463 & 2139095040u) != 0u);
                    let _e477 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e463 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e463 & 2147483648u))), _e462, _e465) * select(0.00000011920929f, 1f, _e465));
                    if _e454 {
                        phi_880_ = _e413[0];
                    } else {
                        phi_880_ = _e413[1];
                    }
                    let _e481 = phi_880_;
                    if _e459 {
                        phi_886_ = _e413[2];
                    } else {
                        phi_886_ = _e481;
                    }
                    let _e484 = phi_886_;
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
                        phi_959_ = _e388[0];
                    } else {
                        phi_959_ = _e388[1];
                    }
                    let _e522 = phi_959_;
                    let _e523 = (_e366 == 2u);
                    if _e523 {
                        phi_965_ = _e388[2];
                    } else {
                        phi_965_ = _e522;
                    }
                    let _e526 = phi_965_;
                    let _e527 = bitcast<u32>(_e526);
                    let _e529 = ((_e527 & 2139095040u) != 0u);
                    let _e541 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e527 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e527 & 2147483648u))), _e526, _e529) * select(0.00000011920929f, 1f, _e529));
                    if _e518 {
                        phi_1005_ = _e413[0];
                    } else {
                        phi_1005_ = _e413[1];
                    }
                    let _e545 = phi_1005_;
                    if _e523 {
                        phi_1011_ = _e413[2];
                    } else {
                        phi_1011_ = _e545;
                    }
                    let _e548 = phi_1011_;
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
                            phi_1130_ = 255i;
                        } else {
                            phi_1130_ = (((_e598 + select(0i, 1i, (_e598 == 0i))) - _e605) + _e346);
                        }
                        let _e613 = phi_1130_;
                        let _e623 = (_e613 <= 0i);
                        if _e623 {
                            phi_1153_ = u32();
                        } else {
                            if _e602 {
                                phi_1152_ = u32();
                            } else {
                                phi_1152_ = select(((bitcast<u32>(_e613) << bitcast<u32>(23i)) | ((_e595 << bitcast<u32>(((_e605 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e613 >= 255i));
                            }
                            let _e627 = phi_1152_;
                            phi_1153_ = _e627;
                        }
                        let _e629 = phi_1153_;
                        let _e641 = ((_e323 & 8388607u) | (select(0u, 1u, ((_e323 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e644 = bitcast<i32>((_e323 >> bitcast<u32>(23i)));
                        let _e648 = (_e641 == 0u);
                        let _e651 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e641)), 32u, _e648)) - 8i);
                        if (_e644 == 255i) {
                            phi_1190_ = 255i;
                        } else {
                            phi_1190_ = (((_e644 + select(0i, 1i, (_e644 == 0i))) - _e651) + _e346);
                        }
                        let _e659 = phi_1190_;
                        let _e669 = (_e659 <= 0i);
                        if _e669 {
                            phi_1213_ = u32();
                        } else {
                            if _e648 {
                                phi_1212_ = u32();
                            } else {
                                phi_1212_ = select(((bitcast<u32>(_e659) << bitcast<u32>(23i)) | ((_e641 << bitcast<u32>(((_e651 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e659 >= 255i));
                            }
                            let _e673 = phi_1212_;
                            phi_1213_ = _e673;
                        }
                        let _e675 = phi_1213_;
                        phi_1221_ = bitcast<f32>(((_e322 & 2147483648u) | select(_e675, 0u, select(_e648, true, _e669))));
                        phi_1222_ = bitcast<f32>(((_e312 & 2147483648u) | select(_e629, 0u, select(_e602, true, _e623))));
                    } else {
                        phi_1221_ = 0f;
                        phi_1222_ = 1f;
                    }
                    let _e681 = phi_1221_;
                    let _e683 = phi_1222_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3462_ = false;
                    phi_1237_ = type_50(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e681);
                    phi_1240_ = (_e683 <= _e681);
                    phi_1242_ = select(0u, 2147483648u, (_e86 == 0u));
                    phi_1244_ = 0u;
                    phi_1246_ = ((3u * _e86) + 1u);
                    loop {
                        let _e691 = phi_3462_;
                        let _e693 = phi_1237_;
                        let _e695 = phi_1240_;
                        let _e697 = phi_1242_;
                        let _e699 = phi_1244_;
                        let _e701 = phi_1246_;
                        local_3 = _e693;
                        if _e695 {
                            phi_1257_ = true;
                        } else {
                            phi_1257_ = (_e699 > 0u);
                        }
                        let _e704 = phi_1257_;
                        if _e704 {
                            let _e705 = (_e701 > 0u);
                            if _e705 {
                                if _e695 {
                                    phi_1289_ = _e695;
                                    phi_1290_ = _e697;
                                    phi_1291_ = _e699;
                                } else {
                                    let _e706 = (_e699 - 1u);
                                    let _e707 = (_e706 % 128u);
                                    let _e708 = (_e707 < 128u);
                                    if _e708 {
                                    } else {
                                        phi_3641_ = true;
                                        break;
                                    }
                                    let _e710 = local_1[_e707];
                                    if _e708 {
                                    } else {
                                        phi_3641_ = true;
                                        break;
                                    }
                                    let _e712 = local[_e707];
                                    phi_1289_ = (_e712 <= _e693.member_1);
                                    phi_1290_ = _e710;
                                    phi_1291_ = _e706;
                                }
                                let _e716 = phi_1289_;
                                let _e718 = phi_1290_;
                                let _e720 = phi_1291_;
                                if _e716 {
                                    if ((_e718 & 2147483648u) != 0u) {
                                        phi_1306_ = _e693;
                                        phi_1309_ = type_8(0u, ((_e718 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e917 = phi_1306_;
                                            let _e919 = phi_1309_;
                                            local_2 = _e917;
                                            local_4 = _e917;
                                            if (_e919.member < _e919.member_1) {
                                                phi_1310_ = type_8((_e919.member + 1u), _e919.member_1);
                                                phi_1332_ = type_8(1u, _e919.member);
                                            } else {
                                                phi_1310_ = _e919;
                                                phi_1332_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e932 = phi_1310_;
                                            let _e934 = phi_1332_;
                                            let _e938 = (bitcast<i32>(_e934.member) != 0i);
                                            if _e938 {
                                                let _e939 = ((_e718 & 268435455u) + _e934.member_1);
                                                let _e940 = (_e939 < _e88);
                                                if _e940 {
                                                    if _e940 {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e944 = global_2.member[_e939].member_1;
                                                    phi_1353_ = _e944;
                                                } else {
                                                    phi_1353_ = 4294967295u;
                                                }
                                                let _e946 = phi_1353_;
                                                if (_e939 >= _e88) {
                                                    phi_1445_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e940 {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e948 = (_e365 % 3u);
                                                    let _e949 = (_e364 % 3u);
                                                    let _e950 = (_e366 % 3u);
                                                    if (_e948 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e956 = global_2.member[_e939].member[_e948];
                                                    if (_e949 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e962 = global_2.member[_e939].member[_e949];
                                                    if (_e950 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e968 = global_2.member[_e939].member[_e950];
                                                    let _e970 = (3u + _e948);
                                                    if (_e970 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e976 = global_2.member[_e939].member[_e970];
                                                    let _e977 = (3u + _e949);
                                                    if (_e977 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e983 = global_2.member[_e939].member[_e977];
                                                    let _e984 = (3u + _e950);
                                                    if (_e984 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e990 = global_2.member[_e939].member[_e984];
                                                    let _e992 = (6u + _e948);
                                                    if (_e992 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e998 = global_2.member[_e939].member[_e992];
                                                    let _e999 = (6u + _e949);
                                                    if (_e999 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e1005 = global_2.member[_e939].member[_e999];
                                                    let _e1006 = (6u + _e950);
                                                    if (_e1006 < 9u) {
                                                    } else {
                                                        phi_3456_ = true;
                                                        break;
                                                    }
                                                    let _e1012 = global_2.member[_e939].member[_e1006];
                                                    phi_1445_ = array<array<f32, 3>, 3>(array<f32, 3>(_e956, _e962, _e968), array<f32, 3>(_e976, _e983, _e990), array<f32, 3>(_e998, _e1005, _e1012));
                                                }
                                                let _e1016 = phi_1445_;
                                                let _e1032 = (_e1016[0][2] - _e541);
                                                let _e1035 = (((_e1016[0][0] - _e412) * _e577) - (_e1032 * _e449));
                                                let _e1038 = (((_e1016[0][1] - _e477) * _e577) - (_e1032 * _e513));
                                                let _e1041 = (_e1016[1][2] - _e541);
                                                let _e1044 = (((_e1016[1][0] - _e412) * _e577) - (_e1041 * _e449));
                                                let _e1047 = (((_e1016[1][1] - _e477) * _e577) - (_e1041 * _e513));
                                                let _e1050 = (_e1016[2][2] - _e541);
                                                let _e1053 = (((_e1016[2][0] - _e412) * _e577) - (_e1050 * _e449));
                                                let _e1056 = (((_e1016[2][1] - _e477) * _e577) - (_e1050 * _e513));
                                                let _e1057 = (_e1053 * _e1047);
                                                let _e1058 = (_e1056 * _e1044);
                                                let _e1059 = (_e1035 * _e1056);
                                                let _e1060 = (_e1038 * _e1053);
                                                let _e1061 = (_e1044 * _e1038);
                                                let _e1062 = (_e1047 * _e1035);
                                                let _e1067 = (((_e1057 >= _e1058) && (_e1059 >= _e1060)) && (_e1061 >= _e1062));
                                                let _e1073 = (_e1067 || (((_e1057 <= _e1058) && (_e1059 <= _e1060)) && (_e1061 <= _e1062)));
                                                if _e1073 {
                                                    let _e1075 = select(-1f, 1f, _e1067);
                                                    let _e1077 = ((_e1057 - _e1058) * _e1075);
                                                    let _e1079 = select(0f, _e1077, (_e1077 > 0f));
                                                    let _e1081 = ((_e1059 - _e1060) * _e1075);
                                                    let _e1083 = select(0f, _e1081, (_e1081 > 0f));
                                                    let _e1085 = ((_e1061 - _e1062) * _e1075);
                                                    let _e1087 = select(0f, _e1085, (_e1085 > 0f));
                                                    let _e1089 = ((_e1079 + _e1083) + _e1087);
                                                    let _e1091 = select(_e1016[1][0], _e1016[0][0], (_e1016[0][0] < _e1016[1][0]));
                                                    let _e1095 = select(_e1016[1][0], _e1016[0][0], (_e1016[0][0] > _e1016[1][0]));
                                                    let _e1099 = select(_e1016[1][1], _e1016[0][1], (_e1016[0][1] < _e1016[1][1]));
                                                    let _e1103 = select(_e1016[1][1], _e1016[0][1], (_e1016[0][1] > _e1016[1][1]));
                                                    let _e1107 = select(_e1016[1][2], _e1016[0][2], (_e1016[0][2] < _e1016[1][2]));
                                                    let _e1111 = select(_e1016[1][2], _e1016[0][2], (_e1016[0][2] > _e1016[1][2]));
                                                    let _e1116 = ((select(_e1016[2][0], _e1091, (_e1091 < _e1016[2][0])) - _e450) * _e453);
                                                    let _e1117 = ((select(_e1016[2][0], _e1095, (_e1095 > _e1016[2][0])) - _e451) * _e453);
                                                    let _e1120 = ((select(_e1016[2][1], _e1099, (_e1099 < _e1016[2][1])) - _e514) * _e517);
                                                    let _e1121 = ((select(_e1016[2][1], _e1103, (_e1103 > _e1016[2][1])) - _e515) * _e517);
                                                    let _e1124 = ((select(_e1016[2][2], _e1107, (_e1107 < _e1016[2][2])) - _e578) * _e581);
                                                    let _e1125 = ((select(_e1016[2][2], _e1111, (_e1111 > _e1016[2][2])) - _e579) * _e581);
                                                    let _e1127 = select(_e1125, _e1124, (_e1124 < _e1125));
                                                    let _e1129 = select(_e1125, _e1124, (_e1124 > _e1125));
                                                    let _e1131 = select(_e1117, _e1116, (_e1116 < _e1117));
                                                    let _e1133 = select(_e1121, _e1120, (_e1120 < _e1121));
                                                    let _e1135 = select(_e1133, _e1131, (_e1131 > _e1133));
                                                    let _e1137 = select(_e1127, _e1135, (_e1135 > _e1127));
                                                    let _e1139 = select(_e1117, _e1116, (_e1116 > _e1117));
                                                    let _e1141 = select(_e1121, _e1120, (_e1120 > _e1121));
                                                    let _e1143 = select(_e1141, _e1139, (_e1139 < _e1141));
                                                    let _e1145 = select(_e1129, _e1143, (_e1143 < _e1129));
                                                    let _e1146 = -(_e1127);
                                                    let _e1152 = select(_e683, _e1137, (_e1137 > _e683));
                                                    let _e1156 = select(_e1044, _e1035, (_e1035 < _e1044));
                                                    let _e1161 = select(_e1044, _e1035, (_e1035 > _e1044));
                                                    let _e1168 = select(_e1047, _e1038, (_e1038 < _e1047));
                                                    let _e1173 = select(_e1047, _e1038, (_e1038 > _e1047));
                                                    let _e1182 = (((((_e1073 && (_e1089 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1053, _e1156, (_e1156 < _e1053)) <= 0f) && (select(_e1053, _e1161, (_e1161 > _e1053)) >= 0f))) && ((select(_e1056, _e1168, (_e1168 < _e1056)) <= 0f) && (select(_e1056, _e1173, (_e1173 > _e1056)) >= 0f))) && (_e1152 <= (_e1145 + (select(_e1146, _e1129, (_e1129 > _e1146)) * 0.0000019073523f)))) && (_e1152 <= _e917.member_1));
                                                    if _e1182 {
                                                        let _e1187 = (_e1016[1][0] - _e1016[0][0]);
                                                        let _e1188 = (_e1016[1][1] - _e1016[0][1]);
                                                        let _e1189 = (_e1016[1][2] - _e1016[0][2]);
                                                        let _e1190 = vec3<f32>(_e1187, _e1188, _e1189);
                                                        let _e1191 = (_e1016[2][0] - _e1016[1][0]);
                                                        let _e1192 = (_e1016[2][1] - _e1016[1][1]);
                                                        let _e1193 = (_e1016[2][2] - _e1016[1][2]);
                                                        let _e1194 = vec3<f32>(_e1191, _e1192, _e1193);
                                                        let _e1195 = (_e1016[0][0] - _e1016[2][0]);
                                                        let _e1196 = (_e1016[0][1] - _e1016[2][1]);
                                                        let _e1197 = (_e1016[0][2] - _e1016[2][2]);
                                                        let _e1198 = vec3<f32>(_e1195, _e1196, _e1197);
                                                        let _e1201 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                        let _e1204 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                        let _e1206 = select(_e1204, _e1201, (_e1201 > _e1204));
                                                        let _e1209 = bitcast<f32>((bitcast<u32>(_e1189) & 2147483647u));
                                                        let _e1211 = select(_e1209, _e1206, (_e1206 > _e1209));
                                                        let _e1214 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                        let _e1217 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                        let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                        let _e1222 = bitcast<f32>((bitcast<u32>(_e1193) & 2147483647u));
                                                        let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                        let _e1227 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                        let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                        let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                        let _e1239 = select(_e1224, _e1211, (_e1211 > _e1224));
                                                        let _e1241 = select(_e1237, _e1239, (_e1239 > _e1237));
                                                        if (_e1211 == _e1241) {
                                                            phi_1975_ = _e1047;
                                                            phi_1976_ = _e1044;
                                                            phi_1977_ = _e1038;
                                                            phi_1978_ = _e1035;
                                                            phi_1979_ = vec3<f32>(_e1016[0][0], _e1016[0][1], _e1016[0][2]);
                                                            phi_1980_ = _e1198;
                                                            phi_1981_ = _e1194;
                                                            phi_1982_ = _e1190;
                                                        } else {
                                                            let _e1243 = (_e1224 == _e1241);
                                                            let _e1248 = vec3(_e1243);
                                                            phi_1975_ = select(_e1038, _e1056, _e1243);
                                                            phi_1976_ = select(_e1035, _e1053, _e1243);
                                                            phi_1977_ = select(_e1056, _e1047, _e1243);
                                                            phi_1978_ = select(_e1053, _e1044, _e1243);
                                                            phi_1979_ = select(vec3<f32>(_e1016[2][0], _e1016[2][1], _e1016[2][2]), vec3<f32>(_e1016[1][0], _e1016[1][1], _e1016[1][2]), _e1248);
                                                            phi_1980_ = select(_e1194, _e1190, _e1248);
                                                            phi_1981_ = select(_e1190, _e1198, _e1248);
                                                            phi_1982_ = select(_e1198, _e1194, _e1248);
                                                        }
                                                        let _e1254 = phi_1975_;
                                                        let _e1256 = phi_1976_;
                                                        let _e1258 = phi_1977_;
                                                        let _e1260 = phi_1978_;
                                                        let _e1262 = phi_1979_;
                                                        let _e1264 = phi_1980_;
                                                        let _e1266 = phi_1981_;
                                                        let _e1268 = phi_1982_;
                                                        let _e1275 = ((_e1266.y * _e1264.z) - (_e1264.y * _e1266.z));
                                                        let _e1280 = ((_e1266.z * _e1264.x) - (_e1264.z * _e1266.x));
                                                        let _e1283 = ((_e1266.x * _e1264.y) - (_e1264.x * _e1266.y));
                                                        let _e1286 = ((_e1079 >= _e1083) && (_e1079 >= _e1087));
                                                        let _e1287 = (_e1083 >= _e1087);
                                                        let _e1301 = (((_e1275 * (select(select(_e1016[2][0], _e1016[1][0], _e1287), _e1016[0][0], _e1286) - _e412)) + (_e1280 * (select(select(_e1016[2][1], _e1016[1][1], _e1287), _e1016[0][1], _e1286) - _e477))) + (_e1283 * (select(select(_e1016[2][2], _e1016[1][2], _e1287), _e1016[0][2], _e1286) - _e541)));
                                                        let _e1306 = (((_e1275 * _e449) + (_e1280 * _e513)) + (_e1283 * _e577));
                                                        let _e1307 = (_e1256 - _e1260);
                                                        let _e1308 = (_e1254 - _e1258);
                                                        let _e1311 = ((_e1307 * _e1307) + (_e1308 * _e1308));
                                                        let _e1318 = (-(((_e1260 * _e1307) + (_e1258 * _e1308))) / select(0.000000000000000000000000000000000000011754944f, _e1311, (_e1311 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1320 = select(1f, _e1318, (_e1318 < 1f));
                                                        let _e1322 = select(0f, _e1320, (_e1320 > 0f));
                                                        let _e1331 = ((_e1262.x + (_e1268.x * _e1322)) - _e412);
                                                        let _e1334 = ((_e1262.y + (_e1268.y * _e1322)) - _e477);
                                                        let _e1337 = ((_e1262.z + (_e1268.z * _e1322)) - _e541);
                                                        let _e1340 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                        let _e1343 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                        let _e1345 = select(_e1343, _e1340, (_e1340 > _e1343));
                                                        let _e1348 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                        let _e1350 = select(_e1348, _e1345, (_e1345 > _e1348));
                                                        let _e1356 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u));
                                                        let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                        let _e1364 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                        let _e1383 = bitcast<f32>((bitcast<u32>(_e1266.x) & 2147483647u));
                                                        let _e1386 = bitcast<f32>((bitcast<u32>(_e1266.y) & 2147483647u));
                                                        let _e1388 = select(_e1386, _e1383, (_e1383 > _e1386));
                                                        let _e1391 = bitcast<f32>((bitcast<u32>(_e1266.z) & 2147483647u));
                                                        let _e1397 = bitcast<f32>((bitcast<u32>(_e1264.x) & 2147483647u));
                                                        let _e1400 = bitcast<f32>((bitcast<u32>(_e1264.y) & 2147483647u));
                                                        let _e1402 = select(_e1400, _e1397, (_e1397 > _e1400));
                                                        let _e1405 = bitcast<f32>((bitcast<u32>(_e1264.z) & 2147483647u));
                                                        let _e1411 = ((bitcast<f32>((bitcast<u32>(((((_e1275 * _e1331) + (_e1280 * _e1334)) + (_e1283 * _e1337)) - _e1301)) & 2147483647u)) <= ((0.0000009536743f * select(_e1241, _e1350, (_e1350 > _e1241))) * select(_e1364, _e1361, (_e1361 > _e1364)))) && !((bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u)) <= ((0.0000038146973f * select(_e1391, _e1388, (_e1388 > _e1391))) * select(_e1405, _e1402, (_e1402 > _e1405))))));
                                                        let _e1412 = (_e1301 / _e1306);
                                                        if (_e1182 && !(_e1411)) {
                                                            let _e1415 = (_e1337 / _e577);
                                                            let _e1423 = (((_e1275 * (_e1331 - (_e449 * _e1415))) + (_e1280 * (_e1334 - (_e513 * _e1415)))) / _e1306);
                                                            phi_2173_ = select(select(_e1415, (_e1415 + _e1423), (bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u)) <= _e1241)), _e1412, _e1411);
                                                        } else {
                                                            phi_2173_ = _e1412;
                                                        }
                                                        let _e1432 = phi_2173_;
                                                        let _e1434 = select(_e1145, _e1432, (_e1432 < _e1145));
                                                        let _e1436 = select(_e1137, _e1434, (_e1434 > _e1137));
                                                        let _e1437 = (1f / _e1089);
                                                        phi_2193_ = type_54(_e1436, (_e1083 * _e1437), (_e1087 * _e1437), ((_e1182 && (_e1436 >= _e683)) && (_e1436 <= _e917.member_1)));
                                                        phi_2194_ = type_54();
                                                    } else {
                                                        phi_2193_ = type_54();
                                                        phi_2194_ = type_54(0f, 0f, 0f, _e1182);
                                                    }
                                                    let _e1446 = phi_2193_;
                                                    let _e1448 = phi_2194_;
                                                    phi_2197_ = _e1446;
                                                    phi_2198_ = _e1448;
                                                    phi_2199_ = select(true, false, _e1182);
                                                } else {
                                                    phi_2197_ = type_54();
                                                    phi_2198_ = type_54(0f, 0f, 0f, _e1073);
                                                    phi_2199_ = true;
                                                }
                                                let _e1451 = phi_2197_;
                                                let _e1453 = phi_2198_;
                                                let _e1455 = phi_2199_;
                                                if _e1455 {
                                                    phi_2203_ = _e1453;
                                                } else {
                                                    phi_2203_ = _e1451;
                                                }
                                                let _e1457 = phi_2203_;
                                                if _e1457.member_3 {
                                                    phi_2212_ = type_28(_e1457.member, _e1457.member_1, _e1457.member_2, _e946);
                                                } else {
                                                    phi_2212_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1464 = phi_2212_;
                                                if (_e1464.member_3 != 4294967295u) {
                                                    if (_e946 == _e111) {
                                                        phi_2547_ = false;
                                                    } else {
                                                        let _e1468 = (_e946 < arrayLength((&global_5.member)));
                                                        if _e1468 {
                                                            if _e1468 {
                                                            } else {
                                                                phi_3456_ = true;
                                                                break;
                                                            }
                                                            let _e1470 = global_5.member[_e946];
                                                            phi_2235_ = _e1470;
                                                        } else {
                                                            phi_2235_ = 4294967295u;
                                                        }
                                                        let _e1472 = phi_2235_;
                                                        let _e1473 = (_e1472 < arrayLength((&global_6.member)));
                                                        if _e1473 {
                                                            if _e1473 {
                                                            } else {
                                                                phi_3456_ = true;
                                                                break;
                                                            }
                                                            let _e1475 = global_6.member[_e1472];
                                                            phi_2249_ = _e1475;
                                                        } else {
                                                            phi_2249_ = 0i;
                                                        }
                                                        let _e1477 = phi_2249_;
                                                        let _e1478 = (_e1477 == 0i);
                                                        if _e1478 {
                                                            phi_2546_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2272_ = vec3<f32>(_e1016[0][0], _e1016[0][1], _e1016[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2271_ = vec3<f32>(_e1016[0][2], _e1016[0][0], _e1016[0][1]);
                                                                } else {
                                                                    phi_2271_ = vec3<f32>(_e1016[0][1], _e1016[0][2], _e1016[0][0]);
                                                                }
                                                                let _e1483 = phi_2271_;
                                                                phi_2272_ = _e1483;
                                                            }
                                                            let _e1486 = phi_2272_;
                                                            if _e389 {
                                                                phi_2291_ = vec3<f32>(_e1016[1][0], _e1016[1][1], _e1016[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2290_ = vec3<f32>(_e1016[1][2], _e1016[1][0], _e1016[1][1]);
                                                                } else {
                                                                    phi_2290_ = vec3<f32>(_e1016[1][1], _e1016[1][2], _e1016[1][0]);
                                                                }
                                                                let _e1491 = phi_2290_;
                                                                phi_2291_ = _e1491;
                                                            }
                                                            let _e1494 = phi_2291_;
                                                            if _e389 {
                                                                phi_2310_ = vec3<f32>(_e1016[2][0], _e1016[2][1], _e1016[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2309_ = vec3<f32>(_e1016[2][2], _e1016[2][0], _e1016[2][1]);
                                                                } else {
                                                                    phi_2309_ = vec3<f32>(_e1016[2][1], _e1016[2][2], _e1016[2][0]);
                                                                }
                                                                let _e1499 = phi_2309_;
                                                                phi_2310_ = _e1499;
                                                            }
                                                            let _e1502 = phi_2310_;
                                                            let _e1505 = (_e1494.x - _e1486.x);
                                                            let _e1508 = (_e1494.y - _e1486.y);
                                                            let _e1511 = (_e1494.z - _e1486.z);
                                                            let _e1513 = (_e1502.x - _e1486.x);
                                                            let _e1515 = (_e1502.y - _e1486.y);
                                                            let _e1517 = (_e1502.z - _e1486.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2346_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1486);
                                                            } else {
                                                                phi_2346_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1532 = phi_2346_;
                                                            let _e1538 = bitcast<f32>((bitcast<u32>((_e1505 * _e1515)) ^ _e243.member_3[0]));
                                                            let _e1542 = bitcast<f32>((bitcast<u32>((_e1508 * _e1513)) ^ _e243.member_3[0]));
                                                            let _e1546 = bitcast<f32>((bitcast<u32>((_e1508 * _e1517)) ^ _e243.member_3[0]));
                                                            let _e1550 = bitcast<f32>((bitcast<u32>((_e1511 * _e1515)) ^ _e243.member_3[0]));
                                                            let _e1554 = bitcast<f32>((bitcast<u32>((_e1511 * _e1513)) ^ _e243.member_3[0]));
                                                            let _e1558 = bitcast<f32>((bitcast<u32>((_e1505 * _e1517)) ^ _e243.member_3[0]));
                                                            let _e1559 = (_e1546 - _e1550);
                                                            let _e1560 = (_e1554 - _e1558);
                                                            let _e1561 = (_e1538 - _e1542);
                                                            let _e1585 = (bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)));
                                                            let _e1592 = (bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u)));
                                                            let _e1599 = (bitcast<f32>((bitcast<u32>(_e1538) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1542) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2528_ = 0f;
                                                            } else {
                                                                let _e1629 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                let _e1632 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                let _e1635 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                let _e1641 = select(_e1635, _e1632, (_e1632 < _e1635));
                                                                let _e1645 = select(_e1632, _e1629, (_e1629 < _e1632));
                                                                let _e1647 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                                let _e1649 = select(_e1635, _e1647, (_e1647 < _e1635));
                                                                phi_2528_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1637, _e1629, (_e1629 > _e1637)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1649, _e1645, (_e1645 > _e1649)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1641, _e1629, (_e1629 < _e1641)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1585 + _e1592) + _e1599))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1676 = phi_2528_;
                                                            phi_2546_ = (_e1478 || !(((((bitcast<f32>((bitcast<u32>((_e1532.x * _e1559)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1532.y * _e1560)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1532.z * _e1561)) ^ _e243.member_3[0]))) * f32(-(_e1477))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.x) & 2147483647u)) * _e1585)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.y) & 2147483647u)) * _e1592)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1532.z) & 2147483647u)) * _e1599)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1676) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1690 = phi_2546_;
                                                        phi_2547_ = _e1690;
                                                    }
                                                    let _e1692 = phi_2547_;
                                                    if _e1692 {
                                                        if (_e1464.member < _e917.member.member) {
                                                            phi_2567_ = true;
                                                        } else {
                                                            if (_e1464.member == _e917.member.member) {
                                                                phi_2566_ = (_e1464.member_3 < _e917.member.member_3);
                                                            } else {
                                                                phi_2566_ = false;
                                                            }
                                                            let _e1702 = phi_2566_;
                                                            phi_2567_ = _e1702;
                                                        }
                                                        let _e1704 = phi_2567_;
                                                        if _e1704 {
                                                            phi_2573_ = type_50(_e1464, _e1464.member);
                                                        } else {
                                                            phi_2573_ = _e917;
                                                        }
                                                        let _e1707 = phi_2573_;
                                                        phi_2574_ = _e1707;
                                                    } else {
                                                        phi_2574_ = _e917;
                                                    }
                                                    let _e1709 = phi_2574_;
                                                    phi_2575_ = _e1709;
                                                } else {
                                                    phi_2575_ = _e917;
                                                }
                                                let _e1711 = phi_2575_;
                                                phi_1307_ = _e1711;
                                            } else {
                                                phi_1307_ = type_50();
                                            }
                                            let _e1713 = phi_1307_;
                                            continue;
                                            continuing {
                                                phi_1306_ = _e1713;
                                                phi_1309_ = _e932;
                                                phi_3456_ = _e691;
                                                break if !(_e938);
                                            }
                                        }
                                        let _e1716 = phi_3456_;
                                        phi_3641_ = _e1716;
                                        if _e1716 {
                                            break;
                                        }
                                        let _e1718 = local_2;
                                        phi_3645_ = _e1716;
                                        let _e2023 = local_4;
                                        phi_3052_ = _e2023;
                                        phi_3053_ = false;
                                        phi_3054_ = _e718;
                                        phi_3055_ = select(_e720, 0u, (_e683 > _e1718.member_1));
                                    } else {
                                        if (_e718 >= _e86) {
                                            phi_2640_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e718 < _e86) {
                                            } else {
                                                phi_3641_ = true;
                                                break;
                                            }
                                            let _e730 = (_e365 % 3u);
                                            if (_e730 < 3u) {
                                            } else {
                                                phi_3641_ = true;
                                                break;
                                            }
                                            let _e736 = global_4.member[_e718].member[_e730];
                                            let _e742 = (_e364 % 3u);
                                            if (_e742 < 3u) {
                                            } else {
                                                phi_3641_ = true;
                                                break;
                                            }
                                            let _e748 = global_4.member[_e718].member[_e742];
                                            let _e754 = (_e366 % 3u);
                                            if (_e754 < 3u) {
                                            } else {
                                                phi_3641_ = true;
                                                break;
                                            }
                                            let _e760 = global_4.member[_e718].member[_e754];
                                            let _e770 = global_4.member[_e718].member_1;
                                            let _e774 = global_4.member[_e718].member_2;
                                            phi_2640_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e736[0], _e736[1], _e736[2], _e736[3]), vec4<f32>(_e748[0], _e748[1], _e748[2], _e748[3]), vec4<f32>(_e760[0], _e760[1], _e760[2], _e760[3])), _e770, _e774);
                                        }
                                        let _e777 = phi_2640_;
                                        let _e789 = ((_e777.member[0].x - _e450) * _e453);
                                        let _e790 = ((_e777.member[0].y - _e450) * _e453);
                                        let _e791 = ((_e777.member[0].z - _e451) * _e453);
                                        let _e792 = ((_e777.member[0].w - _e451) * _e453);
                                        let _e802 = ((_e777.member[1].x - _e514) * _e517);
                                        let _e803 = ((_e777.member[1].y - _e514) * _e517);
                                        let _e804 = ((_e777.member[1].z - _e515) * _e517);
                                        let _e805 = ((_e777.member[1].w - _e515) * _e517);
                                        let _e815 = ((_e777.member[2].x - _e578) * _e581);
                                        let _e816 = ((_e777.member[2].y - _e578) * _e581);
                                        let _e817 = ((_e777.member[2].z - _e579) * _e581);
                                        let _e818 = ((_e777.member[2].w - _e579) * _e581);
                                        let _e820 = select(_e817, _e815, (_e815 < _e817));
                                        let _e822 = select(_e818, _e816, (_e816 < _e818));
                                        let _e824 = select(_e817, _e815, (_e815 > _e817));
                                        let _e826 = select(_e818, _e816, (_e816 > _e818));
                                        let _e828 = select(_e791, _e789, (_e789 < _e791));
                                        let _e830 = select(_e792, _e790, (_e790 < _e792));
                                        let _e832 = select(_e804, _e802, (_e802 < _e804));
                                        let _e834 = select(_e805, _e803, (_e803 < _e805));
                                        let _e836 = select(_e832, _e828, (_e828 > _e832));
                                        let _e838 = select(_e834, _e830, (_e830 > _e834));
                                        let _e840 = select(_e820, _e836, (_e836 > _e820));
                                        let _e842 = select(_e822, _e838, (_e838 > _e822));
                                        let _e844 = select(_e791, _e789, (_e789 > _e791));
                                        let _e846 = select(_e792, _e790, (_e790 > _e792));
                                        let _e848 = select(_e804, _e802, (_e802 > _e804));
                                        let _e850 = select(_e805, _e803, (_e803 > _e805));
                                        let _e852 = select(_e848, _e844, (_e844 < _e848));
                                        let _e854 = select(_e850, _e846, (_e846 < _e850));
                                        let _e859 = -(_e820);
                                        let _e860 = -(_e822);
                                        let _e867 = (select(_e824, _e852, (_e852 < _e824)) + (select(_e859, _e824, (_e824 > _e859)) * 0.0000019073523f));
                                        let _e868 = (select(_e826, _e854, (_e854 < _e826)) + (select(_e860, _e826, (_e826 > _e860)) * 0.0000019073523f));
                                        let _e870 = select(_e683, _e840, (_e840 > _e683));
                                        let _e872 = select(_e683, _e842, (_e842 > _e683));
                                        let _e877 = (_e870 <= select(_e693.member_1, _e867, (_e867 < _e693.member_1)));
                                        let _e878 = (_e872 <= select(_e693.member_1, _e868, (_e868 < _e693.member_1)));
                                        let _e879 = (_e870 <= _e872);
                                        if _e877 {
                                            if _e878 {
                                                if _e879 {
                                                    phi_3002_ = _e777.member_2;
                                                } else {
                                                    phi_3002_ = _e777.member_1;
                                                }
                                                let _e883 = phi_3002_;
                                                let _e885 = (_e720 % 128u);
                                                let _e886 = (_e885 < 128u);
                                                if _e886 {
                                                } else {
                                                    phi_3641_ = true;
                                                    break;
                                                }
                                                local_1[_e885] = _e883;
                                                if _e886 {
                                                } else {
                                                    phi_3641_ = true;
                                                    break;
                                                }
                                                local[_e885] = select(_e870, _e872, _e879);
                                                if _e879 {
                                                    phi_3029_ = _e777.member_1;
                                                } else {
                                                    phi_3029_ = _e777.member_2;
                                                }
                                                let _e893 = phi_3029_;
                                                phi_3030_ = _e893;
                                                phi_3031_ = (_e720 + 1u);
                                            } else {
                                                phi_3030_ = u32();
                                                phi_3031_ = u32();
                                            }
                                            let _e895 = phi_3030_;
                                            let _e897 = phi_3031_;
                                            phi_3033_ = _e895;
                                            phi_3034_ = _e897;
                                            phi_3035_ = select(true, false, _e878);
                                        } else {
                                            phi_3033_ = u32();
                                            phi_3034_ = u32();
                                            phi_3035_ = true;
                                        }
                                        let _e900 = phi_3033_;
                                        let _e902 = phi_3034_;
                                        let _e904 = phi_3035_;
                                        if _e904 {
                                            if _e877 {
                                                phi_3044_ = _e777.member_1;
                                            } else {
                                                phi_3044_ = _e777.member_2;
                                            }
                                            let _e908 = phi_3044_;
                                            phi_3049_ = select(_e878, true, _e877);
                                            phi_3050_ = _e908;
                                        } else {
                                            phi_3049_ = _e716;
                                            phi_3050_ = _e900;
                                        }
                                        let _e911 = phi_3049_;
                                        let _e913 = phi_3050_;
                                        phi_3645_ = _e691;
                                        phi_3052_ = _e693;
                                        phi_3053_ = _e911;
                                        phi_3054_ = _e913;
                                        phi_3055_ = select(_e902, _e720, _e904);
                                    }
                                    let _e1723 = phi_3645_;
                                    let _e1725 = phi_3052_;
                                    let _e1727 = phi_3053_;
                                    let _e1729 = phi_3054_;
                                    let _e1731 = phi_3055_;
                                    phi_3644_ = _e1723;
                                    phi_3056_ = _e1725;
                                    phi_3057_ = _e1727;
                                    phi_3058_ = _e1729;
                                    phi_3059_ = _e1731;
                                    phi_3060_ = (_e701 - 1u);
                                } else {
                                    phi_3644_ = _e691;
                                    phi_3056_ = _e693;
                                    phi_3057_ = _e716;
                                    phi_3058_ = _e718;
                                    phi_3059_ = _e720;
                                    phi_3060_ = _e701;
                                }
                                let _e1733 = phi_3644_;
                                let _e1735 = phi_3056_;
                                let _e1737 = phi_3057_;
                                let _e1739 = phi_3058_;
                                let _e1741 = phi_3059_;
                                let _e1743 = phi_3060_;
                                phi_3643_ = _e1733;
                                phi_3061_ = _e1735;
                                phi_3062_ = _e1737;
                                phi_3063_ = _e1739;
                                phi_3064_ = _e1741;
                                phi_3065_ = _e1743;
                            } else {
                                phi_3643_ = _e691;
                                phi_3061_ = type_50();
                                phi_3062_ = bool();
                                phi_3063_ = u32();
                                phi_3064_ = u32();
                                phi_3065_ = u32();
                            }
                            let _e1745 = phi_3643_;
                            let _e1747 = phi_3061_;
                            let _e1749 = phi_3062_;
                            let _e1751 = phi_3063_;
                            let _e1753 = phi_3064_;
                            let _e1755 = phi_3065_;
                            phi_3642_ = _e1745;
                            phi_1238_ = _e1747;
                            phi_1241_ = _e1749;
                            phi_1243_ = _e1751;
                            phi_1245_ = _e1753;
                            phi_1247_ = _e1755;
                            phi_3066_ = _e705;
                        } else {
                            phi_3642_ = _e691;
                            phi_1238_ = type_50();
                            phi_1241_ = bool();
                            phi_1243_ = u32();
                            phi_1245_ = u32();
                            phi_1247_ = u32();
                            phi_3066_ = false;
                        }
                        let _e1757 = phi_3642_;
                        let _e1759 = phi_1238_;
                        let _e1761 = phi_1241_;
                        let _e1763 = phi_1243_;
                        let _e1765 = phi_1245_;
                        let _e1767 = phi_1247_;
                        let _e1769 = phi_3066_;
                        continue;
                        continuing {
                            phi_3462_ = _e1757;
                            phi_1237_ = _e1759;
                            phi_1240_ = _e1761;
                            phi_1242_ = _e1763;
                            phi_1244_ = _e1765;
                            phi_1246_ = _e1767;
                            phi_3641_ = _e1757;
                            break if !(_e1769);
                        }
                    }
                    let _e1772 = phi_3641_;
                    if _e1772 {
                        break;
                    }
                    let _e1774 = local_3;
                    if (_e1774.member.member_3 != 4294967295u) {
                        let _e1779 = bitcast<u32>(_e1774.member.member);
                        let _e1783 = (bitcast<i32>((_e1779 >> bitcast<u32>(23i))) & 255i);
                        let _e1784 = (_e1783 + _e367);
                        if (_e1783 == 255i) {
                            phi_3125_ = _e1774.member.member;
                        } else {
                            if (_e1783 > 0i) {
                                if (_e1784 > 0i) {
                                    let _e1788 = (_e1784 < 255i);
                                    if _e1788 {
                                        phi_3104_ = bitcast<f32>((_e1779 + bitcast<u32>((_e367 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3104_ = f32();
                                    }
                                    let _e1795 = phi_3104_;
                                    phi_3106_ = _e1795;
                                    phi_3107_ = select(true, false, _e1788);
                                } else {
                                    phi_3106_ = f32();
                                    phi_3107_ = true;
                                }
                                let _e1798 = phi_3106_;
                                let _e1800 = phi_3107_;
                                phi_3108_ = _e1798;
                                phi_3109_ = _e1800;
                            } else {
                                phi_3108_ = f32();
                                phi_3109_ = true;
                            }
                            let _e1802 = phi_3108_;
                            let _e1804 = phi_3109_;
                            if _e1804 {
                                let _e1805 = (_e1779 & 2147483648u);
                                let _e1812 = ((_e1779 & 8388607u) | (select(0u, 1u, ((_e1779 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1816 = (_e1812 == 0u);
                                if _e1816 {
                                    phi_3451_ = bitcast<f32>(_e1805);
                                } else {
                                    let _e1821 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1812)), 32u, _e1816) - 8u);
                                    let _e1824 = (_e1812 << bitcast<u32>((_e1821 & 31u)));
                                    let _e1826 = ((_e1784 + select(0i, 1i, (_e1783 == 0i))) - bitcast<i32>(_e1821));
                                    if (_e1826 >= 255i) {
                                        phi_3441_ = bitcast<f32>((_e1805 | 2139095040u));
                                        phi_3442_ = f32();
                                        phi_3443_ = true;
                                    } else {
                                        let _e1828 = (_e1826 > 0i);
                                        if _e1828 {
                                            phi_3435_ = bitcast<f32>(((_e1805 | (bitcast<u32>(_e1826) << bitcast<u32>(23i))) | (_e1824 & 8388607u)));
                                            phi_3436_ = f32();
                                        } else {
                                            if (_e1826 < -24i) {
                                                phi_3401_ = 26u;
                                            } else {
                                                phi_3401_ = bitcast<u32>((1i - _e1826));
                                            }
                                            let _e1833 = phi_3401_;
                                            let _e1834 = (_e1833 & 31u);
                                            let _e1836 = (_e1824 >> bitcast<u32>(_e1834));
                                            let _e1840 = (_e1824 & ((1u << bitcast<u32>(_e1834)) - 1u));
                                            let _e1844 = (1u << bitcast<u32>(((_e1833 - 1u) & 31u)));
                                            if (_e1840 > _e1844) {
                                                phi_3422_ = true;
                                            } else {
                                                if (_e1840 == _e1844) {
                                                    phi_3419_ = ((_e1836 & 1u) == 1u);
                                                } else {
                                                    phi_3419_ = false;
                                                }
                                                let _e1850 = phi_3419_;
                                                phi_3422_ = _e1850;
                                            }
                                            let _e1852 = phi_3422_;
                                            phi_3435_ = f32();
                                            phi_3436_ = bitcast<f32>((_e1805 | (_e1836 + select(0u, 1u, _e1852))));
                                        }
                                        let _e1865 = phi_3435_;
                                        let _e1867 = phi_3436_;
                                        phi_3441_ = _e1865;
                                        phi_3442_ = _e1867;
                                        phi_3443_ = _e1828;
                                    }
                                    let _e1871 = phi_3441_;
                                    let _e1873 = phi_3442_;
                                    let _e1875 = phi_3443_;
                                    phi_3451_ = select(_e1873, _e1871, _e1875);
                                }
                                let _e1879 = phi_3451_;
                                phi_3124_ = _e1879;
                            } else {
                                phi_3124_ = _e1802;
                            }
                            let _e1881 = phi_3124_;
                            phi_3125_ = _e1881;
                        }
                        let _e1883 = phi_3125_;
                        let _e1884 = bitcast<u32>(_e1883);
                        if ((_e1884 & 2147483647u) >= 2139095040u) {
                            phi_3137_ = bitcast<f32>(((_e1884 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3137_ = _e1883;
                        }
                        let _e1891 = phi_3137_;
                        phi_3142_ = type_28(_e1891, _e1774.member.member_1, _e1774.member.member_2, _e1774.member.member_3);
                    } else {
                        phi_3142_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1896 = phi_3142_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_8.member[_e104] = _e1896;
                    if _e105 {
                    } else {
                        break;
                    }
                    let _e1900 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1900 > 0u) {
                        let _e1902 = (1u < _e100);
                        if _e1902 {
                            if (0u < _e100) {
                            } else {
                                break;
                            }
                            let _e1906 = atomicAdd((&global_9.member[0u]), _e1900);
                            if ((_e1906 + _e1900) < _e1906) {
                                if _e1902 {
                                } else {
                                    break;
                                }
                                let _e1911 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1914 = select(0u, 1u, (_e1896.member_3 != 4294967295u));
                    if (_e1914 > 0u) {
                        let _e1916 = (3u < _e100);
                        if _e1916 {
                            if (2u < _e100) {
                            } else {
                                break;
                            }
                            let _e1920 = atomicAdd((&global_9.member[2u]), _e1914);
                            if ((_e1920 + _e1914) < _e1920) {
                                if _e1916 {
                                } else {
                                    break;
                                }
                                let _e1925 = atomicAdd((&global_9.member[3u]), 1u);
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
