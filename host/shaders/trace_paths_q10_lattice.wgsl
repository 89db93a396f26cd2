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

struct type_58 {
    member: type_37,
    member_1: u32,
}

struct type_59 {
    member: array<vec4<f32>, 3>,
    member_1: type_58,
    member_2: type_58,
}

struct type_64 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_64;
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
    var phi_442_: u32;
    var phi_486_: i32;
    var phi_626_: type_39;
    var phi_732_: i32;
    var phi_733_: i32;
    var phi_743_: bool;
    var phi_753_: u32;
    var phi_754_: u32;
    var phi_756_: bool;
    var phi_761_: u32;
    var phi_794_: i32;
    var phi_812_: f32;
    var phi_818_: f32;
    var phi_858_: f32;
    var phi_864_: f32;
    var phi_937_: f32;
    var phi_943_: f32;
    var phi_983_: f32;
    var phi_989_: f32;
    var phi_1062_: f32;
    var phi_1068_: f32;
    var phi_1108_: f32;
    var phi_1114_: f32;
    var phi_1233_: i32;
    var phi_1255_: u32;
    var phi_1256_: u32;
    var phi_1293_: i32;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_5377_: bool;
    var phi_1421_: type_43;
    var phi_1424_: u32;
    var phi_1426_: bool;
    var phi_1428_: u32;
    var phi_1430_: type_58;
    var phi_1441_: bool;
    var phi_1527_: bool;
    var phi_1528_: u32;
    var phi_1529_: type_58;
    var phi_1548_: type_43;
    var phi_1551_: type_8;
    var phi_1552_: type_8;
    var phi_1574_: type_8;
    var phi_1615_: u32;
    var phi_1621_: u32;
    var phi_1631_: u32;
    var phi_1647_: u32;
    var phi_1680_: u32;
    var phi_1686_: u32;
    var phi_2152_: u32;
    var phi_2170_: u32;
    var phi_2188_: u32;
    var phi_2211_: u32;
    var phi_2229_: u32;
    var phi_2247_: u32;
    var phi_2270_: u32;
    var phi_2288_: u32;
    var phi_2306_: u32;
    var phi_1860_: u32;
    var phi_1875_: u32;
    var phi_1885_: u32;
    var phi_1906_: u32;
    var phi_1927_: u32;
    var phi_1957_: u32;
    var phi_1972_: u32;
    var phi_1982_: u32;
    var phi_2003_: u32;
    var phi_2024_: u32;
    var phi_2054_: u32;
    var phi_2069_: u32;
    var phi_2079_: u32;
    var phi_2100_: u32;
    var phi_2121_: u32;
    var phi_1713_: u32;
    var phi_1762_: u32;
    var phi_1811_: u32;
    var phi_2312_: array<array<f32, 3>, 3>;
    var phi_4938_: bool;
    var phi_4953_: bool;
    var phi_4968_: bool;
    var phi_4983_: bool;
    var phi_4998_: bool;
    var phi_5013_: bool;
    var phi_2854_: f32;
    var phi_2855_: f32;
    var phi_2856_: f32;
    var phi_2857_: f32;
    var phi_2858_: vec3<f32>;
    var phi_2859_: vec3<f32>;
    var phi_2860_: vec3<f32>;
    var phi_2861_: vec3<f32>;
    var phi_5028_: bool;
    var phi_5043_: bool;
    var phi_5058_: bool;
    var phi_5073_: bool;
    var phi_5088_: bool;
    var phi_5103_: bool;
    var phi_3069_: f32;
    var phi_3089_: type_46;
    var phi_3090_: type_46;
    var phi_3093_: type_46;
    var phi_3094_: type_46;
    var phi_3095_: bool;
    var phi_3099_: type_46;
    var phi_3108_: type_25;
    var phi_3131_: u32;
    var phi_3145_: i32;
    var phi_3167_: vec3<f32>;
    var phi_3168_: vec3<f32>;
    var phi_3186_: vec3<f32>;
    var phi_3187_: vec3<f32>;
    var phi_3205_: vec3<f32>;
    var phi_3206_: vec3<f32>;
    var phi_3242_: vec3<f32>;
    var phi_3424_: f32;
    var phi_3442_: bool;
    var phi_3443_: bool;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3469_: type_43;
    var phi_3470_: type_43;
    var phi_3471_: type_43;
    var phi_1549_: type_43;
    var phi_5371_: bool;
    var phi_5706_: bool;
    var phi_3472_: type_43;
    var phi_3974_: u32;
    var phi_3980_: u32;
    var phi_4234_: u32;
    var phi_4235_: u32;
    var phi_4245_: u32;
    var phi_4247_: u32;
    var phi_4248_: bool;
    var phi_4268_: u32;
    var phi_4269_: u32;
    var phi_4273_: type_59;
    var phi_4635_: type_58;
    var phi_4711_: type_58;
    var phi_4712_: u32;
    var phi_4713_: type_58;
    var phi_4715_: u32;
    var phi_4716_: type_58;
    var phi_4717_: bool;
    var phi_4726_: type_58;
    var phi_4731_: bool;
    var phi_4733_: type_58;
    var phi_4737_: bool;
    var phi_4738_: u32;
    var phi_4739_: type_58;
    var phi_4749_: type_58;
    var phi_5618_: bool;
    var phi_4750_: type_43;
    var phi_4751_: u32;
    var phi_4752_: bool;
    var phi_4753_: u32;
    var phi_4754_: type_58;
    var phi_5617_: bool;
    var phi_4755_: type_43;
    var phi_4756_: u32;
    var phi_4757_: bool;
    var phi_4758_: u32;
    var phi_4759_: type_58;
    var phi_5616_: bool;
    var phi_1422_: type_43;
    var phi_1425_: u32;
    var phi_1427_: bool;
    var phi_1429_: u32;
    var phi_1431_: type_58;
    var phi_4760_: bool;
    var phi_5615_: bool;
    var local_10: type_43;
    var phi_4798_: f32;
    var phi_4800_: f32;
    var phi_4801_: bool;
    var phi_4802_: f32;
    var phi_4803_: bool;
    var phi_5279_: u32;
    var phi_5297_: bool;
    var phi_5300_: bool;
    var phi_5313_: f32;
    var phi_5314_: f32;
    var phi_5319_: f32;
    var phi_5320_: f32;
    var phi_5321_: bool;
    var phi_5329_: f32;
    var phi_4818_: f32;
    var phi_4819_: f32;
    var phi_4831_: f32;
    var phi_4836_: type_25;
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
                phi_442_ = _e175;
            } else {
                phi_442_ = 4294967295u;
            }
            let _e177 = phi_442_;
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
                phi_486_ = -126i;
            } else {
                phi_486_ = select(_e220, 127i, (_e220 > 127i));
            }
            let _e225 = phi_486_;
            let _e230 = bitcast<f32>((bitcast<u32>((_e225 + 127i)) << bitcast<u32>(23i)));
            let _e236 = bitcast<f32>((bitcast<u32>(((_e220 - _e225) + 127i)) << bitcast<u32>(23i)));
            if (_e196 == 0u) {
                phi_626_ = type_39(array<f32, 3>(_e213, _e214, _e215), _e196, _e217, _e218);
            } else {
                let _e238 = bitcast<u32>(_e213);
                let _e240 = ((_e238 & 2139095040u) != 0u);
                let _e255 = bitcast<u32>(_e214);
                let _e257 = ((_e255 & 2139095040u) != 0u);
                let _e272 = bitcast<u32>(_e215);
                let _e274 = ((_e272 & 2139095040u) != 0u);
                let _e290 = bitcast<u32>(_e217);
                let _e292 = ((_e290 & 2139095040u) != 0u);
                phi_626_ = type_39(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e238 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e238 & 2147483648u))), _e213, _e240) * _e230) * select(0.00000011920929f, 1f, _e240)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e255 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e255 & 2147483648u))), _e214, _e257) * _e230) * select(0.00000011920929f, 1f, _e257)) * _e236), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e272 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e272 & 2147483648u))), _e215, _e274) * _e230) * select(0.00000011920929f, 1f, _e274)) * _e236)), _e196, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e290 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e290 & 2147483648u))), _e217, _e292) * _e230) * select(0.00000011920929f, 1f, _e292)) * _e236), _e218);
            }
            let _e309 = phi_626_;
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
                            phi_732_ = (bitcast<i32>((_e396 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_732_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e396)), 32u, (_e396 == 0u))));
                        }
                        let _e410 = phi_732_;
                        phi_733_ = _e410;
                    } else {
                        phi_733_ = 0i;
                    }
                    let _e412 = phi_733_;
                    let _e413 = (_e322 == _e366);
                    if _e413 {
                        phi_743_ = true;
                    } else {
                        phi_743_ = (_e330 == _e366);
                    }
                    let _e416 = phi_743_;
                    let _e417 = select(1u, 0u, _e413);
                    if _e416 {
                        let _e418 = (_e417 + 1u);
                        phi_753_ = _e418;
                        phi_754_ = _e418;
                        phi_756_ = select(true, false, (_e418 == 2u));
                    } else {
                        phi_753_ = u32();
                        phi_754_ = 0u;
                        phi_756_ = true;
                    }
                    let _e422 = phi_753_;
                    let _e424 = phi_754_;
                    let _e426 = phi_756_;
                    if _e426 {
                        phi_761_ = (_e424 + 1u);
                    } else {
                        phi_761_ = 0u;
                    }
                    let _e430 = phi_761_;
                    let _e431 = select(_e422, _e424, _e426);
                    let _e432 = select(_e417, select(2u, _e417, _e416), _e426);
                    let _e433 = -(_e412);
                    if (_e433 < -126i) {
                        phi_794_ = -126i;
                    } else {
                        phi_794_ = select(_e433, 127i, (_e433 > 127i));
                    }
                    let _e438 = phi_794_;
                    let _e443 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                    let _e449 = bitcast<f32>((bitcast<u32>(((_e433 - _e438) + 127i)) << bitcast<u32>(23i)));
                    let _e454 = global_7.member[_e156].member.member;
                    let _e455 = (_e431 == 0u);
                    if _e455 {
                        phi_812_ = _e454[0];
                    } else {
                        phi_812_ = _e454[1];
                    }
                    let _e459 = phi_812_;
                    let _e460 = (_e431 == 2u);
                    if _e460 {
                        phi_818_ = _e454[2];
                    } else {
                        phi_818_ = _e459;
                    }
                    let _e463 = phi_818_;
                    let _e464 = bitcast<u32>(_e463);
                    let _e466 = ((_e464 & 2139095040u) != 0u);
                    let _e478 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e464 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e464 & 2147483648u))), _e463, _e466) * select(0.00000011920929f, 1f, _e466));
                    let _e479 = global_7.member[_e156].member.member_2;
                    if _e455 {
                        phi_858_ = _e479[0];
                    } else {
                        phi_858_ = _e479[1];
                    }
                    let _e483 = phi_858_;
                    if _e460 {
                        phi_864_ = _e479[2];
                    } else {
                        phi_864_ = _e483;
                    }
                    let _e486 = phi_864_;
                    let _e487 = bitcast<u32>(_e486);
                    let _e489 = ((_e487 & 2139095040u) != 0u);
                    let _e503 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e487 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e487 & 2147483648u))), _e486, _e489) * _e443) * select(0.00000011920929f, 1f, _e489)) * _e449);
                    let _e507 = (bitcast<f32>((bitcast<u32>(_e503) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e510 = bitcast<f32>((bitcast<u32>(_e478) & 2147483647u));
                    let _e511 = (_e510 * 0.00000011920929f);
                    let _e514 = select(select(0.00000000000011368684f, _e511, (_e511 > 0.00000000000011368684f)), 0f, _e507);
                    let _e515 = select(0f, _e503, _e507);
                    let _e516 = (_e478 + _e514);
                    let _e517 = (_e478 - _e514);
                    let _e519 = select(38685626000000000000000000f, (1f / _e503), _e507);
                    let _e520 = (_e430 == 0u);
                    if _e520 {
                        phi_937_ = _e454[0];
                    } else {
                        phi_937_ = _e454[1];
                    }
                    let _e524 = phi_937_;
                    let _e525 = (_e430 == 2u);
                    if _e525 {
                        phi_943_ = _e454[2];
                    } else {
                        phi_943_ = _e524;
                    }
                    let _e528 = phi_943_;
                    let _e529 = bitcast<u32>(_e528);
                    let _e531 = ((_e529 & 2139095040u) != 0u);
                    let _e543 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e529 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e529 & 2147483648u))), _e528, _e531) * select(0.00000011920929f, 1f, _e531));
                    if _e520 {
                        phi_983_ = _e479[0];
                    } else {
                        phi_983_ = _e479[1];
                    }
                    let _e547 = phi_983_;
                    if _e525 {
                        phi_989_ = _e479[2];
                    } else {
                        phi_989_ = _e547;
                    }
                    let _e550 = phi_989_;
                    let _e551 = bitcast<u32>(_e550);
                    let _e553 = ((_e551 & 2139095040u) != 0u);
                    let _e567 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e551 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e551 & 2147483648u))), _e550, _e553) * _e443) * select(0.00000011920929f, 1f, _e553)) * _e449);
                    let _e571 = (bitcast<f32>((bitcast<u32>(_e567) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e574 = bitcast<f32>((bitcast<u32>(_e543) & 2147483647u));
                    let _e575 = (_e574 * 0.00000011920929f);
                    let _e578 = select(select(0.00000000000011368684f, _e575, (_e575 > 0.00000000000011368684f)), 0f, _e571);
                    let _e579 = select(0f, _e567, _e571);
                    let _e580 = (_e543 + _e578);
                    let _e581 = (_e543 - _e578);
                    let _e583 = select(38685626000000000000000000f, (1f / _e567), _e571);
                    let _e584 = (_e432 == 0u);
                    if _e584 {
                        phi_1062_ = _e454[0];
                    } else {
                        phi_1062_ = _e454[1];
                    }
                    let _e588 = phi_1062_;
                    let _e589 = (_e432 == 2u);
                    if _e589 {
                        phi_1068_ = _e454[2];
                    } else {
                        phi_1068_ = _e588;
                    }
                    let _e592 = phi_1068_;
                    let _e593 = bitcast<u32>(_e592);
                    let _e595 = ((_e593 & 2139095040u) != 0u);
                    let _e607 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e593 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e593 & 2147483648u))), _e592, _e595) * select(0.00000011920929f, 1f, _e595));
                    if _e584 {
                        phi_1108_ = _e479[0];
                    } else {
                        phi_1108_ = _e479[1];
                    }
                    let _e611 = phi_1108_;
                    if _e589 {
                        phi_1114_ = _e479[2];
                    } else {
                        phi_1114_ = _e611;
                    }
                    let _e614 = phi_1114_;
                    let _e615 = bitcast<u32>(_e614);
                    let _e617 = ((_e615 & 2139095040u) != 0u);
                    let _e631 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e615 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e615 & 2147483648u))), _e614, _e617) * _e443) * select(0.00000011920929f, 1f, _e617)) * _e449);
                    let _e635 = (bitcast<f32>((bitcast<u32>(_e631) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e638 = bitcast<f32>((bitcast<u32>(_e607) & 2147483647u));
                    let _e639 = (_e638 * 0.00000011920929f);
                    let _e642 = select(select(0.00000000000011368684f, _e639, (_e639 > 0.00000000000011368684f)), 0f, _e635);
                    let _e643 = select(0f, _e631, _e635);
                    let _e644 = (_e607 + _e642);
                    let _e645 = (_e607 - _e642);
                    let _e647 = select(38685626000000000000000000f, (1f / _e631), _e635);
                    let _e649 = select(_e574, _e510, (_e510 > _e574));
                    if (_e393 && (select(_e638, _e649, (_e649 > _e638)) <= 1099511600000f)) {
                        let _e661 = ((_e379 & 8388607u) | (select(0u, 1u, ((_e379 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e664 = bitcast<i32>((_e379 >> bitcast<u32>(23i)));
                        let _e668 = (_e661 == 0u);
                        let _e671 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e661)), 32u, _e668)) - 8i);
                        if (_e664 == 255i) {
                            phi_1233_ = 255i;
                        } else {
                            phi_1233_ = (((_e664 + select(0i, 1i, (_e664 == 0i))) - _e671) + _e412);
                        }
                        let _e679 = phi_1233_;
                        let _e689 = (_e679 <= 0i);
                        if _e689 {
                            phi_1256_ = u32();
                        } else {
                            if _e668 {
                                phi_1255_ = u32();
                            } else {
                                phi_1255_ = select(((bitcast<u32>(_e679) << bitcast<u32>(23i)) | ((_e661 << bitcast<u32>(((_e671 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e679 >= 255i));
                            }
                            let _e693 = phi_1255_;
                            phi_1256_ = _e693;
                        }
                        let _e695 = phi_1256_;
                        let _e707 = ((_e389 & 8388607u) | (select(0u, 1u, ((_e389 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e710 = bitcast<i32>((_e389 >> bitcast<u32>(23i)));
                        let _e714 = (_e707 == 0u);
                        let _e717 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e707)), 32u, _e714)) - 8i);
                        if (_e710 == 255i) {
                            phi_1293_ = 255i;
                        } else {
                            phi_1293_ = (((_e710 + select(0i, 1i, (_e710 == 0i))) - _e717) + _e412);
                        }
                        let _e725 = phi_1293_;
                        let _e735 = (_e725 <= 0i);
                        if _e735 {
                            phi_1316_ = u32();
                        } else {
                            if _e714 {
                                phi_1315_ = u32();
                            } else {
                                phi_1315_ = select(((bitcast<u32>(_e725) << bitcast<u32>(23i)) | ((_e707 << bitcast<u32>(((_e717 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e725 >= 255i));
                            }
                            let _e739 = phi_1315_;
                            phi_1316_ = _e739;
                        }
                        let _e741 = phi_1316_;
                        phi_1324_ = bitcast<f32>(((_e388 & 2147483648u) | select(_e741, 0u, select(_e714, true, _e735))));
                        phi_1325_ = bitcast<f32>(((_e378 & 2147483648u) | select(_e695, 0u, select(_e668, true, _e689))));
                    } else {
                        phi_1324_ = 0f;
                        phi_1325_ = 1f;
                    }
                    let _e747 = phi_1324_;
                    let _e749 = phi_1325_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e753 = (_e431 % 3u);
                    let _e754 = (_e753 < 3u);
                    if _e754 {
                    } else {
                        break;
                    }
                    let _e756 = local_1[_e753];
                    let _e759 = (_e430 % 3u);
                    let _e760 = (_e759 < 3u);
                    if _e760 {
                    } else {
                        break;
                    }
                    let _e762 = local_1[_e759];
                    let _e765 = (_e432 % 3u);
                    let _e766 = (_e765 < 3u);
                    if _e766 {
                    } else {
                        break;
                    }
                    let _e768 = local_1[_e765];
                    if _e754 {
                    } else {
                        break;
                    }
                    let _e773 = local[_e753];
                    if _e760 {
                    } else {
                        break;
                    }
                    let _e777 = local[_e759];
                    if _e766 {
                    } else {
                        break;
                    }
                    let _e781 = local[_e765];
                    phi_5377_ = false;
                    phi_1421_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e747);
                    phi_1424_ = ((3u * _e109) + 1u);
                    phi_1426_ = (_e749 <= _e747);
                    phi_1428_ = 0u;
                    phi_1430_ = type_58(type_37(vec4<f32>((f32(_e756) * _e168), (f32(_e762) * _e168), (f32(_e768) * _e168), 0f), vec4<f32>((f32(_e773) * _e168), (f32(_e777) * _e168), (f32(_e781) * _e168), 0f)), select(0u, 2147483648u, (_e109 == 0u)));
                    loop {
                        let _e791 = phi_5377_;
                        let _e793 = phi_1421_;
                        let _e795 = phi_1424_;
                        let _e797 = phi_1426_;
                        let _e799 = phi_1428_;
                        let _e801 = phi_1430_;
                        local_10 = _e793;
                        if _e797 {
                            phi_1441_ = true;
                        } else {
                            phi_1441_ = (_e799 > 0u);
                        }
                        let _e804 = phi_1441_;
                        if _e804 {
                            let _e805 = (_e795 > 0u);
                            if _e805 {
                                if _e797 {
                                    phi_1527_ = _e797;
                                    phi_1528_ = _e799;
                                    phi_1529_ = _e801;
                                } else {
                                    let _e806 = (_e799 - 1u);
                                    let _e807 = (_e806 % 128u);
                                    let _e808 = (_e807 < 128u);
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e810 = local_7[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e812 = local_6[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e814 = local_5[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e816 = local_4[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e818 = local_3[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e820 = local_2[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e825 = local_8[_e807];
                                    if _e808 {
                                    } else {
                                        phi_5615_ = true;
                                        break;
                                    }
                                    let _e828 = local_9[_e807];
                                    phi_1527_ = (_e828 <= _e793.member_1);
                                    phi_1528_ = _e806;
                                    phi_1529_ = type_58(type_37(vec4<f32>(_e810, _e812, _e814, 0f), vec4<f32>(_e816, _e818, _e820, 0f)), _e825);
                                }
                                let _e832 = phi_1527_;
                                let _e834 = phi_1528_;
                                let _e836 = phi_1529_;
                                if _e832 {
                                    let _e840 = ((_e836.member_1 & 2147483648u) != 0u);
                                    let _e841 = (_e836.member_1 & 268435455u);
                                    if _e840 {
                                        phi_1548_ = _e793;
                                        phi_1551_ = type_8(0u, ((_e836.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e848 = phi_1548_;
                                            let _e850 = phi_1551_;
                                            local_11 = _e848;
                                            if (_e850.member < _e850.member_1) {
                                                phi_1552_ = type_8((_e850.member + 1u), _e850.member_1);
                                                phi_1574_ = type_8(1u, _e850.member);
                                            } else {
                                                phi_1552_ = _e850;
                                                phi_1574_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e863 = phi_1552_;
                                            let _e865 = phi_1574_;
                                            let _e869 = (bitcast<i32>(_e865.member) != 0i);
                                            if _e869 {
                                                let _e874 = (_e836.member.member_1.x - _e836.member.member.x);
                                                let _e877 = (_e836.member.member_1.y - _e836.member.member.y);
                                                let _e880 = (_e836.member.member_1.z - _e836.member.member.z);
                                                let _e882 = select(_e877, _e874, (_e874 > _e877));
                                                let _e884 = select(_e880, _e882, (_e882 > _e880));
                                                let _e886 = (_e884 < (1024f * _e168));
                                                if _e886 {
                                                    phi_1615_ = 0u;
                                                } else {
                                                    phi_1615_ = select(2u, 1u, (_e884 < (2097152f * _e168)));
                                                }
                                                let _e891 = phi_1615_;
                                                switch bitcast<i32>(_e891) {
                                                    case 0: {
                                                        phi_1621_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1621_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1621_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1621_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e894 = phi_1621_;
                                                switch bitcast<i32>(_e891) {
                                                    case 0: {
                                                        phi_1631_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1631_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1631_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1631_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e901 = phi_1631_;
                                                let _e903 = ((_e841 + (_e865.member_1 * ((3u * _e894) + 1u))) + (3u * _e901));
                                                let _e904 = (_e903 < _e112);
                                                if _e904 {
                                                    if _e904 {
                                                    } else {
                                                        phi_5371_ = true;
                                                        break;
                                                    }
                                                    let _e906 = global_10.member[_e903];
                                                    phi_1647_ = _e906;
                                                } else {
                                                    phi_1647_ = 4294967295u;
                                                }
                                                let _e908 = phi_1647_;
                                                if _e886 {
                                                    phi_1680_ = 0u;
                                                } else {
                                                    phi_1680_ = select(2u, 1u, (_e884 < (2097152f * _e168)));
                                                }
                                                let _e913 = phi_1680_;
                                                switch bitcast<i32>(_e913) {
                                                    case 0: {
                                                        phi_1686_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1686_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1686_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1686_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e916 = phi_1686_;
                                                let _e920 = (_e841 + (_e865.member_1 * ((3u * _e916) + 1u)));
                                                switch bitcast<i32>(_e913) {
                                                    case 0: {
                                                        let _e1195 = (_e920 < _e112);
                                                        if _e1195 {
                                                            if _e1195 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1197 = global_10.member[_e920];
                                                            phi_1713_ = _e1197;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1199 = phi_1713_;
                                                        let _e1201 = ((10u * _e431) & 31u);
                                                        let _e1211 = ((10u * _e430) & 31u);
                                                        let _e1221 = ((10u * _e432) & 31u);
                                                        let _e1231 = (_e920 + 1u);
                                                        let _e1232 = (_e1231 < _e112);
                                                        if _e1232 {
                                                            if _e1232 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1234 = global_10.member[_e1231];
                                                            phi_1762_ = _e1234;
                                                        } else {
                                                            phi_1762_ = 0u;
                                                        }
                                                        let _e1236 = phi_1762_;
                                                        let _e1262 = (_e920 + 2u);
                                                        let _e1263 = (_e1262 < _e112);
                                                        if _e1263 {
                                                            if _e1263 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1265 = global_10.member[_e1262];
                                                            phi_1811_ = _e1265;
                                                        } else {
                                                            phi_1811_ = 0u;
                                                        }
                                                        let _e1267 = phi_1811_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | ((_e1199 >> bitcast<u32>(_e1201)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | ((_e1199 >> bitcast<u32>(_e1211)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | ((_e1199 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | ((_e1236 >> bitcast<u32>(_e1201)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | ((_e1236 >> bitcast<u32>(_e1211)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | ((_e1236 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e168))), array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | ((_e1267 >> bitcast<u32>(_e1201)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | ((_e1267 >> bitcast<u32>(_e1211)) & 1023u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | ((_e1267 >> bitcast<u32>(_e1221)) & 1023u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1009 = (_e920 < _e112);
                                                        if _e1009 {
                                                            if _e1009 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1011 = global_10.member[_e920];
                                                            phi_1860_ = _e1011;
                                                        } else {
                                                            phi_1860_ = 0u;
                                                        }
                                                        let _e1013 = phi_1860_;
                                                        let _e1014 = (_e920 + 1u);
                                                        let _e1015 = (_e1014 < _e112);
                                                        if _e1015 {
                                                            if _e1015 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1017 = global_10.member[_e1014];
                                                            phi_1875_ = _e1017;
                                                        } else {
                                                            phi_1875_ = 0u;
                                                        }
                                                        let _e1019 = phi_1875_;
                                                        let _e1020 = (_e431 == 1u);
                                                        if _e1020 {
                                                            phi_1885_ = ((_e1013 >> bitcast<u32>(21i)) | (_e1019 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1885_ = (_e1019 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1029 = phi_1885_;
                                                        let _e1037 = (_e430 == 1u);
                                                        if _e1037 {
                                                            phi_1906_ = ((_e1013 >> bitcast<u32>(21i)) | (_e1019 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1906_ = (_e1019 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1046 = phi_1906_;
                                                        let _e1054 = (_e432 == 1u);
                                                        if _e1054 {
                                                            phi_1927_ = ((_e1013 >> bitcast<u32>(21i)) | (_e1019 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1927_ = (_e1019 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1063 = phi_1927_;
                                                        let _e1072 = (_e920 + 2u);
                                                        let _e1073 = (_e1072 < _e112);
                                                        if _e1073 {
                                                            if _e1073 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1075 = global_10.member[_e1072];
                                                            phi_1957_ = _e1075;
                                                        } else {
                                                            phi_1957_ = 0u;
                                                        }
                                                        let _e1077 = phi_1957_;
                                                        let _e1078 = (_e920 + 3u);
                                                        let _e1079 = (_e1078 < _e112);
                                                        if _e1079 {
                                                            if _e1079 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1081 = global_10.member[_e1078];
                                                            phi_1972_ = _e1081;
                                                        } else {
                                                            phi_1972_ = 0u;
                                                        }
                                                        let _e1083 = phi_1972_;
                                                        if _e1020 {
                                                            phi_1982_ = ((_e1077 >> bitcast<u32>(21i)) | (_e1083 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1982_ = (_e1083 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1092 = phi_1982_;
                                                        if _e1037 {
                                                            phi_2003_ = ((_e1077 >> bitcast<u32>(21i)) | (_e1083 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2003_ = (_e1083 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1108 = phi_2003_;
                                                        if _e1054 {
                                                            phi_2024_ = ((_e1077 >> bitcast<u32>(21i)) | (_e1083 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2024_ = (_e1083 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1124 = phi_2024_;
                                                        let _e1133 = (_e920 + 4u);
                                                        let _e1134 = (_e1133 < _e112);
                                                        if _e1134 {
                                                            if _e1134 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1136 = global_10.member[_e1133];
                                                            phi_2054_ = _e1136;
                                                        } else {
                                                            phi_2054_ = 0u;
                                                        }
                                                        let _e1138 = phi_2054_;
                                                        let _e1139 = (_e920 + 5u);
                                                        let _e1140 = (_e1139 < _e112);
                                                        if _e1140 {
                                                            if _e1140 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1142 = global_10.member[_e1139];
                                                            phi_2069_ = _e1142;
                                                        } else {
                                                            phi_2069_ = 0u;
                                                        }
                                                        let _e1144 = phi_2069_;
                                                        if _e1020 {
                                                            phi_2079_ = ((_e1138 >> bitcast<u32>(21i)) | (_e1144 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2079_ = (_e1144 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1153 = phi_2079_;
                                                        if _e1037 {
                                                            phi_2100_ = ((_e1138 >> bitcast<u32>(21i)) | (_e1144 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2100_ = (_e1144 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1169 = phi_2100_;
                                                        if _e1054 {
                                                            phi_2121_ = ((_e1138 >> bitcast<u32>(21i)) | (_e1144 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_2121_ = (_e1144 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1185 = phi_2121_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1029, _e1013, _e455) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1046, _e1013, _e520) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1063, _e1013, _e584) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1092, _e1077, _e455) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1108, _e1077, _e520) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1124, _e1077, _e584) & 2097151u))) - 8388608f) * _e168))), array<f32, 3>((_e836.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1153, _e1138, _e455) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1169, _e1138, _e520) & 2097151u))) - 8388608f) * _e168)), (_e836.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1185, _e1138, _e584) & 2097151u))) - 8388608f) * _e168))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e922 = (_e920 + _e431);
                                                        let _e923 = (_e922 < _e112);
                                                        if _e923 {
                                                            if _e923 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e925 = global_10.member[_e922];
                                                            phi_2152_ = _e925;
                                                        } else {
                                                            phi_2152_ = 0u;
                                                        }
                                                        let _e927 = phi_2152_;
                                                        let _e931 = (_e920 + _e430);
                                                        let _e932 = (_e931 < _e112);
                                                        if _e932 {
                                                            if _e932 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e934 = global_10.member[_e931];
                                                            phi_2170_ = _e934;
                                                        } else {
                                                            phi_2170_ = 0u;
                                                        }
                                                        let _e936 = phi_2170_;
                                                        let _e940 = (_e920 + _e432);
                                                        let _e941 = (_e940 < _e112);
                                                        if _e941 {
                                                            if _e941 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e943 = global_10.member[_e940];
                                                            phi_2188_ = _e943;
                                                        } else {
                                                            phi_2188_ = 0u;
                                                        }
                                                        let _e945 = phi_2188_;
                                                        let _e950 = (_e920 + 3u);
                                                        let _e951 = (_e950 + _e431);
                                                        let _e952 = (_e951 < _e112);
                                                        if _e952 {
                                                            if _e952 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e954 = global_10.member[_e951];
                                                            phi_2211_ = _e954;
                                                        } else {
                                                            phi_2211_ = 0u;
                                                        }
                                                        let _e956 = phi_2211_;
                                                        let _e960 = (_e950 + _e430);
                                                        let _e961 = (_e960 < _e112);
                                                        if _e961 {
                                                            if _e961 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e963 = global_10.member[_e960];
                                                            phi_2229_ = _e963;
                                                        } else {
                                                            phi_2229_ = 0u;
                                                        }
                                                        let _e965 = phi_2229_;
                                                        let _e969 = (_e950 + _e432);
                                                        let _e970 = (_e969 < _e112);
                                                        if _e970 {
                                                            if _e970 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e972 = global_10.member[_e969];
                                                            phi_2247_ = _e972;
                                                        } else {
                                                            phi_2247_ = 0u;
                                                        }
                                                        let _e974 = phi_2247_;
                                                        let _e979 = (_e920 + 6u);
                                                        let _e980 = (_e979 + _e431);
                                                        let _e981 = (_e980 < _e112);
                                                        if _e981 {
                                                            if _e981 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e983 = global_10.member[_e980];
                                                            phi_2270_ = _e983;
                                                        } else {
                                                            phi_2270_ = 0u;
                                                        }
                                                        let _e985 = phi_2270_;
                                                        let _e989 = (_e979 + _e430);
                                                        let _e990 = (_e989 < _e112);
                                                        if _e990 {
                                                            if _e990 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e992 = global_10.member[_e989];
                                                            phi_2288_ = _e992;
                                                        } else {
                                                            phi_2288_ = 0u;
                                                        }
                                                        let _e994 = phi_2288_;
                                                        let _e998 = (_e979 + _e432);
                                                        let _e999 = (_e998 < _e112);
                                                        if _e999 {
                                                            if _e999 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1001 = global_10.member[_e998];
                                                            phi_2306_ = _e1001;
                                                        } else {
                                                            phi_2306_ = 0u;
                                                        }
                                                        let _e1003 = phi_2306_;
                                                        phi_2312_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e927)) * _e168), (f32(bitcast<i32>(_e936)) * _e168), (f32(bitcast<i32>(_e945)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e956)) * _e168), (f32(bitcast<i32>(_e965)) * _e168), (f32(bitcast<i32>(_e974)) * _e168)), array<f32, 3>((f32(bitcast<i32>(_e985)) * _e168), (f32(bitcast<i32>(_e994)) * _e168), (f32(bitcast<i32>(_e1003)) * _e168)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2312_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1295 = phi_2312_;
                                                let _e1311 = (_e1295[0][2] - _e607);
                                                let _e1314 = (((_e1295[0][0] - _e478) * _e643) - (_e1311 * _e515));
                                                let _e1317 = (((_e1295[0][1] - _e543) * _e643) - (_e1311 * _e579));
                                                let _e1320 = (_e1295[1][2] - _e607);
                                                let _e1323 = (((_e1295[1][0] - _e478) * _e643) - (_e1320 * _e515));
                                                let _e1326 = (((_e1295[1][1] - _e543) * _e643) - (_e1320 * _e579));
                                                let _e1329 = (_e1295[2][2] - _e607);
                                                let _e1332 = (((_e1295[2][0] - _e478) * _e643) - (_e1329 * _e515));
                                                let _e1335 = (((_e1295[2][1] - _e543) * _e643) - (_e1329 * _e579));
                                                let _e1336 = (_e1332 * _e1326);
                                                let _e1337 = (_e1335 * _e1323);
                                                let _e1338 = (_e1314 * _e1335);
                                                let _e1339 = (_e1317 * _e1332);
                                                let _e1340 = (_e1323 * _e1317);
                                                let _e1341 = (_e1326 * _e1314);
                                                let _e1346 = (((_e1336 >= _e1337) && (_e1338 >= _e1339)) && (_e1340 >= _e1341));
                                                let _e1352 = (_e1346 || (((_e1336 <= _e1337) && (_e1338 <= _e1339)) && (_e1340 <= _e1341)));
                                                if _e1352 {
                                                    let _e1354 = select(-1f, 1f, _e1346);
                                                    let _e1356 = ((_e1336 - _e1337) * _e1354);
                                                    let _e1358 = select(0f, _e1356, (_e1356 > 0f));
                                                    let _e1360 = ((_e1338 - _e1339) * _e1354);
                                                    let _e1362 = select(0f, _e1360, (_e1360 > 0f));
                                                    let _e1364 = ((_e1340 - _e1341) * _e1354);
                                                    let _e1366 = select(0f, _e1364, (_e1364 > 0f));
                                                    let _e1368 = ((_e1358 + _e1362) + _e1366);
                                                    let _e1370 = select(_e1295[1][0], _e1295[0][0], (_e1295[0][0] < _e1295[1][0]));
                                                    let _e1374 = select(_e1295[1][0], _e1295[0][0], (_e1295[0][0] > _e1295[1][0]));
                                                    let _e1378 = select(_e1295[1][1], _e1295[0][1], (_e1295[0][1] < _e1295[1][1]));
                                                    let _e1382 = select(_e1295[1][1], _e1295[0][1], (_e1295[0][1] > _e1295[1][1]));
                                                    let _e1386 = select(_e1295[1][2], _e1295[0][2], (_e1295[0][2] < _e1295[1][2]));
                                                    let _e1390 = select(_e1295[1][2], _e1295[0][2], (_e1295[0][2] > _e1295[1][2]));
                                                    let _e1395 = ((select(_e1295[2][0], _e1370, (_e1370 < _e1295[2][0])) - _e516) * _e519);
                                                    let _e1396 = ((select(_e1295[2][0], _e1374, (_e1374 > _e1295[2][0])) - _e517) * _e519);
                                                    let _e1399 = ((select(_e1295[2][1], _e1378, (_e1378 < _e1295[2][1])) - _e580) * _e583);
                                                    let _e1400 = ((select(_e1295[2][1], _e1382, (_e1382 > _e1295[2][1])) - _e581) * _e583);
                                                    let _e1403 = ((select(_e1295[2][2], _e1386, (_e1386 < _e1295[2][2])) - _e644) * _e647);
                                                    let _e1404 = ((select(_e1295[2][2], _e1390, (_e1390 > _e1295[2][2])) - _e645) * _e647);
                                                    let _e1406 = select(_e1404, _e1403, (_e1403 < _e1404));
                                                    let _e1408 = select(_e1404, _e1403, (_e1403 > _e1404));
                                                    let _e1410 = select(_e1396, _e1395, (_e1395 < _e1396));
                                                    let _e1412 = select(_e1400, _e1399, (_e1399 < _e1400));
                                                    let _e1414 = select(_e1412, _e1410, (_e1410 > _e1412));
                                                    let _e1416 = select(_e1406, _e1414, (_e1414 > _e1406));
                                                    let _e1418 = select(_e1396, _e1395, (_e1395 > _e1396));
                                                    let _e1420 = select(_e1400, _e1399, (_e1399 > _e1400));
                                                    let _e1422 = select(_e1420, _e1418, (_e1418 < _e1420));
                                                    let _e1424 = select(_e1408, _e1422, (_e1422 < _e1408));
                                                    let _e1425 = -(_e1406);
                                                    let _e1431 = select(_e749, _e1416, (_e1416 > _e749));
                                                    let _e1435 = select(_e1323, _e1314, (_e1314 < _e1323));
                                                    let _e1440 = select(_e1323, _e1314, (_e1314 > _e1323));
                                                    let _e1447 = select(_e1326, _e1317, (_e1317 < _e1326));
                                                    let _e1452 = select(_e1326, _e1317, (_e1317 > _e1326));
                                                    let _e1461 = (((((_e1352 && (_e1368 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1332, _e1435, (_e1435 < _e1332)) <= 0f) && (select(_e1332, _e1440, (_e1440 > _e1332)) >= 0f))) && ((select(_e1335, _e1447, (_e1447 < _e1335)) <= 0f) && (select(_e1335, _e1452, (_e1452 > _e1335)) >= 0f))) && (_e1431 <= (_e1424 + (select(_e1425, _e1408, (_e1408 > _e1425)) * 0.0000019073523f)))) && (_e1431 <= _e848.member_1));
                                                    if _e1461 {
                                                        let _e1466 = (_e1295[1][0] - _e1295[0][0]);
                                                        let _e1467 = (_e1295[1][1] - _e1295[0][1]);
                                                        let _e1468 = (_e1295[1][2] - _e1295[0][2]);
                                                        let _e1469 = vec3<f32>(_e1466, _e1467, _e1468);
                                                        let _e1470 = (_e1295[2][0] - _e1295[1][0]);
                                                        let _e1471 = (_e1295[2][1] - _e1295[1][1]);
                                                        let _e1472 = (_e1295[2][2] - _e1295[1][2]);
                                                        let _e1473 = vec3<f32>(_e1470, _e1471, _e1472);
                                                        let _e1474 = (_e1295[0][0] - _e1295[2][0]);
                                                        let _e1475 = (_e1295[0][1] - _e1295[2][1]);
                                                        let _e1476 = (_e1295[0][2] - _e1295[2][2]);
                                                        let _e1477 = vec3<f32>(_e1474, _e1475, _e1476);
                                                        let _e1478 = abs(_e1466);
                                                        let _e1479 = abs(_e1467);
                                                        if (_e1478 != _e1478) {
                                                            phi_4938_ = true;
                                                        } else {
                                                            phi_4938_ = (_e1479 >= _e1478);
                                                        }
                                                        let _e1483 = phi_4938_;
                                                        let _e1484 = select(_e1478, _e1479, _e1483);
                                                        let _e1485 = abs(_e1468);
                                                        if (_e1484 != _e1484) {
                                                            phi_4953_ = true;
                                                        } else {
                                                            phi_4953_ = (_e1485 >= _e1484);
                                                        }
                                                        let _e1489 = phi_4953_;
                                                        let _e1490 = select(_e1484, _e1485, _e1489);
                                                        let _e1491 = abs(_e1470);
                                                        let _e1492 = abs(_e1471);
                                                        if (_e1491 != _e1491) {
                                                            phi_4968_ = true;
                                                        } else {
                                                            phi_4968_ = (_e1492 >= _e1491);
                                                        }
                                                        let _e1496 = phi_4968_;
                                                        let _e1497 = select(_e1491, _e1492, _e1496);
                                                        let _e1498 = abs(_e1472);
                                                        if (_e1497 != _e1497) {
                                                            phi_4983_ = true;
                                                        } else {
                                                            phi_4983_ = (_e1498 >= _e1497);
                                                        }
                                                        let _e1502 = phi_4983_;
                                                        let _e1503 = select(_e1497, _e1498, _e1502);
                                                        let _e1504 = abs(_e1474);
                                                        let _e1505 = abs(_e1475);
                                                        if (_e1504 != _e1504) {
                                                            phi_4998_ = true;
                                                        } else {
                                                            phi_4998_ = (_e1505 >= _e1504);
                                                        }
                                                        let _e1509 = phi_4998_;
                                                        let _e1510 = select(_e1504, _e1505, _e1509);
                                                        let _e1511 = abs(_e1476);
                                                        if (_e1510 != _e1510) {
                                                            phi_5013_ = true;
                                                        } else {
                                                            phi_5013_ = (_e1511 >= _e1510);
                                                        }
                                                        let _e1515 = phi_5013_;
                                                        let _e1516 = select(_e1510, _e1511, _e1515);
                                                        let _e1518 = select(_e1503, _e1490, (_e1490 > _e1503));
                                                        let _e1520 = select(_e1516, _e1518, (_e1518 > _e1516));
                                                        if (_e1490 == _e1520) {
                                                            phi_2854_ = _e1326;
                                                            phi_2855_ = _e1323;
                                                            phi_2856_ = _e1317;
                                                            phi_2857_ = _e1314;
                                                            phi_2858_ = vec3<f32>(_e1295[0][0], _e1295[0][1], _e1295[0][2]);
                                                            phi_2859_ = _e1477;
                                                            phi_2860_ = _e1473;
                                                            phi_2861_ = _e1469;
                                                        } else {
                                                            let _e1522 = (_e1503 == _e1520);
                                                            let _e1527 = vec3(_e1522);
                                                            phi_2854_ = select(_e1317, _e1335, _e1522);
                                                            phi_2855_ = select(_e1314, _e1332, _e1522);
                                                            phi_2856_ = select(_e1335, _e1326, _e1522);
                                                            phi_2857_ = select(_e1332, _e1323, _e1522);
                                                            phi_2858_ = select(vec3<f32>(_e1295[2][0], _e1295[2][1], _e1295[2][2]), vec3<f32>(_e1295[1][0], _e1295[1][1], _e1295[1][2]), _e1527);
                                                            phi_2859_ = select(_e1473, _e1469, _e1527);
                                                            phi_2860_ = select(_e1469, _e1477, _e1527);
                                                            phi_2861_ = select(_e1477, _e1473, _e1527);
                                                        }
                                                        let _e1533 = phi_2854_;
                                                        let _e1535 = phi_2855_;
                                                        let _e1537 = phi_2856_;
                                                        let _e1539 = phi_2857_;
                                                        let _e1541 = phi_2858_;
                                                        let _e1543 = phi_2859_;
                                                        let _e1545 = phi_2860_;
                                                        let _e1547 = phi_2861_;
                                                        let _e1554 = ((_e1545.y * _e1543.z) - (_e1543.y * _e1545.z));
                                                        let _e1559 = ((_e1545.z * _e1543.x) - (_e1543.z * _e1545.x));
                                                        let _e1562 = ((_e1545.x * _e1543.y) - (_e1543.x * _e1545.y));
                                                        let _e1565 = ((_e1358 >= _e1362) && (_e1358 >= _e1366));
                                                        let _e1566 = (_e1362 >= _e1366);
                                                        let _e1580 = (((_e1554 * (select(select(_e1295[2][0], _e1295[1][0], _e1566), _e1295[0][0], _e1565) - _e478)) + (_e1559 * (select(select(_e1295[2][1], _e1295[1][1], _e1566), _e1295[0][1], _e1565) - _e543))) + (_e1562 * (select(select(_e1295[2][2], _e1295[1][2], _e1566), _e1295[0][2], _e1565) - _e607)));
                                                        let _e1585 = (((_e1554 * _e515) + (_e1559 * _e579)) + (_e1562 * _e643));
                                                        let _e1586 = (_e1535 - _e1539);
                                                        let _e1587 = (_e1533 - _e1537);
                                                        let _e1590 = ((_e1586 * _e1586) + (_e1587 * _e1587));
                                                        let _e1597 = (-(((_e1539 * _e1586) + (_e1537 * _e1587))) / select(0.000000000000000000000000000000000000011754944f, _e1590, (_e1590 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1599 = select(1f, _e1597, (_e1597 < 1f));
                                                        let _e1601 = select(0f, _e1599, (_e1599 > 0f));
                                                        let _e1610 = ((_e1541.x + (_e1547.x * _e1601)) - _e478);
                                                        let _e1613 = ((_e1541.y + (_e1547.y * _e1601)) - _e543);
                                                        let _e1616 = ((_e1541.z + (_e1547.z * _e1601)) - _e607);
                                                        let _e1619 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                        let _e1622 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                        let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                        let _e1627 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                        let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                        let _e1633 = abs(_e1554);
                                                        let _e1634 = abs(_e1559);
                                                        if (_e1633 != _e1633) {
                                                            phi_5028_ = true;
                                                        } else {
                                                            phi_5028_ = (_e1634 >= _e1633);
                                                        }
                                                        let _e1638 = phi_5028_;
                                                        let _e1639 = select(_e1633, _e1634, _e1638);
                                                        let _e1640 = abs(_e1562);
                                                        if (_e1639 != _e1639) {
                                                            phi_5043_ = true;
                                                        } else {
                                                            phi_5043_ = (_e1640 >= _e1639);
                                                        }
                                                        let _e1644 = phi_5043_;
                                                        let _e1660 = abs(_e1545.x);
                                                        let _e1661 = abs(_e1545.y);
                                                        if (_e1660 != _e1660) {
                                                            phi_5058_ = true;
                                                        } else {
                                                            phi_5058_ = (_e1661 >= _e1660);
                                                        }
                                                        let _e1665 = phi_5058_;
                                                        let _e1666 = select(_e1660, _e1661, _e1665);
                                                        let _e1667 = abs(_e1545.z);
                                                        if (_e1666 != _e1666) {
                                                            phi_5073_ = true;
                                                        } else {
                                                            phi_5073_ = (_e1667 >= _e1666);
                                                        }
                                                        let _e1671 = phi_5073_;
                                                        let _e1674 = abs(_e1543.x);
                                                        let _e1675 = abs(_e1543.y);
                                                        if (_e1674 != _e1674) {
                                                            phi_5088_ = true;
                                                        } else {
                                                            phi_5088_ = (_e1675 >= _e1674);
                                                        }
                                                        let _e1679 = phi_5088_;
                                                        let _e1680 = select(_e1674, _e1675, _e1679);
                                                        let _e1681 = abs(_e1543.z);
                                                        if (_e1680 != _e1680) {
                                                            phi_5103_ = true;
                                                        } else {
                                                            phi_5103_ = (_e1681 >= _e1680);
                                                        }
                                                        let _e1685 = phi_5103_;
                                                        let _e1690 = ((bitcast<f32>((bitcast<u32>(((((_e1554 * _e1610) + (_e1559 * _e1613)) + (_e1562 * _e1616)) - _e1580)) & 2147483647u)) <= ((0.0000009536743f * select(_e1520, _e1629, (_e1629 > _e1520))) * select(_e1639, _e1640, _e1644))) && !((bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u)) <= ((0.0000038146973f * select(_e1666, _e1667, _e1671)) * select(_e1680, _e1681, _e1685)))));
                                                        let _e1691 = (_e1580 / _e1585);
                                                        if (_e1461 && !(_e1690)) {
                                                            let _e1694 = (_e1616 / _e643);
                                                            let _e1702 = (((_e1554 * (_e1610 - (_e515 * _e1694))) + (_e1559 * (_e1613 - (_e579 * _e1694)))) / _e1585);
                                                            phi_3069_ = select(select(_e1694, (_e1694 + _e1702), (bitcast<f32>((bitcast<u32>(_e1702) & 2147483647u)) <= _e1520)), _e1691, _e1690);
                                                        } else {
                                                            phi_3069_ = _e1691;
                                                        }
                                                        let _e1711 = phi_3069_;
                                                        let _e1713 = select(_e1424, _e1711, (_e1711 < _e1424));
                                                        let _e1715 = select(_e1416, _e1713, (_e1713 > _e1416));
                                                        let _e1716 = (1f / _e1368);
                                                        phi_3089_ = type_46(_e1715, (_e1362 * _e1716), (_e1366 * _e1716), ((_e1461 && (_e1715 >= _e749)) && (_e1715 <= _e848.member_1)));
                                                        phi_3090_ = type_46();
                                                    } else {
                                                        phi_3089_ = type_46();
                                                        phi_3090_ = type_46(0f, 0f, 0f, _e1461);
                                                    }
                                                    let _e1725 = phi_3089_;
                                                    let _e1727 = phi_3090_;
                                                    phi_3093_ = _e1725;
                                                    phi_3094_ = _e1727;
                                                    phi_3095_ = select(true, false, _e1461);
                                                } else {
                                                    phi_3093_ = type_46();
                                                    phi_3094_ = type_46(0f, 0f, 0f, _e1352);
                                                    phi_3095_ = true;
                                                }
                                                let _e1730 = phi_3093_;
                                                let _e1732 = phi_3094_;
                                                let _e1734 = phi_3095_;
                                                if _e1734 {
                                                    phi_3099_ = _e1732;
                                                } else {
                                                    phi_3099_ = _e1730;
                                                }
                                                let _e1736 = phi_3099_;
                                                if _e1736.member_3 {
                                                    phi_3108_ = type_25(_e1736.member, _e1736.member_1, _e1736.member_2, _e908);
                                                } else {
                                                    phi_3108_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1743 = phi_3108_;
                                                if (_e1743.member_3 != 4294967295u) {
                                                    if (_e908 == _e177) {
                                                        phi_3443_ = false;
                                                    } else {
                                                        let _e1747 = (_e908 < arrayLength((&global_5.member)));
                                                        if _e1747 {
                                                            if _e1747 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1749 = global_5.member[_e908];
                                                            phi_3131_ = _e1749;
                                                        } else {
                                                            phi_3131_ = 4294967295u;
                                                        }
                                                        let _e1751 = phi_3131_;
                                                        let _e1752 = (_e1751 < arrayLength((&global_6.member)));
                                                        if _e1752 {
                                                            if _e1752 {
                                                            } else {
                                                                phi_5371_ = true;
                                                                break;
                                                            }
                                                            let _e1754 = global_6.member[_e1751];
                                                            phi_3145_ = _e1754;
                                                        } else {
                                                            phi_3145_ = 0i;
                                                        }
                                                        let _e1756 = phi_3145_;
                                                        let _e1757 = (_e1756 == 0i);
                                                        if _e1757 {
                                                            phi_3442_ = true;
                                                        } else {
                                                            if _e455 {
                                                                phi_3168_ = vec3<f32>(_e1295[0][0], _e1295[0][1], _e1295[0][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3167_ = vec3<f32>(_e1295[0][2], _e1295[0][0], _e1295[0][1]);
                                                                } else {
                                                                    phi_3167_ = vec3<f32>(_e1295[0][1], _e1295[0][2], _e1295[0][0]);
                                                                }
                                                                let _e1762 = phi_3167_;
                                                                phi_3168_ = _e1762;
                                                            }
                                                            let _e1765 = phi_3168_;
                                                            if _e455 {
                                                                phi_3187_ = vec3<f32>(_e1295[1][0], _e1295[1][1], _e1295[1][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3186_ = vec3<f32>(_e1295[1][2], _e1295[1][0], _e1295[1][1]);
                                                                } else {
                                                                    phi_3186_ = vec3<f32>(_e1295[1][1], _e1295[1][2], _e1295[1][0]);
                                                                }
                                                                let _e1770 = phi_3186_;
                                                                phi_3187_ = _e1770;
                                                            }
                                                            let _e1773 = phi_3187_;
                                                            if _e455 {
                                                                phi_3206_ = vec3<f32>(_e1295[2][0], _e1295[2][1], _e1295[2][2]);
                                                            } else {
                                                                if (_e431 == 1u) {
                                                                    phi_3205_ = vec3<f32>(_e1295[2][2], _e1295[2][0], _e1295[2][1]);
                                                                } else {
                                                                    phi_3205_ = vec3<f32>(_e1295[2][1], _e1295[2][2], _e1295[2][0]);
                                                                }
                                                                let _e1778 = phi_3205_;
                                                                phi_3206_ = _e1778;
                                                            }
                                                            let _e1781 = phi_3206_;
                                                            let _e1784 = (_e1773.x - _e1765.x);
                                                            let _e1787 = (_e1773.y - _e1765.y);
                                                            let _e1790 = (_e1773.z - _e1765.z);
                                                            let _e1792 = (_e1781.x - _e1765.x);
                                                            let _e1794 = (_e1781.y - _e1765.y);
                                                            let _e1796 = (_e1781.z - _e1765.z);
                                                            if (_e309.member_1 == 1u) {
                                                                phi_3242_ = (vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]) - _e1765);
                                                            } else {
                                                                phi_3242_ = vec3<f32>(_e309.member[0], _e309.member[1], _e309.member[2]);
                                                            }
                                                            let _e1811 = phi_3242_;
                                                            let _e1817 = bitcast<f32>((bitcast<u32>((_e1784 * _e1794)) ^ _e309.member_3[0]));
                                                            let _e1821 = bitcast<f32>((bitcast<u32>((_e1787 * _e1792)) ^ _e309.member_3[0]));
                                                            let _e1825 = bitcast<f32>((bitcast<u32>((_e1787 * _e1796)) ^ _e309.member_3[0]));
                                                            let _e1829 = bitcast<f32>((bitcast<u32>((_e1790 * _e1794)) ^ _e309.member_3[0]));
                                                            let _e1833 = bitcast<f32>((bitcast<u32>((_e1790 * _e1792)) ^ _e309.member_3[0]));
                                                            let _e1837 = bitcast<f32>((bitcast<u32>((_e1784 * _e1796)) ^ _e309.member_3[0]));
                                                            let _e1838 = (_e1825 - _e1829);
                                                            let _e1839 = (_e1833 - _e1837);
                                                            let _e1840 = (_e1817 - _e1821);
                                                            let _e1864 = (bitcast<f32>((bitcast<u32>(_e1825) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1829) & 2147483647u)));
                                                            let _e1871 = (bitcast<f32>((bitcast<u32>(_e1833) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1837) & 2147483647u)));
                                                            let _e1878 = (bitcast<f32>((bitcast<u32>(_e1817) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1821) & 2147483647u)));
                                                            if (_e309.member_2 == 0f) {
                                                                phi_3424_ = 0f;
                                                            } else {
                                                                let _e1908 = bitcast<f32>((bitcast<u32>(_e1838) & 2147483647u));
                                                                let _e1911 = bitcast<f32>((bitcast<u32>(_e1839) & 2147483647u));
                                                                let _e1914 = bitcast<f32>((bitcast<u32>(_e1840) & 2147483647u));
                                                                let _e1916 = select(_e1914, _e1911, (_e1911 > _e1914));
                                                                let _e1920 = select(_e1914, _e1911, (_e1911 < _e1914));
                                                                let _e1924 = select(_e1911, _e1908, (_e1908 < _e1911));
                                                                let _e1926 = select(_e1911, _e1908, (_e1908 > _e1911));
                                                                let _e1928 = select(_e1914, _e1926, (_e1926 < _e1914));
                                                                phi_3424_ = bitcast<f32>((bitcast<u32>((_e309.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1916, _e1908, (_e1908 > _e1916)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1928, _e1924, (_e1924 > _e1928)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1920, _e1908, (_e1908 < _e1920)))) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1864 + _e1871) + _e1878))) ^ _e309.member_3[0]))) * 1.0000005f)) ^ _e309.member_3[0])))) ^ _e309.member_3[0]));
                                                            }
                                                            let _e1955 = phi_3424_;
                                                            phi_3442_ = (_e1757 || !(((((bitcast<f32>((bitcast<u32>((_e1811.x * _e1838)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1811.y * _e1839)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1811.z * _e1840)) ^ _e309.member_3[0]))) * f32(-(_e1756))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1811.x) & 2147483647u)) * _e1864)) ^ _e309.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1811.y) & 2147483647u)) * _e1871)) ^ _e309.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1811.z) & 2147483647u)) * _e1878)) ^ _e309.member_3[0]))))) ^ _e309.member_3[0])) + _e1955) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1969 = phi_3442_;
                                                        phi_3443_ = _e1969;
                                                    }
                                                    let _e1971 = phi_3443_;
                                                    if _e1971 {
                                                        if (_e1743.member < _e848.member.member) {
                                                            phi_3463_ = true;
                                                        } else {
                                                            if (_e1743.member == _e848.member.member) {
                                                                phi_3462_ = (_e1743.member_3 < _e848.member.member_3);
                                                            } else {
                                                                phi_3462_ = false;
                                                            }
                                                            let _e1981 = phi_3462_;
                                                            phi_3463_ = _e1981;
                                                        }
                                                        let _e1983 = phi_3463_;
                                                        if _e1983 {
                                                            phi_3469_ = type_43(_e1743, _e1743.member);
                                                        } else {
                                                            phi_3469_ = _e848;
                                                        }
                                                        let _e1986 = phi_3469_;
                                                        phi_3470_ = _e1986;
                                                    } else {
                                                        phi_3470_ = _e848;
                                                    }
                                                    let _e1988 = phi_3470_;
                                                    phi_3471_ = _e1988;
                                                } else {
                                                    phi_3471_ = _e848;
                                                }
                                                let _e1990 = phi_3471_;
                                                phi_1549_ = _e1990;
                                            } else {
                                                phi_1549_ = type_43();
                                            }
                                            let _e1992 = phi_1549_;
                                            continue;
                                            continuing {
                                                phi_1548_ = _e1992;
                                                phi_1551_ = _e863;
                                                phi_5371_ = _e791;
                                                break if !(_e869);
                                            }
                                        }
                                        let _e1995 = phi_5371_;
                                        phi_5615_ = _e1995;
                                        if _e1995 {
                                            break;
                                        }
                                        phi_5706_ = _e1995;
                                        let _e2791 = local_11;
                                        phi_3472_ = _e2791;
                                    } else {
                                        phi_5706_ = _e791;
                                        phi_3472_ = _e793;
                                    }
                                    let _e1997 = phi_5706_;
                                    let _e1999 = phi_3472_;
                                    if _e840 {
                                        phi_4737_ = bool();
                                        phi_4738_ = u32();
                                        phi_4739_ = type_58();
                                    } else {
                                        if (_e836.member_1 >= _e109) {
                                            phi_4273_ = type_59(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_58(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_58(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e836.member_1 < _e109) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2003 = ((1u + _e431) % 4u);
                                            if (_e2003 < 4u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2008 = global_4.member[_e836.member_1][_e2003];
                                            let _e2010 = (_e2008 >> bitcast<u32>(11u));
                                            let _e2012 = ((1u + _e430) % 4u);
                                            if (_e2012 < 4u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2017 = global_4.member[_e836.member_1][_e2012];
                                            let _e2019 = (_e2017 >> bitcast<u32>(11u));
                                            let _e2021 = ((1u + _e432) % 4u);
                                            if (_e2021 < 4u) {
                                            } else {
                                                phi_5615_ = true;
                                                break;
                                            }
                                            let _e2026 = global_4.member[_e836.member_1][_e2021];
                                            let _e2028 = (_e2026 >> bitcast<u32>(11u));
                                            let _e2051 = (bitcast<f32>((bitcast<u32>((_e836.member.member_1.x - _e836.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e2052 = (bitcast<f32>((bitcast<u32>((_e836.member.member_1.y - _e836.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e2053 = (bitcast<f32>((bitcast<u32>((_e836.member.member_1.z - _e836.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e2055 = select(_e168, _e2051, (_e2051 > _e168));
                                            let _e2057 = select(_e168, _e2052, (_e2052 > _e168));
                                            let _e2059 = select(_e168, _e2053, (_e2053 > _e168));
                                            let _e2090 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2008 & 1023u))) - 8388608f) * _e2055));
                                            let _e2095 = (bitcast<i32>((_e2008 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2098 = bitcast<f32>((_e2090 & bitcast<u32>(_e2095)));
                                            let _e2099 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2017 & 1023u))) - 8388608f) * _e2057));
                                            let _e2104 = (bitcast<i32>((_e2017 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2107 = bitcast<f32>((_e2099 & bitcast<u32>(_e2104)));
                                            let _e2108 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2026 & 1023u))) - 8388608f) * _e2059));
                                            let _e2113 = (bitcast<i32>((_e2026 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2116 = bitcast<f32>((_e2108 & bitcast<u32>(_e2113)));
                                            let _e2120 = bitcast<f32>((_e2090 & bitcast<u32>(~(_e2095))));
                                            let _e2124 = bitcast<f32>((_e2099 & bitcast<u32>(~(_e2104))));
                                            let _e2128 = bitcast<f32>((_e2108 & bitcast<u32>(~(_e2113))));
                                            let _e2129 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2010 & 1023u))) - 8388608f) * _e2055));
                                            let _e2134 = (bitcast<i32>((_e2010 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2137 = bitcast<f32>((_e2129 & bitcast<u32>(_e2134)));
                                            let _e2138 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2019 & 1023u))) - 8388608f) * _e2057));
                                            let _e2143 = (bitcast<i32>((_e2019 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2146 = bitcast<f32>((_e2138 & bitcast<u32>(_e2143)));
                                            let _e2147 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e2028 & 1023u))) - 8388608f) * _e2059));
                                            let _e2152 = (bitcast<i32>((_e2028 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e2155 = bitcast<f32>((_e2147 & bitcast<u32>(_e2152)));
                                            let _e2159 = bitcast<f32>((_e2129 & bitcast<u32>(~(_e2134))));
                                            let _e2163 = bitcast<f32>((_e2138 & bitcast<u32>(~(_e2143))));
                                            let _e2167 = bitcast<f32>((_e2147 & bitcast<u32>(~(_e2152))));
                                            let _e2168 = (_e836.member.member.x + _e2098);
                                            let _e2169 = (_e836.member.member.y + _e2107);
                                            let _e2170 = (_e836.member.member.z + _e2116);
                                            let _e2173 = (_e836.member.member_1.x - _e2137);
                                            let _e2174 = (_e836.member.member_1.y - _e2146);
                                            let _e2175 = (_e836.member.member_1.z - _e2155);
                                            let _e2194 = (_e2173 - _e2168);
                                            let _e2195 = (_e2174 - _e2169);
                                            let _e2196 = (_e2175 - _e2170);
                                            let _e2198 = select(_e2195, _e2194, (_e2194 > _e2195));
                                            let _e2200 = select(_e2196, _e2198, (_e2198 > _e2196));
                                            if (_e2200 < (1024f * _e168)) {
                                                phi_3974_ = 0u;
                                            } else {
                                                phi_3974_ = select(2u, 1u, (_e2200 < (2097152f * _e168)));
                                            }
                                            let _e2207 = phi_3974_;
                                            switch bitcast<i32>(_e2207) {
                                                case 0: {
                                                    phi_3980_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3980_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3980_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3980_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e2210 = phi_3980_;
                                            let _e2216 = global_4.member[_e836.member_1][0u];
                                            let _e2220 = global_4.member[_e836.member_1][1u];
                                            let _e2224 = global_4.member[_e836.member_1][2u];
                                            let _e2228 = global_4.member[_e836.member_1][3u];
                                            let _e2240 = (((_e2220 >> bitcast<u32>(22i)) | ((_e2224 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e2228 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e2241 = (_e2216 & 268435455u);
                                            let _e2242 = (_e2240 & 268435455u);
                                            let _e2245 = ((_e2216 >> bitcast<u32>(28u)) & 7u);
                                            let _e2253 = ((_e2216 >> bitcast<u32>(31i)) | (((_e2240 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e2254 = (_e2245 != 0u);
                                            if (_e2245 == 0u) {
                                                phi_4235_ = _e2241;
                                            } else {
                                                if (_e2245 == 7u) {
                                                    phi_4234_ = 2147483648u;
                                                } else {
                                                    phi_4234_ = ((2147483648u | (_e2245 << bitcast<u32>(28u))) | (_e2242 & 268435455u));
                                                }
                                                let _e2263 = phi_4234_;
                                                phi_4235_ = _e2263;
                                            }
                                            let _e2265 = phi_4235_;
                                            if _e2254 {
                                                let _e2266 = (_e2245 != 7u);
                                                if _e2266 {
                                                    phi_4245_ = (_e2242 + (_e2245 * ((3u * _e2210) + 1u)));
                                                } else {
                                                    phi_4245_ = u32();
                                                }
                                                let _e2270 = phi_4245_;
                                                phi_4247_ = _e2270;
                                                phi_4248_ = select(true, false, _e2266);
                                            } else {
                                                phi_4247_ = u32();
                                                phi_4248_ = true;
                                            }
                                            let _e2273 = phi_4247_;
                                            let _e2275 = phi_4248_;
                                            if (_e2253 == 0u) {
                                                phi_4269_ = (_e2241 + select(0u, 1u, !(_e2254)));
                                            } else {
                                                if (_e2253 == 7u) {
                                                    phi_4268_ = 2147483648u;
                                                } else {
                                                    phi_4268_ = ((2147483648u | (_e2253 << bitcast<u32>(28u))) | (select(_e2273, _e2242, _e2275) & 268435455u));
                                                }
                                                let _e2288 = phi_4268_;
                                                phi_4269_ = _e2288;
                                            }
                                            let _e2290 = phi_4269_;
                                            phi_4273_ = type_59(array<vec4<f32>, 3>(vec4<f32>(_e2168, (_e836.member.member.x + _e2120), _e2173, (_e836.member.member_1.x - _e2159)), vec4<f32>(_e2169, (_e836.member.member.y + _e2124), _e2174, (_e836.member.member_1.y - _e2163)), vec4<f32>(_e2170, (_e836.member.member.z + _e2128), _e2175, (_e836.member.member_1.z - _e2167))), type_58(type_37((_e836.member.member + vec4<f32>(_e2098, _e2107, _e2116, 0f)), (_e836.member.member_1 - vec4<f32>(_e2137, _e2146, _e2155, 0f))), _e2265), type_58(type_37((_e836.member.member + vec4<f32>(_e2120, _e2124, _e2128, 0f)), (_e836.member.member_1 - vec4<f32>(_e2159, _e2163, _e2167, 0f))), _e2290));
                                        }
                                        let _e2295 = phi_4273_;
                                        let _e2307 = ((_e2295.member[0].x - _e516) * _e519);
                                        let _e2308 = ((_e2295.member[0].y - _e516) * _e519);
                                        let _e2309 = ((_e2295.member[0].z - _e517) * _e519);
                                        let _e2310 = ((_e2295.member[0].w - _e517) * _e519);
                                        let _e2320 = ((_e2295.member[1].x - _e580) * _e583);
                                        let _e2321 = ((_e2295.member[1].y - _e580) * _e583);
                                        let _e2322 = ((_e2295.member[1].z - _e581) * _e583);
                                        let _e2323 = ((_e2295.member[1].w - _e581) * _e583);
                                        let _e2333 = ((_e2295.member[2].x - _e644) * _e647);
                                        let _e2334 = ((_e2295.member[2].y - _e644) * _e647);
                                        let _e2335 = ((_e2295.member[2].z - _e645) * _e647);
                                        let _e2336 = ((_e2295.member[2].w - _e645) * _e647);
                                        let _e2338 = select(_e2335, _e2333, (_e2333 < _e2335));
                                        let _e2340 = select(_e2336, _e2334, (_e2334 < _e2336));
                                        let _e2342 = select(_e2335, _e2333, (_e2333 > _e2335));
                                        let _e2344 = select(_e2336, _e2334, (_e2334 > _e2336));
                                        let _e2346 = select(_e2309, _e2307, (_e2307 < _e2309));
                                        let _e2348 = select(_e2310, _e2308, (_e2308 < _e2310));
                                        let _e2350 = select(_e2322, _e2320, (_e2320 < _e2322));
                                        let _e2352 = select(_e2323, _e2321, (_e2321 < _e2323));
                                        let _e2354 = select(_e2350, _e2346, (_e2346 > _e2350));
                                        let _e2356 = select(_e2352, _e2348, (_e2348 > _e2352));
                                        let _e2358 = select(_e2338, _e2354, (_e2354 > _e2338));
                                        let _e2360 = select(_e2340, _e2356, (_e2356 > _e2340));
                                        let _e2362 = select(_e2309, _e2307, (_e2307 > _e2309));
                                        let _e2364 = select(_e2310, _e2308, (_e2308 > _e2310));
                                        let _e2366 = select(_e2322, _e2320, (_e2320 > _e2322));
                                        let _e2368 = select(_e2323, _e2321, (_e2321 > _e2323));
                                        let _e2370 = select(_e2366, _e2362, (_e2362 < _e2366));
                                        let _e2372 = select(_e2368, _e2364, (_e2364 < _e2368));
                                        let _e2377 = -(_e2338);
                                        let _e2378 = -(_e2340);
                                        let _e2385 = (select(_e2342, _e2370, (_e2370 < _e2342)) + (select(_e2377, _e2342, (_e2342 > _e2377)) * 0.0000019073523f));
                                        let _e2386 = (select(_e2344, _e2372, (_e2372 < _e2344)) + (select(_e2378, _e2344, (_e2344 > _e2378)) * 0.0000019073523f));
                                        let _e2388 = select(_e749, _e2358, (_e2358 > _e749));
                                        let _e2390 = select(_e749, _e2360, (_e2360 > _e749));
                                        let _e2395 = (_e2388 <= select(_e1999.member_1, _e2385, (_e2385 < _e1999.member_1)));
                                        let _e2396 = (_e2390 <= select(_e1999.member_1, _e2386, (_e2386 < _e1999.member_1)));
                                        let _e2397 = (_e2388 <= _e2390);
                                        if _e2395 {
                                            if _e2396 {
                                                if _e2397 {
                                                    phi_4635_ = _e2295.member_2;
                                                } else {
                                                    phi_4635_ = _e2295.member_1;
                                                }
                                                let _e2401 = phi_4635_;
                                                let _e2422 = (_e834 % 128u);
                                                let _e2423 = (_e2422 < 128u);
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_8[_e2422] = _e2401.member_1;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_7[_e2422] = _e2401.member.member.x;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_6[_e2422] = _e2401.member.member.y;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_5[_e2422] = _e2401.member.member.z;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_4[_e2422] = _e2401.member.member_1.x;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_3[_e2422] = _e2401.member.member_1.y;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_2[_e2422] = _e2401.member.member_1.z;
                                                if _e2423 {
                                                } else {
                                                    phi_5615_ = true;
                                                    break;
                                                }
                                                local_9[_e2422] = select(_e2388, _e2390, _e2397);
                                                if _e2397 {
                                                    phi_4711_ = _e2295.member_1;
                                                } else {
                                                    phi_4711_ = _e2295.member_2;
                                                }
                                                let _e2436 = phi_4711_;
                                                phi_4712_ = (_e834 + 1u);
                                                phi_4713_ = _e2436;
                                            } else {
                                                phi_4712_ = u32();
                                                phi_4713_ = type_58();
                                            }
                                            let _e2438 = phi_4712_;
                                            let _e2440 = phi_4713_;
                                            phi_4715_ = _e2438;
                                            phi_4716_ = _e2440;
                                            phi_4717_ = select(true, false, _e2396);
                                        } else {
                                            phi_4715_ = u32();
                                            phi_4716_ = type_58();
                                            phi_4717_ = true;
                                        }
                                        let _e2443 = phi_4715_;
                                        let _e2445 = phi_4716_;
                                        let _e2447 = phi_4717_;
                                        if _e2447 {
                                            if _e2395 {
                                                phi_4726_ = _e2295.member_1;
                                            } else {
                                                phi_4726_ = _e2295.member_2;
                                            }
                                            let _e2451 = phi_4726_;
                                            phi_4731_ = select(_e2396, true, _e2395);
                                            phi_4733_ = _e2451;
                                        } else {
                                            phi_4731_ = _e832;
                                            phi_4733_ = _e2445;
                                        }
                                        let _e2454 = phi_4731_;
                                        let _e2456 = phi_4733_;
                                        phi_4737_ = _e2454;
                                        phi_4738_ = select(_e2443, _e834, _e2447);
                                        phi_4739_ = _e2456;
                                    }
                                    let _e2459 = phi_4737_;
                                    let _e2461 = phi_4738_;
                                    let _e2463 = phi_4739_;
                                    if _e840 {
                                        phi_4749_ = _e836;
                                    } else {
                                        phi_4749_ = _e2463;
                                    }
                                    let _e2465 = phi_4749_;
                                    phi_5618_ = _e1997;
                                    phi_4750_ = _e1999;
                                    phi_4751_ = (_e795 - 1u);
                                    phi_4752_ = select(_e2459, false, _e840);
                                    phi_4753_ = select(_e2461, _e834, _e840);
                                    phi_4754_ = _e2465;
                                } else {
                                    phi_5618_ = _e791;
                                    phi_4750_ = _e793;
                                    phi_4751_ = _e795;
                                    phi_4752_ = _e832;
                                    phi_4753_ = _e834;
                                    phi_4754_ = _e836;
                                }
                                let _e2469 = phi_5618_;
                                let _e2471 = phi_4750_;
                                let _e2473 = phi_4751_;
                                let _e2475 = phi_4752_;
                                let _e2477 = phi_4753_;
                                let _e2479 = phi_4754_;
                                phi_5617_ = _e2469;
                                phi_4755_ = _e2471;
                                phi_4756_ = _e2473;
                                phi_4757_ = _e2475;
                                phi_4758_ = _e2477;
                                phi_4759_ = _e2479;
                            } else {
                                phi_5617_ = _e791;
                                phi_4755_ = type_43();
                                phi_4756_ = u32();
                                phi_4757_ = bool();
                                phi_4758_ = u32();
                                phi_4759_ = type_58();
                            }
                            let _e2481 = phi_5617_;
                            let _e2483 = phi_4755_;
                            let _e2485 = phi_4756_;
                            let _e2487 = phi_4757_;
                            let _e2489 = phi_4758_;
                            let _e2491 = phi_4759_;
                            phi_5616_ = _e2481;
                            phi_1422_ = _e2483;
                            phi_1425_ = _e2485;
                            phi_1427_ = _e2487;
                            phi_1429_ = _e2489;
                            phi_1431_ = _e2491;
                            phi_4760_ = _e805;
                        } else {
                            phi_5616_ = _e791;
                            phi_1422_ = type_43();
                            phi_1425_ = u32();
                            phi_1427_ = bool();
                            phi_1429_ = u32();
                            phi_1431_ = type_58();
                            phi_4760_ = false;
                        }
                        let _e2493 = phi_5616_;
                        let _e2495 = phi_1422_;
                        let _e2497 = phi_1425_;
                        let _e2499 = phi_1427_;
                        let _e2501 = phi_1429_;
                        let _e2503 = phi_1431_;
                        let _e2505 = phi_4760_;
                        continue;
                        continuing {
                            phi_5377_ = _e2493;
                            phi_1421_ = _e2495;
                            phi_1424_ = _e2497;
                            phi_1426_ = _e2499;
                            phi_1428_ = _e2501;
                            phi_1430_ = _e2503;
                            phi_5615_ = _e2493;
                            break if !(_e2505);
                        }
                    }
                    let _e2508 = phi_5615_;
                    if _e2508 {
                        break;
                    }
                    let _e2510 = local_10;
                    if (_e2510.member.member_3 != 4294967295u) {
                        let _e2515 = bitcast<u32>(_e2510.member.member);
                        let _e2519 = (bitcast<i32>((_e2515 >> bitcast<u32>(23i))) & 255i);
                        let _e2520 = (_e2519 + _e433);
                        if (_e2519 == 255i) {
                            phi_4819_ = _e2510.member.member;
                        } else {
                            if (_e2519 > 0i) {
                                if (_e2520 > 0i) {
                                    let _e2524 = (_e2520 < 255i);
                                    if _e2524 {
                                        phi_4798_ = bitcast<f32>((_e2515 + bitcast<u32>((_e433 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4798_ = f32();
                                    }
                                    let _e2531 = phi_4798_;
                                    phi_4800_ = _e2531;
                                    phi_4801_ = select(true, false, _e2524);
                                } else {
                                    phi_4800_ = f32();
                                    phi_4801_ = true;
                                }
                                let _e2534 = phi_4800_;
                                let _e2536 = phi_4801_;
                                phi_4802_ = _e2534;
                                phi_4803_ = _e2536;
                            } else {
                                phi_4802_ = f32();
                                phi_4803_ = true;
                            }
                            let _e2538 = phi_4802_;
                            let _e2540 = phi_4803_;
                            if _e2540 {
                                let _e2541 = (_e2515 & 2147483648u);
                                let _e2548 = ((_e2515 & 8388607u) | (select(0u, 1u, ((_e2515 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2552 = (_e2548 == 0u);
                                if _e2552 {
                                    phi_5329_ = bitcast<f32>(_e2541);
                                } else {
                                    let _e2557 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2548)), 32u, _e2552) - 8u);
                                    let _e2560 = (_e2548 << bitcast<u32>((_e2557 & 31u)));
                                    let _e2562 = ((_e2520 + select(0i, 1i, (_e2519 == 0i))) - bitcast<i32>(_e2557));
                                    if (_e2562 >= 255i) {
                                        phi_5319_ = bitcast<f32>((_e2541 | 2139095040u));
                                        phi_5320_ = f32();
                                        phi_5321_ = true;
                                    } else {
                                        let _e2564 = (_e2562 > 0i);
                                        if _e2564 {
                                            phi_5313_ = bitcast<f32>(((_e2541 | (bitcast<u32>(_e2562) << bitcast<u32>(23i))) | (_e2560 & 8388607u)));
                                            phi_5314_ = f32();
                                        } else {
                                            if (_e2562 < -24i) {
                                                phi_5279_ = 26u;
                                            } else {
                                                phi_5279_ = bitcast<u32>((1i - _e2562));
                                            }
                                            let _e2569 = phi_5279_;
                                            let _e2570 = (_e2569 & 31u);
                                            let _e2572 = (_e2560 >> bitcast<u32>(_e2570));
                                            let _e2576 = (_e2560 & ((1u << bitcast<u32>(_e2570)) - 1u));
                                            let _e2580 = (1u << bitcast<u32>(((_e2569 - 1u) & 31u)));
                                            if (_e2576 > _e2580) {
                                                phi_5300_ = true;
                                            } else {
                                                if (_e2576 == _e2580) {
                                                    phi_5297_ = ((_e2572 & 1u) == 1u);
                                                } else {
                                                    phi_5297_ = false;
                                                }
                                                let _e2586 = phi_5297_;
                                                phi_5300_ = _e2586;
                                            }
                                            let _e2588 = phi_5300_;
                                            phi_5313_ = f32();
                                            phi_5314_ = bitcast<f32>((_e2541 | (_e2572 + select(0u, 1u, _e2588))));
                                        }
                                        let _e2601 = phi_5313_;
                                        let _e2603 = phi_5314_;
                                        phi_5319_ = _e2601;
                                        phi_5320_ = _e2603;
                                        phi_5321_ = _e2564;
                                    }
                                    let _e2607 = phi_5319_;
                                    let _e2609 = phi_5320_;
                                    let _e2611 = phi_5321_;
                                    phi_5329_ = select(_e2609, _e2607, _e2611);
                                }
                                let _e2615 = phi_5329_;
                                phi_4818_ = _e2615;
                            } else {
                                phi_4818_ = _e2538;
                            }
                            let _e2617 = phi_4818_;
                            phi_4819_ = _e2617;
                        }
                        let _e2619 = phi_4819_;
                        let _e2620 = bitcast<u32>(_e2619);
                        if ((_e2620 & 2147483647u) >= 2139095040u) {
                            phi_4831_ = bitcast<f32>(((_e2620 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4831_ = _e2619;
                        }
                        let _e2627 = phi_4831_;
                        phi_4836_ = type_25(_e2627, _e2510.member.member_1, _e2510.member.member_2, _e2510.member.member_3);
                    } else {
                        phi_4836_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2632 = phi_4836_;
                    if _e310 {
                    } else {
                        break;
                    }
                    global_8.member[_e156] = _e2632;
                    if _e171 {
                    } else {
                        break;
                    }
                    let _e2636 = select(0u, 1u, (_e377 <= _e387));
                    if (_e2636 > 0u) {
                        let _e2638 = (1u < _e124);
                        if _e2638 {
                            if (0u < _e124) {
                            } else {
                                break;
                            }
                            let _e2642 = atomicAdd((&global_9.member[0u]), _e2636);
                            if ((_e2642 + _e2636) < _e2642) {
                                if _e2638 {
                                } else {
                                    break;
                                }
                                let _e2647 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2650 = select(0u, 1u, (_e2632.member_3 != 4294967295u));
                    if (_e2650 > 0u) {
                        let _e2652 = (3u < _e124);
                        if _e2652 {
                            if (2u < _e124) {
                            } else {
                                break;
                            }
                            let _e2656 = atomicAdd((&global_9.member[2u]), _e2650);
                            if ((_e2656 + _e2650) < _e2656) {
                                if _e2652 {
                                } else {
                                    break;
                                }
                                let _e2661 = atomicAdd((&global_9.member[3u]), 1u);
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
