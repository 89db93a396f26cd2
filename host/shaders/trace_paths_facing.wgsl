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
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_56;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_312_: u32;
    var phi_356_: i32;
    var phi_496_: type_46;
    var phi_602_: i32;
    var phi_603_: i32;
    var phi_613_: bool;
    var phi_623_: u32;
    var phi_624_: u32;
    var phi_626_: bool;
    var phi_631_: u32;
    var phi_664_: i32;
    var phi_682_: f32;
    var phi_688_: f32;
    var phi_728_: f32;
    var phi_734_: f32;
    var phi_786_: f32;
    var phi_798_: f32;
    var phi_807_: f32;
    var phi_813_: f32;
    var phi_853_: f32;
    var phi_859_: f32;
    var phi_911_: f32;
    var phi_923_: f32;
    var phi_932_: f32;
    var phi_938_: f32;
    var phi_978_: f32;
    var phi_984_: f32;
    var phi_1036_: f32;
    var phi_1048_: f32;
    var phi_1103_: i32;
    var phi_1125_: u32;
    var phi_1126_: u32;
    var phi_1163_: i32;
    var phi_1185_: u32;
    var phi_1186_: u32;
    var phi_1194_: f32;
    var phi_1195_: f32;
    var phi_3436_: bool;
    var phi_1210_: type_50;
    var phi_1213_: u32;
    var phi_1215_: bool;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1230_: bool;
    var phi_1262_: bool;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1279_: type_50;
    var phi_1282_: type_8;
    var phi_1283_: type_8;
    var phi_1305_: type_8;
    var phi_1326_: u32;
    var phi_1418_: array<array<f32, 3>, 3>;
    var phi_1570_: bool;
    var phi_1599_: bool;
    var phi_2018_: f32;
    var phi_2019_: f32;
    var phi_2020_: f32;
    var phi_2021_: f32;
    var phi_2022_: vec3<f32>;
    var phi_2023_: vec3<f32>;
    var phi_2024_: vec3<f32>;
    var phi_2025_: vec3<f32>;
    var phi_2062_: bool;
    var phi_2071_: vec3<f32>;
    var phi_2236_: f32;
    var phi_2238_: f32;
    var phi_2239_: bool;
    var phi_2259_: f32;
    var phi_2260_: f32;
    var phi_2283_: type_28;
    var phi_2285_: type_28;
    var phi_2286_: bool;
    var phi_2290_: type_28;
    var phi_2291_: type_28;
    var phi_2292_: type_28;
    var phi_2293_: bool;
    var phi_2297_: type_28;
    var phi_2298_: bool;
    var phi_2299_: type_28;
    var phi_2300_: bool;
    var phi_2301_: bool;
    var phi_2302_: type_28;
    var phi_2303_: bool;
    var phi_2304_: bool;
    var phi_2312_: type_28;
    var phi_2313_: bool;
    var phi_2317_: type_28;
    var phi_2340_: u32;
    var phi_2354_: i32;
    var phi_2376_: vec3<f32>;
    var phi_2377_: vec3<f32>;
    var phi_2395_: vec3<f32>;
    var phi_2396_: vec3<f32>;
    var phi_2414_: vec3<f32>;
    var phi_2415_: vec3<f32>;
    var phi_2451_: vec3<f32>;
    var phi_2633_: f32;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2678_: type_50;
    var phi_2679_: type_50;
    var phi_2680_: type_50;
    var phi_1280_: type_50;
    var phi_3430_: bool;
    var phi_3657_: bool;
    var phi_2681_: type_50;
    var phi_2746_: type_54;
    var phi_3108_: u32;
    var phi_3135_: u32;
    var phi_3136_: u32;
    var phi_3137_: u32;
    var phi_3139_: u32;
    var phi_3140_: u32;
    var phi_3141_: bool;
    var phi_3150_: u32;
    var phi_3155_: bool;
    var phi_3157_: u32;
    var phi_3161_: bool;
    var phi_3162_: u32;
    var phi_3163_: u32;
    var phi_3625_: bool;
    var phi_3174_: type_50;
    var phi_3175_: u32;
    var phi_3176_: bool;
    var phi_3177_: u32;
    var phi_3178_: u32;
    var phi_3624_: bool;
    var phi_3179_: type_50;
    var phi_3180_: u32;
    var phi_3181_: bool;
    var phi_3182_: u32;
    var phi_3183_: u32;
    var phi_3623_: bool;
    var phi_1211_: type_50;
    var phi_1214_: u32;
    var phi_1216_: bool;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_3184_: bool;
    var phi_3622_: bool;
    var local_2: type_50;
    var phi_3222_: f32;
    var phi_3224_: f32;
    var phi_3225_: bool;
    var phi_3226_: f32;
    var phi_3227_: bool;
    var phi_3375_: u32;
    var phi_3393_: bool;
    var phi_3396_: bool;
    var phi_3409_: f32;
    var phi_3410_: f32;
    var phi_3415_: f32;
    var phi_3416_: f32;
    var phi_3417_: bool;
    var phi_3425_: f32;
    var phi_3242_: f32;
    var phi_3243_: f32;
    var phi_3255_: f32;
    var phi_3260_: type_28;
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
                phi_312_ = _e109;
            } else {
                phi_312_ = 4294967295u;
            }
            let _e111 = phi_312_;
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
                phi_356_ = -126i;
            } else {
                phi_356_ = select(_e154, 127i, (_e154 > 127i));
            }
            let _e159 = phi_356_;
            let _e164 = bitcast<f32>((bitcast<u32>((_e159 + 127i)) << bitcast<u32>(23i)));
            let _e170 = bitcast<f32>((bitcast<u32>(((_e154 - _e159) + 127i)) << bitcast<u32>(23i)));
            if (_e130 == 0u) {
                phi_496_ = type_46(array<f32, 3>(_e147, _e148, _e149), _e130, _e151, _e152);
            } else {
                let _e172 = bitcast<u32>(_e147);
                let _e174 = ((_e172 & 2139095040u) != 0u);
                let _e189 = bitcast<u32>(_e148);
                let _e191 = ((_e189 & 2139095040u) != 0u);
                let _e206 = bitcast<u32>(_e149);
                let _e208 = ((_e206 & 2139095040u) != 0u);
                let _e224 = bitcast<u32>(_e151);
                let _e226 = ((_e224 & 2139095040u) != 0u);
                phi_496_ = type_46(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e172 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e172 & 2147483648u))), _e147, _e174) * _e164) * select(0.00000011920929f, 1f, _e174)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e189 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e189 & 2147483648u))), _e148, _e191) * _e164) * select(0.00000011920929f, 1f, _e191)) * _e170), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e206 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e206 & 2147483648u))), _e149, _e208) * _e164) * select(0.00000011920929f, 1f, _e208)) * _e170)), _e130, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e224 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e224 & 2147483648u))), _e151, _e226) * _e164) * select(0.00000011920929f, 1f, _e226)) * _e170), _e152);
            }
            let _e243 = phi_496_;
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
                            phi_602_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_602_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_602_;
                        phi_603_ = _e344;
                    } else {
                        phi_603_ = 0i;
                    }
                    let _e346 = phi_603_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_613_ = true;
                    } else {
                        phi_613_ = (_e264 == _e300);
                    }
                    let _e350 = phi_613_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_623_ = _e352;
                        phi_624_ = _e352;
                        phi_626_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_623_ = u32();
                        phi_624_ = 0u;
                        phi_626_ = true;
                    }
                    let _e356 = phi_623_;
                    let _e358 = phi_624_;
                    let _e360 = phi_626_;
                    if _e360 {
                        phi_631_ = (_e358 + 1u);
                    } else {
                        phi_631_ = 0u;
                    }
                    let _e364 = phi_631_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_664_ = -126i;
                    } else {
                        phi_664_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_664_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_7.member[_e104].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_682_ = _e388[0];
                    } else {
                        phi_682_ = _e388[1];
                    }
                    let _e393 = phi_682_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_688_ = _e388[2];
                    } else {
                        phi_688_ = _e393;
                    }
                    let _e397 = phi_688_;
                    let _e398 = bitcast<u32>(_e397);
                    let _e400 = ((_e398 & 2139095040u) != 0u);
                    let _e412 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e398 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e398 & 2147483648u))), _e397, _e400) * select(0.00000011920929f, 1f, _e400));
                    let _e413 = global_7.member[_e104].member.member_2;
                    if _e389 {
                        phi_728_ = _e413[0];
                    } else {
                        phi_728_ = _e413[1];
                    }
                    let _e417 = phi_728_;
                    if _e394 {
                        phi_734_ = _e413[2];
                    } else {
                        phi_734_ = _e417;
                    }
                    let _e420 = phi_734_;
                    let _e421 = bitcast<u32>(_e420);
                    let _e423 = ((_e421 & 2139095040u) != 0u);
                    let _e437 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e421 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e421 & 2147483648u))), _e420, _e423) * _e377) * select(0.00000011920929f, 1f, _e423)) * _e383);
                    let _e441 = (bitcast<f32>((bitcast<u32>(_e437) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e441 {
                        let _e445 = (bitcast<f32>((bitcast<u32>(_e412) & 2147483647u)) * 0.00000011920929f);
                        phi_786_ = select(0.00000000000011368684f, _e445, (_e445 > 0.00000000000011368684f));
                    } else {
                        phi_786_ = 0f;
                    }
                    let _e449 = phi_786_;
                    let _e450 = (_e412 + _e449);
                    let _e451 = (_e412 - _e449);
                    let _e452 = select(_e437, 0f, _e441);
                    if _e441 {
                        phi_798_ = 38685626000000000000000000f;
                    } else {
                        phi_798_ = (1f / _e437);
                    }
                    let _e455 = phi_798_;
                    let _e456 = (_e364 == 0u);
                    if _e456 {
                        phi_807_ = _e388[0];
                    } else {
                        phi_807_ = _e388[1];
                    }
                    let _e460 = phi_807_;
                    let _e461 = (_e364 == 2u);
                    if _e461 {
                        phi_813_ = _e388[2];
                    } else {
                        phi_813_ = _e460;
                    }
                    let _e464 = phi_813_;
                    let _e465 = bitcast<u32>(_e464);
                    let _e467 = ((_e465 & 2139095040u) != 0u);
                    let _e479 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e465 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e465 & 2147483648u))), _e464, _e467) * select(0.00000011920929f, 1f, _e467));
                    if _e456 {
                        phi_853_ = _e413[0];
                    } else {
                        phi_853_ = _e413[1];
                    }
                    let _e483 = phi_853_;
                    if _e461 {
                        phi_859_ = _e413[2];
                    } else {
                        phi_859_ = _e483;
                    }
                    let _e486 = phi_859_;
                    let _e487 = bitcast<u32>(_e486);
                    let _e489 = ((_e487 & 2139095040u) != 0u);
                    let _e503 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e487 & 2147483648u))), _e486, _e489) * _e377) * select(0.00000011920929f, 1f, _e489)) * _e383);
                    let _e507 = (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e507 {
                        let _e511 = (bitcast<f32>((bitcast<u32>(_e479) & 2147483647u)) * 0.00000011920929f);
                        phi_911_ = select(0.00000000000011368684f, _e511, (_e511 > 0.00000000000011368684f));
                    } else {
                        phi_911_ = 0f;
                    }
                    let _e515 = phi_911_;
                    let _e516 = (_e479 + _e515);
                    let _e517 = (_e479 - _e515);
                    let _e518 = select(_e503, 0f, _e507);
                    if _e507 {
                        phi_923_ = 38685626000000000000000000f;
                    } else {
                        phi_923_ = (1f / _e503);
                    }
                    let _e521 = phi_923_;
                    let _e522 = (_e366 == 0u);
                    if _e522 {
                        phi_932_ = _e388[0];
                    } else {
                        phi_932_ = _e388[1];
                    }
                    let _e526 = phi_932_;
                    let _e527 = (_e366 == 2u);
                    if _e527 {
                        phi_938_ = _e388[2];
                    } else {
                        phi_938_ = _e526;
                    }
                    let _e530 = phi_938_;
                    let _e531 = bitcast<u32>(_e530);
                    let _e533 = ((_e531 & 2139095040u) != 0u);
                    let _e545 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e531 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e531 & 2147483648u))), _e530, _e533) * select(0.00000011920929f, 1f, _e533));
                    if _e522 {
                        phi_978_ = _e413[0];
                    } else {
                        phi_978_ = _e413[1];
                    }
                    let _e549 = phi_978_;
                    if _e527 {
                        phi_984_ = _e413[2];
                    } else {
                        phi_984_ = _e549;
                    }
                    let _e552 = phi_984_;
                    let _e553 = bitcast<u32>(_e552);
                    let _e555 = ((_e553 & 2139095040u) != 0u);
                    let _e569 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e553 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e553 & 2147483648u))), _e552, _e555) * _e377) * select(0.00000011920929f, 1f, _e555)) * _e383);
                    let _e573 = (bitcast<f32>((bitcast<u32>(_e569) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e573 {
                        let _e577 = (bitcast<f32>((bitcast<u32>(_e545) & 2147483647u)) * 0.00000011920929f);
                        phi_1036_ = select(0.00000000000011368684f, _e577, (_e577 > 0.00000000000011368684f));
                    } else {
                        phi_1036_ = 0f;
                    }
                    let _e581 = phi_1036_;
                    let _e582 = (_e545 + _e581);
                    let _e583 = (_e545 - _e581);
                    let _e584 = select(_e569, 0f, _e573);
                    if _e573 {
                        phi_1048_ = 38685626000000000000000000f;
                    } else {
                        phi_1048_ = (1f / _e569);
                    }
                    let _e587 = phi_1048_;
                    let _e590 = bitcast<f32>((bitcast<u32>(_e412) & 2147483647u));
                    let _e593 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
                    let _e595 = select(_e593, _e590, (_e590 > _e593));
                    let _e598 = bitcast<f32>((bitcast<u32>(_e545) & 2147483647u));
                    if (_e327 && (select(_e598, _e595, (_e595 > _e598)) <= 1099511600000f)) {
                        let _e610 = ((_e313 & 8388607u) | (select(0u, 1u, ((_e313 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e613 = bitcast<i32>((_e313 >> bitcast<u32>(23i)));
                        let _e617 = (_e610 == 0u);
                        let _e620 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e610)), 32u, _e617)) - 8i);
                        if (_e613 == 255i) {
                            phi_1103_ = 255i;
                        } else {
                            phi_1103_ = (((_e613 + select(0i, 1i, (_e613 == 0i))) - _e620) + _e346);
                        }
                        let _e628 = phi_1103_;
                        let _e638 = (_e628 <= 0i);
                        if _e638 {
                            phi_1126_ = u32();
                        } else {
                            if _e617 {
                                phi_1125_ = u32();
                            } else {
                                phi_1125_ = select(((bitcast<u32>(_e628) << bitcast<u32>(23i)) | ((_e610 << bitcast<u32>(((_e620 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e628 >= 255i));
                            }
                            let _e642 = phi_1125_;
                            phi_1126_ = _e642;
                        }
                        let _e644 = phi_1126_;
                        let _e656 = ((_e323 & 8388607u) | (select(0u, 1u, ((_e323 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e659 = bitcast<i32>((_e323 >> bitcast<u32>(23i)));
                        let _e663 = (_e656 == 0u);
                        let _e666 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e656)), 32u, _e663)) - 8i);
                        if (_e659 == 255i) {
                            phi_1163_ = 255i;
                        } else {
                            phi_1163_ = (((_e659 + select(0i, 1i, (_e659 == 0i))) - _e666) + _e346);
                        }
                        let _e674 = phi_1163_;
                        let _e684 = (_e674 <= 0i);
                        if _e684 {
                            phi_1186_ = u32();
                        } else {
                            if _e663 {
                                phi_1185_ = u32();
                            } else {
                                phi_1185_ = select(((bitcast<u32>(_e674) << bitcast<u32>(23i)) | ((_e656 << bitcast<u32>(((_e666 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e674 >= 255i));
                            }
                            let _e688 = phi_1185_;
                            phi_1186_ = _e688;
                        }
                        let _e690 = phi_1186_;
                        phi_1194_ = bitcast<f32>(((_e322 & 2147483648u) | select(_e690, 0u, select(_e663, true, _e684))));
                        phi_1195_ = bitcast<f32>(((_e312 & 2147483648u) | select(_e644, 0u, select(_e617, true, _e638))));
                    } else {
                        phi_1194_ = 0f;
                        phi_1195_ = 1f;
                    }
                    let _e696 = phi_1194_;
                    let _e698 = phi_1195_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_3436_ = false;
                    phi_1210_ = type_50(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e696);
                    phi_1213_ = ((3u * _e86) + 1u);
                    phi_1215_ = (_e698 <= _e696);
                    phi_1217_ = 0u;
                    phi_1219_ = select(0u, 2147483648u, (_e86 == 0u));
                    loop {
                        let _e706 = phi_3436_;
                        let _e708 = phi_1210_;
                        let _e710 = phi_1213_;
                        let _e712 = phi_1215_;
                        let _e714 = phi_1217_;
                        let _e716 = phi_1219_;
                        local_2 = _e708;
                        if _e712 {
                            phi_1230_ = true;
                        } else {
                            phi_1230_ = (_e714 > 0u);
                        }
                        let _e719 = phi_1230_;
                        if _e719 {
                            let _e720 = (_e710 > 0u);
                            if _e720 {
                                if _e712 {
                                    phi_1262_ = _e712;
                                    phi_1263_ = _e714;
                                    phi_1264_ = _e716;
                                } else {
                                    let _e721 = (_e714 - 1u);
                                    let _e722 = (_e721 % 128u);
                                    let _e723 = (_e722 < 128u);
                                    if _e723 {
                                    } else {
                                        phi_3622_ = true;
                                        break;
                                    }
                                    let _e725 = local_1[_e722];
                                    if _e723 {
                                    } else {
                                        phi_3622_ = true;
                                        break;
                                    }
                                    let _e727 = local[_e722];
                                    phi_1262_ = (_e727 <= _e708.member_1);
                                    phi_1263_ = _e721;
                                    phi_1264_ = _e725;
                                }
                                let _e731 = phi_1262_;
                                let _e733 = phi_1263_;
                                let _e735 = phi_1264_;
                                if _e731 {
                                    let _e738 = ((_e735 & 2147483648u) != 0u);
                                    if _e738 {
                                        phi_1279_ = _e708;
                                        phi_1282_ = type_8(0u, ((_e735 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e745 = phi_1279_;
                                            let _e747 = phi_1282_;
                                            local_3 = _e745;
                                            if (_e747.member < _e747.member_1) {
                                                phi_1283_ = type_8((_e747.member + 1u), _e747.member_1);
                                                phi_1305_ = type_8(1u, _e747.member);
                                            } else {
                                                phi_1283_ = _e747;
                                                phi_1305_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e760 = phi_1283_;
                                            let _e762 = phi_1305_;
                                            let _e766 = (bitcast<i32>(_e762.member) != 0i);
                                            if _e766 {
                                                let _e767 = ((_e735 & 268435455u) + _e762.member_1);
                                                let _e768 = (_e767 < _e88);
                                                if _e768 {
                                                    if _e768 {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e772 = global_2.member[_e767].member_1;
                                                    phi_1326_ = _e772;
                                                } else {
                                                    phi_1326_ = 4294967295u;
                                                }
                                                let _e774 = phi_1326_;
                                                if (_e767 >= _e88) {
                                                    phi_1418_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e768 {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e776 = (_e365 % 3u);
                                                    let _e777 = (_e364 % 3u);
                                                    let _e778 = (_e366 % 3u);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e784 = global_2.member[_e767].member[_e776];
                                                    if (_e777 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e790 = global_2.member[_e767].member[_e777];
                                                    if (_e778 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e796 = global_2.member[_e767].member[_e778];
                                                    let _e798 = (3u + _e776);
                                                    if (_e798 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e804 = global_2.member[_e767].member[_e798];
                                                    let _e805 = (3u + _e777);
                                                    if (_e805 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e811 = global_2.member[_e767].member[_e805];
                                                    let _e812 = (3u + _e778);
                                                    if (_e812 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e818 = global_2.member[_e767].member[_e812];
                                                    let _e820 = (6u + _e776);
                                                    if (_e820 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e826 = global_2.member[_e767].member[_e820];
                                                    let _e827 = (6u + _e777);
                                                    if (_e827 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e833 = global_2.member[_e767].member[_e827];
                                                    let _e834 = (6u + _e778);
                                                    if (_e834 < 9u) {
                                                    } else {
                                                        phi_3430_ = true;
                                                        break;
                                                    }
                                                    let _e840 = global_2.member[_e767].member[_e834];
                                                    phi_1418_ = array<array<f32, 3>, 3>(array<f32, 3>(_e784, _e790, _e796), array<f32, 3>(_e804, _e811, _e818), array<f32, 3>(_e826, _e833, _e840));
                                                }
                                                let _e844 = phi_1418_;
                                                let _e852 = (_e844[0][2] - _e545);
                                                let _e855 = (((_e844[0][0] - _e412) * _e584) - (_e852 * _e452));
                                                let _e858 = (((_e844[0][1] - _e479) * _e584) - (_e852 * _e518));
                                                let _e865 = (_e844[1][2] - _e545);
                                                let _e868 = (((_e844[1][0] - _e412) * _e584) - (_e865 * _e452));
                                                let _e871 = (((_e844[1][1] - _e479) * _e584) - (_e865 * _e518));
                                                let _e878 = (_e844[2][2] - _e545);
                                                let _e881 = (((_e844[2][0] - _e412) * _e584) - (_e878 * _e452));
                                                let _e884 = (((_e844[2][1] - _e479) * _e584) - (_e878 * _e518));
                                                let _e885 = (_e881 * _e871);
                                                let _e886 = (_e884 * _e868);
                                                let _e887 = (_e855 * _e884);
                                                let _e888 = (_e858 * _e881);
                                                let _e889 = (_e868 * _e858);
                                                let _e890 = (_e871 * _e855);
                                                let _e895 = (((_e885 >= _e886) && (_e887 >= _e888)) && (_e889 >= _e890));
                                                if (_e895 || (((_e885 <= _e886) && (_e887 <= _e888)) && (_e889 <= _e890))) {
                                                    let _e902 = select(-1f, 1f, _e895);
                                                    let _e904 = ((_e885 - _e886) * _e902);
                                                    let _e906 = select(0f, _e904, (_e904 > 0f));
                                                    let _e908 = ((_e887 - _e888) * _e902);
                                                    let _e910 = select(0f, _e908, (_e908 > 0f));
                                                    let _e912 = ((_e889 - _e890) * _e902);
                                                    let _e914 = select(0f, _e912, (_e912 > 0f));
                                                    let _e916 = ((_e906 + _e910) + _e914);
                                                    if (_e916 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2302_ = type_28();
                                                        phi_2303_ = true;
                                                        phi_2304_ = false;
                                                    } else {
                                                        let _e919 = select(_e868, _e855, (_e855 < _e868));
                                                        if (select(_e881, _e919, (_e919 < _e881)) > 0f) {
                                                            phi_1570_ = true;
                                                        } else {
                                                            let _e924 = select(_e868, _e855, (_e855 > _e868));
                                                            phi_1570_ = (select(_e881, _e924, (_e924 > _e881)) < 0f);
                                                        }
                                                        let _e929 = phi_1570_;
                                                        if _e929 {
                                                            phi_2299_ = type_28();
                                                            phi_2300_ = true;
                                                            phi_2301_ = false;
                                                        } else {
                                                            let _e931 = select(_e871, _e858, (_e858 < _e871));
                                                            if (select(_e884, _e931, (_e931 < _e884)) > 0f) {
                                                                phi_1599_ = true;
                                                            } else {
                                                                let _e936 = select(_e871, _e858, (_e858 > _e871));
                                                                phi_1599_ = (select(_e884, _e936, (_e936 > _e884)) < 0f);
                                                            }
                                                            let _e941 = phi_1599_;
                                                            if _e941 {
                                                                phi_2297_ = type_28();
                                                                phi_2298_ = false;
                                                            } else {
                                                                let _e943 = select(_e844[1][0], _e844[0][0], (_e844[0][0] < _e844[1][0]));
                                                                let _e947 = select(_e844[1][0], _e844[0][0], (_e844[0][0] > _e844[1][0]));
                                                                let _e951 = select(_e844[1][1], _e844[0][1], (_e844[0][1] < _e844[1][1]));
                                                                let _e955 = select(_e844[1][1], _e844[0][1], (_e844[0][1] > _e844[1][1]));
                                                                let _e959 = select(_e844[1][2], _e844[0][2], (_e844[0][2] < _e844[1][2]));
                                                                let _e963 = select(_e844[1][2], _e844[0][2], (_e844[0][2] > _e844[1][2]));
                                                                let _e968 = ((select(_e844[2][0], _e943, (_e943 < _e844[2][0])) - _e450) * _e455);
                                                                let _e969 = ((select(_e844[2][0], _e947, (_e947 > _e844[2][0])) - _e451) * _e455);
                                                                let _e972 = ((select(_e844[2][1], _e951, (_e951 < _e844[2][1])) - _e516) * _e521);
                                                                let _e973 = ((select(_e844[2][1], _e955, (_e955 > _e844[2][1])) - _e517) * _e521);
                                                                let _e976 = ((select(_e844[2][2], _e959, (_e959 < _e844[2][2])) - _e582) * _e587);
                                                                let _e977 = ((select(_e844[2][2], _e963, (_e963 > _e844[2][2])) - _e583) * _e587);
                                                                let _e979 = select(_e977, _e976, (_e976 < _e977));
                                                                let _e981 = select(_e977, _e976, (_e976 > _e977));
                                                                let _e983 = select(_e969, _e968, (_e968 < _e969));
                                                                let _e985 = select(_e973, _e972, (_e972 < _e973));
                                                                let _e987 = select(_e985, _e983, (_e983 > _e985));
                                                                let _e989 = select(_e979, _e987, (_e987 > _e979));
                                                                let _e991 = select(_e969, _e968, (_e968 > _e969));
                                                                let _e993 = select(_e973, _e972, (_e972 > _e973));
                                                                let _e995 = select(_e993, _e991, (_e991 < _e993));
                                                                let _e997 = select(_e981, _e995, (_e995 < _e981));
                                                                let _e998 = -(_e979);
                                                                let _e1004 = select(_e698, _e989, (_e989 > _e698));
                                                                if (_e1004 > (_e997 + (select(_e998, _e981, (_e981 > _e998)) * 0.0000019073523f))) {
                                                                    phi_2292_ = type_28();
                                                                    phi_2293_ = true;
                                                                } else {
                                                                    let _e1006 = (_e1004 > _e745.member_1);
                                                                    if _e1006 {
                                                                        phi_2291_ = type_28();
                                                                    } else {
                                                                        let _e1007 = vec3<f32>(_e844[0][0], _e844[0][1], _e844[0][2]);
                                                                        let _e1008 = vec3<f32>(_e844[1][0], _e844[1][1], _e844[1][2]);
                                                                        let _e1009 = vec3<f32>(_e844[2][0], _e844[2][1], _e844[2][2]);
                                                                        let _e1010 = (_e844[1][0] - _e844[0][0]);
                                                                        let _e1011 = (_e844[1][1] - _e844[0][1]);
                                                                        let _e1012 = (_e844[1][2] - _e844[0][2]);
                                                                        let _e1013 = vec3<f32>(_e1010, _e1011, _e1012);
                                                                        let _e1014 = (_e844[2][0] - _e844[1][0]);
                                                                        let _e1015 = (_e844[2][1] - _e844[1][1]);
                                                                        let _e1016 = (_e844[2][2] - _e844[1][2]);
                                                                        let _e1017 = vec3<f32>(_e1014, _e1015, _e1016);
                                                                        let _e1018 = (_e844[0][0] - _e844[2][0]);
                                                                        let _e1019 = (_e844[0][1] - _e844[2][1]);
                                                                        let _e1020 = (_e844[0][2] - _e844[2][2]);
                                                                        let _e1021 = vec3<f32>(_e1018, _e1019, _e1020);
                                                                        let _e1024 = bitcast<f32>((bitcast<u32>(_e1010) & 2147483647u));
                                                                        let _e1027 = bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u));
                                                                        let _e1029 = select(_e1027, _e1024, (_e1024 > _e1027));
                                                                        let _e1032 = bitcast<f32>((bitcast<u32>(_e1012) & 2147483647u));
                                                                        let _e1034 = select(_e1032, _e1029, (_e1029 > _e1032));
                                                                        let _e1037 = bitcast<f32>((bitcast<u32>(_e1014) & 2147483647u));
                                                                        let _e1040 = bitcast<f32>((bitcast<u32>(_e1015) & 2147483647u));
                                                                        let _e1042 = select(_e1040, _e1037, (_e1037 > _e1040));
                                                                        let _e1045 = bitcast<f32>((bitcast<u32>(_e1016) & 2147483647u));
                                                                        let _e1047 = select(_e1045, _e1042, (_e1042 > _e1045));
                                                                        let _e1050 = bitcast<f32>((bitcast<u32>(_e1018) & 2147483647u));
                                                                        let _e1053 = bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u));
                                                                        let _e1055 = select(_e1053, _e1050, (_e1050 > _e1053));
                                                                        let _e1058 = bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u));
                                                                        let _e1060 = select(_e1058, _e1055, (_e1055 > _e1058));
                                                                        let _e1062 = select(_e1047, _e1034, (_e1034 > _e1047));
                                                                        let _e1064 = select(_e1060, _e1062, (_e1062 > _e1060));
                                                                        if (_e1034 == _e1064) {
                                                                            phi_2018_ = _e871;
                                                                            phi_2019_ = _e868;
                                                                            phi_2020_ = _e858;
                                                                            phi_2021_ = _e855;
                                                                            phi_2022_ = _e1007;
                                                                            phi_2023_ = _e1021;
                                                                            phi_2024_ = _e1017;
                                                                            phi_2025_ = _e1013;
                                                                        } else {
                                                                            let _e1066 = (_e1047 == _e1064);
                                                                            let _e1071 = vec3(_e1066);
                                                                            phi_2018_ = select(_e858, _e884, _e1066);
                                                                            phi_2019_ = select(_e855, _e881, _e1066);
                                                                            phi_2020_ = select(_e884, _e871, _e1066);
                                                                            phi_2021_ = select(_e881, _e868, _e1066);
                                                                            phi_2022_ = select(_e1009, _e1008, _e1071);
                                                                            phi_2023_ = select(_e1017, _e1013, _e1071);
                                                                            phi_2024_ = select(_e1013, _e1021, _e1071);
                                                                            phi_2025_ = select(_e1021, _e1017, _e1071);
                                                                        }
                                                                        let _e1077 = phi_2018_;
                                                                        let _e1079 = phi_2019_;
                                                                        let _e1081 = phi_2020_;
                                                                        let _e1083 = phi_2021_;
                                                                        let _e1085 = phi_2022_;
                                                                        let _e1087 = phi_2023_;
                                                                        let _e1089 = phi_2024_;
                                                                        let _e1091 = phi_2025_;
                                                                        let _e1098 = ((_e1089.y * _e1087.z) - (_e1087.y * _e1089.z));
                                                                        let _e1103 = ((_e1089.z * _e1087.x) - (_e1087.z * _e1089.x));
                                                                        let _e1106 = ((_e1089.x * _e1087.y) - (_e1087.x * _e1089.y));
                                                                        if (_e906 >= _e910) {
                                                                            phi_2062_ = select(true, false, (_e906 >= _e914));
                                                                        } else {
                                                                            phi_2062_ = true;
                                                                        }
                                                                        let _e1111 = phi_2062_;
                                                                        if _e1111 {
                                                                            phi_2071_ = select(_e1009, _e1008, vec3((_e910 >= _e914)));
                                                                        } else {
                                                                            phi_2071_ = _e1007;
                                                                        }
                                                                        let _e1116 = phi_2071_;
                                                                        let _e1127 = (((_e1098 * (_e1116.x - _e412)) + (_e1103 * (_e1116.y - _e479))) + (_e1106 * (_e1116.z - _e545)));
                                                                        let _e1132 = (((_e1098 * _e452) + (_e1103 * _e518)) + (_e1106 * _e584));
                                                                        let _e1133 = (_e1079 - _e1083);
                                                                        let _e1134 = (_e1077 - _e1081);
                                                                        let _e1142 = (-(((_e1083 * _e1133) + (_e1081 * _e1134))) / ((_e1133 * _e1133) + (_e1134 * _e1134)));
                                                                        let _e1144 = select(1f, _e1142, (_e1142 < 1f));
                                                                        let _e1146 = select(0f, _e1144, (_e1144 > 0f));
                                                                        let _e1159 = ((_e1085.x + (_e1091.x * _e1146)) - _e412);
                                                                        let _e1160 = ((_e1085.y + (_e1091.y * _e1146)) - _e479);
                                                                        let _e1161 = ((_e1085.z + (_e1091.z * _e1146)) - _e545);
                                                                        let _e1162 = (_e1161 / _e584);
                                                                        let _e1174 = bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u));
                                                                        let _e1177 = bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u));
                                                                        let _e1179 = select(_e1177, _e1174, (_e1174 > _e1177));
                                                                        let _e1182 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
                                                                        let _e1184 = select(_e1182, _e1179, (_e1179 > _e1182));
                                                                        let _e1190 = bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u));
                                                                        let _e1193 = bitcast<f32>((bitcast<u32>(_e1103) & 2147483647u));
                                                                        let _e1195 = select(_e1193, _e1190, (_e1190 > _e1193));
                                                                        let _e1198 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1098 * _e1159) + (_e1103 * _e1160)) + (_e1106 * _e1161)) - _e1127)) & 2147483647u)) <= ((0.0000009536743f * select(_e1064, _e1184, (_e1184 > _e1064))) * select(_e1198, _e1195, (_e1195 > _e1198)))) {
                                                                            let _e1208 = bitcast<f32>((bitcast<u32>(_e1089.x) & 2147483647u));
                                                                            let _e1211 = bitcast<f32>((bitcast<u32>(_e1089.y) & 2147483647u));
                                                                            let _e1213 = select(_e1211, _e1208, (_e1208 > _e1211));
                                                                            let _e1216 = bitcast<f32>((bitcast<u32>(_e1089.z) & 2147483647u));
                                                                            let _e1222 = bitcast<f32>((bitcast<u32>(_e1087.x) & 2147483647u));
                                                                            let _e1225 = bitcast<f32>((bitcast<u32>(_e1087.y) & 2147483647u));
                                                                            let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                            let _e1230 = bitcast<f32>((bitcast<u32>(_e1087.z) & 2147483647u));
                                                                            let _e1234 = (bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u)) > ((0.0000038146973f * select(_e1216, _e1213, (_e1213 > _e1216))) * select(_e1230, _e1227, (_e1227 > _e1230))));
                                                                            if _e1234 {
                                                                                phi_2236_ = (_e1127 / _e1132);
                                                                            } else {
                                                                                phi_2236_ = f32();
                                                                            }
                                                                            let _e1237 = phi_2236_;
                                                                            phi_2238_ = _e1237;
                                                                            phi_2239_ = select(true, false, _e1234);
                                                                        } else {
                                                                            phi_2238_ = f32();
                                                                            phi_2239_ = true;
                                                                        }
                                                                        let _e1240 = phi_2238_;
                                                                        let _e1242 = phi_2239_;
                                                                        if _e1242 {
                                                                            let _e1250 = (((_e1098 * (_e1159 - (_e452 * _e1162))) + (_e1103 * (_e1160 - (_e518 * _e1162)))) / _e1132);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u)) <= _e1064) {
                                                                                phi_2259_ = (_e1162 + _e1250);
                                                                            } else {
                                                                                phi_2259_ = _e1162;
                                                                            }
                                                                            let _e1257 = phi_2259_;
                                                                            phi_2260_ = _e1257;
                                                                        } else {
                                                                            phi_2260_ = _e1240;
                                                                        }
                                                                        let _e1259 = phi_2260_;
                                                                        let _e1261 = select(_e997, _e1259, (_e1259 < _e997));
                                                                        let _e1263 = select(_e989, _e1261, (_e1261 > _e989));
                                                                        if (_e1263 >= _e698) {
                                                                            let _e1265 = (_e1263 <= _e745.member_1);
                                                                            if _e1265 {
                                                                                let _e1266 = (1f / _e916);
                                                                                phi_2283_ = type_28(_e1263, (_e910 * _e1266), (_e914 * _e1266), _e774);
                                                                            } else {
                                                                                phi_2283_ = type_28();
                                                                            }
                                                                            let _e1271 = phi_2283_;
                                                                            phi_2285_ = _e1271;
                                                                            phi_2286_ = select(true, false, _e1265);
                                                                        } else {
                                                                            phi_2285_ = type_28();
                                                                            phi_2286_ = true;
                                                                        }
                                                                        let _e1274 = phi_2285_;
                                                                        let _e1276 = phi_2286_;
                                                                        if _e1276 {
                                                                            phi_2290_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2290_ = _e1274;
                                                                        }
                                                                        let _e1278 = phi_2290_;
                                                                        phi_2291_ = _e1278;
                                                                    }
                                                                    let _e1280 = phi_2291_;
                                                                    phi_2292_ = _e1280;
                                                                    phi_2293_ = _e1006;
                                                                }
                                                                let _e1282 = phi_2292_;
                                                                let _e1284 = phi_2293_;
                                                                phi_2297_ = _e1282;
                                                                phi_2298_ = _e1284;
                                                            }
                                                            let _e1286 = phi_2297_;
                                                            let _e1288 = phi_2298_;
                                                            phi_2299_ = _e1286;
                                                            phi_2300_ = _e941;
                                                            phi_2301_ = _e1288;
                                                        }
                                                        let _e1290 = phi_2299_;
                                                        let _e1292 = phi_2300_;
                                                        let _e1294 = phi_2301_;
                                                        phi_2302_ = _e1290;
                                                        phi_2303_ = _e1292;
                                                        phi_2304_ = _e1294;
                                                    }
                                                    let _e1296 = phi_2302_;
                                                    let _e1298 = phi_2303_;
                                                    let _e1300 = phi_2304_;
                                                    phi_2312_ = _e1296;
                                                    phi_2313_ = select(_e1300, true, _e1298);
                                                } else {
                                                    phi_2312_ = type_28();
                                                    phi_2313_ = true;
                                                }
                                                let _e1303 = phi_2312_;
                                                let _e1305 = phi_2313_;
                                                if _e1305 {
                                                    phi_2317_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2317_ = _e1303;
                                                }
                                                let _e1307 = phi_2317_;
                                                if (_e1307.member_3 != 4294967295u) {
                                                    if (_e774 == _e111) {
                                                        phi_2652_ = false;
                                                    } else {
                                                        let _e1311 = (_e774 < arrayLength((&global_5.member)));
                                                        if _e1311 {
                                                            if _e1311 {
                                                            } else {
                                                                phi_3430_ = true;
                                                                break;
                                                            }
                                                            let _e1313 = global_5.member[_e774];
                                                            phi_2340_ = _e1313;
                                                        } else {
                                                            phi_2340_ = 4294967295u;
                                                        }
                                                        let _e1315 = phi_2340_;
                                                        let _e1316 = (_e1315 < arrayLength((&global_6.member)));
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_3430_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_6.member[_e1315];
                                                            phi_2354_ = _e1318;
                                                        } else {
                                                            phi_2354_ = 0i;
                                                        }
                                                        let _e1320 = phi_2354_;
                                                        let _e1321 = (_e1320 == 0i);
                                                        if _e1321 {
                                                            phi_2651_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2377_ = vec3<f32>(_e844[0][0], _e844[0][1], _e844[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2376_ = vec3<f32>(_e844[0][2], _e844[0][0], _e844[0][1]);
                                                                } else {
                                                                    phi_2376_ = vec3<f32>(_e844[0][1], _e844[0][2], _e844[0][0]);
                                                                }
                                                                let _e1326 = phi_2376_;
                                                                phi_2377_ = _e1326;
                                                            }
                                                            let _e1329 = phi_2377_;
                                                            if _e389 {
                                                                phi_2396_ = vec3<f32>(_e844[1][0], _e844[1][1], _e844[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2395_ = vec3<f32>(_e844[1][2], _e844[1][0], _e844[1][1]);
                                                                } else {
                                                                    phi_2395_ = vec3<f32>(_e844[1][1], _e844[1][2], _e844[1][0]);
                                                                }
                                                                let _e1334 = phi_2395_;
                                                                phi_2396_ = _e1334;
                                                            }
                                                            let _e1337 = phi_2396_;
                                                            if _e389 {
                                                                phi_2415_ = vec3<f32>(_e844[2][0], _e844[2][1], _e844[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2414_ = vec3<f32>(_e844[2][2], _e844[2][0], _e844[2][1]);
                                                                } else {
                                                                    phi_2414_ = vec3<f32>(_e844[2][1], _e844[2][2], _e844[2][0]);
                                                                }
                                                                let _e1342 = phi_2414_;
                                                                phi_2415_ = _e1342;
                                                            }
                                                            let _e1345 = phi_2415_;
                                                            let _e1348 = (_e1337.x - _e1329.x);
                                                            let _e1351 = (_e1337.y - _e1329.y);
                                                            let _e1354 = (_e1337.z - _e1329.z);
                                                            let _e1356 = (_e1345.x - _e1329.x);
                                                            let _e1358 = (_e1345.y - _e1329.y);
                                                            let _e1360 = (_e1345.z - _e1329.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2451_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1329);
                                                            } else {
                                                                phi_2451_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1375 = phi_2451_;
                                                            let _e1381 = bitcast<f32>((bitcast<u32>((_e1348 * _e1358)) ^ _e243.member_3[0]));
                                                            let _e1385 = bitcast<f32>((bitcast<u32>((_e1351 * _e1356)) ^ _e243.member_3[0]));
                                                            let _e1389 = bitcast<f32>((bitcast<u32>((_e1351 * _e1360)) ^ _e243.member_3[0]));
                                                            let _e1393 = bitcast<f32>((bitcast<u32>((_e1354 * _e1358)) ^ _e243.member_3[0]));
                                                            let _e1397 = bitcast<f32>((bitcast<u32>((_e1354 * _e1356)) ^ _e243.member_3[0]));
                                                            let _e1401 = bitcast<f32>((bitcast<u32>((_e1348 * _e1360)) ^ _e243.member_3[0]));
                                                            let _e1402 = (_e1389 - _e1393);
                                                            let _e1403 = (_e1397 - _e1401);
                                                            let _e1404 = (_e1381 - _e1385);
                                                            let _e1428 = (bitcast<f32>((bitcast<u32>(_e1389) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1393) & 2147483647u)));
                                                            let _e1435 = (bitcast<f32>((bitcast<u32>(_e1397) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1401) & 2147483647u)));
                                                            let _e1442 = (bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1385) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2633_ = 0f;
                                                            } else {
                                                                let _e1472 = bitcast<f32>((bitcast<u32>(_e1402) & 2147483647u));
                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1403) & 2147483647u));
                                                                let _e1478 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                                let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                                let _e1484 = select(_e1478, _e1475, (_e1475 < _e1478));
                                                                let _e1488 = select(_e1475, _e1472, (_e1472 < _e1475));
                                                                let _e1490 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                                let _e1492 = select(_e1478, _e1490, (_e1490 < _e1478));
                                                                phi_2633_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1480, _e1472, (_e1472 > _e1480)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1492, _e1488, (_e1488 > _e1492)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1484, _e1472, (_e1472 < _e1484)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1428 + _e1435) + _e1442))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1519 = phi_2633_;
                                                            phi_2651_ = (_e1321 || !(((((bitcast<f32>((bitcast<u32>((_e1375.x * _e1402)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1375.y * _e1403)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1375.z * _e1404)) ^ _e243.member_3[0]))) * f32(-(_e1320))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1375.x) & 2147483647u)) * _e1428)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1375.y) & 2147483647u)) * _e1435)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1375.z) & 2147483647u)) * _e1442)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1519) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1533 = phi_2651_;
                                                        phi_2652_ = _e1533;
                                                    }
                                                    let _e1535 = phi_2652_;
                                                    if _e1535 {
                                                        if (_e1307.member < _e745.member.member) {
                                                            phi_2672_ = true;
                                                        } else {
                                                            if (_e1307.member == _e745.member.member) {
                                                                phi_2671_ = (_e1307.member_3 < _e745.member.member_3);
                                                            } else {
                                                                phi_2671_ = false;
                                                            }
                                                            let _e1545 = phi_2671_;
                                                            phi_2672_ = _e1545;
                                                        }
                                                        let _e1547 = phi_2672_;
                                                        if _e1547 {
                                                            phi_2678_ = type_50(_e1307, _e1307.member);
                                                        } else {
                                                            phi_2678_ = _e745;
                                                        }
                                                        let _e1550 = phi_2678_;
                                                        phi_2679_ = _e1550;
                                                    } else {
                                                        phi_2679_ = _e745;
                                                    }
                                                    let _e1552 = phi_2679_;
                                                    phi_2680_ = _e1552;
                                                } else {
                                                    phi_2680_ = _e745;
                                                }
                                                let _e1554 = phi_2680_;
                                                phi_1280_ = _e1554;
                                            } else {
                                                phi_1280_ = type_50();
                                            }
                                            let _e1556 = phi_1280_;
                                            continue;
                                            continuing {
                                                phi_1279_ = _e1556;
                                                phi_1282_ = _e760;
                                                phi_3430_ = _e706;
                                                break if !(_e766);
                                            }
                                        }
                                        let _e1559 = phi_3430_;
                                        phi_3622_ = _e1559;
                                        if _e1559 {
                                            break;
                                        }
                                        phi_3657_ = _e1559;
                                        let _e2064 = local_3;
                                        phi_2681_ = _e2064;
                                    } else {
                                        phi_3657_ = _e706;
                                        phi_2681_ = _e708;
                                    }
                                    let _e1561 = phi_3657_;
                                    let _e1563 = phi_2681_;
                                    if _e738 {
                                        phi_3161_ = bool();
                                        phi_3162_ = u32();
                                        phi_3163_ = u32();
                                    } else {
                                        if (_e735 >= _e86) {
                                            phi_2746_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e735 < _e86) {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e1566 = (_e365 % 3u);
                                            if (_e1566 < 3u) {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e1572 = global_4.member[_e735].member[_e1566];
                                            let _e1578 = (_e364 % 3u);
                                            if (_e1578 < 3u) {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e1584 = global_4.member[_e735].member[_e1578];
                                            let _e1590 = (_e366 % 3u);
                                            if (_e1590 < 3u) {
                                            } else {
                                                phi_3622_ = true;
                                                break;
                                            }
                                            let _e1596 = global_4.member[_e735].member[_e1590];
                                            let _e1606 = global_4.member[_e735].member_1;
                                            let _e1610 = global_4.member[_e735].member_2;
                                            phi_2746_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e1572[0], _e1572[1], _e1572[2], _e1572[3]), vec4<f32>(_e1584[0], _e1584[1], _e1584[2], _e1584[3]), vec4<f32>(_e1596[0], _e1596[1], _e1596[2], _e1596[3])), _e1606, _e1610);
                                        }
                                        let _e1613 = phi_2746_;
                                        let _e1625 = ((_e1613.member[0].x - _e450) * _e455);
                                        let _e1626 = ((_e1613.member[0].y - _e450) * _e455);
                                        let _e1627 = ((_e1613.member[0].z - _e451) * _e455);
                                        let _e1628 = ((_e1613.member[0].w - _e451) * _e455);
                                        let _e1638 = ((_e1613.member[1].x - _e516) * _e521);
                                        let _e1639 = ((_e1613.member[1].y - _e516) * _e521);
                                        let _e1640 = ((_e1613.member[1].z - _e517) * _e521);
                                        let _e1641 = ((_e1613.member[1].w - _e517) * _e521);
                                        let _e1651 = ((_e1613.member[2].x - _e582) * _e587);
                                        let _e1652 = ((_e1613.member[2].y - _e582) * _e587);
                                        let _e1653 = ((_e1613.member[2].z - _e583) * _e587);
                                        let _e1654 = ((_e1613.member[2].w - _e583) * _e587);
                                        let _e1656 = select(_e1653, _e1651, (_e1651 < _e1653));
                                        let _e1658 = select(_e1654, _e1652, (_e1652 < _e1654));
                                        let _e1660 = select(_e1653, _e1651, (_e1651 > _e1653));
                                        let _e1662 = select(_e1654, _e1652, (_e1652 > _e1654));
                                        let _e1664 = select(_e1627, _e1625, (_e1625 < _e1627));
                                        let _e1666 = select(_e1628, _e1626, (_e1626 < _e1628));
                                        let _e1668 = select(_e1640, _e1638, (_e1638 < _e1640));
                                        let _e1670 = select(_e1641, _e1639, (_e1639 < _e1641));
                                        let _e1672 = select(_e1668, _e1664, (_e1664 > _e1668));
                                        let _e1674 = select(_e1670, _e1666, (_e1666 > _e1670));
                                        let _e1676 = select(_e1656, _e1672, (_e1672 > _e1656));
                                        let _e1678 = select(_e1658, _e1674, (_e1674 > _e1658));
                                        let _e1680 = select(_e1627, _e1625, (_e1625 > _e1627));
                                        let _e1682 = select(_e1628, _e1626, (_e1626 > _e1628));
                                        let _e1684 = select(_e1640, _e1638, (_e1638 > _e1640));
                                        let _e1686 = select(_e1641, _e1639, (_e1639 > _e1641));
                                        let _e1688 = select(_e1684, _e1680, (_e1680 < _e1684));
                                        let _e1690 = select(_e1686, _e1682, (_e1682 < _e1686));
                                        let _e1695 = -(_e1656);
                                        let _e1696 = -(_e1658);
                                        let _e1703 = (select(_e1660, _e1688, (_e1688 < _e1660)) + (select(_e1695, _e1660, (_e1660 > _e1695)) * 0.0000019073523f));
                                        let _e1704 = (select(_e1662, _e1690, (_e1690 < _e1662)) + (select(_e1696, _e1662, (_e1662 > _e1696)) * 0.0000019073523f));
                                        let _e1706 = select(_e698, _e1676, (_e1676 > _e698));
                                        let _e1708 = select(_e698, _e1678, (_e1678 > _e698));
                                        let _e1713 = (_e1706 <= select(_e1563.member_1, _e1703, (_e1703 < _e1563.member_1)));
                                        let _e1714 = (_e1708 <= select(_e1563.member_1, _e1704, (_e1704 < _e1563.member_1)));
                                        let _e1715 = (_e1706 <= _e1708);
                                        if _e1713 {
                                            if _e1714 {
                                                if _e1715 {
                                                    phi_3108_ = _e1613.member_2;
                                                } else {
                                                    phi_3108_ = _e1613.member_1;
                                                }
                                                let _e1719 = phi_3108_;
                                                let _e1721 = (_e733 % 128u);
                                                let _e1722 = (_e1721 < 128u);
                                                if _e1722 {
                                                } else {
                                                    phi_3622_ = true;
                                                    break;
                                                }
                                                local_1[_e1721] = _e1719;
                                                if _e1722 {
                                                } else {
                                                    phi_3622_ = true;
                                                    break;
                                                }
                                                local[_e1721] = select(_e1706, _e1708, _e1715);
                                                if _e1715 {
                                                    phi_3135_ = _e1613.member_1;
                                                } else {
                                                    phi_3135_ = _e1613.member_2;
                                                }
                                                let _e1729 = phi_3135_;
                                                phi_3136_ = (_e733 + 1u);
                                                phi_3137_ = _e1729;
                                            } else {
                                                phi_3136_ = u32();
                                                phi_3137_ = u32();
                                            }
                                            let _e1731 = phi_3136_;
                                            let _e1733 = phi_3137_;
                                            phi_3139_ = _e1731;
                                            phi_3140_ = _e1733;
                                            phi_3141_ = select(true, false, _e1714);
                                        } else {
                                            phi_3139_ = u32();
                                            phi_3140_ = u32();
                                            phi_3141_ = true;
                                        }
                                        let _e1736 = phi_3139_;
                                        let _e1738 = phi_3140_;
                                        let _e1740 = phi_3141_;
                                        if _e1740 {
                                            if _e1713 {
                                                phi_3150_ = _e1613.member_1;
                                            } else {
                                                phi_3150_ = _e1613.member_2;
                                            }
                                            let _e1744 = phi_3150_;
                                            phi_3155_ = select(_e1714, true, _e1713);
                                            phi_3157_ = _e1744;
                                        } else {
                                            phi_3155_ = _e731;
                                            phi_3157_ = _e1738;
                                        }
                                        let _e1747 = phi_3155_;
                                        let _e1749 = phi_3157_;
                                        phi_3161_ = _e1747;
                                        phi_3162_ = select(_e1736, _e733, _e1740);
                                        phi_3163_ = _e1749;
                                    }
                                    let _e1752 = phi_3161_;
                                    let _e1754 = phi_3162_;
                                    let _e1756 = phi_3163_;
                                    phi_3625_ = _e1561;
                                    phi_3174_ = _e1563;
                                    phi_3175_ = (_e710 - 1u);
                                    phi_3176_ = select(_e1752, false, _e738);
                                    phi_3177_ = select(_e1754, _e733, _e738);
                                    phi_3178_ = select(_e1756, _e735, _e738);
                                } else {
                                    phi_3625_ = _e706;
                                    phi_3174_ = _e708;
                                    phi_3175_ = _e710;
                                    phi_3176_ = _e731;
                                    phi_3177_ = _e733;
                                    phi_3178_ = _e735;
                                }
                                let _e1761 = phi_3625_;
                                let _e1763 = phi_3174_;
                                let _e1765 = phi_3175_;
                                let _e1767 = phi_3176_;
                                let _e1769 = phi_3177_;
                                let _e1771 = phi_3178_;
                                phi_3624_ = _e1761;
                                phi_3179_ = _e1763;
                                phi_3180_ = _e1765;
                                phi_3181_ = _e1767;
                                phi_3182_ = _e1769;
                                phi_3183_ = _e1771;
                            } else {
                                phi_3624_ = _e706;
                                phi_3179_ = type_50();
                                phi_3180_ = u32();
                                phi_3181_ = bool();
                                phi_3182_ = u32();
                                phi_3183_ = u32();
                            }
                            let _e1773 = phi_3624_;
                            let _e1775 = phi_3179_;
                            let _e1777 = phi_3180_;
                            let _e1779 = phi_3181_;
                            let _e1781 = phi_3182_;
                            let _e1783 = phi_3183_;
                            phi_3623_ = _e1773;
                            phi_1211_ = _e1775;
                            phi_1214_ = _e1777;
                            phi_1216_ = _e1779;
                            phi_1218_ = _e1781;
                            phi_1220_ = _e1783;
                            phi_3184_ = _e720;
                        } else {
                            phi_3623_ = _e706;
                            phi_1211_ = type_50();
                            phi_1214_ = u32();
                            phi_1216_ = bool();
                            phi_1218_ = u32();
                            phi_1220_ = u32();
                            phi_3184_ = false;
                        }
                        let _e1785 = phi_3623_;
                        let _e1787 = phi_1211_;
                        let _e1789 = phi_1214_;
                        let _e1791 = phi_1216_;
                        let _e1793 = phi_1218_;
                        let _e1795 = phi_1220_;
                        let _e1797 = phi_3184_;
                        continue;
                        continuing {
                            phi_3436_ = _e1785;
                            phi_1210_ = _e1787;
                            phi_1213_ = _e1789;
                            phi_1215_ = _e1791;
                            phi_1217_ = _e1793;
                            phi_1219_ = _e1795;
                            phi_3622_ = _e1785;
                            break if !(_e1797);
                        }
                    }
                    let _e1800 = phi_3622_;
                    if _e1800 {
                        break;
                    }
                    let _e1802 = local_2;
                    if (_e1802.member.member_3 != 4294967295u) {
                        let _e1807 = bitcast<u32>(_e1802.member.member);
                        let _e1811 = (bitcast<i32>((_e1807 >> bitcast<u32>(23i))) & 255i);
                        let _e1812 = (_e1811 + _e367);
                        if (_e1811 == 255i) {
                            phi_3243_ = _e1802.member.member;
                        } else {
                            if (_e1811 > 0i) {
                                if (_e1812 > 0i) {
                                    let _e1816 = (_e1812 < 255i);
                                    if _e1816 {
                                        phi_3222_ = bitcast<f32>((_e1807 + bitcast<u32>((_e367 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3222_ = f32();
                                    }
                                    let _e1823 = phi_3222_;
                                    phi_3224_ = _e1823;
                                    phi_3225_ = select(true, false, _e1816);
                                } else {
                                    phi_3224_ = f32();
                                    phi_3225_ = true;
                                }
                                let _e1826 = phi_3224_;
                                let _e1828 = phi_3225_;
                                phi_3226_ = _e1826;
                                phi_3227_ = _e1828;
                            } else {
                                phi_3226_ = f32();
                                phi_3227_ = true;
                            }
                            let _e1830 = phi_3226_;
                            let _e1832 = phi_3227_;
                            if _e1832 {
                                let _e1833 = (_e1807 & 2147483648u);
                                let _e1840 = ((_e1807 & 8388607u) | (select(0u, 1u, ((_e1807 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1844 = (_e1840 == 0u);
                                if _e1844 {
                                    phi_3425_ = bitcast<f32>(_e1833);
                                } else {
                                    let _e1849 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1840)), 32u, _e1844) - 8u);
                                    let _e1852 = (_e1840 << bitcast<u32>((_e1849 & 31u)));
                                    let _e1854 = ((_e1812 + select(0i, 1i, (_e1811 == 0i))) - bitcast<i32>(_e1849));
                                    if (_e1854 >= 255i) {
                                        phi_3415_ = bitcast<f32>((_e1833 | 2139095040u));
                                        phi_3416_ = f32();
                                        phi_3417_ = true;
                                    } else {
                                        let _e1856 = (_e1854 > 0i);
                                        if _e1856 {
                                            phi_3409_ = bitcast<f32>(((_e1833 | (bitcast<u32>(_e1854) << bitcast<u32>(23i))) | (_e1852 & 8388607u)));
                                            phi_3410_ = f32();
                                        } else {
                                            if (_e1854 < -24i) {
                                                phi_3375_ = 26u;
                                            } else {
                                                phi_3375_ = bitcast<u32>((1i - _e1854));
                                            }
                                            let _e1861 = phi_3375_;
                                            let _e1862 = (_e1861 & 31u);
                                            let _e1864 = (_e1852 >> bitcast<u32>(_e1862));
                                            let _e1868 = (_e1852 & ((1u << bitcast<u32>(_e1862)) - 1u));
                                            let _e1872 = (1u << bitcast<u32>(((_e1861 - 1u) & 31u)));
                                            if (_e1868 > _e1872) {
                                                phi_3396_ = true;
                                            } else {
                                                if (_e1868 == _e1872) {
                                                    phi_3393_ = ((_e1864 & 1u) == 1u);
                                                } else {
                                                    phi_3393_ = false;
                                                }
                                                let _e1878 = phi_3393_;
                                                phi_3396_ = _e1878;
                                            }
                                            let _e1880 = phi_3396_;
                                            phi_3409_ = f32();
                                            phi_3410_ = bitcast<f32>((_e1833 | (_e1864 + select(0u, 1u, _e1880))));
                                        }
                                        let _e1893 = phi_3409_;
                                        let _e1895 = phi_3410_;
                                        phi_3415_ = _e1893;
                                        phi_3416_ = _e1895;
                                        phi_3417_ = _e1856;
                                    }
                                    let _e1899 = phi_3415_;
                                    let _e1901 = phi_3416_;
                                    let _e1903 = phi_3417_;
                                    phi_3425_ = select(_e1901, _e1899, _e1903);
                                }
                                let _e1907 = phi_3425_;
                                phi_3242_ = _e1907;
                            } else {
                                phi_3242_ = _e1830;
                            }
                            let _e1909 = phi_3242_;
                            phi_3243_ = _e1909;
                        }
                        let _e1911 = phi_3243_;
                        let _e1912 = bitcast<u32>(_e1911);
                        if ((_e1912 & 2147483647u) >= 2139095040u) {
                            phi_3255_ = bitcast<f32>(((_e1912 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3255_ = _e1911;
                        }
                        let _e1919 = phi_3255_;
                        phi_3260_ = type_28(_e1919, _e1802.member.member_1, _e1802.member.member_2, _e1802.member.member_3);
                    } else {
                        phi_3260_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1924 = phi_3260_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_8.member[_e104] = _e1924;
                    if _e105 {
                    } else {
                        break;
                    }
                    let _e1928 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1928 > 0u) {
                        let _e1930 = (1u < _e100);
                        if _e1930 {
                            if (0u < _e100) {
                            } else {
                                break;
                            }
                            let _e1934 = atomicAdd((&global_9.member[0u]), _e1928);
                            if ((_e1934 + _e1928) < _e1934) {
                                if _e1930 {
                                } else {
                                    break;
                                }
                                let _e1939 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1942 = select(0u, 1u, (_e1924.member_3 != 4294967295u));
                    if (_e1942 > 0u) {
                        let _e1944 = (3u < _e100);
                        if _e1944 {
                            if (2u < _e100) {
                            } else {
                                break;
                            }
                            let _e1948 = atomicAdd((&global_9.member[2u]), _e1942);
                            if ((_e1948 + _e1942) < _e1948) {
                                if _e1944 {
                                } else {
                                    break;
                                }
                                let _e1953 = atomicAdd((&global_9.member[3u]), 1u);
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
