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
    var phi_5276_: bool;
    var phi_1401_: type_43;
    var phi_1404_: bool;
    var phi_1406_: u32;
    var phi_1408_: u32;
    var phi_1410_: type_57;
    var phi_1421_: bool;
    var phi_1507_: bool;
    var phi_1508_: u32;
    var phi_1509_: type_57;
    var phi_4061_: u32;
    var phi_4067_: u32;
    var phi_4321_: u32;
    var phi_4322_: u32;
    var phi_4332_: u32;
    var phi_4334_: u32;
    var phi_4335_: bool;
    var phi_4355_: u32;
    var phi_4356_: u32;
    var phi_4360_: type_58;
    var phi_4722_: type_57;
    var phi_4799_: type_57;
    var phi_4800_: u32;
    var phi_4801_: type_57;
    var phi_4803_: u32;
    var phi_4804_: type_57;
    var phi_4805_: bool;
    var phi_4814_: type_57;
    var phi_4819_: bool;
    var phi_4821_: type_57;
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
    var phi_5270_: bool;
    var phi_5513_: bool;
    var phi_4825_: type_43;
    var phi_4826_: bool;
    var phi_4827_: u32;
    var phi_4828_: type_57;
    var phi_5512_: bool;
    var phi_4829_: type_43;
    var phi_4830_: bool;
    var phi_4831_: u32;
    var phi_4832_: u32;
    var phi_4833_: type_57;
    var phi_5511_: bool;
    var phi_4834_: type_43;
    var phi_4835_: bool;
    var phi_4836_: u32;
    var phi_4837_: u32;
    var phi_4838_: type_57;
    var phi_5510_: bool;
    var phi_1402_: type_43;
    var phi_1405_: bool;
    var phi_1407_: u32;
    var phi_1409_: u32;
    var phi_1411_: type_57;
    var phi_4839_: bool;
    var phi_5509_: bool;
    var local_10: type_43;
    var phi_4877_: f32;
    var phi_4879_: f32;
    var phi_4880_: bool;
    var phi_4881_: f32;
    var phi_4882_: bool;
    var phi_5178_: u32;
    var phi_5196_: bool;
    var phi_5199_: bool;
    var phi_5212_: f32;
    var phi_5213_: f32;
    var phi_5218_: f32;
    var phi_5219_: f32;
    var phi_5220_: bool;
    var phi_5228_: f32;
    var phi_4897_: f32;
    var phi_4898_: f32;
    var phi_4910_: f32;
    var phi_4915_: type_25;
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
                    phi_5276_ = false;
                    phi_1401_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e762);
                    phi_1404_ = (_e764 <= _e762);
                    phi_1406_ = ((3u * _e109) + 1u);
                    phi_1408_ = 0u;
                    phi_1410_ = type_57(type_37(vec4<f32>((f32(_e771) * _e168), (f32(_e777) * _e168), (f32(_e783) * _e168), 0f), vec4<f32>((f32(_e788) * _e168), (f32(_e792) * _e168), (f32(_e796) * _e168), 0f)), select(0u, 2147483648u, (_e109 == 0u)));
                    loop {
                        let _e806 = phi_5276_;
                        let _e808 = phi_1401_;
                        let _e810 = phi_1404_;
                        let _e812 = phi_1406_;
                        let _e814 = phi_1408_;
                        let _e816 = phi_1410_;
                        local_10 = _e808;
                        if _e810 {
                            phi_1421_ = true;
                        } else {
                            phi_1421_ = (_e814 > 0u);
                        }
                        let _e819 = phi_1421_;
                        if _e819 {
                            let _e820 = (_e812 > 0u);
                            if _e820 {
                                if _e810 {
                                    phi_1507_ = _e810;
                                    phi_1508_ = _e814;
                                    phi_1509_ = _e816;
                                } else {
                                    let _e821 = (_e814 - 1u);
                                    let _e822 = (_e821 % 128u);
                                    let _e823 = (_e822 < 128u);
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e825 = local_7[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e827 = local_6[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e829 = local_5[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e831 = local_4[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e833 = local_3[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e835 = local_2[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
                                        break;
                                    }
                                    let _e840 = local_8[_e822];
                                    if _e823 {
                                    } else {
                                        phi_5509_ = true;
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
                                    let _e856 = (_e851.member_1 & 268435455u);
                                    if ((_e851.member_1 & 2147483648u) != 0u) {
                                        phi_1528_ = _e808;
                                        phi_1531_ = type_8(0u, ((_e851.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1322 = phi_1528_;
                                            let _e1324 = phi_1531_;
                                            local_11 = _e1322;
                                            if (_e1324.member < _e1324.member_1) {
                                                phi_1532_ = type_8((_e1324.member + 1u), _e1324.member_1);
                                                phi_1554_ = type_8(1u, _e1324.member);
                                            } else {
                                                phi_1532_ = _e1324;
                                                phi_1554_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1337 = phi_1532_;
                                            let _e1339 = phi_1554_;
                                            let _e1343 = (bitcast<i32>(_e1339.member) != 0i);
                                            if _e1343 {
                                                let _e1348 = (_e851.member.member_1.x - _e851.member.member.x);
                                                let _e1351 = (_e851.member.member_1.y - _e851.member.member.y);
                                                let _e1354 = (_e851.member.member_1.z - _e851.member.member.z);
                                                let _e1356 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                let _e1358 = select(_e1354, _e1356, (_e1356 > _e1354));
                                                let _e1360 = (_e1358 < (1024f * _e168));
                                                if _e1360 {
                                                    phi_1595_ = 0u;
                                                } else {
                                                    phi_1595_ = select(2u, 1u, (_e1358 < (2097152f * _e168)));
                                                }
                                                let _e1365 = phi_1595_;
                                                switch bitcast<i32>(_e1365) {
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
                                                let _e1368 = phi_1601_;
                                                switch bitcast<i32>(_e1365) {
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
                                                let _e1375 = phi_1611_;
                                                let _e1377 = ((_e856 + (_e1339.member_1 * ((3u * _e1368) + 1u))) + (3u * _e1375));
                                                let _e1378 = (_e1377 < _e112);
                                                if _e1378 {
                                                    if _e1378 {
                                                    } else {
                                                        phi_5270_ = true;
                                                        break;
                                                    }
                                                    let _e1380 = global_10.member[_e1377];
                                                    phi_1627_ = _e1380;
                                                } else {
                                                    phi_1627_ = 4294967295u;
                                                }
                                                let _e1382 = phi_1627_;
                                                if _e1360 {
                                                    phi_1660_ = 0u;
                                                } else {
                                                    phi_1660_ = select(2u, 1u, (_e1358 < (2097152f * _e168)));
                                                }
                                                let _e1387 = phi_1660_;
                                                switch bitcast<i32>(_e1387) {
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
                                                let _e1390 = phi_1666_;
                                                let _e1394 = (_e856 + (_e1339.member_1 * ((3u * _e1390) + 1u)));
                                                switch bitcast<i32>(_e1387) {
                                                    case 0: {
                                                        let _e1669 = (_e1394 < _e112);
                                                        if _e1669 {
                                                            if _e1669 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1671 = global_10.member[_e1394];
                                                            phi_1693_ = _e1671;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1673 = phi_1693_;
                                                        let _e1675 = ((10u * _e431) & 31u);
                                                        let _e1685 = ((10u * _e430) & 31u);
                                                        let _e1695 = ((10u * _e432) & 31u);
                                                        let _e1705 = (_e1394 + 1u);
                                                        let _e1706 = (_e1705 < _e112);
                                                        if _e1706 {
                                                            if _e1706 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1708 = global_10.member[_e1705];
                                                            phi_1742_ = _e1708;
                                                        } else {
                                                            phi_1742_ = 0u;
                                                        }
                                                        let _e1710 = phi_1742_;
                                                        let _e1736 = (_e1394 + 2u);
                                                        let _e1737 = (_e1736 < _e112);
                                                        if _e1737 {
                                                            if _e1737 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1739 = global_10.member[_e1736];
                                                            phi_1791_ = _e1739;
                                                        } else {
                                                            phi_1791_ = 0u;
                                                        }
                                                        let _e1741 = phi_1791_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1673 >> bitcast<u32>(_e1675)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1673 >> bitcast<u32>(_e1685)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1673 >> bitcast<u32>(_e1695)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1710 >> bitcast<u32>(_e1675)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1710 >> bitcast<u32>(_e1685)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1710 >> bitcast<u32>(_e1695)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | ((_e1741 >> bitcast<u32>(_e1675)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | ((_e1741 >> bitcast<u32>(_e1685)) & 1023u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | ((_e1741 >> bitcast<u32>(_e1695)) & 1023u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1483 = (_e1394 < _e112);
                                                        if _e1483 {
                                                            if _e1483 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1485 = global_10.member[_e1394];
                                                            phi_1840_ = _e1485;
                                                        } else {
                                                            phi_1840_ = 0u;
                                                        }
                                                        let _e1487 = phi_1840_;
                                                        let _e1488 = (_e1394 + 1u);
                                                        let _e1489 = (_e1488 < _e112);
                                                        if _e1489 {
                                                            if _e1489 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1491 = global_10.member[_e1488];
                                                            phi_1855_ = _e1491;
                                                        } else {
                                                            phi_1855_ = 0u;
                                                        }
                                                        let _e1493 = phi_1855_;
                                                        let _e1494 = (_e431 == 1u);
                                                        if _e1494 {
                                                            phi_1865_ = ((_e1487 >> bitcast<u32>(21i)) | (_e1493 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1865_ = (_e1493 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1503 = phi_1865_;
                                                        let _e1511 = (_e430 == 1u);
                                                        if _e1511 {
                                                            phi_1886_ = ((_e1487 >> bitcast<u32>(21i)) | (_e1493 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1886_ = (_e1493 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1520 = phi_1886_;
                                                        let _e1528 = (_e432 == 1u);
                                                        if _e1528 {
                                                            phi_1907_ = ((_e1487 >> bitcast<u32>(21i)) | (_e1493 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1907_ = (_e1493 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1537 = phi_1907_;
                                                        let _e1546 = (_e1394 + 2u);
                                                        let _e1547 = (_e1546 < _e112);
                                                        if _e1547 {
                                                            if _e1547 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1549 = global_10.member[_e1546];
                                                            phi_1937_ = _e1549;
                                                        } else {
                                                            phi_1937_ = 0u;
                                                        }
                                                        let _e1551 = phi_1937_;
                                                        let _e1552 = (_e1394 + 3u);
                                                        let _e1553 = (_e1552 < _e112);
                                                        if _e1553 {
                                                            if _e1553 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1555 = global_10.member[_e1552];
                                                            phi_1952_ = _e1555;
                                                        } else {
                                                            phi_1952_ = 0u;
                                                        }
                                                        let _e1557 = phi_1952_;
                                                        if _e1494 {
                                                            phi_1962_ = ((_e1551 >> bitcast<u32>(21i)) | (_e1557 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1962_ = (_e1557 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1566 = phi_1962_;
                                                        if _e1511 {
                                                            phi_1983_ = ((_e1551 >> bitcast<u32>(21i)) | (_e1557 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1983_ = (_e1557 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1582 = phi_1983_;
                                                        if _e1528 {
                                                            phi_2004_ = ((_e1551 >> bitcast<u32>(21i)) | (_e1557 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2004_ = (_e1557 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1598 = phi_2004_;
                                                        let _e1607 = (_e1394 + 4u);
                                                        let _e1608 = (_e1607 < _e112);
                                                        if _e1608 {
                                                            if _e1608 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1610 = global_10.member[_e1607];
                                                            phi_2034_ = _e1610;
                                                        } else {
                                                            phi_2034_ = 0u;
                                                        }
                                                        let _e1612 = phi_2034_;
                                                        let _e1613 = (_e1394 + 5u);
                                                        let _e1614 = (_e1613 < _e112);
                                                        if _e1614 {
                                                            if _e1614 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1616 = global_10.member[_e1613];
                                                            phi_2049_ = _e1616;
                                                        } else {
                                                            phi_2049_ = 0u;
                                                        }
                                                        let _e1618 = phi_2049_;
                                                        if _e1494 {
                                                            phi_2059_ = ((_e1612 >> bitcast<u32>(21i)) | (_e1618 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2059_ = (_e1618 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1627 = phi_2059_;
                                                        if _e1511 {
                                                            phi_2080_ = ((_e1612 >> bitcast<u32>(21i)) | (_e1618 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2080_ = (_e1618 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1643 = phi_2080_;
                                                        if _e1528 {
                                                            phi_2101_ = ((_e1612 >> bitcast<u32>(21i)) | (_e1618 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2101_ = (_e1618 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1659 = phi_2101_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1503, _e1487, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1520, _e1487, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1537, _e1487, _e588) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1566, _e1551, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1582, _e1551, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1598, _e1551, _e588) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e851.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1627, _e1612, _e455) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1643, _e1612, _e522) & 2097151u))) - 8388608f) * _e168)), (_e851.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1659, _e1612, _e588) & 2097151u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1396 = (_e1394 + _e431);
                                                        let _e1397 = (_e1396 < _e112);
                                                        if _e1397 {
                                                            if _e1397 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1399 = global_10.member[_e1396];
                                                            phi_2132_ = _e1399;
                                                        } else {
                                                            phi_2132_ = 0u;
                                                        }
                                                        let _e1401 = phi_2132_;
                                                        let _e1405 = (_e1394 + _e430);
                                                        let _e1406 = (_e1405 < _e112);
                                                        if _e1406 {
                                                            if _e1406 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1408 = global_10.member[_e1405];
                                                            phi_2150_ = _e1408;
                                                        } else {
                                                            phi_2150_ = 0u;
                                                        }
                                                        let _e1410 = phi_2150_;
                                                        let _e1414 = (_e1394 + _e432);
                                                        let _e1415 = (_e1414 < _e112);
                                                        if _e1415 {
                                                            if _e1415 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1417 = global_10.member[_e1414];
                                                            phi_2168_ = _e1417;
                                                        } else {
                                                            phi_2168_ = 0u;
                                                        }
                                                        let _e1419 = phi_2168_;
                                                        let _e1424 = (_e1394 + 3u);
                                                        let _e1425 = (_e1424 + _e431);
                                                        let _e1426 = (_e1425 < _e112);
                                                        if _e1426 {
                                                            if _e1426 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1428 = global_10.member[_e1425];
                                                            phi_2191_ = _e1428;
                                                        } else {
                                                            phi_2191_ = 0u;
                                                        }
                                                        let _e1430 = phi_2191_;
                                                        let _e1434 = (_e1424 + _e430);
                                                        let _e1435 = (_e1434 < _e112);
                                                        if _e1435 {
                                                            if _e1435 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1437 = global_10.member[_e1434];
                                                            phi_2209_ = _e1437;
                                                        } else {
                                                            phi_2209_ = 0u;
                                                        }
                                                        let _e1439 = phi_2209_;
                                                        let _e1443 = (_e1424 + _e432);
                                                        let _e1444 = (_e1443 < _e112);
                                                        if _e1444 {
                                                            if _e1444 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1446 = global_10.member[_e1443];
                                                            phi_2227_ = _e1446;
                                                        } else {
                                                            phi_2227_ = 0u;
                                                        }
                                                        let _e1448 = phi_2227_;
                                                        let _e1453 = (_e1394 + 6u);
                                                        let _e1454 = (_e1453 + _e431);
                                                        let _e1455 = (_e1454 < _e112);
                                                        if _e1455 {
                                                            if _e1455 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1457 = global_10.member[_e1454];
                                                            phi_2250_ = _e1457;
                                                        } else {
                                                            phi_2250_ = 0u;
                                                        }
                                                        let _e1459 = phi_2250_;
                                                        let _e1463 = (_e1453 + _e430);
                                                        let _e1464 = (_e1463 < _e112);
                                                        if _e1464 {
                                                            if _e1464 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1466 = global_10.member[_e1463];
                                                            phi_2268_ = _e1466;
                                                        } else {
                                                            phi_2268_ = 0u;
                                                        }
                                                        let _e1468 = phi_2268_;
                                                        let _e1472 = (_e1453 + _e432);
                                                        let _e1473 = (_e1472 < _e112);
                                                        if _e1473 {
                                                            if _e1473 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e1475 = global_10.member[_e1472];
                                                            phi_2286_ = _e1475;
                                                        } else {
                                                            phi_2286_ = 0u;
                                                        }
                                                        let _e1477 = phi_2286_;
                                                        phi_2292_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1401)) * _e168), (f32(bitcast<i32>(_e1410)) * _e168), (f32(bitcast<i32>(_e1419)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1430)) * _e168), (f32(bitcast<i32>(_e1439)) * _e168), (f32(bitcast<i32>(_e1448)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e1459)) * _e168), (f32(bitcast<i32>(_e1468)) * _e168), (f32(bitcast<i32>(_e1477)) * _e168)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2292_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1769 = phi_2292_;
                                                let _e1777 = (_e1769[0][2] - _e611);
                                                let _e1780 = (((_e1769[0][0] - _e478) * _e650) - (_e1777 * _e518));
                                                let _e1783 = (((_e1769[0][1] - _e545) * _e650) - (_e1777 * _e584));
                                                let _e1790 = (_e1769[1][2] - _e611);
                                                let _e1793 = (((_e1769[1][0] - _e478) * _e650) - (_e1790 * _e518));
                                                let _e1796 = (((_e1769[1][1] - _e545) * _e650) - (_e1790 * _e584));
                                                let _e1803 = (_e1769[2][2] - _e611);
                                                let _e1806 = (((_e1769[2][0] - _e478) * _e650) - (_e1803 * _e518));
                                                let _e1809 = (((_e1769[2][1] - _e545) * _e650) - (_e1803 * _e584));
                                                let _e1810 = (_e1806 * _e1796);
                                                let _e1811 = (_e1809 * _e1793);
                                                let _e1812 = (_e1780 * _e1809);
                                                let _e1813 = (_e1783 * _e1806);
                                                let _e1814 = (_e1793 * _e1783);
                                                let _e1815 = (_e1796 * _e1780);
                                                let _e1820 = (((_e1810 >= _e1811) && (_e1812 >= _e1813)) && (_e1814 >= _e1815));
                                                if (_e1820 || (((_e1810 <= _e1811) && (_e1812 <= _e1813)) && (_e1814 <= _e1815))) {
                                                    let _e1827 = select(-1f, 1f, _e1820);
                                                    let _e1829 = ((_e1810 - _e1811) * _e1827);
                                                    let _e1831 = select(0f, _e1829, (_e1829 > 0f));
                                                    let _e1833 = ((_e1812 - _e1813) * _e1827);
                                                    let _e1835 = select(0f, _e1833, (_e1833 > 0f));
                                                    let _e1837 = ((_e1814 - _e1815) * _e1827);
                                                    let _e1839 = select(0f, _e1837, (_e1837 > 0f));
                                                    let _e1841 = ((_e1831 + _e1835) + _e1839);
                                                    if (_e1841 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3176_ = type_25();
                                                        phi_3177_ = true;
                                                        phi_3178_ = false;
                                                    } else {
                                                        let _e1844 = select(_e1793, _e1780, (_e1780 < _e1793));
                                                        if (select(_e1806, _e1844, (_e1844 < _e1806)) > 0f) {
                                                            phi_2444_ = true;
                                                        } else {
                                                            let _e1849 = select(_e1793, _e1780, (_e1780 > _e1793));
                                                            phi_2444_ = (select(_e1806, _e1849, (_e1849 > _e1806)) < 0f);
                                                        }
                                                        let _e1854 = phi_2444_;
                                                        if _e1854 {
                                                            phi_3173_ = type_25();
                                                            phi_3174_ = true;
                                                            phi_3175_ = false;
                                                        } else {
                                                            let _e1856 = select(_e1796, _e1783, (_e1783 < _e1796));
                                                            if (select(_e1809, _e1856, (_e1856 < _e1809)) > 0f) {
                                                                phi_2473_ = true;
                                                            } else {
                                                                let _e1861 = select(_e1796, _e1783, (_e1783 > _e1796));
                                                                phi_2473_ = (select(_e1809, _e1861, (_e1861 > _e1809)) < 0f);
                                                            }
                                                            let _e1866 = phi_2473_;
                                                            if _e1866 {
                                                                phi_3171_ = type_25();
                                                                phi_3172_ = false;
                                                            } else {
                                                                let _e1868 = select(_e1769[1][0], _e1769[0][0], (_e1769[0][0] < _e1769[1][0]));
                                                                let _e1872 = select(_e1769[1][0], _e1769[0][0], (_e1769[0][0] > _e1769[1][0]));
                                                                let _e1876 = select(_e1769[1][1], _e1769[0][1], (_e1769[0][1] < _e1769[1][1]));
                                                                let _e1880 = select(_e1769[1][1], _e1769[0][1], (_e1769[0][1] > _e1769[1][1]));
                                                                let _e1884 = select(_e1769[1][2], _e1769[0][2], (_e1769[0][2] < _e1769[1][2]));
                                                                let _e1888 = select(_e1769[1][2], _e1769[0][2], (_e1769[0][2] > _e1769[1][2]));
                                                                let _e1893 = ((select(_e1769[2][0], _e1868, (_e1868 < _e1769[2][0])) - _e516) * _e521);
                                                                let _e1894 = ((select(_e1769[2][0], _e1872, (_e1872 > _e1769[2][0])) - _e517) * _e521);
                                                                let _e1897 = ((select(_e1769[2][1], _e1876, (_e1876 < _e1769[2][1])) - _e582) * _e587);
                                                                let _e1898 = ((select(_e1769[2][1], _e1880, (_e1880 > _e1769[2][1])) - _e583) * _e587);
                                                                let _e1901 = ((select(_e1769[2][2], _e1884, (_e1884 < _e1769[2][2])) - _e648) * _e653);
                                                                let _e1902 = ((select(_e1769[2][2], _e1888, (_e1888 > _e1769[2][2])) - _e649) * _e653);
                                                                let _e1904 = select(_e1902, _e1901, (_e1901 < _e1902));
                                                                let _e1906 = select(_e1902, _e1901, (_e1901 > _e1902));
                                                                let _e1908 = select(_e1894, _e1893, (_e1893 < _e1894));
                                                                let _e1910 = select(_e1898, _e1897, (_e1897 < _e1898));
                                                                let _e1912 = select(_e1910, _e1908, (_e1908 > _e1910));
                                                                let _e1914 = select(_e1904, _e1912, (_e1912 > _e1904));
                                                                let _e1916 = select(_e1894, _e1893, (_e1893 > _e1894));
                                                                let _e1918 = select(_e1898, _e1897, (_e1897 > _e1898));
                                                                let _e1920 = select(_e1918, _e1916, (_e1916 < _e1918));
                                                                let _e1922 = select(_e1906, _e1920, (_e1920 < _e1906));
                                                                let _e1923 = -(_e1904);
                                                                let _e1929 = select(_e764, _e1914, (_e1914 > _e764));
                                                                if (_e1929 > (_e1922 + (select(_e1923, _e1906, (_e1906 > _e1923)) * 0.0000019073523f))) {
                                                                    phi_3166_ = type_25();
                                                                    phi_3167_ = true;
                                                                } else {
                                                                    let _e1931 = (_e1929 > _e1322.member_1);
                                                                    if _e1931 {
                                                                        phi_3165_ = type_25();
                                                                    } else {
                                                                        let _e1932 = vec3<f32>(_e1769[0][0], _e1769[0][1], _e1769[0][2]);
                                                                        let _e1933 = vec3<f32>(_e1769[1][0], _e1769[1][1], _e1769[1][2]);
                                                                        let _e1934 = vec3<f32>(_e1769[2][0], _e1769[2][1], _e1769[2][2]);
                                                                        let _e1935 = (_e1769[1][0] - _e1769[0][0]);
                                                                        let _e1936 = (_e1769[1][1] - _e1769[0][1]);
                                                                        let _e1937 = (_e1769[1][2] - _e1769[0][2]);
                                                                        let _e1938 = vec3<f32>(_e1935, _e1936, _e1937);
                                                                        let _e1939 = (_e1769[2][0] - _e1769[1][0]);
                                                                        let _e1940 = (_e1769[2][1] - _e1769[1][1]);
                                                                        let _e1941 = (_e1769[2][2] - _e1769[1][2]);
                                                                        let _e1942 = vec3<f32>(_e1939, _e1940, _e1941);
                                                                        let _e1943 = (_e1769[0][0] - _e1769[2][0]);
                                                                        let _e1944 = (_e1769[0][1] - _e1769[2][1]);
                                                                        let _e1945 = (_e1769[0][2] - _e1769[2][2]);
                                                                        let _e1946 = vec3<f32>(_e1943, _e1944, _e1945);
                                                                        let _e1949 = bitcast<f32>((bitcast<u32>(_e1935) & 2147483647u));
                                                                        let _e1952 = bitcast<f32>((bitcast<u32>(_e1936) & 2147483647u));
                                                                        let _e1954 = select(_e1952, _e1949, (_e1949 > _e1952));
                                                                        let _e1957 = bitcast<f32>((bitcast<u32>(_e1937) & 2147483647u));
                                                                        let _e1959 = select(_e1957, _e1954, (_e1954 > _e1957));
                                                                        let _e1962 = bitcast<f32>((bitcast<u32>(_e1939) & 2147483647u));
                                                                        let _e1965 = bitcast<f32>((bitcast<u32>(_e1940) & 2147483647u));
                                                                        let _e1967 = select(_e1965, _e1962, (_e1962 > _e1965));
                                                                        let _e1970 = bitcast<f32>((bitcast<u32>(_e1941) & 2147483647u));
                                                                        let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                                        let _e1975 = bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u));
                                                                        let _e1978 = bitcast<f32>((bitcast<u32>(_e1944) & 2147483647u));
                                                                        let _e1980 = select(_e1978, _e1975, (_e1975 > _e1978));
                                                                        let _e1983 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                                        let _e1985 = select(_e1983, _e1980, (_e1980 > _e1983));
                                                                        let _e1987 = select(_e1972, _e1959, (_e1959 > _e1972));
                                                                        let _e1989 = select(_e1985, _e1987, (_e1987 > _e1985));
                                                                        if (_e1959 == _e1989) {
                                                                            phi_2892_ = _e1796;
                                                                            phi_2893_ = _e1793;
                                                                            phi_2894_ = _e1783;
                                                                            phi_2895_ = _e1780;
                                                                            phi_2896_ = _e1932;
                                                                            phi_2897_ = _e1946;
                                                                            phi_2898_ = _e1942;
                                                                            phi_2899_ = _e1938;
                                                                        } else {
                                                                            let _e1991 = (_e1972 == _e1989);
                                                                            let _e1996 = vec3(_e1991);
                                                                            phi_2892_ = select(_e1783, _e1809, _e1991);
                                                                            phi_2893_ = select(_e1780, _e1806, _e1991);
                                                                            phi_2894_ = select(_e1809, _e1796, _e1991);
                                                                            phi_2895_ = select(_e1806, _e1793, _e1991);
                                                                            phi_2896_ = select(_e1934, _e1933, _e1996);
                                                                            phi_2897_ = select(_e1942, _e1938, _e1996);
                                                                            phi_2898_ = select(_e1938, _e1946, _e1996);
                                                                            phi_2899_ = select(_e1946, _e1942, _e1996);
                                                                        }
                                                                        let _e2002 = phi_2892_;
                                                                        let _e2004 = phi_2893_;
                                                                        let _e2006 = phi_2894_;
                                                                        let _e2008 = phi_2895_;
                                                                        let _e2010 = phi_2896_;
                                                                        let _e2012 = phi_2897_;
                                                                        let _e2014 = phi_2898_;
                                                                        let _e2016 = phi_2899_;
                                                                        let _e2023 = ((_e2014.y * _e2012.z) - (_e2012.y * _e2014.z));
                                                                        let _e2028 = ((_e2014.z * _e2012.x) - (_e2012.z * _e2014.x));
                                                                        let _e2031 = ((_e2014.x * _e2012.y) - (_e2012.x * _e2014.y));
                                                                        if (_e1831 >= _e1835) {
                                                                            phi_2936_ = select(true, false, (_e1831 >= _e1839));
                                                                        } else {
                                                                            phi_2936_ = true;
                                                                        }
                                                                        let _e2036 = phi_2936_;
                                                                        if _e2036 {
                                                                            phi_2945_ = select(_e1934, _e1933, vec3((_e1835 >= _e1839)));
                                                                        } else {
                                                                            phi_2945_ = _e1932;
                                                                        }
                                                                        let _e2041 = phi_2945_;
                                                                        let _e2052 = (((_e2023 * (_e2041.x - _e478)) + (_e2028 * (_e2041.y - _e545))) + (_e2031 * (_e2041.z - _e611)));
                                                                        let _e2057 = (((_e2023 * _e518) + (_e2028 * _e584)) + (_e2031 * _e650));
                                                                        let _e2058 = (_e2004 - _e2008);
                                                                        let _e2059 = (_e2002 - _e2006);
                                                                        let _e2067 = (-(((_e2008 * _e2058) + (_e2006 * _e2059))) / ((_e2058 * _e2058) + (_e2059 * _e2059)));
                                                                        let _e2069 = select(1f, _e2067, (_e2067 < 1f));
                                                                        let _e2071 = select(0f, _e2069, (_e2069 > 0f));
                                                                        let _e2084 = ((_e2010.x + (_e2016.x * _e2071)) - _e478);
                                                                        let _e2085 = ((_e2010.y + (_e2016.y * _e2071)) - _e545);
                                                                        let _e2086 = ((_e2010.z + (_e2016.z * _e2071)) - _e611);
                                                                        let _e2087 = (_e2086 / _e650);
                                                                        let _e2099 = bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u));
                                                                        let _e2102 = bitcast<f32>((bitcast<u32>(_e2085) & 2147483647u));
                                                                        let _e2104 = select(_e2102, _e2099, (_e2099 > _e2102));
                                                                        let _e2107 = bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u));
                                                                        let _e2109 = select(_e2107, _e2104, (_e2104 > _e2107));
                                                                        let _e2115 = bitcast<f32>((bitcast<u32>(_e2023) & 2147483647u));
                                                                        let _e2118 = bitcast<f32>((bitcast<u32>(_e2028) & 2147483647u));
                                                                        let _e2120 = select(_e2118, _e2115, (_e2115 > _e2118));
                                                                        let _e2123 = bitcast<f32>((bitcast<u32>(_e2031) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e2023 * _e2084) + (_e2028 * _e2085)) + (_e2031 * _e2086)) - _e2052)) & 2147483647u)) <= ((0.0000009536743f * select(_e1989, _e2109, (_e2109 > _e1989))) * select(_e2123, _e2120, (_e2120 > _e2123)))) {
                                                                            let _e2133 = bitcast<f32>((bitcast<u32>(_e2014.x) & 2147483647u));
                                                                            let _e2136 = bitcast<f32>((bitcast<u32>(_e2014.y) & 2147483647u));
                                                                            let _e2138 = select(_e2136, _e2133, (_e2133 > _e2136));
                                                                            let _e2141 = bitcast<f32>((bitcast<u32>(_e2014.z) & 2147483647u));
                                                                            let _e2147 = bitcast<f32>((bitcast<u32>(_e2012.x) & 2147483647u));
                                                                            let _e2150 = bitcast<f32>((bitcast<u32>(_e2012.y) & 2147483647u));
                                                                            let _e2152 = select(_e2150, _e2147, (_e2147 > _e2150));
                                                                            let _e2155 = bitcast<f32>((bitcast<u32>(_e2012.z) & 2147483647u));
                                                                            let _e2159 = (bitcast<f32>((bitcast<u32>(_e2057) & 2147483647u)) > ((0.0000038146973f * select(_e2141, _e2138, (_e2138 > _e2141))) * select(_e2155, _e2152, (_e2152 > _e2155))));
                                                                            if _e2159 {
                                                                                phi_3110_ = (_e2052 / _e2057);
                                                                            } else {
                                                                                phi_3110_ = f32();
                                                                            }
                                                                            let _e2162 = phi_3110_;
                                                                            phi_3112_ = _e2162;
                                                                            phi_3113_ = select(true, false, _e2159);
                                                                        } else {
                                                                            phi_3112_ = f32();
                                                                            phi_3113_ = true;
                                                                        }
                                                                        let _e2165 = phi_3112_;
                                                                        let _e2167 = phi_3113_;
                                                                        if _e2167 {
                                                                            let _e2175 = (((_e2023 * (_e2084 - (_e518 * _e2087))) + (_e2028 * (_e2085 - (_e584 * _e2087)))) / _e2057);
                                                                            if (bitcast<f32>((bitcast<u32>(_e2175) & 2147483647u)) <= _e1989) {
                                                                                phi_3133_ = (_e2087 + _e2175);
                                                                            } else {
                                                                                phi_3133_ = _e2087;
                                                                            }
                                                                            let _e2182 = phi_3133_;
                                                                            phi_3134_ = _e2182;
                                                                        } else {
                                                                            phi_3134_ = _e2165;
                                                                        }
                                                                        let _e2184 = phi_3134_;
                                                                        let _e2186 = select(_e1922, _e2184, (_e2184 < _e1922));
                                                                        let _e2188 = select(_e1914, _e2186, (_e2186 > _e1914));
                                                                        if (_e2188 >= _e764) {
                                                                            let _e2190 = (_e2188 <= _e1322.member_1);
                                                                            if _e2190 {
                                                                                let _e2191 = (1f / _e1841);
                                                                                phi_3157_ = type_25(_e2188, (_e1835 * _e2191), (_e1839 * _e2191), _e1382);
                                                                            } else {
                                                                                phi_3157_ = type_25();
                                                                            }
                                                                            let _e2196 = phi_3157_;
                                                                            phi_3159_ = _e2196;
                                                                            phi_3160_ = select(true, false, _e2190);
                                                                        } else {
                                                                            phi_3159_ = type_25();
                                                                            phi_3160_ = true;
                                                                        }
                                                                        let _e2199 = phi_3159_;
                                                                        let _e2201 = phi_3160_;
                                                                        if _e2201 {
                                                                            phi_3164_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_3164_ = _e2199;
                                                                        }
                                                                        let _e2203 = phi_3164_;
                                                                        phi_3165_ = _e2203;
                                                                    }
                                                                    let _e2205 = phi_3165_;
                                                                    phi_3166_ = _e2205;
                                                                    phi_3167_ = _e1931;
                                                                }
                                                                let _e2207 = phi_3166_;
                                                                let _e2209 = phi_3167_;
                                                                phi_3171_ = _e2207;
                                                                phi_3172_ = _e2209;
                                                            }
                                                            let _e2211 = phi_3171_;
                                                            let _e2213 = phi_3172_;
                                                            phi_3173_ = _e2211;
                                                            phi_3174_ = _e1866;
                                                            phi_3175_ = _e2213;
                                                        }
                                                        let _e2215 = phi_3173_;
                                                        let _e2217 = phi_3174_;
                                                        let _e2219 = phi_3175_;
                                                        phi_3176_ = _e2215;
                                                        phi_3177_ = _e2217;
                                                        phi_3178_ = _e2219;
                                                    }
                                                    let _e2221 = phi_3176_;
                                                    let _e2223 = phi_3177_;
                                                    let _e2225 = phi_3178_;
                                                    phi_3186_ = _e2221;
                                                    phi_3187_ = select(_e2225, true, _e2223);
                                                } else {
                                                    phi_3186_ = type_25();
                                                    phi_3187_ = true;
                                                }
                                                let _e2228 = phi_3186_;
                                                let _e2230 = phi_3187_;
                                                if _e2230 {
                                                    phi_3191_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3191_ = _e2228;
                                                }
                                                let _e2232 = phi_3191_;
                                                if (_e2232.member_3 != 4294967295u) {
                                                    if (_e1382 == _e177) {
                                                        phi_3526_ = false;
                                                    } else {
                                                        let _e2236 = (_e1382 < arrayLength((&global_5.member)));
                                                        if _e2236 {
                                                            if _e2236 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e2238 = global_5.member[_e1382];
                                                            phi_3214_ = _e2238;
                                                        } else {
                                                            phi_3214_ = 4294967295u;
                                                        }
                                                        let _e2240 = phi_3214_;
                                                        let _e2241 = (_e2240 < arrayLength((&global_6.member)));
                                                        if _e2241 {
                                                            if _e2241 {
                                                            } else {
                                                                phi_5270_ = true;
                                                                break;
                                                            }
                                                            let _e2243 = global_6.member[_e2240];
                                                            phi_3228_ = _e2243;
                                                        } else {
                                                            phi_3228_ = 0i;
                                                        }
                                                        let _e2245 = phi_3228_;
                                                        let _e2246 = (_e2245 == 0i);
                                                        if _e2246 {
                                                            phi_3525_ = true;
                                                        } else {
                                                            if _e455 {
                                                                phi_3251_ = vec3<f32>(_e1769[0][0], _e1769[0][1], _e1769[0][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3250_ = vec3<f32>(_e1769[0][2], _e1769[0][0], _e1769[0][1]);
                                                                } else {
                                                                    phi_3250_ = vec3<f32>(_e1769[0][1], _e1769[0][2], _e1769[0][0]);
                                                                }
                                                                let _e2251 = phi_3250_;
                                                                phi_3251_ = _e2251;
                                                            }
                                                            let _e2254 = phi_3251_;
                                                            if _e455 {
                                                                phi_3270_ = vec3<f32>(_e1769[1][0], _e1769[1][1], _e1769[1][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3269_ = vec3<f32>(_e1769[1][2], _e1769[1][0], _e1769[1][1]);
                                                                } else {
                                                                    phi_3269_ = vec3<f32>(_e1769[1][1], _e1769[1][2], _e1769[1][0]);
                                                                }
                                                                let _e2259 = phi_3269_;
                                                                phi_3270_ = _e2259;
                                                            }
                                                            let _e2262 = phi_3270_;
                                                            if _e455 {
                                                                phi_3289_ = vec3<f32>(_e1769[2][0], _e1769[2][1], _e1769[2][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3288_ = vec3<f32>(_e1769[2][2], _e1769[2][0], _e1769[2][1]);
                                                                } else {
                                                                    phi_3288_ = vec3<f32>(_e1769[2][1], _e1769[2][2], _e1769[2][0]);
                                                                }
                                                                let _e2267 = phi_3288_;
                                                                phi_3289_ = _e2267;
                                                            }
                                                            let _e2270 = phi_3289_;
                                                            let _e2273 = (_e2262.x - _e2254.x);
                                                            let _e2276 = (_e2262.y - _e2254.y);
                                                            let _e2279 = (_e2262.z - _e2254.z);
                                                            let _e2281 = (_e2270.x - _e2254.x);
                                                            let _e2283 = (_e2270.y - _e2254.y);
                                                            let _e2285 = (_e2270.z - _e2254.z);
                                                            if (_e309.member_1 == 1u) {
                                                                phi_3325_ = (vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]) - _e2254);
                                                            } else {
                                                                phi_3325_ = vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]);
                                                            }
                                                            let _e2300 = phi_3325_;
                                                            let _e2306 = bitcast<f32>((bitcast<u32>((_e2273 * _e2283)) ^ _e309.member_3[0]));
                                                            let _e2310 = bitcast<f32>((bitcast<u32>((_e2276 * _e2281)) ^ _e309.member_3[0]));
                                                            let _e2314 = bitcast<f32>((bitcast<u32>((_e2276 * _e2285)) ^ _e309.member_3[0]));
                                                            let _e2318 = bitcast<f32>((bitcast<u32>((_e2279 * _e2283)) ^ _e309.member_3[0]));
                                                            let _e2322 = bitcast<f32>((bitcast<u32>((_e2279 * _e2281)) ^ _e309.member_3[0]));
                                                            let _e2326 = bitcast<f32>((bitcast<u32>((_e2273 * _e2285)) ^ _e309.member_3[0]));
                                                            let _e2327 = (_e2314 - _e2318);
                                                            let _e2328 = (_e2322 - _e2326);
                                                            let _e2329 = (_e2306 - _e2310);
                                                            let _e2353 = (bitcast<f32>((bitcast<u32>(_e2314) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2318) & 2147483647u)));
                                                            let _e2360 = (bitcast<f32>((bitcast<u32>(_e2322) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2326) & 2147483647u)));
                                                            let _e2367 = (bitcast<f32>((bitcast<u32>(_e2306) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2310) & 2147483647u)));
                                                            if (_e309.member_2 == 0f) {
                                                                phi_3507_ = 0f;
                                                            } else {
                                                                let _e2397 = bitcast<f32>((bitcast<u32>(_e2327) & 2147483647u));
                                                                let _e2400 = bitcast<f32>((bitcast<u32>(_e2328) & 2147483647u));
                                                                let _e2403 = bitcast<f32>((bitcast<u32>(_e2329) & 2147483647u));
                                                                let _e2405 = select(_e2403, _e2400, (_e2400 > _e2403));
                                                                let _e2409 = select(_e2403, _e2400, (_e2400 < _e2403));
                                                                let _e2413 = select(_e2400, _e2397, (_e2397 < _e2400));
                                                                let _e2415 = select(_e2400, _e2397, (_e2397 > _e2400));
                                                                let _e2417 = select(_e2403, _e2415, (_e2415 < _e2403));
                                                                phi_3507_ = bitcast<f32>((bitcast<u32>((_e309.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2405, _e2397, (_e2397 > _e2405)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2417, _e2413, (_e2413 > _e2417)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2409, _e2397, (_e2397 < _e2409)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2353 + _e2360) + _e2367))) ^ _e309.member_3[0]))) * 1.0000005f)) ^ _e309.member_3[0])))) ^ _e309.member_3[0]));
                                                            }
                                                            let _e2444 = phi_3507_;
                                                            phi_3525_ = (_e2246 || !(((((bitcast<f32>((bitcast<u32>((_e2300.x * _e2327)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2300.y * _e2328)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2300.z * _e2329)) ^ _e309.member_3[0]))) * f32(-(_e2245))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2300.x) & 2147483647u)) * _e2353)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2300.y) & 2147483647u)) * _e2360)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2300.z) & 2147483647u)) * _e2367)) ^ _e309.member_3[0]))))) ^ _e309.member_3[0])) + _e2444) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2458 = phi_3525_;
                                                        phi_3526_ = _e2458;
                                                    }
                                                    let _e2460 = phi_3526_;
                                                    if _e2460 {
                                                        if (_e2232.member < _e1322.member.member) {
                                                            phi_3546_ = true;
                                                        } else {
                                                            if (_e2232.member == _e1322.member.member) {
                                                                phi_3545_ = (_e2232.member_3 < _e1322.member.member_3);
                                                            } else {
                                                                phi_3545_ = false;
                                                            }
                                                            let _e2470 = phi_3545_;
                                                            phi_3546_ = _e2470;
                                                        }
                                                        let _e2472 = phi_3546_;
                                                        if _e2472 {
                                                            phi_3552_ = type_43(_e2232, _e2232.member);
                                                        } else {
                                                            phi_3552_ = _e1322;
                                                        }
                                                        let _e2475 = phi_3552_;
                                                        phi_3553_ = _e2475;
                                                    } else {
                                                        phi_3553_ = _e1322;
                                                    }
                                                    let _e2477 = phi_3553_;
                                                    phi_3554_ = _e2477;
                                                } else {
                                                    phi_3554_ = _e1322;
                                                }
                                                let _e2479 = phi_3554_;
                                                phi_1529_ = _e2479;
                                            } else {
                                                phi_1529_ = type_43();
                                            }
                                            let _e2481 = phi_1529_;
                                            continue;
                                            continuing {
                                                phi_1528_ = _e2481;
                                                phi_1531_ = _e1337;
                                                phi_5270_ = _e806;
                                                break if !(_e1343);
                                            }
                                        }
                                        let _e2484 = phi_5270_;
                                        phi_5509_ = _e2484;
                                        if _e2484 {
                                            break;
                                        }
                                        phi_5513_ = _e2484;
                                        let _e2851 = local_11;
                                        phi_4825_ = _e2851;
                                        phi_4826_ = false;
                                        phi_4827_ = _e849;
                                        phi_4828_ = _e851;
                                    } else {
                                        if (_e851.member_1 >= _e109) {
                                            phi_4360_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e851.member_1 < _e109) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e864 = ((1u + _e431) % 4u);
                                            if (_e864 < 4u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e869 = global_4.member[_e851.member_1][_e864];
                                            let _e871 = (_e869 >> bitcast<u32>(11u));
                                            let _e873 = ((1u + _e430) % 4u);
                                            if (_e873 < 4u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e878 = global_4.member[_e851.member_1][_e873];
                                            let _e880 = (_e878 >> bitcast<u32>(11u));
                                            let _e882 = ((1u + _e432) % 4u);
                                            if (_e882 < 4u) {
                                            } else {
                                                phi_5509_ = true;
                                                break;
                                            }
                                            let _e887 = global_4.member[_e851.member_1][_e882];
                                            let _e889 = (_e887 >> bitcast<u32>(11u));
                                            let _e912 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.x - _e851.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e913 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.y - _e851.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e914 = (bitcast<f32>((bitcast<u32>((_e851.member.member_1.z - _e851.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e916 = select(_e168, _e912, (_e912 > _e168));
                                            let _e918 = select(_e168, _e913, (_e913 > _e168));
                                            let _e920 = select(_e168, _e914, (_e914 > _e168));
                                            let _e951 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e869 & 1023u))) - 8388608f) * _e916));
                                            let _e956 = (bitcast<i32>((_e869 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e959 = bitcast<f32>((_e951 & bitcast<u32>(_e956)));
                                            let _e960 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e878 & 1023u))) - 8388608f) * _e918));
                                            let _e965 = (bitcast<i32>((_e878 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e968 = bitcast<f32>((_e960 & bitcast<u32>(_e965)));
                                            let _e969 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e887 & 1023u))) - 8388608f) * _e920));
                                            let _e974 = (bitcast<i32>((_e887 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e977 = bitcast<f32>((_e969 & bitcast<u32>(_e974)));
                                            let _e981 = bitcast<f32>((_e951 & bitcast<u32>(~(_e956))));
                                            let _e985 = bitcast<f32>((_e960 & bitcast<u32>(~(_e965))));
                                            let _e989 = bitcast<f32>((_e969 & bitcast<u32>(~(_e974))));
                                            let _e990 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e871 & 1023u))) - 8388608f) * _e916));
                                            let _e995 = (bitcast<i32>((_e871 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e998 = bitcast<f32>((_e990 & bitcast<u32>(_e995)));
                                            let _e999 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e880 & 1023u))) - 8388608f) * _e918));
                                            let _e1004 = (bitcast<i32>((_e880 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1007 = bitcast<f32>((_e999 & bitcast<u32>(_e1004)));
                                            let _e1008 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e889 & 1023u))) - 8388608f) * _e920));
                                            let _e1013 = (bitcast<i32>((_e889 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1016 = bitcast<f32>((_e1008 & bitcast<u32>(_e1013)));
                                            let _e1020 = bitcast<f32>((_e990 & bitcast<u32>(~(_e995))));
                                            let _e1024 = bitcast<f32>((_e999 & bitcast<u32>(~(_e1004))));
                                            let _e1028 = bitcast<f32>((_e1008 & bitcast<u32>(~(_e1013))));
                                            let _e1029 = (_e851.member.member.x + _e959);
                                            let _e1030 = (_e851.member.member.y + _e968);
                                            let _e1031 = (_e851.member.member.z + _e977);
                                            let _e1034 = (_e851.member.member_1.x - _e998);
                                            let _e1035 = (_e851.member.member_1.y - _e1007);
                                            let _e1036 = (_e851.member.member_1.z - _e1016);
                                            let _e1055 = (_e1034 - _e1029);
                                            let _e1056 = (_e1035 - _e1030);
                                            let _e1057 = (_e1036 - _e1031);
                                            let _e1059 = select(_e1056, _e1055, (_e1055 > _e1056));
                                            let _e1061 = select(_e1057, _e1059, (_e1059 > _e1057));
                                            if (_e1061 < (1024f * _e168)) {
                                                phi_4061_ = 0u;
                                            } else {
                                                phi_4061_ = select(2u, 1u, (_e1061 < (2097152f * _e168)));
                                            }
                                            let _e1068 = phi_4061_;
                                            switch bitcast<i32>(_e1068) {
                                                case 0: {
                                                    phi_4067_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_4067_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_4067_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_4067_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1071 = phi_4067_;
                                            let _e1077 = global_4.member[_e851.member_1][0u];
                                            let _e1081 = global_4.member[_e851.member_1][1u];
                                            let _e1085 = global_4.member[_e851.member_1][2u];
                                            let _e1089 = global_4.member[_e851.member_1][3u];
                                            let _e1101 = (((_e1081 >> bitcast<u32>(22i)) | ((_e1085 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1089 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1102 = (_e1077 & 268435455u);
                                            let _e1103 = (_e1101 & 268435455u);
                                            let _e1106 = ((_e1077 >> bitcast<u32>(28u)) & 7u);
                                            let _e1114 = ((_e1077 >> bitcast<u32>(31i)) | (((_e1101 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1115 = (_e1106 != 0u);
                                            if (_e1106 == 0u) {
                                                phi_4322_ = _e1102;
                                            } else {
                                                if (_e1106 == 7u) {
                                                    phi_4321_ = 2147483648u;
                                                } else {
                                                    phi_4321_ = ((2147483648u | (_e1106 << bitcast<u32>(28u))) | (_e1103 & 268435455u));
                                                }
                                                let _e1124 = phi_4321_;
                                                phi_4322_ = _e1124;
                                            }
                                            let _e1126 = phi_4322_;
                                            if _e1115 {
                                                let _e1127 = (_e1106 != 7u);
                                                if _e1127 {
                                                    phi_4332_ = (_e1103 + (_e1106 * ((3u * _e1071) + 1u)));
                                                } else {
                                                    phi_4332_ = u32();
                                                }
                                                let _e1131 = phi_4332_;
                                                phi_4334_ = _e1131;
                                                phi_4335_ = select(true, false, _e1127);
                                            } else {
                                                phi_4334_ = u32();
                                                phi_4335_ = true;
                                            }
                                            let _e1134 = phi_4334_;
                                            let _e1136 = phi_4335_;
                                            if (_e1114 == 0u) {
                                                phi_4356_ = (_e1102 + select(0u, 1u, !(_e1115)));
                                            } else {
                                                if (_e1114 == 7u) {
                                                    phi_4355_ = 2147483648u;
                                                } else {
                                                    phi_4355_ = ((2147483648u | (_e1114 << bitcast<u32>(28u))) | (select(_e1134, _e1103, _e1136) & 268435455u));
                                                }
                                                let _e1149 = phi_4355_;
                                                phi_4356_ = _e1149;
                                            }
                                            let _e1151 = phi_4356_;
                                            phi_4360_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e1029, (_e851.member.member.x + _e981), _e1034, (_e851.member.member_1.x - _e1020)), vec4<f32>(_e1030, (_e851.member.member.y + _e985), _e1035, (_e851.member.member_1.y - _e1024)), vec4<f32>(_e1031, (_e851.member.member.z + _e989), _e1036, (_e851.member.member_1.z - _e1028))), type_57(type_37((_e851.member.member + vec4<f32>(_e959, _e968, _e977, 0f)), (_e851.member.member_1 - vec4<f32>(_e998, _e1007, _e1016, 0f))), _e1126), type_57(type_37((_e851.member.member + vec4<f32>(_e981, _e985, _e989, 0f)), (_e851.member.member_1 - vec4<f32>(_e1020, _e1024, _e1028, 0f))), _e1151));
                                        }
                                        let _e1156 = phi_4360_;
                                        let _e1168 = ((_e1156.member[0].x - _e516) * _e521);
                                        let _e1169 = ((_e1156.member[0].y - _e516) * _e521);
                                        let _e1170 = ((_e1156.member[0].z - _e517) * _e521);
                                        let _e1171 = ((_e1156.member[0].w - _e517) * _e521);
                                        let _e1181 = ((_e1156.member[1].x - _e582) * _e587);
                                        let _e1182 = ((_e1156.member[1].y - _e582) * _e587);
                                        let _e1183 = ((_e1156.member[1].z - _e583) * _e587);
                                        let _e1184 = ((_e1156.member[1].w - _e583) * _e587);
                                        let _e1194 = ((_e1156.member[2].x - _e648) * _e653);
                                        let _e1195 = ((_e1156.member[2].y - _e648) * _e653);
                                        let _e1196 = ((_e1156.member[2].z - _e649) * _e653);
                                        let _e1197 = ((_e1156.member[2].w - _e649) * _e653);
                                        let _e1199 = select(_e1196, _e1194, (_e1194 < _e1196));
                                        let _e1201 = select(_e1197, _e1195, (_e1195 < _e1197));
                                        let _e1203 = select(_e1196, _e1194, (_e1194 > _e1196));
                                        let _e1205 = select(_e1197, _e1195, (_e1195 > _e1197));
                                        let _e1207 = select(_e1170, _e1168, (_e1168 < _e1170));
                                        let _e1209 = select(_e1171, _e1169, (_e1169 < _e1171));
                                        let _e1211 = select(_e1183, _e1181, (_e1181 < _e1183));
                                        let _e1213 = select(_e1184, _e1182, (_e1182 < _e1184));
                                        let _e1215 = select(_e1211, _e1207, (_e1207 > _e1211));
                                        let _e1217 = select(_e1213, _e1209, (_e1209 > _e1213));
                                        let _e1219 = select(_e1199, _e1215, (_e1215 > _e1199));
                                        let _e1221 = select(_e1201, _e1217, (_e1217 > _e1201));
                                        let _e1223 = select(_e1170, _e1168, (_e1168 > _e1170));
                                        let _e1225 = select(_e1171, _e1169, (_e1169 > _e1171));
                                        let _e1227 = select(_e1183, _e1181, (_e1181 > _e1183));
                                        let _e1229 = select(_e1184, _e1182, (_e1182 > _e1184));
                                        let _e1231 = select(_e1227, _e1223, (_e1223 < _e1227));
                                        let _e1233 = select(_e1229, _e1225, (_e1225 < _e1229));
                                        let _e1238 = -(_e1199);
                                        let _e1239 = -(_e1201);
                                        let _e1246 = (select(_e1203, _e1231, (_e1231 < _e1203)) + (select(_e1238, _e1203, (_e1203 > _e1238)) * 0.0000019073523f));
                                        let _e1247 = (select(_e1205, _e1233, (_e1233 < _e1205)) + (select(_e1239, _e1205, (_e1205 > _e1239)) * 0.0000019073523f));
                                        let _e1249 = select(_e764, _e1219, (_e1219 > _e764));
                                        let _e1251 = select(_e764, _e1221, (_e1221 > _e764));
                                        let _e1256 = (_e1249 <= select(_e808.member_1, _e1246, (_e1246 < _e808.member_1)));
                                        let _e1257 = (_e1251 <= select(_e808.member_1, _e1247, (_e1247 < _e808.member_1)));
                                        let _e1258 = (_e1249 <= _e1251);
                                        if _e1256 {
                                            if _e1257 {
                                                if _e1258 {
                                                    phi_4722_ = _e1156.member_2;
                                                } else {
                                                    phi_4722_ = _e1156.member_1;
                                                }
                                                let _e1262 = phi_4722_;
                                                let _e1284 = (_e849 % 128u);
                                                let _e1285 = (_e1284 < 128u);
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_8[_e1284] = _e1262.member_1;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_7[_e1284] = _e1262.member.member.x;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_6[_e1284] = _e1262.member.member.y;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_5[_e1284] = _e1262.member.member.z;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_4[_e1284] = _e1262.member.member_1.x;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_3[_e1284] = _e1262.member.member_1.y;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_2[_e1284] = _e1262.member.member_1.z;
                                                if _e1285 {
                                                } else {
                                                    phi_5509_ = true;
                                                    break;
                                                }
                                                local_9[_e1284] = select(_e1251, _e1249, !(_e1258));
                                                if _e1258 {
                                                    phi_4799_ = _e1156.member_1;
                                                } else {
                                                    phi_4799_ = _e1156.member_2;
                                                }
                                                let _e1298 = phi_4799_;
                                                phi_4800_ = (_e849 + 1u);
                                                phi_4801_ = _e1298;
                                            } else {
                                                phi_4800_ = u32();
                                                phi_4801_ = type_57();
                                            }
                                            let _e1300 = phi_4800_;
                                            let _e1302 = phi_4801_;
                                            phi_4803_ = _e1300;
                                            phi_4804_ = _e1302;
                                            phi_4805_ = select(true, false, _e1257);
                                        } else {
                                            phi_4803_ = u32();
                                            phi_4804_ = type_57();
                                            phi_4805_ = true;
                                        }
                                        let _e1305 = phi_4803_;
                                        let _e1307 = phi_4804_;
                                        let _e1309 = phi_4805_;
                                        if _e1309 {
                                            if _e1256 {
                                                phi_4814_ = _e1156.member_1;
                                            } else {
                                                phi_4814_ = _e1156.member_2;
                                            }
                                            let _e1313 = phi_4814_;
                                            phi_4819_ = select(_e1257, true, _e1256);
                                            phi_4821_ = _e1313;
                                        } else {
                                            phi_4819_ = _e847;
                                            phi_4821_ = _e1307;
                                        }
                                        let _e1316 = phi_4819_;
                                        let _e1318 = phi_4821_;
                                        phi_5513_ = _e806;
                                        phi_4825_ = _e808;
                                        phi_4826_ = _e1316;
                                        phi_4827_ = select(_e1305, _e849, _e1309);
                                        phi_4828_ = _e1318;
                                    }
                                    let _e2486 = phi_5513_;
                                    let _e2488 = phi_4825_;
                                    let _e2490 = phi_4826_;
                                    let _e2492 = phi_4827_;
                                    let _e2494 = phi_4828_;
                                    phi_5512_ = _e2486;
                                    phi_4829_ = _e2488;
                                    phi_4830_ = _e2490;
                                    phi_4831_ = (_e812 - 1u);
                                    phi_4832_ = _e2492;
                                    phi_4833_ = _e2494;
                                } else {
                                    phi_5512_ = _e806;
                                    phi_4829_ = _e808;
                                    phi_4830_ = _e847;
                                    phi_4831_ = _e812;
                                    phi_4832_ = _e849;
                                    phi_4833_ = _e851;
                                }
                                let _e2496 = phi_5512_;
                                let _e2498 = phi_4829_;
                                let _e2500 = phi_4830_;
                                let _e2502 = phi_4831_;
                                let _e2504 = phi_4832_;
                                let _e2506 = phi_4833_;
                                phi_5511_ = _e2496;
                                phi_4834_ = _e2498;
                                phi_4835_ = _e2500;
                                phi_4836_ = _e2502;
                                phi_4837_ = _e2504;
                                phi_4838_ = _e2506;
                            } else {
                                phi_5511_ = _e806;
                                phi_4834_ = type_43();
                                phi_4835_ = bool();
                                phi_4836_ = u32();
                                phi_4837_ = u32();
                                phi_4838_ = type_57();
                            }
                            let _e2508 = phi_5511_;
                            let _e2510 = phi_4834_;
                            let _e2512 = phi_4835_;
                            let _e2514 = phi_4836_;
                            let _e2516 = phi_4837_;
                            let _e2518 = phi_4838_;
                            phi_5510_ = _e2508;
                            phi_1402_ = _e2510;
                            phi_1405_ = _e2512;
                            phi_1407_ = _e2514;
                            phi_1409_ = _e2516;
                            phi_1411_ = _e2518;
                            phi_4839_ = _e820;
                        } else {
                            phi_5510_ = _e806;
                            phi_1402_ = type_43();
                            phi_1405_ = bool();
                            phi_1407_ = u32();
                            phi_1409_ = u32();
                            phi_1411_ = type_57();
                            phi_4839_ = false;
                        }
                        let _e2520 = phi_5510_;
                        let _e2522 = phi_1402_;
                        let _e2524 = phi_1405_;
                        let _e2526 = phi_1407_;
                        let _e2528 = phi_1409_;
                        let _e2530 = phi_1411_;
                        let _e2532 = phi_4839_;
                        continue;
                        continuing {
                            phi_5276_ = _e2520;
                            phi_1401_ = _e2522;
                            phi_1404_ = _e2524;
                            phi_1406_ = _e2526;
                            phi_1408_ = _e2528;
                            phi_1410_ = _e2530;
                            phi_5509_ = _e2520;
                            break if !(_e2532);
                        }
                    }
                    let _e2535 = phi_5509_;
                    if _e2535 {
                        break;
                    }
                    let _e2537 = local_10;
                    if (_e2537.member.member_3 != 4294967295u) {
                        let _e2542 = bitcast<u32>(_e2537.member.member);
                        let _e2546 = (bitcast<i32>((_e2542 >> bitcast<u32>(23i))) & 255i);
                        let _e2547 = (_e2546 + _e433);
                        if (_e2546 == 255i) {
                            phi_4898_ = _e2537.member.member;
                        } else {
                            if (_e2546 > 0i) {
                                if (_e2547 > 0i) {
                                    let _e2551 = (_e2547 < 255i);
                                    if _e2551 {
                                        phi_4877_ = bitcast<f32>((_e2542 + bitcast<u32>((_e433 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4877_ = f32();
                                    }
                                    let _e2558 = phi_4877_;
                                    phi_4879_ = _e2558;
                                    phi_4880_ = select(true, false, _e2551);
                                } else {
                                    phi_4879_ = f32();
                                    phi_4880_ = true;
                                }
                                let _e2561 = phi_4879_;
                                let _e2563 = phi_4880_;
                                phi_4881_ = _e2561;
                                phi_4882_ = _e2563;
                            } else {
                                phi_4881_ = f32();
                                phi_4882_ = true;
                            }
                            let _e2565 = phi_4881_;
                            let _e2567 = phi_4882_;
                            if _e2567 {
                                let _e2568 = (_e2542 & 2147483648u);
                                let _e2575 = ((_e2542 & 8388607u) | (select(0u, 1u, ((_e2542 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2579 = (_e2575 == 0u);
                                if _e2579 {
                                    phi_5228_ = bitcast<f32>(_e2568);
                                } else {
                                    let _e2584 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2575)), 32u, _e2579) - 8u);
                                    let _e2587 = (_e2575 << bitcast<u32>((_e2584 & 31u)));
                                    let _e2589 = ((_e2547 + select(0i, 1i, (_e2546 == 0i))) - bitcast<i32>(_e2584));
                                    if (_e2589 >= 255i) {
                                        phi_5218_ = bitcast<f32>((_e2568 | 2139095040u));
                                        phi_5219_ = f32();
                                        phi_5220_ = true;
                                    } else {
                                        let _e2591 = (_e2589 > 0i);
                                        if _e2591 {
                                            phi_5212_ = bitcast<f32>(((_e2568 | (bitcast<u32>(_e2589) << bitcast<u32>(23i))) | (_e2587 & 8388607u)));
                                            phi_5213_ = f32();
                                        } else {
                                            if (_e2589 < -24i) {
                                                phi_5178_ = 26u;
                                            } else {
                                                phi_5178_ = bitcast<u32>((1i - _e2589));
                                            }
                                            let _e2596 = phi_5178_;
                                            let _e2597 = (_e2596 & 31u);
                                            let _e2599 = (_e2587 >> bitcast<u32>(_e2597));
                                            let _e2603 = (_e2587 & ((1u << bitcast<u32>(_e2597)) - 1u));
                                            let _e2607 = (1u << bitcast<u32>(((_e2596 - 1u) & 31u)));
                                            if (_e2603 > _e2607) {
                                                phi_5199_ = true;
                                            } else {
                                                if (_e2603 == _e2607) {
                                                    phi_5196_ = ((_e2599 & 1u) == 1u);
                                                } else {
                                                    phi_5196_ = false;
                                                }
                                                let _e2613 = phi_5196_;
                                                phi_5199_ = _e2613;
                                            }
                                            let _e2615 = phi_5199_;
                                            phi_5212_ = f32();
                                            phi_5213_ = bitcast<f32>((_e2568 | (_e2599 + select(0u, 1u, _e2615))));
                                        }
                                        let _e2628 = phi_5212_;
                                        let _e2630 = phi_5213_;
                                        phi_5218_ = _e2628;
                                        phi_5219_ = _e2630;
                                        phi_5220_ = _e2591;
                                    }
                                    let _e2634 = phi_5218_;
                                    let _e2636 = phi_5219_;
                                    let _e2638 = phi_5220_;
                                    phi_5228_ = select(_e2636, _e2634, _e2638);
                                }
                                let _e2642 = phi_5228_;
                                phi_4897_ = _e2642;
                            } else {
                                phi_4897_ = _e2565;
                            }
                            let _e2644 = phi_4897_;
                            phi_4898_ = _e2644;
                        }
                        let _e2646 = phi_4898_;
                        let _e2647 = bitcast<u32>(_e2646);
                        if ((_e2647 & 2147483647u) >= 2139095040u) {
                            phi_4910_ = bitcast<f32>(((_e2647 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4910_ = _e2646;
                        }
                        let _e2654 = phi_4910_;
                        phi_4915_ = type_25(_e2654, _e2537.member.member_1, _e2537.member.member_2, _e2537.member.member_3);
                    } else {
                        phi_4915_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2659 = phi_4915_;
                    if _e310 {
                    } else {
                        break;
                    }
                    global_8.member[_e156] = _e2659;
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e2663 = select(0u, 1u, (_e377 <= _e387));
                    if (_e2663 > 0u) {
                        let _e2665 = (1u < _e124);
                        if _e2665 {
                            if (0u < _e124) {
                            } else {
                                break;
                            }
                            let _e2669 = atomicAdd((&global_9.member[0u]), _e2663);
                            if ((_e2669 + _e2663) < _e2669) {
                                if _e2665 {
                                } else {
                                    break;
                                }
                                let _e2674 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2677 = select(0u, 1u, (_e2659.member_3 != 4294967295u));
                    if (_e2677 > 0u) {
                        let _e2679 = (3u < _e124);
                        if _e2679 {
                            if (2u < _e124) {
                            } else {
                                break;
                            }
                            let _e2683 = atomicAdd((&global_9.member[2u]), _e2677);
                            if ((_e2683 + _e2677) < _e2683) {
                                if _e2679 {
                                } else {
                                    break;
                                }
                                let _e2688 = atomicAdd((&global_9.member[3u]), 1u);
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
