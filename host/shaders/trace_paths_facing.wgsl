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
    var phi_3432_: bool;
    var phi_1210_: type_50;
    var phi_1213_: bool;
    var phi_1215_: u32;
    var phi_1217_: u32;
    var phi_1219_: u32;
    var phi_1230_: bool;
    var phi_1262_: bool;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_2750_: type_54;
    var phi_3112_: u32;
    var phi_3140_: u32;
    var phi_3141_: u32;
    var phi_3142_: u32;
    var phi_3144_: u32;
    var phi_3145_: u32;
    var phi_3146_: bool;
    var phi_3155_: u32;
    var phi_3160_: bool;
    var phi_3162_: u32;
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
    var phi_3426_: bool;
    var phi_3622_: bool;
    var phi_3166_: type_50;
    var phi_3167_: bool;
    var phi_3168_: u32;
    var phi_3169_: u32;
    var phi_3621_: bool;
    var phi_3170_: type_50;
    var phi_3171_: bool;
    var phi_3172_: u32;
    var phi_3173_: u32;
    var phi_3174_: u32;
    var phi_3620_: bool;
    var phi_3175_: type_50;
    var phi_3176_: bool;
    var phi_3177_: u32;
    var phi_3178_: u32;
    var phi_3179_: u32;
    var phi_3619_: bool;
    var phi_1211_: type_50;
    var phi_1214_: bool;
    var phi_1216_: u32;
    var phi_1218_: u32;
    var phi_1220_: u32;
    var phi_3180_: bool;
    var phi_3618_: bool;
    var local_2: type_50;
    var phi_3218_: f32;
    var phi_3220_: f32;
    var phi_3221_: bool;
    var phi_3222_: f32;
    var phi_3223_: bool;
    var phi_3371_: u32;
    var phi_3389_: bool;
    var phi_3392_: bool;
    var phi_3405_: f32;
    var phi_3406_: f32;
    var phi_3411_: f32;
    var phi_3412_: f32;
    var phi_3413_: bool;
    var phi_3421_: f32;
    var phi_3238_: f32;
    var phi_3239_: f32;
    var phi_3251_: f32;
    var phi_3256_: type_28;
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
                    phi_3432_ = false;
                    phi_1210_ = type_50(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e696);
                    phi_1213_ = (_e698 <= _e696);
                    phi_1215_ = ((3u * _e86) + 1u);
                    phi_1217_ = 0u;
                    phi_1219_ = select(0u, 2147483648u, (_e86 == 0u));
                    loop {
                        let _e706 = phi_3432_;
                        let _e708 = phi_1210_;
                        let _e710 = phi_1213_;
                        let _e712 = phi_1215_;
                        let _e714 = phi_1217_;
                        let _e716 = phi_1219_;
                        local_2 = _e708;
                        if _e710 {
                            phi_1230_ = true;
                        } else {
                            phi_1230_ = (_e714 > 0u);
                        }
                        let _e719 = phi_1230_;
                        if _e719 {
                            let _e720 = (_e712 > 0u);
                            if _e720 {
                                if _e710 {
                                    phi_1262_ = _e710;
                                    phi_1263_ = _e714;
                                    phi_1264_ = _e716;
                                } else {
                                    let _e721 = (_e714 - 1u);
                                    let _e722 = (_e721 % 128u);
                                    let _e723 = (_e722 < 128u);
                                    if _e723 {
                                    } else {
                                        phi_3618_ = true;
                                        break;
                                    }
                                    let _e725 = local_1[_e722];
                                    if _e723 {
                                    } else {
                                        phi_3618_ = true;
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
                                    if ((_e735 & 2147483648u) != 0u) {
                                        phi_1279_ = _e708;
                                        phi_1282_ = type_8(0u, ((_e735 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e933 = phi_1279_;
                                            let _e935 = phi_1282_;
                                            local_3 = _e933;
                                            if (_e935.member < _e935.member_1) {
                                                phi_1283_ = type_8((_e935.member + 1u), _e935.member_1);
                                                phi_1305_ = type_8(1u, _e935.member);
                                            } else {
                                                phi_1283_ = _e935;
                                                phi_1305_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e948 = phi_1283_;
                                            let _e950 = phi_1305_;
                                            let _e954 = (bitcast<i32>(_e950.member) != 0i);
                                            if _e954 {
                                                let _e955 = ((_e735 & 268435455u) + _e950.member_1);
                                                let _e956 = (_e955 < _e88);
                                                if _e956 {
                                                    if _e956 {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e960 = global_2.member[_e955].member_1;
                                                    phi_1326_ = _e960;
                                                } else {
                                                    phi_1326_ = 4294967295u;
                                                }
                                                let _e962 = phi_1326_;
                                                if (_e955 >= _e88) {
                                                    phi_1418_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e956 {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e964 = (_e365 % 3u);
                                                    let _e965 = (_e364 % 3u);
                                                    let _e966 = (_e366 % 3u);
                                                    if (_e964 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e972 = global_2.member[_e955].member[_e964];
                                                    if (_e965 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_2.member[_e955].member[_e965];
                                                    if (_e966 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e984 = global_2.member[_e955].member[_e966];
                                                    let _e986 = (3u + _e964);
                                                    if (_e986 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e992 = global_2.member[_e955].member[_e986];
                                                    let _e993 = (3u + _e965);
                                                    if (_e993 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e999 = global_2.member[_e955].member[_e993];
                                                    let _e1000 = (3u + _e966);
                                                    if (_e1000 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e1006 = global_2.member[_e955].member[_e1000];
                                                    let _e1008 = (6u + _e964);
                                                    if (_e1008 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e1014 = global_2.member[_e955].member[_e1008];
                                                    let _e1015 = (6u + _e965);
                                                    if (_e1015 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e1021 = global_2.member[_e955].member[_e1015];
                                                    let _e1022 = (6u + _e966);
                                                    if (_e1022 < 9u) {
                                                    } else {
                                                        phi_3426_ = true;
                                                        break;
                                                    }
                                                    let _e1028 = global_2.member[_e955].member[_e1022];
                                                    phi_1418_ = array<array<f32, 3>, 3>(array<f32, 3>(_e972, _e978, _e984), array<f32, 3>(_e992, _e999, _e1006), array<f32, 3>(_e1014, _e1021, _e1028));
                                                }
                                                let _e1032 = phi_1418_;
                                                let _e1040 = (_e1032[0][2] - _e545);
                                                let _e1043 = (((_e1032[0][0] - _e412) * _e584) - (_e1040 * _e452));
                                                let _e1046 = (((_e1032[0][1] - _e479) * _e584) - (_e1040 * _e518));
                                                let _e1053 = (_e1032[1][2] - _e545);
                                                let _e1056 = (((_e1032[1][0] - _e412) * _e584) - (_e1053 * _e452));
                                                let _e1059 = (((_e1032[1][1] - _e479) * _e584) - (_e1053 * _e518));
                                                let _e1066 = (_e1032[2][2] - _e545);
                                                let _e1069 = (((_e1032[2][0] - _e412) * _e584) - (_e1066 * _e452));
                                                let _e1072 = (((_e1032[2][1] - _e479) * _e584) - (_e1066 * _e518));
                                                let _e1073 = (_e1069 * _e1059);
                                                let _e1074 = (_e1072 * _e1056);
                                                let _e1075 = (_e1043 * _e1072);
                                                let _e1076 = (_e1046 * _e1069);
                                                let _e1077 = (_e1056 * _e1046);
                                                let _e1078 = (_e1059 * _e1043);
                                                let _e1083 = (((_e1073 >= _e1074) && (_e1075 >= _e1076)) && (_e1077 >= _e1078));
                                                if (_e1083 || (((_e1073 <= _e1074) && (_e1075 <= _e1076)) && (_e1077 <= _e1078))) {
                                                    let _e1090 = select(-1f, 1f, _e1083);
                                                    let _e1092 = ((_e1073 - _e1074) * _e1090);
                                                    let _e1094 = select(0f, _e1092, (_e1092 > 0f));
                                                    let _e1096 = ((_e1075 - _e1076) * _e1090);
                                                    let _e1098 = select(0f, _e1096, (_e1096 > 0f));
                                                    let _e1100 = ((_e1077 - _e1078) * _e1090);
                                                    let _e1102 = select(0f, _e1100, (_e1100 > 0f));
                                                    let _e1104 = ((_e1094 + _e1098) + _e1102);
                                                    if (_e1104 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2302_ = type_28();
                                                        phi_2303_ = true;
                                                        phi_2304_ = false;
                                                    } else {
                                                        let _e1107 = select(_e1056, _e1043, (_e1043 < _e1056));
                                                        if (select(_e1069, _e1107, (_e1107 < _e1069)) > 0f) {
                                                            phi_1570_ = true;
                                                        } else {
                                                            let _e1112 = select(_e1056, _e1043, (_e1043 > _e1056));
                                                            phi_1570_ = (select(_e1069, _e1112, (_e1112 > _e1069)) < 0f);
                                                        }
                                                        let _e1117 = phi_1570_;
                                                        if _e1117 {
                                                            phi_2299_ = type_28();
                                                            phi_2300_ = true;
                                                            phi_2301_ = false;
                                                        } else {
                                                            let _e1119 = select(_e1059, _e1046, (_e1046 < _e1059));
                                                            if (select(_e1072, _e1119, (_e1119 < _e1072)) > 0f) {
                                                                phi_1599_ = true;
                                                            } else {
                                                                let _e1124 = select(_e1059, _e1046, (_e1046 > _e1059));
                                                                phi_1599_ = (select(_e1072, _e1124, (_e1124 > _e1072)) < 0f);
                                                            }
                                                            let _e1129 = phi_1599_;
                                                            if _e1129 {
                                                                phi_2297_ = type_28();
                                                                phi_2298_ = false;
                                                            } else {
                                                                let _e1131 = select(_e1032[1][0], _e1032[0][0], (_e1032[0][0] < _e1032[1][0]));
                                                                let _e1135 = select(_e1032[1][0], _e1032[0][0], (_e1032[0][0] > _e1032[1][0]));
                                                                let _e1139 = select(_e1032[1][1], _e1032[0][1], (_e1032[0][1] < _e1032[1][1]));
                                                                let _e1143 = select(_e1032[1][1], _e1032[0][1], (_e1032[0][1] > _e1032[1][1]));
                                                                let _e1147 = select(_e1032[1][2], _e1032[0][2], (_e1032[0][2] < _e1032[1][2]));
                                                                let _e1151 = select(_e1032[1][2], _e1032[0][2], (_e1032[0][2] > _e1032[1][2]));
                                                                let _e1156 = ((select(_e1032[2][0], _e1131, (_e1131 < _e1032[2][0])) - _e450) * _e455);
                                                                let _e1157 = ((select(_e1032[2][0], _e1135, (_e1135 > _e1032[2][0])) - _e451) * _e455);
                                                                let _e1160 = ((select(_e1032[2][1], _e1139, (_e1139 < _e1032[2][1])) - _e516) * _e521);
                                                                let _e1161 = ((select(_e1032[2][1], _e1143, (_e1143 > _e1032[2][1])) - _e517) * _e521);
                                                                let _e1164 = ((select(_e1032[2][2], _e1147, (_e1147 < _e1032[2][2])) - _e582) * _e587);
                                                                let _e1165 = ((select(_e1032[2][2], _e1151, (_e1151 > _e1032[2][2])) - _e583) * _e587);
                                                                let _e1167 = select(_e1165, _e1164, (_e1164 < _e1165));
                                                                let _e1169 = select(_e1165, _e1164, (_e1164 > _e1165));
                                                                let _e1171 = select(_e1157, _e1156, (_e1156 < _e1157));
                                                                let _e1173 = select(_e1161, _e1160, (_e1160 < _e1161));
                                                                let _e1175 = select(_e1173, _e1171, (_e1171 > _e1173));
                                                                let _e1177 = select(_e1167, _e1175, (_e1175 > _e1167));
                                                                let _e1179 = select(_e1157, _e1156, (_e1156 > _e1157));
                                                                let _e1181 = select(_e1161, _e1160, (_e1160 > _e1161));
                                                                let _e1183 = select(_e1181, _e1179, (_e1179 < _e1181));
                                                                let _e1185 = select(_e1169, _e1183, (_e1183 < _e1169));
                                                                let _e1186 = -(_e1167);
                                                                let _e1192 = select(_e698, _e1177, (_e1177 > _e698));
                                                                if (_e1192 > (_e1185 + (select(_e1186, _e1169, (_e1169 > _e1186)) * 0.0000019073523f))) {
                                                                    phi_2292_ = type_28();
                                                                    phi_2293_ = true;
                                                                } else {
                                                                    let _e1194 = (_e1192 > _e933.member_1);
                                                                    if _e1194 {
                                                                        phi_2291_ = type_28();
                                                                    } else {
                                                                        let _e1195 = vec3<f32>(_e1032[0][0], _e1032[0][1], _e1032[0][2]);
                                                                        let _e1196 = vec3<f32>(_e1032[1][0], _e1032[1][1], _e1032[1][2]);
                                                                        let _e1197 = vec3<f32>(_e1032[2][0], _e1032[2][1], _e1032[2][2]);
                                                                        let _e1198 = (_e1032[1][0] - _e1032[0][0]);
                                                                        let _e1199 = (_e1032[1][1] - _e1032[0][1]);
                                                                        let _e1200 = (_e1032[1][2] - _e1032[0][2]);
                                                                        let _e1201 = vec3<f32>(_e1198, _e1199, _e1200);
                                                                        let _e1202 = (_e1032[2][0] - _e1032[1][0]);
                                                                        let _e1203 = (_e1032[2][1] - _e1032[1][1]);
                                                                        let _e1204 = (_e1032[2][2] - _e1032[1][2]);
                                                                        let _e1205 = vec3<f32>(_e1202, _e1203, _e1204);
                                                                        let _e1206 = (_e1032[0][0] - _e1032[2][0]);
                                                                        let _e1207 = (_e1032[0][1] - _e1032[2][1]);
                                                                        let _e1208 = (_e1032[0][2] - _e1032[2][2]);
                                                                        let _e1209 = vec3<f32>(_e1206, _e1207, _e1208);
                                                                        let _e1212 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                        let _e1215 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                        let _e1217 = select(_e1215, _e1212, (_e1212 > _e1215));
                                                                        let _e1220 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                        let _e1222 = select(_e1220, _e1217, (_e1217 > _e1220));
                                                                        let _e1225 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                        let _e1228 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                        let _e1230 = select(_e1228, _e1225, (_e1225 > _e1228));
                                                                        let _e1233 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                        let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                        let _e1241 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                        let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                        let _e1246 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1248 = select(_e1246, _e1243, (_e1243 > _e1246));
                                                                        let _e1250 = select(_e1235, _e1222, (_e1222 > _e1235));
                                                                        let _e1252 = select(_e1248, _e1250, (_e1250 > _e1248));
                                                                        if (_e1222 == _e1252) {
                                                                            phi_2018_ = _e1059;
                                                                            phi_2019_ = _e1056;
                                                                            phi_2020_ = _e1046;
                                                                            phi_2021_ = _e1043;
                                                                            phi_2022_ = _e1195;
                                                                            phi_2023_ = _e1209;
                                                                            phi_2024_ = _e1205;
                                                                            phi_2025_ = _e1201;
                                                                        } else {
                                                                            let _e1254 = (_e1235 == _e1252);
                                                                            let _e1259 = vec3(_e1254);
                                                                            phi_2018_ = select(_e1046, _e1072, _e1254);
                                                                            phi_2019_ = select(_e1043, _e1069, _e1254);
                                                                            phi_2020_ = select(_e1072, _e1059, _e1254);
                                                                            phi_2021_ = select(_e1069, _e1056, _e1254);
                                                                            phi_2022_ = select(_e1197, _e1196, _e1259);
                                                                            phi_2023_ = select(_e1205, _e1201, _e1259);
                                                                            phi_2024_ = select(_e1201, _e1209, _e1259);
                                                                            phi_2025_ = select(_e1209, _e1205, _e1259);
                                                                        }
                                                                        let _e1265 = phi_2018_;
                                                                        let _e1267 = phi_2019_;
                                                                        let _e1269 = phi_2020_;
                                                                        let _e1271 = phi_2021_;
                                                                        let _e1273 = phi_2022_;
                                                                        let _e1275 = phi_2023_;
                                                                        let _e1277 = phi_2024_;
                                                                        let _e1279 = phi_2025_;
                                                                        let _e1286 = ((_e1277.y * _e1275.z) - (_e1275.y * _e1277.z));
                                                                        let _e1291 = ((_e1277.z * _e1275.x) - (_e1275.z * _e1277.x));
                                                                        let _e1294 = ((_e1277.x * _e1275.y) - (_e1275.x * _e1277.y));
                                                                        if (_e1094 >= _e1098) {
                                                                            phi_2062_ = select(true, false, (_e1094 >= _e1102));
                                                                        } else {
                                                                            phi_2062_ = true;
                                                                        }
                                                                        let _e1299 = phi_2062_;
                                                                        if _e1299 {
                                                                            phi_2071_ = select(_e1197, _e1196, vec3((_e1098 >= _e1102)));
                                                                        } else {
                                                                            phi_2071_ = _e1195;
                                                                        }
                                                                        let _e1304 = phi_2071_;
                                                                        let _e1315 = (((_e1286 * (_e1304.x - _e412)) + (_e1291 * (_e1304.y - _e479))) + (_e1294 * (_e1304.z - _e545)));
                                                                        let _e1320 = (((_e1286 * _e452) + (_e1291 * _e518)) + (_e1294 * _e584));
                                                                        let _e1321 = (_e1267 - _e1271);
                                                                        let _e1322 = (_e1265 - _e1269);
                                                                        let _e1330 = (-(((_e1271 * _e1321) + (_e1269 * _e1322))) / ((_e1321 * _e1321) + (_e1322 * _e1322)));
                                                                        let _e1332 = select(1f, _e1330, (_e1330 < 1f));
                                                                        let _e1334 = select(0f, _e1332, (_e1332 > 0f));
                                                                        let _e1347 = ((_e1273.x + (_e1279.x * _e1334)) - _e412);
                                                                        let _e1348 = ((_e1273.y + (_e1279.y * _e1334)) - _e479);
                                                                        let _e1349 = ((_e1273.z + (_e1279.z * _e1334)) - _e545);
                                                                        let _e1350 = (_e1349 / _e584);
                                                                        let _e1362 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        let _e1365 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                        let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                        let _e1370 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                        let _e1372 = select(_e1370, _e1367, (_e1367 > _e1370));
                                                                        let _e1378 = bitcast<f32>((bitcast<u32>(_e1286) & 2147483647u));
                                                                        let _e1381 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                                        let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                        let _e1386 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1286 * _e1347) + (_e1291 * _e1348)) + (_e1294 * _e1349)) - _e1315)) & 2147483647u)) <= ((0.0000009536743f * select(_e1252, _e1372, (_e1372 > _e1252))) * select(_e1386, _e1383, (_e1383 > _e1386)))) {
                                                                            let _e1396 = bitcast<f32>((bitcast<u32>(_e1277.x) & 2147483647u));
                                                                            let _e1399 = bitcast<f32>((bitcast<u32>(_e1277.y) & 2147483647u));
                                                                            let _e1401 = select(_e1399, _e1396, (_e1396 > _e1399));
                                                                            let _e1404 = bitcast<f32>((bitcast<u32>(_e1277.z) & 2147483647u));
                                                                            let _e1410 = bitcast<f32>((bitcast<u32>(_e1275.x) & 2147483647u));
                                                                            let _e1413 = bitcast<f32>((bitcast<u32>(_e1275.y) & 2147483647u));
                                                                            let _e1415 = select(_e1413, _e1410, (_e1410 > _e1413));
                                                                            let _e1418 = bitcast<f32>((bitcast<u32>(_e1275.z) & 2147483647u));
                                                                            let _e1422 = (bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u)) > ((0.0000038146973f * select(_e1404, _e1401, (_e1401 > _e1404))) * select(_e1418, _e1415, (_e1415 > _e1418))));
                                                                            if _e1422 {
                                                                                phi_2236_ = (_e1315 / _e1320);
                                                                            } else {
                                                                                phi_2236_ = f32();
                                                                            }
                                                                            let _e1425 = phi_2236_;
                                                                            phi_2238_ = _e1425;
                                                                            phi_2239_ = select(true, false, _e1422);
                                                                        } else {
                                                                            phi_2238_ = f32();
                                                                            phi_2239_ = true;
                                                                        }
                                                                        let _e1428 = phi_2238_;
                                                                        let _e1430 = phi_2239_;
                                                                        if _e1430 {
                                                                            let _e1438 = (((_e1286 * (_e1347 - (_e452 * _e1350))) + (_e1291 * (_e1348 - (_e518 * _e1350)))) / _e1320);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u)) <= _e1252) {
                                                                                phi_2259_ = (_e1350 + _e1438);
                                                                            } else {
                                                                                phi_2259_ = _e1350;
                                                                            }
                                                                            let _e1445 = phi_2259_;
                                                                            phi_2260_ = _e1445;
                                                                        } else {
                                                                            phi_2260_ = _e1428;
                                                                        }
                                                                        let _e1447 = phi_2260_;
                                                                        let _e1449 = select(_e1185, _e1447, (_e1447 < _e1185));
                                                                        let _e1451 = select(_e1177, _e1449, (_e1449 > _e1177));
                                                                        if (_e1451 >= _e698) {
                                                                            let _e1453 = (_e1451 <= _e933.member_1);
                                                                            if _e1453 {
                                                                                let _e1454 = (1f / _e1104);
                                                                                phi_2283_ = type_28(_e1451, (_e1098 * _e1454), (_e1102 * _e1454), _e962);
                                                                            } else {
                                                                                phi_2283_ = type_28();
                                                                            }
                                                                            let _e1459 = phi_2283_;
                                                                            phi_2285_ = _e1459;
                                                                            phi_2286_ = select(true, false, _e1453);
                                                                        } else {
                                                                            phi_2285_ = type_28();
                                                                            phi_2286_ = true;
                                                                        }
                                                                        let _e1462 = phi_2285_;
                                                                        let _e1464 = phi_2286_;
                                                                        if _e1464 {
                                                                            phi_2290_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2290_ = _e1462;
                                                                        }
                                                                        let _e1466 = phi_2290_;
                                                                        phi_2291_ = _e1466;
                                                                    }
                                                                    let _e1468 = phi_2291_;
                                                                    phi_2292_ = _e1468;
                                                                    phi_2293_ = _e1194;
                                                                }
                                                                let _e1470 = phi_2292_;
                                                                let _e1472 = phi_2293_;
                                                                phi_2297_ = _e1470;
                                                                phi_2298_ = _e1472;
                                                            }
                                                            let _e1474 = phi_2297_;
                                                            let _e1476 = phi_2298_;
                                                            phi_2299_ = _e1474;
                                                            phi_2300_ = _e1129;
                                                            phi_2301_ = _e1476;
                                                        }
                                                        let _e1478 = phi_2299_;
                                                        let _e1480 = phi_2300_;
                                                        let _e1482 = phi_2301_;
                                                        phi_2302_ = _e1478;
                                                        phi_2303_ = _e1480;
                                                        phi_2304_ = _e1482;
                                                    }
                                                    let _e1484 = phi_2302_;
                                                    let _e1486 = phi_2303_;
                                                    let _e1488 = phi_2304_;
                                                    phi_2312_ = _e1484;
                                                    phi_2313_ = select(_e1488, true, _e1486);
                                                } else {
                                                    phi_2312_ = type_28();
                                                    phi_2313_ = true;
                                                }
                                                let _e1491 = phi_2312_;
                                                let _e1493 = phi_2313_;
                                                if _e1493 {
                                                    phi_2317_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2317_ = _e1491;
                                                }
                                                let _e1495 = phi_2317_;
                                                if (_e1495.member_3 != 4294967295u) {
                                                    if (_e962 == _e111) {
                                                        phi_2652_ = false;
                                                    } else {
                                                        let _e1499 = (_e962 < arrayLength((&global_5.member)));
                                                        if _e1499 {
                                                            if _e1499 {
                                                            } else {
                                                                phi_3426_ = true;
                                                                break;
                                                            }
                                                            let _e1501 = global_5.member[_e962];
                                                            phi_2340_ = _e1501;
                                                        } else {
                                                            phi_2340_ = 4294967295u;
                                                        }
                                                        let _e1503 = phi_2340_;
                                                        let _e1504 = (_e1503 < arrayLength((&global_6.member)));
                                                        if _e1504 {
                                                            if _e1504 {
                                                            } else {
                                                                phi_3426_ = true;
                                                                break;
                                                            }
                                                            let _e1506 = global_6.member[_e1503];
                                                            phi_2354_ = _e1506;
                                                        } else {
                                                            phi_2354_ = 0i;
                                                        }
                                                        let _e1508 = phi_2354_;
                                                        let _e1509 = (_e1508 == 0i);
                                                        if _e1509 {
                                                            phi_2651_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2377_ = vec3<f32>(_e1032[0][0], _e1032[0][1], _e1032[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2376_ = vec3<f32>(_e1032[0][2], _e1032[0][0], _e1032[0][1]);
                                                                } else {
                                                                    phi_2376_ = vec3<f32>(_e1032[0][1], _e1032[0][2], _e1032[0][0]);
                                                                }
                                                                let _e1514 = phi_2376_;
                                                                phi_2377_ = _e1514;
                                                            }
                                                            let _e1517 = phi_2377_;
                                                            if _e389 {
                                                                phi_2396_ = vec3<f32>(_e1032[1][0], _e1032[1][1], _e1032[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2395_ = vec3<f32>(_e1032[1][2], _e1032[1][0], _e1032[1][1]);
                                                                } else {
                                                                    phi_2395_ = vec3<f32>(_e1032[1][1], _e1032[1][2], _e1032[1][0]);
                                                                }
                                                                let _e1522 = phi_2395_;
                                                                phi_2396_ = _e1522;
                                                            }
                                                            let _e1525 = phi_2396_;
                                                            if _e389 {
                                                                phi_2415_ = vec3<f32>(_e1032[2][0], _e1032[2][1], _e1032[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2414_ = vec3<f32>(_e1032[2][2], _e1032[2][0], _e1032[2][1]);
                                                                } else {
                                                                    phi_2414_ = vec3<f32>(_e1032[2][1], _e1032[2][2], _e1032[2][0]);
                                                                }
                                                                let _e1530 = phi_2414_;
                                                                phi_2415_ = _e1530;
                                                            }
                                                            let _e1533 = phi_2415_;
                                                            let _e1536 = (_e1525.x - _e1517.x);
                                                            let _e1539 = (_e1525.y - _e1517.y);
                                                            let _e1542 = (_e1525.z - _e1517.z);
                                                            let _e1544 = (_e1533.x - _e1517.x);
                                                            let _e1546 = (_e1533.y - _e1517.y);
                                                            let _e1548 = (_e1533.z - _e1517.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2451_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1517);
                                                            } else {
                                                                phi_2451_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1563 = phi_2451_;
                                                            let _e1569 = bitcast<f32>((bitcast<u32>((_e1536 * _e1546)) ^ _e243.member_3[0]));
                                                            let _e1573 = bitcast<f32>((bitcast<u32>((_e1539 * _e1544)) ^ _e243.member_3[0]));
                                                            let _e1577 = bitcast<f32>((bitcast<u32>((_e1539 * _e1548)) ^ _e243.member_3[0]));
                                                            let _e1581 = bitcast<f32>((bitcast<u32>((_e1542 * _e1546)) ^ _e243.member_3[0]));
                                                            let _e1585 = bitcast<f32>((bitcast<u32>((_e1542 * _e1544)) ^ _e243.member_3[0]));
                                                            let _e1589 = bitcast<f32>((bitcast<u32>((_e1536 * _e1548)) ^ _e243.member_3[0]));
                                                            let _e1590 = (_e1577 - _e1581);
                                                            let _e1591 = (_e1585 - _e1589);
                                                            let _e1592 = (_e1569 - _e1573);
                                                            let _e1616 = (bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)));
                                                            let _e1623 = (bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1589) & 2147483647u)));
                                                            let _e1630 = (bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2633_ = 0f;
                                                            } else {
                                                                let _e1660 = bitcast<f32>((bitcast<u32>(_e1590) & 2147483647u));
                                                                let _e1663 = bitcast<f32>((bitcast<u32>(_e1591) & 2147483647u));
                                                                let _e1666 = bitcast<f32>((bitcast<u32>(_e1592) & 2147483647u));
                                                                let _e1668 = select(_e1666, _e1663, (_e1663 > _e1666));
                                                                let _e1672 = select(_e1666, _e1663, (_e1663 < _e1666));
                                                                let _e1676 = select(_e1663, _e1660, (_e1660 < _e1663));
                                                                let _e1678 = select(_e1663, _e1660, (_e1660 > _e1663));
                                                                let _e1680 = select(_e1666, _e1678, (_e1678 < _e1666));
                                                                phi_2633_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1668, _e1660, (_e1660 > _e1668)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1680, _e1676, (_e1676 > _e1680)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1672, _e1660, (_e1660 < _e1672)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1616 + _e1623) + _e1630))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1707 = phi_2633_;
                                                            phi_2651_ = (_e1509 || !(((((bitcast<f32>((bitcast<u32>((_e1563.x * _e1590)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1563.y * _e1591)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1563.z * _e1592)) ^ _e243.member_3[0]))) * f32(-(_e1508))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1563.x) & 2147483647u)) * _e1616)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1563.y) & 2147483647u)) * _e1623)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1563.z) & 2147483647u)) * _e1630)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1707) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1721 = phi_2651_;
                                                        phi_2652_ = _e1721;
                                                    }
                                                    let _e1723 = phi_2652_;
                                                    if _e1723 {
                                                        if (_e1495.member < _e933.member.member) {
                                                            phi_2672_ = true;
                                                        } else {
                                                            if (_e1495.member == _e933.member.member) {
                                                                phi_2671_ = (_e1495.member_3 < _e933.member.member_3);
                                                            } else {
                                                                phi_2671_ = false;
                                                            }
                                                            let _e1733 = phi_2671_;
                                                            phi_2672_ = _e1733;
                                                        }
                                                        let _e1735 = phi_2672_;
                                                        if _e1735 {
                                                            phi_2678_ = type_50(_e1495, _e1495.member);
                                                        } else {
                                                            phi_2678_ = _e933;
                                                        }
                                                        let _e1738 = phi_2678_;
                                                        phi_2679_ = _e1738;
                                                    } else {
                                                        phi_2679_ = _e933;
                                                    }
                                                    let _e1740 = phi_2679_;
                                                    phi_2680_ = _e1740;
                                                } else {
                                                    phi_2680_ = _e933;
                                                }
                                                let _e1742 = phi_2680_;
                                                phi_1280_ = _e1742;
                                            } else {
                                                phi_1280_ = type_50();
                                            }
                                            let _e1744 = phi_1280_;
                                            continue;
                                            continuing {
                                                phi_1279_ = _e1744;
                                                phi_1282_ = _e948;
                                                phi_3426_ = _e706;
                                                break if !(_e954);
                                            }
                                        }
                                        let _e1747 = phi_3426_;
                                        phi_3618_ = _e1747;
                                        if _e1747 {
                                            break;
                                        }
                                        phi_3622_ = _e1747;
                                        let _e2073 = local_3;
                                        phi_3166_ = _e2073;
                                        phi_3167_ = false;
                                        phi_3168_ = _e733;
                                        phi_3169_ = _e735;
                                    } else {
                                        if (_e735 >= _e86) {
                                            phi_2750_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e735 < _e86) {
                                            } else {
                                                phi_3618_ = true;
                                                break;
                                            }
                                            let _e745 = (_e365 % 3u);
                                            if (_e745 < 3u) {
                                            } else {
                                                phi_3618_ = true;
                                                break;
                                            }
                                            let _e751 = global_4.member[_e735].member[_e745];
                                            let _e757 = (_e364 % 3u);
                                            if (_e757 < 3u) {
                                            } else {
                                                phi_3618_ = true;
                                                break;
                                            }
                                            let _e763 = global_4.member[_e735].member[_e757];
                                            let _e769 = (_e366 % 3u);
                                            if (_e769 < 3u) {
                                            } else {
                                                phi_3618_ = true;
                                                break;
                                            }
                                            let _e775 = global_4.member[_e735].member[_e769];
                                            let _e785 = global_4.member[_e735].member_1;
                                            let _e789 = global_4.member[_e735].member_2;
                                            phi_2750_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e751[0], _e751[1], _e751[2], _e751[3]), vec4<f32>(_e763[0], _e763[1], _e763[2], _e763[3]), vec4<f32>(_e775[0], _e775[1], _e775[2], _e775[3])), _e785, _e789);
                                        }
                                        let _e792 = phi_2750_;
                                        let _e804 = ((_e792.member[0].x - _e450) * _e455);
                                        let _e805 = ((_e792.member[0].y - _e450) * _e455);
                                        let _e806 = ((_e792.member[0].z - _e451) * _e455);
                                        let _e807 = ((_e792.member[0].w - _e451) * _e455);
                                        let _e817 = ((_e792.member[1].x - _e516) * _e521);
                                        let _e818 = ((_e792.member[1].y - _e516) * _e521);
                                        let _e819 = ((_e792.member[1].z - _e517) * _e521);
                                        let _e820 = ((_e792.member[1].w - _e517) * _e521);
                                        let _e830 = ((_e792.member[2].x - _e582) * _e587);
                                        let _e831 = ((_e792.member[2].y - _e582) * _e587);
                                        let _e832 = ((_e792.member[2].z - _e583) * _e587);
                                        let _e833 = ((_e792.member[2].w - _e583) * _e587);
                                        let _e835 = select(_e832, _e830, (_e830 < _e832));
                                        let _e837 = select(_e833, _e831, (_e831 < _e833));
                                        let _e839 = select(_e832, _e830, (_e830 > _e832));
                                        let _e841 = select(_e833, _e831, (_e831 > _e833));
                                        let _e843 = select(_e806, _e804, (_e804 < _e806));
                                        let _e845 = select(_e807, _e805, (_e805 < _e807));
                                        let _e847 = select(_e819, _e817, (_e817 < _e819));
                                        let _e849 = select(_e820, _e818, (_e818 < _e820));
                                        let _e851 = select(_e847, _e843, (_e843 > _e847));
                                        let _e853 = select(_e849, _e845, (_e845 > _e849));
                                        let _e855 = select(_e835, _e851, (_e851 > _e835));
                                        let _e857 = select(_e837, _e853, (_e853 > _e837));
                                        let _e859 = select(_e806, _e804, (_e804 > _e806));
                                        let _e861 = select(_e807, _e805, (_e805 > _e807));
                                        let _e863 = select(_e819, _e817, (_e817 > _e819));
                                        let _e865 = select(_e820, _e818, (_e818 > _e820));
                                        let _e867 = select(_e863, _e859, (_e859 < _e863));
                                        let _e869 = select(_e865, _e861, (_e861 < _e865));
                                        let _e874 = -(_e835);
                                        let _e875 = -(_e837);
                                        let _e882 = (select(_e839, _e867, (_e867 < _e839)) + (select(_e874, _e839, (_e839 > _e874)) * 0.0000019073523f));
                                        let _e883 = (select(_e841, _e869, (_e869 < _e841)) + (select(_e875, _e841, (_e841 > _e875)) * 0.0000019073523f));
                                        let _e885 = select(_e698, _e855, (_e855 > _e698));
                                        let _e887 = select(_e698, _e857, (_e857 > _e698));
                                        let _e892 = (_e885 <= select(_e708.member_1, _e882, (_e882 < _e708.member_1)));
                                        let _e893 = (_e887 <= select(_e708.member_1, _e883, (_e883 < _e708.member_1)));
                                        let _e894 = (_e885 <= _e887);
                                        if _e892 {
                                            if _e893 {
                                                if _e894 {
                                                    phi_3112_ = _e792.member_2;
                                                } else {
                                                    phi_3112_ = _e792.member_1;
                                                }
                                                let _e898 = phi_3112_;
                                                let _e901 = (_e733 % 128u);
                                                let _e902 = (_e901 < 128u);
                                                if _e902 {
                                                } else {
                                                    phi_3618_ = true;
                                                    break;
                                                }
                                                local_1[_e901] = _e898;
                                                if _e902 {
                                                } else {
                                                    phi_3618_ = true;
                                                    break;
                                                }
                                                local[_e901] = select(_e887, _e885, !(_e894));
                                                if _e894 {
                                                    phi_3140_ = _e792.member_1;
                                                } else {
                                                    phi_3140_ = _e792.member_2;
                                                }
                                                let _e909 = phi_3140_;
                                                phi_3141_ = (_e733 + 1u);
                                                phi_3142_ = _e909;
                                            } else {
                                                phi_3141_ = u32();
                                                phi_3142_ = u32();
                                            }
                                            let _e911 = phi_3141_;
                                            let _e913 = phi_3142_;
                                            phi_3144_ = _e911;
                                            phi_3145_ = _e913;
                                            phi_3146_ = select(true, false, _e893);
                                        } else {
                                            phi_3144_ = u32();
                                            phi_3145_ = u32();
                                            phi_3146_ = true;
                                        }
                                        let _e916 = phi_3144_;
                                        let _e918 = phi_3145_;
                                        let _e920 = phi_3146_;
                                        if _e920 {
                                            if _e892 {
                                                phi_3155_ = _e792.member_1;
                                            } else {
                                                phi_3155_ = _e792.member_2;
                                            }
                                            let _e924 = phi_3155_;
                                            phi_3160_ = select(_e893, true, _e892);
                                            phi_3162_ = _e924;
                                        } else {
                                            phi_3160_ = _e731;
                                            phi_3162_ = _e918;
                                        }
                                        let _e927 = phi_3160_;
                                        let _e929 = phi_3162_;
                                        phi_3622_ = _e706;
                                        phi_3166_ = _e708;
                                        phi_3167_ = _e927;
                                        phi_3168_ = select(_e916, _e733, _e920);
                                        phi_3169_ = _e929;
                                    }
                                    let _e1749 = phi_3622_;
                                    let _e1751 = phi_3166_;
                                    let _e1753 = phi_3167_;
                                    let _e1755 = phi_3168_;
                                    let _e1757 = phi_3169_;
                                    phi_3621_ = _e1749;
                                    phi_3170_ = _e1751;
                                    phi_3171_ = _e1753;
                                    phi_3172_ = (_e712 - 1u);
                                    phi_3173_ = _e1755;
                                    phi_3174_ = _e1757;
                                } else {
                                    phi_3621_ = _e706;
                                    phi_3170_ = _e708;
                                    phi_3171_ = _e731;
                                    phi_3172_ = _e712;
                                    phi_3173_ = _e733;
                                    phi_3174_ = _e735;
                                }
                                let _e1759 = phi_3621_;
                                let _e1761 = phi_3170_;
                                let _e1763 = phi_3171_;
                                let _e1765 = phi_3172_;
                                let _e1767 = phi_3173_;
                                let _e1769 = phi_3174_;
                                phi_3620_ = _e1759;
                                phi_3175_ = _e1761;
                                phi_3176_ = _e1763;
                                phi_3177_ = _e1765;
                                phi_3178_ = _e1767;
                                phi_3179_ = _e1769;
                            } else {
                                phi_3620_ = _e706;
                                phi_3175_ = type_50();
                                phi_3176_ = bool();
                                phi_3177_ = u32();
                                phi_3178_ = u32();
                                phi_3179_ = u32();
                            }
                            let _e1771 = phi_3620_;
                            let _e1773 = phi_3175_;
                            let _e1775 = phi_3176_;
                            let _e1777 = phi_3177_;
                            let _e1779 = phi_3178_;
                            let _e1781 = phi_3179_;
                            phi_3619_ = _e1771;
                            phi_1211_ = _e1773;
                            phi_1214_ = _e1775;
                            phi_1216_ = _e1777;
                            phi_1218_ = _e1779;
                            phi_1220_ = _e1781;
                            phi_3180_ = _e720;
                        } else {
                            phi_3619_ = _e706;
                            phi_1211_ = type_50();
                            phi_1214_ = bool();
                            phi_1216_ = u32();
                            phi_1218_ = u32();
                            phi_1220_ = u32();
                            phi_3180_ = false;
                        }
                        let _e1783 = phi_3619_;
                        let _e1785 = phi_1211_;
                        let _e1787 = phi_1214_;
                        let _e1789 = phi_1216_;
                        let _e1791 = phi_1218_;
                        let _e1793 = phi_1220_;
                        let _e1795 = phi_3180_;
                        continue;
                        continuing {
                            phi_3432_ = _e1783;
                            phi_1210_ = _e1785;
                            phi_1213_ = _e1787;
                            phi_1215_ = _e1789;
                            phi_1217_ = _e1791;
                            phi_1219_ = _e1793;
                            phi_3618_ = _e1783;
                            break if !(_e1795);
                        }
                    }
                    let _e1798 = phi_3618_;
                    if _e1798 {
                        break;
                    }
                    let _e1800 = local_2;
                    if (_e1800.member.member_3 != 4294967295u) {
                        let _e1805 = bitcast<u32>(_e1800.member.member);
                        let _e1809 = (bitcast<i32>((_e1805 >> bitcast<u32>(23i))) & 255i);
                        let _e1810 = (_e1809 + _e367);
                        if (_e1809 == 255i) {
                            phi_3239_ = _e1800.member.member;
                        } else {
                            if (_e1809 > 0i) {
                                if (_e1810 > 0i) {
                                    let _e1814 = (_e1810 < 255i);
                                    if _e1814 {
                                        phi_3218_ = bitcast<f32>((_e1805 + bitcast<u32>((_e367 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_3218_ = f32();
                                    }
                                    let _e1821 = phi_3218_;
                                    phi_3220_ = _e1821;
                                    phi_3221_ = select(true, false, _e1814);
                                } else {
                                    phi_3220_ = f32();
                                    phi_3221_ = true;
                                }
                                let _e1824 = phi_3220_;
                                let _e1826 = phi_3221_;
                                phi_3222_ = _e1824;
                                phi_3223_ = _e1826;
                            } else {
                                phi_3222_ = f32();
                                phi_3223_ = true;
                            }
                            let _e1828 = phi_3222_;
                            let _e1830 = phi_3223_;
                            if _e1830 {
                                let _e1831 = (_e1805 & 2147483648u);
                                let _e1838 = ((_e1805 & 8388607u) | (select(0u, 1u, ((_e1805 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1842 = (_e1838 == 0u);
                                if _e1842 {
                                    phi_3421_ = bitcast<f32>(_e1831);
                                } else {
                                    let _e1847 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1838)), 32u, _e1842) - 8u);
                                    let _e1850 = (_e1838 << bitcast<u32>((_e1847 & 31u)));
                                    let _e1852 = ((_e1810 + select(0i, 1i, (_e1809 == 0i))) - bitcast<i32>(_e1847));
                                    if (_e1852 >= 255i) {
                                        phi_3411_ = bitcast<f32>((_e1831 | 2139095040u));
                                        phi_3412_ = f32();
                                        phi_3413_ = true;
                                    } else {
                                        let _e1854 = (_e1852 > 0i);
                                        if _e1854 {
                                            phi_3405_ = bitcast<f32>(((_e1831 | (bitcast<u32>(_e1852) << bitcast<u32>(23i))) | (_e1850 & 8388607u)));
                                            phi_3406_ = f32();
                                        } else {
                                            if (_e1852 < -24i) {
                                                phi_3371_ = 26u;
                                            } else {
                                                phi_3371_ = bitcast<u32>((1i - _e1852));
                                            }
                                            let _e1859 = phi_3371_;
                                            let _e1860 = (_e1859 & 31u);
                                            let _e1862 = (_e1850 >> bitcast<u32>(_e1860));
                                            let _e1866 = (_e1850 & ((1u << bitcast<u32>(_e1860)) - 1u));
                                            let _e1870 = (1u << bitcast<u32>(((_e1859 - 1u) & 31u)));
                                            if (_e1866 > _e1870) {
                                                phi_3392_ = true;
                                            } else {
                                                if (_e1866 == _e1870) {
                                                    phi_3389_ = ((_e1862 & 1u) == 1u);
                                                } else {
                                                    phi_3389_ = false;
                                                }
                                                let _e1876 = phi_3389_;
                                                phi_3392_ = _e1876;
                                            }
                                            let _e1878 = phi_3392_;
                                            phi_3405_ = f32();
                                            phi_3406_ = bitcast<f32>((_e1831 | (_e1862 + select(0u, 1u, _e1878))));
                                        }
                                        let _e1891 = phi_3405_;
                                        let _e1893 = phi_3406_;
                                        phi_3411_ = _e1891;
                                        phi_3412_ = _e1893;
                                        phi_3413_ = _e1854;
                                    }
                                    let _e1897 = phi_3411_;
                                    let _e1899 = phi_3412_;
                                    let _e1901 = phi_3413_;
                                    phi_3421_ = select(_e1899, _e1897, _e1901);
                                }
                                let _e1905 = phi_3421_;
                                phi_3238_ = _e1905;
                            } else {
                                phi_3238_ = _e1828;
                            }
                            let _e1907 = phi_3238_;
                            phi_3239_ = _e1907;
                        }
                        let _e1909 = phi_3239_;
                        let _e1910 = bitcast<u32>(_e1909);
                        if ((_e1910 & 2147483647u) >= 2139095040u) {
                            phi_3251_ = bitcast<f32>(((_e1910 & 2147483648u) | 2139095039u));
                        } else {
                            phi_3251_ = _e1909;
                        }
                        let _e1917 = phi_3251_;
                        phi_3256_ = type_28(_e1917, _e1800.member.member_1, _e1800.member.member_2, _e1800.member.member_3);
                    } else {
                        phi_3256_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1922 = phi_3256_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_8.member[_e104] = _e1922;
                    if _e105 {
                    } else {
                        break;
                    }
                    let _e1926 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1926 > 0u) {
                        let _e1928 = (1u < _e100);
                        if _e1928 {
                            if (0u < _e100) {
                            } else {
                                break;
                            }
                            let _e1932 = atomicAdd((&global_9.member[0u]), _e1926);
                            if ((_e1932 + _e1926) < _e1932) {
                                if _e1928 {
                                } else {
                                    break;
                                }
                                let _e1937 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1940 = select(0u, 1u, (_e1922.member_3 != 4294967295u));
                    if (_e1940 > 0u) {
                        let _e1942 = (3u < _e100);
                        if _e1942 {
                            if (2u < _e100) {
                            } else {
                                break;
                            }
                            let _e1946 = atomicAdd((&global_9.member[2u]), _e1940);
                            if ((_e1946 + _e1940) < _e1946) {
                                if _e1942 {
                                } else {
                                    break;
                                }
                                let _e1951 = atomicAdd((&global_9.member[3u]), 1u);
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
