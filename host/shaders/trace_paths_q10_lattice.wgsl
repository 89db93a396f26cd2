struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_25,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_57 {
    member: type_37,
    member_1: u32,
}

struct type_58 {
    member: array<vec4<f32>, 3>,
    member_1: type_57,
    member_2: type_57,
}

struct type_63 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_63;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_422_: u32;
    var phi_466_: i32;
    var phi_606_: type_39;
    var phi_712_: i32;
    var phi_713_: i32;
    var phi_723_: bool;
    var phi_733_: u32;
    var phi_734_: u32;
    var phi_736_: bool;
    var phi_741_: u32;
    var phi_774_: i32;
    var phi_792_: f32;
    var phi_798_: f32;
    var phi_838_: f32;
    var phi_844_: f32;
    var phi_896_: f32;
    var phi_908_: f32;
    var phi_917_: f32;
    var phi_923_: f32;
    var phi_963_: f32;
    var phi_969_: f32;
    var phi_1021_: f32;
    var phi_1033_: f32;
    var phi_1042_: f32;
    var phi_1048_: f32;
    var phi_1088_: f32;
    var phi_1094_: f32;
    var phi_1146_: f32;
    var phi_1158_: f32;
    var phi_1213_: i32;
    var phi_1235_: u32;
    var phi_1236_: u32;
    var phi_1273_: i32;
    var phi_1295_: u32;
    var phi_1296_: u32;
    var phi_1304_: f32;
    var phi_1305_: f32;
    var phi_5280_: bool;
    var phi_1401_: type_43;
    var phi_1404_: u32;
    var phi_1406_: bool;
    var phi_1408_: u32;
    var phi_1410_: type_57;
    var phi_1421_: bool;
    var phi_1507_: bool;
    var phi_1508_: u32;
    var phi_1509_: type_57;
    var phi_1528_: type_43;
    var phi_1531_: type_8;
    var phi_1532_: type_8;
    var phi_1554_: type_8;
    var phi_1595_: u32;
    var phi_1601_: u32;
    var phi_1611_: u32;
    var phi_1627_: u32;
    var phi_1660_: u32;
    var phi_1666_: u32;
    var phi_2132_: u32;
    var phi_2150_: u32;
    var phi_2168_: u32;
    var phi_2191_: u32;
    var phi_2209_: u32;
    var phi_2227_: u32;
    var phi_2250_: u32;
    var phi_2268_: u32;
    var phi_2286_: u32;
    var phi_1840_: u32;
    var phi_1855_: u32;
    var phi_1865_: u32;
    var phi_1886_: u32;
    var phi_1907_: u32;
    var phi_1937_: u32;
    var phi_1952_: u32;
    var phi_1962_: u32;
    var phi_1983_: u32;
    var phi_2004_: u32;
    var phi_2034_: u32;
    var phi_2049_: u32;
    var phi_2059_: u32;
    var phi_2080_: u32;
    var phi_2101_: u32;
    var phi_1693_: u32;
    var phi_1742_: u32;
    var phi_1791_: u32;
    var phi_2292_: array<array<f32, 3>, 3>;
    var phi_2444_: bool;
    var phi_2473_: bool;
    var phi_2892_: f32;
    var phi_2893_: f32;
    var phi_2894_: f32;
    var phi_2895_: f32;
    var phi_2896_: vec3<f32>;
    var phi_2897_: vec3<f32>;
    var phi_2898_: vec3<f32>;
    var phi_2899_: vec3<f32>;
    var phi_2936_: bool;
    var phi_2945_: vec3<f32>;
    var phi_3110_: f32;
    var phi_3112_: f32;
    var phi_3113_: bool;
    var phi_3133_: f32;
    var phi_3134_: f32;
    var phi_3157_: type_25;
    var phi_3159_: type_25;
    var phi_3160_: bool;
    var phi_3164_: type_25;
    var phi_3165_: type_25;
    var phi_3166_: type_25;
    var phi_3167_: bool;
    var phi_3171_: type_25;
    var phi_3172_: bool;
    var phi_3173_: type_25;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var phi_3176_: type_25;
    var phi_3177_: bool;
    var phi_3178_: bool;
    var phi_3186_: type_25;
    var phi_3187_: bool;
    var phi_3191_: type_25;
    var phi_3214_: u32;
    var phi_3228_: i32;
    var phi_3250_: vec3<f32>;
    var phi_3251_: vec3<f32>;
    var phi_3269_: vec3<f32>;
    var phi_3270_: vec3<f32>;
    var phi_3288_: vec3<f32>;
    var phi_3289_: vec3<f32>;
    var phi_3325_: vec3<f32>;
    var phi_3507_: f32;
    var phi_3525_: bool;
    var phi_3526_: bool;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var phi_3552_: type_43;
    var phi_3553_: type_43;
    var phi_3554_: type_43;
    var phi_1529_: type_43;
    var phi_5274_: bool;
    var phi_5604_: bool;
    var phi_3555_: type_43;
    var phi_4057_: u32;
    var phi_4063_: u32;
    var phi_4317_: u32;
    var phi_4318_: u32;
    var phi_4328_: u32;
    var phi_4330_: u32;
    var phi_4331_: bool;
    var phi_4351_: u32;
    var phi_4352_: u32;
    var phi_4356_: type_58;
    var phi_4718_: type_57;
    var phi_4794_: type_57;
    var phi_4795_: u32;
    var phi_4796_: type_57;
    var phi_4798_: u32;
    var phi_4799_: type_57;
    var phi_4800_: bool;
    var phi_4809_: type_57;
    var phi_4814_: bool;
    var phi_4816_: type_57;
    var phi_4820_: bool;
    var phi_4821_: u32;
    var phi_4822_: type_57;
    var phi_4832_: type_57;
    var phi_5516_: bool;
    var phi_4833_: type_43;
    var phi_4834_: u32;
    var phi_4835_: bool;
    var phi_4836_: u32;
    var phi_4837_: type_57;
    var phi_5515_: bool;
    var phi_4838_: type_43;
    var phi_4839_: u32;
    var phi_4840_: bool;
    var phi_4841_: u32;
    var phi_4842_: type_57;
    var phi_5514_: bool;
    var phi_1402_: type_43;
    var phi_1405_: u32;
    var phi_1407_: bool;
    var phi_1409_: u32;
    var phi_1411_: type_57;
    var phi_4843_: bool;
    var phi_5513_: bool;
    var local_10: type_43;
    var phi_4881_: f32;
    var phi_4883_: f32;
    var phi_4884_: bool;
    var phi_4885_: f32;
    var phi_4886_: bool;
    var phi_5182_: u32;
    var phi_5200_: bool;
    var phi_5203_: bool;
    var phi_5216_: f32;
    var phi_5217_: f32;
    var phi_5222_: f32;
    var phi_5223_: f32;
    var phi_5224_: bool;
    var phi_5232_: f32;
    var phi_4901_: f32;
    var phi_4902_: f32;
    var phi_4914_: f32;
    var phi_4919_: type_25;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e107 = global;
            let _e109 = arrayLength((&global_4.member));
            let _e112 = arrayLength((&global_10.member));
            let _e124 = arrayLength((&global_9.member));
            let _e128 = global_3.member[0u][0u];
            let _e132 = global_3.member[0u][1u];
            let _e136 = global_3.member[0u][2u];
            let _e140 = global_3.member[0u][3u];
            let _e144 = global_3.member[1u][0u];
            let _e148 = global_3.member[1u][1u];
            let _e152 = global_3.member[1u][2u];
            let _e156 = (_e107.x + (_e107.y * 2097152u));
            let _e168 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e140) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e128), bitcast<i32>(_e132), bitcast<i32>(_e136));
            local = array<i32, 3>(bitcast<i32>(_e144), bitcast<i32>(_e148), bitcast<i32>(_e152));
            let _e171 = (_e156 < arrayLength((&global_7.member)));
            if _e171 {
                if _e171 {
                } else {
                    break;
                }
                let _e175 = global_7.member[_e156].member_2;
                phi_422_ = _e175;
            } else {
                phi_422_ = 4294967295u;
            }
            let _e177 = phi_422_;
            let _e180 = global_1.member[0u];
            let _e184 = global_2.member[0u][0u];
            let _e188 = global_2.member[0u][1u];
            let _e192 = global_2.member[0u][2u];
            let _e196 = global_2.member[0u][3u];
            let _e200 = global_2.member[1u][0u];
            let _e204 = global_2.member[1u][1u];
            let _e208 = global_2.member[1u][2u];
            let _e212 = global_2.member[1u][3u];
            let _e213 = bitcast<f32>(_e184);
            let _e214 = bitcast<f32>(_e188);
            let _e215 = bitcast<f32>(_e192);
            let _e217 = bitcast<f32>(_e200);
            let _e218 = array<u32, 3>(_e204, _e208, _e212);
            let _e220 = bitcast<i32>(_e180);
            if (_e220 < -126i) {
                phi_466_ = -126i;
            } else {
                phi_466_ = select(_e220, 127i, (_e220 > 127i));
            }
            let _e225 = phi_466_;
            let _e230 = bitcast<f32>((bitcast<u32>((_e225 + 127i)) << bitcast<u32>(23i)));
            let _e236 = bitcast<f32>((bitcast<u32>(((_e220 - _e225) + 127i)) << bitcast<u32>(23i)));
            if (_e196 == 0u) {
                phi_606_ = type_39(array<f32, 3>(_e213, _e214, _e215), _e196, _e217, _e218);
            } else {
                let _e238 = bitcast<u32>(_e213);
                let _e240 = ((_e238 & 2139095040u) != 0u);
                let _e255 = bitcast<u32>(_e214);
                let _e257 = ((_e255 & 2139095040u) != 0u);
                let _e272 = bitcast<u32>(_e215);
                let _e274 = ((_e272 & 2139095040u) != 0u);
                let _e290 = bitcast<u32>(_e217);
                let _e292 = ((_e290 & 2139095040u) != 0u);
                phi_606_ = type_39(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e238 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e238 & 2147483648u))), _e213, _e240) * _e230) * select(0.00000011920929f, 1f, _e240)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e214, _e257) * _e230) * select(0.00000011920929f, 1f, _e257)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e215, _e274) * _e230) * select(0.00000011920929f, 1f, _e274)) * _e236)), _e196, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e290 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e290 & 2147483648u))), _e217, _e292) * _e230) * select(0.00000011920929f, 1f, _e292)) * _e236), _e218);
            }
            let _e309 = phi_606_;
            if _e171 {
                let _e310 = (_e156 < arrayLength((&global_8.member)));
                if _e310 {
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e320 = global_7.member[_e156].member.member_2[0u];
                    let _e322 = (bitcast<u32>(_e320) & 2147483647u);
                    let _e328 = global_7.member[_e156].member.member_2[1u];
                    let _e330 = (bitcast<u32>(_e328) & 2147483647u);
                    let _e336 = global_7.member[_e156].member.member_2[2u];
                    let _e338 = (bitcast<u32>(_e336) & 2147483647u);
                    let _e344 = global_7.member[_e156].member.member[0u];
                    let _e346 = (bitcast<u32>(_e344) & 2147483647u);
                    let _e352 = global_7.member[_e156].member.member[1u];
                    let _e354 = (bitcast<u32>(_e352) & 2147483647u);
                    let _e360 = global_7.member[_e156].member.member[2u];
                    let _e362 = (bitcast<u32>(_e360) & 2147483647u);
                    let _e364 = select(_e330, _e322, (_e330 < _e322));
                    let _e366 = select(_e338, _e364, (_e338 < _e364));
                    let _e368 = select(_e346, _e366, (_e346 < _e366));
                    let _e370 = select(_e354, _e368, (_e354 < _e368));
                    let _e372 = select(_e362, _e370, (_e362 < _e370));
                    let _e377 = global_7.member[_e156].member.member_1;
                    let _e378 = bitcast<u32>(_e377);
                    let _e379 = (_e378 & 2147483647u);
                    let _e387 = global_7.member[_e156].member.member_3;
                    let _e388 = bitcast<u32>(_e387);
                    let _e389 = (_e388 & 2147483647u);
                    let _e393 = (((select(_e379, _e372, (_e379 < _e372)) < 2139095040u) && (_e389 <= 2139095040u)) && (_e366 > 0u));
                    if _e393 {
                        let _e396 = (bitcast<u32>(bitcast<f32>(_e366)) & 2147483647u);
                        if (_e396 >= 8388608u) {
                            phi_712_ = (bitcast<i32>((_e396 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_712_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u))));
                        }
                        let _e410 = phi_712_;
                        phi_713_ = _e410;
                    } else {
                        phi_713_ = 0i;
                    }
                    let _e412 = phi_713_;
                    let _e413 = (_e322 == _e366);
                    if _e413 {
                        phi_723_ = true;
                    } else {
                        phi_723_ = (_e330 == _e366);
                    }
                    let _e416 = phi_723_;
                    let _e417 = select(1u, 0u, _e413);
                    if _e416 {
                        let _e418 = (_e417 + 1u);
                        phi_733_ = _e418;
                        phi_734_ = _e418;
                        phi_736_ = select(true, false, (_e418 == 2u));
                    } else {
                        phi_733_ = u32();
                        phi_734_ = 0u;
                        phi_736_ = true;
                    }
                    let _e422 = phi_733_;
                    let _e424 = phi_734_;
                    let _e426 = phi_736_;
                    if _e426 {
                        phi_741_ = (_e424 + 1u);
                    } else {
                        phi_741_ = 0u;
                    }
                    let _e430 = phi_741_;
                    let _e431 = select(_e422, _e424, _e426);
                    let _e432 = select(_e417, select(2u, _e417, _e416), _e426);
                    let _e433 = -(_e412);
                    if (_e433 < -126i) {
                        phi_774_ = -126i;
                    } else {
                        phi_774_ = select(_e433, 127i, (_e433 > 127i));
                    }
                    let _e438 = phi_774_;
                    let _e443 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                    let _e449 = bitcast<f32>((bitcast<u32>(((_e433 - _e438) + 127i)) << bitcast<u32>(23i)));
                    let _e454 = global_7.member[_e156].member.member;
                    let _e455 = (_e431 == 0u);
                    if _e455 {
                        phi_792_ = _e454[0];
                    } else {
                        phi_792_ = _e454[1];
                    }
                    let _e459 = phi_792_;
                    let _e460 = (_e431 == 2u);
                    if _e460 {
                        phi_798_ = _e454[2];
                    } else {
                        phi_798_ = _e459;
                    }
                    let _e463 = phi_798_;
                    let _e464 = bitcast<u32>(_e463);
                    let _e466 = ((_e464 & 2139095040u) != 0u);
                    let _e478 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * select(0.00000011920929f, 1f, _e466));
                    let _e479 = global_7.member[_e156].member.member_2;
                    if _e455 {
                        phi_838_ = _e479[0];
                    } else {
                        phi_838_ = _e479[1];
                    }
                    let _e483 = phi_838_;
                    if _e460 {
                        phi_844_ = _e479[2];
                    } else {
                        phi_844_ = _e483;
                    }
                    let _e486 = phi_844_;
                    let _e487 = bitcast<u32>(_e486);
                    let _e489 = ((_e487 & 2139095040u) != 0u);
                    let _e503 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e487 & 2147483648u))), _e486, _e489) * _e443) * select(0.00000011920929f, 1f, _e489)) * _e449);
                    let _e507 = (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e507 {
                        let _e511 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) * 0.00000011920929f);
                        phi_896_ = select(0.00000000000011368684f, _e511, (_e511 > 0.00000000000011368684f));
                    } else {
                        phi_896_ = 0f;
                    }
                    let _e515 = phi_896_;
                    let _e516 = (_e478 + _e515);
                    let _e517 = (_e478 - _e515);
                    let _e518 = select(_e503, 0f, _e507);
                    if _e507 {
                        phi_908_ = 38685626000000000000000000f;
                    } else {
                        phi_908_ = (1f / _e503);
                    }
                    let _e521 = phi_908_;
                    let _e522 = (_e430 == 0u);
                    if _e522 {
                        phi_917_ = _e454[0];
                    } else {
                        phi_917_ = _e454[1];
                    }
                    let _e526 = phi_917_;
                    let _e527 = (_e430 == 2u);
                    if _e527 {
                        phi_923_ = _e454[2];
                    } else {
                        phi_923_ = _e526;
                    }
                    let _e530 = phi_923_;
                    let _e531 = bitcast<u32>(_e530);
                    let _e533 = ((_e531 & 2139095040u) != 0u);
                    let _e545 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e531 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e531 & 2147483648u))), _e530, _e533) * select(0.00000011920929f, 1f, _e533));
                    if _e522 {
                        phi_963_ = _e479[0];
                    } else {
                        phi_963_ = _e479[1];
                    }
                    let _e549 = phi_963_;
                    if _e527 {
                        phi_969_ = _e479[2];
                    } else {
                        phi_969_ = _e549;
                    }
                    let _e552 = phi_969_;
                    let _e553 = bitcast<u32>(_e552);
                    let _e555 = ((_e553 & 2139095040u) != 0u);
                    let _e569 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e553 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e553 & 2147483648u))), _e552, _e555) * _e443) * select(0.00000011920929f, 1f, _e555)) * _e449);
                    let _e573 = (bitcast<f32>((bitcast<u32>(_e569) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e573 {
                        let _e577 = (bitcast<f32>((bitcast<u32>(_e545) & 2147483647u)) * 0.00000011920929f);
                        phi_1021_ = select(0.00000000000011368684f, _e577, (_e577 > 0.00000000000011368684f));
                    } else {
                        phi_1021_ = 0f;
                    }
                    let _e581 = phi_1021_;
                    let _e582 = (_e545 + _e581);
                    let _e583 = (_e545 - _e581);
                    let _e584 = select(_e569, 0f, _e573);
                    if _e573 {
                        phi_1033_ = 38685626000000000000000000f;
                    } else {
                        phi_1033_ = (1f / _e569);
                    }
                    let _e587 = phi_1033_;
                    let _e588 = (_e432 == 0u);
                    if _e588 {
                        phi_1042_ = _e454[0];
                    } else {
                        phi_1042_ = _e454[1];
                    }
                    let _e592 = phi_1042_;
                    let _e593 = (_e432 == 2u);
                    if _e593 {
                        phi_1048_ = _e454[2];
                    } else {
                        phi_1048_ = _e592;
                    }
                    let _e596 = phi_1048_;
                    let _e597 = bitcast<u32>(_e596);
                    let _e599 = ((_e597 & 2139095040u) != 0u);
                    let _e611 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e597 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e597 & 2147483648u))), _e596, _e599) * select(0.00000011920929f, 1f, _e599));
                    if _e588 {
                        phi_1088_ = _e479[0];
                    } else {
                        phi_1088_ = _e479[1];
                    }
                    let _e615 = phi_1088_;
                    if _e593 {
                        phi_1094_ = _e479[2];
                    } else {
                        phi_1094_ = _e615;
                    }
                    let _e618 = phi_1094_;
                    let _e619 = bitcast<u32>(_e618);
                    let _e621 = ((_e619 & 2139095040u) != 0u);
                    let _e635 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e619 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e619 & 2147483648u))), _e618, _e621) * _e443) * select(0.00000011920929f, 1f, _e621)) * _e449);
                    let _e639 = (bitcast<f32>((bitcast<u32>(_e635) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e639 {
                        let _e643 = (bitcast<f32>((bitcast<u32>(_e611) & 2147483647u)) * 0.00000011920929f);
                        phi_1146_ = select(0.00000000000011368684f, _e643, (_e643 > 0.00000000000011368684f));
                    } else {
                        phi_1146_ = 0f;
                    }
                    let _e647 = phi_1146_;
                    let _e648 = (_e611 + _e647);
                    let _e649 = (_e611 - _e647);
                    let _e650 = select(_e635, 0f, _e639);
                    if _e639 {
                        phi_1158_ = 38685626000000000000000000f;
                    } else {
                        phi_1158_ = (1f / _e635);
                    }
                    let _e653 = phi_1158_;
                    let _e656 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                    let _e659 = bitcast<f32>((bitcast<u32>(_e545) & 2147483647u));
                    let _e661 = select(_e659, _e656, (_e656 > _e659));
                    let _e664 = bitcast<f32>((bitcast<u32>(_e611) & 2147483647u));
                    if (_e393 && (select(_e664, _e661, (_e661 > _e664)) <= 1099511600000f)) {
                        let _e676 = ((_e379 & 8388607u) | (select(0u, 1u, ((_e379 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e679 = bitcast<i32>((_e379 >> bitcast<u32>(23i)));
                        let _e683 = (_e676 == 0u);
                        let _e686 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e676)), 32u, _e683)) - 8i);
                        if (_e679 == 255i) {
                            phi_1213_ = 255i;
                        } else {
                            phi_1213_ = (((_e679 + select(0i, 1i, (_e679 == 0i))) - _e686) + _e412);
                        }
                        let _e694 = phi_1213_;
                        let _e704 = (_e694 <= 0i);
                        if _e704 {
                            phi_1236_ = u32();
                        } else {
                            if _e683 {
                                phi_1235_ = u32();
                            } else {
                                phi_1235_ = select(((bitcast<u32>(_e694) << bitcast<u32>(23i)) | ((_e676 << bitcast<u32>(((_e686 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e694 >= 255i));
                            }
                            let _e708 = phi_1235_;
                            phi_1236_ = _e708;
                        }
                        let _e710 = phi_1236_;
                        let _e722 = ((_e389 & 8388607u) | (select(0u, 1u, ((_e389 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e725 = bitcast<i32>((_e389 >> bitcast<u32>(23i)));
                        let _e729 = (_e722 == 0u);
                        let _e732 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e722)), 32u, _e729)) - 8i);
                        if (_e725 == 255i) {
                            phi_1273_ = 255i;
                        } else {
                            phi_1273_ = (((_e725 + select(0i, 1i, (_e725 == 0i))) - _e732) + _e412);
                        }
                        let _e740 = phi_1273_;
                        let _e750 = (_e740 <= 0i);
                        if _e750 {
                            phi_1296_ = u32();
                        } else {
                            if _e729 {
                                phi_1295_ = u32();
                            } else {
                                phi_1295_ = select(((bitcast<u32>(_e740) << bitcast<u32>(23i)) | ((_e722 << bitcast<u32>(((_e732 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e740 >= 255i));
                            }
                            let _e754 = phi_1295_;
                            phi_1296_ = _e754;
                        }
                        let _e756 = phi_1296_;
                        phi_1304_ = bitcast<f32>(((_e388 & 2147483648u) | select(_e756, 0u, select(_e729, true, _e750))));
                        phi_1305_ = bitcast<f32>(((_e378 & 2147483648u) | select(_e710, 0u, select(_e683, true, _e704))));
                    } else {
                        phi_1304_ = 0f;
                        phi_1305_ = 1f;
                    }
                    let _e762 = phi_1304_;
                    let _e764 = phi_1305_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e768 = (_e431 % 3u);
                    let _e769 = (_e768 < 3u);
                    if _e769 {
                    } else {
                        break;
                    }
                    let _e771 = local_1[_e768];
                    let _e774 = (_e430 % 3u);
                    let _e775 = (_e774 < 3u);
                    if _e775 {
                    } else {
                        break;
                    }
                    let _e777 = local_1[_e774];
                    let _e780 = (_e432 % 3u);
                    let _e781 = (_e780 < 3u);
                    if _e781 {
                    } else {
                        break;
                    }
                    let _e783 = local_1[_e780];
                    if _e769 {
                    } else {
                        break;
                    }
                    let _e788 = local[_e768];
                    if _e775 {
                    } else {
                        break;
                    }
                    let _e792 = local[_e774];
                    if _e781 {
                    } else {
                        break;
                    }
                    let _e796 = local[_e780];
                    phi_5280_ = false;
                    phi_1401_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e762);
                    phi_1404_ = ((3u * _e109) + 1u);
                    phi_1406_ = (_e764 <= _e762);
                    phi_1408_ = 0u;
                    phi_1410_ = type_57(type_37(vec4<f32>((f32(_e771) * _e168), (f32(_e777) * _e168), (f32(_e783) * _e168), 0f), vec4<f32>((f32(_e788) * _e168), (f32(_e792) * _e168), (f32(_e796) * _e168), 0f)), select(0u, 2147483648u, (_e109 == 0u)));
                    loop {
                        let _e806 = phi_5280_;
                        let _e808 = phi_1401_;
                        let _e810 = phi_1404_;
                        let _e812 = phi_1406_;
                        let _e814 = phi_1408_;
                        let _e816 = phi_1410_;
                        local_10 = _e808;
                        if _e812 {
                            phi_1421_ = true;
                        } else {
                            phi_1421_ = (_e814 > 0u);
                        }
                        let _e819 = phi_1421_;
                        if _e819 {
                            let _e820 = (_e810 > 0u);
                            if _e820 {
                                if _e812 {
                                    phi_1507_ = _e812;
                                    phi_1508_ = _e814;
                                    phi_1509_ = _e816;
                                } else {
                                    let _e821 = (_e814 - 1u);
                                    let _e822 = (_e821 % 128u);
                                    let _e823 = (_e822 < 128u);
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e825 = local_7[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e827 = local_6[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e829 = local_5[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e831 = local_4[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e833 = local_3[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e835 = local_2[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e840 = local_8[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5513_ = true;
                                        break;
                                    }
                                    let _e843 = local_9[_e822];
                                    phi_1507_ = (_e843 <= _e808.member_1);
                                    phi_1508_ = _e821;
                                    phi_1509_ = type_57(type_37(vec4<f32>(_e825, _e827, _e829, 0f), vec4<f32>(_e831, _e833, _e835, 0f)), _e840);
                                }
                                let _e847 = phi_1507_;
                                let _e849 = phi_1508_;
                                let _e851 = phi_1509_;
                                if _e847 {
                                    let _e855 = ((_e851.member_1 & 2147483648u) != 0u);
                                    let _e856 = (_e851.member_1 & 268435455u);
                                    if _e855 {
                                        phi_1528_ = _e808;
                                        phi_1531_ = type_8(0u, ((_e851.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e863 = phi_1528_;
                                            let _e865 = phi_1531_;
                                            local_11 = _e863;
                                            if (_e865.member < _e865.member_1) {
                                                phi_1532_ = type_8((_e865.member + 1u), _e865.member_1);
                                                phi_1554_ = type_8(1u, _e865.member);
                                            } else {
                                                phi_1532_ = _e865;
                                                phi_1554_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e878 = phi_1532_;
                                            let _e880 = phi_1554_;
                                            let _e884 = (bitcast<i32>(_e880.member) != 0i);
                                            if _e884 {
                                                let _e889 = (_e851.member.member_1.x - _e851.member.member.x);
                                                let _e892 = (_e851.member.member_1.y - _e851.member.member.y);
                                                let _e895 = (_e851.member.member_1.z - _e851.member.member.z);
                                                let _e897 = select(_e892, _e889, (_e889 > _e892));
                                                let _e899 = select(_e895, _e897, (_e897 > _e895));
                                                let _e901 = (_e899 < (1024f * _e168));
                                                if _e901 {
                                                    phi_1595_ = 0u;
                                                } else {
                                                    phi_1595_ = select(2u, 1u, (_e899 < (2097152f * _e168)));
                                                }
                                                let _e906 = phi_1595_;
                                                switch bitcast<i32>(_e906) {
                                                    case 0: {
                                                        phi_1601_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1601_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1601_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1601_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e909 = phi_1601_;
                                                switch bitcast<i32>(_e906) {
                                                    case 0: {
                                                        phi_1611_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1611_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1611_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1611_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e916 = phi_1611_;
                                                let _e918 = ((_e856 + (_e880.member_1 * ((3u * _e909) + 1u))) + (3u * _e916));
                                                let _e919 = (_e918 < _e112);
                                                if _e919 {
                                                    if _e919 {
                                                    } else {
                                                        phi_5274_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_10.member[_e918];
                                                    phi_1627_ = _e921;
                                                } else {
                                                    phi_1627_ = 4294967295u;
                                                }
                                                let _e923 = phi_1627_;
                                                if _e901 {
                                                    phi_1660_ = 0u;
                                                } else {
                                                    phi_1660_ = select(2u, 1u, (_e899 < (2097152f * _e168)));
                                                }
                                                let _e928 = phi_1660_;
                                                switch bitcast<i32>(_e928) {
                                                    case 0: {
                                                        phi_1666_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1666_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1666_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1666_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e931 = phi_1666_;
                                                let _e935 = (_e856 + (_e880.member_1 * ((3u * _e931) + 1u)));
                                                switch bitcast<i32>(_e928) {
                                                    case 0: {
                                                        let _e1210 = (_e935 < _e112);
                                                        if _e1210 {
                                                            if _e1210 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1212 = global_10.member[_e935];
                                                            phi_1693_ = _e1212;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1214 = phi_1693_;
                                                        let _e1216 = ((10u * _e431) & 31u);
                                                        let _e1226 = ((10u * _e430) & 31u);
                                                        let _e1236 = ((10u * _e432) & 31u);
                                                        let _e1246 = (_e935 + 1u);
                                                        let _e1247 = (_e1246 < _e112);
                                                        if _e1247 {
                                                            if _e1247 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1249 = global_10.member[_e1246];
                                                            phi_1742_ = _e1249;
                                                        } else {
                                                            phi_1742_ = 0u;
                                                        }
                                                        let _e1251 = phi_1742_;
                                                        let _e1277 = (_e935 + 2u);
                                                        let _e1278 = (_e1277 < _e112);
                                                        if _e1278 {
                                                            if _e1278 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1280 = global_10.member[_e1277];
                                                            phi_1791_ = _e1280;
                                                        } else {
                                                            phi_1791_ = 0u;
                                                        }
                                                        let _e1282 = phi_1791_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1214 >> bitcast<u32>(_e1216)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1214 >> bitcast<u32>(_e1226)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1214 >> bitcast<u32>(_e1236)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1251 >> bitcast<u32>(_e1216)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1251 >> bitcast<u32>(_e1226)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1251 >> bitcast<u32>(_e1236)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1282 >> bitcast<u32>(_e1216)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1282 >> bitcast<u32>(_e1226)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1282 >> bitcast<u32>(_e1236)) & 1023u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1024 = (_e935 < _e112);
                                                        if _e1024 {
                                                            if _e1024 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1026 = global_10.member[_e935];
                                                            phi_1840_ = _e1026;
                                                        } else {
                                                            phi_1840_ = 0u;
                                                        }
                                                        let _e1028 = phi_1840_;
                                                        let _e1029 = (_e935 + 1u);
                                                        let _e1030 = (_e1029 < _e112);
                                                        if _e1030 {
                                                            if _e1030 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1032 = global_10.member[_e1029];
                                                            phi_1855_ = _e1032;
                                                        } else {
                                                            phi_1855_ = 0u;
                                                        }
                                                        let _e1034 = phi_1855_;
                                                        let _e1035 = (_e431 == 1u);
                                                        if _e1035 {
                                                            phi_1865_ = ((_e1028 >> bitcast<u32>(21i)) | (_e1034 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1865_ = (_e1034 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1044 = phi_1865_;
                                                        let _e1052 = (_e430 == 1u);
                                                        if _e1052 {
                                                            phi_1886_ = ((_e1028 >> bitcast<u32>(21i)) | (_e1034 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1886_ = (_e1034 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1061 = phi_1886_;
                                                        let _e1069 = (_e432 == 1u);
                                                        if _e1069 {
                                                            phi_1907_ = ((_e1028 >> bitcast<u32>(21i)) | (_e1034 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1907_ = (_e1034 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1078 = phi_1907_;
                                                        let _e1087 = (_e935 + 2u);
                                                        let _e1088 = (_e1087 < _e112);
                                                        if _e1088 {
                                                            if _e1088 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1090 = global_10.member[_e1087];
                                                            phi_1937_ = _e1090;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1092 = phi_1937_;
                                                        let _e1093 = (_e935 + 3u);
                                                        let _e1094 = (_e1093 < _e112);
                                                        if _e1094 {
                                                            if _e1094 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1096 = global_10.member[_e1093];
                                                            phi_1952_ = _e1096;
                                                        } else {
                                                            phi_1952_ = 0u;
                                                        }
                                                        let _e1098 = phi_1952_;
                                                        if _e1035 {
                                                            phi_1962_ = ((_e1092 >> bitcast<u32>(21i)) | (_e1098 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1962_ = (_e1098 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1107 = phi_1962_;
                                                        if _e1052 {
                                                            phi_1983_ = ((_e1092 >> bitcast<u32>(21i)) | (_e1098 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1983_ = (_e1098 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1123 = phi_1983_;
                                                        if _e1069 {
                                                            phi_2004_ = ((_e1092 >> bitcast<u32>(21i)) | (_e1098 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2004_ = (_e1098 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1139 = phi_2004_;
                                                        let _e1148 = (_e935 + 4u);
                                                        let _e1149 = (_e1148 < _e112);
                                                        if _e1149 {
                                                            if _e1149 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1151 = global_10.member[_e1148];
                                                            phi_2034_ = _e1151;
                                                        } else {
                                                            phi_2034_ = 0u;
                                                        }
                                                        let _e1153 = phi_2034_;
                                                        let _e1154 = (_e935 + 5u);
                                                        let _e1155 = (_e1154 < _e112);
                                                        if _e1155 {
                                                            if _e1155 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1157 = global_10.member[_e1154];
                                                            phi_2049_ = _e1157;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1159 = phi_2049_;
                                                        if _e1035 {
                                                            phi_2059_ = ((_e1153 >> bitcast<u32>(21i)) | (_e1159 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2059_ = (_e1159 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1168 = phi_2059_;
                                                        if _e1052 {
                                                            phi_2080_ = ((_e1153 >> bitcast<u32>(21i)) | (_e1159 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2080_ = (_e1159 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1184 = phi_2080_;
                                                        if _e1069 {
                                                            phi_2101_ = ((_e1153 >> bitcast<u32>(21i)) | (_e1159 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2101_ = (_e1159 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1200 = phi_2101_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1044, _e1028, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1061, _e1028, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1078, _e1028, _e588) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1107, _e1092, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1123, _e1092, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1139, _e1092, _e588) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1168, _e1153, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1184, _e1153, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1200, _e1153, _e588) & 2097151u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e937 = (_e935 + _e431);
                                                        let _e938 = (_e937 < _e112);
                                                        if _e938 {
                                                            if _e938 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e940 = global_10.member[_e937];
                                                            phi_2132_ = _e940;
                                                        } else {
                                                            phi_2132_ = 0u;
                                                        }
                                                        let _e942 = phi_2132_;
                                                        let _e946 = (_e935 + _e430);
                                                        let _e947 = (_e946 < _e112);
                                                        if _e947 {
                                                            if _e947 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e949 = global_10.member[_e946];
                                                            phi_2150_ = _e949;
                                                        } else {
                                                            phi_2150_ = 0u;
                                                        }
                                                        let _e951 = phi_2150_;
                                                        let _e955 = (_e935 + _e432);
                                                        let _e956 = (_e955 < _e112);
                                                        if _e956 {
                                                            if _e956 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e958 = global_10.member[_e955];
                                                            phi_2168_ = _e958;
                                                        } else {
                                                            phi_2168_ = 0u;
                                                        }
                                                        let _e960 = phi_2168_;
                                                        let _e965 = (_e935 + 3u);
                                                        let _e966 = (_e965 + _e431);
                                                        let _e967 = (_e966 < _e112);
                                                        if _e967 {
                                                            if _e967 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e969 = global_10.member[_e966];
                                                            phi_2191_ = _e969;
                                                        } else {
                                                            phi_2191_ = 0u;
                                                        }
                                                        let _e971 = phi_2191_;
                                                        let _e975 = (_e965 + _e430);
                                                        let _e976 = (_e975 < _e112);
                                                        if _e976 {
                                                            if _e976 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e978 = global_10.member[_e975];
                                                            phi_2209_ = _e978;
                                                        } else {
                                                            phi_2209_ = 0u;
                                                        }
                                                        let _e980 = phi_2209_;
                                                        let _e984 = (_e965 + _e432);
                                                        let _e985 = (_e984 < _e112);
                                                        if _e985 {
                                                            if _e985 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e987 = global_10.member[_e984];
                                                            phi_2227_ = _e987;
                                                        } else {
                                                            phi_2227_ = 0u;
                                                        }
                                                        let _e989 = phi_2227_;
                                                        let _e994 = (_e935 + 6u);
                                                        let _e995 = (_e994 + _e431);
                                                        let _e996 = (_e995 < _e112);
                                                        if _e996 {
                                                            if _e996 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e998 = global_10.member[_e995];
                                                            phi_2250_ = _e998;
                                                        } else {
                                                            phi_2250_ = 0u;
                                                        }
                                                        let _e1000 = phi_2250_;
                                                        let _e1004 = (_e994 + _e430);
                                                        let _e1005 = (_e1004 < _e112);
                                                        if _e1005 {
                                                            if _e1005 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1007 = global_10.member[_e1004];
                                                            phi_2268_ = _e1007;
                                                        } else {
                                                            phi_2268_ = 0u;
                                                        }
                                                        let _e1009 = phi_2268_;
                                                        let _e1013 = (_e994 + _e432);
                                                        let _e1014 = (_e1013 < _e112);
                                                        if _e1014 {
                                                            if _e1014 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1016 = global_10.member[_e1013];
                                                            phi_2286_ = _e1016;
                                                        } else {
                                                            phi_2286_ = 0u;
                                                        }
                                                        let _e1018 = phi_2286_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e942)) * _e168), (f32(bitcast<i32>(_e951)) * _e168), (f32(bitcast<i32>(_e960)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e971)) * _e168), (f32(bitcast<i32>(_e980)) * _e168), (f32(bitcast<i32>(_e989)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1000)) * _e168), (f32(bitcast<i32>(_e1009)) * _e168), (f32(bitcast<i32>(_e1018)) * _e168)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2292_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1310 = phi_2292_;
                                                let _e1318 = (_e1310[0][2] - _e611);
                                                let _e1321 = (((_e1310[0][0] - _e478) * _e650) - (_e1318 * _e518));
                                                let _e1324 = (((_e1310[0][1] - _e545) * _e650) - (_e1318 * _e584));
                                                let _e1331 = (_e1310[1][2] - _e611);
                                                let _e1334 = (((_e1310[1][0] - _e478) * _e650) - (_e1331 * _e518));
                                                let _e1337 = (((_e1310[1][1] - _e545) * _e650) - (_e1331 * _e584));
                                                let _e1344 = (_e1310[2][2] - _e611);
                                                let _e1347 = (((_e1310[2][0] - _e478) * _e650) - (_e1344 * _e518));
                                                let _e1350 = (((_e1310[2][1] - _e545) * _e650) - (_e1344 * _e584));
                                                let _e1351 = (_e1347 * _e1337);
                                                let _e1352 = (_e1350 * _e1334);
                                                let _e1353 = (_e1321 * _e1350);
                                                let _e1354 = (_e1324 * _e1347);
                                                let _e1355 = (_e1334 * _e1324);
                                                let _e1356 = (_e1337 * _e1321);
                                                let _e1361 = (((_e1351 >= _e1352) && (_e1353 >= _e1354)) && (_e1355 >= _e1356));
                                                if (_e1361 || (((_e1351 <= _e1352) && (_e1353 <= _e1354)) && (_e1355 <= _e1356))) {
                                                    let _e1368 = select(-1f, 1f, _e1361);
                                                    let _e1370 = ((_e1351 - _e1352) * _e1368);
                                                    let _e1372 = select(0f, _e1370, (_e1370 > 0f));
                                                    let _e1374 = ((_e1353 - _e1354) * _e1368);
                                                    let _e1376 = select(0f, _e1374, (_e1374 > 0f));
                                                    let _e1378 = ((_e1355 - _e1356) * _e1368);
                                                    let _e1380 = select(0f, _e1378, (_e1378 > 0f));
                                                    let _e1382 = ((_e1372 + _e1376) + _e1380);
                                                    if (_e1382 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3176_ = type_25();
                                                        phi_3177_ = true;
                                                        phi_3178_ = false;
                                                    } else {
                                                        let _e1385 = select(_e1334, _e1321, (_e1321 < _e1334));
                                                        if (select(_e1347, _e1385, (_e1385 < _e1347)) > 0f) {
                                                            phi_2444_ = true;
                                                        } else {
                                                            let _e1390 = select(_e1334, _e1321, (_e1321 > _e1334));
                                                            phi_2444_ = (select(_e1347, _e1390, (_e1390 > _e1347)) < 0f);
                                                        }
                                                        let _e1395 = phi_2444_;
                                                        if _e1395 {
                                                            phi_3173_ = type_25();
                                                            phi_3174_ = true;
                                                            phi_3175_ = false;
                                                        } else {
                                                            let _e1397 = select(_e1337, _e1324, (_e1324 < _e1337));
                                                            if (select(_e1350, _e1397, (_e1397 < _e1350)) > 0f) {
                                                                phi_2473_ = true;
                                                            } else {
                                                                let _e1402 = select(_e1337, _e1324, (_e1324 > _e1337));
                                                                phi_2473_ = (select(_e1350, _e1402, (_e1402 > _e1350)) < 0f);
                                                            }
                                                            let _e1407 = phi_2473_;
                                                            if _e1407 {
                                                                phi_3171_ = type_25();
                                                                phi_3172_ = false;
                                                            } else {
                                                                let _e1409 = select(_e1310[1][0], _e1310[0][0], (_e1310[0][0] < _e1310[1][0]));
                                                                let _e1413 = select(_e1310[1][0], _e1310[0][0], (_e1310[0][0] > _e1310[1][0]));
                                                                let _e1417 = select(_e1310[1][1], _e1310[0][1], (_e1310[0][1] < _e1310[1][1]));
                                                                let _e1421 = select(_e1310[1][1], _e1310[0][1], (_e1310[0][1] > _e1310[1][1]));
                                                                let _e1425 = select(_e1310[1][2], _e1310[0][2], (_e1310[0][2] < _e1310[1][2]));
                                                                let _e1429 = select(_e1310[1][2], _e1310[0][2], (_e1310[0][2] > _e1310[1][2]));
                                                                let _e1434 = ((select(_e1310[2][0], _e1409, (_e1409 < _e1310[2][0])) - _e516) * _e521);
                                                                let _e1435 = ((select(_e1310[2][0], _e1413, (_e1413 > _e1310[2][0])) - _e517) * _e521);
                                                                let _e1438 = ((select(_e1310[2][1], _e1417, (_e1417 < _e1310[2][1])) - _e582) * _e587);
                                                                let _e1439 = ((select(_e1310[2][1], _e1421, (_e1421 > _e1310[2][1])) - _e583) * _e587);
                                                                let _e1442 = ((select(_e1310[2][2], _e1425, (_e1425 < _e1310[2][2])) - _e648) * _e653);
                                                                let _e1443 = ((select(_e1310[2][2], _e1429, (_e1429 > _e1310[2][2])) - _e649) * _e653);
                                                                let _e1445 = select(_e1443, _e1442, (_e1442 < _e1443));
                                                                let _e1447 = select(_e1443, _e1442, (_e1442 > _e1443));
                                                                let _e1449 = select(_e1435, _e1434, (_e1434 < _e1435));
                                                                let _e1451 = select(_e1439, _e1438, (_e1438 < _e1439));
                                                                let _e1453 = select(_e1451, _e1449, (_e1449 > _e1451));
                                                                let _e1455 = select(_e1445, _e1453, (_e1453 > _e1445));
                                                                let _e1457 = select(_e1435, _e1434, (_e1434 > _e1435));
                                                                let _e1459 = select(_e1439, _e1438, (_e1438 > _e1439));
                                                                let _e1461 = select(_e1459, _e1457, (_e1457 < _e1459));
                                                                let _e1463 = select(_e1447, _e1461, (_e1461 < _e1447));
                                                                let _e1464 = -(_e1445);
                                                                let _e1470 = select(_e764, _e1455, (_e1455 > _e764));
                                                                if (_e1470 > (_e1463 + (select(_e1464, _e1447, (_e1447 > _e1464)) * 0.0000019073523f))) {
                                                                    phi_3166_ = type_25();
                                                                    phi_3167_ = true;
                                                                } else {
                                                                    let _e1472 = (_e1470 > _e863.member_1);
                                                                    if _e1472 {
                                                                        phi_3165_ = type_25();
                                                                    } else {
                                                                        let _e1473 = vec3<f32>(_e1310[0][0], _e1310[0][1], _e1310[0][2]);
                                                                        let _e1474 = vec3<f32>(_e1310[1][0], _e1310[1][1], _e1310[1][2]);
                                                                        let _e1475 = vec3<f32>(_e1310[2][0], _e1310[2][1], _e1310[2][2]);
                                                                        let _e1476 = (_e1310[1][0] - _e1310[0][0]);
                                                                        let _e1477 = (_e1310[1][1] - _e1310[0][1]);
                                                                        let _e1478 = (_e1310[1][2] - _e1310[0][2]);
                                                                        let _e1479 = vec3<f32>(_e1476, _e1477, _e1478);
                                                                        let _e1480 = (_e1310[2][0] - _e1310[1][0]);
                                                                        let _e1481 = (_e1310[2][1] - _e1310[1][1]);
                                                                        let _e1482 = (_e1310[2][2] - _e1310[1][2]);
                                                                        let _e1483 = vec3<f32>(_e1480, _e1481, _e1482);
                                                                        let _e1484 = (_e1310[0][0] - _e1310[2][0]);
                                                                        let _e1485 = (_e1310[0][1] - _e1310[2][1]);
                                                                        let _e1486 = (_e1310[0][2] - _e1310[2][2]);
                                                                        let _e1487 = vec3<f32>(_e1484, _e1485, _e1486);
                                                                        let _e1490 = bitcast<f32>((bitcast<u32>(_e1476) & 2147483647u));
                                                                        let _e1493 = bitcast<f32>((bitcast<u32>(_e1477) & 2147483647u));
                                                                        let _e1495 = select(_e1493, _e1490, (_e1490 > _e1493));
                                                                        let _e1498 = bitcast<f32>((bitcast<u32>(_e1478) & 2147483647u));
                                                                        let _e1500 = select(_e1498, _e1495, (_e1495 > _e1498));
                                                                        let _e1503 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                        let _e1506 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1508 = select(_e1506, _e1503, (_e1503 > _e1506));
                                                                        let _e1511 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                        let _e1513 = select(_e1511, _e1508, (_e1508 > _e1511));
                                                                        let _e1516 = bitcast<f32>((bitcast<u32>(_e1484) & 2147483647u));
                                                                        let _e1519 = bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u));
                                                                        let _e1521 = select(_e1519, _e1516, (_e1516 > _e1519));
                                                                        let _e1524 = bitcast<f32>((bitcast<u32>(_e1486) & 2147483647u));
                                                                        let _e1526 = select(_e1524, _e1521, (_e1521 > _e1524));
                                                                        let _e1528 = select(_e1513, _e1500, (_e1500 > _e1513));
                                                                        let _e1530 = select(_e1526, _e1528, (_e1528 > _e1526));
                                                                        if (_e1500 == _e1530) {
                                                                            phi_2892_ = _e1337;
                                                                            phi_2893_ = _e1334;
                                                                            phi_2894_ = _e1324;
                                                                            phi_2895_ = _e1321;
                                                                            phi_2896_ = _e1473;
                                                                            phi_2897_ = _e1487;
                                                                            phi_2898_ = _e1483;
                                                                            phi_2899_ = _e1479;
                                                                        } else {
                                                                            let _e1532 = (_e1513 == _e1530);
                                                                            let _e1537 = vec3(_e1532);
                                                                            phi_2892_ = select(_e1324, _e1350, _e1532);
                                                                            phi_2893_ = select(_e1321, _e1347, _e1532);
                                                                            phi_2894_ = select(_e1350, _e1337, _e1532);
                                                                            phi_2895_ = select(_e1347, _e1334, _e1532);
                                                                            phi_2896_ = select(_e1475, _e1474, _e1537);
                                                                            phi_2897_ = select(_e1483, _e1479, _e1537);
                                                                            phi_2898_ = select(_e1479, _e1487, _e1537);
                                                                            phi_2899_ = select(_e1487, _e1483, _e1537);
                                                                        }
                                                                        let _e1543 = phi_2892_;
                                                                        let _e1545 = phi_2893_;
                                                                        let _e1547 = phi_2894_;
                                                                        let _e1549 = phi_2895_;
                                                                        let _e1551 = phi_2896_;
                                                                        let _e1553 = phi_2897_;
                                                                        let _e1555 = phi_2898_;
                                                                        let _e1557 = phi_2899_;
                                                                        let _e1564 = ((_e1555.y * _e1553.z) - (_e1553.y * _e1555.z));
                                                                        let _e1569 = ((_e1555.z * _e1553.x) - (_e1553.z * _e1555.x));
                                                                        let _e1572 = ((_e1555.x * _e1553.y) - (_e1553.x * _e1555.y));
                                                                        if (_e1372 >= _e1376) {
                                                                            phi_2936_ = select(true, false, (_e1372 >= _e1380));
                                                                        } else {
                                                                            phi_2936_ = true;
                                                                        }
                                                                        let _e1577 = phi_2936_;
                                                                        if _e1577 {
                                                                            phi_2945_ = select(_e1475, _e1474, vec3((_e1376 >= _e1380)));
                                                                        } else {
                                                                            phi_2945_ = _e1473;
                                                                        }
                                                                        let _e1582 = phi_2945_;
                                                                        let _e1593 = (((_e1564 * (_e1582.x - _e478)) + (_e1569 * (_e1582.y - _e545))) + (_e1572 * (_e1582.z - _e611)));
                                                                        let _e1598 = (((_e1564 * _e518) + (_e1569 * _e584)) + (_e1572 * _e650));
                                                                        let _e1599 = (_e1545 - _e1549);
                                                                        let _e1600 = (_e1543 - _e1547);
                                                                        let _e1608 = (-(((_e1549 * _e1599) + (_e1547 * _e1600))) / ((_e1599 * _e1599) + (_e1600 * _e1600)));
                                                                        let _e1610 = select(1f, _e1608, (_e1608 < 1f));
                                                                        let _e1612 = select(0f, _e1610, (_e1610 > 0f));
                                                                        let _e1625 = ((_e1551.x + (_e1557.x * _e1612)) - _e478);
                                                                        let _e1626 = ((_e1551.y + (_e1557.y * _e1612)) - _e545);
                                                                        let _e1627 = ((_e1551.z + (_e1557.z * _e1612)) - _e611);
                                                                        let _e1628 = (_e1627 / _e650);
                                                                        let _e1640 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                        let _e1643 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                        let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                        let _e1648 = bitcast<f32>((bitcast<u32>(_e1627) & 2147483647u));
                                                                        let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                        let _e1656 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                                        let _e1659 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                        let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                        let _e1664 = bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1564 * _e1625) + (_e1569 * _e1626)) + (_e1572 * _e1627)) - _e1593)) & 2147483647u)) <= ((0.0000009536743f * select(_e1530, _e1650, (_e1650 > _e1530))) * select(_e1664, _e1661, (_e1661 > _e1664)))) {
                                                                            let _e1674 = bitcast<f32>((bitcast<u32>(_e1555.x) & 2147483647u));
                                                                            let _e1677 = bitcast<f32>((bitcast<u32>(_e1555.y) & 2147483647u));
                                                                            let _e1679 = select(_e1677, _e1674, (_e1674 > _e1677));
                                                                            let _e1682 = bitcast<f32>((bitcast<u32>(_e1555.z) & 2147483647u));
                                                                            let _e1688 = bitcast<f32>((bitcast<u32>(_e1553.x) & 2147483647u));
                                                                            let _e1691 = bitcast<f32>((bitcast<u32>(_e1553.y) & 2147483647u));
                                                                            let _e1693 = select(_e1691, _e1688, (_e1688 > _e1691));
                                                                            let _e1696 = bitcast<f32>((bitcast<u32>(_e1553.z) & 2147483647u));
                                                                            let _e1700 = (bitcast<f32>((bitcast<u32>(_e1598) & 2147483647u)) > ((0.0000038146973f * select(_e1682, _e1679, (_e1679 > _e1682))) * select(_e1696, _e1693, (_e1693 > _e1696))));
                                                                            if _e1700 {
                                                                                phi_3110_ = (_e1593 / _e1598);
                                                                            } else {
                                                                                phi_3110_ = f32();
                                                                            }
                                                                            let _e1703 = phi_3110_;
                                                                            phi_3112_ = _e1703;
                                                                            phi_3113_ = select(true, false, _e1700);
                                                                        } else {
                                                                            phi_3112_ = f32();
                                                                            phi_3113_ = true;
                                                                        }
                                                                        let _e1706 = phi_3112_;
                                                                        let _e1708 = phi_3113_;
                                                                        if _e1708 {
                                                                            let _e1716 = (((_e1564 * (_e1625 - (_e518 * _e1628))) + (_e1569 * (_e1626 - (_e584 * _e1628)))) / _e1598);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u)) <= _e1530) {
                                                                                phi_3133_ = (_e1628 + _e1716);
                                                                            } else {
                                                                                phi_3133_ = _e1628;
                                                                            }
                                                                            let _e1723 = phi_3133_;
                                                                            phi_3134_ = _e1723;
                                                                        } else {
                                                                            phi_3134_ = _e1706;
                                                                        }
                                                                        let _e1725 = phi_3134_;
                                                                        let _e1727 = select(_e1463, _e1725, (_e1725 < _e1463));
                                                                        let _e1729 = select(_e1455, _e1727, (_e1727 > _e1455));
                                                                        if (_e1729 >= _e764) {
                                                                            let _e1731 = (_e1729 <= _e863.member_1);
                                                                            if _e1731 {
                                                                                let _e1732 = (1f / _e1382);
                                                                                phi_3157_ = type_25(_e1729, (_e1376 * _e1732), (_e1380 * _e1732), _e923);
                                                                            } else {
                                                                                phi_3157_ = type_25();
                                                                            }
                                                                            let _e1737 = phi_3157_;
                                                                            phi_3159_ = _e1737;
                                                                            phi_3160_ = select(true, false, _e1731);
                                                                        } else {
                                                                            phi_3159_ = type_25();
                                                                            phi_3160_ = true;
                                                                        }
                                                                        let _e1740 = phi_3159_;
                                                                        let _e1742 = phi_3160_;
                                                                        if _e1742 {
                                                                            phi_3164_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_3164_ = _e1740;
                                                                        }
                                                                        let _e1744 = phi_3164_;
                                                                        phi_3165_ = _e1744;
                                                                    }
                                                                    let _e1746 = phi_3165_;
                                                                    phi_3166_ = _e1746;
                                                                    phi_3167_ = _e1472;
                                                                }
                                                                let _e1748 = phi_3166_;
                                                                let _e1750 = phi_3167_;
                                                                phi_3171_ = _e1748;
                                                                phi_3172_ = _e1750;
                                                            }
                                                            let _e1752 = phi_3171_;
                                                            let _e1754 = phi_3172_;
                                                            phi_3173_ = _e1752;
                                                            phi_3174_ = _e1407;
                                                            phi_3175_ = _e1754;
                                                        }
                                                        let _e1756 = phi_3173_;
                                                        let _e1758 = phi_3174_;
                                                        let _e1760 = phi_3175_;
                                                        phi_3176_ = _e1756;
                                                        phi_3177_ = _e1758;
                                                        phi_3178_ = _e1760;
                                                    }
                                                    let _e1762 = phi_3176_;
                                                    let _e1764 = phi_3177_;
                                                    let _e1766 = phi_3178_;
                                                    phi_3186_ = _e1762;
                                                    phi_3187_ = select(_e1766, true, _e1764);
                                                } else {
                                                    phi_3186_ = type_25();
                                                    phi_3187_ = true;
                                                }
                                                let _e1769 = phi_3186_;
                                                let _e1771 = phi_3187_;
                                                if _e1771 {
                                                    phi_3191_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3191_ = _e1769;
                                                }
                                                let _e1773 = phi_3191_;
                                                if (_e1773.member_3 != 4294967295u) {
                                                    if (_e923 == _e177) {
                                                        phi_3526_ = false;
                                                    } else {
                                                        let _e1777 = (_e923 < arrayLength((&global_5.member)));
                                                        if _e1777 {
                                                            if _e1777 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1779 = global_5.member[_e923];
                                                            phi_3214_ = _e1779;
                                                        } else {
                                                            phi_3214_ = 4294967295u;
                                                        }
                                                        let _e1781 = phi_3214_;
                                                        let _e1782 = (_e1781 < arrayLength((&global_6.member)));
                                                        if _e1782 {
                                                            if _e1782 {
                                                            } else {
                                                                phi_5274_ = true;
                                                                break;
                                                            }
                                                            let _e1784 = global_6.member[_e1781];
                                                            phi_3228_ = _e1784;
                                                        } else {
                                                            phi_3228_ = 0i;
                                                        }
                                                        let _e1786 = phi_3228_;
                                                        let _e1787 = (_e1786 == 0i);
                                                        if _e1787 {
                                                            phi_3525_ = true;
                                                        } else {
                                                            if _e455 {
                                                                phi_3251_ = vec3<f32>(_e1310[0][0], _e1310[0][1], _e1310[0][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3250_ = vec3<f32>(_e1310[0][2], _e1310[0][0], _e1310[0][1]);
                                                                } else {
                                                                    phi_3250_ = vec3<f32>(_e1310[0][1], _e1310[0][2], _e1310[0][0]);
                                                                }
                                                                let _e1792 = phi_3250_;
                                                                phi_3251_ = _e1792;
                                                            }
                                                            let _e1795 = phi_3251_;
                                                            if _e455 {
                                                                phi_3270_ = vec3<f32>(_e1310[1][0], _e1310[1][1], _e1310[1][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3269_ = vec3<f32>(_e1310[1][2], _e1310[1][0], _e1310[1][1]);
                                                                } else {
                                                                    phi_3269_ = vec3<f32>(_e1310[1][1], _e1310[1][2], _e1310[1][0]);
                                                                }
                                                                let _e1800 = phi_3269_;
                                                                phi_3270_ = _e1800;
                                                            }
                                                            let _e1803 = phi_3270_;
                                                            if _e455 {
                                                                phi_3289_ = vec3<f32>(_e1310[2][0], _e1310[2][1], _e1310[2][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3288_ = vec3<f32>(_e1310[2][2], _e1310[2][0], _e1310[2][1]);
                                                                } else {
                                                                    phi_3288_ = vec3<f32>(_e1310[2][1], _e1310[2][2], _e1310[2][0]);
                                                                }
                                                                let _e1808 = phi_3288_;
                                                                phi_3289_ = _e1808;
                                                            }
                                                            let _e1811 = phi_3289_;
                                                            let _e1814 = (_e1803.x - _e1795.x);
                                                            let _e1817 = (_e1803.y - _e1795.y);
                                                            let _e1820 = (_e1803.z - _e1795.z);
                                                            let _e1822 = (_e1811.x - _e1795.x);
                                                            let _e1824 = (_e1811.y - _e1795.y);
                                                            let _e1826 = (_e1811.z - _e1795.z);
                                                            if (_e309.member_1 == 1u) {
                                                                phi_3325_ = (vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]) - _e1795);
                                                            } else {
                                                                phi_3325_ = vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]);
                                                            }
                                                            let _e1841 = phi_3325_;
                                                            let _e1847 = bitcast<f32>((bitcast<u32>((_e1814 * _e1824)) ^ _e309.member_3[0]));
                                                            let _e1851 = bitcast<f32>((bitcast<u32>((_e1817 * _e1822)) ^ _e309.member_3[0]));
                                                            let _e1855 = bitcast<f32>((bitcast<u32>((_e1817 * _e1826)) ^ _e309.member_3[0]));
                                                            let _e1859 = bitcast<f32>((bitcast<u32>((_e1820 * _e1824)) ^ _e309.member_3[0]));
                                                            let _e1863 = bitcast<f32>((bitcast<u32>((_e1820 * _e1822)) ^ _e309.member_3[0]));
                                                            let _e1867 = bitcast<f32>((bitcast<u32>((_e1814 * _e1826)) ^ _e309.member_3[0]));
                                                            let _e1868 = (_e1855 - _e1859);
                                                            let _e1869 = (_e1863 - _e1867);
                                                            let _e1870 = (_e1847 - _e1851);
                                                            let _e1894 = (bitcast<f32>((bitcast<u32>(_e1855) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1859) & 2147483647u)));
                                                            let _e1901 = (bitcast<f32>((bitcast<u32>(_e1863) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1867) & 2147483647u)));
                                                            let _e1908 = (bitcast<f32>((bitcast<u32>(_e1847) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1851) & 2147483647u)));
                                                            if (_e309.member_2 == 0f) {
                                                                phi_3507_ = 0f;
                                                            } else {
                                                                let _e1938 = bitcast<f32>((bitcast<u32>(_e1868) & 2147483647u));
                                                                let _e1941 = bitcast<f32>((bitcast<u32>(_e1869) & 2147483647u));
                                                                let _e1944 = bitcast<f32>((bitcast<u32>(_e1870) & 2147483647u));
                                                                let _e1946 = select(_e1944, _e1941, (_e1941 > _e1944));
                                                                let _e1950 = select(_e1944, _e1941, (_e1941 < _e1944));
                                                                let _e1954 = select(_e1941, _e1938, (_e1938 < _e1941));
                                                                let _e1956 = select(_e1941, _e1938, (_e1938 > _e1941));
                                                                let _e1958 = select(_e1944, _e1956, (_e1956 < _e1944));
                                                                phi_3507_ = bitcast<f32>((bitcast<u32>((_e309.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1946, _e1938, (_e1938 > _e1946)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1958, _e1954, (_e1954 > _e1958)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1950, _e1938, (_e1938 < _e1950)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1894 + _e1901) + _e1908))) ^ _e309.member_3[0]))) * 1.0000005f)) ^ _e309.member_3[0])))) ^ _e309.member_3[0]));
                                                            }
                                                            let _e1985 = phi_3507_;
                                                            phi_3525_ = (_e1787 || !(((((bitcast<f32>((bitcast<u32>((_e1841.x * _e1868)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1841.y * _e1869)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1841.z * _e1870)) ^ _e309.member_3[0]))) * f32(-(_e1786))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1841.x) & 2147483647u)) * _e1894)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1841.y) & 2147483647u)) * _e1901)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1841.z) & 2147483647u)) * _e1908)) ^ _e309.member_3[0]))))) ^ _e309.member_3[0])) + _e1985) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1999 = phi_3525_;
                                                        phi_3526_ = _e1999;
                                                    }
                                                    let _e2001 = phi_3526_;
                                                    if _e2001 {
                                                        if (_e1773.member < _e863.member.member) {
                                                            phi_3546_ = true;
                                                        } else {
                                                            if (_e1773.member == _e863.member.member) {
                                                                phi_3545_ = (_e1773.member_3 < _e863.member.member_3);
                                                            } else {
                                                                phi_3545_ = false;
                                                            }
                                                            let _e2011 = phi_3545_;
                                                            phi_3546_ = _e2011;
                                                        }
                                                        let _e2013 = phi_3546_;
                                                        if _e2013 {
                                                            phi_3552_ = type_43(_e1773, _e1773.member);
                                                        } else {
                                                            phi_3552_ = _e863;
                                                        }
                                                        let _e2016 = phi_3552_;
                                                        phi_3553_ = _e2016;
                                                    } else {
                                                        phi_3553_ = _e863;
                                                    }
                                                    let _e2018 = phi_3553_;
                                                    phi_3554_ = _e2018;
                                                } else {
                                                    phi_3554_ = _e863;
                                                }
                                                let _e2020 = phi_3554_;
                                                phi_1529_ = _e2020;
                                            } else {
                                                phi_1529_ = type_43();
                                            }
                                            let _e2022 = phi_1529_;
                                            continue;
                                            continuing {
                                                phi_1528_ = _e2022;
                                                phi_1531_ = _e878;
                                                phi_5274_ = _e806;
                                                break if !(_e884);
                                            }
                                        }
                                        let _e2025 = phi_5274_;
                                        phi_5513_ = _e2025;
                                        if _e2025 {
                                            break;
                                        }
                                        phi_5604_ = _e2025;
                                        let _e2834 = local_11;
                                        phi_3555_ = _e2834;
                                    } else {
                                        phi_5604_ = _e806;
                                        phi_3555_ = _e808;
                                    }
                                    let _e2027 = phi_5604_;
                                    let _e2029 = phi_3555_;
                                    if _e855 {
                                        phi_4820_ = bool();
                                        phi_4821_ = u32();
                                        phi_4822_ = type_57();
                                    } else {
                                        if (_e851.member_1 >= _e109) {
                                            phi_4356_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e851.member_1 < _e109) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2033 = ((1u + _e431) % 4u);
                                            if (_e2033 < 4u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2038 = global_4.member[_e851.member_1][_e2033];
                                            let _e2040 = (_e2038 >> bitcast<u32>(11u));
                                            let _e2042 = ((1u + _e430) % 4u);
                                            if (_e2042 < 4u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2047 = global_4.member[_e851.member_1][_e2042];
                                            let _e2049 = (_e2047 >> bitcast<u32>(11u));
                                            let _e2051 = ((1u + _e432) % 4u);
                                            if (_e2051 < 4u) {
                                            } else {
                                                phi_5513_ = true;
                                                break;
                                            }
                                            let _e2056 = global_4.member[_e851.member_1][_e2051];
                                            let _e2058 = (_e2056 >> bitcast<u32>(11u));
                                            let _e2081 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.x - _e851.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e2082 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.y - _e851.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e2083 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.z - _e851.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e2085 = select(_e168, _e2081, (_e2081 > _e168));
                                            let _e2087 = select(_e168, _e2082, (_e2082 > _e168));
                                            let _e2089 = select(_e168, _e2083, (_e2083 > _e168));
                                            let _e2120 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2038 & 1023u))) - 8388608f) * _e2085));
                                            let _e2125 = (bitcast<i32>((_e2038 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2128 = bitcast<f32>((_e2120 & bitcast<u32>(_e2125)));
                                            let _e2129 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2047 & 1023u))) - 8388608f) * _e2087));
                                            let _e2134 = (bitcast<i32>((_e2047 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2137 = bitcast<f32>((_e2129 & bitcast<u32>(_e2134)));
                                            let _e2138 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2056 & 1023u))) - 8388608f) * _e2089));
                                            let _e2143 = (bitcast<i32>((_e2056 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2146 = bitcast<f32>((_e2138 & bitcast<u32>(_e2143)));
                                            let _e2150 = bitcast<f32>((_e2120 & bitcast<u32>(~(_e2125))));
                                            let _e2154 = bitcast<f32>((_e2129 & bitcast<u32>(~(_e2134))));
                                            let _e2158 = bitcast<f32>((_e2138 & bitcast<u32>(~(_e2143))));
                                            let _e2159 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2040 & 1023u))) - 8388608f) * _e2085));
                                            let _e2164 = (bitcast<i32>((_e2040 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2167 = bitcast<f32>((_e2159 & bitcast<u32>(_e2164)));
                                            let _e2168 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2049 & 1023u))) - 8388608f) * _e2087));
                                            let _e2173 = (bitcast<i32>((_e2049 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2176 = bitcast<f32>((_e2168 & bitcast<u32>(_e2173)));
                                            let _e2177 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2058 & 1023u))) - 8388608f) * _e2089));
                                            let _e2182 = (bitcast<i32>((_e2058 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2185 = bitcast<f32>((_e2177 & bitcast<u32>(_e2182)));
                                            let _e2189 = bitcast<f32>((_e2159 & bitcast<u32>(~(_e2164))));
                                            let _e2193 = bitcast<f32>((_e2168 & bitcast<u32>(~(_e2173))));
                                            let _e2197 = bitcast<f32>((_e2177 & bitcast<u32>(~(_e2182))));
                                            let _e2198 = (_e851.member.member.x + _e2128);
                                            let _e2199 = (_e851.member.member.y + _e2137);
                                            let _e2200 = (_e851.member.member.z + _e2146);
                                            let _e2203 = (_e851.member.member_1.x - _e2167);
                                            let _e2204 = (_e851.member.member_1.y - _e2176);
                                            let _e2205 = (_e851.member.member_1.z - _e2185);
                                            let _e2224 = (_e2203 - _e2198);
                                            let _e2225 = (_e2204 - _e2199);
                                            let _e2226 = (_e2205 - _e2200);
                                            let _e2228 = select(_e2225, _e2224, (_e2224 > _e2225));
                                            let _e2230 = select(_e2226, _e2228, (_e2228 > _e2226));
                                            if (_e2230 < (1024f * _e168)) {
                                                phi_4057_ = 0u;
                                            } else {
                                                phi_4057_ = select(2u, 1u, (_e2230 < (2097152f * _e168)));
                                            }
                                            let _e2237 = phi_4057_;
                                            switch bitcast<i32>(_e2237) {
                                                case 0: {
                                                    phi_4063_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_4063_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_4063_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_4063_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e2240 = phi_4063_;
                                            let _e2246 = global_4.member[_e851.member_1][0u];
                                            let _e2250 = global_4.member[_e851.member_1][1u];
                                            let _e2254 = global_4.member[_e851.member_1][2u];
                                            let _e2258 = global_4.member[_e851.member_1][3u];
                                            let _e2270 = (((_e2250 >> bitcast<u32>(22i)) | ((_e2254 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2258 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e2271 = (_e2246 & 268435455u);
                                            let _e2272 = (_e2270 & 268435455u);
                                            let _e2275 = ((_e2246 >> bitcast<u32>(28u)) & 7u);
                                            let _e2283 = ((_e2246 >> bitcast<u32>(31i)) | (((_e2270 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e2284 = (_e2275 != 0u);
                                            if (_e2275 == 0u) {
                                                phi_4318_ = _e2271;
                                            } else {
                                                if (_e2275 == 7u) {
                                                    phi_4317_ = 2147483648u;
                                                } else {
                                                    phi_4317_ = ((2147483648u | (_e2275 << bitcast<u32>(28u))) | (_e2272 & 268435455u));
                                                }
                                                let _e2293 = phi_4317_;
                                                phi_4318_ = _e2293;
                                            }
                                            let _e2295 = phi_4318_;
                                            if _e2284 {
                                                let _e2296 = (_e2275 != 7u);
                                                if _e2296 {
                                                    phi_4328_ = (_e2272 + (_e2275 * ((3u * _e2240) + 1u)));
                                                } else {
                                                    phi_4328_ = u32();
                                                }
                                                let _e2300 = phi_4328_;
                                                phi_4330_ = _e2300;
                                                phi_4331_ = select(true, false, _e2296);
                                            } else {
                                                phi_4330_ = u32();
                                                phi_4331_ = true;
                                            }
                                            let _e2303 = phi_4330_;
                                            let _e2305 = phi_4331_;
                                            if (_e2283 == 0u) {
                                                phi_4352_ = (_e2271 + select(0u, 1u, !(_e2284)));
                                            } else {
                                                if (_e2283 == 7u) {
                                                    phi_4351_ = 2147483648u;
                                                } else {
                                                    phi_4351_ = ((2147483648u | (_e2283 << bitcast<u32>(28u))) | (select(_e2303, _e2272, _e2305) & 268435455u));
                                                }
                                                let _e2318 = phi_4351_;
                                                phi_4352_ = _e2318;
                                            }
                                            let _e2320 = phi_4352_;
                                            phi_4356_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e2198, (_e851.member.member.x + _e2150), _e2203, (_e851.member.member_1.x - _e2189)), vec4<f32>(_e2199, (_e851.member.member.y + _e2154), _e2204, (_e851.member.member_1.y - _e2193)), vec4<f32>(_e2200, (_e851.member.member.z + _e2158), _e2205, (_e851.member.member_1.z - _e2197))), type_57(type_37((_e851.member.member + vec4<f32>(_e2128, _e2137, _e2146, 0f)), (_e851.member.member_1 - vec4<f32>(_e2167, _e2176, _e2185, 0f))), _e2295), type_57(type_37((_e851.member.member + vec4<f32>(_e2150, _e2154, _e2158, 0f)), (_e851.member.member_1 - vec4<f32>(_e2189, _e2193, _e2197, 0f))), _e2320));
                                        }
                                        let _e2325 = phi_4356_;
                                        let _e2337 = ((_e2325.member[0].x - _e516) * _e521);
                                        let _e2338 = ((_e2325.member[0].y - _e516) * _e521);
                                        let _e2339 = ((_e2325.member[0].z - _e517) * _e521);
                                        let _e2340 = ((_e2325.member[0].w - _e517) * _e521);
                                        let _e2350 = ((_e2325.member[1].x - _e582) * _e587);
                                        let _e2351 = ((_e2325.member[1].y - _e582) * _e587);
                                        let _e2352 = ((_e2325.member[1].z - _e583) * _e587);
                                        let _e2353 = ((_e2325.member[1].w - _e583) * _e587);
                                        let _e2363 = ((_e2325.member[2].x - _e648) * _e653);
                                        let _e2364 = ((_e2325.member[2].y - _e648) * _e653);
                                        let _e2365 = ((_e2325.member[2].z - _e649) * _e653);
                                        let _e2366 = ((_e2325.member[2].w - _e649) * _e653);
                                        let _e2368 = select(_e2365, _e2363, (_e2363 < _e2365));
                                        let _e2370 = select(_e2366, _e2364, (_e2364 < _e2366));
                                        let _e2372 = select(_e2365, _e2363, (_e2363 > _e2365));
                                        let _e2374 = select(_e2366, _e2364, (_e2364 > _e2366));
                                        let _e2376 = select(_e2339, _e2337, (_e2337 < _e2339));
                                        let _e2378 = select(_e2340, _e2338, (_e2338 < _e2340));
                                        let _e2380 = select(_e2352, _e2350, (_e2350 < _e2352));
                                        let _e2382 = select(_e2353, _e2351, (_e2351 < _e2353));
                                        let _e2384 = select(_e2380, _e2376, (_e2376 > _e2380));
                                        let _e2386 = select(_e2382, _e2378, (_e2378 > _e2382));
                                        let _e2388 = select(_e2368, _e2384, (_e2384 > _e2368));
                                        let _e2390 = select(_e2370, _e2386, (_e2386 > _e2370));
                                        let _e2392 = select(_e2339, _e2337, (_e2337 > _e2339));
                                        let _e2394 = select(_e2340, _e2338, (_e2338 > _e2340));
                                        let _e2396 = select(_e2352, _e2350, (_e2350 > _e2352));
                                        let _e2398 = select(_e2353, _e2351, (_e2351 > _e2353));
                                        let _e2400 = select(_e2396, _e2392, (_e2392 < _e2396));
                                        let _e2402 = select(_e2398, _e2394, (_e2394 < _e2398));
                                        let _e2407 = -(_e2368);
                                        let _e2408 = -(_e2370);
                                        let _e2415 = (select(_e2372, _e2400, (_e2400 < _e2372)) + (select(_e2407, _e2372, (_e2372 > _e2407)) * 0.0000019073523f));
                                        let _e2416 = (select(_e2374, _e2402, (_e2402 < _e2374)) + (select(_e2408, _e2374, (_e2374 > _e2408)) * 0.0000019073523f));
                                        let _e2418 = select(_e764, _e2388, (_e2388 > _e764));
                                        let _e2420 = select(_e764, _e2390, (_e2390 > _e764));
                                        let _e2425 = (_e2418 <= select(_e2029.member_1, _e2415, (_e2415 < _e2029.member_1)));
                                        let _e2426 = (_e2420 <= select(_e2029.member_1, _e2416, (_e2416 < _e2029.member_1)));
                                        let _e2427 = (_e2418 <= _e2420);
                                        if _e2425 {
                                            if _e2426 {
                                                if _e2427 {
                                                    phi_4718_ = _e2325.member_2;
                                                } else {
                                                    phi_4718_ = _e2325.member_1;
                                                }
                                                let _e2431 = phi_4718_;
                                                let _e2452 = (_e849 % 128u);
                                                let _e2453 = (_e2452 < 128u);
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_8[_e2452] = _e2431.member_1;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_7[_e2452] = _e2431.member.member.x;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_6[_e2452] = _e2431.member.member.y;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_5[_e2452] = _e2431.member.member.z;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_4[_e2452] = _e2431.member.member_1.x;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_3[_e2452] = _e2431.member.member_1.y;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_2[_e2452] = _e2431.member.member_1.z;
                                                if _e2453 {
                                                } else {
                                                    phi_5513_ = true;
                                                    break;
                                                }
                                                local_9[_e2452] = select(_e2418, _e2420, _e2427);
                                                if _e2427 {
                                                    phi_4794_ = _e2325.member_1;
                                                } else {
                                                    phi_4794_ = _e2325.member_2;
                                                }
                                                let _e2466 = phi_4794_;
                                                phi_4795_ = (_e849 + 1u);
                                                phi_4796_ = _e2466;
                                            } else {
                                                phi_4795_ = u32();
                                                phi_4796_ = type_57();
                                            }
                                            let _e2468 = phi_4795_;
                                            let _e2470 = phi_4796_;
                                            phi_4798_ = _e2468;
                                            phi_4799_ = _e2470;
                                            phi_4800_ = select(true, false, _e2426);
                                        } else {
                                            phi_4798_ = u32();
                                            phi_4799_ = type_57();
                                            phi_4800_ = true;
                                        }
                                        let _e2473 = phi_4798_;
                                        let _e2475 = phi_4799_;
                                        let _e2477 = phi_4800_;
                                        if _e2477 {
                                            if _e2425 {
                                                phi_4809_ = _e2325.member_1;
                                            } else {
                                                phi_4809_ = _e2325.member_2;
                                            }
                                            let _e2481 = phi_4809_;
                                            phi_4814_ = select(_e2426, true, _e2425);
                                            phi_4816_ = _e2481;
                                        } else {
                                            phi_4814_ = _e847;
                                            phi_4816_ = _e2475;
                                        }
                                        let _e2484 = phi_4814_;
                                        let _e2486 = phi_4816_;
                                        phi_4820_ = _e2484;
                                        phi_4821_ = select(_e2473, _e849, _e2477);
                                        phi_4822_ = _e2486;
                                    }
                                    let _e2489 = phi_4820_;
                                    let _e2491 = phi_4821_;
                                    let _e2493 = phi_4822_;
                                    if _e855 {
                                        phi_4832_ = _e851;
                                    } else {
                                        phi_4832_ = _e2493;
                                    }
                                    let _e2495 = phi_4832_;
                                    phi_5516_ = _e2027;
                                    phi_4833_ = _e2029;
                                    phi_4834_ = (_e810 - 1u);
                                    phi_4835_ = select(_e2489, false, _e855);
                                    phi_4836_ = select(_e2491, _e849, _e855);
                                    phi_4837_ = _e2495;
                                } else {
                                    phi_5516_ = _e806;
                                    phi_4833_ = _e808;
                                    phi_4834_ = _e810;
                                    phi_4835_ = _e847;
                                    phi_4836_ = _e849;
                                    phi_4837_ = _e851;
                                }
                                let _e2499 = phi_5516_;
                                let _e2501 = phi_4833_;
                                let _e2503 = phi_4834_;
                                let _e2505 = phi_4835_;
                                let _e2507 = phi_4836_;
                                let _e2509 = phi_4837_;
                                phi_5515_ = _e2499;
                                phi_4838_ = _e2501;
                                phi_4839_ = _e2503;
                                phi_4840_ = _e2505;
                                phi_4841_ = _e2507;
                                phi_4842_ = _e2509;
                            } else {
                                phi_5515_ = _e806;
                                phi_4838_ = type_43();
                                phi_4839_ = u32();
                                phi_4840_ = bool();
                                phi_4841_ = u32();
                                phi_4842_ = type_57();
                            }
                            let _e2511 = phi_5515_;
                            let _e2513 = phi_4838_;
                            let _e2515 = phi_4839_;
                            let _e2517 = phi_4840_;
                            let _e2519 = phi_4841_;
                            let _e2521 = phi_4842_;
                            phi_5514_ = _e2511;
                            phi_1402_ = _e2513;
                            phi_1405_ = _e2515;
                            phi_1407_ = _e2517;
                            phi_1409_ = _e2519;
                            phi_1411_ = _e2521;
                            phi_4843_ = _e820;
                        } else {
                            phi_5514_ = _e806;
                            phi_1402_ = type_43();
                            phi_1405_ = u32();
                            phi_1407_ = bool();
                            phi_1409_ = u32();
                            phi_1411_ = type_57();
                            phi_4843_ = false;
                        }
                        let _e2523 = phi_5514_;
                        let _e2525 = phi_1402_;
                        let _e2527 = phi_1405_;
                        let _e2529 = phi_1407_;
                        let _e2531 = phi_1409_;
                        let _e2533 = phi_1411_;
                        let _e2535 = phi_4843_;
                        continue;
                        continuing {
                            phi_5280_ = _e2523;
                            phi_1401_ = _e2525;
                            phi_1404_ = _e2527;
                            phi_1406_ = _e2529;
                            phi_1408_ = _e2531;
                            phi_1410_ = _e2533;
                            phi_5513_ = _e2523;
                            break if !(_e2535);
                        }
                    }
                    let _e2538 = phi_5513_;
                    if _e2538 {
                        break;
                    }
                    let _e2540 = local_10;
                    if (_e2540.member.member_3 != 4294967295u) {
                        let _e2545 = bitcast<u32>(_e2540.member.member);
                        let _e2549 = (bitcast<i32>((_e2545 >> bitcast<u32>(23i))) & 255i);
                        let _e2550 = (_e2549 + _e433);
                        if (_e2549 == 255i) {
                            phi_4902_ = _e2540.member.member;
                        } else {
                            if (_e2549 > 0i) {
                                if (_e2550 > 0i) {
                                    let _e2554 = (_e2550 < 255i);
                                    if _e2554 {
                                        phi_4881_ = bitcast<f32>((_e2545 + bitcast<u32>((_e433 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4881_ = f32();
                                    }
                                    let _e2561 = phi_4881_;
                                    phi_4883_ = _e2561;
                                    phi_4884_ = select(true, false, _e2554);
                                } else {
                                    phi_4883_ = f32();
                                    phi_4884_ = true;
                                }
                                let _e2564 = phi_4883_;
                                let _e2566 = phi_4884_;
                                phi_4885_ = _e2564;
                                phi_4886_ = _e2566;
                            } else {
                                phi_4885_ = f32();
                                phi_4886_ = true;
                            }
                            let _e2568 = phi_4885_;
                            let _e2570 = phi_4886_;
                            if _e2570 {
                                let _e2571 = (_e2545 & 2147483648u);
                                let _e2578 = ((_e2545 & 8388607u) | (select(0u, 1u, ((_e2545 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2582 = (_e2578 == 0u);
                                if _e2582 {
                                    phi_5232_ = bitcast<f32>(_e2571);
                                } else {
                                    let _e2587 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2578)), 32u, _e2582) - 8u);
                                    let _e2590 = (_e2578 << bitcast<u32>((_e2587 & 31u)));
                                    let _e2592 = ((_e2550 + select(0i, 1i, (_e2549 == 0i))) - bitcast<i32>(_e2587));
                                    if (_e2592 >= 255i) {
                                        phi_5222_ = bitcast<f32>((_e2571 | 2139095040u));
                                        phi_5223_ = f32();
                                        phi_5224_ = true;
                                    } else {
                                        let _e2594 = (_e2592 > 0i);
                                        if _e2594 {
                                            phi_5216_ = bitcast<f32>(((_e2571 | (bitcast<u32>(_e2592) << bitcast<u32>(23i))) | (_e2590 & 8388607u)));
                                            phi_5217_ = f32();
                                        } else {
                                            if (_e2592 < -24i) {
                                                phi_5182_ = 26u;
                                            } else {
                                                phi_5182_ = bitcast<u32>((1i - _e2592));
                                            }
                                            let _e2599 = phi_5182_;
                                            let _e2600 = (_e2599 & 31u);
                                            let _e2602 = (_e2590 >> bitcast<u32>(_e2600));
                                            let _e2606 = (_e2590 & ((1u << bitcast<u32>(_e2600)) - 1u));
                                            let _e2610 = (1u << bitcast<u32>(((_e2599 - 1u) & 31u)));
                                            if (_e2606 > _e2610) {
                                                phi_5203_ = true;
                                            } else {
                                                if (_e2606 == _e2610) {
                                                    phi_5200_ = ((_e2602 & 1u) == 1u);
                                                } else {
                                                    phi_5200_ = false;
                                                }
                                                let _e2616 = phi_5200_;
                                                phi_5203_ = _e2616;
                                            }
                                            let _e2618 = phi_5203_;
                                            phi_5216_ = f32();
                                            phi_5217_ = bitcast<f32>((_e2571 | (_e2602 + select(0u, 1u, _e2618))));
                                        }
                                        let _e2631 = phi_5216_;
                                        let _e2633 = phi_5217_;
                                        phi_5222_ = _e2631;
                                        phi_5223_ = _e2633;
                                        phi_5224_ = _e2594;
                                    }
                                    let _e2637 = phi_5222_;
                                    let _e2639 = phi_5223_;
                                    let _e2641 = phi_5224_;
                                    phi_5232_ = select(_e2639, _e2637, _e2641);
                                }
                                let _e2645 = phi_5232_;
                                phi_4901_ = _e2645;
                            } else {
                                phi_4901_ = _e2568;
                            }
                            let _e2647 = phi_4901_;
                            phi_4902_ = _e2647;
                        }
                        let _e2649 = phi_4902_;
                        let _e2650 = bitcast<u32>(_e2649);
                        if ((_e2650 & 2147483647u) >= 2139095040u) {
                            phi_4914_ = bitcast<f32>(((_e2650 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4914_ = _e2649;
                        }
                        let _e2657 = phi_4914_;
                        phi_4919_ = type_25(_e2657, _e2540.member.member_1, _e2540.member.member_2, _e2540.member.member_3);
                    } else {
                        phi_4919_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2662 = phi_4919_;
                    if _e310 {
                    } else {
                        break;
                    }
                    global_8.member[_e156] = _e2662;
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e2666 = select(0u, 1u, (_e377 <= _e387));
                    if (_e2666 > 0u) {
                        let _e2668 = (1u < _e124);
                        if _e2668 {
                            if (0u < _e124) {
                            } else {
                                break;
                            }
                            let _e2672 = atomicAdd((&global_9.member[0u]), _e2666);
                            if ((_e2672 + _e2666) < _e2672) {
                                if _e2668 {
                                } else {
                                    break;
                                }
                                let _e2677 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2680 = select(0u, 1u, (_e2662.member_3 != 4294967295u));
                    if (_e2680 > 0u) {
                        let _e2682 = (3u < _e124);
                        if _e2682 {
                            if (2u < _e124) {
                            } else {
                                break;
                            }
                            let _e2686 = atomicAdd((&global_9.member[2u]), _e2680);
                            if ((_e2686 + _e2680) < _e2686) {
                                if _e2682 {
                                } else {
                                    break;
                                }
                                let _e2691 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
